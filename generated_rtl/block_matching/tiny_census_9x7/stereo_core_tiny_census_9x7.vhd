-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny_census_9x7: 32x12, 5 disparities, window 3x3, 1 pixel pair a clock.
-- Options: disparities 5, cost census, census_width_px 9, census_height_px 7.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_census_9x7
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_census_9x7 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 5;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 27;
    latency_clocks : positive := 22;
    flush_groups : positive := 132;
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
  assert width_px = 32 report "stereo_core_tiny_census_9x7: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny_census_9x7: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 5 report "stereo_core_tiny_census_9x7: disparities is " & integer'image(disparities) & " but this core has 5" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_census_9x7: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_census_9x7: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 27 report "stereo_core_tiny_census_9x7: output_width_px is " & integer'image(output_width_px) & " but this core has 27" severity failure;
  assert latency_clocks = 22 report "stereo_core_tiny_census_9x7: latency_clocks is " & integer'image(latency_clocks) & " but this core has 22" severity failure;
  assert flush_groups = 132 report "stereo_core_tiny_census_9x7: flush_groups is " & integer'image(flush_groups) & " but this core has 132" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_census_9x7: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_census_9x7 is
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
  signal transform_left_column_5, transform_left_column_6, transform_right_column_0 : natural range 0 to 255;
  signal transform_right_column_1, transform_right_column_2, transform_right_column_3 : natural range 0 to 255;
  signal transform_right_column_4, transform_right_column_5, transform_right_column_6 : natural range 0 to 255;
  signal transform_left_filter_column_0_0, transform_left_filter_column_0_1 : natural range 0 to 255;
  signal transform_left_filter_column_0_2, transform_left_filter_column_0_3 : natural range 0 to 255;
  signal transform_left_filter_column_0_4, transform_left_filter_column_0_5 : natural range 0 to 255;
  signal transform_left_filter_column_0_6, transform_left_filter_column_1_0 : natural range 0 to 255;
  signal transform_left_filter_column_1_1, transform_left_filter_column_1_2 : natural range 0 to 255;
  signal transform_left_filter_column_1_3, transform_left_filter_column_1_4 : natural range 0 to 255;
  signal transform_left_filter_column_1_5, transform_left_filter_column_1_6 : natural range 0 to 255;
  signal transform_left_filter_column_2_0, transform_left_filter_column_2_1 : natural range 0 to 255;
  signal transform_left_filter_column_2_2, transform_left_filter_column_2_3 : natural range 0 to 255;
  signal transform_left_filter_column_2_4, transform_left_filter_column_2_5 : natural range 0 to 255;
  signal transform_left_filter_column_2_6, transform_left_filter_column_3_0 : natural range 0 to 255;
  signal transform_left_filter_column_3_1, transform_left_filter_column_3_2 : natural range 0 to 255;
  signal transform_left_filter_column_3_3, transform_left_filter_column_3_4 : natural range 0 to 255;
  signal transform_left_filter_column_3_5, transform_left_filter_column_3_6 : natural range 0 to 255;
  signal transform_left_filter_column_4_0, transform_left_filter_column_4_1 : natural range 0 to 255;
  signal transform_left_filter_column_4_2, transform_left_filter_column_4_3 : natural range 0 to 255;
  signal transform_left_filter_column_4_4, transform_left_filter_column_4_5 : natural range 0 to 255;
  signal transform_left_filter_column_4_6, transform_left_filter_column_5_0 : natural range 0 to 255;
  signal transform_left_filter_column_5_1, transform_left_filter_column_5_2 : natural range 0 to 255;
  signal transform_left_filter_column_5_3, transform_left_filter_column_5_4 : natural range 0 to 255;
  signal transform_left_filter_column_5_5, transform_left_filter_column_5_6 : natural range 0 to 255;
  signal transform_left_filter_column_6_0, transform_left_filter_column_6_1 : natural range 0 to 255;
  signal transform_left_filter_column_6_2, transform_left_filter_column_6_3 : natural range 0 to 255;
  signal transform_left_filter_column_6_4, transform_left_filter_column_6_5 : natural range 0 to 255;
  signal transform_left_filter_column_6_6, transform_left_filter_column_7_0 : natural range 0 to 255;
  signal transform_left_filter_column_7_1, transform_left_filter_column_7_2 : natural range 0 to 255;
  signal transform_left_filter_column_7_3, transform_left_filter_column_7_4 : natural range 0 to 255;
  signal transform_left_filter_column_7_5, transform_left_filter_column_7_6 : natural range 0 to 255;
  signal transform_left_filter_column_8_0, transform_left_filter_column_8_1 : natural range 0 to 255;
  signal transform_left_filter_column_8_2, transform_left_filter_column_8_3 : natural range 0 to 255;
  signal transform_left_filter_column_8_4, transform_left_filter_column_8_5 : natural range 0 to 255;
  signal transform_left_filter_column_8_6, transform_right_filter_column_0_0 : natural range 0 to 255;
  signal transform_right_filter_column_0_1, transform_right_filter_column_0_2 : natural range 0 to 255;
  signal transform_right_filter_column_0_3, transform_right_filter_column_0_4 : natural range 0 to 255;
  signal transform_right_filter_column_0_5, transform_right_filter_column_0_6 : natural range 0 to 255;
  signal transform_right_filter_column_1_0, transform_right_filter_column_1_1 : natural range 0 to 255;
  signal transform_right_filter_column_1_2, transform_right_filter_column_1_3 : natural range 0 to 255;
  signal transform_right_filter_column_1_4, transform_right_filter_column_1_5 : natural range 0 to 255;
  signal transform_right_filter_column_1_6, transform_right_filter_column_2_0 : natural range 0 to 255;
  signal transform_right_filter_column_2_1, transform_right_filter_column_2_2 : natural range 0 to 255;
  signal transform_right_filter_column_2_3, transform_right_filter_column_2_4 : natural range 0 to 255;
  signal transform_right_filter_column_2_5, transform_right_filter_column_2_6 : natural range 0 to 255;
  signal transform_right_filter_column_3_0, transform_right_filter_column_3_1 : natural range 0 to 255;
  signal transform_right_filter_column_3_2, transform_right_filter_column_3_3 : natural range 0 to 255;
  signal transform_right_filter_column_3_4, transform_right_filter_column_3_5 : natural range 0 to 255;
  signal transform_right_filter_column_3_6, transform_right_filter_column_4_0 : natural range 0 to 255;
  signal transform_right_filter_column_4_1, transform_right_filter_column_4_2 : natural range 0 to 255;
  signal transform_right_filter_column_4_3, transform_right_filter_column_4_4 : natural range 0 to 255;
  signal transform_right_filter_column_4_5, transform_right_filter_column_4_6 : natural range 0 to 255;
  signal transform_right_filter_column_5_0, transform_right_filter_column_5_1 : natural range 0 to 255;
  signal transform_right_filter_column_5_2, transform_right_filter_column_5_3 : natural range 0 to 255;
  signal transform_right_filter_column_5_4, transform_right_filter_column_5_5 : natural range 0 to 255;
  signal transform_right_filter_column_5_6, transform_right_filter_column_6_0 : natural range 0 to 255;
  signal transform_right_filter_column_6_1, transform_right_filter_column_6_2 : natural range 0 to 255;
  signal transform_right_filter_column_6_3, transform_right_filter_column_6_4 : natural range 0 to 255;
  signal transform_right_filter_column_6_5, transform_right_filter_column_6_6 : natural range 0 to 255;
  signal transform_right_filter_column_7_0, transform_right_filter_column_7_1 : natural range 0 to 255;
  signal transform_right_filter_column_7_2, transform_right_filter_column_7_3 : natural range 0 to 255;
  signal transform_right_filter_column_7_4, transform_right_filter_column_7_5 : natural range 0 to 255;
  signal transform_right_filter_column_7_6, transform_right_filter_column_8_0 : natural range 0 to 255;
  signal transform_right_filter_column_8_1, transform_right_filter_column_8_2 : natural range 0 to 255;
  signal transform_right_filter_column_8_3, transform_right_filter_column_8_4 : natural range 0 to 255;
  signal transform_right_filter_column_8_5, transform_right_filter_column_8_6 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_1, transform_read_row_inside_2, transform_read_row_inside_3 : boolean;
  signal transform_read_row_inside_4, transform_read_row_inside_5, transform_read_row_inside_6 : boolean;
  signal transform_read_column_inside_0, transform_read_column_inside_1, transform_read_column_inside_2 : boolean;
  signal transform_read_column_inside_3, transform_read_column_inside_4, transform_read_column_inside_5 : boolean;
  signal transform_read_column_inside_6, transform_read_column_inside_7, transform_read_column_inside_8 : boolean;
  signal transform_read_start_of_frame, transform_read_valid, transform_ready_row_inside_0 : boolean;
  signal transform_ready_row_inside_1, transform_ready_row_inside_2, transform_ready_row_inside_3 : boolean;
  signal transform_ready_row_inside_4, transform_ready_row_inside_5, transform_ready_row_inside_6 : boolean;
  signal transform_ready_column_inside_0, transform_ready_column_inside_1, transform_ready_column_inside_2 : boolean;
  signal transform_ready_column_inside_3, transform_ready_column_inside_4, transform_ready_column_inside_5 : boolean;
  signal transform_ready_column_inside_6, transform_ready_column_inside_7, transform_ready_column_inside_8 : boolean;
  signal transform_ready_start_of_frame, transform_ready_valid, transform_columns_row_inside_0 : boolean;
  signal transform_columns_row_inside_1, transform_columns_row_inside_2, transform_columns_row_inside_3 : boolean;
  signal transform_columns_row_inside_4, transform_columns_row_inside_5, transform_columns_row_inside_6 : boolean;
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
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 31;
  signal transform_write_column : natural range 0 to 31;
  signal transform_counter_group : natural range 0 to 15;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_read_words_1, transform_right_rows_read_words_1 : unsigned(15 downto 0);
  signal transform_left_rows_ready_words_1, transform_left_rows_write_words_1 : natural range 0 to 65535;
  signal transform_right_rows_ready_words_1, transform_right_rows_write_words_1 : natural range 0 to 65535;
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : unsigned(61 downto 0);
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : unsigned(61 downto 0);
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 31;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 7;
  signal delay_ahead_0, delay_delayed_0 : unsigned(61 downto 0);
  signal delay_column : natural range 0 to 31;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_2, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(61 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_words_0 : unsigned(61 downto 0);
  signal rows_search_rows_ready_words_1, rows_search_rows_ready_newest_0 : unsigned(61 downto 0);
  signal rows_search_rows_write_words_0, rows_search_rows_write_words_1 : unsigned(61 downto 0);
  signal rows_reference_rows_read_words_0, rows_reference_rows_read_words_1 : unsigned(61 downto 0);
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_words_0 : unsigned(61 downto 0);
  signal rows_reference_rows_ready_words_1, rows_reference_rows_ready_newest_0 : unsigned(61 downto 0);
  signal rows_reference_rows_write_words_0, rows_reference_rows_write_words_1, rows_search_0 : unsigned(61 downto 0);
  signal rows_search_1, rows_search_2, rows_reference_0, rows_reference_1, rows_reference_2 : unsigned(61 downto 0);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_2, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_output_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_2 : boolean;
  signal rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : unsigned(61 downto 0);
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_1_0 : unsigned(61 downto 0);
  signal slice0shift_search_1_1, slice0shift_search_1_2, slice0shift_search_1_3 : unsigned(61 downto 0);
  signal slice0shift_search_1_4, slice0shift_search_2_0, slice0shift_search_2_1 : unsigned(61 downto 0);
  signal slice0shift_search_2_2, slice0shift_search_2_3, slice0shift_search_2_4 : unsigned(61 downto 0);
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : unsigned(61 downto 0);
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0_count_0, slice0cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_2, slice0cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_4, slice0cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_6, slice0cost_pixels_first_0_0_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_8, slice0cost_pixels_first_0_0_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_10, slice0cost_pixels_first_0_0_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_12, slice0cost_pixels_first_0_0_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_14, slice0cost_pixels_first_0_0_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_16, slice0cost_pixels_first_0_0_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_18, slice0cost_pixels_first_0_0_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_0, slice0cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_2, slice0cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_4, slice0cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_6, slice0cost_pixels_first_0_1_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_8, slice0cost_pixels_first_0_1_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_10, slice0cost_pixels_first_0_1_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_12, slice0cost_pixels_first_0_1_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_14, slice0cost_pixels_first_0_1_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_16, slice0cost_pixels_first_0_1_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_1_count_18, slice0cost_pixels_first_0_1_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_0, slice0cost_pixels_first_0_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_2, slice0cost_pixels_first_0_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_4, slice0cost_pixels_first_0_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_6, slice0cost_pixels_first_0_2_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_8, slice0cost_pixels_first_0_2_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_10, slice0cost_pixels_first_0_2_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_12, slice0cost_pixels_first_0_2_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_14, slice0cost_pixels_first_0_2_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_16, slice0cost_pixels_first_0_2_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_2_count_18, slice0cost_pixels_first_0_2_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_0, slice0cost_pixels_first_0_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_2, slice0cost_pixels_first_0_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_4, slice0cost_pixels_first_0_3_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_6, slice0cost_pixels_first_0_3_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_8, slice0cost_pixels_first_0_3_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_10, slice0cost_pixels_first_0_3_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_12, slice0cost_pixels_first_0_3_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_14, slice0cost_pixels_first_0_3_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_16, slice0cost_pixels_first_0_3_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_3_count_18, slice0cost_pixels_first_0_3_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_0, slice0cost_pixels_first_0_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_2, slice0cost_pixels_first_0_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_4, slice0cost_pixels_first_0_4_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_6, slice0cost_pixels_first_0_4_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_8, slice0cost_pixels_first_0_4_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_10, slice0cost_pixels_first_0_4_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_12, slice0cost_pixels_first_0_4_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_14, slice0cost_pixels_first_0_4_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_16, slice0cost_pixels_first_0_4_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_4_count_18, slice0cost_pixels_first_0_4_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_0, slice0cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_2, slice0cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_4, slice0cost_pixels_first_1_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_6, slice0cost_pixels_first_1_0_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_8, slice0cost_pixels_first_1_0_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_10, slice0cost_pixels_first_1_0_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_12, slice0cost_pixels_first_1_0_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_14, slice0cost_pixels_first_1_0_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_16, slice0cost_pixels_first_1_0_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_0_count_18, slice0cost_pixels_first_1_0_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_0, slice0cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_2, slice0cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_4, slice0cost_pixels_first_1_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_6, slice0cost_pixels_first_1_1_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_8, slice0cost_pixels_first_1_1_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_10, slice0cost_pixels_first_1_1_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_12, slice0cost_pixels_first_1_1_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_14, slice0cost_pixels_first_1_1_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_16, slice0cost_pixels_first_1_1_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_1_count_18, slice0cost_pixels_first_1_1_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_0, slice0cost_pixels_first_1_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_2, slice0cost_pixels_first_1_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_4, slice0cost_pixels_first_1_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_6, slice0cost_pixels_first_1_2_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_8, slice0cost_pixels_first_1_2_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_10, slice0cost_pixels_first_1_2_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_12, slice0cost_pixels_first_1_2_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_14, slice0cost_pixels_first_1_2_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_16, slice0cost_pixels_first_1_2_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_2_count_18, slice0cost_pixels_first_1_2_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_0, slice0cost_pixels_first_1_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_2, slice0cost_pixels_first_1_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_4, slice0cost_pixels_first_1_3_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_6, slice0cost_pixels_first_1_3_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_8, slice0cost_pixels_first_1_3_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_10, slice0cost_pixels_first_1_3_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_12, slice0cost_pixels_first_1_3_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_14, slice0cost_pixels_first_1_3_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_16, slice0cost_pixels_first_1_3_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_3_count_18, slice0cost_pixels_first_1_3_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_0, slice0cost_pixels_first_1_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_2, slice0cost_pixels_first_1_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_4, slice0cost_pixels_first_1_4_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_6, slice0cost_pixels_first_1_4_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_8, slice0cost_pixels_first_1_4_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_10, slice0cost_pixels_first_1_4_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_12, slice0cost_pixels_first_1_4_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_14, slice0cost_pixels_first_1_4_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_16, slice0cost_pixels_first_1_4_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_1_4_count_18, slice0cost_pixels_first_1_4_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_0, slice0cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_2, slice0cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_4, slice0cost_pixels_first_2_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_6, slice0cost_pixels_first_2_0_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_8, slice0cost_pixels_first_2_0_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_10, slice0cost_pixels_first_2_0_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_12, slice0cost_pixels_first_2_0_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_14, slice0cost_pixels_first_2_0_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_16, slice0cost_pixels_first_2_0_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_18, slice0cost_pixels_first_2_0_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_0, slice0cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_2, slice0cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_4, slice0cost_pixels_first_2_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_6, slice0cost_pixels_first_2_1_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_8, slice0cost_pixels_first_2_1_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_10, slice0cost_pixels_first_2_1_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_12, slice0cost_pixels_first_2_1_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_14, slice0cost_pixels_first_2_1_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_16, slice0cost_pixels_first_2_1_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_18, slice0cost_pixels_first_2_1_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_0, slice0cost_pixels_first_2_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_2, slice0cost_pixels_first_2_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_4, slice0cost_pixels_first_2_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_6, slice0cost_pixels_first_2_2_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_8, slice0cost_pixels_first_2_2_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_10, slice0cost_pixels_first_2_2_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_12, slice0cost_pixels_first_2_2_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_14, slice0cost_pixels_first_2_2_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_16, slice0cost_pixels_first_2_2_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_18, slice0cost_pixels_first_2_2_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_0, slice0cost_pixels_first_2_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_2, slice0cost_pixels_first_2_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_4, slice0cost_pixels_first_2_3_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_6, slice0cost_pixels_first_2_3_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_8, slice0cost_pixels_first_2_3_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_10, slice0cost_pixels_first_2_3_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_12, slice0cost_pixels_first_2_3_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_14, slice0cost_pixels_first_2_3_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_16, slice0cost_pixels_first_2_3_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_18, slice0cost_pixels_first_2_3_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_0, slice0cost_pixels_first_2_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_2, slice0cost_pixels_first_2_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_4, slice0cost_pixels_first_2_4_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_6, slice0cost_pixels_first_2_4_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_8, slice0cost_pixels_first_2_4_count_9 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_10, slice0cost_pixels_first_2_4_count_11 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_12, slice0cost_pixels_first_2_4_count_13 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_14, slice0cost_pixels_first_2_4_count_15 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_16, slice0cost_pixels_first_2_4_count_17 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_18, slice0cost_pixels_first_2_4_count_19 : natural range 0 to 3;
  signal slice0cost_pixels_first_0_0_count_20, slice0cost_pixels_first_0_1_count_20 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_2_count_20, slice0cost_pixels_first_0_3_count_20 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_4_count_20, slice0cost_pixels_first_1_0_count_20 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_1_count_20, slice0cost_pixels_first_1_2_count_20 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_3_count_20, slice0cost_pixels_first_1_4_count_20 : natural range 0 to 2;
  signal slice0cost_pixels_first_2_0_count_20, slice0cost_pixels_first_2_1_count_20 : natural range 0 to 2;
  signal slice0cost_pixels_first_2_2_count_20, slice0cost_pixels_first_2_3_count_20 : natural range 0 to 2;
  signal slice0cost_pixels_first_2_4_count_20 : natural range 0 to 2;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_border_column, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_pair_tag_valid : boolean;
  signal slice0cost_pair_tag_border_column, slice0cost_pair_tag_output_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 62;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_1_0 : natural range 0 to 62;
  signal slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2, slice0cost_pixels_cost_1_3 : natural range 0 to 62;
  signal slice0cost_pixels_cost_1_4, slice0cost_pixels_cost_2_0, slice0cost_pixels_cost_2_1 : natural range 0 to 62;
  signal slice0cost_pixels_cost_2_2, slice0cost_pixels_cost_2_3, slice0cost_pixels_cost_2_4 : natural range 0 to 62;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 62;
  signal slice0cost_single_0_3, slice0cost_single_0_4 : natural range 0 to 62;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_0_3 : natural range 0 to 124;
  signal slice0cost_pair_0_4 : natural range 0 to 124;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 186;
  signal slice0cost_column_0_3, slice0cost_column_0_4 : natural range 0 to 186;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 186;
  signal slice0window_partial_0_0_3, slice0window_partial_0_0_4 : natural range 0 to 186;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 372;
  signal slice0window_partial_0_1_3, slice0window_partial_0_1_4 : natural range 0 to 372;
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_output_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 558;
  signal slice0window_sum_0_3, slice0window_sum_0_4 : natural range 0 to 558;
  -- slice0winner1
  signal slice0winner1_of_pair_0_0, slice0winner1_of_pair_0_1, slice0winner1_of_pair_0_2 : natural range 0 to 558;
  signal slice0winner1_of_pair_0_3, slice0winner1_of_pair_0_4, slice0winner1_of_four_0_0 : natural range 0 to 558;
  signal slice0winner1_of_four_0_1, slice0winner1_of_four_0_2, slice0winner1_of_four_0_3 : natural range 0 to 558;
  signal slice0winner1_of_four_0_4, slice0winner1_best_cost_0_1 : natural range 0 to 558;
  signal slice0winner1_pair_index_0_0, slice0winner1_pair_tag_valid, slice0winner1_pair_tag_output_column : boolean;
  signal slice0winner1_pair_tag_start_of_frame, slice0winner1_pair_tag_end_of_line : boolean;
  signal slice0winner1_four_tag_valid, slice0winner1_four_tag_output_column : boolean;
  signal slice0winner1_four_tag_start_of_frame, slice0winner1_four_tag_end_of_line, slice0winner1_tag_valid : boolean;
  signal slice0winner1_tag_output_column, slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_pair_index_0_1, slice0winner1_four_index_0_0 : natural range 0 to 3;
  signal slice0winner1_best_index_0_0 : natural range 0 to 3;
  signal slice0winner1_pair_index_0_2, slice0winner1_four_index_0_1 : natural range 0 to 4;
  signal slice0winner1_best_index_0_1 : natural range 0 to 4;
  signal slice0winner1_best_cost_0_0 : natural range 0 to 1023;
  -- slice0winner2
  signal slice0winner2_best_index_0_0 : natural range 0 to 4;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 4;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  signal transform_left_rows_read_words_1_memory_read_enable : boolean;
  signal transform_left_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal transform_left_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal transform_left_rows_read_words_1_memory_write_data : unsigned(15 downto 0);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_1_memory_read_enable : boolean;
  signal transform_right_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal transform_right_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal transform_right_rows_read_words_1_memory_write_data : unsigned(15 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(61 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(61 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(61 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(61 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(2 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(2 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(61 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice0_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice0_best_tag_valid and slice0_best_tag_output_column);
  disparity_start_of_frame <= as_bit(slice0_best_tag_start_of_frame and slice0_best_tag_valid and slice0_best_tag_output_column);
  disparity_end_of_line <= as_bit(slice0_best_tag_end_of_line and slice0_best_tag_valid and slice0_best_tag_output_column);

  transform_left_rows_read_words_1_memory_read_enable <= true;
  transform_left_rows_read_words_1_memory_read_address <= to_unsigned(transform_counter_column, 5);
  transform_left_rows_read_words_1_memory_write_address <= to_unsigned(transform_write_column, 5);
  transform_left_rows_read_words_1_memory_write_data <= to_unsigned(transform_left_rows_write_words_1, 16);
  transform_left_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 16, address_bits => 5)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_1_memory_read_enable,
      read_address => transform_left_rows_read_words_1_memory_read_address, read_data => transform_left_rows_read_words_1,
      write_address => transform_left_rows_read_words_1_memory_write_address, write_data => transform_left_rows_read_words_1_memory_write_data);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 5);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 5);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_1_memory_read_enable <= true;
  transform_right_rows_read_words_1_memory_read_address <= to_unsigned(transform_counter_column, 5);
  transform_right_rows_read_words_1_memory_write_address <= to_unsigned(transform_write_column, 5);
  transform_right_rows_read_words_1_memory_write_data <= to_unsigned(transform_right_rows_write_words_1, 16);
  transform_right_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 16, address_bits => 5)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_1_memory_read_enable,
      read_address => transform_right_rows_read_words_1_memory_read_address, read_data => transform_right_rows_read_words_1,
      write_address => transform_right_rows_read_words_1_memory_write_address, write_data => transform_right_rows_read_words_1_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 5);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 5);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_1_memory_write_data <= rows_search_rows_write_words_1;
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 62, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_0_memory_write_data <= rows_search_rows_write_words_0;
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 62, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_1_memory_write_data <= rows_reference_rows_write_words_1;
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 62, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_0_memory_write_data <= rows_reference_rows_write_words_0;
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 62, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 3);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 3);
  delay_delayed_0_memory_write_data <= raster_features_reference_0;
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 5, width => 62, address_bits => 3)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_all : boolean;
    variable transform_counter_group_is_equal_2, transform_counter_group_choice_2 : boolean;
    variable transform_read_column_inside_0_value, transform_read_column_inside_0_value_2 : boolean;
    variable transform_read_column_inside_0_any, transform_read_column_inside_1_value : boolean;
    variable transform_read_column_inside_1_all, transform_read_column_inside_1_choice : boolean;
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
    variable transform_left_filter_feature_0_choice_17, transform_left_filter_feature_0_choice_18 : boolean;
    variable transform_left_filter_feature_0_choice_19, transform_left_filter_feature_0_choice_20 : boolean;
    variable transform_left_filter_feature_0_choice_21, transform_left_filter_feature_0_choice_22 : boolean;
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
    variable transform_left_filter_feature_0_choice_193, transform_left_filter_feature_0_choice_194 : boolean;
    variable transform_left_filter_feature_0_choice_195, transform_left_filter_feature_0_choice_196 : boolean;
    variable transform_left_filter_feature_0_choice_197, transform_left_filter_feature_0_choice_198 : boolean;
    variable transform_left_filter_feature_0_choice_199, transform_left_filter_feature_0_choice_200 : boolean;
    variable transform_left_filter_feature_0_choice_201, transform_left_filter_feature_0_choice_202 : boolean;
    variable transform_left_filter_feature_0_choice_203, transform_left_filter_feature_0_choice_204 : boolean;
    variable transform_left_filter_feature_0_choice_205, transform_left_filter_feature_0_choice_206 : boolean;
    variable transform_left_filter_feature_0_choice_207, transform_left_filter_feature_0_choice_208 : boolean;
    variable transform_left_filter_feature_0_choice_209, transform_left_filter_feature_0_choice_210 : boolean;
    variable transform_left_filter_feature_0_choice_211, transform_left_filter_feature_0_choice_212 : boolean;
    variable transform_left_filter_feature_0_choice_213, transform_left_filter_feature_0_choice_214 : boolean;
    variable transform_left_filter_feature_0_choice_215, transform_left_filter_feature_0_choice_216 : boolean;
    variable transform_left_filter_feature_0_choice_217, transform_left_filter_feature_0_choice_218 : boolean;
    variable transform_left_filter_feature_0_choice_219, transform_left_filter_feature_0_choice_220 : boolean;
    variable transform_left_filter_feature_0_choice_221, transform_left_filter_feature_0_choice_222 : boolean;
    variable transform_left_filter_feature_0_choice_223, transform_left_filter_feature_0_choice_224 : boolean;
    variable transform_left_filter_feature_0_choice_225, transform_left_filter_feature_0_choice_226 : boolean;
    variable transform_left_filter_feature_0_choice_227, transform_left_filter_feature_0_choice_228 : boolean;
    variable transform_left_filter_feature_0_choice_229, transform_left_filter_feature_0_choice_230 : boolean;
    variable transform_left_filter_feature_0_choice_231, transform_left_filter_feature_0_choice_232 : boolean;
    variable transform_left_filter_feature_0_choice_233, transform_left_filter_feature_0_choice_234 : boolean;
    variable transform_left_filter_feature_0_choice_235, transform_left_filter_feature_0_choice_236 : boolean;
    variable transform_left_filter_feature_0_choice_237, transform_left_filter_feature_0_choice_238 : boolean;
    variable transform_left_filter_feature_0_choice_239, transform_left_filter_feature_0_choice_240 : boolean;
    variable transform_left_filter_feature_0_choice_241, transform_left_filter_feature_0_choice_242 : boolean;
    variable transform_left_filter_feature_0_choice_243, transform_left_filter_feature_0_choice_244 : boolean;
    variable transform_left_filter_feature_0_choice_245, transform_left_filter_feature_0_choice_246 : boolean;
    variable transform_left_filter_feature_0_choice_247, transform_left_filter_feature_0_choice_248 : boolean;
    variable transform_left_filter_feature_0_choice_249, transform_left_filter_feature_0_choice_250 : boolean;
    variable transform_left_filter_feature_0_choice_251, transform_left_filter_feature_0_choice_252 : boolean;
    variable transform_left_filter_feature_0_choice_253, transform_left_filter_feature_0_choice_254 : boolean;
    variable transform_left_filter_feature_0_choice_255, transform_left_filter_feature_0_choice_256 : boolean;
    variable transform_left_filter_feature_0_choice_257, transform_left_filter_feature_0_choice_258 : boolean;
    variable transform_left_filter_feature_0_choice_259, transform_left_filter_feature_0_choice_260 : boolean;
    variable transform_left_filter_feature_0_choice_261, transform_left_filter_feature_0_choice_262 : boolean;
    variable transform_left_filter_feature_0_choice_263, transform_left_filter_feature_0_choice_264 : boolean;
    variable transform_left_filter_feature_0_choice_265, transform_left_filter_feature_0_choice_266 : boolean;
    variable transform_left_filter_feature_0_choice_267, transform_left_filter_feature_0_choice_268 : boolean;
    variable transform_left_filter_feature_0_choice_269, transform_left_filter_feature_0_choice_270 : boolean;
    variable transform_left_filter_feature_0_choice_271, transform_left_filter_feature_0_choice_272 : boolean;
    variable transform_left_filter_feature_0_choice_273, transform_left_filter_feature_0_choice_274 : boolean;
    variable transform_left_filter_feature_0_choice_275, transform_left_filter_feature_0_choice_276 : boolean;
    variable transform_left_filter_feature_0_choice_277, transform_left_filter_feature_0_choice_278 : boolean;
    variable transform_left_filter_feature_0_choice_279, transform_left_filter_feature_0_choice_280 : boolean;
    variable transform_left_filter_feature_0_choice_281, transform_left_filter_feature_0_choice_282 : boolean;
    variable transform_left_filter_feature_0_choice_283, transform_left_filter_feature_0_choice_284 : boolean;
    variable transform_left_filter_feature_0_choice_285, transform_left_filter_feature_0_choice_286 : boolean;
    variable transform_left_filter_feature_0_choice_287, transform_left_filter_feature_0_choice_288 : boolean;
    variable transform_left_filter_feature_0_choice_289, transform_left_filter_feature_0_choice_290 : boolean;
    variable transform_left_filter_feature_0_choice_291, transform_left_filter_feature_0_choice_292 : boolean;
    variable transform_left_filter_feature_0_choice_293, transform_left_filter_feature_0_choice_294 : boolean;
    variable transform_left_filter_feature_0_choice_295, transform_left_filter_feature_0_choice_296 : boolean;
    variable transform_left_filter_feature_0_choice_297, transform_left_filter_feature_0_choice_298 : boolean;
    variable transform_left_filter_feature_0_choice_299, transform_left_filter_feature_0_choice_300 : boolean;
    variable transform_left_filter_feature_0_choice_301, transform_left_filter_feature_0_choice_302 : boolean;
    variable transform_left_filter_feature_0_choice_303, transform_left_filter_feature_0_choice_304 : boolean;
    variable transform_left_filter_feature_0_choice_305, transform_left_filter_feature_0_choice_306 : boolean;
    variable transform_left_filter_feature_0_choice_307, transform_left_filter_feature_0_choice_308 : boolean;
    variable transform_left_filter_feature_0_choice_309, transform_left_filter_feature_0_choice_310 : boolean;
    variable transform_left_filter_feature_0_choice_311, transform_left_filter_feature_0_choice_312 : boolean;
    variable transform_left_filter_feature_0_choice_313, transform_left_filter_feature_0_choice_314 : boolean;
    variable transform_left_filter_feature_0_choice_315, transform_left_filter_feature_0_choice_316 : boolean;
    variable transform_left_filter_feature_0_choice_317, transform_left_filter_feature_0_choice_318 : boolean;
    variable transform_left_filter_feature_0_choice_319, transform_left_filter_feature_0_choice_320 : boolean;
    variable transform_left_filter_feature_0_choice_321, transform_left_filter_feature_0_choice_322 : boolean;
    variable transform_left_filter_feature_0_choice_323, transform_left_filter_feature_0_choice_324 : boolean;
    variable transform_left_filter_feature_0_choice_325, transform_left_filter_feature_0_choice_326 : boolean;
    variable transform_left_filter_feature_0_choice_327, transform_left_filter_feature_0_choice_328 : boolean;
    variable transform_left_filter_feature_0_choice_329, transform_left_filter_feature_0_choice_330 : boolean;
    variable transform_left_filter_feature_0_choice_331, transform_left_filter_feature_0_choice_332 : boolean;
    variable transform_left_filter_feature_0_choice_333, transform_left_filter_feature_0_choice_334 : boolean;
    variable transform_left_filter_feature_0_choice_335, transform_left_filter_feature_0_choice_336 : boolean;
    variable transform_left_filter_feature_0_choice_337, transform_left_filter_feature_0_choice_338 : boolean;
    variable transform_left_filter_feature_0_choice_339, transform_left_filter_feature_0_choice_340 : boolean;
    variable transform_left_filter_feature_0_choice_341, transform_left_filter_feature_0_choice_342 : boolean;
    variable transform_left_filter_feature_0_choice_343, transform_left_filter_feature_0_choice_344 : boolean;
    variable transform_left_filter_feature_0_choice_345, transform_left_filter_feature_0_choice_346 : boolean;
    variable transform_left_filter_feature_0_choice_347, transform_left_filter_feature_0_choice_348 : boolean;
    variable transform_left_filter_feature_0_choice_349, transform_left_filter_feature_0_choice_350 : boolean;
    variable transform_left_filter_feature_0_choice_351, transform_left_filter_feature_0_choice_352 : boolean;
    variable transform_left_filter_feature_0_choice_353, transform_left_filter_feature_0_choice_354 : boolean;
    variable transform_left_filter_feature_0_choice_355, transform_left_filter_feature_0_choice_356 : boolean;
    variable transform_left_filter_feature_0_choice_357, transform_left_filter_feature_0_choice_358 : boolean;
    variable transform_left_filter_feature_0_choice_359, transform_left_filter_feature_0_choice_360 : boolean;
    variable transform_left_filter_feature_0_choice_361, transform_left_filter_feature_0_choice_362 : boolean;
    variable transform_left_filter_feature_0_choice_363, transform_left_filter_feature_0_choice_364 : boolean;
    variable transform_left_filter_feature_0_choice_365, transform_left_filter_feature_0_choice_366 : boolean;
    variable transform_left_filter_feature_0_choice_367, transform_left_filter_feature_0_choice_368 : boolean;
    variable transform_left_filter_feature_0_choice_369, transform_left_filter_feature_0_choice_370 : boolean;
    variable transform_left_filter_feature_0_choice_371, transform_left_filter_feature_0_choice_372 : boolean;
    variable transform_left_filter_feature_0_choice_373, transform_left_filter_feature_0_choice_374 : boolean;
    variable transform_left_filter_feature_0_choice_375, transform_left_filter_feature_0_choice_376 : boolean;
    variable transform_left_filter_feature_0_choice_377, transform_left_filter_feature_0_choice_378 : boolean;
    variable transform_left_filter_feature_0_choice_379, transform_left_filter_feature_0_choice_380 : boolean;
    variable transform_left_filter_feature_0_choice_381, transform_left_filter_feature_0_choice_382 : boolean;
    variable transform_left_filter_feature_0_choice_383, transform_left_filter_feature_0_choice_384 : boolean;
    variable transform_left_filter_feature_0_choice_385, transform_left_filter_feature_0_choice_386 : boolean;
    variable transform_left_filter_feature_0_choice_387, transform_left_filter_feature_0_choice_388 : boolean;
    variable transform_left_filter_feature_0_choice_389, transform_left_filter_feature_0_choice_390 : boolean;
    variable transform_left_filter_feature_0_choice_391, transform_left_filter_feature_0_choice_392 : boolean;
    variable transform_left_filter_feature_0_choice_393, transform_left_filter_feature_0_choice_394 : boolean;
    variable transform_left_filter_feature_0_choice_395, transform_left_filter_feature_0_choice_396 : boolean;
    variable transform_left_filter_feature_0_choice_397, transform_left_filter_feature_0_choice_398 : boolean;
    variable transform_left_filter_feature_0_choice_399, transform_left_filter_feature_0_choice_400 : boolean;
    variable transform_left_filter_feature_0_choice_401, transform_left_filter_feature_0_choice_402 : boolean;
    variable transform_left_filter_feature_0_choice_403, transform_left_filter_feature_0_choice_404 : boolean;
    variable transform_left_filter_feature_0_choice_405, transform_left_filter_feature_0_choice_406 : boolean;
    variable transform_left_filter_feature_0_choice_407, transform_left_filter_feature_0_choice_408 : boolean;
    variable transform_left_filter_feature_0_choice_409, transform_left_filter_feature_0_choice_410 : boolean;
    variable transform_left_filter_feature_0_choice_411, transform_left_filter_feature_0_choice_412 : boolean;
    variable transform_left_filter_feature_0_choice_413, transform_left_filter_feature_0_choice_414 : boolean;
    variable transform_left_filter_feature_0_choice_415, transform_left_filter_feature_0_choice_416 : boolean;
    variable transform_left_filter_feature_0_choice_417, transform_left_filter_feature_0_choice_418 : boolean;
    variable transform_left_filter_feature_0_choice_419, transform_left_filter_feature_0_choice_420 : boolean;
    variable transform_left_filter_feature_0_choice_421, transform_left_filter_feature_0_choice_422 : boolean;
    variable transform_left_filter_feature_0_choice_423, transform_left_filter_feature_0_choice_424 : boolean;
    variable transform_left_filter_feature_0_choice_425, transform_left_filter_feature_0_choice_426 : boolean;
    variable transform_left_filter_feature_0_choice_427, transform_left_filter_feature_0_choice_428 : boolean;
    variable transform_left_filter_feature_0_choice_429, transform_left_filter_feature_0_choice_430 : boolean;
    variable transform_left_filter_feature_0_choice_431, transform_left_filter_feature_0_choice_432 : boolean;
    variable transform_left_filter_feature_0_choice_433, transform_left_filter_feature_0_choice_434 : boolean;
    variable transform_left_filter_feature_0_choice_435, transform_left_filter_feature_0_choice_436 : boolean;
    variable transform_left_filter_feature_0_choice_437, transform_left_filter_feature_0_choice_438 : boolean;
    variable transform_left_filter_feature_0_choice_439, transform_left_filter_feature_0_choice_440 : boolean;
    variable transform_left_filter_feature_0_choice_441, transform_left_filter_feature_0_choice_442 : boolean;
    variable transform_left_filter_feature_0_choice_443, transform_left_filter_feature_0_choice_444 : boolean;
    variable transform_left_filter_feature_0_choice_445, transform_left_filter_feature_0_choice_446 : boolean;
    variable transform_left_filter_feature_0_choice_447, transform_left_filter_feature_0_choice_448 : boolean;
    variable transform_left_filter_feature_0_choice_449, transform_left_filter_feature_0_choice_450 : boolean;
    variable transform_left_filter_feature_0_choice_451, transform_left_filter_feature_0_choice_452 : boolean;
    variable transform_left_filter_feature_0_choice_453, transform_left_filter_feature_0_choice_454 : boolean;
    variable transform_left_filter_feature_0_choice_455, transform_left_filter_feature_0_choice_456 : boolean;
    variable transform_left_filter_feature_0_choice_457, transform_left_filter_feature_0_choice_458 : boolean;
    variable transform_left_filter_feature_0_choice_459, transform_left_filter_feature_0_choice_460 : boolean;
    variable transform_left_filter_feature_0_choice_461, transform_left_filter_feature_0_choice_462 : boolean;
    variable transform_left_filter_feature_0_choice_463, transform_left_filter_feature_0_choice_464 : boolean;
    variable transform_left_filter_feature_0_choice_465, transform_left_filter_feature_0_choice_466 : boolean;
    variable transform_left_filter_feature_0_choice_467, transform_left_filter_feature_0_choice_468 : boolean;
    variable transform_left_filter_feature_0_choice_469, transform_left_filter_feature_0_choice_470 : boolean;
    variable transform_left_filter_feature_0_choice_471, transform_left_filter_feature_0_choice_472 : boolean;
    variable transform_left_filter_feature_0_choice_473, transform_left_filter_feature_0_choice_474 : boolean;
    variable transform_left_filter_feature_0_choice_475, transform_left_filter_feature_0_choice_476 : boolean;
    variable transform_left_filter_feature_0_choice_477, transform_left_filter_feature_0_choice_478 : boolean;
    variable transform_left_filter_feature_0_choice_479, transform_left_filter_feature_0_choice_480 : boolean;
    variable transform_left_filter_feature_0_choice_481, transform_left_filter_feature_0_choice_482 : boolean;
    variable transform_left_filter_feature_0_choice_483, transform_left_filter_feature_0_choice_484 : boolean;
    variable transform_left_filter_feature_0_choice_485, transform_left_filter_feature_0_choice_486 : boolean;
    variable transform_left_filter_feature_0_choice_487, transform_left_filter_feature_0_choice_488 : boolean;
    variable transform_left_filter_feature_0_choice_489, transform_left_filter_feature_0_choice_490 : boolean;
    variable transform_left_filter_feature_0_value_7, transform_left_filter_feature_0_choice_491 : boolean;
    variable transform_left_filter_feature_0_value_8, transform_left_filter_feature_0_choice_492 : boolean;
    variable transform_left_filter_feature_0_value_9, transform_left_filter_feature_0_choice_493 : boolean;
    variable transform_left_filter_feature_0_value_10, transform_left_filter_feature_0_choice_494 : boolean;
    variable transform_left_filter_feature_0_value_11, transform_left_filter_feature_0_choice_495 : boolean;
    variable transform_left_filter_feature_0_choice_496, transform_right_filter_feature_0_value : boolean;
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
    variable transform_right_filter_feature_0_choice_18, transform_right_filter_feature_0_choice_19 : boolean;
    variable transform_right_filter_feature_0_choice_20, transform_right_filter_feature_0_choice_21 : boolean;
    variable transform_right_filter_feature_0_choice_22, transform_right_filter_feature_0_choice_23 : boolean;
    variable transform_right_filter_feature_0_choice_24, transform_right_filter_feature_0_choice_25 : boolean;
    variable transform_right_filter_feature_0_choice_26, transform_right_filter_feature_0_choice_27 : boolean;
    variable transform_right_filter_feature_0_choice_28, transform_right_filter_feature_0_choice_29 : boolean;
    variable transform_right_filter_feature_0_choice_30, transform_right_filter_feature_0_choice_31 : boolean;
    variable transform_right_filter_feature_0_choice_32, transform_right_filter_feature_0_choice_33 : boolean;
    variable transform_right_filter_feature_0_choice_34, transform_right_filter_feature_0_choice_35 : boolean;
    variable transform_right_filter_feature_0_choice_36, transform_right_filter_feature_0_choice_37 : boolean;
    variable transform_right_filter_feature_0_choice_38, transform_right_filter_feature_0_choice_39 : boolean;
    variable transform_right_filter_feature_0_choice_40, transform_right_filter_feature_0_choice_41 : boolean;
    variable transform_right_filter_feature_0_choice_42, transform_right_filter_feature_0_choice_43 : boolean;
    variable transform_right_filter_feature_0_choice_44, transform_right_filter_feature_0_choice_45 : boolean;
    variable transform_right_filter_feature_0_choice_46, transform_right_filter_feature_0_choice_47 : boolean;
    variable transform_right_filter_feature_0_choice_48, transform_right_filter_feature_0_choice_49 : boolean;
    variable transform_right_filter_feature_0_choice_50, transform_right_filter_feature_0_choice_51 : boolean;
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
    variable transform_right_filter_feature_0_choice_78, transform_right_filter_feature_0_choice_79 : boolean;
    variable transform_right_filter_feature_0_choice_80, transform_right_filter_feature_0_choice_81 : boolean;
    variable transform_right_filter_feature_0_choice_82, transform_right_filter_feature_0_choice_83 : boolean;
    variable transform_right_filter_feature_0_choice_84, transform_right_filter_feature_0_choice_85 : boolean;
    variable transform_right_filter_feature_0_choice_86, transform_right_filter_feature_0_choice_87 : boolean;
    variable transform_right_filter_feature_0_choice_88, transform_right_filter_feature_0_choice_89 : boolean;
    variable transform_right_filter_feature_0_choice_90, transform_right_filter_feature_0_choice_91 : boolean;
    variable transform_right_filter_feature_0_choice_92, transform_right_filter_feature_0_choice_93 : boolean;
    variable transform_right_filter_feature_0_choice_94, transform_right_filter_feature_0_choice_95 : boolean;
    variable transform_right_filter_feature_0_choice_96, transform_right_filter_feature_0_choice_97 : boolean;
    variable transform_right_filter_feature_0_choice_98, transform_right_filter_feature_0_choice_99 : boolean;
    variable transform_right_filter_feature_0_choice_100, transform_right_filter_feature_0_choice_101 : boolean;
    variable transform_right_filter_feature_0_choice_102, transform_right_filter_feature_0_choice_103 : boolean;
    variable transform_right_filter_feature_0_choice_104, transform_right_filter_feature_0_choice_105 : boolean;
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
    variable transform_right_filter_feature_0_choice_126, transform_right_filter_feature_0_choice_127 : boolean;
    variable transform_right_filter_feature_0_choice_128, transform_right_filter_feature_0_choice_129 : boolean;
    variable transform_right_filter_feature_0_choice_130, transform_right_filter_feature_0_choice_131 : boolean;
    variable transform_right_filter_feature_0_choice_132, transform_right_filter_feature_0_choice_133 : boolean;
    variable transform_right_filter_feature_0_choice_134, transform_right_filter_feature_0_choice_135 : boolean;
    variable transform_right_filter_feature_0_choice_136, transform_right_filter_feature_0_choice_137 : boolean;
    variable transform_right_filter_feature_0_choice_138, transform_right_filter_feature_0_choice_139 : boolean;
    variable transform_right_filter_feature_0_choice_140, transform_right_filter_feature_0_choice_141 : boolean;
    variable transform_right_filter_feature_0_choice_142, transform_right_filter_feature_0_choice_143 : boolean;
    variable transform_right_filter_feature_0_choice_144, transform_right_filter_feature_0_choice_145 : boolean;
    variable transform_right_filter_feature_0_choice_146, transform_right_filter_feature_0_choice_147 : boolean;
    variable transform_right_filter_feature_0_choice_148, transform_right_filter_feature_0_choice_149 : boolean;
    variable transform_right_filter_feature_0_choice_150, transform_right_filter_feature_0_choice_151 : boolean;
    variable transform_right_filter_feature_0_choice_152, transform_right_filter_feature_0_choice_153 : boolean;
    variable transform_right_filter_feature_0_choice_154, transform_right_filter_feature_0_choice_155 : boolean;
    variable transform_right_filter_feature_0_choice_156, transform_right_filter_feature_0_choice_157 : boolean;
    variable transform_right_filter_feature_0_choice_158, transform_right_filter_feature_0_choice_159 : boolean;
    variable transform_right_filter_feature_0_choice_160, transform_right_filter_feature_0_choice_161 : boolean;
    variable transform_right_filter_feature_0_choice_162, transform_right_filter_feature_0_choice_163 : boolean;
    variable transform_right_filter_feature_0_choice_164, transform_right_filter_feature_0_choice_165 : boolean;
    variable transform_right_filter_feature_0_choice_166, transform_right_filter_feature_0_choice_167 : boolean;
    variable transform_right_filter_feature_0_choice_168, transform_right_filter_feature_0_choice_169 : boolean;
    variable transform_right_filter_feature_0_choice_170, transform_right_filter_feature_0_choice_171 : boolean;
    variable transform_right_filter_feature_0_choice_172, transform_right_filter_feature_0_choice_173 : boolean;
    variable transform_right_filter_feature_0_choice_174, transform_right_filter_feature_0_choice_175 : boolean;
    variable transform_right_filter_feature_0_choice_176, transform_right_filter_feature_0_choice_177 : boolean;
    variable transform_right_filter_feature_0_choice_178, transform_right_filter_feature_0_choice_179 : boolean;
    variable transform_right_filter_feature_0_choice_180, transform_right_filter_feature_0_choice_181 : boolean;
    variable transform_right_filter_feature_0_choice_182, transform_right_filter_feature_0_choice_183 : boolean;
    variable transform_right_filter_feature_0_choice_184, transform_right_filter_feature_0_choice_185 : boolean;
    variable transform_right_filter_feature_0_choice_186, transform_right_filter_feature_0_choice_187 : boolean;
    variable transform_right_filter_feature_0_choice_188, transform_right_filter_feature_0_choice_189 : boolean;
    variable transform_right_filter_feature_0_choice_190, transform_right_filter_feature_0_choice_191 : boolean;
    variable transform_right_filter_feature_0_choice_192, transform_right_filter_feature_0_choice_193 : boolean;
    variable transform_right_filter_feature_0_choice_194, transform_right_filter_feature_0_choice_195 : boolean;
    variable transform_right_filter_feature_0_choice_196, transform_right_filter_feature_0_choice_197 : boolean;
    variable transform_right_filter_feature_0_choice_198, transform_right_filter_feature_0_choice_199 : boolean;
    variable transform_right_filter_feature_0_choice_200, transform_right_filter_feature_0_choice_201 : boolean;
    variable transform_right_filter_feature_0_choice_202, transform_right_filter_feature_0_choice_203 : boolean;
    variable transform_right_filter_feature_0_choice_204, transform_right_filter_feature_0_choice_205 : boolean;
    variable transform_right_filter_feature_0_choice_206, transform_right_filter_feature_0_choice_207 : boolean;
    variable transform_right_filter_feature_0_choice_208, transform_right_filter_feature_0_choice_209 : boolean;
    variable transform_right_filter_feature_0_choice_210, transform_right_filter_feature_0_choice_211 : boolean;
    variable transform_right_filter_feature_0_choice_212, transform_right_filter_feature_0_choice_213 : boolean;
    variable transform_right_filter_feature_0_choice_214, transform_right_filter_feature_0_choice_215 : boolean;
    variable transform_right_filter_feature_0_choice_216, transform_right_filter_feature_0_choice_217 : boolean;
    variable transform_right_filter_feature_0_choice_218, transform_right_filter_feature_0_choice_219 : boolean;
    variable transform_right_filter_feature_0_choice_220, transform_right_filter_feature_0_choice_221 : boolean;
    variable transform_right_filter_feature_0_choice_222, transform_right_filter_feature_0_choice_223 : boolean;
    variable transform_right_filter_feature_0_choice_224, transform_right_filter_feature_0_choice_225 : boolean;
    variable transform_right_filter_feature_0_choice_226, transform_right_filter_feature_0_choice_227 : boolean;
    variable transform_right_filter_feature_0_choice_228, transform_right_filter_feature_0_choice_229 : boolean;
    variable transform_right_filter_feature_0_choice_230, transform_right_filter_feature_0_choice_231 : boolean;
    variable transform_right_filter_feature_0_choice_232, transform_right_filter_feature_0_choice_233 : boolean;
    variable transform_right_filter_feature_0_choice_234, transform_right_filter_feature_0_choice_235 : boolean;
    variable transform_right_filter_feature_0_choice_236, transform_right_filter_feature_0_choice_237 : boolean;
    variable transform_right_filter_feature_0_choice_238, transform_right_filter_feature_0_choice_239 : boolean;
    variable transform_right_filter_feature_0_choice_240, transform_right_filter_feature_0_choice_241 : boolean;
    variable transform_right_filter_feature_0_choice_242, transform_right_filter_feature_0_choice_243 : boolean;
    variable transform_right_filter_feature_0_choice_244, transform_right_filter_feature_0_choice_245 : boolean;
    variable transform_right_filter_feature_0_choice_246, transform_right_filter_feature_0_choice_247 : boolean;
    variable transform_right_filter_feature_0_choice_248, transform_right_filter_feature_0_choice_249 : boolean;
    variable transform_right_filter_feature_0_choice_250, transform_right_filter_feature_0_choice_251 : boolean;
    variable transform_right_filter_feature_0_choice_252, transform_right_filter_feature_0_choice_253 : boolean;
    variable transform_right_filter_feature_0_choice_254, transform_right_filter_feature_0_choice_255 : boolean;
    variable transform_right_filter_feature_0_choice_256, transform_right_filter_feature_0_choice_257 : boolean;
    variable transform_right_filter_feature_0_choice_258, transform_right_filter_feature_0_choice_259 : boolean;
    variable transform_right_filter_feature_0_choice_260, transform_right_filter_feature_0_choice_261 : boolean;
    variable transform_right_filter_feature_0_choice_262, transform_right_filter_feature_0_choice_263 : boolean;
    variable transform_right_filter_feature_0_choice_264, transform_right_filter_feature_0_choice_265 : boolean;
    variable transform_right_filter_feature_0_choice_266, transform_right_filter_feature_0_choice_267 : boolean;
    variable transform_right_filter_feature_0_choice_268, transform_right_filter_feature_0_choice_269 : boolean;
    variable transform_right_filter_feature_0_choice_270, transform_right_filter_feature_0_choice_271 : boolean;
    variable transform_right_filter_feature_0_choice_272, transform_right_filter_feature_0_choice_273 : boolean;
    variable transform_right_filter_feature_0_choice_274, transform_right_filter_feature_0_choice_275 : boolean;
    variable transform_right_filter_feature_0_choice_276, transform_right_filter_feature_0_choice_277 : boolean;
    variable transform_right_filter_feature_0_choice_278, transform_right_filter_feature_0_choice_279 : boolean;
    variable transform_right_filter_feature_0_choice_280, transform_right_filter_feature_0_choice_281 : boolean;
    variable transform_right_filter_feature_0_choice_282, transform_right_filter_feature_0_choice_283 : boolean;
    variable transform_right_filter_feature_0_choice_284, transform_right_filter_feature_0_choice_285 : boolean;
    variable transform_right_filter_feature_0_choice_286, transform_right_filter_feature_0_choice_287 : boolean;
    variable transform_right_filter_feature_0_choice_288, transform_right_filter_feature_0_choice_289 : boolean;
    variable transform_right_filter_feature_0_choice_290, transform_right_filter_feature_0_choice_291 : boolean;
    variable transform_right_filter_feature_0_choice_292, transform_right_filter_feature_0_choice_293 : boolean;
    variable transform_right_filter_feature_0_choice_294, transform_right_filter_feature_0_choice_295 : boolean;
    variable transform_right_filter_feature_0_choice_296, transform_right_filter_feature_0_choice_297 : boolean;
    variable transform_right_filter_feature_0_choice_298, transform_right_filter_feature_0_choice_299 : boolean;
    variable transform_right_filter_feature_0_choice_300, transform_right_filter_feature_0_choice_301 : boolean;
    variable transform_right_filter_feature_0_choice_302, transform_right_filter_feature_0_choice_303 : boolean;
    variable transform_right_filter_feature_0_choice_304, transform_right_filter_feature_0_choice_305 : boolean;
    variable transform_right_filter_feature_0_choice_306, transform_right_filter_feature_0_choice_307 : boolean;
    variable transform_right_filter_feature_0_choice_308, transform_right_filter_feature_0_choice_309 : boolean;
    variable transform_right_filter_feature_0_choice_310, transform_right_filter_feature_0_choice_311 : boolean;
    variable transform_right_filter_feature_0_choice_312, transform_right_filter_feature_0_choice_313 : boolean;
    variable transform_right_filter_feature_0_choice_314, transform_right_filter_feature_0_choice_315 : boolean;
    variable transform_right_filter_feature_0_choice_316, transform_right_filter_feature_0_choice_317 : boolean;
    variable transform_right_filter_feature_0_choice_318, transform_right_filter_feature_0_choice_319 : boolean;
    variable transform_right_filter_feature_0_choice_320, transform_right_filter_feature_0_choice_321 : boolean;
    variable transform_right_filter_feature_0_choice_322, transform_right_filter_feature_0_choice_323 : boolean;
    variable transform_right_filter_feature_0_choice_324, transform_right_filter_feature_0_choice_325 : boolean;
    variable transform_right_filter_feature_0_choice_326, transform_right_filter_feature_0_choice_327 : boolean;
    variable transform_right_filter_feature_0_choice_328, transform_right_filter_feature_0_choice_329 : boolean;
    variable transform_right_filter_feature_0_choice_330, transform_right_filter_feature_0_choice_331 : boolean;
    variable transform_right_filter_feature_0_choice_332, transform_right_filter_feature_0_choice_333 : boolean;
    variable transform_right_filter_feature_0_choice_334, transform_right_filter_feature_0_choice_335 : boolean;
    variable transform_right_filter_feature_0_choice_336, transform_right_filter_feature_0_choice_337 : boolean;
    variable transform_right_filter_feature_0_choice_338, transform_right_filter_feature_0_choice_339 : boolean;
    variable transform_right_filter_feature_0_choice_340, transform_right_filter_feature_0_choice_341 : boolean;
    variable transform_right_filter_feature_0_choice_342, transform_right_filter_feature_0_choice_343 : boolean;
    variable transform_right_filter_feature_0_choice_344, transform_right_filter_feature_0_choice_345 : boolean;
    variable transform_right_filter_feature_0_choice_346, transform_right_filter_feature_0_choice_347 : boolean;
    variable transform_right_filter_feature_0_choice_348, transform_right_filter_feature_0_choice_349 : boolean;
    variable transform_right_filter_feature_0_choice_350, transform_right_filter_feature_0_choice_351 : boolean;
    variable transform_right_filter_feature_0_choice_352, transform_right_filter_feature_0_choice_353 : boolean;
    variable transform_right_filter_feature_0_choice_354, transform_right_filter_feature_0_choice_355 : boolean;
    variable transform_right_filter_feature_0_choice_356, transform_right_filter_feature_0_choice_357 : boolean;
    variable transform_right_filter_feature_0_choice_358, transform_right_filter_feature_0_choice_359 : boolean;
    variable transform_right_filter_feature_0_choice_360, transform_right_filter_feature_0_choice_361 : boolean;
    variable transform_right_filter_feature_0_choice_362, transform_right_filter_feature_0_choice_363 : boolean;
    variable transform_right_filter_feature_0_choice_364, transform_right_filter_feature_0_choice_365 : boolean;
    variable transform_right_filter_feature_0_choice_366, transform_right_filter_feature_0_choice_367 : boolean;
    variable transform_right_filter_feature_0_choice_368, transform_right_filter_feature_0_choice_369 : boolean;
    variable transform_right_filter_feature_0_choice_370, transform_right_filter_feature_0_choice_371 : boolean;
    variable transform_right_filter_feature_0_choice_372, transform_right_filter_feature_0_choice_373 : boolean;
    variable transform_right_filter_feature_0_choice_374, transform_right_filter_feature_0_choice_375 : boolean;
    variable transform_right_filter_feature_0_choice_376, transform_right_filter_feature_0_choice_377 : boolean;
    variable transform_right_filter_feature_0_choice_378, transform_right_filter_feature_0_choice_379 : boolean;
    variable transform_right_filter_feature_0_choice_380, transform_right_filter_feature_0_choice_381 : boolean;
    variable transform_right_filter_feature_0_choice_382, transform_right_filter_feature_0_choice_383 : boolean;
    variable transform_right_filter_feature_0_choice_384, transform_right_filter_feature_0_choice_385 : boolean;
    variable transform_right_filter_feature_0_choice_386, transform_right_filter_feature_0_choice_387 : boolean;
    variable transform_right_filter_feature_0_choice_388, transform_right_filter_feature_0_choice_389 : boolean;
    variable transform_right_filter_feature_0_choice_390, transform_right_filter_feature_0_choice_391 : boolean;
    variable transform_right_filter_feature_0_choice_392, transform_right_filter_feature_0_choice_393 : boolean;
    variable transform_right_filter_feature_0_choice_394, transform_right_filter_feature_0_choice_395 : boolean;
    variable transform_right_filter_feature_0_choice_396, transform_right_filter_feature_0_choice_397 : boolean;
    variable transform_right_filter_feature_0_choice_398, transform_right_filter_feature_0_choice_399 : boolean;
    variable transform_right_filter_feature_0_choice_400, transform_right_filter_feature_0_choice_401 : boolean;
    variable transform_right_filter_feature_0_choice_402, transform_right_filter_feature_0_choice_403 : boolean;
    variable transform_right_filter_feature_0_choice_404, transform_right_filter_feature_0_choice_405 : boolean;
    variable transform_right_filter_feature_0_choice_406, transform_right_filter_feature_0_choice_407 : boolean;
    variable transform_right_filter_feature_0_choice_408, transform_right_filter_feature_0_choice_409 : boolean;
    variable transform_right_filter_feature_0_choice_410, transform_right_filter_feature_0_choice_411 : boolean;
    variable transform_right_filter_feature_0_choice_412, transform_right_filter_feature_0_choice_413 : boolean;
    variable transform_right_filter_feature_0_choice_414, transform_right_filter_feature_0_choice_415 : boolean;
    variable transform_right_filter_feature_0_choice_416, transform_right_filter_feature_0_choice_417 : boolean;
    variable transform_right_filter_feature_0_choice_418, transform_right_filter_feature_0_choice_419 : boolean;
    variable transform_right_filter_feature_0_choice_420, transform_right_filter_feature_0_choice_421 : boolean;
    variable transform_right_filter_feature_0_choice_422, transform_right_filter_feature_0_choice_423 : boolean;
    variable transform_right_filter_feature_0_choice_424, transform_right_filter_feature_0_choice_425 : boolean;
    variable transform_right_filter_feature_0_choice_426, transform_right_filter_feature_0_choice_427 : boolean;
    variable transform_right_filter_feature_0_choice_428, transform_right_filter_feature_0_choice_429 : boolean;
    variable transform_right_filter_feature_0_choice_430, transform_right_filter_feature_0_choice_431 : boolean;
    variable transform_right_filter_feature_0_choice_432, transform_right_filter_feature_0_choice_433 : boolean;
    variable transform_right_filter_feature_0_choice_434, transform_right_filter_feature_0_choice_435 : boolean;
    variable transform_right_filter_feature_0_choice_436, transform_right_filter_feature_0_choice_437 : boolean;
    variable transform_right_filter_feature_0_choice_438, transform_right_filter_feature_0_choice_439 : boolean;
    variable transform_right_filter_feature_0_choice_440, transform_right_filter_feature_0_choice_441 : boolean;
    variable transform_right_filter_feature_0_choice_442, transform_right_filter_feature_0_choice_443 : boolean;
    variable transform_right_filter_feature_0_choice_444, transform_right_filter_feature_0_choice_445 : boolean;
    variable transform_right_filter_feature_0_choice_446, transform_right_filter_feature_0_choice_447 : boolean;
    variable transform_right_filter_feature_0_choice_448, transform_right_filter_feature_0_choice_449 : boolean;
    variable transform_right_filter_feature_0_choice_450, transform_right_filter_feature_0_choice_451 : boolean;
    variable transform_right_filter_feature_0_choice_452, transform_right_filter_feature_0_choice_453 : boolean;
    variable transform_right_filter_feature_0_choice_454, transform_right_filter_feature_0_choice_455 : boolean;
    variable transform_right_filter_feature_0_choice_456, transform_right_filter_feature_0_choice_457 : boolean;
    variable transform_right_filter_feature_0_choice_458, transform_right_filter_feature_0_choice_459 : boolean;
    variable transform_right_filter_feature_0_choice_460, transform_right_filter_feature_0_choice_461 : boolean;
    variable transform_right_filter_feature_0_choice_462, transform_right_filter_feature_0_choice_463 : boolean;
    variable transform_right_filter_feature_0_choice_464, transform_right_filter_feature_0_choice_465 : boolean;
    variable transform_right_filter_feature_0_choice_466, transform_right_filter_feature_0_choice_467 : boolean;
    variable transform_right_filter_feature_0_choice_468, transform_right_filter_feature_0_choice_469 : boolean;
    variable transform_right_filter_feature_0_choice_470, transform_right_filter_feature_0_choice_471 : boolean;
    variable transform_right_filter_feature_0_choice_472, transform_right_filter_feature_0_choice_473 : boolean;
    variable transform_right_filter_feature_0_choice_474, transform_right_filter_feature_0_choice_475 : boolean;
    variable transform_right_filter_feature_0_choice_476, transform_right_filter_feature_0_choice_477 : boolean;
    variable transform_right_filter_feature_0_choice_478, transform_right_filter_feature_0_choice_479 : boolean;
    variable transform_right_filter_feature_0_choice_480, transform_right_filter_feature_0_choice_481 : boolean;
    variable transform_right_filter_feature_0_choice_482, transform_right_filter_feature_0_choice_483 : boolean;
    variable transform_right_filter_feature_0_choice_484, transform_right_filter_feature_0_choice_485 : boolean;
    variable transform_right_filter_feature_0_choice_486, transform_right_filter_feature_0_choice_487 : boolean;
    variable transform_right_filter_feature_0_choice_488, transform_right_filter_feature_0_choice_489 : boolean;
    variable transform_right_filter_feature_0_choice_490, transform_right_filter_feature_0_value_7 : boolean;
    variable transform_right_filter_feature_0_choice_491, transform_right_filter_feature_0_value_8 : boolean;
    variable transform_right_filter_feature_0_choice_492, transform_right_filter_feature_0_value_9 : boolean;
    variable transform_right_filter_feature_0_choice_493, transform_right_filter_feature_0_value_10 : boolean;
    variable transform_right_filter_feature_0_choice_494, transform_right_filter_feature_0_value_11 : boolean;
    variable transform_right_filter_feature_0_choice_495, transform_right_filter_feature_0_choice_496 : boolean;
    variable transform_counter_next_frame_choice, transform_counter_next_frame_choice_2 : boolean;
    variable raster_place_group_is_equal, raster_place_group_is_equal_2, raster_place_group_all : boolean;
    variable raster_place_group_is_equal_3, raster_place_group_choice_2, raster_place_next_frame_choice : boolean;
    variable raster_place_next_frame_choice_2, raster_place_next_frame_choice_3 : boolean;
    variable raster_place_next_frame_choice_4, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less : boolean;
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
    variable slice0cost_pixels_first_0_0_count_14_value, slice0cost_pixels_first_0_0_count_14_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_14_value_3, slice0cost_pixels_first_0_0_count_15_value : boolean;
    variable slice0cost_pixels_first_0_0_count_15_value_2, slice0cost_pixels_first_0_0_count_15_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_16_value, slice0cost_pixels_first_0_0_count_16_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_16_value_3, slice0cost_pixels_first_0_0_count_17_value : boolean;
    variable slice0cost_pixels_first_0_0_count_17_value_2, slice0cost_pixels_first_0_0_count_17_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_18_value, slice0cost_pixels_first_0_0_count_18_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_count_18_value_3, slice0cost_pixels_first_0_0_count_19_value : boolean;
    variable slice0cost_pixels_first_0_0_count_19_value_2, slice0cost_pixels_first_0_0_count_19_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_20_value, slice0cost_pixels_first_1_0_count_0_value : boolean;
    variable slice0cost_pixels_first_1_0_count_0_value_2, slice0cost_pixels_first_1_0_count_1_value : boolean;
    variable slice0cost_pixels_first_1_0_count_1_value_2, slice0cost_pixels_first_1_0_count_1_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_2_value, slice0cost_pixels_first_1_0_count_2_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_3_value, slice0cost_pixels_first_1_0_count_3_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_3_value_3, slice0cost_pixels_first_1_0_count_4_value : boolean;
    variable slice0cost_pixels_first_1_0_count_4_value_2, slice0cost_pixels_first_1_0_count_4_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_5_value, slice0cost_pixels_first_1_0_count_5_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_5_value_3, slice0cost_pixels_first_1_0_count_6_value : boolean;
    variable slice0cost_pixels_first_1_0_count_6_value_2, slice0cost_pixels_first_1_0_count_6_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_7_value, slice0cost_pixels_first_1_0_count_7_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_7_value_3, slice0cost_pixels_first_1_0_count_8_value : boolean;
    variable slice0cost_pixels_first_1_0_count_8_value_2, slice0cost_pixels_first_1_0_count_8_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_9_value, slice0cost_pixels_first_1_0_count_9_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_9_value_3, slice0cost_pixels_first_1_0_count_10_value : boolean;
    variable slice0cost_pixels_first_1_0_count_10_value_2, slice0cost_pixels_first_1_0_count_10_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_11_value, slice0cost_pixels_first_1_0_count_11_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_11_value_3, slice0cost_pixels_first_1_0_count_12_value : boolean;
    variable slice0cost_pixels_first_1_0_count_12_value_2, slice0cost_pixels_first_1_0_count_12_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_13_value, slice0cost_pixels_first_1_0_count_13_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_13_value_3, slice0cost_pixels_first_1_0_count_14_value : boolean;
    variable slice0cost_pixels_first_1_0_count_14_value_2, slice0cost_pixels_first_1_0_count_14_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_15_value, slice0cost_pixels_first_1_0_count_15_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_15_value_3, slice0cost_pixels_first_1_0_count_16_value : boolean;
    variable slice0cost_pixels_first_1_0_count_16_value_2, slice0cost_pixels_first_1_0_count_16_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_17_value, slice0cost_pixels_first_1_0_count_17_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_17_value_3, slice0cost_pixels_first_1_0_count_18_value : boolean;
    variable slice0cost_pixels_first_1_0_count_18_value_2, slice0cost_pixels_first_1_0_count_18_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_19_value, slice0cost_pixels_first_1_0_count_19_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_count_19_value_3, slice0cost_pixels_first_1_0_count_20_value : boolean;
    variable slice0cost_pixels_first_2_0_count_0_value, slice0cost_pixels_first_2_0_count_0_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_1_value, slice0cost_pixels_first_2_0_count_1_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_1_value_3, slice0cost_pixels_first_2_0_count_2_value : boolean;
    variable slice0cost_pixels_first_2_0_count_2_value_2, slice0cost_pixels_first_2_0_count_3_value : boolean;
    variable slice0cost_pixels_first_2_0_count_3_value_2, slice0cost_pixels_first_2_0_count_3_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_4_value, slice0cost_pixels_first_2_0_count_4_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_4_value_3, slice0cost_pixels_first_2_0_count_5_value : boolean;
    variable slice0cost_pixels_first_2_0_count_5_value_2, slice0cost_pixels_first_2_0_count_5_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_6_value, slice0cost_pixels_first_2_0_count_6_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_6_value_3, slice0cost_pixels_first_2_0_count_7_value : boolean;
    variable slice0cost_pixels_first_2_0_count_7_value_2, slice0cost_pixels_first_2_0_count_7_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_8_value, slice0cost_pixels_first_2_0_count_8_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_8_value_3, slice0cost_pixels_first_2_0_count_9_value : boolean;
    variable slice0cost_pixels_first_2_0_count_9_value_2, slice0cost_pixels_first_2_0_count_9_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_10_value, slice0cost_pixels_first_2_0_count_10_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_10_value_3, slice0cost_pixels_first_2_0_count_11_value : boolean;
    variable slice0cost_pixels_first_2_0_count_11_value_2, slice0cost_pixels_first_2_0_count_11_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_12_value, slice0cost_pixels_first_2_0_count_12_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_12_value_3, slice0cost_pixels_first_2_0_count_13_value : boolean;
    variable slice0cost_pixels_first_2_0_count_13_value_2, slice0cost_pixels_first_2_0_count_13_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_14_value, slice0cost_pixels_first_2_0_count_14_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_14_value_3, slice0cost_pixels_first_2_0_count_15_value : boolean;
    variable slice0cost_pixels_first_2_0_count_15_value_2, slice0cost_pixels_first_2_0_count_15_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_16_value, slice0cost_pixels_first_2_0_count_16_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_16_value_3, slice0cost_pixels_first_2_0_count_17_value : boolean;
    variable slice0cost_pixels_first_2_0_count_17_value_2, slice0cost_pixels_first_2_0_count_17_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_18_value, slice0cost_pixels_first_2_0_count_18_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_count_18_value_3, slice0cost_pixels_first_2_0_count_19_value : boolean;
    variable slice0cost_pixels_first_2_0_count_19_value_2, slice0cost_pixels_first_2_0_count_19_value_3 : boolean;
    variable slice0cost_pixels_first_2_0_count_20_value, slice0winner1_of_pair_0_0_is_less : boolean;
    variable slice0winner1_of_pair_0_2_is_less, slice0winner1_of_four_0_0_is_less : boolean;
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 3;
    variable transform_counter_group_choice_3, transform_counter_group_choice_4 : natural range 0 to 15;
    variable raster_place_group_choice_3, raster_place_group_choice_4 : natural range 0 to 15;
    variable transform_left_filter_feature_0_choice_497 : natural range 0 to 127;
    variable transform_right_filter_feature_0_choice_497 : natural range 0 to 127;
    variable transform_left_filter_feature_0_choice_498 : natural range 0 to 16383;
    variable transform_right_filter_feature_0_choice_498 : natural range 0 to 16383;
    variable transform_left_filter_feature_0_choice_499 : natural range 0 to 2097151;
    variable transform_right_filter_feature_0_choice_499 : natural range 0 to 2097151;
    variable transform_left_filter_feature_0_choice_500 : natural range 0 to 268435455;
    variable transform_right_filter_feature_0_choice_500 : natural range 0 to 268435455;
    variable transform_left_filter_feature_0_choice_501 : unsigned(32 downto 0);
    variable transform_right_filter_feature_0_choice_501 : unsigned(32 downto 0);
    variable transform_left_filter_feature_0_choice_502 : unsigned(40 downto 0);
    variable transform_right_filter_feature_0_choice_502 : unsigned(40 downto 0);
    variable transform_left_filter_feature_0_choice_503 : unsigned(47 downto 0);
    variable transform_right_filter_feature_0_choice_503 : unsigned(47 downto 0);
    variable transform_left_filter_feature_0_choice_504 : unsigned(54 downto 0);
    variable transform_right_filter_feature_0_choice_504 : unsigned(54 downto 0);
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 31;
      transform_counter_group_all := transform_counter_group_is_equal and (transform_counter_group = 11);
      if transform_counter_group_all then
        transform_counter_group_choice := 3;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_is_equal_2 := (transform_counter_group / 2) = 7;
      if transform_counter_group_is_equal_2 then
        transform_counter_group_choice_2 := transform_counter_group_is_equal and in_valid and (not
          ((transform_counter_group mod 2) = 1));
      else
        transform_counter_group_choice_2 := transform_counter_group_is_equal and in_valid;
      end if;
      if transform_counter_next_frame and (transform_counter_group = 14) then
        transform_counter_group_choice_3 := 3;
      else
        transform_counter_group_choice_3 := (transform_counter_group + 1) mod 16;
      end if;
      if transform_counter_group_choice_2 then
        transform_counter_group_choice_4 := transform_counter_group_choice_3;
      else
        transform_counter_group_choice_4 := transform_counter_group;
      end if;
      transform_read_column_inside_0_value := ((transform_counter_column / 8) mod 2) = 1;
      transform_read_column_inside_0_value_2 := ((transform_counter_column / 4) mod 2) = 1;
      transform_read_column_inside_0_any := ((transform_counter_column / 16) = 1) or
        transform_read_column_inside_0_value or transform_read_column_inside_0_value_2;
      transform_read_column_inside_1_value := ((transform_counter_column / 2) mod 2) = 1;
      transform_read_column_inside_1_all := (not transform_read_column_inside_1_value) and (not
        ((transform_counter_column mod 2) = 1)) and ((transform_counter_column / 8) = 0);
      if (transform_counter_column / 16) = 1 then
        transform_read_column_inside_1_choice := transform_read_column_inside_0_value_2;
      else
        transform_read_column_inside_1_choice := (not transform_read_column_inside_0_value) or
          transform_read_column_inside_0_value_2;
      end if;
      transform_left_filter_feature_0_value := ((transform_left_filter_column_4_3 / 2) mod 2) = 1;
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        ((transform_left_filter_column_4_3 mod 2) = 1));
      if (transform_left_filter_column_8_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_4_3 mod 4) = 0;
      if ((transform_left_filter_column_8_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choice_2 := ((transform_left_filter_column_8_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_2 := ((transform_left_filter_column_4_3 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_2 then
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_3 := ((transform_left_filter_column_4_3 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_3 then
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_4 := ((transform_left_filter_column_4_3 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_4 then
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_5 := ((transform_left_filter_column_4_3 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_5 then
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_6 := ((transform_left_filter_column_4_3 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_6 then
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_7 then
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_8_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_8_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
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
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_8_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
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
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_24 := ((transform_left_filter_column_8_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
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
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_8_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
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
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_8_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_8_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_41 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_41 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_42 := transform_left_filter_feature_0_choice_41;
      else
        transform_left_filter_feature_0_choice_42 := ((transform_left_filter_column_8_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_42 then
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_8_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_8_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_43 then
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_8_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_8_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_44 then
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_8_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_8_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_45 then
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_8_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_8_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_46 then
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_8_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_8_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_47 then
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_8_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_8_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_8_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_49 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_49 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_8_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_50 := transform_left_filter_feature_0_choice_49;
      else
        transform_left_filter_feature_0_choice_50 := ((transform_left_filter_column_8_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_50 then
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_8_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_8_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_51 then
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_8_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_8_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_52 then
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_8_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_8_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_53 then
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_8_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_8_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_54 then
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_8_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_8_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_55 then
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_8_6 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_8_6 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_57 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_57 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_58 := transform_left_filter_feature_0_choice_57;
      else
        transform_left_filter_feature_0_choice_58 := ((transform_left_filter_column_7_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_58 then
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_7_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_7_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_59 then
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_7_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_7_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_60 then
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_7_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_7_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_61 then
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_7_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_7_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_62 then
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_7_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_7_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_63 then
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_7_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_7_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_65 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_65 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_66 := transform_left_filter_feature_0_choice_65;
      else
        transform_left_filter_feature_0_choice_66 := ((transform_left_filter_column_7_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_66 then
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_7_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_7_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_67 then
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_7_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_7_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_68 then
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_7_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_7_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_69 then
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_7_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_7_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_70 then
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_7_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_7_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_71 then
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_7_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_7_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_73 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_73 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_74 := transform_left_filter_feature_0_choice_73;
      else
        transform_left_filter_feature_0_choice_74 := ((transform_left_filter_column_7_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_74 then
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_7_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_7_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_75 then
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_7_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_7_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_76 then
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_7_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_7_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_77 then
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_7_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_7_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_78 then
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_7_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_7_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_79 then
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_7_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_7_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_81 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_81 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_82 := transform_left_filter_feature_0_choice_81;
      else
        transform_left_filter_feature_0_choice_82 := ((transform_left_filter_column_7_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_82 then
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_7_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_7_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_83 then
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_7_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_7_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_84 then
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_7_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_7_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_85 then
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_7_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_7_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_86 then
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_7_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_7_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_87 then
        transform_left_filter_feature_0_choice_88 := ((transform_left_filter_column_7_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_88 := ((transform_left_filter_column_7_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_89 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_89 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_90 := transform_left_filter_feature_0_choice_89;
      else
        transform_left_filter_feature_0_choice_90 := ((transform_left_filter_column_7_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_90 then
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_7_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_7_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_91 then
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_7_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_7_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_92 then
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_7_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_7_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_93 then
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_7_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_7_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_94 then
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_7_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_7_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_95 then
        transform_left_filter_feature_0_choice_96 := ((transform_left_filter_column_7_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_96 := ((transform_left_filter_column_7_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_97 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_97 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_98 := transform_left_filter_feature_0_choice_97;
      else
        transform_left_filter_feature_0_choice_98 := ((transform_left_filter_column_7_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_98 then
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_7_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_7_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_99 then
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_7_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_7_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_100 then
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_7_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_7_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_101 then
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_7_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_7_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_102 then
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_7_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_7_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_103 then
        transform_left_filter_feature_0_choice_104 := ((transform_left_filter_column_7_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_104 := ((transform_left_filter_column_7_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_105 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_105 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_106 := transform_left_filter_feature_0_choice_105;
      else
        transform_left_filter_feature_0_choice_106 := ((transform_left_filter_column_7_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_106 then
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_7_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_7_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_107 then
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_7_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_7_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_108 then
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_7_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_7_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_109 then
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_7_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_7_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_110 then
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_7_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_7_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_111 then
        transform_left_filter_feature_0_choice_112 := ((transform_left_filter_column_7_6 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_112 := ((transform_left_filter_column_7_6 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_113 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_113 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_114 := transform_left_filter_feature_0_choice_113;
      else
        transform_left_filter_feature_0_choice_114 := ((transform_left_filter_column_6_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_114 then
        transform_left_filter_feature_0_choice_115 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_115 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_115 then
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_116 then
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_117 then
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_118 then
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_119 then
        transform_left_filter_feature_0_choice_120 := ((transform_left_filter_column_6_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_120 := ((transform_left_filter_column_6_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_121 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_121 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_122 := transform_left_filter_feature_0_choice_121;
      else
        transform_left_filter_feature_0_choice_122 := ((transform_left_filter_column_6_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_122 then
        transform_left_filter_feature_0_choice_123 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_123 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_123 then
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_124 then
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_125 then
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_126 then
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_127 then
        transform_left_filter_feature_0_choice_128 := ((transform_left_filter_column_6_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_128 := ((transform_left_filter_column_6_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_129 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_129 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_130 := transform_left_filter_feature_0_choice_129;
      else
        transform_left_filter_feature_0_choice_130 := ((transform_left_filter_column_6_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_130 then
        transform_left_filter_feature_0_choice_131 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_131 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_131 then
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_132 then
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_133 then
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_134 then
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_135 then
        transform_left_filter_feature_0_choice_136 := ((transform_left_filter_column_6_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_136 := ((transform_left_filter_column_6_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_137 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_137 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_138 := transform_left_filter_feature_0_choice_137;
      else
        transform_left_filter_feature_0_choice_138 := ((transform_left_filter_column_6_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_138 then
        transform_left_filter_feature_0_choice_139 := (not (((transform_left_filter_column_6_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_139 := (not (((transform_left_filter_column_6_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_139 then
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_6_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_6_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_140 then
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_6_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_6_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_141 then
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_6_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_6_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_142 then
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_6_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_6_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_143 then
        transform_left_filter_feature_0_choice_144 := ((transform_left_filter_column_6_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_144 := ((transform_left_filter_column_6_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_145 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_145 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_146 := transform_left_filter_feature_0_choice_145;
      else
        transform_left_filter_feature_0_choice_146 := ((transform_left_filter_column_6_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_146 then
        transform_left_filter_feature_0_choice_147 := (not (((transform_left_filter_column_6_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_147 := (not (((transform_left_filter_column_6_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_147 then
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_6_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_6_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_148 then
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_6_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_6_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_149 then
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_6_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_6_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_150 then
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_6_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_6_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_151 then
        transform_left_filter_feature_0_choice_152 := ((transform_left_filter_column_6_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_152 := ((transform_left_filter_column_6_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_153 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_153 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_154 := transform_left_filter_feature_0_choice_153;
      else
        transform_left_filter_feature_0_choice_154 := ((transform_left_filter_column_6_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_154 then
        transform_left_filter_feature_0_choice_155 := (not (((transform_left_filter_column_6_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_155 := (not (((transform_left_filter_column_6_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_155 then
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_6_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_6_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_156 then
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_6_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_6_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_157 then
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_6_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_6_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_158 then
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_6_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_6_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_159 then
        transform_left_filter_feature_0_choice_160 := ((transform_left_filter_column_6_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_160 := ((transform_left_filter_column_6_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_161 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_161 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_162 := transform_left_filter_feature_0_choice_161;
      else
        transform_left_filter_feature_0_choice_162 := ((transform_left_filter_column_6_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_162 then
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_6_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_6_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_163 then
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_6_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_6_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_164 then
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_6_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_6_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_165 then
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_6_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_6_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_166 then
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_6_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_6_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_167 then
        transform_left_filter_feature_0_choice_168 := ((transform_left_filter_column_6_6 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_168 := ((transform_left_filter_column_6_6 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_169 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_169 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_170 := transform_left_filter_feature_0_choice_169;
      else
        transform_left_filter_feature_0_choice_170 := ((transform_left_filter_column_5_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_170 then
        transform_left_filter_feature_0_choice_171 := (not (((transform_left_filter_column_5_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_171 := (not (((transform_left_filter_column_5_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_171 then
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_5_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_5_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_172 then
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_5_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_5_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_173 then
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_5_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_5_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_174 then
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_5_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_5_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_175 then
        transform_left_filter_feature_0_choice_176 := ((transform_left_filter_column_5_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_176 := ((transform_left_filter_column_5_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_177 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_177 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_178 := transform_left_filter_feature_0_choice_177;
      else
        transform_left_filter_feature_0_choice_178 := ((transform_left_filter_column_5_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_178 then
        transform_left_filter_feature_0_choice_179 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_179 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_179 then
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_180 then
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_181 then
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_182 then
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_183 then
        transform_left_filter_feature_0_choice_184 := ((transform_left_filter_column_5_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_184 := ((transform_left_filter_column_5_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_185 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_185 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_186 := transform_left_filter_feature_0_choice_185;
      else
        transform_left_filter_feature_0_choice_186 := ((transform_left_filter_column_5_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_186 then
        transform_left_filter_feature_0_choice_187 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_187 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_187 then
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_188 then
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_189 then
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_190 then
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_191 then
        transform_left_filter_feature_0_choice_192 := ((transform_left_filter_column_5_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_192 := ((transform_left_filter_column_5_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_193 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_193 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_194 := transform_left_filter_feature_0_choice_193;
      else
        transform_left_filter_feature_0_choice_194 := ((transform_left_filter_column_5_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_194 then
        transform_left_filter_feature_0_choice_195 := (not (((transform_left_filter_column_5_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_195 := (not (((transform_left_filter_column_5_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_195 then
        transform_left_filter_feature_0_choice_196 := (not (((transform_left_filter_column_5_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_196 := (not (((transform_left_filter_column_5_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_196 then
        transform_left_filter_feature_0_choice_197 := (not (((transform_left_filter_column_5_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_197 := (not (((transform_left_filter_column_5_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_197 then
        transform_left_filter_feature_0_choice_198 := (not (((transform_left_filter_column_5_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_198 := (not (((transform_left_filter_column_5_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_198 then
        transform_left_filter_feature_0_choice_199 := (not (((transform_left_filter_column_5_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_199 := (not (((transform_left_filter_column_5_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_199 then
        transform_left_filter_feature_0_choice_200 := ((transform_left_filter_column_5_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_200 := ((transform_left_filter_column_5_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_201 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_201 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_202 := transform_left_filter_feature_0_choice_201;
      else
        transform_left_filter_feature_0_choice_202 := ((transform_left_filter_column_5_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_202 then
        transform_left_filter_feature_0_choice_203 := (not (((transform_left_filter_column_5_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_203 := (not (((transform_left_filter_column_5_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_203 then
        transform_left_filter_feature_0_choice_204 := (not (((transform_left_filter_column_5_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_204 := (not (((transform_left_filter_column_5_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_204 then
        transform_left_filter_feature_0_choice_205 := (not (((transform_left_filter_column_5_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_205 := (not (((transform_left_filter_column_5_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_205 then
        transform_left_filter_feature_0_choice_206 := (not (((transform_left_filter_column_5_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_206 := (not (((transform_left_filter_column_5_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_206 then
        transform_left_filter_feature_0_choice_207 := (not (((transform_left_filter_column_5_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_207 := (not (((transform_left_filter_column_5_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_207 then
        transform_left_filter_feature_0_choice_208 := ((transform_left_filter_column_5_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_208 := ((transform_left_filter_column_5_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_209 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_209 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_210 := transform_left_filter_feature_0_choice_209;
      else
        transform_left_filter_feature_0_choice_210 := ((transform_left_filter_column_5_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_210 then
        transform_left_filter_feature_0_choice_211 := (not (((transform_left_filter_column_5_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_211 := (not (((transform_left_filter_column_5_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_211 then
        transform_left_filter_feature_0_choice_212 := (not (((transform_left_filter_column_5_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_212 := (not (((transform_left_filter_column_5_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_212 then
        transform_left_filter_feature_0_choice_213 := (not (((transform_left_filter_column_5_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_213 := (not (((transform_left_filter_column_5_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_213 then
        transform_left_filter_feature_0_choice_214 := (not (((transform_left_filter_column_5_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_214 := (not (((transform_left_filter_column_5_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_214 then
        transform_left_filter_feature_0_choice_215 := (not (((transform_left_filter_column_5_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_215 := (not (((transform_left_filter_column_5_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_215 then
        transform_left_filter_feature_0_choice_216 := ((transform_left_filter_column_5_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_216 := ((transform_left_filter_column_5_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_217 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_217 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_218 := transform_left_filter_feature_0_choice_217;
      else
        transform_left_filter_feature_0_choice_218 := ((transform_left_filter_column_5_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_218 then
        transform_left_filter_feature_0_choice_219 := (not (((transform_left_filter_column_5_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_219 := (not (((transform_left_filter_column_5_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_219 then
        transform_left_filter_feature_0_choice_220 := (not (((transform_left_filter_column_5_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_220 := (not (((transform_left_filter_column_5_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_220 then
        transform_left_filter_feature_0_choice_221 := (not (((transform_left_filter_column_5_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_221 := (not (((transform_left_filter_column_5_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_221 then
        transform_left_filter_feature_0_choice_222 := (not (((transform_left_filter_column_5_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_222 := (not (((transform_left_filter_column_5_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_222 then
        transform_left_filter_feature_0_choice_223 := (not (((transform_left_filter_column_5_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_223 := (not (((transform_left_filter_column_5_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_223 then
        transform_left_filter_feature_0_choice_224 := ((transform_left_filter_column_5_6 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_224 := ((transform_left_filter_column_5_6 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_225 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_225 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_226 := transform_left_filter_feature_0_choice_225;
      else
        transform_left_filter_feature_0_choice_226 := ((transform_left_filter_column_4_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_226 then
        transform_left_filter_feature_0_choice_227 := (not (((transform_left_filter_column_4_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_227 := (not (((transform_left_filter_column_4_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_227 then
        transform_left_filter_feature_0_choice_228 := (not (((transform_left_filter_column_4_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_228 := (not (((transform_left_filter_column_4_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_228 then
        transform_left_filter_feature_0_choice_229 := (not (((transform_left_filter_column_4_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_229 := (not (((transform_left_filter_column_4_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_229 then
        transform_left_filter_feature_0_choice_230 := (not (((transform_left_filter_column_4_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_230 := (not (((transform_left_filter_column_4_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_230 then
        transform_left_filter_feature_0_choice_231 := (not (((transform_left_filter_column_4_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_231 := (not (((transform_left_filter_column_4_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_231 then
        transform_left_filter_feature_0_choice_232 := transform_filtering_0_column_inside_4 and
          ((transform_left_filter_column_4_6 / 128) = 1) and (not ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_232 := transform_filtering_0_column_inside_4 and
          (((transform_left_filter_column_4_6 / 128) = 1) or (not ((transform_left_filter_column_4_3 / 128) = 1)));
      end if;
      if (transform_left_filter_column_4_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_233 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_233 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_234 := transform_left_filter_feature_0_choice_233;
      else
        transform_left_filter_feature_0_choice_234 := ((transform_left_filter_column_4_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_234 then
        transform_left_filter_feature_0_choice_235 := (not (((transform_left_filter_column_4_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_235 := (not (((transform_left_filter_column_4_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_235 then
        transform_left_filter_feature_0_choice_236 := (not (((transform_left_filter_column_4_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_236 := (not (((transform_left_filter_column_4_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_236 then
        transform_left_filter_feature_0_choice_237 := (not (((transform_left_filter_column_4_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_237 := (not (((transform_left_filter_column_4_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_237 then
        transform_left_filter_feature_0_choice_238 := (not (((transform_left_filter_column_4_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_238 := (not (((transform_left_filter_column_4_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_238 then
        transform_left_filter_feature_0_choice_239 := (not (((transform_left_filter_column_4_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_239 := (not (((transform_left_filter_column_4_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_239 then
        transform_left_filter_feature_0_choice_240 := ((transform_left_filter_column_4_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_240 := ((transform_left_filter_column_4_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_241 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_241 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_242 := transform_left_filter_feature_0_choice_241;
      else
        transform_left_filter_feature_0_choice_242 := ((transform_left_filter_column_4_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_242 then
        transform_left_filter_feature_0_choice_243 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_243 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_243 then
        transform_left_filter_feature_0_choice_244 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_244 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_244 then
        transform_left_filter_feature_0_choice_245 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_245 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_245 then
        transform_left_filter_feature_0_choice_246 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_246 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_246 then
        transform_left_filter_feature_0_choice_247 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_247 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_247 then
        transform_left_filter_feature_0_choice_248 := ((transform_left_filter_column_4_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_248 := ((transform_left_filter_column_4_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_249 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_249 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_250 := transform_left_filter_feature_0_choice_249;
      else
        transform_left_filter_feature_0_choice_250 := ((transform_left_filter_column_4_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_250 then
        transform_left_filter_feature_0_choice_251 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_251 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_251 then
        transform_left_filter_feature_0_choice_252 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_252 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_252 then
        transform_left_filter_feature_0_choice_253 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_253 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_253 then
        transform_left_filter_feature_0_choice_254 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_254 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_254 then
        transform_left_filter_feature_0_choice_255 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_255 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_255 then
        transform_left_filter_feature_0_choice_256 := ((transform_left_filter_column_4_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_256 := ((transform_left_filter_column_4_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_257 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_257 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_258 := transform_left_filter_feature_0_choice_257;
      else
        transform_left_filter_feature_0_choice_258 := ((transform_left_filter_column_4_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_258 then
        transform_left_filter_feature_0_choice_259 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_259 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_259 then
        transform_left_filter_feature_0_choice_260 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_260 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_260 then
        transform_left_filter_feature_0_choice_261 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_261 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_261 then
        transform_left_filter_feature_0_choice_262 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_262 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_262 then
        transform_left_filter_feature_0_choice_263 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_263 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_263 then
        transform_left_filter_feature_0_choice_264 := ((transform_left_filter_column_4_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_264 := ((transform_left_filter_column_4_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_265 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_265 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_266 := transform_left_filter_feature_0_choice_265;
      else
        transform_left_filter_feature_0_choice_266 := ((transform_left_filter_column_4_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_266 then
        transform_left_filter_feature_0_choice_267 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_267 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_267 then
        transform_left_filter_feature_0_choice_268 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_268 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_268 then
        transform_left_filter_feature_0_choice_269 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_269 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_269 then
        transform_left_filter_feature_0_choice_270 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_270 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_270 then
        transform_left_filter_feature_0_choice_271 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_271 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_271 then
        transform_left_filter_feature_0_choice_272 := ((transform_left_filter_column_4_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_272 := ((transform_left_filter_column_4_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_273 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_273 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_274 := transform_left_filter_feature_0_choice_273;
      else
        transform_left_filter_feature_0_choice_274 := ((transform_left_filter_column_3_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_274 then
        transform_left_filter_feature_0_choice_275 := (not (((transform_left_filter_column_3_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_275 := (not (((transform_left_filter_column_3_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_275 then
        transform_left_filter_feature_0_choice_276 := (not (((transform_left_filter_column_3_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_276 := (not (((transform_left_filter_column_3_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_276 then
        transform_left_filter_feature_0_choice_277 := (not (((transform_left_filter_column_3_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_277 := (not (((transform_left_filter_column_3_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_277 then
        transform_left_filter_feature_0_choice_278 := (not (((transform_left_filter_column_3_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_278 := (not (((transform_left_filter_column_3_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_278 then
        transform_left_filter_feature_0_choice_279 := (not (((transform_left_filter_column_3_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_279 := (not (((transform_left_filter_column_3_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_279 then
        transform_left_filter_feature_0_choice_280 := ((transform_left_filter_column_3_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_280 := ((transform_left_filter_column_3_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_281 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_281 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_282 := transform_left_filter_feature_0_choice_281;
      else
        transform_left_filter_feature_0_choice_282 := ((transform_left_filter_column_3_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_282 then
        transform_left_filter_feature_0_choice_283 := (not (((transform_left_filter_column_3_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_283 := (not (((transform_left_filter_column_3_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_283 then
        transform_left_filter_feature_0_choice_284 := (not (((transform_left_filter_column_3_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_284 := (not (((transform_left_filter_column_3_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_284 then
        transform_left_filter_feature_0_choice_285 := (not (((transform_left_filter_column_3_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_285 := (not (((transform_left_filter_column_3_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_285 then
        transform_left_filter_feature_0_choice_286 := (not (((transform_left_filter_column_3_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_286 := (not (((transform_left_filter_column_3_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_286 then
        transform_left_filter_feature_0_choice_287 := (not (((transform_left_filter_column_3_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_287 := (not (((transform_left_filter_column_3_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_287 then
        transform_left_filter_feature_0_choice_288 := ((transform_left_filter_column_3_6 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_288 := ((transform_left_filter_column_3_6 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_289 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_289 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_290 := transform_left_filter_feature_0_choice_289;
      else
        transform_left_filter_feature_0_choice_290 := ((transform_left_filter_column_3_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_290 then
        transform_left_filter_feature_0_choice_291 := (not (((transform_left_filter_column_3_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_291 := (not (((transform_left_filter_column_3_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_291 then
        transform_left_filter_feature_0_choice_292 := (not (((transform_left_filter_column_3_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_292 := (not (((transform_left_filter_column_3_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_292 then
        transform_left_filter_feature_0_choice_293 := (not (((transform_left_filter_column_3_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_293 := (not (((transform_left_filter_column_3_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_293 then
        transform_left_filter_feature_0_choice_294 := (not (((transform_left_filter_column_3_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_294 := (not (((transform_left_filter_column_3_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_294 then
        transform_left_filter_feature_0_choice_295 := (not (((transform_left_filter_column_3_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_295 := (not (((transform_left_filter_column_3_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_295 then
        transform_left_filter_feature_0_choice_296 := ((transform_left_filter_column_3_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_296 := ((transform_left_filter_column_3_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_297 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_297 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_298 := transform_left_filter_feature_0_choice_297;
      else
        transform_left_filter_feature_0_choice_298 := ((transform_left_filter_column_3_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_298 then
        transform_left_filter_feature_0_choice_299 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_299 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_299 then
        transform_left_filter_feature_0_choice_300 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_300 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_300 then
        transform_left_filter_feature_0_choice_301 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_301 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_301 then
        transform_left_filter_feature_0_choice_302 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_302 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_302 then
        transform_left_filter_feature_0_choice_303 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_303 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_303 then
        transform_left_filter_feature_0_choice_304 := ((transform_left_filter_column_3_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_304 := ((transform_left_filter_column_3_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_305 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_305 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_306 := transform_left_filter_feature_0_choice_305;
      else
        transform_left_filter_feature_0_choice_306 := ((transform_left_filter_column_3_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_306 then
        transform_left_filter_feature_0_choice_307 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_307 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_307 then
        transform_left_filter_feature_0_choice_308 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_308 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_308 then
        transform_left_filter_feature_0_choice_309 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_309 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_309 then
        transform_left_filter_feature_0_choice_310 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_310 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_310 then
        transform_left_filter_feature_0_choice_311 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_311 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_311 then
        transform_left_filter_feature_0_choice_312 := ((transform_left_filter_column_3_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_312 := ((transform_left_filter_column_3_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_313 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_313 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_314 := transform_left_filter_feature_0_choice_313;
      else
        transform_left_filter_feature_0_choice_314 := ((transform_left_filter_column_3_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_314 then
        transform_left_filter_feature_0_choice_315 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_315 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_315 then
        transform_left_filter_feature_0_choice_316 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_316 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_316 then
        transform_left_filter_feature_0_choice_317 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_317 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_317 then
        transform_left_filter_feature_0_choice_318 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_318 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_318 then
        transform_left_filter_feature_0_choice_319 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_319 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_319 then
        transform_left_filter_feature_0_choice_320 := ((transform_left_filter_column_3_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_320 := ((transform_left_filter_column_3_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_321 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_321 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_322 := transform_left_filter_feature_0_choice_321;
      else
        transform_left_filter_feature_0_choice_322 := ((transform_left_filter_column_3_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_322 then
        transform_left_filter_feature_0_choice_323 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_323 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_323 then
        transform_left_filter_feature_0_choice_324 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_324 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_324 then
        transform_left_filter_feature_0_choice_325 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_325 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_325 then
        transform_left_filter_feature_0_choice_326 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_326 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_326 then
        transform_left_filter_feature_0_choice_327 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_327 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_327 then
        transform_left_filter_feature_0_choice_328 := ((transform_left_filter_column_3_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_328 := ((transform_left_filter_column_3_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_329 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_329 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_330 := transform_left_filter_feature_0_choice_329;
      else
        transform_left_filter_feature_0_choice_330 := ((transform_left_filter_column_2_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_330 then
        transform_left_filter_feature_0_choice_331 := (not (((transform_left_filter_column_2_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_331 := (not (((transform_left_filter_column_2_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_331 then
        transform_left_filter_feature_0_choice_332 := (not (((transform_left_filter_column_2_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_332 := (not (((transform_left_filter_column_2_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_332 then
        transform_left_filter_feature_0_choice_333 := (not (((transform_left_filter_column_2_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_333 := (not (((transform_left_filter_column_2_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_333 then
        transform_left_filter_feature_0_choice_334 := (not (((transform_left_filter_column_2_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_334 := (not (((transform_left_filter_column_2_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_334 then
        transform_left_filter_feature_0_choice_335 := (not (((transform_left_filter_column_2_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_335 := (not (((transform_left_filter_column_2_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_335 then
        transform_left_filter_feature_0_choice_336 := ((transform_left_filter_column_2_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_336 := ((transform_left_filter_column_2_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_337 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_337 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_338 := transform_left_filter_feature_0_choice_337;
      else
        transform_left_filter_feature_0_choice_338 := ((transform_left_filter_column_2_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_338 then
        transform_left_filter_feature_0_choice_339 := (not (((transform_left_filter_column_2_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_339 := (not (((transform_left_filter_column_2_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_339 then
        transform_left_filter_feature_0_choice_340 := (not (((transform_left_filter_column_2_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_340 := (not (((transform_left_filter_column_2_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_340 then
        transform_left_filter_feature_0_choice_341 := (not (((transform_left_filter_column_2_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_341 := (not (((transform_left_filter_column_2_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_341 then
        transform_left_filter_feature_0_choice_342 := (not (((transform_left_filter_column_2_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_342 := (not (((transform_left_filter_column_2_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_342 then
        transform_left_filter_feature_0_choice_343 := (not (((transform_left_filter_column_2_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_343 := (not (((transform_left_filter_column_2_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_343 then
        transform_left_filter_feature_0_choice_344 := ((transform_left_filter_column_2_6 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_344 := ((transform_left_filter_column_2_6 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_345 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_345 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_346 := transform_left_filter_feature_0_choice_345;
      else
        transform_left_filter_feature_0_choice_346 := ((transform_left_filter_column_2_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_346 then
        transform_left_filter_feature_0_choice_347 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_347 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_347 then
        transform_left_filter_feature_0_choice_348 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_348 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_348 then
        transform_left_filter_feature_0_choice_349 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_349 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_349 then
        transform_left_filter_feature_0_choice_350 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_350 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_350 then
        transform_left_filter_feature_0_choice_351 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_351 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_351 then
        transform_left_filter_feature_0_choice_352 := ((transform_left_filter_column_2_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_352 := ((transform_left_filter_column_2_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_353 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_353 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_354 := transform_left_filter_feature_0_choice_353;
      else
        transform_left_filter_feature_0_choice_354 := ((transform_left_filter_column_2_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_354 then
        transform_left_filter_feature_0_choice_355 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_355 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_355 then
        transform_left_filter_feature_0_choice_356 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_356 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_356 then
        transform_left_filter_feature_0_choice_357 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_357 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_357 then
        transform_left_filter_feature_0_choice_358 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_358 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_358 then
        transform_left_filter_feature_0_choice_359 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_359 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_359 then
        transform_left_filter_feature_0_choice_360 := ((transform_left_filter_column_2_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_360 := ((transform_left_filter_column_2_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_361 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_361 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_362 := transform_left_filter_feature_0_choice_361;
      else
        transform_left_filter_feature_0_choice_362 := ((transform_left_filter_column_2_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_362 then
        transform_left_filter_feature_0_choice_363 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_363 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_363 then
        transform_left_filter_feature_0_choice_364 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_364 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_364 then
        transform_left_filter_feature_0_choice_365 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_365 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_365 then
        transform_left_filter_feature_0_choice_366 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_366 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_366 then
        transform_left_filter_feature_0_choice_367 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_367 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_367 then
        transform_left_filter_feature_0_choice_368 := ((transform_left_filter_column_2_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_368 := ((transform_left_filter_column_2_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_369 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_369 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_370 := transform_left_filter_feature_0_choice_369;
      else
        transform_left_filter_feature_0_choice_370 := ((transform_left_filter_column_2_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_370 then
        transform_left_filter_feature_0_choice_371 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_371 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_371 then
        transform_left_filter_feature_0_choice_372 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_372 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_372 then
        transform_left_filter_feature_0_choice_373 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_373 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_373 then
        transform_left_filter_feature_0_choice_374 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_374 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_374 then
        transform_left_filter_feature_0_choice_375 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_375 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_375 then
        transform_left_filter_feature_0_choice_376 := ((transform_left_filter_column_2_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_376 := ((transform_left_filter_column_2_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_377 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_377 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_378 := transform_left_filter_feature_0_choice_377;
      else
        transform_left_filter_feature_0_choice_378 := ((transform_left_filter_column_2_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_378 then
        transform_left_filter_feature_0_choice_379 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_379 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_379 then
        transform_left_filter_feature_0_choice_380 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_380 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_380 then
        transform_left_filter_feature_0_choice_381 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_381 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_381 then
        transform_left_filter_feature_0_choice_382 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_382 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_382 then
        transform_left_filter_feature_0_choice_383 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_383 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_383 then
        transform_left_filter_feature_0_choice_384 := ((transform_left_filter_column_2_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_384 := ((transform_left_filter_column_2_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_385 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_385 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_386 := transform_left_filter_feature_0_choice_385;
      else
        transform_left_filter_feature_0_choice_386 := ((transform_left_filter_column_1_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_386 then
        transform_left_filter_feature_0_choice_387 := (not (((transform_left_filter_column_1_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_387 := (not (((transform_left_filter_column_1_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_387 then
        transform_left_filter_feature_0_choice_388 := (not (((transform_left_filter_column_1_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_388 := (not (((transform_left_filter_column_1_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_388 then
        transform_left_filter_feature_0_choice_389 := (not (((transform_left_filter_column_1_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_389 := (not (((transform_left_filter_column_1_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_389 then
        transform_left_filter_feature_0_choice_390 := (not (((transform_left_filter_column_1_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_390 := (not (((transform_left_filter_column_1_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_390 then
        transform_left_filter_feature_0_choice_391 := (not (((transform_left_filter_column_1_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_391 := (not (((transform_left_filter_column_1_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_391 then
        transform_left_filter_feature_0_choice_392 := ((transform_left_filter_column_1_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_392 := ((transform_left_filter_column_1_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_393 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_393 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_394 := transform_left_filter_feature_0_choice_393;
      else
        transform_left_filter_feature_0_choice_394 := ((transform_left_filter_column_1_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_394 then
        transform_left_filter_feature_0_choice_395 := (not (((transform_left_filter_column_1_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_395 := (not (((transform_left_filter_column_1_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_395 then
        transform_left_filter_feature_0_choice_396 := (not (((transform_left_filter_column_1_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_396 := (not (((transform_left_filter_column_1_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_396 then
        transform_left_filter_feature_0_choice_397 := (not (((transform_left_filter_column_1_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_397 := (not (((transform_left_filter_column_1_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_397 then
        transform_left_filter_feature_0_choice_398 := (not (((transform_left_filter_column_1_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_398 := (not (((transform_left_filter_column_1_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_398 then
        transform_left_filter_feature_0_choice_399 := (not (((transform_left_filter_column_1_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_399 := (not (((transform_left_filter_column_1_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_399 then
        transform_left_filter_feature_0_choice_400 := ((transform_left_filter_column_1_6 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_400 := ((transform_left_filter_column_1_6 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_401 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_401 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_402 := transform_left_filter_feature_0_choice_401;
      else
        transform_left_filter_feature_0_choice_402 := ((transform_left_filter_column_1_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_402 then
        transform_left_filter_feature_0_choice_403 := (not (((transform_left_filter_column_1_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_403 := (not (((transform_left_filter_column_1_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_403 then
        transform_left_filter_feature_0_choice_404 := (not (((transform_left_filter_column_1_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_404 := (not (((transform_left_filter_column_1_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_404 then
        transform_left_filter_feature_0_choice_405 := (not (((transform_left_filter_column_1_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_405 := (not (((transform_left_filter_column_1_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_405 then
        transform_left_filter_feature_0_choice_406 := (not (((transform_left_filter_column_1_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_406 := (not (((transform_left_filter_column_1_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_406 then
        transform_left_filter_feature_0_choice_407 := (not (((transform_left_filter_column_1_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_407 := (not (((transform_left_filter_column_1_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_407 then
        transform_left_filter_feature_0_choice_408 := ((transform_left_filter_column_1_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_408 := ((transform_left_filter_column_1_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_409 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_409 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_410 := transform_left_filter_feature_0_choice_409;
      else
        transform_left_filter_feature_0_choice_410 := ((transform_left_filter_column_1_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_410 then
        transform_left_filter_feature_0_choice_411 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_411 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_411 then
        transform_left_filter_feature_0_choice_412 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_412 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_412 then
        transform_left_filter_feature_0_choice_413 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_413 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_413 then
        transform_left_filter_feature_0_choice_414 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_414 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_414 then
        transform_left_filter_feature_0_choice_415 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_415 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_415 then
        transform_left_filter_feature_0_choice_416 := ((transform_left_filter_column_1_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_416 := ((transform_left_filter_column_1_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_417 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_417 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_418 := transform_left_filter_feature_0_choice_417;
      else
        transform_left_filter_feature_0_choice_418 := ((transform_left_filter_column_1_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_418 then
        transform_left_filter_feature_0_choice_419 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_419 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_419 then
        transform_left_filter_feature_0_choice_420 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_420 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_420 then
        transform_left_filter_feature_0_choice_421 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_421 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_421 then
        transform_left_filter_feature_0_choice_422 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_422 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_422 then
        transform_left_filter_feature_0_choice_423 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_423 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_423 then
        transform_left_filter_feature_0_choice_424 := ((transform_left_filter_column_1_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_424 := ((transform_left_filter_column_1_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_425 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_425 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_426 := transform_left_filter_feature_0_choice_425;
      else
        transform_left_filter_feature_0_choice_426 := ((transform_left_filter_column_1_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_426 then
        transform_left_filter_feature_0_choice_427 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_427 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_427 then
        transform_left_filter_feature_0_choice_428 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_428 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_428 then
        transform_left_filter_feature_0_choice_429 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_429 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_429 then
        transform_left_filter_feature_0_choice_430 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_430 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_430 then
        transform_left_filter_feature_0_choice_431 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_431 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_431 then
        transform_left_filter_feature_0_choice_432 := ((transform_left_filter_column_1_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_432 := ((transform_left_filter_column_1_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_433 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_433 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_434 := transform_left_filter_feature_0_choice_433;
      else
        transform_left_filter_feature_0_choice_434 := ((transform_left_filter_column_1_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_434 then
        transform_left_filter_feature_0_choice_435 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_435 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_435 then
        transform_left_filter_feature_0_choice_436 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_436 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_436 then
        transform_left_filter_feature_0_choice_437 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_437 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_437 then
        transform_left_filter_feature_0_choice_438 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_438 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_438 then
        transform_left_filter_feature_0_choice_439 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_439 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_439 then
        transform_left_filter_feature_0_choice_440 := ((transform_left_filter_column_1_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_440 := ((transform_left_filter_column_1_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_5 mod 2) = 1 then
        transform_left_filter_feature_0_choice_441 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_441 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_5 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_442 := transform_left_filter_feature_0_choice_441;
      else
        transform_left_filter_feature_0_choice_442 := ((transform_left_filter_column_0_5 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_442 then
        transform_left_filter_feature_0_choice_443 := (not (((transform_left_filter_column_0_5 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_443 := (not (((transform_left_filter_column_0_5 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_443 then
        transform_left_filter_feature_0_choice_444 := (not (((transform_left_filter_column_0_5 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_444 := (not (((transform_left_filter_column_0_5 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_444 then
        transform_left_filter_feature_0_choice_445 := (not (((transform_left_filter_column_0_5 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_445 := (not (((transform_left_filter_column_0_5 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_445 then
        transform_left_filter_feature_0_choice_446 := (not (((transform_left_filter_column_0_5 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_446 := (not (((transform_left_filter_column_0_5 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_446 then
        transform_left_filter_feature_0_choice_447 := (not (((transform_left_filter_column_0_5 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_447 := (not (((transform_left_filter_column_0_5 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_447 then
        transform_left_filter_feature_0_choice_448 := ((transform_left_filter_column_0_5 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_448 := ((transform_left_filter_column_0_5 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_6 mod 2) = 1 then
        transform_left_filter_feature_0_choice_449 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_449 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_6 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_450 := transform_left_filter_feature_0_choice_449;
      else
        transform_left_filter_feature_0_choice_450 := ((transform_left_filter_column_0_6 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_450 then
        transform_left_filter_feature_0_choice_451 := (not (((transform_left_filter_column_0_6 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_451 := (not (((transform_left_filter_column_0_6 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_451 then
        transform_left_filter_feature_0_choice_452 := (not (((transform_left_filter_column_0_6 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_452 := (not (((transform_left_filter_column_0_6 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_452 then
        transform_left_filter_feature_0_choice_453 := (not (((transform_left_filter_column_0_6 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_453 := (not (((transform_left_filter_column_0_6 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_453 then
        transform_left_filter_feature_0_choice_454 := (not (((transform_left_filter_column_0_6 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_454 := (not (((transform_left_filter_column_0_6 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_454 then
        transform_left_filter_feature_0_choice_455 := (not (((transform_left_filter_column_0_6 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_455 := (not (((transform_left_filter_column_0_6 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_455 then
        transform_left_filter_feature_0_choice_456 := ((transform_left_filter_column_0_6 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_456 := ((transform_left_filter_column_0_6 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_457 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_457 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_458 := transform_left_filter_feature_0_choice_457;
      else
        transform_left_filter_feature_0_choice_458 := ((transform_left_filter_column_0_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_458 then
        transform_left_filter_feature_0_choice_459 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_459 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_459 then
        transform_left_filter_feature_0_choice_460 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_460 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_460 then
        transform_left_filter_feature_0_choice_461 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_461 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_461 then
        transform_left_filter_feature_0_choice_462 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_462 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_462 then
        transform_left_filter_feature_0_choice_463 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_463 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_463 then
        transform_left_filter_feature_0_choice_464 := ((transform_left_filter_column_0_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_464 := ((transform_left_filter_column_0_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_465 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_465 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_466 := transform_left_filter_feature_0_choice_465;
      else
        transform_left_filter_feature_0_choice_466 := ((transform_left_filter_column_0_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_466 then
        transform_left_filter_feature_0_choice_467 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_467 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_467 then
        transform_left_filter_feature_0_choice_468 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_468 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_468 then
        transform_left_filter_feature_0_choice_469 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_469 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_469 then
        transform_left_filter_feature_0_choice_470 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_470 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_470 then
        transform_left_filter_feature_0_choice_471 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_471 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_471 then
        transform_left_filter_feature_0_choice_472 := ((transform_left_filter_column_0_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_472 := ((transform_left_filter_column_0_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_473 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_473 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_474 := transform_left_filter_feature_0_choice_473;
      else
        transform_left_filter_feature_0_choice_474 := ((transform_left_filter_column_0_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_474 then
        transform_left_filter_feature_0_choice_475 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_475 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_475 then
        transform_left_filter_feature_0_choice_476 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_476 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_476 then
        transform_left_filter_feature_0_choice_477 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_477 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_477 then
        transform_left_filter_feature_0_choice_478 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_478 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_478 then
        transform_left_filter_feature_0_choice_479 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_479 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_479 then
        transform_left_filter_feature_0_choice_480 := ((transform_left_filter_column_0_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_480 := ((transform_left_filter_column_0_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_481 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_481 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_482 := transform_left_filter_feature_0_choice_481;
      else
        transform_left_filter_feature_0_choice_482 := ((transform_left_filter_column_0_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_482 then
        transform_left_filter_feature_0_choice_483 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_483 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_483 then
        transform_left_filter_feature_0_choice_484 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_484 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_484 then
        transform_left_filter_feature_0_choice_485 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_485 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_485 then
        transform_left_filter_feature_0_choice_486 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_486 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_486 then
        transform_left_filter_feature_0_choice_487 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_487 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_487 then
        transform_left_filter_feature_0_choice_488 := ((transform_left_filter_column_0_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_488 := ((transform_left_filter_column_0_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_489 := not (((transform_left_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_left_filter_feature_0_choice_489 := (transform_left_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value then
        transform_left_filter_feature_0_choice_490 := ((transform_left_filter_column_4_3 mod 2) = 1) or (not
          (((transform_left_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_left_filter_column_0_0 mod 2) = 1));
      else
        transform_left_filter_feature_0_choice_490 := transform_left_filter_feature_0_choice_489;
      end if;
      transform_left_filter_feature_0_value_7 := ((transform_left_filter_column_0_0 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_490 then
        transform_left_filter_feature_0_choice_491 := (not transform_left_filter_feature_0_value_2) and
          transform_left_filter_feature_0_value_7;
      else
        transform_left_filter_feature_0_choice_491 := (not transform_left_filter_feature_0_value_2) or
          transform_left_filter_feature_0_value_7;
      end if;
      transform_left_filter_feature_0_value_8 := ((transform_left_filter_column_0_0 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_491 then
        transform_left_filter_feature_0_choice_492 := (not transform_left_filter_feature_0_value_3) or
          transform_left_filter_feature_0_value_8;
      else
        transform_left_filter_feature_0_choice_492 := (not transform_left_filter_feature_0_value_3) and
          transform_left_filter_feature_0_value_8;
      end if;
      transform_left_filter_feature_0_value_9 := ((transform_left_filter_column_0_0 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_492 then
        transform_left_filter_feature_0_choice_493 := (not transform_left_filter_feature_0_value_4) or
          transform_left_filter_feature_0_value_9;
      else
        transform_left_filter_feature_0_choice_493 := (not transform_left_filter_feature_0_value_4) and
          transform_left_filter_feature_0_value_9;
      end if;
      transform_left_filter_feature_0_value_10 := ((transform_left_filter_column_0_0 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_493 then
        transform_left_filter_feature_0_choice_494 := (not transform_left_filter_feature_0_value_5) or
          transform_left_filter_feature_0_value_10;
      else
        transform_left_filter_feature_0_choice_494 := (not transform_left_filter_feature_0_value_5) and
          transform_left_filter_feature_0_value_10;
      end if;
      transform_left_filter_feature_0_value_11 := ((transform_left_filter_column_0_0 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_494 then
        transform_left_filter_feature_0_choice_495 := (not transform_left_filter_feature_0_value_6) or
          transform_left_filter_feature_0_value_11;
      else
        transform_left_filter_feature_0_choice_495 := (not transform_left_filter_feature_0_value_6) and
          transform_left_filter_feature_0_value_11;
      end if;
      if transform_left_filter_feature_0_choice_495 then
        transform_left_filter_feature_0_choice_496 := (not ((transform_left_filter_column_4_3 / 128) = 1)) or
          ((transform_left_filter_column_0_0 / 128) = 1);
      else
        transform_left_filter_feature_0_choice_496 := (not ((transform_left_filter_column_4_3 / 128) = 1)) and
          ((transform_left_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_left_filter_feature_0_choice_497 := (as_number(transform_left_filter_feature_0_choice_448) * 32) +
          (as_number(transform_left_filter_feature_0_choice_456) * 64) +
          (as_number(transform_left_filter_feature_0_choice_464) * 16) +
          (as_number(transform_left_filter_feature_0_choice_472) * 8) +
          (as_number(transform_left_filter_feature_0_choice_480) * 4) +
          (as_number(transform_left_filter_feature_0_choice_488) * 2) +
          as_number(transform_left_filter_feature_0_choice_496);
      else
        transform_left_filter_feature_0_choice_497 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_left_filter_feature_0_choice_498 := (as_number(transform_left_filter_feature_0_choice_392) * 4096) +
          (as_number(transform_left_filter_feature_0_choice_400) * 8192) +
          (as_number(transform_left_filter_feature_0_choice_408) * 2048) +
          (as_number(transform_left_filter_feature_0_choice_416) * 1024) +
          (as_number(transform_left_filter_feature_0_choice_424) * 512) +
          (as_number(transform_left_filter_feature_0_choice_432) * 256) +
          (as_number(transform_left_filter_feature_0_choice_440) * 128) + transform_left_filter_feature_0_choice_497;
      else
        transform_left_filter_feature_0_choice_498 := transform_left_filter_feature_0_choice_497;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_left_filter_feature_0_choice_499 := (as_number(transform_left_filter_feature_0_choice_336) * 524288)
          + (as_number(transform_left_filter_feature_0_choice_344) * 1048576) +
          (as_number(transform_left_filter_feature_0_choice_352) * 262144) +
          (as_number(transform_left_filter_feature_0_choice_360) * 131072) +
          (as_number(transform_left_filter_feature_0_choice_368) * 65536) +
          (as_number(transform_left_filter_feature_0_choice_376) * 32768) +
          (as_number(transform_left_filter_feature_0_choice_384) * 16384) + transform_left_filter_feature_0_choice_498;
      else
        transform_left_filter_feature_0_choice_499 := transform_left_filter_feature_0_choice_498;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_left_filter_feature_0_choice_500 := (as_number(transform_left_filter_feature_0_choice_280) *
          67108864) + (as_number(transform_left_filter_feature_0_choice_288) * 134217728) +
          (as_number(transform_left_filter_feature_0_choice_296) * 33554432) +
          (as_number(transform_left_filter_feature_0_choice_304) * 16777216) +
          (as_number(transform_left_filter_feature_0_choice_312) * 8388608) +
          (as_number(transform_left_filter_feature_0_choice_320) * 4194304) +
          (as_number(transform_left_filter_feature_0_choice_328) * 2097152) +
          transform_left_filter_feature_0_choice_499;
      else
        transform_left_filter_feature_0_choice_500 := transform_left_filter_feature_0_choice_499;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0_choice_501 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choice_240), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_248), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_256), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_264), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_272), 1) &
          to_unsigned(transform_left_filter_feature_0_choice_500, 28);
      else
        transform_left_filter_feature_0_choice_501 := to_unsigned(transform_left_filter_feature_0_choice_500, 33);
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_left_filter_feature_0_choice_502 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choice_224), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_216), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_208), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_200), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_192), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_184), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_176), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_232), 1) &
          transform_left_filter_feature_0_choice_501(32 downto 0);
      else
        transform_left_filter_feature_0_choice_502 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choice_232), 8) &
          transform_left_filter_feature_0_choice_501(32 downto 0);
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_left_filter_feature_0_choice_503 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choice_168), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_160), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_152), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_144), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_136), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_128), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_120), 1) &
          transform_left_filter_feature_0_choice_502(40 downto 0);
      else
        transform_left_filter_feature_0_choice_503 := resize(transform_left_filter_feature_0_choice_502, 48);
      end if;
      if transform_filtering_0_column_inside_7 then
        transform_left_filter_feature_0_choice_504 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choice_112), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_104), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_96), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_88), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_80), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_72), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_64), 1) &
          transform_left_filter_feature_0_choice_503(47 downto 0);
      else
        transform_left_filter_feature_0_choice_504 := resize(transform_left_filter_feature_0_choice_503, 55);
      end if;
      transform_right_filter_feature_0_value := ((transform_right_filter_column_4_3 / 2) mod 2) = 1;
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        ((transform_right_filter_column_4_3 mod 2) = 1));
      if (transform_right_filter_column_8_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_4_3 mod 4) = 0;
      if ((transform_right_filter_column_8_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choice_2 := ((transform_right_filter_column_8_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_2 := ((transform_right_filter_column_4_3 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_2 then
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_3 := ((transform_right_filter_column_4_3 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_3 then
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_4 := ((transform_right_filter_column_4_3 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_4 then
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_5 := ((transform_right_filter_column_4_3 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_5 then
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_6 := ((transform_right_filter_column_4_3 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_6 then
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_7 then
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_8_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_8_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
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
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_8_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
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
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_24 := ((transform_right_filter_column_8_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
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
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_8_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
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
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_8_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_8_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_41 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_41 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_42 := transform_right_filter_feature_0_choice_41;
      else
        transform_right_filter_feature_0_choice_42 := ((transform_right_filter_column_8_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_42 then
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_8_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_8_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_43 then
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_8_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_8_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_44 then
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_8_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_8_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_45 then
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_8_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_8_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_46 then
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_8_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_8_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_47 then
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_8_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_8_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_8_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_49 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_49 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_8_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_50 := transform_right_filter_feature_0_choice_49;
      else
        transform_right_filter_feature_0_choice_50 := ((transform_right_filter_column_8_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_50 then
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_8_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_8_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_51 then
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_8_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_8_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_52 then
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_8_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_8_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_53 then
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_8_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_8_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_54 then
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_8_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_8_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_55 then
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_8_6 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_8_6 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_57 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_57 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_58 := transform_right_filter_feature_0_choice_57;
      else
        transform_right_filter_feature_0_choice_58 := ((transform_right_filter_column_7_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_58 then
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_7_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_7_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_59 then
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_7_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_7_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_60 then
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_7_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_7_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_61 then
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_7_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_7_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_62 then
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_7_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_7_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_63 then
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_7_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_7_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_65 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_65 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_66 := transform_right_filter_feature_0_choice_65;
      else
        transform_right_filter_feature_0_choice_66 := ((transform_right_filter_column_7_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_66 then
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_7_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_7_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_67 then
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_7_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_7_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_68 then
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_7_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_7_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_69 then
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_7_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_7_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_70 then
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_7_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_7_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_71 then
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_7_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_7_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_73 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_73 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_74 := transform_right_filter_feature_0_choice_73;
      else
        transform_right_filter_feature_0_choice_74 := ((transform_right_filter_column_7_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_74 then
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_7_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_7_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_75 then
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_7_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_7_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_76 then
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_7_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_7_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_77 then
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_7_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_7_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_78 then
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_7_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_7_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_79 then
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_7_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_7_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_81 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_81 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_82 := transform_right_filter_feature_0_choice_81;
      else
        transform_right_filter_feature_0_choice_82 := ((transform_right_filter_column_7_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_82 then
        transform_right_filter_feature_0_choice_83 := (not (((transform_right_filter_column_7_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_83 := (not (((transform_right_filter_column_7_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_83 then
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_7_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_7_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_84 then
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_7_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_7_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_85 then
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_7_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_7_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_86 then
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_7_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_7_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_87 then
        transform_right_filter_feature_0_choice_88 := ((transform_right_filter_column_7_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_88 := ((transform_right_filter_column_7_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_89 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_89 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_90 := transform_right_filter_feature_0_choice_89;
      else
        transform_right_filter_feature_0_choice_90 := ((transform_right_filter_column_7_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_90 then
        transform_right_filter_feature_0_choice_91 := (not (((transform_right_filter_column_7_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_91 := (not (((transform_right_filter_column_7_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_91 then
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_7_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_7_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_92 then
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_7_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_7_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_93 then
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_7_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_7_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_94 then
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_7_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_7_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_95 then
        transform_right_filter_feature_0_choice_96 := ((transform_right_filter_column_7_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_96 := ((transform_right_filter_column_7_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_97 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_97 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_98 := transform_right_filter_feature_0_choice_97;
      else
        transform_right_filter_feature_0_choice_98 := ((transform_right_filter_column_7_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_98 then
        transform_right_filter_feature_0_choice_99 := (not (((transform_right_filter_column_7_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_99 := (not (((transform_right_filter_column_7_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_99 then
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_7_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_7_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_100 then
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_7_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_7_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_101 then
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_7_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_7_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_102 then
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_7_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_7_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_103 then
        transform_right_filter_feature_0_choice_104 := ((transform_right_filter_column_7_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_104 := ((transform_right_filter_column_7_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_105 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_105 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_106 := transform_right_filter_feature_0_choice_105;
      else
        transform_right_filter_feature_0_choice_106 := ((transform_right_filter_column_7_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_106 then
        transform_right_filter_feature_0_choice_107 := (not (((transform_right_filter_column_7_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_107 := (not (((transform_right_filter_column_7_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_107 then
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_7_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_7_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_108 then
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_7_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_7_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_109 then
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_7_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_7_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_110 then
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_7_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_7_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_111 then
        transform_right_filter_feature_0_choice_112 := ((transform_right_filter_column_7_6 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_112 := ((transform_right_filter_column_7_6 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_113 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_113 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_114 := transform_right_filter_feature_0_choice_113;
      else
        transform_right_filter_feature_0_choice_114 := ((transform_right_filter_column_6_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_114 then
        transform_right_filter_feature_0_choice_115 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_115 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_115 then
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_116 then
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_117 then
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_118 then
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_119 then
        transform_right_filter_feature_0_choice_120 := ((transform_right_filter_column_6_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_120 := ((transform_right_filter_column_6_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_121 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_121 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_122 := transform_right_filter_feature_0_choice_121;
      else
        transform_right_filter_feature_0_choice_122 := ((transform_right_filter_column_6_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_122 then
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_123 then
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_124 then
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_125 then
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_126 then
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_127 then
        transform_right_filter_feature_0_choice_128 := ((transform_right_filter_column_6_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_128 := ((transform_right_filter_column_6_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_129 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_129 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_130 := transform_right_filter_feature_0_choice_129;
      else
        transform_right_filter_feature_0_choice_130 := ((transform_right_filter_column_6_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_130 then
        transform_right_filter_feature_0_choice_131 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_131 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_131 then
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_132 then
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_133 then
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_134 then
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_135 then
        transform_right_filter_feature_0_choice_136 := ((transform_right_filter_column_6_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_136 := ((transform_right_filter_column_6_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_137 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_137 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_138 := transform_right_filter_feature_0_choice_137;
      else
        transform_right_filter_feature_0_choice_138 := ((transform_right_filter_column_6_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_138 then
        transform_right_filter_feature_0_choice_139 := (not (((transform_right_filter_column_6_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_139 := (not (((transform_right_filter_column_6_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_139 then
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_6_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_6_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_140 then
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_6_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_6_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_141 then
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_6_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_6_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_142 then
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_6_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_6_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_143 then
        transform_right_filter_feature_0_choice_144 := ((transform_right_filter_column_6_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_144 := ((transform_right_filter_column_6_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_145 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_145 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_146 := transform_right_filter_feature_0_choice_145;
      else
        transform_right_filter_feature_0_choice_146 := ((transform_right_filter_column_6_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_146 then
        transform_right_filter_feature_0_choice_147 := (not (((transform_right_filter_column_6_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_147 := (not (((transform_right_filter_column_6_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_147 then
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_6_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_6_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_148 then
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_6_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_6_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_149 then
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_6_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_6_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_150 then
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_6_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_6_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_151 then
        transform_right_filter_feature_0_choice_152 := ((transform_right_filter_column_6_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_152 := ((transform_right_filter_column_6_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_153 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_153 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_154 := transform_right_filter_feature_0_choice_153;
      else
        transform_right_filter_feature_0_choice_154 := ((transform_right_filter_column_6_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_154 then
        transform_right_filter_feature_0_choice_155 := (not (((transform_right_filter_column_6_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_155 := (not (((transform_right_filter_column_6_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_155 then
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_6_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_6_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_156 then
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_6_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_6_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_157 then
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_6_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_6_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_158 then
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_6_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_6_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_159 then
        transform_right_filter_feature_0_choice_160 := ((transform_right_filter_column_6_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_160 := ((transform_right_filter_column_6_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_161 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_161 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_162 := transform_right_filter_feature_0_choice_161;
      else
        transform_right_filter_feature_0_choice_162 := ((transform_right_filter_column_6_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_162 then
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_6_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_6_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_163 then
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_6_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_6_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_164 then
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_6_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_6_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_165 then
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_6_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_6_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_166 then
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_6_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_6_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_167 then
        transform_right_filter_feature_0_choice_168 := ((transform_right_filter_column_6_6 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_168 := ((transform_right_filter_column_6_6 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_169 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_169 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_170 := transform_right_filter_feature_0_choice_169;
      else
        transform_right_filter_feature_0_choice_170 := ((transform_right_filter_column_5_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_170 then
        transform_right_filter_feature_0_choice_171 := (not (((transform_right_filter_column_5_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_171 := (not (((transform_right_filter_column_5_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_171 then
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_5_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_5_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_172 then
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_5_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_5_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_173 then
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_5_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_5_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_174 then
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_5_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_5_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_175 then
        transform_right_filter_feature_0_choice_176 := ((transform_right_filter_column_5_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_176 := ((transform_right_filter_column_5_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_177 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_177 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_178 := transform_right_filter_feature_0_choice_177;
      else
        transform_right_filter_feature_0_choice_178 := ((transform_right_filter_column_5_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_178 then
        transform_right_filter_feature_0_choice_179 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_179 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_179 then
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_180 then
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_181 then
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_182 then
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_183 then
        transform_right_filter_feature_0_choice_184 := ((transform_right_filter_column_5_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_184 := ((transform_right_filter_column_5_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_185 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_185 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_186 := transform_right_filter_feature_0_choice_185;
      else
        transform_right_filter_feature_0_choice_186 := ((transform_right_filter_column_5_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_186 then
        transform_right_filter_feature_0_choice_187 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_187 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_187 then
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_188 then
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_189 then
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_190 then
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_191 then
        transform_right_filter_feature_0_choice_192 := ((transform_right_filter_column_5_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_192 := ((transform_right_filter_column_5_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_193 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_193 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_194 := transform_right_filter_feature_0_choice_193;
      else
        transform_right_filter_feature_0_choice_194 := ((transform_right_filter_column_5_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_194 then
        transform_right_filter_feature_0_choice_195 := (not (((transform_right_filter_column_5_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_195 := (not (((transform_right_filter_column_5_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_195 then
        transform_right_filter_feature_0_choice_196 := (not (((transform_right_filter_column_5_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_196 := (not (((transform_right_filter_column_5_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_196 then
        transform_right_filter_feature_0_choice_197 := (not (((transform_right_filter_column_5_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_197 := (not (((transform_right_filter_column_5_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_197 then
        transform_right_filter_feature_0_choice_198 := (not (((transform_right_filter_column_5_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_198 := (not (((transform_right_filter_column_5_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_198 then
        transform_right_filter_feature_0_choice_199 := (not (((transform_right_filter_column_5_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_199 := (not (((transform_right_filter_column_5_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_199 then
        transform_right_filter_feature_0_choice_200 := ((transform_right_filter_column_5_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_200 := ((transform_right_filter_column_5_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_201 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_201 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_202 := transform_right_filter_feature_0_choice_201;
      else
        transform_right_filter_feature_0_choice_202 := ((transform_right_filter_column_5_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_202 then
        transform_right_filter_feature_0_choice_203 := (not (((transform_right_filter_column_5_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_203 := (not (((transform_right_filter_column_5_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_203 then
        transform_right_filter_feature_0_choice_204 := (not (((transform_right_filter_column_5_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_204 := (not (((transform_right_filter_column_5_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_204 then
        transform_right_filter_feature_0_choice_205 := (not (((transform_right_filter_column_5_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_205 := (not (((transform_right_filter_column_5_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_205 then
        transform_right_filter_feature_0_choice_206 := (not (((transform_right_filter_column_5_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_206 := (not (((transform_right_filter_column_5_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_206 then
        transform_right_filter_feature_0_choice_207 := (not (((transform_right_filter_column_5_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_207 := (not (((transform_right_filter_column_5_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_207 then
        transform_right_filter_feature_0_choice_208 := ((transform_right_filter_column_5_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_208 := ((transform_right_filter_column_5_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_209 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_209 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_210 := transform_right_filter_feature_0_choice_209;
      else
        transform_right_filter_feature_0_choice_210 := ((transform_right_filter_column_5_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_210 then
        transform_right_filter_feature_0_choice_211 := (not (((transform_right_filter_column_5_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_211 := (not (((transform_right_filter_column_5_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_211 then
        transform_right_filter_feature_0_choice_212 := (not (((transform_right_filter_column_5_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_212 := (not (((transform_right_filter_column_5_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_212 then
        transform_right_filter_feature_0_choice_213 := (not (((transform_right_filter_column_5_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_213 := (not (((transform_right_filter_column_5_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_213 then
        transform_right_filter_feature_0_choice_214 := (not (((transform_right_filter_column_5_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_214 := (not (((transform_right_filter_column_5_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_214 then
        transform_right_filter_feature_0_choice_215 := (not (((transform_right_filter_column_5_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_215 := (not (((transform_right_filter_column_5_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_215 then
        transform_right_filter_feature_0_choice_216 := ((transform_right_filter_column_5_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_216 := ((transform_right_filter_column_5_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_217 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_217 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_218 := transform_right_filter_feature_0_choice_217;
      else
        transform_right_filter_feature_0_choice_218 := ((transform_right_filter_column_5_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_218 then
        transform_right_filter_feature_0_choice_219 := (not (((transform_right_filter_column_5_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_219 := (not (((transform_right_filter_column_5_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_219 then
        transform_right_filter_feature_0_choice_220 := (not (((transform_right_filter_column_5_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_220 := (not (((transform_right_filter_column_5_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_220 then
        transform_right_filter_feature_0_choice_221 := (not (((transform_right_filter_column_5_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_221 := (not (((transform_right_filter_column_5_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_221 then
        transform_right_filter_feature_0_choice_222 := (not (((transform_right_filter_column_5_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_222 := (not (((transform_right_filter_column_5_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_222 then
        transform_right_filter_feature_0_choice_223 := (not (((transform_right_filter_column_5_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_223 := (not (((transform_right_filter_column_5_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_223 then
        transform_right_filter_feature_0_choice_224 := ((transform_right_filter_column_5_6 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_224 := ((transform_right_filter_column_5_6 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_225 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_225 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_226 := transform_right_filter_feature_0_choice_225;
      else
        transform_right_filter_feature_0_choice_226 := ((transform_right_filter_column_4_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_226 then
        transform_right_filter_feature_0_choice_227 := (not (((transform_right_filter_column_4_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_227 := (not (((transform_right_filter_column_4_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_227 then
        transform_right_filter_feature_0_choice_228 := (not (((transform_right_filter_column_4_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_228 := (not (((transform_right_filter_column_4_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_228 then
        transform_right_filter_feature_0_choice_229 := (not (((transform_right_filter_column_4_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_229 := (not (((transform_right_filter_column_4_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_229 then
        transform_right_filter_feature_0_choice_230 := (not (((transform_right_filter_column_4_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_230 := (not (((transform_right_filter_column_4_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_230 then
        transform_right_filter_feature_0_choice_231 := (not (((transform_right_filter_column_4_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_231 := (not (((transform_right_filter_column_4_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_231 then
        transform_right_filter_feature_0_choice_232 := transform_filtering_0_column_inside_4 and
          ((transform_right_filter_column_4_6 / 128) = 1) and (not ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_232 := transform_filtering_0_column_inside_4 and
          (((transform_right_filter_column_4_6 / 128) = 1) or (not ((transform_right_filter_column_4_3 / 128) = 1)));
      end if;
      if (transform_right_filter_column_4_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_233 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_233 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_234 := transform_right_filter_feature_0_choice_233;
      else
        transform_right_filter_feature_0_choice_234 := ((transform_right_filter_column_4_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_234 then
        transform_right_filter_feature_0_choice_235 := (not (((transform_right_filter_column_4_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_235 := (not (((transform_right_filter_column_4_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_235 then
        transform_right_filter_feature_0_choice_236 := (not (((transform_right_filter_column_4_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_236 := (not (((transform_right_filter_column_4_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_236 then
        transform_right_filter_feature_0_choice_237 := (not (((transform_right_filter_column_4_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_237 := (not (((transform_right_filter_column_4_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_237 then
        transform_right_filter_feature_0_choice_238 := (not (((transform_right_filter_column_4_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_238 := (not (((transform_right_filter_column_4_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_238 then
        transform_right_filter_feature_0_choice_239 := (not (((transform_right_filter_column_4_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_239 := (not (((transform_right_filter_column_4_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_239 then
        transform_right_filter_feature_0_choice_240 := ((transform_right_filter_column_4_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_240 := ((transform_right_filter_column_4_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_241 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_241 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_242 := transform_right_filter_feature_0_choice_241;
      else
        transform_right_filter_feature_0_choice_242 := ((transform_right_filter_column_4_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_242 then
        transform_right_filter_feature_0_choice_243 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_243 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_243 then
        transform_right_filter_feature_0_choice_244 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_244 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_244 then
        transform_right_filter_feature_0_choice_245 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_245 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_245 then
        transform_right_filter_feature_0_choice_246 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_246 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_246 then
        transform_right_filter_feature_0_choice_247 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_247 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_247 then
        transform_right_filter_feature_0_choice_248 := ((transform_right_filter_column_4_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_248 := ((transform_right_filter_column_4_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_249 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_249 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_250 := transform_right_filter_feature_0_choice_249;
      else
        transform_right_filter_feature_0_choice_250 := ((transform_right_filter_column_4_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_250 then
        transform_right_filter_feature_0_choice_251 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_251 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_251 then
        transform_right_filter_feature_0_choice_252 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_252 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_252 then
        transform_right_filter_feature_0_choice_253 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_253 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_253 then
        transform_right_filter_feature_0_choice_254 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_254 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_254 then
        transform_right_filter_feature_0_choice_255 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_255 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_255 then
        transform_right_filter_feature_0_choice_256 := ((transform_right_filter_column_4_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_256 := ((transform_right_filter_column_4_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_257 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_257 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_258 := transform_right_filter_feature_0_choice_257;
      else
        transform_right_filter_feature_0_choice_258 := ((transform_right_filter_column_4_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_258 then
        transform_right_filter_feature_0_choice_259 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_259 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_259 then
        transform_right_filter_feature_0_choice_260 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_260 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_260 then
        transform_right_filter_feature_0_choice_261 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_261 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_261 then
        transform_right_filter_feature_0_choice_262 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_262 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_262 then
        transform_right_filter_feature_0_choice_263 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_263 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_263 then
        transform_right_filter_feature_0_choice_264 := ((transform_right_filter_column_4_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_264 := ((transform_right_filter_column_4_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_265 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_265 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_266 := transform_right_filter_feature_0_choice_265;
      else
        transform_right_filter_feature_0_choice_266 := ((transform_right_filter_column_4_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_266 then
        transform_right_filter_feature_0_choice_267 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_267 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_267 then
        transform_right_filter_feature_0_choice_268 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_268 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_268 then
        transform_right_filter_feature_0_choice_269 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_269 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_269 then
        transform_right_filter_feature_0_choice_270 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_270 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_270 then
        transform_right_filter_feature_0_choice_271 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_271 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_271 then
        transform_right_filter_feature_0_choice_272 := ((transform_right_filter_column_4_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_272 := ((transform_right_filter_column_4_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_273 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_273 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_274 := transform_right_filter_feature_0_choice_273;
      else
        transform_right_filter_feature_0_choice_274 := ((transform_right_filter_column_3_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_274 then
        transform_right_filter_feature_0_choice_275 := (not (((transform_right_filter_column_3_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_275 := (not (((transform_right_filter_column_3_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_275 then
        transform_right_filter_feature_0_choice_276 := (not (((transform_right_filter_column_3_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_276 := (not (((transform_right_filter_column_3_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_276 then
        transform_right_filter_feature_0_choice_277 := (not (((transform_right_filter_column_3_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_277 := (not (((transform_right_filter_column_3_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_277 then
        transform_right_filter_feature_0_choice_278 := (not (((transform_right_filter_column_3_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_278 := (not (((transform_right_filter_column_3_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_278 then
        transform_right_filter_feature_0_choice_279 := (not (((transform_right_filter_column_3_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_279 := (not (((transform_right_filter_column_3_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_279 then
        transform_right_filter_feature_0_choice_280 := ((transform_right_filter_column_3_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_280 := ((transform_right_filter_column_3_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_281 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_281 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_282 := transform_right_filter_feature_0_choice_281;
      else
        transform_right_filter_feature_0_choice_282 := ((transform_right_filter_column_3_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_282 then
        transform_right_filter_feature_0_choice_283 := (not (((transform_right_filter_column_3_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_283 := (not (((transform_right_filter_column_3_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_283 then
        transform_right_filter_feature_0_choice_284 := (not (((transform_right_filter_column_3_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_284 := (not (((transform_right_filter_column_3_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_284 then
        transform_right_filter_feature_0_choice_285 := (not (((transform_right_filter_column_3_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_285 := (not (((transform_right_filter_column_3_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_285 then
        transform_right_filter_feature_0_choice_286 := (not (((transform_right_filter_column_3_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_286 := (not (((transform_right_filter_column_3_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_286 then
        transform_right_filter_feature_0_choice_287 := (not (((transform_right_filter_column_3_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_287 := (not (((transform_right_filter_column_3_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_287 then
        transform_right_filter_feature_0_choice_288 := ((transform_right_filter_column_3_6 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_288 := ((transform_right_filter_column_3_6 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_289 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_289 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_290 := transform_right_filter_feature_0_choice_289;
      else
        transform_right_filter_feature_0_choice_290 := ((transform_right_filter_column_3_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_290 then
        transform_right_filter_feature_0_choice_291 := (not (((transform_right_filter_column_3_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_291 := (not (((transform_right_filter_column_3_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_291 then
        transform_right_filter_feature_0_choice_292 := (not (((transform_right_filter_column_3_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_292 := (not (((transform_right_filter_column_3_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_292 then
        transform_right_filter_feature_0_choice_293 := (not (((transform_right_filter_column_3_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_293 := (not (((transform_right_filter_column_3_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_293 then
        transform_right_filter_feature_0_choice_294 := (not (((transform_right_filter_column_3_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_294 := (not (((transform_right_filter_column_3_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_294 then
        transform_right_filter_feature_0_choice_295 := (not (((transform_right_filter_column_3_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_295 := (not (((transform_right_filter_column_3_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_295 then
        transform_right_filter_feature_0_choice_296 := ((transform_right_filter_column_3_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_296 := ((transform_right_filter_column_3_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_297 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_297 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_298 := transform_right_filter_feature_0_choice_297;
      else
        transform_right_filter_feature_0_choice_298 := ((transform_right_filter_column_3_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_298 then
        transform_right_filter_feature_0_choice_299 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_299 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_299 then
        transform_right_filter_feature_0_choice_300 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_300 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_300 then
        transform_right_filter_feature_0_choice_301 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_301 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_301 then
        transform_right_filter_feature_0_choice_302 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_302 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_302 then
        transform_right_filter_feature_0_choice_303 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_303 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_303 then
        transform_right_filter_feature_0_choice_304 := ((transform_right_filter_column_3_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_304 := ((transform_right_filter_column_3_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_305 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_305 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_306 := transform_right_filter_feature_0_choice_305;
      else
        transform_right_filter_feature_0_choice_306 := ((transform_right_filter_column_3_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_306 then
        transform_right_filter_feature_0_choice_307 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_307 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_307 then
        transform_right_filter_feature_0_choice_308 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_308 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_308 then
        transform_right_filter_feature_0_choice_309 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_309 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_309 then
        transform_right_filter_feature_0_choice_310 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_310 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_310 then
        transform_right_filter_feature_0_choice_311 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_311 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_311 then
        transform_right_filter_feature_0_choice_312 := ((transform_right_filter_column_3_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_312 := ((transform_right_filter_column_3_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_313 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_313 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_314 := transform_right_filter_feature_0_choice_313;
      else
        transform_right_filter_feature_0_choice_314 := ((transform_right_filter_column_3_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_314 then
        transform_right_filter_feature_0_choice_315 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_315 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_315 then
        transform_right_filter_feature_0_choice_316 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_316 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_316 then
        transform_right_filter_feature_0_choice_317 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_317 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_317 then
        transform_right_filter_feature_0_choice_318 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_318 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_318 then
        transform_right_filter_feature_0_choice_319 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_319 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_319 then
        transform_right_filter_feature_0_choice_320 := ((transform_right_filter_column_3_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_320 := ((transform_right_filter_column_3_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_321 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_321 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_322 := transform_right_filter_feature_0_choice_321;
      else
        transform_right_filter_feature_0_choice_322 := ((transform_right_filter_column_3_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_322 then
        transform_right_filter_feature_0_choice_323 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_323 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_323 then
        transform_right_filter_feature_0_choice_324 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_324 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_324 then
        transform_right_filter_feature_0_choice_325 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_325 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_325 then
        transform_right_filter_feature_0_choice_326 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_326 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_326 then
        transform_right_filter_feature_0_choice_327 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_327 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_327 then
        transform_right_filter_feature_0_choice_328 := ((transform_right_filter_column_3_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_328 := ((transform_right_filter_column_3_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_329 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_329 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_330 := transform_right_filter_feature_0_choice_329;
      else
        transform_right_filter_feature_0_choice_330 := ((transform_right_filter_column_2_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_330 then
        transform_right_filter_feature_0_choice_331 := (not (((transform_right_filter_column_2_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_331 := (not (((transform_right_filter_column_2_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_331 then
        transform_right_filter_feature_0_choice_332 := (not (((transform_right_filter_column_2_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_332 := (not (((transform_right_filter_column_2_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_332 then
        transform_right_filter_feature_0_choice_333 := (not (((transform_right_filter_column_2_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_333 := (not (((transform_right_filter_column_2_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_333 then
        transform_right_filter_feature_0_choice_334 := (not (((transform_right_filter_column_2_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_334 := (not (((transform_right_filter_column_2_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_334 then
        transform_right_filter_feature_0_choice_335 := (not (((transform_right_filter_column_2_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_335 := (not (((transform_right_filter_column_2_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_335 then
        transform_right_filter_feature_0_choice_336 := ((transform_right_filter_column_2_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_336 := ((transform_right_filter_column_2_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_337 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_337 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_338 := transform_right_filter_feature_0_choice_337;
      else
        transform_right_filter_feature_0_choice_338 := ((transform_right_filter_column_2_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_338 then
        transform_right_filter_feature_0_choice_339 := (not (((transform_right_filter_column_2_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_339 := (not (((transform_right_filter_column_2_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_339 then
        transform_right_filter_feature_0_choice_340 := (not (((transform_right_filter_column_2_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_340 := (not (((transform_right_filter_column_2_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_340 then
        transform_right_filter_feature_0_choice_341 := (not (((transform_right_filter_column_2_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_341 := (not (((transform_right_filter_column_2_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_341 then
        transform_right_filter_feature_0_choice_342 := (not (((transform_right_filter_column_2_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_342 := (not (((transform_right_filter_column_2_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_342 then
        transform_right_filter_feature_0_choice_343 := (not (((transform_right_filter_column_2_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_343 := (not (((transform_right_filter_column_2_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_343 then
        transform_right_filter_feature_0_choice_344 := ((transform_right_filter_column_2_6 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_344 := ((transform_right_filter_column_2_6 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_345 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_345 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_346 := transform_right_filter_feature_0_choice_345;
      else
        transform_right_filter_feature_0_choice_346 := ((transform_right_filter_column_2_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_346 then
        transform_right_filter_feature_0_choice_347 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_347 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_347 then
        transform_right_filter_feature_0_choice_348 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_348 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_348 then
        transform_right_filter_feature_0_choice_349 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_349 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_349 then
        transform_right_filter_feature_0_choice_350 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_350 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_350 then
        transform_right_filter_feature_0_choice_351 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_351 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_351 then
        transform_right_filter_feature_0_choice_352 := ((transform_right_filter_column_2_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_352 := ((transform_right_filter_column_2_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_353 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_353 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_354 := transform_right_filter_feature_0_choice_353;
      else
        transform_right_filter_feature_0_choice_354 := ((transform_right_filter_column_2_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_354 then
        transform_right_filter_feature_0_choice_355 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_355 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_355 then
        transform_right_filter_feature_0_choice_356 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_356 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_356 then
        transform_right_filter_feature_0_choice_357 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_357 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_357 then
        transform_right_filter_feature_0_choice_358 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_358 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_358 then
        transform_right_filter_feature_0_choice_359 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_359 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_359 then
        transform_right_filter_feature_0_choice_360 := ((transform_right_filter_column_2_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_360 := ((transform_right_filter_column_2_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_361 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_361 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_362 := transform_right_filter_feature_0_choice_361;
      else
        transform_right_filter_feature_0_choice_362 := ((transform_right_filter_column_2_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_362 then
        transform_right_filter_feature_0_choice_363 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_363 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_363 then
        transform_right_filter_feature_0_choice_364 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_364 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_364 then
        transform_right_filter_feature_0_choice_365 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_365 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_365 then
        transform_right_filter_feature_0_choice_366 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_366 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_366 then
        transform_right_filter_feature_0_choice_367 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_367 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_367 then
        transform_right_filter_feature_0_choice_368 := ((transform_right_filter_column_2_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_368 := ((transform_right_filter_column_2_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_369 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_369 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_370 := transform_right_filter_feature_0_choice_369;
      else
        transform_right_filter_feature_0_choice_370 := ((transform_right_filter_column_2_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_370 then
        transform_right_filter_feature_0_choice_371 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_371 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_371 then
        transform_right_filter_feature_0_choice_372 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_372 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_372 then
        transform_right_filter_feature_0_choice_373 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_373 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_373 then
        transform_right_filter_feature_0_choice_374 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_374 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_374 then
        transform_right_filter_feature_0_choice_375 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_375 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_375 then
        transform_right_filter_feature_0_choice_376 := ((transform_right_filter_column_2_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_376 := ((transform_right_filter_column_2_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_377 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_377 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_378 := transform_right_filter_feature_0_choice_377;
      else
        transform_right_filter_feature_0_choice_378 := ((transform_right_filter_column_2_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_378 then
        transform_right_filter_feature_0_choice_379 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_379 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_379 then
        transform_right_filter_feature_0_choice_380 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_380 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_380 then
        transform_right_filter_feature_0_choice_381 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_381 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_381 then
        transform_right_filter_feature_0_choice_382 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_382 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_382 then
        transform_right_filter_feature_0_choice_383 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_383 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_383 then
        transform_right_filter_feature_0_choice_384 := ((transform_right_filter_column_2_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_384 := ((transform_right_filter_column_2_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_385 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_385 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_386 := transform_right_filter_feature_0_choice_385;
      else
        transform_right_filter_feature_0_choice_386 := ((transform_right_filter_column_1_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_386 then
        transform_right_filter_feature_0_choice_387 := (not (((transform_right_filter_column_1_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_387 := (not (((transform_right_filter_column_1_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_387 then
        transform_right_filter_feature_0_choice_388 := (not (((transform_right_filter_column_1_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_388 := (not (((transform_right_filter_column_1_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_388 then
        transform_right_filter_feature_0_choice_389 := (not (((transform_right_filter_column_1_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_389 := (not (((transform_right_filter_column_1_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_389 then
        transform_right_filter_feature_0_choice_390 := (not (((transform_right_filter_column_1_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_390 := (not (((transform_right_filter_column_1_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_390 then
        transform_right_filter_feature_0_choice_391 := (not (((transform_right_filter_column_1_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_391 := (not (((transform_right_filter_column_1_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_391 then
        transform_right_filter_feature_0_choice_392 := ((transform_right_filter_column_1_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_392 := ((transform_right_filter_column_1_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_393 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_393 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_394 := transform_right_filter_feature_0_choice_393;
      else
        transform_right_filter_feature_0_choice_394 := ((transform_right_filter_column_1_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_394 then
        transform_right_filter_feature_0_choice_395 := (not (((transform_right_filter_column_1_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_395 := (not (((transform_right_filter_column_1_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_395 then
        transform_right_filter_feature_0_choice_396 := (not (((transform_right_filter_column_1_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_396 := (not (((transform_right_filter_column_1_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_396 then
        transform_right_filter_feature_0_choice_397 := (not (((transform_right_filter_column_1_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_397 := (not (((transform_right_filter_column_1_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_397 then
        transform_right_filter_feature_0_choice_398 := (not (((transform_right_filter_column_1_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_398 := (not (((transform_right_filter_column_1_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_398 then
        transform_right_filter_feature_0_choice_399 := (not (((transform_right_filter_column_1_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_399 := (not (((transform_right_filter_column_1_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_399 then
        transform_right_filter_feature_0_choice_400 := ((transform_right_filter_column_1_6 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_400 := ((transform_right_filter_column_1_6 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_401 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_401 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_402 := transform_right_filter_feature_0_choice_401;
      else
        transform_right_filter_feature_0_choice_402 := ((transform_right_filter_column_1_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_402 then
        transform_right_filter_feature_0_choice_403 := (not (((transform_right_filter_column_1_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_403 := (not (((transform_right_filter_column_1_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_403 then
        transform_right_filter_feature_0_choice_404 := (not (((transform_right_filter_column_1_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_404 := (not (((transform_right_filter_column_1_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_404 then
        transform_right_filter_feature_0_choice_405 := (not (((transform_right_filter_column_1_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_405 := (not (((transform_right_filter_column_1_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_405 then
        transform_right_filter_feature_0_choice_406 := (not (((transform_right_filter_column_1_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_406 := (not (((transform_right_filter_column_1_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_406 then
        transform_right_filter_feature_0_choice_407 := (not (((transform_right_filter_column_1_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_407 := (not (((transform_right_filter_column_1_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_407 then
        transform_right_filter_feature_0_choice_408 := ((transform_right_filter_column_1_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_408 := ((transform_right_filter_column_1_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_409 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_409 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_410 := transform_right_filter_feature_0_choice_409;
      else
        transform_right_filter_feature_0_choice_410 := ((transform_right_filter_column_1_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_410 then
        transform_right_filter_feature_0_choice_411 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_411 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_411 then
        transform_right_filter_feature_0_choice_412 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_412 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_412 then
        transform_right_filter_feature_0_choice_413 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_413 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_413 then
        transform_right_filter_feature_0_choice_414 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_414 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_414 then
        transform_right_filter_feature_0_choice_415 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_415 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_415 then
        transform_right_filter_feature_0_choice_416 := ((transform_right_filter_column_1_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_416 := ((transform_right_filter_column_1_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_417 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_417 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_418 := transform_right_filter_feature_0_choice_417;
      else
        transform_right_filter_feature_0_choice_418 := ((transform_right_filter_column_1_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_418 then
        transform_right_filter_feature_0_choice_419 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_419 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_419 then
        transform_right_filter_feature_0_choice_420 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_420 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_420 then
        transform_right_filter_feature_0_choice_421 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_421 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_421 then
        transform_right_filter_feature_0_choice_422 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_422 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_422 then
        transform_right_filter_feature_0_choice_423 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_423 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_423 then
        transform_right_filter_feature_0_choice_424 := ((transform_right_filter_column_1_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_424 := ((transform_right_filter_column_1_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_425 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_425 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_426 := transform_right_filter_feature_0_choice_425;
      else
        transform_right_filter_feature_0_choice_426 := ((transform_right_filter_column_1_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_426 then
        transform_right_filter_feature_0_choice_427 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_427 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_427 then
        transform_right_filter_feature_0_choice_428 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_428 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_428 then
        transform_right_filter_feature_0_choice_429 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_429 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_429 then
        transform_right_filter_feature_0_choice_430 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_430 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_430 then
        transform_right_filter_feature_0_choice_431 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_431 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_431 then
        transform_right_filter_feature_0_choice_432 := ((transform_right_filter_column_1_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_432 := ((transform_right_filter_column_1_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_433 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_433 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_434 := transform_right_filter_feature_0_choice_433;
      else
        transform_right_filter_feature_0_choice_434 := ((transform_right_filter_column_1_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_434 then
        transform_right_filter_feature_0_choice_435 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_435 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_435 then
        transform_right_filter_feature_0_choice_436 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_436 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_436 then
        transform_right_filter_feature_0_choice_437 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_437 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_437 then
        transform_right_filter_feature_0_choice_438 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_438 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_438 then
        transform_right_filter_feature_0_choice_439 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_439 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_439 then
        transform_right_filter_feature_0_choice_440 := ((transform_right_filter_column_1_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_440 := ((transform_right_filter_column_1_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_5 mod 2) = 1 then
        transform_right_filter_feature_0_choice_441 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_441 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_5 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_442 := transform_right_filter_feature_0_choice_441;
      else
        transform_right_filter_feature_0_choice_442 := ((transform_right_filter_column_0_5 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_442 then
        transform_right_filter_feature_0_choice_443 := (not (((transform_right_filter_column_0_5 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_443 := (not (((transform_right_filter_column_0_5 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_443 then
        transform_right_filter_feature_0_choice_444 := (not (((transform_right_filter_column_0_5 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_444 := (not (((transform_right_filter_column_0_5 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_444 then
        transform_right_filter_feature_0_choice_445 := (not (((transform_right_filter_column_0_5 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_445 := (not (((transform_right_filter_column_0_5 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_445 then
        transform_right_filter_feature_0_choice_446 := (not (((transform_right_filter_column_0_5 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_446 := (not (((transform_right_filter_column_0_5 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_446 then
        transform_right_filter_feature_0_choice_447 := (not (((transform_right_filter_column_0_5 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_447 := (not (((transform_right_filter_column_0_5 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_447 then
        transform_right_filter_feature_0_choice_448 := ((transform_right_filter_column_0_5 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_448 := ((transform_right_filter_column_0_5 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_6 mod 2) = 1 then
        transform_right_filter_feature_0_choice_449 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_449 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_6 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_450 := transform_right_filter_feature_0_choice_449;
      else
        transform_right_filter_feature_0_choice_450 := ((transform_right_filter_column_0_6 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_450 then
        transform_right_filter_feature_0_choice_451 := (not (((transform_right_filter_column_0_6 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_451 := (not (((transform_right_filter_column_0_6 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_451 then
        transform_right_filter_feature_0_choice_452 := (not (((transform_right_filter_column_0_6 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_452 := (not (((transform_right_filter_column_0_6 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_452 then
        transform_right_filter_feature_0_choice_453 := (not (((transform_right_filter_column_0_6 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_453 := (not (((transform_right_filter_column_0_6 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_453 then
        transform_right_filter_feature_0_choice_454 := (not (((transform_right_filter_column_0_6 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_454 := (not (((transform_right_filter_column_0_6 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_454 then
        transform_right_filter_feature_0_choice_455 := (not (((transform_right_filter_column_0_6 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_455 := (not (((transform_right_filter_column_0_6 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_455 then
        transform_right_filter_feature_0_choice_456 := ((transform_right_filter_column_0_6 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_456 := ((transform_right_filter_column_0_6 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_457 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_457 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_458 := transform_right_filter_feature_0_choice_457;
      else
        transform_right_filter_feature_0_choice_458 := ((transform_right_filter_column_0_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_458 then
        transform_right_filter_feature_0_choice_459 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_459 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_459 then
        transform_right_filter_feature_0_choice_460 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_460 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_460 then
        transform_right_filter_feature_0_choice_461 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_461 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_461 then
        transform_right_filter_feature_0_choice_462 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_462 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_462 then
        transform_right_filter_feature_0_choice_463 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_463 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_463 then
        transform_right_filter_feature_0_choice_464 := ((transform_right_filter_column_0_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_464 := ((transform_right_filter_column_0_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_465 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_465 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_466 := transform_right_filter_feature_0_choice_465;
      else
        transform_right_filter_feature_0_choice_466 := ((transform_right_filter_column_0_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_466 then
        transform_right_filter_feature_0_choice_467 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_467 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_467 then
        transform_right_filter_feature_0_choice_468 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_468 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_468 then
        transform_right_filter_feature_0_choice_469 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_469 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_469 then
        transform_right_filter_feature_0_choice_470 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_470 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_470 then
        transform_right_filter_feature_0_choice_471 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_471 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_471 then
        transform_right_filter_feature_0_choice_472 := ((transform_right_filter_column_0_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_472 := ((transform_right_filter_column_0_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_473 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_473 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_474 := transform_right_filter_feature_0_choice_473;
      else
        transform_right_filter_feature_0_choice_474 := ((transform_right_filter_column_0_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_474 then
        transform_right_filter_feature_0_choice_475 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_475 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_475 then
        transform_right_filter_feature_0_choice_476 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_476 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_476 then
        transform_right_filter_feature_0_choice_477 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_477 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_477 then
        transform_right_filter_feature_0_choice_478 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_478 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_478 then
        transform_right_filter_feature_0_choice_479 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_479 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_479 then
        transform_right_filter_feature_0_choice_480 := ((transform_right_filter_column_0_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_480 := ((transform_right_filter_column_0_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_481 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_481 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_482 := transform_right_filter_feature_0_choice_481;
      else
        transform_right_filter_feature_0_choice_482 := ((transform_right_filter_column_0_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_482 then
        transform_right_filter_feature_0_choice_483 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_483 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_483 then
        transform_right_filter_feature_0_choice_484 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_484 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_484 then
        transform_right_filter_feature_0_choice_485 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_485 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_485 then
        transform_right_filter_feature_0_choice_486 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_486 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_486 then
        transform_right_filter_feature_0_choice_487 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_487 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_487 then
        transform_right_filter_feature_0_choice_488 := ((transform_right_filter_column_0_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_488 := ((transform_right_filter_column_0_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_3 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_489 := not (((transform_right_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_right_filter_feature_0_choice_489 := (transform_right_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value then
        transform_right_filter_feature_0_choice_490 := ((transform_right_filter_column_4_3 mod 2) = 1) or (not
          (((transform_right_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_right_filter_column_0_0 mod 2) =
          1));
      else
        transform_right_filter_feature_0_choice_490 := transform_right_filter_feature_0_choice_489;
      end if;
      transform_right_filter_feature_0_value_7 := ((transform_right_filter_column_0_0 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_490 then
        transform_right_filter_feature_0_choice_491 := (not transform_right_filter_feature_0_value_2) and
          transform_right_filter_feature_0_value_7;
      else
        transform_right_filter_feature_0_choice_491 := (not transform_right_filter_feature_0_value_2) or
          transform_right_filter_feature_0_value_7;
      end if;
      transform_right_filter_feature_0_value_8 := ((transform_right_filter_column_0_0 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_491 then
        transform_right_filter_feature_0_choice_492 := (not transform_right_filter_feature_0_value_3) or
          transform_right_filter_feature_0_value_8;
      else
        transform_right_filter_feature_0_choice_492 := (not transform_right_filter_feature_0_value_3) and
          transform_right_filter_feature_0_value_8;
      end if;
      transform_right_filter_feature_0_value_9 := ((transform_right_filter_column_0_0 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_492 then
        transform_right_filter_feature_0_choice_493 := (not transform_right_filter_feature_0_value_4) or
          transform_right_filter_feature_0_value_9;
      else
        transform_right_filter_feature_0_choice_493 := (not transform_right_filter_feature_0_value_4) and
          transform_right_filter_feature_0_value_9;
      end if;
      transform_right_filter_feature_0_value_10 := ((transform_right_filter_column_0_0 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_493 then
        transform_right_filter_feature_0_choice_494 := (not transform_right_filter_feature_0_value_5) or
          transform_right_filter_feature_0_value_10;
      else
        transform_right_filter_feature_0_choice_494 := (not transform_right_filter_feature_0_value_5) and
          transform_right_filter_feature_0_value_10;
      end if;
      transform_right_filter_feature_0_value_11 := ((transform_right_filter_column_0_0 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_494 then
        transform_right_filter_feature_0_choice_495 := (not transform_right_filter_feature_0_value_6) or
          transform_right_filter_feature_0_value_11;
      else
        transform_right_filter_feature_0_choice_495 := (not transform_right_filter_feature_0_value_6) and
          transform_right_filter_feature_0_value_11;
      end if;
      if transform_right_filter_feature_0_choice_495 then
        transform_right_filter_feature_0_choice_496 := (not ((transform_right_filter_column_4_3 / 128) = 1)) or
          ((transform_right_filter_column_0_0 / 128) = 1);
      else
        transform_right_filter_feature_0_choice_496 := (not ((transform_right_filter_column_4_3 / 128) = 1)) and
          ((transform_right_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_right_filter_feature_0_choice_497 := (as_number(transform_right_filter_feature_0_choice_448) * 32) +
          (as_number(transform_right_filter_feature_0_choice_456) * 64) +
          (as_number(transform_right_filter_feature_0_choice_464) * 16) +
          (as_number(transform_right_filter_feature_0_choice_472) * 8) +
          (as_number(transform_right_filter_feature_0_choice_480) * 4) +
          (as_number(transform_right_filter_feature_0_choice_488) * 2) +
          as_number(transform_right_filter_feature_0_choice_496);
      else
        transform_right_filter_feature_0_choice_497 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_right_filter_feature_0_choice_498 := (as_number(transform_right_filter_feature_0_choice_392) * 4096)
          + (as_number(transform_right_filter_feature_0_choice_400) * 8192) +
          (as_number(transform_right_filter_feature_0_choice_408) * 2048) +
          (as_number(transform_right_filter_feature_0_choice_416) * 1024) +
          (as_number(transform_right_filter_feature_0_choice_424) * 512) +
          (as_number(transform_right_filter_feature_0_choice_432) * 256) +
          (as_number(transform_right_filter_feature_0_choice_440) * 128) + transform_right_filter_feature_0_choice_497;
      else
        transform_right_filter_feature_0_choice_498 := transform_right_filter_feature_0_choice_497;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_right_filter_feature_0_choice_499 := (as_number(transform_right_filter_feature_0_choice_336) *
          524288) + (as_number(transform_right_filter_feature_0_choice_344) * 1048576) +
          (as_number(transform_right_filter_feature_0_choice_352) * 262144) +
          (as_number(transform_right_filter_feature_0_choice_360) * 131072) +
          (as_number(transform_right_filter_feature_0_choice_368) * 65536) +
          (as_number(transform_right_filter_feature_0_choice_376) * 32768) +
          (as_number(transform_right_filter_feature_0_choice_384) * 16384) +
          transform_right_filter_feature_0_choice_498;
      else
        transform_right_filter_feature_0_choice_499 := transform_right_filter_feature_0_choice_498;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_right_filter_feature_0_choice_500 := (as_number(transform_right_filter_feature_0_choice_280) *
          67108864) + (as_number(transform_right_filter_feature_0_choice_288) * 134217728) +
          (as_number(transform_right_filter_feature_0_choice_296) * 33554432) +
          (as_number(transform_right_filter_feature_0_choice_304) * 16777216) +
          (as_number(transform_right_filter_feature_0_choice_312) * 8388608) +
          (as_number(transform_right_filter_feature_0_choice_320) * 4194304) +
          (as_number(transform_right_filter_feature_0_choice_328) * 2097152) +
          transform_right_filter_feature_0_choice_499;
      else
        transform_right_filter_feature_0_choice_500 := transform_right_filter_feature_0_choice_499;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_0_choice_501 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_240), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_248), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_256), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_264), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_272), 1) &
          to_unsigned(transform_right_filter_feature_0_choice_500, 28);
      else
        transform_right_filter_feature_0_choice_501 := to_unsigned(transform_right_filter_feature_0_choice_500, 33);
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_right_filter_feature_0_choice_502 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_224), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_216), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_208), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_200), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_192), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_184), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_176), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_232), 1) &
          transform_right_filter_feature_0_choice_501(32 downto 0);
      else
        transform_right_filter_feature_0_choice_502 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_232), 8) &
          transform_right_filter_feature_0_choice_501(32 downto 0);
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_right_filter_feature_0_choice_503 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_168), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_160), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_152), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_144), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_136), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_128), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_120), 1) &
          transform_right_filter_feature_0_choice_502(40 downto 0);
      else
        transform_right_filter_feature_0_choice_503 := resize(transform_right_filter_feature_0_choice_502, 48);
      end if;
      if transform_filtering_0_column_inside_7 then
        transform_right_filter_feature_0_choice_504 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_112), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_104), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_96), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_88), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_80), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_72), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_64), 1) &
          transform_right_filter_feature_0_choice_503(47 downto 0);
      else
        transform_right_filter_feature_0_choice_504 := resize(transform_right_filter_feature_0_choice_503, 55);
      end if;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_words_1 <= to_integer(transform_left_rows_read_words_1);
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_words_1 <= to_integer(transform_right_rows_read_words_1);
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= (((((transform_counter_group / 2) + 32765) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 12;
      transform_read_row_inside_1 <= transform_counter_group >= 5;
      transform_read_row_inside_2 <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
        (transform_counter_group mod 4)) < 12;
      transform_read_row_inside_3 <= (transform_counter_group >= 3) and (transform_counter_group < 15);
      transform_read_row_inside_4 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 12;
      transform_read_row_inside_5 <= (transform_counter_group >= 1) and (transform_counter_group < 13);
      transform_read_row_inside_6 <= (not ((transform_counter_group / 8) = 1)) or (not (((transform_counter_group / 4)
        mod 2) = 1));
      transform_read_column_inside_0 <= transform_read_column_inside_0_any;
      transform_read_column_inside_2 <= (not transform_read_column_inside_1_value) or ((transform_counter_column / 16)
        = 1) or transform_read_column_inside_0_value or transform_read_column_inside_0_value_2;
      transform_read_column_inside_3 <= ((transform_counter_column mod 4) /= 3) or ((transform_counter_column / 16) =
        1) or transform_read_column_inside_0_value or transform_read_column_inside_0_value_2;
      transform_read_column_inside_4 <= true;
      transform_read_column_inside_5 <= (not transform_read_column_inside_1_all) or (not
        transform_read_column_inside_0_value_2);
      transform_read_column_inside_6 <= transform_read_column_inside_1_value or ((transform_counter_column / 16) = 1)
        or transform_read_column_inside_0_value or (not transform_read_column_inside_0_value_2);
      transform_read_column_inside_7 <= ((transform_counter_column mod 4) = 3) or ((transform_counter_column / 16) = 1)
        or transform_read_column_inside_0_value or (not transform_read_column_inside_0_value_2);
      transform_read_column_inside_8 <= ((transform_counter_column / 16) = 1) or transform_read_column_inside_0_value
        or (not transform_read_column_inside_0_value_2);
      transform_read_start_of_frame <= (transform_counter_column = 4) and (transform_counter_group = 3);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_1 <= transform_read_row_inside_1;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
      transform_ready_row_inside_3 <= transform_read_row_inside_3;
      transform_ready_row_inside_4 <= transform_read_row_inside_4;
      transform_ready_row_inside_5 <= transform_read_row_inside_5;
      transform_ready_row_inside_6 <= transform_read_row_inside_6;
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
      transform_left_column_4 <= transform_left_rows_ready_words_1 mod 256;
      transform_left_column_5 <= transform_left_rows_ready_words_1 / 256;
      transform_left_column_6 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column_1 <= to_integer(transform_right_rows_ready_words_0(15 downto 8));
      transform_right_column_2 <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column_3 <= to_integer(transform_right_rows_ready_words_0(31 downto 24));
      transform_right_column_4 <= transform_right_rows_ready_words_1 mod 256;
      transform_right_column_5 <= transform_right_rows_ready_words_1 / 256;
      transform_right_column_6 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_1 <= transform_ready_row_inside_1;
      transform_columns_row_inside_2 <= transform_ready_row_inside_2;
      transform_columns_row_inside_3 <= transform_ready_row_inside_3;
      transform_columns_row_inside_4 <= transform_ready_row_inside_4;
      transform_columns_row_inside_5 <= transform_ready_row_inside_5;
      transform_columns_row_inside_6 <= transform_ready_row_inside_6;
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
        transform_counter_group <= transform_counter_group_choice_4;
      end if;
      if transform_read_column_inside_1_all then
        transform_read_column_inside_1 <= transform_read_column_inside_1_choice;
      else
        transform_read_column_inside_1 <= transform_read_column_inside_0_any;
      end if;
      if transform_filtering_0_column_inside_8 then
        transform_left_filter_feature_0 <= to_unsigned(as_number(transform_left_filter_feature_0_choice_56), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_48), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_40), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_32), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_24), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_16), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_8), 1) &
          transform_left_filter_feature_0_choice_504(54 downto 0);
        transform_right_filter_feature_0 <= to_unsigned(as_number(transform_right_filter_feature_0_choice_56), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_48), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_40), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_32), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_24), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_16), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_8), 1) &
          transform_right_filter_feature_0_choice_504(54 downto 0);
      else
        transform_left_filter_feature_0 <= resize(transform_left_filter_feature_0_choice_504, 62);
        transform_right_filter_feature_0 <= resize(transform_right_filter_feature_0_choice_504, 62);
      end if;
      if transform_counter_group_is_equal then
        transform_counter_next_frame_choice := transform_counter_next_frame and ((transform_counter_group mod 2) = 1);
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_is_equal_2 then
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
        transform_left_rows_write_words_0 <= to_unsigned((transform_left_rows_ready_words_1 mod 256), 8) &
          transform_left_rows_ready_words_0(31 downto 8);
        transform_left_rows_write_words_1 <= (transform_left_rows_ready_newest_0 * 256) +
          (transform_left_rows_ready_words_1 / 256);
        transform_right_rows_write_words_0 <= to_unsigned((transform_right_rows_ready_words_1 mod 256), 8) &
          transform_right_rows_ready_words_0(31 downto 8);
        transform_right_rows_write_words_1 <= (transform_right_rows_ready_newest_0 * 256) +
          (transform_right_rows_ready_words_1 / 256);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_columns_valid then
        transform_left_filter_column_1_0 <= transform_left_filter_column_0_0;
        transform_left_filter_column_1_1 <= transform_left_filter_column_0_1;
        transform_left_filter_column_1_2 <= transform_left_filter_column_0_2;
        transform_left_filter_column_1_3 <= transform_left_filter_column_0_3;
        transform_left_filter_column_1_4 <= transform_left_filter_column_0_4;
        transform_left_filter_column_1_5 <= transform_left_filter_column_0_5;
        transform_left_filter_column_1_6 <= transform_left_filter_column_0_6;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_left_filter_column_2_1 <= transform_left_filter_column_1_1;
        transform_left_filter_column_2_2 <= transform_left_filter_column_1_2;
        transform_left_filter_column_2_3 <= transform_left_filter_column_1_3;
        transform_left_filter_column_2_4 <= transform_left_filter_column_1_4;
        transform_left_filter_column_2_5 <= transform_left_filter_column_1_5;
        transform_left_filter_column_2_6 <= transform_left_filter_column_1_6;
        transform_left_filter_column_3_0 <= transform_left_filter_column_2_0;
        transform_left_filter_column_3_1 <= transform_left_filter_column_2_1;
        transform_left_filter_column_3_2 <= transform_left_filter_column_2_2;
        transform_left_filter_column_3_3 <= transform_left_filter_column_2_3;
        transform_left_filter_column_3_4 <= transform_left_filter_column_2_4;
        transform_left_filter_column_3_5 <= transform_left_filter_column_2_5;
        transform_left_filter_column_3_6 <= transform_left_filter_column_2_6;
        transform_left_filter_column_4_0 <= transform_left_filter_column_3_0;
        transform_left_filter_column_4_1 <= transform_left_filter_column_3_1;
        transform_left_filter_column_4_2 <= transform_left_filter_column_3_2;
        transform_left_filter_column_4_3 <= transform_left_filter_column_3_3;
        transform_left_filter_column_4_4 <= transform_left_filter_column_3_4;
        transform_left_filter_column_4_5 <= transform_left_filter_column_3_5;
        transform_left_filter_column_4_6 <= transform_left_filter_column_3_6;
        transform_left_filter_column_5_0 <= transform_left_filter_column_4_0;
        transform_left_filter_column_5_1 <= transform_left_filter_column_4_1;
        transform_left_filter_column_5_2 <= transform_left_filter_column_4_2;
        transform_left_filter_column_5_3 <= transform_left_filter_column_4_3;
        transform_left_filter_column_5_4 <= transform_left_filter_column_4_4;
        transform_left_filter_column_5_5 <= transform_left_filter_column_4_5;
        transform_left_filter_column_5_6 <= transform_left_filter_column_4_6;
        transform_left_filter_column_6_0 <= transform_left_filter_column_5_0;
        transform_left_filter_column_6_1 <= transform_left_filter_column_5_1;
        transform_left_filter_column_6_2 <= transform_left_filter_column_5_2;
        transform_left_filter_column_6_3 <= transform_left_filter_column_5_3;
        transform_left_filter_column_6_4 <= transform_left_filter_column_5_4;
        transform_left_filter_column_6_5 <= transform_left_filter_column_5_5;
        transform_left_filter_column_6_6 <= transform_left_filter_column_5_6;
        transform_left_filter_column_7_0 <= transform_left_filter_column_6_0;
        transform_left_filter_column_7_1 <= transform_left_filter_column_6_1;
        transform_left_filter_column_7_2 <= transform_left_filter_column_6_2;
        transform_left_filter_column_7_3 <= transform_left_filter_column_6_3;
        transform_left_filter_column_7_4 <= transform_left_filter_column_6_4;
        transform_left_filter_column_7_5 <= transform_left_filter_column_6_5;
        transform_left_filter_column_7_6 <= transform_left_filter_column_6_6;
        transform_left_filter_column_8_0 <= transform_left_filter_column_7_0;
        transform_left_filter_column_8_1 <= transform_left_filter_column_7_1;
        transform_left_filter_column_8_2 <= transform_left_filter_column_7_2;
        transform_left_filter_column_8_3 <= transform_left_filter_column_7_3;
        transform_left_filter_column_8_4 <= transform_left_filter_column_7_4;
        transform_left_filter_column_8_5 <= transform_left_filter_column_7_5;
        transform_left_filter_column_8_6 <= transform_left_filter_column_7_6;
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_1_1 <= transform_right_filter_column_0_1;
        transform_right_filter_column_1_2 <= transform_right_filter_column_0_2;
        transform_right_filter_column_1_3 <= transform_right_filter_column_0_3;
        transform_right_filter_column_1_4 <= transform_right_filter_column_0_4;
        transform_right_filter_column_1_5 <= transform_right_filter_column_0_5;
        transform_right_filter_column_1_6 <= transform_right_filter_column_0_6;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
        transform_right_filter_column_2_1 <= transform_right_filter_column_1_1;
        transform_right_filter_column_2_2 <= transform_right_filter_column_1_2;
        transform_right_filter_column_2_3 <= transform_right_filter_column_1_3;
        transform_right_filter_column_2_4 <= transform_right_filter_column_1_4;
        transform_right_filter_column_2_5 <= transform_right_filter_column_1_5;
        transform_right_filter_column_2_6 <= transform_right_filter_column_1_6;
        transform_right_filter_column_3_0 <= transform_right_filter_column_2_0;
        transform_right_filter_column_3_1 <= transform_right_filter_column_2_1;
        transform_right_filter_column_3_2 <= transform_right_filter_column_2_2;
        transform_right_filter_column_3_3 <= transform_right_filter_column_2_3;
        transform_right_filter_column_3_4 <= transform_right_filter_column_2_4;
        transform_right_filter_column_3_5 <= transform_right_filter_column_2_5;
        transform_right_filter_column_3_6 <= transform_right_filter_column_2_6;
        transform_right_filter_column_4_0 <= transform_right_filter_column_3_0;
        transform_right_filter_column_4_1 <= transform_right_filter_column_3_1;
        transform_right_filter_column_4_2 <= transform_right_filter_column_3_2;
        transform_right_filter_column_4_3 <= transform_right_filter_column_3_3;
        transform_right_filter_column_4_4 <= transform_right_filter_column_3_4;
        transform_right_filter_column_4_5 <= transform_right_filter_column_3_5;
        transform_right_filter_column_4_6 <= transform_right_filter_column_3_6;
        transform_right_filter_column_5_0 <= transform_right_filter_column_4_0;
        transform_right_filter_column_5_1 <= transform_right_filter_column_4_1;
        transform_right_filter_column_5_2 <= transform_right_filter_column_4_2;
        transform_right_filter_column_5_3 <= transform_right_filter_column_4_3;
        transform_right_filter_column_5_4 <= transform_right_filter_column_4_4;
        transform_right_filter_column_5_5 <= transform_right_filter_column_4_5;
        transform_right_filter_column_5_6 <= transform_right_filter_column_4_6;
        transform_right_filter_column_6_0 <= transform_right_filter_column_5_0;
        transform_right_filter_column_6_1 <= transform_right_filter_column_5_1;
        transform_right_filter_column_6_2 <= transform_right_filter_column_5_2;
        transform_right_filter_column_6_3 <= transform_right_filter_column_5_3;
        transform_right_filter_column_6_4 <= transform_right_filter_column_5_4;
        transform_right_filter_column_6_5 <= transform_right_filter_column_5_5;
        transform_right_filter_column_6_6 <= transform_right_filter_column_5_6;
        transform_right_filter_column_7_0 <= transform_right_filter_column_6_0;
        transform_right_filter_column_7_1 <= transform_right_filter_column_6_1;
        transform_right_filter_column_7_2 <= transform_right_filter_column_6_2;
        transform_right_filter_column_7_3 <= transform_right_filter_column_6_3;
        transform_right_filter_column_7_4 <= transform_right_filter_column_6_4;
        transform_right_filter_column_7_5 <= transform_right_filter_column_6_5;
        transform_right_filter_column_7_6 <= transform_right_filter_column_6_6;
        transform_right_filter_column_8_0 <= transform_right_filter_column_7_0;
        transform_right_filter_column_8_1 <= transform_right_filter_column_7_1;
        transform_right_filter_column_8_2 <= transform_right_filter_column_7_2;
        transform_right_filter_column_8_3 <= transform_right_filter_column_7_3;
        transform_right_filter_column_8_4 <= transform_right_filter_column_7_4;
        transform_right_filter_column_8_5 <= transform_right_filter_column_7_5;
        transform_right_filter_column_8_6 <= transform_right_filter_column_7_6;
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
        if transform_columns_row_inside_5 then
          transform_left_filter_column_0_5 <= transform_left_column_5;
          transform_right_filter_column_0_5 <= transform_right_column_5;
        else
          transform_left_filter_column_0_5 <= 0;
          transform_right_filter_column_0_5 <= 0;
        end if;
        if transform_columns_row_inside_6 then
          transform_left_filter_column_0_6 <= transform_left_column_6;
          transform_right_filter_column_0_6 <= transform_right_column_6;
        else
          transform_left_filter_column_0_6 <= 0;
          transform_right_filter_column_0_6 <= 0;
        end if;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 31;
      raster_place_group_is_equal_2 := raster_place_group = 11;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_is_equal_3 := (raster_place_group / 2) = 6;
      if raster_place_group_is_equal_3 then
        raster_place_group_choice_2 := raster_place_group_is_equal and transform_filtering_1_valid and (not
          ((raster_place_group mod 2) = 1));
      else
        raster_place_group_choice_2 := raster_place_group_is_equal and transform_filtering_1_valid;
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
        raster_place_next_frame_choice_3 := transform_filtering_1_valid;
      else
        raster_place_next_frame_choice_3 := transform_filtering_1_valid and (not transform_filtering_1_start_of_frame);
      end if;
      if raster_place_next_frame_choice_2 then
        raster_place_next_frame_choice_4 := raster_place_next_frame_choice_3;
      else
        raster_place_next_frame_choice_4 := raster_place_group_is_equal and raster_place_group_is_equal_2 and
          transform_filtering_1_valid and transform_filtering_1_start_of_frame;
      end if;
      raster_features_search_0 <= transform_left_filter_feature_0;
      raster_features_reference_0 <= transform_right_filter_feature_0;
      raster_features_valid <= transform_filtering_1_valid;
      raster_place_next_frame <= raster_place_next_frame_choice_4 or ((not transform_filtering_1_valid) and
        raster_place_next_frame);
      if transform_filtering_1_valid and transform_filtering_1_start_of_frame then
        raster_place_group <= raster_place_group_choice * 4;
      else
        raster_place_group <= raster_place_group_choice_4;
      end if;
      if transform_filtering_1_valid then
        if raster_place_group_is_equal or transform_filtering_1_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 32;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 4 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 8;
        end if;
      end if;
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 13;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 12;
      delay_row_inside_1 <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside_2 <= (not ((raster_place_group / 8) = 1)) or (not (((raster_place_group / 4) mod 2) = 1));
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= (raster_place_column / 4) = 0;
      delay_tag_output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and
        ((((((raster_place_column / 4) + 16383) mod 16384) * 4) + (raster_place_column mod 4)) < 27);
      delay_tag_start_of_frame <= (raster_place_column = 4) and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 30;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
      rows_search_rows_ready_words_1 <= rows_search_rows_read_words_1;
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_delayed_0;
      rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
      rows_reference_rows_ready_words_1 <= rows_reference_rows_read_words_1;
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_2 <= delay_row_inside_2;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_2 <= rows_read_inside_2;
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
        rows_search_0 <= to_unsigned(0, 62);
        rows_reference_0 <= to_unsigned(0, 62);
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= rows_search_rows_ready_words_1;
        rows_reference_1 <= rows_reference_rows_ready_words_1;
      else
        rows_search_1 <= to_unsigned(0, 62);
        rows_reference_1 <= to_unsigned(0, 62);
      end if;
      if rows_ready_inside_2 then
        rows_search_2 <= rows_search_rows_ready_newest_0;
        rows_reference_2 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_2 <= to_unsigned(0, 62);
        rows_reference_2 <= to_unsigned(0, 62);
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= rows_search_rows_ready_words_1;
        rows_search_rows_write_words_1 <= rows_search_rows_ready_newest_0;
        rows_reference_rows_write_words_0 <= rows_reference_rows_ready_words_1;
        rows_reference_rows_write_words_1 <= rows_reference_rows_ready_newest_0;
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
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
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
      slice0cost_pixels_first_0_0_count_14_value_2 := to_integer(slice0shift_reference_0(44 downto 44)) = 1;
      slice0cost_pixels_first_0_0_count_14_value_3 := to_integer(slice0shift_reference_0(43 downto 43)) = 1;
      slice0cost_pixels_first_0_0_count_15_value := to_integer(slice0shift_reference_0(45 downto 45)) = 1;
      slice0cost_pixels_first_0_0_count_15_value_2 := to_integer(slice0shift_reference_0(47 downto 47)) = 1;
      slice0cost_pixels_first_0_0_count_15_value_3 := to_integer(slice0shift_reference_0(46 downto 46)) = 1;
      slice0cost_pixels_first_0_0_count_16_value := to_integer(slice0shift_reference_0(48 downto 48)) = 1;
      slice0cost_pixels_first_0_0_count_16_value_2 := to_integer(slice0shift_reference_0(50 downto 50)) = 1;
      slice0cost_pixels_first_0_0_count_16_value_3 := to_integer(slice0shift_reference_0(49 downto 49)) = 1;
      slice0cost_pixels_first_0_0_count_17_value := to_integer(slice0shift_reference_0(51 downto 51)) = 1;
      slice0cost_pixels_first_0_0_count_17_value_2 := to_integer(slice0shift_reference_0(53 downto 53)) = 1;
      slice0cost_pixels_first_0_0_count_17_value_3 := to_integer(slice0shift_reference_0(52 downto 52)) = 1;
      slice0cost_pixels_first_0_0_count_18_value := to_integer(slice0shift_reference_0(54 downto 54)) = 1;
      slice0cost_pixels_first_0_0_count_18_value_2 := to_integer(slice0shift_reference_0(56 downto 56)) = 1;
      slice0cost_pixels_first_0_0_count_18_value_3 := to_integer(slice0shift_reference_0(55 downto 55)) = 1;
      slice0cost_pixels_first_0_0_count_19_value := to_integer(slice0shift_reference_0(57 downto 57)) = 1;
      slice0cost_pixels_first_0_0_count_19_value_2 := to_integer(slice0shift_reference_0(59 downto 59)) = 1;
      slice0cost_pixels_first_0_0_count_19_value_3 := to_integer(slice0shift_reference_0(58 downto 58)) = 1;
      slice0cost_pixels_first_0_0_count_20_value := to_integer(slice0shift_reference_0(60 downto 60)) = 1;
      slice0cost_pixels_first_1_0_count_0_value := to_integer(slice0shift_reference_1(2 downto 2)) = 1;
      slice0cost_pixels_first_1_0_count_0_value_2 := to_integer(slice0shift_reference_1(1 downto 1)) = 1;
      slice0cost_pixels_first_1_0_count_1_value := to_integer(slice0shift_reference_1(3 downto 3)) = 1;
      slice0cost_pixels_first_1_0_count_1_value_2 := to_integer(slice0shift_reference_1(5 downto 5)) = 1;
      slice0cost_pixels_first_1_0_count_1_value_3 := to_integer(slice0shift_reference_1(4 downto 4)) = 1;
      slice0cost_pixels_first_1_0_count_2_value := to_integer(slice0shift_reference_1(8 downto 8)) = 1;
      slice0cost_pixels_first_1_0_count_2_value_2 := to_integer(slice0shift_reference_1(6 downto 6)) = 1;
      slice0cost_pixels_first_1_0_count_3_value := to_integer(slice0shift_reference_1(9 downto 9)) = 1;
      slice0cost_pixels_first_1_0_count_3_value_2 := to_integer(slice0shift_reference_1(11 downto 11)) = 1;
      slice0cost_pixels_first_1_0_count_3_value_3 := to_integer(slice0shift_reference_1(10 downto 10)) = 1;
      slice0cost_pixels_first_1_0_count_4_value := to_integer(slice0shift_reference_1(12 downto 12)) = 1;
      slice0cost_pixels_first_1_0_count_4_value_2 := to_integer(slice0shift_reference_1(14 downto 14)) = 1;
      slice0cost_pixels_first_1_0_count_4_value_3 := to_integer(slice0shift_reference_1(13 downto 13)) = 1;
      slice0cost_pixels_first_1_0_count_5_value := to_integer(slice0shift_reference_1(15 downto 15)) = 1;
      slice0cost_pixels_first_1_0_count_5_value_2 := to_integer(slice0shift_reference_1(17 downto 17)) = 1;
      slice0cost_pixels_first_1_0_count_5_value_3 := to_integer(slice0shift_reference_1(16 downto 16)) = 1;
      slice0cost_pixels_first_1_0_count_6_value := to_integer(slice0shift_reference_1(18 downto 18)) = 1;
      slice0cost_pixels_first_1_0_count_6_value_2 := to_integer(slice0shift_reference_1(20 downto 20)) = 1;
      slice0cost_pixels_first_1_0_count_6_value_3 := to_integer(slice0shift_reference_1(19 downto 19)) = 1;
      slice0cost_pixels_first_1_0_count_7_value := to_integer(slice0shift_reference_1(21 downto 21)) = 1;
      slice0cost_pixels_first_1_0_count_7_value_2 := to_integer(slice0shift_reference_1(23 downto 23)) = 1;
      slice0cost_pixels_first_1_0_count_7_value_3 := to_integer(slice0shift_reference_1(22 downto 22)) = 1;
      slice0cost_pixels_first_1_0_count_8_value := to_integer(slice0shift_reference_1(24 downto 24)) = 1;
      slice0cost_pixels_first_1_0_count_8_value_2 := to_integer(slice0shift_reference_1(26 downto 26)) = 1;
      slice0cost_pixels_first_1_0_count_8_value_3 := to_integer(slice0shift_reference_1(25 downto 25)) = 1;
      slice0cost_pixels_first_1_0_count_9_value := to_integer(slice0shift_reference_1(27 downto 27)) = 1;
      slice0cost_pixels_first_1_0_count_9_value_2 := to_integer(slice0shift_reference_1(29 downto 29)) = 1;
      slice0cost_pixels_first_1_0_count_9_value_3 := to_integer(slice0shift_reference_1(28 downto 28)) = 1;
      slice0cost_pixels_first_1_0_count_10_value := to_integer(slice0shift_reference_1(30 downto 30)) = 1;
      slice0cost_pixels_first_1_0_count_10_value_2 := to_integer(slice0shift_reference_1(32 downto 32)) = 1;
      slice0cost_pixels_first_1_0_count_10_value_3 := to_integer(slice0shift_reference_1(31 downto 31)) = 1;
      slice0cost_pixels_first_1_0_count_11_value := to_integer(slice0shift_reference_1(33 downto 33)) = 1;
      slice0cost_pixels_first_1_0_count_11_value_2 := to_integer(slice0shift_reference_1(35 downto 35)) = 1;
      slice0cost_pixels_first_1_0_count_11_value_3 := to_integer(slice0shift_reference_1(34 downto 34)) = 1;
      slice0cost_pixels_first_1_0_count_12_value := to_integer(slice0shift_reference_1(36 downto 36)) = 1;
      slice0cost_pixels_first_1_0_count_12_value_2 := to_integer(slice0shift_reference_1(38 downto 38)) = 1;
      slice0cost_pixels_first_1_0_count_12_value_3 := to_integer(slice0shift_reference_1(37 downto 37)) = 1;
      slice0cost_pixels_first_1_0_count_13_value := to_integer(slice0shift_reference_1(39 downto 39)) = 1;
      slice0cost_pixels_first_1_0_count_13_value_2 := to_integer(slice0shift_reference_1(41 downto 41)) = 1;
      slice0cost_pixels_first_1_0_count_13_value_3 := to_integer(slice0shift_reference_1(40 downto 40)) = 1;
      slice0cost_pixels_first_1_0_count_14_value := to_integer(slice0shift_reference_1(42 downto 42)) = 1;
      slice0cost_pixels_first_1_0_count_14_value_2 := to_integer(slice0shift_reference_1(44 downto 44)) = 1;
      slice0cost_pixels_first_1_0_count_14_value_3 := to_integer(slice0shift_reference_1(43 downto 43)) = 1;
      slice0cost_pixels_first_1_0_count_15_value := to_integer(slice0shift_reference_1(45 downto 45)) = 1;
      slice0cost_pixels_first_1_0_count_15_value_2 := to_integer(slice0shift_reference_1(47 downto 47)) = 1;
      slice0cost_pixels_first_1_0_count_15_value_3 := to_integer(slice0shift_reference_1(46 downto 46)) = 1;
      slice0cost_pixels_first_1_0_count_16_value := to_integer(slice0shift_reference_1(48 downto 48)) = 1;
      slice0cost_pixels_first_1_0_count_16_value_2 := to_integer(slice0shift_reference_1(50 downto 50)) = 1;
      slice0cost_pixels_first_1_0_count_16_value_3 := to_integer(slice0shift_reference_1(49 downto 49)) = 1;
      slice0cost_pixels_first_1_0_count_17_value := to_integer(slice0shift_reference_1(51 downto 51)) = 1;
      slice0cost_pixels_first_1_0_count_17_value_2 := to_integer(slice0shift_reference_1(53 downto 53)) = 1;
      slice0cost_pixels_first_1_0_count_17_value_3 := to_integer(slice0shift_reference_1(52 downto 52)) = 1;
      slice0cost_pixels_first_1_0_count_18_value := to_integer(slice0shift_reference_1(54 downto 54)) = 1;
      slice0cost_pixels_first_1_0_count_18_value_2 := to_integer(slice0shift_reference_1(56 downto 56)) = 1;
      slice0cost_pixels_first_1_0_count_18_value_3 := to_integer(slice0shift_reference_1(55 downto 55)) = 1;
      slice0cost_pixels_first_1_0_count_19_value := to_integer(slice0shift_reference_1(57 downto 57)) = 1;
      slice0cost_pixels_first_1_0_count_19_value_2 := to_integer(slice0shift_reference_1(59 downto 59)) = 1;
      slice0cost_pixels_first_1_0_count_19_value_3 := to_integer(slice0shift_reference_1(58 downto 58)) = 1;
      slice0cost_pixels_first_1_0_count_20_value := to_integer(slice0shift_reference_1(60 downto 60)) = 1;
      slice0cost_pixels_first_2_0_count_0_value := to_integer(slice0shift_reference_2(2 downto 2)) = 1;
      slice0cost_pixels_first_2_0_count_0_value_2 := to_integer(slice0shift_reference_2(1 downto 1)) = 1;
      slice0cost_pixels_first_2_0_count_1_value := to_integer(slice0shift_reference_2(3 downto 3)) = 1;
      slice0cost_pixels_first_2_0_count_1_value_2 := to_integer(slice0shift_reference_2(5 downto 5)) = 1;
      slice0cost_pixels_first_2_0_count_1_value_3 := to_integer(slice0shift_reference_2(4 downto 4)) = 1;
      slice0cost_pixels_first_2_0_count_2_value := to_integer(slice0shift_reference_2(8 downto 8)) = 1;
      slice0cost_pixels_first_2_0_count_2_value_2 := to_integer(slice0shift_reference_2(6 downto 6)) = 1;
      slice0cost_pixels_first_2_0_count_3_value := to_integer(slice0shift_reference_2(9 downto 9)) = 1;
      slice0cost_pixels_first_2_0_count_3_value_2 := to_integer(slice0shift_reference_2(11 downto 11)) = 1;
      slice0cost_pixels_first_2_0_count_3_value_3 := to_integer(slice0shift_reference_2(10 downto 10)) = 1;
      slice0cost_pixels_first_2_0_count_4_value := to_integer(slice0shift_reference_2(12 downto 12)) = 1;
      slice0cost_pixels_first_2_0_count_4_value_2 := to_integer(slice0shift_reference_2(14 downto 14)) = 1;
      slice0cost_pixels_first_2_0_count_4_value_3 := to_integer(slice0shift_reference_2(13 downto 13)) = 1;
      slice0cost_pixels_first_2_0_count_5_value := to_integer(slice0shift_reference_2(15 downto 15)) = 1;
      slice0cost_pixels_first_2_0_count_5_value_2 := to_integer(slice0shift_reference_2(17 downto 17)) = 1;
      slice0cost_pixels_first_2_0_count_5_value_3 := to_integer(slice0shift_reference_2(16 downto 16)) = 1;
      slice0cost_pixels_first_2_0_count_6_value := to_integer(slice0shift_reference_2(18 downto 18)) = 1;
      slice0cost_pixels_first_2_0_count_6_value_2 := to_integer(slice0shift_reference_2(20 downto 20)) = 1;
      slice0cost_pixels_first_2_0_count_6_value_3 := to_integer(slice0shift_reference_2(19 downto 19)) = 1;
      slice0cost_pixels_first_2_0_count_7_value := to_integer(slice0shift_reference_2(21 downto 21)) = 1;
      slice0cost_pixels_first_2_0_count_7_value_2 := to_integer(slice0shift_reference_2(23 downto 23)) = 1;
      slice0cost_pixels_first_2_0_count_7_value_3 := to_integer(slice0shift_reference_2(22 downto 22)) = 1;
      slice0cost_pixels_first_2_0_count_8_value := to_integer(slice0shift_reference_2(24 downto 24)) = 1;
      slice0cost_pixels_first_2_0_count_8_value_2 := to_integer(slice0shift_reference_2(26 downto 26)) = 1;
      slice0cost_pixels_first_2_0_count_8_value_3 := to_integer(slice0shift_reference_2(25 downto 25)) = 1;
      slice0cost_pixels_first_2_0_count_9_value := to_integer(slice0shift_reference_2(27 downto 27)) = 1;
      slice0cost_pixels_first_2_0_count_9_value_2 := to_integer(slice0shift_reference_2(29 downto 29)) = 1;
      slice0cost_pixels_first_2_0_count_9_value_3 := to_integer(slice0shift_reference_2(28 downto 28)) = 1;
      slice0cost_pixels_first_2_0_count_10_value := to_integer(slice0shift_reference_2(30 downto 30)) = 1;
      slice0cost_pixels_first_2_0_count_10_value_2 := to_integer(slice0shift_reference_2(32 downto 32)) = 1;
      slice0cost_pixels_first_2_0_count_10_value_3 := to_integer(slice0shift_reference_2(31 downto 31)) = 1;
      slice0cost_pixels_first_2_0_count_11_value := to_integer(slice0shift_reference_2(33 downto 33)) = 1;
      slice0cost_pixels_first_2_0_count_11_value_2 := to_integer(slice0shift_reference_2(35 downto 35)) = 1;
      slice0cost_pixels_first_2_0_count_11_value_3 := to_integer(slice0shift_reference_2(34 downto 34)) = 1;
      slice0cost_pixels_first_2_0_count_12_value := to_integer(slice0shift_reference_2(36 downto 36)) = 1;
      slice0cost_pixels_first_2_0_count_12_value_2 := to_integer(slice0shift_reference_2(38 downto 38)) = 1;
      slice0cost_pixels_first_2_0_count_12_value_3 := to_integer(slice0shift_reference_2(37 downto 37)) = 1;
      slice0cost_pixels_first_2_0_count_13_value := to_integer(slice0shift_reference_2(39 downto 39)) = 1;
      slice0cost_pixels_first_2_0_count_13_value_2 := to_integer(slice0shift_reference_2(41 downto 41)) = 1;
      slice0cost_pixels_first_2_0_count_13_value_3 := to_integer(slice0shift_reference_2(40 downto 40)) = 1;
      slice0cost_pixels_first_2_0_count_14_value := to_integer(slice0shift_reference_2(42 downto 42)) = 1;
      slice0cost_pixels_first_2_0_count_14_value_2 := to_integer(slice0shift_reference_2(44 downto 44)) = 1;
      slice0cost_pixels_first_2_0_count_14_value_3 := to_integer(slice0shift_reference_2(43 downto 43)) = 1;
      slice0cost_pixels_first_2_0_count_15_value := to_integer(slice0shift_reference_2(45 downto 45)) = 1;
      slice0cost_pixels_first_2_0_count_15_value_2 := to_integer(slice0shift_reference_2(47 downto 47)) = 1;
      slice0cost_pixels_first_2_0_count_15_value_3 := to_integer(slice0shift_reference_2(46 downto 46)) = 1;
      slice0cost_pixels_first_2_0_count_16_value := to_integer(slice0shift_reference_2(48 downto 48)) = 1;
      slice0cost_pixels_first_2_0_count_16_value_2 := to_integer(slice0shift_reference_2(50 downto 50)) = 1;
      slice0cost_pixels_first_2_0_count_16_value_3 := to_integer(slice0shift_reference_2(49 downto 49)) = 1;
      slice0cost_pixels_first_2_0_count_17_value := to_integer(slice0shift_reference_2(51 downto 51)) = 1;
      slice0cost_pixels_first_2_0_count_17_value_2 := to_integer(slice0shift_reference_2(53 downto 53)) = 1;
      slice0cost_pixels_first_2_0_count_17_value_3 := to_integer(slice0shift_reference_2(52 downto 52)) = 1;
      slice0cost_pixels_first_2_0_count_18_value := to_integer(slice0shift_reference_2(54 downto 54)) = 1;
      slice0cost_pixels_first_2_0_count_18_value_2 := to_integer(slice0shift_reference_2(56 downto 56)) = 1;
      slice0cost_pixels_first_2_0_count_18_value_3 := to_integer(slice0shift_reference_2(55 downto 55)) = 1;
      slice0cost_pixels_first_2_0_count_19_value := to_integer(slice0shift_reference_2(57 downto 57)) = 1;
      slice0cost_pixels_first_2_0_count_19_value_2 := to_integer(slice0shift_reference_2(59 downto 59)) = 1;
      slice0cost_pixels_first_2_0_count_19_value_3 := to_integer(slice0shift_reference_2(58 downto 58)) = 1;
      slice0cost_pixels_first_2_0_count_20_value := to_integer(slice0shift_reference_2(60 downto 60)) = 1;
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
      slice0cost_pixels_first_0_0_count_14 <= as_number((slice0cost_pixels_first_0_0_count_14_value /=
        (to_integer(slice0shift_search_0_0(42 downto 42)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_14_value_2 /= (to_integer(slice0shift_search_0_0(44 downto 44)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_14_value_3 /= (to_integer(slice0shift_search_0_0(43 downto
        43)) = 1)));
      slice0cost_pixels_first_0_0_count_15 <= as_number((slice0cost_pixels_first_0_0_count_15_value /=
        (to_integer(slice0shift_search_0_0(45 downto 45)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_15_value_2 /= (to_integer(slice0shift_search_0_0(47 downto 47)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_15_value_3 /= (to_integer(slice0shift_search_0_0(46 downto
        46)) = 1)));
      slice0cost_pixels_first_0_0_count_16 <= as_number((slice0cost_pixels_first_0_0_count_16_value /=
        (to_integer(slice0shift_search_0_0(48 downto 48)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_16_value_2 /= (to_integer(slice0shift_search_0_0(50 downto 50)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_16_value_3 /= (to_integer(slice0shift_search_0_0(49 downto
        49)) = 1)));
      slice0cost_pixels_first_0_0_count_17 <= as_number((slice0cost_pixels_first_0_0_count_17_value /=
        (to_integer(slice0shift_search_0_0(51 downto 51)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_17_value_2 /= (to_integer(slice0shift_search_0_0(53 downto 53)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_17_value_3 /= (to_integer(slice0shift_search_0_0(52 downto
        52)) = 1)));
      slice0cost_pixels_first_0_0_count_18 <= as_number((slice0cost_pixels_first_0_0_count_18_value /=
        (to_integer(slice0shift_search_0_0(54 downto 54)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_18_value_2 /= (to_integer(slice0shift_search_0_0(56 downto 56)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_18_value_3 /= (to_integer(slice0shift_search_0_0(55 downto
        55)) = 1)));
      slice0cost_pixels_first_0_0_count_19 <= as_number((slice0cost_pixels_first_0_0_count_19_value /=
        (to_integer(slice0shift_search_0_0(57 downto 57)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_19_value_2 /= (to_integer(slice0shift_search_0_0(59 downto 59)) =
        1))) + as_number((slice0cost_pixels_first_0_0_count_19_value_3 /= (to_integer(slice0shift_search_0_0(58 downto
        58)) = 1)));
      slice0cost_pixels_first_0_0_count_20 <= as_number(((to_integer(slice0shift_reference_0(61 downto 61)) = 1) /=
        (to_integer(slice0shift_search_0_0(61 downto 61)) = 1))) +
        as_number((slice0cost_pixels_first_0_0_count_20_value /= (to_integer(slice0shift_search_0_0(60 downto 60)) =
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
      slice0cost_pixels_first_0_1_count_14 <= as_number(((to_integer(slice0shift_search_0_1(42 downto 42)) = 1) /=
        slice0cost_pixels_first_0_0_count_14_value)) + as_number(((to_integer(slice0shift_search_0_1(44 downto 44)) =
        1) /= slice0cost_pixels_first_0_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_0_1(43 downto
        43)) = 1) /= slice0cost_pixels_first_0_0_count_14_value_3));
      slice0cost_pixels_first_0_1_count_15 <= as_number(((to_integer(slice0shift_search_0_1(45 downto 45)) = 1) /=
        slice0cost_pixels_first_0_0_count_15_value)) + as_number(((to_integer(slice0shift_search_0_1(47 downto 47)) =
        1) /= slice0cost_pixels_first_0_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_0_1(46 downto
        46)) = 1) /= slice0cost_pixels_first_0_0_count_15_value_3));
      slice0cost_pixels_first_0_1_count_16 <= as_number(((to_integer(slice0shift_search_0_1(48 downto 48)) = 1) /=
        slice0cost_pixels_first_0_0_count_16_value)) + as_number(((to_integer(slice0shift_search_0_1(50 downto 50)) =
        1) /= slice0cost_pixels_first_0_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_0_1(49 downto
        49)) = 1) /= slice0cost_pixels_first_0_0_count_16_value_3));
      slice0cost_pixels_first_0_1_count_17 <= as_number(((to_integer(slice0shift_search_0_1(51 downto 51)) = 1) /=
        slice0cost_pixels_first_0_0_count_17_value)) + as_number(((to_integer(slice0shift_search_0_1(53 downto 53)) =
        1) /= slice0cost_pixels_first_0_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_0_1(52 downto
        52)) = 1) /= slice0cost_pixels_first_0_0_count_17_value_3));
      slice0cost_pixels_first_0_1_count_18 <= as_number(((to_integer(slice0shift_search_0_1(54 downto 54)) = 1) /=
        slice0cost_pixels_first_0_0_count_18_value)) + as_number(((to_integer(slice0shift_search_0_1(56 downto 56)) =
        1) /= slice0cost_pixels_first_0_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_0_1(55 downto
        55)) = 1) /= slice0cost_pixels_first_0_0_count_18_value_3));
      slice0cost_pixels_first_0_1_count_19 <= as_number(((to_integer(slice0shift_search_0_1(57 downto 57)) = 1) /=
        slice0cost_pixels_first_0_0_count_19_value)) + as_number(((to_integer(slice0shift_search_0_1(59 downto 59)) =
        1) /= slice0cost_pixels_first_0_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_0_1(58 downto
        58)) = 1) /= slice0cost_pixels_first_0_0_count_19_value_3));
      slice0cost_pixels_first_0_1_count_20 <= as_number(((to_integer(slice0shift_search_0_1(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_0(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_0_1(60
        downto 60)) = 1) /= slice0cost_pixels_first_0_0_count_20_value));
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
      slice0cost_pixels_first_0_2_count_14 <= as_number(((to_integer(slice0shift_search_0_2(42 downto 42)) = 1) /=
        slice0cost_pixels_first_0_0_count_14_value)) + as_number(((to_integer(slice0shift_search_0_2(44 downto 44)) =
        1) /= slice0cost_pixels_first_0_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_0_2(43 downto
        43)) = 1) /= slice0cost_pixels_first_0_0_count_14_value_3));
      slice0cost_pixels_first_0_2_count_15 <= as_number(((to_integer(slice0shift_search_0_2(45 downto 45)) = 1) /=
        slice0cost_pixels_first_0_0_count_15_value)) + as_number(((to_integer(slice0shift_search_0_2(47 downto 47)) =
        1) /= slice0cost_pixels_first_0_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_0_2(46 downto
        46)) = 1) /= slice0cost_pixels_first_0_0_count_15_value_3));
      slice0cost_pixels_first_0_2_count_16 <= as_number(((to_integer(slice0shift_search_0_2(48 downto 48)) = 1) /=
        slice0cost_pixels_first_0_0_count_16_value)) + as_number(((to_integer(slice0shift_search_0_2(50 downto 50)) =
        1) /= slice0cost_pixels_first_0_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_0_2(49 downto
        49)) = 1) /= slice0cost_pixels_first_0_0_count_16_value_3));
      slice0cost_pixels_first_0_2_count_17 <= as_number(((to_integer(slice0shift_search_0_2(51 downto 51)) = 1) /=
        slice0cost_pixels_first_0_0_count_17_value)) + as_number(((to_integer(slice0shift_search_0_2(53 downto 53)) =
        1) /= slice0cost_pixels_first_0_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_0_2(52 downto
        52)) = 1) /= slice0cost_pixels_first_0_0_count_17_value_3));
      slice0cost_pixels_first_0_2_count_18 <= as_number(((to_integer(slice0shift_search_0_2(54 downto 54)) = 1) /=
        slice0cost_pixels_first_0_0_count_18_value)) + as_number(((to_integer(slice0shift_search_0_2(56 downto 56)) =
        1) /= slice0cost_pixels_first_0_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_0_2(55 downto
        55)) = 1) /= slice0cost_pixels_first_0_0_count_18_value_3));
      slice0cost_pixels_first_0_2_count_19 <= as_number(((to_integer(slice0shift_search_0_2(57 downto 57)) = 1) /=
        slice0cost_pixels_first_0_0_count_19_value)) + as_number(((to_integer(slice0shift_search_0_2(59 downto 59)) =
        1) /= slice0cost_pixels_first_0_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_0_2(58 downto
        58)) = 1) /= slice0cost_pixels_first_0_0_count_19_value_3));
      slice0cost_pixels_first_0_2_count_20 <= as_number(((to_integer(slice0shift_search_0_2(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_0(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_0_2(60
        downto 60)) = 1) /= slice0cost_pixels_first_0_0_count_20_value));
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
      slice0cost_pixels_first_0_3_count_14 <= as_number(((to_integer(slice0shift_search_0_3(42 downto 42)) = 1) /=
        slice0cost_pixels_first_0_0_count_14_value)) + as_number(((to_integer(slice0shift_search_0_3(44 downto 44)) =
        1) /= slice0cost_pixels_first_0_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_0_3(43 downto
        43)) = 1) /= slice0cost_pixels_first_0_0_count_14_value_3));
      slice0cost_pixels_first_0_3_count_15 <= as_number(((to_integer(slice0shift_search_0_3(45 downto 45)) = 1) /=
        slice0cost_pixels_first_0_0_count_15_value)) + as_number(((to_integer(slice0shift_search_0_3(47 downto 47)) =
        1) /= slice0cost_pixels_first_0_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_0_3(46 downto
        46)) = 1) /= slice0cost_pixels_first_0_0_count_15_value_3));
      slice0cost_pixels_first_0_3_count_16 <= as_number(((to_integer(slice0shift_search_0_3(48 downto 48)) = 1) /=
        slice0cost_pixels_first_0_0_count_16_value)) + as_number(((to_integer(slice0shift_search_0_3(50 downto 50)) =
        1) /= slice0cost_pixels_first_0_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_0_3(49 downto
        49)) = 1) /= slice0cost_pixels_first_0_0_count_16_value_3));
      slice0cost_pixels_first_0_3_count_17 <= as_number(((to_integer(slice0shift_search_0_3(51 downto 51)) = 1) /=
        slice0cost_pixels_first_0_0_count_17_value)) + as_number(((to_integer(slice0shift_search_0_3(53 downto 53)) =
        1) /= slice0cost_pixels_first_0_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_0_3(52 downto
        52)) = 1) /= slice0cost_pixels_first_0_0_count_17_value_3));
      slice0cost_pixels_first_0_3_count_18 <= as_number(((to_integer(slice0shift_search_0_3(54 downto 54)) = 1) /=
        slice0cost_pixels_first_0_0_count_18_value)) + as_number(((to_integer(slice0shift_search_0_3(56 downto 56)) =
        1) /= slice0cost_pixels_first_0_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_0_3(55 downto
        55)) = 1) /= slice0cost_pixels_first_0_0_count_18_value_3));
      slice0cost_pixels_first_0_3_count_19 <= as_number(((to_integer(slice0shift_search_0_3(57 downto 57)) = 1) /=
        slice0cost_pixels_first_0_0_count_19_value)) + as_number(((to_integer(slice0shift_search_0_3(59 downto 59)) =
        1) /= slice0cost_pixels_first_0_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_0_3(58 downto
        58)) = 1) /= slice0cost_pixels_first_0_0_count_19_value_3));
      slice0cost_pixels_first_0_3_count_20 <= as_number(((to_integer(slice0shift_search_0_3(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_0(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_0_3(60
        downto 60)) = 1) /= slice0cost_pixels_first_0_0_count_20_value));
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
      slice0cost_pixels_first_0_4_count_14 <= as_number(((to_integer(slice0shift_search_0_4(42 downto 42)) = 1) /=
        slice0cost_pixels_first_0_0_count_14_value)) + as_number(((to_integer(slice0shift_search_0_4(44 downto 44)) =
        1) /= slice0cost_pixels_first_0_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_0_4(43 downto
        43)) = 1) /= slice0cost_pixels_first_0_0_count_14_value_3));
      slice0cost_pixels_first_0_4_count_15 <= as_number(((to_integer(slice0shift_search_0_4(45 downto 45)) = 1) /=
        slice0cost_pixels_first_0_0_count_15_value)) + as_number(((to_integer(slice0shift_search_0_4(47 downto 47)) =
        1) /= slice0cost_pixels_first_0_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_0_4(46 downto
        46)) = 1) /= slice0cost_pixels_first_0_0_count_15_value_3));
      slice0cost_pixels_first_0_4_count_16 <= as_number(((to_integer(slice0shift_search_0_4(48 downto 48)) = 1) /=
        slice0cost_pixels_first_0_0_count_16_value)) + as_number(((to_integer(slice0shift_search_0_4(50 downto 50)) =
        1) /= slice0cost_pixels_first_0_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_0_4(49 downto
        49)) = 1) /= slice0cost_pixels_first_0_0_count_16_value_3));
      slice0cost_pixels_first_0_4_count_17 <= as_number(((to_integer(slice0shift_search_0_4(51 downto 51)) = 1) /=
        slice0cost_pixels_first_0_0_count_17_value)) + as_number(((to_integer(slice0shift_search_0_4(53 downto 53)) =
        1) /= slice0cost_pixels_first_0_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_0_4(52 downto
        52)) = 1) /= slice0cost_pixels_first_0_0_count_17_value_3));
      slice0cost_pixels_first_0_4_count_18 <= as_number(((to_integer(slice0shift_search_0_4(54 downto 54)) = 1) /=
        slice0cost_pixels_first_0_0_count_18_value)) + as_number(((to_integer(slice0shift_search_0_4(56 downto 56)) =
        1) /= slice0cost_pixels_first_0_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_0_4(55 downto
        55)) = 1) /= slice0cost_pixels_first_0_0_count_18_value_3));
      slice0cost_pixels_first_0_4_count_19 <= as_number(((to_integer(slice0shift_search_0_4(57 downto 57)) = 1) /=
        slice0cost_pixels_first_0_0_count_19_value)) + as_number(((to_integer(slice0shift_search_0_4(59 downto 59)) =
        1) /= slice0cost_pixels_first_0_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_0_4(58 downto
        58)) = 1) /= slice0cost_pixels_first_0_0_count_19_value_3));
      slice0cost_pixels_first_0_4_count_20 <= as_number(((to_integer(slice0shift_search_0_4(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_0(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_0_4(60
        downto 60)) = 1) /= slice0cost_pixels_first_0_0_count_20_value));
      slice0cost_pixels_first_1_0_count_0 <= as_number(((to_integer(slice0shift_search_1_0(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_1(0 downto 0)) = 1))) + as_number((slice0cost_pixels_first_1_0_count_0_value
        /= (to_integer(slice0shift_search_1_0(2 downto 2)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_0_value_2 /= (to_integer(slice0shift_search_1_0(1 downto 1)) =
        1)));
      slice0cost_pixels_first_1_0_count_1 <= as_number((slice0cost_pixels_first_1_0_count_1_value /=
        (to_integer(slice0shift_search_1_0(3 downto 3)) = 1))) + as_number((slice0cost_pixels_first_1_0_count_1_value_2
        /= (to_integer(slice0shift_search_1_0(5 downto 5)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_1_value_3 /= (to_integer(slice0shift_search_1_0(4 downto 4)) =
        1)));
      slice0cost_pixels_first_1_0_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_1_0(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_1(7 downto 0)), 8)))) / 128) +
        as_number((slice0cost_pixels_first_1_0_count_2_value /= (to_integer(slice0shift_search_1_0(8 downto 8)) = 1)))
        + as_number((slice0cost_pixels_first_1_0_count_2_value_2 /= (to_integer(slice0shift_search_1_0(6 downto 6)) =
        1)));
      slice0cost_pixels_first_1_0_count_3 <= as_number((slice0cost_pixels_first_1_0_count_3_value /=
        (to_integer(slice0shift_search_1_0(9 downto 9)) = 1))) + as_number((slice0cost_pixels_first_1_0_count_3_value_2
        /= (to_integer(slice0shift_search_1_0(11 downto 11)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_3_value_3 /= (to_integer(slice0shift_search_1_0(10 downto 10)) =
        1)));
      slice0cost_pixels_first_1_0_count_4 <= as_number((slice0cost_pixels_first_1_0_count_4_value /=
        (to_integer(slice0shift_search_1_0(12 downto 12)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_4_value_2 /= (to_integer(slice0shift_search_1_0(14 downto 14)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_4_value_3 /= (to_integer(slice0shift_search_1_0(13 downto
        13)) = 1)));
      slice0cost_pixels_first_1_0_count_5 <= as_number((slice0cost_pixels_first_1_0_count_5_value /=
        (to_integer(slice0shift_search_1_0(15 downto 15)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_5_value_2 /= (to_integer(slice0shift_search_1_0(17 downto 17)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_5_value_3 /= (to_integer(slice0shift_search_1_0(16 downto
        16)) = 1)));
      slice0cost_pixels_first_1_0_count_6 <= as_number((slice0cost_pixels_first_1_0_count_6_value /=
        (to_integer(slice0shift_search_1_0(18 downto 18)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_6_value_2 /= (to_integer(slice0shift_search_1_0(20 downto 20)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_6_value_3 /= (to_integer(slice0shift_search_1_0(19 downto
        19)) = 1)));
      slice0cost_pixels_first_1_0_count_7 <= as_number((slice0cost_pixels_first_1_0_count_7_value /=
        (to_integer(slice0shift_search_1_0(21 downto 21)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_7_value_2 /= (to_integer(slice0shift_search_1_0(23 downto 23)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_7_value_3 /= (to_integer(slice0shift_search_1_0(22 downto
        22)) = 1)));
      slice0cost_pixels_first_1_0_count_8 <= as_number((slice0cost_pixels_first_1_0_count_8_value /=
        (to_integer(slice0shift_search_1_0(24 downto 24)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_8_value_2 /= (to_integer(slice0shift_search_1_0(26 downto 26)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_8_value_3 /= (to_integer(slice0shift_search_1_0(25 downto
        25)) = 1)));
      slice0cost_pixels_first_1_0_count_9 <= as_number((slice0cost_pixels_first_1_0_count_9_value /=
        (to_integer(slice0shift_search_1_0(27 downto 27)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_9_value_2 /= (to_integer(slice0shift_search_1_0(29 downto 29)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_9_value_3 /= (to_integer(slice0shift_search_1_0(28 downto
        28)) = 1)));
      slice0cost_pixels_first_1_0_count_10 <= as_number((slice0cost_pixels_first_1_0_count_10_value /=
        (to_integer(slice0shift_search_1_0(30 downto 30)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_10_value_2 /= (to_integer(slice0shift_search_1_0(32 downto 32)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_10_value_3 /= (to_integer(slice0shift_search_1_0(31 downto
        31)) = 1)));
      slice0cost_pixels_first_1_0_count_11 <= as_number((slice0cost_pixels_first_1_0_count_11_value /=
        (to_integer(slice0shift_search_1_0(33 downto 33)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_11_value_2 /= (to_integer(slice0shift_search_1_0(35 downto 35)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_11_value_3 /= (to_integer(slice0shift_search_1_0(34 downto
        34)) = 1)));
      slice0cost_pixels_first_1_0_count_12 <= as_number((slice0cost_pixels_first_1_0_count_12_value /=
        (to_integer(slice0shift_search_1_0(36 downto 36)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_12_value_2 /= (to_integer(slice0shift_search_1_0(38 downto 38)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_12_value_3 /= (to_integer(slice0shift_search_1_0(37 downto
        37)) = 1)));
      slice0cost_pixels_first_1_0_count_13 <= as_number((slice0cost_pixels_first_1_0_count_13_value /=
        (to_integer(slice0shift_search_1_0(39 downto 39)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_13_value_2 /= (to_integer(slice0shift_search_1_0(41 downto 41)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_13_value_3 /= (to_integer(slice0shift_search_1_0(40 downto
        40)) = 1)));
      slice0cost_pixels_first_1_0_count_14 <= as_number((slice0cost_pixels_first_1_0_count_14_value /=
        (to_integer(slice0shift_search_1_0(42 downto 42)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_14_value_2 /= (to_integer(slice0shift_search_1_0(44 downto 44)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_14_value_3 /= (to_integer(slice0shift_search_1_0(43 downto
        43)) = 1)));
      slice0cost_pixels_first_1_0_count_15 <= as_number((slice0cost_pixels_first_1_0_count_15_value /=
        (to_integer(slice0shift_search_1_0(45 downto 45)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_15_value_2 /= (to_integer(slice0shift_search_1_0(47 downto 47)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_15_value_3 /= (to_integer(slice0shift_search_1_0(46 downto
        46)) = 1)));
      slice0cost_pixels_first_1_0_count_16 <= as_number((slice0cost_pixels_first_1_0_count_16_value /=
        (to_integer(slice0shift_search_1_0(48 downto 48)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_16_value_2 /= (to_integer(slice0shift_search_1_0(50 downto 50)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_16_value_3 /= (to_integer(slice0shift_search_1_0(49 downto
        49)) = 1)));
      slice0cost_pixels_first_1_0_count_17 <= as_number((slice0cost_pixels_first_1_0_count_17_value /=
        (to_integer(slice0shift_search_1_0(51 downto 51)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_17_value_2 /= (to_integer(slice0shift_search_1_0(53 downto 53)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_17_value_3 /= (to_integer(slice0shift_search_1_0(52 downto
        52)) = 1)));
      slice0cost_pixels_first_1_0_count_18 <= as_number((slice0cost_pixels_first_1_0_count_18_value /=
        (to_integer(slice0shift_search_1_0(54 downto 54)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_18_value_2 /= (to_integer(slice0shift_search_1_0(56 downto 56)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_18_value_3 /= (to_integer(slice0shift_search_1_0(55 downto
        55)) = 1)));
      slice0cost_pixels_first_1_0_count_19 <= as_number((slice0cost_pixels_first_1_0_count_19_value /=
        (to_integer(slice0shift_search_1_0(57 downto 57)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_19_value_2 /= (to_integer(slice0shift_search_1_0(59 downto 59)) =
        1))) + as_number((slice0cost_pixels_first_1_0_count_19_value_3 /= (to_integer(slice0shift_search_1_0(58 downto
        58)) = 1)));
      slice0cost_pixels_first_1_0_count_20 <= as_number(((to_integer(slice0shift_reference_1(61 downto 61)) = 1) /=
        (to_integer(slice0shift_search_1_0(61 downto 61)) = 1))) +
        as_number((slice0cost_pixels_first_1_0_count_20_value /= (to_integer(slice0shift_search_1_0(60 downto 60)) =
        1)));
      slice0cost_pixels_first_1_1_count_0 <= as_number(((to_integer(slice0shift_search_1_1(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_1(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_1_1(2
        downto 2)) = 1) /= slice0cost_pixels_first_1_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_1_1(1 downto 1)) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_1_count_1 <= as_number(((to_integer(slice0shift_search_1_1(3 downto 3)) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((to_integer(slice0shift_search_1_1(5 downto 5)) = 1)
        /= slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_1_1(4 downto 4)) =
        1) /= slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_1_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_1_1(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_1(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_1_1(8 downto 8)) = 1) /= slice0cost_pixels_first_1_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_1_1(6 downto 6)) = 1) /=
        slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_1_count_3 <= as_number(((to_integer(slice0shift_search_1_1(9 downto 9)) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((to_integer(slice0shift_search_1_1(11 downto 11)) = 1)
        /= slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_1_1(10 downto 10))
        = 1) /= slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_1_count_4 <= as_number(((to_integer(slice0shift_search_1_1(12 downto 12)) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((to_integer(slice0shift_search_1_1(14 downto 14)) = 1)
        /= slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_1_1(13 downto 13))
        = 1) /= slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_1_count_5 <= as_number(((to_integer(slice0shift_search_1_1(15 downto 15)) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((to_integer(slice0shift_search_1_1(17 downto 17)) = 1)
        /= slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_1_1(16 downto 16))
        = 1) /= slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_1_count_6 <= as_number(((to_integer(slice0shift_search_1_1(18 downto 18)) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((to_integer(slice0shift_search_1_1(20 downto 20)) = 1)
        /= slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_1_1(19 downto 19))
        = 1) /= slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_1_count_7 <= as_number(((to_integer(slice0shift_search_1_1(21 downto 21)) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((to_integer(slice0shift_search_1_1(23 downto 23)) = 1)
        /= slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_1_1(22 downto 22))
        = 1) /= slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_1_count_8 <= as_number(((to_integer(slice0shift_search_1_1(24 downto 24)) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value)) + as_number(((to_integer(slice0shift_search_1_1(26 downto 26)) = 1)
        /= slice0cost_pixels_first_1_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_1_1(25 downto 25))
        = 1) /= slice0cost_pixels_first_1_0_count_8_value_3));
      slice0cost_pixels_first_1_1_count_9 <= as_number(((to_integer(slice0shift_search_1_1(27 downto 27)) = 1) /=
        slice0cost_pixels_first_1_0_count_9_value)) + as_number(((to_integer(slice0shift_search_1_1(29 downto 29)) = 1)
        /= slice0cost_pixels_first_1_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_1_1(28 downto 28))
        = 1) /= slice0cost_pixels_first_1_0_count_9_value_3));
      slice0cost_pixels_first_1_1_count_10 <= as_number(((to_integer(slice0shift_search_1_1(30 downto 30)) = 1) /=
        slice0cost_pixels_first_1_0_count_10_value)) + as_number(((to_integer(slice0shift_search_1_1(32 downto 32)) =
        1) /= slice0cost_pixels_first_1_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_1_1(31 downto
        31)) = 1) /= slice0cost_pixels_first_1_0_count_10_value_3));
      slice0cost_pixels_first_1_1_count_11 <= as_number(((to_integer(slice0shift_search_1_1(33 downto 33)) = 1) /=
        slice0cost_pixels_first_1_0_count_11_value)) + as_number(((to_integer(slice0shift_search_1_1(35 downto 35)) =
        1) /= slice0cost_pixels_first_1_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_1_1(34 downto
        34)) = 1) /= slice0cost_pixels_first_1_0_count_11_value_3));
      slice0cost_pixels_first_1_1_count_12 <= as_number(((to_integer(slice0shift_search_1_1(36 downto 36)) = 1) /=
        slice0cost_pixels_first_1_0_count_12_value)) + as_number(((to_integer(slice0shift_search_1_1(38 downto 38)) =
        1) /= slice0cost_pixels_first_1_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_1_1(37 downto
        37)) = 1) /= slice0cost_pixels_first_1_0_count_12_value_3));
      slice0cost_pixels_first_1_1_count_13 <= as_number(((to_integer(slice0shift_search_1_1(39 downto 39)) = 1) /=
        slice0cost_pixels_first_1_0_count_13_value)) + as_number(((to_integer(slice0shift_search_1_1(41 downto 41)) =
        1) /= slice0cost_pixels_first_1_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_1_1(40 downto
        40)) = 1) /= slice0cost_pixels_first_1_0_count_13_value_3));
      slice0cost_pixels_first_1_1_count_14 <= as_number(((to_integer(slice0shift_search_1_1(42 downto 42)) = 1) /=
        slice0cost_pixels_first_1_0_count_14_value)) + as_number(((to_integer(slice0shift_search_1_1(44 downto 44)) =
        1) /= slice0cost_pixels_first_1_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_1_1(43 downto
        43)) = 1) /= slice0cost_pixels_first_1_0_count_14_value_3));
      slice0cost_pixels_first_1_1_count_15 <= as_number(((to_integer(slice0shift_search_1_1(45 downto 45)) = 1) /=
        slice0cost_pixels_first_1_0_count_15_value)) + as_number(((to_integer(slice0shift_search_1_1(47 downto 47)) =
        1) /= slice0cost_pixels_first_1_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_1_1(46 downto
        46)) = 1) /= slice0cost_pixels_first_1_0_count_15_value_3));
      slice0cost_pixels_first_1_1_count_16 <= as_number(((to_integer(slice0shift_search_1_1(48 downto 48)) = 1) /=
        slice0cost_pixels_first_1_0_count_16_value)) + as_number(((to_integer(slice0shift_search_1_1(50 downto 50)) =
        1) /= slice0cost_pixels_first_1_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_1_1(49 downto
        49)) = 1) /= slice0cost_pixels_first_1_0_count_16_value_3));
      slice0cost_pixels_first_1_1_count_17 <= as_number(((to_integer(slice0shift_search_1_1(51 downto 51)) = 1) /=
        slice0cost_pixels_first_1_0_count_17_value)) + as_number(((to_integer(slice0shift_search_1_1(53 downto 53)) =
        1) /= slice0cost_pixels_first_1_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_1_1(52 downto
        52)) = 1) /= slice0cost_pixels_first_1_0_count_17_value_3));
      slice0cost_pixels_first_1_1_count_18 <= as_number(((to_integer(slice0shift_search_1_1(54 downto 54)) = 1) /=
        slice0cost_pixels_first_1_0_count_18_value)) + as_number(((to_integer(slice0shift_search_1_1(56 downto 56)) =
        1) /= slice0cost_pixels_first_1_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_1_1(55 downto
        55)) = 1) /= slice0cost_pixels_first_1_0_count_18_value_3));
      slice0cost_pixels_first_1_1_count_19 <= as_number(((to_integer(slice0shift_search_1_1(57 downto 57)) = 1) /=
        slice0cost_pixels_first_1_0_count_19_value)) + as_number(((to_integer(slice0shift_search_1_1(59 downto 59)) =
        1) /= slice0cost_pixels_first_1_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_1_1(58 downto
        58)) = 1) /= slice0cost_pixels_first_1_0_count_19_value_3));
      slice0cost_pixels_first_1_1_count_20 <= as_number(((to_integer(slice0shift_search_1_1(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_1(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_1_1(60
        downto 60)) = 1) /= slice0cost_pixels_first_1_0_count_20_value));
      slice0cost_pixels_first_1_2_count_0 <= as_number(((to_integer(slice0shift_search_1_2(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_1(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_1_2(2
        downto 2)) = 1) /= slice0cost_pixels_first_1_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_1_2(1 downto 1)) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_2_count_1 <= as_number(((to_integer(slice0shift_search_1_2(3 downto 3)) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((to_integer(slice0shift_search_1_2(5 downto 5)) = 1)
        /= slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_1_2(4 downto 4)) =
        1) /= slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_2_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_1_2(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_1(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_1_2(8 downto 8)) = 1) /= slice0cost_pixels_first_1_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_1_2(6 downto 6)) = 1) /=
        slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_2_count_3 <= as_number(((to_integer(slice0shift_search_1_2(9 downto 9)) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((to_integer(slice0shift_search_1_2(11 downto 11)) = 1)
        /= slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_1_2(10 downto 10))
        = 1) /= slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_2_count_4 <= as_number(((to_integer(slice0shift_search_1_2(12 downto 12)) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((to_integer(slice0shift_search_1_2(14 downto 14)) = 1)
        /= slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_1_2(13 downto 13))
        = 1) /= slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_2_count_5 <= as_number(((to_integer(slice0shift_search_1_2(15 downto 15)) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((to_integer(slice0shift_search_1_2(17 downto 17)) = 1)
        /= slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_1_2(16 downto 16))
        = 1) /= slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_2_count_6 <= as_number(((to_integer(slice0shift_search_1_2(18 downto 18)) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((to_integer(slice0shift_search_1_2(20 downto 20)) = 1)
        /= slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_1_2(19 downto 19))
        = 1) /= slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_2_count_7 <= as_number(((to_integer(slice0shift_search_1_2(21 downto 21)) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((to_integer(slice0shift_search_1_2(23 downto 23)) = 1)
        /= slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_1_2(22 downto 22))
        = 1) /= slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_2_count_8 <= as_number(((to_integer(slice0shift_search_1_2(24 downto 24)) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value)) + as_number(((to_integer(slice0shift_search_1_2(26 downto 26)) = 1)
        /= slice0cost_pixels_first_1_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_1_2(25 downto 25))
        = 1) /= slice0cost_pixels_first_1_0_count_8_value_3));
      slice0cost_pixels_first_1_2_count_9 <= as_number(((to_integer(slice0shift_search_1_2(27 downto 27)) = 1) /=
        slice0cost_pixels_first_1_0_count_9_value)) + as_number(((to_integer(slice0shift_search_1_2(29 downto 29)) = 1)
        /= slice0cost_pixels_first_1_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_1_2(28 downto 28))
        = 1) /= slice0cost_pixels_first_1_0_count_9_value_3));
      slice0cost_pixels_first_1_2_count_10 <= as_number(((to_integer(slice0shift_search_1_2(30 downto 30)) = 1) /=
        slice0cost_pixels_first_1_0_count_10_value)) + as_number(((to_integer(slice0shift_search_1_2(32 downto 32)) =
        1) /= slice0cost_pixels_first_1_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_1_2(31 downto
        31)) = 1) /= slice0cost_pixels_first_1_0_count_10_value_3));
      slice0cost_pixels_first_1_2_count_11 <= as_number(((to_integer(slice0shift_search_1_2(33 downto 33)) = 1) /=
        slice0cost_pixels_first_1_0_count_11_value)) + as_number(((to_integer(slice0shift_search_1_2(35 downto 35)) =
        1) /= slice0cost_pixels_first_1_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_1_2(34 downto
        34)) = 1) /= slice0cost_pixels_first_1_0_count_11_value_3));
      slice0cost_pixels_first_1_2_count_12 <= as_number(((to_integer(slice0shift_search_1_2(36 downto 36)) = 1) /=
        slice0cost_pixels_first_1_0_count_12_value)) + as_number(((to_integer(slice0shift_search_1_2(38 downto 38)) =
        1) /= slice0cost_pixels_first_1_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_1_2(37 downto
        37)) = 1) /= slice0cost_pixels_first_1_0_count_12_value_3));
      slice0cost_pixels_first_1_2_count_13 <= as_number(((to_integer(slice0shift_search_1_2(39 downto 39)) = 1) /=
        slice0cost_pixels_first_1_0_count_13_value)) + as_number(((to_integer(slice0shift_search_1_2(41 downto 41)) =
        1) /= slice0cost_pixels_first_1_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_1_2(40 downto
        40)) = 1) /= slice0cost_pixels_first_1_0_count_13_value_3));
      slice0cost_pixels_first_1_2_count_14 <= as_number(((to_integer(slice0shift_search_1_2(42 downto 42)) = 1) /=
        slice0cost_pixels_first_1_0_count_14_value)) + as_number(((to_integer(slice0shift_search_1_2(44 downto 44)) =
        1) /= slice0cost_pixels_first_1_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_1_2(43 downto
        43)) = 1) /= slice0cost_pixels_first_1_0_count_14_value_3));
      slice0cost_pixels_first_1_2_count_15 <= as_number(((to_integer(slice0shift_search_1_2(45 downto 45)) = 1) /=
        slice0cost_pixels_first_1_0_count_15_value)) + as_number(((to_integer(slice0shift_search_1_2(47 downto 47)) =
        1) /= slice0cost_pixels_first_1_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_1_2(46 downto
        46)) = 1) /= slice0cost_pixels_first_1_0_count_15_value_3));
      slice0cost_pixels_first_1_2_count_16 <= as_number(((to_integer(slice0shift_search_1_2(48 downto 48)) = 1) /=
        slice0cost_pixels_first_1_0_count_16_value)) + as_number(((to_integer(slice0shift_search_1_2(50 downto 50)) =
        1) /= slice0cost_pixels_first_1_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_1_2(49 downto
        49)) = 1) /= slice0cost_pixels_first_1_0_count_16_value_3));
      slice0cost_pixels_first_1_2_count_17 <= as_number(((to_integer(slice0shift_search_1_2(51 downto 51)) = 1) /=
        slice0cost_pixels_first_1_0_count_17_value)) + as_number(((to_integer(slice0shift_search_1_2(53 downto 53)) =
        1) /= slice0cost_pixels_first_1_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_1_2(52 downto
        52)) = 1) /= slice0cost_pixels_first_1_0_count_17_value_3));
      slice0cost_pixels_first_1_2_count_18 <= as_number(((to_integer(slice0shift_search_1_2(54 downto 54)) = 1) /=
        slice0cost_pixels_first_1_0_count_18_value)) + as_number(((to_integer(slice0shift_search_1_2(56 downto 56)) =
        1) /= slice0cost_pixels_first_1_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_1_2(55 downto
        55)) = 1) /= slice0cost_pixels_first_1_0_count_18_value_3));
      slice0cost_pixels_first_1_2_count_19 <= as_number(((to_integer(slice0shift_search_1_2(57 downto 57)) = 1) /=
        slice0cost_pixels_first_1_0_count_19_value)) + as_number(((to_integer(slice0shift_search_1_2(59 downto 59)) =
        1) /= slice0cost_pixels_first_1_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_1_2(58 downto
        58)) = 1) /= slice0cost_pixels_first_1_0_count_19_value_3));
      slice0cost_pixels_first_1_2_count_20 <= as_number(((to_integer(slice0shift_search_1_2(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_1(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_1_2(60
        downto 60)) = 1) /= slice0cost_pixels_first_1_0_count_20_value));
      slice0cost_pixels_first_1_3_count_0 <= as_number(((to_integer(slice0shift_search_1_3(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_1(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_1_3(2
        downto 2)) = 1) /= slice0cost_pixels_first_1_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_1_3(1 downto 1)) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_3_count_1 <= as_number(((to_integer(slice0shift_search_1_3(3 downto 3)) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((to_integer(slice0shift_search_1_3(5 downto 5)) = 1)
        /= slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_1_3(4 downto 4)) =
        1) /= slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_3_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_1_3(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_1(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_1_3(8 downto 8)) = 1) /= slice0cost_pixels_first_1_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_1_3(6 downto 6)) = 1) /=
        slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_3_count_3 <= as_number(((to_integer(slice0shift_search_1_3(9 downto 9)) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((to_integer(slice0shift_search_1_3(11 downto 11)) = 1)
        /= slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_1_3(10 downto 10))
        = 1) /= slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_3_count_4 <= as_number(((to_integer(slice0shift_search_1_3(12 downto 12)) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((to_integer(slice0shift_search_1_3(14 downto 14)) = 1)
        /= slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_1_3(13 downto 13))
        = 1) /= slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_3_count_5 <= as_number(((to_integer(slice0shift_search_1_3(15 downto 15)) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((to_integer(slice0shift_search_1_3(17 downto 17)) = 1)
        /= slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_1_3(16 downto 16))
        = 1) /= slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_3_count_6 <= as_number(((to_integer(slice0shift_search_1_3(18 downto 18)) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((to_integer(slice0shift_search_1_3(20 downto 20)) = 1)
        /= slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_1_3(19 downto 19))
        = 1) /= slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_3_count_7 <= as_number(((to_integer(slice0shift_search_1_3(21 downto 21)) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((to_integer(slice0shift_search_1_3(23 downto 23)) = 1)
        /= slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_1_3(22 downto 22))
        = 1) /= slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_3_count_8 <= as_number(((to_integer(slice0shift_search_1_3(24 downto 24)) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value)) + as_number(((to_integer(slice0shift_search_1_3(26 downto 26)) = 1)
        /= slice0cost_pixels_first_1_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_1_3(25 downto 25))
        = 1) /= slice0cost_pixels_first_1_0_count_8_value_3));
      slice0cost_pixels_first_1_3_count_9 <= as_number(((to_integer(slice0shift_search_1_3(27 downto 27)) = 1) /=
        slice0cost_pixels_first_1_0_count_9_value)) + as_number(((to_integer(slice0shift_search_1_3(29 downto 29)) = 1)
        /= slice0cost_pixels_first_1_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_1_3(28 downto 28))
        = 1) /= slice0cost_pixels_first_1_0_count_9_value_3));
      slice0cost_pixels_first_1_3_count_10 <= as_number(((to_integer(slice0shift_search_1_3(30 downto 30)) = 1) /=
        slice0cost_pixels_first_1_0_count_10_value)) + as_number(((to_integer(slice0shift_search_1_3(32 downto 32)) =
        1) /= slice0cost_pixels_first_1_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_1_3(31 downto
        31)) = 1) /= slice0cost_pixels_first_1_0_count_10_value_3));
      slice0cost_pixels_first_1_3_count_11 <= as_number(((to_integer(slice0shift_search_1_3(33 downto 33)) = 1) /=
        slice0cost_pixels_first_1_0_count_11_value)) + as_number(((to_integer(slice0shift_search_1_3(35 downto 35)) =
        1) /= slice0cost_pixels_first_1_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_1_3(34 downto
        34)) = 1) /= slice0cost_pixels_first_1_0_count_11_value_3));
      slice0cost_pixels_first_1_3_count_12 <= as_number(((to_integer(slice0shift_search_1_3(36 downto 36)) = 1) /=
        slice0cost_pixels_first_1_0_count_12_value)) + as_number(((to_integer(slice0shift_search_1_3(38 downto 38)) =
        1) /= slice0cost_pixels_first_1_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_1_3(37 downto
        37)) = 1) /= slice0cost_pixels_first_1_0_count_12_value_3));
      slice0cost_pixels_first_1_3_count_13 <= as_number(((to_integer(slice0shift_search_1_3(39 downto 39)) = 1) /=
        slice0cost_pixels_first_1_0_count_13_value)) + as_number(((to_integer(slice0shift_search_1_3(41 downto 41)) =
        1) /= slice0cost_pixels_first_1_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_1_3(40 downto
        40)) = 1) /= slice0cost_pixels_first_1_0_count_13_value_3));
      slice0cost_pixels_first_1_3_count_14 <= as_number(((to_integer(slice0shift_search_1_3(42 downto 42)) = 1) /=
        slice0cost_pixels_first_1_0_count_14_value)) + as_number(((to_integer(slice0shift_search_1_3(44 downto 44)) =
        1) /= slice0cost_pixels_first_1_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_1_3(43 downto
        43)) = 1) /= slice0cost_pixels_first_1_0_count_14_value_3));
      slice0cost_pixels_first_1_3_count_15 <= as_number(((to_integer(slice0shift_search_1_3(45 downto 45)) = 1) /=
        slice0cost_pixels_first_1_0_count_15_value)) + as_number(((to_integer(slice0shift_search_1_3(47 downto 47)) =
        1) /= slice0cost_pixels_first_1_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_1_3(46 downto
        46)) = 1) /= slice0cost_pixels_first_1_0_count_15_value_3));
      slice0cost_pixels_first_1_3_count_16 <= as_number(((to_integer(slice0shift_search_1_3(48 downto 48)) = 1) /=
        slice0cost_pixels_first_1_0_count_16_value)) + as_number(((to_integer(slice0shift_search_1_3(50 downto 50)) =
        1) /= slice0cost_pixels_first_1_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_1_3(49 downto
        49)) = 1) /= slice0cost_pixels_first_1_0_count_16_value_3));
      slice0cost_pixels_first_1_3_count_17 <= as_number(((to_integer(slice0shift_search_1_3(51 downto 51)) = 1) /=
        slice0cost_pixels_first_1_0_count_17_value)) + as_number(((to_integer(slice0shift_search_1_3(53 downto 53)) =
        1) /= slice0cost_pixels_first_1_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_1_3(52 downto
        52)) = 1) /= slice0cost_pixels_first_1_0_count_17_value_3));
      slice0cost_pixels_first_1_3_count_18 <= as_number(((to_integer(slice0shift_search_1_3(54 downto 54)) = 1) /=
        slice0cost_pixels_first_1_0_count_18_value)) + as_number(((to_integer(slice0shift_search_1_3(56 downto 56)) =
        1) /= slice0cost_pixels_first_1_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_1_3(55 downto
        55)) = 1) /= slice0cost_pixels_first_1_0_count_18_value_3));
      slice0cost_pixels_first_1_3_count_19 <= as_number(((to_integer(slice0shift_search_1_3(57 downto 57)) = 1) /=
        slice0cost_pixels_first_1_0_count_19_value)) + as_number(((to_integer(slice0shift_search_1_3(59 downto 59)) =
        1) /= slice0cost_pixels_first_1_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_1_3(58 downto
        58)) = 1) /= slice0cost_pixels_first_1_0_count_19_value_3));
      slice0cost_pixels_first_1_3_count_20 <= as_number(((to_integer(slice0shift_search_1_3(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_1(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_1_3(60
        downto 60)) = 1) /= slice0cost_pixels_first_1_0_count_20_value));
      slice0cost_pixels_first_1_4_count_0 <= as_number(((to_integer(slice0shift_search_1_4(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_1(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_1_4(2
        downto 2)) = 1) /= slice0cost_pixels_first_1_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_1_4(1 downto 1)) = 1) /=
        slice0cost_pixels_first_1_0_count_0_value_2));
      slice0cost_pixels_first_1_4_count_1 <= as_number(((to_integer(slice0shift_search_1_4(3 downto 3)) = 1) /=
        slice0cost_pixels_first_1_0_count_1_value)) + as_number(((to_integer(slice0shift_search_1_4(5 downto 5)) = 1)
        /= slice0cost_pixels_first_1_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_1_4(4 downto 4)) =
        1) /= slice0cost_pixels_first_1_0_count_1_value_3));
      slice0cost_pixels_first_1_4_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_1_4(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_1(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_1_4(8 downto 8)) = 1) /= slice0cost_pixels_first_1_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_1_4(6 downto 6)) = 1) /=
        slice0cost_pixels_first_1_0_count_2_value_2));
      slice0cost_pixels_first_1_4_count_3 <= as_number(((to_integer(slice0shift_search_1_4(9 downto 9)) = 1) /=
        slice0cost_pixels_first_1_0_count_3_value)) + as_number(((to_integer(slice0shift_search_1_4(11 downto 11)) = 1)
        /= slice0cost_pixels_first_1_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_1_4(10 downto 10))
        = 1) /= slice0cost_pixels_first_1_0_count_3_value_3));
      slice0cost_pixels_first_1_4_count_4 <= as_number(((to_integer(slice0shift_search_1_4(12 downto 12)) = 1) /=
        slice0cost_pixels_first_1_0_count_4_value)) + as_number(((to_integer(slice0shift_search_1_4(14 downto 14)) = 1)
        /= slice0cost_pixels_first_1_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_1_4(13 downto 13))
        = 1) /= slice0cost_pixels_first_1_0_count_4_value_3));
      slice0cost_pixels_first_1_4_count_5 <= as_number(((to_integer(slice0shift_search_1_4(15 downto 15)) = 1) /=
        slice0cost_pixels_first_1_0_count_5_value)) + as_number(((to_integer(slice0shift_search_1_4(17 downto 17)) = 1)
        /= slice0cost_pixels_first_1_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_1_4(16 downto 16))
        = 1) /= slice0cost_pixels_first_1_0_count_5_value_3));
      slice0cost_pixels_first_1_4_count_6 <= as_number(((to_integer(slice0shift_search_1_4(18 downto 18)) = 1) /=
        slice0cost_pixels_first_1_0_count_6_value)) + as_number(((to_integer(slice0shift_search_1_4(20 downto 20)) = 1)
        /= slice0cost_pixels_first_1_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_1_4(19 downto 19))
        = 1) /= slice0cost_pixels_first_1_0_count_6_value_3));
      slice0cost_pixels_first_1_4_count_7 <= as_number(((to_integer(slice0shift_search_1_4(21 downto 21)) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((to_integer(slice0shift_search_1_4(23 downto 23)) = 1)
        /= slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_1_4(22 downto 22))
        = 1) /= slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_4_count_8 <= as_number(((to_integer(slice0shift_search_1_4(24 downto 24)) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value)) + as_number(((to_integer(slice0shift_search_1_4(26 downto 26)) = 1)
        /= slice0cost_pixels_first_1_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_1_4(25 downto 25))
        = 1) /= slice0cost_pixels_first_1_0_count_8_value_3));
      slice0cost_pixels_first_1_4_count_9 <= as_number(((to_integer(slice0shift_search_1_4(27 downto 27)) = 1) /=
        slice0cost_pixels_first_1_0_count_9_value)) + as_number(((to_integer(slice0shift_search_1_4(29 downto 29)) = 1)
        /= slice0cost_pixels_first_1_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_1_4(28 downto 28))
        = 1) /= slice0cost_pixels_first_1_0_count_9_value_3));
      slice0cost_pixels_first_1_4_count_10 <= as_number(((to_integer(slice0shift_search_1_4(30 downto 30)) = 1) /=
        slice0cost_pixels_first_1_0_count_10_value)) + as_number(((to_integer(slice0shift_search_1_4(32 downto 32)) =
        1) /= slice0cost_pixels_first_1_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_1_4(31 downto
        31)) = 1) /= slice0cost_pixels_first_1_0_count_10_value_3));
      slice0cost_pixels_first_1_4_count_11 <= as_number(((to_integer(slice0shift_search_1_4(33 downto 33)) = 1) /=
        slice0cost_pixels_first_1_0_count_11_value)) + as_number(((to_integer(slice0shift_search_1_4(35 downto 35)) =
        1) /= slice0cost_pixels_first_1_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_1_4(34 downto
        34)) = 1) /= slice0cost_pixels_first_1_0_count_11_value_3));
      slice0cost_pixels_first_1_4_count_12 <= as_number(((to_integer(slice0shift_search_1_4(36 downto 36)) = 1) /=
        slice0cost_pixels_first_1_0_count_12_value)) + as_number(((to_integer(slice0shift_search_1_4(38 downto 38)) =
        1) /= slice0cost_pixels_first_1_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_1_4(37 downto
        37)) = 1) /= slice0cost_pixels_first_1_0_count_12_value_3));
      slice0cost_pixels_first_1_4_count_13 <= as_number(((to_integer(slice0shift_search_1_4(39 downto 39)) = 1) /=
        slice0cost_pixels_first_1_0_count_13_value)) + as_number(((to_integer(slice0shift_search_1_4(41 downto 41)) =
        1) /= slice0cost_pixels_first_1_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_1_4(40 downto
        40)) = 1) /= slice0cost_pixels_first_1_0_count_13_value_3));
      slice0cost_pixels_first_1_4_count_14 <= as_number(((to_integer(slice0shift_search_1_4(42 downto 42)) = 1) /=
        slice0cost_pixels_first_1_0_count_14_value)) + as_number(((to_integer(slice0shift_search_1_4(44 downto 44)) =
        1) /= slice0cost_pixels_first_1_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_1_4(43 downto
        43)) = 1) /= slice0cost_pixels_first_1_0_count_14_value_3));
      slice0cost_pixels_first_1_4_count_15 <= as_number(((to_integer(slice0shift_search_1_4(45 downto 45)) = 1) /=
        slice0cost_pixels_first_1_0_count_15_value)) + as_number(((to_integer(slice0shift_search_1_4(47 downto 47)) =
        1) /= slice0cost_pixels_first_1_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_1_4(46 downto
        46)) = 1) /= slice0cost_pixels_first_1_0_count_15_value_3));
      slice0cost_pixels_first_1_4_count_16 <= as_number(((to_integer(slice0shift_search_1_4(48 downto 48)) = 1) /=
        slice0cost_pixels_first_1_0_count_16_value)) + as_number(((to_integer(slice0shift_search_1_4(50 downto 50)) =
        1) /= slice0cost_pixels_first_1_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_1_4(49 downto
        49)) = 1) /= slice0cost_pixels_first_1_0_count_16_value_3));
      slice0cost_pixels_first_1_4_count_17 <= as_number(((to_integer(slice0shift_search_1_4(51 downto 51)) = 1) /=
        slice0cost_pixels_first_1_0_count_17_value)) + as_number(((to_integer(slice0shift_search_1_4(53 downto 53)) =
        1) /= slice0cost_pixels_first_1_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_1_4(52 downto
        52)) = 1) /= slice0cost_pixels_first_1_0_count_17_value_3));
      slice0cost_pixels_first_1_4_count_18 <= as_number(((to_integer(slice0shift_search_1_4(54 downto 54)) = 1) /=
        slice0cost_pixels_first_1_0_count_18_value)) + as_number(((to_integer(slice0shift_search_1_4(56 downto 56)) =
        1) /= slice0cost_pixels_first_1_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_1_4(55 downto
        55)) = 1) /= slice0cost_pixels_first_1_0_count_18_value_3));
      slice0cost_pixels_first_1_4_count_19 <= as_number(((to_integer(slice0shift_search_1_4(57 downto 57)) = 1) /=
        slice0cost_pixels_first_1_0_count_19_value)) + as_number(((to_integer(slice0shift_search_1_4(59 downto 59)) =
        1) /= slice0cost_pixels_first_1_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_1_4(58 downto
        58)) = 1) /= slice0cost_pixels_first_1_0_count_19_value_3));
      slice0cost_pixels_first_1_4_count_20 <= as_number(((to_integer(slice0shift_search_1_4(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_1(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_1_4(60
        downto 60)) = 1) /= slice0cost_pixels_first_1_0_count_20_value));
      slice0cost_pixels_first_2_0_count_0 <= as_number(((to_integer(slice0shift_search_2_0(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_2(0 downto 0)) = 1))) + as_number((slice0cost_pixels_first_2_0_count_0_value
        /= (to_integer(slice0shift_search_2_0(2 downto 2)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_0_value_2 /= (to_integer(slice0shift_search_2_0(1 downto 1)) =
        1)));
      slice0cost_pixels_first_2_0_count_1 <= as_number((slice0cost_pixels_first_2_0_count_1_value /=
        (to_integer(slice0shift_search_2_0(3 downto 3)) = 1))) + as_number((slice0cost_pixels_first_2_0_count_1_value_2
        /= (to_integer(slice0shift_search_2_0(5 downto 5)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_1_value_3 /= (to_integer(slice0shift_search_2_0(4 downto 4)) =
        1)));
      slice0cost_pixels_first_2_0_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_2_0(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_2(7 downto 0)), 8)))) / 128) +
        as_number((slice0cost_pixels_first_2_0_count_2_value /= (to_integer(slice0shift_search_2_0(8 downto 8)) = 1)))
        + as_number((slice0cost_pixels_first_2_0_count_2_value_2 /= (to_integer(slice0shift_search_2_0(6 downto 6)) =
        1)));
      slice0cost_pixels_first_2_0_count_3 <= as_number((slice0cost_pixels_first_2_0_count_3_value /=
        (to_integer(slice0shift_search_2_0(9 downto 9)) = 1))) + as_number((slice0cost_pixels_first_2_0_count_3_value_2
        /= (to_integer(slice0shift_search_2_0(11 downto 11)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_3_value_3 /= (to_integer(slice0shift_search_2_0(10 downto 10)) =
        1)));
      slice0cost_pixels_first_2_0_count_4 <= as_number((slice0cost_pixels_first_2_0_count_4_value /=
        (to_integer(slice0shift_search_2_0(12 downto 12)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_4_value_2 /= (to_integer(slice0shift_search_2_0(14 downto 14)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_4_value_3 /= (to_integer(slice0shift_search_2_0(13 downto
        13)) = 1)));
      slice0cost_pixels_first_2_0_count_5 <= as_number((slice0cost_pixels_first_2_0_count_5_value /=
        (to_integer(slice0shift_search_2_0(15 downto 15)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_5_value_2 /= (to_integer(slice0shift_search_2_0(17 downto 17)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_5_value_3 /= (to_integer(slice0shift_search_2_0(16 downto
        16)) = 1)));
      slice0cost_pixels_first_2_0_count_6 <= as_number((slice0cost_pixels_first_2_0_count_6_value /=
        (to_integer(slice0shift_search_2_0(18 downto 18)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_6_value_2 /= (to_integer(slice0shift_search_2_0(20 downto 20)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_6_value_3 /= (to_integer(slice0shift_search_2_0(19 downto
        19)) = 1)));
      slice0cost_pixels_first_2_0_count_7 <= as_number((slice0cost_pixels_first_2_0_count_7_value /=
        (to_integer(slice0shift_search_2_0(21 downto 21)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_7_value_2 /= (to_integer(slice0shift_search_2_0(23 downto 23)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_7_value_3 /= (to_integer(slice0shift_search_2_0(22 downto
        22)) = 1)));
      slice0cost_pixels_first_2_0_count_8 <= as_number((slice0cost_pixels_first_2_0_count_8_value /=
        (to_integer(slice0shift_search_2_0(24 downto 24)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_8_value_2 /= (to_integer(slice0shift_search_2_0(26 downto 26)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_8_value_3 /= (to_integer(slice0shift_search_2_0(25 downto
        25)) = 1)));
      slice0cost_pixels_first_2_0_count_9 <= as_number((slice0cost_pixels_first_2_0_count_9_value /=
        (to_integer(slice0shift_search_2_0(27 downto 27)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_9_value_2 /= (to_integer(slice0shift_search_2_0(29 downto 29)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_9_value_3 /= (to_integer(slice0shift_search_2_0(28 downto
        28)) = 1)));
      slice0cost_pixels_first_2_0_count_10 <= as_number((slice0cost_pixels_first_2_0_count_10_value /=
        (to_integer(slice0shift_search_2_0(30 downto 30)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_10_value_2 /= (to_integer(slice0shift_search_2_0(32 downto 32)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_10_value_3 /= (to_integer(slice0shift_search_2_0(31 downto
        31)) = 1)));
      slice0cost_pixels_first_2_0_count_11 <= as_number((slice0cost_pixels_first_2_0_count_11_value /=
        (to_integer(slice0shift_search_2_0(33 downto 33)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_11_value_2 /= (to_integer(slice0shift_search_2_0(35 downto 35)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_11_value_3 /= (to_integer(slice0shift_search_2_0(34 downto
        34)) = 1)));
      slice0cost_pixels_first_2_0_count_12 <= as_number((slice0cost_pixels_first_2_0_count_12_value /=
        (to_integer(slice0shift_search_2_0(36 downto 36)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_12_value_2 /= (to_integer(slice0shift_search_2_0(38 downto 38)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_12_value_3 /= (to_integer(slice0shift_search_2_0(37 downto
        37)) = 1)));
      slice0cost_pixels_first_2_0_count_13 <= as_number((slice0cost_pixels_first_2_0_count_13_value /=
        (to_integer(slice0shift_search_2_0(39 downto 39)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_13_value_2 /= (to_integer(slice0shift_search_2_0(41 downto 41)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_13_value_3 /= (to_integer(slice0shift_search_2_0(40 downto
        40)) = 1)));
      slice0cost_pixels_first_2_0_count_14 <= as_number((slice0cost_pixels_first_2_0_count_14_value /=
        (to_integer(slice0shift_search_2_0(42 downto 42)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_14_value_2 /= (to_integer(slice0shift_search_2_0(44 downto 44)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_14_value_3 /= (to_integer(slice0shift_search_2_0(43 downto
        43)) = 1)));
      slice0cost_pixels_first_2_0_count_15 <= as_number((slice0cost_pixels_first_2_0_count_15_value /=
        (to_integer(slice0shift_search_2_0(45 downto 45)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_15_value_2 /= (to_integer(slice0shift_search_2_0(47 downto 47)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_15_value_3 /= (to_integer(slice0shift_search_2_0(46 downto
        46)) = 1)));
      slice0cost_pixels_first_2_0_count_16 <= as_number((slice0cost_pixels_first_2_0_count_16_value /=
        (to_integer(slice0shift_search_2_0(48 downto 48)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_16_value_2 /= (to_integer(slice0shift_search_2_0(50 downto 50)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_16_value_3 /= (to_integer(slice0shift_search_2_0(49 downto
        49)) = 1)));
      slice0cost_pixels_first_2_0_count_17 <= as_number((slice0cost_pixels_first_2_0_count_17_value /=
        (to_integer(slice0shift_search_2_0(51 downto 51)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_17_value_2 /= (to_integer(slice0shift_search_2_0(53 downto 53)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_17_value_3 /= (to_integer(slice0shift_search_2_0(52 downto
        52)) = 1)));
      slice0cost_pixels_first_2_0_count_18 <= as_number((slice0cost_pixels_first_2_0_count_18_value /=
        (to_integer(slice0shift_search_2_0(54 downto 54)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_18_value_2 /= (to_integer(slice0shift_search_2_0(56 downto 56)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_18_value_3 /= (to_integer(slice0shift_search_2_0(55 downto
        55)) = 1)));
      slice0cost_pixels_first_2_0_count_19 <= as_number((slice0cost_pixels_first_2_0_count_19_value /=
        (to_integer(slice0shift_search_2_0(57 downto 57)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_19_value_2 /= (to_integer(slice0shift_search_2_0(59 downto 59)) =
        1))) + as_number((slice0cost_pixels_first_2_0_count_19_value_3 /= (to_integer(slice0shift_search_2_0(58 downto
        58)) = 1)));
      slice0cost_pixels_first_2_0_count_20 <= as_number(((to_integer(slice0shift_reference_2(61 downto 61)) = 1) /=
        (to_integer(slice0shift_search_2_0(61 downto 61)) = 1))) +
        as_number((slice0cost_pixels_first_2_0_count_20_value /= (to_integer(slice0shift_search_2_0(60 downto 60)) =
        1)));
      slice0cost_pixels_first_2_1_count_0 <= as_number(((to_integer(slice0shift_search_2_1(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_2(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_2_1(2
        downto 2)) = 1) /= slice0cost_pixels_first_2_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_2_1(1 downto 1)) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value_2));
      slice0cost_pixels_first_2_1_count_1 <= as_number(((to_integer(slice0shift_search_2_1(3 downto 3)) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value)) + as_number(((to_integer(slice0shift_search_2_1(5 downto 5)) = 1)
        /= slice0cost_pixels_first_2_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_2_1(4 downto 4)) =
        1) /= slice0cost_pixels_first_2_0_count_1_value_3));
      slice0cost_pixels_first_2_1_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_2_1(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_2(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_2_1(8 downto 8)) = 1) /= slice0cost_pixels_first_2_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_2_1(6 downto 6)) = 1) /=
        slice0cost_pixels_first_2_0_count_2_value_2));
      slice0cost_pixels_first_2_1_count_3 <= as_number(((to_integer(slice0shift_search_2_1(9 downto 9)) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value)) + as_number(((to_integer(slice0shift_search_2_1(11 downto 11)) = 1)
        /= slice0cost_pixels_first_2_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_2_1(10 downto 10))
        = 1) /= slice0cost_pixels_first_2_0_count_3_value_3));
      slice0cost_pixels_first_2_1_count_4 <= as_number(((to_integer(slice0shift_search_2_1(12 downto 12)) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value)) + as_number(((to_integer(slice0shift_search_2_1(14 downto 14)) = 1)
        /= slice0cost_pixels_first_2_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_2_1(13 downto 13))
        = 1) /= slice0cost_pixels_first_2_0_count_4_value_3));
      slice0cost_pixels_first_2_1_count_5 <= as_number(((to_integer(slice0shift_search_2_1(15 downto 15)) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value)) + as_number(((to_integer(slice0shift_search_2_1(17 downto 17)) = 1)
        /= slice0cost_pixels_first_2_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_2_1(16 downto 16))
        = 1) /= slice0cost_pixels_first_2_0_count_5_value_3));
      slice0cost_pixels_first_2_1_count_6 <= as_number(((to_integer(slice0shift_search_2_1(18 downto 18)) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value)) + as_number(((to_integer(slice0shift_search_2_1(20 downto 20)) = 1)
        /= slice0cost_pixels_first_2_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_2_1(19 downto 19))
        = 1) /= slice0cost_pixels_first_2_0_count_6_value_3));
      slice0cost_pixels_first_2_1_count_7 <= as_number(((to_integer(slice0shift_search_2_1(21 downto 21)) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value)) + as_number(((to_integer(slice0shift_search_2_1(23 downto 23)) = 1)
        /= slice0cost_pixels_first_2_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_2_1(22 downto 22))
        = 1) /= slice0cost_pixels_first_2_0_count_7_value_3));
      slice0cost_pixels_first_2_1_count_8 <= as_number(((to_integer(slice0shift_search_2_1(24 downto 24)) = 1) /=
        slice0cost_pixels_first_2_0_count_8_value)) + as_number(((to_integer(slice0shift_search_2_1(26 downto 26)) = 1)
        /= slice0cost_pixels_first_2_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_2_1(25 downto 25))
        = 1) /= slice0cost_pixels_first_2_0_count_8_value_3));
      slice0cost_pixels_first_2_1_count_9 <= as_number(((to_integer(slice0shift_search_2_1(27 downto 27)) = 1) /=
        slice0cost_pixels_first_2_0_count_9_value)) + as_number(((to_integer(slice0shift_search_2_1(29 downto 29)) = 1)
        /= slice0cost_pixels_first_2_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_2_1(28 downto 28))
        = 1) /= slice0cost_pixels_first_2_0_count_9_value_3));
      slice0cost_pixels_first_2_1_count_10 <= as_number(((to_integer(slice0shift_search_2_1(30 downto 30)) = 1) /=
        slice0cost_pixels_first_2_0_count_10_value)) + as_number(((to_integer(slice0shift_search_2_1(32 downto 32)) =
        1) /= slice0cost_pixels_first_2_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_2_1(31 downto
        31)) = 1) /= slice0cost_pixels_first_2_0_count_10_value_3));
      slice0cost_pixels_first_2_1_count_11 <= as_number(((to_integer(slice0shift_search_2_1(33 downto 33)) = 1) /=
        slice0cost_pixels_first_2_0_count_11_value)) + as_number(((to_integer(slice0shift_search_2_1(35 downto 35)) =
        1) /= slice0cost_pixels_first_2_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_2_1(34 downto
        34)) = 1) /= slice0cost_pixels_first_2_0_count_11_value_3));
      slice0cost_pixels_first_2_1_count_12 <= as_number(((to_integer(slice0shift_search_2_1(36 downto 36)) = 1) /=
        slice0cost_pixels_first_2_0_count_12_value)) + as_number(((to_integer(slice0shift_search_2_1(38 downto 38)) =
        1) /= slice0cost_pixels_first_2_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_2_1(37 downto
        37)) = 1) /= slice0cost_pixels_first_2_0_count_12_value_3));
      slice0cost_pixels_first_2_1_count_13 <= as_number(((to_integer(slice0shift_search_2_1(39 downto 39)) = 1) /=
        slice0cost_pixels_first_2_0_count_13_value)) + as_number(((to_integer(slice0shift_search_2_1(41 downto 41)) =
        1) /= slice0cost_pixels_first_2_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_2_1(40 downto
        40)) = 1) /= slice0cost_pixels_first_2_0_count_13_value_3));
      slice0cost_pixels_first_2_1_count_14 <= as_number(((to_integer(slice0shift_search_2_1(42 downto 42)) = 1) /=
        slice0cost_pixels_first_2_0_count_14_value)) + as_number(((to_integer(slice0shift_search_2_1(44 downto 44)) =
        1) /= slice0cost_pixels_first_2_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_2_1(43 downto
        43)) = 1) /= slice0cost_pixels_first_2_0_count_14_value_3));
      slice0cost_pixels_first_2_1_count_15 <= as_number(((to_integer(slice0shift_search_2_1(45 downto 45)) = 1) /=
        slice0cost_pixels_first_2_0_count_15_value)) + as_number(((to_integer(slice0shift_search_2_1(47 downto 47)) =
        1) /= slice0cost_pixels_first_2_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_2_1(46 downto
        46)) = 1) /= slice0cost_pixels_first_2_0_count_15_value_3));
      slice0cost_pixels_first_2_1_count_16 <= as_number(((to_integer(slice0shift_search_2_1(48 downto 48)) = 1) /=
        slice0cost_pixels_first_2_0_count_16_value)) + as_number(((to_integer(slice0shift_search_2_1(50 downto 50)) =
        1) /= slice0cost_pixels_first_2_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_2_1(49 downto
        49)) = 1) /= slice0cost_pixels_first_2_0_count_16_value_3));
      slice0cost_pixels_first_2_1_count_17 <= as_number(((to_integer(slice0shift_search_2_1(51 downto 51)) = 1) /=
        slice0cost_pixels_first_2_0_count_17_value)) + as_number(((to_integer(slice0shift_search_2_1(53 downto 53)) =
        1) /= slice0cost_pixels_first_2_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_2_1(52 downto
        52)) = 1) /= slice0cost_pixels_first_2_0_count_17_value_3));
      slice0cost_pixels_first_2_1_count_18 <= as_number(((to_integer(slice0shift_search_2_1(54 downto 54)) = 1) /=
        slice0cost_pixels_first_2_0_count_18_value)) + as_number(((to_integer(slice0shift_search_2_1(56 downto 56)) =
        1) /= slice0cost_pixels_first_2_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_2_1(55 downto
        55)) = 1) /= slice0cost_pixels_first_2_0_count_18_value_3));
      slice0cost_pixels_first_2_1_count_19 <= as_number(((to_integer(slice0shift_search_2_1(57 downto 57)) = 1) /=
        slice0cost_pixels_first_2_0_count_19_value)) + as_number(((to_integer(slice0shift_search_2_1(59 downto 59)) =
        1) /= slice0cost_pixels_first_2_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_2_1(58 downto
        58)) = 1) /= slice0cost_pixels_first_2_0_count_19_value_3));
      slice0cost_pixels_first_2_1_count_20 <= as_number(((to_integer(slice0shift_search_2_1(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_2(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_2_1(60
        downto 60)) = 1) /= slice0cost_pixels_first_2_0_count_20_value));
      slice0cost_pixels_first_2_2_count_0 <= as_number(((to_integer(slice0shift_search_2_2(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_2(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_2_2(2
        downto 2)) = 1) /= slice0cost_pixels_first_2_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_2_2(1 downto 1)) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value_2));
      slice0cost_pixels_first_2_2_count_1 <= as_number(((to_integer(slice0shift_search_2_2(3 downto 3)) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value)) + as_number(((to_integer(slice0shift_search_2_2(5 downto 5)) = 1)
        /= slice0cost_pixels_first_2_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_2_2(4 downto 4)) =
        1) /= slice0cost_pixels_first_2_0_count_1_value_3));
      slice0cost_pixels_first_2_2_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_2_2(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_2(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_2_2(8 downto 8)) = 1) /= slice0cost_pixels_first_2_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_2_2(6 downto 6)) = 1) /=
        slice0cost_pixels_first_2_0_count_2_value_2));
      slice0cost_pixels_first_2_2_count_3 <= as_number(((to_integer(slice0shift_search_2_2(9 downto 9)) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value)) + as_number(((to_integer(slice0shift_search_2_2(11 downto 11)) = 1)
        /= slice0cost_pixels_first_2_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_2_2(10 downto 10))
        = 1) /= slice0cost_pixels_first_2_0_count_3_value_3));
      slice0cost_pixels_first_2_2_count_4 <= as_number(((to_integer(slice0shift_search_2_2(12 downto 12)) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value)) + as_number(((to_integer(slice0shift_search_2_2(14 downto 14)) = 1)
        /= slice0cost_pixels_first_2_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_2_2(13 downto 13))
        = 1) /= slice0cost_pixels_first_2_0_count_4_value_3));
      slice0cost_pixels_first_2_2_count_5 <= as_number(((to_integer(slice0shift_search_2_2(15 downto 15)) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value)) + as_number(((to_integer(slice0shift_search_2_2(17 downto 17)) = 1)
        /= slice0cost_pixels_first_2_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_2_2(16 downto 16))
        = 1) /= slice0cost_pixels_first_2_0_count_5_value_3));
      slice0cost_pixels_first_2_2_count_6 <= as_number(((to_integer(slice0shift_search_2_2(18 downto 18)) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value)) + as_number(((to_integer(slice0shift_search_2_2(20 downto 20)) = 1)
        /= slice0cost_pixels_first_2_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_2_2(19 downto 19))
        = 1) /= slice0cost_pixels_first_2_0_count_6_value_3));
      slice0cost_pixels_first_2_2_count_7 <= as_number(((to_integer(slice0shift_search_2_2(21 downto 21)) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value)) + as_number(((to_integer(slice0shift_search_2_2(23 downto 23)) = 1)
        /= slice0cost_pixels_first_2_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_2_2(22 downto 22))
        = 1) /= slice0cost_pixels_first_2_0_count_7_value_3));
      slice0cost_pixels_first_2_2_count_8 <= as_number(((to_integer(slice0shift_search_2_2(24 downto 24)) = 1) /=
        slice0cost_pixels_first_2_0_count_8_value)) + as_number(((to_integer(slice0shift_search_2_2(26 downto 26)) = 1)
        /= slice0cost_pixels_first_2_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_2_2(25 downto 25))
        = 1) /= slice0cost_pixels_first_2_0_count_8_value_3));
      slice0cost_pixels_first_2_2_count_9 <= as_number(((to_integer(slice0shift_search_2_2(27 downto 27)) = 1) /=
        slice0cost_pixels_first_2_0_count_9_value)) + as_number(((to_integer(slice0shift_search_2_2(29 downto 29)) = 1)
        /= slice0cost_pixels_first_2_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_2_2(28 downto 28))
        = 1) /= slice0cost_pixels_first_2_0_count_9_value_3));
      slice0cost_pixels_first_2_2_count_10 <= as_number(((to_integer(slice0shift_search_2_2(30 downto 30)) = 1) /=
        slice0cost_pixels_first_2_0_count_10_value)) + as_number(((to_integer(slice0shift_search_2_2(32 downto 32)) =
        1) /= slice0cost_pixels_first_2_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_2_2(31 downto
        31)) = 1) /= slice0cost_pixels_first_2_0_count_10_value_3));
      slice0cost_pixels_first_2_2_count_11 <= as_number(((to_integer(slice0shift_search_2_2(33 downto 33)) = 1) /=
        slice0cost_pixels_first_2_0_count_11_value)) + as_number(((to_integer(slice0shift_search_2_2(35 downto 35)) =
        1) /= slice0cost_pixels_first_2_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_2_2(34 downto
        34)) = 1) /= slice0cost_pixels_first_2_0_count_11_value_3));
      slice0cost_pixels_first_2_2_count_12 <= as_number(((to_integer(slice0shift_search_2_2(36 downto 36)) = 1) /=
        slice0cost_pixels_first_2_0_count_12_value)) + as_number(((to_integer(slice0shift_search_2_2(38 downto 38)) =
        1) /= slice0cost_pixels_first_2_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_2_2(37 downto
        37)) = 1) /= slice0cost_pixels_first_2_0_count_12_value_3));
      slice0cost_pixels_first_2_2_count_13 <= as_number(((to_integer(slice0shift_search_2_2(39 downto 39)) = 1) /=
        slice0cost_pixels_first_2_0_count_13_value)) + as_number(((to_integer(slice0shift_search_2_2(41 downto 41)) =
        1) /= slice0cost_pixels_first_2_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_2_2(40 downto
        40)) = 1) /= slice0cost_pixels_first_2_0_count_13_value_3));
      slice0cost_pixels_first_2_2_count_14 <= as_number(((to_integer(slice0shift_search_2_2(42 downto 42)) = 1) /=
        slice0cost_pixels_first_2_0_count_14_value)) + as_number(((to_integer(slice0shift_search_2_2(44 downto 44)) =
        1) /= slice0cost_pixels_first_2_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_2_2(43 downto
        43)) = 1) /= slice0cost_pixels_first_2_0_count_14_value_3));
      slice0cost_pixels_first_2_2_count_15 <= as_number(((to_integer(slice0shift_search_2_2(45 downto 45)) = 1) /=
        slice0cost_pixels_first_2_0_count_15_value)) + as_number(((to_integer(slice0shift_search_2_2(47 downto 47)) =
        1) /= slice0cost_pixels_first_2_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_2_2(46 downto
        46)) = 1) /= slice0cost_pixels_first_2_0_count_15_value_3));
      slice0cost_pixels_first_2_2_count_16 <= as_number(((to_integer(slice0shift_search_2_2(48 downto 48)) = 1) /=
        slice0cost_pixels_first_2_0_count_16_value)) + as_number(((to_integer(slice0shift_search_2_2(50 downto 50)) =
        1) /= slice0cost_pixels_first_2_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_2_2(49 downto
        49)) = 1) /= slice0cost_pixels_first_2_0_count_16_value_3));
      slice0cost_pixels_first_2_2_count_17 <= as_number(((to_integer(slice0shift_search_2_2(51 downto 51)) = 1) /=
        slice0cost_pixels_first_2_0_count_17_value)) + as_number(((to_integer(slice0shift_search_2_2(53 downto 53)) =
        1) /= slice0cost_pixels_first_2_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_2_2(52 downto
        52)) = 1) /= slice0cost_pixels_first_2_0_count_17_value_3));
      slice0cost_pixels_first_2_2_count_18 <= as_number(((to_integer(slice0shift_search_2_2(54 downto 54)) = 1) /=
        slice0cost_pixels_first_2_0_count_18_value)) + as_number(((to_integer(slice0shift_search_2_2(56 downto 56)) =
        1) /= slice0cost_pixels_first_2_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_2_2(55 downto
        55)) = 1) /= slice0cost_pixels_first_2_0_count_18_value_3));
      slice0cost_pixels_first_2_2_count_19 <= as_number(((to_integer(slice0shift_search_2_2(57 downto 57)) = 1) /=
        slice0cost_pixels_first_2_0_count_19_value)) + as_number(((to_integer(slice0shift_search_2_2(59 downto 59)) =
        1) /= slice0cost_pixels_first_2_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_2_2(58 downto
        58)) = 1) /= slice0cost_pixels_first_2_0_count_19_value_3));
      slice0cost_pixels_first_2_2_count_20 <= as_number(((to_integer(slice0shift_search_2_2(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_2(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_2_2(60
        downto 60)) = 1) /= slice0cost_pixels_first_2_0_count_20_value));
      slice0cost_pixels_first_2_3_count_0 <= as_number(((to_integer(slice0shift_search_2_3(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_2(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_2_3(2
        downto 2)) = 1) /= slice0cost_pixels_first_2_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_2_3(1 downto 1)) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value_2));
      slice0cost_pixels_first_2_3_count_1 <= as_number(((to_integer(slice0shift_search_2_3(3 downto 3)) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value)) + as_number(((to_integer(slice0shift_search_2_3(5 downto 5)) = 1)
        /= slice0cost_pixels_first_2_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_2_3(4 downto 4)) =
        1) /= slice0cost_pixels_first_2_0_count_1_value_3));
      slice0cost_pixels_first_2_3_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_2_3(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_2(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_2_3(8 downto 8)) = 1) /= slice0cost_pixels_first_2_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_2_3(6 downto 6)) = 1) /=
        slice0cost_pixels_first_2_0_count_2_value_2));
      slice0cost_pixels_first_2_3_count_3 <= as_number(((to_integer(slice0shift_search_2_3(9 downto 9)) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value)) + as_number(((to_integer(slice0shift_search_2_3(11 downto 11)) = 1)
        /= slice0cost_pixels_first_2_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_2_3(10 downto 10))
        = 1) /= slice0cost_pixels_first_2_0_count_3_value_3));
      slice0cost_pixels_first_2_3_count_4 <= as_number(((to_integer(slice0shift_search_2_3(12 downto 12)) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value)) + as_number(((to_integer(slice0shift_search_2_3(14 downto 14)) = 1)
        /= slice0cost_pixels_first_2_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_2_3(13 downto 13))
        = 1) /= slice0cost_pixels_first_2_0_count_4_value_3));
      slice0cost_pixels_first_2_3_count_5 <= as_number(((to_integer(slice0shift_search_2_3(15 downto 15)) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value)) + as_number(((to_integer(slice0shift_search_2_3(17 downto 17)) = 1)
        /= slice0cost_pixels_first_2_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_2_3(16 downto 16))
        = 1) /= slice0cost_pixels_first_2_0_count_5_value_3));
      slice0cost_pixels_first_2_3_count_6 <= as_number(((to_integer(slice0shift_search_2_3(18 downto 18)) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value)) + as_number(((to_integer(slice0shift_search_2_3(20 downto 20)) = 1)
        /= slice0cost_pixels_first_2_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_2_3(19 downto 19))
        = 1) /= slice0cost_pixels_first_2_0_count_6_value_3));
      slice0cost_pixels_first_2_3_count_7 <= as_number(((to_integer(slice0shift_search_2_3(21 downto 21)) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value)) + as_number(((to_integer(slice0shift_search_2_3(23 downto 23)) = 1)
        /= slice0cost_pixels_first_2_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_2_3(22 downto 22))
        = 1) /= slice0cost_pixels_first_2_0_count_7_value_3));
      slice0cost_pixels_first_2_3_count_8 <= as_number(((to_integer(slice0shift_search_2_3(24 downto 24)) = 1) /=
        slice0cost_pixels_first_2_0_count_8_value)) + as_number(((to_integer(slice0shift_search_2_3(26 downto 26)) = 1)
        /= slice0cost_pixels_first_2_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_2_3(25 downto 25))
        = 1) /= slice0cost_pixels_first_2_0_count_8_value_3));
      slice0cost_pixels_first_2_3_count_9 <= as_number(((to_integer(slice0shift_search_2_3(27 downto 27)) = 1) /=
        slice0cost_pixels_first_2_0_count_9_value)) + as_number(((to_integer(slice0shift_search_2_3(29 downto 29)) = 1)
        /= slice0cost_pixels_first_2_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_2_3(28 downto 28))
        = 1) /= slice0cost_pixels_first_2_0_count_9_value_3));
      slice0cost_pixels_first_2_3_count_10 <= as_number(((to_integer(slice0shift_search_2_3(30 downto 30)) = 1) /=
        slice0cost_pixels_first_2_0_count_10_value)) + as_number(((to_integer(slice0shift_search_2_3(32 downto 32)) =
        1) /= slice0cost_pixels_first_2_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_2_3(31 downto
        31)) = 1) /= slice0cost_pixels_first_2_0_count_10_value_3));
      slice0cost_pixels_first_2_3_count_11 <= as_number(((to_integer(slice0shift_search_2_3(33 downto 33)) = 1) /=
        slice0cost_pixels_first_2_0_count_11_value)) + as_number(((to_integer(slice0shift_search_2_3(35 downto 35)) =
        1) /= slice0cost_pixels_first_2_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_2_3(34 downto
        34)) = 1) /= slice0cost_pixels_first_2_0_count_11_value_3));
      slice0cost_pixels_first_2_3_count_12 <= as_number(((to_integer(slice0shift_search_2_3(36 downto 36)) = 1) /=
        slice0cost_pixels_first_2_0_count_12_value)) + as_number(((to_integer(slice0shift_search_2_3(38 downto 38)) =
        1) /= slice0cost_pixels_first_2_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_2_3(37 downto
        37)) = 1) /= slice0cost_pixels_first_2_0_count_12_value_3));
      slice0cost_pixels_first_2_3_count_13 <= as_number(((to_integer(slice0shift_search_2_3(39 downto 39)) = 1) /=
        slice0cost_pixels_first_2_0_count_13_value)) + as_number(((to_integer(slice0shift_search_2_3(41 downto 41)) =
        1) /= slice0cost_pixels_first_2_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_2_3(40 downto
        40)) = 1) /= slice0cost_pixels_first_2_0_count_13_value_3));
      slice0cost_pixels_first_2_3_count_14 <= as_number(((to_integer(slice0shift_search_2_3(42 downto 42)) = 1) /=
        slice0cost_pixels_first_2_0_count_14_value)) + as_number(((to_integer(slice0shift_search_2_3(44 downto 44)) =
        1) /= slice0cost_pixels_first_2_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_2_3(43 downto
        43)) = 1) /= slice0cost_pixels_first_2_0_count_14_value_3));
      slice0cost_pixels_first_2_3_count_15 <= as_number(((to_integer(slice0shift_search_2_3(45 downto 45)) = 1) /=
        slice0cost_pixels_first_2_0_count_15_value)) + as_number(((to_integer(slice0shift_search_2_3(47 downto 47)) =
        1) /= slice0cost_pixels_first_2_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_2_3(46 downto
        46)) = 1) /= slice0cost_pixels_first_2_0_count_15_value_3));
      slice0cost_pixels_first_2_3_count_16 <= as_number(((to_integer(slice0shift_search_2_3(48 downto 48)) = 1) /=
        slice0cost_pixels_first_2_0_count_16_value)) + as_number(((to_integer(slice0shift_search_2_3(50 downto 50)) =
        1) /= slice0cost_pixels_first_2_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_2_3(49 downto
        49)) = 1) /= slice0cost_pixels_first_2_0_count_16_value_3));
      slice0cost_pixels_first_2_3_count_17 <= as_number(((to_integer(slice0shift_search_2_3(51 downto 51)) = 1) /=
        slice0cost_pixels_first_2_0_count_17_value)) + as_number(((to_integer(slice0shift_search_2_3(53 downto 53)) =
        1) /= slice0cost_pixels_first_2_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_2_3(52 downto
        52)) = 1) /= slice0cost_pixels_first_2_0_count_17_value_3));
      slice0cost_pixels_first_2_3_count_18 <= as_number(((to_integer(slice0shift_search_2_3(54 downto 54)) = 1) /=
        slice0cost_pixels_first_2_0_count_18_value)) + as_number(((to_integer(slice0shift_search_2_3(56 downto 56)) =
        1) /= slice0cost_pixels_first_2_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_2_3(55 downto
        55)) = 1) /= slice0cost_pixels_first_2_0_count_18_value_3));
      slice0cost_pixels_first_2_3_count_19 <= as_number(((to_integer(slice0shift_search_2_3(57 downto 57)) = 1) /=
        slice0cost_pixels_first_2_0_count_19_value)) + as_number(((to_integer(slice0shift_search_2_3(59 downto 59)) =
        1) /= slice0cost_pixels_first_2_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_2_3(58 downto
        58)) = 1) /= slice0cost_pixels_first_2_0_count_19_value_3));
      slice0cost_pixels_first_2_3_count_20 <= as_number(((to_integer(slice0shift_search_2_3(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_2(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_2_3(60
        downto 60)) = 1) /= slice0cost_pixels_first_2_0_count_20_value));
      slice0cost_pixels_first_2_4_count_0 <= as_number(((to_integer(slice0shift_search_2_4(0 downto 0)) = 1) /=
        (to_integer(slice0shift_reference_2(0 downto 0)) = 1))) + as_number(((to_integer(slice0shift_search_2_4(2
        downto 2)) = 1) /= slice0cost_pixels_first_2_0_count_0_value)) +
        as_number(((to_integer(slice0shift_search_2_4(1 downto 1)) = 1) /=
        slice0cost_pixels_first_2_0_count_0_value_2));
      slice0cost_pixels_first_2_4_count_1 <= as_number(((to_integer(slice0shift_search_2_4(3 downto 3)) = 1) /=
        slice0cost_pixels_first_2_0_count_1_value)) + as_number(((to_integer(slice0shift_search_2_4(5 downto 5)) = 1)
        /= slice0cost_pixels_first_2_0_count_1_value_2)) + as_number(((to_integer(slice0shift_search_2_4(4 downto 4)) =
        1) /= slice0cost_pixels_first_2_0_count_1_value_3));
      slice0cost_pixels_first_2_4_count_2 <= (to_integer(((to_unsigned(to_integer(slice0shift_search_2_4(7 downto 0)),
        8)) xor (to_unsigned(to_integer(slice0shift_reference_2(7 downto 0)), 8)))) / 128) +
        as_number(((to_integer(slice0shift_search_2_4(8 downto 8)) = 1) /= slice0cost_pixels_first_2_0_count_2_value))
        + as_number(((to_integer(slice0shift_search_2_4(6 downto 6)) = 1) /=
        slice0cost_pixels_first_2_0_count_2_value_2));
      slice0cost_pixels_first_2_4_count_3 <= as_number(((to_integer(slice0shift_search_2_4(9 downto 9)) = 1) /=
        slice0cost_pixels_first_2_0_count_3_value)) + as_number(((to_integer(slice0shift_search_2_4(11 downto 11)) = 1)
        /= slice0cost_pixels_first_2_0_count_3_value_2)) + as_number(((to_integer(slice0shift_search_2_4(10 downto 10))
        = 1) /= slice0cost_pixels_first_2_0_count_3_value_3));
      slice0cost_pixels_first_2_4_count_4 <= as_number(((to_integer(slice0shift_search_2_4(12 downto 12)) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value)) + as_number(((to_integer(slice0shift_search_2_4(14 downto 14)) = 1)
        /= slice0cost_pixels_first_2_0_count_4_value_2)) + as_number(((to_integer(slice0shift_search_2_4(13 downto 13))
        = 1) /= slice0cost_pixels_first_2_0_count_4_value_3));
      slice0cost_pixels_first_2_4_count_5 <= as_number(((to_integer(slice0shift_search_2_4(15 downto 15)) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value)) + as_number(((to_integer(slice0shift_search_2_4(17 downto 17)) = 1)
        /= slice0cost_pixels_first_2_0_count_5_value_2)) + as_number(((to_integer(slice0shift_search_2_4(16 downto 16))
        = 1) /= slice0cost_pixels_first_2_0_count_5_value_3));
      slice0cost_pixels_first_2_4_count_6 <= as_number(((to_integer(slice0shift_search_2_4(18 downto 18)) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value)) + as_number(((to_integer(slice0shift_search_2_4(20 downto 20)) = 1)
        /= slice0cost_pixels_first_2_0_count_6_value_2)) + as_number(((to_integer(slice0shift_search_2_4(19 downto 19))
        = 1) /= slice0cost_pixels_first_2_0_count_6_value_3));
      slice0cost_pixels_first_2_4_count_7 <= as_number(((to_integer(slice0shift_search_2_4(21 downto 21)) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value)) + as_number(((to_integer(slice0shift_search_2_4(23 downto 23)) = 1)
        /= slice0cost_pixels_first_2_0_count_7_value_2)) + as_number(((to_integer(slice0shift_search_2_4(22 downto 22))
        = 1) /= slice0cost_pixels_first_2_0_count_7_value_3));
      slice0cost_pixels_first_2_4_count_8 <= as_number(((to_integer(slice0shift_search_2_4(24 downto 24)) = 1) /=
        slice0cost_pixels_first_2_0_count_8_value)) + as_number(((to_integer(slice0shift_search_2_4(26 downto 26)) = 1)
        /= slice0cost_pixels_first_2_0_count_8_value_2)) + as_number(((to_integer(slice0shift_search_2_4(25 downto 25))
        = 1) /= slice0cost_pixels_first_2_0_count_8_value_3));
      slice0cost_pixels_first_2_4_count_9 <= as_number(((to_integer(slice0shift_search_2_4(27 downto 27)) = 1) /=
        slice0cost_pixels_first_2_0_count_9_value)) + as_number(((to_integer(slice0shift_search_2_4(29 downto 29)) = 1)
        /= slice0cost_pixels_first_2_0_count_9_value_2)) + as_number(((to_integer(slice0shift_search_2_4(28 downto 28))
        = 1) /= slice0cost_pixels_first_2_0_count_9_value_3));
      slice0cost_pixels_first_2_4_count_10 <= as_number(((to_integer(slice0shift_search_2_4(30 downto 30)) = 1) /=
        slice0cost_pixels_first_2_0_count_10_value)) + as_number(((to_integer(slice0shift_search_2_4(32 downto 32)) =
        1) /= slice0cost_pixels_first_2_0_count_10_value_2)) + as_number(((to_integer(slice0shift_search_2_4(31 downto
        31)) = 1) /= slice0cost_pixels_first_2_0_count_10_value_3));
      slice0cost_pixels_first_2_4_count_11 <= as_number(((to_integer(slice0shift_search_2_4(33 downto 33)) = 1) /=
        slice0cost_pixels_first_2_0_count_11_value)) + as_number(((to_integer(slice0shift_search_2_4(35 downto 35)) =
        1) /= slice0cost_pixels_first_2_0_count_11_value_2)) + as_number(((to_integer(slice0shift_search_2_4(34 downto
        34)) = 1) /= slice0cost_pixels_first_2_0_count_11_value_3));
      slice0cost_pixels_first_2_4_count_12 <= as_number(((to_integer(slice0shift_search_2_4(36 downto 36)) = 1) /=
        slice0cost_pixels_first_2_0_count_12_value)) + as_number(((to_integer(slice0shift_search_2_4(38 downto 38)) =
        1) /= slice0cost_pixels_first_2_0_count_12_value_2)) + as_number(((to_integer(slice0shift_search_2_4(37 downto
        37)) = 1) /= slice0cost_pixels_first_2_0_count_12_value_3));
      slice0cost_pixels_first_2_4_count_13 <= as_number(((to_integer(slice0shift_search_2_4(39 downto 39)) = 1) /=
        slice0cost_pixels_first_2_0_count_13_value)) + as_number(((to_integer(slice0shift_search_2_4(41 downto 41)) =
        1) /= slice0cost_pixels_first_2_0_count_13_value_2)) + as_number(((to_integer(slice0shift_search_2_4(40 downto
        40)) = 1) /= slice0cost_pixels_first_2_0_count_13_value_3));
      slice0cost_pixels_first_2_4_count_14 <= as_number(((to_integer(slice0shift_search_2_4(42 downto 42)) = 1) /=
        slice0cost_pixels_first_2_0_count_14_value)) + as_number(((to_integer(slice0shift_search_2_4(44 downto 44)) =
        1) /= slice0cost_pixels_first_2_0_count_14_value_2)) + as_number(((to_integer(slice0shift_search_2_4(43 downto
        43)) = 1) /= slice0cost_pixels_first_2_0_count_14_value_3));
      slice0cost_pixels_first_2_4_count_15 <= as_number(((to_integer(slice0shift_search_2_4(45 downto 45)) = 1) /=
        slice0cost_pixels_first_2_0_count_15_value)) + as_number(((to_integer(slice0shift_search_2_4(47 downto 47)) =
        1) /= slice0cost_pixels_first_2_0_count_15_value_2)) + as_number(((to_integer(slice0shift_search_2_4(46 downto
        46)) = 1) /= slice0cost_pixels_first_2_0_count_15_value_3));
      slice0cost_pixels_first_2_4_count_16 <= as_number(((to_integer(slice0shift_search_2_4(48 downto 48)) = 1) /=
        slice0cost_pixels_first_2_0_count_16_value)) + as_number(((to_integer(slice0shift_search_2_4(50 downto 50)) =
        1) /= slice0cost_pixels_first_2_0_count_16_value_2)) + as_number(((to_integer(slice0shift_search_2_4(49 downto
        49)) = 1) /= slice0cost_pixels_first_2_0_count_16_value_3));
      slice0cost_pixels_first_2_4_count_17 <= as_number(((to_integer(slice0shift_search_2_4(51 downto 51)) = 1) /=
        slice0cost_pixels_first_2_0_count_17_value)) + as_number(((to_integer(slice0shift_search_2_4(53 downto 53)) =
        1) /= slice0cost_pixels_first_2_0_count_17_value_2)) + as_number(((to_integer(slice0shift_search_2_4(52 downto
        52)) = 1) /= slice0cost_pixels_first_2_0_count_17_value_3));
      slice0cost_pixels_first_2_4_count_18 <= as_number(((to_integer(slice0shift_search_2_4(54 downto 54)) = 1) /=
        slice0cost_pixels_first_2_0_count_18_value)) + as_number(((to_integer(slice0shift_search_2_4(56 downto 56)) =
        1) /= slice0cost_pixels_first_2_0_count_18_value_2)) + as_number(((to_integer(slice0shift_search_2_4(55 downto
        55)) = 1) /= slice0cost_pixels_first_2_0_count_18_value_3));
      slice0cost_pixels_first_2_4_count_19 <= as_number(((to_integer(slice0shift_search_2_4(57 downto 57)) = 1) /=
        slice0cost_pixels_first_2_0_count_19_value)) + as_number(((to_integer(slice0shift_search_2_4(59 downto 59)) =
        1) /= slice0cost_pixels_first_2_0_count_19_value_2)) + as_number(((to_integer(slice0shift_search_2_4(58 downto
        58)) = 1) /= slice0cost_pixels_first_2_0_count_19_value_3));
      slice0cost_pixels_first_2_4_count_20 <= as_number(((to_integer(slice0shift_search_2_4(61 downto 61)) = 1) /=
        (to_integer(slice0shift_reference_2(61 downto 61)) = 1))) + as_number(((to_integer(slice0shift_search_2_4(60
        downto 60)) = 1) /= slice0cost_pixels_first_2_0_count_20_value));
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= slice0cost_pixels_first_0_0_count_7 + slice0cost_pixels_first_0_0_count_13 +
        slice0cost_pixels_first_0_0_count_10 + slice0cost_pixels_first_0_0_count_11 +
        slice0cost_pixels_first_0_0_count_6 + slice0cost_pixels_first_0_0_count_3 + slice0cost_pixels_first_0_0_count_4
        + slice0cost_pixels_first_0_0_count_5 + slice0cost_pixels_first_0_0_count_19 +
        slice0cost_pixels_first_0_0_count_0 + slice0cost_pixels_first_0_0_count_2 +
        slice0cost_pixels_first_0_0_count_15 + slice0cost_pixels_first_0_0_count_17 +
        slice0cost_pixels_first_0_0_count_12 + slice0cost_pixels_first_0_0_count_20 +
        slice0cost_pixels_first_0_0_count_9 + slice0cost_pixels_first_0_0_count_14 +
        slice0cost_pixels_first_0_0_count_8 + slice0cost_pixels_first_0_0_count_1 +
        slice0cost_pixels_first_0_0_count_16 + slice0cost_pixels_first_0_0_count_18;
      slice0cost_pixels_cost_0_1 <= slice0cost_pixels_first_0_1_count_7 + slice0cost_pixels_first_0_1_count_13 +
        slice0cost_pixels_first_0_1_count_10 + slice0cost_pixels_first_0_1_count_11 +
        slice0cost_pixels_first_0_1_count_6 + slice0cost_pixels_first_0_1_count_3 + slice0cost_pixels_first_0_1_count_4
        + slice0cost_pixels_first_0_1_count_5 + slice0cost_pixels_first_0_1_count_19 +
        slice0cost_pixels_first_0_1_count_0 + slice0cost_pixels_first_0_1_count_2 +
        slice0cost_pixels_first_0_1_count_15 + slice0cost_pixels_first_0_1_count_17 +
        slice0cost_pixels_first_0_1_count_12 + slice0cost_pixels_first_0_1_count_20 +
        slice0cost_pixels_first_0_1_count_9 + slice0cost_pixels_first_0_1_count_14 +
        slice0cost_pixels_first_0_1_count_8 + slice0cost_pixels_first_0_1_count_1 +
        slice0cost_pixels_first_0_1_count_16 + slice0cost_pixels_first_0_1_count_18;
      slice0cost_pixels_cost_0_2 <= slice0cost_pixels_first_0_2_count_7 + slice0cost_pixels_first_0_2_count_13 +
        slice0cost_pixels_first_0_2_count_10 + slice0cost_pixels_first_0_2_count_11 +
        slice0cost_pixels_first_0_2_count_6 + slice0cost_pixels_first_0_2_count_3 + slice0cost_pixels_first_0_2_count_4
        + slice0cost_pixels_first_0_2_count_5 + slice0cost_pixels_first_0_2_count_19 +
        slice0cost_pixels_first_0_2_count_0 + slice0cost_pixels_first_0_2_count_2 +
        slice0cost_pixels_first_0_2_count_15 + slice0cost_pixels_first_0_2_count_17 +
        slice0cost_pixels_first_0_2_count_12 + slice0cost_pixels_first_0_2_count_20 +
        slice0cost_pixels_first_0_2_count_9 + slice0cost_pixels_first_0_2_count_14 +
        slice0cost_pixels_first_0_2_count_8 + slice0cost_pixels_first_0_2_count_1 +
        slice0cost_pixels_first_0_2_count_16 + slice0cost_pixels_first_0_2_count_18;
      slice0cost_pixels_cost_0_3 <= slice0cost_pixels_first_0_3_count_7 + slice0cost_pixels_first_0_3_count_13 +
        slice0cost_pixels_first_0_3_count_10 + slice0cost_pixels_first_0_3_count_11 +
        slice0cost_pixels_first_0_3_count_6 + slice0cost_pixels_first_0_3_count_3 + slice0cost_pixels_first_0_3_count_4
        + slice0cost_pixels_first_0_3_count_5 + slice0cost_pixels_first_0_3_count_19 +
        slice0cost_pixels_first_0_3_count_0 + slice0cost_pixels_first_0_3_count_2 +
        slice0cost_pixels_first_0_3_count_15 + slice0cost_pixels_first_0_3_count_17 +
        slice0cost_pixels_first_0_3_count_12 + slice0cost_pixels_first_0_3_count_20 +
        slice0cost_pixels_first_0_3_count_9 + slice0cost_pixels_first_0_3_count_14 +
        slice0cost_pixels_first_0_3_count_8 + slice0cost_pixels_first_0_3_count_1 +
        slice0cost_pixels_first_0_3_count_16 + slice0cost_pixels_first_0_3_count_18;
      slice0cost_pixels_cost_0_4 <= slice0cost_pixels_first_0_4_count_7 + slice0cost_pixels_first_0_4_count_13 +
        slice0cost_pixels_first_0_4_count_10 + slice0cost_pixels_first_0_4_count_11 +
        slice0cost_pixels_first_0_4_count_6 + slice0cost_pixels_first_0_4_count_3 + slice0cost_pixels_first_0_4_count_4
        + slice0cost_pixels_first_0_4_count_5 + slice0cost_pixels_first_0_4_count_19 +
        slice0cost_pixels_first_0_4_count_0 + slice0cost_pixels_first_0_4_count_2 +
        slice0cost_pixels_first_0_4_count_15 + slice0cost_pixels_first_0_4_count_17 +
        slice0cost_pixels_first_0_4_count_12 + slice0cost_pixels_first_0_4_count_20 +
        slice0cost_pixels_first_0_4_count_9 + slice0cost_pixels_first_0_4_count_14 +
        slice0cost_pixels_first_0_4_count_8 + slice0cost_pixels_first_0_4_count_1 +
        slice0cost_pixels_first_0_4_count_16 + slice0cost_pixels_first_0_4_count_18;
      slice0cost_pixels_cost_1_0 <= slice0cost_pixels_first_1_0_count_7 + slice0cost_pixels_first_1_0_count_13 +
        slice0cost_pixels_first_1_0_count_10 + slice0cost_pixels_first_1_0_count_11 +
        slice0cost_pixels_first_1_0_count_6 + slice0cost_pixels_first_1_0_count_3 + slice0cost_pixels_first_1_0_count_4
        + slice0cost_pixels_first_1_0_count_5 + slice0cost_pixels_first_1_0_count_19 +
        slice0cost_pixels_first_1_0_count_0 + slice0cost_pixels_first_1_0_count_2 +
        slice0cost_pixels_first_1_0_count_15 + slice0cost_pixels_first_1_0_count_17 +
        slice0cost_pixels_first_1_0_count_12 + slice0cost_pixels_first_1_0_count_20 +
        slice0cost_pixels_first_1_0_count_9 + slice0cost_pixels_first_1_0_count_14 +
        slice0cost_pixels_first_1_0_count_8 + slice0cost_pixels_first_1_0_count_1 +
        slice0cost_pixels_first_1_0_count_16 + slice0cost_pixels_first_1_0_count_18;
      slice0cost_pixels_cost_1_1 <= slice0cost_pixels_first_1_1_count_7 + slice0cost_pixels_first_1_1_count_13 +
        slice0cost_pixels_first_1_1_count_10 + slice0cost_pixels_first_1_1_count_11 +
        slice0cost_pixels_first_1_1_count_6 + slice0cost_pixels_first_1_1_count_3 + slice0cost_pixels_first_1_1_count_4
        + slice0cost_pixels_first_1_1_count_5 + slice0cost_pixels_first_1_1_count_19 +
        slice0cost_pixels_first_1_1_count_0 + slice0cost_pixels_first_1_1_count_2 +
        slice0cost_pixels_first_1_1_count_15 + slice0cost_pixels_first_1_1_count_17 +
        slice0cost_pixels_first_1_1_count_12 + slice0cost_pixels_first_1_1_count_20 +
        slice0cost_pixels_first_1_1_count_9 + slice0cost_pixels_first_1_1_count_14 +
        slice0cost_pixels_first_1_1_count_8 + slice0cost_pixels_first_1_1_count_1 +
        slice0cost_pixels_first_1_1_count_16 + slice0cost_pixels_first_1_1_count_18;
      slice0cost_pixels_cost_1_2 <= slice0cost_pixels_first_1_2_count_7 + slice0cost_pixels_first_1_2_count_13 +
        slice0cost_pixels_first_1_2_count_10 + slice0cost_pixels_first_1_2_count_11 +
        slice0cost_pixels_first_1_2_count_6 + slice0cost_pixels_first_1_2_count_3 + slice0cost_pixels_first_1_2_count_4
        + slice0cost_pixels_first_1_2_count_5 + slice0cost_pixels_first_1_2_count_19 +
        slice0cost_pixels_first_1_2_count_0 + slice0cost_pixels_first_1_2_count_2 +
        slice0cost_pixels_first_1_2_count_15 + slice0cost_pixels_first_1_2_count_17 +
        slice0cost_pixels_first_1_2_count_12 + slice0cost_pixels_first_1_2_count_20 +
        slice0cost_pixels_first_1_2_count_9 + slice0cost_pixels_first_1_2_count_14 +
        slice0cost_pixels_first_1_2_count_8 + slice0cost_pixels_first_1_2_count_1 +
        slice0cost_pixels_first_1_2_count_16 + slice0cost_pixels_first_1_2_count_18;
      slice0cost_pixels_cost_1_3 <= slice0cost_pixels_first_1_3_count_7 + slice0cost_pixels_first_1_3_count_13 +
        slice0cost_pixels_first_1_3_count_10 + slice0cost_pixels_first_1_3_count_11 +
        slice0cost_pixels_first_1_3_count_6 + slice0cost_pixels_first_1_3_count_3 + slice0cost_pixels_first_1_3_count_4
        + slice0cost_pixels_first_1_3_count_5 + slice0cost_pixels_first_1_3_count_19 +
        slice0cost_pixels_first_1_3_count_0 + slice0cost_pixels_first_1_3_count_2 +
        slice0cost_pixels_first_1_3_count_15 + slice0cost_pixels_first_1_3_count_17 +
        slice0cost_pixels_first_1_3_count_12 + slice0cost_pixels_first_1_3_count_20 +
        slice0cost_pixels_first_1_3_count_9 + slice0cost_pixels_first_1_3_count_14 +
        slice0cost_pixels_first_1_3_count_8 + slice0cost_pixels_first_1_3_count_1 +
        slice0cost_pixels_first_1_3_count_16 + slice0cost_pixels_first_1_3_count_18;
      slice0cost_pixels_cost_1_4 <= slice0cost_pixels_first_1_4_count_7 + slice0cost_pixels_first_1_4_count_13 +
        slice0cost_pixels_first_1_4_count_10 + slice0cost_pixels_first_1_4_count_11 +
        slice0cost_pixels_first_1_4_count_6 + slice0cost_pixels_first_1_4_count_3 + slice0cost_pixels_first_1_4_count_4
        + slice0cost_pixels_first_1_4_count_5 + slice0cost_pixels_first_1_4_count_19 +
        slice0cost_pixels_first_1_4_count_0 + slice0cost_pixels_first_1_4_count_2 +
        slice0cost_pixels_first_1_4_count_15 + slice0cost_pixels_first_1_4_count_17 +
        slice0cost_pixels_first_1_4_count_12 + slice0cost_pixels_first_1_4_count_20 +
        slice0cost_pixels_first_1_4_count_9 + slice0cost_pixels_first_1_4_count_14 +
        slice0cost_pixels_first_1_4_count_8 + slice0cost_pixels_first_1_4_count_1 +
        slice0cost_pixels_first_1_4_count_16 + slice0cost_pixels_first_1_4_count_18;
      slice0cost_pixels_cost_2_0 <= slice0cost_pixels_first_2_0_count_7 + slice0cost_pixels_first_2_0_count_13 +
        slice0cost_pixels_first_2_0_count_10 + slice0cost_pixels_first_2_0_count_11 +
        slice0cost_pixels_first_2_0_count_6 + slice0cost_pixels_first_2_0_count_3 + slice0cost_pixels_first_2_0_count_4
        + slice0cost_pixels_first_2_0_count_5 + slice0cost_pixels_first_2_0_count_19 +
        slice0cost_pixels_first_2_0_count_0 + slice0cost_pixels_first_2_0_count_2 +
        slice0cost_pixels_first_2_0_count_15 + slice0cost_pixels_first_2_0_count_17 +
        slice0cost_pixels_first_2_0_count_12 + slice0cost_pixels_first_2_0_count_20 +
        slice0cost_pixels_first_2_0_count_9 + slice0cost_pixels_first_2_0_count_14 +
        slice0cost_pixels_first_2_0_count_8 + slice0cost_pixels_first_2_0_count_1 +
        slice0cost_pixels_first_2_0_count_16 + slice0cost_pixels_first_2_0_count_18;
      slice0cost_pixels_cost_2_1 <= slice0cost_pixels_first_2_1_count_7 + slice0cost_pixels_first_2_1_count_13 +
        slice0cost_pixels_first_2_1_count_10 + slice0cost_pixels_first_2_1_count_11 +
        slice0cost_pixels_first_2_1_count_6 + slice0cost_pixels_first_2_1_count_3 + slice0cost_pixels_first_2_1_count_4
        + slice0cost_pixels_first_2_1_count_5 + slice0cost_pixels_first_2_1_count_19 +
        slice0cost_pixels_first_2_1_count_0 + slice0cost_pixels_first_2_1_count_2 +
        slice0cost_pixels_first_2_1_count_15 + slice0cost_pixels_first_2_1_count_17 +
        slice0cost_pixels_first_2_1_count_12 + slice0cost_pixels_first_2_1_count_20 +
        slice0cost_pixels_first_2_1_count_9 + slice0cost_pixels_first_2_1_count_14 +
        slice0cost_pixels_first_2_1_count_8 + slice0cost_pixels_first_2_1_count_1 +
        slice0cost_pixels_first_2_1_count_16 + slice0cost_pixels_first_2_1_count_18;
      slice0cost_pixels_cost_2_2 <= slice0cost_pixels_first_2_2_count_7 + slice0cost_pixels_first_2_2_count_13 +
        slice0cost_pixels_first_2_2_count_10 + slice0cost_pixels_first_2_2_count_11 +
        slice0cost_pixels_first_2_2_count_6 + slice0cost_pixels_first_2_2_count_3 + slice0cost_pixels_first_2_2_count_4
        + slice0cost_pixels_first_2_2_count_5 + slice0cost_pixels_first_2_2_count_19 +
        slice0cost_pixels_first_2_2_count_0 + slice0cost_pixels_first_2_2_count_2 +
        slice0cost_pixels_first_2_2_count_15 + slice0cost_pixels_first_2_2_count_17 +
        slice0cost_pixels_first_2_2_count_12 + slice0cost_pixels_first_2_2_count_20 +
        slice0cost_pixels_first_2_2_count_9 + slice0cost_pixels_first_2_2_count_14 +
        slice0cost_pixels_first_2_2_count_8 + slice0cost_pixels_first_2_2_count_1 +
        slice0cost_pixels_first_2_2_count_16 + slice0cost_pixels_first_2_2_count_18;
      slice0cost_pixels_cost_2_3 <= slice0cost_pixels_first_2_3_count_7 + slice0cost_pixels_first_2_3_count_13 +
        slice0cost_pixels_first_2_3_count_10 + slice0cost_pixels_first_2_3_count_11 +
        slice0cost_pixels_first_2_3_count_6 + slice0cost_pixels_first_2_3_count_3 + slice0cost_pixels_first_2_3_count_4
        + slice0cost_pixels_first_2_3_count_5 + slice0cost_pixels_first_2_3_count_19 +
        slice0cost_pixels_first_2_3_count_0 + slice0cost_pixels_first_2_3_count_2 +
        slice0cost_pixels_first_2_3_count_15 + slice0cost_pixels_first_2_3_count_17 +
        slice0cost_pixels_first_2_3_count_12 + slice0cost_pixels_first_2_3_count_20 +
        slice0cost_pixels_first_2_3_count_9 + slice0cost_pixels_first_2_3_count_14 +
        slice0cost_pixels_first_2_3_count_8 + slice0cost_pixels_first_2_3_count_1 +
        slice0cost_pixels_first_2_3_count_16 + slice0cost_pixels_first_2_3_count_18;
      slice0cost_pixels_cost_2_4 <= slice0cost_pixels_first_2_4_count_7 + slice0cost_pixels_first_2_4_count_13 +
        slice0cost_pixels_first_2_4_count_10 + slice0cost_pixels_first_2_4_count_11 +
        slice0cost_pixels_first_2_4_count_6 + slice0cost_pixels_first_2_4_count_3 + slice0cost_pixels_first_2_4_count_4
        + slice0cost_pixels_first_2_4_count_5 + slice0cost_pixels_first_2_4_count_19 +
        slice0cost_pixels_first_2_4_count_0 + slice0cost_pixels_first_2_4_count_2 +
        slice0cost_pixels_first_2_4_count_15 + slice0cost_pixels_first_2_4_count_17 +
        slice0cost_pixels_first_2_4_count_12 + slice0cost_pixels_first_2_4_count_20 +
        slice0cost_pixels_first_2_4_count_9 + slice0cost_pixels_first_2_4_count_14 +
        slice0cost_pixels_first_2_4_count_8 + slice0cost_pixels_first_2_4_count_1 +
        slice0cost_pixels_first_2_4_count_16 + slice0cost_pixels_first_2_4_count_18;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
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
      slice0cost_pair_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
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
        slice0window_partial_0_1_0 <= slice0window_partial_0_0_0 + slice0cost_column_0_0;
        slice0window_partial_0_1_1 <= slice0window_partial_0_0_1 + slice0cost_column_0_1;
        slice0window_partial_0_1_2 <= slice0window_partial_0_0_2 + slice0cost_column_0_2;
        slice0window_partial_0_1_3 <= slice0window_partial_0_0_3 + slice0cost_column_0_3;
        slice0window_partial_0_1_4 <= slice0window_partial_0_0_4 + slice0cost_column_0_4;
        slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
        slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
        slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      end if;
      slice0window_sum_0_0 <= slice0window_partial_0_1_0 + slice0cost_column_0_0;
      slice0window_sum_0_1 <= slice0window_partial_0_1_1 + slice0cost_column_0_1;
      slice0window_sum_0_2 <= slice0window_partial_0_1_2 + slice0cost_column_0_2;
      slice0window_sum_0_3 <= slice0window_partial_0_1_3 + slice0cost_column_0_3;
      slice0window_sum_0_4 <= slice0window_partial_0_1_4 + slice0cost_column_0_4;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_output_column <= slice0window_centre_output_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
      -- slice0winner1
      slice0winner1_of_pair_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_of_pair_0_2_is_less := (slice0window_sum_0_3 - slice0window_sum_0_2) < 0;
      slice0winner1_of_four_0_0_is_less := (to_integer(((to_unsigned(slice0winner1_of_pair_0_2, 10)) or
        (to_unsigned(slice0winner1_of_pair_0_3, 10)))) - to_integer(((to_unsigned(slice0winner1_of_pair_0_0, 10)) or
        (to_unsigned(slice0winner1_of_pair_0_1, 10))))) < 0;
      slice0winner1_of_pair_0_4 <= slice0window_sum_0_4;
      slice0winner1_pair_index_0_0 <= slice0winner1_of_pair_0_0_is_less;
      slice0winner1_pair_index_0_2 <= 4;
      slice0winner1_pair_tag_valid <= slice0window_tag_valid;
      slice0winner1_pair_tag_output_column <= slice0window_tag_output_column;
      slice0winner1_pair_tag_start_of_frame <= slice0window_tag_start_of_frame;
      slice0winner1_pair_tag_end_of_line <= slice0window_tag_end_of_line;
      slice0winner1_of_four_0_4 <= slice0winner1_of_pair_0_4;
      slice0winner1_four_index_0_1 <= slice0winner1_pair_index_0_2;
      slice0winner1_four_tag_valid <= slice0winner1_pair_tag_valid;
      slice0winner1_four_tag_output_column <= slice0winner1_pair_tag_output_column;
      slice0winner1_four_tag_start_of_frame <= slice0winner1_pair_tag_start_of_frame;
      slice0winner1_four_tag_end_of_line <= slice0winner1_pair_tag_end_of_line;
      slice0winner1_best_cost_0_0 <= to_integer(((((((to_unsigned(slice0winner1_of_four_0_2, 10)) or
        (to_unsigned(slice0winner1_of_four_0_3, 10)))) or (to_unsigned(slice0winner1_of_four_0_1, 10)))) or
        (to_unsigned(slice0winner1_of_four_0_0, 10))));
      slice0winner1_best_cost_0_1 <= slice0winner1_of_four_0_4;
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
      -- slice0winner2
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      if (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0 then
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_0;
      end if;
      -- slice0
      slice0_best_index_0_0 <= slice0winner2_best_index_0_0;
      slice0_best_tag_valid <= slice0winner2_tag_valid;
      slice0_best_tag_output_column <= slice0winner2_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner2_tag_end_of_line;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 15;
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
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_output_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
