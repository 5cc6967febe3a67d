-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration tiny_sgm_subpixel: 40x12, 12 disparities, window 3x3, P1 5, P2 22, 1 pixel pair a clock.
-- Options: disparities 12, subpixel true, slice_disparities 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_sgm_subpixel
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_sgm_subpixel is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 12;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 29;
    latency_clocks : positive := 45;
    flush_groups : positive := 207;
    gap_groups : natural := 0
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
  assert width_px = 40 report "stereo_core_tiny_sgm_subpixel: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 12 report "stereo_core_tiny_sgm_subpixel: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 12 report "stereo_core_tiny_sgm_subpixel: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_sgm_subpixel: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_tiny_sgm_subpixel: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 29 report "stereo_core_tiny_sgm_subpixel: output_width_px is " & integer'image(output_width_px) & " but this core has 29" severity failure;
  assert latency_clocks = 45 report "stereo_core_tiny_sgm_subpixel: latency_clocks is " & integer'image(latency_clocks) & " but this core has 45" severity failure;
  assert flush_groups = 207 report "stereo_core_tiny_sgm_subpixel: flush_groups is " & integer'image(flush_groups) & " but this core has 207" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_sgm_subpixel: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_sgm_subpixel is
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
  signal transform_right_filter_column_4_4 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_1, transform_read_row_inside_2, transform_read_row_inside_3 : boolean;
  signal transform_read_row_inside_4, transform_read_column_inside_0, transform_read_column_inside_1 : boolean;
  signal transform_read_column_inside_2, transform_read_column_inside_3, transform_read_column_inside_4 : boolean;
  signal transform_read_start_of_frame, transform_read_valid, transform_ready_row_inside_0 : boolean;
  signal transform_ready_row_inside_1, transform_ready_row_inside_2, transform_ready_row_inside_3 : boolean;
  signal transform_ready_row_inside_4, transform_ready_column_inside_0, transform_ready_column_inside_1 : boolean;
  signal transform_ready_column_inside_2, transform_ready_column_inside_3, transform_ready_column_inside_4 : boolean;
  signal transform_ready_start_of_frame, transform_ready_valid, transform_columns_row_inside_0 : boolean;
  signal transform_columns_row_inside_1, transform_columns_row_inside_2, transform_columns_row_inside_3 : boolean;
  signal transform_columns_row_inside_4, transform_columns_column_inside_0, transform_columns_column_inside_1 : boolean;
  signal transform_columns_column_inside_2, transform_columns_column_inside_3 : boolean;
  signal transform_columns_column_inside_4, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_1 : boolean;
  signal transform_filtering_0_column_inside_2, transform_filtering_0_column_inside_3 : boolean;
  signal transform_filtering_0_column_inside_4, transform_filtering_0_start_of_frame : boolean;
  signal transform_filtering_0_valid, transform_filtering_1_start_of_frame, transform_filtering_1_valid : boolean;
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 63;
  signal transform_write_column : natural range 0 to 63;
  signal transform_counter_group : natural range 0 to 15;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16777215;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16777215;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 16777215;
  signal delay_delayed_0 : unsigned(23 downto 0);
  signal delay_column : natural range 0 to 63;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_2, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_first_cost, delay_tag_map_column, delay_tag_output_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_words_0 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words_1, rows_search_rows_ready_newest_0 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_0, rows_search_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_words_0 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_1, rows_reference_rows_ready_newest_0 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_0, rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_search_0, rows_search_1, rows_search_2, rows_reference_0, rows_reference_1 : natural range 0 to 16777215;
  signal rows_reference_2 : natural range 0 to 16777215;
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
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 16777215;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_1_0 : natural range 0 to 16777215;
  signal slice0shift_search_1_1, slice0shift_search_1_2, slice0shift_search_1_3 : natural range 0 to 16777215;
  signal slice0shift_search_1_4, slice0shift_search_2_0, slice0shift_search_2_1 : natural range 0 to 16777215;
  signal slice0shift_search_2_2, slice0shift_search_2_3, slice0shift_search_2_4 : natural range 0 to 16777215;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 16777215;
  signal slice0shift_search_out_0, slice0shift_search_out_1, slice0shift_search_out_2 : natural range 0 to 16777215;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
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
  signal slice0cost_pixels_first_2_0_count_0, slice0cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_2, slice0cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_4, slice0cost_pixels_first_2_0_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_0_count_6, slice0cost_pixels_first_2_0_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_0, slice0cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_2, slice0cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_4, slice0cost_pixels_first_2_1_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_1_count_6, slice0cost_pixels_first_2_1_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_0, slice0cost_pixels_first_2_2_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_2, slice0cost_pixels_first_2_2_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_4, slice0cost_pixels_first_2_2_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_2_count_6, slice0cost_pixels_first_2_2_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_0, slice0cost_pixels_first_2_3_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_2, slice0cost_pixels_first_2_3_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_4, slice0cost_pixels_first_2_3_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_3_count_6, slice0cost_pixels_first_2_3_count_7 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_0, slice0cost_pixels_first_2_4_count_1 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_2, slice0cost_pixels_first_2_4_count_3 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_4, slice0cost_pixels_first_2_4_count_5 : natural range 0 to 3;
  signal slice0cost_pixels_first_2_4_count_6, slice0cost_pixels_first_2_4_count_7 : natural range 0 to 3;
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
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 24;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_1_0 : natural range 0 to 24;
  signal slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2, slice0cost_pixels_cost_1_3 : natural range 0 to 24;
  signal slice0cost_pixels_cost_1_4, slice0cost_pixels_cost_2_0, slice0cost_pixels_cost_2_1 : natural range 0 to 24;
  signal slice0cost_pixels_cost_2_2, slice0cost_pixels_cost_2_3, slice0cost_pixels_cost_2_4 : natural range 0 to 24;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 24;
  signal slice0cost_single_0_3, slice0cost_single_0_4 : natural range 0 to 24;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_0_3 : natural range 0 to 48;
  signal slice0cost_pair_0_4 : natural range 0 to 48;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 72;
  signal slice0cost_column_0_3, slice0cost_column_0_4 : natural range 0 to 72;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 72;
  signal slice0window_partial_0_0_3, slice0window_partial_0_0_4 : natural range 0 to 72;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 144;
  signal slice0window_partial_0_1_3, slice0window_partial_0_1_4 : natural range 0 to 144;
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_output_column, slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 216;
  signal slice0window_sum_0_3, slice0window_sum_0_4 : natural range 0 to 216;
  -- slice0
  signal slice0_held_0_0, slice0_held_0_1, slice0_held_0_2, slice0_held_0_3, slice0_held_0_4 : natural range 0 to 13;
  signal slice0_held_1_0, slice0_held_1_1, slice0_held_1_2, slice0_held_1_3, slice0_held_1_4 : natural range 0 to 13;
  signal slice0_held_2_0, slice0_held_2_1, slice0_held_2_2, slice0_held_2_3, slice0_held_2_4 : natural range 0 to 13;
  signal slice0_tag_0_valid, slice0_tag_0_map_column, slice0_tag_0_output_column, slice0_tag_0_first_column : boolean;
  signal slice0_tag_0_start_of_frame, slice0_tag_0_end_of_line, slice0_tag_1_valid, slice0_tag_1_map_column : boolean;
  signal slice0_tag_1_output_column, slice0_tag_1_first_column, slice0_tag_1_start_of_frame : boolean;
  signal slice0_tag_1_end_of_line, slice0_tag_2_valid, slice0_tag_2_map_column, slice0_tag_2_output_column : boolean;
  signal slice0_tag_2_first_column, slice0_tag_2_start_of_frame, slice0_tag_2_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 16777215;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_1_0 : natural range 0 to 16777215;
  signal slice1shift_search_1_1, slice1shift_search_1_2, slice1shift_search_1_3 : natural range 0 to 16777215;
  signal slice1shift_search_1_4, slice1shift_search_2_0, slice1shift_search_2_1 : natural range 0 to 16777215;
  signal slice1shift_search_2_2, slice1shift_search_2_3, slice1shift_search_2_4 : natural range 0 to 16777215;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 16777215;
  signal slice1shift_search_out_0, slice1shift_search_out_1, slice1shift_search_out_2 : natural range 0 to 16777215;
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
  signal slice1cost_pixels_first_2_0_count_0, slice1cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_0_count_2, slice1cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_0_count_4, slice1cost_pixels_first_2_0_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_0_count_6, slice1cost_pixels_first_2_0_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_0, slice1cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_2, slice1cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_4, slice1cost_pixels_first_2_1_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_1_count_6, slice1cost_pixels_first_2_1_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_0, slice1cost_pixels_first_2_2_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_2, slice1cost_pixels_first_2_2_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_4, slice1cost_pixels_first_2_2_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_2_count_6, slice1cost_pixels_first_2_2_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_3_count_0, slice1cost_pixels_first_2_3_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_3_count_2, slice1cost_pixels_first_2_3_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_3_count_4, slice1cost_pixels_first_2_3_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_3_count_6, slice1cost_pixels_first_2_3_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_4_count_0, slice1cost_pixels_first_2_4_count_1 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_4_count_2, slice1cost_pixels_first_2_4_count_3 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_4_count_4, slice1cost_pixels_first_2_4_count_5 : natural range 0 to 3;
  signal slice1cost_pixels_first_2_4_count_6, slice1cost_pixels_first_2_4_count_7 : natural range 0 to 3;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 24;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_1_0 : natural range 0 to 24;
  signal slice1cost_pixels_cost_1_1, slice1cost_pixels_cost_1_2, slice1cost_pixels_cost_1_3 : natural range 0 to 24;
  signal slice1cost_pixels_cost_1_4, slice1cost_pixels_cost_2_0, slice1cost_pixels_cost_2_1 : natural range 0 to 24;
  signal slice1cost_pixels_cost_2_2, slice1cost_pixels_cost_2_3, slice1cost_pixels_cost_2_4 : natural range 0 to 24;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 24;
  signal slice1cost_single_0_3, slice1cost_single_0_4 : natural range 0 to 24;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2, slice1cost_pair_0_3 : natural range 0 to 48;
  signal slice1cost_pair_0_4 : natural range 0 to 48;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 72;
  signal slice1cost_column_0_3, slice1cost_column_0_4 : natural range 0 to 72;
  signal slice1cost_tag_border_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 72;
  signal slice1window_partial_0_0_3, slice1window_partial_0_0_4 : natural range 0 to 72;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 144;
  signal slice1window_partial_0_1_3, slice1window_partial_0_1_4 : natural range 0 to 144;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 216;
  signal slice1window_sum_0_3, slice1window_sum_0_4 : natural range 0 to 216;
  -- slice1
  signal slice1_held_0_0, slice1_held_0_1, slice1_held_0_2, slice1_held_0_3, slice1_held_0_4 : natural range 0 to 13;
  signal slice1_held_1_0, slice1_held_1_1, slice1_held_1_2, slice1_held_1_3, slice1_held_1_4 : natural range 0 to 13;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_1_0 : natural range 0 to 16777215;
  signal slice2shift_search_1_1, slice2shift_search_2_0, slice2shift_search_2_1 : natural range 0 to 16777215;
  signal slice2shift_reference_0, slice2shift_reference_1, slice2shift_reference_2 : natural range 0 to 16777215;
  -- slice2cost
  signal slice2cost_pixels_first_0_0_count_0, slice2cost_pixels_first_0_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_2, slice2cost_pixels_first_0_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_4, slice2cost_pixels_first_0_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_0_count_6, slice2cost_pixels_first_0_0_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_0, slice2cost_pixels_first_0_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_2, slice2cost_pixels_first_0_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_4, slice2cost_pixels_first_0_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_0_1_count_6, slice2cost_pixels_first_0_1_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_0, slice2cost_pixels_first_1_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_2, slice2cost_pixels_first_1_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_4, slice2cost_pixels_first_1_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_0_count_6, slice2cost_pixels_first_1_0_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_0, slice2cost_pixels_first_1_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_2, slice2cost_pixels_first_1_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_4, slice2cost_pixels_first_1_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_1_1_count_6, slice2cost_pixels_first_1_1_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_0, slice2cost_pixels_first_2_0_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_2, slice2cost_pixels_first_2_0_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_4, slice2cost_pixels_first_2_0_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_0_count_6, slice2cost_pixels_first_2_0_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_0, slice2cost_pixels_first_2_1_count_1 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_2, slice2cost_pixels_first_2_1_count_3 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_4, slice2cost_pixels_first_2_1_count_5 : natural range 0 to 3;
  signal slice2cost_pixels_first_2_1_count_6, slice2cost_pixels_first_2_1_count_7 : natural range 0 to 3;
  signal slice2cost_pixels_cost_0_0, slice2cost_pixels_cost_0_1, slice2cost_pixels_cost_1_0 : natural range 0 to 24;
  signal slice2cost_pixels_cost_1_1, slice2cost_pixels_cost_2_0, slice2cost_pixels_cost_2_1 : natural range 0 to 24;
  signal slice2cost_single_0_0, slice2cost_single_0_1 : natural range 0 to 24;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1 : natural range 0 to 48;
  signal slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 72;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1 : natural range 0 to 72;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1 : natural range 0 to 144;
  signal slice2window_sum_0_0, slice2window_sum_0_1 : natural range 0 to 216;
  -- slice2
  signal slice2_held_0_0, slice2_held_0_1 : natural range 0 to 13;
  -- entry
  signal entry_next_cost_0, entry_next_cost_1, entry_next_cost_2, entry_next_cost_3 : natural range 0 to 13;
  signal entry_next_cost_4, entry_next_cost_5, entry_next_cost_6, entry_next_cost_7 : natural range 0 to 13;
  signal entry_next_cost_8, entry_next_cost_9, entry_next_cost_10, entry_next_cost_11 : natural range 0 to 13;
  signal entry_cost_0, entry_cost_1, entry_cost_2, entry_cost_3, entry_cost_4, entry_cost_5 : natural range 0 to 13;
  signal entry_cost_6, entry_cost_7, entry_cost_8, entry_cost_9, entry_cost_10, entry_cost_11 : natural range 0 to 13;
  signal entry_next_tag_valid, entry_next_tag_map_column, entry_next_tag_first_column : boolean;
  signal entry_next_tag_end_of_line, entry_next_top, entry_order_falls, entry_order_inside : boolean;
  signal entry_order_complete, entry_order_output, entry_order_first, entry_order_held_output : boolean;
  signal entry_order_turned_output_column, entry_order_turned_first_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag_valid, entry_tag_map_column, entry_tag_first_column, entry_tag_end_of_line, entry_top : boolean;
  signal entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 31;
  -- forward
  signal forward_smallest_smallest_0, forward_smallest_smallest_1, forward_smallest_smallest_2 : natural range 0 to 13;
  signal forward_smallest_smallest_3, forward_smallest_smallest_4, forward_smallest_smallest_5 : natural range 0 to 13;
  signal forward_smallest_next_smallest_0, forward_smallest_next_smallest_1 : natural range 0 to 13;
  signal forward_smallest_next_smallest_2, forward_smallest_next_next_smallest_0 : natural range 0 to 13;
  signal forward_smallest_next_next_smallest_1, forward_smallest_next_next_next_smallest_0 : natural range 0 to 13;
  signal forward_left_smallest, forward_above_ready_cost_0, forward_above_ready_cost_1 : natural range 0 to 13;
  signal forward_above_ready_cost_2, forward_above_ready_cost_3, forward_above_ready_cost_4 : natural range 0 to 13;
  signal forward_above_ready_cost_5, forward_above_ready_cost_6, forward_above_ready_cost_7 : natural range 0 to 13;
  signal forward_above_ready_cost_8, forward_above_ready_cost_9, forward_above_ready_cost_10 : natural range 0 to 13;
  signal forward_above_ready_cost_11, forward_smallest_cost_0, forward_smallest_cost_1 : natural range 0 to 13;
  signal forward_smallest_cost_2, forward_smallest_cost_3, forward_smallest_cost_4 : natural range 0 to 13;
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
  signal forward_above_total_0, forward_above_total_1, forward_above_total_2 : natural range 0 to 44;
  signal forward_above_total_3, forward_above_total_4, forward_above_total_5 : natural range 0 to 44;
  signal forward_above_total_6, forward_above_total_7, forward_above_total_8 : natural range 0 to 44;
  signal forward_above_total_9, forward_above_total_10, forward_above_total_11 : natural range 0 to 44;
  signal forward_above_tree_smallest_0, forward_above_tree_smallest_1 : natural range 0 to 44;
  signal forward_above_tree_smallest_2, forward_above_tree_smallest_3 : natural range 0 to 44;
  signal forward_above_tree_smallest_4, forward_above_tree_smallest_5 : natural range 0 to 44;
  signal forward_above_tree_next_smallest_0, forward_above_tree_next_smallest_1 : natural range 0 to 44;
  signal forward_above_tree_next_smallest_2, forward_above_tree_next_next_smallest_0 : natural range 0 to 44;
  signal forward_above_tree_next_next_smallest_1, forward_above_tree_next_next_next_smallest_0 : natural range 0 to 44;
  signal forward_above_smallest_copy_0 : natural range 0 to 44;
  signal forward_above_delay_held_0, forward_above_delay_held_1 : unsigned(29 downto 0);
  signal forward_above_delay_held_2 : unsigned(11 downto 0);
  signal forward_above_step_0, forward_above_step_1, forward_above_step_2, forward_above_step_3 : natural range 0 to 68;
  signal forward_above_step_4, forward_above_step_5, forward_above_step_6, forward_above_step_7 : natural range 0 to 68;
  signal forward_above_step_8, forward_above_step_9, forward_above_step_10 : natural range 0 to 68;
  signal forward_above_step_11 : natural range 0 to 68;
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
  signal sums_turn_write_smallest_0 : natural range 0 to 13;
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
  signal winnerswinner1_best_cost_0_0, winnerswinner1_best_cost_0_1 : natural range 0 to 127;
  signal winnerswinner1_best_cost_0_2, winnerswinner1_best_cost_0_3 : natural range 0 to 127;
  signal winnerswinner1_best_cost_0_4, winnerswinner1_best_cost_0_5 : natural range 0 to 127;
  signal winnerswinner1_best_below_0_0, winnerswinner1_best_below_0_1 : natural range 0 to 127;
  signal winnerswinner1_best_below_0_2, winnerswinner1_best_below_0_3 : natural range 0 to 127;
  signal winnerswinner1_best_below_0_4, winnerswinner1_best_below_0_5 : natural range 0 to 127;
  signal winnerswinner1_best_above_0_0, winnerswinner1_best_above_0_1 : natural range 0 to 127;
  signal winnerswinner1_best_above_0_2, winnerswinner1_best_above_0_3 : natural range 0 to 127;
  signal winnerswinner1_best_above_0_4, winnerswinner1_best_above_0_5 : natural range 0 to 127;
  signal winnerswinner1_best_first_0_1, winnerswinner1_best_first_0_2 : natural range 0 to 127;
  signal winnerswinner1_best_first_0_3, winnerswinner1_best_first_0_4 : natural range 0 to 127;
  signal winnerswinner1_best_first_0_5, winnerswinner1_best_last_0_0 : natural range 0 to 127;
  signal winnerswinner1_best_last_0_1, winnerswinner1_best_last_0_2 : natural range 0 to 127;
  signal winnerswinner1_best_last_0_3, winnerswinner1_best_last_0_4 : natural range 0 to 127;
  signal winnerswinner1_best_index_0_0, winnerswinner1_tag_valid, winnerswinner1_tag_map_column : boolean;
  signal winnerswinner1_tag_output_column, winnerswinner1_tag_start_of_frame, winnerswinner1_tag_end_of_line : boolean;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_best_index_0_3 : natural range 0 to 7;
  signal winnerswinner1_best_index_0_4 : natural range 0 to 9;
  signal winnerswinner1_best_index_0_5 : natural range 0 to 11;
  -- winnerswinner2
  signal winnerswinner2_best_cost_0_0, winnerswinner2_best_cost_0_1 : natural range 0 to 127;
  signal winnerswinner2_best_cost_0_2, winnerswinner2_best_below_0_0 : natural range 0 to 127;
  signal winnerswinner2_best_below_0_1, winnerswinner2_best_below_0_2 : natural range 0 to 127;
  signal winnerswinner2_best_above_0_0, winnerswinner2_best_above_0_1 : natural range 0 to 127;
  signal winnerswinner2_best_above_0_2, winnerswinner2_best_first_0_1 : natural range 0 to 127;
  signal winnerswinner2_best_first_0_2, winnerswinner2_best_last_0_0 : natural range 0 to 127;
  signal winnerswinner2_best_last_0_1 : natural range 0 to 127;
  signal winnerswinner2_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner2_best_index_0_1 : natural range 0 to 7;
  signal winnerswinner2_best_index_0_2 : natural range 0 to 11;
  signal winnerswinner2_tag_valid, winnerswinner2_tag_map_column, winnerswinner2_tag_output_column : boolean;
  signal winnerswinner2_tag_start_of_frame, winnerswinner2_tag_end_of_line : boolean;
  -- winnerswinner3
  signal winnerswinner3_best_cost_0_0, winnerswinner3_best_cost_0_1 : natural range 0 to 127;
  signal winnerswinner3_best_below_0_0, winnerswinner3_best_below_0_1 : natural range 0 to 127;
  signal winnerswinner3_best_above_0_0, winnerswinner3_best_above_0_1 : natural range 0 to 127;
  signal winnerswinner3_best_first_0_1, winnerswinner3_best_last_0_0 : natural range 0 to 127;
  signal winnerswinner3_best_index_0_0 : natural range 0 to 7;
  signal winnerswinner3_best_index_0_1 : natural range 0 to 11;
  signal winnerswinner3_tag_valid, winnerswinner3_tag_map_column, winnerswinner3_tag_output_column : boolean;
  signal winnerswinner3_tag_start_of_frame, winnerswinner3_tag_end_of_line : boolean;
  -- winnerswinner4
  signal winnerswinner4_best_cost_0_0, winnerswinner4_best_below_0_0 : natural range 0 to 127;
  signal winnerswinner4_best_above_0_0 : natural range 0 to 127;
  signal winnerswinner4_best_index_0_0 : natural range 0 to 11;
  signal winnerswinner4_tag_valid, winnerswinner4_tag_map_column, winnerswinner4_tag_output_column : boolean;
  signal winnerswinner4_tag_start_of_frame, winnerswinner4_tag_end_of_line : boolean;
  -- winners
  signal winners_best_cost_0_0, winners_best_below_0_0, winners_best_above_0_0 : natural range 0 to 127;
  signal winners_best_index_0_0 : natural range 0 to 11;
  signal winners_best_tag_valid, winners_best_tag_map_column, winners_best_tag_output_column : boolean;
  signal winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 11;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 11;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 11;
  signal refinement_disparity_9_0, refinement_disparity_10_0, refinement_disparity_11_0 : natural range 0 to 11;
  signal refinement_tag_0_valid, refinement_tag_0_map_column, refinement_tag_0_output_column : boolean;
  signal refinement_tag_0_start_of_frame, refinement_tag_0_end_of_line, refinement_tag_1_valid : boolean;
  signal refinement_tag_1_map_column, refinement_tag_1_output_column, refinement_tag_1_start_of_frame : boolean;
  signal refinement_tag_1_end_of_line, refinement_tag_2_valid, refinement_tag_2_map_column : boolean;
  signal refinement_tag_2_output_column, refinement_tag_2_start_of_frame, refinement_tag_2_end_of_line : boolean;
  signal refinement_tag_3_valid, refinement_tag_3_map_column, refinement_tag_3_output_column : boolean;
  signal refinement_tag_3_start_of_frame, refinement_tag_3_end_of_line, refinement_tag_4_valid : boolean;
  signal refinement_tag_4_map_column, refinement_tag_4_output_column, refinement_tag_4_start_of_frame : boolean;
  signal refinement_tag_4_end_of_line, refinement_tag_5_valid, refinement_tag_5_map_column : boolean;
  signal refinement_tag_5_output_column, refinement_tag_5_start_of_frame, refinement_tag_5_end_of_line : boolean;
  signal refinement_tag_6_valid, refinement_tag_6_map_column, refinement_tag_6_output_column : boolean;
  signal refinement_tag_6_start_of_frame, refinement_tag_6_end_of_line, refinement_tag_7_valid : boolean;
  signal refinement_tag_7_map_column, refinement_tag_7_output_column, refinement_tag_7_start_of_frame : boolean;
  signal refinement_tag_7_end_of_line, refinement_tag_8_valid, refinement_tag_8_map_column : boolean;
  signal refinement_tag_8_output_column, refinement_tag_8_start_of_frame, refinement_tag_8_end_of_line : boolean;
  signal refinement_tag_9_valid, refinement_tag_9_map_column, refinement_tag_9_output_column : boolean;
  signal refinement_tag_9_start_of_frame, refinement_tag_9_end_of_line, refinement_tag_10_valid : boolean;
  signal refinement_tag_10_map_column, refinement_tag_10_output_column, refinement_tag_10_start_of_frame : boolean;
  signal refinement_tag_10_end_of_line, refinement_tag_11_valid, refinement_tag_11_map_column : boolean;
  signal refinement_tag_11_output_column, refinement_tag_11_start_of_frame, refinement_tag_11_end_of_line : boolean;
  signal refinement_negative_0_0, refinement_negative_1_0, refinement_negative_2_0, refinement_negative_3_0 : boolean;
  signal refinement_negative_4_0, refinement_negative_5_0, refinement_negative_6_0, refinement_negative_7_0 : boolean;
  signal refinement_negative_8_0 : boolean;
  signal refinement_cost_0, refinement_below_0, refinement_above_0, refinement_u_0 : natural range 0 to 127;
  signal refinement_v_0, refinement_remainder_0_0, refinement_remainder_1_0 : natural range 0 to 127;
  signal refinement_remainder_2_0, refinement_remainder_3_0, refinement_remainder_4_0 : natural range 0 to 127;
  signal refinement_remainder_5_0, refinement_remainder_6_0, refinement_remainder_7_0 : natural range 0 to 127;
  signal refinement_divisor_0_0, refinement_divisor_1_0, refinement_divisor_2_0 : natural range 0 to 127;
  signal refinement_divisor_3_0, refinement_divisor_4_0, refinement_divisor_5_0 : natural range 0 to 127;
  signal refinement_divisor_6_0, refinement_divisor_7_0, refinement_fraction_0 : natural range 0 to 127;
  signal refinement_difference_0 : integer range -127 to 127;
  signal refinement_quotient_8_0 : natural range 0 to 255;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 31;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_held_output, turn_order_turned_valid, turn_order_turned_output_column : boolean;
  signal turn_order_turned_start_of_frame, turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid : boolean;
  signal turn_read_tag_output_column, turn_read_tag_start_of_frame, turn_read_tag_end_of_line : boolean;
  signal turn_ready_tag_valid, turn_ready_tag_output_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0 : natural range 0 to 65291;
  signal turn_read_words_0 : unsigned(13 downto 0);
  signal turn_ready : natural range 0 to 16383;
  -- map
  signal map_out_disparity_0 : natural range 0 to 65535;
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  -- other
  signal other_0, other_1 : boolean;
  signal other_2 : natural range 0 to 254;
  signal other_3 : natural range 0 to 252;
  signal other_4 : natural range 0 to 248;
  signal other_5 : natural range 0 to 240;
  signal other_6 : natural range 0 to 224;
  signal other_7 : natural range 0 to 192;
  signal other_8 : natural range 0 to 128;
  signal other_9, other_10, other_11, other_12, other_13, other_14, other_15, other_16 : natural range 0 to 256;
  signal other_17, other_18, other_19, other_20 : natural range 0 to 256;
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
  signal turn_read_words_0_memory_write_data : unsigned(13 downto 0);
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
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(23 downto 0);

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
  turn_read_words_0_memory_write_data <= to_unsigned((turn_write_words_0 mod 16384), 14);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 29, width => 14, address_bits => 5)
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

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 6);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words_1, 24);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 24);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 6);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 24);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 24);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 24);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 12, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3 : boolean;
    variable transform_read_column_inside_1_is_equal, transform_read_column_inside_1_is_equal_2 : boolean;
    variable transform_read_column_inside_1_choice, transform_read_column_inside_1_differs : boolean;
    variable transform_read_column_inside_3_choice, transform_read_column_inside_3_choice_2 : boolean;
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
    variable transform_left_filter_feature_0_value_7, transform_left_filter_feature_0_choice_187 : boolean;
    variable transform_left_filter_feature_0_value_8, transform_left_filter_feature_0_choice_188 : boolean;
    variable transform_left_filter_feature_0_value_9, transform_left_filter_feature_0_choice_189 : boolean;
    variable transform_left_filter_feature_0_value_10, transform_left_filter_feature_0_choice_190 : boolean;
    variable transform_left_filter_feature_0_value_11, transform_left_filter_feature_0_choice_191 : boolean;
    variable transform_left_filter_feature_0_choice_192, transform_right_filter_feature_0_value : boolean;
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
    variable transform_right_filter_feature_0_choice_186, transform_right_filter_feature_0_value_7 : boolean;
    variable transform_right_filter_feature_0_choice_187, transform_right_filter_feature_0_value_8 : boolean;
    variable transform_right_filter_feature_0_choice_188, transform_right_filter_feature_0_value_9 : boolean;
    variable transform_right_filter_feature_0_choice_189, transform_right_filter_feature_0_value_10 : boolean;
    variable transform_right_filter_feature_0_choice_190, transform_right_filter_feature_0_value_11 : boolean;
    variable transform_right_filter_feature_0_choice_191, transform_right_filter_feature_0_choice_192 : boolean;
    variable transform_counter_next_frame_choice, raster_place_group_is_equal, raster_place_group_is_equal_2 : boolean;
    variable raster_place_group_all, raster_place_group_is_equal_3, raster_place_group_choice_2 : boolean;
    variable raster_place_next_frame_choice, raster_place_next_frame_choice_2 : boolean;
    variable raster_place_next_frame_choice_3, raster_place_next_frame_choice_4 : boolean;
    variable delay_row_inside_1_is_not_less, delay_row_inside_1_is_less, delay_tag_first_cost_is_equal : boolean;
    variable delay_tag_map_column_is_not_less, delay_tag_map_column_is_less : boolean;
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
    variable slice0cost_pixels_first_0_0_count_7_value_2, slice0cost_pixels_first_1_0_count_0_value : boolean;
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
    variable slice0cost_pixels_first_2_0_count_7_value_2, slice1cost_pixels_first_0_0_count_0_value : boolean;
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
    variable slice1cost_pixels_first_1_0_count_7_value_2, slice1cost_pixels_first_2_0_count_0_value : boolean;
    variable slice1cost_pixels_first_2_0_count_0_value_2, slice1cost_pixels_first_2_0_count_1_value : boolean;
    variable slice1cost_pixels_first_2_0_count_1_value_2, slice1cost_pixels_first_2_0_count_1_value_3 : boolean;
    variable slice1cost_pixels_first_2_0_count_2_value, slice1cost_pixels_first_2_0_count_2_value_2 : boolean;
    variable slice1cost_pixels_first_2_0_count_3_value, slice1cost_pixels_first_2_0_count_3_value_2 : boolean;
    variable slice1cost_pixels_first_2_0_count_3_value_3, slice1cost_pixels_first_2_0_count_4_value : boolean;
    variable slice1cost_pixels_first_2_0_count_4_value_2, slice1cost_pixels_first_2_0_count_4_value_3 : boolean;
    variable slice1cost_pixels_first_2_0_count_5_value, slice1cost_pixels_first_2_0_count_5_value_2 : boolean;
    variable slice1cost_pixels_first_2_0_count_5_value_3, slice1cost_pixels_first_2_0_count_6_value : boolean;
    variable slice1cost_pixels_first_2_0_count_6_value_2, slice1cost_pixels_first_2_0_count_6_value_3 : boolean;
    variable slice1cost_pixels_first_2_0_count_7_value, slice1cost_pixels_first_2_0_count_7_value_2 : boolean;
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
    variable slice2cost_pixels_first_2_0_count_0_value, slice2cost_pixels_first_2_0_count_0_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_1_value, slice2cost_pixels_first_2_0_count_1_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_1_value_3, slice2cost_pixels_first_2_0_count_2_value : boolean;
    variable slice2cost_pixels_first_2_0_count_2_value_2, slice2cost_pixels_first_2_0_count_3_value : boolean;
    variable slice2cost_pixels_first_2_0_count_3_value_2, slice2cost_pixels_first_2_0_count_3_value_3 : boolean;
    variable slice2cost_pixels_first_2_0_count_4_value, slice2cost_pixels_first_2_0_count_4_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_4_value_3, slice2cost_pixels_first_2_0_count_5_value : boolean;
    variable slice2cost_pixels_first_2_0_count_5_value_2, slice2cost_pixels_first_2_0_count_5_value_3 : boolean;
    variable slice2cost_pixels_first_2_0_count_6_value, slice2cost_pixels_first_2_0_count_6_value_2 : boolean;
    variable slice2cost_pixels_first_2_0_count_6_value_3, slice2cost_pixels_first_2_0_count_7_value : boolean;
    variable slice2cost_pixels_first_2_0_count_7_value_2, entry_order_falls_any, entry_order_falls_all : boolean;
    variable entry_order_complete_all, entry_order_complete_any, entry_order_turned_output_column_choice : boolean;
    variable forward_left_start_cost_0_value, sums_right_start_cost_0_value, sums_turn_writes_copy_0_choice : boolean;
    variable winnerswinner1_best_index_0_0_choice, winnerswinner1_best_index_0_0_choice_2 : boolean;
    variable winnerswinner1_best_index_0_0_value, winnerswinner1_best_index_0_0_choice_3 : boolean;
    variable winnerswinner1_best_index_0_0_value_2, winnerswinner1_best_index_0_0_choice_4 : boolean;
    variable winnerswinner1_best_index_0_0_value_3, winnerswinner1_best_index_0_0_choice_5 : boolean;
    variable winnerswinner1_best_index_0_0_value_4, winnerswinner1_best_index_0_0_choice_6 : boolean;
    variable winnerswinner1_best_index_0_0_choice_7, winnerswinner1_best_index_0_1_choice : boolean;
    variable winnerswinner1_best_index_0_1_choice_2, winnerswinner1_best_index_0_1_value : boolean;
    variable winnerswinner1_best_index_0_1_choice_3, winnerswinner1_best_index_0_1_value_2 : boolean;
    variable winnerswinner1_best_index_0_1_choice_4, winnerswinner1_best_index_0_1_value_3 : boolean;
    variable winnerswinner1_best_index_0_1_choice_5, winnerswinner1_best_index_0_1_value_4 : boolean;
    variable winnerswinner1_best_index_0_1_choice_6, winnerswinner1_best_index_0_1_choice_7 : boolean;
    variable winnerswinner1_best_index_0_2_choice, winnerswinner1_best_index_0_2_choice_2 : boolean;
    variable winnerswinner1_best_index_0_2_value, winnerswinner1_best_index_0_2_choice_3 : boolean;
    variable winnerswinner1_best_index_0_2_value_2, winnerswinner1_best_index_0_2_choice_4 : boolean;
    variable winnerswinner1_best_index_0_2_value_3, winnerswinner1_best_index_0_2_choice_5 : boolean;
    variable winnerswinner1_best_index_0_2_value_4, winnerswinner1_best_index_0_2_choice_6 : boolean;
    variable winnerswinner1_best_index_0_2_choice_7, winnerswinner1_best_index_0_3_choice : boolean;
    variable winnerswinner1_best_index_0_3_choice_2, winnerswinner1_best_index_0_3_value : boolean;
    variable winnerswinner1_best_index_0_3_choice_3, winnerswinner1_best_index_0_3_value_2 : boolean;
    variable winnerswinner1_best_index_0_3_choice_4, winnerswinner1_best_index_0_3_value_3 : boolean;
    variable winnerswinner1_best_index_0_3_choice_5, winnerswinner1_best_index_0_3_value_4 : boolean;
    variable winnerswinner1_best_index_0_3_choice_6, winnerswinner1_best_index_0_3_choice_7 : boolean;
    variable winnerswinner1_best_index_0_4_choice, winnerswinner1_best_index_0_4_choice_2 : boolean;
    variable winnerswinner1_best_index_0_4_value, winnerswinner1_best_index_0_4_choice_3 : boolean;
    variable winnerswinner1_best_index_0_4_value_2, winnerswinner1_best_index_0_4_choice_4 : boolean;
    variable winnerswinner1_best_index_0_4_value_3, winnerswinner1_best_index_0_4_choice_5 : boolean;
    variable winnerswinner1_best_index_0_4_value_4, winnerswinner1_best_index_0_4_choice_6 : boolean;
    variable winnerswinner1_best_index_0_4_choice_7, winnerswinner1_best_index_0_5_choice : boolean;
    variable winnerswinner1_best_index_0_5_choice_2, winnerswinner1_best_index_0_5_value : boolean;
    variable winnerswinner1_best_index_0_5_choice_3, winnerswinner1_best_index_0_5_value_2 : boolean;
    variable winnerswinner1_best_index_0_5_choice_4, winnerswinner1_best_index_0_5_value_3 : boolean;
    variable winnerswinner1_best_index_0_5_choice_5, winnerswinner1_best_index_0_5_value_4 : boolean;
    variable winnerswinner1_best_index_0_5_choice_6, winnerswinner1_best_index_0_5_choice_7 : boolean;
    variable winnerswinner2_best_index_0_0_choice, winnerswinner2_best_index_0_0_choice_2 : boolean;
    variable winnerswinner2_best_index_0_0_value, winnerswinner2_best_index_0_0_choice_3 : boolean;
    variable winnerswinner2_best_index_0_0_value_2, winnerswinner2_best_index_0_0_choice_4 : boolean;
    variable winnerswinner2_best_index_0_0_value_3, winnerswinner2_best_index_0_0_choice_5 : boolean;
    variable winnerswinner2_best_index_0_0_value_4, winnerswinner2_best_index_0_0_choice_6 : boolean;
    variable winnerswinner2_best_index_0_0_choice_7, winnerswinner2_best_index_0_1_choice : boolean;
    variable winnerswinner2_best_index_0_1_choice_2, winnerswinner2_best_index_0_1_value : boolean;
    variable winnerswinner2_best_index_0_1_choice_3, winnerswinner2_best_index_0_1_value_2 : boolean;
    variable winnerswinner2_best_index_0_1_choice_4, winnerswinner2_best_index_0_1_value_3 : boolean;
    variable winnerswinner2_best_index_0_1_choice_5, winnerswinner2_best_index_0_1_value_4 : boolean;
    variable winnerswinner2_best_index_0_1_choice_6, winnerswinner2_best_index_0_1_choice_7 : boolean;
    variable winnerswinner2_best_index_0_2_choice, winnerswinner2_best_index_0_2_choice_2 : boolean;
    variable winnerswinner2_best_index_0_2_value, winnerswinner2_best_index_0_2_choice_3 : boolean;
    variable winnerswinner2_best_index_0_2_value_2, winnerswinner2_best_index_0_2_choice_4 : boolean;
    variable winnerswinner2_best_index_0_2_value_3, winnerswinner2_best_index_0_2_choice_5 : boolean;
    variable winnerswinner2_best_index_0_2_value_4, winnerswinner2_best_index_0_2_choice_6 : boolean;
    variable winnerswinner2_best_index_0_2_choice_7, winnerswinner3_best_index_0_0_choice : boolean;
    variable winnerswinner3_best_index_0_0_choice_2, winnerswinner3_best_index_0_0_value : boolean;
    variable winnerswinner3_best_index_0_0_choice_3, winnerswinner3_best_index_0_0_value_2 : boolean;
    variable winnerswinner3_best_index_0_0_choice_4, winnerswinner3_best_index_0_0_value_3 : boolean;
    variable winnerswinner3_best_index_0_0_choice_5, winnerswinner3_best_index_0_0_value_4 : boolean;
    variable winnerswinner3_best_index_0_0_choice_6, winnerswinner3_best_index_0_0_choice_7 : boolean;
    variable winnerswinner4_best_index_0_0_choice, winnerswinner4_best_index_0_0_choice_2 : boolean;
    variable winnerswinner4_best_index_0_0_value, winnerswinner4_best_index_0_0_choice_3 : boolean;
    variable winnerswinner4_best_index_0_0_value_2, winnerswinner4_best_index_0_0_choice_4 : boolean;
    variable winnerswinner4_best_index_0_0_value_3, winnerswinner4_best_index_0_0_choice_5 : boolean;
    variable winnerswinner4_best_index_0_0_value_4, winnerswinner4_best_index_0_0_choice_6 : boolean;
    variable winnerswinner4_best_index_0_0_choice_7, refinement_divisor_0_0_is_less, turn_order_address_any : boolean;
    variable turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_order_turned_output_column_choice : boolean;
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 3;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 15;
    variable raster_place_group_choice_3, raster_place_group_choice_4 : natural range 0 to 15;
    variable transform_left_filter_feature_0_choice_193 : natural range 0 to 31;
    variable transform_right_filter_feature_0_choice_193, forward_left_room_choice : natural range 0 to 31;
    variable forward_left_room_choice_2, forward_above_total_0_choice : natural range 0 to 31;
    variable forward_above_total_1_choice, forward_above_total_2_choice : natural range 0 to 31;
    variable forward_above_total_3_choice, forward_above_total_4_choice : natural range 0 to 31;
    variable forward_above_total_5_choice, forward_above_total_6_choice : natural range 0 to 31;
    variable forward_above_total_7_choice, forward_above_total_8_choice : natural range 0 to 31;
    variable forward_above_total_9_choice, forward_above_total_10_choice : natural range 0 to 31;
    variable forward_above_total_11_choice, sums_right_room_choice, sums_right_room_choice_2 : natural range 0 to 31;
    variable transform_left_filter_feature_0_choice_194 : natural range 0 to 1023;
    variable transform_right_filter_feature_0_choice_194 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_195 : natural range 0 to 8191;
    variable transform_right_filter_feature_0_choice_195 : natural range 0 to 8191;
    variable transform_left_filter_feature_0_choice_196 : natural range 0 to 524287;
    variable transform_right_filter_feature_0_choice_196 : natural range 0 to 524287;
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 31;
    variable entry_order_address_choice_2, refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable turn_order_address_choice_2 : natural range 0 to 7;
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
    variable forward_above_write_words_0_choice, forward_above_write_words_0_choice_2 : natural range 0 to 68;
    variable forward_above_write_words_0_choice_3, forward_above_write_words_0_choice_4 : natural range 0 to 68;
    variable forward_above_write_words_0_choice_5, forward_above_write_words_0_choice_6 : natural range 0 to 68;
    variable forward_above_write_words_1_choice, forward_above_write_words_1_choice_2 : natural range 0 to 68;
    variable forward_above_write_words_1_choice_3, forward_above_write_words_1_choice_4 : natural range 0 to 68;
    variable forward_above_write_words_1_choice_5, forward_above_write_words_1_choice_6 : natural range 0 to 68;
    variable winnerswinner2_best_below_0_0_choice, winnerswinner2_best_below_0_1_choice : natural range 0 to 127;
    variable winnerswinner2_best_below_0_2_choice, winnerswinner2_best_above_0_0_choice : natural range 0 to 127;
    variable winnerswinner2_best_above_0_1_choice, winnerswinner2_best_above_0_2_choice : natural range 0 to 127;
    variable winnerswinner3_best_below_0_0_choice, winnerswinner3_best_above_0_0_choice : natural range 0 to 127;
    variable winnerswinner4_best_below_0_0_choice, winnerswinner4_best_above_0_0_choice : natural range 0 to 127;
    variable refinement_divisor_0_0_choice, refinement_fraction_0_choice : natural range 0 to 127;
    variable refinement_remainder_1_0_difference : natural range 129 to 383;
    variable refinement_remainder_2_0_difference, refinement_remainder_3_0_difference : natural range 129 to 510;
    variable refinement_remainder_4_0_difference, refinement_remainder_5_0_difference : natural range 129 to 510;
    variable refinement_remainder_6_0_difference, refinement_remainder_7_0_difference : natural range 129 to 510;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
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
      transform_read_column_inside_1_is_equal := (transform_counter_column / 4) = 0;
      transform_read_column_inside_1_is_equal_2 := (transform_counter_column / 2) = 0;
      if transform_read_column_inside_1_is_equal_2 then
        transform_read_column_inside_1_choice := (transform_counter_column mod 4) = 0;
      else
        transform_read_column_inside_1_choice := ((transform_counter_column mod 2) = 1) or (((transform_counter_column
          / 2) mod 2) = 1);
      end if;
      transform_read_column_inside_1_differs := (transform_counter_column / 2) /= 0;
      if (transform_counter_column mod 2) = 1 then
        transform_read_column_inside_3_choice := ((transform_counter_column / 2) mod 8) = 0;
      else
        transform_read_column_inside_3_choice := ((transform_counter_column / 4) mod 4) = 0;
      end if;
      if transform_read_column_inside_1_is_equal_2 then
        transform_read_column_inside_3_choice_2 := (transform_counter_column / 16) = 0;
      else
        transform_read_column_inside_3_choice_2 := ((transform_counter_column / 32) = 1) or (((transform_counter_column
          / 16) mod 2) = 1);
      end if;
      transform_left_filter_feature_0_value := ((transform_left_filter_column_2_2 / 2) mod 2) = 1;
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        ((transform_left_filter_column_2_2 mod 2) = 1));
      if (transform_left_filter_column_4_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_2_2 mod 4) = 0;
      if ((transform_left_filter_column_4_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_2 := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choice_2 := ((transform_left_filter_column_4_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value_2 := ((transform_left_filter_column_2_2 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_2 then
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_3 := (not (((transform_left_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      transform_left_filter_feature_0_value_3 := ((transform_left_filter_column_2_2 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_3 then
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_4 := (not (((transform_left_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      transform_left_filter_feature_0_value_4 := ((transform_left_filter_column_2_2 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_4 then
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_5 := (not (((transform_left_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      transform_left_filter_feature_0_value_5 := ((transform_left_filter_column_2_2 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_5 then
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_6 := (not (((transform_left_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      transform_left_filter_feature_0_value_6 := ((transform_left_filter_column_2_2 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_6 then
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_7 := (not (((transform_left_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_7 then
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_4_0 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_8 := ((transform_left_filter_column_4_0 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_9 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_9 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_10 := transform_left_filter_feature_0_choice_9;
      else
        transform_left_filter_feature_0_choice_10 := ((transform_left_filter_column_4_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_10 then
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_11 := (not (((transform_left_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_11 then
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_12 := (not (((transform_left_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_12 then
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_13 := (not (((transform_left_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_13 then
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_14 := (not (((transform_left_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_14 then
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_15 := (not (((transform_left_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_15 then
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_4_1 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_16 := ((transform_left_filter_column_4_1 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_17 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_17 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_18 := transform_left_filter_feature_0_choice_17;
      else
        transform_left_filter_feature_0_choice_18 := ((transform_left_filter_column_4_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_18 then
        transform_left_filter_feature_0_choice_19 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_19 := (not (((transform_left_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_19 then
        transform_left_filter_feature_0_choice_20 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_20 := (not (((transform_left_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_20 then
        transform_left_filter_feature_0_choice_21 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_21 := (not (((transform_left_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_21 then
        transform_left_filter_feature_0_choice_22 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_22 := (not (((transform_left_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_22 then
        transform_left_filter_feature_0_choice_23 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_23 := (not (((transform_left_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_23 then
        transform_left_filter_feature_0_choice_24 := ((transform_left_filter_column_4_2 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_24 := ((transform_left_filter_column_4_2 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_25 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_25 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_26 := transform_left_filter_feature_0_choice_25;
      else
        transform_left_filter_feature_0_choice_26 := ((transform_left_filter_column_4_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_26 then
        transform_left_filter_feature_0_choice_27 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_27 := (not (((transform_left_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_27 then
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_28 := (not (((transform_left_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_28 then
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_29 := (not (((transform_left_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_29 then
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_30 := (not (((transform_left_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_30 then
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_31 := (not (((transform_left_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_31 then
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_4_3 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_32 := ((transform_left_filter_column_4_3 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_4_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_33 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_33 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_4_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_34 := transform_left_filter_feature_0_choice_33;
      else
        transform_left_filter_feature_0_choice_34 := ((transform_left_filter_column_4_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_34 then
        transform_left_filter_feature_0_choice_35 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_35 := (not (((transform_left_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_35 then
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_36 := (not (((transform_left_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_36 then
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_37 := (not (((transform_left_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_37 then
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_38 := (not (((transform_left_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_38 then
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_39 := (not (((transform_left_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_39 then
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_4_4 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_40 := ((transform_left_filter_column_4_4 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_41 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_41 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_42 := transform_left_filter_feature_0_choice_41;
      else
        transform_left_filter_feature_0_choice_42 := ((transform_left_filter_column_3_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_42 then
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_43 := (not (((transform_left_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_43 then
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_44 := (not (((transform_left_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_44 then
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_45 := (not (((transform_left_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_45 then
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_46 := (not (((transform_left_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_46 then
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_47 := (not (((transform_left_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_47 then
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_3_0 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_48 := ((transform_left_filter_column_3_0 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_49 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_49 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_50 := transform_left_filter_feature_0_choice_49;
      else
        transform_left_filter_feature_0_choice_50 := ((transform_left_filter_column_3_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_50 then
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_51 := (not (((transform_left_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_51 then
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_52 := (not (((transform_left_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_52 then
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_53 := (not (((transform_left_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_53 then
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_54 := (not (((transform_left_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_54 then
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_55 := (not (((transform_left_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_55 then
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_3_1 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_56 := ((transform_left_filter_column_3_1 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_57 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_57 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_58 := transform_left_filter_feature_0_choice_57;
      else
        transform_left_filter_feature_0_choice_58 := ((transform_left_filter_column_3_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_58 then
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_59 := (not (((transform_left_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_59 then
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_60 := (not (((transform_left_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_60 then
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_61 := (not (((transform_left_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_61 then
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_62 := (not (((transform_left_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_62 then
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_63 := (not (((transform_left_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_63 then
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_3_2 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_64 := ((transform_left_filter_column_3_2 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_65 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_65 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_66 := transform_left_filter_feature_0_choice_65;
      else
        transform_left_filter_feature_0_choice_66 := ((transform_left_filter_column_3_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_66 then
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_67 := (not (((transform_left_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_67 then
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_68 := (not (((transform_left_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_68 then
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_69 := (not (((transform_left_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_69 then
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_70 := (not (((transform_left_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_70 then
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_71 := (not (((transform_left_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_71 then
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_3_3 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_72 := ((transform_left_filter_column_3_3 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_3_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_73 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_73 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_3_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_74 := transform_left_filter_feature_0_choice_73;
      else
        transform_left_filter_feature_0_choice_74 := ((transform_left_filter_column_3_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_74 then
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_3_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_75 := (not (((transform_left_filter_column_3_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_75 then
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_3_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_76 := (not (((transform_left_filter_column_3_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_76 then
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_3_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_77 := (not (((transform_left_filter_column_3_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_77 then
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_3_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_78 := (not (((transform_left_filter_column_3_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_78 then
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_3_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_79 := (not (((transform_left_filter_column_3_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_79 then
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_3_4 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_80 := ((transform_left_filter_column_3_4 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_81 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_81 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_82 := transform_left_filter_feature_0_choice_81;
      else
        transform_left_filter_feature_0_choice_82 := ((transform_left_filter_column_2_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_82 then
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_83 := (not (((transform_left_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_83 then
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_84 := (not (((transform_left_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_84 then
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_85 := (not (((transform_left_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_85 then
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_86 := (not (((transform_left_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_86 then
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_87 := (not (((transform_left_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_87 then
        transform_left_filter_feature_0_choice_88 := transform_filtering_0_column_inside_2 and
          ((transform_left_filter_column_2_4 / 128) = 1) and (not ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_88 := transform_filtering_0_column_inside_2 and
          (((transform_left_filter_column_2_4 / 128) = 1) or (not ((transform_left_filter_column_2_2 / 128) = 1)));
      end if;
      if (transform_left_filter_column_2_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_89 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_89 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_90 := transform_left_filter_feature_0_choice_89;
      else
        transform_left_filter_feature_0_choice_90 := ((transform_left_filter_column_2_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_90 then
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_91 := (not (((transform_left_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_91 then
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_92 := (not (((transform_left_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_92 then
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_93 := (not (((transform_left_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_93 then
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_94 := (not (((transform_left_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_94 then
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_95 := (not (((transform_left_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_95 then
        transform_left_filter_feature_0_choice_96 := ((transform_left_filter_column_2_1 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_96 := ((transform_left_filter_column_2_1 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_97 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_97 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_98 := transform_left_filter_feature_0_choice_97;
      else
        transform_left_filter_feature_0_choice_98 := ((transform_left_filter_column_2_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_98 then
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_99 := (not (((transform_left_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_99 then
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_100 := (not (((transform_left_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_100 then
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_101 := (not (((transform_left_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_101 then
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_102 := (not (((transform_left_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_102 then
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_103 := (not (((transform_left_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_103 then
        transform_left_filter_feature_0_choice_104 := ((transform_left_filter_column_2_3 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_104 := ((transform_left_filter_column_2_3 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_105 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_105 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_2_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_106 := transform_left_filter_feature_0_choice_105;
      else
        transform_left_filter_feature_0_choice_106 := ((transform_left_filter_column_2_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_106 then
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_107 := (not (((transform_left_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_107 then
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_108 := (not (((transform_left_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_108 then
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_109 := (not (((transform_left_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_109 then
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_110 := (not (((transform_left_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_110 then
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_111 := (not (((transform_left_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_111 then
        transform_left_filter_feature_0_choice_112 := ((transform_left_filter_column_2_0 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_112 := ((transform_left_filter_column_2_0 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_113 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_113 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_114 := transform_left_filter_feature_0_choice_113;
      else
        transform_left_filter_feature_0_choice_114 := ((transform_left_filter_column_1_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_114 then
        transform_left_filter_feature_0_choice_115 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_115 := (not (((transform_left_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_115 then
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_116 := (not (((transform_left_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_116 then
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_117 := (not (((transform_left_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_117 then
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_118 := (not (((transform_left_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_118 then
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_119 := (not (((transform_left_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_119 then
        transform_left_filter_feature_0_choice_120 := ((transform_left_filter_column_1_3 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_120 := ((transform_left_filter_column_1_3 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_121 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_121 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_122 := transform_left_filter_feature_0_choice_121;
      else
        transform_left_filter_feature_0_choice_122 := ((transform_left_filter_column_1_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_122 then
        transform_left_filter_feature_0_choice_123 := (not (((transform_left_filter_column_1_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_123 := (not (((transform_left_filter_column_1_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_123 then
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_1_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_124 := (not (((transform_left_filter_column_1_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_124 then
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_1_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_125 := (not (((transform_left_filter_column_1_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_125 then
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_1_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_126 := (not (((transform_left_filter_column_1_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_126 then
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_1_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_127 := (not (((transform_left_filter_column_1_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_127 then
        transform_left_filter_feature_0_choice_128 := ((transform_left_filter_column_1_4 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_128 := ((transform_left_filter_column_1_4 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_129 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_129 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_130 := transform_left_filter_feature_0_choice_129;
      else
        transform_left_filter_feature_0_choice_130 := ((transform_left_filter_column_1_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_130 then
        transform_left_filter_feature_0_choice_131 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_131 := (not (((transform_left_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_131 then
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_132 := (not (((transform_left_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_132 then
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_133 := (not (((transform_left_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_133 then
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_134 := (not (((transform_left_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_134 then
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_135 := (not (((transform_left_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_135 then
        transform_left_filter_feature_0_choice_136 := ((transform_left_filter_column_1_2 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_136 := ((transform_left_filter_column_1_2 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_1 mod 2) = 1 then
        transform_left_filter_feature_0_choice_137 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_137 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_1 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_138 := transform_left_filter_feature_0_choice_137;
      else
        transform_left_filter_feature_0_choice_138 := ((transform_left_filter_column_1_1 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_138 then
        transform_left_filter_feature_0_choice_139 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_139 := (not (((transform_left_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_139 then
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_140 := (not (((transform_left_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_140 then
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_141 := (not (((transform_left_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_141 then
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_142 := (not (((transform_left_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_142 then
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_143 := (not (((transform_left_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_143 then
        transform_left_filter_feature_0_choice_144 := ((transform_left_filter_column_1_1 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_144 := ((transform_left_filter_column_1_1 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_1_0 mod 2) = 1 then
        transform_left_filter_feature_0_choice_145 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_145 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_1_0 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_146 := transform_left_filter_feature_0_choice_145;
      else
        transform_left_filter_feature_0_choice_146 := ((transform_left_filter_column_1_0 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_146 then
        transform_left_filter_feature_0_choice_147 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_147 := (not (((transform_left_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_147 then
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_148 := (not (((transform_left_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_148 then
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_149 := (not (((transform_left_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_149 then
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_150 := (not (((transform_left_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_150 then
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_151 := (not (((transform_left_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_151 then
        transform_left_filter_feature_0_choice_152 := ((transform_left_filter_column_1_0 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_152 := ((transform_left_filter_column_1_0 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_3 mod 2) = 1 then
        transform_left_filter_feature_0_choice_153 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_153 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_3 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_154 := transform_left_filter_feature_0_choice_153;
      else
        transform_left_filter_feature_0_choice_154 := ((transform_left_filter_column_0_3 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_154 then
        transform_left_filter_feature_0_choice_155 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_155 := (not (((transform_left_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_155 then
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_156 := (not (((transform_left_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_156 then
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_157 := (not (((transform_left_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_157 then
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_158 := (not (((transform_left_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_158 then
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_159 := (not (((transform_left_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_159 then
        transform_left_filter_feature_0_choice_160 := ((transform_left_filter_column_0_3 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_160 := ((transform_left_filter_column_0_3 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_4 mod 2) = 1 then
        transform_left_filter_feature_0_choice_161 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_161 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_4 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_162 := transform_left_filter_feature_0_choice_161;
      else
        transform_left_filter_feature_0_choice_162 := ((transform_left_filter_column_0_4 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_162 then
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_163 := (not (((transform_left_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_163 then
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_164 := (not (((transform_left_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_164 then
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_165 := (not (((transform_left_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_165 then
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_166 := (not (((transform_left_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_166 then
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_167 := (not (((transform_left_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_167 then
        transform_left_filter_feature_0_choice_168 := ((transform_left_filter_column_0_4 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_168 := ((transform_left_filter_column_0_4 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_0_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_169 := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice_169 := not transform_left_filter_feature_0_value;
      end if;
      if ((transform_left_filter_column_0_2 / 2) mod 2) = 1 then
        transform_left_filter_feature_0_choice_170 := transform_left_filter_feature_0_choice_169;
      else
        transform_left_filter_feature_0_choice_170 := ((transform_left_filter_column_0_2 mod 2) = 1) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choice_170 then
        transform_left_filter_feature_0_choice_171 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_left_filter_feature_0_value_2;
      else
        transform_left_filter_feature_0_choice_171 := (not (((transform_left_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_left_filter_feature_0_value_2;
      end if;
      if transform_left_filter_feature_0_choice_171 then
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_left_filter_feature_0_value_3;
      else
        transform_left_filter_feature_0_choice_172 := (not (((transform_left_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_left_filter_feature_0_value_3;
      end if;
      if transform_left_filter_feature_0_choice_172 then
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_left_filter_feature_0_value_4;
      else
        transform_left_filter_feature_0_choice_173 := (not (((transform_left_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_left_filter_feature_0_value_4;
      end if;
      if transform_left_filter_feature_0_choice_173 then
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_left_filter_feature_0_value_5;
      else
        transform_left_filter_feature_0_choice_174 := (not (((transform_left_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_left_filter_feature_0_value_5;
      end if;
      if transform_left_filter_feature_0_choice_174 then
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_left_filter_feature_0_value_6;
      else
        transform_left_filter_feature_0_choice_175 := (not (((transform_left_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_left_filter_feature_0_value_6;
      end if;
      if transform_left_filter_feature_0_choice_175 then
        transform_left_filter_feature_0_choice_176 := ((transform_left_filter_column_0_2 / 128) = 1) and (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_176 := ((transform_left_filter_column_0_2 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
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
          ((transform_left_filter_column_2_2 / 128) = 1));
      else
        transform_left_filter_feature_0_choice_184 := ((transform_left_filter_column_0_1 / 128) = 1) or (not
          ((transform_left_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_left_filter_column_2_2 mod 2) = 1 then
        transform_left_filter_feature_0_choice_185 := not (((transform_left_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_left_filter_feature_0_choice_185 := (transform_left_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value then
        transform_left_filter_feature_0_choice_186 := ((transform_left_filter_column_2_2 mod 2) = 1) or (not
          (((transform_left_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_left_filter_column_0_0 mod 2) = 1));
      else
        transform_left_filter_feature_0_choice_186 := transform_left_filter_feature_0_choice_185;
      end if;
      transform_left_filter_feature_0_value_7 := ((transform_left_filter_column_0_0 / 4) mod 2) = 1;
      if transform_left_filter_feature_0_choice_186 then
        transform_left_filter_feature_0_choice_187 := (not transform_left_filter_feature_0_value_2) and
          transform_left_filter_feature_0_value_7;
      else
        transform_left_filter_feature_0_choice_187 := (not transform_left_filter_feature_0_value_2) or
          transform_left_filter_feature_0_value_7;
      end if;
      transform_left_filter_feature_0_value_8 := ((transform_left_filter_column_0_0 / 8) mod 2) = 1;
      if transform_left_filter_feature_0_choice_187 then
        transform_left_filter_feature_0_choice_188 := (not transform_left_filter_feature_0_value_3) or
          transform_left_filter_feature_0_value_8;
      else
        transform_left_filter_feature_0_choice_188 := (not transform_left_filter_feature_0_value_3) and
          transform_left_filter_feature_0_value_8;
      end if;
      transform_left_filter_feature_0_value_9 := ((transform_left_filter_column_0_0 / 16) mod 2) = 1;
      if transform_left_filter_feature_0_choice_188 then
        transform_left_filter_feature_0_choice_189 := (not transform_left_filter_feature_0_value_4) or
          transform_left_filter_feature_0_value_9;
      else
        transform_left_filter_feature_0_choice_189 := (not transform_left_filter_feature_0_value_4) and
          transform_left_filter_feature_0_value_9;
      end if;
      transform_left_filter_feature_0_value_10 := ((transform_left_filter_column_0_0 / 32) mod 2) = 1;
      if transform_left_filter_feature_0_choice_189 then
        transform_left_filter_feature_0_choice_190 := (not transform_left_filter_feature_0_value_5) or
          transform_left_filter_feature_0_value_10;
      else
        transform_left_filter_feature_0_choice_190 := (not transform_left_filter_feature_0_value_5) and
          transform_left_filter_feature_0_value_10;
      end if;
      transform_left_filter_feature_0_value_11 := ((transform_left_filter_column_0_0 / 64) mod 2) = 1;
      if transform_left_filter_feature_0_choice_190 then
        transform_left_filter_feature_0_choice_191 := (not transform_left_filter_feature_0_value_6) or
          transform_left_filter_feature_0_value_11;
      else
        transform_left_filter_feature_0_choice_191 := (not transform_left_filter_feature_0_value_6) and
          transform_left_filter_feature_0_value_11;
      end if;
      if transform_left_filter_feature_0_choice_191 then
        transform_left_filter_feature_0_choice_192 := (not ((transform_left_filter_column_2_2 / 128) = 1)) or
          ((transform_left_filter_column_0_0 / 128) = 1);
      else
        transform_left_filter_feature_0_choice_192 := (not ((transform_left_filter_column_2_2 / 128) = 1)) and
          ((transform_left_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_left_filter_feature_0_choice_193 := (as_number(transform_left_filter_feature_0_choice_160) * 8) +
          (as_number(transform_left_filter_feature_0_choice_168) * 16) +
          (as_number(transform_left_filter_feature_0_choice_176) * 4) +
          (as_number(transform_left_filter_feature_0_choice_184) * 2) +
          as_number(transform_left_filter_feature_0_choice_192);
      else
        transform_left_filter_feature_0_choice_193 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_left_filter_feature_0_choice_194 := (as_number(transform_left_filter_feature_0_choice_120) * 256) +
          (as_number(transform_left_filter_feature_0_choice_128) * 512) +
          (as_number(transform_left_filter_feature_0_choice_136) * 128) +
          (as_number(transform_left_filter_feature_0_choice_144) * 64) +
          (as_number(transform_left_filter_feature_0_choice_152) * 32) + transform_left_filter_feature_0_choice_193;
      else
        transform_left_filter_feature_0_choice_194 := transform_left_filter_feature_0_choice_193;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_left_filter_feature_0_choice_195 := (as_number(transform_left_filter_feature_0_choice_96) * 2048) +
          (as_number(transform_left_filter_feature_0_choice_104) * 4096) +
          (as_number(transform_left_filter_feature_0_choice_112) * 1024) + transform_left_filter_feature_0_choice_194;
      else
        transform_left_filter_feature_0_choice_195 := transform_left_filter_feature_0_choice_194;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_left_filter_feature_0_choice_196 := (as_number(transform_left_filter_feature_0_choice_48) * 16384) +
          (as_number(transform_left_filter_feature_0_choice_56) * 32768) +
          (as_number(transform_left_filter_feature_0_choice_64) * 65536) +
          (as_number(transform_left_filter_feature_0_choice_72) * 131072) +
          (as_number(transform_left_filter_feature_0_choice_80) * 262144) +
          (as_number(transform_left_filter_feature_0_choice_88) * 8192) + transform_left_filter_feature_0_choice_195;
      else
        transform_left_filter_feature_0_choice_196 := (as_number(transform_left_filter_feature_0_choice_88) * 8192) +
          transform_left_filter_feature_0_choice_195;
      end if;
      transform_right_filter_feature_0_value := ((transform_right_filter_column_2_2 / 2) mod 2) = 1;
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        ((transform_right_filter_column_2_2 mod 2) = 1));
      if (transform_right_filter_column_4_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_2_2 mod 4) = 0;
      if ((transform_right_filter_column_4_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_2 := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choice_2 := ((transform_right_filter_column_4_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value_2 := ((transform_right_filter_column_2_2 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_2 then
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_3 := (not (((transform_right_filter_column_4_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      transform_right_filter_feature_0_value_3 := ((transform_right_filter_column_2_2 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_3 then
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_4 := (not (((transform_right_filter_column_4_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      transform_right_filter_feature_0_value_4 := ((transform_right_filter_column_2_2 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_4 then
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_5 := (not (((transform_right_filter_column_4_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      transform_right_filter_feature_0_value_5 := ((transform_right_filter_column_2_2 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_5 then
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_6 := (not (((transform_right_filter_column_4_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      transform_right_filter_feature_0_value_6 := ((transform_right_filter_column_2_2 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_6 then
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_7 := (not (((transform_right_filter_column_4_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_7 then
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_4_0 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_8 := ((transform_right_filter_column_4_0 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_9 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_9 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_10 := transform_right_filter_feature_0_choice_9;
      else
        transform_right_filter_feature_0_choice_10 := ((transform_right_filter_column_4_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_10 then
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_11 := (not (((transform_right_filter_column_4_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_11 then
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_12 := (not (((transform_right_filter_column_4_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_12 then
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_13 := (not (((transform_right_filter_column_4_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_13 then
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_14 := (not (((transform_right_filter_column_4_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_14 then
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_15 := (not (((transform_right_filter_column_4_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_15 then
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_4_1 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_16 := ((transform_right_filter_column_4_1 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_17 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_17 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_18 := transform_right_filter_feature_0_choice_17;
      else
        transform_right_filter_feature_0_choice_18 := ((transform_right_filter_column_4_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_18 then
        transform_right_filter_feature_0_choice_19 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_19 := (not (((transform_right_filter_column_4_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_19 then
        transform_right_filter_feature_0_choice_20 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_20 := (not (((transform_right_filter_column_4_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_20 then
        transform_right_filter_feature_0_choice_21 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_21 := (not (((transform_right_filter_column_4_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_21 then
        transform_right_filter_feature_0_choice_22 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_22 := (not (((transform_right_filter_column_4_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_22 then
        transform_right_filter_feature_0_choice_23 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_23 := (not (((transform_right_filter_column_4_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_23 then
        transform_right_filter_feature_0_choice_24 := ((transform_right_filter_column_4_2 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_24 := ((transform_right_filter_column_4_2 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_25 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_25 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_26 := transform_right_filter_feature_0_choice_25;
      else
        transform_right_filter_feature_0_choice_26 := ((transform_right_filter_column_4_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_26 then
        transform_right_filter_feature_0_choice_27 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_27 := (not (((transform_right_filter_column_4_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_27 then
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_28 := (not (((transform_right_filter_column_4_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_28 then
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_29 := (not (((transform_right_filter_column_4_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_29 then
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_30 := (not (((transform_right_filter_column_4_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_30 then
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_31 := (not (((transform_right_filter_column_4_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_31 then
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_4_3 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_32 := ((transform_right_filter_column_4_3 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_4_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_33 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_33 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_4_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_34 := transform_right_filter_feature_0_choice_33;
      else
        transform_right_filter_feature_0_choice_34 := ((transform_right_filter_column_4_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_34 then
        transform_right_filter_feature_0_choice_35 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_35 := (not (((transform_right_filter_column_4_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_35 then
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_36 := (not (((transform_right_filter_column_4_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_36 then
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_37 := (not (((transform_right_filter_column_4_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_37 then
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_38 := (not (((transform_right_filter_column_4_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_38 then
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_39 := (not (((transform_right_filter_column_4_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_39 then
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_4_4 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_40 := ((transform_right_filter_column_4_4 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_41 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_41 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_42 := transform_right_filter_feature_0_choice_41;
      else
        transform_right_filter_feature_0_choice_42 := ((transform_right_filter_column_3_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_42 then
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_43 := (not (((transform_right_filter_column_3_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_43 then
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_44 := (not (((transform_right_filter_column_3_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_44 then
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_45 := (not (((transform_right_filter_column_3_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_45 then
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_46 := (not (((transform_right_filter_column_3_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_46 then
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_47 := (not (((transform_right_filter_column_3_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_47 then
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_3_0 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_48 := ((transform_right_filter_column_3_0 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_49 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_49 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_50 := transform_right_filter_feature_0_choice_49;
      else
        transform_right_filter_feature_0_choice_50 := ((transform_right_filter_column_3_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_50 then
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_51 := (not (((transform_right_filter_column_3_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_51 then
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_52 := (not (((transform_right_filter_column_3_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_52 then
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_53 := (not (((transform_right_filter_column_3_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_53 then
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_54 := (not (((transform_right_filter_column_3_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_54 then
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_55 := (not (((transform_right_filter_column_3_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_55 then
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_3_1 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_56 := ((transform_right_filter_column_3_1 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_57 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_57 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_58 := transform_right_filter_feature_0_choice_57;
      else
        transform_right_filter_feature_0_choice_58 := ((transform_right_filter_column_3_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_58 then
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_59 := (not (((transform_right_filter_column_3_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_59 then
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_60 := (not (((transform_right_filter_column_3_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_60 then
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_61 := (not (((transform_right_filter_column_3_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_61 then
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_62 := (not (((transform_right_filter_column_3_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_62 then
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_63 := (not (((transform_right_filter_column_3_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_63 then
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_3_2 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_64 := ((transform_right_filter_column_3_2 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_65 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_65 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_66 := transform_right_filter_feature_0_choice_65;
      else
        transform_right_filter_feature_0_choice_66 := ((transform_right_filter_column_3_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_66 then
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_67 := (not (((transform_right_filter_column_3_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_67 then
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_68 := (not (((transform_right_filter_column_3_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_68 then
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_69 := (not (((transform_right_filter_column_3_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_69 then
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_70 := (not (((transform_right_filter_column_3_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_70 then
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_71 := (not (((transform_right_filter_column_3_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_71 then
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_3_3 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_72 := ((transform_right_filter_column_3_3 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_3_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_73 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_73 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_3_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_74 := transform_right_filter_feature_0_choice_73;
      else
        transform_right_filter_feature_0_choice_74 := ((transform_right_filter_column_3_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_74 then
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_3_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_75 := (not (((transform_right_filter_column_3_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_75 then
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_3_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_76 := (not (((transform_right_filter_column_3_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_76 then
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_3_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_77 := (not (((transform_right_filter_column_3_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_77 then
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_3_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_78 := (not (((transform_right_filter_column_3_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_78 then
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_3_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_79 := (not (((transform_right_filter_column_3_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_79 then
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_3_4 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_80 := ((transform_right_filter_column_3_4 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_81 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_81 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_82 := transform_right_filter_feature_0_choice_81;
      else
        transform_right_filter_feature_0_choice_82 := ((transform_right_filter_column_2_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_82 then
        transform_right_filter_feature_0_choice_83 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_83 := (not (((transform_right_filter_column_2_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_83 then
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_84 := (not (((transform_right_filter_column_2_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_84 then
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_85 := (not (((transform_right_filter_column_2_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_85 then
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_86 := (not (((transform_right_filter_column_2_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_86 then
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_87 := (not (((transform_right_filter_column_2_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_87 then
        transform_right_filter_feature_0_choice_88 := transform_filtering_0_column_inside_2 and
          ((transform_right_filter_column_2_4 / 128) = 1) and (not ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_88 := transform_filtering_0_column_inside_2 and
          (((transform_right_filter_column_2_4 / 128) = 1) or (not ((transform_right_filter_column_2_2 / 128) = 1)));
      end if;
      if (transform_right_filter_column_2_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_89 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_89 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_90 := transform_right_filter_feature_0_choice_89;
      else
        transform_right_filter_feature_0_choice_90 := ((transform_right_filter_column_2_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_90 then
        transform_right_filter_feature_0_choice_91 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_91 := (not (((transform_right_filter_column_2_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_91 then
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_92 := (not (((transform_right_filter_column_2_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_92 then
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_93 := (not (((transform_right_filter_column_2_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_93 then
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_94 := (not (((transform_right_filter_column_2_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_94 then
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_95 := (not (((transform_right_filter_column_2_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_95 then
        transform_right_filter_feature_0_choice_96 := ((transform_right_filter_column_2_1 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_96 := ((transform_right_filter_column_2_1 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_97 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_97 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_98 := transform_right_filter_feature_0_choice_97;
      else
        transform_right_filter_feature_0_choice_98 := ((transform_right_filter_column_2_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_98 then
        transform_right_filter_feature_0_choice_99 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_99 := (not (((transform_right_filter_column_2_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_99 then
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_100 := (not (((transform_right_filter_column_2_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_100 then
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_101 := (not (((transform_right_filter_column_2_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_101 then
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_102 := (not (((transform_right_filter_column_2_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_102 then
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_103 := (not (((transform_right_filter_column_2_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_103 then
        transform_right_filter_feature_0_choice_104 := ((transform_right_filter_column_2_3 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_104 := ((transform_right_filter_column_2_3 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_105 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_105 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_2_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_106 := transform_right_filter_feature_0_choice_105;
      else
        transform_right_filter_feature_0_choice_106 := ((transform_right_filter_column_2_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_106 then
        transform_right_filter_feature_0_choice_107 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_107 := (not (((transform_right_filter_column_2_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_107 then
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_108 := (not (((transform_right_filter_column_2_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_108 then
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_109 := (not (((transform_right_filter_column_2_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_109 then
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_110 := (not (((transform_right_filter_column_2_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_110 then
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_111 := (not (((transform_right_filter_column_2_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_111 then
        transform_right_filter_feature_0_choice_112 := ((transform_right_filter_column_2_0 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_112 := ((transform_right_filter_column_2_0 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_113 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_113 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_114 := transform_right_filter_feature_0_choice_113;
      else
        transform_right_filter_feature_0_choice_114 := ((transform_right_filter_column_1_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_114 then
        transform_right_filter_feature_0_choice_115 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_115 := (not (((transform_right_filter_column_1_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_115 then
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_116 := (not (((transform_right_filter_column_1_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_116 then
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_117 := (not (((transform_right_filter_column_1_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_117 then
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_118 := (not (((transform_right_filter_column_1_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_118 then
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_119 := (not (((transform_right_filter_column_1_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_119 then
        transform_right_filter_feature_0_choice_120 := ((transform_right_filter_column_1_3 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_120 := ((transform_right_filter_column_1_3 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_121 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_121 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_122 := transform_right_filter_feature_0_choice_121;
      else
        transform_right_filter_feature_0_choice_122 := ((transform_right_filter_column_1_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_122 then
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_1_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_123 := (not (((transform_right_filter_column_1_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_123 then
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_1_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_124 := (not (((transform_right_filter_column_1_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_124 then
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_1_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_125 := (not (((transform_right_filter_column_1_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_125 then
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_1_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_126 := (not (((transform_right_filter_column_1_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_126 then
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_1_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_127 := (not (((transform_right_filter_column_1_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_127 then
        transform_right_filter_feature_0_choice_128 := ((transform_right_filter_column_1_4 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_128 := ((transform_right_filter_column_1_4 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_129 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_129 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_130 := transform_right_filter_feature_0_choice_129;
      else
        transform_right_filter_feature_0_choice_130 := ((transform_right_filter_column_1_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_130 then
        transform_right_filter_feature_0_choice_131 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_131 := (not (((transform_right_filter_column_1_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_131 then
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_132 := (not (((transform_right_filter_column_1_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_132 then
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_133 := (not (((transform_right_filter_column_1_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_133 then
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_134 := (not (((transform_right_filter_column_1_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_134 then
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_135 := (not (((transform_right_filter_column_1_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_135 then
        transform_right_filter_feature_0_choice_136 := ((transform_right_filter_column_1_2 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_136 := ((transform_right_filter_column_1_2 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_1 mod 2) = 1 then
        transform_right_filter_feature_0_choice_137 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_137 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_1 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_138 := transform_right_filter_feature_0_choice_137;
      else
        transform_right_filter_feature_0_choice_138 := ((transform_right_filter_column_1_1 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_138 then
        transform_right_filter_feature_0_choice_139 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_139 := (not (((transform_right_filter_column_1_1 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_139 then
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_140 := (not (((transform_right_filter_column_1_1 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_140 then
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_141 := (not (((transform_right_filter_column_1_1 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_141 then
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_142 := (not (((transform_right_filter_column_1_1 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_142 then
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_143 := (not (((transform_right_filter_column_1_1 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_143 then
        transform_right_filter_feature_0_choice_144 := ((transform_right_filter_column_1_1 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_144 := ((transform_right_filter_column_1_1 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_1_0 mod 2) = 1 then
        transform_right_filter_feature_0_choice_145 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_145 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_1_0 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_146 := transform_right_filter_feature_0_choice_145;
      else
        transform_right_filter_feature_0_choice_146 := ((transform_right_filter_column_1_0 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_146 then
        transform_right_filter_feature_0_choice_147 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_147 := (not (((transform_right_filter_column_1_0 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_147 then
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_148 := (not (((transform_right_filter_column_1_0 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_148 then
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_149 := (not (((transform_right_filter_column_1_0 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_149 then
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_150 := (not (((transform_right_filter_column_1_0 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_150 then
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_151 := (not (((transform_right_filter_column_1_0 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_151 then
        transform_right_filter_feature_0_choice_152 := ((transform_right_filter_column_1_0 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_152 := ((transform_right_filter_column_1_0 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_3 mod 2) = 1 then
        transform_right_filter_feature_0_choice_153 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_153 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_3 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_154 := transform_right_filter_feature_0_choice_153;
      else
        transform_right_filter_feature_0_choice_154 := ((transform_right_filter_column_0_3 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_154 then
        transform_right_filter_feature_0_choice_155 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_155 := (not (((transform_right_filter_column_0_3 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_155 then
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_156 := (not (((transform_right_filter_column_0_3 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_156 then
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_157 := (not (((transform_right_filter_column_0_3 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_157 then
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_158 := (not (((transform_right_filter_column_0_3 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_158 then
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_159 := (not (((transform_right_filter_column_0_3 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_159 then
        transform_right_filter_feature_0_choice_160 := ((transform_right_filter_column_0_3 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_160 := ((transform_right_filter_column_0_3 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_4 mod 2) = 1 then
        transform_right_filter_feature_0_choice_161 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_161 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_4 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_162 := transform_right_filter_feature_0_choice_161;
      else
        transform_right_filter_feature_0_choice_162 := ((transform_right_filter_column_0_4 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_162 then
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_163 := (not (((transform_right_filter_column_0_4 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_163 then
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_164 := (not (((transform_right_filter_column_0_4 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_164 then
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_165 := (not (((transform_right_filter_column_0_4 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_165 then
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_166 := (not (((transform_right_filter_column_0_4 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_166 then
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_167 := (not (((transform_right_filter_column_0_4 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_167 then
        transform_right_filter_feature_0_choice_168 := ((transform_right_filter_column_0_4 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_168 := ((transform_right_filter_column_0_4 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_0_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_169 := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice_169 := not transform_right_filter_feature_0_value;
      end if;
      if ((transform_right_filter_column_0_2 / 2) mod 2) = 1 then
        transform_right_filter_feature_0_choice_170 := transform_right_filter_feature_0_choice_169;
      else
        transform_right_filter_feature_0_choice_170 := ((transform_right_filter_column_0_2 mod 2) = 1) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choice_170 then
        transform_right_filter_feature_0_choice_171 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) and
          transform_right_filter_feature_0_value_2;
      else
        transform_right_filter_feature_0_choice_171 := (not (((transform_right_filter_column_0_2 / 4) mod 2) = 1)) or
          transform_right_filter_feature_0_value_2;
      end if;
      if transform_right_filter_feature_0_choice_171 then
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) or
          transform_right_filter_feature_0_value_3;
      else
        transform_right_filter_feature_0_choice_172 := (not (((transform_right_filter_column_0_2 / 8) mod 2) = 1)) and
          transform_right_filter_feature_0_value_3;
      end if;
      if transform_right_filter_feature_0_choice_172 then
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) or
          transform_right_filter_feature_0_value_4;
      else
        transform_right_filter_feature_0_choice_173 := (not (((transform_right_filter_column_0_2 / 16) mod 2) = 1)) and
          transform_right_filter_feature_0_value_4;
      end if;
      if transform_right_filter_feature_0_choice_173 then
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) or
          transform_right_filter_feature_0_value_5;
      else
        transform_right_filter_feature_0_choice_174 := (not (((transform_right_filter_column_0_2 / 32) mod 2) = 1)) and
          transform_right_filter_feature_0_value_5;
      end if;
      if transform_right_filter_feature_0_choice_174 then
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) or
          transform_right_filter_feature_0_value_6;
      else
        transform_right_filter_feature_0_choice_175 := (not (((transform_right_filter_column_0_2 / 64) mod 2) = 1)) and
          transform_right_filter_feature_0_value_6;
      end if;
      if transform_right_filter_feature_0_choice_175 then
        transform_right_filter_feature_0_choice_176 := ((transform_right_filter_column_0_2 / 128) = 1) and (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_176 := ((transform_right_filter_column_0_2 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
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
          ((transform_right_filter_column_2_2 / 128) = 1));
      else
        transform_right_filter_feature_0_choice_184 := ((transform_right_filter_column_0_1 / 128) = 1) or (not
          ((transform_right_filter_column_2_2 / 128) = 1));
      end if;
      if (transform_right_filter_column_2_2 mod 2) = 1 then
        transform_right_filter_feature_0_choice_185 := not (((transform_right_filter_column_0_0 / 2) mod 2) = 1);
      else
        transform_right_filter_feature_0_choice_185 := (transform_right_filter_column_0_0 mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value then
        transform_right_filter_feature_0_choice_186 := ((transform_right_filter_column_2_2 mod 2) = 1) or (not
          (((transform_right_filter_column_0_0 / 2) mod 2) = 1)) or (not ((transform_right_filter_column_0_0 mod 2) =
          1));
      else
        transform_right_filter_feature_0_choice_186 := transform_right_filter_feature_0_choice_185;
      end if;
      transform_right_filter_feature_0_value_7 := ((transform_right_filter_column_0_0 / 4) mod 2) = 1;
      if transform_right_filter_feature_0_choice_186 then
        transform_right_filter_feature_0_choice_187 := (not transform_right_filter_feature_0_value_2) and
          transform_right_filter_feature_0_value_7;
      else
        transform_right_filter_feature_0_choice_187 := (not transform_right_filter_feature_0_value_2) or
          transform_right_filter_feature_0_value_7;
      end if;
      transform_right_filter_feature_0_value_8 := ((transform_right_filter_column_0_0 / 8) mod 2) = 1;
      if transform_right_filter_feature_0_choice_187 then
        transform_right_filter_feature_0_choice_188 := (not transform_right_filter_feature_0_value_3) or
          transform_right_filter_feature_0_value_8;
      else
        transform_right_filter_feature_0_choice_188 := (not transform_right_filter_feature_0_value_3) and
          transform_right_filter_feature_0_value_8;
      end if;
      transform_right_filter_feature_0_value_9 := ((transform_right_filter_column_0_0 / 16) mod 2) = 1;
      if transform_right_filter_feature_0_choice_188 then
        transform_right_filter_feature_0_choice_189 := (not transform_right_filter_feature_0_value_4) or
          transform_right_filter_feature_0_value_9;
      else
        transform_right_filter_feature_0_choice_189 := (not transform_right_filter_feature_0_value_4) and
          transform_right_filter_feature_0_value_9;
      end if;
      transform_right_filter_feature_0_value_10 := ((transform_right_filter_column_0_0 / 32) mod 2) = 1;
      if transform_right_filter_feature_0_choice_189 then
        transform_right_filter_feature_0_choice_190 := (not transform_right_filter_feature_0_value_5) or
          transform_right_filter_feature_0_value_10;
      else
        transform_right_filter_feature_0_choice_190 := (not transform_right_filter_feature_0_value_5) and
          transform_right_filter_feature_0_value_10;
      end if;
      transform_right_filter_feature_0_value_11 := ((transform_right_filter_column_0_0 / 64) mod 2) = 1;
      if transform_right_filter_feature_0_choice_190 then
        transform_right_filter_feature_0_choice_191 := (not transform_right_filter_feature_0_value_6) or
          transform_right_filter_feature_0_value_11;
      else
        transform_right_filter_feature_0_choice_191 := (not transform_right_filter_feature_0_value_6) and
          transform_right_filter_feature_0_value_11;
      end if;
      if transform_right_filter_feature_0_choice_191 then
        transform_right_filter_feature_0_choice_192 := (not ((transform_right_filter_column_2_2 / 128) = 1)) or
          ((transform_right_filter_column_0_0 / 128) = 1);
      else
        transform_right_filter_feature_0_choice_192 := (not ((transform_right_filter_column_2_2 / 128) = 1)) and
          ((transform_right_filter_column_0_0 / 128) = 1);
      end if;
      if transform_filtering_0_column_inside_0 then
        transform_right_filter_feature_0_choice_193 := (as_number(transform_right_filter_feature_0_choice_160) * 8) +
          (as_number(transform_right_filter_feature_0_choice_168) * 16) +
          (as_number(transform_right_filter_feature_0_choice_176) * 4) +
          (as_number(transform_right_filter_feature_0_choice_184) * 2) +
          as_number(transform_right_filter_feature_0_choice_192);
      else
        transform_right_filter_feature_0_choice_193 := 0;
      end if;
      if transform_filtering_0_column_inside_1 then
        transform_right_filter_feature_0_choice_194 := (as_number(transform_right_filter_feature_0_choice_120) * 256) +
          (as_number(transform_right_filter_feature_0_choice_128) * 512) +
          (as_number(transform_right_filter_feature_0_choice_136) * 128) +
          (as_number(transform_right_filter_feature_0_choice_144) * 64) +
          (as_number(transform_right_filter_feature_0_choice_152) * 32) + transform_right_filter_feature_0_choice_193;
      else
        transform_right_filter_feature_0_choice_194 := transform_right_filter_feature_0_choice_193;
      end if;
      if transform_filtering_0_column_inside_2 then
        transform_right_filter_feature_0_choice_195 := (as_number(transform_right_filter_feature_0_choice_96) * 2048) +
          (as_number(transform_right_filter_feature_0_choice_104) * 4096) +
          (as_number(transform_right_filter_feature_0_choice_112) * 1024) + transform_right_filter_feature_0_choice_194;
      else
        transform_right_filter_feature_0_choice_195 := transform_right_filter_feature_0_choice_194;
      end if;
      if transform_filtering_0_column_inside_3 then
        transform_right_filter_feature_0_choice_196 := (as_number(transform_right_filter_feature_0_choice_48) * 16384)
          + (as_number(transform_right_filter_feature_0_choice_56) * 32768) +
          (as_number(transform_right_filter_feature_0_choice_64) * 65536) +
          (as_number(transform_right_filter_feature_0_choice_72) * 131072) +
          (as_number(transform_right_filter_feature_0_choice_80) * 262144) +
          (as_number(transform_right_filter_feature_0_choice_88) * 8192) + transform_right_filter_feature_0_choice_195;
      else
        transform_right_filter_feature_0_choice_196 := (as_number(transform_right_filter_feature_0_choice_88) * 8192) +
          transform_right_filter_feature_0_choice_195;
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
      transform_read_column_inside_0 <= (((transform_counter_column / 2) mod 16) /= 0) or ((transform_counter_column /
        32) = 1);
      transform_read_column_inside_2 <= true;
      transform_read_column_inside_4 <= transform_read_column_inside_1_is_equal /=
        transform_read_column_inside_1_differs;
      transform_read_start_of_frame <= (transform_counter_column = 2) and (transform_counter_group = 2);
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
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_1 <= transform_columns_column_inside_1;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_3 <= transform_columns_column_inside_3;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 4;
      else
        transform_counter_group <= transform_counter_group_choice_3;
      end if;
      if transform_read_column_inside_1_is_equal then
        transform_read_column_inside_1 <= transform_read_column_inside_1_choice;
      else
        transform_read_column_inside_1 <= transform_read_column_inside_1_differs;
      end if;
      if transform_read_column_inside_3_choice then
        transform_read_column_inside_3 <= transform_read_column_inside_3_choice_2;
      else
        transform_read_column_inside_3 <= transform_read_column_inside_1_differs;
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0 <= (as_number(transform_left_filter_feature_0_choice_8) * 524288) +
          (as_number(transform_left_filter_feature_0_choice_16) * 1048576) +
          (as_number(transform_left_filter_feature_0_choice_24) * 2097152) +
          (as_number(transform_left_filter_feature_0_choice_32) * 4194304) +
          (as_number(transform_left_filter_feature_0_choice_40) * 8388608) + transform_left_filter_feature_0_choice_196;
        transform_right_filter_feature_0 <= (as_number(transform_right_filter_feature_0_choice_8) * 524288) +
          (as_number(transform_right_filter_feature_0_choice_16) * 1048576) +
          (as_number(transform_right_filter_feature_0_choice_24) * 2097152) +
          (as_number(transform_right_filter_feature_0_choice_32) * 4194304) +
          (as_number(transform_right_filter_feature_0_choice_40) * 8388608) +
          transform_right_filter_feature_0_choice_196;
      else
        transform_left_filter_feature_0 <= transform_left_filter_feature_0_choice_196;
        transform_right_filter_feature_0 <= transform_right_filter_feature_0_choice_196;
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
        raster_place_group_choice_2 := raster_place_group_is_equal_2 and transform_filtering_1_valid and (not
          ((raster_place_group mod 2) = 1));
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
        if raster_place_group_is_equal_2 or transform_filtering_1_start_of_frame then
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
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
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
        rows_search_0 <= rows_search_rows_ready_words_0;
        rows_reference_0 <= rows_reference_rows_ready_words_0;
      else
        rows_search_0 <= 0;
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= rows_search_rows_ready_words_1;
        rows_reference_1 <= rows_reference_rows_ready_words_1;
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
      slice0cost_pixels_first_2_0_count_6_value_2 := ((slice0shift_reference_2 / 1048576) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_6_value_3 := ((slice0shift_reference_2 / 524288) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_7_value := ((slice0shift_reference_2 / 2097152) mod 2) = 1;
      slice0cost_pixels_first_2_0_count_7_value_2 := ((slice0shift_reference_2 / 4194304) mod 2) = 1;
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
      slice0cost_pixels_first_2_0_count_6 <= as_number((slice0cost_pixels_first_2_0_count_6_value /=
        (((slice0shift_search_2_0 / 262144) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_6_value_2 /=
        (((slice0shift_search_2_0 / 1048576) mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_count_6_value_3 /=
        (((slice0shift_search_2_0 / 524288) mod 2) = 1)));
      slice0cost_pixels_first_2_0_count_7 <= as_number((slice0cost_pixels_first_2_0_count_7_value /=
        (((slice0shift_search_2_0 / 2097152) mod 2) = 1))) + as_number((((slice0shift_reference_2 / 8388608) = 1) /=
        ((slice0shift_search_2_0 / 8388608) = 1))) + as_number((slice0cost_pixels_first_2_0_count_7_value_2 /=
        (((slice0shift_search_2_0 / 4194304) mod 2) = 1)));
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
      slice0cost_pixels_first_2_1_count_6 <= as_number(((((slice0shift_search_2_1 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value)) + as_number(((((slice0shift_search_2_1 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice0shift_search_2_1 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value_3));
      slice0cost_pixels_first_2_1_count_7 <= as_number(((((slice0shift_search_2_1 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value)) + as_number((((slice0shift_search_2_1 / 8388608) = 1) /=
        ((slice0shift_reference_2 / 8388608) = 1))) + as_number(((((slice0shift_search_2_1 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value_2));
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
      slice0cost_pixels_first_2_2_count_6 <= as_number(((((slice0shift_search_2_2 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value)) + as_number(((((slice0shift_search_2_2 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice0shift_search_2_2 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value_3));
      slice0cost_pixels_first_2_2_count_7 <= as_number(((((slice0shift_search_2_2 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value)) + as_number((((slice0shift_search_2_2 / 8388608) = 1) /=
        ((slice0shift_reference_2 / 8388608) = 1))) + as_number(((((slice0shift_search_2_2 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value_2));
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
      slice0cost_pixels_first_2_3_count_4 <= as_number(((((slice0shift_search_2_3 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value)) + as_number(((((slice0shift_search_2_3 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice0shift_search_2_3 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value_3));
      slice0cost_pixels_first_2_3_count_5 <= as_number(((((slice0shift_search_2_3 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value)) + as_number(((((slice0shift_search_2_3 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice0shift_search_2_3 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value_3));
      slice0cost_pixels_first_2_3_count_6 <= as_number(((((slice0shift_search_2_3 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value)) + as_number(((((slice0shift_search_2_3 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice0shift_search_2_3 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value_3));
      slice0cost_pixels_first_2_3_count_7 <= as_number(((((slice0shift_search_2_3 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value)) + as_number((((slice0shift_search_2_3 / 8388608) = 1) /=
        ((slice0shift_reference_2 / 8388608) = 1))) + as_number(((((slice0shift_search_2_3 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value_2));
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
      slice0cost_pixels_first_2_4_count_4 <= as_number(((((slice0shift_search_2_4 / 4096) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value)) + as_number(((((slice0shift_search_2_4 / 16384) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice0shift_search_2_4 / 8192) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_4_value_3));
      slice0cost_pixels_first_2_4_count_5 <= as_number(((((slice0shift_search_2_4 / 32768) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value)) + as_number(((((slice0shift_search_2_4 / 131072) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice0shift_search_2_4 / 65536) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_5_value_3));
      slice0cost_pixels_first_2_4_count_6 <= as_number(((((slice0shift_search_2_4 / 262144) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value)) + as_number(((((slice0shift_search_2_4 / 1048576) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice0shift_search_2_4 / 524288) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_6_value_3));
      slice0cost_pixels_first_2_4_count_7 <= as_number(((((slice0shift_search_2_4 / 2097152) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value)) + as_number((((slice0shift_search_2_4 / 8388608) = 1) /=
        ((slice0shift_reference_2 / 8388608) = 1))) + as_number(((((slice0shift_search_2_4 / 4194304) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_count_7_value_2));
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
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
      slice0cost_pixels_cost_2_0 <= slice0cost_pixels_first_2_0_count_0 + slice0cost_pixels_first_2_0_count_2 +
        slice0cost_pixels_first_2_0_count_3 + slice0cost_pixels_first_2_0_count_5 + slice0cost_pixels_first_2_0_count_6
        + slice0cost_pixels_first_2_0_count_4 + slice0cost_pixels_first_2_0_count_7 +
        slice0cost_pixels_first_2_0_count_1;
      slice0cost_pixels_cost_2_1 <= slice0cost_pixels_first_2_1_count_0 + slice0cost_pixels_first_2_1_count_2 +
        slice0cost_pixels_first_2_1_count_3 + slice0cost_pixels_first_2_1_count_5 + slice0cost_pixels_first_2_1_count_6
        + slice0cost_pixels_first_2_1_count_4 + slice0cost_pixels_first_2_1_count_7 +
        slice0cost_pixels_first_2_1_count_1;
      slice0cost_pixels_cost_2_2 <= slice0cost_pixels_first_2_2_count_0 + slice0cost_pixels_first_2_2_count_2 +
        slice0cost_pixels_first_2_2_count_3 + slice0cost_pixels_first_2_2_count_5 + slice0cost_pixels_first_2_2_count_6
        + slice0cost_pixels_first_2_2_count_4 + slice0cost_pixels_first_2_2_count_7 +
        slice0cost_pixels_first_2_2_count_1;
      slice0cost_pixels_cost_2_3 <= slice0cost_pixels_first_2_3_count_0 + slice0cost_pixels_first_2_3_count_2 +
        slice0cost_pixels_first_2_3_count_3 + slice0cost_pixels_first_2_3_count_5 + slice0cost_pixels_first_2_3_count_6
        + slice0cost_pixels_first_2_3_count_4 + slice0cost_pixels_first_2_3_count_7 +
        slice0cost_pixels_first_2_3_count_1;
      slice0cost_pixels_cost_2_4 <= slice0cost_pixels_first_2_4_count_0 + slice0cost_pixels_first_2_4_count_2 +
        slice0cost_pixels_first_2_4_count_3 + slice0cost_pixels_first_2_4_count_5 + slice0cost_pixels_first_2_4_count_6
        + slice0cost_pixels_first_2_4_count_4 + slice0cost_pixels_first_2_4_count_7 +
        slice0cost_pixels_first_2_4_count_1;
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
      slice0_held_0_0 <= slice0window_sum_0_0 / 16;
      slice0_held_0_1 <= slice0window_sum_0_1 / 16;
      slice0_held_0_2 <= slice0window_sum_0_2 / 16;
      slice0_held_0_3 <= slice0window_sum_0_3 / 16;
      slice0_held_0_4 <= slice0window_sum_0_4 / 16;
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
      slice1cost_pixels_first_2_0_count_6_value_2 := ((slice1shift_reference_2 / 1048576) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_6_value_3 := ((slice1shift_reference_2 / 524288) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_7_value := ((slice1shift_reference_2 / 2097152) mod 2) = 1;
      slice1cost_pixels_first_2_0_count_7_value_2 := ((slice1shift_reference_2 / 4194304) mod 2) = 1;
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
      slice1cost_pixels_first_2_0_count_6 <= as_number((slice1cost_pixels_first_2_0_count_6_value /=
        (((slice1shift_search_2_0 / 262144) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_6_value_2 /=
        (((slice1shift_search_2_0 / 1048576) mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_count_6_value_3 /=
        (((slice1shift_search_2_0 / 524288) mod 2) = 1)));
      slice1cost_pixels_first_2_0_count_7 <= as_number((slice1cost_pixels_first_2_0_count_7_value /=
        (((slice1shift_search_2_0 / 2097152) mod 2) = 1))) + as_number((((slice1shift_reference_2 / 8388608) = 1) /=
        ((slice1shift_search_2_0 / 8388608) = 1))) + as_number((slice1cost_pixels_first_2_0_count_7_value_2 /=
        (((slice1shift_search_2_0 / 4194304) mod 2) = 1)));
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
      slice1cost_pixels_first_2_1_count_6 <= as_number(((((slice1shift_search_2_1 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value)) + as_number(((((slice1shift_search_2_1 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice1shift_search_2_1 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value_3));
      slice1cost_pixels_first_2_1_count_7 <= as_number(((((slice1shift_search_2_1 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_7_value)) + as_number((((slice1shift_search_2_1 / 8388608) = 1) /=
        ((slice1shift_reference_2 / 8388608) = 1))) + as_number(((((slice1shift_search_2_1 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_7_value_2));
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
      slice1cost_pixels_first_2_2_count_6 <= as_number(((((slice1shift_search_2_2 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value)) + as_number(((((slice1shift_search_2_2 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice1shift_search_2_2 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value_3));
      slice1cost_pixels_first_2_2_count_7 <= as_number(((((slice1shift_search_2_2 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_7_value)) + as_number((((slice1shift_search_2_2 / 8388608) = 1) /=
        ((slice1shift_reference_2 / 8388608) = 1))) + as_number(((((slice1shift_search_2_2 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_7_value_2));
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
      slice1cost_pixels_first_2_3_count_4 <= as_number(((((slice1shift_search_2_3 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value)) + as_number(((((slice1shift_search_2_3 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice1shift_search_2_3 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value_3));
      slice1cost_pixels_first_2_3_count_5 <= as_number(((((slice1shift_search_2_3 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value)) + as_number(((((slice1shift_search_2_3 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice1shift_search_2_3 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value_3));
      slice1cost_pixels_first_2_3_count_6 <= as_number(((((slice1shift_search_2_3 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value)) + as_number(((((slice1shift_search_2_3 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice1shift_search_2_3 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value_3));
      slice1cost_pixels_first_2_3_count_7 <= as_number(((((slice1shift_search_2_3 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_7_value)) + as_number((((slice1shift_search_2_3 / 8388608) = 1) /=
        ((slice1shift_reference_2 / 8388608) = 1))) + as_number(((((slice1shift_search_2_3 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_7_value_2));
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
      slice1cost_pixels_first_2_4_count_4 <= as_number(((((slice1shift_search_2_4 / 4096) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value)) + as_number(((((slice1shift_search_2_4 / 16384) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value_2)) + as_number(((((slice1shift_search_2_4 / 8192) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_4_value_3));
      slice1cost_pixels_first_2_4_count_5 <= as_number(((((slice1shift_search_2_4 / 32768) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value)) + as_number(((((slice1shift_search_2_4 / 131072) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value_2)) + as_number(((((slice1shift_search_2_4 / 65536) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_5_value_3));
      slice1cost_pixels_first_2_4_count_6 <= as_number(((((slice1shift_search_2_4 / 262144) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value)) + as_number(((((slice1shift_search_2_4 / 1048576) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice1shift_search_2_4 / 524288) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_6_value_3));
      slice1cost_pixels_first_2_4_count_7 <= as_number(((((slice1shift_search_2_4 / 2097152) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_7_value)) + as_number((((slice1shift_search_2_4 / 8388608) = 1) /=
        ((slice1shift_reference_2 / 8388608) = 1))) + as_number(((((slice1shift_search_2_4 / 4194304) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_count_7_value_2));
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
      slice1cost_pixels_cost_2_0 <= slice1cost_pixels_first_2_0_count_0 + slice1cost_pixels_first_2_0_count_2 +
        slice1cost_pixels_first_2_0_count_3 + slice1cost_pixels_first_2_0_count_5 + slice1cost_pixels_first_2_0_count_6
        + slice1cost_pixels_first_2_0_count_4 + slice1cost_pixels_first_2_0_count_7 +
        slice1cost_pixels_first_2_0_count_1;
      slice1cost_pixels_cost_2_1 <= slice1cost_pixels_first_2_1_count_0 + slice1cost_pixels_first_2_1_count_2 +
        slice1cost_pixels_first_2_1_count_3 + slice1cost_pixels_first_2_1_count_5 + slice1cost_pixels_first_2_1_count_6
        + slice1cost_pixels_first_2_1_count_4 + slice1cost_pixels_first_2_1_count_7 +
        slice1cost_pixels_first_2_1_count_1;
      slice1cost_pixels_cost_2_2 <= slice1cost_pixels_first_2_2_count_0 + slice1cost_pixels_first_2_2_count_2 +
        slice1cost_pixels_first_2_2_count_3 + slice1cost_pixels_first_2_2_count_5 + slice1cost_pixels_first_2_2_count_6
        + slice1cost_pixels_first_2_2_count_4 + slice1cost_pixels_first_2_2_count_7 +
        slice1cost_pixels_first_2_2_count_1;
      slice1cost_pixels_cost_2_3 <= slice1cost_pixels_first_2_3_count_0 + slice1cost_pixels_first_2_3_count_2 +
        slice1cost_pixels_first_2_3_count_3 + slice1cost_pixels_first_2_3_count_5 + slice1cost_pixels_first_2_3_count_6
        + slice1cost_pixels_first_2_3_count_4 + slice1cost_pixels_first_2_3_count_7 +
        slice1cost_pixels_first_2_3_count_1;
      slice1cost_pixels_cost_2_4 <= slice1cost_pixels_first_2_4_count_0 + slice1cost_pixels_first_2_4_count_2 +
        slice1cost_pixels_first_2_4_count_3 + slice1cost_pixels_first_2_4_count_5 + slice1cost_pixels_first_2_4_count_6
        + slice1cost_pixels_first_2_4_count_4 + slice1cost_pixels_first_2_4_count_7 +
        slice1cost_pixels_first_2_4_count_1;
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
      slice1_held_0_0 <= slice1window_sum_0_0 / 16;
      slice1_held_0_1 <= slice1window_sum_0_1 / 16;
      slice1_held_0_2 <= slice1window_sum_0_2 / 16;
      slice1_held_0_3 <= slice1window_sum_0_3 / 16;
      slice1_held_0_4 <= slice1window_sum_0_4 / 16;
      slice1_held_1_0 <= slice1_held_0_0;
      slice1_held_1_1 <= slice1_held_0_1;
      slice1_held_1_2 <= slice1_held_0_2;
      slice1_held_1_3 <= slice1_held_0_3;
      slice1_held_1_4 <= slice1_held_0_4;
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
      slice2cost_pixels_first_2_0_count_6_value_2 := ((slice2shift_reference_2 / 1048576) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_6_value_3 := ((slice2shift_reference_2 / 524288) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_7_value := ((slice2shift_reference_2 / 2097152) mod 2) = 1;
      slice2cost_pixels_first_2_0_count_7_value_2 := ((slice2shift_reference_2 / 4194304) mod 2) = 1;
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
      slice2cost_pixels_first_2_0_count_6 <= as_number((slice2cost_pixels_first_2_0_count_6_value /=
        (((slice2shift_search_2_0 / 262144) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_6_value_2 /=
        (((slice2shift_search_2_0 / 1048576) mod 2) = 1))) + as_number((slice2cost_pixels_first_2_0_count_6_value_3 /=
        (((slice2shift_search_2_0 / 524288) mod 2) = 1)));
      slice2cost_pixels_first_2_0_count_7 <= as_number((slice2cost_pixels_first_2_0_count_7_value /=
        (((slice2shift_search_2_0 / 2097152) mod 2) = 1))) + as_number((((slice2shift_reference_2 / 8388608) = 1) /=
        ((slice2shift_search_2_0 / 8388608) = 1))) + as_number((slice2cost_pixels_first_2_0_count_7_value_2 /=
        (((slice2shift_search_2_0 / 4194304) mod 2) = 1)));
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
      slice2cost_pixels_first_2_1_count_6 <= as_number(((((slice2shift_search_2_1 / 262144) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_6_value)) + as_number(((((slice2shift_search_2_1 / 1048576) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_6_value_2)) + as_number(((((slice2shift_search_2_1 / 524288) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_6_value_3));
      slice2cost_pixels_first_2_1_count_7 <= as_number(((((slice2shift_search_2_1 / 2097152) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_7_value)) + as_number((((slice2shift_search_2_1 / 8388608) = 1) /=
        ((slice2shift_reference_2 / 8388608) = 1))) + as_number(((((slice2shift_search_2_1 / 4194304) mod 2) = 1) /=
        slice2cost_pixels_first_2_0_count_7_value_2));
      slice2cost_pixels_cost_0_0 <= slice2cost_pixels_first_0_0_count_0 + slice2cost_pixels_first_0_0_count_2 +
        slice2cost_pixels_first_0_0_count_3 + slice2cost_pixels_first_0_0_count_5 + slice2cost_pixels_first_0_0_count_6
        + slice2cost_pixels_first_0_0_count_4 + slice2cost_pixels_first_0_0_count_7 +
        slice2cost_pixels_first_0_0_count_1;
      slice2cost_pixels_cost_0_1 <= slice2cost_pixels_first_0_1_count_0 + slice2cost_pixels_first_0_1_count_2 +
        slice2cost_pixels_first_0_1_count_3 + slice2cost_pixels_first_0_1_count_5 + slice2cost_pixels_first_0_1_count_6
        + slice2cost_pixels_first_0_1_count_4 + slice2cost_pixels_first_0_1_count_7 +
        slice2cost_pixels_first_0_1_count_1;
      slice2cost_pixels_cost_1_0 <= slice2cost_pixels_first_1_0_count_0 + slice2cost_pixels_first_1_0_count_2 +
        slice2cost_pixels_first_1_0_count_3 + slice2cost_pixels_first_1_0_count_5 + slice2cost_pixels_first_1_0_count_6
        + slice2cost_pixels_first_1_0_count_4 + slice2cost_pixels_first_1_0_count_7 +
        slice2cost_pixels_first_1_0_count_1;
      slice2cost_pixels_cost_1_1 <= slice2cost_pixels_first_1_1_count_0 + slice2cost_pixels_first_1_1_count_2 +
        slice2cost_pixels_first_1_1_count_3 + slice2cost_pixels_first_1_1_count_5 + slice2cost_pixels_first_1_1_count_6
        + slice2cost_pixels_first_1_1_count_4 + slice2cost_pixels_first_1_1_count_7 +
        slice2cost_pixels_first_1_1_count_1;
      slice2cost_pixels_cost_2_0 <= slice2cost_pixels_first_2_0_count_0 + slice2cost_pixels_first_2_0_count_2 +
        slice2cost_pixels_first_2_0_count_3 + slice2cost_pixels_first_2_0_count_5 + slice2cost_pixels_first_2_0_count_6
        + slice2cost_pixels_first_2_0_count_4 + slice2cost_pixels_first_2_0_count_7 +
        slice2cost_pixels_first_2_0_count_1;
      slice2cost_pixels_cost_2_1 <= slice2cost_pixels_first_2_1_count_0 + slice2cost_pixels_first_2_1_count_2 +
        slice2cost_pixels_first_2_1_count_3 + slice2cost_pixels_first_2_1_count_5 + slice2cost_pixels_first_2_1_count_6
        + slice2cost_pixels_first_2_1_count_4 + slice2cost_pixels_first_2_1_count_7 +
        slice2cost_pixels_first_2_1_count_1;
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
      slice2_held_0_0 <= slice2window_sum_0_0 / 16;
      slice2_held_0_1 <= slice2window_sum_0_1 / 16;
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
        forward_left_smallest_less <= (forward_smallest_next_next_next_smallest_0 + 59) mod 64;
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
        sums_right_smallest_less <= (sums_turn_ready_smallest_0 + 59) mod 64;
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
        winnerswinner1_best_index_0_0_choice := (not (((sums_sum_0_1 / 2) mod 2) = 1)) or (not ((sums_sum_0_1 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_0_choice := not (((sums_sum_0_1 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_0 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_0_choice_2 := winnerswinner1_best_index_0_0_choice;
      else
        winnerswinner1_best_index_0_0_choice_2 := ((sums_sum_0_0 mod 2) = 1) and ((sums_sum_0_1 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_0_value := ((sums_sum_0_1 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_2 then
        winnerswinner1_best_index_0_0_choice_3 := (not (((sums_sum_0_0 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value;
      else
        winnerswinner1_best_index_0_0_choice_3 := (not (((sums_sum_0_0 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value;
      end if;
      winnerswinner1_best_index_0_0_value_2 := ((sums_sum_0_1 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_3 then
        winnerswinner1_best_index_0_0_choice_4 := (not (((sums_sum_0_0 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value_2;
      else
        winnerswinner1_best_index_0_0_choice_4 := (not (((sums_sum_0_0 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value_2;
      end if;
      winnerswinner1_best_index_0_0_value_3 := ((sums_sum_0_1 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_4 then
        winnerswinner1_best_index_0_0_choice_5 := (not (((sums_sum_0_0 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value_3;
      else
        winnerswinner1_best_index_0_0_choice_5 := (not (((sums_sum_0_0 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value_3;
      end if;
      winnerswinner1_best_index_0_0_value_4 := ((sums_sum_0_1 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_0_choice_5 then
        winnerswinner1_best_index_0_0_choice_6 := (not (((sums_sum_0_0 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_0_value_4;
      else
        winnerswinner1_best_index_0_0_choice_6 := (not (((sums_sum_0_0 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_0_value_4;
      end if;
      if winnerswinner1_best_index_0_0_choice_6 then
        winnerswinner1_best_index_0_0_choice_7 := ((sums_sum_0_0 / 64) = 1) and (not ((sums_sum_0_1 / 64) = 1));
      else
        winnerswinner1_best_index_0_0_choice_7 := ((sums_sum_0_0 / 64) = 1) or (not ((sums_sum_0_1 / 64) = 1));
      end if;
      if (sums_sum_0_2 mod 2) = 1 then
        winnerswinner1_best_index_0_1_choice := (not (((sums_sum_0_3 / 2) mod 2) = 1)) or (not ((sums_sum_0_3 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_1_choice := not (((sums_sum_0_3 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_2 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_1_choice_2 := winnerswinner1_best_index_0_1_choice;
      else
        winnerswinner1_best_index_0_1_choice_2 := ((sums_sum_0_2 mod 2) = 1) and ((sums_sum_0_3 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_1_value := ((sums_sum_0_3 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_2 then
        winnerswinner1_best_index_0_1_choice_3 := (not (((sums_sum_0_2 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value;
      else
        winnerswinner1_best_index_0_1_choice_3 := (not (((sums_sum_0_2 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value;
      end if;
      winnerswinner1_best_index_0_1_value_2 := ((sums_sum_0_3 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_3 then
        winnerswinner1_best_index_0_1_choice_4 := (not (((sums_sum_0_2 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value_2;
      else
        winnerswinner1_best_index_0_1_choice_4 := (not (((sums_sum_0_2 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value_2;
      end if;
      winnerswinner1_best_index_0_1_value_3 := ((sums_sum_0_3 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_4 then
        winnerswinner1_best_index_0_1_choice_5 := (not (((sums_sum_0_2 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value_3;
      else
        winnerswinner1_best_index_0_1_choice_5 := (not (((sums_sum_0_2 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value_3;
      end if;
      winnerswinner1_best_index_0_1_value_4 := ((sums_sum_0_3 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_1_choice_5 then
        winnerswinner1_best_index_0_1_choice_6 := (not (((sums_sum_0_2 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_1_value_4;
      else
        winnerswinner1_best_index_0_1_choice_6 := (not (((sums_sum_0_2 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_1_value_4;
      end if;
      if winnerswinner1_best_index_0_1_choice_6 then
        winnerswinner1_best_index_0_1_choice_7 := ((sums_sum_0_2 / 64) = 1) and (not ((sums_sum_0_3 / 64) = 1));
      else
        winnerswinner1_best_index_0_1_choice_7 := ((sums_sum_0_2 / 64) = 1) or (not ((sums_sum_0_3 / 64) = 1));
      end if;
      if (sums_sum_0_4 mod 2) = 1 then
        winnerswinner1_best_index_0_2_choice := (not (((sums_sum_0_5 / 2) mod 2) = 1)) or (not ((sums_sum_0_5 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_2_choice := not (((sums_sum_0_5 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_4 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_2_choice_2 := winnerswinner1_best_index_0_2_choice;
      else
        winnerswinner1_best_index_0_2_choice_2 := ((sums_sum_0_4 mod 2) = 1) and ((sums_sum_0_5 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_2_value := ((sums_sum_0_5 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_2 then
        winnerswinner1_best_index_0_2_choice_3 := (not (((sums_sum_0_4 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value;
      else
        winnerswinner1_best_index_0_2_choice_3 := (not (((sums_sum_0_4 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value;
      end if;
      winnerswinner1_best_index_0_2_value_2 := ((sums_sum_0_5 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_3 then
        winnerswinner1_best_index_0_2_choice_4 := (not (((sums_sum_0_4 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value_2;
      else
        winnerswinner1_best_index_0_2_choice_4 := (not (((sums_sum_0_4 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value_2;
      end if;
      winnerswinner1_best_index_0_2_value_3 := ((sums_sum_0_5 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_4 then
        winnerswinner1_best_index_0_2_choice_5 := (not (((sums_sum_0_4 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value_3;
      else
        winnerswinner1_best_index_0_2_choice_5 := (not (((sums_sum_0_4 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value_3;
      end if;
      winnerswinner1_best_index_0_2_value_4 := ((sums_sum_0_5 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_2_choice_5 then
        winnerswinner1_best_index_0_2_choice_6 := (not (((sums_sum_0_4 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_2_value_4;
      else
        winnerswinner1_best_index_0_2_choice_6 := (not (((sums_sum_0_4 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_2_value_4;
      end if;
      if winnerswinner1_best_index_0_2_choice_6 then
        winnerswinner1_best_index_0_2_choice_7 := ((sums_sum_0_4 / 64) = 1) and (not ((sums_sum_0_5 / 64) = 1));
      else
        winnerswinner1_best_index_0_2_choice_7 := ((sums_sum_0_4 / 64) = 1) or (not ((sums_sum_0_5 / 64) = 1));
      end if;
      if (sums_sum_0_6 mod 2) = 1 then
        winnerswinner1_best_index_0_3_choice := (not (((sums_sum_0_7 / 2) mod 2) = 1)) or (not ((sums_sum_0_7 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_3_choice := not (((sums_sum_0_7 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_6 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_3_choice_2 := winnerswinner1_best_index_0_3_choice;
      else
        winnerswinner1_best_index_0_3_choice_2 := ((sums_sum_0_6 mod 2) = 1) and ((sums_sum_0_7 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_3_value := ((sums_sum_0_7 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_2 then
        winnerswinner1_best_index_0_3_choice_3 := (not (((sums_sum_0_6 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value;
      else
        winnerswinner1_best_index_0_3_choice_3 := (not (((sums_sum_0_6 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value;
      end if;
      winnerswinner1_best_index_0_3_value_2 := ((sums_sum_0_7 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_3 then
        winnerswinner1_best_index_0_3_choice_4 := (not (((sums_sum_0_6 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value_2;
      else
        winnerswinner1_best_index_0_3_choice_4 := (not (((sums_sum_0_6 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value_2;
      end if;
      winnerswinner1_best_index_0_3_value_3 := ((sums_sum_0_7 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_4 then
        winnerswinner1_best_index_0_3_choice_5 := (not (((sums_sum_0_6 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value_3;
      else
        winnerswinner1_best_index_0_3_choice_5 := (not (((sums_sum_0_6 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value_3;
      end if;
      winnerswinner1_best_index_0_3_value_4 := ((sums_sum_0_7 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_3_choice_5 then
        winnerswinner1_best_index_0_3_choice_6 := (not (((sums_sum_0_6 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_3_value_4;
      else
        winnerswinner1_best_index_0_3_choice_6 := (not (((sums_sum_0_6 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_3_value_4;
      end if;
      if winnerswinner1_best_index_0_3_choice_6 then
        winnerswinner1_best_index_0_3_choice_7 := ((sums_sum_0_6 / 64) = 1) and (not ((sums_sum_0_7 / 64) = 1));
      else
        winnerswinner1_best_index_0_3_choice_7 := ((sums_sum_0_6 / 64) = 1) or (not ((sums_sum_0_7 / 64) = 1));
      end if;
      if (sums_sum_0_8 mod 2) = 1 then
        winnerswinner1_best_index_0_4_choice := (not (((sums_sum_0_9 / 2) mod 2) = 1)) or (not ((sums_sum_0_9 mod 2) =
          1));
      else
        winnerswinner1_best_index_0_4_choice := not (((sums_sum_0_9 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_8 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_4_choice_2 := winnerswinner1_best_index_0_4_choice;
      else
        winnerswinner1_best_index_0_4_choice_2 := ((sums_sum_0_8 mod 2) = 1) and ((sums_sum_0_9 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_4_value := ((sums_sum_0_9 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_4_choice_2 then
        winnerswinner1_best_index_0_4_choice_3 := (not (((sums_sum_0_8 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_4_value;
      else
        winnerswinner1_best_index_0_4_choice_3 := (not (((sums_sum_0_8 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_4_value;
      end if;
      winnerswinner1_best_index_0_4_value_2 := ((sums_sum_0_9 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_4_choice_3 then
        winnerswinner1_best_index_0_4_choice_4 := (not (((sums_sum_0_8 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_4_value_2;
      else
        winnerswinner1_best_index_0_4_choice_4 := (not (((sums_sum_0_8 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_4_value_2;
      end if;
      winnerswinner1_best_index_0_4_value_3 := ((sums_sum_0_9 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_4_choice_4 then
        winnerswinner1_best_index_0_4_choice_5 := (not (((sums_sum_0_8 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_4_value_3;
      else
        winnerswinner1_best_index_0_4_choice_5 := (not (((sums_sum_0_8 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_4_value_3;
      end if;
      winnerswinner1_best_index_0_4_value_4 := ((sums_sum_0_9 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_4_choice_5 then
        winnerswinner1_best_index_0_4_choice_6 := (not (((sums_sum_0_8 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_4_value_4;
      else
        winnerswinner1_best_index_0_4_choice_6 := (not (((sums_sum_0_8 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_4_value_4;
      end if;
      if winnerswinner1_best_index_0_4_choice_6 then
        winnerswinner1_best_index_0_4_choice_7 := ((sums_sum_0_8 / 64) = 1) and (not ((sums_sum_0_9 / 64) = 1));
      else
        winnerswinner1_best_index_0_4_choice_7 := ((sums_sum_0_8 / 64) = 1) or (not ((sums_sum_0_9 / 64) = 1));
      end if;
      if (sums_sum_0_10 mod 2) = 1 then
        winnerswinner1_best_index_0_5_choice := (not (((sums_sum_0_11 / 2) mod 2) = 1)) or (not ((sums_sum_0_11 mod 2)
          = 1));
      else
        winnerswinner1_best_index_0_5_choice := not (((sums_sum_0_11 / 2) mod 2) = 1);
      end if;
      if ((sums_sum_0_10 / 2) mod 2) = 1 then
        winnerswinner1_best_index_0_5_choice_2 := winnerswinner1_best_index_0_5_choice;
      else
        winnerswinner1_best_index_0_5_choice_2 := ((sums_sum_0_10 mod 2) = 1) and ((sums_sum_0_11 mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_5_value := ((sums_sum_0_11 / 4) mod 2) = 1;
      if winnerswinner1_best_index_0_5_choice_2 then
        winnerswinner1_best_index_0_5_choice_3 := (not (((sums_sum_0_10 / 4) mod 2) = 1)) and
          winnerswinner1_best_index_0_5_value;
      else
        winnerswinner1_best_index_0_5_choice_3 := (not (((sums_sum_0_10 / 4) mod 2) = 1)) or
          winnerswinner1_best_index_0_5_value;
      end if;
      winnerswinner1_best_index_0_5_value_2 := ((sums_sum_0_11 / 8) mod 2) = 1;
      if winnerswinner1_best_index_0_5_choice_3 then
        winnerswinner1_best_index_0_5_choice_4 := (not (((sums_sum_0_10 / 8) mod 2) = 1)) or
          winnerswinner1_best_index_0_5_value_2;
      else
        winnerswinner1_best_index_0_5_choice_4 := (not (((sums_sum_0_10 / 8) mod 2) = 1)) and
          winnerswinner1_best_index_0_5_value_2;
      end if;
      winnerswinner1_best_index_0_5_value_3 := ((sums_sum_0_11 / 16) mod 2) = 1;
      if winnerswinner1_best_index_0_5_choice_4 then
        winnerswinner1_best_index_0_5_choice_5 := (not (((sums_sum_0_10 / 16) mod 2) = 1)) or
          winnerswinner1_best_index_0_5_value_3;
      else
        winnerswinner1_best_index_0_5_choice_5 := (not (((sums_sum_0_10 / 16) mod 2) = 1)) and
          winnerswinner1_best_index_0_5_value_3;
      end if;
      winnerswinner1_best_index_0_5_value_4 := ((sums_sum_0_11 / 32) mod 2) = 1;
      if winnerswinner1_best_index_0_5_choice_5 then
        winnerswinner1_best_index_0_5_choice_6 := (not (((sums_sum_0_10 / 32) mod 2) = 1)) or
          winnerswinner1_best_index_0_5_value_4;
      else
        winnerswinner1_best_index_0_5_choice_6 := (not (((sums_sum_0_10 / 32) mod 2) = 1)) and
          winnerswinner1_best_index_0_5_value_4;
      end if;
      if winnerswinner1_best_index_0_5_choice_6 then
        winnerswinner1_best_index_0_5_choice_7 := ((sums_sum_0_10 / 64) = 1) and (not ((sums_sum_0_11 / 64) = 1));
      else
        winnerswinner1_best_index_0_5_choice_7 := ((sums_sum_0_10 / 64) = 1) or (not ((sums_sum_0_11 / 64) = 1));
      end if;
      winnerswinner1_best_index_0_0 <= winnerswinner1_best_index_0_0_choice_7;
      winnerswinner1_best_first_0_1 <= sums_sum_0_2;
      winnerswinner1_best_first_0_2 <= sums_sum_0_4;
      winnerswinner1_best_first_0_3 <= sums_sum_0_6;
      winnerswinner1_best_first_0_4 <= sums_sum_0_8;
      winnerswinner1_best_first_0_5 <= sums_sum_0_10;
      winnerswinner1_best_last_0_0 <= sums_sum_0_1;
      winnerswinner1_best_last_0_1 <= sums_sum_0_3;
      winnerswinner1_best_last_0_2 <= sums_sum_0_5;
      winnerswinner1_best_last_0_3 <= sums_sum_0_7;
      winnerswinner1_best_last_0_4 <= sums_sum_0_9;
      winnerswinner1_tag_valid <= sums_tag_valid;
      winnerswinner1_tag_map_column <= sums_tag_map_column;
      winnerswinner1_tag_output_column <= sums_tag_output_column;
      winnerswinner1_tag_start_of_frame <= sums_tag_start_of_frame;
      winnerswinner1_tag_end_of_line <= sums_tag_end_of_line;
      if (sums_sum_0_1 - sums_sum_0_0) < 0 then
        winnerswinner1_best_cost_0_0 <= sums_sum_0_1;
      else
        winnerswinner1_best_cost_0_0 <= sums_sum_0_0;
      end if;
      if (sums_sum_0_3 - sums_sum_0_2) < 0 then
        winnerswinner1_best_cost_0_1 <= sums_sum_0_3;
      else
        winnerswinner1_best_cost_0_1 <= sums_sum_0_2;
      end if;
      if (sums_sum_0_5 - sums_sum_0_4) < 0 then
        winnerswinner1_best_cost_0_2 <= sums_sum_0_5;
      else
        winnerswinner1_best_cost_0_2 <= sums_sum_0_4;
      end if;
      if (sums_sum_0_7 - sums_sum_0_6) < 0 then
        winnerswinner1_best_cost_0_3 <= sums_sum_0_7;
      else
        winnerswinner1_best_cost_0_3 <= sums_sum_0_6;
      end if;
      if (sums_sum_0_9 - sums_sum_0_8) < 0 then
        winnerswinner1_best_cost_0_4 <= sums_sum_0_9;
      else
        winnerswinner1_best_cost_0_4 <= sums_sum_0_8;
      end if;
      if (sums_sum_0_11 - sums_sum_0_10) < 0 then
        winnerswinner1_best_cost_0_5 <= sums_sum_0_11;
      else
        winnerswinner1_best_cost_0_5 <= sums_sum_0_10;
      end if;
      if winnerswinner1_best_index_0_1_choice_7 then
        winnerswinner1_best_index_0_1 <= 3;
        winnerswinner1_best_below_0_1 <= sums_sum_0_2;
        winnerswinner1_best_above_0_1 <= 0;
      else
        winnerswinner1_best_index_0_1 <= 2;
        winnerswinner1_best_below_0_1 <= 0;
        winnerswinner1_best_above_0_1 <= sums_sum_0_3;
      end if;
      if winnerswinner1_best_index_0_2_choice_7 then
        winnerswinner1_best_index_0_2 <= 5;
        winnerswinner1_best_below_0_2 <= sums_sum_0_4;
        winnerswinner1_best_above_0_2 <= 0;
      else
        winnerswinner1_best_index_0_2 <= 4;
        winnerswinner1_best_below_0_2 <= 0;
        winnerswinner1_best_above_0_2 <= sums_sum_0_5;
      end if;
      if winnerswinner1_best_index_0_3_choice_7 then
        winnerswinner1_best_index_0_3 <= 7;
        winnerswinner1_best_below_0_3 <= sums_sum_0_6;
        winnerswinner1_best_above_0_3 <= 0;
      else
        winnerswinner1_best_index_0_3 <= 6;
        winnerswinner1_best_below_0_3 <= 0;
        winnerswinner1_best_above_0_3 <= sums_sum_0_7;
      end if;
      if winnerswinner1_best_index_0_4_choice_7 then
        winnerswinner1_best_index_0_4 <= 9;
        winnerswinner1_best_below_0_4 <= sums_sum_0_8;
        winnerswinner1_best_above_0_4 <= 0;
      else
        winnerswinner1_best_index_0_4 <= 8;
        winnerswinner1_best_below_0_4 <= 0;
        winnerswinner1_best_above_0_4 <= sums_sum_0_9;
      end if;
      if winnerswinner1_best_index_0_5_choice_7 then
        winnerswinner1_best_index_0_5 <= 11;
        winnerswinner1_best_below_0_5 <= sums_sum_0_10;
        winnerswinner1_best_above_0_5 <= 0;
      else
        winnerswinner1_best_index_0_5 <= 10;
        winnerswinner1_best_below_0_5 <= 0;
        winnerswinner1_best_above_0_5 <= sums_sum_0_11;
      end if;
      if winnerswinner1_best_index_0_0_choice_7 then
        winnerswinner1_best_below_0_0 <= sums_sum_0_0;
        winnerswinner1_best_above_0_0 <= 0;
      else
        winnerswinner1_best_below_0_0 <= 0;
        winnerswinner1_best_above_0_0 <= sums_sum_0_1;
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
      if winnerswinner2_best_index_0_0_choice_6 then
        winnerswinner2_best_index_0_0_choice_7 := ((winnerswinner1_best_cost_0_0 / 64) = 1) and (not
          ((winnerswinner1_best_cost_0_1 / 64) = 1));
      else
        winnerswinner2_best_index_0_0_choice_7 := ((winnerswinner1_best_cost_0_0 / 64) = 1) or (not
          ((winnerswinner1_best_cost_0_1 / 64) = 1));
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
      if winnerswinner2_best_index_0_1_choice_6 then
        winnerswinner2_best_index_0_1_choice_7 := ((winnerswinner1_best_cost_0_2 / 64) = 1) and (not
          ((winnerswinner1_best_cost_0_3 / 64) = 1));
      else
        winnerswinner2_best_index_0_1_choice_7 := ((winnerswinner1_best_cost_0_2 / 64) = 1) or (not
          ((winnerswinner1_best_cost_0_3 / 64) = 1));
      end if;
      if (winnerswinner1_best_cost_0_4 mod 2) = 1 then
        winnerswinner2_best_index_0_2_choice := (not (((winnerswinner1_best_cost_0_5 / 2) mod 2) = 1)) or (not
          ((winnerswinner1_best_cost_0_5 mod 2) = 1));
      else
        winnerswinner2_best_index_0_2_choice := not (((winnerswinner1_best_cost_0_5 / 2) mod 2) = 1);
      end if;
      if ((winnerswinner1_best_cost_0_4 / 2) mod 2) = 1 then
        winnerswinner2_best_index_0_2_choice_2 := winnerswinner2_best_index_0_2_choice;
      else
        winnerswinner2_best_index_0_2_choice_2 := ((winnerswinner1_best_cost_0_4 mod 2) = 1) and
          ((winnerswinner1_best_cost_0_5 mod 4) = 0);
      end if;
      winnerswinner2_best_index_0_2_value := ((winnerswinner1_best_cost_0_5 / 4) mod 2) = 1;
      if winnerswinner2_best_index_0_2_choice_2 then
        winnerswinner2_best_index_0_2_choice_3 := (not (((winnerswinner1_best_cost_0_4 / 4) mod 2) = 1)) and
          winnerswinner2_best_index_0_2_value;
      else
        winnerswinner2_best_index_0_2_choice_3 := (not (((winnerswinner1_best_cost_0_4 / 4) mod 2) = 1)) or
          winnerswinner2_best_index_0_2_value;
      end if;
      winnerswinner2_best_index_0_2_value_2 := ((winnerswinner1_best_cost_0_5 / 8) mod 2) = 1;
      if winnerswinner2_best_index_0_2_choice_3 then
        winnerswinner2_best_index_0_2_choice_4 := (not (((winnerswinner1_best_cost_0_4 / 8) mod 2) = 1)) or
          winnerswinner2_best_index_0_2_value_2;
      else
        winnerswinner2_best_index_0_2_choice_4 := (not (((winnerswinner1_best_cost_0_4 / 8) mod 2) = 1)) and
          winnerswinner2_best_index_0_2_value_2;
      end if;
      winnerswinner2_best_index_0_2_value_3 := ((winnerswinner1_best_cost_0_5 / 16) mod 2) = 1;
      if winnerswinner2_best_index_0_2_choice_4 then
        winnerswinner2_best_index_0_2_choice_5 := (not (((winnerswinner1_best_cost_0_4 / 16) mod 2) = 1)) or
          winnerswinner2_best_index_0_2_value_3;
      else
        winnerswinner2_best_index_0_2_choice_5 := (not (((winnerswinner1_best_cost_0_4 / 16) mod 2) = 1)) and
          winnerswinner2_best_index_0_2_value_3;
      end if;
      winnerswinner2_best_index_0_2_value_4 := ((winnerswinner1_best_cost_0_5 / 32) mod 2) = 1;
      if winnerswinner2_best_index_0_2_choice_5 then
        winnerswinner2_best_index_0_2_choice_6 := (not (((winnerswinner1_best_cost_0_4 / 32) mod 2) = 1)) or
          winnerswinner2_best_index_0_2_value_4;
      else
        winnerswinner2_best_index_0_2_choice_6 := (not (((winnerswinner1_best_cost_0_4 / 32) mod 2) = 1)) and
          winnerswinner2_best_index_0_2_value_4;
      end if;
      if winnerswinner2_best_index_0_2_choice_6 then
        winnerswinner2_best_index_0_2_choice_7 := ((winnerswinner1_best_cost_0_4 / 64) = 1) and (not
          ((winnerswinner1_best_cost_0_5 / 64) = 1));
      else
        winnerswinner2_best_index_0_2_choice_7 := ((winnerswinner1_best_cost_0_4 / 64) = 1) or (not
          ((winnerswinner1_best_cost_0_5 / 64) = 1));
      end if;
      if winnerswinner1_best_index_0_1 = 2 then
        winnerswinner2_best_below_0_0_choice := winnerswinner1_best_last_0_0;
      else
        winnerswinner2_best_below_0_0_choice := winnerswinner1_best_below_0_1;
      end if;
      if winnerswinner1_best_index_0_3 = 6 then
        winnerswinner2_best_below_0_1_choice := winnerswinner1_best_last_0_2;
      else
        winnerswinner2_best_below_0_1_choice := winnerswinner1_best_below_0_3;
      end if;
      if ((winnerswinner1_best_index_0_5 / 8) = 1) and ((winnerswinner1_best_index_0_5 mod 4) = 2) then
        winnerswinner2_best_below_0_2_choice := winnerswinner1_best_last_0_4;
      else
        winnerswinner2_best_below_0_2_choice := winnerswinner1_best_below_0_5;
      end if;
      if winnerswinner1_best_index_0_0 then
        winnerswinner2_best_above_0_0_choice := winnerswinner1_best_first_0_1;
      else
        winnerswinner2_best_above_0_0_choice := winnerswinner1_best_above_0_0;
      end if;
      if other_0 then
        winnerswinner2_best_above_0_1_choice := winnerswinner1_best_first_0_3;
      else
        winnerswinner2_best_above_0_1_choice := winnerswinner1_best_above_0_2;
      end if;
      if other_1 then
        winnerswinner2_best_above_0_2_choice := winnerswinner1_best_first_0_5;
      else
        winnerswinner2_best_above_0_2_choice := winnerswinner1_best_above_0_4;
      end if;
      winnerswinner2_best_first_0_1 <= winnerswinner1_best_first_0_2;
      winnerswinner2_best_first_0_2 <= winnerswinner1_best_first_0_4;
      winnerswinner2_best_last_0_0 <= winnerswinner1_best_last_0_1;
      winnerswinner2_best_last_0_1 <= winnerswinner1_best_last_0_3;
      winnerswinner2_tag_valid <= winnerswinner1_tag_valid;
      winnerswinner2_tag_map_column <= winnerswinner1_tag_map_column;
      winnerswinner2_tag_output_column <= winnerswinner1_tag_output_column;
      winnerswinner2_tag_start_of_frame <= winnerswinner1_tag_start_of_frame;
      winnerswinner2_tag_end_of_line <= winnerswinner1_tag_end_of_line;
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
      if (winnerswinner1_best_cost_0_5 - winnerswinner1_best_cost_0_4) < 0 then
        winnerswinner2_best_cost_0_2 <= winnerswinner1_best_cost_0_5;
      else
        winnerswinner2_best_cost_0_2 <= winnerswinner1_best_cost_0_4;
      end if;
      if winnerswinner2_best_index_0_0_choice_7 then
        winnerswinner2_best_index_0_0 <= winnerswinner1_best_index_0_1;
        winnerswinner2_best_below_0_0 <= winnerswinner2_best_below_0_0_choice;
        winnerswinner2_best_above_0_0 <= winnerswinner1_best_above_0_1;
      else
        winnerswinner2_best_index_0_0 <= as_number(winnerswinner1_best_index_0_0);
        winnerswinner2_best_below_0_0 <= winnerswinner1_best_below_0_0;
        winnerswinner2_best_above_0_0 <= winnerswinner2_best_above_0_0_choice;
      end if;
      if winnerswinner2_best_index_0_1_choice_7 then
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_3;
        winnerswinner2_best_below_0_1 <= winnerswinner2_best_below_0_1_choice;
        winnerswinner2_best_above_0_1 <= winnerswinner1_best_above_0_3;
      else
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_2;
        winnerswinner2_best_below_0_1 <= winnerswinner1_best_below_0_2;
        winnerswinner2_best_above_0_1 <= winnerswinner2_best_above_0_1_choice;
      end if;
      if winnerswinner2_best_index_0_2_choice_7 then
        winnerswinner2_best_index_0_2 <= winnerswinner1_best_index_0_5;
        winnerswinner2_best_below_0_2 <= winnerswinner2_best_below_0_2_choice;
        winnerswinner2_best_above_0_2 <= winnerswinner1_best_above_0_5;
      else
        winnerswinner2_best_index_0_2 <= winnerswinner1_best_index_0_4;
        winnerswinner2_best_below_0_2 <= winnerswinner1_best_below_0_4;
        winnerswinner2_best_above_0_2 <= winnerswinner2_best_above_0_2_choice;
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
      if winnerswinner3_best_index_0_0_choice_6 then
        winnerswinner3_best_index_0_0_choice_7 := ((winnerswinner2_best_cost_0_0 / 64) = 1) and (not
          ((winnerswinner2_best_cost_0_1 / 64) = 1));
      else
        winnerswinner3_best_index_0_0_choice_7 := ((winnerswinner2_best_cost_0_0 / 64) = 1) or (not
          ((winnerswinner2_best_cost_0_1 / 64) = 1));
      end if;
      if winnerswinner2_best_index_0_1 = 4 then
        winnerswinner3_best_below_0_0_choice := winnerswinner2_best_last_0_0;
      else
        winnerswinner3_best_below_0_0_choice := winnerswinner2_best_below_0_1;
      end if;
      if winnerswinner2_best_index_0_0 = 3 then
        winnerswinner3_best_above_0_0_choice := winnerswinner2_best_first_0_1;
      else
        winnerswinner3_best_above_0_0_choice := winnerswinner2_best_above_0_0;
      end if;
      winnerswinner3_best_cost_0_1 <= winnerswinner2_best_cost_0_2;
      winnerswinner3_best_index_0_1 <= winnerswinner2_best_index_0_2;
      winnerswinner3_best_below_0_1 <= winnerswinner2_best_below_0_2;
      winnerswinner3_best_above_0_1 <= winnerswinner2_best_above_0_2;
      winnerswinner3_best_first_0_1 <= winnerswinner2_best_first_0_2;
      winnerswinner3_best_last_0_0 <= winnerswinner2_best_last_0_1;
      winnerswinner3_tag_valid <= winnerswinner2_tag_valid;
      winnerswinner3_tag_map_column <= winnerswinner2_tag_map_column;
      winnerswinner3_tag_output_column <= winnerswinner2_tag_output_column;
      winnerswinner3_tag_start_of_frame <= winnerswinner2_tag_start_of_frame;
      winnerswinner3_tag_end_of_line <= winnerswinner2_tag_end_of_line;
      if (winnerswinner2_best_cost_0_1 - winnerswinner2_best_cost_0_0) < 0 then
        winnerswinner3_best_cost_0_0 <= winnerswinner2_best_cost_0_1;
      else
        winnerswinner3_best_cost_0_0 <= winnerswinner2_best_cost_0_0;
      end if;
      if winnerswinner3_best_index_0_0_choice_7 then
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_1;
        winnerswinner3_best_below_0_0 <= winnerswinner3_best_below_0_0_choice;
        winnerswinner3_best_above_0_0 <= winnerswinner2_best_above_0_1;
      else
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_0;
        winnerswinner3_best_below_0_0 <= winnerswinner2_best_below_0_0;
        winnerswinner3_best_above_0_0 <= winnerswinner3_best_above_0_0_choice;
      end if;
      -- winnerswinner4
      if (winnerswinner3_best_cost_0_0 mod 2) = 1 then
        winnerswinner4_best_index_0_0_choice := (not (((winnerswinner3_best_cost_0_1 / 2) mod 2) = 1)) or (not
          ((winnerswinner3_best_cost_0_1 mod 2) = 1));
      else
        winnerswinner4_best_index_0_0_choice := not (((winnerswinner3_best_cost_0_1 / 2) mod 2) = 1);
      end if;
      if ((winnerswinner3_best_cost_0_0 / 2) mod 2) = 1 then
        winnerswinner4_best_index_0_0_choice_2 := winnerswinner4_best_index_0_0_choice;
      else
        winnerswinner4_best_index_0_0_choice_2 := ((winnerswinner3_best_cost_0_0 mod 2) = 1) and
          ((winnerswinner3_best_cost_0_1 mod 4) = 0);
      end if;
      winnerswinner4_best_index_0_0_value := ((winnerswinner3_best_cost_0_1 / 4) mod 2) = 1;
      if winnerswinner4_best_index_0_0_choice_2 then
        winnerswinner4_best_index_0_0_choice_3 := (not (((winnerswinner3_best_cost_0_0 / 4) mod 2) = 1)) and
          winnerswinner4_best_index_0_0_value;
      else
        winnerswinner4_best_index_0_0_choice_3 := (not (((winnerswinner3_best_cost_0_0 / 4) mod 2) = 1)) or
          winnerswinner4_best_index_0_0_value;
      end if;
      winnerswinner4_best_index_0_0_value_2 := ((winnerswinner3_best_cost_0_1 / 8) mod 2) = 1;
      if winnerswinner4_best_index_0_0_choice_3 then
        winnerswinner4_best_index_0_0_choice_4 := (not (((winnerswinner3_best_cost_0_0 / 8) mod 2) = 1)) or
          winnerswinner4_best_index_0_0_value_2;
      else
        winnerswinner4_best_index_0_0_choice_4 := (not (((winnerswinner3_best_cost_0_0 / 8) mod 2) = 1)) and
          winnerswinner4_best_index_0_0_value_2;
      end if;
      winnerswinner4_best_index_0_0_value_3 := ((winnerswinner3_best_cost_0_1 / 16) mod 2) = 1;
      if winnerswinner4_best_index_0_0_choice_4 then
        winnerswinner4_best_index_0_0_choice_5 := (not (((winnerswinner3_best_cost_0_0 / 16) mod 2) = 1)) or
          winnerswinner4_best_index_0_0_value_3;
      else
        winnerswinner4_best_index_0_0_choice_5 := (not (((winnerswinner3_best_cost_0_0 / 16) mod 2) = 1)) and
          winnerswinner4_best_index_0_0_value_3;
      end if;
      winnerswinner4_best_index_0_0_value_4 := ((winnerswinner3_best_cost_0_1 / 32) mod 2) = 1;
      if winnerswinner4_best_index_0_0_choice_5 then
        winnerswinner4_best_index_0_0_choice_6 := (not (((winnerswinner3_best_cost_0_0 / 32) mod 2) = 1)) or
          winnerswinner4_best_index_0_0_value_4;
      else
        winnerswinner4_best_index_0_0_choice_6 := (not (((winnerswinner3_best_cost_0_0 / 32) mod 2) = 1)) and
          winnerswinner4_best_index_0_0_value_4;
      end if;
      if winnerswinner4_best_index_0_0_choice_6 then
        winnerswinner4_best_index_0_0_choice_7 := ((winnerswinner3_best_cost_0_0 / 64) = 1) and (not
          ((winnerswinner3_best_cost_0_1 / 64) = 1));
      else
        winnerswinner4_best_index_0_0_choice_7 := ((winnerswinner3_best_cost_0_0 / 64) = 1) or (not
          ((winnerswinner3_best_cost_0_1 / 64) = 1));
      end if;
      if ((winnerswinner3_best_index_0_1 / 8) = 1) and ((winnerswinner3_best_index_0_1 mod 4) = 0) then
        winnerswinner4_best_below_0_0_choice := winnerswinner3_best_last_0_0;
      else
        winnerswinner4_best_below_0_0_choice := winnerswinner3_best_below_0_1;
      end if;
      if winnerswinner3_best_index_0_0 = 7 then
        winnerswinner4_best_above_0_0_choice := winnerswinner3_best_first_0_1;
      else
        winnerswinner4_best_above_0_0_choice := winnerswinner3_best_above_0_0;
      end if;
      winnerswinner4_tag_valid <= winnerswinner3_tag_valid;
      winnerswinner4_tag_map_column <= winnerswinner3_tag_map_column;
      winnerswinner4_tag_output_column <= winnerswinner3_tag_output_column;
      winnerswinner4_tag_start_of_frame <= winnerswinner3_tag_start_of_frame;
      winnerswinner4_tag_end_of_line <= winnerswinner3_tag_end_of_line;
      if (winnerswinner3_best_cost_0_1 - winnerswinner3_best_cost_0_0) < 0 then
        winnerswinner4_best_cost_0_0 <= winnerswinner3_best_cost_0_1;
      else
        winnerswinner4_best_cost_0_0 <= winnerswinner3_best_cost_0_0;
      end if;
      if winnerswinner4_best_index_0_0_choice_7 then
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_1;
        winnerswinner4_best_below_0_0 <= winnerswinner4_best_below_0_0_choice;
        winnerswinner4_best_above_0_0 <= winnerswinner3_best_above_0_1;
      else
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_0;
        winnerswinner4_best_below_0_0 <= winnerswinner3_best_below_0_0;
        winnerswinner4_best_above_0_0 <= winnerswinner4_best_above_0_0_choice;
      end if;
      -- winners
      winners_best_cost_0_0 <= winnerswinner4_best_cost_0_0;
      winners_best_index_0_0 <= winnerswinner4_best_index_0_0;
      winners_best_below_0_0 <= winnerswinner4_best_below_0_0;
      winners_best_above_0_0 <= winnerswinner4_best_above_0_0;
      winners_best_tag_valid <= winnerswinner4_tag_valid;
      winners_best_tag_map_column <= winnerswinner4_tag_map_column;
      winners_best_tag_output_column <= winnerswinner4_tag_output_column;
      winners_best_tag_start_of_frame <= winnerswinner4_tag_start_of_frame;
      winners_best_tag_end_of_line <= winnerswinner4_tag_end_of_line;
      -- refinement
      refinement_remainder_1_0_difference := (refinement_remainder_0_0 + 256) - refinement_divisor_0_0;
      refinement_remainder_2_0_difference := ((refinement_remainder_1_0 * 2) + 256) - refinement_divisor_1_0;
      refinement_remainder_3_0_difference := ((refinement_remainder_2_0 * 2) + 256) - refinement_divisor_2_0;
      refinement_remainder_4_0_difference := ((refinement_remainder_3_0 * 2) + 256) - refinement_divisor_3_0;
      refinement_remainder_5_0_difference := ((refinement_remainder_4_0 * 2) + 256) - refinement_divisor_4_0;
      refinement_remainder_6_0_difference := ((refinement_remainder_5_0 * 2) + 256) - refinement_divisor_5_0;
      refinement_remainder_7_0_difference := ((refinement_remainder_6_0 * 2) + 256) - refinement_divisor_6_0;
      refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
      if refinement_divisor_0_0_is_less then
        refinement_divisor_0_0_choice := refinement_v_0;
      else
        refinement_divisor_0_0_choice := refinement_u_0;
      end if;
      refinement_fraction_0_difference := 0 - (refinement_quotient_8_0 / 16);
      refinement_fraction_0_value := (refinement_quotient_8_0 + 15) / 16;
      if refinement_negative_8_0 then
        refinement_fraction_0_choice := refinement_fraction_0_difference mod 128;
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
      refinement_cost_0 <= winners_best_cost_0_0;
      refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 128;
      refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 128;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_divisor_0_0 <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 7)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 7))));
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_quotient_8_0 <= ((((256 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) / 128) + ((other_2
        / 2) * 2);
      refinement_negative_0_0 <= refinement_divisor_0_0_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 16) * 8) + refinement_fraction_0_choice_2;
      if winners_best_index_0_0 = 0 then
        refinement_below_0 <= winners_best_above_0_0;
      else
        refinement_below_0 <= winners_best_below_0_0;
      end if;
      if winners_best_index_0_0 = 11 then
        refinement_above_0 <= winners_best_below_0_0;
      else
        refinement_above_0 <= winners_best_above_0_0;
      end if;
      if (refinement_remainder_1_0_difference / 256) = 1 then
        refinement_remainder_1_0 <= refinement_remainder_1_0_difference mod 128;
      else
        refinement_remainder_1_0 <= refinement_remainder_0_0;
      end if;
      if (refinement_remainder_2_0_difference / 256) = 1 then
        refinement_remainder_2_0 <= refinement_remainder_2_0_difference mod 128;
      else
        refinement_remainder_2_0 <= (refinement_remainder_1_0 mod 64) * 2;
      end if;
      if (refinement_remainder_3_0_difference / 256) = 1 then
        refinement_remainder_3_0 <= refinement_remainder_3_0_difference mod 128;
      else
        refinement_remainder_3_0 <= (refinement_remainder_2_0 mod 64) * 2;
      end if;
      if (refinement_remainder_4_0_difference / 256) = 1 then
        refinement_remainder_4_0 <= refinement_remainder_4_0_difference mod 128;
      else
        refinement_remainder_4_0 <= (refinement_remainder_3_0 mod 64) * 2;
      end if;
      if (refinement_remainder_5_0_difference / 256) = 1 then
        refinement_remainder_5_0 <= refinement_remainder_5_0_difference mod 128;
      else
        refinement_remainder_5_0 <= (refinement_remainder_4_0 mod 64) * 2;
      end if;
      if (refinement_remainder_6_0_difference / 256) = 1 then
        refinement_remainder_6_0 <= refinement_remainder_6_0_difference mod 128;
      else
        refinement_remainder_6_0 <= (refinement_remainder_5_0 mod 64) * 2;
      end if;
      if (refinement_remainder_7_0_difference / 256) = 1 then
        refinement_remainder_7_0 <= refinement_remainder_7_0_difference mod 128;
      else
        refinement_remainder_7_0 <= (refinement_remainder_6_0 mod 64) * 2;
      end if;
      -- turn
      turn_order_address_any := turn_order_inside or (not refinement_tag_11_map_column) or (not
        refinement_tag_11_valid);
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
      turn_order_address_any_2 := (not refinement_tag_11_map_column) or (not refinement_tag_11_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 32;
        else
          turn_order_address <= turn_order_address_choice_2 * 4;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and refinement_tag_11_map_column and refinement_tag_11_valid;
      turn_order_complete_all := refinement_tag_11_map_column and refinement_tag_11_valid;
      if turn_order_falls_all then
        turn_order_turned_output_column_choice := turn_order_output and turn_order_complete;
      else
        turn_order_turned_output_column_choice := turn_order_held_output;
      end if;
      turn_order_turned_valid <= refinement_tag_11_valid;
      turn_order_turned_output_column <= turn_order_turned_output_column_choice and refinement_tag_11_map_column;
      turn_order_turned_start_of_frame <= (not turn_order_inside) and refinement_tag_11_map_column and
        refinement_tag_11_valid and turn_order_first and turn_order_output and turn_order_complete;
      turn_order_turned_end_of_line <= refinement_tag_11_end_of_line;
      turn_newest <= ((other_9 / 256) * 256) + (refinement_fraction_0 * 512) + refinement_disparity_11_0;
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
      if refinement_tag_11_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if refinement_tag_11_valid then
        turn_order_inside <= refinement_tag_11_map_column;
      end if;
      if turn_order_falls_all then
        turn_order_output <= refinement_tag_11_output_column;
        turn_order_first <= refinement_tag_11_start_of_frame;
        turn_order_held_output <= turn_order_output and turn_order_complete;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
        turn_write_place <= turn_order_address;
      end if;
      -- map
      map_out_disparity_0 <= ((((((turn_ready mod 16) + (turn_ready / 8192)) * 2) + (((turn_ready / 512) mod 16) / 8) +
        8191) mod 8192) * 8) + ((turn_ready / 512) mod 8);
      map_out_passed_0 <= ((turn_ready / 256) mod 2) = 1;
      map_out_valid <= turn_ready_tag_valid and turn_ready_tag_output_column;
      map_out_start_of_frame <= turn_ready_tag_start_of_frame and turn_ready_tag_valid and turn_ready_tag_output_column;
      map_out_end_of_line <= turn_ready_tag_end_of_line and turn_ready_tag_valid and turn_ready_tag_output_column;
      -- other
      other_0 <= winnerswinner1_best_index_0_2_choice_7;
      other_1 <= winnerswinner1_best_index_0_4_choice_7;
      other_2 <= ((refinement_remainder_7_0_difference / 256) * 2) + ((other_3 / 4) * 4);
      other_3 <= ((refinement_remainder_6_0_difference / 256) * 4) + ((other_4 / 8) * 8);
      other_4 <= ((refinement_remainder_5_0_difference / 256) * 8) + ((other_5 / 16) * 16);
      other_5 <= ((refinement_remainder_4_0_difference / 256) * 16) + ((other_6 / 32) * 32);
      other_6 <= ((refinement_remainder_3_0_difference / 256) * 32) + ((other_7 / 64) * 64);
      other_7 <= ((refinement_remainder_2_0_difference / 256) * 64) + ((other_8 / 128) * 128);
      other_8 <= (refinement_remainder_1_0_difference / 256) * 128;
      other_9 <= other_10;
      other_10 <= other_11;
      other_11 <= other_12;
      other_12 <= other_13;
      other_13 <= other_14;
      other_14 <= other_15;
      other_15 <= other_16;
      other_16 <= other_17;
      other_17 <= other_18;
      other_18 <= other_19;
      other_19 <= other_20;
      other_20 <= 256;
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
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
