-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_640_f16: 640x480, 128 disparities, window 1x1, P1 4, P2 24, 1 pixel pair a clock.
-- Options: disparities 128, window_px 1, reference left, census_width_px 9, cost_shift 2, p1 4, p2 24, median
--   true, slice_disparities 16, clocks_per_pixel 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_640_f16
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_640_f16 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 128;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 513;
    latency_clocks : positive := 72;
    flush_groups : positive := 3205;
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
  assert width_px = 640 report "stereo_core_sgm_640_f16: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_sgm_640_f16: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 128 report "stereo_core_sgm_640_f16: disparities is " & integer'image(disparities) & " but this core has 128" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_640_f16: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_sgm_640_f16: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 513 report "stereo_core_sgm_640_f16: output_width_px is " & integer'image(output_width_px) & " but this core has 513" severity failure;
  assert latency_clocks = 72 report "stereo_core_sgm_640_f16: latency_clocks is " & integer'image(latency_clocks) & " but this core has 72" severity failure;
  assert flush_groups = 3205 report "stereo_core_sgm_640_f16: flush_groups is " & integer'image(flush_groups) & " but this core has 3205" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_640_f16: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_640_f16 is
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
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 1023;
  signal transform_write_column : natural range 0 to 1023;
  signal transform_counter_group : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : unsigned(43 downto 0);
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : unsigned(43 downto 0);
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : unsigned(43 downto 0);
  signal delay_tag_valid, delay_tag_first_cost, delay_tag_map_column, delay_tag_output_column : boolean;
  signal delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_0, rows_reference_0 : unsigned(43 downto 0);
  signal rows_tag_valid, rows_tag_first_cost, rows_tag_map_column, rows_tag_output_column : boolean;
  signal rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- line
  signal line_centre_map_column_0, line_centre_first_column_0, line_centre_start_of_frame_0 : boolean;
  signal line_centre_end_of_line_0, line_order_falls, line_order_inside, line_order_complete : boolean;
  signal line_order_output, line_order_first, line_order_held_output, line_order_turned_valid : boolean;
  signal line_order_turned_output_column, line_order_turned_start_of_frame, line_comes_1, line_comes_2 : boolean;
  signal line_comes_3, line_comes_4, line_comes_5, line_comes_6, line_comes_7, line_comes_8, line_comes_9 : boolean;
  signal line_comes_10, line_comes_11, line_comes_12, line_comes_13, line_comes_14, line_comes_15 : boolean;
  signal line_comes_16, line_comes_17, line_comes_18, line_comes_19, line_comes_20, line_comes_21 : boolean;
  signal line_comes_22, line_comes_23, line_comes_24, line_comes_25, line_comes_26, line_comes_27 : boolean;
  signal line_comes_28, line_comes_29, line_comes_30, line_comes_31, line_comes_32, line_comes_33 : boolean;
  signal line_comes_34, line_comes_35, line_comes_36, line_comes_37, line_comes_38, line_comes_39 : boolean;
  signal line_comes_40, line_comes_41, line_comes_42, line_comes_43, line_comes_44, line_comes_45 : boolean;
  signal line_comes_46, line_comes_47, line_starts_phases_1, line_starts_phases_2, line_starts_phases_3 : boolean;
  signal line_starts_phases_4, line_starts_phases_5, line_starts_phases_6, line_starts_phases_7 : boolean;
  signal line_starts_phases_8, line_starts_phases_9, line_starts_phases_10, line_starts_phases_11 : boolean;
  signal line_starts_phases_12, line_starts_phases_13, line_starts_phases_14, line_starts_phases_15 : boolean;
  signal line_starts_phases_16, line_starts_phases_17, line_starts_phases_18, line_starts_phases_19 : boolean;
  signal line_starts_phases_20, line_starts_phases_21, line_starts_phases_22, line_starts_phases_23 : boolean;
  signal line_starts_phases_24, line_starts_phases_25, line_starts_phases_26, line_starts_phases_27 : boolean;
  signal line_starts_phases_28, line_starts_phases_29, line_starts_phases_30, line_starts_phases_31 : boolean;
  signal line_starts_phases_32, line_starts_phases_33, line_starts_phases_34, line_starts_phases_35 : boolean;
  signal line_starts_phases_36, line_starts_phases_37, line_starts_phases_38, line_starts_phases_39 : boolean;
  signal line_starts_phases_40, line_starts_phases_41, line_starts_phases_42, line_starts_phases_43 : boolean;
  signal line_starts_phases_44, line_starts_phases_45, line_starts_phases_46, line_starts_phases_47 : boolean;
  signal line_places_0_map_column, line_places_0_first_column, line_places_0_top : boolean;
  signal line_places_0_shown_output_column, line_places_0_shown_start_of_frame : boolean;
  signal line_places_0_shown_end_of_line, line_places_1_map_column, line_places_1_first_column : boolean;
  signal line_places_1_shown_output_column, line_places_1_shown_start_of_frame : boolean;
  signal line_places_1_shown_end_of_line, line_places_2_map_column, line_places_2_shown_output_column : boolean;
  signal line_places_2_shown_start_of_frame, line_places_2_shown_end_of_line : boolean;
  signal line_order_address, line_places_0_address, line_places_1_address : natural range 0 to 1023;
  -- costsshift
  signal costsshift_newest_0, costsshift_new_reference_0, costsshift_read_words_0 : unsigned(43 downto 0);
  signal costsshift_read_words_1, costsshift_read_words_2, costsshift_read_words_3 : unsigned(43 downto 0);
  signal costsshift_read_words_4, costsshift_read_words_5, costsshift_read_words_6 : unsigned(43 downto 0);
  signal costsshift_read_words_7, costsshift_handed_on_0, costsshift_read_reference_0 : unsigned(43 downto 0);
  signal costsshift_search_0_0, costsshift_search_0_1, costsshift_search_0_2 : unsigned(43 downto 0);
  signal costsshift_search_0_3, costsshift_search_0_4, costsshift_search_0_5 : unsigned(43 downto 0);
  signal costsshift_search_0_6, costsshift_search_0_7, costsshift_reference_0 : unsigned(43 downto 0);
  signal costsshift_new_tag_valid, costsshift_read_tag_valid : boolean;
  signal costsshift_count_phase, costsshift_read_count_phase, costsshift_write_phase : natural range 0 to 15;
  -- costswindow
  signal costswindow_first_0_count_0, costswindow_first_0_count_1, costswindow_first_0_count_2 : natural range 0 to 3;
  signal costswindow_first_0_count_3, costswindow_first_0_count_4, costswindow_first_0_count_5 : natural range 0 to 3;
  signal costswindow_first_0_count_6, costswindow_first_0_count_7, costswindow_first_0_count_8 : natural range 0 to 3;
  signal costswindow_first_0_count_9, costswindow_first_0_count_10, costswindow_first_0_count_11 : natural range 0 to 3;
  signal costswindow_first_0_count_12, costswindow_first_0_count_13, costswindow_first_1_count_0 : natural range 0 to 3;
  signal costswindow_first_1_count_1, costswindow_first_1_count_2, costswindow_first_1_count_3 : natural range 0 to 3;
  signal costswindow_first_1_count_4, costswindow_first_1_count_5, costswindow_first_1_count_6 : natural range 0 to 3;
  signal costswindow_first_1_count_7, costswindow_first_1_count_8, costswindow_first_1_count_9 : natural range 0 to 3;
  signal costswindow_first_1_count_10, costswindow_first_1_count_11 : natural range 0 to 3;
  signal costswindow_first_1_count_12, costswindow_first_1_count_13, costswindow_first_2_count_0 : natural range 0 to 3;
  signal costswindow_first_2_count_1, costswindow_first_2_count_2, costswindow_first_2_count_3 : natural range 0 to 3;
  signal costswindow_first_2_count_4, costswindow_first_2_count_5, costswindow_first_2_count_6 : natural range 0 to 3;
  signal costswindow_first_2_count_7, costswindow_first_2_count_8, costswindow_first_2_count_9 : natural range 0 to 3;
  signal costswindow_first_2_count_10, costswindow_first_2_count_11 : natural range 0 to 3;
  signal costswindow_first_2_count_12, costswindow_first_2_count_13, costswindow_first_3_count_0 : natural range 0 to 3;
  signal costswindow_first_3_count_1, costswindow_first_3_count_2, costswindow_first_3_count_3 : natural range 0 to 3;
  signal costswindow_first_3_count_4, costswindow_first_3_count_5, costswindow_first_3_count_6 : natural range 0 to 3;
  signal costswindow_first_3_count_7, costswindow_first_3_count_8, costswindow_first_3_count_9 : natural range 0 to 3;
  signal costswindow_first_3_count_10, costswindow_first_3_count_11 : natural range 0 to 3;
  signal costswindow_first_3_count_12, costswindow_first_3_count_13, costswindow_first_4_count_0 : natural range 0 to 3;
  signal costswindow_first_4_count_1, costswindow_first_4_count_2, costswindow_first_4_count_3 : natural range 0 to 3;
  signal costswindow_first_4_count_4, costswindow_first_4_count_5, costswindow_first_4_count_6 : natural range 0 to 3;
  signal costswindow_first_4_count_7, costswindow_first_4_count_8, costswindow_first_4_count_9 : natural range 0 to 3;
  signal costswindow_first_4_count_10, costswindow_first_4_count_11 : natural range 0 to 3;
  signal costswindow_first_4_count_12, costswindow_first_4_count_13, costswindow_first_5_count_0 : natural range 0 to 3;
  signal costswindow_first_5_count_1, costswindow_first_5_count_2, costswindow_first_5_count_3 : natural range 0 to 3;
  signal costswindow_first_5_count_4, costswindow_first_5_count_5, costswindow_first_5_count_6 : natural range 0 to 3;
  signal costswindow_first_5_count_7, costswindow_first_5_count_8, costswindow_first_5_count_9 : natural range 0 to 3;
  signal costswindow_first_5_count_10, costswindow_first_5_count_11 : natural range 0 to 3;
  signal costswindow_first_5_count_12, costswindow_first_5_count_13, costswindow_first_6_count_0 : natural range 0 to 3;
  signal costswindow_first_6_count_1, costswindow_first_6_count_2, costswindow_first_6_count_3 : natural range 0 to 3;
  signal costswindow_first_6_count_4, costswindow_first_6_count_5, costswindow_first_6_count_6 : natural range 0 to 3;
  signal costswindow_first_6_count_7, costswindow_first_6_count_8, costswindow_first_6_count_9 : natural range 0 to 3;
  signal costswindow_first_6_count_10, costswindow_first_6_count_11 : natural range 0 to 3;
  signal costswindow_first_6_count_12, costswindow_first_6_count_13, costswindow_first_7_count_0 : natural range 0 to 3;
  signal costswindow_first_7_count_1, costswindow_first_7_count_2, costswindow_first_7_count_3 : natural range 0 to 3;
  signal costswindow_first_7_count_4, costswindow_first_7_count_5, costswindow_first_7_count_6 : natural range 0 to 3;
  signal costswindow_first_7_count_7, costswindow_first_7_count_8, costswindow_first_7_count_9 : natural range 0 to 3;
  signal costswindow_first_7_count_10, costswindow_first_7_count_11 : natural range 0 to 3;
  signal costswindow_first_7_count_12, costswindow_first_7_count_13 : natural range 0 to 3;
  signal costswindow_first_0_count_14, costswindow_first_1_count_14 : natural range 0 to 2;
  signal costswindow_first_2_count_14, costswindow_first_3_count_14 : natural range 0 to 2;
  signal costswindow_first_4_count_14, costswindow_first_5_count_14 : natural range 0 to 2;
  signal costswindow_first_6_count_14, costswindow_first_7_count_14 : natural range 0 to 2;
  signal costswindow_sum_0_0, costswindow_sum_0_1, costswindow_sum_0_2, costswindow_sum_0_3 : natural range 0 to 53;
  signal costswindow_sum_0_4, costswindow_sum_0_5, costswindow_sum_0_6, costswindow_sum_0_7 : natural range 0 to 53;
  -- costs
  signal costs_cost_0, costs_cost_1, costs_cost_2, costs_cost_3, costs_cost_4, costs_cost_5 : natural range 0 to 13;
  signal costs_cost_6, costs_cost_7 : natural range 0 to 13;
  -- paths
  signal paths_tree_smallest_0, paths_tree_smallest_1, paths_tree_smallest_2 : natural range 0 to 13;
  signal paths_tree_smallest_3, paths_tree_next_smallest_0, paths_tree_next_smallest_1 : natural range 0 to 13;
  signal paths_tree_next_next_smallest_0 : natural range 0 to 13;
  signal paths_smallest_cost : natural range 0 to 15;
  signal paths_cost_delay_ring_read_address, paths_cost_delay_ring_write_address : natural range 0 to 31;
  signal paths_cost_delay_held_0 : unsigned(31 downto 0);
  signal paths_sum_0, paths_sum_1, paths_sum_2, paths_sum_3, paths_sum_4, paths_sum_5 : natural range 0 to 190;
  signal paths_sum_6, paths_sum_7 : natural range 0 to 190;
  -- pathsleft
  signal pathsleft_low_address, pathsleft_read_count_phase, pathsleft_ahead_count_phase : natural range 0 to 15;
  signal pathsleft_write_count_phase, pathsleft_low_write_address : natural range 0 to 15;
  signal pathsleft_lowest_0, pathsleft_read_words_3, pathsleft_read_neighbour_0 : unsigned(5 downto 0);
  signal pathsleft_lost, pathsleft_short_of, pathsleft_first, pathsleft_is_first, pathsleft_is_last : boolean;
  signal pathsleft_missing, pathsleft_below, pathsleft_q, pathsleft_room_left, pathsleft_q_now : natural range 0 to 31;
  signal pathsleft_room, pathsleft_start_cost_1, pathsleft_start_cost_2, pathsleft_start_cost_3 : natural range 0 to 31;
  signal pathsleft_start_cost_4, pathsleft_start_cost_5, pathsleft_start_cost_6 : natural range 0 to 31;
  signal pathsleft_start_cost_7, pathsleft_start_cost_8, pathsleft_start_cost_9 : natural range 0 to 31;
  signal pathsleft_q_less, pathsleft_g_less, pathsleft_lower_neighbour, pathsleft_stay_0 : natural range 0 to 63;
  signal pathsleft_stay_1, pathsleft_stay_2, pathsleft_stay_3, pathsleft_stay_4 : natural range 0 to 63;
  signal pathsleft_stay_5, pathsleft_stay_6, pathsleft_stay_7, pathsleft_step_0 : natural range 0 to 63;
  signal pathsleft_step_1, pathsleft_step_2, pathsleft_step_3, pathsleft_step_4 : natural range 0 to 63;
  signal pathsleft_step_5, pathsleft_step_6, pathsleft_step_7, pathsleft_stay_change_0 : natural range 0 to 63;
  signal pathsleft_stay_change_1, pathsleft_stay_change_2, pathsleft_stay_change_3 : natural range 0 to 63;
  signal pathsleft_stay_change_4, pathsleft_stay_change_5, pathsleft_stay_change_6 : natural range 0 to 63;
  signal pathsleft_stay_change_7, pathsleft_step_change_0, pathsleft_step_change_1 : natural range 0 to 63;
  signal pathsleft_step_change_2, pathsleft_step_change_3, pathsleft_step_change_4 : natural range 0 to 63;
  signal pathsleft_step_change_5, pathsleft_step_change_6, pathsleft_step_change_7 : natural range 0 to 63;
  signal pathsleft_cost_0, pathsleft_cost_1, pathsleft_cost_2, pathsleft_cost_3 : natural range 0 to 63;
  signal pathsleft_cost_4, pathsleft_cost_5, pathsleft_cost_6, pathsleft_cost_7 : natural range 0 to 63;
  signal pathsleft_arrived_0, pathsleft_arrived_1, pathsleft_arrived_2, pathsleft_arrived_3 : natural range 0 to 63;
  signal pathsleft_arrived_4, pathsleft_arrived_5, pathsleft_arrived_6, pathsleft_arrived_7 : natural range 0 to 63;
  signal pathsleft_tree_smallest_0, pathsleft_tree_smallest_1, pathsleft_tree_smallest_2 : natural range 0 to 63;
  signal pathsleft_tree_smallest_3, pathsleft_tree_next_smallest_0 : natural range 0 to 63;
  signal pathsleft_tree_next_smallest_1, pathsleft_tree_next_next_smallest_0, pathsleft_low_0 : natural range 0 to 63;
  signal pathsleft_g : natural range 0 to 46;
  signal pathsleft_read_words_0, pathsleft_read_words_1, pathsleft_read_words_2 : unsigned(29 downto 0);
  -- pathsabove
  signal pathsabove_memory_read_address_0, pathsabove_memory_write_address_0 : natural range 0 to 4095;
  signal pathsabove_memory_write_address_1 : natural range 0 to 4095;
  signal pathsabove_memory_read_address_2, pathsabove_memory_write_address_2 : natural range 0 to 15;
  signal pathsabove_read_address_count_phase, pathsabove_count_phase : natural range 0 to 15;
  signal pathsabove_write_address_count_phase : natural range 0 to 15;
  signal pathsabove_memory_bank, pathsabove_memory_read_bank, pathsabove_memory_held_bank : natural range 0 to 3;
  signal pathsabove_memory_read_words_0_0, pathsabove_memory_read_words_0_1 : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_2, pathsabove_memory_read_words_0_3 : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_4, pathsabove_memory_read_words_1_0 : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_1, pathsabove_memory_read_words_1_2 : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_3, pathsabove_memory_read_words_1_4 : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_0, pathsabove_memory_read_words_2_1 : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_2, pathsabove_memory_read_words_2_3 : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_4 : unsigned(7 downto 0);
  signal pathsabove_memory_held_words_0_0, pathsabove_memory_held_words_0_1 : natural range 0 to 255;
  signal pathsabove_memory_held_words_0_2, pathsabove_memory_held_words_0_3 : natural range 0 to 255;
  signal pathsabove_memory_held_words_0_4, pathsabove_memory_held_words_1_0 : natural range 0 to 255;
  signal pathsabove_memory_held_words_1_1, pathsabove_memory_held_words_1_2 : natural range 0 to 255;
  signal pathsabove_memory_held_words_1_3, pathsabove_memory_held_words_1_4 : natural range 0 to 255;
  signal pathsabove_memory_held_words_2_0, pathsabove_memory_held_words_2_1 : natural range 0 to 255;
  signal pathsabove_memory_held_words_2_2, pathsabove_memory_held_words_2_3 : natural range 0 to 255;
  signal pathsabove_memory_held_words_2_4, pathsabove_memory_ready_words_0 : natural range 0 to 255;
  signal pathsabove_memory_ready_words_1, pathsabove_memory_ready_words_2 : natural range 0 to 255;
  signal pathsabove_memory_ready_words_3, pathsabove_memory_ready_words_4 : natural range 0 to 255;
  signal pathsabove_memory_write_words_0_0, pathsabove_memory_write_words_0_1 : natural range 0 to 255;
  signal pathsabove_memory_write_words_0_2, pathsabove_memory_write_words_0_3 : natural range 0 to 255;
  signal pathsabove_memory_write_words_0_4, pathsabove_memory_write_words_1_0 : natural range 0 to 255;
  signal pathsabove_memory_write_words_1_1, pathsabove_memory_write_words_1_2 : natural range 0 to 255;
  signal pathsabove_memory_write_words_1_3, pathsabove_memory_write_words_1_4 : natural range 0 to 255;
  signal pathsabove_memory_write_words_2_0, pathsabove_memory_write_words_2_1 : natural range 0 to 255;
  signal pathsabove_memory_write_words_2_2, pathsabove_memory_write_words_2_3 : natural range 0 to 255;
  signal pathsabove_memory_write_words_2_4 : natural range 0 to 255;
  signal pathsabove_read_address_address, pathsabove_write_address_address : natural range 0 to 16383;
  signal pathsabove_ready_top, pathsabove_write_address_is_here : boolean;
  signal pathsabove_total_0, pathsabove_total_1, pathsabove_total_2, pathsabove_total_3 : natural range 0 to 44;
  signal pathsabove_total_4, pathsabove_total_5, pathsabove_total_6, pathsabove_total_7 : natural range 0 to 44;
  signal pathsabove_tree_smallest_0, pathsabove_tree_smallest_1, pathsabove_tree_smallest_2 : natural range 0 to 44;
  signal pathsabove_tree_smallest_3, pathsabove_tree_next_smallest_0 : natural range 0 to 44;
  signal pathsabove_tree_next_smallest_1, pathsabove_tree_next_next_smallest_0 : natural range 0 to 44;
  signal pathsabove_delay_held_0 : unsigned(29 downto 0);
  signal pathsabove_delay_held_1 : unsigned(17 downto 0);
  signal pathsabove_smallest_total, pathsabove_smallest, pathsabove_cost_0, pathsabove_cost_1 : natural range 0 to 63;
  signal pathsabove_cost_2, pathsabove_cost_3, pathsabove_cost_4, pathsabove_cost_5 : natural range 0 to 63;
  signal pathsabove_cost_6, pathsabove_cost_7, pathsabove_held_0, pathsabove_held_1 : natural range 0 to 63;
  signal pathsabove_held_2, pathsabove_held_3, pathsabove_held_4, pathsabove_held_5 : natural range 0 to 63;
  signal pathsabove_held_6, pathsabove_held_7, pathsabove_lower_neighbour, pathsabove_beside_0 : natural range 0 to 63;
  signal pathsabove_beside_1, pathsabove_beside_2, pathsabove_beside_3, pathsabove_beside_4 : natural range 0 to 63;
  signal pathsabove_beside_5, pathsabove_beside_6, pathsabove_beside_7, pathsabove_own_0 : natural range 0 to 63;
  signal pathsabove_own_1, pathsabove_own_2, pathsabove_own_3, pathsabove_own_4 : natural range 0 to 63;
  signal pathsabove_own_5, pathsabove_own_6 : natural range 0 to 63;
  signal pathsabove_step_0, pathsabove_step_1, pathsabove_step_2, pathsabove_step_3 : natural range 0 to 67;
  signal pathsabove_step_4, pathsabove_step_5, pathsabove_step_6, pathsabove_step_7 : natural range 0 to 67;
  signal pathsabove_stay_0, pathsabove_stay_1, pathsabove_stay_2, pathsabove_stay_3 : natural range 0 to 31;
  signal pathsabove_stay_4, pathsabove_stay_5, pathsabove_stay_6, pathsabove_stay_7 : natural range 0 to 31;
  -- pathsturn
  signal pathsturn_sum_memory_read_address_0, pathsturn_sum_memory_write_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_write_address_1, pathsturn_cost_memory_read_address_0 : natural range 0 to 4095;
  signal pathsturn_cost_memory_write_address_0, pathsturn_cost_memory_write_address_1 : natural range 0 to 4095;
  signal pathsturn_sum_memory_read_address_2, pathsturn_sum_memory_write_address_2 : natural range 0 to 15;
  signal pathsturn_cost_memory_read_address_2, pathsturn_cost_memory_write_address_2 : natural range 0 to 15;
  signal pathsturn_ready_smallest_0, pathsturn_read_address_count_phase : natural range 0 to 15;
  signal pathsturn_write_smallest_0, pathsturn_write_address_count_phase : natural range 0 to 15;
  signal pathsturn_sum_memory_bank, pathsturn_sum_memory_read_bank : natural range 0 to 3;
  signal pathsturn_sum_memory_held_bank, pathsturn_cost_memory_bank : natural range 0 to 3;
  signal pathsturn_cost_memory_read_bank, pathsturn_cost_memory_held_bank : natural range 0 to 3;
  signal pathsturn_sum_memory_read_words_0_0, pathsturn_sum_memory_read_words_0_1 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_2, pathsturn_sum_memory_read_words_0_3 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_4, pathsturn_sum_memory_read_words_0_5 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_6, pathsturn_sum_memory_read_words_1_0 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_1, pathsturn_sum_memory_read_words_1_2 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_3, pathsturn_sum_memory_read_words_1_4 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_5, pathsturn_sum_memory_read_words_1_6 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_0, pathsturn_sum_memory_read_words_2_1 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_2, pathsturn_sum_memory_read_words_2_3 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_4, pathsturn_sum_memory_read_words_2_5 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_6, pathsturn_cost_memory_read_words_0_0 : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_1, pathsturn_cost_memory_read_words_0_2 : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_3, pathsturn_cost_memory_read_words_1_0 : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_1_1, pathsturn_cost_memory_read_words_1_2 : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_1_3, pathsturn_cost_memory_read_words_2_0 : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_1, pathsturn_cost_memory_read_words_2_2 : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_3 : unsigned(7 downto 0);
  signal pathsturn_sum_memory_held_words_0_0, pathsturn_sum_memory_held_words_0_1 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_0_2, pathsturn_sum_memory_held_words_0_3 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_0_4, pathsturn_sum_memory_held_words_0_5 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_0_6, pathsturn_sum_memory_held_words_1_0 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_1_1, pathsturn_sum_memory_held_words_1_2 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_1_3, pathsturn_sum_memory_held_words_1_4 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_1_5, pathsturn_sum_memory_held_words_1_6 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_2_0, pathsturn_sum_memory_held_words_2_1 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_2_2, pathsturn_sum_memory_held_words_2_3 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_2_4, pathsturn_sum_memory_held_words_2_5 : natural range 0 to 255;
  signal pathsturn_sum_memory_held_words_2_6, pathsturn_sum_memory_ready_words_0 : natural range 0 to 255;
  signal pathsturn_sum_memory_ready_words_1, pathsturn_sum_memory_ready_words_2 : natural range 0 to 255;
  signal pathsturn_sum_memory_ready_words_3, pathsturn_sum_memory_ready_words_4 : natural range 0 to 255;
  signal pathsturn_sum_memory_ready_words_5, pathsturn_sum_memory_ready_words_6 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_0_1, pathsturn_sum_memory_write_words_0_2 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_0_3, pathsturn_sum_memory_write_words_0_4 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_0_5, pathsturn_sum_memory_write_words_1_1 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_1_2, pathsturn_sum_memory_write_words_1_3 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_1_4, pathsturn_sum_memory_write_words_1_5 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_2_1, pathsturn_sum_memory_write_words_2_2 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_2_3, pathsturn_sum_memory_write_words_2_4 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_2_5, pathsturn_cost_memory_held_words_0_0 : natural range 0 to 255;
  signal pathsturn_cost_memory_held_words_0_1, pathsturn_cost_memory_held_words_0_2 : natural range 0 to 255;
  signal pathsturn_cost_memory_held_words_0_3, pathsturn_cost_memory_held_words_1_0 : natural range 0 to 255;
  signal pathsturn_cost_memory_held_words_1_1, pathsturn_cost_memory_held_words_1_2 : natural range 0 to 255;
  signal pathsturn_cost_memory_held_words_1_3, pathsturn_cost_memory_held_words_2_0 : natural range 0 to 255;
  signal pathsturn_cost_memory_held_words_2_1, pathsturn_cost_memory_held_words_2_2 : natural range 0 to 255;
  signal pathsturn_cost_memory_held_words_2_3, pathsturn_cost_memory_ready_words_0 : natural range 0 to 255;
  signal pathsturn_cost_memory_ready_words_1, pathsturn_cost_memory_ready_words_2 : natural range 0 to 255;
  signal pathsturn_cost_memory_ready_words_3, pathsturn_cost_memory_write_words_0_0 : natural range 0 to 255;
  signal pathsturn_cost_memory_write_words_0_1, pathsturn_cost_memory_write_words_0_2 : natural range 0 to 255;
  signal pathsturn_cost_memory_write_words_0_3, pathsturn_cost_memory_write_words_1_0 : natural range 0 to 255;
  signal pathsturn_cost_memory_write_words_1_1, pathsturn_cost_memory_write_words_1_2 : natural range 0 to 255;
  signal pathsturn_cost_memory_write_words_1_3, pathsturn_cost_memory_write_words_2_0 : natural range 0 to 255;
  signal pathsturn_cost_memory_write_words_2_1, pathsturn_cost_memory_write_words_2_2 : natural range 0 to 255;
  signal pathsturn_cost_memory_write_words_2_3 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_0_0, pathsturn_sum_memory_write_words_1_0 : natural range 0 to 254;
  signal pathsturn_sum_memory_write_words_2_0 : natural range 0 to 254;
  signal pathsturn_sum_memory_write_words_0_6, pathsturn_sum_memory_write_words_1_6 : natural range 0 to 253;
  signal pathsturn_sum_memory_write_words_2_6 : natural range 0 to 253;
  signal pathsturn_smallest_address, pathsturn_write_smallest_address : natural range 0 to 1023;
  signal pathsturn_read_smallest_0 : unsigned(3 downto 0);
  signal pathsturn_read_address_address, pathsturn_sum_read_address : natural range 0 to 16383;
  signal pathsturn_write_address_address, pathsturn_sum_write_address_0 : natural range 0 to 16383;
  signal pathsturn_sum_write_address_1 : natural range 0 to 16383;
  signal pathsturn_write_address_is_here, pathsturn_writes_sums_0, pathsturn_writes_sums_1 : boolean;
  -- pathsright
  signal pathsright_lowest_0, pathsright_read_words_3, pathsright_read_neighbour_0 : unsigned(5 downto 0);
  signal pathsright_lost, pathsright_short_of : boolean;
  signal pathsright_missing, pathsright_below, pathsright_q, pathsright_room_left : natural range 0 to 31;
  signal pathsright_q_now, pathsright_room, pathsright_start_cost_1, pathsright_start_cost_2 : natural range 0 to 31;
  signal pathsright_start_cost_3, pathsright_start_cost_4, pathsright_start_cost_5 : natural range 0 to 31;
  signal pathsright_start_cost_6, pathsright_start_cost_7, pathsright_start_cost_8 : natural range 0 to 31;
  signal pathsright_start_cost_9 : natural range 0 to 31;
  signal pathsright_q_less, pathsright_g_less, pathsright_lower_neighbour, pathsright_stay_0 : natural range 0 to 63;
  signal pathsright_stay_1, pathsright_stay_2, pathsright_stay_3, pathsright_stay_4 : natural range 0 to 63;
  signal pathsright_stay_5, pathsright_stay_6, pathsright_stay_7, pathsright_step_0 : natural range 0 to 63;
  signal pathsright_step_1, pathsright_step_2, pathsright_step_3, pathsright_step_4 : natural range 0 to 63;
  signal pathsright_step_5, pathsright_step_6, pathsright_step_7, pathsright_stay_change_0 : natural range 0 to 63;
  signal pathsright_stay_change_1, pathsright_stay_change_2, pathsright_stay_change_3 : natural range 0 to 63;
  signal pathsright_stay_change_4, pathsright_stay_change_5, pathsright_stay_change_6 : natural range 0 to 63;
  signal pathsright_stay_change_7, pathsright_step_change_0, pathsright_step_change_1 : natural range 0 to 63;
  signal pathsright_step_change_2, pathsright_step_change_3, pathsright_step_change_4 : natural range 0 to 63;
  signal pathsright_step_change_5, pathsright_step_change_6, pathsright_step_change_7 : natural range 0 to 63;
  signal pathsright_cost_0, pathsright_cost_1, pathsright_cost_2, pathsright_cost_3 : natural range 0 to 63;
  signal pathsright_cost_4, pathsright_cost_5, pathsright_cost_6, pathsright_cost_7 : natural range 0 to 63;
  signal pathsright_arrived_0, pathsright_arrived_1, pathsright_arrived_2, pathsright_arrived_3 : natural range 0 to 63;
  signal pathsright_arrived_4, pathsright_arrived_5, pathsright_arrived_6, pathsright_arrived_7 : natural range 0 to 63;
  signal pathsright_tree_smallest_0, pathsright_tree_smallest_1, pathsright_tree_smallest_2 : natural range 0 to 63;
  signal pathsright_tree_smallest_3, pathsright_tree_next_smallest_0 : natural range 0 to 63;
  signal pathsright_tree_next_smallest_1, pathsright_tree_next_next_smallest_0 : natural range 0 to 63;
  signal pathsright_low_0 : natural range 0 to 63;
  signal pathsright_g : natural range 0 to 46;
  signal pathsright_read_words_0, pathsright_read_words_1, pathsright_read_words_2 : unsigned(29 downto 0);
  -- winnerswinner1
  signal winnerswinner1_best_cost_0_0, winnerswinner1_best_cost_0_1 : natural range 0 to 190;
  signal winnerswinner1_best_cost_0_2, winnerswinner1_best_cost_0_3 : natural range 0 to 190;
  signal winnerswinner1_best_index_0_0 : boolean;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_best_index_0_3 : natural range 0 to 7;
  -- winnerswinner2
  signal winnerswinner2_best_cost_0_0, winnerswinner2_best_cost_0_1 : natural range 0 to 190;
  signal winnerswinner2_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner2_best_index_0_1 : natural range 0 to 7;
  -- winnerswinner3
  signal winnerswinner3_best_cost_0_0 : natural range 0 to 190;
  signal winnerswinner3_best_index_0_0 : natural range 0 to 7;
  -- winners
  signal winners_best_cost_0_0, winners_best_index_0_0 : natural range 0 to 255;
  signal winners_best_tag_valid, winners_best_tag_map_column, winners_best_tag_output_column : boolean;
  signal winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 1023;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame : boolean;
  signal turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid, turn_read_tag_map_column : boolean;
  signal turn_read_tag_start_of_frame, turn_read_tag_end_of_line, turn_ready_tag_valid : boolean;
  signal turn_ready_tag_row_start, turn_ready_tag_map_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 511;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column : natural range 0 to 1023;
  signal map_sorted_column : natural range 0 to 1023;
  signal map_counter_group, map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 511;
  signal map_column_1, map_column_2 : natural range 0 to 511;
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
  signal map_rows_read_words_0 : unsigned(17 downto 0);
  signal map_rows_ready_words_0, map_rows_write_words_0 : natural range 0 to 262143;
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0 : natural range 0 to 255;
  signal map_sorted_middle_0, map_sorted_high_0, map_low_0_0, map_low_1_0, map_low_2_0 : natural range 0 to 255;
  signal map_middle_0_0, map_middle_1_0, map_middle_2_0, map_high_0_0, map_high_1_0 : natural range 0 to 255;
  signal map_high_2_0, map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a : natural range 0 to 255;
  signal map_of_middle_0_b, map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b : natural range 0 to 255;
  signal map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0 : natural range 0 to 255;
  signal map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 255;
  -- other
  signal other_0, other_1 : unsigned(48 downto 0);
  signal other_2 : natural range 0 to 510;
  signal other_3, other_4, other_5, other_6, other_7, other_8, other_9, other_10 : natural range 0 to 135007244;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal map_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(17 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal turn_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal pathsright_read_words_3_memory_read_enable : boolean;
  signal pathsright_read_words_3_memory_read_address : unsigned(3 downto 0);
  signal pathsright_read_words_3_memory_write_address : unsigned(3 downto 0);
  signal pathsright_read_words_3_memory_write_data : unsigned(5 downto 0);
  signal pathsright_read_words_2_memory_read_enable : boolean;
  signal pathsright_read_words_2_memory_read_address : unsigned(3 downto 0);
  signal pathsright_read_words_2_memory_write_address : unsigned(3 downto 0);
  signal pathsright_read_words_2_memory_write_data : unsigned(29 downto 0);
  signal pathsright_read_words_1_memory_read_enable : boolean;
  signal pathsright_read_words_1_memory_read_address : unsigned(3 downto 0);
  signal pathsright_read_words_1_memory_write_address : unsigned(3 downto 0);
  signal pathsright_read_words_1_memory_write_data : unsigned(29 downto 0);
  signal pathsright_read_words_0_memory_read_enable : boolean;
  signal pathsright_read_words_0_memory_read_address : unsigned(3 downto 0);
  signal pathsright_read_words_0_memory_write_address : unsigned(3 downto 0);
  signal pathsright_read_words_0_memory_write_data : unsigned(29 downto 0);
  signal pathsright_read_neighbour_0_memory_read_enable : boolean;
  signal pathsright_read_neighbour_0_memory_read_address : unsigned(3 downto 0);
  signal pathsright_read_neighbour_0_memory_write_address : unsigned(3 downto 0);
  signal pathsright_read_neighbour_0_memory_write_data : unsigned(5 downto 0);
  signal pathsright_lowest_0_memory_read_enable : boolean;
  signal pathsright_lowest_0_memory_read_address : unsigned(3 downto 0);
  signal pathsright_lowest_0_memory_write_address : unsigned(3 downto 0);
  signal pathsright_lowest_0_memory_write_data : unsigned(5 downto 0);
  signal pathsturn_read_smallest_0_memory_read_enable : boolean;
  signal pathsturn_read_smallest_0_memory_read_address : unsigned(9 downto 0);
  signal pathsturn_read_smallest_0_memory_write_address : unsigned(9 downto 0);
  signal pathsturn_read_smallest_0_memory_write_data : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_0_6_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_6_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_6_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_6_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_5_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_5_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_5_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_5_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_4_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_4_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_4_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_4_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_3_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_3_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_3_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_2_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_2_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_2_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_2_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_1_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_6_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_6_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_6_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_6_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_5_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_5_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_5_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_5_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_4_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_4_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_4_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_4_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_3_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_3_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_3_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_2_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_2_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_2_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_2_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_1_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_0_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_6_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_6_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_6_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_6_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_5_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_5_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_5_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_5_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_4_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_4_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_4_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_4_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_3_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_3_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_3_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_2_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_2_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_2_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_2_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_1_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_1_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_0_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_0_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_2_0_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_3_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_3_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_3_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_2_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_2_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_2_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_2_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_1_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_1_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_1_3_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_3_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_3_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_1_2_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_2_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_2_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_2_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_1_1_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_1_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_1_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_0_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_3_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_3_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_2_3_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_2_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_2_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_2_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_2_2_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_2_2_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_1_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_1_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_2_1_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_2_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_0_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_2_0_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_2_0_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_delay_held_1_memory_read_enable : boolean;
  signal pathsabove_delay_held_1_memory_read_address : unsigned(4 downto 0);
  signal pathsabove_delay_held_1_memory_write_address : unsigned(4 downto 0);
  signal pathsabove_delay_held_1_memory_write_data : unsigned(17 downto 0);
  signal pathsabove_delay_held_0_memory_read_enable : boolean;
  signal pathsabove_delay_held_0_memory_read_address : unsigned(4 downto 0);
  signal pathsabove_delay_held_0_memory_write_address : unsigned(4 downto 0);
  signal pathsabove_delay_held_0_memory_write_data : unsigned(29 downto 0);
  signal pathsabove_memory_read_words_0_4_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_4_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_4_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_4_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_3_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_3_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_3_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_3_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_2_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_2_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_2_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_2_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_1_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_4_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_4_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_4_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_4_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_3_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_3_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_3_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_3_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_2_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_2_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_2_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_2_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_1_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_0_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_4_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_4_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_4_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_4_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_3_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_3_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_3_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_3_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_2_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_2_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_2_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_2_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_1_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_1_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_1_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_1_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_0_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_0_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_2_0_memory_write_data : unsigned(7 downto 0);
  signal pathsleft_read_words_3_memory_read_enable : boolean;
  signal pathsleft_read_words_3_memory_read_address : unsigned(3 downto 0);
  signal pathsleft_read_words_3_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_read_words_3_memory_write_data : unsigned(5 downto 0);
  signal pathsleft_read_words_2_memory_read_enable : boolean;
  signal pathsleft_read_words_2_memory_read_address : unsigned(3 downto 0);
  signal pathsleft_read_words_2_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_read_words_2_memory_write_data : unsigned(29 downto 0);
  signal pathsleft_read_words_1_memory_read_enable : boolean;
  signal pathsleft_read_words_1_memory_read_address : unsigned(3 downto 0);
  signal pathsleft_read_words_1_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_read_words_1_memory_write_data : unsigned(29 downto 0);
  signal pathsleft_read_words_0_memory_read_enable : boolean;
  signal pathsleft_read_words_0_memory_read_address : unsigned(3 downto 0);
  signal pathsleft_read_words_0_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_read_words_0_memory_write_data : unsigned(29 downto 0);
  signal pathsleft_read_neighbour_0_memory_read_enable : boolean;
  signal pathsleft_read_neighbour_0_memory_read_address : unsigned(3 downto 0);
  signal pathsleft_read_neighbour_0_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_read_neighbour_0_memory_write_data : unsigned(5 downto 0);
  signal pathsleft_lowest_0_memory_read_enable : boolean;
  signal pathsleft_lowest_0_memory_read_address : unsigned(3 downto 0);
  signal pathsleft_lowest_0_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_lowest_0_memory_write_data : unsigned(5 downto 0);
  signal paths_cost_delay_held_0_memory_read_enable : boolean;
  signal paths_cost_delay_held_0_memory_read_address : unsigned(4 downto 0);
  signal paths_cost_delay_held_0_memory_write_address : unsigned(4 downto 0);
  signal paths_cost_delay_held_0_memory_write_data : unsigned(31 downto 0);
  signal costsshift_read_words_7_memory_read_enable : boolean;
  signal costsshift_read_words_7_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_7_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_7_memory_write_data : unsigned(43 downto 0);
  signal costsshift_read_words_6_memory_read_enable : boolean;
  signal costsshift_read_words_6_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_6_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_6_memory_write_data : unsigned(43 downto 0);
  signal costsshift_read_words_5_memory_read_enable : boolean;
  signal costsshift_read_words_5_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_5_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_5_memory_write_data : unsigned(43 downto 0);
  signal costsshift_read_words_4_memory_read_enable : boolean;
  signal costsshift_read_words_4_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_4_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_4_memory_write_data : unsigned(43 downto 0);
  signal costsshift_read_words_3_memory_read_enable : boolean;
  signal costsshift_read_words_3_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_3_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_3_memory_write_data : unsigned(43 downto 0);
  signal costsshift_read_words_2_memory_read_enable : boolean;
  signal costsshift_read_words_2_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_2_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_2_memory_write_data : unsigned(43 downto 0);
  signal costsshift_read_words_1_memory_read_enable : boolean;
  signal costsshift_read_words_1_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_1_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_1_memory_write_data : unsigned(43 downto 0);
  signal costsshift_read_words_0_memory_read_enable : boolean;
  signal costsshift_read_words_0_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_0_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_0_memory_write_data : unsigned(43 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 10);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 10);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 10);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 10);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 10);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_write_column, 10);
  map_rows_read_words_0_memory_write_data <= to_unsigned(map_rows_write_words_0, 18);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 513, width => 18, address_bits => 10)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 10);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 10);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 9);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 514, width => 9, address_bits => 10)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  pathsright_read_words_3_memory_read_enable <= true;
  pathsright_read_words_3_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsright_read_words_3_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsright_read_words_3_memory_write_data <= to_unsigned(pathsright_arrived_7, 6);
  pathsright_read_words_3_memory : entity work.line_memory
    generic map (depth => 16, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_read_words_3_memory_read_enable,
      read_address => pathsright_read_words_3_memory_read_address, read_data => pathsright_read_words_3,
      write_address => pathsright_read_words_3_memory_write_address, write_data => pathsright_read_words_3_memory_write_data);

  pathsright_read_words_2_memory_read_enable <= true;
  pathsright_read_words_2_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsright_read_words_2_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsright_read_words_2_memory_write_data <= to_unsigned(pathsright_arrived_6, 6) & to_unsigned(pathsright_arrived_5, 6) & to_unsigned(pathsright_arrived_4, 6) & to_unsigned(pathsright_arrived_3, 6) & to_unsigned(pathsright_arrived_2, 6);
  pathsright_read_words_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_read_words_2_memory_read_enable,
      read_address => pathsright_read_words_2_memory_read_address, read_data => pathsright_read_words_2,
      write_address => pathsright_read_words_2_memory_write_address, write_data => pathsright_read_words_2_memory_write_data);

  pathsright_read_words_1_memory_read_enable <= true;
  pathsright_read_words_1_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsright_read_words_1_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsright_read_words_1_memory_write_data <= to_unsigned(pathsright_arrived_1, 6) & to_unsigned(pathsright_arrived_0, 6) & to_unsigned(pathsright_cost_7, 6) & to_unsigned(pathsright_cost_6, 6) & to_unsigned(pathsright_cost_5, 6);
  pathsright_read_words_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_read_words_1_memory_read_enable,
      read_address => pathsright_read_words_1_memory_read_address, read_data => pathsright_read_words_1,
      write_address => pathsright_read_words_1_memory_write_address, write_data => pathsright_read_words_1_memory_write_data);

  pathsright_read_words_0_memory_read_enable <= true;
  pathsright_read_words_0_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsright_read_words_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsright_read_words_0_memory_write_data <= to_unsigned(pathsright_cost_4, 6) & to_unsigned(pathsright_cost_3, 6) & to_unsigned(pathsright_cost_2, 6) & to_unsigned(pathsright_cost_1, 6) & to_unsigned(pathsright_cost_0, 6);
  pathsright_read_words_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_read_words_0_memory_read_enable,
      read_address => pathsright_read_words_0_memory_read_address, read_data => pathsright_read_words_0,
      write_address => pathsright_read_words_0_memory_write_address, write_data => pathsright_read_words_0_memory_write_data);

  pathsright_read_neighbour_0_memory_read_enable <= true;
  pathsright_read_neighbour_0_memory_read_address <= to_unsigned(pathsleft_ahead_count_phase, 4);
  pathsright_read_neighbour_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsright_read_neighbour_0_memory_write_data <= to_unsigned(pathsright_cost_0, 6);
  pathsright_read_neighbour_0_memory : entity work.line_memory
    generic map (depth => 16, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_read_neighbour_0_memory_read_enable,
      read_address => pathsright_read_neighbour_0_memory_read_address, read_data => pathsright_read_neighbour_0,
      write_address => pathsright_read_neighbour_0_memory_write_address, write_data => pathsright_read_neighbour_0_memory_write_data);

  pathsright_lowest_0_memory_read_enable <= true;
  pathsright_lowest_0_memory_read_address <= to_unsigned(pathsleft_low_address, 4);
  pathsright_lowest_0_memory_write_address <= to_unsigned(pathsleft_low_write_address, 4);
  pathsright_lowest_0_memory_write_data <= to_unsigned(pathsright_low_0, 6);
  pathsright_lowest_0_memory : entity work.line_memory
    generic map (depth => 16, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_lowest_0_memory_read_enable,
      read_address => pathsright_lowest_0_memory_read_address, read_data => pathsright_lowest_0,
      write_address => pathsright_lowest_0_memory_write_address, write_data => pathsright_lowest_0_memory_write_data);

  pathsturn_read_smallest_0_memory_read_enable <= true;
  pathsturn_read_smallest_0_memory_read_address <= to_unsigned(pathsturn_smallest_address, 10);
  pathsturn_read_smallest_0_memory_write_address <= to_unsigned(pathsturn_write_smallest_address, 10);
  pathsturn_read_smallest_0_memory_write_data <= to_unsigned(pathsturn_write_smallest_0, 4);
  pathsturn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 514, width => 4, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsturn_read_smallest_0_memory_read_enable,
      read_address => pathsturn_read_smallest_0_memory_read_address, read_data => pathsturn_read_smallest_0,
      write_address => pathsturn_read_smallest_0_memory_write_address, write_data => pathsturn_read_smallest_0_memory_write_data);

  pathsturn_sum_memory_read_words_0_6_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_6_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_6_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_6_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_6, 8);
  pathsturn_sum_memory_read_words_0_6_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_6_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_6_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_6,
      write_address => pathsturn_sum_memory_read_words_0_6_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_6_memory_write_data);

  pathsturn_sum_memory_read_words_0_5_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_5_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_5_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_5_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_5, 8);
  pathsturn_sum_memory_read_words_0_5_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_5_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_5_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_5,
      write_address => pathsturn_sum_memory_read_words_0_5_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_5_memory_write_data);

  pathsturn_sum_memory_read_words_0_4_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_4_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_4_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_4_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_4, 8);
  pathsturn_sum_memory_read_words_0_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_4_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_4_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_4,
      write_address => pathsturn_sum_memory_read_words_0_4_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_4_memory_write_data);

  pathsturn_sum_memory_read_words_0_3_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_3_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_3_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_3_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_3, 8);
  pathsturn_sum_memory_read_words_0_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_3_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_3_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_3,
      write_address => pathsturn_sum_memory_read_words_0_3_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_3_memory_write_data);

  pathsturn_sum_memory_read_words_0_2_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_2_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_2_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_2_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_2, 8);
  pathsturn_sum_memory_read_words_0_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_2_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_2_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_2,
      write_address => pathsturn_sum_memory_read_words_0_2_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_2_memory_write_data);

  pathsturn_sum_memory_read_words_0_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_1, 8);
  pathsturn_sum_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_1_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_1,
      write_address => pathsturn_sum_memory_read_words_0_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_1_memory_write_data);

  pathsturn_sum_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_0, 8);
  pathsturn_sum_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_0_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_0,
      write_address => pathsturn_sum_memory_read_words_0_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_0_memory_write_data);

  pathsturn_sum_memory_read_words_1_6_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_6_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_6_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 12);
  pathsturn_sum_memory_read_words_1_6_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1_6, 8);
  pathsturn_sum_memory_read_words_1_6_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_6_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_6_memory_read_address, read_data => pathsturn_sum_memory_read_words_1_6,
      write_address => pathsturn_sum_memory_read_words_1_6_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_6_memory_write_data);

  pathsturn_sum_memory_read_words_1_5_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_5_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_5_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 12);
  pathsturn_sum_memory_read_words_1_5_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1_5, 8);
  pathsturn_sum_memory_read_words_1_5_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_5_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_5_memory_read_address, read_data => pathsturn_sum_memory_read_words_1_5,
      write_address => pathsturn_sum_memory_read_words_1_5_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_5_memory_write_data);

  pathsturn_sum_memory_read_words_1_4_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_4_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_4_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 12);
  pathsturn_sum_memory_read_words_1_4_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1_4, 8);
  pathsturn_sum_memory_read_words_1_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_4_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_4_memory_read_address, read_data => pathsturn_sum_memory_read_words_1_4,
      write_address => pathsturn_sum_memory_read_words_1_4_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_4_memory_write_data);

  pathsturn_sum_memory_read_words_1_3_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_3_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_3_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 12);
  pathsturn_sum_memory_read_words_1_3_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1_3, 8);
  pathsturn_sum_memory_read_words_1_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_3_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_3_memory_read_address, read_data => pathsturn_sum_memory_read_words_1_3,
      write_address => pathsturn_sum_memory_read_words_1_3_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_3_memory_write_data);

  pathsturn_sum_memory_read_words_1_2_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_2_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_2_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 12);
  pathsturn_sum_memory_read_words_1_2_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1_2, 8);
  pathsturn_sum_memory_read_words_1_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_2_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_2_memory_read_address, read_data => pathsturn_sum_memory_read_words_1_2,
      write_address => pathsturn_sum_memory_read_words_1_2_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_2_memory_write_data);

  pathsturn_sum_memory_read_words_1_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 12);
  pathsturn_sum_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1_1, 8);
  pathsturn_sum_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_1_memory_read_address, read_data => pathsturn_sum_memory_read_words_1_1,
      write_address => pathsturn_sum_memory_read_words_1_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_1_memory_write_data);

  pathsturn_sum_memory_read_words_1_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 12);
  pathsturn_sum_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1_0, 8);
  pathsturn_sum_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_0_memory_read_address, read_data => pathsturn_sum_memory_read_words_1_0,
      write_address => pathsturn_sum_memory_read_words_1_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_0_memory_write_data);

  pathsturn_sum_memory_read_words_2_6_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_6_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 4);
  pathsturn_sum_memory_read_words_2_6_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 4);
  pathsturn_sum_memory_read_words_2_6_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_2_6, 8);
  pathsturn_sum_memory_read_words_2_6_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_6_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_6_memory_read_address, read_data => pathsturn_sum_memory_read_words_2_6,
      write_address => pathsturn_sum_memory_read_words_2_6_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_6_memory_write_data);

  pathsturn_sum_memory_read_words_2_5_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_5_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 4);
  pathsturn_sum_memory_read_words_2_5_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 4);
  pathsturn_sum_memory_read_words_2_5_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_2_5, 8);
  pathsturn_sum_memory_read_words_2_5_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_5_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_5_memory_read_address, read_data => pathsturn_sum_memory_read_words_2_5,
      write_address => pathsturn_sum_memory_read_words_2_5_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_5_memory_write_data);

  pathsturn_sum_memory_read_words_2_4_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_4_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 4);
  pathsturn_sum_memory_read_words_2_4_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 4);
  pathsturn_sum_memory_read_words_2_4_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_2_4, 8);
  pathsturn_sum_memory_read_words_2_4_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_4_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_4_memory_read_address, read_data => pathsturn_sum_memory_read_words_2_4,
      write_address => pathsturn_sum_memory_read_words_2_4_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_4_memory_write_data);

  pathsturn_sum_memory_read_words_2_3_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_3_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 4);
  pathsturn_sum_memory_read_words_2_3_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 4);
  pathsturn_sum_memory_read_words_2_3_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_2_3, 8);
  pathsturn_sum_memory_read_words_2_3_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_3_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_3_memory_read_address, read_data => pathsturn_sum_memory_read_words_2_3,
      write_address => pathsturn_sum_memory_read_words_2_3_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_3_memory_write_data);

  pathsturn_sum_memory_read_words_2_2_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_2_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 4);
  pathsturn_sum_memory_read_words_2_2_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 4);
  pathsturn_sum_memory_read_words_2_2_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_2_2, 8);
  pathsturn_sum_memory_read_words_2_2_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_2_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_2_memory_read_address, read_data => pathsturn_sum_memory_read_words_2_2,
      write_address => pathsturn_sum_memory_read_words_2_2_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_2_memory_write_data);

  pathsturn_sum_memory_read_words_2_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 4);
  pathsturn_sum_memory_read_words_2_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 4);
  pathsturn_sum_memory_read_words_2_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_2_1, 8);
  pathsturn_sum_memory_read_words_2_1_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_1_memory_read_address, read_data => pathsturn_sum_memory_read_words_2_1,
      write_address => pathsturn_sum_memory_read_words_2_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_1_memory_write_data);

  pathsturn_sum_memory_read_words_2_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 4);
  pathsturn_sum_memory_read_words_2_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 4);
  pathsturn_sum_memory_read_words_2_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_2_0, 8);
  pathsturn_sum_memory_read_words_2_0_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_0_memory_read_address, read_data => pathsturn_sum_memory_read_words_2_0,
      write_address => pathsturn_sum_memory_read_words_2_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_0_memory_write_data);

  pathsturn_cost_memory_read_words_0_3_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_3_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_3_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
  pathsturn_cost_memory_read_words_0_3_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0_3, 8);
  pathsturn_cost_memory_read_words_0_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_3_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_3_memory_read_address, read_data => pathsturn_cost_memory_read_words_0_3,
      write_address => pathsturn_cost_memory_read_words_0_3_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_3_memory_write_data);

  pathsturn_cost_memory_read_words_0_2_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_2_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_2_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
  pathsturn_cost_memory_read_words_0_2_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0_2, 8);
  pathsturn_cost_memory_read_words_0_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_2_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_2_memory_read_address, read_data => pathsturn_cost_memory_read_words_0_2,
      write_address => pathsturn_cost_memory_read_words_0_2_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_2_memory_write_data);

  pathsturn_cost_memory_read_words_0_1_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
  pathsturn_cost_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0_1, 8);
  pathsturn_cost_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_1_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_1_memory_read_address, read_data => pathsturn_cost_memory_read_words_0_1,
      write_address => pathsturn_cost_memory_read_words_0_1_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_1_memory_write_data);

  pathsturn_cost_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
  pathsturn_cost_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0_0, 8);
  pathsturn_cost_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_0_memory_read_address, read_data => pathsturn_cost_memory_read_words_0_0,
      write_address => pathsturn_cost_memory_read_words_0_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_0_memory_write_data);

  pathsturn_cost_memory_read_words_1_3_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_3_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_3_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 12);
  pathsturn_cost_memory_read_words_1_3_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_1_3, 8);
  pathsturn_cost_memory_read_words_1_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_3_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_3_memory_read_address, read_data => pathsturn_cost_memory_read_words_1_3,
      write_address => pathsturn_cost_memory_read_words_1_3_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_3_memory_write_data);

  pathsturn_cost_memory_read_words_1_2_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_2_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_2_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 12);
  pathsturn_cost_memory_read_words_1_2_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_1_2, 8);
  pathsturn_cost_memory_read_words_1_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_2_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_2_memory_read_address, read_data => pathsturn_cost_memory_read_words_1_2,
      write_address => pathsturn_cost_memory_read_words_1_2_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_2_memory_write_data);

  pathsturn_cost_memory_read_words_1_1_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 12);
  pathsturn_cost_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_1_1, 8);
  pathsturn_cost_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_1_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_1_memory_read_address, read_data => pathsturn_cost_memory_read_words_1_1,
      write_address => pathsturn_cost_memory_read_words_1_1_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_1_memory_write_data);

  pathsturn_cost_memory_read_words_1_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 12);
  pathsturn_cost_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_1_0, 8);
  pathsturn_cost_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_0_memory_read_address, read_data => pathsturn_cost_memory_read_words_1_0,
      write_address => pathsturn_cost_memory_read_words_1_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_0_memory_write_data);

  pathsturn_cost_memory_read_words_2_3_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_3_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 4);
  pathsturn_cost_memory_read_words_2_3_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 4);
  pathsturn_cost_memory_read_words_2_3_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_2_3, 8);
  pathsturn_cost_memory_read_words_2_3_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_3_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_3_memory_read_address, read_data => pathsturn_cost_memory_read_words_2_3,
      write_address => pathsturn_cost_memory_read_words_2_3_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_3_memory_write_data);

  pathsturn_cost_memory_read_words_2_2_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_2_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 4);
  pathsturn_cost_memory_read_words_2_2_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 4);
  pathsturn_cost_memory_read_words_2_2_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_2_2, 8);
  pathsturn_cost_memory_read_words_2_2_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_2_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_2_memory_read_address, read_data => pathsturn_cost_memory_read_words_2_2,
      write_address => pathsturn_cost_memory_read_words_2_2_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_2_memory_write_data);

  pathsturn_cost_memory_read_words_2_1_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_1_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 4);
  pathsturn_cost_memory_read_words_2_1_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 4);
  pathsturn_cost_memory_read_words_2_1_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_2_1, 8);
  pathsturn_cost_memory_read_words_2_1_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_1_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_1_memory_read_address, read_data => pathsturn_cost_memory_read_words_2_1,
      write_address => pathsturn_cost_memory_read_words_2_1_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_1_memory_write_data);

  pathsturn_cost_memory_read_words_2_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 4);
  pathsturn_cost_memory_read_words_2_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 4);
  pathsturn_cost_memory_read_words_2_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_2_0, 8);
  pathsturn_cost_memory_read_words_2_0_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_0_memory_read_address, read_data => pathsturn_cost_memory_read_words_2_0,
      write_address => pathsturn_cost_memory_read_words_2_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_0_memory_write_data);

  pathsabove_delay_held_1_memory_read_enable <= true;
  pathsabove_delay_held_1_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 5);
  pathsabove_delay_held_1_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 5);
  pathsabove_delay_held_1_memory_write_data <= to_unsigned(pathsabove_total_7, 6) & to_unsigned(pathsabove_total_6, 6) & to_unsigned(pathsabove_total_5, 6);
  pathsabove_delay_held_1_memory : entity work.line_memory
    generic map (depth => 20, width => 18, address_bits => 5)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_1_memory_read_enable,
      read_address => pathsabove_delay_held_1_memory_read_address, read_data => pathsabove_delay_held_1,
      write_address => pathsabove_delay_held_1_memory_write_address, write_data => pathsabove_delay_held_1_memory_write_data);

  pathsabove_delay_held_0_memory_read_enable <= true;
  pathsabove_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 5);
  pathsabove_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 5);
  pathsabove_delay_held_0_memory_write_data <= to_unsigned(pathsabove_total_4, 6) & to_unsigned(pathsabove_total_3, 6) & to_unsigned(pathsabove_total_2, 6) & to_unsigned(pathsabove_total_1, 6) & to_unsigned(pathsabove_total_0, 6);
  pathsabove_delay_held_0_memory : entity work.line_memory
    generic map (depth => 20, width => 30, address_bits => 5)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_0_memory_read_enable,
      read_address => pathsabove_delay_held_0_memory_read_address, read_data => pathsabove_delay_held_0,
      write_address => pathsabove_delay_held_0_memory_write_address, write_data => pathsabove_delay_held_0_memory_write_data);

  pathsabove_memory_read_words_0_4_memory_read_enable <= true;
  pathsabove_memory_read_words_0_4_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_4_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_4_memory_write_data <= to_unsigned(pathsabove_memory_write_words_0_4, 8);
  pathsabove_memory_read_words_0_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_4_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_4_memory_read_address, read_data => pathsabove_memory_read_words_0_4,
      write_address => pathsabove_memory_read_words_0_4_memory_write_address, write_data => pathsabove_memory_read_words_0_4_memory_write_data);

  pathsabove_memory_read_words_0_3_memory_read_enable <= true;
  pathsabove_memory_read_words_0_3_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_3_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_3_memory_write_data <= to_unsigned(pathsabove_memory_write_words_0_3, 8);
  pathsabove_memory_read_words_0_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_3_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_3_memory_read_address, read_data => pathsabove_memory_read_words_0_3,
      write_address => pathsabove_memory_read_words_0_3_memory_write_address, write_data => pathsabove_memory_read_words_0_3_memory_write_data);

  pathsabove_memory_read_words_0_2_memory_read_enable <= true;
  pathsabove_memory_read_words_0_2_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_2_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_2_memory_write_data <= to_unsigned(pathsabove_memory_write_words_0_2, 8);
  pathsabove_memory_read_words_0_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_2_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_2_memory_read_address, read_data => pathsabove_memory_read_words_0_2,
      write_address => pathsabove_memory_read_words_0_2_memory_write_address, write_data => pathsabove_memory_read_words_0_2_memory_write_data);

  pathsabove_memory_read_words_0_1_memory_read_enable <= true;
  pathsabove_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words_0_1, 8);
  pathsabove_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_1_memory_read_address, read_data => pathsabove_memory_read_words_0_1,
      write_address => pathsabove_memory_read_words_0_1_memory_write_address, write_data => pathsabove_memory_read_words_0_1_memory_write_data);

  pathsabove_memory_read_words_0_0_memory_read_enable <= true;
  pathsabove_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words_0_0, 8);
  pathsabove_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_0_memory_read_address, read_data => pathsabove_memory_read_words_0_0,
      write_address => pathsabove_memory_read_words_0_0_memory_write_address, write_data => pathsabove_memory_read_words_0_0_memory_write_data);

  pathsabove_memory_read_words_1_4_memory_read_enable <= true;
  pathsabove_memory_read_words_1_4_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_4_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 12);
  pathsabove_memory_read_words_1_4_memory_write_data <= to_unsigned(pathsabove_memory_write_words_1_4, 8);
  pathsabove_memory_read_words_1_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_4_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_4_memory_read_address, read_data => pathsabove_memory_read_words_1_4,
      write_address => pathsabove_memory_read_words_1_4_memory_write_address, write_data => pathsabove_memory_read_words_1_4_memory_write_data);

  pathsabove_memory_read_words_1_3_memory_read_enable <= true;
  pathsabove_memory_read_words_1_3_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_3_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 12);
  pathsabove_memory_read_words_1_3_memory_write_data <= to_unsigned(pathsabove_memory_write_words_1_3, 8);
  pathsabove_memory_read_words_1_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_3_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_3_memory_read_address, read_data => pathsabove_memory_read_words_1_3,
      write_address => pathsabove_memory_read_words_1_3_memory_write_address, write_data => pathsabove_memory_read_words_1_3_memory_write_data);

  pathsabove_memory_read_words_1_2_memory_read_enable <= true;
  pathsabove_memory_read_words_1_2_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_2_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 12);
  pathsabove_memory_read_words_1_2_memory_write_data <= to_unsigned(pathsabove_memory_write_words_1_2, 8);
  pathsabove_memory_read_words_1_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_2_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_2_memory_read_address, read_data => pathsabove_memory_read_words_1_2,
      write_address => pathsabove_memory_read_words_1_2_memory_write_address, write_data => pathsabove_memory_read_words_1_2_memory_write_data);

  pathsabove_memory_read_words_1_1_memory_read_enable <= true;
  pathsabove_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 12);
  pathsabove_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words_1_1, 8);
  pathsabove_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_1_memory_read_address, read_data => pathsabove_memory_read_words_1_1,
      write_address => pathsabove_memory_read_words_1_1_memory_write_address, write_data => pathsabove_memory_read_words_1_1_memory_write_data);

  pathsabove_memory_read_words_1_0_memory_read_enable <= true;
  pathsabove_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 12);
  pathsabove_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words_1_0, 8);
  pathsabove_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_0_memory_read_address, read_data => pathsabove_memory_read_words_1_0,
      write_address => pathsabove_memory_read_words_1_0_memory_write_address, write_data => pathsabove_memory_read_words_1_0_memory_write_data);

  pathsabove_memory_read_words_2_4_memory_read_enable <= true;
  pathsabove_memory_read_words_2_4_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 4);
  pathsabove_memory_read_words_2_4_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 4);
  pathsabove_memory_read_words_2_4_memory_write_data <= to_unsigned(pathsabove_memory_write_words_2_4, 8);
  pathsabove_memory_read_words_2_4_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_4_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_4_memory_read_address, read_data => pathsabove_memory_read_words_2_4,
      write_address => pathsabove_memory_read_words_2_4_memory_write_address, write_data => pathsabove_memory_read_words_2_4_memory_write_data);

  pathsabove_memory_read_words_2_3_memory_read_enable <= true;
  pathsabove_memory_read_words_2_3_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 4);
  pathsabove_memory_read_words_2_3_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 4);
  pathsabove_memory_read_words_2_3_memory_write_data <= to_unsigned(pathsabove_memory_write_words_2_3, 8);
  pathsabove_memory_read_words_2_3_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_3_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_3_memory_read_address, read_data => pathsabove_memory_read_words_2_3,
      write_address => pathsabove_memory_read_words_2_3_memory_write_address, write_data => pathsabove_memory_read_words_2_3_memory_write_data);

  pathsabove_memory_read_words_2_2_memory_read_enable <= true;
  pathsabove_memory_read_words_2_2_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 4);
  pathsabove_memory_read_words_2_2_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 4);
  pathsabove_memory_read_words_2_2_memory_write_data <= to_unsigned(pathsabove_memory_write_words_2_2, 8);
  pathsabove_memory_read_words_2_2_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_2_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_2_memory_read_address, read_data => pathsabove_memory_read_words_2_2,
      write_address => pathsabove_memory_read_words_2_2_memory_write_address, write_data => pathsabove_memory_read_words_2_2_memory_write_data);

  pathsabove_memory_read_words_2_1_memory_read_enable <= true;
  pathsabove_memory_read_words_2_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 4);
  pathsabove_memory_read_words_2_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 4);
  pathsabove_memory_read_words_2_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words_2_1, 8);
  pathsabove_memory_read_words_2_1_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_1_memory_read_address, read_data => pathsabove_memory_read_words_2_1,
      write_address => pathsabove_memory_read_words_2_1_memory_write_address, write_data => pathsabove_memory_read_words_2_1_memory_write_data);

  pathsabove_memory_read_words_2_0_memory_read_enable <= true;
  pathsabove_memory_read_words_2_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 4);
  pathsabove_memory_read_words_2_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 4);
  pathsabove_memory_read_words_2_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words_2_0, 8);
  pathsabove_memory_read_words_2_0_memory : entity work.line_memory
    generic map (depth => 16, width => 8, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_0_memory_read_address, read_data => pathsabove_memory_read_words_2_0,
      write_address => pathsabove_memory_read_words_2_0_memory_write_address, write_data => pathsabove_memory_read_words_2_0_memory_write_data);

  pathsleft_read_words_3_memory_read_enable <= true;
  pathsleft_read_words_3_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsleft_read_words_3_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsleft_read_words_3_memory_write_data <= to_unsigned(pathsleft_arrived_7, 6);
  pathsleft_read_words_3_memory : entity work.line_memory
    generic map (depth => 16, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_read_words_3_memory_read_enable,
      read_address => pathsleft_read_words_3_memory_read_address, read_data => pathsleft_read_words_3,
      write_address => pathsleft_read_words_3_memory_write_address, write_data => pathsleft_read_words_3_memory_write_data);

  pathsleft_read_words_2_memory_read_enable <= true;
  pathsleft_read_words_2_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsleft_read_words_2_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsleft_read_words_2_memory_write_data <= to_unsigned(pathsleft_arrived_6, 6) & to_unsigned(pathsleft_arrived_5, 6) & to_unsigned(pathsleft_arrived_4, 6) & to_unsigned(pathsleft_arrived_3, 6) & to_unsigned(pathsleft_arrived_2, 6);
  pathsleft_read_words_2_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_read_words_2_memory_read_enable,
      read_address => pathsleft_read_words_2_memory_read_address, read_data => pathsleft_read_words_2,
      write_address => pathsleft_read_words_2_memory_write_address, write_data => pathsleft_read_words_2_memory_write_data);

  pathsleft_read_words_1_memory_read_enable <= true;
  pathsleft_read_words_1_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsleft_read_words_1_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsleft_read_words_1_memory_write_data <= to_unsigned(pathsleft_arrived_1, 6) & to_unsigned(pathsleft_arrived_0, 6) & to_unsigned(pathsleft_cost_7, 6) & to_unsigned(pathsleft_cost_6, 6) & to_unsigned(pathsleft_cost_5, 6);
  pathsleft_read_words_1_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_read_words_1_memory_read_enable,
      read_address => pathsleft_read_words_1_memory_read_address, read_data => pathsleft_read_words_1,
      write_address => pathsleft_read_words_1_memory_write_address, write_data => pathsleft_read_words_1_memory_write_data);

  pathsleft_read_words_0_memory_read_enable <= true;
  pathsleft_read_words_0_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsleft_read_words_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsleft_read_words_0_memory_write_data <= to_unsigned(pathsleft_cost_4, 6) & to_unsigned(pathsleft_cost_3, 6) & to_unsigned(pathsleft_cost_2, 6) & to_unsigned(pathsleft_cost_1, 6) & to_unsigned(pathsleft_cost_0, 6);
  pathsleft_read_words_0_memory : entity work.line_memory
    generic map (depth => 16, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_read_words_0_memory_read_enable,
      read_address => pathsleft_read_words_0_memory_read_address, read_data => pathsleft_read_words_0,
      write_address => pathsleft_read_words_0_memory_write_address, write_data => pathsleft_read_words_0_memory_write_data);

  pathsleft_read_neighbour_0_memory_read_enable <= true;
  pathsleft_read_neighbour_0_memory_read_address <= to_unsigned(pathsleft_ahead_count_phase, 4);
  pathsleft_read_neighbour_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsleft_read_neighbour_0_memory_write_data <= to_unsigned(pathsleft_cost_0, 6);
  pathsleft_read_neighbour_0_memory : entity work.line_memory
    generic map (depth => 16, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_read_neighbour_0_memory_read_enable,
      read_address => pathsleft_read_neighbour_0_memory_read_address, read_data => pathsleft_read_neighbour_0,
      write_address => pathsleft_read_neighbour_0_memory_write_address, write_data => pathsleft_read_neighbour_0_memory_write_data);

  pathsleft_lowest_0_memory_read_enable <= true;
  pathsleft_lowest_0_memory_read_address <= to_unsigned(pathsleft_low_address, 4);
  pathsleft_lowest_0_memory_write_address <= to_unsigned(pathsleft_low_write_address, 4);
  pathsleft_lowest_0_memory_write_data <= to_unsigned(pathsleft_low_0, 6);
  pathsleft_lowest_0_memory : entity work.line_memory
    generic map (depth => 16, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_lowest_0_memory_read_enable,
      read_address => pathsleft_lowest_0_memory_read_address, read_data => pathsleft_lowest_0,
      write_address => pathsleft_lowest_0_memory_write_address, write_data => pathsleft_lowest_0_memory_write_data);

  paths_cost_delay_held_0_memory_read_enable <= true;
  paths_cost_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 5);
  paths_cost_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 5);
  paths_cost_delay_held_0_memory_write_data <= to_unsigned(costs_cost_7, 4) & to_unsigned(costs_cost_6, 4) & to_unsigned(costs_cost_5, 4) & to_unsigned(costs_cost_4, 4) & to_unsigned(costs_cost_3, 4) & to_unsigned(costs_cost_2, 4) & to_unsigned(costs_cost_1, 4) & to_unsigned(costs_cost_0, 4);
  paths_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 20, width => 32, address_bits => 5)
    port map (
      clock => clock, read_enable => paths_cost_delay_held_0_memory_read_enable,
      read_address => paths_cost_delay_held_0_memory_read_address, read_data => paths_cost_delay_held_0,
      write_address => paths_cost_delay_held_0_memory_write_address, write_data => paths_cost_delay_held_0_memory_write_data);

  costsshift_read_words_7_memory_read_enable <= true;
  costsshift_read_words_7_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_7_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_7_memory_write_data <= costsshift_search_0_7;
  costsshift_read_words_7_memory : entity work.line_memory
    generic map (depth => 16, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_7_memory_read_enable,
      read_address => costsshift_read_words_7_memory_read_address, read_data => costsshift_read_words_7,
      write_address => costsshift_read_words_7_memory_write_address, write_data => costsshift_read_words_7_memory_write_data);

  costsshift_read_words_6_memory_read_enable <= true;
  costsshift_read_words_6_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_6_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_6_memory_write_data <= costsshift_search_0_6;
  costsshift_read_words_6_memory : entity work.line_memory
    generic map (depth => 16, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_6_memory_read_enable,
      read_address => costsshift_read_words_6_memory_read_address, read_data => costsshift_read_words_6,
      write_address => costsshift_read_words_6_memory_write_address, write_data => costsshift_read_words_6_memory_write_data);

  costsshift_read_words_5_memory_read_enable <= true;
  costsshift_read_words_5_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_5_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_5_memory_write_data <= costsshift_search_0_5;
  costsshift_read_words_5_memory : entity work.line_memory
    generic map (depth => 16, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_5_memory_read_enable,
      read_address => costsshift_read_words_5_memory_read_address, read_data => costsshift_read_words_5,
      write_address => costsshift_read_words_5_memory_write_address, write_data => costsshift_read_words_5_memory_write_data);

  costsshift_read_words_4_memory_read_enable <= true;
  costsshift_read_words_4_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_4_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_4_memory_write_data <= costsshift_search_0_4;
  costsshift_read_words_4_memory : entity work.line_memory
    generic map (depth => 16, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_4_memory_read_enable,
      read_address => costsshift_read_words_4_memory_read_address, read_data => costsshift_read_words_4,
      write_address => costsshift_read_words_4_memory_write_address, write_data => costsshift_read_words_4_memory_write_data);

  costsshift_read_words_3_memory_read_enable <= true;
  costsshift_read_words_3_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_3_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_3_memory_write_data <= costsshift_search_0_3;
  costsshift_read_words_3_memory : entity work.line_memory
    generic map (depth => 16, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_3_memory_read_enable,
      read_address => costsshift_read_words_3_memory_read_address, read_data => costsshift_read_words_3,
      write_address => costsshift_read_words_3_memory_write_address, write_data => costsshift_read_words_3_memory_write_data);

  costsshift_read_words_2_memory_read_enable <= true;
  costsshift_read_words_2_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_2_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_2_memory_write_data <= costsshift_search_0_2;
  costsshift_read_words_2_memory : entity work.line_memory
    generic map (depth => 16, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_2_memory_read_enable,
      read_address => costsshift_read_words_2_memory_read_address, read_data => costsshift_read_words_2,
      write_address => costsshift_read_words_2_memory_write_address, write_data => costsshift_read_words_2_memory_write_data);

  costsshift_read_words_1_memory_read_enable <= true;
  costsshift_read_words_1_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_1_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_1_memory_write_data <= costsshift_search_0_1;
  costsshift_read_words_1_memory : entity work.line_memory
    generic map (depth => 16, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_1_memory_read_enable,
      read_address => costsshift_read_words_1_memory_read_address, read_data => costsshift_read_words_1,
      write_address => costsshift_read_words_1_memory_write_address, write_data => costsshift_read_words_1_memory_write_data);

  costsshift_read_words_0_memory_read_enable <= true;
  costsshift_read_words_0_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_0_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_0_memory_write_data <= costsshift_search_0_0;
  costsshift_read_words_0_memory : entity work.line_memory
    generic map (depth => 16, width => 44, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_0_memory_read_enable,
      read_address => costsshift_read_words_0_memory_read_address, read_data => costsshift_read_words_0,
      write_address => costsshift_read_words_0_memory_write_address, write_data => costsshift_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_differs : boolean;
    variable transform_counter_next_frame_choice, transform_counter_next_frame_choice_2 : boolean;
    variable transform_counter_next_frame_choice_3, transform_counter_next_frame_choice_4 : boolean;
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
    variable transform_left_filter_feature_0_choice_346, transform_left_filter_feature_0_choice_347 : boolean;
    variable transform_left_filter_feature_0_value_7, transform_left_filter_feature_0_choice_348 : boolean;
    variable transform_left_filter_feature_0_value_8, transform_left_filter_feature_0_choice_349 : boolean;
    variable transform_left_filter_feature_0_value_9, transform_left_filter_feature_0_choice_350 : boolean;
    variable transform_left_filter_feature_0_value_10, transform_left_filter_feature_0_choice_351 : boolean;
    variable transform_left_filter_feature_0_value_11, transform_left_filter_feature_0_choice_352 : boolean;
    variable transform_left_filter_feature_0_choice_353, transform_right_filter_feature_0_value : boolean;
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
    variable transform_right_filter_feature_0_value_7, transform_right_filter_feature_0_choice_348 : boolean;
    variable transform_right_filter_feature_0_value_8, transform_right_filter_feature_0_choice_349 : boolean;
    variable transform_right_filter_feature_0_value_9, transform_right_filter_feature_0_choice_350 : boolean;
    variable transform_right_filter_feature_0_value_10, transform_right_filter_feature_0_choice_351 : boolean;
    variable transform_right_filter_feature_0_value_11, transform_right_filter_feature_0_choice_352 : boolean;
    variable transform_right_filter_feature_0_choice_353, raster_place_group_is_equal : boolean;
    variable delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less : boolean;
    variable line_order_falls_any, line_order_falls_all, line_order_complete_any : boolean;
    variable line_order_turned_output_column_choice, costswindow_first_0_count_0_value : boolean;
    variable costswindow_first_0_count_0_value_2, costswindow_first_0_count_1_value : boolean;
    variable costswindow_first_0_count_1_value_2, costswindow_first_0_count_1_value_3 : boolean;
    variable costswindow_first_0_count_2_value, costswindow_first_0_count_2_value_2 : boolean;
    variable costswindow_first_0_count_2_value_3, costswindow_first_0_count_3_value : boolean;
    variable costswindow_first_0_count_3_value_2, costswindow_first_0_count_3_value_3 : boolean;
    variable costswindow_first_0_count_4_value, costswindow_first_0_count_4_value_2 : boolean;
    variable costswindow_first_0_count_4_value_3, costswindow_first_0_count_5_value : boolean;
    variable costswindow_first_0_count_5_value_2, costswindow_first_0_count_5_value_3 : boolean;
    variable costswindow_first_0_count_6_value, costswindow_first_0_count_6_value_2 : boolean;
    variable costswindow_first_0_count_6_value_3, costswindow_first_0_count_7_value : boolean;
    variable costswindow_first_0_count_7_value_2, costswindow_first_0_count_7_value_3 : boolean;
    variable costswindow_first_0_count_8_value, costswindow_first_0_count_8_value_2 : boolean;
    variable costswindow_first_0_count_8_value_3, costswindow_first_0_count_9_value : boolean;
    variable costswindow_first_0_count_9_value_2, costswindow_first_0_count_9_value_3 : boolean;
    variable costswindow_first_0_count_10_value, costswindow_first_0_count_10_value_2 : boolean;
    variable costswindow_first_0_count_10_value_3, costswindow_first_0_count_11_value : boolean;
    variable costswindow_first_0_count_11_value_2, costswindow_first_0_count_11_value_3 : boolean;
    variable costswindow_first_0_count_12_value, costswindow_first_0_count_12_value_2 : boolean;
    variable costswindow_first_0_count_12_value_3, costswindow_first_0_count_13_value : boolean;
    variable costswindow_first_0_count_13_value_2, costswindow_first_0_count_13_value_3 : boolean;
    variable costswindow_first_0_count_14_value, pathsleft_read_count_phase_is_equal, pathsleft_cost_0_any : boolean;
    variable pathsabove_memory_ready_words_0_is_equal, pathsabove_memory_ready_words_0_is_equal_2 : boolean;
    variable pathsabove_ready_top_choice, pathsabove_ready_top_choice_2, pathsabove_count_phase_is_equal : boolean;
    variable pathsabove_memory_write_words_0_0_is_less, pathsabove_memory_write_words_0_1_is_less : boolean;
    variable pathsabove_memory_write_words_0_1_choice_3, pathsabove_memory_write_words_0_2_is_less : boolean;
    variable pathsabove_memory_write_words_0_3_is_less, pathsabove_memory_write_words_0_0_all : boolean;
    variable pathsabove_memory_write_words_1_0_all, pathsabove_memory_write_words_2_0_all : boolean;
    variable pathsturn_sum_memory_ready_words_0_is_equal, pathsturn_sum_memory_ready_words_0_is_equal_2 : boolean;
    variable pathsturn_cost_memory_ready_words_0_is_equal, pathsturn_cost_memory_ready_words_0_is_equal_2 : boolean;
    variable pathsturn_sum_memory_write_words_0_0_all, pathsturn_sum_memory_write_words_1_0_all : boolean;
    variable pathsturn_sum_memory_write_words_2_0_all, pathsturn_cost_memory_write_words_0_0_all : boolean;
    variable pathsturn_cost_memory_write_words_1_0_all, pathsturn_cost_memory_write_words_2_0_all : boolean;
    variable winnerswinner1_best_index_0_0_choice, winnerswinner1_best_index_0_0_choice_2 : boolean;
    variable winnerswinner1_best_index_0_0_value, winnerswinner1_best_index_0_0_choice_3 : boolean;
    variable winnerswinner1_best_index_0_0_value_2, winnerswinner1_best_index_0_0_choice_4 : boolean;
    variable winnerswinner1_best_index_0_0_value_3, winnerswinner1_best_index_0_0_choice_5 : boolean;
    variable winnerswinner1_best_index_0_0_value_4, winnerswinner1_best_index_0_0_choice_6 : boolean;
    variable winnerswinner1_best_index_0_0_value_5, winnerswinner1_best_index_0_0_choice_7 : boolean;
    variable winnerswinner1_best_index_0_1_choice, winnerswinner1_best_index_0_1_choice_2 : boolean;
    variable winnerswinner1_best_index_0_1_value, winnerswinner1_best_index_0_1_choice_3 : boolean;
    variable winnerswinner1_best_index_0_1_value_2, winnerswinner1_best_index_0_1_choice_4 : boolean;
    variable winnerswinner1_best_index_0_1_value_3, winnerswinner1_best_index_0_1_choice_5 : boolean;
    variable winnerswinner1_best_index_0_1_value_4, winnerswinner1_best_index_0_1_choice_6 : boolean;
    variable winnerswinner1_best_index_0_1_value_5, winnerswinner1_best_index_0_1_choice_7 : boolean;
    variable winnerswinner1_best_index_0_1_choice_8, winnerswinner1_best_index_0_2_choice : boolean;
    variable winnerswinner1_best_index_0_2_choice_2, winnerswinner1_best_index_0_2_value : boolean;
    variable winnerswinner1_best_index_0_2_choice_3, winnerswinner1_best_index_0_2_value_2 : boolean;
    variable winnerswinner1_best_index_0_2_choice_4, winnerswinner1_best_index_0_2_value_3 : boolean;
    variable winnerswinner1_best_index_0_2_choice_5, winnerswinner1_best_index_0_2_value_4 : boolean;
    variable winnerswinner1_best_index_0_2_choice_6, winnerswinner1_best_index_0_2_value_5 : boolean;
    variable winnerswinner1_best_index_0_2_choice_7, winnerswinner1_best_index_0_2_choice_8 : boolean;
    variable winnerswinner1_best_index_0_3_choice, winnerswinner1_best_index_0_3_choice_2 : boolean;
    variable winnerswinner1_best_index_0_3_value, winnerswinner1_best_index_0_3_choice_3 : boolean;
    variable winnerswinner1_best_index_0_3_value_2, winnerswinner1_best_index_0_3_choice_4 : boolean;
    variable winnerswinner1_best_index_0_3_value_3, winnerswinner1_best_index_0_3_choice_5 : boolean;
    variable winnerswinner1_best_index_0_3_value_4, winnerswinner1_best_index_0_3_choice_6 : boolean;
    variable winnerswinner1_best_index_0_3_value_5, winnerswinner1_best_index_0_3_choice_7 : boolean;
    variable winnerswinner1_best_index_0_3_choice_8, winnerswinner2_best_index_0_0_choice : boolean;
    variable winnerswinner2_best_index_0_0_choice_2, winnerswinner2_best_index_0_0_value : boolean;
    variable winnerswinner2_best_index_0_0_choice_3, winnerswinner2_best_index_0_0_value_2 : boolean;
    variable winnerswinner2_best_index_0_0_choice_4, winnerswinner2_best_index_0_0_value_3 : boolean;
    variable winnerswinner2_best_index_0_0_choice_5, winnerswinner2_best_index_0_0_value_4 : boolean;
    variable winnerswinner2_best_index_0_0_choice_6, winnerswinner2_best_index_0_0_value_5 : boolean;
    variable winnerswinner2_best_index_0_0_choice_7, winnerswinner2_best_index_0_0_choice_8 : boolean;
    variable winnerswinner2_best_index_0_1_choice, winnerswinner2_best_index_0_1_choice_2 : boolean;
    variable winnerswinner2_best_index_0_1_value, winnerswinner2_best_index_0_1_choice_3 : boolean;
    variable winnerswinner2_best_index_0_1_value_2, winnerswinner2_best_index_0_1_choice_4 : boolean;
    variable winnerswinner2_best_index_0_1_value_3, winnerswinner2_best_index_0_1_choice_5 : boolean;
    variable winnerswinner2_best_index_0_1_value_4, winnerswinner2_best_index_0_1_choice_6 : boolean;
    variable winnerswinner2_best_index_0_1_value_5, winnerswinner2_best_index_0_1_choice_7 : boolean;
    variable winnerswinner2_best_index_0_1_choice_8, winnerswinner3_best_index_0_0_choice : boolean;
    variable winnerswinner3_best_index_0_0_choice_2, winnerswinner3_best_index_0_0_value : boolean;
    variable winnerswinner3_best_index_0_0_choice_3, winnerswinner3_best_index_0_0_value_2 : boolean;
    variable winnerswinner3_best_index_0_0_choice_4, winnerswinner3_best_index_0_0_value_3 : boolean;
    variable winnerswinner3_best_index_0_0_choice_5, winnerswinner3_best_index_0_0_value_4 : boolean;
    variable winnerswinner3_best_index_0_0_choice_6, winnerswinner3_best_index_0_0_value_5 : boolean;
    variable winnerswinner3_best_index_0_0_choice_7, winnerswinner3_best_index_0_0_choice_8 : boolean;
    variable winners_best_index_0_0_value, winners_best_index_0_0_choice, winners_best_index_0_0_value_2 : boolean;
    variable winners_best_index_0_0_choice_2, winners_best_index_0_0_value_3, winners_best_index_0_0_choice_3 : boolean;
    variable winners_best_index_0_0_value_4, winners_best_index_0_0_choice_4, winners_best_index_0_0_value_5 : boolean;
    variable winners_best_index_0_0_choice_5, winners_best_index_0_0_value_6, winners_best_index_0_0_choice_6 : boolean;
    variable winners_best_index_0_0_choice_7, turn_order_address_any, turn_order_address_any_2 : boolean;
    variable turn_order_falls_all, turn_order_complete_all, turn_ready_tag_row_start_differs : boolean;
    variable turn_ready_tag_row_start_is_equal, turn_ready_tag_row_start_choice : boolean;
    variable turn_ready_tag_row_start_choice_2, turn_ready_tag_row_start_is_equal_2 : boolean;
    variable turn_ready_tag_row_start_all, turn_ready_tag_row_start_choice_3, turn_ready_tag_row_start_all_2 : boolean;
    variable map_counter_group_is_equal, map_line_ended_choice, map_at_arrives_value : boolean;
    variable map_of_column_0_b_below_a_value, map_of_column_0_b_below_a_choice : boolean;
    variable map_of_column_0_b_below_a_value_2, map_of_column_0_b_below_a_choice_2 : boolean;
    variable map_of_column_0_b_below_a_choice_3, map_of_column_0_b_below_a_choice_4 : boolean;
    variable map_of_column_0_b_below_a_value_3, map_of_column_0_b_below_a_value_4 : boolean;
    variable map_of_column_0_b_below_a_choice_5, map_of_column_0_b_below_a_value_5 : boolean;
    variable map_of_column_0_b_below_a_value_6, map_of_column_0_b_below_a_choice_6 : boolean;
    variable map_of_column_0_b_below_a_value_7, map_of_column_0_b_below_a_value_8 : boolean;
    variable map_of_column_0_b_below_a_choice_7, map_of_column_0_b_below_a_value_9 : boolean;
    variable map_of_column_0_b_below_a_value_10, map_of_column_0_b_below_a_choice_8 : boolean;
    variable map_of_column_0_b_below_a_value_11, map_of_column_0_b_below_a_value_12 : boolean;
    variable map_of_column_0_b_below_a_choice_9, map_of_column_0_c_below_a_value : boolean;
    variable map_of_column_0_c_below_a_choice, map_of_column_0_c_below_a_value_2 : boolean;
    variable map_of_column_0_c_below_a_choice_2, map_of_column_0_c_below_a_choice_3 : boolean;
    variable map_of_column_0_c_below_a_value_3, map_of_column_0_c_below_a_choice_4 : boolean;
    variable map_of_column_0_c_below_a_choice_5, map_of_column_0_c_below_a_choice_6 : boolean;
    variable map_of_column_0_c_below_a_value_4, map_of_column_0_c_below_a_choice_7 : boolean;
    variable map_of_column_0_c_below_a_choice_8, map_of_column_0_c_below_a_choice_9 : boolean;
    variable map_of_column_0_c_below_a_value_5, map_of_column_0_c_below_a_choice_10 : boolean;
    variable map_of_column_0_c_below_a_choice_11, map_of_column_0_c_below_a_choice_12 : boolean;
    variable map_of_column_0_c_below_a_value_6, map_of_column_0_c_below_a_choice_13 : boolean;
    variable map_of_column_0_c_below_a_choice_14, map_of_column_0_c_below_a_choice_15 : boolean;
    variable map_of_column_0_c_below_a_value_7, map_of_column_0_c_below_a_choice_16 : boolean;
    variable map_of_column_0_c_below_a_choice_17, map_of_column_0_c_below_a_choice_18 : boolean;
    variable map_of_column_0_c_below_a_choice_19, map_of_column_0_c_below_a_choice_20 : boolean;
    variable map_of_column_0_c_below_b_choice, map_of_column_0_c_below_b_choice_2 : boolean;
    variable map_of_column_0_c_below_b_choice_3, map_of_column_0_c_below_b_choice_4 : boolean;
    variable map_of_column_0_c_below_b_choice_5, map_of_column_0_c_below_b_choice_6 : boolean;
    variable map_window_complete_is_equal, map_window_complete_choice, map_of_low_0_b_below_a_value : boolean;
    variable map_of_low_0_b_below_a_choice, map_of_low_0_b_below_a_is_equal, map_of_low_0_b_below_a_choice_2 : boolean;
    variable map_of_low_0_b_below_a_value_2, map_of_low_0_b_below_a_value_3, map_of_low_0_b_below_a_choice_3 : boolean;
    variable map_of_low_0_b_below_a_value_4, map_of_low_0_b_below_a_value_5, map_of_low_0_b_below_a_choice_4 : boolean;
    variable map_of_low_0_b_below_a_value_6, map_of_low_0_b_below_a_value_7, map_of_low_0_b_below_a_choice_5 : boolean;
    variable map_of_low_0_b_below_a_value_8, map_of_low_0_b_below_a_value_9, map_of_low_0_b_below_a_choice_6 : boolean;
    variable map_of_low_0_b_below_a_value_10, map_of_low_0_b_below_a_value_11 : boolean;
    variable map_of_low_0_b_below_a_choice_7, map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice : boolean;
    variable map_of_low_0_c_below_a_choice_2, map_of_low_0_c_below_a_choice_3 : boolean;
    variable map_of_low_0_c_below_a_choice_4, map_of_low_0_c_below_a_choice_5 : boolean;
    variable map_of_low_0_c_below_a_choice_6, map_of_low_0_c_below_a_choice_7, map_of_low_0_c_below_b_choice : boolean;
    variable map_of_low_0_c_below_b_choice_2, map_of_low_0_c_below_b_choice_3 : boolean;
    variable map_of_low_0_c_below_b_choice_4, map_of_low_0_c_below_b_choice_5 : boolean;
    variable map_of_low_0_c_below_b_choice_6, map_of_low_0_c_below_b_choice_7 : boolean;
    variable map_of_middle_0_b_below_a_value, map_of_middle_0_b_below_a_choice : boolean;
    variable map_of_middle_0_b_below_a_is_equal, map_of_middle_0_b_below_a_choice_2 : boolean;
    variable map_of_middle_0_b_below_a_value_2, map_of_middle_0_b_below_a_value_3 : boolean;
    variable map_of_middle_0_b_below_a_choice_3, map_of_middle_0_b_below_a_value_4 : boolean;
    variable map_of_middle_0_b_below_a_value_5, map_of_middle_0_b_below_a_choice_4 : boolean;
    variable map_of_middle_0_b_below_a_value_6, map_of_middle_0_b_below_a_value_7 : boolean;
    variable map_of_middle_0_b_below_a_choice_5, map_of_middle_0_b_below_a_value_8 : boolean;
    variable map_of_middle_0_b_below_a_value_9, map_of_middle_0_b_below_a_choice_6 : boolean;
    variable map_of_middle_0_b_below_a_value_10, map_of_middle_0_b_below_a_value_11 : boolean;
    variable map_of_middle_0_b_below_a_choice_7, map_of_middle_0_c_below_a_value : boolean;
    variable map_of_middle_0_c_below_a_choice, map_of_middle_0_c_below_a_choice_2 : boolean;
    variable map_of_middle_0_c_below_a_choice_3, map_of_middle_0_c_below_a_choice_4 : boolean;
    variable map_of_middle_0_c_below_a_choice_5, map_of_middle_0_c_below_a_choice_6 : boolean;
    variable map_of_middle_0_c_below_a_choice_7, map_of_middle_0_c_below_b_choice : boolean;
    variable map_of_middle_0_c_below_b_choice_2, map_of_middle_0_c_below_b_choice_3 : boolean;
    variable map_of_middle_0_c_below_b_choice_4, map_of_middle_0_c_below_b_choice_5 : boolean;
    variable map_of_middle_0_c_below_b_choice_6, map_of_middle_0_c_below_b_choice_7 : boolean;
    variable map_of_high_0_b_below_a_value, map_of_high_0_b_below_a_choice, map_of_high_0_b_below_a_is_equal : boolean;
    variable map_of_high_0_b_below_a_choice_2, map_of_high_0_b_below_a_value_2 : boolean;
    variable map_of_high_0_b_below_a_value_3, map_of_high_0_b_below_a_choice_3 : boolean;
    variable map_of_high_0_b_below_a_value_4, map_of_high_0_b_below_a_value_5 : boolean;
    variable map_of_high_0_b_below_a_choice_4, map_of_high_0_b_below_a_value_6 : boolean;
    variable map_of_high_0_b_below_a_value_7, map_of_high_0_b_below_a_choice_5 : boolean;
    variable map_of_high_0_b_below_a_value_8, map_of_high_0_b_below_a_value_9 : boolean;
    variable map_of_high_0_b_below_a_choice_6, map_of_high_0_b_below_a_value_10 : boolean;
    variable map_of_high_0_b_below_a_value_11, map_of_high_0_b_below_a_choice_7 : boolean;
    variable map_of_high_0_c_below_a_value, map_of_high_0_c_below_a_choice, map_of_high_0_c_below_a_choice_2 : boolean;
    variable map_of_high_0_c_below_a_choice_3, map_of_high_0_c_below_a_choice_4 : boolean;
    variable map_of_high_0_c_below_a_choice_5, map_of_high_0_c_below_a_choice_6 : boolean;
    variable map_of_high_0_c_below_a_choice_7, map_of_high_0_c_below_b_choice : boolean;
    variable map_of_high_0_c_below_b_choice_2, map_of_high_0_c_below_b_choice_3 : boolean;
    variable map_of_high_0_c_below_b_choice_4, map_of_high_0_c_below_b_choice_5 : boolean;
    variable map_of_high_0_c_below_b_choice_6, map_of_high_0_c_below_b_choice_7, map_of_all_0_b_below_a_value : boolean;
    variable map_of_all_0_b_below_a_choice, map_of_all_0_b_below_a_is_equal, map_of_all_0_b_below_a_choice_2 : boolean;
    variable map_of_all_0_b_below_a_value_2, map_of_all_0_b_below_a_value_3, map_of_all_0_b_below_a_choice_3 : boolean;
    variable map_of_all_0_b_below_a_value_4, map_of_all_0_b_below_a_value_5, map_of_all_0_b_below_a_choice_4 : boolean;
    variable map_of_all_0_b_below_a_value_6, map_of_all_0_b_below_a_value_7, map_of_all_0_b_below_a_choice_5 : boolean;
    variable map_of_all_0_b_below_a_value_8, map_of_all_0_b_below_a_value_9, map_of_all_0_b_below_a_choice_6 : boolean;
    variable map_of_all_0_b_below_a_value_10, map_of_all_0_b_below_a_value_11 : boolean;
    variable map_of_all_0_b_below_a_choice_7, map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice : boolean;
    variable map_of_all_0_c_below_a_choice_2, map_of_all_0_c_below_a_choice_3 : boolean;
    variable map_of_all_0_c_below_a_choice_4, map_of_all_0_c_below_a_choice_5 : boolean;
    variable map_of_all_0_c_below_a_choice_6, map_of_all_0_c_below_a_choice_7, map_of_all_0_c_below_b_choice : boolean;
    variable map_of_all_0_c_below_b_choice_2, map_of_all_0_c_below_b_choice_3 : boolean;
    variable map_of_all_0_c_below_b_choice_4, map_of_all_0_c_below_b_choice_5 : boolean;
    variable map_of_all_0_c_below_b_choice_6, map_of_all_0_c_below_b_choice_7, map_low_1_0_all : boolean;
    variable map_low_0_0_all : boolean;
    variable transform_counter_group_choice, costsshift_count_phase_choice : natural range 0 to 15;
    variable paths_smallest_cost_choice, pathsleft_read_count_phase_choice : natural range 0 to 15;
    variable pathsleft_ahead_count_phase_choice, pathsleft_stay_change_1_value : natural range 0 to 15;
    variable pathsleft_stay_change_2_value, pathsleft_stay_change_3_value : natural range 0 to 15;
    variable pathsleft_stay_change_4_value, pathsleft_stay_change_5_value : natural range 0 to 15;
    variable pathsleft_stay_change_6_value, pathsleft_write_count_phase_choice : natural range 0 to 15;
    variable pathsabove_memory_read_address_2_choice : natural range 0 to 15;
    variable pathsabove_read_address_count_phase_choice, pathsabove_count_phase_choice : natural range 0 to 15;
    variable pathsabove_write_address_count_phase_choice : natural range 0 to 15;
    variable pathsabove_memory_write_words_0_2_choice_2 : natural range 0 to 15;
    variable pathsturn_read_address_count_phase_choice : natural range 0 to 15;
    variable pathsturn_write_address_count_phase_choice, map_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 511;
    variable map_counter_group_choice_2, map_counter_group_choice_3 : natural range 0 to 511;
    variable transform_left_filter_feature_0_choice_354 : natural range 0 to 31;
    variable transform_right_filter_feature_0_choice_354, pathsleft_q_choice : natural range 0 to 31;
    variable pathsleft_q_choice_2, pathsleft_room_left_choice, pathsabove_total_0_choice : natural range 0 to 31;
    variable pathsabove_total_1_choice, pathsabove_total_2_choice, pathsabove_total_3_choice : natural range 0 to 31;
    variable pathsabove_total_4_choice, pathsabove_total_5_choice, pathsabove_total_6_choice : natural range 0 to 31;
    variable pathsabove_total_7_choice, pathsabove_memory_write_words_0_0_choice_2 : natural range 0 to 31;
    variable pathsabove_memory_write_words_0_1_choice : natural range 0 to 31;
    variable pathsabove_memory_write_words_0_1_choice_2 : natural range 0 to 31;
    variable pathsabove_memory_write_words_0_2_choice, pathsabove_memory_write_words_0_3_choice : natural range 0 to 31;
    variable pathsabove_memory_write_words_0_3_choice_2 : natural range 0 to 31;
    variable pathsabove_memory_write_words_0_4_choice : natural range 0 to 31;
    variable pathsabove_memory_write_words_0_4_choice_2, pathsright_q_choice : natural range 0 to 31;
    variable pathsright_q_choice_2, pathsright_room_left_choice : natural range 0 to 31;
    variable transform_left_filter_feature_0_choice_355 : natural range 0 to 1023;
    variable transform_right_filter_feature_0_choice_355 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_356 : natural range 0 to 32767;
    variable transform_right_filter_feature_0_choice_356 : natural range 0 to 32767;
    variable transform_left_filter_feature_0_choice_357 : natural range 0 to 1048575;
    variable transform_right_filter_feature_0_choice_357 : natural range 0 to 1048575;
    variable transform_left_filter_feature_0_choice_358 : natural range 0 to 8388607;
    variable transform_right_filter_feature_0_choice_358 : natural range 0 to 8388607;
    variable transform_left_filter_feature_0_choice_359 : natural range 0 to 536870911;
    variable transform_right_filter_feature_0_choice_359 : natural range 0 to 536870911;
    variable transform_left_filter_feature_0_choice_360 : unsigned(33 downto 0);
    variable transform_right_filter_feature_0_choice_360 : unsigned(33 downto 0);
    variable transform_left_filter_feature_0_choice_361 : unsigned(38 downto 0);
    variable transform_right_filter_feature_0_choice_361 : unsigned(38 downto 0);
    variable line_order_address_choice, turn_order_address_choice : natural range 1 to 1023;
    variable pathsleft_lower_neighbour_value, pathsleft_stay_0_value, pathsleft_stay_0_choice : natural range 0 to 63;
    variable pathsleft_stay_1_value, pathsleft_stay_1_choice, pathsleft_stay_2_value : natural range 0 to 63;
    variable pathsleft_stay_2_choice, pathsleft_stay_3_value, pathsleft_stay_3_value_2 : natural range 0 to 63;
    variable pathsleft_stay_3_choice, pathsleft_stay_4_value, pathsleft_stay_4_choice : natural range 0 to 63;
    variable pathsleft_stay_5_value, pathsleft_stay_5_choice, pathsleft_stay_6_value : natural range 0 to 63;
    variable pathsleft_stay_6_choice, pathsleft_stay_7_choice, pathsleft_step_0_choice : natural range 0 to 63;
    variable pathsleft_step_0_choice_2, pathsleft_step_1_choice, pathsleft_step_2_choice : natural range 0 to 63;
    variable pathsleft_step_3_choice, pathsleft_step_4_choice, pathsleft_step_5_choice : natural range 0 to 63;
    variable pathsleft_step_6_choice, pathsleft_step_7_choice, pathsleft_step_7_choice_2 : natural range 0 to 63;
    variable pathsleft_low_0_choice, pathsabove_smallest_total_choice : natural range 0 to 63;
    variable pathsabove_beside_0_choice, pathsabove_beside_7_choice : natural range 0 to 63;
    variable pathsright_lower_neighbour_value, pathsright_stay_0_value : natural range 0 to 63;
    variable pathsright_stay_0_choice, pathsright_stay_1_value, pathsright_stay_1_choice : natural range 0 to 63;
    variable pathsright_stay_2_value, pathsright_stay_2_choice, pathsright_stay_3_value : natural range 0 to 63;
    variable pathsright_stay_3_value_2, pathsright_stay_3_choice, pathsright_stay_4_value : natural range 0 to 63;
    variable pathsright_stay_4_choice, pathsright_stay_5_value, pathsright_stay_5_choice : natural range 0 to 63;
    variable pathsright_stay_6_value, pathsright_stay_6_choice, pathsright_stay_7_choice : natural range 0 to 63;
    variable pathsright_step_0_choice, pathsright_step_0_choice_2, pathsright_step_1_choice : natural range 0 to 63;
    variable pathsright_step_2_choice, pathsright_step_3_choice, pathsright_step_4_choice : natural range 0 to 63;
    variable pathsright_step_5_choice, pathsright_step_6_choice, pathsright_step_7_choice : natural range 0 to 63;
    variable pathsright_step_7_choice_2, pathsright_low_0_choice : natural range 0 to 63;
    variable pathsabove_memory_read_address_0_sum : natural range 1 to 16384;
    variable pathsabove_memory_read_address_0_choice : natural range 0 to 4095;
    variable pathsabove_memory_read_address_0_sum_2 : natural range 0 to 16384;
    variable pathsturn_cost_memory_read_address_0_sum : natural range 0 to 16384;
    variable pathsabove_memory_bank_choice, pathsabove_memory_bank_choice_2 : natural range 0 to 16383;
    variable pathsabove_write_address_address_choice, pathsturn_cost_memory_bank_choice : natural range 0 to 16383;
    variable pathsabove_memory_ready_words_0_choice, pathsabove_memory_ready_words_1_choice : natural range 0 to 255;
    variable pathsabove_memory_ready_words_2_choice, pathsabove_memory_ready_words_3_choice : natural range 0 to 255;
    variable pathsabove_memory_ready_words_4_choice, pathsabove_memory_write_words_0_0_sum : natural range 0 to 255;
    variable pathsabove_memory_write_words_0_1_sum, pathsabove_memory_write_words_0_2_sum : natural range 0 to 255;
    variable pathsabove_memory_write_words_0_3_sum, pathsabove_memory_write_words_0_4_sum : natural range 0 to 255;
    variable pathsturn_sum_memory_ready_words_0_choice : natural range 0 to 255;
    variable pathsturn_sum_memory_ready_words_1_choice : natural range 0 to 255;
    variable pathsturn_sum_memory_ready_words_2_choice : natural range 0 to 255;
    variable pathsturn_sum_memory_ready_words_3_choice : natural range 0 to 255;
    variable pathsturn_sum_memory_ready_words_4_choice : natural range 0 to 255;
    variable pathsturn_sum_memory_ready_words_5_choice : natural range 0 to 255;
    variable pathsturn_sum_memory_ready_words_6_choice : natural range 0 to 255;
    variable pathsturn_cost_memory_ready_words_0_choice : natural range 0 to 255;
    variable pathsturn_cost_memory_ready_words_1_choice : natural range 0 to 255;
    variable pathsturn_cost_memory_ready_words_2_choice : natural range 0 to 255;
    variable pathsturn_cost_memory_ready_words_3_choice : natural range 0 to 255;
    variable pathsturn_sum_memory_write_words_0_1_sum_2 : natural range 0 to 255;
    variable pathsturn_sum_memory_write_words_0_2_sum_2 : natural range 0 to 255;
    variable pathsturn_sum_memory_write_words_0_3_sum_2 : natural range 0 to 255;
    variable pathsturn_sum_memory_write_words_0_4_sum_2 : natural range 0 to 255;
    variable pathsturn_sum_memory_write_words_0_5_sum_2 : natural range 0 to 255;
    variable pathsturn_cost_memory_write_words_0_1_value : natural range 0 to 255;
    variable pathsturn_cost_memory_write_words_0_2_value, winners_best_cost_0_0_choice : natural range 0 to 255;
    variable map_sorted_low_0_choice, map_sorted_low_0_choice_2, map_sorted_middle_0_choice : natural range 0 to 255;
    variable map_sorted_middle_0_choice_2, map_sorted_high_0_choice : natural range 0 to 255;
    variable map_sorted_high_0_choice_2, map_largest_low_0_choice, map_largest_low_0_choice_2 : natural range 0 to 255;
    variable map_median_middle_0_choice, map_median_middle_0_choice_2 : natural range 0 to 255;
    variable map_median_middle_0_choice_3, map_median_middle_0_choice_4 : natural range 0 to 255;
    variable map_smallest_high_0_choice, map_smallest_high_0_choice_2 : natural range 0 to 255;
    variable map_out_disparity_0_choice, map_out_disparity_0_choice_2 : natural range 0 to 255;
    variable map_out_disparity_0_choice_3, map_out_disparity_0_choice_4, map_low_0_0_choice : natural range 0 to 255;
    variable map_middle_0_0_choice, map_high_0_0_choice : natural range 0 to 255;
    variable pathsabove_memory_write_words_0_0_choice : natural range 0 to 7;
    variable pathsabove_memory_write_words_0_3_choice_3 : natural range 0 to 3;
    variable pathsturn_sum_memory_write_words_0_0_sum : natural range 0 to 126;
    variable pathsturn_sum_memory_write_words_0_1_sum : natural range 0 to 126;
    variable pathsturn_sum_memory_write_words_0_2_sum : natural range 0 to 126;
    variable pathsturn_sum_memory_write_words_0_3_sum : natural range 0 to 126;
    variable pathsturn_sum_memory_write_words_0_4_sum : natural range 0 to 126;
    variable pathsturn_sum_memory_write_words_0_5_sum : natural range 0 to 126;
    variable pathsturn_sum_memory_write_words_0_0_sum_2 : natural range 0 to 254;
    variable pathsturn_sum_memory_write_words_0_6_sum : natural range 0 to 253;
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
      transform_counter_group_differs := transform_counter_group /= 482;
      if (transform_counter_group = 481) and transform_counter_next_frame then
        transform_counter_group_choice_2 := 2;
      else
        transform_counter_group_choice_2 := (transform_counter_group + 1) mod 512;
      end if;
      if transform_counter_group_differs and in_valid and transform_counter_group_is_equal_2 then
        transform_counter_group_choice_3 := transform_counter_group_choice_2;
      else
        transform_counter_group_choice_3 := transform_counter_group;
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := (transform_counter_group /= 481) and transform_counter_next_frame;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_differs then
        transform_counter_next_frame_choice_2 := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if transform_counter_group_all then
        transform_counter_next_frame_choice_3 := in_valid;
      else
        transform_counter_next_frame_choice_3 := in_valid and (not in_start_of_frame);
      end if;
      if transform_counter_next_frame_choice_2 then
        transform_counter_next_frame_choice_4 := transform_counter_next_frame_choice_3;
      else
        transform_counter_next_frame_choice_4 := transform_counter_group_is_equal and
          transform_counter_group_is_equal_2 and in_valid and in_start_of_frame;
      end if;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
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
      if (transform_left_filter_column_4_4 / 128) = 1 then
        transform_left_filter_feature_0_choice_168 := transform_filtering_0_column_inside_4;
      else
        transform_left_filter_feature_0_choice_168 := transform_filtering_0_column_inside_4 and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if transform_left_filter_feature_0_choice_167 then
        transform_left_filter_feature_0_choice_169 := ((transform_left_filter_column_4_4 / 128) = 1) and
          transform_filtering_0_column_inside_4 and (not ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_169 := transform_left_filter_feature_0_choice_168;
      end if;
      if (transform_left_filter_column_4_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_170 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_170 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_171 := transform_left_filter_feature_0_choice_170;
      else
        transform_left_filter_feature_0_choice_171 := ((transform_left_filter_column_4_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_171 then
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_172 then
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_173 then
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_174 then
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_175 then
        transform_left_filter_feature_0_choice_176 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_176 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_176 then
        transform_left_filter_feature_0_choice_177 := ((transform_left_filter_column_4_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_177 := ((transform_left_filter_column_4_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_178 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_178 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_179 := transform_left_filter_feature_0_choice_178;
      else
        transform_left_filter_feature_0_choice_179 := ((transform_left_filter_column_4_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_179 then
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_180 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_180 then
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_181 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_181 then
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_182 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_182 then
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_183 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_183 then
        transform_left_filter_feature_0_choice_184 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_184 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_184 then
        transform_left_filter_feature_0_choice_185 := ((transform_left_filter_column_4_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_185 := ((transform_left_filter_column_4_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_186 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_186 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_187 := transform_left_filter_feature_0_choice_186;
      else
        transform_left_filter_feature_0_choice_187 := ((transform_left_filter_column_4_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_187 then
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_188 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_188 then
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_189 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_189 then
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_190 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_190 then
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_191 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_191 then
        transform_left_filter_feature_0_choice_192 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_192 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_192 then
        transform_left_filter_feature_0_choice_193 := ((transform_left_filter_column_4_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_193 := ((transform_left_filter_column_4_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_194 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_194 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_195 := transform_left_filter_feature_0_choice_194;
      else
        transform_left_filter_feature_0_choice_195 := ((transform_left_filter_column_3_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_195 then
        transform_left_filter_feature_0_choice_196 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_196 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_196 then
        transform_left_filter_feature_0_choice_197 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_197 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_197 then
        transform_left_filter_feature_0_choice_198 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_198 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_198 then
        transform_left_filter_feature_0_choice_199 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_199 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_199 then
        transform_left_filter_feature_0_choice_200 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_200 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_200 then
        transform_left_filter_feature_0_choice_201 := ((transform_left_filter_column_3_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_201 := ((transform_left_filter_column_3_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_202 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_202 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_203 := transform_left_filter_feature_0_choice_202;
      else
        transform_left_filter_feature_0_choice_203 := ((transform_left_filter_column_3_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_203 then
        transform_left_filter_feature_0_choice_204 := (not (((transform_left_filter_column_3_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_204 := (not (((transform_left_filter_column_3_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_204 then
        transform_left_filter_feature_0_choice_205 := (not (((transform_left_filter_column_3_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_205 := (not (((transform_left_filter_column_3_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_205 then
        transform_left_filter_feature_0_choice_206 := (not (((transform_left_filter_column_3_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_206 := (not (((transform_left_filter_column_3_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_206 then
        transform_left_filter_feature_0_choice_207 := (not (((transform_left_filter_column_3_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_207 := (not (((transform_left_filter_column_3_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_207 then
        transform_left_filter_feature_0_choice_208 := (not (((transform_left_filter_column_3_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_208 := (not (((transform_left_filter_column_3_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_208 then
        transform_left_filter_feature_0_choice_209 := ((transform_left_filter_column_3_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_209 := ((transform_left_filter_column_3_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_210 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_210 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_211 := transform_left_filter_feature_0_choice_210;
      else
        transform_left_filter_feature_0_choice_211 := ((transform_left_filter_column_3_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_211 then
        transform_left_filter_feature_0_choice_212 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_212 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_212 then
        transform_left_filter_feature_0_choice_213 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_213 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_213 then
        transform_left_filter_feature_0_choice_214 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_214 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_214 then
        transform_left_filter_feature_0_choice_215 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_215 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_215 then
        transform_left_filter_feature_0_choice_216 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_216 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_216 then
        transform_left_filter_feature_0_choice_217 := ((transform_left_filter_column_3_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_217 := ((transform_left_filter_column_3_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_218 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_218 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_219 := transform_left_filter_feature_0_choice_218;
      else
        transform_left_filter_feature_0_choice_219 := ((transform_left_filter_column_3_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_219 then
        transform_left_filter_feature_0_choice_220 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_220 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_220 then
        transform_left_filter_feature_0_choice_221 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_221 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_221 then
        transform_left_filter_feature_0_choice_222 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_222 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_222 then
        transform_left_filter_feature_0_choice_223 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_223 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_223 then
        transform_left_filter_feature_0_choice_224 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_224 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_224 then
        transform_left_filter_feature_0_choice_225 := ((transform_left_filter_column_3_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_225 := ((transform_left_filter_column_3_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_226 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_226 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_227 := transform_left_filter_feature_0_choice_226;
      else
        transform_left_filter_feature_0_choice_227 := ((transform_left_filter_column_3_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_227 then
        transform_left_filter_feature_0_choice_228 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_228 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_228 then
        transform_left_filter_feature_0_choice_229 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_229 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_229 then
        transform_left_filter_feature_0_choice_230 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_230 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_230 then
        transform_left_filter_feature_0_choice_231 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_231 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_231 then
        transform_left_filter_feature_0_choice_232 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_232 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_232 then
        transform_left_filter_feature_0_choice_233 := ((transform_left_filter_column_3_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_233 := ((transform_left_filter_column_3_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_234 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_234 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_235 := transform_left_filter_feature_0_choice_234;
      else
        transform_left_filter_feature_0_choice_235 := ((transform_left_filter_column_2_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_235 then
        transform_left_filter_feature_0_choice_236 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_236 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_236 then
        transform_left_filter_feature_0_choice_237 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_237 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_237 then
        transform_left_filter_feature_0_choice_238 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_238 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_238 then
        transform_left_filter_feature_0_choice_239 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_239 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_239 then
        transform_left_filter_feature_0_choice_240 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_240 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_240 then
        transform_left_filter_feature_0_choice_241 := ((transform_left_filter_column_2_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_241 := ((transform_left_filter_column_2_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_242 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_242 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_243 := transform_left_filter_feature_0_choice_242;
      else
        transform_left_filter_feature_0_choice_243 := ((transform_left_filter_column_2_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_243 then
        transform_left_filter_feature_0_choice_244 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_244 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_244 then
        transform_left_filter_feature_0_choice_245 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_245 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_245 then
        transform_left_filter_feature_0_choice_246 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_246 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_246 then
        transform_left_filter_feature_0_choice_247 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_247 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_247 then
        transform_left_filter_feature_0_choice_248 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_248 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_248 then
        transform_left_filter_feature_0_choice_249 := ((transform_left_filter_column_2_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_249 := ((transform_left_filter_column_2_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_250 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_250 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_251 := transform_left_filter_feature_0_choice_250;
      else
        transform_left_filter_feature_0_choice_251 := ((transform_left_filter_column_2_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_251 then
        transform_left_filter_feature_0_choice_252 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_252 := (not (((transform_left_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_252 then
        transform_left_filter_feature_0_choice_253 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_253 := (not (((transform_left_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_253 then
        transform_left_filter_feature_0_choice_254 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_254 := (not (((transform_left_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_254 then
        transform_left_filter_feature_0_choice_255 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_255 := (not (((transform_left_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_255 then
        transform_left_filter_feature_0_choice_256 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_256 := (not (((transform_left_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_256 then
        transform_left_filter_feature_0_choice_257 := ((transform_left_filter_column_2_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_257 := ((transform_left_filter_column_2_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_258 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_258 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_259 := transform_left_filter_feature_0_choice_258;
      else
        transform_left_filter_feature_0_choice_259 := ((transform_left_filter_column_2_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_259 then
        transform_left_filter_feature_0_choice_260 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_260 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_260 then
        transform_left_filter_feature_0_choice_261 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_261 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_261 then
        transform_left_filter_feature_0_choice_262 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_262 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_262 then
        transform_left_filter_feature_0_choice_263 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_263 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_263 then
        transform_left_filter_feature_0_choice_264 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_264 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_264 then
        transform_left_filter_feature_0_choice_265 := ((transform_left_filter_column_2_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_265 := ((transform_left_filter_column_2_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_266 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_266 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_267 := transform_left_filter_feature_0_choice_266;
      else
        transform_left_filter_feature_0_choice_267 := ((transform_left_filter_column_2_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_267 then
        transform_left_filter_feature_0_choice_268 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_268 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_268 then
        transform_left_filter_feature_0_choice_269 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_269 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_269 then
        transform_left_filter_feature_0_choice_270 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_270 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_270 then
        transform_left_filter_feature_0_choice_271 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_271 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_271 then
        transform_left_filter_feature_0_choice_272 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_272 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_272 then
        transform_left_filter_feature_0_choice_273 := ((transform_left_filter_column_2_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_273 := ((transform_left_filter_column_2_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_274 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_274 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_275 := transform_left_filter_feature_0_choice_274;
      else
        transform_left_filter_feature_0_choice_275 := ((transform_left_filter_column_1_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_275 then
        transform_left_filter_feature_0_choice_276 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_276 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_276 then
        transform_left_filter_feature_0_choice_277 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_277 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_277 then
        transform_left_filter_feature_0_choice_278 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_278 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_278 then
        transform_left_filter_feature_0_choice_279 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_279 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_279 then
        transform_left_filter_feature_0_choice_280 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_280 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_280 then
        transform_left_filter_feature_0_choice_281 := ((transform_left_filter_column_1_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_281 := ((transform_left_filter_column_1_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_282 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_282 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_283 := transform_left_filter_feature_0_choice_282;
      else
        transform_left_filter_feature_0_choice_283 := ((transform_left_filter_column_1_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_283 then
        transform_left_filter_feature_0_choice_284 := (not (((transform_left_filter_column_1_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_284 := (not (((transform_left_filter_column_1_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_284 then
        transform_left_filter_feature_0_choice_285 := (not (((transform_left_filter_column_1_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_285 := (not (((transform_left_filter_column_1_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_285 then
        transform_left_filter_feature_0_choice_286 := (not (((transform_left_filter_column_1_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_286 := (not (((transform_left_filter_column_1_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_286 then
        transform_left_filter_feature_0_choice_287 := (not (((transform_left_filter_column_1_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_287 := (not (((transform_left_filter_column_1_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_287 then
        transform_left_filter_feature_0_choice_288 := (not (((transform_left_filter_column_1_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_288 := (not (((transform_left_filter_column_1_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_288 then
        transform_left_filter_feature_0_choice_289 := ((transform_left_filter_column_1_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_289 := ((transform_left_filter_column_1_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_290 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_290 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_291 := transform_left_filter_feature_0_choice_290;
      else
        transform_left_filter_feature_0_choice_291 := ((transform_left_filter_column_1_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_291 then
        transform_left_filter_feature_0_choice_292 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_292 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_292 then
        transform_left_filter_feature_0_choice_293 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_293 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_293 then
        transform_left_filter_feature_0_choice_294 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_294 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_294 then
        transform_left_filter_feature_0_choice_295 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_295 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_295 then
        transform_left_filter_feature_0_choice_296 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_296 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_296 then
        transform_left_filter_feature_0_choice_297 := ((transform_left_filter_column_1_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_297 := ((transform_left_filter_column_1_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_298 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_298 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_299 := transform_left_filter_feature_0_choice_298;
      else
        transform_left_filter_feature_0_choice_299 := ((transform_left_filter_column_1_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_299 then
        transform_left_filter_feature_0_choice_300 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_300 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_300 then
        transform_left_filter_feature_0_choice_301 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_301 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_301 then
        transform_left_filter_feature_0_choice_302 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_302 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_302 then
        transform_left_filter_feature_0_choice_303 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_303 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_303 then
        transform_left_filter_feature_0_choice_304 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_304 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_304 then
        transform_left_filter_feature_0_choice_305 := ((transform_left_filter_column_1_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_305 := ((transform_left_filter_column_1_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_306 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_306 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_307 := transform_left_filter_feature_0_choice_306;
      else
        transform_left_filter_feature_0_choice_307 := ((transform_left_filter_column_1_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_307 then
        transform_left_filter_feature_0_choice_308 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_308 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_308 then
        transform_left_filter_feature_0_choice_309 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_309 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_309 then
        transform_left_filter_feature_0_choice_310 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_310 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_310 then
        transform_left_filter_feature_0_choice_311 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_311 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_311 then
        transform_left_filter_feature_0_choice_312 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_312 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_312 then
        transform_left_filter_feature_0_choice_313 := ((transform_left_filter_column_1_0 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_313 := ((transform_left_filter_column_1_0 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_314 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_314 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_315 := transform_left_filter_feature_0_choice_314;
      else
        transform_left_filter_feature_0_choice_315 := ((transform_left_filter_column_0_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_315 then
        transform_left_filter_feature_0_choice_316 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_316 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_316 then
        transform_left_filter_feature_0_choice_317 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_317 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_317 then
        transform_left_filter_feature_0_choice_318 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_318 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_318 then
        transform_left_filter_feature_0_choice_319 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_319 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_319 then
        transform_left_filter_feature_0_choice_320 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_320 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_320 then
        transform_left_filter_feature_0_choice_321 := ((transform_left_filter_column_0_3 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_321 := ((transform_left_filter_column_0_3 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_322 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_322 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_323 := transform_left_filter_feature_0_choice_322;
      else
        transform_left_filter_feature_0_choice_323 := ((transform_left_filter_column_0_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_323 then
        transform_left_filter_feature_0_choice_324 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_324 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_324 then
        transform_left_filter_feature_0_choice_325 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_325 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_325 then
        transform_left_filter_feature_0_choice_326 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_326 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_326 then
        transform_left_filter_feature_0_choice_327 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_327 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_327 then
        transform_left_filter_feature_0_choice_328 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_328 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_328 then
        transform_left_filter_feature_0_choice_329 := ((transform_left_filter_column_0_4 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_329 := ((transform_left_filter_column_0_4 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_330 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_330 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_331 := transform_left_filter_feature_0_choice_330;
      else
        transform_left_filter_feature_0_choice_331 := ((transform_left_filter_column_0_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_331 then
        transform_left_filter_feature_0_choice_332 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_332 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_332 then
        transform_left_filter_feature_0_choice_333 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_333 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_333 then
        transform_left_filter_feature_0_choice_334 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_334 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_334 then
        transform_left_filter_feature_0_choice_335 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_335 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_335 then
        transform_left_filter_feature_0_choice_336 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_336 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_336 then
        transform_left_filter_feature_0_choice_337 := ((transform_left_filter_column_0_2 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_337 := ((transform_left_filter_column_0_2 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_338 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_338 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_339 := transform_left_filter_feature_0_choice_338;
      else
        transform_left_filter_feature_0_choice_339 := ((transform_left_filter_column_0_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_339 then
        transform_left_filter_feature_0_choice_340 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_340 := (not (((transform_left_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_340 then
        transform_left_filter_feature_0_choice_341 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_341 := (not (((transform_left_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_341 then
        transform_left_filter_feature_0_choice_342 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_342 := (not (((transform_left_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_342 then
        transform_left_filter_feature_0_choice_343 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_343 := (not (((transform_left_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_343 then
        transform_left_filter_feature_0_choice_344 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_344 := (not (((transform_left_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_344 then
        transform_left_filter_feature_0_choice_345 := ((transform_left_filter_column_0_1 / 128) = 1) and (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_345 := ((transform_left_filter_column_0_1 / 128) = 1) or (not
          ((transform_left_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_346 := not (((transform_left_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_left_filter_feature_0_choice_346 := (transform_left_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value then
        transform_left_filter_feature_0_choice_347 := ((transform_left_filter_column_4_2 mod 2) = 1) or (not
          (((transform_left_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_left_filter_column_0_0 mod 2) = 1));
      else
        transform_left_filter_feature_0_choice_347 := transform_left_filter_feature_0_choice_346;
      end if;
      transform_left_filter_feature_0_value_7 := ((transform_left_filter_column_0_0 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_347 then
        transform_left_filter_feature_0_choice_348 := (not transform_left_filter_feature_0_value_2) and
          transform_left_filter_feature_0_value_7;
      else
        transform_left_filter_feature_0_choice_348 := (not transform_left_filter_feature_0_value_2) or
          transform_left_filter_feature_0_value_7;
      end if;
      transform_left_filter_feature_0_value_8 := ((transform_left_filter_column_0_0 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_348 then
        transform_left_filter_feature_0_choice_349 := (not transform_left_filter_feature_0_value_3) or
          transform_left_filter_feature_0_value_8;
      else
        transform_left_filter_feature_0_choice_349 := (not transform_left_filter_feature_0_value_3) and
          transform_left_filter_feature_0_value_8;
      end if;
      transform_left_filter_feature_0_value_9 := ((transform_left_filter_column_0_0 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_349 then
        transform_left_filter_feature_0_choice_350 := (not transform_left_filter_feature_0_value_4) or
          transform_left_filter_feature_0_value_9;
      else
        transform_left_filter_feature_0_choice_350 := (not transform_left_filter_feature_0_value_4) and
          transform_left_filter_feature_0_value_9;
      end if;
      transform_left_filter_feature_0_value_10 := ((transform_left_filter_column_0_0 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_350 then
        transform_left_filter_feature_0_choice_351 := (not transform_left_filter_feature_0_value_5) or
          transform_left_filter_feature_0_value_10;
      else
        transform_left_filter_feature_0_choice_351 := (not transform_left_filter_feature_0_value_5) and
          transform_left_filter_feature_0_value_10;
      end if;
      transform_left_filter_feature_0_value_11 := ((transform_left_filter_column_0_0 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_351 then
        transform_left_filter_feature_0_choice_352 := (not transform_left_filter_feature_0_value_6) or
          transform_left_filter_feature_0_value_11;
      else
        transform_left_filter_feature_0_choice_352 := (not transform_left_filter_feature_0_value_6) and
          transform_left_filter_feature_0_value_11;
      end if;
      if transform_left_filter_feature_0_choice_352 then
        transform_left_filter_feature_0_choice_353 := (not ((transform_left_filter_column_4_2 / 128) = 1)) or
          ((transform_left_filter_column_0_0 / 128) = 1);
      else
        transform_left_filter_feature_0_choice_353 := (not ((transform_left_filter_column_4_2 / 128) = 1)) and
          ((transform_left_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_left_filter_feature_0_choice_354 := (as_number(transform_left_filter_feature_0_choice_321) * 8) +
          (as_number(transform_left_filter_feature_0_choice_329) * 16) +
          (as_number(transform_left_filter_feature_0_choice_337) * 4) +
          (as_number(transform_left_filter_feature_0_choice_345) * 2) +
          as_number(transform_left_filter_feature_0_choice_353);
      else
        transform_left_filter_feature_0_choice_354 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_left_filter_feature_0_choice_355 := (as_number(transform_left_filter_feature_0_choice_281) * 256) +
          (as_number(transform_left_filter_feature_0_choice_289) * 512) +
          (as_number(transform_left_filter_feature_0_choice_297) * 128) +
          (as_number(transform_left_filter_feature_0_choice_305) * 64) +
          (as_number(transform_left_filter_feature_0_choice_313) * 32) + transform_left_filter_feature_0_choice_354;
      else
        transform_left_filter_feature_0_choice_355 := transform_left_filter_feature_0_choice_354;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_left_filter_feature_0_choice_356 := (as_number(transform_left_filter_feature_0_choice_241) * 8192) +
          (as_number(transform_left_filter_feature_0_choice_249) * 16384) +
          (as_number(transform_left_filter_feature_0_choice_257) * 4096) +
          (as_number(transform_left_filter_feature_0_choice_265) * 2048) +
          (as_number(transform_left_filter_feature_0_choice_273) * 1024) + transform_left_filter_feature_0_choice_355;
      else
        transform_left_filter_feature_0_choice_356 := transform_left_filter_feature_0_choice_355;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_left_filter_feature_0_choice_357 := (as_number(transform_left_filter_feature_0_choice_201) * 262144)
          + (as_number(transform_left_filter_feature_0_choice_209) * 524288) +
          (as_number(transform_left_filter_feature_0_choice_217) * 131072) +
          (as_number(transform_left_filter_feature_0_choice_225) * 65536) +
          (as_number(transform_left_filter_feature_0_choice_233) * 32768) + transform_left_filter_feature_0_choice_356;
      else
        transform_left_filter_feature_0_choice_357 := transform_left_filter_feature_0_choice_356;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0_choice_358 := (as_number(transform_left_filter_feature_0_choice_177) * 2097152)
          + (as_number(transform_left_filter_feature_0_choice_185) * 4194304) +
          (as_number(transform_left_filter_feature_0_choice_193) * 1048576) +
          transform_left_filter_feature_0_choice_357;
      else
        transform_left_filter_feature_0_choice_358 := transform_left_filter_feature_0_choice_357;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_left_filter_feature_0_choice_359 := (as_number(transform_left_filter_feature_0_choice_128) *
          16777216) + (as_number(transform_left_filter_feature_0_choice_136) * 33554432) +
          (as_number(transform_left_filter_feature_0_choice_144) * 67108864) +
          (as_number(transform_left_filter_feature_0_choice_152) * 134217728) +
          (as_number(transform_left_filter_feature_0_choice_160) * 268435456) +
          (as_number(transform_left_filter_feature_0_choice_169) * 8388608) +
          transform_left_filter_feature_0_choice_358;
      else
        transform_left_filter_feature_0_choice_359 := (as_number(transform_left_filter_feature_0_choice_169) * 8388608)
          + transform_left_filter_feature_0_choice_358;
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_left_filter_feature_0_choice_360 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choice_120), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_112), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_104), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_96), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_88), 1) &
          to_unsigned(transform_left_filter_feature_0_choice_359, 29);
      else
        transform_left_filter_feature_0_choice_360 := to_unsigned(transform_left_filter_feature_0_choice_359, 34);
      end if;
      if transform_filtering_0_column_inside_7 then
        transform_left_filter_feature_0_choice_361 := to_unsigned(as_number(transform_left_filter_feature_0_choice_80),
          1) & to_unsigned(as_number(transform_left_filter_feature_0_choice_72), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_64), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_56), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_48), 1) &
          transform_left_filter_feature_0_choice_360(33 downto 0);
      else
        transform_left_filter_feature_0_choice_361 := resize(transform_left_filter_feature_0_choice_360, 39);
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
      if (transform_right_filter_column_4_4 / 128) = 1 then
        transform_right_filter_feature_0_choice_168 := transform_filtering_0_column_inside_4;
      else
        transform_right_filter_feature_0_choice_168 := transform_filtering_0_column_inside_4 and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if transform_right_filter_feature_0_choice_167 then
        transform_right_filter_feature_0_choice_169 := ((transform_right_filter_column_4_4 / 128) = 1) and
          transform_filtering_0_column_inside_4 and (not ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_169 := transform_right_filter_feature_0_choice_168;
      end if;
      if (transform_right_filter_column_4_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_170 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_170 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_171 := transform_right_filter_feature_0_choice_170;
      else
        transform_right_filter_feature_0_choice_171 := ((transform_right_filter_column_4_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_171 then
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_172 then
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_173 then
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_174 then
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_175 then
        transform_right_filter_feature_0_choice_176 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_176 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_176 then
        transform_right_filter_feature_0_choice_177 := ((transform_right_filter_column_4_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_177 := ((transform_right_filter_column_4_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_178 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_178 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_179 := transform_right_filter_feature_0_choice_178;
      else
        transform_right_filter_feature_0_choice_179 := ((transform_right_filter_column_4_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_179 then
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_180 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_180 then
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_181 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_181 then
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_182 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_182 then
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_183 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_183 then
        transform_right_filter_feature_0_choice_184 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_184 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_184 then
        transform_right_filter_feature_0_choice_185 := ((transform_right_filter_column_4_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_185 := ((transform_right_filter_column_4_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_186 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_186 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_187 := transform_right_filter_feature_0_choice_186;
      else
        transform_right_filter_feature_0_choice_187 := ((transform_right_filter_column_4_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_187 then
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_188 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_188 then
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_189 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_189 then
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_190 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_190 then
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_191 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_191 then
        transform_right_filter_feature_0_choice_192 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_192 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_192 then
        transform_right_filter_feature_0_choice_193 := ((transform_right_filter_column_4_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_193 := ((transform_right_filter_column_4_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_194 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_194 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_195 := transform_right_filter_feature_0_choice_194;
      else
        transform_right_filter_feature_0_choice_195 := ((transform_right_filter_column_3_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_195 then
        transform_right_filter_feature_0_choice_196 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_196 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_196 then
        transform_right_filter_feature_0_choice_197 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_197 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_197 then
        transform_right_filter_feature_0_choice_198 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_198 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_198 then
        transform_right_filter_feature_0_choice_199 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_199 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_199 then
        transform_right_filter_feature_0_choice_200 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_200 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_200 then
        transform_right_filter_feature_0_choice_201 := ((transform_right_filter_column_3_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_201 := ((transform_right_filter_column_3_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_202 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_202 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_203 := transform_right_filter_feature_0_choice_202;
      else
        transform_right_filter_feature_0_choice_203 := ((transform_right_filter_column_3_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_203 then
        transform_right_filter_feature_0_choice_204 := (not (((transform_right_filter_column_3_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_204 := (not (((transform_right_filter_column_3_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_204 then
        transform_right_filter_feature_0_choice_205 := (not (((transform_right_filter_column_3_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_205 := (not (((transform_right_filter_column_3_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_205 then
        transform_right_filter_feature_0_choice_206 := (not (((transform_right_filter_column_3_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_206 := (not (((transform_right_filter_column_3_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_206 then
        transform_right_filter_feature_0_choice_207 := (not (((transform_right_filter_column_3_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_207 := (not (((transform_right_filter_column_3_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_207 then
        transform_right_filter_feature_0_choice_208 := (not (((transform_right_filter_column_3_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_208 := (not (((transform_right_filter_column_3_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_208 then
        transform_right_filter_feature_0_choice_209 := ((transform_right_filter_column_3_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_209 := ((transform_right_filter_column_3_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_210 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_210 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_211 := transform_right_filter_feature_0_choice_210;
      else
        transform_right_filter_feature_0_choice_211 := ((transform_right_filter_column_3_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_211 then
        transform_right_filter_feature_0_choice_212 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_212 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_212 then
        transform_right_filter_feature_0_choice_213 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_213 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_213 then
        transform_right_filter_feature_0_choice_214 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_214 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_214 then
        transform_right_filter_feature_0_choice_215 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_215 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_215 then
        transform_right_filter_feature_0_choice_216 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_216 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_216 then
        transform_right_filter_feature_0_choice_217 := ((transform_right_filter_column_3_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_217 := ((transform_right_filter_column_3_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_218 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_218 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_219 := transform_right_filter_feature_0_choice_218;
      else
        transform_right_filter_feature_0_choice_219 := ((transform_right_filter_column_3_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_219 then
        transform_right_filter_feature_0_choice_220 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_220 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_220 then
        transform_right_filter_feature_0_choice_221 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_221 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_221 then
        transform_right_filter_feature_0_choice_222 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_222 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_222 then
        transform_right_filter_feature_0_choice_223 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_223 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_223 then
        transform_right_filter_feature_0_choice_224 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_224 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_224 then
        transform_right_filter_feature_0_choice_225 := ((transform_right_filter_column_3_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_225 := ((transform_right_filter_column_3_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_226 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_226 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_227 := transform_right_filter_feature_0_choice_226;
      else
        transform_right_filter_feature_0_choice_227 := ((transform_right_filter_column_3_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_227 then
        transform_right_filter_feature_0_choice_228 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_228 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_228 then
        transform_right_filter_feature_0_choice_229 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_229 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_229 then
        transform_right_filter_feature_0_choice_230 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_230 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_230 then
        transform_right_filter_feature_0_choice_231 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_231 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_231 then
        transform_right_filter_feature_0_choice_232 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_232 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_232 then
        transform_right_filter_feature_0_choice_233 := ((transform_right_filter_column_3_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_233 := ((transform_right_filter_column_3_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_234 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_234 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_235 := transform_right_filter_feature_0_choice_234;
      else
        transform_right_filter_feature_0_choice_235 := ((transform_right_filter_column_2_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_235 then
        transform_right_filter_feature_0_choice_236 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_236 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_236 then
        transform_right_filter_feature_0_choice_237 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_237 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_237 then
        transform_right_filter_feature_0_choice_238 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_238 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_238 then
        transform_right_filter_feature_0_choice_239 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_239 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_239 then
        transform_right_filter_feature_0_choice_240 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_240 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_240 then
        transform_right_filter_feature_0_choice_241 := ((transform_right_filter_column_2_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_241 := ((transform_right_filter_column_2_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_242 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_242 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_243 := transform_right_filter_feature_0_choice_242;
      else
        transform_right_filter_feature_0_choice_243 := ((transform_right_filter_column_2_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_243 then
        transform_right_filter_feature_0_choice_244 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_244 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_244 then
        transform_right_filter_feature_0_choice_245 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_245 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_245 then
        transform_right_filter_feature_0_choice_246 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_246 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_246 then
        transform_right_filter_feature_0_choice_247 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_247 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_247 then
        transform_right_filter_feature_0_choice_248 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_248 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_248 then
        transform_right_filter_feature_0_choice_249 := ((transform_right_filter_column_2_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_249 := ((transform_right_filter_column_2_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_250 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_250 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_251 := transform_right_filter_feature_0_choice_250;
      else
        transform_right_filter_feature_0_choice_251 := ((transform_right_filter_column_2_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_251 then
        transform_right_filter_feature_0_choice_252 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_252 := (not (((transform_right_filter_column_2_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_252 then
        transform_right_filter_feature_0_choice_253 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_253 := (not (((transform_right_filter_column_2_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_253 then
        transform_right_filter_feature_0_choice_254 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_254 := (not (((transform_right_filter_column_2_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_254 then
        transform_right_filter_feature_0_choice_255 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_255 := (not (((transform_right_filter_column_2_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_255 then
        transform_right_filter_feature_0_choice_256 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_256 := (not (((transform_right_filter_column_2_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_256 then
        transform_right_filter_feature_0_choice_257 := ((transform_right_filter_column_2_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_257 := ((transform_right_filter_column_2_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_258 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_258 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_259 := transform_right_filter_feature_0_choice_258;
      else
        transform_right_filter_feature_0_choice_259 := ((transform_right_filter_column_2_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_259 then
        transform_right_filter_feature_0_choice_260 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_260 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_260 then
        transform_right_filter_feature_0_choice_261 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_261 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_261 then
        transform_right_filter_feature_0_choice_262 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_262 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_262 then
        transform_right_filter_feature_0_choice_263 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_263 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_263 then
        transform_right_filter_feature_0_choice_264 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_264 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_264 then
        transform_right_filter_feature_0_choice_265 := ((transform_right_filter_column_2_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_265 := ((transform_right_filter_column_2_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_266 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_266 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_267 := transform_right_filter_feature_0_choice_266;
      else
        transform_right_filter_feature_0_choice_267 := ((transform_right_filter_column_2_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_267 then
        transform_right_filter_feature_0_choice_268 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_268 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_268 then
        transform_right_filter_feature_0_choice_269 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_269 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_269 then
        transform_right_filter_feature_0_choice_270 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_270 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_270 then
        transform_right_filter_feature_0_choice_271 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_271 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_271 then
        transform_right_filter_feature_0_choice_272 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_272 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_272 then
        transform_right_filter_feature_0_choice_273 := ((transform_right_filter_column_2_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_273 := ((transform_right_filter_column_2_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_274 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_274 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_275 := transform_right_filter_feature_0_choice_274;
      else
        transform_right_filter_feature_0_choice_275 := ((transform_right_filter_column_1_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_275 then
        transform_right_filter_feature_0_choice_276 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_276 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_276 then
        transform_right_filter_feature_0_choice_277 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_277 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_277 then
        transform_right_filter_feature_0_choice_278 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_278 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_278 then
        transform_right_filter_feature_0_choice_279 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_279 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_279 then
        transform_right_filter_feature_0_choice_280 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_280 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_280 then
        transform_right_filter_feature_0_choice_281 := ((transform_right_filter_column_1_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_281 := ((transform_right_filter_column_1_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_282 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_282 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_283 := transform_right_filter_feature_0_choice_282;
      else
        transform_right_filter_feature_0_choice_283 := ((transform_right_filter_column_1_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_283 then
        transform_right_filter_feature_0_choice_284 := (not (((transform_right_filter_column_1_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_284 := (not (((transform_right_filter_column_1_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_284 then
        transform_right_filter_feature_0_choice_285 := (not (((transform_right_filter_column_1_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_285 := (not (((transform_right_filter_column_1_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_285 then
        transform_right_filter_feature_0_choice_286 := (not (((transform_right_filter_column_1_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_286 := (not (((transform_right_filter_column_1_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_286 then
        transform_right_filter_feature_0_choice_287 := (not (((transform_right_filter_column_1_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_287 := (not (((transform_right_filter_column_1_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_287 then
        transform_right_filter_feature_0_choice_288 := (not (((transform_right_filter_column_1_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_288 := (not (((transform_right_filter_column_1_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_288 then
        transform_right_filter_feature_0_choice_289 := ((transform_right_filter_column_1_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_289 := ((transform_right_filter_column_1_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_290 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_290 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_291 := transform_right_filter_feature_0_choice_290;
      else
        transform_right_filter_feature_0_choice_291 := ((transform_right_filter_column_1_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_291 then
        transform_right_filter_feature_0_choice_292 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_292 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_292 then
        transform_right_filter_feature_0_choice_293 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_293 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_293 then
        transform_right_filter_feature_0_choice_294 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_294 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_294 then
        transform_right_filter_feature_0_choice_295 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_295 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_295 then
        transform_right_filter_feature_0_choice_296 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_296 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_296 then
        transform_right_filter_feature_0_choice_297 := ((transform_right_filter_column_1_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_297 := ((transform_right_filter_column_1_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_298 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_298 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_299 := transform_right_filter_feature_0_choice_298;
      else
        transform_right_filter_feature_0_choice_299 := ((transform_right_filter_column_1_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_299 then
        transform_right_filter_feature_0_choice_300 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_300 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_300 then
        transform_right_filter_feature_0_choice_301 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_301 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_301 then
        transform_right_filter_feature_0_choice_302 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_302 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_302 then
        transform_right_filter_feature_0_choice_303 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_303 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_303 then
        transform_right_filter_feature_0_choice_304 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_304 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_304 then
        transform_right_filter_feature_0_choice_305 := ((transform_right_filter_column_1_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_305 := ((transform_right_filter_column_1_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_306 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_306 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_307 := transform_right_filter_feature_0_choice_306;
      else
        transform_right_filter_feature_0_choice_307 := ((transform_right_filter_column_1_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_307 then
        transform_right_filter_feature_0_choice_308 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_308 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_308 then
        transform_right_filter_feature_0_choice_309 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_309 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_309 then
        transform_right_filter_feature_0_choice_310 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_310 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_310 then
        transform_right_filter_feature_0_choice_311 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_311 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_311 then
        transform_right_filter_feature_0_choice_312 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_312 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_312 then
        transform_right_filter_feature_0_choice_313 := ((transform_right_filter_column_1_0 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_313 := ((transform_right_filter_column_1_0 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_314 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_314 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_315 := transform_right_filter_feature_0_choice_314;
      else
        transform_right_filter_feature_0_choice_315 := ((transform_right_filter_column_0_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_315 then
        transform_right_filter_feature_0_choice_316 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_316 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_316 then
        transform_right_filter_feature_0_choice_317 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_317 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_317 then
        transform_right_filter_feature_0_choice_318 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_318 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_318 then
        transform_right_filter_feature_0_choice_319 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_319 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_319 then
        transform_right_filter_feature_0_choice_320 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_320 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_320 then
        transform_right_filter_feature_0_choice_321 := ((transform_right_filter_column_0_3 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_321 := ((transform_right_filter_column_0_3 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_322 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_322 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_323 := transform_right_filter_feature_0_choice_322;
      else
        transform_right_filter_feature_0_choice_323 := ((transform_right_filter_column_0_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_323 then
        transform_right_filter_feature_0_choice_324 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_324 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_324 then
        transform_right_filter_feature_0_choice_325 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_325 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_325 then
        transform_right_filter_feature_0_choice_326 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_326 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_326 then
        transform_right_filter_feature_0_choice_327 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_327 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_327 then
        transform_right_filter_feature_0_choice_328 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_328 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_328 then
        transform_right_filter_feature_0_choice_329 := ((transform_right_filter_column_0_4 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_329 := ((transform_right_filter_column_0_4 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_330 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_330 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_331 := transform_right_filter_feature_0_choice_330;
      else
        transform_right_filter_feature_0_choice_331 := ((transform_right_filter_column_0_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_331 then
        transform_right_filter_feature_0_choice_332 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_332 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_332 then
        transform_right_filter_feature_0_choice_333 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_333 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_333 then
        transform_right_filter_feature_0_choice_334 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_334 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_334 then
        transform_right_filter_feature_0_choice_335 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_335 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_335 then
        transform_right_filter_feature_0_choice_336 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_336 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_336 then
        transform_right_filter_feature_0_choice_337 := ((transform_right_filter_column_0_2 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_337 := ((transform_right_filter_column_0_2 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_338 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_338 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_339 := transform_right_filter_feature_0_choice_338;
      else
        transform_right_filter_feature_0_choice_339 := ((transform_right_filter_column_0_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_339 then
        transform_right_filter_feature_0_choice_340 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_340 := (not (((transform_right_filter_column_0_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_340 then
        transform_right_filter_feature_0_choice_341 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_341 := (not (((transform_right_filter_column_0_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_341 then
        transform_right_filter_feature_0_choice_342 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_342 := (not (((transform_right_filter_column_0_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_342 then
        transform_right_filter_feature_0_choice_343 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_343 := (not (((transform_right_filter_column_0_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_343 then
        transform_right_filter_feature_0_choice_344 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_344 := (not (((transform_right_filter_column_0_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_344 then
        transform_right_filter_feature_0_choice_345 := ((transform_right_filter_column_0_1 / 128) = 1) and (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_345 := ((transform_right_filter_column_0_1 / 128) = 1) or (not
          ((transform_right_filter_column_4_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_346 := not (((transform_right_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_right_filter_feature_0_choice_346 := (transform_right_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value then
        transform_right_filter_feature_0_choice_347 := ((transform_right_filter_column_4_2 mod 2) = 1) or (not
          (((transform_right_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_right_filter_column_0_0 mod 2) =
          1));
      else
        transform_right_filter_feature_0_choice_347 := transform_right_filter_feature_0_choice_346;
      end if;
      transform_right_filter_feature_0_value_7 := ((transform_right_filter_column_0_0 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_347 then
        transform_right_filter_feature_0_choice_348 := (not transform_right_filter_feature_0_value_2) and
          transform_right_filter_feature_0_value_7;
      else
        transform_right_filter_feature_0_choice_348 := (not transform_right_filter_feature_0_value_2) or
          transform_right_filter_feature_0_value_7;
      end if;
      transform_right_filter_feature_0_value_8 := ((transform_right_filter_column_0_0 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_348 then
        transform_right_filter_feature_0_choice_349 := (not transform_right_filter_feature_0_value_3) or
          transform_right_filter_feature_0_value_8;
      else
        transform_right_filter_feature_0_choice_349 := (not transform_right_filter_feature_0_value_3) and
          transform_right_filter_feature_0_value_8;
      end if;
      transform_right_filter_feature_0_value_9 := ((transform_right_filter_column_0_0 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_349 then
        transform_right_filter_feature_0_choice_350 := (not transform_right_filter_feature_0_value_4) or
          transform_right_filter_feature_0_value_9;
      else
        transform_right_filter_feature_0_choice_350 := (not transform_right_filter_feature_0_value_4) and
          transform_right_filter_feature_0_value_9;
      end if;
      transform_right_filter_feature_0_value_10 := ((transform_right_filter_column_0_0 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_350 then
        transform_right_filter_feature_0_choice_351 := (not transform_right_filter_feature_0_value_5) or
          transform_right_filter_feature_0_value_10;
      else
        transform_right_filter_feature_0_choice_351 := (not transform_right_filter_feature_0_value_5) and
          transform_right_filter_feature_0_value_10;
      end if;
      transform_right_filter_feature_0_value_11 := ((transform_right_filter_column_0_0 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_351 then
        transform_right_filter_feature_0_choice_352 := (not transform_right_filter_feature_0_value_6) or
          transform_right_filter_feature_0_value_11;
      else
        transform_right_filter_feature_0_choice_352 := (not transform_right_filter_feature_0_value_6) and
          transform_right_filter_feature_0_value_11;
      end if;
      if transform_right_filter_feature_0_choice_352 then
        transform_right_filter_feature_0_choice_353 := (not ((transform_right_filter_column_4_2 / 128) = 1)) or
          ((transform_right_filter_column_0_0 / 128) = 1);
      else
        transform_right_filter_feature_0_choice_353 := (not ((transform_right_filter_column_4_2 / 128) = 1)) and
          ((transform_right_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_right_filter_feature_0_choice_354 := (as_number(transform_right_filter_feature_0_choice_321) * 8) +
          (as_number(transform_right_filter_feature_0_choice_329) * 16) +
          (as_number(transform_right_filter_feature_0_choice_337) * 4) +
          (as_number(transform_right_filter_feature_0_choice_345) * 2) +
          as_number(transform_right_filter_feature_0_choice_353);
      else
        transform_right_filter_feature_0_choice_354 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_right_filter_feature_0_choice_355 := (as_number(transform_right_filter_feature_0_choice_281) * 256) +
          (as_number(transform_right_filter_feature_0_choice_289) * 512) +
          (as_number(transform_right_filter_feature_0_choice_297) * 128) +
          (as_number(transform_right_filter_feature_0_choice_305) * 64) +
          (as_number(transform_right_filter_feature_0_choice_313) * 32) + transform_right_filter_feature_0_choice_354;
      else
        transform_right_filter_feature_0_choice_355 := transform_right_filter_feature_0_choice_354;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_right_filter_feature_0_choice_356 := (as_number(transform_right_filter_feature_0_choice_241) * 8192)
          + (as_number(transform_right_filter_feature_0_choice_249) * 16384) +
          (as_number(transform_right_filter_feature_0_choice_257) * 4096) +
          (as_number(transform_right_filter_feature_0_choice_265) * 2048) +
          (as_number(transform_right_filter_feature_0_choice_273) * 1024) + transform_right_filter_feature_0_choice_355;
      else
        transform_right_filter_feature_0_choice_356 := transform_right_filter_feature_0_choice_355;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_right_filter_feature_0_choice_357 := (as_number(transform_right_filter_feature_0_choice_201) *
          262144) + (as_number(transform_right_filter_feature_0_choice_209) * 524288) +
          (as_number(transform_right_filter_feature_0_choice_217) * 131072) +
          (as_number(transform_right_filter_feature_0_choice_225) * 65536) +
          (as_number(transform_right_filter_feature_0_choice_233) * 32768) +
          transform_right_filter_feature_0_choice_356;
      else
        transform_right_filter_feature_0_choice_357 := transform_right_filter_feature_0_choice_356;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_0_choice_358 := (as_number(transform_right_filter_feature_0_choice_177) *
          2097152) + (as_number(transform_right_filter_feature_0_choice_185) * 4194304) +
          (as_number(transform_right_filter_feature_0_choice_193) * 1048576) +
          transform_right_filter_feature_0_choice_357;
      else
        transform_right_filter_feature_0_choice_358 := transform_right_filter_feature_0_choice_357;
      end if;
      if transform_filtering_0_column_inside_5 then
        transform_right_filter_feature_0_choice_359 := (as_number(transform_right_filter_feature_0_choice_128) *
          16777216) + (as_number(transform_right_filter_feature_0_choice_136) * 33554432) +
          (as_number(transform_right_filter_feature_0_choice_144) * 67108864) +
          (as_number(transform_right_filter_feature_0_choice_152) * 134217728) +
          (as_number(transform_right_filter_feature_0_choice_160) * 268435456) +
          (as_number(transform_right_filter_feature_0_choice_169) * 8388608) +
          transform_right_filter_feature_0_choice_358;
      else
        transform_right_filter_feature_0_choice_359 := (as_number(transform_right_filter_feature_0_choice_169) *
          8388608) + transform_right_filter_feature_0_choice_358;
      end if;
      if transform_filtering_0_column_inside_6 then
        transform_right_filter_feature_0_choice_360 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_120), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_112), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_104), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_96), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_88), 1) &
          to_unsigned(transform_right_filter_feature_0_choice_359, 29);
      else
        transform_right_filter_feature_0_choice_360 := to_unsigned(transform_right_filter_feature_0_choice_359, 34);
      end if;
      if transform_filtering_0_column_inside_7 then
        transform_right_filter_feature_0_choice_361 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choice_80), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_72), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_64), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_56), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_48), 1) &
          transform_right_filter_feature_0_choice_360(33 downto 0);
      else
        transform_right_filter_feature_0_choice_361 := resize(transform_right_filter_feature_0_choice_360, 39);
      end if;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_counter_next_frame <= transform_counter_next_frame_choice_4 or ((not in_valid) and
        transform_counter_next_frame);
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
        (transform_counter_group mod 4)) < 480;
      transform_read_row_inside_1 <= (transform_counter_group >= 3) and (transform_counter_group < 483);
      transform_read_row_inside_2 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 480;
      transform_read_row_inside_3 <= (transform_counter_group >= 1) and (transform_counter_group < 481);
      transform_read_row_inside_4 <= transform_counter_group < 480;
      transform_read_column_inside_0 <= transform_read_column_inside_0_is_less;
      transform_read_column_inside_1 <= (transform_counter_column = 0) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_2 <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_3 <= transform_counter_column /= 3;
      transform_read_column_inside_4 <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_5 <= (transform_counter_column < 5) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_6 <= (transform_counter_column < 6) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_7 <= (transform_counter_column < 7) /= transform_read_column_inside_0_is_less;
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
        transform_counter_group <= transform_counter_group_choice * 32;
      else
        transform_counter_group <= transform_counter_group_choice_3;
      end if;
      if transform_filtering_0_column_inside_8 then
        transform_left_filter_feature_0 <= to_unsigned(as_number(transform_left_filter_feature_0_choice_40), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_32), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_24), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_16), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choice_8), 1) &
          transform_left_filter_feature_0_choice_361(38 downto 0);
        transform_right_filter_feature_0 <= to_unsigned(as_number(transform_right_filter_feature_0_choice_40), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_32), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_24), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_16), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choice_8), 1) &
          transform_right_filter_feature_0_choice_361(38 downto 0);
      else
        transform_left_filter_feature_0 <= resize(transform_left_filter_feature_0_choice_361, 44);
        transform_right_filter_feature_0 <= resize(transform_right_filter_feature_0_choice_361, 44);
      end if;
      if in_valid then
        if in_start_of_frame or transform_counter_group_is_equal_2 then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 1024;
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
      raster_place_group_is_equal := raster_place_column = 639;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_1_valid;
      if transform_filtering_1_valid and transform_filtering_1_start_of_frame then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 480) and
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
      delay_tag_first_cost_is_equal := raster_place_column = 127;
      delay_tag_map_column_is_not_less := raster_place_column >= 127;
      delay_tag_map_column_is_less := raster_place_column < 640;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_tag_valid <= raster_features_valid;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= (raster_place_group < 480) and delay_tag_map_column_is_not_less and
        delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= (raster_place_group = 0) and delay_tag_first_cost_is_equal;
      delay_tag_end_of_line <= raster_place_group_is_equal;
      -- rows
      rows_search_0 <= delay_delayed_0;
      rows_reference_0 <= delay_ahead_0;
      rows_tag_valid <= delay_tag_valid;
      rows_tag_first_cost <= delay_tag_first_cost;
      rows_tag_map_column <= delay_tag_map_column;
      rows_tag_output_column <= delay_tag_output_column;
      rows_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_tag_end_of_line <= delay_tag_end_of_line;
      -- line
      if rows_tag_valid then
        line_centre_map_column_0 <= rows_tag_map_column;
        line_centre_first_column_0 <= rows_tag_first_cost;
        line_centre_start_of_frame_0 <= rows_tag_start_of_frame;
      end if;
      line_order_falls_any := (not rows_tag_map_column) or line_centre_map_column_0 or (not rows_tag_valid);
      line_order_falls_all := rows_tag_map_column and (not line_centre_map_column_0) and rows_tag_valid;
      line_order_complete_any := (not rows_tag_map_column) or (not rows_tag_valid);
      if line_order_falls_all then
        line_order_turned_output_column_choice := line_order_output and line_order_complete;
      else
        line_order_turned_output_column_choice := line_order_held_output;
      end if;
      line_centre_end_of_line_0 <= rows_tag_end_of_line;
      line_order_inside <= rows_tag_map_column;
      line_order_turned_valid <= rows_tag_valid;
      line_order_turned_output_column <= line_order_turned_output_column_choice and rows_tag_map_column;
      line_order_turned_start_of_frame <= rows_tag_map_column and (not line_centre_map_column_0) and rows_tag_valid and
        line_order_first and line_order_output and line_order_complete;
      line_comes_1 <= line_order_turned_valid;
      line_comes_2 <= line_comes_1;
      line_comes_3 <= line_comes_2;
      line_comes_4 <= line_comes_3;
      line_comes_5 <= line_comes_4;
      line_comes_6 <= line_comes_5;
      line_comes_7 <= line_comes_6;
      line_comes_8 <= line_comes_7;
      line_comes_9 <= line_comes_8;
      line_comes_10 <= line_comes_9;
      line_comes_11 <= line_comes_10;
      line_comes_12 <= line_comes_11;
      line_comes_13 <= line_comes_12;
      line_comes_14 <= line_comes_13;
      line_comes_15 <= line_comes_14;
      line_comes_16 <= line_comes_15;
      line_comes_17 <= line_comes_16;
      line_comes_18 <= line_comes_17;
      line_comes_19 <= line_comes_18;
      line_comes_20 <= line_comes_19;
      line_comes_21 <= line_comes_20;
      line_comes_22 <= line_comes_21;
      line_comes_23 <= line_comes_22;
      line_comes_24 <= line_comes_23;
      line_comes_25 <= line_comes_24;
      line_comes_26 <= line_comes_25;
      line_comes_27 <= line_comes_26;
      line_comes_28 <= line_comes_27;
      line_comes_29 <= line_comes_28;
      line_comes_30 <= line_comes_29;
      line_comes_31 <= line_comes_30;
      line_comes_32 <= line_comes_31;
      line_comes_33 <= line_comes_32;
      line_comes_34 <= line_comes_33;
      line_comes_35 <= line_comes_34;
      line_comes_36 <= line_comes_35;
      line_comes_37 <= line_comes_36;
      line_comes_38 <= line_comes_37;
      line_comes_39 <= line_comes_38;
      line_comes_40 <= line_comes_39;
      line_comes_41 <= line_comes_40;
      line_comes_42 <= line_comes_41;
      line_comes_43 <= line_comes_42;
      line_comes_44 <= line_comes_43;
      line_comes_45 <= line_comes_44;
      line_comes_46 <= line_comes_45;
      line_comes_47 <= line_comes_46;
      line_starts_phases_1 <= line_order_turned_valid and line_centre_map_column_0;
      line_starts_phases_2 <= line_starts_phases_1;
      line_starts_phases_3 <= line_starts_phases_2;
      line_starts_phases_4 <= line_starts_phases_3;
      line_starts_phases_5 <= line_starts_phases_4;
      line_starts_phases_6 <= line_starts_phases_5;
      line_starts_phases_7 <= line_starts_phases_6;
      line_starts_phases_8 <= line_starts_phases_7;
      line_starts_phases_9 <= line_starts_phases_8;
      line_starts_phases_10 <= line_starts_phases_9;
      line_starts_phases_11 <= line_starts_phases_10;
      line_starts_phases_12 <= line_starts_phases_11;
      line_starts_phases_13 <= line_starts_phases_12;
      line_starts_phases_14 <= line_starts_phases_13;
      line_starts_phases_15 <= line_starts_phases_14;
      line_starts_phases_16 <= line_starts_phases_15;
      line_starts_phases_17 <= line_starts_phases_16;
      line_starts_phases_18 <= line_starts_phases_17;
      line_starts_phases_19 <= line_starts_phases_18;
      line_starts_phases_20 <= line_starts_phases_19;
      line_starts_phases_21 <= line_starts_phases_20;
      line_starts_phases_22 <= line_starts_phases_21;
      line_starts_phases_23 <= line_starts_phases_22;
      line_starts_phases_24 <= line_starts_phases_23;
      line_starts_phases_25 <= line_starts_phases_24;
      line_starts_phases_26 <= pathsleft_read_count_phase = 0;
      line_starts_phases_27 <= pathsleft_is_first;
      line_starts_phases_28 <= line_starts_phases_27;
      line_starts_phases_29 <= line_starts_phases_28;
      line_starts_phases_30 <= line_starts_phases_29;
      line_starts_phases_31 <= line_starts_phases_30;
      line_starts_phases_32 <= line_starts_phases_31;
      line_starts_phases_33 <= line_starts_phases_32;
      line_starts_phases_34 <= line_starts_phases_33;
      line_starts_phases_35 <= line_starts_phases_34;
      line_starts_phases_36 <= line_starts_phases_35;
      line_starts_phases_37 <= line_starts_phases_36;
      line_starts_phases_38 <= line_starts_phases_37;
      line_starts_phases_39 <= line_starts_phases_38;
      line_starts_phases_40 <= line_starts_phases_39;
      line_starts_phases_41 <= line_starts_phases_40;
      line_starts_phases_42 <= line_starts_phases_41;
      line_starts_phases_43 <= line_starts_phases_42;
      line_starts_phases_44 <= line_starts_phases_43;
      line_starts_phases_45 <= line_starts_phases_44;
      line_starts_phases_46 <= line_starts_phases_45;
      line_starts_phases_47 <= line_starts_phases_46;
      if line_order_falls then
        line_order_falls <= line_order_falls_any;
      else
        line_order_falls <= line_order_falls_all;
      end if;
      if rows_tag_end_of_line then
        line_order_complete <= line_order_complete or (rows_tag_map_column and rows_tag_valid);
      else
        line_order_complete <= line_order_complete and line_order_complete_any;
      end if;
      if line_order_falls then
        line_order_address_choice := 1023;
      else
        line_order_address_choice := 1;
      end if;
      if not line_order_complete_any then
        if line_order_falls_any then
          line_order_address <= (line_order_address_choice + line_order_address) mod 1024;
        else
          line_order_address <= as_number((not line_order_falls)) * 512;
        end if;
      end if;
      if line_order_falls_all then
        line_order_output <= rows_tag_output_column;
        line_order_first <= rows_tag_start_of_frame;
        line_order_held_output <= line_order_output and line_order_complete;
      end if;
      if line_order_turned_valid then
        line_places_0_map_column <= line_order_inside;
        line_places_0_first_column <= line_centre_first_column_0;
        line_places_0_top <= line_centre_start_of_frame_0;
        line_places_0_address <= line_order_address;
        line_places_0_shown_output_column <= line_order_turned_output_column;
        line_places_0_shown_start_of_frame <= line_order_turned_start_of_frame;
        line_places_0_shown_end_of_line <= line_centre_end_of_line_0;
      end if;
      if line_comes_16 then
        line_places_1_map_column <= line_places_0_map_column;
        line_places_1_first_column <= line_places_0_first_column;
        line_places_1_address <= line_places_0_address;
        line_places_1_shown_output_column <= line_places_0_shown_output_column;
        line_places_1_shown_start_of_frame <= line_places_0_shown_start_of_frame;
        line_places_1_shown_end_of_line <= line_places_0_shown_end_of_line;
      end if;
      if line_comes_32 then
        line_places_2_map_column <= line_places_1_map_column;
        line_places_2_shown_output_column <= line_places_1_shown_output_column;
        line_places_2_shown_start_of_frame <= line_places_1_shown_start_of_frame;
        line_places_2_shown_end_of_line <= line_places_1_shown_end_of_line;
      end if;
      -- costsshift
      if rows_tag_valid then
        costsshift_newest_0 <= rows_search_0;
        costsshift_new_reference_0 <= rows_reference_0;
      end if;
      if costsshift_count_phase = 15 then
        costsshift_count_phase_choice := 15;
      else
        costsshift_count_phase_choice := (costsshift_count_phase + 1) mod 16;
      end if;
      costsshift_new_tag_valid <= (costsshift_count_phase /= 15) or rows_tag_valid;
      costsshift_handed_on_0 <= costsshift_read_words_7;
      costsshift_read_reference_0 <= costsshift_new_reference_0;
      costsshift_read_tag_valid <= costsshift_new_tag_valid;
      costsshift_read_count_phase <= costsshift_count_phase;
      costsshift_reference_0 <= costsshift_read_reference_0;
      costsshift_write_phase <= costsshift_read_count_phase;
      if rows_tag_valid then
        costsshift_count_phase <= 0;
      else
        costsshift_count_phase <= costsshift_count_phase_choice;
      end if;
      if costsshift_read_tag_valid then
        costsshift_search_0_1 <= costsshift_read_words_0;
        costsshift_search_0_2 <= costsshift_read_words_1;
        costsshift_search_0_3 <= costsshift_read_words_2;
        costsshift_search_0_4 <= costsshift_read_words_3;
        costsshift_search_0_5 <= costsshift_read_words_4;
        costsshift_search_0_6 <= costsshift_read_words_5;
        costsshift_search_0_7 <= costsshift_read_words_6;
        if costsshift_read_count_phase = 0 then
          costsshift_search_0_0 <= costsshift_newest_0;
        else
          costsshift_search_0_0 <= costsshift_handed_on_0;
        end if;
      end if;
      -- costswindow
      costswindow_first_0_count_0_value := to_integer(costsshift_reference_0(2 downto 2)) = 1;
      costswindow_first_0_count_0_value_2 := to_integer(costsshift_reference_0(1 downto 1)) = 1;
      costswindow_first_0_count_1_value := to_integer(costsshift_reference_0(3 downto 3)) = 1;
      costswindow_first_0_count_1_value_2 := to_integer(costsshift_reference_0(4 downto 4)) = 1;
      costswindow_first_0_count_1_value_3 := to_integer(costsshift_reference_0(5 downto 5)) = 1;
      costswindow_first_0_count_2_value := to_integer(costsshift_reference_0(6 downto 6)) = 1;
      costswindow_first_0_count_2_value_2 := to_integer(costsshift_reference_0(7 downto 7)) = 1;
      costswindow_first_0_count_2_value_3 := to_integer(costsshift_reference_0(8 downto 8)) = 1;
      costswindow_first_0_count_3_value := to_integer(costsshift_reference_0(9 downto 9)) = 1;
      costswindow_first_0_count_3_value_2 := to_integer(costsshift_reference_0(10 downto 10)) = 1;
      costswindow_first_0_count_3_value_3 := to_integer(costsshift_reference_0(11 downto 11)) = 1;
      costswindow_first_0_count_4_value := to_integer(costsshift_reference_0(12 downto 12)) = 1;
      costswindow_first_0_count_4_value_2 := to_integer(costsshift_reference_0(13 downto 13)) = 1;
      costswindow_first_0_count_4_value_3 := to_integer(costsshift_reference_0(14 downto 14)) = 1;
      costswindow_first_0_count_5_value := to_integer(costsshift_reference_0(15 downto 15)) = 1;
      costswindow_first_0_count_5_value_2 := to_integer(costsshift_reference_0(16 downto 16)) = 1;
      costswindow_first_0_count_5_value_3 := to_integer(costsshift_reference_0(17 downto 17)) = 1;
      costswindow_first_0_count_6_value := to_integer(costsshift_reference_0(18 downto 18)) = 1;
      costswindow_first_0_count_6_value_2 := to_integer(costsshift_reference_0(19 downto 19)) = 1;
      costswindow_first_0_count_6_value_3 := to_integer(costsshift_reference_0(20 downto 20)) = 1;
      costswindow_first_0_count_7_value := to_integer(costsshift_reference_0(21 downto 21)) = 1;
      costswindow_first_0_count_7_value_2 := to_integer(costsshift_reference_0(22 downto 22)) = 1;
      costswindow_first_0_count_7_value_3 := to_integer(costsshift_reference_0(23 downto 23)) = 1;
      costswindow_first_0_count_8_value := to_integer(costsshift_reference_0(24 downto 24)) = 1;
      costswindow_first_0_count_8_value_2 := to_integer(costsshift_reference_0(26 downto 26)) = 1;
      costswindow_first_0_count_8_value_3 := to_integer(costsshift_reference_0(25 downto 25)) = 1;
      costswindow_first_0_count_9_value := to_integer(costsshift_reference_0(27 downto 27)) = 1;
      costswindow_first_0_count_9_value_2 := to_integer(costsshift_reference_0(28 downto 28)) = 1;
      costswindow_first_0_count_9_value_3 := to_integer(costsshift_reference_0(29 downto 29)) = 1;
      costswindow_first_0_count_10_value := to_integer(costsshift_reference_0(30 downto 30)) = 1;
      costswindow_first_0_count_10_value_2 := to_integer(costsshift_reference_0(31 downto 31)) = 1;
      costswindow_first_0_count_10_value_3 := to_integer(costsshift_reference_0(32 downto 32)) = 1;
      costswindow_first_0_count_11_value := to_integer(costsshift_reference_0(33 downto 33)) = 1;
      costswindow_first_0_count_11_value_2 := to_integer(costsshift_reference_0(34 downto 34)) = 1;
      costswindow_first_0_count_11_value_3 := to_integer(costsshift_reference_0(35 downto 35)) = 1;
      costswindow_first_0_count_12_value := to_integer(costsshift_reference_0(36 downto 36)) = 1;
      costswindow_first_0_count_12_value_2 := to_integer(costsshift_reference_0(37 downto 37)) = 1;
      costswindow_first_0_count_12_value_3 := to_integer(costsshift_reference_0(38 downto 38)) = 1;
      costswindow_first_0_count_13_value := to_integer(costsshift_reference_0(39 downto 39)) = 1;
      costswindow_first_0_count_13_value_2 := to_integer(costsshift_reference_0(40 downto 40)) = 1;
      costswindow_first_0_count_13_value_3 := to_integer(costsshift_reference_0(41 downto 41)) = 1;
      costswindow_first_0_count_14_value := to_integer(costsshift_reference_0(42 downto 42)) = 1;
      costswindow_first_0_count_0 <= as_number(((to_integer(costsshift_reference_0(0 downto 0)) = 1) /=
        (to_integer(costsshift_search_0_0(0 downto 0)) = 1))) + as_number((costswindow_first_0_count_0_value /=
        (to_integer(costsshift_search_0_0(2 downto 2)) = 1))) + as_number((costswindow_first_0_count_0_value_2 /=
        (to_integer(costsshift_search_0_0(1 downto 1)) = 1)));
      costswindow_first_0_count_1 <= as_number((costswindow_first_0_count_1_value /=
        (to_integer(costsshift_search_0_0(3 downto 3)) = 1))) + as_number((costswindow_first_0_count_1_value_2 /=
        (to_integer(costsshift_search_0_0(4 downto 4)) = 1))) + as_number((costswindow_first_0_count_1_value_3 /=
        (to_integer(costsshift_search_0_0(5 downto 5)) = 1)));
      costswindow_first_0_count_2 <= as_number((costswindow_first_0_count_2_value /=
        (to_integer(costsshift_search_0_0(6 downto 6)) = 1))) + as_number((costswindow_first_0_count_2_value_2 /=
        (to_integer(costsshift_search_0_0(7 downto 7)) = 1))) + as_number((costswindow_first_0_count_2_value_3 /=
        (to_integer(costsshift_search_0_0(8 downto 8)) = 1)));
      costswindow_first_0_count_3 <= as_number((costswindow_first_0_count_3_value /=
        (to_integer(costsshift_search_0_0(9 downto 9)) = 1))) + as_number((costswindow_first_0_count_3_value_2 /=
        (to_integer(costsshift_search_0_0(10 downto 10)) = 1))) + as_number((costswindow_first_0_count_3_value_3 /=
        (to_integer(costsshift_search_0_0(11 downto 11)) = 1)));
      costswindow_first_0_count_4 <= as_number((costswindow_first_0_count_4_value /=
        (to_integer(costsshift_search_0_0(12 downto 12)) = 1))) + as_number((costswindow_first_0_count_4_value_2 /=
        (to_integer(costsshift_search_0_0(13 downto 13)) = 1))) + as_number((costswindow_first_0_count_4_value_3 /=
        (to_integer(costsshift_search_0_0(14 downto 14)) = 1)));
      costswindow_first_0_count_5 <= as_number((costswindow_first_0_count_5_value /=
        (to_integer(costsshift_search_0_0(15 downto 15)) = 1))) + as_number((costswindow_first_0_count_5_value_2 /=
        (to_integer(costsshift_search_0_0(16 downto 16)) = 1))) + as_number((costswindow_first_0_count_5_value_3 /=
        (to_integer(costsshift_search_0_0(17 downto 17)) = 1)));
      costswindow_first_0_count_6 <= as_number((costswindow_first_0_count_6_value /=
        (to_integer(costsshift_search_0_0(18 downto 18)) = 1))) + as_number((costswindow_first_0_count_6_value_2 /=
        (to_integer(costsshift_search_0_0(19 downto 19)) = 1))) + as_number((costswindow_first_0_count_6_value_3 /=
        (to_integer(costsshift_search_0_0(20 downto 20)) = 1)));
      costswindow_first_0_count_7 <= as_number((costswindow_first_0_count_7_value /=
        (to_integer(costsshift_search_0_0(21 downto 21)) = 1))) + as_number((costswindow_first_0_count_7_value_2 /=
        (to_integer(costsshift_search_0_0(22 downto 22)) = 1))) + as_number((costswindow_first_0_count_7_value_3 /=
        (to_integer(costsshift_search_0_0(23 downto 23)) = 1)));
      costswindow_first_0_count_8 <= as_number((costswindow_first_0_count_8_value /=
        (to_integer(costsshift_search_0_0(24 downto 24)) = 1))) + as_number((costswindow_first_0_count_8_value_2 /=
        (to_integer(costsshift_search_0_0(26 downto 26)) = 1))) + as_number((costswindow_first_0_count_8_value_3 /=
        (to_integer(costsshift_search_0_0(25 downto 25)) = 1)));
      costswindow_first_0_count_9 <= as_number((costswindow_first_0_count_9_value /=
        (to_integer(costsshift_search_0_0(27 downto 27)) = 1))) + as_number((costswindow_first_0_count_9_value_2 /=
        (to_integer(costsshift_search_0_0(28 downto 28)) = 1))) + as_number((costswindow_first_0_count_9_value_3 /=
        (to_integer(costsshift_search_0_0(29 downto 29)) = 1)));
      costswindow_first_0_count_10 <= as_number((costswindow_first_0_count_10_value /=
        (to_integer(costsshift_search_0_0(30 downto 30)) = 1))) + as_number((costswindow_first_0_count_10_value_2 /=
        (to_integer(costsshift_search_0_0(31 downto 31)) = 1))) + as_number((costswindow_first_0_count_10_value_3 /=
        (to_integer(costsshift_search_0_0(32 downto 32)) = 1)));
      costswindow_first_0_count_11 <= as_number((costswindow_first_0_count_11_value /=
        (to_integer(costsshift_search_0_0(33 downto 33)) = 1))) + as_number((costswindow_first_0_count_11_value_2 /=
        (to_integer(costsshift_search_0_0(34 downto 34)) = 1))) + as_number((costswindow_first_0_count_11_value_3 /=
        (to_integer(costsshift_search_0_0(35 downto 35)) = 1)));
      costswindow_first_0_count_12 <= as_number((costswindow_first_0_count_12_value /=
        (to_integer(costsshift_search_0_0(36 downto 36)) = 1))) + as_number((costswindow_first_0_count_12_value_2 /=
        (to_integer(costsshift_search_0_0(37 downto 37)) = 1))) + as_number((costswindow_first_0_count_12_value_3 /=
        (to_integer(costsshift_search_0_0(38 downto 38)) = 1)));
      costswindow_first_0_count_13 <= as_number((costswindow_first_0_count_13_value /=
        (to_integer(costsshift_search_0_0(39 downto 39)) = 1))) + as_number((costswindow_first_0_count_13_value_2 /=
        (to_integer(costsshift_search_0_0(40 downto 40)) = 1))) + as_number((costswindow_first_0_count_13_value_3 /=
        (to_integer(costsshift_search_0_0(41 downto 41)) = 1)));
      costswindow_first_0_count_14 <= as_number(((to_integer(costsshift_reference_0(43 downto 43)) = 1) /=
        (to_integer(costsshift_search_0_0(43 downto 43)) = 1))) + as_number((costswindow_first_0_count_14_value /=
        (to_integer(costsshift_search_0_0(42 downto 42)) = 1)));
      costswindow_first_1_count_0 <= as_number(((to_integer(costsshift_search_0_1(0 downto 0)) = 1) /=
        (to_integer(costsshift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(costsshift_search_0_1(2 downto
        2)) = 1) /= costswindow_first_0_count_0_value)) + as_number(((to_integer(costsshift_search_0_1(1 downto 1)) =
        1) /= costswindow_first_0_count_0_value_2));
      costswindow_first_1_count_1 <= as_number(((to_integer(costsshift_search_0_1(3 downto 3)) = 1) /=
        costswindow_first_0_count_1_value)) + as_number(((to_integer(costsshift_search_0_1(4 downto 4)) = 1) /=
        costswindow_first_0_count_1_value_2)) + as_number(((to_integer(costsshift_search_0_1(5 downto 5)) = 1) /=
        costswindow_first_0_count_1_value_3));
      costswindow_first_1_count_2 <= as_number(((to_integer(costsshift_search_0_1(6 downto 6)) = 1) /=
        costswindow_first_0_count_2_value)) + as_number(((to_integer(costsshift_search_0_1(7 downto 7)) = 1) /=
        costswindow_first_0_count_2_value_2)) + as_number(((to_integer(costsshift_search_0_1(8 downto 8)) = 1) /=
        costswindow_first_0_count_2_value_3));
      costswindow_first_1_count_3 <= as_number(((to_integer(costsshift_search_0_1(9 downto 9)) = 1) /=
        costswindow_first_0_count_3_value)) + as_number(((to_integer(costsshift_search_0_1(10 downto 10)) = 1) /=
        costswindow_first_0_count_3_value_2)) + as_number(((to_integer(costsshift_search_0_1(11 downto 11)) = 1) /=
        costswindow_first_0_count_3_value_3));
      costswindow_first_1_count_4 <= as_number(((to_integer(costsshift_search_0_1(12 downto 12)) = 1) /=
        costswindow_first_0_count_4_value)) + as_number(((to_integer(costsshift_search_0_1(13 downto 13)) = 1) /=
        costswindow_first_0_count_4_value_2)) + as_number(((to_integer(costsshift_search_0_1(14 downto 14)) = 1) /=
        costswindow_first_0_count_4_value_3));
      costswindow_first_1_count_5 <= as_number(((to_integer(costsshift_search_0_1(15 downto 15)) = 1) /=
        costswindow_first_0_count_5_value)) + as_number(((to_integer(costsshift_search_0_1(16 downto 16)) = 1) /=
        costswindow_first_0_count_5_value_2)) + as_number(((to_integer(costsshift_search_0_1(17 downto 17)) = 1) /=
        costswindow_first_0_count_5_value_3));
      costswindow_first_1_count_6 <= as_number(((to_integer(costsshift_search_0_1(18 downto 18)) = 1) /=
        costswindow_first_0_count_6_value)) + as_number(((to_integer(costsshift_search_0_1(19 downto 19)) = 1) /=
        costswindow_first_0_count_6_value_2)) + as_number(((to_integer(costsshift_search_0_1(20 downto 20)) = 1) /=
        costswindow_first_0_count_6_value_3));
      costswindow_first_1_count_7 <= as_number(((to_integer(costsshift_search_0_1(21 downto 21)) = 1) /=
        costswindow_first_0_count_7_value)) + as_number(((to_integer(costsshift_search_0_1(22 downto 22)) = 1) /=
        costswindow_first_0_count_7_value_2)) + as_number(((to_integer(costsshift_search_0_1(23 downto 23)) = 1) /=
        costswindow_first_0_count_7_value_3));
      costswindow_first_1_count_8 <= as_number(((to_integer(costsshift_search_0_1(24 downto 24)) = 1) /=
        costswindow_first_0_count_8_value)) + as_number(((to_integer(costsshift_search_0_1(26 downto 26)) = 1) /=
        costswindow_first_0_count_8_value_2)) + as_number(((to_integer(costsshift_search_0_1(25 downto 25)) = 1) /=
        costswindow_first_0_count_8_value_3));
      costswindow_first_1_count_9 <= as_number(((to_integer(costsshift_search_0_1(27 downto 27)) = 1) /=
        costswindow_first_0_count_9_value)) + as_number(((to_integer(costsshift_search_0_1(28 downto 28)) = 1) /=
        costswindow_first_0_count_9_value_2)) + as_number(((to_integer(costsshift_search_0_1(29 downto 29)) = 1) /=
        costswindow_first_0_count_9_value_3));
      costswindow_first_1_count_10 <= as_number(((to_integer(costsshift_search_0_1(30 downto 30)) = 1) /=
        costswindow_first_0_count_10_value)) + as_number(((to_integer(costsshift_search_0_1(31 downto 31)) = 1) /=
        costswindow_first_0_count_10_value_2)) + as_number(((to_integer(costsshift_search_0_1(32 downto 32)) = 1) /=
        costswindow_first_0_count_10_value_3));
      costswindow_first_1_count_11 <= as_number(((to_integer(costsshift_search_0_1(33 downto 33)) = 1) /=
        costswindow_first_0_count_11_value)) + as_number(((to_integer(costsshift_search_0_1(34 downto 34)) = 1) /=
        costswindow_first_0_count_11_value_2)) + as_number(((to_integer(costsshift_search_0_1(35 downto 35)) = 1) /=
        costswindow_first_0_count_11_value_3));
      costswindow_first_1_count_12 <= as_number(((to_integer(costsshift_search_0_1(36 downto 36)) = 1) /=
        costswindow_first_0_count_12_value)) + as_number(((to_integer(costsshift_search_0_1(37 downto 37)) = 1) /=
        costswindow_first_0_count_12_value_2)) + as_number(((to_integer(costsshift_search_0_1(38 downto 38)) = 1) /=
        costswindow_first_0_count_12_value_3));
      costswindow_first_1_count_13 <= as_number(((to_integer(costsshift_search_0_1(39 downto 39)) = 1) /=
        costswindow_first_0_count_13_value)) + as_number(((to_integer(costsshift_search_0_1(40 downto 40)) = 1) /=
        costswindow_first_0_count_13_value_2)) + as_number(((to_integer(costsshift_search_0_1(41 downto 41)) = 1) /=
        costswindow_first_0_count_13_value_3));
      costswindow_first_1_count_14 <= as_number(((to_integer(costsshift_search_0_1(43 downto 43)) = 1) /=
        (to_integer(costsshift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(costsshift_search_0_1(42
        downto 42)) = 1) /= costswindow_first_0_count_14_value));
      costswindow_first_2_count_0 <= as_number(((to_integer(costsshift_search_0_2(0 downto 0)) = 1) /=
        (to_integer(costsshift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(costsshift_search_0_2(2 downto
        2)) = 1) /= costswindow_first_0_count_0_value)) + as_number(((to_integer(costsshift_search_0_2(1 downto 1)) =
        1) /= costswindow_first_0_count_0_value_2));
      costswindow_first_2_count_1 <= as_number(((to_integer(costsshift_search_0_2(3 downto 3)) = 1) /=
        costswindow_first_0_count_1_value)) + as_number(((to_integer(costsshift_search_0_2(4 downto 4)) = 1) /=
        costswindow_first_0_count_1_value_2)) + as_number(((to_integer(costsshift_search_0_2(5 downto 5)) = 1) /=
        costswindow_first_0_count_1_value_3));
      costswindow_first_2_count_2 <= as_number(((to_integer(costsshift_search_0_2(6 downto 6)) = 1) /=
        costswindow_first_0_count_2_value)) + as_number(((to_integer(costsshift_search_0_2(7 downto 7)) = 1) /=
        costswindow_first_0_count_2_value_2)) + as_number(((to_integer(costsshift_search_0_2(8 downto 8)) = 1) /=
        costswindow_first_0_count_2_value_3));
      costswindow_first_2_count_3 <= as_number(((to_integer(costsshift_search_0_2(9 downto 9)) = 1) /=
        costswindow_first_0_count_3_value)) + as_number(((to_integer(costsshift_search_0_2(10 downto 10)) = 1) /=
        costswindow_first_0_count_3_value_2)) + as_number(((to_integer(costsshift_search_0_2(11 downto 11)) = 1) /=
        costswindow_first_0_count_3_value_3));
      costswindow_first_2_count_4 <= as_number(((to_integer(costsshift_search_0_2(12 downto 12)) = 1) /=
        costswindow_first_0_count_4_value)) + as_number(((to_integer(costsshift_search_0_2(13 downto 13)) = 1) /=
        costswindow_first_0_count_4_value_2)) + as_number(((to_integer(costsshift_search_0_2(14 downto 14)) = 1) /=
        costswindow_first_0_count_4_value_3));
      costswindow_first_2_count_5 <= as_number(((to_integer(costsshift_search_0_2(15 downto 15)) = 1) /=
        costswindow_first_0_count_5_value)) + as_number(((to_integer(costsshift_search_0_2(16 downto 16)) = 1) /=
        costswindow_first_0_count_5_value_2)) + as_number(((to_integer(costsshift_search_0_2(17 downto 17)) = 1) /=
        costswindow_first_0_count_5_value_3));
      costswindow_first_2_count_6 <= as_number(((to_integer(costsshift_search_0_2(18 downto 18)) = 1) /=
        costswindow_first_0_count_6_value)) + as_number(((to_integer(costsshift_search_0_2(19 downto 19)) = 1) /=
        costswindow_first_0_count_6_value_2)) + as_number(((to_integer(costsshift_search_0_2(20 downto 20)) = 1) /=
        costswindow_first_0_count_6_value_3));
      costswindow_first_2_count_7 <= as_number(((to_integer(costsshift_search_0_2(21 downto 21)) = 1) /=
        costswindow_first_0_count_7_value)) + as_number(((to_integer(costsshift_search_0_2(22 downto 22)) = 1) /=
        costswindow_first_0_count_7_value_2)) + as_number(((to_integer(costsshift_search_0_2(23 downto 23)) = 1) /=
        costswindow_first_0_count_7_value_3));
      costswindow_first_2_count_8 <= as_number(((to_integer(costsshift_search_0_2(24 downto 24)) = 1) /=
        costswindow_first_0_count_8_value)) + as_number(((to_integer(costsshift_search_0_2(26 downto 26)) = 1) /=
        costswindow_first_0_count_8_value_2)) + as_number(((to_integer(costsshift_search_0_2(25 downto 25)) = 1) /=
        costswindow_first_0_count_8_value_3));
      costswindow_first_2_count_9 <= as_number(((to_integer(costsshift_search_0_2(27 downto 27)) = 1) /=
        costswindow_first_0_count_9_value)) + as_number(((to_integer(costsshift_search_0_2(28 downto 28)) = 1) /=
        costswindow_first_0_count_9_value_2)) + as_number(((to_integer(costsshift_search_0_2(29 downto 29)) = 1) /=
        costswindow_first_0_count_9_value_3));
      costswindow_first_2_count_10 <= as_number(((to_integer(costsshift_search_0_2(30 downto 30)) = 1) /=
        costswindow_first_0_count_10_value)) + as_number(((to_integer(costsshift_search_0_2(31 downto 31)) = 1) /=
        costswindow_first_0_count_10_value_2)) + as_number(((to_integer(costsshift_search_0_2(32 downto 32)) = 1) /=
        costswindow_first_0_count_10_value_3));
      costswindow_first_2_count_11 <= as_number(((to_integer(costsshift_search_0_2(33 downto 33)) = 1) /=
        costswindow_first_0_count_11_value)) + as_number(((to_integer(costsshift_search_0_2(34 downto 34)) = 1) /=
        costswindow_first_0_count_11_value_2)) + as_number(((to_integer(costsshift_search_0_2(35 downto 35)) = 1) /=
        costswindow_first_0_count_11_value_3));
      costswindow_first_2_count_12 <= as_number(((to_integer(costsshift_search_0_2(36 downto 36)) = 1) /=
        costswindow_first_0_count_12_value)) + as_number(((to_integer(costsshift_search_0_2(37 downto 37)) = 1) /=
        costswindow_first_0_count_12_value_2)) + as_number(((to_integer(costsshift_search_0_2(38 downto 38)) = 1) /=
        costswindow_first_0_count_12_value_3));
      costswindow_first_2_count_13 <= as_number(((to_integer(costsshift_search_0_2(39 downto 39)) = 1) /=
        costswindow_first_0_count_13_value)) + as_number(((to_integer(costsshift_search_0_2(40 downto 40)) = 1) /=
        costswindow_first_0_count_13_value_2)) + as_number(((to_integer(costsshift_search_0_2(41 downto 41)) = 1) /=
        costswindow_first_0_count_13_value_3));
      costswindow_first_2_count_14 <= as_number(((to_integer(costsshift_search_0_2(43 downto 43)) = 1) /=
        (to_integer(costsshift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(costsshift_search_0_2(42
        downto 42)) = 1) /= costswindow_first_0_count_14_value));
      costswindow_first_3_count_0 <= as_number(((to_integer(costsshift_search_0_3(0 downto 0)) = 1) /=
        (to_integer(costsshift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(costsshift_search_0_3(2 downto
        2)) = 1) /= costswindow_first_0_count_0_value)) + as_number(((to_integer(costsshift_search_0_3(1 downto 1)) =
        1) /= costswindow_first_0_count_0_value_2));
      costswindow_first_3_count_1 <= as_number(((to_integer(costsshift_search_0_3(3 downto 3)) = 1) /=
        costswindow_first_0_count_1_value)) + as_number(((to_integer(costsshift_search_0_3(4 downto 4)) = 1) /=
        costswindow_first_0_count_1_value_2)) + as_number(((to_integer(costsshift_search_0_3(5 downto 5)) = 1) /=
        costswindow_first_0_count_1_value_3));
      costswindow_first_3_count_2 <= as_number(((to_integer(costsshift_search_0_3(6 downto 6)) = 1) /=
        costswindow_first_0_count_2_value)) + as_number(((to_integer(costsshift_search_0_3(7 downto 7)) = 1) /=
        costswindow_first_0_count_2_value_2)) + as_number(((to_integer(costsshift_search_0_3(8 downto 8)) = 1) /=
        costswindow_first_0_count_2_value_3));
      costswindow_first_3_count_3 <= as_number(((to_integer(costsshift_search_0_3(9 downto 9)) = 1) /=
        costswindow_first_0_count_3_value)) + as_number(((to_integer(costsshift_search_0_3(10 downto 10)) = 1) /=
        costswindow_first_0_count_3_value_2)) + as_number(((to_integer(costsshift_search_0_3(11 downto 11)) = 1) /=
        costswindow_first_0_count_3_value_3));
      costswindow_first_3_count_4 <= as_number(((to_integer(costsshift_search_0_3(12 downto 12)) = 1) /=
        costswindow_first_0_count_4_value)) + as_number(((to_integer(costsshift_search_0_3(13 downto 13)) = 1) /=
        costswindow_first_0_count_4_value_2)) + as_number(((to_integer(costsshift_search_0_3(14 downto 14)) = 1) /=
        costswindow_first_0_count_4_value_3));
      costswindow_first_3_count_5 <= as_number(((to_integer(costsshift_search_0_3(15 downto 15)) = 1) /=
        costswindow_first_0_count_5_value)) + as_number(((to_integer(costsshift_search_0_3(16 downto 16)) = 1) /=
        costswindow_first_0_count_5_value_2)) + as_number(((to_integer(costsshift_search_0_3(17 downto 17)) = 1) /=
        costswindow_first_0_count_5_value_3));
      costswindow_first_3_count_6 <= as_number(((to_integer(costsshift_search_0_3(18 downto 18)) = 1) /=
        costswindow_first_0_count_6_value)) + as_number(((to_integer(costsshift_search_0_3(19 downto 19)) = 1) /=
        costswindow_first_0_count_6_value_2)) + as_number(((to_integer(costsshift_search_0_3(20 downto 20)) = 1) /=
        costswindow_first_0_count_6_value_3));
      costswindow_first_3_count_7 <= as_number(((to_integer(costsshift_search_0_3(21 downto 21)) = 1) /=
        costswindow_first_0_count_7_value)) + as_number(((to_integer(costsshift_search_0_3(22 downto 22)) = 1) /=
        costswindow_first_0_count_7_value_2)) + as_number(((to_integer(costsshift_search_0_3(23 downto 23)) = 1) /=
        costswindow_first_0_count_7_value_3));
      costswindow_first_3_count_8 <= as_number(((to_integer(costsshift_search_0_3(24 downto 24)) = 1) /=
        costswindow_first_0_count_8_value)) + as_number(((to_integer(costsshift_search_0_3(26 downto 26)) = 1) /=
        costswindow_first_0_count_8_value_2)) + as_number(((to_integer(costsshift_search_0_3(25 downto 25)) = 1) /=
        costswindow_first_0_count_8_value_3));
      costswindow_first_3_count_9 <= as_number(((to_integer(costsshift_search_0_3(27 downto 27)) = 1) /=
        costswindow_first_0_count_9_value)) + as_number(((to_integer(costsshift_search_0_3(28 downto 28)) = 1) /=
        costswindow_first_0_count_9_value_2)) + as_number(((to_integer(costsshift_search_0_3(29 downto 29)) = 1) /=
        costswindow_first_0_count_9_value_3));
      costswindow_first_3_count_10 <= as_number(((to_integer(costsshift_search_0_3(30 downto 30)) = 1) /=
        costswindow_first_0_count_10_value)) + as_number(((to_integer(costsshift_search_0_3(31 downto 31)) = 1) /=
        costswindow_first_0_count_10_value_2)) + as_number(((to_integer(costsshift_search_0_3(32 downto 32)) = 1) /=
        costswindow_first_0_count_10_value_3));
      costswindow_first_3_count_11 <= as_number(((to_integer(costsshift_search_0_3(33 downto 33)) = 1) /=
        costswindow_first_0_count_11_value)) + as_number(((to_integer(costsshift_search_0_3(34 downto 34)) = 1) /=
        costswindow_first_0_count_11_value_2)) + as_number(((to_integer(costsshift_search_0_3(35 downto 35)) = 1) /=
        costswindow_first_0_count_11_value_3));
      costswindow_first_3_count_12 <= as_number(((to_integer(costsshift_search_0_3(36 downto 36)) = 1) /=
        costswindow_first_0_count_12_value)) + as_number(((to_integer(costsshift_search_0_3(37 downto 37)) = 1) /=
        costswindow_first_0_count_12_value_2)) + as_number(((to_integer(costsshift_search_0_3(38 downto 38)) = 1) /=
        costswindow_first_0_count_12_value_3));
      costswindow_first_3_count_13 <= as_number(((to_integer(costsshift_search_0_3(39 downto 39)) = 1) /=
        costswindow_first_0_count_13_value)) + as_number(((to_integer(costsshift_search_0_3(40 downto 40)) = 1) /=
        costswindow_first_0_count_13_value_2)) + as_number(((to_integer(costsshift_search_0_3(41 downto 41)) = 1) /=
        costswindow_first_0_count_13_value_3));
      costswindow_first_3_count_14 <= as_number(((to_integer(costsshift_search_0_3(43 downto 43)) = 1) /=
        (to_integer(costsshift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(costsshift_search_0_3(42
        downto 42)) = 1) /= costswindow_first_0_count_14_value));
      costswindow_first_4_count_0 <= as_number(((to_integer(costsshift_search_0_4(0 downto 0)) = 1) /=
        (to_integer(costsshift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(costsshift_search_0_4(2 downto
        2)) = 1) /= costswindow_first_0_count_0_value)) + as_number(((to_integer(costsshift_search_0_4(1 downto 1)) =
        1) /= costswindow_first_0_count_0_value_2));
      costswindow_first_4_count_1 <= as_number(((to_integer(costsshift_search_0_4(3 downto 3)) = 1) /=
        costswindow_first_0_count_1_value)) + as_number(((to_integer(costsshift_search_0_4(4 downto 4)) = 1) /=
        costswindow_first_0_count_1_value_2)) + as_number(((to_integer(costsshift_search_0_4(5 downto 5)) = 1) /=
        costswindow_first_0_count_1_value_3));
      costswindow_first_4_count_2 <= as_number(((to_integer(costsshift_search_0_4(6 downto 6)) = 1) /=
        costswindow_first_0_count_2_value)) + as_number(((to_integer(costsshift_search_0_4(7 downto 7)) = 1) /=
        costswindow_first_0_count_2_value_2)) + as_number(((to_integer(costsshift_search_0_4(8 downto 8)) = 1) /=
        costswindow_first_0_count_2_value_3));
      costswindow_first_4_count_3 <= as_number(((to_integer(costsshift_search_0_4(9 downto 9)) = 1) /=
        costswindow_first_0_count_3_value)) + as_number(((to_integer(costsshift_search_0_4(10 downto 10)) = 1) /=
        costswindow_first_0_count_3_value_2)) + as_number(((to_integer(costsshift_search_0_4(11 downto 11)) = 1) /=
        costswindow_first_0_count_3_value_3));
      costswindow_first_4_count_4 <= as_number(((to_integer(costsshift_search_0_4(12 downto 12)) = 1) /=
        costswindow_first_0_count_4_value)) + as_number(((to_integer(costsshift_search_0_4(13 downto 13)) = 1) /=
        costswindow_first_0_count_4_value_2)) + as_number(((to_integer(costsshift_search_0_4(14 downto 14)) = 1) /=
        costswindow_first_0_count_4_value_3));
      costswindow_first_4_count_5 <= as_number(((to_integer(costsshift_search_0_4(15 downto 15)) = 1) /=
        costswindow_first_0_count_5_value)) + as_number(((to_integer(costsshift_search_0_4(16 downto 16)) = 1) /=
        costswindow_first_0_count_5_value_2)) + as_number(((to_integer(costsshift_search_0_4(17 downto 17)) = 1) /=
        costswindow_first_0_count_5_value_3));
      costswindow_first_4_count_6 <= as_number(((to_integer(costsshift_search_0_4(18 downto 18)) = 1) /=
        costswindow_first_0_count_6_value)) + as_number(((to_integer(costsshift_search_0_4(19 downto 19)) = 1) /=
        costswindow_first_0_count_6_value_2)) + as_number(((to_integer(costsshift_search_0_4(20 downto 20)) = 1) /=
        costswindow_first_0_count_6_value_3));
      costswindow_first_4_count_7 <= as_number(((to_integer(costsshift_search_0_4(21 downto 21)) = 1) /=
        costswindow_first_0_count_7_value)) + as_number(((to_integer(costsshift_search_0_4(22 downto 22)) = 1) /=
        costswindow_first_0_count_7_value_2)) + as_number(((to_integer(costsshift_search_0_4(23 downto 23)) = 1) /=
        costswindow_first_0_count_7_value_3));
      costswindow_first_4_count_8 <= as_number(((to_integer(costsshift_search_0_4(24 downto 24)) = 1) /=
        costswindow_first_0_count_8_value)) + as_number(((to_integer(costsshift_search_0_4(26 downto 26)) = 1) /=
        costswindow_first_0_count_8_value_2)) + as_number(((to_integer(costsshift_search_0_4(25 downto 25)) = 1) /=
        costswindow_first_0_count_8_value_3));
      costswindow_first_4_count_9 <= as_number(((to_integer(costsshift_search_0_4(27 downto 27)) = 1) /=
        costswindow_first_0_count_9_value)) + as_number(((to_integer(costsshift_search_0_4(28 downto 28)) = 1) /=
        costswindow_first_0_count_9_value_2)) + as_number(((to_integer(costsshift_search_0_4(29 downto 29)) = 1) /=
        costswindow_first_0_count_9_value_3));
      costswindow_first_4_count_10 <= as_number(((to_integer(costsshift_search_0_4(30 downto 30)) = 1) /=
        costswindow_first_0_count_10_value)) + as_number(((to_integer(costsshift_search_0_4(31 downto 31)) = 1) /=
        costswindow_first_0_count_10_value_2)) + as_number(((to_integer(costsshift_search_0_4(32 downto 32)) = 1) /=
        costswindow_first_0_count_10_value_3));
      costswindow_first_4_count_11 <= as_number(((to_integer(costsshift_search_0_4(33 downto 33)) = 1) /=
        costswindow_first_0_count_11_value)) + as_number(((to_integer(costsshift_search_0_4(34 downto 34)) = 1) /=
        costswindow_first_0_count_11_value_2)) + as_number(((to_integer(costsshift_search_0_4(35 downto 35)) = 1) /=
        costswindow_first_0_count_11_value_3));
      costswindow_first_4_count_12 <= as_number(((to_integer(costsshift_search_0_4(36 downto 36)) = 1) /=
        costswindow_first_0_count_12_value)) + as_number(((to_integer(costsshift_search_0_4(37 downto 37)) = 1) /=
        costswindow_first_0_count_12_value_2)) + as_number(((to_integer(costsshift_search_0_4(38 downto 38)) = 1) /=
        costswindow_first_0_count_12_value_3));
      costswindow_first_4_count_13 <= as_number(((to_integer(costsshift_search_0_4(39 downto 39)) = 1) /=
        costswindow_first_0_count_13_value)) + as_number(((to_integer(costsshift_search_0_4(40 downto 40)) = 1) /=
        costswindow_first_0_count_13_value_2)) + as_number(((to_integer(costsshift_search_0_4(41 downto 41)) = 1) /=
        costswindow_first_0_count_13_value_3));
      costswindow_first_4_count_14 <= as_number(((to_integer(costsshift_search_0_4(43 downto 43)) = 1) /=
        (to_integer(costsshift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(costsshift_search_0_4(42
        downto 42)) = 1) /= costswindow_first_0_count_14_value));
      costswindow_first_5_count_0 <= as_number(((to_integer(costsshift_search_0_5(0 downto 0)) = 1) /=
        (to_integer(costsshift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(costsshift_search_0_5(2 downto
        2)) = 1) /= costswindow_first_0_count_0_value)) + as_number(((to_integer(costsshift_search_0_5(1 downto 1)) =
        1) /= costswindow_first_0_count_0_value_2));
      costswindow_first_5_count_1 <= as_number(((to_integer(costsshift_search_0_5(3 downto 3)) = 1) /=
        costswindow_first_0_count_1_value)) + as_number(((to_integer(costsshift_search_0_5(4 downto 4)) = 1) /=
        costswindow_first_0_count_1_value_2)) + as_number(((to_integer(costsshift_search_0_5(5 downto 5)) = 1) /=
        costswindow_first_0_count_1_value_3));
      costswindow_first_5_count_2 <= as_number(((to_integer(costsshift_search_0_5(6 downto 6)) = 1) /=
        costswindow_first_0_count_2_value)) + as_number(((to_integer(costsshift_search_0_5(7 downto 7)) = 1) /=
        costswindow_first_0_count_2_value_2)) + as_number(((to_integer(costsshift_search_0_5(8 downto 8)) = 1) /=
        costswindow_first_0_count_2_value_3));
      costswindow_first_5_count_3 <= as_number(((to_integer(costsshift_search_0_5(9 downto 9)) = 1) /=
        costswindow_first_0_count_3_value)) + as_number(((to_integer(costsshift_search_0_5(10 downto 10)) = 1) /=
        costswindow_first_0_count_3_value_2)) + as_number(((to_integer(costsshift_search_0_5(11 downto 11)) = 1) /=
        costswindow_first_0_count_3_value_3));
      costswindow_first_5_count_4 <= as_number(((to_integer(costsshift_search_0_5(12 downto 12)) = 1) /=
        costswindow_first_0_count_4_value)) + as_number(((to_integer(costsshift_search_0_5(13 downto 13)) = 1) /=
        costswindow_first_0_count_4_value_2)) + as_number(((to_integer(costsshift_search_0_5(14 downto 14)) = 1) /=
        costswindow_first_0_count_4_value_3));
      costswindow_first_5_count_5 <= as_number(((to_integer(costsshift_search_0_5(15 downto 15)) = 1) /=
        costswindow_first_0_count_5_value)) + as_number(((to_integer(costsshift_search_0_5(16 downto 16)) = 1) /=
        costswindow_first_0_count_5_value_2)) + as_number(((to_integer(costsshift_search_0_5(17 downto 17)) = 1) /=
        costswindow_first_0_count_5_value_3));
      costswindow_first_5_count_6 <= as_number(((to_integer(costsshift_search_0_5(18 downto 18)) = 1) /=
        costswindow_first_0_count_6_value)) + as_number(((to_integer(costsshift_search_0_5(19 downto 19)) = 1) /=
        costswindow_first_0_count_6_value_2)) + as_number(((to_integer(costsshift_search_0_5(20 downto 20)) = 1) /=
        costswindow_first_0_count_6_value_3));
      costswindow_first_5_count_7 <= as_number(((to_integer(costsshift_search_0_5(21 downto 21)) = 1) /=
        costswindow_first_0_count_7_value)) + as_number(((to_integer(costsshift_search_0_5(22 downto 22)) = 1) /=
        costswindow_first_0_count_7_value_2)) + as_number(((to_integer(costsshift_search_0_5(23 downto 23)) = 1) /=
        costswindow_first_0_count_7_value_3));
      costswindow_first_5_count_8 <= as_number(((to_integer(costsshift_search_0_5(24 downto 24)) = 1) /=
        costswindow_first_0_count_8_value)) + as_number(((to_integer(costsshift_search_0_5(26 downto 26)) = 1) /=
        costswindow_first_0_count_8_value_2)) + as_number(((to_integer(costsshift_search_0_5(25 downto 25)) = 1) /=
        costswindow_first_0_count_8_value_3));
      costswindow_first_5_count_9 <= as_number(((to_integer(costsshift_search_0_5(27 downto 27)) = 1) /=
        costswindow_first_0_count_9_value)) + as_number(((to_integer(costsshift_search_0_5(28 downto 28)) = 1) /=
        costswindow_first_0_count_9_value_2)) + as_number(((to_integer(costsshift_search_0_5(29 downto 29)) = 1) /=
        costswindow_first_0_count_9_value_3));
      costswindow_first_5_count_10 <= as_number(((to_integer(costsshift_search_0_5(30 downto 30)) = 1) /=
        costswindow_first_0_count_10_value)) + as_number(((to_integer(costsshift_search_0_5(31 downto 31)) = 1) /=
        costswindow_first_0_count_10_value_2)) + as_number(((to_integer(costsshift_search_0_5(32 downto 32)) = 1) /=
        costswindow_first_0_count_10_value_3));
      costswindow_first_5_count_11 <= as_number(((to_integer(costsshift_search_0_5(33 downto 33)) = 1) /=
        costswindow_first_0_count_11_value)) + as_number(((to_integer(costsshift_search_0_5(34 downto 34)) = 1) /=
        costswindow_first_0_count_11_value_2)) + as_number(((to_integer(costsshift_search_0_5(35 downto 35)) = 1) /=
        costswindow_first_0_count_11_value_3));
      costswindow_first_5_count_12 <= as_number(((to_integer(costsshift_search_0_5(36 downto 36)) = 1) /=
        costswindow_first_0_count_12_value)) + as_number(((to_integer(costsshift_search_0_5(37 downto 37)) = 1) /=
        costswindow_first_0_count_12_value_2)) + as_number(((to_integer(costsshift_search_0_5(38 downto 38)) = 1) /=
        costswindow_first_0_count_12_value_3));
      costswindow_first_5_count_13 <= as_number(((to_integer(costsshift_search_0_5(39 downto 39)) = 1) /=
        costswindow_first_0_count_13_value)) + as_number(((to_integer(costsshift_search_0_5(40 downto 40)) = 1) /=
        costswindow_first_0_count_13_value_2)) + as_number(((to_integer(costsshift_search_0_5(41 downto 41)) = 1) /=
        costswindow_first_0_count_13_value_3));
      costswindow_first_5_count_14 <= as_number(((to_integer(costsshift_search_0_5(43 downto 43)) = 1) /=
        (to_integer(costsshift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(costsshift_search_0_5(42
        downto 42)) = 1) /= costswindow_first_0_count_14_value));
      costswindow_first_6_count_0 <= as_number(((to_integer(costsshift_search_0_6(0 downto 0)) = 1) /=
        (to_integer(costsshift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(costsshift_search_0_6(2 downto
        2)) = 1) /= costswindow_first_0_count_0_value)) + as_number(((to_integer(costsshift_search_0_6(1 downto 1)) =
        1) /= costswindow_first_0_count_0_value_2));
      costswindow_first_6_count_1 <= as_number(((to_integer(costsshift_search_0_6(3 downto 3)) = 1) /=
        costswindow_first_0_count_1_value)) + as_number(((to_integer(costsshift_search_0_6(4 downto 4)) = 1) /=
        costswindow_first_0_count_1_value_2)) + as_number(((to_integer(costsshift_search_0_6(5 downto 5)) = 1) /=
        costswindow_first_0_count_1_value_3));
      costswindow_first_6_count_2 <= as_number(((to_integer(costsshift_search_0_6(6 downto 6)) = 1) /=
        costswindow_first_0_count_2_value)) + as_number(((to_integer(costsshift_search_0_6(7 downto 7)) = 1) /=
        costswindow_first_0_count_2_value_2)) + as_number(((to_integer(costsshift_search_0_6(8 downto 8)) = 1) /=
        costswindow_first_0_count_2_value_3));
      costswindow_first_6_count_3 <= as_number(((to_integer(costsshift_search_0_6(9 downto 9)) = 1) /=
        costswindow_first_0_count_3_value)) + as_number(((to_integer(costsshift_search_0_6(10 downto 10)) = 1) /=
        costswindow_first_0_count_3_value_2)) + as_number(((to_integer(costsshift_search_0_6(11 downto 11)) = 1) /=
        costswindow_first_0_count_3_value_3));
      costswindow_first_6_count_4 <= as_number(((to_integer(costsshift_search_0_6(12 downto 12)) = 1) /=
        costswindow_first_0_count_4_value)) + as_number(((to_integer(costsshift_search_0_6(13 downto 13)) = 1) /=
        costswindow_first_0_count_4_value_2)) + as_number(((to_integer(costsshift_search_0_6(14 downto 14)) = 1) /=
        costswindow_first_0_count_4_value_3));
      costswindow_first_6_count_5 <= as_number(((to_integer(costsshift_search_0_6(15 downto 15)) = 1) /=
        costswindow_first_0_count_5_value)) + as_number(((to_integer(costsshift_search_0_6(16 downto 16)) = 1) /=
        costswindow_first_0_count_5_value_2)) + as_number(((to_integer(costsshift_search_0_6(17 downto 17)) = 1) /=
        costswindow_first_0_count_5_value_3));
      costswindow_first_6_count_6 <= as_number(((to_integer(costsshift_search_0_6(18 downto 18)) = 1) /=
        costswindow_first_0_count_6_value)) + as_number(((to_integer(costsshift_search_0_6(19 downto 19)) = 1) /=
        costswindow_first_0_count_6_value_2)) + as_number(((to_integer(costsshift_search_0_6(20 downto 20)) = 1) /=
        costswindow_first_0_count_6_value_3));
      costswindow_first_6_count_7 <= as_number(((to_integer(costsshift_search_0_6(21 downto 21)) = 1) /=
        costswindow_first_0_count_7_value)) + as_number(((to_integer(costsshift_search_0_6(22 downto 22)) = 1) /=
        costswindow_first_0_count_7_value_2)) + as_number(((to_integer(costsshift_search_0_6(23 downto 23)) = 1) /=
        costswindow_first_0_count_7_value_3));
      costswindow_first_6_count_8 <= as_number(((to_integer(costsshift_search_0_6(24 downto 24)) = 1) /=
        costswindow_first_0_count_8_value)) + as_number(((to_integer(costsshift_search_0_6(26 downto 26)) = 1) /=
        costswindow_first_0_count_8_value_2)) + as_number(((to_integer(costsshift_search_0_6(25 downto 25)) = 1) /=
        costswindow_first_0_count_8_value_3));
      costswindow_first_6_count_9 <= as_number(((to_integer(costsshift_search_0_6(27 downto 27)) = 1) /=
        costswindow_first_0_count_9_value)) + as_number(((to_integer(costsshift_search_0_6(28 downto 28)) = 1) /=
        costswindow_first_0_count_9_value_2)) + as_number(((to_integer(costsshift_search_0_6(29 downto 29)) = 1) /=
        costswindow_first_0_count_9_value_3));
      costswindow_first_6_count_10 <= as_number(((to_integer(costsshift_search_0_6(30 downto 30)) = 1) /=
        costswindow_first_0_count_10_value)) + as_number(((to_integer(costsshift_search_0_6(31 downto 31)) = 1) /=
        costswindow_first_0_count_10_value_2)) + as_number(((to_integer(costsshift_search_0_6(32 downto 32)) = 1) /=
        costswindow_first_0_count_10_value_3));
      costswindow_first_6_count_11 <= as_number(((to_integer(costsshift_search_0_6(33 downto 33)) = 1) /=
        costswindow_first_0_count_11_value)) + as_number(((to_integer(costsshift_search_0_6(34 downto 34)) = 1) /=
        costswindow_first_0_count_11_value_2)) + as_number(((to_integer(costsshift_search_0_6(35 downto 35)) = 1) /=
        costswindow_first_0_count_11_value_3));
      costswindow_first_6_count_12 <= as_number(((to_integer(costsshift_search_0_6(36 downto 36)) = 1) /=
        costswindow_first_0_count_12_value)) + as_number(((to_integer(costsshift_search_0_6(37 downto 37)) = 1) /=
        costswindow_first_0_count_12_value_2)) + as_number(((to_integer(costsshift_search_0_6(38 downto 38)) = 1) /=
        costswindow_first_0_count_12_value_3));
      costswindow_first_6_count_13 <= as_number(((to_integer(costsshift_search_0_6(39 downto 39)) = 1) /=
        costswindow_first_0_count_13_value)) + as_number(((to_integer(costsshift_search_0_6(40 downto 40)) = 1) /=
        costswindow_first_0_count_13_value_2)) + as_number(((to_integer(costsshift_search_0_6(41 downto 41)) = 1) /=
        costswindow_first_0_count_13_value_3));
      costswindow_first_6_count_14 <= as_number(((to_integer(costsshift_search_0_6(43 downto 43)) = 1) /=
        (to_integer(costsshift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(costsshift_search_0_6(42
        downto 42)) = 1) /= costswindow_first_0_count_14_value));
      costswindow_first_7_count_0 <= as_number(((to_integer(costsshift_search_0_7(0 downto 0)) = 1) /=
        (to_integer(costsshift_reference_0(0 downto 0)) = 1))) + as_number(((to_integer(costsshift_search_0_7(2 downto
        2)) = 1) /= costswindow_first_0_count_0_value)) + as_number(((to_integer(costsshift_search_0_7(1 downto 1)) =
        1) /= costswindow_first_0_count_0_value_2));
      costswindow_first_7_count_1 <= as_number(((to_integer(costsshift_search_0_7(3 downto 3)) = 1) /=
        costswindow_first_0_count_1_value)) + as_number(((to_integer(costsshift_search_0_7(4 downto 4)) = 1) /=
        costswindow_first_0_count_1_value_2)) + as_number(((to_integer(costsshift_search_0_7(5 downto 5)) = 1) /=
        costswindow_first_0_count_1_value_3));
      costswindow_first_7_count_2 <= as_number(((to_integer(costsshift_search_0_7(6 downto 6)) = 1) /=
        costswindow_first_0_count_2_value)) + as_number(((to_integer(costsshift_search_0_7(7 downto 7)) = 1) /=
        costswindow_first_0_count_2_value_2)) + as_number(((to_integer(costsshift_search_0_7(8 downto 8)) = 1) /=
        costswindow_first_0_count_2_value_3));
      costswindow_first_7_count_3 <= as_number(((to_integer(costsshift_search_0_7(9 downto 9)) = 1) /=
        costswindow_first_0_count_3_value)) + as_number(((to_integer(costsshift_search_0_7(10 downto 10)) = 1) /=
        costswindow_first_0_count_3_value_2)) + as_number(((to_integer(costsshift_search_0_7(11 downto 11)) = 1) /=
        costswindow_first_0_count_3_value_3));
      costswindow_first_7_count_4 <= as_number(((to_integer(costsshift_search_0_7(12 downto 12)) = 1) /=
        costswindow_first_0_count_4_value)) + as_number(((to_integer(costsshift_search_0_7(13 downto 13)) = 1) /=
        costswindow_first_0_count_4_value_2)) + as_number(((to_integer(costsshift_search_0_7(14 downto 14)) = 1) /=
        costswindow_first_0_count_4_value_3));
      costswindow_first_7_count_5 <= as_number(((to_integer(costsshift_search_0_7(15 downto 15)) = 1) /=
        costswindow_first_0_count_5_value)) + as_number(((to_integer(costsshift_search_0_7(16 downto 16)) = 1) /=
        costswindow_first_0_count_5_value_2)) + as_number(((to_integer(costsshift_search_0_7(17 downto 17)) = 1) /=
        costswindow_first_0_count_5_value_3));
      costswindow_first_7_count_6 <= as_number(((to_integer(costsshift_search_0_7(18 downto 18)) = 1) /=
        costswindow_first_0_count_6_value)) + as_number(((to_integer(costsshift_search_0_7(19 downto 19)) = 1) /=
        costswindow_first_0_count_6_value_2)) + as_number(((to_integer(costsshift_search_0_7(20 downto 20)) = 1) /=
        costswindow_first_0_count_6_value_3));
      costswindow_first_7_count_7 <= as_number(((to_integer(costsshift_search_0_7(21 downto 21)) = 1) /=
        costswindow_first_0_count_7_value)) + as_number(((to_integer(costsshift_search_0_7(22 downto 22)) = 1) /=
        costswindow_first_0_count_7_value_2)) + as_number(((to_integer(costsshift_search_0_7(23 downto 23)) = 1) /=
        costswindow_first_0_count_7_value_3));
      costswindow_first_7_count_8 <= as_number(((to_integer(costsshift_search_0_7(24 downto 24)) = 1) /=
        costswindow_first_0_count_8_value)) + as_number(((to_integer(costsshift_search_0_7(26 downto 26)) = 1) /=
        costswindow_first_0_count_8_value_2)) + as_number(((to_integer(costsshift_search_0_7(25 downto 25)) = 1) /=
        costswindow_first_0_count_8_value_3));
      costswindow_first_7_count_9 <= as_number(((to_integer(costsshift_search_0_7(27 downto 27)) = 1) /=
        costswindow_first_0_count_9_value)) + as_number(((to_integer(costsshift_search_0_7(28 downto 28)) = 1) /=
        costswindow_first_0_count_9_value_2)) + as_number(((to_integer(costsshift_search_0_7(29 downto 29)) = 1) /=
        costswindow_first_0_count_9_value_3));
      costswindow_first_7_count_10 <= as_number(((to_integer(costsshift_search_0_7(30 downto 30)) = 1) /=
        costswindow_first_0_count_10_value)) + as_number(((to_integer(costsshift_search_0_7(31 downto 31)) = 1) /=
        costswindow_first_0_count_10_value_2)) + as_number(((to_integer(costsshift_search_0_7(32 downto 32)) = 1) /=
        costswindow_first_0_count_10_value_3));
      costswindow_first_7_count_11 <= as_number(((to_integer(costsshift_search_0_7(33 downto 33)) = 1) /=
        costswindow_first_0_count_11_value)) + as_number(((to_integer(costsshift_search_0_7(34 downto 34)) = 1) /=
        costswindow_first_0_count_11_value_2)) + as_number(((to_integer(costsshift_search_0_7(35 downto 35)) = 1) /=
        costswindow_first_0_count_11_value_3));
      costswindow_first_7_count_12 <= as_number(((to_integer(costsshift_search_0_7(36 downto 36)) = 1) /=
        costswindow_first_0_count_12_value)) + as_number(((to_integer(costsshift_search_0_7(37 downto 37)) = 1) /=
        costswindow_first_0_count_12_value_2)) + as_number(((to_integer(costsshift_search_0_7(38 downto 38)) = 1) /=
        costswindow_first_0_count_12_value_3));
      costswindow_first_7_count_13 <= as_number(((to_integer(costsshift_search_0_7(39 downto 39)) = 1) /=
        costswindow_first_0_count_13_value)) + as_number(((to_integer(costsshift_search_0_7(40 downto 40)) = 1) /=
        costswindow_first_0_count_13_value_2)) + as_number(((to_integer(costsshift_search_0_7(41 downto 41)) = 1) /=
        costswindow_first_0_count_13_value_3));
      costswindow_first_7_count_14 <= as_number(((to_integer(costsshift_search_0_7(43 downto 43)) = 1) /=
        (to_integer(costsshift_reference_0(43 downto 43)) = 1))) + as_number(((to_integer(costsshift_search_0_7(42
        downto 42)) = 1) /= costswindow_first_0_count_14_value));
      costswindow_sum_0_0 <= ((other_10 / 65536) mod 16) + ((other_10 / 256) mod 16) + (other_10 / 16777216) +
        (other_10 mod 16);
      costswindow_sum_0_1 <= ((other_9 / 65536) mod 16) + ((other_9 / 256) mod 16) + (other_9 / 16777216) + (other_9
        mod 16);
      costswindow_sum_0_2 <= ((other_8 / 65536) mod 16) + ((other_8 / 256) mod 16) + (other_8 / 16777216) + (other_8
        mod 16);
      costswindow_sum_0_3 <= ((other_7 / 65536) mod 16) + ((other_7 / 256) mod 16) + (other_7 / 16777216) + (other_7
        mod 16);
      costswindow_sum_0_4 <= ((other_6 / 65536) mod 16) + ((other_6 / 256) mod 16) + (other_6 / 16777216) + (other_6
        mod 16);
      costswindow_sum_0_5 <= ((other_5 / 65536) mod 16) + ((other_5 / 256) mod 16) + (other_5 / 16777216) + (other_5
        mod 16);
      costswindow_sum_0_6 <= ((other_4 / 65536) mod 16) + ((other_4 / 256) mod 16) + (other_4 / 16777216) + (other_4
        mod 16);
      costswindow_sum_0_7 <= ((other_3 / 65536) mod 16) + ((other_3 / 256) mod 16) + (other_3 / 16777216) + (other_3
        mod 16);
      -- costs
      costs_cost_0 <= costswindow_sum_0_0 / 4;
      costs_cost_1 <= costswindow_sum_0_1 / 4;
      costs_cost_2 <= costswindow_sum_0_2 / 4;
      costs_cost_3 <= costswindow_sum_0_3 / 4;
      costs_cost_4 <= costswindow_sum_0_4 / 4;
      costs_cost_5 <= costswindow_sum_0_5 / 4;
      costs_cost_6 <= costswindow_sum_0_6 / 4;
      costs_cost_7 <= costswindow_sum_0_7 / 4;
      -- paths
      if line_comes_9 then
        paths_smallest_cost_choice := 15;
      else
        paths_smallest_cost_choice := paths_smallest_cost;
      end if;
      paths_cost_delay_ring_write_address <= paths_cost_delay_ring_read_address;
      paths_sum_0 <= (pathsturn_sum_memory_ready_words_0 mod 128) + pathsright_cost_0;
      paths_sum_1 <= ((pathsturn_sum_memory_ready_words_1 mod 64) * 2) + (pathsturn_sum_memory_ready_words_0 / 128) +
        pathsright_cost_1;
      paths_sum_2 <= ((pathsturn_sum_memory_ready_words_2 mod 32) * 4) + (pathsturn_sum_memory_ready_words_1 / 64) +
        pathsright_cost_2;
      paths_sum_3 <= ((pathsturn_sum_memory_ready_words_3 mod 16) * 8) + (pathsturn_sum_memory_ready_words_2 / 32) +
        pathsright_cost_3;
      paths_sum_4 <= ((pathsturn_sum_memory_ready_words_4 mod 8) * 16) + (pathsturn_sum_memory_ready_words_3 / 16) +
        pathsright_cost_4;
      paths_sum_5 <= ((pathsturn_sum_memory_ready_words_5 mod 4) * 32) + (pathsturn_sum_memory_ready_words_4 / 8) +
        pathsright_cost_5;
      paths_sum_6 <= ((pathsturn_sum_memory_ready_words_6 mod 2) * 64) + (pathsturn_sum_memory_ready_words_5 / 4) +
        pathsright_cost_6;
      paths_sum_7 <= (pathsturn_sum_memory_ready_words_6 / 2) + pathsright_cost_7;
      if (costs_cost_1 - costs_cost_0) < 0 then
        paths_tree_smallest_0 <= costs_cost_1;
      else
        paths_tree_smallest_0 <= costs_cost_0;
      end if;
      if (costs_cost_3 - costs_cost_2) < 0 then
        paths_tree_smallest_1 <= costs_cost_3;
      else
        paths_tree_smallest_1 <= costs_cost_2;
      end if;
      if (costs_cost_5 - costs_cost_4) < 0 then
        paths_tree_smallest_2 <= costs_cost_5;
      else
        paths_tree_smallest_2 <= costs_cost_4;
      end if;
      if (costs_cost_7 - costs_cost_6) < 0 then
        paths_tree_smallest_3 <= costs_cost_7;
      else
        paths_tree_smallest_3 <= costs_cost_6;
      end if;
      if (paths_tree_smallest_1 - paths_tree_smallest_0) < 0 then
        paths_tree_next_smallest_0 <= paths_tree_smallest_1;
      else
        paths_tree_next_smallest_0 <= paths_tree_smallest_0;
      end if;
      if (paths_tree_smallest_3 - paths_tree_smallest_2) < 0 then
        paths_tree_next_smallest_1 <= paths_tree_smallest_3;
      else
        paths_tree_next_smallest_1 <= paths_tree_smallest_2;
      end if;
      if (paths_tree_next_smallest_1 - paths_tree_next_smallest_0) < 0 then
        paths_tree_next_next_smallest_0 <= paths_tree_next_smallest_1;
      else
        paths_tree_next_next_smallest_0 <= paths_tree_next_smallest_0;
      end if;
      if (paths_tree_next_next_smallest_0 - paths_smallest_cost_choice) < 0 then
        paths_smallest_cost <= paths_tree_next_next_smallest_0;
      else
        paths_smallest_cost <= paths_smallest_cost_choice;
      end if;
      if paths_cost_delay_ring_read_address = 19 then
        paths_cost_delay_ring_read_address <= 0;
      else
        paths_cost_delay_ring_read_address <= (paths_cost_delay_ring_read_address + 1) mod 32;
      end if;
      -- pathsleft
      if line_starts_phases_20 then
        pathsleft_low_address <= (pathsleft_low_address + 1) mod 16;
      end if;
      pathsleft_read_count_phase_is_equal := pathsleft_read_count_phase = 15;
      if pathsleft_read_count_phase_is_equal then
        pathsleft_read_count_phase_choice := 15;
      else
        pathsleft_read_count_phase_choice := (pathsleft_read_count_phase + 1) mod 16;
      end if;
      if pathsleft_ahead_count_phase = 15 then
        pathsleft_ahead_count_phase_choice := 15;
      else
        pathsleft_ahead_count_phase_choice := (pathsleft_ahead_count_phase + 1) mod 16;
      end if;
      pathsleft_lower_neighbour_value := to_integer(pathsleft_read_words_1(17 downto 12));
      pathsleft_stay_0_value := to_integer(pathsleft_read_words_1(23 downto 18));
      if (pathsleft_stay_0_value - to_integer(pathsleft_read_words_0(5 downto 0))) < 0 then
        pathsleft_stay_0_choice := pathsleft_stay_0_value;
      else
        pathsleft_stay_0_choice := to_integer(pathsleft_read_words_0(5 downto 0));
      end if;
      pathsleft_stay_1_value := to_integer(pathsleft_read_words_0(11 downto 6));
      if (to_integer(pathsleft_read_words_1(29 downto 24)) - pathsleft_stay_1_value) < 0 then
        pathsleft_stay_1_choice := to_integer(pathsleft_read_words_1(29 downto 24));
      else
        pathsleft_stay_1_choice := pathsleft_stay_1_value;
      end if;
      pathsleft_stay_2_value := to_integer(pathsleft_read_words_0(17 downto 12));
      if (to_integer(pathsleft_read_words_2(5 downto 0)) - pathsleft_stay_2_value) < 0 then
        pathsleft_stay_2_choice := to_integer(pathsleft_read_words_2(5 downto 0));
      else
        pathsleft_stay_2_choice := pathsleft_stay_2_value;
      end if;
      pathsleft_stay_3_value := to_integer(pathsleft_read_words_2(11 downto 6));
      pathsleft_stay_3_value_2 := to_integer(pathsleft_read_words_0(23 downto 18));
      if (pathsleft_stay_3_value - pathsleft_stay_3_value_2) < 0 then
        pathsleft_stay_3_choice := pathsleft_stay_3_value;
      else
        pathsleft_stay_3_choice := pathsleft_stay_3_value_2;
      end if;
      pathsleft_stay_4_value := to_integer(pathsleft_read_words_2(17 downto 12));
      if (pathsleft_stay_4_value - to_integer(pathsleft_read_words_0(29 downto 24))) < 0 then
        pathsleft_stay_4_choice := pathsleft_stay_4_value;
      else
        pathsleft_stay_4_choice := to_integer(pathsleft_read_words_0(29 downto 24));
      end if;
      pathsleft_stay_5_value := to_integer(pathsleft_read_words_2(23 downto 18));
      if (pathsleft_stay_5_value - to_integer(pathsleft_read_words_1(5 downto 0))) < 0 then
        pathsleft_stay_5_choice := pathsleft_stay_5_value;
      else
        pathsleft_stay_5_choice := to_integer(pathsleft_read_words_1(5 downto 0));
      end if;
      pathsleft_stay_6_value := to_integer(pathsleft_read_words_1(11 downto 6));
      if (to_integer(pathsleft_read_words_2(29 downto 24)) - pathsleft_stay_6_value) < 0 then
        pathsleft_stay_6_choice := to_integer(pathsleft_read_words_2(29 downto 24));
      else
        pathsleft_stay_6_choice := pathsleft_stay_6_value;
      end if;
      if (to_integer(pathsleft_read_words_3) - pathsleft_lower_neighbour_value) < 0 then
        pathsleft_stay_7_choice := to_integer(pathsleft_read_words_3);
      else
        pathsleft_stay_7_choice := pathsleft_lower_neighbour_value;
      end if;
      if line_starts_phases_26 then
        pathsleft_step_0_choice := pathsleft_stay_1_value;
      else
        pathsleft_step_0_choice := pathsleft_lower_neighbour;
      end if;
      if (pathsleft_stay_1_value - pathsleft_step_0_choice) < 0 then
        pathsleft_step_0_choice_2 := pathsleft_stay_1_value;
      else
        pathsleft_step_0_choice_2 := pathsleft_step_0_choice;
      end if;
      if (pathsleft_stay_2_value - to_integer(pathsleft_read_words_0(5 downto 0))) < 0 then
        pathsleft_step_1_choice := pathsleft_stay_2_value;
      else
        pathsleft_step_1_choice := to_integer(pathsleft_read_words_0(5 downto 0));
      end if;
      if (pathsleft_stay_3_value_2 - pathsleft_stay_1_value) < 0 then
        pathsleft_step_2_choice := pathsleft_stay_3_value_2;
      else
        pathsleft_step_2_choice := pathsleft_stay_1_value;
      end if;
      if (to_integer(pathsleft_read_words_0(29 downto 24)) - pathsleft_stay_2_value) < 0 then
        pathsleft_step_3_choice := to_integer(pathsleft_read_words_0(29 downto 24));
      else
        pathsleft_step_3_choice := pathsleft_stay_2_value;
      end if;
      if (to_integer(pathsleft_read_words_1(5 downto 0)) - pathsleft_stay_3_value_2) < 0 then
        pathsleft_step_4_choice := to_integer(pathsleft_read_words_1(5 downto 0));
      else
        pathsleft_step_4_choice := pathsleft_stay_3_value_2;
      end if;
      if (pathsleft_stay_6_value - to_integer(pathsleft_read_words_0(29 downto 24))) < 0 then
        pathsleft_step_5_choice := pathsleft_stay_6_value;
      else
        pathsleft_step_5_choice := to_integer(pathsleft_read_words_0(29 downto 24));
      end if;
      if (pathsleft_lower_neighbour_value - to_integer(pathsleft_read_words_1(5 downto 0))) < 0 then
        pathsleft_step_6_choice := pathsleft_lower_neighbour_value;
      else
        pathsleft_step_6_choice := to_integer(pathsleft_read_words_1(5 downto 0));
      end if;
      if pathsleft_is_last then
        pathsleft_step_7_choice := pathsleft_stay_6_value;
      else
        pathsleft_step_7_choice := to_integer(pathsleft_read_neighbour_0);
      end if;
      if (pathsleft_step_7_choice - pathsleft_stay_6_value) < 0 then
        pathsleft_step_7_choice_2 := pathsleft_step_7_choice;
      else
        pathsleft_step_7_choice_2 := pathsleft_stay_6_value;
      end if;
      pathsleft_stay_change_1_value := to_integer(paths_cost_delay_held_0(7 downto 0)) / 16;
      pathsleft_stay_change_2_value := to_integer(paths_cost_delay_held_0(11 downto 8));
      pathsleft_stay_change_3_value := to_integer(paths_cost_delay_held_0(15 downto 12));
      pathsleft_stay_change_4_value := to_integer(paths_cost_delay_held_0(19 downto 16));
      pathsleft_stay_change_5_value := to_integer(paths_cost_delay_held_0(23 downto 20));
      pathsleft_stay_change_6_value := to_integer(paths_cost_delay_held_0(27 downto 24));
      if pathsleft_write_count_phase = 15 then
        pathsleft_write_count_phase_choice := 15;
      else
        pathsleft_write_count_phase_choice := (pathsleft_write_count_phase + 1) mod 16;
      end if;
      if line_comes_31 then
        pathsleft_low_0_choice := 63;
      else
        pathsleft_low_0_choice := pathsleft_low_0;
      end if;
      pathsleft_lost <= to_integer(pathsleft_lowest_0(5 downto 5)) = 1;
      pathsleft_short_of <= ((to_integer(pathsleft_lowest_0(4 downto 0)) + pathsleft_room) / 32) = 1;
      pathsleft_missing <= (to_integer(pathsleft_lowest_0) + pathsleft_room) mod 32;
      pathsleft_below <= (0 - to_integer(pathsleft_lowest_0)) mod 32;
      pathsleft_is_first <= line_starts_phases_25;
      pathsleft_is_last <= pathsleft_read_count_phase_is_equal;
      pathsleft_lower_neighbour <= pathsleft_lower_neighbour_value;
      pathsleft_stay_change_0 <= (to_integer(paths_cost_delay_held_0(3 downto 0)) - pathsleft_g) mod 64;
      pathsleft_stay_change_1 <= (pathsleft_stay_change_1_value - pathsleft_g) mod 64;
      pathsleft_stay_change_2 <= (pathsleft_stay_change_2_value - pathsleft_g) mod 64;
      pathsleft_stay_change_3 <= (pathsleft_stay_change_3_value - pathsleft_g) mod 64;
      pathsleft_stay_change_4 <= (pathsleft_stay_change_4_value - pathsleft_g) mod 64;
      pathsleft_stay_change_5 <= (pathsleft_stay_change_5_value - pathsleft_g) mod 64;
      pathsleft_stay_change_6 <= (pathsleft_stay_change_6_value - pathsleft_g) mod 64;
      pathsleft_stay_change_7 <= (to_integer(paths_cost_delay_held_0(31 downto 28)) - pathsleft_g) mod 64;
      pathsleft_step_change_0 <= (to_integer(paths_cost_delay_held_0(3 downto 0)) - pathsleft_g_less) mod 64;
      pathsleft_step_change_1 <= (pathsleft_stay_change_1_value - pathsleft_g_less) mod 64;
      pathsleft_step_change_2 <= (pathsleft_stay_change_2_value - pathsleft_g_less) mod 64;
      pathsleft_step_change_3 <= (pathsleft_stay_change_3_value - pathsleft_g_less) mod 64;
      pathsleft_step_change_4 <= (pathsleft_stay_change_4_value - pathsleft_g_less) mod 64;
      pathsleft_step_change_5 <= (pathsleft_stay_change_5_value - pathsleft_g_less) mod 64;
      pathsleft_step_change_6 <= (pathsleft_stay_change_6_value - pathsleft_g_less) mod 64;
      pathsleft_step_change_7 <= (to_integer(paths_cost_delay_held_0(31 downto 28)) - pathsleft_g_less) mod 64;
      if line_starts_phases_24 then
        pathsleft_read_count_phase <= 0;
      else
        pathsleft_read_count_phase <= pathsleft_read_count_phase_choice;
      end if;
      if line_starts_phases_23 then
        pathsleft_ahead_count_phase <= 0;
      else
        pathsleft_ahead_count_phase <= pathsleft_ahead_count_phase_choice;
      end if;
      if (not ((pathsleft_stay_0_choice / 32) = 1)) and (not pathsleft_first) then
        pathsleft_stay_0 <= pathsleft_stay_0_choice;
      else
        pathsleft_stay_0 <= 32;
      end if;
      if (not ((pathsleft_stay_1_choice / 32) = 1)) and (not pathsleft_first) then
        pathsleft_stay_1 <= pathsleft_stay_1_choice;
      else
        pathsleft_stay_1 <= 32;
      end if;
      if (not ((pathsleft_stay_2_choice / 32) = 1)) and (not pathsleft_first) then
        pathsleft_stay_2 <= pathsleft_stay_2_choice;
      else
        pathsleft_stay_2 <= 32;
      end if;
      if (not ((pathsleft_stay_3_choice / 32) = 1)) and (not pathsleft_first) then
        pathsleft_stay_3 <= pathsleft_stay_3_choice;
      else
        pathsleft_stay_3 <= 32;
      end if;
      if (not ((pathsleft_stay_4_choice / 32) = 1)) and (not pathsleft_first) then
        pathsleft_stay_4 <= pathsleft_stay_4_choice;
      else
        pathsleft_stay_4 <= 32;
      end if;
      if (not ((pathsleft_stay_5_choice / 32) = 1)) and (not pathsleft_first) then
        pathsleft_stay_5 <= pathsleft_stay_5_choice;
      else
        pathsleft_stay_5 <= 32;
      end if;
      if (not ((pathsleft_stay_6_choice / 32) = 1)) and (not pathsleft_first) then
        pathsleft_stay_6 <= pathsleft_stay_6_choice;
      else
        pathsleft_stay_6 <= 32;
      end if;
      if (not ((pathsleft_stay_7_choice / 32) = 1)) and (not pathsleft_first) then
        pathsleft_stay_7 <= pathsleft_stay_7_choice;
      else
        pathsleft_stay_7 <= 32;
      end if;
      if pathsleft_first then
        pathsleft_step_0 <= 32;
        pathsleft_step_1 <= 32;
        pathsleft_step_2 <= 32;
        pathsleft_step_3 <= 32;
        pathsleft_step_4 <= 32;
        pathsleft_step_5 <= 32;
        pathsleft_step_6 <= 32;
        pathsleft_step_7 <= 32;
      else
        pathsleft_step_0 <= pathsleft_step_0_choice_2;
        pathsleft_step_1 <= pathsleft_step_1_choice;
        pathsleft_step_2 <= pathsleft_step_2_choice;
        pathsleft_step_3 <= pathsleft_step_3_choice;
        pathsleft_step_4 <= pathsleft_step_4_choice;
        pathsleft_step_5 <= pathsleft_step_5_choice;
        pathsleft_step_6 <= pathsleft_step_6_choice;
        pathsleft_step_7 <= pathsleft_step_7_choice_2;
      end if;
      if line_starts_phases_27 then
        pathsleft_write_count_phase <= 0;
      else
        pathsleft_write_count_phase <= pathsleft_write_count_phase_choice;
      end if;
      if (pathsleft_cost_1 - pathsleft_cost_0) < 0 then
        pathsleft_tree_smallest_0 <= pathsleft_cost_1;
      else
        pathsleft_tree_smallest_0 <= pathsleft_cost_0;
      end if;
      if (pathsleft_cost_3 - pathsleft_cost_2) < 0 then
        pathsleft_tree_smallest_1 <= pathsleft_cost_3;
      else
        pathsleft_tree_smallest_1 <= pathsleft_cost_2;
      end if;
      if (pathsleft_cost_5 - pathsleft_cost_4) < 0 then
        pathsleft_tree_smallest_2 <= pathsleft_cost_5;
      else
        pathsleft_tree_smallest_2 <= pathsleft_cost_4;
      end if;
      if (pathsleft_cost_7 - pathsleft_cost_6) < 0 then
        pathsleft_tree_smallest_3 <= pathsleft_cost_7;
      else
        pathsleft_tree_smallest_3 <= pathsleft_cost_6;
      end if;
      if (pathsleft_tree_smallest_1 - pathsleft_tree_smallest_0) < 0 then
        pathsleft_tree_next_smallest_0 <= pathsleft_tree_smallest_1;
      else
        pathsleft_tree_next_smallest_0 <= pathsleft_tree_smallest_0;
      end if;
      if (pathsleft_tree_smallest_3 - pathsleft_tree_smallest_2) < 0 then
        pathsleft_tree_next_smallest_1 <= pathsleft_tree_smallest_3;
      else
        pathsleft_tree_next_smallest_1 <= pathsleft_tree_smallest_2;
      end if;
      if (pathsleft_tree_next_smallest_1 - pathsleft_tree_next_smallest_0) < 0 then
        pathsleft_tree_next_next_smallest_0 <= pathsleft_tree_next_smallest_1;
      else
        pathsleft_tree_next_next_smallest_0 <= pathsleft_tree_next_smallest_0;
      end if;
      if (pathsleft_tree_next_next_smallest_0 - pathsleft_low_0_choice) < 0 then
        pathsleft_low_0 <= pathsleft_tree_next_next_smallest_0;
      else
        pathsleft_low_0 <= pathsleft_low_0_choice;
      end if;
      if pathsleft_short_of then
        pathsleft_q_choice := pathsleft_missing;
      else
        pathsleft_q_choice := 0;
      end if;
      if pathsleft_lost then
        pathsleft_q_choice_2 := pathsleft_room;
      else
        pathsleft_q_choice_2 := pathsleft_q_choice;
      end if;
      if pathsleft_short_of then
        pathsleft_room_left_choice := pathsleft_below;
      else
        pathsleft_room_left_choice := pathsleft_room;
      end if;
      if line_starts_phases_23 then
        if line_places_1_first_column then
          pathsleft_q <= 24;
        else
          pathsleft_q <= pathsleft_q_choice_2;
        end if;
        if pathsleft_lost then
          pathsleft_room_left <= 0;
        else
          pathsleft_room_left <= pathsleft_room_left_choice;
        end if;
      end if;
      if line_starts_phases_24 then
        pathsleft_q_now <= pathsleft_q;
        pathsleft_q_less <= ((((pathsleft_q / 4) + 15) mod 16) * 4) + (pathsleft_q mod 4);
        if line_places_1_first_column then
          pathsleft_room <= 0;
          pathsleft_start_cost_1 <= 0;
          pathsleft_start_cost_2 <= 0;
          pathsleft_start_cost_3 <= 0;
          pathsleft_start_cost_4 <= 0;
          pathsleft_start_cost_5 <= 0;
          pathsleft_start_cost_6 <= 0;
          pathsleft_start_cost_7 <= 0;
          pathsleft_start_cost_8 <= 0;
          pathsleft_start_cost_9 <= 0;
        else
          pathsleft_room <= (pathsleft_room_left + pathsleft_start_cost_9) mod 32;
          pathsleft_start_cost_1 <= pathsleft_q_now;
          pathsleft_start_cost_2 <= pathsleft_start_cost_1;
          pathsleft_start_cost_3 <= pathsleft_start_cost_2;
          pathsleft_start_cost_4 <= pathsleft_start_cost_3;
          pathsleft_start_cost_5 <= pathsleft_start_cost_4;
          pathsleft_start_cost_6 <= pathsleft_start_cost_5;
          pathsleft_start_cost_7 <= pathsleft_start_cost_6;
          pathsleft_start_cost_8 <= pathsleft_start_cost_7;
          pathsleft_start_cost_9 <= pathsleft_start_cost_8;
        end if;
      end if;
      if line_starts_phases_25 then
        pathsleft_first <= line_places_1_first_column;
        pathsleft_g <= paths_smallest_cost + pathsleft_q_now;
        pathsleft_g_less <= (paths_smallest_cost + pathsleft_q_less) mod 64;
      end if;
      pathsleft_cost_0_any := (pathsleft_write_count_phase /= 15) or line_starts_phases_27;
      if pathsleft_cost_0_any then
        pathsleft_cost_0 <= (pathsleft_stay_0 + pathsleft_stay_change_0) mod 64;
        pathsleft_cost_1 <= (pathsleft_stay_1 + pathsleft_stay_change_1) mod 64;
        pathsleft_cost_2 <= (pathsleft_stay_2 + pathsleft_stay_change_2) mod 64;
        pathsleft_cost_3 <= (pathsleft_stay_3 + pathsleft_stay_change_3) mod 64;
        pathsleft_cost_4 <= (pathsleft_stay_4 + pathsleft_stay_change_4) mod 64;
        pathsleft_cost_5 <= (pathsleft_stay_5 + pathsleft_stay_change_5) mod 64;
        pathsleft_cost_6 <= (pathsleft_stay_6 + pathsleft_stay_change_6) mod 64;
        pathsleft_cost_7 <= (pathsleft_stay_7 + pathsleft_stay_change_7) mod 64;
        pathsleft_arrived_0 <= (pathsleft_step_0 + pathsleft_step_change_0) mod 64;
        pathsleft_arrived_1 <= (pathsleft_step_1 + pathsleft_step_change_1) mod 64;
        pathsleft_arrived_2 <= (pathsleft_step_2 + pathsleft_step_change_2) mod 64;
        pathsleft_arrived_3 <= (pathsleft_step_3 + pathsleft_step_change_3) mod 64;
        pathsleft_arrived_4 <= (pathsleft_step_4 + pathsleft_step_change_4) mod 64;
        pathsleft_arrived_5 <= (pathsleft_step_5 + pathsleft_step_change_5) mod 64;
        pathsleft_arrived_6 <= (pathsleft_step_6 + pathsleft_step_change_6) mod 64;
        pathsleft_arrived_7 <= (pathsleft_step_7 + pathsleft_step_change_7) mod 64;
      end if;
      if line_starts_phases_47 then
        pathsleft_low_write_address <= (pathsleft_low_write_address + 1) mod 16;
      end if;
      -- pathsabove
      pathsabove_memory_read_address_0_sum := pathsabove_read_address_address + 1;
      if line_places_0_first_column then
        pathsabove_memory_read_address_0_choice := 0;
      else
        pathsabove_memory_read_address_0_choice := pathsabove_memory_read_address_0_sum mod 4096;
      end if;
      pathsabove_memory_read_address_0_sum_2 := pathsabove_read_address_address + as_number(((not
        ((pathsabove_read_address_count_phase / 8) = 1)) or (not (((pathsabove_read_address_count_phase / 4) mod 2) =
        1)) or (not (((pathsabove_read_address_count_phase / 2) mod 2) = 1)) or (not
        ((pathsabove_read_address_count_phase mod 2) = 1))));
      if line_places_0_first_column then
        pathsabove_memory_read_address_2_choice := 0;
      else
        pathsabove_memory_read_address_2_choice := pathsabove_memory_read_address_0_sum mod 16;
      end if;
      if line_places_0_first_column then
        pathsabove_memory_bank_choice := 0;
      else
        pathsabove_memory_bank_choice := pathsabove_memory_read_address_0_sum mod 16384;
      end if;
      if line_starts_phases_2 then
        pathsabove_memory_bank_choice_2 := pathsabove_memory_bank_choice;
      else
        pathsabove_memory_bank_choice_2 := pathsabove_memory_read_address_0_sum_2 mod 16384;
      end if;
      pathsabove_memory_ready_words_0_is_equal := pathsabove_memory_held_bank = 2;
      pathsabove_memory_ready_words_0_is_equal_2 := pathsabove_memory_held_bank = 1;
      if pathsabove_memory_ready_words_0_is_equal_2 then
        pathsabove_memory_ready_words_0_choice := pathsabove_memory_held_words_1_0;
      else
        pathsabove_memory_ready_words_0_choice := pathsabove_memory_held_words_0_0;
      end if;
      if pathsabove_memory_ready_words_0_is_equal_2 then
        pathsabove_memory_ready_words_1_choice := pathsabove_memory_held_words_1_1;
      else
        pathsabove_memory_ready_words_1_choice := pathsabove_memory_held_words_0_1;
      end if;
      if pathsabove_memory_ready_words_0_is_equal_2 then
        pathsabove_memory_ready_words_2_choice := pathsabove_memory_held_words_1_2;
      else
        pathsabove_memory_ready_words_2_choice := pathsabove_memory_held_words_0_2;
      end if;
      if pathsabove_memory_ready_words_0_is_equal_2 then
        pathsabove_memory_ready_words_3_choice := pathsabove_memory_held_words_1_3;
      else
        pathsabove_memory_ready_words_3_choice := pathsabove_memory_held_words_0_3;
      end if;
      if pathsabove_memory_ready_words_0_is_equal_2 then
        pathsabove_memory_ready_words_4_choice := pathsabove_memory_held_words_1_4;
      else
        pathsabove_memory_ready_words_4_choice := pathsabove_memory_held_words_0_4;
      end if;
      if pathsabove_read_address_count_phase = 15 then
        pathsabove_read_address_count_phase_choice := 15;
      else
        pathsabove_read_address_count_phase_choice := (pathsabove_read_address_count_phase + 1) mod 16;
      end if;
      if line_starts_phases_5 then
        pathsabove_ready_top_choice := line_places_0_first_column or pathsabove_ready_top;
      else
        pathsabove_ready_top_choice := pathsabove_ready_top;
      end if;
      if line_starts_phases_5 then
        pathsabove_ready_top_choice_2 := (not line_places_0_first_column) and pathsabove_ready_top;
      else
        pathsabove_ready_top_choice_2 := pathsabove_ready_top;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_0_choice := 24;
      else
        pathsabove_total_0_choice := pathsabove_memory_ready_words_0 mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_1_choice := 24;
      else
        pathsabove_total_1_choice := ((pathsabove_memory_ready_words_1 mod 4) * 8) + (pathsabove_memory_ready_words_0 /
          32);
      end if;
      if pathsabove_ready_top then
        pathsabove_total_2_choice := 24;
      else
        pathsabove_total_2_choice := (pathsabove_memory_ready_words_1 / 4) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_3_choice := 24;
      else
        pathsabove_total_3_choice := ((pathsabove_memory_ready_words_2 mod 16) * 2) + (pathsabove_memory_ready_words_1
          / 128);
      end if;
      if pathsabove_ready_top then
        pathsabove_total_4_choice := 24;
      else
        pathsabove_total_4_choice := ((pathsabove_memory_ready_words_3 mod 2) * 16) + (pathsabove_memory_ready_words_2
          / 16);
      end if;
      if pathsabove_ready_top then
        pathsabove_total_5_choice := 24;
      else
        pathsabove_total_5_choice := (pathsabove_memory_ready_words_3 / 2) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_6_choice := 24;
      else
        pathsabove_total_6_choice := ((pathsabove_memory_ready_words_4 mod 8) * 4) + (pathsabove_memory_ready_words_3 /
          64);
      end if;
      if pathsabove_ready_top then
        pathsabove_total_7_choice := 24;
      else
        pathsabove_total_7_choice := pathsabove_memory_ready_words_4 / 8;
      end if;
      if line_comes_10 then
        pathsabove_smallest_total_choice := 63;
      else
        pathsabove_smallest_total_choice := pathsabove_smallest_total;
      end if;
      pathsabove_count_phase_is_equal := pathsabove_count_phase = 15;
      if pathsabove_count_phase_is_equal then
        pathsabove_count_phase_choice := 15;
      else
        pathsabove_count_phase_choice := (pathsabove_count_phase + 1) mod 16;
      end if;
      if pathsabove_count_phase = 0 then
        pathsabove_beside_0_choice := pathsabove_held_1;
      else
        pathsabove_beside_0_choice := pathsabove_lower_neighbour;
      end if;
      if pathsabove_count_phase_is_equal then
        pathsabove_beside_7_choice := pathsabove_held_6;
      else
        pathsabove_beside_7_choice := pathsabove_cost_0;
      end if;
      if line_places_1_first_column then
        pathsabove_write_address_address_choice := 0;
      else
        pathsabove_write_address_address_choice := (pathsabove_write_address_address + 1) mod 16384;
      end if;
      if pathsabove_write_address_count_phase = 15 then
        pathsabove_write_address_count_phase_choice := 15;
      else
        pathsabove_write_address_count_phase_choice := (pathsabove_write_address_count_phase + 1) mod 16;
      end if;
      pathsabove_memory_bank <= pathsabove_memory_bank_choice_2 / 4096;
      pathsabove_memory_read_bank <= pathsabove_memory_bank;
      pathsabove_memory_held_words_0_0 <= to_integer(pathsabove_memory_read_words_0_0);
      pathsabove_memory_held_words_0_1 <= to_integer(pathsabove_memory_read_words_0_1);
      pathsabove_memory_held_words_0_2 <= to_integer(pathsabove_memory_read_words_0_2);
      pathsabove_memory_held_words_0_3 <= to_integer(pathsabove_memory_read_words_0_3);
      pathsabove_memory_held_words_0_4 <= to_integer(pathsabove_memory_read_words_0_4);
      pathsabove_memory_held_words_1_0 <= to_integer(pathsabove_memory_read_words_1_0);
      pathsabove_memory_held_words_1_1 <= to_integer(pathsabove_memory_read_words_1_1);
      pathsabove_memory_held_words_1_2 <= to_integer(pathsabove_memory_read_words_1_2);
      pathsabove_memory_held_words_1_3 <= to_integer(pathsabove_memory_read_words_1_3);
      pathsabove_memory_held_words_1_4 <= to_integer(pathsabove_memory_read_words_1_4);
      pathsabove_memory_held_words_2_0 <= to_integer(pathsabove_memory_read_words_2_0);
      pathsabove_memory_held_words_2_1 <= to_integer(pathsabove_memory_read_words_2_1);
      pathsabove_memory_held_words_2_2 <= to_integer(pathsabove_memory_read_words_2_2);
      pathsabove_memory_held_words_2_3 <= to_integer(pathsabove_memory_read_words_2_3);
      pathsabove_memory_held_words_2_4 <= to_integer(pathsabove_memory_read_words_2_4);
      pathsabove_memory_held_bank <= pathsabove_memory_read_bank;
      pathsabove_read_address_address <= pathsabove_memory_bank_choice_2;
      pathsabove_total_0 <= costs_cost_0 + pathsabove_total_0_choice;
      pathsabove_total_1 <= costs_cost_1 + pathsabove_total_1_choice;
      pathsabove_total_2 <= costs_cost_2 + pathsabove_total_2_choice;
      pathsabove_total_3 <= costs_cost_3 + pathsabove_total_3_choice;
      pathsabove_total_4 <= costs_cost_4 + pathsabove_total_4_choice;
      pathsabove_total_5 <= costs_cost_5 + pathsabove_total_5_choice;
      pathsabove_total_6 <= costs_cost_6 + pathsabove_total_6_choice;
      pathsabove_total_7 <= costs_cost_7 + pathsabove_total_7_choice;
      pathsabove_cost_0 <= (to_integer(pathsabove_delay_held_0) - pathsabove_smallest) mod 64;
      pathsabove_cost_1 <= (to_integer(pathsabove_delay_held_0(29 downto 6)) - pathsabove_smallest) mod 64;
      pathsabove_cost_2 <= (to_integer(pathsabove_delay_held_0(29 downto 12)) - pathsabove_smallest) mod 64;
      pathsabove_cost_3 <= (to_integer(pathsabove_delay_held_0(29 downto 18)) - pathsabove_smallest) mod 64;
      pathsabove_cost_4 <= (to_integer(pathsabove_delay_held_0(29 downto 24)) - pathsabove_smallest) mod 64;
      pathsabove_cost_5 <= (to_integer(pathsabove_delay_held_1) - pathsabove_smallest) mod 64;
      pathsabove_cost_6 <= (to_integer(pathsabove_delay_held_1(17 downto 6)) - pathsabove_smallest) mod 64;
      pathsabove_cost_7 <= (to_integer(pathsabove_delay_held_1(17 downto 12)) - pathsabove_smallest) mod 64;
      pathsabove_held_0 <= pathsabove_cost_0;
      pathsabove_held_1 <= pathsabove_cost_1;
      pathsabove_held_2 <= pathsabove_cost_2;
      pathsabove_held_3 <= pathsabove_cost_3;
      pathsabove_held_4 <= pathsabove_cost_4;
      pathsabove_held_5 <= pathsabove_cost_5;
      pathsabove_held_6 <= pathsabove_cost_6;
      pathsabove_held_7 <= pathsabove_cost_7;
      pathsabove_lower_neighbour <= pathsabove_held_7;
      pathsabove_own_0 <= pathsabove_held_0;
      pathsabove_own_1 <= pathsabove_held_1;
      pathsabove_own_2 <= pathsabove_held_2;
      pathsabove_own_3 <= pathsabove_held_3;
      pathsabove_own_4 <= pathsabove_held_4;
      pathsabove_own_5 <= pathsabove_held_5;
      pathsabove_own_6 <= pathsabove_held_6;
      pathsabove_step_0 <= (((pathsabove_beside_0 / 4) + 1) * 4) + (pathsabove_beside_0 mod 4);
      pathsabove_step_1 <= (((pathsabove_beside_1 / 4) + 1) * 4) + (pathsabove_beside_1 mod 4);
      pathsabove_step_2 <= (((pathsabove_beside_2 / 4) + 1) * 4) + (pathsabove_beside_2 mod 4);
      pathsabove_step_3 <= (((pathsabove_beside_3 / 4) + 1) * 4) + (pathsabove_beside_3 mod 4);
      pathsabove_step_4 <= (((pathsabove_beside_4 / 4) + 1) * 4) + (pathsabove_beside_4 mod 4);
      pathsabove_step_5 <= (((pathsabove_beside_5 / 4) + 1) * 4) + (pathsabove_beside_5 mod 4);
      pathsabove_step_6 <= (((pathsabove_beside_6 / 4) + 1) * 4) + (pathsabove_beside_6 mod 4);
      pathsabove_step_7 <= (((pathsabove_beside_7 / 4) + 1) * 4) + (pathsabove_beside_7 mod 4);
      pathsabove_write_address_is_here <= (pathsabove_write_address_count_phase /= 15) or line_starts_phases_30;
      if line_starts_phases_2 then
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_choice;
        pathsabove_memory_read_address_2 <= pathsabove_memory_read_address_2_choice;
        pathsabove_read_address_count_phase <= 0;
      else
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_sum_2 mod 4096;
        pathsabove_memory_read_address_2 <= pathsabove_memory_read_address_0_sum_2 mod 16;
        pathsabove_read_address_count_phase <= pathsabove_read_address_count_phase_choice;
      end if;
      if pathsabove_memory_ready_words_0_is_equal then
        pathsabove_memory_ready_words_0 <= pathsabove_memory_held_words_2_0;
        pathsabove_memory_ready_words_1 <= pathsabove_memory_held_words_2_1;
        pathsabove_memory_ready_words_2 <= pathsabove_memory_held_words_2_2;
        pathsabove_memory_ready_words_3 <= pathsabove_memory_held_words_2_3;
        pathsabove_memory_ready_words_4 <= pathsabove_memory_held_words_2_4;
      else
        pathsabove_memory_ready_words_0 <= pathsabove_memory_ready_words_0_choice;
        pathsabove_memory_ready_words_1 <= pathsabove_memory_ready_words_1_choice;
        pathsabove_memory_ready_words_2 <= pathsabove_memory_ready_words_2_choice;
        pathsabove_memory_ready_words_3 <= pathsabove_memory_ready_words_3_choice;
        pathsabove_memory_ready_words_4 <= pathsabove_memory_ready_words_4_choice;
      end if;
      if line_places_0_top then
        pathsabove_ready_top <= pathsabove_ready_top_choice;
      else
        pathsabove_ready_top <= pathsabove_ready_top_choice_2;
      end if;
      if (pathsabove_total_1 - pathsabove_total_0) < 0 then
        pathsabove_tree_smallest_0 <= pathsabove_total_1;
      else
        pathsabove_tree_smallest_0 <= pathsabove_total_0;
      end if;
      if (pathsabove_total_3 - pathsabove_total_2) < 0 then
        pathsabove_tree_smallest_1 <= pathsabove_total_3;
      else
        pathsabove_tree_smallest_1 <= pathsabove_total_2;
      end if;
      if (pathsabove_total_5 - pathsabove_total_4) < 0 then
        pathsabove_tree_smallest_2 <= pathsabove_total_5;
      else
        pathsabove_tree_smallest_2 <= pathsabove_total_4;
      end if;
      if (pathsabove_total_7 - pathsabove_total_6) < 0 then
        pathsabove_tree_smallest_3 <= pathsabove_total_7;
      else
        pathsabove_tree_smallest_3 <= pathsabove_total_6;
      end if;
      if (pathsabove_tree_smallest_1 - pathsabove_tree_smallest_0) < 0 then
        pathsabove_tree_next_smallest_0 <= pathsabove_tree_smallest_1;
      else
        pathsabove_tree_next_smallest_0 <= pathsabove_tree_smallest_0;
      end if;
      if (pathsabove_tree_smallest_3 - pathsabove_tree_smallest_2) < 0 then
        pathsabove_tree_next_smallest_1 <= pathsabove_tree_smallest_3;
      else
        pathsabove_tree_next_smallest_1 <= pathsabove_tree_smallest_2;
      end if;
      if (pathsabove_tree_next_smallest_1 - pathsabove_tree_next_smallest_0) < 0 then
        pathsabove_tree_next_next_smallest_0 <= pathsabove_tree_next_smallest_1;
      else
        pathsabove_tree_next_next_smallest_0 <= pathsabove_tree_next_smallest_0;
      end if;
      if (pathsabove_tree_next_next_smallest_0 - pathsabove_smallest_total_choice) < 0 then
        pathsabove_smallest_total <= pathsabove_tree_next_next_smallest_0;
      else
        pathsabove_smallest_total <= pathsabove_smallest_total_choice;
      end if;
      if line_starts_phases_28 then
        pathsabove_count_phase <= 0;
      else
        pathsabove_count_phase <= pathsabove_count_phase_choice;
      end if;
      if (pathsabove_held_1 - pathsabove_beside_0_choice) < 0 then
        pathsabove_beside_0 <= pathsabove_held_1;
      else
        pathsabove_beside_0 <= pathsabove_beside_0_choice;
      end if;
      if (pathsabove_held_2 - pathsabove_held_0) < 0 then
        pathsabove_beside_1 <= pathsabove_held_2;
      else
        pathsabove_beside_1 <= pathsabove_held_0;
      end if;
      if (pathsabove_held_3 - pathsabove_held_1) < 0 then
        pathsabove_beside_2 <= pathsabove_held_3;
      else
        pathsabove_beside_2 <= pathsabove_held_1;
      end if;
      if (pathsabove_held_4 - pathsabove_held_2) < 0 then
        pathsabove_beside_3 <= pathsabove_held_4;
      else
        pathsabove_beside_3 <= pathsabove_held_2;
      end if;
      if (pathsabove_held_5 - pathsabove_held_3) < 0 then
        pathsabove_beside_4 <= pathsabove_held_5;
      else
        pathsabove_beside_4 <= pathsabove_held_3;
      end if;
      if (pathsabove_held_6 - pathsabove_held_4) < 0 then
        pathsabove_beside_5 <= pathsabove_held_6;
      else
        pathsabove_beside_5 <= pathsabove_held_4;
      end if;
      if (pathsabove_held_7 - pathsabove_held_5) < 0 then
        pathsabove_beside_6 <= pathsabove_held_7;
      else
        pathsabove_beside_6 <= pathsabove_held_5;
      end if;
      if (pathsabove_beside_7_choice - pathsabove_held_6) < 0 then
        pathsabove_beside_7 <= pathsabove_beside_7_choice;
      else
        pathsabove_beside_7 <= pathsabove_held_6;
      end if;
      if pathsabove_own_0 < 24 then
        pathsabove_stay_0 <= pathsabove_own_0 mod 32;
      else
        pathsabove_stay_0 <= 24;
      end if;
      if pathsabove_own_1 < 24 then
        pathsabove_stay_1 <= pathsabove_own_1 mod 32;
      else
        pathsabove_stay_1 <= 24;
      end if;
      if pathsabove_own_2 < 24 then
        pathsabove_stay_2 <= pathsabove_own_2 mod 32;
      else
        pathsabove_stay_2 <= 24;
      end if;
      if pathsabove_own_3 < 24 then
        pathsabove_stay_3 <= pathsabove_own_3 mod 32;
      else
        pathsabove_stay_3 <= 24;
      end if;
      if pathsabove_own_4 < 24 then
        pathsabove_stay_4 <= pathsabove_own_4 mod 32;
      else
        pathsabove_stay_4 <= 24;
      end if;
      if pathsabove_own_5 < 24 then
        pathsabove_stay_5 <= pathsabove_own_5 mod 32;
      else
        pathsabove_stay_5 <= 24;
      end if;
      if pathsabove_own_6 < 24 then
        pathsabove_stay_6 <= pathsabove_own_6 mod 32;
      else
        pathsabove_stay_6 <= 24;
      end if;
      if pathsabove_lower_neighbour < 24 then
        pathsabove_stay_7 <= pathsabove_lower_neighbour mod 32;
      else
        pathsabove_stay_7 <= 24;
      end if;
      if line_starts_phases_30 then
        pathsabove_write_address_address <= pathsabove_write_address_address_choice;
        pathsabove_write_address_count_phase <= 0;
      else
        pathsabove_write_address_address <= (pathsabove_write_address_address + as_number(((not
          ((pathsabove_write_address_count_phase / 8) = 1)) or (not (((pathsabove_write_address_count_phase / 4) mod 2)
          = 1)) or (not (((pathsabove_write_address_count_phase / 2) mod 2) = 1)) or (not
          ((pathsabove_write_address_count_phase mod 2) = 1))))) mod 16384;
        pathsabove_write_address_count_phase <= pathsabove_write_address_count_phase_choice;
      end if;
      pathsabove_memory_write_words_0_0_is_less := (pathsabove_step_1 - pathsabove_stay_1) < 0;
      if pathsabove_memory_write_words_0_0_is_less then
        pathsabove_memory_write_words_0_0_choice := pathsabove_step_1 mod 8;
      else
        pathsabove_memory_write_words_0_0_choice := pathsabove_stay_1 mod 8;
      end if;
      if (pathsabove_step_0 - pathsabove_stay_0) < 0 then
        pathsabove_memory_write_words_0_0_choice_2 := pathsabove_step_0 mod 32;
      else
        pathsabove_memory_write_words_0_0_choice_2 := pathsabove_stay_0;
      end if;
      pathsabove_memory_write_words_0_0_sum := (pathsabove_memory_write_words_0_0_choice * 32) +
        pathsabove_memory_write_words_0_0_choice_2;
      if pathsabove_memory_write_words_0_0_is_less then
        pathsabove_memory_write_words_0_1_choice := pathsabove_step_1 mod 32;
      else
        pathsabove_memory_write_words_0_1_choice := pathsabove_stay_1;
      end if;
      if (pathsabove_step_2 - pathsabove_stay_2) < 0 then
        pathsabove_memory_write_words_0_1_choice_2 := pathsabove_step_2 mod 32;
      else
        pathsabove_memory_write_words_0_1_choice_2 := pathsabove_stay_2;
      end if;
      pathsabove_memory_write_words_0_1_is_less := (pathsabove_step_3 - pathsabove_stay_3) < 0;
      if pathsabove_memory_write_words_0_1_is_less then
        pathsabove_memory_write_words_0_1_choice_3 := (pathsabove_step_3 mod 2) = 1;
      else
        pathsabove_memory_write_words_0_1_choice_3 := (pathsabove_stay_3 mod 2) = 1;
      end if;
      pathsabove_memory_write_words_0_1_sum := (pathsabove_memory_write_words_0_1_choice / 8) +
        (pathsabove_memory_write_words_0_1_choice_2 * 4) + (as_number(pathsabove_memory_write_words_0_1_choice_3) *
        128);
      if pathsabove_memory_write_words_0_1_is_less then
        pathsabove_memory_write_words_0_2_choice := pathsabove_step_3 mod 32;
      else
        pathsabove_memory_write_words_0_2_choice := pathsabove_stay_3;
      end if;
      pathsabove_memory_write_words_0_2_is_less := (pathsabove_step_4 - pathsabove_stay_4) < 0;
      if pathsabove_memory_write_words_0_2_is_less then
        pathsabove_memory_write_words_0_2_choice_2 := pathsabove_step_4 mod 16;
      else
        pathsabove_memory_write_words_0_2_choice_2 := pathsabove_stay_4 mod 16;
      end if;
      pathsabove_memory_write_words_0_2_sum := (pathsabove_memory_write_words_0_2_choice / 2) +
        (pathsabove_memory_write_words_0_2_choice_2 * 16);
      if pathsabove_memory_write_words_0_2_is_less then
        pathsabove_memory_write_words_0_3_choice := pathsabove_step_4 mod 32;
      else
        pathsabove_memory_write_words_0_3_choice := pathsabove_stay_4;
      end if;
      if (pathsabove_step_5 - pathsabove_stay_5) < 0 then
        pathsabove_memory_write_words_0_3_choice_2 := pathsabove_step_5 mod 32;
      else
        pathsabove_memory_write_words_0_3_choice_2 := pathsabove_stay_5;
      end if;
      pathsabove_memory_write_words_0_3_is_less := (pathsabove_step_6 - pathsabove_stay_6) < 0;
      if pathsabove_memory_write_words_0_3_is_less then
        pathsabove_memory_write_words_0_3_choice_3 := pathsabove_step_6 mod 4;
      else
        pathsabove_memory_write_words_0_3_choice_3 := pathsabove_stay_6 mod 4;
      end if;
      pathsabove_memory_write_words_0_3_sum := (pathsabove_memory_write_words_0_3_choice / 16) +
        (pathsabove_memory_write_words_0_3_choice_2 * 2) + (pathsabove_memory_write_words_0_3_choice_3 * 64);
      if pathsabove_memory_write_words_0_3_is_less then
        pathsabove_memory_write_words_0_4_choice := pathsabove_step_6 mod 32;
      else
        pathsabove_memory_write_words_0_4_choice := pathsabove_stay_6;
      end if;
      if (pathsabove_step_7 - pathsabove_stay_7) < 0 then
        pathsabove_memory_write_words_0_4_choice_2 := pathsabove_step_7 mod 32;
      else
        pathsabove_memory_write_words_0_4_choice_2 := pathsabove_stay_7;
      end if;
      pathsabove_memory_write_words_0_4_sum := (pathsabove_memory_write_words_0_4_choice / 4) +
        (pathsabove_memory_write_words_0_4_choice_2 * 8);
      pathsabove_memory_write_words_0_0_all := pathsabove_write_address_is_here and (pathsabove_write_address_address <
        4096);
      if pathsabove_memory_write_words_0_0_all then
        pathsabove_memory_write_words_0_0 <= pathsabove_memory_write_words_0_0_sum;
        pathsabove_memory_write_words_0_1 <= pathsabove_memory_write_words_0_1_sum;
        pathsabove_memory_write_words_0_2 <= pathsabove_memory_write_words_0_2_sum;
        pathsabove_memory_write_words_0_3 <= pathsabove_memory_write_words_0_3_sum;
        pathsabove_memory_write_words_0_4 <= pathsabove_memory_write_words_0_4_sum;
        pathsabove_memory_write_address_0 <= pathsabove_write_address_address mod 4096;
      end if;
      pathsabove_memory_write_words_1_0_all := pathsabove_write_address_is_here and ((pathsabove_write_address_address
        / 4096) = 1);
      if pathsabove_memory_write_words_1_0_all then
        pathsabove_memory_write_words_1_0 <= pathsabove_memory_write_words_0_0_sum;
        pathsabove_memory_write_words_1_1 <= pathsabove_memory_write_words_0_1_sum;
        pathsabove_memory_write_words_1_2 <= pathsabove_memory_write_words_0_2_sum;
        pathsabove_memory_write_words_1_3 <= pathsabove_memory_write_words_0_3_sum;
        pathsabove_memory_write_words_1_4 <= pathsabove_memory_write_words_0_4_sum;
        pathsabove_memory_write_address_1 <= pathsabove_write_address_address mod 4096;
      end if;
      pathsabove_memory_write_words_2_0_all := pathsabove_write_address_is_here and ((pathsabove_write_address_address
        / 4096) = 2);
      if pathsabove_memory_write_words_2_0_all then
        pathsabove_memory_write_words_2_0 <= pathsabove_memory_write_words_0_0_sum;
        pathsabove_memory_write_words_2_1 <= pathsabove_memory_write_words_0_1_sum;
        pathsabove_memory_write_words_2_2 <= pathsabove_memory_write_words_0_2_sum;
        pathsabove_memory_write_words_2_3 <= pathsabove_memory_write_words_0_3_sum;
        pathsabove_memory_write_words_2_4 <= pathsabove_memory_write_words_0_4_sum;
        pathsabove_memory_write_address_2 <= pathsabove_write_address_address mod 16;
      end if;
      if line_comes_26 then
        pathsabove_smallest <= pathsabove_smallest_total;
      end if;
      -- pathsturn
      pathsturn_sum_memory_ready_words_0_is_equal := pathsturn_sum_memory_held_bank = 2;
      pathsturn_sum_memory_ready_words_0_is_equal_2 := pathsturn_sum_memory_held_bank = 1;
      if pathsturn_sum_memory_ready_words_0_is_equal_2 then
        pathsturn_sum_memory_ready_words_0_choice := pathsturn_sum_memory_held_words_1_0;
      else
        pathsturn_sum_memory_ready_words_0_choice := pathsturn_sum_memory_held_words_0_0;
      end if;
      if pathsturn_sum_memory_ready_words_0_is_equal_2 then
        pathsturn_sum_memory_ready_words_1_choice := pathsturn_sum_memory_held_words_1_1;
      else
        pathsturn_sum_memory_ready_words_1_choice := pathsturn_sum_memory_held_words_0_1;
      end if;
      if pathsturn_sum_memory_ready_words_0_is_equal_2 then
        pathsturn_sum_memory_ready_words_2_choice := pathsturn_sum_memory_held_words_1_2;
      else
        pathsturn_sum_memory_ready_words_2_choice := pathsturn_sum_memory_held_words_0_2;
      end if;
      if pathsturn_sum_memory_ready_words_0_is_equal_2 then
        pathsturn_sum_memory_ready_words_3_choice := pathsturn_sum_memory_held_words_1_3;
      else
        pathsturn_sum_memory_ready_words_3_choice := pathsturn_sum_memory_held_words_0_3;
      end if;
      if pathsturn_sum_memory_ready_words_0_is_equal_2 then
        pathsturn_sum_memory_ready_words_4_choice := pathsturn_sum_memory_held_words_1_4;
      else
        pathsturn_sum_memory_ready_words_4_choice := pathsturn_sum_memory_held_words_0_4;
      end if;
      if pathsturn_sum_memory_ready_words_0_is_equal_2 then
        pathsturn_sum_memory_ready_words_5_choice := pathsturn_sum_memory_held_words_1_5;
      else
        pathsturn_sum_memory_ready_words_5_choice := pathsturn_sum_memory_held_words_0_5;
      end if;
      if pathsturn_sum_memory_ready_words_0_is_equal_2 then
        pathsturn_sum_memory_ready_words_6_choice := pathsturn_sum_memory_held_words_1_6;
      else
        pathsturn_sum_memory_ready_words_6_choice := pathsturn_sum_memory_held_words_0_6;
      end if;
      pathsturn_cost_memory_read_address_0_sum := pathsturn_read_address_address + as_number(((not
        ((pathsturn_read_address_count_phase / 8) = 1)) or (not (((pathsturn_read_address_count_phase / 4) mod 2) = 1))
        or (not (((pathsturn_read_address_count_phase / 2) mod 2) = 1)) or (not ((pathsturn_read_address_count_phase
        mod 2) = 1))));
      if line_starts_phases_22 then
        pathsturn_cost_memory_bank_choice := line_places_1_address * 16;
      else
        pathsturn_cost_memory_bank_choice := pathsturn_cost_memory_read_address_0_sum mod 16384;
      end if;
      pathsturn_cost_memory_ready_words_0_is_equal := pathsturn_sum_memory_bank = 2;
      pathsturn_cost_memory_ready_words_0_is_equal_2 := pathsturn_sum_memory_bank = 1;
      if pathsturn_cost_memory_ready_words_0_is_equal_2 then
        pathsturn_cost_memory_ready_words_0_choice := pathsturn_cost_memory_held_words_1_0;
      else
        pathsturn_cost_memory_ready_words_0_choice := pathsturn_cost_memory_held_words_0_0;
      end if;
      if pathsturn_cost_memory_ready_words_0_is_equal_2 then
        pathsturn_cost_memory_ready_words_1_choice := pathsturn_cost_memory_held_words_1_1;
      else
        pathsturn_cost_memory_ready_words_1_choice := pathsturn_cost_memory_held_words_0_1;
      end if;
      if pathsturn_cost_memory_ready_words_0_is_equal_2 then
        pathsturn_cost_memory_ready_words_2_choice := pathsturn_cost_memory_held_words_1_2;
      else
        pathsturn_cost_memory_ready_words_2_choice := pathsturn_cost_memory_held_words_0_2;
      end if;
      if pathsturn_cost_memory_ready_words_0_is_equal_2 then
        pathsturn_cost_memory_ready_words_3_choice := pathsturn_cost_memory_held_words_1_3;
      else
        pathsturn_cost_memory_ready_words_3_choice := pathsturn_cost_memory_held_words_0_3;
      end if;
      if pathsturn_read_address_count_phase = 15 then
        pathsturn_read_address_count_phase_choice := 15;
      else
        pathsturn_read_address_count_phase_choice := (pathsturn_read_address_count_phase + 1) mod 16;
      end if;
      if pathsturn_write_address_count_phase = 15 then
        pathsturn_write_address_count_phase_choice := 15;
      else
        pathsturn_write_address_count_phase_choice := (pathsturn_write_address_count_phase + 1) mod 16;
      end if;
      pathsturn_sum_memory_read_address_0 <= pathsturn_sum_read_address mod 4096;
      pathsturn_sum_memory_read_address_2 <= pathsturn_sum_read_address mod 16;
      pathsturn_sum_memory_bank <= pathsturn_cost_memory_read_bank;
      pathsturn_sum_memory_read_bank <= pathsturn_cost_memory_held_bank;
      pathsturn_sum_memory_held_words_0_0 <= to_integer(pathsturn_sum_memory_read_words_0_0);
      pathsturn_sum_memory_held_words_0_1 <= to_integer(pathsturn_sum_memory_read_words_0_1);
      pathsturn_sum_memory_held_words_0_2 <= to_integer(pathsturn_sum_memory_read_words_0_2);
      pathsturn_sum_memory_held_words_0_3 <= to_integer(pathsturn_sum_memory_read_words_0_3);
      pathsturn_sum_memory_held_words_0_4 <= to_integer(pathsturn_sum_memory_read_words_0_4);
      pathsturn_sum_memory_held_words_0_5 <= to_integer(pathsturn_sum_memory_read_words_0_5);
      pathsturn_sum_memory_held_words_0_6 <= to_integer(pathsturn_sum_memory_read_words_0_6);
      pathsturn_sum_memory_held_words_1_0 <= to_integer(pathsturn_sum_memory_read_words_1_0);
      pathsturn_sum_memory_held_words_1_1 <= to_integer(pathsturn_sum_memory_read_words_1_1);
      pathsturn_sum_memory_held_words_1_2 <= to_integer(pathsturn_sum_memory_read_words_1_2);
      pathsturn_sum_memory_held_words_1_3 <= to_integer(pathsturn_sum_memory_read_words_1_3);
      pathsturn_sum_memory_held_words_1_4 <= to_integer(pathsturn_sum_memory_read_words_1_4);
      pathsturn_sum_memory_held_words_1_5 <= to_integer(pathsturn_sum_memory_read_words_1_5);
      pathsturn_sum_memory_held_words_1_6 <= to_integer(pathsturn_sum_memory_read_words_1_6);
      pathsturn_sum_memory_held_words_2_0 <= to_integer(pathsturn_sum_memory_read_words_2_0);
      pathsturn_sum_memory_held_words_2_1 <= to_integer(pathsturn_sum_memory_read_words_2_1);
      pathsturn_sum_memory_held_words_2_2 <= to_integer(pathsturn_sum_memory_read_words_2_2);
      pathsturn_sum_memory_held_words_2_3 <= to_integer(pathsturn_sum_memory_read_words_2_3);
      pathsturn_sum_memory_held_words_2_4 <= to_integer(pathsturn_sum_memory_read_words_2_4);
      pathsturn_sum_memory_held_words_2_5 <= to_integer(pathsturn_sum_memory_read_words_2_5);
      pathsturn_sum_memory_held_words_2_6 <= to_integer(pathsturn_sum_memory_read_words_2_6);
      pathsturn_sum_memory_held_bank <= pathsturn_sum_memory_read_bank;
      pathsturn_cost_memory_bank <= pathsturn_cost_memory_bank_choice / 4096;
      pathsturn_cost_memory_read_bank <= pathsturn_cost_memory_bank;
      pathsturn_cost_memory_held_words_0_0 <= to_integer(pathsturn_cost_memory_read_words_0_0);
      pathsturn_cost_memory_held_words_0_1 <= to_integer(pathsturn_cost_memory_read_words_0_1);
      pathsturn_cost_memory_held_words_0_2 <= to_integer(pathsturn_cost_memory_read_words_0_2);
      pathsturn_cost_memory_held_words_0_3 <= to_integer(pathsturn_cost_memory_read_words_0_3);
      pathsturn_cost_memory_held_words_1_0 <= to_integer(pathsturn_cost_memory_read_words_1_0);
      pathsturn_cost_memory_held_words_1_1 <= to_integer(pathsturn_cost_memory_read_words_1_1);
      pathsturn_cost_memory_held_words_1_2 <= to_integer(pathsturn_cost_memory_read_words_1_2);
      pathsturn_cost_memory_held_words_1_3 <= to_integer(pathsturn_cost_memory_read_words_1_3);
      pathsturn_cost_memory_held_words_2_0 <= to_integer(pathsturn_cost_memory_read_words_2_0);
      pathsturn_cost_memory_held_words_2_1 <= to_integer(pathsturn_cost_memory_read_words_2_1);
      pathsturn_cost_memory_held_words_2_2 <= to_integer(pathsturn_cost_memory_read_words_2_2);
      pathsturn_cost_memory_held_words_2_3 <= to_integer(pathsturn_cost_memory_read_words_2_3);
      pathsturn_cost_memory_held_bank <= pathsturn_sum_read_address / 4096;
      pathsturn_ready_smallest_0 <= to_integer(pathsturn_read_smallest_0);
      pathsturn_read_address_address <= pathsturn_cost_memory_bank_choice;
      pathsturn_sum_read_address <= pathsturn_read_address_address;
      pathsturn_write_smallest_0 <= paths_smallest_cost;
      pathsturn_write_address_is_here <= (pathsturn_write_address_count_phase /= 15) or line_starts_phases_25;
      pathsturn_sum_write_address_0 <= pathsturn_write_address_address;
      pathsturn_sum_write_address_1 <= pathsturn_sum_write_address_0;
      pathsturn_writes_sums_0 <= pathsturn_write_address_is_here;
      pathsturn_writes_sums_1 <= pathsturn_writes_sums_0;
      if pathsturn_sum_memory_ready_words_0_is_equal then
        pathsturn_sum_memory_ready_words_0 <= pathsturn_sum_memory_held_words_2_0;
        pathsturn_sum_memory_ready_words_1 <= pathsturn_sum_memory_held_words_2_1;
        pathsturn_sum_memory_ready_words_2 <= pathsturn_sum_memory_held_words_2_2;
        pathsturn_sum_memory_ready_words_3 <= pathsturn_sum_memory_held_words_2_3;
        pathsturn_sum_memory_ready_words_4 <= pathsturn_sum_memory_held_words_2_4;
        pathsturn_sum_memory_ready_words_5 <= pathsturn_sum_memory_held_words_2_5;
        pathsturn_sum_memory_ready_words_6 <= pathsturn_sum_memory_held_words_2_6;
      else
        pathsturn_sum_memory_ready_words_0 <= pathsturn_sum_memory_ready_words_0_choice;
        pathsturn_sum_memory_ready_words_1 <= pathsturn_sum_memory_ready_words_1_choice;
        pathsturn_sum_memory_ready_words_2 <= pathsturn_sum_memory_ready_words_2_choice;
        pathsturn_sum_memory_ready_words_3 <= pathsturn_sum_memory_ready_words_3_choice;
        pathsturn_sum_memory_ready_words_4 <= pathsturn_sum_memory_ready_words_4_choice;
        pathsturn_sum_memory_ready_words_5 <= pathsturn_sum_memory_ready_words_5_choice;
        pathsturn_sum_memory_ready_words_6 <= pathsturn_sum_memory_ready_words_6_choice;
      end if;
      if line_starts_phases_22 then
        pathsturn_cost_memory_read_address_0 <= (line_places_1_address mod 256) * 16;
        pathsturn_cost_memory_read_address_2 <= 0;
        pathsturn_read_address_count_phase <= 0;
      else
        pathsturn_cost_memory_read_address_0 <= pathsturn_cost_memory_read_address_0_sum mod 4096;
        pathsturn_cost_memory_read_address_2 <= pathsturn_cost_memory_read_address_0_sum mod 16;
        pathsturn_read_address_count_phase <= pathsturn_read_address_count_phase_choice;
      end if;
      if pathsturn_cost_memory_ready_words_0_is_equal then
        pathsturn_cost_memory_ready_words_0 <= pathsturn_cost_memory_held_words_2_0;
        pathsturn_cost_memory_ready_words_1 <= pathsturn_cost_memory_held_words_2_1;
        pathsturn_cost_memory_ready_words_2 <= pathsturn_cost_memory_held_words_2_2;
        pathsturn_cost_memory_ready_words_3 <= pathsturn_cost_memory_held_words_2_3;
      else
        pathsturn_cost_memory_ready_words_0 <= pathsturn_cost_memory_ready_words_0_choice;
        pathsturn_cost_memory_ready_words_1 <= pathsturn_cost_memory_ready_words_1_choice;
        pathsturn_cost_memory_ready_words_2 <= pathsturn_cost_memory_ready_words_2_choice;
        pathsturn_cost_memory_ready_words_3 <= pathsturn_cost_memory_ready_words_3_choice;
      end if;
      if line_starts_phases_25 then
        pathsturn_write_smallest_address <= line_places_1_address;
        pathsturn_write_address_address <= line_places_1_address * 16;
        pathsturn_write_address_count_phase <= 0;
      else
        pathsturn_write_smallest_address <= 513;
        pathsturn_write_address_address <= (pathsturn_write_address_address + as_number(((not
          ((pathsturn_write_address_count_phase / 8) = 1)) or (not (((pathsturn_write_address_count_phase / 4) mod 2) =
          1)) or (not (((pathsturn_write_address_count_phase / 2) mod 2) = 1)) or (not
          ((pathsturn_write_address_count_phase mod 2) = 1))))) mod 16384;
        pathsturn_write_address_count_phase <= pathsturn_write_address_count_phase_choice;
      end if;
      pathsturn_sum_memory_write_words_0_0_sum := pathsleft_cost_1 + pathsabove_cost_1;
      pathsturn_sum_memory_write_words_0_0_sum_2 := pathsleft_cost_0 + pathsabove_cost_0 +
        ((pathsturn_sum_memory_write_words_0_0_sum mod 2) * 128);
      pathsturn_sum_memory_write_words_0_1_sum := pathsleft_cost_2 + pathsabove_cost_2;
      pathsturn_sum_memory_write_words_0_1_sum_2 := (pathsturn_sum_memory_write_words_0_0_sum / 2) +
        ((pathsturn_sum_memory_write_words_0_1_sum mod 4) * 64);
      pathsturn_sum_memory_write_words_0_2_sum := pathsleft_cost_3 + pathsabove_cost_3;
      pathsturn_sum_memory_write_words_0_2_sum_2 := (pathsturn_sum_memory_write_words_0_1_sum / 4) +
        ((pathsturn_sum_memory_write_words_0_2_sum mod 8) * 32);
      pathsturn_sum_memory_write_words_0_3_sum := pathsleft_cost_4 + pathsabove_cost_4;
      pathsturn_sum_memory_write_words_0_3_sum_2 := (pathsturn_sum_memory_write_words_0_2_sum / 8) +
        ((pathsturn_sum_memory_write_words_0_3_sum mod 16) * 16);
      pathsturn_sum_memory_write_words_0_4_sum := pathsleft_cost_5 + pathsabove_cost_5;
      pathsturn_sum_memory_write_words_0_4_sum_2 := (pathsturn_sum_memory_write_words_0_3_sum / 16) +
        ((pathsturn_sum_memory_write_words_0_4_sum mod 32) * 8);
      pathsturn_sum_memory_write_words_0_5_sum := pathsleft_cost_6 + pathsabove_cost_6;
      pathsturn_sum_memory_write_words_0_5_sum_2 := (pathsturn_sum_memory_write_words_0_4_sum / 32) +
        ((pathsturn_sum_memory_write_words_0_5_sum mod 64) * 4);
      pathsturn_sum_memory_write_words_0_6_sum := (pathsturn_sum_memory_write_words_0_5_sum / 64) + ((pathsleft_cost_7
        + pathsabove_cost_7) * 2);
      pathsturn_sum_memory_write_words_0_0_all := (pathsturn_sum_write_address_1 < 4096) and pathsturn_writes_sums_1;
      if pathsturn_sum_memory_write_words_0_0_all then
        pathsturn_sum_memory_write_words_0_0 <= pathsturn_sum_memory_write_words_0_0_sum_2;
        pathsturn_sum_memory_write_words_0_1 <= pathsturn_sum_memory_write_words_0_1_sum_2;
        pathsturn_sum_memory_write_words_0_2 <= pathsturn_sum_memory_write_words_0_2_sum_2;
        pathsturn_sum_memory_write_words_0_3 <= pathsturn_sum_memory_write_words_0_3_sum_2;
        pathsturn_sum_memory_write_words_0_4 <= pathsturn_sum_memory_write_words_0_4_sum_2;
        pathsturn_sum_memory_write_words_0_5 <= pathsturn_sum_memory_write_words_0_5_sum_2;
        pathsturn_sum_memory_write_words_0_6 <= pathsturn_sum_memory_write_words_0_6_sum;
        pathsturn_sum_memory_write_address_0 <= pathsturn_sum_write_address_1 mod 4096;
      end if;
      pathsturn_sum_memory_write_words_1_0_all := pathsturn_writes_sums_1 and ((pathsturn_sum_write_address_1 / 4096) =
        1);
      if pathsturn_sum_memory_write_words_1_0_all then
        pathsturn_sum_memory_write_words_1_0 <= pathsturn_sum_memory_write_words_0_0_sum_2;
        pathsturn_sum_memory_write_words_1_1 <= pathsturn_sum_memory_write_words_0_1_sum_2;
        pathsturn_sum_memory_write_words_1_2 <= pathsturn_sum_memory_write_words_0_2_sum_2;
        pathsturn_sum_memory_write_words_1_3 <= pathsturn_sum_memory_write_words_0_3_sum_2;
        pathsturn_sum_memory_write_words_1_4 <= pathsturn_sum_memory_write_words_0_4_sum_2;
        pathsturn_sum_memory_write_words_1_5 <= pathsturn_sum_memory_write_words_0_5_sum_2;
        pathsturn_sum_memory_write_words_1_6 <= pathsturn_sum_memory_write_words_0_6_sum;
        pathsturn_sum_memory_write_address_1 <= pathsturn_sum_write_address_1 mod 4096;
      end if;
      pathsturn_sum_memory_write_words_2_0_all := pathsturn_writes_sums_1 and ((pathsturn_sum_write_address_1 / 4096) =
        2);
      if pathsturn_sum_memory_write_words_2_0_all then
        pathsturn_sum_memory_write_words_2_0 <= pathsturn_sum_memory_write_words_0_0_sum_2;
        pathsturn_sum_memory_write_words_2_1 <= pathsturn_sum_memory_write_words_0_1_sum_2;
        pathsturn_sum_memory_write_words_2_2 <= pathsturn_sum_memory_write_words_0_2_sum_2;
        pathsturn_sum_memory_write_words_2_3 <= pathsturn_sum_memory_write_words_0_3_sum_2;
        pathsturn_sum_memory_write_words_2_4 <= pathsturn_sum_memory_write_words_0_4_sum_2;
        pathsturn_sum_memory_write_words_2_5 <= pathsturn_sum_memory_write_words_0_5_sum_2;
        pathsturn_sum_memory_write_words_2_6 <= pathsturn_sum_memory_write_words_0_6_sum;
        pathsturn_sum_memory_write_address_2 <= pathsturn_sum_write_address_1 mod 16;
      end if;
      pathsturn_cost_memory_write_words_0_1_value := to_integer(paths_cost_delay_held_0(15 downto 8));
      pathsturn_cost_memory_write_words_0_2_value := to_integer(paths_cost_delay_held_0(23 downto 16));
      pathsturn_cost_memory_write_words_0_0_all := pathsturn_write_address_is_here and (pathsturn_write_address_address
        < 4096);
      if pathsturn_cost_memory_write_words_0_0_all then
        pathsturn_cost_memory_write_words_0_0 <= to_integer(paths_cost_delay_held_0(7 downto 0));
        pathsturn_cost_memory_write_words_0_1 <= pathsturn_cost_memory_write_words_0_1_value;
        pathsturn_cost_memory_write_words_0_2 <= pathsturn_cost_memory_write_words_0_2_value;
        pathsturn_cost_memory_write_words_0_3 <= to_integer(paths_cost_delay_held_0(31 downto 24));
        pathsturn_cost_memory_write_address_0 <= pathsturn_write_address_address mod 4096;
      end if;
      pathsturn_cost_memory_write_words_1_0_all := pathsturn_write_address_is_here and
        ((pathsturn_write_address_address / 4096) = 1);
      if pathsturn_cost_memory_write_words_1_0_all then
        pathsturn_cost_memory_write_words_1_0 <= to_integer(paths_cost_delay_held_0(7 downto 0));
        pathsturn_cost_memory_write_words_1_1 <= pathsturn_cost_memory_write_words_0_1_value;
        pathsturn_cost_memory_write_words_1_2 <= pathsturn_cost_memory_write_words_0_2_value;
        pathsturn_cost_memory_write_words_1_3 <= to_integer(paths_cost_delay_held_0(31 downto 24));
        pathsturn_cost_memory_write_address_1 <= pathsturn_write_address_address mod 4096;
      end if;
      pathsturn_cost_memory_write_words_2_0_all := pathsturn_write_address_is_here and
        ((pathsturn_write_address_address / 4096) = 2);
      if pathsturn_cost_memory_write_words_2_0_all then
        pathsturn_cost_memory_write_words_2_0 <= to_integer(paths_cost_delay_held_0(7 downto 0));
        pathsturn_cost_memory_write_words_2_1 <= pathsturn_cost_memory_write_words_0_1_value;
        pathsturn_cost_memory_write_words_2_2 <= pathsturn_cost_memory_write_words_0_2_value;
        pathsturn_cost_memory_write_words_2_3 <= to_integer(paths_cost_delay_held_0(31 downto 24));
        pathsturn_cost_memory_write_address_2 <= pathsturn_write_address_address mod 16;
      end if;
      if line_starts_phases_22 then
        pathsturn_smallest_address <= line_places_1_address;
      end if;
      -- pathsright
      pathsright_lower_neighbour_value := to_integer(pathsright_read_words_1(17 downto 12));
      pathsright_stay_0_value := to_integer(pathsright_read_words_1(23 downto 18));
      if (pathsright_stay_0_value - to_integer(pathsright_read_words_0(5 downto 0))) < 0 then
        pathsright_stay_0_choice := pathsright_stay_0_value;
      else
        pathsright_stay_0_choice := to_integer(pathsright_read_words_0(5 downto 0));
      end if;
      pathsright_stay_1_value := to_integer(pathsright_read_words_0(11 downto 6));
      if (to_integer(pathsright_read_words_1(29 downto 24)) - pathsright_stay_1_value) < 0 then
        pathsright_stay_1_choice := to_integer(pathsright_read_words_1(29 downto 24));
      else
        pathsright_stay_1_choice := pathsright_stay_1_value;
      end if;
      pathsright_stay_2_value := to_integer(pathsright_read_words_0(17 downto 12));
      if (to_integer(pathsright_read_words_2(5 downto 0)) - pathsright_stay_2_value) < 0 then
        pathsright_stay_2_choice := to_integer(pathsright_read_words_2(5 downto 0));
      else
        pathsright_stay_2_choice := pathsright_stay_2_value;
      end if;
      pathsright_stay_3_value := to_integer(pathsright_read_words_2(11 downto 6));
      pathsright_stay_3_value_2 := to_integer(pathsright_read_words_0(23 downto 18));
      if (pathsright_stay_3_value - pathsright_stay_3_value_2) < 0 then
        pathsright_stay_3_choice := pathsright_stay_3_value;
      else
        pathsright_stay_3_choice := pathsright_stay_3_value_2;
      end if;
      pathsright_stay_4_value := to_integer(pathsright_read_words_2(17 downto 12));
      if (pathsright_stay_4_value - to_integer(pathsright_read_words_0(29 downto 24))) < 0 then
        pathsright_stay_4_choice := pathsright_stay_4_value;
      else
        pathsright_stay_4_choice := to_integer(pathsright_read_words_0(29 downto 24));
      end if;
      pathsright_stay_5_value := to_integer(pathsright_read_words_2(23 downto 18));
      if (pathsright_stay_5_value - to_integer(pathsright_read_words_1(5 downto 0))) < 0 then
        pathsright_stay_5_choice := pathsright_stay_5_value;
      else
        pathsright_stay_5_choice := to_integer(pathsright_read_words_1(5 downto 0));
      end if;
      pathsright_stay_6_value := to_integer(pathsright_read_words_1(11 downto 6));
      if (to_integer(pathsright_read_words_2(29 downto 24)) - pathsright_stay_6_value) < 0 then
        pathsright_stay_6_choice := to_integer(pathsright_read_words_2(29 downto 24));
      else
        pathsright_stay_6_choice := pathsright_stay_6_value;
      end if;
      if (to_integer(pathsright_read_words_3) - pathsright_lower_neighbour_value) < 0 then
        pathsright_stay_7_choice := to_integer(pathsright_read_words_3);
      else
        pathsright_stay_7_choice := pathsright_lower_neighbour_value;
      end if;
      if line_starts_phases_26 then
        pathsright_step_0_choice := pathsright_stay_1_value;
      else
        pathsright_step_0_choice := pathsright_lower_neighbour;
      end if;
      if (pathsright_stay_1_value - pathsright_step_0_choice) < 0 then
        pathsright_step_0_choice_2 := pathsright_stay_1_value;
      else
        pathsright_step_0_choice_2 := pathsright_step_0_choice;
      end if;
      if (pathsright_stay_2_value - to_integer(pathsright_read_words_0(5 downto 0))) < 0 then
        pathsright_step_1_choice := pathsright_stay_2_value;
      else
        pathsright_step_1_choice := to_integer(pathsright_read_words_0(5 downto 0));
      end if;
      if (pathsright_stay_3_value_2 - pathsright_stay_1_value) < 0 then
        pathsright_step_2_choice := pathsright_stay_3_value_2;
      else
        pathsright_step_2_choice := pathsright_stay_1_value;
      end if;
      if (to_integer(pathsright_read_words_0(29 downto 24)) - pathsright_stay_2_value) < 0 then
        pathsright_step_3_choice := to_integer(pathsright_read_words_0(29 downto 24));
      else
        pathsright_step_3_choice := pathsright_stay_2_value;
      end if;
      if (to_integer(pathsright_read_words_1(5 downto 0)) - pathsright_stay_3_value_2) < 0 then
        pathsright_step_4_choice := to_integer(pathsright_read_words_1(5 downto 0));
      else
        pathsright_step_4_choice := pathsright_stay_3_value_2;
      end if;
      if (pathsright_stay_6_value - to_integer(pathsright_read_words_0(29 downto 24))) < 0 then
        pathsright_step_5_choice := pathsright_stay_6_value;
      else
        pathsright_step_5_choice := to_integer(pathsright_read_words_0(29 downto 24));
      end if;
      if (pathsright_lower_neighbour_value - to_integer(pathsright_read_words_1(5 downto 0))) < 0 then
        pathsright_step_6_choice := pathsright_lower_neighbour_value;
      else
        pathsright_step_6_choice := to_integer(pathsright_read_words_1(5 downto 0));
      end if;
      if pathsleft_is_last then
        pathsright_step_7_choice := pathsright_stay_6_value;
      else
        pathsright_step_7_choice := to_integer(pathsright_read_neighbour_0);
      end if;
      if (pathsright_step_7_choice - pathsright_stay_6_value) < 0 then
        pathsright_step_7_choice_2 := pathsright_step_7_choice;
      else
        pathsright_step_7_choice_2 := pathsright_stay_6_value;
      end if;
      if line_comes_31 then
        pathsright_low_0_choice := 63;
      else
        pathsright_low_0_choice := pathsright_low_0;
      end if;
      pathsright_lost <= to_integer(pathsright_lowest_0(5 downto 5)) = 1;
      pathsright_short_of <= ((to_integer(pathsright_lowest_0(4 downto 0)) + pathsright_room) / 32) = 1;
      pathsright_missing <= (to_integer(pathsright_lowest_0) + pathsright_room) mod 32;
      pathsright_below <= (0 - to_integer(pathsright_lowest_0)) mod 32;
      pathsright_lower_neighbour <= pathsright_lower_neighbour_value;
      pathsright_stay_change_0 <= ((pathsturn_cost_memory_ready_words_0 mod 16) - pathsright_g) mod 64;
      pathsright_stay_change_1 <= ((pathsturn_cost_memory_ready_words_0 / 16) - pathsright_g) mod 64;
      pathsright_stay_change_2 <= ((pathsturn_cost_memory_ready_words_1 mod 16) - pathsright_g) mod 64;
      pathsright_stay_change_3 <= ((pathsturn_cost_memory_ready_words_1 / 16) - pathsright_g) mod 64;
      pathsright_stay_change_4 <= ((pathsturn_cost_memory_ready_words_2 mod 16) - pathsright_g) mod 64;
      pathsright_stay_change_5 <= ((pathsturn_cost_memory_ready_words_2 / 16) - pathsright_g) mod 64;
      pathsright_stay_change_6 <= ((pathsturn_cost_memory_ready_words_3 mod 16) - pathsright_g) mod 64;
      pathsright_stay_change_7 <= ((pathsturn_cost_memory_ready_words_3 / 16) - pathsright_g) mod 64;
      pathsright_step_change_0 <= ((pathsturn_cost_memory_ready_words_0 mod 16) - pathsright_g_less) mod 64;
      pathsright_step_change_1 <= ((pathsturn_cost_memory_ready_words_0 / 16) - pathsright_g_less) mod 64;
      pathsright_step_change_2 <= ((pathsturn_cost_memory_ready_words_1 mod 16) - pathsright_g_less) mod 64;
      pathsright_step_change_3 <= ((pathsturn_cost_memory_ready_words_1 / 16) - pathsright_g_less) mod 64;
      pathsright_step_change_4 <= ((pathsturn_cost_memory_ready_words_2 mod 16) - pathsright_g_less) mod 64;
      pathsright_step_change_5 <= ((pathsturn_cost_memory_ready_words_2 / 16) - pathsright_g_less) mod 64;
      pathsright_step_change_6 <= ((pathsturn_cost_memory_ready_words_3 mod 16) - pathsright_g_less) mod 64;
      pathsright_step_change_7 <= ((pathsturn_cost_memory_ready_words_3 / 16) - pathsright_g_less) mod 64;
      if (not pathsleft_first) and (not ((pathsright_stay_0_choice / 32) = 1)) then
        pathsright_stay_0 <= pathsright_stay_0_choice;
      else
        pathsright_stay_0 <= 32;
      end if;
      if (not ((pathsright_stay_1_choice / 32) = 1)) and (not pathsleft_first) then
        pathsright_stay_1 <= pathsright_stay_1_choice;
      else
        pathsright_stay_1 <= 32;
      end if;
      if (not ((pathsright_stay_2_choice / 32) = 1)) and (not pathsleft_first) then
        pathsright_stay_2 <= pathsright_stay_2_choice;
      else
        pathsright_stay_2 <= 32;
      end if;
      if (not ((pathsright_stay_3_choice / 32) = 1)) and (not pathsleft_first) then
        pathsright_stay_3 <= pathsright_stay_3_choice;
      else
        pathsright_stay_3 <= 32;
      end if;
      if (not ((pathsright_stay_4_choice / 32) = 1)) and (not pathsleft_first) then
        pathsright_stay_4 <= pathsright_stay_4_choice;
      else
        pathsright_stay_4 <= 32;
      end if;
      if (not ((pathsright_stay_5_choice / 32) = 1)) and (not pathsleft_first) then
        pathsright_stay_5 <= pathsright_stay_5_choice;
      else
        pathsright_stay_5 <= 32;
      end if;
      if (not ((pathsright_stay_6_choice / 32) = 1)) and (not pathsleft_first) then
        pathsright_stay_6 <= pathsright_stay_6_choice;
      else
        pathsright_stay_6 <= 32;
      end if;
      if (not ((pathsright_stay_7_choice / 32) = 1)) and (not pathsleft_first) then
        pathsright_stay_7 <= pathsright_stay_7_choice;
      else
        pathsright_stay_7 <= 32;
      end if;
      if pathsleft_first then
        pathsright_step_0 <= 32;
        pathsright_step_1 <= 32;
        pathsright_step_2 <= 32;
        pathsright_step_3 <= 32;
        pathsright_step_4 <= 32;
        pathsright_step_5 <= 32;
        pathsright_step_6 <= 32;
        pathsright_step_7 <= 32;
      else
        pathsright_step_0 <= pathsright_step_0_choice_2;
        pathsright_step_1 <= pathsright_step_1_choice;
        pathsright_step_2 <= pathsright_step_2_choice;
        pathsright_step_3 <= pathsright_step_3_choice;
        pathsright_step_4 <= pathsright_step_4_choice;
        pathsright_step_5 <= pathsright_step_5_choice;
        pathsright_step_6 <= pathsright_step_6_choice;
        pathsright_step_7 <= pathsright_step_7_choice_2;
      end if;
      if (pathsright_cost_1 - pathsright_cost_0) < 0 then
        pathsright_tree_smallest_0 <= pathsright_cost_1;
      else
        pathsright_tree_smallest_0 <= pathsright_cost_0;
      end if;
      if (pathsright_cost_3 - pathsright_cost_2) < 0 then
        pathsright_tree_smallest_1 <= pathsright_cost_3;
      else
        pathsright_tree_smallest_1 <= pathsright_cost_2;
      end if;
      if (pathsright_cost_5 - pathsright_cost_4) < 0 then
        pathsright_tree_smallest_2 <= pathsright_cost_5;
      else
        pathsright_tree_smallest_2 <= pathsright_cost_4;
      end if;
      if (pathsright_cost_7 - pathsright_cost_6) < 0 then
        pathsright_tree_smallest_3 <= pathsright_cost_7;
      else
        pathsright_tree_smallest_3 <= pathsright_cost_6;
      end if;
      if (pathsright_tree_smallest_1 - pathsright_tree_smallest_0) < 0 then
        pathsright_tree_next_smallest_0 <= pathsright_tree_smallest_1;
      else
        pathsright_tree_next_smallest_0 <= pathsright_tree_smallest_0;
      end if;
      if (pathsright_tree_smallest_3 - pathsright_tree_smallest_2) < 0 then
        pathsright_tree_next_smallest_1 <= pathsright_tree_smallest_3;
      else
        pathsright_tree_next_smallest_1 <= pathsright_tree_smallest_2;
      end if;
      if (pathsright_tree_next_smallest_1 - pathsright_tree_next_smallest_0) < 0 then
        pathsright_tree_next_next_smallest_0 <= pathsright_tree_next_smallest_1;
      else
        pathsright_tree_next_next_smallest_0 <= pathsright_tree_next_smallest_0;
      end if;
      if (pathsright_tree_next_next_smallest_0 - pathsright_low_0_choice) < 0 then
        pathsright_low_0 <= pathsright_tree_next_next_smallest_0;
      else
        pathsright_low_0 <= pathsright_low_0_choice;
      end if;
      if pathsright_short_of then
        pathsright_q_choice := pathsright_missing;
      else
        pathsright_q_choice := 0;
      end if;
      if pathsright_lost then
        pathsright_q_choice_2 := pathsright_room;
      else
        pathsright_q_choice_2 := pathsright_q_choice;
      end if;
      if pathsright_short_of then
        pathsright_room_left_choice := pathsright_below;
      else
        pathsright_room_left_choice := pathsright_room;
      end if;
      if line_starts_phases_23 then
        if line_places_1_first_column then
          pathsright_q <= 24;
        else
          pathsright_q <= pathsright_q_choice_2;
        end if;
        if pathsright_lost then
          pathsright_room_left <= 0;
        else
          pathsright_room_left <= pathsright_room_left_choice;
        end if;
      end if;
      if line_starts_phases_24 then
        pathsright_q_now <= pathsright_q;
        pathsright_q_less <= ((((pathsright_q / 4) + 15) mod 16) * 4) + (pathsright_q mod 4);
        if line_places_1_first_column then
          pathsright_room <= 0;
          pathsright_start_cost_1 <= 0;
          pathsright_start_cost_2 <= 0;
          pathsright_start_cost_3 <= 0;
          pathsright_start_cost_4 <= 0;
          pathsright_start_cost_5 <= 0;
          pathsright_start_cost_6 <= 0;
          pathsright_start_cost_7 <= 0;
          pathsright_start_cost_8 <= 0;
          pathsright_start_cost_9 <= 0;
        else
          pathsright_room <= (pathsright_room_left + pathsright_start_cost_9) mod 32;
          pathsright_start_cost_1 <= pathsright_q_now;
          pathsright_start_cost_2 <= pathsright_start_cost_1;
          pathsright_start_cost_3 <= pathsright_start_cost_2;
          pathsright_start_cost_4 <= pathsright_start_cost_3;
          pathsright_start_cost_5 <= pathsright_start_cost_4;
          pathsright_start_cost_6 <= pathsright_start_cost_5;
          pathsright_start_cost_7 <= pathsright_start_cost_6;
          pathsright_start_cost_8 <= pathsright_start_cost_7;
          pathsright_start_cost_9 <= pathsright_start_cost_8;
        end if;
      end if;
      if line_starts_phases_25 then
        pathsright_g <= pathsturn_ready_smallest_0 + pathsright_q_now;
        pathsright_g_less <= (pathsturn_ready_smallest_0 + pathsright_q_less) mod 64;
      end if;
      if pathsleft_cost_0_any then
        pathsright_cost_0 <= (pathsright_stay_0 + pathsright_stay_change_0) mod 64;
        pathsright_cost_1 <= (pathsright_stay_1 + pathsright_stay_change_1) mod 64;
        pathsright_cost_2 <= (pathsright_stay_2 + pathsright_stay_change_2) mod 64;
        pathsright_cost_3 <= (pathsright_stay_3 + pathsright_stay_change_3) mod 64;
        pathsright_cost_4 <= (pathsright_stay_4 + pathsright_stay_change_4) mod 64;
        pathsright_cost_5 <= (pathsright_stay_5 + pathsright_stay_change_5) mod 64;
        pathsright_cost_6 <= (pathsright_stay_6 + pathsright_stay_change_6) mod 64;
        pathsright_cost_7 <= (pathsright_stay_7 + pathsright_stay_change_7) mod 64;
        pathsright_arrived_0 <= (pathsright_step_0 + pathsright_step_change_0) mod 64;
        pathsright_arrived_1 <= (pathsright_step_1 + pathsright_step_change_1) mod 64;
        pathsright_arrived_2 <= (pathsright_step_2 + pathsright_step_change_2) mod 64;
        pathsright_arrived_3 <= (pathsright_step_3 + pathsright_step_change_3) mod 64;
        pathsright_arrived_4 <= (pathsright_step_4 + pathsright_step_change_4) mod 64;
        pathsright_arrived_5 <= (pathsright_step_5 + pathsright_step_change_5) mod 64;
        pathsright_arrived_6 <= (pathsright_step_6 + pathsright_step_change_6) mod 64;
        pathsright_arrived_7 <= (pathsright_step_7 + pathsright_step_change_7) mod 64;
      end if;
      -- winnerswinner1
      if (paths_sum_0 mod 2) = 1 then
        winnerswinner1_best_index_0_0_choice := (not (((paths_sum_1 / 2) mod 2) = 1)) or (not ((paths_sum_1 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_0_choice := not (((paths_sum_1 / 2) mod 2) = 1);
      end if;
      if ((paths_sum_0 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_0_choice_2 := winnerswinner1_best_index_0_0_choice;
      else
        winnerswinner1_best_index_0_0_choice_2 := ((paths_sum_0 mod 2) = 1) and ((paths_sum_1 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_0_value := ((paths_sum_1 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_2 then
        winnerswinner1_best_index_0_0_choice_3 := (not (((paths_sum_0 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value;
      else
        winnerswinner1_best_index_0_0_choice_3 := (not (((paths_sum_0 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value;
      end if;
      winnerswinner1_best_index_0_0_value_2 := ((paths_sum_1 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_3 then
        winnerswinner1_best_index_0_0_choice_4 := (not (((paths_sum_0 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value_2;
      else
        winnerswinner1_best_index_0_0_choice_4 := (not (((paths_sum_0 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value_2;
      end if;
      winnerswinner1_best_index_0_0_value_3 := ((paths_sum_1 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_4 then
        winnerswinner1_best_index_0_0_choice_5 := (not (((paths_sum_0 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value_3;
      else
        winnerswinner1_best_index_0_0_choice_5 := (not (((paths_sum_0 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value_3;
      end if;
      winnerswinner1_best_index_0_0_value_4 := ((paths_sum_1 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_5 then
        winnerswinner1_best_index_0_0_choice_6 := (not (((paths_sum_0 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value_4;
      else
        winnerswinner1_best_index_0_0_choice_6 := (not (((paths_sum_0 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value_4;
      end if;
      winnerswinner1_best_index_0_0_value_5 := ((paths_sum_1 / 64) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_6 then
        winnerswinner1_best_index_0_0_choice_7 := (not (((paths_sum_0 / 64) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value_5;
      else
        winnerswinner1_best_index_0_0_choice_7 := (not (((paths_sum_0 / 64) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value_5;
      end if;
      if (paths_sum_2 mod 2) = 1 then
        winnerswinner1_best_index_0_1_choice := (not (((paths_sum_3 / 2) mod 2) = 1)) or (not ((paths_sum_3 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_1_choice := not (((paths_sum_3 / 2) mod 2) = 1);
      end if;
      if ((paths_sum_2 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_1_choice_2 := winnerswinner1_best_index_0_1_choice;
      else
        winnerswinner1_best_index_0_1_choice_2 := ((paths_sum_2 mod 2) = 1) and ((paths_sum_3 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_1_value := ((paths_sum_3 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_2 then
        winnerswinner1_best_index_0_1_choice_3 := (not (((paths_sum_2 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value;
      else
        winnerswinner1_best_index_0_1_choice_3 := (not (((paths_sum_2 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value;
      end if;
      winnerswinner1_best_index_0_1_value_2 := ((paths_sum_3 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_3 then
        winnerswinner1_best_index_0_1_choice_4 := (not (((paths_sum_2 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value_2;
      else
        winnerswinner1_best_index_0_1_choice_4 := (not (((paths_sum_2 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value_2;
      end if;
      winnerswinner1_best_index_0_1_value_3 := ((paths_sum_3 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_4 then
        winnerswinner1_best_index_0_1_choice_5 := (not (((paths_sum_2 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value_3;
      else
        winnerswinner1_best_index_0_1_choice_5 := (not (((paths_sum_2 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value_3;
      end if;
      winnerswinner1_best_index_0_1_value_4 := ((paths_sum_3 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_5 then
        winnerswinner1_best_index_0_1_choice_6 := (not (((paths_sum_2 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value_4;
      else
        winnerswinner1_best_index_0_1_choice_6 := (not (((paths_sum_2 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value_4;
      end if;
      winnerswinner1_best_index_0_1_value_5 := ((paths_sum_3 / 64) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_6 then
        winnerswinner1_best_index_0_1_choice_7 := (not (((paths_sum_2 / 64) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value_5;
      else
        winnerswinner1_best_index_0_1_choice_7 := (not (((paths_sum_2 / 64) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value_5;
      end if;
      if winnerswinner1_best_index_0_1_choice_7 then
        winnerswinner1_best_index_0_1_choice_8 := ((paths_sum_2 / 128) = 1) and (not ((paths_sum_3 / 128) = 1));
      else
        winnerswinner1_best_index_0_1_choice_8 := ((paths_sum_2 / 128) = 1) or (not ((paths_sum_3 / 128) = 1));
      end if;
      if (paths_sum_4 mod 2) = 1 then
        winnerswinner1_best_index_0_2_choice := (not (((paths_sum_5 / 2) mod 2) = 1)) or (not ((paths_sum_5 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_2_choice := not (((paths_sum_5 / 2) mod 2) = 1);
      end if;
      if ((paths_sum_4 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_2_choice_2 := winnerswinner1_best_index_0_2_choice;
      else
        winnerswinner1_best_index_0_2_choice_2 := ((paths_sum_4 mod 2) = 1) and ((paths_sum_5 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_2_value := ((paths_sum_5 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_2 then
        winnerswinner1_best_index_0_2_choice_3 := (not (((paths_sum_4 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value;
      else
        winnerswinner1_best_index_0_2_choice_3 := (not (((paths_sum_4 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value;
      end if;
      winnerswinner1_best_index_0_2_value_2 := ((paths_sum_5 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_3 then
        winnerswinner1_best_index_0_2_choice_4 := (not (((paths_sum_4 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value_2;
      else
        winnerswinner1_best_index_0_2_choice_4 := (not (((paths_sum_4 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value_2;
      end if;
      winnerswinner1_best_index_0_2_value_3 := ((paths_sum_5 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_4 then
        winnerswinner1_best_index_0_2_choice_5 := (not (((paths_sum_4 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value_3;
      else
        winnerswinner1_best_index_0_2_choice_5 := (not (((paths_sum_4 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value_3;
      end if;
      winnerswinner1_best_index_0_2_value_4 := ((paths_sum_5 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_5 then
        winnerswinner1_best_index_0_2_choice_6 := (not (((paths_sum_4 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value_4;
      else
        winnerswinner1_best_index_0_2_choice_6 := (not (((paths_sum_4 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value_4;
      end if;
      winnerswinner1_best_index_0_2_value_5 := ((paths_sum_5 / 64) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_6 then
        winnerswinner1_best_index_0_2_choice_7 := (not (((paths_sum_4 / 64) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value_5;
      else
        winnerswinner1_best_index_0_2_choice_7 := (not (((paths_sum_4 / 64) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value_5;
      end if;
      if winnerswinner1_best_index_0_2_choice_7 then
        winnerswinner1_best_index_0_2_choice_8 := ((paths_sum_4 / 128) = 1) and (not ((paths_sum_5 / 128) = 1));
      else
        winnerswinner1_best_index_0_2_choice_8 := ((paths_sum_4 / 128) = 1) or (not ((paths_sum_5 / 128) = 1));
      end if;
      if (paths_sum_6 mod 2) = 1 then
        winnerswinner1_best_index_0_3_choice := (not (((paths_sum_7 / 2) mod 2) = 1)) or (not ((paths_sum_7 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_3_choice := not (((paths_sum_7 / 2) mod 2) = 1);
      end if;
      if ((paths_sum_6 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_3_choice_2 := winnerswinner1_best_index_0_3_choice;
      else
        winnerswinner1_best_index_0_3_choice_2 := ((paths_sum_6 mod 2) = 1) and ((paths_sum_7 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_3_value := ((paths_sum_7 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_2 then
        winnerswinner1_best_index_0_3_choice_3 := (not (((paths_sum_6 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value;
      else
        winnerswinner1_best_index_0_3_choice_3 := (not (((paths_sum_6 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value;
      end if;
      winnerswinner1_best_index_0_3_value_2 := ((paths_sum_7 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_3 then
        winnerswinner1_best_index_0_3_choice_4 := (not (((paths_sum_6 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value_2;
      else
        winnerswinner1_best_index_0_3_choice_4 := (not (((paths_sum_6 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value_2;
      end if;
      winnerswinner1_best_index_0_3_value_3 := ((paths_sum_7 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_4 then
        winnerswinner1_best_index_0_3_choice_5 := (not (((paths_sum_6 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value_3;
      else
        winnerswinner1_best_index_0_3_choice_5 := (not (((paths_sum_6 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value_3;
      end if;
      winnerswinner1_best_index_0_3_value_4 := ((paths_sum_7 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_5 then
        winnerswinner1_best_index_0_3_choice_6 := (not (((paths_sum_6 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value_4;
      else
        winnerswinner1_best_index_0_3_choice_6 := (not (((paths_sum_6 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value_4;
      end if;
      winnerswinner1_best_index_0_3_value_5 := ((paths_sum_7 / 64) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_6 then
        winnerswinner1_best_index_0_3_choice_7 := (not (((paths_sum_6 / 64) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value_5;
      else
        winnerswinner1_best_index_0_3_choice_7 := (not (((paths_sum_6 / 64) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value_5;
      end if;
      if winnerswinner1_best_index_0_3_choice_7 then
        winnerswinner1_best_index_0_3_choice_8 := ((paths_sum_6 / 128) = 1) and (not ((paths_sum_7 / 128) = 1));
      else
        winnerswinner1_best_index_0_3_choice_8 := ((paths_sum_6 / 128) = 1) or (not ((paths_sum_7 / 128) = 1));
      end if;
      if (paths_sum_1 - paths_sum_0) < 0 then
        winnerswinner1_best_cost_0_0 <= paths_sum_1;
      else
        winnerswinner1_best_cost_0_0 <= paths_sum_0;
      end if;
      if (paths_sum_3 - paths_sum_2) < 0 then
        winnerswinner1_best_cost_0_1 <= paths_sum_3;
      else
        winnerswinner1_best_cost_0_1 <= paths_sum_2;
      end if;
      if (paths_sum_5 - paths_sum_4) < 0 then
        winnerswinner1_best_cost_0_2 <= paths_sum_5;
      else
        winnerswinner1_best_cost_0_2 <= paths_sum_4;
      end if;
      if (paths_sum_7 - paths_sum_6) < 0 then
        winnerswinner1_best_cost_0_3 <= paths_sum_7;
      else
        winnerswinner1_best_cost_0_3 <= paths_sum_6;
      end if;
      if winnerswinner1_best_index_0_0_choice_7 then
        winnerswinner1_best_index_0_0 <= ((paths_sum_0 / 128) = 1) and (not ((paths_sum_1 / 128) = 1));
      else
        winnerswinner1_best_index_0_0 <= ((paths_sum_0 / 128) = 1) or (not ((paths_sum_1 / 128) = 1));
      end if;
      if winnerswinner1_best_index_0_1_choice_8 then
        winnerswinner1_best_index_0_1 <= 3;
      else
        winnerswinner1_best_index_0_1 <= 2;
      end if;
      if winnerswinner1_best_index_0_2_choice_8 then
        winnerswinner1_best_index_0_2 <= 5;
      else
        winnerswinner1_best_index_0_2 <= 4;
      end if;
      if winnerswinner1_best_index_0_3_choice_8 then
        winnerswinner1_best_index_0_3 <= 7;
      else
        winnerswinner1_best_index_0_3 <= 6;
      end if;
      -- winnerswinner2
      if (winnerswinner1_best_cost_0_0 mod 2) = 1 then
        winnerswinner2_best_index_0_0_choice := (not (((winnerswinner1_best_cost_0_1 / 2) mod 2) = 1)) or (not
          ((winnerswinner1_best_cost_0_1 mod 2) = 1));
      else
        winnerswinner2_best_index_0_0_choice := not (((winnerswinner1_best_cost_0_1 / 2) mod 2) = 1);
      end if;
      if ((winnerswinner1_best_cost_0_0 / 2) mod 2) = 1 then
        winnerswinner2_best_index_0_0_choice_2 := winnerswinner2_best_index_0_0_choice;
      else
        winnerswinner2_best_index_0_0_choice_2 := ((winnerswinner1_best_cost_0_0 mod 2) = 1) and
          ((winnerswinner1_best_cost_0_1 mod 4) = 0);
      end if;
      winnerswinner2_best_index_0_0_value := ((winnerswinner1_best_cost_0_1 / 4) mod 2) = 1;
      if winnerswinner2_best_index_0_0_choice_2 then
        winnerswinner2_best_index_0_0_choice_3 := (not (((winnerswinner1_best_cost_0_0 / 4) mod 2) = 1)) and
          winnerswinner2_best_index_0_0_value;
      else
        winnerswinner2_best_index_0_0_choice_3 := (not (((winnerswinner1_best_cost_0_0 / 4) mod 2) = 1)) or
          winnerswinner2_best_index_0_0_value;
      end if;
      winnerswinner2_best_index_0_0_value_2 := ((winnerswinner1_best_cost_0_1 / 8) mod 2) = 1;
      if winnerswinner2_best_index_0_0_choice_3 then
        winnerswinner2_best_index_0_0_choice_4 := (not (((winnerswinner1_best_cost_0_0 / 8) mod 2) = 1)) or
          winnerswinner2_best_index_0_0_value_2;
      else
        winnerswinner2_best_index_0_0_choice_4 := (not (((winnerswinner1_best_cost_0_0 / 8) mod 2) = 1)) and
          winnerswinner2_best_index_0_0_value_2;
      end if;
      winnerswinner2_best_index_0_0_value_3 := ((winnerswinner1_best_cost_0_1 / 16) mod 2) = 1;
      if winnerswinner2_best_index_0_0_choice_4 then
        winnerswinner2_best_index_0_0_choice_5 := (not (((winnerswinner1_best_cost_0_0 / 16) mod 2) = 1)) or
          winnerswinner2_best_index_0_0_value_3;
      else
        winnerswinner2_best_index_0_0_choice_5 := (not (((winnerswinner1_best_cost_0_0 / 16) mod 2) = 1)) and
          winnerswinner2_best_index_0_0_value_3;
      end if;
      winnerswinner2_best_index_0_0_value_4 := ((winnerswinner1_best_cost_0_1 / 32) mod 2) = 1;
      if winnerswinner2_best_index_0_0_choice_5 then
        winnerswinner2_best_index_0_0_choice_6 := (not (((winnerswinner1_best_cost_0_0 / 32) mod 2) = 1)) or
          winnerswinner2_best_index_0_0_value_4;
      else
        winnerswinner2_best_index_0_0_choice_6 := (not (((winnerswinner1_best_cost_0_0 / 32) mod 2) = 1)) and
          winnerswinner2_best_index_0_0_value_4;
      end if;
      winnerswinner2_best_index_0_0_value_5 := ((winnerswinner1_best_cost_0_1 / 64) mod 2) = 1;
      if winnerswinner2_best_index_0_0_choice_6 then
        winnerswinner2_best_index_0_0_choice_7 := (not (((winnerswinner1_best_cost_0_0 / 64) mod 2) = 1)) or
          winnerswinner2_best_index_0_0_value_5;
      else
        winnerswinner2_best_index_0_0_choice_7 := (not (((winnerswinner1_best_cost_0_0 / 64) mod 2) = 1)) and
          winnerswinner2_best_index_0_0_value_5;
      end if;
      if winnerswinner2_best_index_0_0_choice_7 then
        winnerswinner2_best_index_0_0_choice_8 := ((winnerswinner1_best_cost_0_0 / 128) = 1) and (not
          ((winnerswinner1_best_cost_0_1 / 128) = 1));
      else
        winnerswinner2_best_index_0_0_choice_8 := ((winnerswinner1_best_cost_0_0 / 128) = 1) or (not
          ((winnerswinner1_best_cost_0_1 / 128) = 1));
      end if;
      if (winnerswinner1_best_cost_0_2 mod 2) = 1 then
        winnerswinner2_best_index_0_1_choice := (not (((winnerswinner1_best_cost_0_3 / 2) mod 2) = 1)) or (not
          ((winnerswinner1_best_cost_0_3 mod 2) = 1));
      else
        winnerswinner2_best_index_0_1_choice := not (((winnerswinner1_best_cost_0_3 / 2) mod 2) = 1);
      end if;
      if ((winnerswinner1_best_cost_0_2 / 2) mod 2) = 1 then
        winnerswinner2_best_index_0_1_choice_2 := winnerswinner2_best_index_0_1_choice;
      else
        winnerswinner2_best_index_0_1_choice_2 := ((winnerswinner1_best_cost_0_2 mod 2) = 1) and
          ((winnerswinner1_best_cost_0_3 mod 4) = 0);
      end if;
      winnerswinner2_best_index_0_1_value := ((winnerswinner1_best_cost_0_3 / 4) mod 2) = 1;
      if winnerswinner2_best_index_0_1_choice_2 then
        winnerswinner2_best_index_0_1_choice_3 := (not (((winnerswinner1_best_cost_0_2 / 4) mod 2) = 1)) and
          winnerswinner2_best_index_0_1_value;
      else
        winnerswinner2_best_index_0_1_choice_3 := (not (((winnerswinner1_best_cost_0_2 / 4) mod 2) = 1)) or
          winnerswinner2_best_index_0_1_value;
      end if;
      winnerswinner2_best_index_0_1_value_2 := ((winnerswinner1_best_cost_0_3 / 8) mod 2) = 1;
      if winnerswinner2_best_index_0_1_choice_3 then
        winnerswinner2_best_index_0_1_choice_4 := (not (((winnerswinner1_best_cost_0_2 / 8) mod 2) = 1)) or
          winnerswinner2_best_index_0_1_value_2;
      else
        winnerswinner2_best_index_0_1_choice_4 := (not (((winnerswinner1_best_cost_0_2 / 8) mod 2) = 1)) and
          winnerswinner2_best_index_0_1_value_2;
      end if;
      winnerswinner2_best_index_0_1_value_3 := ((winnerswinner1_best_cost_0_3 / 16) mod 2) = 1;
      if winnerswinner2_best_index_0_1_choice_4 then
        winnerswinner2_best_index_0_1_choice_5 := (not (((winnerswinner1_best_cost_0_2 / 16) mod 2) = 1)) or
          winnerswinner2_best_index_0_1_value_3;
      else
        winnerswinner2_best_index_0_1_choice_5 := (not (((winnerswinner1_best_cost_0_2 / 16) mod 2) = 1)) and
          winnerswinner2_best_index_0_1_value_3;
      end if;
      winnerswinner2_best_index_0_1_value_4 := ((winnerswinner1_best_cost_0_3 / 32) mod 2) = 1;
      if winnerswinner2_best_index_0_1_choice_5 then
        winnerswinner2_best_index_0_1_choice_6 := (not (((winnerswinner1_best_cost_0_2 / 32) mod 2) = 1)) or
          winnerswinner2_best_index_0_1_value_4;
      else
        winnerswinner2_best_index_0_1_choice_6 := (not (((winnerswinner1_best_cost_0_2 / 32) mod 2) = 1)) and
          winnerswinner2_best_index_0_1_value_4;
      end if;
      winnerswinner2_best_index_0_1_value_5 := ((winnerswinner1_best_cost_0_3 / 64) mod 2) = 1;
      if winnerswinner2_best_index_0_1_choice_6 then
        winnerswinner2_best_index_0_1_choice_7 := (not (((winnerswinner1_best_cost_0_2 / 64) mod 2) = 1)) or
          winnerswinner2_best_index_0_1_value_5;
      else
        winnerswinner2_best_index_0_1_choice_7 := (not (((winnerswinner1_best_cost_0_2 / 64) mod 2) = 1)) and
          winnerswinner2_best_index_0_1_value_5;
      end if;
      if winnerswinner2_best_index_0_1_choice_7 then
        winnerswinner2_best_index_0_1_choice_8 := ((winnerswinner1_best_cost_0_2 / 128) = 1) and (not
          ((winnerswinner1_best_cost_0_3 / 128) = 1));
      else
        winnerswinner2_best_index_0_1_choice_8 := ((winnerswinner1_best_cost_0_2 / 128) = 1) or (not
          ((winnerswinner1_best_cost_0_3 / 128) = 1));
      end if;
      if (winnerswinner1_best_cost_0_1 - winnerswinner1_best_cost_0_0) < 0 then
        winnerswinner2_best_cost_0_0 <= winnerswinner1_best_cost_0_1;
      else
        winnerswinner2_best_cost_0_0 <= winnerswinner1_best_cost_0_0;
      end if;
      if (winnerswinner1_best_cost_0_3 - winnerswinner1_best_cost_0_2) < 0 then
        winnerswinner2_best_cost_0_1 <= winnerswinner1_best_cost_0_3;
      else
        winnerswinner2_best_cost_0_1 <= winnerswinner1_best_cost_0_2;
      end if;
      if winnerswinner2_best_index_0_0_choice_8 then
        winnerswinner2_best_index_0_0 <= winnerswinner1_best_index_0_1;
      else
        winnerswinner2_best_index_0_0 <= as_number(winnerswinner1_best_index_0_0);
      end if;
      if winnerswinner2_best_index_0_1_choice_8 then
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_3;
      else
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_2;
      end if;
      -- winnerswinner3
      if (winnerswinner2_best_cost_0_0 mod 2) = 1 then
        winnerswinner3_best_index_0_0_choice := (not (((winnerswinner2_best_cost_0_1 / 2) mod 2) = 1)) or (not
          ((winnerswinner2_best_cost_0_1 mod 2) = 1));
      else
        winnerswinner3_best_index_0_0_choice := not (((winnerswinner2_best_cost_0_1 / 2) mod 2) = 1);
      end if;
      if ((winnerswinner2_best_cost_0_0 / 2) mod 2) = 1 then
        winnerswinner3_best_index_0_0_choice_2 := winnerswinner3_best_index_0_0_choice;
      else
        winnerswinner3_best_index_0_0_choice_2 := ((winnerswinner2_best_cost_0_0 mod 2) = 1) and
          ((winnerswinner2_best_cost_0_1 mod 4) = 0);
      end if;
      winnerswinner3_best_index_0_0_value := ((winnerswinner2_best_cost_0_1 / 4) mod 2) = 1;
      if winnerswinner3_best_index_0_0_choice_2 then
        winnerswinner3_best_index_0_0_choice_3 := (not (((winnerswinner2_best_cost_0_0 / 4) mod 2) = 1)) and
          winnerswinner3_best_index_0_0_value;
      else
        winnerswinner3_best_index_0_0_choice_3 := (not (((winnerswinner2_best_cost_0_0 / 4) mod 2) = 1)) or
          winnerswinner3_best_index_0_0_value;
      end if;
      winnerswinner3_best_index_0_0_value_2 := ((winnerswinner2_best_cost_0_1 / 8) mod 2) = 1;
      if winnerswinner3_best_index_0_0_choice_3 then
        winnerswinner3_best_index_0_0_choice_4 := (not (((winnerswinner2_best_cost_0_0 / 8) mod 2) = 1)) or
          winnerswinner3_best_index_0_0_value_2;
      else
        winnerswinner3_best_index_0_0_choice_4 := (not (((winnerswinner2_best_cost_0_0 / 8) mod 2) = 1)) and
          winnerswinner3_best_index_0_0_value_2;
      end if;
      winnerswinner3_best_index_0_0_value_3 := ((winnerswinner2_best_cost_0_1 / 16) mod 2) = 1;
      if winnerswinner3_best_index_0_0_choice_4 then
        winnerswinner3_best_index_0_0_choice_5 := (not (((winnerswinner2_best_cost_0_0 / 16) mod 2) = 1)) or
          winnerswinner3_best_index_0_0_value_3;
      else
        winnerswinner3_best_index_0_0_choice_5 := (not (((winnerswinner2_best_cost_0_0 / 16) mod 2) = 1)) and
          winnerswinner3_best_index_0_0_value_3;
      end if;
      winnerswinner3_best_index_0_0_value_4 := ((winnerswinner2_best_cost_0_1 / 32) mod 2) = 1;
      if winnerswinner3_best_index_0_0_choice_5 then
        winnerswinner3_best_index_0_0_choice_6 := (not (((winnerswinner2_best_cost_0_0 / 32) mod 2) = 1)) or
          winnerswinner3_best_index_0_0_value_4;
      else
        winnerswinner3_best_index_0_0_choice_6 := (not (((winnerswinner2_best_cost_0_0 / 32) mod 2) = 1)) and
          winnerswinner3_best_index_0_0_value_4;
      end if;
      winnerswinner3_best_index_0_0_value_5 := ((winnerswinner2_best_cost_0_1 / 64) mod 2) = 1;
      if winnerswinner3_best_index_0_0_choice_6 then
        winnerswinner3_best_index_0_0_choice_7 := (not (((winnerswinner2_best_cost_0_0 / 64) mod 2) = 1)) or
          winnerswinner3_best_index_0_0_value_5;
      else
        winnerswinner3_best_index_0_0_choice_7 := (not (((winnerswinner2_best_cost_0_0 / 64) mod 2) = 1)) and
          winnerswinner3_best_index_0_0_value_5;
      end if;
      if winnerswinner3_best_index_0_0_choice_7 then
        winnerswinner3_best_index_0_0_choice_8 := ((winnerswinner2_best_cost_0_0 / 128) = 1) and (not
          ((winnerswinner2_best_cost_0_1 / 128) = 1));
      else
        winnerswinner3_best_index_0_0_choice_8 := ((winnerswinner2_best_cost_0_0 / 128) = 1) or (not
          ((winnerswinner2_best_cost_0_1 / 128) = 1));
      end if;
      if (winnerswinner2_best_cost_0_1 - winnerswinner2_best_cost_0_0) < 0 then
        winnerswinner3_best_cost_0_0 <= winnerswinner2_best_cost_0_1;
      else
        winnerswinner3_best_cost_0_0 <= winnerswinner2_best_cost_0_0;
      end if;
      if winnerswinner3_best_index_0_0_choice_8 then
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_1;
      else
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_0;
      end if;
      -- winners
      if line_comes_32 then
        winners_best_cost_0_0_choice := 255;
      else
        winners_best_cost_0_0_choice := winners_best_cost_0_0;
      end if;
      winners_best_index_0_0_value := ((winners_best_cost_0_0 / 2) mod 2) = 1;
      if (not ((winnerswinner3_best_cost_0_0 mod 2) = 1)) and (((winners_best_cost_0_0 mod 2) = 1) or line_comes_32)
        then
        winners_best_index_0_0_choice := (not (((winnerswinner3_best_cost_0_0 / 2) mod 2) = 1)) or
          winners_best_index_0_0_value or line_comes_32;
      else
        winners_best_index_0_0_choice := (not (((winnerswinner3_best_cost_0_0 / 2) mod 2) = 1)) and
          (winners_best_index_0_0_value or line_comes_32);
      end if;
      winners_best_index_0_0_value_2 := ((winners_best_cost_0_0 / 4) mod 2) = 1;
      if winners_best_index_0_0_choice then
        winners_best_index_0_0_choice_2 := (not (((winnerswinner3_best_cost_0_0 / 4) mod 2) = 1)) or
          winners_best_index_0_0_value_2 or line_comes_32;
      else
        winners_best_index_0_0_choice_2 := (not (((winnerswinner3_best_cost_0_0 / 4) mod 2) = 1)) and
          (winners_best_index_0_0_value_2 or line_comes_32);
      end if;
      winners_best_index_0_0_value_3 := ((winners_best_cost_0_0 / 8) mod 2) = 1;
      if winners_best_index_0_0_choice_2 then
        winners_best_index_0_0_choice_3 := (not (((winnerswinner3_best_cost_0_0 / 8) mod 2) = 1)) or
          winners_best_index_0_0_value_3 or line_comes_32;
      else
        winners_best_index_0_0_choice_3 := (not (((winnerswinner3_best_cost_0_0 / 8) mod 2) = 1)) and
          (winners_best_index_0_0_value_3 or line_comes_32);
      end if;
      winners_best_index_0_0_value_4 := ((winners_best_cost_0_0 / 16) mod 2) = 1;
      if winners_best_index_0_0_choice_3 then
        winners_best_index_0_0_choice_4 := (not (((winnerswinner3_best_cost_0_0 / 16) mod 2) = 1)) or
          winners_best_index_0_0_value_4 or line_comes_32;
      else
        winners_best_index_0_0_choice_4 := (not (((winnerswinner3_best_cost_0_0 / 16) mod 2) = 1)) and
          (winners_best_index_0_0_value_4 or line_comes_32);
      end if;
      winners_best_index_0_0_value_5 := ((winners_best_cost_0_0 / 32) mod 2) = 1;
      if winners_best_index_0_0_choice_4 then
        winners_best_index_0_0_choice_5 := (not (((winnerswinner3_best_cost_0_0 / 32) mod 2) = 1)) or
          winners_best_index_0_0_value_5 or line_comes_32;
      else
        winners_best_index_0_0_choice_5 := (not (((winnerswinner3_best_cost_0_0 / 32) mod 2) = 1)) and
          (winners_best_index_0_0_value_5 or line_comes_32);
      end if;
      winners_best_index_0_0_value_6 := ((winners_best_cost_0_0 / 64) mod 2) = 1;
      if winners_best_index_0_0_choice_5 then
        winners_best_index_0_0_choice_6 := (not (((winnerswinner3_best_cost_0_0 / 64) mod 2) = 1)) or
          winners_best_index_0_0_value_6 or line_comes_32;
      else
        winners_best_index_0_0_choice_6 := (not (((winnerswinner3_best_cost_0_0 / 64) mod 2) = 1)) and
          (winners_best_index_0_0_value_6 or line_comes_32);
      end if;
      if winners_best_index_0_0_choice_6 then
        winners_best_index_0_0_choice_7 := (not ((winnerswinner3_best_cost_0_0 / 128) = 1)) or ((winners_best_cost_0_0
          / 128) = 1) or line_comes_32;
      else
        winners_best_index_0_0_choice_7 := (not ((winnerswinner3_best_cost_0_0 / 128) = 1)) and
          (((winners_best_cost_0_0 / 128) = 1) or line_comes_32);
      end if;
      winners_best_tag_valid <= line_comes_47;
      winners_best_tag_map_column <= line_places_2_map_column;
      winners_best_tag_output_column <= line_places_2_shown_output_column;
      winners_best_tag_start_of_frame <= line_places_2_shown_start_of_frame;
      winners_best_tag_end_of_line <= line_places_2_shown_end_of_line;
      if (winnerswinner3_best_cost_0_0 - winners_best_cost_0_0_choice) < 0 then
        winners_best_cost_0_0 <= winnerswinner3_best_cost_0_0;
      else
        winners_best_cost_0_0 <= winners_best_cost_0_0_choice;
      end if;
      if winners_best_index_0_0_choice_7 then
        winners_best_index_0_0 <= winnerswinner3_best_index_0_0 + 120;
      else
        winners_best_index_0_0 <= ((((winners_best_index_0_0 / 8) + 31) mod 32) * 8) + (winners_best_index_0_0 mod 8);
      end if;
      -- turn
      turn_order_address_any := turn_order_inside or (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 1023;
      else
        turn_order_address_choice := 1;
      end if;
      turn_order_address_any_2 := (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 1024;
        else
          turn_order_address <= as_number((not turn_order_falls)) * 512;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and winners_best_tag_map_column and winners_best_tag_valid;
      turn_order_complete_all := winners_best_tag_map_column and winners_best_tag_valid;
      turn_ready_tag_row_start_differs := map_counter_group /= 481;
      turn_ready_tag_row_start_is_equal := map_counter_column = 512;
      if turn_ready_tag_row_start_is_equal then
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start and (map_counter_group /= 480);
      else
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start;
      end if;
      if turn_ready_tag_row_start_differs then
        turn_ready_tag_row_start_choice_2 := turn_ready_tag_row_start_choice;
      else
        turn_ready_tag_row_start_choice_2 := turn_ready_tag_row_start;
      end if;
      turn_ready_tag_row_start_is_equal_2 := map_counter_group = 479;
      turn_ready_tag_row_start_all := turn_ready_tag_row_start_is_equal_2 and turn_ready_tag_row_start_is_equal;
      if turn_ready_tag_row_start_choice_2 then
        turn_ready_tag_row_start_choice_3 := (not turn_ready_tag_start_of_frame) or turn_ready_tag_row_start_all;
      else
        turn_ready_tag_row_start_choice_3 := turn_ready_tag_start_of_frame and turn_ready_tag_row_start_is_equal_2 and
          turn_ready_tag_row_start_is_equal;
      end if;
      turn_ready_tag_row_start_all_2 := turn_ready_tag_valid and turn_ready_tag_map_column;
      turn_order_turned_valid <= winners_best_tag_valid;
      turn_order_turned_map_column <= winners_best_tag_map_column;
      turn_order_turned_start_of_frame <= (not turn_order_inside) and winners_best_tag_map_column and
        winners_best_tag_valid and turn_order_first and turn_order_complete and turn_order_output;
      turn_order_turned_end_of_line <= winners_best_tag_end_of_line;
      turn_newest <= winners_best_index_0_0 + 256;
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
      if winners_best_tag_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if turn_comes then
        turn_write_place <= turn_order_address;
      else
        turn_write_place <= 513;
      end if;
      if turn_ready_tag_row_start_choice_3 then
        turn_ready_tag_row_start <= turn_ready_tag_row_start or turn_ready_tag_row_start_all_2;
      else
        turn_ready_tag_row_start <= turn_ready_tag_row_start and ((not turn_ready_tag_valid) or (not
          turn_ready_tag_map_column));
      end if;
      if winners_best_tag_valid then
        turn_order_inside <= winners_best_tag_map_column;
      end if;
      if turn_order_falls_all then
        turn_order_output <= winners_best_tag_output_column;
        turn_order_first <= winners_best_tag_start_of_frame;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
      end if;
      -- map
      if turn_ready_tag_row_start_all_2 then
        if turn_ready_tag_start_of_frame or turn_ready_tag_row_start_is_equal then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 1024;
        end if;
      end if;
      if turn_ready_tag_row_start_all then
        map_counter_group_choice := 15;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 480;
      if turn_ready_tag_row_start and map_counter_group_is_equal then
        map_counter_group_choice_2 := 1;
      else
        map_counter_group_choice_2 := (map_counter_group + 1) mod 512;
      end if;
      if turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equal and turn_ready_tag_valid and
        turn_ready_tag_map_column then
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
      map_of_column_0_b_below_a_value := ((map_column_1 / 4) mod 2) = 1;
      if map_at_top then
        map_of_column_0_b_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_b_below_a_choice := ((other_2 / 4) mod 2) = 1;
      end if;
      map_of_column_0_b_below_a_value_2 := ((map_column_1 / 2) mod 2) = 1;
      if map_at_top then
        map_of_column_0_b_below_a_choice_2 := map_of_column_0_b_below_a_value_2;
      else
        map_of_column_0_b_below_a_choice_2 := ((other_2 / 2) mod 2) = 1;
      end if;
      if map_of_column_0_b_below_a_choice_2 then
        map_of_column_0_b_below_a_choice_3 := (not map_of_column_0_b_below_a_value) or (not
          map_of_column_0_b_below_a_value_2);
      else
        map_of_column_0_b_below_a_choice_3 := not map_of_column_0_b_below_a_value;
      end if;
      if map_of_column_0_b_below_a_choice then
        map_of_column_0_b_below_a_choice_4 := map_of_column_0_b_below_a_choice_3;
      else
        map_of_column_0_b_below_a_choice_4 := map_of_column_0_b_below_a_choice_2 and (((map_column_1 / 2) mod 4) = 0);
      end if;
      map_of_column_0_b_below_a_value_3 := ((map_column_1 / 8) mod 2) = 1;
      map_of_column_0_b_below_a_value_4 := ((other_2 / 8) mod 2) = 1;
      if map_of_column_0_b_below_a_choice_4 then
        map_of_column_0_b_below_a_choice_5 := map_of_column_0_b_below_a_value_3 and (not
          map_of_column_0_b_below_a_value_4) and (not map_at_top);
      else
        map_of_column_0_b_below_a_choice_5 := map_of_column_0_b_below_a_value_3 or (not
          map_of_column_0_b_below_a_value_4) or map_at_top;
      end if;
      map_of_column_0_b_below_a_value_5 := ((map_column_1 / 16) mod 2) = 1;
      map_of_column_0_b_below_a_value_6 := ((other_2 / 16) mod 2) = 1;
      if map_of_column_0_b_below_a_choice_5 then
        map_of_column_0_b_below_a_choice_6 := map_of_column_0_b_below_a_value_5 or (not
          map_of_column_0_b_below_a_value_6) or map_at_top;
      else
        map_of_column_0_b_below_a_choice_6 := map_of_column_0_b_below_a_value_5 and (not
          map_of_column_0_b_below_a_value_6) and (not map_at_top);
      end if;
      map_of_column_0_b_below_a_value_7 := ((map_column_1 / 32) mod 2) = 1;
      map_of_column_0_b_below_a_value_8 := ((other_2 / 32) mod 2) = 1;
      if map_of_column_0_b_below_a_choice_6 then
        map_of_column_0_b_below_a_choice_7 := map_of_column_0_b_below_a_value_7 or (not
          map_of_column_0_b_below_a_value_8) or map_at_top;
      else
        map_of_column_0_b_below_a_choice_7 := map_of_column_0_b_below_a_value_7 and (not
          map_of_column_0_b_below_a_value_8) and (not map_at_top);
      end if;
      map_of_column_0_b_below_a_value_9 := ((map_column_1 / 64) mod 2) = 1;
      map_of_column_0_b_below_a_value_10 := ((other_2 / 64) mod 2) = 1;
      if map_of_column_0_b_below_a_choice_7 then
        map_of_column_0_b_below_a_choice_8 := map_of_column_0_b_below_a_value_9 or (not
          map_of_column_0_b_below_a_value_10) or map_at_top;
      else
        map_of_column_0_b_below_a_choice_8 := map_of_column_0_b_below_a_value_9 and (not
          map_of_column_0_b_below_a_value_10) and (not map_at_top);
      end if;
      map_of_column_0_b_below_a_value_11 := ((map_column_1 / 128) mod 2) = 1;
      map_of_column_0_b_below_a_value_12 := ((other_2 / 128) mod 2) = 1;
      if map_of_column_0_b_below_a_choice_8 then
        map_of_column_0_b_below_a_choice_9 := map_of_column_0_b_below_a_value_11 or (not
          map_of_column_0_b_below_a_value_12) or map_at_top;
      else
        map_of_column_0_b_below_a_choice_9 := map_of_column_0_b_below_a_value_11 and (not
          map_of_column_0_b_below_a_value_12) and (not map_at_top);
      end if;
      map_of_column_0_c_below_a_value := ((map_column_2 / 4) mod 2) = 1;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_c_below_a_choice := map_of_column_0_c_below_a_value;
      end if;
      map_of_column_0_c_below_a_value_2 := ((map_column_2 / 2) mod 2) = 1;
      if map_of_column_0_c_below_a_value_2 then
        map_of_column_0_c_below_a_choice_2 := (not map_of_column_0_b_below_a_value_2) and map_counter_next_frame;
      else
        map_of_column_0_c_below_a_choice_2 := (not map_of_column_0_b_below_a_value_2) or (not map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_a_choice then
        map_of_column_0_c_below_a_choice_3 := map_of_column_0_b_below_a_choice_2 and map_of_column_0_c_below_a_choice_2
          and map_of_column_0_b_below_a_choice;
      else
        map_of_column_0_c_below_a_choice_3 := (map_of_column_0_b_below_a_choice_2 and
          map_of_column_0_c_below_a_choice_2) or map_of_column_0_b_below_a_choice;
      end if;
      map_of_column_0_c_below_a_value_3 := ((map_column_2 / 8) mod 2) = 1;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice_4 := map_of_column_0_b_below_a_value_3;
      else
        map_of_column_0_c_below_a_choice_4 := map_of_column_0_c_below_a_value_3;
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choice_5 := map_of_column_0_b_below_a_value_3;
      else
        map_of_column_0_c_below_a_choice_5 := map_of_column_0_b_below_a_value_4;
      end if;
      if map_of_column_0_c_below_a_choice_3 then
        map_of_column_0_c_below_a_choice_6 := (not map_of_column_0_c_below_a_choice_4) or
          map_of_column_0_c_below_a_choice_5;
      else
        map_of_column_0_c_below_a_choice_6 := (not map_of_column_0_c_below_a_choice_4) and
          map_of_column_0_c_below_a_choice_5;
      end if;
      map_of_column_0_c_below_a_value_4 := ((map_column_2 / 16) mod 2) = 1;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice_7 := map_of_column_0_b_below_a_value_5;
      else
        map_of_column_0_c_below_a_choice_7 := map_of_column_0_c_below_a_value_4;
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choice_8 := map_of_column_0_b_below_a_value_5;
      else
        map_of_column_0_c_below_a_choice_8 := map_of_column_0_b_below_a_value_6;
      end if;
      if map_of_column_0_c_below_a_choice_6 then
        map_of_column_0_c_below_a_choice_9 := (not map_of_column_0_c_below_a_choice_7) or
          map_of_column_0_c_below_a_choice_8;
      else
        map_of_column_0_c_below_a_choice_9 := (not map_of_column_0_c_below_a_choice_7) and
          map_of_column_0_c_below_a_choice_8;
      end if;
      map_of_column_0_c_below_a_value_5 := ((map_column_2 / 32) mod 2) = 1;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice_10 := map_of_column_0_b_below_a_value_7;
      else
        map_of_column_0_c_below_a_choice_10 := map_of_column_0_c_below_a_value_5;
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choice_11 := map_of_column_0_b_below_a_value_7;
      else
        map_of_column_0_c_below_a_choice_11 := map_of_column_0_b_below_a_value_8;
      end if;
      if map_of_column_0_c_below_a_choice_9 then
        map_of_column_0_c_below_a_choice_12 := (not map_of_column_0_c_below_a_choice_10) or
          map_of_column_0_c_below_a_choice_11;
      else
        map_of_column_0_c_below_a_choice_12 := (not map_of_column_0_c_below_a_choice_10) and
          map_of_column_0_c_below_a_choice_11;
      end if;
      map_of_column_0_c_below_a_value_6 := ((map_column_2 / 64) mod 2) = 1;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice_13 := map_of_column_0_b_below_a_value_9;
      else
        map_of_column_0_c_below_a_choice_13 := map_of_column_0_c_below_a_value_6;
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choice_14 := map_of_column_0_b_below_a_value_9;
      else
        map_of_column_0_c_below_a_choice_14 := map_of_column_0_b_below_a_value_10;
      end if;
      if map_of_column_0_c_below_a_choice_12 then
        map_of_column_0_c_below_a_choice_15 := (not map_of_column_0_c_below_a_choice_13) or
          map_of_column_0_c_below_a_choice_14;
      else
        map_of_column_0_c_below_a_choice_15 := (not map_of_column_0_c_below_a_choice_13) and
          map_of_column_0_c_below_a_choice_14;
      end if;
      map_of_column_0_c_below_a_value_7 := ((map_column_2 / 128) mod 2) = 1;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice_16 := map_of_column_0_b_below_a_value_11;
      else
        map_of_column_0_c_below_a_choice_16 := map_of_column_0_c_below_a_value_7;
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choice_17 := map_of_column_0_b_below_a_value_11;
      else
        map_of_column_0_c_below_a_choice_17 := map_of_column_0_b_below_a_value_12;
      end if;
      if map_of_column_0_c_below_a_choice_15 then
        map_of_column_0_c_below_a_choice_18 := (not map_of_column_0_c_below_a_choice_16) or
          map_of_column_0_c_below_a_choice_17;
      else
        map_of_column_0_c_below_a_choice_18 := (not map_of_column_0_c_below_a_choice_16) and
          map_of_column_0_c_below_a_choice_17;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice_19 := (map_column_1 / 256) = 1;
      else
        map_of_column_0_c_below_a_choice_19 := (map_column_2 / 256) = 1;
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choice_20 := (map_column_1 / 256) = 1;
      else
        map_of_column_0_c_below_a_choice_20 := (other_2 / 256) = 1;
      end if;
      if (not map_of_column_0_c_below_a_value_2) and map_of_column_0_b_below_a_value_2 and (not map_counter_next_frame)
        then
        map_of_column_0_c_below_b_choice := map_of_column_0_c_below_a_value and (not map_of_column_0_b_below_a_value)
          and (not map_counter_next_frame);
      else
        map_of_column_0_c_below_b_choice := map_of_column_0_c_below_a_value or (not map_of_column_0_b_below_a_value) or
          map_counter_next_frame;
      end if;
      if map_of_column_0_c_below_b_choice then
        map_of_column_0_c_below_b_choice_2 := map_of_column_0_c_below_a_value_3 or (not
          map_of_column_0_b_below_a_value_3) or map_counter_next_frame;
      else
        map_of_column_0_c_below_b_choice_2 := map_of_column_0_c_below_a_value_3 and (not
          map_of_column_0_b_below_a_value_3) and (not map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_b_choice_2 then
        map_of_column_0_c_below_b_choice_3 := map_of_column_0_c_below_a_value_4 or (not
          map_of_column_0_b_below_a_value_5) or map_counter_next_frame;
      else
        map_of_column_0_c_below_b_choice_3 := map_of_column_0_c_below_a_value_4 and (not
          map_of_column_0_b_below_a_value_5) and (not map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_b_choice_3 then
        map_of_column_0_c_below_b_choice_4 := map_of_column_0_c_below_a_value_5 or (not
          map_of_column_0_b_below_a_value_7) or map_counter_next_frame;
      else
        map_of_column_0_c_below_b_choice_4 := map_of_column_0_c_below_a_value_5 and (not
          map_of_column_0_b_below_a_value_7) and (not map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_b_choice_4 then
        map_of_column_0_c_below_b_choice_5 := map_of_column_0_c_below_a_value_6 or (not
          map_of_column_0_b_below_a_value_9) or map_counter_next_frame;
      else
        map_of_column_0_c_below_b_choice_5 := map_of_column_0_c_below_a_value_6 and (not
          map_of_column_0_b_below_a_value_9) and (not map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_b_choice_5 then
        map_of_column_0_c_below_b_choice_6 := map_of_column_0_c_below_a_value_7 or (not
          map_of_column_0_b_below_a_value_11) or map_counter_next_frame;
      else
        map_of_column_0_c_below_b_choice_6 := map_of_column_0_c_below_a_value_7 and (not
          map_of_column_0_b_below_a_value_11) and (not map_counter_next_frame);
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
      map_of_low_0_b_below_a_value := ((map_low_0_0 / 2) mod 2) = 1;
      if (map_low_0_0 mod 2) = 1 then
        map_of_low_0_b_below_a_choice := (not (((map_low_1_0 / 2) mod 2) = 1)) or (not ((map_low_1_0 mod 2) = 1));
      else
        map_of_low_0_b_below_a_choice := not (((map_low_1_0 / 2) mod 2) = 1);
      end if;
      map_of_low_0_b_below_a_is_equal := (map_low_1_0 mod 4) = 0;
      if map_of_low_0_b_below_a_value then
        map_of_low_0_b_below_a_choice_2 := map_of_low_0_b_below_a_choice;
      else
        map_of_low_0_b_below_a_choice_2 := ((map_low_0_0 mod 2) = 1) and map_of_low_0_b_below_a_is_equal;
      end if;
      map_of_low_0_b_below_a_value_2 := ((map_low_0_0 / 4) mod 2) = 1;
      map_of_low_0_b_below_a_value_3 := ((map_low_1_0 / 4) mod 2) = 1;
      if map_of_low_0_b_below_a_choice_2 then
        map_of_low_0_b_below_a_choice_3 := (not map_of_low_0_b_below_a_value_2) and map_of_low_0_b_below_a_value_3;
      else
        map_of_low_0_b_below_a_choice_3 := (not map_of_low_0_b_below_a_value_2) or map_of_low_0_b_below_a_value_3;
      end if;
      map_of_low_0_b_below_a_value_4 := ((map_low_0_0 / 8) mod 2) = 1;
      map_of_low_0_b_below_a_value_5 := ((map_low_1_0 / 8) mod 2) = 1;
      if map_of_low_0_b_below_a_choice_3 then
        map_of_low_0_b_below_a_choice_4 := (not map_of_low_0_b_below_a_value_4) or map_of_low_0_b_below_a_value_5;
      else
        map_of_low_0_b_below_a_choice_4 := (not map_of_low_0_b_below_a_value_4) and map_of_low_0_b_below_a_value_5;
      end if;
      map_of_low_0_b_below_a_value_6 := ((map_low_0_0 / 16) mod 2) = 1;
      map_of_low_0_b_below_a_value_7 := ((map_low_1_0 / 16) mod 2) = 1;
      if map_of_low_0_b_below_a_choice_4 then
        map_of_low_0_b_below_a_choice_5 := (not map_of_low_0_b_below_a_value_6) or map_of_low_0_b_below_a_value_7;
      else
        map_of_low_0_b_below_a_choice_5 := (not map_of_low_0_b_below_a_value_6) and map_of_low_0_b_below_a_value_7;
      end if;
      map_of_low_0_b_below_a_value_8 := ((map_low_0_0 / 32) mod 2) = 1;
      map_of_low_0_b_below_a_value_9 := ((map_low_1_0 / 32) mod 2) = 1;
      if map_of_low_0_b_below_a_choice_5 then
        map_of_low_0_b_below_a_choice_6 := (not map_of_low_0_b_below_a_value_8) or map_of_low_0_b_below_a_value_9;
      else
        map_of_low_0_b_below_a_choice_6 := (not map_of_low_0_b_below_a_value_8) and map_of_low_0_b_below_a_value_9;
      end if;
      map_of_low_0_b_below_a_value_10 := ((map_low_0_0 / 64) mod 2) = 1;
      map_of_low_0_b_below_a_value_11 := ((map_low_1_0 / 64) mod 2) = 1;
      if map_of_low_0_b_below_a_choice_6 then
        map_of_low_0_b_below_a_choice_7 := (not map_of_low_0_b_below_a_value_10) or map_of_low_0_b_below_a_value_11;
      else
        map_of_low_0_b_below_a_choice_7 := (not map_of_low_0_b_below_a_value_10) and map_of_low_0_b_below_a_value_11;
      end if;
      map_of_low_0_c_below_a_value := ((map_low_2_0 / 2) mod 2) = 1;
      if (map_low_2_0 mod 2) = 1 then
        map_of_low_0_c_below_a_choice := not map_of_low_0_b_below_a_value;
      else
        map_of_low_0_c_below_a_choice := (map_low_0_0 mod 4) = 0;
      end if;
      if map_of_low_0_c_below_a_value then
        map_of_low_0_c_below_a_choice_2 := ((map_low_2_0 mod 2) = 1) or (not map_of_low_0_b_below_a_value) or (not
          ((map_low_0_0 mod 2) = 1));
      else
        map_of_low_0_c_below_a_choice_2 := map_of_low_0_c_below_a_choice;
      end if;
      if map_of_low_0_c_below_a_choice_2 then
        map_of_low_0_c_below_a_choice_3 := (not (((map_low_2_0 / 4) mod 2) = 1)) and map_of_low_0_b_below_a_value_2;
      else
        map_of_low_0_c_below_a_choice_3 := (not (((map_low_2_0 / 4) mod 2) = 1)) or map_of_low_0_b_below_a_value_2;
      end if;
      if map_of_low_0_c_below_a_choice_3 then
        map_of_low_0_c_below_a_choice_4 := (not (((map_low_2_0 / 8) mod 2) = 1)) or map_of_low_0_b_below_a_value_4;
      else
        map_of_low_0_c_below_a_choice_4 := (not (((map_low_2_0 / 8) mod 2) = 1)) and map_of_low_0_b_below_a_value_4;
      end if;
      if map_of_low_0_c_below_a_choice_4 then
        map_of_low_0_c_below_a_choice_5 := (not (((map_low_2_0 / 16) mod 2) = 1)) or map_of_low_0_b_below_a_value_6;
      else
        map_of_low_0_c_below_a_choice_5 := (not (((map_low_2_0 / 16) mod 2) = 1)) and map_of_low_0_b_below_a_value_6;
      end if;
      if map_of_low_0_c_below_a_choice_5 then
        map_of_low_0_c_below_a_choice_6 := (not (((map_low_2_0 / 32) mod 2) = 1)) or map_of_low_0_b_below_a_value_8;
      else
        map_of_low_0_c_below_a_choice_6 := (not (((map_low_2_0 / 32) mod 2) = 1)) and map_of_low_0_b_below_a_value_8;
      end if;
      if map_of_low_0_c_below_a_choice_6 then
        map_of_low_0_c_below_a_choice_7 := (not (((map_low_2_0 / 64) mod 2) = 1)) or map_of_low_0_b_below_a_value_10;
      else
        map_of_low_0_c_below_a_choice_7 := (not (((map_low_2_0 / 64) mod 2) = 1)) and map_of_low_0_b_below_a_value_10;
      end if;
      if (map_low_2_0 mod 2) = 1 then
        map_of_low_0_c_below_b_choice := not (((map_low_1_0 / 2) mod 2) = 1);
      else
        map_of_low_0_c_below_b_choice := map_of_low_0_b_below_a_is_equal;
      end if;
      if map_of_low_0_c_below_a_value then
        map_of_low_0_c_below_b_choice_2 := ((map_low_2_0 mod 2) = 1) or (not (((map_low_1_0 / 2) mod 2) = 1)) or (not
          ((map_low_1_0 mod 2) = 1));
      else
        map_of_low_0_c_below_b_choice_2 := map_of_low_0_c_below_b_choice;
      end if;
      if map_of_low_0_c_below_b_choice_2 then
        map_of_low_0_c_below_b_choice_3 := (not (((map_low_2_0 / 4) mod 2) = 1)) and map_of_low_0_b_below_a_value_3;
      else
        map_of_low_0_c_below_b_choice_3 := (not (((map_low_2_0 / 4) mod 2) = 1)) or map_of_low_0_b_below_a_value_3;
      end if;
      if map_of_low_0_c_below_b_choice_3 then
        map_of_low_0_c_below_b_choice_4 := (not (((map_low_2_0 / 8) mod 2) = 1)) or map_of_low_0_b_below_a_value_5;
      else
        map_of_low_0_c_below_b_choice_4 := (not (((map_low_2_0 / 8) mod 2) = 1)) and map_of_low_0_b_below_a_value_5;
      end if;
      if map_of_low_0_c_below_b_choice_4 then
        map_of_low_0_c_below_b_choice_5 := (not (((map_low_2_0 / 16) mod 2) = 1)) or map_of_low_0_b_below_a_value_7;
      else
        map_of_low_0_c_below_b_choice_5 := (not (((map_low_2_0 / 16) mod 2) = 1)) and map_of_low_0_b_below_a_value_7;
      end if;
      if map_of_low_0_c_below_b_choice_5 then
        map_of_low_0_c_below_b_choice_6 := (not (((map_low_2_0 / 32) mod 2) = 1)) or map_of_low_0_b_below_a_value_9;
      else
        map_of_low_0_c_below_b_choice_6 := (not (((map_low_2_0 / 32) mod 2) = 1)) and map_of_low_0_b_below_a_value_9;
      end if;
      if map_of_low_0_c_below_b_choice_6 then
        map_of_low_0_c_below_b_choice_7 := (not (((map_low_2_0 / 64) mod 2) = 1)) or map_of_low_0_b_below_a_value_11;
      else
        map_of_low_0_c_below_b_choice_7 := (not (((map_low_2_0 / 64) mod 2) = 1)) and map_of_low_0_b_below_a_value_11;
      end if;
      map_of_middle_0_b_below_a_value := ((map_middle_0_0 / 2) mod 2) = 1;
      if (map_middle_0_0 mod 2) = 1 then
        map_of_middle_0_b_below_a_choice := (not (((map_middle_1_0 / 2) mod 2) = 1)) or (not ((map_middle_1_0 mod 2) =
          1));
      else
        map_of_middle_0_b_below_a_choice := not (((map_middle_1_0 / 2) mod 2) = 1);
      end if;
      map_of_middle_0_b_below_a_is_equal := (map_middle_1_0 mod 4) = 0;
      if map_of_middle_0_b_below_a_value then
        map_of_middle_0_b_below_a_choice_2 := map_of_middle_0_b_below_a_choice;
      else
        map_of_middle_0_b_below_a_choice_2 := ((map_middle_0_0 mod 2) = 1) and map_of_middle_0_b_below_a_is_equal;
      end if;
      map_of_middle_0_b_below_a_value_2 := ((map_middle_0_0 / 4) mod 2) = 1;
      map_of_middle_0_b_below_a_value_3 := ((map_middle_1_0 / 4) mod 2) = 1;
      if map_of_middle_0_b_below_a_choice_2 then
        map_of_middle_0_b_below_a_choice_3 := (not map_of_middle_0_b_below_a_value_2) and
          map_of_middle_0_b_below_a_value_3;
      else
        map_of_middle_0_b_below_a_choice_3 := (not map_of_middle_0_b_below_a_value_2) or
          map_of_middle_0_b_below_a_value_3;
      end if;
      map_of_middle_0_b_below_a_value_4 := ((map_middle_0_0 / 8) mod 2) = 1;
      map_of_middle_0_b_below_a_value_5 := ((map_middle_1_0 / 8) mod 2) = 1;
      if map_of_middle_0_b_below_a_choice_3 then
        map_of_middle_0_b_below_a_choice_4 := (not map_of_middle_0_b_below_a_value_4) or
          map_of_middle_0_b_below_a_value_5;
      else
        map_of_middle_0_b_below_a_choice_4 := (not map_of_middle_0_b_below_a_value_4) and
          map_of_middle_0_b_below_a_value_5;
      end if;
      map_of_middle_0_b_below_a_value_6 := ((map_middle_0_0 / 16) mod 2) = 1;
      map_of_middle_0_b_below_a_value_7 := ((map_middle_1_0 / 16) mod 2) = 1;
      if map_of_middle_0_b_below_a_choice_4 then
        map_of_middle_0_b_below_a_choice_5 := (not map_of_middle_0_b_below_a_value_6) or
          map_of_middle_0_b_below_a_value_7;
      else
        map_of_middle_0_b_below_a_choice_5 := (not map_of_middle_0_b_below_a_value_6) and
          map_of_middle_0_b_below_a_value_7;
      end if;
      map_of_middle_0_b_below_a_value_8 := ((map_middle_0_0 / 32) mod 2) = 1;
      map_of_middle_0_b_below_a_value_9 := ((map_middle_1_0 / 32) mod 2) = 1;
      if map_of_middle_0_b_below_a_choice_5 then
        map_of_middle_0_b_below_a_choice_6 := (not map_of_middle_0_b_below_a_value_8) or
          map_of_middle_0_b_below_a_value_9;
      else
        map_of_middle_0_b_below_a_choice_6 := (not map_of_middle_0_b_below_a_value_8) and
          map_of_middle_0_b_below_a_value_9;
      end if;
      map_of_middle_0_b_below_a_value_10 := ((map_middle_0_0 / 64) mod 2) = 1;
      map_of_middle_0_b_below_a_value_11 := ((map_middle_1_0 / 64) mod 2) = 1;
      if map_of_middle_0_b_below_a_choice_6 then
        map_of_middle_0_b_below_a_choice_7 := (not map_of_middle_0_b_below_a_value_10) or
          map_of_middle_0_b_below_a_value_11;
      else
        map_of_middle_0_b_below_a_choice_7 := (not map_of_middle_0_b_below_a_value_10) and
          map_of_middle_0_b_below_a_value_11;
      end if;
      map_of_middle_0_c_below_a_value := ((map_middle_2_0 / 2) mod 2) = 1;
      if (map_middle_2_0 mod 2) = 1 then
        map_of_middle_0_c_below_a_choice := not map_of_middle_0_b_below_a_value;
      else
        map_of_middle_0_c_below_a_choice := (map_middle_0_0 mod 4) = 0;
      end if;
      if map_of_middle_0_c_below_a_value then
        map_of_middle_0_c_below_a_choice_2 := ((map_middle_2_0 mod 2) = 1) or (not map_of_middle_0_b_below_a_value) or
          (not ((map_middle_0_0 mod 2) = 1));
      else
        map_of_middle_0_c_below_a_choice_2 := map_of_middle_0_c_below_a_choice;
      end if;
      if map_of_middle_0_c_below_a_choice_2 then
        map_of_middle_0_c_below_a_choice_3 := (not (((map_middle_2_0 / 4) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_2;
      else
        map_of_middle_0_c_below_a_choice_3 := (not (((map_middle_2_0 / 4) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_2;
      end if;
      if map_of_middle_0_c_below_a_choice_3 then
        map_of_middle_0_c_below_a_choice_4 := (not (((map_middle_2_0 / 8) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_4;
      else
        map_of_middle_0_c_below_a_choice_4 := (not (((map_middle_2_0 / 8) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_4;
      end if;
      if map_of_middle_0_c_below_a_choice_4 then
        map_of_middle_0_c_below_a_choice_5 := (not (((map_middle_2_0 / 16) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_6;
      else
        map_of_middle_0_c_below_a_choice_5 := (not (((map_middle_2_0 / 16) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_6;
      end if;
      if map_of_middle_0_c_below_a_choice_5 then
        map_of_middle_0_c_below_a_choice_6 := (not (((map_middle_2_0 / 32) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_8;
      else
        map_of_middle_0_c_below_a_choice_6 := (not (((map_middle_2_0 / 32) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_8;
      end if;
      if map_of_middle_0_c_below_a_choice_6 then
        map_of_middle_0_c_below_a_choice_7 := (not (((map_middle_2_0 / 64) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_10;
      else
        map_of_middle_0_c_below_a_choice_7 := (not (((map_middle_2_0 / 64) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_10;
      end if;
      if (map_middle_2_0 mod 2) = 1 then
        map_of_middle_0_c_below_b_choice := not (((map_middle_1_0 / 2) mod 2) = 1);
      else
        map_of_middle_0_c_below_b_choice := map_of_middle_0_b_below_a_is_equal;
      end if;
      if map_of_middle_0_c_below_a_value then
        map_of_middle_0_c_below_b_choice_2 := ((map_middle_2_0 mod 2) = 1) or (not (((map_middle_1_0 / 2) mod 2) = 1))
          or (not ((map_middle_1_0 mod 2) = 1));
      else
        map_of_middle_0_c_below_b_choice_2 := map_of_middle_0_c_below_b_choice;
      end if;
      if map_of_middle_0_c_below_b_choice_2 then
        map_of_middle_0_c_below_b_choice_3 := (not (((map_middle_2_0 / 4) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_3;
      else
        map_of_middle_0_c_below_b_choice_3 := (not (((map_middle_2_0 / 4) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_3;
      end if;
      if map_of_middle_0_c_below_b_choice_3 then
        map_of_middle_0_c_below_b_choice_4 := (not (((map_middle_2_0 / 8) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_5;
      else
        map_of_middle_0_c_below_b_choice_4 := (not (((map_middle_2_0 / 8) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_5;
      end if;
      if map_of_middle_0_c_below_b_choice_4 then
        map_of_middle_0_c_below_b_choice_5 := (not (((map_middle_2_0 / 16) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_7;
      else
        map_of_middle_0_c_below_b_choice_5 := (not (((map_middle_2_0 / 16) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_7;
      end if;
      if map_of_middle_0_c_below_b_choice_5 then
        map_of_middle_0_c_below_b_choice_6 := (not (((map_middle_2_0 / 32) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_9;
      else
        map_of_middle_0_c_below_b_choice_6 := (not (((map_middle_2_0 / 32) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_9;
      end if;
      if map_of_middle_0_c_below_b_choice_6 then
        map_of_middle_0_c_below_b_choice_7 := (not (((map_middle_2_0 / 64) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_11;
      else
        map_of_middle_0_c_below_b_choice_7 := (not (((map_middle_2_0 / 64) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_11;
      end if;
      map_of_high_0_b_below_a_value := ((map_high_0_0 / 2) mod 2) = 1;
      if (map_high_0_0 mod 2) = 1 then
        map_of_high_0_b_below_a_choice := (not (((map_high_1_0 / 2) mod 2) = 1)) or (not ((map_high_1_0 mod 2) = 1));
      else
        map_of_high_0_b_below_a_choice := not (((map_high_1_0 / 2) mod 2) = 1);
      end if;
      map_of_high_0_b_below_a_is_equal := (map_high_1_0 mod 4) = 0;
      if map_of_high_0_b_below_a_value then
        map_of_high_0_b_below_a_choice_2 := map_of_high_0_b_below_a_choice;
      else
        map_of_high_0_b_below_a_choice_2 := ((map_high_0_0 mod 2) = 1) and map_of_high_0_b_below_a_is_equal;
      end if;
      map_of_high_0_b_below_a_value_2 := ((map_high_0_0 / 4) mod 2) = 1;
      map_of_high_0_b_below_a_value_3 := ((map_high_1_0 / 4) mod 2) = 1;
      if map_of_high_0_b_below_a_choice_2 then
        map_of_high_0_b_below_a_choice_3 := (not map_of_high_0_b_below_a_value_2) and map_of_high_0_b_below_a_value_3;
      else
        map_of_high_0_b_below_a_choice_3 := (not map_of_high_0_b_below_a_value_2) or map_of_high_0_b_below_a_value_3;
      end if;
      map_of_high_0_b_below_a_value_4 := ((map_high_0_0 / 8) mod 2) = 1;
      map_of_high_0_b_below_a_value_5 := ((map_high_1_0 / 8) mod 2) = 1;
      if map_of_high_0_b_below_a_choice_3 then
        map_of_high_0_b_below_a_choice_4 := (not map_of_high_0_b_below_a_value_4) or map_of_high_0_b_below_a_value_5;
      else
        map_of_high_0_b_below_a_choice_4 := (not map_of_high_0_b_below_a_value_4) and map_of_high_0_b_below_a_value_5;
      end if;
      map_of_high_0_b_below_a_value_6 := ((map_high_0_0 / 16) mod 2) = 1;
      map_of_high_0_b_below_a_value_7 := ((map_high_1_0 / 16) mod 2) = 1;
      if map_of_high_0_b_below_a_choice_4 then
        map_of_high_0_b_below_a_choice_5 := (not map_of_high_0_b_below_a_value_6) or map_of_high_0_b_below_a_value_7;
      else
        map_of_high_0_b_below_a_choice_5 := (not map_of_high_0_b_below_a_value_6) and map_of_high_0_b_below_a_value_7;
      end if;
      map_of_high_0_b_below_a_value_8 := ((map_high_0_0 / 32) mod 2) = 1;
      map_of_high_0_b_below_a_value_9 := ((map_high_1_0 / 32) mod 2) = 1;
      if map_of_high_0_b_below_a_choice_5 then
        map_of_high_0_b_below_a_choice_6 := (not map_of_high_0_b_below_a_value_8) or map_of_high_0_b_below_a_value_9;
      else
        map_of_high_0_b_below_a_choice_6 := (not map_of_high_0_b_below_a_value_8) and map_of_high_0_b_below_a_value_9;
      end if;
      map_of_high_0_b_below_a_value_10 := ((map_high_0_0 / 64) mod 2) = 1;
      map_of_high_0_b_below_a_value_11 := ((map_high_1_0 / 64) mod 2) = 1;
      if map_of_high_0_b_below_a_choice_6 then
        map_of_high_0_b_below_a_choice_7 := (not map_of_high_0_b_below_a_value_10) or map_of_high_0_b_below_a_value_11;
      else
        map_of_high_0_b_below_a_choice_7 := (not map_of_high_0_b_below_a_value_10) and map_of_high_0_b_below_a_value_11;
      end if;
      map_of_high_0_c_below_a_value := ((map_high_2_0 / 2) mod 2) = 1;
      if (map_high_2_0 mod 2) = 1 then
        map_of_high_0_c_below_a_choice := not map_of_high_0_b_below_a_value;
      else
        map_of_high_0_c_below_a_choice := (map_high_0_0 mod 4) = 0;
      end if;
      if map_of_high_0_c_below_a_value then
        map_of_high_0_c_below_a_choice_2 := ((map_high_2_0 mod 2) = 1) or (not map_of_high_0_b_below_a_value) or (not
          ((map_high_0_0 mod 2) = 1));
      else
        map_of_high_0_c_below_a_choice_2 := map_of_high_0_c_below_a_choice;
      end if;
      if map_of_high_0_c_below_a_choice_2 then
        map_of_high_0_c_below_a_choice_3 := (not (((map_high_2_0 / 4) mod 2) = 1)) and map_of_high_0_b_below_a_value_2;
      else
        map_of_high_0_c_below_a_choice_3 := (not (((map_high_2_0 / 4) mod 2) = 1)) or map_of_high_0_b_below_a_value_2;
      end if;
      if map_of_high_0_c_below_a_choice_3 then
        map_of_high_0_c_below_a_choice_4 := (not (((map_high_2_0 / 8) mod 2) = 1)) or map_of_high_0_b_below_a_value_4;
      else
        map_of_high_0_c_below_a_choice_4 := (not (((map_high_2_0 / 8) mod 2) = 1)) and map_of_high_0_b_below_a_value_4;
      end if;
      if map_of_high_0_c_below_a_choice_4 then
        map_of_high_0_c_below_a_choice_5 := (not (((map_high_2_0 / 16) mod 2) = 1)) or map_of_high_0_b_below_a_value_6;
      else
        map_of_high_0_c_below_a_choice_5 := (not (((map_high_2_0 / 16) mod 2) = 1)) and map_of_high_0_b_below_a_value_6;
      end if;
      if map_of_high_0_c_below_a_choice_5 then
        map_of_high_0_c_below_a_choice_6 := (not (((map_high_2_0 / 32) mod 2) = 1)) or map_of_high_0_b_below_a_value_8;
      else
        map_of_high_0_c_below_a_choice_6 := (not (((map_high_2_0 / 32) mod 2) = 1)) and map_of_high_0_b_below_a_value_8;
      end if;
      if map_of_high_0_c_below_a_choice_6 then
        map_of_high_0_c_below_a_choice_7 := (not (((map_high_2_0 / 64) mod 2) = 1)) or map_of_high_0_b_below_a_value_10;
      else
        map_of_high_0_c_below_a_choice_7 := (not (((map_high_2_0 / 64) mod 2) = 1)) and
          map_of_high_0_b_below_a_value_10;
      end if;
      if (map_high_2_0 mod 2) = 1 then
        map_of_high_0_c_below_b_choice := not (((map_high_1_0 / 2) mod 2) = 1);
      else
        map_of_high_0_c_below_b_choice := map_of_high_0_b_below_a_is_equal;
      end if;
      if map_of_high_0_c_below_a_value then
        map_of_high_0_c_below_b_choice_2 := ((map_high_2_0 mod 2) = 1) or (not (((map_high_1_0 / 2) mod 2) = 1)) or
          (not ((map_high_1_0 mod 2) = 1));
      else
        map_of_high_0_c_below_b_choice_2 := map_of_high_0_c_below_b_choice;
      end if;
      if map_of_high_0_c_below_b_choice_2 then
        map_of_high_0_c_below_b_choice_3 := (not (((map_high_2_0 / 4) mod 2) = 1)) and map_of_high_0_b_below_a_value_3;
      else
        map_of_high_0_c_below_b_choice_3 := (not (((map_high_2_0 / 4) mod 2) = 1)) or map_of_high_0_b_below_a_value_3;
      end if;
      if map_of_high_0_c_below_b_choice_3 then
        map_of_high_0_c_below_b_choice_4 := (not (((map_high_2_0 / 8) mod 2) = 1)) or map_of_high_0_b_below_a_value_5;
      else
        map_of_high_0_c_below_b_choice_4 := (not (((map_high_2_0 / 8) mod 2) = 1)) and map_of_high_0_b_below_a_value_5;
      end if;
      if map_of_high_0_c_below_b_choice_4 then
        map_of_high_0_c_below_b_choice_5 := (not (((map_high_2_0 / 16) mod 2) = 1)) or map_of_high_0_b_below_a_value_7;
      else
        map_of_high_0_c_below_b_choice_5 := (not (((map_high_2_0 / 16) mod 2) = 1)) and map_of_high_0_b_below_a_value_7;
      end if;
      if map_of_high_0_c_below_b_choice_5 then
        map_of_high_0_c_below_b_choice_6 := (not (((map_high_2_0 / 32) mod 2) = 1)) or map_of_high_0_b_below_a_value_9;
      else
        map_of_high_0_c_below_b_choice_6 := (not (((map_high_2_0 / 32) mod 2) = 1)) and map_of_high_0_b_below_a_value_9;
      end if;
      if map_of_high_0_c_below_b_choice_6 then
        map_of_high_0_c_below_b_choice_7 := (not (((map_high_2_0 / 64) mod 2) = 1)) or map_of_high_0_b_below_a_value_11;
      else
        map_of_high_0_c_below_b_choice_7 := (not (((map_high_2_0 / 64) mod 2) = 1)) and
          map_of_high_0_b_below_a_value_11;
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
      map_of_all_0_b_below_a_value := ((map_largest_low_0 / 2) mod 2) = 1;
      if (map_largest_low_0 mod 2) = 1 then
        map_of_all_0_b_below_a_choice := (not (((map_median_middle_0 / 2) mod 2) = 1)) or (not ((map_median_middle_0
          mod 2) = 1));
      else
        map_of_all_0_b_below_a_choice := not (((map_median_middle_0 / 2) mod 2) = 1);
      end if;
      map_of_all_0_b_below_a_is_equal := (map_median_middle_0 mod 4) = 0;
      if map_of_all_0_b_below_a_value then
        map_of_all_0_b_below_a_choice_2 := map_of_all_0_b_below_a_choice;
      else
        map_of_all_0_b_below_a_choice_2 := ((map_largest_low_0 mod 2) = 1) and map_of_all_0_b_below_a_is_equal;
      end if;
      map_of_all_0_b_below_a_value_2 := ((map_largest_low_0 / 4) mod 2) = 1;
      map_of_all_0_b_below_a_value_3 := ((map_median_middle_0 / 4) mod 2) = 1;
      if map_of_all_0_b_below_a_choice_2 then
        map_of_all_0_b_below_a_choice_3 := (not map_of_all_0_b_below_a_value_2) and map_of_all_0_b_below_a_value_3;
      else
        map_of_all_0_b_below_a_choice_3 := (not map_of_all_0_b_below_a_value_2) or map_of_all_0_b_below_a_value_3;
      end if;
      map_of_all_0_b_below_a_value_4 := ((map_largest_low_0 / 8) mod 2) = 1;
      map_of_all_0_b_below_a_value_5 := ((map_median_middle_0 / 8) mod 2) = 1;
      if map_of_all_0_b_below_a_choice_3 then
        map_of_all_0_b_below_a_choice_4 := (not map_of_all_0_b_below_a_value_4) or map_of_all_0_b_below_a_value_5;
      else
        map_of_all_0_b_below_a_choice_4 := (not map_of_all_0_b_below_a_value_4) and map_of_all_0_b_below_a_value_5;
      end if;
      map_of_all_0_b_below_a_value_6 := ((map_largest_low_0 / 16) mod 2) = 1;
      map_of_all_0_b_below_a_value_7 := ((map_median_middle_0 / 16) mod 2) = 1;
      if map_of_all_0_b_below_a_choice_4 then
        map_of_all_0_b_below_a_choice_5 := (not map_of_all_0_b_below_a_value_6) or map_of_all_0_b_below_a_value_7;
      else
        map_of_all_0_b_below_a_choice_5 := (not map_of_all_0_b_below_a_value_6) and map_of_all_0_b_below_a_value_7;
      end if;
      map_of_all_0_b_below_a_value_8 := ((map_largest_low_0 / 32) mod 2) = 1;
      map_of_all_0_b_below_a_value_9 := ((map_median_middle_0 / 32) mod 2) = 1;
      if map_of_all_0_b_below_a_choice_5 then
        map_of_all_0_b_below_a_choice_6 := (not map_of_all_0_b_below_a_value_8) or map_of_all_0_b_below_a_value_9;
      else
        map_of_all_0_b_below_a_choice_6 := (not map_of_all_0_b_below_a_value_8) and map_of_all_0_b_below_a_value_9;
      end if;
      map_of_all_0_b_below_a_value_10 := ((map_largest_low_0 / 64) mod 2) = 1;
      map_of_all_0_b_below_a_value_11 := ((map_median_middle_0 / 64) mod 2) = 1;
      if map_of_all_0_b_below_a_choice_6 then
        map_of_all_0_b_below_a_choice_7 := (not map_of_all_0_b_below_a_value_10) or map_of_all_0_b_below_a_value_11;
      else
        map_of_all_0_b_below_a_choice_7 := (not map_of_all_0_b_below_a_value_10) and map_of_all_0_b_below_a_value_11;
      end if;
      map_of_all_0_c_below_a_value := ((map_smallest_high_0 / 2) mod 2) = 1;
      if (map_smallest_high_0 mod 2) = 1 then
        map_of_all_0_c_below_a_choice := not map_of_all_0_b_below_a_value;
      else
        map_of_all_0_c_below_a_choice := (map_largest_low_0 mod 4) = 0;
      end if;
      if map_of_all_0_c_below_a_value then
        map_of_all_0_c_below_a_choice_2 := ((map_smallest_high_0 mod 2) = 1) or (not map_of_all_0_b_below_a_value) or
          (not ((map_largest_low_0 mod 2) = 1));
      else
        map_of_all_0_c_below_a_choice_2 := map_of_all_0_c_below_a_choice;
      end if;
      if map_of_all_0_c_below_a_choice_2 then
        map_of_all_0_c_below_a_choice_3 := (not (((map_smallest_high_0 / 4) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_2;
      else
        map_of_all_0_c_below_a_choice_3 := (not (((map_smallest_high_0 / 4) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_2;
      end if;
      if map_of_all_0_c_below_a_choice_3 then
        map_of_all_0_c_below_a_choice_4 := (not (((map_smallest_high_0 / 8) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_4;
      else
        map_of_all_0_c_below_a_choice_4 := (not (((map_smallest_high_0 / 8) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_4;
      end if;
      if map_of_all_0_c_below_a_choice_4 then
        map_of_all_0_c_below_a_choice_5 := (not (((map_smallest_high_0 / 16) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_6;
      else
        map_of_all_0_c_below_a_choice_5 := (not (((map_smallest_high_0 / 16) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_6;
      end if;
      if map_of_all_0_c_below_a_choice_5 then
        map_of_all_0_c_below_a_choice_6 := (not (((map_smallest_high_0 / 32) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_8;
      else
        map_of_all_0_c_below_a_choice_6 := (not (((map_smallest_high_0 / 32) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_8;
      end if;
      if map_of_all_0_c_below_a_choice_6 then
        map_of_all_0_c_below_a_choice_7 := (not (((map_smallest_high_0 / 64) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_10;
      else
        map_of_all_0_c_below_a_choice_7 := (not (((map_smallest_high_0 / 64) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_10;
      end if;
      if (map_smallest_high_0 mod 2) = 1 then
        map_of_all_0_c_below_b_choice := not (((map_median_middle_0 / 2) mod 2) = 1);
      else
        map_of_all_0_c_below_b_choice := map_of_all_0_b_below_a_is_equal;
      end if;
      if map_of_all_0_c_below_a_value then
        map_of_all_0_c_below_b_choice_2 := ((map_smallest_high_0 mod 2) = 1) or (not (((map_median_middle_0 / 2) mod 2)
          = 1)) or (not ((map_median_middle_0 mod 2) = 1));
      else
        map_of_all_0_c_below_b_choice_2 := map_of_all_0_c_below_b_choice;
      end if;
      if map_of_all_0_c_below_b_choice_2 then
        map_of_all_0_c_below_b_choice_3 := (not (((map_smallest_high_0 / 4) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_3;
      else
        map_of_all_0_c_below_b_choice_3 := (not (((map_smallest_high_0 / 4) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_3;
      end if;
      if map_of_all_0_c_below_b_choice_3 then
        map_of_all_0_c_below_b_choice_4 := (not (((map_smallest_high_0 / 8) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_5;
      else
        map_of_all_0_c_below_b_choice_4 := (not (((map_smallest_high_0 / 8) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_5;
      end if;
      if map_of_all_0_c_below_b_choice_4 then
        map_of_all_0_c_below_b_choice_5 := (not (((map_smallest_high_0 / 16) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_7;
      else
        map_of_all_0_c_below_b_choice_5 := (not (((map_smallest_high_0 / 16) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_7;
      end if;
      if map_of_all_0_c_below_b_choice_5 then
        map_of_all_0_c_below_b_choice_6 := (not (((map_smallest_high_0 / 32) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_9;
      else
        map_of_all_0_c_below_b_choice_6 := (not (((map_smallest_high_0 / 32) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_9;
      end if;
      if map_of_all_0_c_below_b_choice_6 then
        map_of_all_0_c_below_b_choice_7 := (not (((map_smallest_high_0 / 64) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_11;
      else
        map_of_all_0_c_below_b_choice_7 := (not (((map_smallest_high_0 / 64) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_11;
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
      map_newest_0 <= ((turn_ready mod 256) * 2) + (turn_ready / 256);
      map_arrives <= turn_ready_tag_row_start_all_2;
      map_behind <= map_line_ended and turn_ready_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_column_1 <= map_rows_ready_words_0 / 512;
      map_column_2 <= map_rows_ready_newest_0;
      map_at_column <= to_integer(other_1(9 downto 0));
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= to_integer(other_1(24 downto 24)) = 1;
      map_at_top <= to_integer(other_1(32 downto 32)) = 1;
      map_at_output <= to_integer(other_1(48 downto 48)) = 1;
      map_of_column_0_b <= map_column_1 / 2;
      map_column_passed_0_0 <= (map_column_1 mod 2) = 1;
      map_column_passed_1_0 <= map_column_passed_0_0;
      map_comparing_column <= map_at_column;
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
      map_of_middle_0_a <= map_middle_0_0;
      map_of_middle_0_b <= map_middle_1_0;
      map_of_middle_0_c <= map_middle_2_0;
      map_of_high_0_a <= map_high_0_0;
      map_of_high_0_b <= map_high_1_0;
      map_of_high_0_c <= map_high_2_0;
      map_of_all_0_a <= map_largest_low_0;
      map_of_all_0_b <= map_median_middle_0;
      map_of_all_0_c <= map_smallest_high_0;
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
        map_counter_group <= map_counter_group_choice * 32;
      else
        map_counter_group <= map_counter_group_choice_3;
      end if;
      if turn_ready_tag_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not turn_ready_tag_valid);
      end if;
      if map_at_top then
        map_of_column_0_a <= map_column_1 / 2;
      else
        map_of_column_0_a <= other_2 / 2;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c <= map_column_1 / 2;
      else
        map_of_column_0_c <= map_column_2 / 2;
      end if;
      if map_of_column_0_b_below_a_choice_9 then
        map_of_column_0_b_below_a <= (not ((map_column_1 / 256) = 1)) and ((other_2 / 256) = 1) and (not map_at_top);
      else
        map_of_column_0_b_below_a <= (not ((map_column_1 / 256) = 1)) or ((other_2 / 256) = 1) or map_at_top;
      end if;
      if map_of_column_0_c_below_a_choice_18 then
        map_of_column_0_c_below_a <= (not map_of_column_0_c_below_a_choice_19) or map_of_column_0_c_below_a_choice_20;
      else
        map_of_column_0_c_below_a <= (not map_of_column_0_c_below_a_choice_19) and map_of_column_0_c_below_a_choice_20;
      end if;
      if map_of_column_0_c_below_b_choice_6 then
        map_of_column_0_c_below_b <= (not ((map_column_2 / 256) = 1)) and ((map_column_1 / 256) = 1) and (not
          map_counter_next_frame);
      else
        map_of_column_0_c_below_b <= (not ((map_column_2 / 256) = 1)) or ((map_column_1 / 256) = 1) or
          map_counter_next_frame;
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
      if map_of_low_0_b_below_a_choice_7 then
        map_of_low_0_b_below_a <= ((map_low_0_0 / 128) = 1) and (not ((map_low_1_0 / 128) = 1));
      else
        map_of_low_0_b_below_a <= ((map_low_0_0 / 128) = 1) or (not ((map_low_1_0 / 128) = 1));
      end if;
      if map_of_low_0_c_below_a_choice_7 then
        map_of_low_0_c_below_a <= (not ((map_low_2_0 / 128) = 1)) or ((map_low_0_0 / 128) = 1);
      else
        map_of_low_0_c_below_a <= (not ((map_low_2_0 / 128) = 1)) and ((map_low_0_0 / 128) = 1);
      end if;
      if map_of_low_0_c_below_b_choice_7 then
        map_of_low_0_c_below_b <= (not ((map_low_2_0 / 128) = 1)) or ((map_low_1_0 / 128) = 1);
      else
        map_of_low_0_c_below_b <= (not ((map_low_2_0 / 128) = 1)) and ((map_low_1_0 / 128) = 1);
      end if;
      if map_of_middle_0_b_below_a_choice_7 then
        map_of_middle_0_b_below_a <= ((map_middle_0_0 / 128) = 1) and (not ((map_middle_1_0 / 128) = 1));
      else
        map_of_middle_0_b_below_a <= ((map_middle_0_0 / 128) = 1) or (not ((map_middle_1_0 / 128) = 1));
      end if;
      if map_of_middle_0_c_below_a_choice_7 then
        map_of_middle_0_c_below_a <= (not ((map_middle_2_0 / 128) = 1)) or ((map_middle_0_0 / 128) = 1);
      else
        map_of_middle_0_c_below_a <= (not ((map_middle_2_0 / 128) = 1)) and ((map_middle_0_0 / 128) = 1);
      end if;
      if map_of_middle_0_c_below_b_choice_7 then
        map_of_middle_0_c_below_b <= (not ((map_middle_2_0 / 128) = 1)) or ((map_middle_1_0 / 128) = 1);
      else
        map_of_middle_0_c_below_b <= (not ((map_middle_2_0 / 128) = 1)) and ((map_middle_1_0 / 128) = 1);
      end if;
      if map_of_high_0_b_below_a_choice_7 then
        map_of_high_0_b_below_a <= ((map_high_0_0 / 128) = 1) and (not ((map_high_1_0 / 128) = 1));
      else
        map_of_high_0_b_below_a <= ((map_high_0_0 / 128) = 1) or (not ((map_high_1_0 / 128) = 1));
      end if;
      if map_of_high_0_c_below_a_choice_7 then
        map_of_high_0_c_below_a <= (not ((map_high_2_0 / 128) = 1)) or ((map_high_0_0 / 128) = 1);
      else
        map_of_high_0_c_below_a <= (not ((map_high_2_0 / 128) = 1)) and ((map_high_0_0 / 128) = 1);
      end if;
      if map_of_high_0_c_below_b_choice_7 then
        map_of_high_0_c_below_b <= (not ((map_high_2_0 / 128) = 1)) or ((map_high_1_0 / 128) = 1);
      else
        map_of_high_0_c_below_b <= (not ((map_high_2_0 / 128) = 1)) and ((map_high_1_0 / 128) = 1);
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
      if map_of_all_0_b_below_a_choice_7 then
        map_of_all_0_b_below_a <= ((map_largest_low_0 / 128) = 1) and (not ((map_median_middle_0 / 128) = 1));
      else
        map_of_all_0_b_below_a <= ((map_largest_low_0 / 128) = 1) or (not ((map_median_middle_0 / 128) = 1));
      end if;
      if map_of_all_0_c_below_a_choice_7 then
        map_of_all_0_c_below_a <= (not ((map_smallest_high_0 / 128) = 1)) or ((map_largest_low_0 / 128) = 1);
      else
        map_of_all_0_c_below_a <= (not ((map_smallest_high_0 / 128) = 1)) and ((map_largest_low_0 / 128) = 1);
      end if;
      if map_of_all_0_c_below_b_choice_7 then
        map_of_all_0_c_below_b <= (not ((map_smallest_high_0 / 128) = 1)) or ((map_median_middle_0 / 128) = 1);
      else
        map_of_all_0_c_below_b <= (not ((map_smallest_high_0 / 128) = 1)) and ((map_median_middle_0 / 128) = 1);
      end if;
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choice_2;
      else
        map_out_disparity_0 <= map_out_disparity_0_choice_4;
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= (map_rows_ready_newest_0 * 512) + (map_rows_ready_words_0 / 512);
        map_write_column <= to_integer(other_1(9 downto 0));
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
      other_0 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 481))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other_1 <= other_0;
      other_2 <= ((map_rows_ready_words_0 mod 512) / 2) * 2;
      other_3 <= ((costswindow_first_7_count_5 + costswindow_first_7_count_6 + costswindow_first_7_count_4 +
        costswindow_first_7_count_7) * 256) + ((costswindow_first_7_count_9 + costswindow_first_7_count_10 +
        costswindow_first_7_count_8 + costswindow_first_7_count_11) * 65536) + ((costswindow_first_7_count_14 +
        costswindow_first_7_count_12 + costswindow_first_7_count_13) * 16777216) + costswindow_first_7_count_1 +
        costswindow_first_7_count_2 + costswindow_first_7_count_0 + costswindow_first_7_count_3;
      other_4 <= ((costswindow_first_6_count_5 + costswindow_first_6_count_6 + costswindow_first_6_count_4 +
        costswindow_first_6_count_7) * 256) + ((costswindow_first_6_count_9 + costswindow_first_6_count_10 +
        costswindow_first_6_count_8 + costswindow_first_6_count_11) * 65536) + ((costswindow_first_6_count_14 +
        costswindow_first_6_count_12 + costswindow_first_6_count_13) * 16777216) + costswindow_first_6_count_1 +
        costswindow_first_6_count_2 + costswindow_first_6_count_0 + costswindow_first_6_count_3;
      other_5 <= ((costswindow_first_5_count_5 + costswindow_first_5_count_6 + costswindow_first_5_count_4 +
        costswindow_first_5_count_7) * 256) + ((costswindow_first_5_count_9 + costswindow_first_5_count_10 +
        costswindow_first_5_count_8 + costswindow_first_5_count_11) * 65536) + ((costswindow_first_5_count_14 +
        costswindow_first_5_count_12 + costswindow_first_5_count_13) * 16777216) + costswindow_first_5_count_1 +
        costswindow_first_5_count_2 + costswindow_first_5_count_0 + costswindow_first_5_count_3;
      other_6 <= ((costswindow_first_4_count_5 + costswindow_first_4_count_6 + costswindow_first_4_count_4 +
        costswindow_first_4_count_7) * 256) + ((costswindow_first_4_count_9 + costswindow_first_4_count_10 +
        costswindow_first_4_count_8 + costswindow_first_4_count_11) * 65536) + ((costswindow_first_4_count_14 +
        costswindow_first_4_count_12 + costswindow_first_4_count_13) * 16777216) + costswindow_first_4_count_1 +
        costswindow_first_4_count_2 + costswindow_first_4_count_0 + costswindow_first_4_count_3;
      other_7 <= ((costswindow_first_3_count_5 + costswindow_first_3_count_6 + costswindow_first_3_count_4 +
        costswindow_first_3_count_7) * 256) + ((costswindow_first_3_count_9 + costswindow_first_3_count_10 +
        costswindow_first_3_count_8 + costswindow_first_3_count_11) * 65536) + ((costswindow_first_3_count_14 +
        costswindow_first_3_count_12 + costswindow_first_3_count_13) * 16777216) + costswindow_first_3_count_1 +
        costswindow_first_3_count_2 + costswindow_first_3_count_0 + costswindow_first_3_count_3;
      other_8 <= ((costswindow_first_2_count_5 + costswindow_first_2_count_6 + costswindow_first_2_count_4 +
        costswindow_first_2_count_7) * 256) + ((costswindow_first_2_count_9 + costswindow_first_2_count_10 +
        costswindow_first_2_count_8 + costswindow_first_2_count_11) * 65536) + ((costswindow_first_2_count_14 +
        costswindow_first_2_count_12 + costswindow_first_2_count_13) * 16777216) + costswindow_first_2_count_1 +
        costswindow_first_2_count_2 + costswindow_first_2_count_0 + costswindow_first_2_count_3;
      other_9 <= ((costswindow_first_1_count_5 + costswindow_first_1_count_6 + costswindow_first_1_count_4 +
        costswindow_first_1_count_7) * 256) + ((costswindow_first_1_count_9 + costswindow_first_1_count_10 +
        costswindow_first_1_count_8 + costswindow_first_1_count_11) * 65536) + ((costswindow_first_1_count_14 +
        costswindow_first_1_count_12 + costswindow_first_1_count_13) * 16777216) + costswindow_first_1_count_1 +
        costswindow_first_1_count_2 + costswindow_first_1_count_0 + costswindow_first_1_count_3;
      other_10 <= ((costswindow_first_0_count_5 + costswindow_first_0_count_6 + costswindow_first_0_count_4 +
        costswindow_first_0_count_7) * 256) + ((costswindow_first_0_count_9 + costswindow_first_0_count_10 +
        costswindow_first_0_count_8 + costswindow_first_0_count_11) * 65536) + ((costswindow_first_0_count_14 +
        costswindow_first_0_count_12 + costswindow_first_0_count_13) * 16777216) + costswindow_first_0_count_1 +
        costswindow_first_0_count_2 + costswindow_first_0_count_0 + costswindow_first_0_count_3;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 482;
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
        raster_place_group <= 480;
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
        line_centre_map_column_0 <= false;
        line_centre_first_column_0 <= false;
        line_centre_end_of_line_0 <= false;
        line_order_address <= 0;
        line_order_falls <= false;
        line_order_inside <= false;
        line_order_complete <= false;
        line_order_output <= false;
        line_order_first <= false;
        line_order_held_output <= false;
        line_order_turned_valid <= false;
        line_order_turned_output_column <= false;
        line_order_turned_start_of_frame <= false;
        line_comes_1 <= false;
        line_comes_2 <= false;
        line_comes_3 <= false;
        line_comes_4 <= false;
        line_comes_5 <= false;
        line_comes_6 <= false;
        line_comes_7 <= false;
        line_comes_8 <= false;
        line_comes_9 <= false;
        line_comes_10 <= false;
        line_comes_11 <= false;
        line_comes_12 <= false;
        line_comes_13 <= false;
        line_comes_14 <= false;
        line_comes_15 <= false;
        line_comes_16 <= false;
        line_comes_17 <= false;
        line_comes_18 <= false;
        line_comes_19 <= false;
        line_comes_20 <= false;
        line_comes_21 <= false;
        line_comes_22 <= false;
        line_comes_23 <= false;
        line_comes_24 <= false;
        line_comes_25 <= false;
        line_comes_26 <= false;
        line_comes_27 <= false;
        line_comes_28 <= false;
        line_comes_29 <= false;
        line_comes_30 <= false;
        line_comes_31 <= false;
        line_comes_32 <= false;
        line_comes_33 <= false;
        line_comes_34 <= false;
        line_comes_35 <= false;
        line_comes_36 <= false;
        line_comes_37 <= false;
        line_comes_38 <= false;
        line_comes_39 <= false;
        line_comes_40 <= false;
        line_comes_41 <= false;
        line_comes_42 <= false;
        line_comes_43 <= false;
        line_comes_44 <= false;
        line_comes_45 <= false;
        line_comes_46 <= false;
        line_comes_47 <= false;
        line_starts_phases_1 <= false;
        line_starts_phases_2 <= false;
        line_starts_phases_3 <= false;
        line_starts_phases_4 <= false;
        line_starts_phases_5 <= false;
        line_starts_phases_6 <= false;
        line_starts_phases_7 <= false;
        line_starts_phases_8 <= false;
        line_starts_phases_9 <= false;
        line_starts_phases_10 <= false;
        line_starts_phases_11 <= false;
        line_starts_phases_12 <= false;
        line_starts_phases_13 <= false;
        line_starts_phases_14 <= false;
        line_starts_phases_15 <= false;
        line_starts_phases_16 <= false;
        line_starts_phases_17 <= false;
        line_starts_phases_18 <= false;
        line_starts_phases_19 <= false;
        line_starts_phases_20 <= false;
        line_starts_phases_21 <= false;
        line_starts_phases_22 <= false;
        line_starts_phases_23 <= false;
        line_starts_phases_24 <= false;
        line_starts_phases_25 <= false;
        line_starts_phases_27 <= false;
        line_starts_phases_28 <= false;
        line_starts_phases_29 <= false;
        line_starts_phases_30 <= false;
        line_starts_phases_31 <= false;
        line_starts_phases_32 <= false;
        line_starts_phases_33 <= false;
        line_starts_phases_34 <= false;
        line_starts_phases_35 <= false;
        line_starts_phases_36 <= false;
        line_starts_phases_37 <= false;
        line_starts_phases_38 <= false;
        line_starts_phases_39 <= false;
        line_starts_phases_40 <= false;
        line_starts_phases_41 <= false;
        line_starts_phases_42 <= false;
        line_starts_phases_43 <= false;
        line_starts_phases_44 <= false;
        line_starts_phases_45 <= false;
        line_starts_phases_46 <= false;
        line_starts_phases_47 <= false;
        line_places_0_map_column <= false;
        line_places_0_first_column <= false;
        line_places_0_address <= 0;
        line_places_0_shown_output_column <= false;
        line_places_0_shown_start_of_frame <= false;
        line_places_0_shown_end_of_line <= false;
        line_places_1_map_column <= false;
        line_places_1_first_column <= false;
        line_places_1_address <= 0;
        line_places_1_shown_output_column <= false;
        line_places_1_shown_start_of_frame <= false;
        line_places_1_shown_end_of_line <= false;
        line_places_2_map_column <= false;
        line_places_2_shown_output_column <= false;
        line_places_2_shown_start_of_frame <= false;
        line_places_2_shown_end_of_line <= false;
        costsshift_new_tag_valid <= false;
        costsshift_count_phase <= 15;
        costsshift_read_tag_valid <= false;
        costsshift_read_count_phase <= 15;
        costsshift_write_phase <= 15;
        paths_cost_delay_ring_read_address <= 1;
        paths_cost_delay_ring_write_address <= 0;
        pathsleft_low_address <= 4;
        pathsleft_read_count_phase <= 15;
        pathsleft_ahead_count_phase <= 15;
        pathsleft_is_first <= false;
        pathsleft_write_count_phase <= 15;
        pathsleft_low_write_address <= 0;
        pathsabove_memory_read_address_0 <= 0;
        pathsabove_memory_read_address_2 <= 0;
        pathsabove_memory_write_address_0 <= 0;
        pathsabove_memory_write_address_1 <= 0;
        pathsabove_memory_write_address_2 <= 0;
        pathsabove_read_address_address <= 0;
        pathsabove_read_address_count_phase <= 15;
        pathsabove_write_address_address <= 0;
        pathsabove_write_address_is_here <= false;
        pathsabove_write_address_count_phase <= 15;
        pathsturn_sum_memory_read_address_0 <= 0;
        pathsturn_sum_memory_read_address_2 <= 0;
        pathsturn_sum_memory_write_address_0 <= 0;
        pathsturn_sum_memory_write_address_1 <= 0;
        pathsturn_sum_memory_write_address_2 <= 0;
        pathsturn_cost_memory_read_address_0 <= 0;
        pathsturn_cost_memory_read_address_2 <= 0;
        pathsturn_cost_memory_write_address_0 <= 0;
        pathsturn_cost_memory_write_address_1 <= 0;
        pathsturn_cost_memory_write_address_2 <= 0;
        pathsturn_smallest_address <= 0;
        pathsturn_read_address_address <= 0;
        pathsturn_read_address_count_phase <= 15;
        pathsturn_sum_read_address <= 0;
        pathsturn_write_smallest_address <= 0;
        pathsturn_write_address_address <= 0;
        pathsturn_write_address_is_here <= false;
        pathsturn_write_address_count_phase <= 15;
        pathsturn_sum_write_address_0 <= 0;
        pathsturn_sum_write_address_1 <= 0;
        pathsturn_writes_sums_0 <= false;
        pathsturn_writes_sums_1 <= false;
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
        turn_order_turned_valid <= false;
        turn_order_turned_map_column <= false;
        turn_order_turned_start_of_frame <= false;
        turn_order_turned_end_of_line <= false;
        turn_comes <= false;
        turn_read_tag_valid <= false;
        turn_read_tag_map_column <= false;
        turn_read_tag_start_of_frame <= false;
        turn_read_tag_end_of_line <= false;
        turn_write_place <= 0;
        turn_ready_tag_valid <= false;
        turn_ready_tag_row_start <= false;
        turn_ready_tag_map_column <= false;
        turn_ready_tag_start_of_frame <= false;
        turn_ready_tag_end_of_line <= false;
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
        other_1 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
