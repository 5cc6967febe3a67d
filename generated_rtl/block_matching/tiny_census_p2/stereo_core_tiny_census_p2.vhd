-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny_census_p2: 32x12, 8 disparities, window 3x3, 2 pixel pairs a clock.
-- Options: disparities 8, cost census, census_width_px 7, census_height_px 3, slice_disparities 3.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_census_p2
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_census_p2 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 8;
    pixels_per_clock : positive := 2;
    disparity_bits : positive := 8;
    output_width_px : positive := 24;
    latency_clocks : positive := 23;
    flush_groups : positive := 67;
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
  assert width_px = 32 report "stereo_core_tiny_census_p2: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny_census_p2: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 8 report "stereo_core_tiny_census_p2: disparities is " & integer'image(disparities) & " but this core has 8" severity failure;
  assert pixels_per_clock = 2 report "stereo_core_tiny_census_p2: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 2" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_census_p2: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 24 report "stereo_core_tiny_census_p2: output_width_px is " & integer'image(output_width_px) & " but this core has 24" severity failure;
  assert latency_clocks = 23 report "stereo_core_tiny_census_p2: latency_clocks is " & integer'image(latency_clocks) & " but this core has 23" severity failure;
  assert flush_groups = 67 report "stereo_core_tiny_census_p2: flush_groups is " & integer'image(flush_groups) & " but this core has 67" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_census_p2: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_census_p2 is
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
  signal in_right_pixel : natural range 0 to 65535;
  signal in_left_pixel : natural range 0 to 65535;
  -- transform
  signal transform_left_0, transform_left_1, transform_right_0, transform_right_1 : natural range 0 to 255;
  signal transform_left_rows_read_newest_0, transform_left_rows_read_newest_1 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_left_rows_ready_newest_1 : natural range 0 to 255;
  signal transform_right_rows_read_newest_0, transform_right_rows_read_newest_1 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0, transform_right_rows_ready_newest_1 : natural range 0 to 255;
  signal transform_left_column_0, transform_left_column_1, transform_left_column_2 : natural range 0 to 255;
  signal transform_left_column_3, transform_right_column_0, transform_right_column_1 : natural range 0 to 255;
  signal transform_right_column_2, transform_right_column_3, transform_left_filter_column_0_0 : natural range 0 to 255;
  signal transform_left_filter_column_0_1, transform_left_filter_column_0_2 : natural range 0 to 255;
  signal transform_left_filter_column_0_3, transform_left_filter_column_1_0 : natural range 0 to 255;
  signal transform_left_filter_column_1_1, transform_left_filter_column_1_2 : natural range 0 to 255;
  signal transform_left_filter_column_1_3, transform_left_filter_column_2_0 : natural range 0 to 255;
  signal transform_left_filter_column_2_1, transform_left_filter_column_2_2 : natural range 0 to 255;
  signal transform_left_filter_column_2_3, transform_left_filter_column_3_0 : natural range 0 to 255;
  signal transform_left_filter_column_3_1, transform_left_filter_column_3_2 : natural range 0 to 255;
  signal transform_left_filter_column_3_3, transform_left_filter_column_4_0 : natural range 0 to 255;
  signal transform_left_filter_column_4_1, transform_left_filter_column_4_2 : natural range 0 to 255;
  signal transform_left_filter_column_4_3, transform_left_filter_column_5_0 : natural range 0 to 255;
  signal transform_left_filter_column_5_1, transform_left_filter_column_5_2 : natural range 0 to 255;
  signal transform_left_filter_column_5_3, transform_left_filter_column_6_0 : natural range 0 to 255;
  signal transform_left_filter_column_6_1, transform_left_filter_column_6_2 : natural range 0 to 255;
  signal transform_left_filter_column_6_3, transform_right_filter_column_0_0 : natural range 0 to 255;
  signal transform_right_filter_column_0_1, transform_right_filter_column_0_2 : natural range 0 to 255;
  signal transform_right_filter_column_0_3, transform_right_filter_column_1_0 : natural range 0 to 255;
  signal transform_right_filter_column_1_1, transform_right_filter_column_1_2 : natural range 0 to 255;
  signal transform_right_filter_column_1_3, transform_right_filter_column_2_0 : natural range 0 to 255;
  signal transform_right_filter_column_2_1, transform_right_filter_column_2_2 : natural range 0 to 255;
  signal transform_right_filter_column_2_3, transform_right_filter_column_3_0 : natural range 0 to 255;
  signal transform_right_filter_column_3_1, transform_right_filter_column_3_2 : natural range 0 to 255;
  signal transform_right_filter_column_3_3, transform_right_filter_column_4_0 : natural range 0 to 255;
  signal transform_right_filter_column_4_1, transform_right_filter_column_4_2 : natural range 0 to 255;
  signal transform_right_filter_column_4_3, transform_right_filter_column_5_0 : natural range 0 to 255;
  signal transform_right_filter_column_5_1, transform_right_filter_column_5_2 : natural range 0 to 255;
  signal transform_right_filter_column_5_3, transform_right_filter_column_6_0 : natural range 0 to 255;
  signal transform_right_filter_column_6_1, transform_right_filter_column_6_2 : natural range 0 to 255;
  signal transform_right_filter_column_6_3 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_1, transform_read_row_inside_3, transform_read_column_inside_0 : boolean;
  signal transform_read_column_inside_1, transform_read_column_inside_2, transform_read_column_inside_3 : boolean;
  signal transform_read_column_inside_4, transform_read_column_inside_5, transform_read_column_inside_6 : boolean;
  signal transform_read_start_of_frame, transform_read_valid, transform_ready_row_inside_0 : boolean;
  signal transform_ready_row_inside_1, transform_ready_row_inside_3, transform_ready_column_inside_0 : boolean;
  signal transform_ready_column_inside_1, transform_ready_column_inside_2, transform_ready_column_inside_3 : boolean;
  signal transform_ready_column_inside_4, transform_ready_column_inside_5, transform_ready_column_inside_6 : boolean;
  signal transform_ready_start_of_frame, transform_ready_valid, transform_columns_row_inside_0 : boolean;
  signal transform_columns_row_inside_1, transform_columns_row_inside_3, transform_columns_column_inside_0 : boolean;
  signal transform_columns_column_inside_1, transform_columns_column_inside_2 : boolean;
  signal transform_columns_column_inside_3, transform_columns_column_inside_4 : boolean;
  signal transform_columns_column_inside_5, transform_columns_column_inside_6 : boolean;
  signal transform_columns_start_of_frame, transform_columns_valid, transform_filtering_0_column_inside_0 : boolean;
  signal transform_filtering_0_column_inside_1, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_0_column_inside_3, transform_filtering_0_column_inside_4 : boolean;
  signal transform_filtering_0_column_inside_5, transform_filtering_0_column_inside_6 : boolean;
  signal transform_filtering_0_start_of_frame, transform_filtering_0_valid : boolean;
  signal transform_filtering_1_start_of_frame, transform_filtering_1_valid : boolean;
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 31;
  signal transform_write_column : natural range 0 to 31;
  signal transform_counter_group : natural range 0 to 7;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(23 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0 : natural range 0 to 16777215;
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : natural range 0 to 16777215;
  signal transform_left_filter_feature_0, transform_left_filter_feature_1 : natural range 0 to 1048575;
  signal transform_right_filter_feature_0, transform_right_filter_feature_1 : natural range 0 to 1048575;
  -- raster
  signal raster_features_search_0, raster_features_search_1, raster_features_reference_0 : natural range 0 to 1048575;
  signal raster_features_reference_1 : natural range 0 to 1048575;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 31;
  signal raster_place_group : natural range 0 to 7;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 7;
  signal delay_ahead_0, delay_ahead_1 : natural range 0 to 1048575;
  signal delay_delayed_0, delay_delayed_1 : unsigned(19 downto 0);
  signal delay_column : natural range 0 to 31;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_3, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(19 downto 0);
  signal rows_search_rows_read_words_2, rows_reference_rows_read_words_0 : unsigned(19 downto 0);
  signal rows_reference_rows_read_words_1, rows_reference_rows_read_words_2 : unsigned(19 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_read_newest_1 : natural range 0 to 1048575;
  signal rows_search_rows_ready_words_0, rows_search_rows_ready_words_1 : natural range 0 to 1048575;
  signal rows_search_rows_ready_words_2, rows_search_rows_ready_newest_0 : natural range 0 to 1048575;
  signal rows_search_rows_ready_newest_1, rows_search_rows_write_words_0 : natural range 0 to 1048575;
  signal rows_search_rows_write_words_1, rows_search_rows_write_words_2 : natural range 0 to 1048575;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_read_newest_1 : natural range 0 to 1048575;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_ready_words_1 : natural range 0 to 1048575;
  signal rows_reference_rows_ready_words_2, rows_reference_rows_ready_newest_0 : natural range 0 to 1048575;
  signal rows_reference_rows_ready_newest_1, rows_reference_rows_write_words_0 : natural range 0 to 1048575;
  signal rows_reference_rows_write_words_1, rows_reference_rows_write_words_2 : natural range 0 to 1048575;
  signal rows_search_0, rows_search_1, rows_search_2, rows_search_3, rows_reference_0 : natural range 0 to 1048575;
  signal rows_reference_1, rows_reference_2, rows_reference_3 : natural range 0 to 1048575;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_3, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_output_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_3 : boolean;
  signal rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 1048575;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 1048575;
  signal slice0shift_search_2_0, slice0shift_search_2_1, slice0shift_search_2_2 : natural range 0 to 1048575;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 1048575;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 1048575;
  signal slice0shift_reference_3, slice0shift_search_out_0, slice0shift_search_out_1 : natural range 0 to 1048575;
  signal slice0shift_search_out_2, slice0shift_search_out_3 : natural range 0 to 1048575;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0_count_0, slice0cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_2, slice0cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_4, slice0cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_0, slice0cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_2, slice0cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_4, slice0cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_0, slice0cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_2, slice0cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_4, slice0cost_pixels_first_0_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_0, slice0cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_2, slice0cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_4, slice0cost_pixels_first_1_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_0, slice0cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_2, slice0cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_4, slice0cost_pixels_first_1_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_0, slice0cost_pixels_first_1_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_2, slice0cost_pixels_first_1_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_4, slice0cost_pixels_first_1_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_0, slice0cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_2, slice0cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_4, slice0cost_pixels_first_2_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_0, slice0cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_2, slice0cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_4, slice0cost_pixels_first_2_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_0, slice0cost_pixels_first_2_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_2, slice0cost_pixels_first_2_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_4, slice0cost_pixels_first_2_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_0_count_0, slice0cost_pixels_first_3_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_0_count_2, slice0cost_pixels_first_3_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_0_count_4, slice0cost_pixels_first_3_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_1_count_0, slice0cost_pixels_first_3_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_1_count_2, slice0cost_pixels_first_3_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_1_count_4, slice0cost_pixels_first_3_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_2_count_0, slice0cost_pixels_first_3_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_2_count_2, slice0cost_pixels_first_3_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_3_2_count_4, slice0cost_pixels_first_3_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_6, slice0cost_pixels_first_0_1_count_6 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_2_count_6, slice0cost_pixels_first_1_0_count_6 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_1_count_6, slice0cost_pixels_first_1_2_count_6 : natural range 0 to 2;
  signal slice0cost_pixels_first_2_0_count_6, slice0cost_pixels_first_2_1_count_6 : natural range 0 to 2;
  signal slice0cost_pixels_first_2_2_count_6, slice0cost_pixels_first_3_0_count_6 : natural range 0 to 2;
  signal slice0cost_pixels_first_3_1_count_6, slice0cost_pixels_first_3_2_count_6 : natural range 0 to 2;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_border_column, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_pair_tag_valid : boolean;
  signal slice0cost_pair_tag_border_column, slice0cost_pair_tag_output_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_output_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 20;
  signal slice0cost_pixels_cost_1_0, slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2 : natural range 0 to 20;
  signal slice0cost_pixels_cost_2_0, slice0cost_pixels_cost_2_1, slice0cost_pixels_cost_2_2 : natural range 0 to 20;
  signal slice0cost_pixels_cost_3_0, slice0cost_pixels_cost_3_1, slice0cost_pixels_cost_3_2 : natural range 0 to 20;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 20;
  signal slice0cost_single_3_0, slice0cost_single_3_1, slice0cost_single_3_2 : natural range 0 to 20;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2 : natural range 0 to 40;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 60;
  signal slice0cost_column_1_0, slice0cost_column_1_1, slice0cost_column_1_2 : natural range 0 to 60;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 60;
  signal slice0window_partial_1_0_0, slice0window_partial_1_0_1, slice0window_partial_1_0_2 : natural range 0 to 60;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 120;
  signal slice0window_partial_1_1_0, slice0window_partial_1_1_1, slice0window_partial_1_1_2 : natural range 0 to 120;
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_output_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 180;
  signal slice0window_sum_1_0, slice0window_sum_1_1, slice0window_sum_1_2 : natural range 0 to 180;
  -- slice0winner1
  signal slice0winner1_of_pair_0_0, slice0winner1_of_pair_0_1, slice0winner1_of_pair_0_2 : natural range 0 to 180;
  signal slice0winner1_of_pair_1_0, slice0winner1_of_pair_1_1, slice0winner1_of_pair_1_2 : natural range 0 to 180;
  signal slice0winner1_of_four_0_0, slice0winner1_of_four_0_1, slice0winner1_of_four_0_2 : natural range 0 to 180;
  signal slice0winner1_of_four_1_0, slice0winner1_of_four_1_1, slice0winner1_of_four_1_2 : natural range 0 to 180;
  signal slice0winner1_pair_index_0_0, slice0winner1_pair_index_1_0, slice0winner1_pair_tag_valid : boolean;
  signal slice0winner1_pair_tag_output_column, slice0winner1_pair_tag_start_of_frame : boolean;
  signal slice0winner1_pair_tag_end_of_line, slice0winner1_four_tag_valid : boolean;
  signal slice0winner1_four_tag_output_column, slice0winner1_four_tag_start_of_frame : boolean;
  signal slice0winner1_four_tag_end_of_line, slice0winner1_tag_valid, slice0winner1_tag_output_column : boolean;
  signal slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_pair_index_0_1, slice0winner1_four_index_0_0 : natural range 0 to 2;
  signal slice0winner1_four_index_1_0, slice0winner1_best_index_0_0 : natural range 0 to 2;
  signal slice0winner1_best_index_1_0 : natural range 0 to 2;
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_1_0 : natural range 0 to 255;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_cost_1_0 : natural range 0 to 255;
  signal slice0_best_index_0_0, slice0_best_index_1_0 : natural range 0 to 7;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 1048575;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 1048575;
  signal slice1shift_search_2_0, slice1shift_search_2_1, slice1shift_search_2_2 : natural range 0 to 1048575;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 1048575;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 1048575;
  signal slice1shift_reference_3, slice1shift_search_out_0, slice1shift_search_out_1 : natural range 0 to 1048575;
  signal slice1shift_search_out_2, slice1shift_search_out_3 : natural range 0 to 1048575;
  -- slice1cost
  signal slice1cost_pixels_first_0_0_count_0, slice1cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_2, slice1cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_4, slice1cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_0, slice1cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_2, slice1cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_4, slice1cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_0, slice1cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_2, slice1cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_4, slice1cost_pixels_first_0_2_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_0, slice1cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_2, slice1cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_4, slice1cost_pixels_first_1_0_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_0, slice1cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_2, slice1cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_4, slice1cost_pixels_first_1_1_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_0, slice1cost_pixels_first_1_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_2, slice1cost_pixels_first_1_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_4, slice1cost_pixels_first_1_2_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_0_count_0, slice1cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_0_count_2, slice1cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_0_count_4, slice1cost_pixels_first_2_0_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_0, slice1cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_2, slice1cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_4, slice1cost_pixels_first_2_1_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_0, slice1cost_pixels_first_2_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_2, slice1cost_pixels_first_2_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_4, slice1cost_pixels_first_2_2_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_0_count_0, slice1cost_pixels_first_3_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_0_count_2, slice1cost_pixels_first_3_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_0_count_4, slice1cost_pixels_first_3_0_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_1_count_0, slice1cost_pixels_first_3_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_1_count_2, slice1cost_pixels_first_3_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_1_count_4, slice1cost_pixels_first_3_1_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_2_count_0, slice1cost_pixels_first_3_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_2_count_2, slice1cost_pixels_first_3_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_3_2_count_4, slice1cost_pixels_first_3_2_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_6, slice1cost_pixels_first_0_1_count_6 : natural range 0 to 2;
  signal slice1cost_pixels_first_0_2_count_6, slice1cost_pixels_first_1_0_count_6 : natural range 0 to 2;
  signal slice1cost_pixels_first_1_1_count_6, slice1cost_pixels_first_1_2_count_6 : natural range 0 to 2;
  signal slice1cost_pixels_first_2_0_count_6, slice1cost_pixels_first_2_1_count_6 : natural range 0 to 2;
  signal slice1cost_pixels_first_2_2_count_6, slice1cost_pixels_first_3_0_count_6 : natural range 0 to 2;
  signal slice1cost_pixels_first_3_1_count_6, slice1cost_pixels_first_3_2_count_6 : natural range 0 to 2;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 20;
  signal slice1cost_pixels_cost_1_0, slice1cost_pixels_cost_1_1, slice1cost_pixels_cost_1_2 : natural range 0 to 20;
  signal slice1cost_pixels_cost_2_0, slice1cost_pixels_cost_2_1, slice1cost_pixels_cost_2_2 : natural range 0 to 20;
  signal slice1cost_pixels_cost_3_0, slice1cost_pixels_cost_3_1, slice1cost_pixels_cost_3_2 : natural range 0 to 20;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 20;
  signal slice1cost_single_3_0, slice1cost_single_3_1, slice1cost_single_3_2 : natural range 0 to 20;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2 : natural range 0 to 40;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 60;
  signal slice1cost_column_1_0, slice1cost_column_1_1, slice1cost_column_1_2 : natural range 0 to 60;
  signal slice1cost_tag_border_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 60;
  signal slice1window_partial_1_0_0, slice1window_partial_1_0_1, slice1window_partial_1_0_2 : natural range 0 to 60;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 120;
  signal slice1window_partial_1_1_0, slice1window_partial_1_1_1, slice1window_partial_1_1_2 : natural range 0 to 120;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 180;
  signal slice1window_sum_1_0, slice1window_sum_1_1, slice1window_sum_1_2 : natural range 0 to 180;
  -- slice1winner1
  signal slice1winner1_of_pair_0_0, slice1winner1_of_pair_0_1, slice1winner1_of_pair_0_2 : natural range 0 to 180;
  signal slice1winner1_of_pair_1_0, slice1winner1_of_pair_1_1, slice1winner1_of_pair_1_2 : natural range 0 to 180;
  signal slice1winner1_of_four_0_0, slice1winner1_of_four_0_1, slice1winner1_of_four_0_2 : natural range 0 to 180;
  signal slice1winner1_of_four_1_0, slice1winner1_of_four_1_1, slice1winner1_of_four_1_2 : natural range 0 to 180;
  signal slice1winner1_pair_index_0_0, slice1winner1_pair_index_1_0 : boolean;
  signal slice1winner1_four_index_0_0, slice1winner1_four_index_1_0 : natural range 0 to 2;
  signal slice1winner1_best_index_0_0, slice1winner1_best_index_1_0 : natural range 0 to 2;
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_1_0 : natural range 0 to 255;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_cost_1_0 : natural range 0 to 255;
  signal slice1_best_index_0_0, slice1_best_index_1_0 : natural range 0 to 7;
  signal slice1_best_tag_valid, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_1_0 : natural range 0 to 1048575;
  signal slice2shift_search_1_1, slice2shift_search_2_0, slice2shift_search_2_1 : natural range 0 to 1048575;
  signal slice2shift_search_3_0, slice2shift_search_3_1, slice2shift_reference_0 : natural range 0 to 1048575;
  signal slice2shift_reference_1, slice2shift_reference_2, slice2shift_reference_3 : natural range 0 to 1048575;
  -- slice2cost
  signal slice2cost_pixels_first_0_0_count_0, slice2cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_2, slice2cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_4, slice2cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_0, slice2cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_2, slice2cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_4, slice2cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_0, slice2cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_2, slice2cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_4, slice2cost_pixels_first_1_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_0, slice2cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_2, slice2cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_4, slice2cost_pixels_first_1_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_0, slice2cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_2, slice2cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_4, slice2cost_pixels_first_2_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_0, slice2cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_2, slice2cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_4, slice2cost_pixels_first_2_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_3_0_count_0, slice2cost_pixels_first_3_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_3_0_count_2, slice2cost_pixels_first_3_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_3_0_count_4, slice2cost_pixels_first_3_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_3_1_count_0, slice2cost_pixels_first_3_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_3_1_count_2, slice2cost_pixels_first_3_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_3_1_count_4, slice2cost_pixels_first_3_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_6, slice2cost_pixels_first_0_1_count_6 : natural range 0 to 2;
  signal slice2cost_pixels_first_1_0_count_6, slice2cost_pixels_first_1_1_count_6 : natural range 0 to 2;
  signal slice2cost_pixels_first_2_0_count_6, slice2cost_pixels_first_2_1_count_6 : natural range 0 to 2;
  signal slice2cost_pixels_first_3_0_count_6, slice2cost_pixels_first_3_1_count_6 : natural range 0 to 2;
  signal slice2cost_pixels_cost_0_0, slice2cost_pixels_cost_0_1, slice2cost_pixels_cost_1_0 : natural range 0 to 20;
  signal slice2cost_pixels_cost_1_1, slice2cost_pixels_cost_2_0, slice2cost_pixels_cost_2_1 : natural range 0 to 20;
  signal slice2cost_pixels_cost_3_0, slice2cost_pixels_cost_3_1, slice2cost_single_0_0 : natural range 0 to 20;
  signal slice2cost_single_0_1, slice2cost_single_3_0, slice2cost_single_3_1 : natural range 0 to 20;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1 : natural range 0 to 40;
  signal slice2cost_column_0_0, slice2cost_column_0_1, slice2cost_column_1_0 : natural range 0 to 60;
  signal slice2cost_column_1_1 : natural range 0 to 60;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1, slice2window_partial_1_0_0 : natural range 0 to 60;
  signal slice2window_partial_1_0_1 : natural range 0 to 60;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1, slice2window_partial_1_1_0 : natural range 0 to 120;
  signal slice2window_partial_1_1_1 : natural range 0 to 120;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_1_0 : natural range 0 to 180;
  signal slice2window_sum_1_1 : natural range 0 to 180;
  -- slice2winner1
  signal slice2winner1_best_cost_0_0, slice2winner1_best_cost_1_0 : natural range 0 to 180;
  signal slice2winner1_best_index_0_0, slice2winner1_best_index_1_0 : boolean;
  -- slice2winner2
  signal slice2winner2_best_cost_0_0, slice2winner2_best_cost_1_0 : natural range 0 to 180;
  signal slice2winner2_best_index_0_0, slice2winner2_best_index_1_0 : boolean;
  -- slice2winner3
  signal slice2winner3_best_cost_0_0, slice2winner3_best_cost_1_0 : natural range 0 to 180;
  signal slice2winner3_best_index_0_0, slice2winner3_best_index_1_0 : boolean;
  -- slice2
  signal slice2_best_index_0_0, slice2_best_index_1_0 : natural range 0 to 7;
  signal slice2_best_tag_valid, slice2_best_tag_output_column, slice2_best_tag_start_of_frame : boolean;
  signal slice2_best_tag_end_of_line : boolean;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_2_memory_read_enable : boolean;
  signal rows_search_rows_read_words_2_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_2_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_2_memory_write_data : unsigned(19 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(19 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal rows_reference_rows_read_words_2_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_2_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_data : unsigned(19 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(19 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal delay_delayed_1_memory_read_enable : boolean;
  signal delay_delayed_1_memory_read_address : unsigned(2 downto 0);
  signal delay_delayed_1_memory_write_address : unsigned(2 downto 0);
  signal delay_delayed_1_memory_write_data : unsigned(19 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(2 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(2 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(19 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice2_best_index_1_0, 8) & to_unsigned(slice2_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(3, 2));
  disparity_valid <= as_bit(slice2_best_tag_valid and slice2_best_tag_output_column);
  disparity_start_of_frame <= as_bit(slice2_best_tag_start_of_frame and slice2_best_tag_valid and slice2_best_tag_output_column);
  disparity_end_of_line <= as_bit(slice2_best_tag_end_of_line and slice2_best_tag_valid and slice2_best_tag_output_column);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 5);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 5);
  transform_left_rows_read_words_0_memory_write_data <= to_unsigned(transform_left_rows_write_words_0, 24);
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 5);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 5);
  transform_right_rows_read_words_0_memory_write_data <= to_unsigned(transform_right_rows_write_words_0, 24);
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  rows_search_rows_read_words_2_memory_read_enable <= true;
  rows_search_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words_2, 20);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 32, width => 20, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words_2,
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words_1, 20);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 20, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 20);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 20, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_2_memory_read_enable <= true;
  rows_reference_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words_2, 20);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 32, width => 20, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words_2,
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 20);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 20, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 20);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 20, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_1_memory_read_enable <= true;
  delay_delayed_1_memory_read_address <= to_unsigned(delay_ring_read_address, 3);
  delay_delayed_1_memory_write_address <= to_unsigned(delay_ring_write_address, 3);
  delay_delayed_1_memory_write_data <= to_unsigned(raster_features_reference_1, 20);
  delay_delayed_1_memory : entity work.line_memory
    generic map (depth => 8, width => 20, address_bits => 3)
    port map (
      clock => clock, read_enable => delay_delayed_1_memory_read_enable,
      read_address => delay_delayed_1_memory_read_address, read_data => delay_delayed_1,
      write_address => delay_delayed_1_memory_write_address, write_data => delay_delayed_1_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 3);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 3);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 20);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 8, width => 20, address_bits => 3)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_all : boolean;
    variable transform_counter_group_is_equal_2, transform_counter_group_choice_2 : boolean;
    variable transform_read_row_inside_0_value, transform_read_row_inside_0_any : boolean;
    variable transform_read_row_inside_1_any, transform_read_column_inside_0_value : boolean;
    variable transform_read_column_inside_0_value_2, transform_read_column_inside_1_is_equal : boolean;
    variable transform_read_column_inside_1_all, transform_read_column_inside_1_is_equal_2 : boolean;
    variable transform_read_column_inside_1_value, transform_read_column_inside_1_choice : boolean;
    variable transform_left_filter_feature_0_value, transform_left_filter_feature_0_any : boolean;
    variable transform_left_filter_feature_0_choice, transform_left_filter_feature_0_is_equal : boolean;
    variable transform_left_filter_feature_0_choice_2, transform_left_filter_feature_0_value_2 : boolean;
    variable transform_left_filter_feature_0_choice_3, transform_left_filter_feature_0_value_3 : boolean;
    variable transform_left_filter_feature_0_choice_4, transform_left_filter_feature_0_value_4 : boolean;
    variable transform_left_filter_feature_0_choice_5, transform_left_filter_feature_0_value_5 : boolean;
    variable transform_left_filter_feature_0_choice_6, transform_left_filter_feature_0_value_6 : boolean;
    variable transform_left_filter_feature_0_choice_7, transform_left_filter_feature_0_choice_8 : boolean;
    variable transform_left_filter_feature_0_value_7, transform_left_filter_feature_0_choice_9 : boolean;
    variable transform_left_filter_feature_0_choice_10, transform_left_filter_feature_0_choice_11 : boolean;
    variable transform_left_filter_feature_0_choice_12, transform_left_filter_feature_0_choice_13 : boolean;
    variable transform_left_filter_feature_0_choice_14, transform_left_filter_feature_0_choice_15 : boolean;
    variable transform_left_filter_feature_0_choice_16, transform_left_filter_feature_0_value_8 : boolean;
    variable transform_left_filter_feature_0_choice_17, transform_left_filter_feature_0_choice_18 : boolean;
    variable transform_left_filter_feature_0_choice_19, transform_left_filter_feature_0_choice_20 : boolean;
    variable transform_left_filter_feature_0_choice_21, transform_left_filter_feature_0_choice_22 : boolean;
    variable transform_left_filter_feature_0_choice_23, transform_left_filter_feature_0_choice_24 : boolean;
    variable transform_left_filter_feature_0_choice_25, transform_left_filter_feature_0_choice_26 : boolean;
    variable transform_left_filter_feature_0_choice_27, transform_left_filter_feature_0_choice_28 : boolean;
    variable transform_left_filter_feature_0_choice_29, transform_left_filter_feature_0_choice_30 : boolean;
    variable transform_left_filter_feature_0_choice_31, transform_left_filter_feature_0_choice_32 : boolean;
    variable transform_left_filter_feature_0_value_9, transform_left_filter_feature_0_choice_33 : boolean;
    variable transform_left_filter_feature_0_choice_34, transform_left_filter_feature_0_choice_35 : boolean;
    variable transform_left_filter_feature_0_choice_36, transform_left_filter_feature_0_choice_37 : boolean;
    variable transform_left_filter_feature_0_choice_38, transform_left_filter_feature_0_choice_39 : boolean;
    variable transform_left_filter_feature_0_choice_40, transform_left_filter_feature_0_value_10 : boolean;
    variable transform_left_filter_feature_0_choice_41, transform_left_filter_feature_0_choice_42 : boolean;
    variable transform_left_filter_feature_0_choice_43, transform_left_filter_feature_0_choice_44 : boolean;
    variable transform_left_filter_feature_0_choice_45, transform_left_filter_feature_0_choice_46 : boolean;
    variable transform_left_filter_feature_0_choice_47, transform_left_filter_feature_0_choice_48 : boolean;
    variable transform_left_filter_feature_0_choice_49, transform_left_filter_feature_0_choice_50 : boolean;
    variable transform_left_filter_feature_0_choice_51, transform_left_filter_feature_0_choice_52 : boolean;
    variable transform_left_filter_feature_0_choice_53, transform_left_filter_feature_0_choice_54 : boolean;
    variable transform_left_filter_feature_0_choice_55, transform_left_filter_feature_0_choice_56 : boolean;
    variable transform_left_filter_feature_0_value_11, transform_left_filter_feature_0_choice_57 : boolean;
    variable transform_left_filter_feature_0_choice_58, transform_left_filter_feature_0_choice_59 : boolean;
    variable transform_left_filter_feature_0_choice_60, transform_left_filter_feature_0_choice_61 : boolean;
    variable transform_left_filter_feature_0_choice_62, transform_left_filter_feature_0_choice_63 : boolean;
    variable transform_left_filter_feature_0_choice_64, transform_left_filter_feature_0_value_12 : boolean;
    variable transform_left_filter_feature_0_choice_65, transform_left_filter_feature_0_choice_66 : boolean;
    variable transform_left_filter_feature_0_choice_67, transform_left_filter_feature_0_choice_68 : boolean;
    variable transform_left_filter_feature_0_choice_69, transform_left_filter_feature_0_choice_70 : boolean;
    variable transform_left_filter_feature_0_choice_71, transform_left_filter_feature_0_choice_72 : boolean;
    variable transform_left_filter_feature_0_value_13, transform_left_filter_feature_0_choice_73 : boolean;
    variable transform_left_filter_feature_0_choice_74, transform_left_filter_feature_0_value_14 : boolean;
    variable transform_left_filter_feature_0_all, transform_left_filter_feature_0_any_2 : boolean;
    variable transform_left_filter_feature_0_choice_75, transform_left_filter_feature_0_value_15 : boolean;
    variable transform_left_filter_feature_0_any_3, transform_left_filter_feature_0_all_2 : boolean;
    variable transform_left_filter_feature_0_choice_76, transform_left_filter_feature_0_value_16 : boolean;
    variable transform_left_filter_feature_0_any_4, transform_left_filter_feature_0_all_3 : boolean;
    variable transform_left_filter_feature_0_choice_77, transform_left_filter_feature_0_value_17 : boolean;
    variable transform_left_filter_feature_0_any_5, transform_left_filter_feature_0_all_4 : boolean;
    variable transform_left_filter_feature_0_choice_78, transform_left_filter_feature_0_value_18 : boolean;
    variable transform_left_filter_feature_0_any_6, transform_left_filter_feature_0_all_5 : boolean;
    variable transform_left_filter_feature_0_choice_79, transform_left_filter_feature_0_choice_80 : boolean;
    variable transform_left_filter_feature_0_choice_81, transform_left_filter_feature_0_value_19 : boolean;
    variable transform_left_filter_feature_0_choice_82, transform_left_filter_feature_0_choice_83 : boolean;
    variable transform_left_filter_feature_0_value_20, transform_left_filter_feature_0_choice_84 : boolean;
    variable transform_left_filter_feature_0_value_21, transform_left_filter_feature_0_choice_85 : boolean;
    variable transform_left_filter_feature_0_value_22, transform_left_filter_feature_0_choice_86 : boolean;
    variable transform_left_filter_feature_0_value_23, transform_left_filter_feature_0_choice_87 : boolean;
    variable transform_left_filter_feature_0_value_24, transform_left_filter_feature_0_choice_88 : boolean;
    variable transform_left_filter_feature_0_choice_89, transform_left_filter_feature_0_value_25 : boolean;
    variable transform_left_filter_feature_0_choice_90, transform_left_filter_feature_0_choice_91 : boolean;
    variable transform_left_filter_feature_0_value_26, transform_left_filter_feature_0_choice_92 : boolean;
    variable transform_left_filter_feature_0_value_27, transform_left_filter_feature_0_choice_93 : boolean;
    variable transform_left_filter_feature_0_value_28, transform_left_filter_feature_0_choice_94 : boolean;
    variable transform_left_filter_feature_0_value_29, transform_left_filter_feature_0_choice_95 : boolean;
    variable transform_left_filter_feature_0_value_30, transform_left_filter_feature_0_choice_96 : boolean;
    variable transform_left_filter_feature_0_choice_97, transform_left_filter_feature_0_choice_98 : boolean;
    variable transform_left_filter_feature_0_choice_99, transform_left_filter_feature_0_choice_100 : boolean;
    variable transform_left_filter_feature_0_choice_101, transform_left_filter_feature_0_choice_102 : boolean;
    variable transform_left_filter_feature_0_choice_103, transform_left_filter_feature_0_choice_104 : boolean;
    variable transform_left_filter_feature_0_choice_105, transform_left_filter_feature_0_value_31 : boolean;
    variable transform_left_filter_feature_0_choice_106, transform_left_filter_feature_0_choice_107 : boolean;
    variable transform_left_filter_feature_0_value_32, transform_left_filter_feature_0_choice_108 : boolean;
    variable transform_left_filter_feature_0_value_33, transform_left_filter_feature_0_choice_109 : boolean;
    variable transform_left_filter_feature_0_value_34, transform_left_filter_feature_0_choice_110 : boolean;
    variable transform_left_filter_feature_0_value_35, transform_left_filter_feature_0_choice_111 : boolean;
    variable transform_left_filter_feature_0_value_36, transform_left_filter_feature_0_choice_112 : boolean;
    variable transform_left_filter_feature_0_choice_113, transform_left_filter_feature_0_value_37 : boolean;
    variable transform_left_filter_feature_0_choice_114, transform_left_filter_feature_0_choice_115 : boolean;
    variable transform_left_filter_feature_0_value_38, transform_left_filter_feature_0_choice_116 : boolean;
    variable transform_left_filter_feature_0_value_39, transform_left_filter_feature_0_choice_117 : boolean;
    variable transform_left_filter_feature_0_value_40, transform_left_filter_feature_0_choice_118 : boolean;
    variable transform_left_filter_feature_0_value_41, transform_left_filter_feature_0_choice_119 : boolean;
    variable transform_left_filter_feature_0_value_42, transform_left_filter_feature_0_choice_120 : boolean;
    variable transform_left_filter_feature_0_choice_121, transform_left_filter_feature_0_choice_122 : boolean;
    variable transform_left_filter_feature_0_choice_123, transform_left_filter_feature_0_choice_124 : boolean;
    variable transform_left_filter_feature_0_choice_125, transform_left_filter_feature_0_choice_126 : boolean;
    variable transform_left_filter_feature_0_choice_127, transform_left_filter_feature_0_choice_128 : boolean;
    variable transform_left_filter_feature_0_choice_129, transform_left_filter_feature_0_value_43 : boolean;
    variable transform_left_filter_feature_0_choice_130, transform_left_filter_feature_0_choice_131 : boolean;
    variable transform_left_filter_feature_0_value_44, transform_left_filter_feature_0_choice_132 : boolean;
    variable transform_left_filter_feature_0_value_45, transform_left_filter_feature_0_choice_133 : boolean;
    variable transform_left_filter_feature_0_value_46, transform_left_filter_feature_0_choice_134 : boolean;
    variable transform_left_filter_feature_0_value_47, transform_left_filter_feature_0_choice_135 : boolean;
    variable transform_left_filter_feature_0_value_48, transform_left_filter_feature_0_choice_136 : boolean;
    variable transform_left_filter_feature_0_choice_137, transform_left_filter_feature_0_value_49 : boolean;
    variable transform_left_filter_feature_0_choice_138, transform_left_filter_feature_0_choice_139 : boolean;
    variable transform_left_filter_feature_0_value_50, transform_left_filter_feature_0_choice_140 : boolean;
    variable transform_left_filter_feature_0_value_51, transform_left_filter_feature_0_choice_141 : boolean;
    variable transform_left_filter_feature_0_value_52, transform_left_filter_feature_0_choice_142 : boolean;
    variable transform_left_filter_feature_0_value_53, transform_left_filter_feature_0_choice_143 : boolean;
    variable transform_left_filter_feature_0_value_54, transform_left_filter_feature_0_choice_144 : boolean;
    variable transform_left_filter_feature_0_choice_145, transform_left_filter_feature_0_choice_146 : boolean;
    variable transform_left_filter_feature_0_choice_147, transform_left_filter_feature_0_value_55 : boolean;
    variable transform_left_filter_feature_0_choice_148, transform_left_filter_feature_0_value_56 : boolean;
    variable transform_left_filter_feature_0_choice_149, transform_left_filter_feature_0_value_57 : boolean;
    variable transform_left_filter_feature_0_choice_150, transform_left_filter_feature_0_value_58 : boolean;
    variable transform_left_filter_feature_0_choice_151, transform_left_filter_feature_0_value_59 : boolean;
    variable transform_left_filter_feature_0_choice_152, transform_left_filter_feature_0_choice_153 : boolean;
    variable transform_left_filter_feature_0_choice_157, transform_left_filter_feature_0_choice_158 : boolean;
    variable transform_left_filter_feature_0_choice_159, transform_left_filter_feature_0_choice_160 : boolean;
    variable transform_left_filter_feature_0_choice_161, transform_left_filter_feature_0_choice_162 : boolean;
    variable transform_left_filter_feature_0_choice_163, transform_left_filter_feature_0_choice_164 : boolean;
    variable transform_left_filter_feature_1_any, transform_left_filter_feature_1_choice : boolean;
    variable transform_left_filter_feature_1_is_equal, transform_left_filter_feature_1_choice_2 : boolean;
    variable transform_left_filter_feature_1_choice_3, transform_left_filter_feature_1_choice_4 : boolean;
    variable transform_left_filter_feature_1_choice_5, transform_left_filter_feature_1_choice_6 : boolean;
    variable transform_left_filter_feature_1_choice_7, transform_left_filter_feature_1_choice_8 : boolean;
    variable transform_left_filter_feature_1_choice_9, transform_left_filter_feature_1_choice_10 : boolean;
    variable transform_left_filter_feature_1_choice_11, transform_left_filter_feature_1_choice_12 : boolean;
    variable transform_left_filter_feature_1_choice_13, transform_left_filter_feature_1_choice_14 : boolean;
    variable transform_left_filter_feature_1_choice_15, transform_left_filter_feature_1_choice_16 : boolean;
    variable transform_left_filter_feature_1_choice_17, transform_left_filter_feature_1_choice_18 : boolean;
    variable transform_left_filter_feature_1_choice_19, transform_left_filter_feature_1_choice_20 : boolean;
    variable transform_left_filter_feature_1_choice_21, transform_left_filter_feature_1_choice_22 : boolean;
    variable transform_left_filter_feature_1_choice_23, transform_left_filter_feature_1_choice_24 : boolean;
    variable transform_left_filter_feature_1_choice_25, transform_left_filter_feature_1_choice_26 : boolean;
    variable transform_left_filter_feature_1_choice_27, transform_left_filter_feature_1_choice_28 : boolean;
    variable transform_left_filter_feature_1_choice_29, transform_left_filter_feature_1_choice_30 : boolean;
    variable transform_left_filter_feature_1_choice_31, transform_left_filter_feature_1_choice_32 : boolean;
    variable transform_left_filter_feature_1_choice_33, transform_left_filter_feature_1_choice_34 : boolean;
    variable transform_left_filter_feature_1_choice_35, transform_left_filter_feature_1_choice_36 : boolean;
    variable transform_left_filter_feature_1_choice_37, transform_left_filter_feature_1_choice_38 : boolean;
    variable transform_left_filter_feature_1_choice_39, transform_left_filter_feature_1_choice_40 : boolean;
    variable transform_left_filter_feature_1_choice_41, transform_left_filter_feature_1_choice_42 : boolean;
    variable transform_left_filter_feature_1_choice_43, transform_left_filter_feature_1_choice_44 : boolean;
    variable transform_left_filter_feature_1_choice_45, transform_left_filter_feature_1_choice_46 : boolean;
    variable transform_left_filter_feature_1_choice_47, transform_left_filter_feature_1_choice_48 : boolean;
    variable transform_left_filter_feature_1_choice_49, transform_left_filter_feature_1_choice_50 : boolean;
    variable transform_left_filter_feature_1_choice_51, transform_left_filter_feature_1_choice_52 : boolean;
    variable transform_left_filter_feature_1_choice_53, transform_left_filter_feature_1_choice_54 : boolean;
    variable transform_left_filter_feature_1_choice_55, transform_left_filter_feature_1_choice_56 : boolean;
    variable transform_left_filter_feature_1_choice_57, transform_left_filter_feature_1_choice_58 : boolean;
    variable transform_left_filter_feature_1_choice_59, transform_left_filter_feature_1_choice_60 : boolean;
    variable transform_left_filter_feature_1_choice_61, transform_left_filter_feature_1_choice_62 : boolean;
    variable transform_left_filter_feature_1_choice_63, transform_left_filter_feature_1_choice_64 : boolean;
    variable transform_left_filter_feature_1_choice_65, transform_left_filter_feature_1_choice_66 : boolean;
    variable transform_left_filter_feature_1_choice_67, transform_left_filter_feature_1_choice_68 : boolean;
    variable transform_left_filter_feature_1_choice_69, transform_left_filter_feature_1_choice_70 : boolean;
    variable transform_left_filter_feature_1_choice_71, transform_left_filter_feature_1_choice_72 : boolean;
    variable transform_left_filter_feature_1_choice_73, transform_left_filter_feature_1_choice_74 : boolean;
    variable transform_left_filter_feature_1_choice_75, transform_left_filter_feature_1_choice_76 : boolean;
    variable transform_left_filter_feature_1_choice_77, transform_left_filter_feature_1_choice_78 : boolean;
    variable transform_left_filter_feature_1_choice_79, transform_left_filter_feature_1_choice_80 : boolean;
    variable transform_left_filter_feature_1_choice_81, transform_left_filter_feature_1_choice_82 : boolean;
    variable transform_left_filter_feature_1_choice_83, transform_left_filter_feature_1_choice_84 : boolean;
    variable transform_left_filter_feature_1_choice_85, transform_left_filter_feature_1_choice_86 : boolean;
    variable transform_left_filter_feature_1_choice_87, transform_left_filter_feature_1_choice_88 : boolean;
    variable transform_left_filter_feature_1_choice_89, transform_left_filter_feature_1_choice_90 : boolean;
    variable transform_left_filter_feature_1_choice_91, transform_left_filter_feature_1_choice_92 : boolean;
    variable transform_left_filter_feature_1_choice_93, transform_left_filter_feature_1_choice_94 : boolean;
    variable transform_left_filter_feature_1_choice_95, transform_left_filter_feature_1_choice_96 : boolean;
    variable transform_left_filter_feature_1_choice_97, transform_left_filter_feature_1_choice_98 : boolean;
    variable transform_left_filter_feature_1_choice_99, transform_left_filter_feature_1_choice_100 : boolean;
    variable transform_left_filter_feature_1_choice_101, transform_left_filter_feature_1_choice_102 : boolean;
    variable transform_left_filter_feature_1_choice_103, transform_left_filter_feature_1_choice_104 : boolean;
    variable transform_left_filter_feature_1_choice_105, transform_left_filter_feature_1_choice_106 : boolean;
    variable transform_left_filter_feature_1_choice_107, transform_left_filter_feature_1_choice_108 : boolean;
    variable transform_left_filter_feature_1_choice_109, transform_left_filter_feature_1_choice_110 : boolean;
    variable transform_left_filter_feature_1_choice_111, transform_left_filter_feature_1_choice_112 : boolean;
    variable transform_left_filter_feature_1_choice_113, transform_left_filter_feature_1_choice_114 : boolean;
    variable transform_left_filter_feature_1_choice_115, transform_left_filter_feature_1_choice_116 : boolean;
    variable transform_left_filter_feature_1_choice_117, transform_left_filter_feature_1_choice_118 : boolean;
    variable transform_left_filter_feature_1_choice_119, transform_left_filter_feature_1_choice_120 : boolean;
    variable transform_left_filter_feature_1_choice_121, transform_left_filter_feature_1_choice_122 : boolean;
    variable transform_left_filter_feature_1_choice_123, transform_left_filter_feature_1_choice_124 : boolean;
    variable transform_left_filter_feature_1_choice_125, transform_left_filter_feature_1_choice_126 : boolean;
    variable transform_left_filter_feature_1_choice_127, transform_left_filter_feature_1_choice_128 : boolean;
    variable transform_left_filter_feature_1_choice_129, transform_left_filter_feature_1_choice_130 : boolean;
    variable transform_left_filter_feature_1_choice_131, transform_left_filter_feature_1_choice_132 : boolean;
    variable transform_left_filter_feature_1_choice_133, transform_left_filter_feature_1_choice_134 : boolean;
    variable transform_left_filter_feature_1_choice_135, transform_left_filter_feature_1_choice_136 : boolean;
    variable transform_left_filter_feature_1_choice_137, transform_left_filter_feature_1_choice_138 : boolean;
    variable transform_left_filter_feature_1_choice_139, transform_left_filter_feature_1_choice_140 : boolean;
    variable transform_left_filter_feature_1_choice_141, transform_left_filter_feature_1_choice_142 : boolean;
    variable transform_left_filter_feature_1_choice_143, transform_left_filter_feature_1_choice_144 : boolean;
    variable transform_left_filter_feature_1_choice_145, transform_left_filter_feature_1_choice_146 : boolean;
    variable transform_left_filter_feature_1_choice_147, transform_left_filter_feature_1_choice_148 : boolean;
    variable transform_left_filter_feature_1_choice_149, transform_left_filter_feature_1_choice_150 : boolean;
    variable transform_left_filter_feature_1_choice_151, transform_left_filter_feature_1_choice_152 : boolean;
    variable transform_left_filter_feature_1_choice_153, transform_left_filter_feature_1_choice_157 : boolean;
    variable transform_left_filter_feature_1_choice_158, transform_left_filter_feature_1_choice_159 : boolean;
    variable transform_left_filter_feature_1_choice_160, transform_left_filter_feature_1_choice_161 : boolean;
    variable transform_left_filter_feature_1_choice_162, transform_left_filter_feature_1_choice_163 : boolean;
    variable transform_left_filter_feature_1_choice_164, transform_right_filter_feature_0_value : boolean;
    variable transform_right_filter_feature_0_any, transform_right_filter_feature_0_choice : boolean;
    variable transform_right_filter_feature_0_is_equal, transform_right_filter_feature_0_choice_2 : boolean;
    variable transform_right_filter_feature_0_value_2, transform_right_filter_feature_0_choice_3 : boolean;
    variable transform_right_filter_feature_0_value_3, transform_right_filter_feature_0_choice_4 : boolean;
    variable transform_right_filter_feature_0_value_4, transform_right_filter_feature_0_choice_5 : boolean;
    variable transform_right_filter_feature_0_value_5, transform_right_filter_feature_0_choice_6 : boolean;
    variable transform_right_filter_feature_0_value_6, transform_right_filter_feature_0_choice_7 : boolean;
    variable transform_right_filter_feature_0_choice_8, transform_right_filter_feature_0_value_7 : boolean;
    variable transform_right_filter_feature_0_choice_9, transform_right_filter_feature_0_choice_10 : boolean;
    variable transform_right_filter_feature_0_choice_11, transform_right_filter_feature_0_choice_12 : boolean;
    variable transform_right_filter_feature_0_choice_13, transform_right_filter_feature_0_choice_14 : boolean;
    variable transform_right_filter_feature_0_choice_15, transform_right_filter_feature_0_choice_16 : boolean;
    variable transform_right_filter_feature_0_value_8, transform_right_filter_feature_0_choice_17 : boolean;
    variable transform_right_filter_feature_0_choice_18, transform_right_filter_feature_0_choice_19 : boolean;
    variable transform_right_filter_feature_0_choice_20, transform_right_filter_feature_0_choice_21 : boolean;
    variable transform_right_filter_feature_0_choice_22, transform_right_filter_feature_0_choice_23 : boolean;
    variable transform_right_filter_feature_0_choice_24, transform_right_filter_feature_0_choice_25 : boolean;
    variable transform_right_filter_feature_0_choice_26, transform_right_filter_feature_0_choice_27 : boolean;
    variable transform_right_filter_feature_0_choice_28, transform_right_filter_feature_0_choice_29 : boolean;
    variable transform_right_filter_feature_0_choice_30, transform_right_filter_feature_0_choice_31 : boolean;
    variable transform_right_filter_feature_0_choice_32, transform_right_filter_feature_0_value_9 : boolean;
    variable transform_right_filter_feature_0_choice_33, transform_right_filter_feature_0_choice_34 : boolean;
    variable transform_right_filter_feature_0_choice_35, transform_right_filter_feature_0_choice_36 : boolean;
    variable transform_right_filter_feature_0_choice_37, transform_right_filter_feature_0_choice_38 : boolean;
    variable transform_right_filter_feature_0_choice_39, transform_right_filter_feature_0_choice_40 : boolean;
    variable transform_right_filter_feature_0_value_10, transform_right_filter_feature_0_choice_41 : boolean;
    variable transform_right_filter_feature_0_choice_42, transform_right_filter_feature_0_choice_43 : boolean;
    variable transform_right_filter_feature_0_choice_44, transform_right_filter_feature_0_choice_45 : boolean;
    variable transform_right_filter_feature_0_choice_46, transform_right_filter_feature_0_choice_47 : boolean;
    variable transform_right_filter_feature_0_choice_48, transform_right_filter_feature_0_choice_49 : boolean;
    variable transform_right_filter_feature_0_choice_50, transform_right_filter_feature_0_choice_51 : boolean;
    variable transform_right_filter_feature_0_choice_52, transform_right_filter_feature_0_choice_53 : boolean;
    variable transform_right_filter_feature_0_choice_54, transform_right_filter_feature_0_choice_55 : boolean;
    variable transform_right_filter_feature_0_choice_56, transform_right_filter_feature_0_value_11 : boolean;
    variable transform_right_filter_feature_0_choice_57, transform_right_filter_feature_0_choice_58 : boolean;
    variable transform_right_filter_feature_0_choice_59, transform_right_filter_feature_0_choice_60 : boolean;
    variable transform_right_filter_feature_0_choice_61, transform_right_filter_feature_0_choice_62 : boolean;
    variable transform_right_filter_feature_0_choice_63, transform_right_filter_feature_0_choice_64 : boolean;
    variable transform_right_filter_feature_0_value_12, transform_right_filter_feature_0_choice_65 : boolean;
    variable transform_right_filter_feature_0_choice_66, transform_right_filter_feature_0_choice_67 : boolean;
    variable transform_right_filter_feature_0_choice_68, transform_right_filter_feature_0_choice_69 : boolean;
    variable transform_right_filter_feature_0_choice_70, transform_right_filter_feature_0_choice_71 : boolean;
    variable transform_right_filter_feature_0_choice_72, transform_right_filter_feature_0_value_13 : boolean;
    variable transform_right_filter_feature_0_choice_73, transform_right_filter_feature_0_choice_74 : boolean;
    variable transform_right_filter_feature_0_value_14, transform_right_filter_feature_0_all : boolean;
    variable transform_right_filter_feature_0_any_2, transform_right_filter_feature_0_choice_75 : boolean;
    variable transform_right_filter_feature_0_value_15, transform_right_filter_feature_0_any_3 : boolean;
    variable transform_right_filter_feature_0_all_2, transform_right_filter_feature_0_choice_76 : boolean;
    variable transform_right_filter_feature_0_value_16, transform_right_filter_feature_0_any_4 : boolean;
    variable transform_right_filter_feature_0_all_3, transform_right_filter_feature_0_choice_77 : boolean;
    variable transform_right_filter_feature_0_value_17, transform_right_filter_feature_0_any_5 : boolean;
    variable transform_right_filter_feature_0_all_4, transform_right_filter_feature_0_choice_78 : boolean;
    variable transform_right_filter_feature_0_value_18, transform_right_filter_feature_0_any_6 : boolean;
    variable transform_right_filter_feature_0_all_5, transform_right_filter_feature_0_choice_79 : boolean;
    variable transform_right_filter_feature_0_choice_80, transform_right_filter_feature_0_choice_81 : boolean;
    variable transform_right_filter_feature_0_value_19, transform_right_filter_feature_0_choice_82 : boolean;
    variable transform_right_filter_feature_0_choice_83, transform_right_filter_feature_0_value_20 : boolean;
    variable transform_right_filter_feature_0_choice_84, transform_right_filter_feature_0_value_21 : boolean;
    variable transform_right_filter_feature_0_choice_85, transform_right_filter_feature_0_value_22 : boolean;
    variable transform_right_filter_feature_0_choice_86, transform_right_filter_feature_0_value_23 : boolean;
    variable transform_right_filter_feature_0_choice_87, transform_right_filter_feature_0_value_24 : boolean;
    variable transform_right_filter_feature_0_choice_88, transform_right_filter_feature_0_choice_89 : boolean;
    variable transform_right_filter_feature_0_value_25, transform_right_filter_feature_0_choice_90 : boolean;
    variable transform_right_filter_feature_0_choice_91, transform_right_filter_feature_0_value_26 : boolean;
    variable transform_right_filter_feature_0_choice_92, transform_right_filter_feature_0_value_27 : boolean;
    variable transform_right_filter_feature_0_choice_93, transform_right_filter_feature_0_value_28 : boolean;
    variable transform_right_filter_feature_0_choice_94, transform_right_filter_feature_0_value_29 : boolean;
    variable transform_right_filter_feature_0_choice_95, transform_right_filter_feature_0_value_30 : boolean;
    variable transform_right_filter_feature_0_choice_96, transform_right_filter_feature_0_choice_97 : boolean;
    variable transform_right_filter_feature_0_choice_98, transform_right_filter_feature_0_choice_99 : boolean;
    variable transform_right_filter_feature_0_choice_100, transform_right_filter_feature_0_choice_101 : boolean;
    variable transform_right_filter_feature_0_choice_102, transform_right_filter_feature_0_choice_103 : boolean;
    variable transform_right_filter_feature_0_choice_104, transform_right_filter_feature_0_choice_105 : boolean;
    variable transform_right_filter_feature_0_value_31, transform_right_filter_feature_0_choice_106 : boolean;
    variable transform_right_filter_feature_0_choice_107, transform_right_filter_feature_0_value_32 : boolean;
    variable transform_right_filter_feature_0_choice_108, transform_right_filter_feature_0_value_33 : boolean;
    variable transform_right_filter_feature_0_choice_109, transform_right_filter_feature_0_value_34 : boolean;
    variable transform_right_filter_feature_0_choice_110, transform_right_filter_feature_0_value_35 : boolean;
    variable transform_right_filter_feature_0_choice_111, transform_right_filter_feature_0_value_36 : boolean;
    variable transform_right_filter_feature_0_choice_112, transform_right_filter_feature_0_choice_113 : boolean;
    variable transform_right_filter_feature_0_value_37, transform_right_filter_feature_0_choice_114 : boolean;
    variable transform_right_filter_feature_0_choice_115, transform_right_filter_feature_0_value_38 : boolean;
    variable transform_right_filter_feature_0_choice_116, transform_right_filter_feature_0_value_39 : boolean;
    variable transform_right_filter_feature_0_choice_117, transform_right_filter_feature_0_value_40 : boolean;
    variable transform_right_filter_feature_0_choice_118, transform_right_filter_feature_0_value_41 : boolean;
    variable transform_right_filter_feature_0_choice_119, transform_right_filter_feature_0_value_42 : boolean;
    variable transform_right_filter_feature_0_choice_120, transform_right_filter_feature_0_choice_121 : boolean;
    variable transform_right_filter_feature_0_choice_122, transform_right_filter_feature_0_choice_123 : boolean;
    variable transform_right_filter_feature_0_choice_124, transform_right_filter_feature_0_choice_125 : boolean;
    variable transform_right_filter_feature_0_choice_126, transform_right_filter_feature_0_choice_127 : boolean;
    variable transform_right_filter_feature_0_choice_128, transform_right_filter_feature_0_choice_129 : boolean;
    variable transform_right_filter_feature_0_value_43, transform_right_filter_feature_0_choice_130 : boolean;
    variable transform_right_filter_feature_0_choice_131, transform_right_filter_feature_0_value_44 : boolean;
    variable transform_right_filter_feature_0_choice_132, transform_right_filter_feature_0_value_45 : boolean;
    variable transform_right_filter_feature_0_choice_133, transform_right_filter_feature_0_value_46 : boolean;
    variable transform_right_filter_feature_0_choice_134, transform_right_filter_feature_0_value_47 : boolean;
    variable transform_right_filter_feature_0_choice_135, transform_right_filter_feature_0_value_48 : boolean;
    variable transform_right_filter_feature_0_choice_136, transform_right_filter_feature_0_choice_137 : boolean;
    variable transform_right_filter_feature_0_value_49, transform_right_filter_feature_0_choice_138 : boolean;
    variable transform_right_filter_feature_0_choice_139, transform_right_filter_feature_0_value_50 : boolean;
    variable transform_right_filter_feature_0_choice_140, transform_right_filter_feature_0_value_51 : boolean;
    variable transform_right_filter_feature_0_choice_141, transform_right_filter_feature_0_value_52 : boolean;
    variable transform_right_filter_feature_0_choice_142, transform_right_filter_feature_0_value_53 : boolean;
    variable transform_right_filter_feature_0_choice_143, transform_right_filter_feature_0_value_54 : boolean;
    variable transform_right_filter_feature_0_choice_144, transform_right_filter_feature_0_choice_145 : boolean;
    variable transform_right_filter_feature_0_choice_146, transform_right_filter_feature_0_choice_147 : boolean;
    variable transform_right_filter_feature_0_value_55, transform_right_filter_feature_0_choice_148 : boolean;
    variable transform_right_filter_feature_0_value_56, transform_right_filter_feature_0_choice_149 : boolean;
    variable transform_right_filter_feature_0_value_57, transform_right_filter_feature_0_choice_150 : boolean;
    variable transform_right_filter_feature_0_value_58, transform_right_filter_feature_0_choice_151 : boolean;
    variable transform_right_filter_feature_0_value_59, transform_right_filter_feature_0_choice_152 : boolean;
    variable transform_right_filter_feature_0_choice_153, transform_right_filter_feature_0_choice_157 : boolean;
    variable transform_right_filter_feature_0_choice_158, transform_right_filter_feature_0_choice_159 : boolean;
    variable transform_right_filter_feature_0_choice_160, transform_right_filter_feature_0_choice_161 : boolean;
    variable transform_right_filter_feature_0_choice_162, transform_right_filter_feature_0_choice_163 : boolean;
    variable transform_right_filter_feature_0_choice_164, transform_right_filter_feature_1_any : boolean;
    variable transform_right_filter_feature_1_choice, transform_right_filter_feature_1_is_equal : boolean;
    variable transform_right_filter_feature_1_choice_2, transform_right_filter_feature_1_choice_3 : boolean;
    variable transform_right_filter_feature_1_choice_4, transform_right_filter_feature_1_choice_5 : boolean;
    variable transform_right_filter_feature_1_choice_6, transform_right_filter_feature_1_choice_7 : boolean;
    variable transform_right_filter_feature_1_choice_8, transform_right_filter_feature_1_choice_9 : boolean;
    variable transform_right_filter_feature_1_choice_10, transform_right_filter_feature_1_choice_11 : boolean;
    variable transform_right_filter_feature_1_choice_12, transform_right_filter_feature_1_choice_13 : boolean;
    variable transform_right_filter_feature_1_choice_14, transform_right_filter_feature_1_choice_15 : boolean;
    variable transform_right_filter_feature_1_choice_16, transform_right_filter_feature_1_choice_17 : boolean;
    variable transform_right_filter_feature_1_choice_18, transform_right_filter_feature_1_choice_19 : boolean;
    variable transform_right_filter_feature_1_choice_20, transform_right_filter_feature_1_choice_21 : boolean;
    variable transform_right_filter_feature_1_choice_22, transform_right_filter_feature_1_choice_23 : boolean;
    variable transform_right_filter_feature_1_choice_24, transform_right_filter_feature_1_choice_25 : boolean;
    variable transform_right_filter_feature_1_choice_26, transform_right_filter_feature_1_choice_27 : boolean;
    variable transform_right_filter_feature_1_choice_28, transform_right_filter_feature_1_choice_29 : boolean;
    variable transform_right_filter_feature_1_choice_30, transform_right_filter_feature_1_choice_31 : boolean;
    variable transform_right_filter_feature_1_choice_32, transform_right_filter_feature_1_choice_33 : boolean;
    variable transform_right_filter_feature_1_choice_34, transform_right_filter_feature_1_choice_35 : boolean;
    variable transform_right_filter_feature_1_choice_36, transform_right_filter_feature_1_choice_37 : boolean;
    variable transform_right_filter_feature_1_choice_38, transform_right_filter_feature_1_choice_39 : boolean;
    variable transform_right_filter_feature_1_choice_40, transform_right_filter_feature_1_choice_41 : boolean;
    variable transform_right_filter_feature_1_choice_42, transform_right_filter_feature_1_choice_43 : boolean;
    variable transform_right_filter_feature_1_choice_44, transform_right_filter_feature_1_choice_45 : boolean;
    variable transform_right_filter_feature_1_choice_46, transform_right_filter_feature_1_choice_47 : boolean;
    variable transform_right_filter_feature_1_choice_48, transform_right_filter_feature_1_choice_49 : boolean;
    variable transform_right_filter_feature_1_choice_50, transform_right_filter_feature_1_choice_51 : boolean;
    variable transform_right_filter_feature_1_choice_52, transform_right_filter_feature_1_choice_53 : boolean;
    variable transform_right_filter_feature_1_choice_54, transform_right_filter_feature_1_choice_55 : boolean;
    variable transform_right_filter_feature_1_choice_56, transform_right_filter_feature_1_choice_57 : boolean;
    variable transform_right_filter_feature_1_choice_58, transform_right_filter_feature_1_choice_59 : boolean;
    variable transform_right_filter_feature_1_choice_60, transform_right_filter_feature_1_choice_61 : boolean;
    variable transform_right_filter_feature_1_choice_62, transform_right_filter_feature_1_choice_63 : boolean;
    variable transform_right_filter_feature_1_choice_64, transform_right_filter_feature_1_choice_65 : boolean;
    variable transform_right_filter_feature_1_choice_66, transform_right_filter_feature_1_choice_67 : boolean;
    variable transform_right_filter_feature_1_choice_68, transform_right_filter_feature_1_choice_69 : boolean;
    variable transform_right_filter_feature_1_choice_70, transform_right_filter_feature_1_choice_71 : boolean;
    variable transform_right_filter_feature_1_choice_72, transform_right_filter_feature_1_choice_73 : boolean;
    variable transform_right_filter_feature_1_choice_74, transform_right_filter_feature_1_choice_75 : boolean;
    variable transform_right_filter_feature_1_choice_76, transform_right_filter_feature_1_choice_77 : boolean;
    variable transform_right_filter_feature_1_choice_78, transform_right_filter_feature_1_choice_79 : boolean;
    variable transform_right_filter_feature_1_choice_80, transform_right_filter_feature_1_choice_81 : boolean;
    variable transform_right_filter_feature_1_choice_82, transform_right_filter_feature_1_choice_83 : boolean;
    variable transform_right_filter_feature_1_choice_84, transform_right_filter_feature_1_choice_85 : boolean;
    variable transform_right_filter_feature_1_choice_86, transform_right_filter_feature_1_choice_87 : boolean;
    variable transform_right_filter_feature_1_choice_88, transform_right_filter_feature_1_choice_89 : boolean;
    variable transform_right_filter_feature_1_choice_90, transform_right_filter_feature_1_choice_91 : boolean;
    variable transform_right_filter_feature_1_choice_92, transform_right_filter_feature_1_choice_93 : boolean;
    variable transform_right_filter_feature_1_choice_94, transform_right_filter_feature_1_choice_95 : boolean;
    variable transform_right_filter_feature_1_choice_96, transform_right_filter_feature_1_choice_97 : boolean;
    variable transform_right_filter_feature_1_choice_98, transform_right_filter_feature_1_choice_99 : boolean;
    variable transform_right_filter_feature_1_choice_100, transform_right_filter_feature_1_choice_101 : boolean;
    variable transform_right_filter_feature_1_choice_102, transform_right_filter_feature_1_choice_103 : boolean;
    variable transform_right_filter_feature_1_choice_104, transform_right_filter_feature_1_choice_105 : boolean;
    variable transform_right_filter_feature_1_choice_106, transform_right_filter_feature_1_choice_107 : boolean;
    variable transform_right_filter_feature_1_choice_108, transform_right_filter_feature_1_choice_109 : boolean;
    variable transform_right_filter_feature_1_choice_110, transform_right_filter_feature_1_choice_111 : boolean;
    variable transform_right_filter_feature_1_choice_112, transform_right_filter_feature_1_choice_113 : boolean;
    variable transform_right_filter_feature_1_choice_114, transform_right_filter_feature_1_choice_115 : boolean;
    variable transform_right_filter_feature_1_choice_116, transform_right_filter_feature_1_choice_117 : boolean;
    variable transform_right_filter_feature_1_choice_118, transform_right_filter_feature_1_choice_119 : boolean;
    variable transform_right_filter_feature_1_choice_120, transform_right_filter_feature_1_choice_121 : boolean;
    variable transform_right_filter_feature_1_choice_122, transform_right_filter_feature_1_choice_123 : boolean;
    variable transform_right_filter_feature_1_choice_124, transform_right_filter_feature_1_choice_125 : boolean;
    variable transform_right_filter_feature_1_choice_126, transform_right_filter_feature_1_choice_127 : boolean;
    variable transform_right_filter_feature_1_choice_128, transform_right_filter_feature_1_choice_129 : boolean;
    variable transform_right_filter_feature_1_choice_130, transform_right_filter_feature_1_choice_131 : boolean;
    variable transform_right_filter_feature_1_choice_132, transform_right_filter_feature_1_choice_133 : boolean;
    variable transform_right_filter_feature_1_choice_134, transform_right_filter_feature_1_choice_135 : boolean;
    variable transform_right_filter_feature_1_choice_136, transform_right_filter_feature_1_choice_137 : boolean;
    variable transform_right_filter_feature_1_choice_138, transform_right_filter_feature_1_choice_139 : boolean;
    variable transform_right_filter_feature_1_choice_140, transform_right_filter_feature_1_choice_141 : boolean;
    variable transform_right_filter_feature_1_choice_142, transform_right_filter_feature_1_choice_143 : boolean;
    variable transform_right_filter_feature_1_choice_144, transform_right_filter_feature_1_choice_145 : boolean;
    variable transform_right_filter_feature_1_choice_146, transform_right_filter_feature_1_choice_147 : boolean;
    variable transform_right_filter_feature_1_choice_148, transform_right_filter_feature_1_choice_149 : boolean;
    variable transform_right_filter_feature_1_choice_150, transform_right_filter_feature_1_choice_151 : boolean;
    variable transform_right_filter_feature_1_choice_152, transform_right_filter_feature_1_choice_153 : boolean;
    variable transform_right_filter_feature_1_choice_157, transform_right_filter_feature_1_choice_158 : boolean;
    variable transform_right_filter_feature_1_choice_159, transform_right_filter_feature_1_choice_160 : boolean;
    variable transform_right_filter_feature_1_choice_161, transform_right_filter_feature_1_choice_162 : boolean;
    variable transform_right_filter_feature_1_choice_163, transform_right_filter_feature_1_choice_164 : boolean;
    variable transform_counter_next_frame_choice, transform_counter_next_frame_choice_2 : boolean;
    variable raster_place_group_is_equal, raster_place_group_all, raster_place_group_is_equal_2 : boolean;
    variable raster_place_group_choice_2, raster_place_next_frame_choice, raster_place_next_frame_choice_2 : boolean;
    variable delay_row_inside_0_value, delay_row_inside_0_any, delay_row_inside_1_any : boolean;
    variable slice0cost_pixels_first_0_0_count_0_value, slice0cost_pixels_first_0_0_count_0_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_1_value, slice0cost_pixels_first_0_0_count_1_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_1_value_3, slice0cost_pixels_first_0_0_count_2_value : boolean;
    variable slice0cost_pixels_first_0_0_count_2_value_2, slice0cost_pixels_first_0_0_count_3_value : boolean;
    variable slice0cost_pixels_first_0_0_count_3_value_2, slice0cost_pixels_first_0_0_count_3_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_4_value, slice0cost_pixels_first_0_0_count_4_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_4_value_3, slice0cost_pixels_first_0_0_count_5_value : boolean;
    variable slice0cost_pixels_first_0_0_count_5_value_2, slice0cost_pixels_first_0_0_count_5_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_6_value, slice0cost_pixels_first_1_0_count_0_value : boolean;
    variable slice0cost_pixels_first_1_0_count_0_value_2, slice0cost_pixels_first_1_0_count_1_value : boolean;
    variable slice0cost_pixels_first_1_0_count_1_value_2, slice0cost_pixels_first_1_0_count_1_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_2_value, slice0cost_pixels_first_1_0_count_2_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_3_value, slice0cost_pixels_first_1_0_count_3_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_3_value_3, slice0cost_pixels_first_1_0_count_4_value : boolean;
    variable slice0cost_pixels_first_1_0_count_4_value_2, slice0cost_pixels_first_1_0_count_4_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_5_value, slice0cost_pixels_first_1_0_count_5_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_5_value_3, slice0cost_pixels_first_1_0_count_6_value : boolean;
    variable slice0cost_pixels_first_2_0_count_0_value, slice0cost_pixels_first_2_0_count_0_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_1_value, slice0cost_pixels_first_2_0_count_1_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_1_value_3, slice0cost_pixels_first_2_0_count_2_value : boolean;
    variable slice0cost_pixels_first_2_0_count_2_value_2, slice0cost_pixels_first_2_0_count_3_value : boolean;
    variable slice0cost_pixels_first_2_0_count_3_value_2, slice0cost_pixels_first_2_0_count_3_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_4_value, slice0cost_pixels_first_2_0_count_4_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_4_value_3, slice0cost_pixels_first_2_0_count_5_value : boolean;
    variable slice0cost_pixels_first_2_0_count_5_value_2, slice0cost_pixels_first_2_0_count_5_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_6_value, slice0cost_pixels_first_3_0_count_0_value : boolean;
    variable slice0cost_pixels_first_3_0_count_0_value_2, slice0cost_pixels_first_3_0_count_1_value : boolean;
    variable slice0cost_pixels_first_3_0_count_1_value_2, slice0cost_pixels_first_3_0_count_1_value_3 : boolean;
    variable slice0cost_pixels_first_3_0_count_2_value, slice0cost_pixels_first_3_0_count_2_value_2 : boolean;
    variable slice0cost_pixels_first_3_0_count_3_value, slice0cost_pixels_first_3_0_count_3_value_2 : boolean;
    variable slice0cost_pixels_first_3_0_count_3_value_3, slice0cost_pixels_first_3_0_count_4_value : boolean;
    variable slice0cost_pixels_first_3_0_count_4_value_2, slice0cost_pixels_first_3_0_count_4_value_3 : boolean;
    variable slice0cost_pixels_first_3_0_count_5_value, slice0cost_pixels_first_3_0_count_5_value_2 : boolean;
    variable slice0cost_pixels_first_3_0_count_5_value_3, slice0cost_pixels_first_3_0_count_6_value : boolean;
    variable slice0winner1_of_pair_0_0_choice, slice0winner1_of_pair_0_0_choice_2 : boolean;
    variable slice0winner1_of_pair_0_0_value, slice0winner1_of_pair_0_0_choice_3 : boolean;
    variable slice0winner1_of_pair_0_0_value_2, slice0winner1_of_pair_0_0_choice_4 : boolean;
    variable slice0winner1_of_pair_0_0_value_3, slice0winner1_of_pair_0_0_choice_5 : boolean;
    variable slice0winner1_of_pair_0_0_value_4, slice0winner1_of_pair_0_0_choice_6 : boolean;
    variable slice0winner1_of_pair_0_0_value_5, slice0winner1_of_pair_0_0_choice_7 : boolean;
    variable slice0winner1_of_pair_0_0_choice_8, slice0winner1_of_pair_1_0_choice : boolean;
    variable slice0winner1_of_pair_1_0_choice_2, slice0winner1_of_pair_1_0_value : boolean;
    variable slice0winner1_of_pair_1_0_choice_3, slice0winner1_of_pair_1_0_value_2 : boolean;
    variable slice0winner1_of_pair_1_0_choice_4, slice0winner1_of_pair_1_0_value_3 : boolean;
    variable slice0winner1_of_pair_1_0_choice_5, slice0winner1_of_pair_1_0_value_4 : boolean;
    variable slice0winner1_of_pair_1_0_choice_6, slice0winner1_of_pair_1_0_value_5 : boolean;
    variable slice0winner1_of_pair_1_0_choice_7, slice0winner1_of_pair_1_0_choice_8 : boolean;
    variable slice0winner1_of_four_0_0_value, slice0winner1_of_four_0_0_value_2 : boolean;
    variable slice0winner1_of_four_0_0_choice, slice0winner1_of_four_0_0_value_3 : boolean;
    variable slice0winner1_of_four_0_0_choice_2, slice0winner1_of_four_0_0_value_4 : boolean;
    variable slice0winner1_of_four_0_0_choice_3, slice0winner1_of_four_0_0_value_5 : boolean;
    variable slice0winner1_of_four_0_0_choice_4, slice0winner1_of_four_0_0_value_6 : boolean;
    variable slice0winner1_of_four_0_0_choice_5, slice0winner1_of_four_0_0_value_7 : boolean;
    variable slice0winner1_of_four_0_0_choice_6, slice0winner1_of_four_0_0_choice_7 : boolean;
    variable slice0winner1_of_four_1_0_value, slice0winner1_of_four_1_0_value_2 : boolean;
    variable slice0winner1_of_four_1_0_choice, slice0winner1_of_four_1_0_value_3 : boolean;
    variable slice0winner1_of_four_1_0_choice_2, slice0winner1_of_four_1_0_value_4 : boolean;
    variable slice0winner1_of_four_1_0_choice_3, slice0winner1_of_four_1_0_value_5 : boolean;
    variable slice0winner1_of_four_1_0_choice_4, slice0winner1_of_four_1_0_value_6 : boolean;
    variable slice0winner1_of_four_1_0_choice_5, slice0winner1_of_four_1_0_value_7 : boolean;
    variable slice0winner1_of_four_1_0_choice_6, slice0winner1_of_four_1_0_choice_7 : boolean;
    variable slice1cost_pixels_first_0_0_count_0_value, slice1cost_pixels_first_0_0_count_0_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_1_value, slice1cost_pixels_first_0_0_count_1_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_1_value_3, slice1cost_pixels_first_0_0_count_2_value : boolean;
    variable slice1cost_pixels_first_0_0_count_2_value_2, slice1cost_pixels_first_0_0_count_3_value : boolean;
    variable slice1cost_pixels_first_0_0_count_3_value_2, slice1cost_pixels_first_0_0_count_3_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_4_value, slice1cost_pixels_first_0_0_count_4_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_count_4_value_3, slice1cost_pixels_first_0_0_count_5_value : boolean;
    variable slice1cost_pixels_first_0_0_count_5_value_2, slice1cost_pixels_first_0_0_count_5_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_6_value, slice1cost_pixels_first_1_0_count_0_value : boolean;
    variable slice1cost_pixels_first_1_0_count_0_value_2, slice1cost_pixels_first_1_0_count_1_value : boolean;
    variable slice1cost_pixels_first_1_0_count_1_value_2, slice1cost_pixels_first_1_0_count_1_value_3 : boolean;
    variable slice1cost_pixels_first_1_0_count_2_value, slice1cost_pixels_first_1_0_count_2_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_3_value, slice1cost_pixels_first_1_0_count_3_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_3_value_3, slice1cost_pixels_first_1_0_count_4_value : boolean;
    variable slice1cost_pixels_first_1_0_count_4_value_2, slice1cost_pixels_first_1_0_count_4_value_3 : boolean;
    variable slice1cost_pixels_first_1_0_count_5_value, slice1cost_pixels_first_1_0_count_5_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_5_value_3, slice1cost_pixels_first_1_0_count_6_value : boolean;
    variable slice1cost_pixels_first_2_0_count_0_value, slice1cost_pixels_first_2_0_count_0_value_2 : boolean;
    variable slice1cost_pixels_first_2_0_count_1_value, slice1cost_pixels_first_2_0_count_1_value_2 : boolean;
    variable slice1cost_pixels_first_2_0_count_1_value_3, slice1cost_pixels_first_2_0_count_2_value : boolean;
    variable slice1cost_pixels_first_2_0_count_2_value_2, slice1cost_pixels_first_2_0_count_3_value : boolean;
    variable slice1cost_pixels_first_2_0_count_3_value_2, slice1cost_pixels_first_2_0_count_3_value_3 : boolean;
    variable slice1cost_pixels_first_2_0_count_4_value, slice1cost_pixels_first_2_0_count_4_value_2 : boolean;
    variable slice1cost_pixels_first_2_0_count_4_value_3, slice1cost_pixels_first_2_0_count_5_value : boolean;
    variable slice1cost_pixels_first_2_0_count_5_value_2, slice1cost_pixels_first_2_0_count_5_value_3 : boolean;
    variable slice1cost_pixels_first_2_0_count_6_value, slice1cost_pixels_first_3_0_count_0_value : boolean;
    variable slice1cost_pixels_first_3_0_count_0_value_2, slice1cost_pixels_first_3_0_count_1_value : boolean;
    variable slice1cost_pixels_first_3_0_count_1_value_2, slice1cost_pixels_first_3_0_count_1_value_3 : boolean;
    variable slice1cost_pixels_first_3_0_count_2_value, slice1cost_pixels_first_3_0_count_2_value_2 : boolean;
    variable slice1cost_pixels_first_3_0_count_3_value, slice1cost_pixels_first_3_0_count_3_value_2 : boolean;
    variable slice1cost_pixels_first_3_0_count_3_value_3, slice1cost_pixels_first_3_0_count_4_value : boolean;
    variable slice1cost_pixels_first_3_0_count_4_value_2, slice1cost_pixels_first_3_0_count_4_value_3 : boolean;
    variable slice1cost_pixels_first_3_0_count_5_value, slice1cost_pixels_first_3_0_count_5_value_2 : boolean;
    variable slice1cost_pixels_first_3_0_count_5_value_3, slice1cost_pixels_first_3_0_count_6_value : boolean;
    variable slice1winner1_of_pair_0_0_choice, slice1winner1_of_pair_0_0_choice_2 : boolean;
    variable slice1winner1_of_pair_0_0_value, slice1winner1_of_pair_0_0_choice_3 : boolean;
    variable slice1winner1_of_pair_0_0_value_2, slice1winner1_of_pair_0_0_choice_4 : boolean;
    variable slice1winner1_of_pair_0_0_value_3, slice1winner1_of_pair_0_0_choice_5 : boolean;
    variable slice1winner1_of_pair_0_0_value_4, slice1winner1_of_pair_0_0_choice_6 : boolean;
    variable slice1winner1_of_pair_0_0_value_5, slice1winner1_of_pair_0_0_choice_7 : boolean;
    variable slice1winner1_of_pair_0_0_choice_8, slice1winner1_of_pair_1_0_choice : boolean;
    variable slice1winner1_of_pair_1_0_choice_2, slice1winner1_of_pair_1_0_value : boolean;
    variable slice1winner1_of_pair_1_0_choice_3, slice1winner1_of_pair_1_0_value_2 : boolean;
    variable slice1winner1_of_pair_1_0_choice_4, slice1winner1_of_pair_1_0_value_3 : boolean;
    variable slice1winner1_of_pair_1_0_choice_5, slice1winner1_of_pair_1_0_value_4 : boolean;
    variable slice1winner1_of_pair_1_0_choice_6, slice1winner1_of_pair_1_0_value_5 : boolean;
    variable slice1winner1_of_pair_1_0_choice_7, slice1winner1_of_pair_1_0_choice_8 : boolean;
    variable slice1winner1_of_four_0_0_value, slice1winner1_of_four_0_0_value_2 : boolean;
    variable slice1winner1_of_four_0_0_choice, slice1winner1_of_four_0_0_value_3 : boolean;
    variable slice1winner1_of_four_0_0_choice_2, slice1winner1_of_four_0_0_value_4 : boolean;
    variable slice1winner1_of_four_0_0_choice_3, slice1winner1_of_four_0_0_value_5 : boolean;
    variable slice1winner1_of_four_0_0_choice_4, slice1winner1_of_four_0_0_value_6 : boolean;
    variable slice1winner1_of_four_0_0_choice_5, slice1winner1_of_four_0_0_value_7 : boolean;
    variable slice1winner1_of_four_0_0_choice_6, slice1winner1_of_four_0_0_choice_7 : boolean;
    variable slice1winner1_of_four_1_0_value, slice1winner1_of_four_1_0_value_2 : boolean;
    variable slice1winner1_of_four_1_0_choice, slice1winner1_of_four_1_0_value_3 : boolean;
    variable slice1winner1_of_four_1_0_choice_2, slice1winner1_of_four_1_0_value_4 : boolean;
    variable slice1winner1_of_four_1_0_choice_3, slice1winner1_of_four_1_0_value_5 : boolean;
    variable slice1winner1_of_four_1_0_choice_4, slice1winner1_of_four_1_0_value_6 : boolean;
    variable slice1winner1_of_four_1_0_choice_5, slice1winner1_of_four_1_0_value_7 : boolean;
    variable slice1winner1_of_four_1_0_choice_6, slice1winner1_of_four_1_0_choice_7 : boolean;
    variable slice1_best_index_0_0_choice, slice1_best_index_0_0_choice_2, slice1_best_index_0_0_value : boolean;
    variable slice1_best_index_0_0_choice_3, slice1_best_index_0_0_value_2, slice1_best_index_0_0_choice_4 : boolean;
    variable slice1_best_index_0_0_value_3, slice1_best_index_0_0_choice_5, slice1_best_index_0_0_value_4 : boolean;
    variable slice1_best_index_0_0_choice_6, slice1_best_index_0_0_value_5, slice1_best_index_0_0_choice_7 : boolean;
    variable slice1_best_index_0_0_choice_8, slice1_best_index_1_0_choice, slice1_best_index_1_0_choice_2 : boolean;
    variable slice1_best_index_1_0_value, slice1_best_index_1_0_choice_3, slice1_best_index_1_0_value_2 : boolean;
    variable slice1_best_index_1_0_choice_4, slice1_best_index_1_0_value_3, slice1_best_index_1_0_choice_5 : boolean;
    variable slice1_best_index_1_0_value_4, slice1_best_index_1_0_choice_6, slice1_best_index_1_0_value_5 : boolean;
    variable slice1_best_index_1_0_choice_7, slice1_best_index_1_0_choice_8 : boolean;
    variable slice2cost_pixels_first_0_0_count_0_value, slice2cost_pixels_first_0_0_count_0_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_1_value, slice2cost_pixels_first_0_0_count_1_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_1_value_3, slice2cost_pixels_first_0_0_count_2_value : boolean;
    variable slice2cost_pixels_first_0_0_count_2_value_2, slice2cost_pixels_first_0_0_count_3_value : boolean;
    variable slice2cost_pixels_first_0_0_count_3_value_2, slice2cost_pixels_first_0_0_count_3_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_4_value, slice2cost_pixels_first_0_0_count_4_value_2 : boolean;
    variable slice2cost_pixels_first_0_0_count_4_value_3, slice2cost_pixels_first_0_0_count_5_value : boolean;
    variable slice2cost_pixels_first_0_0_count_5_value_2, slice2cost_pixels_first_0_0_count_5_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_6_value, slice2cost_pixels_first_1_0_count_0_value : boolean;
    variable slice2cost_pixels_first_1_0_count_0_value_2, slice2cost_pixels_first_1_0_count_1_value : boolean;
    variable slice2cost_pixels_first_1_0_count_1_value_2, slice2cost_pixels_first_1_0_count_1_value_3 : boolean;
    variable slice2cost_pixels_first_1_0_count_2_value, slice2cost_pixels_first_1_0_count_2_value_2 : boolean;
    variable slice2cost_pixels_first_1_0_count_3_value, slice2cost_pixels_first_1_0_count_3_value_2 : boolean;
    variable slice2cost_pixels_first_1_0_count_3_value_3, slice2cost_pixels_first_1_0_count_4_value : boolean;
    variable slice2cost_pixels_first_1_0_count_4_value_2, slice2cost_pixels_first_1_0_count_4_value_3 : boolean;
    variable slice2cost_pixels_first_1_0_count_5_value, slice2cost_pixels_first_1_0_count_5_value_2 : boolean;
    variable slice2cost_pixels_first_1_0_count_5_value_3, slice2cost_pixels_first_1_0_count_6_value : boolean;
    variable slice2cost_pixels_first_2_0_count_0_value, slice2cost_pixels_first_2_0_count_0_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_1_value, slice2cost_pixels_first_2_0_count_1_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_1_value_3, slice2cost_pixels_first_2_0_count_2_value : boolean;
    variable slice2cost_pixels_first_2_0_count_2_value_2, slice2cost_pixels_first_2_0_count_3_value : boolean;
    variable slice2cost_pixels_first_2_0_count_3_value_2, slice2cost_pixels_first_2_0_count_3_value_3 : boolean;
    variable slice2cost_pixels_first_2_0_count_4_value, slice2cost_pixels_first_2_0_count_4_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_4_value_3, slice2cost_pixels_first_2_0_count_5_value : boolean;
    variable slice2cost_pixels_first_2_0_count_5_value_2, slice2cost_pixels_first_2_0_count_5_value_3 : boolean;
    variable slice2cost_pixels_first_2_0_count_6_value, slice2cost_pixels_first_3_0_count_0_value : boolean;
    variable slice2cost_pixels_first_3_0_count_0_value_2, slice2cost_pixels_first_3_0_count_1_value : boolean;
    variable slice2cost_pixels_first_3_0_count_1_value_2, slice2cost_pixels_first_3_0_count_1_value_3 : boolean;
    variable slice2cost_pixels_first_3_0_count_2_value, slice2cost_pixels_first_3_0_count_2_value_2 : boolean;
    variable slice2cost_pixels_first_3_0_count_3_value, slice2cost_pixels_first_3_0_count_3_value_2 : boolean;
    variable slice2cost_pixels_first_3_0_count_3_value_3, slice2cost_pixels_first_3_0_count_4_value : boolean;
    variable slice2cost_pixels_first_3_0_count_4_value_2, slice2cost_pixels_first_3_0_count_4_value_3 : boolean;
    variable slice2cost_pixels_first_3_0_count_5_value, slice2cost_pixels_first_3_0_count_5_value_2 : boolean;
    variable slice2cost_pixels_first_3_0_count_5_value_3, slice2cost_pixels_first_3_0_count_6_value : boolean;
    variable slice2winner1_best_index_0_0_choice, slice2winner1_best_index_0_0_choice_2 : boolean;
    variable slice2winner1_best_index_0_0_value, slice2winner1_best_index_0_0_choice_3 : boolean;
    variable slice2winner1_best_index_0_0_value_2, slice2winner1_best_index_0_0_choice_4 : boolean;
    variable slice2winner1_best_index_0_0_value_3, slice2winner1_best_index_0_0_choice_5 : boolean;
    variable slice2winner1_best_index_0_0_value_4, slice2winner1_best_index_0_0_choice_6 : boolean;
    variable slice2winner1_best_index_0_0_value_5, slice2winner1_best_index_0_0_choice_7 : boolean;
    variable slice2winner1_best_index_1_0_choice, slice2winner1_best_index_1_0_choice_2 : boolean;
    variable slice2winner1_best_index_1_0_value, slice2winner1_best_index_1_0_choice_3 : boolean;
    variable slice2winner1_best_index_1_0_value_2, slice2winner1_best_index_1_0_choice_4 : boolean;
    variable slice2winner1_best_index_1_0_value_3, slice2winner1_best_index_1_0_choice_5 : boolean;
    variable slice2winner1_best_index_1_0_value_4, slice2winner1_best_index_1_0_choice_6 : boolean;
    variable slice2winner1_best_index_1_0_value_5, slice2winner1_best_index_1_0_choice_7 : boolean;
    variable slice2_best_index_0_0_choice, slice2_best_index_0_0_choice_2, slice2_best_index_0_0_value : boolean;
    variable slice2_best_index_0_0_choice_3, slice2_best_index_0_0_value_2, slice2_best_index_0_0_choice_4 : boolean;
    variable slice2_best_index_0_0_value_3, slice2_best_index_0_0_choice_5, slice2_best_index_0_0_value_4 : boolean;
    variable slice2_best_index_0_0_choice_6, slice2_best_index_0_0_value_5, slice2_best_index_0_0_choice_7 : boolean;
    variable slice2_best_index_0_0_choice_8, slice2_best_index_1_0_choice, slice2_best_index_1_0_choice_2 : boolean;
    variable slice2_best_index_1_0_value, slice2_best_index_1_0_choice_3, slice2_best_index_1_0_value_2 : boolean;
    variable slice2_best_index_1_0_choice_4, slice2_best_index_1_0_value_3, slice2_best_index_1_0_choice_5 : boolean;
    variable slice2_best_index_1_0_value_4, slice2_best_index_1_0_choice_6, slice2_best_index_1_0_value_5 : boolean;
    variable slice2_best_index_1_0_choice_7, slice2_best_index_1_0_choice_8 : boolean;
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 3;
    variable transform_counter_group_choice_3, transform_counter_group_choice_4 : natural range 0 to 7;
    variable transform_left_filter_feature_0_choice_154 : natural range 0 to 7;
    variable transform_left_filter_feature_1_choice_154 : natural range 0 to 7;
    variable transform_right_filter_feature_0_choice_154 : natural range 0 to 7;
    variable transform_right_filter_feature_1_choice_154, raster_place_group_choice_3 : natural range 0 to 7;
    variable raster_place_group_choice_4 : natural range 0 to 7;
    variable transform_left_filter_feature_0_choice_155 : natural range 0 to 63;
    variable transform_left_filter_feature_1_choice_155 : natural range 0 to 63;
    variable transform_right_filter_feature_0_choice_155 : natural range 0 to 63;
    variable transform_right_filter_feature_1_choice_155 : natural range 0 to 63;
    variable transform_left_filter_feature_0_choice_156 : natural range 0 to 511;
    variable transform_left_filter_feature_1_choice_156 : natural range 0 to 511;
    variable transform_right_filter_feature_0_choice_156 : natural range 0 to 511;
    variable transform_right_filter_feature_1_choice_156 : natural range 0 to 511;
    variable transform_left_filter_feature_0_choice_165 : natural range 0 to 1023;
    variable transform_left_filter_feature_1_choice_165 : natural range 0 to 1023;
    variable transform_right_filter_feature_0_choice_165 : natural range 0 to 1023;
    variable transform_right_filter_feature_1_choice_165 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_166 : natural range 0 to 16383;
    variable transform_left_filter_feature_1_choice_166 : natural range 0 to 16383;
    variable transform_right_filter_feature_0_choice_166 : natural range 0 to 16383;
    variable transform_right_filter_feature_1_choice_166 : natural range 0 to 16383;
    variable transform_left_filter_feature_0_choice_167 : natural range 0 to 131071;
    variable transform_left_filter_feature_1_choice_167 : natural range 0 to 131071;
    variable transform_right_filter_feature_0_choice_167 : natural range 0 to 131071;
    variable transform_right_filter_feature_1_choice_167 : natural range 0 to 131071;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 31;
      transform_counter_group_all := transform_counter_group_is_equal and (transform_counter_group = 5);
      if transform_counter_group_all then
        transform_counter_group_choice := 3;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_is_equal_2 := (transform_counter_group / 2) = 3;
      if transform_counter_group_is_equal_2 then
        transform_counter_group_choice_2 := in_valid and (not ((transform_counter_group mod 2) = 1));
      else
        transform_counter_group_choice_2 := in_valid;
      end if;
      if transform_counter_next_frame and (transform_counter_group = 6) then
        transform_counter_group_choice_3 := 1;
      else
        transform_counter_group_choice_3 := (transform_counter_group + 1) mod 8;
      end if;
      if transform_counter_group_is_equal and transform_counter_group_choice_2 then
        transform_counter_group_choice_4 := transform_counter_group_choice_3;
      else
        transform_counter_group_choice_4 := transform_counter_group;
      end if;
      transform_read_row_inside_0_value := ((transform_counter_group / 2) mod 2) = 1;
      transform_read_row_inside_0_any := ((transform_counter_group / 4) = 1) or transform_read_row_inside_0_value;
      transform_read_row_inside_1_any := (not ((transform_counter_group / 4) = 1)) or (not
        transform_read_row_inside_0_value);
      transform_read_column_inside_0_value := ((transform_counter_column / 8) mod 2) = 1;
      transform_read_column_inside_0_value_2 := ((transform_counter_column / 4) mod 2) = 1;
      transform_read_column_inside_1_is_equal := (transform_counter_column / 4) = 0;
      transform_read_column_inside_1_all := ((transform_counter_column mod 4) /= 3) and
        transform_read_column_inside_1_is_equal;
      transform_read_column_inside_1_is_equal_2 := (transform_counter_column mod 4) = 0;
      transform_read_column_inside_1_value := ((transform_counter_column / 2) mod 2) = 1;
      if transform_read_column_inside_1_all then
        transform_read_column_inside_1_choice := transform_read_column_inside_1_is_equal_2;
      else
        transform_read_column_inside_1_choice := transform_read_column_inside_1_value or ((transform_counter_column mod
          2) = 1);
      end if;
      transform_left_filter_feature_0_value := ((transform_left_filter_column_3_1 / 2) mod 2) = 1;
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        ((transform_left_filter_column_3_1 mod 2) = 1));
      if (transform_left_filter_column_6_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_3_1 mod 4) = 0;
      if ((transform_left_filter_column_6_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choice_2 := ((transform_left_filter_column_6_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_2 := ((transform_left_filter_column_3_1 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_2 then
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_3 := ((transform_left_filter_column_3_1 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_3 then
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_4 := ((transform_left_filter_column_3_1 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_4 then
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_5 := ((transform_left_filter_column_3_1 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_5 then
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_6 := ((transform_left_filter_column_3_1 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_6 then
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_7 then
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_6_0 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_6_0 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_7 := ((transform_left_filter_column_6_1 / 2) mod 2) = 1;
      if (transform_left_filter_column_6_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_9 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_9 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_7 then
        transform_left_filter_feature_0_choice_10 := transform_left_filter_feature_0_choice_9;
      else
        transform_left_filter_feature_0_choice_10 := ((transform_left_filter_column_6_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_10 then
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_11 then
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_12 then
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_13 then
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_14 then
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_15 then
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_6_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_6_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_8 := ((transform_left_filter_column_6_2 / 2) mod 2) = 1;
      if (transform_left_filter_column_6_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_17 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_17 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_8 then
        transform_left_filter_feature_0_choice_18 := transform_left_filter_feature_0_choice_17;
      else
        transform_left_filter_feature_0_choice_18 := ((transform_left_filter_column_6_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_18 then
        transform_left_filter_feature_0_choice_19 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_19 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_19 then
        transform_left_filter_feature_0_choice_20 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_20 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_20 then
        transform_left_filter_feature_0_choice_21 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_21 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_21 then
        transform_left_filter_feature_0_choice_22 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_22 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_22 then
        transform_left_filter_feature_0_choice_23 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_23 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_23 then
        transform_left_filter_feature_0_choice_24 := ((transform_left_filter_column_6_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_24 := ((transform_left_filter_column_6_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_25 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_25 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_26 := transform_left_filter_feature_0_choice_25;
      else
        transform_left_filter_feature_0_choice_26 := ((transform_left_filter_column_5_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_26 then
        transform_left_filter_feature_0_choice_27 := (not (((transform_left_filter_column_5_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_27 := (not (((transform_left_filter_column_5_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_27 then
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_5_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_5_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_28 then
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_5_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_5_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_29 then
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_5_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_5_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_30 then
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_5_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_5_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_31 then
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_5_0 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_5_0 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_9 := ((transform_left_filter_column_5_1 / 2) mod 2) = 1;
      if (transform_left_filter_column_5_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_33 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_33 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_9 then
        transform_left_filter_feature_0_choice_34 := transform_left_filter_feature_0_choice_33;
      else
        transform_left_filter_feature_0_choice_34 := ((transform_left_filter_column_5_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_34 then
        transform_left_filter_feature_0_choice_35 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_35 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_35 then
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_36 then
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_37 then
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_38 then
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_39 then
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_5_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_5_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_10 := ((transform_left_filter_column_5_2 / 2) mod 2) = 1;
      if (transform_left_filter_column_5_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_41 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_41 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_10 then
        transform_left_filter_feature_0_choice_42 := transform_left_filter_feature_0_choice_41;
      else
        transform_left_filter_feature_0_choice_42 := ((transform_left_filter_column_5_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_42 then
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_43 then
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_44 then
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_45 then
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_46 then
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_47 then
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_5_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_5_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_49 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_49 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_50 := transform_left_filter_feature_0_choice_49;
      else
        transform_left_filter_feature_0_choice_50 := ((transform_left_filter_column_4_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_50 then
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_51 then
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_52 then
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_53 then
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_54 then
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_55 then
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_4_0 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_4_0 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_11 := ((transform_left_filter_column_4_1 / 2) mod 2) = 1;
      if (transform_left_filter_column_4_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_57 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_57 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_11 then
        transform_left_filter_feature_0_choice_58 := transform_left_filter_feature_0_choice_57;
      else
        transform_left_filter_feature_0_choice_58 := ((transform_left_filter_column_4_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_58 then
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_59 then
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_60 then
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_61 then
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_62 then
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_63 then
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_4_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_4_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_12 := ((transform_left_filter_column_4_2 / 2) mod 2) = 1;
      if (transform_left_filter_column_4_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_65 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_65 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_12 then
        transform_left_filter_feature_0_choice_66 := transform_left_filter_feature_0_choice_65;
      else
        transform_left_filter_feature_0_choice_66 := ((transform_left_filter_column_4_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_66 then
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_67 then
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_68 then
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_69 then
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_70 then
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_71 then
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_4_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_4_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_13 := ((transform_left_filter_column_3_2 / 2) mod 2) = 1;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_73 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_73 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_13 then
        transform_left_filter_feature_0_choice_74 := transform_left_filter_feature_0_choice_73;
      else
        transform_left_filter_feature_0_choice_74 := ((transform_left_filter_column_3_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_14 := ((transform_left_filter_column_3_2 / 4) mod 2) = 1;
      transform_left_filter_feature_0_all := (not transform_left_filter_feature_0_value_14) and
        transform_left_filter_feature_0_value_2;
      transform_left_filter_feature_0_any_2 := (not transform_left_filter_feature_0_value_14) or
        transform_left_filter_feature_0_value_2;
      if transform_left_filter_feature_0_choice_74 then
        transform_left_filter_feature_0_choice_75 := transform_left_filter_feature_0_all;
      else
        transform_left_filter_feature_0_choice_75 := transform_left_filter_feature_0_any_2;
      end if;
      transform_left_filter_feature_0_value_15 := ((transform_left_filter_column_3_2 / 8) mod 2) = 1;
      transform_left_filter_feature_0_any_3 := (not transform_left_filter_feature_0_value_15) or
        transform_left_filter_feature_0_value_3;
      transform_left_filter_feature_0_all_2 := (not transform_left_filter_feature_0_value_15) and
        transform_left_filter_feature_0_value_3;
      if transform_left_filter_feature_0_choice_75 then
        transform_left_filter_feature_0_choice_76 := transform_left_filter_feature_0_any_3;
      else
        transform_left_filter_feature_0_choice_76 := transform_left_filter_feature_0_all_2;
      end if;
      transform_left_filter_feature_0_value_16 := ((transform_left_filter_column_3_2 / 16) mod 2) = 1;
      transform_left_filter_feature_0_any_4 := (not transform_left_filter_feature_0_value_16) or
        transform_left_filter_feature_0_value_4;
      transform_left_filter_feature_0_all_3 := (not transform_left_filter_feature_0_value_16) and
        transform_left_filter_feature_0_value_4;
      if transform_left_filter_feature_0_choice_76 then
        transform_left_filter_feature_0_choice_77 := transform_left_filter_feature_0_any_4;
      else
        transform_left_filter_feature_0_choice_77 := transform_left_filter_feature_0_all_3;
      end if;
      transform_left_filter_feature_0_value_17 := ((transform_left_filter_column_3_2 / 32) mod 2) = 1;
      transform_left_filter_feature_0_any_5 := (not transform_left_filter_feature_0_value_17) or
        transform_left_filter_feature_0_value_5;
      transform_left_filter_feature_0_all_4 := (not transform_left_filter_feature_0_value_17) and
        transform_left_filter_feature_0_value_5;
      if transform_left_filter_feature_0_choice_77 then
        transform_left_filter_feature_0_choice_78 := transform_left_filter_feature_0_any_5;
      else
        transform_left_filter_feature_0_choice_78 := transform_left_filter_feature_0_all_4;
      end if;
      transform_left_filter_feature_0_value_18 := ((transform_left_filter_column_3_2 / 64) mod 2) = 1;
      transform_left_filter_feature_0_any_6 := (not transform_left_filter_feature_0_value_18) or
        transform_left_filter_feature_0_value_6;
      transform_left_filter_feature_0_all_5 := (not transform_left_filter_feature_0_value_18) and
        transform_left_filter_feature_0_value_6;
      if transform_left_filter_feature_0_choice_78 then
        transform_left_filter_feature_0_choice_79 := transform_left_filter_feature_0_any_6;
      else
        transform_left_filter_feature_0_choice_79 := transform_left_filter_feature_0_all_5;
      end if;
      if (transform_left_filter_column_3_2 / 128) = 1 then
        transform_left_filter_feature_0_choice_80 := transform_filtering_0_column_inside_3;
      else
        transform_left_filter_feature_0_choice_80 := (not ((transform_left_filter_column_3_1 / 128) = 1)) and
          transform_filtering_0_column_inside_3;
      end if;
      if transform_left_filter_feature_0_choice_79 then
        transform_left_filter_feature_0_choice_81 := ((transform_left_filter_column_3_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1)) and transform_filtering_0_column_inside_3;
      else
        transform_left_filter_feature_0_choice_81 := transform_left_filter_feature_0_choice_80;
      end if;
      transform_left_filter_feature_0_value_19 := ((transform_left_filter_column_2_1 / 2) mod 2) = 1;
      if (transform_left_filter_column_2_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_82 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_82 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_19 then
        transform_left_filter_feature_0_choice_83 := transform_left_filter_feature_0_choice_82;
      else
        transform_left_filter_feature_0_choice_83 := ((transform_left_filter_column_2_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_20 := ((transform_left_filter_column_2_1 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_83 then
        transform_left_filter_feature_0_choice_84 := (not transform_left_filter_feature_0_value_20) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_84 := (not transform_left_filter_feature_0_value_20) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_21 := ((transform_left_filter_column_2_1 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_84 then
        transform_left_filter_feature_0_choice_85 := (not transform_left_filter_feature_0_value_21) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_85 := (not transform_left_filter_feature_0_value_21) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_22 := ((transform_left_filter_column_2_1 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_85 then
        transform_left_filter_feature_0_choice_86 := (not transform_left_filter_feature_0_value_22) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_86 := (not transform_left_filter_feature_0_value_22) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_23 := ((transform_left_filter_column_2_1 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_86 then
        transform_left_filter_feature_0_choice_87 := (not transform_left_filter_feature_0_value_23) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_87 := (not transform_left_filter_feature_0_value_23) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_24 := ((transform_left_filter_column_2_1 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_87 then
        transform_left_filter_feature_0_choice_88 := (not transform_left_filter_feature_0_value_24) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_88 := (not transform_left_filter_feature_0_value_24) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_88 then
        transform_left_filter_feature_0_choice_89 := ((transform_left_filter_column_2_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_89 := ((transform_left_filter_column_2_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_25 := ((transform_left_filter_column_2_2 / 2) mod 2) = 1;
      if (transform_left_filter_column_2_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_90 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_90 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_25 then
        transform_left_filter_feature_0_choice_91 := transform_left_filter_feature_0_choice_90;
      else
        transform_left_filter_feature_0_choice_91 := ((transform_left_filter_column_2_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_26 := ((transform_left_filter_column_2_2 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_91 then
        transform_left_filter_feature_0_choice_92 := (not transform_left_filter_feature_0_value_26) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_92 := (not transform_left_filter_feature_0_value_26) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_27 := ((transform_left_filter_column_2_2 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_92 then
        transform_left_filter_feature_0_choice_93 := (not transform_left_filter_feature_0_value_27) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_93 := (not transform_left_filter_feature_0_value_27) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_28 := ((transform_left_filter_column_2_2 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_93 then
        transform_left_filter_feature_0_choice_94 := (not transform_left_filter_feature_0_value_28) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_94 := (not transform_left_filter_feature_0_value_28) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_29 := ((transform_left_filter_column_2_2 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_94 then
        transform_left_filter_feature_0_choice_95 := (not transform_left_filter_feature_0_value_29) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_95 := (not transform_left_filter_feature_0_value_29) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_30 := ((transform_left_filter_column_2_2 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_95 then
        transform_left_filter_feature_0_choice_96 := (not transform_left_filter_feature_0_value_30) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_96 := (not transform_left_filter_feature_0_value_30) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_96 then
        transform_left_filter_feature_0_choice_97 := ((transform_left_filter_column_2_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_97 := ((transform_left_filter_column_2_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_98 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_98 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_99 := transform_left_filter_feature_0_choice_98;
      else
        transform_left_filter_feature_0_choice_99 := ((transform_left_filter_column_2_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_99 then
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_100 then
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_101 then
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_102 then
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_103 then
        transform_left_filter_feature_0_choice_104 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_104 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_104 then
        transform_left_filter_feature_0_choice_105 := ((transform_left_filter_column_2_0 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_105 := ((transform_left_filter_column_2_0 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_31 := ((transform_left_filter_column_1_1 / 2) mod 2) = 1;
      if (transform_left_filter_column_1_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_106 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_106 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_31 then
        transform_left_filter_feature_0_choice_107 := transform_left_filter_feature_0_choice_106;
      else
        transform_left_filter_feature_0_choice_107 := ((transform_left_filter_column_1_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_32 := ((transform_left_filter_column_1_1 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_107 then
        transform_left_filter_feature_0_choice_108 := (not transform_left_filter_feature_0_value_32) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_108 := (not transform_left_filter_feature_0_value_32) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_33 := ((transform_left_filter_column_1_1 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_108 then
        transform_left_filter_feature_0_choice_109 := (not transform_left_filter_feature_0_value_33) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_109 := (not transform_left_filter_feature_0_value_33) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_34 := ((transform_left_filter_column_1_1 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_109 then
        transform_left_filter_feature_0_choice_110 := (not transform_left_filter_feature_0_value_34) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_110 := (not transform_left_filter_feature_0_value_34) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_35 := ((transform_left_filter_column_1_1 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_110 then
        transform_left_filter_feature_0_choice_111 := (not transform_left_filter_feature_0_value_35) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_111 := (not transform_left_filter_feature_0_value_35) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_36 := ((transform_left_filter_column_1_1 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_111 then
        transform_left_filter_feature_0_choice_112 := (not transform_left_filter_feature_0_value_36) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_112 := (not transform_left_filter_feature_0_value_36) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_112 then
        transform_left_filter_feature_0_choice_113 := ((transform_left_filter_column_1_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_113 := ((transform_left_filter_column_1_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_37 := ((transform_left_filter_column_1_2 / 2) mod 2) = 1;
      if (transform_left_filter_column_1_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_114 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_114 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_37 then
        transform_left_filter_feature_0_choice_115 := transform_left_filter_feature_0_choice_114;
      else
        transform_left_filter_feature_0_choice_115 := ((transform_left_filter_column_1_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_38 := ((transform_left_filter_column_1_2 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_115 then
        transform_left_filter_feature_0_choice_116 := (not transform_left_filter_feature_0_value_38) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_116 := (not transform_left_filter_feature_0_value_38) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_39 := ((transform_left_filter_column_1_2 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_116 then
        transform_left_filter_feature_0_choice_117 := (not transform_left_filter_feature_0_value_39) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_117 := (not transform_left_filter_feature_0_value_39) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_40 := ((transform_left_filter_column_1_2 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_117 then
        transform_left_filter_feature_0_choice_118 := (not transform_left_filter_feature_0_value_40) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_118 := (not transform_left_filter_feature_0_value_40) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_41 := ((transform_left_filter_column_1_2 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_118 then
        transform_left_filter_feature_0_choice_119 := (not transform_left_filter_feature_0_value_41) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_119 := (not transform_left_filter_feature_0_value_41) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_42 := ((transform_left_filter_column_1_2 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_119 then
        transform_left_filter_feature_0_choice_120 := (not transform_left_filter_feature_0_value_42) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_120 := (not transform_left_filter_feature_0_value_42) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_120 then
        transform_left_filter_feature_0_choice_121 := ((transform_left_filter_column_1_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_121 := ((transform_left_filter_column_1_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_122 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_122 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_123 := transform_left_filter_feature_0_choice_122;
      else
        transform_left_filter_feature_0_choice_123 := ((transform_left_filter_column_1_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_123 then
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_124 then
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_125 then
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_126 then
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_127 then
        transform_left_filter_feature_0_choice_128 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_128 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_128 then
        transform_left_filter_feature_0_choice_129 := ((transform_left_filter_column_1_0 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_129 := ((transform_left_filter_column_1_0 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_43 := ((transform_left_filter_column_0_1 / 2) mod 2) = 1;
      if (transform_left_filter_column_0_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_130 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_130 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_43 then
        transform_left_filter_feature_0_choice_131 := transform_left_filter_feature_0_choice_130;
      else
        transform_left_filter_feature_0_choice_131 := ((transform_left_filter_column_0_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_44 := ((transform_left_filter_column_0_1 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_131 then
        transform_left_filter_feature_0_choice_132 := (not transform_left_filter_feature_0_value_44) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_132 := (not transform_left_filter_feature_0_value_44) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_45 := ((transform_left_filter_column_0_1 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_132 then
        transform_left_filter_feature_0_choice_133 := (not transform_left_filter_feature_0_value_45) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_133 := (not transform_left_filter_feature_0_value_45) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_46 := ((transform_left_filter_column_0_1 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_133 then
        transform_left_filter_feature_0_choice_134 := (not transform_left_filter_feature_0_value_46) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_134 := (not transform_left_filter_feature_0_value_46) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_47 := ((transform_left_filter_column_0_1 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_134 then
        transform_left_filter_feature_0_choice_135 := (not transform_left_filter_feature_0_value_47) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_135 := (not transform_left_filter_feature_0_value_47) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_48 := ((transform_left_filter_column_0_1 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_135 then
        transform_left_filter_feature_0_choice_136 := (not transform_left_filter_feature_0_value_48) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_136 := (not transform_left_filter_feature_0_value_48) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_136 then
        transform_left_filter_feature_0_choice_137 := ((transform_left_filter_column_0_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_137 := ((transform_left_filter_column_0_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      transform_left_filter_feature_0_value_49 := ((transform_left_filter_column_0_2 / 2) mod 2) = 1;
      if (transform_left_filter_column_0_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_138 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_138 := not transform_left_filter_feature_0_value;
      end if;
      if transform_left_filter_feature_0_value_49 then
        transform_left_filter_feature_0_choice_139 := transform_left_filter_feature_0_choice_138;
      else
        transform_left_filter_feature_0_choice_139 := ((transform_left_filter_column_0_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_50 := ((transform_left_filter_column_0_2 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_139 then
        transform_left_filter_feature_0_choice_140 := (not transform_left_filter_feature_0_value_50) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_140 := (not transform_left_filter_feature_0_value_50) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_51 := ((transform_left_filter_column_0_2 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_140 then
        transform_left_filter_feature_0_choice_141 := (not transform_left_filter_feature_0_value_51) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_141 := (not transform_left_filter_feature_0_value_51) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_52 := ((transform_left_filter_column_0_2 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_141 then
        transform_left_filter_feature_0_choice_142 := (not transform_left_filter_feature_0_value_52) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_142 := (not transform_left_filter_feature_0_value_52) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_53 := ((transform_left_filter_column_0_2 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_142 then
        transform_left_filter_feature_0_choice_143 := (not transform_left_filter_feature_0_value_53) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_143 := (not transform_left_filter_feature_0_value_53) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_54 := ((transform_left_filter_column_0_2 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_143 then
        transform_left_filter_feature_0_choice_144 := (not transform_left_filter_feature_0_value_54) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_144 := (not transform_left_filter_feature_0_value_54) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_144 then
        transform_left_filter_feature_0_choice_145 := ((transform_left_filter_column_0_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_145 := ((transform_left_filter_column_0_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_146 := not (((transform_left_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_left_filter_feature_0_choice_146 := (transform_left_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value then
        transform_left_filter_feature_0_choice_147 := ((transform_left_filter_column_3_1 mod 2) = 1) or (not
          (((transform_left_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_left_filter_column_0_0 mod 2) = 1));
      else
        transform_left_filter_feature_0_choice_147 := transform_left_filter_feature_0_choice_146;
      end if;
      transform_left_filter_feature_0_value_55 := ((transform_left_filter_column_0_0 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_147 then
        transform_left_filter_feature_0_choice_148 := (not transform_left_filter_feature_0_value_2) and
          transform_left_filter_feature_0_value_55;
      else
        transform_left_filter_feature_0_choice_148 := (not transform_left_filter_feature_0_value_2) or
          transform_left_filter_feature_0_value_55;
      end if;
      transform_left_filter_feature_0_value_56 := ((transform_left_filter_column_0_0 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_148 then
        transform_left_filter_feature_0_choice_149 := (not transform_left_filter_feature_0_value_3) or
          transform_left_filter_feature_0_value_56;
      else
        transform_left_filter_feature_0_choice_149 := (not transform_left_filter_feature_0_value_3) and
          transform_left_filter_feature_0_value_56;
      end if;
      transform_left_filter_feature_0_value_57 := ((transform_left_filter_column_0_0 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_149 then
        transform_left_filter_feature_0_choice_150 := (not transform_left_filter_feature_0_value_4) or
          transform_left_filter_feature_0_value_57;
      else
        transform_left_filter_feature_0_choice_150 := (not transform_left_filter_feature_0_value_4) and
          transform_left_filter_feature_0_value_57;
      end if;
      transform_left_filter_feature_0_value_58 := ((transform_left_filter_column_0_0 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_150 then
        transform_left_filter_feature_0_choice_151 := (not transform_left_filter_feature_0_value_5) or
          transform_left_filter_feature_0_value_58;
      else
        transform_left_filter_feature_0_choice_151 := (not transform_left_filter_feature_0_value_5) and
          transform_left_filter_feature_0_value_58;
      end if;
      transform_left_filter_feature_0_value_59 := ((transform_left_filter_column_0_0 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_151 then
        transform_left_filter_feature_0_choice_152 := (not transform_left_filter_feature_0_value_6) or
          transform_left_filter_feature_0_value_59;
      else
        transform_left_filter_feature_0_choice_152 := (not transform_left_filter_feature_0_value_6) and
          transform_left_filter_feature_0_value_59;
      end if;
      if transform_left_filter_feature_0_choice_152 then
        transform_left_filter_feature_0_choice_153 := (not ((transform_left_filter_column_3_1 / 128) = 1)) or
          ((transform_left_filter_column_0_0 / 128) = 1);
      else
        transform_left_filter_feature_0_choice_153 := (not ((transform_left_filter_column_3_1 / 128) = 1)) and
          ((transform_left_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_left_filter_feature_0_choice_154 := (as_number(transform_left_filter_feature_0_choice_137) * 2) +
          (as_number(transform_left_filter_feature_0_choice_145) * 4) +
          as_number(transform_left_filter_feature_0_choice_153);
      else
        transform_left_filter_feature_0_choice_154 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_left_filter_feature_0_choice_155 := (as_number(transform_left_filter_feature_0_choice_113) * 16) +
          (as_number(transform_left_filter_feature_0_choice_121) * 32) +
          (as_number(transform_left_filter_feature_0_choice_129) * 8) + transform_left_filter_feature_0_choice_154;
      else
        transform_left_filter_feature_0_choice_155 := transform_left_filter_feature_0_choice_154;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_left_filter_feature_0_choice_156 := (as_number(transform_left_filter_feature_0_choice_89) * 128) +
          (as_number(transform_left_filter_feature_0_choice_97) * 256) +
          (as_number(transform_left_filter_feature_0_choice_105) * 64) + transform_left_filter_feature_0_choice_155;
      else
        transform_left_filter_feature_0_choice_156 := transform_left_filter_feature_0_choice_155;
      end if;
      if (transform_left_filter_column_3_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_157 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_157 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_158 := transform_left_filter_feature_0_choice_157;
      else
        transform_left_filter_feature_0_choice_158 := ((transform_left_filter_column_3_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_158 then
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_159 then
        transform_left_filter_feature_0_choice_160 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_160 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_160 then
        transform_left_filter_feature_0_choice_161 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_161 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_161 then
        transform_left_filter_feature_0_choice_162 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_162 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_162 then
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_163 then
        transform_left_filter_feature_0_choice_164 := ((transform_left_filter_column_3_0 / 128) = 1) and (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_164 := ((transform_left_filter_column_3_0 / 128) = 1) or (not
          ((transform_left_filter_column_3_1 / 128) = 1));
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_left_filter_feature_0_choice_165 := transform_left_filter_feature_0_choice_156 +
          (as_number(transform_left_filter_feature_0_choice_164) * 512);
      else
        transform_left_filter_feature_0_choice_165 := transform_left_filter_feature_0_choice_156;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0_choice_166 := (as_number(transform_left_filter_feature_0_choice_56) * 2048) +
          (as_number(transform_left_filter_feature_0_choice_64) * 4096) +
          (as_number(transform_left_filter_feature_0_choice_72) * 8192) +
          (as_number(transform_left_filter_feature_0_choice_81) * 1024) + transform_left_filter_feature_0_choice_165;
      else
        transform_left_filter_feature_0_choice_166 := (as_number(transform_left_filter_feature_0_choice_81) * 1024) +
          transform_left_filter_feature_0_choice_165;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_left_filter_feature_0_choice_167 := (as_number(transform_left_filter_feature_0_choice_32) * 16384) +
          (as_number(transform_left_filter_feature_0_choice_40) * 32768) +
          (as_number(transform_left_filter_feature_0_choice_48) * 65536) + transform_left_filter_feature_0_choice_166;
      else
        transform_left_filter_feature_0_choice_167 := transform_left_filter_feature_0_choice_166;
      end if;
      transform_left_filter_feature_1_any := (not transform_left_filter_feature_0_value_13) or (not
        ((transform_left_filter_column_3_2 mod 2) = 1));
      if (transform_left_filter_column_6_1 mod 2) = 1 then
        transform_left_filter_feature_1_choice := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice := not transform_left_filter_feature_0_value_13;
      end if;
      transform_left_filter_feature_1_is_equal := (transform_left_filter_column_3_2 mod 4) = 0;
      if transform_left_filter_feature_0_value_7 then
        transform_left_filter_feature_1_choice_2 := transform_left_filter_feature_1_choice;
      else
        transform_left_filter_feature_1_choice_2 := ((transform_left_filter_column_6_1 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_2 then
        transform_left_filter_feature_1_choice_3 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_3 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_3 then
        transform_left_filter_feature_1_choice_4 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_4 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_4 then
        transform_left_filter_feature_1_choice_5 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_5 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_5 then
        transform_left_filter_feature_1_choice_6 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_6 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_6 then
        transform_left_filter_feature_1_choice_7 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_7 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_7 then
        transform_left_filter_feature_1_choice_8 := ((transform_left_filter_column_6_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_8 := ((transform_left_filter_column_6_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_9 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_9 := not transform_left_filter_feature_0_value_13;
      end if;
      if transform_left_filter_feature_0_value_8 then
        transform_left_filter_feature_1_choice_10 := transform_left_filter_feature_1_choice_9;
      else
        transform_left_filter_feature_1_choice_10 := ((transform_left_filter_column_6_2 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_10 then
        transform_left_filter_feature_1_choice_11 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_11 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_11 then
        transform_left_filter_feature_1_choice_12 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_12 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_12 then
        transform_left_filter_feature_1_choice_13 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_13 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_13 then
        transform_left_filter_feature_1_choice_14 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_14 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_14 then
        transform_left_filter_feature_1_choice_15 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_15 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_15 then
        transform_left_filter_feature_1_choice_16 := ((transform_left_filter_column_6_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_16 := ((transform_left_filter_column_6_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_3 mod 2) = 1 then
        transform_left_filter_feature_1_choice_17 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_17 := not transform_left_filter_feature_0_value_13;
      end if;
      if ((transform_left_filter_column_6_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_1_choice_18 := transform_left_filter_feature_1_choice_17;
      else
        transform_left_filter_feature_1_choice_18 := ((transform_left_filter_column_6_3 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_18 then
        transform_left_filter_feature_1_choice_19 := (not (((transform_left_filter_column_6_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_19 := (not (((transform_left_filter_column_6_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_19 then
        transform_left_filter_feature_1_choice_20 := (not (((transform_left_filter_column_6_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_20 := (not (((transform_left_filter_column_6_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_20 then
        transform_left_filter_feature_1_choice_21 := (not (((transform_left_filter_column_6_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_21 := (not (((transform_left_filter_column_6_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_21 then
        transform_left_filter_feature_1_choice_22 := (not (((transform_left_filter_column_6_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_22 := (not (((transform_left_filter_column_6_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_22 then
        transform_left_filter_feature_1_choice_23 := (not (((transform_left_filter_column_6_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_23 := (not (((transform_left_filter_column_6_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_23 then
        transform_left_filter_feature_1_choice_24 := ((transform_left_filter_column_6_3 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_24 := ((transform_left_filter_column_6_3 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_1 mod 2) = 1 then
        transform_left_filter_feature_1_choice_25 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_25 := not transform_left_filter_feature_0_value_13;
      end if;
      if transform_left_filter_feature_0_value_9 then
        transform_left_filter_feature_1_choice_26 := transform_left_filter_feature_1_choice_25;
      else
        transform_left_filter_feature_1_choice_26 := ((transform_left_filter_column_5_1 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_26 then
        transform_left_filter_feature_1_choice_27 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_27 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_27 then
        transform_left_filter_feature_1_choice_28 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_28 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_28 then
        transform_left_filter_feature_1_choice_29 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_29 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_29 then
        transform_left_filter_feature_1_choice_30 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_30 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_30 then
        transform_left_filter_feature_1_choice_31 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_31 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_31 then
        transform_left_filter_feature_1_choice_32 := ((transform_left_filter_column_5_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_32 := ((transform_left_filter_column_5_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_33 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_33 := not transform_left_filter_feature_0_value_13;
      end if;
      if transform_left_filter_feature_0_value_10 then
        transform_left_filter_feature_1_choice_34 := transform_left_filter_feature_1_choice_33;
      else
        transform_left_filter_feature_1_choice_34 := ((transform_left_filter_column_5_2 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_34 then
        transform_left_filter_feature_1_choice_35 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_35 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_35 then
        transform_left_filter_feature_1_choice_36 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_36 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_36 then
        transform_left_filter_feature_1_choice_37 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_37 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_37 then
        transform_left_filter_feature_1_choice_38 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_38 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_38 then
        transform_left_filter_feature_1_choice_39 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_39 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_39 then
        transform_left_filter_feature_1_choice_40 := ((transform_left_filter_column_5_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_40 := ((transform_left_filter_column_5_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_3 mod 2) = 1 then
        transform_left_filter_feature_1_choice_41 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_41 := not transform_left_filter_feature_0_value_13;
      end if;
      if ((transform_left_filter_column_5_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_1_choice_42 := transform_left_filter_feature_1_choice_41;
      else
        transform_left_filter_feature_1_choice_42 := ((transform_left_filter_column_5_3 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_42 then
        transform_left_filter_feature_1_choice_43 := (not (((transform_left_filter_column_5_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_43 := (not (((transform_left_filter_column_5_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_43 then
        transform_left_filter_feature_1_choice_44 := (not (((transform_left_filter_column_5_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_44 := (not (((transform_left_filter_column_5_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_44 then
        transform_left_filter_feature_1_choice_45 := (not (((transform_left_filter_column_5_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_45 := (not (((transform_left_filter_column_5_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_45 then
        transform_left_filter_feature_1_choice_46 := (not (((transform_left_filter_column_5_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_46 := (not (((transform_left_filter_column_5_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_46 then
        transform_left_filter_feature_1_choice_47 := (not (((transform_left_filter_column_5_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_47 := (not (((transform_left_filter_column_5_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_47 then
        transform_left_filter_feature_1_choice_48 := ((transform_left_filter_column_5_3 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_48 := ((transform_left_filter_column_5_3 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_1 mod 2) = 1 then
        transform_left_filter_feature_1_choice_49 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_49 := not transform_left_filter_feature_0_value_13;
      end if;
      if transform_left_filter_feature_0_value_11 then
        transform_left_filter_feature_1_choice_50 := transform_left_filter_feature_1_choice_49;
      else
        transform_left_filter_feature_1_choice_50 := ((transform_left_filter_column_4_1 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_50 then
        transform_left_filter_feature_1_choice_51 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_51 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_51 then
        transform_left_filter_feature_1_choice_52 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_52 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_52 then
        transform_left_filter_feature_1_choice_53 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_53 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_53 then
        transform_left_filter_feature_1_choice_54 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_54 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_54 then
        transform_left_filter_feature_1_choice_55 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_55 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_55 then
        transform_left_filter_feature_1_choice_56 := ((transform_left_filter_column_4_1 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_56 := ((transform_left_filter_column_4_1 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_57 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_57 := not transform_left_filter_feature_0_value_13;
      end if;
      if transform_left_filter_feature_0_value_12 then
        transform_left_filter_feature_1_choice_58 := transform_left_filter_feature_1_choice_57;
      else
        transform_left_filter_feature_1_choice_58 := ((transform_left_filter_column_4_2 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_58 then
        transform_left_filter_feature_1_choice_59 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_59 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_59 then
        transform_left_filter_feature_1_choice_60 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_60 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_60 then
        transform_left_filter_feature_1_choice_61 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_61 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_61 then
        transform_left_filter_feature_1_choice_62 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_62 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_62 then
        transform_left_filter_feature_1_choice_63 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_63 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_63 then
        transform_left_filter_feature_1_choice_64 := ((transform_left_filter_column_4_2 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_64 := ((transform_left_filter_column_4_2 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_3 mod 2) = 1 then
        transform_left_filter_feature_1_choice_65 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_65 := not transform_left_filter_feature_0_value_13;
      end if;
      if ((transform_left_filter_column_4_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_1_choice_66 := transform_left_filter_feature_1_choice_65;
      else
        transform_left_filter_feature_1_choice_66 := ((transform_left_filter_column_4_3 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_66 then
        transform_left_filter_feature_1_choice_67 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_67 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_67 then
        transform_left_filter_feature_1_choice_68 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_68 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_68 then
        transform_left_filter_feature_1_choice_69 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_69 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_69 then
        transform_left_filter_feature_1_choice_70 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_70 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_70 then
        transform_left_filter_feature_1_choice_71 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_71 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_71 then
        transform_left_filter_feature_1_choice_72 := ((transform_left_filter_column_4_3 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_72 := ((transform_left_filter_column_4_3 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_3 mod 2) = 1 then
        transform_left_filter_feature_1_choice_73 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_73 := not transform_left_filter_feature_0_value_13;
      end if;
      if ((transform_left_filter_column_3_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_1_choice_74 := transform_left_filter_feature_1_choice_73;
      else
        transform_left_filter_feature_1_choice_74 := ((transform_left_filter_column_3_3 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_74 then
        transform_left_filter_feature_1_choice_75 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_75 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_75 then
        transform_left_filter_feature_1_choice_76 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_76 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_76 then
        transform_left_filter_feature_1_choice_77 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_77 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_77 then
        transform_left_filter_feature_1_choice_78 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_78 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_78 then
        transform_left_filter_feature_1_choice_79 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_79 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if (transform_left_filter_column_3_3 / 128) = 1 then
        transform_left_filter_feature_1_choice_80 := transform_filtering_0_column_inside_3;
      else
        transform_left_filter_feature_1_choice_80 := (not ((transform_left_filter_column_3_2 / 128) = 1)) and
          transform_filtering_0_column_inside_3;
      end if;
      if transform_left_filter_feature_1_choice_79 then
        transform_left_filter_feature_1_choice_81 := ((transform_left_filter_column_3_3 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1)) and transform_filtering_0_column_inside_3;
      else
        transform_left_filter_feature_1_choice_81 := transform_left_filter_feature_1_choice_80;
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_82 := not transform_left_filter_feature_0_value_25;
      else
        transform_left_filter_feature_1_choice_82 := (transform_left_filter_column_2_2 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value_13 then
        transform_left_filter_feature_1_choice_83 := ((transform_left_filter_column_3_2 mod 2) = 1) or (not
          transform_left_filter_feature_0_value_25) or (not ((transform_left_filter_column_2_2 mod 2) = 1));
      else
        transform_left_filter_feature_1_choice_83 := transform_left_filter_feature_1_choice_82;
      end if;
      if transform_left_filter_feature_1_choice_83 then
        transform_left_filter_feature_1_choice_84 := (not transform_left_filter_feature_0_value_14) and
          transform_left_filter_feature_0_value_26;
      else
        transform_left_filter_feature_1_choice_84 := (not transform_left_filter_feature_0_value_14) or
          transform_left_filter_feature_0_value_26;
      end if;
      if transform_left_filter_feature_1_choice_84 then
        transform_left_filter_feature_1_choice_85 := (not transform_left_filter_feature_0_value_15) or
          transform_left_filter_feature_0_value_27;
      else
        transform_left_filter_feature_1_choice_85 := (not transform_left_filter_feature_0_value_15) and
          transform_left_filter_feature_0_value_27;
      end if;
      if transform_left_filter_feature_1_choice_85 then
        transform_left_filter_feature_1_choice_86 := (not transform_left_filter_feature_0_value_16) or
          transform_left_filter_feature_0_value_28;
      else
        transform_left_filter_feature_1_choice_86 := (not transform_left_filter_feature_0_value_16) and
          transform_left_filter_feature_0_value_28;
      end if;
      if transform_left_filter_feature_1_choice_86 then
        transform_left_filter_feature_1_choice_87 := (not transform_left_filter_feature_0_value_17) or
          transform_left_filter_feature_0_value_29;
      else
        transform_left_filter_feature_1_choice_87 := (not transform_left_filter_feature_0_value_17) and
          transform_left_filter_feature_0_value_29;
      end if;
      if transform_left_filter_feature_1_choice_87 then
        transform_left_filter_feature_1_choice_88 := (not transform_left_filter_feature_0_value_18) or
          transform_left_filter_feature_0_value_30;
      else
        transform_left_filter_feature_1_choice_88 := (not transform_left_filter_feature_0_value_18) and
          transform_left_filter_feature_0_value_30;
      end if;
      if transform_left_filter_feature_1_choice_88 then
        transform_left_filter_feature_1_choice_89 := (not ((transform_left_filter_column_3_2 / 128) = 1)) or
          ((transform_left_filter_column_2_2 / 128) = 1);
      else
        transform_left_filter_feature_1_choice_89 := (not ((transform_left_filter_column_3_2 / 128) = 1)) and
          ((transform_left_filter_column_2_2 / 128) = 1);
      end if;
      if (transform_left_filter_column_2_3 mod 2) = 1 then
        transform_left_filter_feature_1_choice_90 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_90 := not transform_left_filter_feature_0_value_13;
      end if;
      if ((transform_left_filter_column_2_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_1_choice_91 := transform_left_filter_feature_1_choice_90;
      else
        transform_left_filter_feature_1_choice_91 := ((transform_left_filter_column_2_3 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_91 then
        transform_left_filter_feature_1_choice_92 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_92 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_92 then
        transform_left_filter_feature_1_choice_93 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_93 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_93 then
        transform_left_filter_feature_1_choice_94 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_94 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_94 then
        transform_left_filter_feature_1_choice_95 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_95 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_95 then
        transform_left_filter_feature_1_choice_96 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_96 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_96 then
        transform_left_filter_feature_1_choice_97 := ((transform_left_filter_column_2_3 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_97 := ((transform_left_filter_column_2_3 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_98 := not transform_left_filter_feature_0_value_19;
      else
        transform_left_filter_feature_1_choice_98 := (transform_left_filter_column_2_1 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value_13 then
        transform_left_filter_feature_1_choice_99 := ((transform_left_filter_column_3_2 mod 2) = 1) or (not
          transform_left_filter_feature_0_value_19) or (not ((transform_left_filter_column_2_1 mod 2) = 1));
      else
        transform_left_filter_feature_1_choice_99 := transform_left_filter_feature_1_choice_98;
      end if;
      if transform_left_filter_feature_1_choice_99 then
        transform_left_filter_feature_1_choice_100 := (not transform_left_filter_feature_0_value_14) and
          transform_left_filter_feature_0_value_20;
      else
        transform_left_filter_feature_1_choice_100 := (not transform_left_filter_feature_0_value_14) or
          transform_left_filter_feature_0_value_20;
      end if;
      if transform_left_filter_feature_1_choice_100 then
        transform_left_filter_feature_1_choice_101 := (not transform_left_filter_feature_0_value_15) or
          transform_left_filter_feature_0_value_21;
      else
        transform_left_filter_feature_1_choice_101 := (not transform_left_filter_feature_0_value_15) and
          transform_left_filter_feature_0_value_21;
      end if;
      if transform_left_filter_feature_1_choice_101 then
        transform_left_filter_feature_1_choice_102 := (not transform_left_filter_feature_0_value_16) or
          transform_left_filter_feature_0_value_22;
      else
        transform_left_filter_feature_1_choice_102 := (not transform_left_filter_feature_0_value_16) and
          transform_left_filter_feature_0_value_22;
      end if;
      if transform_left_filter_feature_1_choice_102 then
        transform_left_filter_feature_1_choice_103 := (not transform_left_filter_feature_0_value_17) or
          transform_left_filter_feature_0_value_23;
      else
        transform_left_filter_feature_1_choice_103 := (not transform_left_filter_feature_0_value_17) and
          transform_left_filter_feature_0_value_23;
      end if;
      if transform_left_filter_feature_1_choice_103 then
        transform_left_filter_feature_1_choice_104 := (not transform_left_filter_feature_0_value_18) or
          transform_left_filter_feature_0_value_24;
      else
        transform_left_filter_feature_1_choice_104 := (not transform_left_filter_feature_0_value_18) and
          transform_left_filter_feature_0_value_24;
      end if;
      if transform_left_filter_feature_1_choice_104 then
        transform_left_filter_feature_1_choice_105 := (not ((transform_left_filter_column_3_2 / 128) = 1)) or
          ((transform_left_filter_column_2_1 / 128) = 1);
      else
        transform_left_filter_feature_1_choice_105 := (not ((transform_left_filter_column_3_2 / 128) = 1)) and
          ((transform_left_filter_column_2_1 / 128) = 1);
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_106 := not transform_left_filter_feature_0_value_37;
      else
        transform_left_filter_feature_1_choice_106 := (transform_left_filter_column_1_2 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value_13 then
        transform_left_filter_feature_1_choice_107 := ((transform_left_filter_column_3_2 mod 2) = 1) or (not
          transform_left_filter_feature_0_value_37) or (not ((transform_left_filter_column_1_2 mod 2) = 1));
      else
        transform_left_filter_feature_1_choice_107 := transform_left_filter_feature_1_choice_106;
      end if;
      if transform_left_filter_feature_1_choice_107 then
        transform_left_filter_feature_1_choice_108 := (not transform_left_filter_feature_0_value_14) and
          transform_left_filter_feature_0_value_38;
      else
        transform_left_filter_feature_1_choice_108 := (not transform_left_filter_feature_0_value_14) or
          transform_left_filter_feature_0_value_38;
      end if;
      if transform_left_filter_feature_1_choice_108 then
        transform_left_filter_feature_1_choice_109 := (not transform_left_filter_feature_0_value_15) or
          transform_left_filter_feature_0_value_39;
      else
        transform_left_filter_feature_1_choice_109 := (not transform_left_filter_feature_0_value_15) and
          transform_left_filter_feature_0_value_39;
      end if;
      if transform_left_filter_feature_1_choice_109 then
        transform_left_filter_feature_1_choice_110 := (not transform_left_filter_feature_0_value_16) or
          transform_left_filter_feature_0_value_40;
      else
        transform_left_filter_feature_1_choice_110 := (not transform_left_filter_feature_0_value_16) and
          transform_left_filter_feature_0_value_40;
      end if;
      if transform_left_filter_feature_1_choice_110 then
        transform_left_filter_feature_1_choice_111 := (not transform_left_filter_feature_0_value_17) or
          transform_left_filter_feature_0_value_41;
      else
        transform_left_filter_feature_1_choice_111 := (not transform_left_filter_feature_0_value_17) and
          transform_left_filter_feature_0_value_41;
      end if;
      if transform_left_filter_feature_1_choice_111 then
        transform_left_filter_feature_1_choice_112 := (not transform_left_filter_feature_0_value_18) or
          transform_left_filter_feature_0_value_42;
      else
        transform_left_filter_feature_1_choice_112 := (not transform_left_filter_feature_0_value_18) and
          transform_left_filter_feature_0_value_42;
      end if;
      if transform_left_filter_feature_1_choice_112 then
        transform_left_filter_feature_1_choice_113 := (not ((transform_left_filter_column_3_2 / 128) = 1)) or
          ((transform_left_filter_column_1_2 / 128) = 1);
      else
        transform_left_filter_feature_1_choice_113 := (not ((transform_left_filter_column_3_2 / 128) = 1)) and
          ((transform_left_filter_column_1_2 / 128) = 1);
      end if;
      if (transform_left_filter_column_1_3 mod 2) = 1 then
        transform_left_filter_feature_1_choice_114 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_114 := not transform_left_filter_feature_0_value_13;
      end if;
      if ((transform_left_filter_column_1_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_1_choice_115 := transform_left_filter_feature_1_choice_114;
      else
        transform_left_filter_feature_1_choice_115 := ((transform_left_filter_column_1_3 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_115 then
        transform_left_filter_feature_1_choice_116 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_116 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_116 then
        transform_left_filter_feature_1_choice_117 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_117 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_117 then
        transform_left_filter_feature_1_choice_118 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_118 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_118 then
        transform_left_filter_feature_1_choice_119 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_119 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_119 then
        transform_left_filter_feature_1_choice_120 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_120 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_120 then
        transform_left_filter_feature_1_choice_121 := ((transform_left_filter_column_1_3 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_121 := ((transform_left_filter_column_1_3 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_122 := not transform_left_filter_feature_0_value_31;
      else
        transform_left_filter_feature_1_choice_122 := (transform_left_filter_column_1_1 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value_13 then
        transform_left_filter_feature_1_choice_123 := ((transform_left_filter_column_3_2 mod 2) = 1) or (not
          transform_left_filter_feature_0_value_31) or (not ((transform_left_filter_column_1_1 mod 2) = 1));
      else
        transform_left_filter_feature_1_choice_123 := transform_left_filter_feature_1_choice_122;
      end if;
      if transform_left_filter_feature_1_choice_123 then
        transform_left_filter_feature_1_choice_124 := (not transform_left_filter_feature_0_value_14) and
          transform_left_filter_feature_0_value_32;
      else
        transform_left_filter_feature_1_choice_124 := (not transform_left_filter_feature_0_value_14) or
          transform_left_filter_feature_0_value_32;
      end if;
      if transform_left_filter_feature_1_choice_124 then
        transform_left_filter_feature_1_choice_125 := (not transform_left_filter_feature_0_value_15) or
          transform_left_filter_feature_0_value_33;
      else
        transform_left_filter_feature_1_choice_125 := (not transform_left_filter_feature_0_value_15) and
          transform_left_filter_feature_0_value_33;
      end if;
      if transform_left_filter_feature_1_choice_125 then
        transform_left_filter_feature_1_choice_126 := (not transform_left_filter_feature_0_value_16) or
          transform_left_filter_feature_0_value_34;
      else
        transform_left_filter_feature_1_choice_126 := (not transform_left_filter_feature_0_value_16) and
          transform_left_filter_feature_0_value_34;
      end if;
      if transform_left_filter_feature_1_choice_126 then
        transform_left_filter_feature_1_choice_127 := (not transform_left_filter_feature_0_value_17) or
          transform_left_filter_feature_0_value_35;
      else
        transform_left_filter_feature_1_choice_127 := (not transform_left_filter_feature_0_value_17) and
          transform_left_filter_feature_0_value_35;
      end if;
      if transform_left_filter_feature_1_choice_127 then
        transform_left_filter_feature_1_choice_128 := (not transform_left_filter_feature_0_value_18) or
          transform_left_filter_feature_0_value_36;
      else
        transform_left_filter_feature_1_choice_128 := (not transform_left_filter_feature_0_value_18) and
          transform_left_filter_feature_0_value_36;
      end if;
      if transform_left_filter_feature_1_choice_128 then
        transform_left_filter_feature_1_choice_129 := (not ((transform_left_filter_column_3_2 / 128) = 1)) or
          ((transform_left_filter_column_1_1 / 128) = 1);
      else
        transform_left_filter_feature_1_choice_129 := (not ((transform_left_filter_column_3_2 / 128) = 1)) and
          ((transform_left_filter_column_1_1 / 128) = 1);
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_130 := not transform_left_filter_feature_0_value_49;
      else
        transform_left_filter_feature_1_choice_130 := (transform_left_filter_column_0_2 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value_13 then
        transform_left_filter_feature_1_choice_131 := ((transform_left_filter_column_3_2 mod 2) = 1) or (not
          transform_left_filter_feature_0_value_49) or (not ((transform_left_filter_column_0_2 mod 2) = 1));
      else
        transform_left_filter_feature_1_choice_131 := transform_left_filter_feature_1_choice_130;
      end if;
      if transform_left_filter_feature_1_choice_131 then
        transform_left_filter_feature_1_choice_132 := (not transform_left_filter_feature_0_value_14) and
          transform_left_filter_feature_0_value_50;
      else
        transform_left_filter_feature_1_choice_132 := (not transform_left_filter_feature_0_value_14) or
          transform_left_filter_feature_0_value_50;
      end if;
      if transform_left_filter_feature_1_choice_132 then
        transform_left_filter_feature_1_choice_133 := (not transform_left_filter_feature_0_value_15) or
          transform_left_filter_feature_0_value_51;
      else
        transform_left_filter_feature_1_choice_133 := (not transform_left_filter_feature_0_value_15) and
          transform_left_filter_feature_0_value_51;
      end if;
      if transform_left_filter_feature_1_choice_133 then
        transform_left_filter_feature_1_choice_134 := (not transform_left_filter_feature_0_value_16) or
          transform_left_filter_feature_0_value_52;
      else
        transform_left_filter_feature_1_choice_134 := (not transform_left_filter_feature_0_value_16) and
          transform_left_filter_feature_0_value_52;
      end if;
      if transform_left_filter_feature_1_choice_134 then
        transform_left_filter_feature_1_choice_135 := (not transform_left_filter_feature_0_value_17) or
          transform_left_filter_feature_0_value_53;
      else
        transform_left_filter_feature_1_choice_135 := (not transform_left_filter_feature_0_value_17) and
          transform_left_filter_feature_0_value_53;
      end if;
      if transform_left_filter_feature_1_choice_135 then
        transform_left_filter_feature_1_choice_136 := (not transform_left_filter_feature_0_value_18) or
          transform_left_filter_feature_0_value_54;
      else
        transform_left_filter_feature_1_choice_136 := (not transform_left_filter_feature_0_value_18) and
          transform_left_filter_feature_0_value_54;
      end if;
      if transform_left_filter_feature_1_choice_136 then
        transform_left_filter_feature_1_choice_137 := (not ((transform_left_filter_column_3_2 / 128) = 1)) or
          ((transform_left_filter_column_0_2 / 128) = 1);
      else
        transform_left_filter_feature_1_choice_137 := (not ((transform_left_filter_column_3_2 / 128) = 1)) and
          ((transform_left_filter_column_0_2 / 128) = 1);
      end if;
      if (transform_left_filter_column_0_3 mod 2) = 1 then
        transform_left_filter_feature_1_choice_138 := transform_left_filter_feature_1_any;
      else
        transform_left_filter_feature_1_choice_138 := not transform_left_filter_feature_0_value_13;
      end if;
      if ((transform_left_filter_column_0_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_1_choice_139 := transform_left_filter_feature_1_choice_138;
      else
        transform_left_filter_feature_1_choice_139 := ((transform_left_filter_column_0_3 mod 2) = 1) and
          transform_left_filter_feature_1_is_equal;
      end if;
      if transform_left_filter_feature_1_choice_139 then
        transform_left_filter_feature_1_choice_140 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_14;
      else
        transform_left_filter_feature_1_choice_140 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_14;
      end if;
      if transform_left_filter_feature_1_choice_140 then
        transform_left_filter_feature_1_choice_141 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_15;
      else
        transform_left_filter_feature_1_choice_141 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_15;
      end if;
      if transform_left_filter_feature_1_choice_141 then
        transform_left_filter_feature_1_choice_142 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_16;
      else
        transform_left_filter_feature_1_choice_142 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_16;
      end if;
      if transform_left_filter_feature_1_choice_142 then
        transform_left_filter_feature_1_choice_143 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_17;
      else
        transform_left_filter_feature_1_choice_143 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_17;
      end if;
      if transform_left_filter_feature_1_choice_143 then
        transform_left_filter_feature_1_choice_144 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_18;
      else
        transform_left_filter_feature_1_choice_144 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_18;
      end if;
      if transform_left_filter_feature_1_choice_144 then
        transform_left_filter_feature_1_choice_145 := ((transform_left_filter_column_0_3 / 128) = 1) and (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      else
        transform_left_filter_feature_1_choice_145 := ((transform_left_filter_column_0_3 / 128) = 1) or (not
          ((transform_left_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_146 := not transform_left_filter_feature_0_value_43;
      else
        transform_left_filter_feature_1_choice_146 := (transform_left_filter_column_0_1 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value_13 then
        transform_left_filter_feature_1_choice_147 := ((transform_left_filter_column_3_2 mod 2) = 1) or (not
          transform_left_filter_feature_0_value_43) or (not ((transform_left_filter_column_0_1 mod 2) = 1));
      else
        transform_left_filter_feature_1_choice_147 := transform_left_filter_feature_1_choice_146;
      end if;
      if transform_left_filter_feature_1_choice_147 then
        transform_left_filter_feature_1_choice_148 := (not transform_left_filter_feature_0_value_14) and
          transform_left_filter_feature_0_value_44;
      else
        transform_left_filter_feature_1_choice_148 := (not transform_left_filter_feature_0_value_14) or
          transform_left_filter_feature_0_value_44;
      end if;
      if transform_left_filter_feature_1_choice_148 then
        transform_left_filter_feature_1_choice_149 := (not transform_left_filter_feature_0_value_15) or
          transform_left_filter_feature_0_value_45;
      else
        transform_left_filter_feature_1_choice_149 := (not transform_left_filter_feature_0_value_15) and
          transform_left_filter_feature_0_value_45;
      end if;
      if transform_left_filter_feature_1_choice_149 then
        transform_left_filter_feature_1_choice_150 := (not transform_left_filter_feature_0_value_16) or
          transform_left_filter_feature_0_value_46;
      else
        transform_left_filter_feature_1_choice_150 := (not transform_left_filter_feature_0_value_16) and
          transform_left_filter_feature_0_value_46;
      end if;
      if transform_left_filter_feature_1_choice_150 then
        transform_left_filter_feature_1_choice_151 := (not transform_left_filter_feature_0_value_17) or
          transform_left_filter_feature_0_value_47;
      else
        transform_left_filter_feature_1_choice_151 := (not transform_left_filter_feature_0_value_17) and
          transform_left_filter_feature_0_value_47;
      end if;
      if transform_left_filter_feature_1_choice_151 then
        transform_left_filter_feature_1_choice_152 := (not transform_left_filter_feature_0_value_18) or
          transform_left_filter_feature_0_value_48;
      else
        transform_left_filter_feature_1_choice_152 := (not transform_left_filter_feature_0_value_18) and
          transform_left_filter_feature_0_value_48;
      end if;
      if transform_left_filter_feature_1_choice_152 then
        transform_left_filter_feature_1_choice_153 := (not ((transform_left_filter_column_3_2 / 128) = 1)) or
          ((transform_left_filter_column_0_1 / 128) = 1);
      else
        transform_left_filter_feature_1_choice_153 := (not ((transform_left_filter_column_3_2 / 128) = 1)) and
          ((transform_left_filter_column_0_1 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_left_filter_feature_1_choice_154 := (as_number(transform_left_filter_feature_1_choice_137) * 2) +
          (as_number(transform_left_filter_feature_1_choice_145) * 4) +
          as_number(transform_left_filter_feature_1_choice_153);
      else
        transform_left_filter_feature_1_choice_154 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_left_filter_feature_1_choice_155 := (as_number(transform_left_filter_feature_1_choice_113) * 16) +
          (as_number(transform_left_filter_feature_1_choice_121) * 32) +
          (as_number(transform_left_filter_feature_1_choice_129) * 8) + transform_left_filter_feature_1_choice_154;
      else
        transform_left_filter_feature_1_choice_155 := transform_left_filter_feature_1_choice_154;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_left_filter_feature_1_choice_156 := (as_number(transform_left_filter_feature_1_choice_89) * 128) +
          (as_number(transform_left_filter_feature_1_choice_97) * 256) +
          (as_number(transform_left_filter_feature_1_choice_105) * 64) + transform_left_filter_feature_1_choice_155;
      else
        transform_left_filter_feature_1_choice_156 := transform_left_filter_feature_1_choice_155;
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_1_choice_157 := not transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_1_choice_157 := transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_value_13 then
        transform_left_filter_feature_1_choice_158 := ((transform_left_filter_column_3_2 mod 2) = 1) or (not
          transform_left_filter_feature_0_value) or (not ((transform_left_filter_column_3_1 mod 2) = 1));
      else
        transform_left_filter_feature_1_choice_158 := transform_left_filter_feature_1_choice_157;
      end if;
      if transform_left_filter_feature_1_choice_158 then
        transform_left_filter_feature_1_choice_159 := transform_left_filter_feature_0_all;
      else
        transform_left_filter_feature_1_choice_159 := transform_left_filter_feature_0_any_2;
      end if;
      if transform_left_filter_feature_1_choice_159 then
        transform_left_filter_feature_1_choice_160 := transform_left_filter_feature_0_any_3;
      else
        transform_left_filter_feature_1_choice_160 := transform_left_filter_feature_0_all_2;
      end if;
      if transform_left_filter_feature_1_choice_160 then
        transform_left_filter_feature_1_choice_161 := transform_left_filter_feature_0_any_4;
      else
        transform_left_filter_feature_1_choice_161 := transform_left_filter_feature_0_all_3;
      end if;
      if transform_left_filter_feature_1_choice_161 then
        transform_left_filter_feature_1_choice_162 := transform_left_filter_feature_0_any_5;
      else
        transform_left_filter_feature_1_choice_162 := transform_left_filter_feature_0_all_4;
      end if;
      if transform_left_filter_feature_1_choice_162 then
        transform_left_filter_feature_1_choice_163 := transform_left_filter_feature_0_any_6;
      else
        transform_left_filter_feature_1_choice_163 := transform_left_filter_feature_0_all_5;
      end if;
      if transform_left_filter_feature_1_choice_163 then
        transform_left_filter_feature_1_choice_164 := (not ((transform_left_filter_column_3_2 / 128) = 1)) or
          ((transform_left_filter_column_3_1 / 128) = 1);
      else
        transform_left_filter_feature_1_choice_164 := (not ((transform_left_filter_column_3_2 / 128) = 1)) and
          ((transform_left_filter_column_3_1 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_left_filter_feature_1_choice_165 := transform_left_filter_feature_1_choice_156 +
          (as_number(transform_left_filter_feature_1_choice_164) * 512);
      else
        transform_left_filter_feature_1_choice_165 := transform_left_filter_feature_1_choice_156;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_1_choice_166 := (as_number(transform_left_filter_feature_1_choice_56) * 2048) +
          (as_number(transform_left_filter_feature_1_choice_64) * 4096) +
          (as_number(transform_left_filter_feature_1_choice_72) * 8192) +
          (as_number(transform_left_filter_feature_1_choice_81) * 1024) + transform_left_filter_feature_1_choice_165;
      else
        transform_left_filter_feature_1_choice_166 := (as_number(transform_left_filter_feature_1_choice_81) * 1024) +
          transform_left_filter_feature_1_choice_165;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_left_filter_feature_1_choice_167 := (as_number(transform_left_filter_feature_1_choice_32) * 16384) +
          (as_number(transform_left_filter_feature_1_choice_40) * 32768) +
          (as_number(transform_left_filter_feature_1_choice_48) * 65536) + transform_left_filter_feature_1_choice_166;
      else
        transform_left_filter_feature_1_choice_167 := transform_left_filter_feature_1_choice_166;
      end if;
      transform_right_filter_feature_0_value := ((transform_right_filter_column_3_1 / 2) mod 2) = 1;
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        ((transform_right_filter_column_3_1 mod 2) = 1));
      if (transform_right_filter_column_6_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_3_1 mod 4) = 0;
      if ((transform_right_filter_column_6_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choice_2 := ((transform_right_filter_column_6_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_2 := ((transform_right_filter_column_3_1 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_2 then
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_3 := ((transform_right_filter_column_3_1 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_3 then
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_4 := ((transform_right_filter_column_3_1 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_4 then
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_5 := ((transform_right_filter_column_3_1 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_5 then
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_6 := ((transform_right_filter_column_3_1 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_6 then
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_7 then
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_6_0 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_6_0 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_7 := ((transform_right_filter_column_6_1 / 2) mod 2) = 1;
      if (transform_right_filter_column_6_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_9 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_9 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_7 then
        transform_right_filter_feature_0_choice_10 := transform_right_filter_feature_0_choice_9;
      else
        transform_right_filter_feature_0_choice_10 := ((transform_right_filter_column_6_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_10 then
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_11 then
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_12 then
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_13 then
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_14 then
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_15 then
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_6_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_6_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_8 := ((transform_right_filter_column_6_2 / 2) mod 2) = 1;
      if (transform_right_filter_column_6_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_17 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_17 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_8 then
        transform_right_filter_feature_0_choice_18 := transform_right_filter_feature_0_choice_17;
      else
        transform_right_filter_feature_0_choice_18 := ((transform_right_filter_column_6_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_18 then
        transform_right_filter_feature_0_choice_19 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_19 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_19 then
        transform_right_filter_feature_0_choice_20 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_20 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_20 then
        transform_right_filter_feature_0_choice_21 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_21 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_21 then
        transform_right_filter_feature_0_choice_22 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_22 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_22 then
        transform_right_filter_feature_0_choice_23 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_23 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_23 then
        transform_right_filter_feature_0_choice_24 := ((transform_right_filter_column_6_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_24 := ((transform_right_filter_column_6_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_25 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_25 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_26 := transform_right_filter_feature_0_choice_25;
      else
        transform_right_filter_feature_0_choice_26 := ((transform_right_filter_column_5_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_26 then
        transform_right_filter_feature_0_choice_27 := (not (((transform_right_filter_column_5_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_27 := (not (((transform_right_filter_column_5_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_27 then
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_5_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_5_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_28 then
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_5_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_5_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_29 then
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_5_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_5_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_30 then
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_5_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_5_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_31 then
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_5_0 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_5_0 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_9 := ((transform_right_filter_column_5_1 / 2) mod 2) = 1;
      if (transform_right_filter_column_5_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_33 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_33 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_9 then
        transform_right_filter_feature_0_choice_34 := transform_right_filter_feature_0_choice_33;
      else
        transform_right_filter_feature_0_choice_34 := ((transform_right_filter_column_5_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_34 then
        transform_right_filter_feature_0_choice_35 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_35 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_35 then
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_36 then
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_37 then
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_38 then
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_39 then
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_5_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_5_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_10 := ((transform_right_filter_column_5_2 / 2) mod 2) = 1;
      if (transform_right_filter_column_5_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_41 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_41 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_10 then
        transform_right_filter_feature_0_choice_42 := transform_right_filter_feature_0_choice_41;
      else
        transform_right_filter_feature_0_choice_42 := ((transform_right_filter_column_5_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_42 then
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_43 then
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_44 then
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_45 then
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_46 then
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_47 then
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_5_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_5_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_49 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_49 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_50 := transform_right_filter_feature_0_choice_49;
      else
        transform_right_filter_feature_0_choice_50 := ((transform_right_filter_column_4_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_50 then
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_51 then
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_52 then
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_53 then
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_54 then
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_55 then
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_4_0 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_4_0 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_11 := ((transform_right_filter_column_4_1 / 2) mod 2) = 1;
      if (transform_right_filter_column_4_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_57 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_57 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_11 then
        transform_right_filter_feature_0_choice_58 := transform_right_filter_feature_0_choice_57;
      else
        transform_right_filter_feature_0_choice_58 := ((transform_right_filter_column_4_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_58 then
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_59 then
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_60 then
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_61 then
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_62 then
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_63 then
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_4_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_4_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_12 := ((transform_right_filter_column_4_2 / 2) mod 2) = 1;
      if (transform_right_filter_column_4_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_65 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_65 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_12 then
        transform_right_filter_feature_0_choice_66 := transform_right_filter_feature_0_choice_65;
      else
        transform_right_filter_feature_0_choice_66 := ((transform_right_filter_column_4_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_66 then
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_67 then
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_68 then
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_69 then
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_70 then
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_71 then
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_4_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_4_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_13 := ((transform_right_filter_column_3_2 / 2) mod 2) = 1;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_73 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_73 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_13 then
        transform_right_filter_feature_0_choice_74 := transform_right_filter_feature_0_choice_73;
      else
        transform_right_filter_feature_0_choice_74 := ((transform_right_filter_column_3_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_14 := ((transform_right_filter_column_3_2 / 4) mod 2) = 1;
      transform_right_filter_feature_0_all := (not transform_right_filter_feature_0_value_14) and
        transform_right_filter_feature_0_value_2;
      transform_right_filter_feature_0_any_2 := (not transform_right_filter_feature_0_value_14) or
        transform_right_filter_feature_0_value_2;
      if transform_right_filter_feature_0_choice_74 then
        transform_right_filter_feature_0_choice_75 := transform_right_filter_feature_0_all;
      else
        transform_right_filter_feature_0_choice_75 := transform_right_filter_feature_0_any_2;
      end if;
      transform_right_filter_feature_0_value_15 := ((transform_right_filter_column_3_2 / 8) mod 2) = 1;
      transform_right_filter_feature_0_any_3 := (not transform_right_filter_feature_0_value_15) or
        transform_right_filter_feature_0_value_3;
      transform_right_filter_feature_0_all_2 := (not transform_right_filter_feature_0_value_15) and
        transform_right_filter_feature_0_value_3;
      if transform_right_filter_feature_0_choice_75 then
        transform_right_filter_feature_0_choice_76 := transform_right_filter_feature_0_any_3;
      else
        transform_right_filter_feature_0_choice_76 := transform_right_filter_feature_0_all_2;
      end if;
      transform_right_filter_feature_0_value_16 := ((transform_right_filter_column_3_2 / 16) mod 2) = 1;
      transform_right_filter_feature_0_any_4 := (not transform_right_filter_feature_0_value_16) or
        transform_right_filter_feature_0_value_4;
      transform_right_filter_feature_0_all_3 := (not transform_right_filter_feature_0_value_16) and
        transform_right_filter_feature_0_value_4;
      if transform_right_filter_feature_0_choice_76 then
        transform_right_filter_feature_0_choice_77 := transform_right_filter_feature_0_any_4;
      else
        transform_right_filter_feature_0_choice_77 := transform_right_filter_feature_0_all_3;
      end if;
      transform_right_filter_feature_0_value_17 := ((transform_right_filter_column_3_2 / 32) mod 2) = 1;
      transform_right_filter_feature_0_any_5 := (not transform_right_filter_feature_0_value_17) or
        transform_right_filter_feature_0_value_5;
      transform_right_filter_feature_0_all_4 := (not transform_right_filter_feature_0_value_17) and
        transform_right_filter_feature_0_value_5;
      if transform_right_filter_feature_0_choice_77 then
        transform_right_filter_feature_0_choice_78 := transform_right_filter_feature_0_any_5;
      else
        transform_right_filter_feature_0_choice_78 := transform_right_filter_feature_0_all_4;
      end if;
      transform_right_filter_feature_0_value_18 := ((transform_right_filter_column_3_2 / 64) mod 2) = 1;
      transform_right_filter_feature_0_any_6 := (not transform_right_filter_feature_0_value_18) or
        transform_right_filter_feature_0_value_6;
      transform_right_filter_feature_0_all_5 := (not transform_right_filter_feature_0_value_18) and
        transform_right_filter_feature_0_value_6;
      if transform_right_filter_feature_0_choice_78 then
        transform_right_filter_feature_0_choice_79 := transform_right_filter_feature_0_any_6;
      else
        transform_right_filter_feature_0_choice_79 := transform_right_filter_feature_0_all_5;
      end if;
      if (transform_right_filter_column_3_2 / 128) = 1 then
        transform_right_filter_feature_0_choice_80 := transform_filtering_0_column_inside_3;
      else
        transform_right_filter_feature_0_choice_80 := (not ((transform_right_filter_column_3_1 / 128) = 1)) and
          transform_filtering_0_column_inside_3;
      end if;
      if transform_right_filter_feature_0_choice_79 then
        transform_right_filter_feature_0_choice_81 := ((transform_right_filter_column_3_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1)) and transform_filtering_0_column_inside_3;
      else
        transform_right_filter_feature_0_choice_81 := transform_right_filter_feature_0_choice_80;
      end if;
      transform_right_filter_feature_0_value_19 := ((transform_right_filter_column_2_1 / 2) mod 2) = 1;
      if (transform_right_filter_column_2_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_82 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_82 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_19 then
        transform_right_filter_feature_0_choice_83 := transform_right_filter_feature_0_choice_82;
      else
        transform_right_filter_feature_0_choice_83 := ((transform_right_filter_column_2_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_20 := ((transform_right_filter_column_2_1 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_83 then
        transform_right_filter_feature_0_choice_84 := (not transform_right_filter_feature_0_value_20) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_84 := (not transform_right_filter_feature_0_value_20) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_21 := ((transform_right_filter_column_2_1 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_84 then
        transform_right_filter_feature_0_choice_85 := (not transform_right_filter_feature_0_value_21) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_85 := (not transform_right_filter_feature_0_value_21) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_22 := ((transform_right_filter_column_2_1 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_85 then
        transform_right_filter_feature_0_choice_86 := (not transform_right_filter_feature_0_value_22) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_86 := (not transform_right_filter_feature_0_value_22) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_23 := ((transform_right_filter_column_2_1 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_86 then
        transform_right_filter_feature_0_choice_87 := (not transform_right_filter_feature_0_value_23) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_87 := (not transform_right_filter_feature_0_value_23) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_24 := ((transform_right_filter_column_2_1 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_87 then
        transform_right_filter_feature_0_choice_88 := (not transform_right_filter_feature_0_value_24) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_88 := (not transform_right_filter_feature_0_value_24) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_88 then
        transform_right_filter_feature_0_choice_89 := ((transform_right_filter_column_2_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_89 := ((transform_right_filter_column_2_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_25 := ((transform_right_filter_column_2_2 / 2) mod 2) = 1;
      if (transform_right_filter_column_2_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_90 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_90 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_25 then
        transform_right_filter_feature_0_choice_91 := transform_right_filter_feature_0_choice_90;
      else
        transform_right_filter_feature_0_choice_91 := ((transform_right_filter_column_2_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_26 := ((transform_right_filter_column_2_2 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_91 then
        transform_right_filter_feature_0_choice_92 := (not transform_right_filter_feature_0_value_26) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_92 := (not transform_right_filter_feature_0_value_26) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_27 := ((transform_right_filter_column_2_2 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_92 then
        transform_right_filter_feature_0_choice_93 := (not transform_right_filter_feature_0_value_27) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_93 := (not transform_right_filter_feature_0_value_27) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_28 := ((transform_right_filter_column_2_2 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_93 then
        transform_right_filter_feature_0_choice_94 := (not transform_right_filter_feature_0_value_28) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_94 := (not transform_right_filter_feature_0_value_28) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_29 := ((transform_right_filter_column_2_2 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_94 then
        transform_right_filter_feature_0_choice_95 := (not transform_right_filter_feature_0_value_29) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_95 := (not transform_right_filter_feature_0_value_29) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_30 := ((transform_right_filter_column_2_2 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_95 then
        transform_right_filter_feature_0_choice_96 := (not transform_right_filter_feature_0_value_30) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_96 := (not transform_right_filter_feature_0_value_30) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_96 then
        transform_right_filter_feature_0_choice_97 := ((transform_right_filter_column_2_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_97 := ((transform_right_filter_column_2_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_98 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_98 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_99 := transform_right_filter_feature_0_choice_98;
      else
        transform_right_filter_feature_0_choice_99 := ((transform_right_filter_column_2_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_99 then
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_100 then
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_101 then
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_102 then
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_103 then
        transform_right_filter_feature_0_choice_104 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_104 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_104 then
        transform_right_filter_feature_0_choice_105 := ((transform_right_filter_column_2_0 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_105 := ((transform_right_filter_column_2_0 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_31 := ((transform_right_filter_column_1_1 / 2) mod 2) = 1;
      if (transform_right_filter_column_1_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_106 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_106 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_31 then
        transform_right_filter_feature_0_choice_107 := transform_right_filter_feature_0_choice_106;
      else
        transform_right_filter_feature_0_choice_107 := ((transform_right_filter_column_1_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_32 := ((transform_right_filter_column_1_1 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_107 then
        transform_right_filter_feature_0_choice_108 := (not transform_right_filter_feature_0_value_32) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_108 := (not transform_right_filter_feature_0_value_32) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_33 := ((transform_right_filter_column_1_1 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_108 then
        transform_right_filter_feature_0_choice_109 := (not transform_right_filter_feature_0_value_33) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_109 := (not transform_right_filter_feature_0_value_33) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_34 := ((transform_right_filter_column_1_1 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_109 then
        transform_right_filter_feature_0_choice_110 := (not transform_right_filter_feature_0_value_34) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_110 := (not transform_right_filter_feature_0_value_34) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_35 := ((transform_right_filter_column_1_1 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_110 then
        transform_right_filter_feature_0_choice_111 := (not transform_right_filter_feature_0_value_35) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_111 := (not transform_right_filter_feature_0_value_35) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_36 := ((transform_right_filter_column_1_1 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_111 then
        transform_right_filter_feature_0_choice_112 := (not transform_right_filter_feature_0_value_36) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_112 := (not transform_right_filter_feature_0_value_36) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_112 then
        transform_right_filter_feature_0_choice_113 := ((transform_right_filter_column_1_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_113 := ((transform_right_filter_column_1_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_37 := ((transform_right_filter_column_1_2 / 2) mod 2) = 1;
      if (transform_right_filter_column_1_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_114 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_114 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_37 then
        transform_right_filter_feature_0_choice_115 := transform_right_filter_feature_0_choice_114;
      else
        transform_right_filter_feature_0_choice_115 := ((transform_right_filter_column_1_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_38 := ((transform_right_filter_column_1_2 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_115 then
        transform_right_filter_feature_0_choice_116 := (not transform_right_filter_feature_0_value_38) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_116 := (not transform_right_filter_feature_0_value_38) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_39 := ((transform_right_filter_column_1_2 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_116 then
        transform_right_filter_feature_0_choice_117 := (not transform_right_filter_feature_0_value_39) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_117 := (not transform_right_filter_feature_0_value_39) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_40 := ((transform_right_filter_column_1_2 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_117 then
        transform_right_filter_feature_0_choice_118 := (not transform_right_filter_feature_0_value_40) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_118 := (not transform_right_filter_feature_0_value_40) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_41 := ((transform_right_filter_column_1_2 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_118 then
        transform_right_filter_feature_0_choice_119 := (not transform_right_filter_feature_0_value_41) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_119 := (not transform_right_filter_feature_0_value_41) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_42 := ((transform_right_filter_column_1_2 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_119 then
        transform_right_filter_feature_0_choice_120 := (not transform_right_filter_feature_0_value_42) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_120 := (not transform_right_filter_feature_0_value_42) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_120 then
        transform_right_filter_feature_0_choice_121 := ((transform_right_filter_column_1_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_121 := ((transform_right_filter_column_1_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_122 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_122 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_123 := transform_right_filter_feature_0_choice_122;
      else
        transform_right_filter_feature_0_choice_123 := ((transform_right_filter_column_1_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_123 then
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_124 then
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_125 then
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_126 then
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_127 then
        transform_right_filter_feature_0_choice_128 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_128 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_128 then
        transform_right_filter_feature_0_choice_129 := ((transform_right_filter_column_1_0 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_129 := ((transform_right_filter_column_1_0 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_43 := ((transform_right_filter_column_0_1 / 2) mod 2) = 1;
      if (transform_right_filter_column_0_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_130 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_130 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_43 then
        transform_right_filter_feature_0_choice_131 := transform_right_filter_feature_0_choice_130;
      else
        transform_right_filter_feature_0_choice_131 := ((transform_right_filter_column_0_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_44 := ((transform_right_filter_column_0_1 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_131 then
        transform_right_filter_feature_0_choice_132 := (not transform_right_filter_feature_0_value_44) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_132 := (not transform_right_filter_feature_0_value_44) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_45 := ((transform_right_filter_column_0_1 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_132 then
        transform_right_filter_feature_0_choice_133 := (not transform_right_filter_feature_0_value_45) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_133 := (not transform_right_filter_feature_0_value_45) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_46 := ((transform_right_filter_column_0_1 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_133 then
        transform_right_filter_feature_0_choice_134 := (not transform_right_filter_feature_0_value_46) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_134 := (not transform_right_filter_feature_0_value_46) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_47 := ((transform_right_filter_column_0_1 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_134 then
        transform_right_filter_feature_0_choice_135 := (not transform_right_filter_feature_0_value_47) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_135 := (not transform_right_filter_feature_0_value_47) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_48 := ((transform_right_filter_column_0_1 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_135 then
        transform_right_filter_feature_0_choice_136 := (not transform_right_filter_feature_0_value_48) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_136 := (not transform_right_filter_feature_0_value_48) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_136 then
        transform_right_filter_feature_0_choice_137 := ((transform_right_filter_column_0_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_137 := ((transform_right_filter_column_0_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      transform_right_filter_feature_0_value_49 := ((transform_right_filter_column_0_2 / 2) mod 2) = 1;
      if (transform_right_filter_column_0_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_138 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_138 := not transform_right_filter_feature_0_value;
      end if;
      if transform_right_filter_feature_0_value_49 then
        transform_right_filter_feature_0_choice_139 := transform_right_filter_feature_0_choice_138;
      else
        transform_right_filter_feature_0_choice_139 := ((transform_right_filter_column_0_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_50 := ((transform_right_filter_column_0_2 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_139 then
        transform_right_filter_feature_0_choice_140 := (not transform_right_filter_feature_0_value_50) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_140 := (not transform_right_filter_feature_0_value_50) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_51 := ((transform_right_filter_column_0_2 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_140 then
        transform_right_filter_feature_0_choice_141 := (not transform_right_filter_feature_0_value_51) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_141 := (not transform_right_filter_feature_0_value_51) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_52 := ((transform_right_filter_column_0_2 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_141 then
        transform_right_filter_feature_0_choice_142 := (not transform_right_filter_feature_0_value_52) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_142 := (not transform_right_filter_feature_0_value_52) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_53 := ((transform_right_filter_column_0_2 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_142 then
        transform_right_filter_feature_0_choice_143 := (not transform_right_filter_feature_0_value_53) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_143 := (not transform_right_filter_feature_0_value_53) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_54 := ((transform_right_filter_column_0_2 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_143 then
        transform_right_filter_feature_0_choice_144 := (not transform_right_filter_feature_0_value_54) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_144 := (not transform_right_filter_feature_0_value_54) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_144 then
        transform_right_filter_feature_0_choice_145 := ((transform_right_filter_column_0_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_145 := ((transform_right_filter_column_0_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_146 := not (((transform_right_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_right_filter_feature_0_choice_146 := (transform_right_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value then
        transform_right_filter_feature_0_choice_147 := ((transform_right_filter_column_3_1 mod 2) = 1) or (not
          (((transform_right_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_right_filter_column_0_0 mod 2) =
          1));
      else
        transform_right_filter_feature_0_choice_147 := transform_right_filter_feature_0_choice_146;
      end if;
      transform_right_filter_feature_0_value_55 := ((transform_right_filter_column_0_0 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_147 then
        transform_right_filter_feature_0_choice_148 := (not transform_right_filter_feature_0_value_2) and
          transform_right_filter_feature_0_value_55;
      else
        transform_right_filter_feature_0_choice_148 := (not transform_right_filter_feature_0_value_2) or
          transform_right_filter_feature_0_value_55;
      end if;
      transform_right_filter_feature_0_value_56 := ((transform_right_filter_column_0_0 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_148 then
        transform_right_filter_feature_0_choice_149 := (not transform_right_filter_feature_0_value_3) or
          transform_right_filter_feature_0_value_56;
      else
        transform_right_filter_feature_0_choice_149 := (not transform_right_filter_feature_0_value_3) and
          transform_right_filter_feature_0_value_56;
      end if;
      transform_right_filter_feature_0_value_57 := ((transform_right_filter_column_0_0 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_149 then
        transform_right_filter_feature_0_choice_150 := (not transform_right_filter_feature_0_value_4) or
          transform_right_filter_feature_0_value_57;
      else
        transform_right_filter_feature_0_choice_150 := (not transform_right_filter_feature_0_value_4) and
          transform_right_filter_feature_0_value_57;
      end if;
      transform_right_filter_feature_0_value_58 := ((transform_right_filter_column_0_0 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_150 then
        transform_right_filter_feature_0_choice_151 := (not transform_right_filter_feature_0_value_5) or
          transform_right_filter_feature_0_value_58;
      else
        transform_right_filter_feature_0_choice_151 := (not transform_right_filter_feature_0_value_5) and
          transform_right_filter_feature_0_value_58;
      end if;
      transform_right_filter_feature_0_value_59 := ((transform_right_filter_column_0_0 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_151 then
        transform_right_filter_feature_0_choice_152 := (not transform_right_filter_feature_0_value_6) or
          transform_right_filter_feature_0_value_59;
      else
        transform_right_filter_feature_0_choice_152 := (not transform_right_filter_feature_0_value_6) and
          transform_right_filter_feature_0_value_59;
      end if;
      if transform_right_filter_feature_0_choice_152 then
        transform_right_filter_feature_0_choice_153 := (not ((transform_right_filter_column_3_1 / 128) = 1)) or
          ((transform_right_filter_column_0_0 / 128) = 1);
      else
        transform_right_filter_feature_0_choice_153 := (not ((transform_right_filter_column_3_1 / 128) = 1)) and
          ((transform_right_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_right_filter_feature_0_choice_154 := (as_number(transform_right_filter_feature_0_choice_137) * 2) +
          (as_number(transform_right_filter_feature_0_choice_145) * 4) +
          as_number(transform_right_filter_feature_0_choice_153);
      else
        transform_right_filter_feature_0_choice_154 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_right_filter_feature_0_choice_155 := (as_number(transform_right_filter_feature_0_choice_113) * 16) +
          (as_number(transform_right_filter_feature_0_choice_121) * 32) +
          (as_number(transform_right_filter_feature_0_choice_129) * 8) + transform_right_filter_feature_0_choice_154;
      else
        transform_right_filter_feature_0_choice_155 := transform_right_filter_feature_0_choice_154;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_right_filter_feature_0_choice_156 := (as_number(transform_right_filter_feature_0_choice_89) * 128) +
          (as_number(transform_right_filter_feature_0_choice_97) * 256) +
          (as_number(transform_right_filter_feature_0_choice_105) * 64) + transform_right_filter_feature_0_choice_155;
      else
        transform_right_filter_feature_0_choice_156 := transform_right_filter_feature_0_choice_155;
      end if;
      if (transform_right_filter_column_3_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_157 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_157 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_158 := transform_right_filter_feature_0_choice_157;
      else
        transform_right_filter_feature_0_choice_158 := ((transform_right_filter_column_3_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_158 then
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_159 then
        transform_right_filter_feature_0_choice_160 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_160 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_160 then
        transform_right_filter_feature_0_choice_161 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_161 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_161 then
        transform_right_filter_feature_0_choice_162 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_162 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_162 then
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_163 then
        transform_right_filter_feature_0_choice_164 := ((transform_right_filter_column_3_0 / 128) = 1) and (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_164 := ((transform_right_filter_column_3_0 / 128) = 1) or (not
          ((transform_right_filter_column_3_1 / 128) = 1));
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_right_filter_feature_0_choice_165 := transform_right_filter_feature_0_choice_156 +
          (as_number(transform_right_filter_feature_0_choice_164) * 512);
      else
        transform_right_filter_feature_0_choice_165 := transform_right_filter_feature_0_choice_156;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_0_choice_166 := (as_number(transform_right_filter_feature_0_choice_56) * 2048) +
          (as_number(transform_right_filter_feature_0_choice_64) * 4096) +
          (as_number(transform_right_filter_feature_0_choice_72) * 8192) +
          (as_number(transform_right_filter_feature_0_choice_81) * 1024) + transform_right_filter_feature_0_choice_165;
      else
        transform_right_filter_feature_0_choice_166 := (as_number(transform_right_filter_feature_0_choice_81) * 1024) +
          transform_right_filter_feature_0_choice_165;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_right_filter_feature_0_choice_167 := (as_number(transform_right_filter_feature_0_choice_32) * 16384)
          + (as_number(transform_right_filter_feature_0_choice_40) * 32768) +
          (as_number(transform_right_filter_feature_0_choice_48) * 65536) + transform_right_filter_feature_0_choice_166;
      else
        transform_right_filter_feature_0_choice_167 := transform_right_filter_feature_0_choice_166;
      end if;
      transform_right_filter_feature_1_any := (not transform_right_filter_feature_0_value_13) or (not
        ((transform_right_filter_column_3_2 mod 2) = 1));
      if (transform_right_filter_column_6_1 mod 2) = 1 then
        transform_right_filter_feature_1_choice := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice := not transform_right_filter_feature_0_value_13;
      end if;
      transform_right_filter_feature_1_is_equal := (transform_right_filter_column_3_2 mod 4) = 0;
      if transform_right_filter_feature_0_value_7 then
        transform_right_filter_feature_1_choice_2 := transform_right_filter_feature_1_choice;
      else
        transform_right_filter_feature_1_choice_2 := ((transform_right_filter_column_6_1 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_2 then
        transform_right_filter_feature_1_choice_3 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_3 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_3 then
        transform_right_filter_feature_1_choice_4 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_4 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_4 then
        transform_right_filter_feature_1_choice_5 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_5 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_5 then
        transform_right_filter_feature_1_choice_6 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_6 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_6 then
        transform_right_filter_feature_1_choice_7 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_7 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_7 then
        transform_right_filter_feature_1_choice_8 := ((transform_right_filter_column_6_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_8 := ((transform_right_filter_column_6_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_9 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_9 := not transform_right_filter_feature_0_value_13;
      end if;
      if transform_right_filter_feature_0_value_8 then
        transform_right_filter_feature_1_choice_10 := transform_right_filter_feature_1_choice_9;
      else
        transform_right_filter_feature_1_choice_10 := ((transform_right_filter_column_6_2 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_10 then
        transform_right_filter_feature_1_choice_11 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_11 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_11 then
        transform_right_filter_feature_1_choice_12 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_12 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_12 then
        transform_right_filter_feature_1_choice_13 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_13 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_13 then
        transform_right_filter_feature_1_choice_14 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_14 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_14 then
        transform_right_filter_feature_1_choice_15 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_15 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_15 then
        transform_right_filter_feature_1_choice_16 := ((transform_right_filter_column_6_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_16 := ((transform_right_filter_column_6_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_3 mod 2) = 1 then
        transform_right_filter_feature_1_choice_17 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_17 := not transform_right_filter_feature_0_value_13;
      end if;
      if ((transform_right_filter_column_6_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_1_choice_18 := transform_right_filter_feature_1_choice_17;
      else
        transform_right_filter_feature_1_choice_18 := ((transform_right_filter_column_6_3 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_18 then
        transform_right_filter_feature_1_choice_19 := (not (((transform_right_filter_column_6_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_19 := (not (((transform_right_filter_column_6_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_19 then
        transform_right_filter_feature_1_choice_20 := (not (((transform_right_filter_column_6_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_20 := (not (((transform_right_filter_column_6_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_20 then
        transform_right_filter_feature_1_choice_21 := (not (((transform_right_filter_column_6_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_21 := (not (((transform_right_filter_column_6_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_21 then
        transform_right_filter_feature_1_choice_22 := (not (((transform_right_filter_column_6_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_22 := (not (((transform_right_filter_column_6_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_22 then
        transform_right_filter_feature_1_choice_23 := (not (((transform_right_filter_column_6_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_23 := (not (((transform_right_filter_column_6_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_23 then
        transform_right_filter_feature_1_choice_24 := ((transform_right_filter_column_6_3 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_24 := ((transform_right_filter_column_6_3 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_1 mod 2) = 1 then
        transform_right_filter_feature_1_choice_25 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_25 := not transform_right_filter_feature_0_value_13;
      end if;
      if transform_right_filter_feature_0_value_9 then
        transform_right_filter_feature_1_choice_26 := transform_right_filter_feature_1_choice_25;
      else
        transform_right_filter_feature_1_choice_26 := ((transform_right_filter_column_5_1 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_26 then
        transform_right_filter_feature_1_choice_27 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_27 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_27 then
        transform_right_filter_feature_1_choice_28 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_28 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_28 then
        transform_right_filter_feature_1_choice_29 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_29 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_29 then
        transform_right_filter_feature_1_choice_30 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_30 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_30 then
        transform_right_filter_feature_1_choice_31 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_31 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_31 then
        transform_right_filter_feature_1_choice_32 := ((transform_right_filter_column_5_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_32 := ((transform_right_filter_column_5_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_33 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_33 := not transform_right_filter_feature_0_value_13;
      end if;
      if transform_right_filter_feature_0_value_10 then
        transform_right_filter_feature_1_choice_34 := transform_right_filter_feature_1_choice_33;
      else
        transform_right_filter_feature_1_choice_34 := ((transform_right_filter_column_5_2 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_34 then
        transform_right_filter_feature_1_choice_35 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_35 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_35 then
        transform_right_filter_feature_1_choice_36 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_36 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_36 then
        transform_right_filter_feature_1_choice_37 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_37 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_37 then
        transform_right_filter_feature_1_choice_38 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_38 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_38 then
        transform_right_filter_feature_1_choice_39 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_39 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_39 then
        transform_right_filter_feature_1_choice_40 := ((transform_right_filter_column_5_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_40 := ((transform_right_filter_column_5_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_3 mod 2) = 1 then
        transform_right_filter_feature_1_choice_41 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_41 := not transform_right_filter_feature_0_value_13;
      end if;
      if ((transform_right_filter_column_5_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_1_choice_42 := transform_right_filter_feature_1_choice_41;
      else
        transform_right_filter_feature_1_choice_42 := ((transform_right_filter_column_5_3 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_42 then
        transform_right_filter_feature_1_choice_43 := (not (((transform_right_filter_column_5_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_43 := (not (((transform_right_filter_column_5_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_43 then
        transform_right_filter_feature_1_choice_44 := (not (((transform_right_filter_column_5_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_44 := (not (((transform_right_filter_column_5_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_44 then
        transform_right_filter_feature_1_choice_45 := (not (((transform_right_filter_column_5_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_45 := (not (((transform_right_filter_column_5_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_45 then
        transform_right_filter_feature_1_choice_46 := (not (((transform_right_filter_column_5_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_46 := (not (((transform_right_filter_column_5_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_46 then
        transform_right_filter_feature_1_choice_47 := (not (((transform_right_filter_column_5_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_47 := (not (((transform_right_filter_column_5_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_47 then
        transform_right_filter_feature_1_choice_48 := ((transform_right_filter_column_5_3 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_48 := ((transform_right_filter_column_5_3 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_1 mod 2) = 1 then
        transform_right_filter_feature_1_choice_49 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_49 := not transform_right_filter_feature_0_value_13;
      end if;
      if transform_right_filter_feature_0_value_11 then
        transform_right_filter_feature_1_choice_50 := transform_right_filter_feature_1_choice_49;
      else
        transform_right_filter_feature_1_choice_50 := ((transform_right_filter_column_4_1 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_50 then
        transform_right_filter_feature_1_choice_51 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_51 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_51 then
        transform_right_filter_feature_1_choice_52 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_52 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_52 then
        transform_right_filter_feature_1_choice_53 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_53 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_53 then
        transform_right_filter_feature_1_choice_54 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_54 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_54 then
        transform_right_filter_feature_1_choice_55 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_55 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_55 then
        transform_right_filter_feature_1_choice_56 := ((transform_right_filter_column_4_1 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_56 := ((transform_right_filter_column_4_1 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_57 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_57 := not transform_right_filter_feature_0_value_13;
      end if;
      if transform_right_filter_feature_0_value_12 then
        transform_right_filter_feature_1_choice_58 := transform_right_filter_feature_1_choice_57;
      else
        transform_right_filter_feature_1_choice_58 := ((transform_right_filter_column_4_2 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_58 then
        transform_right_filter_feature_1_choice_59 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_59 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_59 then
        transform_right_filter_feature_1_choice_60 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_60 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_60 then
        transform_right_filter_feature_1_choice_61 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_61 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_61 then
        transform_right_filter_feature_1_choice_62 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_62 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_62 then
        transform_right_filter_feature_1_choice_63 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_63 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_63 then
        transform_right_filter_feature_1_choice_64 := ((transform_right_filter_column_4_2 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_64 := ((transform_right_filter_column_4_2 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_3 mod 2) = 1 then
        transform_right_filter_feature_1_choice_65 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_65 := not transform_right_filter_feature_0_value_13;
      end if;
      if ((transform_right_filter_column_4_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_1_choice_66 := transform_right_filter_feature_1_choice_65;
      else
        transform_right_filter_feature_1_choice_66 := ((transform_right_filter_column_4_3 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_66 then
        transform_right_filter_feature_1_choice_67 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_67 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_67 then
        transform_right_filter_feature_1_choice_68 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_68 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_68 then
        transform_right_filter_feature_1_choice_69 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_69 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_69 then
        transform_right_filter_feature_1_choice_70 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_70 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_70 then
        transform_right_filter_feature_1_choice_71 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_71 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_71 then
        transform_right_filter_feature_1_choice_72 := ((transform_right_filter_column_4_3 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_72 := ((transform_right_filter_column_4_3 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_3 mod 2) = 1 then
        transform_right_filter_feature_1_choice_73 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_73 := not transform_right_filter_feature_0_value_13;
      end if;
      if ((transform_right_filter_column_3_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_1_choice_74 := transform_right_filter_feature_1_choice_73;
      else
        transform_right_filter_feature_1_choice_74 := ((transform_right_filter_column_3_3 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_74 then
        transform_right_filter_feature_1_choice_75 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_75 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_75 then
        transform_right_filter_feature_1_choice_76 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_76 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_76 then
        transform_right_filter_feature_1_choice_77 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_77 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_77 then
        transform_right_filter_feature_1_choice_78 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_78 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_78 then
        transform_right_filter_feature_1_choice_79 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_79 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if (transform_right_filter_column_3_3 / 128) = 1 then
        transform_right_filter_feature_1_choice_80 := transform_filtering_0_column_inside_3;
      else
        transform_right_filter_feature_1_choice_80 := (not ((transform_right_filter_column_3_2 / 128) = 1)) and
          transform_filtering_0_column_inside_3;
      end if;
      if transform_right_filter_feature_1_choice_79 then
        transform_right_filter_feature_1_choice_81 := ((transform_right_filter_column_3_3 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1)) and transform_filtering_0_column_inside_3;
      else
        transform_right_filter_feature_1_choice_81 := transform_right_filter_feature_1_choice_80;
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_82 := not transform_right_filter_feature_0_value_25;
      else
        transform_right_filter_feature_1_choice_82 := (transform_right_filter_column_2_2 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value_13 then
        transform_right_filter_feature_1_choice_83 := ((transform_right_filter_column_3_2 mod 2) = 1) or (not
          transform_right_filter_feature_0_value_25) or (not ((transform_right_filter_column_2_2 mod 2) = 1));
      else
        transform_right_filter_feature_1_choice_83 := transform_right_filter_feature_1_choice_82;
      end if;
      if transform_right_filter_feature_1_choice_83 then
        transform_right_filter_feature_1_choice_84 := (not transform_right_filter_feature_0_value_14) and
          transform_right_filter_feature_0_value_26;
      else
        transform_right_filter_feature_1_choice_84 := (not transform_right_filter_feature_0_value_14) or
          transform_right_filter_feature_0_value_26;
      end if;
      if transform_right_filter_feature_1_choice_84 then
        transform_right_filter_feature_1_choice_85 := (not transform_right_filter_feature_0_value_15) or
          transform_right_filter_feature_0_value_27;
      else
        transform_right_filter_feature_1_choice_85 := (not transform_right_filter_feature_0_value_15) and
          transform_right_filter_feature_0_value_27;
      end if;
      if transform_right_filter_feature_1_choice_85 then
        transform_right_filter_feature_1_choice_86 := (not transform_right_filter_feature_0_value_16) or
          transform_right_filter_feature_0_value_28;
      else
        transform_right_filter_feature_1_choice_86 := (not transform_right_filter_feature_0_value_16) and
          transform_right_filter_feature_0_value_28;
      end if;
      if transform_right_filter_feature_1_choice_86 then
        transform_right_filter_feature_1_choice_87 := (not transform_right_filter_feature_0_value_17) or
          transform_right_filter_feature_0_value_29;
      else
        transform_right_filter_feature_1_choice_87 := (not transform_right_filter_feature_0_value_17) and
          transform_right_filter_feature_0_value_29;
      end if;
      if transform_right_filter_feature_1_choice_87 then
        transform_right_filter_feature_1_choice_88 := (not transform_right_filter_feature_0_value_18) or
          transform_right_filter_feature_0_value_30;
      else
        transform_right_filter_feature_1_choice_88 := (not transform_right_filter_feature_0_value_18) and
          transform_right_filter_feature_0_value_30;
      end if;
      if transform_right_filter_feature_1_choice_88 then
        transform_right_filter_feature_1_choice_89 := (not ((transform_right_filter_column_3_2 / 128) = 1)) or
          ((transform_right_filter_column_2_2 / 128) = 1);
      else
        transform_right_filter_feature_1_choice_89 := (not ((transform_right_filter_column_3_2 / 128) = 1)) and
          ((transform_right_filter_column_2_2 / 128) = 1);
      end if;
      if (transform_right_filter_column_2_3 mod 2) = 1 then
        transform_right_filter_feature_1_choice_90 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_90 := not transform_right_filter_feature_0_value_13;
      end if;
      if ((transform_right_filter_column_2_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_1_choice_91 := transform_right_filter_feature_1_choice_90;
      else
        transform_right_filter_feature_1_choice_91 := ((transform_right_filter_column_2_3 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_91 then
        transform_right_filter_feature_1_choice_92 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_92 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_92 then
        transform_right_filter_feature_1_choice_93 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_93 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_93 then
        transform_right_filter_feature_1_choice_94 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_94 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_94 then
        transform_right_filter_feature_1_choice_95 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_95 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_95 then
        transform_right_filter_feature_1_choice_96 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_96 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_96 then
        transform_right_filter_feature_1_choice_97 := ((transform_right_filter_column_2_3 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_97 := ((transform_right_filter_column_2_3 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_98 := not transform_right_filter_feature_0_value_19;
      else
        transform_right_filter_feature_1_choice_98 := (transform_right_filter_column_2_1 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value_13 then
        transform_right_filter_feature_1_choice_99 := ((transform_right_filter_column_3_2 mod 2) = 1) or (not
          transform_right_filter_feature_0_value_19) or (not ((transform_right_filter_column_2_1 mod 2) = 1));
      else
        transform_right_filter_feature_1_choice_99 := transform_right_filter_feature_1_choice_98;
      end if;
      if transform_right_filter_feature_1_choice_99 then
        transform_right_filter_feature_1_choice_100 := (not transform_right_filter_feature_0_value_14) and
          transform_right_filter_feature_0_value_20;
      else
        transform_right_filter_feature_1_choice_100 := (not transform_right_filter_feature_0_value_14) or
          transform_right_filter_feature_0_value_20;
      end if;
      if transform_right_filter_feature_1_choice_100 then
        transform_right_filter_feature_1_choice_101 := (not transform_right_filter_feature_0_value_15) or
          transform_right_filter_feature_0_value_21;
      else
        transform_right_filter_feature_1_choice_101 := (not transform_right_filter_feature_0_value_15) and
          transform_right_filter_feature_0_value_21;
      end if;
      if transform_right_filter_feature_1_choice_101 then
        transform_right_filter_feature_1_choice_102 := (not transform_right_filter_feature_0_value_16) or
          transform_right_filter_feature_0_value_22;
      else
        transform_right_filter_feature_1_choice_102 := (not transform_right_filter_feature_0_value_16) and
          transform_right_filter_feature_0_value_22;
      end if;
      if transform_right_filter_feature_1_choice_102 then
        transform_right_filter_feature_1_choice_103 := (not transform_right_filter_feature_0_value_17) or
          transform_right_filter_feature_0_value_23;
      else
        transform_right_filter_feature_1_choice_103 := (not transform_right_filter_feature_0_value_17) and
          transform_right_filter_feature_0_value_23;
      end if;
      if transform_right_filter_feature_1_choice_103 then
        transform_right_filter_feature_1_choice_104 := (not transform_right_filter_feature_0_value_18) or
          transform_right_filter_feature_0_value_24;
      else
        transform_right_filter_feature_1_choice_104 := (not transform_right_filter_feature_0_value_18) and
          transform_right_filter_feature_0_value_24;
      end if;
      if transform_right_filter_feature_1_choice_104 then
        transform_right_filter_feature_1_choice_105 := (not ((transform_right_filter_column_3_2 / 128) = 1)) or
          ((transform_right_filter_column_2_1 / 128) = 1);
      else
        transform_right_filter_feature_1_choice_105 := (not ((transform_right_filter_column_3_2 / 128) = 1)) and
          ((transform_right_filter_column_2_1 / 128) = 1);
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_106 := not transform_right_filter_feature_0_value_37;
      else
        transform_right_filter_feature_1_choice_106 := (transform_right_filter_column_1_2 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value_13 then
        transform_right_filter_feature_1_choice_107 := ((transform_right_filter_column_3_2 mod 2) = 1) or (not
          transform_right_filter_feature_0_value_37) or (not ((transform_right_filter_column_1_2 mod 2) = 1));
      else
        transform_right_filter_feature_1_choice_107 := transform_right_filter_feature_1_choice_106;
      end if;
      if transform_right_filter_feature_1_choice_107 then
        transform_right_filter_feature_1_choice_108 := (not transform_right_filter_feature_0_value_14) and
          transform_right_filter_feature_0_value_38;
      else
        transform_right_filter_feature_1_choice_108 := (not transform_right_filter_feature_0_value_14) or
          transform_right_filter_feature_0_value_38;
      end if;
      if transform_right_filter_feature_1_choice_108 then
        transform_right_filter_feature_1_choice_109 := (not transform_right_filter_feature_0_value_15) or
          transform_right_filter_feature_0_value_39;
      else
        transform_right_filter_feature_1_choice_109 := (not transform_right_filter_feature_0_value_15) and
          transform_right_filter_feature_0_value_39;
      end if;
      if transform_right_filter_feature_1_choice_109 then
        transform_right_filter_feature_1_choice_110 := (not transform_right_filter_feature_0_value_16) or
          transform_right_filter_feature_0_value_40;
      else
        transform_right_filter_feature_1_choice_110 := (not transform_right_filter_feature_0_value_16) and
          transform_right_filter_feature_0_value_40;
      end if;
      if transform_right_filter_feature_1_choice_110 then
        transform_right_filter_feature_1_choice_111 := (not transform_right_filter_feature_0_value_17) or
          transform_right_filter_feature_0_value_41;
      else
        transform_right_filter_feature_1_choice_111 := (not transform_right_filter_feature_0_value_17) and
          transform_right_filter_feature_0_value_41;
      end if;
      if transform_right_filter_feature_1_choice_111 then
        transform_right_filter_feature_1_choice_112 := (not transform_right_filter_feature_0_value_18) or
          transform_right_filter_feature_0_value_42;
      else
        transform_right_filter_feature_1_choice_112 := (not transform_right_filter_feature_0_value_18) and
          transform_right_filter_feature_0_value_42;
      end if;
      if transform_right_filter_feature_1_choice_112 then
        transform_right_filter_feature_1_choice_113 := (not ((transform_right_filter_column_3_2 / 128) = 1)) or
          ((transform_right_filter_column_1_2 / 128) = 1);
      else
        transform_right_filter_feature_1_choice_113 := (not ((transform_right_filter_column_3_2 / 128) = 1)) and
          ((transform_right_filter_column_1_2 / 128) = 1);
      end if;
      if (transform_right_filter_column_1_3 mod 2) = 1 then
        transform_right_filter_feature_1_choice_114 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_114 := not transform_right_filter_feature_0_value_13;
      end if;
      if ((transform_right_filter_column_1_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_1_choice_115 := transform_right_filter_feature_1_choice_114;
      else
        transform_right_filter_feature_1_choice_115 := ((transform_right_filter_column_1_3 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_115 then
        transform_right_filter_feature_1_choice_116 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_116 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_116 then
        transform_right_filter_feature_1_choice_117 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_117 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_117 then
        transform_right_filter_feature_1_choice_118 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_118 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_118 then
        transform_right_filter_feature_1_choice_119 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_119 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_119 then
        transform_right_filter_feature_1_choice_120 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_120 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_120 then
        transform_right_filter_feature_1_choice_121 := ((transform_right_filter_column_1_3 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_121 := ((transform_right_filter_column_1_3 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_122 := not transform_right_filter_feature_0_value_31;
      else
        transform_right_filter_feature_1_choice_122 := (transform_right_filter_column_1_1 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value_13 then
        transform_right_filter_feature_1_choice_123 := ((transform_right_filter_column_3_2 mod 2) = 1) or (not
          transform_right_filter_feature_0_value_31) or (not ((transform_right_filter_column_1_1 mod 2) = 1));
      else
        transform_right_filter_feature_1_choice_123 := transform_right_filter_feature_1_choice_122;
      end if;
      if transform_right_filter_feature_1_choice_123 then
        transform_right_filter_feature_1_choice_124 := (not transform_right_filter_feature_0_value_14) and
          transform_right_filter_feature_0_value_32;
      else
        transform_right_filter_feature_1_choice_124 := (not transform_right_filter_feature_0_value_14) or
          transform_right_filter_feature_0_value_32;
      end if;
      if transform_right_filter_feature_1_choice_124 then
        transform_right_filter_feature_1_choice_125 := (not transform_right_filter_feature_0_value_15) or
          transform_right_filter_feature_0_value_33;
      else
        transform_right_filter_feature_1_choice_125 := (not transform_right_filter_feature_0_value_15) and
          transform_right_filter_feature_0_value_33;
      end if;
      if transform_right_filter_feature_1_choice_125 then
        transform_right_filter_feature_1_choice_126 := (not transform_right_filter_feature_0_value_16) or
          transform_right_filter_feature_0_value_34;
      else
        transform_right_filter_feature_1_choice_126 := (not transform_right_filter_feature_0_value_16) and
          transform_right_filter_feature_0_value_34;
      end if;
      if transform_right_filter_feature_1_choice_126 then
        transform_right_filter_feature_1_choice_127 := (not transform_right_filter_feature_0_value_17) or
          transform_right_filter_feature_0_value_35;
      else
        transform_right_filter_feature_1_choice_127 := (not transform_right_filter_feature_0_value_17) and
          transform_right_filter_feature_0_value_35;
      end if;
      if transform_right_filter_feature_1_choice_127 then
        transform_right_filter_feature_1_choice_128 := (not transform_right_filter_feature_0_value_18) or
          transform_right_filter_feature_0_value_36;
      else
        transform_right_filter_feature_1_choice_128 := (not transform_right_filter_feature_0_value_18) and
          transform_right_filter_feature_0_value_36;
      end if;
      if transform_right_filter_feature_1_choice_128 then
        transform_right_filter_feature_1_choice_129 := (not ((transform_right_filter_column_3_2 / 128) = 1)) or
          ((transform_right_filter_column_1_1 / 128) = 1);
      else
        transform_right_filter_feature_1_choice_129 := (not ((transform_right_filter_column_3_2 / 128) = 1)) and
          ((transform_right_filter_column_1_1 / 128) = 1);
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_130 := not transform_right_filter_feature_0_value_49;
      else
        transform_right_filter_feature_1_choice_130 := (transform_right_filter_column_0_2 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value_13 then
        transform_right_filter_feature_1_choice_131 := ((transform_right_filter_column_3_2 mod 2) = 1) or (not
          transform_right_filter_feature_0_value_49) or (not ((transform_right_filter_column_0_2 mod 2) = 1));
      else
        transform_right_filter_feature_1_choice_131 := transform_right_filter_feature_1_choice_130;
      end if;
      if transform_right_filter_feature_1_choice_131 then
        transform_right_filter_feature_1_choice_132 := (not transform_right_filter_feature_0_value_14) and
          transform_right_filter_feature_0_value_50;
      else
        transform_right_filter_feature_1_choice_132 := (not transform_right_filter_feature_0_value_14) or
          transform_right_filter_feature_0_value_50;
      end if;
      if transform_right_filter_feature_1_choice_132 then
        transform_right_filter_feature_1_choice_133 := (not transform_right_filter_feature_0_value_15) or
          transform_right_filter_feature_0_value_51;
      else
        transform_right_filter_feature_1_choice_133 := (not transform_right_filter_feature_0_value_15) and
          transform_right_filter_feature_0_value_51;
      end if;
      if transform_right_filter_feature_1_choice_133 then
        transform_right_filter_feature_1_choice_134 := (not transform_right_filter_feature_0_value_16) or
          transform_right_filter_feature_0_value_52;
      else
        transform_right_filter_feature_1_choice_134 := (not transform_right_filter_feature_0_value_16) and
          transform_right_filter_feature_0_value_52;
      end if;
      if transform_right_filter_feature_1_choice_134 then
        transform_right_filter_feature_1_choice_135 := (not transform_right_filter_feature_0_value_17) or
          transform_right_filter_feature_0_value_53;
      else
        transform_right_filter_feature_1_choice_135 := (not transform_right_filter_feature_0_value_17) and
          transform_right_filter_feature_0_value_53;
      end if;
      if transform_right_filter_feature_1_choice_135 then
        transform_right_filter_feature_1_choice_136 := (not transform_right_filter_feature_0_value_18) or
          transform_right_filter_feature_0_value_54;
      else
        transform_right_filter_feature_1_choice_136 := (not transform_right_filter_feature_0_value_18) and
          transform_right_filter_feature_0_value_54;
      end if;
      if transform_right_filter_feature_1_choice_136 then
        transform_right_filter_feature_1_choice_137 := (not ((transform_right_filter_column_3_2 / 128) = 1)) or
          ((transform_right_filter_column_0_2 / 128) = 1);
      else
        transform_right_filter_feature_1_choice_137 := (not ((transform_right_filter_column_3_2 / 128) = 1)) and
          ((transform_right_filter_column_0_2 / 128) = 1);
      end if;
      if (transform_right_filter_column_0_3 mod 2) = 1 then
        transform_right_filter_feature_1_choice_138 := transform_right_filter_feature_1_any;
      else
        transform_right_filter_feature_1_choice_138 := not transform_right_filter_feature_0_value_13;
      end if;
      if ((transform_right_filter_column_0_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_1_choice_139 := transform_right_filter_feature_1_choice_138;
      else
        transform_right_filter_feature_1_choice_139 := ((transform_right_filter_column_0_3 mod 2) = 1) and
          transform_right_filter_feature_1_is_equal;
      end if;
      if transform_right_filter_feature_1_choice_139 then
        transform_right_filter_feature_1_choice_140 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_14;
      else
        transform_right_filter_feature_1_choice_140 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_14;
      end if;
      if transform_right_filter_feature_1_choice_140 then
        transform_right_filter_feature_1_choice_141 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_15;
      else
        transform_right_filter_feature_1_choice_141 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_15;
      end if;
      if transform_right_filter_feature_1_choice_141 then
        transform_right_filter_feature_1_choice_142 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_16;
      else
        transform_right_filter_feature_1_choice_142 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_16;
      end if;
      if transform_right_filter_feature_1_choice_142 then
        transform_right_filter_feature_1_choice_143 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_17;
      else
        transform_right_filter_feature_1_choice_143 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_17;
      end if;
      if transform_right_filter_feature_1_choice_143 then
        transform_right_filter_feature_1_choice_144 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_18;
      else
        transform_right_filter_feature_1_choice_144 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_18;
      end if;
      if transform_right_filter_feature_1_choice_144 then
        transform_right_filter_feature_1_choice_145 := ((transform_right_filter_column_0_3 / 128) = 1) and (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      else
        transform_right_filter_feature_1_choice_145 := ((transform_right_filter_column_0_3 / 128) = 1) or (not
          ((transform_right_filter_column_3_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_146 := not transform_right_filter_feature_0_value_43;
      else
        transform_right_filter_feature_1_choice_146 := (transform_right_filter_column_0_1 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value_13 then
        transform_right_filter_feature_1_choice_147 := ((transform_right_filter_column_3_2 mod 2) = 1) or (not
          transform_right_filter_feature_0_value_43) or (not ((transform_right_filter_column_0_1 mod 2) = 1));
      else
        transform_right_filter_feature_1_choice_147 := transform_right_filter_feature_1_choice_146;
      end if;
      if transform_right_filter_feature_1_choice_147 then
        transform_right_filter_feature_1_choice_148 := (not transform_right_filter_feature_0_value_14) and
          transform_right_filter_feature_0_value_44;
      else
        transform_right_filter_feature_1_choice_148 := (not transform_right_filter_feature_0_value_14) or
          transform_right_filter_feature_0_value_44;
      end if;
      if transform_right_filter_feature_1_choice_148 then
        transform_right_filter_feature_1_choice_149 := (not transform_right_filter_feature_0_value_15) or
          transform_right_filter_feature_0_value_45;
      else
        transform_right_filter_feature_1_choice_149 := (not transform_right_filter_feature_0_value_15) and
          transform_right_filter_feature_0_value_45;
      end if;
      if transform_right_filter_feature_1_choice_149 then
        transform_right_filter_feature_1_choice_150 := (not transform_right_filter_feature_0_value_16) or
          transform_right_filter_feature_0_value_46;
      else
        transform_right_filter_feature_1_choice_150 := (not transform_right_filter_feature_0_value_16) and
          transform_right_filter_feature_0_value_46;
      end if;
      if transform_right_filter_feature_1_choice_150 then
        transform_right_filter_feature_1_choice_151 := (not transform_right_filter_feature_0_value_17) or
          transform_right_filter_feature_0_value_47;
      else
        transform_right_filter_feature_1_choice_151 := (not transform_right_filter_feature_0_value_17) and
          transform_right_filter_feature_0_value_47;
      end if;
      if transform_right_filter_feature_1_choice_151 then
        transform_right_filter_feature_1_choice_152 := (not transform_right_filter_feature_0_value_18) or
          transform_right_filter_feature_0_value_48;
      else
        transform_right_filter_feature_1_choice_152 := (not transform_right_filter_feature_0_value_18) and
          transform_right_filter_feature_0_value_48;
      end if;
      if transform_right_filter_feature_1_choice_152 then
        transform_right_filter_feature_1_choice_153 := (not ((transform_right_filter_column_3_2 / 128) = 1)) or
          ((transform_right_filter_column_0_1 / 128) = 1);
      else
        transform_right_filter_feature_1_choice_153 := (not ((transform_right_filter_column_3_2 / 128) = 1)) and
          ((transform_right_filter_column_0_1 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_right_filter_feature_1_choice_154 := (as_number(transform_right_filter_feature_1_choice_137) * 2) +
          (as_number(transform_right_filter_feature_1_choice_145) * 4) +
          as_number(transform_right_filter_feature_1_choice_153);
      else
        transform_right_filter_feature_1_choice_154 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_right_filter_feature_1_choice_155 := (as_number(transform_right_filter_feature_1_choice_113) * 16) +
          (as_number(transform_right_filter_feature_1_choice_121) * 32) +
          (as_number(transform_right_filter_feature_1_choice_129) * 8) + transform_right_filter_feature_1_choice_154;
      else
        transform_right_filter_feature_1_choice_155 := transform_right_filter_feature_1_choice_154;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_right_filter_feature_1_choice_156 := (as_number(transform_right_filter_feature_1_choice_89) * 128) +
          (as_number(transform_right_filter_feature_1_choice_97) * 256) +
          (as_number(transform_right_filter_feature_1_choice_105) * 64) + transform_right_filter_feature_1_choice_155;
      else
        transform_right_filter_feature_1_choice_156 := transform_right_filter_feature_1_choice_155;
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_1_choice_157 := not transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_1_choice_157 := transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_value_13 then
        transform_right_filter_feature_1_choice_158 := ((transform_right_filter_column_3_2 mod 2) = 1) or (not
          transform_right_filter_feature_0_value) or (not ((transform_right_filter_column_3_1 mod 2) = 1));
      else
        transform_right_filter_feature_1_choice_158 := transform_right_filter_feature_1_choice_157;
      end if;
      if transform_right_filter_feature_1_choice_158 then
        transform_right_filter_feature_1_choice_159 := transform_right_filter_feature_0_all;
      else
        transform_right_filter_feature_1_choice_159 := transform_right_filter_feature_0_any_2;
      end if;
      if transform_right_filter_feature_1_choice_159 then
        transform_right_filter_feature_1_choice_160 := transform_right_filter_feature_0_any_3;
      else
        transform_right_filter_feature_1_choice_160 := transform_right_filter_feature_0_all_2;
      end if;
      if transform_right_filter_feature_1_choice_160 then
        transform_right_filter_feature_1_choice_161 := transform_right_filter_feature_0_any_4;
      else
        transform_right_filter_feature_1_choice_161 := transform_right_filter_feature_0_all_3;
      end if;
      if transform_right_filter_feature_1_choice_161 then
        transform_right_filter_feature_1_choice_162 := transform_right_filter_feature_0_any_5;
      else
        transform_right_filter_feature_1_choice_162 := transform_right_filter_feature_0_all_4;
      end if;
      if transform_right_filter_feature_1_choice_162 then
        transform_right_filter_feature_1_choice_163 := transform_right_filter_feature_0_any_6;
      else
        transform_right_filter_feature_1_choice_163 := transform_right_filter_feature_0_all_5;
      end if;
      if transform_right_filter_feature_1_choice_163 then
        transform_right_filter_feature_1_choice_164 := (not ((transform_right_filter_column_3_2 / 128) = 1)) or
          ((transform_right_filter_column_3_1 / 128) = 1);
      else
        transform_right_filter_feature_1_choice_164 := (not ((transform_right_filter_column_3_2 / 128) = 1)) and
          ((transform_right_filter_column_3_1 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_right_filter_feature_1_choice_165 := transform_right_filter_feature_1_choice_156 +
          (as_number(transform_right_filter_feature_1_choice_164) * 512);
      else
        transform_right_filter_feature_1_choice_165 := transform_right_filter_feature_1_choice_156;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_1_choice_166 := (as_number(transform_right_filter_feature_1_choice_56) * 2048) +
          (as_number(transform_right_filter_feature_1_choice_64) * 4096) +
          (as_number(transform_right_filter_feature_1_choice_72) * 8192) +
          (as_number(transform_right_filter_feature_1_choice_81) * 1024) + transform_right_filter_feature_1_choice_165;
      else
        transform_right_filter_feature_1_choice_166 := (as_number(transform_right_filter_feature_1_choice_81) * 1024) +
          transform_right_filter_feature_1_choice_165;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_right_filter_feature_1_choice_167 := (as_number(transform_right_filter_feature_1_choice_32) * 16384)
          + (as_number(transform_right_filter_feature_1_choice_40) * 32768) +
          (as_number(transform_right_filter_feature_1_choice_48) * 65536) + transform_right_filter_feature_1_choice_166;
      else
        transform_right_filter_feature_1_choice_167 := transform_right_filter_feature_1_choice_166;
      end if;
      transform_left_0 <= in_left_pixel mod 256;
      transform_left_1 <= in_left_pixel / 256;
      transform_right_0 <= in_right_pixel mod 256;
      transform_right_1 <= in_right_pixel / 256;
      transform_valid <= in_valid;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_read_newest_1 <= transform_left_1;
      transform_left_rows_ready_words_0 <= to_integer(transform_left_rows_read_words_0);
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_left_rows_ready_newest_1 <= transform_left_rows_read_newest_1;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_read_newest_1 <= transform_right_1;
      transform_right_rows_ready_words_0 <= to_integer(transform_right_rows_read_words_0);
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_right_rows_ready_newest_1 <= transform_right_rows_read_newest_1;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= transform_read_row_inside_0_any;
      transform_read_row_inside_3 <= transform_read_row_inside_1_any;
      transform_read_column_inside_0 <= ((transform_counter_column mod 4) = 3) or ((transform_counter_column / 16) = 1)
        or transform_read_column_inside_0_value or transform_read_column_inside_0_value_2;
      transform_read_column_inside_2 <= ((transform_counter_column / 4) /= 0) or (not
        transform_read_column_inside_1_value) or ((transform_counter_column mod 2) = 1);
      transform_read_column_inside_3 <= true;
      transform_read_column_inside_6 <= (((not transform_read_column_inside_0_value_2) or (not
        transform_read_column_inside_1_value)) and ((transform_counter_column / 8) = 0)) /= (not
        transform_read_column_inside_1_all);
      transform_read_start_of_frame <= (transform_counter_column = 3) and (transform_counter_group = 1);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_1 <= transform_read_row_inside_1;
      transform_ready_row_inside_3 <= transform_read_row_inside_3;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_1 <= transform_read_column_inside_1;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_column_inside_3 <= transform_read_column_inside_3;
      transform_ready_column_inside_4 <= transform_read_column_inside_4;
      transform_ready_column_inside_5 <= transform_read_column_inside_5;
      transform_ready_column_inside_6 <= transform_read_column_inside_6;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column_0 <= transform_left_rows_ready_words_0 mod 256;
      transform_left_column_1 <= (transform_left_rows_ready_words_0 / 256) mod 256;
      transform_left_column_2 <= transform_left_rows_ready_words_0 / 65536;
      transform_left_column_3 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= transform_right_rows_ready_words_0 mod 256;
      transform_right_column_1 <= (transform_right_rows_ready_words_0 / 256) mod 256;
      transform_right_column_2 <= transform_right_rows_ready_words_0 / 65536;
      transform_right_column_3 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_1 <= transform_ready_row_inside_1;
      transform_columns_row_inside_3 <= transform_ready_row_inside_3;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_1 <= transform_ready_column_inside_1;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_column_inside_3 <= transform_ready_column_inside_3;
      transform_columns_column_inside_4 <= transform_ready_column_inside_4;
      transform_columns_column_inside_5 <= transform_ready_column_inside_5;
      transform_columns_column_inside_6 <= transform_ready_column_inside_6;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_1 <= transform_columns_column_inside_1;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_3 <= transform_columns_column_inside_3;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_5 <= transform_columns_column_inside_5;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      if in_start_of_frame and in_valid then
        transform_counter_group <= transform_counter_group_choice * 2;
      else
        transform_counter_group <= transform_counter_group_choice_4;
      end if;
      if (transform_counter_group mod 2) = 1 then
        transform_read_row_inside_1 <= transform_read_row_inside_1_any;
      else
        transform_read_row_inside_1 <= transform_read_row_inside_0_any;
      end if;
      if transform_read_column_inside_1_is_equal then
        transform_read_column_inside_1 <= transform_read_column_inside_1_choice;
      else
        transform_read_column_inside_1 <= not transform_read_column_inside_1_all;
      end if;
      if transform_read_column_inside_1_all then
        transform_read_column_inside_4 <= transform_read_column_inside_1_is_equal;
      else
        transform_read_column_inside_4 <= ((transform_counter_column / 16) = 1) or transform_read_column_inside_0_value
          or transform_read_column_inside_0_value_2;
      end if;
      if (not transform_read_column_inside_0_value) and ((not transform_read_column_inside_0_value_2) or
        transform_read_column_inside_1_is_equal_2) then
        transform_read_column_inside_5 <= transform_read_column_inside_1_all /= ((transform_counter_column / 16) = 1);
      else
        transform_read_column_inside_5 <= not transform_read_column_inside_1_all;
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_left_filter_feature_0 <= (as_number(transform_left_filter_feature_0_choice_8) * 131072) +
          (as_number(transform_left_filter_feature_0_choice_16) * 262144) +
          (as_number(transform_left_filter_feature_0_choice_24) * 524288) + transform_left_filter_feature_0_choice_167;
        transform_left_filter_feature_1 <= (as_number(transform_left_filter_feature_1_choice_8) * 131072) +
          (as_number(transform_left_filter_feature_1_choice_16) * 262144) +
          (as_number(transform_left_filter_feature_1_choice_24) * 524288) + transform_left_filter_feature_1_choice_167;
        transform_right_filter_feature_0 <= (as_number(transform_right_filter_feature_0_choice_8) * 131072) +
          (as_number(transform_right_filter_feature_0_choice_16) * 262144) +
          (as_number(transform_right_filter_feature_0_choice_24) * 524288) +
          transform_right_filter_feature_0_choice_167;
        transform_right_filter_feature_1 <= (as_number(transform_right_filter_feature_1_choice_8) * 131072) +
          (as_number(transform_right_filter_feature_1_choice_16) * 262144) +
          (as_number(transform_right_filter_feature_1_choice_24) * 524288) +
          transform_right_filter_feature_1_choice_167;
      else
        transform_left_filter_feature_0 <= transform_left_filter_feature_0_choice_167;
        transform_left_filter_feature_1 <= transform_left_filter_feature_1_choice_167;
        transform_right_filter_feature_0 <= transform_right_filter_feature_0_choice_167;
        transform_right_filter_feature_1 <= transform_right_filter_feature_1_choice_167;
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := transform_counter_next_frame and ((transform_counter_group mod 2) = 1);
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_is_equal then
        transform_counter_next_frame_choice_2 := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if in_valid then
        if transform_counter_group_is_equal or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 32;
        end if;
        if in_start_of_frame then
          transform_counter_next_frame <= transform_counter_group_all;
        else
          transform_counter_next_frame <= transform_counter_next_frame_choice_2;
        end if;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= (transform_left_rows_ready_words_0 / 65536) +
          (transform_left_rows_ready_newest_0 * 256) + (transform_left_rows_ready_newest_1 * 65536);
        transform_right_rows_write_words_0 <= (transform_right_rows_ready_words_0 / 65536) +
          (transform_right_rows_ready_newest_0 * 256) + (transform_right_rows_ready_newest_1 * 65536);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_columns_valid then
        transform_left_filter_column_1_0 <= transform_left_filter_column_0_0;
        transform_left_filter_column_1_1 <= transform_left_filter_column_0_1;
        transform_left_filter_column_1_2 <= transform_left_filter_column_0_2;
        transform_left_filter_column_1_3 <= transform_left_filter_column_0_3;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_left_filter_column_2_1 <= transform_left_filter_column_1_1;
        transform_left_filter_column_2_2 <= transform_left_filter_column_1_2;
        transform_left_filter_column_2_3 <= transform_left_filter_column_1_3;
        transform_left_filter_column_3_0 <= transform_left_filter_column_2_0;
        transform_left_filter_column_3_1 <= transform_left_filter_column_2_1;
        transform_left_filter_column_3_2 <= transform_left_filter_column_2_2;
        transform_left_filter_column_3_3 <= transform_left_filter_column_2_3;
        transform_left_filter_column_4_0 <= transform_left_filter_column_3_0;
        transform_left_filter_column_4_1 <= transform_left_filter_column_3_1;
        transform_left_filter_column_4_2 <= transform_left_filter_column_3_2;
        transform_left_filter_column_4_3 <= transform_left_filter_column_3_3;
        transform_left_filter_column_5_0 <= transform_left_filter_column_4_0;
        transform_left_filter_column_5_1 <= transform_left_filter_column_4_1;
        transform_left_filter_column_5_2 <= transform_left_filter_column_4_2;
        transform_left_filter_column_5_3 <= transform_left_filter_column_4_3;
        transform_left_filter_column_6_0 <= transform_left_filter_column_5_0;
        transform_left_filter_column_6_1 <= transform_left_filter_column_5_1;
        transform_left_filter_column_6_2 <= transform_left_filter_column_5_2;
        transform_left_filter_column_6_3 <= transform_left_filter_column_5_3;
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_1_1 <= transform_right_filter_column_0_1;
        transform_right_filter_column_1_2 <= transform_right_filter_column_0_2;
        transform_right_filter_column_1_3 <= transform_right_filter_column_0_3;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
        transform_right_filter_column_2_1 <= transform_right_filter_column_1_1;
        transform_right_filter_column_2_2 <= transform_right_filter_column_1_2;
        transform_right_filter_column_2_3 <= transform_right_filter_column_1_3;
        transform_right_filter_column_3_0 <= transform_right_filter_column_2_0;
        transform_right_filter_column_3_1 <= transform_right_filter_column_2_1;
        transform_right_filter_column_3_2 <= transform_right_filter_column_2_2;
        transform_right_filter_column_3_3 <= transform_right_filter_column_2_3;
        transform_right_filter_column_4_0 <= transform_right_filter_column_3_0;
        transform_right_filter_column_4_1 <= transform_right_filter_column_3_1;
        transform_right_filter_column_4_2 <= transform_right_filter_column_3_2;
        transform_right_filter_column_4_3 <= transform_right_filter_column_3_3;
        transform_right_filter_column_5_0 <= transform_right_filter_column_4_0;
        transform_right_filter_column_5_1 <= transform_right_filter_column_4_1;
        transform_right_filter_column_5_2 <= transform_right_filter_column_4_2;
        transform_right_filter_column_5_3 <= transform_right_filter_column_4_3;
        transform_right_filter_column_6_0 <= transform_right_filter_column_5_0;
        transform_right_filter_column_6_1 <= transform_right_filter_column_5_1;
        transform_right_filter_column_6_2 <= transform_right_filter_column_5_2;
        transform_right_filter_column_6_3 <= transform_right_filter_column_5_3;
        if transform_columns_row_inside_0 then
          transform_left_filter_column_0_0 <= transform_left_column_0;
          transform_right_filter_column_0_0 <= transform_right_column_0;
        else
          transform_left_filter_column_0_0 <= 0;
          transform_right_filter_column_0_0 <= 0;
        end if;
        if transform_columns_row_inside_1 then
          transform_left_filter_column_0_1 <= transform_left_column_1;
          transform_left_filter_column_0_2 <= transform_left_column_2;
          transform_right_filter_column_0_1 <= transform_right_column_1;
          transform_right_filter_column_0_2 <= transform_right_column_2;
        else
          transform_left_filter_column_0_1 <= 0;
          transform_left_filter_column_0_2 <= 0;
          transform_right_filter_column_0_1 <= 0;
          transform_right_filter_column_0_2 <= 0;
        end if;
        if transform_columns_row_inside_3 then
          transform_left_filter_column_0_3 <= transform_left_column_3;
          transform_right_filter_column_0_3 <= transform_right_column_3;
        else
          transform_left_filter_column_0_3 <= 0;
          transform_right_filter_column_0_3 <= 0;
        end if;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 31;
      raster_place_group_all := raster_place_group_is_equal and (raster_place_group = 5);
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_is_equal_2 := (raster_place_group / 2) = 3;
      if raster_place_group_is_equal_2 then
        raster_place_group_choice_2 := transform_filtering_1_valid and (not ((raster_place_group mod 2) = 1));
      else
        raster_place_group_choice_2 := transform_filtering_1_valid;
      end if;
      if raster_place_next_frame and (raster_place_group = 6) then
        raster_place_group_choice_3 := 1;
      else
        raster_place_group_choice_3 := (raster_place_group + 1) mod 8;
      end if;
      if raster_place_group_is_equal and raster_place_group_choice_2 then
        raster_place_group_choice_4 := raster_place_group_choice_3;
      else
        raster_place_group_choice_4 := raster_place_group;
      end if;
      raster_features_search_0 <= transform_left_filter_feature_0;
      raster_features_search_1 <= transform_left_filter_feature_1;
      raster_features_reference_0 <= transform_right_filter_feature_0;
      raster_features_reference_1 <= transform_right_filter_feature_1;
      raster_features_valid <= transform_filtering_1_valid;
      if transform_filtering_1_start_of_frame and transform_filtering_1_valid then
        raster_place_group <= raster_place_group_choice * 2;
      else
        raster_place_group <= raster_place_group_choice_4;
      end if;
      if raster_place_group_is_equal_2 then
        raster_place_next_frame_choice := raster_place_next_frame and ((raster_place_group mod 2) = 1);
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_is_equal then
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      end if;
      if transform_filtering_1_valid then
        if raster_place_group_is_equal or transform_filtering_1_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 32;
        end if;
        if transform_filtering_1_start_of_frame then
          raster_place_next_frame <= raster_place_group_all;
        else
          raster_place_next_frame <= raster_place_next_frame_choice_2;
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
      delay_ahead_0 <= raster_features_search_0;
      delay_ahead_1 <= raster_features_search_1;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= delay_row_inside_0_any;
      delay_row_inside_3 <= delay_row_inside_1_any;
      delay_tag_valid <= raster_features_valid;
      delay_tag_output_column <= (raster_place_group >= 1) and (raster_place_group < 7) and (raster_place_column >= 7)
        and (raster_place_column < 31);
      delay_tag_start_of_frame <= (raster_place_column = 7) and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 30;
      if (raster_place_group mod 2) = 1 then
        delay_row_inside_1 <= delay_row_inside_1_any;
      else
        delay_row_inside_1 <= delay_row_inside_0_any;
      end if;
      if (raster_place_column mod 4) = 3 then
        delay_tag_border_column <= (raster_place_column / 4) = 0;
      else
        delay_tag_border_column <= (raster_place_column / 8) = 0;
      end if;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_read_newest_1 <= delay_ahead_1;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_words_2 <= to_integer(rows_search_rows_read_words_2);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_search_rows_ready_newest_1 <= rows_search_rows_read_newest_1;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_read_newest_1 <= to_integer(delay_delayed_1);
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_words_2 <= to_integer(rows_reference_rows_read_words_2);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_reference_rows_ready_newest_1 <= rows_reference_rows_read_newest_1;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_3 <= delay_row_inside_3;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_3 <= rows_read_inside_3;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_inside_0 then
        rows_search_0 <= rows_search_rows_ready_words_0;
        rows_reference_0 <= rows_reference_rows_ready_words_0;
      else
        rows_search_0 <= 0;
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= rows_search_rows_ready_words_1;
        rows_search_2 <= rows_search_rows_ready_words_2;
        rows_reference_1 <= rows_reference_rows_ready_words_1;
        rows_reference_2 <= rows_reference_rows_ready_words_2;
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
        rows_search_rows_write_words_0 <= rows_search_rows_ready_words_2;
        rows_search_rows_write_words_1 <= rows_search_rows_ready_newest_0;
        rows_search_rows_write_words_2 <= rows_search_rows_ready_newest_1;
        rows_reference_rows_write_words_0 <= rows_reference_rows_ready_words_2;
        rows_reference_rows_write_words_1 <= rows_reference_rows_ready_newest_0;
        rows_reference_rows_write_words_2 <= rows_reference_rows_ready_newest_1;
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
      slice0cost_pixels_first_0_0_count_4_value_2 := ((slice0shift_reference_0 / 16384) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_4_value_3 := ((slice0shift_reference_0 / 8192) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_5_value := ((slice0shift_reference_0 / 32768) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_5_value_2 := ((slice0shift_reference_0 / 131072) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_5_value_3 := ((slice0shift_reference_0 / 65536) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_6_value := ((slice0shift_reference_0 / 262144) mod 2) = 1;
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
      slice0cost_pixels_first_1_0_count_4_value_2 := ((slice0shift_reference_1 / 16384) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_4_value_3 := ((slice0shift_reference_1 / 8192) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_5_value := ((slice0shift_reference_1 / 32768) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_5_value_2 := ((slice0shift_reference_1 / 131072) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_5_value_3 := ((slice0shift_reference_1 / 65536) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_6_value := ((slice0shift_reference_1 / 262144) mod 2) = 1;
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
      slice0cost_pixels_first_2_0_count_4_value_2 := ((slice0shift_reference_2 / 16384) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_4_value_3 := ((slice0shift_reference_2 / 8192) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_5_value := ((slice0shift_reference_2 / 32768) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_5_value_2 := ((slice0shift_reference_2 / 131072) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_5_value_3 := ((slice0shift_reference_2 / 65536) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_6_value := ((slice0shift_reference_2 / 262144) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_0_value := ((slice0shift_reference_3 / 4) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_0_value_2 := ((slice0shift_reference_3 / 2) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_1_value := ((slice0shift_reference_3 / 8) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_1_value_2 := ((slice0shift_reference_3 / 32) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_1_value_3 := ((slice0shift_reference_3 / 16) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_2_value := ((slice0shift_reference_3 / 256) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_2_value_2 := ((slice0shift_reference_3 / 64) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_3_value := ((slice0shift_reference_3 / 512) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_3_value_2 := ((slice0shift_reference_3 / 2048) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_3_value_3 := ((slice0shift_reference_3 / 1024) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_4_value := ((slice0shift_reference_3 / 4096) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_4_value_2 := ((slice0shift_reference_3 / 16384) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_4_value_3 := ((slice0shift_reference_3 / 8192) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_5_value := ((slice0shift_reference_3 / 32768) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_5_value_2 := ((slice0shift_reference_3 / 131072) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_5_value_3 := ((slice0shift_reference_3 / 65536) mod 2) = 1;
      slice0cost_pixels_first_3_0_count_6_value := ((slice0shift_reference_3 / 262144) mod 2) = 1;
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
      slice0cost_pixels_first_0_0_count_4 <= as_number((slice0cost_pixels_first_0_0_count_4_value /=
        (((slice0shift_search_0_0 / 4096) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_4_value_2 /=
        (((slice0shift_search_0_0 / 16384) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_4_value_3 /=
        (((slice0shift_search_0_0 / 8192) mod 2) = 1)));
      slice0cost_pixels_first_0_0_count_5 <= as_number((slice0cost_pixels_first_0_0_count_5_value /=
        (((slice0shift_search_0_0 / 32768) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_5_value_2 /=
        (((slice0shift_search_0_0 / 131072) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_5_value_3 /=
        (((slice0shift_search_0_0 / 65536) mod 2) = 1)));
      slice0cost_pixels_first_0_0_count_6 <= as_number((((slice0shift_reference_0 / 524288) = 1) /=
        ((slice0shift_search_0_0 / 524288) = 1))) + as_number((slice0cost_pixels_first_0_0_count_6_value /=
        (((slice0shift_search_0_0 / 262144) mod 2) = 1)));
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
      slice0cost_pixels_first_0_1_count_4 <= as_number(((((slice0shift_search_0_1 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_1 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_1 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_1_count_5 <= as_number(((((slice0shift_search_0_1 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_1 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_1 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_1_count_6 <= as_number((((slice0shift_search_0_1 / 524288) = 1) /=
        ((slice0shift_reference_0 / 524288) = 1))) + as_number(((((slice0shift_search_0_1 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value));
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
      slice0cost_pixels_first_0_2_count_4 <= as_number(((((slice0shift_search_0_2 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_2 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_2 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_2_count_5 <= as_number(((((slice0shift_search_0_2 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_2 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_2 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_2_count_6 <= as_number((((slice0shift_search_0_2 / 524288) = 1) /=
        ((slice0shift_reference_0 / 524288) = 1))) + as_number(((((slice0shift_search_0_2 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value));
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
      slice0cost_pixels_first_1_0_count_4 <= as_number((slice0cost_pixels_first_1_0_count_4_value /=
        (((slice0shift_search_1_0 / 4096) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_4_value_2 /=
        (((slice0shift_search_1_0 / 16384) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_4_value_3 /=
        (((slice0shift_search_1_0 / 8192) mod 2) = 1)));
      slice0cost_pixels_first_1_0_count_5 <= as_number((slice0cost_pixels_first_1_0_count_5_value /=
        (((slice0shift_search_1_0 / 32768) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_5_value_2 /=
        (((slice0shift_search_1_0 / 131072) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_5_value_3 /=
        (((slice0shift_search_1_0 / 65536) mod 2) = 1)));
      slice0cost_pixels_first_1_0_count_6 <= as_number((((slice0shift_reference_1 / 524288) = 1) /=
        ((slice0shift_search_1_0 / 524288) = 1))) + as_number((slice0cost_pixels_first_1_0_count_6_value /=
        (((slice0shift_search_1_0 / 262144) mod 2) = 1)));
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
      slice0cost_pixels_first_1_1_count_4 <= as_number(((((slice0shift_search_1_1 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_1 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_1 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_1_count_5 <= as_number(((((slice0shift_search_1_1 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_1 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_1 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_1_count_6 <= as_number((((slice0shift_search_1_1 / 524288) = 1) /=
        ((slice0shift_reference_1 / 524288) = 1))) + as_number(((((slice0shift_search_1_1 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value));
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
      slice0cost_pixels_first_1_2_count_4 <= as_number(((((slice0shift_search_1_2 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_2 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_2 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_2_count_5 <= as_number(((((slice0shift_search_1_2 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_2 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_2 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_2_count_6 <= as_number((((slice0shift_search_1_2 / 524288) = 1) /=
        ((slice0shift_reference_1 / 524288) = 1))) + as_number(((((slice0shift_search_1_2 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value));
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
      slice0cost_pixels_first_2_0_count_4 <= as_number((slice0cost_pixels_first_2_0_count_4_value /=
        (((slice0shift_search_2_0 / 4096) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_4_value_2 /=
        (((slice0shift_search_2_0 / 16384) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_4_value_3 /=
        (((slice0shift_search_2_0 / 8192) mod 2) = 1)));
      slice0cost_pixels_first_2_0_count_5 <= as_number((slice0cost_pixels_first_2_0_count_5_value /=
        (((slice0shift_search_2_0 / 32768) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_5_value_2 /=
        (((slice0shift_search_2_0 / 131072) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_5_value_3 /=
        (((slice0shift_search_2_0 / 65536) mod 2) = 1)));
      slice0cost_pixels_first_2_0_count_6 <= as_number((((slice0shift_reference_2 / 524288) = 1) /=
        ((slice0shift_search_2_0 / 524288) = 1))) + as_number((slice0cost_pixels_first_2_0_count_6_value /=
        (((slice0shift_search_2_0 / 262144) mod 2) = 1)));
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
      slice0cost_pixels_first_2_1_count_4 <= as_number(((((slice0shift_search_2_1 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value)) + as_number(((((slice0shift_search_2_1 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice0shift_search_2_1 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value_3));
      slice0cost_pixels_first_2_1_count_5 <= as_number(((((slice0shift_search_2_1 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value)) + as_number(((((slice0shift_search_2_1 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice0shift_search_2_1 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value_3));
      slice0cost_pixels_first_2_1_count_6 <= as_number((((slice0shift_search_2_1 / 524288) = 1) /=
        ((slice0shift_reference_2 / 524288) = 1))) + as_number(((((slice0shift_search_2_1 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value));
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
      slice0cost_pixels_first_2_2_count_4 <= as_number(((((slice0shift_search_2_2 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value)) + as_number(((((slice0shift_search_2_2 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice0shift_search_2_2 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value_3));
      slice0cost_pixels_first_2_2_count_5 <= as_number(((((slice0shift_search_2_2 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value)) + as_number(((((slice0shift_search_2_2 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice0shift_search_2_2 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value_3));
      slice0cost_pixels_first_2_2_count_6 <= as_number((((slice0shift_search_2_2 / 524288) = 1) /=
        ((slice0shift_reference_2 / 524288) = 1))) + as_number(((((slice0shift_search_2_2 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value));
      slice0cost_pixels_first_3_0_count_0 <= as_number((((slice0shift_search_3_0 mod 2) = 1) /=
        ((slice0shift_reference_3 mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_0_value /=
        (((slice0shift_search_3_0 / 4) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_0_value_2 /=
        (((slice0shift_search_3_0 / 2) mod 2) = 1)));
      slice0cost_pixels_first_3_0_count_1 <= as_number((slice0cost_pixels_first_3_0_count_1_value /=
        (((slice0shift_search_3_0 / 8) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_1_value_2 /=
        (((slice0shift_search_3_0 / 32) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_1_value_3 /=
        (((slice0shift_search_3_0 / 16) mod 2) = 1)));
      slice0cost_pixels_first_3_0_count_2 <= (to_integer(((to_unsigned((slice0shift_search_3_0 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_3 mod 256), 8)))) / 128) +
        as_number((slice0cost_pixels_first_3_0_count_2_value /= (((slice0shift_search_3_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_3_0_count_2_value_2 /= (((slice0shift_search_3_0 / 64) mod 2) = 1)));
      slice0cost_pixels_first_3_0_count_3 <= as_number((slice0cost_pixels_first_3_0_count_3_value /=
        (((slice0shift_search_3_0 / 512) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_3_value_2 /=
        (((slice0shift_search_3_0 / 2048) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_3_value_3 /=
        (((slice0shift_search_3_0 / 1024) mod 2) = 1)));
      slice0cost_pixels_first_3_0_count_4 <= as_number((slice0cost_pixels_first_3_0_count_4_value /=
        (((slice0shift_search_3_0 / 4096) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_4_value_2 /=
        (((slice0shift_search_3_0 / 16384) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_4_value_3 /=
        (((slice0shift_search_3_0 / 8192) mod 2) = 1)));
      slice0cost_pixels_first_3_0_count_5 <= as_number((slice0cost_pixels_first_3_0_count_5_value /=
        (((slice0shift_search_3_0 / 32768) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_5_value_2 /=
        (((slice0shift_search_3_0 / 131072) mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_count_5_value_3 /=
        (((slice0shift_search_3_0 / 65536) mod 2) = 1)));
      slice0cost_pixels_first_3_0_count_6 <= as_number((((slice0shift_reference_3 / 524288) = 1) /=
        ((slice0shift_search_3_0 / 524288) = 1))) + as_number((slice0cost_pixels_first_3_0_count_6_value /=
        (((slice0shift_search_3_0 / 262144) mod 2) = 1)));
      slice0cost_pixels_first_3_1_count_0 <= as_number((((slice0shift_search_3_1 mod 2) = 1) /=
        ((slice0shift_reference_3 mod 2) = 1))) + as_number(((((slice0shift_search_3_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_0_value)) + as_number(((((slice0shift_search_3_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_0_value_2));
      slice0cost_pixels_first_3_1_count_1 <= as_number(((((slice0shift_search_3_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_1_value)) + as_number(((((slice0shift_search_3_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_1_value_2)) + as_number(((((slice0shift_search_3_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_1_value_3));
      slice0cost_pixels_first_3_1_count_2 <= (to_integer(((to_unsigned((slice0shift_search_3_1 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_3 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_3_1 / 256) mod
        2) = 1) /= slice0cost_pixels_first_3_0_count_2_value)) + as_number(((((slice0shift_search_3_1 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_3_0_count_2_value_2));
      slice0cost_pixels_first_3_1_count_3 <= as_number(((((slice0shift_search_3_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_3_value)) + as_number(((((slice0shift_search_3_1 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_3_value_2)) + as_number(((((slice0shift_search_3_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_3_value_3));
      slice0cost_pixels_first_3_1_count_4 <= as_number(((((slice0shift_search_3_1 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_4_value)) + as_number(((((slice0shift_search_3_1 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_4_value_2)) + as_number(((((slice0shift_search_3_1 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_4_value_3));
      slice0cost_pixels_first_3_1_count_5 <= as_number(((((slice0shift_search_3_1 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_5_value)) + as_number(((((slice0shift_search_3_1 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_5_value_2)) + as_number(((((slice0shift_search_3_1 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_5_value_3));
      slice0cost_pixels_first_3_1_count_6 <= as_number((((slice0shift_search_3_1 / 524288) = 1) /=
        ((slice0shift_reference_3 / 524288) = 1))) + as_number(((((slice0shift_search_3_1 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_6_value));
      slice0cost_pixels_first_3_2_count_0 <= as_number((((slice0shift_search_3_2 mod 2) = 1) /=
        ((slice0shift_reference_3 mod 2) = 1))) + as_number(((((slice0shift_search_3_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_0_value)) + as_number(((((slice0shift_search_3_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_0_value_2));
      slice0cost_pixels_first_3_2_count_1 <= as_number(((((slice0shift_search_3_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_1_value)) + as_number(((((slice0shift_search_3_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_1_value_2)) + as_number(((((slice0shift_search_3_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_1_value_3));
      slice0cost_pixels_first_3_2_count_2 <= (to_integer(((to_unsigned((slice0shift_search_3_2 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_3 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_3_2 / 256) mod
        2) = 1) /= slice0cost_pixels_first_3_0_count_2_value)) + as_number(((((slice0shift_search_3_2 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_3_0_count_2_value_2));
      slice0cost_pixels_first_3_2_count_3 <= as_number(((((slice0shift_search_3_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_3_value)) + as_number(((((slice0shift_search_3_2 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_3_value_2)) + as_number(((((slice0shift_search_3_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_3_value_3));
      slice0cost_pixels_first_3_2_count_4 <= as_number(((((slice0shift_search_3_2 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_4_value)) + as_number(((((slice0shift_search_3_2 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_4_value_2)) + as_number(((((slice0shift_search_3_2 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_4_value_3));
      slice0cost_pixels_first_3_2_count_5 <= as_number(((((slice0shift_search_3_2 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_5_value)) + as_number(((((slice0shift_search_3_2 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_5_value_2)) + as_number(((((slice0shift_search_3_2 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_5_value_3));
      slice0cost_pixels_first_3_2_count_6 <= as_number((((slice0shift_search_3_2 / 524288) = 1) /=
        ((slice0shift_reference_3 / 524288) = 1))) + as_number(((((slice0shift_search_3_2 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_count_6_value));
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= slice0cost_pixels_first_0_0_count_6 + slice0cost_pixels_first_0_0_count_4 +
        slice0cost_pixels_first_0_0_count_3 + slice0cost_pixels_first_0_0_count_1 + slice0cost_pixels_first_0_0_count_5
        + slice0cost_pixels_first_0_0_count_0 + slice0cost_pixels_first_0_0_count_2;
      slice0cost_pixels_cost_0_1 <= slice0cost_pixels_first_0_1_count_6 + slice0cost_pixels_first_0_1_count_4 +
        slice0cost_pixels_first_0_1_count_3 + slice0cost_pixels_first_0_1_count_1 + slice0cost_pixels_first_0_1_count_5
        + slice0cost_pixels_first_0_1_count_0 + slice0cost_pixels_first_0_1_count_2;
      slice0cost_pixels_cost_0_2 <= slice0cost_pixels_first_0_2_count_6 + slice0cost_pixels_first_0_2_count_4 +
        slice0cost_pixels_first_0_2_count_3 + slice0cost_pixels_first_0_2_count_1 + slice0cost_pixels_first_0_2_count_5
        + slice0cost_pixels_first_0_2_count_0 + slice0cost_pixels_first_0_2_count_2;
      slice0cost_pixels_cost_1_0 <= slice0cost_pixels_first_1_0_count_6 + slice0cost_pixels_first_1_0_count_4 +
        slice0cost_pixels_first_1_0_count_3 + slice0cost_pixels_first_1_0_count_1 + slice0cost_pixels_first_1_0_count_5
        + slice0cost_pixels_first_1_0_count_0 + slice0cost_pixels_first_1_0_count_2;
      slice0cost_pixels_cost_1_1 <= slice0cost_pixels_first_1_1_count_6 + slice0cost_pixels_first_1_1_count_4 +
        slice0cost_pixels_first_1_1_count_3 + slice0cost_pixels_first_1_1_count_1 + slice0cost_pixels_first_1_1_count_5
        + slice0cost_pixels_first_1_1_count_0 + slice0cost_pixels_first_1_1_count_2;
      slice0cost_pixels_cost_1_2 <= slice0cost_pixels_first_1_2_count_6 + slice0cost_pixels_first_1_2_count_4 +
        slice0cost_pixels_first_1_2_count_3 + slice0cost_pixels_first_1_2_count_1 + slice0cost_pixels_first_1_2_count_5
        + slice0cost_pixels_first_1_2_count_0 + slice0cost_pixels_first_1_2_count_2;
      slice0cost_pixels_cost_2_0 <= slice0cost_pixels_first_2_0_count_6 + slice0cost_pixels_first_2_0_count_4 +
        slice0cost_pixels_first_2_0_count_3 + slice0cost_pixels_first_2_0_count_1 + slice0cost_pixels_first_2_0_count_5
        + slice0cost_pixels_first_2_0_count_0 + slice0cost_pixels_first_2_0_count_2;
      slice0cost_pixels_cost_2_1 <= slice0cost_pixels_first_2_1_count_6 + slice0cost_pixels_first_2_1_count_4 +
        slice0cost_pixels_first_2_1_count_3 + slice0cost_pixels_first_2_1_count_1 + slice0cost_pixels_first_2_1_count_5
        + slice0cost_pixels_first_2_1_count_0 + slice0cost_pixels_first_2_1_count_2;
      slice0cost_pixels_cost_2_2 <= slice0cost_pixels_first_2_2_count_6 + slice0cost_pixels_first_2_2_count_4 +
        slice0cost_pixels_first_2_2_count_3 + slice0cost_pixels_first_2_2_count_1 + slice0cost_pixels_first_2_2_count_5
        + slice0cost_pixels_first_2_2_count_0 + slice0cost_pixels_first_2_2_count_2;
      slice0cost_pixels_cost_3_0 <= slice0cost_pixels_first_3_0_count_6 + slice0cost_pixels_first_3_0_count_4 +
        slice0cost_pixels_first_3_0_count_3 + slice0cost_pixels_first_3_0_count_1 + slice0cost_pixels_first_3_0_count_5
        + slice0cost_pixels_first_3_0_count_0 + slice0cost_pixels_first_3_0_count_2;
      slice0cost_pixels_cost_3_1 <= slice0cost_pixels_first_3_1_count_6 + slice0cost_pixels_first_3_1_count_4 +
        slice0cost_pixels_first_3_1_count_3 + slice0cost_pixels_first_3_1_count_1 + slice0cost_pixels_first_3_1_count_5
        + slice0cost_pixels_first_3_1_count_0 + slice0cost_pixels_first_3_1_count_2;
      slice0cost_pixels_cost_3_2 <= slice0cost_pixels_first_3_2_count_6 + slice0cost_pixels_first_3_2_count_4 +
        slice0cost_pixels_first_3_2_count_3 + slice0cost_pixels_first_3_2_count_1 + slice0cost_pixels_first_3_2_count_5
        + slice0cost_pixels_first_3_2_count_0 + slice0cost_pixels_first_3_2_count_2;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      slice0cost_pair_0_0 <= slice0cost_pixels_cost_1_0 + slice0cost_pixels_cost_2_0;
      slice0cost_pair_0_1 <= slice0cost_pixels_cost_1_1 + slice0cost_pixels_cost_2_1;
      slice0cost_pair_0_2 <= slice0cost_pixels_cost_1_2 + slice0cost_pixels_cost_2_2;
      slice0cost_single_0_0 <= slice0cost_pixels_cost_0_0;
      slice0cost_single_0_1 <= slice0cost_pixels_cost_0_1;
      slice0cost_single_0_2 <= slice0cost_pixels_cost_0_2;
      slice0cost_single_3_0 <= slice0cost_pixels_cost_3_0;
      slice0cost_single_3_1 <= slice0cost_pixels_cost_3_1;
      slice0cost_single_3_2 <= slice0cost_pixels_cost_3_2;
      slice0cost_pair_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_pair_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
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
        slice0cost_column_0_0 <= slice0cost_pair_0_0 + slice0cost_single_0_0;
        slice0cost_column_0_1 <= slice0cost_pair_0_1 + slice0cost_single_0_1;
        slice0cost_column_0_2 <= slice0cost_pair_0_2 + slice0cost_single_0_2;
        slice0cost_column_1_0 <= slice0cost_pair_0_0 + slice0cost_single_3_0;
        slice0cost_column_1_1 <= slice0cost_pair_0_1 + slice0cost_single_3_1;
        slice0cost_column_1_2 <= slice0cost_pair_0_2 + slice0cost_single_3_2;
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
      end if;
      slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_sum_1_0 <= slice0cost_column_1_0 + slice0window_partial_1_1_0;
      slice0window_sum_1_1 <= slice0cost_column_1_1 + slice0window_partial_1_1_1;
      slice0window_sum_1_2 <= slice0cost_column_1_2 + slice0window_partial_1_1_2;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_output_column <= slice0window_centre_output_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
      -- slice0winner1
      if (slice0window_sum_0_0 mod 2) = 1 then
        slice0winner1_of_pair_0_0_choice := (not (((slice0window_sum_0_1 / 2) mod 2) = 1)) or (not
          ((slice0window_sum_0_1 mod 2) = 1));
      else
        slice0winner1_of_pair_0_0_choice := not (((slice0window_sum_0_1 / 2) mod 2) = 1);
      end if;
      if ((slice0window_sum_0_0 / 2) mod 2) = 1 then
        slice0winner1_of_pair_0_0_choice_2 := slice0winner1_of_pair_0_0_choice;
      else
        slice0winner1_of_pair_0_0_choice_2 := ((slice0window_sum_0_0 mod 2) = 1) and ((slice0window_sum_0_1 mod 4) = 0);
      end if;
      slice0winner1_of_pair_0_0_value := ((slice0window_sum_0_1 / 4) mod 2) = 1;
      if slice0winner1_of_pair_0_0_choice_2 then
        slice0winner1_of_pair_0_0_choice_3 := (not (((slice0window_sum_0_0 / 4) mod 2) = 1)) and
          slice0winner1_of_pair_0_0_value;
      else
        slice0winner1_of_pair_0_0_choice_3 := (not (((slice0window_sum_0_0 / 4) mod 2) = 1)) or
          slice0winner1_of_pair_0_0_value;
      end if;
      slice0winner1_of_pair_0_0_value_2 := ((slice0window_sum_0_1 / 8) mod 2) = 1;
      if slice0winner1_of_pair_0_0_choice_3 then
        slice0winner1_of_pair_0_0_choice_4 := (not (((slice0window_sum_0_0 / 8) mod 2) = 1)) or
          slice0winner1_of_pair_0_0_value_2;
      else
        slice0winner1_of_pair_0_0_choice_4 := (not (((slice0window_sum_0_0 / 8) mod 2) = 1)) and
          slice0winner1_of_pair_0_0_value_2;
      end if;
      slice0winner1_of_pair_0_0_value_3 := ((slice0window_sum_0_1 / 16) mod 2) = 1;
      if slice0winner1_of_pair_0_0_choice_4 then
        slice0winner1_of_pair_0_0_choice_5 := (not (((slice0window_sum_0_0 / 16) mod 2) = 1)) or
          slice0winner1_of_pair_0_0_value_3;
      else
        slice0winner1_of_pair_0_0_choice_5 := (not (((slice0window_sum_0_0 / 16) mod 2) = 1)) and
          slice0winner1_of_pair_0_0_value_3;
      end if;
      slice0winner1_of_pair_0_0_value_4 := ((slice0window_sum_0_1 / 32) mod 2) = 1;
      if slice0winner1_of_pair_0_0_choice_5 then
        slice0winner1_of_pair_0_0_choice_6 := (not (((slice0window_sum_0_0 / 32) mod 2) = 1)) or
          slice0winner1_of_pair_0_0_value_4;
      else
        slice0winner1_of_pair_0_0_choice_6 := (not (((slice0window_sum_0_0 / 32) mod 2) = 1)) and
          slice0winner1_of_pair_0_0_value_4;
      end if;
      slice0winner1_of_pair_0_0_value_5 := ((slice0window_sum_0_1 / 64) mod 2) = 1;
      if slice0winner1_of_pair_0_0_choice_6 then
        slice0winner1_of_pair_0_0_choice_7 := (not (((slice0window_sum_0_0 / 64) mod 2) = 1)) or
          slice0winner1_of_pair_0_0_value_5;
      else
        slice0winner1_of_pair_0_0_choice_7 := (not (((slice0window_sum_0_0 / 64) mod 2) = 1)) and
          slice0winner1_of_pair_0_0_value_5;
      end if;
      if slice0winner1_of_pair_0_0_choice_7 then
        slice0winner1_of_pair_0_0_choice_8 := ((slice0window_sum_0_0 / 128) = 1) and (not ((slice0window_sum_0_1 / 128)
          = 1));
      else
        slice0winner1_of_pair_0_0_choice_8 := ((slice0window_sum_0_0 / 128) = 1) or (not ((slice0window_sum_0_1 / 128)
          = 1));
      end if;
      if (slice0window_sum_1_0 mod 2) = 1 then
        slice0winner1_of_pair_1_0_choice := (not (((slice0window_sum_1_1 / 2) mod 2) = 1)) or (not
          ((slice0window_sum_1_1 mod 2) = 1));
      else
        slice0winner1_of_pair_1_0_choice := not (((slice0window_sum_1_1 / 2) mod 2) = 1);
      end if;
      if ((slice0window_sum_1_0 / 2) mod 2) = 1 then
        slice0winner1_of_pair_1_0_choice_2 := slice0winner1_of_pair_1_0_choice;
      else
        slice0winner1_of_pair_1_0_choice_2 := ((slice0window_sum_1_0 mod 2) = 1) and ((slice0window_sum_1_1 mod 4) = 0);
      end if;
      slice0winner1_of_pair_1_0_value := ((slice0window_sum_1_1 / 4) mod 2) = 1;
      if slice0winner1_of_pair_1_0_choice_2 then
        slice0winner1_of_pair_1_0_choice_3 := (not (((slice0window_sum_1_0 / 4) mod 2) = 1)) and
          slice0winner1_of_pair_1_0_value;
      else
        slice0winner1_of_pair_1_0_choice_3 := (not (((slice0window_sum_1_0 / 4) mod 2) = 1)) or
          slice0winner1_of_pair_1_0_value;
      end if;
      slice0winner1_of_pair_1_0_value_2 := ((slice0window_sum_1_1 / 8) mod 2) = 1;
      if slice0winner1_of_pair_1_0_choice_3 then
        slice0winner1_of_pair_1_0_choice_4 := (not (((slice0window_sum_1_0 / 8) mod 2) = 1)) or
          slice0winner1_of_pair_1_0_value_2;
      else
        slice0winner1_of_pair_1_0_choice_4 := (not (((slice0window_sum_1_0 / 8) mod 2) = 1)) and
          slice0winner1_of_pair_1_0_value_2;
      end if;
      slice0winner1_of_pair_1_0_value_3 := ((slice0window_sum_1_1 / 16) mod 2) = 1;
      if slice0winner1_of_pair_1_0_choice_4 then
        slice0winner1_of_pair_1_0_choice_5 := (not (((slice0window_sum_1_0 / 16) mod 2) = 1)) or
          slice0winner1_of_pair_1_0_value_3;
      else
        slice0winner1_of_pair_1_0_choice_5 := (not (((slice0window_sum_1_0 / 16) mod 2) = 1)) and
          slice0winner1_of_pair_1_0_value_3;
      end if;
      slice0winner1_of_pair_1_0_value_4 := ((slice0window_sum_1_1 / 32) mod 2) = 1;
      if slice0winner1_of_pair_1_0_choice_5 then
        slice0winner1_of_pair_1_0_choice_6 := (not (((slice0window_sum_1_0 / 32) mod 2) = 1)) or
          slice0winner1_of_pair_1_0_value_4;
      else
        slice0winner1_of_pair_1_0_choice_6 := (not (((slice0window_sum_1_0 / 32) mod 2) = 1)) and
          slice0winner1_of_pair_1_0_value_4;
      end if;
      slice0winner1_of_pair_1_0_value_5 := ((slice0window_sum_1_1 / 64) mod 2) = 1;
      if slice0winner1_of_pair_1_0_choice_6 then
        slice0winner1_of_pair_1_0_choice_7 := (not (((slice0window_sum_1_0 / 64) mod 2) = 1)) or
          slice0winner1_of_pair_1_0_value_5;
      else
        slice0winner1_of_pair_1_0_choice_7 := (not (((slice0window_sum_1_0 / 64) mod 2) = 1)) and
          slice0winner1_of_pair_1_0_value_5;
      end if;
      if slice0winner1_of_pair_1_0_choice_7 then
        slice0winner1_of_pair_1_0_choice_8 := ((slice0window_sum_1_0 / 128) = 1) and (not ((slice0window_sum_1_1 / 128)
          = 1));
      else
        slice0winner1_of_pair_1_0_choice_8 := ((slice0window_sum_1_0 / 128) = 1) or (not ((slice0window_sum_1_1 / 128)
          = 1));
      end if;
      slice0winner1_of_four_0_0_value := ((slice0winner1_of_pair_0_1 / 2) mod 2) = 1;
      slice0winner1_of_four_0_0_value_2 := ((slice0winner1_of_pair_0_0 / 2) mod 2) = 1;
      if (not ((slice0winner1_of_pair_0_2 mod 2) = 1)) and (((slice0winner1_of_pair_0_1 mod 2) = 1) or
        ((slice0winner1_of_pair_0_0 mod 2) = 1)) then
        slice0winner1_of_four_0_0_choice := (not (((slice0winner1_of_pair_0_2 / 2) mod 2) = 1)) or
          slice0winner1_of_four_0_0_value or slice0winner1_of_four_0_0_value_2;
      else
        slice0winner1_of_four_0_0_choice := (not (((slice0winner1_of_pair_0_2 / 2) mod 2) = 1)) and
          (slice0winner1_of_four_0_0_value or slice0winner1_of_four_0_0_value_2);
      end if;
      slice0winner1_of_four_0_0_value_3 := ((slice0winner1_of_pair_0_2 / 4) mod 2) = 1;
      if slice0winner1_of_four_0_0_choice then
        slice0winner1_of_four_0_0_choice_2 := slice0winner1_of_four_0_0_value_3 and (not (((slice0winner1_of_pair_0_1 /
          4) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 4) mod 2) = 1));
      else
        slice0winner1_of_four_0_0_choice_2 := slice0winner1_of_four_0_0_value_3 or ((not (((slice0winner1_of_pair_0_1 /
          4) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 4) mod 2) = 1)));
      end if;
      slice0winner1_of_four_0_0_value_4 := ((slice0winner1_of_pair_0_2 / 8) mod 2) = 1;
      if slice0winner1_of_four_0_0_choice_2 then
        slice0winner1_of_four_0_0_choice_3 := slice0winner1_of_four_0_0_value_4 or ((not (((slice0winner1_of_pair_0_1 /
          8) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 8) mod 2) = 1)));
      else
        slice0winner1_of_four_0_0_choice_3 := slice0winner1_of_four_0_0_value_4 and (not (((slice0winner1_of_pair_0_1 /
          8) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 8) mod 2) = 1));
      end if;
      slice0winner1_of_four_0_0_value_5 := ((slice0winner1_of_pair_0_2 / 16) mod 2) = 1;
      if slice0winner1_of_four_0_0_choice_3 then
        slice0winner1_of_four_0_0_choice_4 := slice0winner1_of_four_0_0_value_5 or ((not (((slice0winner1_of_pair_0_1 /
          16) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 16) mod 2) = 1)));
      else
        slice0winner1_of_four_0_0_choice_4 := slice0winner1_of_four_0_0_value_5 and (not (((slice0winner1_of_pair_0_1 /
          16) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 16) mod 2) = 1));
      end if;
      slice0winner1_of_four_0_0_value_6 := ((slice0winner1_of_pair_0_2 / 32) mod 2) = 1;
      if slice0winner1_of_four_0_0_choice_4 then
        slice0winner1_of_four_0_0_choice_5 := slice0winner1_of_four_0_0_value_6 or ((not (((slice0winner1_of_pair_0_1 /
          32) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 32) mod 2) = 1)));
      else
        slice0winner1_of_four_0_0_choice_5 := slice0winner1_of_four_0_0_value_6 and (not (((slice0winner1_of_pair_0_1 /
          32) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 32) mod 2) = 1));
      end if;
      slice0winner1_of_four_0_0_value_7 := ((slice0winner1_of_pair_0_2 / 64) mod 2) = 1;
      if slice0winner1_of_four_0_0_choice_5 then
        slice0winner1_of_four_0_0_choice_6 := slice0winner1_of_four_0_0_value_7 or ((not (((slice0winner1_of_pair_0_1 /
          64) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 64) mod 2) = 1)));
      else
        slice0winner1_of_four_0_0_choice_6 := slice0winner1_of_four_0_0_value_7 and (not (((slice0winner1_of_pair_0_1 /
          64) mod 2) = 1)) and (not (((slice0winner1_of_pair_0_0 / 64) mod 2) = 1));
      end if;
      if slice0winner1_of_four_0_0_choice_6 then
        slice0winner1_of_four_0_0_choice_7 := (not ((slice0winner1_of_pair_0_2 / 128) = 1)) and
          (((slice0winner1_of_pair_0_1 / 128) = 1) or ((slice0winner1_of_pair_0_0 / 128) = 1));
      else
        slice0winner1_of_four_0_0_choice_7 := (not ((slice0winner1_of_pair_0_2 / 128) = 1)) or
          ((slice0winner1_of_pair_0_1 / 128) = 1) or ((slice0winner1_of_pair_0_0 / 128) = 1);
      end if;
      slice0winner1_of_four_1_0_value := ((slice0winner1_of_pair_1_1 / 2) mod 2) = 1;
      slice0winner1_of_four_1_0_value_2 := ((slice0winner1_of_pair_1_0 / 2) mod 2) = 1;
      if (not ((slice0winner1_of_pair_1_2 mod 2) = 1)) and (((slice0winner1_of_pair_1_1 mod 2) = 1) or
        ((slice0winner1_of_pair_1_0 mod 2) = 1)) then
        slice0winner1_of_four_1_0_choice := (not (((slice0winner1_of_pair_1_2 / 2) mod 2) = 1)) or
          slice0winner1_of_four_1_0_value or slice0winner1_of_four_1_0_value_2;
      else
        slice0winner1_of_four_1_0_choice := (not (((slice0winner1_of_pair_1_2 / 2) mod 2) = 1)) and
          (slice0winner1_of_four_1_0_value or slice0winner1_of_four_1_0_value_2);
      end if;
      slice0winner1_of_four_1_0_value_3 := ((slice0winner1_of_pair_1_2 / 4) mod 2) = 1;
      if slice0winner1_of_four_1_0_choice then
        slice0winner1_of_four_1_0_choice_2 := slice0winner1_of_four_1_0_value_3 and (not (((slice0winner1_of_pair_1_1 /
          4) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 4) mod 2) = 1));
      else
        slice0winner1_of_four_1_0_choice_2 := slice0winner1_of_four_1_0_value_3 or ((not (((slice0winner1_of_pair_1_1 /
          4) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 4) mod 2) = 1)));
      end if;
      slice0winner1_of_four_1_0_value_4 := ((slice0winner1_of_pair_1_2 / 8) mod 2) = 1;
      if slice0winner1_of_four_1_0_choice_2 then
        slice0winner1_of_four_1_0_choice_3 := slice0winner1_of_four_1_0_value_4 or ((not (((slice0winner1_of_pair_1_1 /
          8) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 8) mod 2) = 1)));
      else
        slice0winner1_of_four_1_0_choice_3 := slice0winner1_of_four_1_0_value_4 and (not (((slice0winner1_of_pair_1_1 /
          8) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 8) mod 2) = 1));
      end if;
      slice0winner1_of_four_1_0_value_5 := ((slice0winner1_of_pair_1_2 / 16) mod 2) = 1;
      if slice0winner1_of_four_1_0_choice_3 then
        slice0winner1_of_four_1_0_choice_4 := slice0winner1_of_four_1_0_value_5 or ((not (((slice0winner1_of_pair_1_1 /
          16) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 16) mod 2) = 1)));
      else
        slice0winner1_of_four_1_0_choice_4 := slice0winner1_of_four_1_0_value_5 and (not (((slice0winner1_of_pair_1_1 /
          16) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 16) mod 2) = 1));
      end if;
      slice0winner1_of_four_1_0_value_6 := ((slice0winner1_of_pair_1_2 / 32) mod 2) = 1;
      if slice0winner1_of_four_1_0_choice_4 then
        slice0winner1_of_four_1_0_choice_5 := slice0winner1_of_four_1_0_value_6 or ((not (((slice0winner1_of_pair_1_1 /
          32) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 32) mod 2) = 1)));
      else
        slice0winner1_of_four_1_0_choice_5 := slice0winner1_of_four_1_0_value_6 and (not (((slice0winner1_of_pair_1_1 /
          32) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 32) mod 2) = 1));
      end if;
      slice0winner1_of_four_1_0_value_7 := ((slice0winner1_of_pair_1_2 / 64) mod 2) = 1;
      if slice0winner1_of_four_1_0_choice_5 then
        slice0winner1_of_four_1_0_choice_6 := slice0winner1_of_four_1_0_value_7 or ((not (((slice0winner1_of_pair_1_1 /
          64) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 64) mod 2) = 1)));
      else
        slice0winner1_of_four_1_0_choice_6 := slice0winner1_of_four_1_0_value_7 and (not (((slice0winner1_of_pair_1_1 /
          64) mod 2) = 1)) and (not (((slice0winner1_of_pair_1_0 / 64) mod 2) = 1));
      end if;
      if slice0winner1_of_four_1_0_choice_6 then
        slice0winner1_of_four_1_0_choice_7 := (not ((slice0winner1_of_pair_1_2 / 128) = 1)) and
          (((slice0winner1_of_pair_1_1 / 128) = 1) or ((slice0winner1_of_pair_1_0 / 128) = 1));
      else
        slice0winner1_of_four_1_0_choice_7 := (not ((slice0winner1_of_pair_1_2 / 128) = 1)) or
          ((slice0winner1_of_pair_1_1 / 128) = 1) or ((slice0winner1_of_pair_1_0 / 128) = 1);
      end if;
      slice0winner1_of_pair_0_2 <= slice0window_sum_0_2;
      slice0winner1_of_pair_1_2 <= slice0window_sum_1_2;
      slice0winner1_pair_index_0_0 <= slice0winner1_of_pair_0_0_choice_8;
      slice0winner1_pair_index_0_1 <= 2;
      slice0winner1_pair_index_1_0 <= slice0winner1_of_pair_1_0_choice_8;
      slice0winner1_pair_tag_valid <= slice0window_tag_valid;
      slice0winner1_four_tag_valid <= slice0winner1_pair_tag_valid;
      slice0winner1_four_tag_output_column <= slice0winner1_pair_tag_output_column;
      slice0winner1_four_tag_start_of_frame <= slice0winner1_pair_tag_start_of_frame;
      slice0winner1_four_tag_end_of_line <= slice0winner1_pair_tag_end_of_line;
      slice0winner1_best_cost_0_0 <= to_integer(((((to_unsigned(slice0winner1_of_four_0_1, 8)) or
        (to_unsigned(slice0winner1_of_four_0_2, 8)))) or (to_unsigned(slice0winner1_of_four_0_0, 8))));
      slice0winner1_best_cost_1_0 <= to_integer(((((to_unsigned(slice0winner1_of_four_1_1, 8)) or
        (to_unsigned(slice0winner1_of_four_1_2, 8)))) or (to_unsigned(slice0winner1_of_four_1_0, 8))));
      slice0winner1_best_index_0_0 <= slice0winner1_four_index_0_0;
      slice0winner1_best_index_1_0 <= slice0winner1_four_index_1_0;
      slice0winner1_tag_valid <= slice0winner1_four_tag_valid;
      slice0winner1_tag_output_column <= slice0winner1_four_tag_output_column;
      slice0winner1_tag_start_of_frame <= slice0winner1_four_tag_start_of_frame;
      slice0winner1_tag_end_of_line <= slice0winner1_four_tag_end_of_line;
      if slice0winner1_of_pair_0_0_choice_8 then
        slice0winner1_of_pair_0_0 <= 0;
        slice0winner1_of_pair_0_1 <= slice0window_sum_0_1;
      else
        slice0winner1_of_pair_0_0 <= slice0window_sum_0_0;
        slice0winner1_of_pair_0_1 <= 0;
      end if;
      if slice0winner1_of_pair_1_0_choice_8 then
        slice0winner1_of_pair_1_0 <= 0;
        slice0winner1_of_pair_1_1 <= slice0window_sum_1_1;
      else
        slice0winner1_of_pair_1_0 <= slice0window_sum_1_0;
        slice0winner1_of_pair_1_1 <= 0;
      end if;
      if slice0winner1_of_four_0_0_choice_7 then
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
      if slice0winner1_of_four_1_0_choice_7 then
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
        slice0winner1_pair_tag_output_column <= slice0window_tag_output_column;
        slice0winner1_pair_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_pair_tag_end_of_line <= slice0window_tag_end_of_line;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner1_best_cost_0_0;
      slice0_best_cost_1_0 <= slice0winner1_best_cost_1_0;
      slice0_best_index_0_0 <= slice0winner1_best_index_0_0 + 5;
      slice0_best_index_1_0 <= slice0winner1_best_index_1_0 + 5;
      slice0_best_tag_valid <= slice0winner1_tag_valid;
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
      slice1cost_pixels_first_0_0_count_4_value_2 := ((slice1shift_reference_0 / 16384) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_4_value_3 := ((slice1shift_reference_0 / 8192) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_5_value := ((slice1shift_reference_0 / 32768) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_5_value_2 := ((slice1shift_reference_0 / 131072) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_5_value_3 := ((slice1shift_reference_0 / 65536) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_6_value := ((slice1shift_reference_0 / 262144) mod 2) = 1;
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
      slice1cost_pixels_first_1_0_count_4_value_2 := ((slice1shift_reference_1 / 16384) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_4_value_3 := ((slice1shift_reference_1 / 8192) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_5_value := ((slice1shift_reference_1 / 32768) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_5_value_2 := ((slice1shift_reference_1 / 131072) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_5_value_3 := ((slice1shift_reference_1 / 65536) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_6_value := ((slice1shift_reference_1 / 262144) mod 2) = 1;
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
      slice1cost_pixels_first_2_0_count_4_value_2 := ((slice1shift_reference_2 / 16384) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_4_value_3 := ((slice1shift_reference_2 / 8192) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_5_value := ((slice1shift_reference_2 / 32768) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_5_value_2 := ((slice1shift_reference_2 / 131072) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_5_value_3 := ((slice1shift_reference_2 / 65536) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_6_value := ((slice1shift_reference_2 / 262144) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_0_value := ((slice1shift_reference_3 / 4) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_0_value_2 := ((slice1shift_reference_3 / 2) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_1_value := ((slice1shift_reference_3 / 8) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_1_value_2 := ((slice1shift_reference_3 / 32) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_1_value_3 := ((slice1shift_reference_3 / 16) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_2_value := ((slice1shift_reference_3 / 256) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_2_value_2 := ((slice1shift_reference_3 / 64) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_3_value := ((slice1shift_reference_3 / 512) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_3_value_2 := ((slice1shift_reference_3 / 2048) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_3_value_3 := ((slice1shift_reference_3 / 1024) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_4_value := ((slice1shift_reference_3 / 4096) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_4_value_2 := ((slice1shift_reference_3 / 16384) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_4_value_3 := ((slice1shift_reference_3 / 8192) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_5_value := ((slice1shift_reference_3 / 32768) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_5_value_2 := ((slice1shift_reference_3 / 131072) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_5_value_3 := ((slice1shift_reference_3 / 65536) mod 2) = 1;
      slice1cost_pixels_first_3_0_count_6_value := ((slice1shift_reference_3 / 262144) mod 2) = 1;
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
      slice1cost_pixels_first_0_0_count_4 <= as_number((slice1cost_pixels_first_0_0_count_4_value /=
        (((slice1shift_search_0_0 / 4096) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_4_value_2 /=
        (((slice1shift_search_0_0 / 16384) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_4_value_3 /=
        (((slice1shift_search_0_0 / 8192) mod 2) = 1)));
      slice1cost_pixels_first_0_0_count_5 <= as_number((slice1cost_pixels_first_0_0_count_5_value /=
        (((slice1shift_search_0_0 / 32768) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_5_value_2 /=
        (((slice1shift_search_0_0 / 131072) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_5_value_3 /=
        (((slice1shift_search_0_0 / 65536) mod 2) = 1)));
      slice1cost_pixels_first_0_0_count_6 <= as_number((((slice1shift_reference_0 / 524288) = 1) /=
        ((slice1shift_search_0_0 / 524288) = 1))) + as_number((slice1cost_pixels_first_0_0_count_6_value /=
        (((slice1shift_search_0_0 / 262144) mod 2) = 1)));
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
      slice1cost_pixels_first_0_1_count_4 <= as_number(((((slice1shift_search_0_1 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_1 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_1 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_1_count_5 <= as_number(((((slice1shift_search_0_1 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_1 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_1 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_1_count_6 <= as_number((((slice1shift_search_0_1 / 524288) = 1) /=
        ((slice1shift_reference_0 / 524288) = 1))) + as_number(((((slice1shift_search_0_1 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value));
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
      slice1cost_pixels_first_0_2_count_4 <= as_number(((((slice1shift_search_0_2 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_2 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_2 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_2_count_5 <= as_number(((((slice1shift_search_0_2 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_2 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_2 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_2_count_6 <= as_number((((slice1shift_search_0_2 / 524288) = 1) /=
        ((slice1shift_reference_0 / 524288) = 1))) + as_number(((((slice1shift_search_0_2 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value));
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
      slice1cost_pixels_first_1_0_count_4 <= as_number((slice1cost_pixels_first_1_0_count_4_value /=
        (((slice1shift_search_1_0 / 4096) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_4_value_2 /=
        (((slice1shift_search_1_0 / 16384) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_4_value_3 /=
        (((slice1shift_search_1_0 / 8192) mod 2) = 1)));
      slice1cost_pixels_first_1_0_count_5 <= as_number((slice1cost_pixels_first_1_0_count_5_value /=
        (((slice1shift_search_1_0 / 32768) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_5_value_2 /=
        (((slice1shift_search_1_0 / 131072) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_5_value_3 /=
        (((slice1shift_search_1_0 / 65536) mod 2) = 1)));
      slice1cost_pixels_first_1_0_count_6 <= as_number((((slice1shift_reference_1 / 524288) = 1) /=
        ((slice1shift_search_1_0 / 524288) = 1))) + as_number((slice1cost_pixels_first_1_0_count_6_value /=
        (((slice1shift_search_1_0 / 262144) mod 2) = 1)));
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
      slice1cost_pixels_first_1_1_count_4 <= as_number(((((slice1shift_search_1_1 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_1 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_1 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_1_count_5 <= as_number(((((slice1shift_search_1_1 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_1 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_1 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_1_count_6 <= as_number((((slice1shift_search_1_1 / 524288) = 1) /=
        ((slice1shift_reference_1 / 524288) = 1))) + as_number(((((slice1shift_search_1_1 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value));
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
      slice1cost_pixels_first_1_2_count_4 <= as_number(((((slice1shift_search_1_2 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_2 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_2 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_2_count_5 <= as_number(((((slice1shift_search_1_2 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_2 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_2 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_2_count_6 <= as_number((((slice1shift_search_1_2 / 524288) = 1) /=
        ((slice1shift_reference_1 / 524288) = 1))) + as_number(((((slice1shift_search_1_2 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value));
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
      slice1cost_pixels_first_2_0_count_4 <= as_number((slice1cost_pixels_first_2_0_count_4_value /=
        (((slice1shift_search_2_0 / 4096) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_4_value_2 /=
        (((slice1shift_search_2_0 / 16384) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_4_value_3 /=
        (((slice1shift_search_2_0 / 8192) mod 2) = 1)));
      slice1cost_pixels_first_2_0_count_5 <= as_number((slice1cost_pixels_first_2_0_count_5_value /=
        (((slice1shift_search_2_0 / 32768) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_5_value_2 /=
        (((slice1shift_search_2_0 / 131072) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_5_value_3 /=
        (((slice1shift_search_2_0 / 65536) mod 2) = 1)));
      slice1cost_pixels_first_2_0_count_6 <= as_number((((slice1shift_reference_2 / 524288) = 1) /=
        ((slice1shift_search_2_0 / 524288) = 1))) + as_number((slice1cost_pixels_first_2_0_count_6_value /=
        (((slice1shift_search_2_0 / 262144) mod 2) = 1)));
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
      slice1cost_pixels_first_2_1_count_4 <= as_number(((((slice1shift_search_2_1 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value)) + as_number(((((slice1shift_search_2_1 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice1shift_search_2_1 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value_3));
      slice1cost_pixels_first_2_1_count_5 <= as_number(((((slice1shift_search_2_1 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value)) + as_number(((((slice1shift_search_2_1 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice1shift_search_2_1 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value_3));
      slice1cost_pixels_first_2_1_count_6 <= as_number((((slice1shift_search_2_1 / 524288) = 1) /=
        ((slice1shift_reference_2 / 524288) = 1))) + as_number(((((slice1shift_search_2_1 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value));
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
      slice1cost_pixels_first_2_2_count_4 <= as_number(((((slice1shift_search_2_2 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value)) + as_number(((((slice1shift_search_2_2 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice1shift_search_2_2 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value_3));
      slice1cost_pixels_first_2_2_count_5 <= as_number(((((slice1shift_search_2_2 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value)) + as_number(((((slice1shift_search_2_2 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice1shift_search_2_2 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value_3));
      slice1cost_pixels_first_2_2_count_6 <= as_number((((slice1shift_search_2_2 / 524288) = 1) /=
        ((slice1shift_reference_2 / 524288) = 1))) + as_number(((((slice1shift_search_2_2 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value));
      slice1cost_pixels_first_3_0_count_0 <= as_number((((slice1shift_search_3_0 mod 2) = 1) /=
        ((slice1shift_reference_3 mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_0_value /=
        (((slice1shift_search_3_0 / 4) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_0_value_2 /=
        (((slice1shift_search_3_0 / 2) mod 2) = 1)));
      slice1cost_pixels_first_3_0_count_1 <= as_number((slice1cost_pixels_first_3_0_count_1_value /=
        (((slice1shift_search_3_0 / 8) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_1_value_2 /=
        (((slice1shift_search_3_0 / 32) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_1_value_3 /=
        (((slice1shift_search_3_0 / 16) mod 2) = 1)));
      slice1cost_pixels_first_3_0_count_2 <= (to_integer(((to_unsigned((slice1shift_search_3_0 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_3 mod 256), 8)))) / 128) +
        as_number((slice1cost_pixels_first_3_0_count_2_value /= (((slice1shift_search_3_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_3_0_count_2_value_2 /= (((slice1shift_search_3_0 / 64) mod 2) = 1)));
      slice1cost_pixels_first_3_0_count_3 <= as_number((slice1cost_pixels_first_3_0_count_3_value /=
        (((slice1shift_search_3_0 / 512) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_3_value_2 /=
        (((slice1shift_search_3_0 / 2048) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_3_value_3 /=
        (((slice1shift_search_3_0 / 1024) mod 2) = 1)));
      slice1cost_pixels_first_3_0_count_4 <= as_number((slice1cost_pixels_first_3_0_count_4_value /=
        (((slice1shift_search_3_0 / 4096) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_4_value_2 /=
        (((slice1shift_search_3_0 / 16384) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_4_value_3 /=
        (((slice1shift_search_3_0 / 8192) mod 2) = 1)));
      slice1cost_pixels_first_3_0_count_5 <= as_number((slice1cost_pixels_first_3_0_count_5_value /=
        (((slice1shift_search_3_0 / 32768) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_5_value_2 /=
        (((slice1shift_search_3_0 / 131072) mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_count_5_value_3 /=
        (((slice1shift_search_3_0 / 65536) mod 2) = 1)));
      slice1cost_pixels_first_3_0_count_6 <= as_number((((slice1shift_reference_3 / 524288) = 1) /=
        ((slice1shift_search_3_0 / 524288) = 1))) + as_number((slice1cost_pixels_first_3_0_count_6_value /=
        (((slice1shift_search_3_0 / 262144) mod 2) = 1)));
      slice1cost_pixels_first_3_1_count_0 <= as_number((((slice1shift_search_3_1 mod 2) = 1) /=
        ((slice1shift_reference_3 mod 2) = 1))) + as_number(((((slice1shift_search_3_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_0_value)) + as_number(((((slice1shift_search_3_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_0_value_2));
      slice1cost_pixels_first_3_1_count_1 <= as_number(((((slice1shift_search_3_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_1_value)) + as_number(((((slice1shift_search_3_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_1_value_2)) + as_number(((((slice1shift_search_3_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_1_value_3));
      slice1cost_pixels_first_3_1_count_2 <= (to_integer(((to_unsigned((slice1shift_search_3_1 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_3 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_3_1 / 256) mod
        2) = 1) /= slice1cost_pixels_first_3_0_count_2_value)) + as_number(((((slice1shift_search_3_1 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_3_0_count_2_value_2));
      slice1cost_pixels_first_3_1_count_3 <= as_number(((((slice1shift_search_3_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_3_value)) + as_number(((((slice1shift_search_3_1 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_3_value_2)) + as_number(((((slice1shift_search_3_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_3_value_3));
      slice1cost_pixels_first_3_1_count_4 <= as_number(((((slice1shift_search_3_1 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_4_value)) + as_number(((((slice1shift_search_3_1 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_4_value_2)) + as_number(((((slice1shift_search_3_1 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_4_value_3));
      slice1cost_pixels_first_3_1_count_5 <= as_number(((((slice1shift_search_3_1 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_5_value)) + as_number(((((slice1shift_search_3_1 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_5_value_2)) + as_number(((((slice1shift_search_3_1 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_5_value_3));
      slice1cost_pixels_first_3_1_count_6 <= as_number((((slice1shift_search_3_1 / 524288) = 1) /=
        ((slice1shift_reference_3 / 524288) = 1))) + as_number(((((slice1shift_search_3_1 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_6_value));
      slice1cost_pixels_first_3_2_count_0 <= as_number((((slice1shift_search_3_2 mod 2) = 1) /=
        ((slice1shift_reference_3 mod 2) = 1))) + as_number(((((slice1shift_search_3_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_0_value)) + as_number(((((slice1shift_search_3_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_0_value_2));
      slice1cost_pixels_first_3_2_count_1 <= as_number(((((slice1shift_search_3_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_1_value)) + as_number(((((slice1shift_search_3_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_1_value_2)) + as_number(((((slice1shift_search_3_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_1_value_3));
      slice1cost_pixels_first_3_2_count_2 <= (to_integer(((to_unsigned((slice1shift_search_3_2 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_3 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_3_2 / 256) mod
        2) = 1) /= slice1cost_pixels_first_3_0_count_2_value)) + as_number(((((slice1shift_search_3_2 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_3_0_count_2_value_2));
      slice1cost_pixels_first_3_2_count_3 <= as_number(((((slice1shift_search_3_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_3_value)) + as_number(((((slice1shift_search_3_2 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_3_value_2)) + as_number(((((slice1shift_search_3_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_3_value_3));
      slice1cost_pixels_first_3_2_count_4 <= as_number(((((slice1shift_search_3_2 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_4_value)) + as_number(((((slice1shift_search_3_2 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_4_value_2)) + as_number(((((slice1shift_search_3_2 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_4_value_3));
      slice1cost_pixels_first_3_2_count_5 <= as_number(((((slice1shift_search_3_2 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_5_value)) + as_number(((((slice1shift_search_3_2 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_5_value_2)) + as_number(((((slice1shift_search_3_2 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_5_value_3));
      slice1cost_pixels_first_3_2_count_6 <= as_number((((slice1shift_search_3_2 / 524288) = 1) /=
        ((slice1shift_reference_3 / 524288) = 1))) + as_number(((((slice1shift_search_3_2 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_count_6_value));
      slice1cost_pixels_cost_0_0 <= slice1cost_pixels_first_0_0_count_6 + slice1cost_pixels_first_0_0_count_4 +
        slice1cost_pixels_first_0_0_count_3 + slice1cost_pixels_first_0_0_count_1 + slice1cost_pixels_first_0_0_count_5
        + slice1cost_pixels_first_0_0_count_0 + slice1cost_pixels_first_0_0_count_2;
      slice1cost_pixels_cost_0_1 <= slice1cost_pixels_first_0_1_count_6 + slice1cost_pixels_first_0_1_count_4 +
        slice1cost_pixels_first_0_1_count_3 + slice1cost_pixels_first_0_1_count_1 + slice1cost_pixels_first_0_1_count_5
        + slice1cost_pixels_first_0_1_count_0 + slice1cost_pixels_first_0_1_count_2;
      slice1cost_pixels_cost_0_2 <= slice1cost_pixels_first_0_2_count_6 + slice1cost_pixels_first_0_2_count_4 +
        slice1cost_pixels_first_0_2_count_3 + slice1cost_pixels_first_0_2_count_1 + slice1cost_pixels_first_0_2_count_5
        + slice1cost_pixels_first_0_2_count_0 + slice1cost_pixels_first_0_2_count_2;
      slice1cost_pixels_cost_1_0 <= slice1cost_pixels_first_1_0_count_6 + slice1cost_pixels_first_1_0_count_4 +
        slice1cost_pixels_first_1_0_count_3 + slice1cost_pixels_first_1_0_count_1 + slice1cost_pixels_first_1_0_count_5
        + slice1cost_pixels_first_1_0_count_0 + slice1cost_pixels_first_1_0_count_2;
      slice1cost_pixels_cost_1_1 <= slice1cost_pixels_first_1_1_count_6 + slice1cost_pixels_first_1_1_count_4 +
        slice1cost_pixels_first_1_1_count_3 + slice1cost_pixels_first_1_1_count_1 + slice1cost_pixels_first_1_1_count_5
        + slice1cost_pixels_first_1_1_count_0 + slice1cost_pixels_first_1_1_count_2;
      slice1cost_pixels_cost_1_2 <= slice1cost_pixels_first_1_2_count_6 + slice1cost_pixels_first_1_2_count_4 +
        slice1cost_pixels_first_1_2_count_3 + slice1cost_pixels_first_1_2_count_1 + slice1cost_pixels_first_1_2_count_5
        + slice1cost_pixels_first_1_2_count_0 + slice1cost_pixels_first_1_2_count_2;
      slice1cost_pixels_cost_2_0 <= slice1cost_pixels_first_2_0_count_6 + slice1cost_pixels_first_2_0_count_4 +
        slice1cost_pixels_first_2_0_count_3 + slice1cost_pixels_first_2_0_count_1 + slice1cost_pixels_first_2_0_count_5
        + slice1cost_pixels_first_2_0_count_0 + slice1cost_pixels_first_2_0_count_2;
      slice1cost_pixels_cost_2_1 <= slice1cost_pixels_first_2_1_count_6 + slice1cost_pixels_first_2_1_count_4 +
        slice1cost_pixels_first_2_1_count_3 + slice1cost_pixels_first_2_1_count_1 + slice1cost_pixels_first_2_1_count_5
        + slice1cost_pixels_first_2_1_count_0 + slice1cost_pixels_first_2_1_count_2;
      slice1cost_pixels_cost_2_2 <= slice1cost_pixels_first_2_2_count_6 + slice1cost_pixels_first_2_2_count_4 +
        slice1cost_pixels_first_2_2_count_3 + slice1cost_pixels_first_2_2_count_1 + slice1cost_pixels_first_2_2_count_5
        + slice1cost_pixels_first_2_2_count_0 + slice1cost_pixels_first_2_2_count_2;
      slice1cost_pixels_cost_3_0 <= slice1cost_pixels_first_3_0_count_6 + slice1cost_pixels_first_3_0_count_4 +
        slice1cost_pixels_first_3_0_count_3 + slice1cost_pixels_first_3_0_count_1 + slice1cost_pixels_first_3_0_count_5
        + slice1cost_pixels_first_3_0_count_0 + slice1cost_pixels_first_3_0_count_2;
      slice1cost_pixels_cost_3_1 <= slice1cost_pixels_first_3_1_count_6 + slice1cost_pixels_first_3_1_count_4 +
        slice1cost_pixels_first_3_1_count_3 + slice1cost_pixels_first_3_1_count_1 + slice1cost_pixels_first_3_1_count_5
        + slice1cost_pixels_first_3_1_count_0 + slice1cost_pixels_first_3_1_count_2;
      slice1cost_pixels_cost_3_2 <= slice1cost_pixels_first_3_2_count_6 + slice1cost_pixels_first_3_2_count_4 +
        slice1cost_pixels_first_3_2_count_3 + slice1cost_pixels_first_3_2_count_1 + slice1cost_pixels_first_3_2_count_5
        + slice1cost_pixels_first_3_2_count_0 + slice1cost_pixels_first_3_2_count_2;
      slice1cost_pair_0_0 <= slice1cost_pixels_cost_1_0 + slice1cost_pixels_cost_2_0;
      slice1cost_pair_0_1 <= slice1cost_pixels_cost_1_1 + slice1cost_pixels_cost_2_1;
      slice1cost_pair_0_2 <= slice1cost_pixels_cost_1_2 + slice1cost_pixels_cost_2_2;
      slice1cost_single_0_0 <= slice1cost_pixels_cost_0_0;
      slice1cost_single_0_1 <= slice1cost_pixels_cost_0_1;
      slice1cost_single_0_2 <= slice1cost_pixels_cost_0_2;
      slice1cost_single_3_0 <= slice1cost_pixels_cost_3_0;
      slice1cost_single_3_1 <= slice1cost_pixels_cost_3_1;
      slice1cost_single_3_2 <= slice1cost_pixels_cost_3_2;
      slice1cost_tag_border_column <= slice0cost_tag_border_column;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_1_0 <= 0;
        slice1cost_column_1_1 <= 0;
        slice1cost_column_1_2 <= 0;
      else
        slice1cost_column_0_0 <= slice1cost_pair_0_0 + slice1cost_single_0_0;
        slice1cost_column_0_1 <= slice1cost_pair_0_1 + slice1cost_single_0_1;
        slice1cost_column_0_2 <= slice1cost_pair_0_2 + slice1cost_single_0_2;
        slice1cost_column_1_0 <= slice1cost_pair_0_0 + slice1cost_single_3_0;
        slice1cost_column_1_1 <= slice1cost_pair_0_1 + slice1cost_single_3_1;
        slice1cost_column_1_2 <= slice1cost_pair_0_2 + slice1cost_single_3_2;
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
      slice1window_sum_0_0 <= slice1cost_column_0_0 + slice1window_partial_0_1_0;
      slice1window_sum_0_1 <= slice1cost_column_0_1 + slice1window_partial_0_1_1;
      slice1window_sum_0_2 <= slice1cost_column_0_2 + slice1window_partial_0_1_2;
      slice1window_sum_1_0 <= slice1cost_column_1_0 + slice1window_partial_1_1_0;
      slice1window_sum_1_1 <= slice1cost_column_1_1 + slice1window_partial_1_1_1;
      slice1window_sum_1_2 <= slice1cost_column_1_2 + slice1window_partial_1_1_2;
      -- slice1winner1
      if (slice1window_sum_0_0 mod 2) = 1 then
        slice1winner1_of_pair_0_0_choice := (not (((slice1window_sum_0_1 / 2) mod 2) = 1)) or (not
          ((slice1window_sum_0_1 mod 2) = 1));
      else
        slice1winner1_of_pair_0_0_choice := not (((slice1window_sum_0_1 / 2) mod 2) = 1);
      end if;
      if ((slice1window_sum_0_0 / 2) mod 2) = 1 then
        slice1winner1_of_pair_0_0_choice_2 := slice1winner1_of_pair_0_0_choice;
      else
        slice1winner1_of_pair_0_0_choice_2 := ((slice1window_sum_0_0 mod 2) = 1) and ((slice1window_sum_0_1 mod 4) = 0);
      end if;
      slice1winner1_of_pair_0_0_value := ((slice1window_sum_0_1 / 4) mod 2) = 1;
      if slice1winner1_of_pair_0_0_choice_2 then
        slice1winner1_of_pair_0_0_choice_3 := (not (((slice1window_sum_0_0 / 4) mod 2) = 1)) and
          slice1winner1_of_pair_0_0_value;
      else
        slice1winner1_of_pair_0_0_choice_3 := (not (((slice1window_sum_0_0 / 4) mod 2) = 1)) or
          slice1winner1_of_pair_0_0_value;
      end if;
      slice1winner1_of_pair_0_0_value_2 := ((slice1window_sum_0_1 / 8) mod 2) = 1;
      if slice1winner1_of_pair_0_0_choice_3 then
        slice1winner1_of_pair_0_0_choice_4 := (not (((slice1window_sum_0_0 / 8) mod 2) = 1)) or
          slice1winner1_of_pair_0_0_value_2;
      else
        slice1winner1_of_pair_0_0_choice_4 := (not (((slice1window_sum_0_0 / 8) mod 2) = 1)) and
          slice1winner1_of_pair_0_0_value_2;
      end if;
      slice1winner1_of_pair_0_0_value_3 := ((slice1window_sum_0_1 / 16) mod 2) = 1;
      if slice1winner1_of_pair_0_0_choice_4 then
        slice1winner1_of_pair_0_0_choice_5 := (not (((slice1window_sum_0_0 / 16) mod 2) = 1)) or
          slice1winner1_of_pair_0_0_value_3;
      else
        slice1winner1_of_pair_0_0_choice_5 := (not (((slice1window_sum_0_0 / 16) mod 2) = 1)) and
          slice1winner1_of_pair_0_0_value_3;
      end if;
      slice1winner1_of_pair_0_0_value_4 := ((slice1window_sum_0_1 / 32) mod 2) = 1;
      if slice1winner1_of_pair_0_0_choice_5 then
        slice1winner1_of_pair_0_0_choice_6 := (not (((slice1window_sum_0_0 / 32) mod 2) = 1)) or
          slice1winner1_of_pair_0_0_value_4;
      else
        slice1winner1_of_pair_0_0_choice_6 := (not (((slice1window_sum_0_0 / 32) mod 2) = 1)) and
          slice1winner1_of_pair_0_0_value_4;
      end if;
      slice1winner1_of_pair_0_0_value_5 := ((slice1window_sum_0_1 / 64) mod 2) = 1;
      if slice1winner1_of_pair_0_0_choice_6 then
        slice1winner1_of_pair_0_0_choice_7 := (not (((slice1window_sum_0_0 / 64) mod 2) = 1)) or
          slice1winner1_of_pair_0_0_value_5;
      else
        slice1winner1_of_pair_0_0_choice_7 := (not (((slice1window_sum_0_0 / 64) mod 2) = 1)) and
          slice1winner1_of_pair_0_0_value_5;
      end if;
      if slice1winner1_of_pair_0_0_choice_7 then
        slice1winner1_of_pair_0_0_choice_8 := ((slice1window_sum_0_0 / 128) = 1) and (not ((slice1window_sum_0_1 / 128)
          = 1));
      else
        slice1winner1_of_pair_0_0_choice_8 := ((slice1window_sum_0_0 / 128) = 1) or (not ((slice1window_sum_0_1 / 128)
          = 1));
      end if;
      if (slice1window_sum_1_0 mod 2) = 1 then
        slice1winner1_of_pair_1_0_choice := (not (((slice1window_sum_1_1 / 2) mod 2) = 1)) or (not
          ((slice1window_sum_1_1 mod 2) = 1));
      else
        slice1winner1_of_pair_1_0_choice := not (((slice1window_sum_1_1 / 2) mod 2) = 1);
      end if;
      if ((slice1window_sum_1_0 / 2) mod 2) = 1 then
        slice1winner1_of_pair_1_0_choice_2 := slice1winner1_of_pair_1_0_choice;
      else
        slice1winner1_of_pair_1_0_choice_2 := ((slice1window_sum_1_0 mod 2) = 1) and ((slice1window_sum_1_1 mod 4) = 0);
      end if;
      slice1winner1_of_pair_1_0_value := ((slice1window_sum_1_1 / 4) mod 2) = 1;
      if slice1winner1_of_pair_1_0_choice_2 then
        slice1winner1_of_pair_1_0_choice_3 := (not (((slice1window_sum_1_0 / 4) mod 2) = 1)) and
          slice1winner1_of_pair_1_0_value;
      else
        slice1winner1_of_pair_1_0_choice_3 := (not (((slice1window_sum_1_0 / 4) mod 2) = 1)) or
          slice1winner1_of_pair_1_0_value;
      end if;
      slice1winner1_of_pair_1_0_value_2 := ((slice1window_sum_1_1 / 8) mod 2) = 1;
      if slice1winner1_of_pair_1_0_choice_3 then
        slice1winner1_of_pair_1_0_choice_4 := (not (((slice1window_sum_1_0 / 8) mod 2) = 1)) or
          slice1winner1_of_pair_1_0_value_2;
      else
        slice1winner1_of_pair_1_0_choice_4 := (not (((slice1window_sum_1_0 / 8) mod 2) = 1)) and
          slice1winner1_of_pair_1_0_value_2;
      end if;
      slice1winner1_of_pair_1_0_value_3 := ((slice1window_sum_1_1 / 16) mod 2) = 1;
      if slice1winner1_of_pair_1_0_choice_4 then
        slice1winner1_of_pair_1_0_choice_5 := (not (((slice1window_sum_1_0 / 16) mod 2) = 1)) or
          slice1winner1_of_pair_1_0_value_3;
      else
        slice1winner1_of_pair_1_0_choice_5 := (not (((slice1window_sum_1_0 / 16) mod 2) = 1)) and
          slice1winner1_of_pair_1_0_value_3;
      end if;
      slice1winner1_of_pair_1_0_value_4 := ((slice1window_sum_1_1 / 32) mod 2) = 1;
      if slice1winner1_of_pair_1_0_choice_5 then
        slice1winner1_of_pair_1_0_choice_6 := (not (((slice1window_sum_1_0 / 32) mod 2) = 1)) or
          slice1winner1_of_pair_1_0_value_4;
      else
        slice1winner1_of_pair_1_0_choice_6 := (not (((slice1window_sum_1_0 / 32) mod 2) = 1)) and
          slice1winner1_of_pair_1_0_value_4;
      end if;
      slice1winner1_of_pair_1_0_value_5 := ((slice1window_sum_1_1 / 64) mod 2) = 1;
      if slice1winner1_of_pair_1_0_choice_6 then
        slice1winner1_of_pair_1_0_choice_7 := (not (((slice1window_sum_1_0 / 64) mod 2) = 1)) or
          slice1winner1_of_pair_1_0_value_5;
      else
        slice1winner1_of_pair_1_0_choice_7 := (not (((slice1window_sum_1_0 / 64) mod 2) = 1)) and
          slice1winner1_of_pair_1_0_value_5;
      end if;
      if slice1winner1_of_pair_1_0_choice_7 then
        slice1winner1_of_pair_1_0_choice_8 := ((slice1window_sum_1_0 / 128) = 1) and (not ((slice1window_sum_1_1 / 128)
          = 1));
      else
        slice1winner1_of_pair_1_0_choice_8 := ((slice1window_sum_1_0 / 128) = 1) or (not ((slice1window_sum_1_1 / 128)
          = 1));
      end if;
      slice1winner1_of_four_0_0_value := ((slice1winner1_of_pair_0_1 / 2) mod 2) = 1;
      slice1winner1_of_four_0_0_value_2 := ((slice1winner1_of_pair_0_0 / 2) mod 2) = 1;
      if (not ((slice1winner1_of_pair_0_2 mod 2) = 1)) and (((slice1winner1_of_pair_0_1 mod 2) = 1) or
        ((slice1winner1_of_pair_0_0 mod 2) = 1)) then
        slice1winner1_of_four_0_0_choice := (not (((slice1winner1_of_pair_0_2 / 2) mod 2) = 1)) or
          slice1winner1_of_four_0_0_value or slice1winner1_of_four_0_0_value_2;
      else
        slice1winner1_of_four_0_0_choice := (not (((slice1winner1_of_pair_0_2 / 2) mod 2) = 1)) and
          (slice1winner1_of_four_0_0_value or slice1winner1_of_four_0_0_value_2);
      end if;
      slice1winner1_of_four_0_0_value_3 := ((slice1winner1_of_pair_0_2 / 4) mod 2) = 1;
      if slice1winner1_of_four_0_0_choice then
        slice1winner1_of_four_0_0_choice_2 := slice1winner1_of_four_0_0_value_3 and (not (((slice1winner1_of_pair_0_1 /
          4) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 4) mod 2) = 1));
      else
        slice1winner1_of_four_0_0_choice_2 := slice1winner1_of_four_0_0_value_3 or ((not (((slice1winner1_of_pair_0_1 /
          4) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 4) mod 2) = 1)));
      end if;
      slice1winner1_of_four_0_0_value_4 := ((slice1winner1_of_pair_0_2 / 8) mod 2) = 1;
      if slice1winner1_of_four_0_0_choice_2 then
        slice1winner1_of_four_0_0_choice_3 := slice1winner1_of_four_0_0_value_4 or ((not (((slice1winner1_of_pair_0_1 /
          8) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 8) mod 2) = 1)));
      else
        slice1winner1_of_four_0_0_choice_3 := slice1winner1_of_four_0_0_value_4 and (not (((slice1winner1_of_pair_0_1 /
          8) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 8) mod 2) = 1));
      end if;
      slice1winner1_of_four_0_0_value_5 := ((slice1winner1_of_pair_0_2 / 16) mod 2) = 1;
      if slice1winner1_of_four_0_0_choice_3 then
        slice1winner1_of_four_0_0_choice_4 := slice1winner1_of_four_0_0_value_5 or ((not (((slice1winner1_of_pair_0_1 /
          16) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 16) mod 2) = 1)));
      else
        slice1winner1_of_four_0_0_choice_4 := slice1winner1_of_four_0_0_value_5 and (not (((slice1winner1_of_pair_0_1 /
          16) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 16) mod 2) = 1));
      end if;
      slice1winner1_of_four_0_0_value_6 := ((slice1winner1_of_pair_0_2 / 32) mod 2) = 1;
      if slice1winner1_of_four_0_0_choice_4 then
        slice1winner1_of_four_0_0_choice_5 := slice1winner1_of_four_0_0_value_6 or ((not (((slice1winner1_of_pair_0_1 /
          32) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 32) mod 2) = 1)));
      else
        slice1winner1_of_four_0_0_choice_5 := slice1winner1_of_four_0_0_value_6 and (not (((slice1winner1_of_pair_0_1 /
          32) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 32) mod 2) = 1));
      end if;
      slice1winner1_of_four_0_0_value_7 := ((slice1winner1_of_pair_0_2 / 64) mod 2) = 1;
      if slice1winner1_of_four_0_0_choice_5 then
        slice1winner1_of_four_0_0_choice_6 := slice1winner1_of_four_0_0_value_7 or ((not (((slice1winner1_of_pair_0_1 /
          64) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 64) mod 2) = 1)));
      else
        slice1winner1_of_four_0_0_choice_6 := slice1winner1_of_four_0_0_value_7 and (not (((slice1winner1_of_pair_0_1 /
          64) mod 2) = 1)) and (not (((slice1winner1_of_pair_0_0 / 64) mod 2) = 1));
      end if;
      if slice1winner1_of_four_0_0_choice_6 then
        slice1winner1_of_four_0_0_choice_7 := (not ((slice1winner1_of_pair_0_2 / 128) = 1)) and
          (((slice1winner1_of_pair_0_1 / 128) = 1) or ((slice1winner1_of_pair_0_0 / 128) = 1));
      else
        slice1winner1_of_four_0_0_choice_7 := (not ((slice1winner1_of_pair_0_2 / 128) = 1)) or
          ((slice1winner1_of_pair_0_1 / 128) = 1) or ((slice1winner1_of_pair_0_0 / 128) = 1);
      end if;
      slice1winner1_of_four_1_0_value := ((slice1winner1_of_pair_1_1 / 2) mod 2) = 1;
      slice1winner1_of_four_1_0_value_2 := ((slice1winner1_of_pair_1_0 / 2) mod 2) = 1;
      if (not ((slice1winner1_of_pair_1_2 mod 2) = 1)) and (((slice1winner1_of_pair_1_1 mod 2) = 1) or
        ((slice1winner1_of_pair_1_0 mod 2) = 1)) then
        slice1winner1_of_four_1_0_choice := (not (((slice1winner1_of_pair_1_2 / 2) mod 2) = 1)) or
          slice1winner1_of_four_1_0_value or slice1winner1_of_four_1_0_value_2;
      else
        slice1winner1_of_four_1_0_choice := (not (((slice1winner1_of_pair_1_2 / 2) mod 2) = 1)) and
          (slice1winner1_of_four_1_0_value or slice1winner1_of_four_1_0_value_2);
      end if;
      slice1winner1_of_four_1_0_value_3 := ((slice1winner1_of_pair_1_2 / 4) mod 2) = 1;
      if slice1winner1_of_four_1_0_choice then
        slice1winner1_of_four_1_0_choice_2 := slice1winner1_of_four_1_0_value_3 and (not (((slice1winner1_of_pair_1_1 /
          4) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 4) mod 2) = 1));
      else
        slice1winner1_of_four_1_0_choice_2 := slice1winner1_of_four_1_0_value_3 or ((not (((slice1winner1_of_pair_1_1 /
          4) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 4) mod 2) = 1)));
      end if;
      slice1winner1_of_four_1_0_value_4 := ((slice1winner1_of_pair_1_2 / 8) mod 2) = 1;
      if slice1winner1_of_four_1_0_choice_2 then
        slice1winner1_of_four_1_0_choice_3 := slice1winner1_of_four_1_0_value_4 or ((not (((slice1winner1_of_pair_1_1 /
          8) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 8) mod 2) = 1)));
      else
        slice1winner1_of_four_1_0_choice_3 := slice1winner1_of_four_1_0_value_4 and (not (((slice1winner1_of_pair_1_1 /
          8) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 8) mod 2) = 1));
      end if;
      slice1winner1_of_four_1_0_value_5 := ((slice1winner1_of_pair_1_2 / 16) mod 2) = 1;
      if slice1winner1_of_four_1_0_choice_3 then
        slice1winner1_of_four_1_0_choice_4 := slice1winner1_of_four_1_0_value_5 or ((not (((slice1winner1_of_pair_1_1 /
          16) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 16) mod 2) = 1)));
      else
        slice1winner1_of_four_1_0_choice_4 := slice1winner1_of_four_1_0_value_5 and (not (((slice1winner1_of_pair_1_1 /
          16) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 16) mod 2) = 1));
      end if;
      slice1winner1_of_four_1_0_value_6 := ((slice1winner1_of_pair_1_2 / 32) mod 2) = 1;
      if slice1winner1_of_four_1_0_choice_4 then
        slice1winner1_of_four_1_0_choice_5 := slice1winner1_of_four_1_0_value_6 or ((not (((slice1winner1_of_pair_1_1 /
          32) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 32) mod 2) = 1)));
      else
        slice1winner1_of_four_1_0_choice_5 := slice1winner1_of_four_1_0_value_6 and (not (((slice1winner1_of_pair_1_1 /
          32) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 32) mod 2) = 1));
      end if;
      slice1winner1_of_four_1_0_value_7 := ((slice1winner1_of_pair_1_2 / 64) mod 2) = 1;
      if slice1winner1_of_four_1_0_choice_5 then
        slice1winner1_of_four_1_0_choice_6 := slice1winner1_of_four_1_0_value_7 or ((not (((slice1winner1_of_pair_1_1 /
          64) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 64) mod 2) = 1)));
      else
        slice1winner1_of_four_1_0_choice_6 := slice1winner1_of_four_1_0_value_7 and (not (((slice1winner1_of_pair_1_1 /
          64) mod 2) = 1)) and (not (((slice1winner1_of_pair_1_0 / 64) mod 2) = 1));
      end if;
      if slice1winner1_of_four_1_0_choice_6 then
        slice1winner1_of_four_1_0_choice_7 := (not ((slice1winner1_of_pair_1_2 / 128) = 1)) and
          (((slice1winner1_of_pair_1_1 / 128) = 1) or ((slice1winner1_of_pair_1_0 / 128) = 1));
      else
        slice1winner1_of_four_1_0_choice_7 := (not ((slice1winner1_of_pair_1_2 / 128) = 1)) or
          ((slice1winner1_of_pair_1_1 / 128) = 1) or ((slice1winner1_of_pair_1_0 / 128) = 1);
      end if;
      slice1winner1_of_pair_0_2 <= slice1window_sum_0_2;
      slice1winner1_of_pair_1_2 <= slice1window_sum_1_2;
      slice1winner1_pair_index_0_0 <= slice1winner1_of_pair_0_0_choice_8;
      slice1winner1_pair_index_1_0 <= slice1winner1_of_pair_1_0_choice_8;
      slice1winner1_best_cost_0_0 <= to_integer(((((to_unsigned(slice1winner1_of_four_0_1, 8)) or
        (to_unsigned(slice1winner1_of_four_0_2, 8)))) or (to_unsigned(slice1winner1_of_four_0_0, 8))));
      slice1winner1_best_cost_1_0 <= to_integer(((((to_unsigned(slice1winner1_of_four_1_1, 8)) or
        (to_unsigned(slice1winner1_of_four_1_2, 8)))) or (to_unsigned(slice1winner1_of_four_1_0, 8))));
      slice1winner1_best_index_0_0 <= slice1winner1_four_index_0_0;
      slice1winner1_best_index_1_0 <= slice1winner1_four_index_1_0;
      if slice1winner1_of_pair_0_0_choice_8 then
        slice1winner1_of_pair_0_0 <= 0;
        slice1winner1_of_pair_0_1 <= slice1window_sum_0_1;
      else
        slice1winner1_of_pair_0_0 <= slice1window_sum_0_0;
        slice1winner1_of_pair_0_1 <= 0;
      end if;
      if slice1winner1_of_pair_1_0_choice_8 then
        slice1winner1_of_pair_1_0 <= 0;
        slice1winner1_of_pair_1_1 <= slice1window_sum_1_1;
      else
        slice1winner1_of_pair_1_0 <= slice1window_sum_1_0;
        slice1winner1_of_pair_1_1 <= 0;
      end if;
      if slice1winner1_of_four_0_0_choice_7 then
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
      if slice1winner1_of_four_1_0_choice_7 then
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
      if (slice1winner1_best_cost_0_0 mod 2) = 1 then
        slice1_best_index_0_0_choice := (not (((slice0_best_cost_0_0 / 2) mod 2) = 1)) or (not ((slice0_best_cost_0_0
          mod 2) = 1));
      else
        slice1_best_index_0_0_choice := not (((slice0_best_cost_0_0 / 2) mod 2) = 1);
      end if;
      if ((slice1winner1_best_cost_0_0 / 2) mod 2) = 1 then
        slice1_best_index_0_0_choice_2 := slice1_best_index_0_0_choice;
      else
        slice1_best_index_0_0_choice_2 := ((slice1winner1_best_cost_0_0 mod 2) = 1) and ((slice0_best_cost_0_0 mod 4) =
          0);
      end if;
      slice1_best_index_0_0_value := ((slice0_best_cost_0_0 / 4) mod 2) = 1;
      if slice1_best_index_0_0_choice_2 then
        slice1_best_index_0_0_choice_3 := (not (((slice1winner1_best_cost_0_0 / 4) mod 2) = 1)) and
          slice1_best_index_0_0_value;
      else
        slice1_best_index_0_0_choice_3 := (not (((slice1winner1_best_cost_0_0 / 4) mod 2) = 1)) or
          slice1_best_index_0_0_value;
      end if;
      slice1_best_index_0_0_value_2 := ((slice0_best_cost_0_0 / 8) mod 2) = 1;
      if slice1_best_index_0_0_choice_3 then
        slice1_best_index_0_0_choice_4 := (not (((slice1winner1_best_cost_0_0 / 8) mod 2) = 1)) or
          slice1_best_index_0_0_value_2;
      else
        slice1_best_index_0_0_choice_4 := (not (((slice1winner1_best_cost_0_0 / 8) mod 2) = 1)) and
          slice1_best_index_0_0_value_2;
      end if;
      slice1_best_index_0_0_value_3 := ((slice0_best_cost_0_0 / 16) mod 2) = 1;
      if slice1_best_index_0_0_choice_4 then
        slice1_best_index_0_0_choice_5 := (not (((slice1winner1_best_cost_0_0 / 16) mod 2) = 1)) or
          slice1_best_index_0_0_value_3;
      else
        slice1_best_index_0_0_choice_5 := (not (((slice1winner1_best_cost_0_0 / 16) mod 2) = 1)) and
          slice1_best_index_0_0_value_3;
      end if;
      slice1_best_index_0_0_value_4 := ((slice0_best_cost_0_0 / 32) mod 2) = 1;
      if slice1_best_index_0_0_choice_5 then
        slice1_best_index_0_0_choice_6 := (not (((slice1winner1_best_cost_0_0 / 32) mod 2) = 1)) or
          slice1_best_index_0_0_value_4;
      else
        slice1_best_index_0_0_choice_6 := (not (((slice1winner1_best_cost_0_0 / 32) mod 2) = 1)) and
          slice1_best_index_0_0_value_4;
      end if;
      slice1_best_index_0_0_value_5 := ((slice0_best_cost_0_0 / 64) mod 2) = 1;
      if slice1_best_index_0_0_choice_6 then
        slice1_best_index_0_0_choice_7 := (not (((slice1winner1_best_cost_0_0 / 64) mod 2) = 1)) or
          slice1_best_index_0_0_value_5;
      else
        slice1_best_index_0_0_choice_7 := (not (((slice1winner1_best_cost_0_0 / 64) mod 2) = 1)) and
          slice1_best_index_0_0_value_5;
      end if;
      if slice1_best_index_0_0_choice_7 then
        slice1_best_index_0_0_choice_8 := ((slice1winner1_best_cost_0_0 / 128) = 1) and (not ((slice0_best_cost_0_0 /
          128) = 1));
      else
        slice1_best_index_0_0_choice_8 := ((slice1winner1_best_cost_0_0 / 128) = 1) or (not ((slice0_best_cost_0_0 /
          128) = 1));
      end if;
      if (slice1winner1_best_cost_1_0 mod 2) = 1 then
        slice1_best_index_1_0_choice := (not (((slice0_best_cost_1_0 / 2) mod 2) = 1)) or (not ((slice0_best_cost_1_0
          mod 2) = 1));
      else
        slice1_best_index_1_0_choice := not (((slice0_best_cost_1_0 / 2) mod 2) = 1);
      end if;
      if ((slice1winner1_best_cost_1_0 / 2) mod 2) = 1 then
        slice1_best_index_1_0_choice_2 := slice1_best_index_1_0_choice;
      else
        slice1_best_index_1_0_choice_2 := ((slice1winner1_best_cost_1_0 mod 2) = 1) and ((slice0_best_cost_1_0 mod 4) =
          0);
      end if;
      slice1_best_index_1_0_value := ((slice0_best_cost_1_0 / 4) mod 2) = 1;
      if slice1_best_index_1_0_choice_2 then
        slice1_best_index_1_0_choice_3 := (not (((slice1winner1_best_cost_1_0 / 4) mod 2) = 1)) and
          slice1_best_index_1_0_value;
      else
        slice1_best_index_1_0_choice_3 := (not (((slice1winner1_best_cost_1_0 / 4) mod 2) = 1)) or
          slice1_best_index_1_0_value;
      end if;
      slice1_best_index_1_0_value_2 := ((slice0_best_cost_1_0 / 8) mod 2) = 1;
      if slice1_best_index_1_0_choice_3 then
        slice1_best_index_1_0_choice_4 := (not (((slice1winner1_best_cost_1_0 / 8) mod 2) = 1)) or
          slice1_best_index_1_0_value_2;
      else
        slice1_best_index_1_0_choice_4 := (not (((slice1winner1_best_cost_1_0 / 8) mod 2) = 1)) and
          slice1_best_index_1_0_value_2;
      end if;
      slice1_best_index_1_0_value_3 := ((slice0_best_cost_1_0 / 16) mod 2) = 1;
      if slice1_best_index_1_0_choice_4 then
        slice1_best_index_1_0_choice_5 := (not (((slice1winner1_best_cost_1_0 / 16) mod 2) = 1)) or
          slice1_best_index_1_0_value_3;
      else
        slice1_best_index_1_0_choice_5 := (not (((slice1winner1_best_cost_1_0 / 16) mod 2) = 1)) and
          slice1_best_index_1_0_value_3;
      end if;
      slice1_best_index_1_0_value_4 := ((slice0_best_cost_1_0 / 32) mod 2) = 1;
      if slice1_best_index_1_0_choice_5 then
        slice1_best_index_1_0_choice_6 := (not (((slice1winner1_best_cost_1_0 / 32) mod 2) = 1)) or
          slice1_best_index_1_0_value_4;
      else
        slice1_best_index_1_0_choice_6 := (not (((slice1winner1_best_cost_1_0 / 32) mod 2) = 1)) and
          slice1_best_index_1_0_value_4;
      end if;
      slice1_best_index_1_0_value_5 := ((slice0_best_cost_1_0 / 64) mod 2) = 1;
      if slice1_best_index_1_0_choice_6 then
        slice1_best_index_1_0_choice_7 := (not (((slice1winner1_best_cost_1_0 / 64) mod 2) = 1)) or
          slice1_best_index_1_0_value_5;
      else
        slice1_best_index_1_0_choice_7 := (not (((slice1winner1_best_cost_1_0 / 64) mod 2) = 1)) and
          slice1_best_index_1_0_value_5;
      end if;
      if slice1_best_index_1_0_choice_7 then
        slice1_best_index_1_0_choice_8 := ((slice1winner1_best_cost_1_0 / 128) = 1) and (not ((slice0_best_cost_1_0 /
          128) = 1));
      else
        slice1_best_index_1_0_choice_8 := ((slice1winner1_best_cost_1_0 / 128) = 1) or (not ((slice0_best_cost_1_0 /
          128) = 1));
      end if;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if (slice0_best_cost_0_0 - slice1winner1_best_cost_0_0) < 0 then
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner1_best_cost_0_0;
      end if;
      if (slice0_best_cost_1_0 - slice1winner1_best_cost_1_0) < 0 then
        slice1_best_cost_1_0 <= slice0_best_cost_1_0;
      else
        slice1_best_cost_1_0 <= slice1winner1_best_cost_1_0;
      end if;
      if slice1_best_index_0_0_choice_8 then
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_index_0_0 <= (((slice1winner1_best_index_0_0 / 2) + 1) * 2) + (slice1winner1_best_index_0_0 mod 2);
      end if;
      if slice1_best_index_1_0_choice_8 then
        slice1_best_index_1_0 <= slice0_best_index_1_0;
      else
        slice1_best_index_1_0 <= (((slice1winner1_best_index_1_0 / 2) + 1) * 2) + (slice1winner1_best_index_1_0 mod 2);
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
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
      slice2cost_pixels_first_0_0_count_4_value_2 := ((slice2shift_reference_0 / 16384) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_4_value_3 := ((slice2shift_reference_0 / 8192) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_5_value := ((slice2shift_reference_0 / 32768) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_5_value_2 := ((slice2shift_reference_0 / 131072) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_5_value_3 := ((slice2shift_reference_0 / 65536) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_6_value := ((slice2shift_reference_0 / 262144) mod 2) = 1;
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
      slice2cost_pixels_first_1_0_count_4_value_2 := ((slice2shift_reference_1 / 16384) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_4_value_3 := ((slice2shift_reference_1 / 8192) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_5_value := ((slice2shift_reference_1 / 32768) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_5_value_2 := ((slice2shift_reference_1 / 131072) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_5_value_3 := ((slice2shift_reference_1 / 65536) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_6_value := ((slice2shift_reference_1 / 262144) mod 2) = 1;
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
      slice2cost_pixels_first_2_0_count_4_value_2 := ((slice2shift_reference_2 / 16384) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_4_value_3 := ((slice2shift_reference_2 / 8192) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_5_value := ((slice2shift_reference_2 / 32768) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_5_value_2 := ((slice2shift_reference_2 / 131072) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_5_value_3 := ((slice2shift_reference_2 / 65536) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_6_value := ((slice2shift_reference_2 / 262144) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_0_value := ((slice2shift_reference_3 / 4) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_0_value_2 := ((slice2shift_reference_3 / 2) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_1_value := ((slice2shift_reference_3 / 8) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_1_value_2 := ((slice2shift_reference_3 / 32) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_1_value_3 := ((slice2shift_reference_3 / 16) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_2_value := ((slice2shift_reference_3 / 256) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_2_value_2 := ((slice2shift_reference_3 / 64) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_3_value := ((slice2shift_reference_3 / 512) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_3_value_2 := ((slice2shift_reference_3 / 2048) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_3_value_3 := ((slice2shift_reference_3 / 1024) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_4_value := ((slice2shift_reference_3 / 4096) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_4_value_2 := ((slice2shift_reference_3 / 16384) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_4_value_3 := ((slice2shift_reference_3 / 8192) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_5_value := ((slice2shift_reference_3 / 32768) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_5_value_2 := ((slice2shift_reference_3 / 131072) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_5_value_3 := ((slice2shift_reference_3 / 65536) mod 2) = 1;
      slice2cost_pixels_first_3_0_count_6_value := ((slice2shift_reference_3 / 262144) mod 2) = 1;
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
      slice2cost_pixels_first_0_0_count_4 <= as_number((slice2cost_pixels_first_0_0_count_4_value /=
        (((slice2shift_search_0_0 / 4096) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_4_value_2 /=
        (((slice2shift_search_0_0 / 16384) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_4_value_3 /=
        (((slice2shift_search_0_0 / 8192) mod 2) = 1)));
      slice2cost_pixels_first_0_0_count_5 <= as_number((slice2cost_pixels_first_0_0_count_5_value /=
        (((slice2shift_search_0_0 / 32768) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_5_value_2 /=
        (((slice2shift_search_0_0 / 131072) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_5_value_3 /=
        (((slice2shift_search_0_0 / 65536) mod 2) = 1)));
      slice2cost_pixels_first_0_0_count_6 <= as_number((((slice2shift_reference_0 / 524288) = 1) /=
        ((slice2shift_search_0_0 / 524288) = 1))) + as_number((slice2cost_pixels_first_0_0_count_6_value /=
        (((slice2shift_search_0_0 / 262144) mod 2) = 1)));
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
      slice2cost_pixels_first_0_1_count_4 <= as_number(((((slice2shift_search_0_1 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_1 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_1 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_1_count_5 <= as_number(((((slice2shift_search_0_1 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_1 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_1 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_1_count_6 <= as_number((((slice2shift_search_0_1 / 524288) = 1) /=
        ((slice2shift_reference_0 / 524288) = 1))) + as_number(((((slice2shift_search_0_1 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value));
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
      slice2cost_pixels_first_1_0_count_4 <= as_number((slice2cost_pixels_first_1_0_count_4_value /=
        (((slice2shift_search_1_0 / 4096) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_4_value_2 /=
        (((slice2shift_search_1_0 / 16384) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_4_value_3 /=
        (((slice2shift_search_1_0 / 8192) mod 2) = 1)));
      slice2cost_pixels_first_1_0_count_5 <= as_number((slice2cost_pixels_first_1_0_count_5_value /=
        (((slice2shift_search_1_0 / 32768) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_5_value_2 /=
        (((slice2shift_search_1_0 / 131072) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_5_value_3 /=
        (((slice2shift_search_1_0 / 65536) mod 2) = 1)));
      slice2cost_pixels_first_1_0_count_6 <= as_number((((slice2shift_reference_1 / 524288) = 1) /=
        ((slice2shift_search_1_0 / 524288) = 1))) + as_number((slice2cost_pixels_first_1_0_count_6_value /=
        (((slice2shift_search_1_0 / 262144) mod 2) = 1)));
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
      slice2cost_pixels_first_1_1_count_4 <= as_number(((((slice2shift_search_1_1 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_1 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_1 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_1_count_5 <= as_number(((((slice2shift_search_1_1 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_1 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_1 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_1_count_6 <= as_number((((slice2shift_search_1_1 / 524288) = 1) /=
        ((slice2shift_reference_1 / 524288) = 1))) + as_number(((((slice2shift_search_1_1 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value));
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
      slice2cost_pixels_first_2_0_count_4 <= as_number((slice2cost_pixels_first_2_0_count_4_value /=
        (((slice2shift_search_2_0 / 4096) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_4_value_2 /=
        (((slice2shift_search_2_0 / 16384) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_4_value_3 /=
        (((slice2shift_search_2_0 / 8192) mod 2) = 1)));
      slice2cost_pixels_first_2_0_count_5 <= as_number((slice2cost_pixels_first_2_0_count_5_value /=
        (((slice2shift_search_2_0 / 32768) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_5_value_2 /=
        (((slice2shift_search_2_0 / 131072) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_5_value_3 /=
        (((slice2shift_search_2_0 / 65536) mod 2) = 1)));
      slice2cost_pixels_first_2_0_count_6 <= as_number((((slice2shift_reference_2 / 524288) = 1) /=
        ((slice2shift_search_2_0 / 524288) = 1))) + as_number((slice2cost_pixels_first_2_0_count_6_value /=
        (((slice2shift_search_2_0 / 262144) mod 2) = 1)));
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
      slice2cost_pixels_first_2_1_count_4 <= as_number(((((slice2shift_search_2_1 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_4_value)) + as_number(((((slice2shift_search_2_1 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice2shift_search_2_1 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_4_value_3));
      slice2cost_pixels_first_2_1_count_5 <= as_number(((((slice2shift_search_2_1 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_5_value)) + as_number(((((slice2shift_search_2_1 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice2shift_search_2_1 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_5_value_3));
      slice2cost_pixels_first_2_1_count_6 <= as_number((((slice2shift_search_2_1 / 524288) = 1) /=
        ((slice2shift_reference_2 / 524288) = 1))) + as_number(((((slice2shift_search_2_1 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_6_value));
      slice2cost_pixels_first_3_0_count_0 <= as_number((((slice2shift_search_3_0 mod 2) = 1) /=
        ((slice2shift_reference_3 mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_0_value /=
        (((slice2shift_search_3_0 / 4) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_0_value_2 /=
        (((slice2shift_search_3_0 / 2) mod 2) = 1)));
      slice2cost_pixels_first_3_0_count_1 <= as_number((slice2cost_pixels_first_3_0_count_1_value /=
        (((slice2shift_search_3_0 / 8) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_1_value_2 /=
        (((slice2shift_search_3_0 / 32) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_1_value_3 /=
        (((slice2shift_search_3_0 / 16) mod 2) = 1)));
      slice2cost_pixels_first_3_0_count_2 <= (to_integer(((to_unsigned((slice2shift_search_3_0 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_3 mod 256), 8)))) / 128) +
        as_number((slice2cost_pixels_first_3_0_count_2_value /= (((slice2shift_search_3_0 / 256) mod 2) = 1))) +
        as_number((slice2cost_pixels_first_3_0_count_2_value_2 /= (((slice2shift_search_3_0 / 64) mod 2) = 1)));
      slice2cost_pixels_first_3_0_count_3 <= as_number((slice2cost_pixels_first_3_0_count_3_value /=
        (((slice2shift_search_3_0 / 512) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_3_value_2 /=
        (((slice2shift_search_3_0 / 2048) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_3_value_3 /=
        (((slice2shift_search_3_0 / 1024) mod 2) = 1)));
      slice2cost_pixels_first_3_0_count_4 <= as_number((slice2cost_pixels_first_3_0_count_4_value /=
        (((slice2shift_search_3_0 / 4096) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_4_value_2 /=
        (((slice2shift_search_3_0 / 16384) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_4_value_3 /=
        (((slice2shift_search_3_0 / 8192) mod 2) = 1)));
      slice2cost_pixels_first_3_0_count_5 <= as_number((slice2cost_pixels_first_3_0_count_5_value /=
        (((slice2shift_search_3_0 / 32768) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_5_value_2 /=
        (((slice2shift_search_3_0 / 131072) mod 2) = 1))) + as_number((slice2cost_pixels_first_3_0_count_5_value_3 /=
        (((slice2shift_search_3_0 / 65536) mod 2) = 1)));
      slice2cost_pixels_first_3_0_count_6 <= as_number((((slice2shift_reference_3 / 524288) = 1) /=
        ((slice2shift_search_3_0 / 524288) = 1))) + as_number((slice2cost_pixels_first_3_0_count_6_value /=
        (((slice2shift_search_3_0 / 262144) mod 2) = 1)));
      slice2cost_pixels_first_3_1_count_0 <= as_number((((slice2shift_search_3_1 mod 2) = 1) /=
        ((slice2shift_reference_3 mod 2) = 1))) + as_number(((((slice2shift_search_3_1 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_0_value)) + as_number(((((slice2shift_search_3_1 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_0_value_2));
      slice2cost_pixels_first_3_1_count_1 <= as_number(((((slice2shift_search_3_1 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_1_value)) + as_number(((((slice2shift_search_3_1 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_1_value_2)) + as_number(((((slice2shift_search_3_1 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_1_value_3));
      slice2cost_pixels_first_3_1_count_2 <= (to_integer(((to_unsigned((slice2shift_search_3_1 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_3 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_3_1 / 256) mod
        2) = 1) /= slice2cost_pixels_first_3_0_count_2_value)) + as_number(((((slice2shift_search_3_1 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_3_0_count_2_value_2));
      slice2cost_pixels_first_3_1_count_3 <= as_number(((((slice2shift_search_3_1 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_3_value)) + as_number(((((slice2shift_search_3_1 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_3_value_2)) + as_number(((((slice2shift_search_3_1 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_3_value_3));
      slice2cost_pixels_first_3_1_count_4 <= as_number(((((slice2shift_search_3_1 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_4_value)) + as_number(((((slice2shift_search_3_1 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_4_value_2)) + as_number(((((slice2shift_search_3_1 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_4_value_3));
      slice2cost_pixels_first_3_1_count_5 <= as_number(((((slice2shift_search_3_1 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_5_value)) + as_number(((((slice2shift_search_3_1 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_5_value_2)) + as_number(((((slice2shift_search_3_1 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_5_value_3));
      slice2cost_pixels_first_3_1_count_6 <= as_number((((slice2shift_search_3_1 / 524288) = 1) /=
        ((slice2shift_reference_3 / 524288) = 1))) + as_number(((((slice2shift_search_3_1 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_3_0_count_6_value));
      slice2cost_pixels_cost_0_0 <= slice2cost_pixels_first_0_0_count_6 + slice2cost_pixels_first_0_0_count_4 +
        slice2cost_pixels_first_0_0_count_3 + slice2cost_pixels_first_0_0_count_1 + slice2cost_pixels_first_0_0_count_5
        + slice2cost_pixels_first_0_0_count_0 + slice2cost_pixels_first_0_0_count_2;
      slice2cost_pixels_cost_0_1 <= slice2cost_pixels_first_0_1_count_6 + slice2cost_pixels_first_0_1_count_4 +
        slice2cost_pixels_first_0_1_count_3 + slice2cost_pixels_first_0_1_count_1 + slice2cost_pixels_first_0_1_count_5
        + slice2cost_pixels_first_0_1_count_0 + slice2cost_pixels_first_0_1_count_2;
      slice2cost_pixels_cost_1_0 <= slice2cost_pixels_first_1_0_count_6 + slice2cost_pixels_first_1_0_count_4 +
        slice2cost_pixels_first_1_0_count_3 + slice2cost_pixels_first_1_0_count_1 + slice2cost_pixels_first_1_0_count_5
        + slice2cost_pixels_first_1_0_count_0 + slice2cost_pixels_first_1_0_count_2;
      slice2cost_pixels_cost_1_1 <= slice2cost_pixels_first_1_1_count_6 + slice2cost_pixels_first_1_1_count_4 +
        slice2cost_pixels_first_1_1_count_3 + slice2cost_pixels_first_1_1_count_1 + slice2cost_pixels_first_1_1_count_5
        + slice2cost_pixels_first_1_1_count_0 + slice2cost_pixels_first_1_1_count_2;
      slice2cost_pixels_cost_2_0 <= slice2cost_pixels_first_2_0_count_6 + slice2cost_pixels_first_2_0_count_4 +
        slice2cost_pixels_first_2_0_count_3 + slice2cost_pixels_first_2_0_count_1 + slice2cost_pixels_first_2_0_count_5
        + slice2cost_pixels_first_2_0_count_0 + slice2cost_pixels_first_2_0_count_2;
      slice2cost_pixels_cost_2_1 <= slice2cost_pixels_first_2_1_count_6 + slice2cost_pixels_first_2_1_count_4 +
        slice2cost_pixels_first_2_1_count_3 + slice2cost_pixels_first_2_1_count_1 + slice2cost_pixels_first_2_1_count_5
        + slice2cost_pixels_first_2_1_count_0 + slice2cost_pixels_first_2_1_count_2;
      slice2cost_pixels_cost_3_0 <= slice2cost_pixels_first_3_0_count_6 + slice2cost_pixels_first_3_0_count_4 +
        slice2cost_pixels_first_3_0_count_3 + slice2cost_pixels_first_3_0_count_1 + slice2cost_pixels_first_3_0_count_5
        + slice2cost_pixels_first_3_0_count_0 + slice2cost_pixels_first_3_0_count_2;
      slice2cost_pixels_cost_3_1 <= slice2cost_pixels_first_3_1_count_6 + slice2cost_pixels_first_3_1_count_4 +
        slice2cost_pixels_first_3_1_count_3 + slice2cost_pixels_first_3_1_count_1 + slice2cost_pixels_first_3_1_count_5
        + slice2cost_pixels_first_3_1_count_0 + slice2cost_pixels_first_3_1_count_2;
      slice2cost_pair_0_0 <= slice2cost_pixels_cost_1_0 + slice2cost_pixels_cost_2_0;
      slice2cost_pair_0_1 <= slice2cost_pixels_cost_1_1 + slice2cost_pixels_cost_2_1;
      slice2cost_single_0_0 <= slice2cost_pixels_cost_0_0;
      slice2cost_single_0_1 <= slice2cost_pixels_cost_0_1;
      slice2cost_single_3_0 <= slice2cost_pixels_cost_3_0;
      slice2cost_single_3_1 <= slice2cost_pixels_cost_3_1;
      if slice1cost_tag_border_column then
        slice2cost_column_0_0 <= 0;
        slice2cost_column_0_1 <= 0;
        slice2cost_column_1_0 <= 0;
        slice2cost_column_1_1 <= 0;
      else
        slice2cost_column_0_0 <= slice2cost_pair_0_0 + slice2cost_single_0_0;
        slice2cost_column_0_1 <= slice2cost_pair_0_1 + slice2cost_single_0_1;
        slice2cost_column_1_0 <= slice2cost_pair_0_0 + slice2cost_single_3_0;
        slice2cost_column_1_1 <= slice2cost_pair_0_1 + slice2cost_single_3_1;
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
      -- slice2winner1
      if (slice2window_sum_0_0 mod 2) = 1 then
        slice2winner1_best_index_0_0_choice := (not (((slice2window_sum_0_1 / 2) mod 2) = 1)) or (not
          ((slice2window_sum_0_1 mod 2) = 1));
      else
        slice2winner1_best_index_0_0_choice := not (((slice2window_sum_0_1 / 2) mod 2) = 1);
      end if;
      if ((slice2window_sum_0_0 / 2) mod 2) = 1 then
        slice2winner1_best_index_0_0_choice_2 := slice2winner1_best_index_0_0_choice;
      else
        slice2winner1_best_index_0_0_choice_2 := ((slice2window_sum_0_0 mod 2) = 1) and ((slice2window_sum_0_1 mod 4) =
          0);
      end if;
      slice2winner1_best_index_0_0_value := ((slice2window_sum_0_1 / 4) mod 2) = 1;
      if slice2winner1_best_index_0_0_choice_2 then
        slice2winner1_best_index_0_0_choice_3 := (not (((slice2window_sum_0_0 / 4) mod 2) = 1)) and
          slice2winner1_best_index_0_0_value;
      else
        slice2winner1_best_index_0_0_choice_3 := (not (((slice2window_sum_0_0 / 4) mod 2) = 1)) or
          slice2winner1_best_index_0_0_value;
      end if;
      slice2winner1_best_index_0_0_value_2 := ((slice2window_sum_0_1 / 8) mod 2) = 1;
      if slice2winner1_best_index_0_0_choice_3 then
        slice2winner1_best_index_0_0_choice_4 := (not (((slice2window_sum_0_0 / 8) mod 2) = 1)) or
          slice2winner1_best_index_0_0_value_2;
      else
        slice2winner1_best_index_0_0_choice_4 := (not (((slice2window_sum_0_0 / 8) mod 2) = 1)) and
          slice2winner1_best_index_0_0_value_2;
      end if;
      slice2winner1_best_index_0_0_value_3 := ((slice2window_sum_0_1 / 16) mod 2) = 1;
      if slice2winner1_best_index_0_0_choice_4 then
        slice2winner1_best_index_0_0_choice_5 := (not (((slice2window_sum_0_0 / 16) mod 2) = 1)) or
          slice2winner1_best_index_0_0_value_3;
      else
        slice2winner1_best_index_0_0_choice_5 := (not (((slice2window_sum_0_0 / 16) mod 2) = 1)) and
          slice2winner1_best_index_0_0_value_3;
      end if;
      slice2winner1_best_index_0_0_value_4 := ((slice2window_sum_0_1 / 32) mod 2) = 1;
      if slice2winner1_best_index_0_0_choice_5 then
        slice2winner1_best_index_0_0_choice_6 := (not (((slice2window_sum_0_0 / 32) mod 2) = 1)) or
          slice2winner1_best_index_0_0_value_4;
      else
        slice2winner1_best_index_0_0_choice_6 := (not (((slice2window_sum_0_0 / 32) mod 2) = 1)) and
          slice2winner1_best_index_0_0_value_4;
      end if;
      slice2winner1_best_index_0_0_value_5 := ((slice2window_sum_0_1 / 64) mod 2) = 1;
      if slice2winner1_best_index_0_0_choice_6 then
        slice2winner1_best_index_0_0_choice_7 := (not (((slice2window_sum_0_0 / 64) mod 2) = 1)) or
          slice2winner1_best_index_0_0_value_5;
      else
        slice2winner1_best_index_0_0_choice_7 := (not (((slice2window_sum_0_0 / 64) mod 2) = 1)) and
          slice2winner1_best_index_0_0_value_5;
      end if;
      if (slice2window_sum_1_0 mod 2) = 1 then
        slice2winner1_best_index_1_0_choice := (not (((slice2window_sum_1_1 / 2) mod 2) = 1)) or (not
          ((slice2window_sum_1_1 mod 2) = 1));
      else
        slice2winner1_best_index_1_0_choice := not (((slice2window_sum_1_1 / 2) mod 2) = 1);
      end if;
      if ((slice2window_sum_1_0 / 2) mod 2) = 1 then
        slice2winner1_best_index_1_0_choice_2 := slice2winner1_best_index_1_0_choice;
      else
        slice2winner1_best_index_1_0_choice_2 := ((slice2window_sum_1_0 mod 2) = 1) and ((slice2window_sum_1_1 mod 4) =
          0);
      end if;
      slice2winner1_best_index_1_0_value := ((slice2window_sum_1_1 / 4) mod 2) = 1;
      if slice2winner1_best_index_1_0_choice_2 then
        slice2winner1_best_index_1_0_choice_3 := (not (((slice2window_sum_1_0 / 4) mod 2) = 1)) and
          slice2winner1_best_index_1_0_value;
      else
        slice2winner1_best_index_1_0_choice_3 := (not (((slice2window_sum_1_0 / 4) mod 2) = 1)) or
          slice2winner1_best_index_1_0_value;
      end if;
      slice2winner1_best_index_1_0_value_2 := ((slice2window_sum_1_1 / 8) mod 2) = 1;
      if slice2winner1_best_index_1_0_choice_3 then
        slice2winner1_best_index_1_0_choice_4 := (not (((slice2window_sum_1_0 / 8) mod 2) = 1)) or
          slice2winner1_best_index_1_0_value_2;
      else
        slice2winner1_best_index_1_0_choice_4 := (not (((slice2window_sum_1_0 / 8) mod 2) = 1)) and
          slice2winner1_best_index_1_0_value_2;
      end if;
      slice2winner1_best_index_1_0_value_3 := ((slice2window_sum_1_1 / 16) mod 2) = 1;
      if slice2winner1_best_index_1_0_choice_4 then
        slice2winner1_best_index_1_0_choice_5 := (not (((slice2window_sum_1_0 / 16) mod 2) = 1)) or
          slice2winner1_best_index_1_0_value_3;
      else
        slice2winner1_best_index_1_0_choice_5 := (not (((slice2window_sum_1_0 / 16) mod 2) = 1)) and
          slice2winner1_best_index_1_0_value_3;
      end if;
      slice2winner1_best_index_1_0_value_4 := ((slice2window_sum_1_1 / 32) mod 2) = 1;
      if slice2winner1_best_index_1_0_choice_5 then
        slice2winner1_best_index_1_0_choice_6 := (not (((slice2window_sum_1_0 / 32) mod 2) = 1)) or
          slice2winner1_best_index_1_0_value_4;
      else
        slice2winner1_best_index_1_0_choice_6 := (not (((slice2window_sum_1_0 / 32) mod 2) = 1)) and
          slice2winner1_best_index_1_0_value_4;
      end if;
      slice2winner1_best_index_1_0_value_5 := ((slice2window_sum_1_1 / 64) mod 2) = 1;
      if slice2winner1_best_index_1_0_choice_6 then
        slice2winner1_best_index_1_0_choice_7 := (not (((slice2window_sum_1_0 / 64) mod 2) = 1)) or
          slice2winner1_best_index_1_0_value_5;
      else
        slice2winner1_best_index_1_0_choice_7 := (not (((slice2window_sum_1_0 / 64) mod 2) = 1)) and
          slice2winner1_best_index_1_0_value_5;
      end if;
      if (slice2window_sum_0_1 - slice2window_sum_0_0) < 0 then
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_1;
      else
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_0;
      end if;
      if (slice2window_sum_1_1 - slice2window_sum_1_0) < 0 then
        slice2winner1_best_cost_1_0 <= slice2window_sum_1_1;
      else
        slice2winner1_best_cost_1_0 <= slice2window_sum_1_0;
      end if;
      if slice2winner1_best_index_0_0_choice_7 then
        slice2winner1_best_index_0_0 <= ((slice2window_sum_0_0 / 128) = 1) and (not ((slice2window_sum_0_1 / 128) = 1));
      else
        slice2winner1_best_index_0_0 <= ((slice2window_sum_0_0 / 128) = 1) or (not ((slice2window_sum_0_1 / 128) = 1));
      end if;
      if slice2winner1_best_index_1_0_choice_7 then
        slice2winner1_best_index_1_0 <= ((slice2window_sum_1_0 / 128) = 1) and (not ((slice2window_sum_1_1 / 128) = 1));
      else
        slice2winner1_best_index_1_0 <= ((slice2window_sum_1_0 / 128) = 1) or (not ((slice2window_sum_1_1 / 128) = 1));
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
      if (slice2winner3_best_cost_0_0 mod 2) = 1 then
        slice2_best_index_0_0_choice := (not (((slice1_best_cost_0_0 / 2) mod 2) = 1)) or (not ((slice1_best_cost_0_0
          mod 2) = 1));
      else
        slice2_best_index_0_0_choice := not (((slice1_best_cost_0_0 / 2) mod 2) = 1);
      end if;
      if ((slice2winner3_best_cost_0_0 / 2) mod 2) = 1 then
        slice2_best_index_0_0_choice_2 := slice2_best_index_0_0_choice;
      else
        slice2_best_index_0_0_choice_2 := ((slice2winner3_best_cost_0_0 mod 2) = 1) and ((slice1_best_cost_0_0 mod 4) =
          0);
      end if;
      slice2_best_index_0_0_value := ((slice1_best_cost_0_0 / 4) mod 2) = 1;
      if slice2_best_index_0_0_choice_2 then
        slice2_best_index_0_0_choice_3 := (not (((slice2winner3_best_cost_0_0 / 4) mod 2) = 1)) and
          slice2_best_index_0_0_value;
      else
        slice2_best_index_0_0_choice_3 := (not (((slice2winner3_best_cost_0_0 / 4) mod 2) = 1)) or
          slice2_best_index_0_0_value;
      end if;
      slice2_best_index_0_0_value_2 := ((slice1_best_cost_0_0 / 8) mod 2) = 1;
      if slice2_best_index_0_0_choice_3 then
        slice2_best_index_0_0_choice_4 := (not (((slice2winner3_best_cost_0_0 / 8) mod 2) = 1)) or
          slice2_best_index_0_0_value_2;
      else
        slice2_best_index_0_0_choice_4 := (not (((slice2winner3_best_cost_0_0 / 8) mod 2) = 1)) and
          slice2_best_index_0_0_value_2;
      end if;
      slice2_best_index_0_0_value_3 := ((slice1_best_cost_0_0 / 16) mod 2) = 1;
      if slice2_best_index_0_0_choice_4 then
        slice2_best_index_0_0_choice_5 := (not (((slice2winner3_best_cost_0_0 / 16) mod 2) = 1)) or
          slice2_best_index_0_0_value_3;
      else
        slice2_best_index_0_0_choice_5 := (not (((slice2winner3_best_cost_0_0 / 16) mod 2) = 1)) and
          slice2_best_index_0_0_value_3;
      end if;
      slice2_best_index_0_0_value_4 := ((slice1_best_cost_0_0 / 32) mod 2) = 1;
      if slice2_best_index_0_0_choice_5 then
        slice2_best_index_0_0_choice_6 := (not (((slice2winner3_best_cost_0_0 / 32) mod 2) = 1)) or
          slice2_best_index_0_0_value_4;
      else
        slice2_best_index_0_0_choice_6 := (not (((slice2winner3_best_cost_0_0 / 32) mod 2) = 1)) and
          slice2_best_index_0_0_value_4;
      end if;
      slice2_best_index_0_0_value_5 := ((slice1_best_cost_0_0 / 64) mod 2) = 1;
      if slice2_best_index_0_0_choice_6 then
        slice2_best_index_0_0_choice_7 := (not (((slice2winner3_best_cost_0_0 / 64) mod 2) = 1)) or
          slice2_best_index_0_0_value_5;
      else
        slice2_best_index_0_0_choice_7 := (not (((slice2winner3_best_cost_0_0 / 64) mod 2) = 1)) and
          slice2_best_index_0_0_value_5;
      end if;
      if slice2_best_index_0_0_choice_7 then
        slice2_best_index_0_0_choice_8 := ((slice2winner3_best_cost_0_0 / 128) = 1) and (not ((slice1_best_cost_0_0 /
          128) = 1));
      else
        slice2_best_index_0_0_choice_8 := ((slice2winner3_best_cost_0_0 / 128) = 1) or (not ((slice1_best_cost_0_0 /
          128) = 1));
      end if;
      if (slice2winner3_best_cost_1_0 mod 2) = 1 then
        slice2_best_index_1_0_choice := (not (((slice1_best_cost_1_0 / 2) mod 2) = 1)) or (not ((slice1_best_cost_1_0
          mod 2) = 1));
      else
        slice2_best_index_1_0_choice := not (((slice1_best_cost_1_0 / 2) mod 2) = 1);
      end if;
      if ((slice2winner3_best_cost_1_0 / 2) mod 2) = 1 then
        slice2_best_index_1_0_choice_2 := slice2_best_index_1_0_choice;
      else
        slice2_best_index_1_0_choice_2 := ((slice2winner3_best_cost_1_0 mod 2) = 1) and ((slice1_best_cost_1_0 mod 4) =
          0);
      end if;
      slice2_best_index_1_0_value := ((slice1_best_cost_1_0 / 4) mod 2) = 1;
      if slice2_best_index_1_0_choice_2 then
        slice2_best_index_1_0_choice_3 := (not (((slice2winner3_best_cost_1_0 / 4) mod 2) = 1)) and
          slice2_best_index_1_0_value;
      else
        slice2_best_index_1_0_choice_3 := (not (((slice2winner3_best_cost_1_0 / 4) mod 2) = 1)) or
          slice2_best_index_1_0_value;
      end if;
      slice2_best_index_1_0_value_2 := ((slice1_best_cost_1_0 / 8) mod 2) = 1;
      if slice2_best_index_1_0_choice_3 then
        slice2_best_index_1_0_choice_4 := (not (((slice2winner3_best_cost_1_0 / 8) mod 2) = 1)) or
          slice2_best_index_1_0_value_2;
      else
        slice2_best_index_1_0_choice_4 := (not (((slice2winner3_best_cost_1_0 / 8) mod 2) = 1)) and
          slice2_best_index_1_0_value_2;
      end if;
      slice2_best_index_1_0_value_3 := ((slice1_best_cost_1_0 / 16) mod 2) = 1;
      if slice2_best_index_1_0_choice_4 then
        slice2_best_index_1_0_choice_5 := (not (((slice2winner3_best_cost_1_0 / 16) mod 2) = 1)) or
          slice2_best_index_1_0_value_3;
      else
        slice2_best_index_1_0_choice_5 := (not (((slice2winner3_best_cost_1_0 / 16) mod 2) = 1)) and
          slice2_best_index_1_0_value_3;
      end if;
      slice2_best_index_1_0_value_4 := ((slice1_best_cost_1_0 / 32) mod 2) = 1;
      if slice2_best_index_1_0_choice_5 then
        slice2_best_index_1_0_choice_6 := (not (((slice2winner3_best_cost_1_0 / 32) mod 2) = 1)) or
          slice2_best_index_1_0_value_4;
      else
        slice2_best_index_1_0_choice_6 := (not (((slice2winner3_best_cost_1_0 / 32) mod 2) = 1)) and
          slice2_best_index_1_0_value_4;
      end if;
      slice2_best_index_1_0_value_5 := ((slice1_best_cost_1_0 / 64) mod 2) = 1;
      if slice2_best_index_1_0_choice_6 then
        slice2_best_index_1_0_choice_7 := (not (((slice2winner3_best_cost_1_0 / 64) mod 2) = 1)) or
          slice2_best_index_1_0_value_5;
      else
        slice2_best_index_1_0_choice_7 := (not (((slice2winner3_best_cost_1_0 / 64) mod 2) = 1)) and
          slice2_best_index_1_0_value_5;
      end if;
      if slice2_best_index_1_0_choice_7 then
        slice2_best_index_1_0_choice_8 := ((slice2winner3_best_cost_1_0 / 128) = 1) and (not ((slice1_best_cost_1_0 /
          128) = 1));
      else
        slice2_best_index_1_0_choice_8 := ((slice2winner3_best_cost_1_0 / 128) = 1) or (not ((slice1_best_cost_1_0 /
          128) = 1));
      end if;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if slice2_best_index_0_0_choice_8 then
        slice2_best_index_0_0 <= slice1_best_index_0_0;
      else
        slice2_best_index_0_0 <= as_number(slice2winner3_best_index_0_0);
      end if;
      if slice2_best_index_1_0_choice_8 then
        slice2_best_index_1_0 <= slice1_best_index_1_0;
      else
        slice2_best_index_1_0 <= as_number(slice2winner3_best_index_1_0);
      end if;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 7;
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
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_tag_valid <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_centre_output_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
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
        slice0_best_tag_valid <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_output_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
