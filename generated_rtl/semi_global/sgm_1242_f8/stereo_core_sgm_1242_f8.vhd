-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_1242_f8: 1242x375, 128 disparities, window 3x3, P1 7, P2 60, 1 pixel pair a clock.
-- Options: disparities 128, reference left, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap
--   5, p1 7, p2 60, p2_least 20, above_p1 5, above_p2 31, median true, full_width true, slice_disparities 16,
--   clocks_per_pixel 8, front_clocks 2.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_1242_f8
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_1242_f8 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 1242;
    height_px : positive := 375;
    disparities : positive := 128;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 1240;
    latency_clocks : positive := 63;
    flush_groups : positive := 7457;
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
  assert width_px = 1242 report "stereo_core_sgm_1242_f8: width_px is " & integer'image(width_px) & " but this core has 1242" severity failure;
  assert height_px = 375 report "stereo_core_sgm_1242_f8: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 128 report "stereo_core_sgm_1242_f8: disparities is " & integer'image(disparities) & " but this core has 128" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_1242_f8: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_sgm_1242_f8: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 1240 report "stereo_core_sgm_1242_f8: output_width_px is " & integer'image(output_width_px) & " but this core has 1240" severity failure;
  assert latency_clocks = 63 report "stereo_core_sgm_1242_f8: latency_clocks is " & integer'image(latency_clocks) & " but this core has 63" severity failure;
  assert flush_groups = 7457 report "stereo_core_sgm_1242_f8: flush_groups is " & integer'image(flush_groups) & " but this core has 7457" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_1242_f8: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_1242_f8 is
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
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_14_1d is array (natural range <>) of natural range 0 to 14;
  type natural_14_2d is array (natural range <>, natural range <>) of natural range 0 to 14;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16383_2d is array (natural range <>, natural range <>) of natural range 0 to 16383;
  type natural_169_1d is array (natural range <>) of natural range 0 to 169;
  type natural_190_1d is array (natural range <>) of natural range 0 to 190;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_21_1d is array (natural range <>) of natural range 0 to 21;
  type natural_254_1d is array (natural range <>) of natural range 0 to 254;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_255_to_256_1d is array (natural range <>) of natural range 255 to 256;
  type natural_28_1d is array (natural range <>) of natural range 0 to 28;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_52_1d is array (natural range <>) of natural range 0 to 52;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_64_1d is array (natural range <>) of natural range 0 to 64;
  type natural_68_1d is array (natural range <>) of natural range 0 to 68;
  type natural_7_1d is array (natural range <>) of natural range 0 to 7;
  type unsigned_27_1d is array (natural range <>) of unsigned(26 downto 0);
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type unsigned_49_1d is array (natural range <>) of unsigned(48 downto 0);
  type unsigned_8_2d is array (natural range <>, natural range <>) of unsigned(7 downto 0);
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
  signal transform_counter_column, transform_counter_column_after, transform_read_column : natural range 0 to 2047;
  signal transform_ready_column, transform_write_column : natural range 0 to 2047;
  signal transform_counter_group, transform_counter_group_after : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame, raster_place_last_column, raster_place_counts : boolean;
  signal raster_place_frame_joins, raster_place_back_to_back : boolean;
  signal raster_place_column, raster_place_column_after : natural range 0 to 2047;
  signal raster_place_group, raster_place_group_after : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16383;
  signal delay_column : natural range 0 to 2047;
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
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 2047;
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
  signal line_comes : boolean_1d(1 to 35);
  signal line_starts_phases : boolean_1d(1 to 35);
  signal line_places_map_column : boolean_1d(0 to 4);  -- line_places_#_map_column
  signal line_places_first_column : boolean_1d(0 to 3);  -- line_places_#_first_column
  signal line_places_0_top : boolean;
  signal line_places_shown_output_column : boolean_1d(0 to 4);  -- line_places_#_shown_output_column
  signal line_places_shown_first_column : boolean_1d(0 to 2);  -- line_places_#_shown_first_column
  signal line_places_shown_start_of_frame : boolean_1d(0 to 4);  -- line_places_#_shown_start_of_frame
  signal line_places_shown_end_of_line : boolean_1d(0 to 4);  -- line_places_#_shown_end_of_line
  signal line_order_address : natural range 0 to 2047;
  signal line_places_address : natural_2047_1d(0 to 2);  -- line_places_#_address
  -- costsshift
  signal costsshift_newest : natural_16383_1d(0 to 2);
  signal costsshift_new_reference : natural_16383_1d(0 to 2);
  signal costsshift_handed_on : natural_16383_1d(0 to 2);
  signal costsshift_read_reference : natural_16383_1d(0 to 2);
  signal costsshift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal costsshift_reference : natural_16383_1d(0 to 2);
  signal costsshift_new_tag_valid, costsshift_read_tag_valid : boolean;
  signal costsshift_count_phase, costsshift_read_count_phase, costsshift_write_phase : natural range 0 to 7;
  signal costsshift_read_words : unsigned_28_1d(0 to 23);
  -- costscolumn
  signal costscolumn_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- costscolumn_pixels_first_#_#_count_#
  signal costscolumn_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- costscolumn_pixels_first_#_#_count_4
  signal costscolumn_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal costscolumn_single_0 : natural_14_1d(0 to 15);
  signal costscolumn_pair_0 : natural_28_1d(0 to 15);
  signal costscolumn_column_0 : natural_42_1d(0 to 15);
  -- costswindow
  signal costswindow_read_count_phase, costswindow_write_count_phase : natural range 0 to 7;
  signal costswindow_read_words : unsigned_27_1d(0 to 3);
  signal costswindow_read_wordss : unsigned_28_1d(4 to 7);  -- costswindow_read_words_#
  signal costswindow_partial : natural_42_1d(0 to 15);
  signal costswindow_partials : natural_105_1d(16 to 31);  -- costswindow_partial_#
  signal costswindow_sum_0 : natural_169_1d(0 to 15);
  -- costsmask
  signal costsmask_column : natural range 0 to 2047;
  signal costsmask_partner : natural range 0 to 8191;
  signal costsmask_inside : boolean_1d(0 to 15);
  -- costs
  signal costs_cost : natural_21_1d(0 to 15);
  -- paths
  signal paths_tree_smallest : natural_21_1d(0 to 7);
  signal paths_tree_next_smallest : natural_21_1d(0 to 3);
  signal paths_tree_next_next_smallest : natural_21_1d(0 to 1);
  signal paths_tree_next_next_next_smallest_0, paths_smallest_cost : natural range 0 to 21;
  signal paths_cost_delay_ring_read_address, paths_cost_delay_ring_write_address : natural range 0 to 15;
  signal paths_cost_delay_held_0 : unsigned(29 downto 0);
  signal paths_cost_delay_held_1 : unsigned(17 downto 0);
  signal paths_sum : natural_254_1d(0 to 15);
  -- pathsleft
  signal pathsleft_fresh_past_newest : natural_64_1d(0 to 1);
  signal pathsleft_fresh_past_pairs : natural_64_1d(0 to 2);
  signal pathsleft_fresh_past_fours : natural_64_1d(0 to 7);
  signal pathsleft_fresh_past_eight, pathsleft_fresh_past_oldest, pathsleft_fresh_past_cheapest : natural range 0 to 64;
  signal pathsleft_fresh_here : natural range 0 to 64;
  signal pathsleft_fresh_known, pathsleft_q_less, pathsleft_g_less, pathsleft_lower_neighbour : natural range 0 to 127;
  signal pathsleft_stay : natural_127_1d(0 to 15);
  signal pathsleft_step : natural_127_1d(0 to 15);
  signal pathsleft_stay_change : natural_127_1d(0 to 15);
  signal pathsleft_step_change : natural_127_1d(0 to 15);
  signal pathsleft_cost : natural_127_1d(0 to 15);
  signal pathsleft_arrived : natural_127_1d(0 to 15);
  signal pathsleft_tree_smallest : natural_127_1d(0 to 7);
  signal pathsleft_tree_next_smallest : natural_127_1d(0 to 3);
  signal pathsleft_tree_next_next_smallest : natural_127_1d(0 to 1);
  signal pathsleft_tree_next_next_next_smallest_0, pathsleft_low_0 : natural range 0 to 127;
  signal pathsleft_low_address, pathsleft_low_write_address : natural range 0 to 15;
  signal pathsleft_lowest_0, pathsleft_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsleft_lost, pathsleft_short_of, pathsleft_first, pathsleft_is_first, pathsleft_is_last : boolean;
  signal pathsleft_missing, pathsleft_below, pathsleft_q, pathsleft_room_left, pathsleft_q_now : natural range 0 to 63;
  signal pathsleft_room : natural range 0 to 63;
  signal pathsleft_start_cost : natural_63_1d(1 to 9);
  signal pathsleft_g : natural range 0 to 84;
  signal pathsleft_read_count_phase, pathsleft_ahead_count_phase, pathsleft_write_count_phase : natural range 0 to 7;
  signal pathsleft_read_words : unsigned_28_1d(0 to 7);
  -- pathsabove
  signal pathsabove_memory_read_address_0 : natural range 0 to 4095;
  signal pathsabove_memory_write_address : natural_4095_1d(0 to 1);
  signal pathsabove_memory_read_address_2, pathsabove_memory_write_address_2 : natural range 0 to 2047;
  signal pathsabove_memory_bank, pathsabove_memory_read_bank, pathsabove_memory_held_bank : natural range 0 to 3;
  signal pathsabove_memory_read_words : unsigned_8_2d(0 to 2, 0 to 9);
  signal pathsabove_memory_held_words : natural_255_2d(0 to 2, 0 to 9);
  signal pathsabove_memory_ready_words : natural_255_1d(0 to 9);
  signal pathsabove_memory_write_words : natural_255_2d(0 to 2, 0 to 9);
  signal pathsabove_read_address_address, pathsabove_write_address_address : natural range 0 to 16383;
  signal pathsabove_read_address_count_phase, pathsabove_count_phase : natural range 0 to 7;
  signal pathsabove_write_address_count_phase : natural range 0 to 7;
  signal pathsabove_ready_top, pathsabove_write_address_is_here : boolean;
  signal pathsabove_total : natural_52_1d(0 to 15);
  signal pathsabove_tree_smallest : natural_52_1d(0 to 7);
  signal pathsabove_tree_next_smallest : natural_52_1d(0 to 3);
  signal pathsabove_tree_next_next_smallest : natural_52_1d(0 to 1);
  signal pathsabove_tree_next_next_next_smallest_0 : natural range 0 to 52;
  signal pathsabove_delay_held : unsigned_30_1d(0 to 2);
  signal pathsabove_delay_held_3 : unsigned(5 downto 0);
  signal pathsabove_smallest_total, pathsabove_smallest : natural range 0 to 63;
  signal pathsabove_cost : natural_63_1d(0 to 15);
  signal pathsabove_held : natural_63_1d(0 to 15);
  signal pathsabove_lower_neighbour : natural range 0 to 63;
  signal pathsabove_beside : natural_63_1d(0 to 15);
  signal pathsabove_own : natural_63_1d(0 to 14);
  signal pathsabove_step : natural_68_1d(0 to 15);
  signal pathsabove_stay : natural_31_1d(0 to 15);
  -- pathsturn
  signal pathsturn_sum_memory_read_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_write_address : natural_4095_1d(0 to 1);
  signal pathsturn_cost_memory_read_address_0 : natural range 0 to 4095;
  signal pathsturn_cost_memory_write_address : natural_4095_1d(0 to 1);
  signal pathsturn_sum_memory_read_address_2, pathsturn_sum_memory_write_address_2 : natural range 0 to 2047;
  signal pathsturn_cost_memory_read_address_2, pathsturn_cost_memory_write_address_2 : natural range 0 to 2047;
  signal pathsturn_smallest_address, pathsturn_write_smallest_address : natural range 0 to 2047;
  signal pathsturn_sum_memory_bank, pathsturn_sum_memory_read_bank : natural range 0 to 3;
  signal pathsturn_sum_memory_held_bank, pathsturn_cost_memory_bank : natural range 0 to 3;
  signal pathsturn_cost_memory_read_bank, pathsturn_cost_memory_held_bank : natural range 0 to 3;
  signal pathsturn_sum_memory_read_words : unsigned_8_2d(0 to 2, 0 to 13);
  signal pathsturn_cost_memory_read_words : unsigned_8_2d(0 to 2, 0 to 5);
  signal pathsturn_sum_memory_held_words : natural_255_2d(0 to 2, 0 to 13);
  signal pathsturn_sum_memory_ready_words : natural_255_1d(0 to 13);
  signal pathsturn_sum_memory_write_words : natural_255_2d(0 to 2, 0 to 13);
  signal pathsturn_cost_memory_held_words : natural_255_2d(0 to 2, 0 to 5);
  signal pathsturn_cost_memory_ready_words : natural_255_1d(0 to 5);
  signal pathsturn_cost_memory_write_words : natural_255_2d(0 to 2, 0 to 5);
  signal pathsturn_read_smallest_0 : unsigned(4 downto 0);
  signal pathsturn_ready_smallest_0 : natural range 0 to 31;
  signal pathsturn_read_address_address, pathsturn_sum_read_address : natural range 0 to 16383;
  signal pathsturn_write_address_address : natural range 0 to 16383;
  signal pathsturn_sum_write_address : natural_16383_1d(0 to 1);
  signal pathsturn_read_address_count_phase, pathsturn_write_address_count_phase : natural range 0 to 7;
  signal pathsturn_write_smallest_0 : natural range 0 to 21;
  signal pathsturn_write_address_is_here : boolean;
  signal pathsturn_writes_sums : boolean_1d(0 to 1);
  -- pathsright
  signal pathsright_fresh_past_newest : natural_64_1d(0 to 1);
  signal pathsright_fresh_past_pairs : natural_64_1d(0 to 2);
  signal pathsright_fresh_past_fours : natural_64_1d(0 to 7);
  signal pathsright_fresh_past_eight, pathsright_fresh_past_oldest : natural range 0 to 64;
  signal pathsright_fresh_past_cheapest, pathsright_fresh_here : natural range 0 to 64;
  signal pathsright_fresh_known, pathsright_q_less, pathsright_g_less : natural range 0 to 127;
  signal pathsright_lower_neighbour : natural range 0 to 127;
  signal pathsright_stay : natural_127_1d(0 to 15);
  signal pathsright_step : natural_127_1d(0 to 15);
  signal pathsright_stay_change : natural_127_1d(0 to 15);
  signal pathsright_step_change : natural_127_1d(0 to 15);
  signal pathsright_cost : natural_127_1d(0 to 15);
  signal pathsright_arrived : natural_127_1d(0 to 15);
  signal pathsright_tree_smallest : natural_127_1d(0 to 7);
  signal pathsright_tree_next_smallest : natural_127_1d(0 to 3);
  signal pathsright_tree_next_next_smallest : natural_127_1d(0 to 1);
  signal pathsright_tree_next_next_next_smallest_0, pathsright_low_0 : natural range 0 to 127;
  signal pathsright_lowest_0, pathsright_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsright_lost, pathsright_short_of : boolean;
  signal pathsright_missing, pathsright_below, pathsright_q, pathsright_room_left : natural range 0 to 63;
  signal pathsright_q_now, pathsright_room : natural range 0 to 63;
  signal pathsright_start_cost : natural_63_1d(1 to 9);
  signal pathsright_g : natural range 0 to 94;
  signal pathsright_read_words : unsigned_28_1d(0 to 7);
  -- winnersmask
  signal winnersmask_column : natural range 0 to 2047;
  signal winnersmask_partner : natural range 0 to 8191;
  signal winnersmask_inside : boolean_1d(0 to 15);
  -- winnerswinner1
  signal winnerswinner1_best_cost_0 : natural_255_1d(0 to 7);
  signal winnerswinner1_best_index_0_0, winnerswinner1_best_below_0 : boolean;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_best_index_0_3 : natural range 0 to 7;
  signal winnerswinner1_best_index_0_4 : natural range 0 to 9;
  signal winnerswinner1_best_index_0_5 : natural range 0 to 11;
  signal winnerswinner1_best_index_0_6 : natural range 0 to 13;
  signal winnerswinner1_best_index_0_7 : natural range 0 to 15;
  -- winnerswinner2
  signal winnerswinner2_best_cost_0 : natural_255_1d(0 to 3);
  signal winnerswinner2_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner2_best_index_0_1 : natural range 0 to 7;
  signal winnerswinner2_best_index_0_2 : natural range 0 to 11;
  signal winnerswinner2_best_index_0_3 : natural range 0 to 15;
  -- winnerswinner3
  signal winnerswinner3_best_cost_0 : natural_255_1d(0 to 1);
  signal winnerswinner3_best_index_0_0 : natural range 0 to 7;
  signal winnerswinner3_best_index_0_1 : natural range 0 to 15;
  -- winnerswinner4
  signal winnerswinner4_best_cost_0_0 : natural range 0 to 255;
  signal winnerswinner4_best_index_0_0 : natural range 0 to 15;
  -- winners
  signal winners_best_cost_0_0, winners_best_index_0_0 : natural range 0 to 255;
  signal winners_best_tag_valid, winners_best_tag_map_column, winners_best_tag_output_column : boolean;
  signal winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 2047;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame : boolean;
  signal turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid, turn_read_tag_map_column : boolean;
  signal turn_read_tag_start_of_frame, turn_read_tag_end_of_line, turn_ready_tag_valid : boolean;
  signal turn_ready_tag_row_start, turn_ready_tag_map_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 511;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column : natural range 0 to 2047;
  signal map_sorted_column : natural range 0 to 2047;
  signal map_counter_group, map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 511;
  signal map_column : natural_511_1d(1 to 2);
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
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0 : natural range 0 to 255;
  signal map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 255;
  signal map_low_0 : natural_255_1d(0 to 2);  -- map_low_#_0
  signal map_middle_0 : natural_255_1d(0 to 2);  -- map_middle_#_0
  signal map_high_0 : natural_255_1d(0 to 2);  -- map_high_#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b : natural range 0 to 255;
  signal map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b, map_of_high_0_c : natural range 0 to 255;
  signal map_largest_low_0, map_median_middle_0, map_smallest_high_0, map_of_all_0_a : natural range 0 to 255;
  signal map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 255;
  -- relief
  signal relief_centre_column : natural_255_1d(0 to 4);
  signal relief_centre_grey : natural_255_1d(0 to 1);
  signal relief_before : natural range 0 to 255;
  signal relief_newest, relief_delayed_0, relief_rows_read_newest_0, relief_rows_ready_words_0 : natural range 0 to 63;
  signal relief_rows_ready_newest_0, relief_rows_write_words_0, relief_shown_0, relief_column_0 : natural range 0 to 63;
  signal relief_entering, relief_entered, relief_between, relief_write_turned_0 : natural range 0 to 63;
  signal relief_rows_read_words_0, relief_turned_0 : unsigned(5 downto 0);
  signal relief_left : natural_64_1d(0 to 2);
  signal relief_right : natural_64_1d(0 to 2);
  signal relief_write_address : natural range 0 to 2047;
  -- other
  signal other : unsigned_49_1d(0 to 1);
  signal other_2 : natural range 0 to 510;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(10 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(10 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(10 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(10 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address, map_rows_read_words_0_memory_write_address : unsigned(10 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(17 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address, turn_read_words_0_memory_write_address : unsigned(10 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal pathsright_read_words_7_memory_read_enable : boolean;
  signal pathsright_read_words_7_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_words_7_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_words_7_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_words_6_memory_read_enable : boolean;
  signal pathsright_read_words_6_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_words_6_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_words_6_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_words_5_memory_read_enable : boolean;
  signal pathsright_read_words_5_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_words_5_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_words_5_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_words_4_memory_read_enable : boolean;
  signal pathsright_read_words_4_memory_read_address : unsigned(2 downto 0);
  signal pathsright_read_words_4_memory_write_address : unsigned(2 downto 0);
  signal pathsright_read_words_4_memory_write_data : unsigned(27 downto 0);
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
  signal pathsturn_read_smallest_0_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_read_smallest_0_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_read_smallest_0_memory_write_data : unsigned(4 downto 0);
  signal pathsturn_sum_memory_read_words_0_13_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_13_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_13_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_13_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_12_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_12_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_12_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_12_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_11_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_11_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_11_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_11_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_10_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_10_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_10_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_10_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_9_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_9_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_9_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_9_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_8_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_8_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_8_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_8_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_0_7_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_7_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_7_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_0_7_memory_write_data : unsigned(7 downto 0);
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
  signal pathsturn_sum_memory_read_words_1_13_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_13_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_13_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_13_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_12_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_12_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_12_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_12_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_11_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_11_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_11_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_11_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_10_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_10_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_10_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_10_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_9_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_9_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_9_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_9_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_8_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_8_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_8_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_8_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_1_7_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_1_7_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_7_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_sum_memory_read_words_1_7_memory_write_data : unsigned(7 downto 0);
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
  signal pathsturn_sum_memory_read_words_2_13_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_13_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_13_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_13_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_12_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_12_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_12_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_12_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_11_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_11_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_11_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_11_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_10_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_10_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_10_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_10_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_9_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_9_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_9_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_9_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_8_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_8_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_8_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_8_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_7_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_7_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_7_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_7_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_6_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_6_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_6_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_6_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_5_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_5_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_5_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_5_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_4_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_4_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_4_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_4_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_3_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_3_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_3_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_2_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_2_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_2_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_2_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_1_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_1_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_sum_memory_read_words_2_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_2_0_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_0_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_sum_memory_read_words_2_0_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_5_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_5_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_5_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_5_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_0_4_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_4_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_4_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_0_4_memory_write_data : unsigned(7 downto 0);
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
  signal pathsturn_cost_memory_read_words_1_5_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_5_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_5_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_5_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_1_4_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_1_4_memory_read_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_4_memory_write_address : unsigned(11 downto 0);
  signal pathsturn_cost_memory_read_words_1_4_memory_write_data : unsigned(7 downto 0);
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
  signal pathsturn_cost_memory_read_words_2_5_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_5_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_5_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_5_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_4_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_4_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_4_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_4_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_3_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_3_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_3_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_3_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_2_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_2_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_2_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_2_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_1_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_1_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_1_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_1_memory_write_data : unsigned(7 downto 0);
  signal pathsturn_cost_memory_read_words_2_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_2_0_memory_read_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_0_memory_write_address : unsigned(10 downto 0);
  signal pathsturn_cost_memory_read_words_2_0_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_delay_held_3_memory_read_enable : boolean;
  signal pathsabove_delay_held_3_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_3_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_3_memory_write_data : unsigned(5 downto 0);
  signal pathsabove_delay_held_2_memory_read_enable : boolean;
  signal pathsabove_delay_held_2_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_2_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_2_memory_write_data : unsigned(29 downto 0);
  signal pathsabove_delay_held_1_memory_read_enable : boolean;
  signal pathsabove_delay_held_1_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_1_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_1_memory_write_data : unsigned(29 downto 0);
  signal pathsabove_delay_held_0_memory_read_enable : boolean;
  signal pathsabove_delay_held_0_memory_read_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_0_memory_write_address : unsigned(3 downto 0);
  signal pathsabove_delay_held_0_memory_write_data : unsigned(29 downto 0);
  signal pathsabove_memory_read_words_0_9_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_9_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_9_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_9_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_8_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_8_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_8_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_8_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_7_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_7_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_7_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_7_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_6_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_6_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_6_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_6_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_0_5_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_5_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_5_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_0_5_memory_write_data : unsigned(7 downto 0);
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
  signal pathsabove_memory_read_words_1_9_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_9_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_9_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_9_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_8_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_8_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_8_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_8_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_7_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_7_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_7_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_7_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_6_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_6_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_6_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_6_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_1_5_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_1_5_memory_read_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_5_memory_write_address : unsigned(11 downto 0);
  signal pathsabove_memory_read_words_1_5_memory_write_data : unsigned(7 downto 0);
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
  signal pathsabove_memory_read_words_2_9_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_9_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_9_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_9_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_8_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_8_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_8_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_8_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_7_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_7_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_7_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_7_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_6_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_6_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_6_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_6_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_5_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_5_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_5_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_5_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_4_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_4_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_4_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_4_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_3_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_3_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_3_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_3_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_2_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_2_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_2_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_2_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_1_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_1_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_1_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_1_memory_write_data : unsigned(7 downto 0);
  signal pathsabove_memory_read_words_2_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_2_0_memory_read_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_0_memory_write_address : unsigned(10 downto 0);
  signal pathsabove_memory_read_words_2_0_memory_write_data : unsigned(7 downto 0);
  signal pathsleft_read_words_7_memory_read_enable : boolean;
  signal pathsleft_read_words_7_memory_read_address, pathsleft_read_words_7_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_words_7_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_words_6_memory_read_enable : boolean;
  signal pathsleft_read_words_6_memory_read_address, pathsleft_read_words_6_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_words_6_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_words_5_memory_read_enable : boolean;
  signal pathsleft_read_words_5_memory_read_address, pathsleft_read_words_5_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_words_5_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_words_4_memory_read_enable : boolean;
  signal pathsleft_read_words_4_memory_read_address, pathsleft_read_words_4_memory_write_address : unsigned(2 downto 0);
  signal pathsleft_read_words_4_memory_write_data : unsigned(27 downto 0);
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
  signal paths_cost_delay_held_1_memory_read_enable : boolean;
  signal paths_cost_delay_held_1_memory_read_address : unsigned(3 downto 0);
  signal paths_cost_delay_held_1_memory_write_address : unsigned(3 downto 0);
  signal paths_cost_delay_held_1_memory_write_data : unsigned(17 downto 0);
  signal paths_cost_delay_held_0_memory_read_enable : boolean;
  signal paths_cost_delay_held_0_memory_read_address : unsigned(3 downto 0);
  signal paths_cost_delay_held_0_memory_write_address : unsigned(3 downto 0);
  signal paths_cost_delay_held_0_memory_write_data : unsigned(29 downto 0);
  signal relief_turned_0_memory_read_enable : boolean;
  signal relief_turned_0_memory_read_address, relief_turned_0_memory_write_address : unsigned(10 downto 0);
  signal relief_turned_0_memory_write_data : unsigned(5 downto 0);
  signal relief_rows_read_words_0_memory_read_enable : boolean;
  signal relief_rows_read_words_0_memory_read_address : unsigned(10 downto 0);
  signal relief_rows_read_words_0_memory_write_address : unsigned(10 downto 0);
  signal relief_rows_read_words_0_memory_write_data : unsigned(5 downto 0);
  signal costswindow_read_words_7_memory_read_enable : boolean;
  signal costswindow_read_words_7_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_7_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_7_memory_write_data : unsigned(27 downto 0);
  signal costswindow_read_words_6_memory_read_enable : boolean;
  signal costswindow_read_words_6_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_6_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_6_memory_write_data : unsigned(27 downto 0);
  signal costswindow_read_words_5_memory_read_enable : boolean;
  signal costswindow_read_words_5_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_5_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_5_memory_write_data : unsigned(27 downto 0);
  signal costswindow_read_words_4_memory_read_enable : boolean;
  signal costswindow_read_words_4_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_4_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_4_memory_write_data : unsigned(27 downto 0);
  signal costswindow_read_words_3_memory_read_enable : boolean;
  signal costswindow_read_words_3_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_3_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_3_memory_write_data : unsigned(26 downto 0);
  signal costswindow_read_words_2_memory_read_enable : boolean;
  signal costswindow_read_words_2_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_2_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_2_memory_write_data : unsigned(26 downto 0);
  signal costswindow_read_words_1_memory_read_enable : boolean;
  signal costswindow_read_words_1_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_1_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_1_memory_write_data : unsigned(26 downto 0);
  signal costswindow_read_words_0_memory_read_enable : boolean;
  signal costswindow_read_words_0_memory_read_address : unsigned(2 downto 0);
  signal costswindow_read_words_0_memory_write_address : unsigned(2 downto 0);
  signal costswindow_read_words_0_memory_write_data : unsigned(26 downto 0);
  signal costsshift_read_words_23_memory_read_enable : boolean;
  signal costsshift_read_words_23_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_23_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_23_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_22_memory_read_enable : boolean;
  signal costsshift_read_words_22_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_22_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_22_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_21_memory_read_enable : boolean;
  signal costsshift_read_words_21_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_21_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_21_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_20_memory_read_enable : boolean;
  signal costsshift_read_words_20_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_20_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_20_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_19_memory_read_enable : boolean;
  signal costsshift_read_words_19_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_19_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_19_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_18_memory_read_enable : boolean;
  signal costsshift_read_words_18_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_18_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_18_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_17_memory_read_enable : boolean;
  signal costsshift_read_words_17_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_17_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_17_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_16_memory_read_enable : boolean;
  signal costsshift_read_words_16_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_16_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_16_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_15_memory_read_enable : boolean;
  signal costsshift_read_words_15_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_15_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_15_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_14_memory_read_enable : boolean;
  signal costsshift_read_words_14_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_14_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_14_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_13_memory_read_enable : boolean;
  signal costsshift_read_words_13_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_13_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_13_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_12_memory_read_enable : boolean;
  signal costsshift_read_words_12_memory_read_address : unsigned(2 downto 0);
  signal costsshift_read_words_12_memory_write_address : unsigned(2 downto 0);
  signal costsshift_read_words_12_memory_write_data : unsigned(27 downto 0);
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
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(10 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(10 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(10 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(10 downto 0);
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
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 11);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 11);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1242, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 11);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 11);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1242, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 11);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_write_column, 11);
  map_rows_read_words_0_memory_write_data <= to_unsigned(map_rows_write_words_0, 18);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1240, width => 18, address_bits => 11)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 11);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 11);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 9);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 1241, width => 9, address_bits => 11)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  pathsright_read_words_7_memory_read_enable <= true;
  pathsright_read_words_7_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_7_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_7_memory_write_data <= to_unsigned(pathsright_arrived(15), 7) & to_unsigned(pathsright_arrived(14), 7) & to_unsigned(pathsright_arrived(13), 7) & to_unsigned(pathsright_arrived(12), 7);
  pathsright_read_words_7_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_7_memory_read_enable,
      read_address => pathsright_read_words_7_memory_read_address, read_data => pathsright_read_words(7),
      write_address => pathsright_read_words_7_memory_write_address, write_data => pathsright_read_words_7_memory_write_data);

  pathsright_read_words_6_memory_read_enable <= true;
  pathsright_read_words_6_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_6_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_6_memory_write_data <= to_unsigned(pathsright_arrived(11), 7) & to_unsigned(pathsright_arrived(10), 7) & to_unsigned(pathsright_arrived(9), 7) & to_unsigned(pathsright_arrived(8), 7);
  pathsright_read_words_6_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_6_memory_read_enable,
      read_address => pathsright_read_words_6_memory_read_address, read_data => pathsright_read_words(6),
      write_address => pathsright_read_words_6_memory_write_address, write_data => pathsright_read_words_6_memory_write_data);

  pathsright_read_words_5_memory_read_enable <= true;
  pathsright_read_words_5_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_5_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_5_memory_write_data <= to_unsigned(pathsright_arrived(7), 7) & to_unsigned(pathsright_arrived(6), 7) & to_unsigned(pathsright_arrived(5), 7) & to_unsigned(pathsright_arrived(4), 7);
  pathsright_read_words_5_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_5_memory_read_enable,
      read_address => pathsright_read_words_5_memory_read_address, read_data => pathsright_read_words(5),
      write_address => pathsright_read_words_5_memory_write_address, write_data => pathsright_read_words_5_memory_write_data);

  pathsright_read_words_4_memory_read_enable <= true;
  pathsright_read_words_4_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_4_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_4_memory_write_data <= to_unsigned(pathsright_arrived(3), 7) & to_unsigned(pathsright_arrived(2), 7) & to_unsigned(pathsright_arrived(1), 7) & to_unsigned(pathsright_arrived(0), 7);
  pathsright_read_words_4_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_4_memory_read_enable,
      read_address => pathsright_read_words_4_memory_read_address, read_data => pathsright_read_words(4),
      write_address => pathsright_read_words_4_memory_write_address, write_data => pathsright_read_words_4_memory_write_data);

  pathsright_read_words_3_memory_read_enable <= true;
  pathsright_read_words_3_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_3_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_3_memory_write_data <= to_unsigned(pathsright_cost(15), 7) & to_unsigned(pathsright_cost(14), 7) & to_unsigned(pathsright_cost(13), 7) & to_unsigned(pathsright_cost(12), 7);
  pathsright_read_words_3_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsright_read_words_3_memory_read_enable,
      read_address => pathsright_read_words_3_memory_read_address, read_data => pathsright_read_words(3),
      write_address => pathsright_read_words_3_memory_write_address, write_data => pathsright_read_words_3_memory_write_data);

  pathsright_read_words_2_memory_read_enable <= true;
  pathsright_read_words_2_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsright_read_words_2_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsright_read_words_2_memory_write_data <= to_unsigned(pathsright_cost(11), 7) & to_unsigned(pathsright_cost(10), 7) & to_unsigned(pathsright_cost(9), 7) & to_unsigned(pathsright_cost(8), 7);
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
  pathsturn_read_smallest_0_memory_read_address <= to_unsigned(pathsturn_smallest_address, 11);
  pathsturn_read_smallest_0_memory_write_address <= to_unsigned(pathsturn_write_smallest_address, 11);
  pathsturn_read_smallest_0_memory_write_data <= to_unsigned(pathsturn_write_smallest_0, 5);
  pathsturn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 1241, width => 5, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_read_smallest_0_memory_read_enable,
      read_address => pathsturn_read_smallest_0_memory_read_address, read_data => pathsturn_read_smallest_0,
      write_address => pathsturn_read_smallest_0_memory_write_address, write_data => pathsturn_read_smallest_0_memory_write_data);

  pathsturn_sum_memory_read_words_0_13_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_13_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_13_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_13_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 13), 8);
  pathsturn_sum_memory_read_words_0_13_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_13_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_13_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 13),
      write_address => pathsturn_sum_memory_read_words_0_13_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_13_memory_write_data);

  pathsturn_sum_memory_read_words_0_12_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_12_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_12_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_12_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 12), 8);
  pathsturn_sum_memory_read_words_0_12_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_12_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_12_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 12),
      write_address => pathsturn_sum_memory_read_words_0_12_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_12_memory_write_data);

  pathsturn_sum_memory_read_words_0_11_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_11_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_11_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_11_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 11), 8);
  pathsturn_sum_memory_read_words_0_11_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_11_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_11_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 11),
      write_address => pathsturn_sum_memory_read_words_0_11_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_11_memory_write_data);

  pathsturn_sum_memory_read_words_0_10_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_10_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_10_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_10_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 10), 8);
  pathsturn_sum_memory_read_words_0_10_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_10_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_10_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 10),
      write_address => pathsturn_sum_memory_read_words_0_10_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_10_memory_write_data);

  pathsturn_sum_memory_read_words_0_9_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_9_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_9_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_9_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 9), 8);
  pathsturn_sum_memory_read_words_0_9_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_9_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_9_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 9),
      write_address => pathsturn_sum_memory_read_words_0_9_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_9_memory_write_data);

  pathsturn_sum_memory_read_words_0_8_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_8_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_8_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_8_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 8), 8);
  pathsturn_sum_memory_read_words_0_8_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_8_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_8_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 8),
      write_address => pathsturn_sum_memory_read_words_0_8_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_8_memory_write_data);

  pathsturn_sum_memory_read_words_0_7_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_7_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_7_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_7_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 7), 8);
  pathsturn_sum_memory_read_words_0_7_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_7_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_7_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 7),
      write_address => pathsturn_sum_memory_read_words_0_7_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_7_memory_write_data);

  pathsturn_sum_memory_read_words_0_6_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_6_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_6_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_6_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 6), 8);
  pathsturn_sum_memory_read_words_0_6_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_6_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_6_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 6),
      write_address => pathsturn_sum_memory_read_words_0_6_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_6_memory_write_data);

  pathsturn_sum_memory_read_words_0_5_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_5_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_5_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_5_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 5), 8);
  pathsturn_sum_memory_read_words_0_5_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_5_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_5_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 5),
      write_address => pathsturn_sum_memory_read_words_0_5_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_5_memory_write_data);

  pathsturn_sum_memory_read_words_0_4_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_4_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_4_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_4_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 4), 8);
  pathsturn_sum_memory_read_words_0_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_4_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_4_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 4),
      write_address => pathsturn_sum_memory_read_words_0_4_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_4_memory_write_data);

  pathsturn_sum_memory_read_words_0_3_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_3_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_3_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_3_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 3), 8);
  pathsturn_sum_memory_read_words_0_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_3_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_3_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 3),
      write_address => pathsturn_sum_memory_read_words_0_3_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_3_memory_write_data);

  pathsturn_sum_memory_read_words_0_2_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_2_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_2_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_2_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 2), 8);
  pathsturn_sum_memory_read_words_0_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_2_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_2_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 2),
      write_address => pathsturn_sum_memory_read_words_0_2_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_2_memory_write_data);

  pathsturn_sum_memory_read_words_0_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 1), 8);
  pathsturn_sum_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_1_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 1),
      write_address => pathsturn_sum_memory_read_words_0_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_1_memory_write_data);

  pathsturn_sum_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(0), 12);
  pathsturn_sum_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, 0), 8);
  pathsturn_sum_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_0_memory_read_address, read_data => pathsturn_sum_memory_read_words(0, 0),
      write_address => pathsturn_sum_memory_read_words_0_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_0_memory_write_data);

  pathsturn_sum_memory_read_words_1_13_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_13_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_13_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_13_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 13), 8);
  pathsturn_sum_memory_read_words_1_13_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_13_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_13_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 13),
      write_address => pathsturn_sum_memory_read_words_1_13_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_13_memory_write_data);

  pathsturn_sum_memory_read_words_1_12_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_12_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_12_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_12_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 12), 8);
  pathsturn_sum_memory_read_words_1_12_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_12_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_12_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 12),
      write_address => pathsturn_sum_memory_read_words_1_12_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_12_memory_write_data);

  pathsturn_sum_memory_read_words_1_11_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_11_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_11_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_11_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 11), 8);
  pathsturn_sum_memory_read_words_1_11_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_11_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_11_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 11),
      write_address => pathsturn_sum_memory_read_words_1_11_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_11_memory_write_data);

  pathsturn_sum_memory_read_words_1_10_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_10_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_10_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_10_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 10), 8);
  pathsturn_sum_memory_read_words_1_10_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_10_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_10_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 10),
      write_address => pathsturn_sum_memory_read_words_1_10_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_10_memory_write_data);

  pathsturn_sum_memory_read_words_1_9_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_9_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_9_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_9_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 9), 8);
  pathsturn_sum_memory_read_words_1_9_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_9_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_9_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 9),
      write_address => pathsturn_sum_memory_read_words_1_9_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_9_memory_write_data);

  pathsturn_sum_memory_read_words_1_8_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_8_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_8_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_8_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 8), 8);
  pathsturn_sum_memory_read_words_1_8_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_8_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_8_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 8),
      write_address => pathsturn_sum_memory_read_words_1_8_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_8_memory_write_data);

  pathsturn_sum_memory_read_words_1_7_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_7_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_7_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_7_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 7), 8);
  pathsturn_sum_memory_read_words_1_7_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_7_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_7_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 7),
      write_address => pathsturn_sum_memory_read_words_1_7_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_7_memory_write_data);

  pathsturn_sum_memory_read_words_1_6_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_6_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_6_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_6_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 6), 8);
  pathsturn_sum_memory_read_words_1_6_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_6_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_6_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 6),
      write_address => pathsturn_sum_memory_read_words_1_6_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_6_memory_write_data);

  pathsturn_sum_memory_read_words_1_5_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_5_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_5_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_5_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 5), 8);
  pathsturn_sum_memory_read_words_1_5_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_5_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_5_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 5),
      write_address => pathsturn_sum_memory_read_words_1_5_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_5_memory_write_data);

  pathsturn_sum_memory_read_words_1_4_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_4_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_4_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_4_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 4), 8);
  pathsturn_sum_memory_read_words_1_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_4_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_4_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 4),
      write_address => pathsturn_sum_memory_read_words_1_4_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_4_memory_write_data);

  pathsturn_sum_memory_read_words_1_3_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_3_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_3_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_3_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 3), 8);
  pathsturn_sum_memory_read_words_1_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_3_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_3_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 3),
      write_address => pathsturn_sum_memory_read_words_1_3_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_3_memory_write_data);

  pathsturn_sum_memory_read_words_1_2_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_2_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_2_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_2_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 2), 8);
  pathsturn_sum_memory_read_words_1_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_2_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_2_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 2),
      write_address => pathsturn_sum_memory_read_words_1_2_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_2_memory_write_data);

  pathsturn_sum_memory_read_words_1_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 1), 8);
  pathsturn_sum_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_1_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 1),
      write_address => pathsturn_sum_memory_read_words_1_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_1_memory_write_data);

  pathsturn_sum_memory_read_words_1_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
  pathsturn_sum_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address(1), 12);
  pathsturn_sum_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, 0), 8);
  pathsturn_sum_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_1_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_1_0_memory_read_address, read_data => pathsturn_sum_memory_read_words(1, 0),
      write_address => pathsturn_sum_memory_read_words_1_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_1_0_memory_write_data);

  pathsturn_sum_memory_read_words_2_13_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_13_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_13_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_13_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 13), 8);
  pathsturn_sum_memory_read_words_2_13_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_13_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_13_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 13),
      write_address => pathsturn_sum_memory_read_words_2_13_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_13_memory_write_data);

  pathsturn_sum_memory_read_words_2_12_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_12_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_12_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_12_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 12), 8);
  pathsturn_sum_memory_read_words_2_12_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_12_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_12_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 12),
      write_address => pathsturn_sum_memory_read_words_2_12_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_12_memory_write_data);

  pathsturn_sum_memory_read_words_2_11_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_11_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_11_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_11_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 11), 8);
  pathsturn_sum_memory_read_words_2_11_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_11_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_11_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 11),
      write_address => pathsturn_sum_memory_read_words_2_11_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_11_memory_write_data);

  pathsturn_sum_memory_read_words_2_10_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_10_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_10_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_10_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 10), 8);
  pathsturn_sum_memory_read_words_2_10_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_10_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_10_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 10),
      write_address => pathsturn_sum_memory_read_words_2_10_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_10_memory_write_data);

  pathsturn_sum_memory_read_words_2_9_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_9_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_9_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_9_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 9), 8);
  pathsturn_sum_memory_read_words_2_9_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_9_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_9_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 9),
      write_address => pathsturn_sum_memory_read_words_2_9_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_9_memory_write_data);

  pathsturn_sum_memory_read_words_2_8_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_8_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_8_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_8_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 8), 8);
  pathsturn_sum_memory_read_words_2_8_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_8_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_8_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 8),
      write_address => pathsturn_sum_memory_read_words_2_8_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_8_memory_write_data);

  pathsturn_sum_memory_read_words_2_7_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_7_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_7_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_7_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 7), 8);
  pathsturn_sum_memory_read_words_2_7_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_7_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_7_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 7),
      write_address => pathsturn_sum_memory_read_words_2_7_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_7_memory_write_data);

  pathsturn_sum_memory_read_words_2_6_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_6_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_6_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_6_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 6), 8);
  pathsturn_sum_memory_read_words_2_6_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_6_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_6_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 6),
      write_address => pathsturn_sum_memory_read_words_2_6_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_6_memory_write_data);

  pathsturn_sum_memory_read_words_2_5_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_5_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_5_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_5_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 5), 8);
  pathsturn_sum_memory_read_words_2_5_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_5_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_5_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 5),
      write_address => pathsturn_sum_memory_read_words_2_5_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_5_memory_write_data);

  pathsturn_sum_memory_read_words_2_4_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_4_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_4_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_4_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 4), 8);
  pathsturn_sum_memory_read_words_2_4_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_4_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_4_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 4),
      write_address => pathsturn_sum_memory_read_words_2_4_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_4_memory_write_data);

  pathsturn_sum_memory_read_words_2_3_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_3_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_3_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_3_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 3), 8);
  pathsturn_sum_memory_read_words_2_3_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_3_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_3_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 3),
      write_address => pathsturn_sum_memory_read_words_2_3_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_3_memory_write_data);

  pathsturn_sum_memory_read_words_2_2_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_2_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_2_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_2_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 2), 8);
  pathsturn_sum_memory_read_words_2_2_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_2_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_2_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 2),
      write_address => pathsturn_sum_memory_read_words_2_2_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_2_memory_write_data);

  pathsturn_sum_memory_read_words_2_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_1_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 1), 8);
  pathsturn_sum_memory_read_words_2_1_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_1_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 1),
      write_address => pathsturn_sum_memory_read_words_2_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_1_memory_write_data);

  pathsturn_sum_memory_read_words_2_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_2_0_memory_read_address <= to_unsigned(pathsturn_sum_memory_read_address_2, 11);
  pathsturn_sum_memory_read_words_2_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_2, 11);
  pathsturn_sum_memory_read_words_2_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words(2, 0), 8);
  pathsturn_sum_memory_read_words_2_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_2_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_2_0_memory_read_address, read_data => pathsturn_sum_memory_read_words(2, 0),
      write_address => pathsturn_sum_memory_read_words_2_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_2_0_memory_write_data);

  pathsturn_cost_memory_read_words_0_5_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_5_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_5_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(0), 12);
  pathsturn_cost_memory_read_words_0_5_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(0, 5), 8);
  pathsturn_cost_memory_read_words_0_5_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_5_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_5_memory_read_address, read_data => pathsturn_cost_memory_read_words(0, 5),
      write_address => pathsturn_cost_memory_read_words_0_5_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_5_memory_write_data);

  pathsturn_cost_memory_read_words_0_4_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_4_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_4_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(0), 12);
  pathsturn_cost_memory_read_words_0_4_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(0, 4), 8);
  pathsturn_cost_memory_read_words_0_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_4_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_4_memory_read_address, read_data => pathsturn_cost_memory_read_words(0, 4),
      write_address => pathsturn_cost_memory_read_words_0_4_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_4_memory_write_data);

  pathsturn_cost_memory_read_words_0_3_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_3_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_3_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(0), 12);
  pathsturn_cost_memory_read_words_0_3_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(0, 3), 8);
  pathsturn_cost_memory_read_words_0_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_3_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_3_memory_read_address, read_data => pathsturn_cost_memory_read_words(0, 3),
      write_address => pathsturn_cost_memory_read_words_0_3_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_3_memory_write_data);

  pathsturn_cost_memory_read_words_0_2_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_2_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_2_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(0), 12);
  pathsturn_cost_memory_read_words_0_2_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(0, 2), 8);
  pathsturn_cost_memory_read_words_0_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_2_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_2_memory_read_address, read_data => pathsturn_cost_memory_read_words(0, 2),
      write_address => pathsturn_cost_memory_read_words_0_2_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_2_memory_write_data);

  pathsturn_cost_memory_read_words_0_1_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(0), 12);
  pathsturn_cost_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(0, 1), 8);
  pathsturn_cost_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_1_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_1_memory_read_address, read_data => pathsturn_cost_memory_read_words(0, 1),
      write_address => pathsturn_cost_memory_read_words_0_1_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_1_memory_write_data);

  pathsturn_cost_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(0), 12);
  pathsturn_cost_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(0, 0), 8);
  pathsturn_cost_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_0_memory_read_address, read_data => pathsturn_cost_memory_read_words(0, 0),
      write_address => pathsturn_cost_memory_read_words_0_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_0_memory_write_data);

  pathsturn_cost_memory_read_words_1_5_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_5_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_5_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(1), 12);
  pathsturn_cost_memory_read_words_1_5_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(1, 5), 8);
  pathsturn_cost_memory_read_words_1_5_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_5_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_5_memory_read_address, read_data => pathsturn_cost_memory_read_words(1, 5),
      write_address => pathsturn_cost_memory_read_words_1_5_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_5_memory_write_data);

  pathsturn_cost_memory_read_words_1_4_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_4_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_4_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(1), 12);
  pathsturn_cost_memory_read_words_1_4_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(1, 4), 8);
  pathsturn_cost_memory_read_words_1_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_4_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_4_memory_read_address, read_data => pathsturn_cost_memory_read_words(1, 4),
      write_address => pathsturn_cost_memory_read_words_1_4_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_4_memory_write_data);

  pathsturn_cost_memory_read_words_1_3_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_3_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_3_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(1), 12);
  pathsturn_cost_memory_read_words_1_3_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(1, 3), 8);
  pathsturn_cost_memory_read_words_1_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_3_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_3_memory_read_address, read_data => pathsturn_cost_memory_read_words(1, 3),
      write_address => pathsturn_cost_memory_read_words_1_3_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_3_memory_write_data);

  pathsturn_cost_memory_read_words_1_2_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_2_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_2_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(1), 12);
  pathsturn_cost_memory_read_words_1_2_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(1, 2), 8);
  pathsturn_cost_memory_read_words_1_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_2_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_2_memory_read_address, read_data => pathsturn_cost_memory_read_words(1, 2),
      write_address => pathsturn_cost_memory_read_words_1_2_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_2_memory_write_data);

  pathsturn_cost_memory_read_words_1_1_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(1), 12);
  pathsturn_cost_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(1, 1), 8);
  pathsturn_cost_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_1_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_1_memory_read_address, read_data => pathsturn_cost_memory_read_words(1, 1),
      write_address => pathsturn_cost_memory_read_words_1_1_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_1_memory_write_data);

  pathsturn_cost_memory_read_words_1_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
  pathsturn_cost_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address(1), 12);
  pathsturn_cost_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(1, 0), 8);
  pathsturn_cost_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_1_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_1_0_memory_read_address, read_data => pathsturn_cost_memory_read_words(1, 0),
      write_address => pathsturn_cost_memory_read_words_1_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_1_0_memory_write_data);

  pathsturn_cost_memory_read_words_2_5_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_5_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 11);
  pathsturn_cost_memory_read_words_2_5_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 11);
  pathsturn_cost_memory_read_words_2_5_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(2, 5), 8);
  pathsturn_cost_memory_read_words_2_5_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_5_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_5_memory_read_address, read_data => pathsturn_cost_memory_read_words(2, 5),
      write_address => pathsturn_cost_memory_read_words_2_5_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_5_memory_write_data);

  pathsturn_cost_memory_read_words_2_4_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_4_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 11);
  pathsturn_cost_memory_read_words_2_4_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 11);
  pathsturn_cost_memory_read_words_2_4_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(2, 4), 8);
  pathsturn_cost_memory_read_words_2_4_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_4_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_4_memory_read_address, read_data => pathsturn_cost_memory_read_words(2, 4),
      write_address => pathsturn_cost_memory_read_words_2_4_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_4_memory_write_data);

  pathsturn_cost_memory_read_words_2_3_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_3_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 11);
  pathsturn_cost_memory_read_words_2_3_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 11);
  pathsturn_cost_memory_read_words_2_3_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(2, 3), 8);
  pathsturn_cost_memory_read_words_2_3_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_3_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_3_memory_read_address, read_data => pathsturn_cost_memory_read_words(2, 3),
      write_address => pathsturn_cost_memory_read_words_2_3_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_3_memory_write_data);

  pathsturn_cost_memory_read_words_2_2_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_2_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 11);
  pathsturn_cost_memory_read_words_2_2_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 11);
  pathsturn_cost_memory_read_words_2_2_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(2, 2), 8);
  pathsturn_cost_memory_read_words_2_2_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_2_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_2_memory_read_address, read_data => pathsturn_cost_memory_read_words(2, 2),
      write_address => pathsturn_cost_memory_read_words_2_2_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_2_memory_write_data);

  pathsturn_cost_memory_read_words_2_1_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_1_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 11);
  pathsturn_cost_memory_read_words_2_1_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 11);
  pathsturn_cost_memory_read_words_2_1_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(2, 1), 8);
  pathsturn_cost_memory_read_words_2_1_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_1_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_1_memory_read_address, read_data => pathsturn_cost_memory_read_words(2, 1),
      write_address => pathsturn_cost_memory_read_words_2_1_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_1_memory_write_data);

  pathsturn_cost_memory_read_words_2_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_2_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_2, 11);
  pathsturn_cost_memory_read_words_2_0_memory_write_address <= to_unsigned(pathsturn_cost_memory_write_address_2, 11);
  pathsturn_cost_memory_read_words_2_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words(2, 0), 8);
  pathsturn_cost_memory_read_words_2_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_2_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_2_0_memory_read_address, read_data => pathsturn_cost_memory_read_words(2, 0),
      write_address => pathsturn_cost_memory_read_words_2_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_2_0_memory_write_data);

  pathsabove_delay_held_3_memory_read_enable <= true;
  pathsabove_delay_held_3_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  pathsabove_delay_held_3_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  pathsabove_delay_held_3_memory_write_data <= to_unsigned(pathsabove_total(15), 6);
  pathsabove_delay_held_3_memory : entity work.line_memory
    generic map (depth => 13, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_3_memory_read_enable,
      read_address => pathsabove_delay_held_3_memory_read_address, read_data => pathsabove_delay_held_3,
      write_address => pathsabove_delay_held_3_memory_write_address, write_data => pathsabove_delay_held_3_memory_write_data);

  pathsabove_delay_held_2_memory_read_enable <= true;
  pathsabove_delay_held_2_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  pathsabove_delay_held_2_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  pathsabove_delay_held_2_memory_write_data <= to_unsigned(pathsabove_total(14), 6) & to_unsigned(pathsabove_total(13), 6) & to_unsigned(pathsabove_total(12), 6) & to_unsigned(pathsabove_total(11), 6) & to_unsigned(pathsabove_total(10), 6);
  pathsabove_delay_held_2_memory : entity work.line_memory
    generic map (depth => 13, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_2_memory_read_enable,
      read_address => pathsabove_delay_held_2_memory_read_address, read_data => pathsabove_delay_held(2),
      write_address => pathsabove_delay_held_2_memory_write_address, write_data => pathsabove_delay_held_2_memory_write_data);

  pathsabove_delay_held_1_memory_read_enable <= true;
  pathsabove_delay_held_1_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  pathsabove_delay_held_1_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  pathsabove_delay_held_1_memory_write_data <= to_unsigned(pathsabove_total(9), 6) & to_unsigned(pathsabove_total(8), 6) & to_unsigned(pathsabove_total(7), 6) & to_unsigned(pathsabove_total(6), 6) & to_unsigned(pathsabove_total(5), 6);
  pathsabove_delay_held_1_memory : entity work.line_memory
    generic map (depth => 13, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_1_memory_read_enable,
      read_address => pathsabove_delay_held_1_memory_read_address, read_data => pathsabove_delay_held(1),
      write_address => pathsabove_delay_held_1_memory_write_address, write_data => pathsabove_delay_held_1_memory_write_data);

  pathsabove_delay_held_0_memory_read_enable <= true;
  pathsabove_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  pathsabove_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  pathsabove_delay_held_0_memory_write_data <= to_unsigned(pathsabove_total(4), 6) & to_unsigned(pathsabove_total(3), 6) & to_unsigned(pathsabove_total(2), 6) & to_unsigned(pathsabove_total(1), 6) & to_unsigned(pathsabove_total(0), 6);
  pathsabove_delay_held_0_memory : entity work.line_memory
    generic map (depth => 13, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_0_memory_read_enable,
      read_address => pathsabove_delay_held_0_memory_read_address, read_data => pathsabove_delay_held(0),
      write_address => pathsabove_delay_held_0_memory_write_address, write_data => pathsabove_delay_held_0_memory_write_data);

  pathsabove_memory_read_words_0_9_memory_read_enable <= true;
  pathsabove_memory_read_words_0_9_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_9_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_9_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 9), 8);
  pathsabove_memory_read_words_0_9_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_9_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_9_memory_read_address, read_data => pathsabove_memory_read_words(0, 9),
      write_address => pathsabove_memory_read_words_0_9_memory_write_address, write_data => pathsabove_memory_read_words_0_9_memory_write_data);

  pathsabove_memory_read_words_0_8_memory_read_enable <= true;
  pathsabove_memory_read_words_0_8_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_8_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_8_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 8), 8);
  pathsabove_memory_read_words_0_8_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_8_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_8_memory_read_address, read_data => pathsabove_memory_read_words(0, 8),
      write_address => pathsabove_memory_read_words_0_8_memory_write_address, write_data => pathsabove_memory_read_words_0_8_memory_write_data);

  pathsabove_memory_read_words_0_7_memory_read_enable <= true;
  pathsabove_memory_read_words_0_7_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_7_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_7_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 7), 8);
  pathsabove_memory_read_words_0_7_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_7_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_7_memory_read_address, read_data => pathsabove_memory_read_words(0, 7),
      write_address => pathsabove_memory_read_words_0_7_memory_write_address, write_data => pathsabove_memory_read_words_0_7_memory_write_data);

  pathsabove_memory_read_words_0_6_memory_read_enable <= true;
  pathsabove_memory_read_words_0_6_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_6_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_6_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 6), 8);
  pathsabove_memory_read_words_0_6_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_6_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_6_memory_read_address, read_data => pathsabove_memory_read_words(0, 6),
      write_address => pathsabove_memory_read_words_0_6_memory_write_address, write_data => pathsabove_memory_read_words_0_6_memory_write_data);

  pathsabove_memory_read_words_0_5_memory_read_enable <= true;
  pathsabove_memory_read_words_0_5_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_5_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_5_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 5), 8);
  pathsabove_memory_read_words_0_5_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_5_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_5_memory_read_address, read_data => pathsabove_memory_read_words(0, 5),
      write_address => pathsabove_memory_read_words_0_5_memory_write_address, write_data => pathsabove_memory_read_words_0_5_memory_write_data);

  pathsabove_memory_read_words_0_4_memory_read_enable <= true;
  pathsabove_memory_read_words_0_4_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_4_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_4_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 4), 8);
  pathsabove_memory_read_words_0_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_4_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_4_memory_read_address, read_data => pathsabove_memory_read_words(0, 4),
      write_address => pathsabove_memory_read_words_0_4_memory_write_address, write_data => pathsabove_memory_read_words_0_4_memory_write_data);

  pathsabove_memory_read_words_0_3_memory_read_enable <= true;
  pathsabove_memory_read_words_0_3_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_3_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_3_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 3), 8);
  pathsabove_memory_read_words_0_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_3_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_3_memory_read_address, read_data => pathsabove_memory_read_words(0, 3),
      write_address => pathsabove_memory_read_words_0_3_memory_write_address, write_data => pathsabove_memory_read_words_0_3_memory_write_data);

  pathsabove_memory_read_words_0_2_memory_read_enable <= true;
  pathsabove_memory_read_words_0_2_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_2_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_2_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 2), 8);
  pathsabove_memory_read_words_0_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_2_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_2_memory_read_address, read_data => pathsabove_memory_read_words(0, 2),
      write_address => pathsabove_memory_read_words_0_2_memory_write_address, write_data => pathsabove_memory_read_words_0_2_memory_write_data);

  pathsabove_memory_read_words_0_1_memory_read_enable <= true;
  pathsabove_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 1), 8);
  pathsabove_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_1_memory_read_address, read_data => pathsabove_memory_read_words(0, 1),
      write_address => pathsabove_memory_read_words_0_1_memory_write_address, write_data => pathsabove_memory_read_words_0_1_memory_write_data);

  pathsabove_memory_read_words_0_0_memory_read_enable <= true;
  pathsabove_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address(0), 12);
  pathsabove_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words(0, 0), 8);
  pathsabove_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_0_memory_read_address, read_data => pathsabove_memory_read_words(0, 0),
      write_address => pathsabove_memory_read_words_0_0_memory_write_address, write_data => pathsabove_memory_read_words_0_0_memory_write_data);

  pathsabove_memory_read_words_1_9_memory_read_enable <= true;
  pathsabove_memory_read_words_1_9_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_9_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_9_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 9), 8);
  pathsabove_memory_read_words_1_9_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_9_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_9_memory_read_address, read_data => pathsabove_memory_read_words(1, 9),
      write_address => pathsabove_memory_read_words_1_9_memory_write_address, write_data => pathsabove_memory_read_words_1_9_memory_write_data);

  pathsabove_memory_read_words_1_8_memory_read_enable <= true;
  pathsabove_memory_read_words_1_8_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_8_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_8_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 8), 8);
  pathsabove_memory_read_words_1_8_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_8_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_8_memory_read_address, read_data => pathsabove_memory_read_words(1, 8),
      write_address => pathsabove_memory_read_words_1_8_memory_write_address, write_data => pathsabove_memory_read_words_1_8_memory_write_data);

  pathsabove_memory_read_words_1_7_memory_read_enable <= true;
  pathsabove_memory_read_words_1_7_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_7_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_7_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 7), 8);
  pathsabove_memory_read_words_1_7_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_7_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_7_memory_read_address, read_data => pathsabove_memory_read_words(1, 7),
      write_address => pathsabove_memory_read_words_1_7_memory_write_address, write_data => pathsabove_memory_read_words_1_7_memory_write_data);

  pathsabove_memory_read_words_1_6_memory_read_enable <= true;
  pathsabove_memory_read_words_1_6_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_6_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_6_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 6), 8);
  pathsabove_memory_read_words_1_6_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_6_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_6_memory_read_address, read_data => pathsabove_memory_read_words(1, 6),
      write_address => pathsabove_memory_read_words_1_6_memory_write_address, write_data => pathsabove_memory_read_words_1_6_memory_write_data);

  pathsabove_memory_read_words_1_5_memory_read_enable <= true;
  pathsabove_memory_read_words_1_5_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_5_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_5_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 5), 8);
  pathsabove_memory_read_words_1_5_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_5_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_5_memory_read_address, read_data => pathsabove_memory_read_words(1, 5),
      write_address => pathsabove_memory_read_words_1_5_memory_write_address, write_data => pathsabove_memory_read_words_1_5_memory_write_data);

  pathsabove_memory_read_words_1_4_memory_read_enable <= true;
  pathsabove_memory_read_words_1_4_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_4_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_4_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 4), 8);
  pathsabove_memory_read_words_1_4_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_4_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_4_memory_read_address, read_data => pathsabove_memory_read_words(1, 4),
      write_address => pathsabove_memory_read_words_1_4_memory_write_address, write_data => pathsabove_memory_read_words_1_4_memory_write_data);

  pathsabove_memory_read_words_1_3_memory_read_enable <= true;
  pathsabove_memory_read_words_1_3_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_3_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_3_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 3), 8);
  pathsabove_memory_read_words_1_3_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_3_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_3_memory_read_address, read_data => pathsabove_memory_read_words(1, 3),
      write_address => pathsabove_memory_read_words_1_3_memory_write_address, write_data => pathsabove_memory_read_words_1_3_memory_write_data);

  pathsabove_memory_read_words_1_2_memory_read_enable <= true;
  pathsabove_memory_read_words_1_2_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_2_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_2_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 2), 8);
  pathsabove_memory_read_words_1_2_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_2_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_2_memory_read_address, read_data => pathsabove_memory_read_words(1, 2),
      write_address => pathsabove_memory_read_words_1_2_memory_write_address, write_data => pathsabove_memory_read_words_1_2_memory_write_data);

  pathsabove_memory_read_words_1_1_memory_read_enable <= true;
  pathsabove_memory_read_words_1_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 1), 8);
  pathsabove_memory_read_words_1_1_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_1_memory_read_address, read_data => pathsabove_memory_read_words(1, 1),
      write_address => pathsabove_memory_read_words_1_1_memory_write_address, write_data => pathsabove_memory_read_words_1_1_memory_write_data);

  pathsabove_memory_read_words_1_0_memory_read_enable <= true;
  pathsabove_memory_read_words_1_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
  pathsabove_memory_read_words_1_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address(1), 12);
  pathsabove_memory_read_words_1_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words(1, 0), 8);
  pathsabove_memory_read_words_1_0_memory : entity work.line_memory
    generic map (depth => 4096, width => 8, address_bits => 12)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_1_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_1_0_memory_read_address, read_data => pathsabove_memory_read_words(1, 0),
      write_address => pathsabove_memory_read_words_1_0_memory_write_address, write_data => pathsabove_memory_read_words_1_0_memory_write_data);

  pathsabove_memory_read_words_2_9_memory_read_enable <= true;
  pathsabove_memory_read_words_2_9_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_9_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_9_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 9), 8);
  pathsabove_memory_read_words_2_9_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_9_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_9_memory_read_address, read_data => pathsabove_memory_read_words(2, 9),
      write_address => pathsabove_memory_read_words_2_9_memory_write_address, write_data => pathsabove_memory_read_words_2_9_memory_write_data);

  pathsabove_memory_read_words_2_8_memory_read_enable <= true;
  pathsabove_memory_read_words_2_8_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_8_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_8_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 8), 8);
  pathsabove_memory_read_words_2_8_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_8_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_8_memory_read_address, read_data => pathsabove_memory_read_words(2, 8),
      write_address => pathsabove_memory_read_words_2_8_memory_write_address, write_data => pathsabove_memory_read_words_2_8_memory_write_data);

  pathsabove_memory_read_words_2_7_memory_read_enable <= true;
  pathsabove_memory_read_words_2_7_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_7_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_7_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 7), 8);
  pathsabove_memory_read_words_2_7_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_7_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_7_memory_read_address, read_data => pathsabove_memory_read_words(2, 7),
      write_address => pathsabove_memory_read_words_2_7_memory_write_address, write_data => pathsabove_memory_read_words_2_7_memory_write_data);

  pathsabove_memory_read_words_2_6_memory_read_enable <= true;
  pathsabove_memory_read_words_2_6_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_6_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_6_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 6), 8);
  pathsabove_memory_read_words_2_6_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_6_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_6_memory_read_address, read_data => pathsabove_memory_read_words(2, 6),
      write_address => pathsabove_memory_read_words_2_6_memory_write_address, write_data => pathsabove_memory_read_words_2_6_memory_write_data);

  pathsabove_memory_read_words_2_5_memory_read_enable <= true;
  pathsabove_memory_read_words_2_5_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_5_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_5_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 5), 8);
  pathsabove_memory_read_words_2_5_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_5_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_5_memory_read_address, read_data => pathsabove_memory_read_words(2, 5),
      write_address => pathsabove_memory_read_words_2_5_memory_write_address, write_data => pathsabove_memory_read_words_2_5_memory_write_data);

  pathsabove_memory_read_words_2_4_memory_read_enable <= true;
  pathsabove_memory_read_words_2_4_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_4_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_4_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 4), 8);
  pathsabove_memory_read_words_2_4_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_4_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_4_memory_read_address, read_data => pathsabove_memory_read_words(2, 4),
      write_address => pathsabove_memory_read_words_2_4_memory_write_address, write_data => pathsabove_memory_read_words_2_4_memory_write_data);

  pathsabove_memory_read_words_2_3_memory_read_enable <= true;
  pathsabove_memory_read_words_2_3_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_3_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_3_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 3), 8);
  pathsabove_memory_read_words_2_3_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_3_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_3_memory_read_address, read_data => pathsabove_memory_read_words(2, 3),
      write_address => pathsabove_memory_read_words_2_3_memory_write_address, write_data => pathsabove_memory_read_words_2_3_memory_write_data);

  pathsabove_memory_read_words_2_2_memory_read_enable <= true;
  pathsabove_memory_read_words_2_2_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_2_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_2_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 2), 8);
  pathsabove_memory_read_words_2_2_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_2_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_2_memory_read_address, read_data => pathsabove_memory_read_words(2, 2),
      write_address => pathsabove_memory_read_words_2_2_memory_write_address, write_data => pathsabove_memory_read_words_2_2_memory_write_data);

  pathsabove_memory_read_words_2_1_memory_read_enable <= true;
  pathsabove_memory_read_words_2_1_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_1_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_1_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 1), 8);
  pathsabove_memory_read_words_2_1_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_1_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_1_memory_read_address, read_data => pathsabove_memory_read_words(2, 1),
      write_address => pathsabove_memory_read_words_2_1_memory_write_address, write_data => pathsabove_memory_read_words_2_1_memory_write_data);

  pathsabove_memory_read_words_2_0_memory_read_enable <= true;
  pathsabove_memory_read_words_2_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_2, 11);
  pathsabove_memory_read_words_2_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_2, 11);
  pathsabove_memory_read_words_2_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words(2, 0), 8);
  pathsabove_memory_read_words_2_0_memory : entity work.line_memory
    generic map (depth => 2048, width => 8, address_bits => 11)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_2_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_2_0_memory_read_address, read_data => pathsabove_memory_read_words(2, 0),
      write_address => pathsabove_memory_read_words_2_0_memory_write_address, write_data => pathsabove_memory_read_words_2_0_memory_write_data);

  pathsleft_read_words_7_memory_read_enable <= true;
  pathsleft_read_words_7_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_7_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_7_memory_write_data <= to_unsigned(pathsleft_arrived(15), 7) & to_unsigned(pathsleft_arrived(14), 7) & to_unsigned(pathsleft_arrived(13), 7) & to_unsigned(pathsleft_arrived(12), 7);
  pathsleft_read_words_7_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_7_memory_read_enable,
      read_address => pathsleft_read_words_7_memory_read_address, read_data => pathsleft_read_words(7),
      write_address => pathsleft_read_words_7_memory_write_address, write_data => pathsleft_read_words_7_memory_write_data);

  pathsleft_read_words_6_memory_read_enable <= true;
  pathsleft_read_words_6_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_6_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_6_memory_write_data <= to_unsigned(pathsleft_arrived(11), 7) & to_unsigned(pathsleft_arrived(10), 7) & to_unsigned(pathsleft_arrived(9), 7) & to_unsigned(pathsleft_arrived(8), 7);
  pathsleft_read_words_6_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_6_memory_read_enable,
      read_address => pathsleft_read_words_6_memory_read_address, read_data => pathsleft_read_words(6),
      write_address => pathsleft_read_words_6_memory_write_address, write_data => pathsleft_read_words_6_memory_write_data);

  pathsleft_read_words_5_memory_read_enable <= true;
  pathsleft_read_words_5_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_5_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_5_memory_write_data <= to_unsigned(pathsleft_arrived(7), 7) & to_unsigned(pathsleft_arrived(6), 7) & to_unsigned(pathsleft_arrived(5), 7) & to_unsigned(pathsleft_arrived(4), 7);
  pathsleft_read_words_5_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_5_memory_read_enable,
      read_address => pathsleft_read_words_5_memory_read_address, read_data => pathsleft_read_words(5),
      write_address => pathsleft_read_words_5_memory_write_address, write_data => pathsleft_read_words_5_memory_write_data);

  pathsleft_read_words_4_memory_read_enable <= true;
  pathsleft_read_words_4_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_4_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_4_memory_write_data <= to_unsigned(pathsleft_arrived(3), 7) & to_unsigned(pathsleft_arrived(2), 7) & to_unsigned(pathsleft_arrived(1), 7) & to_unsigned(pathsleft_arrived(0), 7);
  pathsleft_read_words_4_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_4_memory_read_enable,
      read_address => pathsleft_read_words_4_memory_read_address, read_data => pathsleft_read_words(4),
      write_address => pathsleft_read_words_4_memory_write_address, write_data => pathsleft_read_words_4_memory_write_data);

  pathsleft_read_words_3_memory_read_enable <= true;
  pathsleft_read_words_3_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_3_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_3_memory_write_data <= to_unsigned(pathsleft_cost(15), 7) & to_unsigned(pathsleft_cost(14), 7) & to_unsigned(pathsleft_cost(13), 7) & to_unsigned(pathsleft_cost(12), 7);
  pathsleft_read_words_3_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsleft_read_words_3_memory_read_enable,
      read_address => pathsleft_read_words_3_memory_read_address, read_data => pathsleft_read_words(3),
      write_address => pathsleft_read_words_3_memory_write_address, write_data => pathsleft_read_words_3_memory_write_data);

  pathsleft_read_words_2_memory_read_enable <= true;
  pathsleft_read_words_2_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 3);
  pathsleft_read_words_2_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 3);
  pathsleft_read_words_2_memory_write_data <= to_unsigned(pathsleft_cost(11), 7) & to_unsigned(pathsleft_cost(10), 7) & to_unsigned(pathsleft_cost(9), 7) & to_unsigned(pathsleft_cost(8), 7);
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

  paths_cost_delay_held_1_memory_read_enable <= true;
  paths_cost_delay_held_1_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  paths_cost_delay_held_1_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  paths_cost_delay_held_1_memory_write_data <= ((((((((((to_unsigned(costs_cost(14), 6) & to_unsigned(0, 12)) or (to_unsigned((costs_cost(15) mod 8), 3) & to_unsigned(0, 15)))) or (to_unsigned(costs_cost(13), 9) & to_unsigned(0, 9)))) or (to_unsigned(costs_cost(12), 12) & to_unsigned(0, 6)))) or (to_unsigned(costs_cost(10), 18)))) or (to_unsigned(costs_cost(11), 15) & to_unsigned(0, 3)));
  paths_cost_delay_held_1_memory : entity work.line_memory
    generic map (depth => 13, width => 18, address_bits => 4)
    port map (
      clock => clock, read_enable => paths_cost_delay_held_1_memory_read_enable,
      read_address => paths_cost_delay_held_1_memory_read_address, read_data => paths_cost_delay_held_1,
      write_address => paths_cost_delay_held_1_memory_write_address, write_data => paths_cost_delay_held_1_memory_write_data);

  paths_cost_delay_held_0_memory_read_enable <= true;
  paths_cost_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
  paths_cost_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
  paths_cost_delay_held_0_memory_write_data <= ((((((((((((((((((to_unsigned(costs_cost(8), 6) & to_unsigned(0, 24)) or (to_unsigned((costs_cost(9) mod 8), 3) & to_unsigned(0, 27)))) or (to_unsigned(costs_cost(7), 9) & to_unsigned(0, 21)))) or (to_unsigned(costs_cost(6), 12) & to_unsigned(0, 18)))) or (to_unsigned(costs_cost(5), 15) & to_unsigned(0, 15)))) or (to_unsigned(costs_cost(4), 18) & to_unsigned(0, 12)))) or (to_unsigned(costs_cost(3), 21) & to_unsigned(0, 9)))) or (to_unsigned(costs_cost(2), 24) & to_unsigned(0, 6)))) or (to_unsigned(costs_cost(0), 30)))) or (to_unsigned(costs_cost(1), 27) & to_unsigned(0, 3)));
  paths_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 13, width => 30, address_bits => 4)
    port map (
      clock => clock, read_enable => paths_cost_delay_held_0_memory_read_enable,
      read_address => paths_cost_delay_held_0_memory_read_address, read_data => paths_cost_delay_held_0,
      write_address => paths_cost_delay_held_0_memory_write_address, write_data => paths_cost_delay_held_0_memory_write_data);

  relief_turned_0_memory_read_enable <= true;
  relief_turned_0_memory_read_address <= to_unsigned(line_order_address, 11);
  relief_turned_0_memory_write_address <= to_unsigned(relief_write_address, 11);
  relief_turned_0_memory_write_data <= to_unsigned(relief_write_turned_0, 6);
  relief_turned_0_memory : entity work.line_memory
    generic map (depth => 1241, width => 6, address_bits => 11)
    port map (
      clock => clock, read_enable => relief_turned_0_memory_read_enable,
      read_address => relief_turned_0_memory_read_address, read_data => relief_turned_0,
      write_address => relief_turned_0_memory_write_address, write_data => relief_turned_0_memory_write_data);

  relief_rows_read_words_0_memory_read_enable <= true;
  relief_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 11);
  relief_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 11);
  relief_rows_read_words_0_memory_write_data <= to_unsigned(relief_rows_write_words_0, 6);
  relief_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1242, width => 6, address_bits => 11)
    port map (
      clock => clock, read_enable => relief_rows_read_words_0_memory_read_enable,
      read_address => relief_rows_read_words_0_memory_read_address, read_data => relief_rows_read_words_0,
      write_address => relief_rows_read_words_0_memory_write_address, write_data => relief_rows_read_words_0_memory_write_data);

  costswindow_read_words_7_memory_read_enable <= true;
  costswindow_read_words_7_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_7_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_7_memory_write_data <= to_unsigned(costswindow_partials(31), 7) & to_unsigned(costswindow_partials(30), 7) & to_unsigned(costswindow_partials(29), 7) & to_unsigned(costswindow_partials(28), 7);
  costswindow_read_words_7_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_7_memory_read_enable,
      read_address => costswindow_read_words_7_memory_read_address, read_data => costswindow_read_wordss(7),
      write_address => costswindow_read_words_7_memory_write_address, write_data => costswindow_read_words_7_memory_write_data);

  costswindow_read_words_6_memory_read_enable <= true;
  costswindow_read_words_6_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_6_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_6_memory_write_data <= to_unsigned(costswindow_partials(27), 7) & to_unsigned(costswindow_partials(26), 7) & to_unsigned(costswindow_partials(25), 7) & to_unsigned(costswindow_partials(24), 7);
  costswindow_read_words_6_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_6_memory_read_enable,
      read_address => costswindow_read_words_6_memory_read_address, read_data => costswindow_read_wordss(6),
      write_address => costswindow_read_words_6_memory_write_address, write_data => costswindow_read_words_6_memory_write_data);

  costswindow_read_words_5_memory_read_enable <= true;
  costswindow_read_words_5_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_5_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_5_memory_write_data <= to_unsigned(costswindow_partials(23), 7) & to_unsigned(costswindow_partials(22), 7) & to_unsigned(costswindow_partials(21), 7) & to_unsigned(costswindow_partials(20), 7);
  costswindow_read_words_5_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_5_memory_read_enable,
      read_address => costswindow_read_words_5_memory_read_address, read_data => costswindow_read_wordss(5),
      write_address => costswindow_read_words_5_memory_write_address, write_data => costswindow_read_words_5_memory_write_data);

  costswindow_read_words_4_memory_read_enable <= true;
  costswindow_read_words_4_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_4_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_4_memory_write_data <= to_unsigned(costswindow_partials(19), 7) & to_unsigned(costswindow_partials(18), 7) & to_unsigned(costswindow_partials(17), 7) & to_unsigned(costswindow_partials(16), 7);
  costswindow_read_words_4_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_4_memory_read_enable,
      read_address => costswindow_read_words_4_memory_read_address, read_data => costswindow_read_wordss(4),
      write_address => costswindow_read_words_4_memory_write_address, write_data => costswindow_read_words_4_memory_write_data);

  costswindow_read_words_3_memory_read_enable <= true;
  costswindow_read_words_3_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_3_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_3_memory_write_data <= to_unsigned(costswindow_partial(15), 6) & to_unsigned(costswindow_partial(14), 7) & to_unsigned(costswindow_partial(13), 7) & to_unsigned(costswindow_partial(12), 7);
  costswindow_read_words_3_memory : entity work.line_memory
    generic map (depth => 8, width => 27, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_3_memory_read_enable,
      read_address => costswindow_read_words_3_memory_read_address, read_data => costswindow_read_words(3),
      write_address => costswindow_read_words_3_memory_write_address, write_data => costswindow_read_words_3_memory_write_data);

  costswindow_read_words_2_memory_read_enable <= true;
  costswindow_read_words_2_memory_read_address <= to_unsigned(costswindow_read_count_phase, 3);
  costswindow_read_words_2_memory_write_address <= to_unsigned(costswindow_write_count_phase, 3);
  costswindow_read_words_2_memory_write_data <= to_unsigned(costswindow_partial(11), 6) & to_unsigned(costswindow_partial(10), 7) & to_unsigned(costswindow_partial(9), 7) & to_unsigned(costswindow_partial(8), 7);
  costswindow_read_words_2_memory : entity work.line_memory
    generic map (depth => 8, width => 27, address_bits => 3)
    port map (
      clock => clock, read_enable => costswindow_read_words_2_memory_read_enable,
      read_address => costswindow_read_words_2_memory_read_address, read_data => costswindow_read_words(2),
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

  costsshift_read_words_23_memory_read_enable <= true;
  costsshift_read_words_23_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_23_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_23_memory_write_data <= to_unsigned(costsshift_search(2, 15), 14) & to_unsigned(costsshift_search(2, 14), 14);
  costsshift_read_words_23_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_23_memory_read_enable,
      read_address => costsshift_read_words_23_memory_read_address, read_data => costsshift_read_words(23),
      write_address => costsshift_read_words_23_memory_write_address, write_data => costsshift_read_words_23_memory_write_data);

  costsshift_read_words_22_memory_read_enable <= true;
  costsshift_read_words_22_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_22_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_22_memory_write_data <= to_unsigned(costsshift_search(2, 13), 14) & to_unsigned(costsshift_search(2, 12), 14);
  costsshift_read_words_22_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_22_memory_read_enable,
      read_address => costsshift_read_words_22_memory_read_address, read_data => costsshift_read_words(22),
      write_address => costsshift_read_words_22_memory_write_address, write_data => costsshift_read_words_22_memory_write_data);

  costsshift_read_words_21_memory_read_enable <= true;
  costsshift_read_words_21_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_21_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_21_memory_write_data <= to_unsigned(costsshift_search(2, 11), 14) & to_unsigned(costsshift_search(2, 10), 14);
  costsshift_read_words_21_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_21_memory_read_enable,
      read_address => costsshift_read_words_21_memory_read_address, read_data => costsshift_read_words(21),
      write_address => costsshift_read_words_21_memory_write_address, write_data => costsshift_read_words_21_memory_write_data);

  costsshift_read_words_20_memory_read_enable <= true;
  costsshift_read_words_20_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_20_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_20_memory_write_data <= to_unsigned(costsshift_search(2, 9), 14) & to_unsigned(costsshift_search(2, 8), 14);
  costsshift_read_words_20_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_20_memory_read_enable,
      read_address => costsshift_read_words_20_memory_read_address, read_data => costsshift_read_words(20),
      write_address => costsshift_read_words_20_memory_write_address, write_data => costsshift_read_words_20_memory_write_data);

  costsshift_read_words_19_memory_read_enable <= true;
  costsshift_read_words_19_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_19_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_19_memory_write_data <= to_unsigned(costsshift_search(2, 7), 14) & to_unsigned(costsshift_search(2, 6), 14);
  costsshift_read_words_19_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_19_memory_read_enable,
      read_address => costsshift_read_words_19_memory_read_address, read_data => costsshift_read_words(19),
      write_address => costsshift_read_words_19_memory_write_address, write_data => costsshift_read_words_19_memory_write_data);

  costsshift_read_words_18_memory_read_enable <= true;
  costsshift_read_words_18_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_18_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_18_memory_write_data <= to_unsigned(costsshift_search(2, 5), 14) & to_unsigned(costsshift_search(2, 4), 14);
  costsshift_read_words_18_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_18_memory_read_enable,
      read_address => costsshift_read_words_18_memory_read_address, read_data => costsshift_read_words(18),
      write_address => costsshift_read_words_18_memory_write_address, write_data => costsshift_read_words_18_memory_write_data);

  costsshift_read_words_17_memory_read_enable <= true;
  costsshift_read_words_17_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_17_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_17_memory_write_data <= to_unsigned(costsshift_search(2, 3), 14) & to_unsigned(costsshift_search(2, 2), 14);
  costsshift_read_words_17_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_17_memory_read_enable,
      read_address => costsshift_read_words_17_memory_read_address, read_data => costsshift_read_words(17),
      write_address => costsshift_read_words_17_memory_write_address, write_data => costsshift_read_words_17_memory_write_data);

  costsshift_read_words_16_memory_read_enable <= true;
  costsshift_read_words_16_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_16_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_16_memory_write_data <= to_unsigned(costsshift_search(2, 1), 14) & to_unsigned(costsshift_search(2, 0), 14);
  costsshift_read_words_16_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_16_memory_read_enable,
      read_address => costsshift_read_words_16_memory_read_address, read_data => costsshift_read_words(16),
      write_address => costsshift_read_words_16_memory_write_address, write_data => costsshift_read_words_16_memory_write_data);

  costsshift_read_words_15_memory_read_enable <= true;
  costsshift_read_words_15_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_15_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_15_memory_write_data <= to_unsigned(costsshift_search(1, 15), 14) & to_unsigned(costsshift_search(1, 14), 14);
  costsshift_read_words_15_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_15_memory_read_enable,
      read_address => costsshift_read_words_15_memory_read_address, read_data => costsshift_read_words(15),
      write_address => costsshift_read_words_15_memory_write_address, write_data => costsshift_read_words_15_memory_write_data);

  costsshift_read_words_14_memory_read_enable <= true;
  costsshift_read_words_14_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_14_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_14_memory_write_data <= to_unsigned(costsshift_search(1, 13), 14) & to_unsigned(costsshift_search(1, 12), 14);
  costsshift_read_words_14_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_14_memory_read_enable,
      read_address => costsshift_read_words_14_memory_read_address, read_data => costsshift_read_words(14),
      write_address => costsshift_read_words_14_memory_write_address, write_data => costsshift_read_words_14_memory_write_data);

  costsshift_read_words_13_memory_read_enable <= true;
  costsshift_read_words_13_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_13_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_13_memory_write_data <= to_unsigned(costsshift_search(1, 11), 14) & to_unsigned(costsshift_search(1, 10), 14);
  costsshift_read_words_13_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_13_memory_read_enable,
      read_address => costsshift_read_words_13_memory_read_address, read_data => costsshift_read_words(13),
      write_address => costsshift_read_words_13_memory_write_address, write_data => costsshift_read_words_13_memory_write_data);

  costsshift_read_words_12_memory_read_enable <= true;
  costsshift_read_words_12_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_12_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_12_memory_write_data <= to_unsigned(costsshift_search(1, 9), 14) & to_unsigned(costsshift_search(1, 8), 14);
  costsshift_read_words_12_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_12_memory_read_enable,
      read_address => costsshift_read_words_12_memory_read_address, read_data => costsshift_read_words(12),
      write_address => costsshift_read_words_12_memory_write_address, write_data => costsshift_read_words_12_memory_write_data);

  costsshift_read_words_11_memory_read_enable <= true;
  costsshift_read_words_11_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_11_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_11_memory_write_data <= to_unsigned(costsshift_search(1, 7), 14) & to_unsigned(costsshift_search(1, 6), 14);
  costsshift_read_words_11_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_11_memory_read_enable,
      read_address => costsshift_read_words_11_memory_read_address, read_data => costsshift_read_words(11),
      write_address => costsshift_read_words_11_memory_write_address, write_data => costsshift_read_words_11_memory_write_data);

  costsshift_read_words_10_memory_read_enable <= true;
  costsshift_read_words_10_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_10_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_10_memory_write_data <= to_unsigned(costsshift_search(1, 5), 14) & to_unsigned(costsshift_search(1, 4), 14);
  costsshift_read_words_10_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_10_memory_read_enable,
      read_address => costsshift_read_words_10_memory_read_address, read_data => costsshift_read_words(10),
      write_address => costsshift_read_words_10_memory_write_address, write_data => costsshift_read_words_10_memory_write_data);

  costsshift_read_words_9_memory_read_enable <= true;
  costsshift_read_words_9_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_9_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_9_memory_write_data <= to_unsigned(costsshift_search(1, 3), 14) & to_unsigned(costsshift_search(1, 2), 14);
  costsshift_read_words_9_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_9_memory_read_enable,
      read_address => costsshift_read_words_9_memory_read_address, read_data => costsshift_read_words(9),
      write_address => costsshift_read_words_9_memory_write_address, write_data => costsshift_read_words_9_memory_write_data);

  costsshift_read_words_8_memory_read_enable <= true;
  costsshift_read_words_8_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_8_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_8_memory_write_data <= to_unsigned(costsshift_search(1, 1), 14) & to_unsigned(costsshift_search(1, 0), 14);
  costsshift_read_words_8_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_8_memory_read_enable,
      read_address => costsshift_read_words_8_memory_read_address, read_data => costsshift_read_words(8),
      write_address => costsshift_read_words_8_memory_write_address, write_data => costsshift_read_words_8_memory_write_data);

  costsshift_read_words_7_memory_read_enable <= true;
  costsshift_read_words_7_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_7_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_7_memory_write_data <= to_unsigned(costsshift_search(0, 15), 14) & to_unsigned(costsshift_search(0, 14), 14);
  costsshift_read_words_7_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_7_memory_read_enable,
      read_address => costsshift_read_words_7_memory_read_address, read_data => costsshift_read_words(7),
      write_address => costsshift_read_words_7_memory_write_address, write_data => costsshift_read_words_7_memory_write_data);

  costsshift_read_words_6_memory_read_enable <= true;
  costsshift_read_words_6_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_6_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_6_memory_write_data <= to_unsigned(costsshift_search(0, 13), 14) & to_unsigned(costsshift_search(0, 12), 14);
  costsshift_read_words_6_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_6_memory_read_enable,
      read_address => costsshift_read_words_6_memory_read_address, read_data => costsshift_read_words(6),
      write_address => costsshift_read_words_6_memory_write_address, write_data => costsshift_read_words_6_memory_write_data);

  costsshift_read_words_5_memory_read_enable <= true;
  costsshift_read_words_5_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_5_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_5_memory_write_data <= to_unsigned(costsshift_search(0, 11), 14) & to_unsigned(costsshift_search(0, 10), 14);
  costsshift_read_words_5_memory : entity work.line_memory
    generic map (depth => 8, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => costsshift_read_words_5_memory_read_enable,
      read_address => costsshift_read_words_5_memory_read_address, read_data => costsshift_read_words(5),
      write_address => costsshift_read_words_5_memory_write_address, write_data => costsshift_read_words_5_memory_write_data);

  costsshift_read_words_4_memory_read_enable <= true;
  costsshift_read_words_4_memory_read_address <= to_unsigned(costsshift_count_phase, 3);
  costsshift_read_words_4_memory_write_address <= to_unsigned(costsshift_write_phase, 3);
  costsshift_read_words_4_memory_write_data <= to_unsigned(costsshift_search(0, 9), 14) & to_unsigned(costsshift_search(0, 8), 14);
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
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 11);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 11);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1242, width => 28, address_bits => 11)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 11);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 11);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1242, width => 28, address_bits => 11)
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
    variable pathsleft_stay_choice : boolean_1d(0 to 15);  -- pathsleft_stay_#_choice
    variable pathsleft_stay_choices : boolean_2d(0 to 15, 2 to 15);  -- pathsleft_stay_#_choice_#
    variable pathsleft_stay_value_2 : boolean_1d(0 to 3);  -- pathsleft_stay_#_value_2
    variable pathsleft_stay_0_values : boolean_1d(3 to 4);  -- pathsleft_stay_0_value_#
    variable pathsleft_stay_0_values_from_5 : boolean_1d(5 to 10);  -- pathsleft_stay_0_value_#
    variable pathsleft_stay_values : boolean_1d(5 to 7);  -- pathsleft_stay_#_value
    variable pathsleft_stay_value_2s : boolean_1d(5 to 7);  -- pathsleft_stay_#_value_2
    variable pathsleft_stay_values_from_9 : boolean_1d(9 to 11);  -- pathsleft_stay_#_value
    variable pathsleft_stay_value_2s_from_9 : boolean_1d(9 to 11);  -- pathsleft_stay_#_value_2
    variable pathsleft_stay_values_from_13 : boolean_1d(13 to 15);  -- pathsleft_stay_#_value
    variable pathsleft_stay_value_2s_from_13 : boolean_1d(13 to 15);  -- pathsleft_stay_#_value_2
    variable pathsleft_cost_0_any, pathsabove_memory_ready_words_0_is_equal : boolean;
    variable pathsabove_memory_ready_words_0_is_equal_2, pathsabove_ready_top_choice : boolean;
    variable pathsabove_ready_top_choice_2, pathsabove_count_phase_is_equal : boolean;
    variable pathsabove_memory_write_words_0_is_less : boolean_1d(0 to 3);  -- pathsabove_memory_write_words_0_#_is_less
    variable pathsabove_memory_write_words_0_1_choice_3 : boolean;
    variable pathsabove_memory_write_words_0_is_lesss : boolean_1d(5 to 8);  -- pathsabove_memory_write_words_0_#_is_less
    variable pathsabove_memory_write_words_0_6_choice_3 : boolean;
    variable pathsabove_memory_write_words_0_all : boolean_1d(0 to 2);  -- pathsabove_memory_write_words_#_0_all
    variable pathsturn_sum_memory_ready_words_0_is_equal, pathsturn_sum_memory_ready_words_0_is_equal_2 : boolean;
    variable pathsturn_cost_memory_ready_words_0_is_equal, pathsturn_cost_memory_ready_words_0_is_equal_2 : boolean;
    variable pathsturn_sum_memory_write_words_0_all : boolean_1d(0 to 2);  -- pathsturn_sum_memory_write_words_#_0_all
    variable pathsturn_cost_memory_write_words_0_all : boolean_1d(0 to 2);  -- pathsturn_cost_memory_write_words_#_0_all
    variable pathsright_stay_value : boolean_1d(0 to 3);  -- pathsright_stay_#_value
    variable pathsright_stay_0_is_equal : boolean;
    variable pathsright_stay_choice : boolean_1d(0 to 15);  -- pathsright_stay_#_choice
    variable pathsright_stay_choices : boolean_2d(0 to 15, 2 to 15);  -- pathsright_stay_#_choice_#
    variable pathsright_stay_value_2 : boolean_1d(0 to 3);  -- pathsright_stay_#_value_2
    variable pathsright_stay_0_values : boolean_1d(3 to 4);  -- pathsright_stay_0_value_#
    variable pathsright_stay_0_values_from_5 : boolean_1d(5 to 10);  -- pathsright_stay_0_value_#
    variable pathsright_stay_values : boolean_1d(5 to 7);  -- pathsright_stay_#_value
    variable pathsright_stay_value_2s : boolean_1d(5 to 7);  -- pathsright_stay_#_value_2
    variable pathsright_stay_values_from_9 : boolean_1d(9 to 11);  -- pathsright_stay_#_value
    variable pathsright_stay_value_2s_from_9 : boolean_1d(9 to 11);  -- pathsright_stay_#_value_2
    variable pathsright_stay_values_from_13 : boolean_1d(13 to 15);  -- pathsright_stay_#_value
    variable pathsright_stay_value_2s_from_13 : boolean_1d(13 to 15);  -- pathsright_stay_#_value_2
    variable winnerswinner1_best_index_0_choice : boolean_1d(0 to 7);  -- winnerswinner1_best_index_0_#_choice
    variable winnerswinner1_best_index_0_value : boolean_1d(0 to 7);  -- winnerswinner1_best_index_0_#_value
    variable winnerswinner1_best_index_0_values : boolean_2d(0 to 7, 2 to 12);  -- winnerswinner1_best_index_0_#_value_#
    variable winnerswinner1_best_index_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner1_best_index_0_0_choice_#
    variable winnerswinner1_best_index_0_choices : boolean_2d(1 to 7, 2 to 8);  -- winnerswinner1_best_index_0_#_choice_#
    variable winnerswinner2_best_index_0_choice : boolean_1d(0 to 3);  -- winnerswinner2_best_index_0_#_choice
    variable winnerswinner2_best_index_0_choices : boolean_2d(0 to 3, 2 to 8);  -- winnerswinner2_best_index_0_#_choice_#
    variable winnerswinner2_best_index_0_value : boolean_1d(0 to 3);  -- winnerswinner2_best_index_0_#_value
    variable winnerswinner2_best_index_0_values : boolean_2d(0 to 3, 2 to 5);  -- winnerswinner2_best_index_0_#_value_#
    variable winnerswinner3_best_index_0_choice : boolean_1d(0 to 1);  -- winnerswinner3_best_index_0_#_choice
    variable winnerswinner3_best_index_0_choices : boolean_2d(0 to 1, 2 to 8);  -- winnerswinner3_best_index_0_#_choice_#
    variable winnerswinner3_best_index_0_value : boolean_1d(0 to 1);  -- winnerswinner3_best_index_0_#_value
    variable winnerswinner3_best_index_0_values : boolean_2d(0 to 1, 2 to 5);  -- winnerswinner3_best_index_0_#_value_#
    variable winnerswinner4_best_index_0_0_choice : boolean;
    variable winnerswinner4_best_index_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner4_best_index_0_0_choice_#
    variable winnerswinner4_best_index_0_0_value : boolean;
    variable winnerswinner4_best_index_0_0_values : boolean_1d(2 to 5);  -- winnerswinner4_best_index_0_0_value_#
    variable turn_order_address_any, turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_ready_tag_row_start_differs, turn_ready_tag_row_start_is_equal : boolean;
    variable turn_ready_tag_row_start_choice : boolean;
    variable turn_ready_tag_row_start_choices : boolean_1d(2 to 3);  -- turn_ready_tag_row_start_choice_#
    variable turn_ready_tag_row_start_is_equal_2, turn_ready_tag_row_start_all : boolean;
    variable turn_ready_tag_row_start_all_2, map_counter_group_is_equal, map_line_ended_choice : boolean;
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
    variable relief_newest_choice : boolean;
    variable relief_newest_choices : boolean_1d(2 to 16);  -- relief_newest_choice_#
    variable relief_newest_value : boolean;
    variable relief_newest_values : boolean_1d(2 to 5);  -- relief_newest_value_#
    variable transform_counter_group_after_choice, raster_place_group_after_choice : natural range 0 to 511;
    variable winners_best_cost_0_0_choice : natural range 0 to 511;
    variable map_counter_group_choices : natural_511_1d(2 to 3);  -- map_counter_group_choice_#
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 375;
    variable map_counter_group_choice : natural range 0 to 375;
    variable line_order_address_choice, turn_order_address_choice : natural range 1 to 2047;
    variable line_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 1239;
    variable costsshift_count_phase_choice, costswindow_read_count_phase_choice : natural range 0 to 7;
    variable costswindow_write_count_phase_choice, pathsleft_read_count_phase_choice : natural range 0 to 7;
    variable pathsleft_ahead_count_phase_choice : natural range 0 to 7;
    variable pathsleft_stay_change_value : natural_7_1d(1 to 8);  -- pathsleft_stay_change_#_value
    variable pathsleft_stay_change_values : natural_7_1d(11 to 14);  -- pathsleft_stay_change_#_value
    variable pathsleft_write_count_phase_choice, pathsabove_read_address_count_phase_choice : natural range 0 to 7;
    variable pathsabove_count_phase_choice, pathsabove_write_address_count_phase_choice : natural range 0 to 7;
    variable pathsabove_memory_write_words_0_0_choice, pathsabove_memory_write_words_0_5_choice : natural range 0 to 7;
    variable pathsturn_read_address_count_phase_choice : natural range 0 to 7;
    variable pathsturn_write_address_count_phase_choice, pathsright_stay_change_1_value : natural range 0 to 7;
    variable pathsright_stay_change_2_sum : natural range 0 to 7;
    variable pathsright_stay_change_value : natural_7_1d(3 to 4);  -- pathsright_stay_change_#_value
    variable pathsright_stay_change_5_sum, pathsright_stay_change_6_value : natural range 0 to 7;
    variable pathsright_stay_change_9_value, pathsright_stay_change_10_sum : natural range 0 to 7;
    variable pathsright_stay_change_values : natural_7_1d(11 to 12);  -- pathsright_stay_change_#_value
    variable pathsright_stay_change_13_sum, pathsright_stay_change_14_value : natural range 0 to 7;
    variable costsmask_column_sum, winnersmask_column_sum : natural range 1 to 2048;
    variable costsmask_column_choice, pathsabove_memory_read_address_2_choice : natural range 0 to 2047;
    variable winnersmask_column_choice : natural range 0 to 2047;
    variable costsmask_partner_choice, winnersmask_partner_choice : natural range 0 to 2048;
    variable paths_smallest_cost_choice : natural range 0 to 21;
    variable pathsleft_stay_choice_16 : natural_127_1d(0 to 15);  -- pathsleft_stay_#_choice_16
    variable pathsleft_stay_values_from_1 : natural_127_2d(1 to 2, 3 to 4);  -- pathsleft_stay_#_value_#
    variable pathsleft_stay_values_from_5 : natural_127_2d(5 to 6, 3 to 4);  -- pathsleft_stay_#_value_#
    variable pathsleft_stay_values_2 : natural_127_2d(9 to 10, 3 to 4);  -- pathsleft_stay_#_value_#
    variable pathsleft_stay_values_3 : natural_127_2d(13 to 14, 3 to 4);  -- pathsleft_stay_#_value_#
    variable pathsleft_step_choice : natural_127_1d(0 to 15);  -- pathsleft_step_#_choice
    variable pathsleft_step_0_choice_2, pathsleft_step_15_choice_2, pathsleft_low_0_choice : natural range 0 to 127;
    variable pathsright_stay_choice_16 : natural_127_1d(0 to 15);  -- pathsright_stay_#_choice_16
    variable pathsright_stay_values_from_1 : natural_127_2d(1 to 2, 3 to 4);  -- pathsright_stay_#_value_#
    variable pathsright_stay_values_from_5 : natural_127_2d(5 to 6, 3 to 4);  -- pathsright_stay_#_value_#
    variable pathsright_stay_values_2 : natural_127_2d(9 to 10, 3 to 4);  -- pathsright_stay_#_value_#
    variable pathsright_stay_values_3 : natural_127_2d(13 to 14, 3 to 4);  -- pathsright_stay_#_value_#
    variable pathsright_step_choice : natural_127_1d(0 to 15);  -- pathsright_step_#_choice
    variable pathsright_step_0_choice_2, pathsright_step_15_choice_2, pathsright_low_0_choice : natural range 0 to 127;
    variable pathsleft_q_choice, pathsleft_q_choice_2, pathsleft_room_left_choice : natural range 0 to 63;
    variable pathsabove_smallest_total_choice, pathsabove_beside_0_choice : natural range 0 to 63;
    variable pathsabove_beside_15_choice, pathsright_q_choice, pathsright_q_choice_2 : natural range 0 to 63;
    variable pathsright_room_left_choice, relief_newest_choice_17 : natural range 0 to 63;
    variable pathsabove_memory_read_address_0_sum : natural range 1 to 16384;
    variable pathsabove_memory_read_address_0_choice : natural range 0 to 4095;
    variable pathsabove_memory_read_address_0_sum_2 : natural range 0 to 16384;
    variable pathsturn_cost_memory_read_address_0_sum : natural range 0 to 16384;
    variable pathsabove_memory_bank_choice, pathsabove_memory_bank_choice_2 : natural range 0 to 16383;
    variable pathsabove_write_address_address_choice, pathsturn_cost_memory_bank_choice : natural range 0 to 16383;
    variable pathsabove_memory_ready_words_choice : natural_255_1d(0 to 9);  -- pathsabove_memory_ready_words_#_choice
    variable pathsabove_memory_write_words_0_sum : natural_255_1d(0 to 9);  -- pathsabove_memory_write_words_0_#_sum
    variable pathsturn_sum_memory_ready_words_choice : natural_255_1d(0 to 13);  -- pathsturn_sum_memory_ready_words_#_choice
    variable pathsturn_cost_memory_ready_words_choice : natural_255_1d(0 to 5);  -- pathsturn_cost_memory_ready_words_#_choice
    variable pathsturn_sum_memory_write_words_0_sum_2 : natural_255_1d(0 to 5);  -- pathsturn_sum_memory_write_words_0_#_sum_2
    variable pathsturn_sum_memory_write_words_0_6_sum : natural range 0 to 255;
    variable pathsturn_sum_memory_write_words_0_sum_2s : natural_255_1d(7 to 12);  -- pathsturn_sum_memory_write_words_0_#_sum_2
    variable pathsturn_sum_memory_write_words_0_13_sum : natural range 0 to 255;
    variable pathsturn_cost_memory_write_words_0_sum : natural_255_1d(0 to 5);  -- pathsturn_cost_memory_write_words_0_#_sum
    variable winnerswinner1_best_cost_0_any : natural_255_1d(0 to 7);  -- winnerswinner1_best_cost_0_#_any
    variable winnerswinner1_best_cost_0_any_2 : natural_255_1d(0 to 7);  -- winnerswinner1_best_cost_0_#_any_2
    variable winners_best_cost_0_0_choice_2, map_sorted_low_0_choice : natural range 0 to 255;
    variable map_sorted_low_0_choice_2, map_sorted_middle_0_choice : natural range 0 to 255;
    variable map_sorted_middle_0_choice_2, map_sorted_high_0_choice : natural range 0 to 255;
    variable map_sorted_high_0_choice_2, map_largest_low_0_choice, map_largest_low_0_choice_2 : natural range 0 to 255;
    variable map_median_middle_0_choice : natural range 0 to 255;
    variable map_median_middle_0_choices : natural_255_1d(2 to 4);  -- map_median_middle_0_choice_#
    variable map_smallest_high_0_choice, map_smallest_high_0_choice_2 : natural range 0 to 255;
    variable map_out_disparity_0_choice : natural range 0 to 255;
    variable map_out_disparity_0_choices : natural_255_1d(2 to 4);  -- map_out_disparity_0_choice_#
    variable map_low_0_0_choice, map_middle_0_0_choice, map_high_0_0_choice : natural range 0 to 255;
    variable relief_newest_values_from_6 : natural_255_1d(6 to 7);  -- relief_newest_value_#
    variable pathsabove_total_choice : natural_31_1d(0 to 15);  -- pathsabove_total_#_choice
    variable pathsabove_memory_write_words_0_choice_2 : natural_31_1d(0 to 1);  -- pathsabove_memory_write_words_0_#_choice_2
    variable pathsabove_memory_write_words_0_choice : natural_31_1d(1 to 4);  -- pathsabove_memory_write_words_0_#_choice
    variable pathsabove_memory_write_words_0_choice_2s : natural_31_1d(3 to 6);  -- pathsabove_memory_write_words_0_#_choice_2
    variable pathsabove_memory_write_words_0_choices : natural_31_1d(6 to 9);  -- pathsabove_memory_write_words_0_#_choice
    variable pathsabove_memory_write_words_0_choice_2s_from_8 : natural_31_1d(8 to 9);  -- pathsabove_memory_write_words_0_#_choice_2
    variable pathsabove_memory_write_words_0_2_choice_2 : natural range 0 to 15;
    variable pathsabove_memory_write_words_0_7_choice_2 : natural range 0 to 15;
    variable pathsabove_memory_write_words_0_3_choice_3 : natural range 0 to 3;
    variable pathsabove_memory_write_words_0_8_choice_3 : natural range 0 to 3;
    variable pathsturn_sum_memory_write_words_0_sum : natural_190_1d(0 to 5);  -- pathsturn_sum_memory_write_words_0_#_sum
    variable pathsturn_sum_memory_write_words_0_sums : natural_190_1d(7 to 12);  -- pathsturn_sum_memory_write_words_0_#_sum
    variable winnerswinner1_best_cost_0_sum : natural_255_to_256_1d(0 to 7);  -- winnerswinner1_best_cost_0_#_sum
    variable winnerswinner1_best_cost_0_sum_2 : natural_255_to_256_1d(0 to 7);  -- winnerswinner1_best_cost_0_#_sum_2
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_next_frame_is_equal := transform_counter_column = 1241;
      if transform_counter_last_column then
        transform_counter_frame_joins_choice := (not transform_counter_back_to_back) and winnerswinner1_best_below_0;
      else
        transform_counter_frame_joins_choice := winnerswinner1_best_below_0;
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
      transform_counter_next_frame <= transform_counter_next_frame_is_equal and (transform_counter_group = 374);
      transform_counter_last_column <= transform_counter_next_frame_is_equal;
      transform_counter_counts <= transform_counter_group /= 377;
      transform_counter_back_to_back <= (transform_counter_group = 376) and winnerswinner1_best_below_0;
      transform_counter_next_frame_after <= 378 < transform_counter_group;
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
      transform_reached_beyond_last(2) <= 374 < transform_counter_group;
      transform_reached_beyond_last(3) <= 376 < transform_counter_group;
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
        transform_counter_column_after <= (transform_counter_column + 1) mod 2048;
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
        transform_counter_group_choice := 375;
      else
        transform_counter_group_choice := 0;
      end if;
      if in_valid then
        if in_start_of_frame then
          transform_counter_column <= 0;
          transform_counter_group <= transform_counter_group_choice;
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
      raster_place_next_frame_is_equal := raster_place_column = 1241;
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
      raster_place_next_frame <= raster_place_next_frame_is_equal and (raster_place_group = 374);
      raster_place_last_column <= raster_place_next_frame_is_equal;
      raster_place_counts <= raster_place_group < 375;
      raster_place_frame_joins <= (raster_place_group = 375) and transform_read_row_inside_0;
      if delay_row_inside(2) then
        raster_place_back_to_back <= raster_place_back_to_back_choice;
      else
        raster_place_back_to_back <= transform_read_row_inside_0;
      end if;
      if raster_place_last_column then
        raster_place_column_after <= 0;
      else
        raster_place_column_after <= (raster_place_column + 1) mod 2048;
      end if;
      if (not delay_row_inside(2)) or (not raster_place_last_column) then
        raster_place_group_after <= raster_place_group;
      else
        raster_place_group_after <= raster_place_group_after_choice;
      end if;
      if raster_place_next_frame then
        raster_place_group_choice := 375;
      else
        raster_place_group_choice := 0;
      end if;
      if transform_filtering_valid(2) then
        if transform_filtering_start_of_frame(2) then
          raster_place_column <= 0;
          raster_place_group <= raster_place_group_choice;
        else
          raster_place_column <= raster_place_column_after;
          raster_place_group <= raster_place_group_after;
        end if;
      end if;
      -- delay
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 376;
      delay_tag_map_column_is_not_less := raster_place_column >= 1;
      delay_tag_map_column_is_less := raster_place_column < 1241;
      delay_tag_first_column_is_equal := raster_place_column = 1;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 375;
      delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside(2) <= raster_place_group /= 376;
      delay_tag_valid <= raster_features_valid;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less and
        delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 1240;
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
        line_order_address_choice := 2047;
      else
        line_order_address_choice := 1;
      end if;
      if line_order_falls then
        line_order_address_choice_2 := 0;
      else
        line_order_address_choice_2 := 1239;
      end if;
      if not ((not line_centre_map_column_0) or (not rows_tag_valid)) then
        if line_order_address_any then
          line_order_address <= (line_order_address_choice + line_order_address) mod 2048;
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
      for i in 2 to 35 loop
        line_comes(i) <= line_comes(i - 1);
      end loop;
      line_starts_phases(1) <= line_order_inside and line_order_turned_valid;
      for i in 2 to 35 loop
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
      if line_comes(24) then
        line_places_map_column(3) <= line_places_map_column(2);
        line_places_first_column(3) <= line_places_shown_first_column(2);
        line_places_shown_output_column(3) <= line_places_shown_output_column(2);
        line_places_shown_start_of_frame(3) <= line_places_shown_start_of_frame(2);
        line_places_shown_end_of_line(3) <= line_places_shown_end_of_line(2);
      end if;
      if line_comes(32) then
        line_places_map_column(4) <= line_places_map_column(3);
        line_places_shown_output_column(4) <= line_places_shown_output_column(3);
        line_places_shown_start_of_frame(4) <= line_places_shown_start_of_frame(3);
        line_places_shown_end_of_line(4) <= line_places_shown_end_of_line(3);
      end if;
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
      costsshift_handed_on(0) <= to_integer(costsshift_read_words(7)(27 downto 14));
      costsshift_handed_on(1) <= to_integer(costsshift_read_words(15)(27 downto 14));
      costsshift_handed_on(2) <= to_integer(costsshift_read_words(23)(27 downto 14));
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
          for j in 0 to 6 loop
            costsshift_search(i, 2 * j + 1) <= to_integer(costsshift_read_words(8 * i + j)(13 downto 0));
            costsshift_search(i, 2 * j + 2) <= to_integer(costsshift_read_words(8 * i + j)(27 downto 14));
          end loop;
          costsshift_search(i, 15) <= to_integer(costsshift_read_words(8 * i + 7)(13 downto 0));
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
        for j in 1 to 15 loop
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
        for j in 0 to 15 loop
          costscolumn_pixels_cost(i, j) <= costscolumn_pixels_first_count(i, j, 3) + costscolumn_pixels_first_count(i,
            j, 0) + costscolumn_pixels_first_count(i, j, 1) + costscolumn_pixels_first_count_4(i, j) +
            costscolumn_pixels_first_count(i, j, 2);
        end loop;
      end loop;
      for i in 0 to 15 loop
        costscolumn_pair_0(i) <= costscolumn_pixels_cost(1, i) + costscolumn_pixels_cost(2, i);
      end loop;
      for i in 0 to 15 loop
        costscolumn_single_0(i) <= costscolumn_pixels_cost(0, i);
      end loop;
      for i in 0 to 15 loop
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
      for i in 0 to 1 loop
        for j in 0 to 3 loop
          costswindow_sum_0(8 * i + j) <= costscolumn_column_0(8 * i + j) + to_integer(costswindow_read_wordss(2 * i +
            4)(7 * j + 6 downto 7 * j));
        end loop;
        for j in 4 to 7 loop
          costswindow_sum_0(8 * i + j) <= costscolumn_column_0(8 * i + j) + to_integer(costswindow_read_wordss(2 * i +
            5)(7 * j - 22 downto 7 * j - 28));
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
        for i in 0 to 15 loop
          costswindow_partial(i) <= costscolumn_column_0(i);
        end loop;
        for i in 0 to 1 loop
          for j in 16 to 19 loop
            costswindow_partials(8 * i + j) <= costscolumn_column_0(8 * i + j - 16) +
              to_integer(costswindow_read_words(2 * i)(7 * j - 107 downto 7 * j - 112));
          end loop;
          for j in 20 to 23 loop
            costswindow_partials(8 * i + j) <= costscolumn_column_0(8 * i + j - 16) +
              to_integer(costswindow_read_words(2 * i + 1)(7 * j - 135 downto 7 * j - 140));
          end loop;
        end loop;
      end if;
      -- costsmask
      costsmask_column_sum := costsmask_column + 1;
      if line_places_shown_first_column(0) then
        costsmask_column_choice := 0;
      else
        costsmask_column_choice := costsmask_column_sum mod 2048;
      end if;
      if line_comes(5) then
        costsmask_column <= costsmask_column_choice;
      end if;
      if line_places_shown_first_column(0) then
        costsmask_partner_choice := 0;
      else
        costsmask_partner_choice := costsmask_column_sum;
      end if;
      costsmask_inside(0) <= (((((costsmask_partner / 2048) + 31) mod 32) * 2048) + (costsmask_partner mod 2048)) <
        1240;
      costsmask_inside(1) <= (costsmask_partner >= 2049) and (costsmask_partner < 3289);
      costsmask_inside(2) <= (((((costsmask_partner / 2) + 31743) mod 32768) * 2) + (costsmask_partner mod 2)) < 1240;
      costsmask_inside(3) <= (costsmask_partner >= 2051) and (costsmask_partner < 3291);
      costsmask_inside(4) <= (((((costsmask_partner / 4) + 15871) mod 16384) * 4) + (costsmask_partner mod 4)) < 1240;
      costsmask_inside(5) <= (costsmask_partner >= 2053) and (costsmask_partner < 3293);
      costsmask_inside(6) <= (((((costsmask_partner / 2) + 31741) mod 32768) * 2) + (costsmask_partner mod 2)) < 1240;
      costsmask_inside(7) <= (costsmask_partner >= 2055) and (costsmask_partner < 3295);
      costsmask_inside(8) <= (((((costsmask_partner / 8) + 7935) mod 8192) * 8) + (costsmask_partner mod 8)) < 1240;
      costsmask_inside(9) <= (costsmask_partner >= 2057) and (costsmask_partner < 3297);
      costsmask_inside(10) <= (((((costsmask_partner / 2) + 31739) mod 32768) * 2) + (costsmask_partner mod 2)) < 1240;
      costsmask_inside(11) <= (costsmask_partner >= 2059) and (costsmask_partner < 3299);
      costsmask_inside(12) <= (((((costsmask_partner / 4) + 15869) mod 16384) * 4) + (costsmask_partner mod 4)) < 1240;
      costsmask_inside(13) <= (costsmask_partner >= 2061) and (costsmask_partner < 3301);
      costsmask_inside(14) <= (((((costsmask_partner / 2) + 31737) mod 32768) * 2) + (costsmask_partner mod 2)) < 1240;
      costsmask_inside(15) <= (costsmask_partner >= 2063) and (costsmask_partner < 3303);
      if line_comes(5) then
        costsmask_partner <= (((costsmask_partner_choice / 2048) + 1) * 2048) + costsmask_column_choice;
      else
        costsmask_partner <= ((((costsmask_partner / 16) + 511) mod 512) * 16) + (costsmask_partner mod 16);
      end if;
      -- costs
      for i in 0 to 15 loop
        if (not (((not is_set(costswindow_sum_0(i), 5)) or (not is_set(costswindow_sum_0(i), 4))) and
          ((costswindow_sum_0(i) / 64) = 0))) or (not costsmask_inside(i)) then
          costs_cost(i) <= 5;
        else
          costs_cost(i) <= costswindow_sum_0(i) / 8;
        end if;
      end loop;
      -- paths
      if line_comes(12) then
        paths_smallest_cost_choice := 7;
      else
        paths_smallest_cost_choice := paths_smallest_cost;
      end if;
      paths_cost_delay_ring_write_address <= paths_cost_delay_ring_read_address;
      for i in 0 to 1 loop
        paths_sum(8 * i) <= (pathsturn_sum_memory_ready_words(7 * i) mod 128) + pathsright_cost(8 * i);
        paths_sum(8 * i + 1) <= ((pathsturn_sum_memory_ready_words(7 * i + 1) mod 64) * 2) +
          (pathsturn_sum_memory_ready_words(7 * i) / 128) + pathsright_cost(8 * i + 1);
        paths_sum(8 * i + 2) <= ((pathsturn_sum_memory_ready_words(7 * i + 2) mod 32) * 4) +
          (pathsturn_sum_memory_ready_words(7 * i + 1) / 64) + pathsright_cost(8 * i + 2);
        paths_sum(8 * i + 3) <= ((pathsturn_sum_memory_ready_words(7 * i + 3) mod 16) * 8) +
          (pathsturn_sum_memory_ready_words(7 * i + 2) / 32) + pathsright_cost(8 * i + 3);
        paths_sum(8 * i + 4) <= ((pathsturn_sum_memory_ready_words(7 * i + 4) mod 8) * 16) +
          (pathsturn_sum_memory_ready_words(7 * i + 3) / 16) + pathsright_cost(8 * i + 4);
        paths_sum(8 * i + 5) <= ((pathsturn_sum_memory_ready_words(7 * i + 5) mod 4) * 32) +
          (pathsturn_sum_memory_ready_words(7 * i + 4) / 8) + pathsright_cost(8 * i + 5);
        paths_sum(8 * i + 6) <= ((pathsturn_sum_memory_ready_words(7 * i + 6) mod 2) * 64) +
          (pathsturn_sum_memory_ready_words(7 * i + 5) / 4) + pathsright_cost(8 * i + 6);
        paths_sum(8 * i + 7) <= (pathsturn_sum_memory_ready_words(7 * i + 6) / 2) + pathsright_cost(8 * i + 7);
      end loop;
      for i in 0 to 7 loop
        if (costs_cost(2 * i + 1) - costs_cost(2 * i)) < 0 then
          paths_tree_smallest(i) <= costs_cost(2 * i + 1);
        else
          paths_tree_smallest(i) <= costs_cost(2 * i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (paths_tree_smallest(2 * i + 1) - paths_tree_smallest(2 * i)) < 0 then
          paths_tree_next_smallest(i) <= paths_tree_smallest(2 * i + 1);
        else
          paths_tree_next_smallest(i) <= paths_tree_smallest(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (paths_tree_next_smallest(2 * i + 1) - paths_tree_next_smallest(2 * i)) < 0 then
          paths_tree_next_next_smallest(i) <= paths_tree_next_smallest(2 * i + 1);
        else
          paths_tree_next_next_smallest(i) <= paths_tree_next_smallest(2 * i);
        end if;
      end loop;
      if (paths_tree_next_next_smallest(1) - paths_tree_next_next_smallest(0)) < 0 then
        paths_tree_next_next_next_smallest_0 <= paths_tree_next_next_smallest(1);
      else
        paths_tree_next_next_next_smallest_0 <= paths_tree_next_next_smallest(0);
      end if;
      if (paths_tree_next_next_next_smallest_0 - paths_smallest_cost_choice) < 0 then
        paths_smallest_cost <= paths_tree_next_next_next_smallest_0;
      else
        paths_smallest_cost <= paths_smallest_cost_choice;
      end if;
      if paths_cost_delay_ring_read_address = 12 then
        paths_cost_delay_ring_read_address <= 0;
      else
        paths_cost_delay_ring_read_address <= (paths_cost_delay_ring_read_address + 1) mod 16;
      end if;
      -- pathsleft
      if line_starts_phases(11) then
        pathsleft_fresh_past_newest(0) <= relief_left(1);
        pathsleft_fresh_past_newest(1) <= pathsleft_fresh_past_newest(0);
      end if;
      if line_starts_phases(12) then
        pathsleft_fresh_past_pairs(1) <= pathsleft_fresh_past_pairs(0);
        pathsleft_fresh_past_pairs(2) <= pathsleft_fresh_past_pairs(1);
        if (pathsleft_fresh_past_newest(1) - pathsleft_fresh_past_newest(0)) < 0 then
          pathsleft_fresh_past_pairs(0) <= pathsleft_fresh_past_newest(1);
        else
          pathsleft_fresh_past_pairs(0) <= pathsleft_fresh_past_newest(0);
        end if;
      end if;
      if line_starts_phases(13) then
        for i in 1 to 7 loop
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
      if pathsleft_read_words(4)(0) = '1' then
        pathsleft_stay_choice(0) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(0) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(4)(1) = '1' then
        pathsleft_stay_choices(0, 2) := (pathsleft_read_words(4)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(0, 2) := pathsleft_stay_choice(0);
      end if;
      pathsleft_stay_value_2(0) := is_set(pathsleft_fresh_here, 2);
      if pathsleft_stay_choices(0, 2) then
        pathsleft_stay_choices(0, 3) := (not (pathsleft_read_words(4)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(0, 3) := (not (pathsleft_read_words(4)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        pathsleft_stay_0_values(i) := is_set(pathsleft_fresh_here, i);
        if pathsleft_stay_choices(0, i) then
          pathsleft_stay_choices(0, i + 1) := (not (pathsleft_read_words(4)(i) = '1')) or pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(0, i + 1) := (not (pathsleft_read_words(4)(i) = '1')) and pathsleft_stay_0_values(i);
        end if;
      end loop;
      pathsleft_stay_0_values_from_5(5) := is_set(pathsleft_fresh_here, 5);
      if pathsleft_stay_choices(0, 5) then
        pathsleft_stay_choices(0, 6) := (not (pathsleft_read_words(4)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(0, 6) := (not (pathsleft_read_words(4)(5) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(0, 6) then
        pathsleft_stay_choices(0, 7) := (not (pathsleft_read_words(4)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(0, 7) := (not (pathsleft_read_words(4)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
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
      if (to_integer(pathsleft_read_words(4)(6 downto 0)) - to_integer(pathsleft_read_words(0)(6 downto 0))) < 0 then
        pathsleft_stay_choice_16(0) := to_integer(pathsleft_read_words(4)(6 downto 0));
      else
        pathsleft_stay_choice_16(0) := to_integer(pathsleft_read_words(0)(6 downto 0));
      end if;
      for i in 1 to 2 loop
        pathsleft_stay_value(i) := pathsleft_read_words(4)(7 * i) = '1';
        if pathsleft_stay_value(i) then
          pathsleft_stay_choice(i) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choice(i) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(4)(7 * i + 1) = '1' then
          pathsleft_stay_choices(i, 2) := pathsleft_stay_value(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 2) := pathsleft_stay_choice(i);
        end if;
        if pathsleft_stay_choices(i, 2) then
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(4)(7 * i + 2) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(4)(7 * i + 2) = '1')) or pathsleft_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(4)(7 * i + j) = '1')) or
              pathsleft_stay_0_values(j);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(4)(7 * i + j) = '1')) and
              pathsleft_stay_0_values(j);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 5) then
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(4)(7 * i + 5) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(4)(7 * i + 5) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 6) then
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(4)(7 * i + 6) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(4)(7 * i + 6) = '1')) and
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
        pathsleft_stay_values_from_1(i, 3) := to_integer(pathsleft_read_words(4)(7 * i + 6 downto 7 * i));
        pathsleft_stay_values_from_1(i, 4) := to_integer(pathsleft_read_words(0)(7 * i + 6 downto 7 * i));
        if (pathsleft_stay_values_from_1(i, 3) - pathsleft_stay_values_from_1(i, 4)) < 0 then
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_from_1(i, 3);
        else
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_from_1(i, 4);
        end if;
      end loop;
      pathsleft_stay_value(3) := pathsleft_read_words(4)(21) = '1';
      if pathsleft_stay_value(3) then
        pathsleft_stay_choice(3) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(3) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(4)(22) = '1' then
        pathsleft_stay_choices(3, 2) := pathsleft_stay_value(3) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(3, 2) := pathsleft_stay_choice(3);
      end if;
      if pathsleft_stay_choices(3, 2) then
        pathsleft_stay_choices(3, 3) := (not (pathsleft_read_words(4)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(3, 3) := (not (pathsleft_read_words(4)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(3, i) then
          pathsleft_stay_choices(3, i + 1) := (not (pathsleft_read_words(4)(i + 21) = '1')) or
            pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(3, i + 1) := (not (pathsleft_read_words(4)(i + 21) = '1')) and
            pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(3, 5) then
        pathsleft_stay_choices(3, 6) := (not (pathsleft_read_words(4)(26) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(3, 6) := (not (pathsleft_read_words(4)(26) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(3, 6) then
        pathsleft_stay_choices(3, 7) := (not (pathsleft_read_words(4)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(3, 7) := (not (pathsleft_read_words(4)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
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
      if (to_integer(pathsleft_read_words(4)(27 downto 21)) - to_integer(pathsleft_read_words(0)(27 downto 21))) < 0
        then
        pathsleft_stay_choice_16(3) := to_integer(pathsleft_read_words(4)(27 downto 21));
      else
        pathsleft_stay_choice_16(3) := to_integer(pathsleft_read_words(0)(27 downto 21));
      end if;
      if pathsleft_read_words(5)(0) = '1' then
        pathsleft_stay_choice(4) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(4) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(5)(1) = '1' then
        pathsleft_stay_choices(4, 2) := (pathsleft_read_words(5)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(4, 2) := pathsleft_stay_choice(4);
      end if;
      if pathsleft_stay_choices(4, 2) then
        pathsleft_stay_choices(4, 3) := (not (pathsleft_read_words(5)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(4, 3) := (not (pathsleft_read_words(5)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(4, i) then
          pathsleft_stay_choices(4, i + 1) := (not (pathsleft_read_words(5)(i) = '1')) or pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(4, i + 1) := (not (pathsleft_read_words(5)(i) = '1')) and pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(4, 5) then
        pathsleft_stay_choices(4, 6) := (not (pathsleft_read_words(5)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(4, 6) := (not (pathsleft_read_words(5)(5) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(4, 6) then
        pathsleft_stay_choices(4, 7) := (not (pathsleft_read_words(5)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(4, 7) := (not (pathsleft_read_words(5)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
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
      if (to_integer(pathsleft_read_words(5)(6 downto 0)) - to_integer(pathsleft_read_words(1)(6 downto 0))) < 0 then
        pathsleft_stay_choice_16(4) := to_integer(pathsleft_read_words(5)(6 downto 0));
      else
        pathsleft_stay_choice_16(4) := to_integer(pathsleft_read_words(1)(6 downto 0));
      end if;
      for i in 5 to 6 loop
        pathsleft_stay_values(i) := pathsleft_read_words(5)(7 * i - 28) = '1';
        if pathsleft_stay_values(i) then
          pathsleft_stay_choice(i) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choice(i) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(5)(7 * i - 27) = '1' then
          pathsleft_stay_choices(i, 2) := pathsleft_stay_values(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 2) := pathsleft_stay_choice(i);
        end if;
        if pathsleft_stay_choices(i, 2) then
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(5)(7 * i - 26) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(5)(7 * i - 26) = '1')) or
            pathsleft_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(5)(7 * i + j - 28) = '1')) or
              pathsleft_stay_0_values(j);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(5)(7 * i + j - 28) = '1')) and
              pathsleft_stay_0_values(j);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 5) then
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(5)(7 * i - 23) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(5)(7 * i - 23) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 6) then
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(5)(7 * i - 22) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(5)(7 * i - 22) = '1')) and
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
        pathsleft_stay_values_from_5(i, 3) := to_integer(pathsleft_read_words(5)(7 * i - 22 downto 7 * i - 28));
        pathsleft_stay_values_from_5(i, 4) := to_integer(pathsleft_read_words(1)(7 * i - 22 downto 7 * i - 28));
        if (pathsleft_stay_values_from_5(i, 3) - pathsleft_stay_values_from_5(i, 4)) < 0 then
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_from_5(i, 3);
        else
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_from_5(i, 4);
        end if;
      end loop;
      pathsleft_stay_values(7) := pathsleft_read_words(5)(21) = '1';
      if pathsleft_stay_values(7) then
        pathsleft_stay_choice(7) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(7) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(5)(22) = '1' then
        pathsleft_stay_choices(7, 2) := pathsleft_stay_values(7) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(7, 2) := pathsleft_stay_choice(7);
      end if;
      if pathsleft_stay_choices(7, 2) then
        pathsleft_stay_choices(7, 3) := (not (pathsleft_read_words(5)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(7, 3) := (not (pathsleft_read_words(5)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(7, i) then
          pathsleft_stay_choices(7, i + 1) := (not (pathsleft_read_words(5)(i + 21) = '1')) or
            pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(7, i + 1) := (not (pathsleft_read_words(5)(i + 21) = '1')) and
            pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(7, 5) then
        pathsleft_stay_choices(7, 6) := (not (pathsleft_read_words(5)(26) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(7, 6) := (not (pathsleft_read_words(5)(26) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(7, 6) then
        pathsleft_stay_choices(7, 7) := (not (pathsleft_read_words(5)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(7, 7) := (not (pathsleft_read_words(5)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
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
      if (to_integer(pathsleft_read_words(5)(27 downto 21)) - to_integer(pathsleft_read_words(1)(27 downto 21))) < 0
        then
        pathsleft_stay_choice_16(7) := to_integer(pathsleft_read_words(5)(27 downto 21));
      else
        pathsleft_stay_choice_16(7) := to_integer(pathsleft_read_words(1)(27 downto 21));
      end if;
      if pathsleft_read_words(6)(0) = '1' then
        pathsleft_stay_choice(8) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(6)(1) = '1' then
        pathsleft_stay_choices(8, 2) := (pathsleft_read_words(6)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(8, 2) := pathsleft_stay_choice(8);
      end if;
      if pathsleft_stay_choices(8, 2) then
        pathsleft_stay_choices(8, 3) := (not (pathsleft_read_words(6)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(8, 3) := (not (pathsleft_read_words(6)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(8, i) then
          pathsleft_stay_choices(8, i + 1) := (not (pathsleft_read_words(6)(i) = '1')) or pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(8, i + 1) := (not (pathsleft_read_words(6)(i) = '1')) and pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(8, 5) then
        pathsleft_stay_choices(8, 6) := (not (pathsleft_read_words(6)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(8, 6) := (not (pathsleft_read_words(6)(5) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(8, 6) then
        pathsleft_stay_choices(8, 7) := (not (pathsleft_read_words(6)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(8, 7) := (not (pathsleft_read_words(6)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_read_words(2)(0) = '1' then
        pathsleft_stay_choices(8, 8) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choices(8, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(2)(1) = '1' then
        pathsleft_stay_choices(8, 9) := (pathsleft_read_words(2)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(8, 9) := pathsleft_stay_choices(8, 8);
      end if;
      if pathsleft_stay_choices(8, 9) then
        pathsleft_stay_choices(8, 10) := (not (pathsleft_read_words(2)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(8, 10) := (not (pathsleft_read_words(2)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsleft_stay_choices(8, i) then
          pathsleft_stay_choices(8, i + 1) := (not (pathsleft_read_words(2)(i - 7) = '1')) or pathsleft_stay_0_values(i
            - 7);
        else
          pathsleft_stay_choices(8, i + 1) := (not (pathsleft_read_words(2)(i - 7) = '1')) and
            pathsleft_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsleft_stay_choices(8, 12) then
        pathsleft_stay_choices(8, 13) := (not (pathsleft_read_words(2)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(8, 13) := (not (pathsleft_read_words(2)(5) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(8, 13) then
        pathsleft_stay_choices(8, 14) := (not (pathsleft_read_words(2)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(8, 14) := (not (pathsleft_read_words(2)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(8, 7) then
        pathsleft_stay_choices(8, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(8, 15) := pathsleft_stay_choices(8, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words(6)(6 downto 0)) - to_integer(pathsleft_read_words(2)(6 downto 0))) < 0 then
        pathsleft_stay_choice_16(8) := to_integer(pathsleft_read_words(6)(6 downto 0));
      else
        pathsleft_stay_choice_16(8) := to_integer(pathsleft_read_words(2)(6 downto 0));
      end if;
      for i in 9 to 10 loop
        pathsleft_stay_values_from_9(i) := pathsleft_read_words(6)(7 * i - 56) = '1';
        if pathsleft_stay_values_from_9(i) then
          pathsleft_stay_choice(i) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choice(i) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(6)(7 * i - 55) = '1' then
          pathsleft_stay_choices(i, 2) := pathsleft_stay_values_from_9(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 2) := pathsleft_stay_choice(i);
        end if;
        if pathsleft_stay_choices(i, 2) then
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(6)(7 * i - 54) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(6)(7 * i - 54) = '1')) or
            pathsleft_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(6)(7 * i + j - 56) = '1')) or
              pathsleft_stay_0_values(j);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(6)(7 * i + j - 56) = '1')) and
              pathsleft_stay_0_values(j);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 5) then
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(6)(7 * i - 51) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(6)(7 * i - 51) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 6) then
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(6)(7 * i - 50) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(6)(7 * i - 50) = '1')) and
            is_set(pathsleft_fresh_here, 6);
        end if;
        pathsleft_stay_value_2s_from_9(i) := pathsleft_read_words(2)(7 * i - 56) = '1';
        if pathsleft_stay_value_2s_from_9(i) then
          pathsleft_stay_choices(i, 8) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choices(i, 8) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(2)(7 * i - 55) = '1' then
          pathsleft_stay_choices(i, 9) := pathsleft_stay_value_2s_from_9(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 9) := pathsleft_stay_choices(i, 8);
        end if;
        if pathsleft_stay_choices(i, 9) then
          pathsleft_stay_choices(i, 10) := (not (pathsleft_read_words(2)(7 * i - 54) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 10) := (not (pathsleft_read_words(2)(7 * i - 54) = '1')) or
            pathsleft_stay_value_2(0);
        end if;
        for j in 10 to 11 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(2)(7 * i + j - 63) = '1')) or
              pathsleft_stay_0_values(j - 7);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(2)(7 * i + j - 63) = '1')) and
              pathsleft_stay_0_values(j - 7);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 12) then
          pathsleft_stay_choices(i, 13) := (not (pathsleft_read_words(2)(7 * i - 51) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 13) := (not (pathsleft_read_words(2)(7 * i - 51) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 13) then
          pathsleft_stay_choices(i, 14) := (not (pathsleft_read_words(2)(7 * i - 50) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 14) := (not (pathsleft_read_words(2)(7 * i - 50) = '1')) and
            is_set(pathsleft_fresh_here, 6);
        end if;
        if pathsleft_stay_choices(i, 7) then
          pathsleft_stay_choices(i, 15) := not pathsleft_first;
        else
          pathsleft_stay_choices(i, 15) := pathsleft_stay_choices(i, 14) and (not pathsleft_first);
        end if;
        pathsleft_stay_values_2(i, 3) := to_integer(pathsleft_read_words(6)(7 * i - 50 downto 7 * i - 56));
        pathsleft_stay_values_2(i, 4) := to_integer(pathsleft_read_words(2)(7 * i - 50 downto 7 * i - 56));
        if (pathsleft_stay_values_2(i, 3) - pathsleft_stay_values_2(i, 4)) < 0 then
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_2(i, 3);
        else
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_2(i, 4);
        end if;
      end loop;
      pathsleft_stay_values_from_9(11) := pathsleft_read_words(6)(21) = '1';
      if pathsleft_stay_values_from_9(11) then
        pathsleft_stay_choice(11) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(11) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(6)(22) = '1' then
        pathsleft_stay_choices(11, 2) := pathsleft_stay_values_from_9(11) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(11, 2) := pathsleft_stay_choice(11);
      end if;
      if pathsleft_stay_choices(11, 2) then
        pathsleft_stay_choices(11, 3) := (not (pathsleft_read_words(6)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(11, 3) := (not (pathsleft_read_words(6)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(11, i) then
          pathsleft_stay_choices(11, i + 1) := (not (pathsleft_read_words(6)(i + 21) = '1')) or
            pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(11, i + 1) := (not (pathsleft_read_words(6)(i + 21) = '1')) and
            pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(11, 5) then
        pathsleft_stay_choices(11, 6) := (not (pathsleft_read_words(6)(26) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(11, 6) := (not (pathsleft_read_words(6)(26) = '1')) and
          pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(11, 6) then
        pathsleft_stay_choices(11, 7) := (not (pathsleft_read_words(6)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(11, 7) := (not (pathsleft_read_words(6)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      pathsleft_stay_value_2s_from_9(11) := pathsleft_read_words(2)(21) = '1';
      if pathsleft_stay_value_2s_from_9(11) then
        pathsleft_stay_choices(11, 8) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choices(11, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(2)(22) = '1' then
        pathsleft_stay_choices(11, 9) := pathsleft_stay_value_2s_from_9(11) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(11, 9) := pathsleft_stay_choices(11, 8);
      end if;
      if pathsleft_stay_choices(11, 9) then
        pathsleft_stay_choices(11, 10) := (not (pathsleft_read_words(2)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(11, 10) := (not (pathsleft_read_words(2)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsleft_stay_choices(11, i) then
          pathsleft_stay_choices(11, i + 1) := (not (pathsleft_read_words(2)(i + 14) = '1')) or
            pathsleft_stay_0_values(i - 7);
        else
          pathsleft_stay_choices(11, i + 1) := (not (pathsleft_read_words(2)(i + 14) = '1')) and
            pathsleft_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsleft_stay_choices(11, 12) then
        pathsleft_stay_choices(11, 13) := (not (pathsleft_read_words(2)(26) = '1')) or
          pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(11, 13) := (not (pathsleft_read_words(2)(26) = '1')) and
          pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(11, 13) then
        pathsleft_stay_choices(11, 14) := (not (pathsleft_read_words(2)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(11, 14) := (not (pathsleft_read_words(2)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(11, 7) then
        pathsleft_stay_choices(11, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(11, 15) := pathsleft_stay_choices(11, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words(6)(27 downto 21)) - to_integer(pathsleft_read_words(2)(27 downto 21))) < 0
        then
        pathsleft_stay_choice_16(11) := to_integer(pathsleft_read_words(6)(27 downto 21));
      else
        pathsleft_stay_choice_16(11) := to_integer(pathsleft_read_words(2)(27 downto 21));
      end if;
      if pathsleft_read_words(7)(0) = '1' then
        pathsleft_stay_choice(12) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(12) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(7)(1) = '1' then
        pathsleft_stay_choices(12, 2) := (pathsleft_read_words(7)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(12, 2) := pathsleft_stay_choice(12);
      end if;
      if pathsleft_stay_choices(12, 2) then
        pathsleft_stay_choices(12, 3) := (not (pathsleft_read_words(7)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(12, 3) := (not (pathsleft_read_words(7)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(12, i) then
          pathsleft_stay_choices(12, i + 1) := (not (pathsleft_read_words(7)(i) = '1')) or pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(12, i + 1) := (not (pathsleft_read_words(7)(i) = '1')) and pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(12, 5) then
        pathsleft_stay_choices(12, 6) := (not (pathsleft_read_words(7)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(12, 6) := (not (pathsleft_read_words(7)(5) = '1')) and pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(12, 6) then
        pathsleft_stay_choices(12, 7) := (not (pathsleft_read_words(7)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(12, 7) := (not (pathsleft_read_words(7)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_read_words(3)(0) = '1' then
        pathsleft_stay_choices(12, 8) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choices(12, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(3)(1) = '1' then
        pathsleft_stay_choices(12, 9) := (pathsleft_read_words(3)(0) = '1') or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(12, 9) := pathsleft_stay_choices(12, 8);
      end if;
      if pathsleft_stay_choices(12, 9) then
        pathsleft_stay_choices(12, 10) := (not (pathsleft_read_words(3)(2) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(12, 10) := (not (pathsleft_read_words(3)(2) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsleft_stay_choices(12, i) then
          pathsleft_stay_choices(12, i + 1) := (not (pathsleft_read_words(3)(i - 7) = '1')) or
            pathsleft_stay_0_values(i - 7);
        else
          pathsleft_stay_choices(12, i + 1) := (not (pathsleft_read_words(3)(i - 7) = '1')) and
            pathsleft_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsleft_stay_choices(12, 12) then
        pathsleft_stay_choices(12, 13) := (not (pathsleft_read_words(3)(5) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(12, 13) := (not (pathsleft_read_words(3)(5) = '1')) and
          pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(12, 13) then
        pathsleft_stay_choices(12, 14) := (not (pathsleft_read_words(3)(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(12, 14) := (not (pathsleft_read_words(3)(6) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(12, 7) then
        pathsleft_stay_choices(12, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(12, 15) := pathsleft_stay_choices(12, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words(7)(6 downto 0)) - to_integer(pathsleft_read_words(3)(6 downto 0))) < 0 then
        pathsleft_stay_choice_16(12) := to_integer(pathsleft_read_words(7)(6 downto 0));
      else
        pathsleft_stay_choice_16(12) := to_integer(pathsleft_read_words(3)(6 downto 0));
      end if;
      for i in 13 to 14 loop
        pathsleft_stay_values_from_13(i) := pathsleft_read_words(7)(7 * i - 84) = '1';
        if pathsleft_stay_values_from_13(i) then
          pathsleft_stay_choice(i) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choice(i) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(7)(7 * i - 83) = '1' then
          pathsleft_stay_choices(i, 2) := pathsleft_stay_values_from_13(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 2) := pathsleft_stay_choice(i);
        end if;
        if pathsleft_stay_choices(i, 2) then
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(7)(7 * i - 82) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 3) := (not (pathsleft_read_words(7)(7 * i - 82) = '1')) or
            pathsleft_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(7)(7 * i + j - 84) = '1')) or
              pathsleft_stay_0_values(j);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(7)(7 * i + j - 84) = '1')) and
              pathsleft_stay_0_values(j);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 5) then
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(7)(7 * i - 79) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 6) := (not (pathsleft_read_words(7)(7 * i - 79) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 6) then
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(7)(7 * i - 78) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 7) := (not (pathsleft_read_words(7)(7 * i - 78) = '1')) and
            is_set(pathsleft_fresh_here, 6);
        end if;
        pathsleft_stay_value_2s_from_13(i) := pathsleft_read_words(3)(7 * i - 84) = '1';
        if pathsleft_stay_value_2s_from_13(i) then
          pathsleft_stay_choices(i, 8) := not pathsleft_stay_value(0);
        else
          pathsleft_stay_choices(i, 8) := pathsleft_stay_0_is_equal;
        end if;
        if pathsleft_read_words(3)(7 * i - 83) = '1' then
          pathsleft_stay_choices(i, 9) := pathsleft_stay_value_2s_from_13(i) or (not pathsleft_stay_value(0)) or (not
            is_set(pathsleft_fresh_here, 0));
        else
          pathsleft_stay_choices(i, 9) := pathsleft_stay_choices(i, 8);
        end if;
        if pathsleft_stay_choices(i, 9) then
          pathsleft_stay_choices(i, 10) := (not (pathsleft_read_words(3)(7 * i - 82) = '1')) and
            pathsleft_stay_value_2(0);
        else
          pathsleft_stay_choices(i, 10) := (not (pathsleft_read_words(3)(7 * i - 82) = '1')) or
            pathsleft_stay_value_2(0);
        end if;
        for j in 10 to 11 loop
          if pathsleft_stay_choices(i, j) then
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(3)(7 * i + j - 91) = '1')) or
              pathsleft_stay_0_values(j - 7);
          else
            pathsleft_stay_choices(i, j + 1) := (not (pathsleft_read_words(3)(7 * i + j - 91) = '1')) and
              pathsleft_stay_0_values(j - 7);
          end if;
        end loop;
        if pathsleft_stay_choices(i, 12) then
          pathsleft_stay_choices(i, 13) := (not (pathsleft_read_words(3)(7 * i - 79) = '1')) or
            pathsleft_stay_0_values_from_5(5);
        else
          pathsleft_stay_choices(i, 13) := (not (pathsleft_read_words(3)(7 * i - 79) = '1')) and
            pathsleft_stay_0_values_from_5(5);
        end if;
        if pathsleft_stay_choices(i, 13) then
          pathsleft_stay_choices(i, 14) := (not (pathsleft_read_words(3)(7 * i - 78) = '1')) or
            is_set(pathsleft_fresh_here, 6);
        else
          pathsleft_stay_choices(i, 14) := (not (pathsleft_read_words(3)(7 * i - 78) = '1')) and
            is_set(pathsleft_fresh_here, 6);
        end if;
        if pathsleft_stay_choices(i, 7) then
          pathsleft_stay_choices(i, 15) := not pathsleft_first;
        else
          pathsleft_stay_choices(i, 15) := pathsleft_stay_choices(i, 14) and (not pathsleft_first);
        end if;
        pathsleft_stay_values_3(i, 3) := to_integer(pathsleft_read_words(7)(7 * i - 78 downto 7 * i - 84));
        pathsleft_stay_values_3(i, 4) := to_integer(pathsleft_read_words(3)(7 * i - 78 downto 7 * i - 84));
        if (pathsleft_stay_values_3(i, 3) - pathsleft_stay_values_3(i, 4)) < 0 then
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_3(i, 3);
        else
          pathsleft_stay_choice_16(i) := pathsleft_stay_values_3(i, 4);
        end if;
      end loop;
      pathsleft_stay_values_from_13(15) := pathsleft_read_words(7)(21) = '1';
      if pathsleft_stay_values_from_13(15) then
        pathsleft_stay_choice(15) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choice(15) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(7)(22) = '1' then
        pathsleft_stay_choices(15, 2) := pathsleft_stay_values_from_13(15) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(15, 2) := pathsleft_stay_choice(15);
      end if;
      if pathsleft_stay_choices(15, 2) then
        pathsleft_stay_choices(15, 3) := (not (pathsleft_read_words(7)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(15, 3) := (not (pathsleft_read_words(7)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsleft_stay_choices(15, i) then
          pathsleft_stay_choices(15, i + 1) := (not (pathsleft_read_words(7)(i + 21) = '1')) or
            pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(15, i + 1) := (not (pathsleft_read_words(7)(i + 21) = '1')) and
            pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(15, 5) then
        pathsleft_stay_choices(15, 6) := (not (pathsleft_read_words(7)(26) = '1')) or pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(15, 6) := (not (pathsleft_read_words(7)(26) = '1')) and
          pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(15, 6) then
        pathsleft_stay_choices(15, 7) := (not (pathsleft_read_words(7)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(15, 7) := (not (pathsleft_read_words(7)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      pathsleft_stay_value_2s_from_13(15) := pathsleft_read_words(3)(21) = '1';
      if pathsleft_stay_value_2s_from_13(15) then
        pathsleft_stay_choices(15, 8) := not pathsleft_stay_value(0);
      else
        pathsleft_stay_choices(15, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words(3)(22) = '1' then
        pathsleft_stay_choices(15, 9) := pathsleft_stay_value_2s_from_13(15) or (not pathsleft_stay_value(0)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(15, 9) := pathsleft_stay_choices(15, 8);
      end if;
      if pathsleft_stay_choices(15, 9) then
        pathsleft_stay_choices(15, 10) := (not (pathsleft_read_words(3)(23) = '1')) and pathsleft_stay_value_2(0);
      else
        pathsleft_stay_choices(15, 10) := (not (pathsleft_read_words(3)(23) = '1')) or pathsleft_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsleft_stay_choices(15, i) then
          pathsleft_stay_choices(15, i + 1) := (not (pathsleft_read_words(3)(i + 14) = '1')) or
            pathsleft_stay_0_values(i - 7);
        else
          pathsleft_stay_choices(15, i + 1) := (not (pathsleft_read_words(3)(i + 14) = '1')) and
            pathsleft_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsleft_stay_choices(15, 12) then
        pathsleft_stay_choices(15, 13) := (not (pathsleft_read_words(3)(26) = '1')) or
          pathsleft_stay_0_values_from_5(5);
      else
        pathsleft_stay_choices(15, 13) := (not (pathsleft_read_words(3)(26) = '1')) and
          pathsleft_stay_0_values_from_5(5);
      end if;
      if pathsleft_stay_choices(15, 13) then
        pathsleft_stay_choices(15, 14) := (not (pathsleft_read_words(3)(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(15, 14) := (not (pathsleft_read_words(3)(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(15, 7) then
        pathsleft_stay_choices(15, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(15, 15) := pathsleft_stay_choices(15, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words(7)(27 downto 21)) - to_integer(pathsleft_read_words(3)(27 downto 21))) < 0
        then
        pathsleft_stay_choice_16(15) := to_integer(pathsleft_read_words(7)(27 downto 21));
      else
        pathsleft_stay_choice_16(15) := to_integer(pathsleft_read_words(3)(27 downto 21));
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
      for i in 1 to 2 loop
        if (to_integer(pathsleft_read_words(i)(48 - 21 * i downto 42 - 21 * i)) - pathsleft_stay_values_from_5(i + 4,
          4)) < 0 then
          pathsleft_step_choice(i + 5) := to_integer(pathsleft_read_words(i)(48 - 21 * i downto 42 - 21 * i));
        else
          pathsleft_step_choice(i + 5) := pathsleft_stay_values_from_5(i + 4, 4);
        end if;
      end loop;
      for i in 9 to 10 loop
        if (pathsleft_stay_values_2(i, 4) - to_integer(pathsleft_read_words(i - 8)(216 - 21 * i downto 210 - 21 * i)))
          < 0 then
          pathsleft_step_choice(i - 1) := pathsleft_stay_values_2(i, 4);
        else
          pathsleft_step_choice(i - 1) := to_integer(pathsleft_read_words(i - 8)(216 - 21 * i downto 210 - 21 * i));
        end if;
      end loop;
      for i in 2 to 3 loop
        if (to_integer(pathsleft_read_words(i)(69 - 21 * i downto 63 - 21 * i)) - pathsleft_stay_values_2(i + 7, 4)) <
          0 then
          pathsleft_step_choice(i + 8) := to_integer(pathsleft_read_words(i)(69 - 21 * i downto 63 - 21 * i));
        else
          pathsleft_step_choice(i + 8) := pathsleft_stay_values_2(i + 7, 4);
        end if;
      end loop;
      for i in 13 to 14 loop
        if (pathsleft_stay_values_3(i, 4) - to_integer(pathsleft_read_words(i - 11)(300 - 21 * i downto 294 - 21 * i)))
          < 0 then
          pathsleft_step_choice(i - 1) := pathsleft_stay_values_3(i, 4);
        else
          pathsleft_step_choice(i - 1) := to_integer(pathsleft_read_words(i - 11)(300 - 21 * i downto 294 - 21 * i));
        end if;
      end loop;
      if (to_integer(pathsleft_read_words(3)(27 downto 21)) - pathsleft_stay_values_3(13, 4)) < 0 then
        pathsleft_step_choice(14) := to_integer(pathsleft_read_words(3)(27 downto 21));
      else
        pathsleft_step_choice(14) := pathsleft_stay_values_3(13, 4);
      end if;
      if pathsleft_is_last then
        pathsleft_step_choice(15) := pathsleft_stay_values_3(14, 4);
      else
        pathsleft_step_choice(15) := to_integer(pathsleft_read_neighbour_0);
      end if;
      if (pathsleft_step_choice(15) - pathsleft_stay_values_3(14, 4)) < 0 then
        pathsleft_step_15_choice_2 := pathsleft_step_choice(15);
      else
        pathsleft_step_15_choice_2 := pathsleft_stay_values_3(14, 4);
      end if;
      pathsleft_stay_change_value(1) := to_integer(paths_cost_delay_held_0(5 downto 0)) / 8;
      for i in 2 to 8 loop
        pathsleft_stay_change_value(i) := to_integer(paths_cost_delay_held_0(3 * i + 2 downto 3 * i));
      end loop;
      pathsleft_stay_change_values(11) := to_integer(paths_cost_delay_held_1(5 downto 0)) / 8;
      pathsleft_stay_change_values(12) := to_integer(paths_cost_delay_held_1(8 downto 6));
      pathsleft_stay_change_values(13) := to_integer(paths_cost_delay_held_1(11 downto 9));
      pathsleft_stay_change_values(14) := to_integer(paths_cost_delay_held_1(14 downto 12));
      if pathsleft_write_count_phase = 7 then
        pathsleft_write_count_phase_choice := 7;
      else
        pathsleft_write_count_phase_choice := (pathsleft_write_count_phase + 1) mod 8;
      end if;
      if line_comes(27) then
        pathsleft_low_0_choice := 127;
      else
        pathsleft_low_0_choice := pathsleft_low_0;
      end if;
      pathsleft_fresh_past_oldest <= pathsleft_fresh_past_fours(7);
      pathsleft_lost <= is_set(pathsleft_fresh_known, 6);
      pathsleft_short_of <= (((pathsleft_fresh_known mod 64) + pathsleft_room) / 64) = 1;
      pathsleft_missing <= (pathsleft_fresh_known + pathsleft_room) mod 64;
      pathsleft_below <= (0 - pathsleft_fresh_known) mod 64;
      pathsleft_is_first <= pathsleft_read_count_phase = 0;
      pathsleft_is_last <= pathsleft_read_count_phase_is_equal;
      pathsleft_lower_neighbour <= to_integer(pathsleft_read_words(3)(27 downto 21));
      pathsleft_stay_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g) mod 128;
      for i in 1 to 8 loop
        pathsleft_stay_change(i) <= (pathsleft_stay_change_value(i) - pathsleft_g) mod 128;
      end loop;
      pathsleft_stay_change(9) <= (to_integer(paths_cost_delay_held_0(29 downto 27)) - pathsleft_g) mod 128;
      pathsleft_stay_change(10) <= (to_integer(paths_cost_delay_held_1(2 downto 0)) - pathsleft_g) mod 128;
      pathsleft_stay_change(11) <= (pathsleft_stay_change_values(11) - pathsleft_g) mod 128;
      pathsleft_stay_change(12) <= (pathsleft_stay_change_values(12) - pathsleft_g) mod 128;
      pathsleft_stay_change(13) <= (pathsleft_stay_change_values(13) - pathsleft_g) mod 128;
      pathsleft_stay_change(14) <= (pathsleft_stay_change_values(14) - pathsleft_g) mod 128;
      pathsleft_stay_change(15) <= (to_integer(paths_cost_delay_held_1(17 downto 15)) - pathsleft_g) mod 128;
      pathsleft_step_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g_less) mod 128;
      for i in 1 to 8 loop
        pathsleft_step_change(i) <= (pathsleft_stay_change_value(i) - pathsleft_g_less) mod 128;
      end loop;
      pathsleft_step_change(9) <= (to_integer(paths_cost_delay_held_0(29 downto 27)) - pathsleft_g_less) mod 128;
      pathsleft_step_change(10) <= (to_integer(paths_cost_delay_held_1(2 downto 0)) - pathsleft_g_less) mod 128;
      pathsleft_step_change(11) <= (pathsleft_stay_change_values(11) - pathsleft_g_less) mod 128;
      pathsleft_step_change(12) <= (pathsleft_stay_change_values(12) - pathsleft_g_less) mod 128;
      pathsleft_step_change(13) <= (pathsleft_stay_change_values(13) - pathsleft_g_less) mod 128;
      pathsleft_step_change(14) <= (pathsleft_stay_change_values(14) - pathsleft_g_less) mod 128;
      pathsleft_step_change(15) <= (to_integer(paths_cost_delay_held_1(17 downto 15)) - pathsleft_g_less) mod 128;
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
      if line_starts_phases(19) then
        pathsleft_read_count_phase <= 0;
      else
        pathsleft_read_count_phase <= pathsleft_read_count_phase_choice;
      end if;
      if line_starts_phases(18) then
        pathsleft_ahead_count_phase <= 0;
      else
        pathsleft_ahead_count_phase <= pathsleft_ahead_count_phase_choice;
      end if;
      for i in 0 to 15 loop
        if pathsleft_stay_choices(i, 15) then
          pathsleft_stay(i) <= pathsleft_stay_choice_16(i);
        else
          pathsleft_stay(i) <= pathsleft_fresh_here;
        end if;
      end loop;
      if pathsleft_first then
        for i in 0 to 15 loop
          pathsleft_step(i) <= 64;
        end loop;
      else
        pathsleft_step(0) <= pathsleft_step_0_choice_2;
        for i in 1 to 14 loop
          pathsleft_step(i) <= pathsleft_step_choice(i);
        end loop;
        pathsleft_step(15) <= pathsleft_step_15_choice_2;
      end if;
      if line_starts_phases(22) then
        pathsleft_write_count_phase <= 0;
      else
        pathsleft_write_count_phase <= pathsleft_write_count_phase_choice;
      end if;
      for i in 0 to 7 loop
        if (pathsleft_cost(2 * i + 1) - pathsleft_cost(2 * i)) < 0 then
          pathsleft_tree_smallest(i) <= pathsleft_cost(2 * i + 1);
        else
          pathsleft_tree_smallest(i) <= pathsleft_cost(2 * i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (pathsleft_tree_smallest(2 * i + 1) - pathsleft_tree_smallest(2 * i)) < 0 then
          pathsleft_tree_next_smallest(i) <= pathsleft_tree_smallest(2 * i + 1);
        else
          pathsleft_tree_next_smallest(i) <= pathsleft_tree_smallest(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (pathsleft_tree_next_smallest(2 * i + 1) - pathsleft_tree_next_smallest(2 * i)) < 0 then
          pathsleft_tree_next_next_smallest(i) <= pathsleft_tree_next_smallest(2 * i + 1);
        else
          pathsleft_tree_next_next_smallest(i) <= pathsleft_tree_next_smallest(2 * i);
        end if;
      end loop;
      if (pathsleft_tree_next_next_smallest(1) - pathsleft_tree_next_next_smallest(0)) < 0 then
        pathsleft_tree_next_next_next_smallest_0 <= pathsleft_tree_next_next_smallest(1);
      else
        pathsleft_tree_next_next_next_smallest_0 <= pathsleft_tree_next_next_smallest(0);
      end if;
      if (pathsleft_tree_next_next_next_smallest_0 - pathsleft_low_0_choice) < 0 then
        pathsleft_low_0 <= pathsleft_tree_next_next_next_smallest_0;
      else
        pathsleft_low_0 <= pathsleft_low_0_choice;
      end if;
      if line_starts_phases(20) then
        pathsleft_fresh_here <= relief_left(2);
        pathsleft_first <= line_places_shown_first_column(2);
        pathsleft_g <= paths_smallest_cost + pathsleft_q_now;
        pathsleft_g_less <= (paths_smallest_cost + pathsleft_q_less) mod 128;
      end if;
      if line_starts_phases(14) then
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
      if line_starts_phases(18) then
        if line_places_shown_first_column(2) then
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
      if line_starts_phases(19) then
        pathsleft_q_now <= pathsleft_q;
        pathsleft_q_less <= (pathsleft_q + 121) mod 128;
        if line_places_shown_first_column(2) then
          pathsleft_room <= 0;
          for i in 1 to 9 loop
            pathsleft_start_cost(i) <= 0;
          end loop;
        else
          pathsleft_room <= (pathsleft_room_left + pathsleft_start_cost(9)) mod 64;
          pathsleft_start_cost(1) <= pathsleft_q_now;
          for i in 2 to 9 loop
            pathsleft_start_cost(i) <= pathsleft_start_cost(i - 1);
          end loop;
        end if;
      end if;
      pathsleft_cost_0_any := (not is_set(pathsleft_write_count_phase, 2)) or (not is_set(pathsleft_write_count_phase,
        1)) or (not is_set(pathsleft_write_count_phase, 0)) or line_starts_phases(22);
      if pathsleft_cost_0_any then
        for i in 0 to 15 loop
          pathsleft_cost(i) <= (pathsleft_stay(i) + pathsleft_stay_change(i)) mod 128;
        end loop;
        for i in 0 to 15 loop
          pathsleft_arrived(i) <= (pathsleft_step(i) + pathsleft_step_change(i)) mod 128;
        end loop;
      end if;
      if line_starts_phases(35) then
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
        pathsabove_memory_read_address_2_choice := 0;
      else
        pathsabove_memory_read_address_2_choice := pathsabove_memory_read_address_0_sum mod 2048;
      end if;
      if line_places_shown_first_column(0) then
        pathsabove_memory_bank_choice := 0;
      else
        pathsabove_memory_bank_choice := pathsabove_memory_read_address_0_sum mod 16384;
      end if;
      if line_starts_phases(4) then
        pathsabove_memory_bank_choice_2 := pathsabove_memory_bank_choice;
      else
        pathsabove_memory_bank_choice_2 := pathsabove_memory_read_address_0_sum_2 mod 16384;
      end if;
      pathsabove_memory_ready_words_0_is_equal := pathsabove_memory_held_bank = 2;
      pathsabove_memory_ready_words_0_is_equal_2 := pathsabove_memory_held_bank = 1;
      for i in 0 to 9 loop
        if pathsabove_memory_ready_words_0_is_equal_2 then
          pathsabove_memory_ready_words_choice(i) := pathsabove_memory_held_words(1, i);
        else
          pathsabove_memory_ready_words_choice(i) := pathsabove_memory_held_words(0, i);
        end if;
      end loop;
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
      for i in 0 to 1 loop
        if pathsabove_ready_top then
          pathsabove_total_choice(8 * i) := 31;
        else
          pathsabove_total_choice(8 * i) := pathsabove_memory_ready_words(5 * i) mod 32;
        end if;
        if pathsabove_ready_top then
          pathsabove_total_choice(8 * i + 1) := 31;
        else
          pathsabove_total_choice(8 * i + 1) := ((pathsabove_memory_ready_words(5 * i + 1) mod 4) * 8) +
            (pathsabove_memory_ready_words(5 * i) / 32);
        end if;
        if pathsabove_ready_top then
          pathsabove_total_choice(8 * i + 2) := 31;
        else
          pathsabove_total_choice(8 * i + 2) := (pathsabove_memory_ready_words(5 * i + 1) / 4) mod 32;
        end if;
        if pathsabove_ready_top then
          pathsabove_total_choice(8 * i + 3) := 31;
        else
          pathsabove_total_choice(8 * i + 3) := ((pathsabove_memory_ready_words(5 * i + 2) mod 16) * 2) +
            (pathsabove_memory_ready_words(5 * i + 1) / 128);
        end if;
        if pathsabove_ready_top then
          pathsabove_total_choice(8 * i + 4) := 31;
        else
          pathsabove_total_choice(8 * i + 4) := ((pathsabove_memory_ready_words(5 * i + 3) mod 2) * 16) +
            (pathsabove_memory_ready_words(5 * i + 2) / 16);
        end if;
        if pathsabove_ready_top then
          pathsabove_total_choice(8 * i + 5) := 31;
        else
          pathsabove_total_choice(8 * i + 5) := (pathsabove_memory_ready_words(5 * i + 3) / 2) mod 32;
        end if;
        if pathsabove_ready_top then
          pathsabove_total_choice(8 * i + 6) := 31;
        else
          pathsabove_total_choice(8 * i + 6) := ((pathsabove_memory_ready_words(5 * i + 4) mod 8) * 4) +
            (pathsabove_memory_ready_words(5 * i + 3) / 64);
        end if;
        if pathsabove_ready_top then
          pathsabove_total_choice(8 * i + 7) := 31;
        else
          pathsabove_total_choice(8 * i + 7) := pathsabove_memory_ready_words(5 * i + 4) / 8;
        end if;
      end loop;
      if line_comes(13) then
        pathsabove_smallest_total_choice := 63;
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
        pathsabove_beside_15_choice := pathsabove_held(14);
      else
        pathsabove_beside_15_choice := pathsabove_cost(0);
      end if;
      if line_places_first_column(3) then
        pathsabove_write_address_address_choice := 0;
      else
        pathsabove_write_address_address_choice := (pathsabove_write_address_address + 1) mod 16384;
      end if;
      if pathsabove_write_address_count_phase = 7 then
        pathsabove_write_address_count_phase_choice := 7;
      else
        pathsabove_write_address_count_phase_choice := (pathsabove_write_address_count_phase + 1) mod 8;
      end if;
      pathsabove_memory_bank <= pathsabove_memory_bank_choice_2 / 4096;
      pathsabove_memory_read_bank <= pathsabove_memory_bank;
      for i in 0 to 2 loop
        for j in 0 to 9 loop
          pathsabove_memory_held_words(i, j) <= to_integer(pathsabove_memory_read_words(i, j));
        end loop;
      end loop;
      pathsabove_memory_held_bank <= pathsabove_memory_read_bank;
      pathsabove_read_address_address <= pathsabove_memory_bank_choice_2;
      for i in 0 to 15 loop
        pathsabove_total(i) <= costs_cost(i) + pathsabove_total_choice(i);
      end loop;
      for i in 0 to 2 loop
        pathsabove_cost(5 * i) <= (to_integer(pathsabove_delay_held(i)) - pathsabove_smallest) mod 64;
        pathsabove_cost(5 * i + 1) <= (to_integer(pathsabove_delay_held(i)(29 downto 6)) - pathsabove_smallest) mod 64;
        pathsabove_cost(5 * i + 2) <= (to_integer(pathsabove_delay_held(i)(29 downto 12)) - pathsabove_smallest) mod 64;
        pathsabove_cost(5 * i + 3) <= (to_integer(pathsabove_delay_held(i)(29 downto 18)) - pathsabove_smallest) mod 64;
        pathsabove_cost(5 * i + 4) <= (to_integer(pathsabove_delay_held(i)(29 downto 24)) - pathsabove_smallest) mod 64;
      end loop;
      pathsabove_cost(15) <= (to_integer(pathsabove_delay_held_3) - pathsabove_smallest) mod 64;
      for i in 0 to 15 loop
        pathsabove_held(i) <= pathsabove_cost(i);
      end loop;
      pathsabove_lower_neighbour <= pathsabove_held(15);
      for i in 0 to 14 loop
        pathsabove_own(i) <= pathsabove_held(i);
      end loop;
      for i in 0 to 15 loop
        pathsabove_step(i) <= pathsabove_beside(i) + 5;
      end loop;
      pathsabove_write_address_is_here <= line_starts_phases(25) or (not is_set(pathsabove_write_address_count_phase,
        2)) or (not is_set(pathsabove_write_address_count_phase, 1)) or (not
        is_set(pathsabove_write_address_count_phase, 0));
      if line_starts_phases(4) then
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_choice;
        pathsabove_memory_read_address_2 <= pathsabove_memory_read_address_2_choice;
        pathsabove_read_address_count_phase <= 0;
      else
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_sum_2 mod 4096;
        pathsabove_memory_read_address_2 <= pathsabove_memory_read_address_0_sum_2 mod 2048;
        pathsabove_read_address_count_phase <= pathsabove_read_address_count_phase_choice;
      end if;
      if pathsabove_memory_ready_words_0_is_equal then
        for i in 0 to 9 loop
          pathsabove_memory_ready_words(i) <= pathsabove_memory_held_words(2, i);
        end loop;
      else
        for i in 0 to 9 loop
          pathsabove_memory_ready_words(i) <= pathsabove_memory_ready_words_choice(i);
        end loop;
      end if;
      if line_places_0_top then
        pathsabove_ready_top <= pathsabove_ready_top_choice;
      else
        pathsabove_ready_top <= pathsabove_ready_top_choice_2;
      end if;
      for i in 0 to 7 loop
        if (pathsabove_total(2 * i + 1) - pathsabove_total(2 * i)) < 0 then
          pathsabove_tree_smallest(i) <= pathsabove_total(2 * i + 1);
        else
          pathsabove_tree_smallest(i) <= pathsabove_total(2 * i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (pathsabove_tree_smallest(2 * i + 1) - pathsabove_tree_smallest(2 * i)) < 0 then
          pathsabove_tree_next_smallest(i) <= pathsabove_tree_smallest(2 * i + 1);
        else
          pathsabove_tree_next_smallest(i) <= pathsabove_tree_smallest(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (pathsabove_tree_next_smallest(2 * i + 1) - pathsabove_tree_next_smallest(2 * i)) < 0 then
          pathsabove_tree_next_next_smallest(i) <= pathsabove_tree_next_smallest(2 * i + 1);
        else
          pathsabove_tree_next_next_smallest(i) <= pathsabove_tree_next_smallest(2 * i);
        end if;
      end loop;
      if (pathsabove_tree_next_next_smallest(1) - pathsabove_tree_next_next_smallest(0)) < 0 then
        pathsabove_tree_next_next_next_smallest_0 <= pathsabove_tree_next_next_smallest(1);
      else
        pathsabove_tree_next_next_next_smallest_0 <= pathsabove_tree_next_next_smallest(0);
      end if;
      if (pathsabove_tree_next_next_next_smallest_0 - pathsabove_smallest_total_choice) < 0 then
        pathsabove_smallest_total <= pathsabove_tree_next_next_next_smallest_0;
      else
        pathsabove_smallest_total <= pathsabove_smallest_total_choice;
      end if;
      if line_starts_phases(23) then
        pathsabove_count_phase <= 0;
      else
        pathsabove_count_phase <= pathsabove_count_phase_choice;
      end if;
      if (pathsabove_held(1) - pathsabove_beside_0_choice) < 0 then
        pathsabove_beside(0) <= pathsabove_held(1);
      else
        pathsabove_beside(0) <= pathsabove_beside_0_choice;
      end if;
      for i in 2 to 15 loop
        if (pathsabove_held(i) - pathsabove_held(i - 2)) < 0 then
          pathsabove_beside(i - 1) <= pathsabove_held(i);
        else
          pathsabove_beside(i - 1) <= pathsabove_held(i - 2);
        end if;
      end loop;
      if (pathsabove_beside_15_choice - pathsabove_held(14)) < 0 then
        pathsabove_beside(15) <= pathsabove_beside_15_choice;
      else
        pathsabove_beside(15) <= pathsabove_held(14);
      end if;
      for i in 0 to 14 loop
        if pathsabove_own(i) < 31 then
          pathsabove_stay(i) <= pathsabove_own(i) mod 32;
        else
          pathsabove_stay(i) <= 31;
        end if;
      end loop;
      if pathsabove_lower_neighbour < 31 then
        pathsabove_stay(15) <= pathsabove_lower_neighbour mod 32;
      else
        pathsabove_stay(15) <= 31;
      end if;
      if line_starts_phases(25) then
        pathsabove_write_address_address <= pathsabove_write_address_address_choice;
        pathsabove_write_address_count_phase <= 0;
      else
        pathsabove_write_address_address <= (pathsabove_write_address_address + as_number(((not
          is_set(pathsabove_write_address_count_phase, 2)) or (not is_set(pathsabove_write_address_count_phase, 1)) or
          (not is_set(pathsabove_write_address_count_phase, 0))))) mod 16384;
        pathsabove_write_address_count_phase <= pathsabove_write_address_count_phase_choice;
      end if;
      pathsabove_memory_write_words_0_is_less(0) := (pathsabove_step(1) - pathsabove_stay(1)) < 0;
      if pathsabove_memory_write_words_0_is_less(0) then
        pathsabove_memory_write_words_0_0_choice := pathsabove_step(1) mod 8;
      else
        pathsabove_memory_write_words_0_0_choice := pathsabove_stay(1) mod 8;
      end if;
      if (pathsabove_step(0) - pathsabove_stay(0)) < 0 then
        pathsabove_memory_write_words_0_choice_2(0) := pathsabove_step(0) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2(0) := pathsabove_stay(0);
      end if;
      pathsabove_memory_write_words_0_sum(0) := (pathsabove_memory_write_words_0_0_choice * 32) +
        pathsabove_memory_write_words_0_choice_2(0);
      if pathsabove_memory_write_words_0_is_less(0) then
        pathsabove_memory_write_words_0_choice(1) := pathsabove_step(1) mod 32;
      else
        pathsabove_memory_write_words_0_choice(1) := pathsabove_stay(1);
      end if;
      if (pathsabove_step(2) - pathsabove_stay(2)) < 0 then
        pathsabove_memory_write_words_0_choice_2(1) := pathsabove_step(2) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2(1) := pathsabove_stay(2);
      end if;
      pathsabove_memory_write_words_0_is_less(1) := (pathsabove_step(3) - pathsabove_stay(3)) < 0;
      if pathsabove_memory_write_words_0_is_less(1) then
        pathsabove_memory_write_words_0_1_choice_3 := is_set(pathsabove_step(3), 0);
      else
        pathsabove_memory_write_words_0_1_choice_3 := is_set(pathsabove_stay(3), 0);
      end if;
      pathsabove_memory_write_words_0_sum(1) := (pathsabove_memory_write_words_0_choice(1) / 8) +
        (pathsabove_memory_write_words_0_choice_2(1) * 4) + (as_number(pathsabove_memory_write_words_0_1_choice_3) *
        128);
      if pathsabove_memory_write_words_0_is_less(1) then
        pathsabove_memory_write_words_0_choice(2) := pathsabove_step(3) mod 32;
      else
        pathsabove_memory_write_words_0_choice(2) := pathsabove_stay(3);
      end if;
      pathsabove_memory_write_words_0_is_less(2) := (pathsabove_step(4) - pathsabove_stay(4)) < 0;
      if pathsabove_memory_write_words_0_is_less(2) then
        pathsabove_memory_write_words_0_2_choice_2 := pathsabove_step(4) mod 16;
      else
        pathsabove_memory_write_words_0_2_choice_2 := pathsabove_stay(4) mod 16;
      end if;
      pathsabove_memory_write_words_0_sum(2) := (pathsabove_memory_write_words_0_choice(2) / 2) +
        (pathsabove_memory_write_words_0_2_choice_2 * 16);
      if pathsabove_memory_write_words_0_is_less(2) then
        pathsabove_memory_write_words_0_choice(3) := pathsabove_step(4) mod 32;
      else
        pathsabove_memory_write_words_0_choice(3) := pathsabove_stay(4);
      end if;
      if (pathsabove_step(5) - pathsabove_stay(5)) < 0 then
        pathsabove_memory_write_words_0_choice_2s(3) := pathsabove_step(5) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2s(3) := pathsabove_stay(5);
      end if;
      pathsabove_memory_write_words_0_is_less(3) := (pathsabove_step(6) - pathsabove_stay(6)) < 0;
      if pathsabove_memory_write_words_0_is_less(3) then
        pathsabove_memory_write_words_0_3_choice_3 := pathsabove_step(6) mod 4;
      else
        pathsabove_memory_write_words_0_3_choice_3 := pathsabove_stay(6) mod 4;
      end if;
      pathsabove_memory_write_words_0_sum(3) := (pathsabove_memory_write_words_0_choice(3) / 16) +
        (pathsabove_memory_write_words_0_choice_2s(3) * 2) + (pathsabove_memory_write_words_0_3_choice_3 * 64);
      if pathsabove_memory_write_words_0_is_less(3) then
        pathsabove_memory_write_words_0_choice(4) := pathsabove_step(6) mod 32;
      else
        pathsabove_memory_write_words_0_choice(4) := pathsabove_stay(6);
      end if;
      if (pathsabove_step(7) - pathsabove_stay(7)) < 0 then
        pathsabove_memory_write_words_0_choice_2s(4) := pathsabove_step(7) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2s(4) := pathsabove_stay(7);
      end if;
      pathsabove_memory_write_words_0_sum(4) := (pathsabove_memory_write_words_0_choice(4) / 4) +
        (pathsabove_memory_write_words_0_choice_2s(4) * 8);
      pathsabove_memory_write_words_0_is_lesss(5) := (pathsabove_step(9) - pathsabove_stay(9)) < 0;
      if pathsabove_memory_write_words_0_is_lesss(5) then
        pathsabove_memory_write_words_0_5_choice := pathsabove_step(9) mod 8;
      else
        pathsabove_memory_write_words_0_5_choice := pathsabove_stay(9) mod 8;
      end if;
      if (pathsabove_step(8) - pathsabove_stay(8)) < 0 then
        pathsabove_memory_write_words_0_choice_2s(5) := pathsabove_step(8) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2s(5) := pathsabove_stay(8);
      end if;
      pathsabove_memory_write_words_0_sum(5) := (pathsabove_memory_write_words_0_5_choice * 32) +
        pathsabove_memory_write_words_0_choice_2s(5);
      if pathsabove_memory_write_words_0_is_lesss(5) then
        pathsabove_memory_write_words_0_choices(6) := pathsabove_step(9) mod 32;
      else
        pathsabove_memory_write_words_0_choices(6) := pathsabove_stay(9);
      end if;
      if (pathsabove_step(10) - pathsabove_stay(10)) < 0 then
        pathsabove_memory_write_words_0_choice_2s(6) := pathsabove_step(10) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2s(6) := pathsabove_stay(10);
      end if;
      pathsabove_memory_write_words_0_is_lesss(6) := (pathsabove_step(11) - pathsabove_stay(11)) < 0;
      if pathsabove_memory_write_words_0_is_lesss(6) then
        pathsabove_memory_write_words_0_6_choice_3 := is_set(pathsabove_step(11), 0);
      else
        pathsabove_memory_write_words_0_6_choice_3 := is_set(pathsabove_stay(11), 0);
      end if;
      pathsabove_memory_write_words_0_sum(6) := (pathsabove_memory_write_words_0_choices(6) / 8) +
        (pathsabove_memory_write_words_0_choice_2s(6) * 4) + (as_number(pathsabove_memory_write_words_0_6_choice_3) *
        128);
      if pathsabove_memory_write_words_0_is_lesss(6) then
        pathsabove_memory_write_words_0_choices(7) := pathsabove_step(11) mod 32;
      else
        pathsabove_memory_write_words_0_choices(7) := pathsabove_stay(11);
      end if;
      pathsabove_memory_write_words_0_is_lesss(7) := (pathsabove_step(12) - pathsabove_stay(12)) < 0;
      if pathsabove_memory_write_words_0_is_lesss(7) then
        pathsabove_memory_write_words_0_7_choice_2 := pathsabove_step(12) mod 16;
      else
        pathsabove_memory_write_words_0_7_choice_2 := pathsabove_stay(12) mod 16;
      end if;
      pathsabove_memory_write_words_0_sum(7) := (pathsabove_memory_write_words_0_choices(7) / 2) +
        (pathsabove_memory_write_words_0_7_choice_2 * 16);
      if pathsabove_memory_write_words_0_is_lesss(7) then
        pathsabove_memory_write_words_0_choices(8) := pathsabove_step(12) mod 32;
      else
        pathsabove_memory_write_words_0_choices(8) := pathsabove_stay(12);
      end if;
      if (pathsabove_step(13) - pathsabove_stay(13)) < 0 then
        pathsabove_memory_write_words_0_choice_2s_from_8(8) := pathsabove_step(13) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2s_from_8(8) := pathsabove_stay(13);
      end if;
      pathsabove_memory_write_words_0_is_lesss(8) := (pathsabove_step(14) - pathsabove_stay(14)) < 0;
      if pathsabove_memory_write_words_0_is_lesss(8) then
        pathsabove_memory_write_words_0_8_choice_3 := pathsabove_step(14) mod 4;
      else
        pathsabove_memory_write_words_0_8_choice_3 := pathsabove_stay(14) mod 4;
      end if;
      pathsabove_memory_write_words_0_sum(8) := (pathsabove_memory_write_words_0_choices(8) / 16) +
        (pathsabove_memory_write_words_0_choice_2s_from_8(8) * 2) + (pathsabove_memory_write_words_0_8_choice_3 * 64);
      if pathsabove_memory_write_words_0_is_lesss(8) then
        pathsabove_memory_write_words_0_choices(9) := pathsabove_step(14) mod 32;
      else
        pathsabove_memory_write_words_0_choices(9) := pathsabove_stay(14);
      end if;
      if (pathsabove_step(15) - pathsabove_stay(15)) < 0 then
        pathsabove_memory_write_words_0_choice_2s_from_8(9) := pathsabove_step(15) mod 32;
      else
        pathsabove_memory_write_words_0_choice_2s_from_8(9) := pathsabove_stay(15);
      end if;
      pathsabove_memory_write_words_0_sum(9) := (pathsabove_memory_write_words_0_choices(9) / 4) +
        (pathsabove_memory_write_words_0_choice_2s_from_8(9) * 8);
      pathsabove_memory_write_words_0_all(0) := pathsabove_write_address_is_here and (pathsabove_write_address_address
        < 4096);
      for i in 0 to 1 loop
        if pathsabove_memory_write_words_0_all(i) then
          for j in 0 to 9 loop
            pathsabove_memory_write_words(i, j) <= pathsabove_memory_write_words_0_sum(j);
          end loop;
          pathsabove_memory_write_address(i) <= pathsabove_write_address_address mod 4096;
        end if;
        pathsabove_memory_write_words_0_all(i + 1) := pathsabove_write_address_is_here and
          ((pathsabove_write_address_address / 4096) = (i + 1));
      end loop;
      if pathsabove_memory_write_words_0_all(2) then
        for i in 0 to 9 loop
          pathsabove_memory_write_words(2, i) <= pathsabove_memory_write_words_0_sum(i);
        end loop;
        pathsabove_memory_write_address_2 <= pathsabove_write_address_address mod 2048;
      end if;
      if line_comes(21) then
        pathsabove_smallest <= pathsabove_smallest_total;
      end if;
      -- pathsturn
      pathsturn_sum_memory_ready_words_0_is_equal := pathsturn_sum_memory_held_bank = 2;
      pathsturn_sum_memory_ready_words_0_is_equal_2 := pathsturn_sum_memory_held_bank = 1;
      for i in 0 to 13 loop
        if pathsturn_sum_memory_ready_words_0_is_equal_2 then
          pathsturn_sum_memory_ready_words_choice(i) := pathsturn_sum_memory_held_words(1, i);
        else
          pathsturn_sum_memory_ready_words_choice(i) := pathsturn_sum_memory_held_words(0, i);
        end if;
      end loop;
      pathsturn_cost_memory_read_address_0_sum := pathsturn_read_address_address + as_number(((not
        is_set(pathsturn_read_address_count_phase, 2)) or (not is_set(pathsturn_read_address_count_phase, 1)) or (not
        is_set(pathsturn_read_address_count_phase, 0))));
      if line_starts_phases(17) then
        pathsturn_cost_memory_bank_choice := line_places_address(2) * 8;
      else
        pathsturn_cost_memory_bank_choice := pathsturn_cost_memory_read_address_0_sum mod 16384;
      end if;
      pathsturn_cost_memory_ready_words_0_is_equal := pathsturn_sum_memory_bank = 2;
      pathsturn_cost_memory_ready_words_0_is_equal_2 := pathsturn_sum_memory_bank = 1;
      for i in 0 to 5 loop
        if pathsturn_cost_memory_ready_words_0_is_equal_2 then
          pathsturn_cost_memory_ready_words_choice(i) := pathsturn_cost_memory_held_words(1, i);
        else
          pathsturn_cost_memory_ready_words_choice(i) := pathsturn_cost_memory_held_words(0, i);
        end if;
      end loop;
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
      pathsturn_sum_memory_read_address_2 <= pathsturn_sum_read_address mod 2048;
      pathsturn_sum_memory_bank <= pathsturn_cost_memory_read_bank;
      pathsturn_sum_memory_read_bank <= pathsturn_cost_memory_held_bank;
      for i in 0 to 2 loop
        for j in 0 to 13 loop
          pathsturn_sum_memory_held_words(i, j) <= to_integer(pathsturn_sum_memory_read_words(i, j));
        end loop;
      end loop;
      pathsturn_sum_memory_held_bank <= pathsturn_sum_memory_read_bank;
      pathsturn_cost_memory_bank <= pathsturn_cost_memory_bank_choice / 4096;
      pathsturn_cost_memory_read_bank <= pathsturn_cost_memory_bank;
      for i in 0 to 2 loop
        for j in 0 to 5 loop
          pathsturn_cost_memory_held_words(i, j) <= to_integer(pathsturn_cost_memory_read_words(i, j));
        end loop;
      end loop;
      pathsturn_cost_memory_held_bank <= pathsturn_sum_read_address / 4096;
      pathsturn_ready_smallest_0 <= to_integer(pathsturn_read_smallest_0);
      pathsturn_read_address_address <= pathsturn_cost_memory_bank_choice;
      pathsturn_sum_read_address <= pathsturn_read_address_address;
      pathsturn_write_smallest_0 <= paths_smallest_cost;
      pathsturn_write_address_is_here <= line_starts_phases(20) or (not is_set(pathsturn_write_address_count_phase, 2))
        or (not is_set(pathsturn_write_address_count_phase, 1)) or (not is_set(pathsturn_write_address_count_phase, 0));
      pathsturn_sum_write_address(0) <= pathsturn_write_address_address;
      pathsturn_sum_write_address(1) <= pathsturn_sum_write_address(0);
      pathsturn_writes_sums(0) <= pathsturn_write_address_is_here;
      pathsturn_writes_sums(1) <= pathsturn_writes_sums(0);
      if pathsturn_sum_memory_ready_words_0_is_equal then
        for i in 0 to 13 loop
          pathsturn_sum_memory_ready_words(i) <= pathsturn_sum_memory_held_words(2, i);
        end loop;
      else
        for i in 0 to 13 loop
          pathsturn_sum_memory_ready_words(i) <= pathsturn_sum_memory_ready_words_choice(i);
        end loop;
      end if;
      if line_starts_phases(17) then
        pathsturn_cost_memory_read_address_0 <= (line_places_address(2) mod 512) * 8;
        pathsturn_cost_memory_read_address_2 <= (line_places_address(2) mod 256) * 8;
        pathsturn_read_address_count_phase <= 0;
      else
        pathsturn_cost_memory_read_address_0 <= pathsturn_cost_memory_read_address_0_sum mod 4096;
        pathsturn_cost_memory_read_address_2 <= pathsturn_cost_memory_read_address_0_sum mod 2048;
        pathsturn_read_address_count_phase <= pathsturn_read_address_count_phase_choice;
      end if;
      if pathsturn_cost_memory_ready_words_0_is_equal then
        for i in 0 to 5 loop
          pathsturn_cost_memory_ready_words(i) <= pathsturn_cost_memory_held_words(2, i);
        end loop;
      else
        for i in 0 to 5 loop
          pathsturn_cost_memory_ready_words(i) <= pathsturn_cost_memory_ready_words_choice(i);
        end loop;
      end if;
      if line_starts_phases(20) then
        pathsturn_write_smallest_address <= line_places_address(2);
        pathsturn_write_address_address <= line_places_address(2) * 8;
        pathsturn_write_address_count_phase <= 0;
      else
        pathsturn_write_smallest_address <= 1240;
        pathsturn_write_address_address <= (pathsturn_write_address_address + as_number(((not
          is_set(pathsturn_write_address_count_phase, 2)) or (not is_set(pathsturn_write_address_count_phase, 1)) or
          (not is_set(pathsturn_write_address_count_phase, 0))))) mod 16384;
        pathsturn_write_address_count_phase <= pathsturn_write_address_count_phase_choice;
      end if;
      pathsturn_sum_memory_write_words_0_sum(0) := pathsleft_cost(1) + pathsabove_cost(1);
      pathsturn_sum_memory_write_words_0_sum_2(0) := ((pathsleft_cost(0) + pathsabove_cost(0)) mod 128) +
        ((pathsturn_sum_memory_write_words_0_sum(0) mod 2) * 128);
      pathsturn_sum_memory_write_words_0_sum(1) := pathsleft_cost(2) + pathsabove_cost(2);
      pathsturn_sum_memory_write_words_0_sum_2(1) := ((pathsturn_sum_memory_write_words_0_sum(0) mod 128) / 2) +
        ((pathsturn_sum_memory_write_words_0_sum(1) mod 4) * 64);
      pathsturn_sum_memory_write_words_0_sum(2) := pathsleft_cost(3) + pathsabove_cost(3);
      pathsturn_sum_memory_write_words_0_sum_2(2) := ((pathsturn_sum_memory_write_words_0_sum(1) mod 128) / 4) +
        ((pathsturn_sum_memory_write_words_0_sum(2) mod 8) * 32);
      pathsturn_sum_memory_write_words_0_sum(3) := pathsleft_cost(4) + pathsabove_cost(4);
      pathsturn_sum_memory_write_words_0_sum_2(3) := ((pathsturn_sum_memory_write_words_0_sum(2) mod 128) / 8) +
        ((pathsturn_sum_memory_write_words_0_sum(3) mod 16) * 16);
      pathsturn_sum_memory_write_words_0_sum(4) := pathsleft_cost(5) + pathsabove_cost(5);
      pathsturn_sum_memory_write_words_0_sum_2(4) := ((pathsturn_sum_memory_write_words_0_sum(3) mod 128) / 16) +
        ((pathsturn_sum_memory_write_words_0_sum(4) mod 32) * 8);
      pathsturn_sum_memory_write_words_0_sum(5) := pathsleft_cost(6) + pathsabove_cost(6);
      pathsturn_sum_memory_write_words_0_sum_2(5) := ((pathsturn_sum_memory_write_words_0_sum(4) mod 128) / 32) +
        ((pathsturn_sum_memory_write_words_0_sum(5) mod 64) * 4);
      pathsturn_sum_memory_write_words_0_6_sum := ((pathsturn_sum_memory_write_words_0_sum(5) mod 128) / 64) +
        (((pathsleft_cost(7) + pathsabove_cost(7)) mod 128) * 2);
      pathsturn_sum_memory_write_words_0_sums(7) := pathsleft_cost(9) + pathsabove_cost(9);
      pathsturn_sum_memory_write_words_0_sum_2s(7) := ((pathsleft_cost(8) + pathsabove_cost(8)) mod 128) +
        ((pathsturn_sum_memory_write_words_0_sums(7) mod 2) * 128);
      pathsturn_sum_memory_write_words_0_sums(8) := pathsleft_cost(10) + pathsabove_cost(10);
      pathsturn_sum_memory_write_words_0_sum_2s(8) := ((pathsturn_sum_memory_write_words_0_sums(7) mod 128) / 2) +
        ((pathsturn_sum_memory_write_words_0_sums(8) mod 4) * 64);
      pathsturn_sum_memory_write_words_0_sums(9) := pathsleft_cost(11) + pathsabove_cost(11);
      pathsturn_sum_memory_write_words_0_sum_2s(9) := ((pathsturn_sum_memory_write_words_0_sums(8) mod 128) / 4) +
        ((pathsturn_sum_memory_write_words_0_sums(9) mod 8) * 32);
      pathsturn_sum_memory_write_words_0_sums(10) := pathsleft_cost(12) + pathsabove_cost(12);
      pathsturn_sum_memory_write_words_0_sum_2s(10) := ((pathsturn_sum_memory_write_words_0_sums(9) mod 128) / 8) +
        ((pathsturn_sum_memory_write_words_0_sums(10) mod 16) * 16);
      pathsturn_sum_memory_write_words_0_sums(11) := pathsleft_cost(13) + pathsabove_cost(13);
      pathsturn_sum_memory_write_words_0_sum_2s(11) := ((pathsturn_sum_memory_write_words_0_sums(10) mod 128) / 16) +
        ((pathsturn_sum_memory_write_words_0_sums(11) mod 32) * 8);
      pathsturn_sum_memory_write_words_0_sums(12) := pathsleft_cost(14) + pathsabove_cost(14);
      pathsturn_sum_memory_write_words_0_sum_2s(12) := ((pathsturn_sum_memory_write_words_0_sums(11) mod 128) / 32) +
        ((pathsturn_sum_memory_write_words_0_sums(12) mod 64) * 4);
      pathsturn_sum_memory_write_words_0_13_sum := ((pathsturn_sum_memory_write_words_0_sums(12) mod 128) / 64) +
        (((pathsleft_cost(15) + pathsabove_cost(15)) mod 128) * 2);
      pathsturn_sum_memory_write_words_0_all(0) := (pathsturn_sum_write_address(1) < 4096) and pathsturn_writes_sums(1);
      for i in 0 to 1 loop
        if pathsturn_sum_memory_write_words_0_all(i) then
          for j in 0 to 5 loop
            pathsturn_sum_memory_write_words(i, j) <= pathsturn_sum_memory_write_words_0_sum_2(j);
          end loop;
          pathsturn_sum_memory_write_words(i, 6) <= pathsturn_sum_memory_write_words_0_6_sum;
          for j in 7 to 12 loop
            pathsturn_sum_memory_write_words(i, j) <= pathsturn_sum_memory_write_words_0_sum_2s(j);
          end loop;
          pathsturn_sum_memory_write_words(i, 13) <= pathsturn_sum_memory_write_words_0_13_sum;
          pathsturn_sum_memory_write_address(i) <= pathsturn_sum_write_address(1) mod 4096;
        end if;
        pathsturn_sum_memory_write_words_0_all(i + 1) := pathsturn_writes_sums(1) and ((pathsturn_sum_write_address(1)
          / 4096) = (i + 1));
      end loop;
      if pathsturn_sum_memory_write_words_0_all(2) then
        for i in 0 to 5 loop
          pathsturn_sum_memory_write_words(2, i) <= pathsturn_sum_memory_write_words_0_sum_2(i);
        end loop;
        pathsturn_sum_memory_write_words(2, 6) <= pathsturn_sum_memory_write_words_0_6_sum;
        for i in 7 to 12 loop
          pathsturn_sum_memory_write_words(2, i) <= pathsturn_sum_memory_write_words_0_sum_2s(i);
        end loop;
        pathsturn_sum_memory_write_words(2, 13) <= pathsturn_sum_memory_write_words_0_13_sum;
        pathsturn_sum_memory_write_address_2 <= pathsturn_sum_write_address(1) mod 2048;
      end if;
      pathsturn_cost_memory_write_words_0_sum(0) := (to_integer(paths_cost_delay_held_0(7 downto 6)) * 64) +
        to_integer(paths_cost_delay_held_0(5 downto 0));
      pathsturn_cost_memory_write_words_0_sum(1) := ((to_integer(paths_cost_delay_held_0(14 downto 8)) / 2) * 2) +
        to_integer(paths_cost_delay_held_0(8 downto 8)) + (to_integer(paths_cost_delay_held_0(15 downto 15)) * 128);
      pathsturn_cost_memory_write_words_0_sum(2) := (pathsleft_stay_change_value(5) / 2) +
        ((to_integer(paths_cost_delay_held_0(23 downto 16)) / 4) * 4);
      pathsturn_cost_memory_write_words_0_sum(3) := to_integer(paths_cost_delay_held_0(29 downto 24)) +
        (to_integer(paths_cost_delay_held_1(1 downto 0)) * 64);
      pathsturn_cost_memory_write_words_0_sum(4) := (to_integer(paths_cost_delay_held_1(5 downto 0)) / 4) +
        ((to_integer(paths_cost_delay_held_1(8 downto 2)) / 16) * 16) + (to_integer(paths_cost_delay_held_1(9 downto
        9)) * 128);
      pathsturn_cost_memory_write_words_0_sum(5) := (pathsleft_stay_change_values(13) / 2) +
        (to_integer(paths_cost_delay_held_1(17 downto 12)) * 4);
      pathsturn_cost_memory_write_words_0_all(0) := pathsturn_write_address_is_here and
        (pathsturn_write_address_address < 4096);
      for i in 0 to 1 loop
        if pathsturn_cost_memory_write_words_0_all(i) then
          for j in 0 to 5 loop
            pathsturn_cost_memory_write_words(i, j) <= pathsturn_cost_memory_write_words_0_sum(j);
          end loop;
          pathsturn_cost_memory_write_address(i) <= pathsturn_write_address_address mod 4096;
        end if;
        pathsturn_cost_memory_write_words_0_all(i + 1) := pathsturn_write_address_is_here and
          ((pathsturn_write_address_address / 4096) = (i + 1));
      end loop;
      if pathsturn_cost_memory_write_words_0_all(2) then
        for i in 0 to 5 loop
          pathsturn_cost_memory_write_words(2, i) <= pathsturn_cost_memory_write_words_0_sum(i);
        end loop;
        pathsturn_cost_memory_write_address_2 <= pathsturn_write_address_address mod 2048;
      end if;
      if line_starts_phases(17) then
        pathsturn_smallest_address <= line_places_address(2);
      end if;
      -- pathsright
      if line_starts_phases(11) then
        pathsright_fresh_past_newest(0) <= relief_right(1);
        pathsright_fresh_past_newest(1) <= pathsright_fresh_past_newest(0);
      end if;
      if line_starts_phases(12) then
        pathsright_fresh_past_pairs(1) <= pathsright_fresh_past_pairs(0);
        pathsright_fresh_past_pairs(2) <= pathsright_fresh_past_pairs(1);
        if (pathsright_fresh_past_newest(1) - pathsright_fresh_past_newest(0)) < 0 then
          pathsright_fresh_past_pairs(0) <= pathsright_fresh_past_newest(1);
        else
          pathsright_fresh_past_pairs(0) <= pathsright_fresh_past_newest(0);
        end if;
      end if;
      if line_starts_phases(13) then
        for i in 1 to 7 loop
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
      if pathsright_read_words(4)(0) = '1' then
        pathsright_stay_choice(0) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(0) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(4)(1) = '1' then
        pathsright_stay_choices(0, 2) := (pathsright_read_words(4)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(0, 2) := pathsright_stay_choice(0);
      end if;
      pathsright_stay_value_2(0) := is_set(pathsright_fresh_here, 2);
      if pathsright_stay_choices(0, 2) then
        pathsright_stay_choices(0, 3) := (not (pathsright_read_words(4)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(0, 3) := (not (pathsright_read_words(4)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        pathsright_stay_0_values(i) := is_set(pathsright_fresh_here, i);
        if pathsright_stay_choices(0, i) then
          pathsright_stay_choices(0, i + 1) := (not (pathsright_read_words(4)(i) = '1')) or pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(0, i + 1) := (not (pathsright_read_words(4)(i) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      pathsright_stay_0_values_from_5(5) := is_set(pathsright_fresh_here, 5);
      if pathsright_stay_choices(0, 5) then
        pathsright_stay_choices(0, 6) := (not (pathsright_read_words(4)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(0, 6) := (not (pathsright_read_words(4)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(0, 6) then
        pathsright_stay_choices(0, 7) := (not (pathsright_read_words(4)(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(0, 7) := (not (pathsright_read_words(4)(6) = '1')) and is_set(pathsright_fresh_here, 6);
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
      if (to_integer(pathsright_read_words(4)(6 downto 0)) - to_integer(pathsright_read_words(0)(6 downto 0))) < 0 then
        pathsright_stay_choice_16(0) := to_integer(pathsright_read_words(4)(6 downto 0));
      else
        pathsright_stay_choice_16(0) := to_integer(pathsright_read_words(0)(6 downto 0));
      end if;
      for i in 1 to 2 loop
        pathsright_stay_value(i) := pathsright_read_words(4)(7 * i) = '1';
        if pathsright_stay_value(i) then
          pathsright_stay_choice(i) := not pathsright_stay_value(0);
        else
          pathsright_stay_choice(i) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(4)(7 * i + 1) = '1' then
          pathsright_stay_choices(i, 2) := pathsright_stay_value(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 2) := pathsright_stay_choice(i);
        end if;
        if pathsright_stay_choices(i, 2) then
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(4)(7 * i + 2) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(4)(7 * i + 2) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(4)(7 * i + j) = '1')) or
              pathsright_stay_0_values(j);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(4)(7 * i + j) = '1')) and
              pathsright_stay_0_values(j);
          end if;
        end loop;
        if pathsright_stay_choices(i, 5) then
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(4)(7 * i + 5) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(4)(7 * i + 5) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 6) then
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(4)(7 * i + 6) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(4)(7 * i + 6) = '1')) and
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
        pathsright_stay_values_from_1(i, 3) := to_integer(pathsright_read_words(4)(7 * i + 6 downto 7 * i));
        pathsright_stay_values_from_1(i, 4) := to_integer(pathsright_read_words(0)(7 * i + 6 downto 7 * i));
        if (pathsright_stay_values_from_1(i, 3) - pathsright_stay_values_from_1(i, 4)) < 0 then
          pathsright_stay_choice_16(i) := pathsright_stay_values_from_1(i, 3);
        else
          pathsright_stay_choice_16(i) := pathsright_stay_values_from_1(i, 4);
        end if;
      end loop;
      pathsright_stay_value(3) := pathsright_read_words(4)(21) = '1';
      if pathsright_stay_value(3) then
        pathsright_stay_choice(3) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(3) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(4)(22) = '1' then
        pathsright_stay_choices(3, 2) := pathsright_stay_value(3) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(3, 2) := pathsright_stay_choice(3);
      end if;
      if pathsright_stay_choices(3, 2) then
        pathsright_stay_choices(3, 3) := (not (pathsright_read_words(4)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(3, 3) := (not (pathsright_read_words(4)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(3, i) then
          pathsright_stay_choices(3, i + 1) := (not (pathsright_read_words(4)(i + 21) = '1')) or
            pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(3, i + 1) := (not (pathsright_read_words(4)(i + 21) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(3, 5) then
        pathsright_stay_choices(3, 6) := (not (pathsright_read_words(4)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(3, 6) := (not (pathsright_read_words(4)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(3, 6) then
        pathsright_stay_choices(3, 7) := (not (pathsright_read_words(4)(27) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(3, 7) := (not (pathsright_read_words(4)(27) = '1')) and is_set(pathsright_fresh_here,
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
      if (to_integer(pathsright_read_words(4)(27 downto 21)) - to_integer(pathsright_read_words(0)(27 downto 21))) < 0
        then
        pathsright_stay_choice_16(3) := to_integer(pathsright_read_words(4)(27 downto 21));
      else
        pathsright_stay_choice_16(3) := to_integer(pathsright_read_words(0)(27 downto 21));
      end if;
      if pathsright_read_words(5)(0) = '1' then
        pathsright_stay_choice(4) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(4) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(5)(1) = '1' then
        pathsright_stay_choices(4, 2) := (pathsright_read_words(5)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(4, 2) := pathsright_stay_choice(4);
      end if;
      if pathsright_stay_choices(4, 2) then
        pathsright_stay_choices(4, 3) := (not (pathsright_read_words(5)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(4, 3) := (not (pathsright_read_words(5)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(4, i) then
          pathsright_stay_choices(4, i + 1) := (not (pathsright_read_words(5)(i) = '1')) or pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(4, i + 1) := (not (pathsright_read_words(5)(i) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(4, 5) then
        pathsright_stay_choices(4, 6) := (not (pathsright_read_words(5)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(4, 6) := (not (pathsright_read_words(5)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(4, 6) then
        pathsright_stay_choices(4, 7) := (not (pathsright_read_words(5)(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(4, 7) := (not (pathsright_read_words(5)(6) = '1')) and is_set(pathsright_fresh_here, 6);
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
      if (to_integer(pathsright_read_words(5)(6 downto 0)) - to_integer(pathsright_read_words(1)(6 downto 0))) < 0 then
        pathsright_stay_choice_16(4) := to_integer(pathsright_read_words(5)(6 downto 0));
      else
        pathsright_stay_choice_16(4) := to_integer(pathsright_read_words(1)(6 downto 0));
      end if;
      for i in 5 to 6 loop
        pathsright_stay_values(i) := pathsright_read_words(5)(7 * i - 28) = '1';
        if pathsright_stay_values(i) then
          pathsright_stay_choice(i) := not pathsright_stay_value(0);
        else
          pathsright_stay_choice(i) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(5)(7 * i - 27) = '1' then
          pathsright_stay_choices(i, 2) := pathsright_stay_values(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 2) := pathsright_stay_choice(i);
        end if;
        if pathsright_stay_choices(i, 2) then
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(5)(7 * i - 26) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(5)(7 * i - 26) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(5)(7 * i + j - 28) = '1')) or
              pathsright_stay_0_values(j);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(5)(7 * i + j - 28) = '1')) and
              pathsright_stay_0_values(j);
          end if;
        end loop;
        if pathsright_stay_choices(i, 5) then
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(5)(7 * i - 23) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(5)(7 * i - 23) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 6) then
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(5)(7 * i - 22) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(5)(7 * i - 22) = '1')) and
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
        pathsright_stay_values_from_5(i, 3) := to_integer(pathsright_read_words(5)(7 * i - 22 downto 7 * i - 28));
        pathsright_stay_values_from_5(i, 4) := to_integer(pathsright_read_words(1)(7 * i - 22 downto 7 * i - 28));
        if (pathsright_stay_values_from_5(i, 3) - pathsright_stay_values_from_5(i, 4)) < 0 then
          pathsright_stay_choice_16(i) := pathsright_stay_values_from_5(i, 3);
        else
          pathsright_stay_choice_16(i) := pathsright_stay_values_from_5(i, 4);
        end if;
      end loop;
      pathsright_stay_values(7) := pathsright_read_words(5)(21) = '1';
      if pathsright_stay_values(7) then
        pathsright_stay_choice(7) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(7) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(5)(22) = '1' then
        pathsright_stay_choices(7, 2) := pathsright_stay_values(7) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(7, 2) := pathsright_stay_choice(7);
      end if;
      if pathsright_stay_choices(7, 2) then
        pathsright_stay_choices(7, 3) := (not (pathsright_read_words(5)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(7, 3) := (not (pathsright_read_words(5)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(7, i) then
          pathsright_stay_choices(7, i + 1) := (not (pathsright_read_words(5)(i + 21) = '1')) or
            pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(7, i + 1) := (not (pathsright_read_words(5)(i + 21) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(7, 5) then
        pathsright_stay_choices(7, 6) := (not (pathsright_read_words(5)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(7, 6) := (not (pathsright_read_words(5)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(7, 6) then
        pathsright_stay_choices(7, 7) := (not (pathsright_read_words(5)(27) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(7, 7) := (not (pathsright_read_words(5)(27) = '1')) and is_set(pathsright_fresh_here,
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
      if (to_integer(pathsright_read_words(5)(27 downto 21)) - to_integer(pathsright_read_words(1)(27 downto 21))) < 0
        then
        pathsright_stay_choice_16(7) := to_integer(pathsright_read_words(5)(27 downto 21));
      else
        pathsright_stay_choice_16(7) := to_integer(pathsright_read_words(1)(27 downto 21));
      end if;
      if pathsright_read_words(6)(0) = '1' then
        pathsright_stay_choice(8) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(6)(1) = '1' then
        pathsright_stay_choices(8, 2) := (pathsright_read_words(6)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(8, 2) := pathsright_stay_choice(8);
      end if;
      if pathsright_stay_choices(8, 2) then
        pathsright_stay_choices(8, 3) := (not (pathsright_read_words(6)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(8, 3) := (not (pathsright_read_words(6)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(8, i) then
          pathsright_stay_choices(8, i + 1) := (not (pathsright_read_words(6)(i) = '1')) or pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(8, i + 1) := (not (pathsright_read_words(6)(i) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(8, 5) then
        pathsright_stay_choices(8, 6) := (not (pathsright_read_words(6)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(8, 6) := (not (pathsright_read_words(6)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(8, 6) then
        pathsright_stay_choices(8, 7) := (not (pathsright_read_words(6)(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(8, 7) := (not (pathsright_read_words(6)(6) = '1')) and is_set(pathsright_fresh_here, 6);
      end if;
      if pathsright_read_words(2)(0) = '1' then
        pathsright_stay_choices(8, 8) := not pathsright_stay_value(0);
      else
        pathsright_stay_choices(8, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(2)(1) = '1' then
        pathsright_stay_choices(8, 9) := (pathsright_read_words(2)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(8, 9) := pathsright_stay_choices(8, 8);
      end if;
      if pathsright_stay_choices(8, 9) then
        pathsright_stay_choices(8, 10) := (not (pathsright_read_words(2)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(8, 10) := (not (pathsright_read_words(2)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsright_stay_choices(8, i) then
          pathsright_stay_choices(8, i + 1) := (not (pathsright_read_words(2)(i - 7) = '1')) or
            pathsright_stay_0_values(i - 7);
        else
          pathsright_stay_choices(8, i + 1) := (not (pathsright_read_words(2)(i - 7) = '1')) and
            pathsright_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsright_stay_choices(8, 12) then
        pathsright_stay_choices(8, 13) := (not (pathsright_read_words(2)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(8, 13) := (not (pathsright_read_words(2)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(8, 13) then
        pathsright_stay_choices(8, 14) := (not (pathsright_read_words(2)(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(8, 14) := (not (pathsright_read_words(2)(6) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(8, 7) then
        pathsright_stay_choices(8, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(8, 15) := pathsright_stay_choices(8, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words(6)(6 downto 0)) - to_integer(pathsright_read_words(2)(6 downto 0))) < 0 then
        pathsright_stay_choice_16(8) := to_integer(pathsright_read_words(6)(6 downto 0));
      else
        pathsright_stay_choice_16(8) := to_integer(pathsright_read_words(2)(6 downto 0));
      end if;
      for i in 9 to 10 loop
        pathsright_stay_values_from_9(i) := pathsright_read_words(6)(7 * i - 56) = '1';
        if pathsright_stay_values_from_9(i) then
          pathsright_stay_choice(i) := not pathsright_stay_value(0);
        else
          pathsright_stay_choice(i) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(6)(7 * i - 55) = '1' then
          pathsright_stay_choices(i, 2) := pathsright_stay_values_from_9(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 2) := pathsright_stay_choice(i);
        end if;
        if pathsright_stay_choices(i, 2) then
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(6)(7 * i - 54) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(6)(7 * i - 54) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(6)(7 * i + j - 56) = '1')) or
              pathsright_stay_0_values(j);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(6)(7 * i + j - 56) = '1')) and
              pathsright_stay_0_values(j);
          end if;
        end loop;
        if pathsright_stay_choices(i, 5) then
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(6)(7 * i - 51) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(6)(7 * i - 51) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 6) then
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(6)(7 * i - 50) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(6)(7 * i - 50) = '1')) and
            is_set(pathsright_fresh_here, 6);
        end if;
        pathsright_stay_value_2s_from_9(i) := pathsright_read_words(2)(7 * i - 56) = '1';
        if pathsright_stay_value_2s_from_9(i) then
          pathsright_stay_choices(i, 8) := not pathsright_stay_value(0);
        else
          pathsright_stay_choices(i, 8) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(2)(7 * i - 55) = '1' then
          pathsright_stay_choices(i, 9) := pathsright_stay_value_2s_from_9(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 9) := pathsright_stay_choices(i, 8);
        end if;
        if pathsright_stay_choices(i, 9) then
          pathsright_stay_choices(i, 10) := (not (pathsright_read_words(2)(7 * i - 54) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 10) := (not (pathsright_read_words(2)(7 * i - 54) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 10 to 11 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(2)(7 * i + j - 63) = '1')) or
              pathsright_stay_0_values(j - 7);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(2)(7 * i + j - 63) = '1')) and
              pathsright_stay_0_values(j - 7);
          end if;
        end loop;
        if pathsright_stay_choices(i, 12) then
          pathsright_stay_choices(i, 13) := (not (pathsright_read_words(2)(7 * i - 51) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 13) := (not (pathsright_read_words(2)(7 * i - 51) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 13) then
          pathsright_stay_choices(i, 14) := (not (pathsright_read_words(2)(7 * i - 50) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 14) := (not (pathsright_read_words(2)(7 * i - 50) = '1')) and
            is_set(pathsright_fresh_here, 6);
        end if;
        if pathsright_stay_choices(i, 7) then
          pathsright_stay_choices(i, 15) := not pathsleft_first;
        else
          pathsright_stay_choices(i, 15) := pathsright_stay_choices(i, 14) and (not pathsleft_first);
        end if;
        pathsright_stay_values_2(i, 3) := to_integer(pathsright_read_words(6)(7 * i - 50 downto 7 * i - 56));
        pathsright_stay_values_2(i, 4) := to_integer(pathsright_read_words(2)(7 * i - 50 downto 7 * i - 56));
        if (pathsright_stay_values_2(i, 3) - pathsright_stay_values_2(i, 4)) < 0 then
          pathsright_stay_choice_16(i) := pathsright_stay_values_2(i, 3);
        else
          pathsright_stay_choice_16(i) := pathsright_stay_values_2(i, 4);
        end if;
      end loop;
      pathsright_stay_values_from_9(11) := pathsright_read_words(6)(21) = '1';
      if pathsright_stay_values_from_9(11) then
        pathsright_stay_choice(11) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(11) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(6)(22) = '1' then
        pathsright_stay_choices(11, 2) := pathsright_stay_values_from_9(11) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(11, 2) := pathsright_stay_choice(11);
      end if;
      if pathsright_stay_choices(11, 2) then
        pathsright_stay_choices(11, 3) := (not (pathsright_read_words(6)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(11, 3) := (not (pathsright_read_words(6)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(11, i) then
          pathsright_stay_choices(11, i + 1) := (not (pathsright_read_words(6)(i + 21) = '1')) or
            pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(11, i + 1) := (not (pathsright_read_words(6)(i + 21) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(11, 5) then
        pathsright_stay_choices(11, 6) := (not (pathsright_read_words(6)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(11, 6) := (not (pathsright_read_words(6)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(11, 6) then
        pathsright_stay_choices(11, 7) := (not (pathsright_read_words(6)(27) = '1')) or is_set(pathsright_fresh_here,
          6);
      else
        pathsright_stay_choices(11, 7) := (not (pathsright_read_words(6)(27) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      pathsright_stay_value_2s_from_9(11) := pathsright_read_words(2)(21) = '1';
      if pathsright_stay_value_2s_from_9(11) then
        pathsright_stay_choices(11, 8) := not pathsright_stay_value(0);
      else
        pathsright_stay_choices(11, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(2)(22) = '1' then
        pathsright_stay_choices(11, 9) := pathsright_stay_value_2s_from_9(11) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(11, 9) := pathsright_stay_choices(11, 8);
      end if;
      if pathsright_stay_choices(11, 9) then
        pathsright_stay_choices(11, 10) := (not (pathsright_read_words(2)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(11, 10) := (not (pathsright_read_words(2)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsright_stay_choices(11, i) then
          pathsright_stay_choices(11, i + 1) := (not (pathsright_read_words(2)(i + 14) = '1')) or
            pathsright_stay_0_values(i - 7);
        else
          pathsright_stay_choices(11, i + 1) := (not (pathsright_read_words(2)(i + 14) = '1')) and
            pathsright_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsright_stay_choices(11, 12) then
        pathsright_stay_choices(11, 13) := (not (pathsright_read_words(2)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(11, 13) := (not (pathsright_read_words(2)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(11, 13) then
        pathsright_stay_choices(11, 14) := (not (pathsright_read_words(2)(27) = '1')) or is_set(pathsright_fresh_here,
          6);
      else
        pathsright_stay_choices(11, 14) := (not (pathsright_read_words(2)(27) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(11, 7) then
        pathsright_stay_choices(11, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(11, 15) := pathsright_stay_choices(11, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words(6)(27 downto 21)) - to_integer(pathsright_read_words(2)(27 downto 21))) < 0
        then
        pathsright_stay_choice_16(11) := to_integer(pathsright_read_words(6)(27 downto 21));
      else
        pathsright_stay_choice_16(11) := to_integer(pathsright_read_words(2)(27 downto 21));
      end if;
      if pathsright_read_words(7)(0) = '1' then
        pathsright_stay_choice(12) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(12) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(7)(1) = '1' then
        pathsright_stay_choices(12, 2) := (pathsright_read_words(7)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(12, 2) := pathsright_stay_choice(12);
      end if;
      if pathsright_stay_choices(12, 2) then
        pathsright_stay_choices(12, 3) := (not (pathsright_read_words(7)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(12, 3) := (not (pathsright_read_words(7)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(12, i) then
          pathsright_stay_choices(12, i + 1) := (not (pathsright_read_words(7)(i) = '1')) or
            pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(12, i + 1) := (not (pathsright_read_words(7)(i) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(12, 5) then
        pathsright_stay_choices(12, 6) := (not (pathsright_read_words(7)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(12, 6) := (not (pathsright_read_words(7)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(12, 6) then
        pathsright_stay_choices(12, 7) := (not (pathsright_read_words(7)(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(12, 7) := (not (pathsright_read_words(7)(6) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_read_words(3)(0) = '1' then
        pathsright_stay_choices(12, 8) := not pathsright_stay_value(0);
      else
        pathsright_stay_choices(12, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(3)(1) = '1' then
        pathsright_stay_choices(12, 9) := (pathsright_read_words(3)(0) = '1') or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(12, 9) := pathsright_stay_choices(12, 8);
      end if;
      if pathsright_stay_choices(12, 9) then
        pathsright_stay_choices(12, 10) := (not (pathsright_read_words(3)(2) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(12, 10) := (not (pathsright_read_words(3)(2) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsright_stay_choices(12, i) then
          pathsright_stay_choices(12, i + 1) := (not (pathsright_read_words(3)(i - 7) = '1')) or
            pathsright_stay_0_values(i - 7);
        else
          pathsright_stay_choices(12, i + 1) := (not (pathsright_read_words(3)(i - 7) = '1')) and
            pathsright_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsright_stay_choices(12, 12) then
        pathsright_stay_choices(12, 13) := (not (pathsright_read_words(3)(5) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(12, 13) := (not (pathsright_read_words(3)(5) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(12, 13) then
        pathsright_stay_choices(12, 14) := (not (pathsright_read_words(3)(6) = '1')) or is_set(pathsright_fresh_here,
          6);
      else
        pathsright_stay_choices(12, 14) := (not (pathsright_read_words(3)(6) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(12, 7) then
        pathsright_stay_choices(12, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(12, 15) := pathsright_stay_choices(12, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words(7)(6 downto 0)) - to_integer(pathsright_read_words(3)(6 downto 0))) < 0 then
        pathsright_stay_choice_16(12) := to_integer(pathsright_read_words(7)(6 downto 0));
      else
        pathsright_stay_choice_16(12) := to_integer(pathsright_read_words(3)(6 downto 0));
      end if;
      for i in 13 to 14 loop
        pathsright_stay_values_from_13(i) := pathsright_read_words(7)(7 * i - 84) = '1';
        if pathsright_stay_values_from_13(i) then
          pathsright_stay_choice(i) := not pathsright_stay_value(0);
        else
          pathsright_stay_choice(i) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(7)(7 * i - 83) = '1' then
          pathsright_stay_choices(i, 2) := pathsright_stay_values_from_13(i) or (not pathsright_stay_value(0)) or (not
            is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 2) := pathsright_stay_choice(i);
        end if;
        if pathsright_stay_choices(i, 2) then
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(7)(7 * i - 82) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 3) := (not (pathsright_read_words(7)(7 * i - 82) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 3 to 4 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(7)(7 * i + j - 84) = '1')) or
              pathsright_stay_0_values(j);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(7)(7 * i + j - 84) = '1')) and
              pathsright_stay_0_values(j);
          end if;
        end loop;
        if pathsright_stay_choices(i, 5) then
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(7)(7 * i - 79) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 6) := (not (pathsright_read_words(7)(7 * i - 79) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 6) then
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(7)(7 * i - 78) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 7) := (not (pathsright_read_words(7)(7 * i - 78) = '1')) and
            is_set(pathsright_fresh_here, 6);
        end if;
        pathsright_stay_value_2s_from_13(i) := pathsright_read_words(3)(7 * i - 84) = '1';
        if pathsright_stay_value_2s_from_13(i) then
          pathsright_stay_choices(i, 8) := not pathsright_stay_value(0);
        else
          pathsright_stay_choices(i, 8) := pathsright_stay_0_is_equal;
        end if;
        if pathsright_read_words(3)(7 * i - 83) = '1' then
          pathsright_stay_choices(i, 9) := pathsright_stay_value_2s_from_13(i) or (not pathsright_stay_value(0)) or
            (not is_set(pathsright_fresh_here, 0));
        else
          pathsright_stay_choices(i, 9) := pathsright_stay_choices(i, 8);
        end if;
        if pathsright_stay_choices(i, 9) then
          pathsright_stay_choices(i, 10) := (not (pathsright_read_words(3)(7 * i - 82) = '1')) and
            pathsright_stay_value_2(0);
        else
          pathsright_stay_choices(i, 10) := (not (pathsright_read_words(3)(7 * i - 82) = '1')) or
            pathsright_stay_value_2(0);
        end if;
        for j in 10 to 11 loop
          if pathsright_stay_choices(i, j) then
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(3)(7 * i + j - 91) = '1')) or
              pathsright_stay_0_values(j - 7);
          else
            pathsright_stay_choices(i, j + 1) := (not (pathsright_read_words(3)(7 * i + j - 91) = '1')) and
              pathsright_stay_0_values(j - 7);
          end if;
        end loop;
        if pathsright_stay_choices(i, 12) then
          pathsright_stay_choices(i, 13) := (not (pathsright_read_words(3)(7 * i - 79) = '1')) or
            pathsright_stay_0_values_from_5(5);
        else
          pathsright_stay_choices(i, 13) := (not (pathsright_read_words(3)(7 * i - 79) = '1')) and
            pathsright_stay_0_values_from_5(5);
        end if;
        if pathsright_stay_choices(i, 13) then
          pathsright_stay_choices(i, 14) := (not (pathsright_read_words(3)(7 * i - 78) = '1')) or
            is_set(pathsright_fresh_here, 6);
        else
          pathsright_stay_choices(i, 14) := (not (pathsright_read_words(3)(7 * i - 78) = '1')) and
            is_set(pathsright_fresh_here, 6);
        end if;
        if pathsright_stay_choices(i, 7) then
          pathsright_stay_choices(i, 15) := not pathsleft_first;
        else
          pathsright_stay_choices(i, 15) := pathsright_stay_choices(i, 14) and (not pathsleft_first);
        end if;
        pathsright_stay_values_3(i, 3) := to_integer(pathsright_read_words(7)(7 * i - 78 downto 7 * i - 84));
        pathsright_stay_values_3(i, 4) := to_integer(pathsright_read_words(3)(7 * i - 78 downto 7 * i - 84));
        if (pathsright_stay_values_3(i, 3) - pathsright_stay_values_3(i, 4)) < 0 then
          pathsright_stay_choice_16(i) := pathsright_stay_values_3(i, 3);
        else
          pathsright_stay_choice_16(i) := pathsright_stay_values_3(i, 4);
        end if;
      end loop;
      pathsright_stay_values_from_13(15) := pathsright_read_words(7)(21) = '1';
      if pathsright_stay_values_from_13(15) then
        pathsright_stay_choice(15) := not pathsright_stay_value(0);
      else
        pathsright_stay_choice(15) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(7)(22) = '1' then
        pathsright_stay_choices(15, 2) := pathsright_stay_values_from_13(15) or (not pathsright_stay_value(0)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(15, 2) := pathsright_stay_choice(15);
      end if;
      if pathsright_stay_choices(15, 2) then
        pathsright_stay_choices(15, 3) := (not (pathsright_read_words(7)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(15, 3) := (not (pathsright_read_words(7)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 3 to 4 loop
        if pathsright_stay_choices(15, i) then
          pathsright_stay_choices(15, i + 1) := (not (pathsright_read_words(7)(i + 21) = '1')) or
            pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(15, i + 1) := (not (pathsright_read_words(7)(i + 21) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(15, 5) then
        pathsright_stay_choices(15, 6) := (not (pathsright_read_words(7)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(15, 6) := (not (pathsright_read_words(7)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(15, 6) then
        pathsright_stay_choices(15, 7) := (not (pathsright_read_words(7)(27) = '1')) or is_set(pathsright_fresh_here,
          6);
      else
        pathsright_stay_choices(15, 7) := (not (pathsright_read_words(7)(27) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      pathsright_stay_value_2s_from_13(15) := pathsright_read_words(3)(21) = '1';
      if pathsright_stay_value_2s_from_13(15) then
        pathsright_stay_choices(15, 8) := not pathsright_stay_value(0);
      else
        pathsright_stay_choices(15, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words(3)(22) = '1' then
        pathsright_stay_choices(15, 9) := pathsright_stay_value_2s_from_13(15) or (not pathsright_stay_value(0)) or
          (not is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(15, 9) := pathsright_stay_choices(15, 8);
      end if;
      if pathsright_stay_choices(15, 9) then
        pathsright_stay_choices(15, 10) := (not (pathsright_read_words(3)(23) = '1')) and pathsright_stay_value_2(0);
      else
        pathsright_stay_choices(15, 10) := (not (pathsright_read_words(3)(23) = '1')) or pathsright_stay_value_2(0);
      end if;
      for i in 10 to 11 loop
        if pathsright_stay_choices(15, i) then
          pathsright_stay_choices(15, i + 1) := (not (pathsright_read_words(3)(i + 14) = '1')) or
            pathsright_stay_0_values(i - 7);
        else
          pathsright_stay_choices(15, i + 1) := (not (pathsright_read_words(3)(i + 14) = '1')) and
            pathsright_stay_0_values(i - 7);
        end if;
      end loop;
      if pathsright_stay_choices(15, 12) then
        pathsright_stay_choices(15, 13) := (not (pathsright_read_words(3)(26) = '1')) or
          pathsright_stay_0_values_from_5(5);
      else
        pathsright_stay_choices(15, 13) := (not (pathsright_read_words(3)(26) = '1')) and
          pathsright_stay_0_values_from_5(5);
      end if;
      if pathsright_stay_choices(15, 13) then
        pathsright_stay_choices(15, 14) := (not (pathsright_read_words(3)(27) = '1')) or is_set(pathsright_fresh_here,
          6);
      else
        pathsright_stay_choices(15, 14) := (not (pathsright_read_words(3)(27) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(15, 7) then
        pathsright_stay_choices(15, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(15, 15) := pathsright_stay_choices(15, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words(7)(27 downto 21)) - to_integer(pathsright_read_words(3)(27 downto 21))) < 0
        then
        pathsright_stay_choice_16(15) := to_integer(pathsright_read_words(7)(27 downto 21));
      else
        pathsright_stay_choice_16(15) := to_integer(pathsright_read_words(3)(27 downto 21));
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
      for i in 1 to 2 loop
        if (to_integer(pathsright_read_words(i)(48 - 21 * i downto 42 - 21 * i)) - pathsright_stay_values_from_5(i + 4,
          4)) < 0 then
          pathsright_step_choice(i + 5) := to_integer(pathsright_read_words(i)(48 - 21 * i downto 42 - 21 * i));
        else
          pathsright_step_choice(i + 5) := pathsright_stay_values_from_5(i + 4, 4);
        end if;
      end loop;
      for i in 9 to 10 loop
        if (pathsright_stay_values_2(i, 4) - to_integer(pathsright_read_words(i - 8)(216 - 21 * i downto 210 - 21 *
          i))) < 0 then
          pathsright_step_choice(i - 1) := pathsright_stay_values_2(i, 4);
        else
          pathsright_step_choice(i - 1) := to_integer(pathsright_read_words(i - 8)(216 - 21 * i downto 210 - 21 * i));
        end if;
      end loop;
      for i in 2 to 3 loop
        if (to_integer(pathsright_read_words(i)(69 - 21 * i downto 63 - 21 * i)) - pathsright_stay_values_2(i + 7, 4))
          < 0 then
          pathsright_step_choice(i + 8) := to_integer(pathsright_read_words(i)(69 - 21 * i downto 63 - 21 * i));
        else
          pathsright_step_choice(i + 8) := pathsright_stay_values_2(i + 7, 4);
        end if;
      end loop;
      for i in 13 to 14 loop
        if (pathsright_stay_values_3(i, 4) - to_integer(pathsright_read_words(i - 11)(300 - 21 * i downto 294 - 21 *
          i))) < 0 then
          pathsright_step_choice(i - 1) := pathsright_stay_values_3(i, 4);
        else
          pathsright_step_choice(i - 1) := to_integer(pathsright_read_words(i - 11)(300 - 21 * i downto 294 - 21 * i));
        end if;
      end loop;
      if (to_integer(pathsright_read_words(3)(27 downto 21)) - pathsright_stay_values_3(13, 4)) < 0 then
        pathsright_step_choice(14) := to_integer(pathsright_read_words(3)(27 downto 21));
      else
        pathsright_step_choice(14) := pathsright_stay_values_3(13, 4);
      end if;
      if pathsleft_is_last then
        pathsright_step_choice(15) := pathsright_stay_values_3(14, 4);
      else
        pathsright_step_choice(15) := to_integer(pathsright_read_neighbour_0);
      end if;
      if (pathsright_step_choice(15) - pathsright_stay_values_3(14, 4)) < 0 then
        pathsright_step_15_choice_2 := pathsright_step_choice(15);
      else
        pathsright_step_15_choice_2 := pathsright_stay_values_3(14, 4);
      end if;
      pathsright_stay_change_1_value := (pathsturn_cost_memory_ready_words(0) / 8) mod 8;
      pathsright_stay_change_2_sum := ((pathsturn_cost_memory_ready_words(1) mod 2) * 4) +
        (pathsturn_cost_memory_ready_words(0) / 64);
      pathsright_stay_change_value(3) := (pathsturn_cost_memory_ready_words(1) / 2) mod 8;
      pathsright_stay_change_value(4) := (pathsturn_cost_memory_ready_words(1) / 16) mod 8;
      pathsright_stay_change_5_sum := ((pathsturn_cost_memory_ready_words(2) mod 4) * 2) +
        (pathsturn_cost_memory_ready_words(1) / 128);
      pathsright_stay_change_6_value := (pathsturn_cost_memory_ready_words(2) / 4) mod 8;
      pathsright_stay_change_9_value := (pathsturn_cost_memory_ready_words(3) / 8) mod 8;
      pathsright_stay_change_10_sum := ((pathsturn_cost_memory_ready_words(4) mod 2) * 4) +
        (pathsturn_cost_memory_ready_words(3) / 64);
      pathsright_stay_change_values(11) := (pathsturn_cost_memory_ready_words(4) / 2) mod 8;
      pathsright_stay_change_values(12) := (pathsturn_cost_memory_ready_words(4) / 16) mod 8;
      pathsright_stay_change_13_sum := ((pathsturn_cost_memory_ready_words(5) mod 4) * 2) +
        (pathsturn_cost_memory_ready_words(4) / 128);
      pathsright_stay_change_14_value := (pathsturn_cost_memory_ready_words(5) / 4) mod 8;
      if line_comes(27) then
        pathsright_low_0_choice := 127;
      else
        pathsright_low_0_choice := pathsright_low_0;
      end if;
      pathsright_fresh_past_oldest <= pathsright_fresh_past_fours(7);
      pathsright_lost <= is_set(pathsright_fresh_known, 6);
      pathsright_short_of <= (((pathsright_fresh_known mod 64) + pathsright_room) / 64) = 1;
      pathsright_missing <= (pathsright_fresh_known + pathsright_room) mod 64;
      pathsright_below <= (0 - pathsright_fresh_known) mod 64;
      pathsright_lower_neighbour <= to_integer(pathsright_read_words(3)(27 downto 21));
      pathsright_stay_change(0) <= ((pathsturn_cost_memory_ready_words(0) mod 8) - pathsright_g) mod 128;
      pathsright_stay_change(1) <= (pathsright_stay_change_1_value - pathsright_g) mod 128;
      pathsright_stay_change(2) <= (pathsright_stay_change_2_sum - pathsright_g) mod 128;
      pathsright_stay_change(3) <= (pathsright_stay_change_value(3) - pathsright_g) mod 128;
      pathsright_stay_change(4) <= (pathsright_stay_change_value(4) - pathsright_g) mod 128;
      pathsright_stay_change(5) <= (pathsright_stay_change_5_sum - pathsright_g) mod 128;
      pathsright_stay_change(6) <= (pathsright_stay_change_6_value - pathsright_g) mod 128;
      pathsright_stay_change(7) <= ((pathsturn_cost_memory_ready_words(2) / 32) - pathsright_g) mod 128;
      pathsright_stay_change(8) <= ((pathsturn_cost_memory_ready_words(3) mod 8) - pathsright_g) mod 128;
      pathsright_stay_change(9) <= (pathsright_stay_change_9_value - pathsright_g) mod 128;
      pathsright_stay_change(10) <= (pathsright_stay_change_10_sum - pathsright_g) mod 128;
      pathsright_stay_change(11) <= (pathsright_stay_change_values(11) - pathsright_g) mod 128;
      pathsright_stay_change(12) <= (pathsright_stay_change_values(12) - pathsright_g) mod 128;
      pathsright_stay_change(13) <= (pathsright_stay_change_13_sum - pathsright_g) mod 128;
      pathsright_stay_change(14) <= (pathsright_stay_change_14_value - pathsright_g) mod 128;
      pathsright_stay_change(15) <= ((pathsturn_cost_memory_ready_words(5) / 32) - pathsright_g) mod 128;
      pathsright_step_change(0) <= ((pathsturn_cost_memory_ready_words(0) mod 8) - pathsright_g_less) mod 128;
      pathsright_step_change(1) <= (pathsright_stay_change_1_value - pathsright_g_less) mod 128;
      pathsright_step_change(2) <= (pathsright_stay_change_2_sum - pathsright_g_less) mod 128;
      pathsright_step_change(3) <= (pathsright_stay_change_value(3) - pathsright_g_less) mod 128;
      pathsright_step_change(4) <= (pathsright_stay_change_value(4) - pathsright_g_less) mod 128;
      pathsright_step_change(5) <= (pathsright_stay_change_5_sum - pathsright_g_less) mod 128;
      pathsright_step_change(6) <= (pathsright_stay_change_6_value - pathsright_g_less) mod 128;
      pathsright_step_change(7) <= ((pathsturn_cost_memory_ready_words(2) / 32) - pathsright_g_less) mod 128;
      pathsright_step_change(8) <= ((pathsturn_cost_memory_ready_words(3) mod 8) - pathsright_g_less) mod 128;
      pathsright_step_change(9) <= (pathsright_stay_change_9_value - pathsright_g_less) mod 128;
      pathsright_step_change(10) <= (pathsright_stay_change_10_sum - pathsright_g_less) mod 128;
      pathsright_step_change(11) <= (pathsright_stay_change_values(11) - pathsright_g_less) mod 128;
      pathsright_step_change(12) <= (pathsright_stay_change_values(12) - pathsright_g_less) mod 128;
      pathsright_step_change(13) <= (pathsright_stay_change_13_sum - pathsright_g_less) mod 128;
      pathsright_step_change(14) <= (pathsright_stay_change_14_value - pathsright_g_less) mod 128;
      pathsright_step_change(15) <= ((pathsturn_cost_memory_ready_words(5) / 32) - pathsright_g_less) mod 128;
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
      for i in 0 to 15 loop
        if pathsright_stay_choices(i, 15) then
          pathsright_stay(i) <= pathsright_stay_choice_16(i);
        else
          pathsright_stay(i) <= pathsright_fresh_here;
        end if;
      end loop;
      if pathsleft_first then
        for i in 0 to 15 loop
          pathsright_step(i) <= 64;
        end loop;
      else
        pathsright_step(0) <= pathsright_step_0_choice_2;
        for i in 1 to 14 loop
          pathsright_step(i) <= pathsright_step_choice(i);
        end loop;
        pathsright_step(15) <= pathsright_step_15_choice_2;
      end if;
      for i in 0 to 7 loop
        if (pathsright_cost(2 * i + 1) - pathsright_cost(2 * i)) < 0 then
          pathsright_tree_smallest(i) <= pathsright_cost(2 * i + 1);
        else
          pathsright_tree_smallest(i) <= pathsright_cost(2 * i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if (pathsright_tree_smallest(2 * i + 1) - pathsright_tree_smallest(2 * i)) < 0 then
          pathsright_tree_next_smallest(i) <= pathsright_tree_smallest(2 * i + 1);
        else
          pathsright_tree_next_smallest(i) <= pathsright_tree_smallest(2 * i);
        end if;
      end loop;
      for i in 0 to 1 loop
        if (pathsright_tree_next_smallest(2 * i + 1) - pathsright_tree_next_smallest(2 * i)) < 0 then
          pathsright_tree_next_next_smallest(i) <= pathsright_tree_next_smallest(2 * i + 1);
        else
          pathsright_tree_next_next_smallest(i) <= pathsright_tree_next_smallest(2 * i);
        end if;
      end loop;
      if (pathsright_tree_next_next_smallest(1) - pathsright_tree_next_next_smallest(0)) < 0 then
        pathsright_tree_next_next_next_smallest_0 <= pathsright_tree_next_next_smallest(1);
      else
        pathsright_tree_next_next_next_smallest_0 <= pathsright_tree_next_next_smallest(0);
      end if;
      if (pathsright_tree_next_next_next_smallest_0 - pathsright_low_0_choice) < 0 then
        pathsright_low_0 <= pathsright_tree_next_next_next_smallest_0;
      else
        pathsright_low_0 <= pathsright_low_0_choice;
      end if;
      if line_starts_phases(20) then
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
      if line_starts_phases(18) then
        if line_places_shown_first_column(2) then
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
      if line_starts_phases(19) then
        pathsright_q_now <= pathsright_q;
        pathsright_q_less <= (pathsright_q + 121) mod 128;
        if line_places_shown_first_column(2) then
          pathsright_room <= 0;
          for i in 1 to 9 loop
            pathsright_start_cost(i) <= 0;
          end loop;
        else
          pathsright_room <= (pathsright_room_left + pathsright_start_cost(9)) mod 64;
          pathsright_start_cost(1) <= pathsright_q_now;
          for i in 2 to 9 loop
            pathsright_start_cost(i) <= pathsright_start_cost(i - 1);
          end loop;
        end if;
      end if;
      if pathsleft_cost_0_any then
        for i in 0 to 15 loop
          pathsright_cost(i) <= (pathsright_stay(i) + pathsright_stay_change(i)) mod 128;
        end loop;
        for i in 0 to 15 loop
          pathsright_arrived(i) <= (pathsright_step(i) + pathsright_step_change(i)) mod 128;
        end loop;
      end if;
      -- winnersmask
      winnersmask_column_sum := winnersmask_column + 1;
      if line_places_first_column(2) then
        winnersmask_column_choice := 0;
      else
        winnersmask_column_choice := winnersmask_column_sum mod 2048;
      end if;
      if line_comes(22) then
        winnersmask_column <= winnersmask_column_choice;
      end if;
      if line_places_first_column(2) then
        winnersmask_partner_choice := 0;
      else
        winnersmask_partner_choice := winnersmask_column_sum;
      end if;
      winnersmask_inside(0) <= (((((winnersmask_partner / 2048) + 31) mod 32) * 2048) + (winnersmask_partner mod 2048))
        < 1240;
      winnersmask_inside(1) <= (winnersmask_partner >= 2047) and (winnersmask_partner < 3287);
      winnersmask_inside(2) <= (((((winnersmask_partner / 2) + 31745) mod 32768) * 2) + (winnersmask_partner mod 2)) <
        1240;
      winnersmask_inside(3) <= (winnersmask_partner >= 2045) and (winnersmask_partner < 3285);
      winnersmask_inside(4) <= (((((winnersmask_partner / 4) + 15873) mod 16384) * 4) + (winnersmask_partner mod 4)) <
        1240;
      winnersmask_inside(5) <= (winnersmask_partner >= 2043) and (winnersmask_partner < 3283);
      winnersmask_inside(6) <= (((((winnersmask_partner / 2) + 31747) mod 32768) * 2) + (winnersmask_partner mod 2)) <
        1240;
      winnersmask_inside(7) <= (winnersmask_partner >= 2041) and (winnersmask_partner < 3281);
      winnersmask_inside(8) <= (((((winnersmask_partner / 8) + 7937) mod 8192) * 8) + (winnersmask_partner mod 8)) <
        1240;
      winnersmask_inside(9) <= (winnersmask_partner >= 2039) and (winnersmask_partner < 3279);
      winnersmask_inside(10) <= (((((winnersmask_partner / 2) + 31749) mod 32768) * 2) + (winnersmask_partner mod 2)) <
        1240;
      winnersmask_inside(11) <= (winnersmask_partner >= 2037) and (winnersmask_partner < 3277);
      winnersmask_inside(12) <= (((((winnersmask_partner / 4) + 15875) mod 16384) * 4) + (winnersmask_partner mod 4)) <
        1240;
      winnersmask_inside(13) <= (winnersmask_partner >= 2035) and (winnersmask_partner < 3275);
      winnersmask_inside(14) <= (((((winnersmask_partner / 2) + 31751) mod 32768) * 2) + (winnersmask_partner mod 2)) <
        1240;
      winnersmask_inside(15) <= (winnersmask_partner >= 2033) and (winnersmask_partner < 3273);
      if line_comes(22) then
        winnersmask_partner <= (((winnersmask_partner_choice / 2048) + 1) * 2048) + winnersmask_column_choice;
      else
        winnersmask_partner <= ((((winnersmask_partner / 16) + 1) mod 512) * 16) + (winnersmask_partner mod 16);
      end if;
      -- winnerswinner1
      for i in 0 to 7 loop
        winnerswinner1_best_cost_0_sum(i) := as_number(winnersmask_inside(2 * i + 1)) + 255;
        winnerswinner1_best_cost_0_any(i) := to_integer(((to_unsigned(paths_sum(2 * i + 1), 8)) or
          (to_unsigned((winnerswinner1_best_cost_0_sum(i) mod 256), 8))));
        winnerswinner1_best_cost_0_sum_2(i) := as_number(winnersmask_inside(2 * i)) + 255;
        winnerswinner1_best_cost_0_any_2(i) := to_integer(((to_unsigned(paths_sum(2 * i), 8)) or
          (to_unsigned((winnerswinner1_best_cost_0_sum_2(i) mod 256), 8))));
      end loop;
      if is_set(winnerswinner1_best_cost_0_sum_2(0), 0) then
        winnerswinner1_best_index_0_choice(0) := (not is_set(winnerswinner1_best_cost_0_sum(0), 0)) and (not
          is_set(paths_sum(1), 0));
      else
        winnerswinner1_best_index_0_choice(0) := is_set(paths_sum(0), 0) and (not
          is_set(winnerswinner1_best_cost_0_sum(0), 0)) and (not is_set(paths_sum(1), 0));
      end if;
      winnerswinner1_best_index_0_value(0) := (((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 2) mod 2) = 1;
      winnerswinner1_best_index_0_values(0, 2) := is_set(paths_sum(0), 1);
      if (not ((((winnerswinner1_best_cost_0_sum(0) mod 256) / 2) mod 2) = 1)) and (not is_set(paths_sum(1), 1)) then
        winnerswinner1_best_index_0_0_choices(2) := winnerswinner1_best_index_0_choice(0) or
          winnerswinner1_best_index_0_value(0) or winnerswinner1_best_index_0_values(0, 2);
      else
        winnerswinner1_best_index_0_0_choices(2) := winnerswinner1_best_index_0_choice(0) and
          (winnerswinner1_best_index_0_value(0) or winnerswinner1_best_index_0_values(0, 2));
      end if;
      winnerswinner1_best_index_0_values(0, 3) := (((winnerswinner1_best_cost_0_sum(0) mod 256) / 4) mod 2) = 1;
      winnerswinner1_best_index_0_values(0, 4) := is_set(paths_sum(1), 2);
      if winnerswinner1_best_index_0_0_choices(2) then
        winnerswinner1_best_index_0_0_choices(3) := (not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 4) mod 2) =
          1)) and (not is_set(paths_sum(0), 2)) and (winnerswinner1_best_index_0_values(0, 3) or
          winnerswinner1_best_index_0_values(0, 4));
      else
        winnerswinner1_best_index_0_0_choices(3) := ((not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 4) mod 2)
          = 1)) and (not is_set(paths_sum(0), 2))) or winnerswinner1_best_index_0_values(0, 3) or
          winnerswinner1_best_index_0_values(0, 4);
      end if;
      winnerswinner1_best_index_0_values(0, 5) := (((winnerswinner1_best_cost_0_sum(0) mod 256) / 8) mod 2) = 1;
      winnerswinner1_best_index_0_values(0, 6) := is_set(paths_sum(1), 3);
      if winnerswinner1_best_index_0_0_choices(3) then
        winnerswinner1_best_index_0_0_choices(4) := ((not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 8) mod 2)
          = 1)) and (not is_set(paths_sum(0), 3))) or winnerswinner1_best_index_0_values(0, 5) or
          winnerswinner1_best_index_0_values(0, 6);
      else
        winnerswinner1_best_index_0_0_choices(4) := (not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 8) mod 2) =
          1)) and (not is_set(paths_sum(0), 3)) and (winnerswinner1_best_index_0_values(0, 5) or
          winnerswinner1_best_index_0_values(0, 6));
      end if;
      winnerswinner1_best_index_0_values(0, 7) := (((winnerswinner1_best_cost_0_sum(0) mod 256) / 16) mod 2) = 1;
      winnerswinner1_best_index_0_values(0, 8) := is_set(paths_sum(1), 4);
      if winnerswinner1_best_index_0_0_choices(4) then
        winnerswinner1_best_index_0_0_choices(5) := ((not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 16) mod 2)
          = 1)) and (not is_set(paths_sum(0), 4))) or winnerswinner1_best_index_0_values(0, 7) or
          winnerswinner1_best_index_0_values(0, 8);
      else
        winnerswinner1_best_index_0_0_choices(5) := (not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 16) mod 2)
          = 1)) and (not is_set(paths_sum(0), 4)) and (winnerswinner1_best_index_0_values(0, 7) or
          winnerswinner1_best_index_0_values(0, 8));
      end if;
      winnerswinner1_best_index_0_values(0, 9) := (((winnerswinner1_best_cost_0_sum(0) mod 256) / 32) mod 2) = 1;
      winnerswinner1_best_index_0_values(0, 10) := is_set(paths_sum(1), 5);
      if winnerswinner1_best_index_0_0_choices(5) then
        winnerswinner1_best_index_0_0_choices(6) := ((not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 32) mod 2)
          = 1)) and (not is_set(paths_sum(0), 5))) or winnerswinner1_best_index_0_values(0, 9) or
          winnerswinner1_best_index_0_values(0, 10);
      else
        winnerswinner1_best_index_0_0_choices(6) := (not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 32) mod 2)
          = 1)) and (not is_set(paths_sum(0), 5)) and (winnerswinner1_best_index_0_values(0, 9) or
          winnerswinner1_best_index_0_values(0, 10));
      end if;
      winnerswinner1_best_index_0_values(0, 11) := (((winnerswinner1_best_cost_0_sum(0) mod 256) / 64) mod 2) = 1;
      winnerswinner1_best_index_0_values(0, 12) := is_set(paths_sum(1), 6);
      if winnerswinner1_best_index_0_0_choices(6) then
        winnerswinner1_best_index_0_0_choices(7) := ((not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 64) mod 2)
          = 1)) and (not is_set(paths_sum(0), 6))) or winnerswinner1_best_index_0_values(0, 11) or
          winnerswinner1_best_index_0_values(0, 12);
      else
        winnerswinner1_best_index_0_0_choices(7) := (not ((((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 64) mod 2)
          = 1)) and (not is_set(paths_sum(0), 6)) and (winnerswinner1_best_index_0_values(0, 11) or
          winnerswinner1_best_index_0_values(0, 12));
      end if;
      for i in 1 to 7 loop
        if is_set(winnerswinner1_best_cost_0_sum_2(i), 0) then
          winnerswinner1_best_index_0_choice(i) := (not is_set(winnerswinner1_best_cost_0_sum(i), 0)) and (not
            is_set(paths_sum(2 * i + 1), 0));
        else
          winnerswinner1_best_index_0_choice(i) := is_set(paths_sum(2 * i), 0) and (not
            is_set(winnerswinner1_best_cost_0_sum(i), 0)) and (not is_set(paths_sum(2 * i + 1), 0));
        end if;
        winnerswinner1_best_index_0_value(i) := (((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 2) mod 2) = 1;
        winnerswinner1_best_index_0_values(i, 2) := is_set(paths_sum(2 * i), 1);
        if (not ((((winnerswinner1_best_cost_0_sum(i) mod 256) / 2) mod 2) = 1)) and (not is_set(paths_sum(2 * i + 1),
          1)) then
          winnerswinner1_best_index_0_choices(i, 2) := winnerswinner1_best_index_0_choice(i) or
            winnerswinner1_best_index_0_value(i) or winnerswinner1_best_index_0_values(i, 2);
        else
          winnerswinner1_best_index_0_choices(i, 2) := winnerswinner1_best_index_0_choice(i) and
            (winnerswinner1_best_index_0_value(i) or winnerswinner1_best_index_0_values(i, 2));
        end if;
        winnerswinner1_best_index_0_values(i, 3) := (((winnerswinner1_best_cost_0_sum(i) mod 256) / 4) mod 2) = 1;
        winnerswinner1_best_index_0_values(i, 4) := is_set(paths_sum(2 * i + 1), 2);
        if winnerswinner1_best_index_0_choices(i, 2) then
          winnerswinner1_best_index_0_choices(i, 3) := (not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 4) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 2)) and (winnerswinner1_best_index_0_values(i, 3) or
            winnerswinner1_best_index_0_values(i, 4));
        else
          winnerswinner1_best_index_0_choices(i, 3) := ((not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 4) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 2))) or winnerswinner1_best_index_0_values(i, 3) or
            winnerswinner1_best_index_0_values(i, 4);
        end if;
        winnerswinner1_best_index_0_values(i, 5) := (((winnerswinner1_best_cost_0_sum(i) mod 256) / 8) mod 2) = 1;
        winnerswinner1_best_index_0_values(i, 6) := is_set(paths_sum(2 * i + 1), 3);
        if winnerswinner1_best_index_0_choices(i, 3) then
          winnerswinner1_best_index_0_choices(i, 4) := ((not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 8) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 3))) or winnerswinner1_best_index_0_values(i, 5) or
            winnerswinner1_best_index_0_values(i, 6);
        else
          winnerswinner1_best_index_0_choices(i, 4) := (not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 8) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 3)) and (winnerswinner1_best_index_0_values(i, 5) or
            winnerswinner1_best_index_0_values(i, 6));
        end if;
        winnerswinner1_best_index_0_values(i, 7) := (((winnerswinner1_best_cost_0_sum(i) mod 256) / 16) mod 2) = 1;
        winnerswinner1_best_index_0_values(i, 8) := is_set(paths_sum(2 * i + 1), 4);
        if winnerswinner1_best_index_0_choices(i, 4) then
          winnerswinner1_best_index_0_choices(i, 5) := ((not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 16) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 4))) or winnerswinner1_best_index_0_values(i, 7) or
            winnerswinner1_best_index_0_values(i, 8);
        else
          winnerswinner1_best_index_0_choices(i, 5) := (not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 16) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 4)) and (winnerswinner1_best_index_0_values(i, 7) or
            winnerswinner1_best_index_0_values(i, 8));
        end if;
        winnerswinner1_best_index_0_values(i, 9) := (((winnerswinner1_best_cost_0_sum(i) mod 256) / 32) mod 2) = 1;
        winnerswinner1_best_index_0_values(i, 10) := is_set(paths_sum(2 * i + 1), 5);
        if winnerswinner1_best_index_0_choices(i, 5) then
          winnerswinner1_best_index_0_choices(i, 6) := ((not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 32) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 5))) or winnerswinner1_best_index_0_values(i, 9) or
            winnerswinner1_best_index_0_values(i, 10);
        else
          winnerswinner1_best_index_0_choices(i, 6) := (not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 32) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 5)) and (winnerswinner1_best_index_0_values(i, 9) or
            winnerswinner1_best_index_0_values(i, 10));
        end if;
        winnerswinner1_best_index_0_values(i, 11) := (((winnerswinner1_best_cost_0_sum(i) mod 256) / 64) mod 2) = 1;
        winnerswinner1_best_index_0_values(i, 12) := is_set(paths_sum(2 * i + 1), 6);
        if winnerswinner1_best_index_0_choices(i, 6) then
          winnerswinner1_best_index_0_choices(i, 7) := ((not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 64) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 6))) or winnerswinner1_best_index_0_values(i, 11) or
            winnerswinner1_best_index_0_values(i, 12);
        else
          winnerswinner1_best_index_0_choices(i, 7) := (not ((((winnerswinner1_best_cost_0_sum_2(i) mod 256) / 64) mod
            2) = 1)) and (not is_set(paths_sum(2 * i), 6)) and (winnerswinner1_best_index_0_values(i, 11) or
            winnerswinner1_best_index_0_values(i, 12));
        end if;
        if winnerswinner1_best_index_0_choices(i, 7) then
          winnerswinner1_best_index_0_choices(i, 8) := (not ((not (((winnerswinner1_best_cost_0_sum_2(i) mod 256) /
            128) = 1)) and (not is_set(paths_sum(2 * i), 7)))) and (not (((winnerswinner1_best_cost_0_sum(i) mod 256) /
            128) = 1)) and (not is_set(paths_sum(2 * i + 1), 7));
        else
          winnerswinner1_best_index_0_choices(i, 8) := (not ((not (((winnerswinner1_best_cost_0_sum_2(i) mod 256) /
            128) = 1)) and (not is_set(paths_sum(2 * i), 7)))) or ((not (((winnerswinner1_best_cost_0_sum(i) mod 256) /
            128) = 1)) and (not is_set(paths_sum(2 * i + 1), 7)));
        end if;
      end loop;
      for i in 0 to 7 loop
        if (winnerswinner1_best_cost_0_any(i) - winnerswinner1_best_cost_0_any_2(i)) < 0 then
          winnerswinner1_best_cost_0(i) <= winnerswinner1_best_cost_0_any(i);
        else
          winnerswinner1_best_cost_0(i) <= winnerswinner1_best_cost_0_any_2(i);
        end if;
      end loop;
      if winnerswinner1_best_index_0_0_choices(7) then
        winnerswinner1_best_index_0_0 <= (not ((not (((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 128) = 1)) and
          (not is_set(paths_sum(0), 7)))) and (not (((winnerswinner1_best_cost_0_sum(0) mod 256) / 128) = 1)) and (not
          is_set(paths_sum(1), 7));
      else
        winnerswinner1_best_index_0_0 <= (not ((not (((winnerswinner1_best_cost_0_sum_2(0) mod 256) / 128) = 1)) and
          (not is_set(paths_sum(0), 7)))) or ((not (((winnerswinner1_best_cost_0_sum(0) mod 256) / 128) = 1)) and (not
          is_set(paths_sum(1), 7)));
      end if;
      if winnerswinner1_best_index_0_choices(1, 8) then
        winnerswinner1_best_index_0_1 <= 3;
      else
        winnerswinner1_best_index_0_1 <= 2;
      end if;
      if winnerswinner1_best_index_0_choices(2, 8) then
        winnerswinner1_best_index_0_2 <= 5;
      else
        winnerswinner1_best_index_0_2 <= 4;
      end if;
      if winnerswinner1_best_index_0_choices(3, 8) then
        winnerswinner1_best_index_0_3 <= 7;
      else
        winnerswinner1_best_index_0_3 <= 6;
      end if;
      if winnerswinner1_best_index_0_choices(4, 8) then
        winnerswinner1_best_index_0_4 <= 9;
      else
        winnerswinner1_best_index_0_4 <= 8;
      end if;
      if winnerswinner1_best_index_0_choices(5, 8) then
        winnerswinner1_best_index_0_5 <= 11;
      else
        winnerswinner1_best_index_0_5 <= 10;
      end if;
      if winnerswinner1_best_index_0_choices(6, 8) then
        winnerswinner1_best_index_0_6 <= 13;
      else
        winnerswinner1_best_index_0_6 <= 12;
      end if;
      if winnerswinner1_best_index_0_choices(7, 8) then
        winnerswinner1_best_index_0_7 <= 15;
      else
        winnerswinner1_best_index_0_7 <= 14;
      end if;
      if in_valid then
        if in_start_of_frame then
          winnerswinner1_best_below_0 <= transform_counter_next_frame;
        else
          winnerswinner1_best_below_0 <= transform_counter_frame_joins;
        end if;
      end if;
      -- winnerswinner2
      for i in 0 to 3 loop
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
      for i in 0 to 3 loop
        if (winnerswinner1_best_cost_0(2 * i + 1) - winnerswinner1_best_cost_0(2 * i)) < 0 then
          winnerswinner2_best_cost_0(i) <= winnerswinner1_best_cost_0(2 * i + 1);
        else
          winnerswinner2_best_cost_0(i) <= winnerswinner1_best_cost_0(2 * i);
        end if;
      end loop;
      if winnerswinner2_best_index_0_choices(0, 8) then
        winnerswinner2_best_index_0_0 <= winnerswinner1_best_index_0_1;
      else
        winnerswinner2_best_index_0_0 <= as_number(winnerswinner1_best_index_0_0);
      end if;
      if winnerswinner2_best_index_0_choices(1, 8) then
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_3;
      else
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_2;
      end if;
      if winnerswinner2_best_index_0_choices(2, 8) then
        winnerswinner2_best_index_0_2 <= winnerswinner1_best_index_0_5;
      else
        winnerswinner2_best_index_0_2 <= winnerswinner1_best_index_0_4;
      end if;
      if winnerswinner2_best_index_0_choices(3, 8) then
        winnerswinner2_best_index_0_3 <= winnerswinner1_best_index_0_7;
      else
        winnerswinner2_best_index_0_3 <= winnerswinner1_best_index_0_6;
      end if;
      -- winnerswinner3
      for i in 0 to 1 loop
        if is_set(winnerswinner2_best_cost_0(2 * i), 0) then
          winnerswinner3_best_index_0_choice(i) := (not is_set(winnerswinner2_best_cost_0(2 * i + 1), 1)) or (not
            is_set(winnerswinner2_best_cost_0(2 * i + 1), 0));
        else
          winnerswinner3_best_index_0_choice(i) := not is_set(winnerswinner2_best_cost_0(2 * i + 1), 1);
        end if;
        if is_set(winnerswinner2_best_cost_0(2 * i), 1) then
          winnerswinner3_best_index_0_choices(i, 2) := winnerswinner3_best_index_0_choice(i);
        else
          winnerswinner3_best_index_0_choices(i, 2) := is_set(winnerswinner2_best_cost_0(2 * i), 0) and
            ((winnerswinner2_best_cost_0(2 * i + 1) mod 4) = 0);
        end if;
        winnerswinner3_best_index_0_value(i) := is_set(winnerswinner2_best_cost_0(2 * i + 1), 2);
        if winnerswinner3_best_index_0_choices(i, 2) then
          winnerswinner3_best_index_0_choices(i, 3) := (not is_set(winnerswinner2_best_cost_0(2 * i), 2)) and
            winnerswinner3_best_index_0_value(i);
        else
          winnerswinner3_best_index_0_choices(i, 3) := (not is_set(winnerswinner2_best_cost_0(2 * i), 2)) or
            winnerswinner3_best_index_0_value(i);
        end if;
        for j in 2 to 5 loop
          winnerswinner3_best_index_0_values(i, j) := is_set(winnerswinner2_best_cost_0(2 * i + 1), j + 1);
          if winnerswinner3_best_index_0_choices(i, j + 1) then
            winnerswinner3_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner2_best_cost_0(2 * i), j + 1)) or
              winnerswinner3_best_index_0_values(i, j);
          else
            winnerswinner3_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner2_best_cost_0(2 * i), j + 1)) and
              winnerswinner3_best_index_0_values(i, j);
          end if;
        end loop;
        if winnerswinner3_best_index_0_choices(i, 7) then
          winnerswinner3_best_index_0_choices(i, 8) := is_set(winnerswinner2_best_cost_0(2 * i), 7) and (not
            is_set(winnerswinner2_best_cost_0(2 * i + 1), 7));
        else
          winnerswinner3_best_index_0_choices(i, 8) := is_set(winnerswinner2_best_cost_0(2 * i), 7) or (not
            is_set(winnerswinner2_best_cost_0(2 * i + 1), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if (winnerswinner2_best_cost_0(2 * i + 1) - winnerswinner2_best_cost_0(2 * i)) < 0 then
          winnerswinner3_best_cost_0(i) <= winnerswinner2_best_cost_0(2 * i + 1);
        else
          winnerswinner3_best_cost_0(i) <= winnerswinner2_best_cost_0(2 * i);
        end if;
      end loop;
      if winnerswinner3_best_index_0_choices(0, 8) then
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_1;
      else
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_0;
      end if;
      if winnerswinner3_best_index_0_choices(1, 8) then
        winnerswinner3_best_index_0_1 <= winnerswinner2_best_index_0_3;
      else
        winnerswinner3_best_index_0_1 <= winnerswinner2_best_index_0_2;
      end if;
      -- winnerswinner4
      if is_set(winnerswinner3_best_cost_0(0), 0) then
        winnerswinner4_best_index_0_0_choice := (not is_set(winnerswinner3_best_cost_0(1), 1)) or (not
          is_set(winnerswinner3_best_cost_0(1), 0));
      else
        winnerswinner4_best_index_0_0_choice := not is_set(winnerswinner3_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner3_best_cost_0(0), 1) then
        winnerswinner4_best_index_0_0_choices(2) := winnerswinner4_best_index_0_0_choice;
      else
        winnerswinner4_best_index_0_0_choices(2) := is_set(winnerswinner3_best_cost_0(0), 0) and
          ((winnerswinner3_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner4_best_index_0_0_value := is_set(winnerswinner3_best_cost_0(1), 2);
      if winnerswinner4_best_index_0_0_choices(2) then
        winnerswinner4_best_index_0_0_choices(3) := (not is_set(winnerswinner3_best_cost_0(0), 2)) and
          winnerswinner4_best_index_0_0_value;
      else
        winnerswinner4_best_index_0_0_choices(3) := (not is_set(winnerswinner3_best_cost_0(0), 2)) or
          winnerswinner4_best_index_0_0_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner4_best_index_0_0_values(i) := is_set(winnerswinner3_best_cost_0(1), i + 1);
        if winnerswinner4_best_index_0_0_choices(i + 1) then
          winnerswinner4_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner3_best_cost_0(0), i + 1)) or
            winnerswinner4_best_index_0_0_values(i);
        else
          winnerswinner4_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner3_best_cost_0(0), i + 1)) and
            winnerswinner4_best_index_0_0_values(i);
        end if;
      end loop;
      if winnerswinner4_best_index_0_0_choices(7) then
        winnerswinner4_best_index_0_0_choices(8) := is_set(winnerswinner3_best_cost_0(0), 7) and (not
          is_set(winnerswinner3_best_cost_0(1), 7));
      else
        winnerswinner4_best_index_0_0_choices(8) := is_set(winnerswinner3_best_cost_0(0), 7) or (not
          is_set(winnerswinner3_best_cost_0(1), 7));
      end if;
      if (winnerswinner3_best_cost_0(1) - winnerswinner3_best_cost_0(0)) < 0 then
        winnerswinner4_best_cost_0_0 <= winnerswinner3_best_cost_0(1);
      else
        winnerswinner4_best_cost_0_0 <= winnerswinner3_best_cost_0(0);
      end if;
      if winnerswinner4_best_index_0_0_choices(8) then
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_1;
      else
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_0;
      end if;
      -- winners
      if line_comes(28) then
        winners_best_cost_0_0_choice := 511;
      else
        winners_best_cost_0_0_choice := winners_best_cost_0_0;
      end if;
      if line_comes(28) then
        winners_best_cost_0_0_choice_2 := 255;
      else
        winners_best_cost_0_0_choice_2 := winners_best_cost_0_0;
      end if;
      winners_best_tag_valid <= line_comes(35);
      winners_best_tag_map_column <= line_places_map_column(4);
      winners_best_tag_output_column <= line_places_shown_output_column(4);
      winners_best_tag_start_of_frame <= line_places_shown_start_of_frame(4);
      winners_best_tag_end_of_line <= line_places_shown_end_of_line(4);
      if (winners_best_cost_0_0_choice - winnerswinner4_best_cost_0_0) < 0 then
        winners_best_cost_0_0 <= winners_best_cost_0_0_choice_2;
      else
        winners_best_cost_0_0 <= winnerswinner4_best_cost_0_0;
      end if;
      if (winnerswinner4_best_cost_0_0 - winners_best_cost_0_0_choice) < 0 then
        winners_best_index_0_0 <= winnerswinner4_best_index_0_0 + 112;
      else
        winners_best_index_0_0 <= ((((winners_best_index_0_0 / 16) + 15) mod 16) * 16) + (winners_best_index_0_0 mod
          16);
      end if;
      -- turn
      turn_order_address_any := turn_ready_tag_map_column or (not winners_best_tag_map_column) or (not
        winners_best_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 2047;
      else
        turn_order_address_choice := 1;
      end if;
      if turn_order_falls then
        turn_order_address_choice_2 := 0;
      else
        turn_order_address_choice_2 := 1239;
      end if;
      turn_order_address_any_2 := (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 2048;
        else
          turn_order_address <= turn_order_address_choice_2;
        end if;
      end if;
      turn_order_falls_all := (not turn_ready_tag_map_column) and winners_best_tag_map_column and
        winners_best_tag_valid;
      turn_order_complete_all := winners_best_tag_map_column and winners_best_tag_valid;
      turn_ready_tag_row_start_differs := map_counter_group /= 376;
      turn_ready_tag_row_start_is_equal := map_counter_column = 1239;
      if turn_ready_tag_row_start_is_equal then
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start and (map_counter_group /= 375);
      else
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start;
      end if;
      if turn_ready_tag_row_start_differs then
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start_choice;
      else
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start;
      end if;
      turn_ready_tag_row_start_is_equal_2 := map_counter_group = 374;
      turn_ready_tag_row_start_all := turn_ready_tag_row_start_is_equal_2 and turn_ready_tag_row_start_is_equal;
      if turn_ready_tag_row_start_choices(2) then
        turn_ready_tag_row_start_choices(3) := (not turn_ready_tag_start_of_frame) or turn_ready_tag_row_start_all;
      else
        turn_ready_tag_row_start_choices(3) := turn_ready_tag_start_of_frame and turn_ready_tag_row_start_is_equal_2
          and turn_ready_tag_row_start_is_equal;
      end if;
      turn_ready_tag_row_start_all_2 := turn_ready_tag_valid and turn_order_inside;
      turn_order_inside <= turn_read_tag_map_column;
      turn_order_turned_valid <= winners_best_tag_valid;
      turn_order_turned_map_column <= winners_best_tag_map_column;
      turn_order_turned_start_of_frame <= (not turn_ready_tag_map_column) and winners_best_tag_map_column and
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
        turn_write_place <= 1240;
      end if;
      if turn_ready_tag_row_start_choices(3) then
        turn_ready_tag_row_start <= turn_ready_tag_row_start or turn_ready_tag_row_start_all_2;
      else
        turn_ready_tag_row_start <= turn_ready_tag_row_start and ((not turn_ready_tag_valid) or (not
          turn_order_inside));
      end if;
      if turn_order_falls_all then
        turn_order_output <= winners_best_tag_output_column;
        turn_order_first <= winners_best_tag_start_of_frame;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
      end if;
      if winners_best_tag_valid then
        turn_ready_tag_map_column <= winners_best_tag_map_column;
      end if;
      -- map
      if turn_ready_tag_row_start_all_2 then
        if turn_ready_tag_start_of_frame or turn_ready_tag_row_start_is_equal then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 2048;
        end if;
      end if;
      if turn_ready_tag_row_start_all then
        map_counter_group_choice := 375;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 375;
      if turn_ready_tag_row_start and map_counter_group_is_equal then
        map_counter_group_choices(2) := 1;
      else
        map_counter_group_choices(2) := (map_counter_group + 1) mod 512;
      end if;
      if turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equal and turn_ready_tag_valid and
        turn_order_inside then
        map_counter_group_choices(3) := map_counter_group_choices(2);
      else
        map_counter_group_choices(3) := map_counter_group;
      end if;
      if turn_ready_tag_valid then
        map_line_ended_choice := turn_order_inside;
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
      map_at_column <= to_integer(other(1)(10 downto 0));
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
      if turn_ready_tag_start_of_frame and turn_ready_tag_valid and turn_order_inside then
        map_counter_group <= map_counter_group_choice;
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
        map_write_column <= to_integer(other(1)(10 downto 0));
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
      for i in 10 to 11 loop
        if relief_newest_choices(8) then
          relief_newest_choices(i) := not is_set(relief_newest_values_from_6(6), 23 - 2 * i);
        else
          relief_newest_choices(i) := not is_set(relief_newest_values_from_6(7), 23 - 2 * i);
        end if;
      end loop;
      if relief_newest_choices(8) then
        relief_newest_choices(12) := is_set(relief_newest_values_from_6(6), 4);
      else
        relief_newest_choices(12) := is_set(relief_newest_values_from_6(7), 4);
      end if;
      if relief_newest_choices(8) then
        relief_newest_choices(13) := not is_set(relief_newest_values_from_6(6), 5);
      else
        relief_newest_choices(13) := not is_set(relief_newest_values_from_6(7), 5);
      end if;
      for i in 14 to 15 loop
        if relief_newest_choices(8) then
          relief_newest_choices(i) := is_set(relief_newest_values_from_6(6), i - 8);
        else
          relief_newest_choices(i) := is_set(relief_newest_values_from_6(7), i - 8);
        end if;
      end loop;
      if relief_newest_choices(7) then
        relief_newest_choices(16) := is_set(relief_centre_grey(1), 7) and (not is_set(relief_before, 7));
      else
        relief_newest_choices(16) := is_set(relief_centre_grey(1), 7) or (not is_set(relief_before, 7));
      end if;
      if relief_newest_choices(16) then
        relief_newest_choice_17 := (relief_newest_values_from_6(7) / 2) mod 64;
      else
        relief_newest_choice_17 := (relief_newest_values_from_6(6) / 2) mod 64;
      end if;
      relief_centre_grey(0) <= relief_centre_column(4);
      relief_centre_grey(1) <= relief_centre_grey(0);
      relief_delayed_0 <= relief_newest;
      relief_rows_read_newest_0 <= relief_delayed_0;
      relief_rows_ready_words_0 <= to_integer(relief_rows_read_words_0);
      relief_rows_ready_newest_0 <= relief_rows_read_newest_0;
      relief_shown_0 <= relief_rows_ready_words_0;
      relief_write_turned_0 <= relief_entered;
      if ((not ((not ((not ((not relief_newest_choices(9)) and relief_newest_choices(10) and
        relief_newest_choices(11))) and relief_newest_choices(12))) and relief_newest_choices(13))) and
        relief_newest_choices(14)) or relief_newest_choices(15) then
        relief_newest <= 40;
      else
        relief_newest <= relief_newest_choice_17;
      end if;
      if relief_entering < 40 then
        relief_entered <= relief_entering;
      else
        relief_entered <= 40;
      end if;
      if line_starts_phases(1) then
        relief_write_address <= line_order_address;
      else
        relief_write_address <= 1240;
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
      -- other
      other(0) <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 376))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other(1) <= other(0);
      other_2 <= ((map_rows_ready_words_0 mod 512) / 2) * 2;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 377;
        transform_counter_next_frame <= false;
        transform_counter_last_column <= false;
        transform_counter_counts <= false;
        transform_counter_frame_joins <= false;
        transform_counter_back_to_back <= false;
        transform_counter_column_after <= 1;
        transform_counter_group_after <= 377;
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
        raster_place_group <= 376;
        raster_place_next_frame <= false;
        raster_place_last_column <= false;
        raster_place_frame_joins <= false;
        raster_place_back_to_back <= false;
        raster_place_column_after <= 1;
        raster_place_group_after <= 376;
        delay_column <= 0;
        delay_row_inside(2) <= false;
        delay_tag_valid <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_first_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_first_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_first_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
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
        line_order_turned_start_of_frame <= false;
        line_order_turned_end_of_line <= false;
        line_newest_first_column <= false;
        for i in 1 to 35 loop
          line_comes(i) <= false;
        end loop;
        for i in 1 to 35 loop
          line_starts_phases(i) <= false;
        end loop;
        for i in 0 to 2 loop
          line_places_map_column(i) <= false;
          line_places_address(i) <= 0;
          line_places_shown_output_column(i) <= false;
          line_places_shown_first_column(i) <= false;
          line_places_shown_start_of_frame(i) <= false;
          line_places_shown_end_of_line(i) <= false;
        end loop;
        line_places_map_column(3) <= false;
        line_places_first_column(3) <= false;
        line_places_shown_output_column(3) <= false;
        line_places_shown_start_of_frame(3) <= false;
        line_places_shown_end_of_line(3) <= false;
        line_places_map_column(4) <= false;
        line_places_shown_output_column(4) <= false;
        line_places_shown_start_of_frame(4) <= false;
        line_places_shown_end_of_line(4) <= false;
        costsshift_new_tag_valid <= false;
        costsshift_count_phase <= 7;
        costsshift_read_tag_valid <= false;
        costsshift_read_count_phase <= 7;
        costsshift_write_phase <= 7;
        costswindow_read_count_phase <= 7;
        costswindow_write_count_phase <= 7;
        paths_cost_delay_ring_read_address <= 1;
        paths_cost_delay_ring_write_address <= 0;
        pathsleft_low_address <= 4;
        pathsleft_read_count_phase <= 7;
        pathsleft_ahead_count_phase <= 7;
        pathsleft_write_count_phase <= 7;
        pathsleft_low_write_address <= 0;
        pathsabove_memory_read_address_0 <= 0;
        pathsabove_memory_read_address_2 <= 0;
        pathsabove_memory_write_address(0) <= 0;
        pathsabove_memory_write_address(1) <= 0;
        pathsabove_memory_write_address_2 <= 0;
        pathsabove_read_address_address <= 0;
        pathsabove_read_address_count_phase <= 7;
        pathsabove_write_address_address <= 0;
        pathsabove_write_address_is_here <= false;
        pathsabove_write_address_count_phase <= 7;
        pathsturn_sum_memory_read_address_0 <= 0;
        pathsturn_sum_memory_read_address_2 <= 0;
        pathsturn_sum_memory_write_address(0) <= 0;
        pathsturn_sum_memory_write_address(1) <= 0;
        pathsturn_sum_memory_write_address_2 <= 0;
        pathsturn_cost_memory_read_address_0 <= 0;
        pathsturn_cost_memory_read_address_2 <= 0;
        pathsturn_cost_memory_write_address(0) <= 0;
        pathsturn_cost_memory_write_address(1) <= 0;
        pathsturn_cost_memory_write_address_2 <= 0;
        pathsturn_smallest_address <= 0;
        pathsturn_read_address_address <= 0;
        pathsturn_read_address_count_phase <= 7;
        pathsturn_sum_read_address <= 0;
        pathsturn_write_smallest_address <= 0;
        pathsturn_write_address_address <= 0;
        pathsturn_write_address_is_here <= false;
        pathsturn_write_address_count_phase <= 7;
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
        for i in 0 to 2 loop
          map_waiting_complete(i) <= false;
          map_waiting_first(i) <= false;
          map_waiting_last(i) <= false;
        end loop;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
        relief_write_address <= 0;
        other(0) <= to_unsigned(0, 49);
        other(1) <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
