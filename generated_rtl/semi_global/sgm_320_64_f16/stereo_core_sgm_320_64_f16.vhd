-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_320_64_f16: 320x240, 64 disparities, window 3x3, P1 7, P2 60, 1 pixel pair a clock.
-- Options: reference left, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap 5, p1 7, p2 60,
--   above_p1 5, above_p2 31, median true, slice_disparities 16, clocks_per_pixel 16, front_clocks 2.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_320_64_f16
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_320_64_f16 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 240;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 257;
    latency_clocks : positive := 75;
    flush_groups : positive := 1926;
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
  assert width_px = 320 report "stereo_core_sgm_320_64_f16: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 240 report "stereo_core_sgm_320_64_f16: height_px is " & integer'image(height_px) & " but this core has 240" severity failure;
  assert disparities = 64 report "stereo_core_sgm_320_64_f16: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_320_64_f16: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_sgm_320_64_f16: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 257 report "stereo_core_sgm_320_64_f16: output_width_px is " & integer'image(output_width_px) & " but this core has 257" severity failure;
  assert latency_clocks = 75 report "stereo_core_sgm_320_64_f16: latency_clocks is " & integer'image(latency_clocks) & " but this core has 75" severity failure;
  assert flush_groups = 1926 report "stereo_core_sgm_320_64_f16: flush_groups is " & integer'image(flush_groups) & " but this core has 1926" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_320_64_f16: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_320_64_f16 is
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

  -- whether the bit of this place is 1
  function is_set(value : natural; place : natural) return boolean is
  begin
    return (value / 2 ** place) mod 2 = 1;
  end function;

  type boolean_1d is array (natural range <>) of boolean;
  type boolean_2d is array (natural range <>, natural range <>) of boolean;
  type natural_105_1d is array (natural range <>) of natural range 0 to 105;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_14_1d is array (natural range <>) of natural range 0 to 14;
  type natural_14_2d is array (natural range <>, natural range <>) of natural range 0 to 14;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16383_2d is array (natural range <>, natural range <>) of natural range 0 to 16383;
  type natural_169_1d is array (natural range <>) of natural range 0 to 169;
  type natural_21_1d is array (natural range <>) of natural range 0 to 21;
  type natural_254_1d is array (natural range <>) of natural range 0 to 254;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_28_1d is array (natural range <>) of natural range 0 to 28;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_52_1d is array (natural range <>) of natural range 0 to 52;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_68_1d is array (natural range <>) of natural range 0 to 68;
  type natural_7_1d is array (natural range <>) of natural range 0 to 7;
  type natural_8191_1d is array (natural range <>) of natural range 0 to 8191;
  type unsigned_12_1d is array (natural range <>) of unsigned(11 downto 0);
  type unsigned_16_1d is array (natural range <>) of unsigned(15 downto 0);
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_49_1d is array (natural range <>) of unsigned(48 downto 0);
  type unsigned_4_1d is array (natural range <>) of unsigned(3 downto 0);
  signal in_start_of_frame, in_valid : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_counter_group : natural range 0 to 255;
  signal transform_counter_group_after, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0, transform_left_column_0, transform_left_column_2 : natural range 0 to 255;
  signal transform_left_column_4, transform_right_column_0, transform_right_column_2 : natural range 0 to 255;
  signal transform_right_column_4 : natural range 0 to 255;
  signal transform_left_filter_column_0 : natural_255_1d(0 to 8);  -- transform_left_filter_column_#_0
  signal transform_left_filter_column_2 : natural_255_1d(0 to 8);  -- transform_left_filter_column_#_2
  signal transform_left_filter_column_4 : natural_255_1d(0 to 8);  -- transform_left_filter_column_#_4
  signal transform_right_filter_column_0 : natural_255_1d(0 to 8);  -- transform_right_filter_column_#_0
  signal transform_right_filter_column_2 : natural_255_1d(0 to 8);  -- transform_right_filter_column_#_2
  signal transform_right_filter_column_4 : natural_255_1d(0 to 8);  -- transform_right_filter_column_#_4
  signal transform_valid, transform_counter_next_frame, transform_counter_last_column : boolean;
  signal transform_counter_counts, transform_counter_frame_joins, transform_counter_back_to_back : boolean;
  signal transform_counter_next_frame_after, transform_read_row_inside_0, transform_read_column_inside_0 : boolean;
  signal transform_read_column_inside_2, transform_read_column_inside_4, transform_read_column_inside_6 : boolean;
  signal transform_read_column_inside_8, transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside_0, transform_ready_row_inside_2, transform_ready_row_inside_4 : boolean;
  signal transform_ready_column_inside_0, transform_ready_column_inside_2, transform_ready_column_inside_4 : boolean;
  signal transform_ready_column_inside_6, transform_ready_column_inside_8, transform_ready_start_of_frame : boolean;
  signal transform_ready_valid, transform_reached_first_0, transform_reached_first_2 : boolean;
  signal transform_reached_first_4 : boolean;
  signal transform_reached_beyond_last : boolean_1d(2 to 3);
  signal transform_columns_row_inside_0, transform_columns_row_inside_2, transform_columns_row_inside_4 : boolean;
  signal transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_column_inside_4, transform_columns_column_inside_6 : boolean;
  signal transform_columns_column_inside_8, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_left_filter_low_is_larger_0_0_0, transform_left_filter_low_is_larger_0_0_2 : boolean;
  signal transform_left_filter_low_is_larger_0_0_4, transform_left_filter_low_is_larger_0_2_0 : boolean;
  signal transform_left_filter_low_is_larger_0_2_2, transform_left_filter_low_is_larger_0_2_4 : boolean;
  signal transform_left_filter_low_is_larger_0_4_0, transform_left_filter_low_is_larger_0_4_4 : boolean;
  signal transform_left_filter_low_is_larger_0_6_0, transform_left_filter_low_is_larger_0_6_2 : boolean;
  signal transform_left_filter_low_is_larger_0_6_4, transform_left_filter_low_is_larger_0_8_0 : boolean;
  signal transform_left_filter_low_is_larger_0_8_2, transform_left_filter_low_is_larger_0_8_4 : boolean;
  signal transform_right_filter_low_is_larger_0_0_0, transform_right_filter_low_is_larger_0_0_2 : boolean;
  signal transform_right_filter_low_is_larger_0_0_4, transform_right_filter_low_is_larger_0_2_0 : boolean;
  signal transform_right_filter_low_is_larger_0_2_2, transform_right_filter_low_is_larger_0_2_4 : boolean;
  signal transform_right_filter_low_is_larger_0_4_0, transform_right_filter_low_is_larger_0_4_4 : boolean;
  signal transform_right_filter_low_is_larger_0_6_0, transform_right_filter_low_is_larger_0_6_2 : boolean;
  signal transform_right_filter_low_is_larger_0_6_4, transform_right_filter_low_is_larger_0_8_0 : boolean;
  signal transform_right_filter_low_is_larger_0_8_2, transform_right_filter_low_is_larger_0_8_4 : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_0_column_inside_4, transform_filtering_0_column_inside_6 : boolean;
  signal transform_filtering_0_column_inside_8 : boolean;
  signal transform_filtering_start_of_frame : boolean_1d(0 to 2);  -- transform_filtering_#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 2);  -- transform_filtering_#_valid
  signal transform_counter_column, transform_counter_column_after, transform_read_column : natural range 0 to 511;
  signal transform_ready_column, transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame, raster_place_last_column, raster_place_counts : boolean;
  signal raster_place_frame_joins, raster_place_back_to_back : boolean;
  signal raster_place_column, raster_place_column_after : natural range 0 to 511;
  signal raster_place_group, raster_place_group_after : natural range 0 to 255;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16383;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag_valid, delay_tag_border_column, delay_tag_first_cost, delay_tag_map_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_search : natural_16383_1d(0 to 2);
  signal rows_reference : natural_16383_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag_valid, rows_read_tag_border_column, rows_read_tag_first_cost, rows_read_tag_map_column : boolean;
  signal rows_read_tag_output_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_first_cost : boolean;
  signal rows_ready_tag_map_column, rows_ready_tag_output_column, rows_ready_tag_start_of_frame : boolean;
  signal rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column, rows_tag_first_cost : boolean;
  signal rows_tag_map_column, rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- line
  signal line_centre_map_column_0, line_centre_output_column_0, line_centre_first_column_0 : boolean;
  signal line_centre_start_of_frame_0, line_centre_end_of_line_0, line_order_falls, line_order_inside : boolean;
  signal line_order_complete, line_order_output, line_order_first, line_order_held_output : boolean;
  signal line_order_turned_valid, line_order_turned_map_column, line_order_turned_output_column : boolean;
  signal line_order_turned_start_of_frame, line_order_turned_end_of_line, line_newest_first_column : boolean;
  signal line_newest_top : boolean;
  signal line_comes : boolean_1d(1 to 47);
  signal line_starts_phases : boolean_1d(1 to 47);
  signal line_places_map_column : boolean_1d(0 to 2);  -- line_places_#_map_column
  signal line_places_first_column : boolean_1d(0 to 1);  -- line_places_#_first_column
  signal line_places_0_top : boolean;
  signal line_places_shown_output_column : boolean_1d(0 to 2);  -- line_places_#_shown_output_column
  signal line_places_shown_start_of_frame : boolean_1d(0 to 2);  -- line_places_#_shown_start_of_frame
  signal line_places_shown_end_of_line : boolean_1d(0 to 2);  -- line_places_#_shown_end_of_line
  signal line_order_address : natural range 0 to 511;
  signal line_places_address : natural_511_1d(0 to 1);  -- line_places_#_address
  -- costsshift
  signal costsshift_newest : natural_16383_1d(0 to 2);
  signal costsshift_new_reference : natural_16383_1d(0 to 2);
  signal costsshift_handed_on : natural_16383_1d(0 to 2);
  signal costsshift_read_reference : natural_16383_1d(0 to 2);
  signal costsshift_search : natural_16383_2d(0 to 2, 0 to 3);
  signal costsshift_reference : natural_16383_1d(0 to 2);
  signal costsshift_new_tag_valid, costsshift_new_tag_border_column, costsshift_read_tag_valid : boolean;
  signal costsshift_read_tag_border_column, costsshift_tag_border_column : boolean;
  signal costsshift_count_phase, costsshift_read_count_phase, costsshift_write_phase : natural range 0 to 15;
  signal costsshift_read_words : unsigned_28_1d(0 to 5);
  -- costscolumn
  signal costscolumn_pixels_first_count : natural_3_3d(0 to 2, 0 to 3, 0 to 3);  -- costscolumn_pixels_first_#_#_count_#
  signal costscolumn_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 3);  -- costscolumn_pixels_first_#_#_count_4
  signal costscolumn_pixels_first_tag_border_column, costscolumn_pixels_tag_border_column : boolean;
  signal costscolumn_pair_tag_border_column : boolean;
  signal costscolumn_pixels_cost : natural_14_2d(0 to 2, 0 to 3);
  signal costscolumn_single_0 : natural_14_1d(0 to 3);
  signal costscolumn_pair_0 : natural_28_1d(0 to 3);
  signal costscolumn_column_0 : natural_42_1d(0 to 3);
  -- costswindow
  signal costswindow_read_count_phase, costswindow_write_count_phase : natural range 0 to 15;
  signal costswindow_read_words_0 : unsigned(26 downto 0);
  signal costswindow_read_words_1 : unsigned(27 downto 0);
  signal costswindow_partial : natural_42_1d(0 to 3);
  signal costswindow_partials : natural_105_1d(4 to 7);  -- costswindow_partial_#
  signal costswindow_sum_0 : natural_169_1d(0 to 3);
  -- costs
  signal costs_cost : natural_21_1d(0 to 3);
  -- paths
  signal paths_tree_smallest : natural_21_1d(0 to 1);
  signal paths_tree_next_smallest_0, paths_smallest_cost : natural range 0 to 21;
  signal paths_cost_delay_ring_read_address, paths_cost_delay_ring_write_address : natural range 0 to 31;
  signal paths_cost_delay_held_0 : unsigned(11 downto 0);
  signal paths_sum : natural_254_1d(0 to 3);
  -- pathsleft
  signal pathsleft_low_address, pathsleft_read_count_phase, pathsleft_ahead_count_phase : natural range 0 to 15;
  signal pathsleft_write_count_phase, pathsleft_low_write_address : natural range 0 to 15;
  signal pathsleft_lowest_0, pathsleft_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsleft_lost, pathsleft_short_of, pathsleft_first, pathsleft_is_first, pathsleft_is_last : boolean;
  signal pathsleft_missing, pathsleft_below, pathsleft_q, pathsleft_room_left, pathsleft_q_now : natural range 0 to 63;
  signal pathsleft_room : natural range 0 to 63;
  signal pathsleft_start_cost : natural_63_1d(1 to 8);
  signal pathsleft_q_less, pathsleft_g_less, pathsleft_lower_neighbour : natural range 0 to 127;
  signal pathsleft_stay : natural_127_1d(0 to 3);
  signal pathsleft_step : natural_127_1d(0 to 3);
  signal pathsleft_stay_change : natural_127_1d(0 to 3);
  signal pathsleft_step_change : natural_127_1d(0 to 3);
  signal pathsleft_cost : natural_127_1d(0 to 3);
  signal pathsleft_arrived : natural_127_1d(0 to 3);
  signal pathsleft_tree_smallest : natural_127_1d(0 to 1);
  signal pathsleft_tree_next_smallest_0, pathsleft_low_0 : natural range 0 to 127;
  signal pathsleft_g : natural range 0 to 84;
  signal pathsleft_read_words : unsigned_28_1d(0 to 1);
  -- pathsabove
  signal pathsabove_memory_read_address_0, pathsabove_memory_write_address_0 : natural range 0 to 4095;
  signal pathsabove_memory_read_address_1 : natural range 0 to 15;
  signal pathsabove_memory_held_words_1 : natural_15_1d(0 to 1);  -- pathsabove_memory_held_words_#_1
  signal pathsabove_memory_ready_words_1 : natural range 0 to 15;
  signal pathsabove_memory_write_words_1 : natural_15_1d(0 to 1);  -- pathsabove_memory_write_words_#_1
  signal pathsabove_memory_write_address_1, pathsabove_read_address_count_phase : natural range 0 to 15;
  signal pathsabove_count_phase, pathsabove_write_address_count_phase : natural range 0 to 15;
  signal pathsabove_memory_bank, pathsabove_memory_read_bank, pathsabove_memory_held_bank : boolean;
  signal pathsabove_ready_top, pathsabove_write_address_is_here : boolean;
  signal pathsabove_memory_read_words_0 : unsigned_16_1d(0 to 1);  -- pathsabove_memory_read_words_#_0
  signal pathsabove_memory_read_words_1 : unsigned_4_1d(0 to 1);  -- pathsabove_memory_read_words_#_1
  signal pathsabove_memory_held_words_0 : natural_65535_1d(0 to 1);  -- pathsabove_memory_held_words_#_0
  signal pathsabove_memory_ready_words_0 : natural range 0 to 65535;
  signal pathsabove_memory_write_words_0 : natural_65535_1d(0 to 1);  -- pathsabove_memory_write_words_#_0
  signal pathsabove_read_address_address, pathsabove_write_address_address : natural range 0 to 8191;
  signal pathsabove_total : natural_52_1d(0 to 3);
  signal pathsabove_tree_smallest : natural_52_1d(0 to 1);
  signal pathsabove_tree_next_smallest_0 : natural range 0 to 52;
  signal pathsabove_delay_held_0 : unsigned(23 downto 0);
  signal pathsabove_smallest_total, pathsabove_smallest : natural range 0 to 63;
  signal pathsabove_cost : natural_63_1d(0 to 3);
  signal pathsabove_held : natural_63_1d(0 to 3);
  signal pathsabove_lower_neighbour : natural range 0 to 63;
  signal pathsabove_beside : natural_63_1d(0 to 3);
  signal pathsabove_own : natural_63_1d(0 to 2);
  signal pathsabove_step : natural_68_1d(0 to 3);
  signal pathsabove_stay : natural_31_1d(0 to 3);
  -- pathsturn
  signal pathsturn_sum_memory_read_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_held_words_1 : natural_4095_1d(0 to 1);  -- pathsturn_sum_memory_held_words_#_1
  signal pathsturn_sum_memory_ready_words_1 : natural range 0 to 4095;
  signal pathsturn_sum_memory_write_words_1 : natural_4095_1d(0 to 1);  -- pathsturn_sum_memory_write_words_#_1
  signal pathsturn_sum_memory_write_address_0, pathsturn_cost_memory_read_address_0 : natural range 0 to 4095;
  signal pathsturn_cost_memory_held_words_0 : natural_4095_1d(0 to 1);  -- pathsturn_cost_memory_held_words_#_0
  signal pathsturn_cost_memory_ready_words_0 : natural range 0 to 4095;
  signal pathsturn_cost_memory_write_words_0 : natural_4095_1d(0 to 1);  -- pathsturn_cost_memory_write_words_#_0
  signal pathsturn_cost_memory_write_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_read_address_1, pathsturn_sum_memory_write_address_1 : natural range 0 to 15;
  signal pathsturn_cost_memory_read_address_1, pathsturn_cost_memory_write_address_1 : natural range 0 to 15;
  signal pathsturn_read_address_count_phase, pathsturn_write_address_count_phase : natural range 0 to 15;
  signal pathsturn_sum_memory_bank, pathsturn_sum_memory_read_bank, pathsturn_sum_memory_held_bank : boolean;
  signal pathsturn_cost_memory_bank, pathsturn_cost_memory_read_bank, pathsturn_cost_memory_held_bank : boolean;
  signal pathsturn_write_address_is_here : boolean;
  signal pathsturn_writes_sums : boolean_1d(0 to 1);
  signal pathsturn_sum_memory_read_words_0 : unsigned_16_1d(0 to 1);  -- pathsturn_sum_memory_read_words_#_0
  signal pathsturn_sum_memory_read_words_1 : unsigned_12_1d(0 to 1);  -- pathsturn_sum_memory_read_words_#_1
  signal pathsturn_cost_memory_read_words_0 : unsigned_12_1d(0 to 1);  -- pathsturn_cost_memory_read_words_#_0
  signal pathsturn_sum_memory_held_words_0 : natural_65535_1d(0 to 1);  -- pathsturn_sum_memory_held_words_#_0
  signal pathsturn_sum_memory_ready_words_0 : natural range 0 to 65535;
  signal pathsturn_sum_memory_write_words_0 : natural_65535_1d(0 to 1);  -- pathsturn_sum_memory_write_words_#_0
  signal pathsturn_smallest_address, pathsturn_write_smallest_address : natural range 0 to 511;
  signal pathsturn_read_smallest_0 : unsigned(4 downto 0);
  signal pathsturn_ready_smallest_0 : natural range 0 to 31;
  signal pathsturn_read_address_address, pathsturn_sum_read_address : natural range 0 to 8191;
  signal pathsturn_write_address_address : natural range 0 to 8191;
  signal pathsturn_sum_write_address : natural_8191_1d(0 to 1);
  signal pathsturn_write_smallest_0 : natural range 0 to 21;
  -- pathsright
  signal pathsright_lowest_0, pathsright_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsright_lost, pathsright_short_of : boolean;
  signal pathsright_missing, pathsright_below, pathsright_q, pathsright_room_left : natural range 0 to 63;
  signal pathsright_q_now, pathsright_room : natural range 0 to 63;
  signal pathsright_start_cost : natural_63_1d(1 to 8);
  signal pathsright_q_less, pathsright_g_less, pathsright_lower_neighbour : natural range 0 to 127;
  signal pathsright_stay : natural_127_1d(0 to 3);
  signal pathsright_step : natural_127_1d(0 to 3);
  signal pathsright_stay_change : natural_127_1d(0 to 3);
  signal pathsright_step_change : natural_127_1d(0 to 3);
  signal pathsright_cost : natural_127_1d(0 to 3);
  signal pathsright_arrived : natural_127_1d(0 to 3);
  signal pathsright_tree_smallest : natural_127_1d(0 to 1);
  signal pathsright_tree_next_smallest_0, pathsright_low_0 : natural range 0 to 127;
  signal pathsright_g : natural range 0 to 94;
  signal pathsright_read_words : unsigned_28_1d(0 to 1);
  -- winnerswinner1
  signal winnerswinner1_best_cost_0 : natural_254_1d(0 to 1);
  signal winnerswinner1_best_index_0_0, winnerswinner1_best_below_0 : boolean;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 3;
  -- winnerswinner2
  signal winnerswinner2_best_cost_0_0 : natural range 0 to 254;
  signal winnerswinner2_best_index_0_0 : natural range 0 to 3;
  -- winners
  signal winners_best_cost_0_0, winners_best_index_0_0 : natural range 0 to 255;
  signal winners_best_tag_valid, winners_best_tag_map_column, winners_best_tag_output_column : boolean;
  signal winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  -- turn
  signal turn_order_address, turn_newest, turn_write_words_0, turn_write_place, turn_ready : natural range 0 to 511;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame : boolean;
  signal turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid, turn_read_tag_map_column : boolean;
  signal turn_read_tag_start_of_frame, turn_read_tag_end_of_line, turn_ready_tag_valid : boolean;
  signal turn_ready_tag_row_start, turn_ready_tag_map_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- map
  signal map_counter_column, map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 511;
  signal map_write_column : natural range 0 to 511;
  signal map_column : natural_511_1d(1 to 2);
  signal map_at_column, map_comparing_column, map_sorted_column : natural range 0 to 511;
  signal map_counter_group, map_of_column_0_a, map_of_column_0_b, map_of_column_0_c : natural range 0 to 255;
  signal map_sorted_low_0, map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 255;
  signal map_low_0 : natural_255_1d(0 to 2);  -- map_low_#_0
  signal map_middle_0 : natural_255_1d(0 to 2);  -- map_middle_#_0
  signal map_high_0 : natural_255_1d(0 to 2);  -- map_high_#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b : natural range 0 to 255;
  signal map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b, map_of_high_0_c : natural range 0 to 255;
  signal map_largest_low_0, map_median_middle_0, map_smallest_high_0, map_of_all_0_a : natural range 0 to 255;
  signal map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 255;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_at_arrives, map_at_behind : boolean;
  signal map_at_top, map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a : boolean;
  signal map_of_column_0_c_below_b : boolean;
  signal map_column_passed_0 : boolean_1d(0 to 1);  -- map_column_passed_#_0
  signal map_comparing_arrives, map_comparing_behind, map_comparing_top, map_comparing_output : boolean;
  signal map_sorted_arrives, map_sorted_behind, map_sorted_top, map_sorted_output : boolean;
  signal map_passed_0 : boolean_1d(0 to 1);  -- map_passed_#_0
  signal map_window_complete, map_window_first, map_window_last, map_of_low_0_b_below_a : boolean;
  signal map_of_low_0_c_below_a, map_of_low_0_c_below_b, map_of_middle_0_b_below_a, map_of_middle_0_c_below_a : boolean;
  signal map_of_middle_0_c_below_b, map_of_high_0_b_below_a, map_of_high_0_c_below_a, map_of_high_0_c_below_b : boolean;
  signal map_of_all_0_b_below_a, map_of_all_0_c_below_a, map_of_all_0_c_below_b : boolean;
  signal map_waiting_complete : boolean_1d(0 to 2);  -- map_waiting_#_complete
  signal map_waiting_first : boolean_1d(0 to 2);  -- map_waiting_#_first
  signal map_waiting_last : boolean_1d(0 to 2);  -- map_waiting_#_last
  signal map_waiting_passed_0 : boolean_1d(0 to 2);  -- map_waiting_passed_#_0
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_rows_read_words_0 : unsigned(17 downto 0);
  signal map_rows_ready_words_0, map_rows_write_words_0 : natural range 0 to 262143;
  -- other
  signal other : unsigned_49_1d(0 to 1);
  signal other_2 : natural range 0 to 510;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address, map_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(17 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address, turn_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal pathsright_read_words_1_memory_read_enable : boolean;
  signal pathsright_read_words_1_memory_read_address : unsigned(3 downto 0);
  signal pathsright_read_words_1_memory_write_address : unsigned(3 downto 0);
  signal pathsright_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_words_0_memory_read_enable : boolean;
  signal pathsright_read_words_0_memory_read_address : unsigned(3 downto 0);
  signal pathsright_read_words_0_memory_write_address : unsigned(3 downto 0);
  signal pathsright_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_neighbour_0_memory_read_enable : boolean;
  signal pathsright_read_neighbour_0_memory_read_address : unsigned(3 downto 0);
  signal pathsright_read_neighbour_0_memory_write_address : unsigned(3 downto 0);
  signal pathsright_read_neighbour_0_memory_write_data : unsigned(6 downto 0);
  signal pathsright_lowest_0_memory_read_enable : boolean;
  signal pathsright_lowest_0_memory_read_address, pathsright_lowest_0_memory_write_address : unsigned(3 downto 0);
  signal pathsright_lowest_0_memory_write_data : unsigned(6 downto 0);
  signal pathsturn_read_smallest_0_memory_read_enable : boolean;
  signal pathsturn_read_smallest_0_memory_read_address : unsigned(8 downto 0);
  signal pathsturn_read_smallest_0_memory_write_address : unsigned(8 downto 0);
  signal pathsturn_read_smallest_0_memory_write_data : unsigned(4 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_1_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_write_data : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_1_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_write_data : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_0_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_write_data : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_0_memory_read_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_write_address : unsigned(3 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_write_data : unsigned(11 downto 0);
  signal pathsabove_delay_held_0_memory_read_enable : boolean;
  signal pathsabove_delay_held_0_memory_read_address : unsigned(4 downto 0);
  signal pathsabove_delay_held_0_memory_write_address : unsigned(4 downto 0);
  signal pathsabove_delay_held_0_memory_write_data : unsigned(23 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_1_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_write_data : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_write_data : unsigned(15 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_1_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_write_data : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_0_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_write_data : unsigned(15 downto 0);
  signal pathsleft_read_words_1_memory_read_enable : boolean;
  signal pathsleft_read_words_1_memory_read_address, pathsleft_read_words_1_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_words_0_memory_read_enable : boolean;
  signal pathsleft_read_words_0_memory_read_address, pathsleft_read_words_0_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_neighbour_0_memory_read_enable : boolean;
  signal pathsleft_read_neighbour_0_memory_read_address : unsigned(3 downto 0);
  signal pathsleft_read_neighbour_0_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_read_neighbour_0_memory_write_data : unsigned(6 downto 0);
  signal pathsleft_lowest_0_memory_read_enable : boolean;
  signal pathsleft_lowest_0_memory_read_address, pathsleft_lowest_0_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_lowest_0_memory_write_data : unsigned(6 downto 0);
  signal paths_cost_delay_held_0_memory_read_enable : boolean;
  signal paths_cost_delay_held_0_memory_read_address : unsigned(4 downto 0);
  signal paths_cost_delay_held_0_memory_write_address : unsigned(4 downto 0);
  signal paths_cost_delay_held_0_memory_write_data : unsigned(11 downto 0);
  signal costswindow_read_words_1_memory_read_enable : boolean;
  signal costswindow_read_words_1_memory_read_address : unsigned(3 downto 0);
  signal costswindow_read_words_1_memory_write_address : unsigned(3 downto 0);
  signal costswindow_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal costswindow_read_words_0_memory_read_enable : boolean;
  signal costswindow_read_words_0_memory_read_address : unsigned(3 downto 0);
  signal costswindow_read_words_0_memory_write_address : unsigned(3 downto 0);
  signal costswindow_read_words_0_memory_write_data : unsigned(26 downto 0);
  signal costsshift_read_words_5_memory_read_enable : boolean;
  signal costsshift_read_words_5_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_5_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_5_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_4_memory_read_enable : boolean;
  signal costsshift_read_words_4_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_4_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_4_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_3_memory_read_enable : boolean;
  signal costsshift_read_words_3_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_3_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_3_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_2_memory_read_enable : boolean;
  signal costsshift_read_words_2_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_2_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_1_memory_read_enable : boolean;
  signal costsshift_read_words_1_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_1_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_0_memory_read_enable : boolean;
  signal costsshift_read_words_0_memory_read_address : unsigned(3 downto 0);
  signal costsshift_read_words_0_memory_write_address : unsigned(3 downto 0);
  signal costsshift_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(27 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 9);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_write_column, 9);
  map_rows_read_words_0_memory_write_data <= to_unsigned(map_rows_write_words_0, 18);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 257, width => 18, address_bits => 9)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 9);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 9);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 9);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 258, width => 9, address_bits => 9)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  pathsright_read_words_1_memory_read_enable <= true;
  pathsright_read_words_1_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsright_read_words_1_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsright_read_words_1_memory_write_data <= to_unsigned(pathsright_arrived(3), 7) & to_unsigned(pathsright_arrived(2), 7) & to_unsigned(pathsright_arrived(1), 7) & to_unsigned(pathsright_arrived(0), 7);
  pathsright_read_words_1_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_read_words_1_memory_read_enable,
      read_address => pathsright_read_words_1_memory_read_address, read_data => pathsright_read_words(1),
      write_address => pathsright_read_words_1_memory_write_address, write_data => pathsright_read_words_1_memory_write_data);

  pathsright_read_words_0_memory_read_enable <= true;
  pathsright_read_words_0_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsright_read_words_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsright_read_words_0_memory_write_data <= to_unsigned(pathsright_cost(3), 7) & to_unsigned(pathsright_cost(2), 7) & to_unsigned(pathsright_cost(1), 7) & to_unsigned(pathsright_cost(0), 7);
  pathsright_read_words_0_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_read_words_0_memory_read_enable,
      read_address => pathsright_read_words_0_memory_read_address, read_data => pathsright_read_words(0),
      write_address => pathsright_read_words_0_memory_write_address, write_data => pathsright_read_words_0_memory_write_data);

  pathsright_read_neighbour_0_memory_read_enable <= true;
  pathsright_read_neighbour_0_memory_read_address <= to_unsigned(pathsleft_ahead_count_phase, 4);
  pathsright_read_neighbour_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsright_read_neighbour_0_memory_write_data <= to_unsigned(pathsright_cost(0), 7);
  pathsright_read_neighbour_0_memory : entity work.line_memory
    generic map (depth => 16, width => 7, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_read_neighbour_0_memory_read_enable,
      read_address => pathsright_read_neighbour_0_memory_read_address, read_data => pathsright_read_neighbour_0,
      write_address => pathsright_read_neighbour_0_memory_write_address, write_data => pathsright_read_neighbour_0_memory_write_data);

  pathsright_lowest_0_memory_read_enable <= true;
  pathsright_lowest_0_memory_read_address <= to_unsigned(pathsleft_low_address, 4);
  pathsright_lowest_0_memory_write_address <= to_unsigned(pathsleft_low_write_address, 4);
  pathsright_lowest_0_memory_write_data <= to_unsigned(pathsright_low_0, 7);
  pathsright_lowest_0_memory : entity work.line_memory
    generic map (depth => 16, width => 7, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsright_lowest_0_memory_read_enable,
      read_address => pathsright_lowest_0_memory_read_address, read_data => pathsright_lowest_0,
      write_address => pathsright_lowest_0_memory_write_address, write_data => pathsright_lowest_0_memory_write_data);

  pathsturn_read_smallest_0_memory_read_enable <= true;
  pathsturn_read_smallest_0_memory_read_address <= to_unsigned(pathsturn_smallest_address, 9);
  pathsturn_read_smallest_0_memory_write_address <= to_unsigned(pathsturn_write_smallest_address, 9);
  pathsturn_read_smallest_0_memory_write_data <= to_unsigned(pathsturn_write_smallest_0, 5);
  pathsturn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 258, width => 5, address_bits => 9)
    port map (
      clock => clock, read_enable => pathsturn_read_smallest_0_memory_read_enable,
      read_address => pathsturn_read_smallest_0_memory_read_address, read_data => pathsturn_read_smallest_0,
      write_address => pathsturn_read_smallest_0_memory_write_address, write_data => pathsturn_read_smallest_0_memory_write_data);

  pathsturn_sum_memory_read_words_0_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1(0), 12);
  pathsturn_sum_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 12, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_1_memory_read_address, read_data => pathsturn_sum_memory_read_words_1(0),
      write_address => pathsturn_sum_memory_read_words_0_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_1_memory_write_data);

  pathsturn_sum_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0(0), 16);
  pathsturn_sum_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 16, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_0_memory_read_address, read_data => pathsturn_sum_memory_read_words_0(0),
      write_address => pathsturn_sum_memory_read_words_0_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_0_memory_write_data);

  pathsturn_sum_memory_read_words_1_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 4);
  pathsturn_sum_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 4);
  pathsturn_sum_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_1(1), 12);
  pathsturn_sum_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 16, width => 12, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_1_memory_read_address, read_data => pathsturn_sum_memory_read_words_1(1),
      write_address => pathsturn_sum_memory_read_words_1_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_1_memory_write_data);

  pathsturn_sum_memory_read_words_1_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 4);
  pathsturn_sum_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 4);
  pathsturn_sum_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0(1), 16);
  pathsturn_sum_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 16, width => 16, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_0_memory_read_address, read_data => pathsturn_sum_memory_read_words_0(1),
      write_address => pathsturn_sum_memory_read_words_1_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_0_memory_write_data);

  pathsturn_cost_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
  pathsturn_cost_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0(0), 12);
  pathsturn_cost_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 12, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_0_memory_read_address, read_data => pathsturn_cost_memory_read_words_0(0),
      write_address => pathsturn_cost_memory_read_words_0_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_0_memory_write_data);

  pathsturn_cost_memory_read_words_1_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_1, 4);
  pathsturn_cost_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 4);
  pathsturn_cost_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0(1), 12);
  pathsturn_cost_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 16, width => 12, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_0_memory_read_address, read_data => pathsturn_cost_memory_read_words_0(1),
      write_address => pathsturn_cost_memory_read_words_1_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_0_memory_write_data);

  pathsabove_delay_held_0_memory_read_enable <= true;
  pathsabove_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 5);
  pathsabove_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 5);
  pathsabove_delay_held_0_memory_write_data <= to_unsigned(pathsabove_total(3), 6) & to_unsigned(pathsabove_total(2), 6) & to_unsigned(pathsabove_total(1), 6) & to_unsigned(pathsabove_total(0), 6);
  pathsabove_delay_held_0_memory : entity work.line_memory
    generic map (depth => 19, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_0_memory_read_enable,
      read_address => pathsabove_delay_held_0_memory_read_address, read_data => pathsabove_delay_held_0,
      write_address => pathsabove_delay_held_0_memory_write_address, write_data => pathsabove_delay_held_0_memory_write_data);

  pathsabove_memory_read_words_0_1_memory_read_enable <= true;
  pathsabove_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words_1(0), 4);
  pathsabove_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 4, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_1_memory_read_address, read_data => pathsabove_memory_read_words_1(0),
      write_address => pathsabove_memory_read_words_0_1_memory_write_address, write_data => pathsabove_memory_read_words_0_1_memory_write_data);

  pathsabove_memory_read_words_0_0_memory_read_enable <= true;
  pathsabove_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words_0(0), 16);
  pathsabove_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 16, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_0_memory_read_address, read_data => pathsabove_memory_read_words_0(0),
      write_address => pathsabove_memory_read_words_0_0_memory_write_address, write_data => pathsabove_memory_read_words_0_0_memory_write_data);

  pathsabove_memory_read_words_1_1_memory_read_enable <= true;
  pathsabove_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_1, 4);
  pathsabove_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 4);
  pathsabove_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words_1(1), 4);
  pathsabove_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 16, width => 4, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_1_memory_read_address, read_data => pathsabove_memory_read_words_1(1),
      write_address => pathsabove_memory_read_words_1_1_memory_write_address, write_data => pathsabove_memory_read_words_1_1_memory_write_data);

  pathsabove_memory_read_words_1_0_memory_read_enable <= true;
  pathsabove_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_1, 4);
  pathsabove_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 4);
  pathsabove_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words_0(1), 16);
  pathsabove_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 16, width => 16, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_0_memory_read_address, read_data => pathsabove_memory_read_words_0(1),
      write_address => pathsabove_memory_read_words_1_0_memory_write_address, write_data => pathsabove_memory_read_words_1_0_memory_write_data);

  pathsleft_read_words_1_memory_read_enable <= true;
  pathsleft_read_words_1_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsleft_read_words_1_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsleft_read_words_1_memory_write_data <= to_unsigned(pathsleft_arrived(3), 7) & to_unsigned(pathsleft_arrived(2), 7) & to_unsigned(pathsleft_arrived(1), 7) & to_unsigned(pathsleft_arrived(0), 7);
  pathsleft_read_words_1_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_read_words_1_memory_read_enable,
      read_address => pathsleft_read_words_1_memory_read_address, read_data => pathsleft_read_words(1),
      write_address => pathsleft_read_words_1_memory_write_address, write_data => pathsleft_read_words_1_memory_write_data);

  pathsleft_read_words_0_memory_read_enable <= true;
  pathsleft_read_words_0_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 4);
  pathsleft_read_words_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsleft_read_words_0_memory_write_data <= to_unsigned(pathsleft_cost(3), 7) & to_unsigned(pathsleft_cost(2), 7) & to_unsigned(pathsleft_cost(1), 7) & to_unsigned(pathsleft_cost(0), 7);
  pathsleft_read_words_0_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_read_words_0_memory_read_enable,
      read_address => pathsleft_read_words_0_memory_read_address, read_data => pathsleft_read_words(0),
      write_address => pathsleft_read_words_0_memory_write_address, write_data => pathsleft_read_words_0_memory_write_data);

  pathsleft_read_neighbour_0_memory_read_enable <= true;
  pathsleft_read_neighbour_0_memory_read_address <= to_unsigned(pathsleft_ahead_count_phase, 4);
  pathsleft_read_neighbour_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 4);
  pathsleft_read_neighbour_0_memory_write_data <= to_unsigned(pathsleft_cost(0), 7);
  pathsleft_read_neighbour_0_memory : entity work.line_memory
    generic map (depth => 16, width => 7, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_read_neighbour_0_memory_read_enable,
      read_address => pathsleft_read_neighbour_0_memory_read_address, read_data => pathsleft_read_neighbour_0,
      write_address => pathsleft_read_neighbour_0_memory_write_address, write_data => pathsleft_read_neighbour_0_memory_write_data);

  pathsleft_lowest_0_memory_read_enable <= true;
  pathsleft_lowest_0_memory_read_address <= to_unsigned(pathsleft_low_address, 4);
  pathsleft_lowest_0_memory_write_address <= to_unsigned(pathsleft_low_write_address, 4);
  pathsleft_lowest_0_memory_write_data <= to_unsigned(pathsleft_low_0, 7);
  pathsleft_lowest_0_memory : entity work.line_memory
    generic map (depth => 16, width => 7, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsleft_lowest_0_memory_read_enable,
      read_address => pathsleft_lowest_0_memory_read_address, read_data => pathsleft_lowest_0,
      write_address => pathsleft_lowest_0_memory_write_address, write_data => pathsleft_lowest_0_memory_write_data);

  paths_cost_delay_held_0_memory_read_enable <= true;
  paths_cost_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 5);
  paths_cost_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 5);
  paths_cost_delay_held_0_memory_write_data <= ((((((to_unsigned(costs_cost(2), 6) & to_unsigned(0, 6)) or (to_unsigned((costs_cost(3) mod 8), 3) & to_unsigned(0, 9)))) or (to_unsigned(costs_cost(0), 12)))) or (to_unsigned(costs_cost(1), 9) & to_unsigned(0, 3)));
  paths_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 19, width => 12, address_bits => 5)
    port map (
      clock => clock, read_enable => paths_cost_delay_held_0_memory_read_enable,
      read_address => paths_cost_delay_held_0_memory_read_address, read_data => paths_cost_delay_held_0,
      write_address => paths_cost_delay_held_0_memory_write_address, write_data => paths_cost_delay_held_0_memory_write_data);

  costswindow_read_words_1_memory_read_enable <= true;
  costswindow_read_words_1_memory_read_address <= to_unsigned(costswindow_read_count_phase, 4);
  costswindow_read_words_1_memory_write_address <= to_unsigned(costswindow_write_count_phase, 4);
  costswindow_read_words_1_memory_write_data <= to_unsigned(costswindow_partials(7), 7) & to_unsigned(costswindow_partials(6), 7) & to_unsigned(costswindow_partials(5), 7) & to_unsigned(costswindow_partials(4), 7);
  costswindow_read_words_1_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => costswindow_read_words_1_memory_read_enable,
      read_address => costswindow_read_words_1_memory_read_address, read_data => costswindow_read_words_1,
      write_address => costswindow_read_words_1_memory_write_address, write_data => costswindow_read_words_1_memory_write_data);

  costswindow_read_words_0_memory_read_enable <= true;
  costswindow_read_words_0_memory_read_address <= to_unsigned(costswindow_read_count_phase, 4);
  costswindow_read_words_0_memory_write_address <= to_unsigned(costswindow_write_count_phase, 4);
  costswindow_read_words_0_memory_write_data <= to_unsigned(costswindow_partial(3), 6) & to_unsigned(costswindow_partial(2), 7) & to_unsigned(costswindow_partial(1), 7) & to_unsigned(costswindow_partial(0), 7);
  costswindow_read_words_0_memory : entity work.line_memory
    generic map (depth => 16, width => 27, address_bits => 4)
    port map (
      clock => clock, read_enable => costswindow_read_words_0_memory_read_enable,
      read_address => costswindow_read_words_0_memory_read_address, read_data => costswindow_read_words_0,
      write_address => costswindow_read_words_0_memory_write_address, write_data => costswindow_read_words_0_memory_write_data);

  costsshift_read_words_5_memory_read_enable <= true;
  costsshift_read_words_5_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_5_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_5_memory_write_data <= to_unsigned(costsshift_search(2, 3), 14) & to_unsigned(costsshift_search(2, 2), 14);
  costsshift_read_words_5_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_5_memory_read_enable,
      read_address => costsshift_read_words_5_memory_read_address, read_data => costsshift_read_words(5),
      write_address => costsshift_read_words_5_memory_write_address, write_data => costsshift_read_words_5_memory_write_data);

  costsshift_read_words_4_memory_read_enable <= true;
  costsshift_read_words_4_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_4_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_4_memory_write_data <= to_unsigned(costsshift_search(2, 1), 14) & to_unsigned(costsshift_search(2, 0), 14);
  costsshift_read_words_4_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_4_memory_read_enable,
      read_address => costsshift_read_words_4_memory_read_address, read_data => costsshift_read_words(4),
      write_address => costsshift_read_words_4_memory_write_address, write_data => costsshift_read_words_4_memory_write_data);

  costsshift_read_words_3_memory_read_enable <= true;
  costsshift_read_words_3_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_3_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_3_memory_write_data <= to_unsigned(costsshift_search(1, 3), 14) & to_unsigned(costsshift_search(1, 2), 14);
  costsshift_read_words_3_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_3_memory_read_enable,
      read_address => costsshift_read_words_3_memory_read_address, read_data => costsshift_read_words(3),
      write_address => costsshift_read_words_3_memory_write_address, write_data => costsshift_read_words_3_memory_write_data);

  costsshift_read_words_2_memory_read_enable <= true;
  costsshift_read_words_2_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_2_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_2_memory_write_data <= to_unsigned(costsshift_search(1, 1), 14) & to_unsigned(costsshift_search(1, 0), 14);
  costsshift_read_words_2_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_2_memory_read_enable,
      read_address => costsshift_read_words_2_memory_read_address, read_data => costsshift_read_words(2),
      write_address => costsshift_read_words_2_memory_write_address, write_data => costsshift_read_words_2_memory_write_data);

  costsshift_read_words_1_memory_read_enable <= true;
  costsshift_read_words_1_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_1_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_1_memory_write_data <= to_unsigned(costsshift_search(0, 3), 14) & to_unsigned(costsshift_search(0, 2), 14);
  costsshift_read_words_1_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_1_memory_read_enable,
      read_address => costsshift_read_words_1_memory_read_address, read_data => costsshift_read_words(1),
      write_address => costsshift_read_words_1_memory_write_address, write_data => costsshift_read_words_1_memory_write_data);

  costsshift_read_words_0_memory_read_enable <= true;
  costsshift_read_words_0_memory_read_address <= to_unsigned(costsshift_count_phase, 4);
  costsshift_read_words_0_memory_write_address <= to_unsigned(costsshift_write_phase, 4);
  costsshift_read_words_0_memory_write_data <= to_unsigned(costsshift_search(0, 1), 14) & to_unsigned(costsshift_search(0, 0), 14);
  costsshift_read_words_0_memory : entity work.line_memory
    generic map (depth => 16, width => 28, address_bits => 4)
    port map (
      clock => clock, read_enable => costsshift_read_words_0_memory_read_enable,
      read_address => costsshift_read_words_0_memory_read_address, read_data => costsshift_read_words(0),
      write_address => costsshift_read_words_0_memory_write_address, write_data => costsshift_read_words_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_next_frame_is_equal, transform_counter_frame_joins_choice : boolean;
    variable transform_counter_next_frame_after_any, transform_counter_next_frame_after_is_equal : boolean;
    variable transform_read_column_inside_0_is_less, transform_reached_first_0_value : boolean;
    variable transform_reached_beyond_last_3_value, transform_reached_beyond_last_3_choice : boolean;
    variable transform_left_filter_low_is_larger_0_0_0_value : boolean;
    variable transform_left_filter_low_is_larger_0_0_0_choice : boolean;
    variable transform_left_filter_low_is_larger_0_0_0_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_0_0_choice_#
    variable transform_left_filter_low_is_larger_0_0_0_values : boolean_1d(2 to 4);  -- transform_left_filter_low_is_larger_0_0_0_value_#
    variable transform_left_filter_low_is_larger_0_0_2_any, transform_left_filter_low_is_larger_0_0_2_choice : boolean;
    variable transform_left_filter_low_is_larger_0_0_2_is_equal : boolean;
    variable transform_left_filter_low_is_larger_0_0_2_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_0_2_choice_#
    variable transform_left_filter_low_is_larger_0_0_2_value : boolean;
    variable transform_left_filter_low_is_larger_0_0_4_choice : boolean;
    variable transform_left_filter_low_is_larger_0_0_4_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_0_4_choice_#
    variable transform_left_filter_low_is_larger_0_0_4_value : boolean;
    variable transform_left_filter_low_is_larger_0_2_0_choice : boolean;
    variable transform_left_filter_low_is_larger_0_2_0_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_2_0_choice_#
    variable transform_left_filter_low_is_larger_0_2_0_value : boolean;
    variable transform_left_filter_low_is_larger_0_2_2_choice : boolean;
    variable transform_left_filter_low_is_larger_0_2_2_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_2_2_choice_#
    variable transform_left_filter_low_is_larger_0_2_2_value : boolean;
    variable transform_left_filter_low_is_larger_0_2_4_choice : boolean;
    variable transform_left_filter_low_is_larger_0_2_4_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_2_4_choice_#
    variable transform_left_filter_low_is_larger_0_2_4_value : boolean;
    variable transform_left_filter_low_is_larger_0_4_0_choice : boolean;
    variable transform_left_filter_low_is_larger_0_4_0_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_4_0_choice_#
    variable transform_left_filter_low_is_larger_0_4_0_value : boolean;
    variable transform_left_filter_low_is_larger_0_4_4_choice : boolean;
    variable transform_left_filter_low_is_larger_0_4_4_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_4_4_choice_#
    variable transform_left_filter_low_is_larger_0_4_4_value : boolean;
    variable transform_left_filter_low_is_larger_0_6_0_choice : boolean;
    variable transform_left_filter_low_is_larger_0_6_0_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_6_0_choice_#
    variable transform_left_filter_low_is_larger_0_6_0_value : boolean;
    variable transform_left_filter_low_is_larger_0_6_2_choice : boolean;
    variable transform_left_filter_low_is_larger_0_6_2_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_6_2_choice_#
    variable transform_left_filter_low_is_larger_0_6_2_value : boolean;
    variable transform_left_filter_low_is_larger_0_6_4_choice : boolean;
    variable transform_left_filter_low_is_larger_0_6_4_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_6_4_choice_#
    variable transform_left_filter_low_is_larger_0_6_4_value : boolean;
    variable transform_left_filter_low_is_larger_0_8_0_choice : boolean;
    variable transform_left_filter_low_is_larger_0_8_0_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_8_0_choice_#
    variable transform_left_filter_low_is_larger_0_8_0_value : boolean;
    variable transform_left_filter_low_is_larger_0_8_2_choice : boolean;
    variable transform_left_filter_low_is_larger_0_8_2_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_8_2_choice_#
    variable transform_left_filter_low_is_larger_0_8_2_value : boolean;
    variable transform_left_filter_low_is_larger_0_8_4_choice : boolean;
    variable transform_left_filter_low_is_larger_0_8_4_choices : boolean_1d(2 to 3);  -- transform_left_filter_low_is_larger_0_8_4_choice_#
    variable transform_left_filter_low_is_larger_0_8_4_value, transform_left_filter_feature_0_value : boolean;
    variable transform_left_filter_feature_0_choice : boolean;
    variable transform_left_filter_feature_0_values : boolean_1d(2 to 3);  -- transform_left_filter_feature_0_value_#
    variable transform_left_filter_feature_0_choices : boolean_1d(2 to 65);  -- transform_left_filter_feature_0_choice_#
    variable transform_left_filter_feature_0_all : boolean;
    variable transform_left_filter_feature_0_alls : boolean_1d(2 to 4);  -- transform_left_filter_feature_0_all_#
    variable transform_right_filter_low_is_larger_0_0_0_value : boolean;
    variable transform_right_filter_low_is_larger_0_0_0_choice : boolean;
    variable transform_right_filter_low_is_larger_0_0_0_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_0_0_choice_#
    variable transform_right_filter_low_is_larger_0_0_0_values : boolean_1d(2 to 4);  -- transform_right_filter_low_is_larger_0_0_0_value_#
    variable transform_right_filter_low_is_larger_0_0_2_any : boolean;
    variable transform_right_filter_low_is_larger_0_0_2_choice : boolean;
    variable transform_right_filter_low_is_larger_0_0_2_is_equal : boolean;
    variable transform_right_filter_low_is_larger_0_0_2_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_0_2_choice_#
    variable transform_right_filter_low_is_larger_0_0_2_value : boolean;
    variable transform_right_filter_low_is_larger_0_0_4_choice : boolean;
    variable transform_right_filter_low_is_larger_0_0_4_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_0_4_choice_#
    variable transform_right_filter_low_is_larger_0_0_4_value : boolean;
    variable transform_right_filter_low_is_larger_0_2_0_choice : boolean;
    variable transform_right_filter_low_is_larger_0_2_0_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_2_0_choice_#
    variable transform_right_filter_low_is_larger_0_2_0_value : boolean;
    variable transform_right_filter_low_is_larger_0_2_2_choice : boolean;
    variable transform_right_filter_low_is_larger_0_2_2_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_2_2_choice_#
    variable transform_right_filter_low_is_larger_0_2_2_value : boolean;
    variable transform_right_filter_low_is_larger_0_2_4_choice : boolean;
    variable transform_right_filter_low_is_larger_0_2_4_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_2_4_choice_#
    variable transform_right_filter_low_is_larger_0_2_4_value : boolean;
    variable transform_right_filter_low_is_larger_0_4_0_choice : boolean;
    variable transform_right_filter_low_is_larger_0_4_0_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_4_0_choice_#
    variable transform_right_filter_low_is_larger_0_4_0_value : boolean;
    variable transform_right_filter_low_is_larger_0_4_4_choice : boolean;
    variable transform_right_filter_low_is_larger_0_4_4_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_4_4_choice_#
    variable transform_right_filter_low_is_larger_0_4_4_value : boolean;
    variable transform_right_filter_low_is_larger_0_6_0_choice : boolean;
    variable transform_right_filter_low_is_larger_0_6_0_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_6_0_choice_#
    variable transform_right_filter_low_is_larger_0_6_0_value : boolean;
    variable transform_right_filter_low_is_larger_0_6_2_choice : boolean;
    variable transform_right_filter_low_is_larger_0_6_2_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_6_2_choice_#
    variable transform_right_filter_low_is_larger_0_6_2_value : boolean;
    variable transform_right_filter_low_is_larger_0_6_4_choice : boolean;
    variable transform_right_filter_low_is_larger_0_6_4_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_6_4_choice_#
    variable transform_right_filter_low_is_larger_0_6_4_value : boolean;
    variable transform_right_filter_low_is_larger_0_8_0_choice : boolean;
    variable transform_right_filter_low_is_larger_0_8_0_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_8_0_choice_#
    variable transform_right_filter_low_is_larger_0_8_0_value : boolean;
    variable transform_right_filter_low_is_larger_0_8_2_choice : boolean;
    variable transform_right_filter_low_is_larger_0_8_2_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_8_2_choice_#
    variable transform_right_filter_low_is_larger_0_8_2_value : boolean;
    variable transform_right_filter_low_is_larger_0_8_4_choice : boolean;
    variable transform_right_filter_low_is_larger_0_8_4_choices : boolean_1d(2 to 3);  -- transform_right_filter_low_is_larger_0_8_4_choice_#
    variable transform_right_filter_low_is_larger_0_8_4_value, transform_right_filter_feature_0_value : boolean;
    variable transform_right_filter_feature_0_choice : boolean;
    variable transform_right_filter_feature_0_values : boolean_1d(2 to 3);  -- transform_right_filter_feature_0_value_#
    variable transform_right_filter_feature_0_choices : boolean_1d(2 to 70);  -- transform_right_filter_feature_0_choice_#
    variable transform_right_filter_feature_0_all : boolean;
    variable transform_right_filter_feature_0_alls : boolean_1d(2 to 5);  -- transform_right_filter_feature_0_all_#
    variable raster_place_next_frame_is_equal, raster_place_back_to_back_choice : boolean;
    variable delay_row_inside_1_is_not_less, delay_row_inside_1_is_less, delay_tag_first_cost_is_equal : boolean;
    variable delay_tag_map_column_is_not_less, delay_tag_map_column_is_less, line_order_address_any : boolean;
    variable line_order_falls_all, line_order_turned_output_column_choice, costsshift_search_0_0_is_equal : boolean;
    variable costscolumn_pixels_first_0_count_value : boolean_2d(0 to 2, 0 to 4);  -- costscolumn_pixels_first_#_0_count_#_value
    variable costscolumn_pixels_first_0_count_value_2 : boolean_2d(0 to 2, 0 to 3);  -- costscolumn_pixels_first_#_0_count_#_value_2
    variable costscolumn_pixels_first_0_count_1_value_3 : boolean_1d(0 to 2);  -- costscolumn_pixels_first_#_0_count_1_value_3
    variable costscolumn_pixels_first_0_count_3_value_3 : boolean_1d(0 to 2);  -- costscolumn_pixels_first_#_0_count_3_value_3
    variable costswindow_partial_0_any, pathsleft_read_count_phase_is_equal, pathsleft_cost_0_any : boolean;
    variable pathsabove_ready_top_choice, pathsabove_ready_top_choice_2, pathsabove_count_phase_is_equal : boolean;
    variable pathsabove_memory_write_words_0_0_is_less, pathsabove_memory_write_words_0_0_choice_4 : boolean;
    variable pathsabove_memory_write_words_0_all : boolean_1d(0 to 1);  -- pathsabove_memory_write_words_#_0_all
    variable pathsturn_sum_memory_write_words_0_all : boolean_1d(0 to 1);  -- pathsturn_sum_memory_write_words_#_0_all
    variable pathsturn_cost_memory_write_words_0_all : boolean_1d(0 to 1);  -- pathsturn_cost_memory_write_words_#_0_all
    variable winnerswinner1_best_index_0_choice : boolean_1d(0 to 1);  -- winnerswinner1_best_index_0_#_choice
    variable winnerswinner1_best_index_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner1_best_index_0_0_choice_#
    variable winnerswinner1_best_index_0_value : boolean_1d(0 to 1);  -- winnerswinner1_best_index_0_#_value
    variable winnerswinner1_best_index_0_values : boolean_2d(0 to 1, 2 to 5);  -- winnerswinner1_best_index_0_#_value_#
    variable winnerswinner1_best_index_0_1_choices : boolean_1d(2 to 8);  -- winnerswinner1_best_index_0_1_choice_#
    variable winnerswinner2_best_index_0_0_choice : boolean;
    variable winnerswinner2_best_index_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner2_best_index_0_0_choice_#
    variable winnerswinner2_best_index_0_0_value : boolean;
    variable winnerswinner2_best_index_0_0_values : boolean_1d(2 to 5);  -- winnerswinner2_best_index_0_0_value_#
    variable turn_order_address_any, turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_ready_tag_row_start_is_equal, turn_ready_tag_row_start_choice : boolean;
    variable turn_ready_tag_row_start_choices : boolean_1d(2 to 3);  -- turn_ready_tag_row_start_choice_#
    variable turn_ready_tag_row_start_is_equals : boolean_1d(2 to 3);  -- turn_ready_tag_row_start_is_equal_#
    variable turn_ready_tag_row_start_all, turn_ready_tag_row_start_all_2, map_line_ended_choice : boolean;
    variable map_at_arrives_value, map_of_column_0_b_below_a_value, map_of_column_0_b_below_a_choice : boolean;
    variable map_of_column_0_b_below_a_values : boolean_1d(2 to 12);  -- map_of_column_0_b_below_a_value_#
    variable map_of_column_0_b_below_a_choices : boolean_1d(2 to 9);  -- map_of_column_0_b_below_a_choice_#
    variable map_of_column_0_c_below_a_value, map_of_column_0_c_below_a_choice : boolean;
    variable map_of_column_0_c_below_a_values : boolean_1d(2 to 7);  -- map_of_column_0_c_below_a_value_#
    variable map_of_column_0_c_below_a_choices : boolean_1d(2 to 20);  -- map_of_column_0_c_below_a_choice_#
    variable map_of_column_0_c_below_b_choice : boolean;
    variable map_of_column_0_c_below_b_choices : boolean_1d(2 to 6);  -- map_of_column_0_c_below_b_choice_#
    variable map_window_complete_is_equal, map_window_complete_choice, map_of_low_0_b_below_a_value : boolean;
    variable map_of_low_0_b_below_a_choice, map_of_low_0_b_below_a_is_equal : boolean;
    variable map_of_low_0_b_below_a_choices : boolean_1d(2 to 7);  -- map_of_low_0_b_below_a_choice_#
    variable map_of_low_0_b_below_a_values : boolean_1d(2 to 11);  -- map_of_low_0_b_below_a_value_#
    variable map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice : boolean;
    variable map_of_low_0_c_below_a_choices : boolean_1d(2 to 7);  -- map_of_low_0_c_below_a_choice_#
    variable map_of_low_0_c_below_b_choice : boolean;
    variable map_of_low_0_c_below_b_choices : boolean_1d(2 to 7);  -- map_of_low_0_c_below_b_choice_#
    variable map_of_middle_0_b_below_a_value, map_of_middle_0_b_below_a_choice : boolean;
    variable map_of_middle_0_b_below_a_is_equal : boolean;
    variable map_of_middle_0_b_below_a_choices : boolean_1d(2 to 7);  -- map_of_middle_0_b_below_a_choice_#
    variable map_of_middle_0_b_below_a_values : boolean_1d(2 to 11);  -- map_of_middle_0_b_below_a_value_#
    variable map_of_middle_0_c_below_a_value, map_of_middle_0_c_below_a_choice : boolean;
    variable map_of_middle_0_c_below_a_choices : boolean_1d(2 to 7);  -- map_of_middle_0_c_below_a_choice_#
    variable map_of_middle_0_c_below_b_choice : boolean;
    variable map_of_middle_0_c_below_b_choices : boolean_1d(2 to 7);  -- map_of_middle_0_c_below_b_choice_#
    variable map_of_high_0_b_below_a_value, map_of_high_0_b_below_a_choice, map_of_high_0_b_below_a_is_equal : boolean;
    variable map_of_high_0_b_below_a_choices : boolean_1d(2 to 7);  -- map_of_high_0_b_below_a_choice_#
    variable map_of_high_0_b_below_a_values : boolean_1d(2 to 11);  -- map_of_high_0_b_below_a_value_#
    variable map_of_high_0_c_below_a_value, map_of_high_0_c_below_a_choice : boolean;
    variable map_of_high_0_c_below_a_choices : boolean_1d(2 to 7);  -- map_of_high_0_c_below_a_choice_#
    variable map_of_high_0_c_below_b_choice : boolean;
    variable map_of_high_0_c_below_b_choices : boolean_1d(2 to 7);  -- map_of_high_0_c_below_b_choice_#
    variable map_of_all_0_b_below_a_value, map_of_all_0_b_below_a_choice, map_of_all_0_b_below_a_is_equal : boolean;
    variable map_of_all_0_b_below_a_choices : boolean_1d(2 to 7);  -- map_of_all_0_b_below_a_choice_#
    variable map_of_all_0_b_below_a_values : boolean_1d(2 to 11);  -- map_of_all_0_b_below_a_value_#
    variable map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice : boolean;
    variable map_of_all_0_c_below_a_choices : boolean_1d(2 to 7);  -- map_of_all_0_c_below_a_choice_#
    variable map_of_all_0_c_below_b_choice : boolean;
    variable map_of_all_0_c_below_b_choices : boolean_1d(2 to 7);  -- map_of_all_0_c_below_b_choice_#
    variable map_low_0_all : boolean_1d(0 to 1);  -- map_low_#_0_all
    variable transform_counter_group_after_choice, raster_place_group_after_choice : natural range 0 to 255;
    variable winners_best_cost_0_0_choice_2 : natural range 0 to 255;
    variable map_counter_group_choices : natural_255_1d(2 to 3);  -- map_counter_group_choice_#
    variable map_sorted_low_0_choice, map_sorted_low_0_choice_2, map_sorted_middle_0_choice : natural range 0 to 255;
    variable map_sorted_middle_0_choice_2, map_sorted_high_0_choice : natural range 0 to 255;
    variable map_sorted_high_0_choice_2, map_largest_low_0_choice, map_largest_low_0_choice_2 : natural range 0 to 255;
    variable map_median_middle_0_choice : natural range 0 to 255;
    variable map_median_middle_0_choices : natural_255_1d(2 to 4);  -- map_median_middle_0_choice_#
    variable map_smallest_high_0_choice, map_smallest_high_0_choice_2 : natural range 0 to 255;
    variable map_out_disparity_0_choice : natural range 0 to 255;
    variable map_out_disparity_0_choices : natural_255_1d(2 to 4);  -- map_out_disparity_0_choice_#
    variable map_low_0_0_choice, map_middle_0_0_choice, map_high_0_0_choice : natural range 0 to 255;
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 15;
    variable costsshift_count_phase_choice, costswindow_read_count_phase_choice : natural range 0 to 15;
    variable costswindow_write_count_phase_choice, pathsleft_read_count_phase_choice : natural range 0 to 15;
    variable pathsleft_ahead_count_phase_choice, pathsleft_write_count_phase_choice : natural range 0 to 15;
    variable pathsabove_memory_read_address_1_choice : natural range 0 to 15;
    variable pathsabove_read_address_count_phase_choice, pathsabove_count_phase_choice : natural range 0 to 15;
    variable pathsabove_write_address_count_phase_choice : natural range 0 to 15;
    variable pathsturn_read_address_count_phase_choice : natural range 0 to 15;
    variable pathsturn_write_address_count_phase_choice, map_counter_group_choice : natural range 0 to 15;
    variable line_order_address_choice, turn_order_address_choice : natural range 1 to 511;
    variable paths_smallest_cost_choice : natural range 0 to 21;
    variable pathsleft_stay_choice : natural_127_1d(0 to 3);  -- pathsleft_stay_#_choice
    variable pathsleft_stay_value : natural_127_1d(1 to 2);  -- pathsleft_stay_#_value
    variable pathsleft_stay_value_2 : natural_127_1d(1 to 2);  -- pathsleft_stay_#_value_2
    variable pathsleft_step_choice : natural_127_1d(0 to 3);  -- pathsleft_step_#_choice
    variable pathsleft_step_0_choice_2, pathsleft_step_3_choice_2, pathsleft_low_0_choice : natural range 0 to 127;
    variable pathsright_stay_choice : natural_127_1d(0 to 3);  -- pathsright_stay_#_choice
    variable pathsright_stay_value : natural_127_1d(1 to 2);  -- pathsright_stay_#_value
    variable pathsright_stay_value_2 : natural_127_1d(1 to 2);  -- pathsright_stay_#_value_2
    variable pathsright_step_choice : natural_127_1d(0 to 3);  -- pathsright_step_#_choice
    variable pathsright_step_0_choice_2, pathsright_step_3_choice_2, pathsright_low_0_choice : natural range 0 to 127;
    variable pathsleft_stay_change_value : natural_7_1d(1 to 2);  -- pathsleft_stay_change_#_value
    variable pathsright_stay_change_value : natural_7_1d(1 to 2);  -- pathsright_stay_change_#_value
    variable pathsleft_q_choice, pathsleft_q_choice_2, pathsleft_room_left_choice : natural range 0 to 63;
    variable pathsabove_smallest_total_choice, pathsabove_beside_0_choice : natural range 0 to 63;
    variable pathsabove_beside_3_choice, pathsright_q_choice, pathsright_q_choice_2 : natural range 0 to 63;
    variable pathsright_room_left_choice : natural range 0 to 63;
    variable pathsabove_memory_read_address_0_sum : natural range 1 to 8192;
    variable pathsabove_memory_read_address_0_choice : natural range 0 to 4095;
    variable pathsturn_sum_memory_write_words_0_1_sum : natural range 0 to 4095;
    variable pathsabove_memory_read_address_0_sum_2, pathsturn_cost_memory_read_address_0_sum : natural range 0 to 8192;
    variable pathsabove_memory_bank_choice, pathsabove_memory_bank_choice_2 : natural range 0 to 8191;
    variable pathsabove_write_address_address_choice, pathsturn_cost_memory_bank_choice : natural range 0 to 8191;
    variable pathsabove_total_choice : natural_31_1d(0 to 3);  -- pathsabove_total_#_choice
    variable pathsabove_memory_write_words_0_choice : natural_31_1d(0 to 1);  -- pathsabove_memory_write_words_0_#_choice
    variable pathsabove_memory_write_words_0_0_choices : natural_31_1d(2 to 3);  -- pathsabove_memory_write_words_0_0_choice_#
    variable pathsabove_memory_write_words_0_0_sum : natural range 0 to 65535;
    variable pathsturn_sum_memory_write_words_0_0_sum_2 : natural range 0 to 65535;
    variable pathsturn_sum_memory_write_words_0_0_sum : natural range 0 to 190;
    variable winners_best_cost_0_0_choice : natural range 0 to 511;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_next_frame_is_equal := transform_counter_column = 319;
      if transform_counter_last_column then
        transform_counter_frame_joins_choice := (not transform_counter_back_to_back) and winnerswinner1_best_below_0;
      else
        transform_counter_frame_joins_choice := winnerswinner1_best_below_0;
      end if;
      if transform_counter_back_to_back then
        transform_counter_group_after_choice := 2;
      else
        transform_counter_group_after_choice := (transform_counter_group + 1) mod 256;
      end if;
      transform_counter_next_frame_after_any := is_set(transform_counter_group, 3) or is_set(transform_counter_group,
        2);
      transform_counter_next_frame_after_is_equal := (transform_counter_group / 16) = 15;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
      transform_reached_first_0_value := is_set(transform_counter_group, 6);
      transform_reached_beyond_last_3_value := is_set(transform_counter_group, 4);
      if is_set(transform_counter_group, 1) then
        transform_reached_beyond_last_3_choice := transform_reached_beyond_last_3_value;
      else
        transform_reached_beyond_last_3_choice := transform_reached_beyond_last_3_value and
          transform_counter_next_frame_after_any;
      end if;
      transform_left_filter_low_is_larger_0_0_0_value := is_set(transform_left_filter_column_2(4), 1);
      if is_set(transform_left_filter_column_2(4), 0) then
        transform_left_filter_low_is_larger_0_0_0_choice := not is_set(transform_left_filter_column_0(0), 1);
      else
        transform_left_filter_low_is_larger_0_0_0_choice := (transform_left_filter_column_0(0) mod 4) = 0;
      end if;
      if transform_left_filter_low_is_larger_0_0_0_value then
        transform_left_filter_low_is_larger_0_0_0_choices(2) := is_set(transform_left_filter_column_2(4), 0) or (not
          is_set(transform_left_filter_column_0(0), 1)) or (not is_set(transform_left_filter_column_0(0), 0));
      else
        transform_left_filter_low_is_larger_0_0_0_choices(2) := transform_left_filter_low_is_larger_0_0_0_choice;
      end if;
      transform_left_filter_low_is_larger_0_0_0_values(2) := is_set(transform_left_filter_column_2(4), 2);
      transform_left_filter_low_is_larger_0_0_0_values(3) := is_set(transform_left_filter_column_0(0), 2);
      if transform_left_filter_low_is_larger_0_0_0_choices(2) then
        transform_left_filter_low_is_larger_0_0_0_choices(3) := (not
          transform_left_filter_low_is_larger_0_0_0_values(2)) and transform_left_filter_low_is_larger_0_0_0_values(3);
      else
        transform_left_filter_low_is_larger_0_0_0_choices(3) := (not
          transform_left_filter_low_is_larger_0_0_0_values(2)) or transform_left_filter_low_is_larger_0_0_0_values(3);
      end if;
      transform_left_filter_low_is_larger_0_0_0_values(4) := is_set(transform_left_filter_column_0(0), 3);
      transform_left_filter_low_is_larger_0_0_2_any := (not transform_left_filter_low_is_larger_0_0_0_value) or (not
        is_set(transform_left_filter_column_2(4), 0));
      if is_set(transform_left_filter_column_2(0), 0) then
        transform_left_filter_low_is_larger_0_0_2_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_0_2_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      transform_left_filter_low_is_larger_0_0_2_is_equal := (transform_left_filter_column_2(4) mod 4) = 0;
      if is_set(transform_left_filter_column_2(0), 1) then
        transform_left_filter_low_is_larger_0_0_2_choices(2) := transform_left_filter_low_is_larger_0_0_2_choice;
      else
        transform_left_filter_low_is_larger_0_0_2_choices(2) := is_set(transform_left_filter_column_2(0), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_0_2_choices(2) then
        transform_left_filter_low_is_larger_0_0_2_choices(3) := (not is_set(transform_left_filter_column_2(0), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_0_2_choices(3) := (not is_set(transform_left_filter_column_2(0), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_0_2_value := is_set(transform_left_filter_column_2(0), 3);
      if is_set(transform_left_filter_column_4(0), 0) then
        transform_left_filter_low_is_larger_0_0_4_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_0_4_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_4(0), 1) then
        transform_left_filter_low_is_larger_0_0_4_choices(2) := transform_left_filter_low_is_larger_0_0_4_choice;
      else
        transform_left_filter_low_is_larger_0_0_4_choices(2) := is_set(transform_left_filter_column_4(0), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_0_4_choices(2) then
        transform_left_filter_low_is_larger_0_0_4_choices(3) := (not is_set(transform_left_filter_column_4(0), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_0_4_choices(3) := (not is_set(transform_left_filter_column_4(0), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_0_4_value := is_set(transform_left_filter_column_4(0), 3);
      if is_set(transform_left_filter_column_0(2), 0) then
        transform_left_filter_low_is_larger_0_2_0_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_2_0_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_0(2), 1) then
        transform_left_filter_low_is_larger_0_2_0_choices(2) := transform_left_filter_low_is_larger_0_2_0_choice;
      else
        transform_left_filter_low_is_larger_0_2_0_choices(2) := is_set(transform_left_filter_column_0(2), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_2_0_choices(2) then
        transform_left_filter_low_is_larger_0_2_0_choices(3) := (not is_set(transform_left_filter_column_0(2), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_2_0_choices(3) := (not is_set(transform_left_filter_column_0(2), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_2_0_value := is_set(transform_left_filter_column_0(2), 3);
      if is_set(transform_left_filter_column_2(2), 0) then
        transform_left_filter_low_is_larger_0_2_2_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_2_2_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_2(2), 1) then
        transform_left_filter_low_is_larger_0_2_2_choices(2) := transform_left_filter_low_is_larger_0_2_2_choice;
      else
        transform_left_filter_low_is_larger_0_2_2_choices(2) := is_set(transform_left_filter_column_2(2), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_2_2_choices(2) then
        transform_left_filter_low_is_larger_0_2_2_choices(3) := (not is_set(transform_left_filter_column_2(2), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_2_2_choices(3) := (not is_set(transform_left_filter_column_2(2), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_2_2_value := is_set(transform_left_filter_column_2(2), 3);
      if is_set(transform_left_filter_column_4(2), 0) then
        transform_left_filter_low_is_larger_0_2_4_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_2_4_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_4(2), 1) then
        transform_left_filter_low_is_larger_0_2_4_choices(2) := transform_left_filter_low_is_larger_0_2_4_choice;
      else
        transform_left_filter_low_is_larger_0_2_4_choices(2) := is_set(transform_left_filter_column_4(2), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_2_4_choices(2) then
        transform_left_filter_low_is_larger_0_2_4_choices(3) := (not is_set(transform_left_filter_column_4(2), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_2_4_choices(3) := (not is_set(transform_left_filter_column_4(2), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_2_4_value := is_set(transform_left_filter_column_4(2), 3);
      if is_set(transform_left_filter_column_0(4), 0) then
        transform_left_filter_low_is_larger_0_4_0_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_4_0_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_0(4), 1) then
        transform_left_filter_low_is_larger_0_4_0_choices(2) := transform_left_filter_low_is_larger_0_4_0_choice;
      else
        transform_left_filter_low_is_larger_0_4_0_choices(2) := is_set(transform_left_filter_column_0(4), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_4_0_choices(2) then
        transform_left_filter_low_is_larger_0_4_0_choices(3) := (not is_set(transform_left_filter_column_0(4), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_4_0_choices(3) := (not is_set(transform_left_filter_column_0(4), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_4_0_value := is_set(transform_left_filter_column_0(4), 3);
      if is_set(transform_left_filter_column_4(4), 0) then
        transform_left_filter_low_is_larger_0_4_4_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_4_4_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_4(4), 1) then
        transform_left_filter_low_is_larger_0_4_4_choices(2) := transform_left_filter_low_is_larger_0_4_4_choice;
      else
        transform_left_filter_low_is_larger_0_4_4_choices(2) := is_set(transform_left_filter_column_4(4), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_4_4_choices(2) then
        transform_left_filter_low_is_larger_0_4_4_choices(3) := (not is_set(transform_left_filter_column_4(4), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_4_4_choices(3) := (not is_set(transform_left_filter_column_4(4), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_4_4_value := is_set(transform_left_filter_column_4(4), 3);
      if is_set(transform_left_filter_column_0(6), 0) then
        transform_left_filter_low_is_larger_0_6_0_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_6_0_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_0(6), 1) then
        transform_left_filter_low_is_larger_0_6_0_choices(2) := transform_left_filter_low_is_larger_0_6_0_choice;
      else
        transform_left_filter_low_is_larger_0_6_0_choices(2) := is_set(transform_left_filter_column_0(6), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_6_0_choices(2) then
        transform_left_filter_low_is_larger_0_6_0_choices(3) := (not is_set(transform_left_filter_column_0(6), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_6_0_choices(3) := (not is_set(transform_left_filter_column_0(6), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_6_0_value := is_set(transform_left_filter_column_0(6), 3);
      if is_set(transform_left_filter_column_2(6), 0) then
        transform_left_filter_low_is_larger_0_6_2_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_6_2_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_2(6), 1) then
        transform_left_filter_low_is_larger_0_6_2_choices(2) := transform_left_filter_low_is_larger_0_6_2_choice;
      else
        transform_left_filter_low_is_larger_0_6_2_choices(2) := is_set(transform_left_filter_column_2(6), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_6_2_choices(2) then
        transform_left_filter_low_is_larger_0_6_2_choices(3) := (not is_set(transform_left_filter_column_2(6), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_6_2_choices(3) := (not is_set(transform_left_filter_column_2(6), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_6_2_value := is_set(transform_left_filter_column_2(6), 3);
      if is_set(transform_left_filter_column_4(6), 0) then
        transform_left_filter_low_is_larger_0_6_4_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_6_4_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_4(6), 1) then
        transform_left_filter_low_is_larger_0_6_4_choices(2) := transform_left_filter_low_is_larger_0_6_4_choice;
      else
        transform_left_filter_low_is_larger_0_6_4_choices(2) := is_set(transform_left_filter_column_4(6), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_6_4_choices(2) then
        transform_left_filter_low_is_larger_0_6_4_choices(3) := (not is_set(transform_left_filter_column_4(6), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_6_4_choices(3) := (not is_set(transform_left_filter_column_4(6), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_6_4_value := is_set(transform_left_filter_column_4(6), 3);
      if is_set(transform_left_filter_column_0(8), 0) then
        transform_left_filter_low_is_larger_0_8_0_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_8_0_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_0(8), 1) then
        transform_left_filter_low_is_larger_0_8_0_choices(2) := transform_left_filter_low_is_larger_0_8_0_choice;
      else
        transform_left_filter_low_is_larger_0_8_0_choices(2) := is_set(transform_left_filter_column_0(8), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_8_0_choices(2) then
        transform_left_filter_low_is_larger_0_8_0_choices(3) := (not is_set(transform_left_filter_column_0(8), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_8_0_choices(3) := (not is_set(transform_left_filter_column_0(8), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_8_0_value := is_set(transform_left_filter_column_0(8), 3);
      if is_set(transform_left_filter_column_2(8), 0) then
        transform_left_filter_low_is_larger_0_8_2_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_8_2_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_2(8), 1) then
        transform_left_filter_low_is_larger_0_8_2_choices(2) := transform_left_filter_low_is_larger_0_8_2_choice;
      else
        transform_left_filter_low_is_larger_0_8_2_choices(2) := is_set(transform_left_filter_column_2(8), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_8_2_choices(2) then
        transform_left_filter_low_is_larger_0_8_2_choices(3) := (not is_set(transform_left_filter_column_2(8), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_8_2_choices(3) := (not is_set(transform_left_filter_column_2(8), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_8_2_value := is_set(transform_left_filter_column_2(8), 3);
      if is_set(transform_left_filter_column_4(8), 0) then
        transform_left_filter_low_is_larger_0_8_4_choice := transform_left_filter_low_is_larger_0_0_2_any;
      else
        transform_left_filter_low_is_larger_0_8_4_choice := not transform_left_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_left_filter_column_4(8), 1) then
        transform_left_filter_low_is_larger_0_8_4_choices(2) := transform_left_filter_low_is_larger_0_8_4_choice;
      else
        transform_left_filter_low_is_larger_0_8_4_choices(2) := is_set(transform_left_filter_column_4(8), 0) and
          transform_left_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_left_filter_low_is_larger_0_8_4_choices(2) then
        transform_left_filter_low_is_larger_0_8_4_choices(3) := (not is_set(transform_left_filter_column_4(8), 2)) and
          transform_left_filter_low_is_larger_0_0_0_values(2);
      else
        transform_left_filter_low_is_larger_0_8_4_choices(3) := (not is_set(transform_left_filter_column_4(8), 2)) or
          transform_left_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_left_filter_low_is_larger_0_8_4_value := is_set(transform_left_filter_column_4(8), 3);
      transform_left_filter_feature_0_value := is_set(transform_left_filter_column_2(4), 4);
      if is_set(transform_left_filter_column_0(0), 4) then
        transform_left_filter_feature_0_choice := (not transform_left_filter_low_is_larger_0_0_0) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choice := (not transform_left_filter_low_is_larger_0_0_0) or
          transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_values(2) := is_set(transform_left_filter_column_2(4), 5);
      if transform_left_filter_feature_0_choice then
        transform_left_filter_feature_0_choices(2) := (not is_set(transform_left_filter_column_0(0), 5)) or
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices(2) := (not is_set(transform_left_filter_column_0(0), 5)) and
          transform_left_filter_feature_0_values(2);
      end if;
      transform_left_filter_feature_0_values(3) := is_set(transform_left_filter_column_2(4), 6);
      if transform_left_filter_feature_0_choices(2) then
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column_0(0), 6)) or
          transform_left_filter_feature_0_values(3);
      else
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column_0(0), 6)) and
          transform_left_filter_feature_0_values(3);
      end if;
      transform_left_filter_feature_0_all := transform_filtering_0_column_inside_0 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_0(0), 7) then
        transform_left_filter_feature_0_choices(4) := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choices(4) := transform_left_filter_feature_0_all;
      end if;
      if transform_left_filter_feature_0_choices(3) then
        transform_left_filter_feature_0_choices(5) := is_set(transform_left_filter_column_0(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(5) := transform_left_filter_feature_0_choices(4);
      end if;
      if is_set(transform_left_filter_column_2(0), 4) then
        transform_left_filter_feature_0_choices(6) := (not transform_left_filter_low_is_larger_0_0_2) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(6) := (not transform_left_filter_low_is_larger_0_0_2) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 6 to 7 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_2(0), i - 1)) or
            transform_left_filter_feature_0_values(i - 4);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_2(0), i - 1)) and
            transform_left_filter_feature_0_values(i - 4);
        end if;
      end loop;
      if is_set(transform_left_filter_column_2(0), 7) then
        transform_left_filter_feature_0_choices(9) := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choices(9) := transform_left_filter_feature_0_all;
      end if;
      if transform_left_filter_feature_0_choices(8) then
        transform_left_filter_feature_0_choices(10) := is_set(transform_left_filter_column_2(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(10) := transform_left_filter_feature_0_choices(9);
      end if;
      if is_set(transform_left_filter_column_4(0), 4) then
        transform_left_filter_feature_0_choices(11) := (not transform_left_filter_low_is_larger_0_0_4) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(11) := (not transform_left_filter_low_is_larger_0_0_4) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 11 to 12 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(0), i - 6)) or
            transform_left_filter_feature_0_values(i - 9);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(0), i - 6)) and
            transform_left_filter_feature_0_values(i - 9);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(13) then
        transform_left_filter_feature_0_choices(14) := transform_filtering_0_column_inside_0 and
          is_set(transform_left_filter_column_4(0), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(14) := transform_filtering_0_column_inside_0 and
          (is_set(transform_left_filter_column_4(0), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(2), 4) then
        transform_left_filter_feature_0_choices(15) := (not transform_left_filter_low_is_larger_0_2_2) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(15) := (not transform_left_filter_low_is_larger_0_2_2) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 15 to 16 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_2(2), i - 10)) or
            transform_left_filter_feature_0_values(i - 13);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_2(2), i - 10)) and
            transform_left_filter_feature_0_values(i - 13);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(2) := transform_filtering_0_column_inside_2 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(2), 7) then
        transform_left_filter_feature_0_choices(18) := transform_filtering_0_column_inside_2;
      else
        transform_left_filter_feature_0_choices(18) := transform_left_filter_feature_0_alls(2);
      end if;
      if transform_left_filter_feature_0_choices(17) then
        transform_left_filter_feature_0_choices(19) := is_set(transform_left_filter_column_2(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(19) := transform_left_filter_feature_0_choices(18);
      end if;
      if is_set(transform_left_filter_column_0(2), 4) then
        transform_left_filter_feature_0_choices(20) := (not transform_left_filter_low_is_larger_0_2_0) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(20) := (not transform_left_filter_low_is_larger_0_2_0) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 20 to 21 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(2), i - 15)) or
            transform_left_filter_feature_0_values(i - 18);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(2), i - 15)) and
            transform_left_filter_feature_0_values(i - 18);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(2), 7) then
        transform_left_filter_feature_0_choices(23) := transform_filtering_0_column_inside_2;
      else
        transform_left_filter_feature_0_choices(23) := transform_left_filter_feature_0_alls(2);
      end if;
      if transform_left_filter_feature_0_choices(22) then
        transform_left_filter_feature_0_choices(24) := is_set(transform_left_filter_column_0(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(24) := transform_left_filter_feature_0_choices(23);
      end if;
      if is_set(transform_left_filter_column_4(2), 4) then
        transform_left_filter_feature_0_choices(25) := (not transform_left_filter_low_is_larger_0_2_4) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(25) := (not transform_left_filter_low_is_larger_0_2_4) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 25 to 26 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(2), i - 20)) or
            transform_left_filter_feature_0_values(i - 23);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(2), i - 20)) and
            transform_left_filter_feature_0_values(i - 23);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(27) then
        transform_left_filter_feature_0_choices(28) := transform_filtering_0_column_inside_2 and
          is_set(transform_left_filter_column_4(2), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(28) := transform_filtering_0_column_inside_2 and
          (is_set(transform_left_filter_column_4(2), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_0(4), 4) then
        transform_left_filter_feature_0_choices(29) := (not transform_left_filter_low_is_larger_0_4_0) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(29) := (not transform_left_filter_low_is_larger_0_4_0) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 29 to 30 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(4), i - 24)) or
            transform_left_filter_feature_0_values(i - 27);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(4), i - 24)) and
            transform_left_filter_feature_0_values(i - 27);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(4), 7) then
        transform_left_filter_feature_0_choices(32) := transform_filtering_0_column_inside_4;
      else
        transform_left_filter_feature_0_choices(32) := transform_filtering_0_column_inside_4 and (not
          is_set(transform_left_filter_column_2(4), 7));
      end if;
      if transform_left_filter_feature_0_choices(31) then
        transform_left_filter_feature_0_choices(33) := is_set(transform_left_filter_column_0(4), 7) and
          transform_filtering_0_column_inside_4 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(33) := transform_left_filter_feature_0_choices(32);
      end if;
      if is_set(transform_left_filter_column_4(4), 4) then
        transform_left_filter_feature_0_choices(34) := (not transform_left_filter_low_is_larger_0_4_4) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(34) := (not transform_left_filter_low_is_larger_0_4_4) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 34 to 35 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(4), i - 29)) or
            transform_left_filter_feature_0_values(i - 32);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(4), i - 29)) and
            transform_left_filter_feature_0_values(i - 32);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(36) then
        transform_left_filter_feature_0_choices(37) := transform_filtering_0_column_inside_4 and
          is_set(transform_left_filter_column_4(4), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(37) := transform_filtering_0_column_inside_4 and
          (is_set(transform_left_filter_column_4(4), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(6), 4) then
        transform_left_filter_feature_0_choices(38) := (not transform_left_filter_low_is_larger_0_6_2) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(38) := (not transform_left_filter_low_is_larger_0_6_2) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 38 to 39 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_2(6), i - 33)) or
            transform_left_filter_feature_0_values(i - 36);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_2(6), i - 33)) and
            transform_left_filter_feature_0_values(i - 36);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(3) := transform_filtering_0_column_inside_6 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(6), 7) then
        transform_left_filter_feature_0_choices(41) := transform_filtering_0_column_inside_6;
      else
        transform_left_filter_feature_0_choices(41) := transform_left_filter_feature_0_alls(3);
      end if;
      if transform_left_filter_feature_0_choices(40) then
        transform_left_filter_feature_0_choices(42) := is_set(transform_left_filter_column_2(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(42) := transform_left_filter_feature_0_choices(41);
      end if;
      if is_set(transform_left_filter_column_0(6), 4) then
        transform_left_filter_feature_0_choices(43) := (not transform_left_filter_low_is_larger_0_6_0) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(43) := (not transform_left_filter_low_is_larger_0_6_0) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 43 to 44 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(6), i - 38)) or
            transform_left_filter_feature_0_values(i - 41);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(6), i - 38)) and
            transform_left_filter_feature_0_values(i - 41);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(6), 7) then
        transform_left_filter_feature_0_choices(46) := transform_filtering_0_column_inside_6;
      else
        transform_left_filter_feature_0_choices(46) := transform_left_filter_feature_0_alls(3);
      end if;
      if transform_left_filter_feature_0_choices(45) then
        transform_left_filter_feature_0_choices(47) := is_set(transform_left_filter_column_0(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(47) := transform_left_filter_feature_0_choices(46);
      end if;
      if is_set(transform_left_filter_column_4(6), 4) then
        transform_left_filter_feature_0_choices(48) := (not transform_left_filter_low_is_larger_0_6_4) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(48) := (not transform_left_filter_low_is_larger_0_6_4) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 48 to 49 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(6), i - 43)) or
            transform_left_filter_feature_0_values(i - 46);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(6), i - 43)) and
            transform_left_filter_feature_0_values(i - 46);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(50) then
        transform_left_filter_feature_0_choices(51) := transform_filtering_0_column_inside_6 and
          is_set(transform_left_filter_column_4(6), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(51) := transform_filtering_0_column_inside_6 and
          (is_set(transform_left_filter_column_4(6), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(8), 4) then
        transform_left_filter_feature_0_choices(52) := (not transform_left_filter_low_is_larger_0_8_2) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(52) := (not transform_left_filter_low_is_larger_0_8_2) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 52 to 53 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_2(8), i - 47)) or
            transform_left_filter_feature_0_values(i - 50);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_2(8), i - 47)) and
            transform_left_filter_feature_0_values(i - 50);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(4) := transform_filtering_0_column_inside_8 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(8), 7) then
        transform_left_filter_feature_0_choices(55) := transform_filtering_0_column_inside_8;
      else
        transform_left_filter_feature_0_choices(55) := transform_left_filter_feature_0_alls(4);
      end if;
      if transform_left_filter_feature_0_choices(54) then
        transform_left_filter_feature_0_choices(56) := is_set(transform_left_filter_column_2(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(56) := transform_left_filter_feature_0_choices(55);
      end if;
      if is_set(transform_left_filter_column_0(8), 4) then
        transform_left_filter_feature_0_choices(57) := (not transform_left_filter_low_is_larger_0_8_0) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(57) := (not transform_left_filter_low_is_larger_0_8_0) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 57 to 58 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(8), i - 52)) or
            transform_left_filter_feature_0_values(i - 55);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(8), i - 52)) and
            transform_left_filter_feature_0_values(i - 55);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(8), 7) then
        transform_left_filter_feature_0_choices(60) := transform_filtering_0_column_inside_8;
      else
        transform_left_filter_feature_0_choices(60) := transform_left_filter_feature_0_alls(4);
      end if;
      if transform_left_filter_feature_0_choices(59) then
        transform_left_filter_feature_0_choices(61) := is_set(transform_left_filter_column_0(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(61) := transform_left_filter_feature_0_choices(60);
      end if;
      if is_set(transform_left_filter_column_4(8), 4) then
        transform_left_filter_feature_0_choices(62) := (not transform_left_filter_low_is_larger_0_8_4) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(62) := (not transform_left_filter_low_is_larger_0_8_4) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 62 to 63 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(8), i - 57)) or
            transform_left_filter_feature_0_values(i - 60);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(8), i - 57)) and
            transform_left_filter_feature_0_values(i - 60);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(64) then
        transform_left_filter_feature_0_choices(65) := transform_filtering_0_column_inside_8 and
          is_set(transform_left_filter_column_4(8), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(65) := transform_filtering_0_column_inside_8 and
          (is_set(transform_left_filter_column_4(8), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      transform_right_filter_low_is_larger_0_0_0_value := is_set(transform_right_filter_column_2(4), 1);
      if is_set(transform_right_filter_column_2(4), 0) then
        transform_right_filter_low_is_larger_0_0_0_choice := not is_set(transform_right_filter_column_0(0), 1);
      else
        transform_right_filter_low_is_larger_0_0_0_choice := (transform_right_filter_column_0(0) mod 4) = 0;
      end if;
      if transform_right_filter_low_is_larger_0_0_0_value then
        transform_right_filter_low_is_larger_0_0_0_choices(2) := is_set(transform_right_filter_column_2(4), 0) or (not
          is_set(transform_right_filter_column_0(0), 1)) or (not is_set(transform_right_filter_column_0(0), 0));
      else
        transform_right_filter_low_is_larger_0_0_0_choices(2) := transform_right_filter_low_is_larger_0_0_0_choice;
      end if;
      transform_right_filter_low_is_larger_0_0_0_values(2) := is_set(transform_right_filter_column_2(4), 2);
      transform_right_filter_low_is_larger_0_0_0_values(3) := is_set(transform_right_filter_column_0(0), 2);
      if transform_right_filter_low_is_larger_0_0_0_choices(2) then
        transform_right_filter_low_is_larger_0_0_0_choices(3) := (not
          transform_right_filter_low_is_larger_0_0_0_values(2)) and
          transform_right_filter_low_is_larger_0_0_0_values(3);
      else
        transform_right_filter_low_is_larger_0_0_0_choices(3) := (not
          transform_right_filter_low_is_larger_0_0_0_values(2)) or transform_right_filter_low_is_larger_0_0_0_values(3);
      end if;
      transform_right_filter_low_is_larger_0_0_0_values(4) := is_set(transform_right_filter_column_0(0), 3);
      transform_right_filter_low_is_larger_0_0_2_any := (not transform_right_filter_low_is_larger_0_0_0_value) or (not
        is_set(transform_right_filter_column_2(4), 0));
      if is_set(transform_right_filter_column_2(0), 0) then
        transform_right_filter_low_is_larger_0_0_2_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_0_2_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      transform_right_filter_low_is_larger_0_0_2_is_equal := (transform_right_filter_column_2(4) mod 4) = 0;
      if is_set(transform_right_filter_column_2(0), 1) then
        transform_right_filter_low_is_larger_0_0_2_choices(2) := transform_right_filter_low_is_larger_0_0_2_choice;
      else
        transform_right_filter_low_is_larger_0_0_2_choices(2) := is_set(transform_right_filter_column_2(0), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_0_2_choices(2) then
        transform_right_filter_low_is_larger_0_0_2_choices(3) := (not is_set(transform_right_filter_column_2(0), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_0_2_choices(3) := (not is_set(transform_right_filter_column_2(0), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_0_2_value := is_set(transform_right_filter_column_2(0), 3);
      if is_set(transform_right_filter_column_4(0), 0) then
        transform_right_filter_low_is_larger_0_0_4_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_0_4_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_4(0), 1) then
        transform_right_filter_low_is_larger_0_0_4_choices(2) := transform_right_filter_low_is_larger_0_0_4_choice;
      else
        transform_right_filter_low_is_larger_0_0_4_choices(2) := is_set(transform_right_filter_column_4(0), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_0_4_choices(2) then
        transform_right_filter_low_is_larger_0_0_4_choices(3) := (not is_set(transform_right_filter_column_4(0), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_0_4_choices(3) := (not is_set(transform_right_filter_column_4(0), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_0_4_value := is_set(transform_right_filter_column_4(0), 3);
      if is_set(transform_right_filter_column_0(2), 0) then
        transform_right_filter_low_is_larger_0_2_0_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_2_0_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_0(2), 1) then
        transform_right_filter_low_is_larger_0_2_0_choices(2) := transform_right_filter_low_is_larger_0_2_0_choice;
      else
        transform_right_filter_low_is_larger_0_2_0_choices(2) := is_set(transform_right_filter_column_0(2), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_2_0_choices(2) then
        transform_right_filter_low_is_larger_0_2_0_choices(3) := (not is_set(transform_right_filter_column_0(2), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_2_0_choices(3) := (not is_set(transform_right_filter_column_0(2), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_2_0_value := is_set(transform_right_filter_column_0(2), 3);
      if is_set(transform_right_filter_column_2(2), 0) then
        transform_right_filter_low_is_larger_0_2_2_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_2_2_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_2(2), 1) then
        transform_right_filter_low_is_larger_0_2_2_choices(2) := transform_right_filter_low_is_larger_0_2_2_choice;
      else
        transform_right_filter_low_is_larger_0_2_2_choices(2) := is_set(transform_right_filter_column_2(2), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_2_2_choices(2) then
        transform_right_filter_low_is_larger_0_2_2_choices(3) := (not is_set(transform_right_filter_column_2(2), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_2_2_choices(3) := (not is_set(transform_right_filter_column_2(2), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_2_2_value := is_set(transform_right_filter_column_2(2), 3);
      if is_set(transform_right_filter_column_4(2), 0) then
        transform_right_filter_low_is_larger_0_2_4_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_2_4_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_4(2), 1) then
        transform_right_filter_low_is_larger_0_2_4_choices(2) := transform_right_filter_low_is_larger_0_2_4_choice;
      else
        transform_right_filter_low_is_larger_0_2_4_choices(2) := is_set(transform_right_filter_column_4(2), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_2_4_choices(2) then
        transform_right_filter_low_is_larger_0_2_4_choices(3) := (not is_set(transform_right_filter_column_4(2), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_2_4_choices(3) := (not is_set(transform_right_filter_column_4(2), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_2_4_value := is_set(transform_right_filter_column_4(2), 3);
      if is_set(transform_right_filter_column_0(4), 0) then
        transform_right_filter_low_is_larger_0_4_0_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_4_0_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_0(4), 1) then
        transform_right_filter_low_is_larger_0_4_0_choices(2) := transform_right_filter_low_is_larger_0_4_0_choice;
      else
        transform_right_filter_low_is_larger_0_4_0_choices(2) := is_set(transform_right_filter_column_0(4), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_4_0_choices(2) then
        transform_right_filter_low_is_larger_0_4_0_choices(3) := (not is_set(transform_right_filter_column_0(4), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_4_0_choices(3) := (not is_set(transform_right_filter_column_0(4), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_4_0_value := is_set(transform_right_filter_column_0(4), 3);
      if is_set(transform_right_filter_column_4(4), 0) then
        transform_right_filter_low_is_larger_0_4_4_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_4_4_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_4(4), 1) then
        transform_right_filter_low_is_larger_0_4_4_choices(2) := transform_right_filter_low_is_larger_0_4_4_choice;
      else
        transform_right_filter_low_is_larger_0_4_4_choices(2) := is_set(transform_right_filter_column_4(4), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_4_4_choices(2) then
        transform_right_filter_low_is_larger_0_4_4_choices(3) := (not is_set(transform_right_filter_column_4(4), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_4_4_choices(3) := (not is_set(transform_right_filter_column_4(4), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_4_4_value := is_set(transform_right_filter_column_4(4), 3);
      if is_set(transform_right_filter_column_0(6), 0) then
        transform_right_filter_low_is_larger_0_6_0_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_6_0_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_0(6), 1) then
        transform_right_filter_low_is_larger_0_6_0_choices(2) := transform_right_filter_low_is_larger_0_6_0_choice;
      else
        transform_right_filter_low_is_larger_0_6_0_choices(2) := is_set(transform_right_filter_column_0(6), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_6_0_choices(2) then
        transform_right_filter_low_is_larger_0_6_0_choices(3) := (not is_set(transform_right_filter_column_0(6), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_6_0_choices(3) := (not is_set(transform_right_filter_column_0(6), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_6_0_value := is_set(transform_right_filter_column_0(6), 3);
      if is_set(transform_right_filter_column_2(6), 0) then
        transform_right_filter_low_is_larger_0_6_2_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_6_2_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_2(6), 1) then
        transform_right_filter_low_is_larger_0_6_2_choices(2) := transform_right_filter_low_is_larger_0_6_2_choice;
      else
        transform_right_filter_low_is_larger_0_6_2_choices(2) := is_set(transform_right_filter_column_2(6), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_6_2_choices(2) then
        transform_right_filter_low_is_larger_0_6_2_choices(3) := (not is_set(transform_right_filter_column_2(6), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_6_2_choices(3) := (not is_set(transform_right_filter_column_2(6), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_6_2_value := is_set(transform_right_filter_column_2(6), 3);
      if is_set(transform_right_filter_column_4(6), 0) then
        transform_right_filter_low_is_larger_0_6_4_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_6_4_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_4(6), 1) then
        transform_right_filter_low_is_larger_0_6_4_choices(2) := transform_right_filter_low_is_larger_0_6_4_choice;
      else
        transform_right_filter_low_is_larger_0_6_4_choices(2) := is_set(transform_right_filter_column_4(6), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_6_4_choices(2) then
        transform_right_filter_low_is_larger_0_6_4_choices(3) := (not is_set(transform_right_filter_column_4(6), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_6_4_choices(3) := (not is_set(transform_right_filter_column_4(6), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_6_4_value := is_set(transform_right_filter_column_4(6), 3);
      if is_set(transform_right_filter_column_0(8), 0) then
        transform_right_filter_low_is_larger_0_8_0_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_8_0_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_0(8), 1) then
        transform_right_filter_low_is_larger_0_8_0_choices(2) := transform_right_filter_low_is_larger_0_8_0_choice;
      else
        transform_right_filter_low_is_larger_0_8_0_choices(2) := is_set(transform_right_filter_column_0(8), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_8_0_choices(2) then
        transform_right_filter_low_is_larger_0_8_0_choices(3) := (not is_set(transform_right_filter_column_0(8), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_8_0_choices(3) := (not is_set(transform_right_filter_column_0(8), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_8_0_value := is_set(transform_right_filter_column_0(8), 3);
      if is_set(transform_right_filter_column_2(8), 0) then
        transform_right_filter_low_is_larger_0_8_2_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_8_2_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_2(8), 1) then
        transform_right_filter_low_is_larger_0_8_2_choices(2) := transform_right_filter_low_is_larger_0_8_2_choice;
      else
        transform_right_filter_low_is_larger_0_8_2_choices(2) := is_set(transform_right_filter_column_2(8), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_8_2_choices(2) then
        transform_right_filter_low_is_larger_0_8_2_choices(3) := (not is_set(transform_right_filter_column_2(8), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_8_2_choices(3) := (not is_set(transform_right_filter_column_2(8), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_8_2_value := is_set(transform_right_filter_column_2(8), 3);
      if is_set(transform_right_filter_column_4(8), 0) then
        transform_right_filter_low_is_larger_0_8_4_choice := transform_right_filter_low_is_larger_0_0_2_any;
      else
        transform_right_filter_low_is_larger_0_8_4_choice := not transform_right_filter_low_is_larger_0_0_0_value;
      end if;
      if is_set(transform_right_filter_column_4(8), 1) then
        transform_right_filter_low_is_larger_0_8_4_choices(2) := transform_right_filter_low_is_larger_0_8_4_choice;
      else
        transform_right_filter_low_is_larger_0_8_4_choices(2) := is_set(transform_right_filter_column_4(8), 0) and
          transform_right_filter_low_is_larger_0_0_2_is_equal;
      end if;
      if transform_right_filter_low_is_larger_0_8_4_choices(2) then
        transform_right_filter_low_is_larger_0_8_4_choices(3) := (not is_set(transform_right_filter_column_4(8), 2))
          and transform_right_filter_low_is_larger_0_0_0_values(2);
      else
        transform_right_filter_low_is_larger_0_8_4_choices(3) := (not is_set(transform_right_filter_column_4(8), 2)) or
          transform_right_filter_low_is_larger_0_0_0_values(2);
      end if;
      transform_right_filter_low_is_larger_0_8_4_value := is_set(transform_right_filter_column_4(8), 3);
      transform_right_filter_feature_0_value := is_set(transform_right_filter_column_2(4), 4);
      if is_set(transform_right_filter_column_0(0), 4) then
        transform_right_filter_feature_0_choice := (not transform_right_filter_low_is_larger_0_0_0) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choice := (not transform_right_filter_low_is_larger_0_0_0) or
          transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_values(2) := is_set(transform_right_filter_column_2(4), 5);
      if transform_right_filter_feature_0_choice then
        transform_right_filter_feature_0_choices(2) := (not is_set(transform_right_filter_column_0(0), 5)) or
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices(2) := (not is_set(transform_right_filter_column_0(0), 5)) and
          transform_right_filter_feature_0_values(2);
      end if;
      transform_right_filter_feature_0_values(3) := is_set(transform_right_filter_column_2(4), 6);
      if transform_right_filter_feature_0_choices(2) then
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column_0(0), 6)) or
          transform_right_filter_feature_0_values(3);
      else
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column_0(0), 6)) and
          transform_right_filter_feature_0_values(3);
      end if;
      transform_right_filter_feature_0_all := (not is_set(transform_right_filter_column_2(4), 7)) and
        transform_filtering_0_column_inside_0;
      if is_set(transform_right_filter_column_0(0), 7) then
        transform_right_filter_feature_0_choices(4) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices(4) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices(3) then
        transform_right_filter_feature_0_choices(5) := is_set(transform_right_filter_column_0(0), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices(5) := transform_right_filter_feature_0_choices(4);
      end if;
      if is_set(transform_right_filter_column_2(0), 4) then
        transform_right_filter_feature_0_choices(6) := (not transform_right_filter_low_is_larger_0_0_2) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(6) := (not transform_right_filter_low_is_larger_0_0_2) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 6 to 7 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_2(0), i - 1)) or
            transform_right_filter_feature_0_values(i - 4);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_2(0), i - 1))
            and transform_right_filter_feature_0_values(i - 4);
        end if;
      end loop;
      if is_set(transform_right_filter_column_2(0), 7) then
        transform_right_filter_feature_0_choices(9) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices(9) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices(8) then
        transform_right_filter_feature_0_choices(10) := is_set(transform_right_filter_column_2(0), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices(10) := transform_right_filter_feature_0_choices(9);
      end if;
      if is_set(transform_right_filter_column_4(0), 4) then
        transform_right_filter_feature_0_choices(11) := (not transform_right_filter_low_is_larger_0_0_4) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(11) := (not transform_right_filter_low_is_larger_0_0_4) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 11 to 12 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(0), i - 6)) or
            transform_right_filter_feature_0_values(i - 9);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(0), i - 6))
            and transform_right_filter_feature_0_values(i - 9);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(0), 7) then
        transform_right_filter_feature_0_choices(14) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices(14) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices(13) then
        transform_right_filter_feature_0_choices(15) := is_set(transform_right_filter_column_4(0), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices(15) := transform_right_filter_feature_0_choices(14);
      end if;
      if is_set(transform_right_filter_column_2(2), 4) then
        transform_right_filter_feature_0_choices(16) := (not transform_right_filter_low_is_larger_0_2_2) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(16) := (not transform_right_filter_low_is_larger_0_2_2) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 16 to 17 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_2(2), i - 11))
            or transform_right_filter_feature_0_values(i - 14);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_2(2), i - 11))
            and transform_right_filter_feature_0_values(i - 14);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(2) := (not is_set(transform_right_filter_column_2(4), 7)) and
        transform_filtering_0_column_inside_2;
      if is_set(transform_right_filter_column_2(2), 7) then
        transform_right_filter_feature_0_choices(19) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices(19) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices(18) then
        transform_right_filter_feature_0_choices(20) := is_set(transform_right_filter_column_2(2), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices(20) := transform_right_filter_feature_0_choices(19);
      end if;
      if is_set(transform_right_filter_column_0(2), 4) then
        transform_right_filter_feature_0_choices(21) := (not transform_right_filter_low_is_larger_0_2_0) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(21) := (not transform_right_filter_low_is_larger_0_2_0) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 21 to 22 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(2), i - 16))
            or transform_right_filter_feature_0_values(i - 19);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(2), i - 16))
            and transform_right_filter_feature_0_values(i - 19);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(2), 7) then
        transform_right_filter_feature_0_choices(24) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices(24) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices(23) then
        transform_right_filter_feature_0_choices(25) := is_set(transform_right_filter_column_0(2), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices(25) := transform_right_filter_feature_0_choices(24);
      end if;
      if is_set(transform_right_filter_column_4(2), 4) then
        transform_right_filter_feature_0_choices(26) := (not transform_right_filter_low_is_larger_0_2_4) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(26) := (not transform_right_filter_low_is_larger_0_2_4) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 26 to 27 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(2), i - 21))
            or transform_right_filter_feature_0_values(i - 24);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(2), i - 21))
            and transform_right_filter_feature_0_values(i - 24);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(2), 7) then
        transform_right_filter_feature_0_choices(29) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices(29) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices(28) then
        transform_right_filter_feature_0_choices(30) := is_set(transform_right_filter_column_4(2), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices(30) := transform_right_filter_feature_0_choices(29);
      end if;
      if is_set(transform_right_filter_column_0(4), 4) then
        transform_right_filter_feature_0_choices(31) := (not transform_right_filter_low_is_larger_0_4_0) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(31) := (not transform_right_filter_low_is_larger_0_4_0) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 31 to 32 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(4), i - 26))
            or transform_right_filter_feature_0_values(i - 29);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(4), i - 26))
            and transform_right_filter_feature_0_values(i - 29);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(3) := (not is_set(transform_right_filter_column_2(4), 7)) and
        transform_filtering_0_column_inside_4;
      if is_set(transform_right_filter_column_0(4), 7) then
        transform_right_filter_feature_0_choices(34) := transform_filtering_0_column_inside_4;
      else
        transform_right_filter_feature_0_choices(34) := transform_right_filter_feature_0_alls(3);
      end if;
      if transform_right_filter_feature_0_choices(33) then
        transform_right_filter_feature_0_choices(35) := is_set(transform_right_filter_column_0(4), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_4;
      else
        transform_right_filter_feature_0_choices(35) := transform_right_filter_feature_0_choices(34);
      end if;
      if is_set(transform_right_filter_column_4(4), 4) then
        transform_right_filter_feature_0_choices(36) := (not transform_right_filter_low_is_larger_0_4_4) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(36) := (not transform_right_filter_low_is_larger_0_4_4) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 36 to 37 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(4), i - 31))
            or transform_right_filter_feature_0_values(i - 34);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(4), i - 31))
            and transform_right_filter_feature_0_values(i - 34);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(4), 7) then
        transform_right_filter_feature_0_choices(39) := transform_filtering_0_column_inside_4;
      else
        transform_right_filter_feature_0_choices(39) := transform_right_filter_feature_0_alls(3);
      end if;
      if transform_right_filter_feature_0_choices(38) then
        transform_right_filter_feature_0_choices(40) := is_set(transform_right_filter_column_4(4), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_4;
      else
        transform_right_filter_feature_0_choices(40) := transform_right_filter_feature_0_choices(39);
      end if;
      if is_set(transform_right_filter_column_2(6), 4) then
        transform_right_filter_feature_0_choices(41) := (not transform_right_filter_low_is_larger_0_6_2) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(41) := (not transform_right_filter_low_is_larger_0_6_2) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 41 to 42 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_2(6), i - 36))
            or transform_right_filter_feature_0_values(i - 39);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_2(6), i - 36))
            and transform_right_filter_feature_0_values(i - 39);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(4) := (not is_set(transform_right_filter_column_2(4), 7)) and
        transform_filtering_0_column_inside_6;
      if is_set(transform_right_filter_column_2(6), 7) then
        transform_right_filter_feature_0_choices(44) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices(44) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices(43) then
        transform_right_filter_feature_0_choices(45) := is_set(transform_right_filter_column_2(6), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices(45) := transform_right_filter_feature_0_choices(44);
      end if;
      if is_set(transform_right_filter_column_0(6), 4) then
        transform_right_filter_feature_0_choices(46) := (not transform_right_filter_low_is_larger_0_6_0) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(46) := (not transform_right_filter_low_is_larger_0_6_0) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 46 to 47 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(6), i - 41))
            or transform_right_filter_feature_0_values(i - 44);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(6), i - 41))
            and transform_right_filter_feature_0_values(i - 44);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(6), 7) then
        transform_right_filter_feature_0_choices(49) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices(49) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices(48) then
        transform_right_filter_feature_0_choices(50) := is_set(transform_right_filter_column_0(6), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices(50) := transform_right_filter_feature_0_choices(49);
      end if;
      if is_set(transform_right_filter_column_4(6), 4) then
        transform_right_filter_feature_0_choices(51) := (not transform_right_filter_low_is_larger_0_6_4) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(51) := (not transform_right_filter_low_is_larger_0_6_4) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 51 to 52 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(6), i - 46))
            or transform_right_filter_feature_0_values(i - 49);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(6), i - 46))
            and transform_right_filter_feature_0_values(i - 49);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(6), 7) then
        transform_right_filter_feature_0_choices(54) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices(54) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices(53) then
        transform_right_filter_feature_0_choices(55) := is_set(transform_right_filter_column_4(6), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices(55) := transform_right_filter_feature_0_choices(54);
      end if;
      if is_set(transform_right_filter_column_2(8), 4) then
        transform_right_filter_feature_0_choices(56) := (not transform_right_filter_low_is_larger_0_8_2) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(56) := (not transform_right_filter_low_is_larger_0_8_2) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 56 to 57 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_2(8), i - 51))
            or transform_right_filter_feature_0_values(i - 54);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_2(8), i - 51))
            and transform_right_filter_feature_0_values(i - 54);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(5) := (not is_set(transform_right_filter_column_2(4), 7)) and
        transform_filtering_0_column_inside_8;
      if is_set(transform_right_filter_column_2(8), 7) then
        transform_right_filter_feature_0_choices(59) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices(59) := transform_right_filter_feature_0_alls(5);
      end if;
      if transform_right_filter_feature_0_choices(58) then
        transform_right_filter_feature_0_choices(60) := is_set(transform_right_filter_column_2(8), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices(60) := transform_right_filter_feature_0_choices(59);
      end if;
      if is_set(transform_right_filter_column_0(8), 4) then
        transform_right_filter_feature_0_choices(61) := (not transform_right_filter_low_is_larger_0_8_0) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(61) := (not transform_right_filter_low_is_larger_0_8_0) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 61 to 62 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(8), i - 56))
            or transform_right_filter_feature_0_values(i - 59);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(8), i - 56))
            and transform_right_filter_feature_0_values(i - 59);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(8), 7) then
        transform_right_filter_feature_0_choices(64) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices(64) := transform_right_filter_feature_0_alls(5);
      end if;
      if transform_right_filter_feature_0_choices(63) then
        transform_right_filter_feature_0_choices(65) := is_set(transform_right_filter_column_0(8), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices(65) := transform_right_filter_feature_0_choices(64);
      end if;
      if is_set(transform_right_filter_column_4(8), 4) then
        transform_right_filter_feature_0_choices(66) := (not transform_right_filter_low_is_larger_0_8_4) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(66) := (not transform_right_filter_low_is_larger_0_8_4) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 66 to 67 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(8), i - 61))
            or transform_right_filter_feature_0_values(i - 64);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(8), i - 61))
            and transform_right_filter_feature_0_values(i - 64);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(8), 7) then
        transform_right_filter_feature_0_choices(69) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices(69) := transform_right_filter_feature_0_alls(5);
      end if;
      if transform_right_filter_feature_0_choices(68) then
        transform_right_filter_feature_0_choices(70) := is_set(transform_right_filter_column_4(8), 7) and (not
          is_set(transform_right_filter_column_2(4), 7)) and transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices(70) := transform_right_filter_feature_0_choices(69);
      end if;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_counter_next_frame <= transform_counter_next_frame_is_equal and (transform_counter_group = 239);
      transform_counter_last_column <= transform_counter_next_frame_is_equal;
      transform_counter_counts <= ((transform_counter_group mod 16) /= 2) or ((transform_counter_group / 16) /= 15);
      transform_counter_back_to_back <= winnerswinner1_best_below_0 and (transform_counter_group = 241);
      transform_counter_next_frame_after <= transform_counter_next_frame_after_any and
        transform_counter_next_frame_after_is_equal;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_column_inside_0 <= transform_read_column_inside_0_is_less;
      transform_read_column_inside_2 <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_4 <= true;
      transform_read_column_inside_6 <= (transform_counter_column < 6) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_8 <= (transform_counter_column < 8) /= transform_read_column_inside_0_is_less;
      transform_read_start_of_frame <= (transform_counter_column = 4) and (transform_counter_group = 2);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_reached_first_0 and (not transform_counter_next_frame_after);
      transform_ready_row_inside_2 <= transform_reached_first_2 and (not transform_reached_beyond_last(3));
      transform_ready_row_inside_4 <= transform_read_column_inside_4 and (not transform_reached_beyond_last(2));
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_column_inside_4 <= transform_reached_first_4;
      transform_ready_column_inside_6 <= transform_read_column_inside_6;
      transform_ready_column_inside_8 <= transform_read_column_inside_8;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_reached_first_0 <= (((transform_counter_group / 4) mod 16) /= 0) or is_set(transform_counter_group, 7)
        or transform_reached_first_0_value;
      transform_reached_first_2 <= (((transform_counter_group / 2) mod 16) /= 0) or is_set(transform_counter_group, 7)
        or transform_reached_first_0_value or is_set(transform_counter_group, 5);
      transform_reached_first_4 <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
      transform_reached_beyond_last(2) <= transform_counter_next_frame_after_is_equal;
      transform_reached_beyond_last(3) <= transform_reached_beyond_last_3_choice and ((transform_counter_group / 32) =
        7);
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
      transform_left_filter_feature_0 <= as_number(transform_left_filter_feature_0_choices(5)) +
        (as_number(transform_left_filter_feature_0_choices(10)) * 2) +
        (as_number(transform_left_filter_feature_0_choices(14)) * 4) +
        (as_number(transform_left_filter_feature_0_choices(19)) * 16) +
        (as_number(transform_left_filter_feature_0_choices(24)) * 8) +
        (as_number(transform_left_filter_feature_0_choices(28)) * 32) +
        (as_number(transform_left_filter_feature_0_choices(33)) * 64) +
        (as_number(transform_left_filter_feature_0_choices(37)) * 128) +
        (as_number(transform_left_filter_feature_0_choices(42)) * 512) +
        (as_number(transform_left_filter_feature_0_choices(47)) * 256) +
        (as_number(transform_left_filter_feature_0_choices(51)) * 1024) +
        (as_number(transform_left_filter_feature_0_choices(56)) * 4096) +
        (as_number(transform_left_filter_feature_0_choices(61)) * 2048) +
        (as_number(transform_left_filter_feature_0_choices(65)) * 8192);
      transform_right_filter_feature_0 <= as_number(transform_right_filter_feature_0_choices(5)) +
        (as_number(transform_right_filter_feature_0_choices(10)) * 2) +
        (as_number(transform_right_filter_feature_0_choices(15)) * 4) +
        (as_number(transform_right_filter_feature_0_choices(20)) * 16) +
        (as_number(transform_right_filter_feature_0_choices(25)) * 8) +
        (as_number(transform_right_filter_feature_0_choices(30)) * 32) +
        (as_number(transform_right_filter_feature_0_choices(35)) * 64) +
        (as_number(transform_right_filter_feature_0_choices(40)) * 128) +
        (as_number(transform_right_filter_feature_0_choices(45)) * 512) +
        (as_number(transform_right_filter_feature_0_choices(50)) * 256) +
        (as_number(transform_right_filter_feature_0_choices(55)) * 1024) +
        (as_number(transform_right_filter_feature_0_choices(60)) * 4096) +
        (as_number(transform_right_filter_feature_0_choices(65)) * 2048) +
        (as_number(transform_right_filter_feature_0_choices(70)) * 8192);
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_8 <= transform_columns_column_inside_8;
      transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
      transform_filtering_valid(0) <= transform_columns_valid;
      transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
      transform_filtering_valid(1) <= transform_filtering_valid(0);
      transform_filtering_start_of_frame(2) <= transform_filtering_start_of_frame(1);
      transform_filtering_valid(2) <= transform_filtering_valid(1);
      if transform_counter_counts then
        transform_counter_frame_joins <= transform_counter_frame_joins_choice;
      else
        transform_counter_frame_joins <= winnerswinner1_best_below_0;
      end if;
      if transform_counter_last_column then
        transform_counter_column_after <= 0;
      else
        transform_counter_column_after <= (transform_counter_column + 1) mod 512;
      end if;
      if (not transform_counter_counts) or (not transform_counter_last_column) then
        transform_counter_group_after <= transform_counter_group;
      else
        transform_counter_group_after <= transform_counter_group_after_choice;
      end if;
      if transform_left_filter_low_is_larger_0_0_0_choices(3) then
        transform_left_filter_low_is_larger_0_0_0 <= (not is_set(transform_left_filter_column_2(4), 3)) or
          transform_left_filter_low_is_larger_0_0_0_values(4);
      else
        transform_left_filter_low_is_larger_0_0_0 <= (not is_set(transform_left_filter_column_2(4), 3)) and
          transform_left_filter_low_is_larger_0_0_0_values(4);
      end if;
      if transform_left_filter_low_is_larger_0_0_2_choices(3) then
        transform_left_filter_low_is_larger_0_0_2 <= transform_left_filter_low_is_larger_0_0_2_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_0_2 <= transform_left_filter_low_is_larger_0_0_2_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_0_4_choices(3) then
        transform_left_filter_low_is_larger_0_0_4 <= transform_left_filter_low_is_larger_0_0_4_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_0_4 <= transform_left_filter_low_is_larger_0_0_4_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_2_0_choices(3) then
        transform_left_filter_low_is_larger_0_2_0 <= transform_left_filter_low_is_larger_0_2_0_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_2_0 <= transform_left_filter_low_is_larger_0_2_0_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_2_2_choices(3) then
        transform_left_filter_low_is_larger_0_2_2 <= transform_left_filter_low_is_larger_0_2_2_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_2_2 <= transform_left_filter_low_is_larger_0_2_2_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_2_4_choices(3) then
        transform_left_filter_low_is_larger_0_2_4 <= transform_left_filter_low_is_larger_0_2_4_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_2_4 <= transform_left_filter_low_is_larger_0_2_4_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_4_0_choices(3) then
        transform_left_filter_low_is_larger_0_4_0 <= transform_left_filter_low_is_larger_0_4_0_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_4_0 <= transform_left_filter_low_is_larger_0_4_0_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_4_4_choices(3) then
        transform_left_filter_low_is_larger_0_4_4 <= transform_left_filter_low_is_larger_0_4_4_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_4_4 <= transform_left_filter_low_is_larger_0_4_4_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_6_0_choices(3) then
        transform_left_filter_low_is_larger_0_6_0 <= transform_left_filter_low_is_larger_0_6_0_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_6_0 <= transform_left_filter_low_is_larger_0_6_0_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_6_2_choices(3) then
        transform_left_filter_low_is_larger_0_6_2 <= transform_left_filter_low_is_larger_0_6_2_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_6_2 <= transform_left_filter_low_is_larger_0_6_2_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_6_4_choices(3) then
        transform_left_filter_low_is_larger_0_6_4 <= transform_left_filter_low_is_larger_0_6_4_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_6_4 <= transform_left_filter_low_is_larger_0_6_4_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_8_0_choices(3) then
        transform_left_filter_low_is_larger_0_8_0 <= transform_left_filter_low_is_larger_0_8_0_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_8_0 <= transform_left_filter_low_is_larger_0_8_0_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_8_2_choices(3) then
        transform_left_filter_low_is_larger_0_8_2 <= transform_left_filter_low_is_larger_0_8_2_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_8_2 <= transform_left_filter_low_is_larger_0_8_2_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_left_filter_low_is_larger_0_8_4_choices(3) then
        transform_left_filter_low_is_larger_0_8_4 <= transform_left_filter_low_is_larger_0_8_4_value and (not
          is_set(transform_left_filter_column_2(4), 3));
      else
        transform_left_filter_low_is_larger_0_8_4 <= transform_left_filter_low_is_larger_0_8_4_value or (not
          is_set(transform_left_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_0_0_choices(3) then
        transform_right_filter_low_is_larger_0_0_0 <= (not is_set(transform_right_filter_column_2(4), 3)) or
          transform_right_filter_low_is_larger_0_0_0_values(4);
      else
        transform_right_filter_low_is_larger_0_0_0 <= (not is_set(transform_right_filter_column_2(4), 3)) and
          transform_right_filter_low_is_larger_0_0_0_values(4);
      end if;
      if transform_right_filter_low_is_larger_0_0_2_choices(3) then
        transform_right_filter_low_is_larger_0_0_2 <= transform_right_filter_low_is_larger_0_0_2_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_0_2 <= transform_right_filter_low_is_larger_0_0_2_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_0_4_choices(3) then
        transform_right_filter_low_is_larger_0_0_4 <= transform_right_filter_low_is_larger_0_0_4_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_0_4 <= transform_right_filter_low_is_larger_0_0_4_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_2_0_choices(3) then
        transform_right_filter_low_is_larger_0_2_0 <= transform_right_filter_low_is_larger_0_2_0_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_2_0 <= transform_right_filter_low_is_larger_0_2_0_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_2_2_choices(3) then
        transform_right_filter_low_is_larger_0_2_2 <= transform_right_filter_low_is_larger_0_2_2_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_2_2 <= transform_right_filter_low_is_larger_0_2_2_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_2_4_choices(3) then
        transform_right_filter_low_is_larger_0_2_4 <= transform_right_filter_low_is_larger_0_2_4_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_2_4 <= transform_right_filter_low_is_larger_0_2_4_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_4_0_choices(3) then
        transform_right_filter_low_is_larger_0_4_0 <= transform_right_filter_low_is_larger_0_4_0_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_4_0 <= transform_right_filter_low_is_larger_0_4_0_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_4_4_choices(3) then
        transform_right_filter_low_is_larger_0_4_4 <= transform_right_filter_low_is_larger_0_4_4_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_4_4 <= transform_right_filter_low_is_larger_0_4_4_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_6_0_choices(3) then
        transform_right_filter_low_is_larger_0_6_0 <= transform_right_filter_low_is_larger_0_6_0_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_6_0 <= transform_right_filter_low_is_larger_0_6_0_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_6_2_choices(3) then
        transform_right_filter_low_is_larger_0_6_2 <= transform_right_filter_low_is_larger_0_6_2_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_6_2 <= transform_right_filter_low_is_larger_0_6_2_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_6_4_choices(3) then
        transform_right_filter_low_is_larger_0_6_4 <= transform_right_filter_low_is_larger_0_6_4_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_6_4 <= transform_right_filter_low_is_larger_0_6_4_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_8_0_choices(3) then
        transform_right_filter_low_is_larger_0_8_0 <= transform_right_filter_low_is_larger_0_8_0_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_8_0 <= transform_right_filter_low_is_larger_0_8_0_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_8_2_choices(3) then
        transform_right_filter_low_is_larger_0_8_2 <= transform_right_filter_low_is_larger_0_8_2_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_8_2 <= transform_right_filter_low_is_larger_0_8_2_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_right_filter_low_is_larger_0_8_4_choices(3) then
        transform_right_filter_low_is_larger_0_8_4 <= transform_right_filter_low_is_larger_0_8_4_value and (not
          is_set(transform_right_filter_column_2(4), 3));
      else
        transform_right_filter_low_is_larger_0_8_4 <= transform_right_filter_low_is_larger_0_8_4_value or (not
          is_set(transform_right_filter_column_2(4), 3));
      end if;
      if transform_counter_next_frame then
        transform_counter_group_choice := 15;
      else
        transform_counter_group_choice := 0;
      end if;
      if in_valid then
        if in_start_of_frame then
          transform_counter_column <= 0;
          transform_counter_group <= transform_counter_group_choice * 16;
        else
          transform_counter_column <= transform_counter_column_after;
          transform_counter_group <= transform_counter_group_after;
        end if;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= to_unsigned(transform_left_rows_ready_newest_0, 8) &
          transform_left_rows_ready_words_0(31 downto 8);
        transform_right_rows_write_words_0 <= to_unsigned(transform_right_rows_ready_newest_0, 8) &
          transform_right_rows_ready_words_0(31 downto 8);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_filtering_valid(2) then
        if transform_filtering_start_of_frame(2) then
          transform_read_row_inside_0 <= raster_place_next_frame;
        else
          transform_read_row_inside_0 <= raster_place_back_to_back;
        end if;
      end if;
      if transform_columns_valid then
        for i in 1 to 8 loop
          transform_left_filter_column_0(i) <= transform_left_filter_column_0(i - 1);
          transform_left_filter_column_2(i) <= transform_left_filter_column_2(i - 1);
          transform_left_filter_column_4(i) <= transform_left_filter_column_4(i - 1);
        end loop;
        for i in 1 to 8 loop
          transform_right_filter_column_0(i) <= transform_right_filter_column_0(i - 1);
          transform_right_filter_column_2(i) <= transform_right_filter_column_2(i - 1);
          transform_right_filter_column_4(i) <= transform_right_filter_column_4(i - 1);
        end loop;
        if transform_columns_row_inside_0 then
          transform_left_filter_column_0(0) <= transform_left_column_0;
          transform_right_filter_column_0(0) <= transform_right_column_0;
        else
          transform_left_filter_column_0(0) <= 0;
          transform_right_filter_column_0(0) <= 0;
        end if;
        if transform_columns_row_inside_2 then
          transform_left_filter_column_2(0) <= transform_left_column_2;
          transform_right_filter_column_2(0) <= transform_right_column_2;
        else
          transform_left_filter_column_2(0) <= 0;
          transform_right_filter_column_2(0) <= 0;
        end if;
        if transform_columns_row_inside_4 then
          transform_left_filter_column_4(0) <= transform_left_column_4;
          transform_right_filter_column_4(0) <= transform_right_column_4;
        else
          transform_left_filter_column_4(0) <= 0;
          transform_right_filter_column_4(0) <= 0;
        end if;
      end if;
      -- raster
      raster_place_next_frame_is_equal := raster_place_column = 319;
      if raster_place_last_column then
        raster_place_back_to_back_choice := (not raster_place_frame_joins) and transform_read_row_inside_0;
      else
        raster_place_back_to_back_choice := transform_read_row_inside_0;
      end if;
      if raster_place_frame_joins then
        raster_place_group_after_choice := 1;
      else
        raster_place_group_after_choice := (raster_place_group + 1) mod 256;
      end if;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_valid(2);
      raster_place_next_frame <= raster_place_next_frame_is_equal and (raster_place_group = 239);
      raster_place_last_column <= raster_place_next_frame_is_equal;
      raster_place_counts <= (not is_set(raster_place_group, 7)) or (not is_set(raster_place_group, 6)) or (not
        is_set(raster_place_group, 5)) or (not is_set(raster_place_group, 4));
      raster_place_frame_joins <= transform_read_row_inside_0 and (raster_place_group = 240);
      if delay_row_inside(2) then
        raster_place_back_to_back <= raster_place_back_to_back_choice;
      else
        raster_place_back_to_back <= transform_read_row_inside_0;
      end if;
      if raster_place_last_column then
        raster_place_column_after <= 0;
      else
        raster_place_column_after <= (raster_place_column + 1) mod 512;
      end if;
      if (not delay_row_inside(2)) or (not raster_place_last_column) then
        raster_place_group_after <= raster_place_group;
      else
        raster_place_group_after <= raster_place_group_after_choice;
      end if;
      if raster_place_next_frame then
        raster_place_group_choice := 15;
      else
        raster_place_group_choice := 0;
      end if;
      if transform_filtering_valid(2) then
        if transform_filtering_start_of_frame(2) then
          raster_place_column <= 0;
          raster_place_group <= raster_place_group_choice * 16;
        else
          raster_place_column <= raster_place_column_after;
          raster_place_group <= raster_place_group_after;
        end if;
      end if;
      -- delay
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 241;
      delay_tag_first_cost_is_equal := raster_place_column = 63;
      delay_tag_map_column_is_not_less := raster_place_column >= 63;
      delay_tag_map_column_is_less := raster_place_column < 320;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 240;
      delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside(2) <= ((raster_place_group mod 16) /= 1) or ((raster_place_group / 16) /= 15);
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= raster_place_column < 63;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and
        delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 1);
      -- rows
      rows_search_rows_read_newest_0 <= delay_delayed_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside(0) <= delay_row_inside(0);
      rows_read_inside(1) <= delay_row_inside(1);
      rows_read_inside(2) <= raster_place_counts;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_first_cost <= delay_tag_first_cost;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= raster_place_last_column;
      rows_ready_column <= rows_read_column;
      rows_ready_inside(0) <= rows_read_inside(0);
      rows_ready_inside(1) <= rows_read_inside(1);
      rows_ready_inside(2) <= rows_read_inside(2);
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
      if rows_ready_inside(0) then
        rows_search(0) <= rows_search_rows_ready_words_0 mod 16384;
        rows_reference(0) <= rows_reference_rows_ready_words_0 mod 16384;
      else
        rows_search(0) <= 0;
        rows_reference(0) <= 0;
      end if;
      if rows_ready_inside(1) then
        rows_search(1) <= rows_search_rows_ready_words_0 / 16384;
        rows_reference(1) <= rows_reference_rows_ready_words_0 / 16384;
      else
        rows_search(1) <= 0;
        rows_reference(1) <= 0;
      end if;
      if rows_ready_inside(2) then
        rows_search(2) <= rows_search_rows_ready_newest_0;
        rows_reference(2) <= rows_reference_rows_ready_newest_0;
      else
        rows_search(2) <= 0;
        rows_reference(2) <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 16384) + (rows_search_rows_ready_newest_0 *
          16384);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 16384) +
          (rows_reference_rows_ready_newest_0 * 16384);
        rows_write_column <= rows_ready_column;
      end if;
      -- line
      if rows_tag_valid then
        line_centre_map_column_0 <= rows_tag_map_column;
        line_centre_output_column_0 <= rows_tag_output_column;
        line_centre_first_column_0 <= rows_tag_first_cost;
        line_centre_start_of_frame_0 <= rows_tag_start_of_frame;
        line_centre_end_of_line_0 <= rows_tag_end_of_line;
        line_order_inside <= line_centre_map_column_0;
        line_newest_first_column <= line_centre_first_column_0;
        line_newest_top <= line_centre_start_of_frame_0;
      end if;
      line_order_address_any := (not line_centre_map_column_0) or line_order_inside or (not rows_tag_valid);
      if line_order_falls then
        line_order_address_choice := 511;
      else
        line_order_address_choice := 1;
      end if;
      if not ((not line_centre_map_column_0) or (not rows_tag_valid)) then
        if line_order_address_any then
          line_order_address <= (line_order_address_choice + line_order_address) mod 512;
        else
          line_order_address <= as_number((not line_order_falls)) * 256;
        end if;
      end if;
      line_order_falls_all := line_centre_map_column_0 and (not line_order_inside) and rows_tag_valid;
      if line_order_falls_all then
        line_order_turned_output_column_choice := line_order_output and line_order_complete;
      else
        line_order_turned_output_column_choice := line_order_held_output;
      end if;
      line_order_turned_valid <= rows_tag_valid;
      line_order_turned_map_column <= line_centre_map_column_0;
      line_order_turned_output_column <= line_order_turned_output_column_choice and line_centre_map_column_0;
      line_order_turned_start_of_frame <= line_centre_map_column_0 and (not line_order_inside) and rows_tag_valid and
        line_order_first and line_order_output and line_order_complete;
      line_order_turned_end_of_line <= line_centre_end_of_line_0;
      line_comes(1) <= line_order_turned_valid;
      for i in 2 to 47 loop
        line_comes(i) <= line_comes(i - 1);
      end loop;
      line_starts_phases(1) <= line_order_inside and line_order_turned_valid;
      for i in 2 to 26 loop
        line_starts_phases(i) <= line_starts_phases(i - 1);
      end loop;
      line_starts_phases(27) <= pathsleft_read_count_phase = 0;
      line_starts_phases(28) <= pathsleft_is_first;
      for i in 29 to 47 loop
        line_starts_phases(i) <= line_starts_phases(i - 1);
      end loop;
      if line_order_falls then
        line_order_falls <= line_order_address_any;
      else
        line_order_falls <= line_order_falls_all;
      end if;
      if line_order_complete then
        line_order_complete <= line_centre_end_of_line_0 or (not line_centre_map_column_0) or (not rows_tag_valid);
      else
        line_order_complete <= line_centre_end_of_line_0 and line_centre_map_column_0 and rows_tag_valid;
      end if;
      if line_order_falls_all then
        line_order_output <= line_centre_output_column_0;
        line_order_first <= line_centre_start_of_frame_0;
        line_order_held_output <= line_order_output and line_order_complete;
      end if;
      if line_order_turned_valid then
        line_places_map_column(0) <= line_order_turned_map_column;
        line_places_first_column(0) <= line_newest_first_column;
        line_places_0_top <= line_newest_top;
        line_places_address(0) <= line_order_address;
        line_places_shown_output_column(0) <= line_order_turned_output_column;
        line_places_shown_start_of_frame(0) <= line_order_turned_start_of_frame;
        line_places_shown_end_of_line(0) <= line_order_turned_end_of_line;
      end if;
      if line_comes(16) then
        line_places_map_column(1) <= line_places_map_column(0);
        line_places_first_column(1) <= line_places_first_column(0);
        line_places_address(1) <= line_places_address(0);
        line_places_shown_output_column(1) <= line_places_shown_output_column(0);
        line_places_shown_start_of_frame(1) <= line_places_shown_start_of_frame(0);
        line_places_shown_end_of_line(1) <= line_places_shown_end_of_line(0);
      end if;
      if line_comes(32) then
        line_places_map_column(2) <= line_places_map_column(1);
        line_places_shown_output_column(2) <= line_places_shown_output_column(1);
        line_places_shown_start_of_frame(2) <= line_places_shown_start_of_frame(1);
        line_places_shown_end_of_line(2) <= line_places_shown_end_of_line(1);
      end if;
      -- costsshift
      if rows_tag_valid then
        costsshift_newest(0) <= rows_search(0);
        costsshift_newest(1) <= rows_search(1);
        costsshift_newest(2) <= rows_search(2);
        costsshift_new_reference(0) <= rows_reference(0);
        costsshift_new_reference(1) <= rows_reference(1);
        costsshift_new_reference(2) <= rows_reference(2);
        costsshift_new_tag_border_column <= rows_tag_border_column;
      end if;
      if costsshift_count_phase = 15 then
        costsshift_count_phase_choice := 15;
      else
        costsshift_count_phase_choice := (costsshift_count_phase + 1) mod 16;
      end if;
      costsshift_new_tag_valid <= (costsshift_count_phase /= 15) or rows_tag_valid;
      costsshift_handed_on(0) <= to_integer(costsshift_read_words(1)(27 downto 14));
      costsshift_handed_on(1) <= to_integer(costsshift_read_words(3)(27 downto 14));
      costsshift_handed_on(2) <= to_integer(costsshift_read_words(5)(27 downto 14));
      costsshift_read_reference(0) <= costsshift_new_reference(0);
      costsshift_read_reference(1) <= costsshift_new_reference(1);
      costsshift_read_reference(2) <= costsshift_new_reference(2);
      costsshift_read_tag_valid <= costsshift_new_tag_valid;
      costsshift_read_tag_border_column <= costsshift_new_tag_border_column;
      costsshift_read_count_phase <= costsshift_count_phase;
      costsshift_reference(0) <= costsshift_read_reference(0);
      costsshift_reference(1) <= costsshift_read_reference(1);
      costsshift_reference(2) <= costsshift_read_reference(2);
      costsshift_tag_border_column <= costsshift_read_tag_border_column;
      costsshift_write_phase <= costsshift_read_count_phase;
      if rows_tag_valid then
        costsshift_count_phase <= 0;
      else
        costsshift_count_phase <= costsshift_count_phase_choice;
      end if;
      costsshift_search_0_0_is_equal := costsshift_read_count_phase = 0;
      if costsshift_read_tag_valid then
        for i in 0 to 2 loop
          costsshift_search(i, 1) <= to_integer(costsshift_read_words(2 * i)(13 downto 0));
          costsshift_search(i, 2) <= to_integer(costsshift_read_words(2 * i)(27 downto 14));
          costsshift_search(i, 3) <= to_integer(costsshift_read_words(2 * i + 1)(13 downto 0));
        end loop;
        if costsshift_search_0_0_is_equal then
          costsshift_search(0, 0) <= costsshift_newest(0);
          costsshift_search(1, 0) <= costsshift_newest(1);
          costsshift_search(2, 0) <= costsshift_newest(2);
        else
          costsshift_search(0, 0) <= costsshift_handed_on(0);
          costsshift_search(1, 0) <= costsshift_handed_on(1);
          costsshift_search(2, 0) <= costsshift_handed_on(2);
        end if;
      end if;
      -- costscolumn
      for i in 0 to 2 loop
        costscolumn_pixels_first_0_count_value(i, 0) := is_set(costsshift_reference(i), 2);
        costscolumn_pixels_first_0_count_value_2(i, 0) := is_set(costsshift_reference(i), 1);
        costscolumn_pixels_first_0_count_value(i, 1) := is_set(costsshift_reference(i), 3);
        costscolumn_pixels_first_0_count_value_2(i, 1) := is_set(costsshift_reference(i), 5);
        costscolumn_pixels_first_0_count_1_value_3(i) := is_set(costsshift_reference(i), 4);
        costscolumn_pixels_first_0_count_value(i, 2) := is_set(costsshift_reference(i), 8);
        costscolumn_pixels_first_0_count_value_2(i, 2) := is_set(costsshift_reference(i), 6);
        costscolumn_pixels_first_0_count_value(i, 3) := is_set(costsshift_reference(i), 9);
        costscolumn_pixels_first_0_count_value_2(i, 3) := is_set(costsshift_reference(i), 11);
        costscolumn_pixels_first_0_count_3_value_3(i) := is_set(costsshift_reference(i), 10);
        costscolumn_pixels_first_0_count_value(i, 4) := is_set(costsshift_reference(i), 12);
      end loop;
      for i in 0 to 2 loop
        costscolumn_pixels_first_count(i, 0, 0) <= as_number((is_set(costsshift_search(i, 0), 0) /=
          is_set(costsshift_reference(i), 0))) + as_number((costscolumn_pixels_first_0_count_value(i, 0) /=
          is_set(costsshift_search(i, 0), 2))) + as_number((costscolumn_pixels_first_0_count_value_2(i, 0) /=
          is_set(costsshift_search(i, 0), 1)));
        costscolumn_pixels_first_count(i, 0, 1) <= as_number((costscolumn_pixels_first_0_count_value(i, 1) /=
          is_set(costsshift_search(i, 0), 3))) + as_number((costscolumn_pixels_first_0_count_value_2(i, 1) /=
          is_set(costsshift_search(i, 0), 5))) + as_number((costscolumn_pixels_first_0_count_1_value_3(i) /=
          is_set(costsshift_search(i, 0), 4)));
        costscolumn_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((costsshift_search(i, 0) mod 256), 8)) xor
          (to_unsigned((costsshift_reference(i) mod 256), 8)))) / 128) +
          as_number((costscolumn_pixels_first_0_count_value(i, 2) /= is_set(costsshift_search(i, 0), 8))) +
          as_number((costscolumn_pixels_first_0_count_value_2(i, 2) /= is_set(costsshift_search(i, 0), 6)));
        costscolumn_pixels_first_count(i, 0, 3) <= as_number((costscolumn_pixels_first_0_count_value(i, 3) /=
          is_set(costsshift_search(i, 0), 9))) + as_number((costscolumn_pixels_first_0_count_value_2(i, 3) /=
          is_set(costsshift_search(i, 0), 11))) + as_number((costscolumn_pixels_first_0_count_3_value_3(i) /=
          is_set(costsshift_search(i, 0), 10)));
        costscolumn_pixels_first_count_4(i, 0) <= as_number((is_set(costsshift_reference(i), 13) /=
          is_set(costsshift_search(i, 0), 13))) + as_number((costscolumn_pixels_first_0_count_value(i, 4) /=
          is_set(costsshift_search(i, 0), 12)));
        for j in 1 to 3 loop
          costscolumn_pixels_first_count(i, j, 0) <= as_number((is_set(costsshift_search(i, j), 0) /=
            is_set(costsshift_reference(i), 0))) + as_number((is_set(costsshift_search(i, j), 2) /=
            costscolumn_pixels_first_0_count_value(i, 0))) + as_number((is_set(costsshift_search(i, j), 1) /=
            costscolumn_pixels_first_0_count_value_2(i, 0)));
          costscolumn_pixels_first_count(i, j, 1) <= as_number((is_set(costsshift_search(i, j), 3) /=
            costscolumn_pixels_first_0_count_value(i, 1))) + as_number((is_set(costsshift_search(i, j), 5) /=
            costscolumn_pixels_first_0_count_value_2(i, 1))) + as_number((is_set(costsshift_search(i, j), 4) /=
            costscolumn_pixels_first_0_count_1_value_3(i)));
          costscolumn_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((costsshift_search(i, j) mod 256), 8))
            xor (to_unsigned((costsshift_reference(i) mod 256), 8)))) / 128) + as_number((is_set(costsshift_search(i,
            j), 8) /= costscolumn_pixels_first_0_count_value(i, 2))) + as_number((is_set(costsshift_search(i, j), 6) /=
            costscolumn_pixels_first_0_count_value_2(i, 2)));
          costscolumn_pixels_first_count(i, j, 3) <= as_number((is_set(costsshift_search(i, j), 9) /=
            costscolumn_pixels_first_0_count_value(i, 3))) + as_number((is_set(costsshift_search(i, j), 11) /=
            costscolumn_pixels_first_0_count_value_2(i, 3))) + as_number((is_set(costsshift_search(i, j), 10) /=
            costscolumn_pixels_first_0_count_3_value_3(i)));
          costscolumn_pixels_first_count_4(i, j) <= as_number((is_set(costsshift_search(i, j), 13) /=
            is_set(costsshift_reference(i), 13))) + as_number((is_set(costsshift_search(i, j), 12) /=
            costscolumn_pixels_first_0_count_value(i, 4)));
        end loop;
      end loop;
      costscolumn_pixels_first_tag_border_column <= costsshift_tag_border_column;
      for i in 0 to 2 loop
        for j in 0 to 3 loop
          costscolumn_pixels_cost(i, j) <= costscolumn_pixels_first_count(i, j, 3) + costscolumn_pixels_first_count(i,
            j, 0) + costscolumn_pixels_first_count(i, j, 1) + costscolumn_pixels_first_count_4(i, j) +
            costscolumn_pixels_first_count(i, j, 2);
        end loop;
      end loop;
      costscolumn_pixels_tag_border_column <= costscolumn_pixels_first_tag_border_column;
      costscolumn_pair_0(0) <= costscolumn_pixels_cost(1, 0) + costscolumn_pixels_cost(2, 0);
      costscolumn_pair_0(1) <= costscolumn_pixels_cost(1, 1) + costscolumn_pixels_cost(2, 1);
      costscolumn_pair_0(2) <= costscolumn_pixels_cost(1, 2) + costscolumn_pixels_cost(2, 2);
      costscolumn_pair_0(3) <= costscolumn_pixels_cost(1, 3) + costscolumn_pixels_cost(2, 3);
      costscolumn_single_0(0) <= costscolumn_pixels_cost(0, 0);
      costscolumn_single_0(1) <= costscolumn_pixels_cost(0, 1);
      costscolumn_single_0(2) <= costscolumn_pixels_cost(0, 2);
      costscolumn_single_0(3) <= costscolumn_pixels_cost(0, 3);
      costscolumn_pair_tag_border_column <= costscolumn_pixels_tag_border_column;
      if costscolumn_pair_tag_border_column then
        costscolumn_column_0(0) <= 0;
        costscolumn_column_0(1) <= 0;
        costscolumn_column_0(2) <= 0;
        costscolumn_column_0(3) <= 0;
      else
        costscolumn_column_0(0) <= costscolumn_pair_0(0) + costscolumn_single_0(0);
        costscolumn_column_0(1) <= costscolumn_pair_0(1) + costscolumn_single_0(1);
        costscolumn_column_0(2) <= costscolumn_pair_0(2) + costscolumn_single_0(2);
        costscolumn_column_0(3) <= costscolumn_pair_0(3) + costscolumn_single_0(3);
      end if;
      -- costswindow
      if costswindow_read_count_phase = 15 then
        costswindow_read_count_phase_choice := 15;
      else
        costswindow_read_count_phase_choice := (costswindow_read_count_phase + 1) mod 16;
      end if;
      if costswindow_write_count_phase = 15 then
        costswindow_write_count_phase_choice := 15;
      else
        costswindow_write_count_phase_choice := (costswindow_write_count_phase + 1) mod 16;
      end if;
      for i in 0 to 3 loop
        costswindow_sum_0(i) <= costscolumn_column_0(i) + to_integer(costswindow_read_words_1(7 * i + 6 downto 7 * i));
      end loop;
      if line_comes(4) then
        costswindow_read_count_phase <= 0;
      else
        costswindow_read_count_phase <= costswindow_read_count_phase_choice;
      end if;
      if line_comes(6) then
        costswindow_write_count_phase <= 0;
      else
        costswindow_write_count_phase <= costswindow_write_count_phase_choice;
      end if;
      costswindow_partial_0_any := (costswindow_write_count_phase /= 15) or line_comes(6);
      if costswindow_partial_0_any then
        costswindow_partial(0) <= costscolumn_column_0(0);
        costswindow_partial(1) <= costscolumn_column_0(1);
        costswindow_partial(2) <= costscolumn_column_0(2);
        costswindow_partial(3) <= costscolumn_column_0(3);
        for i in 4 to 6 loop
          costswindow_partials(i) <= costscolumn_column_0(i - 4) + to_integer(costswindow_read_words_0(7 * i - 23
            downto 7 * i - 28));
        end loop;
        costswindow_partials(7) <= to_integer(costswindow_read_words_0(26 downto 21)) + costscolumn_column_0(3);
      end if;
      -- costs
      for i in 0 to 3 loop
        if is_set(costswindow_sum_0(i), 7) or is_set(costswindow_sum_0(i), 6) or (((costswindow_sum_0(i) / 16) mod 4) =
          3) then
          costs_cost(i) <= 5;
        else
          costs_cost(i) <= costswindow_sum_0(i) / 8;
        end if;
      end loop;
      -- paths
      if line_comes(10) then
        paths_smallest_cost_choice := 7;
      else
        paths_smallest_cost_choice := paths_smallest_cost;
      end if;
      paths_cost_delay_ring_write_address <= paths_cost_delay_ring_read_address;
      paths_sum(0) <= (pathsturn_sum_memory_ready_words_0 mod 128) + pathsright_cost(0);
      paths_sum(1) <= ((pathsturn_sum_memory_ready_words_0 / 128) mod 128) + pathsright_cost(1);
      paths_sum(2) <= ((pathsturn_sum_memory_ready_words_1 mod 32) * 4) + (pathsturn_sum_memory_ready_words_0 / 16384)
        + pathsright_cost(2);
      paths_sum(3) <= (pathsturn_sum_memory_ready_words_1 / 32) + pathsright_cost(3);
      for i in 0 to 1 loop
        if (costs_cost(2 * i + 1) - costs_cost(2 * i)) < 0 then
          paths_tree_smallest(i) <= costs_cost(2 * i + 1);
        else
          paths_tree_smallest(i) <= costs_cost(2 * i);
        end if;
      end loop;
      if (paths_tree_smallest(1) - paths_tree_smallest(0)) < 0 then
        paths_tree_next_smallest_0 <= paths_tree_smallest(1);
      else
        paths_tree_next_smallest_0 <= paths_tree_smallest(0);
      end if;
      if (paths_tree_next_smallest_0 - paths_smallest_cost_choice) < 0 then
        paths_smallest_cost <= paths_tree_next_smallest_0;
      else
        paths_smallest_cost <= paths_smallest_cost_choice;
      end if;
      if paths_cost_delay_ring_read_address = 18 then
        paths_cost_delay_ring_read_address <= 0;
      else
        paths_cost_delay_ring_read_address <= (paths_cost_delay_ring_read_address + 1) mod 32;
      end if;
      -- pathsleft
      if line_starts_phases(21) then
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
      if (to_integer(pathsleft_read_words(1)(6 downto 0)) - to_integer(pathsleft_read_words(0)(6 downto 0))) < 0 then
        pathsleft_stay_choice(0) := to_integer(pathsleft_read_words(1)(6 downto 0));
      else
        pathsleft_stay_choice(0) := to_integer(pathsleft_read_words(0)(6 downto 0));
      end if;
      for i in 1 to 2 loop
        pathsleft_stay_value(i) := to_integer(pathsleft_read_words(1)(7 * i + 6 downto 7 * i));
        pathsleft_stay_value_2(i) := to_integer(pathsleft_read_words(0)(7 * i + 6 downto 7 * i));
        if (pathsleft_stay_value(i) - pathsleft_stay_value_2(i)) < 0 then
          pathsleft_stay_choice(i) := pathsleft_stay_value(i);
        else
          pathsleft_stay_choice(i) := pathsleft_stay_value_2(i);
        end if;
      end loop;
      if (to_integer(pathsleft_read_words(1)(27 downto 21)) - to_integer(pathsleft_read_words(0)(27 downto 21))) < 0
        then
        pathsleft_stay_choice(3) := to_integer(pathsleft_read_words(1)(27 downto 21));
      else
        pathsleft_stay_choice(3) := to_integer(pathsleft_read_words(0)(27 downto 21));
      end if;
      if line_starts_phases(27) then
        pathsleft_step_choice(0) := pathsleft_stay_value_2(1);
      else
        pathsleft_step_choice(0) := pathsleft_lower_neighbour;
      end if;
      if (pathsleft_stay_value_2(1) - pathsleft_step_choice(0)) < 0 then
        pathsleft_step_0_choice_2 := pathsleft_stay_value_2(1);
      else
        pathsleft_step_0_choice_2 := pathsleft_step_choice(0);
      end if;
      if (pathsleft_stay_value_2(2) - to_integer(pathsleft_read_words(0)(6 downto 0))) < 0 then
        pathsleft_step_choice(1) := pathsleft_stay_value_2(2);
      else
        pathsleft_step_choice(1) := to_integer(pathsleft_read_words(0)(6 downto 0));
      end if;
      if (to_integer(pathsleft_read_words(0)(27 downto 21)) - pathsleft_stay_value_2(1)) < 0 then
        pathsleft_step_choice(2) := to_integer(pathsleft_read_words(0)(27 downto 21));
      else
        pathsleft_step_choice(2) := pathsleft_stay_value_2(1);
      end if;
      if pathsleft_is_last then
        pathsleft_step_choice(3) := pathsleft_stay_value_2(2);
      else
        pathsleft_step_choice(3) := to_integer(pathsleft_read_neighbour_0);
      end if;
      if (pathsleft_step_choice(3) - pathsleft_stay_value_2(2)) < 0 then
        pathsleft_step_3_choice_2 := pathsleft_step_choice(3);
      else
        pathsleft_step_3_choice_2 := pathsleft_stay_value_2(2);
      end if;
      pathsleft_stay_change_value(1) := to_integer(paths_cost_delay_held_0(5 downto 0)) / 8;
      pathsleft_stay_change_value(2) := to_integer(paths_cost_delay_held_0(8 downto 6));
      if pathsleft_write_count_phase = 15 then
        pathsleft_write_count_phase_choice := 15;
      else
        pathsleft_write_count_phase_choice := (pathsleft_write_count_phase + 1) mod 16;
      end if;
      if line_comes(31) then
        pathsleft_low_0_choice := 127;
      else
        pathsleft_low_0_choice := pathsleft_low_0;
      end if;
      pathsleft_lost <= pathsleft_lowest_0(6) = '1';
      pathsleft_short_of <= ((to_integer(pathsright_lowest_0(5 downto 0)) + pathsright_room) / 64) = 1;
      pathsleft_missing <= (to_integer(pathsleft_lowest_0) + pathsleft_room) mod 64;
      pathsleft_below <= (0 - to_integer(pathsleft_lowest_0)) mod 64;
      pathsleft_is_first <= line_starts_phases(26);
      pathsleft_is_last <= pathsleft_read_count_phase_is_equal;
      pathsleft_lower_neighbour <= to_integer(pathsleft_read_words(0)(27 downto 21));
      pathsleft_stay_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g) mod 128;
      pathsleft_stay_change(1) <= (pathsleft_stay_change_value(1) - pathsleft_g) mod 128;
      pathsleft_stay_change(2) <= (pathsleft_stay_change_value(2) - pathsleft_g) mod 128;
      pathsleft_stay_change(3) <= (to_integer(paths_cost_delay_held_0(11 downto 9)) - pathsleft_g) mod 128;
      pathsleft_step_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g_less) mod 128;
      pathsleft_step_change(1) <= (pathsleft_stay_change_value(1) - pathsleft_g_less) mod 128;
      pathsleft_step_change(2) <= (pathsleft_stay_change_value(2) - pathsleft_g_less) mod 128;
      pathsleft_step_change(3) <= (to_integer(paths_cost_delay_held_0(11 downto 9)) - pathsleft_g_less) mod 128;
      if line_starts_phases(25) then
        pathsleft_read_count_phase <= 0;
      else
        pathsleft_read_count_phase <= pathsleft_read_count_phase_choice;
      end if;
      if line_starts_phases(24) then
        pathsleft_ahead_count_phase <= 0;
      else
        pathsleft_ahead_count_phase <= pathsleft_ahead_count_phase_choice;
      end if;
      for i in 0 to 3 loop
        if (not is_set(pathsleft_stay_choice(i), 6)) and (not pathsleft_first) then
          pathsleft_stay(i) <= pathsleft_stay_choice(i);
        else
          pathsleft_stay(i) <= 64;
        end if;
      end loop;
      if pathsleft_first then
        pathsleft_step(0) <= 64;
        pathsleft_step(1) <= 64;
        pathsleft_step(2) <= 64;
        pathsleft_step(3) <= 64;
      else
        pathsleft_step(0) <= pathsleft_step_0_choice_2;
        pathsleft_step(1) <= pathsleft_step_choice(1);
        pathsleft_step(2) <= pathsleft_step_choice(2);
        pathsleft_step(3) <= pathsleft_step_3_choice_2;
      end if;
      if line_starts_phases(28) then
        pathsleft_write_count_phase <= 0;
      else
        pathsleft_write_count_phase <= pathsleft_write_count_phase_choice;
      end if;
      for i in 0 to 1 loop
        if (pathsleft_cost(2 * i + 1) - pathsleft_cost(2 * i)) < 0 then
          pathsleft_tree_smallest(i) <= pathsleft_cost(2 * i + 1);
        else
          pathsleft_tree_smallest(i) <= pathsleft_cost(2 * i);
        end if;
      end loop;
      if (pathsleft_tree_smallest(1) - pathsleft_tree_smallest(0)) < 0 then
        pathsleft_tree_next_smallest_0 <= pathsleft_tree_smallest(1);
      else
        pathsleft_tree_next_smallest_0 <= pathsleft_tree_smallest(0);
      end if;
      if (pathsleft_tree_next_smallest_0 - pathsleft_low_0_choice) < 0 then
        pathsleft_low_0 <= pathsleft_tree_next_smallest_0;
      else
        pathsleft_low_0 <= pathsleft_low_0_choice;
      end if;
      if pathsright_short_of then
        pathsleft_q_choice := pathsleft_missing;
      else
        pathsleft_q_choice := 0;
      end if;
      if pathsleft_lost then
        pathsleft_q_choice_2 := pathsleft_room;
      else
        pathsleft_q_choice_2 := pathsleft_q_choice;
      end if;
      if pathsright_short_of then
        pathsleft_room_left_choice := pathsleft_below;
      else
        pathsleft_room_left_choice := pathsleft_room;
      end if;
      if line_starts_phases(24) then
        if line_places_first_column(1) then
          pathsleft_q <= 60;
        else
          pathsleft_q <= pathsleft_q_choice_2;
        end if;
        if pathsleft_lost then
          pathsleft_room_left <= 0;
        else
          pathsleft_room_left <= pathsleft_room_left_choice;
        end if;
      end if;
      if line_starts_phases(25) then
        pathsleft_q_now <= pathsleft_q;
        pathsleft_q_less <= (pathsleft_q + 121) mod 128;
        if line_places_first_column(1) then
          pathsleft_room <= 0;
          for i in 1 to 8 loop
            pathsleft_start_cost(i) <= 0;
          end loop;
        else
          pathsleft_room <= (pathsleft_room_left + pathsleft_start_cost(8)) mod 64;
          pathsleft_start_cost(1) <= pathsleft_q_now;
          for i in 2 to 8 loop
            pathsleft_start_cost(i) <= pathsleft_start_cost(i - 1);
          end loop;
        end if;
      end if;
      if line_starts_phases(26) then
        pathsleft_first <= line_places_first_column(1);
        pathsleft_g <= paths_smallest_cost + pathsleft_q_now;
        pathsleft_g_less <= (paths_smallest_cost + pathsleft_q_less) mod 128;
      end if;
      pathsleft_cost_0_any := (pathsleft_write_count_phase /= 15) or line_starts_phases(28);
      if pathsleft_cost_0_any then
        pathsleft_cost(0) <= (pathsleft_stay(0) + pathsleft_stay_change(0)) mod 128;
        pathsleft_cost(1) <= (pathsleft_stay(1) + pathsleft_stay_change(1)) mod 128;
        pathsleft_cost(2) <= (pathsleft_stay(2) + pathsleft_stay_change(2)) mod 128;
        pathsleft_cost(3) <= (pathsleft_stay(3) + pathsleft_stay_change(3)) mod 128;
        pathsleft_arrived(0) <= (pathsleft_step(0) + pathsleft_step_change(0)) mod 128;
        pathsleft_arrived(1) <= (pathsleft_step(1) + pathsleft_step_change(1)) mod 128;
        pathsleft_arrived(2) <= (pathsleft_step(2) + pathsleft_step_change(2)) mod 128;
        pathsleft_arrived(3) <= (pathsleft_step(3) + pathsleft_step_change(3)) mod 128;
      end if;
      if line_starts_phases(47) then
        pathsleft_low_write_address <= (pathsleft_low_write_address + 1) mod 16;
      end if;
      -- pathsabove
      pathsabove_memory_read_address_0_sum := pathsabove_read_address_address + 1;
      if line_places_first_column(0) then
        pathsabove_memory_read_address_0_choice := 0;
      else
        pathsabove_memory_read_address_0_choice := pathsabove_memory_read_address_0_sum mod 4096;
      end if;
      pathsabove_memory_read_address_0_sum_2 := pathsabove_read_address_address + as_number(((not
        is_set(pathsabove_read_address_count_phase, 3)) or (not is_set(pathsabove_read_address_count_phase, 2)) or (not
        is_set(pathsabove_read_address_count_phase, 1)) or (not is_set(pathsabove_read_address_count_phase, 0))));
      if line_places_first_column(0) then
        pathsabove_memory_read_address_1_choice := 0;
      else
        pathsabove_memory_read_address_1_choice := pathsabove_memory_read_address_0_sum mod 16;
      end if;
      if line_places_first_column(0) then
        pathsabove_memory_bank_choice := 0;
      else
        pathsabove_memory_bank_choice := pathsabove_memory_read_address_0_sum mod 8192;
      end if;
      if line_starts_phases(4) then
        pathsabove_memory_bank_choice_2 := pathsabove_memory_bank_choice;
      else
        pathsabove_memory_bank_choice_2 := pathsabove_memory_read_address_0_sum_2 mod 8192;
      end if;
      if pathsabove_read_address_count_phase = 15 then
        pathsabove_read_address_count_phase_choice := 15;
      else
        pathsabove_read_address_count_phase_choice := (pathsabove_read_address_count_phase + 1) mod 16;
      end if;
      if line_starts_phases(7) then
        pathsabove_ready_top_choice := line_places_first_column(0) or pathsabove_ready_top;
      else
        pathsabove_ready_top_choice := pathsabove_ready_top;
      end if;
      if line_starts_phases(7) then
        pathsabove_ready_top_choice_2 := (not line_places_first_column(0)) and pathsabove_ready_top;
      else
        pathsabove_ready_top_choice_2 := pathsabove_ready_top;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(0) := 31;
      else
        pathsabove_total_choice(0) := pathsabove_memory_ready_words_0 mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(1) := 31;
      else
        pathsabove_total_choice(1) := (pathsabove_memory_ready_words_0 / 32) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(2) := 31;
      else
        pathsabove_total_choice(2) := (pathsabove_memory_ready_words_0 / 1024) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(3) := 31;
      else
        pathsabove_total_choice(3) := (pathsabove_memory_ready_words_1 * 2) + (pathsabove_memory_ready_words_0 / 32768);
      end if;
      if line_comes(11) then
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
        pathsabove_beside_0_choice := pathsabove_held(1);
      else
        pathsabove_beside_0_choice := pathsabove_lower_neighbour;
      end if;
      if pathsabove_count_phase_is_equal then
        pathsabove_beside_3_choice := pathsabove_held(2);
      else
        pathsabove_beside_3_choice := pathsabove_cost(0);
      end if;
      if line_places_first_column(1) then
        pathsabove_write_address_address_choice := 0;
      else
        pathsabove_write_address_address_choice := (pathsabove_write_address_address + 1) mod 8192;
      end if;
      if pathsabove_write_address_count_phase = 15 then
        pathsabove_write_address_count_phase_choice := 15;
      else
        pathsabove_write_address_count_phase_choice := (pathsabove_write_address_count_phase + 1) mod 16;
      end if;
      pathsabove_memory_bank <= is_set(pathsabove_memory_bank_choice_2, 12);
      pathsabove_memory_read_bank <= pathsabove_memory_bank;
      pathsabove_memory_held_words_0(0) <= to_integer(pathsabove_memory_read_words_0(0));
      pathsabove_memory_held_words_1(0) <= to_integer(pathsabove_memory_read_words_1(0));
      pathsabove_memory_held_words_0(1) <= to_integer(pathsabove_memory_read_words_0(1));
      pathsabove_memory_held_words_1(1) <= to_integer(pathsabove_memory_read_words_1(1));
      pathsabove_memory_held_bank <= pathsabove_memory_read_bank;
      pathsabove_read_address_address <= pathsabove_memory_bank_choice_2;
      pathsabove_total(0) <= costs_cost(0) + pathsabove_total_choice(0);
      pathsabove_total(1) <= costs_cost(1) + pathsabove_total_choice(1);
      pathsabove_total(2) <= costs_cost(2) + pathsabove_total_choice(2);
      pathsabove_total(3) <= costs_cost(3) + pathsabove_total_choice(3);
      pathsabove_cost(0) <= (to_integer(pathsabove_delay_held_0) - pathsabove_smallest) mod 64;
      pathsabove_cost(1) <= (to_integer(pathsabove_delay_held_0(23 downto 6)) - pathsabove_smallest) mod 64;
      pathsabove_cost(2) <= (to_integer(pathsabove_delay_held_0(23 downto 12)) - pathsabove_smallest) mod 64;
      pathsabove_cost(3) <= (to_integer(pathsabove_delay_held_0(23 downto 18)) - pathsabove_smallest) mod 64;
      pathsabove_held(0) <= pathsabove_cost(0);
      pathsabove_held(1) <= pathsabove_cost(1);
      pathsabove_held(2) <= pathsabove_cost(2);
      pathsabove_held(3) <= pathsabove_cost(3);
      pathsabove_lower_neighbour <= pathsabove_held(3);
      pathsabove_own(0) <= pathsabove_held(0);
      pathsabove_own(1) <= pathsabove_held(1);
      pathsabove_own(2) <= pathsabove_held(2);
      pathsabove_step(0) <= pathsabove_beside(0) + 5;
      pathsabove_step(1) <= pathsabove_beside(1) + 5;
      pathsabove_step(2) <= pathsabove_beside(2) + 5;
      pathsabove_step(3) <= pathsabove_beside(3) + 5;
      pathsabove_write_address_is_here <= (pathsabove_write_address_count_phase /= 15) or line_starts_phases(31);
      if line_starts_phases(4) then
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_choice;
        pathsabove_memory_read_address_1 <= pathsabove_memory_read_address_1_choice;
        pathsabove_read_address_count_phase <= 0;
      else
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_sum_2 mod 4096;
        pathsabove_memory_read_address_1 <= pathsabove_memory_read_address_0_sum_2 mod 16;
        pathsabove_read_address_count_phase <= pathsabove_read_address_count_phase_choice;
      end if;
      if pathsabove_memory_held_bank then
        pathsabove_memory_ready_words_0 <= pathsabove_memory_held_words_0(1);
        pathsabove_memory_ready_words_1 <= pathsabove_memory_held_words_1(1);
      else
        pathsabove_memory_ready_words_0 <= pathsabove_memory_held_words_0(0);
        pathsabove_memory_ready_words_1 <= pathsabove_memory_held_words_1(0);
      end if;
      if line_places_0_top then
        pathsabove_ready_top <= pathsabove_ready_top_choice;
      else
        pathsabove_ready_top <= pathsabove_ready_top_choice_2;
      end if;
      for i in 0 to 1 loop
        if (pathsabove_total(2 * i + 1) - pathsabove_total(2 * i)) < 0 then
          pathsabove_tree_smallest(i) <= pathsabove_total(2 * i + 1);
        else
          pathsabove_tree_smallest(i) <= pathsabove_total(2 * i);
        end if;
      end loop;
      if (pathsabove_tree_smallest(1) - pathsabove_tree_smallest(0)) < 0 then
        pathsabove_tree_next_smallest_0 <= pathsabove_tree_smallest(1);
      else
        pathsabove_tree_next_smallest_0 <= pathsabove_tree_smallest(0);
      end if;
      if (pathsabove_tree_next_smallest_0 - pathsabove_smallest_total_choice) < 0 then
        pathsabove_smallest_total <= pathsabove_tree_next_smallest_0;
      else
        pathsabove_smallest_total <= pathsabove_smallest_total_choice;
      end if;
      if line_starts_phases(29) then
        pathsabove_count_phase <= 0;
      else
        pathsabove_count_phase <= pathsabove_count_phase_choice;
      end if;
      if (pathsabove_held(1) - pathsabove_beside_0_choice) < 0 then
        pathsabove_beside(0) <= pathsabove_held(1);
      else
        pathsabove_beside(0) <= pathsabove_beside_0_choice;
      end if;
      for i in 2 to 3 loop
        if (pathsabove_held(i) - pathsabove_held(i - 2)) < 0 then
          pathsabove_beside(i - 1) <= pathsabove_held(i);
        else
          pathsabove_beside(i - 1) <= pathsabove_held(i - 2);
        end if;
      end loop;
      if (pathsabove_beside_3_choice - pathsabove_held(2)) < 0 then
        pathsabove_beside(3) <= pathsabove_beside_3_choice;
      else
        pathsabove_beside(3) <= pathsabove_held(2);
      end if;
      for i in 0 to 2 loop
        if pathsabove_own(i) < 31 then
          pathsabove_stay(i) <= pathsabove_own(i) mod 32;
        else
          pathsabove_stay(i) <= 31;
        end if;
      end loop;
      if pathsabove_lower_neighbour < 31 then
        pathsabove_stay(3) <= pathsabove_lower_neighbour mod 32;
      else
        pathsabove_stay(3) <= 31;
      end if;
      if line_starts_phases(31) then
        pathsabove_write_address_address <= pathsabove_write_address_address_choice;
        pathsabove_write_address_count_phase <= 0;
      else
        pathsabove_write_address_address <= (pathsabove_write_address_address + as_number(((not
          is_set(pathsabove_write_address_count_phase, 3)) or (not is_set(pathsabove_write_address_count_phase, 2)) or
          (not is_set(pathsabove_write_address_count_phase, 1)) or (not is_set(pathsabove_write_address_count_phase,
          0))))) mod 8192;
        pathsabove_write_address_count_phase <= pathsabove_write_address_count_phase_choice;
      end if;
      if (pathsabove_step(1) - pathsabove_stay(1)) < 0 then
        pathsabove_memory_write_words_0_choice(0) := pathsabove_step(1) mod 32;
      else
        pathsabove_memory_write_words_0_choice(0) := pathsabove_stay(1);
      end if;
      for i in 2 to 3 loop
        if (pathsabove_step(2 * i - 4) - pathsabove_stay(2 * i - 4)) < 0 then
          pathsabove_memory_write_words_0_0_choices(i) := pathsabove_step(2 * i - 4) mod 32;
        else
          pathsabove_memory_write_words_0_0_choices(i) := pathsabove_stay(2 * i - 4);
        end if;
      end loop;
      pathsabove_memory_write_words_0_0_is_less := (pathsabove_step(3) - pathsabove_stay(3)) < 0;
      if pathsabove_memory_write_words_0_0_is_less then
        pathsabove_memory_write_words_0_0_choice_4 := is_set(pathsabove_step(3), 0);
      else
        pathsabove_memory_write_words_0_0_choice_4 := is_set(pathsabove_stay(3), 0);
      end if;
      pathsabove_memory_write_words_0_0_sum := (pathsabove_memory_write_words_0_choice(0) * 32) +
        pathsabove_memory_write_words_0_0_choices(2) + (pathsabove_memory_write_words_0_0_choices(3) * 1024) +
        (as_number(pathsabove_memory_write_words_0_0_choice_4) * 32768);
      if pathsabove_memory_write_words_0_0_is_less then
        pathsabove_memory_write_words_0_choice(1) := pathsabove_step(3) mod 32;
      else
        pathsabove_memory_write_words_0_choice(1) := pathsabove_stay(3);
      end if;
      pathsabove_memory_write_words_0_all(0) := pathsabove_write_address_is_here and (pathsabove_write_address_address
        < 4096);
      if pathsabove_memory_write_words_0_all(0) then
        pathsabove_memory_write_words_0(0) <= pathsabove_memory_write_words_0_0_sum;
        pathsabove_memory_write_words_1(0) <= pathsabove_memory_write_words_0_choice(1) / 2;
        pathsabove_memory_write_address_0 <= pathsabove_write_address_address mod 4096;
      end if;
      pathsabove_memory_write_words_0_all(1) := (4095 < pathsabove_write_address_address) and
        pathsabove_write_address_is_here;
      if pathsabove_memory_write_words_0_all(1) then
        pathsabove_memory_write_words_0(1) <= pathsabove_memory_write_words_0_0_sum;
        pathsabove_memory_write_words_1(1) <= pathsabove_memory_write_words_0_choice(1) / 2;
        pathsabove_memory_write_address_1 <= pathsabove_write_address_address mod 16;
      end if;
      if line_comes(27) then
        pathsabove_smallest <= pathsabove_smallest_total;
      end if;
      -- pathsturn
      pathsturn_cost_memory_read_address_0_sum := pathsturn_read_address_address + as_number(((not
        is_set(pathsturn_read_address_count_phase, 3)) or (not is_set(pathsturn_read_address_count_phase, 2)) or (not
        is_set(pathsturn_read_address_count_phase, 1)) or (not is_set(pathsturn_read_address_count_phase, 0))));
      if line_starts_phases(23) then
        pathsturn_cost_memory_bank_choice := line_places_address(1) * 16;
      else
        pathsturn_cost_memory_bank_choice := pathsturn_cost_memory_read_address_0_sum mod 8192;
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
      pathsturn_sum_memory_read_address_1 <= pathsturn_sum_read_address mod 16;
      pathsturn_sum_memory_bank <= pathsturn_cost_memory_read_bank;
      pathsturn_sum_memory_read_bank <= pathsturn_cost_memory_held_bank;
      pathsturn_sum_memory_held_words_0(0) <= to_integer(pathsturn_sum_memory_read_words_0(0));
      pathsturn_sum_memory_held_words_1(0) <= to_integer(pathsturn_sum_memory_read_words_1(0));
      pathsturn_sum_memory_held_words_0(1) <= to_integer(pathsturn_sum_memory_read_words_0(1));
      pathsturn_sum_memory_held_words_1(1) <= to_integer(pathsturn_sum_memory_read_words_1(1));
      pathsturn_sum_memory_held_bank <= pathsturn_sum_memory_read_bank;
      pathsturn_cost_memory_bank <= is_set(pathsturn_cost_memory_bank_choice, 12);
      pathsturn_cost_memory_read_bank <= pathsturn_cost_memory_bank;
      pathsturn_cost_memory_held_words_0(0) <= to_integer(pathsturn_cost_memory_read_words_0(0));
      pathsturn_cost_memory_held_words_0(1) <= to_integer(pathsturn_cost_memory_read_words_0(1));
      pathsturn_cost_memory_held_bank <= is_set(pathsturn_sum_read_address, 12);
      pathsturn_ready_smallest_0 <= to_integer(pathsturn_read_smallest_0);
      pathsturn_read_address_address <= pathsturn_cost_memory_bank_choice;
      pathsturn_sum_read_address <= pathsturn_read_address_address;
      pathsturn_write_smallest_0 <= paths_smallest_cost;
      pathsturn_write_address_is_here <= (pathsturn_write_address_count_phase /= 15) or line_starts_phases(26);
      pathsturn_sum_write_address(0) <= pathsturn_write_address_address;
      pathsturn_sum_write_address(1) <= pathsturn_sum_write_address(0);
      pathsturn_writes_sums(0) <= pathsturn_write_address_is_here;
      pathsturn_writes_sums(1) <= pathsturn_writes_sums(0);
      if pathsturn_sum_memory_held_bank then
        pathsturn_sum_memory_ready_words_0 <= pathsturn_sum_memory_held_words_0(1);
        pathsturn_sum_memory_ready_words_1 <= pathsturn_sum_memory_held_words_1(1);
      else
        pathsturn_sum_memory_ready_words_0 <= pathsturn_sum_memory_held_words_0(0);
        pathsturn_sum_memory_ready_words_1 <= pathsturn_sum_memory_held_words_1(0);
      end if;
      if line_starts_phases(23) then
        pathsturn_cost_memory_read_address_0 <= (line_places_address(1) mod 256) * 16;
        pathsturn_cost_memory_read_address_1 <= 0;
        pathsturn_read_address_count_phase <= 0;
      else
        pathsturn_cost_memory_read_address_0 <= pathsturn_cost_memory_read_address_0_sum mod 4096;
        pathsturn_cost_memory_read_address_1 <= pathsturn_cost_memory_read_address_0_sum mod 16;
        pathsturn_read_address_count_phase <= pathsturn_read_address_count_phase_choice;
      end if;
      if pathsturn_sum_memory_bank then
        pathsturn_cost_memory_ready_words_0 <= pathsturn_cost_memory_held_words_0(1);
      else
        pathsturn_cost_memory_ready_words_0 <= pathsturn_cost_memory_held_words_0(0);
      end if;
      if line_starts_phases(26) then
        pathsturn_write_smallest_address <= line_places_address(1);
        pathsturn_write_address_address <= line_places_address(1) * 16;
        pathsturn_write_address_count_phase <= 0;
      else
        pathsturn_write_smallest_address <= 257;
        pathsturn_write_address_address <= (pathsturn_write_address_address + as_number(((not
          is_set(pathsturn_write_address_count_phase, 3)) or (not is_set(pathsturn_write_address_count_phase, 2)) or
          (not is_set(pathsturn_write_address_count_phase, 1)) or (not is_set(pathsturn_write_address_count_phase,
          0))))) mod 8192;
        pathsturn_write_address_count_phase <= pathsturn_write_address_count_phase_choice;
      end if;
      pathsturn_sum_memory_write_words_0_0_sum := pathsleft_cost(2) + pathsabove_cost(2);
      pathsturn_sum_memory_write_words_0_0_sum_2 := (((pathsleft_cost(1) + pathsabove_cost(1)) mod 128) * 128) +
        ((pathsleft_cost(0) + pathsabove_cost(0)) mod 128) + ((pathsturn_sum_memory_write_words_0_0_sum mod 4) * 16384);
      pathsturn_sum_memory_write_words_0_1_sum := (((pathsleft_cost(3) + pathsabove_cost(3)) mod 128) * 32) +
        ((pathsturn_sum_memory_write_words_0_0_sum mod 128) / 4);
      pathsturn_sum_memory_write_words_0_all(0) := (pathsturn_sum_write_address(1) < 4096) and pathsturn_writes_sums(1);
      if pathsturn_sum_memory_write_words_0_all(0) then
        pathsturn_sum_memory_write_words_0(0) <= pathsturn_sum_memory_write_words_0_0_sum_2;
        pathsturn_sum_memory_write_words_1(0) <= pathsturn_sum_memory_write_words_0_1_sum;
        pathsturn_sum_memory_write_address_0 <= pathsturn_sum_write_address(1) mod 4096;
      end if;
      pathsturn_sum_memory_write_words_0_all(1) := is_set(pathsturn_sum_write_address(1), 12) and
        pathsturn_writes_sums(1);
      if pathsturn_sum_memory_write_words_0_all(1) then
        pathsturn_sum_memory_write_words_0(1) <= pathsturn_sum_memory_write_words_0_0_sum_2;
        pathsturn_sum_memory_write_words_1(1) <= pathsturn_sum_memory_write_words_0_1_sum;
        pathsturn_sum_memory_write_address_1 <= pathsturn_sum_write_address(1) mod 16;
      end if;
      pathsturn_cost_memory_write_words_0_all(0) := pathsturn_write_address_is_here and
        (pathsturn_write_address_address < 4096);
      if pathsturn_cost_memory_write_words_0_all(0) then
        pathsturn_cost_memory_write_words_0(0) <= to_integer(paths_cost_delay_held_0);
        pathsturn_cost_memory_write_address_0 <= pathsturn_write_address_address mod 4096;
      end if;
      pathsturn_cost_memory_write_words_0_all(1) := (4095 < pathsturn_write_address_address) and
        pathsturn_write_address_is_here;
      if pathsturn_cost_memory_write_words_0_all(1) then
        pathsturn_cost_memory_write_words_0(1) <= to_integer(paths_cost_delay_held_0);
        pathsturn_cost_memory_write_address_1 <= pathsturn_write_address_address mod 16;
      end if;
      if line_starts_phases(23) then
        pathsturn_smallest_address <= line_places_address(1);
      end if;
      -- pathsright
      if (to_integer(pathsright_read_words(1)(6 downto 0)) - to_integer(pathsright_read_words(0)(6 downto 0))) < 0 then
        pathsright_stay_choice(0) := to_integer(pathsright_read_words(1)(6 downto 0));
      else
        pathsright_stay_choice(0) := to_integer(pathsright_read_words(0)(6 downto 0));
      end if;
      for i in 1 to 2 loop
        pathsright_stay_value(i) := to_integer(pathsright_read_words(1)(7 * i + 6 downto 7 * i));
        pathsright_stay_value_2(i) := to_integer(pathsright_read_words(0)(7 * i + 6 downto 7 * i));
        if (pathsright_stay_value(i) - pathsright_stay_value_2(i)) < 0 then
          pathsright_stay_choice(i) := pathsright_stay_value(i);
        else
          pathsright_stay_choice(i) := pathsright_stay_value_2(i);
        end if;
      end loop;
      if (to_integer(pathsright_read_words(1)(27 downto 21)) - to_integer(pathsright_read_words(0)(27 downto 21))) < 0
        then
        pathsright_stay_choice(3) := to_integer(pathsright_read_words(1)(27 downto 21));
      else
        pathsright_stay_choice(3) := to_integer(pathsright_read_words(0)(27 downto 21));
      end if;
      if line_starts_phases(27) then
        pathsright_step_choice(0) := pathsright_stay_value_2(1);
      else
        pathsright_step_choice(0) := pathsright_lower_neighbour;
      end if;
      if (pathsright_stay_value_2(1) - pathsright_step_choice(0)) < 0 then
        pathsright_step_0_choice_2 := pathsright_stay_value_2(1);
      else
        pathsright_step_0_choice_2 := pathsright_step_choice(0);
      end if;
      if (pathsright_stay_value_2(2) - to_integer(pathsright_read_words(0)(6 downto 0))) < 0 then
        pathsright_step_choice(1) := pathsright_stay_value_2(2);
      else
        pathsright_step_choice(1) := to_integer(pathsright_read_words(0)(6 downto 0));
      end if;
      if (to_integer(pathsright_read_words(0)(27 downto 21)) - pathsright_stay_value_2(1)) < 0 then
        pathsright_step_choice(2) := to_integer(pathsright_read_words(0)(27 downto 21));
      else
        pathsright_step_choice(2) := pathsright_stay_value_2(1);
      end if;
      if pathsleft_is_last then
        pathsright_step_choice(3) := pathsright_stay_value_2(2);
      else
        pathsright_step_choice(3) := to_integer(pathsright_read_neighbour_0);
      end if;
      if (pathsright_step_choice(3) - pathsright_stay_value_2(2)) < 0 then
        pathsright_step_3_choice_2 := pathsright_step_choice(3);
      else
        pathsright_step_3_choice_2 := pathsright_stay_value_2(2);
      end if;
      pathsright_stay_change_value(1) := (pathsturn_cost_memory_ready_words_0 mod 64) / 8;
      pathsright_stay_change_value(2) := (pathsturn_cost_memory_ready_words_0 / 64) mod 8;
      if line_comes(31) then
        pathsright_low_0_choice := 127;
      else
        pathsright_low_0_choice := pathsright_low_0;
      end if;
      pathsright_lost <= pathsright_lowest_0(6) = '1';
      pathsright_short_of <= ((to_integer(pathsleft_lowest_0(5 downto 0)) + pathsleft_room) / 64) = 1;
      pathsright_missing <= (to_integer(pathsright_lowest_0) + pathsright_room) mod 64;
      pathsright_below <= (0 - to_integer(pathsright_lowest_0)) mod 64;
      pathsright_lower_neighbour <= to_integer(pathsright_read_words(0)(27 downto 21));
      pathsright_stay_change(0) <= ((pathsturn_cost_memory_ready_words_0 mod 8) - pathsright_g) mod 128;
      pathsright_stay_change(1) <= (pathsright_stay_change_value(1) - pathsright_g) mod 128;
      pathsright_stay_change(2) <= (pathsright_stay_change_value(2) - pathsright_g) mod 128;
      pathsright_stay_change(3) <= ((pathsturn_cost_memory_ready_words_0 / 512) - pathsright_g) mod 128;
      pathsright_step_change(0) <= ((pathsturn_cost_memory_ready_words_0 mod 8) - pathsright_g_less) mod 128;
      pathsright_step_change(1) <= (pathsright_stay_change_value(1) - pathsright_g_less) mod 128;
      pathsright_step_change(2) <= (pathsright_stay_change_value(2) - pathsright_g_less) mod 128;
      pathsright_step_change(3) <= ((pathsturn_cost_memory_ready_words_0 / 512) - pathsright_g_less) mod 128;
      if (not pathsleft_first) and (not is_set(pathsright_stay_choice(0), 6)) then
        pathsright_stay(0) <= pathsright_stay_choice(0);
      else
        pathsright_stay(0) <= 64;
      end if;
      for i in 1 to 3 loop
        if (not is_set(pathsright_stay_choice(i), 6)) and (not pathsleft_first) then
          pathsright_stay(i) <= pathsright_stay_choice(i);
        else
          pathsright_stay(i) <= 64;
        end if;
      end loop;
      if pathsleft_first then
        pathsright_step(0) <= 64;
        pathsright_step(1) <= 64;
        pathsright_step(2) <= 64;
        pathsright_step(3) <= 64;
      else
        pathsright_step(0) <= pathsright_step_0_choice_2;
        pathsright_step(1) <= pathsright_step_choice(1);
        pathsright_step(2) <= pathsright_step_choice(2);
        pathsright_step(3) <= pathsright_step_3_choice_2;
      end if;
      for i in 0 to 1 loop
        if (pathsright_cost(2 * i + 1) - pathsright_cost(2 * i)) < 0 then
          pathsright_tree_smallest(i) <= pathsright_cost(2 * i + 1);
        else
          pathsright_tree_smallest(i) <= pathsright_cost(2 * i);
        end if;
      end loop;
      if (pathsright_tree_smallest(1) - pathsright_tree_smallest(0)) < 0 then
        pathsright_tree_next_smallest_0 <= pathsright_tree_smallest(1);
      else
        pathsright_tree_next_smallest_0 <= pathsright_tree_smallest(0);
      end if;
      if (pathsright_tree_next_smallest_0 - pathsright_low_0_choice) < 0 then
        pathsright_low_0 <= pathsright_tree_next_smallest_0;
      else
        pathsright_low_0 <= pathsright_low_0_choice;
      end if;
      if pathsleft_short_of then
        pathsright_q_choice := pathsright_missing;
      else
        pathsright_q_choice := 0;
      end if;
      if pathsright_lost then
        pathsright_q_choice_2 := pathsright_room;
      else
        pathsright_q_choice_2 := pathsright_q_choice;
      end if;
      if pathsleft_short_of then
        pathsright_room_left_choice := pathsright_below;
      else
        pathsright_room_left_choice := pathsright_room;
      end if;
      if line_starts_phases(24) then
        if line_places_first_column(1) then
          pathsright_q <= 60;
        else
          pathsright_q <= pathsright_q_choice_2;
        end if;
        if pathsright_lost then
          pathsright_room_left <= 0;
        else
          pathsright_room_left <= pathsright_room_left_choice;
        end if;
      end if;
      if line_starts_phases(25) then
        pathsright_q_now <= pathsright_q;
        pathsright_q_less <= (pathsright_q + 121) mod 128;
        if line_places_first_column(1) then
          pathsright_room <= 0;
          for i in 1 to 8 loop
            pathsright_start_cost(i) <= 0;
          end loop;
        else
          pathsright_room <= (pathsright_room_left + pathsright_start_cost(8)) mod 64;
          pathsright_start_cost(1) <= pathsright_q_now;
          for i in 2 to 8 loop
            pathsright_start_cost(i) <= pathsright_start_cost(i - 1);
          end loop;
        end if;
      end if;
      if line_starts_phases(26) then
        pathsright_g <= pathsturn_ready_smallest_0 + pathsright_q_now;
        pathsright_g_less <= (pathsturn_ready_smallest_0 + pathsright_q_less) mod 128;
      end if;
      if pathsleft_cost_0_any then
        pathsright_cost(0) <= (pathsright_stay(0) + pathsright_stay_change(0)) mod 128;
        pathsright_cost(1) <= (pathsright_stay(1) + pathsright_stay_change(1)) mod 128;
        pathsright_cost(2) <= (pathsright_stay(2) + pathsright_stay_change(2)) mod 128;
        pathsright_cost(3) <= (pathsright_stay(3) + pathsright_stay_change(3)) mod 128;
        pathsright_arrived(0) <= (pathsright_step(0) + pathsright_step_change(0)) mod 128;
        pathsright_arrived(1) <= (pathsright_step(1) + pathsright_step_change(1)) mod 128;
        pathsright_arrived(2) <= (pathsright_step(2) + pathsright_step_change(2)) mod 128;
        pathsright_arrived(3) <= (pathsright_step(3) + pathsright_step_change(3)) mod 128;
      end if;
      -- winnerswinner1
      if is_set(paths_sum(0), 0) then
        winnerswinner1_best_index_0_choice(0) := (not is_set(paths_sum(1), 1)) or (not is_set(paths_sum(1), 0));
      else
        winnerswinner1_best_index_0_choice(0) := not is_set(paths_sum(1), 1);
      end if;
      if is_set(paths_sum(0), 1) then
        winnerswinner1_best_index_0_0_choices(2) := winnerswinner1_best_index_0_choice(0);
      else
        winnerswinner1_best_index_0_0_choices(2) := is_set(paths_sum(0), 0) and ((paths_sum(1) mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_value(0) := is_set(paths_sum(1), 2);
      if winnerswinner1_best_index_0_0_choices(2) then
        winnerswinner1_best_index_0_0_choices(3) := (not is_set(paths_sum(0), 2)) and
          winnerswinner1_best_index_0_value(0);
      else
        winnerswinner1_best_index_0_0_choices(3) := (not is_set(paths_sum(0), 2)) or
          winnerswinner1_best_index_0_value(0);
      end if;
      for i in 2 to 5 loop
        winnerswinner1_best_index_0_values(0, i) := is_set(paths_sum(1), i + 1);
        if winnerswinner1_best_index_0_0_choices(i + 1) then
          winnerswinner1_best_index_0_0_choices(i + 2) := (not is_set(paths_sum(0), i + 1)) or
            winnerswinner1_best_index_0_values(0, i);
        else
          winnerswinner1_best_index_0_0_choices(i + 2) := (not is_set(paths_sum(0), i + 1)) and
            winnerswinner1_best_index_0_values(0, i);
        end if;
      end loop;
      if is_set(paths_sum(2), 0) then
        winnerswinner1_best_index_0_choice(1) := (not is_set(paths_sum(3), 1)) or (not is_set(paths_sum(3), 0));
      else
        winnerswinner1_best_index_0_choice(1) := not is_set(paths_sum(3), 1);
      end if;
      if is_set(paths_sum(2), 1) then
        winnerswinner1_best_index_0_1_choices(2) := winnerswinner1_best_index_0_choice(1);
      else
        winnerswinner1_best_index_0_1_choices(2) := is_set(paths_sum(2), 0) and ((paths_sum(3) mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_value(1) := is_set(paths_sum(3), 2);
      if winnerswinner1_best_index_0_1_choices(2) then
        winnerswinner1_best_index_0_1_choices(3) := (not is_set(paths_sum(2), 2)) and
          winnerswinner1_best_index_0_value(1);
      else
        winnerswinner1_best_index_0_1_choices(3) := (not is_set(paths_sum(2), 2)) or
          winnerswinner1_best_index_0_value(1);
      end if;
      for i in 2 to 5 loop
        winnerswinner1_best_index_0_values(1, i) := is_set(paths_sum(3), i + 1);
        if winnerswinner1_best_index_0_1_choices(i + 1) then
          winnerswinner1_best_index_0_1_choices(i + 2) := (not is_set(paths_sum(2), i + 1)) or
            winnerswinner1_best_index_0_values(1, i);
        else
          winnerswinner1_best_index_0_1_choices(i + 2) := (not is_set(paths_sum(2), i + 1)) and
            winnerswinner1_best_index_0_values(1, i);
        end if;
      end loop;
      if winnerswinner1_best_index_0_1_choices(7) then
        winnerswinner1_best_index_0_1_choices(8) := is_set(paths_sum(2), 7) and (not is_set(paths_sum(3), 7));
      else
        winnerswinner1_best_index_0_1_choices(8) := is_set(paths_sum(2), 7) or (not is_set(paths_sum(3), 7));
      end if;
      for i in 0 to 1 loop
        if (paths_sum(2 * i + 1) - paths_sum(2 * i)) < 0 then
          winnerswinner1_best_cost_0(i) <= paths_sum(2 * i + 1);
        else
          winnerswinner1_best_cost_0(i) <= paths_sum(2 * i);
        end if;
      end loop;
      if winnerswinner1_best_index_0_0_choices(7) then
        winnerswinner1_best_index_0_0 <= is_set(paths_sum(0), 7) and (not is_set(paths_sum(1), 7));
      else
        winnerswinner1_best_index_0_0 <= is_set(paths_sum(0), 7) or (not is_set(paths_sum(1), 7));
      end if;
      if winnerswinner1_best_index_0_1_choices(8) then
        winnerswinner1_best_index_0_1 <= 3;
      else
        winnerswinner1_best_index_0_1 <= 2;
      end if;
      if in_valid then
        if in_start_of_frame then
          winnerswinner1_best_below_0 <= transform_counter_next_frame;
        else
          winnerswinner1_best_below_0 <= transform_counter_frame_joins;
        end if;
      end if;
      -- winnerswinner2
      if is_set(winnerswinner1_best_cost_0(0), 0) then
        winnerswinner2_best_index_0_0_choice := (not is_set(winnerswinner1_best_cost_0(1), 1)) or (not
          is_set(winnerswinner1_best_cost_0(1), 0));
      else
        winnerswinner2_best_index_0_0_choice := not is_set(winnerswinner1_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(0), 1) then
        winnerswinner2_best_index_0_0_choices(2) := winnerswinner2_best_index_0_0_choice;
      else
        winnerswinner2_best_index_0_0_choices(2) := is_set(winnerswinner1_best_cost_0(0), 0) and
          ((winnerswinner1_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner2_best_index_0_0_value := is_set(winnerswinner1_best_cost_0(1), 2);
      if winnerswinner2_best_index_0_0_choices(2) then
        winnerswinner2_best_index_0_0_choices(3) := (not is_set(winnerswinner1_best_cost_0(0), 2)) and
          winnerswinner2_best_index_0_0_value;
      else
        winnerswinner2_best_index_0_0_choices(3) := (not is_set(winnerswinner1_best_cost_0(0), 2)) or
          winnerswinner2_best_index_0_0_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_best_index_0_0_values(i) := is_set(winnerswinner1_best_cost_0(1), i + 1);
        if winnerswinner2_best_index_0_0_choices(i + 1) then
          winnerswinner2_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(0), i + 1)) or
            winnerswinner2_best_index_0_0_values(i);
        else
          winnerswinner2_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(0), i + 1)) and
            winnerswinner2_best_index_0_0_values(i);
        end if;
      end loop;
      if winnerswinner2_best_index_0_0_choices(7) then
        winnerswinner2_best_index_0_0_choices(8) := is_set(winnerswinner1_best_cost_0(0), 7) and (not
          is_set(winnerswinner1_best_cost_0(1), 7));
      else
        winnerswinner2_best_index_0_0_choices(8) := is_set(winnerswinner1_best_cost_0(0), 7) or (not
          is_set(winnerswinner1_best_cost_0(1), 7));
      end if;
      if (winnerswinner1_best_cost_0(1) - winnerswinner1_best_cost_0(0)) < 0 then
        winnerswinner2_best_cost_0_0 <= winnerswinner1_best_cost_0(1);
      else
        winnerswinner2_best_cost_0_0 <= winnerswinner1_best_cost_0(0);
      end if;
      if winnerswinner2_best_index_0_0_choices(8) then
        winnerswinner2_best_index_0_0 <= winnerswinner1_best_index_0_1;
      else
        winnerswinner2_best_index_0_0 <= as_number(winnerswinner1_best_index_0_0);
      end if;
      -- winners
      if line_comes(32) then
        winners_best_cost_0_0_choice := 511;
      else
        winners_best_cost_0_0_choice := winners_best_cost_0_0;
      end if;
      if line_comes(32) then
        winners_best_cost_0_0_choice_2 := 255;
      else
        winners_best_cost_0_0_choice_2 := winners_best_cost_0_0;
      end if;
      winners_best_tag_valid <= line_comes(47);
      winners_best_tag_map_column <= line_places_map_column(2);
      winners_best_tag_output_column <= line_places_shown_output_column(2);
      winners_best_tag_start_of_frame <= line_places_shown_start_of_frame(2);
      winners_best_tag_end_of_line <= line_places_shown_end_of_line(2);
      if (winners_best_cost_0_0_choice - winnerswinner2_best_cost_0_0) < 0 then
        winners_best_cost_0_0 <= winners_best_cost_0_0_choice_2;
      else
        winners_best_cost_0_0 <= winnerswinner2_best_cost_0_0;
      end if;
      if (winnerswinner2_best_cost_0_0 - winners_best_cost_0_0_choice) < 0 then
        winners_best_index_0_0 <= winnerswinner2_best_index_0_0 + 60;
      else
        winners_best_index_0_0 <= ((((winners_best_index_0_0 / 4) + 63) mod 64) * 4) + (winners_best_index_0_0 mod 4);
      end if;
      -- turn
      turn_order_address_any := turn_order_inside or (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 511;
      else
        turn_order_address_choice := 1;
      end if;
      turn_order_address_any_2 := (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 512;
        else
          turn_order_address <= as_number((not turn_order_falls)) * 256;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and winners_best_tag_map_column and winners_best_tag_valid;
      turn_order_complete_all := winners_best_tag_map_column and winners_best_tag_valid;
      turn_ready_tag_row_start_is_equal := map_counter_group = 240;
      if turn_ready_tag_row_start_is_equal then
        turn_ready_tag_row_start_choice := (map_counter_column /= 256) and turn_ready_tag_row_start;
      else
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start;
      end if;
      if map_counter_group = 241 then
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start;
      else
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start_choice;
      end if;
      turn_ready_tag_row_start_is_equals(2) := map_counter_column = 256;
      turn_ready_tag_row_start_is_equals(3) := map_counter_group = 239;
      turn_ready_tag_row_start_all := turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_row_start_is_equals(3);
      if turn_ready_tag_row_start_choices(2) then
        turn_ready_tag_row_start_choices(3) := turn_ready_tag_row_start_all or (not turn_ready_tag_start_of_frame);
      else
        turn_ready_tag_row_start_choices(3) := turn_ready_tag_row_start_is_equals(2) and
          turn_ready_tag_row_start_is_equals(3) and turn_ready_tag_start_of_frame;
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
        turn_write_place <= 257;
      end if;
      if turn_ready_tag_row_start_choices(3) then
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
        if turn_ready_tag_start_of_frame or turn_ready_tag_row_start_is_equals(2) then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 512;
        end if;
      end if;
      if turn_ready_tag_row_start_all then
        map_counter_group_choice := 15;
      else
        map_counter_group_choice := 0;
      end if;
      if turn_ready_tag_row_start_is_equal and turn_ready_tag_row_start then
        map_counter_group_choices(2) := 1;
      else
        map_counter_group_choices(2) := (map_counter_group + 1) mod 256;
      end if;
      if (map_counter_group /= 241) and turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_valid and
        turn_ready_tag_map_column then
        map_counter_group_choices(3) := map_counter_group_choices(2);
      else
        map_counter_group_choices(3) := map_counter_group;
      end if;
      if turn_ready_tag_valid then
        map_line_ended_choice := turn_ready_tag_map_column;
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := other(1)(16) = '1';
      map_of_column_0_b_below_a_value := is_set(map_column(1), 2);
      if map_at_top then
        map_of_column_0_b_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_b_below_a_choice := is_set(other_2, 2);
      end if;
      map_of_column_0_b_below_a_values(2) := is_set(map_column(1), 1);
      if map_at_top then
        map_of_column_0_b_below_a_choices(2) := map_of_column_0_b_below_a_values(2);
      else
        map_of_column_0_b_below_a_choices(2) := is_set(other_2, 1);
      end if;
      if map_of_column_0_b_below_a_choices(2) then
        map_of_column_0_b_below_a_choices(3) := (not map_of_column_0_b_below_a_value) or (not
          map_of_column_0_b_below_a_values(2));
      else
        map_of_column_0_b_below_a_choices(3) := not map_of_column_0_b_below_a_value;
      end if;
      if map_of_column_0_b_below_a_choice then
        map_of_column_0_b_below_a_choices(4) := map_of_column_0_b_below_a_choices(3);
      else
        map_of_column_0_b_below_a_choices(4) := map_of_column_0_b_below_a_choices(2) and (((map_column(1) / 2) mod 4) =
          0);
      end if;
      map_of_column_0_b_below_a_values(3) := is_set(map_column(1), 3);
      map_of_column_0_b_below_a_values(4) := is_set(other_2, 3);
      if map_of_column_0_b_below_a_choices(4) then
        map_of_column_0_b_below_a_choices(5) := map_of_column_0_b_below_a_values(3) and (not
          map_of_column_0_b_below_a_values(4)) and (not map_at_top);
      else
        map_of_column_0_b_below_a_choices(5) := map_of_column_0_b_below_a_values(3) or (not
          map_of_column_0_b_below_a_values(4)) or map_at_top;
      end if;
      for i in 4 to 7 loop
        map_of_column_0_b_below_a_values(2 * i - 3) := is_set(map_column(1), i);
        map_of_column_0_b_below_a_values(2 * i - 2) := is_set(other_2, i);
        if map_of_column_0_b_below_a_choices(i + 1) then
          map_of_column_0_b_below_a_choices(i + 2) := map_of_column_0_b_below_a_values(2 * i - 3) or (not
            map_of_column_0_b_below_a_values(2 * i - 2)) or map_at_top;
        else
          map_of_column_0_b_below_a_choices(i + 2) := map_of_column_0_b_below_a_values(2 * i - 3) and (not
            map_of_column_0_b_below_a_values(2 * i - 2)) and (not map_at_top);
        end if;
      end loop;
      map_of_column_0_c_below_a_value := is_set(map_column(2), 2);
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_c_below_a_choice := map_of_column_0_c_below_a_value;
      end if;
      map_of_column_0_c_below_a_values(2) := is_set(map_column(2), 1);
      if map_of_column_0_c_below_a_values(2) then
        map_of_column_0_c_below_a_choices(2) := (not map_of_column_0_b_below_a_values(2)) and map_counter_next_frame;
      else
        map_of_column_0_c_below_a_choices(2) := (not map_of_column_0_b_below_a_values(2)) or (not
          map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_a_choice then
        map_of_column_0_c_below_a_choices(3) := map_of_column_0_b_below_a_choices(2) and
          map_of_column_0_c_below_a_choices(2) and map_of_column_0_b_below_a_choice;
      else
        map_of_column_0_c_below_a_choices(3) := (map_of_column_0_b_below_a_choices(2) and
          map_of_column_0_c_below_a_choices(2)) or map_of_column_0_b_below_a_choice;
      end if;
      for i in 3 to 7 loop
        map_of_column_0_c_below_a_values(i) := is_set(map_column(2), i);
        if map_counter_next_frame then
          map_of_column_0_c_below_a_choices(3 * i - 5) := map_of_column_0_b_below_a_values(2 * i - 3);
        else
          map_of_column_0_c_below_a_choices(3 * i - 5) := map_of_column_0_c_below_a_values(i);
        end if;
        if map_at_top then
          map_of_column_0_c_below_a_choices(3 * i - 4) := map_of_column_0_b_below_a_values(2 * i - 3);
        else
          map_of_column_0_c_below_a_choices(3 * i - 4) := map_of_column_0_b_below_a_values(2 * i - 2);
        end if;
        if map_of_column_0_c_below_a_choices(3 * i - 6) then
          map_of_column_0_c_below_a_choices(3 * i - 3) := (not map_of_column_0_c_below_a_choices(3 * i - 5)) or
            map_of_column_0_c_below_a_choices(3 * i - 4);
        else
          map_of_column_0_c_below_a_choices(3 * i - 3) := (not map_of_column_0_c_below_a_choices(3 * i - 5)) and
            map_of_column_0_c_below_a_choices(3 * i - 4);
        end if;
      end loop;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choices(19) := is_set(map_column(1), 8);
      else
        map_of_column_0_c_below_a_choices(19) := is_set(map_column(2), 8);
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choices(20) := is_set(map_column(1), 8);
      else
        map_of_column_0_c_below_a_choices(20) := is_set(other_2, 8);
      end if;
      if (not map_of_column_0_c_below_a_values(2)) and map_of_column_0_b_below_a_values(2) and (not
        map_counter_next_frame) then
        map_of_column_0_c_below_b_choice := map_of_column_0_c_below_a_value and (not map_of_column_0_b_below_a_value)
          and (not map_counter_next_frame);
      else
        map_of_column_0_c_below_b_choice := map_of_column_0_c_below_a_value or (not map_of_column_0_b_below_a_value) or
          map_counter_next_frame;
      end if;
      if map_of_column_0_c_below_b_choice then
        map_of_column_0_c_below_b_choices(2) := map_of_column_0_c_below_a_values(3) or (not
          map_of_column_0_b_below_a_values(3)) or map_counter_next_frame;
      else
        map_of_column_0_c_below_b_choices(2) := map_of_column_0_c_below_a_values(3) and (not
          map_of_column_0_b_below_a_values(3)) and (not map_counter_next_frame);
      end if;
      for i in 2 to 5 loop
        if map_of_column_0_c_below_b_choices(i) then
          map_of_column_0_c_below_b_choices(i + 1) := map_of_column_0_c_below_a_values(i + 2) or (not
            map_of_column_0_b_below_a_values(2 * i + 1)) or map_counter_next_frame;
        else
          map_of_column_0_c_below_b_choices(i + 1) := map_of_column_0_c_below_a_values(i + 2) and (not
            map_of_column_0_b_below_a_values(2 * i + 1)) and (not map_counter_next_frame);
        end if;
      end loop;
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
      map_of_low_0_b_below_a_value := is_set(map_low_0(0), 1);
      if is_set(map_low_0(0), 0) then
        map_of_low_0_b_below_a_choice := (not is_set(map_low_0(1), 1)) or (not is_set(map_low_0(1), 0));
      else
        map_of_low_0_b_below_a_choice := not is_set(map_low_0(1), 1);
      end if;
      map_of_low_0_b_below_a_is_equal := (map_low_0(1) mod 4) = 0;
      if map_of_low_0_b_below_a_value then
        map_of_low_0_b_below_a_choices(2) := map_of_low_0_b_below_a_choice;
      else
        map_of_low_0_b_below_a_choices(2) := is_set(map_low_0(0), 0) and map_of_low_0_b_below_a_is_equal;
      end if;
      map_of_low_0_b_below_a_values(2) := is_set(map_low_0(0), 2);
      map_of_low_0_b_below_a_values(3) := is_set(map_low_0(1), 2);
      if map_of_low_0_b_below_a_choices(2) then
        map_of_low_0_b_below_a_choices(3) := (not map_of_low_0_b_below_a_values(2)) and
          map_of_low_0_b_below_a_values(3);
      else
        map_of_low_0_b_below_a_choices(3) := (not map_of_low_0_b_below_a_values(2)) or map_of_low_0_b_below_a_values(3);
      end if;
      for i in 3 to 6 loop
        map_of_low_0_b_below_a_values(2 * i - 2) := is_set(map_low_0(0), i);
        map_of_low_0_b_below_a_values(2 * i - 1) := is_set(map_low_0(1), i);
        if map_of_low_0_b_below_a_choices(i) then
          map_of_low_0_b_below_a_choices(i + 1) := (not map_of_low_0_b_below_a_values(2 * i - 2)) or
            map_of_low_0_b_below_a_values(2 * i - 1);
        else
          map_of_low_0_b_below_a_choices(i + 1) := (not map_of_low_0_b_below_a_values(2 * i - 2)) and
            map_of_low_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_low_0_c_below_a_value := is_set(map_low_0(2), 1);
      if is_set(map_low_0(2), 0) then
        map_of_low_0_c_below_a_choice := not map_of_low_0_b_below_a_value;
      else
        map_of_low_0_c_below_a_choice := (map_low_0(0) mod 4) = 0;
      end if;
      if map_of_low_0_c_below_a_value then
        map_of_low_0_c_below_a_choices(2) := is_set(map_low_0(2), 0) or (not map_of_low_0_b_below_a_value) or (not
          is_set(map_low_0(0), 0));
      else
        map_of_low_0_c_below_a_choices(2) := map_of_low_0_c_below_a_choice;
      end if;
      if map_of_low_0_c_below_a_choices(2) then
        map_of_low_0_c_below_a_choices(3) := (not is_set(map_low_0(2), 2)) and map_of_low_0_b_below_a_values(2);
      else
        map_of_low_0_c_below_a_choices(3) := (not is_set(map_low_0(2), 2)) or map_of_low_0_b_below_a_values(2);
      end if;
      for i in 3 to 6 loop
        if map_of_low_0_c_below_a_choices(i) then
          map_of_low_0_c_below_a_choices(i + 1) := (not is_set(map_low_0(2), i)) or map_of_low_0_b_below_a_values(2 * i
            - 2);
        else
          map_of_low_0_c_below_a_choices(i + 1) := (not is_set(map_low_0(2), i)) and map_of_low_0_b_below_a_values(2 *
            i - 2);
        end if;
      end loop;
      if is_set(map_low_0(2), 0) then
        map_of_low_0_c_below_b_choice := not is_set(map_low_0(1), 1);
      else
        map_of_low_0_c_below_b_choice := map_of_low_0_b_below_a_is_equal;
      end if;
      if map_of_low_0_c_below_a_value then
        map_of_low_0_c_below_b_choices(2) := is_set(map_low_0(2), 0) or (not is_set(map_low_0(1), 1)) or (not
          is_set(map_low_0(1), 0));
      else
        map_of_low_0_c_below_b_choices(2) := map_of_low_0_c_below_b_choice;
      end if;
      if map_of_low_0_c_below_b_choices(2) then
        map_of_low_0_c_below_b_choices(3) := (not is_set(map_low_0(2), 2)) and map_of_low_0_b_below_a_values(3);
      else
        map_of_low_0_c_below_b_choices(3) := (not is_set(map_low_0(2), 2)) or map_of_low_0_b_below_a_values(3);
      end if;
      for i in 3 to 6 loop
        if map_of_low_0_c_below_b_choices(i) then
          map_of_low_0_c_below_b_choices(i + 1) := (not is_set(map_low_0(2), i)) or map_of_low_0_b_below_a_values(2 * i
            - 1);
        else
          map_of_low_0_c_below_b_choices(i + 1) := (not is_set(map_low_0(2), i)) and map_of_low_0_b_below_a_values(2 *
            i - 1);
        end if;
      end loop;
      map_of_middle_0_b_below_a_value := is_set(map_middle_0(0), 1);
      if is_set(map_middle_0(0), 0) then
        map_of_middle_0_b_below_a_choice := (not is_set(map_middle_0(1), 1)) or (not is_set(map_middle_0(1), 0));
      else
        map_of_middle_0_b_below_a_choice := not is_set(map_middle_0(1), 1);
      end if;
      map_of_middle_0_b_below_a_is_equal := (map_middle_0(1) mod 4) = 0;
      if map_of_middle_0_b_below_a_value then
        map_of_middle_0_b_below_a_choices(2) := map_of_middle_0_b_below_a_choice;
      else
        map_of_middle_0_b_below_a_choices(2) := is_set(map_middle_0(0), 0) and map_of_middle_0_b_below_a_is_equal;
      end if;
      map_of_middle_0_b_below_a_values(2) := is_set(map_middle_0(0), 2);
      map_of_middle_0_b_below_a_values(3) := is_set(map_middle_0(1), 2);
      if map_of_middle_0_b_below_a_choices(2) then
        map_of_middle_0_b_below_a_choices(3) := (not map_of_middle_0_b_below_a_values(2)) and
          map_of_middle_0_b_below_a_values(3);
      else
        map_of_middle_0_b_below_a_choices(3) := (not map_of_middle_0_b_below_a_values(2)) or
          map_of_middle_0_b_below_a_values(3);
      end if;
      for i in 3 to 6 loop
        map_of_middle_0_b_below_a_values(2 * i - 2) := is_set(map_middle_0(0), i);
        map_of_middle_0_b_below_a_values(2 * i - 1) := is_set(map_middle_0(1), i);
        if map_of_middle_0_b_below_a_choices(i) then
          map_of_middle_0_b_below_a_choices(i + 1) := (not map_of_middle_0_b_below_a_values(2 * i - 2)) or
            map_of_middle_0_b_below_a_values(2 * i - 1);
        else
          map_of_middle_0_b_below_a_choices(i + 1) := (not map_of_middle_0_b_below_a_values(2 * i - 2)) and
            map_of_middle_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_middle_0_c_below_a_value := is_set(map_middle_0(2), 1);
      if is_set(map_middle_0(2), 0) then
        map_of_middle_0_c_below_a_choice := not map_of_middle_0_b_below_a_value;
      else
        map_of_middle_0_c_below_a_choice := (map_middle_0(0) mod 4) = 0;
      end if;
      if map_of_middle_0_c_below_a_value then
        map_of_middle_0_c_below_a_choices(2) := is_set(map_middle_0(2), 0) or (not map_of_middle_0_b_below_a_value) or
          (not is_set(map_middle_0(0), 0));
      else
        map_of_middle_0_c_below_a_choices(2) := map_of_middle_0_c_below_a_choice;
      end if;
      if map_of_middle_0_c_below_a_choices(2) then
        map_of_middle_0_c_below_a_choices(3) := (not is_set(map_middle_0(2), 2)) and
          map_of_middle_0_b_below_a_values(2);
      else
        map_of_middle_0_c_below_a_choices(3) := (not is_set(map_middle_0(2), 2)) or map_of_middle_0_b_below_a_values(2);
      end if;
      for i in 3 to 6 loop
        if map_of_middle_0_c_below_a_choices(i) then
          map_of_middle_0_c_below_a_choices(i + 1) := (not is_set(map_middle_0(2), i)) or
            map_of_middle_0_b_below_a_values(2 * i - 2);
        else
          map_of_middle_0_c_below_a_choices(i + 1) := (not is_set(map_middle_0(2), i)) and
            map_of_middle_0_b_below_a_values(2 * i - 2);
        end if;
      end loop;
      if is_set(map_middle_0(2), 0) then
        map_of_middle_0_c_below_b_choice := not is_set(map_middle_0(1), 1);
      else
        map_of_middle_0_c_below_b_choice := map_of_middle_0_b_below_a_is_equal;
      end if;
      if map_of_middle_0_c_below_a_value then
        map_of_middle_0_c_below_b_choices(2) := is_set(map_middle_0(2), 0) or (not is_set(map_middle_0(1), 1)) or (not
          is_set(map_middle_0(1), 0));
      else
        map_of_middle_0_c_below_b_choices(2) := map_of_middle_0_c_below_b_choice;
      end if;
      if map_of_middle_0_c_below_b_choices(2) then
        map_of_middle_0_c_below_b_choices(3) := (not is_set(map_middle_0(2), 2)) and
          map_of_middle_0_b_below_a_values(3);
      else
        map_of_middle_0_c_below_b_choices(3) := (not is_set(map_middle_0(2), 2)) or map_of_middle_0_b_below_a_values(3);
      end if;
      for i in 3 to 6 loop
        if map_of_middle_0_c_below_b_choices(i) then
          map_of_middle_0_c_below_b_choices(i + 1) := (not is_set(map_middle_0(2), i)) or
            map_of_middle_0_b_below_a_values(2 * i - 1);
        else
          map_of_middle_0_c_below_b_choices(i + 1) := (not is_set(map_middle_0(2), i)) and
            map_of_middle_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_high_0_b_below_a_value := is_set(map_high_0(0), 1);
      if is_set(map_high_0(0), 0) then
        map_of_high_0_b_below_a_choice := (not is_set(map_high_0(1), 1)) or (not is_set(map_high_0(1), 0));
      else
        map_of_high_0_b_below_a_choice := not is_set(map_high_0(1), 1);
      end if;
      map_of_high_0_b_below_a_is_equal := (map_high_0(1) mod 4) = 0;
      if map_of_high_0_b_below_a_value then
        map_of_high_0_b_below_a_choices(2) := map_of_high_0_b_below_a_choice;
      else
        map_of_high_0_b_below_a_choices(2) := is_set(map_high_0(0), 0) and map_of_high_0_b_below_a_is_equal;
      end if;
      map_of_high_0_b_below_a_values(2) := is_set(map_high_0(0), 2);
      map_of_high_0_b_below_a_values(3) := is_set(map_high_0(1), 2);
      if map_of_high_0_b_below_a_choices(2) then
        map_of_high_0_b_below_a_choices(3) := (not map_of_high_0_b_below_a_values(2)) and
          map_of_high_0_b_below_a_values(3);
      else
        map_of_high_0_b_below_a_choices(3) := (not map_of_high_0_b_below_a_values(2)) or
          map_of_high_0_b_below_a_values(3);
      end if;
      for i in 3 to 6 loop
        map_of_high_0_b_below_a_values(2 * i - 2) := is_set(map_high_0(0), i);
        map_of_high_0_b_below_a_values(2 * i - 1) := is_set(map_high_0(1), i);
        if map_of_high_0_b_below_a_choices(i) then
          map_of_high_0_b_below_a_choices(i + 1) := (not map_of_high_0_b_below_a_values(2 * i - 2)) or
            map_of_high_0_b_below_a_values(2 * i - 1);
        else
          map_of_high_0_b_below_a_choices(i + 1) := (not map_of_high_0_b_below_a_values(2 * i - 2)) and
            map_of_high_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_high_0_c_below_a_value := is_set(map_high_0(2), 1);
      if is_set(map_high_0(2), 0) then
        map_of_high_0_c_below_a_choice := not map_of_high_0_b_below_a_value;
      else
        map_of_high_0_c_below_a_choice := (map_high_0(0) mod 4) = 0;
      end if;
      if map_of_high_0_c_below_a_value then
        map_of_high_0_c_below_a_choices(2) := is_set(map_high_0(2), 0) or (not map_of_high_0_b_below_a_value) or (not
          is_set(map_high_0(0), 0));
      else
        map_of_high_0_c_below_a_choices(2) := map_of_high_0_c_below_a_choice;
      end if;
      if map_of_high_0_c_below_a_choices(2) then
        map_of_high_0_c_below_a_choices(3) := (not is_set(map_high_0(2), 2)) and map_of_high_0_b_below_a_values(2);
      else
        map_of_high_0_c_below_a_choices(3) := (not is_set(map_high_0(2), 2)) or map_of_high_0_b_below_a_values(2);
      end if;
      for i in 3 to 6 loop
        if map_of_high_0_c_below_a_choices(i) then
          map_of_high_0_c_below_a_choices(i + 1) := (not is_set(map_high_0(2), i)) or map_of_high_0_b_below_a_values(2
            * i - 2);
        else
          map_of_high_0_c_below_a_choices(i + 1) := (not is_set(map_high_0(2), i)) and map_of_high_0_b_below_a_values(2
            * i - 2);
        end if;
      end loop;
      if is_set(map_high_0(2), 0) then
        map_of_high_0_c_below_b_choice := not is_set(map_high_0(1), 1);
      else
        map_of_high_0_c_below_b_choice := map_of_high_0_b_below_a_is_equal;
      end if;
      if map_of_high_0_c_below_a_value then
        map_of_high_0_c_below_b_choices(2) := is_set(map_high_0(2), 0) or (not is_set(map_high_0(1), 1)) or (not
          is_set(map_high_0(1), 0));
      else
        map_of_high_0_c_below_b_choices(2) := map_of_high_0_c_below_b_choice;
      end if;
      if map_of_high_0_c_below_b_choices(2) then
        map_of_high_0_c_below_b_choices(3) := (not is_set(map_high_0(2), 2)) and map_of_high_0_b_below_a_values(3);
      else
        map_of_high_0_c_below_b_choices(3) := (not is_set(map_high_0(2), 2)) or map_of_high_0_b_below_a_values(3);
      end if;
      for i in 3 to 6 loop
        if map_of_high_0_c_below_b_choices(i) then
          map_of_high_0_c_below_b_choices(i + 1) := (not is_set(map_high_0(2), i)) or map_of_high_0_b_below_a_values(2
            * i - 1);
        else
          map_of_high_0_c_below_b_choices(i + 1) := (not is_set(map_high_0(2), i)) and map_of_high_0_b_below_a_values(2
            * i - 1);
        end if;
      end loop;
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
        map_median_middle_0_choices(2) := map_of_middle_0_b;
      else
        map_median_middle_0_choices(2) := map_median_middle_0_choice;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choices(3) := map_of_middle_0_c;
      else
        map_median_middle_0_choices(3) := map_of_middle_0_b;
      end if;
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choices(4) := map_of_middle_0_a;
      else
        map_median_middle_0_choices(4) := map_median_middle_0_choices(3);
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
      map_of_all_0_b_below_a_value := is_set(map_largest_low_0, 1);
      if is_set(map_largest_low_0, 0) then
        map_of_all_0_b_below_a_choice := (not is_set(map_median_middle_0, 1)) or (not is_set(map_median_middle_0, 0));
      else
        map_of_all_0_b_below_a_choice := not is_set(map_median_middle_0, 1);
      end if;
      map_of_all_0_b_below_a_is_equal := (map_median_middle_0 mod 4) = 0;
      if map_of_all_0_b_below_a_value then
        map_of_all_0_b_below_a_choices(2) := map_of_all_0_b_below_a_choice;
      else
        map_of_all_0_b_below_a_choices(2) := is_set(map_largest_low_0, 0) and map_of_all_0_b_below_a_is_equal;
      end if;
      map_of_all_0_b_below_a_values(2) := is_set(map_largest_low_0, 2);
      map_of_all_0_b_below_a_values(3) := is_set(map_median_middle_0, 2);
      if map_of_all_0_b_below_a_choices(2) then
        map_of_all_0_b_below_a_choices(3) := (not map_of_all_0_b_below_a_values(2)) and
          map_of_all_0_b_below_a_values(3);
      else
        map_of_all_0_b_below_a_choices(3) := (not map_of_all_0_b_below_a_values(2)) or map_of_all_0_b_below_a_values(3);
      end if;
      for i in 3 to 6 loop
        map_of_all_0_b_below_a_values(2 * i - 2) := is_set(map_largest_low_0, i);
        map_of_all_0_b_below_a_values(2 * i - 1) := is_set(map_median_middle_0, i);
        if map_of_all_0_b_below_a_choices(i) then
          map_of_all_0_b_below_a_choices(i + 1) := (not map_of_all_0_b_below_a_values(2 * i - 2)) or
            map_of_all_0_b_below_a_values(2 * i - 1);
        else
          map_of_all_0_b_below_a_choices(i + 1) := (not map_of_all_0_b_below_a_values(2 * i - 2)) and
            map_of_all_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_all_0_c_below_a_value := is_set(map_smallest_high_0, 1);
      if is_set(map_smallest_high_0, 0) then
        map_of_all_0_c_below_a_choice := not map_of_all_0_b_below_a_value;
      else
        map_of_all_0_c_below_a_choice := (map_largest_low_0 mod 4) = 0;
      end if;
      if map_of_all_0_c_below_a_value then
        map_of_all_0_c_below_a_choices(2) := is_set(map_smallest_high_0, 0) or (not map_of_all_0_b_below_a_value) or
          (not is_set(map_largest_low_0, 0));
      else
        map_of_all_0_c_below_a_choices(2) := map_of_all_0_c_below_a_choice;
      end if;
      if map_of_all_0_c_below_a_choices(2) then
        map_of_all_0_c_below_a_choices(3) := (not is_set(map_smallest_high_0, 2)) and map_of_all_0_b_below_a_values(2);
      else
        map_of_all_0_c_below_a_choices(3) := (not is_set(map_smallest_high_0, 2)) or map_of_all_0_b_below_a_values(2);
      end if;
      for i in 3 to 6 loop
        if map_of_all_0_c_below_a_choices(i) then
          map_of_all_0_c_below_a_choices(i + 1) := (not is_set(map_smallest_high_0, i)) or
            map_of_all_0_b_below_a_values(2 * i - 2);
        else
          map_of_all_0_c_below_a_choices(i + 1) := (not is_set(map_smallest_high_0, i)) and
            map_of_all_0_b_below_a_values(2 * i - 2);
        end if;
      end loop;
      if is_set(map_smallest_high_0, 0) then
        map_of_all_0_c_below_b_choice := not is_set(map_median_middle_0, 1);
      else
        map_of_all_0_c_below_b_choice := map_of_all_0_b_below_a_is_equal;
      end if;
      if map_of_all_0_c_below_a_value then
        map_of_all_0_c_below_b_choices(2) := is_set(map_smallest_high_0, 0) or (not is_set(map_median_middle_0, 1)) or
          (not is_set(map_median_middle_0, 0));
      else
        map_of_all_0_c_below_b_choices(2) := map_of_all_0_c_below_b_choice;
      end if;
      if map_of_all_0_c_below_b_choices(2) then
        map_of_all_0_c_below_b_choices(3) := (not is_set(map_smallest_high_0, 2)) and map_of_all_0_b_below_a_values(3);
      else
        map_of_all_0_c_below_b_choices(3) := (not is_set(map_smallest_high_0, 2)) or map_of_all_0_b_below_a_values(3);
      end if;
      for i in 3 to 6 loop
        if map_of_all_0_c_below_b_choices(i) then
          map_of_all_0_c_below_b_choices(i + 1) := (not is_set(map_smallest_high_0, i)) or
            map_of_all_0_b_below_a_values(2 * i - 1);
        else
          map_of_all_0_c_below_b_choices(i + 1) := (not is_set(map_smallest_high_0, i)) and
            map_of_all_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choice := map_of_all_0_c;
      else
        map_out_disparity_0_choice := map_of_all_0_a;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choices(2) := map_of_all_0_b;
      else
        map_out_disparity_0_choices(2) := map_out_disparity_0_choice;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choices(3) := map_of_all_0_c;
      else
        map_out_disparity_0_choices(3) := map_of_all_0_b;
      end if;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choices(4) := map_of_all_0_a;
      else
        map_out_disparity_0_choices(4) := map_out_disparity_0_choices(3);
      end if;
      map_counter_next_frame <= other(1)(40) = '1';
      map_newest_0 <= ((turn_ready mod 256) * 2) + (turn_ready / 256);
      map_arrives <= turn_ready_tag_row_start_all_2;
      map_behind <= map_line_ended and turn_ready_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_column(1) <= map_rows_ready_words_0 / 512;
      map_column(2) <= map_rows_ready_newest_0;
      map_at_column <= to_integer(other(1)(8 downto 0));
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= other(1)(24) = '1';
      map_at_top <= other(1)(32) = '1';
      map_at_output <= other(1)(48) = '1';
      map_of_column_0_b <= map_column(1) / 2;
      map_column_passed_0(0) <= is_set(map_column(1), 0);
      map_column_passed_0(1) <= map_column_passed_0(0);
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
      map_of_low_0_a <= map_low_0(0);
      map_of_low_0_b <= map_low_0(1);
      map_of_low_0_c <= map_low_0(2);
      map_of_middle_0_a <= map_middle_0(0);
      map_of_middle_0_b <= map_middle_0(1);
      map_of_middle_0_c <= map_middle_0(2);
      map_of_high_0_a <= map_high_0(0);
      map_of_high_0_b <= map_high_0(1);
      map_of_high_0_c <= map_high_0(2);
      map_of_all_0_a <= map_largest_low_0;
      map_of_all_0_b <= map_median_middle_0;
      map_of_all_0_c <= map_smallest_high_0;
      map_waiting_complete(0) <= map_window_complete;
      map_waiting_first(0) <= map_window_first;
      map_waiting_last(0) <= map_window_last;
      map_waiting_complete(1) <= map_waiting_complete(0);
      map_waiting_first(1) <= map_waiting_first(0);
      map_waiting_last(1) <= map_waiting_last(0);
      map_waiting_complete(2) <= map_waiting_complete(1);
      map_waiting_first(2) <= map_waiting_first(1);
      map_waiting_last(2) <= map_waiting_last(1);
      map_waiting_passed_0(0) <= map_passed_0(1);
      map_waiting_passed_0(1) <= map_waiting_passed_0(0);
      map_waiting_passed_0(2) <= map_waiting_passed_0(1);
      map_out_passed_0 <= map_waiting_passed_0(2);
      map_out_valid <= map_waiting_complete(2);
      map_out_start_of_frame <= map_waiting_first(2) and map_waiting_complete(2);
      map_out_end_of_line <= map_waiting_last(2) and map_waiting_complete(2);
      if turn_ready_tag_start_of_frame and turn_ready_tag_valid and turn_ready_tag_map_column then
        map_counter_group <= map_counter_group_choice * 16;
      else
        map_counter_group <= map_counter_group_choices(3);
      end if;
      if turn_ready_tag_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not turn_ready_tag_valid);
      end if;
      if map_at_top then
        map_of_column_0_a <= map_column(1) / 2;
      else
        map_of_column_0_a <= other_2 / 2;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c <= map_column(1) / 2;
      else
        map_of_column_0_c <= map_column(2) / 2;
      end if;
      if map_of_column_0_b_below_a_choices(9) then
        map_of_column_0_b_below_a <= (not is_set(map_column(1), 8)) and is_set(other_2, 8) and (not map_at_top);
      else
        map_of_column_0_b_below_a <= (not is_set(map_column(1), 8)) or is_set(other_2, 8) or map_at_top;
      end if;
      if map_of_column_0_c_below_a_choices(18) then
        map_of_column_0_c_below_a <= (not map_of_column_0_c_below_a_choices(19)) or
          map_of_column_0_c_below_a_choices(20);
      else
        map_of_column_0_c_below_a <= (not map_of_column_0_c_below_a_choices(19)) and
          map_of_column_0_c_below_a_choices(20);
      end if;
      if map_of_column_0_c_below_b_choices(6) then
        map_of_column_0_c_below_b <= (not is_set(map_column(2), 8)) and is_set(map_column(1), 8) and (not
          map_counter_next_frame);
      else
        map_of_column_0_c_below_b <= (not is_set(map_column(2), 8)) or is_set(map_column(1), 8) or
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
      if map_passed_0(0) then
        map_passed_0(1) <= map_passed_0(1) or map_sorted_arrives or map_sorted_behind;
      else
        map_passed_0(1) <= map_passed_0(1) and (not map_sorted_arrives) and (not map_sorted_behind);
      end if;
      if map_of_low_0_b_below_a_choices(7) then
        map_of_low_0_b_below_a <= is_set(map_low_0(0), 7) and (not is_set(map_low_0(1), 7));
      else
        map_of_low_0_b_below_a <= is_set(map_low_0(0), 7) or (not is_set(map_low_0(1), 7));
      end if;
      if map_of_low_0_c_below_a_choices(7) then
        map_of_low_0_c_below_a <= (not is_set(map_low_0(2), 7)) or is_set(map_low_0(0), 7);
      else
        map_of_low_0_c_below_a <= (not is_set(map_low_0(2), 7)) and is_set(map_low_0(0), 7);
      end if;
      if map_of_low_0_c_below_b_choices(7) then
        map_of_low_0_c_below_b <= (not is_set(map_low_0(2), 7)) or is_set(map_low_0(1), 7);
      else
        map_of_low_0_c_below_b <= (not is_set(map_low_0(2), 7)) and is_set(map_low_0(1), 7);
      end if;
      if map_of_middle_0_b_below_a_choices(7) then
        map_of_middle_0_b_below_a <= is_set(map_middle_0(0), 7) and (not is_set(map_middle_0(1), 7));
      else
        map_of_middle_0_b_below_a <= is_set(map_middle_0(0), 7) or (not is_set(map_middle_0(1), 7));
      end if;
      if map_of_middle_0_c_below_a_choices(7) then
        map_of_middle_0_c_below_a <= (not is_set(map_middle_0(2), 7)) or is_set(map_middle_0(0), 7);
      else
        map_of_middle_0_c_below_a <= (not is_set(map_middle_0(2), 7)) and is_set(map_middle_0(0), 7);
      end if;
      if map_of_middle_0_c_below_b_choices(7) then
        map_of_middle_0_c_below_b <= (not is_set(map_middle_0(2), 7)) or is_set(map_middle_0(1), 7);
      else
        map_of_middle_0_c_below_b <= (not is_set(map_middle_0(2), 7)) and is_set(map_middle_0(1), 7);
      end if;
      if map_of_high_0_b_below_a_choices(7) then
        map_of_high_0_b_below_a <= is_set(map_high_0(0), 7) and (not is_set(map_high_0(1), 7));
      else
        map_of_high_0_b_below_a <= is_set(map_high_0(0), 7) or (not is_set(map_high_0(1), 7));
      end if;
      if map_of_high_0_c_below_a_choices(7) then
        map_of_high_0_c_below_a <= (not is_set(map_high_0(2), 7)) or is_set(map_high_0(0), 7);
      else
        map_of_high_0_c_below_a <= (not is_set(map_high_0(2), 7)) and is_set(map_high_0(0), 7);
      end if;
      if map_of_high_0_c_below_b_choices(7) then
        map_of_high_0_c_below_b <= (not is_set(map_high_0(2), 7)) or is_set(map_high_0(1), 7);
      else
        map_of_high_0_c_below_b <= (not is_set(map_high_0(2), 7)) and is_set(map_high_0(1), 7);
      end if;
      if map_of_low_0_b_below_a then
        map_largest_low_0 <= map_largest_low_0_choice;
      else
        map_largest_low_0 <= map_largest_low_0_choice_2;
      end if;
      if map_of_middle_0_b_below_a then
        map_median_middle_0 <= map_median_middle_0_choices(2);
      else
        map_median_middle_0 <= map_median_middle_0_choices(4);
      end if;
      if map_of_high_0_b_below_a then
        map_smallest_high_0 <= map_smallest_high_0_choice;
      else
        map_smallest_high_0 <= map_smallest_high_0_choice_2;
      end if;
      if map_of_all_0_b_below_a_choices(7) then
        map_of_all_0_b_below_a <= is_set(map_largest_low_0, 7) and (not is_set(map_median_middle_0, 7));
      else
        map_of_all_0_b_below_a <= is_set(map_largest_low_0, 7) or (not is_set(map_median_middle_0, 7));
      end if;
      if map_of_all_0_c_below_a_choices(7) then
        map_of_all_0_c_below_a <= (not is_set(map_smallest_high_0, 7)) or is_set(map_largest_low_0, 7);
      else
        map_of_all_0_c_below_a <= (not is_set(map_smallest_high_0, 7)) and is_set(map_largest_low_0, 7);
      end if;
      if map_of_all_0_c_below_b_choices(7) then
        map_of_all_0_c_below_b <= (not is_set(map_smallest_high_0, 7)) or is_set(map_median_middle_0, 7);
      else
        map_of_all_0_c_below_b <= (not is_set(map_smallest_high_0, 7)) and is_set(map_median_middle_0, 7);
      end if;
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choices(2);
      else
        map_out_disparity_0 <= map_out_disparity_0_choices(4);
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= (map_rows_ready_newest_0 * 512) + (map_rows_ready_words_0 / 512);
        map_write_column <= to_integer(other(1)(8 downto 0));
      end if;
      if map_sorted_behind then
        map_low_0_0_choice := map_low_0(0);
      else
        map_low_0_0_choice := map_sorted_low_0;
      end if;
      map_low_0_all(1) := map_window_complete_is_equal and map_sorted_arrives;
      if map_sorted_behind then
        map_middle_0_0_choice := map_middle_0(0);
      else
        map_middle_0_0_choice := map_sorted_middle_0;
      end if;
      if map_sorted_behind then
        map_high_0_0_choice := map_high_0(0);
      else
        map_high_0_0_choice := map_sorted_high_0;
      end if;
      map_low_0_all(0) := (not map_sorted_arrives) and (not map_sorted_behind);
      if not map_low_0_all(0) then
        map_low_0(0) <= map_low_0_0_choice;
        map_low_0(2) <= map_low_0(1);
        map_middle_0(0) <= map_middle_0_0_choice;
        map_middle_0(2) <= map_middle_0(1);
        map_high_0(0) <= map_high_0_0_choice;
        map_high_0(2) <= map_high_0(1);
        if map_low_0_all(1) then
          map_low_0(1) <= map_low_0_0_choice;
          map_middle_0(1) <= map_middle_0_0_choice;
          map_high_0(1) <= map_high_0_0_choice;
        else
          map_low_0(1) <= map_low_0(0);
          map_middle_0(1) <= map_middle_0(0);
          map_high_0(1) <= map_high_0(0);
        end if;
      end if;
      if map_sorted_arrives then
        map_passed_0(0) <= map_column_passed_0(1);
      end if;
      -- other
      other(0) <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 241))), 1) &
        to_unsigned(as_number(turn_ready_tag_row_start_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)),
        8) & to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other(1) <= other(0);
      other_2 <= ((map_rows_ready_words_0 mod 512) / 2) * 2;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 242;
        transform_counter_next_frame <= false;
        transform_counter_last_column <= false;
        transform_counter_counts <= false;
        transform_counter_frame_joins <= false;
        transform_counter_back_to_back <= false;
        transform_counter_column_after <= 1;
        transform_counter_group_after <= 242;
        transform_read_column <= 0;
        transform_read_row_inside_0 <= false;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_write_column <= 0;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        for i in 0 to 2 loop
          transform_filtering_start_of_frame(i) <= false;
          transform_filtering_valid(i) <= false;
        end loop;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 241;
        raster_place_next_frame <= false;
        raster_place_last_column <= false;
        raster_place_frame_joins <= false;
        raster_place_back_to_back <= false;
        raster_place_column_after <= 1;
        raster_place_group_after <= 241;
        delay_column <= 0;
        delay_row_inside(2) <= false;
        delay_tag_valid <= false;
        delay_tag_first_cost <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
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
        line_centre_map_column_0 <= false;
        line_centre_output_column_0 <= false;
        line_centre_first_column_0 <= false;
        line_centre_start_of_frame_0 <= false;
        line_centre_end_of_line_0 <= false;
        line_order_address <= 0;
        line_order_falls <= false;
        line_order_inside <= false;
        line_order_complete <= false;
        line_order_output <= false;
        line_order_first <= false;
        line_order_held_output <= false;
        line_order_turned_valid <= false;
        line_order_turned_map_column <= false;
        line_order_turned_output_column <= false;
        line_order_turned_start_of_frame <= false;
        line_order_turned_end_of_line <= false;
        line_newest_first_column <= false;
        for i in 1 to 47 loop
          line_comes(i) <= false;
        end loop;
        for i in 1 to 26 loop
          line_starts_phases(i) <= false;
        end loop;
        for i in 28 to 47 loop
          line_starts_phases(i) <= false;
        end loop;
        for i in 0 to 1 loop
          line_places_map_column(i) <= false;
          line_places_first_column(i) <= false;
          line_places_address(i) <= 0;
          line_places_shown_output_column(i) <= false;
          line_places_shown_start_of_frame(i) <= false;
          line_places_shown_end_of_line(i) <= false;
        end loop;
        line_places_map_column(2) <= false;
        line_places_shown_output_column(2) <= false;
        line_places_shown_start_of_frame(2) <= false;
        line_places_shown_end_of_line(2) <= false;
        costsshift_new_tag_valid <= false;
        costsshift_count_phase <= 15;
        costsshift_read_tag_valid <= false;
        costsshift_read_count_phase <= 15;
        costsshift_write_phase <= 15;
        costswindow_read_count_phase <= 15;
        costswindow_write_count_phase <= 15;
        paths_cost_delay_ring_read_address <= 1;
        paths_cost_delay_ring_write_address <= 0;
        pathsleft_low_address <= 5;
        pathsleft_read_count_phase <= 15;
        pathsleft_ahead_count_phase <= 15;
        pathsleft_is_first <= false;
        pathsleft_write_count_phase <= 15;
        pathsleft_low_write_address <= 0;
        pathsabove_memory_read_address_0 <= 0;
        pathsabove_memory_read_address_1 <= 0;
        pathsabove_memory_write_address_0 <= 0;
        pathsabove_memory_write_address_1 <= 0;
        pathsabove_read_address_address <= 0;
        pathsabove_read_address_count_phase <= 15;
        pathsabove_write_address_address <= 0;
        pathsabove_write_address_is_here <= false;
        pathsabove_write_address_count_phase <= 15;
        pathsturn_sum_memory_read_address_0 <= 0;
        pathsturn_sum_memory_read_address_1 <= 0;
        pathsturn_sum_memory_write_address_0 <= 0;
        pathsturn_sum_memory_write_address_1 <= 0;
        pathsturn_cost_memory_read_address_0 <= 0;
        pathsturn_cost_memory_read_address_1 <= 0;
        pathsturn_cost_memory_write_address_0 <= 0;
        pathsturn_cost_memory_write_address_1 <= 0;
        pathsturn_smallest_address <= 0;
        pathsturn_read_address_address <= 0;
        pathsturn_read_address_count_phase <= 15;
        pathsturn_sum_read_address <= 0;
        pathsturn_write_smallest_address <= 0;
        pathsturn_write_address_address <= 0;
        pathsturn_write_address_is_here <= false;
        pathsturn_write_address_count_phase <= 15;
        pathsturn_sum_write_address(0) <= 0;
        pathsturn_sum_write_address(1) <= 0;
        pathsturn_writes_sums(0) <= false;
        pathsturn_writes_sums(1) <= false;
        winnerswinner1_best_below_0 <= false;
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
        map_counter_group <= 241;
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
        for i in 0 to 2 loop
          map_waiting_complete(i) <= false;
          map_waiting_first(i) <= false;
          map_waiting_last(i) <= false;
        end loop;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
        other(0) <= to_unsigned(0, 49);
        other(1) <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
