-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration census_450_full: 450x375, 48 disparities, window 9x9, 1 pixel pair a clock.
-- Options: disparities 48, window_px 9, reference left, cost census, census_width_px 9, census_pattern
--   even_columns, subpixel true, median true, full_width true, aggregation recursive, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config census_450_full
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_census_450_full is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 48;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 442;
    latency_clocks : positive := 49;
    flush_groups : positive := 3155;
    gap_groups : positive := 1800
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 450 report "stereo_core_census_450_full: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_census_450_full: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 48 report "stereo_core_census_450_full: disparities is " & integer'image(disparities) & " but this core has 48" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_census_450_full: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_census_450_full: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 442 report "stereo_core_census_450_full: output_width_px is " & integer'image(output_width_px) & " but this core has 442" severity failure;
  assert latency_clocks = 49 report "stereo_core_census_450_full: latency_clocks is " & integer'image(latency_clocks) & " but this core has 49" severity failure;
  assert flush_groups = 3155 report "stereo_core_census_450_full: flush_groups is " & integer'image(flush_groups) & " but this core has 3155" severity failure;
  assert gap_groups = 1800 report "stereo_core_census_450_full: gap_groups is " & integer'image(gap_groups) & " but this core has 1800" severity failure;
end entity;

architecture rtl of stereo_core_census_450_full is
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
  signal transform_read_row_inside_4, transform_read_column_inside_0, transform_read_column_inside_2 : boolean;
  signal transform_read_column_inside_4, transform_read_column_inside_6, transform_read_column_inside_8 : boolean;
  signal transform_read_start_of_frame, transform_read_valid, transform_ready_row_inside_0 : boolean;
  signal transform_ready_row_inside_1, transform_ready_row_inside_2, transform_ready_row_inside_3 : boolean;
  signal transform_ready_row_inside_4, transform_ready_column_inside_0, transform_ready_column_inside_2 : boolean;
  signal transform_ready_column_inside_4, transform_ready_column_inside_6, transform_ready_column_inside_8 : boolean;
  signal transform_ready_start_of_frame, transform_ready_valid, transform_columns_row_inside_0 : boolean;
  signal transform_columns_row_inside_1, transform_columns_row_inside_2, transform_columns_row_inside_3 : boolean;
  signal transform_columns_row_inside_4, transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_column_inside_4, transform_columns_column_inside_6 : boolean;
  signal transform_columns_column_inside_8, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_row_inside_4, transform_filtering_0_column_inside_0 : boolean;
  signal transform_filtering_0_column_inside_2, transform_filtering_0_column_inside_4 : boolean;
  signal transform_filtering_0_column_inside_6, transform_filtering_0_column_inside_8 : boolean;
  signal transform_filtering_0_start_of_frame, transform_filtering_0_valid : boolean;
  signal transform_filtering_1_row_inside_4, transform_filtering_1_column_inside_4 : boolean;
  signal transform_filtering_1_start_of_frame, transform_filtering_1_valid : boolean;
  signal transform_counter_column, transform_counter_group, transform_read_column : natural range 0 to 511;
  signal transform_ready_column, transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16777215;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16777215;
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16777215;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside_0, delay_row_inside_1, delay_tag_valid, delay_tag_row_start, delay_tag_first_group : boolean;
  signal delay_tag_leaves_window, delay_tag_map_column, delay_tag_first_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_words_2, rows_search_rows_read_words_3 : unsigned(23 downto 0);
  signal rows_search_rows_read_words_4, rows_search_rows_read_words_5 : unsigned(23 downto 0);
  signal rows_search_rows_read_words_6, rows_search_rows_read_words_7 : unsigned(23 downto 0);
  signal rows_search_rows_read_words_8, rows_reference_rows_read_words_0 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_1, rows_reference_rows_read_words_2 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_3, rows_reference_rows_read_words_4 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_5, rows_reference_rows_read_words_6 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_7, rows_reference_rows_read_words_8 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_words_0 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words_1, rows_search_rows_ready_words_2 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words_3, rows_search_rows_ready_words_4 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words_5, rows_search_rows_ready_words_6 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words_7, rows_search_rows_ready_words_8 : natural range 0 to 16777215;
  signal rows_search_rows_ready_newest_0, rows_search_rows_write_words_0 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_1, rows_search_rows_write_words_2 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_3, rows_search_rows_write_words_4 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_5, rows_search_rows_write_words_6 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_7, rows_search_rows_write_words_8 : natural range 0 to 16777215;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_words_0 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_1, rows_reference_rows_ready_words_2 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_3, rows_reference_rows_ready_words_4 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_5, rows_reference_rows_ready_words_6 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_7, rows_reference_rows_ready_words_8 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_newest_0, rows_reference_rows_write_words_0 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_1, rows_reference_rows_write_words_2 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_3, rows_reference_rows_write_words_4 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_5, rows_reference_rows_write_words_6 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_7, rows_reference_rows_write_words_8 : natural range 0 to 16777215;
  signal rows_search_0, rows_search_1, rows_reference_0, rows_reference_1 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_tag_valid, rows_read_tag_row_start : boolean;
  signal rows_read_tag_first_group, rows_read_tag_leaves_window, rows_read_tag_map_column : boolean;
  signal rows_read_tag_first_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside_0, rows_ready_inside_1, rows_ready_tag_valid, rows_ready_tag_row_start : boolean;
  signal rows_ready_tag_first_group, rows_ready_tag_leaves_window, rows_ready_tag_map_column : boolean;
  signal rows_ready_tag_first_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_row_start, rows_tag_first_group, rows_tag_leaves_window : boolean;
  signal rows_tag_map_column, rows_tag_first_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 16777215;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 16777215;
  signal slice0shift_search_0_6, slice0shift_search_0_7, slice0shift_search_0_8 : natural range 0 to 16777215;
  signal slice0shift_search_0_9, slice0shift_search_0_10, slice0shift_search_0_11 : natural range 0 to 16777215;
  signal slice0shift_search_0_12, slice0shift_search_0_13, slice0shift_search_0_14 : natural range 0 to 16777215;
  signal slice0shift_search_0_15, slice0shift_search_1_0, slice0shift_search_1_1 : natural range 0 to 16777215;
  signal slice0shift_search_1_2, slice0shift_search_1_3, slice0shift_search_1_4 : natural range 0 to 16777215;
  signal slice0shift_search_1_5, slice0shift_search_1_6, slice0shift_search_1_7 : natural range 0 to 16777215;
  signal slice0shift_search_1_8, slice0shift_search_1_9, slice0shift_search_1_10 : natural range 0 to 16777215;
  signal slice0shift_search_1_11, slice0shift_search_1_12, slice0shift_search_1_13 : natural range 0 to 16777215;
  signal slice0shift_search_1_14, slice0shift_search_1_15, slice0shift_reference_0 : natural range 0 to 16777215;
  signal slice0shift_reference_1, slice0shift_search_out_0, slice0shift_search_out_1 : natural range 0 to 16777215;
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_leaves_window, slice0shift_tag_map_column, slice0shift_tag_first_column : boolean;
  signal slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0_count_0, slice0cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_2, slice0cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_4, slice0cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_6, slice0cost_pixels_first_0_0_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_0, slice0cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_2, slice0cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_4, slice0cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_6, slice0cost_pixels_first_0_1_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_0, slice0cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_2, slice0cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_4, slice0cost_pixels_first_0_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_6, slice0cost_pixels_first_0_2_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_0, slice0cost_pixels_first_0_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_2, slice0cost_pixels_first_0_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_4, slice0cost_pixels_first_0_3_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_6, slice0cost_pixels_first_0_3_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_0, slice0cost_pixels_first_0_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_2, slice0cost_pixels_first_0_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_4, slice0cost_pixels_first_0_4_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_6, slice0cost_pixels_first_0_4_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_5_count_0, slice0cost_pixels_first_0_5_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_5_count_2, slice0cost_pixels_first_0_5_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_5_count_4, slice0cost_pixels_first_0_5_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_5_count_6, slice0cost_pixels_first_0_5_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_6_count_0, slice0cost_pixels_first_0_6_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_6_count_2, slice0cost_pixels_first_0_6_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_6_count_4, slice0cost_pixels_first_0_6_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_6_count_6, slice0cost_pixels_first_0_6_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_7_count_0, slice0cost_pixels_first_0_7_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_7_count_2, slice0cost_pixels_first_0_7_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_7_count_4, slice0cost_pixels_first_0_7_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_7_count_6, slice0cost_pixels_first_0_7_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_8_count_0, slice0cost_pixels_first_0_8_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_8_count_2, slice0cost_pixels_first_0_8_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_8_count_4, slice0cost_pixels_first_0_8_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_8_count_6, slice0cost_pixels_first_0_8_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_9_count_0, slice0cost_pixels_first_0_9_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_9_count_2, slice0cost_pixels_first_0_9_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_9_count_4, slice0cost_pixels_first_0_9_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_9_count_6, slice0cost_pixels_first_0_9_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_10_count_0, slice0cost_pixels_first_0_10_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_10_count_2, slice0cost_pixels_first_0_10_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_10_count_4, slice0cost_pixels_first_0_10_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_10_count_6, slice0cost_pixels_first_0_10_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_11_count_0, slice0cost_pixels_first_0_11_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_11_count_2, slice0cost_pixels_first_0_11_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_11_count_4, slice0cost_pixels_first_0_11_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_11_count_6, slice0cost_pixels_first_0_11_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_12_count_0, slice0cost_pixels_first_0_12_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_12_count_2, slice0cost_pixels_first_0_12_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_12_count_4, slice0cost_pixels_first_0_12_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_12_count_6, slice0cost_pixels_first_0_12_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_13_count_0, slice0cost_pixels_first_0_13_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_13_count_2, slice0cost_pixels_first_0_13_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_13_count_4, slice0cost_pixels_first_0_13_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_13_count_6, slice0cost_pixels_first_0_13_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_14_count_0, slice0cost_pixels_first_0_14_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_14_count_2, slice0cost_pixels_first_0_14_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_14_count_4, slice0cost_pixels_first_0_14_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_14_count_6, slice0cost_pixels_first_0_14_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_15_count_0, slice0cost_pixels_first_0_15_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_15_count_2, slice0cost_pixels_first_0_15_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_15_count_4, slice0cost_pixels_first_0_15_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_15_count_6, slice0cost_pixels_first_0_15_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_0, slice0cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_2, slice0cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_4, slice0cost_pixels_first_1_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_6, slice0cost_pixels_first_1_0_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_0, slice0cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_2, slice0cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_4, slice0cost_pixels_first_1_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_6, slice0cost_pixels_first_1_1_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_0, slice0cost_pixels_first_1_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_2, slice0cost_pixels_first_1_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_4, slice0cost_pixels_first_1_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_6, slice0cost_pixels_first_1_2_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_0, slice0cost_pixels_first_1_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_2, slice0cost_pixels_first_1_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_4, slice0cost_pixels_first_1_3_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_6, slice0cost_pixels_first_1_3_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_0, slice0cost_pixels_first_1_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_2, slice0cost_pixels_first_1_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_4, slice0cost_pixels_first_1_4_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_6, slice0cost_pixels_first_1_4_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_5_count_0, slice0cost_pixels_first_1_5_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_5_count_2, slice0cost_pixels_first_1_5_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_5_count_4, slice0cost_pixels_first_1_5_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_5_count_6, slice0cost_pixels_first_1_5_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_6_count_0, slice0cost_pixels_first_1_6_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_6_count_2, slice0cost_pixels_first_1_6_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_6_count_4, slice0cost_pixels_first_1_6_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_6_count_6, slice0cost_pixels_first_1_6_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_7_count_0, slice0cost_pixels_first_1_7_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_7_count_2, slice0cost_pixels_first_1_7_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_7_count_4, slice0cost_pixels_first_1_7_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_7_count_6, slice0cost_pixels_first_1_7_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_8_count_0, slice0cost_pixels_first_1_8_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_8_count_2, slice0cost_pixels_first_1_8_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_8_count_4, slice0cost_pixels_first_1_8_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_8_count_6, slice0cost_pixels_first_1_8_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_9_count_0, slice0cost_pixels_first_1_9_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_9_count_2, slice0cost_pixels_first_1_9_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_9_count_4, slice0cost_pixels_first_1_9_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_9_count_6, slice0cost_pixels_first_1_9_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_10_count_0, slice0cost_pixels_first_1_10_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_10_count_2, slice0cost_pixels_first_1_10_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_10_count_4, slice0cost_pixels_first_1_10_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_10_count_6, slice0cost_pixels_first_1_10_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_11_count_0, slice0cost_pixels_first_1_11_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_11_count_2, slice0cost_pixels_first_1_11_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_11_count_4, slice0cost_pixels_first_1_11_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_11_count_6, slice0cost_pixels_first_1_11_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_12_count_0, slice0cost_pixels_first_1_12_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_12_count_2, slice0cost_pixels_first_1_12_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_12_count_4, slice0cost_pixels_first_1_12_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_12_count_6, slice0cost_pixels_first_1_12_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_13_count_0, slice0cost_pixels_first_1_13_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_13_count_2, slice0cost_pixels_first_1_13_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_13_count_4, slice0cost_pixels_first_1_13_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_13_count_6, slice0cost_pixels_first_1_13_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_14_count_0, slice0cost_pixels_first_1_14_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_14_count_2, slice0cost_pixels_first_1_14_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_14_count_4, slice0cost_pixels_first_1_14_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_14_count_6, slice0cost_pixels_first_1_14_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_15_count_0, slice0cost_pixels_first_1_15_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_15_count_2, slice0cost_pixels_first_1_15_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_15_count_4, slice0cost_pixels_first_1_15_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_15_count_6, slice0cost_pixels_first_1_15_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_map_column, slice0cost_pixels_first_tag_first_column : boolean;
  signal slice0cost_pixels_first_tag_start_of_frame, slice0cost_pixels_first_tag_end_of_line : boolean;
  signal slice0cost_pixels_tag_valid, slice0cost_pixels_tag_row_start, slice0cost_pixels_tag_first_group : boolean;
  signal slice0cost_pixels_tag_leaves_window, slice0cost_pixels_tag_map_column : boolean;
  signal slice0cost_pixels_tag_first_column, slice0cost_pixels_tag_start_of_frame : boolean;
  signal slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid, slice0cost_ready_tag_row_start : boolean;
  signal slice0cost_ready_tag_first_group, slice0cost_ready_tag_leaves_window : boolean;
  signal slice0cost_ready_tag_map_column, slice0cost_ready_tag_first_column : boolean;
  signal slice0cost_ready_tag_start_of_frame, slice0cost_ready_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_row_start, slice0cost_tag_first_group, slice0cost_tag_leaves_window : boolean;
  signal slice0cost_tag_map_column, slice0cost_tag_first_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 24;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_0_5 : natural range 0 to 24;
  signal slice0cost_pixels_cost_0_6, slice0cost_pixels_cost_0_7, slice0cost_pixels_cost_0_8 : natural range 0 to 24;
  signal slice0cost_pixels_cost_0_9, slice0cost_pixels_cost_0_10, slice0cost_pixels_cost_0_11 : natural range 0 to 24;
  signal slice0cost_pixels_cost_0_12, slice0cost_pixels_cost_0_13, slice0cost_pixels_cost_0_14 : natural range 0 to 24;
  signal slice0cost_pixels_cost_0_15, slice0cost_pixels_cost_1_0, slice0cost_pixels_cost_1_1 : natural range 0 to 24;
  signal slice0cost_pixels_cost_1_2, slice0cost_pixels_cost_1_3, slice0cost_pixels_cost_1_4 : natural range 0 to 24;
  signal slice0cost_pixels_cost_1_5, slice0cost_pixels_cost_1_6, slice0cost_pixels_cost_1_7 : natural range 0 to 24;
  signal slice0cost_pixels_cost_1_8, slice0cost_pixels_cost_1_9, slice0cost_pixels_cost_1_10 : natural range 0 to 24;
  signal slice0cost_pixels_cost_1_11, slice0cost_pixels_cost_1_12, slice0cost_pixels_cost_1_13 : natural range 0 to 24;
  signal slice0cost_pixels_cost_1_14, slice0cost_pixels_cost_1_15 : natural range 0 to 24;
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 511;
  signal slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words_0, slice0cost_read_words_1, slice0cost_read_words_2 : unsigned(31 downto 0);
  signal slice0cost_read_words_3, slice0cost_ready_words_0, slice0cost_ready_words_1 : unsigned(31 downto 0);
  signal slice0cost_ready_words_2, slice0cost_ready_words_3, slice0cost_write_words_0 : unsigned(31 downto 0);
  signal slice0cost_write_words_1, slice0cost_write_words_2, slice0cost_write_words_3 : unsigned(31 downto 0);
  signal slice0cost_change_0_0, slice0cost_change_0_1, slice0cost_change_0_2 : integer range -24 to 24;
  signal slice0cost_change_0_3, slice0cost_change_0_4, slice0cost_change_0_5 : integer range -24 to 24;
  signal slice0cost_change_0_6, slice0cost_change_0_7, slice0cost_change_0_8 : integer range -24 to 24;
  signal slice0cost_change_0_9, slice0cost_change_0_10, slice0cost_change_0_11 : integer range -24 to 24;
  signal slice0cost_change_0_12, slice0cost_change_0_13, slice0cost_change_0_14 : integer range -24 to 24;
  signal slice0cost_change_0_15 : integer range -24 to 24;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 255;
  signal slice0cost_column_0_3, slice0cost_column_0_4, slice0cost_column_0_5 : natural range 0 to 255;
  signal slice0cost_column_0_6, slice0cost_column_0_7, slice0cost_column_0_8 : natural range 0 to 255;
  signal slice0cost_column_0_9, slice0cost_column_0_10, slice0cost_column_0_11 : natural range 0 to 255;
  signal slice0cost_column_0_12, slice0cost_column_0_13, slice0cost_column_0_14 : natural range 0 to 255;
  signal slice0cost_column_0_15 : natural range 0 to 255;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving_0, slice0window_leaving_1, slice0window_leaving_2 : unsigned(31 downto 0);
  signal slice0window_leaving_3 : unsigned(31 downto 0);
  signal slice0window_entering_0_0, slice0window_entering_0_1, slice0window_entering_0_2 : natural range 0 to 255;
  signal slice0window_entering_0_3, slice0window_entering_0_4, slice0window_entering_0_5 : natural range 0 to 255;
  signal slice0window_entering_0_6, slice0window_entering_0_7, slice0window_entering_0_8 : natural range 0 to 255;
  signal slice0window_entering_0_9, slice0window_entering_0_10, slice0window_entering_0_11 : natural range 0 to 255;
  signal slice0window_entering_0_12, slice0window_entering_0_13, slice0window_entering_0_14 : natural range 0 to 255;
  signal slice0window_entering_0_15 : natural range 0 to 255;
  signal slice0window_entering_tag_valid, slice0window_entering_tag_row_start : boolean;
  signal slice0window_entering_tag_first_group, slice0window_entering_tag_leaves_window : boolean;
  signal slice0window_entering_tag_map_column, slice0window_entering_tag_first_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_row_start : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_map_column : boolean;
  signal slice0window_change_tag_first_column, slice0window_change_tag_start_of_frame : boolean;
  signal slice0window_change_tag_end_of_line, slice0window_centre_map_column_0 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_first_column_1 : boolean;
  signal slice0window_centre_first_column_2, slice0window_centre_first_column_3 : boolean;
  signal slice0window_centre_start_of_frame_0, slice0window_centre_start_of_frame_3 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_first_column : boolean;
  signal slice0window_tag_start_of_frame : boolean;
  signal slice0window_change_0_0, slice0window_change_0_1, slice0window_change_0_2 : integer range -255 to 255;
  signal slice0window_change_0_3, slice0window_change_0_4, slice0window_change_0_5 : integer range -255 to 255;
  signal slice0window_change_0_6, slice0window_change_0_7, slice0window_change_0_8 : integer range -255 to 255;
  signal slice0window_change_0_9, slice0window_change_0_10, slice0window_change_0_11 : integer range -255 to 255;
  signal slice0window_change_0_12, slice0window_change_0_13, slice0window_change_0_14 : integer range -255 to 255;
  signal slice0window_change_0_15 : integer range -255 to 255;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 2047;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 2047;
  signal slice0window_sum_0_6, slice0window_sum_0_7, slice0window_sum_0_8 : natural range 0 to 2047;
  signal slice0window_sum_0_9, slice0window_sum_0_10, slice0window_sum_0_11 : natural range 0 to 2047;
  signal slice0window_sum_0_12, slice0window_sum_0_13, slice0window_sum_0_14 : natural range 0 to 2047;
  signal slice0window_sum_0_15 : natural range 0 to 2047;
  -- slice0mask
  signal slice0mask_inside_0, slice0mask_inside_1, slice0mask_inside_2, slice0mask_inside_3 : boolean;
  signal slice0mask_inside_4, slice0mask_inside_5, slice0mask_inside_6, slice0mask_inside_7 : boolean;
  signal slice0mask_inside_8, slice0mask_inside_9, slice0mask_inside_10, slice0mask_inside_11 : boolean;
  signal slice0mask_inside_12, slice0mask_inside_13, slice0mask_inside_14, slice0mask_inside_15 : boolean;
  signal slice0mask_left_out : boolean;
  signal slice0mask_column : natural range 0 to 511;
  -- slice0winner1
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_cost_0_2, slice0winner1_best_cost_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_cost_0_4, slice0winner1_best_cost_0_5 : natural range 0 to 2047;
  signal slice0winner1_best_cost_0_6, slice0winner1_best_cost_0_7 : natural range 0 to 2047;
  signal slice0winner1_best_below_0_0, slice0winner1_best_below_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_below_0_2, slice0winner1_best_below_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_below_0_4, slice0winner1_best_below_0_5 : natural range 0 to 2047;
  signal slice0winner1_best_below_0_6, slice0winner1_best_below_0_7 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_0, slice0winner1_best_above_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_2, slice0winner1_best_above_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_4, slice0winner1_best_above_0_5 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_6, slice0winner1_best_above_0_7 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_1, slice0winner1_best_first_0_2 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_3, slice0winner1_best_first_0_4 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_5, slice0winner1_best_first_0_6 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_7, slice0winner1_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_1, slice0winner1_best_last_0_2 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_3, slice0winner1_best_last_0_4 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_5, slice0winner1_best_last_0_6 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_7 : natural range 0 to 2047;
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_map_column : boolean;
  signal slice0winner1_tag_first_column, slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  signal slice0winner1_best_index_0_4 : natural range 0 to 9;
  signal slice0winner1_best_index_0_5 : natural range 0 to 11;
  signal slice0winner1_best_index_0_6 : natural range 0 to 13;
  signal slice0winner1_best_index_0_7 : natural range 0 to 15;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_cost_0_2, slice0winner2_best_cost_0_3 : natural range 0 to 2047;
  signal slice0winner2_best_below_0_0, slice0winner2_best_below_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_below_0_2, slice0winner2_best_below_0_3 : natural range 0 to 2047;
  signal slice0winner2_best_above_0_0, slice0winner2_best_above_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_above_0_2, slice0winner2_best_above_0_3 : natural range 0 to 2047;
  signal slice0winner2_best_first_0_1, slice0winner2_best_first_0_2 : natural range 0 to 2047;
  signal slice0winner2_best_first_0_3, slice0winner2_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner2_best_last_0_1, slice0winner2_best_last_0_2 : natural range 0 to 2047;
  signal slice0winner2_best_last_0_3 : natural range 0 to 2047;
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2 : natural range 0 to 11;
  signal slice0winner2_best_index_0_3 : natural range 0 to 15;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_cost_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_below_0_0, slice0winner3_best_below_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_above_0_0, slice0winner3_best_above_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_first_0_1, slice0winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner3_best_last_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 15;
  signal slice0winner3_tag_valid, slice0winner3_tag_map_column, slice0winner3_tag_start_of_frame : boolean;
  signal slice0winner3_tag_end_of_line : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_above_0_0, slice0winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_tag_valid, slice0winner4_tag_map_column, slice0winner4_tag_start_of_frame : boolean;
  signal slice0winner4_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_below_0_0, slice0_best_above_0_0 : natural range 0 to 2047;
  signal slice0_best_last_0_0 : natural range 0 to 2047;
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 16777215;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 16777215;
  signal slice1shift_search_0_6, slice1shift_search_0_7, slice1shift_search_0_8 : natural range 0 to 16777215;
  signal slice1shift_search_0_9, slice1shift_search_0_10, slice1shift_search_0_11 : natural range 0 to 16777215;
  signal slice1shift_search_0_12, slice1shift_search_0_13, slice1shift_search_0_14 : natural range 0 to 16777215;
  signal slice1shift_search_0_15, slice1shift_search_1_0, slice1shift_search_1_1 : natural range 0 to 16777215;
  signal slice1shift_search_1_2, slice1shift_search_1_3, slice1shift_search_1_4 : natural range 0 to 16777215;
  signal slice1shift_search_1_5, slice1shift_search_1_6, slice1shift_search_1_7 : natural range 0 to 16777215;
  signal slice1shift_search_1_8, slice1shift_search_1_9, slice1shift_search_1_10 : natural range 0 to 16777215;
  signal slice1shift_search_1_11, slice1shift_search_1_12, slice1shift_search_1_13 : natural range 0 to 16777215;
  signal slice1shift_search_1_14, slice1shift_search_1_15, slice1shift_reference_0 : natural range 0 to 16777215;
  signal slice1shift_reference_1, slice1shift_search_out_0, slice1shift_search_out_1 : natural range 0 to 16777215;
  -- slice1cost
  signal slice1cost_pixels_first_0_0_count_0, slice1cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_2, slice1cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_4, slice1cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_0_count_6, slice1cost_pixels_first_0_0_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_0, slice1cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_2, slice1cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_4, slice1cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_1_count_6, slice1cost_pixels_first_0_1_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_0, slice1cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_2, slice1cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_4, slice1cost_pixels_first_0_2_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_2_count_6, slice1cost_pixels_first_0_2_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_0, slice1cost_pixels_first_0_3_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_2, slice1cost_pixels_first_0_3_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_4, slice1cost_pixels_first_0_3_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_3_count_6, slice1cost_pixels_first_0_3_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_0, slice1cost_pixels_first_0_4_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_2, slice1cost_pixels_first_0_4_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_4, slice1cost_pixels_first_0_4_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_4_count_6, slice1cost_pixels_first_0_4_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_5_count_0, slice1cost_pixels_first_0_5_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_5_count_2, slice1cost_pixels_first_0_5_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_5_count_4, slice1cost_pixels_first_0_5_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_5_count_6, slice1cost_pixels_first_0_5_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_6_count_0, slice1cost_pixels_first_0_6_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_6_count_2, slice1cost_pixels_first_0_6_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_6_count_4, slice1cost_pixels_first_0_6_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_6_count_6, slice1cost_pixels_first_0_6_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_7_count_0, slice1cost_pixels_first_0_7_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_7_count_2, slice1cost_pixels_first_0_7_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_7_count_4, slice1cost_pixels_first_0_7_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_7_count_6, slice1cost_pixels_first_0_7_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_8_count_0, slice1cost_pixels_first_0_8_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_8_count_2, slice1cost_pixels_first_0_8_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_8_count_4, slice1cost_pixels_first_0_8_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_8_count_6, slice1cost_pixels_first_0_8_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_9_count_0, slice1cost_pixels_first_0_9_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_9_count_2, slice1cost_pixels_first_0_9_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_9_count_4, slice1cost_pixels_first_0_9_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_9_count_6, slice1cost_pixels_first_0_9_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_10_count_0, slice1cost_pixels_first_0_10_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_10_count_2, slice1cost_pixels_first_0_10_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_10_count_4, slice1cost_pixels_first_0_10_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_10_count_6, slice1cost_pixels_first_0_10_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_11_count_0, slice1cost_pixels_first_0_11_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_11_count_2, slice1cost_pixels_first_0_11_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_11_count_4, slice1cost_pixels_first_0_11_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_11_count_6, slice1cost_pixels_first_0_11_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_12_count_0, slice1cost_pixels_first_0_12_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_12_count_2, slice1cost_pixels_first_0_12_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_12_count_4, slice1cost_pixels_first_0_12_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_12_count_6, slice1cost_pixels_first_0_12_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_13_count_0, slice1cost_pixels_first_0_13_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_13_count_2, slice1cost_pixels_first_0_13_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_13_count_4, slice1cost_pixels_first_0_13_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_13_count_6, slice1cost_pixels_first_0_13_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_14_count_0, slice1cost_pixels_first_0_14_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_14_count_2, slice1cost_pixels_first_0_14_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_14_count_4, slice1cost_pixels_first_0_14_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_14_count_6, slice1cost_pixels_first_0_14_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_15_count_0, slice1cost_pixels_first_0_15_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_15_count_2, slice1cost_pixels_first_0_15_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_15_count_4, slice1cost_pixels_first_0_15_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_0_15_count_6, slice1cost_pixels_first_0_15_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_0, slice1cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_2, slice1cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_4, slice1cost_pixels_first_1_0_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_0_count_6, slice1cost_pixels_first_1_0_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_0, slice1cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_2, slice1cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_4, slice1cost_pixels_first_1_1_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_1_count_6, slice1cost_pixels_first_1_1_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_0, slice1cost_pixels_first_1_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_2, slice1cost_pixels_first_1_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_4, slice1cost_pixels_first_1_2_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_2_count_6, slice1cost_pixels_first_1_2_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_3_count_0, slice1cost_pixels_first_1_3_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_3_count_2, slice1cost_pixels_first_1_3_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_3_count_4, slice1cost_pixels_first_1_3_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_3_count_6, slice1cost_pixels_first_1_3_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_4_count_0, slice1cost_pixels_first_1_4_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_4_count_2, slice1cost_pixels_first_1_4_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_4_count_4, slice1cost_pixels_first_1_4_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_4_count_6, slice1cost_pixels_first_1_4_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_5_count_0, slice1cost_pixels_first_1_5_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_5_count_2, slice1cost_pixels_first_1_5_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_5_count_4, slice1cost_pixels_first_1_5_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_5_count_6, slice1cost_pixels_first_1_5_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_6_count_0, slice1cost_pixels_first_1_6_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_6_count_2, slice1cost_pixels_first_1_6_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_6_count_4, slice1cost_pixels_first_1_6_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_6_count_6, slice1cost_pixels_first_1_6_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_7_count_0, slice1cost_pixels_first_1_7_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_7_count_2, slice1cost_pixels_first_1_7_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_7_count_4, slice1cost_pixels_first_1_7_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_7_count_6, slice1cost_pixels_first_1_7_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_8_count_0, slice1cost_pixels_first_1_8_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_8_count_2, slice1cost_pixels_first_1_8_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_8_count_4, slice1cost_pixels_first_1_8_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_8_count_6, slice1cost_pixels_first_1_8_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_9_count_0, slice1cost_pixels_first_1_9_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_9_count_2, slice1cost_pixels_first_1_9_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_9_count_4, slice1cost_pixels_first_1_9_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_9_count_6, slice1cost_pixels_first_1_9_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_10_count_0, slice1cost_pixels_first_1_10_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_10_count_2, slice1cost_pixels_first_1_10_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_10_count_4, slice1cost_pixels_first_1_10_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_10_count_6, slice1cost_pixels_first_1_10_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_11_count_0, slice1cost_pixels_first_1_11_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_11_count_2, slice1cost_pixels_first_1_11_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_11_count_4, slice1cost_pixels_first_1_11_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_11_count_6, slice1cost_pixels_first_1_11_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_12_count_0, slice1cost_pixels_first_1_12_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_12_count_2, slice1cost_pixels_first_1_12_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_12_count_4, slice1cost_pixels_first_1_12_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_12_count_6, slice1cost_pixels_first_1_12_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_13_count_0, slice1cost_pixels_first_1_13_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_13_count_2, slice1cost_pixels_first_1_13_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_13_count_4, slice1cost_pixels_first_1_13_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_13_count_6, slice1cost_pixels_first_1_13_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_14_count_0, slice1cost_pixels_first_1_14_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_14_count_2, slice1cost_pixels_first_1_14_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_14_count_4, slice1cost_pixels_first_1_14_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_14_count_6, slice1cost_pixels_first_1_14_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_15_count_0, slice1cost_pixels_first_1_15_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_15_count_2, slice1cost_pixels_first_1_15_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_15_count_4, slice1cost_pixels_first_1_15_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_1_15_count_6, slice1cost_pixels_first_1_15_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 24;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_0_5 : natural range 0 to 24;
  signal slice1cost_pixels_cost_0_6, slice1cost_pixels_cost_0_7, slice1cost_pixels_cost_0_8 : natural range 0 to 24;
  signal slice1cost_pixels_cost_0_9, slice1cost_pixels_cost_0_10, slice1cost_pixels_cost_0_11 : natural range 0 to 24;
  signal slice1cost_pixels_cost_0_12, slice1cost_pixels_cost_0_13, slice1cost_pixels_cost_0_14 : natural range 0 to 24;
  signal slice1cost_pixels_cost_0_15, slice1cost_pixels_cost_1_0, slice1cost_pixels_cost_1_1 : natural range 0 to 24;
  signal slice1cost_pixels_cost_1_2, slice1cost_pixels_cost_1_3, slice1cost_pixels_cost_1_4 : natural range 0 to 24;
  signal slice1cost_pixels_cost_1_5, slice1cost_pixels_cost_1_6, slice1cost_pixels_cost_1_7 : natural range 0 to 24;
  signal slice1cost_pixels_cost_1_8, slice1cost_pixels_cost_1_9, slice1cost_pixels_cost_1_10 : natural range 0 to 24;
  signal slice1cost_pixels_cost_1_11, slice1cost_pixels_cost_1_12, slice1cost_pixels_cost_1_13 : natural range 0 to 24;
  signal slice1cost_pixels_cost_1_14, slice1cost_pixels_cost_1_15 : natural range 0 to 24;
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 511;
  signal slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words_0, slice1cost_read_words_1, slice1cost_read_words_2 : unsigned(31 downto 0);
  signal slice1cost_read_words_3, slice1cost_ready_words_0, slice1cost_ready_words_1 : unsigned(31 downto 0);
  signal slice1cost_ready_words_2, slice1cost_ready_words_3, slice1cost_write_words_0 : unsigned(31 downto 0);
  signal slice1cost_write_words_1, slice1cost_write_words_2, slice1cost_write_words_3 : unsigned(31 downto 0);
  signal slice1cost_change_0_0, slice1cost_change_0_1, slice1cost_change_0_2 : integer range -24 to 24;
  signal slice1cost_change_0_3, slice1cost_change_0_4, slice1cost_change_0_5 : integer range -24 to 24;
  signal slice1cost_change_0_6, slice1cost_change_0_7, slice1cost_change_0_8 : integer range -24 to 24;
  signal slice1cost_change_0_9, slice1cost_change_0_10, slice1cost_change_0_11 : integer range -24 to 24;
  signal slice1cost_change_0_12, slice1cost_change_0_13, slice1cost_change_0_14 : integer range -24 to 24;
  signal slice1cost_change_0_15 : integer range -24 to 24;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 255;
  signal slice1cost_column_0_3, slice1cost_column_0_4, slice1cost_column_0_5 : natural range 0 to 255;
  signal slice1cost_column_0_6, slice1cost_column_0_7, slice1cost_column_0_8 : natural range 0 to 255;
  signal slice1cost_column_0_9, slice1cost_column_0_10, slice1cost_column_0_11 : natural range 0 to 255;
  signal slice1cost_column_0_12, slice1cost_column_0_13, slice1cost_column_0_14 : natural range 0 to 255;
  signal slice1cost_column_0_15 : natural range 0 to 255;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving_0, slice1window_leaving_1, slice1window_leaving_2 : unsigned(31 downto 0);
  signal slice1window_leaving_3 : unsigned(31 downto 0);
  signal slice1window_entering_0_0, slice1window_entering_0_1, slice1window_entering_0_2 : natural range 0 to 255;
  signal slice1window_entering_0_3, slice1window_entering_0_4, slice1window_entering_0_5 : natural range 0 to 255;
  signal slice1window_entering_0_6, slice1window_entering_0_7, slice1window_entering_0_8 : natural range 0 to 255;
  signal slice1window_entering_0_9, slice1window_entering_0_10, slice1window_entering_0_11 : natural range 0 to 255;
  signal slice1window_entering_0_12, slice1window_entering_0_13, slice1window_entering_0_14 : natural range 0 to 255;
  signal slice1window_entering_0_15 : natural range 0 to 255;
  signal slice1window_change_0_0, slice1window_change_0_1, slice1window_change_0_2 : integer range -255 to 255;
  signal slice1window_change_0_3, slice1window_change_0_4, slice1window_change_0_5 : integer range -255 to 255;
  signal slice1window_change_0_6, slice1window_change_0_7, slice1window_change_0_8 : integer range -255 to 255;
  signal slice1window_change_0_9, slice1window_change_0_10, slice1window_change_0_11 : integer range -255 to 255;
  signal slice1window_change_0_12, slice1window_change_0_13, slice1window_change_0_14 : integer range -255 to 255;
  signal slice1window_change_0_15 : integer range -255 to 255;
  signal slice1window_change_tag_row_start, slice1window_change_tag_leaves_window : boolean;
  signal slice1window_change_tag_first_column, slice1window_centre_map_column_0 : boolean;
  signal slice1window_centre_first_column_0, slice1window_centre_first_column_1 : boolean;
  signal slice1window_centre_first_column_2, slice1window_centre_start_of_frame_0 : boolean;
  signal slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 2047;
  signal slice1window_sum_0_3, slice1window_sum_0_4, slice1window_sum_0_5 : natural range 0 to 2047;
  signal slice1window_sum_0_6, slice1window_sum_0_7, slice1window_sum_0_8 : natural range 0 to 2047;
  signal slice1window_sum_0_9, slice1window_sum_0_10, slice1window_sum_0_11 : natural range 0 to 2047;
  signal slice1window_sum_0_12, slice1window_sum_0_13, slice1window_sum_0_14 : natural range 0 to 2047;
  signal slice1window_sum_0_15 : natural range 0 to 2047;
  -- slice1mask
  signal slice1mask_inside_0, slice1mask_inside_1, slice1mask_inside_2, slice1mask_inside_3 : boolean;
  signal slice1mask_inside_4, slice1mask_inside_5, slice1mask_inside_6, slice1mask_inside_7 : boolean;
  signal slice1mask_inside_8, slice1mask_inside_9, slice1mask_inside_10, slice1mask_inside_11 : boolean;
  signal slice1mask_inside_12, slice1mask_inside_13, slice1mask_inside_14, slice1mask_inside_15 : boolean;
  signal slice1mask_left_out : boolean;
  -- slice1winner1
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_cost_0_2, slice1winner1_best_cost_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_cost_0_4, slice1winner1_best_cost_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_cost_0_6, slice1winner1_best_cost_0_7 : natural range 0 to 2047;
  signal slice1winner1_best_below_0_0, slice1winner1_best_below_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_below_0_2, slice1winner1_best_below_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_below_0_4, slice1winner1_best_below_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_below_0_6, slice1winner1_best_below_0_7 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_0, slice1winner1_best_above_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_2, slice1winner1_best_above_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_4, slice1winner1_best_above_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_6, slice1winner1_best_above_0_7 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_0, slice1winner1_best_first_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_2, slice1winner1_best_first_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_4, slice1winner1_best_first_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_6, slice1winner1_best_first_0_7 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_0, slice1winner1_best_last_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_2, slice1winner1_best_last_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_4, slice1winner1_best_last_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_6, slice1winner1_best_last_0_7 : natural range 0 to 2047;
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_index_0_4 : natural range 0 to 9;
  signal slice1winner1_best_index_0_5 : natural range 0 to 11;
  signal slice1winner1_best_index_0_6 : natural range 0 to 13;
  signal slice1winner1_best_index_0_7 : natural range 0 to 15;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_cost_0_2, slice1winner2_best_cost_0_3 : natural range 0 to 2047;
  signal slice1winner2_best_below_0_0, slice1winner2_best_below_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_below_0_2, slice1winner2_best_below_0_3 : natural range 0 to 2047;
  signal slice1winner2_best_above_0_0, slice1winner2_best_above_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_above_0_2, slice1winner2_best_above_0_3 : natural range 0 to 2047;
  signal slice1winner2_best_first_0_0, slice1winner2_best_first_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_first_0_2, slice1winner2_best_first_0_3 : natural range 0 to 2047;
  signal slice1winner2_best_last_0_0, slice1winner2_best_last_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_last_0_2, slice1winner2_best_last_0_3 : natural range 0 to 2047;
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  signal slice1winner2_best_index_0_3 : natural range 0 to 15;
  -- slice1winner3
  signal slice1winner3_best_cost_0_0, slice1winner3_best_cost_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_below_0_0, slice1winner3_best_below_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_above_0_0, slice1winner3_best_above_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_first_0_0, slice1winner3_best_first_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_last_0_0, slice1winner3_best_last_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 15;
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_above_0_0, slice1winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 2047;
  signal slice1_best_last_0_0 : natural range 0 to 2047;
  signal slice1_best_index_0_0 : natural range 0 to 31;
  signal slice1_best_tag_valid, slice1_best_tag_map_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_0_2 : natural range 0 to 16777215;
  signal slice2shift_search_0_3, slice2shift_search_0_4, slice2shift_search_0_5 : natural range 0 to 16777215;
  signal slice2shift_search_0_6, slice2shift_search_0_7, slice2shift_search_0_8 : natural range 0 to 16777215;
  signal slice2shift_search_0_9, slice2shift_search_0_10, slice2shift_search_0_11 : natural range 0 to 16777215;
  signal slice2shift_search_0_12, slice2shift_search_0_13, slice2shift_search_0_14 : natural range 0 to 16777215;
  signal slice2shift_search_0_15, slice2shift_search_1_0, slice2shift_search_1_1 : natural range 0 to 16777215;
  signal slice2shift_search_1_2, slice2shift_search_1_3, slice2shift_search_1_4 : natural range 0 to 16777215;
  signal slice2shift_search_1_5, slice2shift_search_1_6, slice2shift_search_1_7 : natural range 0 to 16777215;
  signal slice2shift_search_1_8, slice2shift_search_1_9, slice2shift_search_1_10 : natural range 0 to 16777215;
  signal slice2shift_search_1_11, slice2shift_search_1_12, slice2shift_search_1_13 : natural range 0 to 16777215;
  signal slice2shift_search_1_14, slice2shift_search_1_15, slice2shift_reference_0 : natural range 0 to 16777215;
  signal slice2shift_reference_1 : natural range 0 to 16777215;
  -- slice2cost
  signal slice2cost_pixels_first_0_0_count_0, slice2cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_2, slice2cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_4, slice2cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_6, slice2cost_pixels_first_0_0_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_0, slice2cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_2, slice2cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_4, slice2cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_6, slice2cost_pixels_first_0_1_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_2_count_0, slice2cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_2_count_2, slice2cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_2_count_4, slice2cost_pixels_first_0_2_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_2_count_6, slice2cost_pixels_first_0_2_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_3_count_0, slice2cost_pixels_first_0_3_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_3_count_2, slice2cost_pixels_first_0_3_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_3_count_4, slice2cost_pixels_first_0_3_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_3_count_6, slice2cost_pixels_first_0_3_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_4_count_0, slice2cost_pixels_first_0_4_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_4_count_2, slice2cost_pixels_first_0_4_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_4_count_4, slice2cost_pixels_first_0_4_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_4_count_6, slice2cost_pixels_first_0_4_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_5_count_0, slice2cost_pixels_first_0_5_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_5_count_2, slice2cost_pixels_first_0_5_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_5_count_4, slice2cost_pixels_first_0_5_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_5_count_6, slice2cost_pixels_first_0_5_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_6_count_0, slice2cost_pixels_first_0_6_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_6_count_2, slice2cost_pixels_first_0_6_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_6_count_4, slice2cost_pixels_first_0_6_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_6_count_6, slice2cost_pixels_first_0_6_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_7_count_0, slice2cost_pixels_first_0_7_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_7_count_2, slice2cost_pixels_first_0_7_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_7_count_4, slice2cost_pixels_first_0_7_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_7_count_6, slice2cost_pixels_first_0_7_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_8_count_0, slice2cost_pixels_first_0_8_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_8_count_2, slice2cost_pixels_first_0_8_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_8_count_4, slice2cost_pixels_first_0_8_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_8_count_6, slice2cost_pixels_first_0_8_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_9_count_0, slice2cost_pixels_first_0_9_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_9_count_2, slice2cost_pixels_first_0_9_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_9_count_4, slice2cost_pixels_first_0_9_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_9_count_6, slice2cost_pixels_first_0_9_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_10_count_0, slice2cost_pixels_first_0_10_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_10_count_2, slice2cost_pixels_first_0_10_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_10_count_4, slice2cost_pixels_first_0_10_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_10_count_6, slice2cost_pixels_first_0_10_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_11_count_0, slice2cost_pixels_first_0_11_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_11_count_2, slice2cost_pixels_first_0_11_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_11_count_4, slice2cost_pixels_first_0_11_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_11_count_6, slice2cost_pixels_first_0_11_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_12_count_0, slice2cost_pixels_first_0_12_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_12_count_2, slice2cost_pixels_first_0_12_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_12_count_4, slice2cost_pixels_first_0_12_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_12_count_6, slice2cost_pixels_first_0_12_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_13_count_0, slice2cost_pixels_first_0_13_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_13_count_2, slice2cost_pixels_first_0_13_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_13_count_4, slice2cost_pixels_first_0_13_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_13_count_6, slice2cost_pixels_first_0_13_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_14_count_0, slice2cost_pixels_first_0_14_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_14_count_2, slice2cost_pixels_first_0_14_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_14_count_4, slice2cost_pixels_first_0_14_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_14_count_6, slice2cost_pixels_first_0_14_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_15_count_0, slice2cost_pixels_first_0_15_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_15_count_2, slice2cost_pixels_first_0_15_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_15_count_4, slice2cost_pixels_first_0_15_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_15_count_6, slice2cost_pixels_first_0_15_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_0, slice2cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_2, slice2cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_4, slice2cost_pixels_first_1_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_6, slice2cost_pixels_first_1_0_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_0, slice2cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_2, slice2cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_4, slice2cost_pixels_first_1_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_6, slice2cost_pixels_first_1_1_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_2_count_0, slice2cost_pixels_first_1_2_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_2_count_2, slice2cost_pixels_first_1_2_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_2_count_4, slice2cost_pixels_first_1_2_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_2_count_6, slice2cost_pixels_first_1_2_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_3_count_0, slice2cost_pixels_first_1_3_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_3_count_2, slice2cost_pixels_first_1_3_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_3_count_4, slice2cost_pixels_first_1_3_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_3_count_6, slice2cost_pixels_first_1_3_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_4_count_0, slice2cost_pixels_first_1_4_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_4_count_2, slice2cost_pixels_first_1_4_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_4_count_4, slice2cost_pixels_first_1_4_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_4_count_6, slice2cost_pixels_first_1_4_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_5_count_0, slice2cost_pixels_first_1_5_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_5_count_2, slice2cost_pixels_first_1_5_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_5_count_4, slice2cost_pixels_first_1_5_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_5_count_6, slice2cost_pixels_first_1_5_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_6_count_0, slice2cost_pixels_first_1_6_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_6_count_2, slice2cost_pixels_first_1_6_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_6_count_4, slice2cost_pixels_first_1_6_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_6_count_6, slice2cost_pixels_first_1_6_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_7_count_0, slice2cost_pixels_first_1_7_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_7_count_2, slice2cost_pixels_first_1_7_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_7_count_4, slice2cost_pixels_first_1_7_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_7_count_6, slice2cost_pixels_first_1_7_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_8_count_0, slice2cost_pixels_first_1_8_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_8_count_2, slice2cost_pixels_first_1_8_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_8_count_4, slice2cost_pixels_first_1_8_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_8_count_6, slice2cost_pixels_first_1_8_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_9_count_0, slice2cost_pixels_first_1_9_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_9_count_2, slice2cost_pixels_first_1_9_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_9_count_4, slice2cost_pixels_first_1_9_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_9_count_6, slice2cost_pixels_first_1_9_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_10_count_0, slice2cost_pixels_first_1_10_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_10_count_2, slice2cost_pixels_first_1_10_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_10_count_4, slice2cost_pixels_first_1_10_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_10_count_6, slice2cost_pixels_first_1_10_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_11_count_0, slice2cost_pixels_first_1_11_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_11_count_2, slice2cost_pixels_first_1_11_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_11_count_4, slice2cost_pixels_first_1_11_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_11_count_6, slice2cost_pixels_first_1_11_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_12_count_0, slice2cost_pixels_first_1_12_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_12_count_2, slice2cost_pixels_first_1_12_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_12_count_4, slice2cost_pixels_first_1_12_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_12_count_6, slice2cost_pixels_first_1_12_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_13_count_0, slice2cost_pixels_first_1_13_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_13_count_2, slice2cost_pixels_first_1_13_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_13_count_4, slice2cost_pixels_first_1_13_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_13_count_6, slice2cost_pixels_first_1_13_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_14_count_0, slice2cost_pixels_first_1_14_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_14_count_2, slice2cost_pixels_first_1_14_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_14_count_4, slice2cost_pixels_first_1_14_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_14_count_6, slice2cost_pixels_first_1_14_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_15_count_0, slice2cost_pixels_first_1_15_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_15_count_2, slice2cost_pixels_first_1_15_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_15_count_4, slice2cost_pixels_first_1_15_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_15_count_6, slice2cost_pixels_first_1_15_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_cost_0_0, slice2cost_pixels_cost_0_1, slice2cost_pixels_cost_0_2 : natural range 0 to 24;
  signal slice2cost_pixels_cost_0_3, slice2cost_pixels_cost_0_4, slice2cost_pixels_cost_0_5 : natural range 0 to 24;
  signal slice2cost_pixels_cost_0_6, slice2cost_pixels_cost_0_7, slice2cost_pixels_cost_0_8 : natural range 0 to 24;
  signal slice2cost_pixels_cost_0_9, slice2cost_pixels_cost_0_10, slice2cost_pixels_cost_0_11 : natural range 0 to 24;
  signal slice2cost_pixels_cost_0_12, slice2cost_pixels_cost_0_13, slice2cost_pixels_cost_0_14 : natural range 0 to 24;
  signal slice2cost_pixels_cost_0_15, slice2cost_pixels_cost_1_0, slice2cost_pixels_cost_1_1 : natural range 0 to 24;
  signal slice2cost_pixels_cost_1_2, slice2cost_pixels_cost_1_3, slice2cost_pixels_cost_1_4 : natural range 0 to 24;
  signal slice2cost_pixels_cost_1_5, slice2cost_pixels_cost_1_6, slice2cost_pixels_cost_1_7 : natural range 0 to 24;
  signal slice2cost_pixels_cost_1_8, slice2cost_pixels_cost_1_9, slice2cost_pixels_cost_1_10 : natural range 0 to 24;
  signal slice2cost_pixels_cost_1_11, slice2cost_pixels_cost_1_12, slice2cost_pixels_cost_1_13 : natural range 0 to 24;
  signal slice2cost_pixels_cost_1_14, slice2cost_pixels_cost_1_15 : natural range 0 to 24;
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column : natural range 0 to 511;
  signal slice2cost_write_column : natural range 0 to 511;
  signal slice2cost_read_words_0, slice2cost_read_words_1, slice2cost_read_words_2 : unsigned(31 downto 0);
  signal slice2cost_read_words_3, slice2cost_ready_words_0, slice2cost_ready_words_1 : unsigned(31 downto 0);
  signal slice2cost_ready_words_2, slice2cost_ready_words_3, slice2cost_write_words_0 : unsigned(31 downto 0);
  signal slice2cost_write_words_1, slice2cost_write_words_2, slice2cost_write_words_3 : unsigned(31 downto 0);
  signal slice2cost_change_0_0, slice2cost_change_0_1, slice2cost_change_0_2 : integer range -24 to 24;
  signal slice2cost_change_0_3, slice2cost_change_0_4, slice2cost_change_0_5 : integer range -24 to 24;
  signal slice2cost_change_0_6, slice2cost_change_0_7, slice2cost_change_0_8 : integer range -24 to 24;
  signal slice2cost_change_0_9, slice2cost_change_0_10, slice2cost_change_0_11 : integer range -24 to 24;
  signal slice2cost_change_0_12, slice2cost_change_0_13, slice2cost_change_0_14 : integer range -24 to 24;
  signal slice2cost_change_0_15 : integer range -24 to 24;
  signal slice2cost_column_0_0, slice2cost_column_0_1, slice2cost_column_0_2 : natural range 0 to 255;
  signal slice2cost_column_0_3, slice2cost_column_0_4, slice2cost_column_0_5 : natural range 0 to 255;
  signal slice2cost_column_0_6, slice2cost_column_0_7, slice2cost_column_0_8 : natural range 0 to 255;
  signal slice2cost_column_0_9, slice2cost_column_0_10, slice2cost_column_0_11 : natural range 0 to 255;
  signal slice2cost_column_0_12, slice2cost_column_0_13, slice2cost_column_0_14 : natural range 0 to 255;
  signal slice2cost_column_0_15 : natural range 0 to 255;
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 15;
  signal slice2window_leaving_0, slice2window_leaving_1, slice2window_leaving_2 : unsigned(31 downto 0);
  signal slice2window_leaving_3 : unsigned(31 downto 0);
  signal slice2window_entering_0_0, slice2window_entering_0_1, slice2window_entering_0_2 : natural range 0 to 255;
  signal slice2window_entering_0_3, slice2window_entering_0_4, slice2window_entering_0_5 : natural range 0 to 255;
  signal slice2window_entering_0_6, slice2window_entering_0_7, slice2window_entering_0_8 : natural range 0 to 255;
  signal slice2window_entering_0_9, slice2window_entering_0_10, slice2window_entering_0_11 : natural range 0 to 255;
  signal slice2window_entering_0_12, slice2window_entering_0_13, slice2window_entering_0_14 : natural range 0 to 255;
  signal slice2window_entering_0_15 : natural range 0 to 255;
  signal slice2window_change_0_0, slice2window_change_0_1, slice2window_change_0_2 : integer range -255 to 255;
  signal slice2window_change_0_3, slice2window_change_0_4, slice2window_change_0_5 : integer range -255 to 255;
  signal slice2window_change_0_6, slice2window_change_0_7, slice2window_change_0_8 : integer range -255 to 255;
  signal slice2window_change_0_9, slice2window_change_0_10, slice2window_change_0_11 : integer range -255 to 255;
  signal slice2window_change_0_12, slice2window_change_0_13, slice2window_change_0_14 : integer range -255 to 255;
  signal slice2window_change_0_15 : integer range -255 to 255;
  signal slice2window_change_tag_row_start, slice2window_change_tag_first_column : boolean;
  signal slice2window_centre_map_column_0, slice2window_centre_map_column_1, slice2window_centre_map_column_2 : boolean;
  signal slice2window_centre_first_column_0, slice2window_centre_first_column_1 : boolean;
  signal slice2window_centre_first_column_2, slice2window_centre_start_of_frame_0 : boolean;
  signal slice2window_centre_end_of_line_0, slice2window_centre_end_of_line_1 : boolean;
  signal slice2window_centre_end_of_line_2 : boolean;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_0_2 : natural range 0 to 2047;
  signal slice2window_sum_0_3, slice2window_sum_0_4, slice2window_sum_0_5 : natural range 0 to 2047;
  signal slice2window_sum_0_6, slice2window_sum_0_7, slice2window_sum_0_8 : natural range 0 to 2047;
  signal slice2window_sum_0_9, slice2window_sum_0_10, slice2window_sum_0_11 : natural range 0 to 2047;
  signal slice2window_sum_0_12, slice2window_sum_0_13, slice2window_sum_0_14 : natural range 0 to 2047;
  signal slice2window_sum_0_15 : natural range 0 to 2047;
  -- slice2mask
  signal slice2mask_inside_0, slice2mask_inside_1, slice2mask_inside_2, slice2mask_inside_3 : boolean;
  signal slice2mask_inside_4, slice2mask_inside_5, slice2mask_inside_6, slice2mask_inside_7 : boolean;
  signal slice2mask_inside_8, slice2mask_inside_9, slice2mask_inside_10, slice2mask_inside_11 : boolean;
  signal slice2mask_inside_12, slice2mask_inside_13, slice2mask_inside_14, slice2mask_inside_15 : boolean;
  -- slice2winner1
  signal slice2winner1_best_cost_0_0, slice2winner1_best_cost_0_1 : natural range 0 to 2047;
  signal slice2winner1_best_cost_0_2, slice2winner1_best_cost_0_3 : natural range 0 to 2047;
  signal slice2winner1_best_cost_0_4, slice2winner1_best_cost_0_5 : natural range 0 to 2047;
  signal slice2winner1_best_cost_0_6, slice2winner1_best_cost_0_7 : natural range 0 to 2047;
  signal slice2winner1_best_below_0_0, slice2winner1_best_below_0_1 : natural range 0 to 2047;
  signal slice2winner1_best_below_0_2, slice2winner1_best_below_0_3 : natural range 0 to 2047;
  signal slice2winner1_best_below_0_4, slice2winner1_best_below_0_5 : natural range 0 to 2047;
  signal slice2winner1_best_below_0_6, slice2winner1_best_below_0_7 : natural range 0 to 2047;
  signal slice2winner1_best_above_0_0, slice2winner1_best_above_0_1 : natural range 0 to 2047;
  signal slice2winner1_best_above_0_2, slice2winner1_best_above_0_3 : natural range 0 to 2047;
  signal slice2winner1_best_above_0_4, slice2winner1_best_above_0_5 : natural range 0 to 2047;
  signal slice2winner1_best_above_0_6, slice2winner1_best_above_0_7 : natural range 0 to 2047;
  signal slice2winner1_best_first_0_0, slice2winner1_best_first_0_1 : natural range 0 to 2047;
  signal slice2winner1_best_first_0_2, slice2winner1_best_first_0_3 : natural range 0 to 2047;
  signal slice2winner1_best_first_0_4, slice2winner1_best_first_0_5 : natural range 0 to 2047;
  signal slice2winner1_best_first_0_6, slice2winner1_best_first_0_7 : natural range 0 to 2047;
  signal slice2winner1_best_last_0_0, slice2winner1_best_last_0_1 : natural range 0 to 2047;
  signal slice2winner1_best_last_0_2, slice2winner1_best_last_0_3 : natural range 0 to 2047;
  signal slice2winner1_best_last_0_4, slice2winner1_best_last_0_5 : natural range 0 to 2047;
  signal slice2winner1_best_last_0_6 : natural range 0 to 2047;
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0_1 : natural range 0 to 3;
  signal slice2winner1_best_index_0_2 : natural range 0 to 5;
  signal slice2winner1_best_index_0_3 : natural range 0 to 7;
  signal slice2winner1_best_index_0_4 : natural range 0 to 9;
  signal slice2winner1_best_index_0_5 : natural range 0 to 11;
  signal slice2winner1_best_index_0_6 : natural range 0 to 13;
  signal slice2winner1_best_index_0_7 : natural range 0 to 15;
  -- slice2winner2
  signal slice2winner2_best_cost_0_0, slice2winner2_best_cost_0_1 : natural range 0 to 2047;
  signal slice2winner2_best_cost_0_2, slice2winner2_best_cost_0_3 : natural range 0 to 2047;
  signal slice2winner2_best_below_0_0, slice2winner2_best_below_0_1 : natural range 0 to 2047;
  signal slice2winner2_best_below_0_2, slice2winner2_best_below_0_3 : natural range 0 to 2047;
  signal slice2winner2_best_above_0_0, slice2winner2_best_above_0_1 : natural range 0 to 2047;
  signal slice2winner2_best_above_0_2, slice2winner2_best_above_0_3 : natural range 0 to 2047;
  signal slice2winner2_best_first_0_0, slice2winner2_best_first_0_1 : natural range 0 to 2047;
  signal slice2winner2_best_first_0_2, slice2winner2_best_first_0_3 : natural range 0 to 2047;
  signal slice2winner2_best_last_0_0, slice2winner2_best_last_0_1 : natural range 0 to 2047;
  signal slice2winner2_best_last_0_2 : natural range 0 to 2047;
  signal slice2winner2_best_index_0_0 : natural range 0 to 3;
  signal slice2winner2_best_index_0_1 : natural range 0 to 7;
  signal slice2winner2_best_index_0_2 : natural range 0 to 11;
  signal slice2winner2_best_index_0_3 : natural range 0 to 15;
  -- slice2winner3
  signal slice2winner3_best_cost_0_0, slice2winner3_best_cost_0_1 : natural range 0 to 2047;
  signal slice2winner3_best_below_0_0, slice2winner3_best_below_0_1 : natural range 0 to 2047;
  signal slice2winner3_best_above_0_0, slice2winner3_best_above_0_1 : natural range 0 to 2047;
  signal slice2winner3_best_first_0_0, slice2winner3_best_first_0_1 : natural range 0 to 2047;
  signal slice2winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice2winner3_best_index_0_0 : natural range 0 to 7;
  signal slice2winner3_best_index_0_1 : natural range 0 to 15;
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_above_0_0, slice2winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_below_0_0, slice2_best_above_0_0 : natural range 0 to 2047;
  signal slice2_best_index_0_0 : natural range 0 to 47;
  signal slice2_best_tag_valid, slice2_best_tag_map_column, slice2_best_tag_start_of_frame : boolean;
  signal slice2_best_tag_end_of_line : boolean;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 47;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 47;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 47;
  signal refinement_disparity_9_0, refinement_disparity_10_0, refinement_disparity_11_0 : natural range 0 to 47;
  signal refinement_passed_0_0, refinement_passed_1_0, refinement_passed_2_0, refinement_passed_3_0 : boolean;
  signal refinement_passed_5_0, refinement_passed_6_0, refinement_passed_7_0, refinement_passed_8_0 : boolean;
  signal refinement_passed_11_0, refinement_tag_0_valid, refinement_tag_0_map_column : boolean;
  signal refinement_tag_0_start_of_frame, refinement_tag_0_end_of_line, refinement_tag_1_valid : boolean;
  signal refinement_tag_1_map_column, refinement_tag_1_start_of_frame, refinement_tag_1_end_of_line : boolean;
  signal refinement_tag_2_valid, refinement_tag_2_map_column, refinement_tag_2_start_of_frame : boolean;
  signal refinement_tag_2_end_of_line, refinement_tag_3_valid, refinement_tag_3_map_column : boolean;
  signal refinement_tag_3_start_of_frame, refinement_tag_3_end_of_line, refinement_tag_4_valid : boolean;
  signal refinement_tag_4_map_column, refinement_tag_4_start_of_frame, refinement_tag_4_end_of_line : boolean;
  signal refinement_tag_5_valid, refinement_tag_5_map_column, refinement_tag_5_start_of_frame : boolean;
  signal refinement_tag_5_end_of_line, refinement_tag_6_valid, refinement_tag_6_map_column : boolean;
  signal refinement_tag_6_start_of_frame, refinement_tag_6_end_of_line, refinement_tag_7_valid : boolean;
  signal refinement_tag_7_map_column, refinement_tag_7_start_of_frame, refinement_tag_7_end_of_line : boolean;
  signal refinement_tag_8_valid, refinement_tag_8_map_column, refinement_tag_8_start_of_frame : boolean;
  signal refinement_tag_8_end_of_line, refinement_tag_9_valid, refinement_tag_9_map_column : boolean;
  signal refinement_tag_9_start_of_frame, refinement_tag_9_end_of_line, refinement_tag_10_valid : boolean;
  signal refinement_tag_10_map_column, refinement_tag_10_start_of_frame, refinement_tag_10_end_of_line : boolean;
  signal refinement_tag_11_valid, refinement_tag_11_row_start, refinement_tag_11_map_column : boolean;
  signal refinement_tag_11_start_of_frame, refinement_tag_11_end_of_line, refinement_negative_0_0 : boolean;
  signal refinement_negative_1_0, refinement_negative_2_0, refinement_negative_3_0, refinement_negative_4_0 : boolean;
  signal refinement_negative_5_0, refinement_negative_6_0, refinement_negative_7_0, refinement_negative_8_0 : boolean;
  signal refinement_cost_0, refinement_below_0, refinement_above_0, refinement_u_0 : natural range 0 to 2047;
  signal refinement_v_0, refinement_remainder_0_0, refinement_remainder_1_0 : natural range 0 to 2047;
  signal refinement_remainder_2_0, refinement_remainder_3_0, refinement_remainder_4_0 : natural range 0 to 2047;
  signal refinement_remainder_5_0, refinement_remainder_6_0, refinement_remainder_7_0 : natural range 0 to 2047;
  signal refinement_divisor_0_0, refinement_divisor_1_0, refinement_divisor_2_0 : natural range 0 to 2047;
  signal refinement_divisor_3_0, refinement_divisor_4_0, refinement_divisor_5_0 : natural range 0 to 2047;
  signal refinement_divisor_6_0, refinement_divisor_7_0 : natural range 0 to 2047;
  signal refinement_difference_0 : integer range -2047 to 2047;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_counter_column, map_counter_group, map_write_column, map_at_column : natural range 0 to 511;
  signal map_comparing_column, map_sorted_column : natural range 0 to 511;
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
  signal map_rows_read_words_0 : unsigned(25 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 67108863;
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
  signal other_0, other_1, other_2, other_3, other_4, other_5, other_6, other_7, other_8 : boolean;
  signal other_9, other_11 : unsigned(48 downto 0);
  signal other_10 : natural range 0 to 8190;
  signal other_12 : natural range 0 to 254;
  signal other_13 : natural range 0 to 252;
  signal other_14 : natural range 0 to 248;
  signal other_15 : natural range 0 to 240;
  signal other_16 : natural range 0 to 224;
  signal other_17 : natural range 0 to 192;
  signal other_18 : natural range 0 to 128;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal map_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal slice2window_leaving_3_memory_read_enable : boolean;
  signal slice2window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_3_memory_write_data : unsigned(31 downto 0);
  signal slice2window_leaving_2_memory_read_enable : boolean;
  signal slice2window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_2_memory_write_data : unsigned(31 downto 0);
  signal slice2window_leaving_1_memory_read_enable : boolean;
  signal slice2window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice2window_leaving_0_memory_read_enable : boolean;
  signal slice2window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice2window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice2window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice2cost_read_words_3_memory_read_enable : boolean;
  signal slice2cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_3_memory_write_data : unsigned(31 downto 0);
  signal slice2cost_read_words_2_memory_read_enable : boolean;
  signal slice2cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal slice2cost_read_words_1_memory_read_enable : boolean;
  signal slice2cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal slice2cost_read_words_0_memory_read_enable : boolean;
  signal slice2cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_3_memory_read_enable : boolean;
  signal slice1window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_3_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_2_memory_read_enable : boolean;
  signal slice1window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_3_memory_read_enable : boolean;
  signal slice1cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_2_memory_read_enable : boolean;
  signal slice1cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_3_memory_read_enable : boolean;
  signal slice0window_leaving_3_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_3_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_3_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_2_memory_read_enable : boolean;
  signal slice0window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_3_memory_read_enable : boolean;
  signal slice0cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal rows_search_rows_read_words_8_memory_read_enable : boolean;
  signal rows_search_rows_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_8_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_7_memory_read_enable : boolean;
  signal rows_search_rows_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_7_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_6_memory_read_enable : boolean;
  signal rows_search_rows_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_6_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_5_memory_read_enable : boolean;
  signal rows_search_rows_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_5_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_4_memory_read_enable : boolean;
  signal rows_search_rows_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_4_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_3_memory_read_enable : boolean;
  signal rows_search_rows_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_2_memory_read_enable : boolean;
  signal rows_search_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_8_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_8_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_7_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_7_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_6_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_6_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_5_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_5_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_4_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_4_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_3_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_2_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(23 downto 0);

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

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 9);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_at_column, 9);
  map_rows_read_words_0_memory_write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 442, width => 26, address_bits => 9)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  slice2window_leaving_3_memory_read_enable <= true;
  slice2window_leaving_3_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_3_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_3_memory_write_data <= to_unsigned(slice2cost_column_0_15, 8) & to_unsigned(slice2cost_column_0_14, 8) & to_unsigned(slice2cost_column_0_13, 8) & to_unsigned(slice2cost_column_0_12, 8);
  slice2window_leaving_3_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_3_memory_read_enable,
      read_address => slice2window_leaving_3_memory_read_address, read_data => slice2window_leaving_3,
      write_address => slice2window_leaving_3_memory_write_address, write_data => slice2window_leaving_3_memory_write_data);

  slice2window_leaving_2_memory_read_enable <= true;
  slice2window_leaving_2_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_2_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_2_memory_write_data <= to_unsigned(slice2cost_column_0_11, 8) & to_unsigned(slice2cost_column_0_10, 8) & to_unsigned(slice2cost_column_0_9, 8) & to_unsigned(slice2cost_column_0_8, 8);
  slice2window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_2_memory_read_enable,
      read_address => slice2window_leaving_2_memory_read_address, read_data => slice2window_leaving_2,
      write_address => slice2window_leaving_2_memory_write_address, write_data => slice2window_leaving_2_memory_write_data);

  slice2window_leaving_1_memory_read_enable <= true;
  slice2window_leaving_1_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_1_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_1_memory_write_data <= to_unsigned(slice2cost_column_0_7, 8) & to_unsigned(slice2cost_column_0_6, 8) & to_unsigned(slice2cost_column_0_5, 8) & to_unsigned(slice2cost_column_0_4, 8);
  slice2window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_1_memory_read_enable,
      read_address => slice2window_leaving_1_memory_read_address, read_data => slice2window_leaving_1,
      write_address => slice2window_leaving_1_memory_write_address, write_data => slice2window_leaving_1_memory_write_data);

  slice2window_leaving_0_memory_read_enable <= true;
  slice2window_leaving_0_memory_read_address <= to_unsigned(slice2window_ring_read_address, 4);
  slice2window_leaving_0_memory_write_address <= to_unsigned(slice2window_ring_write_address, 4);
  slice2window_leaving_0_memory_write_data <= to_unsigned(slice2cost_column_0_3, 8) & to_unsigned(slice2cost_column_0_2, 8) & to_unsigned(slice2cost_column_0_1, 8) & to_unsigned(slice2cost_column_0_0, 8);
  slice2window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice2window_leaving_0_memory_read_enable,
      read_address => slice2window_leaving_0_memory_read_address, read_data => slice2window_leaving_0,
      write_address => slice2window_leaving_0_memory_write_address, write_data => slice2window_leaving_0_memory_write_data);

  slice2cost_read_words_3_memory_read_enable <= true;
  slice2cost_read_words_3_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_3_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_3_memory_write_data <= slice2cost_write_words_3;
  slice2cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_3_memory_read_enable,
      read_address => slice2cost_read_words_3_memory_read_address, read_data => slice2cost_read_words_3,
      write_address => slice2cost_read_words_3_memory_write_address, write_data => slice2cost_read_words_3_memory_write_data);

  slice2cost_read_words_2_memory_read_enable <= true;
  slice2cost_read_words_2_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_2_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_2_memory_write_data <= slice2cost_write_words_2;
  slice2cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_2_memory_read_enable,
      read_address => slice2cost_read_words_2_memory_read_address, read_data => slice2cost_read_words_2,
      write_address => slice2cost_read_words_2_memory_write_address, write_data => slice2cost_read_words_2_memory_write_data);

  slice2cost_read_words_1_memory_read_enable <= true;
  slice2cost_read_words_1_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_1_memory_write_data <= slice2cost_write_words_1;
  slice2cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_1_memory_read_enable,
      read_address => slice2cost_read_words_1_memory_read_address, read_data => slice2cost_read_words_1,
      write_address => slice2cost_read_words_1_memory_write_address, write_data => slice2cost_read_words_1_memory_write_data);

  slice2cost_read_words_0_memory_read_enable <= true;
  slice2cost_read_words_0_memory_read_address <= to_unsigned(slice2cost_read_column, 9);
  slice2cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_0_memory_write_data <= slice2cost_write_words_0;
  slice2cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_0_memory_read_enable,
      read_address => slice2cost_read_words_0_memory_read_address, read_data => slice2cost_read_words_0,
      write_address => slice2cost_read_words_0_memory_write_address, write_data => slice2cost_read_words_0_memory_write_data);

  slice1window_leaving_3_memory_read_enable <= true;
  slice1window_leaving_3_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_3_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_3_memory_write_data <= to_unsigned(slice1cost_column_0_15, 8) & to_unsigned(slice1cost_column_0_14, 8) & to_unsigned(slice1cost_column_0_13, 8) & to_unsigned(slice1cost_column_0_12, 8);
  slice1window_leaving_3_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_3_memory_read_enable,
      read_address => slice1window_leaving_3_memory_read_address, read_data => slice1window_leaving_3,
      write_address => slice1window_leaving_3_memory_write_address, write_data => slice1window_leaving_3_memory_write_data);

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_0_11, 8) & to_unsigned(slice1cost_column_0_10, 8) & to_unsigned(slice1cost_column_0_9, 8) & to_unsigned(slice1cost_column_0_8, 8);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving_2,
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0_7, 8) & to_unsigned(slice1cost_column_0_6, 8) & to_unsigned(slice1cost_column_0_5, 8) & to_unsigned(slice1cost_column_0_4, 8);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving_1,
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0_3, 8) & to_unsigned(slice1cost_column_0_2, 8) & to_unsigned(slice1cost_column_0_1, 8) & to_unsigned(slice1cost_column_0_0, 8);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving_0,
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_3_memory_read_enable <= true;
  slice1cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_3_memory_write_data <= slice1cost_write_words_3;
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words_3,
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_2_memory_write_data <= slice1cost_write_words_2;
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words_2,
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_1_memory_write_data <= slice1cost_write_words_1;
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words_1,
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_0_memory_write_data <= slice1cost_write_words_0;
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words_0,
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_3_memory_read_enable <= true;
  slice0window_leaving_3_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_3_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_3_memory_write_data <= to_unsigned(slice0cost_column_0_15, 8) & to_unsigned(slice0cost_column_0_14, 8) & to_unsigned(slice0cost_column_0_13, 8) & to_unsigned(slice0cost_column_0_12, 8);
  slice0window_leaving_3_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_3_memory_read_enable,
      read_address => slice0window_leaving_3_memory_read_address, read_data => slice0window_leaving_3,
      write_address => slice0window_leaving_3_memory_write_address, write_data => slice0window_leaving_3_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_0_11, 8) & to_unsigned(slice0cost_column_0_10, 8) & to_unsigned(slice0cost_column_0_9, 8) & to_unsigned(slice0cost_column_0_8, 8);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving_2,
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0_7, 8) & to_unsigned(slice0cost_column_0_6, 8) & to_unsigned(slice0cost_column_0_5, 8) & to_unsigned(slice0cost_column_0_4, 8);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving_1,
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0_3, 8) & to_unsigned(slice0cost_column_0_2, 8) & to_unsigned(slice0cost_column_0_1, 8) & to_unsigned(slice0cost_column_0_0, 8);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving_0,
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_3_memory_read_enable <= true;
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_3_memory_write_data <= slice0cost_write_words_3;
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words_3,
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_2_memory_write_data <= slice0cost_write_words_2;
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words_2,
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_1_memory_write_data <= slice0cost_write_words_1;
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words_1,
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_0_memory_write_data <= slice0cost_write_words_0;
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words_0,
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  rows_search_rows_read_words_8_memory_read_enable <= true;
  rows_search_rows_read_words_8_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_8_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_8_memory_write_data <= to_unsigned(rows_search_rows_write_words_8, 24);
  rows_search_rows_read_words_8_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_8_memory_read_enable,
      read_address => rows_search_rows_read_words_8_memory_read_address, read_data => rows_search_rows_read_words_8,
      write_address => rows_search_rows_read_words_8_memory_write_address, write_data => rows_search_rows_read_words_8_memory_write_data);

  rows_search_rows_read_words_7_memory_read_enable <= true;
  rows_search_rows_read_words_7_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_7_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_7_memory_write_data <= to_unsigned(rows_search_rows_write_words_7, 24);
  rows_search_rows_read_words_7_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_7_memory_read_enable,
      read_address => rows_search_rows_read_words_7_memory_read_address, read_data => rows_search_rows_read_words_7,
      write_address => rows_search_rows_read_words_7_memory_write_address, write_data => rows_search_rows_read_words_7_memory_write_data);

  rows_search_rows_read_words_6_memory_read_enable <= true;
  rows_search_rows_read_words_6_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_6_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_6_memory_write_data <= to_unsigned(rows_search_rows_write_words_6, 24);
  rows_search_rows_read_words_6_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_6_memory_read_enable,
      read_address => rows_search_rows_read_words_6_memory_read_address, read_data => rows_search_rows_read_words_6,
      write_address => rows_search_rows_read_words_6_memory_write_address, write_data => rows_search_rows_read_words_6_memory_write_data);

  rows_search_rows_read_words_5_memory_read_enable <= true;
  rows_search_rows_read_words_5_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_5_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_5_memory_write_data <= to_unsigned(rows_search_rows_write_words_5, 24);
  rows_search_rows_read_words_5_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_5_memory_read_enable,
      read_address => rows_search_rows_read_words_5_memory_read_address, read_data => rows_search_rows_read_words_5,
      write_address => rows_search_rows_read_words_5_memory_write_address, write_data => rows_search_rows_read_words_5_memory_write_data);

  rows_search_rows_read_words_4_memory_read_enable <= true;
  rows_search_rows_read_words_4_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_4_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_4_memory_write_data <= to_unsigned(rows_search_rows_write_words_4, 24);
  rows_search_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_4_memory_read_enable,
      read_address => rows_search_rows_read_words_4_memory_read_address, read_data => rows_search_rows_read_words_4,
      write_address => rows_search_rows_read_words_4_memory_write_address, write_data => rows_search_rows_read_words_4_memory_write_data);

  rows_search_rows_read_words_3_memory_read_enable <= true;
  rows_search_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_3_memory_write_data <= to_unsigned(rows_search_rows_write_words_3, 24);
  rows_search_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_3_memory_read_enable,
      read_address => rows_search_rows_read_words_3_memory_read_address, read_data => rows_search_rows_read_words_3,
      write_address => rows_search_rows_read_words_3_memory_write_address, write_data => rows_search_rows_read_words_3_memory_write_data);

  rows_search_rows_read_words_2_memory_read_enable <= true;
  rows_search_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words_2, 24);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words_2,
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words_1, 24);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 24);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_8_memory_read_enable <= true;
  rows_reference_rows_read_words_8_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_8_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_8_memory_write_data <= to_unsigned(rows_reference_rows_write_words_8, 24);
  rows_reference_rows_read_words_8_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_8_memory_read_enable,
      read_address => rows_reference_rows_read_words_8_memory_read_address, read_data => rows_reference_rows_read_words_8,
      write_address => rows_reference_rows_read_words_8_memory_write_address, write_data => rows_reference_rows_read_words_8_memory_write_data);

  rows_reference_rows_read_words_7_memory_read_enable <= true;
  rows_reference_rows_read_words_7_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_7_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_7_memory_write_data <= to_unsigned(rows_reference_rows_write_words_7, 24);
  rows_reference_rows_read_words_7_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_7_memory_read_enable,
      read_address => rows_reference_rows_read_words_7_memory_read_address, read_data => rows_reference_rows_read_words_7,
      write_address => rows_reference_rows_read_words_7_memory_write_address, write_data => rows_reference_rows_read_words_7_memory_write_data);

  rows_reference_rows_read_words_6_memory_read_enable <= true;
  rows_reference_rows_read_words_6_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_6_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_6_memory_write_data <= to_unsigned(rows_reference_rows_write_words_6, 24);
  rows_reference_rows_read_words_6_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_6_memory_read_enable,
      read_address => rows_reference_rows_read_words_6_memory_read_address, read_data => rows_reference_rows_read_words_6,
      write_address => rows_reference_rows_read_words_6_memory_write_address, write_data => rows_reference_rows_read_words_6_memory_write_data);

  rows_reference_rows_read_words_5_memory_read_enable <= true;
  rows_reference_rows_read_words_5_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_5_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_5_memory_write_data <= to_unsigned(rows_reference_rows_write_words_5, 24);
  rows_reference_rows_read_words_5_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_5_memory_read_enable,
      read_address => rows_reference_rows_read_words_5_memory_read_address, read_data => rows_reference_rows_read_words_5,
      write_address => rows_reference_rows_read_words_5_memory_write_address, write_data => rows_reference_rows_read_words_5_memory_write_data);

  rows_reference_rows_read_words_4_memory_read_enable <= true;
  rows_reference_rows_read_words_4_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_4_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_4_memory_write_data <= to_unsigned(rows_reference_rows_write_words_4, 24);
  rows_reference_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_4_memory_read_enable,
      read_address => rows_reference_rows_read_words_4_memory_read_address, read_data => rows_reference_rows_read_words_4,
      write_address => rows_reference_rows_read_words_4_memory_write_address, write_data => rows_reference_rows_read_words_4_memory_write_data);

  rows_reference_rows_read_words_3_memory_read_enable <= true;
  rows_reference_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_3_memory_write_data <= to_unsigned(rows_reference_rows_write_words_3, 24);
  rows_reference_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_3_memory_read_enable,
      read_address => rows_reference_rows_read_words_3_memory_read_address, read_data => rows_reference_rows_read_words_3,
      write_address => rows_reference_rows_read_words_3_memory_write_address, write_data => rows_reference_rows_read_words_3_memory_write_data);

  rows_reference_rows_read_words_2_memory_read_enable <= true;
  rows_reference_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words_2, 24);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words_2,
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 24);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 24);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_differs : boolean;
    variable transform_read_column_inside_0_is_less, transform_left_filter_feature_0_value : boolean;
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
    variable transform_left_filter_feature_0_choice_18, transform_left_filter_feature_0_value_7 : boolean;
    variable transform_left_filter_feature_0_choice_19, transform_left_filter_feature_0_value_8 : boolean;
    variable transform_left_filter_feature_0_choice_20, transform_left_filter_feature_0_value_9 : boolean;
    variable transform_left_filter_feature_0_choice_21, transform_left_filter_feature_0_value_10 : boolean;
    variable transform_left_filter_feature_0_choice_22, transform_left_filter_feature_0_value_11 : boolean;
    variable transform_left_filter_feature_0_choice_23, transform_left_filter_feature_0_choice_24 : boolean;
    variable transform_left_filter_feature_0_choice_25, transform_left_filter_feature_0_choice_26 : boolean;
    variable transform_left_filter_feature_0_choice_27, transform_left_filter_feature_0_choice_28 : boolean;
    variable transform_left_filter_feature_0_choice_29, transform_left_filter_feature_0_choice_30 : boolean;
    variable transform_left_filter_feature_0_choice_31, transform_left_filter_feature_0_choice_32 : boolean;
    variable transform_left_filter_feature_0_choice_33, transform_left_filter_feature_0_choice_34 : boolean;
    variable transform_left_filter_feature_0_choice_35, transform_left_filter_feature_0_choice_36 : boolean;
    variable transform_left_filter_feature_0_choice_37, transform_left_filter_feature_0_choice_38 : boolean;
    variable transform_left_filter_feature_0_choice_39, transform_left_filter_feature_0_choice_40 : boolean;
    variable transform_left_filter_feature_0_choice_41, transform_left_filter_feature_0_choice_42 : boolean;
    variable transform_left_filter_feature_0_choice_43, transform_left_filter_feature_0_choice_44 : boolean;
    variable transform_left_filter_feature_0_choice_45, transform_left_filter_feature_0_choice_46 : boolean;
    variable transform_left_filter_feature_0_choice_47, transform_left_filter_feature_0_choice_48 : boolean;
    variable transform_left_filter_feature_0_choice_49, transform_left_filter_feature_0_choice_50 : boolean;
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
    variable transform_left_filter_feature_0_choice_77, transform_left_filter_feature_0_choice_78 : boolean;
    variable transform_left_filter_feature_0_choice_79, transform_left_filter_feature_0_choice_80 : boolean;
    variable transform_left_filter_feature_0_choice_81, transform_left_filter_feature_0_choice_82 : boolean;
    variable transform_left_filter_feature_0_choice_83, transform_left_filter_feature_0_choice_84 : boolean;
    variable transform_left_filter_feature_0_choice_85, transform_left_filter_feature_0_choice_86 : boolean;
    variable transform_left_filter_feature_0_choice_87, transform_left_filter_feature_0_choice_88 : boolean;
    variable transform_left_filter_feature_0_choice_89, transform_left_filter_feature_0_choice_90 : boolean;
    variable transform_left_filter_feature_0_choice_91, transform_left_filter_feature_0_choice_92 : boolean;
    variable transform_left_filter_feature_0_choice_93, transform_left_filter_feature_0_choice_94 : boolean;
    variable transform_left_filter_feature_0_choice_95, transform_left_filter_feature_0_choice_96 : boolean;
    variable transform_left_filter_feature_0_choice_97, transform_left_filter_feature_0_choice_98 : boolean;
    variable transform_left_filter_feature_0_choice_99, transform_left_filter_feature_0_choice_100 : boolean;
    variable transform_left_filter_feature_0_choice_101, transform_left_filter_feature_0_choice_102 : boolean;
    variable transform_left_filter_feature_0_choice_103, transform_left_filter_feature_0_choice_104 : boolean;
    variable transform_left_filter_feature_0_choice_105, transform_left_filter_feature_0_choice_106 : boolean;
    variable transform_left_filter_feature_0_choice_107, transform_left_filter_feature_0_choice_108 : boolean;
    variable transform_left_filter_feature_0_choice_109, transform_left_filter_feature_0_choice_110 : boolean;
    variable transform_left_filter_feature_0_choice_111, transform_left_filter_feature_0_choice_112 : boolean;
    variable transform_left_filter_feature_0_choice_113, transform_left_filter_feature_0_choice_114 : boolean;
    variable transform_left_filter_feature_0_choice_115, transform_left_filter_feature_0_choice_116 : boolean;
    variable transform_left_filter_feature_0_choice_117, transform_left_filter_feature_0_choice_118 : boolean;
    variable transform_left_filter_feature_0_choice_119, transform_left_filter_feature_0_choice_120 : boolean;
    variable transform_left_filter_feature_0_choice_121, transform_left_filter_feature_0_choice_122 : boolean;
    variable transform_left_filter_feature_0_choice_123, transform_left_filter_feature_0_choice_124 : boolean;
    variable transform_left_filter_feature_0_choice_125, transform_left_filter_feature_0_choice_126 : boolean;
    variable transform_left_filter_feature_0_choice_127, transform_left_filter_feature_0_choice_128 : boolean;
    variable transform_left_filter_feature_0_choice_129, transform_left_filter_feature_0_choice_130 : boolean;
    variable transform_left_filter_feature_0_choice_131, transform_left_filter_feature_0_choice_132 : boolean;
    variable transform_left_filter_feature_0_choice_133, transform_left_filter_feature_0_choice_134 : boolean;
    variable transform_left_filter_feature_0_choice_135, transform_left_filter_feature_0_choice_136 : boolean;
    variable transform_left_filter_feature_0_choice_137, transform_left_filter_feature_0_choice_138 : boolean;
    variable transform_left_filter_feature_0_choice_139, transform_left_filter_feature_0_choice_140 : boolean;
    variable transform_left_filter_feature_0_choice_141, transform_left_filter_feature_0_choice_142 : boolean;
    variable transform_left_filter_feature_0_choice_143, transform_left_filter_feature_0_choice_144 : boolean;
    variable transform_left_filter_feature_0_choice_145, transform_left_filter_feature_0_choice_146 : boolean;
    variable transform_left_filter_feature_0_choice_147, transform_left_filter_feature_0_choice_148 : boolean;
    variable transform_left_filter_feature_0_choice_149, transform_left_filter_feature_0_choice_150 : boolean;
    variable transform_left_filter_feature_0_choice_151, transform_left_filter_feature_0_choice_152 : boolean;
    variable transform_left_filter_feature_0_choice_153, transform_left_filter_feature_0_choice_154 : boolean;
    variable transform_left_filter_feature_0_choice_155, transform_left_filter_feature_0_choice_156 : boolean;
    variable transform_left_filter_feature_0_choice_157, transform_left_filter_feature_0_choice_158 : boolean;
    variable transform_left_filter_feature_0_choice_159, transform_left_filter_feature_0_choice_160 : boolean;
    variable transform_left_filter_feature_0_choice_161, transform_left_filter_feature_0_choice_162 : boolean;
    variable transform_left_filter_feature_0_choice_163, transform_left_filter_feature_0_choice_164 : boolean;
    variable transform_left_filter_feature_0_choice_165, transform_left_filter_feature_0_choice_166 : boolean;
    variable transform_left_filter_feature_0_choice_167, transform_left_filter_feature_0_choice_168 : boolean;
    variable transform_left_filter_feature_0_choice_169, transform_left_filter_feature_0_choice_170 : boolean;
    variable transform_left_filter_feature_0_choice_171, transform_left_filter_feature_0_choice_172 : boolean;
    variable transform_left_filter_feature_0_choice_173, transform_left_filter_feature_0_choice_174 : boolean;
    variable transform_left_filter_feature_0_choice_175, transform_left_filter_feature_0_choice_176 : boolean;
    variable transform_left_filter_feature_0_choice_177, transform_left_filter_feature_0_choice_178 : boolean;
    variable transform_left_filter_feature_0_choice_179, transform_left_filter_feature_0_choice_180 : boolean;
    variable transform_left_filter_feature_0_choice_181, transform_left_filter_feature_0_choice_182 : boolean;
    variable transform_left_filter_feature_0_choice_183, transform_left_filter_feature_0_choice_184 : boolean;
    variable transform_left_filter_feature_0_choice_185, transform_left_filter_feature_0_choice_186 : boolean;
    variable transform_left_filter_feature_0_choice_187, transform_left_filter_feature_0_choice_188 : boolean;
    variable transform_left_filter_feature_0_choice_189, transform_left_filter_feature_0_choice_190 : boolean;
    variable transform_left_filter_feature_0_choice_191, transform_left_filter_feature_0_choice_192 : boolean;
    variable transform_left_filter_feature_0_choice_193, transform_right_filter_feature_0_value : boolean;
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
    variable transform_right_filter_feature_0_choice_16, transform_right_filter_feature_0_choice_17 : boolean;
    variable transform_right_filter_feature_0_choice_18, transform_right_filter_feature_0_value_7 : boolean;
    variable transform_right_filter_feature_0_choice_19, transform_right_filter_feature_0_value_8 : boolean;
    variable transform_right_filter_feature_0_choice_20, transform_right_filter_feature_0_value_9 : boolean;
    variable transform_right_filter_feature_0_choice_21, transform_right_filter_feature_0_value_10 : boolean;
    variable transform_right_filter_feature_0_choice_22, transform_right_filter_feature_0_value_11 : boolean;
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
    variable transform_right_filter_feature_0_choice_193, transform_counter_next_frame_choice : boolean;
    variable transform_counter_next_frame_choice_2, raster_place_group_is_equal : boolean;
    variable delay_tag_first_column_is_equal, slice0cost_pixels_first_0_0_count_0_value : boolean;
    variable slice0cost_pixels_first_0_0_count_0_value_2, slice0cost_pixels_first_0_0_count_1_value : boolean;
    variable slice0cost_pixels_first_0_0_count_1_value_2, slice0cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_2_value, slice0cost_pixels_first_0_0_count_2_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_3_value, slice0cost_pixels_first_0_0_count_3_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_3_value_3, slice0cost_pixels_first_0_0_count_4_value : boolean;
    variable slice0cost_pixels_first_0_0_count_4_value_2, slice0cost_pixels_first_0_0_count_4_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_5_value, slice0cost_pixels_first_0_0_count_5_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_5_value_3, slice0cost_pixels_first_0_0_count_6_value : boolean;
    variable slice0cost_pixels_first_0_0_count_6_value_2, slice0cost_pixels_first_0_0_count_6_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_7_value, slice0cost_pixels_first_0_0_count_7_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_0_value, slice0cost_pixels_first_1_0_count_0_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_1_value, slice0cost_pixels_first_1_0_count_1_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_1_value_3, slice0cost_pixels_first_1_0_count_2_value : boolean;
    variable slice0cost_pixels_first_1_0_count_2_value_2, slice0cost_pixels_first_1_0_count_3_value : boolean;
    variable slice0cost_pixels_first_1_0_count_3_value_2, slice0cost_pixels_first_1_0_count_3_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_4_value, slice0cost_pixels_first_1_0_count_4_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_4_value_3, slice0cost_pixels_first_1_0_count_5_value : boolean;
    variable slice0cost_pixels_first_1_0_count_5_value_2, slice0cost_pixels_first_1_0_count_5_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_6_value, slice0cost_pixels_first_1_0_count_6_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_6_value_3, slice0cost_pixels_first_1_0_count_7_value : boolean;
    variable slice0cost_pixels_first_1_0_count_7_value_2, slice0mask_inside_0_choice : boolean;
    variable slice0mask_inside_1_choice, slice0mask_inside_2_choice, slice0mask_inside_3_choice : boolean;
    variable slice0mask_inside_4_choice, slice0mask_inside_5_choice, slice0mask_inside_6_choice : boolean;
    variable slice0mask_inside_7_choice, slice0mask_inside_8_choice, slice0mask_inside_9_choice : boolean;
    variable slice0mask_inside_10_choice, slice0mask_inside_11_choice, slice0mask_inside_12_choice : boolean;
    variable slice0mask_inside_13_choice, slice0mask_inside_14_choice, slice0mask_inside_15_choice : boolean;
    variable slice0winner1_best_cost_0_0_is_less, slice0winner1_best_cost_0_1_is_less : boolean;
    variable slice0winner1_best_cost_0_2_is_less, slice0winner1_best_cost_0_3_is_less : boolean;
    variable slice0winner1_best_cost_0_4_is_less, slice0winner1_best_cost_0_5_is_less : boolean;
    variable slice0winner1_best_cost_0_6_is_less, slice0winner1_best_cost_0_7_is_less : boolean;
    variable slice0winner2_best_cost_0_0_is_less, slice0winner2_best_cost_0_1_is_less : boolean;
    variable slice0winner2_best_cost_0_2_is_less, slice0winner2_best_cost_0_3_is_less : boolean;
    variable slice0winner3_best_cost_0_0_is_less, slice0winner3_best_cost_0_1_is_less : boolean;
    variable slice0winner4_best_cost_0_0_is_less, slice1cost_pixels_first_0_0_count_0_value : boolean;
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
    variable slice1cost_pixels_first_1_0_count_0_value, slice1cost_pixels_first_1_0_count_0_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_1_value, slice1cost_pixels_first_1_0_count_1_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_1_value_3, slice1cost_pixels_first_1_0_count_2_value : boolean;
    variable slice1cost_pixels_first_1_0_count_2_value_2, slice1cost_pixels_first_1_0_count_3_value : boolean;
    variable slice1cost_pixels_first_1_0_count_3_value_2, slice1cost_pixels_first_1_0_count_3_value_3 : boolean;
    variable slice1cost_pixels_first_1_0_count_4_value, slice1cost_pixels_first_1_0_count_4_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_4_value_3, slice1cost_pixels_first_1_0_count_5_value : boolean;
    variable slice1cost_pixels_first_1_0_count_5_value_2, slice1cost_pixels_first_1_0_count_5_value_3 : boolean;
    variable slice1cost_pixels_first_1_0_count_6_value, slice1cost_pixels_first_1_0_count_6_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_count_6_value_3, slice1cost_pixels_first_1_0_count_7_value : boolean;
    variable slice1cost_pixels_first_1_0_count_7_value_2, slice1mask_inside_0_all, slice1mask_inside_0_choice : boolean;
    variable slice1mask_inside_1_choice, slice1mask_inside_2_choice, slice1mask_inside_3_choice : boolean;
    variable slice1mask_inside_4_choice, slice1mask_inside_5_choice, slice1mask_inside_6_choice : boolean;
    variable slice1mask_inside_7_choice, slice1mask_inside_8_choice, slice1mask_inside_9_choice : boolean;
    variable slice1mask_inside_10_choice, slice1mask_inside_11_choice, slice1mask_inside_12_choice : boolean;
    variable slice1mask_inside_13_choice, slice1mask_inside_14_choice, slice1mask_inside_15_choice : boolean;
    variable slice1winner1_best_cost_0_0_is_less, slice1winner1_best_cost_0_1_is_less : boolean;
    variable slice1winner1_best_cost_0_2_is_less, slice1winner1_best_cost_0_3_is_less : boolean;
    variable slice1winner1_best_cost_0_4_is_less, slice1winner1_best_cost_0_5_is_less : boolean;
    variable slice1winner1_best_cost_0_6_is_less, slice1winner1_best_cost_0_7_is_less : boolean;
    variable slice1winner2_best_cost_0_0_is_less, slice1winner2_best_cost_0_1_is_less : boolean;
    variable slice1winner2_best_cost_0_2_is_less, slice1winner2_best_cost_0_3_is_less : boolean;
    variable slice1winner3_best_cost_0_0_is_less, slice1winner3_best_cost_0_1_is_less : boolean;
    variable slice1winner4_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less : boolean;
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
    variable slice2cost_pixels_first_0_0_count_7_value_2, slice2cost_pixels_first_1_0_count_0_value : boolean;
    variable slice2cost_pixels_first_1_0_count_0_value_2, slice2cost_pixels_first_1_0_count_1_value : boolean;
    variable slice2cost_pixels_first_1_0_count_1_value_2, slice2cost_pixels_first_1_0_count_1_value_3 : boolean;
    variable slice2cost_pixels_first_1_0_count_2_value, slice2cost_pixels_first_1_0_count_2_value_2 : boolean;
    variable slice2cost_pixels_first_1_0_count_3_value, slice2cost_pixels_first_1_0_count_3_value_2 : boolean;
    variable slice2cost_pixels_first_1_0_count_3_value_3, slice2cost_pixels_first_1_0_count_4_value : boolean;
    variable slice2cost_pixels_first_1_0_count_4_value_2, slice2cost_pixels_first_1_0_count_4_value_3 : boolean;
    variable slice2cost_pixels_first_1_0_count_5_value, slice2cost_pixels_first_1_0_count_5_value_2 : boolean;
    variable slice2cost_pixels_first_1_0_count_5_value_3, slice2cost_pixels_first_1_0_count_6_value : boolean;
    variable slice2cost_pixels_first_1_0_count_6_value_2, slice2cost_pixels_first_1_0_count_6_value_3 : boolean;
    variable slice2cost_pixels_first_1_0_count_7_value, slice2cost_pixels_first_1_0_count_7_value_2 : boolean;
    variable slice2mask_inside_0_all, slice2mask_inside_0_choice, slice2mask_inside_1_choice : boolean;
    variable slice2mask_inside_2_choice, slice2mask_inside_3_choice, slice2mask_inside_4_choice : boolean;
    variable slice2mask_inside_5_choice, slice2mask_inside_6_choice, slice2mask_inside_7_choice : boolean;
    variable slice2mask_inside_8_choice, slice2mask_inside_9_choice, slice2mask_inside_10_choice : boolean;
    variable slice2mask_inside_11_choice, slice2mask_inside_12_choice, slice2mask_inside_13_choice : boolean;
    variable slice2mask_inside_14_choice, slice2mask_inside_15_choice, slice2winner1_best_cost_0_0_is_less : boolean;
    variable slice2winner1_best_cost_0_1_is_less, slice2winner1_best_cost_0_2_is_less : boolean;
    variable slice2winner1_best_cost_0_3_is_less, slice2winner1_best_cost_0_4_is_less : boolean;
    variable slice2winner1_best_cost_0_5_is_less, slice2winner1_best_cost_0_6_is_less : boolean;
    variable slice2winner1_best_cost_0_7_is_less, slice2winner2_best_cost_0_0_is_less : boolean;
    variable slice2winner2_best_cost_0_1_is_less, slice2winner2_best_cost_0_2_is_less : boolean;
    variable slice2winner2_best_cost_0_3_is_less, slice2winner3_best_cost_0_0_is_less : boolean;
    variable slice2winner3_best_cost_0_1_is_less, slice2winner4_best_cost_0_0_is_less : boolean;
    variable slice2_best_cost_0_0_is_less, refinement_tag_11_row_start_differs : boolean;
    variable refinement_tag_11_row_start_is_equal, refinement_tag_11_row_start_choice : boolean;
    variable refinement_tag_11_row_start_choice_2, refinement_tag_11_row_start_is_equal_2 : boolean;
    variable refinement_tag_11_row_start_all, refinement_tag_11_row_start_choice_3 : boolean;
    variable refinement_tag_11_row_start_all_2, refinement_below_0_differs, refinement_below_0_value : boolean;
    variable refinement_below_0_value_2, refinement_below_0_choice, refinement_above_0_differs : boolean;
    variable refinement_above_0_choice, refinement_divisor_0_0_is_less, map_counter_group_is_equal : boolean;
    variable map_line_ended_choice, map_at_arrives_value, map_window_complete_is_equal : boolean;
    variable map_window_complete_choice, map_low_1_0_all, map_low_0_0_all : boolean;
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 511;
    variable map_counter_group_choice_2, map_counter_group_choice_3 : natural range 0 to 511;
    variable slice0cost_column_0_0_choice, slice0cost_column_0_0_value : natural range 0 to 255;
    variable slice0cost_column_0_1_choice, slice0cost_column_0_1_value : natural range 0 to 255;
    variable slice0cost_column_0_2_choice, slice0cost_column_0_2_value : natural range 0 to 255;
    variable slice0cost_column_0_3_choice, slice0cost_column_0_3_value : natural range 0 to 255;
    variable slice0cost_column_0_4_choice, slice0cost_column_0_4_value : natural range 0 to 255;
    variable slice0cost_column_0_5_choice, slice0cost_column_0_5_value : natural range 0 to 255;
    variable slice0cost_column_0_6_choice, slice0cost_column_0_6_value : natural range 0 to 255;
    variable slice0cost_column_0_7_choice, slice0cost_column_0_7_value : natural range 0 to 255;
    variable slice0cost_column_0_8_choice, slice0cost_column_0_8_value : natural range 0 to 255;
    variable slice0cost_column_0_9_choice, slice0cost_column_0_9_value : natural range 0 to 255;
    variable slice0cost_column_0_10_choice, slice0cost_column_0_10_value : natural range 0 to 255;
    variable slice0cost_column_0_11_choice, slice0cost_column_0_11_value : natural range 0 to 255;
    variable slice0cost_column_0_12_choice, slice0cost_column_0_12_value : natural range 0 to 255;
    variable slice0cost_column_0_13_choice, slice0cost_column_0_13_value : natural range 0 to 255;
    variable slice0cost_column_0_14_choice, slice0cost_column_0_14_value : natural range 0 to 255;
    variable slice0cost_column_0_15_choice, slice0cost_column_0_15_value : natural range 0 to 255;
    variable slice0window_change_0_0_choice, slice0window_change_0_1_choice : natural range 0 to 255;
    variable slice0window_change_0_2_choice, slice0window_change_0_3_choice : natural range 0 to 255;
    variable slice0window_change_0_4_choice, slice0window_change_0_5_choice : natural range 0 to 255;
    variable slice0window_change_0_6_choice, slice0window_change_0_7_choice : natural range 0 to 255;
    variable slice0window_change_0_8_choice, slice0window_change_0_9_choice : natural range 0 to 255;
    variable slice0window_change_0_10_choice, slice0window_change_0_11_choice : natural range 0 to 255;
    variable slice0window_change_0_12_choice, slice0window_change_0_13_choice : natural range 0 to 255;
    variable slice0window_change_0_14_choice, slice0window_change_0_15_choice : natural range 0 to 255;
    variable slice1cost_column_0_0_choice, slice1cost_column_0_0_value : natural range 0 to 255;
    variable slice1cost_column_0_1_choice, slice1cost_column_0_1_value : natural range 0 to 255;
    variable slice1cost_column_0_2_choice, slice1cost_column_0_2_value : natural range 0 to 255;
    variable slice1cost_column_0_3_choice, slice1cost_column_0_3_value : natural range 0 to 255;
    variable slice1cost_column_0_4_choice, slice1cost_column_0_4_value : natural range 0 to 255;
    variable slice1cost_column_0_5_choice, slice1cost_column_0_5_value : natural range 0 to 255;
    variable slice1cost_column_0_6_choice, slice1cost_column_0_6_value : natural range 0 to 255;
    variable slice1cost_column_0_7_choice, slice1cost_column_0_7_value : natural range 0 to 255;
    variable slice1cost_column_0_8_choice, slice1cost_column_0_8_value : natural range 0 to 255;
    variable slice1cost_column_0_9_choice, slice1cost_column_0_9_value : natural range 0 to 255;
    variable slice1cost_column_0_10_choice, slice1cost_column_0_10_value : natural range 0 to 255;
    variable slice1cost_column_0_11_choice, slice1cost_column_0_11_value : natural range 0 to 255;
    variable slice1cost_column_0_12_choice, slice1cost_column_0_12_value : natural range 0 to 255;
    variable slice1cost_column_0_13_choice, slice1cost_column_0_13_value : natural range 0 to 255;
    variable slice1cost_column_0_14_choice, slice1cost_column_0_14_value : natural range 0 to 255;
    variable slice1cost_column_0_15_choice, slice1cost_column_0_15_value : natural range 0 to 255;
    variable slice1window_change_0_0_choice, slice1window_change_0_1_choice : natural range 0 to 255;
    variable slice1window_change_0_2_choice, slice1window_change_0_3_choice : natural range 0 to 255;
    variable slice1window_change_0_4_choice, slice1window_change_0_5_choice : natural range 0 to 255;
    variable slice1window_change_0_6_choice, slice1window_change_0_7_choice : natural range 0 to 255;
    variable slice1window_change_0_8_choice, slice1window_change_0_9_choice : natural range 0 to 255;
    variable slice1window_change_0_10_choice, slice1window_change_0_11_choice : natural range 0 to 255;
    variable slice1window_change_0_12_choice, slice1window_change_0_13_choice : natural range 0 to 255;
    variable slice1window_change_0_14_choice, slice1window_change_0_15_choice : natural range 0 to 255;
    variable slice2cost_column_0_0_choice, slice2cost_column_0_0_value : natural range 0 to 255;
    variable slice2cost_column_0_1_choice, slice2cost_column_0_1_value : natural range 0 to 255;
    variable slice2cost_column_0_2_choice, slice2cost_column_0_2_value : natural range 0 to 255;
    variable slice2cost_column_0_3_choice, slice2cost_column_0_3_value : natural range 0 to 255;
    variable slice2cost_column_0_4_choice, slice2cost_column_0_4_value : natural range 0 to 255;
    variable slice2cost_column_0_5_choice, slice2cost_column_0_5_value : natural range 0 to 255;
    variable slice2cost_column_0_6_choice, slice2cost_column_0_6_value : natural range 0 to 255;
    variable slice2cost_column_0_7_choice, slice2cost_column_0_7_value : natural range 0 to 255;
    variable slice2cost_column_0_8_choice, slice2cost_column_0_8_value : natural range 0 to 255;
    variable slice2cost_column_0_9_choice, slice2cost_column_0_9_value : natural range 0 to 255;
    variable slice2cost_column_0_10_choice, slice2cost_column_0_10_value : natural range 0 to 255;
    variable slice2cost_column_0_11_choice, slice2cost_column_0_11_value : natural range 0 to 255;
    variable slice2cost_column_0_12_choice, slice2cost_column_0_12_value : natural range 0 to 255;
    variable slice2cost_column_0_13_choice, slice2cost_column_0_13_value : natural range 0 to 255;
    variable slice2cost_column_0_14_choice, slice2cost_column_0_14_value : natural range 0 to 255;
    variable slice2cost_column_0_15_choice, slice2cost_column_0_15_value : natural range 0 to 255;
    variable slice2window_change_0_0_choice, slice2window_change_0_1_choice : natural range 0 to 255;
    variable slice2window_change_0_2_choice, slice2window_change_0_3_choice : natural range 0 to 255;
    variable slice2window_change_0_4_choice, slice2window_change_0_5_choice : natural range 0 to 255;
    variable slice2window_change_0_6_choice, slice2window_change_0_7_choice : natural range 0 to 255;
    variable slice2window_change_0_8_choice, slice2window_change_0_9_choice : natural range 0 to 255;
    variable slice2window_change_0_10_choice, slice2window_change_0_11_choice : natural range 0 to 255;
    variable slice2window_change_0_12_choice, slice2window_change_0_13_choice : natural range 0 to 255;
    variable slice2window_change_0_14_choice, slice2window_change_0_15_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable slice0window_sum_0_0_choice, slice0window_sum_0_1_choice : natural range 0 to 2047;
    variable slice0window_sum_0_2_choice, slice0window_sum_0_3_choice : natural range 0 to 2047;
    variable slice0window_sum_0_4_choice, slice0window_sum_0_5_choice : natural range 0 to 2047;
    variable slice0window_sum_0_6_choice, slice0window_sum_0_7_choice : natural range 0 to 2047;
    variable slice0window_sum_0_8_choice, slice0window_sum_0_9_choice : natural range 0 to 2047;
    variable slice0window_sum_0_10_choice, slice0window_sum_0_11_choice : natural range 0 to 2047;
    variable slice0window_sum_0_12_choice, slice0window_sum_0_13_choice : natural range 0 to 2047;
    variable slice0window_sum_0_14_choice, slice0window_sum_0_15_choice : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_0_choice, slice0winner1_best_cost_0_0_any : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_0_choice_2, slice0winner1_best_cost_0_0_any_2 : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_1_choice, slice0winner1_best_cost_0_1_any : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_1_choice_2, slice0winner1_best_cost_0_1_any_2 : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_2_choice, slice0winner1_best_cost_0_2_any : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_2_choice_2, slice0winner1_best_cost_0_2_any_2 : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_3_choice, slice0winner1_best_cost_0_3_any : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_3_choice_2, slice0winner1_best_cost_0_3_any_2 : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_4_choice, slice0winner1_best_cost_0_4_any : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_4_choice_2, slice0winner1_best_cost_0_4_any_2 : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_5_choice, slice0winner1_best_cost_0_5_any : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_5_choice_2, slice0winner1_best_cost_0_5_any_2 : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_6_choice, slice0winner1_best_cost_0_6_any : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_6_choice_2, slice0winner1_best_cost_0_6_any_2 : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_7_choice, slice0winner1_best_cost_0_7_any : natural range 0 to 2047;
    variable slice0winner1_best_cost_0_7_choice_2, slice0winner1_best_cost_0_7_any_2 : natural range 0 to 2047;
    variable slice0winner2_best_below_0_0_choice, slice0winner2_best_below_0_1_choice : natural range 0 to 2047;
    variable slice0winner2_best_below_0_2_choice, slice0winner2_best_below_0_3_choice : natural range 0 to 2047;
    variable slice0winner2_best_above_0_0_choice, slice0winner2_best_above_0_1_choice : natural range 0 to 2047;
    variable slice0winner2_best_above_0_2_choice, slice0winner2_best_above_0_3_choice : natural range 0 to 2047;
    variable slice0winner3_best_below_0_0_choice, slice0winner3_best_below_0_1_choice : natural range 0 to 2047;
    variable slice0winner3_best_above_0_0_choice, slice0winner3_best_above_0_1_choice : natural range 0 to 2047;
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1window_sum_0_0_choice, slice1window_sum_0_1_choice : natural range 0 to 2047;
    variable slice1window_sum_0_2_choice, slice1window_sum_0_3_choice : natural range 0 to 2047;
    variable slice1window_sum_0_4_choice, slice1window_sum_0_5_choice : natural range 0 to 2047;
    variable slice1window_sum_0_6_choice, slice1window_sum_0_7_choice : natural range 0 to 2047;
    variable slice1window_sum_0_8_choice, slice1window_sum_0_9_choice : natural range 0 to 2047;
    variable slice1window_sum_0_10_choice, slice1window_sum_0_11_choice : natural range 0 to 2047;
    variable slice1window_sum_0_12_choice, slice1window_sum_0_13_choice : natural range 0 to 2047;
    variable slice1window_sum_0_14_choice, slice1window_sum_0_15_choice : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_0_choice, slice1winner1_best_cost_0_0_any : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_0_choice_2, slice1winner1_best_cost_0_0_any_2 : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_1_choice, slice1winner1_best_cost_0_1_any : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_1_choice_2, slice1winner1_best_cost_0_1_any_2 : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_2_choice, slice1winner1_best_cost_0_2_any : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_2_choice_2, slice1winner1_best_cost_0_2_any_2 : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_3_choice, slice1winner1_best_cost_0_3_any : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_3_choice_2, slice1winner1_best_cost_0_3_any_2 : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_4_choice, slice1winner1_best_cost_0_4_any : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_4_choice_2, slice1winner1_best_cost_0_4_any_2 : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_5_choice, slice1winner1_best_cost_0_5_any : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_5_choice_2, slice1winner1_best_cost_0_5_any_2 : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_6_choice, slice1winner1_best_cost_0_6_any : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_6_choice_2, slice1winner1_best_cost_0_6_any_2 : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_7_choice, slice1winner1_best_cost_0_7_any : natural range 0 to 2047;
    variable slice1winner1_best_cost_0_7_choice_2, slice1winner1_best_cost_0_7_any_2 : natural range 0 to 2047;
    variable slice1winner2_best_below_0_0_choice, slice1winner2_best_below_0_1_choice : natural range 0 to 2047;
    variable slice1winner2_best_below_0_2_choice, slice1winner2_best_below_0_3_choice : natural range 0 to 2047;
    variable slice1winner2_best_above_0_0_choice, slice1winner2_best_above_0_1_choice : natural range 0 to 2047;
    variable slice1winner2_best_above_0_2_choice, slice1winner2_best_above_0_3_choice : natural range 0 to 2047;
    variable slice1winner3_best_below_0_0_choice, slice1winner3_best_below_0_1_choice : natural range 0 to 2047;
    variable slice1winner3_best_above_0_0_choice, slice1winner3_best_above_0_1_choice : natural range 0 to 2047;
    variable slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 2047;
    variable slice2window_sum_0_0_choice, slice2window_sum_0_1_choice : natural range 0 to 2047;
    variable slice2window_sum_0_2_choice, slice2window_sum_0_3_choice : natural range 0 to 2047;
    variable slice2window_sum_0_4_choice, slice2window_sum_0_5_choice : natural range 0 to 2047;
    variable slice2window_sum_0_6_choice, slice2window_sum_0_7_choice : natural range 0 to 2047;
    variable slice2window_sum_0_8_choice, slice2window_sum_0_9_choice : natural range 0 to 2047;
    variable slice2window_sum_0_10_choice, slice2window_sum_0_11_choice : natural range 0 to 2047;
    variable slice2window_sum_0_12_choice, slice2window_sum_0_13_choice : natural range 0 to 2047;
    variable slice2window_sum_0_14_choice, slice2window_sum_0_15_choice : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_0_choice, slice2winner1_best_cost_0_0_any : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_0_choice_2, slice2winner1_best_cost_0_0_any_2 : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_1_choice, slice2winner1_best_cost_0_1_any : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_1_choice_2, slice2winner1_best_cost_0_1_any_2 : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_2_choice, slice2winner1_best_cost_0_2_any : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_2_choice_2, slice2winner1_best_cost_0_2_any_2 : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_3_choice, slice2winner1_best_cost_0_3_any : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_3_choice_2, slice2winner1_best_cost_0_3_any_2 : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_4_choice, slice2winner1_best_cost_0_4_any : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_4_choice_2, slice2winner1_best_cost_0_4_any_2 : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_5_choice, slice2winner1_best_cost_0_5_any : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_5_choice_2, slice2winner1_best_cost_0_5_any_2 : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_6_choice, slice2winner1_best_cost_0_6_any : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_6_choice_2, slice2winner1_best_cost_0_6_any_2 : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_7_choice, slice2winner1_best_cost_0_7_any : natural range 0 to 2047;
    variable slice2winner1_best_cost_0_7_choice_2, slice2winner1_best_cost_0_7_any_2 : natural range 0 to 2047;
    variable slice2winner2_best_below_0_0_choice, slice2winner2_best_below_0_1_choice : natural range 0 to 2047;
    variable slice2winner2_best_below_0_2_choice, slice2winner2_best_below_0_3_choice : natural range 0 to 2047;
    variable slice2winner2_best_above_0_0_choice, slice2winner2_best_above_0_1_choice : natural range 0 to 2047;
    variable slice2winner2_best_above_0_2_choice, slice2winner2_best_above_0_3_choice : natural range 0 to 2047;
    variable slice2winner3_best_below_0_0_choice, slice2winner3_best_below_0_1_choice : natural range 0 to 2047;
    variable slice2winner3_best_above_0_0_choice, slice2winner3_best_above_0_1_choice : natural range 0 to 2047;
    variable slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice2_best_below_0_0_choice, slice2_best_above_0_0_choice : natural range 0 to 2047;
    variable refinement_divisor_0_0_choice : natural range 0 to 2047;
    variable refinement_remainder_1_0_difference : natural range 2049 to 6143;
    variable refinement_remainder_2_0_difference, refinement_remainder_3_0_difference : natural range 2049 to 8190;
    variable refinement_remainder_4_0_difference, refinement_remainder_5_0_difference : natural range 2049 to 8190;
    variable refinement_remainder_6_0_difference, refinement_remainder_7_0_difference : natural range 2049 to 8190;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable map_of_column_0_a_choice : natural range 0 to 4095;
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
      transform_counter_group_is_equal := transform_counter_group = 374;
      transform_counter_group_is_equal_2 := transform_counter_column = 449;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 375;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_differs := transform_counter_group /= 377;
      if (transform_counter_group = 376) and transform_counter_next_frame then
        transform_counter_group_choice_2 := 2;
      else
        transform_counter_group_choice_2 := (transform_counter_group + 1) mod 512;
      end if;
      if transform_counter_group_differs and in_valid and transform_counter_group_is_equal_2 then
        transform_counter_group_choice_3 := transform_counter_group_choice_2;
      else
        transform_counter_group_choice_3 := transform_counter_group;
      end if;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
      transform_left_filter_feature_0_value := ((transform_left_filter_column_4_2 / 2) mod 2) = 1;
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        ((transform_left_filter_column_4_2 mod 2) = 1));
      if (transform_left_filter_column_0_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_4_2 mod 4) = 0;
      if ((transform_left_filter_column_0_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choice_2 := ((transform_left_filter_column_0_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_2 := ((transform_left_filter_column_4_2 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_2 then
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_3 := ((transform_left_filter_column_4_2 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_3 then
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_4 := ((transform_left_filter_column_4_2 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_4 then
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_5 := ((transform_left_filter_column_4_2 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_5 then
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_6 := ((transform_left_filter_column_4_2 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_6 then
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_7 then
        transform_left_filter_feature_0_choice_8 := transform_filtering_0_column_inside_0 and
          ((transform_left_filter_column_0_1 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_8 := transform_filtering_0_column_inside_0 and
          (((transform_left_filter_column_0_1 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_0_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_9 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_9 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_10 := transform_left_filter_feature_0_choice_9;
      else
        transform_left_filter_feature_0_choice_10 := ((transform_left_filter_column_0_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_10 then
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_11 then
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_12 then
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_13 then
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_14 then
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_15 then
        transform_left_filter_feature_0_choice_16 := transform_filtering_0_column_inside_0 and
          ((transform_left_filter_column_0_3 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_16 := transform_filtering_0_column_inside_0 and
          (((transform_left_filter_column_0_3 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_0_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_17 := (transform_left_filter_column_4_2 mod 4) = 3;
      else
        transform_left_filter_feature_0_choice_17 := transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_18 := transform_left_filter_feature_0_choice_17;
      else
        transform_left_filter_feature_0_choice_18 := (not ((transform_left_filter_column_0_0 mod 2) = 1)) or
          transform_left_filter_feature_0_value or ((transform_left_filter_column_4_2 mod 2) = 1);
      end if;
      transform_left_filter_feature_0_value_7 := ((transform_left_filter_column_0_0 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_18 then
        transform_left_filter_feature_0_choice_19 := transform_left_filter_feature_0_value_7 and (not
          transform_left_filter_feature_0_value_2);
      else
        transform_left_filter_feature_0_choice_19 := transform_left_filter_feature_0_value_7 or (not
          transform_left_filter_feature_0_value_2);
      end if;
      transform_left_filter_feature_0_value_8 := ((transform_left_filter_column_0_0 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_19 then
        transform_left_filter_feature_0_choice_20 := transform_left_filter_feature_0_value_8 or (not
          transform_left_filter_feature_0_value_3);
      else
        transform_left_filter_feature_0_choice_20 := transform_left_filter_feature_0_value_8 and (not
          transform_left_filter_feature_0_value_3);
      end if;
      transform_left_filter_feature_0_value_9 := ((transform_left_filter_column_0_0 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_20 then
        transform_left_filter_feature_0_choice_21 := transform_left_filter_feature_0_value_9 or (not
          transform_left_filter_feature_0_value_4);
      else
        transform_left_filter_feature_0_choice_21 := transform_left_filter_feature_0_value_9 and (not
          transform_left_filter_feature_0_value_4);
      end if;
      transform_left_filter_feature_0_value_10 := ((transform_left_filter_column_0_0 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_21 then
        transform_left_filter_feature_0_choice_22 := transform_left_filter_feature_0_value_10 or (not
          transform_left_filter_feature_0_value_5);
      else
        transform_left_filter_feature_0_choice_22 := transform_left_filter_feature_0_value_10 and (not
          transform_left_filter_feature_0_value_5);
      end if;
      transform_left_filter_feature_0_value_11 := ((transform_left_filter_column_0_0 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_22 then
        transform_left_filter_feature_0_choice_23 := transform_left_filter_feature_0_value_11 or (not
          transform_left_filter_feature_0_value_6);
      else
        transform_left_filter_feature_0_choice_23 := transform_left_filter_feature_0_value_11 and (not
          transform_left_filter_feature_0_value_6);
      end if;
      if (transform_left_filter_column_0_0 / 128) = 1 then
        transform_left_filter_feature_0_choice_24 := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choice_24 := transform_filtering_0_column_inside_0 and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if transform_left_filter_feature_0_choice_23 then
        transform_left_filter_feature_0_choice_25 := transform_left_filter_feature_0_choice_24;
      else
        transform_left_filter_feature_0_choice_25 := ((transform_left_filter_column_0_0 / 128) = 1) and
          transform_filtering_0_column_inside_0 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_26 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_26 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_27 := transform_left_filter_feature_0_choice_26;
      else
        transform_left_filter_feature_0_choice_27 := ((transform_left_filter_column_0_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_27 then
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_28 then
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_29 then
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_30 then
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_31 then
        transform_left_filter_feature_0_choice_32 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_32 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_32 then
        transform_left_filter_feature_0_choice_33 := transform_filtering_0_column_inside_0 and
          ((transform_left_filter_column_0_2 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_33 := transform_filtering_0_column_inside_0 and
          (((transform_left_filter_column_0_2 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_0_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_34 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_34 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_35 := transform_left_filter_feature_0_choice_34;
      else
        transform_left_filter_feature_0_choice_35 := ((transform_left_filter_column_0_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_35 then
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_36 then
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_37 then
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_38 then
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_39 then
        transform_left_filter_feature_0_choice_40 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_40 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_40 then
        transform_left_filter_feature_0_choice_41 := transform_filtering_0_column_inside_0 and
          ((transform_left_filter_column_0_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_41 := transform_filtering_0_column_inside_0 and
          (((transform_left_filter_column_0_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_2_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_42 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_42 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_43 := transform_left_filter_feature_0_choice_42;
      else
        transform_left_filter_feature_0_choice_43 := ((transform_left_filter_column_2_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_43 then
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_44 then
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_45 then
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_46 then
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_47 then
        transform_left_filter_feature_0_choice_48 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_48 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_48 then
        transform_left_filter_feature_0_choice_49 := transform_filtering_0_column_inside_2 and
          ((transform_left_filter_column_2_3 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_49 := transform_filtering_0_column_inside_2 and
          (((transform_left_filter_column_2_3 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_2_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_50 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_50 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_51 := transform_left_filter_feature_0_choice_50;
      else
        transform_left_filter_feature_0_choice_51 := ((transform_left_filter_column_2_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_51 then
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_52 then
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_53 then
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_54 then
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_55 then
        transform_left_filter_feature_0_choice_56 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_56 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_56 then
        transform_left_filter_feature_0_choice_57 := transform_filtering_0_column_inside_2 and
          ((transform_left_filter_column_2_1 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_57 := transform_filtering_0_column_inside_2 and
          (((transform_left_filter_column_2_1 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_2_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_58 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_58 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_59 := transform_left_filter_feature_0_choice_58;
      else
        transform_left_filter_feature_0_choice_59 := ((transform_left_filter_column_2_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_59 then
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_60 then
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_61 then
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_62 then
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_63 then
        transform_left_filter_feature_0_choice_64 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_64 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_64 then
        transform_left_filter_feature_0_choice_65 := transform_filtering_0_column_inside_2 and
          ((transform_left_filter_column_2_0 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_65 := transform_filtering_0_column_inside_2 and
          (((transform_left_filter_column_2_0 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_2_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_66 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_66 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_67 := transform_left_filter_feature_0_choice_66;
      else
        transform_left_filter_feature_0_choice_67 := ((transform_left_filter_column_2_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_67 then
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_68 then
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_69 then
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_70 then
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_71 then
        transform_left_filter_feature_0_choice_72 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_72 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_72 then
        transform_left_filter_feature_0_choice_73 := transform_filtering_0_column_inside_2 and
          ((transform_left_filter_column_2_2 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_73 := transform_filtering_0_column_inside_2 and
          (((transform_left_filter_column_2_2 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_2_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_74 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_74 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_75 := transform_left_filter_feature_0_choice_74;
      else
        transform_left_filter_feature_0_choice_75 := ((transform_left_filter_column_2_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_75 then
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_76 then
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_77 then
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_78 then
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_79 then
        transform_left_filter_feature_0_choice_80 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_80 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_80 then
        transform_left_filter_feature_0_choice_81 := transform_filtering_0_column_inside_2 and
          ((transform_left_filter_column_2_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_81 := transform_filtering_0_column_inside_2 and
          (((transform_left_filter_column_2_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_4_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_82 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_82 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_83 := transform_left_filter_feature_0_choice_82;
      else
        transform_left_filter_feature_0_choice_83 := ((transform_left_filter_column_4_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_83 then
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_84 then
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_85 then
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_86 then
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_87 then
        transform_left_filter_feature_0_choice_88 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_88 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_88 then
        transform_left_filter_feature_0_choice_89 := transform_filtering_0_column_inside_4 and
          ((transform_left_filter_column_4_3 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_89 := transform_filtering_0_column_inside_4 and
          (((transform_left_filter_column_4_3 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_4_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_90 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_90 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_91 := transform_left_filter_feature_0_choice_90;
      else
        transform_left_filter_feature_0_choice_91 := ((transform_left_filter_column_4_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_91 then
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_92 then
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_93 then
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_94 then
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_95 then
        transform_left_filter_feature_0_choice_96 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_96 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_96 then
        transform_left_filter_feature_0_choice_97 := transform_filtering_0_column_inside_4 and
          ((transform_left_filter_column_4_0 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_97 := transform_filtering_0_column_inside_4 and
          (((transform_left_filter_column_4_0 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_4_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_98 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_98 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_99 := transform_left_filter_feature_0_choice_98;
      else
        transform_left_filter_feature_0_choice_99 := ((transform_left_filter_column_4_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_99 then
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_100 then
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_101 then
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_102 then
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_103 then
        transform_left_filter_feature_0_choice_104 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_104 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_104 then
        transform_left_filter_feature_0_choice_105 := transform_filtering_0_column_inside_4 and
          ((transform_left_filter_column_4_1 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_105 := transform_filtering_0_column_inside_4 and
          (((transform_left_filter_column_4_1 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_4_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_106 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_106 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_107 := transform_left_filter_feature_0_choice_106;
      else
        transform_left_filter_feature_0_choice_107 := ((transform_left_filter_column_4_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_107 then
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_108 then
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_109 then
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_110 then
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_111 then
        transform_left_filter_feature_0_choice_112 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_112 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_112 then
        transform_left_filter_feature_0_choice_113 := transform_filtering_0_column_inside_4 and
          ((transform_left_filter_column_4_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_113 := transform_filtering_0_column_inside_4 and
          (((transform_left_filter_column_4_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_6_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_114 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_114 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_115 := transform_left_filter_feature_0_choice_114;
      else
        transform_left_filter_feature_0_choice_115 := ((transform_left_filter_column_6_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_115 then
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_6_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_6_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_116 then
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_6_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_6_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_117 then
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_6_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_6_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_118 then
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_6_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_6_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_119 then
        transform_left_filter_feature_0_choice_120 := (not (((transform_left_filter_column_6_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_120 := (not (((transform_left_filter_column_6_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_120 then
        transform_left_filter_feature_0_choice_121 := transform_filtering_0_column_inside_6 and
          ((transform_left_filter_column_6_3 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_121 := transform_filtering_0_column_inside_6 and
          (((transform_left_filter_column_6_3 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_6_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_122 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_122 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_123 := transform_left_filter_feature_0_choice_122;
      else
        transform_left_filter_feature_0_choice_123 := ((transform_left_filter_column_6_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_123 then
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_124 then
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_125 then
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_126 then
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_127 then
        transform_left_filter_feature_0_choice_128 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_128 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_128 then
        transform_left_filter_feature_0_choice_129 := transform_filtering_0_column_inside_6 and
          ((transform_left_filter_column_6_1 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_129 := transform_filtering_0_column_inside_6 and
          (((transform_left_filter_column_6_1 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_6_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_130 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_130 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_131 := transform_left_filter_feature_0_choice_130;
      else
        transform_left_filter_feature_0_choice_131 := ((transform_left_filter_column_6_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_131 then
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_132 then
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_133 then
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_134 then
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_135 then
        transform_left_filter_feature_0_choice_136 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_136 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_136 then
        transform_left_filter_feature_0_choice_137 := transform_filtering_0_column_inside_6 and
          ((transform_left_filter_column_6_0 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_137 := transform_filtering_0_column_inside_6 and
          (((transform_left_filter_column_6_0 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_6_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_138 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_138 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_139 := transform_left_filter_feature_0_choice_138;
      else
        transform_left_filter_feature_0_choice_139 := ((transform_left_filter_column_6_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_139 then
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_140 then
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_141 then
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_142 then
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_143 then
        transform_left_filter_feature_0_choice_144 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_144 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_144 then
        transform_left_filter_feature_0_choice_145 := transform_filtering_0_column_inside_6 and
          ((transform_left_filter_column_6_2 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_145 := transform_filtering_0_column_inside_6 and
          (((transform_left_filter_column_6_2 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_6_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_146 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_146 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_147 := transform_left_filter_feature_0_choice_146;
      else
        transform_left_filter_feature_0_choice_147 := ((transform_left_filter_column_6_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_147 then
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_6_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_6_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_148 then
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_6_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_6_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_149 then
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_6_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_6_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_150 then
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_6_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_6_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_151 then
        transform_left_filter_feature_0_choice_152 := (not (((transform_left_filter_column_6_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_152 := (not (((transform_left_filter_column_6_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_152 then
        transform_left_filter_feature_0_choice_153 := transform_filtering_0_column_inside_6 and
          ((transform_left_filter_column_6_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_153 := transform_filtering_0_column_inside_6 and
          (((transform_left_filter_column_6_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_8_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_154 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_154 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_155 := transform_left_filter_feature_0_choice_154;
      else
        transform_left_filter_feature_0_choice_155 := ((transform_left_filter_column_8_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_155 then
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_8_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_8_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_156 then
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_8_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_8_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_157 then
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_8_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_8_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_158 then
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_8_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_8_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_159 then
        transform_left_filter_feature_0_choice_160 := (not (((transform_left_filter_column_8_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_160 := (not (((transform_left_filter_column_8_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_160 then
        transform_left_filter_feature_0_choice_161 := transform_filtering_0_column_inside_8 and
          ((transform_left_filter_column_8_3 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_161 := transform_filtering_0_column_inside_8 and
          (((transform_left_filter_column_8_3 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_8_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_162 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_162 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_163 := transform_left_filter_feature_0_choice_162;
      else
        transform_left_filter_feature_0_choice_163 := ((transform_left_filter_column_8_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_163 then
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_8_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_8_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_164 then
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_8_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_8_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_165 then
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_8_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_8_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_166 then
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_8_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_8_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_167 then
        transform_left_filter_feature_0_choice_168 := (not (((transform_left_filter_column_8_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_168 := (not (((transform_left_filter_column_8_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_168 then
        transform_left_filter_feature_0_choice_169 := transform_filtering_0_column_inside_8 and
          ((transform_left_filter_column_8_1 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_169 := transform_filtering_0_column_inside_8 and
          (((transform_left_filter_column_8_1 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_8_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_170 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_170 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_171 := transform_left_filter_feature_0_choice_170;
      else
        transform_left_filter_feature_0_choice_171 := ((transform_left_filter_column_8_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_171 then
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_172 then
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_173 then
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_174 then
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_175 then
        transform_left_filter_feature_0_choice_176 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_176 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_176 then
        transform_left_filter_feature_0_choice_177 := transform_filtering_0_column_inside_8 and
          ((transform_left_filter_column_8_0 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_177 := transform_filtering_0_column_inside_8 and
          (((transform_left_filter_column_8_0 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_8_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_178 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_178 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_179 := transform_left_filter_feature_0_choice_178;
      else
        transform_left_filter_feature_0_choice_179 := ((transform_left_filter_column_8_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_179 then
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_8_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_8_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_180 then
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_8_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_8_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_181 then
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_8_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_8_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_182 then
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_8_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_8_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_183 then
        transform_left_filter_feature_0_choice_184 := (not (((transform_left_filter_column_8_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_184 := (not (((transform_left_filter_column_8_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_184 then
        transform_left_filter_feature_0_choice_185 := transform_filtering_0_column_inside_8 and
          ((transform_left_filter_column_8_2 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_185 := transform_filtering_0_column_inside_8 and
          (((transform_left_filter_column_8_2 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_8_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_186 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_186 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_187 := transform_left_filter_feature_0_choice_186;
      else
        transform_left_filter_feature_0_choice_187 := ((transform_left_filter_column_8_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_187 then
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_8_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_8_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_188 then
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_8_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_8_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_189 then
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_8_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_8_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_190 then
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_8_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_8_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_191 then
        transform_left_filter_feature_0_choice_192 := (not (((transform_left_filter_column_8_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_192 := (not (((transform_left_filter_column_8_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_192 then
        transform_left_filter_feature_0_choice_193 := transform_filtering_0_column_inside_8 and
          ((transform_left_filter_column_8_4 / 128) = 1) and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_193 := transform_filtering_0_column_inside_8 and
          (((transform_left_filter_column_8_4 / 128) = 1) or (not ((transform_left_filter_column_4_2 / 128) = 1)));
      end if;
      transform_right_filter_feature_0_value := ((transform_right_filter_column_4_2 / 2) mod 2) = 1;
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        ((transform_right_filter_column_4_2 mod 2) = 1));
      if (transform_right_filter_column_0_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_4_2 mod 4) = 0;
      if ((transform_right_filter_column_0_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choice_2 := ((transform_right_filter_column_0_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_2 := ((transform_right_filter_column_4_2 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_2 then
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_3 := ((transform_right_filter_column_4_2 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_3 then
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_4 := ((transform_right_filter_column_4_2 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_4 then
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_5 := ((transform_right_filter_column_4_2 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_5 then
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_6 := ((transform_right_filter_column_4_2 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_6 then
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_7 then
        transform_right_filter_feature_0_choice_8 := transform_filtering_0_column_inside_0 and
          ((transform_right_filter_column_0_1 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_8 := transform_filtering_0_column_inside_0 and
          (((transform_right_filter_column_0_1 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_0_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_9 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_9 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_10 := transform_right_filter_feature_0_choice_9;
      else
        transform_right_filter_feature_0_choice_10 := ((transform_right_filter_column_0_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_10 then
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_11 then
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_12 then
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_13 then
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_14 then
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_15 then
        transform_right_filter_feature_0_choice_16 := transform_filtering_0_column_inside_0 and
          ((transform_right_filter_column_0_3 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_16 := transform_filtering_0_column_inside_0 and
          (((transform_right_filter_column_0_3 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_0_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_17 := (transform_right_filter_column_4_2 mod 4) = 3;
      else
        transform_right_filter_feature_0_choice_17 := transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_18 := transform_right_filter_feature_0_choice_17;
      else
        transform_right_filter_feature_0_choice_18 := (not ((transform_right_filter_column_0_0 mod 2) = 1)) or
          transform_right_filter_feature_0_value or ((transform_right_filter_column_4_2 mod 2) = 1);
      end if;
      transform_right_filter_feature_0_value_7 := ((transform_right_filter_column_0_0 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_18 then
        transform_right_filter_feature_0_choice_19 := transform_right_filter_feature_0_value_7 and (not
          transform_right_filter_feature_0_value_2);
      else
        transform_right_filter_feature_0_choice_19 := transform_right_filter_feature_0_value_7 or (not
          transform_right_filter_feature_0_value_2);
      end if;
      transform_right_filter_feature_0_value_8 := ((transform_right_filter_column_0_0 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_19 then
        transform_right_filter_feature_0_choice_20 := transform_right_filter_feature_0_value_8 or (not
          transform_right_filter_feature_0_value_3);
      else
        transform_right_filter_feature_0_choice_20 := transform_right_filter_feature_0_value_8 and (not
          transform_right_filter_feature_0_value_3);
      end if;
      transform_right_filter_feature_0_value_9 := ((transform_right_filter_column_0_0 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_20 then
        transform_right_filter_feature_0_choice_21 := transform_right_filter_feature_0_value_9 or (not
          transform_right_filter_feature_0_value_4);
      else
        transform_right_filter_feature_0_choice_21 := transform_right_filter_feature_0_value_9 and (not
          transform_right_filter_feature_0_value_4);
      end if;
      transform_right_filter_feature_0_value_10 := ((transform_right_filter_column_0_0 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_21 then
        transform_right_filter_feature_0_choice_22 := transform_right_filter_feature_0_value_10 or (not
          transform_right_filter_feature_0_value_5);
      else
        transform_right_filter_feature_0_choice_22 := transform_right_filter_feature_0_value_10 and (not
          transform_right_filter_feature_0_value_5);
      end if;
      transform_right_filter_feature_0_value_11 := ((transform_right_filter_column_0_0 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_22 then
        transform_right_filter_feature_0_choice_23 := transform_right_filter_feature_0_value_11 or (not
          transform_right_filter_feature_0_value_6);
      else
        transform_right_filter_feature_0_choice_23 := transform_right_filter_feature_0_value_11 and (not
          transform_right_filter_feature_0_value_6);
      end if;
      if (transform_right_filter_column_0_0 / 128) = 1 then
        transform_right_filter_feature_0_choice_24 := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choice_24 := transform_filtering_0_column_inside_0 and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if transform_right_filter_feature_0_choice_23 then
        transform_right_filter_feature_0_choice_25 := transform_right_filter_feature_0_choice_24;
      else
        transform_right_filter_feature_0_choice_25 := ((transform_right_filter_column_0_0 / 128) = 1) and
          transform_filtering_0_column_inside_0 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_26 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_26 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_27 := transform_right_filter_feature_0_choice_26;
      else
        transform_right_filter_feature_0_choice_27 := ((transform_right_filter_column_0_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_27 then
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_28 then
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_29 then
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_30 then
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_31 then
        transform_right_filter_feature_0_choice_32 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_32 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_32 then
        transform_right_filter_feature_0_choice_33 := transform_filtering_0_column_inside_0 and
          ((transform_right_filter_column_0_2 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_33 := transform_filtering_0_column_inside_0 and
          (((transform_right_filter_column_0_2 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_0_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_34 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_34 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_35 := transform_right_filter_feature_0_choice_34;
      else
        transform_right_filter_feature_0_choice_35 := ((transform_right_filter_column_0_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_35 then
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_36 then
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_37 then
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_38 then
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_39 then
        transform_right_filter_feature_0_choice_40 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_40 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_40 then
        transform_right_filter_feature_0_choice_41 := transform_filtering_0_column_inside_0 and
          ((transform_right_filter_column_0_4 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_41 := transform_filtering_0_column_inside_0 and
          (((transform_right_filter_column_0_4 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_2_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_42 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_42 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_43 := transform_right_filter_feature_0_choice_42;
      else
        transform_right_filter_feature_0_choice_43 := ((transform_right_filter_column_2_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_43 then
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_44 then
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_45 then
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_46 then
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_47 then
        transform_right_filter_feature_0_choice_48 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_48 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_48 then
        transform_right_filter_feature_0_choice_49 := transform_filtering_0_column_inside_2 and
          ((transform_right_filter_column_2_3 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_49 := transform_filtering_0_column_inside_2 and
          (((transform_right_filter_column_2_3 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_2_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_50 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_50 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_51 := transform_right_filter_feature_0_choice_50;
      else
        transform_right_filter_feature_0_choice_51 := ((transform_right_filter_column_2_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_51 then
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_52 then
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_53 then
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_54 then
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_55 then
        transform_right_filter_feature_0_choice_56 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_56 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_56 then
        transform_right_filter_feature_0_choice_57 := transform_filtering_0_column_inside_2 and
          ((transform_right_filter_column_2_1 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_57 := transform_filtering_0_column_inside_2 and
          (((transform_right_filter_column_2_1 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_2_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_58 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_58 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_59 := transform_right_filter_feature_0_choice_58;
      else
        transform_right_filter_feature_0_choice_59 := ((transform_right_filter_column_2_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_59 then
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_60 then
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_61 then
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_62 then
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_63 then
        transform_right_filter_feature_0_choice_64 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_64 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_64 then
        transform_right_filter_feature_0_choice_65 := transform_filtering_0_column_inside_2 and
          ((transform_right_filter_column_2_0 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_65 := transform_filtering_0_column_inside_2 and
          (((transform_right_filter_column_2_0 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_2_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_66 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_66 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_67 := transform_right_filter_feature_0_choice_66;
      else
        transform_right_filter_feature_0_choice_67 := ((transform_right_filter_column_2_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_67 then
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_68 then
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_69 then
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_70 then
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_71 then
        transform_right_filter_feature_0_choice_72 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_72 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_72 then
        transform_right_filter_feature_0_choice_73 := transform_filtering_0_column_inside_2 and
          ((transform_right_filter_column_2_2 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_73 := transform_filtering_0_column_inside_2 and
          (((transform_right_filter_column_2_2 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_2_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_74 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_74 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_75 := transform_right_filter_feature_0_choice_74;
      else
        transform_right_filter_feature_0_choice_75 := ((transform_right_filter_column_2_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_75 then
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_76 then
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_77 then
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_78 then
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_79 then
        transform_right_filter_feature_0_choice_80 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_80 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_80 then
        transform_right_filter_feature_0_choice_81 := transform_filtering_0_column_inside_2 and
          ((transform_right_filter_column_2_4 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_81 := transform_filtering_0_column_inside_2 and
          (((transform_right_filter_column_2_4 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_4_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_82 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_82 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_83 := transform_right_filter_feature_0_choice_82;
      else
        transform_right_filter_feature_0_choice_83 := ((transform_right_filter_column_4_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_83 then
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_84 then
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_85 then
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_86 then
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_87 then
        transform_right_filter_feature_0_choice_88 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_88 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_88 then
        transform_right_filter_feature_0_choice_89 := transform_filtering_0_column_inside_4 and
          ((transform_right_filter_column_4_3 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_89 := transform_filtering_0_column_inside_4 and
          (((transform_right_filter_column_4_3 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_4_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_90 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_90 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_91 := transform_right_filter_feature_0_choice_90;
      else
        transform_right_filter_feature_0_choice_91 := ((transform_right_filter_column_4_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_91 then
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_92 then
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_93 then
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_94 then
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_95 then
        transform_right_filter_feature_0_choice_96 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_96 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_96 then
        transform_right_filter_feature_0_choice_97 := transform_filtering_0_column_inside_4 and
          ((transform_right_filter_column_4_0 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_97 := transform_filtering_0_column_inside_4 and
          (((transform_right_filter_column_4_0 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_4_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_98 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_98 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_99 := transform_right_filter_feature_0_choice_98;
      else
        transform_right_filter_feature_0_choice_99 := ((transform_right_filter_column_4_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_99 then
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_100 then
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_101 then
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_102 then
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_103 then
        transform_right_filter_feature_0_choice_104 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_104 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_104 then
        transform_right_filter_feature_0_choice_105 := transform_filtering_0_column_inside_4 and
          ((transform_right_filter_column_4_1 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_105 := transform_filtering_0_column_inside_4 and
          (((transform_right_filter_column_4_1 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_4_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_106 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_106 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_107 := transform_right_filter_feature_0_choice_106;
      else
        transform_right_filter_feature_0_choice_107 := ((transform_right_filter_column_4_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_107 then
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_108 then
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_109 then
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_110 then
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_111 then
        transform_right_filter_feature_0_choice_112 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_112 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_112 then
        transform_right_filter_feature_0_choice_113 := transform_filtering_0_column_inside_4 and
          ((transform_right_filter_column_4_4 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_113 := transform_filtering_0_column_inside_4 and
          (((transform_right_filter_column_4_4 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_6_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_114 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_114 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_115 := transform_right_filter_feature_0_choice_114;
      else
        transform_right_filter_feature_0_choice_115 := ((transform_right_filter_column_6_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_115 then
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_6_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_6_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_116 then
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_6_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_6_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_117 then
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_6_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_6_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_118 then
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_6_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_6_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_119 then
        transform_right_filter_feature_0_choice_120 := (not (((transform_right_filter_column_6_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_120 := (not (((transform_right_filter_column_6_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_120 then
        transform_right_filter_feature_0_choice_121 := transform_filtering_0_column_inside_6 and
          ((transform_right_filter_column_6_3 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_121 := transform_filtering_0_column_inside_6 and
          (((transform_right_filter_column_6_3 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_6_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_122 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_122 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_123 := transform_right_filter_feature_0_choice_122;
      else
        transform_right_filter_feature_0_choice_123 := ((transform_right_filter_column_6_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_123 then
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_124 then
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_125 then
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_126 then
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_127 then
        transform_right_filter_feature_0_choice_128 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_128 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_128 then
        transform_right_filter_feature_0_choice_129 := transform_filtering_0_column_inside_6 and
          ((transform_right_filter_column_6_1 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_129 := transform_filtering_0_column_inside_6 and
          (((transform_right_filter_column_6_1 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_6_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_130 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_130 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_131 := transform_right_filter_feature_0_choice_130;
      else
        transform_right_filter_feature_0_choice_131 := ((transform_right_filter_column_6_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_131 then
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_132 then
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_133 then
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_134 then
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_135 then
        transform_right_filter_feature_0_choice_136 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_136 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_136 then
        transform_right_filter_feature_0_choice_137 := transform_filtering_0_column_inside_6 and
          ((transform_right_filter_column_6_0 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_137 := transform_filtering_0_column_inside_6 and
          (((transform_right_filter_column_6_0 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_6_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_138 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_138 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_139 := transform_right_filter_feature_0_choice_138;
      else
        transform_right_filter_feature_0_choice_139 := ((transform_right_filter_column_6_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_139 then
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_140 then
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_141 then
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_142 then
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_143 then
        transform_right_filter_feature_0_choice_144 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_144 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_144 then
        transform_right_filter_feature_0_choice_145 := transform_filtering_0_column_inside_6 and
          ((transform_right_filter_column_6_2 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_145 := transform_filtering_0_column_inside_6 and
          (((transform_right_filter_column_6_2 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_6_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_146 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_146 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_147 := transform_right_filter_feature_0_choice_146;
      else
        transform_right_filter_feature_0_choice_147 := ((transform_right_filter_column_6_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_147 then
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_6_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_6_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_148 then
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_6_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_6_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_149 then
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_6_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_6_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_150 then
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_6_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_6_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_151 then
        transform_right_filter_feature_0_choice_152 := (not (((transform_right_filter_column_6_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_152 := (not (((transform_right_filter_column_6_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_152 then
        transform_right_filter_feature_0_choice_153 := transform_filtering_0_column_inside_6 and
          ((transform_right_filter_column_6_4 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_153 := transform_filtering_0_column_inside_6 and
          (((transform_right_filter_column_6_4 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_8_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_154 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_154 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_155 := transform_right_filter_feature_0_choice_154;
      else
        transform_right_filter_feature_0_choice_155 := ((transform_right_filter_column_8_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_155 then
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_8_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_8_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_156 then
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_8_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_8_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_157 then
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_8_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_8_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_158 then
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_8_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_8_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_159 then
        transform_right_filter_feature_0_choice_160 := (not (((transform_right_filter_column_8_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_160 := (not (((transform_right_filter_column_8_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_160 then
        transform_right_filter_feature_0_choice_161 := transform_filtering_0_column_inside_8 and
          ((transform_right_filter_column_8_3 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_161 := transform_filtering_0_column_inside_8 and
          (((transform_right_filter_column_8_3 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_8_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_162 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_162 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_163 := transform_right_filter_feature_0_choice_162;
      else
        transform_right_filter_feature_0_choice_163 := ((transform_right_filter_column_8_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_163 then
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_8_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_8_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_164 then
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_8_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_8_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_165 then
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_8_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_8_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_166 then
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_8_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_8_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_167 then
        transform_right_filter_feature_0_choice_168 := (not (((transform_right_filter_column_8_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_168 := (not (((transform_right_filter_column_8_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_168 then
        transform_right_filter_feature_0_choice_169 := transform_filtering_0_column_inside_8 and
          ((transform_right_filter_column_8_1 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_169 := transform_filtering_0_column_inside_8 and
          (((transform_right_filter_column_8_1 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_8_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_170 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_170 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_171 := transform_right_filter_feature_0_choice_170;
      else
        transform_right_filter_feature_0_choice_171 := ((transform_right_filter_column_8_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_171 then
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_172 then
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_173 then
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_174 then
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_175 then
        transform_right_filter_feature_0_choice_176 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_176 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_176 then
        transform_right_filter_feature_0_choice_177 := transform_filtering_0_column_inside_8 and
          ((transform_right_filter_column_8_0 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_177 := transform_filtering_0_column_inside_8 and
          (((transform_right_filter_column_8_0 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_8_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_178 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_178 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_179 := transform_right_filter_feature_0_choice_178;
      else
        transform_right_filter_feature_0_choice_179 := ((transform_right_filter_column_8_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_179 then
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_8_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_8_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_180 then
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_8_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_8_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_181 then
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_8_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_8_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_182 then
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_8_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_8_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_183 then
        transform_right_filter_feature_0_choice_184 := (not (((transform_right_filter_column_8_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_184 := (not (((transform_right_filter_column_8_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_184 then
        transform_right_filter_feature_0_choice_185 := transform_filtering_0_column_inside_8 and
          ((transform_right_filter_column_8_2 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_185 := transform_filtering_0_column_inside_8 and
          (((transform_right_filter_column_8_2 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_8_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_186 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_186 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_187 := transform_right_filter_feature_0_choice_186;
      else
        transform_right_filter_feature_0_choice_187 := ((transform_right_filter_column_8_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_187 then
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_8_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_8_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_188 then
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_8_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_8_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_189 then
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_8_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_8_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_190 then
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_8_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_8_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_191 then
        transform_right_filter_feature_0_choice_192 := (not (((transform_right_filter_column_8_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_192 := (not (((transform_right_filter_column_8_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_192 then
        transform_right_filter_feature_0_choice_193 := transform_filtering_0_column_inside_8 and
          ((transform_right_filter_column_8_4 / 128) = 1) and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_193 := transform_filtering_0_column_inside_8 and
          (((transform_right_filter_column_8_4 / 128) = 1) or (not ((transform_right_filter_column_4_2 / 128) = 1)));
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
        (transform_counter_group mod 4)) < 375;
      transform_read_row_inside_1 <= (transform_counter_group >= 3) and (transform_counter_group < 378);
      transform_read_row_inside_2 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 375;
      transform_read_row_inside_3 <= (transform_counter_group >= 1) and (transform_counter_group < 376);
      transform_read_row_inside_4 <= transform_counter_group < 375;
      transform_read_column_inside_0 <= transform_read_column_inside_0_is_less;
      transform_read_column_inside_2 <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_4 <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_6 <= (transform_counter_column < 6) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_8 <= (transform_counter_column < 8) /= transform_read_column_inside_0_is_less;
      transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_1 <= transform_read_row_inside_1;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
      transform_ready_row_inside_3 <= transform_read_row_inside_3;
      transform_ready_row_inside_4 <= transform_read_row_inside_4;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_column_inside_4 <= transform_read_column_inside_4;
      transform_ready_column_inside_6 <= transform_read_column_inside_6;
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
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_column_inside_4 <= transform_ready_column_inside_4;
      transform_columns_column_inside_6 <= transform_ready_column_inside_6;
      transform_columns_column_inside_8 <= transform_ready_column_inside_8;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_feature_0 <= (as_number(transform_left_filter_feature_0_choice_8) * 2) +
        (as_number(transform_left_filter_feature_0_choice_16) * 8) +
        as_number(transform_left_filter_feature_0_choice_25) + (as_number(transform_left_filter_feature_0_choice_33) *
        4) + (as_number(transform_left_filter_feature_0_choice_41) * 16) +
        (as_number(transform_left_filter_feature_0_choice_49) * 256) +
        (as_number(transform_left_filter_feature_0_choice_57) * 64) +
        (as_number(transform_left_filter_feature_0_choice_65) * 32) +
        (as_number(transform_left_filter_feature_0_choice_73) * 128) +
        (as_number(transform_left_filter_feature_0_choice_81) * 512) +
        (as_number(transform_left_filter_feature_0_choice_89) * 4096) +
        (as_number(transform_left_filter_feature_0_choice_97) * 1024) +
        (as_number(transform_left_filter_feature_0_choice_105) * 2048) +
        (as_number(transform_left_filter_feature_0_choice_113) * 8192) +
        (as_number(transform_left_filter_feature_0_choice_121) * 131072) +
        (as_number(transform_left_filter_feature_0_choice_129) * 32768) +
        (as_number(transform_left_filter_feature_0_choice_137) * 16384) +
        (as_number(transform_left_filter_feature_0_choice_145) * 65536) +
        (as_number(transform_left_filter_feature_0_choice_153) * 262144) +
        (as_number(transform_left_filter_feature_0_choice_161) * 4194304) +
        (as_number(transform_left_filter_feature_0_choice_169) * 1048576) +
        (as_number(transform_left_filter_feature_0_choice_177) * 524288) +
        (as_number(transform_left_filter_feature_0_choice_185) * 2097152) +
        (as_number(transform_left_filter_feature_0_choice_193) * 8388608);
      transform_right_filter_feature_0 <= (as_number(transform_right_filter_feature_0_choice_8) * 2) +
        (as_number(transform_right_filter_feature_0_choice_16) * 8) +
        as_number(transform_right_filter_feature_0_choice_25) + (as_number(transform_right_filter_feature_0_choice_33)
        * 4) + (as_number(transform_right_filter_feature_0_choice_41) * 16) +
        (as_number(transform_right_filter_feature_0_choice_49) * 256) +
        (as_number(transform_right_filter_feature_0_choice_57) * 64) +
        (as_number(transform_right_filter_feature_0_choice_65) * 32) +
        (as_number(transform_right_filter_feature_0_choice_73) * 128) +
        (as_number(transform_right_filter_feature_0_choice_81) * 512) +
        (as_number(transform_right_filter_feature_0_choice_89) * 4096) +
        (as_number(transform_right_filter_feature_0_choice_97) * 1024) +
        (as_number(transform_right_filter_feature_0_choice_105) * 2048) +
        (as_number(transform_right_filter_feature_0_choice_113) * 8192) +
        (as_number(transform_right_filter_feature_0_choice_121) * 131072) +
        (as_number(transform_right_filter_feature_0_choice_129) * 32768) +
        (as_number(transform_right_filter_feature_0_choice_137) * 16384) +
        (as_number(transform_right_filter_feature_0_choice_145) * 65536) +
        (as_number(transform_right_filter_feature_0_choice_153) * 262144) +
        (as_number(transform_right_filter_feature_0_choice_161) * 4194304) +
        (as_number(transform_right_filter_feature_0_choice_169) * 1048576) +
        (as_number(transform_right_filter_feature_0_choice_177) * 524288) +
        (as_number(transform_right_filter_feature_0_choice_185) * 2097152) +
        (as_number(transform_right_filter_feature_0_choice_193) * 8388608);
      transform_filtering_0_row_inside_4 <= refinement_passed_8_0;
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_8 <= transform_columns_column_inside_8;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_row_inside_4 <= transform_filtering_0_row_inside_4;
      transform_filtering_1_column_inside_4 <= refinement_passed_3_0;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice;
      else
        transform_counter_group <= transform_counter_group_choice_3;
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := (transform_counter_group /= 376) and transform_counter_next_frame;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_differs then
        transform_counter_next_frame_choice_2 := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if in_valid then
        if in_start_of_frame or transform_counter_group_is_equal_2 then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 512;
        end if;
        if transform_counter_next_frame_choice_2 then
          transform_counter_next_frame <= (not in_start_of_frame) or transform_counter_group_all;
        else
          transform_counter_next_frame <= in_start_of_frame and transform_counter_group_is_equal and
            transform_counter_group_is_equal_2;
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
      raster_place_group_is_equal := raster_place_column = 449;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_1_valid;
      if transform_filtering_1_valid and transform_filtering_1_start_of_frame then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 379) and
          transform_filtering_1_valid and raster_place_group_is_equal))) mod 512;
      end if;
      if transform_filtering_1_valid then
        if raster_place_group_is_equal or transform_filtering_1_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
      end if;
      -- delay
      delay_tag_first_column_is_equal := raster_place_column = 4;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (raster_place_group >= 9) and (raster_place_group < 384);
      delay_row_inside_1 <= raster_place_group < 375;
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_leaves_window <= (raster_place_column >= 9) and (raster_place_column < 450);
      delay_tag_map_column <= (((((raster_place_column / 4) + 16383) mod 16384) * 4) + (raster_place_column mod 4)) <
        442;
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 4);
      delay_tag_end_of_line <= raster_place_column = 445;
      -- rows
      rows_search_rows_read_newest_0 <= delay_delayed_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_words_2 <= to_integer(rows_search_rows_read_words_2);
      rows_search_rows_ready_words_3 <= to_integer(rows_search_rows_read_words_3);
      rows_search_rows_ready_words_4 <= to_integer(rows_search_rows_read_words_4);
      rows_search_rows_ready_words_5 <= to_integer(rows_search_rows_read_words_5);
      rows_search_rows_ready_words_6 <= to_integer(rows_search_rows_read_words_6);
      rows_search_rows_ready_words_7 <= to_integer(rows_search_rows_read_words_7);
      rows_search_rows_ready_words_8 <= to_integer(rows_search_rows_read_words_8);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_words_2 <= to_integer(rows_reference_rows_read_words_2);
      rows_reference_rows_ready_words_3 <= to_integer(rows_reference_rows_read_words_3);
      rows_reference_rows_ready_words_4 <= to_integer(rows_reference_rows_read_words_4);
      rows_reference_rows_ready_words_5 <= to_integer(rows_reference_rows_read_words_5);
      rows_reference_rows_ready_words_6 <= to_integer(rows_reference_rows_read_words_6);
      rows_reference_rows_ready_words_7 <= to_integer(rows_reference_rows_read_words_7);
      rows_reference_rows_ready_words_8 <= to_integer(rows_reference_rows_read_words_8);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_row_start <= delay_tag_row_start;
      rows_read_tag_first_group <= delay_tag_first_group;
      rows_read_tag_leaves_window <= delay_tag_leaves_window;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_row_start <= rows_read_tag_row_start;
      rows_ready_tag_first_group <= rows_read_tag_first_group;
      rows_ready_tag_leaves_window <= rows_read_tag_leaves_window;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_row_start <= rows_ready_tag_row_start;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_leaves_window <= rows_ready_tag_leaves_window;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
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
        rows_search_1 <= rows_search_rows_ready_newest_0;
        rows_reference_1 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_1 <= 0;
        rows_reference_1 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= rows_search_rows_ready_words_1;
        rows_search_rows_write_words_1 <= rows_search_rows_ready_words_2;
        rows_search_rows_write_words_2 <= rows_search_rows_ready_words_3;
        rows_search_rows_write_words_3 <= rows_search_rows_ready_words_4;
        rows_search_rows_write_words_4 <= rows_search_rows_ready_words_5;
        rows_search_rows_write_words_5 <= rows_search_rows_ready_words_6;
        rows_search_rows_write_words_6 <= rows_search_rows_ready_words_7;
        rows_search_rows_write_words_7 <= rows_search_rows_ready_words_8;
        rows_search_rows_write_words_8 <= rows_search_rows_ready_newest_0;
        rows_reference_rows_write_words_0 <= rows_reference_rows_ready_words_1;
        rows_reference_rows_write_words_1 <= rows_reference_rows_ready_words_2;
        rows_reference_rows_write_words_2 <= rows_reference_rows_ready_words_3;
        rows_reference_rows_write_words_3 <= rows_reference_rows_ready_words_4;
        rows_reference_rows_write_words_4 <= rows_reference_rows_ready_words_5;
        rows_reference_rows_write_words_5 <= rows_reference_rows_ready_words_6;
        rows_reference_rows_write_words_6 <= rows_reference_rows_ready_words_7;
        rows_reference_rows_write_words_7 <= rows_reference_rows_ready_words_8;
        rows_reference_rows_write_words_8 <= rows_reference_rows_ready_newest_0;
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= rows_search_0;
        slice0shift_search_0_1 <= slice0shift_search_0_0;
        slice0shift_search_0_2 <= slice0shift_search_0_1;
        slice0shift_search_0_3 <= slice0shift_search_0_2;
        slice0shift_search_0_4 <= slice0shift_search_0_3;
        slice0shift_search_0_5 <= slice0shift_search_0_4;
        slice0shift_search_0_6 <= slice0shift_search_0_5;
        slice0shift_search_0_7 <= slice0shift_search_0_6;
        slice0shift_search_0_8 <= slice0shift_search_0_7;
        slice0shift_search_0_9 <= slice0shift_search_0_8;
        slice0shift_search_0_10 <= slice0shift_search_0_9;
        slice0shift_search_0_11 <= slice0shift_search_0_10;
        slice0shift_search_0_12 <= slice0shift_search_0_11;
        slice0shift_search_0_13 <= slice0shift_search_0_12;
        slice0shift_search_0_14 <= slice0shift_search_0_13;
        slice0shift_search_0_15 <= slice0shift_search_0_14;
        slice0shift_search_1_0 <= rows_search_1;
        slice0shift_search_1_1 <= slice0shift_search_1_0;
        slice0shift_search_1_2 <= slice0shift_search_1_1;
        slice0shift_search_1_3 <= slice0shift_search_1_2;
        slice0shift_search_1_4 <= slice0shift_search_1_3;
        slice0shift_search_1_5 <= slice0shift_search_1_4;
        slice0shift_search_1_6 <= slice0shift_search_1_5;
        slice0shift_search_1_7 <= slice0shift_search_1_6;
        slice0shift_search_1_8 <= slice0shift_search_1_7;
        slice0shift_search_1_9 <= slice0shift_search_1_8;
        slice0shift_search_1_10 <= slice0shift_search_1_9;
        slice0shift_search_1_11 <= slice0shift_search_1_10;
        slice0shift_search_1_12 <= slice0shift_search_1_11;
        slice0shift_search_1_13 <= slice0shift_search_1_12;
        slice0shift_search_1_14 <= slice0shift_search_1_13;
        slice0shift_search_1_15 <= slice0shift_search_1_14;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_search_out_0 <= slice0shift_search_0_15;
      slice0shift_search_out_1 <= slice0shift_search_1_15;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_row_start <= rows_tag_row_start;
      slice0shift_tag_first_group <= rows_tag_first_group;
      slice0shift_tag_leaves_window <= rows_tag_leaves_window;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_first_column <= rows_tag_first_column;
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
      slice0cost_pixels_first_0_0_count_6_value_2 := ((slice0shift_reference_0 / 1048576) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_6_value_3 := ((slice0shift_reference_0 / 524288) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_7_value := ((slice0shift_reference_0 / 2097152) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_7_value_2 := ((slice0shift_reference_0 / 4194304) mod 2) = 1;
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
      slice0cost_pixels_first_1_0_count_6_value_2 := ((slice0shift_reference_1 / 1048576) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_6_value_3 := ((slice0shift_reference_1 / 524288) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_7_value := ((slice0shift_reference_1 / 2097152) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_7_value_2 := ((slice0shift_reference_1 / 4194304) mod 2) = 1;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_0_choice := 0;
      else
        slice0cost_column_0_0_choice := to_integer(slice0cost_ready_words_0(7 downto 0));
      end if;
      slice0cost_column_0_0_value := (slice0cost_change_0_0 + slice0cost_column_0_0_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_1_choice := 0;
      else
        slice0cost_column_0_1_choice := to_integer(slice0cost_ready_words_0(15 downto 8));
      end if;
      slice0cost_column_0_1_value := (slice0cost_change_0_1 + slice0cost_column_0_1_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_2_choice := 0;
      else
        slice0cost_column_0_2_choice := to_integer(slice0cost_ready_words_0(23 downto 16));
      end if;
      slice0cost_column_0_2_value := (slice0cost_change_0_2 + slice0cost_column_0_2_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_3_choice := 0;
      else
        slice0cost_column_0_3_choice := to_integer(slice0cost_ready_words_0(31 downto 24));
      end if;
      slice0cost_column_0_3_value := (slice0cost_change_0_3 + slice0cost_column_0_3_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_4_choice := 0;
      else
        slice0cost_column_0_4_choice := to_integer(slice0cost_ready_words_1(7 downto 0));
      end if;
      slice0cost_column_0_4_value := (slice0cost_change_0_4 + slice0cost_column_0_4_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_5_choice := 0;
      else
        slice0cost_column_0_5_choice := to_integer(slice0cost_ready_words_1(15 downto 8));
      end if;
      slice0cost_column_0_5_value := (slice0cost_change_0_5 + slice0cost_column_0_5_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_6_choice := 0;
      else
        slice0cost_column_0_6_choice := to_integer(slice0cost_ready_words_1(23 downto 16));
      end if;
      slice0cost_column_0_6_value := (slice0cost_change_0_6 + slice0cost_column_0_6_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_7_choice := 0;
      else
        slice0cost_column_0_7_choice := to_integer(slice0cost_ready_words_1(31 downto 24));
      end if;
      slice0cost_column_0_7_value := (slice0cost_change_0_7 + slice0cost_column_0_7_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_8_choice := 0;
      else
        slice0cost_column_0_8_choice := to_integer(slice0cost_ready_words_2(7 downto 0));
      end if;
      slice0cost_column_0_8_value := (slice0cost_change_0_8 + slice0cost_column_0_8_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_9_choice := 0;
      else
        slice0cost_column_0_9_choice := to_integer(slice0cost_ready_words_2(15 downto 8));
      end if;
      slice0cost_column_0_9_value := (slice0cost_change_0_9 + slice0cost_column_0_9_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_10_choice := 0;
      else
        slice0cost_column_0_10_choice := to_integer(slice0cost_ready_words_2(23 downto 16));
      end if;
      slice0cost_column_0_10_value := (slice0cost_change_0_10 + slice0cost_column_0_10_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_11_choice := 0;
      else
        slice0cost_column_0_11_choice := to_integer(slice0cost_ready_words_2(31 downto 24));
      end if;
      slice0cost_column_0_11_value := (slice0cost_change_0_11 + slice0cost_column_0_11_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_12_choice := 0;
      else
        slice0cost_column_0_12_choice := to_integer(slice0cost_ready_words_3(7 downto 0));
      end if;
      slice0cost_column_0_12_value := (slice0cost_change_0_12 + slice0cost_column_0_12_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_13_choice := 0;
      else
        slice0cost_column_0_13_choice := to_integer(slice0cost_ready_words_3(15 downto 8));
      end if;
      slice0cost_column_0_13_value := (slice0cost_change_0_13 + slice0cost_column_0_13_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_14_choice := 0;
      else
        slice0cost_column_0_14_choice := to_integer(slice0cost_ready_words_3(23 downto 16));
      end if;
      slice0cost_column_0_14_value := (slice0cost_change_0_14 + slice0cost_column_0_14_choice) mod 256;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_15_choice := 0;
      else
        slice0cost_column_0_15_choice := to_integer(slice0cost_ready_words_3(31 downto 24));
      end if;
      slice0cost_column_0_15_value := (slice0cost_change_0_15 + slice0cost_column_0_15_choice) mod 256;
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
      slice0cost_pixels_first_0_0_count_6 <= as_number((slice0cost_pixels_first_0_0_count_6_value /=
        (((slice0shift_search_0_0 / 262144) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_6_value_2 /=
        (((slice0shift_search_0_0 / 1048576) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_6_value_3 /=
        (((slice0shift_search_0_0 / 524288) mod 2) = 1)));
      slice0cost_pixels_first_0_0_count_7 <= as_number((slice0cost_pixels_first_0_0_count_7_value /=
        (((slice0shift_search_0_0 / 2097152) mod 2) = 1))) + as_number((((slice0shift_reference_0 / 8388608) = 1) /=
        ((slice0shift_search_0_0 / 8388608) = 1))) + as_number((slice0cost_pixels_first_0_0_count_7_value_2 /=
        (((slice0shift_search_0_0 / 4194304) mod 2) = 1)));
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
      slice0cost_pixels_first_0_1_count_6 <= as_number(((((slice0shift_search_0_1 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_1 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_1 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_1_count_7 <= as_number(((((slice0shift_search_0_1 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_1 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_1 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
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
      slice0cost_pixels_first_0_2_count_6 <= as_number(((((slice0shift_search_0_2 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_2 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_2 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_2_count_7 <= as_number(((((slice0shift_search_0_2 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_2 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_2 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
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
      slice0cost_pixels_first_0_3_count_4 <= as_number(((((slice0shift_search_0_3 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_3 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_3 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_3_count_5 <= as_number(((((slice0shift_search_0_3 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_3 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_3 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_3_count_6 <= as_number(((((slice0shift_search_0_3 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_3 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_3 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_3_count_7 <= as_number(((((slice0shift_search_0_3 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_3 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_3 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
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
      slice0cost_pixels_first_0_4_count_4 <= as_number(((((slice0shift_search_0_4 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_4 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_4 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_4_count_5 <= as_number(((((slice0shift_search_0_4 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_4 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_4 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_4_count_6 <= as_number(((((slice0shift_search_0_4 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_4 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_4 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_4_count_7 <= as_number(((((slice0shift_search_0_4 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_4 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_4 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_5_count_0 <= as_number((((slice0shift_search_0_5 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_5 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_5 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_5_count_1 <= as_number(((((slice0shift_search_0_5 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_5 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_5 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_5_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_5 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_5 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_5 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_5_count_3 <= as_number(((((slice0shift_search_0_5 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_5 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_5 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_5_count_4 <= as_number(((((slice0shift_search_0_5 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_5 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_5 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_5_count_5 <= as_number(((((slice0shift_search_0_5 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_5 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_5 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_5_count_6 <= as_number(((((slice0shift_search_0_5 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_5 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_5 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_5_count_7 <= as_number(((((slice0shift_search_0_5 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_5 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_5 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_6_count_0 <= as_number((((slice0shift_search_0_6 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_6 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_6 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_6_count_1 <= as_number(((((slice0shift_search_0_6 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_6 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_6 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_6_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_6 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_6 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_6 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_6_count_3 <= as_number(((((slice0shift_search_0_6 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_6 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_6 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_6_count_4 <= as_number(((((slice0shift_search_0_6 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_6 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_6 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_6_count_5 <= as_number(((((slice0shift_search_0_6 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_6 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_6 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_6_count_6 <= as_number(((((slice0shift_search_0_6 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_6 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_6 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_6_count_7 <= as_number(((((slice0shift_search_0_6 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_6 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_6 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_7_count_0 <= as_number((((slice0shift_search_0_7 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_7 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_7 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_7_count_1 <= as_number(((((slice0shift_search_0_7 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_7 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_7 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_7_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_7 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_7 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_7 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_7_count_3 <= as_number(((((slice0shift_search_0_7 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_7 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_7 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_7_count_4 <= as_number(((((slice0shift_search_0_7 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_7 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_7 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_7_count_5 <= as_number(((((slice0shift_search_0_7 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_7 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_7 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_7_count_6 <= as_number(((((slice0shift_search_0_7 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_7 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_7 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_7_count_7 <= as_number(((((slice0shift_search_0_7 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_7 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_7 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_8_count_0 <= as_number((((slice0shift_search_0_8 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_8 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_8 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_8_count_1 <= as_number(((((slice0shift_search_0_8 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_8 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_8 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_8_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_8 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_8 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_8 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_8_count_3 <= as_number(((((slice0shift_search_0_8 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_8 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_8 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_8_count_4 <= as_number(((((slice0shift_search_0_8 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_8 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_8 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_8_count_5 <= as_number(((((slice0shift_search_0_8 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_8 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_8 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_8_count_6 <= as_number(((((slice0shift_search_0_8 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_8 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_8 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_8_count_7 <= as_number(((((slice0shift_search_0_8 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_8 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_8 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_9_count_0 <= as_number((((slice0shift_search_0_9 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_9 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_9 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_9_count_1 <= as_number(((((slice0shift_search_0_9 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_9 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_9 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_9_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_9 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_9 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_9 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_9_count_3 <= as_number(((((slice0shift_search_0_9 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_9 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_9 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_9_count_4 <= as_number(((((slice0shift_search_0_9 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_9 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_9 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_9_count_5 <= as_number(((((slice0shift_search_0_9 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_9 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_9 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_9_count_6 <= as_number(((((slice0shift_search_0_9 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_9 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_9 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_9_count_7 <= as_number(((((slice0shift_search_0_9 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_9 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_9 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_10_count_0 <= as_number((((slice0shift_search_0_10 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_10 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_10 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_10_count_1 <= as_number(((((slice0shift_search_0_10 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_10 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_10 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_10_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_10 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_10 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_10 / 64) mod 2) =
        1) /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_10_count_3 <= as_number(((((slice0shift_search_0_10 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_10 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_10 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_10_count_4 <= as_number(((((slice0shift_search_0_10 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_10 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_10 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_10_count_5 <= as_number(((((slice0shift_search_0_10 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_10 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_10 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_10_count_6 <= as_number(((((slice0shift_search_0_10 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_10 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_10 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_10_count_7 <= as_number(((((slice0shift_search_0_10 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_10 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_10 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_11_count_0 <= as_number((((slice0shift_search_0_11 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_11 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_11 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_11_count_1 <= as_number(((((slice0shift_search_0_11 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_11 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_11 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_11_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_11 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_11 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_11 / 64) mod 2) =
        1) /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_11_count_3 <= as_number(((((slice0shift_search_0_11 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_11 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_11 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_11_count_4 <= as_number(((((slice0shift_search_0_11 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_11 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_11 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_11_count_5 <= as_number(((((slice0shift_search_0_11 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_11 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_11 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_11_count_6 <= as_number(((((slice0shift_search_0_11 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_11 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_11 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_11_count_7 <= as_number(((((slice0shift_search_0_11 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_11 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_11 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_12_count_0 <= as_number((((slice0shift_search_0_12 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_12 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_12 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_12_count_1 <= as_number(((((slice0shift_search_0_12 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_12 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_12 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_12_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_12 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_12 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_12 / 64) mod 2) =
        1) /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_12_count_3 <= as_number(((((slice0shift_search_0_12 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_12 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_12 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_12_count_4 <= as_number(((((slice0shift_search_0_12 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_12 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_12 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_12_count_5 <= as_number(((((slice0shift_search_0_12 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_12 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_12 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_12_count_6 <= as_number(((((slice0shift_search_0_12 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_12 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_12 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_12_count_7 <= as_number(((((slice0shift_search_0_12 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_12 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_12 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_13_count_0 <= as_number((((slice0shift_search_0_13 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_13 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_13 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_13_count_1 <= as_number(((((slice0shift_search_0_13 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_13 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_13 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_13_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_13 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_13 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_13 / 64) mod 2) =
        1) /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_13_count_3 <= as_number(((((slice0shift_search_0_13 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_13 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_13 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_13_count_4 <= as_number(((((slice0shift_search_0_13 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_13 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_13 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_13_count_5 <= as_number(((((slice0shift_search_0_13 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_13 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_13 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_13_count_6 <= as_number(((((slice0shift_search_0_13 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_13 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_13 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_13_count_7 <= as_number(((((slice0shift_search_0_13 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_13 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_13 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_14_count_0 <= as_number((((slice0shift_search_0_14 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_14 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_14 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_14_count_1 <= as_number(((((slice0shift_search_0_14 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_14 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_14 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_14_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_14 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_14 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_14 / 64) mod 2) =
        1) /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_14_count_3 <= as_number(((((slice0shift_search_0_14 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_14 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_14 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_14_count_4 <= as_number(((((slice0shift_search_0_14 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_14 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_14 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_14_count_5 <= as_number(((((slice0shift_search_0_14 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_14 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_14 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_14_count_6 <= as_number(((((slice0shift_search_0_14 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_14 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_14 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_14_count_7 <= as_number(((((slice0shift_search_0_14 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_14 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_14 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
      slice0cost_pixels_first_0_15_count_0 <= as_number((((slice0shift_search_0_15 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_15 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value)) + as_number(((((slice0shift_search_0_15 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_0_value_2));
      slice0cost_pixels_first_0_15_count_1 <= as_number(((((slice0shift_search_0_15 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value)) + as_number(((((slice0shift_search_0_15 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice0shift_search_0_15 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_1_value_3));
      slice0cost_pixels_first_0_15_count_2 <= (to_integer(((to_unsigned((slice0shift_search_0_15 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_0_15 / 256) mod
        2) = 1) /= slice0cost_pixels_first_0_0_count_2_value)) + as_number(((((slice0shift_search_0_15 / 64) mod 2) =
        1) /= slice0cost_pixels_first_0_0_count_2_value_2));
      slice0cost_pixels_first_0_15_count_3 <= as_number(((((slice0shift_search_0_15 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value)) + as_number(((((slice0shift_search_0_15 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice0shift_search_0_15 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_3_value_3));
      slice0cost_pixels_first_0_15_count_4 <= as_number(((((slice0shift_search_0_15 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value)) + as_number(((((slice0shift_search_0_15 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice0shift_search_0_15 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_4_value_3));
      slice0cost_pixels_first_0_15_count_5 <= as_number(((((slice0shift_search_0_15 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value)) + as_number(((((slice0shift_search_0_15 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice0shift_search_0_15 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_5_value_3));
      slice0cost_pixels_first_0_15_count_6 <= as_number(((((slice0shift_search_0_15 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value)) + as_number(((((slice0shift_search_0_15 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice0shift_search_0_15 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_6_value_3));
      slice0cost_pixels_first_0_15_count_7 <= as_number(((((slice0shift_search_0_15 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value)) + as_number((((slice0shift_search_0_15 / 8388608) = 1) /=
        ((slice0shift_reference_0 / 8388608) = 1))) + as_number(((((slice0shift_search_0_15 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2));
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
      slice0cost_pixels_first_1_0_count_6 <= as_number((slice0cost_pixels_first_1_0_count_6_value /=
        (((slice0shift_search_1_0 / 262144) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_6_value_2 /=
        (((slice0shift_search_1_0 / 1048576) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_6_value_3 /=
        (((slice0shift_search_1_0 / 524288) mod 2) = 1)));
      slice0cost_pixels_first_1_0_count_7 <= as_number((slice0cost_pixels_first_1_0_count_7_value /=
        (((slice0shift_search_1_0 / 2097152) mod 2) = 1))) + as_number((((slice0shift_reference_1 / 8388608) = 1) /=
        ((slice0shift_search_1_0 / 8388608) = 1))) + as_number((slice0cost_pixels_first_1_0_count_7_value_2 /=
        (((slice0shift_search_1_0 / 4194304) mod 2) = 1)));
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
      slice0cost_pixels_first_1_1_count_6 <= as_number(((((slice0shift_search_1_1 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_1 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_1 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_1_count_7 <= as_number(((((slice0shift_search_1_1 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_1 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_1 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
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
      slice0cost_pixels_first_1_2_count_6 <= as_number(((((slice0shift_search_1_2 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_2 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_2 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_2_count_7 <= as_number(((((slice0shift_search_1_2 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_2 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_2 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
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
      slice0cost_pixels_first_1_3_count_4 <= as_number(((((slice0shift_search_1_3 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_3 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_3 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_3_count_5 <= as_number(((((slice0shift_search_1_3 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_3 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_3 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_3_count_6 <= as_number(((((slice0shift_search_1_3 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_3 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_3 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_3_count_7 <= as_number(((((slice0shift_search_1_3 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_3 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_3 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
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
      slice0cost_pixels_first_1_4_count_4 <= as_number(((((slice0shift_search_1_4 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_4 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_4 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_4_count_5 <= as_number(((((slice0shift_search_1_4 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_4 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_4 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_4_count_6 <= as_number(((((slice0shift_search_1_4 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_4 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_4 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_4_count_7 <= as_number(((((slice0shift_search_1_4 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_4 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_4 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_5_count_0 <= as_number((((slice0shift_search_1_5 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_5 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_5 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_5_count_1 <= as_number(((((slice0shift_search_1_5 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_5 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_5 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_5_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_5 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_5 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_5 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_5_count_3 <= as_number(((((slice0shift_search_1_5 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_5 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_5 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_5_count_4 <= as_number(((((slice0shift_search_1_5 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_5 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_5 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_5_count_5 <= as_number(((((slice0shift_search_1_5 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_5 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_5 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_5_count_6 <= as_number(((((slice0shift_search_1_5 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_5 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_5 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_5_count_7 <= as_number(((((slice0shift_search_1_5 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_5 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_5 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_6_count_0 <= as_number((((slice0shift_search_1_6 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_6 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_6 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_6_count_1 <= as_number(((((slice0shift_search_1_6 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_6 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_6 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_6_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_6 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_6 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_6 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_6_count_3 <= as_number(((((slice0shift_search_1_6 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_6 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_6 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_6_count_4 <= as_number(((((slice0shift_search_1_6 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_6 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_6 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_6_count_5 <= as_number(((((slice0shift_search_1_6 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_6 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_6 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_6_count_6 <= as_number(((((slice0shift_search_1_6 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_6 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_6 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_6_count_7 <= as_number(((((slice0shift_search_1_6 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_6 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_6 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_7_count_0 <= as_number((((slice0shift_search_1_7 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_7 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_7 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_7_count_1 <= as_number(((((slice0shift_search_1_7 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_7 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_7 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_7_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_7 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_7 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_7 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_7_count_3 <= as_number(((((slice0shift_search_1_7 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_7 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_7 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_7_count_4 <= as_number(((((slice0shift_search_1_7 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_7 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_7 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_7_count_5 <= as_number(((((slice0shift_search_1_7 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_7 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_7 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_7_count_6 <= as_number(((((slice0shift_search_1_7 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_7 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_7 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_7_count_7 <= as_number(((((slice0shift_search_1_7 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_7 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_7 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_8_count_0 <= as_number((((slice0shift_search_1_8 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_8 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_8 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_8_count_1 <= as_number(((((slice0shift_search_1_8 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_8 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_8 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_8_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_8 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_8 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_8 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_8_count_3 <= as_number(((((slice0shift_search_1_8 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_8 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_8 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_8_count_4 <= as_number(((((slice0shift_search_1_8 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_8 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_8 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_8_count_5 <= as_number(((((slice0shift_search_1_8 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_8 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_8 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_8_count_6 <= as_number(((((slice0shift_search_1_8 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_8 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_8 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_8_count_7 <= as_number(((((slice0shift_search_1_8 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_8 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_8 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_9_count_0 <= as_number((((slice0shift_search_1_9 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_9 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_9 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_9_count_1 <= as_number(((((slice0shift_search_1_9 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_9 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_9 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_9_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_9 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_9 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_9 / 64) mod 2) = 1)
        /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_9_count_3 <= as_number(((((slice0shift_search_1_9 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_9 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_9 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_9_count_4 <= as_number(((((slice0shift_search_1_9 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_9 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_9 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_9_count_5 <= as_number(((((slice0shift_search_1_9 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_9 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_9 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_9_count_6 <= as_number(((((slice0shift_search_1_9 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_9 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_9 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_9_count_7 <= as_number(((((slice0shift_search_1_9 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_9 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_9 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_10_count_0 <= as_number((((slice0shift_search_1_10 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_10 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_10 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_10_count_1 <= as_number(((((slice0shift_search_1_10 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_10 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_10 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_10_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_10 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_10 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_10 / 64) mod 2) =
        1) /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_10_count_3 <= as_number(((((slice0shift_search_1_10 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_10 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_10 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_10_count_4 <= as_number(((((slice0shift_search_1_10 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_10 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_10 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_10_count_5 <= as_number(((((slice0shift_search_1_10 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_10 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_10 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_10_count_6 <= as_number(((((slice0shift_search_1_10 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_10 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_10 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_10_count_7 <= as_number(((((slice0shift_search_1_10 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_10 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_10 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_11_count_0 <= as_number((((slice0shift_search_1_11 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_11 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_11 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_11_count_1 <= as_number(((((slice0shift_search_1_11 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_11 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_11 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_11_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_11 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_11 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_11 / 64) mod 2) =
        1) /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_11_count_3 <= as_number(((((slice0shift_search_1_11 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_11 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_11 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_11_count_4 <= as_number(((((slice0shift_search_1_11 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_11 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_11 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_11_count_5 <= as_number(((((slice0shift_search_1_11 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_11 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_11 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_11_count_6 <= as_number(((((slice0shift_search_1_11 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_11 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_11 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_11_count_7 <= as_number(((((slice0shift_search_1_11 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_11 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_11 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_12_count_0 <= as_number((((slice0shift_search_1_12 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_12 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_12 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_12_count_1 <= as_number(((((slice0shift_search_1_12 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_12 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_12 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_12_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_12 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_12 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_12 / 64) mod 2) =
        1) /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_12_count_3 <= as_number(((((slice0shift_search_1_12 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_12 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_12 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_12_count_4 <= as_number(((((slice0shift_search_1_12 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_12 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_12 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_12_count_5 <= as_number(((((slice0shift_search_1_12 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_12 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_12 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_12_count_6 <= as_number(((((slice0shift_search_1_12 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_12 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_12 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_12_count_7 <= as_number(((((slice0shift_search_1_12 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_12 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_12 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_13_count_0 <= as_number((((slice0shift_search_1_13 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_13 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_13 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_13_count_1 <= as_number(((((slice0shift_search_1_13 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_13 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_13 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_13_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_13 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_13 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_13 / 64) mod 2) =
        1) /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_13_count_3 <= as_number(((((slice0shift_search_1_13 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_13 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_13 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_13_count_4 <= as_number(((((slice0shift_search_1_13 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_13 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_13 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_13_count_5 <= as_number(((((slice0shift_search_1_13 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_13 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_13 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_13_count_6 <= as_number(((((slice0shift_search_1_13 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_13 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_13 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_13_count_7 <= as_number(((((slice0shift_search_1_13 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_13 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_13 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_14_count_0 <= as_number((((slice0shift_search_1_14 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_14 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_14 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_14_count_1 <= as_number(((((slice0shift_search_1_14 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_14 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_14 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_14_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_14 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_14 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_14 / 64) mod 2) =
        1) /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_14_count_3 <= as_number(((((slice0shift_search_1_14 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_14 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_14 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_14_count_4 <= as_number(((((slice0shift_search_1_14 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_14 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_14 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_14_count_5 <= as_number(((((slice0shift_search_1_14 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_14 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_14 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_14_count_6 <= as_number(((((slice0shift_search_1_14 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_14 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_14 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_14_count_7 <= as_number(((((slice0shift_search_1_14 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_14 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_14 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_1_15_count_0 <= as_number((((slice0shift_search_1_15 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_15 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value)) + as_number(((((slice0shift_search_1_15 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_15_count_1 <= as_number(((((slice0shift_search_1_15 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((((slice0shift_search_1_15 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice0shift_search_1_15 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_15_count_2 <= (to_integer(((to_unsigned((slice0shift_search_1_15 mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice0shift_search_1_15 / 256) mod
        2) = 1) /= slice0cost_pixels_first_1_0_count_2_value)) + as_number(((((slice0shift_search_1_15 / 64) mod 2) =
        1) /= slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_15_count_3 <= as_number(((((slice0shift_search_1_15 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((((slice0shift_search_1_15 / 2048) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice0shift_search_1_15 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_15_count_4 <= as_number(((((slice0shift_search_1_15 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((((slice0shift_search_1_15 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice0shift_search_1_15 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_15_count_5 <= as_number(((((slice0shift_search_1_15 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((((slice0shift_search_1_15 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice0shift_search_1_15 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_15_count_6 <= as_number(((((slice0shift_search_1_15 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((((slice0shift_search_1_15 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice0shift_search_1_15 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_15_count_7 <= as_number(((((slice0shift_search_1_15 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number((((slice0shift_search_1_15 / 8388608) = 1) /=
        ((slice0shift_reference_1 / 8388608) = 1))) + as_number(((((slice0shift_search_1_15 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2));
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_row_start <= slice0shift_tag_row_start;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_first_column <= slice0shift_tag_first_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= slice0cost_pixels_first_0_0_count_0 + slice0cost_pixels_first_0_0_count_2 +
        slice0cost_pixels_first_0_0_count_3 + slice0cost_pixels_first_0_0_count_5 + slice0cost_pixels_first_0_0_count_6
        + slice0cost_pixels_first_0_0_count_4 + slice0cost_pixels_first_0_0_count_7 +
        slice0cost_pixels_first_0_0_count_1;
      slice0cost_pixels_cost_0_1 <= slice0cost_pixels_first_0_1_count_0 + slice0cost_pixels_first_0_1_count_2 +
        slice0cost_pixels_first_0_1_count_3 + slice0cost_pixels_first_0_1_count_5 + slice0cost_pixels_first_0_1_count_6
        + slice0cost_pixels_first_0_1_count_4 + slice0cost_pixels_first_0_1_count_7 +
        slice0cost_pixels_first_0_1_count_1;
      slice0cost_pixels_cost_0_2 <= slice0cost_pixels_first_0_2_count_0 + slice0cost_pixels_first_0_2_count_2 +
        slice0cost_pixels_first_0_2_count_3 + slice0cost_pixels_first_0_2_count_5 + slice0cost_pixels_first_0_2_count_6
        + slice0cost_pixels_first_0_2_count_4 + slice0cost_pixels_first_0_2_count_7 +
        slice0cost_pixels_first_0_2_count_1;
      slice0cost_pixels_cost_0_3 <= slice0cost_pixels_first_0_3_count_0 + slice0cost_pixels_first_0_3_count_2 +
        slice0cost_pixels_first_0_3_count_3 + slice0cost_pixels_first_0_3_count_5 + slice0cost_pixels_first_0_3_count_6
        + slice0cost_pixels_first_0_3_count_4 + slice0cost_pixels_first_0_3_count_7 +
        slice0cost_pixels_first_0_3_count_1;
      slice0cost_pixels_cost_0_4 <= slice0cost_pixels_first_0_4_count_0 + slice0cost_pixels_first_0_4_count_2 +
        slice0cost_pixels_first_0_4_count_3 + slice0cost_pixels_first_0_4_count_5 + slice0cost_pixels_first_0_4_count_6
        + slice0cost_pixels_first_0_4_count_4 + slice0cost_pixels_first_0_4_count_7 +
        slice0cost_pixels_first_0_4_count_1;
      slice0cost_pixels_cost_0_5 <= slice0cost_pixels_first_0_5_count_0 + slice0cost_pixels_first_0_5_count_2 +
        slice0cost_pixels_first_0_5_count_3 + slice0cost_pixels_first_0_5_count_5 + slice0cost_pixels_first_0_5_count_6
        + slice0cost_pixels_first_0_5_count_4 + slice0cost_pixels_first_0_5_count_7 +
        slice0cost_pixels_first_0_5_count_1;
      slice0cost_pixels_cost_0_6 <= slice0cost_pixels_first_0_6_count_0 + slice0cost_pixels_first_0_6_count_2 +
        slice0cost_pixels_first_0_6_count_3 + slice0cost_pixels_first_0_6_count_5 + slice0cost_pixels_first_0_6_count_6
        + slice0cost_pixels_first_0_6_count_4 + slice0cost_pixels_first_0_6_count_7 +
        slice0cost_pixels_first_0_6_count_1;
      slice0cost_pixels_cost_0_7 <= slice0cost_pixels_first_0_7_count_0 + slice0cost_pixels_first_0_7_count_2 +
        slice0cost_pixels_first_0_7_count_3 + slice0cost_pixels_first_0_7_count_5 + slice0cost_pixels_first_0_7_count_6
        + slice0cost_pixels_first_0_7_count_4 + slice0cost_pixels_first_0_7_count_7 +
        slice0cost_pixels_first_0_7_count_1;
      slice0cost_pixels_cost_0_8 <= slice0cost_pixels_first_0_8_count_0 + slice0cost_pixels_first_0_8_count_2 +
        slice0cost_pixels_first_0_8_count_3 + slice0cost_pixels_first_0_8_count_5 + slice0cost_pixels_first_0_8_count_6
        + slice0cost_pixels_first_0_8_count_4 + slice0cost_pixels_first_0_8_count_7 +
        slice0cost_pixels_first_0_8_count_1;
      slice0cost_pixels_cost_0_9 <= slice0cost_pixels_first_0_9_count_0 + slice0cost_pixels_first_0_9_count_2 +
        slice0cost_pixels_first_0_9_count_3 + slice0cost_pixels_first_0_9_count_5 + slice0cost_pixels_first_0_9_count_6
        + slice0cost_pixels_first_0_9_count_4 + slice0cost_pixels_first_0_9_count_7 +
        slice0cost_pixels_first_0_9_count_1;
      slice0cost_pixels_cost_0_10 <= slice0cost_pixels_first_0_10_count_0 + slice0cost_pixels_first_0_10_count_2 +
        slice0cost_pixels_first_0_10_count_3 + slice0cost_pixels_first_0_10_count_5 +
        slice0cost_pixels_first_0_10_count_6 + slice0cost_pixels_first_0_10_count_4 +
        slice0cost_pixels_first_0_10_count_7 + slice0cost_pixels_first_0_10_count_1;
      slice0cost_pixels_cost_0_11 <= slice0cost_pixels_first_0_11_count_0 + slice0cost_pixels_first_0_11_count_2 +
        slice0cost_pixels_first_0_11_count_3 + slice0cost_pixels_first_0_11_count_5 +
        slice0cost_pixels_first_0_11_count_6 + slice0cost_pixels_first_0_11_count_4 +
        slice0cost_pixels_first_0_11_count_7 + slice0cost_pixels_first_0_11_count_1;
      slice0cost_pixels_cost_0_12 <= slice0cost_pixels_first_0_12_count_0 + slice0cost_pixels_first_0_12_count_2 +
        slice0cost_pixels_first_0_12_count_3 + slice0cost_pixels_first_0_12_count_5 +
        slice0cost_pixels_first_0_12_count_6 + slice0cost_pixels_first_0_12_count_4 +
        slice0cost_pixels_first_0_12_count_7 + slice0cost_pixels_first_0_12_count_1;
      slice0cost_pixels_cost_0_13 <= slice0cost_pixels_first_0_13_count_0 + slice0cost_pixels_first_0_13_count_2 +
        slice0cost_pixels_first_0_13_count_3 + slice0cost_pixels_first_0_13_count_5 +
        slice0cost_pixels_first_0_13_count_6 + slice0cost_pixels_first_0_13_count_4 +
        slice0cost_pixels_first_0_13_count_7 + slice0cost_pixels_first_0_13_count_1;
      slice0cost_pixels_cost_0_14 <= slice0cost_pixels_first_0_14_count_0 + slice0cost_pixels_first_0_14_count_2 +
        slice0cost_pixels_first_0_14_count_3 + slice0cost_pixels_first_0_14_count_5 +
        slice0cost_pixels_first_0_14_count_6 + slice0cost_pixels_first_0_14_count_4 +
        slice0cost_pixels_first_0_14_count_7 + slice0cost_pixels_first_0_14_count_1;
      slice0cost_pixels_cost_0_15 <= slice0cost_pixels_first_0_15_count_0 + slice0cost_pixels_first_0_15_count_2 +
        slice0cost_pixels_first_0_15_count_3 + slice0cost_pixels_first_0_15_count_5 +
        slice0cost_pixels_first_0_15_count_6 + slice0cost_pixels_first_0_15_count_4 +
        slice0cost_pixels_first_0_15_count_7 + slice0cost_pixels_first_0_15_count_1;
      slice0cost_pixels_cost_1_0 <= slice0cost_pixels_first_1_0_count_0 + slice0cost_pixels_first_1_0_count_2 +
        slice0cost_pixels_first_1_0_count_3 + slice0cost_pixels_first_1_0_count_5 + slice0cost_pixels_first_1_0_count_6
        + slice0cost_pixels_first_1_0_count_4 + slice0cost_pixels_first_1_0_count_7 +
        slice0cost_pixels_first_1_0_count_1;
      slice0cost_pixels_cost_1_1 <= slice0cost_pixels_first_1_1_count_0 + slice0cost_pixels_first_1_1_count_2 +
        slice0cost_pixels_first_1_1_count_3 + slice0cost_pixels_first_1_1_count_5 + slice0cost_pixels_first_1_1_count_6
        + slice0cost_pixels_first_1_1_count_4 + slice0cost_pixels_first_1_1_count_7 +
        slice0cost_pixels_first_1_1_count_1;
      slice0cost_pixels_cost_1_2 <= slice0cost_pixels_first_1_2_count_0 + slice0cost_pixels_first_1_2_count_2 +
        slice0cost_pixels_first_1_2_count_3 + slice0cost_pixels_first_1_2_count_5 + slice0cost_pixels_first_1_2_count_6
        + slice0cost_pixels_first_1_2_count_4 + slice0cost_pixels_first_1_2_count_7 +
        slice0cost_pixels_first_1_2_count_1;
      slice0cost_pixels_cost_1_3 <= slice0cost_pixels_first_1_3_count_0 + slice0cost_pixels_first_1_3_count_2 +
        slice0cost_pixels_first_1_3_count_3 + slice0cost_pixels_first_1_3_count_5 + slice0cost_pixels_first_1_3_count_6
        + slice0cost_pixels_first_1_3_count_4 + slice0cost_pixels_first_1_3_count_7 +
        slice0cost_pixels_first_1_3_count_1;
      slice0cost_pixels_cost_1_4 <= slice0cost_pixels_first_1_4_count_0 + slice0cost_pixels_first_1_4_count_2 +
        slice0cost_pixels_first_1_4_count_3 + slice0cost_pixels_first_1_4_count_5 + slice0cost_pixels_first_1_4_count_6
        + slice0cost_pixels_first_1_4_count_4 + slice0cost_pixels_first_1_4_count_7 +
        slice0cost_pixels_first_1_4_count_1;
      slice0cost_pixels_cost_1_5 <= slice0cost_pixels_first_1_5_count_0 + slice0cost_pixels_first_1_5_count_2 +
        slice0cost_pixels_first_1_5_count_3 + slice0cost_pixels_first_1_5_count_5 + slice0cost_pixels_first_1_5_count_6
        + slice0cost_pixels_first_1_5_count_4 + slice0cost_pixels_first_1_5_count_7 +
        slice0cost_pixels_first_1_5_count_1;
      slice0cost_pixels_cost_1_6 <= slice0cost_pixels_first_1_6_count_0 + slice0cost_pixels_first_1_6_count_2 +
        slice0cost_pixels_first_1_6_count_3 + slice0cost_pixels_first_1_6_count_5 + slice0cost_pixels_first_1_6_count_6
        + slice0cost_pixels_first_1_6_count_4 + slice0cost_pixels_first_1_6_count_7 +
        slice0cost_pixels_first_1_6_count_1;
      slice0cost_pixels_cost_1_7 <= slice0cost_pixels_first_1_7_count_0 + slice0cost_pixels_first_1_7_count_2 +
        slice0cost_pixels_first_1_7_count_3 + slice0cost_pixels_first_1_7_count_5 + slice0cost_pixels_first_1_7_count_6
        + slice0cost_pixels_first_1_7_count_4 + slice0cost_pixels_first_1_7_count_7 +
        slice0cost_pixels_first_1_7_count_1;
      slice0cost_pixels_cost_1_8 <= slice0cost_pixels_first_1_8_count_0 + slice0cost_pixels_first_1_8_count_2 +
        slice0cost_pixels_first_1_8_count_3 + slice0cost_pixels_first_1_8_count_5 + slice0cost_pixels_first_1_8_count_6
        + slice0cost_pixels_first_1_8_count_4 + slice0cost_pixels_first_1_8_count_7 +
        slice0cost_pixels_first_1_8_count_1;
      slice0cost_pixels_cost_1_9 <= slice0cost_pixels_first_1_9_count_0 + slice0cost_pixels_first_1_9_count_2 +
        slice0cost_pixels_first_1_9_count_3 + slice0cost_pixels_first_1_9_count_5 + slice0cost_pixels_first_1_9_count_6
        + slice0cost_pixels_first_1_9_count_4 + slice0cost_pixels_first_1_9_count_7 +
        slice0cost_pixels_first_1_9_count_1;
      slice0cost_pixels_cost_1_10 <= slice0cost_pixels_first_1_10_count_0 + slice0cost_pixels_first_1_10_count_2 +
        slice0cost_pixels_first_1_10_count_3 + slice0cost_pixels_first_1_10_count_5 +
        slice0cost_pixels_first_1_10_count_6 + slice0cost_pixels_first_1_10_count_4 +
        slice0cost_pixels_first_1_10_count_7 + slice0cost_pixels_first_1_10_count_1;
      slice0cost_pixels_cost_1_11 <= slice0cost_pixels_first_1_11_count_0 + slice0cost_pixels_first_1_11_count_2 +
        slice0cost_pixels_first_1_11_count_3 + slice0cost_pixels_first_1_11_count_5 +
        slice0cost_pixels_first_1_11_count_6 + slice0cost_pixels_first_1_11_count_4 +
        slice0cost_pixels_first_1_11_count_7 + slice0cost_pixels_first_1_11_count_1;
      slice0cost_pixels_cost_1_12 <= slice0cost_pixels_first_1_12_count_0 + slice0cost_pixels_first_1_12_count_2 +
        slice0cost_pixels_first_1_12_count_3 + slice0cost_pixels_first_1_12_count_5 +
        slice0cost_pixels_first_1_12_count_6 + slice0cost_pixels_first_1_12_count_4 +
        slice0cost_pixels_first_1_12_count_7 + slice0cost_pixels_first_1_12_count_1;
      slice0cost_pixels_cost_1_13 <= slice0cost_pixels_first_1_13_count_0 + slice0cost_pixels_first_1_13_count_2 +
        slice0cost_pixels_first_1_13_count_3 + slice0cost_pixels_first_1_13_count_5 +
        slice0cost_pixels_first_1_13_count_6 + slice0cost_pixels_first_1_13_count_4 +
        slice0cost_pixels_first_1_13_count_7 + slice0cost_pixels_first_1_13_count_1;
      slice0cost_pixels_cost_1_14 <= slice0cost_pixels_first_1_14_count_0 + slice0cost_pixels_first_1_14_count_2 +
        slice0cost_pixels_first_1_14_count_3 + slice0cost_pixels_first_1_14_count_5 +
        slice0cost_pixels_first_1_14_count_6 + slice0cost_pixels_first_1_14_count_4 +
        slice0cost_pixels_first_1_14_count_7 + slice0cost_pixels_first_1_14_count_1;
      slice0cost_pixels_cost_1_15 <= slice0cost_pixels_first_1_15_count_0 + slice0cost_pixels_first_1_15_count_2 +
        slice0cost_pixels_first_1_15_count_3 + slice0cost_pixels_first_1_15_count_5 +
        slice0cost_pixels_first_1_15_count_6 + slice0cost_pixels_first_1_15_count_4 +
        slice0cost_pixels_first_1_15_count_7 + slice0cost_pixels_first_1_15_count_1;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_row_start <= slice0cost_pixels_first_tag_row_start;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_first_column <= slice0cost_pixels_first_tag_first_column;
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
      slice0cost_change_0_8 <= slice0cost_pixels_cost_1_8 - slice0cost_pixels_cost_0_8;
      slice0cost_change_0_9 <= slice0cost_pixels_cost_1_9 - slice0cost_pixels_cost_0_9;
      slice0cost_change_0_10 <= slice0cost_pixels_cost_1_10 - slice0cost_pixels_cost_0_10;
      slice0cost_change_0_11 <= slice0cost_pixels_cost_1_11 - slice0cost_pixels_cost_0_11;
      slice0cost_change_0_12 <= slice0cost_pixels_cost_1_12 - slice0cost_pixels_cost_0_12;
      slice0cost_change_0_13 <= slice0cost_pixels_cost_1_13 - slice0cost_pixels_cost_0_13;
      slice0cost_change_0_14 <= slice0cost_pixels_cost_1_14 - slice0cost_pixels_cost_0_14;
      slice0cost_change_0_15 <= slice0cost_pixels_cost_1_15 - slice0cost_pixels_cost_0_15;
      slice0cost_ready_words_0 <= slice0cost_read_words_0;
      slice0cost_ready_words_1 <= slice0cost_read_words_1;
      slice0cost_ready_words_2 <= slice0cost_read_words_2;
      slice0cost_ready_words_3 <= slice0cost_read_words_3;
      slice0cost_ready_column <= slice0cost_change_column;
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_row_start <= slice0cost_pixels_tag_row_start;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_map_column <= slice0cost_pixels_tag_map_column;
      slice0cost_ready_tag_first_column <= slice0cost_pixels_tag_first_column;
      slice0cost_ready_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_ready_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_column_0_0 <= slice0cost_column_0_0_value;
      slice0cost_column_0_1 <= slice0cost_column_0_1_value;
      slice0cost_column_0_2 <= slice0cost_column_0_2_value;
      slice0cost_column_0_3 <= slice0cost_column_0_3_value;
      slice0cost_column_0_4 <= slice0cost_column_0_4_value;
      slice0cost_column_0_5 <= slice0cost_column_0_5_value;
      slice0cost_column_0_6 <= slice0cost_column_0_6_value;
      slice0cost_column_0_7 <= slice0cost_column_0_7_value;
      slice0cost_column_0_8 <= slice0cost_column_0_8_value;
      slice0cost_column_0_9 <= slice0cost_column_0_9_value;
      slice0cost_column_0_10 <= slice0cost_column_0_10_value;
      slice0cost_column_0_11 <= slice0cost_column_0_11_value;
      slice0cost_column_0_12 <= slice0cost_column_0_12_value;
      slice0cost_column_0_13 <= slice0cost_column_0_13_value;
      slice0cost_column_0_14 <= slice0cost_column_0_14_value;
      slice0cost_column_0_15 <= slice0cost_column_0_15_value;
      slice0cost_write_column <= slice0cost_ready_column;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_row_start <= slice0cost_ready_tag_row_start;
      slice0cost_tag_first_group <= slice0cost_ready_tag_first_group;
      slice0cost_tag_leaves_window <= slice0cost_ready_tag_leaves_window;
      slice0cost_tag_map_column <= slice0cost_ready_tag_map_column;
      slice0cost_tag_first_column <= slice0cost_ready_tag_first_column;
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
        slice0cost_write_words_0 <= to_unsigned(slice0cost_column_0_3_value, 8) &
          to_unsigned(slice0cost_column_0_2_value, 8) & to_unsigned(slice0cost_column_0_1_value, 8) &
          to_unsigned(slice0cost_column_0_0_value, 8);
        slice0cost_write_words_1 <= to_unsigned(slice0cost_column_0_7_value, 8) &
          to_unsigned(slice0cost_column_0_6_value, 8) & to_unsigned(slice0cost_column_0_5_value, 8) &
          to_unsigned(slice0cost_column_0_4_value, 8);
        slice0cost_write_words_2 <= to_unsigned(slice0cost_column_0_11_value, 8) &
          to_unsigned(slice0cost_column_0_10_value, 8) & to_unsigned(slice0cost_column_0_9_value, 8) &
          to_unsigned(slice0cost_column_0_8_value, 8);
        slice0cost_write_words_3 <= to_unsigned(slice0cost_column_0_15_value, 8) &
          to_unsigned(slice0cost_column_0_14_value, 8) & to_unsigned(slice0cost_column_0_13_value, 8) &
          to_unsigned(slice0cost_column_0_12_value, 8);
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
        slice0window_change_0_0_choice := to_integer(slice0window_leaving_0(7 downto 0));
      else
        slice0window_change_0_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_1_choice := to_integer(slice0window_leaving_0(15 downto 8));
      else
        slice0window_change_0_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_2_choice := to_integer(slice0window_leaving_0(23 downto 16));
      else
        slice0window_change_0_2_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_3_choice := to_integer(slice0window_leaving_0(31 downto 24));
      else
        slice0window_change_0_3_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_4_choice := to_integer(slice0window_leaving_1(7 downto 0));
      else
        slice0window_change_0_4_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_5_choice := to_integer(slice0window_leaving_1(15 downto 8));
      else
        slice0window_change_0_5_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_6_choice := to_integer(slice0window_leaving_1(23 downto 16));
      else
        slice0window_change_0_6_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_7_choice := to_integer(slice0window_leaving_1(31 downto 24));
      else
        slice0window_change_0_7_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_8_choice := to_integer(slice0window_leaving_2(7 downto 0));
      else
        slice0window_change_0_8_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_9_choice := to_integer(slice0window_leaving_2(15 downto 8));
      else
        slice0window_change_0_9_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_10_choice := to_integer(slice0window_leaving_2(23 downto 16));
      else
        slice0window_change_0_10_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_11_choice := to_integer(slice0window_leaving_2(31 downto 24));
      else
        slice0window_change_0_11_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_12_choice := to_integer(slice0window_leaving_3(7 downto 0));
      else
        slice0window_change_0_12_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_13_choice := to_integer(slice0window_leaving_3(15 downto 8));
      else
        slice0window_change_0_13_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_14_choice := to_integer(slice0window_leaving_3(23 downto 16));
      else
        slice0window_change_0_14_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_15_choice := to_integer(slice0window_leaving_3(31 downto 24));
      else
        slice0window_change_0_15_choice := 0;
      end if;
      slice0window_entering_0_0 <= slice0cost_column_0_0;
      slice0window_entering_0_1 <= slice0cost_column_0_1;
      slice0window_entering_0_2 <= slice0cost_column_0_2;
      slice0window_entering_0_3 <= slice0cost_column_0_3;
      slice0window_entering_0_4 <= slice0cost_column_0_4;
      slice0window_entering_0_5 <= slice0cost_column_0_5;
      slice0window_entering_0_6 <= slice0cost_column_0_6;
      slice0window_entering_0_7 <= slice0cost_column_0_7;
      slice0window_entering_0_8 <= slice0cost_column_0_8;
      slice0window_entering_0_9 <= slice0cost_column_0_9;
      slice0window_entering_0_10 <= slice0cost_column_0_10;
      slice0window_entering_0_11 <= slice0cost_column_0_11;
      slice0window_entering_0_12 <= slice0cost_column_0_12;
      slice0window_entering_0_13 <= slice0cost_column_0_13;
      slice0window_entering_0_14 <= slice0cost_column_0_14;
      slice0window_entering_0_15 <= slice0cost_column_0_15;
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
      slice0window_entering_tag_row_start <= slice0cost_tag_row_start;
      slice0window_entering_tag_first_group <= slice0cost_tag_first_group;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_map_column <= slice0cost_tag_map_column;
      slice0window_entering_tag_first_column <= slice0cost_tag_first_column;
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
      slice0window_change_0_8 <= slice0window_entering_0_8 - slice0window_change_0_8_choice;
      slice0window_change_0_9 <= slice0window_entering_0_9 - slice0window_change_0_9_choice;
      slice0window_change_0_10 <= slice0window_entering_0_10 - slice0window_change_0_10_choice;
      slice0window_change_0_11 <= slice0window_entering_0_11 - slice0window_change_0_11_choice;
      slice0window_change_0_12 <= slice0window_entering_0_12 - slice0window_change_0_12_choice;
      slice0window_change_0_13 <= slice0window_entering_0_13 - slice0window_change_0_13_choice;
      slice0window_change_0_14 <= slice0window_entering_0_14 - slice0window_change_0_14_choice;
      slice0window_change_0_15 <= slice0window_entering_0_15 - slice0window_change_0_15_choice;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_row_start <= slice0window_entering_tag_row_start;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_map_column <= slice0window_entering_tag_map_column;
      slice0window_change_tag_first_column <= slice0window_entering_tag_first_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_map_column_0 <= slice0window_change_tag_map_column;
      slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_tag_valid <= slice0window_change_tag_valid;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_0_choice := 0;
      else
        slice0window_sum_0_0_choice := slice0window_sum_0_0;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_1_choice := 0;
      else
        slice0window_sum_0_1_choice := slice0window_sum_0_1;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_2_choice := 0;
      else
        slice0window_sum_0_2_choice := slice0window_sum_0_2;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_3_choice := 0;
      else
        slice0window_sum_0_3_choice := slice0window_sum_0_3;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_4_choice := 0;
      else
        slice0window_sum_0_4_choice := slice0window_sum_0_4;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_5_choice := 0;
      else
        slice0window_sum_0_5_choice := slice0window_sum_0_5;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_6_choice := 0;
      else
        slice0window_sum_0_6_choice := slice0window_sum_0_6;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_7_choice := 0;
      else
        slice0window_sum_0_7_choice := slice0window_sum_0_7;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_8_choice := 0;
      else
        slice0window_sum_0_8_choice := slice0window_sum_0_8;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_9_choice := 0;
      else
        slice0window_sum_0_9_choice := slice0window_sum_0_9;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_10_choice := 0;
      else
        slice0window_sum_0_10_choice := slice0window_sum_0_10;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_11_choice := 0;
      else
        slice0window_sum_0_11_choice := slice0window_sum_0_11;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_12_choice := 0;
      else
        slice0window_sum_0_12_choice := slice0window_sum_0_12;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_13_choice := 0;
      else
        slice0window_sum_0_13_choice := slice0window_sum_0_13;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_14_choice := 0;
      else
        slice0window_sum_0_14_choice := slice0window_sum_0_14;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_15_choice := 0;
      else
        slice0window_sum_0_15_choice := slice0window_sum_0_15;
      end if;
      if slice0window_change_tag_valid then
        slice0window_sum_0_0 <= (slice0window_sum_0_0_choice + slice0window_change_0_0) mod 2048;
        slice0window_sum_0_1 <= (slice0window_sum_0_1_choice + slice0window_change_0_1) mod 2048;
        slice0window_sum_0_2 <= (slice0window_sum_0_2_choice + slice0window_change_0_2) mod 2048;
        slice0window_sum_0_3 <= (slice0window_sum_0_3_choice + slice0window_change_0_3) mod 2048;
        slice0window_sum_0_4 <= (slice0window_sum_0_4_choice + slice0window_change_0_4) mod 2048;
        slice0window_sum_0_5 <= (slice0window_sum_0_5_choice + slice0window_change_0_5) mod 2048;
        slice0window_sum_0_6 <= (slice0window_sum_0_6_choice + slice0window_change_0_6) mod 2048;
        slice0window_sum_0_7 <= (slice0window_sum_0_7_choice + slice0window_change_0_7) mod 2048;
        slice0window_sum_0_8 <= (slice0window_sum_0_8_choice + slice0window_change_0_8) mod 2048;
        slice0window_sum_0_9 <= (slice0window_sum_0_9_choice + slice0window_change_0_9) mod 2048;
        slice0window_sum_0_10 <= (slice0window_sum_0_10_choice + slice0window_change_0_10) mod 2048;
        slice0window_sum_0_11 <= (slice0window_sum_0_11_choice + slice0window_change_0_11) mod 2048;
        slice0window_sum_0_12 <= (slice0window_sum_0_12_choice + slice0window_change_0_12) mod 2048;
        slice0window_sum_0_13 <= (slice0window_sum_0_13_choice + slice0window_change_0_13) mod 2048;
        slice0window_sum_0_14 <= (slice0window_sum_0_14_choice + slice0window_change_0_14) mod 2048;
        slice0window_sum_0_15 <= (slice0window_sum_0_15_choice + slice0window_change_0_15) mod 2048;
        slice0window_centre_first_column_0 <= slice0window_change_tag_first_column;
        slice0window_centre_first_column_1 <= slice0window_centre_first_column_0;
        slice0window_centre_first_column_2 <= slice0window_centre_first_column_1;
        slice0window_centre_first_column_3 <= slice0window_centre_first_column_2;
      end if;
      if slice0winner1_tag_valid then
        slice0window_centre_start_of_frame_3 <= slice2window_centre_start_of_frame_0;
        slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_3;
      end if;
      if slice0window_tag_valid then
        slice0window_tag_first_column <= slice1window_centre_first_column_2;
      end if;
      -- slice0mask
      if slice0window_change_tag_valid then
        slice0mask_inside_0_choice := slice0window_centre_first_column_3;
      else
        slice0mask_inside_0_choice := slice0mask_inside_0;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_1_choice := slice0mask_inside_0;
      else
        slice0mask_inside_1_choice := slice0mask_inside_1;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_2_choice := slice0mask_inside_1;
      else
        slice0mask_inside_2_choice := slice0mask_inside_2;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_3_choice := slice0mask_inside_2;
      else
        slice0mask_inside_3_choice := slice0mask_inside_3;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_4_choice := slice0mask_inside_3;
      else
        slice0mask_inside_4_choice := slice0mask_inside_4;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_5_choice := slice0mask_inside_4;
      else
        slice0mask_inside_5_choice := slice0mask_inside_5;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_6_choice := slice0mask_inside_5;
      else
        slice0mask_inside_6_choice := slice0mask_inside_6;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_7_choice := slice0mask_inside_6;
      else
        slice0mask_inside_7_choice := slice0mask_inside_7;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_8_choice := slice0mask_inside_7;
      else
        slice0mask_inside_8_choice := slice0mask_inside_8;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_9_choice := slice0mask_inside_8;
      else
        slice0mask_inside_9_choice := slice0mask_inside_9;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_10_choice := slice0mask_inside_9;
      else
        slice0mask_inside_10_choice := slice0mask_inside_10;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_11_choice := slice0mask_inside_10;
      else
        slice0mask_inside_11_choice := slice0mask_inside_11;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_12_choice := slice0mask_inside_11;
      else
        slice0mask_inside_12_choice := slice0mask_inside_12;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_13_choice := slice0mask_inside_12;
      else
        slice0mask_inside_13_choice := slice0mask_inside_13;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_14_choice := slice0mask_inside_13;
      else
        slice0mask_inside_14_choice := slice0mask_inside_14;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_15_choice := slice0mask_inside_14;
      else
        slice0mask_inside_15_choice := slice0mask_inside_15;
      end if;
      slice0mask_left_out <= slice0mask_inside_15;
      if slice0mask_column < 441 then
        slice0mask_inside_0 <= slice0mask_inside_0 or slice0window_change_tag_valid;
      else
        slice0mask_inside_0 <= slice0mask_inside_0_choice;
      end if;
      if slice0window_centre_first_column_3 then
        slice0mask_inside_1 <= slice0mask_inside_1 and (not slice0window_change_tag_valid);
        slice0mask_inside_2 <= slice0mask_inside_2 and (not slice0window_change_tag_valid);
        slice0mask_inside_3 <= slice0mask_inside_3 and (not slice0window_change_tag_valid);
        slice0mask_inside_4 <= slice0mask_inside_4 and (not slice0window_change_tag_valid);
        slice0mask_inside_5 <= slice0mask_inside_5 and (not slice0window_change_tag_valid);
        slice0mask_inside_6 <= slice0mask_inside_6 and (not slice0window_change_tag_valid);
        slice0mask_inside_7 <= slice0mask_inside_7 and (not slice0window_change_tag_valid);
        slice0mask_inside_8 <= slice0mask_inside_8 and (not slice0window_change_tag_valid);
        slice0mask_inside_9 <= slice0mask_inside_9 and (not slice0window_change_tag_valid);
        slice0mask_inside_10 <= slice0mask_inside_10 and (not slice0window_change_tag_valid);
        slice0mask_inside_11 <= slice0mask_inside_11 and (not slice0window_change_tag_valid);
        slice0mask_inside_12 <= slice0mask_inside_12 and (not slice0window_change_tag_valid);
        slice0mask_inside_13 <= slice0mask_inside_13 and (not slice0window_change_tag_valid);
        slice0mask_inside_14 <= slice0mask_inside_14 and (not slice0window_change_tag_valid);
        slice0mask_inside_15 <= slice0mask_inside_15 and (not slice0window_change_tag_valid);
      else
        slice0mask_inside_1 <= slice0mask_inside_1_choice;
        slice0mask_inside_2 <= slice0mask_inside_2_choice;
        slice0mask_inside_3 <= slice0mask_inside_3_choice;
        slice0mask_inside_4 <= slice0mask_inside_4_choice;
        slice0mask_inside_5 <= slice0mask_inside_5_choice;
        slice0mask_inside_6 <= slice0mask_inside_6_choice;
        slice0mask_inside_7 <= slice0mask_inside_7_choice;
        slice0mask_inside_8 <= slice0mask_inside_8_choice;
        slice0mask_inside_9 <= slice0mask_inside_9_choice;
        slice0mask_inside_10 <= slice0mask_inside_10_choice;
        slice0mask_inside_11 <= slice0mask_inside_11_choice;
        slice0mask_inside_12 <= slice0mask_inside_12_choice;
        slice0mask_inside_13 <= slice0mask_inside_13_choice;
        slice0mask_inside_14 <= slice0mask_inside_14_choice;
        slice0mask_inside_15 <= slice0mask_inside_15_choice;
      end if;
      if slice0window_change_tag_valid then
        if slice0window_centre_first_column_3 then
          slice0mask_column <= 0;
        else
          slice0mask_column <= (slice0mask_column + 1) mod 512;
        end if;
      end if;
      -- slice0winner1
      if slice0mask_inside_1 then
        slice0winner1_best_cost_0_0_choice := 0;
      else
        slice0winner1_best_cost_0_0_choice := 2047;
      end if;
      slice0winner1_best_cost_0_0_any := to_integer(((to_unsigned(slice0window_sum_0_1, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_0_choice, 11))));
      if slice0mask_inside_0 then
        slice0winner1_best_cost_0_0_choice_2 := 0;
      else
        slice0winner1_best_cost_0_0_choice_2 := 2047;
      end if;
      slice0winner1_best_cost_0_0_any_2 := to_integer(((to_unsigned(slice0window_sum_0_0, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_0_choice_2, 11))));
      slice0winner1_best_cost_0_0_is_less := (slice0winner1_best_cost_0_0_any - slice0winner1_best_cost_0_0_any_2) < 0;
      if slice0mask_inside_3 then
        slice0winner1_best_cost_0_1_choice := 0;
      else
        slice0winner1_best_cost_0_1_choice := 2047;
      end if;
      slice0winner1_best_cost_0_1_any := to_integer(((to_unsigned(slice0window_sum_0_3, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_1_choice, 11))));
      if slice0mask_inside_2 then
        slice0winner1_best_cost_0_1_choice_2 := 0;
      else
        slice0winner1_best_cost_0_1_choice_2 := 2047;
      end if;
      slice0winner1_best_cost_0_1_any_2 := to_integer(((to_unsigned(slice0window_sum_0_2, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_1_choice_2, 11))));
      slice0winner1_best_cost_0_1_is_less := (slice0winner1_best_cost_0_1_any - slice0winner1_best_cost_0_1_any_2) < 0;
      if slice0mask_inside_5 then
        slice0winner1_best_cost_0_2_choice := 0;
      else
        slice0winner1_best_cost_0_2_choice := 2047;
      end if;
      slice0winner1_best_cost_0_2_any := to_integer(((to_unsigned(slice0window_sum_0_5, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_2_choice, 11))));
      if slice0mask_inside_4 then
        slice0winner1_best_cost_0_2_choice_2 := 0;
      else
        slice0winner1_best_cost_0_2_choice_2 := 2047;
      end if;
      slice0winner1_best_cost_0_2_any_2 := to_integer(((to_unsigned(slice0window_sum_0_4, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_2_choice_2, 11))));
      slice0winner1_best_cost_0_2_is_less := (slice0winner1_best_cost_0_2_any - slice0winner1_best_cost_0_2_any_2) < 0;
      if slice0mask_inside_7 then
        slice0winner1_best_cost_0_3_choice := 0;
      else
        slice0winner1_best_cost_0_3_choice := 2047;
      end if;
      slice0winner1_best_cost_0_3_any := to_integer(((to_unsigned(slice0window_sum_0_7, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_3_choice, 11))));
      if slice0mask_inside_6 then
        slice0winner1_best_cost_0_3_choice_2 := 0;
      else
        slice0winner1_best_cost_0_3_choice_2 := 2047;
      end if;
      slice0winner1_best_cost_0_3_any_2 := to_integer(((to_unsigned(slice0window_sum_0_6, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_3_choice_2, 11))));
      slice0winner1_best_cost_0_3_is_less := (slice0winner1_best_cost_0_3_any - slice0winner1_best_cost_0_3_any_2) < 0;
      if slice0mask_inside_9 then
        slice0winner1_best_cost_0_4_choice := 0;
      else
        slice0winner1_best_cost_0_4_choice := 2047;
      end if;
      slice0winner1_best_cost_0_4_any := to_integer(((to_unsigned(slice0window_sum_0_9, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_4_choice, 11))));
      if slice0mask_inside_8 then
        slice0winner1_best_cost_0_4_choice_2 := 0;
      else
        slice0winner1_best_cost_0_4_choice_2 := 2047;
      end if;
      slice0winner1_best_cost_0_4_any_2 := to_integer(((to_unsigned(slice0window_sum_0_8, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_4_choice_2, 11))));
      slice0winner1_best_cost_0_4_is_less := (slice0winner1_best_cost_0_4_any - slice0winner1_best_cost_0_4_any_2) < 0;
      if slice0mask_inside_11 then
        slice0winner1_best_cost_0_5_choice := 0;
      else
        slice0winner1_best_cost_0_5_choice := 2047;
      end if;
      slice0winner1_best_cost_0_5_any := to_integer(((to_unsigned(slice0window_sum_0_11, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_5_choice, 11))));
      if slice0mask_inside_10 then
        slice0winner1_best_cost_0_5_choice_2 := 0;
      else
        slice0winner1_best_cost_0_5_choice_2 := 2047;
      end if;
      slice0winner1_best_cost_0_5_any_2 := to_integer(((to_unsigned(slice0window_sum_0_10, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_5_choice_2, 11))));
      slice0winner1_best_cost_0_5_is_less := (slice0winner1_best_cost_0_5_any - slice0winner1_best_cost_0_5_any_2) < 0;
      if slice0mask_inside_13 then
        slice0winner1_best_cost_0_6_choice := 0;
      else
        slice0winner1_best_cost_0_6_choice := 2047;
      end if;
      slice0winner1_best_cost_0_6_any := to_integer(((to_unsigned(slice0window_sum_0_13, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_6_choice, 11))));
      if slice0mask_inside_12 then
        slice0winner1_best_cost_0_6_choice_2 := 0;
      else
        slice0winner1_best_cost_0_6_choice_2 := 2047;
      end if;
      slice0winner1_best_cost_0_6_any_2 := to_integer(((to_unsigned(slice0window_sum_0_12, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_6_choice_2, 11))));
      slice0winner1_best_cost_0_6_is_less := (slice0winner1_best_cost_0_6_any - slice0winner1_best_cost_0_6_any_2) < 0;
      if slice0mask_inside_15 then
        slice0winner1_best_cost_0_7_choice := 0;
      else
        slice0winner1_best_cost_0_7_choice := 2047;
      end if;
      slice0winner1_best_cost_0_7_any := to_integer(((to_unsigned(slice0window_sum_0_15, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_7_choice, 11))));
      if slice0mask_inside_14 then
        slice0winner1_best_cost_0_7_choice_2 := 0;
      else
        slice0winner1_best_cost_0_7_choice_2 := 2047;
      end if;
      slice0winner1_best_cost_0_7_any_2 := to_integer(((to_unsigned(slice0window_sum_0_14, 11)) or
        (to_unsigned(slice0winner1_best_cost_0_7_choice_2, 11))));
      slice0winner1_best_cost_0_7_is_less := (slice0winner1_best_cost_0_7_any - slice0winner1_best_cost_0_7_any_2) < 0;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_first_0_1 <= slice0winner1_best_cost_0_1_any_2;
      slice0winner1_best_first_0_2 <= slice0winner1_best_cost_0_2_any_2;
      slice0winner1_best_first_0_3 <= slice0winner1_best_cost_0_3_any_2;
      slice0winner1_best_first_0_4 <= slice0winner1_best_cost_0_4_any_2;
      slice0winner1_best_first_0_5 <= slice0winner1_best_cost_0_5_any_2;
      slice0winner1_best_first_0_6 <= slice0winner1_best_cost_0_6_any_2;
      slice0winner1_best_first_0_7 <= slice0winner1_best_cost_0_7_any_2;
      slice0winner1_best_last_0_0 <= slice0winner1_best_cost_0_0_any;
      slice0winner1_best_last_0_1 <= slice0winner1_best_cost_0_1_any;
      slice0winner1_best_last_0_2 <= slice0winner1_best_cost_0_2_any;
      slice0winner1_best_last_0_3 <= slice0winner1_best_cost_0_3_any;
      slice0winner1_best_last_0_4 <= slice0winner1_best_cost_0_4_any;
      slice0winner1_best_last_0_5 <= slice0winner1_best_cost_0_5_any;
      slice0winner1_best_last_0_6 <= slice0winner1_best_cost_0_6_any;
      slice0winner1_best_last_0_7 <= slice0winner1_best_cost_0_7_any;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      if slice0winner1_best_cost_0_0_is_less then
        slice0winner1_best_cost_0_0 <= slice0winner1_best_cost_0_0_any;
        slice0winner1_best_below_0_0 <= slice0winner1_best_cost_0_0_any_2;
        slice0winner1_best_above_0_0 <= 0;
      else
        slice0winner1_best_cost_0_0 <= slice0winner1_best_cost_0_0_any_2;
        slice0winner1_best_below_0_0 <= 0;
        slice0winner1_best_above_0_0 <= slice0winner1_best_cost_0_0_any;
      end if;
      if slice0winner1_best_cost_0_1_is_less then
        slice0winner1_best_cost_0_1 <= slice0winner1_best_cost_0_1_any;
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0_1 <= slice0winner1_best_cost_0_1_any_2;
        slice0winner1_best_above_0_1 <= 0;
      else
        slice0winner1_best_cost_0_1 <= slice0winner1_best_cost_0_1_any_2;
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0_1 <= 0;
        slice0winner1_best_above_0_1 <= slice0winner1_best_cost_0_1_any;
      end if;
      if slice0winner1_best_cost_0_2_is_less then
        slice0winner1_best_cost_0_2 <= slice0winner1_best_cost_0_2_any;
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0_2 <= slice0winner1_best_cost_0_2_any_2;
        slice0winner1_best_above_0_2 <= 0;
      else
        slice0winner1_best_cost_0_2 <= slice0winner1_best_cost_0_2_any_2;
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0_2 <= 0;
        slice0winner1_best_above_0_2 <= slice0winner1_best_cost_0_2_any;
      end if;
      if slice0winner1_best_cost_0_3_is_less then
        slice0winner1_best_cost_0_3 <= slice0winner1_best_cost_0_3_any;
        slice0winner1_best_index_0_3 <= 7;
        slice0winner1_best_below_0_3 <= slice0winner1_best_cost_0_3_any_2;
        slice0winner1_best_above_0_3 <= 0;
      else
        slice0winner1_best_cost_0_3 <= slice0winner1_best_cost_0_3_any_2;
        slice0winner1_best_index_0_3 <= 6;
        slice0winner1_best_below_0_3 <= 0;
        slice0winner1_best_above_0_3 <= slice0winner1_best_cost_0_3_any;
      end if;
      if slice0winner1_best_cost_0_4_is_less then
        slice0winner1_best_cost_0_4 <= slice0winner1_best_cost_0_4_any;
        slice0winner1_best_index_0_4 <= 9;
        slice0winner1_best_below_0_4 <= slice0winner1_best_cost_0_4_any_2;
        slice0winner1_best_above_0_4 <= 0;
      else
        slice0winner1_best_cost_0_4 <= slice0winner1_best_cost_0_4_any_2;
        slice0winner1_best_index_0_4 <= 8;
        slice0winner1_best_below_0_4 <= 0;
        slice0winner1_best_above_0_4 <= slice0winner1_best_cost_0_4_any;
      end if;
      if slice0winner1_best_cost_0_5_is_less then
        slice0winner1_best_cost_0_5 <= slice0winner1_best_cost_0_5_any;
        slice0winner1_best_index_0_5 <= 11;
        slice0winner1_best_below_0_5 <= slice0winner1_best_cost_0_5_any_2;
        slice0winner1_best_above_0_5 <= 0;
      else
        slice0winner1_best_cost_0_5 <= slice0winner1_best_cost_0_5_any_2;
        slice0winner1_best_index_0_5 <= 10;
        slice0winner1_best_below_0_5 <= 0;
        slice0winner1_best_above_0_5 <= slice0winner1_best_cost_0_5_any;
      end if;
      if slice0winner1_best_cost_0_6_is_less then
        slice0winner1_best_cost_0_6 <= slice0winner1_best_cost_0_6_any;
        slice0winner1_best_index_0_6 <= 13;
        slice0winner1_best_below_0_6 <= slice0winner1_best_cost_0_6_any_2;
        slice0winner1_best_above_0_6 <= 0;
      else
        slice0winner1_best_cost_0_6 <= slice0winner1_best_cost_0_6_any_2;
        slice0winner1_best_index_0_6 <= 12;
        slice0winner1_best_below_0_6 <= 0;
        slice0winner1_best_above_0_6 <= slice0winner1_best_cost_0_6_any;
      end if;
      if slice0winner1_best_cost_0_7_is_less then
        slice0winner1_best_cost_0_7 <= slice0winner1_best_cost_0_7_any;
        slice0winner1_best_index_0_7 <= 15;
        slice0winner1_best_below_0_7 <= slice0winner1_best_cost_0_7_any_2;
        slice0winner1_best_above_0_7 <= 0;
      else
        slice0winner1_best_cost_0_7 <= slice0winner1_best_cost_0_7_any_2;
        slice0winner1_best_index_0_7 <= 14;
        slice0winner1_best_below_0_7 <= 0;
        slice0winner1_best_above_0_7 <= slice0winner1_best_cost_0_7_any;
      end if;
      if slice0winner1_tag_valid then
        slice0winner1_tag_map_column <= slice2window_centre_map_column_2;
        slice0winner1_tag_first_column <= slice2window_centre_first_column_2;
        slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_tag_end_of_line <= slice2window_centre_end_of_line_2;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      slice0winner2_best_cost_0_1_is_less := (slice0winner1_best_cost_0_3 - slice0winner1_best_cost_0_2) < 0;
      slice0winner2_best_cost_0_2_is_less := (slice0winner1_best_cost_0_5 - slice0winner1_best_cost_0_4) < 0;
      slice0winner2_best_cost_0_3_is_less := (slice0winner1_best_cost_0_7 - slice0winner1_best_cost_0_6) < 0;
      if slice0winner1_best_index_0_1 = 2 then
        slice0winner2_best_below_0_0_choice := slice0winner1_best_last_0_0;
      else
        slice0winner2_best_below_0_0_choice := slice0winner1_best_below_0_1;
      end if;
      if slice0winner1_best_index_0_3 = 6 then
        slice0winner2_best_below_0_1_choice := slice0winner1_best_last_0_2;
      else
        slice0winner2_best_below_0_1_choice := slice0winner1_best_below_0_3;
      end if;
      if ((slice0winner1_best_index_0_5 / 8) = 1) and ((slice0winner1_best_index_0_5 mod 4) = 2) then
        slice0winner2_best_below_0_2_choice := slice0winner1_best_last_0_4;
      else
        slice0winner2_best_below_0_2_choice := slice0winner1_best_below_0_5;
      end if;
      if slice0winner1_best_index_0_7 = 14 then
        slice0winner2_best_below_0_3_choice := slice0winner1_best_last_0_6;
      else
        slice0winner2_best_below_0_3_choice := slice0winner1_best_below_0_7;
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_0_choice := slice0winner1_best_first_0_1;
      else
        slice0winner2_best_above_0_0_choice := slice0winner1_best_above_0_0;
      end if;
      if other_0 then
        slice0winner2_best_above_0_1_choice := slice0winner1_best_first_0_3;
      else
        slice0winner2_best_above_0_1_choice := slice0winner1_best_above_0_2;
      end if;
      if other_1 then
        slice0winner2_best_above_0_2_choice := slice0winner1_best_first_0_5;
      else
        slice0winner2_best_above_0_2_choice := slice0winner1_best_above_0_4;
      end if;
      if other_2 then
        slice0winner2_best_above_0_3_choice := slice0winner1_best_first_0_7;
      else
        slice0winner2_best_above_0_3_choice := slice0winner1_best_above_0_6;
      end if;
      slice0winner2_best_first_0_1 <= slice0winner1_best_first_0_2;
      slice0winner2_best_first_0_2 <= slice0winner1_best_first_0_4;
      slice0winner2_best_first_0_3 <= slice0winner1_best_first_0_6;
      slice0winner2_best_last_0_0 <= slice0winner1_best_last_0_1;
      slice0winner2_best_last_0_1 <= slice0winner1_best_last_0_3;
      slice0winner2_best_last_0_2 <= slice0winner1_best_last_0_5;
      slice0winner2_best_last_0_3 <= slice0winner1_best_last_0_7;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      if slice0winner2_best_cost_0_0_is_less then
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_1;
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
        slice0winner2_best_below_0_0 <= slice0winner2_best_below_0_0_choice;
        slice0winner2_best_above_0_0 <= slice0winner1_best_above_0_1;
      else
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_0;
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
        slice0winner2_best_below_0_0 <= slice0winner1_best_below_0_0;
        slice0winner2_best_above_0_0 <= slice0winner2_best_above_0_0_choice;
      end if;
      if slice0winner2_best_cost_0_1_is_less then
        slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_3;
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_3;
        slice0winner2_best_below_0_1 <= slice0winner2_best_below_0_1_choice;
        slice0winner2_best_above_0_1 <= slice0winner1_best_above_0_3;
      else
        slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_2;
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
        slice0winner2_best_below_0_1 <= slice0winner1_best_below_0_2;
        slice0winner2_best_above_0_1 <= slice0winner2_best_above_0_1_choice;
      end if;
      if slice0winner2_best_cost_0_2_is_less then
        slice0winner2_best_cost_0_2 <= slice0winner1_best_cost_0_5;
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_5;
        slice0winner2_best_below_0_2 <= slice0winner2_best_below_0_2_choice;
        slice0winner2_best_above_0_2 <= slice0winner1_best_above_0_5;
      else
        slice0winner2_best_cost_0_2 <= slice0winner1_best_cost_0_4;
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_4;
        slice0winner2_best_below_0_2 <= slice0winner1_best_below_0_4;
        slice0winner2_best_above_0_2 <= slice0winner2_best_above_0_2_choice;
      end if;
      if slice0winner2_best_cost_0_3_is_less then
        slice0winner2_best_cost_0_3 <= slice0winner1_best_cost_0_7;
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_7;
        slice0winner2_best_below_0_3 <= slice0winner2_best_below_0_3_choice;
        slice0winner2_best_above_0_3 <= slice0winner1_best_above_0_7;
      else
        slice0winner2_best_cost_0_3 <= slice0winner1_best_cost_0_6;
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_6;
        slice0winner2_best_below_0_3 <= slice0winner1_best_below_0_6;
        slice0winner2_best_above_0_3 <= slice0winner2_best_above_0_3_choice;
      end if;
      -- slice0winner3
      slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0_1 - slice0winner2_best_cost_0_0) < 0;
      slice0winner3_best_cost_0_1_is_less := (slice0winner2_best_cost_0_3 - slice0winner2_best_cost_0_2) < 0;
      if slice0winner2_best_index_0_1 = 4 then
        slice0winner3_best_below_0_0_choice := slice0winner2_best_last_0_0;
      else
        slice0winner3_best_below_0_0_choice := slice0winner2_best_below_0_1;
      end if;
      if slice0winner2_best_index_0_3 = 12 then
        slice0winner3_best_below_0_1_choice := slice0winner2_best_last_0_2;
      else
        slice0winner3_best_below_0_1_choice := slice0winner2_best_below_0_3;
      end if;
      if slice0winner2_best_index_0_0 = 3 then
        slice0winner3_best_above_0_0_choice := slice0winner2_best_first_0_1;
      else
        slice0winner3_best_above_0_0_choice := slice0winner2_best_above_0_0;
      end if;
      if ((slice0winner2_best_index_0_2 / 8) = 1) and ((slice0winner2_best_index_0_2 mod 4) = 3) then
        slice0winner3_best_above_0_1_choice := slice0winner2_best_first_0_3;
      else
        slice0winner3_best_above_0_1_choice := slice0winner2_best_above_0_2;
      end if;
      slice0winner3_best_first_0_1 <= slice0winner2_best_first_0_2;
      slice0winner3_best_last_0_0 <= slice0winner2_best_last_0_1;
      slice0winner3_best_last_0_1 <= slice0winner2_best_last_0_3;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_map_column <= slice0winner2_tag_map_column;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0winner3_tag_end_of_line <= slice0winner2_tag_end_of_line;
      if slice0winner3_best_cost_0_0_is_less then
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_1;
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1;
        slice0winner3_best_below_0_0 <= slice0winner3_best_below_0_0_choice;
        slice0winner3_best_above_0_0 <= slice0winner2_best_above_0_1;
      else
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_0;
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_0;
        slice0winner3_best_below_0_0 <= slice0winner2_best_below_0_0;
        slice0winner3_best_above_0_0 <= slice0winner3_best_above_0_0_choice;
      end if;
      if slice0winner3_best_cost_0_1_is_less then
        slice0winner3_best_cost_0_1 <= slice0winner2_best_cost_0_3;
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_3;
        slice0winner3_best_below_0_1 <= slice0winner3_best_below_0_1_choice;
        slice0winner3_best_above_0_1 <= slice0winner2_best_above_0_3;
      else
        slice0winner3_best_cost_0_1 <= slice0winner2_best_cost_0_2;
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_2;
        slice0winner3_best_below_0_1 <= slice0winner2_best_below_0_2;
        slice0winner3_best_above_0_1 <= slice0winner3_best_above_0_1_choice;
      end if;
      -- slice0winner4
      slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0_1 - slice0winner3_best_cost_0_0) < 0;
      if slice0winner3_best_index_0_1 = 8 then
        slice0winner4_best_below_0_0_choice := slice0winner3_best_last_0_0;
      else
        slice0winner4_best_below_0_0_choice := slice0winner3_best_below_0_1;
      end if;
      if slice0winner3_best_index_0_0 = 7 then
        slice0winner4_best_above_0_0_choice := slice0winner3_best_first_0_1;
      else
        slice0winner4_best_above_0_0_choice := slice0winner3_best_above_0_0;
      end if;
      slice0winner4_best_last_0_0 <= slice0winner3_best_last_0_1;
      slice0winner4_tag_valid <= slice0winner3_tag_valid;
      slice0winner4_tag_map_column <= slice0winner3_tag_map_column;
      slice0winner4_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0winner4_tag_end_of_line <= slice0winner3_tag_end_of_line;
      if slice0winner4_best_cost_0_0_is_less then
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0_1;
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_1;
        slice0winner4_best_below_0_0 <= slice0winner4_best_below_0_0_choice;
        slice0winner4_best_above_0_0 <= slice0winner3_best_above_0_1;
      else
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0_0;
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_0;
        slice0winner4_best_below_0_0 <= slice0winner3_best_below_0_0;
        slice0winner4_best_above_0_0 <= slice0winner4_best_above_0_0_choice;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner4_best_cost_0_0;
      slice0_best_index_0_0 <= slice0winner4_best_index_0_0;
      slice0_best_below_0_0 <= slice0winner4_best_below_0_0;
      slice0_best_above_0_0 <= slice0winner4_best_above_0_0;
      slice0_best_last_0_0 <= slice0winner4_best_last_0_0;
      slice0_best_tag_valid <= slice0winner4_tag_valid;
      slice0_best_tag_map_column <= slice0winner4_tag_map_column;
      slice0_best_tag_start_of_frame <= slice0winner4_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner4_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice0shift_search_out_0;
        slice1shift_search_0_1 <= slice1shift_search_0_0;
        slice1shift_search_0_2 <= slice1shift_search_0_1;
        slice1shift_search_0_3 <= slice1shift_search_0_2;
        slice1shift_search_0_4 <= slice1shift_search_0_3;
        slice1shift_search_0_5 <= slice1shift_search_0_4;
        slice1shift_search_0_6 <= slice1shift_search_0_5;
        slice1shift_search_0_7 <= slice1shift_search_0_6;
        slice1shift_search_0_8 <= slice1shift_search_0_7;
        slice1shift_search_0_9 <= slice1shift_search_0_8;
        slice1shift_search_0_10 <= slice1shift_search_0_9;
        slice1shift_search_0_11 <= slice1shift_search_0_10;
        slice1shift_search_0_12 <= slice1shift_search_0_11;
        slice1shift_search_0_13 <= slice1shift_search_0_12;
        slice1shift_search_0_14 <= slice1shift_search_0_13;
        slice1shift_search_0_15 <= slice1shift_search_0_14;
        slice1shift_search_1_0 <= slice0shift_search_out_1;
        slice1shift_search_1_1 <= slice1shift_search_1_0;
        slice1shift_search_1_2 <= slice1shift_search_1_1;
        slice1shift_search_1_3 <= slice1shift_search_1_2;
        slice1shift_search_1_4 <= slice1shift_search_1_3;
        slice1shift_search_1_5 <= slice1shift_search_1_4;
        slice1shift_search_1_6 <= slice1shift_search_1_5;
        slice1shift_search_1_7 <= slice1shift_search_1_6;
        slice1shift_search_1_8 <= slice1shift_search_1_7;
        slice1shift_search_1_9 <= slice1shift_search_1_8;
        slice1shift_search_1_10 <= slice1shift_search_1_9;
        slice1shift_search_1_11 <= slice1shift_search_1_10;
        slice1shift_search_1_12 <= slice1shift_search_1_11;
        slice1shift_search_1_13 <= slice1shift_search_1_12;
        slice1shift_search_1_14 <= slice1shift_search_1_13;
        slice1shift_search_1_15 <= slice1shift_search_1_14;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_search_out_0 <= slice1shift_search_0_15;
      slice1shift_search_out_1 <= slice1shift_search_1_15;
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
      slice1cost_pixels_first_0_0_count_6_value_2 := ((slice1shift_reference_0 / 1048576) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_6_value_3 := ((slice1shift_reference_0 / 524288) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_7_value := ((slice1shift_reference_0 / 2097152) mod 2) = 1;
      slice1cost_pixels_first_0_0_count_7_value_2 := ((slice1shift_reference_0 / 4194304) mod 2) = 1;
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
      slice1cost_pixels_first_1_0_count_6_value_2 := ((slice1shift_reference_1 / 1048576) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_6_value_3 := ((slice1shift_reference_1 / 524288) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_7_value := ((slice1shift_reference_1 / 2097152) mod 2) = 1;
      slice1cost_pixels_first_1_0_count_7_value_2 := ((slice1shift_reference_1 / 4194304) mod 2) = 1;
      if slice0cost_tag_first_group then
        slice1cost_column_0_0_choice := 0;
      else
        slice1cost_column_0_0_choice := to_integer(slice1cost_ready_words_0(7 downto 0));
      end if;
      slice1cost_column_0_0_value := (slice1cost_change_0_0 + slice1cost_column_0_0_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_1_choice := 0;
      else
        slice1cost_column_0_1_choice := to_integer(slice1cost_ready_words_0(15 downto 8));
      end if;
      slice1cost_column_0_1_value := (slice1cost_change_0_1 + slice1cost_column_0_1_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_2_choice := 0;
      else
        slice1cost_column_0_2_choice := to_integer(slice1cost_ready_words_0(23 downto 16));
      end if;
      slice1cost_column_0_2_value := (slice1cost_change_0_2 + slice1cost_column_0_2_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_3_choice := 0;
      else
        slice1cost_column_0_3_choice := to_integer(slice1cost_ready_words_0(31 downto 24));
      end if;
      slice1cost_column_0_3_value := (slice1cost_change_0_3 + slice1cost_column_0_3_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_4_choice := 0;
      else
        slice1cost_column_0_4_choice := to_integer(slice1cost_ready_words_1(7 downto 0));
      end if;
      slice1cost_column_0_4_value := (slice1cost_change_0_4 + slice1cost_column_0_4_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_5_choice := 0;
      else
        slice1cost_column_0_5_choice := to_integer(slice1cost_ready_words_1(15 downto 8));
      end if;
      slice1cost_column_0_5_value := (slice1cost_change_0_5 + slice1cost_column_0_5_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_6_choice := 0;
      else
        slice1cost_column_0_6_choice := to_integer(slice1cost_ready_words_1(23 downto 16));
      end if;
      slice1cost_column_0_6_value := (slice1cost_change_0_6 + slice1cost_column_0_6_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_7_choice := 0;
      else
        slice1cost_column_0_7_choice := to_integer(slice1cost_ready_words_1(31 downto 24));
      end if;
      slice1cost_column_0_7_value := (slice1cost_change_0_7 + slice1cost_column_0_7_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_8_choice := 0;
      else
        slice1cost_column_0_8_choice := to_integer(slice1cost_ready_words_2(7 downto 0));
      end if;
      slice1cost_column_0_8_value := (slice1cost_change_0_8 + slice1cost_column_0_8_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_9_choice := 0;
      else
        slice1cost_column_0_9_choice := to_integer(slice1cost_ready_words_2(15 downto 8));
      end if;
      slice1cost_column_0_9_value := (slice1cost_change_0_9 + slice1cost_column_0_9_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_10_choice := 0;
      else
        slice1cost_column_0_10_choice := to_integer(slice1cost_ready_words_2(23 downto 16));
      end if;
      slice1cost_column_0_10_value := (slice1cost_change_0_10 + slice1cost_column_0_10_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_11_choice := 0;
      else
        slice1cost_column_0_11_choice := to_integer(slice1cost_ready_words_2(31 downto 24));
      end if;
      slice1cost_column_0_11_value := (slice1cost_change_0_11 + slice1cost_column_0_11_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_12_choice := 0;
      else
        slice1cost_column_0_12_choice := to_integer(slice1cost_ready_words_3(7 downto 0));
      end if;
      slice1cost_column_0_12_value := (slice1cost_change_0_12 + slice1cost_column_0_12_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_13_choice := 0;
      else
        slice1cost_column_0_13_choice := to_integer(slice1cost_ready_words_3(15 downto 8));
      end if;
      slice1cost_column_0_13_value := (slice1cost_change_0_13 + slice1cost_column_0_13_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_14_choice := 0;
      else
        slice1cost_column_0_14_choice := to_integer(slice1cost_ready_words_3(23 downto 16));
      end if;
      slice1cost_column_0_14_value := (slice1cost_change_0_14 + slice1cost_column_0_14_choice) mod 256;
      if slice0cost_tag_first_group then
        slice1cost_column_0_15_choice := 0;
      else
        slice1cost_column_0_15_choice := to_integer(slice1cost_ready_words_3(31 downto 24));
      end if;
      slice1cost_column_0_15_value := (slice1cost_change_0_15 + slice1cost_column_0_15_choice) mod 256;
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
      slice1cost_pixels_first_0_0_count_6 <= as_number((slice1cost_pixels_first_0_0_count_6_value /=
        (((slice1shift_search_0_0 / 262144) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_6_value_2 /=
        (((slice1shift_search_0_0 / 1048576) mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_count_6_value_3 /=
        (((slice1shift_search_0_0 / 524288) mod 2) = 1)));
      slice1cost_pixels_first_0_0_count_7 <= as_number((slice1cost_pixels_first_0_0_count_7_value /=
        (((slice1shift_search_0_0 / 2097152) mod 2) = 1))) + as_number((((slice1shift_reference_0 / 8388608) = 1) /=
        ((slice1shift_search_0_0 / 8388608) = 1))) + as_number((slice1cost_pixels_first_0_0_count_7_value_2 /=
        (((slice1shift_search_0_0 / 4194304) mod 2) = 1)));
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
      slice1cost_pixels_first_0_1_count_6 <= as_number(((((slice1shift_search_0_1 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_1 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_1 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_1_count_7 <= as_number(((((slice1shift_search_0_1 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_1 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_1 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
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
      slice1cost_pixels_first_0_2_count_6 <= as_number(((((slice1shift_search_0_2 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_2 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_2 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_2_count_7 <= as_number(((((slice1shift_search_0_2 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_2 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_2 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
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
      slice1cost_pixels_first_0_3_count_4 <= as_number(((((slice1shift_search_0_3 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_3 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_3 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_3_count_5 <= as_number(((((slice1shift_search_0_3 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_3 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_3 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_3_count_6 <= as_number(((((slice1shift_search_0_3 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_3 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_3 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_3_count_7 <= as_number(((((slice1shift_search_0_3 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_3 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_3 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
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
      slice1cost_pixels_first_0_4_count_4 <= as_number(((((slice1shift_search_0_4 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_4 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_4 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_4_count_5 <= as_number(((((slice1shift_search_0_4 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_4 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_4 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_4_count_6 <= as_number(((((slice1shift_search_0_4 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_4 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_4 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_4_count_7 <= as_number(((((slice1shift_search_0_4 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_4 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_4 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_5_count_0 <= as_number((((slice1shift_search_0_5 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_5 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_5 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_5_count_1 <= as_number(((((slice1shift_search_0_5 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_5 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_5 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_5_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_5 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_5 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_5 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_5_count_3 <= as_number(((((slice1shift_search_0_5 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_5 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_5 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_5_count_4 <= as_number(((((slice1shift_search_0_5 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_5 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_5 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_5_count_5 <= as_number(((((slice1shift_search_0_5 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_5 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_5 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_5_count_6 <= as_number(((((slice1shift_search_0_5 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_5 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_5 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_5_count_7 <= as_number(((((slice1shift_search_0_5 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_5 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_5 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_6_count_0 <= as_number((((slice1shift_search_0_6 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_6 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_6 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_6_count_1 <= as_number(((((slice1shift_search_0_6 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_6 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_6 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_6_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_6 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_6 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_6 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_6_count_3 <= as_number(((((slice1shift_search_0_6 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_6 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_6 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_6_count_4 <= as_number(((((slice1shift_search_0_6 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_6 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_6 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_6_count_5 <= as_number(((((slice1shift_search_0_6 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_6 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_6 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_6_count_6 <= as_number(((((slice1shift_search_0_6 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_6 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_6 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_6_count_7 <= as_number(((((slice1shift_search_0_6 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_6 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_6 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_7_count_0 <= as_number((((slice1shift_search_0_7 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_7 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_7 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_7_count_1 <= as_number(((((slice1shift_search_0_7 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_7 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_7 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_7_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_7 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_7 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_7 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_7_count_3 <= as_number(((((slice1shift_search_0_7 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_7 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_7 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_7_count_4 <= as_number(((((slice1shift_search_0_7 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_7 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_7 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_7_count_5 <= as_number(((((slice1shift_search_0_7 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_7 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_7 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_7_count_6 <= as_number(((((slice1shift_search_0_7 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_7 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_7 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_7_count_7 <= as_number(((((slice1shift_search_0_7 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_7 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_7 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_8_count_0 <= as_number((((slice1shift_search_0_8 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_8 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_8 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_8_count_1 <= as_number(((((slice1shift_search_0_8 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_8 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_8 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_8_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_8 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_8 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_8 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_8_count_3 <= as_number(((((slice1shift_search_0_8 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_8 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_8 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_8_count_4 <= as_number(((((slice1shift_search_0_8 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_8 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_8 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_8_count_5 <= as_number(((((slice1shift_search_0_8 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_8 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_8 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_8_count_6 <= as_number(((((slice1shift_search_0_8 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_8 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_8 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_8_count_7 <= as_number(((((slice1shift_search_0_8 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_8 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_8 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_9_count_0 <= as_number((((slice1shift_search_0_9 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_9 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_9 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_9_count_1 <= as_number(((((slice1shift_search_0_9 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_9 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_9 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_9_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_9 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_9 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_9 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_9_count_3 <= as_number(((((slice1shift_search_0_9 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_9 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_9 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_9_count_4 <= as_number(((((slice1shift_search_0_9 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_9 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_9 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_9_count_5 <= as_number(((((slice1shift_search_0_9 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_9 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_9 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_9_count_6 <= as_number(((((slice1shift_search_0_9 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_9 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_9 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_9_count_7 <= as_number(((((slice1shift_search_0_9 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_9 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_9 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_10_count_0 <= as_number((((slice1shift_search_0_10 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_10 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_10 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_10_count_1 <= as_number(((((slice1shift_search_0_10 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_10 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_10 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_10_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_10 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_10 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_10 / 64) mod 2) =
        1) /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_10_count_3 <= as_number(((((slice1shift_search_0_10 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_10 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_10 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_10_count_4 <= as_number(((((slice1shift_search_0_10 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_10 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_10 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_10_count_5 <= as_number(((((slice1shift_search_0_10 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_10 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_10 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_10_count_6 <= as_number(((((slice1shift_search_0_10 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_10 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_10 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_10_count_7 <= as_number(((((slice1shift_search_0_10 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_10 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_10 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_11_count_0 <= as_number((((slice1shift_search_0_11 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_11 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_11 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_11_count_1 <= as_number(((((slice1shift_search_0_11 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_11 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_11 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_11_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_11 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_11 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_11 / 64) mod 2) =
        1) /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_11_count_3 <= as_number(((((slice1shift_search_0_11 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_11 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_11 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_11_count_4 <= as_number(((((slice1shift_search_0_11 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_11 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_11 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_11_count_5 <= as_number(((((slice1shift_search_0_11 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_11 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_11 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_11_count_6 <= as_number(((((slice1shift_search_0_11 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_11 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_11 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_11_count_7 <= as_number(((((slice1shift_search_0_11 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_11 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_11 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_12_count_0 <= as_number((((slice1shift_search_0_12 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_12 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_12 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_12_count_1 <= as_number(((((slice1shift_search_0_12 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_12 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_12 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_12_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_12 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_12 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_12 / 64) mod 2) =
        1) /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_12_count_3 <= as_number(((((slice1shift_search_0_12 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_12 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_12 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_12_count_4 <= as_number(((((slice1shift_search_0_12 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_12 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_12 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_12_count_5 <= as_number(((((slice1shift_search_0_12 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_12 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_12 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_12_count_6 <= as_number(((((slice1shift_search_0_12 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_12 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_12 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_12_count_7 <= as_number(((((slice1shift_search_0_12 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_12 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_12 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_13_count_0 <= as_number((((slice1shift_search_0_13 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_13 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_13 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_13_count_1 <= as_number(((((slice1shift_search_0_13 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_13 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_13 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_13_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_13 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_13 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_13 / 64) mod 2) =
        1) /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_13_count_3 <= as_number(((((slice1shift_search_0_13 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_13 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_13 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_13_count_4 <= as_number(((((slice1shift_search_0_13 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_13 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_13 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_13_count_5 <= as_number(((((slice1shift_search_0_13 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_13 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_13 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_13_count_6 <= as_number(((((slice1shift_search_0_13 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_13 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_13 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_13_count_7 <= as_number(((((slice1shift_search_0_13 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_13 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_13 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_14_count_0 <= as_number((((slice1shift_search_0_14 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_14 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_14 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_14_count_1 <= as_number(((((slice1shift_search_0_14 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_14 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_14 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_14_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_14 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_14 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_14 / 64) mod 2) =
        1) /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_14_count_3 <= as_number(((((slice1shift_search_0_14 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_14 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_14 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_14_count_4 <= as_number(((((slice1shift_search_0_14 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_14 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_14 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_14_count_5 <= as_number(((((slice1shift_search_0_14 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_14 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_14 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_14_count_6 <= as_number(((((slice1shift_search_0_14 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_14 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_14 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_14_count_7 <= as_number(((((slice1shift_search_0_14 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_14 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_14 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
      slice1cost_pixels_first_0_15_count_0 <= as_number((((slice1shift_search_0_15 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_15 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value)) + as_number(((((slice1shift_search_0_15 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_0_value_2));
      slice1cost_pixels_first_0_15_count_1 <= as_number(((((slice1shift_search_0_15 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value)) + as_number(((((slice1shift_search_0_15 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice1shift_search_0_15 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_1_value_3));
      slice1cost_pixels_first_0_15_count_2 <= (to_integer(((to_unsigned((slice1shift_search_0_15 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_0_15 / 256) mod
        2) = 1) /= slice1cost_pixels_first_0_0_count_2_value)) + as_number(((((slice1shift_search_0_15 / 64) mod 2) =
        1) /= slice1cost_pixels_first_0_0_count_2_value_2));
      slice1cost_pixels_first_0_15_count_3 <= as_number(((((slice1shift_search_0_15 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value)) + as_number(((((slice1shift_search_0_15 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice1shift_search_0_15 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_3_value_3));
      slice1cost_pixels_first_0_15_count_4 <= as_number(((((slice1shift_search_0_15 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value)) + as_number(((((slice1shift_search_0_15 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice1shift_search_0_15 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_4_value_3));
      slice1cost_pixels_first_0_15_count_5 <= as_number(((((slice1shift_search_0_15 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value)) + as_number(((((slice1shift_search_0_15 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice1shift_search_0_15 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_5_value_3));
      slice1cost_pixels_first_0_15_count_6 <= as_number(((((slice1shift_search_0_15 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value)) + as_number(((((slice1shift_search_0_15 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice1shift_search_0_15 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_6_value_3));
      slice1cost_pixels_first_0_15_count_7 <= as_number(((((slice1shift_search_0_15 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value)) + as_number((((slice1shift_search_0_15 / 8388608) = 1) /=
        ((slice1shift_reference_0 / 8388608) = 1))) + as_number(((((slice1shift_search_0_15 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_count_7_value_2));
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
      slice1cost_pixels_first_1_0_count_6 <= as_number((slice1cost_pixels_first_1_0_count_6_value /=
        (((slice1shift_search_1_0 / 262144) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_6_value_2 /=
        (((slice1shift_search_1_0 / 1048576) mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_count_6_value_3 /=
        (((slice1shift_search_1_0 / 524288) mod 2) = 1)));
      slice1cost_pixels_first_1_0_count_7 <= as_number((slice1cost_pixels_first_1_0_count_7_value /=
        (((slice1shift_search_1_0 / 2097152) mod 2) = 1))) + as_number((((slice1shift_reference_1 / 8388608) = 1) /=
        ((slice1shift_search_1_0 / 8388608) = 1))) + as_number((slice1cost_pixels_first_1_0_count_7_value_2 /=
        (((slice1shift_search_1_0 / 4194304) mod 2) = 1)));
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
      slice1cost_pixels_first_1_1_count_6 <= as_number(((((slice1shift_search_1_1 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_1 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_1 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_1_count_7 <= as_number(((((slice1shift_search_1_1 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_1 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_1 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
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
      slice1cost_pixels_first_1_2_count_6 <= as_number(((((slice1shift_search_1_2 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_2 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_2 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_2_count_7 <= as_number(((((slice1shift_search_1_2 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_2 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_2 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
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
      slice1cost_pixels_first_1_3_count_4 <= as_number(((((slice1shift_search_1_3 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_3 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_3 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_3_count_5 <= as_number(((((slice1shift_search_1_3 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_3 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_3 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_3_count_6 <= as_number(((((slice1shift_search_1_3 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_3 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_3 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_3_count_7 <= as_number(((((slice1shift_search_1_3 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_3 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_3 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
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
      slice1cost_pixels_first_1_4_count_4 <= as_number(((((slice1shift_search_1_4 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_4 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_4 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_4_count_5 <= as_number(((((slice1shift_search_1_4 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_4 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_4 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_4_count_6 <= as_number(((((slice1shift_search_1_4 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_4 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_4 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_4_count_7 <= as_number(((((slice1shift_search_1_4 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_4 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_4 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_5_count_0 <= as_number((((slice1shift_search_1_5 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_5 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_5 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_5_count_1 <= as_number(((((slice1shift_search_1_5 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_5 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_5 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_5_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_5 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_5 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_5 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_5_count_3 <= as_number(((((slice1shift_search_1_5 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_5 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_5 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_5_count_4 <= as_number(((((slice1shift_search_1_5 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_5 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_5 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_5_count_5 <= as_number(((((slice1shift_search_1_5 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_5 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_5 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_5_count_6 <= as_number(((((slice1shift_search_1_5 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_5 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_5 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_5_count_7 <= as_number(((((slice1shift_search_1_5 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_5 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_5 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_6_count_0 <= as_number((((slice1shift_search_1_6 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_6 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_6 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_6_count_1 <= as_number(((((slice1shift_search_1_6 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_6 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_6 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_6_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_6 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_6 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_6 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_6_count_3 <= as_number(((((slice1shift_search_1_6 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_6 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_6 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_6_count_4 <= as_number(((((slice1shift_search_1_6 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_6 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_6 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_6_count_5 <= as_number(((((slice1shift_search_1_6 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_6 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_6 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_6_count_6 <= as_number(((((slice1shift_search_1_6 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_6 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_6 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_6_count_7 <= as_number(((((slice1shift_search_1_6 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_6 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_6 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_7_count_0 <= as_number((((slice1shift_search_1_7 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_7 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_7 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_7_count_1 <= as_number(((((slice1shift_search_1_7 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_7 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_7 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_7_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_7 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_7 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_7 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_7_count_3 <= as_number(((((slice1shift_search_1_7 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_7 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_7 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_7_count_4 <= as_number(((((slice1shift_search_1_7 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_7 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_7 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_7_count_5 <= as_number(((((slice1shift_search_1_7 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_7 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_7 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_7_count_6 <= as_number(((((slice1shift_search_1_7 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_7 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_7 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_7_count_7 <= as_number(((((slice1shift_search_1_7 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_7 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_7 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_8_count_0 <= as_number((((slice1shift_search_1_8 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_8 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_8 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_8_count_1 <= as_number(((((slice1shift_search_1_8 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_8 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_8 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_8_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_8 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_8 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_8 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_8_count_3 <= as_number(((((slice1shift_search_1_8 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_8 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_8 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_8_count_4 <= as_number(((((slice1shift_search_1_8 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_8 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_8 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_8_count_5 <= as_number(((((slice1shift_search_1_8 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_8 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_8 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_8_count_6 <= as_number(((((slice1shift_search_1_8 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_8 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_8 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_8_count_7 <= as_number(((((slice1shift_search_1_8 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_8 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_8 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_9_count_0 <= as_number((((slice1shift_search_1_9 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_9 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_9 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_9_count_1 <= as_number(((((slice1shift_search_1_9 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_9 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_9 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_9_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_9 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_9 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_9 / 64) mod 2) = 1)
        /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_9_count_3 <= as_number(((((slice1shift_search_1_9 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_9 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_9 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_9_count_4 <= as_number(((((slice1shift_search_1_9 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_9 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_9 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_9_count_5 <= as_number(((((slice1shift_search_1_9 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_9 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_9 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_9_count_6 <= as_number(((((slice1shift_search_1_9 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_9 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_9 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_9_count_7 <= as_number(((((slice1shift_search_1_9 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_9 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_9 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_10_count_0 <= as_number((((slice1shift_search_1_10 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_10 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_10 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_10_count_1 <= as_number(((((slice1shift_search_1_10 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_10 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_10 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_10_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_10 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_10 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_10 / 64) mod 2) =
        1) /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_10_count_3 <= as_number(((((slice1shift_search_1_10 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_10 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_10 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_10_count_4 <= as_number(((((slice1shift_search_1_10 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_10 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_10 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_10_count_5 <= as_number(((((slice1shift_search_1_10 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_10 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_10 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_10_count_6 <= as_number(((((slice1shift_search_1_10 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_10 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_10 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_10_count_7 <= as_number(((((slice1shift_search_1_10 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_10 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_10 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_11_count_0 <= as_number((((slice1shift_search_1_11 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_11 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_11 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_11_count_1 <= as_number(((((slice1shift_search_1_11 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_11 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_11 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_11_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_11 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_11 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_11 / 64) mod 2) =
        1) /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_11_count_3 <= as_number(((((slice1shift_search_1_11 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_11 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_11 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_11_count_4 <= as_number(((((slice1shift_search_1_11 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_11 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_11 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_11_count_5 <= as_number(((((slice1shift_search_1_11 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_11 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_11 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_11_count_6 <= as_number(((((slice1shift_search_1_11 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_11 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_11 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_11_count_7 <= as_number(((((slice1shift_search_1_11 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_11 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_11 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_12_count_0 <= as_number((((slice1shift_search_1_12 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_12 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_12 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_12_count_1 <= as_number(((((slice1shift_search_1_12 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_12 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_12 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_12_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_12 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_12 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_12 / 64) mod 2) =
        1) /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_12_count_3 <= as_number(((((slice1shift_search_1_12 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_12 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_12 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_12_count_4 <= as_number(((((slice1shift_search_1_12 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_12 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_12 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_12_count_5 <= as_number(((((slice1shift_search_1_12 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_12 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_12 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_12_count_6 <= as_number(((((slice1shift_search_1_12 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_12 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_12 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_12_count_7 <= as_number(((((slice1shift_search_1_12 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_12 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_12 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_13_count_0 <= as_number((((slice1shift_search_1_13 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_13 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_13 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_13_count_1 <= as_number(((((slice1shift_search_1_13 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_13 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_13 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_13_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_13 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_13 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_13 / 64) mod 2) =
        1) /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_13_count_3 <= as_number(((((slice1shift_search_1_13 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_13 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_13 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_13_count_4 <= as_number(((((slice1shift_search_1_13 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_13 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_13 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_13_count_5 <= as_number(((((slice1shift_search_1_13 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_13 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_13 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_13_count_6 <= as_number(((((slice1shift_search_1_13 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_13 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_13 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_13_count_7 <= as_number(((((slice1shift_search_1_13 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_13 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_13 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_14_count_0 <= as_number((((slice1shift_search_1_14 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_14 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_14 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_14_count_1 <= as_number(((((slice1shift_search_1_14 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_14 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_14 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_14_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_14 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_14 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_14 / 64) mod 2) =
        1) /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_14_count_3 <= as_number(((((slice1shift_search_1_14 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_14 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_14 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_14_count_4 <= as_number(((((slice1shift_search_1_14 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_14 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_14 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_14_count_5 <= as_number(((((slice1shift_search_1_14 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_14 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_14 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_14_count_6 <= as_number(((((slice1shift_search_1_14 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_14 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_14 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_14_count_7 <= as_number(((((slice1shift_search_1_14 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_14 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_14 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_first_1_15_count_0 <= as_number((((slice1shift_search_1_15 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_15 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value)) + as_number(((((slice1shift_search_1_15 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_0_value_2));
      slice1cost_pixels_first_1_15_count_1 <= as_number(((((slice1shift_search_1_15 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value)) + as_number(((((slice1shift_search_1_15 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice1shift_search_1_15 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_1_value_3));
      slice1cost_pixels_first_1_15_count_2 <= (to_integer(((to_unsigned((slice1shift_search_1_15 mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice1shift_search_1_15 / 256) mod
        2) = 1) /= slice1cost_pixels_first_1_0_count_2_value)) + as_number(((((slice1shift_search_1_15 / 64) mod 2) =
        1) /= slice1cost_pixels_first_1_0_count_2_value_2));
      slice1cost_pixels_first_1_15_count_3 <= as_number(((((slice1shift_search_1_15 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value)) + as_number(((((slice1shift_search_1_15 / 2048) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice1shift_search_1_15 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_3_value_3));
      slice1cost_pixels_first_1_15_count_4 <= as_number(((((slice1shift_search_1_15 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value)) + as_number(((((slice1shift_search_1_15 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice1shift_search_1_15 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_4_value_3));
      slice1cost_pixels_first_1_15_count_5 <= as_number(((((slice1shift_search_1_15 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value)) + as_number(((((slice1shift_search_1_15 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice1shift_search_1_15 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_5_value_3));
      slice1cost_pixels_first_1_15_count_6 <= as_number(((((slice1shift_search_1_15 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value)) + as_number(((((slice1shift_search_1_15 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice1shift_search_1_15 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_6_value_3));
      slice1cost_pixels_first_1_15_count_7 <= as_number(((((slice1shift_search_1_15 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value)) + as_number((((slice1shift_search_1_15 / 8388608) = 1) /=
        ((slice1shift_reference_1 / 8388608) = 1))) + as_number(((((slice1shift_search_1_15 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_count_7_value_2));
      slice1cost_pixels_cost_0_0 <= slice1cost_pixels_first_0_0_count_0 + slice1cost_pixels_first_0_0_count_2 +
        slice1cost_pixels_first_0_0_count_3 + slice1cost_pixels_first_0_0_count_5 + slice1cost_pixels_first_0_0_count_6
        + slice1cost_pixels_first_0_0_count_4 + slice1cost_pixels_first_0_0_count_7 +
        slice1cost_pixels_first_0_0_count_1;
      slice1cost_pixels_cost_0_1 <= slice1cost_pixels_first_0_1_count_0 + slice1cost_pixels_first_0_1_count_2 +
        slice1cost_pixels_first_0_1_count_3 + slice1cost_pixels_first_0_1_count_5 + slice1cost_pixels_first_0_1_count_6
        + slice1cost_pixels_first_0_1_count_4 + slice1cost_pixels_first_0_1_count_7 +
        slice1cost_pixels_first_0_1_count_1;
      slice1cost_pixels_cost_0_2 <= slice1cost_pixels_first_0_2_count_0 + slice1cost_pixels_first_0_2_count_2 +
        slice1cost_pixels_first_0_2_count_3 + slice1cost_pixels_first_0_2_count_5 + slice1cost_pixels_first_0_2_count_6
        + slice1cost_pixels_first_0_2_count_4 + slice1cost_pixels_first_0_2_count_7 +
        slice1cost_pixels_first_0_2_count_1;
      slice1cost_pixels_cost_0_3 <= slice1cost_pixels_first_0_3_count_0 + slice1cost_pixels_first_0_3_count_2 +
        slice1cost_pixels_first_0_3_count_3 + slice1cost_pixels_first_0_3_count_5 + slice1cost_pixels_first_0_3_count_6
        + slice1cost_pixels_first_0_3_count_4 + slice1cost_pixels_first_0_3_count_7 +
        slice1cost_pixels_first_0_3_count_1;
      slice1cost_pixels_cost_0_4 <= slice1cost_pixels_first_0_4_count_0 + slice1cost_pixels_first_0_4_count_2 +
        slice1cost_pixels_first_0_4_count_3 + slice1cost_pixels_first_0_4_count_5 + slice1cost_pixels_first_0_4_count_6
        + slice1cost_pixels_first_0_4_count_4 + slice1cost_pixels_first_0_4_count_7 +
        slice1cost_pixels_first_0_4_count_1;
      slice1cost_pixels_cost_0_5 <= slice1cost_pixels_first_0_5_count_0 + slice1cost_pixels_first_0_5_count_2 +
        slice1cost_pixels_first_0_5_count_3 + slice1cost_pixels_first_0_5_count_5 + slice1cost_pixels_first_0_5_count_6
        + slice1cost_pixels_first_0_5_count_4 + slice1cost_pixels_first_0_5_count_7 +
        slice1cost_pixels_first_0_5_count_1;
      slice1cost_pixels_cost_0_6 <= slice1cost_pixels_first_0_6_count_0 + slice1cost_pixels_first_0_6_count_2 +
        slice1cost_pixels_first_0_6_count_3 + slice1cost_pixels_first_0_6_count_5 + slice1cost_pixels_first_0_6_count_6
        + slice1cost_pixels_first_0_6_count_4 + slice1cost_pixels_first_0_6_count_7 +
        slice1cost_pixels_first_0_6_count_1;
      slice1cost_pixels_cost_0_7 <= slice1cost_pixels_first_0_7_count_0 + slice1cost_pixels_first_0_7_count_2 +
        slice1cost_pixels_first_0_7_count_3 + slice1cost_pixels_first_0_7_count_5 + slice1cost_pixels_first_0_7_count_6
        + slice1cost_pixels_first_0_7_count_4 + slice1cost_pixels_first_0_7_count_7 +
        slice1cost_pixels_first_0_7_count_1;
      slice1cost_pixels_cost_0_8 <= slice1cost_pixels_first_0_8_count_0 + slice1cost_pixels_first_0_8_count_2 +
        slice1cost_pixels_first_0_8_count_3 + slice1cost_pixels_first_0_8_count_5 + slice1cost_pixels_first_0_8_count_6
        + slice1cost_pixels_first_0_8_count_4 + slice1cost_pixels_first_0_8_count_7 +
        slice1cost_pixels_first_0_8_count_1;
      slice1cost_pixels_cost_0_9 <= slice1cost_pixels_first_0_9_count_0 + slice1cost_pixels_first_0_9_count_2 +
        slice1cost_pixels_first_0_9_count_3 + slice1cost_pixels_first_0_9_count_5 + slice1cost_pixels_first_0_9_count_6
        + slice1cost_pixels_first_0_9_count_4 + slice1cost_pixels_first_0_9_count_7 +
        slice1cost_pixels_first_0_9_count_1;
      slice1cost_pixels_cost_0_10 <= slice1cost_pixels_first_0_10_count_0 + slice1cost_pixels_first_0_10_count_2 +
        slice1cost_pixels_first_0_10_count_3 + slice1cost_pixels_first_0_10_count_5 +
        slice1cost_pixels_first_0_10_count_6 + slice1cost_pixels_first_0_10_count_4 +
        slice1cost_pixels_first_0_10_count_7 + slice1cost_pixels_first_0_10_count_1;
      slice1cost_pixels_cost_0_11 <= slice1cost_pixels_first_0_11_count_0 + slice1cost_pixels_first_0_11_count_2 +
        slice1cost_pixels_first_0_11_count_3 + slice1cost_pixels_first_0_11_count_5 +
        slice1cost_pixels_first_0_11_count_6 + slice1cost_pixels_first_0_11_count_4 +
        slice1cost_pixels_first_0_11_count_7 + slice1cost_pixels_first_0_11_count_1;
      slice1cost_pixels_cost_0_12 <= slice1cost_pixels_first_0_12_count_0 + slice1cost_pixels_first_0_12_count_2 +
        slice1cost_pixels_first_0_12_count_3 + slice1cost_pixels_first_0_12_count_5 +
        slice1cost_pixels_first_0_12_count_6 + slice1cost_pixels_first_0_12_count_4 +
        slice1cost_pixels_first_0_12_count_7 + slice1cost_pixels_first_0_12_count_1;
      slice1cost_pixels_cost_0_13 <= slice1cost_pixels_first_0_13_count_0 + slice1cost_pixels_first_0_13_count_2 +
        slice1cost_pixels_first_0_13_count_3 + slice1cost_pixels_first_0_13_count_5 +
        slice1cost_pixels_first_0_13_count_6 + slice1cost_pixels_first_0_13_count_4 +
        slice1cost_pixels_first_0_13_count_7 + slice1cost_pixels_first_0_13_count_1;
      slice1cost_pixels_cost_0_14 <= slice1cost_pixels_first_0_14_count_0 + slice1cost_pixels_first_0_14_count_2 +
        slice1cost_pixels_first_0_14_count_3 + slice1cost_pixels_first_0_14_count_5 +
        slice1cost_pixels_first_0_14_count_6 + slice1cost_pixels_first_0_14_count_4 +
        slice1cost_pixels_first_0_14_count_7 + slice1cost_pixels_first_0_14_count_1;
      slice1cost_pixels_cost_0_15 <= slice1cost_pixels_first_0_15_count_0 + slice1cost_pixels_first_0_15_count_2 +
        slice1cost_pixels_first_0_15_count_3 + slice1cost_pixels_first_0_15_count_5 +
        slice1cost_pixels_first_0_15_count_6 + slice1cost_pixels_first_0_15_count_4 +
        slice1cost_pixels_first_0_15_count_7 + slice1cost_pixels_first_0_15_count_1;
      slice1cost_pixels_cost_1_0 <= slice1cost_pixels_first_1_0_count_0 + slice1cost_pixels_first_1_0_count_2 +
        slice1cost_pixels_first_1_0_count_3 + slice1cost_pixels_first_1_0_count_5 + slice1cost_pixels_first_1_0_count_6
        + slice1cost_pixels_first_1_0_count_4 + slice1cost_pixels_first_1_0_count_7 +
        slice1cost_pixels_first_1_0_count_1;
      slice1cost_pixels_cost_1_1 <= slice1cost_pixels_first_1_1_count_0 + slice1cost_pixels_first_1_1_count_2 +
        slice1cost_pixels_first_1_1_count_3 + slice1cost_pixels_first_1_1_count_5 + slice1cost_pixels_first_1_1_count_6
        + slice1cost_pixels_first_1_1_count_4 + slice1cost_pixels_first_1_1_count_7 +
        slice1cost_pixels_first_1_1_count_1;
      slice1cost_pixels_cost_1_2 <= slice1cost_pixels_first_1_2_count_0 + slice1cost_pixels_first_1_2_count_2 +
        slice1cost_pixels_first_1_2_count_3 + slice1cost_pixels_first_1_2_count_5 + slice1cost_pixels_first_1_2_count_6
        + slice1cost_pixels_first_1_2_count_4 + slice1cost_pixels_first_1_2_count_7 +
        slice1cost_pixels_first_1_2_count_1;
      slice1cost_pixels_cost_1_3 <= slice1cost_pixels_first_1_3_count_0 + slice1cost_pixels_first_1_3_count_2 +
        slice1cost_pixels_first_1_3_count_3 + slice1cost_pixels_first_1_3_count_5 + slice1cost_pixels_first_1_3_count_6
        + slice1cost_pixels_first_1_3_count_4 + slice1cost_pixels_first_1_3_count_7 +
        slice1cost_pixels_first_1_3_count_1;
      slice1cost_pixels_cost_1_4 <= slice1cost_pixels_first_1_4_count_0 + slice1cost_pixels_first_1_4_count_2 +
        slice1cost_pixels_first_1_4_count_3 + slice1cost_pixels_first_1_4_count_5 + slice1cost_pixels_first_1_4_count_6
        + slice1cost_pixels_first_1_4_count_4 + slice1cost_pixels_first_1_4_count_7 +
        slice1cost_pixels_first_1_4_count_1;
      slice1cost_pixels_cost_1_5 <= slice1cost_pixels_first_1_5_count_0 + slice1cost_pixels_first_1_5_count_2 +
        slice1cost_pixels_first_1_5_count_3 + slice1cost_pixels_first_1_5_count_5 + slice1cost_pixels_first_1_5_count_6
        + slice1cost_pixels_first_1_5_count_4 + slice1cost_pixels_first_1_5_count_7 +
        slice1cost_pixels_first_1_5_count_1;
      slice1cost_pixels_cost_1_6 <= slice1cost_pixels_first_1_6_count_0 + slice1cost_pixels_first_1_6_count_2 +
        slice1cost_pixels_first_1_6_count_3 + slice1cost_pixels_first_1_6_count_5 + slice1cost_pixels_first_1_6_count_6
        + slice1cost_pixels_first_1_6_count_4 + slice1cost_pixels_first_1_6_count_7 +
        slice1cost_pixels_first_1_6_count_1;
      slice1cost_pixels_cost_1_7 <= slice1cost_pixels_first_1_7_count_0 + slice1cost_pixels_first_1_7_count_2 +
        slice1cost_pixels_first_1_7_count_3 + slice1cost_pixels_first_1_7_count_5 + slice1cost_pixels_first_1_7_count_6
        + slice1cost_pixels_first_1_7_count_4 + slice1cost_pixels_first_1_7_count_7 +
        slice1cost_pixels_first_1_7_count_1;
      slice1cost_pixels_cost_1_8 <= slice1cost_pixels_first_1_8_count_0 + slice1cost_pixels_first_1_8_count_2 +
        slice1cost_pixels_first_1_8_count_3 + slice1cost_pixels_first_1_8_count_5 + slice1cost_pixels_first_1_8_count_6
        + slice1cost_pixels_first_1_8_count_4 + slice1cost_pixels_first_1_8_count_7 +
        slice1cost_pixels_first_1_8_count_1;
      slice1cost_pixels_cost_1_9 <= slice1cost_pixels_first_1_9_count_0 + slice1cost_pixels_first_1_9_count_2 +
        slice1cost_pixels_first_1_9_count_3 + slice1cost_pixels_first_1_9_count_5 + slice1cost_pixels_first_1_9_count_6
        + slice1cost_pixels_first_1_9_count_4 + slice1cost_pixels_first_1_9_count_7 +
        slice1cost_pixels_first_1_9_count_1;
      slice1cost_pixels_cost_1_10 <= slice1cost_pixels_first_1_10_count_0 + slice1cost_pixels_first_1_10_count_2 +
        slice1cost_pixels_first_1_10_count_3 + slice1cost_pixels_first_1_10_count_5 +
        slice1cost_pixels_first_1_10_count_6 + slice1cost_pixels_first_1_10_count_4 +
        slice1cost_pixels_first_1_10_count_7 + slice1cost_pixels_first_1_10_count_1;
      slice1cost_pixels_cost_1_11 <= slice1cost_pixels_first_1_11_count_0 + slice1cost_pixels_first_1_11_count_2 +
        slice1cost_pixels_first_1_11_count_3 + slice1cost_pixels_first_1_11_count_5 +
        slice1cost_pixels_first_1_11_count_6 + slice1cost_pixels_first_1_11_count_4 +
        slice1cost_pixels_first_1_11_count_7 + slice1cost_pixels_first_1_11_count_1;
      slice1cost_pixels_cost_1_12 <= slice1cost_pixels_first_1_12_count_0 + slice1cost_pixels_first_1_12_count_2 +
        slice1cost_pixels_first_1_12_count_3 + slice1cost_pixels_first_1_12_count_5 +
        slice1cost_pixels_first_1_12_count_6 + slice1cost_pixels_first_1_12_count_4 +
        slice1cost_pixels_first_1_12_count_7 + slice1cost_pixels_first_1_12_count_1;
      slice1cost_pixels_cost_1_13 <= slice1cost_pixels_first_1_13_count_0 + slice1cost_pixels_first_1_13_count_2 +
        slice1cost_pixels_first_1_13_count_3 + slice1cost_pixels_first_1_13_count_5 +
        slice1cost_pixels_first_1_13_count_6 + slice1cost_pixels_first_1_13_count_4 +
        slice1cost_pixels_first_1_13_count_7 + slice1cost_pixels_first_1_13_count_1;
      slice1cost_pixels_cost_1_14 <= slice1cost_pixels_first_1_14_count_0 + slice1cost_pixels_first_1_14_count_2 +
        slice1cost_pixels_first_1_14_count_3 + slice1cost_pixels_first_1_14_count_5 +
        slice1cost_pixels_first_1_14_count_6 + slice1cost_pixels_first_1_14_count_4 +
        slice1cost_pixels_first_1_14_count_7 + slice1cost_pixels_first_1_14_count_1;
      slice1cost_pixels_cost_1_15 <= slice1cost_pixels_first_1_15_count_0 + slice1cost_pixels_first_1_15_count_2 +
        slice1cost_pixels_first_1_15_count_3 + slice1cost_pixels_first_1_15_count_5 +
        slice1cost_pixels_first_1_15_count_6 + slice1cost_pixels_first_1_15_count_4 +
        slice1cost_pixels_first_1_15_count_7 + slice1cost_pixels_first_1_15_count_1;
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
      slice1cost_change_0_8 <= slice1cost_pixels_cost_1_8 - slice1cost_pixels_cost_0_8;
      slice1cost_change_0_9 <= slice1cost_pixels_cost_1_9 - slice1cost_pixels_cost_0_9;
      slice1cost_change_0_10 <= slice1cost_pixels_cost_1_10 - slice1cost_pixels_cost_0_10;
      slice1cost_change_0_11 <= slice1cost_pixels_cost_1_11 - slice1cost_pixels_cost_0_11;
      slice1cost_change_0_12 <= slice1cost_pixels_cost_1_12 - slice1cost_pixels_cost_0_12;
      slice1cost_change_0_13 <= slice1cost_pixels_cost_1_13 - slice1cost_pixels_cost_0_13;
      slice1cost_change_0_14 <= slice1cost_pixels_cost_1_14 - slice1cost_pixels_cost_0_14;
      slice1cost_change_0_15 <= slice1cost_pixels_cost_1_15 - slice1cost_pixels_cost_0_15;
      slice1cost_ready_words_0 <= slice1cost_read_words_0;
      slice1cost_ready_words_1 <= slice1cost_read_words_1;
      slice1cost_ready_words_2 <= slice1cost_read_words_2;
      slice1cost_ready_words_3 <= slice1cost_read_words_3;
      slice1cost_column_0_0 <= slice1cost_column_0_0_value;
      slice1cost_column_0_1 <= slice1cost_column_0_1_value;
      slice1cost_column_0_2 <= slice1cost_column_0_2_value;
      slice1cost_column_0_3 <= slice1cost_column_0_3_value;
      slice1cost_column_0_4 <= slice1cost_column_0_4_value;
      slice1cost_column_0_5 <= slice1cost_column_0_5_value;
      slice1cost_column_0_6 <= slice1cost_column_0_6_value;
      slice1cost_column_0_7 <= slice1cost_column_0_7_value;
      slice1cost_column_0_8 <= slice1cost_column_0_8_value;
      slice1cost_column_0_9 <= slice1cost_column_0_9_value;
      slice1cost_column_0_10 <= slice1cost_column_0_10_value;
      slice1cost_column_0_11 <= slice1cost_column_0_11_value;
      slice1cost_column_0_12 <= slice1cost_column_0_12_value;
      slice1cost_column_0_13 <= slice1cost_column_0_13_value;
      slice1cost_column_0_14 <= slice1cost_column_0_14_value;
      slice1cost_column_0_15 <= slice1cost_column_0_15_value;
      if slice0cost_ready_tag_valid then
        slice1cost_ready_column <= slice1cost_change_column;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_column <= slice0cost_write_column;
        slice1cost_write_words_0 <= to_unsigned(slice1cost_column_0_3_value, 8) &
          to_unsigned(slice1cost_column_0_2_value, 8) & to_unsigned(slice1cost_column_0_1_value, 8) &
          to_unsigned(slice1cost_column_0_0_value, 8);
        slice1cost_write_words_1 <= to_unsigned(slice1cost_column_0_7_value, 8) &
          to_unsigned(slice1cost_column_0_6_value, 8) & to_unsigned(slice1cost_column_0_5_value, 8) &
          to_unsigned(slice1cost_column_0_4_value, 8);
        slice1cost_write_words_2 <= to_unsigned(slice1cost_column_0_11_value, 8) &
          to_unsigned(slice1cost_column_0_10_value, 8) & to_unsigned(slice1cost_column_0_9_value, 8) &
          to_unsigned(slice1cost_column_0_8_value, 8);
        slice1cost_write_words_3 <= to_unsigned(slice1cost_column_0_15_value, 8) &
          to_unsigned(slice1cost_column_0_14_value, 8) & to_unsigned(slice1cost_column_0_13_value, 8) &
          to_unsigned(slice1cost_column_0_12_value, 8);
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
        slice1window_change_0_0_choice := to_integer(slice1window_leaving_0(7 downto 0));
      else
        slice1window_change_0_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_1_choice := to_integer(slice1window_leaving_0(15 downto 8));
      else
        slice1window_change_0_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_2_choice := to_integer(slice1window_leaving_0(23 downto 16));
      else
        slice1window_change_0_2_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_3_choice := to_integer(slice1window_leaving_0(31 downto 24));
      else
        slice1window_change_0_3_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_4_choice := to_integer(slice1window_leaving_1(7 downto 0));
      else
        slice1window_change_0_4_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_5_choice := to_integer(slice1window_leaving_1(15 downto 8));
      else
        slice1window_change_0_5_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_6_choice := to_integer(slice1window_leaving_1(23 downto 16));
      else
        slice1window_change_0_6_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_7_choice := to_integer(slice1window_leaving_1(31 downto 24));
      else
        slice1window_change_0_7_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_8_choice := to_integer(slice1window_leaving_2(7 downto 0));
      else
        slice1window_change_0_8_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_9_choice := to_integer(slice1window_leaving_2(15 downto 8));
      else
        slice1window_change_0_9_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_10_choice := to_integer(slice1window_leaving_2(23 downto 16));
      else
        slice1window_change_0_10_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_11_choice := to_integer(slice1window_leaving_2(31 downto 24));
      else
        slice1window_change_0_11_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_12_choice := to_integer(slice1window_leaving_3(7 downto 0));
      else
        slice1window_change_0_12_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_13_choice := to_integer(slice1window_leaving_3(15 downto 8));
      else
        slice1window_change_0_13_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_14_choice := to_integer(slice1window_leaving_3(23 downto 16));
      else
        slice1window_change_0_14_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_15_choice := to_integer(slice1window_leaving_3(31 downto 24));
      else
        slice1window_change_0_15_choice := 0;
      end if;
      slice1window_entering_0_0 <= slice1cost_column_0_0;
      slice1window_entering_0_1 <= slice1cost_column_0_1;
      slice1window_entering_0_2 <= slice1cost_column_0_2;
      slice1window_entering_0_3 <= slice1cost_column_0_3;
      slice1window_entering_0_4 <= slice1cost_column_0_4;
      slice1window_entering_0_5 <= slice1cost_column_0_5;
      slice1window_entering_0_6 <= slice1cost_column_0_6;
      slice1window_entering_0_7 <= slice1cost_column_0_7;
      slice1window_entering_0_8 <= slice1cost_column_0_8;
      slice1window_entering_0_9 <= slice1cost_column_0_9;
      slice1window_entering_0_10 <= slice1cost_column_0_10;
      slice1window_entering_0_11 <= slice1cost_column_0_11;
      slice1window_entering_0_12 <= slice1cost_column_0_12;
      slice1window_entering_0_13 <= slice1cost_column_0_13;
      slice1window_entering_0_14 <= slice1cost_column_0_14;
      slice1window_entering_0_15 <= slice1cost_column_0_15;
      slice1window_change_0_0 <= slice1window_entering_0_0 - slice1window_change_0_0_choice;
      slice1window_change_0_1 <= slice1window_entering_0_1 - slice1window_change_0_1_choice;
      slice1window_change_0_2 <= slice1window_entering_0_2 - slice1window_change_0_2_choice;
      slice1window_change_0_3 <= slice1window_entering_0_3 - slice1window_change_0_3_choice;
      slice1window_change_0_4 <= slice1window_entering_0_4 - slice1window_change_0_4_choice;
      slice1window_change_0_5 <= slice1window_entering_0_5 - slice1window_change_0_5_choice;
      slice1window_change_0_6 <= slice1window_entering_0_6 - slice1window_change_0_6_choice;
      slice1window_change_0_7 <= slice1window_entering_0_7 - slice1window_change_0_7_choice;
      slice1window_change_0_8 <= slice1window_entering_0_8 - slice1window_change_0_8_choice;
      slice1window_change_0_9 <= slice1window_entering_0_9 - slice1window_change_0_9_choice;
      slice1window_change_0_10 <= slice1window_entering_0_10 - slice1window_change_0_10_choice;
      slice1window_change_0_11 <= slice1window_entering_0_11 - slice1window_change_0_11_choice;
      slice1window_change_0_12 <= slice1window_entering_0_12 - slice1window_change_0_12_choice;
      slice1window_change_0_13 <= slice1window_entering_0_13 - slice1window_change_0_13_choice;
      slice1window_change_0_14 <= slice1window_entering_0_14 - slice1window_change_0_14_choice;
      slice1window_change_0_15 <= slice1window_entering_0_15 - slice1window_change_0_15_choice;
      slice1window_change_tag_row_start <= slice0window_change_tag_row_start;
      slice1window_change_tag_leaves_window <= slice0window_change_tag_leaves_window;
      slice1window_change_tag_first_column <= slice0window_change_tag_first_column;
      slice1window_centre_map_column_0 <= slice0window_centre_map_column_0;
      slice1window_centre_first_column_0 <= slice1window_change_tag_first_column;
      slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
      slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_0_choice := 0;
      else
        slice1window_sum_0_0_choice := slice1window_sum_0_0;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_1_choice := 0;
      else
        slice1window_sum_0_1_choice := slice1window_sum_0_1;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_2_choice := 0;
      else
        slice1window_sum_0_2_choice := slice1window_sum_0_2;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_3_choice := 0;
      else
        slice1window_sum_0_3_choice := slice1window_sum_0_3;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_4_choice := 0;
      else
        slice1window_sum_0_4_choice := slice1window_sum_0_4;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_5_choice := 0;
      else
        slice1window_sum_0_5_choice := slice1window_sum_0_5;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_6_choice := 0;
      else
        slice1window_sum_0_6_choice := slice1window_sum_0_6;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_7_choice := 0;
      else
        slice1window_sum_0_7_choice := slice1window_sum_0_7;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_8_choice := 0;
      else
        slice1window_sum_0_8_choice := slice1window_sum_0_8;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_9_choice := 0;
      else
        slice1window_sum_0_9_choice := slice1window_sum_0_9;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_10_choice := 0;
      else
        slice1window_sum_0_10_choice := slice1window_sum_0_10;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_11_choice := 0;
      else
        slice1window_sum_0_11_choice := slice1window_sum_0_11;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_12_choice := 0;
      else
        slice1window_sum_0_12_choice := slice1window_sum_0_12;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_13_choice := 0;
      else
        slice1window_sum_0_13_choice := slice1window_sum_0_13;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_14_choice := 0;
      else
        slice1window_sum_0_14_choice := slice1window_sum_0_14;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_15_choice := 0;
      else
        slice1window_sum_0_15_choice := slice1window_sum_0_15;
      end if;
      if slice0window_tag_valid then
        slice1window_sum_0_0 <= (slice1window_sum_0_0_choice + slice1window_change_0_0) mod 2048;
        slice1window_sum_0_1 <= (slice1window_sum_0_1_choice + slice1window_change_0_1) mod 2048;
        slice1window_sum_0_2 <= (slice1window_sum_0_2_choice + slice1window_change_0_2) mod 2048;
        slice1window_sum_0_3 <= (slice1window_sum_0_3_choice + slice1window_change_0_3) mod 2048;
        slice1window_sum_0_4 <= (slice1window_sum_0_4_choice + slice1window_change_0_4) mod 2048;
        slice1window_sum_0_5 <= (slice1window_sum_0_5_choice + slice1window_change_0_5) mod 2048;
        slice1window_sum_0_6 <= (slice1window_sum_0_6_choice + slice1window_change_0_6) mod 2048;
        slice1window_sum_0_7 <= (slice1window_sum_0_7_choice + slice1window_change_0_7) mod 2048;
        slice1window_sum_0_8 <= (slice1window_sum_0_8_choice + slice1window_change_0_8) mod 2048;
        slice1window_sum_0_9 <= (slice1window_sum_0_9_choice + slice1window_change_0_9) mod 2048;
        slice1window_sum_0_10 <= (slice1window_sum_0_10_choice + slice1window_change_0_10) mod 2048;
        slice1window_sum_0_11 <= (slice1window_sum_0_11_choice + slice1window_change_0_11) mod 2048;
        slice1window_sum_0_12 <= (slice1window_sum_0_12_choice + slice1window_change_0_12) mod 2048;
        slice1window_sum_0_13 <= (slice1window_sum_0_13_choice + slice1window_change_0_13) mod 2048;
        slice1window_sum_0_14 <= (slice1window_sum_0_14_choice + slice1window_change_0_14) mod 2048;
        slice1window_sum_0_15 <= (slice1window_sum_0_15_choice + slice1window_change_0_15) mod 2048;
        slice1window_centre_first_column_1 <= slice2window_change_tag_first_column;
        slice1window_centre_first_column_2 <= slice1window_centre_first_column_1;
      end if;
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
      if slice0window_tag_valid then
        slice1mask_inside_5_choice := slice1mask_inside_4;
      else
        slice1mask_inside_5_choice := slice1mask_inside_5;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_6_choice := slice1mask_inside_5;
      else
        slice1mask_inside_6_choice := slice1mask_inside_6;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_7_choice := slice1mask_inside_6;
      else
        slice1mask_inside_7_choice := slice1mask_inside_7;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_8_choice := slice1mask_inside_7;
      else
        slice1mask_inside_8_choice := slice1mask_inside_8;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_9_choice := slice1mask_inside_8;
      else
        slice1mask_inside_9_choice := slice1mask_inside_9;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_10_choice := slice1mask_inside_9;
      else
        slice1mask_inside_10_choice := slice1mask_inside_10;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_11_choice := slice1mask_inside_10;
      else
        slice1mask_inside_11_choice := slice1mask_inside_11;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_12_choice := slice1mask_inside_11;
      else
        slice1mask_inside_12_choice := slice1mask_inside_12;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_13_choice := slice1mask_inside_12;
      else
        slice1mask_inside_13_choice := slice1mask_inside_13;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_14_choice := slice1mask_inside_13;
      else
        slice1mask_inside_14_choice := slice1mask_inside_14;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_15_choice := slice1mask_inside_14;
      else
        slice1mask_inside_15_choice := slice1mask_inside_15;
      end if;
      slice1mask_left_out <= slice1mask_inside_15;
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
        slice1mask_inside_5 <= (not slice0window_tag_valid) and slice1mask_inside_5;
        slice1mask_inside_6 <= (not slice0window_tag_valid) and slice1mask_inside_6;
        slice1mask_inside_7 <= (not slice0window_tag_valid) and slice1mask_inside_7;
        slice1mask_inside_8 <= (not slice0window_tag_valid) and slice1mask_inside_8;
        slice1mask_inside_9 <= (not slice0window_tag_valid) and slice1mask_inside_9;
        slice1mask_inside_10 <= (not slice0window_tag_valid) and slice1mask_inside_10;
        slice1mask_inside_11 <= (not slice0window_tag_valid) and slice1mask_inside_11;
        slice1mask_inside_12 <= (not slice0window_tag_valid) and slice1mask_inside_12;
        slice1mask_inside_13 <= (not slice0window_tag_valid) and slice1mask_inside_13;
        slice1mask_inside_14 <= (not slice0window_tag_valid) and slice1mask_inside_14;
        slice1mask_inside_15 <= (not slice0window_tag_valid) and slice1mask_inside_15;
      else
        slice1mask_inside_1 <= slice1mask_inside_1_choice;
        slice1mask_inside_2 <= slice1mask_inside_2_choice;
        slice1mask_inside_3 <= slice1mask_inside_3_choice;
        slice1mask_inside_4 <= slice1mask_inside_4_choice;
        slice1mask_inside_5 <= slice1mask_inside_5_choice;
        slice1mask_inside_6 <= slice1mask_inside_6_choice;
        slice1mask_inside_7 <= slice1mask_inside_7_choice;
        slice1mask_inside_8 <= slice1mask_inside_8_choice;
        slice1mask_inside_9 <= slice1mask_inside_9_choice;
        slice1mask_inside_10 <= slice1mask_inside_10_choice;
        slice1mask_inside_11 <= slice1mask_inside_11_choice;
        slice1mask_inside_12 <= slice1mask_inside_12_choice;
        slice1mask_inside_13 <= slice1mask_inside_13_choice;
        slice1mask_inside_14 <= slice1mask_inside_14_choice;
        slice1mask_inside_15 <= slice1mask_inside_15_choice;
      end if;
      -- slice1winner1
      if slice1mask_inside_1 then
        slice1winner1_best_cost_0_0_choice := 0;
      else
        slice1winner1_best_cost_0_0_choice := 2047;
      end if;
      slice1winner1_best_cost_0_0_any := to_integer(((to_unsigned(slice1window_sum_0_1, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_0_choice, 11))));
      if slice1mask_inside_0 then
        slice1winner1_best_cost_0_0_choice_2 := 0;
      else
        slice1winner1_best_cost_0_0_choice_2 := 2047;
      end if;
      slice1winner1_best_cost_0_0_any_2 := to_integer(((to_unsigned(slice1window_sum_0_0, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_0_choice_2, 11))));
      slice1winner1_best_cost_0_0_is_less := (slice1winner1_best_cost_0_0_any - slice1winner1_best_cost_0_0_any_2) < 0;
      if slice1mask_inside_3 then
        slice1winner1_best_cost_0_1_choice := 0;
      else
        slice1winner1_best_cost_0_1_choice := 2047;
      end if;
      slice1winner1_best_cost_0_1_any := to_integer(((to_unsigned(slice1window_sum_0_3, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_1_choice, 11))));
      if slice1mask_inside_2 then
        slice1winner1_best_cost_0_1_choice_2 := 0;
      else
        slice1winner1_best_cost_0_1_choice_2 := 2047;
      end if;
      slice1winner1_best_cost_0_1_any_2 := to_integer(((to_unsigned(slice1window_sum_0_2, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_1_choice_2, 11))));
      slice1winner1_best_cost_0_1_is_less := (slice1winner1_best_cost_0_1_any - slice1winner1_best_cost_0_1_any_2) < 0;
      if slice1mask_inside_5 then
        slice1winner1_best_cost_0_2_choice := 0;
      else
        slice1winner1_best_cost_0_2_choice := 2047;
      end if;
      slice1winner1_best_cost_0_2_any := to_integer(((to_unsigned(slice1window_sum_0_5, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_2_choice, 11))));
      if slice1mask_inside_4 then
        slice1winner1_best_cost_0_2_choice_2 := 0;
      else
        slice1winner1_best_cost_0_2_choice_2 := 2047;
      end if;
      slice1winner1_best_cost_0_2_any_2 := to_integer(((to_unsigned(slice1window_sum_0_4, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_2_choice_2, 11))));
      slice1winner1_best_cost_0_2_is_less := (slice1winner1_best_cost_0_2_any - slice1winner1_best_cost_0_2_any_2) < 0;
      if slice1mask_inside_7 then
        slice1winner1_best_cost_0_3_choice := 0;
      else
        slice1winner1_best_cost_0_3_choice := 2047;
      end if;
      slice1winner1_best_cost_0_3_any := to_integer(((to_unsigned(slice1window_sum_0_7, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_3_choice, 11))));
      if slice1mask_inside_6 then
        slice1winner1_best_cost_0_3_choice_2 := 0;
      else
        slice1winner1_best_cost_0_3_choice_2 := 2047;
      end if;
      slice1winner1_best_cost_0_3_any_2 := to_integer(((to_unsigned(slice1window_sum_0_6, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_3_choice_2, 11))));
      slice1winner1_best_cost_0_3_is_less := (slice1winner1_best_cost_0_3_any - slice1winner1_best_cost_0_3_any_2) < 0;
      if slice1mask_inside_9 then
        slice1winner1_best_cost_0_4_choice := 0;
      else
        slice1winner1_best_cost_0_4_choice := 2047;
      end if;
      slice1winner1_best_cost_0_4_any := to_integer(((to_unsigned(slice1window_sum_0_9, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_4_choice, 11))));
      if slice1mask_inside_8 then
        slice1winner1_best_cost_0_4_choice_2 := 0;
      else
        slice1winner1_best_cost_0_4_choice_2 := 2047;
      end if;
      slice1winner1_best_cost_0_4_any_2 := to_integer(((to_unsigned(slice1window_sum_0_8, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_4_choice_2, 11))));
      slice1winner1_best_cost_0_4_is_less := (slice1winner1_best_cost_0_4_any - slice1winner1_best_cost_0_4_any_2) < 0;
      if slice1mask_inside_11 then
        slice1winner1_best_cost_0_5_choice := 0;
      else
        slice1winner1_best_cost_0_5_choice := 2047;
      end if;
      slice1winner1_best_cost_0_5_any := to_integer(((to_unsigned(slice1window_sum_0_11, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_5_choice, 11))));
      if slice1mask_inside_10 then
        slice1winner1_best_cost_0_5_choice_2 := 0;
      else
        slice1winner1_best_cost_0_5_choice_2 := 2047;
      end if;
      slice1winner1_best_cost_0_5_any_2 := to_integer(((to_unsigned(slice1window_sum_0_10, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_5_choice_2, 11))));
      slice1winner1_best_cost_0_5_is_less := (slice1winner1_best_cost_0_5_any - slice1winner1_best_cost_0_5_any_2) < 0;
      if slice1mask_inside_13 then
        slice1winner1_best_cost_0_6_choice := 0;
      else
        slice1winner1_best_cost_0_6_choice := 2047;
      end if;
      slice1winner1_best_cost_0_6_any := to_integer(((to_unsigned(slice1window_sum_0_13, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_6_choice, 11))));
      if slice1mask_inside_12 then
        slice1winner1_best_cost_0_6_choice_2 := 0;
      else
        slice1winner1_best_cost_0_6_choice_2 := 2047;
      end if;
      slice1winner1_best_cost_0_6_any_2 := to_integer(((to_unsigned(slice1window_sum_0_12, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_6_choice_2, 11))));
      slice1winner1_best_cost_0_6_is_less := (slice1winner1_best_cost_0_6_any - slice1winner1_best_cost_0_6_any_2) < 0;
      if slice1mask_inside_15 then
        slice1winner1_best_cost_0_7_choice := 0;
      else
        slice1winner1_best_cost_0_7_choice := 2047;
      end if;
      slice1winner1_best_cost_0_7_any := to_integer(((to_unsigned(slice1window_sum_0_15, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_7_choice, 11))));
      if slice1mask_inside_14 then
        slice1winner1_best_cost_0_7_choice_2 := 0;
      else
        slice1winner1_best_cost_0_7_choice_2 := 2047;
      end if;
      slice1winner1_best_cost_0_7_any_2 := to_integer(((to_unsigned(slice1window_sum_0_14, 11)) or
        (to_unsigned(slice1winner1_best_cost_0_7_choice_2, 11))));
      slice1winner1_best_cost_0_7_is_less := (slice1winner1_best_cost_0_7_any - slice1winner1_best_cost_0_7_any_2) < 0;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      slice1winner1_best_first_0_0 <= slice1winner1_best_cost_0_0_any_2;
      slice1winner1_best_first_0_1 <= slice1winner1_best_cost_0_1_any_2;
      slice1winner1_best_first_0_2 <= slice1winner1_best_cost_0_2_any_2;
      slice1winner1_best_first_0_3 <= slice1winner1_best_cost_0_3_any_2;
      slice1winner1_best_first_0_4 <= slice1winner1_best_cost_0_4_any_2;
      slice1winner1_best_first_0_5 <= slice1winner1_best_cost_0_5_any_2;
      slice1winner1_best_first_0_6 <= slice1winner1_best_cost_0_6_any_2;
      slice1winner1_best_first_0_7 <= slice1winner1_best_cost_0_7_any_2;
      slice1winner1_best_last_0_0 <= slice1winner1_best_cost_0_0_any;
      slice1winner1_best_last_0_1 <= slice1winner1_best_cost_0_1_any;
      slice1winner1_best_last_0_2 <= slice1winner1_best_cost_0_2_any;
      slice1winner1_best_last_0_3 <= slice1winner1_best_cost_0_3_any;
      slice1winner1_best_last_0_4 <= slice1winner1_best_cost_0_4_any;
      slice1winner1_best_last_0_5 <= slice1winner1_best_cost_0_5_any;
      slice1winner1_best_last_0_6 <= slice1winner1_best_cost_0_6_any;
      slice1winner1_best_last_0_7 <= slice1winner1_best_cost_0_7_any;
      if slice1winner1_best_cost_0_0_is_less then
        slice1winner1_best_cost_0_0 <= slice1winner1_best_cost_0_0_any;
        slice1winner1_best_below_0_0 <= slice1winner1_best_cost_0_0_any_2;
        slice1winner1_best_above_0_0 <= 0;
      else
        slice1winner1_best_cost_0_0 <= slice1winner1_best_cost_0_0_any_2;
        slice1winner1_best_below_0_0 <= 0;
        slice1winner1_best_above_0_0 <= slice1winner1_best_cost_0_0_any;
      end if;
      if slice1winner1_best_cost_0_1_is_less then
        slice1winner1_best_cost_0_1 <= slice1winner1_best_cost_0_1_any;
        slice1winner1_best_index_0_1 <= 3;
        slice1winner1_best_below_0_1 <= slice1winner1_best_cost_0_1_any_2;
        slice1winner1_best_above_0_1 <= 0;
      else
        slice1winner1_best_cost_0_1 <= slice1winner1_best_cost_0_1_any_2;
        slice1winner1_best_index_0_1 <= 2;
        slice1winner1_best_below_0_1 <= 0;
        slice1winner1_best_above_0_1 <= slice1winner1_best_cost_0_1_any;
      end if;
      if slice1winner1_best_cost_0_2_is_less then
        slice1winner1_best_cost_0_2 <= slice1winner1_best_cost_0_2_any;
        slice1winner1_best_index_0_2 <= 5;
        slice1winner1_best_below_0_2 <= slice1winner1_best_cost_0_2_any_2;
        slice1winner1_best_above_0_2 <= 0;
      else
        slice1winner1_best_cost_0_2 <= slice1winner1_best_cost_0_2_any_2;
        slice1winner1_best_index_0_2 <= 4;
        slice1winner1_best_below_0_2 <= 0;
        slice1winner1_best_above_0_2 <= slice1winner1_best_cost_0_2_any;
      end if;
      if slice1winner1_best_cost_0_3_is_less then
        slice1winner1_best_cost_0_3 <= slice1winner1_best_cost_0_3_any;
        slice1winner1_best_index_0_3 <= 7;
        slice1winner1_best_below_0_3 <= slice1winner1_best_cost_0_3_any_2;
        slice1winner1_best_above_0_3 <= 0;
      else
        slice1winner1_best_cost_0_3 <= slice1winner1_best_cost_0_3_any_2;
        slice1winner1_best_index_0_3 <= 6;
        slice1winner1_best_below_0_3 <= 0;
        slice1winner1_best_above_0_3 <= slice1winner1_best_cost_0_3_any;
      end if;
      if slice1winner1_best_cost_0_4_is_less then
        slice1winner1_best_cost_0_4 <= slice1winner1_best_cost_0_4_any;
        slice1winner1_best_index_0_4 <= 9;
        slice1winner1_best_below_0_4 <= slice1winner1_best_cost_0_4_any_2;
        slice1winner1_best_above_0_4 <= 0;
      else
        slice1winner1_best_cost_0_4 <= slice1winner1_best_cost_0_4_any_2;
        slice1winner1_best_index_0_4 <= 8;
        slice1winner1_best_below_0_4 <= 0;
        slice1winner1_best_above_0_4 <= slice1winner1_best_cost_0_4_any;
      end if;
      if slice1winner1_best_cost_0_5_is_less then
        slice1winner1_best_cost_0_5 <= slice1winner1_best_cost_0_5_any;
        slice1winner1_best_index_0_5 <= 11;
        slice1winner1_best_below_0_5 <= slice1winner1_best_cost_0_5_any_2;
        slice1winner1_best_above_0_5 <= 0;
      else
        slice1winner1_best_cost_0_5 <= slice1winner1_best_cost_0_5_any_2;
        slice1winner1_best_index_0_5 <= 10;
        slice1winner1_best_below_0_5 <= 0;
        slice1winner1_best_above_0_5 <= slice1winner1_best_cost_0_5_any;
      end if;
      if slice1winner1_best_cost_0_6_is_less then
        slice1winner1_best_cost_0_6 <= slice1winner1_best_cost_0_6_any;
        slice1winner1_best_index_0_6 <= 13;
        slice1winner1_best_below_0_6 <= slice1winner1_best_cost_0_6_any_2;
        slice1winner1_best_above_0_6 <= 0;
      else
        slice1winner1_best_cost_0_6 <= slice1winner1_best_cost_0_6_any_2;
        slice1winner1_best_index_0_6 <= 12;
        slice1winner1_best_below_0_6 <= 0;
        slice1winner1_best_above_0_6 <= slice1winner1_best_cost_0_6_any;
      end if;
      if slice1winner1_best_cost_0_7_is_less then
        slice1winner1_best_cost_0_7 <= slice1winner1_best_cost_0_7_any;
        slice1winner1_best_index_0_7 <= 15;
        slice1winner1_best_below_0_7 <= slice1winner1_best_cost_0_7_any_2;
        slice1winner1_best_above_0_7 <= 0;
      else
        slice1winner1_best_cost_0_7 <= slice1winner1_best_cost_0_7_any_2;
        slice1winner1_best_index_0_7 <= 14;
        slice1winner1_best_below_0_7 <= 0;
        slice1winner1_best_above_0_7 <= slice1winner1_best_cost_0_7_any;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0;
      slice1winner2_best_cost_0_1_is_less := (slice1winner1_best_cost_0_3 - slice1winner1_best_cost_0_2) < 0;
      slice1winner2_best_cost_0_2_is_less := (slice1winner1_best_cost_0_5 - slice1winner1_best_cost_0_4) < 0;
      slice1winner2_best_cost_0_3_is_less := (slice1winner1_best_cost_0_7 - slice1winner1_best_cost_0_6) < 0;
      if slice1winner1_best_index_0_1 = 2 then
        slice1winner2_best_below_0_0_choice := slice1winner1_best_last_0_0;
      else
        slice1winner2_best_below_0_0_choice := slice1winner1_best_below_0_1;
      end if;
      if slice1winner1_best_index_0_3 = 6 then
        slice1winner2_best_below_0_1_choice := slice1winner1_best_last_0_2;
      else
        slice1winner2_best_below_0_1_choice := slice1winner1_best_below_0_3;
      end if;
      if ((slice1winner1_best_index_0_5 / 8) = 1) and ((slice1winner1_best_index_0_5 mod 4) = 2) then
        slice1winner2_best_below_0_2_choice := slice1winner1_best_last_0_4;
      else
        slice1winner2_best_below_0_2_choice := slice1winner1_best_below_0_5;
      end if;
      if slice1winner1_best_index_0_7 = 14 then
        slice1winner2_best_below_0_3_choice := slice1winner1_best_last_0_6;
      else
        slice1winner2_best_below_0_3_choice := slice1winner1_best_below_0_7;
      end if;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_0_choice := slice1winner1_best_first_0_1;
      else
        slice1winner2_best_above_0_0_choice := slice1winner1_best_above_0_0;
      end if;
      if other_6 then
        slice1winner2_best_above_0_1_choice := slice1winner1_best_first_0_3;
      else
        slice1winner2_best_above_0_1_choice := slice1winner1_best_above_0_2;
      end if;
      if other_7 then
        slice1winner2_best_above_0_2_choice := slice1winner1_best_first_0_5;
      else
        slice1winner2_best_above_0_2_choice := slice1winner1_best_above_0_4;
      end if;
      if other_8 then
        slice1winner2_best_above_0_3_choice := slice1winner1_best_first_0_7;
      else
        slice1winner2_best_above_0_3_choice := slice1winner1_best_above_0_6;
      end if;
      slice1winner2_best_first_0_0 <= slice1winner1_best_first_0_0;
      slice1winner2_best_first_0_1 <= slice1winner1_best_first_0_2;
      slice1winner2_best_first_0_2 <= slice1winner1_best_first_0_4;
      slice1winner2_best_first_0_3 <= slice1winner1_best_first_0_6;
      slice1winner2_best_last_0_0 <= slice1winner1_best_last_0_1;
      slice1winner2_best_last_0_1 <= slice1winner1_best_last_0_3;
      slice1winner2_best_last_0_2 <= slice1winner1_best_last_0_5;
      slice1winner2_best_last_0_3 <= slice1winner1_best_last_0_7;
      if slice1winner2_best_cost_0_0_is_less then
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_1;
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
        slice1winner2_best_below_0_0 <= slice1winner2_best_below_0_0_choice;
        slice1winner2_best_above_0_0 <= slice1winner1_best_above_0_1;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
        slice1winner2_best_below_0_0 <= slice1winner1_best_below_0_0;
        slice1winner2_best_above_0_0 <= slice1winner2_best_above_0_0_choice;
      end if;
      if slice1winner2_best_cost_0_1_is_less then
        slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_3;
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_3;
        slice1winner2_best_below_0_1 <= slice1winner2_best_below_0_1_choice;
        slice1winner2_best_above_0_1 <= slice1winner1_best_above_0_3;
      else
        slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_2;
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
        slice1winner2_best_below_0_1 <= slice1winner1_best_below_0_2;
        slice1winner2_best_above_0_1 <= slice1winner2_best_above_0_1_choice;
      end if;
      if slice1winner2_best_cost_0_2_is_less then
        slice1winner2_best_cost_0_2 <= slice1winner1_best_cost_0_5;
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_5;
        slice1winner2_best_below_0_2 <= slice1winner2_best_below_0_2_choice;
        slice1winner2_best_above_0_2 <= slice1winner1_best_above_0_5;
      else
        slice1winner2_best_cost_0_2 <= slice1winner1_best_cost_0_4;
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_4;
        slice1winner2_best_below_0_2 <= slice1winner1_best_below_0_4;
        slice1winner2_best_above_0_2 <= slice1winner2_best_above_0_2_choice;
      end if;
      if slice1winner2_best_cost_0_3_is_less then
        slice1winner2_best_cost_0_3 <= slice1winner1_best_cost_0_7;
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_7;
        slice1winner2_best_below_0_3 <= slice1winner2_best_below_0_3_choice;
        slice1winner2_best_above_0_3 <= slice1winner1_best_above_0_7;
      else
        slice1winner2_best_cost_0_3 <= slice1winner1_best_cost_0_6;
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_6;
        slice1winner2_best_below_0_3 <= slice1winner1_best_below_0_6;
        slice1winner2_best_above_0_3 <= slice1winner2_best_above_0_3_choice;
      end if;
      -- slice1winner3
      slice1winner3_best_cost_0_0_is_less := (slice1winner2_best_cost_0_1 - slice1winner2_best_cost_0_0) < 0;
      slice1winner3_best_cost_0_1_is_less := (slice1winner2_best_cost_0_3 - slice1winner2_best_cost_0_2) < 0;
      if slice1winner2_best_index_0_1 = 4 then
        slice1winner3_best_below_0_0_choice := slice1winner2_best_last_0_0;
      else
        slice1winner3_best_below_0_0_choice := slice1winner2_best_below_0_1;
      end if;
      if slice1winner2_best_index_0_3 = 12 then
        slice1winner3_best_below_0_1_choice := slice1winner2_best_last_0_2;
      else
        slice1winner3_best_below_0_1_choice := slice1winner2_best_below_0_3;
      end if;
      if slice1winner2_best_index_0_0 = 3 then
        slice1winner3_best_above_0_0_choice := slice1winner2_best_first_0_1;
      else
        slice1winner3_best_above_0_0_choice := slice1winner2_best_above_0_0;
      end if;
      if ((slice1winner2_best_index_0_2 / 8) = 1) and ((slice1winner2_best_index_0_2 mod 4) = 3) then
        slice1winner3_best_above_0_1_choice := slice1winner2_best_first_0_3;
      else
        slice1winner3_best_above_0_1_choice := slice1winner2_best_above_0_2;
      end if;
      slice1winner3_best_first_0_0 <= slice1winner2_best_first_0_0;
      slice1winner3_best_first_0_1 <= slice1winner2_best_first_0_2;
      slice1winner3_best_last_0_0 <= slice1winner2_best_last_0_1;
      slice1winner3_best_last_0_1 <= slice1winner2_best_last_0_3;
      if slice1winner3_best_cost_0_0_is_less then
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_1;
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1;
        slice1winner3_best_below_0_0 <= slice1winner3_best_below_0_0_choice;
        slice1winner3_best_above_0_0 <= slice1winner2_best_above_0_1;
      else
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_0;
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
        slice1winner3_best_below_0_0 <= slice1winner2_best_below_0_0;
        slice1winner3_best_above_0_0 <= slice1winner3_best_above_0_0_choice;
      end if;
      if slice1winner3_best_cost_0_1_is_less then
        slice1winner3_best_cost_0_1 <= slice1winner2_best_cost_0_3;
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_3;
        slice1winner3_best_below_0_1 <= slice1winner3_best_below_0_1_choice;
        slice1winner3_best_above_0_1 <= slice1winner2_best_above_0_3;
      else
        slice1winner3_best_cost_0_1 <= slice1winner2_best_cost_0_2;
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_2;
        slice1winner3_best_below_0_1 <= slice1winner2_best_below_0_2;
        slice1winner3_best_above_0_1 <= slice1winner3_best_above_0_1_choice;
      end if;
      -- slice1winner4
      slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0_1 - slice1winner3_best_cost_0_0) < 0;
      if slice1winner3_best_index_0_1 = 8 then
        slice1winner4_best_below_0_0_choice := slice1winner3_best_last_0_0;
      else
        slice1winner4_best_below_0_0_choice := slice1winner3_best_below_0_1;
      end if;
      if slice1winner3_best_index_0_0 = 7 then
        slice1winner4_best_above_0_0_choice := slice1winner3_best_first_0_1;
      else
        slice1winner4_best_above_0_0_choice := slice1winner3_best_above_0_0;
      end if;
      slice1winner4_best_first_0_0 <= slice1winner3_best_first_0_0;
      slice1winner4_best_last_0_0 <= slice1winner3_best_last_0_1;
      if slice1winner4_best_cost_0_0_is_less then
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_1;
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_1;
        slice1winner4_best_below_0_0 <= slice1winner4_best_below_0_0_choice;
        slice1winner4_best_above_0_0 <= slice1winner3_best_above_0_1;
      else
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_0;
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
        slice1winner4_best_below_0_0 <= slice1winner3_best_below_0_0;
        slice1winner4_best_above_0_0 <= slice1winner4_best_above_0_0_choice;
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice1winner4_best_cost_0_0 - slice0_best_cost_0_0) < 0;
      if slice1winner4_best_index_0_0 = 0 then
        slice1_best_below_0_0_choice := slice0_best_last_0_0;
      else
        slice1_best_below_0_0_choice := slice1winner4_best_below_0_0;
      end if;
      if slice0_best_index_0_0 = 15 then
        slice1_best_above_0_0_choice := slice1winner4_best_first_0_0;
      else
        slice1_best_above_0_0_choice := slice0_best_above_0_0;
      end if;
      slice1_best_last_0_0 <= slice1winner4_best_last_0_0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice1winner4_best_cost_0_0;
        slice1_best_index_0_0 <= slice1winner4_best_index_0_0 + 16;
        slice1_best_below_0_0 <= slice1_best_below_0_0_choice;
        slice1_best_above_0_0 <= slice1winner4_best_above_0_0;
      else
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
        slice1_best_below_0_0 <= slice0_best_below_0_0;
        slice1_best_above_0_0 <= slice1_best_above_0_0_choice;
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        slice2shift_search_0_0 <= slice1shift_search_out_0;
        slice2shift_search_0_1 <= slice2shift_search_0_0;
        slice2shift_search_0_2 <= slice2shift_search_0_1;
        slice2shift_search_0_3 <= slice2shift_search_0_2;
        slice2shift_search_0_4 <= slice2shift_search_0_3;
        slice2shift_search_0_5 <= slice2shift_search_0_4;
        slice2shift_search_0_6 <= slice2shift_search_0_5;
        slice2shift_search_0_7 <= slice2shift_search_0_6;
        slice2shift_search_0_8 <= slice2shift_search_0_7;
        slice2shift_search_0_9 <= slice2shift_search_0_8;
        slice2shift_search_0_10 <= slice2shift_search_0_9;
        slice2shift_search_0_11 <= slice2shift_search_0_10;
        slice2shift_search_0_12 <= slice2shift_search_0_11;
        slice2shift_search_0_13 <= slice2shift_search_0_12;
        slice2shift_search_0_14 <= slice2shift_search_0_13;
        slice2shift_search_0_15 <= slice2shift_search_0_14;
        slice2shift_search_1_0 <= slice1shift_search_out_1;
        slice2shift_search_1_1 <= slice2shift_search_1_0;
        slice2shift_search_1_2 <= slice2shift_search_1_1;
        slice2shift_search_1_3 <= slice2shift_search_1_2;
        slice2shift_search_1_4 <= slice2shift_search_1_3;
        slice2shift_search_1_5 <= slice2shift_search_1_4;
        slice2shift_search_1_6 <= slice2shift_search_1_5;
        slice2shift_search_1_7 <= slice2shift_search_1_6;
        slice2shift_search_1_8 <= slice2shift_search_1_7;
        slice2shift_search_1_9 <= slice2shift_search_1_8;
        slice2shift_search_1_10 <= slice2shift_search_1_9;
        slice2shift_search_1_11 <= slice2shift_search_1_10;
        slice2shift_search_1_12 <= slice2shift_search_1_11;
        slice2shift_search_1_13 <= slice2shift_search_1_12;
        slice2shift_search_1_14 <= slice2shift_search_1_13;
        slice2shift_search_1_15 <= slice2shift_search_1_14;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
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
      slice2cost_pixels_first_0_0_count_6_value_2 := ((slice2shift_reference_0 / 1048576) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_6_value_3 := ((slice2shift_reference_0 / 524288) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_7_value := ((slice2shift_reference_0 / 2097152) mod 2) = 1;
      slice2cost_pixels_first_0_0_count_7_value_2 := ((slice2shift_reference_0 / 4194304) mod 2) = 1;
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
      slice2cost_pixels_first_1_0_count_6_value_2 := ((slice2shift_reference_1 / 1048576) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_6_value_3 := ((slice2shift_reference_1 / 524288) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_7_value := ((slice2shift_reference_1 / 2097152) mod 2) = 1;
      slice2cost_pixels_first_1_0_count_7_value_2 := ((slice2shift_reference_1 / 4194304) mod 2) = 1;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_0_choice := 0;
      else
        slice2cost_column_0_0_choice := to_integer(slice2cost_ready_words_0(7 downto 0));
      end if;
      slice2cost_column_0_0_value := (slice2cost_change_0_0 + slice2cost_column_0_0_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_1_choice := 0;
      else
        slice2cost_column_0_1_choice := to_integer(slice2cost_ready_words_0(15 downto 8));
      end if;
      slice2cost_column_0_1_value := (slice2cost_change_0_1 + slice2cost_column_0_1_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_2_choice := 0;
      else
        slice2cost_column_0_2_choice := to_integer(slice2cost_ready_words_0(23 downto 16));
      end if;
      slice2cost_column_0_2_value := (slice2cost_change_0_2 + slice2cost_column_0_2_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_3_choice := 0;
      else
        slice2cost_column_0_3_choice := to_integer(slice2cost_ready_words_0(31 downto 24));
      end if;
      slice2cost_column_0_3_value := (slice2cost_change_0_3 + slice2cost_column_0_3_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_4_choice := 0;
      else
        slice2cost_column_0_4_choice := to_integer(slice2cost_ready_words_1(7 downto 0));
      end if;
      slice2cost_column_0_4_value := (slice2cost_change_0_4 + slice2cost_column_0_4_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_5_choice := 0;
      else
        slice2cost_column_0_5_choice := to_integer(slice2cost_ready_words_1(15 downto 8));
      end if;
      slice2cost_column_0_5_value := (slice2cost_change_0_5 + slice2cost_column_0_5_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_6_choice := 0;
      else
        slice2cost_column_0_6_choice := to_integer(slice2cost_ready_words_1(23 downto 16));
      end if;
      slice2cost_column_0_6_value := (slice2cost_change_0_6 + slice2cost_column_0_6_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_7_choice := 0;
      else
        slice2cost_column_0_7_choice := to_integer(slice2cost_ready_words_1(31 downto 24));
      end if;
      slice2cost_column_0_7_value := (slice2cost_change_0_7 + slice2cost_column_0_7_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_8_choice := 0;
      else
        slice2cost_column_0_8_choice := to_integer(slice2cost_ready_words_2(7 downto 0));
      end if;
      slice2cost_column_0_8_value := (slice2cost_change_0_8 + slice2cost_column_0_8_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_9_choice := 0;
      else
        slice2cost_column_0_9_choice := to_integer(slice2cost_ready_words_2(15 downto 8));
      end if;
      slice2cost_column_0_9_value := (slice2cost_change_0_9 + slice2cost_column_0_9_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_10_choice := 0;
      else
        slice2cost_column_0_10_choice := to_integer(slice2cost_ready_words_2(23 downto 16));
      end if;
      slice2cost_column_0_10_value := (slice2cost_change_0_10 + slice2cost_column_0_10_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_11_choice := 0;
      else
        slice2cost_column_0_11_choice := to_integer(slice2cost_ready_words_2(31 downto 24));
      end if;
      slice2cost_column_0_11_value := (slice2cost_change_0_11 + slice2cost_column_0_11_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_12_choice := 0;
      else
        slice2cost_column_0_12_choice := to_integer(slice2cost_ready_words_3(7 downto 0));
      end if;
      slice2cost_column_0_12_value := (slice2cost_change_0_12 + slice2cost_column_0_12_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_13_choice := 0;
      else
        slice2cost_column_0_13_choice := to_integer(slice2cost_ready_words_3(15 downto 8));
      end if;
      slice2cost_column_0_13_value := (slice2cost_change_0_13 + slice2cost_column_0_13_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_14_choice := 0;
      else
        slice2cost_column_0_14_choice := to_integer(slice2cost_ready_words_3(23 downto 16));
      end if;
      slice2cost_column_0_14_value := (slice2cost_change_0_14 + slice2cost_column_0_14_choice) mod 256;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_15_choice := 0;
      else
        slice2cost_column_0_15_choice := to_integer(slice2cost_ready_words_3(31 downto 24));
      end if;
      slice2cost_column_0_15_value := (slice2cost_change_0_15 + slice2cost_column_0_15_choice) mod 256;
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
      slice2cost_pixels_first_0_0_count_6 <= as_number((slice2cost_pixels_first_0_0_count_6_value /=
        (((slice2shift_search_0_0 / 262144) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_6_value_2 /=
        (((slice2shift_search_0_0 / 1048576) mod 2) = 1))) + as_number((slice2cost_pixels_first_0_0_count_6_value_3 /=
        (((slice2shift_search_0_0 / 524288) mod 2) = 1)));
      slice2cost_pixels_first_0_0_count_7 <= as_number((slice2cost_pixels_first_0_0_count_7_value /=
        (((slice2shift_search_0_0 / 2097152) mod 2) = 1))) + as_number((((slice2shift_reference_0 / 8388608) = 1) /=
        ((slice2shift_search_0_0 / 8388608) = 1))) + as_number((slice2cost_pixels_first_0_0_count_7_value_2 /=
        (((slice2shift_search_0_0 / 4194304) mod 2) = 1)));
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
      slice2cost_pixels_first_0_1_count_6 <= as_number(((((slice2shift_search_0_1 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_1 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_1 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_1_count_7 <= as_number(((((slice2shift_search_0_1 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_1 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_1 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_2_count_0 <= as_number((((slice2shift_search_0_2 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_2 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_2 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_2_count_1 <= as_number(((((slice2shift_search_0_2 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_2 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_2 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_2_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_2 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_2 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_2 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_2_count_3 <= as_number(((((slice2shift_search_0_2 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_2 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_2 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_2_count_4 <= as_number(((((slice2shift_search_0_2 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_2 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_2 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_2_count_5 <= as_number(((((slice2shift_search_0_2 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_2 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_2 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_2_count_6 <= as_number(((((slice2shift_search_0_2 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_2 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_2 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_2_count_7 <= as_number(((((slice2shift_search_0_2 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_2 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_2 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_3_count_0 <= as_number((((slice2shift_search_0_3 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_3 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_3 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_3_count_1 <= as_number(((((slice2shift_search_0_3 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_3 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_3 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_3_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_3 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_3 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_3 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_3_count_3 <= as_number(((((slice2shift_search_0_3 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_3 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_3 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_3_count_4 <= as_number(((((slice2shift_search_0_3 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_3 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_3 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_3_count_5 <= as_number(((((slice2shift_search_0_3 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_3 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_3 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_3_count_6 <= as_number(((((slice2shift_search_0_3 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_3 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_3 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_3_count_7 <= as_number(((((slice2shift_search_0_3 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_3 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_3 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_4_count_0 <= as_number((((slice2shift_search_0_4 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_4 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_4 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_4_count_1 <= as_number(((((slice2shift_search_0_4 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_4 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_4 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_4_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_4 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_4 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_4 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_4_count_3 <= as_number(((((slice2shift_search_0_4 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_4 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_4 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_4_count_4 <= as_number(((((slice2shift_search_0_4 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_4 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_4 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_4_count_5 <= as_number(((((slice2shift_search_0_4 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_4 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_4 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_4_count_6 <= as_number(((((slice2shift_search_0_4 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_4 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_4 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_4_count_7 <= as_number(((((slice2shift_search_0_4 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_4 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_4 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_5_count_0 <= as_number((((slice2shift_search_0_5 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_5 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_5 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_5_count_1 <= as_number(((((slice2shift_search_0_5 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_5 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_5 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_5_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_5 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_5 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_5 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_5_count_3 <= as_number(((((slice2shift_search_0_5 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_5 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_5 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_5_count_4 <= as_number(((((slice2shift_search_0_5 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_5 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_5 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_5_count_5 <= as_number(((((slice2shift_search_0_5 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_5 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_5 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_5_count_6 <= as_number(((((slice2shift_search_0_5 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_5 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_5 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_5_count_7 <= as_number(((((slice2shift_search_0_5 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_5 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_5 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_6_count_0 <= as_number((((slice2shift_search_0_6 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_6 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_6 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_6_count_1 <= as_number(((((slice2shift_search_0_6 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_6 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_6 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_6_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_6 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_6 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_6 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_6_count_3 <= as_number(((((slice2shift_search_0_6 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_6 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_6 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_6_count_4 <= as_number(((((slice2shift_search_0_6 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_6 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_6 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_6_count_5 <= as_number(((((slice2shift_search_0_6 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_6 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_6 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_6_count_6 <= as_number(((((slice2shift_search_0_6 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_6 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_6 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_6_count_7 <= as_number(((((slice2shift_search_0_6 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_6 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_6 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_7_count_0 <= as_number((((slice2shift_search_0_7 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_7 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_7 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_7_count_1 <= as_number(((((slice2shift_search_0_7 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_7 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_7 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_7_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_7 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_7 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_7 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_7_count_3 <= as_number(((((slice2shift_search_0_7 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_7 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_7 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_7_count_4 <= as_number(((((slice2shift_search_0_7 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_7 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_7 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_7_count_5 <= as_number(((((slice2shift_search_0_7 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_7 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_7 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_7_count_6 <= as_number(((((slice2shift_search_0_7 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_7 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_7 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_7_count_7 <= as_number(((((slice2shift_search_0_7 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_7 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_7 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_8_count_0 <= as_number((((slice2shift_search_0_8 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_8 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_8 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_8_count_1 <= as_number(((((slice2shift_search_0_8 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_8 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_8 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_8_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_8 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_8 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_8 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_8_count_3 <= as_number(((((slice2shift_search_0_8 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_8 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_8 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_8_count_4 <= as_number(((((slice2shift_search_0_8 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_8 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_8 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_8_count_5 <= as_number(((((slice2shift_search_0_8 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_8 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_8 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_8_count_6 <= as_number(((((slice2shift_search_0_8 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_8 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_8 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_8_count_7 <= as_number(((((slice2shift_search_0_8 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_8 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_8 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_9_count_0 <= as_number((((slice2shift_search_0_9 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_9 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_9 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_9_count_1 <= as_number(((((slice2shift_search_0_9 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_9 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_9 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_9_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_9 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_9 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_9 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_9_count_3 <= as_number(((((slice2shift_search_0_9 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_9 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_9 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_9_count_4 <= as_number(((((slice2shift_search_0_9 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_9 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_9 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_9_count_5 <= as_number(((((slice2shift_search_0_9 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_9 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_9 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_9_count_6 <= as_number(((((slice2shift_search_0_9 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_9 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_9 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_9_count_7 <= as_number(((((slice2shift_search_0_9 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_9 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_9 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_10_count_0 <= as_number((((slice2shift_search_0_10 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_10 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_10 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_10_count_1 <= as_number(((((slice2shift_search_0_10 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_10 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_10 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_10_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_10 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_10 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_10 / 64) mod 2) =
        1) /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_10_count_3 <= as_number(((((slice2shift_search_0_10 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_10 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_10 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_10_count_4 <= as_number(((((slice2shift_search_0_10 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_10 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_10 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_10_count_5 <= as_number(((((slice2shift_search_0_10 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_10 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_10 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_10_count_6 <= as_number(((((slice2shift_search_0_10 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_10 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_10 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_10_count_7 <= as_number(((((slice2shift_search_0_10 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_10 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_10 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_11_count_0 <= as_number((((slice2shift_search_0_11 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_11 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_11 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_11_count_1 <= as_number(((((slice2shift_search_0_11 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_11 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_11 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_11_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_11 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_11 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_11 / 64) mod 2) =
        1) /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_11_count_3 <= as_number(((((slice2shift_search_0_11 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_11 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_11 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_11_count_4 <= as_number(((((slice2shift_search_0_11 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_11 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_11 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_11_count_5 <= as_number(((((slice2shift_search_0_11 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_11 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_11 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_11_count_6 <= as_number(((((slice2shift_search_0_11 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_11 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_11 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_11_count_7 <= as_number(((((slice2shift_search_0_11 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_11 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_11 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_12_count_0 <= as_number((((slice2shift_search_0_12 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_12 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_12 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_12_count_1 <= as_number(((((slice2shift_search_0_12 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_12 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_12 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_12_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_12 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_12 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_12 / 64) mod 2) =
        1) /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_12_count_3 <= as_number(((((slice2shift_search_0_12 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_12 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_12 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_12_count_4 <= as_number(((((slice2shift_search_0_12 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_12 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_12 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_12_count_5 <= as_number(((((slice2shift_search_0_12 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_12 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_12 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_12_count_6 <= as_number(((((slice2shift_search_0_12 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_12 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_12 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_12_count_7 <= as_number(((((slice2shift_search_0_12 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_12 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_12 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_13_count_0 <= as_number((((slice2shift_search_0_13 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_13 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_13 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_13_count_1 <= as_number(((((slice2shift_search_0_13 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_13 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_13 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_13_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_13 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_13 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_13 / 64) mod 2) =
        1) /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_13_count_3 <= as_number(((((slice2shift_search_0_13 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_13 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_13 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_13_count_4 <= as_number(((((slice2shift_search_0_13 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_13 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_13 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_13_count_5 <= as_number(((((slice2shift_search_0_13 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_13 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_13 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_13_count_6 <= as_number(((((slice2shift_search_0_13 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_13 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_13 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_13_count_7 <= as_number(((((slice2shift_search_0_13 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_13 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_13 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_14_count_0 <= as_number((((slice2shift_search_0_14 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_14 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_14 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_14_count_1 <= as_number(((((slice2shift_search_0_14 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_14 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_14 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_14_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_14 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_14 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_14 / 64) mod 2) =
        1) /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_14_count_3 <= as_number(((((slice2shift_search_0_14 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_14 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_14 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_14_count_4 <= as_number(((((slice2shift_search_0_14 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_14 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_14 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_14_count_5 <= as_number(((((slice2shift_search_0_14 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_14 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_14 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_14_count_6 <= as_number(((((slice2shift_search_0_14 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_14 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_14 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_14_count_7 <= as_number(((((slice2shift_search_0_14 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_14 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_14 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
      slice2cost_pixels_first_0_15_count_0 <= as_number((((slice2shift_search_0_15 mod 2) = 1) /=
        ((slice2shift_reference_0 mod 2) = 1))) + as_number(((((slice2shift_search_0_15 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value)) + as_number(((((slice2shift_search_0_15 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_0_value_2));
      slice2cost_pixels_first_0_15_count_1 <= as_number(((((slice2shift_search_0_15 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value)) + as_number(((((slice2shift_search_0_15 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_2)) + as_number(((((slice2shift_search_0_15 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_1_value_3));
      slice2cost_pixels_first_0_15_count_2 <= (to_integer(((to_unsigned((slice2shift_search_0_15 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_0_15 / 256) mod
        2) = 1) /= slice2cost_pixels_first_0_0_count_2_value)) + as_number(((((slice2shift_search_0_15 / 64) mod 2) =
        1) /= slice2cost_pixels_first_0_0_count_2_value_2));
      slice2cost_pixels_first_0_15_count_3 <= as_number(((((slice2shift_search_0_15 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value)) + as_number(((((slice2shift_search_0_15 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_2)) + as_number(((((slice2shift_search_0_15 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_3_value_3));
      slice2cost_pixels_first_0_15_count_4 <= as_number(((((slice2shift_search_0_15 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value)) + as_number(((((slice2shift_search_0_15 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_2)) + as_number(((((slice2shift_search_0_15 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_4_value_3));
      slice2cost_pixels_first_0_15_count_5 <= as_number(((((slice2shift_search_0_15 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value)) + as_number(((((slice2shift_search_0_15 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_2)) + as_number(((((slice2shift_search_0_15 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_5_value_3));
      slice2cost_pixels_first_0_15_count_6 <= as_number(((((slice2shift_search_0_15 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value)) + as_number(((((slice2shift_search_0_15 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_2)) + as_number(((((slice2shift_search_0_15 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_6_value_3));
      slice2cost_pixels_first_0_15_count_7 <= as_number(((((slice2shift_search_0_15 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value)) + as_number((((slice2shift_search_0_15 / 8388608) = 1) /=
        ((slice2shift_reference_0 / 8388608) = 1))) + as_number(((((slice2shift_search_0_15 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_0_0_count_7_value_2));
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
      slice2cost_pixels_first_1_0_count_6 <= as_number((slice2cost_pixels_first_1_0_count_6_value /=
        (((slice2shift_search_1_0 / 262144) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_6_value_2 /=
        (((slice2shift_search_1_0 / 1048576) mod 2) = 1))) + as_number((slice2cost_pixels_first_1_0_count_6_value_3 /=
        (((slice2shift_search_1_0 / 524288) mod 2) = 1)));
      slice2cost_pixels_first_1_0_count_7 <= as_number((slice2cost_pixels_first_1_0_count_7_value /=
        (((slice2shift_search_1_0 / 2097152) mod 2) = 1))) + as_number((((slice2shift_reference_1 / 8388608) = 1) /=
        ((slice2shift_search_1_0 / 8388608) = 1))) + as_number((slice2cost_pixels_first_1_0_count_7_value_2 /=
        (((slice2shift_search_1_0 / 4194304) mod 2) = 1)));
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
      slice2cost_pixels_first_1_1_count_6 <= as_number(((((slice2shift_search_1_1 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_1 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_1 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_1_count_7 <= as_number(((((slice2shift_search_1_1 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_1 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_1 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_2_count_0 <= as_number((((slice2shift_search_1_2 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_2 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_2 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_2_count_1 <= as_number(((((slice2shift_search_1_2 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_2 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_2 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_2_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_2 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_2 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_2 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_2_count_3 <= as_number(((((slice2shift_search_1_2 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_2 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_2 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_2_count_4 <= as_number(((((slice2shift_search_1_2 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_2 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_2 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_2_count_5 <= as_number(((((slice2shift_search_1_2 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_2 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_2 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_2_count_6 <= as_number(((((slice2shift_search_1_2 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_2 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_2 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_2_count_7 <= as_number(((((slice2shift_search_1_2 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_2 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_2 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_3_count_0 <= as_number((((slice2shift_search_1_3 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_3 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_3 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_3_count_1 <= as_number(((((slice2shift_search_1_3 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_3 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_3 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_3_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_3 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_3 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_3 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_3_count_3 <= as_number(((((slice2shift_search_1_3 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_3 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_3 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_3_count_4 <= as_number(((((slice2shift_search_1_3 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_3 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_3 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_3_count_5 <= as_number(((((slice2shift_search_1_3 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_3 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_3 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_3_count_6 <= as_number(((((slice2shift_search_1_3 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_3 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_3 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_3_count_7 <= as_number(((((slice2shift_search_1_3 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_3 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_3 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_4_count_0 <= as_number((((slice2shift_search_1_4 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_4 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_4 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_4_count_1 <= as_number(((((slice2shift_search_1_4 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_4 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_4 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_4_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_4 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_4 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_4 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_4_count_3 <= as_number(((((slice2shift_search_1_4 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_4 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_4 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_4_count_4 <= as_number(((((slice2shift_search_1_4 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_4 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_4 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_4_count_5 <= as_number(((((slice2shift_search_1_4 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_4 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_4 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_4_count_6 <= as_number(((((slice2shift_search_1_4 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_4 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_4 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_4_count_7 <= as_number(((((slice2shift_search_1_4 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_4 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_4 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_5_count_0 <= as_number((((slice2shift_search_1_5 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_5 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_5 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_5_count_1 <= as_number(((((slice2shift_search_1_5 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_5 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_5 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_5_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_5 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_5 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_5 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_5_count_3 <= as_number(((((slice2shift_search_1_5 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_5 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_5 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_5_count_4 <= as_number(((((slice2shift_search_1_5 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_5 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_5 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_5_count_5 <= as_number(((((slice2shift_search_1_5 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_5 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_5 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_5_count_6 <= as_number(((((slice2shift_search_1_5 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_5 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_5 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_5_count_7 <= as_number(((((slice2shift_search_1_5 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_5 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_5 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_6_count_0 <= as_number((((slice2shift_search_1_6 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_6 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_6 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_6_count_1 <= as_number(((((slice2shift_search_1_6 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_6 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_6 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_6_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_6 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_6 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_6 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_6_count_3 <= as_number(((((slice2shift_search_1_6 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_6 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_6 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_6_count_4 <= as_number(((((slice2shift_search_1_6 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_6 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_6 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_6_count_5 <= as_number(((((slice2shift_search_1_6 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_6 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_6 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_6_count_6 <= as_number(((((slice2shift_search_1_6 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_6 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_6 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_6_count_7 <= as_number(((((slice2shift_search_1_6 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_6 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_6 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_7_count_0 <= as_number((((slice2shift_search_1_7 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_7 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_7 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_7_count_1 <= as_number(((((slice2shift_search_1_7 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_7 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_7 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_7_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_7 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_7 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_7 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_7_count_3 <= as_number(((((slice2shift_search_1_7 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_7 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_7 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_7_count_4 <= as_number(((((slice2shift_search_1_7 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_7 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_7 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_7_count_5 <= as_number(((((slice2shift_search_1_7 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_7 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_7 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_7_count_6 <= as_number(((((slice2shift_search_1_7 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_7 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_7 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_7_count_7 <= as_number(((((slice2shift_search_1_7 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_7 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_7 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_8_count_0 <= as_number((((slice2shift_search_1_8 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_8 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_8 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_8_count_1 <= as_number(((((slice2shift_search_1_8 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_8 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_8 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_8_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_8 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_8 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_8 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_8_count_3 <= as_number(((((slice2shift_search_1_8 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_8 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_8 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_8_count_4 <= as_number(((((slice2shift_search_1_8 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_8 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_8 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_8_count_5 <= as_number(((((slice2shift_search_1_8 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_8 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_8 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_8_count_6 <= as_number(((((slice2shift_search_1_8 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_8 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_8 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_8_count_7 <= as_number(((((slice2shift_search_1_8 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_8 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_8 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_9_count_0 <= as_number((((slice2shift_search_1_9 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_9 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_9 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_9_count_1 <= as_number(((((slice2shift_search_1_9 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_9 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_9 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_9_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_9 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_9 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_9 / 64) mod 2) = 1)
        /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_9_count_3 <= as_number(((((slice2shift_search_1_9 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_9 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_9 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_9_count_4 <= as_number(((((slice2shift_search_1_9 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_9 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_9 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_9_count_5 <= as_number(((((slice2shift_search_1_9 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_9 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_9 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_9_count_6 <= as_number(((((slice2shift_search_1_9 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_9 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_9 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_9_count_7 <= as_number(((((slice2shift_search_1_9 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_9 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_9 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_10_count_0 <= as_number((((slice2shift_search_1_10 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_10 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_10 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_10_count_1 <= as_number(((((slice2shift_search_1_10 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_10 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_10 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_10_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_10 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_10 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_10 / 64) mod 2) =
        1) /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_10_count_3 <= as_number(((((slice2shift_search_1_10 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_10 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_10 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_10_count_4 <= as_number(((((slice2shift_search_1_10 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_10 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_10 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_10_count_5 <= as_number(((((slice2shift_search_1_10 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_10 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_10 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_10_count_6 <= as_number(((((slice2shift_search_1_10 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_10 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_10 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_10_count_7 <= as_number(((((slice2shift_search_1_10 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_10 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_10 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_11_count_0 <= as_number((((slice2shift_search_1_11 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_11 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_11 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_11_count_1 <= as_number(((((slice2shift_search_1_11 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_11 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_11 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_11_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_11 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_11 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_11 / 64) mod 2) =
        1) /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_11_count_3 <= as_number(((((slice2shift_search_1_11 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_11 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_11 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_11_count_4 <= as_number(((((slice2shift_search_1_11 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_11 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_11 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_11_count_5 <= as_number(((((slice2shift_search_1_11 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_11 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_11 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_11_count_6 <= as_number(((((slice2shift_search_1_11 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_11 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_11 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_11_count_7 <= as_number(((((slice2shift_search_1_11 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_11 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_11 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_12_count_0 <= as_number((((slice2shift_search_1_12 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_12 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_12 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_12_count_1 <= as_number(((((slice2shift_search_1_12 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_12 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_12 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_12_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_12 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_12 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_12 / 64) mod 2) =
        1) /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_12_count_3 <= as_number(((((slice2shift_search_1_12 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_12 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_12 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_12_count_4 <= as_number(((((slice2shift_search_1_12 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_12 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_12 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_12_count_5 <= as_number(((((slice2shift_search_1_12 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_12 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_12 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_12_count_6 <= as_number(((((slice2shift_search_1_12 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_12 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_12 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_12_count_7 <= as_number(((((slice2shift_search_1_12 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_12 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_12 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_13_count_0 <= as_number((((slice2shift_search_1_13 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_13 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_13 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_13_count_1 <= as_number(((((slice2shift_search_1_13 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_13 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_13 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_13_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_13 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_13 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_13 / 64) mod 2) =
        1) /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_13_count_3 <= as_number(((((slice2shift_search_1_13 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_13 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_13 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_13_count_4 <= as_number(((((slice2shift_search_1_13 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_13 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_13 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_13_count_5 <= as_number(((((slice2shift_search_1_13 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_13 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_13 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_13_count_6 <= as_number(((((slice2shift_search_1_13 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_13 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_13 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_13_count_7 <= as_number(((((slice2shift_search_1_13 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_13 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_13 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_14_count_0 <= as_number((((slice2shift_search_1_14 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_14 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_14 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_14_count_1 <= as_number(((((slice2shift_search_1_14 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_14 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_14 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_14_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_14 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_14 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_14 / 64) mod 2) =
        1) /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_14_count_3 <= as_number(((((slice2shift_search_1_14 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_14 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_14 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_14_count_4 <= as_number(((((slice2shift_search_1_14 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_14 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_14 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_14_count_5 <= as_number(((((slice2shift_search_1_14 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_14 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_14 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_14_count_6 <= as_number(((((slice2shift_search_1_14 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_14 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_14 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_14_count_7 <= as_number(((((slice2shift_search_1_14 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_14 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_14 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_first_1_15_count_0 <= as_number((((slice2shift_search_1_15 mod 2) = 1) /=
        ((slice2shift_reference_1 mod 2) = 1))) + as_number(((((slice2shift_search_1_15 / 4) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value)) + as_number(((((slice2shift_search_1_15 / 2) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_0_value_2));
      slice2cost_pixels_first_1_15_count_1 <= as_number(((((slice2shift_search_1_15 / 8) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value)) + as_number(((((slice2shift_search_1_15 / 32) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_2)) + as_number(((((slice2shift_search_1_15 / 16) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_1_value_3));
      slice2cost_pixels_first_1_15_count_2 <= (to_integer(((to_unsigned((slice2shift_search_1_15 mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_1 mod 256), 8)))) / 128) + as_number(((((slice2shift_search_1_15 / 256) mod
        2) = 1) /= slice2cost_pixels_first_1_0_count_2_value)) + as_number(((((slice2shift_search_1_15 / 64) mod 2) =
        1) /= slice2cost_pixels_first_1_0_count_2_value_2));
      slice2cost_pixels_first_1_15_count_3 <= as_number(((((slice2shift_search_1_15 / 512) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value)) + as_number(((((slice2shift_search_1_15 / 2048) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_2)) + as_number(((((slice2shift_search_1_15 / 1024) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_3_value_3));
      slice2cost_pixels_first_1_15_count_4 <= as_number(((((slice2shift_search_1_15 / 4096) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value)) + as_number(((((slice2shift_search_1_15 / 16384) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_2)) + as_number(((((slice2shift_search_1_15 / 8192) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_4_value_3));
      slice2cost_pixels_first_1_15_count_5 <= as_number(((((slice2shift_search_1_15 / 32768) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value)) + as_number(((((slice2shift_search_1_15 / 131072) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_2)) + as_number(((((slice2shift_search_1_15 / 65536) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_5_value_3));
      slice2cost_pixels_first_1_15_count_6 <= as_number(((((slice2shift_search_1_15 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value)) + as_number(((((slice2shift_search_1_15 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_2)) + as_number(((((slice2shift_search_1_15 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_6_value_3));
      slice2cost_pixels_first_1_15_count_7 <= as_number(((((slice2shift_search_1_15 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value)) + as_number((((slice2shift_search_1_15 / 8388608) = 1) /=
        ((slice2shift_reference_1 / 8388608) = 1))) + as_number(((((slice2shift_search_1_15 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_1_0_count_7_value_2));
      slice2cost_pixels_cost_0_0 <= slice2cost_pixels_first_0_0_count_0 + slice2cost_pixels_first_0_0_count_2 +
        slice2cost_pixels_first_0_0_count_3 + slice2cost_pixels_first_0_0_count_5 + slice2cost_pixels_first_0_0_count_6
        + slice2cost_pixels_first_0_0_count_4 + slice2cost_pixels_first_0_0_count_7 +
        slice2cost_pixels_first_0_0_count_1;
      slice2cost_pixels_cost_0_1 <= slice2cost_pixels_first_0_1_count_0 + slice2cost_pixels_first_0_1_count_2 +
        slice2cost_pixels_first_0_1_count_3 + slice2cost_pixels_first_0_1_count_5 + slice2cost_pixels_first_0_1_count_6
        + slice2cost_pixels_first_0_1_count_4 + slice2cost_pixels_first_0_1_count_7 +
        slice2cost_pixels_first_0_1_count_1;
      slice2cost_pixels_cost_0_2 <= slice2cost_pixels_first_0_2_count_0 + slice2cost_pixels_first_0_2_count_2 +
        slice2cost_pixels_first_0_2_count_3 + slice2cost_pixels_first_0_2_count_5 + slice2cost_pixels_first_0_2_count_6
        + slice2cost_pixels_first_0_2_count_4 + slice2cost_pixels_first_0_2_count_7 +
        slice2cost_pixels_first_0_2_count_1;
      slice2cost_pixels_cost_0_3 <= slice2cost_pixels_first_0_3_count_0 + slice2cost_pixels_first_0_3_count_2 +
        slice2cost_pixels_first_0_3_count_3 + slice2cost_pixels_first_0_3_count_5 + slice2cost_pixels_first_0_3_count_6
        + slice2cost_pixels_first_0_3_count_4 + slice2cost_pixels_first_0_3_count_7 +
        slice2cost_pixels_first_0_3_count_1;
      slice2cost_pixels_cost_0_4 <= slice2cost_pixels_first_0_4_count_0 + slice2cost_pixels_first_0_4_count_2 +
        slice2cost_pixels_first_0_4_count_3 + slice2cost_pixels_first_0_4_count_5 + slice2cost_pixels_first_0_4_count_6
        + slice2cost_pixels_first_0_4_count_4 + slice2cost_pixels_first_0_4_count_7 +
        slice2cost_pixels_first_0_4_count_1;
      slice2cost_pixels_cost_0_5 <= slice2cost_pixels_first_0_5_count_0 + slice2cost_pixels_first_0_5_count_2 +
        slice2cost_pixels_first_0_5_count_3 + slice2cost_pixels_first_0_5_count_5 + slice2cost_pixels_first_0_5_count_6
        + slice2cost_pixels_first_0_5_count_4 + slice2cost_pixels_first_0_5_count_7 +
        slice2cost_pixels_first_0_5_count_1;
      slice2cost_pixels_cost_0_6 <= slice2cost_pixels_first_0_6_count_0 + slice2cost_pixels_first_0_6_count_2 +
        slice2cost_pixels_first_0_6_count_3 + slice2cost_pixels_first_0_6_count_5 + slice2cost_pixels_first_0_6_count_6
        + slice2cost_pixels_first_0_6_count_4 + slice2cost_pixels_first_0_6_count_7 +
        slice2cost_pixels_first_0_6_count_1;
      slice2cost_pixels_cost_0_7 <= slice2cost_pixels_first_0_7_count_0 + slice2cost_pixels_first_0_7_count_2 +
        slice2cost_pixels_first_0_7_count_3 + slice2cost_pixels_first_0_7_count_5 + slice2cost_pixels_first_0_7_count_6
        + slice2cost_pixels_first_0_7_count_4 + slice2cost_pixels_first_0_7_count_7 +
        slice2cost_pixels_first_0_7_count_1;
      slice2cost_pixels_cost_0_8 <= slice2cost_pixels_first_0_8_count_0 + slice2cost_pixels_first_0_8_count_2 +
        slice2cost_pixels_first_0_8_count_3 + slice2cost_pixels_first_0_8_count_5 + slice2cost_pixels_first_0_8_count_6
        + slice2cost_pixels_first_0_8_count_4 + slice2cost_pixels_first_0_8_count_7 +
        slice2cost_pixels_first_0_8_count_1;
      slice2cost_pixels_cost_0_9 <= slice2cost_pixels_first_0_9_count_0 + slice2cost_pixels_first_0_9_count_2 +
        slice2cost_pixels_first_0_9_count_3 + slice2cost_pixels_first_0_9_count_5 + slice2cost_pixels_first_0_9_count_6
        + slice2cost_pixels_first_0_9_count_4 + slice2cost_pixels_first_0_9_count_7 +
        slice2cost_pixels_first_0_9_count_1;
      slice2cost_pixels_cost_0_10 <= slice2cost_pixels_first_0_10_count_0 + slice2cost_pixels_first_0_10_count_2 +
        slice2cost_pixels_first_0_10_count_3 + slice2cost_pixels_first_0_10_count_5 +
        slice2cost_pixels_first_0_10_count_6 + slice2cost_pixels_first_0_10_count_4 +
        slice2cost_pixels_first_0_10_count_7 + slice2cost_pixels_first_0_10_count_1;
      slice2cost_pixels_cost_0_11 <= slice2cost_pixels_first_0_11_count_0 + slice2cost_pixels_first_0_11_count_2 +
        slice2cost_pixels_first_0_11_count_3 + slice2cost_pixels_first_0_11_count_5 +
        slice2cost_pixels_first_0_11_count_6 + slice2cost_pixels_first_0_11_count_4 +
        slice2cost_pixels_first_0_11_count_7 + slice2cost_pixels_first_0_11_count_1;
      slice2cost_pixels_cost_0_12 <= slice2cost_pixels_first_0_12_count_0 + slice2cost_pixels_first_0_12_count_2 +
        slice2cost_pixels_first_0_12_count_3 + slice2cost_pixels_first_0_12_count_5 +
        slice2cost_pixels_first_0_12_count_6 + slice2cost_pixels_first_0_12_count_4 +
        slice2cost_pixels_first_0_12_count_7 + slice2cost_pixels_first_0_12_count_1;
      slice2cost_pixels_cost_0_13 <= slice2cost_pixels_first_0_13_count_0 + slice2cost_pixels_first_0_13_count_2 +
        slice2cost_pixels_first_0_13_count_3 + slice2cost_pixels_first_0_13_count_5 +
        slice2cost_pixels_first_0_13_count_6 + slice2cost_pixels_first_0_13_count_4 +
        slice2cost_pixels_first_0_13_count_7 + slice2cost_pixels_first_0_13_count_1;
      slice2cost_pixels_cost_0_14 <= slice2cost_pixels_first_0_14_count_0 + slice2cost_pixels_first_0_14_count_2 +
        slice2cost_pixels_first_0_14_count_3 + slice2cost_pixels_first_0_14_count_5 +
        slice2cost_pixels_first_0_14_count_6 + slice2cost_pixels_first_0_14_count_4 +
        slice2cost_pixels_first_0_14_count_7 + slice2cost_pixels_first_0_14_count_1;
      slice2cost_pixels_cost_0_15 <= slice2cost_pixels_first_0_15_count_0 + slice2cost_pixels_first_0_15_count_2 +
        slice2cost_pixels_first_0_15_count_3 + slice2cost_pixels_first_0_15_count_5 +
        slice2cost_pixels_first_0_15_count_6 + slice2cost_pixels_first_0_15_count_4 +
        slice2cost_pixels_first_0_15_count_7 + slice2cost_pixels_first_0_15_count_1;
      slice2cost_pixels_cost_1_0 <= slice2cost_pixels_first_1_0_count_0 + slice2cost_pixels_first_1_0_count_2 +
        slice2cost_pixels_first_1_0_count_3 + slice2cost_pixels_first_1_0_count_5 + slice2cost_pixels_first_1_0_count_6
        + slice2cost_pixels_first_1_0_count_4 + slice2cost_pixels_first_1_0_count_7 +
        slice2cost_pixels_first_1_0_count_1;
      slice2cost_pixels_cost_1_1 <= slice2cost_pixels_first_1_1_count_0 + slice2cost_pixels_first_1_1_count_2 +
        slice2cost_pixels_first_1_1_count_3 + slice2cost_pixels_first_1_1_count_5 + slice2cost_pixels_first_1_1_count_6
        + slice2cost_pixels_first_1_1_count_4 + slice2cost_pixels_first_1_1_count_7 +
        slice2cost_pixels_first_1_1_count_1;
      slice2cost_pixels_cost_1_2 <= slice2cost_pixels_first_1_2_count_0 + slice2cost_pixels_first_1_2_count_2 +
        slice2cost_pixels_first_1_2_count_3 + slice2cost_pixels_first_1_2_count_5 + slice2cost_pixels_first_1_2_count_6
        + slice2cost_pixels_first_1_2_count_4 + slice2cost_pixels_first_1_2_count_7 +
        slice2cost_pixels_first_1_2_count_1;
      slice2cost_pixels_cost_1_3 <= slice2cost_pixels_first_1_3_count_0 + slice2cost_pixels_first_1_3_count_2 +
        slice2cost_pixels_first_1_3_count_3 + slice2cost_pixels_first_1_3_count_5 + slice2cost_pixels_first_1_3_count_6
        + slice2cost_pixels_first_1_3_count_4 + slice2cost_pixels_first_1_3_count_7 +
        slice2cost_pixels_first_1_3_count_1;
      slice2cost_pixels_cost_1_4 <= slice2cost_pixels_first_1_4_count_0 + slice2cost_pixels_first_1_4_count_2 +
        slice2cost_pixels_first_1_4_count_3 + slice2cost_pixels_first_1_4_count_5 + slice2cost_pixels_first_1_4_count_6
        + slice2cost_pixels_first_1_4_count_4 + slice2cost_pixels_first_1_4_count_7 +
        slice2cost_pixels_first_1_4_count_1;
      slice2cost_pixels_cost_1_5 <= slice2cost_pixels_first_1_5_count_0 + slice2cost_pixels_first_1_5_count_2 +
        slice2cost_pixels_first_1_5_count_3 + slice2cost_pixels_first_1_5_count_5 + slice2cost_pixels_first_1_5_count_6
        + slice2cost_pixels_first_1_5_count_4 + slice2cost_pixels_first_1_5_count_7 +
        slice2cost_pixels_first_1_5_count_1;
      slice2cost_pixels_cost_1_6 <= slice2cost_pixels_first_1_6_count_0 + slice2cost_pixels_first_1_6_count_2 +
        slice2cost_pixels_first_1_6_count_3 + slice2cost_pixels_first_1_6_count_5 + slice2cost_pixels_first_1_6_count_6
        + slice2cost_pixels_first_1_6_count_4 + slice2cost_pixels_first_1_6_count_7 +
        slice2cost_pixels_first_1_6_count_1;
      slice2cost_pixels_cost_1_7 <= slice2cost_pixels_first_1_7_count_0 + slice2cost_pixels_first_1_7_count_2 +
        slice2cost_pixels_first_1_7_count_3 + slice2cost_pixels_first_1_7_count_5 + slice2cost_pixels_first_1_7_count_6
        + slice2cost_pixels_first_1_7_count_4 + slice2cost_pixels_first_1_7_count_7 +
        slice2cost_pixels_first_1_7_count_1;
      slice2cost_pixels_cost_1_8 <= slice2cost_pixels_first_1_8_count_0 + slice2cost_pixels_first_1_8_count_2 +
        slice2cost_pixels_first_1_8_count_3 + slice2cost_pixels_first_1_8_count_5 + slice2cost_pixels_first_1_8_count_6
        + slice2cost_pixels_first_1_8_count_4 + slice2cost_pixels_first_1_8_count_7 +
        slice2cost_pixels_first_1_8_count_1;
      slice2cost_pixels_cost_1_9 <= slice2cost_pixels_first_1_9_count_0 + slice2cost_pixels_first_1_9_count_2 +
        slice2cost_pixels_first_1_9_count_3 + slice2cost_pixels_first_1_9_count_5 + slice2cost_pixels_first_1_9_count_6
        + slice2cost_pixels_first_1_9_count_4 + slice2cost_pixels_first_1_9_count_7 +
        slice2cost_pixels_first_1_9_count_1;
      slice2cost_pixels_cost_1_10 <= slice2cost_pixels_first_1_10_count_0 + slice2cost_pixels_first_1_10_count_2 +
        slice2cost_pixels_first_1_10_count_3 + slice2cost_pixels_first_1_10_count_5 +
        slice2cost_pixels_first_1_10_count_6 + slice2cost_pixels_first_1_10_count_4 +
        slice2cost_pixels_first_1_10_count_7 + slice2cost_pixels_first_1_10_count_1;
      slice2cost_pixels_cost_1_11 <= slice2cost_pixels_first_1_11_count_0 + slice2cost_pixels_first_1_11_count_2 +
        slice2cost_pixels_first_1_11_count_3 + slice2cost_pixels_first_1_11_count_5 +
        slice2cost_pixels_first_1_11_count_6 + slice2cost_pixels_first_1_11_count_4 +
        slice2cost_pixels_first_1_11_count_7 + slice2cost_pixels_first_1_11_count_1;
      slice2cost_pixels_cost_1_12 <= slice2cost_pixels_first_1_12_count_0 + slice2cost_pixels_first_1_12_count_2 +
        slice2cost_pixels_first_1_12_count_3 + slice2cost_pixels_first_1_12_count_5 +
        slice2cost_pixels_first_1_12_count_6 + slice2cost_pixels_first_1_12_count_4 +
        slice2cost_pixels_first_1_12_count_7 + slice2cost_pixels_first_1_12_count_1;
      slice2cost_pixels_cost_1_13 <= slice2cost_pixels_first_1_13_count_0 + slice2cost_pixels_first_1_13_count_2 +
        slice2cost_pixels_first_1_13_count_3 + slice2cost_pixels_first_1_13_count_5 +
        slice2cost_pixels_first_1_13_count_6 + slice2cost_pixels_first_1_13_count_4 +
        slice2cost_pixels_first_1_13_count_7 + slice2cost_pixels_first_1_13_count_1;
      slice2cost_pixels_cost_1_14 <= slice2cost_pixels_first_1_14_count_0 + slice2cost_pixels_first_1_14_count_2 +
        slice2cost_pixels_first_1_14_count_3 + slice2cost_pixels_first_1_14_count_5 +
        slice2cost_pixels_first_1_14_count_6 + slice2cost_pixels_first_1_14_count_4 +
        slice2cost_pixels_first_1_14_count_7 + slice2cost_pixels_first_1_14_count_1;
      slice2cost_pixels_cost_1_15 <= slice2cost_pixels_first_1_15_count_0 + slice2cost_pixels_first_1_15_count_2 +
        slice2cost_pixels_first_1_15_count_3 + slice2cost_pixels_first_1_15_count_5 +
        slice2cost_pixels_first_1_15_count_6 + slice2cost_pixels_first_1_15_count_4 +
        slice2cost_pixels_first_1_15_count_7 + slice2cost_pixels_first_1_15_count_1;
      slice2cost_change_column <= slice2cost_read_column;
      slice2cost_change_0_0 <= slice2cost_pixels_cost_1_0 - slice2cost_pixels_cost_0_0;
      slice2cost_change_0_1 <= slice2cost_pixels_cost_1_1 - slice2cost_pixels_cost_0_1;
      slice2cost_change_0_2 <= slice2cost_pixels_cost_1_2 - slice2cost_pixels_cost_0_2;
      slice2cost_change_0_3 <= slice2cost_pixels_cost_1_3 - slice2cost_pixels_cost_0_3;
      slice2cost_change_0_4 <= slice2cost_pixels_cost_1_4 - slice2cost_pixels_cost_0_4;
      slice2cost_change_0_5 <= slice2cost_pixels_cost_1_5 - slice2cost_pixels_cost_0_5;
      slice2cost_change_0_6 <= slice2cost_pixels_cost_1_6 - slice2cost_pixels_cost_0_6;
      slice2cost_change_0_7 <= slice2cost_pixels_cost_1_7 - slice2cost_pixels_cost_0_7;
      slice2cost_change_0_8 <= slice2cost_pixels_cost_1_8 - slice2cost_pixels_cost_0_8;
      slice2cost_change_0_9 <= slice2cost_pixels_cost_1_9 - slice2cost_pixels_cost_0_9;
      slice2cost_change_0_10 <= slice2cost_pixels_cost_1_10 - slice2cost_pixels_cost_0_10;
      slice2cost_change_0_11 <= slice2cost_pixels_cost_1_11 - slice2cost_pixels_cost_0_11;
      slice2cost_change_0_12 <= slice2cost_pixels_cost_1_12 - slice2cost_pixels_cost_0_12;
      slice2cost_change_0_13 <= slice2cost_pixels_cost_1_13 - slice2cost_pixels_cost_0_13;
      slice2cost_change_0_14 <= slice2cost_pixels_cost_1_14 - slice2cost_pixels_cost_0_14;
      slice2cost_change_0_15 <= slice2cost_pixels_cost_1_15 - slice2cost_pixels_cost_0_15;
      slice2cost_ready_words_0 <= slice2cost_read_words_0;
      slice2cost_ready_words_1 <= slice2cost_read_words_1;
      slice2cost_ready_words_2 <= slice2cost_read_words_2;
      slice2cost_ready_words_3 <= slice2cost_read_words_3;
      slice2cost_ready_column <= slice2cost_change_column;
      slice2cost_column_0_0 <= slice2cost_column_0_0_value;
      slice2cost_column_0_1 <= slice2cost_column_0_1_value;
      slice2cost_column_0_2 <= slice2cost_column_0_2_value;
      slice2cost_column_0_3 <= slice2cost_column_0_3_value;
      slice2cost_column_0_4 <= slice2cost_column_0_4_value;
      slice2cost_column_0_5 <= slice2cost_column_0_5_value;
      slice2cost_column_0_6 <= slice2cost_column_0_6_value;
      slice2cost_column_0_7 <= slice2cost_column_0_7_value;
      slice2cost_column_0_8 <= slice2cost_column_0_8_value;
      slice2cost_column_0_9 <= slice2cost_column_0_9_value;
      slice2cost_column_0_10 <= slice2cost_column_0_10_value;
      slice2cost_column_0_11 <= slice2cost_column_0_11_value;
      slice2cost_column_0_12 <= slice2cost_column_0_12_value;
      slice2cost_column_0_13 <= slice2cost_column_0_13_value;
      slice2cost_column_0_14 <= slice2cost_column_0_14_value;
      slice2cost_column_0_15 <= slice2cost_column_0_15_value;
      if slice0cost_pixels_tag_valid then
        if slice0cost_pixels_tag_row_start then
          slice2cost_read_column <= 0;
        else
          slice2cost_read_column <= (slice2cost_read_column + 1) mod 512;
        end if;
      end if;
      if slice0window_entering_tag_valid then
        slice2cost_write_column <= slice2cost_ready_column;
        slice2cost_write_words_0 <= to_unsigned(slice2cost_column_0_3_value, 8) &
          to_unsigned(slice2cost_column_0_2_value, 8) & to_unsigned(slice2cost_column_0_1_value, 8) &
          to_unsigned(slice2cost_column_0_0_value, 8);
        slice2cost_write_words_1 <= to_unsigned(slice2cost_column_0_7_value, 8) &
          to_unsigned(slice2cost_column_0_6_value, 8) & to_unsigned(slice2cost_column_0_5_value, 8) &
          to_unsigned(slice2cost_column_0_4_value, 8);
        slice2cost_write_words_2 <= to_unsigned(slice2cost_column_0_11_value, 8) &
          to_unsigned(slice2cost_column_0_10_value, 8) & to_unsigned(slice2cost_column_0_9_value, 8) &
          to_unsigned(slice2cost_column_0_8_value, 8);
        slice2cost_write_words_3 <= to_unsigned(slice2cost_column_0_15_value, 8) &
          to_unsigned(slice2cost_column_0_14_value, 8) & to_unsigned(slice2cost_column_0_13_value, 8) &
          to_unsigned(slice2cost_column_0_12_value, 8);
      end if;
      -- slice2window
      if slice0window_change_tag_valid then
        slice2window_ring_write_address <= slice2window_ring_read_address;
        if slice2window_ring_read_address = 9 then
          slice2window_ring_read_address <= 0;
        else
          slice2window_ring_read_address <= (slice2window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_0_choice := to_integer(slice2window_leaving_0(7 downto 0));
      else
        slice2window_change_0_0_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_1_choice := to_integer(slice2window_leaving_0(15 downto 8));
      else
        slice2window_change_0_1_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_2_choice := to_integer(slice2window_leaving_0(23 downto 16));
      else
        slice2window_change_0_2_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_3_choice := to_integer(slice2window_leaving_0(31 downto 24));
      else
        slice2window_change_0_3_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_4_choice := to_integer(slice2window_leaving_1(7 downto 0));
      else
        slice2window_change_0_4_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_5_choice := to_integer(slice2window_leaving_1(15 downto 8));
      else
        slice2window_change_0_5_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_6_choice := to_integer(slice2window_leaving_1(23 downto 16));
      else
        slice2window_change_0_6_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_7_choice := to_integer(slice2window_leaving_1(31 downto 24));
      else
        slice2window_change_0_7_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_8_choice := to_integer(slice2window_leaving_2(7 downto 0));
      else
        slice2window_change_0_8_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_9_choice := to_integer(slice2window_leaving_2(15 downto 8));
      else
        slice2window_change_0_9_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_10_choice := to_integer(slice2window_leaving_2(23 downto 16));
      else
        slice2window_change_0_10_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_11_choice := to_integer(slice2window_leaving_2(31 downto 24));
      else
        slice2window_change_0_11_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_12_choice := to_integer(slice2window_leaving_3(7 downto 0));
      else
        slice2window_change_0_12_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_13_choice := to_integer(slice2window_leaving_3(15 downto 8));
      else
        slice2window_change_0_13_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_14_choice := to_integer(slice2window_leaving_3(23 downto 16));
      else
        slice2window_change_0_14_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_15_choice := to_integer(slice2window_leaving_3(31 downto 24));
      else
        slice2window_change_0_15_choice := 0;
      end if;
      slice2window_entering_0_0 <= slice2cost_column_0_0;
      slice2window_entering_0_1 <= slice2cost_column_0_1;
      slice2window_entering_0_2 <= slice2cost_column_0_2;
      slice2window_entering_0_3 <= slice2cost_column_0_3;
      slice2window_entering_0_4 <= slice2cost_column_0_4;
      slice2window_entering_0_5 <= slice2cost_column_0_5;
      slice2window_entering_0_6 <= slice2cost_column_0_6;
      slice2window_entering_0_7 <= slice2cost_column_0_7;
      slice2window_entering_0_8 <= slice2cost_column_0_8;
      slice2window_entering_0_9 <= slice2cost_column_0_9;
      slice2window_entering_0_10 <= slice2cost_column_0_10;
      slice2window_entering_0_11 <= slice2cost_column_0_11;
      slice2window_entering_0_12 <= slice2cost_column_0_12;
      slice2window_entering_0_13 <= slice2cost_column_0_13;
      slice2window_entering_0_14 <= slice2cost_column_0_14;
      slice2window_entering_0_15 <= slice2cost_column_0_15;
      slice2window_change_0_0 <= slice2window_entering_0_0 - slice2window_change_0_0_choice;
      slice2window_change_0_1 <= slice2window_entering_0_1 - slice2window_change_0_1_choice;
      slice2window_change_0_2 <= slice2window_entering_0_2 - slice2window_change_0_2_choice;
      slice2window_change_0_3 <= slice2window_entering_0_3 - slice2window_change_0_3_choice;
      slice2window_change_0_4 <= slice2window_entering_0_4 - slice2window_change_0_4_choice;
      slice2window_change_0_5 <= slice2window_entering_0_5 - slice2window_change_0_5_choice;
      slice2window_change_0_6 <= slice2window_entering_0_6 - slice2window_change_0_6_choice;
      slice2window_change_0_7 <= slice2window_entering_0_7 - slice2window_change_0_7_choice;
      slice2window_change_0_8 <= slice2window_entering_0_8 - slice2window_change_0_8_choice;
      slice2window_change_0_9 <= slice2window_entering_0_9 - slice2window_change_0_9_choice;
      slice2window_change_0_10 <= slice2window_entering_0_10 - slice2window_change_0_10_choice;
      slice2window_change_0_11 <= slice2window_entering_0_11 - slice2window_change_0_11_choice;
      slice2window_change_0_12 <= slice2window_entering_0_12 - slice2window_change_0_12_choice;
      slice2window_change_0_13 <= slice2window_entering_0_13 - slice2window_change_0_13_choice;
      slice2window_change_0_14 <= slice2window_entering_0_14 - slice2window_change_0_14_choice;
      slice2window_change_0_15 <= slice2window_entering_0_15 - slice2window_change_0_15_choice;
      slice2window_change_tag_row_start <= slice1window_change_tag_row_start;
      if slice0window_tag_valid then
        slice2window_change_tag_first_column <= slice1window_change_tag_first_column;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_0_choice := 0;
      else
        slice2window_sum_0_0_choice := slice2window_sum_0_0;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_1_choice := 0;
      else
        slice2window_sum_0_1_choice := slice2window_sum_0_1;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_2_choice := 0;
      else
        slice2window_sum_0_2_choice := slice2window_sum_0_2;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_3_choice := 0;
      else
        slice2window_sum_0_3_choice := slice2window_sum_0_3;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_4_choice := 0;
      else
        slice2window_sum_0_4_choice := slice2window_sum_0_4;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_5_choice := 0;
      else
        slice2window_sum_0_5_choice := slice2window_sum_0_5;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_6_choice := 0;
      else
        slice2window_sum_0_6_choice := slice2window_sum_0_6;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_7_choice := 0;
      else
        slice2window_sum_0_7_choice := slice2window_sum_0_7;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_8_choice := 0;
      else
        slice2window_sum_0_8_choice := slice2window_sum_0_8;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_9_choice := 0;
      else
        slice2window_sum_0_9_choice := slice2window_sum_0_9;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_10_choice := 0;
      else
        slice2window_sum_0_10_choice := slice2window_sum_0_10;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_11_choice := 0;
      else
        slice2window_sum_0_11_choice := slice2window_sum_0_11;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_12_choice := 0;
      else
        slice2window_sum_0_12_choice := slice2window_sum_0_12;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_13_choice := 0;
      else
        slice2window_sum_0_13_choice := slice2window_sum_0_13;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_14_choice := 0;
      else
        slice2window_sum_0_14_choice := slice2window_sum_0_14;
      end if;
      if slice2window_change_tag_row_start then
        slice2window_sum_0_15_choice := 0;
      else
        slice2window_sum_0_15_choice := slice2window_sum_0_15;
      end if;
      if slice0winner1_tag_valid then
        slice2window_sum_0_0 <= (slice2window_sum_0_0_choice + slice2window_change_0_0) mod 2048;
        slice2window_sum_0_1 <= (slice2window_sum_0_1_choice + slice2window_change_0_1) mod 2048;
        slice2window_sum_0_2 <= (slice2window_sum_0_2_choice + slice2window_change_0_2) mod 2048;
        slice2window_sum_0_3 <= (slice2window_sum_0_3_choice + slice2window_change_0_3) mod 2048;
        slice2window_sum_0_4 <= (slice2window_sum_0_4_choice + slice2window_change_0_4) mod 2048;
        slice2window_sum_0_5 <= (slice2window_sum_0_5_choice + slice2window_change_0_5) mod 2048;
        slice2window_sum_0_6 <= (slice2window_sum_0_6_choice + slice2window_change_0_6) mod 2048;
        slice2window_sum_0_7 <= (slice2window_sum_0_7_choice + slice2window_change_0_7) mod 2048;
        slice2window_sum_0_8 <= (slice2window_sum_0_8_choice + slice2window_change_0_8) mod 2048;
        slice2window_sum_0_9 <= (slice2window_sum_0_9_choice + slice2window_change_0_9) mod 2048;
        slice2window_sum_0_10 <= (slice2window_sum_0_10_choice + slice2window_change_0_10) mod 2048;
        slice2window_sum_0_11 <= (slice2window_sum_0_11_choice + slice2window_change_0_11) mod 2048;
        slice2window_sum_0_12 <= (slice2window_sum_0_12_choice + slice2window_change_0_12) mod 2048;
        slice2window_sum_0_13 <= (slice2window_sum_0_13_choice + slice2window_change_0_13) mod 2048;
        slice2window_sum_0_14 <= (slice2window_sum_0_14_choice + slice2window_change_0_14) mod 2048;
        slice2window_sum_0_15 <= (slice2window_sum_0_15_choice + slice2window_change_0_15) mod 2048;
        slice2window_centre_map_column_0 <= slice1window_centre_map_column_0;
        slice2window_centre_map_column_1 <= slice2window_centre_map_column_0;
        slice2window_centre_map_column_2 <= slice2window_centre_map_column_1;
        slice2window_centre_first_column_0 <= slice1window_centre_first_column_0;
        slice2window_centre_first_column_1 <= slice2window_centre_first_column_0;
        slice2window_centre_first_column_2 <= slice2window_centre_first_column_1;
        slice2window_centre_start_of_frame_0 <= slice1window_centre_start_of_frame_0;
        slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
        slice2window_centre_end_of_line_1 <= slice2window_centre_end_of_line_0;
        slice2window_centre_end_of_line_2 <= slice2window_centre_end_of_line_1;
      end if;
      -- slice2mask
      slice2mask_inside_0_all := (not slice0winner1_tag_valid) and slice2mask_inside_0;
      if slice0winner1_tag_first_column then
        slice2mask_inside_0_choice := slice2mask_inside_0_all;
      else
        slice2mask_inside_0_choice := slice0winner1_tag_valid or slice2mask_inside_0;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_1_choice := slice2mask_inside_0;
      else
        slice2mask_inside_1_choice := slice2mask_inside_1;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_2_choice := slice2mask_inside_1;
      else
        slice2mask_inside_2_choice := slice2mask_inside_2;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_3_choice := slice2mask_inside_2;
      else
        slice2mask_inside_3_choice := slice2mask_inside_3;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_4_choice := slice2mask_inside_3;
      else
        slice2mask_inside_4_choice := slice2mask_inside_4;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_5_choice := slice2mask_inside_4;
      else
        slice2mask_inside_5_choice := slice2mask_inside_5;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_6_choice := slice2mask_inside_5;
      else
        slice2mask_inside_6_choice := slice2mask_inside_6;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_7_choice := slice2mask_inside_6;
      else
        slice2mask_inside_7_choice := slice2mask_inside_7;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_8_choice := slice2mask_inside_7;
      else
        slice2mask_inside_8_choice := slice2mask_inside_8;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_9_choice := slice2mask_inside_8;
      else
        slice2mask_inside_9_choice := slice2mask_inside_9;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_10_choice := slice2mask_inside_9;
      else
        slice2mask_inside_10_choice := slice2mask_inside_10;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_11_choice := slice2mask_inside_10;
      else
        slice2mask_inside_11_choice := slice2mask_inside_11;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_12_choice := slice2mask_inside_11;
      else
        slice2mask_inside_12_choice := slice2mask_inside_12;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_13_choice := slice2mask_inside_12;
      else
        slice2mask_inside_13_choice := slice2mask_inside_13;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_14_choice := slice2mask_inside_13;
      else
        slice2mask_inside_14_choice := slice2mask_inside_14;
      end if;
      if slice0winner1_tag_valid then
        slice2mask_inside_15_choice := slice2mask_inside_14;
      else
        slice2mask_inside_15_choice := slice2mask_inside_15;
      end if;
      if slice1mask_left_out then
        slice2mask_inside_0 <= slice2mask_inside_0_choice;
      else
        slice2mask_inside_0 <= slice2mask_inside_0_all;
      end if;
      if slice0winner1_tag_first_column then
        slice2mask_inside_1 <= (not slice0winner1_tag_valid) and slice2mask_inside_1;
        slice2mask_inside_2 <= (not slice0winner1_tag_valid) and slice2mask_inside_2;
        slice2mask_inside_3 <= (not slice0winner1_tag_valid) and slice2mask_inside_3;
        slice2mask_inside_4 <= (not slice0winner1_tag_valid) and slice2mask_inside_4;
        slice2mask_inside_5 <= (not slice0winner1_tag_valid) and slice2mask_inside_5;
        slice2mask_inside_6 <= (not slice0winner1_tag_valid) and slice2mask_inside_6;
        slice2mask_inside_7 <= (not slice0winner1_tag_valid) and slice2mask_inside_7;
        slice2mask_inside_8 <= (not slice0winner1_tag_valid) and slice2mask_inside_8;
        slice2mask_inside_9 <= (not slice0winner1_tag_valid) and slice2mask_inside_9;
        slice2mask_inside_10 <= (not slice0winner1_tag_valid) and slice2mask_inside_10;
        slice2mask_inside_11 <= (not slice0winner1_tag_valid) and slice2mask_inside_11;
        slice2mask_inside_12 <= (not slice0winner1_tag_valid) and slice2mask_inside_12;
        slice2mask_inside_13 <= (not slice0winner1_tag_valid) and slice2mask_inside_13;
        slice2mask_inside_14 <= (not slice0winner1_tag_valid) and slice2mask_inside_14;
        slice2mask_inside_15 <= (not slice0winner1_tag_valid) and slice2mask_inside_15;
      else
        slice2mask_inside_1 <= slice2mask_inside_1_choice;
        slice2mask_inside_2 <= slice2mask_inside_2_choice;
        slice2mask_inside_3 <= slice2mask_inside_3_choice;
        slice2mask_inside_4 <= slice2mask_inside_4_choice;
        slice2mask_inside_5 <= slice2mask_inside_5_choice;
        slice2mask_inside_6 <= slice2mask_inside_6_choice;
        slice2mask_inside_7 <= slice2mask_inside_7_choice;
        slice2mask_inside_8 <= slice2mask_inside_8_choice;
        slice2mask_inside_9 <= slice2mask_inside_9_choice;
        slice2mask_inside_10 <= slice2mask_inside_10_choice;
        slice2mask_inside_11 <= slice2mask_inside_11_choice;
        slice2mask_inside_12 <= slice2mask_inside_12_choice;
        slice2mask_inside_13 <= slice2mask_inside_13_choice;
        slice2mask_inside_14 <= slice2mask_inside_14_choice;
        slice2mask_inside_15 <= slice2mask_inside_15_choice;
      end if;
      -- slice2winner1
      if slice2mask_inside_1 then
        slice2winner1_best_cost_0_0_choice := 0;
      else
        slice2winner1_best_cost_0_0_choice := 2047;
      end if;
      slice2winner1_best_cost_0_0_any := to_integer(((to_unsigned(slice2window_sum_0_1, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_0_choice, 11))));
      if slice2mask_inside_0 then
        slice2winner1_best_cost_0_0_choice_2 := 0;
      else
        slice2winner1_best_cost_0_0_choice_2 := 2047;
      end if;
      slice2winner1_best_cost_0_0_any_2 := to_integer(((to_unsigned(slice2window_sum_0_0, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_0_choice_2, 11))));
      slice2winner1_best_cost_0_0_is_less := (slice2winner1_best_cost_0_0_any - slice2winner1_best_cost_0_0_any_2) < 0;
      if slice2mask_inside_3 then
        slice2winner1_best_cost_0_1_choice := 0;
      else
        slice2winner1_best_cost_0_1_choice := 2047;
      end if;
      slice2winner1_best_cost_0_1_any := to_integer(((to_unsigned(slice2window_sum_0_3, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_1_choice, 11))));
      if slice2mask_inside_2 then
        slice2winner1_best_cost_0_1_choice_2 := 0;
      else
        slice2winner1_best_cost_0_1_choice_2 := 2047;
      end if;
      slice2winner1_best_cost_0_1_any_2 := to_integer(((to_unsigned(slice2window_sum_0_2, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_1_choice_2, 11))));
      slice2winner1_best_cost_0_1_is_less := (slice2winner1_best_cost_0_1_any - slice2winner1_best_cost_0_1_any_2) < 0;
      if slice2mask_inside_5 then
        slice2winner1_best_cost_0_2_choice := 0;
      else
        slice2winner1_best_cost_0_2_choice := 2047;
      end if;
      slice2winner1_best_cost_0_2_any := to_integer(((to_unsigned(slice2window_sum_0_5, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_2_choice, 11))));
      if slice2mask_inside_4 then
        slice2winner1_best_cost_0_2_choice_2 := 0;
      else
        slice2winner1_best_cost_0_2_choice_2 := 2047;
      end if;
      slice2winner1_best_cost_0_2_any_2 := to_integer(((to_unsigned(slice2window_sum_0_4, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_2_choice_2, 11))));
      slice2winner1_best_cost_0_2_is_less := (slice2winner1_best_cost_0_2_any - slice2winner1_best_cost_0_2_any_2) < 0;
      if slice2mask_inside_7 then
        slice2winner1_best_cost_0_3_choice := 0;
      else
        slice2winner1_best_cost_0_3_choice := 2047;
      end if;
      slice2winner1_best_cost_0_3_any := to_integer(((to_unsigned(slice2window_sum_0_7, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_3_choice, 11))));
      if slice2mask_inside_6 then
        slice2winner1_best_cost_0_3_choice_2 := 0;
      else
        slice2winner1_best_cost_0_3_choice_2 := 2047;
      end if;
      slice2winner1_best_cost_0_3_any_2 := to_integer(((to_unsigned(slice2window_sum_0_6, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_3_choice_2, 11))));
      slice2winner1_best_cost_0_3_is_less := (slice2winner1_best_cost_0_3_any - slice2winner1_best_cost_0_3_any_2) < 0;
      if slice2mask_inside_9 then
        slice2winner1_best_cost_0_4_choice := 0;
      else
        slice2winner1_best_cost_0_4_choice := 2047;
      end if;
      slice2winner1_best_cost_0_4_any := to_integer(((to_unsigned(slice2window_sum_0_9, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_4_choice, 11))));
      if slice2mask_inside_8 then
        slice2winner1_best_cost_0_4_choice_2 := 0;
      else
        slice2winner1_best_cost_0_4_choice_2 := 2047;
      end if;
      slice2winner1_best_cost_0_4_any_2 := to_integer(((to_unsigned(slice2window_sum_0_8, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_4_choice_2, 11))));
      slice2winner1_best_cost_0_4_is_less := (slice2winner1_best_cost_0_4_any - slice2winner1_best_cost_0_4_any_2) < 0;
      if slice2mask_inside_11 then
        slice2winner1_best_cost_0_5_choice := 0;
      else
        slice2winner1_best_cost_0_5_choice := 2047;
      end if;
      slice2winner1_best_cost_0_5_any := to_integer(((to_unsigned(slice2window_sum_0_11, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_5_choice, 11))));
      if slice2mask_inside_10 then
        slice2winner1_best_cost_0_5_choice_2 := 0;
      else
        slice2winner1_best_cost_0_5_choice_2 := 2047;
      end if;
      slice2winner1_best_cost_0_5_any_2 := to_integer(((to_unsigned(slice2window_sum_0_10, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_5_choice_2, 11))));
      slice2winner1_best_cost_0_5_is_less := (slice2winner1_best_cost_0_5_any - slice2winner1_best_cost_0_5_any_2) < 0;
      if slice2mask_inside_13 then
        slice2winner1_best_cost_0_6_choice := 0;
      else
        slice2winner1_best_cost_0_6_choice := 2047;
      end if;
      slice2winner1_best_cost_0_6_any := to_integer(((to_unsigned(slice2window_sum_0_13, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_6_choice, 11))));
      if slice2mask_inside_12 then
        slice2winner1_best_cost_0_6_choice_2 := 0;
      else
        slice2winner1_best_cost_0_6_choice_2 := 2047;
      end if;
      slice2winner1_best_cost_0_6_any_2 := to_integer(((to_unsigned(slice2window_sum_0_12, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_6_choice_2, 11))));
      slice2winner1_best_cost_0_6_is_less := (slice2winner1_best_cost_0_6_any - slice2winner1_best_cost_0_6_any_2) < 0;
      if slice2mask_inside_15 then
        slice2winner1_best_cost_0_7_choice := 0;
      else
        slice2winner1_best_cost_0_7_choice := 2047;
      end if;
      slice2winner1_best_cost_0_7_any := to_integer(((to_unsigned(slice2window_sum_0_15, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_7_choice, 11))));
      if slice2mask_inside_14 then
        slice2winner1_best_cost_0_7_choice_2 := 0;
      else
        slice2winner1_best_cost_0_7_choice_2 := 2047;
      end if;
      slice2winner1_best_cost_0_7_any_2 := to_integer(((to_unsigned(slice2window_sum_0_14, 11)) or
        (to_unsigned(slice2winner1_best_cost_0_7_choice_2, 11))));
      slice2winner1_best_cost_0_7_is_less := (slice2winner1_best_cost_0_7_any - slice2winner1_best_cost_0_7_any_2) < 0;
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_0_is_less;
      slice2winner1_best_first_0_0 <= slice2winner1_best_cost_0_0_any_2;
      slice2winner1_best_first_0_1 <= slice2winner1_best_cost_0_1_any_2;
      slice2winner1_best_first_0_2 <= slice2winner1_best_cost_0_2_any_2;
      slice2winner1_best_first_0_3 <= slice2winner1_best_cost_0_3_any_2;
      slice2winner1_best_first_0_4 <= slice2winner1_best_cost_0_4_any_2;
      slice2winner1_best_first_0_5 <= slice2winner1_best_cost_0_5_any_2;
      slice2winner1_best_first_0_6 <= slice2winner1_best_cost_0_6_any_2;
      slice2winner1_best_first_0_7 <= slice2winner1_best_cost_0_7_any_2;
      slice2winner1_best_last_0_0 <= slice2winner1_best_cost_0_0_any;
      slice2winner1_best_last_0_1 <= slice2winner1_best_cost_0_1_any;
      slice2winner1_best_last_0_2 <= slice2winner1_best_cost_0_2_any;
      slice2winner1_best_last_0_3 <= slice2winner1_best_cost_0_3_any;
      slice2winner1_best_last_0_4 <= slice2winner1_best_cost_0_4_any;
      slice2winner1_best_last_0_5 <= slice2winner1_best_cost_0_5_any;
      slice2winner1_best_last_0_6 <= slice2winner1_best_cost_0_6_any;
      if slice2winner1_best_cost_0_0_is_less then
        slice2winner1_best_cost_0_0 <= slice2winner1_best_cost_0_0_any;
        slice2winner1_best_below_0_0 <= slice2winner1_best_cost_0_0_any_2;
        slice2winner1_best_above_0_0 <= 0;
      else
        slice2winner1_best_cost_0_0 <= slice2winner1_best_cost_0_0_any_2;
        slice2winner1_best_below_0_0 <= 0;
        slice2winner1_best_above_0_0 <= slice2winner1_best_cost_0_0_any;
      end if;
      if slice2winner1_best_cost_0_1_is_less then
        slice2winner1_best_cost_0_1 <= slice2winner1_best_cost_0_1_any;
        slice2winner1_best_index_0_1 <= 3;
        slice2winner1_best_below_0_1 <= slice2winner1_best_cost_0_1_any_2;
        slice2winner1_best_above_0_1 <= 0;
      else
        slice2winner1_best_cost_0_1 <= slice2winner1_best_cost_0_1_any_2;
        slice2winner1_best_index_0_1 <= 2;
        slice2winner1_best_below_0_1 <= 0;
        slice2winner1_best_above_0_1 <= slice2winner1_best_cost_0_1_any;
      end if;
      if slice2winner1_best_cost_0_2_is_less then
        slice2winner1_best_cost_0_2 <= slice2winner1_best_cost_0_2_any;
        slice2winner1_best_index_0_2 <= 5;
        slice2winner1_best_below_0_2 <= slice2winner1_best_cost_0_2_any_2;
        slice2winner1_best_above_0_2 <= 0;
      else
        slice2winner1_best_cost_0_2 <= slice2winner1_best_cost_0_2_any_2;
        slice2winner1_best_index_0_2 <= 4;
        slice2winner1_best_below_0_2 <= 0;
        slice2winner1_best_above_0_2 <= slice2winner1_best_cost_0_2_any;
      end if;
      if slice2winner1_best_cost_0_3_is_less then
        slice2winner1_best_cost_0_3 <= slice2winner1_best_cost_0_3_any;
        slice2winner1_best_index_0_3 <= 7;
        slice2winner1_best_below_0_3 <= slice2winner1_best_cost_0_3_any_2;
        slice2winner1_best_above_0_3 <= 0;
      else
        slice2winner1_best_cost_0_3 <= slice2winner1_best_cost_0_3_any_2;
        slice2winner1_best_index_0_3 <= 6;
        slice2winner1_best_below_0_3 <= 0;
        slice2winner1_best_above_0_3 <= slice2winner1_best_cost_0_3_any;
      end if;
      if slice2winner1_best_cost_0_4_is_less then
        slice2winner1_best_cost_0_4 <= slice2winner1_best_cost_0_4_any;
        slice2winner1_best_index_0_4 <= 9;
        slice2winner1_best_below_0_4 <= slice2winner1_best_cost_0_4_any_2;
        slice2winner1_best_above_0_4 <= 0;
      else
        slice2winner1_best_cost_0_4 <= slice2winner1_best_cost_0_4_any_2;
        slice2winner1_best_index_0_4 <= 8;
        slice2winner1_best_below_0_4 <= 0;
        slice2winner1_best_above_0_4 <= slice2winner1_best_cost_0_4_any;
      end if;
      if slice2winner1_best_cost_0_5_is_less then
        slice2winner1_best_cost_0_5 <= slice2winner1_best_cost_0_5_any;
        slice2winner1_best_index_0_5 <= 11;
        slice2winner1_best_below_0_5 <= slice2winner1_best_cost_0_5_any_2;
        slice2winner1_best_above_0_5 <= 0;
      else
        slice2winner1_best_cost_0_5 <= slice2winner1_best_cost_0_5_any_2;
        slice2winner1_best_index_0_5 <= 10;
        slice2winner1_best_below_0_5 <= 0;
        slice2winner1_best_above_0_5 <= slice2winner1_best_cost_0_5_any;
      end if;
      if slice2winner1_best_cost_0_6_is_less then
        slice2winner1_best_cost_0_6 <= slice2winner1_best_cost_0_6_any;
        slice2winner1_best_index_0_6 <= 13;
        slice2winner1_best_below_0_6 <= slice2winner1_best_cost_0_6_any_2;
        slice2winner1_best_above_0_6 <= 0;
      else
        slice2winner1_best_cost_0_6 <= slice2winner1_best_cost_0_6_any_2;
        slice2winner1_best_index_0_6 <= 12;
        slice2winner1_best_below_0_6 <= 0;
        slice2winner1_best_above_0_6 <= slice2winner1_best_cost_0_6_any;
      end if;
      if slice2winner1_best_cost_0_7_is_less then
        slice2winner1_best_cost_0_7 <= slice2winner1_best_cost_0_7_any;
        slice2winner1_best_index_0_7 <= 15;
        slice2winner1_best_below_0_7 <= slice2winner1_best_cost_0_7_any_2;
        slice2winner1_best_above_0_7 <= 0;
      else
        slice2winner1_best_cost_0_7 <= slice2winner1_best_cost_0_7_any_2;
        slice2winner1_best_index_0_7 <= 14;
        slice2winner1_best_below_0_7 <= 0;
        slice2winner1_best_above_0_7 <= slice2winner1_best_cost_0_7_any;
      end if;
      -- slice2winner2
      slice2winner2_best_cost_0_0_is_less := (slice2winner1_best_cost_0_1 - slice2winner1_best_cost_0_0) < 0;
      slice2winner2_best_cost_0_1_is_less := (slice2winner1_best_cost_0_3 - slice2winner1_best_cost_0_2) < 0;
      slice2winner2_best_cost_0_2_is_less := (slice2winner1_best_cost_0_5 - slice2winner1_best_cost_0_4) < 0;
      slice2winner2_best_cost_0_3_is_less := (slice2winner1_best_cost_0_7 - slice2winner1_best_cost_0_6) < 0;
      if slice2winner1_best_index_0_1 = 2 then
        slice2winner2_best_below_0_0_choice := slice2winner1_best_last_0_0;
      else
        slice2winner2_best_below_0_0_choice := slice2winner1_best_below_0_1;
      end if;
      if slice2winner1_best_index_0_3 = 6 then
        slice2winner2_best_below_0_1_choice := slice2winner1_best_last_0_2;
      else
        slice2winner2_best_below_0_1_choice := slice2winner1_best_below_0_3;
      end if;
      if ((slice2winner1_best_index_0_5 / 8) = 1) and ((slice2winner1_best_index_0_5 mod 4) = 2) then
        slice2winner2_best_below_0_2_choice := slice2winner1_best_last_0_4;
      else
        slice2winner2_best_below_0_2_choice := slice2winner1_best_below_0_5;
      end if;
      if slice2winner1_best_index_0_7 = 14 then
        slice2winner2_best_below_0_3_choice := slice2winner1_best_last_0_6;
      else
        slice2winner2_best_below_0_3_choice := slice2winner1_best_below_0_7;
      end if;
      if slice2winner1_best_index_0_0 then
        slice2winner2_best_above_0_0_choice := slice2winner1_best_first_0_1;
      else
        slice2winner2_best_above_0_0_choice := slice2winner1_best_above_0_0;
      end if;
      if other_3 then
        slice2winner2_best_above_0_1_choice := slice2winner1_best_first_0_3;
      else
        slice2winner2_best_above_0_1_choice := slice2winner1_best_above_0_2;
      end if;
      if other_4 then
        slice2winner2_best_above_0_2_choice := slice2winner1_best_first_0_5;
      else
        slice2winner2_best_above_0_2_choice := slice2winner1_best_above_0_4;
      end if;
      if other_5 then
        slice2winner2_best_above_0_3_choice := slice2winner1_best_first_0_7;
      else
        slice2winner2_best_above_0_3_choice := slice2winner1_best_above_0_6;
      end if;
      slice2winner2_best_first_0_0 <= slice2winner1_best_first_0_0;
      slice2winner2_best_first_0_1 <= slice2winner1_best_first_0_2;
      slice2winner2_best_first_0_2 <= slice2winner1_best_first_0_4;
      slice2winner2_best_first_0_3 <= slice2winner1_best_first_0_6;
      slice2winner2_best_last_0_0 <= slice2winner1_best_last_0_1;
      slice2winner2_best_last_0_1 <= slice2winner1_best_last_0_3;
      slice2winner2_best_last_0_2 <= slice2winner1_best_last_0_5;
      if slice2winner2_best_cost_0_0_is_less then
        slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_1;
        slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_1;
        slice2winner2_best_below_0_0 <= slice2winner2_best_below_0_0_choice;
        slice2winner2_best_above_0_0 <= slice2winner1_best_above_0_1;
      else
        slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_0;
        slice2winner2_best_index_0_0 <= as_number(slice2winner1_best_index_0_0);
        slice2winner2_best_below_0_0 <= slice2winner1_best_below_0_0;
        slice2winner2_best_above_0_0 <= slice2winner2_best_above_0_0_choice;
      end if;
      if slice2winner2_best_cost_0_1_is_less then
        slice2winner2_best_cost_0_1 <= slice2winner1_best_cost_0_3;
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_3;
        slice2winner2_best_below_0_1 <= slice2winner2_best_below_0_1_choice;
        slice2winner2_best_above_0_1 <= slice2winner1_best_above_0_3;
      else
        slice2winner2_best_cost_0_1 <= slice2winner1_best_cost_0_2;
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_2;
        slice2winner2_best_below_0_1 <= slice2winner1_best_below_0_2;
        slice2winner2_best_above_0_1 <= slice2winner2_best_above_0_1_choice;
      end if;
      if slice2winner2_best_cost_0_2_is_less then
        slice2winner2_best_cost_0_2 <= slice2winner1_best_cost_0_5;
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_5;
        slice2winner2_best_below_0_2 <= slice2winner2_best_below_0_2_choice;
        slice2winner2_best_above_0_2 <= slice2winner1_best_above_0_5;
      else
        slice2winner2_best_cost_0_2 <= slice2winner1_best_cost_0_4;
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_4;
        slice2winner2_best_below_0_2 <= slice2winner1_best_below_0_4;
        slice2winner2_best_above_0_2 <= slice2winner2_best_above_0_2_choice;
      end if;
      if slice2winner2_best_cost_0_3_is_less then
        slice2winner2_best_cost_0_3 <= slice2winner1_best_cost_0_7;
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_7;
        slice2winner2_best_below_0_3 <= slice2winner2_best_below_0_3_choice;
        slice2winner2_best_above_0_3 <= slice2winner1_best_above_0_7;
      else
        slice2winner2_best_cost_0_3 <= slice2winner1_best_cost_0_6;
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_6;
        slice2winner2_best_below_0_3 <= slice2winner1_best_below_0_6;
        slice2winner2_best_above_0_3 <= slice2winner2_best_above_0_3_choice;
      end if;
      -- slice2winner3
      slice2winner3_best_cost_0_0_is_less := (slice2winner2_best_cost_0_1 - slice2winner2_best_cost_0_0) < 0;
      slice2winner3_best_cost_0_1_is_less := (slice2winner2_best_cost_0_3 - slice2winner2_best_cost_0_2) < 0;
      if slice2winner2_best_index_0_1 = 4 then
        slice2winner3_best_below_0_0_choice := slice2winner2_best_last_0_0;
      else
        slice2winner3_best_below_0_0_choice := slice2winner2_best_below_0_1;
      end if;
      if slice2winner2_best_index_0_3 = 12 then
        slice2winner3_best_below_0_1_choice := slice2winner2_best_last_0_2;
      else
        slice2winner3_best_below_0_1_choice := slice2winner2_best_below_0_3;
      end if;
      if slice2winner2_best_index_0_0 = 3 then
        slice2winner3_best_above_0_0_choice := slice2winner2_best_first_0_1;
      else
        slice2winner3_best_above_0_0_choice := slice2winner2_best_above_0_0;
      end if;
      if ((slice2winner2_best_index_0_2 / 8) = 1) and ((slice2winner2_best_index_0_2 mod 4) = 3) then
        slice2winner3_best_above_0_1_choice := slice2winner2_best_first_0_3;
      else
        slice2winner3_best_above_0_1_choice := slice2winner2_best_above_0_2;
      end if;
      slice2winner3_best_first_0_0 <= slice2winner2_best_first_0_0;
      slice2winner3_best_first_0_1 <= slice2winner2_best_first_0_2;
      slice2winner3_best_last_0_0 <= slice2winner2_best_last_0_1;
      if slice2winner3_best_cost_0_0_is_less then
        slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_1;
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_1;
        slice2winner3_best_below_0_0 <= slice2winner3_best_below_0_0_choice;
        slice2winner3_best_above_0_0 <= slice2winner2_best_above_0_1;
      else
        slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_0;
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
        slice2winner3_best_below_0_0 <= slice2winner2_best_below_0_0;
        slice2winner3_best_above_0_0 <= slice2winner3_best_above_0_0_choice;
      end if;
      if slice2winner3_best_cost_0_1_is_less then
        slice2winner3_best_cost_0_1 <= slice2winner2_best_cost_0_3;
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_3;
        slice2winner3_best_below_0_1 <= slice2winner3_best_below_0_1_choice;
        slice2winner3_best_above_0_1 <= slice2winner2_best_above_0_3;
      else
        slice2winner3_best_cost_0_1 <= slice2winner2_best_cost_0_2;
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_2;
        slice2winner3_best_below_0_1 <= slice2winner2_best_below_0_2;
        slice2winner3_best_above_0_1 <= slice2winner3_best_above_0_1_choice;
      end if;
      -- slice2winner4
      slice2winner4_best_cost_0_0_is_less := (slice2winner3_best_cost_0_1 - slice2winner3_best_cost_0_0) < 0;
      if slice2winner3_best_index_0_1 = 8 then
        slice2winner4_best_below_0_0_choice := slice2winner3_best_last_0_0;
      else
        slice2winner4_best_below_0_0_choice := slice2winner3_best_below_0_1;
      end if;
      if slice2winner3_best_index_0_0 = 7 then
        slice2winner4_best_above_0_0_choice := slice2winner3_best_first_0_1;
      else
        slice2winner4_best_above_0_0_choice := slice2winner3_best_above_0_0;
      end if;
      slice2winner4_best_first_0_0 <= slice2winner3_best_first_0_0;
      if slice2winner4_best_cost_0_0_is_less then
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0_1;
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_1;
        slice2winner4_best_below_0_0 <= slice2winner4_best_below_0_0_choice;
        slice2winner4_best_above_0_0 <= slice2winner3_best_above_0_1;
      else
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0_0;
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_0;
        slice2winner4_best_below_0_0 <= slice2winner3_best_below_0_0;
        slice2winner4_best_above_0_0 <= slice2winner4_best_above_0_0_choice;
      end if;
      -- slice2
      slice2_best_cost_0_0_is_less := (slice2winner4_best_cost_0_0 - slice1_best_cost_0_0) < 0;
      if slice2winner4_best_index_0_0 = 0 then
        slice2_best_below_0_0_choice := slice1_best_last_0_0;
      else
        slice2_best_below_0_0_choice := slice2winner4_best_below_0_0;
      end if;
      if slice1_best_index_0_0 = 31 then
        slice2_best_above_0_0_choice := slice2winner4_best_first_0_0;
      else
        slice2_best_above_0_0_choice := slice1_best_above_0_0;
      end if;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_map_column <= slice1_best_tag_map_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if slice2_best_cost_0_0_is_less then
        slice2_best_cost_0_0 <= slice2winner4_best_cost_0_0;
        slice2_best_index_0_0 <= slice2winner4_best_index_0_0 + 32;
        slice2_best_below_0_0 <= slice2_best_below_0_0_choice;
        slice2_best_above_0_0 <= slice2winner4_best_above_0_0;
      else
        slice2_best_cost_0_0 <= slice1_best_cost_0_0;
        slice2_best_index_0_0 <= slice1_best_index_0_0;
        slice2_best_below_0_0 <= slice1_best_below_0_0;
        slice2_best_above_0_0 <= slice2_best_above_0_0_choice;
      end if;
      -- refinement
      refinement_tag_11_row_start_differs := map_counter_group /= 376;
      refinement_tag_11_row_start_is_equal := map_counter_column = 441;
      if refinement_tag_11_row_start_is_equal then
        refinement_tag_11_row_start_choice := refinement_tag_11_row_start and (map_counter_group /= 375);
      else
        refinement_tag_11_row_start_choice := refinement_tag_11_row_start;
      end if;
      if refinement_tag_11_row_start_differs then
        refinement_tag_11_row_start_choice_2 := refinement_tag_11_row_start_choice;
      else
        refinement_tag_11_row_start_choice_2 := refinement_tag_11_row_start;
      end if;
      refinement_tag_11_row_start_is_equal_2 := map_counter_group = 374;
      refinement_tag_11_row_start_all := refinement_tag_11_row_start_is_equal_2 and
        refinement_tag_11_row_start_is_equal;
      if refinement_tag_11_row_start_choice_2 then
        refinement_tag_11_row_start_choice_3 := (not refinement_tag_11_start_of_frame) or
          refinement_tag_11_row_start_all;
      else
        refinement_tag_11_row_start_choice_3 := refinement_tag_11_start_of_frame and
          refinement_tag_11_row_start_is_equal_2 and refinement_tag_11_row_start_is_equal;
      end if;
      refinement_tag_11_row_start_all_2 := refinement_tag_11_valid and refinement_tag_11_map_column;
      refinement_below_0_differs := slice2_best_below_0_0 /= 2047;
      refinement_below_0_value := ((slice2_best_index_0_0 / 16) mod 2) = 1;
      refinement_below_0_value_2 := ((slice2_best_index_0_0 / 8) mod 2) = 1;
      if (not ((slice2_best_index_0_0 / 32) = 1)) and ((slice2_best_index_0_0 mod 8) = 0) then
        refinement_below_0_choice := refinement_below_0_differs and (refinement_below_0_value or
          refinement_below_0_value_2);
      else
        refinement_below_0_choice := refinement_below_0_differs;
      end if;
      refinement_above_0_differs := slice2_best_above_0_0 /= 2047;
      if ((slice2_best_index_0_0 / 32) = 1) and ((slice2_best_index_0_0 mod 8) = 7) then
        refinement_above_0_choice := refinement_above_0_differs and (refinement_below_0_value or (not
          refinement_below_0_value_2));
      else
        refinement_above_0_choice := refinement_above_0_differs;
      end if;
      refinement_remainder_1_0_difference := (refinement_remainder_0_0 + 4096) - refinement_divisor_0_0;
      refinement_remainder_2_0_difference := ((refinement_remainder_1_0 * 2) + 4096) - refinement_divisor_1_0;
      refinement_remainder_3_0_difference := ((refinement_remainder_2_0 * 2) + 4096) - refinement_divisor_2_0;
      refinement_remainder_4_0_difference := ((refinement_remainder_3_0 * 2) + 4096) - refinement_divisor_3_0;
      refinement_remainder_5_0_difference := ((refinement_remainder_4_0 * 2) + 4096) - refinement_divisor_4_0;
      refinement_remainder_6_0_difference := ((refinement_remainder_5_0 * 2) + 4096) - refinement_divisor_5_0;
      refinement_remainder_7_0_difference := ((refinement_remainder_6_0 * 2) + 4096) - refinement_divisor_6_0;
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
      refinement_disparity_0_0 <= slice2_best_index_0_0;
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
      refinement_passed_0_0 <= true;
      refinement_passed_1_0 <= refinement_passed_0_0;
      refinement_passed_2_0 <= refinement_passed_1_0;
      refinement_passed_3_0 <= refinement_passed_2_0;
      refinement_passed_5_0 <= transform_filtering_1_column_inside_4;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_11_0 <= transform_filtering_1_row_inside_4;
      refinement_tag_0_valid <= slice2_best_tag_valid;
      refinement_tag_0_map_column <= slice2_best_tag_map_column;
      refinement_tag_0_start_of_frame <= slice2_best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= slice2_best_tag_end_of_line;
      refinement_tag_1_valid <= refinement_tag_0_valid;
      refinement_tag_1_map_column <= refinement_tag_0_map_column;
      refinement_tag_1_start_of_frame <= refinement_tag_0_start_of_frame;
      refinement_tag_1_end_of_line <= refinement_tag_0_end_of_line;
      refinement_tag_2_valid <= refinement_tag_1_valid;
      refinement_tag_2_map_column <= refinement_tag_1_map_column;
      refinement_tag_2_start_of_frame <= refinement_tag_1_start_of_frame;
      refinement_tag_2_end_of_line <= refinement_tag_1_end_of_line;
      refinement_tag_3_valid <= refinement_tag_2_valid;
      refinement_tag_3_map_column <= refinement_tag_2_map_column;
      refinement_tag_3_start_of_frame <= refinement_tag_2_start_of_frame;
      refinement_tag_3_end_of_line <= refinement_tag_2_end_of_line;
      refinement_tag_4_valid <= refinement_tag_3_valid;
      refinement_tag_4_map_column <= refinement_tag_3_map_column;
      refinement_tag_4_start_of_frame <= refinement_tag_3_start_of_frame;
      refinement_tag_4_end_of_line <= refinement_tag_3_end_of_line;
      refinement_tag_5_valid <= refinement_tag_4_valid;
      refinement_tag_5_map_column <= refinement_tag_4_map_column;
      refinement_tag_5_start_of_frame <= refinement_tag_4_start_of_frame;
      refinement_tag_5_end_of_line <= refinement_tag_4_end_of_line;
      refinement_tag_6_valid <= refinement_tag_5_valid;
      refinement_tag_6_map_column <= refinement_tag_5_map_column;
      refinement_tag_6_start_of_frame <= refinement_tag_5_start_of_frame;
      refinement_tag_6_end_of_line <= refinement_tag_5_end_of_line;
      refinement_tag_7_valid <= refinement_tag_6_valid;
      refinement_tag_7_map_column <= refinement_tag_6_map_column;
      refinement_tag_7_start_of_frame <= refinement_tag_6_start_of_frame;
      refinement_tag_7_end_of_line <= refinement_tag_6_end_of_line;
      refinement_tag_8_valid <= refinement_tag_7_valid;
      refinement_tag_8_map_column <= refinement_tag_7_map_column;
      refinement_tag_8_start_of_frame <= refinement_tag_7_start_of_frame;
      refinement_tag_8_end_of_line <= refinement_tag_7_end_of_line;
      refinement_tag_9_valid <= refinement_tag_8_valid;
      refinement_tag_9_map_column <= refinement_tag_8_map_column;
      refinement_tag_9_start_of_frame <= refinement_tag_8_start_of_frame;
      refinement_tag_9_end_of_line <= refinement_tag_8_end_of_line;
      refinement_tag_10_valid <= refinement_tag_9_valid;
      refinement_tag_10_map_column <= refinement_tag_9_map_column;
      refinement_tag_10_start_of_frame <= refinement_tag_9_start_of_frame;
      refinement_tag_10_end_of_line <= refinement_tag_9_end_of_line;
      refinement_tag_11_valid <= refinement_tag_10_valid;
      refinement_tag_11_map_column <= refinement_tag_10_map_column;
      refinement_tag_11_start_of_frame <= refinement_tag_10_start_of_frame;
      refinement_tag_11_end_of_line <= refinement_tag_10_end_of_line;
      refinement_cost_0 <= slice2_best_cost_0_0;
      refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 2048;
      refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 2048;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_divisor_0_0 <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 11)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 11))));
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_quotient_8_0 <= ((((4096 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) / 2048) +
        ((other_12 / 2) * 2);
      refinement_negative_0_0 <= refinement_divisor_0_0_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
      if refinement_tag_11_row_start_choice_3 then
        refinement_tag_11_row_start <= refinement_tag_11_row_start or refinement_tag_11_row_start_all_2;
      else
        refinement_tag_11_row_start <= refinement_tag_11_row_start and ((not refinement_tag_11_valid) or (not
          refinement_tag_11_map_column));
      end if;
      if refinement_below_0_choice then
        refinement_below_0 <= slice2_best_below_0_0;
      else
        refinement_below_0 <= slice2_best_above_0_0;
      end if;
      if (not refinement_above_0_choice) and (slice2_best_index_0_0 /= 0) and refinement_below_0_differs then
        refinement_above_0 <= slice2_best_below_0_0;
      else
        refinement_above_0 <= slice2_best_above_0_0;
      end if;
      if (refinement_remainder_1_0_difference / 4096) = 1 then
        refinement_remainder_1_0 <= refinement_remainder_1_0_difference mod 2048;
      else
        refinement_remainder_1_0 <= refinement_remainder_0_0;
      end if;
      if (refinement_remainder_2_0_difference / 4096) = 1 then
        refinement_remainder_2_0 <= refinement_remainder_2_0_difference mod 2048;
      else
        refinement_remainder_2_0 <= (refinement_remainder_1_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_3_0_difference / 4096) = 1 then
        refinement_remainder_3_0 <= refinement_remainder_3_0_difference mod 2048;
      else
        refinement_remainder_3_0 <= (refinement_remainder_2_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_4_0_difference / 4096) = 1 then
        refinement_remainder_4_0 <= refinement_remainder_4_0_difference mod 2048;
      else
        refinement_remainder_4_0 <= (refinement_remainder_3_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_5_0_difference / 4096) = 1 then
        refinement_remainder_5_0 <= refinement_remainder_5_0_difference mod 2048;
      else
        refinement_remainder_5_0 <= (refinement_remainder_4_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_6_0_difference / 4096) = 1 then
        refinement_remainder_6_0 <= refinement_remainder_6_0_difference mod 2048;
      else
        refinement_remainder_6_0 <= (refinement_remainder_5_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_7_0_difference / 4096) = 1 then
        refinement_remainder_7_0 <= refinement_remainder_7_0_difference mod 2048;
      else
        refinement_remainder_7_0 <= (refinement_remainder_6_0 mod 1024) * 2;
      end if;
      -- map
      if refinement_tag_11_row_start_all_2 then
        if refinement_tag_11_start_of_frame or refinement_tag_11_row_start_is_equal then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 512;
        end if;
      end if;
      if refinement_tag_11_row_start_all then
        map_counter_group_choice := 375;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 375;
      if refinement_tag_11_row_start and map_counter_group_is_equal then
        map_counter_group_choice_2 := 1;
      else
        map_counter_group_choice_2 := (map_counter_group + 1) mod 512;
      end if;
      if refinement_tag_11_row_start_differs and refinement_tag_11_row_start_is_equal and refinement_tag_11_valid and
        refinement_tag_11_map_column then
        map_counter_group_choice_3 := map_counter_group_choice_2;
      else
        map_counter_group_choice_3 := map_counter_group;
      end if;
      if refinement_tag_11_valid then
        map_line_ended_choice := refinement_tag_11_map_column;
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := to_integer(other_9(16 downto 16)) = 1;
      if map_at_top then
        map_of_column_0_a_choice := map_column_1 / 2;
      else
        map_of_column_0_a_choice := other_10 / 2;
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
      map_window_complete_is_equal := map_sorted_column = 0;
      if map_window_complete_is_equal then
        map_window_complete_choice := map_sorted_behind;
      else
        map_window_complete_choice := map_sorted_arrives or map_sorted_behind;
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
      map_counter_next_frame <= to_integer(other_9(40 downto 40)) = 1;
      map_newest_0 <= (((((((refinement_disparity_11_0 + (refinement_fraction_0 / 16)) * 2) + ((refinement_fraction_0
        mod 16) / 8) + 8191) mod 4096) * 8) + (refinement_fraction_0 mod 8)) * 2) + as_number(refinement_passed_11_0);
      map_arrives <= refinement_tag_11_row_start_all_2;
      map_behind <= map_line_ended and refinement_tag_11_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_write_column <= to_integer(other_9(8 downto 0));
      map_column_1 <= map_rows_ready_words_0 / 8192;
      map_column_2 <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= to_integer(other_9(24 downto 24)) = 1;
      map_at_top <= to_integer(other_9(32 downto 32)) = 1;
      map_at_output <= to_integer(other_9(48 downto 48)) = 1;
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
      map_window_complete <= map_sorted_output and map_window_complete_choice;
      map_window_first <= map_sorted_top and (map_sorted_column = 1) and map_sorted_arrives;
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
      if refinement_tag_11_start_of_frame and refinement_tag_11_valid and refinement_tag_11_map_column then
        map_counter_group <= map_counter_group_choice;
      else
        map_counter_group <= map_counter_group_choice_3;
      end if;
      if refinement_tag_11_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not refinement_tag_11_valid);
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
        map_rows_write_words_0 <= (map_rows_ready_words_0 / 8192) + (map_rows_ready_newest_0 * 8192);
        map_at_column <= to_integer(other_9(8 downto 0));
      end if;
      if map_sorted_behind then
        map_low_0_0_choice := map_low_0_0;
      else
        map_low_0_0_choice := map_sorted_low_0;
      end if;
      map_low_1_0_all := map_window_complete_is_equal and map_sorted_arrives;
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
      other_0 <= slice0winner1_best_cost_0_2_is_less;
      other_1 <= slice0winner1_best_cost_0_4_is_less;
      other_2 <= slice0winner1_best_cost_0_6_is_less;
      other_3 <= slice2winner1_best_cost_0_2_is_less;
      other_4 <= slice2winner1_best_cost_0_4_is_less;
      other_5 <= slice2winner1_best_cost_0_6_is_less;
      other_6 <= slice1winner1_best_cost_0_2_is_less;
      other_7 <= slice1winner1_best_cost_0_4_is_less;
      other_8 <= slice1winner1_best_cost_0_6_is_less;
      other_9 <= other_11;
      other_10 <= ((map_rows_ready_words_0 mod 8192) / 2) * 2;
      other_11 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 376))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other_12 <= ((refinement_remainder_7_0_difference / 4096) * 2) + ((other_13 / 4) * 4);
      other_13 <= ((refinement_remainder_6_0_difference / 4096) * 4) + ((other_14 / 8) * 8);
      other_14 <= ((refinement_remainder_5_0_difference / 4096) * 8) + ((other_15 / 16) * 16);
      other_15 <= ((refinement_remainder_4_0_difference / 4096) * 16) + ((other_16 / 32) * 32);
      other_16 <= ((refinement_remainder_3_0_difference / 4096) * 32) + ((other_17 / 64) * 64);
      other_17 <= ((refinement_remainder_2_0_difference / 4096) * 64) + ((other_18 / 128) * 128);
      other_18 <= (refinement_remainder_1_0_difference / 4096) * 128;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 377;
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
        raster_place_group <= 379;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_row_start <= false;
        delay_tag_map_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_row_start <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_row_start <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_row_start <= false;
        rows_tag_map_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_row_start <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_row_start <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_row_start <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_map_column <= false;
        slice0cost_ready_tag_start_of_frame <= false;
        slice0cost_ready_tag_end_of_line <= false;
        slice0cost_write_column <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_map_column <= false;
        slice0window_entering_tag_start_of_frame <= false;
        slice0window_entering_tag_end_of_line <= false;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_map_column <= false;
        slice0window_change_tag_start_of_frame <= false;
        slice0window_change_tag_end_of_line <= false;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_start_of_frame_3 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_start_of_frame <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_map_column <= false;
        slice0winner3_tag_start_of_frame <= false;
        slice0winner3_tag_end_of_line <= false;
        slice0winner4_tag_valid <= false;
        slice0winner4_tag_map_column <= false;
        slice0winner4_tag_start_of_frame <= false;
        slice0winner4_tag_end_of_line <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1cost_read_column <= 0;
        slice1cost_change_column <= 0;
        slice1cost_ready_column <= 0;
        slice1cost_write_column <= 0;
        slice1window_ring_read_address <= 1;
        slice1window_ring_write_address <= 0;
        slice1window_centre_map_column_0 <= false;
        slice1window_centre_start_of_frame_0 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_map_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2cost_read_column <= 0;
        slice2cost_change_column <= 0;
        slice2cost_ready_column <= 0;
        slice2cost_write_column <= 0;
        slice2window_ring_read_address <= 1;
        slice2window_ring_write_address <= 0;
        slice2window_centre_map_column_0 <= false;
        slice2window_centre_map_column_1 <= false;
        slice2window_centre_map_column_2 <= false;
        slice2window_centre_start_of_frame_0 <= false;
        slice2window_centre_end_of_line_0 <= false;
        slice2window_centre_end_of_line_1 <= false;
        slice2window_centre_end_of_line_2 <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_map_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
        refinement_tag_0_valid <= false;
        refinement_tag_0_map_column <= false;
        refinement_tag_0_start_of_frame <= false;
        refinement_tag_0_end_of_line <= false;
        refinement_tag_1_valid <= false;
        refinement_tag_1_map_column <= false;
        refinement_tag_1_start_of_frame <= false;
        refinement_tag_1_end_of_line <= false;
        refinement_tag_2_valid <= false;
        refinement_tag_2_map_column <= false;
        refinement_tag_2_start_of_frame <= false;
        refinement_tag_2_end_of_line <= false;
        refinement_tag_3_valid <= false;
        refinement_tag_3_map_column <= false;
        refinement_tag_3_start_of_frame <= false;
        refinement_tag_3_end_of_line <= false;
        refinement_tag_4_valid <= false;
        refinement_tag_4_map_column <= false;
        refinement_tag_4_start_of_frame <= false;
        refinement_tag_4_end_of_line <= false;
        refinement_tag_5_valid <= false;
        refinement_tag_5_map_column <= false;
        refinement_tag_5_start_of_frame <= false;
        refinement_tag_5_end_of_line <= false;
        refinement_tag_6_valid <= false;
        refinement_tag_6_map_column <= false;
        refinement_tag_6_start_of_frame <= false;
        refinement_tag_6_end_of_line <= false;
        refinement_tag_7_valid <= false;
        refinement_tag_7_map_column <= false;
        refinement_tag_7_start_of_frame <= false;
        refinement_tag_7_end_of_line <= false;
        refinement_tag_8_valid <= false;
        refinement_tag_8_map_column <= false;
        refinement_tag_8_start_of_frame <= false;
        refinement_tag_8_end_of_line <= false;
        refinement_tag_9_valid <= false;
        refinement_tag_9_map_column <= false;
        refinement_tag_9_start_of_frame <= false;
        refinement_tag_9_end_of_line <= false;
        refinement_tag_10_valid <= false;
        refinement_tag_10_map_column <= false;
        refinement_tag_10_start_of_frame <= false;
        refinement_tag_10_end_of_line <= false;
        refinement_tag_11_valid <= false;
        refinement_tag_11_row_start <= false;
        refinement_tag_11_map_column <= false;
        refinement_tag_11_start_of_frame <= false;
        refinement_tag_11_end_of_line <= false;
        map_counter_column <= 0;
        map_counter_group <= 376;
        map_arrives <= false;
        map_behind <= false;
        map_line_ended <= false;
        map_write_column <= 0;
        map_at_column <= 0;
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
        other_9 <= to_unsigned(0, 49);
        other_11 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
