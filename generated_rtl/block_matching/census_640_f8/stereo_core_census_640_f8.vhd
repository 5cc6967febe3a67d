-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration census_640_f8: 640x480, 64 disparities, window 9x9, 1 pixel pair a clock.
-- Options: window_px 9, reference left, cost census, census_width_px 9, census_height_px 3,
--   left_right_threshold 1, uniqueness_percent 5, subpixel true, median true, aggregation recursive,
--   slice_disparities 16, clocks_per_pixel 8.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config census_640_f8
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_census_640_f8 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 576;
    latency_clocks : positive := 28;
    flush_groups : positive := 5061;
    gap_groups : positive := 2560
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
  assert width_px = 640 report "stereo_core_census_640_f8: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_census_640_f8: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 64 report "stereo_core_census_640_f8: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_census_640_f8: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_census_640_f8: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 576 report "stereo_core_census_640_f8: output_width_px is " & integer'image(output_width_px) & " but this core has 576" severity failure;
  assert latency_clocks = 28 report "stereo_core_census_640_f8: latency_clocks is " & integer'image(latency_clocks) & " but this core has 28" severity failure;
  assert flush_groups = 5061 report "stereo_core_census_640_f8: flush_groups is " & integer'image(flush_groups) & " but this core has 5061" severity failure;
  assert gap_groups = 2560 report "stereo_core_census_640_f8: gap_groups is " & integer'image(gap_groups) & " but this core has 2560" severity failure;
end entity;

