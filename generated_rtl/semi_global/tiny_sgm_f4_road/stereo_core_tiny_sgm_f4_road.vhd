-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration tiny_sgm_f4_road: 40x12, 12 disparities, window 3x3, P1 7, P2 60, 1 pixel pair a clock.
-- Options: disparities 12, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap 5, p1 7, p2 60,
--   p2_least 20, above_p1 5, above_p2 31, slice_disparities 5, clocks_per_pixel 4.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_sgm_f4_road
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_sgm_f4_road is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 12;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 29;
    latency_clocks : positive := 39;
    flush_groups : positive := 205;
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
  assert width_px = 40 report "stereo_core_tiny_sgm_f4_road: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 12 report "stereo_core_tiny_sgm_f4_road: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 12 report "stereo_core_tiny_sgm_f4_road: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_sgm_f4_road: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_sgm_f4_road: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 29 report "stereo_core_tiny_sgm_f4_road: output_width_px is " & integer'image(output_width_px) & " but this core has 29" severity failure;
  assert latency_clocks = 39 report "stereo_core_tiny_sgm_f4_road: latency_clocks is " & integer'image(latency_clocks) & " but this core has 39" severity failure;
  assert flush_groups = 205 report "stereo_core_tiny_sgm_f4_road: flush_groups is " & integer'image(flush_groups) & " but this core has 205" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_sgm_f4_road: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_sgm_f4_road is
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
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_52_1d is array (natural range <>) of natural range 0 to 52;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_64_1d is array (natural range <>) of natural range 0 to 64;
  type natural_68_1d is array (natural range <>) of natural range 0 to 68;
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  signal in_valid, in_start_of_frame : boolean;
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
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_2, transform_read_row_inside_4, transform_read_column_inside_0 : boolean;
  signal transform_read_column_inside_2, transform_read_column_inside_4, transform_read_column_inside_6 : boolean;
  signal transform_read_column_inside_8, transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside_0, transform_ready_row_inside_2, transform_ready_row_inside_4 : boolean;
  signal transform_ready_column_inside_0, transform_ready_column_inside_2, transform_ready_column_inside_4 : boolean;
  signal transform_ready_column_inside_6, transform_ready_column_inside_8, transform_ready_start_of_frame : boolean;
  signal transform_ready_valid, transform_columns_row_inside_0, transform_columns_row_inside_2 : boolean;
  signal transform_columns_row_inside_4, transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_column_inside_4, transform_columns_column_inside_6 : boolean;
  signal transform_columns_column_inside_8, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_0_column_inside_4, transform_filtering_0_column_inside_6 : boolean;
  signal transform_filtering_0_column_inside_8 : boolean;
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- transform_filtering_#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- transform_filtering_#_valid
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 63;
  signal transform_write_column : natural range 0 to 63;
  signal transform_counter_group : natural range 0 to 15;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 16383;
  signal delay_delayed_0 : unsigned(13 downto 0);
  signal delay_column : natural range 0 to 63;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag_valid, delay_tag_border_column, delay_tag_first_cost, delay_tag_map_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_search : natural_16383_1d(0 to 2);
  signal rows_reference : natural_16383_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 63;
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
  signal line_comes : boolean_1d(1 to 23);
  signal line_starts_phases : boolean_1d(1 to 23);
  signal line_places_map_column : boolean_1d(0 to 5);  -- line_places_#_map_column
  signal line_places_first_column : boolean_1d(0 to 4);  -- line_places_#_first_column
  signal line_places_top : boolean_1d(0 to 1);  -- line_places_#_top
  signal line_places_shown_output_column : boolean_1d(0 to 5);  -- line_places_#_shown_output_column
  signal line_places_shown_start_of_frame : boolean_1d(0 to 5);  -- line_places_#_shown_start_of_frame
  signal line_places_shown_end_of_line : boolean_1d(0 to 5);  -- line_places_#_shown_end_of_line
  signal line_order_address : natural range 0 to 31;
  signal line_places_address : natural_31_1d(0 to 3);  -- line_places_#_address
  -- costsshift
  signal costsshift_newest : natural_16383_1d(0 to 2);
  signal costsshift_new_reference : natural_16383_1d(0 to 2);
  signal costsshift_handed_on : natural_16383_1d(0 to 2);
  signal costsshift_read_reference : natural_16383_1d(0 to 2);
  signal costsshift_search : natural_16383_2d(0 to 2, 0 to 2);
  signal costsshift_reference : natural_16383_1d(0 to 2);
  signal costsshift_new_tag_valid, costsshift_new_tag_border_column, costsshift_read_tag_valid : boolean;
  signal costsshift_read_tag_border_column, costsshift_tag_border_column : boolean;
  signal costsshift_count_phase, costsshift_read_count_phase, costsshift_write_phase : natural range 0 to 3;
  signal costsshift_read_words : unsigned_28_1d(0 to 3);
  signal costsshift_read_words_4 : unsigned(13 downto 0);
  -- costscolumn
  signal costscolumn_pixels_first_count : natural_3_3d(0 to 2, 0 to 2, 0 to 3);  -- costscolumn_pixels_first_#_#_count_#
  signal costscolumn_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 2);  -- costscolumn_pixels_first_#_#_count_4
  signal costscolumn_pixels_first_tag_border_column, costscolumn_pixels_tag_border_column : boolean;
  signal costscolumn_pair_tag_border_column : boolean;
  signal costscolumn_pixels_cost : natural_14_2d(0 to 2, 0 to 2);
  signal costscolumn_single_0 : natural_14_1d(0 to 2);
  signal costscolumn_pair_0 : natural_28_1d(0 to 2);
  signal costscolumn_column_0 : natural_42_1d(0 to 2);
  -- costswindow
  signal costswindow_read_count_phase, costswindow_write_count_phase : natural range 0 to 3;
  signal costswindow_read_words_0 : unsigned(27 downto 0);
  signal costswindow_read_words_1 : unsigned(13 downto 0);
  signal costswindow_partial : natural_42_1d(0 to 2);
  signal costswindow_partials : natural_105_1d(3 to 5);  -- costswindow_partial_#
  signal costswindow_sum_0 : natural_169_1d(0 to 2);
  -- costs
  signal costs_cost : natural_21_1d(0 to 2);
  -- paths
  signal paths_tree_smallest : natural_21_1d(0 to 1);
  signal paths_tree_next_smallest_0, paths_smallest_cost : natural range 0 to 21;
  signal paths_cost_delay_ring_read_address, paths_cost_delay_ring_write_address : natural range 0 to 7;
  signal paths_cost_delay_held_0 : unsigned(8 downto 0);
  signal paths_sum : natural_254_1d(0 to 2);
  -- pathsleft
  signal pathsleft_fresh_past_newest : natural_64_1d(0 to 1);
  signal pathsleft_fresh_past_pairs : natural_64_1d(0 to 2);
  signal pathsleft_fresh_past_fours : natural_64_1d(0 to 4);
  signal pathsleft_fresh_past_cheapest, pathsleft_fresh_here : natural range 0 to 64;
  signal pathsleft_fresh_known, pathsleft_q_less, pathsleft_g_less, pathsleft_passed_by : natural range 0 to 127;
  signal pathsleft_lower_neighbour : natural range 0 to 127;
  signal pathsleft_stay : natural_127_1d(0 to 2);
  signal pathsleft_step : natural_127_1d(0 to 2);
  signal pathsleft_stay_change : natural_127_1d(0 to 2);
  signal pathsleft_step_change : natural_127_1d(0 to 2);
  signal pathsleft_cost : natural_127_1d(0 to 2);
  signal pathsleft_arrived : natural_127_1d(0 to 2);
  signal pathsleft_tree_smallest : natural_127_1d(0 to 1);
  signal pathsleft_tree_next_smallest_0, pathsleft_low_0 : natural range 0 to 127;
  signal pathsleft_low_address, pathsleft_low_write_address : natural range 0 to 15;
  signal pathsleft_lowest_0, pathsleft_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsleft_lost, pathsleft_short_of, pathsleft_first, pathsleft_is_first, pathsleft_is_last : boolean;
  signal pathsleft_passes_by : boolean;
  signal pathsleft_missing, pathsleft_below, pathsleft_q, pathsleft_room_left, pathsleft_q_now : natural range 0 to 63;
  signal pathsleft_room : natural range 0 to 63;
  signal pathsleft_start_cost : natural_63_1d(1 to 6);
  signal pathsleft_g : natural range 0 to 84;
  signal pathsleft_read_count_phase, pathsleft_ahead_count_phase, pathsleft_write_count_phase : natural range 0 to 3;
  signal pathsleft_read_words_0 : unsigned(27 downto 0);
  signal pathsleft_read_words_1 : unsigned(13 downto 0);
  -- pathsabove
  signal pathsabove_memory_read_address_0, pathsabove_memory_write_address_0 : natural range 0 to 127;
  signal pathsabove_write_address_address : natural range 0 to 127;
  signal pathsabove_memory_read_words_0_0 : unsigned(14 downto 0);
  signal pathsabove_memory_ready_words_0, pathsabove_memory_write_words_0_0 : natural range 0 to 32767;
  signal pathsabove_read_address_count_phase, pathsabove_count_phase : natural range 0 to 3;
  signal pathsabove_write_address_count_phase : natural range 0 to 3;
  signal pathsabove_ready_top, pathsabove_write_address_is_here : boolean;
  signal pathsabove_total : natural_52_1d(0 to 2);
  signal pathsabove_tree_smallest : natural_52_1d(0 to 1);
  signal pathsabove_tree_next_smallest_0 : natural range 0 to 52;
  signal pathsabove_delay_held_0 : unsigned(17 downto 0);
  signal pathsabove_smallest_total, pathsabove_smallest : natural range 0 to 63;
  signal pathsabove_cost : natural_63_1d(0 to 2);
  signal pathsabove_held : natural_63_1d(0 to 2);
  signal pathsabove_lower_neighbour : natural range 0 to 63;
  signal pathsabove_beside : natural_63_1d(0 to 2);
  signal pathsabove_own : natural_63_1d(0 to 1);
  signal pathsabove_step : natural_68_1d(0 to 2);
  signal pathsabove_stay : natural_31_1d(0 to 2);
  -- pathsturn
  signal pathsturn_sum_memory_read_address_0, pathsturn_sum_memory_write_address_0 : natural range 0 to 127;
  signal pathsturn_cost_memory_read_address_0, pathsturn_cost_memory_write_address_0 : natural range 0 to 127;
  signal pathsturn_sum_read_address, pathsturn_write_address_address : natural range 0 to 127;
  signal pathsturn_sum_write_address : natural_127_1d(0 to 1);
  signal pathsturn_sum_memory_read_words_0_0 : unsigned(15 downto 0);
  signal pathsturn_sum_memory_read_words_0_1, pathsturn_read_smallest_0 : unsigned(4 downto 0);
  signal pathsturn_sum_memory_ready_words_0, pathsturn_sum_memory_write_words_0_0 : natural range 0 to 65535;
  signal pathsturn_sum_memory_ready_words_1, pathsturn_sum_memory_write_words_0_1 : natural range 0 to 31;
  signal pathsturn_smallest_address, pathsturn_ready_smallest_0 : natural range 0 to 31;
  signal pathsturn_write_smallest_address : natural range 0 to 31;
  signal pathsturn_cost_memory_read_words_0_0 : unsigned(8 downto 0);
  signal pathsturn_cost_memory_ready_words_0, pathsturn_cost_memory_write_words_0_0 : natural range 0 to 511;
  signal pathsturn_write_smallest_0 : natural range 0 to 21;
  signal pathsturn_write_address_is_here : boolean;
  signal pathsturn_writes_sums : boolean_1d(0 to 1);
  signal pathsturn_write_address_count_phase : natural range 0 to 3;
  -- pathsright
  signal pathsright_fresh_past_newest : natural_64_1d(0 to 1);
  signal pathsright_fresh_past_pairs : natural_64_1d(0 to 2);
  signal pathsright_fresh_past_fours : natural_64_1d(0 to 4);
  signal pathsright_fresh_past_cheapest, pathsright_fresh_here : natural range 0 to 64;
  signal pathsright_fresh_known, pathsright_q_less, pathsright_g_less, pathsright_passed_by : natural range 0 to 127;
  signal pathsright_lower_neighbour : natural range 0 to 127;
  signal pathsright_stay : natural_127_1d(0 to 2);
  signal pathsright_step : natural_127_1d(0 to 2);
  signal pathsright_stay_change : natural_127_1d(0 to 2);
  signal pathsright_step_change : natural_127_1d(0 to 2);
  signal pathsright_cost : natural_127_1d(0 to 2);
  signal pathsright_arrived : natural_127_1d(0 to 2);
  signal pathsright_tree_smallest : natural_127_1d(0 to 1);
  signal pathsright_tree_next_smallest_0, pathsright_low_0 : natural range 0 to 127;
  signal pathsright_lowest_0, pathsright_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsright_lost, pathsright_short_of : boolean;
  signal pathsright_missing, pathsright_below, pathsright_q, pathsright_room_left : natural range 0 to 63;
  signal pathsright_q_now, pathsright_room : natural range 0 to 63;
  signal pathsright_start_cost : natural_63_1d(1 to 6);
  signal pathsright_g : natural range 0 to 94;
  signal pathsright_read_words_0 : unsigned(27 downto 0);
  signal pathsright_read_words_1 : unsigned(13 downto 0);
  -- winnerswinner1
  signal winnerswinner1_best_cost_0 : natural_254_1d(0 to 1);
  signal winnerswinner1_best_index_0_0 : boolean;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 2;
  -- winnerswinner2
  signal winnerswinner2_best_cost_0_0 : natural range 0 to 254;
  signal winnerswinner2_best_index_0_0 : natural range 0 to 2;
  -- winners
  signal winners_best_cost_0_0, winners_best_index_0_0 : natural range 0 to 255;
  signal winners_best_tag_valid, winners_best_tag_map_column, winners_best_tag_output_column : boolean;
  signal winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 31;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_held_output, turn_order_turned_valid, turn_order_turned_output_column : boolean;
  signal turn_order_turned_start_of_frame, turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid : boolean;
  signal turn_read_tag_output_column, turn_read_tag_start_of_frame, turn_read_tag_end_of_line : boolean;
  signal turn_ready_tag_valid, turn_ready_tag_output_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 511;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- relief
  signal relief_centre_column : natural_255_1d(0 to 4);
  signal relief_centre_grey_0, relief_before : natural range 0 to 255;
  signal relief_newest, relief_rows_read_newest_0, relief_rows_ready_words_0 : natural range 0 to 63;
  signal relief_rows_ready_newest_0, relief_rows_write_words_0, relief_shown_0, relief_column_0 : natural range 0 to 63;
  signal relief_entering, relief_entered, relief_between, relief_write_turned_0 : natural range 0 to 63;
  signal relief_delayed_0, relief_rows_read_words_0, relief_turned_0 : unsigned(5 downto 0);
  signal relief_left : natural_64_1d(0 to 3);
  signal relief_right : natural_64_1d(0 to 3);
  signal relief_write_address : natural range 0 to 31;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address, turn_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal pathsright_read_words_1_memory_read_enable : boolean;
  signal pathsright_read_words_1_memory_read_address : unsigned(1 downto 0);
  signal pathsright_read_words_1_memory_write_address : unsigned(1 downto 0);
  signal pathsright_read_words_1_memory_write_data : unsigned(13 downto 0);
  signal pathsright_read_words_0_memory_read_enable : boolean;
  signal pathsright_read_words_0_memory_read_address : unsigned(1 downto 0);
  signal pathsright_read_words_0_memory_write_address : unsigned(1 downto 0);
  signal pathsright_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal pathsright_read_neighbour_0_memory_read_enable : boolean;
  signal pathsright_read_neighbour_0_memory_read_address : unsigned(1 downto 0);
  signal pathsright_read_neighbour_0_memory_write_address : unsigned(1 downto 0);
  signal pathsright_read_neighbour_0_memory_write_data : unsigned(6 downto 0);
  signal pathsright_lowest_0_memory_read_enable : boolean;
  signal pathsright_lowest_0_memory_read_address, pathsright_lowest_0_memory_write_address : unsigned(3 downto 0);
  signal pathsright_lowest_0_memory_write_data : unsigned(6 downto 0);
  signal pathsturn_read_smallest_0_memory_read_enable : boolean;
  signal pathsturn_read_smallest_0_memory_read_address : unsigned(4 downto 0);
  signal pathsturn_read_smallest_0_memory_write_address : unsigned(4 downto 0);
  signal pathsturn_read_smallest_0_memory_write_data : unsigned(4 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_1_memory_read_address : unsigned(6 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_write_address : unsigned(6 downto 0);
  signal pathsturn_sum_memory_read_words_0_1_memory_write_data : unsigned(4 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsturn_sum_memory_read_words_0_0_memory_read_address : unsigned(6 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_write_address : unsigned(6 downto 0);
  signal pathsturn_sum_memory_read_words_0_0_memory_write_data : unsigned(15 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsturn_cost_memory_read_words_0_0_memory_read_address : unsigned(6 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_write_address : unsigned(6 downto 0);
  signal pathsturn_cost_memory_read_words_0_0_memory_write_data : unsigned(8 downto 0);
  signal pathsabove_delay_held_0_memory_read_enable : boolean;
  signal pathsabove_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal pathsabove_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal pathsabove_delay_held_0_memory_write_data : unsigned(17 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_read_enable : boolean;
  signal pathsabove_memory_read_words_0_0_memory_read_address : unsigned(6 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_write_address : unsigned(6 downto 0);
  signal pathsabove_memory_read_words_0_0_memory_write_data : unsigned(14 downto 0);
  signal pathsleft_read_words_1_memory_read_enable : boolean;
  signal pathsleft_read_words_1_memory_read_address, pathsleft_read_words_1_memory_write_address : unsigned(1 downto 0);
  signal pathsleft_read_words_1_memory_write_data : unsigned(13 downto 0);
  signal pathsleft_read_words_0_memory_read_enable : boolean;
  signal pathsleft_read_words_0_memory_read_address, pathsleft_read_words_0_memory_write_address : unsigned(1 downto 0);
  signal pathsleft_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal pathsleft_read_neighbour_0_memory_read_enable : boolean;
  signal pathsleft_read_neighbour_0_memory_read_address : unsigned(1 downto 0);
  signal pathsleft_read_neighbour_0_memory_write_address : unsigned(1 downto 0);
  signal pathsleft_read_neighbour_0_memory_write_data : unsigned(6 downto 0);
  signal pathsleft_lowest_0_memory_read_enable : boolean;
  signal pathsleft_lowest_0_memory_read_address, pathsleft_lowest_0_memory_write_address : unsigned(3 downto 0);
  signal pathsleft_lowest_0_memory_write_data : unsigned(6 downto 0);
  signal paths_cost_delay_held_0_memory_read_enable : boolean;
  signal paths_cost_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal paths_cost_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal paths_cost_delay_held_0_memory_write_data : unsigned(8 downto 0);
  signal relief_turned_0_memory_read_enable : boolean;
  signal relief_turned_0_memory_read_address, relief_turned_0_memory_write_address : unsigned(4 downto 0);
  signal relief_turned_0_memory_write_data : unsigned(5 downto 0);
  signal relief_rows_read_words_0_memory_read_enable : boolean;
  signal relief_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal relief_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal relief_rows_read_words_0_memory_write_data : unsigned(5 downto 0);
  signal relief_delayed_0_memory_read_enable : boolean;
  signal relief_delayed_0_memory_read_address, relief_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal relief_delayed_0_memory_write_data : unsigned(5 downto 0);
  signal costswindow_read_words_1_memory_read_enable : boolean;
  signal costswindow_read_words_1_memory_read_address : unsigned(1 downto 0);
  signal costswindow_read_words_1_memory_write_address : unsigned(1 downto 0);
  signal costswindow_read_words_1_memory_write_data : unsigned(13 downto 0);
  signal costswindow_read_words_0_memory_read_enable : boolean;
  signal costswindow_read_words_0_memory_read_address : unsigned(1 downto 0);
  signal costswindow_read_words_0_memory_write_address : unsigned(1 downto 0);
  signal costswindow_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_4_memory_read_enable : boolean;
  signal costsshift_read_words_4_memory_read_address : unsigned(1 downto 0);
  signal costsshift_read_words_4_memory_write_address : unsigned(1 downto 0);
  signal costsshift_read_words_4_memory_write_data : unsigned(13 downto 0);
  signal costsshift_read_words_3_memory_read_enable : boolean;
  signal costsshift_read_words_3_memory_read_address : unsigned(1 downto 0);
  signal costsshift_read_words_3_memory_write_address : unsigned(1 downto 0);
  signal costsshift_read_words_3_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_2_memory_read_enable : boolean;
  signal costsshift_read_words_2_memory_read_address : unsigned(1 downto 0);
  signal costsshift_read_words_2_memory_write_address : unsigned(1 downto 0);
  signal costsshift_read_words_2_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_1_memory_read_enable : boolean;
  signal costsshift_read_words_1_memory_read_address : unsigned(1 downto 0);
  signal costsshift_read_words_1_memory_write_address : unsigned(1 downto 0);
  signal costsshift_read_words_1_memory_write_data : unsigned(27 downto 0);
  signal costsshift_read_words_0_memory_read_enable : boolean;
  signal costsshift_read_words_0_memory_read_address : unsigned(1 downto 0);
  signal costsshift_read_words_0_memory_write_address : unsigned(1 downto 0);
  signal costsshift_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address, delay_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(13 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned((turn_ready mod 256), 8));
  pixel_valid <= std_logic_vector(to_unsigned((turn_ready / 256), 1));
  disparity_valid <= as_bit(turn_ready_tag_valid and turn_ready_tag_output_column);
  disparity_start_of_frame <= as_bit(turn_ready_tag_start_of_frame and turn_ready_tag_valid and turn_ready_tag_output_column);
  disparity_end_of_line <= as_bit(turn_ready_tag_end_of_line and turn_ready_tag_valid and turn_ready_tag_output_column);

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
    generic map (depth => 30, width => 9, address_bits => 5)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  pathsright_read_words_1_memory_read_enable <= true;
  pathsright_read_words_1_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 2);
  pathsright_read_words_1_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 2);
  pathsright_read_words_1_memory_write_data <= to_unsigned(pathsright_arrived(2), 7) & to_unsigned(pathsright_arrived(1), 7);
  pathsright_read_words_1_memory : entity work.line_memory
    generic map (depth => 4, width => 14, address_bits => 2)
    port map (
      clock => clock, read_enable => pathsright_read_words_1_memory_read_enable,
      read_address => pathsright_read_words_1_memory_read_address, read_data => pathsright_read_words_1,
      write_address => pathsright_read_words_1_memory_write_address, write_data => pathsright_read_words_1_memory_write_data);

  pathsright_read_words_0_memory_read_enable <= true;
  pathsright_read_words_0_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 2);
  pathsright_read_words_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 2);
  pathsright_read_words_0_memory_write_data <= to_unsigned(pathsright_arrived(0), 7) & to_unsigned(pathsright_cost(2), 7) & to_unsigned(pathsright_cost(1), 7) & to_unsigned(pathsright_cost(0), 7);
  pathsright_read_words_0_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => pathsright_read_words_0_memory_read_enable,
      read_address => pathsright_read_words_0_memory_read_address, read_data => pathsright_read_words_0,
      write_address => pathsright_read_words_0_memory_write_address, write_data => pathsright_read_words_0_memory_write_data);

  pathsright_read_neighbour_0_memory_read_enable <= true;
  pathsright_read_neighbour_0_memory_read_address <= to_unsigned(pathsleft_ahead_count_phase, 2);
  pathsright_read_neighbour_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 2);
  pathsright_read_neighbour_0_memory_write_data <= to_unsigned(pathsright_cost(0), 7);
  pathsright_read_neighbour_0_memory : entity work.line_memory
    generic map (depth => 4, width => 7, address_bits => 2)
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
  pathsturn_read_smallest_0_memory_read_address <= to_unsigned(pathsturn_smallest_address, 5);
  pathsturn_read_smallest_0_memory_write_address <= to_unsigned(pathsturn_write_smallest_address, 5);
  pathsturn_read_smallest_0_memory_write_data <= to_unsigned(pathsturn_write_smallest_0, 5);
  pathsturn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 30, width => 5, address_bits => 5)
    port map (
      clock => clock, read_enable => pathsturn_read_smallest_0_memory_read_enable,
      read_address => pathsturn_read_smallest_0_memory_read_address, read_data => pathsturn_read_smallest_0,
      write_address => pathsturn_read_smallest_0_memory_write_address, write_data => pathsturn_read_smallest_0_memory_write_data);

  pathsturn_sum_memory_read_words_0_1_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_1_memory_read_address <= to_unsigned(pathsturn_write_address_address, 7);
  pathsturn_sum_memory_read_words_0_1_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 7);
  pathsturn_sum_memory_read_words_0_1_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_1, 5);
  pathsturn_sum_memory_read_words_0_1_memory : entity work.line_memory
    generic map (depth => 116, width => 5, address_bits => 7)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_1_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_1_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_1,
      write_address => pathsturn_sum_memory_read_words_0_1_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_1_memory_write_data);

  pathsturn_sum_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_sum_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_write_address_address, 7);
  pathsturn_sum_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 7);
  pathsturn_sum_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_sum_memory_write_words_0_0, 16);
  pathsturn_sum_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 116, width => 16, address_bits => 7)
    port map (
      clock => clock, read_enable => pathsturn_sum_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_sum_memory_read_words_0_0_memory_read_address, read_data => pathsturn_sum_memory_read_words_0_0,
      write_address => pathsturn_sum_memory_read_words_0_0_memory_write_address, write_data => pathsturn_sum_memory_read_words_0_0_memory_write_data);

  pathsturn_cost_memory_read_words_0_0_memory_read_enable <= true;
  pathsturn_cost_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 7);
  pathsturn_cost_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsturn_sum_write_address(0), 7);
  pathsturn_cost_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsturn_cost_memory_write_words_0_0, 9);
  pathsturn_cost_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 116, width => 9, address_bits => 7)
    port map (
      clock => clock, read_enable => pathsturn_cost_memory_read_words_0_0_memory_read_enable,
      read_address => pathsturn_cost_memory_read_words_0_0_memory_read_address, read_data => pathsturn_cost_memory_read_words_0_0,
      write_address => pathsturn_cost_memory_read_words_0_0_memory_write_address, write_data => pathsturn_cost_memory_read_words_0_0_memory_write_data);

  pathsabove_delay_held_0_memory_read_enable <= true;
  pathsabove_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 3);
  pathsabove_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 3);
  pathsabove_delay_held_0_memory_write_data <= to_unsigned(pathsabove_total(2), 6) & to_unsigned(pathsabove_total(1), 6) & to_unsigned(pathsabove_total(0), 6);
  pathsabove_delay_held_0_memory : entity work.line_memory
    generic map (depth => 7, width => 18, address_bits => 3)
    port map (
      clock => clock, read_enable => pathsabove_delay_held_0_memory_read_enable,
      read_address => pathsabove_delay_held_0_memory_read_address, read_data => pathsabove_delay_held_0,
      write_address => pathsabove_delay_held_0_memory_write_address, write_data => pathsabove_delay_held_0_memory_write_data);

  pathsabove_memory_read_words_0_0_memory_read_enable <= true;
  pathsabove_memory_read_words_0_0_memory_read_address <= to_unsigned(pathsabove_memory_read_address_0, 7);
  pathsabove_memory_read_words_0_0_memory_write_address <= to_unsigned(pathsabove_memory_write_address_0, 7);
  pathsabove_memory_read_words_0_0_memory_write_data <= to_unsigned(pathsabove_memory_write_words_0_0, 15);
  pathsabove_memory_read_words_0_0_memory : entity work.line_memory
    generic map (depth => 116, width => 15, address_bits => 7)
    port map (
      clock => clock, read_enable => pathsabove_memory_read_words_0_0_memory_read_enable,
      read_address => pathsabove_memory_read_words_0_0_memory_read_address, read_data => pathsabove_memory_read_words_0_0,
      write_address => pathsabove_memory_read_words_0_0_memory_write_address, write_data => pathsabove_memory_read_words_0_0_memory_write_data);

  pathsleft_read_words_1_memory_read_enable <= true;
  pathsleft_read_words_1_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 2);
  pathsleft_read_words_1_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 2);
  pathsleft_read_words_1_memory_write_data <= to_unsigned(pathsleft_arrived(2), 7) & to_unsigned(pathsleft_arrived(1), 7);
  pathsleft_read_words_1_memory : entity work.line_memory
    generic map (depth => 4, width => 14, address_bits => 2)
    port map (
      clock => clock, read_enable => pathsleft_read_words_1_memory_read_enable,
      read_address => pathsleft_read_words_1_memory_read_address, read_data => pathsleft_read_words_1,
      write_address => pathsleft_read_words_1_memory_write_address, write_data => pathsleft_read_words_1_memory_write_data);

  pathsleft_read_words_0_memory_read_enable <= true;
  pathsleft_read_words_0_memory_read_address <= to_unsigned(pathsleft_read_count_phase, 2);
  pathsleft_read_words_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 2);
  pathsleft_read_words_0_memory_write_data <= to_unsigned(pathsleft_arrived(0), 7) & to_unsigned(pathsleft_cost(2), 7) & to_unsigned(pathsleft_cost(1), 7) & to_unsigned(pathsleft_cost(0), 7);
  pathsleft_read_words_0_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => pathsleft_read_words_0_memory_read_enable,
      read_address => pathsleft_read_words_0_memory_read_address, read_data => pathsleft_read_words_0,
      write_address => pathsleft_read_words_0_memory_write_address, write_data => pathsleft_read_words_0_memory_write_data);

  pathsleft_read_neighbour_0_memory_read_enable <= true;
  pathsleft_read_neighbour_0_memory_read_address <= to_unsigned(pathsleft_ahead_count_phase, 2);
  pathsleft_read_neighbour_0_memory_write_address <= to_unsigned(pathsleft_write_count_phase, 2);
  pathsleft_read_neighbour_0_memory_write_data <= to_unsigned(pathsleft_cost(0), 7);
  pathsleft_read_neighbour_0_memory : entity work.line_memory
    generic map (depth => 4, width => 7, address_bits => 2)
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
  paths_cost_delay_held_0_memory_read_address <= to_unsigned(paths_cost_delay_ring_read_address, 3);
  paths_cost_delay_held_0_memory_write_address <= to_unsigned(paths_cost_delay_ring_write_address, 3);
  paths_cost_delay_held_0_memory_write_data <= ((to_unsigned((costs_cost(2) mod 8), 3) & to_unsigned(costs_cost(0), 6)) or (to_unsigned(costs_cost(1), 6) & to_unsigned(0, 3)));
  paths_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 7, width => 9, address_bits => 3)
    port map (
      clock => clock, read_enable => paths_cost_delay_held_0_memory_read_enable,
      read_address => paths_cost_delay_held_0_memory_read_address, read_data => paths_cost_delay_held_0,
      write_address => paths_cost_delay_held_0_memory_write_address, write_data => paths_cost_delay_held_0_memory_write_data);

  relief_turned_0_memory_read_enable <= true;
  relief_turned_0_memory_read_address <= to_unsigned(line_order_address, 5);
  relief_turned_0_memory_write_address <= to_unsigned(relief_write_address, 5);
  relief_turned_0_memory_write_data <= to_unsigned(relief_write_turned_0, 6);
  relief_turned_0_memory : entity work.line_memory
    generic map (depth => 30, width => 6, address_bits => 5)
    port map (
      clock => clock, read_enable => relief_turned_0_memory_read_enable,
      read_address => relief_turned_0_memory_read_address, read_data => relief_turned_0,
      write_address => relief_turned_0_memory_write_address, write_data => relief_turned_0_memory_write_data);

  relief_rows_read_words_0_memory_read_enable <= true;
  relief_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  relief_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  relief_rows_read_words_0_memory_write_data <= to_unsigned(relief_rows_write_words_0, 6);
  relief_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 6, address_bits => 6)
    port map (
      clock => clock, read_enable => relief_rows_read_words_0_memory_read_enable,
      read_address => relief_rows_read_words_0_memory_read_address, read_data => relief_rows_read_words_0,
      write_address => relief_rows_read_words_0_memory_write_address, write_data => relief_rows_read_words_0_memory_write_data);

  relief_delayed_0_memory_read_enable <= true;
  relief_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  relief_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  relief_delayed_0_memory_write_data <= to_unsigned(relief_newest, 6);
  relief_delayed_0_memory : entity work.line_memory
    generic map (depth => 12, width => 6, address_bits => 4)
    port map (
      clock => clock, read_enable => relief_delayed_0_memory_read_enable,
      read_address => relief_delayed_0_memory_read_address, read_data => relief_delayed_0,
      write_address => relief_delayed_0_memory_write_address, write_data => relief_delayed_0_memory_write_data);

  costswindow_read_words_1_memory_read_enable <= true;
  costswindow_read_words_1_memory_read_address <= to_unsigned(costswindow_read_count_phase, 2);
  costswindow_read_words_1_memory_write_address <= to_unsigned(costswindow_write_count_phase, 2);
  costswindow_read_words_1_memory_write_data <= to_unsigned(costswindow_partials(5), 7) & to_unsigned(costswindow_partials(4), 7);
  costswindow_read_words_1_memory : entity work.line_memory
    generic map (depth => 4, width => 14, address_bits => 2)
    port map (
      clock => clock, read_enable => costswindow_read_words_1_memory_read_enable,
      read_address => costswindow_read_words_1_memory_read_address, read_data => costswindow_read_words_1,
      write_address => costswindow_read_words_1_memory_write_address, write_data => costswindow_read_words_1_memory_write_data);

  costswindow_read_words_0_memory_read_enable <= true;
  costswindow_read_words_0_memory_read_address <= to_unsigned(costswindow_read_count_phase, 2);
  costswindow_read_words_0_memory_write_address <= to_unsigned(costswindow_write_count_phase, 2);
  costswindow_read_words_0_memory_write_data <= to_unsigned(costswindow_partials(3), 7) & to_unsigned(costswindow_partial(2), 7) & to_unsigned(costswindow_partial(1), 7) & to_unsigned(costswindow_partial(0), 7);
  costswindow_read_words_0_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => costswindow_read_words_0_memory_read_enable,
      read_address => costswindow_read_words_0_memory_read_address, read_data => costswindow_read_words_0,
      write_address => costswindow_read_words_0_memory_write_address, write_data => costswindow_read_words_0_memory_write_data);

  costsshift_read_words_4_memory_read_enable <= true;
  costsshift_read_words_4_memory_read_address <= to_unsigned(costsshift_count_phase, 2);
  costsshift_read_words_4_memory_write_address <= to_unsigned(costsshift_write_phase, 2);
  costsshift_read_words_4_memory_write_data <= to_unsigned(costsshift_search(2, 2), 14);
  costsshift_read_words_4_memory : entity work.line_memory
    generic map (depth => 4, width => 14, address_bits => 2)
    port map (
      clock => clock, read_enable => costsshift_read_words_4_memory_read_enable,
      read_address => costsshift_read_words_4_memory_read_address, read_data => costsshift_read_words_4,
      write_address => costsshift_read_words_4_memory_write_address, write_data => costsshift_read_words_4_memory_write_data);

  costsshift_read_words_3_memory_read_enable <= true;
  costsshift_read_words_3_memory_read_address <= to_unsigned(costsshift_count_phase, 2);
  costsshift_read_words_3_memory_write_address <= to_unsigned(costsshift_write_phase, 2);
  costsshift_read_words_3_memory_write_data <= to_unsigned(costsshift_search(2, 1), 14) & to_unsigned(costsshift_search(2, 0), 14);
  costsshift_read_words_3_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => costsshift_read_words_3_memory_read_enable,
      read_address => costsshift_read_words_3_memory_read_address, read_data => costsshift_read_words(3),
      write_address => costsshift_read_words_3_memory_write_address, write_data => costsshift_read_words_3_memory_write_data);

  costsshift_read_words_2_memory_read_enable <= true;
  costsshift_read_words_2_memory_read_address <= to_unsigned(costsshift_count_phase, 2);
  costsshift_read_words_2_memory_write_address <= to_unsigned(costsshift_write_phase, 2);
  costsshift_read_words_2_memory_write_data <= to_unsigned(costsshift_search(1, 2), 14) & to_unsigned(costsshift_search(1, 1), 14);
  costsshift_read_words_2_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => costsshift_read_words_2_memory_read_enable,
      read_address => costsshift_read_words_2_memory_read_address, read_data => costsshift_read_words(2),
      write_address => costsshift_read_words_2_memory_write_address, write_data => costsshift_read_words_2_memory_write_data);

  costsshift_read_words_1_memory_read_enable <= true;
  costsshift_read_words_1_memory_read_address <= to_unsigned(costsshift_count_phase, 2);
  costsshift_read_words_1_memory_write_address <= to_unsigned(costsshift_write_phase, 2);
  costsshift_read_words_1_memory_write_data <= to_unsigned(costsshift_search(1, 0), 14) & to_unsigned(costsshift_search(0, 2), 14);
  costsshift_read_words_1_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => costsshift_read_words_1_memory_read_enable,
      read_address => costsshift_read_words_1_memory_read_address, read_data => costsshift_read_words(1),
      write_address => costsshift_read_words_1_memory_write_address, write_data => costsshift_read_words_1_memory_write_data);

  costsshift_read_words_0_memory_read_enable <= true;
  costsshift_read_words_0_memory_read_address <= to_unsigned(costsshift_count_phase, 2);
  costsshift_read_words_0_memory_write_address <= to_unsigned(costsshift_write_phase, 2);
  costsshift_read_words_0_memory_write_data <= to_unsigned(costsshift_search(0, 1), 14) & to_unsigned(costsshift_search(0, 0), 14);
  costsshift_read_words_0_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => costsshift_read_words_0_memory_read_enable,
      read_address => costsshift_read_words_0_memory_read_address, read_data => costsshift_read_words(0),
      write_address => costsshift_read_words_0_memory_write_address, write_data => costsshift_read_words_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 14);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 12, width => 14, address_bits => 4)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_next_frame_choice : boolean;
    variable transform_counter_next_frame_choices : boolean_1d(2 to 3);  -- transform_counter_next_frame_choice_#
    variable transform_read_column_inside_0_value : boolean;
    variable transform_read_column_inside_0_values : boolean_1d(2 to 3);  -- transform_read_column_inside_0_value_#
    variable transform_read_column_inside_2_is_equal, transform_read_column_inside_2_differs : boolean;
    variable transform_read_column_inside_6_choice, transform_left_filter_feature_0_any : boolean;
    variable transform_left_filter_feature_0_choice, transform_left_filter_feature_0_is_equal : boolean;
    variable transform_left_filter_feature_0_choices : boolean_1d(2 to 16);  -- transform_left_filter_feature_0_choice_#
    variable transform_left_filter_feature_0_value : boolean;
    variable transform_left_filter_feature_0_values : boolean_1d(2 to 5);  -- transform_left_filter_feature_0_value_#
    variable transform_left_filter_feature_0_choices_from_18 : boolean_1d(18 to 121);  -- transform_left_filter_feature_0_choice_#
    variable transform_left_filter_feature_0_all : boolean;
    variable transform_left_filter_feature_0_alls : boolean_1d(2 to 4);  -- transform_left_filter_feature_0_all_#
    variable transform_right_filter_feature_0_any, transform_right_filter_feature_0_choice : boolean;
    variable transform_right_filter_feature_0_is_equal : boolean;
    variable transform_right_filter_feature_0_choices : boolean_1d(2 to 16);  -- transform_right_filter_feature_0_choice_#
    variable transform_right_filter_feature_0_value : boolean;
    variable transform_right_filter_feature_0_values : boolean_1d(2 to 5);  -- transform_right_filter_feature_0_value_#
    variable transform_right_filter_feature_0_choices_from_18 : boolean_1d(18 to 125);  -- transform_right_filter_feature_0_choice_#
    variable transform_right_filter_feature_0_all : boolean;
    variable transform_right_filter_feature_0_alls : boolean_1d(2 to 4);  -- transform_right_filter_feature_0_all_#
    variable raster_place_group_is_equal : boolean;
    variable raster_place_group_is_equals : boolean_1d(2 to 3);  -- raster_place_group_is_equal_#
    variable raster_place_group_all, raster_place_group_choice_2, raster_place_next_frame_choice : boolean;
    variable raster_place_next_frame_choice_2, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less : boolean;
    variable delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less : boolean;
    variable line_order_address_any, line_order_falls_all, line_order_turned_output_column_choice : boolean;
    variable costsshift_search_0_0_is_equal : boolean;
    variable costscolumn_pixels_first_0_count_value : boolean_2d(0 to 2, 0 to 4);  -- costscolumn_pixels_first_#_0_count_#_value
    variable costscolumn_pixels_first_0_count_value_2 : boolean_2d(0 to 2, 0 to 3);  -- costscolumn_pixels_first_#_0_count_#_value_2
    variable costscolumn_pixels_first_0_count_1_value_3 : boolean_1d(0 to 2);  -- costscolumn_pixels_first_#_0_count_1_value_3
    variable costscolumn_pixels_first_0_count_3_value_3 : boolean_1d(0 to 2);  -- costscolumn_pixels_first_#_0_count_3_value_3
    variable costswindow_partial_0_any, pathsleft_read_count_phase_is_equal, pathsleft_passes_by_is_equal : boolean;
    variable pathsleft_passes_by_choice, pathsleft_passes_by_choice_2 : boolean;
    variable pathsleft_stay_value : boolean_1d(0 to 2);  -- pathsleft_stay_#_value
    variable pathsleft_stay_0_values : boolean_1d(2 to 11);  -- pathsleft_stay_0_value_#
    variable pathsleft_stay_0_is_equal : boolean;
    variable pathsleft_stay_choice : boolean_1d(0 to 2);  -- pathsleft_stay_#_choice
    variable pathsleft_stay_choices : boolean_2d(0 to 2, 2 to 15);  -- pathsleft_stay_#_choice_#
    variable pathsleft_stay_2_value_2, pathsleft_cost_0_any, pathsabove_ready_top_choice : boolean;
    variable pathsabove_ready_top_choice_2, pathsabove_count_phase_is_equal : boolean;
    variable pathsright_stay_value : boolean_1d(0 to 2);  -- pathsright_stay_#_value
    variable pathsright_stay_0_values : boolean_1d(2 to 11);  -- pathsright_stay_0_value_#
    variable pathsright_stay_0_is_equal : boolean;
    variable pathsright_stay_choice : boolean_1d(0 to 2);  -- pathsright_stay_#_choice
    variable pathsright_stay_choices : boolean_2d(0 to 2, 2 to 15);  -- pathsright_stay_#_choice_#
    variable pathsright_stay_2_value_2, winnerswinner1_best_index_0_0_choice : boolean;
    variable winnerswinner1_best_index_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner1_best_index_0_0_choice_#
    variable winnerswinner1_best_index_0_0_value : boolean;
    variable winnerswinner1_best_index_0_0_values : boolean_1d(2 to 5);  -- winnerswinner1_best_index_0_0_value_#
    variable winnerswinner2_best_index_0_0_choice : boolean;
    variable winnerswinner2_best_index_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner2_best_index_0_0_choice_#
    variable winnerswinner2_best_index_0_0_value : boolean;
    variable winnerswinner2_best_index_0_0_values : boolean_1d(2 to 5);  -- winnerswinner2_best_index_0_0_value_#
    variable winners_best_cost_0_0_is_less, turn_order_address_any, turn_order_address_any_2 : boolean;
    variable turn_order_falls_all, turn_order_complete_all, turn_order_turned_output_column_choice : boolean;
    variable relief_newest_choice : boolean;
    variable relief_newest_choices : boolean_1d(2 to 16);  -- relief_newest_choice_#
    variable relief_newest_value : boolean;
    variable relief_newest_values : boolean_1d(2 to 5);  -- relief_newest_value_#
    variable transform_counter_group_choice, transform_left_filter_feature_0_choice_17 : natural range 0 to 3;
    variable transform_right_filter_feature_0_choice_17, raster_place_group_choice : natural range 0 to 3;
    variable costsshift_count_phase_choice, costswindow_read_count_phase_choice : natural range 0 to 3;
    variable costswindow_write_count_phase_choice, pathsleft_read_count_phase_choice : natural range 0 to 3;
    variable pathsleft_ahead_count_phase_choice, pathsleft_write_count_phase_choice : natural range 0 to 3;
    variable pathsabove_read_address_count_phase_choice, pathsabove_count_phase_choice : natural range 0 to 3;
    variable pathsabove_write_address_count_phase_choice : natural range 0 to 3;
    variable pathsturn_write_address_count_phase_choice : natural range 0 to 3;
    variable transform_counter_group_choices : natural_15_1d(2 to 3);  -- transform_counter_group_choice_#
    variable raster_place_group_choices : natural_15_1d(3 to 4);  -- raster_place_group_choice_#
    variable line_order_address_choice, turn_order_address_choice : natural range 1 to 31;
    variable line_order_address_choice_2, pathsleft_stay_change_1_value : natural range 0 to 7;
    variable pathsright_stay_change_1_value, turn_order_address_choice_2 : natural range 0 to 7;
    variable paths_smallest_cost_choice : natural range 0 to 21;
    variable pathsleft_lower_neighbour_value : natural range 0 to 127;
    variable pathsleft_stay_choice_16 : natural_127_1d(0 to 2);  -- pathsleft_stay_#_choice_16
    variable pathsleft_stay_1_value_2 : natural range 0 to 127;
    variable pathsleft_step_choice : natural_127_1d(0 to 2);  -- pathsleft_step_#_choice
    variable pathsleft_step_0_choice_2 : natural range 0 to 127;
    variable pathsleft_step_2_choices : natural_127_1d(2 to 3);  -- pathsleft_step_2_choice_#
    variable pathsleft_low_0_choice, pathsabove_memory_read_address_0_choice : natural range 0 to 127;
    variable pathsabove_write_address_address_choice, pathsright_lower_neighbour_value : natural range 0 to 127;
    variable pathsright_stay_choice_16 : natural_127_1d(0 to 2);  -- pathsright_stay_#_choice_16
    variable pathsright_stay_1_value_2 : natural range 0 to 127;
    variable pathsright_step_choice : natural_127_1d(0 to 2);  -- pathsright_step_#_choice
    variable pathsright_step_0_choice_2 : natural range 0 to 127;
    variable pathsright_step_2_choices : natural_127_1d(2 to 3);  -- pathsright_step_2_choice_#
    variable pathsright_low_0_choice : natural range 0 to 127;
    variable pathsleft_q_choice, pathsleft_q_choice_2, pathsleft_room_left_choice : natural range 0 to 63;
    variable pathsabove_smallest_total_choice, pathsabove_beside_0_choice : natural range 0 to 63;
    variable pathsabove_beside_2_choice, pathsright_q_choice, pathsright_q_choice_2 : natural range 0 to 63;
    variable pathsright_room_left_choice, relief_newest_choice_17 : natural range 0 to 63;
    variable pathsabove_total_choice : natural_31_1d(0 to 2);  -- pathsabove_total_#_choice
    variable pathsabove_memory_write_words_0_0_choice : natural range 0 to 31;
    variable pathsabove_memory_write_words_0_0_choices : natural_31_1d(2 to 3);  -- pathsabove_memory_write_words_0_0_choice_#
    variable pathsturn_sum_memory_write_words_0_0_sum : natural range 0 to 190;
    variable winners_best_cost_0_0_choice : natural range 0 to 511;
    variable winners_best_cost_0_0_choice_2 : natural range 0 to 255;
    variable relief_newest_values_from_6 : natural_255_1d(6 to 7);  -- relief_newest_value_#
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
      if transform_counter_next_frame and (transform_counter_group = 13) then
        transform_counter_group_choices(2) := 2;
      else
        transform_counter_group_choices(2) := (transform_counter_group + 1) mod 16;
      end if;
      if (transform_counter_group /= 14) and transform_counter_group_is_equal and in_valid then
        transform_counter_group_choices(3) := transform_counter_group_choices(2);
      else
        transform_counter_group_choices(3) := transform_counter_group;
      end if;
      if transform_counter_group_is_equal and ((transform_counter_group / 2) = 6) then
        transform_counter_next_frame_choice := transform_counter_next_frame and (not is_set(transform_counter_group,
          0));
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_all then
        transform_counter_next_frame_choices(2) := in_valid;
      else
        transform_counter_next_frame_choices(2) := in_valid and (not in_start_of_frame);
      end if;
      if transform_counter_next_frame_choice then
        transform_counter_next_frame_choices(3) := transform_counter_next_frame_choices(2);
      else
        transform_counter_next_frame_choices(3) := transform_counter_group_is_equal and
          transform_counter_group_is_equal_2 and in_valid and in_start_of_frame;
      end if;
      transform_read_column_inside_0_value := is_set(transform_counter_column, 4);
      transform_read_column_inside_0_values(2) := is_set(transform_counter_column, 3);
      transform_read_column_inside_0_values(3) := is_set(transform_counter_column, 2);
      transform_read_column_inside_2_is_equal := (transform_counter_column / 4) = 0;
      transform_read_column_inside_2_differs := (transform_counter_column / 4) /= 0;
      if is_set(transform_counter_column, 1) then
        transform_read_column_inside_6_choice := (not is_set(transform_counter_column, 5)) and (not
          transform_read_column_inside_0_value) and (not transform_read_column_inside_0_values(3));
      else
        transform_read_column_inside_6_choice := (transform_counter_column / 16) = 0;
      end if;
      transform_left_filter_feature_0_any := (not is_set(transform_left_filter_column_2(4), 1)) or (not
        is_set(transform_left_filter_column_2(4), 0));
      if is_set(transform_left_filter_column_0(4), 0) then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_2(4) mod 4) = 0;
      if is_set(transform_left_filter_column_0(4), 1) then
        transform_left_filter_feature_0_choices(2) := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choices(2) := is_set(transform_left_filter_column_0(4), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value := is_set(transform_left_filter_column_2(4), 2);
      if transform_left_filter_feature_0_choices(2) then
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column_0(4), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column_0(4), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 2 to 5 loop
        transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column_2(4), i + 1);
        if transform_left_filter_feature_0_choices(i + 1) then
          transform_left_filter_feature_0_choices(i + 2) := (not is_set(transform_left_filter_column_0(4), i + 1)) or
            transform_left_filter_feature_0_values(i);
        else
          transform_left_filter_feature_0_choices(i + 2) := (not is_set(transform_left_filter_column_0(4), i + 1)) and
            transform_left_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(7) then
        transform_left_filter_feature_0_choices(8) := is_set(transform_left_filter_column_0(4), 7) and (not
          is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(8) := is_set(transform_left_filter_column_0(4), 7) or (not
          is_set(transform_left_filter_column_2(4), 7));
      end if;
      if is_set(transform_left_filter_column_4(4), 0) then
        transform_left_filter_feature_0_choices(9) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(9) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_4(4), 1) then
        transform_left_filter_feature_0_choices(10) := transform_left_filter_feature_0_choices(9);
      else
        transform_left_filter_feature_0_choices(10) := is_set(transform_left_filter_column_4(4), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(10) then
        transform_left_filter_feature_0_choices(11) := (not is_set(transform_left_filter_column_4(4), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(11) := (not is_set(transform_left_filter_column_4(4), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 11 to 14 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(4), i - 8)) or
            transform_left_filter_feature_0_values(i - 9);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(4), i - 8)) and
            transform_left_filter_feature_0_values(i - 9);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(15) then
        transform_left_filter_feature_0_choices(16) := is_set(transform_left_filter_column_4(4), 7) and (not
          is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(16) := is_set(transform_left_filter_column_4(4), 7) or (not
          is_set(transform_left_filter_column_2(4), 7));
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0_choice_17 := as_number(transform_left_filter_feature_0_choices(8)) +
          (as_number(transform_left_filter_feature_0_choices(16)) * 2);
      else
        transform_left_filter_feature_0_choice_17 := 0;
      end if;
      if is_set(transform_left_filter_column_2(0), 0) then
        transform_left_filter_feature_0_choices_from_18(18) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(18) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_2(0), 1) then
        transform_left_filter_feature_0_choices_from_18(19) := transform_left_filter_feature_0_choices_from_18(18);
      else
        transform_left_filter_feature_0_choices_from_18(19) := is_set(transform_left_filter_column_2(0), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(19) then
        transform_left_filter_feature_0_choices_from_18(20) := (not is_set(transform_left_filter_column_2(0), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(20) := (not is_set(transform_left_filter_column_2(0), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 20 to 23 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(0), i -
            17)) or transform_left_filter_feature_0_values(i - 18);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(0), i -
            17)) and transform_left_filter_feature_0_values(i - 18);
        end if;
      end loop;
      transform_left_filter_feature_0_all := transform_filtering_0_column_inside_0 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(0), 7) then
        transform_left_filter_feature_0_choices_from_18(25) := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choices_from_18(25) := transform_left_filter_feature_0_all;
      end if;
      if transform_left_filter_feature_0_choices_from_18(24) then
        transform_left_filter_feature_0_choices_from_18(26) := is_set(transform_left_filter_column_2(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(26) := transform_left_filter_feature_0_choices_from_18(25);
      end if;
      if is_set(transform_left_filter_column_0(0), 0) then
        transform_left_filter_feature_0_choices_from_18(27) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(27) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_0(0), 1) then
        transform_left_filter_feature_0_choices_from_18(28) := transform_left_filter_feature_0_choices_from_18(27);
      else
        transform_left_filter_feature_0_choices_from_18(28) := is_set(transform_left_filter_column_0(0), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(28) then
        transform_left_filter_feature_0_choices_from_18(29) := (not is_set(transform_left_filter_column_0(0), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(29) := (not is_set(transform_left_filter_column_0(0), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 29 to 32 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(0), i -
            26)) or transform_left_filter_feature_0_values(i - 27);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(0), i -
            26)) and transform_left_filter_feature_0_values(i - 27);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(0), 7) then
        transform_left_filter_feature_0_choices_from_18(34) := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choices_from_18(34) := transform_left_filter_feature_0_all;
      end if;
      if transform_left_filter_feature_0_choices_from_18(33) then
        transform_left_filter_feature_0_choices_from_18(35) := is_set(transform_left_filter_column_0(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(35) := transform_left_filter_feature_0_choices_from_18(34);
      end if;
      if is_set(transform_left_filter_column_4(0), 0) then
        transform_left_filter_feature_0_choices_from_18(36) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(36) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_4(0), 1) then
        transform_left_filter_feature_0_choices_from_18(37) := transform_left_filter_feature_0_choices_from_18(36);
      else
        transform_left_filter_feature_0_choices_from_18(37) := is_set(transform_left_filter_column_4(0), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(37) then
        transform_left_filter_feature_0_choices_from_18(38) := (not is_set(transform_left_filter_column_4(0), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(38) := (not is_set(transform_left_filter_column_4(0), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 38 to 41 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(0), i -
            35)) or transform_left_filter_feature_0_values(i - 36);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(0), i -
            35)) and transform_left_filter_feature_0_values(i - 36);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices_from_18(42) then
        transform_left_filter_feature_0_choices_from_18(43) := transform_filtering_0_column_inside_0 and
          is_set(transform_left_filter_column_4(0), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(43) := transform_filtering_0_column_inside_0 and
          (is_set(transform_left_filter_column_4(0), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(2), 0) then
        transform_left_filter_feature_0_choices_from_18(44) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(44) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_2(2), 1) then
        transform_left_filter_feature_0_choices_from_18(45) := transform_left_filter_feature_0_choices_from_18(44);
      else
        transform_left_filter_feature_0_choices_from_18(45) := is_set(transform_left_filter_column_2(2), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(45) then
        transform_left_filter_feature_0_choices_from_18(46) := (not is_set(transform_left_filter_column_2(2), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(46) := (not is_set(transform_left_filter_column_2(2), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 46 to 49 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(2), i -
            43)) or transform_left_filter_feature_0_values(i - 44);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(2), i -
            43)) and transform_left_filter_feature_0_values(i - 44);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(2) := transform_filtering_0_column_inside_2 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(2), 7) then
        transform_left_filter_feature_0_choices_from_18(51) := transform_filtering_0_column_inside_2;
      else
        transform_left_filter_feature_0_choices_from_18(51) := transform_left_filter_feature_0_alls(2);
      end if;
      if transform_left_filter_feature_0_choices_from_18(50) then
        transform_left_filter_feature_0_choices_from_18(52) := is_set(transform_left_filter_column_2(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(52) := transform_left_filter_feature_0_choices_from_18(51);
      end if;
      if is_set(transform_left_filter_column_0(2), 0) then
        transform_left_filter_feature_0_choices_from_18(53) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(53) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_0(2), 1) then
        transform_left_filter_feature_0_choices_from_18(54) := transform_left_filter_feature_0_choices_from_18(53);
      else
        transform_left_filter_feature_0_choices_from_18(54) := is_set(transform_left_filter_column_0(2), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(54) then
        transform_left_filter_feature_0_choices_from_18(55) := (not is_set(transform_left_filter_column_0(2), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(55) := (not is_set(transform_left_filter_column_0(2), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 55 to 58 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(2), i -
            52)) or transform_left_filter_feature_0_values(i - 53);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(2), i -
            52)) and transform_left_filter_feature_0_values(i - 53);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(2), 7) then
        transform_left_filter_feature_0_choices_from_18(60) := transform_filtering_0_column_inside_2;
      else
        transform_left_filter_feature_0_choices_from_18(60) := transform_left_filter_feature_0_alls(2);
      end if;
      if transform_left_filter_feature_0_choices_from_18(59) then
        transform_left_filter_feature_0_choices_from_18(61) := is_set(transform_left_filter_column_0(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(61) := transform_left_filter_feature_0_choices_from_18(60);
      end if;
      if is_set(transform_left_filter_column_4(2), 0) then
        transform_left_filter_feature_0_choices_from_18(62) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(62) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_4(2), 1) then
        transform_left_filter_feature_0_choices_from_18(63) := transform_left_filter_feature_0_choices_from_18(62);
      else
        transform_left_filter_feature_0_choices_from_18(63) := is_set(transform_left_filter_column_4(2), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(63) then
        transform_left_filter_feature_0_choices_from_18(64) := (not is_set(transform_left_filter_column_4(2), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(64) := (not is_set(transform_left_filter_column_4(2), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 64 to 67 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(2), i -
            61)) or transform_left_filter_feature_0_values(i - 62);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(2), i -
            61)) and transform_left_filter_feature_0_values(i - 62);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices_from_18(68) then
        transform_left_filter_feature_0_choices_from_18(69) := transform_filtering_0_column_inside_2 and
          is_set(transform_left_filter_column_4(2), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(69) := transform_filtering_0_column_inside_2 and
          (is_set(transform_left_filter_column_4(2), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(6), 0) then
        transform_left_filter_feature_0_choices_from_18(70) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(70) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_2(6), 1) then
        transform_left_filter_feature_0_choices_from_18(71) := transform_left_filter_feature_0_choices_from_18(70);
      else
        transform_left_filter_feature_0_choices_from_18(71) := is_set(transform_left_filter_column_2(6), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(71) then
        transform_left_filter_feature_0_choices_from_18(72) := (not is_set(transform_left_filter_column_2(6), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(72) := (not is_set(transform_left_filter_column_2(6), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 72 to 75 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(6), i -
            69)) or transform_left_filter_feature_0_values(i - 70);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(6), i -
            69)) and transform_left_filter_feature_0_values(i - 70);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(3) := transform_filtering_0_column_inside_6 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(6), 7) then
        transform_left_filter_feature_0_choices_from_18(77) := transform_filtering_0_column_inside_6;
      else
        transform_left_filter_feature_0_choices_from_18(77) := transform_left_filter_feature_0_alls(3);
      end if;
      if transform_left_filter_feature_0_choices_from_18(76) then
        transform_left_filter_feature_0_choices_from_18(78) := is_set(transform_left_filter_column_2(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(78) := transform_left_filter_feature_0_choices_from_18(77);
      end if;
      if is_set(transform_left_filter_column_0(6), 0) then
        transform_left_filter_feature_0_choices_from_18(79) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(79) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_0(6), 1) then
        transform_left_filter_feature_0_choices_from_18(80) := transform_left_filter_feature_0_choices_from_18(79);
      else
        transform_left_filter_feature_0_choices_from_18(80) := is_set(transform_left_filter_column_0(6), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(80) then
        transform_left_filter_feature_0_choices_from_18(81) := (not is_set(transform_left_filter_column_0(6), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(81) := (not is_set(transform_left_filter_column_0(6), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 81 to 84 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(6), i -
            78)) or transform_left_filter_feature_0_values(i - 79);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(6), i -
            78)) and transform_left_filter_feature_0_values(i - 79);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(6), 7) then
        transform_left_filter_feature_0_choices_from_18(86) := transform_filtering_0_column_inside_6;
      else
        transform_left_filter_feature_0_choices_from_18(86) := transform_left_filter_feature_0_alls(3);
      end if;
      if transform_left_filter_feature_0_choices_from_18(85) then
        transform_left_filter_feature_0_choices_from_18(87) := is_set(transform_left_filter_column_0(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(87) := transform_left_filter_feature_0_choices_from_18(86);
      end if;
      if is_set(transform_left_filter_column_4(6), 0) then
        transform_left_filter_feature_0_choices_from_18(88) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(88) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_4(6), 1) then
        transform_left_filter_feature_0_choices_from_18(89) := transform_left_filter_feature_0_choices_from_18(88);
      else
        transform_left_filter_feature_0_choices_from_18(89) := is_set(transform_left_filter_column_4(6), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(89) then
        transform_left_filter_feature_0_choices_from_18(90) := (not is_set(transform_left_filter_column_4(6), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(90) := (not is_set(transform_left_filter_column_4(6), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 90 to 93 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(6), i -
            87)) or transform_left_filter_feature_0_values(i - 88);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(6), i -
            87)) and transform_left_filter_feature_0_values(i - 88);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices_from_18(94) then
        transform_left_filter_feature_0_choices_from_18(95) := transform_filtering_0_column_inside_6 and
          is_set(transform_left_filter_column_4(6), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(95) := transform_filtering_0_column_inside_6 and
          (is_set(transform_left_filter_column_4(6), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(8), 0) then
        transform_left_filter_feature_0_choices_from_18(96) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(96) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_2(8), 1) then
        transform_left_filter_feature_0_choices_from_18(97) := transform_left_filter_feature_0_choices_from_18(96);
      else
        transform_left_filter_feature_0_choices_from_18(97) := is_set(transform_left_filter_column_2(8), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(97) then
        transform_left_filter_feature_0_choices_from_18(98) := (not is_set(transform_left_filter_column_2(8), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(98) := (not is_set(transform_left_filter_column_2(8), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 98 to 101 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(8), i -
            95)) or transform_left_filter_feature_0_values(i - 96);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(8), i -
            95)) and transform_left_filter_feature_0_values(i - 96);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(4) := transform_filtering_0_column_inside_8 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(8), 7) then
        transform_left_filter_feature_0_choices_from_18(103) := transform_filtering_0_column_inside_8;
      else
        transform_left_filter_feature_0_choices_from_18(103) := transform_left_filter_feature_0_alls(4);
      end if;
      if transform_left_filter_feature_0_choices_from_18(102) then
        transform_left_filter_feature_0_choices_from_18(104) := is_set(transform_left_filter_column_2(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(104) := transform_left_filter_feature_0_choices_from_18(103);
      end if;
      if is_set(transform_left_filter_column_0(8), 0) then
        transform_left_filter_feature_0_choices_from_18(105) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(105) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_0(8), 1) then
        transform_left_filter_feature_0_choices_from_18(106) := transform_left_filter_feature_0_choices_from_18(105);
      else
        transform_left_filter_feature_0_choices_from_18(106) := is_set(transform_left_filter_column_0(8), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(106) then
        transform_left_filter_feature_0_choices_from_18(107) := (not is_set(transform_left_filter_column_0(8), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(107) := (not is_set(transform_left_filter_column_0(8), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 107 to 110 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(8), i -
            104)) or transform_left_filter_feature_0_values(i - 105);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(8), i -
            104)) and transform_left_filter_feature_0_values(i - 105);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(8), 7) then
        transform_left_filter_feature_0_choices_from_18(112) := transform_filtering_0_column_inside_8;
      else
        transform_left_filter_feature_0_choices_from_18(112) := transform_left_filter_feature_0_alls(4);
      end if;
      if transform_left_filter_feature_0_choices_from_18(111) then
        transform_left_filter_feature_0_choices_from_18(113) := is_set(transform_left_filter_column_0(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(113) := transform_left_filter_feature_0_choices_from_18(112);
      end if;
      if is_set(transform_left_filter_column_4(8), 0) then
        transform_left_filter_feature_0_choices_from_18(114) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(114) := not is_set(transform_left_filter_column_2(4), 1);
      end if;
      if is_set(transform_left_filter_column_4(8), 1) then
        transform_left_filter_feature_0_choices_from_18(115) := transform_left_filter_feature_0_choices_from_18(114);
      else
        transform_left_filter_feature_0_choices_from_18(115) := is_set(transform_left_filter_column_4(8), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(115) then
        transform_left_filter_feature_0_choices_from_18(116) := (not is_set(transform_left_filter_column_4(8), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices_from_18(116) := (not is_set(transform_left_filter_column_4(8), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 116 to 119 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(8), i -
            113)) or transform_left_filter_feature_0_values(i - 114);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(8), i -
            113)) and transform_left_filter_feature_0_values(i - 114);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices_from_18(120) then
        transform_left_filter_feature_0_choices_from_18(121) := transform_filtering_0_column_inside_8 and
          is_set(transform_left_filter_column_4(8), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(121) := transform_filtering_0_column_inside_8 and
          (is_set(transform_left_filter_column_4(8), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      transform_right_filter_feature_0_any := (not is_set(transform_right_filter_column_2(4), 1)) or (not
        is_set(transform_right_filter_column_2(4), 0));
      if is_set(transform_right_filter_column_0(4), 0) then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_2(4) mod 4) = 0;
      if is_set(transform_right_filter_column_0(4), 1) then
        transform_right_filter_feature_0_choices(2) := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choices(2) := is_set(transform_right_filter_column_0(4), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value := is_set(transform_right_filter_column_2(4), 2);
      if transform_right_filter_feature_0_choices(2) then
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column_0(4), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column_0(4), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 2 to 5 loop
        transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column_2(4), i + 1);
        if transform_right_filter_feature_0_choices(i + 1) then
          transform_right_filter_feature_0_choices(i + 2) := (not is_set(transform_right_filter_column_0(4), i + 1)) or
            transform_right_filter_feature_0_values(i);
        else
          transform_right_filter_feature_0_choices(i + 2) := (not is_set(transform_right_filter_column_0(4), i + 1))
            and transform_right_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_right_filter_feature_0_choices(7) then
        transform_right_filter_feature_0_choices(8) := is_set(transform_right_filter_column_0(4), 7) and (not
          is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices(8) := is_set(transform_right_filter_column_0(4), 7) or (not
          is_set(transform_right_filter_column_2(4), 7));
      end if;
      if is_set(transform_right_filter_column_4(4), 0) then
        transform_right_filter_feature_0_choices(9) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(9) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_4(4), 1) then
        transform_right_filter_feature_0_choices(10) := transform_right_filter_feature_0_choices(9);
      else
        transform_right_filter_feature_0_choices(10) := is_set(transform_right_filter_column_4(4), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(10) then
        transform_right_filter_feature_0_choices(11) := (not is_set(transform_right_filter_column_4(4), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(11) := (not is_set(transform_right_filter_column_4(4), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 11 to 14 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(4), i - 8)) or
            transform_right_filter_feature_0_values(i - 9);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(4), i - 8))
            and transform_right_filter_feature_0_values(i - 9);
        end if;
      end loop;
      if transform_right_filter_feature_0_choices(15) then
        transform_right_filter_feature_0_choices(16) := is_set(transform_right_filter_column_4(4), 7) and (not
          is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices(16) := is_set(transform_right_filter_column_4(4), 7) or (not
          is_set(transform_right_filter_column_2(4), 7));
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_0_choice_17 := as_number(transform_right_filter_feature_0_choices(8)) +
          (as_number(transform_right_filter_feature_0_choices(16)) * 2);
      else
        transform_right_filter_feature_0_choice_17 := 0;
      end if;
      if is_set(transform_right_filter_column_2(0), 0) then
        transform_right_filter_feature_0_choices_from_18(18) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(18) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_2(0), 1) then
        transform_right_filter_feature_0_choices_from_18(19) := transform_right_filter_feature_0_choices_from_18(18);
      else
        transform_right_filter_feature_0_choices_from_18(19) := is_set(transform_right_filter_column_2(0), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(19) then
        transform_right_filter_feature_0_choices_from_18(20) := (not is_set(transform_right_filter_column_2(0), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(20) := (not is_set(transform_right_filter_column_2(0), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 20 to 23 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(0), i
            - 17)) or transform_right_filter_feature_0_values(i - 18);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(0), i
            - 17)) and transform_right_filter_feature_0_values(i - 18);
        end if;
      end loop;
      transform_right_filter_feature_0_all := transform_filtering_0_column_inside_0 and (not
        is_set(transform_right_filter_column_2(4), 7));
      if is_set(transform_right_filter_column_2(0), 7) then
        transform_right_filter_feature_0_choices_from_18(25) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices_from_18(25) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices_from_18(24) then
        transform_right_filter_feature_0_choices_from_18(26) := is_set(transform_right_filter_column_2(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(26) := transform_right_filter_feature_0_choices_from_18(25);
      end if;
      if is_set(transform_right_filter_column_0(0), 0) then
        transform_right_filter_feature_0_choices_from_18(27) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(27) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_0(0), 1) then
        transform_right_filter_feature_0_choices_from_18(28) := transform_right_filter_feature_0_choices_from_18(27);
      else
        transform_right_filter_feature_0_choices_from_18(28) := is_set(transform_right_filter_column_0(0), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(28) then
        transform_right_filter_feature_0_choices_from_18(29) := (not is_set(transform_right_filter_column_0(0), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(29) := (not is_set(transform_right_filter_column_0(0), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 29 to 32 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(0), i
            - 26)) or transform_right_filter_feature_0_values(i - 27);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(0), i
            - 26)) and transform_right_filter_feature_0_values(i - 27);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(0), 7) then
        transform_right_filter_feature_0_choices_from_18(34) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices_from_18(34) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices_from_18(33) then
        transform_right_filter_feature_0_choices_from_18(35) := is_set(transform_right_filter_column_0(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(35) := transform_right_filter_feature_0_choices_from_18(34);
      end if;
      if is_set(transform_right_filter_column_4(0), 0) then
        transform_right_filter_feature_0_choices_from_18(36) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(36) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_4(0), 1) then
        transform_right_filter_feature_0_choices_from_18(37) := transform_right_filter_feature_0_choices_from_18(36);
      else
        transform_right_filter_feature_0_choices_from_18(37) := is_set(transform_right_filter_column_4(0), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(37) then
        transform_right_filter_feature_0_choices_from_18(38) := (not is_set(transform_right_filter_column_4(0), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(38) := (not is_set(transform_right_filter_column_4(0), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 38 to 41 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(0), i
            - 35)) or transform_right_filter_feature_0_values(i - 36);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(0), i
            - 35)) and transform_right_filter_feature_0_values(i - 36);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(0), 7) then
        transform_right_filter_feature_0_choices_from_18(43) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices_from_18(43) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices_from_18(42) then
        transform_right_filter_feature_0_choices_from_18(44) := is_set(transform_right_filter_column_4(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(44) := transform_right_filter_feature_0_choices_from_18(43);
      end if;
      if is_set(transform_right_filter_column_2(2), 0) then
        transform_right_filter_feature_0_choices_from_18(45) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(45) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_2(2), 1) then
        transform_right_filter_feature_0_choices_from_18(46) := transform_right_filter_feature_0_choices_from_18(45);
      else
        transform_right_filter_feature_0_choices_from_18(46) := is_set(transform_right_filter_column_2(2), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(46) then
        transform_right_filter_feature_0_choices_from_18(47) := (not is_set(transform_right_filter_column_2(2), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(47) := (not is_set(transform_right_filter_column_2(2), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 47 to 50 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(2), i
            - 44)) or transform_right_filter_feature_0_values(i - 45);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(2), i
            - 44)) and transform_right_filter_feature_0_values(i - 45);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(2) := transform_filtering_0_column_inside_2 and (not
        is_set(transform_right_filter_column_2(4), 7));
      if is_set(transform_right_filter_column_2(2), 7) then
        transform_right_filter_feature_0_choices_from_18(52) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices_from_18(52) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices_from_18(51) then
        transform_right_filter_feature_0_choices_from_18(53) := is_set(transform_right_filter_column_2(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(53) := transform_right_filter_feature_0_choices_from_18(52);
      end if;
      if is_set(transform_right_filter_column_0(2), 0) then
        transform_right_filter_feature_0_choices_from_18(54) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(54) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_0(2), 1) then
        transform_right_filter_feature_0_choices_from_18(55) := transform_right_filter_feature_0_choices_from_18(54);
      else
        transform_right_filter_feature_0_choices_from_18(55) := is_set(transform_right_filter_column_0(2), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(55) then
        transform_right_filter_feature_0_choices_from_18(56) := (not is_set(transform_right_filter_column_0(2), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(56) := (not is_set(transform_right_filter_column_0(2), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 56 to 59 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(2), i
            - 53)) or transform_right_filter_feature_0_values(i - 54);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(2), i
            - 53)) and transform_right_filter_feature_0_values(i - 54);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(2), 7) then
        transform_right_filter_feature_0_choices_from_18(61) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices_from_18(61) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices_from_18(60) then
        transform_right_filter_feature_0_choices_from_18(62) := is_set(transform_right_filter_column_0(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(62) := transform_right_filter_feature_0_choices_from_18(61);
      end if;
      if is_set(transform_right_filter_column_4(2), 0) then
        transform_right_filter_feature_0_choices_from_18(63) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(63) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_4(2), 1) then
        transform_right_filter_feature_0_choices_from_18(64) := transform_right_filter_feature_0_choices_from_18(63);
      else
        transform_right_filter_feature_0_choices_from_18(64) := is_set(transform_right_filter_column_4(2), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(64) then
        transform_right_filter_feature_0_choices_from_18(65) := (not is_set(transform_right_filter_column_4(2), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(65) := (not is_set(transform_right_filter_column_4(2), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 65 to 68 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(2), i
            - 62)) or transform_right_filter_feature_0_values(i - 63);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(2), i
            - 62)) and transform_right_filter_feature_0_values(i - 63);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(2), 7) then
        transform_right_filter_feature_0_choices_from_18(70) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices_from_18(70) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices_from_18(69) then
        transform_right_filter_feature_0_choices_from_18(71) := is_set(transform_right_filter_column_4(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(71) := transform_right_filter_feature_0_choices_from_18(70);
      end if;
      if is_set(transform_right_filter_column_2(6), 0) then
        transform_right_filter_feature_0_choices_from_18(72) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(72) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_2(6), 1) then
        transform_right_filter_feature_0_choices_from_18(73) := transform_right_filter_feature_0_choices_from_18(72);
      else
        transform_right_filter_feature_0_choices_from_18(73) := is_set(transform_right_filter_column_2(6), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(73) then
        transform_right_filter_feature_0_choices_from_18(74) := (not is_set(transform_right_filter_column_2(6), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(74) := (not is_set(transform_right_filter_column_2(6), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 74 to 77 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(6), i
            - 71)) or transform_right_filter_feature_0_values(i - 72);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(6), i
            - 71)) and transform_right_filter_feature_0_values(i - 72);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(3) := transform_filtering_0_column_inside_6 and (not
        is_set(transform_right_filter_column_2(4), 7));
      if is_set(transform_right_filter_column_2(6), 7) then
        transform_right_filter_feature_0_choices_from_18(79) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices_from_18(79) := transform_right_filter_feature_0_alls(3);
      end if;
      if transform_right_filter_feature_0_choices_from_18(78) then
        transform_right_filter_feature_0_choices_from_18(80) := is_set(transform_right_filter_column_2(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(80) := transform_right_filter_feature_0_choices_from_18(79);
      end if;
      if is_set(transform_right_filter_column_0(6), 0) then
        transform_right_filter_feature_0_choices_from_18(81) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(81) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_0(6), 1) then
        transform_right_filter_feature_0_choices_from_18(82) := transform_right_filter_feature_0_choices_from_18(81);
      else
        transform_right_filter_feature_0_choices_from_18(82) := is_set(transform_right_filter_column_0(6), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(82) then
        transform_right_filter_feature_0_choices_from_18(83) := (not is_set(transform_right_filter_column_0(6), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(83) := (not is_set(transform_right_filter_column_0(6), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 83 to 86 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(6), i
            - 80)) or transform_right_filter_feature_0_values(i - 81);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(6), i
            - 80)) and transform_right_filter_feature_0_values(i - 81);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(6), 7) then
        transform_right_filter_feature_0_choices_from_18(88) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices_from_18(88) := transform_right_filter_feature_0_alls(3);
      end if;
      if transform_right_filter_feature_0_choices_from_18(87) then
        transform_right_filter_feature_0_choices_from_18(89) := is_set(transform_right_filter_column_0(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(89) := transform_right_filter_feature_0_choices_from_18(88);
      end if;
      if is_set(transform_right_filter_column_4(6), 0) then
        transform_right_filter_feature_0_choices_from_18(90) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(90) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_4(6), 1) then
        transform_right_filter_feature_0_choices_from_18(91) := transform_right_filter_feature_0_choices_from_18(90);
      else
        transform_right_filter_feature_0_choices_from_18(91) := is_set(transform_right_filter_column_4(6), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(91) then
        transform_right_filter_feature_0_choices_from_18(92) := (not is_set(transform_right_filter_column_4(6), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(92) := (not is_set(transform_right_filter_column_4(6), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 92 to 95 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(6), i
            - 89)) or transform_right_filter_feature_0_values(i - 90);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(6), i
            - 89)) and transform_right_filter_feature_0_values(i - 90);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(6), 7) then
        transform_right_filter_feature_0_choices_from_18(97) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices_from_18(97) := transform_right_filter_feature_0_alls(3);
      end if;
      if transform_right_filter_feature_0_choices_from_18(96) then
        transform_right_filter_feature_0_choices_from_18(98) := is_set(transform_right_filter_column_4(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(98) := transform_right_filter_feature_0_choices_from_18(97);
      end if;
      if is_set(transform_right_filter_column_2(8), 0) then
        transform_right_filter_feature_0_choices_from_18(99) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(99) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_2(8), 1) then
        transform_right_filter_feature_0_choices_from_18(100) := transform_right_filter_feature_0_choices_from_18(99);
      else
        transform_right_filter_feature_0_choices_from_18(100) := is_set(transform_right_filter_column_2(8), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(100) then
        transform_right_filter_feature_0_choices_from_18(101) := (not is_set(transform_right_filter_column_2(8), 2))
          and transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(101) := (not is_set(transform_right_filter_column_2(8), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 101 to 104 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(8), i
            - 98)) or transform_right_filter_feature_0_values(i - 99);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(8), i
            - 98)) and transform_right_filter_feature_0_values(i - 99);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(4) := transform_filtering_0_column_inside_8 and (not
        is_set(transform_right_filter_column_2(4), 7));
      if is_set(transform_right_filter_column_2(8), 7) then
        transform_right_filter_feature_0_choices_from_18(106) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices_from_18(106) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices_from_18(105) then
        transform_right_filter_feature_0_choices_from_18(107) := is_set(transform_right_filter_column_2(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(107) := transform_right_filter_feature_0_choices_from_18(106);
      end if;
      if is_set(transform_right_filter_column_0(8), 0) then
        transform_right_filter_feature_0_choices_from_18(108) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(108) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_0(8), 1) then
        transform_right_filter_feature_0_choices_from_18(109) := transform_right_filter_feature_0_choices_from_18(108);
      else
        transform_right_filter_feature_0_choices_from_18(109) := is_set(transform_right_filter_column_0(8), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(109) then
        transform_right_filter_feature_0_choices_from_18(110) := (not is_set(transform_right_filter_column_0(8), 2))
          and transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(110) := (not is_set(transform_right_filter_column_0(8), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 110 to 113 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(8), i
            - 107)) or transform_right_filter_feature_0_values(i - 108);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(8), i
            - 107)) and transform_right_filter_feature_0_values(i - 108);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(8), 7) then
        transform_right_filter_feature_0_choices_from_18(115) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices_from_18(115) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices_from_18(114) then
        transform_right_filter_feature_0_choices_from_18(116) := is_set(transform_right_filter_column_0(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(116) := transform_right_filter_feature_0_choices_from_18(115);
      end if;
      if is_set(transform_right_filter_column_4(8), 0) then
        transform_right_filter_feature_0_choices_from_18(117) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(117) := not is_set(transform_right_filter_column_2(4), 1);
      end if;
      if is_set(transform_right_filter_column_4(8), 1) then
        transform_right_filter_feature_0_choices_from_18(118) := transform_right_filter_feature_0_choices_from_18(117);
      else
        transform_right_filter_feature_0_choices_from_18(118) := is_set(transform_right_filter_column_4(8), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(118) then
        transform_right_filter_feature_0_choices_from_18(119) := (not is_set(transform_right_filter_column_4(8), 2))
          and transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices_from_18(119) := (not is_set(transform_right_filter_column_4(8), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 119 to 122 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(8), i
            - 116)) or transform_right_filter_feature_0_values(i - 117);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(8), i
            - 116)) and transform_right_filter_feature_0_values(i - 117);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(8), 7) then
        transform_right_filter_feature_0_choices_from_18(124) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices_from_18(124) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices_from_18(123) then
        transform_right_filter_feature_0_choices_from_18(125) := is_set(transform_right_filter_column_4(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(125) := transform_right_filter_feature_0_choices_from_18(124);
      end if;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_counter_next_frame <= transform_counter_next_frame_choices(3) or ((not in_valid) and
        transform_counter_next_frame);
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
        (transform_counter_group mod 4)) < 12;
      transform_read_row_inside_2 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 12;
      transform_read_row_inside_4 <= (not is_set(transform_counter_group, 3)) or (not is_set(transform_counter_group,
        2));
      transform_read_column_inside_0 <= is_set(transform_counter_column, 5) or transform_read_column_inside_0_value or
        transform_read_column_inside_0_values(2) or transform_read_column_inside_0_values(3);
      transform_read_column_inside_4 <= true;
      transform_read_column_inside_8 <= is_set(transform_counter_column, 5) or transform_read_column_inside_0_value or
        transform_read_column_inside_0_values(2) or (not transform_read_column_inside_0_values(3));
      transform_read_start_of_frame <= (transform_counter_column = 4) and (transform_counter_group = 2);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
      transform_ready_row_inside_4 <= transform_read_row_inside_4;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_column_inside_4 <= transform_read_column_inside_4;
      transform_ready_column_inside_6 <= transform_read_column_inside_6;
      transform_ready_column_inside_8 <= transform_read_column_inside_8;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
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
      transform_left_filter_feature_0 <= (transform_left_filter_feature_0_choice_17 * 64) +
        (as_number(transform_left_filter_feature_0_choices_from_18(26)) * 2) +
        as_number(transform_left_filter_feature_0_choices_from_18(35)) +
        (as_number(transform_left_filter_feature_0_choices_from_18(43)) * 4) +
        (as_number(transform_left_filter_feature_0_choices_from_18(52)) * 16) +
        (as_number(transform_left_filter_feature_0_choices_from_18(61)) * 8) +
        (as_number(transform_left_filter_feature_0_choices_from_18(69)) * 32) +
        (as_number(transform_left_filter_feature_0_choices_from_18(78)) * 512) +
        (as_number(transform_left_filter_feature_0_choices_from_18(87)) * 256) +
        (as_number(transform_left_filter_feature_0_choices_from_18(95)) * 1024) +
        (as_number(transform_left_filter_feature_0_choices_from_18(104)) * 4096) +
        (as_number(transform_left_filter_feature_0_choices_from_18(113)) * 2048) +
        (as_number(transform_left_filter_feature_0_choices_from_18(121)) * 8192);
      transform_right_filter_feature_0 <= (transform_right_filter_feature_0_choice_17 * 64) +
        (as_number(transform_right_filter_feature_0_choices_from_18(26)) * 2) +
        as_number(transform_right_filter_feature_0_choices_from_18(35)) +
        (as_number(transform_right_filter_feature_0_choices_from_18(44)) * 4) +
        (as_number(transform_right_filter_feature_0_choices_from_18(53)) * 16) +
        (as_number(transform_right_filter_feature_0_choices_from_18(62)) * 8) +
        (as_number(transform_right_filter_feature_0_choices_from_18(71)) * 32) +
        (as_number(transform_right_filter_feature_0_choices_from_18(80)) * 512) +
        (as_number(transform_right_filter_feature_0_choices_from_18(89)) * 256) +
        (as_number(transform_right_filter_feature_0_choices_from_18(98)) * 1024) +
        (as_number(transform_right_filter_feature_0_choices_from_18(107)) * 4096) +
        (as_number(transform_right_filter_feature_0_choices_from_18(116)) * 2048) +
        (as_number(transform_right_filter_feature_0_choices_from_18(125)) * 8192);
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_8 <= transform_columns_column_inside_8;
      transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
      transform_filtering_valid(0) <= transform_columns_valid;
      transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
      transform_filtering_valid(1) <= transform_filtering_valid(0);
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 4;
      else
        transform_counter_group <= transform_counter_group_choices(3);
      end if;
      if ((transform_counter_column / 2) mod 16) = 0 then
        transform_read_column_inside_2 <= transform_read_column_inside_2_is_equal /= is_set(transform_counter_column,
          5);
      else
        transform_read_column_inside_2 <= transform_read_column_inside_2_differs;
      end if;
      if transform_read_column_inside_6_choice then
        transform_read_column_inside_6 <= transform_read_column_inside_2_is_equal /=
          transform_read_column_inside_0_values(2);
      else
        transform_read_column_inside_6 <= transform_read_column_inside_2_differs;
      end if;
      if in_valid then
        if transform_counter_group_is_equal or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 64;
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
      raster_place_group_is_equal := raster_place_group = 11;
      raster_place_group_is_equals(2) := raster_place_column = 39;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equals(2);
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_is_equals(3) := (raster_place_group / 2) = 6;
      if raster_place_group_is_equals(3) then
        raster_place_group_choice_2 := raster_place_group_is_equals(2) and (not is_set(raster_place_group, 0)) and
          transform_filtering_valid(1);
      else
        raster_place_group_choice_2 := raster_place_group_is_equals(2) and transform_filtering_valid(1);
      end if;
      if raster_place_next_frame and (raster_place_group = 12) then
        raster_place_group_choices(3) := 1;
      else
        raster_place_group_choices(3) := (raster_place_group + 1) mod 16;
      end if;
      if raster_place_group_choice_2 then
        raster_place_group_choices(4) := raster_place_group_choices(3);
      else
        raster_place_group_choices(4) := raster_place_group;
      end if;
      raster_features_search_0 <= transform_left_filter_feature_0;
      raster_features_reference_0 <= transform_right_filter_feature_0;
      raster_features_valid <= transform_filtering_valid(1);
      if transform_filtering_start_of_frame(1) and transform_filtering_valid(1) then
        raster_place_group <= raster_place_group_choice * 4;
      else
        raster_place_group <= raster_place_group_choices(4);
      end if;
      if raster_place_group_is_equals(2) then
        raster_place_next_frame_choice := raster_place_next_frame and is_set(raster_place_group, 0);
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_is_equals(3) then
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      end if;
      if transform_filtering_valid(1) then
        if raster_place_group_is_equals(2) or transform_filtering_start_of_frame(1) then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 64;
        end if;
        if raster_place_next_frame_choice_2 then
          raster_place_next_frame <= raster_place_group_all or (not transform_filtering_start_of_frame(1));
        else
          raster_place_next_frame <= raster_place_group_is_equal and raster_place_group_is_equals(2) and
            transform_filtering_start_of_frame(1);
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
      delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 12;
      delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside(2) <= (not is_set(raster_place_group, 3)) or (not is_set(raster_place_group, 2));
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= (not (is_set(raster_place_column, 3) and (is_set(raster_place_column, 2) or
        ((raster_place_column mod 4) = 3)))) and ((raster_place_column / 16) = 0);
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and
        delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_group_is_equals(2);
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside(0) <= delay_row_inside(0);
      rows_read_inside(1) <= delay_row_inside(1);
      rows_read_inside(2) <= delay_row_inside(2);
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_first_cost <= delay_tag_first_cost;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
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
        line_order_address_choice := 31;
      else
        line_order_address_choice := 1;
      end if;
      if line_order_falls then
        line_order_address_choice_2 := 0;
      else
        line_order_address_choice_2 := 7;
      end if;
      if not ((not line_centre_map_column_0) or (not rows_tag_valid)) then
        if line_order_address_any then
          line_order_address <= (line_order_address_choice + line_order_address) mod 32;
        else
          line_order_address <= line_order_address_choice_2 * 4;
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
      for i in 2 to 23 loop
        line_comes(i) <= line_comes(i - 1);
      end loop;
      line_starts_phases(1) <= line_order_inside and line_order_turned_valid;
      for i in 2 to 14 loop
        line_starts_phases(i) <= line_starts_phases(i - 1);
      end loop;
      line_starts_phases(15) <= pathsleft_read_count_phase = 0;
      line_starts_phases(16) <= pathsleft_is_first;
      for i in 17 to 23 loop
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
        line_places_top(0) <= line_newest_top;
        line_places_address(0) <= line_order_address;
        line_places_shown_output_column(0) <= line_order_turned_output_column;
        line_places_shown_start_of_frame(0) <= line_order_turned_start_of_frame;
        line_places_shown_end_of_line(0) <= line_order_turned_end_of_line;
      end if;
      if line_comes(4) then
        line_places_map_column(1) <= line_places_map_column(0);
        line_places_first_column(1) <= line_places_first_column(0);
        line_places_top(1) <= line_places_top(0);
        line_places_address(1) <= line_places_address(0);
        line_places_shown_output_column(1) <= line_places_shown_output_column(0);
        line_places_shown_start_of_frame(1) <= line_places_shown_start_of_frame(0);
        line_places_shown_end_of_line(1) <= line_places_shown_end_of_line(0);
      end if;
      for i in 2 to 3 loop
        if line_comes(4 * i) then
          line_places_map_column(i) <= line_places_map_column(i - 1);
          line_places_first_column(i) <= line_places_first_column(i - 1);
          line_places_address(i) <= line_places_address(i - 1);
          line_places_shown_output_column(i) <= line_places_shown_output_column(i - 1);
          line_places_shown_start_of_frame(i) <= line_places_shown_start_of_frame(i - 1);
          line_places_shown_end_of_line(i) <= line_places_shown_end_of_line(i - 1);
        end if;
      end loop;
      if line_comes(16) then
        line_places_map_column(4) <= line_places_map_column(3);
        line_places_first_column(4) <= line_places_first_column(3);
        line_places_shown_output_column(4) <= line_places_shown_output_column(3);
        line_places_shown_start_of_frame(4) <= line_places_shown_start_of_frame(3);
        line_places_shown_end_of_line(4) <= line_places_shown_end_of_line(3);
      end if;
      if line_comes(20) then
        line_places_map_column(5) <= line_places_map_column(4);
        line_places_shown_output_column(5) <= line_places_shown_output_column(4);
        line_places_shown_start_of_frame(5) <= line_places_shown_start_of_frame(4);
        line_places_shown_end_of_line(5) <= line_places_shown_end_of_line(4);
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
      if costsshift_count_phase = 3 then
        costsshift_count_phase_choice := 3;
      else
        costsshift_count_phase_choice := (costsshift_count_phase + 1) mod 4;
      end if;
      costsshift_new_tag_valid <= rows_tag_valid or (not is_set(costsshift_count_phase, 1)) or (not
        is_set(costsshift_count_phase, 0));
      costsshift_handed_on(0) <= to_integer(costsshift_read_words(1)(13 downto 0));
      costsshift_handed_on(1) <= to_integer(costsshift_read_words(2)(27 downto 14));
      costsshift_handed_on(2) <= to_integer(costsshift_read_words_4);
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
        costsshift_search(0, 1) <= to_integer(costsshift_read_words(0)(13 downto 0));
        costsshift_search(0, 2) <= to_integer(costsshift_read_words(0)(27 downto 14));
        costsshift_search(1, 1) <= to_integer(costsshift_read_words(1)(27 downto 14));
        costsshift_search(1, 2) <= to_integer(costsshift_read_words(2)(13 downto 0));
        costsshift_search(2, 1) <= to_integer(costsshift_read_words(3)(13 downto 0));
        costsshift_search(2, 2) <= to_integer(costsshift_read_words(3)(27 downto 14));
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
        for j in 1 to 2 loop
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
        for j in 0 to 2 loop
          costscolumn_pixels_cost(i, j) <= costscolumn_pixels_first_count(i, j, 3) + costscolumn_pixels_first_count(i,
            j, 0) + costscolumn_pixels_first_count(i, j, 1) + costscolumn_pixels_first_count_4(i, j) +
            costscolumn_pixels_first_count(i, j, 2);
        end loop;
      end loop;
      costscolumn_pixels_tag_border_column <= costscolumn_pixels_first_tag_border_column;
      costscolumn_pair_0(0) <= costscolumn_pixels_cost(1, 0) + costscolumn_pixels_cost(2, 0);
      costscolumn_pair_0(1) <= costscolumn_pixels_cost(1, 1) + costscolumn_pixels_cost(2, 1);
      costscolumn_pair_0(2) <= costscolumn_pixels_cost(1, 2) + costscolumn_pixels_cost(2, 2);
      costscolumn_single_0(0) <= costscolumn_pixels_cost(0, 0);
      costscolumn_single_0(1) <= costscolumn_pixels_cost(0, 1);
      costscolumn_single_0(2) <= costscolumn_pixels_cost(0, 2);
      costscolumn_pair_tag_border_column <= costscolumn_pixels_tag_border_column;
      if costscolumn_pair_tag_border_column then
        costscolumn_column_0(0) <= 0;
        costscolumn_column_0(1) <= 0;
        costscolumn_column_0(2) <= 0;
      else
        costscolumn_column_0(0) <= costscolumn_pair_0(0) + costscolumn_single_0(0);
        costscolumn_column_0(1) <= costscolumn_pair_0(1) + costscolumn_single_0(1);
        costscolumn_column_0(2) <= costscolumn_pair_0(2) + costscolumn_single_0(2);
      end if;
      -- costswindow
      if costswindow_read_count_phase = 3 then
        costswindow_read_count_phase_choice := 3;
      else
        costswindow_read_count_phase_choice := (costswindow_read_count_phase + 1) mod 4;
      end if;
      if costswindow_write_count_phase = 3 then
        costswindow_write_count_phase_choice := 3;
      else
        costswindow_write_count_phase_choice := (costswindow_write_count_phase + 1) mod 4;
      end if;
      costswindow_sum_0(0) <= costscolumn_column_0(0) + to_integer(costswindow_read_words_0(27 downto 21));
      costswindow_sum_0(1) <= costscolumn_column_0(1) + to_integer(costswindow_read_words_1(6 downto 0));
      costswindow_sum_0(2) <= costscolumn_column_0(2) + to_integer(costswindow_read_words_1(13 downto 7));
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
      costswindow_partial_0_any := (not is_set(costswindow_write_count_phase, 1)) or (not
        is_set(costswindow_write_count_phase, 0)) or line_comes(6);
      if costswindow_partial_0_any then
        costswindow_partial(0) <= costscolumn_column_0(0);
        costswindow_partial(1) <= costscolumn_column_0(1);
        costswindow_partial(2) <= costscolumn_column_0(2);
        for i in 3 to 5 loop
          costswindow_partials(i) <= costscolumn_column_0(i - 3) + to_integer(costswindow_read_words_0(7 * i - 16
            downto 7 * i - 21));
        end loop;
      end if;
      -- costs
      for i in 0 to 2 loop
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
      paths_tree_smallest(1) <= costs_cost(2);
      paths_cost_delay_ring_write_address <= paths_cost_delay_ring_read_address;
      paths_sum(0) <= (pathsturn_sum_memory_ready_words_0 mod 128) + pathsright_cost(0);
      paths_sum(1) <= ((pathsturn_sum_memory_ready_words_0 / 128) mod 128) + pathsright_cost(1);
      paths_sum(2) <= (pathsturn_sum_memory_ready_words_1 * 4) + (pathsturn_sum_memory_ready_words_0 / 16384) +
        pathsright_cost(2);
      if (costs_cost(1) - costs_cost(0)) < 0 then
        paths_tree_smallest(0) <= costs_cost(1);
      else
        paths_tree_smallest(0) <= costs_cost(0);
      end if;
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
      if paths_cost_delay_ring_read_address = 6 then
        paths_cost_delay_ring_read_address <= 0;
      else
        paths_cost_delay_ring_read_address <= (paths_cost_delay_ring_read_address + 1) mod 8;
      end if;
      -- pathsleft
      if line_starts_phases(6) then
        pathsleft_fresh_past_newest(0) <= relief_left(1);
        pathsleft_fresh_past_newest(1) <= pathsleft_fresh_past_newest(0);
      end if;
      if line_starts_phases(7) then
        pathsleft_fresh_past_pairs(1) <= pathsleft_fresh_past_pairs(0);
        pathsleft_fresh_past_pairs(2) <= pathsleft_fresh_past_pairs(1);
        if (pathsleft_fresh_past_newest(1) - pathsleft_fresh_past_newest(0)) < 0 then
          pathsleft_fresh_past_pairs(0) <= pathsleft_fresh_past_newest(1);
        else
          pathsleft_fresh_past_pairs(0) <= pathsleft_fresh_past_newest(0);
        end if;
      end if;
      if line_starts_phases(8) then
        pathsleft_fresh_past_fours(1) <= pathsleft_fresh_past_fours(0);
        pathsleft_fresh_past_fours(2) <= pathsleft_fresh_past_fours(1);
        pathsleft_fresh_past_fours(3) <= pathsleft_fresh_past_fours(2);
        pathsleft_fresh_past_fours(4) <= pathsleft_fresh_past_fours(3);
        pathsleft_low_address <= (pathsleft_low_address + 1) mod 16;
        if (pathsleft_fresh_past_pairs(2) - pathsleft_fresh_past_pairs(0)) < 0 then
          pathsleft_fresh_past_fours(0) <= pathsleft_fresh_past_pairs(2);
        else
          pathsleft_fresh_past_fours(0) <= pathsleft_fresh_past_pairs(0);
        end if;
      end if;
      pathsleft_read_count_phase_is_equal := pathsleft_read_count_phase = 3;
      if pathsleft_read_count_phase_is_equal then
        pathsleft_read_count_phase_choice := 3;
      else
        pathsleft_read_count_phase_choice := (pathsleft_read_count_phase + 1) mod 4;
      end if;
      if pathsleft_ahead_count_phase = 3 then
        pathsleft_ahead_count_phase_choice := 3;
      else
        pathsleft_ahead_count_phase_choice := (pathsleft_ahead_count_phase + 1) mod 4;
      end if;
      pathsleft_passes_by_is_equal := pathsleft_write_count_phase = 3;
      if is_set(pathsleft_ahead_count_phase, 0) then
        pathsleft_passes_by_choice := pathsleft_passes_by_is_equal;
      else
        pathsleft_passes_by_choice := pathsleft_write_count_phase = 2;
      end if;
      if is_set(pathsleft_ahead_count_phase, 0) then
        pathsleft_passes_by_choice_2 := pathsleft_write_count_phase = 1;
      else
        pathsleft_passes_by_choice_2 := pathsleft_write_count_phase = 0;
      end if;
      pathsleft_lower_neighbour_value := to_integer(pathsleft_read_words_0(20 downto 14));
      pathsleft_stay_value(0) := pathsleft_read_words_0(21) = '1';
      pathsleft_stay_0_values(2) := is_set(pathsleft_fresh_here, 1);
      pathsleft_stay_0_is_equal := (pathsleft_fresh_here mod 4) = 0;
      if pathsleft_stay_value(0) then
        pathsleft_stay_choice(0) := not pathsleft_stay_0_values(2);
      else
        pathsleft_stay_choice(0) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words_0(22) = '1' then
        pathsleft_stay_choices(0, 2) := pathsleft_stay_value(0) or (not pathsleft_stay_0_values(2)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(0, 2) := pathsleft_stay_choice(0);
      end if;
      pathsleft_stay_0_values(3) := is_set(pathsleft_fresh_here, 2);
      if pathsleft_stay_choices(0, 2) then
        pathsleft_stay_choices(0, 3) := (not (pathsleft_read_words_0(23) = '1')) and pathsleft_stay_0_values(3);
      else
        pathsleft_stay_choices(0, 3) := (not (pathsleft_read_words_0(23) = '1')) or pathsleft_stay_0_values(3);
      end if;
      for i in 4 to 6 loop
        pathsleft_stay_0_values(i) := is_set(pathsleft_fresh_here, i - 1);
        if pathsleft_stay_choices(0, i - 1) then
          pathsleft_stay_choices(0, i) := (not (pathsleft_read_words_0(i + 20) = '1')) or pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(0, i) := (not (pathsleft_read_words_0(i + 20) = '1')) and pathsleft_stay_0_values(i);
        end if;
      end loop;
      if pathsleft_stay_choices(0, 6) then
        pathsleft_stay_choices(0, 7) := (not (pathsleft_read_words_0(27) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(0, 7) := (not (pathsleft_read_words_0(27) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if is_set(pathsleft_fresh_here, 0) then
        pathsleft_stay_choices(0, 8) := (not (pathsleft_read_words_0(1) = '1')) or (not (pathsleft_read_words_0(0) =
          '1'));
      else
        pathsleft_stay_choices(0, 8) := not (pathsleft_read_words_0(1) = '1');
      end if;
      if pathsleft_stay_0_values(2) then
        pathsleft_stay_choices(0, 9) := pathsleft_stay_choices(0, 8);
      else
        pathsleft_stay_choices(0, 9) := is_set(pathsleft_fresh_here, 0) and (to_integer(pathsleft_read_words_0(1 downto
          0)) = 0);
      end if;
      pathsleft_stay_0_values(7) := pathsleft_read_words_0(2) = '1';
      if pathsleft_stay_choices(0, 9) then
        pathsleft_stay_choices(0, 10) := (not pathsleft_stay_0_values(3)) and pathsleft_stay_0_values(7);
      else
        pathsleft_stay_choices(0, 10) := (not pathsleft_stay_0_values(3)) or pathsleft_stay_0_values(7);
      end if;
      for i in 8 to 10 loop
        pathsleft_stay_0_values(i) := pathsleft_read_words_0(i - 5) = '1';
        if pathsleft_stay_choices(0, i + 2) then
          pathsleft_stay_choices(0, i + 3) := (not pathsleft_stay_0_values(i - 4)) or pathsleft_stay_0_values(i);
        else
          pathsleft_stay_choices(0, i + 3) := (not pathsleft_stay_0_values(i - 4)) and pathsleft_stay_0_values(i);
        end if;
      end loop;
      pathsleft_stay_0_values(11) := pathsleft_read_words_0(6) = '1';
      if pathsleft_stay_choices(0, 13) then
        pathsleft_stay_choices(0, 14) := (not is_set(pathsleft_fresh_here, 6)) or pathsleft_stay_0_values(11);
      else
        pathsleft_stay_choices(0, 14) := (not is_set(pathsleft_fresh_here, 6)) and pathsleft_stay_0_values(11);
      end if;
      if pathsleft_stay_choices(0, 7) then
        pathsleft_stay_choices(0, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(0, 15) := (not pathsleft_stay_choices(0, 14)) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words_0(27 downto 21)) - to_integer(pathsleft_read_words_0(6 downto 0))) < 0 then
        pathsleft_stay_choice_16(0) := to_integer(pathsleft_read_words_0(27 downto 21));
      else
        pathsleft_stay_choice_16(0) := to_integer(pathsleft_read_words_0(6 downto 0));
      end if;
      if pathsleft_read_words_1(0) = '1' then
        pathsleft_stay_choice(1) := not pathsleft_stay_0_values(2);
      else
        pathsleft_stay_choice(1) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words_1(1) = '1' then
        pathsleft_stay_choices(1, 2) := (pathsleft_read_words_1(0) = '1') or (not pathsleft_stay_0_values(2)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(1, 2) := pathsleft_stay_choice(1);
      end if;
      if pathsleft_stay_choices(1, 2) then
        pathsleft_stay_choices(1, 3) := (not (pathsleft_read_words_1(2) = '1')) and pathsleft_stay_0_values(3);
      else
        pathsleft_stay_choices(1, 3) := (not (pathsleft_read_words_1(2) = '1')) or pathsleft_stay_0_values(3);
      end if;
      for i in 3 to 5 loop
        if pathsleft_stay_choices(1, i) then
          pathsleft_stay_choices(1, i + 1) := (not (pathsleft_read_words_1(i) = '1')) or pathsleft_stay_0_values(i + 1);
        else
          pathsleft_stay_choices(1, i + 1) := (not (pathsleft_read_words_1(i) = '1')) and pathsleft_stay_0_values(i +
            1);
        end if;
      end loop;
      if pathsleft_stay_choices(1, 6) then
        pathsleft_stay_choices(1, 7) := (not (pathsleft_read_words_1(6) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(1, 7) := (not (pathsleft_read_words_1(6) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      pathsleft_stay_value(1) := pathsleft_read_words_0(7) = '1';
      if pathsleft_stay_value(1) then
        pathsleft_stay_choices(1, 8) := not pathsleft_stay_0_values(2);
      else
        pathsleft_stay_choices(1, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words_0(8) = '1' then
        pathsleft_stay_choices(1, 9) := pathsleft_stay_value(1) or (not pathsleft_stay_0_values(2)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(1, 9) := pathsleft_stay_choices(1, 8);
      end if;
      if pathsleft_stay_choices(1, 9) then
        pathsleft_stay_choices(1, 10) := (not (pathsleft_read_words_0(9) = '1')) and pathsleft_stay_0_values(3);
      else
        pathsleft_stay_choices(1, 10) := (not (pathsleft_read_words_0(9) = '1')) or pathsleft_stay_0_values(3);
      end if;
      for i in 10 to 12 loop
        if pathsleft_stay_choices(1, i) then
          pathsleft_stay_choices(1, i + 1) := (not (pathsleft_read_words_0(i) = '1')) or pathsleft_stay_0_values(i - 6);
        else
          pathsleft_stay_choices(1, i + 1) := (not (pathsleft_read_words_0(i) = '1')) and pathsleft_stay_0_values(i -
            6);
        end if;
      end loop;
      if pathsleft_stay_choices(1, 13) then
        pathsleft_stay_choices(1, 14) := (not (pathsleft_read_words_0(13) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(1, 14) := (not (pathsleft_read_words_0(13) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(1, 7) then
        pathsleft_stay_choices(1, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(1, 15) := pathsleft_stay_choices(1, 14) and (not pathsleft_first);
      end if;
      pathsleft_stay_1_value_2 := to_integer(pathsleft_read_words_0(13 downto 7));
      if (to_integer(pathsleft_read_words_1(6 downto 0)) - pathsleft_stay_1_value_2) < 0 then
        pathsleft_stay_choice_16(1) := to_integer(pathsleft_read_words_1(6 downto 0));
      else
        pathsleft_stay_choice_16(1) := pathsleft_stay_1_value_2;
      end if;
      pathsleft_stay_value(2) := pathsleft_read_words_1(7) = '1';
      if pathsleft_stay_value(2) then
        pathsleft_stay_choice(2) := not pathsleft_stay_0_values(2);
      else
        pathsleft_stay_choice(2) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words_1(8) = '1' then
        pathsleft_stay_choices(2, 2) := pathsleft_stay_value(2) or (not pathsleft_stay_0_values(2)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(2, 2) := pathsleft_stay_choice(2);
      end if;
      if pathsleft_stay_choices(2, 2) then
        pathsleft_stay_choices(2, 3) := (not (pathsleft_read_words_1(9) = '1')) and pathsleft_stay_0_values(3);
      else
        pathsleft_stay_choices(2, 3) := (not (pathsleft_read_words_1(9) = '1')) or pathsleft_stay_0_values(3);
      end if;
      for i in 3 to 5 loop
        if pathsleft_stay_choices(2, i) then
          pathsleft_stay_choices(2, i + 1) := (not (pathsleft_read_words_1(i + 7) = '1')) or pathsleft_stay_0_values(i
            + 1);
        else
          pathsleft_stay_choices(2, i + 1) := (not (pathsleft_read_words_1(i + 7) = '1')) and pathsleft_stay_0_values(i
            + 1);
        end if;
      end loop;
      if pathsleft_stay_choices(2, 6) then
        pathsleft_stay_choices(2, 7) := (not (pathsleft_read_words_1(13) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(2, 7) := (not (pathsleft_read_words_1(13) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      pathsleft_stay_2_value_2 := pathsleft_read_words_0(14) = '1';
      if pathsleft_stay_2_value_2 then
        pathsleft_stay_choices(2, 8) := not pathsleft_stay_0_values(2);
      else
        pathsleft_stay_choices(2, 8) := pathsleft_stay_0_is_equal;
      end if;
      if pathsleft_read_words_0(15) = '1' then
        pathsleft_stay_choices(2, 9) := pathsleft_stay_2_value_2 or (not pathsleft_stay_0_values(2)) or (not
          is_set(pathsleft_fresh_here, 0));
      else
        pathsleft_stay_choices(2, 9) := pathsleft_stay_choices(2, 8);
      end if;
      if pathsleft_stay_choices(2, 9) then
        pathsleft_stay_choices(2, 10) := (not (pathsleft_read_words_0(16) = '1')) and pathsleft_stay_0_values(3);
      else
        pathsleft_stay_choices(2, 10) := (not (pathsleft_read_words_0(16) = '1')) or pathsleft_stay_0_values(3);
      end if;
      for i in 10 to 12 loop
        if pathsleft_stay_choices(2, i) then
          pathsleft_stay_choices(2, i + 1) := (not (pathsleft_read_words_0(i + 7) = '1')) or pathsleft_stay_0_values(i
            - 6);
        else
          pathsleft_stay_choices(2, i + 1) := (not (pathsleft_read_words_0(i + 7) = '1')) and pathsleft_stay_0_values(i
            - 6);
        end if;
      end loop;
      if pathsleft_stay_choices(2, 13) then
        pathsleft_stay_choices(2, 14) := (not (pathsleft_read_words_0(20) = '1')) or is_set(pathsleft_fresh_here, 6);
      else
        pathsleft_stay_choices(2, 14) := (not (pathsleft_read_words_0(20) = '1')) and is_set(pathsleft_fresh_here, 6);
      end if;
      if pathsleft_stay_choices(2, 7) then
        pathsleft_stay_choices(2, 15) := not pathsleft_first;
      else
        pathsleft_stay_choices(2, 15) := pathsleft_stay_choices(2, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsleft_read_words_1(13 downto 7)) - pathsleft_lower_neighbour_value) < 0 then
        pathsleft_stay_choice_16(2) := to_integer(pathsleft_read_words_1(13 downto 7));
      else
        pathsleft_stay_choice_16(2) := pathsleft_lower_neighbour_value;
      end if;
      if line_starts_phases(15) then
        pathsleft_step_choice(0) := pathsleft_stay_1_value_2;
      else
        pathsleft_step_choice(0) := pathsleft_lower_neighbour;
      end if;
      if (pathsleft_stay_1_value_2 - pathsleft_step_choice(0)) < 0 then
        pathsleft_step_0_choice_2 := pathsleft_stay_1_value_2;
      else
        pathsleft_step_0_choice_2 := pathsleft_step_choice(0);
      end if;
      if (pathsleft_lower_neighbour_value - to_integer(pathsleft_read_words_0(6 downto 0))) < 0 then
        pathsleft_step_choice(1) := pathsleft_lower_neighbour_value;
      else
        pathsleft_step_choice(1) := to_integer(pathsleft_read_words_0(6 downto 0));
      end if;
      if pathsleft_passes_by then
        pathsleft_step_choice(2) := pathsleft_passed_by;
      else
        pathsleft_step_choice(2) := to_integer(pathsleft_read_neighbour_0);
      end if;
      if pathsleft_is_last then
        pathsleft_step_2_choices(2) := pathsleft_stay_1_value_2;
      else
        pathsleft_step_2_choices(2) := pathsleft_step_choice(2);
      end if;
      if (pathsleft_step_2_choices(2) - pathsleft_stay_1_value_2) < 0 then
        pathsleft_step_2_choices(3) := pathsleft_step_2_choices(2);
      else
        pathsleft_step_2_choices(3) := pathsleft_stay_1_value_2;
      end if;
      pathsleft_stay_change_1_value := to_integer(paths_cost_delay_held_0(5 downto 0)) / 8;
      if pathsleft_passes_by_is_equal then
        pathsleft_write_count_phase_choice := 3;
      else
        pathsleft_write_count_phase_choice := (pathsleft_write_count_phase + 1) mod 4;
      end if;
      if line_comes(19) then
        pathsleft_low_0_choice := 127;
      else
        pathsleft_low_0_choice := pathsleft_low_0;
      end if;
      pathsleft_lost <= is_set(pathsleft_fresh_known, 6);
      pathsleft_short_of <= (((pathsright_fresh_known mod 64) + pathsright_room) / 64) = 1;
      pathsleft_missing <= (pathsleft_fresh_known + pathsleft_room) mod 64;
      pathsleft_below <= (0 - pathsleft_fresh_known) mod 64;
      pathsleft_is_first <= line_starts_phases(14);
      pathsleft_is_last <= pathsleft_read_count_phase_is_equal;
      pathsleft_passed_by <= pathsleft_cost(0);
      pathsleft_lower_neighbour <= pathsleft_lower_neighbour_value;
      pathsleft_stay_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g) mod 128;
      pathsleft_stay_change(1) <= (pathsleft_stay_change_1_value - pathsleft_g) mod 128;
      pathsleft_stay_change(2) <= (to_integer(paths_cost_delay_held_0(8 downto 6)) - pathsleft_g) mod 128;
      pathsleft_step_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g_less) mod 128;
      pathsleft_step_change(1) <= (pathsleft_stay_change_1_value - pathsleft_g_less) mod 128;
      pathsleft_step_change(2) <= (to_integer(paths_cost_delay_held_0(8 downto 6)) - pathsleft_g_less) mod 128;
      pathsleft_tree_smallest(1) <= pathsleft_cost(2);
      if (pathsleft_fresh_past_fours(4) - pathsleft_fresh_past_fours(0)) < 0 then
        pathsleft_fresh_past_cheapest <= pathsleft_fresh_past_fours(4);
      else
        pathsleft_fresh_past_cheapest <= pathsleft_fresh_past_fours(0);
      end if;
      if (pathsleft_fresh_past_cheapest - to_integer(pathsleft_lowest_0)) < 0 then
        pathsleft_fresh_known <= pathsleft_fresh_past_cheapest;
      else
        pathsleft_fresh_known <= to_integer(pathsleft_lowest_0);
      end if;
      if line_starts_phases(13) then
        pathsleft_read_count_phase <= 0;
      else
        pathsleft_read_count_phase <= pathsleft_read_count_phase_choice;
      end if;
      if line_starts_phases(12) then
        pathsleft_ahead_count_phase <= 0;
      else
        pathsleft_ahead_count_phase <= pathsleft_ahead_count_phase_choice;
      end if;
      if is_set(pathsleft_ahead_count_phase, 1) then
        pathsleft_passes_by <= pathsleft_passes_by_choice;
      else
        pathsleft_passes_by <= pathsleft_passes_by_choice_2;
      end if;
      for i in 0 to 2 loop
        if pathsleft_stay_choices(i, 15) then
          pathsleft_stay(i) <= pathsleft_stay_choice_16(i);
        else
          pathsleft_stay(i) <= pathsleft_fresh_here;
        end if;
      end loop;
      if pathsleft_first then
        pathsleft_step(0) <= 64;
        pathsleft_step(1) <= 64;
        pathsleft_step(2) <= 64;
      else
        pathsleft_step(0) <= pathsleft_step_0_choice_2;
        pathsleft_step(1) <= pathsleft_step_choice(1);
        pathsleft_step(2) <= pathsleft_step_2_choices(3);
      end if;
      if line_starts_phases(16) then
        pathsleft_write_count_phase <= 0;
      else
        pathsleft_write_count_phase <= pathsleft_write_count_phase_choice;
      end if;
      if (pathsleft_cost(1) - pathsleft_cost(0)) < 0 then
        pathsleft_tree_smallest(0) <= pathsleft_cost(1);
      else
        pathsleft_tree_smallest(0) <= pathsleft_cost(0);
      end if;
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
      if line_starts_phases(14) then
        pathsleft_fresh_here <= relief_left(3);
        pathsleft_first <= line_places_first_column(3);
        pathsleft_g <= paths_smallest_cost + pathsleft_q_now;
        pathsleft_g_less <= (paths_smallest_cost + pathsleft_q_less) mod 128;
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
      if line_starts_phases(12) then
        if line_places_first_column(2) then
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
      if line_starts_phases(13) then
        pathsleft_q_now <= pathsleft_q;
        pathsleft_q_less <= (pathsleft_q + 121) mod 128;
        if line_places_first_column(3) then
          pathsleft_room <= 0;
          for i in 1 to 6 loop
            pathsleft_start_cost(i) <= 0;
          end loop;
        else
          pathsleft_room <= (pathsleft_room_left + pathsleft_start_cost(6)) mod 64;
          pathsleft_start_cost(1) <= pathsleft_q_now;
          for i in 2 to 6 loop
            pathsleft_start_cost(i) <= pathsleft_start_cost(i - 1);
          end loop;
        end if;
      end if;
      pathsleft_cost_0_any := line_starts_phases(16) or (not is_set(pathsleft_write_count_phase, 1)) or (not
        is_set(pathsleft_write_count_phase, 0));
      if pathsleft_cost_0_any then
        pathsleft_cost(0) <= (pathsleft_stay(0) + pathsleft_stay_change(0)) mod 128;
        pathsleft_cost(1) <= (pathsleft_stay(1) + pathsleft_stay_change(1)) mod 128;
        pathsleft_cost(2) <= (pathsleft_stay(2) + pathsleft_stay_change(2)) mod 128;
        pathsleft_arrived(0) <= (pathsleft_step(0) + pathsleft_step_change(0)) mod 128;
        pathsleft_arrived(1) <= (pathsleft_step(1) + pathsleft_step_change(1)) mod 128;
        pathsleft_arrived(2) <= (pathsleft_step(2) + pathsleft_step_change(2)) mod 128;
      end if;
      if line_starts_phases(23) then
        pathsleft_low_write_address <= (pathsleft_low_write_address + 1) mod 16;
      end if;
      -- pathsabove
      if line_places_first_column(1) then
        pathsabove_memory_read_address_0_choice := 0;
      else
        pathsabove_memory_read_address_0_choice := (pathsabove_memory_read_address_0 + 1) mod 128;
      end if;
      if pathsabove_read_address_count_phase = 3 then
        pathsabove_read_address_count_phase_choice := 3;
      else
        pathsabove_read_address_count_phase_choice := (pathsabove_read_address_count_phase + 1) mod 4;
      end if;
      if line_places_first_column(1) then
        pathsabove_ready_top_choice := pathsabove_ready_top or line_starts_phases(7);
      else
        pathsabove_ready_top_choice := pathsabove_ready_top;
      end if;
      if line_places_first_column(1) then
        pathsabove_ready_top_choice_2 := pathsabove_ready_top and (not line_starts_phases(7));
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
        pathsabove_total_choice(2) := pathsabove_memory_ready_words_0 / 1024;
      end if;
      if line_comes(11) then
        pathsabove_smallest_total_choice := 63;
      else
        pathsabove_smallest_total_choice := pathsabove_smallest_total;
      end if;
      pathsabove_count_phase_is_equal := pathsabove_count_phase = 3;
      if pathsabove_count_phase_is_equal then
        pathsabove_count_phase_choice := 3;
      else
        pathsabove_count_phase_choice := (pathsabove_count_phase + 1) mod 4;
      end if;
      if pathsabove_count_phase = 0 then
        pathsabove_beside_0_choice := pathsabove_held(1);
      else
        pathsabove_beside_0_choice := pathsabove_lower_neighbour;
      end if;
      if pathsabove_count_phase_is_equal then
        pathsabove_beside_2_choice := pathsabove_held(1);
      else
        pathsabove_beside_2_choice := pathsabove_cost(0);
      end if;
      if line_places_first_column(4) then
        pathsabove_write_address_address_choice := 0;
      else
        pathsabove_write_address_address_choice := (pathsabove_write_address_address + 1) mod 128;
      end if;
      if pathsabove_write_address_count_phase = 3 then
        pathsabove_write_address_count_phase_choice := 3;
      else
        pathsabove_write_address_count_phase_choice := (pathsabove_write_address_count_phase + 1) mod 4;
      end if;
      pathsabove_memory_ready_words_0 <= to_integer(pathsabove_memory_read_words_0_0);
      pathsabove_total(0) <= costs_cost(0) + pathsabove_total_choice(0);
      pathsabove_total(1) <= costs_cost(1) + pathsabove_total_choice(1);
      pathsabove_total(2) <= costs_cost(2) + pathsabove_total_choice(2);
      pathsabove_tree_smallest(1) <= pathsabove_total(2);
      pathsabove_cost(0) <= (to_integer(pathsabove_delay_held_0) - pathsabove_smallest) mod 64;
      pathsabove_cost(1) <= (to_integer(pathsabove_delay_held_0(17 downto 6)) - pathsabove_smallest) mod 64;
      pathsabove_cost(2) <= (to_integer(pathsabove_delay_held_0(17 downto 12)) - pathsabove_smallest) mod 64;
      pathsabove_held(0) <= pathsabove_cost(0);
      pathsabove_held(1) <= pathsabove_cost(1);
      pathsabove_held(2) <= pathsabove_cost(2);
      pathsabove_lower_neighbour <= pathsabove_held(2);
      pathsabove_own(0) <= pathsabove_held(0);
      pathsabove_own(1) <= pathsabove_held(1);
      pathsabove_step(0) <= pathsabove_beside(0) + 5;
      pathsabove_step(1) <= pathsabove_beside(1) + 5;
      pathsabove_step(2) <= pathsabove_beside(2) + 5;
      pathsabove_write_address_is_here <= line_starts_phases(19) or (not is_set(pathsabove_write_address_count_phase,
        1)) or (not is_set(pathsabove_write_address_count_phase, 0));
      if line_starts_phases(5) then
        pathsabove_memory_read_address_0 <= pathsabove_memory_read_address_0_choice;
        pathsabove_read_address_count_phase <= 0;
      else
        pathsabove_memory_read_address_0 <= (pathsabove_memory_read_address_0 + as_number(((not
          is_set(pathsabove_read_address_count_phase, 1)) or (not is_set(pathsabove_read_address_count_phase, 0)))))
          mod 128;
        pathsabove_read_address_count_phase <= pathsabove_read_address_count_phase_choice;
      end if;
      if line_places_top(1) then
        pathsabove_ready_top <= pathsabove_ready_top_choice;
      else
        pathsabove_ready_top <= pathsabove_ready_top_choice_2;
      end if;
      if (pathsabove_total(1) - pathsabove_total(0)) < 0 then
        pathsabove_tree_smallest(0) <= pathsabove_total(1);
      else
        pathsabove_tree_smallest(0) <= pathsabove_total(0);
      end if;
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
      if line_starts_phases(17) then
        pathsabove_count_phase <= 0;
      else
        pathsabove_count_phase <= pathsabove_count_phase_choice;
      end if;
      if (pathsabove_held(1) - pathsabove_beside_0_choice) < 0 then
        pathsabove_beside(0) <= pathsabove_held(1);
      else
        pathsabove_beside(0) <= pathsabove_beside_0_choice;
      end if;
      if (pathsabove_held(2) - pathsabove_held(0)) < 0 then
        pathsabove_beside(1) <= pathsabove_held(2);
      else
        pathsabove_beside(1) <= pathsabove_held(0);
      end if;
      if (pathsabove_beside_2_choice - pathsabove_held(1)) < 0 then
        pathsabove_beside(2) <= pathsabove_beside_2_choice;
      else
        pathsabove_beside(2) <= pathsabove_held(1);
      end if;
      for i in 0 to 1 loop
        if pathsabove_own(i) < 31 then
          pathsabove_stay(i) <= pathsabove_own(i) mod 32;
        else
          pathsabove_stay(i) <= 31;
        end if;
      end loop;
      if pathsabove_lower_neighbour < 31 then
        pathsabove_stay(2) <= pathsabove_lower_neighbour mod 32;
      else
        pathsabove_stay(2) <= 31;
      end if;
      if line_starts_phases(19) then
        pathsabove_write_address_address <= pathsabove_write_address_address_choice;
        pathsabove_write_address_count_phase <= 0;
      else
        pathsabove_write_address_address <= (pathsabove_write_address_address + as_number(((not
          is_set(pathsabove_write_address_count_phase, 1)) or (not is_set(pathsabove_write_address_count_phase, 0)))))
          mod 128;
        pathsabove_write_address_count_phase <= pathsabove_write_address_count_phase_choice;
      end if;
      if (pathsabove_step(1) - pathsabove_stay(1)) < 0 then
        pathsabove_memory_write_words_0_0_choice := pathsabove_step(1) mod 32;
      else
        pathsabove_memory_write_words_0_0_choice := pathsabove_stay(1);
      end if;
      for i in 2 to 3 loop
        if (pathsabove_step(2 * i - 4) - pathsabove_stay(2 * i - 4)) < 0 then
          pathsabove_memory_write_words_0_0_choices(i) := pathsabove_step(2 * i - 4) mod 32;
        else
          pathsabove_memory_write_words_0_0_choices(i) := pathsabove_stay(2 * i - 4);
        end if;
      end loop;
      if pathsabove_write_address_is_here then
        pathsabove_memory_write_words_0_0 <= (pathsabove_memory_write_words_0_0_choice * 32) +
          pathsabove_memory_write_words_0_0_choices(2) + (pathsabove_memory_write_words_0_0_choices(3) * 1024);
        pathsabove_memory_write_address_0 <= pathsabove_write_address_address;
      end if;
      if line_comes(15) then
        pathsabove_smallest <= pathsabove_smallest_total;
      end if;
      -- pathsturn
      if pathsturn_write_address_count_phase = 3 then
        pathsturn_write_address_count_phase_choice := 3;
      else
        pathsturn_write_address_count_phase_choice := (pathsturn_write_address_count_phase + 1) mod 4;
      end if;
      pathsturn_sum_memory_ready_words_0 <= to_integer(pathsturn_sum_memory_read_words_0_0);
      pathsturn_sum_memory_ready_words_1 <= to_integer(pathsturn_sum_memory_read_words_0_1);
      pathsturn_cost_memory_ready_words_0 <= to_integer(pathsturn_cost_memory_read_words_0_0);
      pathsturn_cost_memory_write_address_0 <= pathsturn_sum_memory_read_address_0;
      pathsturn_ready_smallest_0 <= to_integer(pathsturn_read_smallest_0);
      pathsturn_sum_read_address <= pathsturn_cost_memory_read_address_0;
      pathsturn_write_smallest_0 <= paths_smallest_cost;
      pathsturn_write_address_address <= pathsturn_sum_read_address;
      pathsturn_write_address_is_here <= line_starts_phases(14) or (not is_set(pathsturn_write_address_count_phase, 1))
        or (not is_set(pathsturn_write_address_count_phase, 0));
      pathsturn_sum_write_address(1) <= pathsturn_cost_memory_write_address_0;
      pathsturn_writes_sums(0) <= pathsturn_write_address_is_here;
      pathsturn_writes_sums(1) <= pathsturn_writes_sums(0);
      if line_starts_phases(14) then
        pathsturn_sum_memory_read_address_0 <= line_places_address(3) * 4;
        pathsturn_write_smallest_address <= line_places_address(3);
        pathsturn_write_address_count_phase <= 0;
      else
        pathsturn_sum_memory_read_address_0 <= (pathsturn_sum_memory_read_address_0 + as_number(((not
          is_set(pathsturn_write_address_count_phase, 1)) or (not is_set(pathsturn_write_address_count_phase, 0)))))
          mod 128;
        pathsturn_write_smallest_address <= 29;
        pathsturn_write_address_count_phase <= pathsturn_write_address_count_phase_choice;
      end if;
      if line_starts_phases(12) then
        pathsturn_cost_memory_read_address_0 <= line_places_address(2) * 4;
      else
        pathsturn_cost_memory_read_address_0 <= (pathsturn_cost_memory_read_address_0 + as_number(((not
          is_set(pathsleft_ahead_count_phase, 1)) or (not is_set(pathsleft_ahead_count_phase, 0))))) mod 128;
      end if;
      pathsturn_sum_memory_write_words_0_0_sum := pathsleft_cost(2) + pathsabove_cost(2);
      if pathsturn_writes_sums(1) then
        pathsturn_sum_memory_write_words_0_0 <= (((pathsleft_cost(1) + pathsabove_cost(1)) mod 128) * 128) +
          ((pathsleft_cost(0) + pathsabove_cost(0)) mod 128) + ((pathsturn_sum_memory_write_words_0_0_sum mod 4) *
          16384);
        pathsturn_sum_memory_write_words_0_1 <= (pathsturn_sum_memory_write_words_0_0_sum mod 128) / 4;
        pathsturn_sum_memory_write_address_0 <= pathsturn_sum_write_address(1);
      end if;
      if pathsturn_write_address_is_here then
        pathsturn_cost_memory_write_words_0_0 <= to_integer(paths_cost_delay_held_0);
        pathsturn_sum_write_address(0) <= pathsturn_sum_memory_read_address_0;
      end if;
      if line_starts_phases(11) then
        pathsturn_smallest_address <= line_places_address(2);
      end if;
      -- pathsright
      if line_starts_phases(6) then
        pathsright_fresh_past_newest(0) <= relief_right(1);
        pathsright_fresh_past_newest(1) <= pathsright_fresh_past_newest(0);
      end if;
      if line_starts_phases(7) then
        pathsright_fresh_past_pairs(1) <= pathsright_fresh_past_pairs(0);
        pathsright_fresh_past_pairs(2) <= pathsright_fresh_past_pairs(1);
        if (pathsright_fresh_past_newest(1) - pathsright_fresh_past_newest(0)) < 0 then
          pathsright_fresh_past_pairs(0) <= pathsright_fresh_past_newest(1);
        else
          pathsright_fresh_past_pairs(0) <= pathsright_fresh_past_newest(0);
        end if;
      end if;
      if line_starts_phases(8) then
        pathsright_fresh_past_fours(1) <= pathsright_fresh_past_fours(0);
        pathsright_fresh_past_fours(2) <= pathsright_fresh_past_fours(1);
        pathsright_fresh_past_fours(3) <= pathsright_fresh_past_fours(2);
        pathsright_fresh_past_fours(4) <= pathsright_fresh_past_fours(3);
        if (pathsright_fresh_past_pairs(2) - pathsright_fresh_past_pairs(0)) < 0 then
          pathsright_fresh_past_fours(0) <= pathsright_fresh_past_pairs(2);
        else
          pathsright_fresh_past_fours(0) <= pathsright_fresh_past_pairs(0);
        end if;
      end if;
      pathsright_lower_neighbour_value := to_integer(pathsright_read_words_0(20 downto 14));
      pathsright_stay_value(0) := pathsright_read_words_0(21) = '1';
      pathsright_stay_0_values(2) := is_set(pathsright_fresh_here, 1);
      pathsright_stay_0_is_equal := (pathsright_fresh_here mod 4) = 0;
      if pathsright_stay_value(0) then
        pathsright_stay_choice(0) := not pathsright_stay_0_values(2);
      else
        pathsright_stay_choice(0) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words_0(22) = '1' then
        pathsright_stay_choices(0, 2) := pathsright_stay_value(0) or (not pathsright_stay_0_values(2)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(0, 2) := pathsright_stay_choice(0);
      end if;
      pathsright_stay_0_values(3) := is_set(pathsright_fresh_here, 2);
      if pathsright_stay_choices(0, 2) then
        pathsright_stay_choices(0, 3) := (not (pathsright_read_words_0(23) = '1')) and pathsright_stay_0_values(3);
      else
        pathsright_stay_choices(0, 3) := (not (pathsright_read_words_0(23) = '1')) or pathsright_stay_0_values(3);
      end if;
      for i in 4 to 6 loop
        pathsright_stay_0_values(i) := is_set(pathsright_fresh_here, i - 1);
        if pathsright_stay_choices(0, i - 1) then
          pathsright_stay_choices(0, i) := (not (pathsright_read_words_0(i + 20) = '1')) or pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(0, i) := (not (pathsright_read_words_0(i + 20) = '1')) and
            pathsright_stay_0_values(i);
        end if;
      end loop;
      if pathsright_stay_choices(0, 6) then
        pathsright_stay_choices(0, 7) := (not (pathsright_read_words_0(27) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(0, 7) := (not (pathsright_read_words_0(27) = '1')) and is_set(pathsright_fresh_here, 6);
      end if;
      if is_set(pathsright_fresh_here, 0) then
        pathsright_stay_choices(0, 8) := (not (pathsright_read_words_0(1) = '1')) or (not (pathsright_read_words_0(0) =
          '1'));
      else
        pathsright_stay_choices(0, 8) := not (pathsright_read_words_0(1) = '1');
      end if;
      if pathsright_stay_0_values(2) then
        pathsright_stay_choices(0, 9) := pathsright_stay_choices(0, 8);
      else
        pathsright_stay_choices(0, 9) := is_set(pathsright_fresh_here, 0) and (to_integer(pathsright_read_words_0(1
          downto 0)) = 0);
      end if;
      pathsright_stay_0_values(7) := pathsright_read_words_0(2) = '1';
      if pathsright_stay_choices(0, 9) then
        pathsright_stay_choices(0, 10) := (not pathsright_stay_0_values(3)) and pathsright_stay_0_values(7);
      else
        pathsright_stay_choices(0, 10) := (not pathsright_stay_0_values(3)) or pathsright_stay_0_values(7);
      end if;
      for i in 8 to 10 loop
        pathsright_stay_0_values(i) := pathsright_read_words_0(i - 5) = '1';
        if pathsright_stay_choices(0, i + 2) then
          pathsright_stay_choices(0, i + 3) := (not pathsright_stay_0_values(i - 4)) or pathsright_stay_0_values(i);
        else
          pathsright_stay_choices(0, i + 3) := (not pathsright_stay_0_values(i - 4)) and pathsright_stay_0_values(i);
        end if;
      end loop;
      pathsright_stay_0_values(11) := pathsright_read_words_0(6) = '1';
      if pathsright_stay_choices(0, 13) then
        pathsright_stay_choices(0, 14) := (not is_set(pathsright_fresh_here, 6)) or pathsright_stay_0_values(11);
      else
        pathsright_stay_choices(0, 14) := (not is_set(pathsright_fresh_here, 6)) and pathsright_stay_0_values(11);
      end if;
      if pathsright_stay_choices(0, 7) then
        pathsright_stay_choices(0, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(0, 15) := (not pathsright_stay_choices(0, 14)) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words_0(27 downto 21)) - to_integer(pathsright_read_words_0(6 downto 0))) < 0 then
        pathsright_stay_choice_16(0) := to_integer(pathsright_read_words_0(27 downto 21));
      else
        pathsright_stay_choice_16(0) := to_integer(pathsright_read_words_0(6 downto 0));
      end if;
      if pathsright_read_words_1(0) = '1' then
        pathsright_stay_choice(1) := not pathsright_stay_0_values(2);
      else
        pathsright_stay_choice(1) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words_1(1) = '1' then
        pathsright_stay_choices(1, 2) := (pathsright_read_words_1(0) = '1') or (not pathsright_stay_0_values(2)) or
          (not is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(1, 2) := pathsright_stay_choice(1);
      end if;
      if pathsright_stay_choices(1, 2) then
        pathsright_stay_choices(1, 3) := (not (pathsright_read_words_1(2) = '1')) and pathsright_stay_0_values(3);
      else
        pathsright_stay_choices(1, 3) := (not (pathsright_read_words_1(2) = '1')) or pathsright_stay_0_values(3);
      end if;
      for i in 3 to 5 loop
        if pathsright_stay_choices(1, i) then
          pathsright_stay_choices(1, i + 1) := (not (pathsright_read_words_1(i) = '1')) or pathsright_stay_0_values(i +
            1);
        else
          pathsright_stay_choices(1, i + 1) := (not (pathsright_read_words_1(i) = '1')) and pathsright_stay_0_values(i
            + 1);
        end if;
      end loop;
      if pathsright_stay_choices(1, 6) then
        pathsright_stay_choices(1, 7) := (not (pathsright_read_words_1(6) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(1, 7) := (not (pathsright_read_words_1(6) = '1')) and is_set(pathsright_fresh_here, 6);
      end if;
      pathsright_stay_value(1) := pathsright_read_words_0(7) = '1';
      if pathsright_stay_value(1) then
        pathsright_stay_choices(1, 8) := not pathsright_stay_0_values(2);
      else
        pathsright_stay_choices(1, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words_0(8) = '1' then
        pathsright_stay_choices(1, 9) := pathsright_stay_value(1) or (not pathsright_stay_0_values(2)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(1, 9) := pathsright_stay_choices(1, 8);
      end if;
      if pathsright_stay_choices(1, 9) then
        pathsright_stay_choices(1, 10) := (not (pathsright_read_words_0(9) = '1')) and pathsright_stay_0_values(3);
      else
        pathsright_stay_choices(1, 10) := (not (pathsright_read_words_0(9) = '1')) or pathsright_stay_0_values(3);
      end if;
      for i in 10 to 12 loop
        if pathsright_stay_choices(1, i) then
          pathsright_stay_choices(1, i + 1) := (not (pathsright_read_words_0(i) = '1')) or pathsright_stay_0_values(i -
            6);
        else
          pathsright_stay_choices(1, i + 1) := (not (pathsright_read_words_0(i) = '1')) and pathsright_stay_0_values(i
            - 6);
        end if;
      end loop;
      if pathsright_stay_choices(1, 13) then
        pathsright_stay_choices(1, 14) := (not (pathsright_read_words_0(13) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(1, 14) := (not (pathsright_read_words_0(13) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(1, 7) then
        pathsright_stay_choices(1, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(1, 15) := pathsright_stay_choices(1, 14) and (not pathsleft_first);
      end if;
      pathsright_stay_1_value_2 := to_integer(pathsright_read_words_0(13 downto 7));
      if (to_integer(pathsright_read_words_1(6 downto 0)) - pathsright_stay_1_value_2) < 0 then
        pathsright_stay_choice_16(1) := to_integer(pathsright_read_words_1(6 downto 0));
      else
        pathsright_stay_choice_16(1) := pathsright_stay_1_value_2;
      end if;
      pathsright_stay_value(2) := pathsright_read_words_1(7) = '1';
      if pathsright_stay_value(2) then
        pathsright_stay_choice(2) := not pathsright_stay_0_values(2);
      else
        pathsright_stay_choice(2) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words_1(8) = '1' then
        pathsright_stay_choices(2, 2) := pathsright_stay_value(2) or (not pathsright_stay_0_values(2)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(2, 2) := pathsright_stay_choice(2);
      end if;
      if pathsright_stay_choices(2, 2) then
        pathsright_stay_choices(2, 3) := (not (pathsright_read_words_1(9) = '1')) and pathsright_stay_0_values(3);
      else
        pathsright_stay_choices(2, 3) := (not (pathsright_read_words_1(9) = '1')) or pathsright_stay_0_values(3);
      end if;
      for i in 3 to 5 loop
        if pathsright_stay_choices(2, i) then
          pathsright_stay_choices(2, i + 1) := (not (pathsright_read_words_1(i + 7) = '1')) or
            pathsright_stay_0_values(i + 1);
        else
          pathsright_stay_choices(2, i + 1) := (not (pathsright_read_words_1(i + 7) = '1')) and
            pathsright_stay_0_values(i + 1);
        end if;
      end loop;
      if pathsright_stay_choices(2, 6) then
        pathsright_stay_choices(2, 7) := (not (pathsright_read_words_1(13) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(2, 7) := (not (pathsright_read_words_1(13) = '1')) and is_set(pathsright_fresh_here, 6);
      end if;
      pathsright_stay_2_value_2 := pathsright_read_words_0(14) = '1';
      if pathsright_stay_2_value_2 then
        pathsright_stay_choices(2, 8) := not pathsright_stay_0_values(2);
      else
        pathsright_stay_choices(2, 8) := pathsright_stay_0_is_equal;
      end if;
      if pathsright_read_words_0(15) = '1' then
        pathsright_stay_choices(2, 9) := pathsright_stay_2_value_2 or (not pathsright_stay_0_values(2)) or (not
          is_set(pathsright_fresh_here, 0));
      else
        pathsright_stay_choices(2, 9) := pathsright_stay_choices(2, 8);
      end if;
      if pathsright_stay_choices(2, 9) then
        pathsright_stay_choices(2, 10) := (not (pathsright_read_words_0(16) = '1')) and pathsright_stay_0_values(3);
      else
        pathsright_stay_choices(2, 10) := (not (pathsright_read_words_0(16) = '1')) or pathsright_stay_0_values(3);
      end if;
      for i in 10 to 12 loop
        if pathsright_stay_choices(2, i) then
          pathsright_stay_choices(2, i + 1) := (not (pathsright_read_words_0(i + 7) = '1')) or
            pathsright_stay_0_values(i - 6);
        else
          pathsright_stay_choices(2, i + 1) := (not (pathsright_read_words_0(i + 7) = '1')) and
            pathsright_stay_0_values(i - 6);
        end if;
      end loop;
      if pathsright_stay_choices(2, 13) then
        pathsright_stay_choices(2, 14) := (not (pathsright_read_words_0(20) = '1')) or is_set(pathsright_fresh_here, 6);
      else
        pathsright_stay_choices(2, 14) := (not (pathsright_read_words_0(20) = '1')) and is_set(pathsright_fresh_here,
          6);
      end if;
      if pathsright_stay_choices(2, 7) then
        pathsright_stay_choices(2, 15) := not pathsleft_first;
      else
        pathsright_stay_choices(2, 15) := pathsright_stay_choices(2, 14) and (not pathsleft_first);
      end if;
      if (to_integer(pathsright_read_words_1(13 downto 7)) - pathsright_lower_neighbour_value) < 0 then
        pathsright_stay_choice_16(2) := to_integer(pathsright_read_words_1(13 downto 7));
      else
        pathsright_stay_choice_16(2) := pathsright_lower_neighbour_value;
      end if;
      if line_starts_phases(15) then
        pathsright_step_choice(0) := pathsright_stay_1_value_2;
      else
        pathsright_step_choice(0) := pathsright_lower_neighbour;
      end if;
      if (pathsright_stay_1_value_2 - pathsright_step_choice(0)) < 0 then
        pathsright_step_0_choice_2 := pathsright_stay_1_value_2;
      else
        pathsright_step_0_choice_2 := pathsright_step_choice(0);
      end if;
      if (pathsright_lower_neighbour_value - to_integer(pathsright_read_words_0(6 downto 0))) < 0 then
        pathsright_step_choice(1) := pathsright_lower_neighbour_value;
      else
        pathsright_step_choice(1) := to_integer(pathsright_read_words_0(6 downto 0));
      end if;
      if pathsleft_passes_by then
        pathsright_step_choice(2) := pathsright_passed_by;
      else
        pathsright_step_choice(2) := to_integer(pathsright_read_neighbour_0);
      end if;
      if pathsleft_is_last then
        pathsright_step_2_choices(2) := pathsright_stay_1_value_2;
      else
        pathsright_step_2_choices(2) := pathsright_step_choice(2);
      end if;
      if (pathsright_step_2_choices(2) - pathsright_stay_1_value_2) < 0 then
        pathsright_step_2_choices(3) := pathsright_step_2_choices(2);
      else
        pathsright_step_2_choices(3) := pathsright_stay_1_value_2;
      end if;
      pathsright_stay_change_1_value := (pathsturn_cost_memory_ready_words_0 mod 64) / 8;
      if line_comes(19) then
        pathsright_low_0_choice := 127;
      else
        pathsright_low_0_choice := pathsright_low_0;
      end if;
      pathsright_lost <= is_set(pathsright_fresh_known, 6);
      pathsright_short_of <= (((pathsleft_fresh_known mod 64) + pathsleft_room) / 64) = 1;
      pathsright_missing <= (pathsright_fresh_known + pathsright_room) mod 64;
      pathsright_below <= (0 - pathsright_fresh_known) mod 64;
      pathsright_passed_by <= pathsright_cost(0);
      pathsright_lower_neighbour <= pathsright_lower_neighbour_value;
      pathsright_stay_change(0) <= ((pathsturn_cost_memory_ready_words_0 mod 8) - pathsright_g) mod 128;
      pathsright_stay_change(1) <= (pathsright_stay_change_1_value - pathsright_g) mod 128;
      pathsright_stay_change(2) <= ((pathsturn_cost_memory_ready_words_0 / 64) - pathsright_g) mod 128;
      pathsright_step_change(0) <= ((pathsturn_cost_memory_ready_words_0 mod 8) - pathsright_g_less) mod 128;
      pathsright_step_change(1) <= (pathsright_stay_change_1_value - pathsright_g_less) mod 128;
      pathsright_step_change(2) <= ((pathsturn_cost_memory_ready_words_0 / 64) - pathsright_g_less) mod 128;
      pathsright_tree_smallest(1) <= pathsright_cost(2);
      if (pathsright_fresh_past_fours(4) - pathsright_fresh_past_fours(0)) < 0 then
        pathsright_fresh_past_cheapest <= pathsright_fresh_past_fours(4);
      else
        pathsright_fresh_past_cheapest <= pathsright_fresh_past_fours(0);
      end if;
      if (pathsright_fresh_past_cheapest - to_integer(pathsright_lowest_0)) < 0 then
        pathsright_fresh_known <= pathsright_fresh_past_cheapest;
      else
        pathsright_fresh_known <= to_integer(pathsright_lowest_0);
      end if;
      for i in 0 to 2 loop
        if pathsright_stay_choices(i, 15) then
          pathsright_stay(i) <= pathsright_stay_choice_16(i);
        else
          pathsright_stay(i) <= pathsright_fresh_here;
        end if;
      end loop;
      if pathsleft_first then
        pathsright_step(0) <= 64;
        pathsright_step(1) <= 64;
        pathsright_step(2) <= 64;
      else
        pathsright_step(0) <= pathsright_step_0_choice_2;
        pathsright_step(1) <= pathsright_step_choice(1);
        pathsright_step(2) <= pathsright_step_2_choices(3);
      end if;
      if (pathsright_cost(1) - pathsright_cost(0)) < 0 then
        pathsright_tree_smallest(0) <= pathsright_cost(1);
      else
        pathsright_tree_smallest(0) <= pathsright_cost(0);
      end if;
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
      if line_starts_phases(14) then
        pathsright_fresh_here <= relief_right(3);
        pathsright_g <= pathsturn_ready_smallest_0 + pathsright_q_now;
        pathsright_g_less <= (pathsturn_ready_smallest_0 + pathsright_q_less) mod 128;
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
      if line_starts_phases(12) then
        if line_places_first_column(2) then
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
      if line_starts_phases(13) then
        pathsright_q_now <= pathsright_q;
        pathsright_q_less <= (pathsright_q + 121) mod 128;
        if line_places_first_column(3) then
          pathsright_room <= 0;
          for i in 1 to 6 loop
            pathsright_start_cost(i) <= 0;
          end loop;
        else
          pathsright_room <= (pathsright_room_left + pathsright_start_cost(6)) mod 64;
          pathsright_start_cost(1) <= pathsright_q_now;
          for i in 2 to 6 loop
            pathsright_start_cost(i) <= pathsright_start_cost(i - 1);
          end loop;
        end if;
      end if;
      if pathsleft_cost_0_any then
        pathsright_cost(0) <= (pathsright_stay(0) + pathsright_stay_change(0)) mod 128;
        pathsright_cost(1) <= (pathsright_stay(1) + pathsright_stay_change(1)) mod 128;
        pathsright_cost(2) <= (pathsright_stay(2) + pathsright_stay_change(2)) mod 128;
        pathsright_arrived(0) <= (pathsright_step(0) + pathsright_step_change(0)) mod 128;
        pathsright_arrived(1) <= (pathsright_step(1) + pathsright_step_change(1)) mod 128;
        pathsright_arrived(2) <= (pathsright_step(2) + pathsright_step_change(2)) mod 128;
      end if;
      -- winnerswinner1
      if is_set(paths_sum(2), 0) then
        winnerswinner1_best_index_0_0_choice := (not is_set(paths_sum(1), 1)) or (not is_set(paths_sum(1), 0));
      else
        winnerswinner1_best_index_0_0_choice := not is_set(paths_sum(1), 1);
      end if;
      if is_set(paths_sum(2), 1) then
        winnerswinner1_best_index_0_0_choices(2) := winnerswinner1_best_index_0_0_choice;
      else
        winnerswinner1_best_index_0_0_choices(2) := is_set(paths_sum(2), 0) and ((paths_sum(1) mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_0_value := is_set(paths_sum(1), 2);
      if winnerswinner1_best_index_0_0_choices(2) then
        winnerswinner1_best_index_0_0_choices(3) := (not is_set(paths_sum(2), 2)) and
          winnerswinner1_best_index_0_0_value;
      else
        winnerswinner1_best_index_0_0_choices(3) := (not is_set(paths_sum(2), 2)) or
          winnerswinner1_best_index_0_0_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_best_index_0_0_values(i) := is_set(paths_sum(1), i + 1);
        if winnerswinner1_best_index_0_0_choices(i + 1) then
          winnerswinner1_best_index_0_0_choices(i + 2) := (not is_set(paths_sum(2), i + 1)) or
            winnerswinner1_best_index_0_0_values(i);
        else
          winnerswinner1_best_index_0_0_choices(i + 2) := (not is_set(paths_sum(2), i + 1)) and
            winnerswinner1_best_index_0_0_values(i);
        end if;
      end loop;
      winnerswinner1_best_cost_0(1) <= paths_sum(0);
      winnerswinner1_best_index_0_1 <= 2;
      if (paths_sum(1) - paths_sum(2)) < 0 then
        winnerswinner1_best_cost_0(0) <= paths_sum(1);
      else
        winnerswinner1_best_cost_0(0) <= paths_sum(2);
      end if;
      if winnerswinner1_best_index_0_0_choices(7) then
        winnerswinner1_best_index_0_0 <= is_set(paths_sum(2), 7) and (not is_set(paths_sum(1), 7));
      else
        winnerswinner1_best_index_0_0 <= is_set(paths_sum(2), 7) or (not is_set(paths_sum(1), 7));
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
      if line_comes(20) then
        winners_best_cost_0_0_choice := 511;
      else
        winners_best_cost_0_0_choice := winners_best_cost_0_0;
      end if;
      winners_best_cost_0_0_is_less := (winners_best_cost_0_0_choice - winnerswinner2_best_cost_0_0) < 0;
      if line_comes(20) then
        winners_best_cost_0_0_choice_2 := 255;
      else
        winners_best_cost_0_0_choice_2 := winners_best_cost_0_0;
      end if;
      winners_best_tag_valid <= line_comes(23);
      winners_best_tag_map_column <= line_places_map_column(5);
      winners_best_tag_output_column <= line_places_shown_output_column(5);
      winners_best_tag_start_of_frame <= line_places_shown_start_of_frame(5);
      winners_best_tag_end_of_line <= line_places_shown_end_of_line(5);
      if winners_best_cost_0_0_is_less then
        winners_best_cost_0_0 <= winners_best_cost_0_0_choice_2;
        winners_best_index_0_0 <= (winners_best_index_0_0 + 3) mod 256;
      else
        winners_best_cost_0_0 <= winnerswinner2_best_cost_0_0;
        winners_best_index_0_0 <= winnerswinner2_best_index_0_0;
      end if;
      -- turn
      turn_order_address_any := turn_order_inside or (not winners_best_tag_map_column) or (not winners_best_tag_valid);
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
      turn_order_address_any_2 := (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 32;
        else
          turn_order_address <= turn_order_address_choice_2 * 4;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and winners_best_tag_map_column and winners_best_tag_valid;
      turn_order_complete_all := winners_best_tag_map_column and winners_best_tag_valid;
      if turn_order_falls_all then
        turn_order_turned_output_column_choice := turn_order_complete and turn_order_output;
      else
        turn_order_turned_output_column_choice := turn_order_held_output;
      end if;
      turn_order_turned_valid <= winners_best_tag_valid;
      turn_order_turned_output_column <= turn_order_turned_output_column_choice and winners_best_tag_map_column;
      turn_order_turned_start_of_frame <= (not turn_order_inside) and winners_best_tag_map_column and
        winners_best_tag_valid and turn_order_first and turn_order_complete and turn_order_output;
      turn_order_turned_end_of_line <= winners_best_tag_end_of_line;
      turn_newest <= winners_best_index_0_0 + 256;
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
      if winners_best_tag_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if turn_comes then
        turn_write_place <= turn_order_address;
      else
        turn_write_place <= 29;
      end if;
      if winners_best_tag_valid then
        turn_order_inside <= winners_best_tag_map_column;
      end if;
      if turn_order_falls_all then
        turn_order_output <= winners_best_tag_output_column;
        turn_order_first <= winners_best_tag_start_of_frame;
        turn_order_held_output <= turn_order_complete and turn_order_output;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
      end if;
      -- relief
      if transform_columns_valid then
        relief_centre_column(0) <= transform_right_column_2;
        relief_centre_column(1) <= relief_centre_column(0);
        relief_centre_column(2) <= relief_centre_column(1);
        relief_centre_column(3) <= relief_centre_column(2);
        relief_centre_column(4) <= relief_centre_column(3);
      end if;
      if is_set(relief_centre_grey_0, 0) then
        relief_newest_choice := (not is_set(relief_before, 1)) or (not is_set(relief_before, 0));
      else
        relief_newest_choice := not is_set(relief_before, 1);
      end if;
      if is_set(relief_centre_grey_0, 1) then
        relief_newest_choices(2) := relief_newest_choice;
      else
        relief_newest_choices(2) := is_set(relief_centre_grey_0, 0) and ((relief_before mod 4) = 0);
      end if;
      relief_newest_value := is_set(relief_before, 2);
      if relief_newest_choices(2) then
        relief_newest_choices(3) := (not is_set(relief_centre_grey_0, 2)) and relief_newest_value;
      else
        relief_newest_choices(3) := (not is_set(relief_centre_grey_0, 2)) or relief_newest_value;
      end if;
      for i in 2 to 5 loop
        relief_newest_values(i) := is_set(relief_before, i + 1);
        if relief_newest_choices(i + 1) then
          relief_newest_choices(i + 2) := (not is_set(relief_centre_grey_0, i + 1)) or relief_newest_values(i);
        else
          relief_newest_choices(i + 2) := (not is_set(relief_centre_grey_0, i + 1)) and relief_newest_values(i);
        end if;
      end loop;
      if relief_newest_choices(7) then
        relief_newest_choices(8) := (not is_set(relief_centre_grey_0, 7)) or is_set(relief_before, 7);
      else
        relief_newest_choices(8) := (not is_set(relief_centre_grey_0, 7)) and is_set(relief_before, 7);
      end if;
      relief_newest_values_from_6(6) := (relief_before - relief_centre_grey_0) mod 256;
      relief_newest_values_from_6(7) := (relief_centre_grey_0 - relief_before) mod 256;
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
        relief_newest_choices(16) := is_set(relief_centre_grey_0, 7) and (not is_set(relief_before, 7));
      else
        relief_newest_choices(16) := is_set(relief_centre_grey_0, 7) or (not is_set(relief_before, 7));
      end if;
      if relief_newest_choices(16) then
        relief_newest_choice_17 := (relief_newest_values_from_6(7) / 2) mod 64;
      else
        relief_newest_choice_17 := (relief_newest_values_from_6(6) / 2) mod 64;
      end if;
      relief_centre_grey_0 <= relief_centre_column(4);
      relief_rows_read_newest_0 <= to_integer(relief_delayed_0);
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
        relief_write_address <= 29;
      end if;
      if transform_filtering_valid(1) then
        relief_before <= relief_centre_grey_0;
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
      for i in 1 to 3 loop
        if line_comes(4 * i + 1) then
          relief_left(i) <= relief_left(i - 1);
          relief_right(i) <= relief_right(i - 1);
        end if;
      end loop;
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
        transform_filtering_start_of_frame(0) <= false;
        transform_filtering_valid(0) <= false;
        transform_filtering_start_of_frame(1) <= false;
        transform_filtering_valid(1) <= false;
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
        for i in 1 to 23 loop
          line_comes(i) <= false;
        end loop;
        for i in 1 to 14 loop
          line_starts_phases(i) <= false;
        end loop;
        for i in 16 to 23 loop
          line_starts_phases(i) <= false;
        end loop;
        for i in 0 to 3 loop
          line_places_map_column(i) <= false;
          line_places_first_column(i) <= false;
          line_places_address(i) <= 0;
          line_places_shown_output_column(i) <= false;
          line_places_shown_start_of_frame(i) <= false;
          line_places_shown_end_of_line(i) <= false;
        end loop;
        line_places_map_column(4) <= false;
        line_places_first_column(4) <= false;
        line_places_shown_output_column(4) <= false;
        line_places_shown_start_of_frame(4) <= false;
        line_places_shown_end_of_line(4) <= false;
        line_places_map_column(5) <= false;
        line_places_shown_output_column(5) <= false;
        line_places_shown_start_of_frame(5) <= false;
        line_places_shown_end_of_line(5) <= false;
        costsshift_new_tag_valid <= false;
        costsshift_count_phase <= 3;
        costsshift_read_tag_valid <= false;
        costsshift_read_count_phase <= 3;
        costsshift_write_phase <= 3;
        costswindow_read_count_phase <= 3;
        costswindow_write_count_phase <= 3;
        paths_cost_delay_ring_read_address <= 1;
        paths_cost_delay_ring_write_address <= 0;
        pathsleft_low_address <= 7;
        pathsleft_read_count_phase <= 3;
        pathsleft_ahead_count_phase <= 3;
        pathsleft_is_first <= false;
        pathsleft_write_count_phase <= 3;
        pathsleft_low_write_address <= 0;
        pathsabove_memory_read_address_0 <= 0;
        pathsabove_memory_write_address_0 <= 0;
        pathsabove_read_address_count_phase <= 3;
        pathsabove_write_address_address <= 0;
        pathsabove_write_address_is_here <= false;
        pathsabove_write_address_count_phase <= 3;
        pathsturn_sum_memory_read_address_0 <= 0;
        pathsturn_sum_memory_write_address_0 <= 0;
        pathsturn_cost_memory_read_address_0 <= 0;
        pathsturn_cost_memory_write_address_0 <= 0;
        pathsturn_smallest_address <= 0;
        pathsturn_sum_read_address <= 0;
        pathsturn_write_smallest_address <= 0;
        pathsturn_write_address_address <= 0;
        pathsturn_write_address_is_here <= false;
        pathsturn_write_address_count_phase <= 3;
        pathsturn_sum_write_address(0) <= 0;
        pathsturn_sum_write_address(1) <= 0;
        pathsturn_writes_sums(0) <= false;
        pathsturn_writes_sums(1) <= false;
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
        relief_write_address <= 0;
      end if;
    end if;
  end process;
end architecture;
