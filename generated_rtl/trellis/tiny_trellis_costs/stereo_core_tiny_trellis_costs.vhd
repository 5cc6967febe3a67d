-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, trellis, configuration tiny_trellis_costs: 40x12, 12 disparities, window 3x3, drop 0 or by 2, occlusion 2, 1 pixel pair a clock.
-- Options: disparities 12, drop_cost 0, occlusion_cost 2, far_drop 2, slice_disparities 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_trellis_costs
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_trellis_costs is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 12;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 29;
    latency_clocks : positive := 28;
    flush_groups : positive := 204;
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
  assert width_px = 40 report "stereo_core_tiny_trellis_costs: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 12 report "stereo_core_tiny_trellis_costs: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 12 report "stereo_core_tiny_trellis_costs: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_trellis_costs: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_trellis_costs: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 29 report "stereo_core_tiny_trellis_costs: output_width_px is " & integer'image(output_width_px) & " but this core has 29" severity failure;
  assert latency_clocks = 28 report "stereo_core_tiny_trellis_costs: latency_clocks is " & integer'image(latency_clocks) & " but this core has 28" severity failure;
  assert flush_groups = 204 report "stereo_core_tiny_trellis_costs: flush_groups is " & integer'image(flush_groups) & " but this core has 204" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_trellis_costs: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_trellis_costs is
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
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16777215;
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
  signal entry_order_complete, entry_order_output, entry_order_held_output, entry_order_turned_output_column : boolean;
  signal entry_order_turned_start_of_frame, entry_tag_valid, entry_tag_map_column, entry_tag_first_column : boolean;
  signal entry_tag_end_of_line, entry_turned_output_column, entry_turned_start_of_frame : boolean;
  signal entry_order_address, entry_place : natural range 0 to 31;
  -- forward
  signal forward_next_cost_0, forward_next_cost_1, forward_next_cost_2, forward_next_cost_3 : natural range 0 to 13;
  signal forward_next_cost_4, forward_next_cost_5, forward_next_cost_6, forward_next_cost_7 : natural range 0 to 13;
  signal forward_next_cost_8, forward_next_cost_9, forward_next_cost_10, forward_next_cost_11 : natural range 0 to 13;
  signal forward_next_first, forward_far_0, forward_far_1, forward_far_2, forward_far_3, forward_far_4 : boolean;
  signal forward_far_5, forward_far_6, forward_far_7, forward_far_8, forward_far_9 : boolean;
  signal forward_pair_cost_0, forward_pair_cost_1, forward_pair_cost_2, forward_pair_cost_3 : natural range 0 to 26;
  signal forward_pair_cost_4, forward_pair_cost_5, forward_pair_cost_6, forward_pair_cost_7 : natural range 0 to 26;
  signal forward_pair_cost_8, forward_pair_cost_9, forward_pair_cost_10, forward_pair_cost_11 : natural range 0 to 26;
  signal forward_path_0, forward_path_1, forward_path_2, forward_path_3, forward_path_4 : natural range 0 to 511;
  signal forward_path_5, forward_path_6, forward_path_7, forward_path_8, forward_path_9 : natural range 0 to 511;
  signal forward_path_10, forward_path_11, forward_stayed_0, forward_stayed_1 : natural range 0 to 511;
  signal forward_stayed_2, forward_stayed_3, forward_stayed_4, forward_stayed_5 : natural range 0 to 511;
  signal forward_stayed_6, forward_stayed_7, forward_stayed_8, forward_stayed_9 : natural range 0 to 511;
  signal forward_stayed_10, forward_stayed_11, forward_occluding_0, forward_occluding_1 : natural range 0 to 511;
  signal forward_occluding_2, forward_occluding_3, forward_occluding_4, forward_occluding_5 : natural range 0 to 511;
  signal forward_occluding_6, forward_occluding_7, forward_occluding_8, forward_occluding_9 : natural range 0 to 511;
  signal forward_occluding_10, forward_dropped_0, forward_dropped_1, forward_dropped_2 : natural range 0 to 511;
  signal forward_dropped_3, forward_dropped_4, forward_dropped_5, forward_dropped_6 : natural range 0 to 511;
  signal forward_dropped_7, forward_dropped_8, forward_dropped_9, forward_dropped_10 : natural range 0 to 511;
  signal forward_dropped_11 : natural range 0 to 511;
  signal forward_decision_0 : natural range 0 to 2;
  signal forward_decision_1, forward_decision_2, forward_decision_3, forward_decision_4 : natural range 0 to 3;
  signal forward_decision_5, forward_decision_6, forward_decision_7, forward_decision_8 : natural range 0 to 3;
  signal forward_decision_9, forward_decision_10, forward_decision_11 : natural range 0 to 3;
  -- decisions
  signal decisions_read_words_0 : unsigned(23 downto 0);
  signal decisions_ready_decision_0, decisions_ready_decision_1, decisions_ready_decision_2 : natural range 0 to 3;
  signal decisions_ready_decision_3, decisions_ready_decision_4, decisions_ready_decision_5 : natural range 0 to 3;
  signal decisions_ready_decision_6, decisions_ready_decision_7, decisions_ready_decision_8 : natural range 0 to 3;
  signal decisions_ready_decision_9, decisions_ready_decision_10, decisions_ready_decision_11 : natural range 0 to 3;
  signal decisions_ready_inside, decisions_comes_0, decisions_comes_1, decisions_comes_2 : boolean;
  signal decisions_place_0, decisions_place_1, decisions_place_2, decisions_write_place : natural range 0 to 31;
  signal decisions_write_words_0 : natural range 0 to 16777214;
  -- last
  signal last_tags_held_0_end_of_line, last_tags_held_1_map_column, last_tags_held_1_end_of_line : boolean;
  signal last_tags_held_2_map_column, last_tags_held_2_end_of_line, last_tags_moved, last_tag_valid : boolean;
  signal last_tag_map_column, last_tag_end_of_line : boolean;
  signal last_path_0_0 : natural range 0 to 256;
  signal last_path_0_1, last_path_0_2, last_path_0_3, last_path_0_4, last_path_0_5 : natural range 0 to 511;
  signal last_path_0_6, last_path_0_7, last_path_0_8, last_path_0_9, last_path_0_10 : natural range 0 to 511;
  signal last_path_0_11 : natural range 0 to 511;
  signal last_state : natural range 0 to 11;
  -- lastwinner1
  signal lastwinner1_best_cost_0_0, lastwinner1_best_cost_0_1, lastwinner1_best_cost_0_2 : natural range 0 to 511;
  signal lastwinner1_best_cost_0_3, lastwinner1_best_cost_0_4, lastwinner1_best_cost_0_5 : natural range 0 to 511;
  signal lastwinner1_best_index_0_0, lastwinner1_tag_valid, lastwinner1_tag_map_column : boolean;
  signal lastwinner1_tag_end_of_line : boolean;
  signal lastwinner1_best_index_0_1 : natural range 0 to 3;
  signal lastwinner1_best_index_0_2 : natural range 0 to 5;
  signal lastwinner1_best_index_0_3 : natural range 0 to 7;
  signal lastwinner1_best_index_0_4 : natural range 0 to 9;
  signal lastwinner1_best_index_0_5 : natural range 0 to 11;
  -- lastwinner2
  signal lastwinner2_best_cost_0_0, lastwinner2_best_cost_0_1, lastwinner2_best_cost_0_2 : natural range 0 to 511;
  signal lastwinner2_best_index_0_0 : natural range 0 to 3;
  signal lastwinner2_best_index_0_1 : natural range 0 to 7;
  signal lastwinner2_best_index_0_2 : natural range 0 to 11;
  signal lastwinner2_tag_valid, lastwinner2_tag_map_column, lastwinner2_tag_end_of_line : boolean;
  -- lastwinner3
  signal lastwinner3_best_cost_0_0, lastwinner3_best_cost_0_1 : natural range 0 to 511;
  signal lastwinner3_best_index_0_0 : natural range 0 to 7;
  signal lastwinner3_best_index_0_1 : natural range 0 to 11;
  signal lastwinner3_tag_valid, lastwinner3_tag_map_column, lastwinner3_tag_end_of_line : boolean;
  -- lastwinner4
  signal lastwinner4_best_index_0_0 : natural range 0 to 11;
  signal lastwinner4_tag_valid, lastwinner4_tag_map_column, lastwinner4_tag_end_of_line : boolean;
  -- traceback
  signal traceback_state, traceback_out_disparity_0 : natural range 0 to 255;
  signal traceback_decision, traceback_falling : natural range 0 to 3;
  signal traceback_tags_held_0_output_column, traceback_tags_held_0_start_of_frame : boolean;
  signal traceback_tags_held_1_output_column, traceback_tags_held_1_start_of_frame, traceback_out_passed_0 : boolean;
  signal traceback_out_tag_map_column, traceback_out_tag_output_column, traceback_out_tag_start_of_frame : boolean;
  signal traceback_out_tag_end_of_line : boolean;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 31;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_held_output, turn_order_turned_map_column, turn_order_turned_output_column : boolean;
  signal turn_order_turned_first_column, turn_comes, turn_read_tag_map_column, turn_read_tag_output_column : boolean;
  signal turn_read_tag_first_column, turn_ready_tag_map_column, turn_ready_tag_output_column : boolean;
  signal turn_ready_tag_first_column : boolean;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 511;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- fill
  signal fill_out_disparity_0 : natural range 0 to 255;
  signal fill_out_passed_0, fill_out_tag_output_column : boolean;
  -- other
  signal other_0, other_1, other_2, other_3 : natural range 0 to 257;
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
  signal decisions_read_words_0_memory_read_enable : boolean;
  signal decisions_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal decisions_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal decisions_read_words_0_memory_write_data : unsigned(23 downto 0);
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

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(fill_out_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(fill_out_passed_0), 1));
  disparity_valid <= as_bit(lastwinner4_tag_valid and fill_out_tag_output_column);
  disparity_start_of_frame <= as_bit(((other_1 mod 2) = 1) and lastwinner4_tag_valid and fill_out_tag_output_column);
  disparity_end_of_line <= as_bit(((other_1 / 256) = 1) and lastwinner4_tag_valid and fill_out_tag_output_column);

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

  decisions_read_words_0_memory_read_enable <= true;
  decisions_read_words_0_memory_read_address <= to_unsigned(entry_order_address, 5);
  decisions_read_words_0_memory_write_address <= to_unsigned(decisions_write_place, 5);
  decisions_read_words_0_memory_write_data <= to_unsigned(decisions_write_words_0, 24);
  decisions_read_words_0_memory : entity work.line_memory
    generic map (depth => 29, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => decisions_read_words_0_memory_read_enable,
      read_address => decisions_read_words_0_memory_read_address, read_data => decisions_read_words_0,
      write_address => decisions_read_words_0_memory_write_address, write_data => decisions_read_words_0_memory_write_data);

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
    variable entry_order_complete_any, entry_order_turned_output_column_choice, forward_path_0_value : boolean;
    variable forward_path_1_any, forward_path_1_value, forward_path_2_any, forward_path_2_value : boolean;
    variable forward_path_3_any, forward_path_3_value, forward_path_4_any, forward_path_4_value : boolean;
    variable forward_path_5_any, forward_path_5_value, forward_path_6_any, forward_path_6_value : boolean;
    variable forward_path_7_any, forward_path_7_value, forward_path_8_any, forward_path_8_value : boolean;
    variable forward_path_9_any, forward_path_9_value, forward_path_10_any, forward_path_10_value : boolean;
    variable forward_path_11_any, forward_path_11_value, forward_occluding_0_choice : boolean;
    variable forward_occluding_1_choice, forward_occluding_1_choice_2, forward_occluding_2_choice : boolean;
    variable forward_occluding_2_choice_2, forward_occluding_3_choice, forward_occluding_3_choice_2 : boolean;
    variable forward_occluding_4_choice, forward_occluding_4_choice_2, forward_occluding_5_choice : boolean;
    variable forward_occluding_5_choice_2, forward_occluding_6_choice, forward_occluding_6_choice_2 : boolean;
    variable forward_occluding_7_choice, forward_occluding_7_choice_2, forward_occluding_8_choice : boolean;
    variable forward_occluding_8_choice_2, forward_occluding_9_choice, forward_occluding_9_choice_2 : boolean;
    variable forward_occluding_10_choice, forward_occluding_10_choice_2, forward_dropped_0_value : boolean;
    variable forward_dropped_1_value, forward_dropped_2_value, forward_dropped_3_value : boolean;
    variable forward_dropped_4_value, forward_dropped_5_value, forward_dropped_6_value : boolean;
    variable forward_dropped_7_value, forward_dropped_8_value, forward_dropped_9_value, forward_far_1_any : boolean;
    variable forward_far_1_choice, forward_far_2_choice, forward_far_3_choice, forward_far_4_choice : boolean;
    variable forward_far_5_choice, forward_far_6_choice, forward_far_7_choice, forward_far_8_choice : boolean;
    variable forward_far_9_choice, decisions_write_words_0_all, lastwinner1_best_cost_0_0_is_less : boolean;
    variable lastwinner1_best_cost_0_1_is_less, lastwinner1_best_cost_0_2_is_less : boolean;
    variable lastwinner1_best_cost_0_3_is_less, lastwinner1_best_cost_0_4_is_less : boolean;
    variable lastwinner1_best_cost_0_5_is_less, lastwinner2_best_cost_0_0_is_less : boolean;
    variable lastwinner2_best_cost_0_1_is_less, lastwinner2_best_cost_0_2_is_less : boolean;
    variable lastwinner3_best_cost_0_0_is_less, traceback_state_is_equal, traceback_state_is_equal_2 : boolean;
    variable traceback_state_is_equal_3, traceback_state_all, traceback_decision_value : boolean;
    variable traceback_decision_value_2, traceback_decision_value_3, turn_order_address_any : boolean;
    variable turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_order_turned_output_column_choice : boolean;
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 3;
    variable traceback_decision_choice, traceback_decision_choice_2, traceback_decision_choice_3 : natural range 0 to 3;
    variable traceback_decision_choice_4, traceback_decision_choice_5 : natural range 0 to 3;
    variable traceback_decision_choice_6, traceback_decision_choice_7 : natural range 0 to 3;
    variable traceback_decision_choice_8, traceback_decision_choice_9 : natural range 0 to 3;
    variable traceback_decision_choice_10, traceback_decision_choice_11 : natural range 0 to 3;
    variable traceback_decision_choice_12, traceback_decision_choice_13 : natural range 0 to 3;
    variable traceback_decision_choice_14, traceback_decision_choice_15 : natural range 0 to 3;
    variable traceback_decision_choice_16, traceback_decision_choice_17 : natural range 0 to 3;
    variable traceback_decision_choice_18, traceback_decision_choice_19 : natural range 0 to 3;
    variable traceback_decision_choice_20, traceback_decision_choice_21 : natural range 0 to 3;
    variable traceback_decision_choice_22, traceback_decision_choice_23 : natural range 0 to 3;
    variable traceback_decision_choice_24, traceback_decision_choice_25 : natural range 0 to 3;
    variable traceback_decision_choice_26, traceback_decision_choice_27 : natural range 0 to 3;
    variable traceback_decision_choice_28, traceback_decision_choice_29 : natural range 0 to 3;
    variable traceback_decision_choice_30, traceback_decision_choice_31 : natural range 0 to 3;
    variable traceback_decision_choice_32, traceback_decision_choice_33 : natural range 0 to 3;
    variable traceback_decision_choice_34, traceback_decision_choice_35 : natural range 0 to 3;
    variable traceback_decision_choice_36, traceback_decision_choice_37 : natural range 0 to 3;
    variable traceback_decision_choice_38, traceback_decision_choice_39 : natural range 0 to 3;
    variable traceback_decision_choice_40, traceback_decision_choice_41 : natural range 0 to 3;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 15;
    variable raster_place_group_choice_3, raster_place_group_choice_4 : natural range 0 to 15;
    variable transform_left_filter_feature_0_choice_193 : natural range 0 to 31;
    variable transform_right_filter_feature_0_choice_193 : natural range 0 to 31;
    variable transform_left_filter_feature_0_choice_194 : natural range 0 to 1023;
    variable transform_right_filter_feature_0_choice_194 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_195 : natural range 0 to 8191;
    variable transform_right_filter_feature_0_choice_195 : natural range 0 to 8191;
    variable transform_left_filter_feature_0_choice_196 : natural range 0 to 524287;
    variable transform_right_filter_feature_0_choice_196 : natural range 0 to 524287;
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 31;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 7;
    variable forward_path_0_choice, forward_path_0_choice_2, forward_path_1_choice : natural range 0 to 511;
    variable forward_path_1_choice_2, forward_path_1_choice_3, forward_path_2_choice : natural range 0 to 511;
    variable forward_path_2_choice_2, forward_path_2_choice_3, forward_path_3_choice : natural range 0 to 511;
    variable forward_path_3_choice_2, forward_path_3_choice_3, forward_path_4_choice : natural range 0 to 511;
    variable forward_path_4_choice_2, forward_path_4_choice_3, forward_path_5_choice : natural range 0 to 511;
    variable forward_path_5_choice_2, forward_path_5_choice_3, forward_path_6_choice : natural range 0 to 511;
    variable forward_path_6_choice_2, forward_path_6_choice_3, forward_path_7_choice : natural range 0 to 511;
    variable forward_path_7_choice_2, forward_path_7_choice_3, forward_path_8_choice : natural range 0 to 511;
    variable forward_path_8_choice_2, forward_path_8_choice_3, forward_path_9_choice : natural range 0 to 511;
    variable forward_path_9_choice_2, forward_path_9_choice_3, forward_path_10_choice : natural range 0 to 511;
    variable forward_path_10_choice_2, forward_path_10_choice_3, forward_path_11_choice : natural range 0 to 511;
    variable forward_path_11_choice_2, forward_path_11_choice_3, forward_dropped_0_choice : natural range 0 to 511;
    variable forward_dropped_1_choice, forward_dropped_2_choice, forward_dropped_3_choice : natural range 0 to 511;
    variable forward_dropped_4_choice, forward_dropped_5_choice, forward_dropped_6_choice : natural range 0 to 511;
    variable forward_dropped_7_choice, forward_dropped_8_choice, forward_dropped_9_choice : natural range 0 to 511;
    variable forward_decision_0_choice, forward_decision_1_choice, forward_decision_2_choice : natural range 1 to 2;
    variable forward_decision_3_choice, forward_decision_4_choice, forward_decision_5_choice : natural range 1 to 2;
    variable forward_decision_6_choice, forward_decision_7_choice, forward_decision_8_choice : natural range 1 to 2;
    variable forward_decision_9_choice : natural range 1 to 2;
    variable forward_decision_1_choice_2, forward_decision_2_choice_2 : natural range 0 to 2;
    variable forward_decision_3_choice_2, forward_decision_4_choice_2 : natural range 0 to 2;
    variable forward_decision_5_choice_2, forward_decision_6_choice_2 : natural range 0 to 2;
    variable forward_decision_7_choice_2, forward_decision_8_choice_2 : natural range 0 to 2;
    variable forward_decision_9_choice_2 : natural range 0 to 2;
    variable last_path_0_2_difference : integer range -255 to 256;
    variable traceback_state_sum : natural range 1 to 256;
    variable traceback_state_sum_2 : natural range 1 to 128;
    variable traceback_state_sum_3 : natural range 255 to 510;
    variable traceback_state_choice, traceback_state_choice_2, traceback_state_choice_3 : natural range 0 to 255;
    variable fill_out_disparity_0_choice : natural range 0 to 255;
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
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
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
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 13;
      delay_tag_first_cost_is_equal := raster_place_column = 11;
      delay_tag_map_column_is_not_less := raster_place_column >= 11;
      delay_tag_map_column_is_less := raster_place_column < 40;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
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
      rows_search_rows_read_newest_0 <= delay_delayed_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
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
      entry_order_falls_any := (not slice0_tag_2_valid) or (not slice0_tag_2_map_column) or entry_order_inside;
      entry_order_falls_all := slice0_tag_2_valid and slice0_tag_2_map_column and (not entry_order_inside);
      entry_order_complete_any := (not slice0_tag_2_valid) or (not slice0_tag_2_map_column);
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
      entry_order_turned_start_of_frame <= slice0_tag_2_valid and slice0_tag_2_map_column and (not entry_order_inside)
        and entry_next_top and entry_order_output and entry_order_complete;
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
      entry_place <= entry_order_address;
      entry_turned_output_column <= entry_order_turned_output_column;
      entry_turned_start_of_frame <= entry_order_turned_start_of_frame;
      if entry_order_falls then
        entry_order_falls <= entry_order_falls_any;
      else
        entry_order_falls <= entry_order_falls_all;
      end if;
      if slice0_tag_2_end_of_line then
        entry_order_complete <= entry_order_complete or (slice0_tag_2_valid and slice0_tag_2_map_column);
      else
        entry_order_complete <= entry_order_complete and entry_order_complete_any;
      end if;
      if entry_order_falls_all then
        entry_next_top <= slice0_tag_2_start_of_frame;
        entry_order_output <= slice0_tag_2_output_column;
        entry_order_held_output <= entry_order_output and entry_order_complete;
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
      -- forward
      forward_path_0_value := (((forward_dropped_0 - forward_stayed_0) mod 512) / 256) = 1;
      if forward_path_0_value then
        forward_path_0_choice := forward_dropped_0;
      else
        forward_path_0_choice := forward_stayed_0;
      end if;
      if forward_next_first then
        forward_path_0_choice_2 := 0;
      else
        forward_path_0_choice_2 := forward_path_0_choice;
      end if;
      forward_path_1_any := (not ((((forward_occluding_0 - forward_stayed_1) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_0 - forward_dropped_1) mod 512) / 256) = 1));
      forward_path_1_value := (((forward_dropped_1 - forward_stayed_1) mod 512) / 256) = 1;
      if forward_path_1_value then
        forward_path_1_choice := forward_dropped_1;
      else
        forward_path_1_choice := forward_stayed_1;
      end if;
      if forward_path_1_any then
        forward_path_1_choice_2 := forward_path_1_choice;
      else
        forward_path_1_choice_2 := forward_occluding_0;
      end if;
      if forward_next_first then
        forward_path_1_choice_3 := 0;
      else
        forward_path_1_choice_3 := forward_path_1_choice_2;
      end if;
      forward_path_2_any := (not ((((forward_occluding_1 - forward_stayed_2) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_1 - forward_dropped_2) mod 512) / 256) = 1));
      forward_path_2_value := (((forward_dropped_2 - forward_stayed_2) mod 512) / 256) = 1;
      if forward_path_2_value then
        forward_path_2_choice := forward_dropped_2;
      else
        forward_path_2_choice := forward_stayed_2;
      end if;
      if forward_path_2_any then
        forward_path_2_choice_2 := forward_path_2_choice;
      else
        forward_path_2_choice_2 := forward_occluding_1;
      end if;
      if forward_next_first then
        forward_path_2_choice_3 := 0;
      else
        forward_path_2_choice_3 := forward_path_2_choice_2;
      end if;
      forward_path_3_any := (not ((((forward_occluding_2 - forward_stayed_3) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_2 - forward_dropped_3) mod 512) / 256) = 1));
      forward_path_3_value := (((forward_dropped_3 - forward_stayed_3) mod 512) / 256) = 1;
      if forward_path_3_value then
        forward_path_3_choice := forward_dropped_3;
      else
        forward_path_3_choice := forward_stayed_3;
      end if;
      if forward_path_3_any then
        forward_path_3_choice_2 := forward_path_3_choice;
      else
        forward_path_3_choice_2 := forward_occluding_2;
      end if;
      if forward_next_first then
        forward_path_3_choice_3 := 0;
      else
        forward_path_3_choice_3 := forward_path_3_choice_2;
      end if;
      forward_path_4_any := (not ((((forward_occluding_3 - forward_stayed_4) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_3 - forward_dropped_4) mod 512) / 256) = 1));
      forward_path_4_value := (((forward_dropped_4 - forward_stayed_4) mod 512) / 256) = 1;
      if forward_path_4_value then
        forward_path_4_choice := forward_dropped_4;
      else
        forward_path_4_choice := forward_stayed_4;
      end if;
      if forward_path_4_any then
        forward_path_4_choice_2 := forward_path_4_choice;
      else
        forward_path_4_choice_2 := forward_occluding_3;
      end if;
      if forward_next_first then
        forward_path_4_choice_3 := 0;
      else
        forward_path_4_choice_3 := forward_path_4_choice_2;
      end if;
      forward_path_5_any := (not ((((forward_occluding_4 - forward_stayed_5) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_4 - forward_dropped_5) mod 512) / 256) = 1));
      forward_path_5_value := (((forward_dropped_5 - forward_stayed_5) mod 512) / 256) = 1;
      if forward_path_5_value then
        forward_path_5_choice := forward_dropped_5;
      else
        forward_path_5_choice := forward_stayed_5;
      end if;
      if forward_path_5_any then
        forward_path_5_choice_2 := forward_path_5_choice;
      else
        forward_path_5_choice_2 := forward_occluding_4;
      end if;
      if forward_next_first then
        forward_path_5_choice_3 := 0;
      else
        forward_path_5_choice_3 := forward_path_5_choice_2;
      end if;
      forward_path_6_any := (not ((((forward_occluding_5 - forward_stayed_6) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_5 - forward_dropped_6) mod 512) / 256) = 1));
      forward_path_6_value := (((forward_dropped_6 - forward_stayed_6) mod 512) / 256) = 1;
      if forward_path_6_value then
        forward_path_6_choice := forward_dropped_6;
      else
        forward_path_6_choice := forward_stayed_6;
      end if;
      if forward_path_6_any then
        forward_path_6_choice_2 := forward_path_6_choice;
      else
        forward_path_6_choice_2 := forward_occluding_5;
      end if;
      if forward_next_first then
        forward_path_6_choice_3 := 0;
      else
        forward_path_6_choice_3 := forward_path_6_choice_2;
      end if;
      forward_path_7_any := (not ((((forward_occluding_6 - forward_stayed_7) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_6 - forward_dropped_7) mod 512) / 256) = 1));
      forward_path_7_value := (((forward_dropped_7 - forward_stayed_7) mod 512) / 256) = 1;
      if forward_path_7_value then
        forward_path_7_choice := forward_dropped_7;
      else
        forward_path_7_choice := forward_stayed_7;
      end if;
      if forward_path_7_any then
        forward_path_7_choice_2 := forward_path_7_choice;
      else
        forward_path_7_choice_2 := forward_occluding_6;
      end if;
      if forward_next_first then
        forward_path_7_choice_3 := 0;
      else
        forward_path_7_choice_3 := forward_path_7_choice_2;
      end if;
      forward_path_8_any := (not ((((forward_occluding_7 - forward_stayed_8) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_7 - forward_dropped_8) mod 512) / 256) = 1));
      forward_path_8_value := (((forward_dropped_8 - forward_stayed_8) mod 512) / 256) = 1;
      if forward_path_8_value then
        forward_path_8_choice := forward_dropped_8;
      else
        forward_path_8_choice := forward_stayed_8;
      end if;
      if forward_path_8_any then
        forward_path_8_choice_2 := forward_path_8_choice;
      else
        forward_path_8_choice_2 := forward_occluding_7;
      end if;
      if forward_next_first then
        forward_path_8_choice_3 := 0;
      else
        forward_path_8_choice_3 := forward_path_8_choice_2;
      end if;
      forward_path_9_any := (not ((((forward_occluding_8 - forward_stayed_9) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_8 - forward_dropped_9) mod 512) / 256) = 1));
      forward_path_9_value := (((forward_dropped_9 - forward_stayed_9) mod 512) / 256) = 1;
      if forward_path_9_value then
        forward_path_9_choice := forward_dropped_9;
      else
        forward_path_9_choice := forward_stayed_9;
      end if;
      if forward_path_9_any then
        forward_path_9_choice_2 := forward_path_9_choice;
      else
        forward_path_9_choice_2 := forward_occluding_8;
      end if;
      if forward_next_first then
        forward_path_9_choice_3 := 0;
      else
        forward_path_9_choice_3 := forward_path_9_choice_2;
      end if;
      forward_path_10_any := (not ((((forward_occluding_9 - forward_stayed_10) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_9 - forward_dropped_10) mod 512) / 256) = 1));
      forward_path_10_value := (((forward_dropped_10 - forward_stayed_10) mod 512) / 256) = 1;
      if forward_path_10_value then
        forward_path_10_choice := forward_dropped_10;
      else
        forward_path_10_choice := forward_stayed_10;
      end if;
      if forward_path_10_any then
        forward_path_10_choice_2 := forward_path_10_choice;
      else
        forward_path_10_choice_2 := forward_occluding_9;
      end if;
      if forward_next_first then
        forward_path_10_choice_3 := 0;
      else
        forward_path_10_choice_3 := forward_path_10_choice_2;
      end if;
      forward_path_11_any := (not ((((forward_occluding_10 - forward_stayed_11) mod 512) / 256) = 1)) or (not
        ((((forward_occluding_10 - forward_dropped_11) mod 512) / 256) = 1));
      forward_path_11_value := (((forward_dropped_11 - forward_stayed_11) mod 512) / 256) = 1;
      if forward_path_11_value then
        forward_path_11_choice := forward_dropped_11;
      else
        forward_path_11_choice := forward_stayed_11;
      end if;
      if forward_path_11_any then
        forward_path_11_choice_2 := forward_path_11_choice;
      else
        forward_path_11_choice_2 := forward_occluding_10;
      end if;
      if forward_next_first then
        forward_path_11_choice_3 := 0;
      else
        forward_path_11_choice_3 := forward_path_11_choice_2;
      end if;
      if forward_path_0_value then
        forward_occluding_0_choice := (forward_dropped_0 mod 2) = 1;
      else
        forward_occluding_0_choice := (forward_stayed_0 mod 2) = 1;
      end if;
      if forward_path_1_value then
        forward_occluding_1_choice := (forward_dropped_1 mod 2) = 1;
      else
        forward_occluding_1_choice := (forward_stayed_1 mod 2) = 1;
      end if;
      if forward_path_1_any then
        forward_occluding_1_choice_2 := forward_occluding_1_choice;
      else
        forward_occluding_1_choice_2 := (forward_occluding_0 mod 2) = 1;
      end if;
      if forward_path_2_value then
        forward_occluding_2_choice := (forward_dropped_2 mod 2) = 1;
      else
        forward_occluding_2_choice := (forward_stayed_2 mod 2) = 1;
      end if;
      if forward_path_2_any then
        forward_occluding_2_choice_2 := forward_occluding_2_choice;
      else
        forward_occluding_2_choice_2 := (forward_occluding_1 mod 2) = 1;
      end if;
      if forward_path_3_value then
        forward_occluding_3_choice := (forward_dropped_3 mod 2) = 1;
      else
        forward_occluding_3_choice := (forward_stayed_3 mod 2) = 1;
      end if;
      if forward_path_3_any then
        forward_occluding_3_choice_2 := forward_occluding_3_choice;
      else
        forward_occluding_3_choice_2 := (forward_occluding_2 mod 2) = 1;
      end if;
      if forward_path_4_value then
        forward_occluding_4_choice := (forward_dropped_4 mod 2) = 1;
      else
        forward_occluding_4_choice := (forward_stayed_4 mod 2) = 1;
      end if;
      if forward_path_4_any then
        forward_occluding_4_choice_2 := forward_occluding_4_choice;
      else
        forward_occluding_4_choice_2 := (forward_occluding_3 mod 2) = 1;
      end if;
      if forward_path_5_value then
        forward_occluding_5_choice := (forward_dropped_5 mod 2) = 1;
      else
        forward_occluding_5_choice := (forward_stayed_5 mod 2) = 1;
      end if;
      if forward_path_5_any then
        forward_occluding_5_choice_2 := forward_occluding_5_choice;
      else
        forward_occluding_5_choice_2 := (forward_occluding_4 mod 2) = 1;
      end if;
      if forward_path_6_value then
        forward_occluding_6_choice := (forward_dropped_6 mod 2) = 1;
      else
        forward_occluding_6_choice := (forward_stayed_6 mod 2) = 1;
      end if;
      if forward_path_6_any then
        forward_occluding_6_choice_2 := forward_occluding_6_choice;
      else
        forward_occluding_6_choice_2 := (forward_occluding_5 mod 2) = 1;
      end if;
      if forward_path_7_value then
        forward_occluding_7_choice := (forward_dropped_7 mod 2) = 1;
      else
        forward_occluding_7_choice := (forward_stayed_7 mod 2) = 1;
      end if;
      if forward_path_7_any then
        forward_occluding_7_choice_2 := forward_occluding_7_choice;
      else
        forward_occluding_7_choice_2 := (forward_occluding_6 mod 2) = 1;
      end if;
      if forward_path_8_value then
        forward_occluding_8_choice := (forward_dropped_8 mod 2) = 1;
      else
        forward_occluding_8_choice := (forward_stayed_8 mod 2) = 1;
      end if;
      if forward_path_8_any then
        forward_occluding_8_choice_2 := forward_occluding_8_choice;
      else
        forward_occluding_8_choice_2 := (forward_occluding_7 mod 2) = 1;
      end if;
      if forward_path_9_value then
        forward_occluding_9_choice := (forward_dropped_9 mod 2) = 1;
      else
        forward_occluding_9_choice := (forward_stayed_9 mod 2) = 1;
      end if;
      if forward_path_9_any then
        forward_occluding_9_choice_2 := forward_occluding_9_choice;
      else
        forward_occluding_9_choice_2 := (forward_occluding_8 mod 2) = 1;
      end if;
      if forward_path_10_value then
        forward_occluding_10_choice := (forward_dropped_10 mod 2) = 1;
      else
        forward_occluding_10_choice := (forward_stayed_10 mod 2) = 1;
      end if;
      if forward_path_10_any then
        forward_occluding_10_choice_2 := forward_occluding_10_choice;
      else
        forward_occluding_10_choice_2 := (forward_occluding_9 mod 2) = 1;
      end if;
      forward_dropped_0_value := (((forward_path_2 - forward_path_1) mod 512) / 256) = 1;
      if forward_dropped_0_value then
        forward_dropped_0_choice := forward_path_2;
      else
        forward_dropped_0_choice := forward_path_1;
      end if;
      forward_dropped_1_value := (((forward_path_3 - forward_path_2) mod 512) / 256) = 1;
      if forward_dropped_1_value then
        forward_dropped_1_choice := forward_path_3;
      else
        forward_dropped_1_choice := forward_path_2;
      end if;
      forward_dropped_2_value := (((forward_path_4 - forward_path_3) mod 512) / 256) = 1;
      if forward_dropped_2_value then
        forward_dropped_2_choice := forward_path_4;
      else
        forward_dropped_2_choice := forward_path_3;
      end if;
      forward_dropped_3_value := (((forward_path_5 - forward_path_4) mod 512) / 256) = 1;
      if forward_dropped_3_value then
        forward_dropped_3_choice := forward_path_5;
      else
        forward_dropped_3_choice := forward_path_4;
      end if;
      forward_dropped_4_value := (((forward_path_6 - forward_path_5) mod 512) / 256) = 1;
      if forward_dropped_4_value then
        forward_dropped_4_choice := forward_path_6;
      else
        forward_dropped_4_choice := forward_path_5;
      end if;
      forward_dropped_5_value := (((forward_path_7 - forward_path_6) mod 512) / 256) = 1;
      if forward_dropped_5_value then
        forward_dropped_5_choice := forward_path_7;
      else
        forward_dropped_5_choice := forward_path_6;
      end if;
      forward_dropped_6_value := (((forward_path_8 - forward_path_7) mod 512) / 256) = 1;
      if forward_dropped_6_value then
        forward_dropped_6_choice := forward_path_8;
      else
        forward_dropped_6_choice := forward_path_7;
      end if;
      forward_dropped_7_value := (((forward_path_9 - forward_path_8) mod 512) / 256) = 1;
      if forward_dropped_7_value then
        forward_dropped_7_choice := forward_path_9;
      else
        forward_dropped_7_choice := forward_path_8;
      end if;
      forward_dropped_8_value := (((forward_path_10 - forward_path_9) mod 512) / 256) = 1;
      if forward_dropped_8_value then
        forward_dropped_8_choice := forward_path_10;
      else
        forward_dropped_8_choice := forward_path_9;
      end if;
      forward_dropped_9_value := (((forward_path_11 - forward_path_10) mod 512) / 256) = 1;
      if forward_dropped_9_value then
        forward_dropped_9_choice := forward_path_11;
      else
        forward_dropped_9_choice := forward_path_10;
      end if;
      if forward_far_0 then
        forward_decision_0_choice := 2;
      else
        forward_decision_0_choice := 1;
      end if;
      if forward_far_1 then
        forward_decision_1_choice := 2;
      else
        forward_decision_1_choice := 1;
      end if;
      if forward_path_1_value then
        forward_decision_1_choice_2 := forward_decision_1_choice;
      else
        forward_decision_1_choice_2 := 0;
      end if;
      if forward_far_2 then
        forward_decision_2_choice := 2;
      else
        forward_decision_2_choice := 1;
      end if;
      if forward_path_2_value then
        forward_decision_2_choice_2 := forward_decision_2_choice;
      else
        forward_decision_2_choice_2 := 0;
      end if;
      if forward_far_3 then
        forward_decision_3_choice := 2;
      else
        forward_decision_3_choice := 1;
      end if;
      if forward_path_3_value then
        forward_decision_3_choice_2 := forward_decision_3_choice;
      else
        forward_decision_3_choice_2 := 0;
      end if;
      if forward_far_4 then
        forward_decision_4_choice := 2;
      else
        forward_decision_4_choice := 1;
      end if;
      if forward_path_4_value then
        forward_decision_4_choice_2 := forward_decision_4_choice;
      else
        forward_decision_4_choice_2 := 0;
      end if;
      if forward_far_5 then
        forward_decision_5_choice := 2;
      else
        forward_decision_5_choice := 1;
      end if;
      if forward_path_5_value then
        forward_decision_5_choice_2 := forward_decision_5_choice;
      else
        forward_decision_5_choice_2 := 0;
      end if;
      if forward_far_6 then
        forward_decision_6_choice := 2;
      else
        forward_decision_6_choice := 1;
      end if;
      if forward_path_6_value then
        forward_decision_6_choice_2 := forward_decision_6_choice;
      else
        forward_decision_6_choice_2 := 0;
      end if;
      if forward_far_7 then
        forward_decision_7_choice := 2;
      else
        forward_decision_7_choice := 1;
      end if;
      if forward_path_7_value then
        forward_decision_7_choice_2 := forward_decision_7_choice;
      else
        forward_decision_7_choice_2 := 0;
      end if;
      if forward_far_8 then
        forward_decision_8_choice := 2;
      else
        forward_decision_8_choice := 1;
      end if;
      if forward_path_8_value then
        forward_decision_8_choice_2 := forward_decision_8_choice;
      else
        forward_decision_8_choice_2 := 0;
      end if;
      if forward_far_9 then
        forward_decision_9_choice := 2;
      else
        forward_decision_9_choice := 1;
      end if;
      if forward_path_9_value then
        forward_decision_9_choice_2 := forward_decision_9_choice;
      else
        forward_decision_9_choice_2 := 0;
      end if;
      if entry_tag_valid then
        forward_next_cost_0 <= entry_cost_0;
        forward_next_cost_1 <= entry_cost_1;
        forward_next_cost_2 <= entry_cost_2;
        forward_next_cost_3 <= entry_cost_3;
        forward_next_cost_4 <= entry_cost_4;
        forward_next_cost_5 <= entry_cost_5;
        forward_next_cost_6 <= entry_cost_6;
        forward_next_cost_7 <= entry_cost_7;
        forward_next_cost_8 <= entry_cost_8;
        forward_next_cost_9 <= entry_cost_9;
        forward_next_cost_10 <= entry_cost_10;
        forward_next_cost_11 <= entry_cost_11;
        forward_next_first <= entry_tag_first_column;
        forward_pair_cost_0 <= entry_cost_0 + forward_next_cost_0;
        forward_pair_cost_1 <= entry_cost_1 + forward_next_cost_1;
        forward_pair_cost_2 <= entry_cost_2 + forward_next_cost_2;
        forward_pair_cost_3 <= entry_cost_3 + forward_next_cost_3;
        forward_pair_cost_4 <= entry_cost_4 + forward_next_cost_4;
        forward_pair_cost_5 <= entry_cost_5 + forward_next_cost_5;
        forward_pair_cost_6 <= entry_cost_6 + forward_next_cost_6;
        forward_pair_cost_7 <= entry_cost_7 + forward_next_cost_7;
        forward_pair_cost_8 <= entry_cost_8 + forward_next_cost_8;
        forward_pair_cost_9 <= entry_cost_9 + forward_next_cost_9;
        forward_pair_cost_10 <= entry_cost_10 + forward_next_cost_10;
        forward_pair_cost_11 <= entry_cost_11 + forward_next_cost_11;
        forward_path_0 <= forward_path_0_choice_2;
        forward_path_1 <= forward_path_1_choice_3;
        forward_path_2 <= forward_path_2_choice_3;
        forward_path_3 <= forward_path_3_choice_3;
        forward_path_4 <= forward_path_4_choice_3;
        forward_path_5 <= forward_path_5_choice_3;
        forward_path_6 <= forward_path_6_choice_3;
        forward_path_7 <= forward_path_7_choice_3;
        forward_path_8 <= forward_path_8_choice_3;
        forward_path_9 <= forward_path_9_choice_3;
        forward_path_10 <= forward_path_10_choice_3;
        forward_path_11 <= forward_path_11_choice_3;
        forward_stayed_0 <= (forward_path_0_choice_2 + forward_next_cost_0) mod 512;
        forward_stayed_1 <= (forward_path_1_choice_3 + forward_next_cost_1) mod 512;
        forward_stayed_2 <= (forward_path_2_choice_3 + forward_next_cost_2) mod 512;
        forward_stayed_3 <= (forward_path_3_choice_3 + forward_next_cost_3) mod 512;
        forward_stayed_4 <= (forward_path_4_choice_3 + forward_next_cost_4) mod 512;
        forward_stayed_5 <= (forward_path_5_choice_3 + forward_next_cost_5) mod 512;
        forward_stayed_6 <= (forward_path_6_choice_3 + forward_next_cost_6) mod 512;
        forward_stayed_7 <= (forward_path_7_choice_3 + forward_next_cost_7) mod 512;
        forward_stayed_8 <= (forward_path_8_choice_3 + forward_next_cost_8) mod 512;
        forward_stayed_9 <= (forward_path_9_choice_3 + forward_next_cost_9) mod 512;
        forward_stayed_10 <= (forward_path_10_choice_3 + forward_next_cost_10) mod 512;
        forward_stayed_11 <= (forward_path_11_choice_3 + forward_next_cost_11) mod 512;
        forward_far_0 <= forward_dropped_0_value and (not forward_next_first);
        if forward_next_first then
          forward_occluding_0 <= 128;
          forward_occluding_1 <= 128;
          forward_occluding_2 <= 128;
          forward_occluding_3 <= 128;
          forward_occluding_4 <= 128;
          forward_occluding_5 <= 128;
          forward_occluding_6 <= 128;
          forward_occluding_7 <= 128;
          forward_occluding_8 <= 128;
          forward_occluding_9 <= 128;
          forward_occluding_10 <= 128;
          forward_dropped_0 <= 128;
          forward_dropped_1 <= 128;
          forward_dropped_2 <= 128;
          forward_dropped_3 <= 128;
          forward_dropped_4 <= 128;
          forward_dropped_5 <= 128;
          forward_dropped_6 <= 128;
          forward_dropped_7 <= 128;
          forward_dropped_8 <= 128;
          forward_dropped_9 <= 128;
          forward_dropped_10 <= 128;
          forward_dropped_11 <= 128;
        else
          forward_occluding_0 <= ((((forward_path_0_choice_2 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_0_choice));
          forward_occluding_1 <= ((((forward_path_1_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_1_choice_2));
          forward_occluding_2 <= ((((forward_path_2_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_2_choice_2));
          forward_occluding_3 <= ((((forward_path_3_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_3_choice_2));
          forward_occluding_4 <= ((((forward_path_4_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_4_choice_2));
          forward_occluding_5 <= ((((forward_path_5_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_5_choice_2));
          forward_occluding_6 <= ((((forward_path_6_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_6_choice_2));
          forward_occluding_7 <= ((((forward_path_7_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_7_choice_2));
          forward_occluding_8 <= ((((forward_path_8_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_8_choice_2));
          forward_occluding_9 <= ((((forward_path_9_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_9_choice_2));
          forward_occluding_10 <= ((((forward_path_10_choice_3 / 2) + 1) mod 256) * 2) + as_number(((not
            forward_next_first) and forward_occluding_10_choice_2));
          forward_dropped_0 <= (forward_pair_cost_0 + forward_dropped_0_choice) mod 512;
          forward_dropped_1 <= (forward_pair_cost_1 + forward_dropped_1_choice) mod 512;
          forward_dropped_2 <= (forward_pair_cost_2 + forward_dropped_2_choice) mod 512;
          forward_dropped_3 <= (forward_pair_cost_3 + forward_dropped_3_choice) mod 512;
          forward_dropped_4 <= (forward_pair_cost_4 + forward_dropped_4_choice) mod 512;
          forward_dropped_5 <= (forward_pair_cost_5 + forward_dropped_5_choice) mod 512;
          forward_dropped_6 <= (forward_pair_cost_6 + forward_dropped_6_choice) mod 512;
          forward_dropped_7 <= (forward_pair_cost_7 + forward_dropped_7_choice) mod 512;
          forward_dropped_8 <= (forward_pair_cost_8 + forward_dropped_8_choice) mod 512;
          forward_dropped_9 <= (forward_pair_cost_9 + forward_dropped_9_choice) mod 512;
          forward_dropped_10 <= (forward_pair_cost_10 + forward_path_11) mod 512;
          forward_dropped_11 <= (forward_pair_cost_11 + forward_path_11) mod 512;
        end if;
        if forward_path_0_value then
          forward_decision_0 <= forward_decision_0_choice;
        else
          forward_decision_0 <= 0;
        end if;
        if forward_path_1_any then
          forward_decision_1 <= forward_decision_1_choice_2;
        else
          forward_decision_1 <= 3;
        end if;
        if forward_path_2_any then
          forward_decision_2 <= forward_decision_2_choice_2;
        else
          forward_decision_2 <= 3;
        end if;
        if forward_path_3_any then
          forward_decision_3 <= forward_decision_3_choice_2;
        else
          forward_decision_3 <= 3;
        end if;
        if forward_path_4_any then
          forward_decision_4 <= forward_decision_4_choice_2;
        else
          forward_decision_4 <= 3;
        end if;
        if forward_path_5_any then
          forward_decision_5 <= forward_decision_5_choice_2;
        else
          forward_decision_5 <= 3;
        end if;
        if forward_path_6_any then
          forward_decision_6 <= forward_decision_6_choice_2;
        else
          forward_decision_6 <= 3;
        end if;
        if forward_path_7_any then
          forward_decision_7 <= forward_decision_7_choice_2;
        else
          forward_decision_7 <= 3;
        end if;
        if forward_path_8_any then
          forward_decision_8 <= forward_decision_8_choice_2;
        else
          forward_decision_8 <= 3;
        end if;
        if forward_path_9_any then
          forward_decision_9 <= forward_decision_9_choice_2;
        else
          forward_decision_9 <= 3;
        end if;
        if forward_path_10_any then
          forward_decision_10 <= as_number(forward_path_10_value);
        else
          forward_decision_10 <= 3;
        end if;
        if forward_path_11_any then
          forward_decision_11 <= as_number(forward_path_11_value);
        else
          forward_decision_11 <= 3;
        end if;
      end if;
      forward_far_1_any := (not entry_tag_valid) or (not forward_next_first);
      if forward_dropped_1_value then
        forward_far_1_choice := forward_far_1_any;
      else
        forward_far_1_choice := not entry_tag_valid;
      end if;
      if forward_dropped_2_value then
        forward_far_2_choice := forward_far_1_any;
      else
        forward_far_2_choice := not entry_tag_valid;
      end if;
      if forward_dropped_3_value then
        forward_far_3_choice := forward_far_1_any;
      else
        forward_far_3_choice := not entry_tag_valid;
      end if;
      if forward_dropped_4_value then
        forward_far_4_choice := forward_far_1_any;
      else
        forward_far_4_choice := not entry_tag_valid;
      end if;
      if forward_dropped_5_value then
        forward_far_5_choice := forward_far_1_any;
      else
        forward_far_5_choice := not entry_tag_valid;
      end if;
      if forward_dropped_6_value then
        forward_far_6_choice := forward_far_1_any;
      else
        forward_far_6_choice := not entry_tag_valid;
      end if;
      if forward_dropped_7_value then
        forward_far_7_choice := forward_far_1_any;
      else
        forward_far_7_choice := not entry_tag_valid;
      end if;
      if forward_dropped_8_value then
        forward_far_8_choice := forward_far_1_any;
      else
        forward_far_8_choice := not entry_tag_valid;
      end if;
      if forward_dropped_9_value then
        forward_far_9_choice := forward_far_1_any;
      else
        forward_far_9_choice := not entry_tag_valid;
      end if;
      if forward_far_1 then
        forward_far_1 <= forward_far_1_choice;
      else
        forward_far_1 <= forward_dropped_1_value and entry_tag_valid and (not forward_next_first);
      end if;
      if forward_far_2 then
        forward_far_2 <= forward_far_2_choice;
      else
        forward_far_2 <= forward_dropped_2_value and entry_tag_valid and (not forward_next_first);
      end if;
      if forward_far_3 then
        forward_far_3 <= forward_far_3_choice;
      else
        forward_far_3 <= forward_dropped_3_value and entry_tag_valid and (not forward_next_first);
      end if;
      if forward_far_4 then
        forward_far_4 <= forward_far_4_choice;
      else
        forward_far_4 <= forward_dropped_4_value and entry_tag_valid and (not forward_next_first);
      end if;
      if forward_far_5 then
        forward_far_5 <= forward_far_5_choice;
      else
        forward_far_5 <= forward_dropped_5_value and entry_tag_valid and (not forward_next_first);
      end if;
      if forward_far_6 then
        forward_far_6 <= forward_far_6_choice;
      else
        forward_far_6 <= forward_dropped_6_value and entry_tag_valid and (not forward_next_first);
      end if;
      if forward_far_7 then
        forward_far_7 <= forward_far_7_choice;
      else
        forward_far_7 <= forward_dropped_7_value and entry_tag_valid and (not forward_next_first);
      end if;
      if forward_far_8 then
        forward_far_8 <= forward_far_8_choice;
      else
        forward_far_8 <= forward_dropped_8_value and entry_tag_valid and (not forward_next_first);
      end if;
      if forward_far_9 then
        forward_far_9 <= forward_far_9_choice;
      else
        forward_far_9 <= forward_dropped_9_value and entry_tag_valid and (not forward_next_first);
      end if;
      -- decisions
      if entry_tag_valid then
        decisions_ready_decision_0 <= to_integer(decisions_read_words_0(1 downto 0));
        decisions_ready_decision_1 <= (to_integer(decisions_read_words_0(7 downto 0)) / 4) mod 4;
        decisions_ready_decision_2 <= (to_integer(decisions_read_words_0(7 downto 0)) / 16) mod 4;
        decisions_ready_decision_3 <= to_integer(decisions_read_words_0(7 downto 0)) / 64;
        decisions_ready_decision_4 <= to_integer(decisions_read_words_0(9 downto 8));
        decisions_ready_decision_5 <= to_integer(decisions_read_words_0(11 downto 10));
        decisions_ready_decision_6 <= to_integer(decisions_read_words_0(13 downto 12));
        decisions_ready_decision_7 <= to_integer(decisions_read_words_0(15 downto 14));
        decisions_ready_decision_8 <= to_integer(decisions_read_words_0(17 downto 16));
        decisions_ready_decision_9 <= to_integer(decisions_read_words_0(19 downto 18));
        decisions_ready_decision_10 <= to_integer(decisions_read_words_0(21 downto 20));
        decisions_ready_decision_11 <= to_integer(decisions_read_words_0(23 downto 22));
        decisions_ready_inside <= entry_tag_map_column;
        decisions_comes_0 <= entry_tag_map_column;
        decisions_comes_1 <= decisions_ready_inside;
        decisions_comes_2 <= last_tags_held_1_map_column;
        decisions_place_0 <= entry_place;
        decisions_place_1 <= decisions_place_0;
        decisions_place_2 <= decisions_place_1;
      end if;
      decisions_write_words_0_all := decisions_comes_2 and entry_tag_valid;
      if decisions_write_words_0_all then
        decisions_write_words_0 <= (forward_decision_10 * 1048576) + (forward_decision_11 * 4194304) +
          (forward_decision_9 * 262144) + (forward_decision_8 * 65536) + (forward_decision_7 * 16384) +
          (forward_decision_6 * 4096) + (forward_decision_5 * 1024) + (forward_decision_4 * 256) + (forward_decision_3
          * 64) + (forward_decision_2 * 16) + forward_decision_0 + (forward_decision_1 * 4);
        decisions_write_place <= decisions_place_2;
      end if;
      -- last
      if entry_tag_valid then
        last_tags_held_0_end_of_line <= entry_tag_end_of_line;
        last_tags_held_1_map_column <= decisions_comes_0;
        last_tags_held_1_end_of_line <= last_tags_held_0_end_of_line;
        last_tags_held_2_map_column <= decisions_comes_1;
        last_tags_held_2_end_of_line <= last_tags_held_1_end_of_line;
      end if;
      last_path_0_2_difference := 256 - forward_path_0;
      last_tags_moved <= entry_tag_valid;
      last_path_0_0 <= 256;
      last_path_0_1 <= ((((((forward_path_1 / 256) + 1) mod 2) * 256) + (forward_path_1 mod 256)) - forward_path_0) mod
        512;
      last_path_0_2 <= (last_path_0_2_difference + forward_path_2) mod 512;
      last_path_0_3 <= (last_path_0_2_difference + forward_path_3) mod 512;
      last_path_0_4 <= (last_path_0_2_difference + forward_path_4) mod 512;
      last_path_0_5 <= (last_path_0_2_difference + forward_path_5) mod 512;
      last_path_0_6 <= (last_path_0_2_difference + forward_path_6) mod 512;
      last_path_0_7 <= (last_path_0_2_difference + forward_path_7) mod 512;
      last_path_0_8 <= (last_path_0_2_difference + forward_path_8) mod 512;
      last_path_0_9 <= (last_path_0_2_difference + forward_path_9) mod 512;
      last_path_0_10 <= (last_path_0_2_difference + forward_path_10) mod 512;
      last_path_0_11 <= (last_path_0_2_difference + forward_path_11) mod 512;
      last_tag_valid <= last_tags_moved;
      last_tag_map_column <= last_tags_held_2_map_column;
      last_tag_end_of_line <= last_tags_held_2_end_of_line;
      if not ((not lastwinner4_tag_end_of_line) or (not lastwinner4_tag_map_column) or (not lastwinner4_tag_valid)) then
        last_state <= lastwinner4_best_index_0_0;
      end if;
      -- lastwinner1
      lastwinner1_best_cost_0_0_is_less := (last_path_0_1 - last_path_0_0) < 0;
      lastwinner1_best_cost_0_1_is_less := (last_path_0_3 - last_path_0_2) < 0;
      lastwinner1_best_cost_0_2_is_less := (last_path_0_5 - last_path_0_4) < 0;
      lastwinner1_best_cost_0_3_is_less := (last_path_0_7 - last_path_0_6) < 0;
      lastwinner1_best_cost_0_4_is_less := (last_path_0_9 - last_path_0_8) < 0;
      lastwinner1_best_cost_0_5_is_less := (last_path_0_11 - last_path_0_10) < 0;
      lastwinner1_best_index_0_0 <= lastwinner1_best_cost_0_0_is_less;
      lastwinner1_tag_valid <= last_tag_valid;
      lastwinner1_tag_map_column <= last_tag_map_column;
      lastwinner1_tag_end_of_line <= last_tag_end_of_line;
      if lastwinner1_best_cost_0_0_is_less then
        lastwinner1_best_cost_0_0 <= last_path_0_1;
      else
        lastwinner1_best_cost_0_0 <= last_path_0_0;
      end if;
      if lastwinner1_best_cost_0_1_is_less then
        lastwinner1_best_cost_0_1 <= last_path_0_3;
        lastwinner1_best_index_0_1 <= 3;
      else
        lastwinner1_best_cost_0_1 <= last_path_0_2;
        lastwinner1_best_index_0_1 <= 2;
      end if;
      if lastwinner1_best_cost_0_2_is_less then
        lastwinner1_best_cost_0_2 <= last_path_0_5;
        lastwinner1_best_index_0_2 <= 5;
      else
        lastwinner1_best_cost_0_2 <= last_path_0_4;
        lastwinner1_best_index_0_2 <= 4;
      end if;
      if lastwinner1_best_cost_0_3_is_less then
        lastwinner1_best_cost_0_3 <= last_path_0_7;
        lastwinner1_best_index_0_3 <= 7;
      else
        lastwinner1_best_cost_0_3 <= last_path_0_6;
        lastwinner1_best_index_0_3 <= 6;
      end if;
      if lastwinner1_best_cost_0_4_is_less then
        lastwinner1_best_cost_0_4 <= last_path_0_9;
        lastwinner1_best_index_0_4 <= 9;
      else
        lastwinner1_best_cost_0_4 <= last_path_0_8;
        lastwinner1_best_index_0_4 <= 8;
      end if;
      if lastwinner1_best_cost_0_5_is_less then
        lastwinner1_best_cost_0_5 <= last_path_0_11;
        lastwinner1_best_index_0_5 <= 11;
      else
        lastwinner1_best_cost_0_5 <= last_path_0_10;
        lastwinner1_best_index_0_5 <= 10;
      end if;
      -- lastwinner2
      lastwinner2_best_cost_0_0_is_less := (lastwinner1_best_cost_0_1 - lastwinner1_best_cost_0_0) < 0;
      lastwinner2_best_cost_0_1_is_less := (lastwinner1_best_cost_0_3 - lastwinner1_best_cost_0_2) < 0;
      lastwinner2_best_cost_0_2_is_less := (lastwinner1_best_cost_0_5 - lastwinner1_best_cost_0_4) < 0;
      lastwinner2_tag_valid <= lastwinner1_tag_valid;
      lastwinner2_tag_map_column <= lastwinner1_tag_map_column;
      lastwinner2_tag_end_of_line <= lastwinner1_tag_end_of_line;
      if lastwinner2_best_cost_0_0_is_less then
        lastwinner2_best_cost_0_0 <= lastwinner1_best_cost_0_1;
        lastwinner2_best_index_0_0 <= lastwinner1_best_index_0_1;
      else
        lastwinner2_best_cost_0_0 <= lastwinner1_best_cost_0_0;
        lastwinner2_best_index_0_0 <= as_number(lastwinner1_best_index_0_0);
      end if;
      if lastwinner2_best_cost_0_1_is_less then
        lastwinner2_best_cost_0_1 <= lastwinner1_best_cost_0_3;
        lastwinner2_best_index_0_1 <= lastwinner1_best_index_0_3;
      else
        lastwinner2_best_cost_0_1 <= lastwinner1_best_cost_0_2;
        lastwinner2_best_index_0_1 <= lastwinner1_best_index_0_2;
      end if;
      if lastwinner2_best_cost_0_2_is_less then
        lastwinner2_best_cost_0_2 <= lastwinner1_best_cost_0_5;
        lastwinner2_best_index_0_2 <= lastwinner1_best_index_0_5;
      else
        lastwinner2_best_cost_0_2 <= lastwinner1_best_cost_0_4;
        lastwinner2_best_index_0_2 <= lastwinner1_best_index_0_4;
      end if;
      -- lastwinner3
      lastwinner3_best_cost_0_0_is_less := (lastwinner2_best_cost_0_1 - lastwinner2_best_cost_0_0) < 0;
      lastwinner3_best_cost_0_1 <= lastwinner2_best_cost_0_2;
      lastwinner3_best_index_0_1 <= lastwinner2_best_index_0_2;
      lastwinner3_tag_valid <= lastwinner2_tag_valid;
      lastwinner3_tag_map_column <= lastwinner2_tag_map_column;
      lastwinner3_tag_end_of_line <= lastwinner2_tag_end_of_line;
      if lastwinner3_best_cost_0_0_is_less then
        lastwinner3_best_cost_0_0 <= lastwinner2_best_cost_0_1;
        lastwinner3_best_index_0_0 <= lastwinner2_best_index_0_1;
      else
        lastwinner3_best_cost_0_0 <= lastwinner2_best_cost_0_0;
        lastwinner3_best_index_0_0 <= lastwinner2_best_index_0_0;
      end if;
      -- lastwinner4
      lastwinner4_tag_valid <= lastwinner3_tag_valid;
      lastwinner4_tag_map_column <= lastwinner3_tag_map_column;
      lastwinner4_tag_end_of_line <= lastwinner3_tag_end_of_line;
      if (lastwinner3_best_cost_0_1 - lastwinner3_best_cost_0_0) < 0 then
        lastwinner4_best_index_0_0 <= lastwinner3_best_index_0_1;
      else
        lastwinner4_best_index_0_0 <= lastwinner3_best_index_0_0;
      end if;
      -- traceback
      traceback_state_is_equal := traceback_falling = 1;
      traceback_state_sum := traceback_state + 1;
      traceback_state_is_equal_2 := traceback_falling = 2;
      traceback_state_sum_2 := (traceback_state / 2) + 1;
      traceback_state_is_equal_3 := traceback_falling = 0;
      traceback_state_all := (traceback_decision = 3) and traceback_state_is_equal_3;
      traceback_state_sum_3 := traceback_state + 255;
      if traceback_state_all then
        traceback_state_choice := traceback_state_sum_3 mod 256;
      else
        traceback_state_choice := traceback_state;
      end if;
      if traceback_state_is_equal_2 then
        traceback_state_choice_2 := ((traceback_state_sum_2 mod 128) * 2) + (traceback_state mod 2);
      else
        traceback_state_choice_2 := traceback_state_choice;
      end if;
      if traceback_state_is_equal then
        traceback_state_choice_3 := traceback_state_sum mod 256;
      else
        traceback_state_choice_3 := traceback_state_choice_2;
      end if;
      traceback_decision_value := (((traceback_state_sum mod 256) / 2) mod 2) = 1;
      if (traceback_state_sum mod 2) = 1 then
        traceback_decision_choice := decisions_ready_decision_11;
      else
        traceback_decision_choice := decisions_ready_decision_10;
      end if;
      if (traceback_state_sum mod 2) = 1 then
        traceback_decision_choice_2 := decisions_ready_decision_9;
      else
        traceback_decision_choice_2 := decisions_ready_decision_8;
      end if;
      if traceback_decision_value then
        traceback_decision_choice_3 := traceback_decision_choice;
      else
        traceback_decision_choice_3 := traceback_decision_choice_2;
      end if;
      if (traceback_state_sum mod 2) = 1 then
        traceback_decision_choice_4 := decisions_ready_decision_7;
      else
        traceback_decision_choice_4 := decisions_ready_decision_6;
      end if;
      if (traceback_state_sum mod 2) = 1 then
        traceback_decision_choice_5 := decisions_ready_decision_5;
      else
        traceback_decision_choice_5 := decisions_ready_decision_4;
      end if;
      if traceback_decision_value then
        traceback_decision_choice_6 := traceback_decision_choice_4;
      else
        traceback_decision_choice_6 := traceback_decision_choice_5;
      end if;
      if (traceback_state_sum mod 2) = 1 then
        traceback_decision_choice_7 := decisions_ready_decision_3;
      else
        traceback_decision_choice_7 := decisions_ready_decision_2;
      end if;
      if (traceback_state_sum mod 2) = 1 then
        traceback_decision_choice_8 := decisions_ready_decision_1;
      else
        traceback_decision_choice_8 := decisions_ready_decision_0;
      end if;
      if traceback_decision_value then
        traceback_decision_choice_9 := traceback_decision_choice_7;
      else
        traceback_decision_choice_9 := traceback_decision_choice_8;
      end if;
      if (((traceback_state_sum mod 256) / 4) mod 2) = 1 then
        traceback_decision_choice_10 := traceback_decision_choice_6;
      else
        traceback_decision_choice_10 := traceback_decision_choice_9;
      end if;
      if (((traceback_state_sum mod 256) / 8) mod 2) = 1 then
        traceback_decision_choice_11 := traceback_decision_choice_3;
      else
        traceback_decision_choice_11 := traceback_decision_choice_10;
      end if;
      if (traceback_state mod 2) = 1 then
        traceback_decision_choice_12 := decisions_ready_decision_11;
      else
        traceback_decision_choice_12 := decisions_ready_decision_10;
      end if;
      if (traceback_state mod 2) = 1 then
        traceback_decision_choice_13 := decisions_ready_decision_9;
      else
        traceback_decision_choice_13 := decisions_ready_decision_8;
      end if;
      if (traceback_state_sum_2 mod 2) = 1 then
        traceback_decision_choice_14 := traceback_decision_choice_12;
      else
        traceback_decision_choice_14 := traceback_decision_choice_13;
      end if;
      if (traceback_state mod 2) = 1 then
        traceback_decision_choice_15 := decisions_ready_decision_7;
      else
        traceback_decision_choice_15 := decisions_ready_decision_6;
      end if;
      if (traceback_state mod 2) = 1 then
        traceback_decision_choice_16 := decisions_ready_decision_5;
      else
        traceback_decision_choice_16 := decisions_ready_decision_4;
      end if;
      if (traceback_state_sum_2 mod 2) = 1 then
        traceback_decision_choice_17 := traceback_decision_choice_15;
      else
        traceback_decision_choice_17 := traceback_decision_choice_16;
      end if;
      if (traceback_state mod 2) = 1 then
        traceback_decision_choice_18 := decisions_ready_decision_3;
      else
        traceback_decision_choice_18 := decisions_ready_decision_2;
      end if;
      if (traceback_state mod 2) = 1 then
        traceback_decision_choice_19 := decisions_ready_decision_1;
      else
        traceback_decision_choice_19 := decisions_ready_decision_0;
      end if;
      if (traceback_state_sum_2 mod 2) = 1 then
        traceback_decision_choice_20 := traceback_decision_choice_18;
      else
        traceback_decision_choice_20 := traceback_decision_choice_19;
      end if;
      if (((traceback_state_sum_2 mod 128) / 2) mod 2) = 1 then
        traceback_decision_choice_21 := traceback_decision_choice_17;
      else
        traceback_decision_choice_21 := traceback_decision_choice_20;
      end if;
      if (((traceback_state_sum_2 mod 128) / 4) mod 2) = 1 then
        traceback_decision_choice_22 := traceback_decision_choice_14;
      else
        traceback_decision_choice_22 := traceback_decision_choice_21;
      end if;
      traceback_decision_value_2 := (((traceback_state_sum_3 mod 256) / 2) mod 2) = 1;
      if (traceback_state_sum_3 mod 2) = 1 then
        traceback_decision_choice_23 := decisions_ready_decision_11;
      else
        traceback_decision_choice_23 := decisions_ready_decision_10;
      end if;
      if (traceback_state_sum_3 mod 2) = 1 then
        traceback_decision_choice_24 := decisions_ready_decision_9;
      else
        traceback_decision_choice_24 := decisions_ready_decision_8;
      end if;
      if traceback_decision_value_2 then
        traceback_decision_choice_25 := traceback_decision_choice_23;
      else
        traceback_decision_choice_25 := traceback_decision_choice_24;
      end if;
      if (traceback_state_sum_3 mod 2) = 1 then
        traceback_decision_choice_26 := decisions_ready_decision_7;
      else
        traceback_decision_choice_26 := decisions_ready_decision_6;
      end if;
      if (traceback_state_sum_3 mod 2) = 1 then
        traceback_decision_choice_27 := decisions_ready_decision_5;
      else
        traceback_decision_choice_27 := decisions_ready_decision_4;
      end if;
      if traceback_decision_value_2 then
        traceback_decision_choice_28 := traceback_decision_choice_26;
      else
        traceback_decision_choice_28 := traceback_decision_choice_27;
      end if;
      if (traceback_state_sum_3 mod 2) = 1 then
        traceback_decision_choice_29 := decisions_ready_decision_3;
      else
        traceback_decision_choice_29 := decisions_ready_decision_2;
      end if;
      if (traceback_state_sum_3 mod 2) = 1 then
        traceback_decision_choice_30 := decisions_ready_decision_1;
      else
        traceback_decision_choice_30 := decisions_ready_decision_0;
      end if;
      if traceback_decision_value_2 then
        traceback_decision_choice_31 := traceback_decision_choice_29;
      else
        traceback_decision_choice_31 := traceback_decision_choice_30;
      end if;
      if (((traceback_state_sum_3 mod 256) / 4) mod 2) = 1 then
        traceback_decision_choice_32 := traceback_decision_choice_28;
      else
        traceback_decision_choice_32 := traceback_decision_choice_31;
      end if;
      if (((traceback_state_sum_3 mod 256) / 8) mod 2) = 1 then
        traceback_decision_choice_33 := traceback_decision_choice_25;
      else
        traceback_decision_choice_33 := traceback_decision_choice_32;
      end if;
      traceback_decision_value_3 := ((traceback_state / 2) mod 2) = 1;
      if traceback_decision_value_3 then
        traceback_decision_choice_34 := traceback_decision_choice_12;
      else
        traceback_decision_choice_34 := traceback_decision_choice_13;
      end if;
      if traceback_decision_value_3 then
        traceback_decision_choice_35 := traceback_decision_choice_15;
      else
        traceback_decision_choice_35 := traceback_decision_choice_16;
      end if;
      if traceback_decision_value_3 then
        traceback_decision_choice_36 := traceback_decision_choice_18;
      else
        traceback_decision_choice_36 := traceback_decision_choice_19;
      end if;
      if ((traceback_state / 4) mod 2) = 1 then
        traceback_decision_choice_37 := traceback_decision_choice_35;
      else
        traceback_decision_choice_37 := traceback_decision_choice_36;
      end if;
      if ((traceback_state / 8) mod 2) = 1 then
        traceback_decision_choice_38 := traceback_decision_choice_34;
      else
        traceback_decision_choice_38 := traceback_decision_choice_37;
      end if;
      if traceback_state_all then
        traceback_decision_choice_39 := traceback_decision_choice_33;
      else
        traceback_decision_choice_39 := traceback_decision_choice_38;
      end if;
      if traceback_state_is_equal_2 then
        traceback_decision_choice_40 := traceback_decision_choice_22;
      else
        traceback_decision_choice_40 := traceback_decision_choice_39;
      end if;
      if traceback_state_is_equal then
        traceback_decision_choice_41 := traceback_decision_choice_11;
      else
        traceback_decision_choice_41 := traceback_decision_choice_40;
      end if;
      if entry_tag_valid then
        traceback_tags_held_0_output_column <= entry_turned_output_column;
        traceback_tags_held_0_start_of_frame <= entry_turned_start_of_frame;
        traceback_tags_held_1_output_column <= traceback_tags_held_0_output_column;
        traceback_tags_held_1_start_of_frame <= traceback_tags_held_0_start_of_frame;
        if decisions_comes_0 then
          traceback_state <= traceback_state_choice_3;
          traceback_decision <= traceback_decision_choice_41;
        else
          traceback_state <= last_state;
          traceback_decision <= 0;
        end if;
        if ((((traceback_decision + 255) mod 256) / 2) = 0) and decisions_comes_0 and traceback_state_is_equal_3 then
          traceback_falling <= traceback_decision;
        else
          traceback_falling <= 0;
        end if;
      end if;
      traceback_out_disparity_0 <= traceback_state;
      traceback_out_passed_0 <= ((traceback_falling / 2) = 1) or ((traceback_falling mod 2) = 1) or (not
        ((traceback_decision / 2) = 1)) or (not ((traceback_decision mod 2) = 1));
      traceback_out_tag_map_column <= decisions_comes_1;
      traceback_out_tag_output_column <= traceback_tags_held_1_output_column;
      traceback_out_tag_start_of_frame <= traceback_tags_held_1_start_of_frame;
      traceback_out_tag_end_of_line <= last_tags_held_1_end_of_line;
      -- turn
      turn_order_address_any := turn_order_inside or (not traceback_out_tag_map_column) or (not last_tag_valid);
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
      turn_order_address_any_2 := (not traceback_out_tag_map_column) or (not last_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 32;
        else
          turn_order_address <= turn_order_address_choice_2 * 4;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and traceback_out_tag_map_column and last_tag_valid;
      turn_order_complete_all := traceback_out_tag_map_column and last_tag_valid;
      if turn_order_falls_all then
        turn_order_turned_output_column_choice := turn_order_output and turn_order_complete;
      else
        turn_order_turned_output_column_choice := turn_order_held_output;
      end if;
      turn_order_turned_map_column <= traceback_out_tag_map_column;
      turn_order_turned_output_column <= turn_order_turned_output_column_choice and traceback_out_tag_map_column;
      turn_order_turned_first_column <= turn_order_falls_all;
      turn_newest <= (as_number(traceback_out_passed_0) * 256) + traceback_out_disparity_0;
      turn_comes <= turn_order_complete_all;
      turn_read_tag_map_column <= turn_order_turned_map_column;
      turn_read_tag_output_column <= turn_order_turned_output_column;
      turn_read_tag_first_column <= turn_order_turned_first_column;
      turn_ready <= to_integer(turn_read_words_0);
      turn_ready_tag_map_column <= turn_read_tag_map_column;
      turn_ready_tag_output_column <= turn_read_tag_output_column;
      turn_ready_tag_first_column <= turn_read_tag_first_column;
      if turn_order_falls then
        turn_order_falls <= turn_order_address_any;
      else
        turn_order_falls <= turn_order_falls_all;
      end if;
      if traceback_out_tag_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if last_tag_valid then
        turn_order_inside <= traceback_out_tag_map_column;
      end if;
      if turn_order_falls_all then
        turn_order_output <= traceback_out_tag_output_column;
        turn_order_first <= traceback_out_tag_start_of_frame;
        turn_order_held_output <= turn_order_output and turn_order_complete;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
        turn_write_place <= turn_order_address;
      end if;
      -- fill
      if turn_ready_tag_first_column then
        fill_out_disparity_0_choice := 0;
      else
        fill_out_disparity_0_choice := fill_out_disparity_0;
      end if;
      if turn_ready_tag_map_column and lastwinner3_tag_valid then
        if (turn_ready / 256) = 1 then
          fill_out_disparity_0 <= turn_ready mod 256;
        else
          fill_out_disparity_0 <= fill_out_disparity_0_choice;
        end if;
      end if;
      fill_out_passed_0 <= (turn_ready / 256) = 1;
      fill_out_tag_output_column <= turn_ready_tag_output_column;
      -- other
      other_0 <= other_3;
      other_1 <= other_0;
      other_2 <= (as_number(traceback_out_tag_end_of_line) * 256) + as_number(((not turn_order_inside) and
        traceback_out_tag_map_column and last_tag_valid and turn_order_first and turn_order_output and
        turn_order_complete));
      other_3 <= other_2;
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
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_tag_valid <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
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
        slice0_tag_1_start_of_frame <= false;
        slice0_tag_1_end_of_line <= false;
        slice0_tag_2_valid <= false;
        slice0_tag_2_map_column <= false;
        slice0_tag_2_output_column <= false;
        slice0_tag_2_start_of_frame <= false;
        slice0_tag_2_end_of_line <= false;
        entry_next_tag_valid <= false;
        entry_next_tag_map_column <= false;
        entry_next_tag_end_of_line <= false;
        entry_next_top <= false;
        entry_order_address <= 0;
        entry_order_falls <= false;
        entry_order_inside <= false;
        entry_order_complete <= false;
        entry_order_output <= false;
        entry_order_held_output <= false;
        entry_order_turned_output_column <= false;
        entry_order_turned_start_of_frame <= false;
        entry_tag_valid <= false;
        entry_tag_map_column <= false;
        entry_tag_end_of_line <= false;
        entry_place <= 0;
        entry_turned_output_column <= false;
        entry_turned_start_of_frame <= false;
        decisions_ready_inside <= false;
        decisions_comes_0 <= false;
        decisions_comes_1 <= false;
        decisions_comes_2 <= false;
        decisions_place_0 <= 0;
        decisions_place_1 <= 0;
        decisions_place_2 <= 0;
        decisions_write_place <= 0;
        last_tags_held_0_end_of_line <= false;
        last_tags_held_1_map_column <= false;
        last_tags_held_1_end_of_line <= false;
        last_tags_held_2_map_column <= false;
        last_tags_held_2_end_of_line <= false;
        last_tags_moved <= false;
        last_tag_valid <= false;
        last_tag_map_column <= false;
        last_tag_end_of_line <= false;
        lastwinner1_tag_valid <= false;
        lastwinner1_tag_map_column <= false;
        lastwinner1_tag_end_of_line <= false;
        lastwinner2_tag_valid <= false;
        lastwinner2_tag_map_column <= false;
        lastwinner2_tag_end_of_line <= false;
        lastwinner3_tag_valid <= false;
        lastwinner3_tag_map_column <= false;
        lastwinner3_tag_end_of_line <= false;
        lastwinner4_tag_valid <= false;
        lastwinner4_tag_map_column <= false;
        lastwinner4_tag_end_of_line <= false;
        traceback_tags_held_0_output_column <= false;
        traceback_tags_held_0_start_of_frame <= false;
        traceback_tags_held_1_output_column <= false;
        traceback_tags_held_1_start_of_frame <= false;
        traceback_out_tag_map_column <= false;
        traceback_out_tag_output_column <= false;
        traceback_out_tag_start_of_frame <= false;
        traceback_out_tag_end_of_line <= false;
        turn_order_address <= 0;
        turn_order_falls <= false;
        turn_order_inside <= false;
        turn_order_complete <= false;
        turn_order_output <= false;
        turn_order_first <= false;
        turn_order_held_output <= false;
        turn_order_turned_map_column <= false;
        turn_order_turned_output_column <= false;
        turn_comes <= false;
        turn_read_tag_map_column <= false;
        turn_read_tag_output_column <= false;
        turn_write_place <= 0;
        turn_ready_tag_map_column <= false;
        turn_ready_tag_output_column <= false;
        fill_out_tag_output_column <= false;
        other_0 <= 0;
        other_1 <= 0;
        other_2 <= 0;
        other_3 <= 0;
      end if;
    end if;
  end process;
end architecture;
