-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_640_64_f8_dense: 640x480, 64 disparities, window 3x3, P1 9, P2 40, 1 pixel pair a clock.
-- Options: reference left, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap 6, p1 9, p2 40,
--   p2_least 15, above_p1 5, above_p2 20, left_right_threshold 1, subpixel true, median true, full_width
--   true, border_cost 3, support_threshold 10, confidence true, margin_weight 4, support_weight 2, fill_holes
--   true, slice_disparities 16, clocks_per_pixel 8, front_clocks 2.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_640_64_f8_dense
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_640_64_f8_dense is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 24;
    output_width_px : positive := 638;
    latency_clocks : positive := 97;
    flush_groups : positive := 5834;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(23 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 640 report "stereo_core_sgm_640_64_f8_dense: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_sgm_640_64_f8_dense: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 64 report "stereo_core_sgm_640_64_f8_dense: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_640_64_f8_dense: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 24 report "stereo_core_sgm_640_64_f8_dense: disparity_bits is " & integer'image(disparity_bits) & " but this core has 24" severity failure;
  assert output_width_px = 638 report "stereo_core_sgm_640_64_f8_dense: output_width_px is " & integer'image(output_width_px) & " but this core has 638" severity failure;
  assert latency_clocks = 97 report "stereo_core_sgm_640_64_f8_dense: latency_clocks is " & integer'image(latency_clocks) & " but this core has 97" severity failure;
  assert flush_groups = 5834 report "stereo_core_sgm_640_64_f8_dense: flush_groups is " & integer'image(flush_groups) & " but this core has 5834" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_640_64_f8_dense: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_640_64_f8_dense is
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
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_105_1d is array (natural range <>) of natural range 0 to 105;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_14_1d is array (natural range <>) of natural range 0 to 14;
  type natural_14_2d is array (natural range <>, natural range <>) of natural range 0 to 14;
  type natural_158_1d is array (natural range <>) of natural range 0 to 158;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16383_2d is array (natural range <>, natural range <>) of natural range 0 to 16383;
  type natural_169_1d is array (natural range <>) of natural range 0 to 169;
  type natural_21_1d is array (natural range <>) of natural range 0 to 21;
  type natural_254_1d is array (natural range <>) of natural range 0 to 254;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_257_to_1022_1d is array (natural range <>) of natural range 257 to 1022;
  type natural_28_1d is array (natural range <>) of natural range 0 to 28;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_36_1d is array (natural range <>) of natural range 0 to 36;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_52_1d is array (natural range <>) of natural range 0 to 52;
  type natural_5_1d is array (natural range <>) of natural range 0 to 5;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_to_127_1d is array (natural range <>) of natural range 63 to 127;
  type natural_64_1d is array (natural range <>) of natural range 0 to 64;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_65535_2d is array (natural range <>, natural range <>) of natural range 0 to 65535;
  type natural_7_1d is array (natural range <>) of natural range 0 to 7;
  type natural_8191_1d is array (natural range <>) of natural range 0 to 8191;
  type unsigned_16_1d is array (natural range <>) of unsigned(15 downto 0);
  type unsigned_16_2d is array (natural range <>, natural range <>) of unsigned(15 downto 0);
  type unsigned_27_1d is array (natural range <>) of unsigned(26 downto 0);
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type unsigned_8_1d is array (natural range <>) of unsigned(7 downto 0);
  signal in_start_of_frame, in_valid : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
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
  signal transform_counter_column, transform_counter_column_after, transform_read_column : natural range 0 to 1023;
  signal transform_ready_column, transform_write_column : natural range 0 to 1023;
  signal transform_counter_group, transform_counter_group_after : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame, raster_place_last_column, raster_place_counts : boolean;
  signal raster_place_frame_joins, raster_place_back_to_back : boolean;
  signal raster_place_column, raster_place_column_after : natural range 0 to 1023;
  signal raster_place_group, raster_place_group_after : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16383;
  signal delay_column : natural range 0 to 1023;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag_valid, delay_tag_map_column, delay_tag_output_column, delay_tag_first_column : boolean;
  signal delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_search : natural_16383_1d(0 to 2);
  signal rows_reference : natural_16383_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 1023;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag_valid, rows_read_tag_map_column, rows_read_tag_output_column : boolean;
  signal rows_read_tag_first_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag_valid, rows_ready_tag_map_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_first_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_map_column, rows_tag_output_column, rows_tag_first_column : boolean;
  signal rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- line
  signal line_centre_map_column_0, line_centre_output_column_0, line_centre_first_column_0 : boolean;
  signal line_centre_start_of_frame_0, line_centre_end_of_line_0, line_order_falls, line_order_inside : boolean;
  signal line_order_complete, line_order_output, line_order_first, line_order_held_output : boolean;
  signal line_order_turned_valid, line_order_turned_map_column, line_order_turned_output_column : boolean;
  signal line_order_turned_first_column, line_order_turned_start_of_frame, line_order_turned_end_of_line : boolean;
  signal line_newest_first_column, line_newest_top : boolean;
  signal line_comes : boolean_1d(1 to 33);
  signal line_starts_phases : boolean_1d(1 to 33);
  signal line_places_map_column : boolean_1d(0 to 4);  -- line_places_#_map_column
  signal line_places_first_column : boolean_1d(0 to 4);  -- line_places_#_first_column
  signal line_places_0_top : boolean;
  signal line_places_shown_output_column : boolean_1d(0 to 4);  -- line_places_#_shown_output_column
  signal line_places_shown_first_column : boolean_1d(0 to 2);  -- line_places_#_shown_first_column
  signal line_places_shown_start_of_frame : boolean_1d(0 to 4);  -- line_places_#_shown_start_of_frame
  signal line_places_shown_end_of_line : boolean_1d(0 to 4);  -- line_places_#_shown_end_of_line
  signal line_order_address : natural range 0 to 1023;
  signal line_places_address : natural_1023_1d(0 to 2);  -- line_places_#_address
  -- costsshift
  signal costsshift_newest : natural_16383_1d(0 to 2);
  signal costsshift_new_reference : natural_16383_1d(0 to 2);
  signal costsshift_handed_on : natural_16383_1d(0 to 2);
  signal costsshift_read_reference : natural_16383_1d(0 to 2);
  signal costsshift_search : natural_16383_2d(0 to 2, 0 to 7);
  signal costsshift_reference : natural_16383_1d(0 to 2);
  signal costsshift_new_tag_valid, costsshift_read_tag_valid : boolean;
  signal costsshift_count_phase, costsshift_read_count_phase, costsshift_write_phase : natural range 0 to 7;
  signal costsshift_read_words : unsigned_28_1d(0 to 11);
  -- costscolumn
  signal costscolumn_pixels_first_count : natural_3_3d(0 to 2, 0 to 7, 0 to 3);  -- costscolumn_pixels_first_#_#_count_#
  signal costscolumn_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 7);  -- costscolumn_pixels_first_#_#_count_4
  signal costscolumn_pixels_cost : natural_14_2d(0 to 2, 0 to 7);
  signal costscolumn_single_0 : natural_14_1d(0 to 7);
  signal costscolumn_pair_0 : natural_28_1d(0 to 7);
  signal costscolumn_column_0 : natural_42_1d(0 to 7);
  -- costswindow
  signal costswindow_read_count_phase, costswindow_write_count_phase : natural range 0 to 7;
  signal costswindow_read_words : unsigned_27_1d(0 to 1);
  signal costswindow_read_wordss : unsigned_28_1d(2 to 3);  -- costswindow_read_words_#
  signal costswindow_partial : natural_42_1d(0 to 7);
  signal costswindow_partials : natural_105_1d(8 to 15);  -- costswindow_partial_#
  signal costswindow_sum_0 : natural_169_1d(0 to 7);
  -- costsmask
  signal costsmask_column : natural range 0 to 1023;
  signal costsmask_partner : natural range 0 to 4095;
  signal costsmask_inside : boolean_1d(0 to 7);
  -- costs
  signal costs_cost : natural_21_1d(0 to 7);
  -- paths
  signal paths_tree_smallest : natural_21_1d(0 to 3);
  signal paths_tree_next_smallest : natural_21_1d(0 to 1);
  signal paths_tree_next_next_smallest_0, paths_smallest_cost : natural range 0 to 21;
  signal paths_cost_delay_ring_read_address, paths_cost_delay_ring_write_address : natural range 0 to 15;
  signal paths_cost_delay_held_0 : unsigned(23 downto 0);
  signal paths_sum : natural_254_1d(0 to 7);
  -- pathsleft
  signal pathsleft_fresh_past_newest : natural_64_1d(0 to 1);
  signal pathsleft_fresh_past_pairs : natural_64_1d(0 to 2);
  signal pathsleft_fresh_past_fours : natural_64_1d(0 to 6);
  signal pathsleft_fresh_past_eight, pathsleft_fresh_past_oldest, pathsleft_fresh_past_cheapest : natural range 0 to 64;
  signal pathsleft_fresh_here : natural range 0 to 64;
  signal pathsleft_fresh_known, pathsleft_q_less, pathsleft_g_less, pathsleft_lower_neighbour : natural range 0 to 127;
  signal pathsleft_stay : natural_127_1d(0 to 7);
  signal pathsleft_step : natural_127_1d(0 to 7);
  signal pathsleft_stay_change : natural_127_1d(0 to 7);
  signal pathsleft_step_change : natural_127_1d(0 to 7);
  signal pathsleft_cost : natural_127_1d(0 to 7);
  signal pathsleft_arrived : natural_127_1d(0 to 7);
  signal pathsleft_tree_smallest : natural_127_1d(0 to 3);
  signal pathsleft_tree_next_smallest : natural_127_1d(0 to 1);
  signal pathsleft_tree_next_next_smallest_0, pathsleft_low_0 : natural range 0 to 127;
  signal pathsleft_low_address, pathsleft_low_write_address : natural range 0 to 15;
  signal pathsleft_lowest_0, pathsleft_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsleft_lost, pathsleft_short_of, pathsleft_first, pathsleft_is_first, pathsleft_is_last : boolean;
  signal pathsleft_missing, pathsleft_below, pathsleft_q, pathsleft_room_left, pathsleft_q_now : natural range 0 to 63;
  signal pathsleft_room : natural range 0 to 63;
  signal pathsleft_start_cost : natural_63_1d(1 to 8);
  signal pathsleft_g : natural range 0 to 84;
  signal pathsleft_read_count_phase, pathsleft_ahead_count_phase, pathsleft_write_count_phase : natural range 0 to 7;
  signal pathsleft_read_words : unsigned_28_1d(0 to 3);
  -- pathsabove
  signal pathsabove_memory_read_address_0, pathsabove_memory_write_address_0 : natural range 0 to 4095;
  signal pathsabove_memory_read_address_1, pathsabove_memory_write_address_1 : natural range 0 to 1023;
  signal pathsabove_memory_bank, pathsabove_memory_read_bank, pathsabove_memory_held_bank : boolean;
  signal pathsabove_ready_top, pathsabove_write_address_is_here : boolean;
  signal pathsabove_memory_read_words : unsigned_16_2d(0 to 1, 0 to 1);
  signal pathsabove_memory_read_words_2 : unsigned_8_1d(0 to 1);  -- pathsabove_memory_read_words_#_2
  signal pathsabove_memory_held_words : natural_65535_2d(0 to 1, 0 to 1);
  signal pathsabove_memory_ready_words : natural_65535_1d(0 to 1);
  signal pathsabove_memory_write_words : natural_65535_2d(0 to 1, 0 to 1);
  signal pathsabove_memory_held_words_2 : natural_255_1d(0 to 1);  -- pathsabove_memory_held_words_#_2
  signal pathsabove_memory_ready_words_2 : natural range 0 to 255;
  signal pathsabove_memory_write_words_2 : natural_255_1d(0 to 1);  -- pathsabove_memory_write_words_#_2
  signal pathsabove_read_address_address, pathsabove_write_address_address : natural range 0 to 8191;
  signal pathsabove_read_address_count_phase, pathsabove_count_phase : natural range 0 to 7;
  signal pathsabove_write_address_count_phase : natural range 0 to 7;
  signal pathsabove_total : natural_52_1d(0 to 7);
  signal pathsabove_tree_smallest : natural_52_1d(0 to 3);
  signal pathsabove_tree_next_smallest : natural_52_1d(0 to 1);
  signal pathsabove_tree_next_next_smallest_0, pathsabove_smallest_total, pathsabove_smallest : natural range 0 to 52;
  signal pathsabove_delay_held_0 : unsigned(29 downto 0);
  signal pathsabove_delay_held_1 : unsigned(9 downto 0);
  signal pathsabove_cost : natural_31_1d(0 to 7);
  signal pathsabove_held : natural_31_1d(0 to 7);
  signal pathsabove_lower_neighbour : natural range 0 to 31;
  signal pathsabove_beside : natural_31_1d(0 to 7);
  signal pathsabove_own : natural_31_1d(0 to 6);
  signal pathsabove_stay : natural_31_1d(0 to 7);
  signal pathsabove_step : natural_36_1d(0 to 7);
  -- pathsturn
  signal pathsturn_sum_memory_read_address_0, pathsturn_sum_memory_write_address_0 : natural range 0 to 4095;
  signal pathsturn_cost_memory_read_address_0, pathsturn_cost_memory_write_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_read_address_1, pathsturn_sum_memory_write_address_1 : natural range 0 to 1023;
  signal pathsturn_cost_memory_read_address_1, pathsturn_cost_memory_write_address_1 : natural range 0 to 1023;
  signal pathsturn_smallest_address, pathsturn_write_smallest_address : natural range 0 to 1023;
  signal pathsturn_sum_memory_bank, pathsturn_sum_memory_read_bank, pathsturn_sum_memory_held_bank : boolean;
  signal pathsturn_cost_memory_bank, pathsturn_cost_memory_read_bank, pathsturn_cost_memory_held_bank : boolean;
  signal pathsturn_write_address_is_here : boolean;
  signal pathsturn_writes_sums : boolean_1d(0 to 1);
  signal pathsturn_sum_memory_read_words : unsigned_16_2d(0 to 1, 0 to 2);
  signal pathsturn_cost_memory_read_words_0 : unsigned_16_1d(0 to 1);  -- pathsturn_cost_memory_read_words_#_0
  signal pathsturn_sum_memory_read_words_3 : unsigned_8_1d(0 to 1);  -- pathsturn_sum_memory_read_words_#_3
  signal pathsturn_cost_memory_read_words_1 : unsigned_8_1d(0 to 1);  -- pathsturn_cost_memory_read_words_#_1
  signal pathsturn_sum_memory_held_words : natural_65535_2d(0 to 1, 0 to 2);
  signal pathsturn_sum_memory_ready_words : natural_65535_1d(0 to 2);
  signal pathsturn_sum_memory_write_words : natural_65535_2d(0 to 1, 0 to 2);
  signal pathsturn_cost_memory_held_words_0 : natural_65535_1d(0 to 1);  -- pathsturn_cost_memory_held_words_#_0
  signal pathsturn_cost_memory_ready_words_0 : natural range 0 to 65535;
  signal pathsturn_cost_memory_write_words_0 : natural_65535_1d(0 to 1);  -- pathsturn_cost_memory_write_words_#_0
  signal pathsturn_sum_memory_held_words_3 : natural_255_1d(0 to 1);  -- pathsturn_sum_memory_held_words_#_3
  signal pathsturn_sum_memory_ready_words_3 : natural range 0 to 255;
  signal pathsturn_sum_memory_write_words_3 : natural_255_1d(0 to 1);  -- pathsturn_sum_memory_write_words_#_3
  signal pathsturn_cost_memory_held_words_1 : natural_255_1d(0 to 1);  -- pathsturn_cost_memory_held_words_#_1
  signal pathsturn_cost_memory_ready_words_1 : natural range 0 to 255;
  signal pathsturn_cost_memory_write_words_1 : natural_255_1d(0 to 1);  -- pathsturn_cost_memory_write_words_#_1
  signal pathsturn_read_smallest_0 : unsigned(4 downto 0);
  signal pathsturn_ready_smallest_0 : natural range 0 to 31;
  signal pathsturn_read_address_address, pathsturn_sum_read_address : natural range 0 to 8191;
  signal pathsturn_write_address_address : natural range 0 to 8191;
  signal pathsturn_sum_write_address : natural_8191_1d(0 to 1);
  signal pathsturn_read_address_count_phase, pathsturn_write_address_count_phase : natural range 0 to 7;
  signal pathsturn_write_smallest_0 : natural range 0 to 21;
  -- pathsright
  signal pathsright_fresh_past_newest : natural_64_1d(0 to 1);
  signal pathsright_fresh_past_pairs : natural_64_1d(0 to 2);
  signal pathsright_fresh_past_fours : natural_64_1d(0 to 6);
  signal pathsright_fresh_past_eight, pathsright_fresh_past_oldest : natural range 0 to 64;
  signal pathsright_fresh_past_cheapest, pathsright_fresh_here : natural range 0 to 64;
  signal pathsright_fresh_known, pathsright_q_less, pathsright_g_less : natural range 0 to 127;
  signal pathsright_lower_neighbour : natural range 0 to 127;
  signal pathsright_stay : natural_127_1d(0 to 7);
  signal pathsright_step : natural_127_1d(0 to 7);
  signal pathsright_stay_change : natural_127_1d(0 to 7);
  signal pathsright_step_change : natural_127_1d(0 to 7);
  signal pathsright_cost : natural_127_1d(0 to 7);
  signal pathsright_arrived : natural_127_1d(0 to 7);
  signal pathsright_tree_smallest : natural_127_1d(0 to 3);
  signal pathsright_tree_next_smallest : natural_127_1d(0 to 1);
  signal pathsright_tree_next_next_smallest_0, pathsright_low_0 : natural range 0 to 127;
  signal pathsright_lowest_0, pathsright_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsright_lost, pathsright_short_of : boolean;
  signal pathsright_missing, pathsright_below, pathsright_q, pathsright_room_left : natural range 0 to 63;
  signal pathsright_q_now, pathsright_room : natural range 0 to 63;
  signal pathsright_start_cost : natural_63_1d(1 to 8);
  signal pathsright_g : natural range 0 to 94;
  signal pathsright_read_words : unsigned_28_1d(0 to 3);
  -- winnersmask
  signal winnersmask_column : natural range 0 to 1023;
  signal winnersmask_partner : natural range 0 to 4095;
  signal winnersmask_inside : boolean_1d(0 to 7);
  -- winnerswinner1
  signal winnerswinner1_held_0 : natural_254_1d(0 to 7);
  signal winnerswinner1_best_cost_0 : natural_254_1d(0 to 3);
  signal winnerswinner1_best_below_0 : natural_254_1d(0 to 3);
  signal winnerswinner1_best_above_0 : natural_254_1d(0 to 3);
  signal winnerswinner1_best_late_cost_0 : natural_254_1d(0 to 3);
  signal winnerswinner1_best_index_0_0, winnerswinner1_best_place_0_2 : boolean;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_best_index_0_3 : natural range 0 to 7;
  signal winnerswinner1_best_but_first_0 : natural_255_1d(0 to 3);
  signal winnerswinner1_best_but_last_0 : natural_255_1d(0 to 3);
  -- winnerswinner2
  signal winnerswinner2_best_cost_0 : natural_254_1d(0 to 1);
  signal winnerswinner2_best_below_0 : natural_254_1d(0 to 1);
  signal winnerswinner2_best_above_0 : natural_254_1d(0 to 1);
  signal winnerswinner2_best_first_0 : natural_254_1d(0 to 1);
  signal winnerswinner2_best_last_0 : natural_254_1d(0 to 1);
  signal winnerswinner2_best_late_cost_0 : natural_254_1d(0 to 1);
  signal winnerswinner2_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner2_best_index_0_1 : natural range 0 to 7;
  signal winnerswinner2_best_place_0 : boolean_1d(0 to 1);
  signal winnerswinner2_best_at_start_0 : boolean_1d(0 to 1);
  signal winnerswinner2_best_at_end_0 : boolean_1d(0 to 1);
  signal winnerswinner2_best_second_0 : natural_255_1d(0 to 1);
  signal winnerswinner2_best_but_first_0 : natural_255_1d(0 to 1);
  signal winnerswinner2_best_but_last_0 : natural_255_1d(0 to 1);
  -- winnerswinner3
  signal winnerswinner3_best_cost_0_0, winnerswinner3_best_below_0_0 : natural range 0 to 254;
  signal winnerswinner3_best_above_0_0, winnerswinner3_best_first_0_0 : natural range 0 to 254;
  signal winnerswinner3_best_last_0_0, winnerswinner3_best_late_cost_0_0 : natural range 0 to 254;
  signal winnerswinner3_best_index_0_0 : natural range 0 to 7;
  signal winnerswinner3_best_place_0_0, winnerswinner3_best_at_start_0_0, winnerswinner3_best_at_end_0_0 : boolean;
  signal winnerswinner3_best_second_0_0, winnerswinner3_best_but_first_0_0 : natural range 0 to 255;
  signal winnerswinner3_best_but_last_0_0 : natural range 0 to 255;
  -- winners
  signal winners_best_cost_0_0, winners_best_index_0_0, winners_best_late_cost_0_0 : natural range 0 to 255;
  signal winners_best_second_0_0, winners_best_but_last_0_0 : natural range 0 to 255;
  signal winners_best_below_0_0, winners_best_above_0_0, winners_best_last_0_0 : natural range 0 to 254;
  signal winners_best_place_0_0, winners_best_at_start_0_0, winners_best_at_end_0_0, winners_best_tag_valid : boolean;
  signal winners_best_tag_map_column, winners_best_tag_output_column, winners_best_tag_start_of_frame : boolean;
  signal winners_best_tag_end_of_line : boolean;
  signal winners_partner_column : natural range 0 to 1023;
  signal winners_partner_at : natural range 0 to 1279;
  -- other
  signal other_read_count_phase, other_count_phase, other_write_count_phase : natural range 0 to 7;
  signal other_next_words : unsigned_32_1d(0 to 3);
  signal other_words : unsigned_32_1d(0 to 3);
  signal other : unsigned_32_1d(12 to 15);
  signal other_base, other_left : natural range 0 to 255;
  signal other_first_column, other_output_column, other_0 : boolean;
  signal other_1 : natural range 0 to 8190;
  signal other_2 : natural range 0 to 15;
  signal other_3 : natural range 0 to 63;
  signal other_4 : natural range 0 to 31;
  signal other_5 : natural range 0 to 254;
  signal other_6 : natural range 0 to 252;
  signal other_7 : natural range 0 to 248;
  signal other_8 : natural range 0 to 240;
  signal other_9 : natural range 0 to 224;
  signal other_10 : natural range 0 to 192;
  signal other_11 : natural range 0 to 128;
  -- refinement
  signal refinement_disparity_0 : natural_255_1d(0 to 11);  -- refinement_disparity_#_0
  signal refinement_gap_0, refinement_u_0, refinement_v_0 : natural range 0 to 255;
  signal refinement_remainder_0 : natural_255_1d(1 to 7);  -- refinement_remainder_#_0
  signal refinement_divisor_0 : natural_255_1d(0 to 7);  -- refinement_divisor_#_0
  signal refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- refinement_passed_#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- refinement_tag_#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- refinement_tag_#_map_column
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- refinement_tag_#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- refinement_tag_#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- refinement_tag_#_end_of_line
  signal refinement_alone_0_0, refinement_scaled_gap, refinement_scaled_cost : boolean;
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- refinement_negative_#_0
  signal refinement_margin_0 : natural_63_1d(0 to 9);  -- refinement_margin_#_0
  signal refinement_below_0, refinement_above_0, refinement_remainder_0_0 : natural range 0 to 254;
  signal refinement_difference_0 : integer range -254 to 254;
  -- leftright
  signal leftright_other_0 : natural_255_1d(0 to 14);  -- leftright_other_#_0
  signal leftright_asking_disparity_0, leftright_answered_disparity_0 : natural range 0 to 255;
  signal leftright_checked_disparity_0 : natural range 0 to 255;
  signal leftright_ring_read_address, leftright_ring_write_address, leftright_asking_margin_0 : natural range 0 to 63;
  signal leftright_answered_margin_0, leftright_checked_margin_0 : natural range 0 to 63;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_tag_valid : boolean;
  signal leftright_asking_tag_map_column, leftright_asking_tag_output_column : boolean;
  signal leftright_asking_tag_start_of_frame, leftright_asking_tag_end_of_line, leftright_answered_passed_0 : boolean;
  signal leftright_answered_tag_valid, leftright_answered_tag_map_column : boolean;
  signal leftright_answered_tag_output_column, leftright_answered_tag_start_of_frame : boolean;
  signal leftright_answered_tag_end_of_line, leftright_checked_passed_0, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_map_column, leftright_checked_tag_output_column : boolean;
  signal leftright_checked_tag_start_of_frame, leftright_checked_tag_end_of_line : boolean;
  signal leftright_position, leftright_held_position, leftright_address_0 : natural range 0 to 127;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_held_1 : unsigned(5 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0 : natural range 0 to 31;
  signal leftright_checked_fraction_0 : natural range 0 to 31;
  signal leftright_found_0 : unsigned(7 downto 0);
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 1023;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame : boolean;
  signal turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid, turn_read_tag_map_column : boolean;
  signal turn_read_tag_start_of_frame, turn_read_tag_end_of_line, turn_ready_tag_valid : boolean;
  signal turn_ready_tag_row_start, turn_ready_tag_map_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 1048575;
  signal turn_read_words_0 : unsigned(19 downto 0);
  -- support
  signal support_counter_column, support_newest_rest_0, support_rest_rows_read_newest_0 : natural range 0 to 1023;
  signal support_rest_rows_ready_newest_0, support_read_column, support_ready_column : natural range 0 to 1023;
  signal support_write_column, support_column_rest_0 : natural range 0 to 1023;
  signal support_rest_0 : natural_1023_1d(0 to 6);  -- support_rest_#_0
  signal support_centre_rest_0 : natural_1023_1d(0 to 2);  -- support_centre_rest_#_0
  signal support_out_disparity_0 : natural range 0 to 1023;
  signal support_counter_group : natural range 0 to 511;
  signal support_newest_0, support_rows_read_newest_0, support_rows_ready_newest_0 : natural range 0 to 127;
  signal support_column : natural_127_1d(0 to 4);
  signal support_cells : natural_127_2d(0 to 12, 0 to 4);
  signal support_centre_0 : natural_127_1d(0 to 2);  -- support_centre_#_0
  signal support_moves, support_arrives, support_last, support_read_moves, support_read_arrives : boolean;
  signal support_read_above2, support_read_above1, support_read_below1, support_read_below2 : boolean;
  signal support_read_first, support_read_last, support_ready_moves, support_ready_arrives : boolean;
  signal support_ready_above2, support_ready_above1, support_ready_below1, support_ready_below2 : boolean;
  signal support_ready_first, support_ready_last, support_at_moves, support_at_arrives, support_at_first : boolean;
  signal support_at_last : boolean;
  signal support_row_tag : boolean_1d(0 to 12);
  signal support_moment_map_column : boolean_1d(0 to 6);  -- support_moment_#_map_column
  signal support_moment_start_of_frame : boolean_1d(0 to 6);  -- support_moment_#_start_of_frame
  signal support_moment_last : boolean_1d(0 to 6);  -- support_moment_#_last
  signal support_next_tag, support_moved : boolean;
  signal support_like_0 : boolean_2d(0 to 6, 0 to 4);
  signal support_enough_0 : boolean;
  signal support_centre_moment_map_column : boolean_1d(0 to 3);  -- support_centre_moment_#_map_column
  signal support_centre_moment_start_of_frame : boolean_1d(0 to 3);  -- support_centre_moment_#_start_of_frame
  signal support_centre_moment_last : boolean_1d(0 to 3);  -- support_centre_moment_#_last
  signal support_centre_moved : boolean_1d(0 to 3);
  signal support_out_passed_0, support_out_tag_valid, support_out_tag_row_start, support_out_tag_map_column : boolean;
  signal support_out_tag_start_of_frame, support_out_tag_end_of_line : boolean;
  signal support_rows_read_words_0 : unsigned(27 downto 0);
  signal support_rows_ready_words_0, support_rows_write_words_0 : natural range 0 to 268435455;
  signal support_rest_rows_read_words_0 : unsigned(19 downto 0);
  signal support_rest_rows_ready_words_0, support_rest_rows_write_words_0 : natural range 0 to 1048575;
  signal support_partial_0 : natural_5_1d(0 to 6);
  signal support_count_0 : natural range 0 to 35;
  signal support_sum_0 : natural range 0 to 322;
  signal support_out_sure_0 : natural range 0 to 255;
  -- fill
  signal fill_counter_column, fill_newest_disparity_0, fill_read_column, fill_ready_column : natural range 0 to 1023;
  signal fill_write_column, fill_pixel_0_disparity, fill_at_column : natural range 0 to 1023;
  signal fill_asking_0_disparity : natural_1023_1d(0 to 1);  -- fill_asking_#_0_disparity
  signal fill_asking_at_column : natural_1023_1d(0 to 1);  -- fill_asking_at_#_column
  signal fill_known_0_disparity, fill_known_at_column, fill_beside_0_left : natural range 0 to 1023;
  signal fill_beside_0_right, fill_beside_0_left_column, fill_beside_0_right_column : natural range 0 to 1023;
  signal fill_measured_0_disparity, fill_measured_at_column, fill_measured_beside_0_left : natural range 0 to 1023;
  signal fill_measured_beside_0_right, fill_measured_beside_0_right_column, fill_width_0 : natural range 0 to 1023;
  signal fill_chosen_0_disparity, fill_chosen_at_column, fill_chosen_beside_0_left : natural range 0 to 1023;
  signal fill_chosen_beside_0_right, fill_write_above_column : natural range 0 to 1023;
  signal fill_counter_group, fill_ends_next_place_0, fill_ends_row_place_0 : natural range 0 to 511;
  signal fill_ends_row_above_place_0, fill_ends_write_place_0, fill_ends_read_place_0 : natural range 0 to 511;
  signal fill_newest_passed_0, fill_moves, fill_arrives, fill_last, fill_read_moves, fill_read_arrives : boolean;
  signal fill_read_top, fill_read_last, fill_ready_moves, fill_ready_arrives, fill_ready_top, fill_ready_last : boolean;
  signal fill_ends_open_0, fill_pixel_0_passed, fill_at_moves, fill_at_arrives, fill_at_top, fill_at_last : boolean;
  signal fill_in_hole_0 : boolean;
  signal fill_asking_0_passed : boolean_1d(0 to 1);  -- fill_asking_#_0_passed
  signal fill_asking_at_moves : boolean_1d(0 to 1);  -- fill_asking_at_#_moves
  signal fill_asking_at_arrives : boolean_1d(0 to 1);  -- fill_asking_at_#_arrives
  signal fill_asking_at_top : boolean_1d(0 to 1);  -- fill_asking_at_#_top
  signal fill_asking_at_last : boolean_1d(0 to 1);  -- fill_asking_at_#_last
  signal fill_hole_starts_0 : boolean_1d(0 to 1);  -- fill_hole_starts_#_0
  signal fill_known_0_passed, fill_known_at_moves, fill_known_at_arrives, fill_known_at_top : boolean;
  signal fill_known_at_last, fill_beside_0_has_left, fill_beside_0_has_right, fill_measured_0_passed : boolean;
  signal fill_measured_at_moves, fill_measured_at_arrives, fill_measured_at_top, fill_measured_at_last : boolean;
  signal fill_measured_beside_0_has_left, fill_measured_beside_0_has_right, fill_rises_0 : boolean;
  signal fill_chosen_0_passed, fill_chosen_at_moves, fill_chosen_at_arrives, fill_chosen_at_top : boolean;
  signal fill_chosen_at_last, fill_chosen_beside_0_has_left, fill_chosen_beside_0_has_right : boolean;
  signal fill_takes_left_0, fill_out_passed_0, fill_out_filled_0, fill_out_tag_valid, fill_out_tag_row_start : boolean;
  signal fill_out_tag_map_column, fill_out_tag_start_of_frame, fill_out_tag_end_of_line, fill_has_values : boolean;
  signal fill_had_values : boolean;
  signal fill_newest_sure_0, fill_pixel_0_sure : natural range 0 to 255;
  signal fill_asking_0_sure : natural_255_1d(0 to 1);  -- fill_asking_#_0_sure
  signal fill_known_0_sure, fill_measured_0_sure, fill_chosen_0_sure, fill_out_sure_0 : natural range 0 to 255;
  signal fill_rows_read_words_0 : unsigned(18 downto 0);
  signal fill_rows_read_newest_0, fill_rows_ready_words_0, fill_rows_ready_newest_0 : natural range 0 to 524287;
  signal fill_rows_write_words_0 : natural range 0 to 524287;
  signal fill_ends_write_words_0, fill_ends_ready_words_0 : natural range 0 to 2097151;
  signal fill_ends_read_words_0 : unsigned(20 downto 0);
  signal fill_step_0 : natural range 0 to 127;
  signal fill_above_read_0 : unsigned(15 downto 0);
  signal fill_above_0, fill_write_above_0 : natural range 0 to 65535;
  signal fill_out_disparity_0 : natural range 0 to 32767;
  -- median
  signal median_counter_column, median_read_column, median_ready_column, median_write_column : natural range 0 to 1023;
  signal median_at_column, median_comparing_column, median_sorted_column : natural range 0 to 1023;
  signal median_counter_group, median_beside_newest_0, median_beside_rows_read_newest_0 : natural range 0 to 511;
  signal median_beside_rows_ready_words_0, median_beside_rows_ready_newest_0 : natural range 0 to 511;
  signal median_beside_rows_write_words_0, median_beside_column_0 : natural range 0 to 511;
  signal median_beside_of_column_0 : natural_511_1d(0 to 1);  -- median_beside_of_column_#_0
  signal median_beside_in_window_0 : natural_511_1d(0 to 1);  -- median_beside_in_window_#_0
  signal median_beside_waiting_0 : natural_511_1d(0 to 2);  -- median_beside_waiting_#_0
  signal median_counter_next_frame, median_arrives, median_behind, median_line_ended, median_read_arrives : boolean;
  signal median_read_behind, median_read_top, median_read_bottom, median_read_output, median_ready_arrives : boolean;
  signal median_ready_behind, median_ready_top, median_ready_output, median_at_arrives, median_at_behind : boolean;
  signal median_at_top, median_at_output, median_of_column_0_b_below_a, median_of_column_0_c_below_a : boolean;
  signal median_of_column_0_c_below_b : boolean;
  signal median_column_passed_0 : boolean_1d(0 to 1);  -- median_column_passed_#_0
  signal median_comparing_arrives, median_comparing_behind, median_comparing_top, median_comparing_output : boolean;
  signal median_sorted_arrives, median_sorted_behind, median_sorted_top, median_sorted_output : boolean;
  signal median_passed_0 : boolean_1d(0 to 1);  -- median_passed_#_0
  signal median_window_complete, median_window_first, median_window_last, median_of_low_0_b_below_a : boolean;
  signal median_of_low_0_c_below_a, median_of_low_0_c_below_b, median_of_middle_0_b_below_a : boolean;
  signal median_of_middle_0_c_below_a, median_of_middle_0_c_below_b, median_of_high_0_b_below_a : boolean;
  signal median_of_high_0_c_below_a, median_of_high_0_c_below_b, median_of_all_0_b_below_a : boolean;
  signal median_of_all_0_c_below_a, median_of_all_0_c_below_b : boolean;
  signal median_waiting_complete : boolean_1d(0 to 2);  -- median_waiting_#_complete
  signal median_waiting_first : boolean_1d(0 to 2);  -- median_waiting_#_first
  signal median_waiting_last : boolean_1d(0 to 2);  -- median_waiting_#_last
  signal median_waiting_passed_0 : boolean_1d(0 to 2);  -- median_waiting_passed_#_0
  signal median_out_passed_0, median_out_filled_0, median_out_valid, median_out_start_of_frame : boolean;
  signal median_out_end_of_line : boolean;
  signal median_newest_0, median_rows_read_newest_0, median_rows_ready_newest_0 : natural range 0 to 65535;
  signal median_column_2 : natural range 0 to 65535;
  signal median_rows_read_words_0 : unsigned(25 downto 0);
  signal median_rows_ready_words_0 : natural range 0 to 67108863;
  signal median_rows_write_words_0 : natural range 0 to 536870911;
  signal median_column_1 : natural range 0 to 8191;
  signal median_of_column_0_a, median_of_column_0_b : natural range 0 to 4095;
  signal median_of_column_0_c, median_sorted_low_0, median_sorted_middle_0 : natural range 0 to 32767;
  signal median_sorted_high_0 : natural range 0 to 32767;
  signal median_low_0 : natural_32767_1d(0 to 2);  -- median_low_#_0
  signal median_middle_0 : natural_32767_1d(0 to 2);  -- median_middle_#_0
  signal median_high_0 : natural_32767_1d(0 to 2);  -- median_high_#_0
  signal median_of_low_0_a, median_of_low_0_b, median_of_low_0_c, median_of_middle_0_a : natural range 0 to 32767;
  signal median_of_middle_0_b, median_of_middle_0_c, median_of_high_0_a, median_of_high_0_b : natural range 0 to 32767;
  signal median_of_high_0_c, median_largest_low_0, median_median_middle_0 : natural range 0 to 32767;
  signal median_smallest_high_0, median_of_all_0_a, median_of_all_0_b, median_of_all_0_c : natural range 0 to 32767;
  signal median_out_disparity_0 : natural range 0 to 32767;
  signal median_beside_rows_read_words_0 : unsigned(8 downto 0);
  signal median_out_confidence_0 : natural range 0 to 255;
  -- relief
  signal relief_centre_column : natural_255_1d(0 to 4);
  signal relief_centre_grey : natural_255_1d(0 to 1);
  signal relief_before : natural range 0 to 255;
  signal relief_newest, relief_delayed_0, relief_rows_read_newest_0, relief_rows_ready_words_0 : natural range 0 to 31;
  signal relief_rows_ready_newest_0, relief_rows_write_words_0, relief_shown_0, relief_column_0 : natural range 0 to 31;
  signal relief_entering, relief_entered, relief_between, relief_write_turned_0 : natural range 0 to 31;
  signal relief_rows_read_words_0, relief_turned_0 : unsigned(4 downto 0);
  signal relief_left : natural_64_1d(0 to 2);
  signal relief_right : natural_64_1d(0 to 2);
  signal relief_write_address : natural range 0 to 1023;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal median_beside_rows_read_words_0_memory_read_enable : boolean;
  signal median_beside_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal median_beside_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal median_beside_rows_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal median_rows_read_words_0_memory_read_enable : boolean;
  signal median_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal median_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal median_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal fill_above_read_0_memory_read_enable : boolean;
  signal fill_above_read_0_memory_read_address, fill_above_read_0_memory_write_address : unsigned(9 downto 0);
  signal fill_above_read_0_memory_write_data : unsigned(15 downto 0);
  signal fill_ends_read_words_0_memory_read_enable : boolean;
  signal fill_ends_read_words_0_memory_read_address, fill_ends_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal fill_ends_read_words_0_memory_write_data : unsigned(20 downto 0);
  signal fill_rows_read_words_0_memory_read_enable : boolean;
  signal fill_rows_read_words_0_memory_read_address, fill_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal fill_rows_read_words_0_memory_write_data : unsigned(18 downto 0);
  signal support_rows_read_words_0_memory_read_enable : boolean;
  signal support_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal support_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal support_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal support_rest_rows_read_words_0_memory_read_enable : boolean;
  signal support_rest_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal support_rest_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal support_rest_rows_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address, turn_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal leftright_found_0_memory_read_enable : boolean;
  signal leftright_found_0_memory_read_address, leftright_found_0_memory_write_address : unsigned(6 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(7 downto 0);
  signal leftright_held_1_memory_read_enable : boolean;
  signal leftright_held_1_memory_read_address, leftright_held_1_memory_write_address : unsigned(5 downto 0);
  signal leftright_held_1_memory_write_data : unsigned(5 downto 0);
  signal leftright_held_0_memory_read_enable : boolean;
  signal leftright_held_0_memory_read_address, leftright_held_0_memory_write_address : unsigned(5 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(17 downto 0);
  signal other_next_words_3_memory_read_enable : boolean;
  signal other_next_words_3_memory_read_address, other_next_words_3_memory_write_address : unsigned(2 downto 0);
  signal other_next_words_3_memory_write_data : unsigned(31 downto 0);
  signal other_next_words_2_memory_read_enable : boolean;
  signal other_next_words_2_memory_read_address, other_next_words_2_memory_write_address : unsigned(2 downto 0);
  signal other_next_words_2_memory_write_data : unsigned(31 downto 0);
  signal other_next_words_1_memory_read_enable : boolean;
  signal other_next_words_1_memory_read_address, other_next_words_1_memory_write_address : unsigned(2 downto 0);
  signal other_next_words_1_memory_write_data : unsigned(31 downto 0);
  signal other_next_words_0_memory_read_enable : boolean;
  signal other_next_words_0_memory_read_address, other_next_words_0_memory_write_address : unsigned(2 downto 0);
  signal other_next_words_0_memory_write_data : unsigned(31 downto 0);
  signal pathsright_read_words_3_memory_read_enable : boolean;
  signal pathsright_read_words_3_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_words_3_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_words_3_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_words_2_memory_read_enable : boolean;
  signal pathsright_read_words_2_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_words_2_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_words_1_memory_read_enable : boolean;
  signal pathsright_read_words_1_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_words_1_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_words_0_memory_read_enable : boolean;
  signal pathsright_read_words_0_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_words_0_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_neighbour_0_memory_read_enable : boolean;
  signal pathsright_read_neighbour_0_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_neighbour_0_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_neighbour_0_memory_write_data : unsigned(6 downto 0);
  signal pathsright_lowest_0_memory_read_enable : boolean;
  signal pathsright_lowest_0_memory_read_address, pathsright_lowest_0_memory_write_address : unsigned(3 downto 0);
  signal pathsright_lowest_0_memory_write_data : unsigned(6 downto 0);
  signal pathsturn_read_smallest_0_memory_read_enable : boolean;
  signal pathsturn_read_smallest_0_memory_read_address : unsigned(9 downto 0);
  signal pathsturn_read_smallest_0_memory_write_address : unsigned(9 downto 0);
  signal pathsturn_read_smallest_0_memory_write_data : unsigned(4 downto 0);
  signal pathsturn_sum_memory_read_words_0_3_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_3_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_3_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_2_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_2_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_2_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_2_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_1_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_sum_memory_read_words_1_3_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_3_memory_read_address : unsigned(9 downto 0);
  signal pathsturn_sum_memory_read_words_1_3_memory_write_address : unsigned(9 downto 0);
  signal pathsturn_sum_memory_read_words_1_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_2_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_2_memory_read_address : unsigned(9 downto 0);
  signal pathsturn_sum_memory_read_words_1_2_memory_write_address : unsigned(9 downto 0);
  signal pathsturn_sum_memory_read_words_1_2_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_1_memory_read_address : unsigned(9 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_write_address : unsigned(9 downto 0);
  signal pathsturn_sum_memory_read_words_1_1_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_0_memory_read_address : unsigned(9 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_write_address : unsigned(9 downto 0);
  signal pathsturn_sum_memory_read_words_1_0_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_cost_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_1_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_1_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_cost_memory_read_words_1_1_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_1_memory_read_address : unsigned(9 downto 0);
  signal pathsturn_cost_memory_read_words_1_1_memory_write_address : unsigned(9 downto 0);
  signal pathsturn_cost_memory_read_words_1_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_0_memory_read_address : unsigned(9 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_write_address : unsigned(9 downto 0);
  signal pathsturn_cost_memory_read_words_1_0_memory_write_data : unsigned(15 downto 0);
  signal pathsabove_delay_held_1_memory_read_enable : boolean;
  signal pathsabove_delay_held_1_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_1_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_1_memory_write_data : unsigned(9 downto 0);
  signal pathsabove_delay_held_0_memory_read_enable : boolean;
  signal pathsabove_delay_held_0_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_0_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_0_memory_write_data : unsigned(29 downto 0);
  signal pathsabove_memory_read_words_0_2_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_2_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_2_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_2_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_1_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_1_memory_write_data : unsigned(15 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_0_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_write_data : unsigned(15 downto 0);
  signal pathsabove_memory_read_words_1_2_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_2_memory_read_address : unsigned(9 downto 0);
  signal pathsabove_memory_read_words_1_2_memory_write_address : unsigned(9 downto 0);
  signal pathsabove_memory_read_words_1_2_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_1_memory_read_address : unsigned(9 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_write_address : unsigned(9 downto 0);
  signal pathsabove_memory_read_words_1_1_memory_write_data : unsigned(15 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_0_memory_read_address : unsigned(9 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_write_address : unsigned(9 downto 0);
  signal pathsabove_memory_read_words_1_0_memory_write_data : unsigned(15 downto 0);
  signal pathsleft_read_words_3_memory_read_enable : boolean;
  signal pathsleft_read_words_3_memory_read_address, pathsleft_read_words_3_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_words_3_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_words_2_memory_read_enable : boolean;
  signal pathsleft_read_words_2_memory_read_address, pathsleft_read_words_2_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_words_1_memory_read_enable : boolean;
  signal pathsleft_read_words_1_memory_read_address, pathsleft_read_words_1_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_words_0_memory_read_enable : boolean;
  signal pathsleft_read_words_0_memory_read_address, pathsleft_read_words_0_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_neighbour_0_memory_read_enable : boolean;
  signal pathsleft_read_neighbour_0_memory_read_address : unsigned(2 downto 0);
  signal pathsleft_read_neighbour_0_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_neighbour_0_memory_write_data : unsigned(6 downto 0);
  signal pathsleft_lowest_0_memory_read_enable : boolean;
  signal pathsleft_lowest_0_memory_read_address, pathsleft_lowest_0_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_lowest_0_memory_write_data : unsigned(6 downto 0);
  signal paths_cost_delay_held_0_memory_read_enable : boolean;
  signal paths_cost_delay_held_0_memory_read_address : unsigned(3 downto 0);
  signal paths_cost_delay_held_0_memory_write_address : unsigned(3 downto 0);
  signal paths_cost_delay_held_0_memory_write_data : unsigned(23 downto 0);
  signal relief_turned_0_memory_read_enable : boolean;
  signal relief_turned_0_memory_read_address, relief_turned_0_memory_write_address : unsigned(9 downto 0);
  signal relief_turned_0_memory_write_data : unsigned(4 downto 0);
  signal relief_rows_read_words_0_memory_read_enable : boolean;
  signal relief_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal relief_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal relief_rows_read_words_0_memory_write_data : unsigned(4 downto 0);
  signal costswindow_read_words_3_memory_read_enable : boolean;
  signal costswindow_read_words_3_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_3_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_3_memory_write_data : unsigned(27 downto 0);
  signal costswindow_read_words_2_memory_read_enable : boolean;
  signal costswindow_read_words_2_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_2_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal costswindow_read_words_1_memory_read_enable : boolean;
  signal costswindow_read_words_1_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_1_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_1_memory_write_data : unsigned(26 downto 0);
  signal costswindow_read_words_0_memory_read_enable : boolean;
  signal costswindow_read_words_0_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_0_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_0_memory_write_data : unsigned(26 downto 0);
  signal costsshift_read_words_11_memory_read_enable : boolean;
  signal costsshift_read_words_11_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_11_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_11_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_10_memory_read_enable : boolean;
  signal costsshift_read_words_10_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_10_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_10_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_9_memory_read_enable : boolean;
  signal costsshift_read_words_9_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_9_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_9_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_8_memory_read_enable : boolean;
  signal costsshift_read_words_8_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_8_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_8_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_7_memory_read_enable : boolean;
  signal costsshift_read_words_7_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_7_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_7_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_6_memory_read_enable : boolean;
  signal costsshift_read_words_6_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_6_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_6_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_5_memory_read_enable : boolean;
  signal costsshift_read_words_5_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_5_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_5_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_4_memory_read_enable : boolean;
  signal costsshift_read_words_4_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_4_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_4_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_3_memory_read_enable : boolean;
  signal costsshift_read_words_3_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_3_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_3_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_2_memory_read_enable : boolean;
  signal costsshift_read_words_2_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_2_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_1_memory_read_enable : boolean;
  signal costsshift_read_words_1_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_1_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_0_memory_read_enable : boolean;
  signal costsshift_read_words_0_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_0_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(27 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(unsigned'(to_unsigned(median_out_confidence_0, 8) & to_unsigned(as_number(median_out_filled_0), 1) & to_unsigned(median_out_disparity_0, 15)));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(median_out_passed_0), 1));
  disparity_valid <= as_bit(median_out_valid);
  disparity_start_of_frame <= as_bit(median_out_start_of_frame);
  disparity_end_of_line <= as_bit(median_out_end_of_line);

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

  median_beside_rows_read_words_0_memory_read_enable <= true;
  median_beside_rows_read_words_0_memory_read_address <= to_unsigned(median_counter_column, 10);
  median_beside_rows_read_words_0_memory_write_address <= to_unsigned(median_at_column, 10);
  median_beside_rows_read_words_0_memory_write_data <= to_unsigned(median_beside_rows_write_words_0, 9);
  median_beside_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 638, width => 9, address_bits => 10)
    port map (
      clock => clock, read_enable => median_beside_rows_read_words_0_memory_read_enable,
      read_address => median_beside_rows_read_words_0_memory_read_address, read_data => median_beside_rows_read_words_0,
      write_address => median_beside_rows_read_words_0_memory_write_address, write_data => median_beside_rows_read_words_0_memory_write_data);

  median_rows_read_words_0_memory_read_enable <= true;
  median_rows_read_words_0_memory_read_address <= to_unsigned(median_counter_column, 10);
  median_rows_read_words_0_memory_write_address <= to_unsigned(median_at_column, 10);
  median_rows_read_words_0_memory_write_data <= to_unsigned((median_rows_write_words_0 mod 67108864), 26);
  median_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 638, width => 26, address_bits => 10)
    port map (
      clock => clock, read_enable => median_rows_read_words_0_memory_read_enable,
      read_address => median_rows_read_words_0_memory_read_address, read_data => median_rows_read_words_0,
      write_address => median_rows_read_words_0_memory_write_address, write_data => median_rows_read_words_0_memory_write_data);

  fill_above_read_0_memory_read_enable <= true;
  fill_above_read_0_memory_read_address <= to_unsigned(fill_known_at_column, 10);
  fill_above_read_0_memory_write_address <= to_unsigned(fill_write_above_column, 10);
  fill_above_read_0_memory_write_data <= to_unsigned(fill_write_above_0, 16);
  fill_above_read_0_memory : entity work.line_memory
    generic map (depth => 638, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => fill_above_read_0_memory_read_enable,
      read_address => fill_above_read_0_memory_read_address, read_data => fill_above_read_0,
      write_address => fill_above_read_0_memory_write_address, write_data => fill_above_read_0_memory_write_data);

  fill_ends_read_words_0_memory_read_enable <= true;
  fill_ends_read_words_0_memory_read_address <= to_unsigned(fill_ends_read_place_0, 9);
  fill_ends_read_words_0_memory_write_address <= to_unsigned(fill_ends_write_place_0, 9);
  fill_ends_read_words_0_memory_write_data <= to_unsigned(fill_ends_write_words_0, 21);
  fill_ends_read_words_0_memory : entity work.line_memory
    generic map (depth => 323, width => 21, address_bits => 9)
    port map (
      clock => clock, read_enable => fill_ends_read_words_0_memory_read_enable,
      read_address => fill_ends_read_words_0_memory_read_address, read_data => fill_ends_read_words_0,
      write_address => fill_ends_read_words_0_memory_write_address, write_data => fill_ends_read_words_0_memory_write_data);

  fill_rows_read_words_0_memory_read_enable <= true;
  fill_rows_read_words_0_memory_read_address <= to_unsigned(fill_counter_column, 10);
  fill_rows_read_words_0_memory_write_address <= to_unsigned(fill_at_column, 10);
  fill_rows_read_words_0_memory_write_data <= to_unsigned(fill_rows_write_words_0, 19);
  fill_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 638, width => 19, address_bits => 10)
    port map (
      clock => clock, read_enable => fill_rows_read_words_0_memory_read_enable,
      read_address => fill_rows_read_words_0_memory_read_address, read_data => fill_rows_read_words_0,
      write_address => fill_rows_read_words_0_memory_write_address, write_data => fill_rows_read_words_0_memory_write_data);

  support_rows_read_words_0_memory_read_enable <= true;
  support_rows_read_words_0_memory_read_address <= to_unsigned(support_counter_column, 10);
  support_rows_read_words_0_memory_write_address <= to_unsigned(support_write_column, 10);
  support_rows_read_words_0_memory_write_data <= to_unsigned(support_rows_write_words_0, 28);
  support_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 638, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => support_rows_read_words_0_memory_read_enable,
      read_address => support_rows_read_words_0_memory_read_address, read_data => support_rows_read_words_0,
      write_address => support_rows_read_words_0_memory_write_address, write_data => support_rows_read_words_0_memory_write_data);

  support_rest_rows_read_words_0_memory_read_enable <= true;
  support_rest_rows_read_words_0_memory_read_address <= to_unsigned(support_counter_column, 10);
  support_rest_rows_read_words_0_memory_write_address <= to_unsigned(support_write_column, 10);
  support_rest_rows_read_words_0_memory_write_data <= to_unsigned(support_rest_rows_write_words_0, 20);
  support_rest_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 638, width => 20, address_bits => 10)
    port map (
      clock => clock, read_enable => support_rest_rows_read_words_0_memory_read_enable,
      read_address => support_rest_rows_read_words_0_memory_read_address, read_data => support_rest_rows_read_words_0,
      write_address => support_rest_rows_read_words_0_memory_write_address, write_data => support_rest_rows_read_words_0_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 10);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 10);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 20);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 639, width => 20, address_bits => 10)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  leftright_found_0_memory_read_enable <= true;
  leftright_found_0_memory_read_address <= to_unsigned(leftright_address_0, 7);
  leftright_found_0_memory_write_address <= to_unsigned(leftright_position, 7);
  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_0(14), 8);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 128, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => leftright_found_0_memory_read_enable,
      read_address => leftright_found_0_memory_read_address, read_data => leftright_found_0,
      write_address => leftright_found_0_memory_write_address, write_data => leftright_found_0_memory_write_data);

  leftright_held_1_memory_read_enable <= true;
  leftright_held_1_memory_read_address <= to_unsigned(leftright_ring_read_address, 6);
  leftright_held_1_memory_write_address <= to_unsigned(leftright_ring_write_address, 6);
  leftright_held_1_memory_write_data <= to_unsigned(refinement_margin_0(9), 6);
  leftright_held_1_memory : entity work.line_memory
    generic map (depth => 64, width => 6, address_bits => 6)
    port map (
      clock => clock, read_enable => leftright_held_1_memory_read_enable,
      read_address => leftright_held_1_memory_read_address, read_data => leftright_held_1,
      write_address => leftright_held_1_memory_write_address, write_data => leftright_held_1_memory_write_data);

  leftright_held_0_memory_read_enable <= true;
  leftright_held_0_memory_read_address <= to_unsigned(leftright_ring_read_address, 6);
  leftright_held_0_memory_write_address <= to_unsigned(leftright_ring_write_address, 6);
  leftright_held_0_memory_write_data <= to_unsigned(other_4, 5) & to_unsigned(as_number(refinement_passed_0(11)), 1) & to_unsigned(refinement_disparity_0(11), 8) & to_unsigned(as_number(refinement_tag_end_of_line(11)), 1) & to_unsigned(as_number(refinement_tag_start_of_frame(11)), 1) & to_unsigned(as_number(refinement_tag_output_column(11)), 1) & to_unsigned(as_number(refinement_tag_map_column(11)), 1);
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 64, width => 18, address_bits => 6)
    port map (
      clock => clock, read_enable => leftright_held_0_memory_read_enable,
      read_address => leftright_held_0_memory_read_address, read_data => leftright_held_0,
      write_address => leftright_held_0_memory_write_address, write_data => leftright_held_0_memory_write_data);

  other_next_words_3_memory_read_enable <= true;
  other_next_words_3_memory_read_address <= to_unsigned(other_read_count_phase, 3);
  other_next_words_3_memory_write_address <= to_unsigned(other_write_count_phase, 3);
  other_next_words_3_memory_write_data <= other(12);
  other_next_words_3_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => other_next_words_3_memory_read_enable,
      read_address => other_next_words_3_memory_read_address, read_data => other_next_words(3),
      write_address => other_next_words_3_memory_write_address, write_data => other_next_words_3_memory_write_data);

  other_next_words_2_memory_read_enable <= true;
  other_next_words_2_memory_read_address <= to_unsigned(other_read_count_phase, 3);
  other_next_words_2_memory_write_address <= to_unsigned(other_write_count_phase, 3);
  other_next_words_2_memory_write_data <= other(13);
  other_next_words_2_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => other_next_words_2_memory_read_enable,
      read_address => other_next_words_2_memory_read_address, read_data => other_next_words(2),
      write_address => other_next_words_2_memory_write_address, write_data => other_next_words_2_memory_write_data);

  other_next_words_1_memory_read_enable <= true;
  other_next_words_1_memory_read_address <= to_unsigned(other_read_count_phase, 3);
  other_next_words_1_memory_write_address <= to_unsigned(other_write_count_phase, 3);
  other_next_words_1_memory_write_data <= other(14);
  other_next_words_1_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => other_next_words_1_memory_read_enable,
      read_address => other_next_words_1_memory_read_address, read_data => other_next_words(1),
      write_address => other_next_words_1_memory_write_address, write_data => other_next_words_1_memory_write_data);

  other_next_words_0_memory_read_enable <= true;
  other_next_words_0_memory_read_address <= to_unsigned(other_read_count_phase, 3);
  other_next_words_0_memory_write_address <= to_unsigned(other_write_count_phase, 3);
  other_next_words_0_memory_write_data <= other(15);
  other_next_words_0_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => other_next_words_0_memory_read_enable,
      read_address => other_next_words_0_memory_read_address, read_data => other_next_words(0),
      write_address => other_next_words_0_memory_write_address, write_data => other_next_words_0_memory_write_data);

  pathsright_read_words_3_memory_read_enable <= true;
  pathsright_read_words_3_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_3_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_3_memory_write_data <= to_unsigned(pathsright_arrived(7), 7) & to_unsigned(pathsright_arrived(6), 7) & to_unsigned(pathsright_arrived(5), 7) & to_unsigned(pathsright_arrived(4), 7);
  pathsright_read_words_3_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_3_memory_read_enable,
      read_address => pathsright_read_words_3_memory_read_address, read_data => pathsright_read_words(3),
      write_address => pathsright_read_words_3_memory_write_address, write_data => pathsright_read_words_3_memory_write_data);

  pathsright_read_words_2_memory_read_enable <= true;
  pathsright_read_words_2_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_2_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_2_memory_write_data <= to_unsigned(pathsright_arrived(3), 7) & to_unsigned(pathsright_arrived(2), 7) & to_unsigned(pathsright_arrived(1), 7) & to_unsigned(pathsright_arrived(0), 7);
  pathsright_read_words_2_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_2_memory_read_enable,
      read_address => pathsright_read_words_2_memory_read_address, read_data => pathsright_read_words(2),
      write_address => pathsright_read_words_2_memory_write_address, write_data => pathsright_read_words_2_memory_write_data);

  pathsright_read_words_1_memory_read_enable <= true;
  pathsright_read_words_1_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_1_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_1_memory_write_data <= to_unsigned(pathsright_cost(7), 7) & to_unsigned(pathsright_cost(6), 7) & to_unsigned(pathsright_cost(5), 7) & to_unsigned(pathsright_cost(4), 7);
  pathsright_read_words_1_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_1_memory_read_enable,
      read_address => pathsright_read_words_1_memory_read_address, read_data => pathsright_read_words(1),
      write_address => pathsright_read_words_1_memory_write_address, write_data => pathsright_read_words_1_memory_write_data);

  pathsright_read_words_0_memory_read_enable <= true;
  pathsright_read_words_0_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_0_memory_write_data <= to_unsigned(pathsright_cost(3), 7) & to_unsigned(pathsright_cost(2), 7) & to_unsigned(pathsright_cost(1), 7) & to_unsigned(pathsright_cost(0), 7);
  pathsright_read_words_0_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_0_memory_read_enable,
      read_address => pathsright_read_words_0_memory_read_address, read_data => pathsright_read_words(0),
      write_address => pathsright_read_words_0_memory_write_address, write_data => pathsright_read_words_0_memory_write_data);

  pathsright_read_neighbour_0_memory_read_enable <= true;
  pathsright_read_neighbour_0_memory_read_address <= to_unsigned(pathsleft_ahead_count_phase, 3);
  pathsright_read_neighbour_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_neighbour_0_memory_write_data <= to_unsigned(pathsright_cost(0), 7);
  pathsright_read_neighbour_0_memory : entity work.line_memory
    generic map (depth => 8, width => 7, address_bits => 3)
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
  pathsturn_read_smallest_0_memory_read_address <= to_unsigned(pathsturn_smallest_address, 10);
  pathsturn_read_smallest_0_memory_write_address <= to_unsigned(pathsturn_write_smallest_address, 10);
  pathsturn_read_smallest_0_memory_write_data <= to_unsigned(pathsturn_write_smallest_0, 5);
  pathsturn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 639, width => 5, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsturn_read_smallest_0_memory_read_enable,
      read_address => pathsturn_read_smallest_0_memory_read_address, read_data => pathsturn_read_smallest_0,
      write_address => pathsturn_read_smallest_0_memory_write_address, write_data => pathsturn_read_smallest_0_memory_write_data);

  pathsturn_sum_memory_read_words_0_3_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_3_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_3_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_3_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_3(0), 8);
  pathsturn_sum_memory_read_words_0_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_3_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_3_memory_read_address, read_data => pathsturn_sum_memory_read_words_3(0),
      write_address => pathsturn_sum_memory_read_words_0_3_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_3_memory_write_data);

  pathsturn_sum_memory_read_words_0_2_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_2_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_2_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_2_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 2), 16);
  pathsturn_sum_memory_read_words_0_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 16, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_2_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_2_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 2),
      write_address => pathsturn_sum_memory_read_words_0_2_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_2_memory_write_data);

  pathsturn_sum_memory_read_words_0_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 1), 16);
  pathsturn_sum_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 16, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_1_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 1),
      write_address => pathsturn_sum_memory_read_words_0_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_1_memory_write_data);

  pathsturn_sum_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
  pathsturn_sum_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 0), 16);
  pathsturn_sum_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 16, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_0_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 0),
      write_address => pathsturn_sum_memory_read_words_0_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_0_memory_write_data);

  pathsturn_sum_memory_read_words_1_3_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_3_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 10);
  pathsturn_sum_memory_read_words_1_3_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 10);
  pathsturn_sum_memory_read_words_1_3_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_3(1), 8);
  pathsturn_sum_memory_read_words_1_3_memory : entity work.line_memory
    generic map (depth => 1024, width => 8, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_3_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_3_memory_read_address, read_data => pathsturn_sum_memory_read_words_3(1),
      write_address => pathsturn_sum_memory_read_words_1_3_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_3_memory_write_data);

  pathsturn_sum_memory_read_words_1_2_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_2_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 10);
  pathsturn_sum_memory_read_words_1_2_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 10);
  pathsturn_sum_memory_read_words_1_2_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 2), 16);
  pathsturn_sum_memory_read_words_1_2_memory : entity work.line_memory
    generic map (depth => 1024, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_2_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_2_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 2),
      write_address => pathsturn_sum_memory_read_words_1_2_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_2_memory_write_data);

  pathsturn_sum_memory_read_words_1_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 10);
  pathsturn_sum_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 10);
  pathsturn_sum_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 1), 16);
  pathsturn_sum_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 1024, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_1_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 1),
      write_address => pathsturn_sum_memory_read_words_1_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_1_memory_write_data);

  pathsturn_sum_memory_read_words_1_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 10);
  pathsturn_sum_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 10);
  pathsturn_sum_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 0), 16);
  pathsturn_sum_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 1024, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_0_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 0),
      write_address => pathsturn_sum_memory_read_words_1_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_0_memory_write_data);

  pathsturn_cost_memory_read_words_0_1_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
  pathsturn_cost_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_1(0), 8);
  pathsturn_cost_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_1_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_1_memory_read_address, read_data => pathsturn_cost_memory_read_words_1(0),
      write_address => pathsturn_cost_memory_read_words_0_1_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_1_memory_write_data);

  pathsturn_cost_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
  pathsturn_cost_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0(0), 16);
  pathsturn_cost_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 16, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_0_memory_read_address, read_data => pathsturn_cost_memory_read_words_0(0),
      write_address => pathsturn_cost_memory_read_words_0_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_0_memory_write_data);

  pathsturn_cost_memory_read_words_1_1_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_1, 10);
  pathsturn_cost_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 10);
  pathsturn_cost_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_1(1), 8);
  pathsturn_cost_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 1024, width => 8, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_1_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_1_memory_read_address, read_data => pathsturn_cost_memory_read_words_1(1),
      write_address => pathsturn_cost_memory_read_words_1_1_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_1_memory_write_data);

  pathsturn_cost_memory_read_words_1_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_1, 10);
  pathsturn_cost_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 10);
  pathsturn_cost_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0(1), 16);
  pathsturn_cost_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 1024, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_0_memory_read_address, read_data => pathsturn_cost_memory_read_words_0(1),
      write_address => pathsturn_cost_memory_read_words_1_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_0_memory_write_data);

  pathsabove_delay_held_1_memory_read_enable <= true;
  pathsabove_delay_held_1_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  pathsabove_delay_held_1_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  pathsabove_delay_held_1_memory_write_data <= ((to_unsigned((pathsabove_total(7) mod 32), 5) & to_unsigned(0, 5)) or (to_unsigned(pathsabove_total(6), 10)));
  pathsabove_delay_held_1_memory : entity work.line_memory
    generic map (depth => 12, width => 10, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_1_memory_read_enable,
      read_address => pathsabove_delay_held_1_memory_read_address, read_data => pathsabove_delay_held_1,
      write_address => pathsabove_delay_held_1_memory_write_address, write_data => pathsabove_delay_held_1_memory_write_data);

  pathsabove_delay_held_0_memory_read_enable <= true;
  pathsabove_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  pathsabove_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  pathsabove_delay_held_0_memory_write_data <= ((to_unsigned((pathsabove_total(5) mod 32), 5) & to_unsigned(to_integer(((to_unsigned(pathsabove_total(2), 11) & to_unsigned(0, 10)) or (to_unsigned(pathsabove_total(3), 6) & to_unsigned(to_integer(((to_unsigned(pathsabove_total(1), 6) & to_unsigned(0, 5)) or (to_unsigned(pathsabove_total(0), 11)))), 15)))), 25)) or (to_unsigned(pathsabove_total(4), 10) & to_unsigned(0, 20)));
  pathsabove_delay_held_0_memory : entity work.line_memory
    generic map (depth => 12, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_0_memory_read_enable,
      read_address => pathsabove_delay_held_0_memory_read_address, read_data => pathsabove_delay_held_0,
      write_address => pathsabove_delay_held_0_memory_write_address, write_data => pathsabove_delay_held_0_memory_write_data);

  pathsabove_memory_read_words_0_2_memory_read_enable <= true;
  pathsabove_memory_read_words_0_2_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_2_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_2_memory_write_data <= to_unsigned(pathsabove_memory_write_words_2(0), 8);
  pathsabove_memory_read_words_0_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_2_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_2_memory_read_address, read_data => pathsabove_memory_read_words_2(0),
      write_address => pathsabove_memory_read_words_0_2_memory_write_address, write_data => pathsabove_memory_read_words_0_2_memory_write_data);

  pathsabove_memory_read_words_0_1_memory_read_enable <= true;
  pathsabove_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 1), 16);
  pathsabove_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 16, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_1_memory_read_address, read_data => pathsabove_memory_read_words(0, 1),
      write_address => pathsabove_memory_read_words_0_1_memory_write_address, write_data => pathsabove_memory_read_words_0_1_memory_write_data);

  pathsabove_memory_read_words_0_0_memory_read_enable <= true;
  pathsabove_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
  pathsabove_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 0), 16);
  pathsabove_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 16, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_0_memory_read_address, read_data => pathsabove_memory_read_words(0, 0),
      write_address => pathsabove_memory_read_words_0_0_memory_write_address, write_data => pathsabove_memory_read_words_0_0_memory_write_data);

  pathsabove_memory_read_words_1_2_memory_read_enable <= true;
  pathsabove_memory_read_words_1_2_memory_read_address <= to_unsigned(pathsabove_memory_read_address_1, 10);
  pathsabove_memory_read_words_1_2_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 10);
  pathsabove_memory_read_words_1_2_memory_write_data <= to_unsigned(pathsabove_memory_write_words_2(1), 8);
  pathsabove_memory_read_words_1_2_memory : entity work.line_memory
    generic map (depth => 1024, width => 8, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_2_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_2_memory_read_address, read_data => pathsabove_memory_read_words_2(1),
      write_address => pathsabove_memory_read_words_1_2_memory_write_address, write_data => pathsabove_memory_read_words_1_2_memory_write_data);

  pathsabove_memory_read_words_1_1_memory_read_enable <= true;
  pathsabove_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_1, 10);
  pathsabove_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 10);
  pathsabove_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 1), 16);
  pathsabove_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 1024, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_1_memory_read_address, read_data => pathsabove_memory_read_words(1, 1),
      write_address => pathsabove_memory_read_words_1_1_memory_write_address, write_data => pathsabove_memory_read_words_1_1_memory_write_data);

  pathsabove_memory_read_words_1_0_memory_read_enable <= true;
  pathsabove_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_1, 10);
  pathsabove_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_1, 10);
  pathsabove_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 0), 16);
  pathsabove_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 1024, width => 16, address_bits => 10)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_0_memory_read_address, read_data => pathsabove_memory_read_words(1, 0),
      write_address => pathsabove_memory_read_words_1_0_memory_write_address, write_data => pathsabove_memory_read_words_1_0_memory_write_data);

  pathsleft_read_words_3_memory_read_enable <= true;
  pathsleft_read_words_3_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_3_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_3_memory_write_data <= to_unsigned(pathsleft_arrived(7), 7) & to_unsigned(pathsleft_arrived(6), 7) & to_unsigned(pathsleft_arrived(5), 7) & to_unsigned(pathsleft_arrived(4), 7);
  pathsleft_read_words_3_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_3_memory_read_enable,
      read_address => pathsleft_read_words_3_memory_read_address, read_data => pathsleft_read_words(3),
      write_address => pathsleft_read_words_3_memory_write_address, write_data => pathsleft_read_words_3_memory_write_data);

  pathsleft_read_words_2_memory_read_enable <= true;
  pathsleft_read_words_2_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_2_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_2_memory_write_data <= to_unsigned(pathsleft_arrived(3), 7) & to_unsigned(pathsleft_arrived(2), 7) & to_unsigned(pathsleft_arrived(1), 7) & to_unsigned(pathsleft_arrived(0), 7);
  pathsleft_read_words_2_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_2_memory_read_enable,
      read_address => pathsleft_read_words_2_memory_read_address, read_data => pathsleft_read_words(2),
      write_address => pathsleft_read_words_2_memory_write_address, write_data => pathsleft_read_words_2_memory_write_data);

  pathsleft_read_words_1_memory_read_enable <= true;
  pathsleft_read_words_1_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_1_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_1_memory_write_data <= to_unsigned(pathsleft_cost(7), 7) & to_unsigned(pathsleft_cost(6), 7) & to_unsigned(pathsleft_cost(5), 7) & to_unsigned(pathsleft_cost(4), 7);
  pathsleft_read_words_1_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_1_memory_read_enable,
      read_address => pathsleft_read_words_1_memory_read_address, read_data => pathsleft_read_words(1),
      write_address => pathsleft_read_words_1_memory_write_address, write_data => pathsleft_read_words_1_memory_write_data);

  pathsleft_read_words_0_memory_read_enable <= true;
  pathsleft_read_words_0_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_0_memory_write_data <= to_unsigned(pathsleft_cost(3), 7) & to_unsigned(pathsleft_cost(2), 7) & to_unsigned(pathsleft_cost(1), 7) & to_unsigned(pathsleft_cost(0), 7);
  pathsleft_read_words_0_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_0_memory_read_enable,
      read_address => pathsleft_read_words_0_memory_read_address, read_data => pathsleft_read_words(0),
      write_address => pathsleft_read_words_0_memory_write_address, write_data => pathsleft_read_words_0_memory_write_data);

  pathsleft_read_neighbour_0_memory_read_enable <= true;
  pathsleft_read_neighbour_0_memory_read_address <= to_unsigned(pathsleft_ahead_count_phase, 3);
  pathsleft_read_neighbour_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_neighbour_0_memory_write_data <= to_unsigned(pathsleft_cost(0), 7);
  pathsleft_read_neighbour_0_memory : entity work.line_memory
    generic map (depth => 8, width => 7, address_bits => 3)
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
  paths_cost_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  paths_cost_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  paths_cost_delay_held_0_memory_write_data <= ((((((((((((((to_unsigned(costs_cost(6), 6) & to_unsigned(0, 18)) or (to_unsigned((costs_cost(7) mod 8), 3) & to_unsigned(0, 21)))) or (to_unsigned(costs_cost(5), 9) & to_unsigned(0, 15)))) or (to_unsigned(costs_cost(4), 12) & to_unsigned(0, 12)))) or (to_unsigned(costs_cost(3), 15) & to_unsigned(0, 9)))) or (to_unsigned(costs_cost(2), 18) & to_unsigned(0, 6)))) or (to_unsigned(costs_cost(0), 24)))) or (to_unsigned(costs_cost(1), 21) & to_unsigned(0, 3)));
  paths_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 12, width => 24, address_bits => 4)
    port map (
      clock => clock, read_enable => paths_cost_delay_held_0_memory_read_enable,
      read_address => paths_cost_delay_held_0_memory_read_address, read_data => paths_cost_delay_held_0,
      write_address => paths_cost_delay_held_0_memory_write_address, write_data => paths_cost_delay_held_0_memory_write_data);

  relief_turned_0_memory_read_enable <= true;
  relief_turned_0_memory_read_address <= to_unsigned(line_order_address, 10);
  relief_turned_0_memory_write_address <= to_unsigned(relief_write_address, 10);
  relief_turned_0_memory_write_data <= to_unsigned(relief_write_turned_0, 5);
  relief_turned_0_memory : entity work.line_memory
    generic map (depth => 639, width => 5, address_bits => 10)
    port map (
      clock => clock, read_enable => relief_turned_0_memory_read_enable,
      read_address => relief_turned_0_memory_read_address, read_data => relief_turned_0,
      write_address => relief_turned_0_memory_write_address, write_data => relief_turned_0_memory_write_data);

  relief_rows_read_words_0_memory_read_enable <= true;
  relief_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 10);
  relief_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 10);
  relief_rows_read_words_0_memory_write_data <= to_unsigned(relief_rows_write_words_0, 5);
  relief_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 5, address_bits => 10)
    port map (
      clock => clock, read_enable => relief_rows_read_words_0_memory_read_enable,
      read_address => relief_rows_read_words_0_memory_read_address, read_data => relief_rows_read_words_0,
      write_address => relief_rows_read_words_0_memory_write_address, write_data => relief_rows_read_words_0_memory_write_data);

  costswindow_read_words_3_memory_read_enable <= true;
  costswindow_read_words_3_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_3_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_3_memory_write_data <= to_unsigned(costswindow_partials(15), 7) & to_unsigned(costswindow_partials(14), 7) & to_unsigned(costswindow_partials(13), 7) & to_unsigned(costswindow_partials(12), 7);
  costswindow_read_words_3_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_3_memory_read_enable,
      read_address => costswindow_read_words_3_memory_read_address, read_data => costswindow_read_wordss(3),
      write_address => costswindow_read_words_3_memory_write_address, write_data => costswindow_read_words_3_memory_write_data);

  costswindow_read_words_2_memory_read_enable <= true;
  costswindow_read_words_2_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_2_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_2_memory_write_data <= to_unsigned(costswindow_partials(11), 7) & to_unsigned(costswindow_partials(10), 7) & to_unsigned(costswindow_partials(9), 7) & to_unsigned(costswindow_partials(8), 7);
  costswindow_read_words_2_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_2_memory_read_enable,
      read_address => costswindow_read_words_2_memory_read_address, read_data => costswindow_read_wordss(2),
      write_address => costswindow_read_words_2_memory_write_address, write_data => costswindow_read_words_2_memory_write_data);

  costswindow_read_words_1_memory_read_enable <= true;
  costswindow_read_words_1_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_1_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_1_memory_write_data <= to_unsigned(costswindow_partial(7), 6) & to_unsigned(costswindow_partial(6), 7) & to_unsigned(costswindow_partial(5), 7) & to_unsigned(costswindow_partial(4), 7);
  costswindow_read_words_1_memory : entity work.line_memory
    generic map (depth => 8, width => 27, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_1_memory_read_enable,
      read_address => costswindow_read_words_1_memory_read_address, read_data => costswindow_read_words(1),
      write_address => costswindow_read_words_1_memory_write_address, write_data => costswindow_read_words_1_memory_write_data);

  costswindow_read_words_0_memory_read_enable <= true;
  costswindow_read_words_0_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_0_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_0_memory_write_data <= to_unsigned(costswindow_partial(3), 6) & to_unsigned(costswindow_partial(2), 7) & to_unsigned(costswindow_partial(1), 7) & to_unsigned(costswindow_partial(0), 7);
  costswindow_read_words_0_memory : entity work.line_memory
    generic map (depth => 8, width => 27, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_0_memory_read_enable,
      read_address => costswindow_read_words_0_memory_read_address, read_data => costswindow_read_words(0),
      write_address => costswindow_read_words_0_memory_write_address, write_data => costswindow_read_words_0_memory_write_data);

  costsshift_read_words_11_memory_read_enable <= true;
  costsshift_read_words_11_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_11_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_11_memory_write_data <= to_unsigned(costsshift_search(2, 7), 14) & to_unsigned(costsshift_search(2, 6), 14);
  costsshift_read_words_11_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_11_memory_read_enable,
      read_address => costsshift_read_words_11_memory_read_address, read_data => costsshift_read_words(11),
      write_address => costsshift_read_words_11_memory_write_address, write_data => costsshift_read_words_11_memory_write_data);

  costsshift_read_words_10_memory_read_enable <= true;
  costsshift_read_words_10_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_10_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_10_memory_write_data <= to_unsigned(costsshift_search(2, 5), 14) & to_unsigned(costsshift_search(2, 4), 14);
  costsshift_read_words_10_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_10_memory_read_enable,
      read_address => costsshift_read_words_10_memory_read_address, read_data => costsshift_read_words(10),
      write_address => costsshift_read_words_10_memory_write_address, write_data => costsshift_read_words_10_memory_write_data);

  costsshift_read_words_9_memory_read_enable <= true;
  costsshift_read_words_9_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_9_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_9_memory_write_data <= to_unsigned(costsshift_search(2, 3), 14) & to_unsigned(costsshift_search(2, 2), 14);
  costsshift_read_words_9_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_9_memory_read_enable,
      read_address => costsshift_read_words_9_memory_read_address, read_data => costsshift_read_words(9),
      write_address => costsshift_read_words_9_memory_write_address, write_data => costsshift_read_words_9_memory_write_data);

  costsshift_read_words_8_memory_read_enable <= true;
  costsshift_read_words_8_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_8_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_8_memory_write_data <= to_unsigned(costsshift_search(2, 1), 14) & to_unsigned(costsshift_search(2, 0), 14);
  costsshift_read_words_8_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_8_memory_read_enable,
      read_address => costsshift_read_words_8_memory_read_address, read_data => costsshift_read_words(8),
      write_address => costsshift_read_words_8_memory_write_address, write_data => costsshift_read_words_8_memory_write_data);

  costsshift_read_words_7_memory_read_enable <= true;
  costsshift_read_words_7_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_7_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_7_memory_write_data <= to_unsigned(costsshift_search(1, 7), 14) & to_unsigned(costsshift_search(1, 6), 14);
  costsshift_read_words_7_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_7_memory_read_enable,
      read_address => costsshift_read_words_7_memory_read_address, read_data => costsshift_read_words(7),
      write_address => costsshift_read_words_7_memory_write_address, write_data => costsshift_read_words_7_memory_write_data);

  costsshift_read_words_6_memory_read_enable <= true;
  costsshift_read_words_6_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_6_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_6_memory_write_data <= to_unsigned(costsshift_search(1, 5), 14) & to_unsigned(costsshift_search(1, 4), 14);
  costsshift_read_words_6_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_6_memory_read_enable,
      read_address => costsshift_read_words_6_memory_read_address, read_data => costsshift_read_words(6),
      write_address => costsshift_read_words_6_memory_write_address, write_data => costsshift_read_words_6_memory_write_data);

  costsshift_read_words_5_memory_read_enable <= true;
  costsshift_read_words_5_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_5_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_5_memory_write_data <= to_unsigned(costsshift_search(1, 3), 14) & to_unsigned(costsshift_search(1, 2), 14);
  costsshift_read_words_5_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_5_memory_read_enable,
      read_address => costsshift_read_words_5_memory_read_address, read_data => costsshift_read_words(5),
      write_address => costsshift_read_words_5_memory_write_address, write_data => costsshift_read_words_5_memory_write_data);

  costsshift_read_words_4_memory_read_enable <= true;
  costsshift_read_words_4_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_4_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_4_memory_write_data <= to_unsigned(costsshift_search(1, 1), 14) & to_unsigned(costsshift_search(1, 0), 14);
  costsshift_read_words_4_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_4_memory_read_enable,
      read_address => costsshift_read_words_4_memory_read_address, read_data => costsshift_read_words(4),
      write_address => costsshift_read_words_4_memory_write_address, write_data => costsshift_read_words_4_memory_write_data);

  costsshift_read_words_3_memory_read_enable <= true;
  costsshift_read_words_3_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_3_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_3_memory_write_data <= to_unsigned(costsshift_search(0, 7), 14) & to_unsigned(costsshift_search(0, 6), 14);
  costsshift_read_words_3_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_3_memory_read_enable,
      read_address => costsshift_read_words_3_memory_read_address, read_data => costsshift_read_words(3),
      write_address => costsshift_read_words_3_memory_write_address, write_data => costsshift_read_words_3_memory_write_data);

  costsshift_read_words_2_memory_read_enable <= true;
  costsshift_read_words_2_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_2_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_2_memory_write_data <= to_unsigned(costsshift_search(0, 5), 14) & to_unsigned(costsshift_search(0, 4), 14);
  costsshift_read_words_2_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_2_memory_read_enable,
      read_address => costsshift_read_words_2_memory_read_address, read_data => costsshift_read_words(2),
      write_address => costsshift_read_words_2_memory_write_address, write_data => costsshift_read_words_2_memory_write_data);

  costsshift_read_words_1_memory_read_enable <= true;
  costsshift_read_words_1_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_1_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_1_memory_write_data <= to_unsigned(costsshift_search(0, 3), 14) & to_unsigned(costsshift_search(0, 2), 14);
  costsshift_read_words_1_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_1_memory_read_enable,
      read_address => costsshift_read_words_1_memory_read_address, read_data => costsshift_read_words(1),
      write_address => costsshift_read_words_1_memory_write_address, write_data => costsshift_read_words_1_memory_write_data);

  costsshift_read_words_0_memory_read_enable <= true;
  costsshift_read_words_0_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_0_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_0_memory_write_data <= to_unsigned(costsshift_search(0, 1), 14) & to_unsigned(costsshift_search(0, 0), 14);
  costsshift_read_words_0_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_0_memory_read_enable,
      read_address => costsshift_read_words_0_memory_read_address, read_data => costsshift_read_words(0),
      write_address => costsshift_read_words_0_memory_write_address, write_data => costsshift_read_words_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 10);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 10);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 10);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_next_frame_is_equal, transform_counter_frame_joins_choice : boolean;
    variable transform_read_column_inside_0_is_less, transform_left_filter_low_is_larger_0_0_0_value : boolean;
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
    variable delay_row_inside_1_is_not_less, delay_row_inside_1_is_less, delay_tag_map_column_is_not_less : boolean;
    variable delay_tag_map_column_is_less, delay_tag_first_column_is_equal, line_order_address_any : boolean;
    variable line_order_falls_all, line_order_turned_output_column_choice, costsshift_search_0_0_is_equal : boolean;
    variable costscolumn_pixels_first_0_count_value : boolean_2d(0 to 2, 0 to 4);  -- costscolumn_pixels_first_#_0_count_#_value
    variable costscolumn_pixels_first_0_count_value_2 : boolean_2d(0 to 2, 0 to 3);  -- costscolumn_pixels_first_#_0_count_#_value_2
    variable costscolumn_pixels_first_0_count_1_value_3 : boolean_1d(0 to 2);  -- costscolumn_pixels_first_#_0_count_1_value_3
    variable costscolumn_pixels_first_0_count_3_value_3 : boolean_1d(0 to 2);  -- costscolumn_pixels_first_#_0_count_3_value_3
    variable costswindow_partial_0_any, pathsleft_read_count_phase_is_equal : boolean;
    variable pathsleft_stay_value : boolean_1d(0 to 3);  -- pathsleft_stay_#_value
    variable pathsleft_stay_0_is_equal : boolean;
    variable pathsleft_stay_choice : boolean_1d(0 to 7);  -- pathsleft_stay_#_choice
    variable pathsleft_stay_choices : boolean_2d(0 to 7, 2 to 15);  -- pathsleft_stay_#_choice_#
    variable pathsleft_stay_value_2 : boolean_1d(0 to 3);  -- pathsleft_stay_#_value_2
    variable pathsleft_stay_0_values : boolean_1d(3 to 4);  -- pathsleft_stay_0_value_#
    variable pathsleft_stay_0_values_from_5 : boolean_1d(5 to 10);  -- pathsleft_stay_0_value_#
    variable pathsleft_stay_values : boolean_1d(5 to 7);  -- pathsleft_stay_#_value
    variable pathsleft_stay_value_2s : boolean_1d(5 to 7);  -- pathsleft_stay_#_value_2
    variable pathsleft_cost_0_any, pathsabove_ready_top_choice, pathsabove_ready_top_choice_2 : boolean;
    variable pathsabove_count_phase_is_equal : boolean;
    variable pathsabove_memory_write_words_0_is_less : boolean_1d(0 to 1);  -- pathsabove_memory_write_words_0_#_is_less
    variable pathsabove_memory_write_words_0_0_choice_4 : boolean;
    variable pathsabove_memory_write_words_0_all : boolean_1d(0 to 1);  -- pathsabove_memory_write_words_#_0_all
    variable pathsturn_sum_memory_write_words_0_all : boolean_1d(0 to 1);  -- pathsturn_sum_memory_write_words_#_0_all
    variable pathsturn_cost_memory_write_words_0_all : boolean_1d(0 to 1);  -- pathsturn_cost_memory_write_words_#_0_all
    variable pathsright_stay_value : boolean_1d(0 to 3);  -- pathsright_stay_#_value
    variable pathsright_stay_0_is_equal : boolean;
    variable pathsright_stay_choice : boolean_1d(0 to 7);  -- pathsright_stay_#_choice
    variable pathsright_stay_choices : boolean_2d(0 to 7, 2 to 15);  -- pathsright_stay_#_choice_#
    variable pathsright_stay_value_2 : boolean_1d(0 to 3);  -- pathsright_stay_#_value_2
    variable pathsright_stay_0_values : boolean_1d(3 to 4);  -- pathsright_stay_0_value_#
    variable pathsright_stay_0_values_from_5 : boolean_1d(5 to 10);  -- pathsright_stay_0_value_#
    variable pathsright_stay_values : boolean_1d(5 to 7);  -- pathsright_stay_#_value
    variable pathsright_stay_value_2s : boolean_1d(5 to 7);  -- pathsright_stay_#_value_2
    variable winnerswinner1_best_index_0_value : boolean_1d(0 to 3);  -- winnerswinner1_best_index_0_#_value
    variable winnerswinner1_best_index_0_values : boolean_2d(0 to 3, 2 to 7);  -- winnerswinner1_best_index_0_#_value_#
    variable winnerswinner1_best_index_0_choice : boolean_1d(0 to 3);  -- winnerswinner1_best_index_0_#_choice
    variable winnerswinner1_best_index_0_choices : boolean_2d(0 to 3, 2 to 8);  -- winnerswinner1_best_index_0_#_choice_#
    variable winnerswinner2_best_index_0_choice : boolean_1d(0 to 1);  -- winnerswinner2_best_index_0_#_choice
    variable winnerswinner2_best_index_0_choices : boolean_2d(0 to 1, 2 to 8);  -- winnerswinner2_best_index_0_#_choice_#
    variable winnerswinner2_best_index_0_value : boolean_1d(0 to 1);  -- winnerswinner2_best_index_0_#_value
    variable winnerswinner2_best_index_0_values : boolean_2d(0 to 1, 2 to 5);  -- winnerswinner2_best_index_0_#_value_#
    variable winnerswinner2_best_below_0_is_equal : boolean_1d(0 to 1);  -- winnerswinner2_best_below_0_#_is_equal
    variable winnerswinner2_best_at_start_0_choice : boolean_1d(0 to 1);  -- winnerswinner2_best_at_start_0_#_choice
    variable winnerswinner3_best_index_0_0_choice : boolean;
    variable winnerswinner3_best_index_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner3_best_index_0_0_choice_#
    variable winnerswinner3_best_index_0_0_value : boolean;
    variable winnerswinner3_best_index_0_0_values : boolean_1d(2 to 5);  -- winnerswinner3_best_index_0_0_value_#
    variable winnerswinner3_best_below_0_0_is_equal, winnerswinner3_best_above_0_0_is_equal : boolean;
    variable winnerswinner3_best_at_start_0_0_choice, winners_best_index_0_0_is_less : boolean;
    variable winners_best_below_0_0_is_equal, winners_best_above_0_0_is_equal, other_0_is_equal, other_12_any : boolean;
    variable other_choice : boolean_1d(12 to 13);  -- other_#_choice
    variable other_12_choices : boolean_1d(2 to 9);  -- other_12_choice_#
    variable other_value : boolean_1d(12 to 13);  -- other_#_value
    variable other_12_values : boolean_1d(2 to 5);  -- other_12_value_#
    variable other_all : boolean_1d(12 to 13);  -- other_#_all
    variable other_12_choices_from_12 : boolean_1d(12 to 20);  -- other_12_choice_#
    variable other_12_values_from_7 : boolean_1d(7 to 21);  -- other_12_value_#
    variable other_12_alls : boolean_1d(2 to 3);  -- other_12_all_#
    variable other_12_choices_from_23 : boolean_1d(23 to 31);  -- other_12_choice_#
    variable other_12_choices_from_34 : boolean_1d(34 to 42);  -- other_12_choice_#
    variable other_12_differs : boolean;
    variable other_13_choices : boolean_1d(2 to 9);  -- other_13_choice_#
    variable other_13_values : boolean_1d(2 to 20);  -- other_13_value_#
    variable other_13_choices_from_12 : boolean_1d(12 to 19);  -- other_13_choice_#
    variable other_13_alls : boolean_1d(2 to 4);  -- other_13_all_#
    variable other_13_choices_from_22 : boolean_1d(22 to 30);  -- other_13_choice_#
    variable other_13_choices_from_33 : boolean_1d(33 to 41);  -- other_13_choice_#
    variable refinement_below_0_differs, refinement_divisor_0_0_is_less, leftright_holds_winners_choice : boolean;
    variable turn_order_address_any, turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_ready_tag_row_start_differs, turn_ready_tag_row_start_is_equal : boolean;
    variable turn_ready_tag_row_start_choice : boolean;
    variable turn_ready_tag_row_start_choices : boolean_1d(2 to 3);  -- turn_ready_tag_row_start_choice_#
    variable turn_ready_tag_row_start_is_equal_2, turn_ready_tag_row_start_all : boolean;
    variable turn_ready_tag_row_start_all_2, support_newest_0_value, support_moment_0_start_of_frame_choice : boolean;
    variable support_next_tag_choice, support_next_tag_choice_2 : boolean;
    variable support_like_0_0_choice : boolean_1d(0 to 2);  -- support_like_0_#_0_choice
    variable support_like_0_1_differs : boolean_1d(0 to 2);  -- support_like_0_#_1_differs
    variable support_like_0_0_choices : boolean_1d(4 to 6);  -- support_like_0_#_0_choice
    variable support_like_0_1_differss : boolean_1d(4 to 6);  -- support_like_0_#_1_differs
    variable support_out_tag_row_start_differs, support_out_tag_row_start_is_equal : boolean;
    variable support_out_tag_row_start_choice : boolean;
    variable support_out_tag_row_start_choices : boolean_1d(2 to 3);  -- support_out_tag_row_start_choice_#
    variable support_out_tag_row_start_is_equal_2, support_out_tag_row_start_all : boolean;
    variable support_out_tag_row_start_all_2, fill_ends_read_place_0_choice, fill_out_disparity_0_all : boolean;
    variable fill_out_disparity_0_all_2, fill_out_filled_0_is_equal, fill_out_filled_0_choice : boolean;
    variable fill_out_tag_row_start_differs, fill_out_tag_row_start_is_equal, fill_out_tag_row_start_choice : boolean;
    variable fill_out_tag_row_start_choices : boolean_1d(2 to 3);  -- fill_out_tag_row_start_choice_#
    variable fill_out_tag_row_start_is_equal_2, fill_out_tag_row_start_all, fill_out_tag_row_start_all_2 : boolean;
    variable fill_ends_next_place_0_choice, fill_ends_next_place_0_choice_2, fill_ends_row_place_0_all : boolean;
    variable fill_beside_0_left_any, median_counter_group_is_equal, median_line_ended_choice : boolean;
    variable median_window_complete_is_equal, median_window_complete_choice : boolean;
    variable median_low_0_all : boolean_1d(0 to 1);  -- median_low_#_0_all
    variable relief_newest_choice : boolean;
    variable relief_newest_choices : boolean_1d(2 to 15);  -- relief_newest_choice_#
    variable relief_newest_value : boolean;
    variable relief_newest_values : boolean_1d(2 to 5);  -- relief_newest_value_#
    variable transform_counter_group_after_choice, raster_place_group_after_choice : natural range 0 to 511;
    variable winners_best_cost_0_0_choice : natural range 0 to 511;
    variable support_counter_group_choices : natural_511_1d(2 to 3);  -- support_counter_group_choice_#
    variable fill_counter_group_choices : natural_511_1d(2 to 3);  -- fill_counter_group_choice_#
    variable fill_ends_read_place_0_choices : natural_511_1d(2 to 3);  -- fill_ends_read_place_0_choice_#
    variable fill_takes_left_0_choice : natural range 0 to 511;
    variable median_counter_group_choices : natural_511_1d(2 to 3);  -- median_counter_group_choice_#
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 15;
    variable support_counter_group_choice, fill_counter_group_choice : natural range 0 to 15;
    variable median_counter_group_choice : natural range 0 to 15;
    variable line_order_address_choice, turn_order_address_choice : natural range 1 to 1023;
    variable line_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 637;
    variable costsshift_count_phase_choice, costswindow_read_count_phase_choice : natural range 0 to 7;
    variable costswindow_write_count_phase_choice, pathsleft_read_count_phase_choice : natural range 0 to 7;
    variable pathsleft_ahead_count_phase_choice : natural range 0 to 7;
    variable pathsleft_stay_change_value : natural_7_1d(1 to 6);  -- pathsleft_stay_change_#_value
    variable pathsleft_write_count_phase_choice, pathsabove_read_address_count_phase_choice : natural range 0 to 7;
    variable pathsabove_count_phase_choice, pathsabove_write_address_count_phase_choice : natural range 0 to 7;
    variable pathsturn_read_address_count_phase_choice : natural range 0 to 7;
    variable pathsturn_write_address_count_phase_choice : natural range 0 to 7;
    variable pathsright_stay_change_value : natural_7_1d(1 to 4);  -- pathsright_stay_change_#_value
    variable pathsright_stay_change_5_sum, pathsright_stay_change_6_value : natural range 0 to 7;
    variable other_read_count_phase_choice, other_count_phase_choice : natural range 0 to 7;
    variable other_write_count_phase_choice, other_4_choice_2 : natural range 0 to 7;
    variable costsmask_column_sum, winnersmask_column_sum, winners_partner_at_sum : natural range 1 to 1024;
    variable costsmask_column_choice, pathsabove_memory_read_address_1_choice : natural range 0 to 1023;
    variable winnersmask_column_choice, fill_takes_left_0_choice_2 : natural range 0 to 1023;
    variable fill_out_disparity_0_choice : natural range 0 to 1023;
    variable costsmask_partner_choice, winnersmask_partner_choice, winners_partner_at_choice : natural range 0 to 1024;
    variable costs_cost_choice : natural_21_1d(0 to 7);  -- costs_cost_#_choice
    variable paths_smallest_cost_choice : natural range 0 to 21;
    variable pathsleft_stay_choice_16 : natural_127_1d(0 to 7);  -- pathsleft_stay_#_choice_16
    variable pathsleft_stay_values_from_1 : natural_127_2d(1 to 2, 3 to 4);  -- pathsleft_stay_#_value_#
    variable pathsleft_stay_values_from_5 : natural_127_2d(5 to 6, 3 to 4);  -- pathsleft_stay_#_value_#
    variable pathsleft_step_choice : natural_127_1d(0 to 7);  -- pathsleft_step_#_choice
    variable pathsleft_step_0_choice_2, pathsleft_step_7_choice_2, pathsleft_low_0_choice : natural range 0 to 127;
    variable pathsright_stay_choice_16 : natural_127_1d(0 to 7);  -- pathsright_stay_#_choice_16
    variable pathsright_stay_values_from_1 : natural_127_2d(1 to 2, 3 to 4);  -- pathsright_stay_#_value_#
    variable pathsright_stay_values_from_5 : natural_127_2d(5 to 6, 3 to 4);  -- pathsright_stay_#_value_#
    variable pathsright_step_choice : natural_127_1d(0 to 7);  -- pathsright_step_#_choice
    variable pathsright_step_0_choice_2, pathsright_step_7_choice_2, pathsright_low_0_choice : natural range 0 to 127;
    variable support_like_0_value : natural_127_2d(0 to 6, 0 to 4);  -- support_like_0_#_#_value
    variable pathsleft_q_choice, pathsleft_q_choice_2, pathsleft_room_left_choice : natural range 0 to 63;
    variable pathsright_q_choice, pathsright_q_choice_2, pathsright_room_left_choice : natural range 0 to 63;
    variable pathsabove_memory_read_address_0_sum : natural range 1 to 8192;
    variable pathsabove_memory_read_address_0_choice, median_of_column_0_a_choice : natural range 0 to 4095;
    variable pathsabove_memory_read_address_0_sum_2, pathsturn_cost_memory_read_address_0_sum : natural range 0 to 8192;
    variable pathsabove_memory_bank_choice, pathsabove_memory_bank_choice_2 : natural range 0 to 8191;
    variable pathsabove_write_address_address_choice, pathsturn_cost_memory_bank_choice : natural range 0 to 8191;
    variable pathsabove_total_choice : natural_31_1d(0 to 7);  -- pathsabove_total_#_choice
    variable pathsabove_beside_0_choice, pathsabove_beside_7_choice : natural range 0 to 31;
    variable pathsabove_memory_write_words_0_choice : natural_31_1d(0 to 2);  -- pathsabove_memory_write_words_0_#_choice
    variable pathsabove_memory_write_words_0_choice_2 : natural_31_1d(0 to 2);  -- pathsabove_memory_write_words_0_#_choice_2
    variable pathsabove_memory_write_words_0_choice_3 : natural_31_1d(0 to 1);  -- pathsabove_memory_write_words_0_#_choice_3
    variable other_base_choice, relief_newest_choice_16 : natural range 0 to 31;
    variable pathsabove_smallest_total_choice : natural range 0 to 52;
    variable pathsabove_memory_write_words_0_sum : natural_65535_1d(0 to 1);  -- pathsabove_memory_write_words_0_#_sum
    variable pathsturn_sum_memory_write_words_0_sum_2 : natural_65535_1d(0 to 2);  -- pathsturn_sum_memory_write_words_0_#_sum_2
    variable pathsturn_cost_memory_write_words_0_0_sum, fill_write_above_0_choice : natural range 0 to 65535;
    variable pathsabove_memory_write_words_0_1_choice_4 : natural range 0 to 3;
    variable pathsabove_memory_write_words_0_2_sum, pathsturn_sum_memory_write_words_0_3_sum : natural range 0 to 255;
    variable pathsturn_cost_memory_write_words_0_1_sum : natural range 0 to 255;
    variable winnerswinner2_best_second_0_choice : natural_255_1d(0 to 1);  -- winnerswinner2_best_second_0_#_choice
    variable winnerswinner2_best_second_0_choices : natural_255_2d(0 to 1, 2 to 4);  -- winnerswinner2_best_second_0_#_choice_#
    variable winnerswinner3_best_second_0_0_choice : natural range 0 to 255;
    variable winnerswinner3_best_second_0_0_choices : natural_255_1d(2 to 4);  -- winnerswinner3_best_second_0_0_choice_#
    variable winners_best_cost_0_0_choice_2, winners_best_index_0_0_choice : natural range 0 to 255;
    variable winners_best_second_0_0_choice : natural range 0 to 255;
    variable winners_best_second_0_0_choices : natural_255_1d(2 to 7);  -- winners_best_second_0_0_choice_#
    variable other_4_choice : natural range 0 to 255;
    variable other_12_choices_from_10 : natural_255_1d(10 to 11);  -- other_12_choice_#
    variable other_12_choices_from_21 : natural_255_1d(21 to 22);  -- other_12_choice_#
    variable other_12_choices_from_32 : natural_255_1d(32 to 33);  -- other_12_choice_#
    variable other_12_choices_from_43 : natural_255_1d(43 to 44);  -- other_12_choice_#
    variable other_13_choices_from_10 : natural_255_1d(10 to 11);  -- other_13_choice_#
    variable other_13_choices_from_20 : natural_255_1d(20 to 21);  -- other_13_choice_#
    variable other_13_choices_from_31 : natural_255_1d(31 to 32);  -- other_13_choice_#
    variable other_13_choices_from_42 : natural_255_1d(42 to 43);  -- other_13_choice_#
    variable other_choices : natural_255_1d(14 to 15);  -- other_#_choice
    variable other_choices_from_14 : natural_255_2d(14 to 15, 2 to 8);  -- other_#_choice_#
    variable refinement_divisor_0_0_choice, support_out_sure_0_choice : natural range 0 to 255;
    variable relief_newest_values_from_6 : natural_255_1d(6 to 7);  -- relief_newest_value_#
    variable pathsturn_sum_memory_write_words_0_sum : natural_158_1d(0 to 2);  -- pathsturn_sum_memory_write_words_0_#_sum
    variable winnerswinner2_best_below_0_choice : natural_254_1d(0 to 1);  -- winnerswinner2_best_below_0_#_choice
    variable winnerswinner2_best_above_0_choice : natural_254_1d(0 to 1);  -- winnerswinner2_best_above_0_#_choice
    variable winnerswinner3_best_below_0_0_choice, winnerswinner3_best_above_0_0_choice : natural range 0 to 254;
    variable winners_best_below_0_0_choice, winners_best_below_0_0_choice_2 : natural range 0 to 254;
    variable winners_best_above_0_0_choice, winners_best_above_0_0_choice_2 : natural range 0 to 254;
    variable other_4_difference : integer range -15 to 0;
    variable other_4_value : natural range 0 to 16;
    variable other_difference : natural_257_to_1022_1d(5 to 10);  -- other_#_difference
    variable other_11_difference : natural range 257 to 766;
    variable other_12_value_6 : natural range 0 to 248;
    variable leftright_checked_passed_0_difference : integer range -254 to 256;
    variable support_column_choice : natural_63_to_127_1d(0 to 4);  -- support_column_#_choice
    variable support_like_0_0_0_difference : integer range -62 to 1;
    variable fill_out_disparity_0_choice_2, median_of_column_0_c_choice : natural range 0 to 32767;
    variable median_sorted_low_0_choice, median_sorted_low_0_choice_2 : natural range 0 to 32767;
    variable median_sorted_middle_0_choice, median_sorted_middle_0_choice_2 : natural range 0 to 32767;
    variable median_sorted_high_0_choice, median_sorted_high_0_choice_2 : natural range 0 to 32767;
    variable median_largest_low_0_choice, median_largest_low_0_choice_2 : natural range 0 to 32767;
    variable median_median_middle_0_choice : natural range 0 to 32767;
    variable median_median_middle_0_choices : natural_32767_1d(2 to 4);  -- median_median_middle_0_choice_#
    variable median_smallest_high_0_choice, median_smallest_high_0_choice_2 : natural range 0 to 32767;
    variable median_out_disparity_0_choice : natural range 0 to 32767;
    variable median_out_disparity_0_choices : natural_32767_1d(2 to 4);  -- median_out_disparity_0_choice_#
    variable median_low_0_0_choice, median_middle_0_0_choice, median_high_0_0_choice : natural range 0 to 32767;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_next_frame_is_equal := transform_counter_column = 639;
      if transform_counter_last_column then
        transform_counter_frame_joins_choice := (not transform_counter_back_to_back) and refinement_scaled_gap;
      else
        transform_counter_frame_joins_choice := refinement_scaled_gap;
      end if;
      if transform_counter_back_to_back then
        transform_counter_group_after_choice := 2;
      else
        transform_counter_group_after_choice := (transform_counter_group + 1) mod 512;
      end if;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
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
      transform_counter_next_frame <= transform_counter_next_frame_is_equal and (transform_counter_group = 479);
      transform_counter_last_column <= transform_counter_next_frame_is_equal;
      transform_counter_counts <= transform_counter_group /= 482;
      transform_counter_back_to_back <= (transform_counter_group = 481) and refinement_scaled_gap;
      transform_counter_next_frame_after <= 483 < transform_counter_group;
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
      transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
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
      transform_reached_first_0 <= 3 < transform_counter_group;
      transform_reached_first_2 <= 1 < transform_counter_group;
      transform_reached_first_4 <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
      transform_reached_beyond_last(2) <= 479 < transform_counter_group;
      transform_reached_beyond_last(3) <= 481 < transform_counter_group;
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
        transform_counter_frame_joins <= refinement_scaled_gap;
      end if;
      if transform_counter_last_column then
        transform_counter_column_after <= 0;
      else
        transform_counter_column_after <= (transform_counter_column + 1) mod 1024;
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
          transform_counter_group <= transform_counter_group_choice * 32;
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
      raster_place_next_frame_is_equal := raster_place_column = 639;
      if raster_place_last_column then
        raster_place_back_to_back_choice := (not raster_place_frame_joins) and transform_read_row_inside_0;
      else
        raster_place_back_to_back_choice := transform_read_row_inside_0;
      end if;
      if raster_place_frame_joins then
        raster_place_group_after_choice := 1;
      else
        raster_place_group_after_choice := (raster_place_group + 1) mod 512;
      end if;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_valid(2);
      raster_place_next_frame <= raster_place_next_frame_is_equal and (raster_place_group = 479);
      raster_place_last_column <= raster_place_next_frame_is_equal;
      raster_place_counts <= raster_place_group < 480;
      raster_place_frame_joins <= (raster_place_group = 480) and transform_read_row_inside_0;
      if delay_row_inside(2) then
        raster_place_back_to_back <= raster_place_back_to_back_choice;
      else
        raster_place_back_to_back <= transform_read_row_inside_0;
      end if;
      if raster_place_last_column then
        raster_place_column_after <= 0;
      else
        raster_place_column_after <= (raster_place_column + 1) mod 1024;
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
          raster_place_group <= raster_place_group_choice * 32;
        else
          raster_place_column <= raster_place_column_after;
          raster_place_group <= raster_place_group_after;
        end if;
      end if;
      -- delay
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 481;
      delay_tag_map_column_is_not_less := raster_place_column >= 1;
      delay_tag_map_column_is_less := raster_place_column < 639;
      delay_tag_first_column_is_equal := raster_place_column = 1;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 480;
      delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside(2) <= raster_place_group /= 481;
      delay_tag_valid <= raster_features_valid;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less and
        delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 638;
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
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside(0) <= rows_read_inside(0);
      rows_ready_inside(1) <= rows_read_inside(1);
      rows_ready_inside(2) <= rows_read_inside(2);
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
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
        line_centre_first_column_0 <= rows_tag_first_column;
        line_centre_start_of_frame_0 <= rows_tag_start_of_frame;
        line_centre_end_of_line_0 <= rows_tag_end_of_line;
        line_order_inside <= line_centre_map_column_0;
        line_newest_first_column <= line_centre_first_column_0;
        line_newest_top <= line_centre_start_of_frame_0;
      end if;
      line_order_address_any := (not line_centre_map_column_0) or line_order_inside or (not rows_tag_valid);
      if line_order_falls then
        line_order_address_choice := 1023;
      else
        line_order_address_choice := 1;
      end if;
      if line_order_falls then
        line_order_address_choice_2 := 0;
      else
        line_order_address_choice_2 := 637;
      end if;
      if not ((not line_centre_map_column_0) or (not rows_tag_valid)) then
        if line_order_address_any then
          line_order_address <= (line_order_address_choice + line_order_address) mod 1024;
        else
          line_order_address <= line_order_address_choice_2;
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
      line_order_turned_first_column <= line_order_falls_all;
      line_order_turned_start_of_frame <= line_centre_map_column_0 and (not line_order_inside) and rows_tag_valid and
        line_order_first and line_order_output and line_order_complete;
      line_order_turned_end_of_line <= line_centre_end_of_line_0;
      line_comes(1) <= line_order_turned_valid;
      for i in 2 to 33 loop
        line_comes(i) <= line_comes(i - 1);
      end loop;
      line_starts_phases(1) <= line_order_inside and line_order_turned_valid;
      for i in 2 to 33 loop
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
        line_places_first_column(0) <= line_order_turned_first_column;
        line_places_0_top <= line_newest_top;
        line_places_address(0) <= line_order_address;
        line_places_shown_output_column(0) <= line_order_turned_output_column;
        line_places_shown_first_column(0) <= line_newest_first_column;
        line_places_shown_start_of_frame(0) <= line_order_turned_start_of_frame;
        line_places_shown_end_of_line(0) <= line_order_turned_end_of_line;
      end if;
      for i in 1 to 2 loop
        if line_comes(8 * i) then
          line_places_map_column(i) <= line_places_map_column(i - 1);
          line_places_first_column(i) <= line_places_first_column(i - 1);
          line_places_address(i) <= line_places_address(i - 1);
          line_places_shown_output_column(i) <= line_places_shown_output_column(i - 1);
          line_places_shown_first_column(i) <= line_places_shown_first_column(i - 1);
          line_places_shown_start_of_frame(i) <= line_places_shown_start_of_frame(i - 1);
          line_places_shown_end_of_line(i) <= line_places_shown_end_of_line(i - 1);
        end if;
      end loop;
      for i in 3 to 4 loop
        if line_comes(8 * i) then
          line_places_map_column(i) <= line_places_map_column(i - 1);
          line_places_first_column(i) <= line_places_first_column(i - 1);
          line_places_shown_output_column(i) <= line_places_shown_output_column(i - 1);
          line_places_shown_start_of_frame(i) <= line_places_shown_start_of_frame(i - 1);
          line_places_shown_end_of_line(i) <= line_places_shown_end_of_line(i - 1);
        end if;
      end loop;
      -- costsshift
      if rows_tag_valid then
        costsshift_newest(0) <= rows_search(0);
        costsshift_newest(1) <= rows_search(1);
        costsshift_newest(2) <= rows_search(2);
        costsshift_new_reference(0) <= rows_reference(0);
        costsshift_new_reference(1) <= rows_reference(1);
        costsshift_new_reference(2) <= rows_reference(2);
      end if;
      if costsshift_count_phase = 7 then
        costsshift_count_phase_choice := 7;
      else
        costsshift_count_phase_choice := (costsshift_count_phase + 1) mod 8;
      end if;
      costsshift_new_tag_valid <= rows_tag_valid or (not is_set(costsshift_count_phase, 2)) or (not
        is_set(costsshift_count_phase, 1)) or (not is_set(costsshift_count_phase, 0));
      costsshift_handed_on(0) <= to_integer(costsshift_read_words(3)(27 downto 14));
      costsshift_handed_on(1) <= to_integer(costsshift_read_words(7)(27 downto 14));
      costsshift_handed_on(2) <= to_integer(costsshift_read_words(11)(27 downto 14));
      costsshift_read_reference(0) <= costsshift_new_reference(0);
      costsshift_read_reference(1) <= costsshift_new_reference(1);
      costsshift_read_reference(2) <= costsshift_new_reference(2);
      costsshift_read_tag_valid <= costsshift_new_tag_valid;
      costsshift_read_count_phase <= costsshift_count_phase;
      costsshift_reference(0) <= costsshift_read_reference(0);
      costsshift_reference(1) <= costsshift_read_reference(1);
      costsshift_reference(2) <= costsshift_read_reference(2);
      costsshift_write_phase <= costsshift_read_count_phase;
      if rows_tag_valid then
        costsshift_count_phase <= 0;
      else
        costsshift_count_phase <= costsshift_count_phase_choice;
      end if;
      costsshift_search_0_0_is_equal := costsshift_read_count_phase = 0;
      if costsshift_read_tag_valid then
        for i in 0 to 2 loop
          for j in 0 to 2 loop
            costsshift_search(i, 2 * j + 1) <= to_integer(costsshift_read_words(4 * i + j)(13 downto 0));
            costsshift_search(i, 2 * j + 2) <= to_integer(costsshift_read_words(4 * i + j)(27 downto 14));
          end loop;
          costsshift_search(i, 7) <= to_integer(costsshift_read_words(4 * i + 3)(13 downto 0));
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
        for j in 1 to 7 loop
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
      for i in 0 to 2 loop
        for j in 0 to 7 loop
          costscolumn_pixels_cost(i, j) <= costscolumn_pixels_first_count(i, j, 3) + costscolumn_pixels_first_count(i,
            j, 0) + costscolumn_pixels_first_count(i, j, 1) + costscolumn_pixels_first_count_4(i, j) +
            costscolumn_pixels_first_count(i, j, 2);
        end loop;
      end loop;
      for i in 0 to 7 loop
        costscolumn_pair_0(i) <= costscolumn_pixels_cost(1, i) + costscolumn_pixels_cost(2, i);
      end loop;
      for i in 0 to 7 loop
        costscolumn_single_0(i) <= costscolumn_pixels_cost(0, i);
      end loop;
      for i in 0 to 7 loop
        costscolumn_column_0(i) <= costscolumn_pair_0(i) + costscolumn_single_0(i);
      end loop;
      -- costswindow
      if costswindow_read_count_phase = 7 then
        costswindow_read_count_phase_choice := 7;
      else
        costswindow_read_count_phase_choice := (costswindow_read_count_phase + 1) mod 8;
      end if;
      if costswindow_write_count_phase = 7 then
        costswindow_write_count_phase_choice := 7;
      else
        costswindow_write_count_phase_choice := (costswindow_write_count_phase + 1) mod 8;
      end if;
      for i in 2 to 3 loop
        for j in 0 to 3 loop
          costswindow_sum_0(4 * i + j - 8) <= costscolumn_column_0(4 * i + j - 8) +
            to_integer(costswindow_read_wordss(i)(7 * j + 6 downto 7 * j));
        end loop;
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
      costswindow_partial_0_any := (not is_set(costswindow_write_count_phase, 2)) or (not
        is_set(costswindow_write_count_phase, 1)) or (not is_set(costswindow_write_count_phase, 0)) or line_comes(6);
      if costswindow_partial_0_any then
        for i in 0 to 7 loop
          costswindow_partial(i) <= costscolumn_column_0(i);
        end loop;
        for i in 0 to 1 loop
          for j in 8 to 11 loop
            costswindow_partials(4 * i + j) <= costscolumn_column_0(4 * i + j - 8) +
              to_integer(costswindow_read_words(i)(7 * j - 51 downto 7 * j - 56));
          end loop;
        end loop;
      end if;
      -- costsmask
      costsmask_column_sum := costsmask_column + 1;
      if line_places_shown_first_column(0) then
        costsmask_column_choice := 0;
      else
        costsmask_column_choice := costsmask_column_sum mod 1024;
      end if;
      if line_comes(5) then
        costsmask_column <= costsmask_column_choice;
      end if;
      if line_places_shown_first_column(0) then
        costsmask_partner_choice := 0;
      else
        costsmask_partner_choice := costsmask_column_sum;
      end if;
      costsmask_inside(0) <= (((((costsmask_partner / 1024) + 63) mod 64) * 1024) + (costsmask_partner mod 1024)) < 638;
      costsmask_inside(1) <= (costsmask_partner >= 1025) and (costsmask_partner < 1663);
      costsmask_inside(2) <= (((((costsmask_partner / 2) + 32255) mod 32768) * 2) + (costsmask_partner mod 2)) < 638;
      costsmask_inside(3) <= (costsmask_partner >= 1027) and (costsmask_partner < 1665);
      costsmask_inside(4) <= (((((costsmask_partner / 4) + 16127) mod 16384) * 4) + (costsmask_partner mod 4)) < 638;
      costsmask_inside(5) <= (costsmask_partner >= 1029) and (costsmask_partner < 1667);
      costsmask_inside(6) <= (((((costsmask_partner / 2) + 32253) mod 32768) * 2) + (costsmask_partner mod 2)) < 638;
      costsmask_inside(7) <= (costsmask_partner >= 1031) and (costsmask_partner < 1669);
      if line_comes(5) then
        costsmask_partner <= (((costsmask_partner_choice / 1024) + 1) * 1024) + costsmask_column_choice;
      else
        costsmask_partner <= ((((costsmask_partner / 8) + 511) mod 512) * 8) + (costsmask_partner mod 8);
      end if;
      -- costs
      for i in 0 to 7 loop
        if (not ((not is_set(costswindow_sum_0(i), 6)) and ((not is_set(costswindow_sum_0(i), 5)) or (not
          is_set(costswindow_sum_0(i), 4)) or (not is_set(costswindow_sum_0(i), 3))))) or is_set(costswindow_sum_0(i),
          7) then
          costs_cost_choice(i) := 6;
        else
          costs_cost_choice(i) := costswindow_sum_0(i) / 8;
        end if;
      end loop;
      for i in 0 to 7 loop
        if costsmask_inside(i) then
          costs_cost(i) <= costs_cost_choice(i);
        else
          costs_cost(i) <= 3;
        end if;
      end loop;
      -- paths
      if line_comes(11) then
        paths_smallest_cost_choice := 7;
      else
        paths_smallest_cost_choice := paths_smallest_cost;
      end if;
      paths_cost_delay_ring_write_address <= paths_cost_delay_ring_read_address;
      paths_sum(0) <= (pathsturn_sum_memory_ready_words(0) mod 128) + pathsright_cost(0);
      paths_sum(1) <= ((pathsturn_sum_memory_ready_words(0) / 128) mod 128) + pathsright_cost(1);
      paths_sum(2) <= ((pathsturn_sum_memory_ready_words(1) mod 32) * 4) + (pathsturn_sum_memory_ready_words(0) /
        16384) + pathsright_cost(2);
      paths_sum(3) <= ((pathsturn_sum_memory_ready_words(1) / 32) mod 128) + pathsright_cost(3);
      paths_sum(4) <= ((pathsturn_sum_memory_ready_words(2) mod 8) * 16) + (pathsturn_sum_memory_ready_words(1) / 4096)
        + pathsright_cost(4);
      paths_sum(5) <= ((pathsturn_sum_memory_ready_words(2) / 8) mod 128) + pathsright_cost(5);
      paths_sum(6) <= ((pathsturn_sum_memory_ready_words_3 mod 2) * 64) + (pathsturn_sum_memory_ready_words(2) / 1024)
        + pathsright_cost(6);
      paths_sum(7) <= (pathsturn_sum_memory_ready_words_3 / 2) + pathsright_cost(7);
      for i in 0 to 3 loop
        if (costs_cost(2 * i + 1) - costs_cost(2 * i)) < 0 then
          paths_tree_smallest(i) <= costs_cost(2 * i + 1);
        else
          paths_tree_smallest(i) <= costs_cost(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (paths_tree_smallest(2 * i + 1) - paths_tree_smallest(2 * i)) < 0 then
          paths_tree_next_smallest(i) <= paths_tree_smallest(2 * i + 1);
        else
          paths_tree_next_smallest(i) <= paths_tree_smallest(2 * i);
        end if;
      end loop;
      if (paths_tree_next_smallest(1) - paths_tree_next_smallest(0)) < 0 then
        paths_tree_next_next_smallest_0 <= paths_tree_next_smallest(1);
      else
        paths_tree_next_next_smallest_0 <= paths_tree_next_smallest(0);
      end if;
      if (paths_tree_next_next_smallest_0 - paths_smallest_cost_choice) < 0 then
        paths_smallest_cost <= paths_tree_next_next_smallest_0;
      else
        paths_smallest_cost <= paths_smallest_cost_choice;
      end if;
      if paths_cost_delay_ring_read_address = 11 then
        paths_cost_delay_ring_read_address <= 0;
      else
        paths_cost_delay_ring_read_address <= (paths_cost_delay_ring_read_address + 1) mod 16;
      end if;
      -- pathsleft
      if line_starts_phases(10) then
        pathsleft_fresh_past_newest(0) <= relief_left(1);
        pathsleft_fresh_past_newest(1) <= pathsleft_fresh_past_newest(0);
      end if;
      if line_starts_phases(11) then
        pathsleft_fresh_past_pairs(1) <= pathsleft_fresh_past_pairs(0);
        pathsleft_fresh_past_pairs(2) <= pathsleft_fresh_past_pairs(1);
        if (pathsleft_fresh_past_newest(1) - pathsleft_fresh_past_newest(0)) < 0 then
          pathsleft_fresh_past_pairs(0) <= pathsleft_fresh_past_newest(1);
        else
          pathsleft_fresh_past_pairs(0) <= pathsleft_fresh_past_newest(0);
        end if;
      end if;
      if line_starts_phases(12) then
        for i in 1 to 6 loop
          pathsleft_fresh_past_fours(i) <= pathsleft_fresh_past_fours(i - 1);
        end loop;
        if (pathsleft_fresh_past_pairs(2) - pathsleft_fresh_past_pairs(0)) < 0 then
          pathsleft_fresh_past_fours(0) <= pathsleft_fresh_past_pairs(2);
        else
          pathsleft_fresh_past_fours(0) <= pathsleft_fresh_past_pairs(0);
        end if;
      end if;
      pathsleft_read_count_phase_is_equal := pathsleft_read_count_phase = 7;
      if pathsleft_read_count_phase_is_equal then
        pathsleft_read_count_phase_choice := 7;
      else
        pathsleft_read_count_phase_choice := (pathsleft_read_count_phase + 1) mod 8;
      end if;
      if pathsleft_ahead_count_phase = 7 then
        pathsleft_ahead_count_phase_choice := 7;
      else
        pathsleft_ahead_count_phase_choice := (pathsleft_ahead_count_phase + 1) mod 8;
      end if;
      pathsleft_stay_value(0) := is_set(pathsleft_fresh_here, 1);
      pathsleft_stay_0_is_equal := (pathsleft_fresh_here mod 4) = 0;
      if pathsleft_read_words(2)(0) = '1' then
        pathsleft_stay_choice(0) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(0) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(2)(1) = '1' then
        pathsleft_stay_choices(0, 2) := (pathsleft_read_words(2)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(0, 2) := pathsleft_stay_choice(0);
      end if;
      pathsleft_stay_value_2(0) := is_set(pathsleft_fresh_here, 2);
      if pathsleft_stay_choices(0, 2) then
        pathsleft_stay_choices(0, 3) := (not (pathsleft_read_words(2)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(0, 3) := (not (pathsleft_read_words(2)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        pathsleft_stay_0_values(i) := is_set(pathsleft_fresh_here, i);
        if pathsleft_stay_choices(0, i) then
          pathsleft_stay_choices(0, i + 1) := (not (pathsleft_read_words(2)(i) = '1')) or pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(0, i + 1) := (not (pathsleft_read_words(2)(i) = '1')) and pathsleft_stay_0_values(i);
        end if;
      end loop;
      pathsleft_stay_0_values_from_5(5) := is_set(pathsleft_fresh_here, 5);
      if pathsleft_stay_choices(0, 5) then
        pathsleft_stay_choices(0, 6) := (not (pathsleft_read_words(2)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(0, 6) := (not (pathsleft_read_words(2)(5) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(0, 6) then
        pathsleft_stay_choices(0, 7) := (not (pathsleft_read_words(2)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(0, 7) := (not (pathsleft_read_words(2)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if is_set(pathsleft_fresh_here, 0) then
        pathsleft_stay_choices(0, 8) := (not (pathsleft_read_words(0)(1) = '1')) or (not (pathsleft_read_words(0)(0) =
          '1'));
      else
        pathsleft_stay_choices(0, 8) := not (pathsleft_read_words(0)(1) = '1');
      end if;
      if pathsleft_stay_value(0) then
        pathsleft_stay_choices(0, 9) := pathsleft_stay_choices(0, 8);
      else
        pathsleft_stay_choices(0, 9) := is_set(pathsleft_fresh_here, 0) and (to_integer(pathsleft_read_words(0)(1
          downto 0)) = 0);
      end if;
      pathsleft_stay_0_values_from_5(6) := pathsleft_read_words(0)(2) = '1';
      if pathsleft_stay_choices(0, 9) then
        pathsleft_stay_choices(0, 10) := (not pathsleft_stay_value_2(0)) and pathsleft_stay_0_values_from_5(6);
      else
        pathsleft_stay_choices(0, 10) := (not pathsleft_stay_value_2(0)) or pathsleft_stay_0_values_from_5(6);
      end if;
      for i in 7 to 8 loop
        pathsleft_stay_0_values_from_5(i) := pathsleft_read_words(0)(i - 4) = '1';
        if pathsleft_stay_choices(0, i + 3) then
          pathsleft_stay_choices(0, i + 4) := (not pathsleft_stay_0_values(i - 4)) or pathsleft_stay_0_values_from_5(i);
        else
          pathsleft_stay_choices(0, i + 4) := (not pathsleft_stay_0_values(i - 4)) and
            pathsleft_stay_0_values_from_5(i);
        end if;
      end loop;
      pathsleft_stay_0_values_from_5(9) := pathsleft_read_words(0)(5) = '1';
      if pathsleft_stay_choices(0, 12) then
        pathsleft_stay_choices(0, 13) := (not pathsleft_stay_0_values_from_5(5)) or pathsleft_stay_0_values_from_5(9);
      else
        pathsleft_stay_choices(0, 13) := (not pathsleft_stay_0_values_from_5(5)) and pathsleft_stay_0_values_from_5(9);
      end if;
      pathsleft_stay_0_values_from_5(10) := pathsleft_read_words(0)(6) = '1';
      if pathsleft_stay_choices(0, 13) then
        pathsleft_stay_choices(0, 14) := (not is_set(pathsleft_fresh_here, 6)) or pathsleft_stay_0_values_from_5(10);
      else
        pathsleft_stay_choices(0, 14) := (not is_set(pathsleft_fresh_here, 6)) and pathsleft_stay_0_values_from_5(10);
      end if;
      if pathsleft_stay_choices(0, 7) then
        pathsleft_stay_choices(0, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(0, 15) := (not pathsleft_stay_choices(0, 14)) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words(2)(6 downto 0)) - to_integer(pathsleft_read_words(0)(6 downto 0))) < 0 then
        pathsleft_stay_choice_16(0) := to_integer(pathsleft_read_words(2)(6 downto 0));
      else
        pathsleft_stay_choice_16(0) := to_integer(pathsleft_read_words(0)(6 downto 0));
      end if;
      for i in 1 to 2 loop
        pathsleft_stay_value(i) := pathsleft_read_words(2)(7 * i) = '1';
        if pathsleft_stay_value(i) then
          pathsleft_stay_choice(i) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choice(i) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(2)(7 * i + 1) = '1' then
          pathsleft_stay_choices(i, 2) := pathsleft_stay_value(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 2) := pathsleft_stay_choice(i);
        end if;
        if pathsleft_stay_choices(i, 2) then
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(2)(7 * i + 2) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(2)(7 * i + 2) = '1')) or pathsleft_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(2)(7 * i + j) = '1')) or
              pathsleft_stay_0_values(j);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(2)(7 * i + j) = '1')) and
              pathsleft_stay_0_values(j);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 5) then
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(2)(7 * i + 5) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(2)(7 * i + 5) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 6) then
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(2)(7 * i + 6) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(2)(7 * i + 6) = '1')) and
            is_set(pathsleft_fresh_here, 6);
        end if;
        pathsleft_stay_value_2(i) := pathsleft_read_words(0)(7 * i) = '1';
        if pathsleft_stay_value_2(i) then
          pathsleft_stay_choices(i, 8) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choices(i, 8) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(0)(7 * i + 1) = '1' then
          pathsleft_stay_choices(i, 9) := pathsleft_stay_value_2(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 9) := pathsleft_stay_choices(i, 8);
        end if;
        if pathsleft_stay_choices(i, 9) then
          pathsleft_stay_choices(i, 10) := (not (pathsleft_read_words(0)(7 * i + 2) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 10) := (not (pathsleft_read_words(0)(7 * i + 2) = '1')) or
            pathsleft_stay_value_2(0);
        end if;
        for j in 10 to 11 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(0)(7 * i + j - 7) = '1')) or
              pathsleft_stay_0_values(j - 7);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(0)(7 * i + j - 7) = '1')) and
              pathsleft_stay_0_values(j - 7);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 12) then
          pathsleft_stay_choices(i, 13) := (not (pathsleft_read_words(0)(7 * i + 5) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 13) := (not (pathsleft_read_words(0)(7 * i + 5) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 13) then
          pathsleft_stay_choices(i, 14) := (not (pathsleft_read_words(0)(7 * i + 6) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 14) := (not (pathsleft_read_words(0)(7 * i + 6) = '1')) and
            is_set(pathsleft_fresh_here, 6);
        end if;
        if pathsleft_stay_choices(i, 7) then
          pathsleft_stay_choices(i, 15) := not pathsleft_first;
        else
          pathsleft_stay_choices(i, 15) := pathsleft_stay_choices(i, 14) and (not pathsleft_first);
        end if;
        pathsleft_stay_values_from_1(i, 3) := to_integer(pathsleft_read_words(2)(7 * i + 6 downto 7 * i));
        pathsleft_stay_values_from_1(i, 4) := to_integer(pathsleft_read_words(0)(7 * i + 6 downto 7 * i));
        if (pathsleft_stay_values_from_1(i, 3) - pathsleft_stay_values_from_1(i, 4)) < 0 then
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_from_1(i, 3);
        else
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_from_1(i, 4);
        end if;
      end loop;
      pathsleft_stay_value(3) := pathsleft_read_words(2)(21) = '1';
      if pathsleft_stay_value(3) then
        pathsleft_stay_choice(3) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(3) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(2)(22) = '1' then
        pathsleft_stay_choices(3, 2) := pathsleft_stay_value(3) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(3, 2) := pathsleft_stay_choice(3);
      end if;
      if pathsleft_stay_choices(3, 2) then
        pathsleft_stay_choices(3, 3) := (not (pathsleft_read_words(2)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(3, 3) := (not (pathsleft_read_words(2)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(3, i) then
          pathsleft_stay_choices(3, i + 1) := (not (pathsleft_read_words(2)(i + 21) = '1')) or
            pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(3, i + 1) := (not (pathsleft_read_words(2)(i + 21) = '1')) and
            pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(3, 5) then
        pathsleft_stay_choices(3, 6) := (not (pathsleft_read_words(2)(26) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(3, 6) := (not (pathsleft_read_words(2)(26) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(3, 6) then
        pathsleft_stay_choices(3, 7) := (not (pathsleft_read_words(2)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(3, 7) := (not (pathsleft_read_words(2)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      pathsleft_stay_value_2(3) := pathsleft_read_words(0)(21) = '1';
      if pathsleft_stay_value_2(3) then
        pathsleft_stay_choices(3, 8) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choices(3, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(0)(22) = '1' then
        pathsleft_stay_choices(3, 9) := pathsleft_stay_value_2(3) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(3, 9) := pathsleft_stay_choices(3, 8);
      end if;
      if pathsleft_stay_choices(3, 9) then
        pathsleft_stay_choices(3, 10) := (not (pathsleft_read_words(0)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(3, 10) := (not (pathsleft_read_words(0)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsleft_stay_choices(3, i) then
          pathsleft_stay_choices(3, i + 1) := (not (pathsleft_read_words(0)(i + 14) = '1')) or
            pathsleft_stay_0_values(i - 7);
        else
          pathsleft_stay_choices(3, i + 1) := (not (pathsleft_read_words(0)(i + 14) = '1')) and
            pathsleft_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsleft_stay_choices(3, 12) then
        pathsleft_stay_choices(3, 13) := (not (pathsleft_read_words(0)(26) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(3, 13) := (not (pathsleft_read_words(0)(26) = '1')) and
          pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(3, 13) then
        pathsleft_stay_choices(3, 14) := (not (pathsleft_read_words(0)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(3, 14) := (not (pathsleft_read_words(0)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(3, 7) then
        pathsleft_stay_choices(3, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(3, 15) := pathsleft_stay_choices(3, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words(2)(27 downto 21)) - to_integer(pathsleft_read_words(0)(27 downto 21))) < 0
        then
        pathsleft_stay_choice_16(3) := to_integer(pathsleft_read_words(2)(27 downto 21));
      else
        pathsleft_stay_choice_16(3) := to_integer(pathsleft_read_words(0)(27 downto 21));
      end if;
      if pathsleft_read_words(3)(0) = '1' then
        pathsleft_stay_choice(4) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(4) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(3)(1) = '1' then
        pathsleft_stay_choices(4, 2) := (pathsleft_read_words(3)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(4, 2) := pathsleft_stay_choice(4);
      end if;
      if pathsleft_stay_choices(4, 2) then
        pathsleft_stay_choices(4, 3) := (not (pathsleft_read_words(3)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(4, 3) := (not (pathsleft_read_words(3)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(4, i) then
          pathsleft_stay_choices(4, i + 1) := (not (pathsleft_read_words(3)(i) = '1')) or pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(4, i + 1) := (not (pathsleft_read_words(3)(i) = '1')) and pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(4, 5) then
        pathsleft_stay_choices(4, 6) := (not (pathsleft_read_words(3)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(4, 6) := (not (pathsleft_read_words(3)(5) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(4, 6) then
        pathsleft_stay_choices(4, 7) := (not (pathsleft_read_words(3)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(4, 7) := (not (pathsleft_read_words(3)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_read_words(1)(0) = '1' then
        pathsleft_stay_choices(4, 8) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choices(4, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(1)(1) = '1' then
        pathsleft_stay_choices(4, 9) := (pathsleft_read_words(1)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(4, 9) := pathsleft_stay_choices(4, 8);
      end if;
      if pathsleft_stay_choices(4, 9) then
        pathsleft_stay_choices(4, 10) := (not (pathsleft_read_words(1)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(4, 10) := (not (pathsleft_read_words(1)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsleft_stay_choices(4, i) then
          pathsleft_stay_choices(4, i + 1) := (not (pathsleft_read_words(1)(i - 7) = '1')) or pathsleft_stay_0_values(i
            - 7);
        else
          pathsleft_stay_choices(4, i + 1) := (not (pathsleft_read_words(1)(i - 7) = '1')) and
            pathsleft_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsleft_stay_choices(4, 12) then
        pathsleft_stay_choices(4, 13) := (not (pathsleft_read_words(1)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(4, 13) := (not (pathsleft_read_words(1)(5) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(4, 13) then
        pathsleft_stay_choices(4, 14) := (not (pathsleft_read_words(1)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(4, 14) := (not (pathsleft_read_words(1)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(4, 7) then
        pathsleft_stay_choices(4, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(4, 15) := pathsleft_stay_choices(4, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words(3)(6 downto 0)) - to_integer(pathsleft_read_words(1)(6 downto 0))) < 0 then
        pathsleft_stay_choice_16(4) := to_integer(pathsleft_read_words(3)(6 downto 0));
      else
        pathsleft_stay_choice_16(4) := to_integer(pathsleft_read_words(1)(6 downto 0));
      end if;
      for i in 5 to 6 loop
        pathsleft_stay_values(i) := pathsleft_read_words(3)(7 * i - 28) = '1';
        if pathsleft_stay_values(i) then
          pathsleft_stay_choice(i) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choice(i) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(3)(7 * i - 27) = '1' then
          pathsleft_stay_choices(i, 2) := pathsleft_stay_values(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 2) := pathsleft_stay_choice(i);
        end if;
        if pathsleft_stay_choices(i, 2) then
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(3)(7 * i - 26) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(3)(7 * i - 26) = '1')) or
            pathsleft_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(3)(7 * i + j - 28) = '1')) or
              pathsleft_stay_0_values(j);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(3)(7 * i + j - 28) = '1')) and
              pathsleft_stay_0_values(j);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 5) then
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(3)(7 * i - 23) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(3)(7 * i - 23) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 6) then
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(3)(7 * i - 22) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(3)(7 * i - 22) = '1')) and
            is_set(pathsleft_fresh_here, 6);
        end if;
        pathsleft_stay_value_2s(i) := pathsleft_read_words(1)(7 * i - 28) = '1';
        if pathsleft_stay_value_2s(i) then
          pathsleft_stay_choices(i, 8) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choices(i, 8) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(1)(7 * i - 27) = '1' then
          pathsleft_stay_choices(i, 9) := pathsleft_stay_value_2s(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 9) := pathsleft_stay_choices(i, 8);
        end if;
        if pathsleft_stay_choices(i, 9) then
          pathsleft_stay_choices(i, 10) := (not (pathsleft_read_words(1)(7 * i - 26) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 10) := (not (pathsleft_read_words(1)(7 * i - 26) = '1')) or
            pathsleft_stay_value_2(0);
        end if;
        for j in 10 to 11 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(1)(7 * i + j - 35) = '1')) or
              pathsleft_stay_0_values(j - 7);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(1)(7 * i + j - 35) = '1')) and
              pathsleft_stay_0_values(j - 7);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 12) then
          pathsleft_stay_choices(i, 13) := (not (pathsleft_read_words(1)(7 * i - 23) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 13) := (not (pathsleft_read_words(1)(7 * i - 23) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 13) then
          pathsleft_stay_choices(i, 14) := (not (pathsleft_read_words(1)(7 * i - 22) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 14) := (not (pathsleft_read_words(1)(7 * i - 22) = '1')) and
            is_set(pathsleft_fresh_here, 6);
        end if;
        if pathsleft_stay_choices(i, 7) then
          pathsleft_stay_choices(i, 15) := not pathsleft_first;
        else
          pathsleft_stay_choices(i, 15) := pathsleft_stay_choices(i, 14) and (not pathsleft_first);
        end if;
        pathsleft_stay_values_from_5(i, 3) := to_integer(pathsleft_read_words(3)(7 * i - 22 downto 7 * i - 28));
        pathsleft_stay_values_from_5(i, 4) := to_integer(pathsleft_read_words(1)(7 * i - 22 downto 7 * i - 28));
        if (pathsleft_stay_values_from_5(i, 3) - pathsleft_stay_values_from_5(i, 4)) < 0 then
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_from_5(i, 3);
        else
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_from_5(i, 4);
        end if;
      end loop;
      pathsleft_stay_values(7) := pathsleft_read_words(3)(21) = '1';
      if pathsleft_stay_values(7) then
        pathsleft_stay_choice(7) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(7) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(3)(22) = '1' then
        pathsleft_stay_choices(7, 2) := pathsleft_stay_values(7) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(7, 2) := pathsleft_stay_choice(7);
      end if;
      if pathsleft_stay_choices(7, 2) then
        pathsleft_stay_choices(7, 3) := (not (pathsleft_read_words(3)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(7, 3) := (not (pathsleft_read_words(3)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(7, i) then
          pathsleft_stay_choices(7, i + 1) := (not (pathsleft_read_words(3)(i + 21) = '1')) or
            pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(7, i + 1) := (not (pathsleft_read_words(3)(i + 21) = '1')) and
            pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(7, 5) then
        pathsleft_stay_choices(7, 6) := (not (pathsleft_read_words(3)(26) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(7, 6) := (not (pathsleft_read_words(3)(26) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(7, 6) then
        pathsleft_stay_choices(7, 7) := (not (pathsleft_read_words(3)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(7, 7) := (not (pathsleft_read_words(3)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      pathsleft_stay_value_2s(7) := pathsleft_read_words(1)(21) = '1';
      if pathsleft_stay_value_2s(7) then
        pathsleft_stay_choices(7, 8) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choices(7, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(1)(22) = '1' then
        pathsleft_stay_choices(7, 9) := pathsleft_stay_value_2s(7) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(7, 9) := pathsleft_stay_choices(7, 8);
      end if;
      if pathsleft_stay_choices(7, 9) then
        pathsleft_stay_choices(7, 10) := (not (pathsleft_read_words(1)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(7, 10) := (not (pathsleft_read_words(1)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsleft_stay_choices(7, i) then
          pathsleft_stay_choices(7, i + 1) := (not (pathsleft_read_words(1)(i + 14) = '1')) or
            pathsleft_stay_0_values(i - 7);
        else
          pathsleft_stay_choices(7, i + 1) := (not (pathsleft_read_words(1)(i + 14) = '1')) and
            pathsleft_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsleft_stay_choices(7, 12) then
        pathsleft_stay_choices(7, 13) := (not (pathsleft_read_words(1)(26) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(7, 13) := (not (pathsleft_read_words(1)(26) = '1')) and
          pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(7, 13) then
        pathsleft_stay_choices(7, 14) := (not (pathsleft_read_words(1)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(7, 14) := (not (pathsleft_read_words(1)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(7, 7) then
        pathsleft_stay_choices(7, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(7, 15) := pathsleft_stay_choices(7, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words(3)(27 downto 21)) - to_integer(pathsleft_read_words(1)(27 downto 21))) < 0
        then
        pathsleft_stay_choice_16(7) := to_integer(pathsleft_read_words(3)(27 downto 21));
      else
        pathsleft_stay_choice_16(7) := to_integer(pathsleft_read_words(1)(27 downto 21));
      end if;
      if pathsleft_is_first then
        pathsleft_step_choice(0) := pathsleft_stay_values_from_1(1, 4);
      else
        pathsleft_step_choice(0) := pathsleft_lower_neighbour;
      end if;
      if (pathsleft_stay_values_from_1(1, 4) - pathsleft_step_choice(0)) < 0 then
        pathsleft_step_0_choice_2 := pathsleft_stay_values_from_1(1, 4);
      else
        pathsleft_step_0_choice_2 := pathsleft_step_choice(0);
      end if;
      if (pathsleft_stay_values_from_1(2, 4) - to_integer(pathsleft_read_words(0)(6 downto 0))) < 0 then
        pathsleft_step_choice(1) := pathsleft_stay_values_from_1(2, 4);
      else
        pathsleft_step_choice(1) := to_integer(pathsleft_read_words(0)(6 downto 0));
      end if;
      for i in 0 to 1 loop
        if (to_integer(pathsleft_read_words(i)(27 - 21 * i downto 21 - 21 * i)) - pathsleft_stay_values_from_1(i + 1,
          4)) < 0 then
          pathsleft_step_choice(i + 2) := to_integer(pathsleft_read_words(i)(27 - 21 * i downto 21 - 21 * i));
        else
          pathsleft_step_choice(i + 2) := pathsleft_stay_values_from_1(i + 1, 4);
        end if;
      end loop;
      for i in 5 to 6 loop
        if (pathsleft_stay_values_from_5(i, 4) - to_integer(pathsleft_read_words(i - 5)(132 - 21 * i downto 126 - 21 *
          i))) < 0 then
          pathsleft_step_choice(i - 1) := pathsleft_stay_values_from_5(i, 4);
        else
          pathsleft_step_choice(i - 1) := to_integer(pathsleft_read_words(i - 5)(132 - 21 * i downto 126 - 21 * i));
        end if;
      end loop;
      if (to_integer(pathsleft_read_words(1)(27 downto 21)) - pathsleft_stay_values_from_5(5, 4)) < 0 then
        pathsleft_step_choice(6) := to_integer(pathsleft_read_words(1)(27 downto 21));
      else
        pathsleft_step_choice(6) := pathsleft_stay_values_from_5(5, 4);
      end if;
      if pathsleft_is_last then
        pathsleft_step_choice(7) := pathsleft_stay_values_from_5(6, 4);
      else
        pathsleft_step_choice(7) := to_integer(pathsleft_read_neighbour_0);
      end if;
      if (pathsleft_step_choice(7) - pathsleft_stay_values_from_5(6, 4)) < 0 then
        pathsleft_step_7_choice_2 := pathsleft_step_choice(7);
      else
        pathsleft_step_7_choice_2 := pathsleft_stay_values_from_5(6, 4);
      end if;
      pathsleft_stay_change_value(1) := to_integer(paths_cost_delay_held_0(5 downto 0)) / 8;
      for i in 2 to 6 loop
        pathsleft_stay_change_value(i) := to_integer(paths_cost_delay_held_0(3 * i + 2 downto 3 * i));
      end loop;
      if pathsleft_write_count_phase = 7 then
        pathsleft_write_count_phase_choice := 7;
      else
        pathsleft_write_count_phase_choice := (pathsleft_write_count_phase + 1) mod 8;
      end if;
      if line_comes(25) then
        pathsleft_low_0_choice := 127;
      else
        pathsleft_low_0_choice := pathsleft_low_0;
      end if;
      pathsleft_fresh_past_oldest <= pathsleft_fresh_past_fours(6);
      pathsleft_lost <= is_set(pathsleft_fresh_known, 6);
      pathsleft_short_of <= (((pathsleft_fresh_known mod 64) + pathsleft_room) / 64) = 1;
      pathsleft_missing <= (pathsleft_fresh_known + pathsleft_room) mod 64;
      pathsleft_below <= (0 - pathsleft_fresh_known) mod 64;
      pathsleft_is_first <= pathsleft_read_count_phase = 0;
      pathsleft_is_last <= pathsleft_read_count_phase_is_equal;
      pathsleft_lower_neighbour <= to_integer(pathsleft_read_words(1)(27 downto 21));
      pathsleft_stay_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g) mod 128;
      for i in 1 to 6 loop
        pathsleft_stay_change(i) <= (pathsleft_stay_change_value(i) - pathsleft_g) mod 128;
      end loop;
      pathsleft_stay_change(7) <= (to_integer(paths_cost_delay_held_0(23 downto 21)) - pathsleft_g) mod 128;
      pathsleft_step_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g_less) mod 128;
      for i in 1 to 6 loop
        pathsleft_step_change(i) <= (pathsleft_stay_change_value(i) - pathsleft_g_less) mod 128;
      end loop;
      pathsleft_step_change(7) <= (to_integer(paths_cost_delay_held_0(23 downto 21)) - pathsleft_g_less) mod 128;
      if (pathsleft_fresh_past_fours(4) - pathsleft_fresh_past_fours(0)) < 0 then
        pathsleft_fresh_past_eight <= pathsleft_fresh_past_fours(4);
      else
        pathsleft_fresh_past_eight <= pathsleft_fresh_past_fours(0);
      end if;
      if (pathsleft_fresh_past_oldest - pathsleft_fresh_past_eight) < 0 then
        pathsleft_fresh_past_cheapest <= pathsleft_fresh_past_oldest;
      else
        pathsleft_fresh_past_cheapest <= pathsleft_fresh_past_eight;
      end if;
      if (pathsleft_fresh_past_cheapest - to_integer(pathsleft_lowest_0)) < 0 then
        pathsleft_fresh_known <= pathsleft_fresh_past_cheapest;
      else
        pathsleft_fresh_known <= to_integer(pathsleft_lowest_0);
      end if;
      if line_starts_phases(18) then
        pathsleft_read_count_phase <= 0;
      else
        pathsleft_read_count_phase <= pathsleft_read_count_phase_choice;
      end if;
      if line_starts_phases(17) then
        pathsleft_ahead_count_phase <= 0;
      else
        pathsleft_ahead_count_phase <= pathsleft_ahead_count_phase_choice;
      end if;
      for i in 0 to 7 loop
        if pathsleft_stay_choices(i, 15) then
          pathsleft_stay(i) <= pathsleft_stay_choice_16(i);
        else
          pathsleft_stay(i) <= pathsleft_fresh_here;
        end if;
      end loop;
      if pathsleft_first then
        for i in 0 to 7 loop
          pathsleft_step(i) <= 64;
        end loop;
      else
        pathsleft_step(0) <= pathsleft_step_0_choice_2;
        for i in 1 to 6 loop
          pathsleft_step(i) <= pathsleft_step_choice(i);
        end loop;
        pathsleft_step(7) <= pathsleft_step_7_choice_2;
      end if;
      if line_starts_phases(21) then
        pathsleft_write_count_phase <= 0;
      else
        pathsleft_write_count_phase <= pathsleft_write_count_phase_choice;
      end if;
      for i in 0 to 3 loop
        if (pathsleft_cost(2 * i + 1) - pathsleft_cost(2 * i)) < 0 then
          pathsleft_tree_smallest(i) <= pathsleft_cost(2 * i + 1);
        else
          pathsleft_tree_smallest(i) <= pathsleft_cost(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (pathsleft_tree_smallest(2 * i + 1) - pathsleft_tree_smallest(2 * i)) < 0 then
          pathsleft_tree_next_smallest(i) <= pathsleft_tree_smallest(2 * i + 1);
        else
          pathsleft_tree_next_smallest(i) <= pathsleft_tree_smallest(2 * i);
        end if;
      end loop;
      if (pathsleft_tree_next_smallest(1) - pathsleft_tree_next_smallest(0)) < 0 then
        pathsleft_tree_next_next_smallest_0 <= pathsleft_tree_next_smallest(1);
      else
        pathsleft_tree_next_next_smallest_0 <= pathsleft_tree_next_smallest(0);
      end if;
      if (pathsleft_tree_next_next_smallest_0 - pathsleft_low_0_choice) < 0 then
        pathsleft_low_0 <= pathsleft_tree_next_next_smallest_0;
      else
        pathsleft_low_0 <= pathsleft_low_0_choice;
      end if;
      if line_starts_phases(19) then
        pathsleft_fresh_here <= relief_left(2);
        pathsleft_first <= line_places_shown_first_column(2);
        pathsleft_g <= paths_smallest_cost + pathsleft_q_now;
        pathsleft_g_less <= (paths_smallest_cost + pathsleft_q_less) mod 128;
      end if;
      if line_starts_phases(13) then
        pathsleft_low_address <= (pathsleft_low_address + 1) mod 16;
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
      if line_starts_phases(17) then
        if line_places_shown_first_column(2) then
          pathsleft_q <= 40;
        else
          pathsleft_q <= pathsleft_q_choice_2;
        end if;
        if pathsleft_lost then
          pathsleft_room_left <= 0;
        else
          pathsleft_room_left <= pathsleft_room_left_choice;
        end if;
      end if;
      if line_starts_phases(18) then
        pathsleft_q_now <= pathsleft_q;
        pathsleft_q_less <= (pathsleft_q + 119) mod 128;
        if line_places_shown_first_column(2) then
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
      pathsleft_cost_0_any := (not is_set(pathsleft_write_count_phase, 2)) or (not is_set(pathsleft_write_count_phase,
        1)) or (not is_set(pathsleft_write_count_phase, 0)) or line_starts_phases(21);
      if pathsleft_cost_0_any then
        for i in 0 to 7 loop
          pathsleft_cost(i) <= (pathsleft_stay(i) + pathsleft_stay_change(i)) mod 128;
        end loop;
        for i in 0 to 7 loop
          pathsleft_arrived(i) <= (pathsleft_step(i) + pathsleft_step_change(i)) mod 128;
        end loop;
      end if;
      if line_starts_phases(33) then
        pathsleft_low_write_address <= (pathsleft_low_write_address + 1) mod 16;
      end if;
      -- pathsabove
      pathsabove_memory_read_address_0_sum := pathsabove_read_address_address + 1;
      if line_places_shown_first_column(0) then
        pathsabove_memory_read_address_0_choice := 0;
      else
        pathsabove_memory_read_address_0_choice := pathsabove_memory_read_address_0_sum mod 4096;
      end if;
      pathsabove_memory_read_address_0_sum_2 := pathsabove_read_address_address + as_number(((not
        is_set(pathsabove_read_address_count_phase, 2)) or (not is_set(pathsabove_read_address_count_phase, 1)) or (not
        is_set(pathsabove_read_address_count_phase, 0))));
      if line_places_shown_first_column(0) then
        pathsabove_memory_read_address_1_choice := 0;
      else
        pathsabove_memory_read_address_1_choice := pathsabove_memory_read_address_0_sum mod 1024;
      end if;
      if line_places_shown_first_column(0) then
        pathsabove_memory_bank_choice := 0;
      else
        pathsabove_memory_bank_choice := pathsabove_memory_read_address_0_sum mod 8192;
      end if;
      if line_starts_phases(4) then
        pathsabove_memory_bank_choice_2 := pathsabove_memory_bank_choice;
      else
        pathsabove_memory_bank_choice_2 := pathsabove_memory_read_address_0_sum_2 mod 8192;
      end if;
      if pathsabove_read_address_count_phase = 7 then
        pathsabove_read_address_count_phase_choice := 7;
      else
        pathsabove_read_address_count_phase_choice := (pathsabove_read_address_count_phase + 1) mod 8;
      end if;
      if line_starts_phases(7) then
        pathsabove_ready_top_choice := line_places_shown_first_column(0) or pathsabove_ready_top;
      else
        pathsabove_ready_top_choice := pathsabove_ready_top;
      end if;
      if line_starts_phases(7) then
        pathsabove_ready_top_choice_2 := (not line_places_shown_first_column(0)) and pathsabove_ready_top;
      else
        pathsabove_ready_top_choice_2 := pathsabove_ready_top;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(0) := 20;
      else
        pathsabove_total_choice(0) := pathsabove_memory_ready_words(0) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(1) := 20;
      else
        pathsabove_total_choice(1) := (pathsabove_memory_ready_words(0) / 32) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(2) := 20;
      else
        pathsabove_total_choice(2) := (pathsabove_memory_ready_words(0) / 1024) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(3) := 20;
      else
        pathsabove_total_choice(3) := ((pathsabove_memory_ready_words(1) mod 16) * 2) +
          (pathsabove_memory_ready_words(0) / 32768);
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(4) := 20;
      else
        pathsabove_total_choice(4) := (pathsabove_memory_ready_words(1) / 16) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(5) := 20;
      else
        pathsabove_total_choice(5) := (pathsabove_memory_ready_words(1) / 512) mod 32;
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(6) := 20;
      else
        pathsabove_total_choice(6) := ((pathsabove_memory_ready_words_2 mod 8) * 4) + (pathsabove_memory_ready_words(1)
          / 16384);
      end if;
      if pathsabove_ready_top then
        pathsabove_total_choice(7) := 20;
      else
        pathsabove_total_choice(7) := pathsabove_memory_ready_words_2 / 8;
      end if;
      if line_comes(12) then
        pathsabove_smallest_total_choice := 31;
      else
        pathsabove_smallest_total_choice := pathsabove_smallest_total;
      end if;
      pathsabove_count_phase_is_equal := pathsabove_count_phase = 7;
      if pathsabove_count_phase_is_equal then
        pathsabove_count_phase_choice := 7;
      else
        pathsabove_count_phase_choice := (pathsabove_count_phase + 1) mod 8;
      end if;
      if pathsabove_count_phase = 0 then
        pathsabove_beside_0_choice := pathsabove_held(1);
      else
        pathsabove_beside_0_choice := pathsabove_lower_neighbour;
      end if;
      if pathsabove_count_phase_is_equal then
        pathsabove_beside_7_choice := pathsabove_held(6);
      else
        pathsabove_beside_7_choice := pathsabove_cost(0);
      end if;
      if line_places_shown_first_column(2) then
        pathsabove_write_address_address_choice := 0;
      else
        pathsabove_write_address_address_choice := (pathsabove_write_address_address + 1) mod 8192;
      end if;
      if pathsabove_write_address_count_phase = 7 then
        pathsabove_write_address_count_phase_choice := 7;
      else
        pathsabove_write_address_count_phase_choice := (pathsabove_write_address_count_phase + 1) mod 8;
      end if;
      pathsabove_memory_bank <= is_set(pathsabove_memory_bank_choice_2, 12);
      pathsabove_memory_read_bank <= pathsabove_memory_bank;
      pathsabove_memory_held_words(0, 0) <= to_integer(pathsabove_memory_read_words(0, 0));
      pathsabove_memory_held_words(0, 1) <= to_integer(pathsabove_memory_read_words(0, 1));
      pathsabove_memory_held_words_2(0) <= to_integer(pathsabove_memory_read_words_2(0));
      pathsabove_memory_held_words(1, 0) <= to_integer(pathsabove_memory_read_words(1, 0));
      pathsabove_memory_held_words(1, 1) <= to_integer(pathsabove_memory_read_words(1, 1));
      pathsabove_memory_held_words_2(1) <= to_integer(pathsabove_memory_read_words_2(1));
      pathsabove_memory_held_bank <= pathsabove_memory_read_bank;
      pathsabove_read_address_address <= pathsabove_memory_bank_choice_2;
      for i in 0 to 7 loop
        pathsabove_total(i) <= costs_cost(i) + pathsabove_total_choice(i);
      end loop;
      pathsabove_cost(0) <= (to_integer(pathsabove_delay_held_0) - pathsabove_smallest) mod 32;
      pathsabove_cost(1) <= (to_integer(pathsabove_delay_held_0(29 downto 5)) - pathsabove_smallest) mod 32;
      pathsabove_cost(2) <= (to_integer(pathsabove_delay_held_0(29 downto 10)) - pathsabove_smallest) mod 32;
      pathsabove_cost(3) <= (to_integer(pathsabove_delay_held_0(29 downto 15)) - pathsabove_smallest) mod 32;
      pathsabove_cost(4) <= (to_integer(pathsabove_delay_held_0(29 downto 20)) - pathsabove_smallest) mod 32;
      pathsabove_cost(5) <= (to_integer(pathsabove_delay_held_0(29 downto 25)) - pathsabove_smallest) mod 32;
      pathsabove_cost(6) <= (to_integer(pathsabove_delay_held_1) - pathsabove_smallest) mod 32;
      pathsabove_cost(7) <= (to_integer(pathsabove_delay_held_1(9 downto 5)) - pathsabove_smallest) mod 32;
      for i in 0 to 7 loop
        pathsabove_held(i) <= pathsabove_cost(i);
      end loop;
      pathsabove_lower_neighbour <= pathsabove_held(7);
      for i in 0 to 6 loop
        pathsabove_own(i) <= pathsabove_held(i);
      end loop;
      for i in 0 to 7 loop
        pathsabove_step(i) <= pathsabove_beside(i) + 5;
      end loop;
      pathsabove_write_address_is_here <= line_starts_phases(24) or (not is_set(pathsabove_write_address_count_phase,
        2)) or (not is_set(pathsabove_write_address_count_phase, 1)) or (not
        is_set(pathsabove_write_address_count_phase, 0));
      if line_starts_phases(4) then
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_choice;
        pathsabove_memory_read_address_1 <= pathsabove_memory_read_address_1_choice;
        pathsabove_read_address_count_phase <= 0;
      else
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_sum_2 mod 4096;
        pathsabove_memory_read_address_1 <= pathsabove_memory_read_address_0_sum_2 mod 1024;
        pathsabove_read_address_count_phase <= pathsabove_read_address_count_phase_choice;
      end if;
      if pathsabove_memory_held_bank then
        pathsabove_memory_ready_words(0) <= pathsabove_memory_held_words(1, 0);
        pathsabove_memory_ready_words(1) <= pathsabove_memory_held_words(1, 1);
        pathsabove_memory_ready_words_2 <= pathsabove_memory_held_words_2(1);
      else
        pathsabove_memory_ready_words(0) <= pathsabove_memory_held_words(0, 0);
        pathsabove_memory_ready_words(1) <= pathsabove_memory_held_words(0, 1);
        pathsabove_memory_ready_words_2 <= pathsabove_memory_held_words_2(0);
      end if;
      if line_places_0_top then
        pathsabove_ready_top <= pathsabove_ready_top_choice;
      else
        pathsabove_ready_top <= pathsabove_ready_top_choice_2;
      end if;
      for i in 0 to 3 loop
        if (pathsabove_total(2 * i + 1) - pathsabove_total(2 * i)) < 0 then
          pathsabove_tree_smallest(i) <= pathsabove_total(2 * i + 1);
        else
          pathsabove_tree_smallest(i) <= pathsabove_total(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (pathsabove_tree_smallest(2 * i + 1) - pathsabove_tree_smallest(2 * i)) < 0 then
          pathsabove_tree_next_smallest(i) <= pathsabove_tree_smallest(2 * i + 1);
        else
          pathsabove_tree_next_smallest(i) <= pathsabove_tree_smallest(2 * i);
        end if;
      end loop;
      if (pathsabove_tree_next_smallest(1) - pathsabove_tree_next_smallest(0)) < 0 then
        pathsabove_tree_next_next_smallest_0 <= pathsabove_tree_next_smallest(1);
      else
        pathsabove_tree_next_next_smallest_0 <= pathsabove_tree_next_smallest(0);
      end if;
      if (pathsabove_tree_next_next_smallest_0 - pathsabove_smallest_total_choice) < 0 then
        pathsabove_smallest_total <= pathsabove_tree_next_next_smallest_0;
      else
        pathsabove_smallest_total <= pathsabove_smallest_total_choice;
      end if;
      if line_starts_phases(22) then
        pathsabove_count_phase <= 0;
      else
        pathsabove_count_phase <= pathsabove_count_phase_choice;
      end if;
      if (pathsabove_held(1) - pathsabove_beside_0_choice) < 0 then
        pathsabove_beside(0) <= pathsabove_held(1);
      else
        pathsabove_beside(0) <= pathsabove_beside_0_choice;
      end if;
      for i in 2 to 7 loop
        if (pathsabove_held(i) - pathsabove_held(i - 2)) < 0 then
          pathsabove_beside(i - 1) <= pathsabove_held(i);
        else
          pathsabove_beside(i - 1) <= pathsabove_held(i - 2);
        end if;
      end loop;
      if (pathsabove_beside_7_choice - pathsabove_held(6)) < 0 then
        pathsabove_beside(7) <= pathsabove_beside_7_choice;
      else
        pathsabove_beside(7) <= pathsabove_held(6);
      end if;
      for i in 0 to 6 loop
        if pathsabove_own(i) < 20 then
          pathsabove_stay(i) <= pathsabove_own(i);
        else
          pathsabove_stay(i) <= 20;
        end if;
      end loop;
      if pathsabove_lower_neighbour < 20 then
        pathsabove_stay(7) <= pathsabove_lower_neighbour;
      else
        pathsabove_stay(7) <= 20;
      end if;
      if line_starts_phases(24) then
        pathsabove_write_address_address <= pathsabove_write_address_address_choice;
        pathsabove_write_address_count_phase <= 0;
      else
        pathsabove_write_address_address <= (pathsabove_write_address_address + as_number(((not
          is_set(pathsabove_write_address_count_phase, 2)) or (not is_set(pathsabove_write_address_count_phase, 1)) or
          (not is_set(pathsabove_write_address_count_phase, 0))))) mod 8192;
        pathsabove_write_address_count_phase <= pathsabove_write_address_count_phase_choice;
      end if;
      if (pathsabove_step(1) - pathsabove_stay(1)) < 0 then
        pathsabove_memory_write_words_0_choice(0) := pathsabove_step(1) mod 32;
      else
        pathsabove_memory_write_words_0_choice(0) := pathsabove_stay(1);
      end if;
      if (pathsabove_step(0) - pathsabove_stay(0)) < 0 then
        pathsabove_memory_write_words_0_choice_2(0) := pathsabove_step(0) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2(0) := pathsabove_stay(0);
      end if;
      if (pathsabove_step(2) - pathsabove_stay(2)) < 0 then
        pathsabove_memory_write_words_0_choice_3(0) := pathsabove_step(2) mod 32;
      else
        pathsabove_memory_write_words_0_choice_3(0) := pathsabove_stay(2);
      end if;
      pathsabove_memory_write_words_0_is_less(0) := (pathsabove_step(3) - pathsabove_stay(3)) < 0;
      if pathsabove_memory_write_words_0_is_less(0) then
        pathsabove_memory_write_words_0_0_choice_4 := is_set(pathsabove_step(3), 0);
      else
        pathsabove_memory_write_words_0_0_choice_4 := is_set(pathsabove_stay(3), 0);
      end if;
      pathsabove_memory_write_words_0_sum(0) := (pathsabove_memory_write_words_0_choice(0) * 32) +
        pathsabove_memory_write_words_0_choice_2(0) + (pathsabove_memory_write_words_0_choice_3(0) * 1024) +
        (as_number(pathsabove_memory_write_words_0_0_choice_4) * 32768);
      if (pathsabove_step(4) - pathsabove_stay(4)) < 0 then
        pathsabove_memory_write_words_0_choice(1) := pathsabove_step(4) mod 32;
      else
        pathsabove_memory_write_words_0_choice(1) := pathsabove_stay(4);
      end if;
      if pathsabove_memory_write_words_0_is_less(0) then
        pathsabove_memory_write_words_0_choice_2(1) := pathsabove_step(3) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2(1) := pathsabove_stay(3);
      end if;
      if (pathsabove_step(5) - pathsabove_stay(5)) < 0 then
        pathsabove_memory_write_words_0_choice_3(1) := pathsabove_step(5) mod 32;
      else
        pathsabove_memory_write_words_0_choice_3(1) := pathsabove_stay(5);
      end if;
      pathsabove_memory_write_words_0_is_less(1) := (pathsabove_step(6) - pathsabove_stay(6)) < 0;
      if pathsabove_memory_write_words_0_is_less(1) then
        pathsabove_memory_write_words_0_1_choice_4 := pathsabove_step(6) mod 4;
      else
        pathsabove_memory_write_words_0_1_choice_4 := pathsabove_stay(6) mod 4;
      end if;
      pathsabove_memory_write_words_0_sum(1) := (pathsabove_memory_write_words_0_choice(1) * 16) +
        (pathsabove_memory_write_words_0_choice_2(1) / 2) + (pathsabove_memory_write_words_0_choice_3(1) * 512) +
        (pathsabove_memory_write_words_0_1_choice_4 * 16384);
      if pathsabove_memory_write_words_0_is_less(1) then
        pathsabove_memory_write_words_0_choice(2) := pathsabove_step(6) mod 32;
      else
        pathsabove_memory_write_words_0_choice(2) := pathsabove_stay(6);
      end if;
      if (pathsabove_step(7) - pathsabove_stay(7)) < 0 then
        pathsabove_memory_write_words_0_choice_2(2) := pathsabove_step(7) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2(2) := pathsabove_stay(7);
      end if;
      pathsabove_memory_write_words_0_2_sum := (pathsabove_memory_write_words_0_choice(2) / 4) +
        (pathsabove_memory_write_words_0_choice_2(2) * 8);
      pathsabove_memory_write_words_0_all(0) := pathsabove_write_address_is_here and (pathsabove_write_address_address
        < 4096);
      if pathsabove_memory_write_words_0_all(0) then
        pathsabove_memory_write_words(0, 0) <= pathsabove_memory_write_words_0_sum(0);
        pathsabove_memory_write_words(0, 1) <= pathsabove_memory_write_words_0_sum(1);
        pathsabove_memory_write_words_2(0) <= pathsabove_memory_write_words_0_2_sum;
        pathsabove_memory_write_address_0 <= pathsabove_write_address_address mod 4096;
      end if;
      pathsabove_memory_write_words_0_all(1) := (4095 < pathsabove_write_address_address) and
        pathsabove_write_address_is_here;
      if pathsabove_memory_write_words_0_all(1) then
        pathsabove_memory_write_words(1, 0) <= pathsabove_memory_write_words_0_sum(0);
        pathsabove_memory_write_words(1, 1) <= pathsabove_memory_write_words_0_sum(1);
        pathsabove_memory_write_words_2(1) <= pathsabove_memory_write_words_0_2_sum;
        pathsabove_memory_write_address_1 <= pathsabove_write_address_address mod 1024;
      end if;
      if line_comes(20) then
        pathsabove_smallest <= pathsabove_smallest_total;
      end if;
      -- pathsturn
      pathsturn_cost_memory_read_address_0_sum := pathsturn_read_address_address + as_number(((not
        is_set(pathsturn_read_address_count_phase, 2)) or (not is_set(pathsturn_read_address_count_phase, 1)) or (not
        is_set(pathsturn_read_address_count_phase, 0))));
      if line_starts_phases(16) then
        pathsturn_cost_memory_bank_choice := line_places_address(1) * 8;
      else
        pathsturn_cost_memory_bank_choice := pathsturn_cost_memory_read_address_0_sum mod 8192;
      end if;
      if pathsturn_read_address_count_phase = 7 then
        pathsturn_read_address_count_phase_choice := 7;
      else
        pathsturn_read_address_count_phase_choice := (pathsturn_read_address_count_phase + 1) mod 8;
      end if;
      if pathsturn_write_address_count_phase = 7 then
        pathsturn_write_address_count_phase_choice := 7;
      else
        pathsturn_write_address_count_phase_choice := (pathsturn_write_address_count_phase + 1) mod 8;
      end if;
      pathsturn_sum_memory_read_address_0 <= pathsturn_sum_read_address mod 4096;
      pathsturn_sum_memory_read_address_1 <= pathsturn_sum_read_address mod 1024;
      pathsturn_sum_memory_bank <= is_set(pathsturn_sum_read_address, 12);
      pathsturn_sum_memory_read_bank <= pathsturn_sum_memory_bank;
      for i in 0 to 1 loop
        pathsturn_sum_memory_held_words(i, 0) <= to_integer(pathsturn_sum_memory_read_words(i, 0));
        pathsturn_sum_memory_held_words(i, 1) <= to_integer(pathsturn_sum_memory_read_words(i, 1));
        pathsturn_sum_memory_held_words(i, 2) <= to_integer(pathsturn_sum_memory_read_words(i, 2));
        pathsturn_sum_memory_held_words_3(i) <= to_integer(pathsturn_sum_memory_read_words_3(i));
      end loop;
      pathsturn_sum_memory_held_bank <= pathsturn_sum_memory_read_bank;
      pathsturn_cost_memory_bank <= is_set(pathsturn_cost_memory_bank_choice, 12);
      pathsturn_cost_memory_read_bank <= pathsturn_cost_memory_bank;
      pathsturn_cost_memory_held_words_0(0) <= to_integer(pathsturn_cost_memory_read_words_0(0));
      pathsturn_cost_memory_held_words_1(0) <= to_integer(pathsturn_cost_memory_read_words_1(0));
      pathsturn_cost_memory_held_words_0(1) <= to_integer(pathsturn_cost_memory_read_words_0(1));
      pathsturn_cost_memory_held_words_1(1) <= to_integer(pathsturn_cost_memory_read_words_1(1));
      pathsturn_cost_memory_held_bank <= pathsturn_cost_memory_read_bank;
      pathsturn_ready_smallest_0 <= to_integer(pathsturn_read_smallest_0);
      pathsturn_read_address_address <= pathsturn_cost_memory_bank_choice;
      pathsturn_sum_read_address <= pathsturn_read_address_address;
      pathsturn_write_smallest_0 <= paths_smallest_cost;
      pathsturn_write_address_is_here <= line_starts_phases(19) or (not is_set(pathsturn_write_address_count_phase, 2))
        or (not is_set(pathsturn_write_address_count_phase, 1)) or (not is_set(pathsturn_write_address_count_phase, 0));
      pathsturn_sum_write_address(0) <= pathsturn_write_address_address;
      pathsturn_sum_write_address(1) <= pathsturn_sum_write_address(0);
      pathsturn_writes_sums(0) <= pathsturn_write_address_is_here;
      pathsturn_writes_sums(1) <= pathsturn_writes_sums(0);
      if pathsturn_sum_memory_held_bank then
        pathsturn_sum_memory_ready_words(0) <= pathsturn_sum_memory_held_words(1, 0);
        pathsturn_sum_memory_ready_words(1) <= pathsturn_sum_memory_held_words(1, 1);
        pathsturn_sum_memory_ready_words(2) <= pathsturn_sum_memory_held_words(1, 2);
        pathsturn_sum_memory_ready_words_3 <= pathsturn_sum_memory_held_words_3(1);
      else
        pathsturn_sum_memory_ready_words(0) <= pathsturn_sum_memory_held_words(0, 0);
        pathsturn_sum_memory_ready_words(1) <= pathsturn_sum_memory_held_words(0, 1);
        pathsturn_sum_memory_ready_words(2) <= pathsturn_sum_memory_held_words(0, 2);
        pathsturn_sum_memory_ready_words_3 <= pathsturn_sum_memory_held_words_3(0);
      end if;
      if line_starts_phases(16) then
        pathsturn_cost_memory_read_address_0 <= (line_places_address(1) mod 512) * 8;
        pathsturn_cost_memory_read_address_1 <= (line_places_address(1) mod 128) * 8;
        pathsturn_read_address_count_phase <= 0;
      else
        pathsturn_cost_memory_read_address_0 <= pathsturn_cost_memory_read_address_0_sum mod 4096;
        pathsturn_cost_memory_read_address_1 <= pathsturn_cost_memory_read_address_0_sum mod 1024;
        pathsturn_read_address_count_phase <= pathsturn_read_address_count_phase_choice;
      end if;
      if pathsturn_cost_memory_held_bank then
        pathsturn_cost_memory_ready_words_0 <= pathsturn_cost_memory_held_words_0(1);
        pathsturn_cost_memory_ready_words_1 <= pathsturn_cost_memory_held_words_1(1);
      else
        pathsturn_cost_memory_ready_words_0 <= pathsturn_cost_memory_held_words_0(0);
        pathsturn_cost_memory_ready_words_1 <= pathsturn_cost_memory_held_words_1(0);
      end if;
      if line_starts_phases(19) then
        pathsturn_write_smallest_address <= line_places_address(2);
        pathsturn_write_address_address <= line_places_address(2) * 8;
        pathsturn_write_address_count_phase <= 0;
      else
        pathsturn_write_smallest_address <= 638;
        pathsturn_write_address_address <= (pathsturn_write_address_address + as_number(((not
          is_set(pathsturn_write_address_count_phase, 2)) or (not is_set(pathsturn_write_address_count_phase, 1)) or
          (not is_set(pathsturn_write_address_count_phase, 0))))) mod 8192;
        pathsturn_write_address_count_phase <= pathsturn_write_address_count_phase_choice;
      end if;
      pathsturn_sum_memory_write_words_0_sum(0) := pathsleft_cost(2) + pathsabove_cost(2);
      pathsturn_sum_memory_write_words_0_sum_2(0) := (((pathsleft_cost(1) + pathsabove_cost(1)) mod 128) * 128) +
        ((pathsleft_cost(0) + pathsabove_cost(0)) mod 128) + ((pathsturn_sum_memory_write_words_0_sum(0) mod 4) *
        16384);
      pathsturn_sum_memory_write_words_0_sum(1) := pathsleft_cost(4) + pathsabove_cost(4);
      pathsturn_sum_memory_write_words_0_sum_2(1) := (((pathsleft_cost(3) + pathsabove_cost(3)) mod 128) * 32) +
        ((pathsturn_sum_memory_write_words_0_sum(0) mod 128) / 4) + ((pathsturn_sum_memory_write_words_0_sum(1) mod 16)
        * 4096);
      pathsturn_sum_memory_write_words_0_sum(2) := pathsleft_cost(6) + pathsabove_cost(6);
      pathsturn_sum_memory_write_words_0_sum_2(2) := (((pathsleft_cost(5) + pathsabove_cost(5)) mod 128) * 8) +
        ((pathsturn_sum_memory_write_words_0_sum(1) mod 128) / 16) + ((pathsturn_sum_memory_write_words_0_sum(2) mod
        64) * 1024);
      pathsturn_sum_memory_write_words_0_3_sum := ((pathsturn_sum_memory_write_words_0_sum(2) mod 128) / 64) +
        (((pathsleft_cost(7) + pathsabove_cost(7)) mod 128) * 2);
      pathsturn_sum_memory_write_words_0_all(0) := (pathsturn_sum_write_address(1) < 4096) and pathsturn_writes_sums(1);
      if pathsturn_sum_memory_write_words_0_all(0) then
        pathsturn_sum_memory_write_words(0, 0) <= pathsturn_sum_memory_write_words_0_sum_2(0);
        pathsturn_sum_memory_write_words(0, 1) <= pathsturn_sum_memory_write_words_0_sum_2(1);
        pathsturn_sum_memory_write_words(0, 2) <= pathsturn_sum_memory_write_words_0_sum_2(2);
        pathsturn_sum_memory_write_words_3(0) <= pathsturn_sum_memory_write_words_0_3_sum;
        pathsturn_sum_memory_write_address_0 <= pathsturn_sum_write_address(1) mod 4096;
      end if;
      pathsturn_sum_memory_write_words_0_all(1) := is_set(pathsturn_sum_write_address(1), 12) and
        pathsturn_writes_sums(1);
      if pathsturn_sum_memory_write_words_0_all(1) then
        pathsturn_sum_memory_write_words(1, 0) <= pathsturn_sum_memory_write_words_0_sum_2(0);
        pathsturn_sum_memory_write_words(1, 1) <= pathsturn_sum_memory_write_words_0_sum_2(1);
        pathsturn_sum_memory_write_words(1, 2) <= pathsturn_sum_memory_write_words_0_sum_2(2);
        pathsturn_sum_memory_write_words_3(1) <= pathsturn_sum_memory_write_words_0_3_sum;
        pathsturn_sum_memory_write_address_1 <= pathsturn_sum_write_address(1) mod 1024;
      end if;
      pathsturn_cost_memory_write_words_0_0_sum := (to_integer(paths_cost_delay_held_0(15 downto 15)) * 32768) +
        to_integer(paths_cost_delay_held_0(14 downto 0));
      pathsturn_cost_memory_write_words_0_1_sum := (pathsleft_stay_change_value(5) / 2) +
        (to_integer(paths_cost_delay_held_0(23 downto 18)) * 4);
      pathsturn_cost_memory_write_words_0_all(0) := pathsturn_write_address_is_here and
        (pathsturn_write_address_address < 4096);
      if pathsturn_cost_memory_write_words_0_all(0) then
        pathsturn_cost_memory_write_words_0(0) <= pathsturn_cost_memory_write_words_0_0_sum;
        pathsturn_cost_memory_write_words_1(0) <= pathsturn_cost_memory_write_words_0_1_sum;
        pathsturn_cost_memory_write_address_0 <= pathsturn_write_address_address mod 4096;
      end if;
      pathsturn_cost_memory_write_words_0_all(1) := (4095 < pathsturn_write_address_address) and
        pathsturn_write_address_is_here;
      if pathsturn_cost_memory_write_words_0_all(1) then
        pathsturn_cost_memory_write_words_0(1) <= pathsturn_cost_memory_write_words_0_0_sum;
        pathsturn_cost_memory_write_words_1(1) <= pathsturn_cost_memory_write_words_0_1_sum;
        pathsturn_cost_memory_write_address_1 <= pathsturn_write_address_address mod 1024;
      end if;
      if line_starts_phases(16) then
        pathsturn_smallest_address <= line_places_address(1);
      end if;
      -- pathsright
      if line_starts_phases(10) then
        pathsright_fresh_past_newest(0) <= relief_right(1);
        pathsright_fresh_past_newest(1) <= pathsright_fresh_past_newest(0);
      end if;
      if line_starts_phases(11) then
        pathsright_fresh_past_pairs(1) <= pathsright_fresh_past_pairs(0);
        pathsright_fresh_past_pairs(2) <= pathsright_fresh_past_pairs(1);
        if (pathsright_fresh_past_newest(1) - pathsright_fresh_past_newest(0)) < 0 then
          pathsright_fresh_past_pairs(0) <= pathsright_fresh_past_newest(1);
        else
          pathsright_fresh_past_pairs(0) <= pathsright_fresh_past_newest(0);
        end if;
      end if;
      if line_starts_phases(12) then
        for i in 1 to 6 loop
          pathsright_fresh_past_fours(i) <= pathsright_fresh_past_fours(i - 1);
        end loop;
        if (pathsright_fresh_past_pairs(2) - pathsright_fresh_past_pairs(0)) < 0 then
          pathsright_fresh_past_fours(0) <= pathsright_fresh_past_pairs(2);
        else
          pathsright_fresh_past_fours(0) <= pathsright_fresh_past_pairs(0);
        end if;
      end if;
      pathsright_stay_value(0) := is_set(pathsright_fresh_here, 1);
      pathsright_stay_0_is_equal := (pathsright_fresh_here mod 4) = 0;
      if pathsright_read_words(2)(0) = '1' then
        pathsright_stay_choice(0) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(0) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(2)(1) = '1' then
        pathsright_stay_choices(0, 2) := (pathsright_read_words(2)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(0, 2) := pathsright_stay_choice(0);
      end if;
      pathsright_stay_value_2(0) := is_set(pathsright_fresh_here, 2);
      if pathsright_stay_choices(0, 2) then
        pathsright_stay_choices(0, 3) := (not (pathsright_read_words(2)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(0, 3) := (not (pathsright_read_words(2)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        pathsright_stay_0_values(i) := is_set(pathsright_fresh_here, i);
        if pathsright_stay_choices(0, i) then
          pathsright_stay_choices(0, i + 1) := (not (pathsright_read_words(2)(i) = '1')) or pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(0, i + 1) := (not (pathsright_read_words(2)(i) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      pathsright_stay_0_values_from_5(5) := is_set(pathsright_fresh_here, 5);
      if pathsright_stay_choices(0, 5) then
        pathsright_stay_choices(0, 6) := (not (pathsright_read_words(2)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(0, 6) := (not (pathsright_read_words(2)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(0, 6) then
        pathsright_stay_choices(0, 7) := (not (pathsright_read_words(2)(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(0, 7) := (not (pathsright_read_words(2)(6) = '1')) and is_set(pathsright_fresh_here, 6);
      end if;
      if is_set(pathsright_fresh_here, 0) then
        pathsright_stay_choices(0, 8) := (not (pathsright_read_words(0)(1) = '1')) or (not (pathsright_read_words(0)(0)
          = '1'));
      else
        pathsright_stay_choices(0, 8) := not (pathsright_read_words(0)(1) = '1');
      end if;
      if pathsright_stay_value(0) then
        pathsright_stay_choices(0, 9) := pathsright_stay_choices(0, 8);
      else
        pathsright_stay_choices(0, 9) := is_set(pathsright_fresh_here, 0) and (to_integer(pathsright_read_words(0)(1
          downto 0)) = 0);
      end if;
      pathsright_stay_0_values_from_5(6) := pathsright_read_words(0)(2) = '1';
      if pathsright_stay_choices(0, 9) then
        pathsright_stay_choices(0, 10) := (not pathsright_stay_value_2(0)) and pathsright_stay_0_values_from_5(6);
      else
        pathsright_stay_choices(0, 10) := (not pathsright_stay_value_2(0)) or pathsright_stay_0_values_from_5(6);
      end if;
      for i in 7 to 8 loop
        pathsright_stay_0_values_from_5(i) := pathsright_read_words(0)(i - 4) = '1';
        if pathsright_stay_choices(0, i + 3) then
          pathsright_stay_choices(0, i + 4) := (not pathsright_stay_0_values(i - 4)) or
            pathsright_stay_0_values_from_5(i);
        else
          pathsright_stay_choices(0, i + 4) := (not pathsright_stay_0_values(i - 4)) and
            pathsright_stay_0_values_from_5(i);
        end if;
      end loop;
      pathsright_stay_0_values_from_5(9) := pathsright_read_words(0)(5) = '1';
      if pathsright_stay_choices(0, 12) then
        pathsright_stay_choices(0, 13) := (not pathsright_stay_0_values_from_5(5)) or
          pathsright_stay_0_values_from_5(9);
      else
        pathsright_stay_choices(0, 13) := (not pathsright_stay_0_values_from_5(5)) and
          pathsright_stay_0_values_from_5(9);
      end if;
      pathsright_stay_0_values_from_5(10) := pathsright_read_words(0)(6) = '1';
      if pathsright_stay_choices(0, 13) then
        pathsright_stay_choices(0, 14) := (not is_set(pathsright_fresh_here, 6)) or pathsright_stay_0_values_from_5(10);
      else
        pathsright_stay_choices(0, 14) := (not is_set(pathsright_fresh_here, 6)) and
          pathsright_stay_0_values_from_5(10);
      end if;
      if pathsright_stay_choices(0, 7) then
        pathsright_stay_choices(0, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(0, 15) := (not pathsright_stay_choices(0, 14)) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words(2)(6 downto 0)) - to_integer(pathsright_read_words(0)(6 downto 0))) < 0 then
        pathsright_stay_choice_16(0) := to_integer(pathsright_read_words(2)(6 downto 0));
      else
        pathsright_stay_choice_16(0) := to_integer(pathsright_read_words(0)(6 downto 0));
      end if;
      for i in 1 to 2 loop
        pathsright_stay_value(i) := pathsright_read_words(2)(7 * i) = '1';
        if pathsright_stay_value(i) then
          pathsright_stay_choice(i) := not pathsright_stay_value(0);
        else
          pathsright_stay_choice(i) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(2)(7 * i + 1) = '1' then
          pathsright_stay_choices(i, 2) := pathsright_stay_value(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 2) := pathsright_stay_choice(i);
        end if;
        if pathsright_stay_choices(i, 2) then
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(2)(7 * i + 2) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(2)(7 * i + 2) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(2)(7 * i + j) = '1')) or
              pathsright_stay_0_values(j);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(2)(7 * i + j) = '1')) and
              pathsright_stay_0_values(j);
          end if;
        end loop;
        if pathsright_stay_choices(i, 5) then
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(2)(7 * i + 5) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(2)(7 * i + 5) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 6) then
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(2)(7 * i + 6) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(2)(7 * i + 6) = '1')) and
            is_set(pathsright_fresh_here, 6);
        end if;
        pathsright_stay_value_2(i) := pathsright_read_words(0)(7 * i) = '1';
        if pathsright_stay_value_2(i) then
          pathsright_stay_choices(i, 8) := not pathsright_stay_value(0);
        else
          pathsright_stay_choices(i, 8) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(0)(7 * i + 1) = '1' then
          pathsright_stay_choices(i, 9) := pathsright_stay_value_2(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 9) := pathsright_stay_choices(i, 8);
        end if;
        if pathsright_stay_choices(i, 9) then
          pathsright_stay_choices(i, 10) := (not (pathsright_read_words(0)(7 * i + 2) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 10) := (not (pathsright_read_words(0)(7 * i + 2) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 10 to 11 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(0)(7 * i + j - 7) = '1')) or
              pathsright_stay_0_values(j - 7);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(0)(7 * i + j - 7) = '1')) and
              pathsright_stay_0_values(j - 7);
          end if;
        end loop;
        if pathsright_stay_choices(i, 12) then
          pathsright_stay_choices(i, 13) := (not (pathsright_read_words(0)(7 * i + 5) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 13) := (not (pathsright_read_words(0)(7 * i + 5) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 13) then
          pathsright_stay_choices(i, 14) := (not (pathsright_read_words(0)(7 * i + 6) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 14) := (not (pathsright_read_words(0)(7 * i + 6) = '1')) and
            is_set(pathsright_fresh_here, 6);
        end if;
        if pathsright_stay_choices(i, 7) then
          pathsright_stay_choices(i, 15) := not pathsleft_first;
        else
          pathsright_stay_choices(i, 15) := pathsright_stay_choices(i, 14) and (not pathsleft_first);
        end if;
        pathsright_stay_values_from_1(i, 3) := to_integer(pathsright_read_words(2)(7 * i + 6 downto 7 * i));
        pathsright_stay_values_from_1(i, 4) := to_integer(pathsright_read_words(0)(7 * i + 6 downto 7 * i));
        if (pathsright_stay_values_from_1(i, 3) - pathsright_stay_values_from_1(i, 4)) < 0 then
          pathsright_stay_choice_16(i) := pathsright_stay_values_from_1(i, 3);
        else
          pathsright_stay_choice_16(i) := pathsright_stay_values_from_1(i, 4);
        end if;
      end loop;
      pathsright_stay_value(3) := pathsright_read_words(2)(21) = '1';
      if pathsright_stay_value(3) then
        pathsright_stay_choice(3) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(3) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(2)(22) = '1' then
        pathsright_stay_choices(3, 2) := pathsright_stay_value(3) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(3, 2) := pathsright_stay_choice(3);
      end if;
      if pathsright_stay_choices(3, 2) then
        pathsright_stay_choices(3, 3) := (not (pathsright_read_words(2)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(3, 3) := (not (pathsright_read_words(2)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(3, i) then
          pathsright_stay_choices(3, i + 1) := (not (pathsright_read_words(2)(i + 21) = '1')) or
            pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(3, i + 1) := (not (pathsright_read_words(2)(i + 21) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(3, 5) then
        pathsright_stay_choices(3, 6) := (not (pathsright_read_words(2)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(3, 6) := (not (pathsright_read_words(2)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(3, 6) then
        pathsright_stay_choices(3, 7) := (not (pathsright_read_words(2)(27) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(3, 7) := (not (pathsright_read_words(2)(27) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      pathsright_stay_value_2(3) := pathsright_read_words(0)(21) = '1';
      if pathsright_stay_value_2(3) then
        pathsright_stay_choices(3, 8) := not pathsright_stay_value(0);
      else
        pathsright_stay_choices(3, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(0)(22) = '1' then
        pathsright_stay_choices(3, 9) := pathsright_stay_value_2(3) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(3, 9) := pathsright_stay_choices(3, 8);
      end if;
      if pathsright_stay_choices(3, 9) then
        pathsright_stay_choices(3, 10) := (not (pathsright_read_words(0)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(3, 10) := (not (pathsright_read_words(0)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsright_stay_choices(3, i) then
          pathsright_stay_choices(3, i + 1) := (not (pathsright_read_words(0)(i + 14) = '1')) or
            pathsright_stay_0_values(i - 7);
        else
          pathsright_stay_choices(3, i + 1) := (not (pathsright_read_words(0)(i + 14) = '1')) and
            pathsright_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsright_stay_choices(3, 12) then
        pathsright_stay_choices(3, 13) := (not (pathsright_read_words(0)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(3, 13) := (not (pathsright_read_words(0)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(3, 13) then
        pathsright_stay_choices(3, 14) := (not (pathsright_read_words(0)(27) = '1')) or is_set(pathsright_fresh_here,
          6);
      else
        pathsright_stay_choices(3, 14) := (not (pathsright_read_words(0)(27) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(3, 7) then
        pathsright_stay_choices(3, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(3, 15) := pathsright_stay_choices(3, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words(2)(27 downto 21)) - to_integer(pathsright_read_words(0)(27 downto 21))) < 0
        then
        pathsright_stay_choice_16(3) := to_integer(pathsright_read_words(2)(27 downto 21));
      else
        pathsright_stay_choice_16(3) := to_integer(pathsright_read_words(0)(27 downto 21));
      end if;
      if pathsright_read_words(3)(0) = '1' then
        pathsright_stay_choice(4) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(4) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(3)(1) = '1' then
        pathsright_stay_choices(4, 2) := (pathsright_read_words(3)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(4, 2) := pathsright_stay_choice(4);
      end if;
      if pathsright_stay_choices(4, 2) then
        pathsright_stay_choices(4, 3) := (not (pathsright_read_words(3)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(4, 3) := (not (pathsright_read_words(3)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(4, i) then
          pathsright_stay_choices(4, i + 1) := (not (pathsright_read_words(3)(i) = '1')) or pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(4, i + 1) := (not (pathsright_read_words(3)(i) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(4, 5) then
        pathsright_stay_choices(4, 6) := (not (pathsright_read_words(3)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(4, 6) := (not (pathsright_read_words(3)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(4, 6) then
        pathsright_stay_choices(4, 7) := (not (pathsright_read_words(3)(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(4, 7) := (not (pathsright_read_words(3)(6) = '1')) and is_set(pathsright_fresh_here, 6);
      end if;
      if pathsright_read_words(1)(0) = '1' then
        pathsright_stay_choices(4, 8) := not pathsright_stay_value(0);
      else
        pathsright_stay_choices(4, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(1)(1) = '1' then
        pathsright_stay_choices(4, 9) := (pathsright_read_words(1)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(4, 9) := pathsright_stay_choices(4, 8);
      end if;
      if pathsright_stay_choices(4, 9) then
        pathsright_stay_choices(4, 10) := (not (pathsright_read_words(1)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(4, 10) := (not (pathsright_read_words(1)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsright_stay_choices(4, i) then
          pathsright_stay_choices(4, i + 1) := (not (pathsright_read_words(1)(i - 7) = '1')) or
            pathsright_stay_0_values(i - 7);
        else
          pathsright_stay_choices(4, i + 1) := (not (pathsright_read_words(1)(i - 7) = '1')) and
            pathsright_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsright_stay_choices(4, 12) then
        pathsright_stay_choices(4, 13) := (not (pathsright_read_words(1)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(4, 13) := (not (pathsright_read_words(1)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(4, 13) then
        pathsright_stay_choices(4, 14) := (not (pathsright_read_words(1)(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(4, 14) := (not (pathsright_read_words(1)(6) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(4, 7) then
        pathsright_stay_choices(4, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(4, 15) := pathsright_stay_choices(4, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words(3)(6 downto 0)) - to_integer(pathsright_read_words(1)(6 downto 0))) < 0 then
        pathsright_stay_choice_16(4) := to_integer(pathsright_read_words(3)(6 downto 0));
      else
        pathsright_stay_choice_16(4) := to_integer(pathsright_read_words(1)(6 downto 0));
      end if;
      for i in 5 to 6 loop
        pathsright_stay_values(i) := pathsright_read_words(3)(7 * i - 28) = '1';
        if pathsright_stay_values(i) then
          pathsright_stay_choice(i) := not pathsright_stay_value(0);
        else
          pathsright_stay_choice(i) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(3)(7 * i - 27) = '1' then
          pathsright_stay_choices(i, 2) := pathsright_stay_values(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 2) := pathsright_stay_choice(i);
        end if;
        if pathsright_stay_choices(i, 2) then
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(3)(7 * i - 26) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(3)(7 * i - 26) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(3)(7 * i + j - 28) = '1')) or
              pathsright_stay_0_values(j);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(3)(7 * i + j - 28) = '1')) and
              pathsright_stay_0_values(j);
          end if;
        end loop;
        if pathsright_stay_choices(i, 5) then
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(3)(7 * i - 23) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(3)(7 * i - 23) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 6) then
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(3)(7 * i - 22) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(3)(7 * i - 22) = '1')) and
            is_set(pathsright_fresh_here, 6);
        end if;
        pathsright_stay_value_2s(i) := pathsright_read_words(1)(7 * i - 28) = '1';
        if pathsright_stay_value_2s(i) then
          pathsright_stay_choices(i, 8) := not pathsright_stay_value(0);
        else
          pathsright_stay_choices(i, 8) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(1)(7 * i - 27) = '1' then
          pathsright_stay_choices(i, 9) := pathsright_stay_value_2s(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 9) := pathsright_stay_choices(i, 8);
        end if;
        if pathsright_stay_choices(i, 9) then
          pathsright_stay_choices(i, 10) := (not (pathsright_read_words(1)(7 * i - 26) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 10) := (not (pathsright_read_words(1)(7 * i - 26) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 10 to 11 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(1)(7 * i + j - 35) = '1')) or
              pathsright_stay_0_values(j - 7);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(1)(7 * i + j - 35) = '1')) and
              pathsright_stay_0_values(j - 7);
          end if;
        end loop;
        if pathsright_stay_choices(i, 12) then
          pathsright_stay_choices(i, 13) := (not (pathsright_read_words(1)(7 * i - 23) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 13) := (not (pathsright_read_words(1)(7 * i - 23) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 13) then
          pathsright_stay_choices(i, 14) := (not (pathsright_read_words(1)(7 * i - 22) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 14) := (not (pathsright_read_words(1)(7 * i - 22) = '1')) and
            is_set(pathsright_fresh_here, 6);
        end if;
        if pathsright_stay_choices(i, 7) then
          pathsright_stay_choices(i, 15) := not pathsleft_first;
        else
          pathsright_stay_choices(i, 15) := pathsright_stay_choices(i, 14) and (not pathsleft_first);
        end if;
        pathsright_stay_values_from_5(i, 3) := to_integer(pathsright_read_words(3)(7 * i - 22 downto 7 * i - 28));
        pathsright_stay_values_from_5(i, 4) := to_integer(pathsright_read_words(1)(7 * i - 22 downto 7 * i - 28));
        if (pathsright_stay_values_from_5(i, 3) - pathsright_stay_values_from_5(i, 4)) < 0 then
          pathsright_stay_choice_16(i) := pathsright_stay_values_from_5(i, 3);
        else
          pathsright_stay_choice_16(i) := pathsright_stay_values_from_5(i, 4);
        end if;
      end loop;
      pathsright_stay_values(7) := pathsright_read_words(3)(21) = '1';
      if pathsright_stay_values(7) then
        pathsright_stay_choice(7) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(7) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(3)(22) = '1' then
        pathsright_stay_choices(7, 2) := pathsright_stay_values(7) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(7, 2) := pathsright_stay_choice(7);
      end if;
      if pathsright_stay_choices(7, 2) then
        pathsright_stay_choices(7, 3) := (not (pathsright_read_words(3)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(7, 3) := (not (pathsright_read_words(3)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(7, i) then
          pathsright_stay_choices(7, i + 1) := (not (pathsright_read_words(3)(i + 21) = '1')) or
            pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(7, i + 1) := (not (pathsright_read_words(3)(i + 21) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(7, 5) then
        pathsright_stay_choices(7, 6) := (not (pathsright_read_words(3)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(7, 6) := (not (pathsright_read_words(3)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(7, 6) then
        pathsright_stay_choices(7, 7) := (not (pathsright_read_words(3)(27) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(7, 7) := (not (pathsright_read_words(3)(27) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      pathsright_stay_value_2s(7) := pathsright_read_words(1)(21) = '1';
      if pathsright_stay_value_2s(7) then
        pathsright_stay_choices(7, 8) := not pathsright_stay_value(0);
      else
        pathsright_stay_choices(7, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(1)(22) = '1' then
        pathsright_stay_choices(7, 9) := pathsright_stay_value_2s(7) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(7, 9) := pathsright_stay_choices(7, 8);
      end if;
      if pathsright_stay_choices(7, 9) then
        pathsright_stay_choices(7, 10) := (not (pathsright_read_words(1)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(7, 10) := (not (pathsright_read_words(1)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsright_stay_choices(7, i) then
          pathsright_stay_choices(7, i + 1) := (not (pathsright_read_words(1)(i + 14) = '1')) or
            pathsright_stay_0_values(i - 7);
        else
          pathsright_stay_choices(7, i + 1) := (not (pathsright_read_words(1)(i + 14) = '1')) and
            pathsright_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsright_stay_choices(7, 12) then
        pathsright_stay_choices(7, 13) := (not (pathsright_read_words(1)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(7, 13) := (not (pathsright_read_words(1)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(7, 13) then
        pathsright_stay_choices(7, 14) := (not (pathsright_read_words(1)(27) = '1')) or is_set(pathsright_fresh_here,
          6);
      else
        pathsright_stay_choices(7, 14) := (not (pathsright_read_words(1)(27) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(7, 7) then
        pathsright_stay_choices(7, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(7, 15) := pathsright_stay_choices(7, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words(3)(27 downto 21)) - to_integer(pathsright_read_words(1)(27 downto 21))) < 0
        then
        pathsright_stay_choice_16(7) := to_integer(pathsright_read_words(3)(27 downto 21));
      else
        pathsright_stay_choice_16(7) := to_integer(pathsright_read_words(1)(27 downto 21));
      end if;
      if pathsleft_is_first then
        pathsright_step_choice(0) := pathsright_stay_values_from_1(1, 4);
      else
        pathsright_step_choice(0) := pathsright_lower_neighbour;
      end if;
      if (pathsright_stay_values_from_1(1, 4) - pathsright_step_choice(0)) < 0 then
        pathsright_step_0_choice_2 := pathsright_stay_values_from_1(1, 4);
      else
        pathsright_step_0_choice_2 := pathsright_step_choice(0);
      end if;
      if (pathsright_stay_values_from_1(2, 4) - to_integer(pathsright_read_words(0)(6 downto 0))) < 0 then
        pathsright_step_choice(1) := pathsright_stay_values_from_1(2, 4);
      else
        pathsright_step_choice(1) := to_integer(pathsright_read_words(0)(6 downto 0));
      end if;
      for i in 0 to 1 loop
        if (to_integer(pathsright_read_words(i)(27 - 21 * i downto 21 - 21 * i)) - pathsright_stay_values_from_1(i + 1,
          4)) < 0 then
          pathsright_step_choice(i + 2) := to_integer(pathsright_read_words(i)(27 - 21 * i downto 21 - 21 * i));
        else
          pathsright_step_choice(i + 2) := pathsright_stay_values_from_1(i + 1, 4);
        end if;
      end loop;
      for i in 5 to 6 loop
        if (pathsright_stay_values_from_5(i, 4) - to_integer(pathsright_read_words(i - 5)(132 - 21 * i downto 126 - 21
          * i))) < 0 then
          pathsright_step_choice(i - 1) := pathsright_stay_values_from_5(i, 4);
        else
          pathsright_step_choice(i - 1) := to_integer(pathsright_read_words(i - 5)(132 - 21 * i downto 126 - 21 * i));
        end if;
      end loop;
      if (to_integer(pathsright_read_words(1)(27 downto 21)) - pathsright_stay_values_from_5(5, 4)) < 0 then
        pathsright_step_choice(6) := to_integer(pathsright_read_words(1)(27 downto 21));
      else
        pathsright_step_choice(6) := pathsright_stay_values_from_5(5, 4);
      end if;
      if pathsleft_is_last then
        pathsright_step_choice(7) := pathsright_stay_values_from_5(6, 4);
      else
        pathsright_step_choice(7) := to_integer(pathsright_read_neighbour_0);
      end if;
      if (pathsright_step_choice(7) - pathsright_stay_values_from_5(6, 4)) < 0 then
        pathsright_step_7_choice_2 := pathsright_step_choice(7);
      else
        pathsright_step_7_choice_2 := pathsright_stay_values_from_5(6, 4);
      end if;
      pathsright_stay_change_value(1) := (pathsturn_cost_memory_ready_words_0 mod 64) / 8;
      pathsright_stay_change_value(2) := (pathsturn_cost_memory_ready_words_0 / 64) mod 8;
      pathsright_stay_change_value(3) := (pathsturn_cost_memory_ready_words_0 / 512) mod 8;
      pathsright_stay_change_value(4) := (pathsturn_cost_memory_ready_words_0 / 4096) mod 8;
      pathsright_stay_change_5_sum := ((pathsturn_cost_memory_ready_words_1 mod 4) * 2) +
        (pathsturn_cost_memory_ready_words_0 / 32768);
      pathsright_stay_change_6_value := (pathsturn_cost_memory_ready_words_1 / 4) mod 8;
      if line_comes(25) then
        pathsright_low_0_choice := 127;
      else
        pathsright_low_0_choice := pathsright_low_0;
      end if;
      pathsright_fresh_past_oldest <= pathsright_fresh_past_fours(6);
      pathsright_lost <= is_set(pathsright_fresh_known, 6);
      pathsright_short_of <= (((pathsright_fresh_known mod 64) + pathsright_room) / 64) = 1;
      pathsright_missing <= (pathsright_fresh_known + pathsright_room) mod 64;
      pathsright_below <= (0 - pathsright_fresh_known) mod 64;
      pathsright_lower_neighbour <= to_integer(pathsright_read_words(1)(27 downto 21));
      pathsright_stay_change(0) <= ((pathsturn_cost_memory_ready_words_0 mod 8) - pathsright_g) mod 128;
      pathsright_stay_change(1) <= (pathsright_stay_change_value(1) - pathsright_g) mod 128;
      pathsright_stay_change(2) <= (pathsright_stay_change_value(2) - pathsright_g) mod 128;
      pathsright_stay_change(3) <= (pathsright_stay_change_value(3) - pathsright_g) mod 128;
      pathsright_stay_change(4) <= (pathsright_stay_change_value(4) - pathsright_g) mod 128;
      pathsright_stay_change(5) <= (pathsright_stay_change_5_sum - pathsright_g) mod 128;
      pathsright_stay_change(6) <= (pathsright_stay_change_6_value - pathsright_g) mod 128;
      pathsright_stay_change(7) <= ((pathsturn_cost_memory_ready_words_1 / 32) - pathsright_g) mod 128;
      pathsright_step_change(0) <= ((pathsturn_cost_memory_ready_words_0 mod 8) - pathsright_g_less) mod 128;
      pathsright_step_change(1) <= (pathsright_stay_change_value(1) - pathsright_g_less) mod 128;
      pathsright_step_change(2) <= (pathsright_stay_change_value(2) - pathsright_g_less) mod 128;
      pathsright_step_change(3) <= (pathsright_stay_change_value(3) - pathsright_g_less) mod 128;
      pathsright_step_change(4) <= (pathsright_stay_change_value(4) - pathsright_g_less) mod 128;
      pathsright_step_change(5) <= (pathsright_stay_change_5_sum - pathsright_g_less) mod 128;
      pathsright_step_change(6) <= (pathsright_stay_change_6_value - pathsright_g_less) mod 128;
      pathsright_step_change(7) <= ((pathsturn_cost_memory_ready_words_1 / 32) - pathsright_g_less) mod 128;
      if (pathsright_fresh_past_fours(4) - pathsright_fresh_past_fours(0)) < 0 then
        pathsright_fresh_past_eight <= pathsright_fresh_past_fours(4);
      else
        pathsright_fresh_past_eight <= pathsright_fresh_past_fours(0);
      end if;
      if (pathsright_fresh_past_oldest - pathsright_fresh_past_eight) < 0 then
        pathsright_fresh_past_cheapest <= pathsright_fresh_past_oldest;
      else
        pathsright_fresh_past_cheapest <= pathsright_fresh_past_eight;
      end if;
      if (pathsright_fresh_past_cheapest - to_integer(pathsright_lowest_0)) < 0 then
        pathsright_fresh_known <= pathsright_fresh_past_cheapest;
      else
        pathsright_fresh_known <= to_integer(pathsright_lowest_0);
      end if;
      for i in 0 to 7 loop
        if pathsright_stay_choices(i, 15) then
          pathsright_stay(i) <= pathsright_stay_choice_16(i);
        else
          pathsright_stay(i) <= pathsright_fresh_here;
        end if;
      end loop;
      if pathsleft_first then
        for i in 0 to 7 loop
          pathsright_step(i) <= 64;
        end loop;
      else
        pathsright_step(0) <= pathsright_step_0_choice_2;
        for i in 1 to 6 loop
          pathsright_step(i) <= pathsright_step_choice(i);
        end loop;
        pathsright_step(7) <= pathsright_step_7_choice_2;
      end if;
      for i in 0 to 3 loop
        if (pathsright_cost(2 * i + 1) - pathsright_cost(2 * i)) < 0 then
          pathsright_tree_smallest(i) <= pathsright_cost(2 * i + 1);
        else
          pathsright_tree_smallest(i) <= pathsright_cost(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (pathsright_tree_smallest(2 * i + 1) - pathsright_tree_smallest(2 * i)) < 0 then
          pathsright_tree_next_smallest(i) <= pathsright_tree_smallest(2 * i + 1);
        else
          pathsright_tree_next_smallest(i) <= pathsright_tree_smallest(2 * i);
        end if;
      end loop;
      if (pathsright_tree_next_smallest(1) - pathsright_tree_next_smallest(0)) < 0 then
        pathsright_tree_next_next_smallest_0 <= pathsright_tree_next_smallest(1);
      else
        pathsright_tree_next_next_smallest_0 <= pathsright_tree_next_smallest(0);
      end if;
      if (pathsright_tree_next_next_smallest_0 - pathsright_low_0_choice) < 0 then
        pathsright_low_0 <= pathsright_tree_next_next_smallest_0;
      else
        pathsright_low_0 <= pathsright_low_0_choice;
      end if;
      if line_starts_phases(19) then
        pathsright_fresh_here <= relief_right(2);
        pathsright_g <= pathsturn_ready_smallest_0 + pathsright_q_now;
        pathsright_g_less <= (pathsturn_ready_smallest_0 + pathsright_q_less) mod 128;
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
      if line_starts_phases(17) then
        if line_places_shown_first_column(2) then
          pathsright_q <= 40;
        else
          pathsright_q <= pathsright_q_choice_2;
        end if;
        if pathsright_lost then
          pathsright_room_left <= 0;
        else
          pathsright_room_left <= pathsright_room_left_choice;
        end if;
      end if;
      if line_starts_phases(18) then
        pathsright_q_now <= pathsright_q;
        pathsright_q_less <= (pathsright_q + 119) mod 128;
        if line_places_shown_first_column(2) then
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
      if pathsleft_cost_0_any then
        for i in 0 to 7 loop
          pathsright_cost(i) <= (pathsright_stay(i) + pathsright_stay_change(i)) mod 128;
        end loop;
        for i in 0 to 7 loop
          pathsright_arrived(i) <= (pathsright_step(i) + pathsright_step_change(i)) mod 128;
        end loop;
      end if;
      -- winnersmask
      winnersmask_column_sum := winnersmask_column + 1;
      if line_places_first_column(2) then
        winnersmask_column_choice := 0;
      else
        winnersmask_column_choice := winnersmask_column_sum mod 1024;
      end if;
      if line_comes(21) then
        winnersmask_column <= winnersmask_column_choice;
      end if;
      if line_places_first_column(2) then
        winnersmask_partner_choice := 0;
      else
        winnersmask_partner_choice := winnersmask_column_sum;
      end if;
      winnersmask_inside(0) <= (((((winnersmask_partner / 1024) + 63) mod 64) * 1024) + (winnersmask_partner mod 1024))
        < 638;
      winnersmask_inside(1) <= (winnersmask_partner >= 1023) and (winnersmask_partner < 1661);
      winnersmask_inside(2) <= (((((winnersmask_partner / 2) + 32257) mod 32768) * 2) + (winnersmask_partner mod 2)) <
        638;
      winnersmask_inside(3) <= (winnersmask_partner >= 1021) and (winnersmask_partner < 1659);
      winnersmask_inside(4) <= (((((winnersmask_partner / 4) + 16129) mod 16384) * 4) + (winnersmask_partner mod 4)) <
        638;
      winnersmask_inside(5) <= (winnersmask_partner >= 1019) and (winnersmask_partner < 1657);
      winnersmask_inside(6) <= (((((winnersmask_partner / 2) + 32259) mod 32768) * 2) + (winnersmask_partner mod 2)) <
        638;
      winnersmask_inside(7) <= (winnersmask_partner >= 1017) and (winnersmask_partner < 1655);
      if line_comes(21) then
        winnersmask_partner <= (((winnersmask_partner_choice / 1024) + 1) * 1024) + winnersmask_column_choice;
      else
        winnersmask_partner <= ((((winnersmask_partner / 8) + 1) mod 512) * 8) + (winnersmask_partner mod 8);
      end if;
      -- winnerswinner1
      for i in 0 to 3 loop
        winnerswinner1_best_index_0_value(i) := is_set(paths_sum(2 * i + 1), 1);
        winnerswinner1_best_index_0_values(i, 2) := is_set(paths_sum(2 * i), 1);
        if is_set(paths_sum(2 * i + 1), 0) then
          winnerswinner1_best_index_0_choice(i) := not winnerswinner1_best_index_0_values(i, 2);
        else
          winnerswinner1_best_index_0_choice(i) := (paths_sum(2 * i) mod 4) = 0;
        end if;
        if winnerswinner1_best_index_0_value(i) then
          winnerswinner1_best_index_0_choices(i, 2) := is_set(paths_sum(2 * i + 1), 0) or (not
            winnerswinner1_best_index_0_values(i, 2)) or (not is_set(paths_sum(2 * i), 0));
        else
          winnerswinner1_best_index_0_choices(i, 2) := winnerswinner1_best_index_0_choice(i);
        end if;
        winnerswinner1_best_index_0_values(i, 3) := is_set(paths_sum(2 * i), 2);
        if winnerswinner1_best_index_0_choices(i, 2) then
          winnerswinner1_best_index_0_choices(i, 3) := (not is_set(paths_sum(2 * i + 1), 2)) and
            winnerswinner1_best_index_0_values(i, 3);
        else
          winnerswinner1_best_index_0_choices(i, 3) := (not is_set(paths_sum(2 * i + 1), 2)) or
            winnerswinner1_best_index_0_values(i, 3);
        end if;
        for j in 4 to 7 loop
          winnerswinner1_best_index_0_values(i, j) := is_set(paths_sum(2 * i), j - 1);
          if winnerswinner1_best_index_0_choices(i, j - 1) then
            winnerswinner1_best_index_0_choices(i, j) := (not is_set(paths_sum(2 * i + 1), j - 1)) or
              winnerswinner1_best_index_0_values(i, j);
          else
            winnerswinner1_best_index_0_choices(i, j) := (not is_set(paths_sum(2 * i + 1), j - 1)) and
              winnerswinner1_best_index_0_values(i, j);
          end if;
        end loop;
        if winnerswinner1_best_index_0_choices(i, 7) then
          winnerswinner1_best_index_0_choices(i, 8) := (not is_set(paths_sum(2 * i + 1), 7)) or is_set(paths_sum(2 *
            i), 7);
        else
          winnerswinner1_best_index_0_choices(i, 8) := (not is_set(paths_sum(2 * i + 1), 7)) and is_set(paths_sum(2 *
            i), 7);
        end if;
      end loop;
      for i in 0 to 7 loop
        winnerswinner1_held_0(i) <= paths_sum(i);
      end loop;
      winnerswinner1_best_index_0_0 <= winnerswinner1_best_index_0_choices(0, 8);
      winnerswinner1_best_place_0_2 <= winnerswinner1_best_index_0_choices(2, 8);
      winnerswinner1_best_late_cost_0(0) <= winnerswinner1_best_cost_0(0);
      winnerswinner1_best_late_cost_0(1) <= winnerswinner1_best_cost_0(1);
      winnerswinner1_best_late_cost_0(2) <= winnerswinner1_best_cost_0(2);
      winnerswinner1_best_late_cost_0(3) <= winnerswinner1_best_cost_0(3);
      winnerswinner1_best_but_first_0(0) <= winnerswinner1_held_0(1);
      winnerswinner1_best_but_first_0(1) <= winnerswinner1_held_0(3);
      winnerswinner1_best_but_first_0(2) <= winnerswinner1_held_0(5);
      winnerswinner1_best_but_first_0(3) <= winnerswinner1_held_0(7);
      winnerswinner1_best_but_last_0(0) <= winnerswinner1_held_0(0);
      winnerswinner1_best_but_last_0(1) <= winnerswinner1_held_0(2);
      winnerswinner1_best_but_last_0(2) <= winnerswinner1_held_0(4);
      winnerswinner1_best_but_last_0(3) <= winnerswinner1_held_0(6);
      for i in 0 to 3 loop
        if (paths_sum(2 * i + 1) - paths_sum(2 * i)) < 0 then
          winnerswinner1_best_cost_0(i) <= paths_sum(2 * i + 1);
        else
          winnerswinner1_best_cost_0(i) <= paths_sum(2 * i);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(1, 8) then
        winnerswinner1_best_index_0_1 <= 3;
        winnerswinner1_best_below_0(1) <= paths_sum(2);
        winnerswinner1_best_above_0(1) <= 0;
      else
        winnerswinner1_best_index_0_1 <= 2;
        winnerswinner1_best_below_0(1) <= 0;
        winnerswinner1_best_above_0(1) <= paths_sum(3);
      end if;
      if winnerswinner1_best_index_0_choices(2, 8) then
        winnerswinner1_best_index_0_2 <= 5;
        winnerswinner1_best_below_0(2) <= paths_sum(4);
        winnerswinner1_best_above_0(2) <= 0;
      else
        winnerswinner1_best_index_0_2 <= 4;
        winnerswinner1_best_below_0(2) <= 0;
        winnerswinner1_best_above_0(2) <= paths_sum(5);
      end if;
      if winnerswinner1_best_index_0_choices(3, 8) then
        winnerswinner1_best_index_0_3 <= 7;
        winnerswinner1_best_below_0(3) <= paths_sum(6);
        winnerswinner1_best_above_0(3) <= 0;
      else
        winnerswinner1_best_index_0_3 <= 6;
        winnerswinner1_best_below_0(3) <= 0;
        winnerswinner1_best_above_0(3) <= paths_sum(7);
      end if;
      if winnerswinner1_best_index_0_choices(0, 8) then
        winnerswinner1_best_below_0(0) <= paths_sum(0);
        winnerswinner1_best_above_0(0) <= 0;
      else
        winnerswinner1_best_below_0(0) <= 0;
        winnerswinner1_best_above_0(0) <= paths_sum(1);
      end if;
      -- winnerswinner2
      for i in 0 to 1 loop
        if is_set(winnerswinner1_best_cost_0(2 * i), 0) then
          winnerswinner2_best_index_0_choice(i) := (not is_set(winnerswinner1_best_cost_0(2 * i + 1), 1)) or (not
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 0));
        else
          winnerswinner2_best_index_0_choice(i) := not is_set(winnerswinner1_best_cost_0(2 * i + 1), 1);
        end if;
        if is_set(winnerswinner1_best_cost_0(2 * i), 1) then
          winnerswinner2_best_index_0_choices(i, 2) := winnerswinner2_best_index_0_choice(i);
        else
          winnerswinner2_best_index_0_choices(i, 2) := is_set(winnerswinner1_best_cost_0(2 * i), 0) and
            ((winnerswinner1_best_cost_0(2 * i + 1) mod 4) = 0);
        end if;
        winnerswinner2_best_index_0_value(i) := is_set(winnerswinner1_best_cost_0(2 * i + 1), 2);
        if winnerswinner2_best_index_0_choices(i, 2) then
          winnerswinner2_best_index_0_choices(i, 3) := (not is_set(winnerswinner1_best_cost_0(2 * i), 2)) and
            winnerswinner2_best_index_0_value(i);
        else
          winnerswinner2_best_index_0_choices(i, 3) := (not is_set(winnerswinner1_best_cost_0(2 * i), 2)) or
            winnerswinner2_best_index_0_value(i);
        end if;
        for j in 2 to 5 loop
          winnerswinner2_best_index_0_values(i, j) := is_set(winnerswinner1_best_cost_0(2 * i + 1), j + 1);
          if winnerswinner2_best_index_0_choices(i, j + 1) then
            winnerswinner2_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner1_best_cost_0(2 * i), j + 1)) or
              winnerswinner2_best_index_0_values(i, j);
          else
            winnerswinner2_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner1_best_cost_0(2 * i), j + 1)) and
              winnerswinner2_best_index_0_values(i, j);
          end if;
        end loop;
        if winnerswinner2_best_index_0_choices(i, 7) then
          winnerswinner2_best_index_0_choices(i, 8) := is_set(winnerswinner1_best_cost_0(2 * i), 7) and (not
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 7));
        else
          winnerswinner2_best_index_0_choices(i, 8) := is_set(winnerswinner1_best_cost_0(2 * i), 7) or (not
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 7));
        end if;
      end loop;
      winnerswinner2_best_below_0_is_equal(0) := winnerswinner1_best_index_0_1 = 2;
      if winnerswinner2_best_below_0_is_equal(0) then
        winnerswinner2_best_below_0_choice(0) := winnerswinner1_held_0(1);
      else
        winnerswinner2_best_below_0_choice(0) := winnerswinner1_best_below_0(1);
      end if;
      winnerswinner2_best_below_0_is_equal(1) := winnerswinner1_best_index_0_3 = 6;
      if winnerswinner2_best_below_0_is_equal(1) then
        winnerswinner2_best_below_0_choice(1) := winnerswinner1_held_0(5);
      else
        winnerswinner2_best_below_0_choice(1) := winnerswinner1_best_below_0(3);
      end if;
      if winnerswinner1_best_index_0_0 then
        winnerswinner2_best_above_0_choice(0) := winnerswinner1_held_0(2);
      else
        winnerswinner2_best_above_0_choice(0) := winnerswinner1_best_above_0(0);
      end if;
      if winnerswinner1_best_place_0_2 then
        winnerswinner2_best_above_0_choice(1) := winnerswinner1_held_0(6);
      else
        winnerswinner2_best_above_0_choice(1) := winnerswinner1_best_above_0(2);
      end if;
      for i in 0 to 1 loop
        if winnerswinner2_best_index_0_choices(i, 7) then
          winnerswinner2_best_at_start_0_choice(i) := (not is_set(winnerswinner1_best_cost_0(2 * i), 7)) or
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 7);
        else
          winnerswinner2_best_at_start_0_choice(i) := (not is_set(winnerswinner1_best_cost_0(2 * i), 7)) and
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 7);
        end if;
      end loop;
      for i in 0 to 1 loop
        if winnerswinner2_best_place_0(i) then
          winnerswinner2_best_second_0_choice(i) := 255;
        else
          winnerswinner2_best_second_0_choice(i) := winnerswinner1_best_late_cost_0(2 * i + 1);
        end if;
        if winnerswinner2_best_at_end_0(i) then
          winnerswinner2_best_second_0_choices(i, 2) := winnerswinner1_best_but_first_0(2 * i + 1);
        else
          winnerswinner2_best_second_0_choices(i, 2) := winnerswinner2_best_second_0_choice(i);
        end if;
        if winnerswinner2_best_place_0(i) then
          winnerswinner2_best_second_0_choices(i, 3) := winnerswinner1_best_late_cost_0(2 * i);
        else
          winnerswinner2_best_second_0_choices(i, 3) := 255;
        end if;
        if winnerswinner2_best_at_start_0(i) then
          winnerswinner2_best_second_0_choices(i, 4) := winnerswinner1_best_but_last_0(2 * i);
        else
          winnerswinner2_best_second_0_choices(i, 4) := winnerswinner2_best_second_0_choices(i, 3);
        end if;
      end loop;
      winnerswinner2_best_first_0(0) <= winnerswinner1_held_0(0);
      winnerswinner2_best_first_0(1) <= winnerswinner1_held_0(4);
      winnerswinner2_best_last_0(0) <= winnerswinner1_held_0(3);
      winnerswinner2_best_last_0(1) <= winnerswinner1_held_0(7);
      winnerswinner2_best_place_0(0) <= winnerswinner2_best_index_0_choices(0, 8);
      winnerswinner2_best_place_0(1) <= winnerswinner2_best_index_0_choices(1, 8);
      winnerswinner2_best_at_start_0(0) <= (not winnerswinner2_best_at_start_0_choice(0)) and
        winnerswinner2_best_below_0_is_equal(0);
      winnerswinner2_best_at_start_0(1) <= (not winnerswinner2_best_at_start_0_choice(1)) and
        winnerswinner2_best_below_0_is_equal(1);
      winnerswinner2_best_at_end_0(0) <= winnerswinner2_best_at_start_0_choice(0) and winnerswinner1_best_index_0_0;
      winnerswinner2_best_at_end_0(1) <= winnerswinner2_best_at_start_0_choice(1) and winnerswinner1_best_place_0_2;
      winnerswinner2_best_late_cost_0(0) <= winnerswinner2_best_cost_0(0);
      winnerswinner2_best_late_cost_0(1) <= winnerswinner2_best_cost_0(1);
      for i in 0 to 1 loop
        if (winnerswinner1_best_cost_0(2 * i + 1) - winnerswinner1_best_cost_0(2 * i)) < 0 then
          winnerswinner2_best_cost_0(i) <= winnerswinner1_best_cost_0(2 * i + 1);
        else
          winnerswinner2_best_cost_0(i) <= winnerswinner1_best_cost_0(2 * i);
        end if;
      end loop;
      if winnerswinner2_best_index_0_choices(0, 8) then
        winnerswinner2_best_index_0_0 <= winnerswinner1_best_index_0_1;
        winnerswinner2_best_below_0(0) <= winnerswinner2_best_below_0_choice(0);
        winnerswinner2_best_above_0(0) <= winnerswinner1_best_above_0(1);
      else
        winnerswinner2_best_index_0_0 <= as_number(winnerswinner1_best_index_0_0);
        winnerswinner2_best_below_0(0) <= winnerswinner1_best_below_0(0);
        winnerswinner2_best_above_0(0) <= winnerswinner2_best_above_0_choice(0);
      end if;
      if winnerswinner2_best_index_0_choices(1, 8) then
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_3;
        winnerswinner2_best_below_0(1) <= winnerswinner2_best_below_0_choice(1);
        winnerswinner2_best_above_0(1) <= winnerswinner1_best_above_0(3);
      else
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_2;
        winnerswinner2_best_below_0(1) <= winnerswinner1_best_below_0(2);
        winnerswinner2_best_above_0(1) <= winnerswinner2_best_above_0_choice(1);
      end if;
      for i in 0 to 1 loop
        if (winnerswinner2_best_second_0_choices(i, 2) - winnerswinner2_best_second_0_choices(i, 4)) < 0 then
          winnerswinner2_best_second_0(i) <= winnerswinner2_best_second_0_choices(i, 2);
        else
          winnerswinner2_best_second_0(i) <= winnerswinner2_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (winnerswinner1_best_late_cost_0(2 * i + 1) - winnerswinner1_best_but_first_0(2 * i)) < 0 then
          winnerswinner2_best_but_first_0(i) <= winnerswinner1_best_late_cost_0(2 * i + 1);
        else
          winnerswinner2_best_but_first_0(i) <= winnerswinner1_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (winnerswinner1_best_but_last_0(2 * i + 1) - winnerswinner1_best_late_cost_0(2 * i)) < 0 then
          winnerswinner2_best_but_last_0(i) <= winnerswinner1_best_but_last_0(2 * i + 1);
        else
          winnerswinner2_best_but_last_0(i) <= winnerswinner1_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- winnerswinner3
      if is_set(winnerswinner2_best_cost_0(0), 0) then
        winnerswinner3_best_index_0_0_choice := (not is_set(winnerswinner2_best_cost_0(1), 1)) or (not
          is_set(winnerswinner2_best_cost_0(1), 0));
      else
        winnerswinner3_best_index_0_0_choice := not is_set(winnerswinner2_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner2_best_cost_0(0), 1) then
        winnerswinner3_best_index_0_0_choices(2) := winnerswinner3_best_index_0_0_choice;
      else
        winnerswinner3_best_index_0_0_choices(2) := is_set(winnerswinner2_best_cost_0(0), 0) and
          ((winnerswinner2_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner3_best_index_0_0_value := is_set(winnerswinner2_best_cost_0(1), 2);
      if winnerswinner3_best_index_0_0_choices(2) then
        winnerswinner3_best_index_0_0_choices(3) := (not is_set(winnerswinner2_best_cost_0(0), 2)) and
          winnerswinner3_best_index_0_0_value;
      else
        winnerswinner3_best_index_0_0_choices(3) := (not is_set(winnerswinner2_best_cost_0(0), 2)) or
          winnerswinner3_best_index_0_0_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner3_best_index_0_0_values(i) := is_set(winnerswinner2_best_cost_0(1), i + 1);
        if winnerswinner3_best_index_0_0_choices(i + 1) then
          winnerswinner3_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(0), i + 1)) or
            winnerswinner3_best_index_0_0_values(i);
        else
          winnerswinner3_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(0), i + 1)) and
            winnerswinner3_best_index_0_0_values(i);
        end if;
      end loop;
      if winnerswinner3_best_index_0_0_choices(7) then
        winnerswinner3_best_index_0_0_choices(8) := is_set(winnerswinner2_best_cost_0(0), 7) and (not
          is_set(winnerswinner2_best_cost_0(1), 7));
      else
        winnerswinner3_best_index_0_0_choices(8) := is_set(winnerswinner2_best_cost_0(0), 7) or (not
          is_set(winnerswinner2_best_cost_0(1), 7));
      end if;
      winnerswinner3_best_below_0_0_is_equal := winnerswinner2_best_index_0_1 = 4;
      if winnerswinner3_best_below_0_0_is_equal then
        winnerswinner3_best_below_0_0_choice := winnerswinner2_best_last_0(0);
      else
        winnerswinner3_best_below_0_0_choice := winnerswinner2_best_below_0(1);
      end if;
      winnerswinner3_best_above_0_0_is_equal := winnerswinner2_best_index_0_0 = 3;
      if winnerswinner3_best_above_0_0_is_equal then
        winnerswinner3_best_above_0_0_choice := winnerswinner2_best_first_0(1);
      else
        winnerswinner3_best_above_0_0_choice := winnerswinner2_best_above_0(0);
      end if;
      if winnerswinner3_best_index_0_0_choices(7) then
        winnerswinner3_best_at_start_0_0_choice := (not is_set(winnerswinner2_best_cost_0(0), 7)) or
          is_set(winnerswinner2_best_cost_0(1), 7);
      else
        winnerswinner3_best_at_start_0_0_choice := (not is_set(winnerswinner2_best_cost_0(0), 7)) and
          is_set(winnerswinner2_best_cost_0(1), 7);
      end if;
      if winnerswinner3_best_place_0_0 then
        winnerswinner3_best_second_0_0_choice := winnerswinner2_best_second_0(1);
      else
        winnerswinner3_best_second_0_0_choice := winnerswinner2_best_late_cost_0(1);
      end if;
      if winnerswinner3_best_at_end_0_0 then
        winnerswinner3_best_second_0_0_choices(2) := winnerswinner2_best_but_first_0(1);
      else
        winnerswinner3_best_second_0_0_choices(2) := winnerswinner3_best_second_0_0_choice;
      end if;
      if winnerswinner3_best_place_0_0 then
        winnerswinner3_best_second_0_0_choices(3) := winnerswinner2_best_late_cost_0(0);
      else
        winnerswinner3_best_second_0_0_choices(3) := winnerswinner2_best_second_0(0);
      end if;
      if winnerswinner3_best_at_start_0_0 then
        winnerswinner3_best_second_0_0_choices(4) := winnerswinner2_best_but_last_0(0);
      else
        winnerswinner3_best_second_0_0_choices(4) := winnerswinner3_best_second_0_0_choices(3);
      end if;
      winnerswinner3_best_first_0_0 <= winnerswinner2_best_first_0(0);
      winnerswinner3_best_last_0_0 <= winnerswinner2_best_last_0(1);
      winnerswinner3_best_place_0_0 <= winnerswinner3_best_index_0_0_choices(8);
      winnerswinner3_best_at_start_0_0 <= (not winnerswinner3_best_at_start_0_0_choice) and
        winnerswinner3_best_below_0_0_is_equal;
      winnerswinner3_best_at_end_0_0 <= winnerswinner3_best_at_start_0_0_choice and
        winnerswinner3_best_above_0_0_is_equal;
      winnerswinner3_best_late_cost_0_0 <= winnerswinner3_best_cost_0_0;
      if (winnerswinner2_best_cost_0(1) - winnerswinner2_best_cost_0(0)) < 0 then
        winnerswinner3_best_cost_0_0 <= winnerswinner2_best_cost_0(1);
      else
        winnerswinner3_best_cost_0_0 <= winnerswinner2_best_cost_0(0);
      end if;
      if winnerswinner3_best_index_0_0_choices(8) then
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_1;
        winnerswinner3_best_below_0_0 <= winnerswinner3_best_below_0_0_choice;
        winnerswinner3_best_above_0_0 <= winnerswinner2_best_above_0(1);
      else
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_0;
        winnerswinner3_best_below_0_0 <= winnerswinner2_best_below_0(0);
        winnerswinner3_best_above_0_0 <= winnerswinner3_best_above_0_0_choice;
      end if;
      if (winnerswinner3_best_second_0_0_choices(2) - winnerswinner3_best_second_0_0_choices(4)) < 0 then
        winnerswinner3_best_second_0_0 <= winnerswinner3_best_second_0_0_choices(2);
      else
        winnerswinner3_best_second_0_0 <= winnerswinner3_best_second_0_0_choices(4);
      end if;
      if (winnerswinner2_best_late_cost_0(1) - winnerswinner2_best_but_first_0(0)) < 0 then
        winnerswinner3_best_but_first_0_0 <= winnerswinner2_best_late_cost_0(1);
      else
        winnerswinner3_best_but_first_0_0 <= winnerswinner2_best_but_first_0(0);
      end if;
      if (winnerswinner2_best_but_last_0(1) - winnerswinner2_best_late_cost_0(0)) < 0 then
        winnerswinner3_best_but_last_0_0 <= winnerswinner2_best_but_last_0(1);
      else
        winnerswinner3_best_but_last_0_0 <= winnerswinner2_best_late_cost_0(0);
      end if;
      -- winners
      if line_comes(26) then
        winners_best_cost_0_0_choice := 511;
      else
        winners_best_cost_0_0_choice := winners_best_cost_0_0;
      end if;
      if line_comes(26) then
        winners_best_cost_0_0_choice_2 := 255;
      else
        winners_best_cost_0_0_choice_2 := winners_best_cost_0_0;
      end if;
      winners_best_index_0_0_is_less := (winnerswinner3_best_cost_0_0 - winners_best_cost_0_0_choice) < 0;
      if winners_best_index_0_0_is_less then
        winners_best_index_0_0_choice := winnerswinner3_best_index_0_0 + 56;
      else
        winners_best_index_0_0_choice := ((((winners_best_index_0_0 / 8) + 31) mod 32) * 8) + (winners_best_index_0_0
          mod 8);
      end if;
      winners_best_below_0_0_is_equal := winnerswinner3_best_index_0_0 = 0;
      if (not line_comes(26)) and winners_best_below_0_0_is_equal then
        winners_best_below_0_0_choice := winners_best_last_0_0;
      else
        winners_best_below_0_0_choice := winnerswinner3_best_below_0_0;
      end if;
      if line_comes(26) then
        winners_best_below_0_0_choice_2 := 0;
      else
        winners_best_below_0_0_choice_2 := winners_best_below_0_0;
      end if;
      winners_best_above_0_0_is_equal := winners_best_index_0_0 = 63;
      if line_comes(26) then
        winners_best_above_0_0_choice := 0;
      else
        winners_best_above_0_0_choice := winners_best_above_0_0;
      end if;
      if winners_best_above_0_0_is_equal then
        winners_best_above_0_0_choice_2 := winnerswinner3_best_first_0_0;
      else
        winners_best_above_0_0_choice_2 := winners_best_above_0_0_choice;
      end if;
      if winners_best_place_0_0 then
        winners_best_second_0_0_choice := winnerswinner3_best_second_0_0;
      else
        winners_best_second_0_0_choice := winnerswinner3_best_late_cost_0_0;
      end if;
      if winners_best_at_end_0_0 then
        winners_best_second_0_0_choices(2) := winnerswinner3_best_but_first_0_0;
      else
        winners_best_second_0_0_choices(2) := winners_best_second_0_0_choice;
      end if;
      if line_comes(27) then
        winners_best_second_0_0_choices(3) := 255;
      else
        winners_best_second_0_0_choices(3) := winners_best_but_last_0_0;
      end if;
      if line_comes(27) then
        winners_best_second_0_0_choices(4) := 255;
      else
        winners_best_second_0_0_choices(4) := winners_best_late_cost_0_0;
      end if;
      if line_comes(27) then
        winners_best_second_0_0_choices(5) := 255;
      else
        winners_best_second_0_0_choices(5) := winners_best_second_0_0;
      end if;
      if winners_best_place_0_0 then
        winners_best_second_0_0_choices(6) := winners_best_second_0_0_choices(4);
      else
        winners_best_second_0_0_choices(6) := winners_best_second_0_0_choices(5);
      end if;
      if winners_best_at_start_0_0 then
        winners_best_second_0_0_choices(7) := winners_best_second_0_0_choices(3);
      else
        winners_best_second_0_0_choices(7) := winners_best_second_0_0_choices(6);
      end if;
      winners_partner_at_sum := winners_partner_column + 1;
      if line_places_first_column(4) then
        winners_partner_at_choice := 0;
      else
        winners_partner_at_choice := winners_partner_at_sum;
      end if;
      winners_best_index_0_0 <= winners_best_index_0_0_choice;
      winners_best_last_0_0 <= winnerswinner3_best_last_0_0;
      winners_best_place_0_0 <= winners_best_index_0_0_is_less;
      winners_best_at_start_0_0 <= (not line_comes(26)) and winners_best_below_0_0_is_equal and
        winners_best_index_0_0_is_less;
      winners_best_at_end_0_0 <= winners_best_above_0_0_is_equal and ((winnerswinner3_best_cost_0_0 -
        winners_best_cost_0_0_choice) >= 0);
      winners_best_late_cost_0_0 <= winners_best_cost_0_0;
      winners_best_tag_valid <= line_comes(33);
      winners_best_tag_map_column <= line_places_map_column(4);
      winners_best_tag_output_column <= line_places_shown_output_column(4);
      winners_best_tag_start_of_frame <= line_places_shown_start_of_frame(4);
      winners_best_tag_end_of_line <= line_places_shown_end_of_line(4);
      winners_partner_at <= winners_partner_at_choice + winners_best_index_0_0_choice;
      if (winners_best_cost_0_0_choice - winnerswinner3_best_cost_0_0) < 0 then
        winners_best_cost_0_0 <= winners_best_cost_0_0_choice_2;
      else
        winners_best_cost_0_0 <= winnerswinner3_best_cost_0_0;
      end if;
      if winners_best_index_0_0_is_less then
        winners_best_below_0_0 <= winners_best_below_0_0_choice;
        winners_best_above_0_0 <= winnerswinner3_best_above_0_0;
      else
        winners_best_below_0_0 <= winners_best_below_0_0_choice_2;
        winners_best_above_0_0 <= winners_best_above_0_0_choice_2;
      end if;
      if (winners_best_second_0_0_choices(2) - winners_best_second_0_0_choices(7)) < 0 then
        winners_best_second_0_0 <= winners_best_second_0_0_choices(2);
      else
        winners_best_second_0_0 <= winners_best_second_0_0_choices(7);
      end if;
      if (winnerswinner3_best_but_last_0_0 - winners_best_second_0_0_choices(4)) < 0 then
        winners_best_but_last_0_0 <= winnerswinner3_best_but_last_0_0;
      else
        winners_best_but_last_0_0 <= winners_best_second_0_0_choices(4);
      end if;
      if line_comes(33) then
        if line_places_first_column(4) then
          winners_partner_column <= 0;
        else
          winners_partner_column <= winners_partner_at_sum mod 1024;
        end if;
      end if;
      -- other
      if other_read_count_phase = 7 then
        other_read_count_phase_choice := 7;
      else
        other_read_count_phase_choice := (other_read_count_phase + 1) mod 8;
      end if;
      if other_count_phase = 7 then
        other_count_phase_choice := 7;
      else
        other_count_phase_choice := (other_count_phase + 1) mod 8;
      end if;
      if line_comes(22) then
        other_base_choice := 0;
      else
        other_base_choice := ((other_base / 8) + 1) mod 32;
      end if;
      if other_write_count_phase = 7 then
        other_write_count_phase_choice := 7;
      else
        other_write_count_phase_choice := (other_write_count_phase + 1) mod 8;
      end if;
      other_0_is_equal := fill_ready_column = 0;
      other_4_difference := 0 - (refinement_quotient_8_0 / 16);
      other_4_value := (refinement_quotient_8_0 + 15) / 16;
      if refinement_negative_0(8) then
        other_4_choice := other_4_difference mod 256;
      else
        other_4_choice := other_4_value;
      end if;
      if refinement_negative_0(8) then
        other_4_choice_2 := other_4_difference mod 8;
      else
        other_4_choice_2 := other_4_value mod 8;
      end if;
      for i in 5 to 10 loop
        other_difference(i) := ((refinement_remainder_0(11 - i) * 2) + 512) - refinement_divisor_0(11 - i);
      end loop;
      other_11_difference := (refinement_remainder_0_0 + 512) - refinement_divisor_0(0);
      other_12_any := line_comes(23) or (not is_set(other_write_count_phase, 2)) or (not
        is_set(other_write_count_phase, 1)) or (not is_set(other_write_count_phase, 0));
      if is_set(paths_sum(5), 0) then
        other_choice(12) := (not (other_words(1)(17) = '1')) or (not (other_words(1)(16) = '1'));
      else
        other_choice(12) := not (other_words(1)(17) = '1');
      end if;
      if winnerswinner1_best_index_0_value(2) then
        other_12_choices(2) := other_choice(12);
      else
        other_12_choices(2) := is_set(paths_sum(5), 0) and (to_integer(other_words(1)(17 downto 16)) = 0);
      end if;
      other_value(12) := other_words(1)(18) = '1';
      if other_12_choices(2) then
        other_12_choices(3) := (not is_set(paths_sum(5), 2)) and other_value(12);
      else
        other_12_choices(3) := (not is_set(paths_sum(5), 2)) or other_value(12);
      end if;
      for i in 2 to 5 loop
        other_12_values(i) := other_words(1)(i + 17) = '1';
        if other_12_choices(i + 1) then
          other_12_choices(i + 2) := (not is_set(paths_sum(5), i + 1)) or other_12_values(i);
        else
          other_12_choices(i + 2) := (not is_set(paths_sum(5), i + 1)) and other_12_values(i);
        end if;
      end loop;
      if is_set(paths_sum(5), 7) then
        other_12_choices(8) := not other_first_column;
      else
        other_12_choices(8) := (not (other_words(1)(23) = '1')) and (not other_first_column);
      end if;
      if other_12_choices(7) then
        other_12_choices(9) := is_set(paths_sum(5), 7) and (not (other_words(1)(23) = '1')) and (not
          other_first_column);
      else
        other_12_choices(9) := other_12_choices(8);
      end if;
      other_all(12) := (not other_12_choices(9)) and winnersmask_inside(5) and other_output_column;
      other_12_value_6 := (other_base / 8) * 8;
      if other_all(12) then
        other_12_choices_from_10(10) := other_12_value_6 + 5;
      else
        other_12_choices_from_10(10) := to_integer(other_words(3)(23 downto 16));
      end if;
      if other_12_any then
        other_12_choices_from_10(11) := other_12_choices_from_10(10);
      else
        other_12_choices_from_10(11) := to_integer(other(12)(15 downto 8));
      end if;
      if is_set(paths_sum(4), 0) then
        other_12_choices_from_12(12) := (not (other_words(1)(9) = '1')) or (not (other_words(1)(8) = '1'));
      else
        other_12_choices_from_12(12) := not (other_words(1)(9) = '1');
      end if;
      if winnerswinner1_best_index_0_values(2, 2) then
        other_12_choices_from_12(13) := other_12_choices_from_12(12);
      else
        other_12_choices_from_12(13) := is_set(paths_sum(4), 0) and (to_integer(other_words(1)(9 downto 8)) = 0);
      end if;
      other_12_values_from_7(7) := other_words(1)(10) = '1';
      if other_12_choices_from_12(13) then
        other_12_choices_from_12(14) := (not winnerswinner1_best_index_0_values(2, 3)) and other_12_values_from_7(7);
      else
        other_12_choices_from_12(14) := (not winnerswinner1_best_index_0_values(2, 3)) or other_12_values_from_7(7);
      end if;
      for i in 8 to 11 loop
        other_12_values_from_7(i) := other_words(1)(i + 3) = '1';
        if other_12_choices_from_12(i + 6) then
          other_12_choices_from_12(i + 7) := (not winnerswinner1_best_index_0_values(2, i - 4)) or
            other_12_values_from_7(i);
        else
          other_12_choices_from_12(i + 7) := (not winnerswinner1_best_index_0_values(2, i - 4)) and
            other_12_values_from_7(i);
        end if;
      end loop;
      if is_set(paths_sum(4), 7) then
        other_12_choices_from_12(19) := not other_first_column;
      else
        other_12_choices_from_12(19) := (not (other_words(1)(15) = '1')) and (not other_first_column);
      end if;
      if other_12_choices_from_12(18) then
        other_12_choices_from_12(20) := is_set(paths_sum(4), 7) and (not (other_words(1)(15) = '1')) and (not
          other_first_column);
      else
        other_12_choices_from_12(20) := other_12_choices_from_12(19);
      end if;
      other_12_alls(2) := (not other_12_choices_from_12(20)) and winnersmask_inside(4) and other_output_column;
      if other_12_alls(2) then
        other_12_choices_from_21(21) := other_12_value_6 + 4;
      else
        other_12_choices_from_21(21) := to_integer(other_words(3)(15 downto 8));
      end if;
      if other_12_any then
        other_12_choices_from_21(22) := other_12_choices_from_21(21);
      else
        other_12_choices_from_21(22) := to_integer(other(12)(7 downto 0));
      end if;
      if is_set(paths_sum(6), 0) then
        other_12_choices_from_23(23) := (not (other_words(1)(25) = '1')) or (not (other_words(1)(24) = '1'));
      else
        other_12_choices_from_23(23) := not (other_words(1)(25) = '1');
      end if;
      if winnerswinner1_best_index_0_values(3, 2) then
        other_12_choices_from_23(24) := other_12_choices_from_23(23);
      else
        other_12_choices_from_23(24) := is_set(paths_sum(6), 0) and (to_integer(other_words(1)(25 downto 24)) = 0);
      end if;
      other_12_values_from_7(12) := other_words(1)(26) = '1';
      if other_12_choices_from_23(24) then
        other_12_choices_from_23(25) := (not winnerswinner1_best_index_0_values(3, 3)) and other_12_values_from_7(12);
      else
        other_12_choices_from_23(25) := (not winnerswinner1_best_index_0_values(3, 3)) or other_12_values_from_7(12);
      end if;
      for i in 13 to 16 loop
        other_12_values_from_7(i) := other_words(1)(i + 14) = '1';
        if other_12_choices_from_23(i + 12) then
          other_12_choices_from_23(i + 13) := (not winnerswinner1_best_index_0_values(3, i - 9)) or
            other_12_values_from_7(i);
        else
          other_12_choices_from_23(i + 13) := (not winnerswinner1_best_index_0_values(3, i - 9)) and
            other_12_values_from_7(i);
        end if;
      end loop;
      if is_set(paths_sum(6), 7) then
        other_12_choices_from_23(30) := not other_first_column;
      else
        other_12_choices_from_23(30) := (not (other_words(1)(31) = '1')) and (not other_first_column);
      end if;
      if other_12_choices_from_23(29) then
        other_12_choices_from_23(31) := is_set(paths_sum(6), 7) and (not (other_words(1)(31) = '1')) and (not
          other_first_column);
      else
        other_12_choices_from_23(31) := other_12_choices_from_23(30);
      end if;
      other_12_alls(3) := (not other_12_choices_from_23(31)) and winnersmask_inside(6) and other_output_column;
      if other_12_alls(3) then
        other_12_choices_from_32(32) := other_12_value_6 + 6;
      else
        other_12_choices_from_32(32) := to_integer(other_words(3)(31 downto 24));
      end if;
      if other_12_any then
        other_12_choices_from_32(33) := other_12_choices_from_32(32);
      else
        other_12_choices_from_32(33) := to_integer(other(12)(23 downto 16));
      end if;
      if is_set(paths_sum(7), 0) then
        other_12_choices_from_34(34) := (not (other_next_words(0)(1) = '1')) or (not (other_next_words(0)(0) = '1'));
      else
        other_12_choices_from_34(34) := not (other_next_words(0)(1) = '1');
      end if;
      if winnerswinner1_best_index_0_value(3) then
        other_12_choices_from_34(35) := other_12_choices_from_34(34);
      else
        other_12_choices_from_34(35) := is_set(paths_sum(7), 0) and (to_integer(other_next_words(0)(1 downto 0)) = 0);
      end if;
      other_12_values_from_7(17) := other_next_words(0)(2) = '1';
      if other_12_choices_from_34(35) then
        other_12_choices_from_34(36) := (not is_set(paths_sum(7), 2)) and other_12_values_from_7(17);
      else
        other_12_choices_from_34(36) := (not is_set(paths_sum(7), 2)) or other_12_values_from_7(17);
      end if;
      for i in 18 to 21 loop
        other_12_values_from_7(i) := other_next_words(0)(i - 15) = '1';
        if other_12_choices_from_34(i + 18) then
          other_12_choices_from_34(i + 19) := (not is_set(paths_sum(7), i - 15)) or other_12_values_from_7(i);
        else
          other_12_choices_from_34(i + 19) := (not is_set(paths_sum(7), i - 15)) and other_12_values_from_7(i);
        end if;
      end loop;
      other_12_differs := other_count_phase /= 7;
      if other_12_choices_from_34(40) then
        other_12_choices_from_34(41) := other_12_differs and is_set(paths_sum(7), 7) and (not (other_next_words(0)(7) =
          '1'));
      else
        other_12_choices_from_34(41) := other_12_differs and (is_set(paths_sum(7), 7) or (not (other_next_words(0)(7) =
          '1')));
      end if;
      if other_12_choices_from_34(41) then
        other_12_choices_from_34(42) := winnersmask_inside(7) and other_output_column and other_first_column;
      else
        other_12_choices_from_34(42) := winnersmask_inside(7) and other_output_column;
      end if;
      if other_12_choices_from_34(42) then
        other_12_choices_from_43(43) := other_12_value_6 + 7;
      else
        other_12_choices_from_43(43) := to_integer(other_next_words(2)(7 downto 0));
      end if;
      if other_12_any then
        other_12_choices_from_43(44) := other_12_choices_from_43(43);
      else
        other_12_choices_from_43(44) := to_integer(other(12)(31 downto 24));
      end if;
      if is_set(paths_sum(1), 0) then
        other_choice(13) := (not (other_words(0)(17) = '1')) or (not (other_words(0)(16) = '1'));
      else
        other_choice(13) := not (other_words(0)(17) = '1');
      end if;
      if winnerswinner1_best_index_0_value(0) then
        other_13_choices(2) := other_choice(13);
      else
        other_13_choices(2) := is_set(paths_sum(1), 0) and (to_integer(other_words(0)(17 downto 16)) = 0);
      end if;
      other_value(13) := other_words(0)(18) = '1';
      if other_13_choices(2) then
        other_13_choices(3) := (not is_set(paths_sum(1), 2)) and other_value(13);
      else
        other_13_choices(3) := (not is_set(paths_sum(1), 2)) or other_value(13);
      end if;
      for i in 2 to 5 loop
        other_13_values(i) := other_words(0)(i + 17) = '1';
        if other_13_choices(i + 1) then
          other_13_choices(i + 2) := (not is_set(paths_sum(1), i + 1)) or other_13_values(i);
        else
          other_13_choices(i + 2) := (not is_set(paths_sum(1), i + 1)) and other_13_values(i);
        end if;
      end loop;
      if is_set(paths_sum(1), 7) then
        other_13_choices(8) := not other_first_column;
      else
        other_13_choices(8) := (not (other_words(0)(23) = '1')) and (not other_first_column);
      end if;
      if other_13_choices(7) then
        other_13_choices(9) := is_set(paths_sum(1), 7) and (not (other_words(0)(23) = '1')) and (not
          other_first_column);
      else
        other_13_choices(9) := other_13_choices(8);
      end if;
      other_all(13) := (not other_13_choices(9)) and winnersmask_inside(1) and other_output_column;
      if other_all(13) then
        other_13_choices_from_10(10) := other_12_value_6 + 1;
      else
        other_13_choices_from_10(10) := to_integer(other_words(2)(23 downto 16));
      end if;
      if other_12_any then
        other_13_choices_from_10(11) := other_13_choices_from_10(10);
      else
        other_13_choices_from_10(11) := to_integer(other(13)(15 downto 8));
      end if;
      if is_set(paths_sum(0), 0) then
        other_13_choices_from_12(12) := (not (other_words(0)(9) = '1')) or (not (other_words(0)(8) = '1'));
      else
        other_13_choices_from_12(12) := not (other_words(0)(9) = '1');
      end if;
      if winnerswinner1_best_index_0_values(0, 2) then
        other_13_choices_from_12(13) := other_13_choices_from_12(12);
      else
        other_13_choices_from_12(13) := is_set(paths_sum(0), 0) and (to_integer(other_words(0)(9 downto 8)) = 0);
      end if;
      other_13_values(6) := other_words(0)(10) = '1';
      if other_13_choices_from_12(13) then
        other_13_choices_from_12(14) := (not winnerswinner1_best_index_0_values(0, 3)) and other_13_values(6);
      else
        other_13_choices_from_12(14) := (not winnerswinner1_best_index_0_values(0, 3)) or other_13_values(6);
      end if;
      for i in 7 to 10 loop
        other_13_values(i) := other_words(0)(i + 4) = '1';
        if other_13_choices_from_12(i + 7) then
          other_13_choices_from_12(i + 8) := (not winnerswinner1_best_index_0_values(0, i - 3)) or other_13_values(i);
        else
          other_13_choices_from_12(i + 8) := (not winnerswinner1_best_index_0_values(0, i - 3)) and other_13_values(i);
        end if;
      end loop;
      if other_13_choices_from_12(18) then
        other_13_choices_from_12(19) := (not other_first_column) and is_set(paths_sum(0), 7) and (not
          (other_words(0)(15) = '1'));
      else
        other_13_choices_from_12(19) := (not other_first_column) and (is_set(paths_sum(0), 7) or (not
          (other_words(0)(15) = '1')));
      end if;
      other_13_alls(2) := (not other_13_choices_from_12(19)) and winnersmask_inside(0) and other_output_column;
      if other_13_alls(2) then
        other_13_choices_from_20(20) := other_base;
      else
        other_13_choices_from_20(20) := to_integer(other_words(2)(15 downto 8));
      end if;
      if other_12_any then
        other_13_choices_from_20(21) := other_13_choices_from_20(20);
      else
        other_13_choices_from_20(21) := to_integer(other(13)(7 downto 0));
      end if;
      if is_set(paths_sum(2), 0) then
        other_13_choices_from_22(22) := (not (other_words(0)(25) = '1')) or (not (other_words(0)(24) = '1'));
      else
        other_13_choices_from_22(22) := not (other_words(0)(25) = '1');
      end if;
      if winnerswinner1_best_index_0_values(1, 2) then
        other_13_choices_from_22(23) := other_13_choices_from_22(22);
      else
        other_13_choices_from_22(23) := is_set(paths_sum(2), 0) and (to_integer(other_words(0)(25 downto 24)) = 0);
      end if;
      other_13_values(11) := other_words(0)(26) = '1';
      if other_13_choices_from_22(23) then
        other_13_choices_from_22(24) := (not winnerswinner1_best_index_0_values(1, 3)) and other_13_values(11);
      else
        other_13_choices_from_22(24) := (not winnerswinner1_best_index_0_values(1, 3)) or other_13_values(11);
      end if;
      for i in 12 to 15 loop
        other_13_values(i) := other_words(0)(i + 15) = '1';
        if other_13_choices_from_22(i + 12) then
          other_13_choices_from_22(i + 13) := (not winnerswinner1_best_index_0_values(1, i - 8)) or other_13_values(i);
        else
          other_13_choices_from_22(i + 13) := (not winnerswinner1_best_index_0_values(1, i - 8)) and other_13_values(i);
        end if;
      end loop;
      if is_set(paths_sum(2), 7) then
        other_13_choices_from_22(29) := not other_first_column;
      else
        other_13_choices_from_22(29) := (not (other_words(0)(31) = '1')) and (not other_first_column);
      end if;
      if other_13_choices_from_22(28) then
        other_13_choices_from_22(30) := is_set(paths_sum(2), 7) and (not (other_words(0)(31) = '1')) and (not
          other_first_column);
      else
        other_13_choices_from_22(30) := other_13_choices_from_22(29);
      end if;
      other_13_alls(3) := (not other_13_choices_from_22(30)) and winnersmask_inside(2) and other_output_column;
      if other_13_alls(3) then
        other_13_choices_from_31(31) := other_12_value_6 + 2;
      else
        other_13_choices_from_31(31) := to_integer(other_words(2)(31 downto 24));
      end if;
      if other_12_any then
        other_13_choices_from_31(32) := other_13_choices_from_31(31);
      else
        other_13_choices_from_31(32) := to_integer(other(13)(23 downto 16));
      end if;
      if is_set(paths_sum(3), 0) then
        other_13_choices_from_33(33) := (not (other_words(1)(1) = '1')) or (not (other_words(1)(0) = '1'));
      else
        other_13_choices_from_33(33) := not (other_words(1)(1) = '1');
      end if;
      if winnerswinner1_best_index_0_value(1) then
        other_13_choices_from_33(34) := other_13_choices_from_33(33);
      else
        other_13_choices_from_33(34) := is_set(paths_sum(3), 0) and (to_integer(other_words(1)(1 downto 0)) = 0);
      end if;
      other_13_values(16) := other_words(1)(2) = '1';
      if other_13_choices_from_33(34) then
        other_13_choices_from_33(35) := (not is_set(paths_sum(3), 2)) and other_13_values(16);
      else
        other_13_choices_from_33(35) := (not is_set(paths_sum(3), 2)) or other_13_values(16);
      end if;
      for i in 17 to 20 loop
        other_13_values(i) := other_words(1)(i - 14) = '1';
        if other_13_choices_from_33(i + 18) then
          other_13_choices_from_33(i + 19) := (not is_set(paths_sum(3), i - 14)) or other_13_values(i);
        else
          other_13_choices_from_33(i + 19) := (not is_set(paths_sum(3), i - 14)) and other_13_values(i);
        end if;
      end loop;
      if is_set(paths_sum(3), 7) then
        other_13_choices_from_33(40) := not other_first_column;
      else
        other_13_choices_from_33(40) := (not (other_words(1)(7) = '1')) and (not other_first_column);
      end if;
      if other_13_choices_from_33(39) then
        other_13_choices_from_33(41) := is_set(paths_sum(3), 7) and (not (other_words(1)(7) = '1')) and (not
          other_first_column);
      else
        other_13_choices_from_33(41) := other_13_choices_from_33(40);
      end if;
      other_13_alls(4) := (not other_13_choices_from_33(41)) and winnersmask_inside(3) and other_output_column;
      if other_13_alls(4) then
        other_13_choices_from_42(42) := other_12_value_6 + 3;
      else
        other_13_choices_from_42(42) := to_integer(other_words(3)(7 downto 0));
      end if;
      if other_12_any then
        other_13_choices_from_42(43) := other_13_choices_from_42(42);
      else
        other_13_choices_from_42(43) := to_integer(other(13)(31 downto 24));
      end if;
      if other_all(12) then
        other_choices(14) := paths_sum(5);
      else
        other_choices(14) := to_integer(other_words(1)(23 downto 16));
      end if;
      if other_12_any then
        other_choices_from_14(14, 2) := other_choices(14);
      else
        other_choices_from_14(14, 2) := to_integer(other(14)(15 downto 8));
      end if;
      for i in 2 to 3 loop
        if other_12_alls(i) then
          other_choices_from_14(14, 2 * i - 1) := paths_sum(2 * i);
        else
          other_choices_from_14(14, 2 * i - 1) := to_integer(other_words(1)(16 * i - 17 downto 16 * i - 24));
        end if;
        if other_12_any then
          other_choices_from_14(14, 2 * i) := other_choices_from_14(14, 2 * i - 1);
        else
          other_choices_from_14(14, 2 * i) := to_integer(other(14)(16 * i - 25 downto 16 * i - 32));
        end if;
      end loop;
      if other_12_choices_from_34(42) then
        other_choices_from_14(14, 7) := paths_sum(7);
      else
        other_choices_from_14(14, 7) := to_integer(other_next_words(0)(7 downto 0));
      end if;
      if other_12_any then
        other_choices_from_14(14, 8) := other_choices_from_14(14, 7);
      else
        other_choices_from_14(14, 8) := to_integer(other(14)(31 downto 24));
      end if;
      if other_all(13) then
        other_choices(15) := paths_sum(1);
      else
        other_choices(15) := to_integer(other_words(0)(23 downto 16));
      end if;
      if other_12_any then
        other_choices_from_14(15, 2) := other_choices(15);
      else
        other_choices_from_14(15, 2) := to_integer(other(15)(15 downto 8));
      end if;
      for i in 2 to 3 loop
        if other_13_alls(i) then
          other_choices_from_14(15, 2 * i - 1) := paths_sum(2 * i - 4);
        else
          other_choices_from_14(15, 2 * i - 1) := to_integer(other_words(0)(16 * i - 17 downto 16 * i - 24));
        end if;
        if other_12_any then
          other_choices_from_14(15, 2 * i) := other_choices_from_14(15, 2 * i - 1);
        else
          other_choices_from_14(15, 2 * i) := to_integer(other(15)(16 * i - 25 downto 16 * i - 32));
        end if;
      end loop;
      if other_13_alls(4) then
        other_choices_from_14(15, 7) := paths_sum(3);
      else
        other_choices_from_14(15, 7) := to_integer(other_words(1)(7 downto 0));
      end if;
      if other_12_any then
        other_choices_from_14(15, 8) := other_choices_from_14(15, 7);
      else
        other_choices_from_14(15, 8) := to_integer(other(15)(31 downto 24));
      end if;
      other_words(0) <= other_next_words(0);
      other_words(1) <= other_next_words(1);
      other_words(2) <= other_next_words(2);
      other_words(3) <= other_next_words(3);
      other_base <= other_base_choice * 8;
      other_0 <= other_0_is_equal;
      other_1 <= ((median_rows_ready_words_0 mod 8192) / 2) * 2;
      other_2 <= support_centre_rest_0(2) mod 16;
      other_3 <= support_centre_0(2) mod 64;
      other_4 <= ((((other_4_choice / 8) + 1) mod 4) * 8) + other_4_choice_2;
      other_5 <= ((other_difference(5) / 512) * 2) + ((other_6 / 4) * 4);
      other_6 <= ((other_difference(6) / 512) * 4) + ((other_7 / 8) * 8);
      other_7 <= ((other_difference(7) / 512) * 8) + ((other_8 / 16) * 16);
      other_8 <= ((other_difference(8) / 512) * 16) + ((other_9 / 32) * 32);
      other_9 <= ((other_difference(9) / 512) * 32) + ((other_10 / 64) * 64);
      other_10 <= ((other_difference(10) / 512) * 64) + ((other_11 / 128) * 128);
      other_11 <= (other_11_difference / 512) * 128;
      other(12) <= to_unsigned(other_12_choices_from_43(44), 8) & to_unsigned(other_12_choices_from_32(33), 8) &
        to_unsigned(other_12_choices_from_10(11), 8) & to_unsigned(other_12_choices_from_21(22), 8);
      other(13) <= to_unsigned(other_13_choices_from_42(43), 8) & to_unsigned(other_13_choices_from_31(32), 8) &
        to_unsigned(other_13_choices_from_10(11), 8) & to_unsigned(other_13_choices_from_20(21), 8);
      other(14) <= to_unsigned(other_choices_from_14(14, 8), 8) & to_unsigned(other_choices_from_14(14, 6), 8) &
        to_unsigned(other_choices_from_14(14, 2), 8) & to_unsigned(other_choices_from_14(14, 4), 8);
      other(15) <= to_unsigned(other_choices_from_14(15, 8), 8) & to_unsigned(other_choices_from_14(15, 6), 8) &
        to_unsigned(other_choices_from_14(15, 2), 8) & to_unsigned(other_choices_from_14(15, 4), 8);
      if line_comes(20) then
        other_read_count_phase <= 0;
      else
        other_read_count_phase <= other_read_count_phase_choice;
      end if;
      if line_comes(22) then
        other_count_phase <= 0;
      else
        other_count_phase <= other_count_phase_choice;
      end if;
      if line_comes(23) then
        other_write_count_phase <= 0;
      else
        other_write_count_phase <= other_write_count_phase_choice;
      end if;
      if line_comes(22) then
        other_first_column <= line_places_first_column(2);
        other_output_column <= line_places_shown_output_column(2);
      end if;
      if other_write_count_phase = 0 then
        other_left <= to_integer(other(13)(7 downto 0));
      end if;
      -- refinement
      refinement_below_0_differs := winners_best_index_0_0 /= 0;
      refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
      if refinement_divisor_0_0_is_less then
        refinement_divisor_0_0_choice := refinement_v_0;
      else
        refinement_divisor_0_0_choice := refinement_u_0;
      end if;
      refinement_disparity_0(0) <= winners_best_index_0_0;
      for i in 1 to 11 loop
        refinement_disparity_0(i) <= refinement_disparity_0(i - 1);
      end loop;
      refinement_passed_0(0) <= winners_partner_at < 638;
      for i in 1 to 11 loop
        refinement_passed_0(i) <= refinement_passed_0(i - 1);
      end loop;
      refinement_tag_valid(0) <= winners_best_tag_valid;
      refinement_tag_map_column(0) <= winners_best_tag_map_column;
      refinement_tag_output_column(0) <= winners_best_tag_output_column;
      refinement_tag_start_of_frame(0) <= winners_best_tag_start_of_frame;
      refinement_tag_end_of_line(0) <= winners_best_tag_end_of_line;
      for i in 1 to 11 loop
        refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
        refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
        refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
        refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
        refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
      end loop;
      refinement_alone_0_0 <= winners_best_second_0_0 = 255;
      refinement_gap_0 <= (winners_best_second_0_0 - winners_best_late_cost_0_0) mod 256;
      refinement_scaled_cost <= median_read_bottom;
      for i in 1 to 9 loop
        refinement_margin_0(i) <= refinement_margin_0(i - 1);
      end loop;
      refinement_u_0 <= (refinement_below_0 - winners_best_late_cost_0_0) mod 256;
      refinement_v_0 <= (refinement_above_0 - winners_best_late_cost_0_0) mod 256;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 8)) or
        (to_unsigned(as_number(((refinement_v_0 = 0) and (refinement_u_0 = 0))), 8))));
      for i in 1 to 7 loop
        refinement_divisor_0(i) <= refinement_divisor_0(i - 1);
      end loop;
      refinement_quotient_8_0 <= ((((refinement_remainder_0(7) * 2) + 512) - refinement_divisor_0(7)) / 512) +
        ((other_5 / 2) * 2);
      refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
      for i in 1 to 8 loop
        refinement_negative_0(i) <= refinement_negative_0(i - 1);
      end loop;
      if (not refinement_alone_0_0) and ((refinement_gap_0 / 64) = 0) then
        refinement_margin_0(0) <= refinement_gap_0 mod 64;
      else
        refinement_margin_0(0) <= 63;
      end if;
      if refinement_below_0_differs then
        refinement_below_0 <= winners_best_below_0_0;
      else
        refinement_below_0 <= winners_best_above_0_0;
      end if;
      if refinement_below_0_differs and winners_best_above_0_0_is_equal then
        refinement_above_0 <= winners_best_below_0_0;
      else
        refinement_above_0 <= winners_best_above_0_0;
      end if;
      if is_set(other_11_difference, 9) then
        refinement_remainder_0(1) <= other_11_difference mod 256;
      else
        refinement_remainder_0(1) <= refinement_remainder_0_0;
      end if;
      for i in 2 to 7 loop
        if is_set(other_difference(12 - i), 9) then
          refinement_remainder_0(i) <= other_difference(12 - i) mod 256;
        else
          refinement_remainder_0(i) <= (refinement_remainder_0(i - 1) mod 128) * 2;
        end if;
      end loop;
      if in_valid then
        if in_start_of_frame then
          refinement_scaled_gap <= transform_counter_next_frame;
        else
          refinement_scaled_gap <= transform_counter_frame_joins;
        end if;
      end if;
      -- leftright
      if (not is_set(leftright_ring_read_address, 5)) and ((leftright_ring_read_address mod 8) = 0) then
        leftright_holds_winners_choice := (not leftright_holds_winners) and (is_set(leftright_ring_read_address, 4) or
          is_set(leftright_ring_read_address, 3));
      else
        leftright_holds_winners_choice := not leftright_holds_winners;
      end if;
      leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
      leftright_other_0(0) <= other_left;
      for i in 1 to 14 loop
        leftright_other_0(i) <= leftright_other_0(i - 1);
      end loop;
      leftright_position <= (leftright_position + as_number(refinement_tag_valid(11))) mod 128;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_choice) and refinement_tag_valid(11);
      leftright_address_0 <= (to_integer(leftright_held_0(17 downto 4)) + leftright_held_position + 65) mod 128;
      leftright_asking_disparity_0 <= to_integer(leftright_held_0(11 downto 4));
      leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
      leftright_asking_passed_0 <= leftright_held_0(12) = '1';
      leftright_asking_margin_0 <= to_integer(leftright_held_1);
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_map_column <= leftright_held_0(0) = '1';
      leftright_asking_tag_output_column <= leftright_held_0(1) = '1';
      leftright_asking_tag_start_of_frame <= leftright_held_0(2) = '1';
      leftright_asking_tag_end_of_line <= leftright_held_0(3) = '1';
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_fraction_0 <= leftright_asking_fraction_0;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_margin_0 <= leftright_asking_margin_0;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_map_column <= leftright_asking_tag_map_column;
      leftright_answered_tag_output_column <= leftright_asking_tag_output_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_fraction_0 <= leftright_answered_fraction_0;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
        (leftright_checked_passed_0_difference < 3);
      leftright_checked_margin_0 <= leftright_answered_margin_0;
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_map_column <= leftright_answered_tag_map_column;
      leftright_checked_tag_output_column <= leftright_answered_tag_output_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if leftright_holds_winners_choice then
        leftright_holds_winners <= (not refinement_tag_valid(11)) and leftright_holds_winners;
      else
        leftright_holds_winners <= refinement_tag_valid(11) or leftright_holds_winners;
      end if;
      if refinement_tag_valid(11) then
        leftright_ring_write_address <= leftright_ring_read_address;
        if leftright_ring_read_address = 63 then
          leftright_ring_read_address <= 0;
        else
          leftright_ring_read_address <= (leftright_ring_read_address + 1) mod 64;
        end if;
      end if;
      -- turn
      turn_order_address_any := turn_order_inside or (not leftright_checked_tag_map_column) or (not
        leftright_checked_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 1023;
      else
        turn_order_address_choice := 1;
      end if;
      if turn_order_falls then
        turn_order_address_choice_2 := 0;
      else
        turn_order_address_choice_2 := 637;
      end if;
      turn_order_address_any_2 := (not leftright_checked_tag_map_column) or (not leftright_checked_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 1024;
        else
          turn_order_address <= turn_order_address_choice_2;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and leftright_checked_tag_map_column and
        leftright_checked_tag_valid;
      turn_order_complete_all := leftright_checked_tag_map_column and leftright_checked_tag_valid;
      turn_ready_tag_row_start_differs := support_counter_group /= 482;
      turn_ready_tag_row_start_is_equal := support_counter_column = 637;
      if turn_ready_tag_row_start_is_equal then
        turn_ready_tag_row_start_choice := (support_counter_group /= 481) and turn_ready_tag_row_start;
      else
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start;
      end if;
      if turn_ready_tag_row_start_differs then
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start_choice;
      else
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start;
      end if;
      turn_ready_tag_row_start_is_equal_2 := support_counter_group = 479;
      turn_ready_tag_row_start_all := turn_ready_tag_row_start_is_equal_2 and turn_ready_tag_row_start_is_equal;
      if turn_ready_tag_row_start_choices(2) then
        turn_ready_tag_row_start_choices(3) := (not turn_ready_tag_start_of_frame) or turn_ready_tag_row_start_all;
      else
        turn_ready_tag_row_start_choices(3) := turn_ready_tag_start_of_frame and turn_ready_tag_row_start_is_equal_2
          and turn_ready_tag_row_start_is_equal;
      end if;
      turn_ready_tag_row_start_all_2 := turn_ready_tag_map_column and turn_ready_tag_valid;
      turn_order_turned_valid <= leftright_checked_tag_valid;
      turn_order_turned_map_column <= leftright_checked_tag_map_column;
      turn_order_turned_start_of_frame <= (not turn_order_inside) and leftright_checked_tag_map_column and
        leftright_checked_tag_valid and turn_order_first and turn_order_output and turn_order_complete;
      turn_order_turned_end_of_line <= leftright_checked_tag_end_of_line;
      turn_newest <= (leftright_checked_fraction_0 * 512) + leftright_checked_disparity_0 +
        (as_number(leftright_checked_passed_0) * 256) + (leftright_checked_margin_0 * 16384);
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
      if leftright_checked_tag_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if turn_comes then
        turn_write_place <= turn_order_address;
      else
        turn_write_place <= 638;
      end if;
      if turn_ready_tag_row_start_choices(3) then
        turn_ready_tag_row_start <= turn_ready_tag_row_start or turn_ready_tag_row_start_all_2;
      else
        turn_ready_tag_row_start <= turn_ready_tag_row_start and ((not turn_ready_tag_map_column) or (not
          turn_ready_tag_valid));
      end if;
      if leftright_checked_tag_valid then
        turn_order_inside <= leftright_checked_tag_map_column;
      end if;
      if turn_order_falls_all then
        turn_order_output <= leftright_checked_tag_output_column;
        turn_order_first <= leftright_checked_tag_start_of_frame;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
      end if;
      -- support
      if turn_ready_tag_row_start_all_2 then
        if turn_ready_tag_start_of_frame or turn_ready_tag_row_start_is_equal then
          support_counter_column <= 0;
        else
          support_counter_column <= (support_counter_column + 1) mod 1024;
        end if;
      end if;
      if turn_ready_tag_row_start_all then
        support_counter_group_choice := 15;
      else
        support_counter_group_choice := 0;
      end if;
      if (support_counter_group = 481) and turn_ready_tag_row_start then
        support_counter_group_choices(2) := 2;
      else
        support_counter_group_choices(2) := (support_counter_group + 1) mod 512;
      end if;
      if turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equal and turn_ready_tag_map_column and
        turn_ready_tag_valid then
        support_counter_group_choices(3) := support_counter_group_choices(2);
      else
        support_counter_group_choices(3) := support_counter_group;
      end if;
      support_newest_0_value := (((turn_ready / 512) mod 16) / 8) = 1;
      if support_ready_arrives and support_ready_above2 then
        support_column_choice(0) := 127;
      else
        support_column_choice(0) := 63;
      end if;
      if support_ready_above1 and support_ready_arrives then
        support_column_choice(1) := 127;
      else
        support_column_choice(1) := 63;
      end if;
      if support_ready_arrives then
        support_column_choice(2) := 127;
      else
        support_column_choice(2) := 63;
      end if;
      if support_ready_below2 and support_ready_arrives then
        support_column_choice(3) := 127;
      else
        support_column_choice(3) := 63;
      end if;
      if support_ready_below1 and support_ready_arrives then
        support_column_choice(4) := 127;
      else
        support_column_choice(4) := 63;
      end if;
      if support_at_moves then
        support_moment_0_start_of_frame_choice := support_at_arrives;
      else
        support_moment_0_start_of_frame_choice := support_moment_start_of_frame(0);
      end if;
      if support_row_tag(0) then
        support_next_tag_choice := (not support_at_moves) and support_next_tag;
      else
        support_next_tag_choice := support_at_moves or support_next_tag;
      end if;
      if support_at_moves then
        support_next_tag_choice_2 := support_row_tag(0);
      else
        support_next_tag_choice_2 := support_next_tag;
      end if;
      support_like_0_0_0_difference := 1 - (support_cells(6, 2) mod 64);
      support_like_0_value(0, 0) := ((support_cells(0, 0) mod 64) + support_like_0_0_0_difference) mod 128;
      if support_row_tag(6) then
        support_like_0_0_choice(0) := support_next_tag and is_set(support_cells(0, 0), 6);
      else
        support_like_0_0_choice(0) := (not support_next_tag) and is_set(support_cells(0, 0), 6);
      end if;
      support_like_0_value(0, 1) := ((support_cells(0, 1) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_1_differs(0) := support_row_tag(6) /= (not support_next_tag);
      for i in 0 to 1 loop
        for j in 2 to 4 loop
          support_like_0_value(i, j) := ((support_cells(2 * i, j) mod 64) + support_like_0_0_0_difference) mod 128;
        end loop;
        support_like_0_value(i + 1, 0) := ((support_cells(2 * i + 2, 0) mod 64) + support_like_0_0_0_difference) mod
          128;
        if support_row_tag(2 * i + 2) then
          support_like_0_0_choice(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and support_row_tag(6);
        else
          support_like_0_0_choice(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6));
        end if;
        support_like_0_value(i + 1, 1) := ((support_cells(2 * i + 2, 1) mod 64) + support_like_0_0_0_difference) mod
          128;
        support_like_0_1_differs(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
      end loop;
      for i in 2 to 4 loop
        support_like_0_value(2, i) := ((support_cells(4, i) mod 64) + support_like_0_0_0_difference) mod 128;
      end loop;
      support_like_0_value(3, 0) := ((support_cells(6, 0) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_value(3, 1) := ((support_cells(6, 1) mod 64) + support_like_0_0_0_difference) mod 128;
      for i in 3 to 5 loop
        for j in 2 to 4 loop
          support_like_0_value(i, j) := (support_like_0_0_0_difference + (support_cells(2 * i, j) mod 64)) mod 128;
        end loop;
        support_like_0_value(i + 1, 0) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 0) mod 64)) mod
          128;
        if support_row_tag(2 * i + 2) then
          support_like_0_0_choices(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and support_row_tag(6);
        else
          support_like_0_0_choices(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6));
        end if;
        support_like_0_value(i + 1, 1) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 1) mod 64)) mod
          128;
        support_like_0_1_differss(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
      end loop;
      for i in 2 to 4 loop
        support_like_0_value(6, i) := (support_like_0_0_0_difference + (support_cells(12, i) mod 64)) mod 128;
      end loop;
      if support_sum_0 < 255 then
        support_out_sure_0_choice := support_sum_0 mod 256;
      else
        support_out_sure_0_choice := 255;
      end if;
      support_out_tag_row_start_differs := fill_counter_group /= 481;
      support_out_tag_row_start_is_equal := fill_counter_column = 637;
      if support_out_tag_row_start_is_equal then
        support_out_tag_row_start_choice := (fill_counter_group /= 480) and support_out_tag_row_start;
      else
        support_out_tag_row_start_choice := support_out_tag_row_start;
      end if;
      if support_out_tag_row_start_differs then
        support_out_tag_row_start_choices(2) := support_out_tag_row_start_choice;
      else
        support_out_tag_row_start_choices(2) := support_out_tag_row_start;
      end if;
      support_out_tag_row_start_is_equal_2 := fill_counter_group = 479;
      support_out_tag_row_start_all := support_out_tag_row_start_is_equal_2 and support_out_tag_row_start_is_equal;
      if support_out_tag_row_start_choices(2) then
        support_out_tag_row_start_choices(3) := (not support_out_tag_start_of_frame) or support_out_tag_row_start_all;
      else
        support_out_tag_row_start_choices(3) := support_out_tag_start_of_frame and support_out_tag_row_start_is_equal_2
          and support_out_tag_row_start_is_equal;
      end if;
      support_out_tag_row_start_all_2 := support_out_tag_map_column and support_out_tag_valid;
      support_newest_0 <= ((((((turn_ready + (((turn_ready / 512) mod 32) / 16)) mod 64) * 2) +
        as_number(support_newest_0_value)) * 8) / 16) + (((turn_ready / 256) mod 2) * 64);
      support_newest_rest_0 <= (as_number(support_newest_0_value) * 8) + ((turn_ready / 512) mod 8) + ((turn_ready /
        16384) * 16);
      support_moves <= turn_ready_tag_valid;
      support_arrives <= turn_ready_tag_row_start_all_2;
      support_last <= turn_ready_tag_end_of_line and turn_ready_tag_map_column and turn_ready_tag_valid;
      support_rows_read_newest_0 <= support_newest_0;
      support_rows_ready_words_0 <= to_integer(support_rows_read_words_0);
      support_rows_ready_newest_0 <= support_rows_read_newest_0;
      support_rest_rows_read_newest_0 <= support_newest_rest_0;
      support_rest_rows_ready_words_0 <= to_integer(support_rest_rows_read_words_0);
      support_rest_rows_ready_newest_0 <= support_rest_rows_read_newest_0;
      support_read_column <= support_counter_column;
      support_read_moves <= support_moves;
      support_read_arrives <= support_arrives;
      support_read_above2 <= 3 < support_counter_group;
      support_read_above1 <= 2 < support_counter_group;
      support_read_below1 <= support_counter_group < 480;
      support_read_below2 <= support_counter_group < 481;
      support_read_first <= (support_counter_column = 0) and (support_counter_group = 2);
      support_read_last <= support_last;
      support_ready_column <= support_read_column;
      support_ready_moves <= support_read_moves;
      support_ready_arrives <= support_read_arrives;
      support_ready_above2 <= support_read_above2;
      support_ready_above1 <= support_read_above1;
      support_ready_below1 <= support_read_below1;
      support_ready_below2 <= support_read_below2;
      support_ready_first <= support_read_first;
      support_ready_last <= support_read_last;
      support_column(0) <= to_integer(((to_unsigned(support_column_choice(0), 7)) and
        (to_unsigned((support_rows_ready_words_0 mod 128), 7))));
      support_column(1) <= to_integer(((to_unsigned(support_column_choice(1), 7)) and
        (to_unsigned(((support_rows_ready_words_0 / 128) mod 128), 7))));
      support_column(2) <= to_integer(((to_unsigned(support_column_choice(2), 7)) and
        (to_unsigned(((support_rows_ready_words_0 / 16384) mod 128), 7))));
      support_column(3) <= to_integer(((to_unsigned(support_column_choice(3), 7)) and
        (to_unsigned((support_rows_ready_words_0 / 2097152), 7))));
      support_column(4) <= to_integer(((to_unsigned(support_rows_ready_newest_0, 7)) and
        (to_unsigned(support_column_choice(4), 7))));
      support_column_rest_0 <= support_rest_rows_ready_words_0 mod 1024;
      support_at_moves <= support_ready_moves;
      support_at_arrives <= support_ready_arrives;
      support_at_first <= support_ready_first;
      support_at_last <= support_ready_last;
      support_moved <= support_at_moves;
      for i in 0 to 2 loop
        support_like_0(i, 0) <= ((not is_set(support_like_0_value(i, 0), 1)) or (not (((support_cells(2 * i, 0) +
          support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(i, 0) / 4) = 0) and
          support_like_0_0_choice(i);
        for j in 1 to 4 loop
          support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_cells(2 * i, j) +
            support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and
            is_set(support_cells(2 * i, j), 6) and support_like_0_1_differs(i);
        end loop;
      end loop;
      support_like_0(3, 0) <= ((not is_set(support_like_0_value(3, 0), 1)) or (not (((support_cells(6, 0) +
        support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(3, 0) / 4) = 0) and
        is_set(support_cells(6, 0), 6);
      support_like_0(3, 1) <= ((not is_set(support_like_0_value(3, 1), 1)) or (not (((support_cells(6, 1) +
        support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(3, 1) / 4) = 0) and
        is_set(support_cells(6, 1), 6);
      for i in 2 to 4 loop
        support_like_0(3, i) <= ((not is_set(support_like_0_value(3, i), 1)) or (not (((support_like_0_0_0_difference +
          support_cells(6, i)) mod 2) = 1))) and ((support_like_0_value(3, i) / 4) = 0) and is_set(support_cells(6, i),
          6);
      end loop;
      for i in 4 to 6 loop
        support_like_0(i, 0) <= ((not is_set(support_like_0_value(i, 0), 1)) or (not (((support_like_0_0_0_difference +
          support_cells(2 * i, 0)) mod 2) = 1))) and ((support_like_0_value(i, 0) / 4) = 0) and
          support_like_0_0_choices(i);
        for j in 1 to 4 loop
          support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_like_0_0_0_difference
            + support_cells(2 * i, j)) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and
            is_set(support_cells(2 * i, j), 6) and support_like_0_1_differss(i);
        end loop;
      end loop;
      for i in 0 to 6 loop
        support_partial_0(i) <= as_number(support_like_0(i, 3)) + as_number(support_like_0(i, 0)) +
          as_number(support_like_0(i, 1)) + as_number(support_like_0(i, 4)) + as_number(support_like_0(i, 2));
      end loop;
      support_count_0 <= support_partial_0(6) + support_partial_0(4) + support_partial_0(3) + support_partial_0(1) +
        support_partial_0(5) + support_partial_0(0) + support_partial_0(2);
      support_sum_0 <= ((((support_centre_rest_0(2) / 16) + ((support_count_0 * 2) / 4)) * 2) + (support_count_0 mod
        2)) * 2;
      support_centre_0(0) <= support_cells(6, 2);
      support_centre_0(1) <= support_centre_0(0);
      support_centre_0(2) <= support_centre_0(1);
      support_centre_rest_0(0) <= support_rest_0(6);
      support_centre_rest_0(1) <= support_centre_rest_0(0);
      support_centre_rest_0(2) <= support_centre_rest_0(1);
      support_centre_moment_map_column(0) <= support_moment_map_column(6);
      support_centre_moment_start_of_frame(0) <= support_moment_start_of_frame(6);
      support_centre_moment_last(0) <= support_moment_last(6);
      for i in 1 to 3 loop
        support_centre_moment_map_column(i) <= support_centre_moment_map_column(i - 1);
        support_centre_moment_start_of_frame(i) <= support_centre_moment_start_of_frame(i - 1);
        support_centre_moment_last(i) <= support_centre_moment_last(i - 1);
      end loop;
      support_centre_moved(0) <= support_moved;
      support_centre_moved(1) <= support_centre_moved(0);
      support_centre_moved(2) <= support_centre_moved(1);
      support_centre_moved(3) <= support_centre_moved(2);
      support_out_disparity_0 <= ((((other_3 * 2) + (other_2 / 8) + 127) mod 128) * 8) + (other_2 mod 8);
      support_out_passed_0 <= support_enough_0;
      support_out_tag_valid <= support_centre_moved(3);
      support_out_tag_map_column <= support_centre_moment_map_column(3);
      support_out_tag_start_of_frame <= support_centre_moment_start_of_frame(3);
      support_out_tag_end_of_line <= support_centre_moment_last(3);
      if turn_ready_tag_start_of_frame and turn_ready_tag_map_column and turn_ready_tag_valid then
        support_counter_group <= support_counter_group_choice * 32;
      else
        support_counter_group <= support_counter_group_choices(3);
      end if;
      if support_row_tag(0) then
        support_row_tag(0) <= (not support_at_arrives) or support_moment_map_column(0) or (not support_at_moves);
      else
        support_row_tag(0) <= support_at_arrives and (not support_moment_map_column(0)) and support_at_moves;
      end if;
      if support_at_first then
        support_moment_start_of_frame(0) <= support_moment_0_start_of_frame_choice;
      else
        support_moment_start_of_frame(0) <= support_moment_start_of_frame(0) and (not support_at_moves);
      end if;
      if support_at_arrives and (not support_moment_map_column(0)) then
        support_next_tag <= support_next_tag_choice;
      else
        support_next_tag <= support_next_tag_choice_2;
      end if;
      if (not is_set(support_count_0, 4)) and ((not is_set(support_count_0, 3)) or (((support_count_0 / 2) mod 4) = 0))
        then
        support_enough_0 <= is_set(support_centre_0(2), 6) and is_set(support_count_0, 5);
      else
        support_enough_0 <= is_set(support_centre_0(2), 6);
      end if;
      if support_enough_0 then
        support_out_sure_0 <= support_out_sure_0_choice;
      else
        support_out_sure_0 <= 0;
      end if;
      if support_out_tag_row_start_choices(3) then
        support_out_tag_row_start <= support_out_tag_row_start or support_out_tag_row_start_all_2;
      else
        support_out_tag_row_start <= support_out_tag_row_start and ((not support_out_tag_map_column) or (not
          support_out_tag_valid));
      end if;
      if support_ready_arrives then
        support_rows_write_words_0 <= (support_rows_ready_words_0 / 128) + (support_rows_ready_newest_0 * 2097152);
        support_rest_rows_write_words_0 <= (support_rest_rows_ready_words_0 / 1024) + (support_rest_rows_ready_newest_0
          * 1024);
        support_write_column <= support_ready_column;
      end if;
      if support_at_moves then
        for i in 0 to 4 loop
          support_cells(0, i) <= support_column(i);
        end loop;
        for i in 0 to 5 loop
          for j in 0 to 4 loop
            support_cells(2 * i + 1, j) <= support_cells(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            support_cells(2 * i + 2, j) <= support_cells(2 * i + 1, j);
          end loop;
        end loop;
        support_row_tag(1) <= support_next_tag;
        for i in 2 to 12 loop
          support_row_tag(i) <= support_row_tag(i - 1);
        end loop;
        support_rest_0(0) <= support_column_rest_0;
        for i in 1 to 6 loop
          support_rest_0(i) <= support_rest_0(i - 1);
        end loop;
        support_moment_map_column(0) <= support_at_arrives;
        support_moment_last(0) <= support_at_last;
        for i in 1 to 6 loop
          support_moment_map_column(i) <= support_moment_map_column(i - 1);
          support_moment_start_of_frame(i) <= support_moment_start_of_frame(i - 1);
          support_moment_last(i) <= support_moment_last(i - 1);
        end loop;
      end if;
      -- fill
      if support_out_tag_row_start_all_2 then
        if support_out_tag_start_of_frame or support_out_tag_row_start_is_equal then
          fill_counter_column <= 0;
        else
          fill_counter_column <= (fill_counter_column + 1) mod 1024;
        end if;
      end if;
      if support_out_tag_row_start_all then
        fill_counter_group_choice := 15;
      else
        fill_counter_group_choice := 0;
      end if;
      if (fill_counter_group = 480) and support_out_tag_row_start then
        fill_counter_group_choices(2) := 1;
      else
        fill_counter_group_choices(2) := (fill_counter_group + 1) mod 512;
      end if;
      if support_out_tag_row_start_differs and support_out_tag_row_start_is_equal and support_out_tag_map_column and
        support_out_tag_valid then
        fill_counter_group_choices(3) := fill_counter_group_choices(2);
      else
        fill_counter_group_choices(3) := fill_counter_group;
      end if;
      if other_0 then
        fill_ends_read_place_0_choice := fill_at_arrives and (not fill_pixel_0_passed);
      else
        fill_ends_read_place_0_choice := fill_at_arrives and (not fill_pixel_0_passed) and (not fill_in_hole_0);
      end if;
      if fill_ends_read_place_0 = 322 then
        fill_ends_read_place_0_choices(2) := 0;
      else
        fill_ends_read_place_0_choices(2) := (fill_ends_read_place_0 + 1) mod 512;
      end if;
      if fill_ends_read_place_0_choice then
        fill_ends_read_place_0_choices(3) := fill_ends_read_place_0_choices(2);
      else
        fill_ends_read_place_0_choices(3) := fill_ends_read_place_0;
      end if;
      if (fill_step_0 - fill_width_0) < 0 then
        fill_takes_left_0_choice := ((fill_width_0 - fill_step_0) mod 1024) / 2;
      else
        fill_takes_left_0_choice := 0;
      end if;
      if fill_rises_0 then
        fill_takes_left_0_choice_2 := fill_takes_left_0_choice * 2;
      else
        fill_takes_left_0_choice_2 := fill_width_0;
      end if;
      fill_out_disparity_0_all := (not fill_chosen_0_passed) and ((not fill_chosen_at_top) or
        fill_chosen_beside_0_has_right or fill_chosen_beside_0_has_left);
      fill_out_disparity_0_all_2 := (not fill_chosen_beside_0_has_right) and (not fill_chosen_beside_0_has_left);
      if fill_takes_left_0 then
        fill_out_disparity_0_choice := fill_chosen_beside_0_left;
      else
        fill_out_disparity_0_choice := fill_chosen_beside_0_right;
      end if;
      if fill_out_disparity_0_all_2 then
        fill_out_disparity_0_choice_2 := fill_above_0 mod 32768;
      else
        fill_out_disparity_0_choice_2 := fill_out_disparity_0_choice;
      end if;
      fill_out_filled_0_is_equal := fill_chosen_at_column = 0;
      if fill_out_filled_0_is_equal and fill_chosen_at_arrives then
        fill_out_filled_0_choice := fill_has_values and (not fill_chosen_at_top);
      else
        fill_out_filled_0_choice := fill_had_values;
      end if;
      fill_out_tag_row_start_differs := median_counter_group /= 481;
      fill_out_tag_row_start_is_equal := median_counter_column = 637;
      if fill_out_tag_row_start_is_equal then
        fill_out_tag_row_start_choice := (median_counter_group /= 480) and fill_out_tag_row_start;
      else
        fill_out_tag_row_start_choice := fill_out_tag_row_start;
      end if;
      if fill_out_tag_row_start_differs then
        fill_out_tag_row_start_choices(2) := fill_out_tag_row_start_choice;
      else
        fill_out_tag_row_start_choices(2) := fill_out_tag_row_start;
      end if;
      fill_out_tag_row_start_is_equal_2 := median_counter_group = 479;
      fill_out_tag_row_start_all := fill_out_tag_row_start_is_equal_2 and fill_out_tag_row_start_is_equal;
      if fill_out_tag_row_start_choices(2) then
        fill_out_tag_row_start_choices(3) := (not fill_out_tag_start_of_frame) or fill_out_tag_row_start_all;
      else
        fill_out_tag_row_start_choices(3) := fill_out_tag_start_of_frame and fill_out_tag_row_start_is_equal_2 and
          fill_out_tag_row_start_is_equal;
      end if;
      fill_out_tag_row_start_all_2 := fill_out_tag_map_column and fill_out_tag_valid;
      fill_newest_disparity_0 <= support_out_disparity_0;
      fill_newest_passed_0 <= support_out_passed_0;
      fill_newest_sure_0 <= support_out_sure_0;
      fill_moves <= support_out_tag_valid;
      fill_arrives <= support_out_tag_row_start_all_2;
      fill_last <= support_out_tag_end_of_line and support_out_tag_map_column and support_out_tag_valid;
      fill_rows_read_newest_0 <= (fill_newest_sure_0 * 2048) + (fill_newest_disparity_0 * 2) +
        as_number(fill_newest_passed_0);
      fill_rows_ready_words_0 <= to_integer(fill_rows_read_words_0);
      fill_rows_ready_newest_0 <= fill_rows_read_newest_0;
      fill_read_column <= fill_counter_column;
      fill_read_moves <= fill_moves;
      fill_read_arrives <= fill_arrives;
      fill_read_top <= fill_counter_group = 1;
      fill_read_last <= fill_last;
      fill_ready_column <= fill_read_column;
      fill_ready_moves <= fill_read_moves;
      fill_ready_arrives <= fill_read_arrives;
      fill_ready_top <= fill_read_top;
      fill_ready_last <= fill_read_last;
      fill_write_column <= fill_ready_column;
      fill_ends_write_words_0 <= (fill_counter_column * 1024) + fill_newest_disparity_0 +
        (as_number(fill_newest_passed_0) * 1048576);
      fill_ends_write_place_0 <= fill_ends_next_place_0;
      fill_ends_ready_words_0 <= to_integer(fill_ends_read_words_0);
      fill_pixel_0_disparity <= (fill_rows_ready_words_0 mod 2048) / 2;
      fill_pixel_0_passed <= is_set(fill_rows_ready_words_0, 0);
      fill_pixel_0_sure <= fill_rows_ready_words_0 / 2048;
      fill_at_moves <= fill_ready_moves;
      fill_at_arrives <= fill_ready_arrives;
      fill_at_top <= fill_ready_top;
      fill_at_last <= fill_ready_last;
      fill_asking_0_disparity(0) <= fill_pixel_0_disparity;
      fill_asking_0_passed(0) <= fill_pixel_0_passed;
      fill_asking_0_sure(0) <= fill_pixel_0_sure;
      fill_asking_0_disparity(1) <= fill_asking_0_disparity(0);
      fill_asking_0_passed(1) <= fill_asking_0_passed(0);
      fill_asking_0_sure(1) <= fill_asking_0_sure(0);
      fill_asking_at_column(0) <= fill_write_column;
      fill_asking_at_moves(0) <= fill_at_moves;
      fill_asking_at_arrives(0) <= fill_at_arrives;
      fill_asking_at_top(0) <= fill_at_top;
      fill_asking_at_last(0) <= fill_at_last;
      fill_asking_at_column(1) <= fill_asking_at_column(0);
      fill_asking_at_moves(1) <= fill_asking_at_moves(0);
      fill_asking_at_arrives(1) <= fill_asking_at_arrives(0);
      fill_asking_at_top(1) <= fill_asking_at_top(0);
      fill_asking_at_last(1) <= fill_asking_at_last(0);
      fill_hole_starts_0(0) <= fill_ends_read_place_0_choice;
      fill_hole_starts_0(1) <= fill_hole_starts_0(0);
      fill_known_0_disparity <= fill_asking_0_disparity(1);
      fill_known_0_passed <= fill_asking_0_passed(1);
      fill_known_0_sure <= fill_asking_0_sure(1);
      fill_known_at_column <= fill_asking_at_column(1);
      fill_known_at_moves <= fill_asking_at_moves(1);
      fill_known_at_arrives <= fill_asking_at_arrives(1);
      fill_known_at_top <= fill_asking_at_top(1);
      fill_known_at_last <= fill_asking_at_last(1);
      fill_measured_0_disparity <= fill_known_0_disparity;
      fill_measured_0_passed <= fill_known_0_passed;
      fill_measured_0_sure <= fill_known_0_sure;
      fill_measured_at_column <= fill_known_at_column;
      fill_measured_at_moves <= fill_known_at_moves;
      fill_measured_at_arrives <= fill_known_at_arrives;
      fill_measured_at_top <= fill_known_at_top;
      fill_measured_at_last <= fill_known_at_last;
      fill_measured_beside_0_left <= fill_beside_0_left;
      fill_measured_beside_0_right <= fill_beside_0_right;
      fill_measured_beside_0_has_left <= fill_beside_0_has_left;
      fill_measured_beside_0_has_right <= fill_beside_0_has_right;
      fill_measured_beside_0_right_column <= fill_beside_0_right_column;
      fill_width_0 <= (fill_beside_0_right_column + (65535 - fill_beside_0_left_column)) mod 1024;
      fill_step_0 <= ((fill_beside_0_right - fill_beside_0_left) mod 2048) / 16;
      fill_rises_0 <= (fill_beside_0_right - fill_beside_0_left) >= 0;
      fill_chosen_0_disparity <= fill_measured_0_disparity;
      fill_chosen_0_passed <= fill_measured_0_passed;
      fill_chosen_0_sure <= fill_measured_0_sure;
      fill_chosen_at_column <= fill_measured_at_column;
      fill_chosen_at_moves <= fill_measured_at_moves;
      fill_chosen_at_arrives <= fill_measured_at_arrives;
      fill_chosen_at_top <= fill_measured_at_top;
      fill_chosen_at_last <= fill_measured_at_last;
      fill_chosen_beside_0_left <= fill_measured_beside_0_left;
      fill_chosen_beside_0_right <= fill_measured_beside_0_right;
      fill_chosen_beside_0_has_left <= fill_measured_beside_0_has_left;
      fill_chosen_beside_0_has_right <= fill_measured_beside_0_has_right;
      fill_takes_left_0 <= fill_measured_beside_0_has_left and ((((fill_measured_at_column +
        (fill_takes_left_0_choice_2 / 2)) - fill_measured_beside_0_right_column) < 0) or (not
        fill_measured_beside_0_has_right));
      fill_above_0 <= to_integer(fill_above_read_0);
      fill_out_passed_0 <= fill_chosen_0_passed;
      fill_out_sure_0 <= fill_chosen_0_sure;
      fill_out_tag_valid <= fill_chosen_at_moves;
      fill_out_tag_map_column <= fill_chosen_at_arrives;
      fill_out_tag_start_of_frame <= fill_out_filled_0_is_equal and fill_chosen_at_arrives and fill_chosen_at_top;
      fill_out_tag_end_of_line <= fill_chosen_at_last;
      if support_out_tag_start_of_frame and support_out_tag_map_column and support_out_tag_valid then
        fill_counter_group <= fill_counter_group_choice * 32;
      else
        fill_counter_group <= fill_counter_group_choices(3);
      end if;
      if fill_newest_passed_0 then
        fill_ends_open_0 <= fill_ends_open_0 and (not fill_arrives);
      else
        fill_ends_open_0 <= fill_ends_open_0 or fill_arrives;
      end if;
      if other_0_is_equal and fill_ready_arrives then
        fill_ends_read_place_0 <= fill_ends_row_above_place_0;
      else
        fill_ends_read_place_0 <= fill_ends_read_place_0_choices(3);
      end if;
      if fill_beside_0_has_left then
        fill_beside_0_has_left <= (fill_asking_at_column(1) /= 0) or fill_asking_0_passed(1) or (not
          fill_asking_at_arrives(1));
      else
        fill_beside_0_has_left <= fill_asking_0_passed(1) and fill_asking_at_arrives(1);
      end if;
      if fill_out_disparity_0_all then
        fill_out_disparity_0 <= fill_out_disparity_0_choice_2;
      else
        fill_out_disparity_0 <= fill_chosen_0_disparity;
      end if;
      if fill_out_filled_0_choice then
        fill_out_filled_0 <= not fill_chosen_0_passed;
      else
        fill_out_filled_0 <= (not fill_chosen_0_passed) and (fill_chosen_beside_0_has_right or
          fill_chosen_beside_0_has_left);
      end if;
      if fill_out_tag_row_start_choices(3) then
        fill_out_tag_row_start <= fill_out_tag_row_start or fill_out_tag_row_start_all_2;
      else
        fill_out_tag_row_start <= fill_out_tag_row_start and ((not fill_out_tag_map_column) or (not
          fill_out_tag_valid));
      end if;
      if (not fill_out_filled_0_choice) and (not fill_chosen_0_passed) and (not fill_chosen_beside_0_has_right) and
        (not fill_chosen_beside_0_has_left) then
        fill_has_values <= fill_has_values and (not fill_chosen_at_arrives);
      else
        fill_has_values <= fill_has_values or fill_chosen_at_arrives;
      end if;
      if fill_ready_arrives then
        fill_rows_write_words_0 <= fill_rows_ready_newest_0;
        fill_at_column <= fill_ready_column;
      end if;
      if fill_last then
        fill_ends_next_place_0_choice := fill_arrives;
      else
        fill_ends_next_place_0_choice := fill_newest_passed_0 and fill_arrives;
      end if;
      if fill_ends_open_0 and ((not fill_arrives) or (fill_counter_column /= 0)) then
        fill_ends_next_place_0_choice_2 := fill_ends_next_place_0_choice;
      else
        fill_ends_next_place_0_choice_2 := fill_last and (not fill_newest_passed_0) and fill_arrives;
      end if;
      if fill_ends_next_place_0_choice_2 then
        if fill_ends_next_place_0 = 322 then
          fill_ends_next_place_0 <= 0;
        else
          fill_ends_next_place_0 <= (fill_ends_next_place_0 + 1) mod 512;
        end if;
      end if;
      fill_ends_row_place_0_all := fill_arrives and (fill_counter_column = 0);
      if fill_ends_row_place_0_all then
        fill_ends_row_place_0 <= fill_ends_next_place_0;
        fill_ends_row_above_place_0 <= fill_ends_row_place_0;
      end if;
      if fill_at_arrives then
        fill_in_hole_0 <= not fill_pixel_0_passed;
      end if;
      fill_beside_0_left_any := (not fill_asking_0_passed(1)) or (not fill_asking_at_arrives(1));
      if not fill_beside_0_left_any then
        fill_beside_0_left <= fill_asking_0_disparity(1);
        fill_beside_0_left_column <= fill_asking_at_column(1);
      end if;
      if fill_hole_starts_0(1) then
        fill_beside_0_right <= fill_ends_ready_words_0 mod 1024;
        fill_beside_0_has_right <= is_set(fill_ends_ready_words_0, 20);
        fill_beside_0_right_column <= (fill_ends_ready_words_0 / 1024) mod 1024;
      end if;
      if fill_out_disparity_0_all_2 then
        fill_write_above_0_choice := fill_above_0;
      else
        fill_write_above_0_choice := fill_out_disparity_0_choice;
      end if;
      if fill_chosen_at_arrives then
        fill_had_values <= fill_out_filled_0_choice;
        fill_write_above_column <= fill_chosen_at_column;
        if fill_out_disparity_0_all then
          fill_write_above_0 <= fill_write_above_0_choice;
        else
          fill_write_above_0 <= fill_chosen_0_disparity;
        end if;
      end if;
      -- median
      if fill_out_tag_row_start_all_2 then
        if fill_out_tag_start_of_frame or fill_out_tag_row_start_is_equal then
          median_counter_column <= 0;
        else
          median_counter_column <= (median_counter_column + 1) mod 1024;
        end if;
      end if;
      if fill_out_tag_row_start_all then
        median_counter_group_choice := 15;
      else
        median_counter_group_choice := 0;
      end if;
      median_counter_group_is_equal := median_counter_group = 480;
      if median_counter_group_is_equal and fill_out_tag_row_start then
        median_counter_group_choices(2) := 1;
      else
        median_counter_group_choices(2) := (median_counter_group + 1) mod 512;
      end if;
      if fill_out_tag_row_start_differs and fill_out_tag_row_start_is_equal and fill_out_tag_map_column and
        fill_out_tag_valid then
        median_counter_group_choices(3) := median_counter_group_choices(2);
      else
        median_counter_group_choices(3) := median_counter_group;
      end if;
      if fill_out_tag_valid then
        median_line_ended_choice := fill_out_tag_map_column;
      else
        median_line_ended_choice := median_line_ended;
      end if;
      if median_at_top then
        median_of_column_0_a_choice := median_column_1 / 2;
      else
        median_of_column_0_a_choice := other_1 / 2;
      end if;
      if median_counter_next_frame then
        median_of_column_0_c_choice := median_column_1 / 2;
      else
        median_of_column_0_c_choice := median_column_2 / 2;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_low_0_choice := median_of_column_0_c;
      else
        median_sorted_low_0_choice := median_of_column_0_b;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_low_0_choice_2 := median_of_column_0_c;
      else
        median_sorted_low_0_choice_2 := median_of_column_0_a;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_middle_0_choice := median_of_column_0_b;
      else
        median_sorted_middle_0_choice := median_sorted_low_0_choice_2;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_middle_0_choice_2 := median_of_column_0_a;
      else
        median_sorted_middle_0_choice_2 := median_sorted_low_0_choice;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_high_0_choice := median_of_column_0_a;
      else
        median_sorted_high_0_choice := median_of_column_0_c;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_high_0_choice_2 := median_of_column_0_b;
      else
        median_sorted_high_0_choice_2 := median_of_column_0_c;
      end if;
      median_window_complete_is_equal := median_sorted_column = 0;
      if median_window_complete_is_equal then
        median_window_complete_choice := median_sorted_behind;
      else
        median_window_complete_choice := median_sorted_arrives or median_sorted_behind;
      end if;
      if median_of_low_0_c_below_a then
        median_largest_low_0_choice := median_of_low_0_a;
      else
        median_largest_low_0_choice := median_of_low_0_c;
      end if;
      if median_of_low_0_c_below_b then
        median_largest_low_0_choice_2 := median_of_low_0_b;
      else
        median_largest_low_0_choice_2 := median_of_low_0_c;
      end if;
      if median_of_middle_0_c_below_a then
        median_median_middle_0_choice := median_of_middle_0_c;
      else
        median_median_middle_0_choice := median_of_middle_0_a;
      end if;
      if median_of_middle_0_c_below_b then
        median_median_middle_0_choices(2) := median_of_middle_0_b;
      else
        median_median_middle_0_choices(2) := median_median_middle_0_choice;
      end if;
      if median_of_middle_0_c_below_b then
        median_median_middle_0_choices(3) := median_of_middle_0_c;
      else
        median_median_middle_0_choices(3) := median_of_middle_0_b;
      end if;
      if median_of_middle_0_c_below_a then
        median_median_middle_0_choices(4) := median_of_middle_0_a;
      else
        median_median_middle_0_choices(4) := median_median_middle_0_choices(3);
      end if;
      if median_of_high_0_c_below_b then
        median_smallest_high_0_choice := median_of_high_0_c;
      else
        median_smallest_high_0_choice := median_of_high_0_b;
      end if;
      if median_of_high_0_c_below_a then
        median_smallest_high_0_choice_2 := median_of_high_0_c;
      else
        median_smallest_high_0_choice_2 := median_of_high_0_a;
      end if;
      if median_of_all_0_c_below_a then
        median_out_disparity_0_choice := median_of_all_0_c;
      else
        median_out_disparity_0_choice := median_of_all_0_a;
      end if;
      if median_of_all_0_c_below_b then
        median_out_disparity_0_choices(2) := median_of_all_0_b;
      else
        median_out_disparity_0_choices(2) := median_out_disparity_0_choice;
      end if;
      if median_of_all_0_c_below_b then
        median_out_disparity_0_choices(3) := median_of_all_0_c;
      else
        median_out_disparity_0_choices(3) := median_of_all_0_b;
      end if;
      if median_of_all_0_c_below_a then
        median_out_disparity_0_choices(4) := median_of_all_0_a;
      else
        median_out_disparity_0_choices(4) := median_out_disparity_0_choices(3);
      end if;
      median_counter_next_frame <= refinement_scaled_cost;
      median_newest_0 <= (fill_out_disparity_0 * 2) + as_number(fill_out_passed_0);
      median_arrives <= fill_out_tag_row_start_all_2;
      median_behind <= median_line_ended and fill_out_tag_valid;
      median_rows_read_newest_0 <= median_newest_0;
      median_rows_ready_words_0 <= to_integer(median_rows_read_words_0);
      median_rows_ready_newest_0 <= median_rows_read_newest_0;
      median_read_column <= median_counter_column;
      median_read_arrives <= median_arrives;
      median_read_behind <= median_behind;
      median_read_top <= median_counter_group = 1;
      median_read_bottom <= median_counter_group_is_equal;
      median_read_output <= (median_counter_group >= 1) and (median_counter_group < 481);
      median_ready_column <= median_read_column;
      median_ready_arrives <= median_read_arrives;
      median_ready_behind <= median_read_behind;
      median_ready_top <= median_read_top;
      median_ready_output <= median_read_output;
      median_write_column <= median_ready_column;
      median_column_1 <= median_rows_ready_words_0 / 8192;
      median_column_2 <= median_rows_ready_newest_0;
      median_at_arrives <= median_ready_arrives;
      median_at_behind <= median_ready_behind;
      median_at_top <= median_ready_top;
      median_at_output <= median_ready_output;
      median_of_column_0_a <= median_of_column_0_a_choice;
      median_of_column_0_b <= median_column_1 / 2;
      median_of_column_0_c <= median_of_column_0_c_choice;
      median_of_column_0_b_below_a <= ((median_column_1 / 2) - median_of_column_0_a_choice) < 0;
      median_of_column_0_c_below_a <= (median_of_column_0_c_choice - median_of_column_0_a_choice) < 0;
      median_of_column_0_c_below_b <= (median_of_column_0_c_choice - (median_column_1 / 2)) < 0;
      median_column_passed_0(0) <= is_set(median_column_1, 0);
      median_column_passed_0(1) <= median_column_passed_0(0);
      median_comparing_column <= median_write_column;
      median_comparing_arrives <= median_at_arrives;
      median_comparing_behind <= median_at_behind;
      median_comparing_top <= median_at_top;
      median_comparing_output <= median_at_output;
      median_sorted_column <= median_comparing_column;
      median_sorted_arrives <= median_comparing_arrives;
      median_sorted_behind <= median_comparing_behind;
      median_sorted_top <= median_comparing_top;
      median_sorted_output <= median_comparing_output;
      median_window_complete <= median_sorted_output and median_window_complete_choice;
      median_window_first <= median_sorted_top and (median_sorted_column = 1) and median_sorted_arrives;
      median_window_last <= median_sorted_behind;
      median_of_low_0_a <= median_low_0(0);
      median_of_low_0_b <= median_low_0(1);
      median_of_low_0_c <= median_low_0(2);
      median_of_low_0_b_below_a <= (median_low_0(1) - median_low_0(0)) < 0;
      median_of_low_0_c_below_a <= (median_low_0(2) - median_low_0(0)) < 0;
      median_of_low_0_c_below_b <= (median_low_0(2) - median_low_0(1)) < 0;
      median_of_middle_0_a <= median_middle_0(0);
      median_of_middle_0_b <= median_middle_0(1);
      median_of_middle_0_c <= median_middle_0(2);
      median_of_middle_0_b_below_a <= (median_middle_0(1) - median_middle_0(0)) < 0;
      median_of_middle_0_c_below_a <= (median_middle_0(2) - median_middle_0(0)) < 0;
      median_of_middle_0_c_below_b <= (median_middle_0(2) - median_middle_0(1)) < 0;
      median_of_high_0_a <= median_high_0(0);
      median_of_high_0_b <= median_high_0(1);
      median_of_high_0_c <= median_high_0(2);
      median_of_high_0_b_below_a <= (median_high_0(1) - median_high_0(0)) < 0;
      median_of_high_0_c_below_a <= (median_high_0(2) - median_high_0(0)) < 0;
      median_of_high_0_c_below_b <= (median_high_0(2) - median_high_0(1)) < 0;
      median_of_all_0_a <= median_largest_low_0;
      median_of_all_0_b <= median_median_middle_0;
      median_of_all_0_c <= median_smallest_high_0;
      median_of_all_0_b_below_a <= (median_median_middle_0 - median_largest_low_0) < 0;
      median_of_all_0_c_below_a <= (median_smallest_high_0 - median_largest_low_0) < 0;
      median_of_all_0_c_below_b <= (median_smallest_high_0 - median_median_middle_0) < 0;
      median_waiting_complete(0) <= median_window_complete;
      median_waiting_first(0) <= median_window_first;
      median_waiting_last(0) <= median_window_last;
      median_waiting_complete(1) <= median_waiting_complete(0);
      median_waiting_first(1) <= median_waiting_first(0);
      median_waiting_last(1) <= median_waiting_last(0);
      median_waiting_complete(2) <= median_waiting_complete(1);
      median_waiting_first(2) <= median_waiting_first(1);
      median_waiting_last(2) <= median_waiting_last(1);
      median_waiting_passed_0(0) <= median_passed_0(1);
      median_waiting_passed_0(1) <= median_waiting_passed_0(0);
      median_waiting_passed_0(2) <= median_waiting_passed_0(1);
      median_beside_newest_0 <= (fill_out_sure_0 * 2) + as_number(fill_out_filled_0);
      median_beside_rows_read_newest_0 <= median_beside_newest_0;
      median_beside_rows_ready_words_0 <= to_integer(median_beside_rows_read_words_0);
      median_beside_rows_ready_newest_0 <= median_beside_rows_read_newest_0;
      median_beside_column_0 <= median_beside_rows_ready_words_0;
      median_beside_of_column_0(0) <= median_beside_column_0;
      median_beside_of_column_0(1) <= median_beside_of_column_0(0);
      median_beside_waiting_0(0) <= median_beside_in_window_0(1);
      median_beside_waiting_0(1) <= median_beside_waiting_0(0);
      median_beside_waiting_0(2) <= median_beside_waiting_0(1);
      median_out_passed_0 <= median_waiting_passed_0(2);
      median_out_confidence_0 <= median_beside_waiting_0(2) / 2;
      median_out_filled_0 <= is_set(median_beside_waiting_0(2), 0);
      median_out_valid <= median_waiting_complete(2);
      median_out_start_of_frame <= median_waiting_first(2) and median_waiting_complete(2);
      median_out_end_of_line <= median_waiting_last(2) and median_waiting_complete(2);
      if fill_out_tag_start_of_frame and fill_out_tag_map_column and fill_out_tag_valid then
        median_counter_group <= median_counter_group_choice * 32;
      else
        median_counter_group <= median_counter_group_choices(3);
      end if;
      if fill_out_tag_end_of_line then
        median_line_ended <= median_line_ended_choice;
      else
        median_line_ended <= median_line_ended and (not fill_out_tag_valid);
      end if;
      if median_of_column_0_b_below_a then
        median_sorted_low_0 <= median_sorted_low_0_choice;
        median_sorted_middle_0 <= median_sorted_middle_0_choice;
        median_sorted_high_0 <= median_sorted_high_0_choice;
      else
        median_sorted_low_0 <= median_sorted_low_0_choice_2;
        median_sorted_middle_0 <= median_sorted_middle_0_choice_2;
        median_sorted_high_0 <= median_sorted_high_0_choice_2;
      end if;
      if median_passed_0(0) then
        median_passed_0(1) <= median_passed_0(1) or median_sorted_arrives or median_sorted_behind;
      else
        median_passed_0(1) <= median_passed_0(1) and (not median_sorted_arrives) and (not median_sorted_behind);
      end if;
      if median_of_low_0_b_below_a then
        median_largest_low_0 <= median_largest_low_0_choice;
      else
        median_largest_low_0 <= median_largest_low_0_choice_2;
      end if;
      if median_of_middle_0_b_below_a then
        median_median_middle_0 <= median_median_middle_0_choices(2);
      else
        median_median_middle_0 <= median_median_middle_0_choices(4);
      end if;
      if median_of_high_0_b_below_a then
        median_smallest_high_0 <= median_smallest_high_0_choice;
      else
        median_smallest_high_0 <= median_smallest_high_0_choice_2;
      end if;
      if median_of_all_0_b_below_a then
        median_out_disparity_0 <= median_out_disparity_0_choices(2);
      else
        median_out_disparity_0 <= median_out_disparity_0_choices(4);
      end if;
      if median_ready_arrives then
        median_rows_write_words_0 <= (median_rows_ready_words_0 / 8192) + (median_rows_ready_newest_0 * 8192);
        median_at_column <= median_ready_column;
        median_beside_rows_write_words_0 <= median_beside_rows_ready_newest_0;
      end if;
      if median_sorted_behind then
        median_low_0_0_choice := median_low_0(0);
      else
        median_low_0_0_choice := median_sorted_low_0;
      end if;
      median_low_0_all(1) := median_window_complete_is_equal and median_sorted_arrives;
      if median_sorted_behind then
        median_middle_0_0_choice := median_middle_0(0);
      else
        median_middle_0_0_choice := median_sorted_middle_0;
      end if;
      if median_sorted_behind then
        median_high_0_0_choice := median_high_0(0);
      else
        median_high_0_0_choice := median_sorted_high_0;
      end if;
      median_low_0_all(0) := (not median_sorted_arrives) and (not median_sorted_behind);
      if not median_low_0_all(0) then
        median_low_0(0) <= median_low_0_0_choice;
        median_low_0(2) <= median_low_0(1);
        median_middle_0(0) <= median_middle_0_0_choice;
        median_middle_0(2) <= median_middle_0(1);
        median_high_0(0) <= median_high_0_0_choice;
        median_high_0(2) <= median_high_0(1);
        median_beside_in_window_0(1) <= median_beside_in_window_0(0);
        if median_low_0_all(1) then
          median_low_0(1) <= median_low_0_0_choice;
          median_middle_0(1) <= median_middle_0_0_choice;
          median_high_0(1) <= median_high_0_0_choice;
        else
          median_low_0(1) <= median_low_0(0);
          median_middle_0(1) <= median_middle_0(0);
          median_high_0(1) <= median_high_0(0);
        end if;
      end if;
      if median_sorted_arrives then
        median_passed_0(0) <= median_column_passed_0(1);
        median_beside_in_window_0(0) <= median_beside_of_column_0(1);
      end if;
      -- relief
      if transform_columns_valid then
        relief_centre_column(0) <= transform_left_column_2;
        relief_centre_column(1) <= relief_centre_column(0);
        relief_centre_column(2) <= relief_centre_column(1);
        relief_centre_column(3) <= relief_centre_column(2);
        relief_centre_column(4) <= relief_centre_column(3);
      end if;
      if is_set(relief_centre_grey(1), 0) then
        relief_newest_choice := (not is_set(relief_before, 1)) or (not is_set(relief_before, 0));
      else
        relief_newest_choice := not is_set(relief_before, 1);
      end if;
      if is_set(relief_centre_grey(1), 1) then
        relief_newest_choices(2) := relief_newest_choice;
      else
        relief_newest_choices(2) := is_set(relief_centre_grey(1), 0) and ((relief_before mod 4) = 0);
      end if;
      relief_newest_value := is_set(relief_before, 2);
      if relief_newest_choices(2) then
        relief_newest_choices(3) := (not is_set(relief_centre_grey(1), 2)) and relief_newest_value;
      else
        relief_newest_choices(3) := (not is_set(relief_centre_grey(1), 2)) or relief_newest_value;
      end if;
      for i in 2 to 5 loop
        relief_newest_values(i) := is_set(relief_before, i + 1);
        if relief_newest_choices(i + 1) then
          relief_newest_choices(i + 2) := (not is_set(relief_centre_grey(1), i + 1)) or relief_newest_values(i);
        else
          relief_newest_choices(i + 2) := (not is_set(relief_centre_grey(1), i + 1)) and relief_newest_values(i);
        end if;
      end loop;
      if relief_newest_choices(7) then
        relief_newest_choices(8) := (not is_set(relief_centre_grey(1), 7)) or is_set(relief_before, 7);
      else
        relief_newest_choices(8) := (not is_set(relief_centre_grey(1), 7)) and is_set(relief_before, 7);
      end if;
      relief_newest_values_from_6(6) := (relief_before - relief_centre_grey(1)) mod 256;
      relief_newest_values_from_6(7) := (relief_centre_grey(1) - relief_before) mod 256;
      if relief_newest_choices(8) then
        relief_newest_choices(9) := is_set(relief_newest_values_from_6(6), 2);
      else
        relief_newest_choices(9) := is_set(relief_newest_values_from_6(7), 2);
      end if;
      if relief_newest_choices(8) then
        relief_newest_choices(10) := not is_set(relief_newest_values_from_6(6), 3);
      else
        relief_newest_choices(10) := not is_set(relief_newest_values_from_6(7), 3);
      end if;
      for i in 11 to 12 loop
        if relief_newest_choices(8) then
          relief_newest_choices(i) := is_set(relief_newest_values_from_6(6), 16 - i);
        else
          relief_newest_choices(i) := is_set(relief_newest_values_from_6(7), 16 - i);
        end if;
      end loop;
      if relief_newest_choices(8) then
        relief_newest_choices(13) := not is_set(relief_newest_values_from_6(6), 7);
      else
        relief_newest_choices(13) := not is_set(relief_newest_values_from_6(7), 7);
      end if;
      if relief_newest_choices(8) then
        relief_newest_choices(14) := is_set(relief_newest_values_from_6(6), 6);
      else
        relief_newest_choices(14) := is_set(relief_newest_values_from_6(7), 6);
      end if;
      if relief_newest_choices(7) then
        relief_newest_choices(15) := is_set(relief_centre_grey(1), 7) and (not is_set(relief_before, 7));
      else
        relief_newest_choices(15) := is_set(relief_centre_grey(1), 7) or (not is_set(relief_before, 7));
      end if;
      if relief_newest_choices(15) then
        relief_newest_choice_16 := (relief_newest_values_from_6(7) / 2) mod 32;
      else
        relief_newest_choice_16 := (relief_newest_values_from_6(6) / 2) mod 32;
      end if;
      relief_centre_grey(0) <= relief_centre_column(4);
      relief_centre_grey(1) <= relief_centre_grey(0);
      relief_delayed_0 <= relief_newest;
      relief_rows_read_newest_0 <= relief_delayed_0;
      relief_rows_ready_words_0 <= to_integer(relief_rows_read_words_0);
      relief_rows_ready_newest_0 <= relief_rows_read_newest_0;
      relief_shown_0 <= relief_rows_ready_words_0;
      relief_write_turned_0 <= relief_entered;
      if (not ((not ((not ((not relief_newest_choices(9)) and relief_newest_choices(10))) and relief_newest_choices(11)
        and relief_newest_choices(12))) and relief_newest_choices(13))) or relief_newest_choices(14) then
        relief_newest <= 25;
      else
        relief_newest <= relief_newest_choice_16;
      end if;
      if relief_entering < 25 then
        relief_entered <= relief_entering;
      else
        relief_entered <= 25;
      end if;
      if line_starts_phases(1) then
        relief_write_address <= line_order_address;
      else
        relief_write_address <= 638;
      end if;
      if transform_filtering_valid(2) then
        relief_before <= relief_centre_grey(1);
      end if;
      if rows_ready_tag_valid then
        relief_rows_write_words_0 <= relief_rows_ready_newest_0;
      end if;
      if rows_tag_valid then
        relief_column_0 <= relief_shown_0;
        relief_entering <= relief_column_0;
      end if;
      if line_comes(1) then
        relief_between <= to_integer(relief_turned_0);
        if line_newest_first_column then
          relief_left(0) <= 64;
          relief_right(0) <= 64;
        else
          relief_left(0) <= 64 - relief_entered;
          relief_right(0) <= 64 - relief_between;
        end if;
      end if;
      for i in 1 to 2 loop
        if line_comes(8 * i + 1) then
          relief_left(i) <= relief_left(i - 1);
          relief_right(i) <= relief_right(i - 1);
        end if;
      end loop;
      if reset = '1' then
        transform_left_0 <= 0;
        transform_right_0 <= 0;
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 482;
        transform_counter_next_frame <= false;
        transform_counter_last_column <= false;
        transform_counter_counts <= false;
        transform_counter_frame_joins <= false;
        transform_counter_back_to_back <= false;
        transform_counter_column_after <= 1;
        transform_counter_group_after <= 482;
        transform_counter_next_frame_after <= false;
        transform_left_rows_read_newest_0 <= 0;
        transform_left_rows_ready_words_0 <= to_unsigned(0, 32);
        transform_left_rows_ready_newest_0 <= 0;
        transform_left_rows_write_words_0 <= to_unsigned(0, 32);
        transform_right_rows_read_newest_0 <= 0;
        transform_right_rows_ready_words_0 <= to_unsigned(0, 32);
        transform_right_rows_ready_newest_0 <= 0;
        transform_right_rows_write_words_0 <= to_unsigned(0, 32);
        transform_read_column <= 0;
        transform_read_row_inside_0 <= false;
        transform_read_column_inside_0 <= false;
        transform_read_column_inside_2 <= false;
        transform_read_column_inside_4 <= false;
        transform_read_column_inside_6 <= false;
        transform_read_column_inside_8 <= false;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        transform_ready_row_inside_0 <= false;
        transform_ready_row_inside_2 <= false;
        transform_ready_row_inside_4 <= false;
        transform_ready_column_inside_0 <= false;
        transform_ready_column_inside_2 <= false;
        transform_ready_column_inside_4 <= false;
        transform_ready_column_inside_6 <= false;
        transform_ready_column_inside_8 <= false;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_reached_first_0 <= false;
        transform_reached_first_2 <= false;
        transform_reached_first_4 <= false;
        transform_reached_beyond_last(2) <= false;
        transform_reached_beyond_last(3) <= false;
        transform_write_column <= 0;
        transform_left_column_0 <= 0;
        transform_left_column_2 <= 0;
        transform_left_column_4 <= 0;
        transform_right_column_0 <= 0;
        transform_right_column_2 <= 0;
        transform_right_column_4 <= 0;
        transform_columns_row_inside_0 <= false;
        transform_columns_row_inside_2 <= false;
        transform_columns_row_inside_4 <= false;
        transform_columns_column_inside_0 <= false;
        transform_columns_column_inside_2 <= false;
        transform_columns_column_inside_4 <= false;
        transform_columns_column_inside_6 <= false;
        transform_columns_column_inside_8 <= false;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        for i in 0 to 8 loop
          transform_left_filter_column_0(i) <= 0;
          transform_left_filter_column_2(i) <= 0;
          transform_left_filter_column_4(i) <= 0;
        end loop;
        transform_left_filter_low_is_larger_0_0_0 <= false;
        transform_left_filter_low_is_larger_0_0_2 <= false;
        transform_left_filter_low_is_larger_0_0_4 <= false;
        transform_left_filter_low_is_larger_0_2_0 <= false;
        transform_left_filter_low_is_larger_0_2_2 <= false;
        transform_left_filter_low_is_larger_0_2_4 <= false;
        transform_left_filter_low_is_larger_0_4_0 <= false;
        transform_left_filter_low_is_larger_0_4_4 <= false;
        transform_left_filter_low_is_larger_0_6_0 <= false;
        transform_left_filter_low_is_larger_0_6_2 <= false;
        transform_left_filter_low_is_larger_0_6_4 <= false;
        transform_left_filter_low_is_larger_0_8_0 <= false;
        transform_left_filter_low_is_larger_0_8_2 <= false;
        transform_left_filter_low_is_larger_0_8_4 <= false;
        transform_left_filter_feature_0 <= 0;
        for i in 0 to 8 loop
          transform_right_filter_column_0(i) <= 0;
          transform_right_filter_column_2(i) <= 0;
          transform_right_filter_column_4(i) <= 0;
        end loop;
        transform_right_filter_low_is_larger_0_0_0 <= false;
        transform_right_filter_low_is_larger_0_0_2 <= false;
        transform_right_filter_low_is_larger_0_0_4 <= false;
        transform_right_filter_low_is_larger_0_2_0 <= false;
        transform_right_filter_low_is_larger_0_2_2 <= false;
        transform_right_filter_low_is_larger_0_2_4 <= false;
        transform_right_filter_low_is_larger_0_4_0 <= false;
        transform_right_filter_low_is_larger_0_4_4 <= false;
        transform_right_filter_low_is_larger_0_6_0 <= false;
        transform_right_filter_low_is_larger_0_6_2 <= false;
        transform_right_filter_low_is_larger_0_6_4 <= false;
        transform_right_filter_low_is_larger_0_8_0 <= false;
        transform_right_filter_low_is_larger_0_8_2 <= false;
        transform_right_filter_low_is_larger_0_8_4 <= false;
        transform_right_filter_feature_0 <= 0;
        transform_filtering_0_column_inside_0 <= false;
        transform_filtering_0_column_inside_2 <= false;
        transform_filtering_0_column_inside_4 <= false;
        transform_filtering_0_column_inside_6 <= false;
        transform_filtering_0_column_inside_8 <= false;
        for i in 0 to 2 loop
          transform_filtering_start_of_frame(i) <= false;
          transform_filtering_valid(i) <= false;
        end loop;
        raster_features_search_0 <= 0;
        raster_features_reference_0 <= 0;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 481;
        raster_place_next_frame <= false;
        raster_place_last_column <= false;
        raster_place_counts <= false;
        raster_place_frame_joins <= false;
        raster_place_back_to_back <= false;
        raster_place_column_after <= 1;
        raster_place_group_after <= 481;
        delay_ahead_0 <= 0;
        delay_delayed_0 <= 0;
        delay_column <= 0;
        delay_row_inside(0) <= false;
        delay_row_inside(1) <= false;
        delay_row_inside(2) <= false;
        delay_tag_valid <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_first_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_search_rows_read_newest_0 <= 0;
        rows_search_rows_ready_words_0 <= 0;
        rows_search_rows_ready_newest_0 <= 0;
        rows_search_rows_write_words_0 <= 0;
        rows_reference_rows_read_newest_0 <= 0;
        rows_reference_rows_ready_words_0 <= 0;
        rows_reference_rows_ready_newest_0 <= 0;
        rows_reference_rows_write_words_0 <= 0;
        rows_read_column <= 0;
        rows_read_inside(0) <= false;
        rows_read_inside(1) <= false;
        rows_read_inside(2) <= false;
        rows_read_tag_valid <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_first_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_inside(0) <= false;
        rows_ready_inside(1) <= false;
        rows_ready_inside(2) <= false;
        rows_ready_tag_valid <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_first_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_search(0) <= 0;
        rows_search(1) <= 0;
        rows_search(2) <= 0;
        rows_reference(0) <= 0;
        rows_reference(1) <= 0;
        rows_reference(2) <= 0;
        rows_tag_valid <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_first_column <= false;
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
        line_order_turned_first_column <= false;
        line_order_turned_start_of_frame <= false;
        line_order_turned_end_of_line <= false;
        line_newest_first_column <= false;
        line_newest_top <= false;
        for i in 1 to 33 loop
          line_comes(i) <= false;
        end loop;
        for i in 1 to 33 loop
          line_starts_phases(i) <= false;
        end loop;
        line_places_map_column(0) <= false;
        line_places_first_column(0) <= false;
        line_places_0_top <= false;
        for i in 0 to 1 loop
          line_places_address(i) <= 0;
          line_places_shown_output_column(i) <= false;
          line_places_shown_first_column(i) <= false;
          line_places_shown_start_of_frame(i) <= false;
          line_places_shown_end_of_line(i) <= false;
          line_places_map_column(i + 1) <= false;
          line_places_first_column(i + 1) <= false;
        end loop;
        line_places_address(2) <= 0;
        line_places_shown_output_column(2) <= false;
        line_places_shown_first_column(2) <= false;
        for i in 2 to 3 loop
          line_places_shown_start_of_frame(i) <= false;
          line_places_shown_end_of_line(i) <= false;
          line_places_map_column(i + 1) <= false;
          line_places_first_column(i + 1) <= false;
          line_places_shown_output_column(i + 1) <= false;
        end loop;
        line_places_shown_start_of_frame(4) <= false;
        line_places_shown_end_of_line(4) <= false;
        costsshift_newest(0) <= 0;
        costsshift_newest(1) <= 0;
        costsshift_newest(2) <= 0;
        costsshift_new_reference(0) <= 0;
        costsshift_new_reference(1) <= 0;
        costsshift_new_reference(2) <= 0;
        costsshift_new_tag_valid <= false;
        costsshift_count_phase <= 7;
        costsshift_handed_on(0) <= 0;
        costsshift_handed_on(1) <= 0;
        costsshift_handed_on(2) <= 0;
        costsshift_read_reference(0) <= 0;
        costsshift_read_reference(1) <= 0;
        costsshift_read_reference(2) <= 0;
        costsshift_read_tag_valid <= false;
        costsshift_read_count_phase <= 7;
        for i in 0 to 2 loop
          for j in 0 to 7 loop
            costsshift_search(i, j) <= 0;
          end loop;
        end loop;
        costsshift_reference(0) <= 0;
        costsshift_reference(1) <= 0;
        costsshift_reference(2) <= 0;
        costsshift_write_phase <= 7;
        for i in 0 to 2 loop
          for j in 0 to 7 loop
            costscolumn_pixels_first_count(i, j, 0) <= 0;
            costscolumn_pixels_first_count(i, j, 1) <= 0;
            costscolumn_pixels_first_count(i, j, 2) <= 0;
            costscolumn_pixels_first_count(i, j, 3) <= 0;
            costscolumn_pixels_first_count_4(i, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 2 loop
          for j in 0 to 7 loop
            costscolumn_pixels_cost(i, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 7 loop
          costscolumn_pair_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          costscolumn_single_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          costscolumn_column_0(i) <= 0;
        end loop;
        costswindow_read_count_phase <= 7;
        for i in 0 to 7 loop
          costswindow_partial(i) <= 0;
        end loop;
        for i in 8 to 15 loop
          costswindow_partials(i) <= 0;
        end loop;
        costswindow_write_count_phase <= 7;
        for i in 0 to 7 loop
          costswindow_sum_0(i) <= 0;
        end loop;
        costsmask_column <= 0;
        costsmask_partner <= 0;
        for i in 0 to 7 loop
          costsmask_inside(i) <= false;
        end loop;
        for i in 0 to 7 loop
          costs_cost(i) <= 0;
        end loop;
        paths_tree_smallest(0) <= 0;
        paths_tree_smallest(1) <= 0;
        paths_tree_smallest(2) <= 0;
        paths_tree_smallest(3) <= 0;
        paths_tree_next_smallest(0) <= 0;
        paths_tree_next_smallest(1) <= 0;
        paths_tree_next_next_smallest_0 <= 0;
        paths_smallest_cost <= 0;
        paths_cost_delay_ring_read_address <= 1;
        paths_cost_delay_ring_write_address <= 0;
        pathsleft_fresh_past_newest(0) <= 0;
        pathsleft_fresh_past_newest(1) <= 0;
        pathsleft_fresh_past_pairs(0) <= 0;
        pathsleft_fresh_past_pairs(1) <= 0;
        pathsleft_fresh_past_pairs(2) <= 0;
        for i in 0 to 6 loop
          pathsleft_fresh_past_fours(i) <= 0;
        end loop;
        pathsleft_fresh_past_eight <= 0;
        pathsleft_fresh_past_oldest <= 0;
        pathsleft_fresh_past_cheapest <= 0;
        pathsleft_fresh_known <= 0;
        pathsleft_fresh_here <= 0;
        pathsleft_low_address <= 5;
        pathsleft_lost <= false;
        pathsleft_short_of <= false;
        pathsleft_missing <= 0;
        pathsleft_below <= 0;
        pathsleft_q <= 0;
        pathsleft_room_left <= 0;
        pathsleft_q_now <= 0;
        pathsleft_q_less <= 0;
        pathsleft_room <= 0;
        for i in 1 to 8 loop
          pathsleft_start_cost(i) <= 0;
        end loop;
        pathsleft_first <= false;
        pathsleft_g <= 0;
        pathsleft_g_less <= 0;
        pathsleft_read_count_phase <= 7;
        pathsleft_ahead_count_phase <= 7;
        pathsleft_is_first <= false;
        pathsleft_is_last <= true;
        pathsleft_lower_neighbour <= 0;
        for i in 0 to 7 loop
          pathsleft_stay(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsleft_step(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsleft_stay_change(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsleft_step_change(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsleft_cost(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsleft_arrived(i) <= 0;
        end loop;
        pathsleft_write_count_phase <= 7;
        pathsleft_tree_smallest(0) <= 0;
        pathsleft_tree_smallest(1) <= 0;
        pathsleft_tree_smallest(2) <= 0;
        pathsleft_tree_smallest(3) <= 0;
        pathsleft_tree_next_smallest(0) <= 0;
        pathsleft_tree_next_smallest(1) <= 0;
        pathsleft_tree_next_next_smallest_0 <= 0;
        pathsleft_low_0 <= 0;
        pathsleft_low_write_address <= 0;
        pathsabove_memory_read_address_0 <= 0;
        pathsabove_memory_read_address_1 <= 0;
        pathsabove_memory_bank <= false;
        pathsabove_memory_read_bank <= false;
        pathsabove_memory_held_words(0, 0) <= 0;
        pathsabove_memory_held_words(0, 1) <= 0;
        pathsabove_memory_held_words_2(0) <= 0;
        pathsabove_memory_held_words(1, 0) <= 0;
        pathsabove_memory_held_words(1, 1) <= 0;
        pathsabove_memory_held_words_2(1) <= 0;
        pathsabove_memory_held_bank <= false;
        pathsabove_memory_ready_words(0) <= 0;
        pathsabove_memory_ready_words(1) <= 0;
        pathsabove_memory_ready_words_2 <= 0;
        pathsabove_memory_write_words(0, 0) <= 0;
        pathsabove_memory_write_words(0, 1) <= 0;
        pathsabove_memory_write_words_2(0) <= 0;
        pathsabove_memory_write_words(1, 0) <= 0;
        pathsabove_memory_write_words(1, 1) <= 0;
        pathsabove_memory_write_words_2(1) <= 0;
        pathsabove_memory_write_address_0 <= 0;
        pathsabove_memory_write_address_1 <= 0;
        pathsabove_read_address_address <= 0;
        pathsabove_read_address_count_phase <= 7;
        pathsabove_ready_top <= false;
        for i in 0 to 7 loop
          pathsabove_total(i) <= 0;
        end loop;
        pathsabove_tree_smallest(0) <= 0;
        pathsabove_tree_smallest(1) <= 0;
        pathsabove_tree_smallest(2) <= 0;
        pathsabove_tree_smallest(3) <= 0;
        pathsabove_tree_next_smallest(0) <= 0;
        pathsabove_tree_next_smallest(1) <= 0;
        pathsabove_tree_next_next_smallest_0 <= 0;
        pathsabove_smallest_total <= 0;
        pathsabove_smallest <= 0;
        for i in 0 to 7 loop
          pathsabove_cost(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsabove_held(i) <= 0;
        end loop;
        pathsabove_lower_neighbour <= 0;
        pathsabove_count_phase <= 7;
        for i in 0 to 7 loop
          pathsabove_beside(i) <= 0;
        end loop;
        for i in 0 to 6 loop
          pathsabove_own(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsabove_step(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsabove_stay(i) <= 0;
        end loop;
        pathsabove_write_address_address <= 0;
        pathsabove_write_address_is_here <= false;
        pathsabove_write_address_count_phase <= 7;
        pathsturn_sum_memory_read_address_0 <= 0;
        pathsturn_sum_memory_read_address_1 <= 0;
        pathsturn_sum_memory_bank <= false;
        pathsturn_sum_memory_read_bank <= false;
        for i in 0 to 1 loop
          pathsturn_sum_memory_held_words(i, 0) <= 0;
          pathsturn_sum_memory_held_words(i, 1) <= 0;
          pathsturn_sum_memory_held_words(i, 2) <= 0;
          pathsturn_sum_memory_held_words_3(i) <= 0;
        end loop;
        pathsturn_sum_memory_held_bank <= false;
        pathsturn_sum_memory_ready_words(0) <= 0;
        pathsturn_sum_memory_ready_words(1) <= 0;
        pathsturn_sum_memory_ready_words(2) <= 0;
        pathsturn_sum_memory_ready_words_3 <= 0;
        for i in 0 to 1 loop
          pathsturn_sum_memory_write_words(i, 0) <= 0;
          pathsturn_sum_memory_write_words(i, 1) <= 0;
          pathsturn_sum_memory_write_words(i, 2) <= 0;
          pathsturn_sum_memory_write_words_3(i) <= 0;
        end loop;
        pathsturn_sum_memory_write_address_0 <= 0;
        pathsturn_sum_memory_write_address_1 <= 0;
        pathsturn_cost_memory_read_address_0 <= 0;
        pathsturn_cost_memory_read_address_1 <= 0;
        pathsturn_cost_memory_bank <= false;
        pathsturn_cost_memory_read_bank <= false;
        pathsturn_cost_memory_held_words_0(0) <= 0;
        pathsturn_cost_memory_held_words_1(0) <= 0;
        pathsturn_cost_memory_held_words_0(1) <= 0;
        pathsturn_cost_memory_held_words_1(1) <= 0;
        pathsturn_cost_memory_held_bank <= false;
        pathsturn_cost_memory_ready_words_0 <= 0;
        pathsturn_cost_memory_ready_words_1 <= 0;
        pathsturn_cost_memory_write_words_0(0) <= 0;
        pathsturn_cost_memory_write_words_1(0) <= 0;
        pathsturn_cost_memory_write_words_0(1) <= 0;
        pathsturn_cost_memory_write_words_1(1) <= 0;
        pathsturn_cost_memory_write_address_0 <= 0;
        pathsturn_cost_memory_write_address_1 <= 0;
        pathsturn_smallest_address <= 0;
        pathsturn_ready_smallest_0 <= 0;
        pathsturn_read_address_address <= 0;
        pathsturn_read_address_count_phase <= 7;
        pathsturn_sum_read_address <= 0;
        pathsturn_write_smallest_0 <= 0;
        pathsturn_write_smallest_address <= 0;
        pathsturn_write_address_address <= 0;
        pathsturn_write_address_is_here <= false;
        pathsturn_write_address_count_phase <= 7;
        pathsturn_sum_write_address(0) <= 0;
        pathsturn_sum_write_address(1) <= 0;
        pathsturn_writes_sums(0) <= false;
        pathsturn_writes_sums(1) <= false;
        pathsright_fresh_past_newest(0) <= 0;
        pathsright_fresh_past_newest(1) <= 0;
        pathsright_fresh_past_pairs(0) <= 0;
        pathsright_fresh_past_pairs(1) <= 0;
        pathsright_fresh_past_pairs(2) <= 0;
        for i in 0 to 6 loop
          pathsright_fresh_past_fours(i) <= 0;
        end loop;
        pathsright_fresh_past_eight <= 0;
        pathsright_fresh_past_oldest <= 0;
        pathsright_fresh_past_cheapest <= 0;
        pathsright_fresh_known <= 0;
        pathsright_fresh_here <= 0;
        pathsright_lost <= false;
        pathsright_short_of <= false;
        pathsright_missing <= 0;
        pathsright_below <= 0;
        pathsright_q <= 0;
        pathsright_room_left <= 0;
        pathsright_q_now <= 0;
        pathsright_q_less <= 0;
        pathsright_room <= 0;
        for i in 1 to 8 loop
          pathsright_start_cost(i) <= 0;
        end loop;
        pathsright_g <= 0;
        pathsright_g_less <= 0;
        pathsright_lower_neighbour <= 0;
        for i in 0 to 7 loop
          pathsright_stay(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsright_step(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsright_stay_change(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsright_step_change(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsright_cost(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          pathsright_arrived(i) <= 0;
        end loop;
        pathsright_tree_smallest(0) <= 0;
        pathsright_tree_smallest(1) <= 0;
        pathsright_tree_smallest(2) <= 0;
        pathsright_tree_smallest(3) <= 0;
        pathsright_tree_next_smallest(0) <= 0;
        pathsright_tree_next_smallest(1) <= 0;
        pathsright_tree_next_next_smallest_0 <= 0;
        pathsright_low_0 <= 0;
        for i in 0 to 7 loop
          paths_sum(i) <= 0;
        end loop;
        winnersmask_column <= 0;
        winnersmask_partner <= 0;
        for i in 0 to 7 loop
          winnersmask_inside(i) <= false;
        end loop;
        for i in 0 to 7 loop
          winnerswinner1_held_0(i) <= 0;
        end loop;
        winnerswinner1_best_cost_0(0) <= 0;
        winnerswinner1_best_cost_0(1) <= 0;
        winnerswinner1_best_cost_0(2) <= 0;
        winnerswinner1_best_cost_0(3) <= 0;
        winnerswinner1_best_index_0_0 <= false;
        winnerswinner1_best_index_0_1 <= 0;
        winnerswinner1_best_index_0_2 <= 0;
        winnerswinner1_best_index_0_3 <= 0;
        winnerswinner1_best_below_0(0) <= 0;
        winnerswinner1_best_below_0(1) <= 0;
        winnerswinner1_best_below_0(2) <= 0;
        winnerswinner1_best_below_0(3) <= 0;
        winnerswinner1_best_above_0(0) <= 0;
        winnerswinner1_best_above_0(1) <= 0;
        winnerswinner1_best_above_0(2) <= 0;
        winnerswinner1_best_above_0(3) <= 0;
        winnerswinner1_best_place_0_2 <= false;
        winnerswinner1_best_late_cost_0(0) <= 0;
        winnerswinner1_best_late_cost_0(1) <= 0;
        winnerswinner1_best_late_cost_0(2) <= 0;
        winnerswinner1_best_late_cost_0(3) <= 0;
        winnerswinner1_best_but_first_0(0) <= 255;
        winnerswinner1_best_but_first_0(1) <= 255;
        winnerswinner1_best_but_first_0(2) <= 255;
        winnerswinner1_best_but_first_0(3) <= 255;
        winnerswinner1_best_but_last_0(0) <= 255;
        winnerswinner1_best_but_last_0(1) <= 255;
        winnerswinner1_best_but_last_0(2) <= 255;
        winnerswinner1_best_but_last_0(3) <= 255;
        winnerswinner2_best_cost_0(0) <= 0;
        winnerswinner2_best_cost_0(1) <= 0;
        winnerswinner2_best_index_0_0 <= 0;
        winnerswinner2_best_index_0_1 <= 0;
        winnerswinner2_best_below_0(0) <= 0;
        winnerswinner2_best_below_0(1) <= 0;
        winnerswinner2_best_above_0(0) <= 0;
        winnerswinner2_best_above_0(1) <= 0;
        winnerswinner2_best_first_0(0) <= 0;
        winnerswinner2_best_first_0(1) <= 0;
        winnerswinner2_best_last_0(0) <= 0;
        winnerswinner2_best_last_0(1) <= 0;
        winnerswinner2_best_place_0(0) <= false;
        winnerswinner2_best_place_0(1) <= false;
        winnerswinner2_best_at_start_0(0) <= false;
        winnerswinner2_best_at_start_0(1) <= false;
        winnerswinner2_best_at_end_0(0) <= false;
        winnerswinner2_best_at_end_0(1) <= false;
        winnerswinner2_best_late_cost_0(0) <= 0;
        winnerswinner2_best_late_cost_0(1) <= 0;
        winnerswinner2_best_second_0(0) <= 255;
        winnerswinner2_best_second_0(1) <= 255;
        winnerswinner2_best_but_first_0(0) <= 255;
        winnerswinner2_best_but_first_0(1) <= 255;
        winnerswinner2_best_but_last_0(0) <= 255;
        winnerswinner2_best_but_last_0(1) <= 255;
        winnerswinner3_best_cost_0_0 <= 0;
        winnerswinner3_best_index_0_0 <= 0;
        winnerswinner3_best_below_0_0 <= 0;
        winnerswinner3_best_above_0_0 <= 0;
        winnerswinner3_best_first_0_0 <= 0;
        winnerswinner3_best_last_0_0 <= 0;
        winnerswinner3_best_place_0_0 <= false;
        winnerswinner3_best_at_start_0_0 <= false;
        winnerswinner3_best_at_end_0_0 <= false;
        winnerswinner3_best_late_cost_0_0 <= 0;
        winnerswinner3_best_second_0_0 <= 255;
        winnerswinner3_best_but_first_0_0 <= 255;
        winnerswinner3_best_but_last_0_0 <= 255;
        winners_best_cost_0_0 <= 0;
        winners_best_index_0_0 <= 0;
        winners_best_below_0_0 <= 0;
        winners_best_above_0_0 <= 0;
        winners_best_last_0_0 <= 0;
        winners_best_place_0_0 <= false;
        winners_best_at_start_0_0 <= false;
        winners_best_at_end_0_0 <= false;
        winners_best_late_cost_0_0 <= 0;
        winners_best_second_0_0 <= 255;
        winners_best_but_last_0_0 <= 255;
        winners_best_tag_valid <= false;
        winners_best_tag_map_column <= false;
        winners_best_tag_output_column <= false;
        winners_best_tag_start_of_frame <= false;
        winners_best_tag_end_of_line <= false;
        winners_partner_column <= 0;
        winners_partner_at <= 0;
        other_read_count_phase <= 7;
        other_words(0) <= to_unsigned(0, 32);
        other_words(1) <= to_unsigned(0, 32);
        other_words(2) <= to_unsigned(0, 32);
        other_words(3) <= to_unsigned(0, 32);
        other_count_phase <= 7;
        other_base <= 0;
        other_first_column <= false;
        other_output_column <= false;
        other_write_count_phase <= 7;
        other_left <= 0;
        for i in 0 to 11 loop
          refinement_disparity_0(i) <= 0;
        end loop;
        for i in 0 to 11 loop
          refinement_passed_0(i) <= false;
        end loop;
        for i in 0 to 11 loop
          refinement_tag_valid(i) <= false;
          refinement_tag_map_column(i) <= false;
          refinement_tag_output_column(i) <= false;
          refinement_tag_start_of_frame(i) <= false;
          refinement_tag_end_of_line(i) <= false;
        end loop;
        refinement_alone_0_0 <= false;
        refinement_gap_0 <= 0;
        refinement_scaled_gap <= false;
        for i in 0 to 9 loop
          refinement_margin_0(i) <= 0;
        end loop;
        refinement_below_0 <= 0;
        refinement_above_0 <= 0;
        refinement_u_0 <= 0;
        refinement_v_0 <= 0;
        refinement_difference_0 <= 0;
        refinement_remainder_0_0 <= 0;
        for i in 1 to 7 loop
          refinement_remainder_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          refinement_divisor_0(i) <= 1;
        end loop;
        refinement_quotient_8_0 <= 0;
        for i in 0 to 8 loop
          refinement_negative_0(i) <= false;
        end loop;
        for i in 0 to 14 loop
          leftright_other_0(i) <= 0;
        end loop;
        leftright_ring_read_address <= 1;
        leftright_ring_write_address <= 0;
        leftright_holds_winners <= false;
        leftright_position <= 0;
        leftright_held_position <= 0;
        leftright_held_valid <= false;
        leftright_address_0 <= 0;
        leftright_asking_disparity_0 <= 0;
        leftright_asking_fraction_0 <= 8;
        leftright_asking_passed_0 <= true;
        leftright_asking_margin_0 <= 0;
        leftright_asking_tag_valid <= false;
        leftright_asking_tag_map_column <= false;
        leftright_asking_tag_output_column <= false;
        leftright_asking_tag_start_of_frame <= false;
        leftright_asking_tag_end_of_line <= false;
        leftright_answered_disparity_0 <= 0;
        leftright_answered_fraction_0 <= 8;
        leftright_answered_passed_0 <= true;
        leftright_answered_margin_0 <= 0;
        leftright_answered_tag_valid <= false;
        leftright_answered_tag_map_column <= false;
        leftright_answered_tag_output_column <= false;
        leftright_answered_tag_start_of_frame <= false;
        leftright_answered_tag_end_of_line <= false;
        leftright_checked_disparity_0 <= 0;
        leftright_checked_fraction_0 <= 8;
        leftright_checked_passed_0 <= true;
        leftright_checked_margin_0 <= 0;
        leftright_checked_tag_valid <= false;
        leftright_checked_tag_map_column <= false;
        leftright_checked_tag_output_column <= false;
        leftright_checked_tag_start_of_frame <= false;
        leftright_checked_tag_end_of_line <= false;
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
        turn_newest <= 0;
        turn_comes <= false;
        turn_read_tag_valid <= false;
        turn_read_tag_map_column <= false;
        turn_read_tag_start_of_frame <= false;
        turn_read_tag_end_of_line <= false;
        turn_write_words_0 <= 0;
        turn_write_place <= 0;
        turn_ready <= 0;
        turn_ready_tag_valid <= false;
        turn_ready_tag_row_start <= false;
        turn_ready_tag_map_column <= false;
        turn_ready_tag_start_of_frame <= false;
        turn_ready_tag_end_of_line <= false;
        support_counter_column <= 0;
        support_counter_group <= 482;
        support_newest_0 <= 0;
        support_newest_rest_0 <= 0;
        support_moves <= false;
        support_arrives <= false;
        support_last <= false;
        support_rows_read_newest_0 <= 0;
        support_rows_ready_words_0 <= 0;
        support_rows_ready_newest_0 <= 0;
        support_rows_write_words_0 <= 0;
        support_rest_rows_read_newest_0 <= 0;
        support_rest_rows_ready_words_0 <= 0;
        support_rest_rows_ready_newest_0 <= 0;
        support_rest_rows_write_words_0 <= 0;
        support_read_column <= 0;
        support_read_moves <= false;
        support_read_arrives <= false;
        support_read_above2 <= false;
        support_read_above1 <= false;
        support_read_below1 <= false;
        support_read_below2 <= false;
        support_read_first <= false;
        support_read_last <= false;
        support_ready_column <= 0;
        support_ready_moves <= false;
        support_ready_arrives <= false;
        support_ready_above2 <= false;
        support_ready_above1 <= false;
        support_ready_below1 <= false;
        support_ready_below2 <= false;
        support_ready_first <= false;
        support_ready_last <= false;
        support_write_column <= 0;
        for i in 0 to 4 loop
          support_column(i) <= 0;
        end loop;
        support_column_rest_0 <= 0;
        support_at_moves <= false;
        support_at_arrives <= false;
        support_at_first <= false;
        support_at_last <= false;
        for i in 0 to 5 loop
          for j in 0 to 4 loop
            support_cells(2 * i, j) <= 0;
          end loop;
          for j in 0 to 4 loop
            support_cells(2 * i + 1, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 4 loop
          support_cells(12, i) <= 0;
        end loop;
        for i in 0 to 12 loop
          support_row_tag(i) <= false;
        end loop;
        for i in 0 to 6 loop
          support_rest_0(i) <= 0;
        end loop;
        for i in 0 to 6 loop
          support_moment_map_column(i) <= false;
          support_moment_start_of_frame(i) <= false;
          support_moment_last(i) <= false;
        end loop;
        support_next_tag <= false;
        support_moved <= false;
        for i in 0 to 2 loop
          for j in 0 to 4 loop
            support_like_0(2 * i, j) <= false;
          end loop;
          for j in 0 to 4 loop
            support_like_0(2 * i + 1, j) <= false;
          end loop;
        end loop;
        for i in 0 to 4 loop
          support_like_0(6, i) <= false;
        end loop;
        for i in 0 to 6 loop
          support_partial_0(i) <= 0;
        end loop;
        support_count_0 <= 0;
        support_enough_0 <= false;
        support_sum_0 <= 0;
        support_centre_0(0) <= 0;
        support_centre_0(1) <= 0;
        support_centre_0(2) <= 0;
        support_centre_rest_0(0) <= 0;
        support_centre_rest_0(1) <= 0;
        support_centre_rest_0(2) <= 0;
        for i in 0 to 3 loop
          support_centre_moment_map_column(i) <= false;
          support_centre_moment_start_of_frame(i) <= false;
          support_centre_moment_last(i) <= false;
        end loop;
        support_centre_moved(0) <= false;
        support_centre_moved(1) <= false;
        support_centre_moved(2) <= false;
        support_centre_moved(3) <= false;
        support_out_disparity_0 <= 0;
        support_out_passed_0 <= false;
        support_out_sure_0 <= 0;
        support_out_tag_valid <= false;
        support_out_tag_row_start <= false;
        support_out_tag_map_column <= false;
        support_out_tag_start_of_frame <= false;
        support_out_tag_end_of_line <= false;
        fill_counter_column <= 0;
        fill_counter_group <= 481;
        fill_newest_disparity_0 <= 0;
        fill_newest_passed_0 <= false;
        fill_newest_sure_0 <= 0;
        fill_moves <= false;
        fill_arrives <= false;
        fill_last <= false;
        fill_rows_read_newest_0 <= 0;
        fill_rows_ready_words_0 <= 0;
        fill_rows_ready_newest_0 <= 0;
        fill_rows_write_words_0 <= 0;
        fill_read_column <= 0;
        fill_read_moves <= false;
        fill_read_arrives <= false;
        fill_read_top <= false;
        fill_read_last <= false;
        fill_ready_column <= 0;
        fill_ready_moves <= false;
        fill_ready_arrives <= false;
        fill_ready_top <= false;
        fill_ready_last <= false;
        fill_write_column <= 0;
        fill_ends_open_0 <= false;
        fill_pixel_0_passed <= false;
        fill_at_column <= 0;
        fill_at_moves <= false;
        fill_at_arrives <= false;
        fill_at_top <= false;
        fill_at_last <= false;
        fill_in_hole_0 <= false;
        fill_asking_0_passed(0) <= false;
        fill_asking_0_passed(1) <= false;
        for i in 0 to 1 loop
          fill_asking_at_column(i) <= 0;
          fill_asking_at_moves(i) <= false;
          fill_asking_at_arrives(i) <= false;
          fill_asking_at_top(i) <= false;
          fill_asking_at_last(i) <= false;
        end loop;
        fill_hole_starts_0(0) <= false;
        fill_hole_starts_0(1) <= false;
        fill_known_at_column <= 0;
        fill_known_at_moves <= false;
        fill_known_at_arrives <= false;
        fill_known_at_top <= false;
        fill_known_at_last <= false;
        fill_measured_at_column <= 0;
        fill_measured_at_moves <= false;
        fill_measured_at_arrives <= false;
        fill_measured_at_top <= false;
        fill_measured_at_last <= false;
        fill_chosen_at_column <= 0;
        fill_chosen_at_moves <= false;
        fill_chosen_at_arrives <= false;
        fill_chosen_at_top <= false;
        fill_chosen_at_last <= false;
        fill_out_tag_valid <= false;
        fill_out_tag_row_start <= false;
        fill_out_tag_map_column <= false;
        fill_out_tag_start_of_frame <= false;
        fill_out_tag_end_of_line <= false;
        median_counter_column <= 0;
        median_counter_group <= 481;
        median_arrives <= false;
        median_behind <= false;
        median_line_ended <= false;
        median_read_column <= 0;
        median_read_arrives <= false;
        median_read_behind <= false;
        median_read_top <= false;
        median_read_output <= false;
        median_ready_column <= 0;
        median_ready_arrives <= false;
        median_ready_behind <= false;
        median_ready_top <= false;
        median_ready_output <= false;
        median_write_column <= 0;
        median_at_arrives <= false;
        median_at_behind <= false;
        median_at_top <= false;
        median_at_output <= false;
        median_comparing_column <= 0;
        median_comparing_arrives <= false;
        median_comparing_behind <= false;
        median_comparing_top <= false;
        median_comparing_output <= false;
        median_sorted_column <= 0;
        median_sorted_arrives <= false;
        median_sorted_behind <= false;
        median_sorted_top <= false;
        median_sorted_output <= false;
        median_window_complete <= false;
        median_window_first <= false;
        median_window_last <= false;
        for i in 0 to 2 loop
          median_waiting_complete(i) <= false;
          median_waiting_first(i) <= false;
          median_waiting_last(i) <= false;
        end loop;
        median_out_valid <= false;
        median_out_start_of_frame <= false;
        median_out_end_of_line <= false;
        for i in 0 to 4 loop
          relief_centre_column(i) <= 0;
        end loop;
        relief_centre_grey(0) <= 0;
        relief_centre_grey(1) <= 0;
        relief_before <= 0;
        relief_newest <= 0;
        relief_delayed_0 <= 0;
        relief_rows_read_newest_0 <= 0;
        relief_rows_ready_words_0 <= 0;
        relief_rows_ready_newest_0 <= 0;
        relief_rows_write_words_0 <= 0;
        relief_shown_0 <= 0;
        relief_column_0 <= 0;
        relief_entering <= 0;
        relief_entered <= 0;
        relief_left(0) <= 0;
        relief_left(1) <= 0;
        relief_left(2) <= 0;
        relief_right(0) <= 0;
        relief_right(1) <= 0;
        relief_right(2) <= 0;
        relief_between <= 0;
        relief_write_turned_0 <= 0;
        relief_write_address <= 0;
        other_0 <= true;
        other_2 <= 0;
        other_3 <= 0;
        other_4 <= 8;
        other_5 <= 0;
        other_6 <= 0;
        other_7 <= 0;
        other_8 <= 0;
        other_9 <= 0;
        other_10 <= 0;
        other_11 <= 0;
        other(12) <= to_unsigned(0, 32);
        other(13) <= to_unsigned(0, 32);
        other(14) <= to_unsigned(0, 32);
        other(15) <= to_unsigned(0, 32);
      end if;
    end if;
  end process;
end architecture;