architecture rtl of stereo_core_census_640_f8 is
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
  signal transform_left_column_2, transform_right_column_0, transform_right_column_1 : natural range 0 to 255;
  signal transform_right_column_2, transform_left_filter_column_0_0 : natural range 0 to 255;
  signal transform_left_filter_column_0_1, transform_left_filter_column_0_2 : natural range 0 to 255;
  signal transform_left_filter_column_1_0, transform_left_filter_column_1_1 : natural range 0 to 255;
  signal transform_left_filter_column_1_2, transform_left_filter_column_2_0 : natural range 0 to 255;
  signal transform_left_filter_column_2_1, transform_left_filter_column_2_2 : natural range 0 to 255;
  signal transform_left_filter_column_3_0, transform_left_filter_column_3_1 : natural range 0 to 255;
  signal transform_left_filter_column_3_2, transform_left_filter_column_4_0 : natural range 0 to 255;
  signal transform_left_filter_column_4_1, transform_left_filter_column_4_2 : natural range 0 to 255;
  signal transform_left_filter_column_5_0, transform_left_filter_column_5_1 : natural range 0 to 255;
  signal transform_left_filter_column_5_2, transform_left_filter_column_6_0 : natural range 0 to 255;
  signal transform_left_filter_column_6_1, transform_left_filter_column_6_2 : natural range 0 to 255;
  signal transform_left_filter_column_7_0, transform_left_filter_column_7_1 : natural range 0 to 255;
  signal transform_left_filter_column_7_2, transform_left_filter_column_8_0 : natural range 0 to 255;
  signal transform_left_filter_column_8_1, transform_left_filter_column_8_2 : natural range 0 to 255;
  signal transform_right_filter_column_0_0, transform_right_filter_column_0_1 : natural range 0 to 255;
  signal transform_right_filter_column_0_2, transform_right_filter_column_1_0 : natural range 0 to 255;
  signal transform_right_filter_column_1_1, transform_right_filter_column_1_2 : natural range 0 to 255;
  signal transform_right_filter_column_2_0, transform_right_filter_column_2_1 : natural range 0 to 255;
  signal transform_right_filter_column_2_2, transform_right_filter_column_3_0 : natural range 0 to 255;
  signal transform_right_filter_column_3_1, transform_right_filter_column_3_2 : natural range 0 to 255;
  signal transform_right_filter_column_4_0, transform_right_filter_column_4_1 : natural range 0 to 255;
  signal transform_right_filter_column_4_2, transform_right_filter_column_5_0 : natural range 0 to 255;
  signal transform_right_filter_column_5_1, transform_right_filter_column_5_2 : natural range 0 to 255;
  signal transform_right_filter_column_6_0, transform_right_filter_column_6_1 : natural range 0 to 255;
  signal transform_right_filter_column_6_2, transform_right_filter_column_7_0 : natural range 0 to 255;
  signal transform_right_filter_column_7_1, transform_right_filter_column_7_2 : natural range 0 to 255;
  signal transform_right_filter_column_8_0, transform_right_filter_column_8_1 : natural range 0 to 255;
  signal transform_right_filter_column_8_2 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_1, transform_read_row_inside_2, transform_read_column_inside_0 : boolean;
  signal transform_read_column_inside_1, transform_read_column_inside_2, transform_read_column_inside_3 : boolean;
  signal transform_read_column_inside_4, transform_read_column_inside_5, transform_read_column_inside_6 : boolean;
  signal transform_read_column_inside_7, transform_read_column_inside_8, transform_read_start_of_frame : boolean;
  signal transform_read_valid, transform_ready_row_inside_0, transform_ready_row_inside_1 : boolean;
  signal transform_ready_row_inside_2, transform_ready_column_inside_0, transform_ready_column_inside_1 : boolean;
  signal transform_ready_column_inside_2, transform_ready_column_inside_3, transform_ready_column_inside_4 : boolean;
  signal transform_ready_column_inside_5, transform_ready_column_inside_6, transform_ready_column_inside_7 : boolean;
  signal transform_ready_column_inside_8, transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_columns_row_inside_0, transform_columns_row_inside_1, transform_columns_row_inside_2 : boolean;
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
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 1023;
  signal transform_write_column : natural range 0 to 1023;
  signal transform_counter_group : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(15 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0 : natural range 0 to 65535;
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : natural range 0 to 65535;
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 67108863;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 67108863;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 67108863;
  signal delay_column : natural range 0 to 1023;
  signal delay_row_inside_0, delay_row_inside_1, delay_tag_valid, delay_tag_first_group : boolean;
  signal delay_tag_output_column, delay_tag_first_column, delay_tag_start_of_frame : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(25 downto 0);
  signal rows_search_rows_read_words_2, rows_search_rows_read_words_3 : unsigned(25 downto 0);
  signal rows_search_rows_read_words_4, rows_search_rows_read_words_5 : unsigned(25 downto 0);
  signal rows_search_rows_read_words_6, rows_search_rows_read_words_7 : unsigned(25 downto 0);
  signal rows_search_rows_read_words_8, rows_reference_rows_read_words_0 : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_1, rows_reference_rows_read_words_2 : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_3, rows_reference_rows_read_words_4 : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_5, rows_reference_rows_read_words_6 : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_7, rows_reference_rows_read_words_8 : unsigned(25 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_words_0 : natural range 0 to 67108863;
  signal rows_search_rows_ready_words_1, rows_search_rows_ready_words_2 : natural range 0 to 67108863;
  signal rows_search_rows_ready_words_3, rows_search_rows_ready_words_4 : natural range 0 to 67108863;
  signal rows_search_rows_ready_words_5, rows_search_rows_ready_words_6 : natural range 0 to 67108863;
  signal rows_search_rows_ready_words_7, rows_search_rows_ready_words_8 : natural range 0 to 67108863;
  signal rows_search_rows_ready_newest_0, rows_search_rows_write_words_0 : natural range 0 to 67108863;
  signal rows_search_rows_write_words_1, rows_search_rows_write_words_2 : natural range 0 to 67108863;
  signal rows_search_rows_write_words_3, rows_search_rows_write_words_4 : natural range 0 to 67108863;
  signal rows_search_rows_write_words_5, rows_search_rows_write_words_6 : natural range 0 to 67108863;
  signal rows_search_rows_write_words_7, rows_search_rows_write_words_8 : natural range 0 to 67108863;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_words_0 : natural range 0 to 67108863;
  signal rows_reference_rows_ready_words_1, rows_reference_rows_ready_words_2 : natural range 0 to 67108863;
  signal rows_reference_rows_ready_words_3, rows_reference_rows_ready_words_4 : natural range 0 to 67108863;
  signal rows_reference_rows_ready_words_5, rows_reference_rows_ready_words_6 : natural range 0 to 67108863;
  signal rows_reference_rows_ready_words_7, rows_reference_rows_ready_words_8 : natural range 0 to 67108863;
  signal rows_reference_rows_ready_newest_0, rows_reference_rows_write_words_0 : natural range 0 to 67108863;
  signal rows_reference_rows_write_words_1, rows_reference_rows_write_words_2 : natural range 0 to 67108863;
  signal rows_reference_rows_write_words_3, rows_reference_rows_write_words_4 : natural range 0 to 67108863;
  signal rows_reference_rows_write_words_5, rows_reference_rows_write_words_6 : natural range 0 to 67108863;
  signal rows_reference_rows_write_words_7, rows_reference_rows_write_words_8 : natural range 0 to 67108863;
  signal rows_search_0, rows_search_1, rows_reference_0, rows_reference_1 : natural range 0 to 67108863;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 1023;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_tag_valid, rows_read_tag_first_group : boolean;
  signal rows_read_tag_output_column, rows_read_tag_first_column, rows_read_tag_start_of_frame : boolean;
  signal rows_ready_inside_0, rows_ready_inside_1, rows_ready_tag_valid, rows_ready_tag_first_group : boolean;
  signal rows_ready_tag_output_column, rows_ready_tag_first_column, rows_ready_tag_start_of_frame : boolean;
  signal rows_tag_valid, rows_tag_first_group, rows_tag_output_column, rows_tag_first_column : boolean;
  signal rows_tag_start_of_frame : boolean;
  -- passes
  signal passes_row, passes_coming_first_group, passes_coming_output, passes_coming_starts, passes_row_ended : boolean;
  signal passes_arrived, passes_shows, passes_showing_first_group, passes_showing_output : boolean;
  signal passes_showing_starts, passes_pass_ends, passes_last_pass, passes_leaving_starts : boolean;
  signal passes_read_tag_valid, passes_read_tag_row_start, passes_read_tag_first_group : boolean;
  signal passes_read_tag_border_column, passes_read_tag_first_cost, passes_read_tag_leaves_window : boolean;
  signal passes_read_tag_map_column, passes_read_tag_output_column, passes_read_tag_first_column : boolean;
  signal passes_read_tag_end_of_line, passes_tag_valid, passes_tag_row_start, passes_tag_first_group : boolean;
  signal passes_tag_border_column, passes_tag_first_cost, passes_tag_leaves_window, passes_tag_map_column : boolean;
  signal passes_tag_output_column, passes_tag_first_column : boolean;
  signal passes_write_address, passes_search_address, passes_reference_address : natural range 0 to 2047;
  signal passes_write_search_0, passes_write_search_1, passes_write_reference_0 : natural range 0 to 67108863;
  signal passes_write_reference_1, passes_search_0, passes_search_1, passes_reference_0 : natural range 0 to 67108863;
  signal passes_reference_1 : natural range 0 to 67108863;
  signal passes_pass : natural range 0 to 7;
  signal passes_column : natural range 0 to 1023;
  signal passes_search_start : natural range 0 to 1016;
  signal passes_read_search_0, passes_read_search_1, passes_read_reference_0 : unsigned(25 downto 0);
  signal passes_read_reference_1 : unsigned(25 downto 0);
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 67108863;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 67108863;
  signal slice0shift_search_0_6, slice0shift_search_0_7, slice0shift_search_1_0 : natural range 0 to 67108863;
  signal slice0shift_search_1_1, slice0shift_search_1_2, slice0shift_search_1_3 : natural range 0 to 67108863;
  signal slice0shift_search_1_4, slice0shift_search_1_5, slice0shift_search_1_6 : natural range 0 to 67108863;
  signal slice0shift_search_1_7, slice0shift_reference_0, slice0shift_reference_1 : natural range 0 to 67108863;
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_first_column : boolean;
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
  signal slice0cost_pixels_first_0_0_count_8, slice0cost_pixels_first_0_1_count_8 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_2_count_8, slice0cost_pixels_first_0_3_count_8 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_4_count_8, slice0cost_pixels_first_0_5_count_8 : natural range 0 to 2;
  signal slice0cost_pixels_first_0_6_count_8, slice0cost_pixels_first_0_7_count_8 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_0_count_8, slice0cost_pixels_first_1_1_count_8 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_2_count_8, slice0cost_pixels_first_1_3_count_8 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_4_count_8, slice0cost_pixels_first_1_5_count_8 : natural range 0 to 2;
  signal slice0cost_pixels_first_1_6_count_8, slice0cost_pixels_first_1_7_count_8 : natural range 0 to 2;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_first_group : boolean;
  signal slice0cost_pixels_first_tag_border_column, slice0cost_pixels_first_tag_first_cost : boolean;
  signal slice0cost_pixels_first_tag_leaves_window, slice0cost_pixels_first_tag_map_column : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_first_column : boolean;
  signal slice0cost_pixels_tag_valid, slice0cost_pixels_tag_first_group, slice0cost_pixels_tag_border_column : boolean;
  signal slice0cost_pixels_tag_first_cost, slice0cost_pixels_tag_leaves_window : boolean;
  signal slice0cost_pixels_tag_map_column, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_first_column, slice0cost_ready_tag_valid, slice0cost_ready_tag_first_group : boolean;
  signal slice0cost_ready_tag_border_column, slice0cost_ready_tag_first_cost : boolean;
  signal slice0cost_ready_tag_leaves_window, slice0cost_ready_tag_map_column : boolean;
  signal slice0cost_ready_tag_output_column, slice0cost_ready_tag_first_column, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_first_cost, slice0cost_tag_leaves_window, slice0cost_tag_map_column : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_first_column : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 26;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_0_5 : natural range 0 to 26;
  signal slice0cost_pixels_cost_0_6, slice0cost_pixels_cost_0_7, slice0cost_pixels_cost_1_0 : natural range 0 to 26;
  signal slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2, slice0cost_pixels_cost_1_3 : natural range 0 to 26;
  signal slice0cost_pixels_cost_1_4, slice0cost_pixels_cost_1_5, slice0cost_pixels_cost_1_6 : natural range 0 to 26;
  signal slice0cost_pixels_cost_1_7 : natural range 0 to 26;
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 8191;
  signal slice0cost_write_column : natural range 0 to 8191;
  signal slice0cost_read_words_0, slice0cost_read_words_1, slice0cost_read_words_2 : unsigned(15 downto 0);
  signal slice0cost_read_words_3 : unsigned(15 downto 0);
  signal slice0cost_change_0_0, slice0cost_change_0_1, slice0cost_change_0_2 : integer range -26 to 26;
  signal slice0cost_change_0_3, slice0cost_change_0_4, slice0cost_change_0_5 : integer range -26 to 26;
  signal slice0cost_change_0_6, slice0cost_change_0_7 : integer range -26 to 26;
  signal slice0cost_ready_words_0, slice0cost_ready_words_1, slice0cost_ready_words_2 : natural range 0 to 65535;
  signal slice0cost_ready_words_3, slice0cost_write_words_0, slice0cost_write_words_1 : natural range 0 to 65535;
  signal slice0cost_write_words_2, slice0cost_write_words_3 : natural range 0 to 65535;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 255;
  signal slice0cost_column_0_3, slice0cost_column_0_4, slice0cost_column_0_5 : natural range 0 to 255;
  signal slice0cost_column_0_6, slice0cost_column_0_7 : natural range 0 to 255;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving_0, slice0window_leaving_1 : unsigned(31 downto 0);
  signal slice0window_entering_0_0, slice0window_entering_0_1, slice0window_entering_0_2 : natural range 0 to 255;
  signal slice0window_entering_0_3, slice0window_entering_0_4, slice0window_entering_0_5 : natural range 0 to 255;
  signal slice0window_entering_0_6, slice0window_entering_0_7 : natural range 0 to 255;
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_map_column : boolean;
  signal slice0window_entering_tag_output_column, slice0window_entering_tag_first_column : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_map_column, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_first_column, slice0window_centre_map_column_0 : boolean;
  signal slice0window_centre_map_column_1, slice0window_centre_map_column_2, slice0window_centre_map_column_3 : boolean;
  signal slice0window_centre_output_column_0, slice0window_centre_output_column_1 : boolean;
  signal slice0window_centre_output_column_2, slice0window_centre_output_column_3 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_first_column_1 : boolean;
  signal slice0window_centre_first_column_2, slice0window_centre_first_column_3, slice0window_tag_valid : boolean;
  signal slice0window_tag_map_column, slice0window_tag_output_column, slice0window_tag_first_column : boolean;
  signal slice0window_change_0_0, slice0window_change_0_1, slice0window_change_0_2 : integer range -255 to 255;
  signal slice0window_change_0_3, slice0window_change_0_4, slice0window_change_0_5 : integer range -255 to 255;
  signal slice0window_change_0_6, slice0window_change_0_7 : integer range -255 to 255;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 4095;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 4095;
  signal slice0window_sum_0_6, slice0window_sum_0_7 : natural range 0 to 4095;
  -- slice0other
  signal slice0other_cost_0_0, slice0other_cost_0_1, slice0other_cost_0_2 : natural range 0 to 4095;
  signal slice0other_cost_0_3, slice0other_cost_0_4, slice0other_cost_0_5 : natural range 0 to 4095;
  signal slice0other_cost_0_6, slice0other_cost_0_7, slice0other_cost_out_0 : natural range 0 to 4095;
  signal slice0other_winner_0_1 : boolean;
  signal slice0other_winner_0_2 : natural range 0 to 2;
  signal slice0other_winner_0_3 : natural range 0 to 3;
  signal slice0other_winner_0_4 : natural range 0 to 4;
  signal slice0other_winner_0_5 : natural range 0 to 5;
  signal slice0other_winner_0_6 : natural range 0 to 6;
  signal slice0other_winner_0_7 : natural range 0 to 7;
  -- slice0winner1
  signal slice0winner1_held_0_0, slice0winner1_held_0_1, slice0winner1_held_0_2 : natural range 0 to 4095;
  signal slice0winner1_held_0_3, slice0winner1_held_0_4, slice0winner1_held_0_5 : natural range 0 to 4095;
  signal slice0winner1_held_0_6, slice0winner1_held_0_7, slice0winner1_best_cost_0_0 : natural range 0 to 4095;
  signal slice0winner1_best_cost_0_1, slice0winner1_best_cost_0_2 : natural range 0 to 4095;
  signal slice0winner1_best_cost_0_3, slice0winner1_best_below_0_0 : natural range 0 to 4095;
  signal slice0winner1_best_below_0_1, slice0winner1_best_below_0_2 : natural range 0 to 4095;
  signal slice0winner1_best_below_0_3, slice0winner1_best_above_0_0 : natural range 0 to 4095;
  signal slice0winner1_best_above_0_1, slice0winner1_best_above_0_2 : natural range 0 to 4095;
  signal slice0winner1_best_above_0_3, slice0winner1_best_late_cost_0_0 : natural range 0 to 4095;
  signal slice0winner1_best_late_cost_0_1, slice0winner1_best_late_cost_0_2 : natural range 0 to 4095;
  signal slice0winner1_best_late_cost_0_3, slice0winner1_best_but_first_0_0 : natural range 0 to 4095;
  signal slice0winner1_best_but_first_0_1, slice0winner1_best_but_first_0_2 : natural range 0 to 4095;
  signal slice0winner1_best_but_first_0_3, slice0winner1_best_but_last_0_0 : natural range 0 to 4095;
  signal slice0winner1_best_but_last_0_1, slice0winner1_best_but_last_0_2 : natural range 0 to 4095;
  signal slice0winner1_best_but_last_0_3 : natural range 0 to 4095;
  signal slice0winner1_best_index_0_0, slice0winner1_best_place_0_2, slice0winner1_tag_valid : boolean;
  signal slice0winner1_tag_map_column, slice0winner1_tag_first_column : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_below_0_0, slice0winner2_best_below_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_above_0_0, slice0winner2_best_above_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_first_0_0, slice0winner2_best_first_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_last_0_0, slice0winner2_best_last_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_late_cost_0_0, slice0winner2_best_late_cost_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_second_0_0, slice0winner2_best_second_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_but_first_0_0, slice0winner2_best_but_first_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_but_last_0_0, slice0winner2_best_but_last_0_1 : natural range 0 to 4095;
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_place_0_0, slice0winner2_best_place_0_1, slice0winner2_best_at_start_0_0 : boolean;
  signal slice0winner2_best_at_start_0_1, slice0winner2_best_at_end_0_0, slice0winner2_best_at_end_0_1 : boolean;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_first_column : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_below_0_0 : natural range 0 to 4095;
  signal slice0winner3_best_above_0_0, slice0winner3_best_first_0_0 : natural range 0 to 4095;
  signal slice0winner3_best_last_0_0, slice0winner3_best_late_cost_0_0 : natural range 0 to 4095;
  signal slice0winner3_best_second_0_0, slice0winner3_best_but_first_0_0 : natural range 0 to 4095;
  signal slice0winner3_best_but_last_0_0 : natural range 0 to 4095;
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_place_0_0, slice0winner3_best_at_start_0_0, slice0winner3_best_at_end_0_0 : boolean;
  signal slice0winner3_tag_valid, slice0winner3_tag_map_column, slice0winner3_tag_first_column : boolean;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 7;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_first_0_0 : natural range 0 to 4095;
  signal slice0_best_last_0_0, slice0_best_late_cost_0_0, slice0_best_second_0_0 : natural range 0 to 4095;
  signal slice0_best_but_first_0_0, slice0_best_but_last_0_0 : natural range 0 to 4095;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_first_column : boolean;
  -- best
  signal best_read_index_0_0, best_waiting_index_0_0, best_ready_index_0_0, best_pass : natural range 0 to 7;
  signal best_read_below_0_0, best_read_above_0_0, best_read_first_0_0, best_read_last_0_0 : natural range 0 to 4095;
  signal best_read_late_cost_0_0, best_read_second_0_0, best_read_but_first_0_0 : natural range 0 to 4095;
  signal best_read_but_last_0_0, best_waiting_below_0_0, best_waiting_above_0_0 : natural range 0 to 4095;
  signal best_waiting_first_0_0, best_waiting_last_0_0, best_waiting_late_cost_0_0 : natural range 0 to 4095;
  signal best_waiting_second_0_0, best_waiting_but_first_0_0, best_waiting_but_last_0_0 : natural range 0 to 4095;
  signal best_ready_below_0_0, best_ready_above_0_0, best_ready_first_0_0 : natural range 0 to 4095;
  signal best_ready_last_0_0, best_ready_late_cost_0_0, best_ready_second_0_0 : natural range 0 to 4095;
  signal best_ready_but_first_0_0, best_ready_but_last_0_0, best_ready_words_2 : natural range 0 to 4095;
  signal best_compared_below_0_0, best_compared_above_0_0, best_compared_first_0_0 : natural range 0 to 4095;
  signal best_compared_last_0_0, best_compared_late_cost_0_0, best_compared_second_0_0 : natural range 0 to 4095;
  signal best_compared_but_first_0_0, best_compared_but_last_0_0, best_compared_words_2 : natural range 0 to 4095;
  signal best_best_cost_0_0, best_best_below_0_0, best_best_above_0_0, best_best_last_0_0 : natural range 0 to 4095;
  signal best_best_late_cost_0_0, best_best_second_0_0, best_best_but_last_0_0 : natural range 0 to 4095;
  signal best_kept_cost : natural range 0 to 4095;
  signal best_read_tag_valid, best_read_tag_map_column, best_read_tag_first_column, best_waiting_tag_valid : boolean;
  signal best_waiting_tag_map_column, best_waiting_tag_first_column, best_ready_tag_valid : boolean;
  signal best_ready_tag_map_column, best_ready_tag_first_column, best_compared_tag_valid : boolean;
  signal best_compared_tag_map_column, best_compared_tag_first_column, best_first_pass, best_last_pass : boolean;
  signal best_here_wins, best_here_is_first, best_before_is_last, best_best_place_0_0, best_best_at_start_0_0 : boolean;
  signal best_best_at_end_0_0, best_best_tag_valid, best_best_tag_map_column, best_best_tag_first_column : boolean;
  signal best_was_first : boolean;
  signal best_column, best_late_column, best_place_column, best_write_column : natural range 0 to 1023;
  signal best_late_write_column : natural range 0 to 1023;
  signal best_read_words_0 : unsigned(19 downto 0);
  signal best_read_words_1, best_read_losers_0 : unsigned(23 downto 0);
  signal best_read_words_2 : unsigned(11 downto 0);
  signal best_ready_words_0 : natural range 0 to 1048575;
  signal best_ready_words_1, best_ready_losers_0, best_compared_words_1 : natural range 0 to 16777215;
  signal best_compared_losers_0 : natural range 0 to 16777215;
  signal best_base, best_compared_index_0_0, best_best_index_0_0 : natural range 0 to 255;
  signal best_last_before : natural range 7 to 255;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 255;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 255;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 255;
  signal refinement_disparity_9_0, refinement_disparity_10_0, refinement_disparity_11_0 : natural range 0 to 255;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  signal refinement_passed_0_0, refinement_passed_1_0, refinement_passed_2_0, refinement_passed_3_0 : boolean;
  signal refinement_passed_4_0, refinement_passed_5_0, refinement_passed_6_0, refinement_passed_7_0 : boolean;
  signal refinement_passed_8_0, refinement_passed_9_0, refinement_passed_10_0, refinement_passed_11_0 : boolean;
  signal refinement_tag_0_valid, refinement_tag_0_map_column, refinement_tag_0_first_column : boolean;
  signal refinement_tag_1_valid, refinement_tag_1_map_column, refinement_tag_1_first_column : boolean;
  signal refinement_tag_2_valid, refinement_tag_2_map_column, refinement_tag_2_first_column : boolean;
  signal refinement_tag_3_valid, refinement_tag_3_map_column, refinement_tag_3_first_column : boolean;
  signal refinement_tag_4_valid, refinement_tag_4_map_column, refinement_tag_4_first_column : boolean;
  signal refinement_tag_5_valid, refinement_tag_5_map_column, refinement_tag_5_first_column : boolean;
  signal refinement_tag_6_valid, refinement_tag_6_map_column, refinement_tag_6_first_column : boolean;
  signal refinement_tag_7_valid, refinement_tag_7_map_column, refinement_tag_7_first_column : boolean;
  signal refinement_tag_8_valid, refinement_tag_8_map_column, refinement_tag_8_first_column : boolean;
  signal refinement_tag_9_valid, refinement_tag_9_map_column, refinement_tag_9_first_column : boolean;
  signal refinement_tag_10_valid, refinement_tag_10_map_column, refinement_tag_10_first_column : boolean;
  signal refinement_tag_11_valid, refinement_tag_11_map_column, refinement_tag_11_first_column : boolean;
  signal refinement_alone_0_0, refinement_alone_1_0, refinement_negative_0_0, refinement_negative_1_0 : boolean;
  signal refinement_negative_2_0, refinement_negative_3_0, refinement_negative_4_0, refinement_negative_5_0 : boolean;
  signal refinement_negative_6_0, refinement_negative_7_0, refinement_negative_8_0 : boolean;
  signal refinement_gap_0, refinement_lowest_0, refinement_scaled_cost_0, refinement_below_0 : natural range 0 to 4095;
  signal refinement_above_0, refinement_u_0, refinement_v_0, refinement_remainder_0_0 : natural range 0 to 4095;
  signal refinement_remainder_1_0, refinement_remainder_2_0, refinement_remainder_3_0 : natural range 0 to 4095;
  signal refinement_remainder_4_0, refinement_remainder_5_0, refinement_remainder_6_0 : natural range 0 to 4095;
  signal refinement_remainder_7_0, refinement_divisor_0_0, refinement_divisor_1_0 : natural range 0 to 4095;
  signal refinement_divisor_2_0, refinement_divisor_3_0, refinement_divisor_4_0 : natural range 0 to 4095;
  signal refinement_divisor_5_0, refinement_divisor_6_0, refinement_divisor_7_0 : natural range 0 to 4095;
  signal refinement_scaled_gap_0 : natural range 0 to 81900;
  signal refinement_difference_0 : integer range -4095 to 4095;
  -- winners
  signal winners_row, winners_read_tag_valid, winners_read_tag_map_column, winners_read_tag_start_of_frame : boolean;
  signal winners_read_tag_end_of_line, winners_winners_passed_0, winners_winners_tag_valid : boolean;
  signal winners_winners_tag_map_column, winners_winners_tag_start_of_frame, winners_winners_tag_end_of_line : boolean;
  signal winners_column : natural range 0 to 1023;
  signal winners_write_address, winners_read_address, winners_address_out : natural range 0 to 2047;
  signal winners_write_word_0 : natural range 0 to 4095;
  signal winners_read_word_0 : unsigned(11 downto 0);
  signal winners_winners_disparity_0 : natural range 0 to 63;
  signal winners_winners_fraction_0 : natural range 0 to 31;
  -- check
  signal check_read_winner, check_base, check_waiting_winner, check_ready_winner, check_winner : natural range 0 to 255;
  signal check_read_place, check_columns, check_waiting_place, check_ready_place : natural range 0 to 1023;
  signal check_write_place : natural range 0 to 1023;
  signal check_read_counts, check_read_has_before, check_read_row, check_waiting_counts : boolean;
  signal check_waiting_has_before, check_waiting_row, check_ready_counts, check_ready_has_before : boolean;
  signal check_ready_row, check_asking_passed_0, check_asking_tag_valid, check_asking_tag_map_column : boolean;
  signal check_asking_tag_start_of_frame, check_asking_tag_end_of_line, check_answered_passed_0 : boolean;
  signal check_answered_tag_valid, check_answered_tag_map_column, check_answered_tag_start_of_frame : boolean;
  signal check_answered_tag_end_of_line, check_checked_passed_0, check_checked_tag_valid : boolean;
  signal check_checked_tag_row_start, check_checked_tag_map_column, check_checked_tag_start_of_frame : boolean;
  signal check_checked_tag_end_of_line : boolean;
  signal check_pass : natural range 0 to 7;
  signal check_first : natural range 0 to 1016;
  signal check_waiting_cost, check_ready_cost, check_cost : natural range 0 to 4095;
  signal check_read_words_0 : unsigned(19 downto 0);
  signal check_ready_words_0 : natural range 0 to 1048575;
  signal check_write_address, check_address : natural range 0 to 2047;
  signal check_asking_disparity_0, check_answered_disparity_0, check_checked_disparity_0 : natural range 0 to 63;
  signal check_asking_fraction_0, check_answered_fraction_0, check_checked_fraction_0 : natural range 0 to 31;
  signal check_found_0 : unsigned(7 downto 0);
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column : natural range 0 to 1023;
  signal map_sorted_column : natural range 0 to 1023;
  signal map_counter_group : natural range 0 to 511;
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
  signal other_0, other_2 : unsigned(48 downto 0);
  signal other_1 : natural range 0 to 8190;
  signal other_3 : natural range 0 to 67108863;
  signal other_4 : unsigned(25 downto 0);
  signal other_5 : natural range 0 to 255;
  signal other_6 : natural range 0 to 254;
  signal other_7 : natural range 0 to 252;
  signal other_8 : natural range 0 to 248;
  signal other_9 : natural range 0 to 240;
  signal other_10 : natural range 0 to 224;
  signal other_11 : natural range 0 to 192;
  signal other_12 : natural range 0 to 128;
  signal other_13 : natural range 0 to 4095;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal other_4_memory_read_enable : boolean;
  signal other_4_memory_read_address : unsigned(9 downto 0);
  signal other_4_memory_write_address : unsigned(9 downto 0);
  signal other_4_memory_write_data : unsigned(25 downto 0);
  signal check_read_words_0_memory_read_enable : boolean;
  signal check_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal check_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal check_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal check_found_0_memory_read_enable : boolean;
  signal check_found_0_memory_read_address : unsigned(10 downto 0);
  signal check_found_0_memory_write_address : unsigned(10 downto 0);
  signal check_found_0_memory_write_data : unsigned(7 downto 0);
  signal winners_read_word_0_memory_read_enable : boolean;
  signal winners_read_word_0_memory_read_address : unsigned(10 downto 0);
  signal winners_read_word_0_memory_write_address : unsigned(10 downto 0);
  signal winners_read_word_0_memory_write_data : unsigned(11 downto 0);
  signal best_read_words_2_memory_read_enable : boolean;
  signal best_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal best_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal best_read_words_2_memory_write_data : unsigned(11 downto 0);
  signal best_read_words_1_memory_read_enable : boolean;
  signal best_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal best_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal best_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal best_read_words_0_memory_read_enable : boolean;
  signal best_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal best_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal best_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal best_read_losers_0_memory_read_enable : boolean;
  signal best_read_losers_0_memory_read_address : unsigned(9 downto 0);
  signal best_read_losers_0_memory_write_address : unsigned(9 downto 0);
  signal best_read_losers_0_memory_write_data : unsigned(23 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_3_memory_read_enable : boolean;
  signal slice0cost_read_words_3_memory_read_address : unsigned(12 downto 0);
  signal slice0cost_read_words_3_memory_write_address : unsigned(12 downto 0);
  signal slice0cost_read_words_3_memory_write_data : unsigned(15 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(12 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(12 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(15 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(12 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(12 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(15 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(12 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(12 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal passes_read_search_1_memory_read_enable : boolean;
  signal passes_read_search_1_memory_read_address : unsigned(10 downto 0);
  signal passes_read_search_1_memory_write_address : unsigned(10 downto 0);
  signal passes_read_search_1_memory_write_data : unsigned(25 downto 0);
  signal passes_read_search_0_memory_read_enable : boolean;
  signal passes_read_search_0_memory_read_address : unsigned(10 downto 0);
  signal passes_read_search_0_memory_write_address : unsigned(10 downto 0);
  signal passes_read_search_0_memory_write_data : unsigned(25 downto 0);
  signal passes_read_reference_1_memory_read_enable : boolean;
  signal passes_read_reference_1_memory_read_address : unsigned(10 downto 0);
  signal passes_read_reference_1_memory_write_address : unsigned(10 downto 0);
  signal passes_read_reference_1_memory_write_data : unsigned(25 downto 0);
  signal passes_read_reference_0_memory_read_enable : boolean;
  signal passes_read_reference_0_memory_read_address : unsigned(10 downto 0);
  signal passes_read_reference_0_memory_write_address : unsigned(10 downto 0);
  signal passes_read_reference_0_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_8_memory_read_enable : boolean;
  signal rows_search_rows_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_8_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_7_memory_read_enable : boolean;
  signal rows_search_rows_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_7_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_6_memory_read_enable : boolean;
  signal rows_search_rows_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_6_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_5_memory_read_enable : boolean;
  signal rows_search_rows_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_5_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_4_memory_read_enable : boolean;
  signal rows_search_rows_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_4_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_3_memory_read_enable : boolean;
  signal rows_search_rows_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_3_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_2_memory_read_enable : boolean;
  signal rows_search_rows_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_2_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(25 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_8_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_8_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_7_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_7_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_6_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_6_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_5_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_5_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_4_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_4_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_3_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_2_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(25 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(25 downto 0);

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
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 10);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 10);
  transform_left_rows_read_words_0_memory_write_data <= to_unsigned(transform_left_rows_write_words_0, 16);
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 10);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 10);
  transform_right_rows_read_words_0_memory_write_data <= to_unsigned(transform_right_rows_write_words_0, 16);
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  other_4_memory_read_enable <= true;
  other_4_memory_read_address <= to_unsigned(map_counter_column, 10);
  other_4_memory_write_address <= to_unsigned(map_at_column, 10);
  other_4_memory_write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
  other_4_memory : entity work.line_memory
    generic map (depth => 576, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => other_4_memory_read_enable,
      read_address => other_4_memory_read_address, read_data => other_4,
      write_address => other_4_memory_write_address, write_data => other_4_memory_write_data);

  check_read_words_0_memory_read_enable <= true;
  check_read_words_0_memory_read_address <= to_unsigned(check_read_place, 10);
  check_read_words_0_memory_write_address <= to_unsigned(check_write_place, 10);
  check_read_words_0_memory_write_data <= to_unsigned(check_winner, 8) & to_unsigned(check_cost, 12);
  check_read_words_0_memory : entity work.line_memory
    generic map (depth => 1024, width => 20, address_bits => 10)
    port map (
      clock => clock, read_enable => check_read_words_0_memory_read_enable,
      read_address => check_read_words_0_memory_read_address, read_data => check_read_words_0,
      write_address => check_read_words_0_memory_write_address, write_data => check_read_words_0_memory_write_data);

  check_found_0_memory_read_enable <= true;
  check_found_0_memory_read_address <= to_unsigned(check_address, 11);
  check_found_0_memory_write_address <= to_unsigned(check_write_address, 11);
  check_found_0_memory_write_data <= to_unsigned(check_winner, 8);
  check_found_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => check_found_0_memory_read_enable,
      read_address => check_found_0_memory_read_address, read_data => check_found_0,
      write_address => check_found_0_memory_write_address, write_data => check_found_0_memory_write_data);

  winners_read_word_0_memory_read_enable <= true;
  winners_read_word_0_memory_read_address <= to_unsigned(passes_write_address, 11);
  winners_read_word_0_memory_write_address <= to_unsigned(winners_write_address, 11);
  winners_read_word_0_memory_write_data <= to_unsigned(winners_write_word_0, 12);
  winners_read_word_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 12, address_bits => 11)
    port map (
      clock => clock, read_enable => winners_read_word_0_memory_read_enable,
      read_address => winners_read_word_0_memory_read_address, read_data => winners_read_word_0,
      write_address => winners_read_word_0_memory_write_address, write_data => winners_read_word_0_memory_write_data);

  best_read_words_2_memory_read_enable <= true;
  best_read_words_2_memory_read_address <= to_unsigned(best_column, 10);
  best_read_words_2_memory_write_address <= to_unsigned(best_write_column, 10);
  best_read_words_2_memory_write_data <= to_unsigned(best_best_last_0_0, 12);
  best_read_words_2_memory : entity work.line_memory
    generic map (depth => 1024, width => 12, address_bits => 10)
    port map (
      clock => clock, read_enable => best_read_words_2_memory_read_enable,
      read_address => best_read_words_2_memory_read_address, read_data => best_read_words_2,
      write_address => best_read_words_2_memory_write_address, write_data => best_read_words_2_memory_write_data);

  best_read_words_1_memory_read_enable <= true;
  best_read_words_1_memory_read_address <= to_unsigned(best_column, 10);
  best_read_words_1_memory_write_address <= to_unsigned(best_write_column, 10);
  best_read_words_1_memory_write_data <= to_unsigned(best_best_above_0_0, 12) & to_unsigned(best_best_below_0_0, 12);
  best_read_words_1_memory : entity work.line_memory
    generic map (depth => 1024, width => 24, address_bits => 10)
    port map (
      clock => clock, read_enable => best_read_words_1_memory_read_enable,
      read_address => best_read_words_1_memory_read_address, read_data => best_read_words_1,
      write_address => best_read_words_1_memory_write_address, write_data => best_read_words_1_memory_write_data);

  best_read_words_0_memory_read_enable <= true;
  best_read_words_0_memory_read_address <= to_unsigned(best_column, 10);
  best_read_words_0_memory_write_address <= to_unsigned(best_write_column, 10);
  best_read_words_0_memory_write_data <= to_unsigned(best_best_index_0_0, 8) & to_unsigned(best_best_cost_0_0, 12);
  best_read_words_0_memory : entity work.line_memory
    generic map (depth => 1024, width => 20, address_bits => 10)
    port map (
      clock => clock, read_enable => best_read_words_0_memory_read_enable,
      read_address => best_read_words_0_memory_read_address, read_data => best_read_words_0,
      write_address => best_read_words_0_memory_write_address, write_data => best_read_words_0_memory_write_data);

  best_read_losers_0_memory_read_enable <= true;
  best_read_losers_0_memory_read_address <= to_unsigned(best_late_column, 10);
  best_read_losers_0_memory_write_address <= to_unsigned(best_late_write_column, 10);
  best_read_losers_0_memory_write_data <= to_unsigned(best_best_but_last_0_0, 12) & to_unsigned(best_best_second_0_0, 12);
  best_read_losers_0_memory : entity work.line_memory
    generic map (depth => 1024, width => 24, address_bits => 10)
    port map (
      clock => clock, read_enable => best_read_losers_0_memory_read_enable,
      read_address => best_read_losers_0_memory_read_address, read_data => best_read_losers_0,
      write_address => best_read_losers_0_memory_write_address, write_data => best_read_losers_0_memory_write_data);

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
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 13);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice0cost_write_column, 13);
  slice0cost_read_words_3_memory_write_data <= to_unsigned(slice0cost_write_words_3, 16);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 4711, width => 16, address_bits => 13)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words_3,
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 13);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice0cost_write_column, 13);
  slice0cost_read_words_2_memory_write_data <= to_unsigned(slice0cost_write_words_2, 16);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 4711, width => 16, address_bits => 13)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words_2,
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 13);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice0cost_write_column, 13);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words_1, 16);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 4711, width => 16, address_bits => 13)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words_1,
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 13);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice0cost_write_column, 13);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words_0, 16);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 4711, width => 16, address_bits => 13)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words_0,
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  passes_read_search_1_memory_read_enable <= true;
  passes_read_search_1_memory_read_address <= to_unsigned(passes_search_address, 11);
  passes_read_search_1_memory_write_address <= to_unsigned(passes_write_address, 11);
  passes_read_search_1_memory_write_data <= to_unsigned(passes_write_search_1, 26);
  passes_read_search_1_memory : entity work.line_memory
    generic map (depth => 2048, width => 26, address_bits => 11)
    port map (
      clock => clock, read_enable => passes_read_search_1_memory_read_enable,
      read_address => passes_read_search_1_memory_read_address, read_data => passes_read_search_1,
      write_address => passes_read_search_1_memory_write_address, write_data => passes_read_search_1_memory_write_data);

  passes_read_search_0_memory_read_enable <= true;
  passes_read_search_0_memory_read_address <= to_unsigned(passes_search_address, 11);
  passes_read_search_0_memory_write_address <= to_unsigned(passes_write_address, 11);
  passes_read_search_0_memory_write_data <= to_unsigned(passes_write_search_0, 26);
  passes_read_search_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 26, address_bits => 11)
    port map (
      clock => clock, read_enable => passes_read_search_0_memory_read_enable,
      read_address => passes_read_search_0_memory_read_address, read_data => passes_read_search_0,
      write_address => passes_read_search_0_memory_write_address, write_data => passes_read_search_0_memory_write_data);

  passes_read_reference_1_memory_read_enable <= true;
  passes_read_reference_1_memory_read_address <= to_unsigned(passes_reference_address, 11);
  passes_read_reference_1_memory_write_address <= to_unsigned(passes_write_address, 11);
  passes_read_reference_1_memory_write_data <= to_unsigned(passes_write_reference_1, 26);
  passes_read_reference_1_memory : entity work.line_memory
    generic map (depth => 2048, width => 26, address_bits => 11)
    port map (
      clock => clock, read_enable => passes_read_reference_1_memory_read_enable,
      read_address => passes_read_reference_1_memory_read_address, read_data => passes_read_reference_1,
      write_address => passes_read_reference_1_memory_write_address, write_data => passes_read_reference_1_memory_write_data);

  passes_read_reference_0_memory_read_enable <= true;
  passes_read_reference_0_memory_read_address <= to_unsigned(passes_reference_address, 11);
  passes_read_reference_0_memory_write_address <= to_unsigned(passes_write_address, 11);
  passes_read_reference_0_memory_write_data <= to_unsigned(passes_write_reference_0, 26);
  passes_read_reference_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 26, address_bits => 11)
    port map (
      clock => clock, read_enable => passes_read_reference_0_memory_read_enable,
      read_address => passes_read_reference_0_memory_read_address, read_data => passes_read_reference_0,
      write_address => passes_read_reference_0_memory_write_address, write_data => passes_read_reference_0_memory_write_data);

  rows_search_rows_read_words_8_memory_read_enable <= true;
  rows_search_rows_read_words_8_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_8_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_8_memory_write_data <= to_unsigned(rows_search_rows_write_words_8, 26);
  rows_search_rows_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_8_memory_read_enable,
      read_address => rows_search_rows_read_words_8_memory_read_address, read_data => rows_search_rows_read_words_8,
      write_address => rows_search_rows_read_words_8_memory_write_address, write_data => rows_search_rows_read_words_8_memory_write_data);

  rows_search_rows_read_words_7_memory_read_enable <= true;
  rows_search_rows_read_words_7_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_7_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_7_memory_write_data <= to_unsigned(rows_search_rows_write_words_7, 26);
  rows_search_rows_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_7_memory_read_enable,
      read_address => rows_search_rows_read_words_7_memory_read_address, read_data => rows_search_rows_read_words_7,
      write_address => rows_search_rows_read_words_7_memory_write_address, write_data => rows_search_rows_read_words_7_memory_write_data);

  rows_search_rows_read_words_6_memory_read_enable <= true;
  rows_search_rows_read_words_6_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_6_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_6_memory_write_data <= to_unsigned(rows_search_rows_write_words_6, 26);
  rows_search_rows_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_6_memory_read_enable,
      read_address => rows_search_rows_read_words_6_memory_read_address, read_data => rows_search_rows_read_words_6,
      write_address => rows_search_rows_read_words_6_memory_write_address, write_data => rows_search_rows_read_words_6_memory_write_data);

  rows_search_rows_read_words_5_memory_read_enable <= true;
  rows_search_rows_read_words_5_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_5_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_5_memory_write_data <= to_unsigned(rows_search_rows_write_words_5, 26);
  rows_search_rows_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_5_memory_read_enable,
      read_address => rows_search_rows_read_words_5_memory_read_address, read_data => rows_search_rows_read_words_5,
      write_address => rows_search_rows_read_words_5_memory_write_address, write_data => rows_search_rows_read_words_5_memory_write_data);

  rows_search_rows_read_words_4_memory_read_enable <= true;
  rows_search_rows_read_words_4_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_4_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_4_memory_write_data <= to_unsigned(rows_search_rows_write_words_4, 26);
  rows_search_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_4_memory_read_enable,
      read_address => rows_search_rows_read_words_4_memory_read_address, read_data => rows_search_rows_read_words_4,
      write_address => rows_search_rows_read_words_4_memory_write_address, write_data => rows_search_rows_read_words_4_memory_write_data);

  rows_search_rows_read_words_3_memory_read_enable <= true;
  rows_search_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_3_memory_write_data <= to_unsigned(rows_search_rows_write_words_3, 26);
  rows_search_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_3_memory_read_enable,
      read_address => rows_search_rows_read_words_3_memory_read_address, read_data => rows_search_rows_read_words_3,
      write_address => rows_search_rows_read_words_3_memory_write_address, write_data => rows_search_rows_read_words_3_memory_write_data);

  rows_search_rows_read_words_2_memory_read_enable <= true;
  rows_search_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words_2, 26);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words_2,
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words_1, 26);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 26);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_8_memory_read_enable <= true;
  rows_reference_rows_read_words_8_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_8_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_8_memory_write_data <= to_unsigned(rows_reference_rows_write_words_8, 26);
  rows_reference_rows_read_words_8_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_8_memory_read_enable,
      read_address => rows_reference_rows_read_words_8_memory_read_address, read_data => rows_reference_rows_read_words_8,
      write_address => rows_reference_rows_read_words_8_memory_write_address, write_data => rows_reference_rows_read_words_8_memory_write_data);

  rows_reference_rows_read_words_7_memory_read_enable <= true;
  rows_reference_rows_read_words_7_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_7_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_7_memory_write_data <= to_unsigned(rows_reference_rows_write_words_7, 26);
  rows_reference_rows_read_words_7_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_7_memory_read_enable,
      read_address => rows_reference_rows_read_words_7_memory_read_address, read_data => rows_reference_rows_read_words_7,
      write_address => rows_reference_rows_read_words_7_memory_write_address, write_data => rows_reference_rows_read_words_7_memory_write_data);

  rows_reference_rows_read_words_6_memory_read_enable <= true;
  rows_reference_rows_read_words_6_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_6_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_6_memory_write_data <= to_unsigned(rows_reference_rows_write_words_6, 26);
  rows_reference_rows_read_words_6_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_6_memory_read_enable,
      read_address => rows_reference_rows_read_words_6_memory_read_address, read_data => rows_reference_rows_read_words_6,
      write_address => rows_reference_rows_read_words_6_memory_write_address, write_data => rows_reference_rows_read_words_6_memory_write_data);

  rows_reference_rows_read_words_5_memory_read_enable <= true;
  rows_reference_rows_read_words_5_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_5_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_5_memory_write_data <= to_unsigned(rows_reference_rows_write_words_5, 26);
  rows_reference_rows_read_words_5_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_5_memory_read_enable,
      read_address => rows_reference_rows_read_words_5_memory_read_address, read_data => rows_reference_rows_read_words_5,
      write_address => rows_reference_rows_read_words_5_memory_write_address, write_data => rows_reference_rows_read_words_5_memory_write_data);

  rows_reference_rows_read_words_4_memory_read_enable <= true;
  rows_reference_rows_read_words_4_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_4_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_4_memory_write_data <= to_unsigned(rows_reference_rows_write_words_4, 26);
  rows_reference_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_4_memory_read_enable,
      read_address => rows_reference_rows_read_words_4_memory_read_address, read_data => rows_reference_rows_read_words_4,
      write_address => rows_reference_rows_read_words_4_memory_write_address, write_data => rows_reference_rows_read_words_4_memory_write_data);

  rows_reference_rows_read_words_3_memory_read_enable <= true;
  rows_reference_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_3_memory_write_data <= to_unsigned(rows_reference_rows_write_words_3, 26);
  rows_reference_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_3_memory_read_enable,
      read_address => rows_reference_rows_read_words_3_memory_read_address, read_data => rows_reference_rows_read_words_3,
      write_address => rows_reference_rows_read_words_3_memory_write_address, write_data => rows_reference_rows_read_words_3_memory_write_data);

  rows_reference_rows_read_words_2_memory_read_enable <= true;
  rows_reference_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words_2, 26);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words_2,
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 26);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 26);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 26, address_bits => 10)
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
    variable transform_left_filter_feature_0_choice_194, transform_left_filter_feature_0_value_7 : boolean;
    variable transform_left_filter_feature_0_choice_195, transform_left_filter_feature_0_value_8 : boolean;
    variable transform_left_filter_feature_0_choice_196, transform_left_filter_feature_0_value_9 : boolean;
    variable transform_left_filter_feature_0_choice_197, transform_left_filter_feature_0_value_10 : boolean;
    variable transform_left_filter_feature_0_choice_198, transform_left_filter_feature_0_value_11 : boolean;
    variable transform_left_filter_feature_0_choice_199, transform_left_filter_feature_0_choice_200 : boolean;
    variable transform_left_filter_feature_0_choice_205, transform_left_filter_feature_0_choice_206 : boolean;
    variable transform_left_filter_feature_0_choice_207, transform_left_filter_feature_0_choice_208 : boolean;
    variable transform_left_filter_feature_0_choice_209, transform_left_filter_feature_0_choice_210 : boolean;
    variable transform_left_filter_feature_0_choice_211, transform_left_filter_feature_0_choice_212 : boolean;
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
    variable transform_right_filter_feature_0_value_7, transform_right_filter_feature_0_choice_195 : boolean;
    variable transform_right_filter_feature_0_value_8, transform_right_filter_feature_0_choice_196 : boolean;
    variable transform_right_filter_feature_0_value_9, transform_right_filter_feature_0_choice_197 : boolean;
    variable transform_right_filter_feature_0_value_10, transform_right_filter_feature_0_choice_198 : boolean;
    variable transform_right_filter_feature_0_value_11, transform_right_filter_feature_0_choice_199 : boolean;
    variable transform_right_filter_feature_0_choice_200, transform_right_filter_feature_0_choice_205 : boolean;
    variable transform_right_filter_feature_0_choice_206, transform_right_filter_feature_0_choice_207 : boolean;
    variable transform_right_filter_feature_0_choice_208, transform_right_filter_feature_0_choice_209 : boolean;
    variable transform_right_filter_feature_0_choice_210, transform_right_filter_feature_0_choice_211 : boolean;
    variable transform_right_filter_feature_0_choice_212, transform_counter_next_frame_choice : boolean;
    variable transform_counter_next_frame_choice_2, raster_place_group_is_equal : boolean;
    variable delay_tag_first_column_is_equal, passes_row_is_equal, passes_coming_first_group_choice : boolean;
    variable passes_coming_first_group_choice_2, passes_coming_output_choice, passes_coming_output_choice_2 : boolean;
    variable passes_coming_starts_choice, passes_coming_starts_choice_2, passes_row_ended_all : boolean;
    variable passes_shows_any, passes_showing_first_group_differs, passes_showing_output_choice : boolean;
    variable passes_showing_output_choice_2, passes_leaving_starts_choice, passes_leaving_starts_choice_2 : boolean;
    variable passes_read_tag_leaves_window_differs, passes_read_tag_map_column_is_equal : boolean;
    variable passes_read_tag_map_column_choice, slice0cost_pixels_first_0_0_count_0_value : boolean;
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
    variable slice0cost_pixels_first_0_0_count_7_value_3, slice0cost_pixels_first_0_0_count_8_value : boolean;
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
    variable slice0cost_pixels_first_1_0_count_7_value_2, slice0cost_pixels_first_1_0_count_7_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_count_8_value, slice0other_cost_0_1_all, slice0other_cost_0_1_choice : boolean;
    variable slice0other_cost_0_2_choice, slice0other_cost_0_3_choice, slice0other_cost_0_4_choice : boolean;
    variable slice0other_cost_0_5_choice, slice0other_cost_0_6_choice, slice0other_cost_0_7_all : boolean;
    variable slice0winner1_best_cost_0_0_is_less, slice0winner1_best_cost_0_1_is_less : boolean;
    variable slice0winner1_best_cost_0_2_is_less, slice0winner1_best_cost_0_3_is_less : boolean;
    variable slice0winner2_best_cost_0_0_is_less, slice0winner2_best_cost_0_1_is_less : boolean;
    variable slice0winner2_best_below_0_0_is_equal, slice0winner2_best_below_0_1_is_equal : boolean;
    variable slice0winner3_best_cost_0_0_is_less, slice0winner3_best_below_0_0_is_equal : boolean;
    variable slice0winner3_best_above_0_0_is_equal, best_base_any, best_base_is_equal : boolean;
    variable best_first_pass_is_equal, best_before_is_last_value, best_before_is_last_choice : boolean;
    variable best_before_is_last_choice_2, best_before_is_last_choice_3, best_before_is_last_value_2 : boolean;
    variable best_before_is_last_choice_4, best_before_is_last_choice_5, best_before_is_last_choice_6 : boolean;
    variable best_before_is_last_choice_7, refinement_divisor_0_0_is_less, winners_row_differs : boolean;
    variable winners_column_any, check_read_winner_all, check_read_winner_all_2, check_read_has_before_choice : boolean;
    variable check_read_has_before_choice_2, check_read_has_before_is_less, check_read_has_before_value : boolean;
    variable check_read_has_before_choice_3, check_read_has_before_choice_4, check_read_has_before_choice_5 : boolean;
    variable check_read_has_before_choice_6, check_read_has_before_choice_7, check_cost_any : boolean;
    variable check_checked_tag_row_start_differs, check_checked_tag_row_start_is_equal : boolean;
    variable check_checked_tag_row_start_choice, check_checked_tag_row_start_choice_2 : boolean;
    variable check_checked_tag_row_start_is_equal_2, check_checked_tag_row_start_all : boolean;
    variable check_checked_tag_row_start_choice_3, check_checked_tag_row_start_all_2 : boolean;
    variable map_counter_group_is_equal, map_line_ended_choice, map_at_arrives_value : boolean;
    variable map_window_complete_is_equal, map_window_complete_choice, map_low_1_0_all, map_low_0_0_all : boolean;
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 511;
    variable transform_left_filter_feature_0_choice_203 : natural range 0 to 511;
    variable transform_right_filter_feature_0_choice_203, map_counter_group_choice_2 : natural range 0 to 511;
    variable map_counter_group_choice_3 : natural range 0 to 511;
    variable transform_left_filter_feature_0_choice_201 : natural range 0 to 7;
    variable transform_right_filter_feature_0_choice_201, refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable transform_left_filter_feature_0_choice_202 : natural range 0 to 63;
    variable transform_right_filter_feature_0_choice_202 : natural range 0 to 63;
    variable transform_left_filter_feature_0_choice_204 : natural range 0 to 4095;
    variable transform_right_filter_feature_0_choice_204, slice0window_sum_0_0_choice : natural range 0 to 4095;
    variable slice0window_sum_0_1_choice, slice0window_sum_0_2_choice : natural range 0 to 4095;
    variable slice0window_sum_0_3_choice, slice0window_sum_0_4_choice : natural range 0 to 4095;
    variable slice0window_sum_0_5_choice, slice0window_sum_0_6_choice : natural range 0 to 4095;
    variable slice0window_sum_0_7_choice, slice0winner2_best_below_0_0_choice : natural range 0 to 4095;
    variable slice0winner2_best_below_0_1_choice, slice0winner2_best_above_0_0_choice : natural range 0 to 4095;
    variable slice0winner2_best_above_0_1_choice, slice0winner2_best_second_0_0_choice : natural range 0 to 4095;
    variable slice0winner2_best_second_0_0_choice_2, slice0winner2_best_second_0_0_choice_3 : natural range 0 to 4095;
    variable slice0winner2_best_second_0_0_choice_4, slice0winner2_best_second_0_1_choice : natural range 0 to 4095;
    variable slice0winner2_best_second_0_1_choice_2, slice0winner2_best_second_0_1_choice_3 : natural range 0 to 4095;
    variable slice0winner2_best_second_0_1_choice_4, slice0winner3_best_below_0_0_choice : natural range 0 to 4095;
    variable slice0winner3_best_above_0_0_choice, slice0winner3_best_second_0_0_choice : natural range 0 to 4095;
    variable slice0winner3_best_second_0_0_choice_2, slice0winner3_best_second_0_0_choice_3 : natural range 0 to 4095;
    variable slice0winner3_best_second_0_0_choice_4, best_best_below_0_0_choice : natural range 0 to 4095;
    variable best_best_above_0_0_choice, best_best_second_0_0_choice : natural range 0 to 4095;
    variable best_best_second_0_0_choice_2, best_best_second_0_0_choice_4 : natural range 0 to 4095;
    variable best_best_second_0_0_choice_5, best_best_second_0_0_choice_6 : natural range 0 to 4095;
    variable refinement_divisor_0_0_choice, map_of_column_0_a_choice : natural range 0 to 4095;
    variable transform_left_filter_feature_0_choice_213 : natural range 0 to 8191;
    variable transform_right_filter_feature_0_choice_213 : natural range 0 to 8191;
    variable transform_left_filter_feature_0_choice_214 : natural range 0 to 131071;
    variable transform_right_filter_feature_0_choice_214 : natural range 0 to 131071;
    variable transform_left_filter_feature_0_choice_215 : natural range 0 to 1048575;
    variable transform_right_filter_feature_0_choice_215 : natural range 0 to 1048575;
    variable transform_left_filter_feature_0_choice_216 : natural range 0 to 8388607;
    variable transform_right_filter_feature_0_choice_216 : natural range 0 to 8388607;
    variable passes_pass_ends_choice : natural range 586 to 593;
    variable passes_search_start_choice, passes_search_start_choice_2 : natural range 0 to 127;
    variable passes_search_address_choice, check_read_place_choice, check_first_choice : natural range 0 to 127;
    variable passes_search_address_value, check_read_counts_sum, check_read_counts_choice : natural range 0 to 1024;
    variable passes_search_address_choice_2, passes_reference_address_choice : natural range 0 to 1023;
    variable best_write_column_choice, best_write_column_choice_2, winners_column_choice : natural range 0 to 1023;
    variable check_write_place_choice : natural range 0 to 1023;
    variable slice0cost_column_0_0_choice, slice0cost_column_0_0_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_1_choice, slice0cost_column_0_1_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_2_choice, slice0cost_column_0_2_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_3_choice, slice0cost_column_0_3_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_4_choice, slice0cost_column_0_4_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_5_choice, slice0cost_column_0_5_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_6_choice, slice0cost_column_0_6_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_7_choice, slice0cost_column_0_7_choice_2 : natural range 0 to 255;
    variable slice0window_change_0_0_choice, slice0window_change_0_1_choice : natural range 0 to 255;
    variable slice0window_change_0_2_choice, slice0window_change_0_3_choice : natural range 0 to 255;
    variable slice0window_change_0_4_choice, slice0window_change_0_5_choice : natural range 0 to 255;
    variable slice0window_change_0_6_choice, slice0window_change_0_7_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable best_base_choice, best_base_choice_2, check_read_winner_choice : natural range 0 to 31;
    variable check_read_winner_choice_2 : natural range 0 to 31;
    variable best_before_is_last_value_3, best_before_is_last_value_4 : natural range 0 to 3;
    variable best_best_second_0_0_choice_3 : unsigned(59 downto 0);
    variable refinement_remainder_1_0_difference : natural range 4097 to 12287;
    variable refinement_remainder_2_0_difference, refinement_remainder_3_0_difference : natural range 4097 to 16382;
    variable refinement_remainder_4_0_difference, refinement_remainder_5_0_difference : natural range 4097 to 16382;
    variable refinement_remainder_6_0_difference, refinement_remainder_7_0_difference : natural range 4097 to 16382;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable check_read_has_before_sum : natural range 1 to 8;
    variable check_checked_passed_0_difference : integer range -254 to 64;
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
      transform_counter_group_is_equal := transform_counter_group = 479;
      transform_counter_group_is_equal_2 := transform_counter_column = 639;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 15;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_differs := transform_counter_group /= 481;
      if (transform_counter_group = 480) and transform_counter_next_frame then
        transform_counter_group_choice_2 := 1;
      else
        transform_counter_group_choice_2 := (transform_counter_group + 1) mod 512;
      end if;
      if transform_counter_group_differs and in_valid and transform_counter_group_is_equal_2 then
        transform_counter_group_choice_3 := transform_counter_group_choice_2;
      else
        transform_counter_group_choice_3 := transform_counter_group;
      end if;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
      transform_left_filter_feature_0_value := ((transform_left_filter_column_4_1 / 2) mod 2) = 1;
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        ((transform_left_filter_column_4_1 mod 2) = 1));
      if (transform_left_filter_column_8_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_4_1 mod 4) = 0;
      if ((transform_left_filter_column_8_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choice_2 := ((transform_left_filter_column_8_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_2 := ((transform_left_filter_column_4_1 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_2 then
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_3 := ((transform_left_filter_column_4_1 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_3 then
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_4 := ((transform_left_filter_column_4_1 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_4 then
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_5 := ((transform_left_filter_column_4_1 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_5 then
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_6 := ((transform_left_filter_column_4_1 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_6 then
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_7 then
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_8_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_8_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
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
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_8_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
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
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_24 := ((transform_left_filter_column_8_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_25 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_25 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_26 := transform_left_filter_feature_0_choice_25;
      else
        transform_left_filter_feature_0_choice_26 := ((transform_left_filter_column_7_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_26 then
        transform_left_filter_feature_0_choice_27 := (not (((transform_left_filter_column_7_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_27 := (not (((transform_left_filter_column_7_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_27 then
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_7_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_7_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_28 then
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_7_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_7_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_29 then
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_7_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_7_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_30 then
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_7_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_7_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_31 then
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_7_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_7_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_33 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_33 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_34 := transform_left_filter_feature_0_choice_33;
      else
        transform_left_filter_feature_0_choice_34 := ((transform_left_filter_column_7_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_34 then
        transform_left_filter_feature_0_choice_35 := (not (((transform_left_filter_column_7_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_35 := (not (((transform_left_filter_column_7_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_35 then
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_7_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_7_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_36 then
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_7_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_7_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_37 then
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_7_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_7_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_38 then
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_7_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_7_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_39 then
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_7_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_7_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_7_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_41 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_41 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_7_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_42 := transform_left_filter_feature_0_choice_41;
      else
        transform_left_filter_feature_0_choice_42 := ((transform_left_filter_column_7_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_42 then
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_7_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_7_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_43 then
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_7_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_7_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_44 then
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_7_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_7_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_45 then
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_7_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_7_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_46 then
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_7_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_7_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_47 then
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_7_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_7_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_49 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_49 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_50 := transform_left_filter_feature_0_choice_49;
      else
        transform_left_filter_feature_0_choice_50 := ((transform_left_filter_column_6_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_50 then
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_51 then
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_52 then
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_53 then
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_54 then
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_55 then
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_6_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_6_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_57 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_57 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_58 := transform_left_filter_feature_0_choice_57;
      else
        transform_left_filter_feature_0_choice_58 := ((transform_left_filter_column_6_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_58 then
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_59 then
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_60 then
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_61 then
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_62 then
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_63 then
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_6_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_6_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_6_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_65 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_65 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_6_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_66 := transform_left_filter_feature_0_choice_65;
      else
        transform_left_filter_feature_0_choice_66 := ((transform_left_filter_column_6_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_66 then
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_67 then
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_68 then
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_69 then
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_70 then
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_71 then
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_6_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_6_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_73 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_73 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_74 := transform_left_filter_feature_0_choice_73;
      else
        transform_left_filter_feature_0_choice_74 := ((transform_left_filter_column_5_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_74 then
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_5_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_5_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_75 then
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_5_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_5_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_76 then
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_5_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_5_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_77 then
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_5_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_5_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_78 then
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_5_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_5_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_79 then
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_5_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_5_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_81 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_81 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_82 := transform_left_filter_feature_0_choice_81;
      else
        transform_left_filter_feature_0_choice_82 := ((transform_left_filter_column_5_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_82 then
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_83 then
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_84 then
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_85 then
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_86 then
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_87 then
        transform_left_filter_feature_0_choice_88 := ((transform_left_filter_column_5_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_88 := ((transform_left_filter_column_5_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_5_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_89 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_89 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_5_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_90 := transform_left_filter_feature_0_choice_89;
      else
        transform_left_filter_feature_0_choice_90 := ((transform_left_filter_column_5_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_90 then
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_91 then
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_92 then
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_93 then
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_94 then
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_95 then
        transform_left_filter_feature_0_choice_96 := ((transform_left_filter_column_5_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_96 := ((transform_left_filter_column_5_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_97 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_97 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_98 := transform_left_filter_feature_0_choice_97;
      else
        transform_left_filter_feature_0_choice_98 := ((transform_left_filter_column_4_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_98 then
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_99 then
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_100 then
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_101 then
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_102 then
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_103 then
        transform_left_filter_feature_0_choice_104 := transform_filtering_0_column_inside_4 and
          ((transform_left_filter_column_4_2 / 128) = 1) and (not ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_104 := transform_filtering_0_column_inside_4 and
          (((transform_left_filter_column_4_2 / 128) = 1) or (not ((transform_left_filter_column_4_1 / 128) = 1)));
      end if;
      if (transform_left_filter_column_3_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_105 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_105 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_106 := transform_left_filter_feature_0_choice_105;
      else
        transform_left_filter_feature_0_choice_106 := ((transform_left_filter_column_3_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_106 then
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_107 then
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_108 then
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_109 then
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_110 then
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_111 then
        transform_left_filter_feature_0_choice_112 := ((transform_left_filter_column_3_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_112 := ((transform_left_filter_column_3_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_113 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_113 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_114 := transform_left_filter_feature_0_choice_113;
      else
        transform_left_filter_feature_0_choice_114 := ((transform_left_filter_column_3_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_114 then
        transform_left_filter_feature_0_choice_115 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_115 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_115 then
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_116 then
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_117 then
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_118 then
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_119 then
        transform_left_filter_feature_0_choice_120 := ((transform_left_filter_column_3_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_120 := ((transform_left_filter_column_3_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_121 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_121 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_122 := transform_left_filter_feature_0_choice_121;
      else
        transform_left_filter_feature_0_choice_122 := ((transform_left_filter_column_3_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_122 then
        transform_left_filter_feature_0_choice_123 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_123 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_123 then
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_124 then
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_125 then
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_126 then
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_127 then
        transform_left_filter_feature_0_choice_128 := ((transform_left_filter_column_3_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_128 := ((transform_left_filter_column_3_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_129 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_129 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_130 := transform_left_filter_feature_0_choice_129;
      else
        transform_left_filter_feature_0_choice_130 := ((transform_left_filter_column_2_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_130 then
        transform_left_filter_feature_0_choice_131 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_131 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_131 then
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_132 then
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_133 then
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_134 then
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_135 then
        transform_left_filter_feature_0_choice_136 := ((transform_left_filter_column_2_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_136 := ((transform_left_filter_column_2_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_137 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_137 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_138 := transform_left_filter_feature_0_choice_137;
      else
        transform_left_filter_feature_0_choice_138 := ((transform_left_filter_column_2_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_138 then
        transform_left_filter_feature_0_choice_139 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_139 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_139 then
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_140 then
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_141 then
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_142 then
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_143 then
        transform_left_filter_feature_0_choice_144 := ((transform_left_filter_column_2_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_144 := ((transform_left_filter_column_2_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_145 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_145 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_146 := transform_left_filter_feature_0_choice_145;
      else
        transform_left_filter_feature_0_choice_146 := ((transform_left_filter_column_2_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_146 then
        transform_left_filter_feature_0_choice_147 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_147 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_147 then
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_148 then
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_149 then
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_150 then
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_151 then
        transform_left_filter_feature_0_choice_152 := ((transform_left_filter_column_2_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_152 := ((transform_left_filter_column_2_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_153 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_153 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_154 := transform_left_filter_feature_0_choice_153;
      else
        transform_left_filter_feature_0_choice_154 := ((transform_left_filter_column_1_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_154 then
        transform_left_filter_feature_0_choice_155 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_155 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_155 then
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_156 then
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_157 then
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_158 then
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_159 then
        transform_left_filter_feature_0_choice_160 := ((transform_left_filter_column_1_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_160 := ((transform_left_filter_column_1_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_161 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_161 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_162 := transform_left_filter_feature_0_choice_161;
      else
        transform_left_filter_feature_0_choice_162 := ((transform_left_filter_column_1_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_162 then
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_163 then
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_164 then
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_165 then
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_166 then
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_167 then
        transform_left_filter_feature_0_choice_168 := ((transform_left_filter_column_1_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_168 := ((transform_left_filter_column_1_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_169 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_169 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_170 := transform_left_filter_feature_0_choice_169;
      else
        transform_left_filter_feature_0_choice_170 := ((transform_left_filter_column_1_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_170 then
        transform_left_filter_feature_0_choice_171 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_171 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_171 then
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_172 then
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_173 then
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_174 then
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_175 then
        transform_left_filter_feature_0_choice_176 := ((transform_left_filter_column_1_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_176 := ((transform_left_filter_column_1_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_177 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_177 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_178 := transform_left_filter_feature_0_choice_177;
      else
        transform_left_filter_feature_0_choice_178 := ((transform_left_filter_column_0_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_178 then
        transform_left_filter_feature_0_choice_179 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_179 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_179 then
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_180 then
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_181 then
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_182 then
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_183 then
        transform_left_filter_feature_0_choice_184 := ((transform_left_filter_column_0_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_184 := ((transform_left_filter_column_0_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_185 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_185 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_186 := transform_left_filter_feature_0_choice_185;
      else
        transform_left_filter_feature_0_choice_186 := ((transform_left_filter_column_0_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_186 then
        transform_left_filter_feature_0_choice_187 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_187 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_187 then
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_188 then
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_189 then
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_190 then
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_191 then
        transform_left_filter_feature_0_choice_192 := ((transform_left_filter_column_0_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_192 := ((transform_left_filter_column_0_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_193 := not (((transform_left_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_left_filter_feature_0_choice_193 := (transform_left_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value then
        transform_left_filter_feature_0_choice_194 := ((transform_left_filter_column_4_1 mod 2) = 1) or (not
          (((transform_left_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_left_filter_column_0_0 mod 2) = 1));
      else
        transform_left_filter_feature_0_choice_194 := transform_left_filter_feature_0_choice_193;
      end if;
      transform_left_filter_feature_0_value_7 := ((transform_left_filter_column_0_0 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_194 then
        transform_left_filter_feature_0_choice_195 := (not transform_left_filter_feature_0_value_2) and
          transform_left_filter_feature_0_value_7;
      else
        transform_left_filter_feature_0_choice_195 := (not transform_left_filter_feature_0_value_2) or
          transform_left_filter_feature_0_value_7;
      end if;
      transform_left_filter_feature_0_value_8 := ((transform_left_filter_column_0_0 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_195 then
        transform_left_filter_feature_0_choice_196 := (not transform_left_filter_feature_0_value_3) or
          transform_left_filter_feature_0_value_8;
      else
        transform_left_filter_feature_0_choice_196 := (not transform_left_filter_feature_0_value_3) and
          transform_left_filter_feature_0_value_8;
      end if;
      transform_left_filter_feature_0_value_9 := ((transform_left_filter_column_0_0 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_196 then
        transform_left_filter_feature_0_choice_197 := (not transform_left_filter_feature_0_value_4) or
          transform_left_filter_feature_0_value_9;
      else
        transform_left_filter_feature_0_choice_197 := (not transform_left_filter_feature_0_value_4) and
          transform_left_filter_feature_0_value_9;
      end if;
      transform_left_filter_feature_0_value_10 := ((transform_left_filter_column_0_0 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_197 then
        transform_left_filter_feature_0_choice_198 := (not transform_left_filter_feature_0_value_5) or
          transform_left_filter_feature_0_value_10;
      else
        transform_left_filter_feature_0_choice_198 := (not transform_left_filter_feature_0_value_5) and
          transform_left_filter_feature_0_value_10;
      end if;
      transform_left_filter_feature_0_value_11 := ((transform_left_filter_column_0_0 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_198 then
        transform_left_filter_feature_0_choice_199 := (not transform_left_filter_feature_0_value_6) or
          transform_left_filter_feature_0_value_11;
      else
        transform_left_filter_feature_0_choice_199 := (not transform_left_filter_feature_0_value_6) and
          transform_left_filter_feature_0_value_11;
      end if;
      if transform_left_filter_feature_0_choice_199 then
        transform_left_filter_feature_0_choice_200 := (not ((transform_left_filter_column_4_1 / 128) = 1)) or
          ((transform_left_filter_column_0_0 / 128) = 1);
      else
        transform_left_filter_feature_0_choice_200 := (not ((transform_left_filter_column_4_1 / 128) = 1)) and
          ((transform_left_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_left_filter_feature_0_choice_201 := (as_number(transform_left_filter_feature_0_choice_184) * 2) +
          (as_number(transform_left_filter_feature_0_choice_192) * 4) +
          as_number(transform_left_filter_feature_0_choice_200);
      else
        transform_left_filter_feature_0_choice_201 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_left_filter_feature_0_choice_202 := (as_number(transform_left_filter_feature_0_choice_160) * 16) +
          (as_number(transform_left_filter_feature_0_choice_168) * 32) +
          (as_number(transform_left_filter_feature_0_choice_176) * 8) + transform_left_filter_feature_0_choice_201;
      else
        transform_left_filter_feature_0_choice_202 := transform_left_filter_feature_0_choice_201;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_left_filter_feature_0_choice_203 := (as_number(transform_left_filter_feature_0_choice_136) * 128) +
          (as_number(transform_left_filter_feature_0_choice_144) * 256) +
          (as_number(transform_left_filter_feature_0_choice_152) * 64) + transform_left_filter_feature_0_choice_202;
      else
        transform_left_filter_feature_0_choice_203 := transform_left_filter_feature_0_choice_202;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_left_filter_feature_0_choice_204 := (as_number(transform_left_filter_feature_0_choice_112) * 1024) +
          (as_number(transform_left_filter_feature_0_choice_120) * 2048) +
          (as_number(transform_left_filter_feature_0_choice_128) * 512) + transform_left_filter_feature_0_choice_203;
      else
        transform_left_filter_feature_0_choice_204 := transform_left_filter_feature_0_choice_203;
      end if;
      if (transform_left_filter_column_4_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_205 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_205 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_206 := transform_left_filter_feature_0_choice_205;
      else
        transform_left_filter_feature_0_choice_206 := ((transform_left_filter_column_4_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_206 then
        transform_left_filter_feature_0_choice_207 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_207 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_207 then
        transform_left_filter_feature_0_choice_208 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_208 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_208 then
        transform_left_filter_feature_0_choice_209 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_209 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_209 then
        transform_left_filter_feature_0_choice_210 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_210 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_210 then
        transform_left_filter_feature_0_choice_211 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_211 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_211 then
        transform_left_filter_feature_0_choice_212 := ((transform_left_filter_column_4_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_212 := ((transform_left_filter_column_4_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_1 / 128) = 1));
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0_choice_213 := transform_left_filter_feature_0_choice_204 +
          (as_number(transform_left_filter_feature_0_choice_212) * 4096);
      else
        transform_left_filter_feature_0_choice_213 := transform_left_filter_feature_0_choice_204;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_left_filter_feature_0_choice_214 := (as_number(transform_left_filter_feature_0_choice_80) * 16384) +
          (as_number(transform_left_filter_feature_0_choice_88) * 32768) +
          (as_number(transform_left_filter_feature_0_choice_96) * 65536) +
          (as_number(transform_left_filter_feature_0_choice_104) * 8192) + transform_left_filter_feature_0_choice_213;
      else
        transform_left_filter_feature_0_choice_214 := (as_number(transform_left_filter_feature_0_choice_104) * 8192) +
          transform_left_filter_feature_0_choice_213;
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_left_filter_feature_0_choice_215 := (as_number(transform_left_filter_feature_0_choice_56) * 131072) +
          (as_number(transform_left_filter_feature_0_choice_64) * 262144) +
          (as_number(transform_left_filter_feature_0_choice_72) * 524288) + transform_left_filter_feature_0_choice_214;
      else
        transform_left_filter_feature_0_choice_215 := transform_left_filter_feature_0_choice_214;
      end if;
      if transform_filtering_0_column_inside_7 then
        transform_left_filter_feature_0_choice_216 := (as_number(transform_left_filter_feature_0_choice_32) * 1048576)
          + (as_number(transform_left_filter_feature_0_choice_40) * 2097152) +
          (as_number(transform_left_filter_feature_0_choice_48) * 4194304) + transform_left_filter_feature_0_choice_215;
      else
        transform_left_filter_feature_0_choice_216 := transform_left_filter_feature_0_choice_215;
      end if;
      transform_right_filter_feature_0_value := ((transform_right_filter_column_4_1 / 2) mod 2) = 1;
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        ((transform_right_filter_column_4_1 mod 2) = 1));
      if (transform_right_filter_column_8_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_4_1 mod 4) = 0;
      if ((transform_right_filter_column_8_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choice_2 := ((transform_right_filter_column_8_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_2 := ((transform_right_filter_column_4_1 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_2 then
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_8_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_3 := ((transform_right_filter_column_4_1 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_3 then
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_8_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_4 := ((transform_right_filter_column_4_1 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_4 then
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_8_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_5 := ((transform_right_filter_column_4_1 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_5 then
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_8_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_6 := ((transform_right_filter_column_4_1 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_6 then
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_8_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_7 then
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_8_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_8_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
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
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_8_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
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
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_24 := ((transform_right_filter_column_8_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_25 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_25 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_26 := transform_right_filter_feature_0_choice_25;
      else
        transform_right_filter_feature_0_choice_26 := ((transform_right_filter_column_7_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_26 then
        transform_right_filter_feature_0_choice_27 := (not (((transform_right_filter_column_7_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_27 := (not (((transform_right_filter_column_7_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_27 then
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_7_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_7_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_28 then
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_7_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_7_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_29 then
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_7_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_7_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_30 then
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_7_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_7_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_31 then
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_7_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_7_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_33 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_33 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_34 := transform_right_filter_feature_0_choice_33;
      else
        transform_right_filter_feature_0_choice_34 := ((transform_right_filter_column_7_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_34 then
        transform_right_filter_feature_0_choice_35 := (not (((transform_right_filter_column_7_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_35 := (not (((transform_right_filter_column_7_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_35 then
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_7_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_7_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_36 then
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_7_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_7_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_37 then
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_7_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_7_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_38 then
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_7_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_7_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_39 then
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_7_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_7_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_7_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_41 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_41 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_7_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_42 := transform_right_filter_feature_0_choice_41;
      else
        transform_right_filter_feature_0_choice_42 := ((transform_right_filter_column_7_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_42 then
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_7_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_7_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_43 then
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_7_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_7_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_44 then
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_7_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_7_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_45 then
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_7_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_7_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_46 then
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_7_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_7_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_47 then
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_7_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_7_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_49 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_49 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_50 := transform_right_filter_feature_0_choice_49;
      else
        transform_right_filter_feature_0_choice_50 := ((transform_right_filter_column_6_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_50 then
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_6_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_51 then
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_6_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_52 then
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_6_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_53 then
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_6_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_54 then
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_6_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_55 then
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_6_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_6_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_57 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_57 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_58 := transform_right_filter_feature_0_choice_57;
      else
        transform_right_filter_feature_0_choice_58 := ((transform_right_filter_column_6_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_58 then
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_6_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_59 then
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_6_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_60 then
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_6_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_61 then
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_6_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_62 then
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_6_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_63 then
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_6_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_6_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_6_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_65 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_65 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_6_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_66 := transform_right_filter_feature_0_choice_65;
      else
        transform_right_filter_feature_0_choice_66 := ((transform_right_filter_column_6_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_66 then
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_6_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_67 then
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_6_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_68 then
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_6_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_69 then
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_6_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_70 then
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_6_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_71 then
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_6_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_6_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_73 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_73 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_74 := transform_right_filter_feature_0_choice_73;
      else
        transform_right_filter_feature_0_choice_74 := ((transform_right_filter_column_5_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_74 then
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_5_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_5_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_75 then
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_5_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_5_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_76 then
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_5_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_5_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_77 then
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_5_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_5_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_78 then
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_5_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_5_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_79 then
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_5_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_5_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_81 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_81 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_82 := transform_right_filter_feature_0_choice_81;
      else
        transform_right_filter_feature_0_choice_82 := ((transform_right_filter_column_5_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_82 then
        transform_right_filter_feature_0_choice_83 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_83 := (not (((transform_right_filter_column_5_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_83 then
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_5_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_84 then
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_5_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_85 then
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_5_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_86 then
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_5_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_87 then
        transform_right_filter_feature_0_choice_88 := ((transform_right_filter_column_5_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_88 := ((transform_right_filter_column_5_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_5_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_89 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_89 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_5_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_90 := transform_right_filter_feature_0_choice_89;
      else
        transform_right_filter_feature_0_choice_90 := ((transform_right_filter_column_5_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_90 then
        transform_right_filter_feature_0_choice_91 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_91 := (not (((transform_right_filter_column_5_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_91 then
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_5_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_92 then
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_5_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_93 then
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_5_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_94 then
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_5_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_95 then
        transform_right_filter_feature_0_choice_96 := ((transform_right_filter_column_5_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_96 := ((transform_right_filter_column_5_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_97 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_97 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_98 := transform_right_filter_feature_0_choice_97;
      else
        transform_right_filter_feature_0_choice_98 := ((transform_right_filter_column_4_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_98 then
        transform_right_filter_feature_0_choice_99 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_99 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_99 then
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_100 then
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_101 then
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_102 then
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_103 then
        transform_right_filter_feature_0_choice_104 := transform_filtering_0_column_inside_4 and
          ((transform_right_filter_column_4_2 / 128) = 1) and (not ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_104 := transform_filtering_0_column_inside_4 and
          (((transform_right_filter_column_4_2 / 128) = 1) or (not ((transform_right_filter_column_4_1 / 128) = 1)));
      end if;
      if (transform_right_filter_column_3_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_105 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_105 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_106 := transform_right_filter_feature_0_choice_105;
      else
        transform_right_filter_feature_0_choice_106 := ((transform_right_filter_column_3_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_106 then
        transform_right_filter_feature_0_choice_107 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_107 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_107 then
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_108 then
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_109 then
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_110 then
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_111 then
        transform_right_filter_feature_0_choice_112 := ((transform_right_filter_column_3_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_112 := ((transform_right_filter_column_3_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_113 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_113 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_114 := transform_right_filter_feature_0_choice_113;
      else
        transform_right_filter_feature_0_choice_114 := ((transform_right_filter_column_3_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_114 then
        transform_right_filter_feature_0_choice_115 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_115 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_115 then
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_116 then
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_117 then
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_118 then
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_119 then
        transform_right_filter_feature_0_choice_120 := ((transform_right_filter_column_3_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_120 := ((transform_right_filter_column_3_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_121 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_121 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_122 := transform_right_filter_feature_0_choice_121;
      else
        transform_right_filter_feature_0_choice_122 := ((transform_right_filter_column_3_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_122 then
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_123 then
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_124 then
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_125 then
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_126 then
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_127 then
        transform_right_filter_feature_0_choice_128 := ((transform_right_filter_column_3_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_128 := ((transform_right_filter_column_3_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_129 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_129 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_130 := transform_right_filter_feature_0_choice_129;
      else
        transform_right_filter_feature_0_choice_130 := ((transform_right_filter_column_2_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_130 then
        transform_right_filter_feature_0_choice_131 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_131 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_131 then
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_132 then
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_133 then
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_134 then
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_135 then
        transform_right_filter_feature_0_choice_136 := ((transform_right_filter_column_2_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_136 := ((transform_right_filter_column_2_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_137 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_137 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_138 := transform_right_filter_feature_0_choice_137;
      else
        transform_right_filter_feature_0_choice_138 := ((transform_right_filter_column_2_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_138 then
        transform_right_filter_feature_0_choice_139 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_139 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_139 then
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_140 then
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_141 then
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_142 then
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_143 then
        transform_right_filter_feature_0_choice_144 := ((transform_right_filter_column_2_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_144 := ((transform_right_filter_column_2_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_145 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_145 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_146 := transform_right_filter_feature_0_choice_145;
      else
        transform_right_filter_feature_0_choice_146 := ((transform_right_filter_column_2_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_146 then
        transform_right_filter_feature_0_choice_147 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_147 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_147 then
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_148 then
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_149 then
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_150 then
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_151 then
        transform_right_filter_feature_0_choice_152 := ((transform_right_filter_column_2_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_152 := ((transform_right_filter_column_2_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_153 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_153 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_154 := transform_right_filter_feature_0_choice_153;
      else
        transform_right_filter_feature_0_choice_154 := ((transform_right_filter_column_1_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_154 then
        transform_right_filter_feature_0_choice_155 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_155 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_155 then
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_156 then
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_157 then
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_158 then
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_159 then
        transform_right_filter_feature_0_choice_160 := ((transform_right_filter_column_1_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_160 := ((transform_right_filter_column_1_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_161 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_161 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_162 := transform_right_filter_feature_0_choice_161;
      else
        transform_right_filter_feature_0_choice_162 := ((transform_right_filter_column_1_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_162 then
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_163 then
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_164 then
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_165 then
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_166 then
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_167 then
        transform_right_filter_feature_0_choice_168 := ((transform_right_filter_column_1_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_168 := ((transform_right_filter_column_1_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_169 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_169 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_170 := transform_right_filter_feature_0_choice_169;
      else
        transform_right_filter_feature_0_choice_170 := ((transform_right_filter_column_1_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_170 then
        transform_right_filter_feature_0_choice_171 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_171 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_171 then
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_172 then
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_173 then
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_174 then
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_175 then
        transform_right_filter_feature_0_choice_176 := ((transform_right_filter_column_1_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_176 := ((transform_right_filter_column_1_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_177 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_177 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_178 := transform_right_filter_feature_0_choice_177;
      else
        transform_right_filter_feature_0_choice_178 := ((transform_right_filter_column_0_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_178 then
        transform_right_filter_feature_0_choice_179 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_179 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_179 then
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_180 then
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_181 then
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_182 then
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_183 then
        transform_right_filter_feature_0_choice_184 := ((transform_right_filter_column_0_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_184 := ((transform_right_filter_column_0_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_185 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_185 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_186 := transform_right_filter_feature_0_choice_185;
      else
        transform_right_filter_feature_0_choice_186 := ((transform_right_filter_column_0_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_186 then
        transform_right_filter_feature_0_choice_187 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_187 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_187 then
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_188 then
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_189 then
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_190 then
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_191 then
        transform_right_filter_feature_0_choice_192 := ((transform_right_filter_column_0_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_192 := ((transform_right_filter_column_0_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_193 := not (((transform_right_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_right_filter_feature_0_choice_193 := (transform_right_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value then
        transform_right_filter_feature_0_choice_194 := ((transform_right_filter_column_4_1 mod 2) = 1) or (not
          (((transform_right_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_right_filter_column_0_0 mod 2) =
          1));
      else
        transform_right_filter_feature_0_choice_194 := transform_right_filter_feature_0_choice_193;
      end if;
      transform_right_filter_feature_0_value_7 := ((transform_right_filter_column_0_0 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_194 then
        transform_right_filter_feature_0_choice_195 := (not transform_right_filter_feature_0_value_2) and
          transform_right_filter_feature_0_value_7;
      else
        transform_right_filter_feature_0_choice_195 := (not transform_right_filter_feature_0_value_2) or
          transform_right_filter_feature_0_value_7;
      end if;
      transform_right_filter_feature_0_value_8 := ((transform_right_filter_column_0_0 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_195 then
        transform_right_filter_feature_0_choice_196 := (not transform_right_filter_feature_0_value_3) or
          transform_right_filter_feature_0_value_8;
      else
        transform_right_filter_feature_0_choice_196 := (not transform_right_filter_feature_0_value_3) and
          transform_right_filter_feature_0_value_8;
      end if;
      transform_right_filter_feature_0_value_9 := ((transform_right_filter_column_0_0 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_196 then
        transform_right_filter_feature_0_choice_197 := (not transform_right_filter_feature_0_value_4) or
          transform_right_filter_feature_0_value_9;
      else
        transform_right_filter_feature_0_choice_197 := (not transform_right_filter_feature_0_value_4) and
          transform_right_filter_feature_0_value_9;
      end if;
      transform_right_filter_feature_0_value_10 := ((transform_right_filter_column_0_0 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_197 then
        transform_right_filter_feature_0_choice_198 := (not transform_right_filter_feature_0_value_5) or
          transform_right_filter_feature_0_value_10;
      else
        transform_right_filter_feature_0_choice_198 := (not transform_right_filter_feature_0_value_5) and
          transform_right_filter_feature_0_value_10;
      end if;
      transform_right_filter_feature_0_value_11 := ((transform_right_filter_column_0_0 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_198 then
        transform_right_filter_feature_0_choice_199 := (not transform_right_filter_feature_0_value_6) or
          transform_right_filter_feature_0_value_11;
      else
        transform_right_filter_feature_0_choice_199 := (not transform_right_filter_feature_0_value_6) and
          transform_right_filter_feature_0_value_11;
      end if;
      if transform_right_filter_feature_0_choice_199 then
        transform_right_filter_feature_0_choice_200 := (not ((transform_right_filter_column_4_1 / 128) = 1)) or
          ((transform_right_filter_column_0_0 / 128) = 1);
      else
        transform_right_filter_feature_0_choice_200 := (not ((transform_right_filter_column_4_1 / 128) = 1)) and
          ((transform_right_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_right_filter_feature_0_choice_201 := (as_number(transform_right_filter_feature_0_choice_184) * 2) +
          (as_number(transform_right_filter_feature_0_choice_192) * 4) +
          as_number(transform_right_filter_feature_0_choice_200);
      else
        transform_right_filter_feature_0_choice_201 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_right_filter_feature_0_choice_202 := (as_number(transform_right_filter_feature_0_choice_160) * 16) +
          (as_number(transform_right_filter_feature_0_choice_168) * 32) +
          (as_number(transform_right_filter_feature_0_choice_176) * 8) + transform_right_filter_feature_0_choice_201;
      else
        transform_right_filter_feature_0_choice_202 := transform_right_filter_feature_0_choice_201;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_right_filter_feature_0_choice_203 := (as_number(transform_right_filter_feature_0_choice_136) * 128) +
          (as_number(transform_right_filter_feature_0_choice_144) * 256) +
          (as_number(transform_right_filter_feature_0_choice_152) * 64) + transform_right_filter_feature_0_choice_202;
      else
        transform_right_filter_feature_0_choice_203 := transform_right_filter_feature_0_choice_202;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_right_filter_feature_0_choice_204 := (as_number(transform_right_filter_feature_0_choice_112) * 1024)
          + (as_number(transform_right_filter_feature_0_choice_120) * 2048) +
          (as_number(transform_right_filter_feature_0_choice_128) * 512) + transform_right_filter_feature_0_choice_203;
      else
        transform_right_filter_feature_0_choice_204 := transform_right_filter_feature_0_choice_203;
      end if;
      if (transform_right_filter_column_4_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_205 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_205 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_206 := transform_right_filter_feature_0_choice_205;
      else
        transform_right_filter_feature_0_choice_206 := ((transform_right_filter_column_4_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_206 then
        transform_right_filter_feature_0_choice_207 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_207 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_207 then
        transform_right_filter_feature_0_choice_208 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_208 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_208 then
        transform_right_filter_feature_0_choice_209 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_209 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_209 then
        transform_right_filter_feature_0_choice_210 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_210 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_210 then
        transform_right_filter_feature_0_choice_211 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_211 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_211 then
        transform_right_filter_feature_0_choice_212 := ((transform_right_filter_column_4_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_212 := ((transform_right_filter_column_4_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_1 / 128) = 1));
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_0_choice_213 := transform_right_filter_feature_0_choice_204 +
          (as_number(transform_right_filter_feature_0_choice_212) * 4096);
      else
        transform_right_filter_feature_0_choice_213 := transform_right_filter_feature_0_choice_204;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_right_filter_feature_0_choice_214 := (as_number(transform_right_filter_feature_0_choice_80) * 16384)
          + (as_number(transform_right_filter_feature_0_choice_88) * 32768) +
          (as_number(transform_right_filter_feature_0_choice_96) * 65536) +
          (as_number(transform_right_filter_feature_0_choice_104) * 8192) + transform_right_filter_feature_0_choice_213;
      else
        transform_right_filter_feature_0_choice_214 := (as_number(transform_right_filter_feature_0_choice_104) * 8192)
          + transform_right_filter_feature_0_choice_213;
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_right_filter_feature_0_choice_215 := (as_number(transform_right_filter_feature_0_choice_56) * 131072)
          + (as_number(transform_right_filter_feature_0_choice_64) * 262144) +
          (as_number(transform_right_filter_feature_0_choice_72) * 524288) +
          transform_right_filter_feature_0_choice_214;
      else
        transform_right_filter_feature_0_choice_215 := transform_right_filter_feature_0_choice_214;
      end if;
      if transform_filtering_0_column_inside_7 then
        transform_right_filter_feature_0_choice_216 := (as_number(transform_right_filter_feature_0_choice_32) *
          1048576) + (as_number(transform_right_filter_feature_0_choice_40) * 2097152) +
          (as_number(transform_right_filter_feature_0_choice_48) * 4194304) +
          transform_right_filter_feature_0_choice_215;
      else
        transform_right_filter_feature_0_choice_216 := transform_right_filter_feature_0_choice_215;
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
        (transform_counter_group mod 2)) < 480;
      transform_read_row_inside_1 <= (transform_counter_group >= 1) and (transform_counter_group < 481);
      transform_read_row_inside_2 <= transform_counter_group < 480;
      transform_read_column_inside_0 <= transform_read_column_inside_0_is_less;
      transform_read_column_inside_1 <= (transform_counter_column = 0) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_2 <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_3 <= transform_counter_column /= 3;
      transform_read_column_inside_4 <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_5 <= (transform_counter_column < 5) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_6 <= (transform_counter_column < 6) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_7 <= (transform_counter_column < 7) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_8 <= (transform_counter_column < 8) /= transform_read_column_inside_0_is_less;
      transform_read_start_of_frame <= (transform_counter_group = 1) and (transform_counter_column = 4);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_1 <= transform_read_row_inside_1;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
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
      transform_left_column_0 <= transform_left_rows_ready_words_0 mod 256;
      transform_left_column_1 <= transform_left_rows_ready_words_0 / 256;
      transform_left_column_2 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= transform_right_rows_ready_words_0 mod 256;
      transform_right_column_1 <= transform_right_rows_ready_words_0 / 256;
      transform_right_column_2 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_1 <= transform_ready_row_inside_1;
      transform_columns_row_inside_2 <= transform_ready_row_inside_2;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_1 <= transform_ready_column_inside_1;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_column_inside_3 <= transform_ready_column_inside_3;
      transform_columns_column_inside_4 <= refinement_passed_1_0;
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
      transform_filtering_0_column_inside_4 <= refinement_passed_2_0;
      transform_filtering_0_column_inside_5 <= transform_columns_column_inside_5;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_7 <= transform_columns_column_inside_7;
      transform_filtering_0_column_inside_8 <= transform_columns_column_inside_8;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 32;
      else
        transform_counter_group <= transform_counter_group_choice_3;
      end if;
      if transform_filtering_0_column_inside_8 then
        transform_left_filter_feature_0 <= (as_number(transform_left_filter_feature_0_choice_8) * 8388608) +
          (as_number(transform_left_filter_feature_0_choice_16) * 16777216) +
          (as_number(transform_left_filter_feature_0_choice_24) * 33554432) +
          transform_left_filter_feature_0_choice_216;
        transform_right_filter_feature_0 <= (as_number(transform_right_filter_feature_0_choice_8) * 8388608) +
          (as_number(transform_right_filter_feature_0_choice_16) * 16777216) +
          (as_number(transform_right_filter_feature_0_choice_24) * 33554432) +
          transform_right_filter_feature_0_choice_216;
      else
        transform_left_filter_feature_0 <= transform_left_filter_feature_0_choice_216;
        transform_right_filter_feature_0 <= transform_right_filter_feature_0_choice_216;
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := (transform_counter_group /= 480) and transform_counter_next_frame;
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
          transform_counter_column <= (transform_counter_column + 1) mod 1024;
        end if;
        if transform_counter_next_frame_choice_2 then
          transform_counter_next_frame <= (not in_start_of_frame) or transform_counter_group_all;
        else
          transform_counter_next_frame <= in_start_of_frame and transform_counter_group_is_equal and
            transform_counter_group_is_equal_2;
        end if;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= (transform_left_rows_ready_newest_0 * 256) +
          (transform_left_rows_ready_words_0 / 256);
        transform_right_rows_write_words_0 <= (transform_right_rows_ready_newest_0 * 256) +
          (transform_right_rows_ready_words_0 / 256);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_columns_valid then
        transform_left_filter_column_1_0 <= transform_left_filter_column_0_0;
        transform_left_filter_column_1_1 <= transform_left_filter_column_0_1;
        transform_left_filter_column_1_2 <= transform_left_filter_column_0_2;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_left_filter_column_2_1 <= transform_left_filter_column_1_1;
        transform_left_filter_column_2_2 <= transform_left_filter_column_1_2;
        transform_left_filter_column_3_0 <= transform_left_filter_column_2_0;
        transform_left_filter_column_3_1 <= transform_left_filter_column_2_1;
        transform_left_filter_column_3_2 <= transform_left_filter_column_2_2;
        transform_left_filter_column_4_0 <= transform_left_filter_column_3_0;
        transform_left_filter_column_4_1 <= transform_left_filter_column_3_1;
        transform_left_filter_column_4_2 <= transform_left_filter_column_3_2;
        transform_left_filter_column_5_0 <= transform_left_filter_column_4_0;
        transform_left_filter_column_5_1 <= transform_left_filter_column_4_1;
        transform_left_filter_column_5_2 <= transform_left_filter_column_4_2;
        transform_left_filter_column_6_0 <= transform_left_filter_column_5_0;
        transform_left_filter_column_6_1 <= transform_left_filter_column_5_1;
        transform_left_filter_column_6_2 <= transform_left_filter_column_5_2;
        transform_left_filter_column_7_0 <= transform_left_filter_column_6_0;
        transform_left_filter_column_7_1 <= transform_left_filter_column_6_1;
        transform_left_filter_column_7_2 <= transform_left_filter_column_6_2;
        transform_left_filter_column_8_0 <= transform_left_filter_column_7_0;
        transform_left_filter_column_8_1 <= transform_left_filter_column_7_1;
        transform_left_filter_column_8_2 <= transform_left_filter_column_7_2;
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_1_1 <= transform_right_filter_column_0_1;
        transform_right_filter_column_1_2 <= transform_right_filter_column_0_2;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
        transform_right_filter_column_2_1 <= transform_right_filter_column_1_1;
        transform_right_filter_column_2_2 <= transform_right_filter_column_1_2;
        transform_right_filter_column_3_0 <= transform_right_filter_column_2_0;
        transform_right_filter_column_3_1 <= transform_right_filter_column_2_1;
        transform_right_filter_column_3_2 <= transform_right_filter_column_2_2;
        transform_right_filter_column_4_0 <= transform_right_filter_column_3_0;
        transform_right_filter_column_4_1 <= transform_right_filter_column_3_1;
        transform_right_filter_column_4_2 <= transform_right_filter_column_3_2;
        transform_right_filter_column_5_0 <= transform_right_filter_column_4_0;
        transform_right_filter_column_5_1 <= transform_right_filter_column_4_1;
        transform_right_filter_column_5_2 <= transform_right_filter_column_4_2;
        transform_right_filter_column_6_0 <= transform_right_filter_column_5_0;
        transform_right_filter_column_6_1 <= transform_right_filter_column_5_1;
        transform_right_filter_column_6_2 <= transform_right_filter_column_5_2;
        transform_right_filter_column_7_0 <= transform_right_filter_column_6_0;
        transform_right_filter_column_7_1 <= transform_right_filter_column_6_1;
        transform_right_filter_column_7_2 <= transform_right_filter_column_6_2;
        transform_right_filter_column_8_0 <= transform_right_filter_column_7_0;
        transform_right_filter_column_8_1 <= transform_right_filter_column_7_1;
        transform_right_filter_column_8_2 <= transform_right_filter_column_7_2;
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
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 639;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_1_valid;
      if transform_filtering_1_valid and transform_filtering_1_start_of_frame then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 484) and
          transform_filtering_1_valid and raster_place_group_is_equal))) mod 512;
      end if;
      if transform_filtering_1_valid then
        if raster_place_group_is_equal or transform_filtering_1_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 1024;
        end if;
      end if;
      -- delay
      delay_tag_first_column_is_equal := raster_place_column = 1;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (raster_place_group >= 9) and (raster_place_group < 489);
      delay_row_inside_1 <= raster_place_group < 480;
      delay_tag_valid <= raster_features_valid;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_output_column <= ((((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) <
        480) and (raster_place_column >= 1) and (raster_place_column < 640);
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= (raster_place_group = 4) and delay_tag_first_column_is_equal;
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
      rows_read_tag_first_group <= delay_tag_first_group;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_first_group <= rows_read_tag_first_group;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
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
      -- passes
      passes_row_is_equal := rows_write_column = 639;
      if rows_tag_valid then
        passes_row <= passes_row_is_equal /= passes_row;
        passes_write_address <= rows_write_column + (as_number(passes_row) * 1024);
        passes_write_search_0 <= rows_search_0;
        passes_write_search_1 <= rows_search_1;
        passes_write_reference_0 <= rows_reference_0;
        passes_write_reference_1 <= rows_reference_1;
      end if;
      if rows_tag_first_column then
        passes_coming_first_group_choice := passes_coming_first_group or rows_tag_valid;
      else
        passes_coming_first_group_choice := passes_coming_first_group;
      end if;
      if rows_tag_first_column then
        passes_coming_first_group_choice_2 := passes_coming_first_group and (not rows_tag_valid);
      else
        passes_coming_first_group_choice_2 := passes_coming_first_group;
      end if;
      if rows_tag_first_column then
        passes_coming_output_choice := passes_coming_output or rows_tag_valid;
      else
        passes_coming_output_choice := passes_coming_output;
      end if;
      if rows_tag_first_column then
        passes_coming_output_choice_2 := passes_coming_output and (not rows_tag_valid);
      else
        passes_coming_output_choice_2 := passes_coming_output;
      end if;
      if rows_tag_first_column then
        passes_coming_starts_choice := passes_coming_starts or rows_tag_valid;
      else
        passes_coming_starts_choice := passes_coming_starts;
      end if;
      if rows_tag_first_column then
        passes_coming_starts_choice_2 := passes_coming_starts and (not rows_tag_valid);
      else
        passes_coming_starts_choice_2 := passes_coming_starts;
      end if;
      passes_row_ended_all := rows_tag_valid and passes_row_is_equal;
      passes_shows_any := (not passes_pass_ends) or (not passes_last_pass);
      passes_showing_first_group_differs := rows_write_column /= 639;
      if rows_tag_valid then
        passes_showing_output_choice := passes_row_is_equal or passes_showing_output;
      else
        passes_showing_output_choice := passes_showing_output;
      end if;
      if rows_tag_valid then
        passes_showing_output_choice_2 := passes_showing_first_group_differs and passes_showing_output;
      else
        passes_showing_output_choice_2 := passes_showing_output;
      end if;
      if passes_last_pass then
        passes_pass_ends_choice := 593;
      else
        passes_pass_ends_choice := 586;
      end if;
      if passes_shows_any then
        passes_search_start_choice := ((passes_search_start / 8) + 127) mod 128;
      else
        passes_search_start_choice := 6;
      end if;
      if passes_pass_ends then
        passes_search_start_choice_2 := passes_search_start_choice;
      else
        passes_search_start_choice_2 := passes_search_start / 8;
      end if;
      passes_search_address_value := as_number((not passes_row)) * 1024;
      if passes_shows_any then
        passes_search_address_choice := passes_search_start / 8;
      else
        passes_search_address_choice := 7;
      end if;
      if passes_pass_ends then
        passes_search_address_choice_2 := passes_search_address_choice * 8;
      else
        passes_search_address_choice_2 := (passes_search_address + as_number(passes_shows)) mod 1024;
      end if;
      if passes_pass_ends then
        passes_reference_address_choice := 56;
      else
        passes_reference_address_choice := (passes_reference_address + as_number(passes_shows)) mod 1024;
      end if;
      if rows_tag_valid then
        passes_leaving_starts_choice := passes_row_is_equal or passes_leaving_starts;
      else
        passes_leaving_starts_choice := passes_leaving_starts;
      end if;
      if rows_tag_valid then
        passes_leaving_starts_choice_2 := passes_showing_first_group_differs and passes_leaving_starts;
      else
        passes_leaving_starts_choice_2 := passes_leaving_starts;
      end if;
      passes_read_tag_leaves_window_differs := passes_column /= 0;
      passes_read_tag_map_column_is_equal := passes_column = 8;
      if passes_read_tag_map_column then
        passes_read_tag_map_column_choice := passes_read_tag_map_column_is_equal or (not passes_read_tag_end_of_line);
      else
        passes_read_tag_map_column_choice := passes_read_tag_map_column_is_equal;
      end if;
      passes_row_ended <= passes_row_ended_all;
      passes_arrived <= rows_tag_valid;
      passes_pass_ends <= passes_column = passes_pass_ends_choice;
      passes_last_pass <= passes_pass = 7;
      passes_search_start <= passes_search_start_choice_2 * 8;
      passes_search_address <= passes_search_address_value + passes_search_address_choice_2;
      passes_reference_address <= passes_search_address_value + passes_reference_address_choice;
      passes_read_tag_valid <= passes_shows;
      passes_read_tag_row_start <= to_integer(((to_unsigned(passes_pass, 10)) or (to_unsigned(passes_column, 10)))) = 0;
      passes_read_tag_first_group <= passes_showing_first_group;
      passes_read_tag_border_column <= (passes_column /= 7) and (passes_read_tag_border_column or (passes_column = 0)
        or (passes_column = 584));
      passes_read_tag_first_cost <= passes_column = 7;
      passes_read_tag_map_column <= passes_read_tag_map_column_choice;
      passes_read_tag_output_column <= passes_showing_output and passes_read_tag_map_column_choice;
      passes_read_tag_first_column <= passes_read_tag_first_cost;
      passes_read_tag_end_of_line <= passes_column = 583;
      passes_search_0 <= to_integer(passes_read_search_0);
      passes_search_1 <= to_integer(passes_read_search_1);
      passes_reference_0 <= to_integer(passes_read_reference_0);
      passes_reference_1 <= to_integer(passes_read_reference_1);
      passes_tag_valid <= passes_read_tag_valid;
      passes_tag_row_start <= passes_read_tag_row_start;
      passes_tag_first_group <= passes_read_tag_first_group;
      passes_tag_border_column <= passes_read_tag_border_column;
      passes_tag_first_cost <= passes_read_tag_map_column_is_equal;
      passes_tag_leaves_window <= passes_read_tag_leaves_window;
      passes_tag_map_column <= passes_read_tag_map_column;
      passes_tag_output_column <= passes_read_tag_output_column;
      passes_tag_first_column <= passes_read_tag_first_column;
      if rows_tag_first_group then
        passes_coming_first_group <= passes_coming_first_group_choice;
      else
        passes_coming_first_group <= passes_coming_first_group_choice_2;
      end if;
      if rows_tag_output_column then
        passes_coming_output <= passes_coming_output_choice;
      else
        passes_coming_output <= passes_coming_output_choice_2;
      end if;
      if rows_tag_start_of_frame then
        passes_coming_starts <= passes_coming_starts_choice;
      else
        passes_coming_starts <= passes_coming_starts_choice_2;
      end if;
      if passes_row_ended then
        passes_shows <= (not passes_shows) or (not passes_pass_ends) or (not passes_last_pass);
      else
        passes_shows <= passes_shows and passes_shows_any;
      end if;
      if passes_showing_first_group then
        passes_showing_first_group <= passes_coming_first_group or (not rows_tag_valid) or
          passes_showing_first_group_differs;
      else
        passes_showing_first_group <= passes_coming_first_group and rows_tag_valid and passes_row_is_equal;
      end if;
      if passes_coming_output then
        passes_showing_output <= passes_showing_output_choice;
      else
        passes_showing_output <= passes_showing_output_choice_2;
      end if;
      if passes_coming_starts then
        passes_showing_starts <= passes_showing_starts or passes_row_ended_all;
      else
        passes_showing_starts <= passes_showing_starts and ((not rows_tag_valid) or passes_showing_first_group_differs);
      end if;
      if passes_pass_ends then
        passes_column <= 0;
      else
        passes_column <= (passes_column + as_number(passes_shows)) mod 1024;
      end if;
      if passes_showing_starts then
        passes_leaving_starts <= passes_leaving_starts_choice;
      else
        passes_leaving_starts <= passes_leaving_starts_choice_2;
      end if;
      if passes_read_tag_leaves_window then
        passes_read_tag_leaves_window <= passes_read_tag_leaves_window_differs;
      else
        passes_read_tag_leaves_window <= (passes_column = 16) and passes_read_tag_leaves_window_differs;
      end if;
      if passes_pass_ends then
        if passes_shows_any then
          passes_pass <= (passes_pass + 1) mod 8;
        else
          passes_pass <= 0;
        end if;
      end if;
      -- slice0shift
      if passes_tag_valid then
        slice0shift_search_0_0 <= passes_search_0;
        slice0shift_search_0_1 <= slice0shift_search_0_0;
        slice0shift_search_0_2 <= slice0shift_search_0_1;
        slice0shift_search_0_3 <= slice0shift_search_0_2;
        slice0shift_search_0_4 <= slice0shift_search_0_3;
        slice0shift_search_0_5 <= slice0shift_search_0_4;
        slice0shift_search_0_6 <= slice0shift_search_0_5;
        slice0shift_search_0_7 <= slice0shift_search_0_6;
        slice0shift_search_1_0 <= passes_search_1;
        slice0shift_search_1_1 <= slice0shift_search_1_0;
        slice0shift_search_1_2 <= slice0shift_search_1_1;
        slice0shift_search_1_3 <= slice0shift_search_1_2;
        slice0shift_search_1_4 <= slice0shift_search_1_3;
        slice0shift_search_1_5 <= slice0shift_search_1_4;
        slice0shift_search_1_6 <= slice0shift_search_1_5;
        slice0shift_search_1_7 <= slice0shift_search_1_6;
      end if;
      slice0shift_reference_0 <= passes_reference_0;
      slice0shift_reference_1 <= passes_reference_1;
      slice0shift_tag_valid <= passes_tag_valid;
      slice0shift_tag_row_start <= passes_tag_row_start;
      slice0shift_tag_first_group <= passes_tag_first_group;
      slice0shift_tag_border_column <= passes_tag_border_column;
      slice0shift_tag_first_cost <= passes_tag_first_cost;
      slice0shift_tag_leaves_window <= passes_tag_leaves_window;
      slice0shift_tag_map_column <= passes_tag_map_column;
      slice0shift_tag_output_column <= passes_tag_output_column;
      slice0shift_tag_first_column <= passes_tag_first_column;
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
      slice0cost_pixels_first_0_0_count_7_value_2 := ((slice0shift_reference_0 / 8388608) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_7_value_3 := ((slice0shift_reference_0 / 4194304) mod 2) = 1;
      slice0cost_pixels_first_0_0_count_8_value := ((slice0shift_reference_0 / 16777216) mod 2) = 1;
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
      slice0cost_pixels_first_1_0_count_7_value_2 := ((slice0shift_reference_1 / 8388608) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_7_value_3 := ((slice0shift_reference_1 / 4194304) mod 2) = 1;
      slice0cost_pixels_first_1_0_count_8_value := ((slice0shift_reference_1 / 16777216) mod 2) = 1;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_0_choice := 0;
      else
        slice0cost_column_0_0_choice := slice0cost_ready_words_0 mod 256;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_0_choice_2 := 0;
      else
        slice0cost_column_0_0_choice_2 := (slice0cost_change_0_0 + slice0cost_column_0_0_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_1_choice := 0;
      else
        slice0cost_column_0_1_choice := slice0cost_ready_words_0 / 256;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_1_choice_2 := 0;
      else
        slice0cost_column_0_1_choice_2 := (slice0cost_change_0_1 + slice0cost_column_0_1_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_2_choice := 0;
      else
        slice0cost_column_0_2_choice := slice0cost_ready_words_1 mod 256;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_2_choice_2 := 0;
      else
        slice0cost_column_0_2_choice_2 := (slice0cost_change_0_2 + slice0cost_column_0_2_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_3_choice := 0;
      else
        slice0cost_column_0_3_choice := slice0cost_ready_words_1 / 256;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_3_choice_2 := 0;
      else
        slice0cost_column_0_3_choice_2 := (slice0cost_change_0_3 + slice0cost_column_0_3_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_4_choice := 0;
      else
        slice0cost_column_0_4_choice := slice0cost_ready_words_2 mod 256;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_4_choice_2 := 0;
      else
        slice0cost_column_0_4_choice_2 := (slice0cost_change_0_4 + slice0cost_column_0_4_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_5_choice := 0;
      else
        slice0cost_column_0_5_choice := slice0cost_ready_words_2 / 256;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_5_choice_2 := 0;
      else
        slice0cost_column_0_5_choice_2 := (slice0cost_change_0_5 + slice0cost_column_0_5_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_6_choice := 0;
      else
        slice0cost_column_0_6_choice := slice0cost_ready_words_3 mod 256;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_6_choice_2 := 0;
      else
        slice0cost_column_0_6_choice_2 := (slice0cost_change_0_6 + slice0cost_column_0_6_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_7_choice := 0;
      else
        slice0cost_column_0_7_choice := slice0cost_ready_words_3 / 256;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_7_choice_2 := 0;
      else
        slice0cost_column_0_7_choice_2 := (slice0cost_change_0_7 + slice0cost_column_0_7_choice) mod 256;
      end if;
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
        (((slice0shift_search_0_0 / 2097152) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_7_value_2 /=
        (((slice0shift_search_0_0 / 8388608) mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_count_7_value_3 /=
        (((slice0shift_search_0_0 / 4194304) mod 2) = 1)));
      slice0cost_pixels_first_0_0_count_8 <= as_number((((slice0shift_reference_0 / 33554432) = 1) /=
        ((slice0shift_search_0_0 / 33554432) = 1))) + as_number((slice0cost_pixels_first_0_0_count_8_value /=
        (((slice0shift_search_0_0 / 16777216) mod 2) = 1)));
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
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((((slice0shift_search_0_1 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((((slice0shift_search_0_1 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_1_count_8 <= as_number((((slice0shift_search_0_1 / 33554432) = 1) /=
        ((slice0shift_reference_0 / 33554432) = 1))) + as_number(((((slice0shift_search_0_1 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value));
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
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((((slice0shift_search_0_2 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((((slice0shift_search_0_2 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_2_count_8 <= as_number((((slice0shift_search_0_2 / 33554432) = 1) /=
        ((slice0shift_reference_0 / 33554432) = 1))) + as_number(((((slice0shift_search_0_2 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value));
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
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((((slice0shift_search_0_3 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((((slice0shift_search_0_3 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_3_count_8 <= as_number((((slice0shift_search_0_3 / 33554432) = 1) /=
        ((slice0shift_reference_0 / 33554432) = 1))) + as_number(((((slice0shift_search_0_3 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value));
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
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((((slice0shift_search_0_4 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((((slice0shift_search_0_4 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_4_count_8 <= as_number((((slice0shift_search_0_4 / 33554432) = 1) /=
        ((slice0shift_reference_0 / 33554432) = 1))) + as_number(((((slice0shift_search_0_4 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value));
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
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((((slice0shift_search_0_5 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((((slice0shift_search_0_5 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_5_count_8 <= as_number((((slice0shift_search_0_5 / 33554432) = 1) /=
        ((slice0shift_reference_0 / 33554432) = 1))) + as_number(((((slice0shift_search_0_5 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value));
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
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((((slice0shift_search_0_6 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((((slice0shift_search_0_6 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_6_count_8 <= as_number((((slice0shift_search_0_6 / 33554432) = 1) /=
        ((slice0shift_reference_0 / 33554432) = 1))) + as_number(((((slice0shift_search_0_6 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value));
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
        slice0cost_pixels_first_0_0_count_7_value)) + as_number(((((slice0shift_search_0_7 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_2)) + as_number(((((slice0shift_search_0_7 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_7_value_3));
      slice0cost_pixels_first_0_7_count_8 <= as_number((((slice0shift_search_0_7 / 33554432) = 1) /=
        ((slice0shift_reference_0 / 33554432) = 1))) + as_number(((((slice0shift_search_0_7 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_count_8_value));
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
        (((slice0shift_search_1_0 / 2097152) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_7_value_2 /=
        (((slice0shift_search_1_0 / 8388608) mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_count_7_value_3 /=
        (((slice0shift_search_1_0 / 4194304) mod 2) = 1)));
      slice0cost_pixels_first_1_0_count_8 <= as_number((((slice0shift_reference_1 / 33554432) = 1) /=
        ((slice0shift_search_1_0 / 33554432) = 1))) + as_number((slice0cost_pixels_first_1_0_count_8_value /=
        (((slice0shift_search_1_0 / 16777216) mod 2) = 1)));
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
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((((slice0shift_search_1_1 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((((slice0shift_search_1_1 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_1_count_8 <= as_number((((slice0shift_search_1_1 / 33554432) = 1) /=
        ((slice0shift_reference_1 / 33554432) = 1))) + as_number(((((slice0shift_search_1_1 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value));
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
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((((slice0shift_search_1_2 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((((slice0shift_search_1_2 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_2_count_8 <= as_number((((slice0shift_search_1_2 / 33554432) = 1) /=
        ((slice0shift_reference_1 / 33554432) = 1))) + as_number(((((slice0shift_search_1_2 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value));
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
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((((slice0shift_search_1_3 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((((slice0shift_search_1_3 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_3_count_8 <= as_number((((slice0shift_search_1_3 / 33554432) = 1) /=
        ((slice0shift_reference_1 / 33554432) = 1))) + as_number(((((slice0shift_search_1_3 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value));
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
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((((slice0shift_search_1_4 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((((slice0shift_search_1_4 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_4_count_8 <= as_number((((slice0shift_search_1_4 / 33554432) = 1) /=
        ((slice0shift_reference_1 / 33554432) = 1))) + as_number(((((slice0shift_search_1_4 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value));
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
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((((slice0shift_search_1_5 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((((slice0shift_search_1_5 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_5_count_8 <= as_number((((slice0shift_search_1_5 / 33554432) = 1) /=
        ((slice0shift_reference_1 / 33554432) = 1))) + as_number(((((slice0shift_search_1_5 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value));
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
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((((slice0shift_search_1_6 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((((slice0shift_search_1_6 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_6_count_8 <= as_number((((slice0shift_search_1_6 / 33554432) = 1) /=
        ((slice0shift_reference_1 / 33554432) = 1))) + as_number(((((slice0shift_search_1_6 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value));
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
        slice0cost_pixels_first_1_0_count_7_value)) + as_number(((((slice0shift_search_1_7 / 8388608) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_2)) + as_number(((((slice0shift_search_1_7 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_7_value_3));
      slice0cost_pixels_first_1_7_count_8 <= as_number((((slice0shift_search_1_7 / 33554432) = 1) /=
        ((slice0shift_reference_1 / 33554432) = 1))) + as_number(((((slice0shift_search_1_7 / 16777216) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_count_8_value));
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_first_column <= slice0shift_tag_first_column;
      slice0cost_pixels_cost_0_0 <= slice0cost_pixels_first_0_0_count_6 + slice0cost_pixels_first_0_0_count_0 +
        slice0cost_pixels_first_0_0_count_1 + slice0cost_pixels_first_0_0_count_3 + slice0cost_pixels_first_0_0_count_8
        + slice0cost_pixels_first_0_0_count_4 + slice0cost_pixels_first_0_0_count_5 +
        slice0cost_pixels_first_0_0_count_7 + slice0cost_pixels_first_0_0_count_2;
      slice0cost_pixels_cost_0_1 <= slice0cost_pixels_first_0_1_count_6 + slice0cost_pixels_first_0_1_count_0 +
        slice0cost_pixels_first_0_1_count_1 + slice0cost_pixels_first_0_1_count_3 + slice0cost_pixels_first_0_1_count_8
        + slice0cost_pixels_first_0_1_count_4 + slice0cost_pixels_first_0_1_count_5 +
        slice0cost_pixels_first_0_1_count_7 + slice0cost_pixels_first_0_1_count_2;
      slice0cost_pixels_cost_0_2 <= slice0cost_pixels_first_0_2_count_6 + slice0cost_pixels_first_0_2_count_0 +
        slice0cost_pixels_first_0_2_count_1 + slice0cost_pixels_first_0_2_count_3 + slice0cost_pixels_first_0_2_count_8
        + slice0cost_pixels_first_0_2_count_4 + slice0cost_pixels_first_0_2_count_5 +
        slice0cost_pixels_first_0_2_count_7 + slice0cost_pixels_first_0_2_count_2;
      slice0cost_pixels_cost_0_3 <= slice0cost_pixels_first_0_3_count_6 + slice0cost_pixels_first_0_3_count_0 +
        slice0cost_pixels_first_0_3_count_1 + slice0cost_pixels_first_0_3_count_3 + slice0cost_pixels_first_0_3_count_8
        + slice0cost_pixels_first_0_3_count_4 + slice0cost_pixels_first_0_3_count_5 +
        slice0cost_pixels_first_0_3_count_7 + slice0cost_pixels_first_0_3_count_2;
      slice0cost_pixels_cost_0_4 <= slice0cost_pixels_first_0_4_count_6 + slice0cost_pixels_first_0_4_count_0 +
        slice0cost_pixels_first_0_4_count_1 + slice0cost_pixels_first_0_4_count_3 + slice0cost_pixels_first_0_4_count_8
        + slice0cost_pixels_first_0_4_count_4 + slice0cost_pixels_first_0_4_count_5 +
        slice0cost_pixels_first_0_4_count_7 + slice0cost_pixels_first_0_4_count_2;
      slice0cost_pixels_cost_0_5 <= slice0cost_pixels_first_0_5_count_6 + slice0cost_pixels_first_0_5_count_0 +
        slice0cost_pixels_first_0_5_count_1 + slice0cost_pixels_first_0_5_count_3 + slice0cost_pixels_first_0_5_count_8
        + slice0cost_pixels_first_0_5_count_4 + slice0cost_pixels_first_0_5_count_5 +
        slice0cost_pixels_first_0_5_count_7 + slice0cost_pixels_first_0_5_count_2;
      slice0cost_pixels_cost_0_6 <= slice0cost_pixels_first_0_6_count_6 + slice0cost_pixels_first_0_6_count_0 +
        slice0cost_pixels_first_0_6_count_1 + slice0cost_pixels_first_0_6_count_3 + slice0cost_pixels_first_0_6_count_8
        + slice0cost_pixels_first_0_6_count_4 + slice0cost_pixels_first_0_6_count_5 +
        slice0cost_pixels_first_0_6_count_7 + slice0cost_pixels_first_0_6_count_2;
      slice0cost_pixels_cost_0_7 <= slice0cost_pixels_first_0_7_count_6 + slice0cost_pixels_first_0_7_count_0 +
        slice0cost_pixels_first_0_7_count_1 + slice0cost_pixels_first_0_7_count_3 + slice0cost_pixels_first_0_7_count_8
        + slice0cost_pixels_first_0_7_count_4 + slice0cost_pixels_first_0_7_count_5 +
        slice0cost_pixels_first_0_7_count_7 + slice0cost_pixels_first_0_7_count_2;
      slice0cost_pixels_cost_1_0 <= slice0cost_pixels_first_1_0_count_6 + slice0cost_pixels_first_1_0_count_0 +
        slice0cost_pixels_first_1_0_count_1 + slice0cost_pixels_first_1_0_count_3 + slice0cost_pixels_first_1_0_count_8
        + slice0cost_pixels_first_1_0_count_4 + slice0cost_pixels_first_1_0_count_5 +
        slice0cost_pixels_first_1_0_count_7 + slice0cost_pixels_first_1_0_count_2;
      slice0cost_pixels_cost_1_1 <= slice0cost_pixels_first_1_1_count_6 + slice0cost_pixels_first_1_1_count_0 +
        slice0cost_pixels_first_1_1_count_1 + slice0cost_pixels_first_1_1_count_3 + slice0cost_pixels_first_1_1_count_8
        + slice0cost_pixels_first_1_1_count_4 + slice0cost_pixels_first_1_1_count_5 +
        slice0cost_pixels_first_1_1_count_7 + slice0cost_pixels_first_1_1_count_2;
      slice0cost_pixels_cost_1_2 <= slice0cost_pixels_first_1_2_count_6 + slice0cost_pixels_first_1_2_count_0 +
        slice0cost_pixels_first_1_2_count_1 + slice0cost_pixels_first_1_2_count_3 + slice0cost_pixels_first_1_2_count_8
        + slice0cost_pixels_first_1_2_count_4 + slice0cost_pixels_first_1_2_count_5 +
        slice0cost_pixels_first_1_2_count_7 + slice0cost_pixels_first_1_2_count_2;
      slice0cost_pixels_cost_1_3 <= slice0cost_pixels_first_1_3_count_6 + slice0cost_pixels_first_1_3_count_0 +
        slice0cost_pixels_first_1_3_count_1 + slice0cost_pixels_first_1_3_count_3 + slice0cost_pixels_first_1_3_count_8
        + slice0cost_pixels_first_1_3_count_4 + slice0cost_pixels_first_1_3_count_5 +
        slice0cost_pixels_first_1_3_count_7 + slice0cost_pixels_first_1_3_count_2;
      slice0cost_pixels_cost_1_4 <= slice0cost_pixels_first_1_4_count_6 + slice0cost_pixels_first_1_4_count_0 +
        slice0cost_pixels_first_1_4_count_1 + slice0cost_pixels_first_1_4_count_3 + slice0cost_pixels_first_1_4_count_8
        + slice0cost_pixels_first_1_4_count_4 + slice0cost_pixels_first_1_4_count_5 +
        slice0cost_pixels_first_1_4_count_7 + slice0cost_pixels_first_1_4_count_2;
      slice0cost_pixels_cost_1_5 <= slice0cost_pixels_first_1_5_count_6 + slice0cost_pixels_first_1_5_count_0 +
        slice0cost_pixels_first_1_5_count_1 + slice0cost_pixels_first_1_5_count_3 + slice0cost_pixels_first_1_5_count_8
        + slice0cost_pixels_first_1_5_count_4 + slice0cost_pixels_first_1_5_count_5 +
        slice0cost_pixels_first_1_5_count_7 + slice0cost_pixels_first_1_5_count_2;
      slice0cost_pixels_cost_1_6 <= slice0cost_pixels_first_1_6_count_6 + slice0cost_pixels_first_1_6_count_0 +
        slice0cost_pixels_first_1_6_count_1 + slice0cost_pixels_first_1_6_count_3 + slice0cost_pixels_first_1_6_count_8
        + slice0cost_pixels_first_1_6_count_4 + slice0cost_pixels_first_1_6_count_5 +
        slice0cost_pixels_first_1_6_count_7 + slice0cost_pixels_first_1_6_count_2;
      slice0cost_pixels_cost_1_7 <= slice0cost_pixels_first_1_7_count_6 + slice0cost_pixels_first_1_7_count_0 +
        slice0cost_pixels_first_1_7_count_1 + slice0cost_pixels_first_1_7_count_3 + slice0cost_pixels_first_1_7_count_8
        + slice0cost_pixels_first_1_7_count_4 + slice0cost_pixels_first_1_7_count_5 +
        slice0cost_pixels_first_1_7_count_7 + slice0cost_pixels_first_1_7_count_2;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_first_column <= slice0cost_pixels_first_tag_first_column;
      slice0cost_change_column <= slice0cost_read_column;
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
      slice0cost_ready_tag_map_column <= slice0cost_pixels_tag_map_column;
      slice0cost_ready_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_ready_tag_first_column <= slice0cost_pixels_tag_first_column;
      slice0cost_column_0_0 <= slice0cost_column_0_0_choice_2;
      slice0cost_column_0_1 <= slice0cost_column_0_1_choice_2;
      slice0cost_column_0_2 <= slice0cost_column_0_2_choice_2;
      slice0cost_column_0_3 <= slice0cost_column_0_3_choice_2;
      slice0cost_column_0_4 <= slice0cost_column_0_4_choice_2;
      slice0cost_column_0_5 <= slice0cost_column_0_5_choice_2;
      slice0cost_column_0_6 <= slice0cost_column_0_6_choice_2;
      slice0cost_column_0_7 <= slice0cost_column_0_7_choice_2;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_first_cost <= slice0cost_ready_tag_first_cost;
      slice0cost_tag_leaves_window <= slice0cost_ready_tag_leaves_window;
      slice0cost_tag_map_column <= slice0cost_ready_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_ready_tag_output_column;
      slice0cost_tag_first_column <= slice0cost_ready_tag_first_column;
      if slice0shift_tag_valid then
        if slice0shift_tag_row_start then
          slice0cost_read_column <= 0;
        else
          slice0cost_read_column <= (slice0cost_read_column + 1) mod 8192;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        slice0cost_write_column <= slice0cost_ready_column;
        slice0cost_write_words_0 <= (slice0cost_column_0_1_choice_2 * 256) + slice0cost_column_0_0_choice_2;
        slice0cost_write_words_1 <= (slice0cost_column_0_3_choice_2 * 256) + slice0cost_column_0_2_choice_2;
        slice0cost_write_words_2 <= (slice0cost_column_0_5_choice_2 * 256) + slice0cost_column_0_4_choice_2;
        slice0cost_write_words_3 <= (slice0cost_column_0_7_choice_2 * 256) + slice0cost_column_0_6_choice_2;
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
      slice0window_entering_tag_map_column <= slice0cost_tag_map_column;
      slice0window_entering_tag_output_column <= slice0cost_tag_output_column;
      slice0window_entering_tag_first_column <= slice0window_entering_tag_first_cost;
      slice0window_change_0_0 <= slice0window_entering_0_0 - slice0window_change_0_0_choice;
      slice0window_change_0_1 <= slice0window_entering_0_1 - slice0window_change_0_1_choice;
      slice0window_change_0_2 <= slice0window_entering_0_2 - slice0window_change_0_2_choice;
      slice0window_change_0_3 <= slice0window_entering_0_3 - slice0window_change_0_3_choice;
      slice0window_change_0_4 <= slice0window_entering_0_4 - slice0window_change_0_4_choice;
      slice0window_change_0_5 <= slice0window_entering_0_5 - slice0window_change_0_5_choice;
      slice0window_change_0_6 <= slice0window_entering_0_6 - slice0window_change_0_6_choice;
      slice0window_change_0_7 <= slice0window_entering_0_7 - slice0window_change_0_7_choice;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_cost <= slice0cost_tag_first_column;
      slice0window_change_tag_map_column <= slice0window_entering_tag_map_column;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_first_column <= slice0window_entering_tag_first_column;
      slice0window_tag_valid <= slice0window_change_tag_valid;
      slice0window_tag_map_column <= slice0window_centre_map_column_3;
      slice0window_tag_output_column <= slice0window_centre_output_column_3;
      slice0window_tag_first_column <= slice0window_centre_first_column_3;
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
        slice0window_sum_0_0 <= (slice0window_sum_0_0_choice + slice0window_change_0_0) mod 4096;
        slice0window_sum_0_1 <= (slice0window_sum_0_1_choice + slice0window_change_0_1) mod 4096;
        slice0window_sum_0_2 <= (slice0window_sum_0_2_choice + slice0window_change_0_2) mod 4096;
        slice0window_sum_0_3 <= (slice0window_sum_0_3_choice + slice0window_change_0_3) mod 4096;
        slice0window_sum_0_4 <= (slice0window_sum_0_4_choice + slice0window_change_0_4) mod 4096;
        slice0window_sum_0_5 <= (slice0window_sum_0_5_choice + slice0window_change_0_5) mod 4096;
        slice0window_sum_0_6 <= (slice0window_sum_0_6_choice + slice0window_change_0_6) mod 4096;
        slice0window_sum_0_7 <= (slice0window_sum_0_7_choice + slice0window_change_0_7) mod 4096;
        slice0window_centre_map_column_0 <= slice0window_change_tag_map_column;
        slice0window_centre_map_column_1 <= slice0window_centre_map_column_0;
        slice0window_centre_map_column_2 <= slice0window_centre_map_column_1;
        slice0window_centre_map_column_3 <= slice0window_centre_map_column_2;
        slice0window_centre_output_column_0 <= slice0window_change_tag_output_column;
        slice0window_centre_output_column_1 <= slice0window_centre_output_column_0;
        slice0window_centre_output_column_2 <= slice0window_centre_output_column_1;
        slice0window_centre_output_column_3 <= slice0window_centre_output_column_2;
        slice0window_centre_first_column_0 <= slice0window_change_tag_first_column;
        slice0window_centre_first_column_1 <= slice0window_centre_first_column_0;
        slice0window_centre_first_column_2 <= slice0window_centre_first_column_1;
        slice0window_centre_first_column_3 <= slice0window_centre_first_column_2;
      end if;
      -- slice0other
      slice0other_cost_0_1_all := slice0window_tag_output_column and slice0window_tag_first_column;
      if (slice0window_sum_0_1 - slice0other_cost_0_0) < 0 then
        slice0other_cost_0_1_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_1_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0window_sum_0_2 - slice0other_cost_0_1) < 0 then
        slice0other_cost_0_2_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_2_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0window_sum_0_3 - slice0other_cost_0_2) < 0 then
        slice0other_cost_0_3_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_3_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0window_sum_0_4 - slice0other_cost_0_3) < 0 then
        slice0other_cost_0_4_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_4_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0window_sum_0_5 - slice0other_cost_0_4) < 0 then
        slice0other_cost_0_5_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_5_choice := slice0other_cost_0_1_all;
      end if;
      if (slice0window_sum_0_6 - slice0other_cost_0_5) < 0 then
        slice0other_cost_0_6_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_6_choice := slice0other_cost_0_1_all;
      end if;
      slice0other_cost_0_7_all := slice0window_tag_output_column and (((slice0window_sum_0_7 - slice0other_cost_0_6) <
        0) or slice0window_tag_first_column);
      if slice0window_tag_valid then
        slice0other_winner_0_1 <= slice0other_cost_0_1_choice;
        if slice0window_tag_output_column then
          slice0other_cost_0_0 <= slice0window_sum_0_0;
        else
          slice0other_cost_0_0 <= 0;
        end if;
        if slice0other_cost_0_1_choice then
          slice0other_cost_0_1 <= slice0window_sum_0_1;
        else
          slice0other_cost_0_1 <= slice0other_cost_0_0;
        end if;
        if slice0other_cost_0_2_choice then
          slice0other_cost_0_2 <= slice0window_sum_0_2;
          slice0other_winner_0_2 <= 2;
        else
          slice0other_cost_0_2 <= slice0other_cost_0_1;
          slice0other_winner_0_2 <= as_number(slice0other_winner_0_1);
        end if;
        if slice0other_cost_0_3_choice then
          slice0other_cost_0_3 <= slice0window_sum_0_3;
          slice0other_winner_0_3 <= 3;
        else
          slice0other_cost_0_3 <= slice0other_cost_0_2;
          slice0other_winner_0_3 <= slice0other_winner_0_2;
        end if;
        if slice0other_cost_0_4_choice then
          slice0other_cost_0_4 <= slice0window_sum_0_4;
          slice0other_winner_0_4 <= 4;
        else
          slice0other_cost_0_4 <= slice0other_cost_0_3;
          slice0other_winner_0_4 <= slice0other_winner_0_3;
        end if;
        if slice0other_cost_0_5_choice then
          slice0other_cost_0_5 <= slice0window_sum_0_5;
          slice0other_winner_0_5 <= 5;
        else
          slice0other_cost_0_5 <= slice0other_cost_0_4;
          slice0other_winner_0_5 <= slice0other_winner_0_4;
        end if;
        if slice0other_cost_0_6_choice then
          slice0other_cost_0_6 <= slice0window_sum_0_6;
          slice0other_winner_0_6 <= 6;
        else
          slice0other_cost_0_6 <= slice0other_cost_0_5;
          slice0other_winner_0_6 <= slice0other_winner_0_5;
        end if;
        if slice0other_cost_0_7_all then
          slice0other_cost_0_7 <= slice0window_sum_0_7;
          slice0other_winner_0_7 <= 7;
        else
          slice0other_cost_0_7 <= slice0other_cost_0_6;
          slice0other_winner_0_7 <= slice0other_winner_0_6;
        end if;
      end if;
      slice0other_cost_out_0 <= slice0other_cost_0_7;
      -- slice0winner1
      slice0winner1_best_cost_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_best_cost_0_1_is_less := (slice0window_sum_0_3 - slice0window_sum_0_2) < 0;
      slice0winner1_best_cost_0_2_is_less := (slice0window_sum_0_5 - slice0window_sum_0_4) < 0;
      slice0winner1_best_cost_0_3_is_less := (slice0window_sum_0_7 - slice0window_sum_0_6) < 0;
      slice0winner1_held_0_0 <= slice0window_sum_0_0;
      slice0winner1_held_0_1 <= slice0window_sum_0_1;
      slice0winner1_held_0_2 <= slice0window_sum_0_2;
      slice0winner1_held_0_3 <= slice0window_sum_0_3;
      slice0winner1_held_0_4 <= slice0window_sum_0_4;
      slice0winner1_held_0_5 <= slice0window_sum_0_5;
      slice0winner1_held_0_6 <= slice0window_sum_0_6;
      slice0winner1_held_0_7 <= slice0window_sum_0_7;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_place_0_2 <= slice0winner1_best_cost_0_2_is_less;
      slice0winner1_best_late_cost_0_0 <= slice0winner1_best_cost_0_0;
      slice0winner1_best_late_cost_0_1 <= slice0winner1_best_cost_0_1;
      slice0winner1_best_late_cost_0_2 <= slice0winner1_best_cost_0_2;
      slice0winner1_best_late_cost_0_3 <= slice0winner1_best_cost_0_3;
      slice0winner1_best_but_first_0_0 <= slice0winner1_held_0_1;
      slice0winner1_best_but_first_0_1 <= slice0winner1_held_0_3;
      slice0winner1_best_but_first_0_2 <= slice0winner1_held_0_5;
      slice0winner1_best_but_first_0_3 <= slice0winner1_held_0_7;
      slice0winner1_best_but_last_0_0 <= slice0winner1_held_0_0;
      slice0winner1_best_but_last_0_1 <= slice0winner1_held_0_2;
      slice0winner1_best_but_last_0_2 <= slice0winner1_held_0_4;
      slice0winner1_best_but_last_0_3 <= slice0winner1_held_0_6;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_map_column <= slice0window_tag_map_column;
      slice0winner1_tag_first_column <= slice0window_tag_first_column;
      if slice0winner1_best_cost_0_0_is_less then
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_1;
        slice0winner1_best_below_0_0 <= slice0window_sum_0_0;
        slice0winner1_best_above_0_0 <= 0;
      else
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_0;
        slice0winner1_best_below_0_0 <= 0;
        slice0winner1_best_above_0_0 <= slice0window_sum_0_1;
      end if;
      if slice0winner1_best_cost_0_1_is_less then
        slice0winner1_best_cost_0_1 <= slice0window_sum_0_3;
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0_1 <= slice0window_sum_0_2;
        slice0winner1_best_above_0_1 <= 0;
      else
        slice0winner1_best_cost_0_1 <= slice0window_sum_0_2;
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0_1 <= 0;
        slice0winner1_best_above_0_1 <= slice0window_sum_0_3;
      end if;
      if slice0winner1_best_cost_0_2_is_less then
        slice0winner1_best_cost_0_2 <= slice0window_sum_0_5;
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0_2 <= slice0window_sum_0_4;
        slice0winner1_best_above_0_2 <= 0;
      else
        slice0winner1_best_cost_0_2 <= slice0window_sum_0_4;
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0_2 <= 0;
        slice0winner1_best_above_0_2 <= slice0window_sum_0_5;
      end if;
      if slice0winner1_best_cost_0_3_is_less then
        slice0winner1_best_cost_0_3 <= slice0window_sum_0_7;
        slice0winner1_best_index_0_3 <= 7;
        slice0winner1_best_below_0_3 <= slice0window_sum_0_6;
        slice0winner1_best_above_0_3 <= 0;
      else
        slice0winner1_best_cost_0_3 <= slice0window_sum_0_6;
        slice0winner1_best_index_0_3 <= 6;
        slice0winner1_best_below_0_3 <= 0;
        slice0winner1_best_above_0_3 <= slice0window_sum_0_7;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      slice0winner2_best_cost_0_1_is_less := (slice0winner1_best_cost_0_3 - slice0winner1_best_cost_0_2) < 0;
      slice0winner2_best_below_0_0_is_equal := slice0winner1_best_index_0_1 = 2;
      if slice0winner2_best_below_0_0_is_equal then
        slice0winner2_best_below_0_0_choice := slice0winner1_held_0_1;
      else
        slice0winner2_best_below_0_0_choice := slice0winner1_best_below_0_1;
      end if;
      slice0winner2_best_below_0_1_is_equal := slice0winner1_best_index_0_3 = 6;
      if slice0winner2_best_below_0_1_is_equal then
        slice0winner2_best_below_0_1_choice := slice0winner1_held_0_5;
      else
        slice0winner2_best_below_0_1_choice := slice0winner1_best_below_0_3;
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_0_choice := slice0winner1_held_0_2;
      else
        slice0winner2_best_above_0_0_choice := slice0winner1_best_above_0_0;
      end if;
      if slice0winner1_best_place_0_2 then
        slice0winner2_best_above_0_1_choice := slice0winner1_held_0_6;
      else
        slice0winner2_best_above_0_1_choice := slice0winner1_best_above_0_2;
      end if;
      if slice0winner2_best_place_0_0 then
        slice0winner2_best_second_0_0_choice := 4095;
      else
        slice0winner2_best_second_0_0_choice := slice0winner1_best_late_cost_0_1;
      end if;
      if slice0winner2_best_at_end_0_0 then
        slice0winner2_best_second_0_0_choice_2 := slice0winner1_best_but_first_0_1;
      else
        slice0winner2_best_second_0_0_choice_2 := slice0winner2_best_second_0_0_choice;
      end if;
      if slice0winner2_best_place_0_0 then
        slice0winner2_best_second_0_0_choice_3 := slice0winner1_best_late_cost_0_0;
      else
        slice0winner2_best_second_0_0_choice_3 := 4095;
      end if;
      if slice0winner2_best_at_start_0_0 then
        slice0winner2_best_second_0_0_choice_4 := slice0winner1_best_but_last_0_0;
      else
        slice0winner2_best_second_0_0_choice_4 := slice0winner2_best_second_0_0_choice_3;
      end if;
      if slice0winner2_best_place_0_1 then
        slice0winner2_best_second_0_1_choice := 4095;
      else
        slice0winner2_best_second_0_1_choice := slice0winner1_best_late_cost_0_3;
      end if;
      if slice0winner2_best_at_end_0_1 then
        slice0winner2_best_second_0_1_choice_2 := slice0winner1_best_but_first_0_3;
      else
        slice0winner2_best_second_0_1_choice_2 := slice0winner2_best_second_0_1_choice;
      end if;
      if slice0winner2_best_place_0_1 then
        slice0winner2_best_second_0_1_choice_3 := slice0winner1_best_late_cost_0_2;
      else
        slice0winner2_best_second_0_1_choice_3 := 4095;
      end if;
      if slice0winner2_best_at_start_0_1 then
        slice0winner2_best_second_0_1_choice_4 := slice0winner1_best_but_last_0_2;
      else
        slice0winner2_best_second_0_1_choice_4 := slice0winner2_best_second_0_1_choice_3;
      end if;
      slice0winner2_best_first_0_0 <= slice0winner1_held_0_0;
      slice0winner2_best_first_0_1 <= slice0winner1_held_0_4;
      slice0winner2_best_last_0_0 <= slice0winner1_held_0_3;
      slice0winner2_best_last_0_1 <= slice0winner1_held_0_7;
      slice0winner2_best_place_0_0 <= slice0winner2_best_cost_0_0_is_less;
      slice0winner2_best_place_0_1 <= slice0winner2_best_cost_0_1_is_less;
      slice0winner2_best_at_start_0_0 <= slice0winner2_best_cost_0_0_is_less and slice0winner2_best_below_0_0_is_equal;
      slice0winner2_best_at_start_0_1 <= slice0winner2_best_cost_0_1_is_less and slice0winner2_best_below_0_1_is_equal;
      slice0winner2_best_at_end_0_0 <= slice0winner1_best_index_0_0 and ((slice0winner1_best_cost_0_1 -
        slice0winner1_best_cost_0_0) >= 0);
      slice0winner2_best_at_end_0_1 <= slice0winner1_best_place_0_2 and ((slice0winner1_best_cost_0_3 -
        slice0winner1_best_cost_0_2) >= 0);
      slice0winner2_best_late_cost_0_0 <= slice0winner2_best_cost_0_0;
      slice0winner2_best_late_cost_0_1 <= slice0winner2_best_cost_0_1;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
      slice0winner2_tag_first_column <= slice0winner1_tag_first_column;
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
      if (slice0winner2_best_second_0_0_choice_2 - slice0winner2_best_second_0_0_choice_4) < 0 then
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_2;
      else
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_4;
      end if;
      if (slice0winner2_best_second_0_1_choice_2 - slice0winner2_best_second_0_1_choice_4) < 0 then
        slice0winner2_best_second_0_1 <= slice0winner2_best_second_0_1_choice_2;
      else
        slice0winner2_best_second_0_1 <= slice0winner2_best_second_0_1_choice_4;
      end if;
      if (slice0winner1_best_late_cost_0_1 - slice0winner1_best_but_first_0_0) < 0 then
        slice0winner2_best_but_first_0_0 <= slice0winner1_best_late_cost_0_1;
      else
        slice0winner2_best_but_first_0_0 <= slice0winner1_best_but_first_0_0;
      end if;
      if (slice0winner1_best_late_cost_0_3 - slice0winner1_best_but_first_0_2) < 0 then
        slice0winner2_best_but_first_0_1 <= slice0winner1_best_late_cost_0_3;
      else
        slice0winner2_best_but_first_0_1 <= slice0winner1_best_but_first_0_2;
      end if;
      if (slice0winner1_best_but_last_0_1 - slice0winner1_best_late_cost_0_0) < 0 then
        slice0winner2_best_but_last_0_0 <= slice0winner1_best_but_last_0_1;
      else
        slice0winner2_best_but_last_0_0 <= slice0winner1_best_late_cost_0_0;
      end if;
      if (slice0winner1_best_but_last_0_3 - slice0winner1_best_late_cost_0_2) < 0 then
        slice0winner2_best_but_last_0_1 <= slice0winner1_best_but_last_0_3;
      else
        slice0winner2_best_but_last_0_1 <= slice0winner1_best_late_cost_0_2;
      end if;
      -- slice0winner3
      slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0_1 - slice0winner2_best_cost_0_0) < 0;
      slice0winner3_best_below_0_0_is_equal := slice0winner2_best_index_0_1 = 4;
      if slice0winner3_best_below_0_0_is_equal then
        slice0winner3_best_below_0_0_choice := slice0winner2_best_last_0_0;
      else
        slice0winner3_best_below_0_0_choice := slice0winner2_best_below_0_1;
      end if;
      slice0winner3_best_above_0_0_is_equal := slice0winner2_best_index_0_0 = 3;
      if slice0winner3_best_above_0_0_is_equal then
        slice0winner3_best_above_0_0_choice := slice0winner2_best_first_0_1;
      else
        slice0winner3_best_above_0_0_choice := slice0winner2_best_above_0_0;
      end if;
      if slice0winner3_best_place_0_0 then
        slice0winner3_best_second_0_0_choice := slice0winner2_best_second_0_1;
      else
        slice0winner3_best_second_0_0_choice := slice0winner2_best_late_cost_0_1;
      end if;
      if slice0winner3_best_at_end_0_0 then
        slice0winner3_best_second_0_0_choice_2 := slice0winner2_best_but_first_0_1;
      else
        slice0winner3_best_second_0_0_choice_2 := slice0winner3_best_second_0_0_choice;
      end if;
      if slice0winner3_best_place_0_0 then
        slice0winner3_best_second_0_0_choice_3 := slice0winner2_best_late_cost_0_0;
      else
        slice0winner3_best_second_0_0_choice_3 := slice0winner2_best_second_0_0;
      end if;
      if slice0winner3_best_at_start_0_0 then
        slice0winner3_best_second_0_0_choice_4 := slice0winner2_best_but_last_0_0;
      else
        slice0winner3_best_second_0_0_choice_4 := slice0winner3_best_second_0_0_choice_3;
      end if;
      slice0winner3_best_first_0_0 <= slice0winner2_best_first_0_0;
      slice0winner3_best_last_0_0 <= slice0winner2_best_last_0_1;
      slice0winner3_best_place_0_0 <= slice0winner3_best_cost_0_0_is_less;
      slice0winner3_best_at_start_0_0 <= slice0winner3_best_cost_0_0_is_less and slice0winner3_best_below_0_0_is_equal;
      slice0winner3_best_at_end_0_0 <= ((slice0winner2_best_cost_0_1 - slice0winner2_best_cost_0_0) >= 0) and
        slice0winner3_best_above_0_0_is_equal;
      slice0winner3_best_late_cost_0_0 <= slice0winner3_best_cost_0_0;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_map_column <= slice0winner2_tag_map_column;
      slice0winner3_tag_first_column <= slice0winner2_tag_first_column;
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
      if (slice0winner3_best_second_0_0_choice_2 - slice0winner3_best_second_0_0_choice_4) < 0 then
        slice0winner3_best_second_0_0 <= slice0winner3_best_second_0_0_choice_2;
      else
        slice0winner3_best_second_0_0 <= slice0winner3_best_second_0_0_choice_4;
      end if;
      if (slice0winner2_best_late_cost_0_1 - slice0winner2_best_but_first_0_0) < 0 then
        slice0winner3_best_but_first_0_0 <= slice0winner2_best_late_cost_0_1;
      else
        slice0winner3_best_but_first_0_0 <= slice0winner2_best_but_first_0_0;
      end if;
      if (slice0winner2_best_but_last_0_1 - slice0winner2_best_late_cost_0_0) < 0 then
        slice0winner3_best_but_last_0_0 <= slice0winner2_best_but_last_0_1;
      else
        slice0winner3_best_but_last_0_0 <= slice0winner2_best_late_cost_0_0;
      end if;
      -- slice0
      slice0_best_index_0_0 <= slice0winner3_best_index_0_0;
      slice0_best_below_0_0 <= slice0winner3_best_below_0_0;
      slice0_best_above_0_0 <= slice0winner3_best_above_0_0;
      slice0_best_first_0_0 <= slice0winner3_best_first_0_0;
      slice0_best_last_0_0 <= slice0winner3_best_last_0_0;
      slice0_best_late_cost_0_0 <= slice0winner3_best_late_cost_0_0;
      slice0_best_second_0_0 <= slice0winner3_best_second_0_0;
      slice0_best_but_first_0_0 <= slice0winner3_best_but_first_0_0;
      slice0_best_but_last_0_0 <= slice0winner3_best_but_last_0_0;
      slice0_best_tag_valid <= slice0winner3_tag_valid;
      slice0_best_tag_map_column <= slice0winner3_tag_map_column;
      slice0_best_tag_first_column <= slice0winner3_tag_first_column;
      -- best
      best_base_any := (not best_waiting_tag_valid) or (not best_waiting_tag_first_column);
      best_base_is_equal := best_pass = 7;
      if best_base_is_equal then
        best_base_choice := 0;
      else
        best_base_choice := ((best_base / 8) + 1) mod 32;
      end if;
      if best_base_any then
        best_base_choice_2 := best_base / 8;
      else
        best_base_choice_2 := best_base_choice;
      end if;
      best_first_pass_is_equal := best_pass = 0;
      best_before_is_last_value := ((best_last_before / 64) mod 2) = 1;
      if best_before_is_last_value then
        best_before_is_last_choice := (best_ready_words_0 / 262144) = 3;
      else
        best_before_is_last_choice := (best_ready_words_0 / 262144) = 2;
      end if;
      if best_before_is_last_value then
        best_before_is_last_choice_2 := (best_ready_words_0 / 262144) = 1;
      else
        best_before_is_last_choice_2 := (best_ready_words_0 / 262144) = 0;
      end if;
      if (best_last_before / 128) = 1 then
        best_before_is_last_choice_3 := best_before_is_last_choice;
      else
        best_before_is_last_choice_3 := best_before_is_last_choice_2;
      end if;
      best_before_is_last_value_2 := ((best_last_before / 16) mod 2) = 1;
      best_before_is_last_value_3 := (best_ready_words_0 / 65536) mod 4;
      if best_before_is_last_value_2 then
        best_before_is_last_choice_4 := best_before_is_last_value_3 = 3;
      else
        best_before_is_last_choice_4 := best_before_is_last_value_3 = 2;
      end if;
      if best_before_is_last_value_2 then
        best_before_is_last_choice_5 := best_before_is_last_value_3 = 1;
      else
        best_before_is_last_choice_5 := best_before_is_last_value_3 = 0;
      end if;
      if ((best_last_before / 32) mod 2) = 1 then
        best_before_is_last_choice_6 := best_before_is_last_choice_4;
      else
        best_before_is_last_choice_6 := best_before_is_last_choice_5;
      end if;
      best_before_is_last_value_4 := (best_ready_words_0 / 16384) mod 4;
      if ((best_last_before / 8) mod 2) = 1 then
        best_before_is_last_choice_7 := best_before_is_last_value_4 = 3;
      else
        best_before_is_last_choice_7 := best_before_is_last_value_4 = 1;
      end if;
      if best_here_is_first then
        best_best_below_0_0_choice := best_compared_words_2;
      else
        best_best_below_0_0_choice := best_compared_below_0_0;
      end if;
      if best_before_is_last then
        best_best_above_0_0_choice := best_compared_first_0_0;
      else
        best_best_above_0_0_choice := best_compared_words_1 / 4096;
      end if;
      if best_best_place_0_0 then
        best_best_second_0_0_choice := best_compared_second_0_0;
      else
        best_best_second_0_0_choice := best_compared_late_cost_0_0;
      end if;
      if best_best_at_end_0_0 then
        best_best_second_0_0_choice_2 := best_compared_but_first_0_0;
      else
        best_best_second_0_0_choice_2 := best_best_second_0_0_choice;
      end if;
      if best_was_first then
        best_best_second_0_0_choice_3 := to_unsigned(4095, 12) & to_unsigned(4095, 16) & to_unsigned(4095, 16) &
          to_unsigned(4095, 16);
      else
        best_best_second_0_0_choice_3 := to_unsigned((best_compared_losers_0 / 4096), 12) & to_unsigned(4095, 16) &
          to_unsigned((best_compared_losers_0 mod 4096), 16) & to_unsigned(best_kept_cost, 16);
      end if;
      if best_was_first then
        best_best_second_0_0_choice_4 := 4095;
      else
        best_best_second_0_0_choice_4 := best_kept_cost;
      end if;
      if best_best_place_0_0 then
        best_best_second_0_0_choice_5 := best_best_second_0_0_choice_4;
      else
        best_best_second_0_0_choice_5 := to_integer(best_best_second_0_0_choice_3(27 downto 16));
      end if;
      if best_best_at_start_0_0 then
        best_best_second_0_0_choice_6 := to_integer(best_best_second_0_0_choice_3(59 downto 48));
      else
        best_best_second_0_0_choice_6 := best_best_second_0_0_choice_5;
      end if;
      if best_compared_tag_first_column then
        best_write_column_choice := 0;
      else
        best_write_column_choice := (best_place_column + 1) mod 1024;
      end if;
      if best_compared_tag_valid then
        best_write_column_choice_2 := best_write_column_choice;
      else
        best_write_column_choice_2 := best_place_column;
      end if;
      best_read_index_0_0 <= slice0_best_index_0_0;
      best_read_below_0_0 <= slice0_best_below_0_0;
      best_read_above_0_0 <= slice0_best_above_0_0;
      best_read_first_0_0 <= slice0_best_first_0_0;
      best_read_last_0_0 <= slice0_best_last_0_0;
      best_read_late_cost_0_0 <= slice0_best_late_cost_0_0;
      best_read_second_0_0 <= slice0_best_second_0_0;
      best_read_but_first_0_0 <= slice0_best_but_first_0_0;
      best_read_but_last_0_0 <= slice0_best_but_last_0_0;
      best_read_tag_valid <= slice0_best_tag_valid;
      best_read_tag_map_column <= slice0_best_tag_map_column;
      best_read_tag_first_column <= slice0_best_tag_first_column;
      best_late_column <= best_column;
      best_waiting_index_0_0 <= best_read_index_0_0;
      best_waiting_below_0_0 <= best_read_below_0_0;
      best_waiting_above_0_0 <= best_read_above_0_0;
      best_waiting_first_0_0 <= best_read_first_0_0;
      best_waiting_last_0_0 <= best_read_last_0_0;
      best_waiting_late_cost_0_0 <= best_read_late_cost_0_0;
      best_waiting_second_0_0 <= best_read_second_0_0;
      best_waiting_but_first_0_0 <= best_read_but_first_0_0;
      best_waiting_but_last_0_0 <= best_read_but_last_0_0;
      best_waiting_tag_valid <= best_read_tag_valid;
      best_waiting_tag_map_column <= best_read_tag_map_column;
      best_waiting_tag_first_column <= best_read_tag_first_column;
      best_ready_index_0_0 <= best_waiting_index_0_0;
      best_ready_below_0_0 <= best_waiting_below_0_0;
      best_ready_above_0_0 <= best_waiting_above_0_0;
      best_ready_first_0_0 <= best_waiting_first_0_0;
      best_ready_last_0_0 <= best_waiting_last_0_0;
      best_ready_late_cost_0_0 <= best_waiting_late_cost_0_0;
      best_ready_second_0_0 <= best_waiting_second_0_0;
      best_ready_but_first_0_0 <= best_waiting_but_first_0_0;
      best_ready_but_last_0_0 <= best_waiting_but_last_0_0;
      best_ready_tag_valid <= best_waiting_tag_valid;
      best_ready_tag_map_column <= best_waiting_tag_map_column;
      best_ready_tag_first_column <= best_waiting_tag_first_column;
      best_ready_words_0 <= to_integer(best_read_words_0);
      best_ready_words_1 <= to_integer(best_read_words_1);
      best_ready_words_2 <= to_integer(best_read_words_2);
      best_ready_losers_0 <= to_integer(best_read_losers_0);
      best_base <= best_base_choice_2 * 8;
      best_compared_index_0_0 <= ((best_base / 8) * 8) + best_ready_index_0_0;
      best_compared_below_0_0 <= best_ready_below_0_0;
      best_compared_above_0_0 <= best_ready_above_0_0;
      best_compared_first_0_0 <= best_ready_first_0_0;
      best_compared_last_0_0 <= best_ready_last_0_0;
      best_compared_late_cost_0_0 <= best_ready_late_cost_0_0;
      best_compared_second_0_0 <= best_ready_second_0_0;
      best_compared_but_first_0_0 <= best_ready_but_first_0_0;
      best_compared_but_last_0_0 <= best_ready_but_last_0_0;
      best_compared_tag_valid <= best_ready_tag_valid;
      best_compared_tag_map_column <= best_ready_tag_map_column;
      best_compared_tag_first_column <= best_ready_tag_first_column;
      best_compared_words_1 <= best_ready_words_1;
      best_compared_words_2 <= best_ready_words_2;
      best_compared_losers_0 <= best_ready_losers_0;
      best_first_pass <= best_first_pass_is_equal;
      best_last_pass <= best_base_is_equal;
      best_here_wins <= ((best_waiting_late_cost_0_0 - (best_ready_words_0 mod 4096)) < 0) or best_first_pass_is_equal;
      best_here_is_first <= best_ready_index_0_0 = 0;
      best_before_is_last <= best_before_is_last_choice_3 and best_before_is_last_choice_6 and
        best_before_is_last_choice_7 and (((best_ready_words_0 / 4096) mod 4) = 3);
      best_best_last_0_0 <= best_compared_last_0_0;
      best_best_place_0_0 <= best_here_wins;
      best_best_at_start_0_0 <= (not best_first_pass) and best_here_is_first and best_here_wins;
      best_best_at_end_0_0 <= best_before_is_last and (not best_here_wins);
      best_best_late_cost_0_0 <= best_best_cost_0_0;
      best_best_tag_valid <= best_compared_tag_valid;
      best_best_tag_map_column <= best_last_pass and best_compared_tag_map_column;
      best_best_tag_first_column <= best_last_pass and best_compared_tag_first_column;
      best_late_write_column <= best_write_column;
      best_kept_cost <= other_13;
      best_was_first <= best_first_pass;
      if best_here_wins then
        best_best_cost_0_0 <= best_ready_late_cost_0_0;
        best_best_index_0_0 <= best_compared_index_0_0;
        best_best_below_0_0 <= best_best_below_0_0_choice;
        best_best_above_0_0 <= best_compared_above_0_0;
      else
        best_best_cost_0_0 <= other_13;
        best_best_index_0_0 <= other_5;
        best_best_below_0_0 <= best_compared_words_1 mod 4096;
        best_best_above_0_0 <= best_best_above_0_0_choice;
      end if;
      if (best_best_second_0_0_choice_2 - best_best_second_0_0_choice_6) < 0 then
        best_best_second_0_0 <= best_best_second_0_0_choice_2;
      else
        best_best_second_0_0 <= best_best_second_0_0_choice_6;
      end if;
      if (best_compared_but_last_0_0 - best_best_second_0_0_choice_4) < 0 then
        best_best_but_last_0_0 <= best_compared_but_last_0_0;
      else
        best_best_but_last_0_0 <= best_best_second_0_0_choice_4;
      end if;
      if (not best_compared_tag_map_column) or (not best_compared_tag_valid) then
        best_write_column <= 1023;
      else
        best_write_column <= best_write_column_choice_2;
      end if;
      if slice0_best_tag_valid then
        if slice0_best_tag_first_column then
          best_column <= 0;
        else
          best_column <= (best_column + 1) mod 1024;
        end if;
      end if;
      if not best_base_any then
        if best_base_is_equal then
          best_pass <= 0;
          best_last_before <= 255;
        else
          best_pass <= (best_pass + 1) mod 8;
          best_last_before <= ((((best_last_before / 8) + 1) mod 32) * 8) + 7;
        end if;
      end if;
      if best_compared_tag_valid then
        best_place_column <= best_write_column_choice;
      end if;
      -- refinement
      refinement_remainder_1_0_difference := (refinement_remainder_0_0 + 8192) - refinement_divisor_0_0;
      refinement_remainder_2_0_difference := ((refinement_remainder_1_0 * 2) + 8192) - refinement_divisor_1_0;
      refinement_remainder_3_0_difference := ((refinement_remainder_2_0 * 2) + 8192) - refinement_divisor_2_0;
      refinement_remainder_4_0_difference := ((refinement_remainder_3_0 * 2) + 8192) - refinement_divisor_3_0;
      refinement_remainder_5_0_difference := ((refinement_remainder_4_0 * 2) + 8192) - refinement_divisor_4_0;
      refinement_remainder_6_0_difference := ((refinement_remainder_5_0 * 2) + 8192) - refinement_divisor_5_0;
      refinement_remainder_7_0_difference := ((refinement_remainder_6_0 * 2) + 8192) - refinement_divisor_6_0;
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
      refinement_disparity_0_0 <= best_best_index_0_0;
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
      refinement_passed_2_0 <= transform_ready_column_inside_4;
      refinement_passed_4_0 <= refinement_passed_3_0;
      refinement_passed_5_0 <= refinement_passed_4_0;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_9_0 <= refinement_passed_8_0;
      refinement_passed_10_0 <= refinement_passed_9_0;
      refinement_passed_11_0 <= refinement_passed_10_0;
      refinement_tag_0_valid <= best_best_tag_valid;
      refinement_tag_0_map_column <= best_best_tag_map_column;
      refinement_tag_0_first_column <= best_best_tag_first_column;
      refinement_tag_1_valid <= refinement_tag_0_valid;
      refinement_tag_1_map_column <= refinement_tag_0_map_column;
      refinement_tag_1_first_column <= refinement_tag_0_first_column;
      refinement_tag_2_valid <= refinement_tag_1_valid;
      refinement_tag_2_map_column <= refinement_tag_1_map_column;
      refinement_tag_2_first_column <= refinement_tag_1_first_column;
      refinement_tag_3_valid <= refinement_tag_2_valid;
      refinement_tag_3_map_column <= refinement_tag_2_map_column;
      refinement_tag_3_first_column <= refinement_tag_2_first_column;
      refinement_tag_4_valid <= refinement_tag_3_valid;
      refinement_tag_4_map_column <= refinement_tag_3_map_column;
      refinement_tag_4_first_column <= refinement_tag_3_first_column;
      refinement_tag_5_valid <= refinement_tag_4_valid;
      refinement_tag_5_map_column <= refinement_tag_4_map_column;
      refinement_tag_5_first_column <= refinement_tag_4_first_column;
      refinement_tag_6_valid <= refinement_tag_5_valid;
      refinement_tag_6_map_column <= refinement_tag_5_map_column;
      refinement_tag_6_first_column <= refinement_tag_5_first_column;
      refinement_tag_7_valid <= refinement_tag_6_valid;
      refinement_tag_7_map_column <= refinement_tag_6_map_column;
      refinement_tag_7_first_column <= refinement_tag_6_first_column;
      refinement_tag_8_valid <= refinement_tag_7_valid;
      refinement_tag_8_map_column <= refinement_tag_7_map_column;
      refinement_tag_8_first_column <= refinement_tag_7_first_column;
      refinement_tag_9_valid <= refinement_tag_8_valid;
      refinement_tag_9_map_column <= refinement_tag_8_map_column;
      refinement_tag_9_first_column <= refinement_tag_8_first_column;
      refinement_tag_10_valid <= refinement_tag_9_valid;
      refinement_tag_10_map_column <= refinement_tag_9_map_column;
      refinement_tag_10_first_column <= refinement_tag_9_first_column;
      refinement_tag_11_valid <= refinement_tag_10_valid;
      refinement_tag_11_map_column <= refinement_tag_10_map_column;
      refinement_tag_11_first_column <= refinement_tag_10_first_column;
      refinement_alone_0_0 <= best_best_second_0_0 = 4095;
      refinement_alone_1_0 <= refinement_alone_0_0;
      refinement_gap_0 <= (best_best_second_0_0 - best_best_late_cost_0_0) mod 4096;
      refinement_lowest_0 <= best_best_late_cost_0_0;
      refinement_scaled_gap_0 <= (((refinement_gap_0 + (refinement_gap_0 / 4)) * 4) + (refinement_gap_0 mod 4)) * 4;
      refinement_scaled_cost_0 <= refinement_lowest_0;
      refinement_u_0 <= (refinement_below_0 - best_best_late_cost_0_0) mod 4096;
      refinement_v_0 <= (refinement_above_0 - best_best_late_cost_0_0) mod 4096;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_divisor_0_0 <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 12)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 12))));
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_quotient_8_0 <= ((((8192 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) / 4096) +
        ((other_6 / 2) * 2);
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
      if refinement_alone_1_0 then
        refinement_passed_3_0 <= transform_columns_column_inside_4;
      else
        refinement_passed_3_0 <= transform_columns_column_inside_4 and ((refinement_scaled_cost_0 -
          refinement_scaled_gap_0) < 0);
      end if;
      if best_best_index_0_0 = 0 then
        refinement_below_0 <= best_best_above_0_0;
      else
        refinement_below_0 <= best_best_below_0_0;
      end if;
      if best_best_index_0_0 = 63 then
        refinement_above_0 <= best_best_below_0_0;
      else
        refinement_above_0 <= best_best_above_0_0;
      end if;
      if (refinement_remainder_1_0_difference / 8192) = 1 then
        refinement_remainder_1_0 <= refinement_remainder_1_0_difference mod 4096;
      else
        refinement_remainder_1_0 <= refinement_remainder_0_0;
      end if;
      if (refinement_remainder_2_0_difference / 8192) = 1 then
        refinement_remainder_2_0 <= refinement_remainder_2_0_difference mod 4096;
      else
        refinement_remainder_2_0 <= (refinement_remainder_1_0 mod 2048) * 2;
      end if;
      if (refinement_remainder_3_0_difference / 8192) = 1 then
        refinement_remainder_3_0 <= refinement_remainder_3_0_difference mod 4096;
      else
        refinement_remainder_3_0 <= (refinement_remainder_2_0 mod 2048) * 2;
      end if;
      if (refinement_remainder_4_0_difference / 8192) = 1 then
        refinement_remainder_4_0 <= refinement_remainder_4_0_difference mod 4096;
      else
        refinement_remainder_4_0 <= (refinement_remainder_3_0 mod 2048) * 2;
      end if;
      if (refinement_remainder_5_0_difference / 8192) = 1 then
        refinement_remainder_5_0 <= refinement_remainder_5_0_difference mod 4096;
      else
        refinement_remainder_5_0 <= (refinement_remainder_4_0 mod 2048) * 2;
      end if;
      if (refinement_remainder_6_0_difference / 8192) = 1 then
        refinement_remainder_6_0 <= refinement_remainder_6_0_difference mod 4096;
      else
        refinement_remainder_6_0 <= (refinement_remainder_5_0 mod 2048) * 2;
      end if;
      if (refinement_remainder_7_0_difference / 8192) = 1 then
        refinement_remainder_7_0 <= refinement_remainder_7_0_difference mod 4096;
      else
        refinement_remainder_7_0 <= (refinement_remainder_6_0 mod 2048) * 2;
      end if;
      -- winners
      winners_row_differs := winners_row /= refinement_tag_11_first_column;
      if refinement_tag_11_map_column then
        if refinement_tag_11_valid then
          winners_row <= winners_row_differs;
        else
          winners_row <= winners_row;
        end if;
      end if;
      if refinement_tag_11_first_column then
        winners_column_choice := 0;
      else
        winners_column_choice := winners_column;
      end if;
      winners_column_any := (not refinement_tag_11_map_column) or (not refinement_tag_11_valid);
      if not winners_column_any then
        winners_column <= (winners_column_choice + 1) mod 1024;
      end if;
      winners_write_word_0 <= to_integer(((to_unsigned(as_number(refinement_passed_11_0), 1) &
        to_unsigned(refinement_disparity_11_0, 11)) or (to_unsigned((refinement_fraction_0 mod 64), 6) & to_unsigned(0,
        6))));
      winners_read_tag_valid <= passes_arrived;
      winners_read_tag_map_column <= (passes_write_address mod 1024) < 576;
      winners_read_tag_start_of_frame <= ((passes_write_address mod 1024) = 0) and passes_leaving_starts;
      winners_read_tag_end_of_line <= (passes_write_address mod 1024) = 575;
      winners_read_address <= passes_write_address;
      winners_winners_disparity_0 <= to_integer(winners_read_word_0(5 downto 0));
      winners_winners_fraction_0 <= to_integer(winners_read_word_0(10 downto 6));
      winners_winners_passed_0 <= to_integer(winners_read_word_0(11 downto 11)) = 1;
      winners_winners_tag_valid <= winners_read_tag_valid;
      winners_winners_tag_map_column <= winners_read_tag_map_column;
      winners_winners_tag_start_of_frame <= winners_read_tag_start_of_frame;
      winners_winners_tag_end_of_line <= winners_read_tag_end_of_line;
      winners_address_out <= winners_read_address;
      if winners_column_any then
        winners_write_address <= 2047;
      else
        winners_write_address <= (as_number(winners_row_differs) * 1024) + winners_column_choice;
      end if;
      -- check
      check_read_winner_all := slice0winner1_tag_valid and slice0winner1_tag_first_column;
      check_read_winner_all_2 := slice0winner1_tag_valid and slice0winner1_tag_first_column and (check_pass = 7);
      if check_read_winner_all_2 then
        check_read_winner_choice := 0;
      else
        check_read_winner_choice := ((check_base / 8) + 1) mod 32;
      end if;
      if check_read_winner_all then
        check_read_winner_choice_2 := check_read_winner_choice;
      else
        check_read_winner_choice_2 := check_base / 8;
      end if;
      if check_read_winner_all_2 then
        check_read_place_choice := 7;
      else
        check_read_place_choice := ((check_first / 8) + 127) mod 128;
      end if;
      check_read_counts_sum := check_columns + as_number((check_columns /= 583));
      if check_read_winner_all then
        check_read_counts_choice := 0;
      else
        check_read_counts_choice := check_read_counts_sum;
      end if;
      check_read_has_before_sum := check_pass + 1;
      if check_read_winner_all then
        check_read_has_before_choice := ((check_read_has_before_sum mod 8) / 4) = 1;
      else
        check_read_has_before_choice := (check_pass / 4) = 1;
      end if;
      if check_read_winner_all_2 then
        check_read_has_before_choice_2 := (not check_read_winner_all) and ((check_pass / 4) = 1);
      else
        check_read_has_before_choice_2 := check_read_has_before_choice;
      end if;
      check_read_has_before_is_less := 7 < check_read_counts_choice;
      check_read_has_before_value := ((check_pass / 2) mod 2) = 1;
      if check_read_winner_all then
        check_read_has_before_choice_3 := (((check_read_has_before_sum mod 8) / 2) mod 2) = 1;
      else
        check_read_has_before_choice_3 := check_read_has_before_value;
      end if;
      if check_read_winner_all_2 then
        check_read_has_before_choice_4 := (not check_read_winner_all) and check_read_has_before_value;
      else
        check_read_has_before_choice_4 := check_read_has_before_choice_3;
      end if;
      if check_read_winner_all then
        check_read_has_before_choice_5 := (check_read_has_before_sum mod 2) = 1;
      else
        check_read_has_before_choice_5 := (check_pass mod 2) = 1;
      end if;
      if check_read_winner_all_2 then
        check_read_has_before_choice_6 := (not check_read_winner_all) and ((check_pass mod 2) = 1);
      else
        check_read_has_before_choice_6 := check_read_has_before_choice_5;
      end if;
      if check_read_has_before_choice_4 then
        check_read_has_before_choice_7 := check_read_has_before_is_less;
      else
        check_read_has_before_choice_7 := check_read_has_before_choice_6 and check_read_has_before_is_less;
      end if;
      if check_read_winner_all then
        check_first_choice := check_read_place_choice;
      else
        check_first_choice := check_first / 8;
      end if;
      check_cost_any := ((check_ready_cost - (check_ready_words_0 mod 4096)) < 0) or (not check_ready_has_before);
      if check_ready_counts then
        check_write_place_choice := check_ready_place;
      else
        check_write_place_choice := 1023;
      end if;
      check_checked_passed_0_difference := (check_answered_disparity_0 + 1) - to_integer(check_found_0);
      check_checked_tag_row_start_differs := map_counter_group /= 481;
      check_checked_tag_row_start_is_equal := map_counter_column = 575;
      if check_checked_tag_row_start_is_equal then
        check_checked_tag_row_start_choice := check_checked_tag_row_start and (map_counter_group /= 480);
      else
        check_checked_tag_row_start_choice := check_checked_tag_row_start;
      end if;
      if check_checked_tag_row_start_differs then
        check_checked_tag_row_start_choice_2 := check_checked_tag_row_start_choice;
      else
        check_checked_tag_row_start_choice_2 := check_checked_tag_row_start;
      end if;
      check_checked_tag_row_start_is_equal_2 := map_counter_group = 479;
      check_checked_tag_row_start_all := check_checked_tag_row_start_is_equal_2 and
        check_checked_tag_row_start_is_equal;
      if check_checked_tag_row_start_choice_2 then
        check_checked_tag_row_start_choice_3 := (not check_checked_tag_start_of_frame) or
          check_checked_tag_row_start_all;
      else
        check_checked_tag_row_start_choice_3 := check_checked_tag_start_of_frame and
          check_checked_tag_row_start_is_equal_2 and check_checked_tag_row_start_is_equal;
      end if;
      check_checked_tag_row_start_all_2 := check_checked_tag_valid and check_checked_tag_map_column;
      check_read_winner <= (check_read_winner_choice_2 * 8) + slice0other_winner_0_7;
      check_read_counts <= (check_read_counts_choice < 583) and slice0winner1_tag_valid;
      check_read_row <= check_read_winner_all_2 /= check_read_row;
      check_base <= check_read_winner_choice_2 * 8;
      check_first <= check_first_choice * 8;
      check_waiting_cost <= slice0other_cost_out_0;
      check_waiting_winner <= check_read_winner;
      check_waiting_place <= check_read_place;
      check_waiting_counts <= check_read_counts;
      check_waiting_has_before <= check_read_has_before;
      check_waiting_row <= check_read_row;
      check_ready_cost <= check_waiting_cost;
      check_ready_winner <= check_waiting_winner;
      check_ready_place <= check_waiting_place;
      check_ready_counts <= check_waiting_counts;
      check_ready_has_before <= check_waiting_has_before;
      check_ready_row <= check_waiting_row;
      check_ready_words_0 <= to_integer(check_read_words_0);
      check_write_place <= check_write_place_choice;
      check_write_address <= check_write_place_choice + (as_number(check_ready_row) * 1024);
      check_asking_disparity_0 <= winners_winners_disparity_0;
      check_asking_fraction_0 <= winners_winners_fraction_0;
      check_asking_passed_0 <= winners_winners_passed_0;
      check_asking_tag_valid <= winners_winners_tag_valid;
      check_asking_tag_map_column <= winners_winners_tag_map_column;
      check_asking_tag_start_of_frame <= winners_winners_tag_start_of_frame;
      check_asking_tag_end_of_line <= winners_winners_tag_end_of_line;
      check_address <= (winners_address_out + (63 - winners_winners_disparity_0)) mod 2048;
      check_answered_disparity_0 <= check_asking_disparity_0;
      check_answered_fraction_0 <= check_asking_fraction_0;
      check_answered_passed_0 <= check_asking_passed_0;
      check_answered_tag_valid <= check_asking_tag_valid;
      check_answered_tag_map_column <= check_asking_tag_map_column;
      check_answered_tag_start_of_frame <= check_asking_tag_start_of_frame;
      check_answered_tag_end_of_line <= check_asking_tag_end_of_line;
      check_checked_disparity_0 <= check_answered_disparity_0;
      check_checked_fraction_0 <= check_answered_fraction_0;
      check_checked_passed_0 <= (check_checked_passed_0_difference >= 0) and (check_checked_passed_0_difference < 3)
        and check_answered_passed_0;
      check_checked_tag_valid <= check_answered_tag_valid;
      check_checked_tag_map_column <= check_answered_tag_map_column;
      check_checked_tag_start_of_frame <= check_answered_tag_start_of_frame;
      check_checked_tag_end_of_line <= check_answered_tag_end_of_line;
      if check_read_winner_all then
        check_read_place <= check_read_place_choice * 8;
      else
        check_read_place <= (check_read_place + as_number(slice0winner1_tag_valid)) mod 1024;
      end if;
      if check_read_has_before_choice_2 then
        check_read_has_before <= check_read_has_before_is_less;
      else
        check_read_has_before <= check_read_has_before_choice_7;
      end if;
      if check_cost_any then
        check_cost <= check_ready_cost;
        check_winner <= check_ready_winner;
      else
        check_cost <= check_ready_words_0 mod 4096;
        check_winner <= check_ready_words_0 / 4096;
      end if;
      if check_checked_tag_row_start_choice_3 then
        check_checked_tag_row_start <= check_checked_tag_row_start or check_checked_tag_row_start_all_2;
      else
        check_checked_tag_row_start <= check_checked_tag_row_start and ((not check_checked_tag_valid) or (not
          check_checked_tag_map_column));
      end if;
      if check_read_winner_all then
        if check_read_winner_all_2 then
          check_pass <= 0;
        else
          check_pass <= check_read_has_before_sum mod 8;
        end if;
      end if;
      if slice0winner1_tag_valid then
        if check_read_winner_all then
          check_columns <= 0;
        else
          check_columns <= check_read_counts_sum mod 1024;
        end if;
      end if;
      -- map
      if check_checked_tag_row_start_all_2 then
        if check_checked_tag_start_of_frame or check_checked_tag_row_start_is_equal then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 1024;
        end if;
      end if;
      if check_checked_tag_row_start_all then
        map_counter_group_choice := 15;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 480;
      if check_checked_tag_row_start and map_counter_group_is_equal then
        map_counter_group_choice_2 := 1;
      else
        map_counter_group_choice_2 := (map_counter_group + 1) mod 512;
      end if;
      if check_checked_tag_row_start_differs and check_checked_tag_row_start_is_equal and check_checked_tag_valid and
        check_checked_tag_map_column then
        map_counter_group_choice_3 := map_counter_group_choice_2;
      else
        map_counter_group_choice_3 := map_counter_group;
      end if;
      if check_checked_tag_valid then
        map_line_ended_choice := check_checked_tag_map_column;
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := to_integer(other_0(16 downto 16)) = 1;
      if map_at_top then
        map_of_column_0_a_choice := map_column_1 / 2;
      else
        map_of_column_0_a_choice := other_1 / 2;
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
      map_counter_next_frame <= to_integer(other_0(40 downto 40)) = 1;
      map_newest_0 <= ((((((((check_checked_disparity_0 + 4095) mod 2048) * 2) + (check_checked_fraction_0 / 8) + 1)
        mod 4096) * 8) + (check_checked_fraction_0 mod 8)) * 2) + as_number(check_checked_passed_0);
      map_arrives <= check_checked_tag_row_start_all_2;
      map_behind <= map_line_ended and check_checked_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_write_column <= to_integer(other_0(9 downto 0));
      map_column_1 <= other_3 / 8192;
      map_column_2 <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= to_integer(other_0(24 downto 24)) = 1;
      map_at_top <= to_integer(other_0(32 downto 32)) = 1;
      map_at_output <= to_integer(other_0(48 downto 48)) = 1;
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
      if check_checked_tag_start_of_frame and check_checked_tag_valid and check_checked_tag_map_column then
        map_counter_group <= map_counter_group_choice * 32;
      else
        map_counter_group <= map_counter_group_choice_3;
      end if;
      if check_checked_tag_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not check_checked_tag_valid);
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
        map_rows_write_words_0 <= (other_3 / 8192) + (map_rows_ready_newest_0 * 8192);
        map_at_column <= to_integer(other_0(9 downto 0));
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
      other_0 <= other_2;
      other_1 <= ((other_3 mod 8192) / 2) * 2;
      other_2 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 481))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other_3 <= to_integer(other_4);
      other_5 <= best_ready_words_0 / 4096;
      other_6 <= ((refinement_remainder_7_0_difference / 8192) * 2) + ((other_7 / 4) * 4);
      other_7 <= ((refinement_remainder_6_0_difference / 8192) * 4) + ((other_8 / 8) * 8);
      other_8 <= ((refinement_remainder_5_0_difference / 8192) * 8) + ((other_9 / 16) * 16);
      other_9 <= ((refinement_remainder_4_0_difference / 8192) * 16) + ((other_10 / 32) * 32);
      other_10 <= ((refinement_remainder_3_0_difference / 8192) * 32) + ((other_11 / 64) * 64);
      other_11 <= ((refinement_remainder_2_0_difference / 8192) * 64) + ((other_12 / 128) * 128);
      other_12 <= (refinement_remainder_1_0_difference / 8192) * 128;
      other_13 <= best_ready_words_0 mod 4096;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 481;
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
        raster_place_group <= 484;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_first_column <= false;
        delay_tag_start_of_frame <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_first_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_first_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_first_column <= false;
        rows_tag_start_of_frame <= false;
        passes_row <= false;
        passes_coming_starts <= false;
        passes_row_ended <= false;
        passes_arrived <= false;
        passes_write_address <= 0;
        passes_shows <= false;
        passes_showing_starts <= false;
        passes_pass <= 0;
        passes_column <= 0;
        passes_pass_ends <= false;
        passes_last_pass <= false;
        passes_search_start <= 48;
        passes_search_address <= 56;
        passes_reference_address <= 56;
        passes_leaving_starts <= false;
        passes_read_tag_valid <= false;
        passes_read_tag_row_start <= false;
        passes_read_tag_map_column <= false;
        passes_read_tag_end_of_line <= false;
        passes_tag_valid <= false;
        passes_tag_row_start <= false;
        passes_tag_first_cost <= false;
        passes_tag_map_column <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_row_start <= false;
        slice0shift_tag_first_cost <= false;
        slice0shift_tag_map_column <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_first_cost <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_first_cost <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_first_cost <= false;
        slice0cost_ready_tag_map_column <= false;
        slice0cost_write_column <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_first_cost <= false;
        slice0cost_tag_map_column <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_first_cost <= false;
        slice0window_entering_tag_map_column <= false;
        slice0window_entering_tag_first_column <= false;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_map_column <= false;
        slice0window_change_tag_first_column <= false;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_map_column_1 <= false;
        slice0window_centre_map_column_2 <= false;
        slice0window_centre_map_column_3 <= false;
        slice0window_centre_first_column_0 <= false;
        slice0window_centre_first_column_1 <= false;
        slice0window_centre_first_column_2 <= false;
        slice0window_centre_first_column_3 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_first_column <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_first_column <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_first_column <= false;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_map_column <= false;
        slice0winner3_tag_first_column <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_first_column <= false;
        best_read_tag_valid <= false;
        best_read_tag_map_column <= false;
        best_read_tag_first_column <= false;
        best_column <= 0;
        best_late_column <= 0;
        best_waiting_tag_valid <= false;
        best_waiting_tag_map_column <= false;
        best_waiting_tag_first_column <= false;
        best_ready_tag_valid <= false;
        best_ready_tag_map_column <= false;
        best_ready_tag_first_column <= false;
        best_pass <= 7;
        best_compared_tag_valid <= false;
        best_compared_tag_map_column <= false;
        best_compared_tag_first_column <= false;
        best_last_pass <= false;
        best_best_tag_valid <= false;
        best_best_tag_map_column <= false;
        best_best_tag_first_column <= false;
        best_place_column <= 0;
        best_write_column <= 0;
        best_late_write_column <= 0;
        refinement_tag_0_valid <= false;
        refinement_tag_0_map_column <= false;
        refinement_tag_0_first_column <= false;
        refinement_tag_1_valid <= false;
        refinement_tag_1_map_column <= false;
        refinement_tag_1_first_column <= false;
        refinement_tag_2_valid <= false;
        refinement_tag_2_map_column <= false;
        refinement_tag_2_first_column <= false;
        refinement_tag_3_valid <= false;
        refinement_tag_3_map_column <= false;
        refinement_tag_3_first_column <= false;
        refinement_tag_4_valid <= false;
        refinement_tag_4_map_column <= false;
        refinement_tag_4_first_column <= false;
        refinement_tag_5_valid <= false;
        refinement_tag_5_map_column <= false;
        refinement_tag_5_first_column <= false;
        refinement_tag_6_valid <= false;
        refinement_tag_6_map_column <= false;
        refinement_tag_6_first_column <= false;
        refinement_tag_7_valid <= false;
        refinement_tag_7_map_column <= false;
        refinement_tag_7_first_column <= false;
        refinement_tag_8_valid <= false;
        refinement_tag_8_map_column <= false;
        refinement_tag_8_first_column <= false;
        refinement_tag_9_valid <= false;
        refinement_tag_9_map_column <= false;
        refinement_tag_9_first_column <= false;
        refinement_tag_10_valid <= false;
        refinement_tag_10_map_column <= false;
        refinement_tag_10_first_column <= false;
        refinement_tag_11_valid <= false;
        refinement_tag_11_map_column <= false;
        refinement_tag_11_first_column <= false;
        winners_row <= true;
        winners_column <= 0;
        winners_write_address <= 0;
        winners_read_tag_valid <= false;
        winners_read_tag_map_column <= false;
        winners_read_tag_start_of_frame <= false;
        winners_read_tag_end_of_line <= false;
        winners_winners_tag_valid <= false;
        winners_winners_tag_map_column <= false;
        winners_winners_tag_start_of_frame <= false;
        winners_winners_tag_end_of_line <= false;
        check_read_place <= 0;
        check_read_counts <= false;
        check_read_row <= true;
        check_pass <= 7;
        check_first <= 0;
        check_columns <= 0;
        check_waiting_place <= 0;
        check_waiting_counts <= false;
        check_waiting_row <= true;
        check_ready_place <= 0;
        check_ready_counts <= false;
        check_ready_row <= true;
        check_write_place <= 0;
        check_write_address <= 0;
        check_asking_tag_valid <= false;
        check_asking_tag_map_column <= false;
        check_asking_tag_start_of_frame <= false;
        check_asking_tag_end_of_line <= false;
        check_answered_tag_valid <= false;
        check_answered_tag_map_column <= false;
        check_answered_tag_start_of_frame <= false;
        check_answered_tag_end_of_line <= false;
        check_checked_tag_valid <= false;
        check_checked_tag_row_start <= false;
        check_checked_tag_map_column <= false;
        check_checked_tag_start_of_frame <= false;
        check_checked_tag_end_of_line <= false;
        map_counter_column <= 0;
        map_counter_group <= 481;
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
        other_0 <= to_unsigned(0, 49);
        other_2 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
