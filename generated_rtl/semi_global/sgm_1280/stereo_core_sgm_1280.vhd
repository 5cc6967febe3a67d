-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_1280: 1280x720, 64 disparities, window 1x1, P1 7, P2 60, 1 pixel pair a clock.
-- Options: window_px 1, reference left, census_width_px 9, census_pattern checkerboard, cost_shift 1,
--   cost_cap 5, p1 7, p2 60, p2_least 20, above_p1 5, above_p2 31, median true, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_1280
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_1280 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 1280;
    height_px : positive := 720;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 1217;
    latency_clocks : positive := 47;
    flush_groups : positive := 6409;
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
  assert width_px = 1280 report "stereo_core_sgm_1280: width_px is " & integer'image(width_px) & " but this core has 1280" severity failure;
  assert height_px = 720 report "stereo_core_sgm_1280: height_px is " & integer'image(height_px) & " but this core has 720" severity failure;
  assert disparities = 64 report "stereo_core_sgm_1280: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_1280: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_sgm_1280: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 1217 report "stereo_core_sgm_1280: output_width_px is " & integer'image(output_width_px) & " but this core has 1217" severity failure;
  assert latency_clocks = 47 report "stereo_core_sgm_1280: latency_clocks is " & integer'image(latency_clocks) & " but this core has 47" severity failure;
  assert flush_groups = 6409 report "stereo_core_sgm_1280: flush_groups is " & integer'image(flush_groups) & " but this core has 6409" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_1280: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_1280 is
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
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_1073741823_1d is array (natural range <>) of natural range 0 to 1073741823;
  type natural_11_1d is array (natural range <>) of natural range 0 to 11;
  type natural_11_2d is array (natural range <>, natural range <>) of natural range 0 to 11;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_190_1d is array (natural range <>) of natural range 0 to 190;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_22_1d is array (natural range <>) of natural range 0 to 22;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_3_2d is array (natural range <>, natural range <>) of natural range 0 to 3;
  type natural_4194303_1d is array (natural range <>) of natural range 0 to 4194303;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_68_1d is array (natural range <>) of natural range 0 to 68;
  type natural_68_2d is array (natural range <>, natural range <>) of natural range 0 to 68;
  type natural_7_2d is array (natural range <>, natural range <>) of natural range 0 to 7;
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type unsigned_31_1d is array (natural range <>) of unsigned(30 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column : natural_255_1d(0 to 4);
  signal transform_right_column : natural_255_1d(0 to 4);
  signal transform_left_filter_column : natural_255_2d(0 to 7, 0 to 4);
  signal transform_left_filter_column_8_0, transform_left_filter_column_8_2 : natural range 0 to 255;
  signal transform_left_filter_column_8_4 : natural range 0 to 255;
  signal transform_right_filter_column : natural_255_2d(0 to 7, 0 to 4);
  signal transform_right_filter_column_8_0, transform_right_filter_column_8_2 : natural range 0 to 255;
  signal transform_right_filter_column_8_4 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_read_row_inside : boolean_1d(0 to 4);
  signal transform_read_column_inside : boolean_1d(0 to 8);
  signal transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside : boolean_1d(0 to 4);
  signal transform_ready_column_inside : boolean_1d(0 to 8);
  signal transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_columns_row_inside : boolean_1d(0 to 4);
  signal transform_columns_column_inside : boolean_1d(0 to 8);
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside : boolean_1d(0 to 8);
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- transform_filtering_#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- transform_filtering_#_valid
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 2047;
  signal transform_write_column : natural range 0 to 2047;
  signal transform_counter_group : natural range 0 to 1023;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 4194303;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 4194303;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 2047;
  signal raster_place_group : natural range 0 to 1023;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 4194303;
  signal delay_tag_valid, delay_tag_border_column, delay_tag_first_cost, delay_tag_map_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_0, rows_reference_0 : natural range 0 to 4194303;
  signal rows_tag_valid, rows_tag_border_column, rows_tag_first_cost, rows_tag_map_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0 : natural_4194303_1d(0 to 15);
  signal slice0shift_reference_0, slice0shift_search_out_0 : natural range 0 to 4194303;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 6);  -- slice0cost_pixels_first_0_#_count_#
  signal slice0cost_pixels_first_0_count_7 : boolean_1d(0 to 15);  -- slice0cost_pixels_first_0_#_count_7
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
  signal slice0cost_pixels_cost_0 : natural_22_1d(0 to 15);
  signal slice0cost_single_0 : natural_22_1d(0 to 15);
  -- slice0window
  signal slice0window_tag_valid, slice0window_tag_border_column, slice0window_tag_first_cost : boolean;
  signal slice0window_tag_map_column, slice0window_tag_output_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  -- slice0
  signal slice0_held : natural_11_2d(0 to 3, 0 to 15);
  signal slice0_tag_valid : boolean_1d(0 to 3);  -- slice0_tag_#_valid
  signal slice0_tag_0_border_column : boolean;
  signal slice0_tag_first_cost : boolean_1d(0 to 3);  -- slice0_tag_#_first_cost
  signal slice0_tag_map_column : boolean_1d(0 to 3);  -- slice0_tag_#_map_column
  signal slice0_tag_output_column : boolean_1d(0 to 3);  -- slice0_tag_#_output_column
  signal slice0_tag_start_of_frame : boolean_1d(0 to 3);  -- slice0_tag_#_start_of_frame
  signal slice0_tag_end_of_line : boolean_1d(0 to 3);  -- slice0_tag_#_end_of_line
  -- slice1shift
  signal slice1shift_search_0 : natural_4194303_1d(0 to 15);
  signal slice1shift_reference_0, slice1shift_search_out_0 : natural range 0 to 4194303;
  -- slice1cost
  signal slice1cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 6);  -- slice1cost_pixels_first_0_#_count_#
  signal slice1cost_pixels_first_0_count_7 : boolean_1d(0 to 15);  -- slice1cost_pixels_first_0_#_count_7
  signal slice1cost_pixels_cost_0 : natural_22_1d(0 to 15);
  signal slice1cost_single_0 : natural_22_1d(0 to 15);
  -- slice1
  signal slice1_held : natural_11_2d(0 to 2, 0 to 15);
  -- slice2shift
  signal slice2shift_search_0 : natural_4194303_1d(0 to 15);
  signal slice2shift_reference_0, slice2shift_search_out_0 : natural range 0 to 4194303;
  -- slice2cost
  signal slice2cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 6);  -- slice2cost_pixels_first_0_#_count_#
  signal slice2cost_pixels_first_0_count_7 : boolean_1d(0 to 15);  -- slice2cost_pixels_first_0_#_count_7
  signal slice2cost_pixels_cost_0 : natural_22_1d(0 to 15);
  signal slice2cost_single_0 : natural_22_1d(0 to 15);
  -- slice2
  signal slice2_held : natural_11_2d(0 to 1, 0 to 15);
  -- slice3shift
  signal slice3shift_search_0 : natural_4194303_1d(0 to 15);
  signal slice3shift_reference_0 : natural range 0 to 4194303;
  -- slice3cost
  signal slice3cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 6);  -- slice3cost_pixels_first_0_#_count_#
  signal slice3cost_pixels_first_0_count_7 : boolean_1d(0 to 15);  -- slice3cost_pixels_first_0_#_count_7
  signal slice3cost_pixels_cost_0 : natural_22_1d(0 to 15);
  signal slice3cost_single_0 : natural_22_1d(0 to 15);
  -- slice3
  signal slice3_held_0 : natural_11_1d(0 to 15);
  -- entry
  signal entry_next_cost : natural_11_1d(0 to 63);
  signal entry_cost : natural_11_1d(0 to 63);
  signal entry_next_tag_valid, entry_next_tag_first_cost, entry_next_tag_map_column : boolean;
  signal entry_next_tag_end_of_line, entry_next_top, entry_order_falls, entry_order_inside : boolean;
  signal entry_order_complete, entry_order_output, entry_order_first, entry_order_held_output : boolean;
  signal entry_order_turned_output_column, entry_order_turned_first_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag_valid, entry_tag_first_cost, entry_tag_map_column, entry_tag_end_of_line, entry_top : boolean;
  signal entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 2047;
  -- forward
  signal forward_smallest_smallest : natural_11_1d(0 to 31);
  signal forward_smallest_next_smallest : natural_11_1d(0 to 15);
  signal forward_smallest_next_next_smallest : natural_11_1d(0 to 7);
  signal forward_smallest_next_next_next_smallest : natural_11_1d(0 to 3);
  signal forward_smallest_next_next_next_next_smallest : natural_11_1d(0 to 1);
  signal forward_smallest_next_next_next_next_next_smallest_0 : natural range 0 to 11;
  signal forward_above_ready_cost : natural_11_1d(0 to 63);
  signal forward_smallest_cost : natural_11_1d(0 to 4);
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address : natural range 0 to 7;
  signal forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost : natural_7_2d(0 to 3, 0 to 63);
  signal forward_cost_delay_held : unsigned_31_1d(0 to 5);
  signal forward_cost_delay_held_6 : unsigned(12 downto 0);
  signal forward_left_pair : natural_127_1d(0 to 31);
  signal forward_left_tree_smallest : natural_127_1d(0 to 15);
  signal forward_left_tree_next_smallest : natural_127_1d(0 to 7);
  signal forward_left_tree_next_next_smallest : natural_127_1d(0 to 3);
  signal forward_left_tree_next_next_next_smallest : natural_127_1d(0 to 1);
  signal forward_left_tree_next_next_next_next_smallest_0, forward_left_smallest : natural range 0 to 127;
  signal forward_left_smallest_less, forward_left_relief_leaves : natural range 0 to 127;
  signal forward_left_g_copy : natural_127_1d(0 to 3);
  signal forward_left_g_less_copy : natural_127_1d(0 to 3);
  signal forward_left_stay_change : natural_127_1d(0 to 63);
  signal forward_left_step_change : natural_127_1d(0 to 63);
  signal forward_left_cost : natural_127_1d(0 to 63);
  signal forward_left_arrived : natural_127_1d(0 to 63);
  signal forward_left_start_cost : natural_63_1d(0 to 8);
  signal forward_left_room, forward_left_relief_next_0 : natural range 0 to 63;
  signal forward_left_relief_past : natural_63_1d(0 to 7);
  signal forward_left_relief_pairs : natural_63_1d(0 to 1);
  signal forward_left_relief_fours : natural_63_1d(0 to 2);
  signal forward_left_relief_older, forward_left_relief_recent, forward_left_relief_largest : natural range 0 to 63;
  signal forward_left_relief_beyond : natural range 0 to 63;
  signal forward_above_cost : natural_63_1d(0 to 63);
  signal forward_above_beside : natural_63_1d(0 to 63);
  signal forward_above_own_0 : natural range 0 to 63;
  signal forward_above_own : natural_63_1d(2 to 61);
  signal forward_above_own_63 : natural range 0 to 63;
  signal forward_reliefs_moved : natural_63_1d(0 to 10);
  signal forward_left_first : boolean_1d(0 to 2);
  signal forward_above_ready_top : boolean;
  signal forward_above_comes : boolean_1d(0 to 11);
  signal forward_above_writes_copy_0 : boolean;
  signal forward_first : boolean_1d(0 to 5);
  signal forward_left_relief_reach_of_best : natural range 0 to 255;
  signal forward_left_relief_room_of_best : natural range 0 to 190;
  signal forward_left_relief_reach_again : natural range 0 to 254;
  signal forward_above_read_words : unsigned_32_1d(0 to 9);
  signal forward_above_ready_words : unsigned_32_1d(0 to 9);
  signal forward_above_write_words : unsigned_32_1d(0 to 9);
  signal forward_above_read_words_10 : unsigned(21 downto 0);
  signal forward_above_ready_words_10, forward_above_write_words_10 : natural range 0 to 4194303;
  signal forward_above_total : natural_42_1d(0 to 63);
  signal forward_above_tree_smallest : natural_42_1d(0 to 31);
  signal forward_above_tree_next_smallest : natural_42_1d(0 to 15);
  signal forward_above_tree_next_next_smallest : natural_42_1d(0 to 7);
  signal forward_above_tree_next_next_next_smallest : natural_42_1d(0 to 3);
  signal forward_above_tree_next_next_next_next_smallest : natural_42_1d(0 to 1);
  signal forward_above_tree_next_next_next_next_next_smallest_0 : natural range 0 to 42;
  signal forward_above_smallest_copy : natural_42_1d(0 to 3);
  signal forward_above_delay_held : unsigned_30_1d(0 to 11);
  signal forward_above_delay_held_12 : unsigned(23 downto 0);
  signal forward_above_step : natural_68_1d(0 to 63);
  signal forward_above_stay : natural_31_1d(0 to 63);
  signal forward_above_column : natural_2047_1d(0 to 11);
  signal forward_above_write_column : natural range 0 to 2047;
  -- sums
  signal sums_turn_read_sums : unsigned_32_1d(0 to 15);
  signal sums_turn_ready_sums : unsigned_32_1d(0 to 15);
  signal sums_turn_write_sums : unsigned_32_1d(0 to 15);
  signal sums_sum_delay_held : unsigned_32_1d(0 to 15);
  signal sums_turn_read_costs : unsigned_30_1d(0 to 5);
  signal sums_turn_read_costs_6 : unsigned(11 downto 0);
  signal sums_turn_read_smallest_0 : unsigned(8 downto 0);
  signal sums_turn_ready_costs : natural_1073741823_1d(0 to 5);
  signal sums_turn_write_costs : natural_1073741823_1d(0 to 5);
  signal sums_turn_ready_costs_6, sums_turn_write_costs_6 : natural range 0 to 4095;
  signal sums_turn_ready_smallest_0, sums_turn_write_smallest_0 : natural range 0 to 511;
  signal sums_turn_ready_first, sums_turn_writes_copy_0 : boolean;
  signal sums_right_first : boolean_1d(0 to 2);
  signal sums_tag_valid, sums_tag_map_column, sums_tag_output_column, sums_tag_start_of_frame : boolean;
  signal sums_tag_end_of_line : boolean;
  signal sums_tags_held_output_column : boolean_1d(0 to 4);  -- sums_tags_held_#_output_column
  signal sums_tags_held_start_of_frame : boolean_1d(0 to 4);  -- sums_tags_held_#_start_of_frame
  signal sums_tags_held_end_of_line : boolean_1d(0 to 4);  -- sums_tags_held_#_end_of_line
  signal sums_tags_moved : boolean;
  signal sums_turn_place : natural_2047_1d(0 to 10);
  signal sums_turn_write_place : natural range 0 to 2047;
  signal sums_cost : natural_7_2d(0 to 1, 0 to 63);
  signal sums_right_pair : natural_127_1d(0 to 31);
  signal sums_right_tree_smallest : natural_127_1d(0 to 15);
  signal sums_right_tree_next_smallest : natural_127_1d(0 to 7);
  signal sums_right_tree_next_next_smallest : natural_127_1d(0 to 3);
  signal sums_right_tree_next_next_next_smallest : natural_127_1d(0 to 1);
  signal sums_right_tree_next_next_next_next_smallest_0, sums_right_smallest : natural range 0 to 127;
  signal sums_right_smallest_less, sums_right_relief_leaves : natural range 0 to 127;
  signal sums_right_g_copy : natural_127_1d(0 to 3);
  signal sums_right_g_less_copy : natural_127_1d(0 to 3);
  signal sums_right_stay_change : natural_127_1d(0 to 63);
  signal sums_right_step_change : natural_127_1d(0 to 63);
  signal sums_right_cost : natural_127_1d(0 to 63);
  signal sums_right_arrived : natural_127_1d(0 to 63);
  signal sums_right_start_cost : natural_63_1d(0 to 8);
  signal sums_right_room, sums_right_relief_next_0 : natural range 0 to 63;
  signal sums_right_relief_past : natural_63_1d(0 to 7);
  signal sums_right_relief_pairs : natural_63_1d(0 to 1);
  signal sums_right_relief_fours : natural_63_1d(0 to 2);
  signal sums_right_relief_older, sums_right_relief_recent, sums_right_relief_largest : natural range 0 to 63;
  signal sums_right_relief_beyond : natural range 0 to 63;
  signal sums_right_relief_reach_of_best : natural range 0 to 255;
  signal sums_sum_0 : natural_255_1d(0 to 63);
  signal sums_right_relief_room_of_best : natural range 0 to 190;
  signal sums_right_relief_reach_again : natural range 0 to 254;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  -- winnerswinner1
  signal winnerswinner1_of_pair_0 : natural_255_1d(0 to 63);
  signal winnerswinner1_of_four_0 : natural_255_1d(0 to 63);
  signal winnerswinner1_best_cost_0 : natural_255_1d(0 to 15);
  signal winnerswinner1_pair_index_0_0, winnerswinner1_pair_tag_valid, winnerswinner1_pair_tag_map_column : boolean;
  signal winnerswinner1_pair_tag_output_column, winnerswinner1_pair_tag_start_of_frame : boolean;
  signal winnerswinner1_pair_tag_end_of_line, winnerswinner1_four_tag_valid : boolean;
  signal winnerswinner1_four_tag_map_column, winnerswinner1_four_tag_output_column : boolean;
  signal winnerswinner1_four_tag_start_of_frame, winnerswinner1_four_tag_end_of_line : boolean;
  signal winnerswinner1_tag_valid, winnerswinner1_tag_map_column, winnerswinner1_tag_output_column : boolean;
  signal winnerswinner1_tag_start_of_frame, winnerswinner1_tag_end_of_line : boolean;
  signal winnerswinner1_pair_index_0_1, winnerswinner1_four_index_0_0 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner1_pair_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_pair_index_0_3, winnerswinner1_four_index_0_1 : natural range 0 to 7;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 7;
  signal winnerswinner1_pair_index_0_4 : natural range 0 to 9;
  signal winnerswinner1_pair_index_0_5, winnerswinner1_four_index_0_2 : natural range 0 to 11;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 11;
  signal winnerswinner1_pair_index_0_6 : natural range 0 to 13;
  signal winnerswinner1_pair_index_0_7, winnerswinner1_four_index_0_3 : natural range 0 to 15;
  signal winnerswinner1_best_index_0_3 : natural range 0 to 15;
  signal winnerswinner1_pair_index_0_8 : natural range 0 to 17;
  signal winnerswinner1_pair_index_0_9, winnerswinner1_four_index_0_4 : natural range 0 to 19;
  signal winnerswinner1_best_index_0_4 : natural range 0 to 19;
  signal winnerswinner1_pair_index_0_10 : natural range 0 to 21;
  signal winnerswinner1_pair_index_0_11, winnerswinner1_four_index_0_5 : natural range 0 to 23;
  signal winnerswinner1_best_index_0_5 : natural range 0 to 23;
  signal winnerswinner1_pair_index_0_12 : natural range 0 to 25;
  signal winnerswinner1_pair_index_0_13, winnerswinner1_four_index_0_6 : natural range 0 to 27;
  signal winnerswinner1_best_index_0_6 : natural range 0 to 27;
  signal winnerswinner1_pair_index_0_14 : natural range 0 to 29;
  signal winnerswinner1_pair_index_0_15, winnerswinner1_four_index_0_7 : natural range 0 to 31;
  signal winnerswinner1_best_index_0_7 : natural range 0 to 31;
  signal winnerswinner1_pair_index_0_16 : natural range 0 to 33;
  signal winnerswinner1_pair_index_0_17, winnerswinner1_four_index_0_8 : natural range 0 to 35;
  signal winnerswinner1_best_index_0_8 : natural range 0 to 35;
  signal winnerswinner1_pair_index_0_18 : natural range 0 to 37;
  signal winnerswinner1_pair_index_0_19, winnerswinner1_four_index_0_9 : natural range 0 to 39;
  signal winnerswinner1_best_index_0_9 : natural range 0 to 39;
  signal winnerswinner1_pair_index_0_20 : natural range 0 to 41;
  signal winnerswinner1_pair_index_0_21, winnerswinner1_four_index_0_10 : natural range 0 to 43;
  signal winnerswinner1_best_index_0_10 : natural range 0 to 43;
  signal winnerswinner1_pair_index_0_22 : natural range 0 to 45;
  signal winnerswinner1_pair_index_0_23, winnerswinner1_four_index_0_11 : natural range 0 to 47;
  signal winnerswinner1_best_index_0_11 : natural range 0 to 47;
  signal winnerswinner1_pair_index_0_24 : natural range 0 to 49;
  signal winnerswinner1_pair_index_0_25, winnerswinner1_four_index_0_12 : natural range 0 to 51;
  signal winnerswinner1_best_index_0_12 : natural range 0 to 51;
  signal winnerswinner1_pair_index_0_26 : natural range 0 to 53;
  signal winnerswinner1_pair_index_0_27, winnerswinner1_four_index_0_13 : natural range 0 to 55;
  signal winnerswinner1_best_index_0_13 : natural range 0 to 55;
  signal winnerswinner1_pair_index_0_28 : natural range 0 to 57;
  signal winnerswinner1_pair_index_0_29, winnerswinner1_four_index_0_14 : natural range 0 to 59;
  signal winnerswinner1_best_index_0_14 : natural range 0 to 59;
  signal winnerswinner1_pair_index_0_30 : natural range 0 to 61;
  signal winnerswinner1_pair_index_0_31, winnerswinner1_four_index_0_15 : natural range 0 to 63;
  signal winnerswinner1_best_index_0_15 : natural range 0 to 63;
  -- winnerswinner2
  signal winnerswinner2_of_pair_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_of_four_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_cost_0 : natural_255_1d(0 to 3);
  signal winnerswinner2_pair_index_0_0 : natural range 0 to 7;
  signal winnerswinner2_pair_index_0_1, winnerswinner2_four_index_0_0 : natural range 0 to 15;
  signal winnerswinner2_best_index_0_0 : natural range 0 to 15;
  signal winnerswinner2_pair_index_0_2 : natural range 0 to 23;
  signal winnerswinner2_pair_index_0_3, winnerswinner2_four_index_0_1 : natural range 0 to 31;
  signal winnerswinner2_best_index_0_1 : natural range 0 to 31;
  signal winnerswinner2_pair_index_0_4 : natural range 0 to 39;
  signal winnerswinner2_pair_index_0_5, winnerswinner2_four_index_0_2 : natural range 0 to 47;
  signal winnerswinner2_best_index_0_2 : natural range 0 to 47;
  signal winnerswinner2_pair_index_0_6 : natural range 0 to 55;
  signal winnerswinner2_pair_index_0_7, winnerswinner2_four_index_0_3 : natural range 0 to 63;
  signal winnerswinner2_best_index_0_3 : natural range 0 to 63;
  signal winnerswinner2_pair_tag_valid, winnerswinner2_pair_tag_map_column : boolean;
  signal winnerswinner2_pair_tag_output_column, winnerswinner2_pair_tag_start_of_frame : boolean;
  signal winnerswinner2_pair_tag_end_of_line, winnerswinner2_four_tag_valid : boolean;
  signal winnerswinner2_four_tag_map_column, winnerswinner2_four_tag_output_column : boolean;
  signal winnerswinner2_four_tag_start_of_frame, winnerswinner2_four_tag_end_of_line : boolean;
  signal winnerswinner2_tag_valid, winnerswinner2_tag_map_column, winnerswinner2_tag_output_column : boolean;
  signal winnerswinner2_tag_start_of_frame, winnerswinner2_tag_end_of_line : boolean;
  -- winnerswinner3
  signal winnerswinner3_of_pair_0 : natural_255_1d(0 to 3);
  signal winnerswinner3_pair_index_0_0 : natural range 0 to 31;
  signal winnerswinner3_pair_index_0_1, winnerswinner3_four_index_0_0 : natural range 0 to 63;
  signal winnerswinner3_best_index_0_0 : natural range 0 to 63;
  signal winnerswinner3_pair_tag_valid, winnerswinner3_pair_tag_map_column : boolean;
  signal winnerswinner3_pair_tag_output_column, winnerswinner3_pair_tag_start_of_frame : boolean;
  signal winnerswinner3_pair_tag_end_of_line, winnerswinner3_four_tag_valid : boolean;
  signal winnerswinner3_four_tag_map_column, winnerswinner3_four_tag_output_column : boolean;
  signal winnerswinner3_four_tag_start_of_frame, winnerswinner3_four_tag_end_of_line : boolean;
  signal winnerswinner3_tag_valid, winnerswinner3_tag_map_column, winnerswinner3_tag_output_column : boolean;
  signal winnerswinner3_tag_start_of_frame, winnerswinner3_tag_end_of_line : boolean;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 63;
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
  signal turn_newest, turn_write_words_0 : natural range 0 to 319;
  signal turn_read_words_0 : unsigned(8 downto 0);
  signal turn_ready : natural range 0 to 511;
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column : natural range 0 to 2047;
  signal map_sorted_column : natural range 0 to 2047;
  signal map_counter_group : natural range 0 to 1023;
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
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 127;
  signal map_column : natural_127_1d(1 to 2);
  signal map_rows_read_words_0 : unsigned(15 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 65535;
  signal map_rows_write_words_0 : natural range 0 to 65151;
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0 : natural range 0 to 63;
  signal map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 63;
  signal map_low_0 : natural_63_1d(0 to 2);  -- map_low_#_0
  signal map_middle_0 : natural_63_1d(0 to 2);  -- map_middle_#_0
  signal map_high_0 : natural_63_1d(0 to 2);  -- map_high_#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b : natural range 0 to 63;
  signal map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b, map_of_high_0_c : natural range 0 to 63;
  signal map_largest_low_0, map_median_middle_0, map_smallest_high_0, map_of_all_0_a : natural range 0 to 63;
  signal map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 63;
  -- relief
  signal relief_centre_column : natural_255_1d(0 to 4);
  signal relief_centre_grey_0, relief_before : natural range 0 to 255;
  signal relief_newest, relief_delayed_0, relief_shown_0 : natural range 0 to 63;
  signal relief_waiting : natural_63_1d(0 to 9);
  signal relief_entering, relief_entered : natural range 0 to 63;
  -- other
  signal other : unsigned_32_1d(0 to 15);
  signal other_16, other_18 : unsigned(48 downto 0);
  signal other_17 : natural range 0 to 126;
  signal others_from_19 : natural_22_1d(19 to 146);  -- other_#
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
  signal map_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address, turn_read_words_0_memory_write_address : unsigned(10 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal sums_sum_delay_held_15_memory_read_enable : boolean;
  signal sums_sum_delay_held_15_memory_read_address, sums_sum_delay_held_15_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_15_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_14_memory_read_enable : boolean;
  signal sums_sum_delay_held_14_memory_read_address, sums_sum_delay_held_14_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_14_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_13_memory_read_enable : boolean;
  signal sums_sum_delay_held_13_memory_read_address, sums_sum_delay_held_13_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_13_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_12_memory_read_enable : boolean;
  signal sums_sum_delay_held_12_memory_read_address, sums_sum_delay_held_12_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_12_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_11_memory_read_enable : boolean;
  signal sums_sum_delay_held_11_memory_read_address, sums_sum_delay_held_11_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_11_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_10_memory_read_enable : boolean;
  signal sums_sum_delay_held_10_memory_read_address, sums_sum_delay_held_10_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_10_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_9_memory_read_enable : boolean;
  signal sums_sum_delay_held_9_memory_read_address, sums_sum_delay_held_9_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_9_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_8_memory_read_enable : boolean;
  signal sums_sum_delay_held_8_memory_read_address, sums_sum_delay_held_8_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_8_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_7_memory_read_enable : boolean;
  signal sums_sum_delay_held_7_memory_read_address, sums_sum_delay_held_7_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_7_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_6_memory_read_enable : boolean;
  signal sums_sum_delay_held_6_memory_read_address, sums_sum_delay_held_6_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_6_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_5_memory_read_enable : boolean;
  signal sums_sum_delay_held_5_memory_read_address, sums_sum_delay_held_5_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_5_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_4_memory_read_enable : boolean;
  signal sums_sum_delay_held_4_memory_read_address, sums_sum_delay_held_4_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_4_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_3_memory_read_enable : boolean;
  signal sums_sum_delay_held_3_memory_read_address, sums_sum_delay_held_3_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_3_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_2_memory_read_enable : boolean;
  signal sums_sum_delay_held_2_memory_read_address, sums_sum_delay_held_2_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_2_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_1_memory_read_enable : boolean;
  signal sums_sum_delay_held_1_memory_read_address, sums_sum_delay_held_1_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_1_memory_write_data : unsigned(31 downto 0);
  signal sums_sum_delay_held_0_memory_read_enable : boolean;
  signal sums_sum_delay_held_0_memory_read_address, sums_sum_delay_held_0_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_0_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_15_memory_read_enable : boolean;
  signal sums_turn_read_sums_15_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_15_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_15_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_14_memory_read_enable : boolean;
  signal sums_turn_read_sums_14_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_14_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_14_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_13_memory_read_enable : boolean;
  signal sums_turn_read_sums_13_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_13_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_13_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_12_memory_read_enable : boolean;
  signal sums_turn_read_sums_12_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_12_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_12_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_11_memory_read_enable : boolean;
  signal sums_turn_read_sums_11_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_11_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_11_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_10_memory_read_enable : boolean;
  signal sums_turn_read_sums_10_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_10_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_10_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_9_memory_read_enable : boolean;
  signal sums_turn_read_sums_9_memory_read_address, sums_turn_read_sums_9_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_9_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_8_memory_read_enable : boolean;
  signal sums_turn_read_sums_8_memory_read_address, sums_turn_read_sums_8_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_8_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_7_memory_read_enable : boolean;
  signal sums_turn_read_sums_7_memory_read_address, sums_turn_read_sums_7_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_7_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_6_memory_read_enable : boolean;
  signal sums_turn_read_sums_6_memory_read_address, sums_turn_read_sums_6_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_6_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_5_memory_read_enable : boolean;
  signal sums_turn_read_sums_5_memory_read_address, sums_turn_read_sums_5_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_5_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_4_memory_read_enable : boolean;
  signal sums_turn_read_sums_4_memory_read_address, sums_turn_read_sums_4_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_4_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_3_memory_read_enable : boolean;
  signal sums_turn_read_sums_3_memory_read_address, sums_turn_read_sums_3_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_3_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_2_memory_read_enable : boolean;
  signal sums_turn_read_sums_2_memory_read_address, sums_turn_read_sums_2_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_2_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_1_memory_read_enable : boolean;
  signal sums_turn_read_sums_1_memory_read_address, sums_turn_read_sums_1_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_1_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_sums_0_memory_read_enable : boolean;
  signal sums_turn_read_sums_0_memory_read_address, sums_turn_read_sums_0_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_sums_0_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_6_memory_read_enable : boolean;
  signal sums_turn_read_costs_6_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_6_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_6_memory_write_data : unsigned(11 downto 0);
  signal sums_turn_read_costs_5_memory_read_enable : boolean;
  signal sums_turn_read_costs_5_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_5_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_5_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_4_memory_read_enable : boolean;
  signal sums_turn_read_costs_4_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_4_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_4_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_3_memory_read_enable : boolean;
  signal sums_turn_read_costs_3_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_3_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_3_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_2_memory_read_enable : boolean;
  signal sums_turn_read_costs_2_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_2_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_2_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_1_memory_read_enable : boolean;
  signal sums_turn_read_costs_1_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_1_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_1_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_0_memory_read_enable : boolean;
  signal sums_turn_read_costs_0_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_0_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_costs_0_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_smallest_0_memory_read_enable : boolean;
  signal sums_turn_read_smallest_0_memory_read_address : unsigned(10 downto 0);
  signal sums_turn_read_smallest_0_memory_write_address : unsigned(10 downto 0);
  signal sums_turn_read_smallest_0_memory_write_data : unsigned(8 downto 0);
  signal forward_above_read_words_10_memory_read_enable : boolean;
  signal forward_above_read_words_10_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_10_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal forward_above_read_words_9_memory_read_enable : boolean;
  signal forward_above_read_words_9_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_9_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_9_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_8_memory_read_enable : boolean;
  signal forward_above_read_words_8_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_8_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_8_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_7_memory_read_enable : boolean;
  signal forward_above_read_words_7_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_7_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_7_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_6_memory_read_enable : boolean;
  signal forward_above_read_words_6_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_6_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_6_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_5_memory_read_enable : boolean;
  signal forward_above_read_words_5_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_5_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_5_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_4_memory_read_enable : boolean;
  signal forward_above_read_words_4_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_4_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_4_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_3_memory_read_enable : boolean;
  signal forward_above_read_words_3_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_3_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_3_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_2_memory_read_enable : boolean;
  signal forward_above_read_words_2_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_2_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_1_memory_read_enable : boolean;
  signal forward_above_read_words_1_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_1_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_0_memory_read_enable : boolean;
  signal forward_above_read_words_0_memory_read_address : unsigned(10 downto 0);
  signal forward_above_read_words_0_memory_write_address : unsigned(10 downto 0);
  signal forward_above_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal forward_above_delay_held_12_memory_read_enable : boolean;
  signal forward_above_delay_held_12_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_12_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_12_memory_write_data : unsigned(23 downto 0);
  signal forward_above_delay_held_11_memory_read_enable : boolean;
  signal forward_above_delay_held_11_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_11_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_11_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_10_memory_read_enable : boolean;
  signal forward_above_delay_held_10_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_10_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_10_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_9_memory_read_enable : boolean;
  signal forward_above_delay_held_9_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_9_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_9_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_8_memory_read_enable : boolean;
  signal forward_above_delay_held_8_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_8_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_8_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_7_memory_read_enable : boolean;
  signal forward_above_delay_held_7_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_7_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_7_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_6_memory_read_enable : boolean;
  signal forward_above_delay_held_6_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_6_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_6_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_5_memory_read_enable : boolean;
  signal forward_above_delay_held_5_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_5_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_5_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_4_memory_read_enable : boolean;
  signal forward_above_delay_held_4_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_4_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_4_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_3_memory_read_enable : boolean;
  signal forward_above_delay_held_3_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_3_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_3_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_2_memory_read_enable : boolean;
  signal forward_above_delay_held_2_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_1_memory_read_enable : boolean;
  signal forward_above_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_0_memory_read_enable : boolean;
  signal forward_above_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_data : unsigned(29 downto 0);
  signal forward_cost_delay_held_6_memory_read_enable : boolean;
  signal forward_cost_delay_held_6_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_6_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_6_memory_write_data : unsigned(12 downto 0);
  signal forward_cost_delay_held_5_memory_read_enable : boolean;
  signal forward_cost_delay_held_5_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_5_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_5_memory_write_data : unsigned(30 downto 0);
  signal forward_cost_delay_held_4_memory_read_enable : boolean;
  signal forward_cost_delay_held_4_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_4_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_4_memory_write_data : unsigned(30 downto 0);
  signal forward_cost_delay_held_3_memory_read_enable : boolean;
  signal forward_cost_delay_held_3_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_3_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_3_memory_write_data : unsigned(30 downto 0);
  signal forward_cost_delay_held_2_memory_read_enable : boolean;
  signal forward_cost_delay_held_2_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_2_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_2_memory_write_data : unsigned(30 downto 0);
  signal forward_cost_delay_held_1_memory_read_enable : boolean;
  signal forward_cost_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_1_memory_write_data : unsigned(30 downto 0);
  signal forward_cost_delay_held_0_memory_read_enable : boolean;
  signal forward_cost_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_data : unsigned(30 downto 0);

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
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 11);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 11);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1280, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 11);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 11);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1280, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 11);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_at_column, 11);
  map_rows_read_words_0_memory_write_data <= to_unsigned(map_rows_write_words_0, 16);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 1217, width => 16, address_bits => 11)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 11);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 11);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 9);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 1217, width => 9, address_bits => 11)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  sums_sum_delay_held_15_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_15_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_15_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_15_memory_write_data <= sums_turn_ready_sums(15);
  sums_sum_delay_held_15_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_15_memory_read_enable,
      read_address => sums_sum_delay_held_15_memory_read_address, read_data => sums_sum_delay_held(15),
      write_address => sums_sum_delay_held_15_memory_write_address, write_data => sums_sum_delay_held_15_memory_write_data);

  sums_sum_delay_held_14_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_14_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_14_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_14_memory_write_data <= sums_turn_ready_sums(14);
  sums_sum_delay_held_14_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_14_memory_read_enable,
      read_address => sums_sum_delay_held_14_memory_read_address, read_data => sums_sum_delay_held(14),
      write_address => sums_sum_delay_held_14_memory_write_address, write_data => sums_sum_delay_held_14_memory_write_data);

  sums_sum_delay_held_13_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_13_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_13_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_13_memory_write_data <= sums_turn_ready_sums(13);
  sums_sum_delay_held_13_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_13_memory_read_enable,
      read_address => sums_sum_delay_held_13_memory_read_address, read_data => sums_sum_delay_held(13),
      write_address => sums_sum_delay_held_13_memory_write_address, write_data => sums_sum_delay_held_13_memory_write_data);

  sums_sum_delay_held_12_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_12_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_12_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_12_memory_write_data <= sums_turn_ready_sums(12);
  sums_sum_delay_held_12_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_12_memory_read_enable,
      read_address => sums_sum_delay_held_12_memory_read_address, read_data => sums_sum_delay_held(12),
      write_address => sums_sum_delay_held_12_memory_write_address, write_data => sums_sum_delay_held_12_memory_write_data);

  sums_sum_delay_held_11_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_11_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_11_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_11_memory_write_data <= sums_turn_ready_sums(11);
  sums_sum_delay_held_11_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_11_memory_read_enable,
      read_address => sums_sum_delay_held_11_memory_read_address, read_data => sums_sum_delay_held(11),
      write_address => sums_sum_delay_held_11_memory_write_address, write_data => sums_sum_delay_held_11_memory_write_data);

  sums_sum_delay_held_10_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_10_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_10_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_10_memory_write_data <= sums_turn_ready_sums(10);
  sums_sum_delay_held_10_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_10_memory_read_enable,
      read_address => sums_sum_delay_held_10_memory_read_address, read_data => sums_sum_delay_held(10),
      write_address => sums_sum_delay_held_10_memory_write_address, write_data => sums_sum_delay_held_10_memory_write_data);

  sums_sum_delay_held_9_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_9_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_9_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_9_memory_write_data <= sums_turn_ready_sums(9);
  sums_sum_delay_held_9_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_9_memory_read_enable,
      read_address => sums_sum_delay_held_9_memory_read_address, read_data => sums_sum_delay_held(9),
      write_address => sums_sum_delay_held_9_memory_write_address, write_data => sums_sum_delay_held_9_memory_write_data);

  sums_sum_delay_held_8_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_8_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_8_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_8_memory_write_data <= sums_turn_ready_sums(8);
  sums_sum_delay_held_8_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_8_memory_read_enable,
      read_address => sums_sum_delay_held_8_memory_read_address, read_data => sums_sum_delay_held(8),
      write_address => sums_sum_delay_held_8_memory_write_address, write_data => sums_sum_delay_held_8_memory_write_data);

  sums_sum_delay_held_7_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_7_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_7_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_7_memory_write_data <= sums_turn_ready_sums(7);
  sums_sum_delay_held_7_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_7_memory_read_enable,
      read_address => sums_sum_delay_held_7_memory_read_address, read_data => sums_sum_delay_held(7),
      write_address => sums_sum_delay_held_7_memory_write_address, write_data => sums_sum_delay_held_7_memory_write_data);

  sums_sum_delay_held_6_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_6_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_6_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_6_memory_write_data <= sums_turn_ready_sums(6);
  sums_sum_delay_held_6_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_6_memory_read_enable,
      read_address => sums_sum_delay_held_6_memory_read_address, read_data => sums_sum_delay_held(6),
      write_address => sums_sum_delay_held_6_memory_write_address, write_data => sums_sum_delay_held_6_memory_write_data);

  sums_sum_delay_held_5_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_5_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_5_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_5_memory_write_data <= sums_turn_ready_sums(5);
  sums_sum_delay_held_5_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_5_memory_read_enable,
      read_address => sums_sum_delay_held_5_memory_read_address, read_data => sums_sum_delay_held(5),
      write_address => sums_sum_delay_held_5_memory_write_address, write_data => sums_sum_delay_held_5_memory_write_data);

  sums_sum_delay_held_4_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_4_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_4_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_4_memory_write_data <= sums_turn_ready_sums(4);
  sums_sum_delay_held_4_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_4_memory_read_enable,
      read_address => sums_sum_delay_held_4_memory_read_address, read_data => sums_sum_delay_held(4),
      write_address => sums_sum_delay_held_4_memory_write_address, write_data => sums_sum_delay_held_4_memory_write_data);

  sums_sum_delay_held_3_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_3_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_3_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_3_memory_write_data <= sums_turn_ready_sums(3);
  sums_sum_delay_held_3_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_3_memory_read_enable,
      read_address => sums_sum_delay_held_3_memory_read_address, read_data => sums_sum_delay_held(3),
      write_address => sums_sum_delay_held_3_memory_write_address, write_data => sums_sum_delay_held_3_memory_write_data);

  sums_sum_delay_held_2_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_2_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_2_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_2_memory_write_data <= sums_turn_ready_sums(2);
  sums_sum_delay_held_2_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_2_memory_read_enable,
      read_address => sums_sum_delay_held_2_memory_read_address, read_data => sums_sum_delay_held(2),
      write_address => sums_sum_delay_held_2_memory_write_address, write_data => sums_sum_delay_held_2_memory_write_data);

  sums_sum_delay_held_1_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_1_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_1_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_1_memory_write_data <= sums_turn_ready_sums(1);
  sums_sum_delay_held_1_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_1_memory_read_enable,
      read_address => sums_sum_delay_held_1_memory_read_address, read_data => sums_sum_delay_held(1),
      write_address => sums_sum_delay_held_1_memory_write_address, write_data => sums_sum_delay_held_1_memory_write_data);

  sums_sum_delay_held_0_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_0_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_0_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_0_memory_write_data <= sums_turn_ready_sums(0);
  sums_sum_delay_held_0_memory : entity work.line_memory
    generic map (depth => 4, width => 32, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_0_memory_read_enable,
      read_address => sums_sum_delay_held_0_memory_read_address, read_data => sums_sum_delay_held(0),
      write_address => sums_sum_delay_held_0_memory_write_address, write_data => sums_sum_delay_held_0_memory_write_data);

  sums_turn_read_sums_15_memory_read_enable <= true;
  sums_turn_read_sums_15_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_15_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_15_memory_write_data <= sums_turn_write_sums(15);
  sums_turn_read_sums_15_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_15_memory_read_enable,
      read_address => sums_turn_read_sums_15_memory_read_address, read_data => sums_turn_read_sums(15),
      write_address => sums_turn_read_sums_15_memory_write_address, write_data => sums_turn_read_sums_15_memory_write_data);

  sums_turn_read_sums_14_memory_read_enable <= true;
  sums_turn_read_sums_14_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_14_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_14_memory_write_data <= sums_turn_write_sums(14);
  sums_turn_read_sums_14_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_14_memory_read_enable,
      read_address => sums_turn_read_sums_14_memory_read_address, read_data => sums_turn_read_sums(14),
      write_address => sums_turn_read_sums_14_memory_write_address, write_data => sums_turn_read_sums_14_memory_write_data);

  sums_turn_read_sums_13_memory_read_enable <= true;
  sums_turn_read_sums_13_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_13_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_13_memory_write_data <= sums_turn_write_sums(13);
  sums_turn_read_sums_13_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_13_memory_read_enable,
      read_address => sums_turn_read_sums_13_memory_read_address, read_data => sums_turn_read_sums(13),
      write_address => sums_turn_read_sums_13_memory_write_address, write_data => sums_turn_read_sums_13_memory_write_data);

  sums_turn_read_sums_12_memory_read_enable <= true;
  sums_turn_read_sums_12_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_12_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_12_memory_write_data <= sums_turn_write_sums(12);
  sums_turn_read_sums_12_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_12_memory_read_enable,
      read_address => sums_turn_read_sums_12_memory_read_address, read_data => sums_turn_read_sums(12),
      write_address => sums_turn_read_sums_12_memory_write_address, write_data => sums_turn_read_sums_12_memory_write_data);

  sums_turn_read_sums_11_memory_read_enable <= true;
  sums_turn_read_sums_11_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_11_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_11_memory_write_data <= sums_turn_write_sums(11);
  sums_turn_read_sums_11_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_11_memory_read_enable,
      read_address => sums_turn_read_sums_11_memory_read_address, read_data => sums_turn_read_sums(11),
      write_address => sums_turn_read_sums_11_memory_write_address, write_data => sums_turn_read_sums_11_memory_write_data);

  sums_turn_read_sums_10_memory_read_enable <= true;
  sums_turn_read_sums_10_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_10_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_10_memory_write_data <= sums_turn_write_sums(10);
  sums_turn_read_sums_10_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_10_memory_read_enable,
      read_address => sums_turn_read_sums_10_memory_read_address, read_data => sums_turn_read_sums(10),
      write_address => sums_turn_read_sums_10_memory_write_address, write_data => sums_turn_read_sums_10_memory_write_data);

  sums_turn_read_sums_9_memory_read_enable <= true;
  sums_turn_read_sums_9_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_9_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_9_memory_write_data <= sums_turn_write_sums(9);
  sums_turn_read_sums_9_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_9_memory_read_enable,
      read_address => sums_turn_read_sums_9_memory_read_address, read_data => sums_turn_read_sums(9),
      write_address => sums_turn_read_sums_9_memory_write_address, write_data => sums_turn_read_sums_9_memory_write_data);

  sums_turn_read_sums_8_memory_read_enable <= true;
  sums_turn_read_sums_8_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_8_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_8_memory_write_data <= sums_turn_write_sums(8);
  sums_turn_read_sums_8_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_8_memory_read_enable,
      read_address => sums_turn_read_sums_8_memory_read_address, read_data => sums_turn_read_sums(8),
      write_address => sums_turn_read_sums_8_memory_write_address, write_data => sums_turn_read_sums_8_memory_write_data);

  sums_turn_read_sums_7_memory_read_enable <= true;
  sums_turn_read_sums_7_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_7_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_7_memory_write_data <= sums_turn_write_sums(7);
  sums_turn_read_sums_7_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_7_memory_read_enable,
      read_address => sums_turn_read_sums_7_memory_read_address, read_data => sums_turn_read_sums(7),
      write_address => sums_turn_read_sums_7_memory_write_address, write_data => sums_turn_read_sums_7_memory_write_data);

  sums_turn_read_sums_6_memory_read_enable <= true;
  sums_turn_read_sums_6_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_6_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_6_memory_write_data <= sums_turn_write_sums(6);
  sums_turn_read_sums_6_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_6_memory_read_enable,
      read_address => sums_turn_read_sums_6_memory_read_address, read_data => sums_turn_read_sums(6),
      write_address => sums_turn_read_sums_6_memory_write_address, write_data => sums_turn_read_sums_6_memory_write_data);

  sums_turn_read_sums_5_memory_read_enable <= true;
  sums_turn_read_sums_5_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_5_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_5_memory_write_data <= sums_turn_write_sums(5);
  sums_turn_read_sums_5_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_5_memory_read_enable,
      read_address => sums_turn_read_sums_5_memory_read_address, read_data => sums_turn_read_sums(5),
      write_address => sums_turn_read_sums_5_memory_write_address, write_data => sums_turn_read_sums_5_memory_write_data);

  sums_turn_read_sums_4_memory_read_enable <= true;
  sums_turn_read_sums_4_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_4_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_4_memory_write_data <= sums_turn_write_sums(4);
  sums_turn_read_sums_4_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_4_memory_read_enable,
      read_address => sums_turn_read_sums_4_memory_read_address, read_data => sums_turn_read_sums(4),
      write_address => sums_turn_read_sums_4_memory_write_address, write_data => sums_turn_read_sums_4_memory_write_data);

  sums_turn_read_sums_3_memory_read_enable <= true;
  sums_turn_read_sums_3_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_3_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_3_memory_write_data <= sums_turn_write_sums(3);
  sums_turn_read_sums_3_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_3_memory_read_enable,
      read_address => sums_turn_read_sums_3_memory_read_address, read_data => sums_turn_read_sums(3),
      write_address => sums_turn_read_sums_3_memory_write_address, write_data => sums_turn_read_sums_3_memory_write_data);

  sums_turn_read_sums_2_memory_read_enable <= true;
  sums_turn_read_sums_2_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_2_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_2_memory_write_data <= sums_turn_write_sums(2);
  sums_turn_read_sums_2_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_2_memory_read_enable,
      read_address => sums_turn_read_sums_2_memory_read_address, read_data => sums_turn_read_sums(2),
      write_address => sums_turn_read_sums_2_memory_write_address, write_data => sums_turn_read_sums_2_memory_write_data);

  sums_turn_read_sums_1_memory_read_enable <= true;
  sums_turn_read_sums_1_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_1_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_1_memory_write_data <= sums_turn_write_sums(1);
  sums_turn_read_sums_1_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_1_memory_read_enable,
      read_address => sums_turn_read_sums_1_memory_read_address, read_data => sums_turn_read_sums(1),
      write_address => sums_turn_read_sums_1_memory_write_address, write_data => sums_turn_read_sums_1_memory_write_data);

  sums_turn_read_sums_0_memory_read_enable <= true;
  sums_turn_read_sums_0_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_sums_0_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_sums_0_memory_write_data <= sums_turn_write_sums(0);
  sums_turn_read_sums_0_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_0_memory_read_enable,
      read_address => sums_turn_read_sums_0_memory_read_address, read_data => sums_turn_read_sums(0),
      write_address => sums_turn_read_sums_0_memory_write_address, write_data => sums_turn_read_sums_0_memory_write_data);

  sums_turn_read_costs_6_memory_read_enable <= true;
  sums_turn_read_costs_6_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_costs_6_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_costs_6_memory_write_data <= to_unsigned(sums_turn_write_costs_6, 12);
  sums_turn_read_costs_6_memory : entity work.line_memory
    generic map (depth => 1217, width => 12, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_6_memory_read_enable,
      read_address => sums_turn_read_costs_6_memory_read_address, read_data => sums_turn_read_costs_6,
      write_address => sums_turn_read_costs_6_memory_write_address, write_data => sums_turn_read_costs_6_memory_write_data);

  sums_turn_read_costs_5_memory_read_enable <= true;
  sums_turn_read_costs_5_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_costs_5_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_costs_5_memory_write_data <= to_unsigned(sums_turn_write_costs(5), 30);
  sums_turn_read_costs_5_memory : entity work.line_memory
    generic map (depth => 1217, width => 30, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_5_memory_read_enable,
      read_address => sums_turn_read_costs_5_memory_read_address, read_data => sums_turn_read_costs(5),
      write_address => sums_turn_read_costs_5_memory_write_address, write_data => sums_turn_read_costs_5_memory_write_data);

  sums_turn_read_costs_4_memory_read_enable <= true;
  sums_turn_read_costs_4_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_costs_4_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_costs_4_memory_write_data <= to_unsigned(sums_turn_write_costs(4), 30);
  sums_turn_read_costs_4_memory : entity work.line_memory
    generic map (depth => 1217, width => 30, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_4_memory_read_enable,
      read_address => sums_turn_read_costs_4_memory_read_address, read_data => sums_turn_read_costs(4),
      write_address => sums_turn_read_costs_4_memory_write_address, write_data => sums_turn_read_costs_4_memory_write_data);

  sums_turn_read_costs_3_memory_read_enable <= true;
  sums_turn_read_costs_3_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_costs_3_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_costs_3_memory_write_data <= to_unsigned(sums_turn_write_costs(3), 30);
  sums_turn_read_costs_3_memory : entity work.line_memory
    generic map (depth => 1217, width => 30, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_3_memory_read_enable,
      read_address => sums_turn_read_costs_3_memory_read_address, read_data => sums_turn_read_costs(3),
      write_address => sums_turn_read_costs_3_memory_write_address, write_data => sums_turn_read_costs_3_memory_write_data);

  sums_turn_read_costs_2_memory_read_enable <= true;
  sums_turn_read_costs_2_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_costs_2_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_costs_2_memory_write_data <= to_unsigned(sums_turn_write_costs(2), 30);
  sums_turn_read_costs_2_memory : entity work.line_memory
    generic map (depth => 1217, width => 30, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_2_memory_read_enable,
      read_address => sums_turn_read_costs_2_memory_read_address, read_data => sums_turn_read_costs(2),
      write_address => sums_turn_read_costs_2_memory_write_address, write_data => sums_turn_read_costs_2_memory_write_data);

  sums_turn_read_costs_1_memory_read_enable <= true;
  sums_turn_read_costs_1_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_costs_1_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_costs_1_memory_write_data <= to_unsigned(sums_turn_write_costs(1), 30);
  sums_turn_read_costs_1_memory : entity work.line_memory
    generic map (depth => 1217, width => 30, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_1_memory_read_enable,
      read_address => sums_turn_read_costs_1_memory_read_address, read_data => sums_turn_read_costs(1),
      write_address => sums_turn_read_costs_1_memory_write_address, write_data => sums_turn_read_costs_1_memory_write_data);

  sums_turn_read_costs_0_memory_read_enable <= true;
  sums_turn_read_costs_0_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_costs_0_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_costs_0_memory_write_data <= to_unsigned(sums_turn_write_costs(0), 30);
  sums_turn_read_costs_0_memory : entity work.line_memory
    generic map (depth => 1217, width => 30, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_0_memory_read_enable,
      read_address => sums_turn_read_costs_0_memory_read_address, read_data => sums_turn_read_costs(0),
      write_address => sums_turn_read_costs_0_memory_write_address, write_data => sums_turn_read_costs_0_memory_write_data);

  sums_turn_read_smallest_0_memory_read_enable <= true;
  sums_turn_read_smallest_0_memory_read_address <= to_unsigned(entry_order_address, 11);
  sums_turn_read_smallest_0_memory_write_address <= to_unsigned(sums_turn_write_place, 11);
  sums_turn_read_smallest_0_memory_write_data <= to_unsigned(sums_turn_write_smallest_0, 9);
  sums_turn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 1217, width => 9, address_bits => 11)
    port map (
      clock => clock, read_enable => sums_turn_read_smallest_0_memory_read_enable,
      read_address => sums_turn_read_smallest_0_memory_read_address, read_data => sums_turn_read_smallest_0,
      write_address => sums_turn_read_smallest_0_memory_write_address, write_data => sums_turn_read_smallest_0_memory_write_data);

  forward_above_read_words_10_memory_read_enable <= true;
  forward_above_read_words_10_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_10_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_10_memory_write_data <= to_unsigned(forward_above_write_words_10, 22);
  forward_above_read_words_10_memory : entity work.line_memory
    generic map (depth => 1217, width => 22, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_10_memory_read_enable,
      read_address => forward_above_read_words_10_memory_read_address, read_data => forward_above_read_words_10,
      write_address => forward_above_read_words_10_memory_write_address, write_data => forward_above_read_words_10_memory_write_data);

  forward_above_read_words_9_memory_read_enable <= true;
  forward_above_read_words_9_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_9_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_9_memory_write_data <= forward_above_write_words(9);
  forward_above_read_words_9_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_9_memory_read_enable,
      read_address => forward_above_read_words_9_memory_read_address, read_data => forward_above_read_words(9),
      write_address => forward_above_read_words_9_memory_write_address, write_data => forward_above_read_words_9_memory_write_data);

  forward_above_read_words_8_memory_read_enable <= true;
  forward_above_read_words_8_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_8_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_8_memory_write_data <= forward_above_write_words(8);
  forward_above_read_words_8_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_8_memory_read_enable,
      read_address => forward_above_read_words_8_memory_read_address, read_data => forward_above_read_words(8),
      write_address => forward_above_read_words_8_memory_write_address, write_data => forward_above_read_words_8_memory_write_data);

  forward_above_read_words_7_memory_read_enable <= true;
  forward_above_read_words_7_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_7_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_7_memory_write_data <= forward_above_write_words(7);
  forward_above_read_words_7_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_7_memory_read_enable,
      read_address => forward_above_read_words_7_memory_read_address, read_data => forward_above_read_words(7),
      write_address => forward_above_read_words_7_memory_write_address, write_data => forward_above_read_words_7_memory_write_data);

  forward_above_read_words_6_memory_read_enable <= true;
  forward_above_read_words_6_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_6_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_6_memory_write_data <= forward_above_write_words(6);
  forward_above_read_words_6_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_6_memory_read_enable,
      read_address => forward_above_read_words_6_memory_read_address, read_data => forward_above_read_words(6),
      write_address => forward_above_read_words_6_memory_write_address, write_data => forward_above_read_words_6_memory_write_data);

  forward_above_read_words_5_memory_read_enable <= true;
  forward_above_read_words_5_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_5_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_5_memory_write_data <= forward_above_write_words(5);
  forward_above_read_words_5_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_5_memory_read_enable,
      read_address => forward_above_read_words_5_memory_read_address, read_data => forward_above_read_words(5),
      write_address => forward_above_read_words_5_memory_write_address, write_data => forward_above_read_words_5_memory_write_data);

  forward_above_read_words_4_memory_read_enable <= true;
  forward_above_read_words_4_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_4_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_4_memory_write_data <= forward_above_write_words(4);
  forward_above_read_words_4_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_4_memory_read_enable,
      read_address => forward_above_read_words_4_memory_read_address, read_data => forward_above_read_words(4),
      write_address => forward_above_read_words_4_memory_write_address, write_data => forward_above_read_words_4_memory_write_data);

  forward_above_read_words_3_memory_read_enable <= true;
  forward_above_read_words_3_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_3_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_3_memory_write_data <= forward_above_write_words(3);
  forward_above_read_words_3_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_3_memory_read_enable,
      read_address => forward_above_read_words_3_memory_read_address, read_data => forward_above_read_words(3),
      write_address => forward_above_read_words_3_memory_write_address, write_data => forward_above_read_words_3_memory_write_data);

  forward_above_read_words_2_memory_read_enable <= true;
  forward_above_read_words_2_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_2_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_2_memory_write_data <= forward_above_write_words(2);
  forward_above_read_words_2_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_2_memory_read_enable,
      read_address => forward_above_read_words_2_memory_read_address, read_data => forward_above_read_words(2),
      write_address => forward_above_read_words_2_memory_write_address, write_data => forward_above_read_words_2_memory_write_data);

  forward_above_read_words_1_memory_read_enable <= true;
  forward_above_read_words_1_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_1_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_1_memory_write_data <= forward_above_write_words(1);
  forward_above_read_words_1_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_1_memory_read_enable,
      read_address => forward_above_read_words_1_memory_read_address, read_data => forward_above_read_words(1),
      write_address => forward_above_read_words_1_memory_write_address, write_data => forward_above_read_words_1_memory_write_data);

  forward_above_read_words_0_memory_read_enable <= true;
  forward_above_read_words_0_memory_read_address <= to_unsigned(entry_next_column, 11);
  forward_above_read_words_0_memory_write_address <= to_unsigned(forward_above_write_column, 11);
  forward_above_read_words_0_memory_write_data <= forward_above_write_words(0);
  forward_above_read_words_0_memory : entity work.line_memory
    generic map (depth => 1217, width => 32, address_bits => 11)
    port map (
      clock => clock, read_enable => forward_above_read_words_0_memory_read_enable,
      read_address => forward_above_read_words_0_memory_read_address, read_data => forward_above_read_words(0),
      write_address => forward_above_read_words_0_memory_write_address, write_data => forward_above_read_words_0_memory_write_data);

  forward_above_delay_held_12_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_12_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_12_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_12_memory_write_data <= to_unsigned(forward_above_total(63), 6) & to_unsigned(forward_above_total(62), 6) & to_unsigned(forward_above_total(61), 6) & to_unsigned(forward_above_total(60), 6);
  forward_above_delay_held_12_memory : entity work.line_memory
    generic map (depth => 7, width => 24, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_12_memory_read_enable,
      read_address => forward_above_delay_held_12_memory_read_address, read_data => forward_above_delay_held_12,
      write_address => forward_above_delay_held_12_memory_write_address, write_data => forward_above_delay_held_12_memory_write_data);

  forward_above_delay_held_11_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_11_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_11_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_11_memory_write_data <= to_unsigned(forward_above_total(59), 6) & to_unsigned(forward_above_total(58), 6) & to_unsigned(forward_above_total(57), 6) & to_unsigned(forward_above_total(56), 6) & to_unsigned(forward_above_total(55), 6);
  forward_above_delay_held_11_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_11_memory_read_enable,
      read_address => forward_above_delay_held_11_memory_read_address, read_data => forward_above_delay_held(11),
      write_address => forward_above_delay_held_11_memory_write_address, write_data => forward_above_delay_held_11_memory_write_data);

  forward_above_delay_held_10_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_10_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_10_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_10_memory_write_data <= to_unsigned(forward_above_total(54), 6) & to_unsigned(forward_above_total(53), 6) & to_unsigned(forward_above_total(52), 6) & to_unsigned(forward_above_total(51), 6) & to_unsigned(forward_above_total(50), 6);
  forward_above_delay_held_10_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_10_memory_read_enable,
      read_address => forward_above_delay_held_10_memory_read_address, read_data => forward_above_delay_held(10),
      write_address => forward_above_delay_held_10_memory_write_address, write_data => forward_above_delay_held_10_memory_write_data);

  forward_above_delay_held_9_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_9_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_9_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_9_memory_write_data <= to_unsigned(forward_above_total(49), 6) & to_unsigned(forward_above_total(48), 6) & to_unsigned(forward_above_total(47), 6) & to_unsigned(forward_above_total(46), 6) & to_unsigned(forward_above_total(45), 6);
  forward_above_delay_held_9_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_9_memory_read_enable,
      read_address => forward_above_delay_held_9_memory_read_address, read_data => forward_above_delay_held(9),
      write_address => forward_above_delay_held_9_memory_write_address, write_data => forward_above_delay_held_9_memory_write_data);

  forward_above_delay_held_8_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_8_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_8_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_8_memory_write_data <= to_unsigned(forward_above_total(44), 6) & to_unsigned(forward_above_total(43), 6) & to_unsigned(forward_above_total(42), 6) & to_unsigned(forward_above_total(41), 6) & to_unsigned(forward_above_total(40), 6);
  forward_above_delay_held_8_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_8_memory_read_enable,
      read_address => forward_above_delay_held_8_memory_read_address, read_data => forward_above_delay_held(8),
      write_address => forward_above_delay_held_8_memory_write_address, write_data => forward_above_delay_held_8_memory_write_data);

  forward_above_delay_held_7_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_7_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_7_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_7_memory_write_data <= to_unsigned(forward_above_total(39), 6) & to_unsigned(forward_above_total(38), 6) & to_unsigned(forward_above_total(37), 6) & to_unsigned(forward_above_total(36), 6) & to_unsigned(forward_above_total(35), 6);
  forward_above_delay_held_7_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_7_memory_read_enable,
      read_address => forward_above_delay_held_7_memory_read_address, read_data => forward_above_delay_held(7),
      write_address => forward_above_delay_held_7_memory_write_address, write_data => forward_above_delay_held_7_memory_write_data);

  forward_above_delay_held_6_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_6_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_6_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_6_memory_write_data <= to_unsigned(forward_above_total(34), 6) & to_unsigned(forward_above_total(33), 6) & to_unsigned(forward_above_total(32), 6) & to_unsigned(forward_above_total(31), 6) & to_unsigned(forward_above_total(30), 6);
  forward_above_delay_held_6_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_6_memory_read_enable,
      read_address => forward_above_delay_held_6_memory_read_address, read_data => forward_above_delay_held(6),
      write_address => forward_above_delay_held_6_memory_write_address, write_data => forward_above_delay_held_6_memory_write_data);

  forward_above_delay_held_5_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_5_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_5_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_5_memory_write_data <= to_unsigned(forward_above_total(29), 6) & to_unsigned(forward_above_total(28), 6) & to_unsigned(forward_above_total(27), 6) & to_unsigned(forward_above_total(26), 6) & to_unsigned(forward_above_total(25), 6);
  forward_above_delay_held_5_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_5_memory_read_enable,
      read_address => forward_above_delay_held_5_memory_read_address, read_data => forward_above_delay_held(5),
      write_address => forward_above_delay_held_5_memory_write_address, write_data => forward_above_delay_held_5_memory_write_data);

  forward_above_delay_held_4_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_4_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_4_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_4_memory_write_data <= to_unsigned(forward_above_total(24), 6) & to_unsigned(forward_above_total(23), 6) & to_unsigned(forward_above_total(22), 6) & to_unsigned(forward_above_total(21), 6) & to_unsigned(forward_above_total(20), 6);
  forward_above_delay_held_4_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_4_memory_read_enable,
      read_address => forward_above_delay_held_4_memory_read_address, read_data => forward_above_delay_held(4),
      write_address => forward_above_delay_held_4_memory_write_address, write_data => forward_above_delay_held_4_memory_write_data);

  forward_above_delay_held_3_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_3_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_3_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_3_memory_write_data <= to_unsigned(forward_above_total(19), 6) & to_unsigned(forward_above_total(18), 6) & to_unsigned(forward_above_total(17), 6) & to_unsigned(forward_above_total(16), 6) & to_unsigned(forward_above_total(15), 6);
  forward_above_delay_held_3_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_3_memory_read_enable,
      read_address => forward_above_delay_held_3_memory_read_address, read_data => forward_above_delay_held(3),
      write_address => forward_above_delay_held_3_memory_write_address, write_data => forward_above_delay_held_3_memory_write_data);

  forward_above_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_2_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_2_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_2_memory_write_data <= to_unsigned(forward_above_total(14), 6) & to_unsigned(forward_above_total(13), 6) & to_unsigned(forward_above_total(12), 6) & to_unsigned(forward_above_total(11), 6) & to_unsigned(forward_above_total(10), 6);
  forward_above_delay_held_2_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_2_memory_read_enable,
      read_address => forward_above_delay_held_2_memory_read_address, read_data => forward_above_delay_held(2),
      write_address => forward_above_delay_held_2_memory_write_address, write_data => forward_above_delay_held_2_memory_write_data);

  forward_above_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_1_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_1_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_1_memory_write_data <= to_unsigned(forward_above_total(9), 6) & to_unsigned(forward_above_total(8), 6) & to_unsigned(forward_above_total(7), 6) & to_unsigned(forward_above_total(6), 6) & to_unsigned(forward_above_total(5), 6);
  forward_above_delay_held_1_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_1_memory_read_enable,
      read_address => forward_above_delay_held_1_memory_read_address, read_data => forward_above_delay_held(1),
      write_address => forward_above_delay_held_1_memory_write_address, write_data => forward_above_delay_held_1_memory_write_data);

  forward_above_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_0_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_0_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_0_memory_write_data <= to_unsigned(forward_above_total(4), 6) & to_unsigned(forward_above_total(3), 6) & to_unsigned(forward_above_total(2), 6) & to_unsigned(forward_above_total(1), 6) & to_unsigned(forward_above_total(0), 6);
  forward_above_delay_held_0_memory : entity work.line_memory
    generic map (depth => 7, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_0_memory_read_enable,
      read_address => forward_above_delay_held_0_memory_read_address, read_data => forward_above_delay_held(0),
      write_address => forward_above_delay_held_0_memory_write_address, write_data => forward_above_delay_held_0_memory_write_data);

  forward_cost_delay_held_6_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_6_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_6_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_6_memory_write_data <= ((((((to_unsigned(entry_cost(62), 7) & to_unsigned(0, 6)) or (to_unsigned(entry_cost(63), 4) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(60), 13)))) or (to_unsigned(entry_cost(61), 10) & to_unsigned(0, 3)));
  forward_cost_delay_held_6_memory : entity work.line_memory
    generic map (depth => 7, width => 13, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_6_memory_read_enable,
      read_address => forward_cost_delay_held_6_memory_read_address, read_data => forward_cost_delay_held_6,
      write_address => forward_cost_delay_held_6_memory_write_address, write_data => forward_cost_delay_held_6_memory_write_data);

  forward_cost_delay_held_5_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_5_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_5_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_5_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(58), 7) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(59), 4) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(57), 10) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(56), 13) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(55), 16) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(54), 19) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(53), 22) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(52), 25) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(50), 31)))) or (to_unsigned(entry_cost(51), 28) & to_unsigned(0, 3)));
  forward_cost_delay_held_5_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_5_memory_read_enable,
      read_address => forward_cost_delay_held_5_memory_read_address, read_data => forward_cost_delay_held(5),
      write_address => forward_cost_delay_held_5_memory_write_address, write_data => forward_cost_delay_held_5_memory_write_data);

  forward_cost_delay_held_4_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_4_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_4_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_4_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(48), 7) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(49), 4) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(47), 10) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(46), 13) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(45), 16) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(44), 19) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(43), 22) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(42), 25) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(40), 31)))) or (to_unsigned(entry_cost(41), 28) & to_unsigned(0, 3)));
  forward_cost_delay_held_4_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_4_memory_read_enable,
      read_address => forward_cost_delay_held_4_memory_read_address, read_data => forward_cost_delay_held(4),
      write_address => forward_cost_delay_held_4_memory_write_address, write_data => forward_cost_delay_held_4_memory_write_data);

  forward_cost_delay_held_3_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_3_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_3_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_3_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(38), 7) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(39), 4) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(37), 10) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(36), 13) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(35), 16) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(34), 19) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(33), 22) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(32), 25) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(30), 31)))) or (to_unsigned(entry_cost(31), 28) & to_unsigned(0, 3)));
  forward_cost_delay_held_3_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_3_memory_read_enable,
      read_address => forward_cost_delay_held_3_memory_read_address, read_data => forward_cost_delay_held(3),
      write_address => forward_cost_delay_held_3_memory_write_address, write_data => forward_cost_delay_held_3_memory_write_data);

  forward_cost_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_2_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_2_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_2_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(28), 7) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(29), 4) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(27), 10) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(26), 13) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(25), 16) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(24), 19) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(23), 22) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(22), 25) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(20), 31)))) or (to_unsigned(entry_cost(21), 28) & to_unsigned(0, 3)));
  forward_cost_delay_held_2_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_2_memory_read_enable,
      read_address => forward_cost_delay_held_2_memory_read_address, read_data => forward_cost_delay_held(2),
      write_address => forward_cost_delay_held_2_memory_write_address, write_data => forward_cost_delay_held_2_memory_write_data);

  forward_cost_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_1_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_1_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_1_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(18), 7) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(19), 4) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(17), 10) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(16), 13) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(15), 16) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(14), 19) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(13), 22) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(12), 25) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(10), 31)))) or (to_unsigned(entry_cost(11), 28) & to_unsigned(0, 3)));
  forward_cost_delay_held_1_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_1_memory_read_enable,
      read_address => forward_cost_delay_held_1_memory_read_address, read_data => forward_cost_delay_held(1),
      write_address => forward_cost_delay_held_1_memory_write_address, write_data => forward_cost_delay_held_1_memory_write_data);

  forward_cost_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_0_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_0_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_0_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(8), 7) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(9), 4) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(7), 10) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(6), 13) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(5), 16) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(4), 19) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(3), 22) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(2), 25) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(0), 31)))) or (to_unsigned(entry_cost(1), 28) & to_unsigned(0, 3)));
  forward_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_0_memory_read_enable,
      read_address => forward_cost_delay_held_0_memory_read_address, read_data => forward_cost_delay_held(0),
      write_address => forward_cost_delay_held_0_memory_write_address, write_data => forward_cost_delay_held_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_differs : boolean;
    variable transform_read_column_inside_0_is_less, transform_left_filter_feature_0_any : boolean;
    variable transform_left_filter_feature_0_choice, transform_left_filter_feature_0_is_equal : boolean;
    variable transform_left_filter_feature_0_choices : boolean_1d(2 to 189);  -- transform_left_filter_feature_0_choice_#
    variable transform_left_filter_feature_0_value : boolean;
    variable transform_left_filter_feature_0_values : boolean_1d(2 to 5);  -- transform_left_filter_feature_0_value_#
    variable transform_left_filter_feature_0_all : boolean;
    variable transform_left_filter_feature_0_alls : boolean_1d(2 to 4);  -- transform_left_filter_feature_0_all_#
    variable transform_right_filter_feature_0_any, transform_right_filter_feature_0_choice : boolean;
    variable transform_right_filter_feature_0_is_equal : boolean;
    variable transform_right_filter_feature_0_choices : boolean_1d(2 to 198);  -- transform_right_filter_feature_0_choice_#
    variable transform_right_filter_feature_0_value : boolean;
    variable transform_right_filter_feature_0_values : boolean_1d(2 to 5);  -- transform_right_filter_feature_0_value_#
    variable transform_right_filter_feature_0_all : boolean;
    variable transform_right_filter_feature_0_alls : boolean_1d(2 to 9);  -- transform_right_filter_feature_0_all_#
    variable transform_counter_next_frame_choice, transform_counter_next_frame_choice_2 : boolean;
    variable raster_place_group_is_equal, delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less : boolean;
    variable delay_tag_map_column_is_less : boolean;
    variable slice0cost_pixels_first_0_0_count_value : boolean_1d(0 to 6);  -- slice0cost_pixels_first_0_0_count_#_value
    variable slice0cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 6);  -- slice0cost_pixels_first_0_0_count_#_value_2
    variable slice0cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 6);  -- slice0cost_pixels_first_0_0_count_#_value_3
    variable slice1cost_pixels_first_0_0_count_value : boolean_1d(0 to 6);  -- slice1cost_pixels_first_0_0_count_#_value
    variable slice1cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 6);  -- slice1cost_pixels_first_0_0_count_#_value_2
    variable slice1cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 6);  -- slice1cost_pixels_first_0_0_count_#_value_3
    variable slice2cost_pixels_first_0_0_count_value : boolean_1d(0 to 6);  -- slice2cost_pixels_first_0_0_count_#_value
    variable slice2cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 6);  -- slice2cost_pixels_first_0_0_count_#_value_2
    variable slice2cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 6);  -- slice2cost_pixels_first_0_0_count_#_value_3
    variable slice3cost_pixels_first_0_0_count_value : boolean_1d(0 to 6);  -- slice3cost_pixels_first_0_0_count_#_value
    variable slice3cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 6);  -- slice3cost_pixels_first_0_0_count_#_value_2
    variable slice3cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice3cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 6);  -- slice3cost_pixels_first_0_0_count_#_value_3
    variable entry_order_falls_any, entry_order_falls_all, entry_order_complete_all, entry_order_complete_any : boolean;
    variable entry_order_turned_output_column_choice, forward_left_start_cost_0_any : boolean;
    variable forward_left_start_cost_0_choice : boolean;
    variable forward_left_start_cost_0_choices : boolean_1d(2 to 6);  -- forward_left_start_cost_0_choice_#
    variable forward_left_start_cost_0_value : boolean;
    variable forward_left_start_cost_0_values : boolean_1d(2 to 3);  -- forward_left_start_cost_0_value_#
    variable forward_left_start_cost_0_is_less, sums_right_start_cost_0_any, sums_right_start_cost_0_choice : boolean;
    variable sums_right_start_cost_0_choices : boolean_1d(2 to 6);  -- sums_right_start_cost_0_choice_#
    variable sums_right_start_cost_0_value : boolean;
    variable sums_right_start_cost_0_values : boolean_1d(2 to 3);  -- sums_right_start_cost_0_value_#
    variable sums_right_start_cost_0_is_less, sums_turn_writes_copy_0_choice : boolean;
    variable winnerswinner1_of_pair_0_0_choice : boolean;
    variable winnerswinner1_of_pair_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_0_choice_#
    variable winnerswinner1_of_pair_0_0_value : boolean;
    variable winnerswinner1_of_pair_0_0_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_0_value_#
    variable winnerswinner1_of_pair_0_2_choice : boolean;
    variable winnerswinner1_of_pair_0_2_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_2_choice_#
    variable winnerswinner1_of_pair_0_2_value : boolean;
    variable winnerswinner1_of_pair_0_2_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_2_value_#
    variable winnerswinner1_of_pair_0_4_choice : boolean;
    variable winnerswinner1_of_pair_0_4_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_4_choice_#
    variable winnerswinner1_of_pair_0_4_value : boolean;
    variable winnerswinner1_of_pair_0_4_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_4_value_#
    variable winnerswinner1_of_pair_0_6_choice : boolean;
    variable winnerswinner1_of_pair_0_6_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_6_choice_#
    variable winnerswinner1_of_pair_0_6_value : boolean;
    variable winnerswinner1_of_pair_0_6_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_6_value_#
    variable winnerswinner1_of_pair_0_8_choice : boolean;
    variable winnerswinner1_of_pair_0_8_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_8_choice_#
    variable winnerswinner1_of_pair_0_8_value : boolean;
    variable winnerswinner1_of_pair_0_8_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_8_value_#
    variable winnerswinner1_of_pair_0_10_choice : boolean;
    variable winnerswinner1_of_pair_0_10_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_10_choice_#
    variable winnerswinner1_of_pair_0_10_value : boolean;
    variable winnerswinner1_of_pair_0_10_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_10_value_#
    variable winnerswinner1_of_pair_0_12_choice : boolean;
    variable winnerswinner1_of_pair_0_12_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_12_choice_#
    variable winnerswinner1_of_pair_0_12_value : boolean;
    variable winnerswinner1_of_pair_0_12_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_12_value_#
    variable winnerswinner1_of_pair_0_14_choice : boolean;
    variable winnerswinner1_of_pair_0_14_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_14_choice_#
    variable winnerswinner1_of_pair_0_14_value : boolean;
    variable winnerswinner1_of_pair_0_14_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_14_value_#
    variable winnerswinner1_of_pair_0_16_choice : boolean;
    variable winnerswinner1_of_pair_0_16_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_16_choice_#
    variable winnerswinner1_of_pair_0_16_value : boolean;
    variable winnerswinner1_of_pair_0_16_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_16_value_#
    variable winnerswinner1_of_pair_0_18_choice : boolean;
    variable winnerswinner1_of_pair_0_18_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_18_choice_#
    variable winnerswinner1_of_pair_0_18_value : boolean;
    variable winnerswinner1_of_pair_0_18_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_18_value_#
    variable winnerswinner1_of_pair_0_20_choice : boolean;
    variable winnerswinner1_of_pair_0_20_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_20_choice_#
    variable winnerswinner1_of_pair_0_20_value : boolean;
    variable winnerswinner1_of_pair_0_20_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_20_value_#
    variable winnerswinner1_of_pair_0_22_choice : boolean;
    variable winnerswinner1_of_pair_0_22_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_22_choice_#
    variable winnerswinner1_of_pair_0_22_value : boolean;
    variable winnerswinner1_of_pair_0_22_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_22_value_#
    variable winnerswinner1_of_pair_0_24_choice : boolean;
    variable winnerswinner1_of_pair_0_24_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_24_choice_#
    variable winnerswinner1_of_pair_0_24_value : boolean;
    variable winnerswinner1_of_pair_0_24_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_24_value_#
    variable winnerswinner1_of_pair_0_26_choice : boolean;
    variable winnerswinner1_of_pair_0_26_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_26_choice_#
    variable winnerswinner1_of_pair_0_26_value : boolean;
    variable winnerswinner1_of_pair_0_26_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_26_value_#
    variable winnerswinner1_of_pair_0_28_choice : boolean;
    variable winnerswinner1_of_pair_0_28_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_28_choice_#
    variable winnerswinner1_of_pair_0_28_value : boolean;
    variable winnerswinner1_of_pair_0_28_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_28_value_#
    variable winnerswinner1_of_pair_0_30_choice : boolean;
    variable winnerswinner1_of_pair_0_30_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_30_choice_#
    variable winnerswinner1_of_pair_0_30_value : boolean;
    variable winnerswinner1_of_pair_0_30_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_30_value_#
    variable winnerswinner1_of_pair_0_32_choice : boolean;
    variable winnerswinner1_of_pair_0_32_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_32_choice_#
    variable winnerswinner1_of_pair_0_32_value : boolean;
    variable winnerswinner1_of_pair_0_32_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_32_value_#
    variable winnerswinner1_of_pair_0_34_choice : boolean;
    variable winnerswinner1_of_pair_0_34_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_34_choice_#
    variable winnerswinner1_of_pair_0_34_value : boolean;
    variable winnerswinner1_of_pair_0_34_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_34_value_#
    variable winnerswinner1_of_pair_0_36_choice : boolean;
    variable winnerswinner1_of_pair_0_36_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_36_choice_#
    variable winnerswinner1_of_pair_0_36_value : boolean;
    variable winnerswinner1_of_pair_0_36_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_36_value_#
    variable winnerswinner1_of_pair_0_38_choice : boolean;
    variable winnerswinner1_of_pair_0_38_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_38_choice_#
    variable winnerswinner1_of_pair_0_38_value : boolean;
    variable winnerswinner1_of_pair_0_38_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_38_value_#
    variable winnerswinner1_of_pair_0_40_choice : boolean;
    variable winnerswinner1_of_pair_0_40_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_40_choice_#
    variable winnerswinner1_of_pair_0_40_value : boolean;
    variable winnerswinner1_of_pair_0_40_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_40_value_#
    variable winnerswinner1_of_pair_0_42_choice : boolean;
    variable winnerswinner1_of_pair_0_42_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_42_choice_#
    variable winnerswinner1_of_pair_0_42_value : boolean;
    variable winnerswinner1_of_pair_0_42_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_42_value_#
    variable winnerswinner1_of_pair_0_44_choice : boolean;
    variable winnerswinner1_of_pair_0_44_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_44_choice_#
    variable winnerswinner1_of_pair_0_44_value : boolean;
    variable winnerswinner1_of_pair_0_44_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_44_value_#
    variable winnerswinner1_of_pair_0_46_choice : boolean;
    variable winnerswinner1_of_pair_0_46_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_46_choice_#
    variable winnerswinner1_of_pair_0_46_value : boolean;
    variable winnerswinner1_of_pair_0_46_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_46_value_#
    variable winnerswinner1_of_pair_0_48_choice : boolean;
    variable winnerswinner1_of_pair_0_48_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_48_choice_#
    variable winnerswinner1_of_pair_0_48_value : boolean;
    variable winnerswinner1_of_pair_0_48_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_48_value_#
    variable winnerswinner1_of_pair_0_50_choice : boolean;
    variable winnerswinner1_of_pair_0_50_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_50_choice_#
    variable winnerswinner1_of_pair_0_50_value : boolean;
    variable winnerswinner1_of_pair_0_50_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_50_value_#
    variable winnerswinner1_of_pair_0_52_choice : boolean;
    variable winnerswinner1_of_pair_0_52_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_52_choice_#
    variable winnerswinner1_of_pair_0_52_value : boolean;
    variable winnerswinner1_of_pair_0_52_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_52_value_#
    variable winnerswinner1_of_pair_0_54_choice : boolean;
    variable winnerswinner1_of_pair_0_54_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_54_choice_#
    variable winnerswinner1_of_pair_0_54_value : boolean;
    variable winnerswinner1_of_pair_0_54_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_54_value_#
    variable winnerswinner1_of_pair_0_56_choice : boolean;
    variable winnerswinner1_of_pair_0_56_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_56_choice_#
    variable winnerswinner1_of_pair_0_56_value : boolean;
    variable winnerswinner1_of_pair_0_56_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_56_value_#
    variable winnerswinner1_of_pair_0_58_choice : boolean;
    variable winnerswinner1_of_pair_0_58_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_58_choice_#
    variable winnerswinner1_of_pair_0_58_value : boolean;
    variable winnerswinner1_of_pair_0_58_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_58_value_#
    variable winnerswinner1_of_pair_0_60_choice : boolean;
    variable winnerswinner1_of_pair_0_60_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_60_choice_#
    variable winnerswinner1_of_pair_0_60_value : boolean;
    variable winnerswinner1_of_pair_0_60_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_60_value_#
    variable winnerswinner1_of_pair_0_62_choice : boolean;
    variable winnerswinner1_of_pair_0_62_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_pair_0_62_choice_#
    variable winnerswinner1_of_pair_0_62_value : boolean;
    variable winnerswinner1_of_pair_0_62_values : boolean_1d(2 to 5);  -- winnerswinner1_of_pair_0_62_value_#
    variable winnerswinner1_of_four_0_0_choice, winnerswinner1_of_four_0_0_value : boolean;
    variable winnerswinner1_of_four_0_0_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_0_value_#
    variable winnerswinner1_of_four_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_0_choice_#
    variable winnerswinner1_of_four_0_4_choice, winnerswinner1_of_four_0_4_value : boolean;
    variable winnerswinner1_of_four_0_4_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_4_value_#
    variable winnerswinner1_of_four_0_4_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_4_choice_#
    variable winnerswinner1_of_four_0_8_choice, winnerswinner1_of_four_0_8_value : boolean;
    variable winnerswinner1_of_four_0_8_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_8_value_#
    variable winnerswinner1_of_four_0_8_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_8_choice_#
    variable winnerswinner1_of_four_0_12_choice, winnerswinner1_of_four_0_12_value : boolean;
    variable winnerswinner1_of_four_0_12_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_12_value_#
    variable winnerswinner1_of_four_0_12_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_12_choice_#
    variable winnerswinner1_of_four_0_16_choice, winnerswinner1_of_four_0_16_value : boolean;
    variable winnerswinner1_of_four_0_16_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_16_value_#
    variable winnerswinner1_of_four_0_16_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_16_choice_#
    variable winnerswinner1_of_four_0_20_choice, winnerswinner1_of_four_0_20_value : boolean;
    variable winnerswinner1_of_four_0_20_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_20_value_#
    variable winnerswinner1_of_four_0_20_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_20_choice_#
    variable winnerswinner1_of_four_0_24_choice, winnerswinner1_of_four_0_24_value : boolean;
    variable winnerswinner1_of_four_0_24_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_24_value_#
    variable winnerswinner1_of_four_0_24_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_24_choice_#
    variable winnerswinner1_of_four_0_28_choice, winnerswinner1_of_four_0_28_value : boolean;
    variable winnerswinner1_of_four_0_28_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_28_value_#
    variable winnerswinner1_of_four_0_28_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_28_choice_#
    variable winnerswinner1_of_four_0_32_choice, winnerswinner1_of_four_0_32_value : boolean;
    variable winnerswinner1_of_four_0_32_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_32_value_#
    variable winnerswinner1_of_four_0_32_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_32_choice_#
    variable winnerswinner1_of_four_0_36_choice, winnerswinner1_of_four_0_36_value : boolean;
    variable winnerswinner1_of_four_0_36_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_36_value_#
    variable winnerswinner1_of_four_0_36_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_36_choice_#
    variable winnerswinner1_of_four_0_40_choice, winnerswinner1_of_four_0_40_value : boolean;
    variable winnerswinner1_of_four_0_40_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_40_value_#
    variable winnerswinner1_of_four_0_40_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_40_choice_#
    variable winnerswinner1_of_four_0_44_choice, winnerswinner1_of_four_0_44_value : boolean;
    variable winnerswinner1_of_four_0_44_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_44_value_#
    variable winnerswinner1_of_four_0_44_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_44_choice_#
    variable winnerswinner1_of_four_0_48_choice, winnerswinner1_of_four_0_48_value : boolean;
    variable winnerswinner1_of_four_0_48_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_48_value_#
    variable winnerswinner1_of_four_0_48_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_48_choice_#
    variable winnerswinner1_of_four_0_52_choice, winnerswinner1_of_four_0_52_value : boolean;
    variable winnerswinner1_of_four_0_52_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_52_value_#
    variable winnerswinner1_of_four_0_52_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_52_choice_#
    variable winnerswinner1_of_four_0_56_choice, winnerswinner1_of_four_0_56_value : boolean;
    variable winnerswinner1_of_four_0_56_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_56_value_#
    variable winnerswinner1_of_four_0_56_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_56_choice_#
    variable winnerswinner1_of_four_0_60_choice, winnerswinner1_of_four_0_60_value : boolean;
    variable winnerswinner1_of_four_0_60_values : boolean_1d(2 to 12);  -- winnerswinner1_of_four_0_60_value_#
    variable winnerswinner1_of_four_0_60_choices : boolean_1d(2 to 8);  -- winnerswinner1_of_four_0_60_choice_#
    variable winnerswinner2_of_pair_0_0_choice : boolean;
    variable winnerswinner2_of_pair_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_pair_0_0_choice_#
    variable winnerswinner2_of_pair_0_0_value : boolean;
    variable winnerswinner2_of_pair_0_0_values : boolean_1d(2 to 5);  -- winnerswinner2_of_pair_0_0_value_#
    variable winnerswinner2_of_pair_0_2_choice : boolean;
    variable winnerswinner2_of_pair_0_2_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_pair_0_2_choice_#
    variable winnerswinner2_of_pair_0_2_value : boolean;
    variable winnerswinner2_of_pair_0_2_values : boolean_1d(2 to 5);  -- winnerswinner2_of_pair_0_2_value_#
    variable winnerswinner2_of_pair_0_4_choice : boolean;
    variable winnerswinner2_of_pair_0_4_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_pair_0_4_choice_#
    variable winnerswinner2_of_pair_0_4_value : boolean;
    variable winnerswinner2_of_pair_0_4_values : boolean_1d(2 to 5);  -- winnerswinner2_of_pair_0_4_value_#
    variable winnerswinner2_of_pair_0_6_choice : boolean;
    variable winnerswinner2_of_pair_0_6_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_pair_0_6_choice_#
    variable winnerswinner2_of_pair_0_6_value : boolean;
    variable winnerswinner2_of_pair_0_6_values : boolean_1d(2 to 5);  -- winnerswinner2_of_pair_0_6_value_#
    variable winnerswinner2_of_pair_0_8_choice : boolean;
    variable winnerswinner2_of_pair_0_8_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_pair_0_8_choice_#
    variable winnerswinner2_of_pair_0_8_value : boolean;
    variable winnerswinner2_of_pair_0_8_values : boolean_1d(2 to 5);  -- winnerswinner2_of_pair_0_8_value_#
    variable winnerswinner2_of_pair_0_10_choice : boolean;
    variable winnerswinner2_of_pair_0_10_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_pair_0_10_choice_#
    variable winnerswinner2_of_pair_0_10_value : boolean;
    variable winnerswinner2_of_pair_0_10_values : boolean_1d(2 to 5);  -- winnerswinner2_of_pair_0_10_value_#
    variable winnerswinner2_of_pair_0_12_choice : boolean;
    variable winnerswinner2_of_pair_0_12_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_pair_0_12_choice_#
    variable winnerswinner2_of_pair_0_12_value : boolean;
    variable winnerswinner2_of_pair_0_12_values : boolean_1d(2 to 5);  -- winnerswinner2_of_pair_0_12_value_#
    variable winnerswinner2_of_pair_0_14_choice : boolean;
    variable winnerswinner2_of_pair_0_14_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_pair_0_14_choice_#
    variable winnerswinner2_of_pair_0_14_value : boolean;
    variable winnerswinner2_of_pair_0_14_values : boolean_1d(2 to 5);  -- winnerswinner2_of_pair_0_14_value_#
    variable winnerswinner2_of_four_0_0_choice, winnerswinner2_of_four_0_0_value : boolean;
    variable winnerswinner2_of_four_0_0_values : boolean_1d(2 to 12);  -- winnerswinner2_of_four_0_0_value_#
    variable winnerswinner2_of_four_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_four_0_0_choice_#
    variable winnerswinner2_of_four_0_4_choice, winnerswinner2_of_four_0_4_value : boolean;
    variable winnerswinner2_of_four_0_4_values : boolean_1d(2 to 12);  -- winnerswinner2_of_four_0_4_value_#
    variable winnerswinner2_of_four_0_4_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_four_0_4_choice_#
    variable winnerswinner2_of_four_0_8_choice, winnerswinner2_of_four_0_8_value : boolean;
    variable winnerswinner2_of_four_0_8_values : boolean_1d(2 to 12);  -- winnerswinner2_of_four_0_8_value_#
    variable winnerswinner2_of_four_0_8_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_four_0_8_choice_#
    variable winnerswinner2_of_four_0_12_choice, winnerswinner2_of_four_0_12_value : boolean;
    variable winnerswinner2_of_four_0_12_values : boolean_1d(2 to 12);  -- winnerswinner2_of_four_0_12_value_#
    variable winnerswinner2_of_four_0_12_choices : boolean_1d(2 to 8);  -- winnerswinner2_of_four_0_12_choice_#
    variable winnerswinner3_of_pair_0_0_choice : boolean;
    variable winnerswinner3_of_pair_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner3_of_pair_0_0_choice_#
    variable winnerswinner3_of_pair_0_0_value : boolean;
    variable winnerswinner3_of_pair_0_0_values : boolean_1d(2 to 5);  -- winnerswinner3_of_pair_0_0_value_#
    variable winnerswinner3_of_pair_0_2_choice : boolean;
    variable winnerswinner3_of_pair_0_2_choices : boolean_1d(2 to 8);  -- winnerswinner3_of_pair_0_2_choice_#
    variable winnerswinner3_of_pair_0_2_value : boolean;
    variable winnerswinner3_of_pair_0_2_values : boolean_1d(2 to 5);  -- winnerswinner3_of_pair_0_2_value_#
    variable winnerswinner3_four_index_0_0_choice, winnerswinner3_four_index_0_0_value : boolean;
    variable winnerswinner3_four_index_0_0_values : boolean_1d(2 to 12);  -- winnerswinner3_four_index_0_0_value_#
    variable winnerswinner3_four_index_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner3_four_index_0_0_choice_#
    variable turn_order_address_any, turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_ready_tag_row_start_differs, turn_ready_tag_row_start_is_equal : boolean;
    variable turn_ready_tag_row_start_choice : boolean;
    variable turn_ready_tag_row_start_choices : boolean_1d(2 to 3);  -- turn_ready_tag_row_start_choice_#
    variable turn_ready_tag_row_start_is_equal_2, turn_ready_tag_row_start_all : boolean;
    variable turn_ready_tag_row_start_all_2, map_counter_group_is_equal, map_line_ended_choice : boolean;
    variable map_at_arrives_value, map_of_column_0_b_below_a_value, map_of_column_0_b_below_a_choice : boolean;
    variable map_of_column_0_b_below_a_values : boolean_1d(2 to 8);  -- map_of_column_0_b_below_a_value_#
    variable map_of_column_0_b_below_a_choices : boolean_1d(2 to 7);  -- map_of_column_0_b_below_a_choice_#
    variable map_of_column_0_c_below_a_value, map_of_column_0_c_below_a_choice : boolean;
    variable map_of_column_0_c_below_a_values : boolean_1d(2 to 5);  -- map_of_column_0_c_below_a_value_#
    variable map_of_column_0_c_below_a_choices : boolean_1d(2 to 14);  -- map_of_column_0_c_below_a_choice_#
    variable map_of_column_0_c_below_b_choice : boolean;
    variable map_of_column_0_c_below_b_choices : boolean_1d(2 to 4);  -- map_of_column_0_c_below_b_choice_#
    variable map_window_complete_is_equal, map_window_complete_choice, map_of_low_0_b_below_a_value : boolean;
    variable map_of_low_0_b_below_a_choice, map_of_low_0_b_below_a_is_equal : boolean;
    variable map_of_low_0_b_below_a_choices : boolean_1d(2 to 5);  -- map_of_low_0_b_below_a_choice_#
    variable map_of_low_0_b_below_a_values : boolean_1d(2 to 7);  -- map_of_low_0_b_below_a_value_#
    variable map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice : boolean;
    variable map_of_low_0_c_below_a_choices : boolean_1d(2 to 5);  -- map_of_low_0_c_below_a_choice_#
    variable map_of_low_0_c_below_b_choice : boolean;
    variable map_of_low_0_c_below_b_choices : boolean_1d(2 to 5);  -- map_of_low_0_c_below_b_choice_#
    variable map_of_middle_0_b_below_a_value, map_of_middle_0_b_below_a_choice : boolean;
    variable map_of_middle_0_b_below_a_is_equal : boolean;
    variable map_of_middle_0_b_below_a_choices : boolean_1d(2 to 5);  -- map_of_middle_0_b_below_a_choice_#
    variable map_of_middle_0_b_below_a_values : boolean_1d(2 to 7);  -- map_of_middle_0_b_below_a_value_#
    variable map_of_middle_0_c_below_a_value, map_of_middle_0_c_below_a_choice : boolean;
    variable map_of_middle_0_c_below_a_choices : boolean_1d(2 to 5);  -- map_of_middle_0_c_below_a_choice_#
    variable map_of_middle_0_c_below_b_choice : boolean;
    variable map_of_middle_0_c_below_b_choices : boolean_1d(2 to 5);  -- map_of_middle_0_c_below_b_choice_#
    variable map_of_high_0_b_below_a_value, map_of_high_0_b_below_a_choice, map_of_high_0_b_below_a_is_equal : boolean;
    variable map_of_high_0_b_below_a_choices : boolean_1d(2 to 5);  -- map_of_high_0_b_below_a_choice_#
    variable map_of_high_0_b_below_a_values : boolean_1d(2 to 7);  -- map_of_high_0_b_below_a_value_#
    variable map_of_high_0_c_below_a_value, map_of_high_0_c_below_a_choice : boolean;
    variable map_of_high_0_c_below_a_choices : boolean_1d(2 to 5);  -- map_of_high_0_c_below_a_choice_#
    variable map_of_high_0_c_below_b_choice : boolean;
    variable map_of_high_0_c_below_b_choices : boolean_1d(2 to 5);  -- map_of_high_0_c_below_b_choice_#
    variable map_of_all_0_b_below_a_value, map_of_all_0_b_below_a_choice, map_of_all_0_b_below_a_is_equal : boolean;
    variable map_of_all_0_b_below_a_choices : boolean_1d(2 to 5);  -- map_of_all_0_b_below_a_choice_#
    variable map_of_all_0_b_below_a_values : boolean_1d(2 to 7);  -- map_of_all_0_b_below_a_value_#
    variable map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice : boolean;
    variable map_of_all_0_c_below_a_choices : boolean_1d(2 to 5);  -- map_of_all_0_c_below_a_choice_#
    variable map_of_all_0_c_below_b_choice : boolean;
    variable map_of_all_0_c_below_b_choices : boolean_1d(2 to 5);  -- map_of_all_0_c_below_b_choice_#
    variable map_low_0_all : boolean_1d(0 to 1);  -- map_low_#_0_all
    variable relief_newest_choice : boolean;
    variable relief_newest_choices : boolean_1d(2 to 16);  -- relief_newest_choice_#
    variable relief_newest_value : boolean;
    variable relief_newest_values : boolean_1d(2 to 5);  -- relief_newest_value_#
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 45;
    variable transform_counter_group_choices : natural_1023_1d(2 to 3);  -- transform_counter_group_choice_#
    variable map_counter_group_choices : natural_1023_1d(2 to 3);  -- map_counter_group_choice_#
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 2047;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 19;
    variable forward_left_pair_choice : natural_127_1d(0 to 31);  -- forward_left_pair_#_choice
    variable forward_left_g_copy_0_value, forward_left_g_less_copy_0_value : natural range 0 to 127;
    variable forward_left_cost_choice : natural_127_1d(0 to 63);  -- forward_left_cost_#_choice
    variable forward_left_cost_choice_2 : natural_127_1d(0 to 63);  -- forward_left_cost_#_choice_2
    variable forward_left_arrived_choice : natural_127_1d(0 to 63);  -- forward_left_arrived_#_choice
    variable forward_left_arrived_choice_2 : natural_127_1d(3 to 4);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s : natural_127_1d(7 to 8);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_11 : natural_127_1d(11 to 12);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_15 : natural_127_1d(15 to 16);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_19 : natural_127_1d(19 to 20);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_23 : natural_127_1d(23 to 24);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_27 : natural_127_1d(27 to 28);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_31 : natural_127_1d(31 to 32);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_35 : natural_127_1d(35 to 36);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_39 : natural_127_1d(39 to 40);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_43 : natural_127_1d(43 to 44);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_47 : natural_127_1d(47 to 48);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_51 : natural_127_1d(51 to 52);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_55 : natural_127_1d(55 to 56);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_59 : natural_127_1d(59 to 60);  -- forward_left_arrived_#_choice_2
    variable sums_right_pair_choice : natural_127_1d(0 to 31);  -- sums_right_pair_#_choice
    variable sums_right_g_copy_0_value, sums_right_g_less_copy_0_value : natural range 0 to 127;
    variable sums_right_cost_choice : natural_127_1d(0 to 63);  -- sums_right_cost_#_choice
    variable sums_right_cost_choice_2 : natural_127_1d(0 to 63);  -- sums_right_cost_#_choice_2
    variable sums_right_arrived_choice : natural_127_1d(0 to 63);  -- sums_right_arrived_#_choice
    variable sums_right_arrived_choice_2 : natural_127_1d(3 to 4);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s : natural_127_1d(7 to 8);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_11 : natural_127_1d(11 to 12);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_15 : natural_127_1d(15 to 16);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_19 : natural_127_1d(19 to 20);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_23 : natural_127_1d(23 to 24);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_27 : natural_127_1d(27 to 28);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_31 : natural_127_1d(31 to 32);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_35 : natural_127_1d(35 to 36);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_39 : natural_127_1d(39 to 40);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_43 : natural_127_1d(43 to 44);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_47 : natural_127_1d(47 to 48);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_51 : natural_127_1d(51 to 52);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_55 : natural_127_1d(55 to 56);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_59 : natural_127_1d(59 to 60);  -- sums_right_arrived_#_choice_2
    variable forward_left_start_cost_0_choices_from_7 : natural_63_1d(7 to 9);  -- forward_left_start_cost_0_choice_#
    variable forward_left_room_value, forward_left_room_choice : natural range 0 to 63;
    variable forward_left_room_choices : natural_63_1d(2 to 3);  -- forward_left_room_choice_#
    variable forward_left_smallest_choice, forward_left_relief_pairs_0_choice : natural range 0 to 63;
    variable forward_left_relief_older_choice, forward_left_relief_recent_choice : natural range 0 to 63;
    variable forward_left_relief_largest_choice : natural range 0 to 63;
    variable sums_right_start_cost_0_choices_from_7 : natural_63_1d(7 to 9);  -- sums_right_start_cost_0_choice_#
    variable sums_right_room_value, sums_right_room_choice : natural range 0 to 63;
    variable sums_right_room_choices : natural_63_1d(2 to 3);  -- sums_right_room_choice_#
    variable sums_right_smallest_choice, sums_right_relief_pairs_0_choice : natural range 0 to 63;
    variable sums_right_relief_older_choice, sums_right_relief_recent_choice : natural range 0 to 63;
    variable sums_right_relief_largest_choice, map_sorted_low_0_choice : natural range 0 to 63;
    variable map_sorted_low_0_choice_2, map_sorted_middle_0_choice : natural range 0 to 63;
    variable map_sorted_middle_0_choice_2, map_sorted_high_0_choice, map_sorted_high_0_choice_2 : natural range 0 to 63;
    variable map_largest_low_0_choice, map_largest_low_0_choice_2, map_median_middle_0_choice : natural range 0 to 63;
    variable map_median_middle_0_choices : natural_63_1d(2 to 4);  -- map_median_middle_0_choice_#
    variable map_smallest_high_0_choice, map_smallest_high_0_choice_2 : natural range 0 to 63;
    variable map_out_disparity_0_choice : natural range 0 to 63;
    variable map_out_disparity_0_choices : natural_63_1d(2 to 4);  -- map_out_disparity_0_choice_#
    variable map_low_0_0_choice, map_middle_0_0_choice, map_high_0_0_choice : natural range 0 to 63;
    variable relief_newest_choice_17 : natural range 0 to 63;
    variable forward_left_smallest_difference : integer range -63 to 74;
    variable forward_left_relief_reach_of_best_sum, forward_left_relief_reach_of_best_choice : natural range 0 to 190;
    variable sums_right_relief_reach_of_best_sum, sums_right_relief_reach_of_best_choice : natural range 0 to 190;
    variable other_choice_4 : natural_190_1d(0 to 15);  -- other_#_choice_4
    variable forward_left_relief_reach_of_best_choices : natural_255_1d(2 to 3);  -- forward_left_relief_reach_of_best_choice_#
    variable sums_right_relief_reach_of_best_choices : natural_255_1d(2 to 3);  -- sums_right_relief_reach_of_best_choice_#
    variable relief_newest_values_from_6 : natural_255_1d(6 to 7);  -- relief_newest_value_#
    variable other_choices : natural_255_1d(0 to 15);  -- other_#_choice
    variable other_choice : natural_255_2d(0 to 15, 2 to 3);  -- other_#_choice_#
    variable forward_left_relief_leaves_choice, sums_right_relief_leaves_choice : natural range 64 to 127;
    variable forward_above_total_choice : natural_31_1d(0 to 63);  -- forward_above_total_#_choice
    variable forward_above_write_words_choice : natural_68_1d(0 to 10);  -- forward_above_write_words_#_choice
    variable forward_above_write_words_choices : natural_68_2d(0 to 9, 2 to 6);  -- forward_above_write_words_#_choice_#
    variable forward_above_write_words_10_choices : natural_68_1d(2 to 4);  -- forward_above_write_words_10_choice_#
    variable sums_right_smallest_difference : integer range -63 to 63;
    variable other_20_choice, other_22_choice, other_24_choice, other_26_choice : natural range 0 to 11;
    variable other_28_choice, other_30_choice, other_32_choice, other_34_choice : natural range 0 to 11;
    variable other_36_choice, other_38_choice, other_40_choice, other_42_choice : natural range 0 to 11;
    variable other_44_choice, other_46_choice, other_48_choice, other_50_choice : natural range 0 to 11;
    variable other_52_choice, other_54_choice, other_56_choice, other_58_choice : natural range 0 to 11;
    variable other_60_choice, other_62_choice, other_64_choice, other_66_choice : natural range 0 to 11;
    variable other_68_choice, other_70_choice, other_72_choice, other_74_choice : natural range 0 to 11;
    variable other_76_choice, other_78_choice, other_80_choice, other_82_choice : natural range 0 to 11;
    variable other_84_choice, other_86_choice, other_88_choice, other_90_choice : natural range 0 to 11;
    variable other_92_choice, other_94_choice, other_96_choice, other_98_choice : natural range 0 to 11;
    variable other_100_choice, other_102_choice, other_104_choice, other_106_choice : natural range 0 to 11;
    variable other_108_choice, other_110_choice, other_112_choice, other_114_choice : natural range 0 to 11;
    variable other_116_choice, other_118_choice, other_120_choice, other_122_choice : natural range 0 to 11;
    variable other_124_choice, other_126_choice, other_128_choice, other_130_choice : natural range 0 to 11;
    variable other_132_choice, other_134_choice, other_136_choice, other_138_choice : natural range 0 to 11;
    variable other_140_choice, other_142_choice, other_144_choice, other_146_choice : natural range 0 to 11;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_group = 719;
      transform_counter_group_is_equal_2 := transform_counter_column = 1279;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 45;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_differs := transform_counter_group /= 722;
      if (transform_counter_group = 721) and transform_counter_next_frame then
        transform_counter_group_choices(2) := 2;
      else
        transform_counter_group_choices(2) := (transform_counter_group + 1) mod 1024;
      end if;
      if transform_counter_group_differs and in_valid and transform_counter_group_is_equal_2 then
        transform_counter_group_choices(3) := transform_counter_group_choices(2);
      else
        transform_counter_group_choices(3) := transform_counter_group;
      end if;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
      transform_left_filter_feature_0_any := (not is_set(transform_left_filter_column(4, 2), 1)) or (not
        is_set(transform_left_filter_column(4, 2), 0));
      if is_set(transform_left_filter_column(5, 1), 0) then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not is_set(transform_left_filter_column(4, 2), 1);
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column(4, 2) mod 4) = 0;
      if is_set(transform_left_filter_column(5, 1), 1) then
        transform_left_filter_feature_0_choices(2) := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choices(2) := is_set(transform_left_filter_column(5, 1), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_value := is_set(transform_left_filter_column(4, 2), 2);
      if transform_left_filter_feature_0_choices(2) then
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column(5, 1), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column(5, 1), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 2 to 5 loop
        transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(4, 2), i + 1);
        if transform_left_filter_feature_0_choices(i + 1) then
          transform_left_filter_feature_0_choices(i + 2) := (not is_set(transform_left_filter_column(5, 1), i + 1)) or
            transform_left_filter_feature_0_values(i);
        else
          transform_left_filter_feature_0_choices(i + 2) := (not is_set(transform_left_filter_column(5, 1), i + 1)) and
            transform_left_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(7) then
        transform_left_filter_feature_0_choices(8) := transform_filtering_0_column_inside(5) and
          is_set(transform_left_filter_column(5, 1), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(8) := transform_filtering_0_column_inside(5) and
          (is_set(transform_left_filter_column(5, 1), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
      end if;
      for i in 4 to 5 loop
        if is_set(transform_left_filter_column(i, 8 - i), 0) then
          transform_left_filter_feature_0_choices(9 * i - 27) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(9 * i - 27) := not is_set(transform_left_filter_column(4, 2), 1);
        end if;
        if is_set(transform_left_filter_column(i, 8 - i), 1) then
          transform_left_filter_feature_0_choices(9 * i - 26) := transform_left_filter_feature_0_choices(9 * i - 27);
        else
          transform_left_filter_feature_0_choices(9 * i - 26) := is_set(transform_left_filter_column(i, 8 - i), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(9 * i - 26) then
          transform_left_filter_feature_0_choices(9 * i - 25) := (not is_set(transform_left_filter_column(i, 8 - i),
            2)) and transform_left_filter_feature_0_value;
        else
          transform_left_filter_feature_0_choices(9 * i - 25) := (not is_set(transform_left_filter_column(i, 8 - i),
            2)) or transform_left_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(9 * i + j - 28) then
            transform_left_filter_feature_0_choices(9 * i + j - 27) := (not is_set(transform_left_filter_column(i, 8 -
              i), j)) or transform_left_filter_feature_0_values(j - 1);
          else
            transform_left_filter_feature_0_choices(9 * i + j - 27) := (not is_set(transform_left_filter_column(i, 8 -
              i), j)) and transform_left_filter_feature_0_values(j - 1);
          end if;
        end loop;
        if is_set(transform_left_filter_column(i, 8 - i), 7) then
          transform_left_filter_feature_0_choices(9 * i - 20) := transform_filtering_0_column_inside(i);
        else
          transform_left_filter_feature_0_choices(9 * i - 20) := transform_filtering_0_column_inside(i) and (not
            is_set(transform_left_filter_column(4, 2), 7));
        end if;
        if transform_left_filter_feature_0_choices(9 * i - 21) then
          transform_left_filter_feature_0_choices(9 * i - 19) := is_set(transform_left_filter_column(i, 8 - i), 7) and
            transform_filtering_0_column_inside(i) and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(9 * i - 19) := transform_left_filter_feature_0_choices(9 * i - 20);
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(7 - 3 * i, 1 - i), 0) then
          transform_left_filter_feature_0_choices(17 * i + 27) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(17 * i + 27) := not is_set(transform_left_filter_column(4, 2), 1);
        end if;
        if is_set(transform_left_filter_column(7 - 3 * i, 1 - i), 1) then
          transform_left_filter_feature_0_choices(17 * i + 28) := transform_left_filter_feature_0_choices(17 * i + 27);
        else
          transform_left_filter_feature_0_choices(17 * i + 28) := is_set(transform_left_filter_column(7 - 3 * i, 1 -
            i), 0) and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(17 * i + 28) then
          transform_left_filter_feature_0_choices(17 * i + 29) := (not is_set(transform_left_filter_column(7 - 3 * i, 1
            - i), 2)) and transform_left_filter_feature_0_value;
        else
          transform_left_filter_feature_0_choices(17 * i + 29) := (not is_set(transform_left_filter_column(7 - 3 * i, 1
            - i), 2)) or transform_left_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(17 * i + j + 26) then
            transform_left_filter_feature_0_choices(17 * i + j + 27) := (not is_set(transform_left_filter_column(7 - 3
              * i, 1 - i), j)) or transform_left_filter_feature_0_values(j - 1);
          else
            transform_left_filter_feature_0_choices(17 * i + j + 27) := (not is_set(transform_left_filter_column(7 - 3
              * i, 1 - i), j)) and transform_left_filter_feature_0_values(j - 1);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(17 * i + 33) then
          transform_left_filter_feature_0_choices(17 * i + 34) := transform_filtering_0_column_inside(7 - 3 * i) and
            is_set(transform_left_filter_column(7 - 3 * i, 1 - i), 7) and (not is_set(transform_left_filter_column(4,
            2), 7));
        else
          transform_left_filter_feature_0_choices(17 * i + 34) := transform_filtering_0_column_inside(7 - 3 * i) and
            (is_set(transform_left_filter_column(7 - 3 * i, 1 - i), 7) or (not is_set(transform_left_filter_column(4,
            2), 7)));
        end if;
        if is_set(transform_left_filter_column(7 - 4 * i, 3), 0) then
          transform_left_filter_feature_0_choices(17 * i + 35) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(17 * i + 35) := not is_set(transform_left_filter_column(4, 2), 1);
        end if;
        if is_set(transform_left_filter_column(7 - 4 * i, 3), 1) then
          transform_left_filter_feature_0_choices(17 * i + 36) := transform_left_filter_feature_0_choices(17 * i + 35);
        else
          transform_left_filter_feature_0_choices(17 * i + 36) := is_set(transform_left_filter_column(7 - 4 * i, 3), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(17 * i + 36) then
          transform_left_filter_feature_0_choices(17 * i + 37) := (not is_set(transform_left_filter_column(7 - 4 * i,
            3), 2)) and transform_left_filter_feature_0_value;
        else
          transform_left_filter_feature_0_choices(17 * i + 37) := (not is_set(transform_left_filter_column(7 - 4 * i,
            3), 2)) or transform_left_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(17 * i + j + 34) then
            transform_left_filter_feature_0_choices(17 * i + j + 35) := (not is_set(transform_left_filter_column(7 - 4
              * i, 3), j)) or transform_left_filter_feature_0_values(j - 1);
          else
            transform_left_filter_feature_0_choices(17 * i + j + 35) := (not is_set(transform_left_filter_column(7 - 4
              * i, 3), j)) and transform_left_filter_feature_0_values(j - 1);
          end if;
        end loop;
        if is_set(transform_left_filter_column(7 - 4 * i, 3), 7) then
          transform_left_filter_feature_0_choices(17 * i + 42) := transform_filtering_0_column_inside(7 - 4 * i);
        else
          transform_left_filter_feature_0_choices(17 * i + 42) := transform_filtering_0_column_inside(7 - 4 * i) and
            (not is_set(transform_left_filter_column(4, 2), 7));
        end if;
        if transform_left_filter_feature_0_choices(17 * i + 41) then
          transform_left_filter_feature_0_choices(17 * i + 43) := is_set(transform_left_filter_column(7 - 4 * i, 3), 7)
            and transform_filtering_0_column_inside(7 - 4 * i) and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(17 * i + 43) := transform_left_filter_feature_0_choices(17 * i + 42);
        end if;
      end loop;
      if is_set(transform_left_filter_column(3, 1), 0) then
        transform_left_filter_feature_0_choices(61) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(61) := not is_set(transform_left_filter_column(4, 2), 1);
      end if;
      if is_set(transform_left_filter_column(3, 1), 1) then
        transform_left_filter_feature_0_choices(62) := transform_left_filter_feature_0_choices(61);
      else
        transform_left_filter_feature_0_choices(62) := is_set(transform_left_filter_column(3, 1), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(62) then
        transform_left_filter_feature_0_choices(63) := (not is_set(transform_left_filter_column(3, 1), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(63) := (not is_set(transform_left_filter_column(3, 1), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 63 to 66 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(3, 1), i - 60)) or
            transform_left_filter_feature_0_values(i - 61);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(3, 1), i - 60))
            and transform_left_filter_feature_0_values(i - 61);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(67) then
        transform_left_filter_feature_0_choices(68) := transform_filtering_0_column_inside(3) and
          is_set(transform_left_filter_column(3, 1), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(68) := transform_filtering_0_column_inside(3) and
          (is_set(transform_left_filter_column(3, 1), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
      end if;
      if is_set(transform_left_filter_column(1, 3), 0) then
        transform_left_filter_feature_0_choices(69) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(69) := not is_set(transform_left_filter_column(4, 2), 1);
      end if;
      if is_set(transform_left_filter_column(1, 3), 1) then
        transform_left_filter_feature_0_choices(70) := transform_left_filter_feature_0_choices(69);
      else
        transform_left_filter_feature_0_choices(70) := is_set(transform_left_filter_column(1, 3), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(70) then
        transform_left_filter_feature_0_choices(71) := (not is_set(transform_left_filter_column(1, 3), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(71) := (not is_set(transform_left_filter_column(1, 3), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 71 to 74 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(1, 3), i - 68)) or
            transform_left_filter_feature_0_values(i - 69);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(1, 3), i - 68))
            and transform_left_filter_feature_0_values(i - 69);
        end if;
      end loop;
      if is_set(transform_left_filter_column(1, 3), 7) then
        transform_left_filter_feature_0_choices(76) := transform_filtering_0_column_inside(1);
      else
        transform_left_filter_feature_0_choices(76) := transform_filtering_0_column_inside(1) and (not
          is_set(transform_left_filter_column(4, 2), 7));
      end if;
      if transform_left_filter_feature_0_choices(75) then
        transform_left_filter_feature_0_choices(77) := is_set(transform_left_filter_column(1, 3), 7) and
          transform_filtering_0_column_inside(1) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(77) := transform_left_filter_feature_0_choices(76);
      end if;
      if is_set(transform_left_filter_column(1, 1), 0) then
        transform_left_filter_feature_0_choices(78) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(78) := not is_set(transform_left_filter_column(4, 2), 1);
      end if;
      if is_set(transform_left_filter_column(1, 1), 1) then
        transform_left_filter_feature_0_choices(79) := transform_left_filter_feature_0_choices(78);
      else
        transform_left_filter_feature_0_choices(79) := is_set(transform_left_filter_column(1, 1), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(79) then
        transform_left_filter_feature_0_choices(80) := (not is_set(transform_left_filter_column(1, 1), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(80) := (not is_set(transform_left_filter_column(1, 1), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 80 to 83 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(1, 1), i - 77)) or
            transform_left_filter_feature_0_values(i - 78);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(1, 1), i - 77))
            and transform_left_filter_feature_0_values(i - 78);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(84) then
        transform_left_filter_feature_0_choices(85) := transform_filtering_0_column_inside(1) and
          is_set(transform_left_filter_column(1, 1), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(85) := transform_filtering_0_column_inside(1) and
          (is_set(transform_left_filter_column(1, 1), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
      end if;
      if is_set(transform_left_filter_column(0, 2), 0) then
        transform_left_filter_feature_0_choices(86) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(86) := not is_set(transform_left_filter_column(4, 2), 1);
      end if;
      if is_set(transform_left_filter_column(0, 2), 1) then
        transform_left_filter_feature_0_choices(87) := transform_left_filter_feature_0_choices(86);
      else
        transform_left_filter_feature_0_choices(87) := is_set(transform_left_filter_column(0, 2), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(87) then
        transform_left_filter_feature_0_choices(88) := (not is_set(transform_left_filter_column(0, 2), 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(88) := (not is_set(transform_left_filter_column(0, 2), 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 88 to 91 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(0, 2), i - 85)) or
            transform_left_filter_feature_0_values(i - 86);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(0, 2), i - 85))
            and transform_left_filter_feature_0_values(i - 86);
        end if;
      end loop;
      transform_left_filter_feature_0_all := transform_filtering_0_column_inside(0) and (not
        is_set(transform_left_filter_column(4, 2), 7));
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(0, 2 - 2 * i), 7) then
          transform_left_filter_feature_0_choices(9 * i + 93) := transform_filtering_0_column_inside(0);
        else
          transform_left_filter_feature_0_choices(9 * i + 93) := transform_left_filter_feature_0_all;
        end if;
        if transform_left_filter_feature_0_choices(9 * i + 92) then
          transform_left_filter_feature_0_choices(9 * i + 94) := is_set(transform_left_filter_column(0, 2 - 2 * i), 7)
            and transform_filtering_0_column_inside(0) and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(9 * i + 94) := transform_left_filter_feature_0_choices(9 * i + 93);
        end if;
        if is_set(transform_left_filter_column(0, 4 * i), 0) then
          transform_left_filter_feature_0_choices(9 * i + 95) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(9 * i + 95) := not is_set(transform_left_filter_column(4, 2), 1);
        end if;
        if is_set(transform_left_filter_column(0, 4 * i), 1) then
          transform_left_filter_feature_0_choices(9 * i + 96) := transform_left_filter_feature_0_choices(9 * i + 95);
        else
          transform_left_filter_feature_0_choices(9 * i + 96) := is_set(transform_left_filter_column(0, 4 * i), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(9 * i + 96) then
          transform_left_filter_feature_0_choices(9 * i + 97) := (not is_set(transform_left_filter_column(0, 4 * i),
            2)) and transform_left_filter_feature_0_value;
        else
          transform_left_filter_feature_0_choices(9 * i + 97) := (not is_set(transform_left_filter_column(0, 4 * i),
            2)) or transform_left_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(9 * i + j + 94) then
            transform_left_filter_feature_0_choices(9 * i + j + 95) := (not is_set(transform_left_filter_column(0, 4 *
              i), j)) or transform_left_filter_feature_0_values(j - 1);
          else
            transform_left_filter_feature_0_choices(9 * i + j + 95) := (not is_set(transform_left_filter_column(0, 4 *
              i), j)) and transform_left_filter_feature_0_values(j - 1);
          end if;
        end loop;
      end loop;
      for i in 2 to 3 loop
        if transform_left_filter_feature_0_choices(26 * i + 58) then
          transform_left_filter_feature_0_choices(26 * i + 59) := transform_filtering_0_column_inside(2 * i - 4) and
            is_set(transform_left_filter_column(2 * i - 4, 4), 7) and (not is_set(transform_left_filter_column(4, 2),
            7));
        else
          transform_left_filter_feature_0_choices(26 * i + 59) := transform_filtering_0_column_inside(2 * i - 4) and
            (is_set(transform_left_filter_column(2 * i - 4, 4), 7) or (not is_set(transform_left_filter_column(4, 2),
            7)));
        end if;
        if is_set(transform_left_filter_column(4 * i - 6, 2), 0) then
          transform_left_filter_feature_0_choices(26 * i + 60) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(26 * i + 60) := not is_set(transform_left_filter_column(4, 2), 1);
        end if;
        if is_set(transform_left_filter_column(4 * i - 6, 2), 1) then
          transform_left_filter_feature_0_choices(26 * i + 61) := transform_left_filter_feature_0_choices(26 * i + 60);
        else
          transform_left_filter_feature_0_choices(26 * i + 61) := is_set(transform_left_filter_column(4 * i - 6, 2), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(26 * i + 61) then
          transform_left_filter_feature_0_choices(26 * i + 62) := (not is_set(transform_left_filter_column(4 * i - 6,
            2), 2)) and transform_left_filter_feature_0_value;
        else
          transform_left_filter_feature_0_choices(26 * i + 62) := (not is_set(transform_left_filter_column(4 * i - 6,
            2), 2)) or transform_left_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(26 * i + j + 59) then
            transform_left_filter_feature_0_choices(26 * i + j + 60) := (not is_set(transform_left_filter_column(4 * i
              - 6, 2), j)) or transform_left_filter_feature_0_values(j - 1);
          else
            transform_left_filter_feature_0_choices(26 * i + j + 60) := (not is_set(transform_left_filter_column(4 * i
              - 6, 2), j)) and transform_left_filter_feature_0_values(j - 1);
          end if;
        end loop;
        transform_left_filter_feature_0_alls(i) := transform_filtering_0_column_inside(4 * i - 6) and (not
          is_set(transform_left_filter_column(4, 2), 7));
        for j in 0 to 1 loop
          if is_set(transform_left_filter_column(4 * i - 6, 2 - 2 * j), 7) then
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 67) := transform_filtering_0_column_inside(4 * i -
              6);
          else
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 67) := transform_left_filter_feature_0_alls(i);
          end if;
          if transform_left_filter_feature_0_choices(26 * i + 9 * j + 66) then
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 68) := is_set(transform_left_filter_column(4 * i -
              6, 2 - 2 * j), 7) and transform_filtering_0_column_inside(4 * i - 6) and (not
              is_set(transform_left_filter_column(4, 2), 7));
          else
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 68) := transform_left_filter_feature_0_choices(26
              * i + 9 * j + 67);
          end if;
          if is_set(transform_left_filter_column(4 * i - 6, 4 * j), 0) then
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 69) := transform_left_filter_feature_0_any;
          else
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 69) := not is_set(transform_left_filter_column(4,
              2), 1);
          end if;
          if is_set(transform_left_filter_column(4 * i - 6, 4 * j), 1) then
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 70) := transform_left_filter_feature_0_choices(26
              * i + 9 * j + 69);
          else
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 70) := is_set(transform_left_filter_column(4 * i -
              6, 4 * j), 0) and transform_left_filter_feature_0_is_equal;
          end if;
          if transform_left_filter_feature_0_choices(26 * i + 9 * j + 70) then
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 71) := (not is_set(transform_left_filter_column(4
              * i - 6, 4 * j), 2)) and transform_left_filter_feature_0_value;
          else
            transform_left_filter_feature_0_choices(26 * i + 9 * j + 71) := (not is_set(transform_left_filter_column(4
              * i - 6, 4 * j), 2)) or transform_left_filter_feature_0_value;
          end if;
          for k in 3 to 6 loop
            if transform_left_filter_feature_0_choices(26 * i + 9 * j + k + 68) then
              transform_left_filter_feature_0_choices(26 * i + 9 * j + k + 69) := (not
                is_set(transform_left_filter_column(4 * i - 6, 4 * j), k)) or transform_left_filter_feature_0_values(k
                - 1);
            else
              transform_left_filter_feature_0_choices(26 * i + 9 * j + k + 69) := (not
                is_set(transform_left_filter_column(4 * i - 6, 4 * j), k)) and transform_left_filter_feature_0_values(k
                - 1);
            end if;
          end loop;
        end loop;
      end loop;
      if transform_left_filter_feature_0_choices(162) then
        transform_left_filter_feature_0_choices(163) := transform_filtering_0_column_inside(6) and
          is_set(transform_left_filter_column(6, 4), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(163) := transform_filtering_0_column_inside(6) and
          (is_set(transform_left_filter_column(6, 4), 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
      end if;
      if is_set(transform_left_filter_column_8_2, 0) then
        transform_left_filter_feature_0_choices(164) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(164) := not is_set(transform_left_filter_column(4, 2), 1);
      end if;
      if is_set(transform_left_filter_column_8_2, 1) then
        transform_left_filter_feature_0_choices(165) := transform_left_filter_feature_0_choices(164);
      else
        transform_left_filter_feature_0_choices(165) := is_set(transform_left_filter_column_8_2, 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(165) then
        transform_left_filter_feature_0_choices(166) := (not is_set(transform_left_filter_column_8_2, 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(166) := (not is_set(transform_left_filter_column_8_2, 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 166 to 169 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_8_2, i - 163)) or
            transform_left_filter_feature_0_values(i - 164);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_8_2, i - 163)) and
            transform_left_filter_feature_0_values(i - 164);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(4) := transform_filtering_0_column_inside(8) and (not
        is_set(transform_left_filter_column(4, 2), 7));
      if is_set(transform_left_filter_column_8_2, 7) then
        transform_left_filter_feature_0_choices(171) := transform_filtering_0_column_inside(8);
      else
        transform_left_filter_feature_0_choices(171) := transform_left_filter_feature_0_alls(4);
      end if;
      if transform_left_filter_feature_0_choices(170) then
        transform_left_filter_feature_0_choices(172) := is_set(transform_left_filter_column_8_2, 7) and
          transform_filtering_0_column_inside(8) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(172) := transform_left_filter_feature_0_choices(171);
      end if;
      if is_set(transform_left_filter_column_8_0, 0) then
        transform_left_filter_feature_0_choices(173) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(173) := not is_set(transform_left_filter_column(4, 2), 1);
      end if;
      if is_set(transform_left_filter_column_8_0, 1) then
        transform_left_filter_feature_0_choices(174) := transform_left_filter_feature_0_choices(173);
      else
        transform_left_filter_feature_0_choices(174) := is_set(transform_left_filter_column_8_0, 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(174) then
        transform_left_filter_feature_0_choices(175) := (not is_set(transform_left_filter_column_8_0, 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(175) := (not is_set(transform_left_filter_column_8_0, 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 175 to 178 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_8_0, i - 172)) or
            transform_left_filter_feature_0_values(i - 173);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_8_0, i - 172)) and
            transform_left_filter_feature_0_values(i - 173);
        end if;
      end loop;
      if is_set(transform_left_filter_column_8_0, 7) then
        transform_left_filter_feature_0_choices(180) := transform_filtering_0_column_inside(8);
      else
        transform_left_filter_feature_0_choices(180) := transform_left_filter_feature_0_alls(4);
      end if;
      if transform_left_filter_feature_0_choices(179) then
        transform_left_filter_feature_0_choices(181) := is_set(transform_left_filter_column_8_0, 7) and
          transform_filtering_0_column_inside(8) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(181) := transform_left_filter_feature_0_choices(180);
      end if;
      if is_set(transform_left_filter_column_8_4, 0) then
        transform_left_filter_feature_0_choices(182) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(182) := not is_set(transform_left_filter_column(4, 2), 1);
      end if;
      if is_set(transform_left_filter_column_8_4, 1) then
        transform_left_filter_feature_0_choices(183) := transform_left_filter_feature_0_choices(182);
      else
        transform_left_filter_feature_0_choices(183) := is_set(transform_left_filter_column_8_4, 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(183) then
        transform_left_filter_feature_0_choices(184) := (not is_set(transform_left_filter_column_8_4, 2)) and
          transform_left_filter_feature_0_value;
      else
        transform_left_filter_feature_0_choices(184) := (not is_set(transform_left_filter_column_8_4, 2)) or
          transform_left_filter_feature_0_value;
      end if;
      for i in 184 to 187 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_8_4, i - 181)) or
            transform_left_filter_feature_0_values(i - 182);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_8_4, i - 181)) and
            transform_left_filter_feature_0_values(i - 182);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(188) then
        transform_left_filter_feature_0_choices(189) := transform_filtering_0_column_inside(8) and
          is_set(transform_left_filter_column_8_4, 7) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(189) := transform_filtering_0_column_inside(8) and
          (is_set(transform_left_filter_column_8_4, 7) or (not is_set(transform_left_filter_column(4, 2), 7)));
      end if;
      transform_right_filter_feature_0_any := (not is_set(transform_right_filter_column(4, 2), 1)) or (not
        is_set(transform_right_filter_column(4, 2), 0));
      if is_set(transform_right_filter_column(5, 1), 0) then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not is_set(transform_right_filter_column(4, 2), 1);
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column(4, 2) mod 4) = 0;
      if is_set(transform_right_filter_column(5, 1), 1) then
        transform_right_filter_feature_0_choices(2) := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choices(2) := is_set(transform_right_filter_column(5, 1), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_value := is_set(transform_right_filter_column(4, 2), 2);
      if transform_right_filter_feature_0_choices(2) then
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column(5, 1), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column(5, 1), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 2 to 5 loop
        transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(4, 2), i + 1);
        if transform_right_filter_feature_0_choices(i + 1) then
          transform_right_filter_feature_0_choices(i + 2) := (not is_set(transform_right_filter_column(5, 1), i + 1))
            or transform_right_filter_feature_0_values(i);
        else
          transform_right_filter_feature_0_choices(i + 2) := (not is_set(transform_right_filter_column(5, 1), i + 1))
            and transform_right_filter_feature_0_values(i);
        end if;
      end loop;
      transform_right_filter_feature_0_all := (not is_set(transform_right_filter_column(4, 2), 7)) and
        transform_filtering_0_column_inside(5);
      if is_set(transform_right_filter_column(5, 1), 7) then
        transform_right_filter_feature_0_choices(8) := transform_filtering_0_column_inside(5);
      else
        transform_right_filter_feature_0_choices(8) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices(7) then
        transform_right_filter_feature_0_choices(9) := is_set(transform_right_filter_column(5, 1), 7) and (not
          is_set(transform_right_filter_column(4, 2), 7)) and transform_filtering_0_column_inside(5);
      else
        transform_right_filter_feature_0_choices(9) := transform_right_filter_feature_0_choices(8);
      end if;
      if is_set(transform_right_filter_column(4, 4), 0) then
        transform_right_filter_feature_0_choices(10) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(10) := not is_set(transform_right_filter_column(4, 2), 1);
      end if;
      if is_set(transform_right_filter_column(4, 4), 1) then
        transform_right_filter_feature_0_choices(11) := transform_right_filter_feature_0_choices(10);
      else
        transform_right_filter_feature_0_choices(11) := is_set(transform_right_filter_column(4, 4), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(11) then
        transform_right_filter_feature_0_choices(12) := (not is_set(transform_right_filter_column(4, 4), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(12) := (not is_set(transform_right_filter_column(4, 4), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 12 to 15 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(4, 4), i - 9))
            or transform_right_filter_feature_0_values(i - 10);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(4, 4), i - 9))
            and transform_right_filter_feature_0_values(i - 10);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(2) := (not is_set(transform_right_filter_column(4, 2), 7)) and
        transform_filtering_0_column_inside(4);
      if is_set(transform_right_filter_column(4, 4), 7) then
        transform_right_filter_feature_0_choices(17) := transform_filtering_0_column_inside(4);
      else
        transform_right_filter_feature_0_choices(17) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices(16) then
        transform_right_filter_feature_0_choices(18) := is_set(transform_right_filter_column(4, 4), 7) and (not
          is_set(transform_right_filter_column(4, 2), 7)) and transform_filtering_0_column_inside(4);
      else
        transform_right_filter_feature_0_choices(18) := transform_right_filter_feature_0_choices(17);
      end if;
      if is_set(transform_right_filter_column(5, 3), 0) then
        transform_right_filter_feature_0_choices(19) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(19) := not is_set(transform_right_filter_column(4, 2), 1);
      end if;
      if is_set(transform_right_filter_column(5, 3), 1) then
        transform_right_filter_feature_0_choices(20) := transform_right_filter_feature_0_choices(19);
      else
        transform_right_filter_feature_0_choices(20) := is_set(transform_right_filter_column(5, 3), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(20) then
        transform_right_filter_feature_0_choices(21) := (not is_set(transform_right_filter_column(5, 3), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(21) := (not is_set(transform_right_filter_column(5, 3), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 21 to 24 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(5, 3), i - 18))
            or transform_right_filter_feature_0_values(i - 19);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(5, 3), i - 18))
            and transform_right_filter_feature_0_values(i - 19);
        end if;
      end loop;
      if is_set(transform_right_filter_column(5, 3), 7) then
        transform_right_filter_feature_0_choices(26) := transform_filtering_0_column_inside(5);
      else
        transform_right_filter_feature_0_choices(26) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices(25) then
        transform_right_filter_feature_0_choices(27) := is_set(transform_right_filter_column(5, 3), 7) and (not
          is_set(transform_right_filter_column(4, 2), 7)) and transform_filtering_0_column_inside(5);
      else
        transform_right_filter_feature_0_choices(27) := transform_right_filter_feature_0_choices(26);
      end if;
      if is_set(transform_right_filter_column(7, 1), 0) then
        transform_right_filter_feature_0_choices(28) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(28) := not is_set(transform_right_filter_column(4, 2), 1);
      end if;
      if is_set(transform_right_filter_column(7, 1), 1) then
        transform_right_filter_feature_0_choices(29) := transform_right_filter_feature_0_choices(28);
      else
        transform_right_filter_feature_0_choices(29) := is_set(transform_right_filter_column(7, 1), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(29) then
        transform_right_filter_feature_0_choices(30) := (not is_set(transform_right_filter_column(7, 1), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(30) := (not is_set(transform_right_filter_column(7, 1), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 30 to 33 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(7, 1), i - 27))
            or transform_right_filter_feature_0_values(i - 28);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(7, 1), i - 27))
            and transform_right_filter_feature_0_values(i - 28);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(3) := (not is_set(transform_right_filter_column(4, 2), 7)) and
        transform_filtering_0_column_inside(7);
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(7, 2 * i + 1), 7) then
          transform_right_filter_feature_0_choices(9 * i + 35) := transform_filtering_0_column_inside(7);
        else
          transform_right_filter_feature_0_choices(9 * i + 35) := transform_right_filter_feature_0_alls(3);
        end if;
        if transform_right_filter_feature_0_choices(9 * i + 34) then
          transform_right_filter_feature_0_choices(9 * i + 36) := is_set(transform_right_filter_column(7, 2 * i + 1),
            7) and (not is_set(transform_right_filter_column(4, 2), 7)) and transform_filtering_0_column_inside(7);
        else
          transform_right_filter_feature_0_choices(9 * i + 36) := transform_right_filter_feature_0_choices(9 * i + 35);
        end if;
        if is_set(transform_right_filter_column(7 - 3 * i, 3 - 3 * i), 0) then
          transform_right_filter_feature_0_choices(9 * i + 37) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(9 * i + 37) := not is_set(transform_right_filter_column(4, 2), 1);
        end if;
        if is_set(transform_right_filter_column(7 - 3 * i, 3 - 3 * i), 1) then
          transform_right_filter_feature_0_choices(9 * i + 38) := transform_right_filter_feature_0_choices(9 * i + 37);
        else
          transform_right_filter_feature_0_choices(9 * i + 38) := is_set(transform_right_filter_column(7 - 3 * i, 3 - 3
            * i), 0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(9 * i + 38) then
          transform_right_filter_feature_0_choices(9 * i + 39) := (not is_set(transform_right_filter_column(7 - 3 * i,
            3 - 3 * i), 2)) and transform_right_filter_feature_0_value;
        else
          transform_right_filter_feature_0_choices(9 * i + 39) := (not is_set(transform_right_filter_column(7 - 3 * i,
            3 - 3 * i), 2)) or transform_right_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(9 * i + j + 36) then
            transform_right_filter_feature_0_choices(9 * i + j + 37) := (not is_set(transform_right_filter_column(7 - 3
              * i, 3 - 3 * i), j)) or transform_right_filter_feature_0_values(j - 1);
          else
            transform_right_filter_feature_0_choices(9 * i + j + 37) := (not is_set(transform_right_filter_column(7 - 3
              * i, 3 - 3 * i), j)) and transform_right_filter_feature_0_values(j - 1);
          end if;
        end loop;
      end loop;
      if is_set(transform_right_filter_column(4, 0), 7) then
        transform_right_filter_feature_0_choices(53) := transform_filtering_0_column_inside(4);
      else
        transform_right_filter_feature_0_choices(53) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices(52) then
        transform_right_filter_feature_0_choices(54) := is_set(transform_right_filter_column(4, 0), 7) and (not
          is_set(transform_right_filter_column(4, 2), 7)) and transform_filtering_0_column_inside(4);
      else
        transform_right_filter_feature_0_choices(54) := transform_right_filter_feature_0_choices(53);
      end if;
      if is_set(transform_right_filter_column(3, 3), 0) then
        transform_right_filter_feature_0_choices(55) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(55) := not is_set(transform_right_filter_column(4, 2), 1);
      end if;
      if is_set(transform_right_filter_column(3, 3), 1) then
        transform_right_filter_feature_0_choices(56) := transform_right_filter_feature_0_choices(55);
      else
        transform_right_filter_feature_0_choices(56) := is_set(transform_right_filter_column(3, 3), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(56) then
        transform_right_filter_feature_0_choices(57) := (not is_set(transform_right_filter_column(3, 3), 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(57) := (not is_set(transform_right_filter_column(3, 3), 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 57 to 60 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(3, 3), i - 54))
            or transform_right_filter_feature_0_values(i - 55);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(3, 3), i - 54))
            and transform_right_filter_feature_0_values(i - 55);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(4) := (not is_set(transform_right_filter_column(4, 2), 7)) and
        transform_filtering_0_column_inside(3);
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(3, 3 - 2 * i), 7) then
          transform_right_filter_feature_0_choices(9 * i + 62) := transform_filtering_0_column_inside(3);
        else
          transform_right_filter_feature_0_choices(9 * i + 62) := transform_right_filter_feature_0_alls(4);
        end if;
        if transform_right_filter_feature_0_choices(9 * i + 61) then
          transform_right_filter_feature_0_choices(9 * i + 63) := is_set(transform_right_filter_column(3, 3 - 2 * i),
            7) and (not is_set(transform_right_filter_column(4, 2), 7)) and transform_filtering_0_column_inside(3);
        else
          transform_right_filter_feature_0_choices(9 * i + 63) := transform_right_filter_feature_0_choices(9 * i + 62);
        end if;
        if is_set(transform_right_filter_column(3 - 2 * i, 2 * i + 1), 0) then
          transform_right_filter_feature_0_choices(9 * i + 64) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(9 * i + 64) := not is_set(transform_right_filter_column(4, 2), 1);
        end if;
        if is_set(transform_right_filter_column(3 - 2 * i, 2 * i + 1), 1) then
          transform_right_filter_feature_0_choices(9 * i + 65) := transform_right_filter_feature_0_choices(9 * i + 64);
        else
          transform_right_filter_feature_0_choices(9 * i + 65) := is_set(transform_right_filter_column(3 - 2 * i, 2 * i
            + 1), 0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(9 * i + 65) then
          transform_right_filter_feature_0_choices(9 * i + 66) := (not is_set(transform_right_filter_column(3 - 2 * i,
            2 * i + 1), 2)) and transform_right_filter_feature_0_value;
        else
          transform_right_filter_feature_0_choices(9 * i + 66) := (not is_set(transform_right_filter_column(3 - 2 * i,
            2 * i + 1), 2)) or transform_right_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(9 * i + j + 63) then
            transform_right_filter_feature_0_choices(9 * i + j + 64) := (not is_set(transform_right_filter_column(3 - 2
              * i, 2 * i + 1), j)) or transform_right_filter_feature_0_values(j - 1);
          else
            transform_right_filter_feature_0_choices(9 * i + j + 64) := (not is_set(transform_right_filter_column(3 - 2
              * i, 2 * i + 1), j)) and transform_right_filter_feature_0_values(j - 1);
          end if;
        end loop;
      end loop;
      transform_right_filter_feature_0_alls(5) := (not is_set(transform_right_filter_column(4, 2), 7)) and
        transform_filtering_0_column_inside(1);
      for i in 1 to 2 loop
        if is_set(transform_right_filter_column(1, 5 - 2 * i), 7) then
          transform_right_filter_feature_0_choices(9 * i + 71) := transform_filtering_0_column_inside(1);
        else
          transform_right_filter_feature_0_choices(9 * i + 71) := transform_right_filter_feature_0_alls(5);
        end if;
        if transform_right_filter_feature_0_choices(9 * i + 70) then
          transform_right_filter_feature_0_choices(9 * i + 72) := is_set(transform_right_filter_column(1, 5 - 2 * i),
            7) and (not is_set(transform_right_filter_column(4, 2), 7)) and transform_filtering_0_column_inside(1);
        else
          transform_right_filter_feature_0_choices(9 * i + 72) := transform_right_filter_feature_0_choices(9 * i + 71);
        end if;
        if is_set(transform_right_filter_column(2 - i, i), 0) then
          transform_right_filter_feature_0_choices(9 * i + 73) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(9 * i + 73) := not is_set(transform_right_filter_column(4, 2), 1);
        end if;
        if is_set(transform_right_filter_column(2 - i, i), 1) then
          transform_right_filter_feature_0_choices(9 * i + 74) := transform_right_filter_feature_0_choices(9 * i + 73);
        else
          transform_right_filter_feature_0_choices(9 * i + 74) := is_set(transform_right_filter_column(2 - i, i), 0)
            and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(9 * i + 74) then
          transform_right_filter_feature_0_choices(9 * i + 75) := (not is_set(transform_right_filter_column(2 - i, i),
            2)) and transform_right_filter_feature_0_value;
        else
          transform_right_filter_feature_0_choices(9 * i + 75) := (not is_set(transform_right_filter_column(2 - i, i),
            2)) or transform_right_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(9 * i + j + 72) then
            transform_right_filter_feature_0_choices(9 * i + j + 73) := (not is_set(transform_right_filter_column(2 -
              i, i), j)) or transform_right_filter_feature_0_values(j - 1);
          else
            transform_right_filter_feature_0_choices(9 * i + j + 73) := (not is_set(transform_right_filter_column(2 -
              i, i), j)) and transform_right_filter_feature_0_values(j - 1);
          end if;
        end loop;
      end loop;
      for i in 6 to 7 loop
        transform_right_filter_feature_0_alls(i) := transform_filtering_0_column_inside(2 * i - 12) and (not
          is_set(transform_right_filter_column(4, 2), 7));
        for j in 0 to 1 loop
          if is_set(transform_right_filter_column(2 * i - 12, 2 - 2 * j), 7) then
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 64) := transform_filtering_0_column_inside(2 * i
              - 12);
          else
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 64) := transform_right_filter_feature_0_alls(i);
          end if;
          if transform_right_filter_feature_0_choices(27 * i + 9 * j - 65) then
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 63) := is_set(transform_right_filter_column(2 * i
              - 12, 2 - 2 * j), 7) and transform_filtering_0_column_inside(2 * i - 12) and (not
              is_set(transform_right_filter_column(4, 2), 7));
          else
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 63) :=
              transform_right_filter_feature_0_choices(27 * i + 9 * j - 64);
          end if;
          if is_set(transform_right_filter_column(2 * i - 12, 4 * j), 0) then
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 62) := transform_right_filter_feature_0_any;
          else
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 62) := not
              is_set(transform_right_filter_column(4, 2), 1);
          end if;
          if is_set(transform_right_filter_column(2 * i - 12, 4 * j), 1) then
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 61) :=
              transform_right_filter_feature_0_choices(27 * i + 9 * j - 62);
          else
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 61) := is_set(transform_right_filter_column(2 * i
              - 12, 4 * j), 0) and transform_right_filter_feature_0_is_equal;
          end if;
          if transform_right_filter_feature_0_choices(27 * i + 9 * j - 61) then
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 60) := (not
              is_set(transform_right_filter_column(2 * i - 12, 4 * j), 2)) and transform_right_filter_feature_0_value;
          else
            transform_right_filter_feature_0_choices(27 * i + 9 * j - 60) := (not
              is_set(transform_right_filter_column(2 * i - 12, 4 * j), 2)) or transform_right_filter_feature_0_value;
          end if;
          for k in 3 to 6 loop
            if transform_right_filter_feature_0_choices(27 * i + 9 * j + k - 63) then
              transform_right_filter_feature_0_choices(27 * i + 9 * j + k - 62) := (not
                is_set(transform_right_filter_column(2 * i - 12, 4 * j), k)) or
                transform_right_filter_feature_0_values(k - 1);
            else
              transform_right_filter_feature_0_choices(27 * i + 9 * j + k - 62) := (not
                is_set(transform_right_filter_column(2 * i - 12, 4 * j), k)) and
                transform_right_filter_feature_0_values(k - 1);
            end if;
          end loop;
        end loop;
        if is_set(transform_right_filter_column(2 * i - 12, 4), 7) then
          transform_right_filter_feature_0_choices(27 * i - 46) := transform_filtering_0_column_inside(2 * i - 12);
        else
          transform_right_filter_feature_0_choices(27 * i - 46) := transform_right_filter_feature_0_alls(i);
        end if;
        if transform_right_filter_feature_0_choices(27 * i - 47) then
          transform_right_filter_feature_0_choices(27 * i - 45) := is_set(transform_right_filter_column(2 * i - 12, 4),
            7) and transform_filtering_0_column_inside(2 * i - 12) and (not is_set(transform_right_filter_column(4, 2),
            7));
        else
          transform_right_filter_feature_0_choices(27 * i - 45) := transform_right_filter_feature_0_choices(27 * i -
            46);
        end if;
        if is_set(transform_right_filter_column(4 * i - 22, 2), 0) then
          transform_right_filter_feature_0_choices(27 * i - 44) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(27 * i - 44) := not is_set(transform_right_filter_column(4, 2), 1);
        end if;
        if is_set(transform_right_filter_column(4 * i - 22, 2), 1) then
          transform_right_filter_feature_0_choices(27 * i - 43) := transform_right_filter_feature_0_choices(27 * i -
            44);
        else
          transform_right_filter_feature_0_choices(27 * i - 43) := is_set(transform_right_filter_column(4 * i - 22, 2),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(27 * i - 43) then
          transform_right_filter_feature_0_choices(27 * i - 42) := (not is_set(transform_right_filter_column(4 * i -
            22, 2), 2)) and transform_right_filter_feature_0_value;
        else
          transform_right_filter_feature_0_choices(27 * i - 42) := (not is_set(transform_right_filter_column(4 * i -
            22, 2), 2)) or transform_right_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(27 * i + j - 45) then
            transform_right_filter_feature_0_choices(27 * i + j - 44) := (not is_set(transform_right_filter_column(4 *
              i - 22, 2), j)) or transform_right_filter_feature_0_values(j - 1);
          else
            transform_right_filter_feature_0_choices(27 * i + j - 44) := (not is_set(transform_right_filter_column(4 *
              i - 22, 2), j)) and transform_right_filter_feature_0_values(j - 1);
          end if;
        end loop;
      end loop;
      transform_right_filter_feature_0_alls(8) := transform_filtering_0_column_inside(6) and (not
        is_set(transform_right_filter_column(4, 2), 7));
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(6, 2 - 2 * i), 7) then
          transform_right_filter_feature_0_choices(9 * i + 152) := transform_filtering_0_column_inside(6);
        else
          transform_right_filter_feature_0_choices(9 * i + 152) := transform_right_filter_feature_0_alls(8);
        end if;
        if transform_right_filter_feature_0_choices(9 * i + 151) then
          transform_right_filter_feature_0_choices(9 * i + 153) := is_set(transform_right_filter_column(6, 2 - 2 * i),
            7) and transform_filtering_0_column_inside(6) and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(9 * i + 153) := transform_right_filter_feature_0_choices(9 * i +
            152);
        end if;
        if is_set(transform_right_filter_column(6, 4 * i), 0) then
          transform_right_filter_feature_0_choices(9 * i + 154) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(9 * i + 154) := not is_set(transform_right_filter_column(4, 2), 1);
        end if;
        if is_set(transform_right_filter_column(6, 4 * i), 1) then
          transform_right_filter_feature_0_choices(9 * i + 155) := transform_right_filter_feature_0_choices(9 * i +
            154);
        else
          transform_right_filter_feature_0_choices(9 * i + 155) := is_set(transform_right_filter_column(6, 4 * i), 0)
            and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(9 * i + 155) then
          transform_right_filter_feature_0_choices(9 * i + 156) := (not is_set(transform_right_filter_column(6, 4 * i),
            2)) and transform_right_filter_feature_0_value;
        else
          transform_right_filter_feature_0_choices(9 * i + 156) := (not is_set(transform_right_filter_column(6, 4 * i),
            2)) or transform_right_filter_feature_0_value;
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(9 * i + j + 153) then
            transform_right_filter_feature_0_choices(9 * i + j + 154) := (not is_set(transform_right_filter_column(6, 4
              * i), j)) or transform_right_filter_feature_0_values(j - 1);
          else
            transform_right_filter_feature_0_choices(9 * i + j + 154) := (not is_set(transform_right_filter_column(6, 4
              * i), j)) and transform_right_filter_feature_0_values(j - 1);
          end if;
        end loop;
      end loop;
      if is_set(transform_right_filter_column(6, 4), 7) then
        transform_right_filter_feature_0_choices(170) := transform_filtering_0_column_inside(6);
      else
        transform_right_filter_feature_0_choices(170) := transform_right_filter_feature_0_alls(8);
      end if;
      if transform_right_filter_feature_0_choices(169) then
        transform_right_filter_feature_0_choices(171) := is_set(transform_right_filter_column(6, 4), 7) and
          transform_filtering_0_column_inside(6) and (not is_set(transform_right_filter_column(4, 2), 7));
      else
        transform_right_filter_feature_0_choices(171) := transform_right_filter_feature_0_choices(170);
      end if;
      if is_set(transform_right_filter_column_8_2, 0) then
        transform_right_filter_feature_0_choices(172) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(172) := not is_set(transform_right_filter_column(4, 2), 1);
      end if;
      if is_set(transform_right_filter_column_8_2, 1) then
        transform_right_filter_feature_0_choices(173) := transform_right_filter_feature_0_choices(172);
      else
        transform_right_filter_feature_0_choices(173) := is_set(transform_right_filter_column_8_2, 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(173) then
        transform_right_filter_feature_0_choices(174) := (not is_set(transform_right_filter_column_8_2, 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(174) := (not is_set(transform_right_filter_column_8_2, 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 174 to 177 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_8_2, i - 171))
            or transform_right_filter_feature_0_values(i - 172);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_8_2, i - 171))
            and transform_right_filter_feature_0_values(i - 172);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(9) := transform_filtering_0_column_inside(8) and (not
        is_set(transform_right_filter_column(4, 2), 7));
      if is_set(transform_right_filter_column_8_2, 7) then
        transform_right_filter_feature_0_choices(179) := transform_filtering_0_column_inside(8);
      else
        transform_right_filter_feature_0_choices(179) := transform_right_filter_feature_0_alls(9);
      end if;
      if transform_right_filter_feature_0_choices(178) then
        transform_right_filter_feature_0_choices(180) := is_set(transform_right_filter_column_8_2, 7) and
          transform_filtering_0_column_inside(8) and (not is_set(transform_right_filter_column(4, 2), 7));
      else
        transform_right_filter_feature_0_choices(180) := transform_right_filter_feature_0_choices(179);
      end if;
      if is_set(transform_right_filter_column_8_0, 0) then
        transform_right_filter_feature_0_choices(181) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(181) := not is_set(transform_right_filter_column(4, 2), 1);
      end if;
      if is_set(transform_right_filter_column_8_0, 1) then
        transform_right_filter_feature_0_choices(182) := transform_right_filter_feature_0_choices(181);
      else
        transform_right_filter_feature_0_choices(182) := is_set(transform_right_filter_column_8_0, 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(182) then
        transform_right_filter_feature_0_choices(183) := (not is_set(transform_right_filter_column_8_0, 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(183) := (not is_set(transform_right_filter_column_8_0, 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 183 to 186 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_8_0, i - 180))
            or transform_right_filter_feature_0_values(i - 181);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_8_0, i - 180))
            and transform_right_filter_feature_0_values(i - 181);
        end if;
      end loop;
      if is_set(transform_right_filter_column_8_0, 7) then
        transform_right_filter_feature_0_choices(188) := transform_filtering_0_column_inside(8);
      else
        transform_right_filter_feature_0_choices(188) := transform_right_filter_feature_0_alls(9);
      end if;
      if transform_right_filter_feature_0_choices(187) then
        transform_right_filter_feature_0_choices(189) := is_set(transform_right_filter_column_8_0, 7) and
          transform_filtering_0_column_inside(8) and (not is_set(transform_right_filter_column(4, 2), 7));
      else
        transform_right_filter_feature_0_choices(189) := transform_right_filter_feature_0_choices(188);
      end if;
      if is_set(transform_right_filter_column_8_4, 0) then
        transform_right_filter_feature_0_choices(190) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(190) := not is_set(transform_right_filter_column(4, 2), 1);
      end if;
      if is_set(transform_right_filter_column_8_4, 1) then
        transform_right_filter_feature_0_choices(191) := transform_right_filter_feature_0_choices(190);
      else
        transform_right_filter_feature_0_choices(191) := is_set(transform_right_filter_column_8_4, 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(191) then
        transform_right_filter_feature_0_choices(192) := (not is_set(transform_right_filter_column_8_4, 2)) and
          transform_right_filter_feature_0_value;
      else
        transform_right_filter_feature_0_choices(192) := (not is_set(transform_right_filter_column_8_4, 2)) or
          transform_right_filter_feature_0_value;
      end if;
      for i in 192 to 195 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_8_4, i - 189))
            or transform_right_filter_feature_0_values(i - 190);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_8_4, i - 189))
            and transform_right_filter_feature_0_values(i - 190);
        end if;
      end loop;
      if is_set(transform_right_filter_column_8_4, 7) then
        transform_right_filter_feature_0_choices(197) := transform_filtering_0_column_inside(8);
      else
        transform_right_filter_feature_0_choices(197) := transform_right_filter_feature_0_alls(9);
      end if;
      if transform_right_filter_feature_0_choices(196) then
        transform_right_filter_feature_0_choices(198) := is_set(transform_right_filter_column_8_4, 7) and
          transform_filtering_0_column_inside(8) and (not is_set(transform_right_filter_column(4, 2), 7));
      else
        transform_right_filter_feature_0_choices(198) := transform_right_filter_feature_0_choices(197);
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
      transform_read_row_inside(0) <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
        (transform_counter_group mod 4)) < 720;
      transform_read_row_inside(1) <= (transform_counter_group >= 3) and (transform_counter_group < 723);
      transform_read_row_inside(2) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 720;
      transform_read_row_inside(3) <= (transform_counter_group >= 1) and (transform_counter_group < 721);
      transform_read_row_inside(4) <= transform_counter_group < 720;
      transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
      transform_read_column_inside(1) <= (transform_counter_column = 0) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside(2) <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside(3) <= transform_counter_column /= 3;
      for i in 4 to 8 loop
        transform_read_column_inside(i) <= (transform_counter_column < i) /= transform_read_column_inside_0_is_less;
      end loop;
      transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      for i in 0 to 4 loop
        transform_ready_row_inside(i) <= transform_read_row_inside(i);
      end loop;
      for i in 0 to 8 loop
        transform_ready_column_inside(i) <= transform_read_column_inside(i);
      end loop;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column(0) <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
      transform_left_column(1) <= to_integer(transform_left_rows_ready_words_0(15 downto 8));
      transform_left_column(2) <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
      transform_left_column(3) <= to_integer(transform_left_rows_ready_words_0(31 downto 24));
      transform_left_column(4) <= transform_left_rows_ready_newest_0;
      transform_right_column(0) <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column(1) <= to_integer(transform_right_rows_ready_words_0(15 downto 8));
      transform_right_column(2) <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column(3) <= to_integer(transform_right_rows_ready_words_0(31 downto 24));
      transform_right_column(4) <= transform_right_rows_ready_newest_0;
      for i in 0 to 4 loop
        transform_columns_row_inside(i) <= transform_ready_row_inside(i);
      end loop;
      for i in 0 to 8 loop
        transform_columns_column_inside(i) <= transform_ready_column_inside(i);
      end loop;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_feature_0 <= (as_number(transform_left_filter_feature_0_choices(8)) * 4096) +
        (as_number(transform_left_filter_feature_0_choices(17)) * 2048) +
        (as_number(transform_left_filter_feature_0_choices(26)) * 8192) +
        (as_number(transform_left_filter_feature_0_choices(34)) * 131072) +
        (as_number(transform_left_filter_feature_0_choices(43)) * 262144) +
        (as_number(transform_left_filter_feature_0_choices(51)) * 1024) +
        (as_number(transform_left_filter_feature_0_choices(60)) * 512) +
        (as_number(transform_left_filter_feature_0_choices(68)) * 256) +
        (as_number(transform_left_filter_feature_0_choices(77)) * 16) +
        (as_number(transform_left_filter_feature_0_choices(85)) * 8) +
        (as_number(transform_left_filter_feature_0_choices(94)) * 2) +
        as_number(transform_left_filter_feature_0_choices(103)) +
        (as_number(transform_left_filter_feature_0_choices(111)) * 4) +
        (as_number(transform_left_filter_feature_0_choices(120)) * 64) +
        (as_number(transform_left_filter_feature_0_choices(129)) * 32) +
        (as_number(transform_left_filter_feature_0_choices(137)) * 128) +
        (as_number(transform_left_filter_feature_0_choices(146)) * 32768) +
        (as_number(transform_left_filter_feature_0_choices(155)) * 16384) +
        (as_number(transform_left_filter_feature_0_choices(163)) * 65536) +
        (as_number(transform_left_filter_feature_0_choices(172)) * 1048576) +
        (as_number(transform_left_filter_feature_0_choices(181)) * 524288) +
        (as_number(transform_left_filter_feature_0_choices(189)) * 2097152);
      transform_right_filter_feature_0 <= (as_number(transform_right_filter_feature_0_choices(9)) * 4096) +
        (as_number(transform_right_filter_feature_0_choices(18)) * 2048) +
        (as_number(transform_right_filter_feature_0_choices(27)) * 8192) +
        (as_number(transform_right_filter_feature_0_choices(36)) * 131072) +
        (as_number(transform_right_filter_feature_0_choices(45)) * 262144) +
        (as_number(transform_right_filter_feature_0_choices(54)) * 1024) +
        (as_number(transform_right_filter_feature_0_choices(63)) * 512) +
        (as_number(transform_right_filter_feature_0_choices(72)) * 256) +
        (as_number(transform_right_filter_feature_0_choices(81)) * 16) +
        (as_number(transform_right_filter_feature_0_choices(90)) * 8) +
        (as_number(transform_right_filter_feature_0_choices(99)) * 2) +
        as_number(transform_right_filter_feature_0_choices(108)) +
        (as_number(transform_right_filter_feature_0_choices(117)) * 4) +
        (as_number(transform_right_filter_feature_0_choices(126)) * 64) +
        (as_number(transform_right_filter_feature_0_choices(135)) * 32) +
        (as_number(transform_right_filter_feature_0_choices(144)) * 128) +
        (as_number(transform_right_filter_feature_0_choices(153)) * 32768) +
        (as_number(transform_right_filter_feature_0_choices(162)) * 16384) +
        (as_number(transform_right_filter_feature_0_choices(171)) * 65536) +
        (as_number(transform_right_filter_feature_0_choices(180)) * 1048576) +
        (as_number(transform_right_filter_feature_0_choices(189)) * 524288) +
        (as_number(transform_right_filter_feature_0_choices(198)) * 2097152);
      for i in 0 to 8 loop
        transform_filtering_0_column_inside(i) <= transform_columns_column_inside(i);
      end loop;
      transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
      transform_filtering_valid(0) <= transform_columns_valid;
      transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
      transform_filtering_valid(1) <= transform_filtering_valid(0);
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 16;
      else
        transform_counter_group <= transform_counter_group_choices(3);
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := (transform_counter_group /= 721) and transform_counter_next_frame;
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
          transform_counter_column <= (transform_counter_column + 1) mod 2048;
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
        for i in 0 to 2 loop
          for j in 0 to 4 loop
            transform_left_filter_column(2 * i + 1, j) <= transform_left_filter_column(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            transform_left_filter_column(2 * i + 2, j) <= transform_left_filter_column(2 * i + 1, j);
          end loop;
        end loop;
        for i in 0 to 4 loop
          transform_left_filter_column(7, i) <= transform_left_filter_column(6, i);
        end loop;
        transform_left_filter_column_8_0 <= transform_left_filter_column(7, 0);
        transform_left_filter_column_8_2 <= transform_left_filter_column(7, 2);
        transform_left_filter_column_8_4 <= transform_left_filter_column(7, 4);
        for i in 0 to 2 loop
          for j in 0 to 4 loop
            transform_right_filter_column(2 * i + 1, j) <= transform_right_filter_column(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            transform_right_filter_column(2 * i + 2, j) <= transform_right_filter_column(2 * i + 1, j);
          end loop;
        end loop;
        for i in 0 to 4 loop
          transform_right_filter_column(7, i) <= transform_right_filter_column(6, i);
        end loop;
        transform_right_filter_column_8_0 <= transform_right_filter_column(7, 0);
        transform_right_filter_column_8_2 <= transform_right_filter_column(7, 2);
        transform_right_filter_column_8_4 <= transform_right_filter_column(7, 4);
        for i in 0 to 4 loop
          if transform_columns_row_inside(i) then
            transform_left_filter_column(0, i) <= transform_left_column(i);
            transform_right_filter_column(0, i) <= transform_right_column(i);
          else
            transform_left_filter_column(0, i) <= 0;
            transform_right_filter_column(0, i) <= 0;
          end if;
        end loop;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 1279;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_valid(1);
      if transform_filtering_start_of_frame(1) and transform_filtering_valid(1) then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 720) and
          raster_place_group_is_equal and transform_filtering_valid(1)))) mod 1024;
      end if;
      if transform_filtering_valid(1) then
        if raster_place_group_is_equal or transform_filtering_start_of_frame(1) then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 2048;
        end if;
      end if;
      -- delay
      delay_tag_first_cost_is_equal := raster_place_column = 63;
      delay_tag_map_column_is_not_less := raster_place_column >= 63;
      delay_tag_map_column_is_less := raster_place_column < 1280;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= raster_place_column < 63;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= (raster_place_group < 720) and delay_tag_map_column_is_not_less and
        delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= (raster_place_group = 0) and delay_tag_first_cost_is_equal;
      delay_tag_end_of_line <= raster_place_group_is_equal;
      -- rows
      rows_search_0 <= delay_delayed_0;
      rows_reference_0 <= delay_ahead_0;
      rows_tag_valid <= delay_tag_valid;
      rows_tag_border_column <= delay_tag_border_column;
      rows_tag_first_cost <= delay_tag_first_cost;
      rows_tag_map_column <= delay_tag_map_column;
      rows_tag_output_column <= delay_tag_output_column;
      rows_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_tag_end_of_line <= delay_tag_end_of_line;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0(0) <= rows_search_0;
        for i in 1 to 15 loop
          slice0shift_search_0(i) <= slice0shift_search_0(i - 1);
        end loop;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_search_out_0 <= slice0shift_search_0(15);
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_pixels_first_0_0_count_value(0) := is_set(slice0shift_reference_0, 2);
      slice0cost_pixels_first_0_0_count_value_2(0) := is_set(slice0shift_reference_0, 1);
      slice0cost_pixels_first_0_0_count_value(1) := is_set(slice0shift_reference_0, 3);
      slice0cost_pixels_first_0_0_count_value_2(1) := is_set(slice0shift_reference_0, 5);
      slice0cost_pixels_first_0_0_count_1_value_3 := is_set(slice0shift_reference_0, 4);
      slice0cost_pixels_first_0_0_count_value(2) := is_set(slice0shift_reference_0, 8);
      slice0cost_pixels_first_0_0_count_value_2(2) := is_set(slice0shift_reference_0, 6);
      for i in 3 to 6 loop
        slice0cost_pixels_first_0_0_count_value(i) := is_set(slice0shift_reference_0, 3 * i);
        slice0cost_pixels_first_0_0_count_value_2(i) := is_set(slice0shift_reference_0, 3 * i + 2);
        slice0cost_pixels_first_0_0_count_value_3(i) := is_set(slice0shift_reference_0, 3 * i + 1);
      end loop;
      slice0cost_pixels_first_0_count(0, 0) <= as_number((is_set(slice0shift_search_0(0), 0) /=
        is_set(slice0shift_reference_0, 0))) + as_number((slice0cost_pixels_first_0_0_count_value(0) /=
        is_set(slice0shift_search_0(0), 2))) + as_number((slice0cost_pixels_first_0_0_count_value_2(0) /=
        is_set(slice0shift_search_0(0), 1)));
      slice0cost_pixels_first_0_count(0, 1) <= as_number((slice0cost_pixels_first_0_0_count_value(1) /=
        is_set(slice0shift_search_0(0), 3))) + as_number((slice0cost_pixels_first_0_0_count_value_2(1) /=
        is_set(slice0shift_search_0(0), 5))) + as_number((slice0cost_pixels_first_0_0_count_1_value_3 /=
        is_set(slice0shift_search_0(0), 4)));
      slice0cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned((slice0shift_search_0(0) mod 256), 8)) xor
        (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) +
        as_number((slice0cost_pixels_first_0_0_count_value(2) /= is_set(slice0shift_search_0(0), 8))) +
        as_number((slice0cost_pixels_first_0_0_count_value_2(2) /= is_set(slice0shift_search_0(0), 6)));
      for i in 3 to 6 loop
        slice0cost_pixels_first_0_count(0, i) <= as_number((slice0cost_pixels_first_0_0_count_value(i) /=
          is_set(slice0shift_search_0(0), 3 * i))) + as_number((slice0cost_pixels_first_0_0_count_value_2(i) /=
          is_set(slice0shift_search_0(0), 3 * i + 2))) + as_number((slice0cost_pixels_first_0_0_count_value_3(i) /=
          is_set(slice0shift_search_0(0), 3 * i + 1)));
      end loop;
      slice0cost_pixels_first_0_count_7(0) <= is_set(slice0shift_reference_0, 21) /= is_set(slice0shift_search_0(0),
        21);
      for i in 1 to 15 loop
        slice0cost_pixels_first_0_count(i, 0) <= as_number((is_set(slice0shift_search_0(i), 0) /=
          is_set(slice0shift_reference_0, 0))) + as_number((is_set(slice0shift_search_0(i), 2) /=
          slice0cost_pixels_first_0_0_count_value(0))) + as_number((is_set(slice0shift_search_0(i), 1) /=
          slice0cost_pixels_first_0_0_count_value_2(0)));
        slice0cost_pixels_first_0_count(i, 1) <= as_number((is_set(slice0shift_search_0(i), 3) /=
          slice0cost_pixels_first_0_0_count_value(1))) + as_number((is_set(slice0shift_search_0(i), 5) /=
          slice0cost_pixels_first_0_0_count_value_2(1))) + as_number((is_set(slice0shift_search_0(i), 4) /=
          slice0cost_pixels_first_0_0_count_1_value_3));
        slice0cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned((slice0shift_search_0(i) mod 256), 8)) xor
          (to_unsigned((slice0shift_reference_0 mod 256), 8)))) / 128) + as_number((is_set(slice0shift_search_0(i), 8)
          /= slice0cost_pixels_first_0_0_count_value(2))) + as_number((is_set(slice0shift_search_0(i), 6) /=
          slice0cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 6 loop
          slice0cost_pixels_first_0_count(i, j) <= as_number((is_set(slice0shift_search_0(i), 3 * j) /=
            slice0cost_pixels_first_0_0_count_value(j))) + as_number((is_set(slice0shift_search_0(i), 3 * j + 2) /=
            slice0cost_pixels_first_0_0_count_value_2(j))) + as_number((is_set(slice0shift_search_0(i), 3 * j + 1) /=
            slice0cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice0cost_pixels_first_0_count_7(i) <= is_set(slice0shift_search_0(i), 21) /= is_set(slice0shift_reference_0,
          21);
      end loop;
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_pixels_cost_0(i) <= slice0cost_pixels_first_0_count(i, 0) + slice0cost_pixels_first_0_count(i, 2) +
          slice0cost_pixels_first_0_count(i, 3) + slice0cost_pixels_first_0_count(i, 5) +
          slice0cost_pixels_first_0_count(i, 6) + slice0cost_pixels_first_0_count(i, 4) +
          as_number(slice0cost_pixels_first_0_count_7(i)) + slice0cost_pixels_first_0_count(i, 1);
      end loop;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_single_0(i) <= slice0cost_pixels_cost_0(i);
      end loop;
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
      -- slice0window
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_border_column <= slice0cost_tag_border_column;
      slice0window_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_tag_map_column <= slice0cost_tag_map_column;
      slice0window_tag_output_column <= slice0cost_tag_output_column;
      slice0window_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_tag_end_of_line <= slice0cost_tag_end_of_line;
      -- slice0
      for i in 1 to 3 loop
        for j in 0 to 15 loop
          slice0_held(i, j) <= slice0_held(i - 1, j);
        end loop;
      end loop;
      slice0_tag_valid(0) <= slice0window_tag_valid;
      slice0_tag_0_border_column <= slice0window_tag_border_column;
      slice0_tag_first_cost(0) <= slice0window_tag_first_cost;
      slice0_tag_map_column(0) <= slice0window_tag_map_column;
      slice0_tag_output_column(0) <= slice0window_tag_output_column;
      slice0_tag_start_of_frame(0) <= slice0window_tag_start_of_frame;
      slice0_tag_end_of_line(0) <= slice0window_tag_end_of_line;
      for i in 1 to 3 loop
        slice0_tag_valid(i) <= slice0_tag_valid(i - 1);
        slice0_tag_first_cost(i) <= slice0_tag_first_cost(i - 1);
        slice0_tag_map_column(i) <= slice0_tag_map_column(i - 1);
        slice0_tag_output_column(i) <= slice0_tag_output_column(i - 1);
        slice0_tag_start_of_frame(i) <= slice0_tag_start_of_frame(i - 1);
        slice0_tag_end_of_line(i) <= slice0_tag_end_of_line(i - 1);
      end loop;
      for i in 0 to 15 loop
        if is_set(others_from_19(145 - 2 * i), 4) or (((others_from_19(145 - 2 * i) / 4) mod 4) = 3) then
          slice0_held(0, i) <= 5;
        else
          slice0_held(0, i) <= others_from_19(145 - 2 * i) / 2;
        end if;
      end loop;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0(0) <= slice0shift_search_out_0;
        for i in 1 to 15 loop
          slice1shift_search_0(i) <= slice1shift_search_0(i - 1);
        end loop;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_search_out_0 <= slice1shift_search_0(15);
      -- slice1cost
      slice1cost_pixels_first_0_0_count_value(0) := is_set(slice1shift_reference_0, 2);
      slice1cost_pixels_first_0_0_count_value_2(0) := is_set(slice1shift_reference_0, 1);
      slice1cost_pixels_first_0_0_count_value(1) := is_set(slice1shift_reference_0, 3);
      slice1cost_pixels_first_0_0_count_value_2(1) := is_set(slice1shift_reference_0, 5);
      slice1cost_pixels_first_0_0_count_1_value_3 := is_set(slice1shift_reference_0, 4);
      slice1cost_pixels_first_0_0_count_value(2) := is_set(slice1shift_reference_0, 8);
      slice1cost_pixels_first_0_0_count_value_2(2) := is_set(slice1shift_reference_0, 6);
      for i in 3 to 6 loop
        slice1cost_pixels_first_0_0_count_value(i) := is_set(slice1shift_reference_0, 3 * i);
        slice1cost_pixels_first_0_0_count_value_2(i) := is_set(slice1shift_reference_0, 3 * i + 2);
        slice1cost_pixels_first_0_0_count_value_3(i) := is_set(slice1shift_reference_0, 3 * i + 1);
      end loop;
      slice1cost_pixels_first_0_count(0, 0) <= as_number((is_set(slice1shift_search_0(0), 0) /=
        is_set(slice1shift_reference_0, 0))) + as_number((slice1cost_pixels_first_0_0_count_value(0) /=
        is_set(slice1shift_search_0(0), 2))) + as_number((slice1cost_pixels_first_0_0_count_value_2(0) /=
        is_set(slice1shift_search_0(0), 1)));
      slice1cost_pixels_first_0_count(0, 1) <= as_number((slice1cost_pixels_first_0_0_count_value(1) /=
        is_set(slice1shift_search_0(0), 3))) + as_number((slice1cost_pixels_first_0_0_count_value_2(1) /=
        is_set(slice1shift_search_0(0), 5))) + as_number((slice1cost_pixels_first_0_0_count_1_value_3 /=
        is_set(slice1shift_search_0(0), 4)));
      slice1cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned((slice1shift_search_0(0) mod 256), 8)) xor
        (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) +
        as_number((slice1cost_pixels_first_0_0_count_value(2) /= is_set(slice1shift_search_0(0), 8))) +
        as_number((slice1cost_pixels_first_0_0_count_value_2(2) /= is_set(slice1shift_search_0(0), 6)));
      for i in 3 to 6 loop
        slice1cost_pixels_first_0_count(0, i) <= as_number((slice1cost_pixels_first_0_0_count_value(i) /=
          is_set(slice1shift_search_0(0), 3 * i))) + as_number((slice1cost_pixels_first_0_0_count_value_2(i) /=
          is_set(slice1shift_search_0(0), 3 * i + 2))) + as_number((slice1cost_pixels_first_0_0_count_value_3(i) /=
          is_set(slice1shift_search_0(0), 3 * i + 1)));
      end loop;
      slice1cost_pixels_first_0_count_7(0) <= is_set(slice1shift_reference_0, 21) /= is_set(slice1shift_search_0(0),
        21);
      for i in 1 to 15 loop
        slice1cost_pixels_first_0_count(i, 0) <= as_number((is_set(slice1shift_search_0(i), 0) /=
          is_set(slice1shift_reference_0, 0))) + as_number((is_set(slice1shift_search_0(i), 2) /=
          slice1cost_pixels_first_0_0_count_value(0))) + as_number((is_set(slice1shift_search_0(i), 1) /=
          slice1cost_pixels_first_0_0_count_value_2(0)));
        slice1cost_pixels_first_0_count(i, 1) <= as_number((is_set(slice1shift_search_0(i), 3) /=
          slice1cost_pixels_first_0_0_count_value(1))) + as_number((is_set(slice1shift_search_0(i), 5) /=
          slice1cost_pixels_first_0_0_count_value_2(1))) + as_number((is_set(slice1shift_search_0(i), 4) /=
          slice1cost_pixels_first_0_0_count_1_value_3));
        slice1cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned((slice1shift_search_0(i) mod 256), 8)) xor
          (to_unsigned((slice1shift_reference_0 mod 256), 8)))) / 128) + as_number((is_set(slice1shift_search_0(i), 8)
          /= slice1cost_pixels_first_0_0_count_value(2))) + as_number((is_set(slice1shift_search_0(i), 6) /=
          slice1cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 6 loop
          slice1cost_pixels_first_0_count(i, j) <= as_number((is_set(slice1shift_search_0(i), 3 * j) /=
            slice1cost_pixels_first_0_0_count_value(j))) + as_number((is_set(slice1shift_search_0(i), 3 * j + 2) /=
            slice1cost_pixels_first_0_0_count_value_2(j))) + as_number((is_set(slice1shift_search_0(i), 3 * j + 1) /=
            slice1cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice1cost_pixels_first_0_count_7(i) <= is_set(slice1shift_search_0(i), 21) /= is_set(slice1shift_reference_0,
          21);
      end loop;
      for i in 0 to 15 loop
        slice1cost_pixels_cost_0(i) <= slice1cost_pixels_first_0_count(i, 0) + slice1cost_pixels_first_0_count(i, 2) +
          slice1cost_pixels_first_0_count(i, 3) + slice1cost_pixels_first_0_count(i, 5) +
          slice1cost_pixels_first_0_count(i, 6) + slice1cost_pixels_first_0_count(i, 4) +
          as_number(slice1cost_pixels_first_0_count_7(i)) + slice1cost_pixels_first_0_count(i, 1);
      end loop;
      for i in 0 to 15 loop
        slice1cost_single_0(i) <= slice1cost_pixels_cost_0(i);
      end loop;
      -- slice1
      for i in 0 to 15 loop
        slice1_held(1, i) <= slice1_held(0, i);
      end loop;
      for i in 0 to 15 loop
        slice1_held(2, i) <= slice1_held(1, i);
      end loop;
      for i in 0 to 15 loop
        if is_set(others_from_19(113 - 2 * i), 4) or (((others_from_19(113 - 2 * i) / 4) mod 4) = 3) then
          slice1_held(0, i) <= 5;
        else
          slice1_held(0, i) <= others_from_19(113 - 2 * i) / 2;
        end if;
      end loop;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        slice2shift_search_0(0) <= slice1shift_search_out_0;
        for i in 1 to 15 loop
          slice2shift_search_0(i) <= slice2shift_search_0(i - 1);
        end loop;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_search_out_0 <= slice2shift_search_0(15);
      -- slice2cost
      slice2cost_pixels_first_0_0_count_value(0) := is_set(slice2shift_reference_0, 2);
      slice2cost_pixels_first_0_0_count_value_2(0) := is_set(slice2shift_reference_0, 1);
      slice2cost_pixels_first_0_0_count_value(1) := is_set(slice2shift_reference_0, 3);
      slice2cost_pixels_first_0_0_count_value_2(1) := is_set(slice2shift_reference_0, 5);
      slice2cost_pixels_first_0_0_count_1_value_3 := is_set(slice2shift_reference_0, 4);
      slice2cost_pixels_first_0_0_count_value(2) := is_set(slice2shift_reference_0, 8);
      slice2cost_pixels_first_0_0_count_value_2(2) := is_set(slice2shift_reference_0, 6);
      for i in 3 to 6 loop
        slice2cost_pixels_first_0_0_count_value(i) := is_set(slice2shift_reference_0, 3 * i);
        slice2cost_pixels_first_0_0_count_value_2(i) := is_set(slice2shift_reference_0, 3 * i + 2);
        slice2cost_pixels_first_0_0_count_value_3(i) := is_set(slice2shift_reference_0, 3 * i + 1);
      end loop;
      slice2cost_pixels_first_0_count(0, 0) <= as_number((is_set(slice2shift_search_0(0), 0) /=
        is_set(slice2shift_reference_0, 0))) + as_number((slice2cost_pixels_first_0_0_count_value(0) /=
        is_set(slice2shift_search_0(0), 2))) + as_number((slice2cost_pixels_first_0_0_count_value_2(0) /=
        is_set(slice2shift_search_0(0), 1)));
      slice2cost_pixels_first_0_count(0, 1) <= as_number((slice2cost_pixels_first_0_0_count_value(1) /=
        is_set(slice2shift_search_0(0), 3))) + as_number((slice2cost_pixels_first_0_0_count_value_2(1) /=
        is_set(slice2shift_search_0(0), 5))) + as_number((slice2cost_pixels_first_0_0_count_1_value_3 /=
        is_set(slice2shift_search_0(0), 4)));
      slice2cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned((slice2shift_search_0(0) mod 256), 8)) xor
        (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) +
        as_number((slice2cost_pixels_first_0_0_count_value(2) /= is_set(slice2shift_search_0(0), 8))) +
        as_number((slice2cost_pixels_first_0_0_count_value_2(2) /= is_set(slice2shift_search_0(0), 6)));
      for i in 3 to 6 loop
        slice2cost_pixels_first_0_count(0, i) <= as_number((slice2cost_pixels_first_0_0_count_value(i) /=
          is_set(slice2shift_search_0(0), 3 * i))) + as_number((slice2cost_pixels_first_0_0_count_value_2(i) /=
          is_set(slice2shift_search_0(0), 3 * i + 2))) + as_number((slice2cost_pixels_first_0_0_count_value_3(i) /=
          is_set(slice2shift_search_0(0), 3 * i + 1)));
      end loop;
      slice2cost_pixels_first_0_count_7(0) <= is_set(slice2shift_reference_0, 21) /= is_set(slice2shift_search_0(0),
        21);
      for i in 1 to 15 loop
        slice2cost_pixels_first_0_count(i, 0) <= as_number((is_set(slice2shift_search_0(i), 0) /=
          is_set(slice2shift_reference_0, 0))) + as_number((is_set(slice2shift_search_0(i), 2) /=
          slice2cost_pixels_first_0_0_count_value(0))) + as_number((is_set(slice2shift_search_0(i), 1) /=
          slice2cost_pixels_first_0_0_count_value_2(0)));
        slice2cost_pixels_first_0_count(i, 1) <= as_number((is_set(slice2shift_search_0(i), 3) /=
          slice2cost_pixels_first_0_0_count_value(1))) + as_number((is_set(slice2shift_search_0(i), 5) /=
          slice2cost_pixels_first_0_0_count_value_2(1))) + as_number((is_set(slice2shift_search_0(i), 4) /=
          slice2cost_pixels_first_0_0_count_1_value_3));
        slice2cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned((slice2shift_search_0(i) mod 256), 8)) xor
          (to_unsigned((slice2shift_reference_0 mod 256), 8)))) / 128) + as_number((is_set(slice2shift_search_0(i), 8)
          /= slice2cost_pixels_first_0_0_count_value(2))) + as_number((is_set(slice2shift_search_0(i), 6) /=
          slice2cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 6 loop
          slice2cost_pixels_first_0_count(i, j) <= as_number((is_set(slice2shift_search_0(i), 3 * j) /=
            slice2cost_pixels_first_0_0_count_value(j))) + as_number((is_set(slice2shift_search_0(i), 3 * j + 2) /=
            slice2cost_pixels_first_0_0_count_value_2(j))) + as_number((is_set(slice2shift_search_0(i), 3 * j + 1) /=
            slice2cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice2cost_pixels_first_0_count_7(i) <= is_set(slice2shift_search_0(i), 21) /= is_set(slice2shift_reference_0,
          21);
      end loop;
      for i in 0 to 15 loop
        slice2cost_pixels_cost_0(i) <= slice2cost_pixels_first_0_count(i, 0) + slice2cost_pixels_first_0_count(i, 2) +
          slice2cost_pixels_first_0_count(i, 3) + slice2cost_pixels_first_0_count(i, 5) +
          slice2cost_pixels_first_0_count(i, 6) + slice2cost_pixels_first_0_count(i, 4) +
          as_number(slice2cost_pixels_first_0_count_7(i)) + slice2cost_pixels_first_0_count(i, 1);
      end loop;
      for i in 0 to 15 loop
        slice2cost_single_0(i) <= slice2cost_pixels_cost_0(i);
      end loop;
      -- slice2
      for i in 0 to 15 loop
        slice2_held(1, i) <= slice2_held(0, i);
      end loop;
      for i in 0 to 15 loop
        if is_set(others_from_19(81 - 2 * i), 4) or (((others_from_19(81 - 2 * i) / 4) mod 4) = 3) then
          slice2_held(0, i) <= 5;
        else
          slice2_held(0, i) <= others_from_19(81 - 2 * i) / 2;
        end if;
      end loop;
      -- slice3shift
      if slice0cost_pixels_tag_valid then
        slice3shift_search_0(0) <= slice2shift_search_out_0;
        for i in 1 to 15 loop
          slice3shift_search_0(i) <= slice3shift_search_0(i - 1);
        end loop;
      end if;
      slice3shift_reference_0 <= slice2shift_reference_0;
      -- slice3cost
      slice3cost_pixels_first_0_0_count_value(0) := is_set(slice3shift_reference_0, 2);
      slice3cost_pixels_first_0_0_count_value_2(0) := is_set(slice3shift_reference_0, 1);
      slice3cost_pixels_first_0_0_count_value(1) := is_set(slice3shift_reference_0, 3);
      slice3cost_pixels_first_0_0_count_value_2(1) := is_set(slice3shift_reference_0, 5);
      slice3cost_pixels_first_0_0_count_1_value_3 := is_set(slice3shift_reference_0, 4);
      slice3cost_pixels_first_0_0_count_value(2) := is_set(slice3shift_reference_0, 8);
      slice3cost_pixels_first_0_0_count_value_2(2) := is_set(slice3shift_reference_0, 6);
      for i in 3 to 6 loop
        slice3cost_pixels_first_0_0_count_value(i) := is_set(slice3shift_reference_0, 3 * i);
        slice3cost_pixels_first_0_0_count_value_2(i) := is_set(slice3shift_reference_0, 3 * i + 2);
        slice3cost_pixels_first_0_0_count_value_3(i) := is_set(slice3shift_reference_0, 3 * i + 1);
      end loop;
      slice3cost_pixels_first_0_count(0, 0) <= as_number((is_set(slice3shift_search_0(0), 0) /=
        is_set(slice3shift_reference_0, 0))) + as_number((slice3cost_pixels_first_0_0_count_value(0) /=
        is_set(slice3shift_search_0(0), 2))) + as_number((slice3cost_pixels_first_0_0_count_value_2(0) /=
        is_set(slice3shift_search_0(0), 1)));
      slice3cost_pixels_first_0_count(0, 1) <= as_number((slice3cost_pixels_first_0_0_count_value(1) /=
        is_set(slice3shift_search_0(0), 3))) + as_number((slice3cost_pixels_first_0_0_count_value_2(1) /=
        is_set(slice3shift_search_0(0), 5))) + as_number((slice3cost_pixels_first_0_0_count_1_value_3 /=
        is_set(slice3shift_search_0(0), 4)));
      slice3cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned((slice3shift_search_0(0) mod 256), 8)) xor
        (to_unsigned((slice3shift_reference_0 mod 256), 8)))) / 128) +
        as_number((slice3cost_pixels_first_0_0_count_value(2) /= is_set(slice3shift_search_0(0), 8))) +
        as_number((slice3cost_pixels_first_0_0_count_value_2(2) /= is_set(slice3shift_search_0(0), 6)));
      for i in 3 to 6 loop
        slice3cost_pixels_first_0_count(0, i) <= as_number((slice3cost_pixels_first_0_0_count_value(i) /=
          is_set(slice3shift_search_0(0), 3 * i))) + as_number((slice3cost_pixels_first_0_0_count_value_2(i) /=
          is_set(slice3shift_search_0(0), 3 * i + 2))) + as_number((slice3cost_pixels_first_0_0_count_value_3(i) /=
          is_set(slice3shift_search_0(0), 3 * i + 1)));
      end loop;
      slice3cost_pixels_first_0_count_7(0) <= is_set(slice3shift_reference_0, 21) /= is_set(slice3shift_search_0(0),
        21);
      for i in 1 to 15 loop
        slice3cost_pixels_first_0_count(i, 0) <= as_number((is_set(slice3shift_search_0(i), 0) /=
          is_set(slice3shift_reference_0, 0))) + as_number((is_set(slice3shift_search_0(i), 2) /=
          slice3cost_pixels_first_0_0_count_value(0))) + as_number((is_set(slice3shift_search_0(i), 1) /=
          slice3cost_pixels_first_0_0_count_value_2(0)));
        slice3cost_pixels_first_0_count(i, 1) <= as_number((is_set(slice3shift_search_0(i), 3) /=
          slice3cost_pixels_first_0_0_count_value(1))) + as_number((is_set(slice3shift_search_0(i), 5) /=
          slice3cost_pixels_first_0_0_count_value_2(1))) + as_number((is_set(slice3shift_search_0(i), 4) /=
          slice3cost_pixels_first_0_0_count_1_value_3));
        slice3cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned((slice3shift_search_0(i) mod 256), 8)) xor
          (to_unsigned((slice3shift_reference_0 mod 256), 8)))) / 128) + as_number((is_set(slice3shift_search_0(i), 8)
          /= slice3cost_pixels_first_0_0_count_value(2))) + as_number((is_set(slice3shift_search_0(i), 6) /=
          slice3cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 6 loop
          slice3cost_pixels_first_0_count(i, j) <= as_number((is_set(slice3shift_search_0(i), 3 * j) /=
            slice3cost_pixels_first_0_0_count_value(j))) + as_number((is_set(slice3shift_search_0(i), 3 * j + 2) /=
            slice3cost_pixels_first_0_0_count_value_2(j))) + as_number((is_set(slice3shift_search_0(i), 3 * j + 1) /=
            slice3cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice3cost_pixels_first_0_count_7(i) <= is_set(slice3shift_search_0(i), 21) /= is_set(slice3shift_reference_0,
          21);
      end loop;
      for i in 0 to 15 loop
        slice3cost_pixels_cost_0(i) <= slice3cost_pixels_first_0_count(i, 0) + slice3cost_pixels_first_0_count(i, 2) +
          slice3cost_pixels_first_0_count(i, 3) + slice3cost_pixels_first_0_count(i, 5) +
          slice3cost_pixels_first_0_count(i, 6) + slice3cost_pixels_first_0_count(i, 4) +
          as_number(slice3cost_pixels_first_0_count_7(i)) + slice3cost_pixels_first_0_count(i, 1);
      end loop;
      for i in 0 to 15 loop
        slice3cost_single_0(i) <= slice3cost_pixels_cost_0(i);
      end loop;
      -- slice3
      for i in 0 to 15 loop
        if is_set(others_from_19(49 - 2 * i), 4) or (((others_from_19(49 - 2 * i) / 4) mod 4) = 3) then
          slice3_held_0(i) <= 5;
        else
          slice3_held_0(i) <= others_from_19(49 - 2 * i) / 2;
        end if;
      end loop;
      -- entry
      entry_order_falls_any := entry_next_tag_map_column or (not slice0_tag_map_column(3)) or (not slice0_tag_valid(3));
      entry_order_falls_all := (not entry_next_tag_map_column) and slice0_tag_map_column(3) and slice0_tag_valid(3);
      entry_order_complete_all := slice0_tag_map_column(3) and slice0_tag_valid(3);
      entry_order_complete_any := (not slice0_tag_map_column(3)) or (not slice0_tag_valid(3));
      if entry_order_falls_all then
        entry_order_turned_output_column_choice := entry_order_output and entry_order_complete;
      else
        entry_order_turned_output_column_choice := entry_order_held_output;
      end if;
      for i in 0 to 15 loop
        entry_next_cost(i) <= slice0_held(3, i);
      end loop;
      for i in 16 to 31 loop
        entry_next_cost(i) <= slice1_held(2, i - 16);
      end loop;
      for i in 32 to 47 loop
        entry_next_cost(i) <= slice2_held(1, i - 32);
      end loop;
      for i in 48 to 63 loop
        entry_next_cost(i) <= slice3_held_0(i - 48);
      end loop;
      entry_next_tag_valid <= slice0_tag_valid(3);
      entry_next_tag_first_cost <= slice0_tag_first_cost(3);
      entry_next_tag_end_of_line <= slice0_tag_end_of_line(3);
      entry_order_inside <= slice0_tag_map_column(3);
      entry_order_turned_output_column <= entry_order_turned_output_column_choice and slice0_tag_map_column(3);
      entry_order_turned_first_column <= entry_order_falls_all;
      entry_order_turned_start_of_frame <= (not entry_next_tag_map_column) and slice0_tag_map_column(3) and
        slice0_tag_valid(3) and entry_order_first and entry_order_output and entry_order_complete;
      for i in 0 to 63 loop
        entry_cost(i) <= entry_next_cost(i);
      end loop;
      entry_tag_valid <= entry_next_tag_valid;
      entry_tag_first_cost <= entry_next_tag_first_cost;
      entry_tag_map_column <= entry_order_inside;
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
      if slice0_tag_end_of_line(3) then
        entry_order_complete <= entry_order_complete or entry_order_complete_all;
      else
        entry_order_complete <= entry_order_complete and entry_order_complete_any;
      end if;
      if slice0_tag_valid(3) then
        entry_next_tag_map_column <= slice0_tag_map_column(3);
      end if;
      if entry_order_complete_all then
        if slice0_tag_first_cost(3) then
          entry_next_column <= 0;
          entry_next_top <= slice0_tag_start_of_frame(3);
        else
          entry_next_column <= (entry_next_column + 1) mod 2048;
          entry_next_top <= entry_next_top;
        end if;
      end if;
      if entry_order_falls then
        entry_order_address_choice := 2047;
      else
        entry_order_address_choice := 1;
      end if;
      if entry_order_falls then
        entry_order_address_choice_2 := 0;
      else
        entry_order_address_choice_2 := 19;
      end if;
      if not entry_order_complete_any then
        if entry_order_falls_any then
          entry_order_address <= (entry_order_address_choice + entry_order_address) mod 2048;
        else
          entry_order_address <= entry_order_address_choice_2 * 64;
        end if;
      end if;
      if entry_order_falls_all then
        entry_order_output <= slice0_tag_output_column(3);
        entry_order_first <= slice0_tag_start_of_frame(3);
        entry_order_held_output <= entry_order_output and entry_order_complete;
      end if;
      -- forward
      for i in 0 to 7 loop
        for j in 2 to 3 loop
          if (forward_left_cost(8 * i + j) - forward_left_cost(8 * i + j - 2)) < 0 then
            forward_left_pair_choice(4 * i + j - 2) := forward_left_cost(8 * i + j);
          else
            forward_left_pair_choice(4 * i + j - 2) := forward_left_cost(8 * i + j - 2);
          end if;
        end loop;
        for j in 6 to 7 loop
          if (forward_left_cost(8 * i + j) - forward_left_cost(8 * i + j - 2)) < 0 then
            forward_left_pair_choice(4 * i + j - 4) := forward_left_cost(8 * i + j);
          else
            forward_left_pair_choice(4 * i + j - 4) := forward_left_cost(8 * i + j - 2);
          end if;
        end loop;
      end loop;
      forward_left_start_cost_0_any := ((((forward_left_tree_next_next_next_next_smallest_0 mod 64) +
        forward_left_relief_beyond) / 64) = 1) or is_set(forward_left_tree_next_next_next_next_smallest_0, 6);
      if is_set(forward_left_relief_largest, 0) then
        forward_left_start_cost_0_choice := (not is_set(forward_left_room, 1)) or (not is_set(forward_left_room, 0));
      else
        forward_left_start_cost_0_choice := not is_set(forward_left_room, 1);
      end if;
      if is_set(forward_left_relief_largest, 1) then
        forward_left_start_cost_0_choices(2) := forward_left_start_cost_0_choice;
      else
        forward_left_start_cost_0_choices(2) := is_set(forward_left_relief_largest, 0) and ((forward_left_room mod 4) =
          0);
      end if;
      forward_left_start_cost_0_value := is_set(forward_left_room, 2);
      if forward_left_start_cost_0_choices(2) then
        forward_left_start_cost_0_choices(3) := (not is_set(forward_left_relief_largest, 2)) and
          forward_left_start_cost_0_value;
      else
        forward_left_start_cost_0_choices(3) := (not is_set(forward_left_relief_largest, 2)) or
          forward_left_start_cost_0_value;
      end if;
      for i in 2 to 3 loop
        forward_left_start_cost_0_values(i) := is_set(forward_left_room, i + 1);
        if forward_left_start_cost_0_choices(i + 1) then
          forward_left_start_cost_0_choices(i + 2) := (not is_set(forward_left_relief_largest, i + 1)) or
            forward_left_start_cost_0_values(i);
        else
          forward_left_start_cost_0_choices(i + 2) := (not is_set(forward_left_relief_largest, i + 1)) and
            forward_left_start_cost_0_values(i);
        end if;
      end loop;
      if forward_left_start_cost_0_choices(5) then
        forward_left_start_cost_0_choices(6) := is_set(forward_left_relief_largest, 5) and (not
          is_set(forward_left_room, 5));
      else
        forward_left_start_cost_0_choices(6) := is_set(forward_left_relief_largest, 5) or (not
          is_set(forward_left_room, 5));
      end if;
      if forward_left_start_cost_0_choices(6) then
        forward_left_start_cost_0_choices_from_7(7) := 0;
      else
        forward_left_start_cost_0_choices_from_7(7) := (forward_left_room - forward_left_relief_largest) mod 64;
      end if;
      forward_left_start_cost_0_is_less := 127 < ((forward_left_tree_next_next_next_next_smallest_0 mod 64) +
        forward_left_relief_reach_of_best);
      if forward_left_start_cost_0_is_less then
        forward_left_start_cost_0_choices_from_7(8) := (forward_left_tree_next_next_next_next_smallest_0 +
          forward_left_relief_reach_of_best) mod 64;
      else
        forward_left_start_cost_0_choices_from_7(8) := 0;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_start_cost_0_choices_from_7(9) := forward_left_start_cost_0_choices_from_7(7);
      else
        forward_left_start_cost_0_choices_from_7(9) := forward_left_start_cost_0_choices_from_7(8);
      end if;
      forward_left_room_value := (forward_left_start_cost(8) + forward_left_room) mod 64;
      if forward_left_start_cost_0_choices(6) then
        forward_left_room_choice := forward_left_room_value;
      else
        forward_left_room_choice := (forward_left_start_cost(8) + forward_left_relief_largest) mod 64;
      end if;
      if forward_left_start_cost_0_is_less then
        forward_left_room_choices(2) := (forward_left_relief_room_of_best -
          forward_left_tree_next_next_next_next_smallest_0) mod 64;
      else
        forward_left_room_choices(2) := forward_left_room_value;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_room_choices(3) := forward_left_room_choice;
      else
        forward_left_room_choices(3) := forward_left_room_choices(2);
      end if;
      if forward_first(5) then
        forward_left_smallest_choice := 0;
      else
        forward_left_smallest_choice := forward_reliefs_moved(5);
      end if;
      forward_left_smallest_difference := (forward_smallest_next_next_next_next_next_smallest_0 +
        forward_left_smallest_choice) - forward_reliefs_moved(4);
      if (forward_left_smallest_choice - forward_left_relief_past(0)) < 0 then
        forward_left_relief_pairs_0_choice := forward_left_relief_past(0);
      else
        forward_left_relief_pairs_0_choice := forward_left_smallest_choice;
      end if;
      if (forward_left_relief_fours(0) - forward_left_relief_fours(2)) < 0 then
        forward_left_relief_older_choice := forward_left_relief_fours(2);
      else
        forward_left_relief_older_choice := forward_left_relief_fours(0);
      end if;
      if (forward_reliefs_moved(4) - forward_left_smallest_choice) < 0 then
        forward_left_relief_recent_choice := forward_left_smallest_choice;
      else
        forward_left_relief_recent_choice := forward_reliefs_moved(4);
      end if;
      if (forward_reliefs_moved(4) - forward_left_relief_recent) < 0 then
        forward_left_relief_largest_choice := forward_left_relief_recent;
      else
        forward_left_relief_largest_choice := forward_reliefs_moved(4);
      end if;
      forward_left_relief_reach_of_best_sum := forward_left_room + forward_left_relief_leaves;
      if forward_left_start_cost_0_choices(6) then
        forward_left_relief_reach_of_best_choice := forward_left_relief_reach_of_best_sum;
      else
        forward_left_relief_reach_of_best_choice := forward_left_relief_largest + forward_left_relief_leaves;
      end if;
      if forward_left_start_cost_0_is_less then
        forward_left_relief_reach_of_best_choices(2) := (forward_left_relief_reach_again -
          (forward_left_tree_next_next_next_next_smallest_0 mod 64)) mod 256;
      else
        forward_left_relief_reach_of_best_choices(2) := forward_left_relief_reach_of_best_sum;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_relief_reach_of_best_choices(3) := forward_left_relief_reach_of_best_choice;
      else
        forward_left_relief_reach_of_best_choices(3) := forward_left_relief_reach_of_best_choices(2);
      end if;
      if forward_first(5) then
        forward_left_relief_leaves_choice := 64;
      else
        forward_left_relief_leaves_choice := forward_left_start_cost(7) + 64;
      end if;
      forward_left_g_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest) mod 128;
      forward_left_g_less_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest_less) mod 128;
      for i in 0 to 63 loop
        if (forward_left_arrived(i) - forward_left_cost(i)) < 0 then
          forward_left_cost_choice(i) := forward_left_arrived(i);
        else
          forward_left_cost_choice(i) := forward_left_cost(i);
        end if;
        if is_set(forward_left_cost_choice(i), 6) or forward_left_first(2) then
          forward_left_cost_choice_2(i) := 64;
        else
          forward_left_cost_choice_2(i) := forward_left_cost_choice(i);
        end if;
      end loop;
      if forward_left_first(2) then
        forward_left_arrived_choice(0) := 64;
      else
        forward_left_arrived_choice(0) := forward_left_cost(1);
      end if;
      for i in 1 to 2 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 1);
        end if;
      end loop;
      for i in 4 to 5 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2(i - 1) := 64;
        else
          forward_left_arrived_choice_2(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 5 to 6 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 3);
        end if;
      end loop;
      for i in 8 to 9 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s(i - 1) := 64;
        else
          forward_left_arrived_choice_2s(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 9 to 10 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 5);
        end if;
      end loop;
      for i in 12 to 13 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_11(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_11(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 13 to 14 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 7);
        end if;
      end loop;
      for i in 16 to 17 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_15(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_15(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 17 to 18 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 9);
        end if;
      end loop;
      for i in 20 to 21 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_19(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_19(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 21 to 22 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 11);
        end if;
      end loop;
      for i in 24 to 25 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_23(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_23(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 25 to 26 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 13);
        end if;
      end loop;
      for i in 28 to 29 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_27(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_27(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 29 to 30 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 15);
        end if;
      end loop;
      for i in 32 to 33 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_31(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_31(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 33 to 34 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 17);
        end if;
      end loop;
      for i in 36 to 37 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_35(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_35(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 37 to 38 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 19);
        end if;
      end loop;
      for i in 40 to 41 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_39(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_39(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 41 to 42 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 21);
        end if;
      end loop;
      for i in 44 to 45 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_43(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_43(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 45 to 46 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 23);
        end if;
      end loop;
      for i in 48 to 49 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_47(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_47(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 49 to 50 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 25);
        end if;
      end loop;
      for i in 52 to 53 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_51(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_51(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 53 to 54 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 27);
        end if;
      end loop;
      for i in 56 to 57 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_55(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_55(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 57 to 58 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 29);
        end if;
      end loop;
      for i in 60 to 61 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_59(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_59(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 61 to 62 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 31);
        end if;
      end loop;
      if forward_left_first(2) then
        forward_left_arrived_choice(63) := 64;
      else
        forward_left_arrived_choice(63) := forward_left_cost(62);
      end if;
      for i in 0 to 4 loop
        for j in 0 to 5 loop
          if forward_above_ready_top then
            forward_above_total_choice(12 * i + j) := 31;
          else
            forward_above_total_choice(12 * i + j) := to_integer(forward_above_ready_words(2 * i)(5 * j + 4 downto 5 *
              j));
          end if;
        end loop;
        for j in 6 to 11 loop
          if forward_above_ready_top then
            forward_above_total_choice(12 * i + j) := 31;
          else
            forward_above_total_choice(12 * i + j) := to_integer(forward_above_ready_words(2 * i + 1)(5 * j - 26 downto
              5 * j - 30));
          end if;
        end loop;
      end loop;
      if forward_above_ready_top then
        forward_above_total_choice(60) := 31;
      else
        forward_above_total_choice(60) := forward_above_ready_words_10 mod 32;
      end if;
      if forward_above_ready_top then
        forward_above_total_choice(61) := 31;
      else
        forward_above_total_choice(61) := (forward_above_ready_words_10 / 32) mod 32;
      end if;
      if forward_above_ready_top then
        forward_above_total_choice(62) := 31;
      else
        forward_above_total_choice(62) := (forward_above_ready_words_10 / 1024) mod 32;
      end if;
      if forward_above_ready_top then
        forward_above_total_choice(63) := 31;
      else
        forward_above_total_choice(63) := (forward_above_ready_words_10 / 32768) mod 32;
      end if;
      if entry_tag_valid then
        forward_cost_delay_ring_write_address <= forward_cost_delay_ring_read_address;
        for i in 0 to 31 loop
          forward_left_pair(i) <= forward_left_pair_choice(i);
        end loop;
        forward_left_smallest <= forward_left_smallest_difference mod 128;
        forward_left_smallest_less <= (forward_left_smallest_difference + 121) mod 128;
        forward_left_first(0) <= forward_first(5);
        forward_left_first(1) <= forward_left_first(0);
        forward_left_first(2) <= forward_left_first(1);
        forward_left_relief_next_0 <= forward_reliefs_moved(4);
        forward_left_relief_past(0) <= forward_left_smallest_choice;
        for i in 1 to 7 loop
          forward_left_relief_past(i) <= forward_left_relief_past(i - 1);
        end loop;
        forward_left_relief_pairs(0) <= forward_left_relief_pairs_0_choice;
        forward_left_relief_pairs(1) <= forward_left_relief_pairs(0);
        forward_left_relief_fours(1) <= forward_left_relief_fours(0);
        forward_left_relief_fours(2) <= forward_left_relief_fours(1);
        forward_left_relief_largest <= forward_left_relief_largest_choice;
        forward_left_relief_beyond <= (forward_left_relief_largest_choice - forward_left_relief_past(7)) mod 64;
        forward_left_relief_leaves <= forward_left_relief_leaves_choice - forward_left_relief_past(6);
        forward_left_relief_room_of_best <= forward_left_relief_past(7) + forward_left_relief_leaves_choice;
        forward_left_relief_reach_again <= (64 - forward_left_relief_past(6)) + forward_left_relief_past(7) +
          forward_left_relief_leaves_choice;
        forward_left_g_copy(0) <= forward_left_g_copy_0_value;
        forward_left_g_copy(1) <= forward_left_g_copy_0_value;
        forward_left_g_copy(2) <= forward_left_g_copy_0_value;
        forward_left_g_copy(3) <= forward_left_g_copy_0_value;
        forward_left_g_less_copy(0) <= forward_left_g_less_copy_0_value;
        forward_left_g_less_copy(1) <= forward_left_g_less_copy_0_value;
        forward_left_g_less_copy(2) <= forward_left_g_less_copy_0_value;
        forward_left_g_less_copy(3) <= forward_left_g_less_copy_0_value;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            forward_left_stay_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_copy(2 * i)) mod 128;
          end loop;
          for j in 16 to 31 loop
            forward_left_stay_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_copy(2 * i + 1)) mod
              128;
          end loop;
        end loop;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            forward_left_step_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_less_copy(2 * i)) mod
              128;
          end loop;
          for j in 16 to 31 loop
            forward_left_step_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_less_copy(2 * i + 1))
              mod 128;
          end loop;
        end loop;
        for i in 0 to 63 loop
          forward_left_cost(i) <= (forward_left_cost_choice_2(i) + forward_left_stay_change(i)) mod 128;
        end loop;
        for i in 0 to 2 loop
          forward_left_arrived(i) <= (forward_left_arrived_choice(i) + forward_left_step_change(i)) mod 128;
        end loop;
        forward_left_arrived(3) <= (forward_left_arrived_choice_2(3) + forward_left_step_change(3)) mod 128;
        forward_left_arrived(4) <= (forward_left_arrived_choice_2(4) + forward_left_step_change(4)) mod 128;
        forward_left_arrived(5) <= (forward_left_arrived_choice(5) + forward_left_step_change(5)) mod 128;
        forward_left_arrived(6) <= (forward_left_arrived_choice(6) + forward_left_step_change(6)) mod 128;
        forward_left_arrived(7) <= (forward_left_arrived_choice_2s(7) + forward_left_step_change(7)) mod 128;
        forward_left_arrived(8) <= (forward_left_arrived_choice_2s(8) + forward_left_step_change(8)) mod 128;
        forward_left_arrived(9) <= (forward_left_arrived_choice(9) + forward_left_step_change(9)) mod 128;
        forward_left_arrived(10) <= (forward_left_arrived_choice(10) + forward_left_step_change(10)) mod 128;
        forward_left_arrived(11) <= (forward_left_arrived_choice_2s_from_11(11) + forward_left_step_change(11)) mod 128;
        forward_left_arrived(12) <= (forward_left_arrived_choice_2s_from_11(12) + forward_left_step_change(12)) mod 128;
        forward_left_arrived(13) <= (forward_left_arrived_choice(13) + forward_left_step_change(13)) mod 128;
        forward_left_arrived(14) <= (forward_left_arrived_choice(14) + forward_left_step_change(14)) mod 128;
        forward_left_arrived(15) <= (forward_left_arrived_choice_2s_from_15(15) + forward_left_step_change(15)) mod 128;
        forward_left_arrived(16) <= (forward_left_arrived_choice_2s_from_15(16) + forward_left_step_change(16)) mod 128;
        forward_left_arrived(17) <= (forward_left_arrived_choice(17) + forward_left_step_change(17)) mod 128;
        forward_left_arrived(18) <= (forward_left_arrived_choice(18) + forward_left_step_change(18)) mod 128;
        forward_left_arrived(19) <= (forward_left_arrived_choice_2s_from_19(19) + forward_left_step_change(19)) mod 128;
        forward_left_arrived(20) <= (forward_left_arrived_choice_2s_from_19(20) + forward_left_step_change(20)) mod 128;
        forward_left_arrived(21) <= (forward_left_arrived_choice(21) + forward_left_step_change(21)) mod 128;
        forward_left_arrived(22) <= (forward_left_arrived_choice(22) + forward_left_step_change(22)) mod 128;
        forward_left_arrived(23) <= (forward_left_arrived_choice_2s_from_23(23) + forward_left_step_change(23)) mod 128;
        forward_left_arrived(24) <= (forward_left_arrived_choice_2s_from_23(24) + forward_left_step_change(24)) mod 128;
        forward_left_arrived(25) <= (forward_left_arrived_choice(25) + forward_left_step_change(25)) mod 128;
        forward_left_arrived(26) <= (forward_left_arrived_choice(26) + forward_left_step_change(26)) mod 128;
        forward_left_arrived(27) <= (forward_left_arrived_choice_2s_from_27(27) + forward_left_step_change(27)) mod 128;
        forward_left_arrived(28) <= (forward_left_arrived_choice_2s_from_27(28) + forward_left_step_change(28)) mod 128;
        forward_left_arrived(29) <= (forward_left_arrived_choice(29) + forward_left_step_change(29)) mod 128;
        forward_left_arrived(30) <= (forward_left_arrived_choice(30) + forward_left_step_change(30)) mod 128;
        forward_left_arrived(31) <= (forward_left_arrived_choice_2s_from_31(31) + forward_left_step_change(31)) mod 128;
        forward_left_arrived(32) <= (forward_left_arrived_choice_2s_from_31(32) + forward_left_step_change(32)) mod 128;
        forward_left_arrived(33) <= (forward_left_arrived_choice(33) + forward_left_step_change(33)) mod 128;
        forward_left_arrived(34) <= (forward_left_arrived_choice(34) + forward_left_step_change(34)) mod 128;
        forward_left_arrived(35) <= (forward_left_arrived_choice_2s_from_35(35) + forward_left_step_change(35)) mod 128;
        forward_left_arrived(36) <= (forward_left_arrived_choice_2s_from_35(36) + forward_left_step_change(36)) mod 128;
        forward_left_arrived(37) <= (forward_left_arrived_choice(37) + forward_left_step_change(37)) mod 128;
        forward_left_arrived(38) <= (forward_left_arrived_choice(38) + forward_left_step_change(38)) mod 128;
        forward_left_arrived(39) <= (forward_left_arrived_choice_2s_from_39(39) + forward_left_step_change(39)) mod 128;
        forward_left_arrived(40) <= (forward_left_arrived_choice_2s_from_39(40) + forward_left_step_change(40)) mod 128;
        forward_left_arrived(41) <= (forward_left_arrived_choice(41) + forward_left_step_change(41)) mod 128;
        forward_left_arrived(42) <= (forward_left_arrived_choice(42) + forward_left_step_change(42)) mod 128;
        forward_left_arrived(43) <= (forward_left_arrived_choice_2s_from_43(43) + forward_left_step_change(43)) mod 128;
        forward_left_arrived(44) <= (forward_left_arrived_choice_2s_from_43(44) + forward_left_step_change(44)) mod 128;
        forward_left_arrived(45) <= (forward_left_arrived_choice(45) + forward_left_step_change(45)) mod 128;
        forward_left_arrived(46) <= (forward_left_arrived_choice(46) + forward_left_step_change(46)) mod 128;
        forward_left_arrived(47) <= (forward_left_arrived_choice_2s_from_47(47) + forward_left_step_change(47)) mod 128;
        forward_left_arrived(48) <= (forward_left_arrived_choice_2s_from_47(48) + forward_left_step_change(48)) mod 128;
        forward_left_arrived(49) <= (forward_left_arrived_choice(49) + forward_left_step_change(49)) mod 128;
        forward_left_arrived(50) <= (forward_left_arrived_choice(50) + forward_left_step_change(50)) mod 128;
        forward_left_arrived(51) <= (forward_left_arrived_choice_2s_from_51(51) + forward_left_step_change(51)) mod 128;
        forward_left_arrived(52) <= (forward_left_arrived_choice_2s_from_51(52) + forward_left_step_change(52)) mod 128;
        forward_left_arrived(53) <= (forward_left_arrived_choice(53) + forward_left_step_change(53)) mod 128;
        forward_left_arrived(54) <= (forward_left_arrived_choice(54) + forward_left_step_change(54)) mod 128;
        forward_left_arrived(55) <= (forward_left_arrived_choice_2s_from_55(55) + forward_left_step_change(55)) mod 128;
        forward_left_arrived(56) <= (forward_left_arrived_choice_2s_from_55(56) + forward_left_step_change(56)) mod 128;
        forward_left_arrived(57) <= (forward_left_arrived_choice(57) + forward_left_step_change(57)) mod 128;
        forward_left_arrived(58) <= (forward_left_arrived_choice(58) + forward_left_step_change(58)) mod 128;
        forward_left_arrived(59) <= (forward_left_arrived_choice_2s_from_59(59) + forward_left_step_change(59)) mod 128;
        forward_left_arrived(60) <= (forward_left_arrived_choice_2s_from_59(60) + forward_left_step_change(60)) mod 128;
        for i in 61 to 63 loop
          forward_left_arrived(i) <= (forward_left_arrived_choice(i) + forward_left_step_change(i)) mod 128;
        end loop;
        for i in 0 to 9 loop
          forward_above_ready_words(i) <= forward_above_read_words(i);
        end loop;
        forward_above_ready_words_10 <= to_integer(forward_above_read_words_10);
        for i in 0 to 63 loop
          forward_above_ready_cost(i) <= entry_cost(i);
        end loop;
        forward_above_ready_top <= entry_top;
        for i in 0 to 63 loop
          forward_above_total(i) <= forward_above_total_choice(i) + forward_above_ready_cost(i);
        end loop;
        forward_above_delay_ring_write_address <= forward_above_delay_ring_read_address;
        forward_above_smallest_copy(0) <= forward_above_tree_next_next_next_next_next_smallest_0;
        forward_above_smallest_copy(1) <= forward_above_tree_next_next_next_next_next_smallest_0;
        forward_above_smallest_copy(2) <= forward_above_tree_next_next_next_next_next_smallest_0;
        forward_above_smallest_copy(3) <= forward_above_tree_next_next_next_next_next_smallest_0;
        for i in 0 to 2 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(0)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(0)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(0)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(0)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(0)) mod 64;
        end loop;
        for i in 3 to 4 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(i - 3))
            mod 64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(1)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(1)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(1)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(1)) mod 64;
        end loop;
        for i in 5 to 6 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(1)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(1)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(i - 4)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(i - 4)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(i - 4)) mod 64;
        end loop;
        for i in 7 to 8 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(2)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(2)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(2)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(2)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(2)) mod 64;
        end loop;
        for i in 9 to 10 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(i - 7))
            mod 64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(i - 7)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(i - 7)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(3)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(3)) mod 64;
        end loop;
        forward_above_cost(55) <= (to_integer(forward_above_delay_held(11)) - forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(56) <= (to_integer(forward_above_delay_held(11)(29 downto 6)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(57) <= (to_integer(forward_above_delay_held(11)(29 downto 12)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(58) <= (to_integer(forward_above_delay_held(11)(29 downto 18)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(59) <= (to_integer(forward_above_delay_held(11)(29 downto 24)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(60) <= (to_integer(forward_above_delay_held_12) - forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(61) <= (to_integer(forward_above_delay_held_12(23 downto 6)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(62) <= (to_integer(forward_above_delay_held_12(23 downto 12)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(63) <= (to_integer(forward_above_delay_held_12(23 downto 18)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_beside(0) <= forward_above_cost(1);
        forward_above_beside(63) <= forward_above_cost(62);
        forward_above_own_0 <= forward_above_cost(0);
        for i in 2 to 61 loop
          forward_above_own(i) <= forward_above_cost(i);
        end loop;
        forward_above_own_63 <= forward_above_cost(63);
        for i in 0 to 63 loop
          forward_above_step(i) <= forward_above_beside(i) + 5;
        end loop;
        forward_above_comes(0) <= entry_tag_map_column;
        for i in 1 to 11 loop
          forward_above_comes(i) <= forward_above_comes(i - 1);
        end loop;
        forward_above_column(0) <= entry_column;
        for i in 1 to 11 loop
          forward_above_column(i) <= forward_above_column(i - 1);
        end loop;
        forward_first(0) <= entry_turned_first_column;
        forward_first(1) <= sums_turn_ready_first;
        forward_first(2) <= forward_first(1);
        forward_first(3) <= forward_first(2);
        forward_first(4) <= forward_first(3);
        forward_first(5) <= forward_first(4);
        forward_reliefs_moved(0) <= relief_entered;
        for i in 1 to 5 loop
          forward_reliefs_moved(i) <= forward_reliefs_moved(i - 1);
        end loop;
        forward_reliefs_moved(6) <= forward_left_relief_next_0;
        forward_reliefs_moved(7) <= forward_reliefs_moved(6);
        forward_reliefs_moved(8) <= forward_reliefs_moved(7);
        forward_reliefs_moved(9) <= forward_reliefs_moved(8);
        forward_reliefs_moved(10) <= forward_reliefs_moved(9);
        for i in 0 to 5 loop
          forward_cost(0, 10 * i) <= to_integer(forward_cost_delay_held(i)(2 downto 0));
          forward_cost(0, 10 * i + 1) <= to_integer(forward_cost_delay_held(i)(5 downto 0)) / 8;
          for j in 2 to 9 loop
            forward_cost(0, 10 * i + j) <= to_integer(forward_cost_delay_held(i)(3 * j + 2 downto 3 * j));
          end loop;
        end loop;
        forward_cost(0, 60) <= to_integer(forward_cost_delay_held_6(2 downto 0));
        forward_cost(0, 61) <= to_integer(forward_cost_delay_held_6(5 downto 0)) / 8;
        forward_cost(0, 62) <= to_integer(forward_cost_delay_held_6(8 downto 6));
        forward_cost(0, 63) <= to_integer(forward_cost_delay_held_6(11 downto 9));
        for i in 1 to 3 loop
          for j in 0 to 63 loop
            forward_cost(i, j) <= forward_cost(i - 1, j);
          end loop;
        end loop;
        forward_smallest_cost(0) <= forward_smallest_next_next_next_next_next_smallest_0;
        forward_smallest_cost(1) <= forward_smallest_cost(0);
        forward_smallest_cost(2) <= forward_smallest_cost(1);
        forward_smallest_cost(3) <= forward_smallest_cost(2);
        forward_smallest_cost(4) <= forward_smallest_cost(3);
        for i in 0 to 31 loop
          if (entry_cost(2 * i + 1) - entry_cost(2 * i)) < 0 then
            forward_smallest_smallest(i) <= entry_cost(2 * i + 1);
          else
            forward_smallest_smallest(i) <= entry_cost(2 * i);
          end if;
        end loop;
        for i in 0 to 15 loop
          if (forward_smallest_smallest(2 * i + 1) - forward_smallest_smallest(2 * i)) < 0 then
            forward_smallest_next_smallest(i) <= forward_smallest_smallest(2 * i + 1);
          else
            forward_smallest_next_smallest(i) <= forward_smallest_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_smallest_next_smallest(2 * i + 1) - forward_smallest_next_smallest(2 * i)) < 0 then
            forward_smallest_next_next_smallest(i) <= forward_smallest_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_smallest(i) <= forward_smallest_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_smallest_next_next_smallest(2 * i + 1) - forward_smallest_next_next_smallest(2 * i)) < 0 then
            forward_smallest_next_next_next_smallest(i) <= forward_smallest_next_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_next_smallest(i) <= forward_smallest_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_smallest_next_next_next_smallest(2 * i + 1) - forward_smallest_next_next_next_smallest(2 * i)) <
            0 then
            forward_smallest_next_next_next_next_smallest(i) <= forward_smallest_next_next_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_next_next_smallest(i) <= forward_smallest_next_next_next_smallest(2 * i);
          end if;
        end loop;
        if (forward_smallest_next_next_next_next_smallest(1) - forward_smallest_next_next_next_next_smallest(0)) < 0
          then
          forward_smallest_next_next_next_next_next_smallest_0 <= forward_smallest_next_next_next_next_smallest(1);
        else
          forward_smallest_next_next_next_next_next_smallest_0 <= forward_smallest_next_next_next_next_smallest(0);
        end if;
        if forward_cost_delay_ring_read_address = 6 then
          forward_cost_delay_ring_read_address <= 0;
        else
          forward_cost_delay_ring_read_address <= (forward_cost_delay_ring_read_address + 1) mod 8;
        end if;
        for i in 0 to 15 loop
          if (forward_left_pair(2 * i + 1) - forward_left_pair(2 * i)) < 0 then
            forward_left_tree_smallest(i) <= forward_left_pair(2 * i + 1);
          else
            forward_left_tree_smallest(i) <= forward_left_pair(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_left_tree_smallest(2 * i + 1) - forward_left_tree_smallest(2 * i)) < 0 then
            forward_left_tree_next_smallest(i) <= forward_left_tree_smallest(2 * i + 1);
          else
            forward_left_tree_next_smallest(i) <= forward_left_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_left_tree_next_smallest(2 * i + 1) - forward_left_tree_next_smallest(2 * i)) < 0 then
            forward_left_tree_next_next_smallest(i) <= forward_left_tree_next_smallest(2 * i + 1);
          else
            forward_left_tree_next_next_smallest(i) <= forward_left_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_left_tree_next_next_smallest(2 * i + 1) - forward_left_tree_next_next_smallest(2 * i)) < 0 then
            forward_left_tree_next_next_next_smallest(i) <= forward_left_tree_next_next_smallest(2 * i + 1);
          else
            forward_left_tree_next_next_next_smallest(i) <= forward_left_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        if (forward_left_tree_next_next_next_smallest(1) - forward_left_tree_next_next_next_smallest(0)) < 0 then
          forward_left_tree_next_next_next_next_smallest_0 <= forward_left_tree_next_next_next_smallest(1);
        else
          forward_left_tree_next_next_next_next_smallest_0 <= forward_left_tree_next_next_next_smallest(0);
        end if;
        if forward_first(5) then
          forward_left_start_cost(0) <= 60;
          for i in 1 to 8 loop
            forward_left_start_cost(i) <= 0;
          end loop;
          forward_left_room <= 0;
          forward_left_relief_reach_of_best <= 0;
        else
          forward_left_start_cost(0) <= forward_left_start_cost_0_choices_from_7(9);
          for i in 1 to 8 loop
            forward_left_start_cost(i) <= forward_left_start_cost(i - 1);
          end loop;
          forward_left_room <= forward_left_room_choices(3);
          forward_left_relief_reach_of_best <= forward_left_relief_reach_of_best_choices(3);
        end if;
        if (forward_left_relief_pairs_0_choice - forward_left_relief_pairs(1)) < 0 then
          forward_left_relief_fours(0) <= forward_left_relief_pairs(1);
        else
          forward_left_relief_fours(0) <= forward_left_relief_pairs_0_choice;
        end if;
        if (forward_left_smallest_choice - forward_left_relief_older_choice) < 0 then
          forward_left_relief_older <= forward_left_relief_older_choice;
        else
          forward_left_relief_older <= forward_left_smallest_choice;
        end if;
        if (forward_left_relief_recent_choice - forward_left_relief_older) < 0 then
          forward_left_relief_recent <= forward_left_relief_older;
        else
          forward_left_relief_recent <= forward_left_relief_recent_choice;
        end if;
        for i in 0 to 31 loop
          if (forward_above_total(2 * i + 1) - forward_above_total(2 * i)) < 0 then
            forward_above_tree_smallest(i) <= forward_above_total(2 * i + 1);
          else
            forward_above_tree_smallest(i) <= forward_above_total(2 * i);
          end if;
        end loop;
        for i in 0 to 15 loop
          if (forward_above_tree_smallest(2 * i + 1) - forward_above_tree_smallest(2 * i)) < 0 then
            forward_above_tree_next_smallest(i) <= forward_above_tree_smallest(2 * i + 1);
          else
            forward_above_tree_next_smallest(i) <= forward_above_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_above_tree_next_smallest(2 * i + 1) - forward_above_tree_next_smallest(2 * i)) < 0 then
            forward_above_tree_next_next_smallest(i) <= forward_above_tree_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_smallest(i) <= forward_above_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_above_tree_next_next_smallest(2 * i + 1) - forward_above_tree_next_next_smallest(2 * i)) < 0 then
            forward_above_tree_next_next_next_smallest(i) <= forward_above_tree_next_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_next_smallest(i) <= forward_above_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_above_tree_next_next_next_smallest(2 * i + 1) - forward_above_tree_next_next_next_smallest(2 *
            i)) < 0 then
            forward_above_tree_next_next_next_next_smallest(i) <= forward_above_tree_next_next_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_next_next_smallest(i) <= forward_above_tree_next_next_next_smallest(2 * i);
          end if;
        end loop;
        if (forward_above_tree_next_next_next_next_smallest(1) - forward_above_tree_next_next_next_next_smallest(0)) <
          0 then
          forward_above_tree_next_next_next_next_next_smallest_0 <= forward_above_tree_next_next_next_next_smallest(1);
        else
          forward_above_tree_next_next_next_next_next_smallest_0 <= forward_above_tree_next_next_next_next_smallest(0);
        end if;
        if forward_above_delay_ring_read_address = 6 then
          forward_above_delay_ring_read_address <= 0;
        else
          forward_above_delay_ring_read_address <= (forward_above_delay_ring_read_address + 1) mod 8;
        end if;
        for i in 2 to 63 loop
          if (forward_above_cost(i) - forward_above_cost(i - 2)) < 0 then
            forward_above_beside(i - 1) <= forward_above_cost(i);
          else
            forward_above_beside(i - 1) <= forward_above_cost(i - 2);
          end if;
        end loop;
        if forward_above_own_0 < 31 then
          forward_above_stay(0) <= forward_above_own_0 mod 32;
        else
          forward_above_stay(0) <= 31;
        end if;
        if forward_above_beside(0) < 31 then
          forward_above_stay(1) <= forward_above_beside(0) mod 32;
        else
          forward_above_stay(1) <= 31;
        end if;
        for i in 2 to 61 loop
          if forward_above_own(i) < 31 then
            forward_above_stay(i) <= forward_above_own(i) mod 32;
          else
            forward_above_stay(i) <= 31;
          end if;
        end loop;
        if forward_above_beside(63) < 31 then
          forward_above_stay(62) <= forward_above_beside(63) mod 32;
        else
          forward_above_stay(62) <= 31;
        end if;
        if forward_above_own_63 < 31 then
          forward_above_stay(63) <= forward_above_own_63 mod 32;
        else
          forward_above_stay(63) <= 31;
        end if;
      end if;
      if forward_above_comes(11) then
        forward_above_writes_copy_0 <= entry_next_tag_valid and (forward_above_comes(10) or (not entry_tag_valid));
      else
        forward_above_writes_copy_0 <= entry_next_tag_valid and forward_above_comes(10) and entry_tag_valid;
      end if;
      for i in 0 to 9 loop
        if (forward_above_step(6 * i + 4) - forward_above_stay(6 * i + 4)) < 0 then
          forward_above_write_words_choice(i) := forward_above_step(6 * i + 4);
        else
          forward_above_write_words_choice(i) := forward_above_stay(6 * i + 4);
        end if;
        for j in 2 to 3 loop
          if (forward_above_step(6 * i + 9 - 2 * j) - forward_above_stay(6 * i + 9 - 2 * j)) < 0 then
            forward_above_write_words_choices(i, j) := forward_above_step(6 * i + 9 - 2 * j);
          else
            forward_above_write_words_choices(i, j) := forward_above_stay(6 * i + 9 - 2 * j);
          end if;
        end loop;
        for j in 4 to 5 loop
          if (forward_above_step(6 * i + 10 - 2 * j) - forward_above_stay(6 * i + 10 - 2 * j)) < 0 then
            forward_above_write_words_choices(i, j) := forward_above_step(6 * i + 10 - 2 * j);
          else
            forward_above_write_words_choices(i, j) := forward_above_stay(6 * i + 10 - 2 * j);
          end if;
        end loop;
        if (forward_above_step(6 * i + 1) - forward_above_stay(6 * i + 1)) < 0 then
          forward_above_write_words_choices(i, 6) := forward_above_step(6 * i + 1);
        else
          forward_above_write_words_choices(i, 6) := forward_above_stay(6 * i + 1);
        end if;
      end loop;
      if (forward_above_step(62) - forward_above_stay(62)) < 0 then
        forward_above_write_words_choice(10) := forward_above_step(62);
      else
        forward_above_write_words_choice(10) := forward_above_stay(62);
      end if;
      for i in 2 to 3 loop
        if (forward_above_step(69 - 3 * i) - forward_above_stay(69 - 3 * i)) < 0 then
          forward_above_write_words_10_choices(i) := forward_above_step(69 - 3 * i);
        else
          forward_above_write_words_10_choices(i) := forward_above_stay(69 - 3 * i);
        end if;
      end loop;
      if (forward_above_step(61) - forward_above_stay(61)) < 0 then
        forward_above_write_words_10_choices(4) := forward_above_step(61);
      else
        forward_above_write_words_10_choices(4) := forward_above_stay(61);
      end if;
      if forward_above_writes_copy_0 then
        for i in 0 to 9 loop
          forward_above_write_words(i) <= ((((((((((to_unsigned(forward_above_write_words_choice(i), 12) &
            to_unsigned(0, 20)) or (to_unsigned(forward_above_write_words_choices(i, 2), 7) & to_unsigned(0, 25)))) or
            (to_unsigned(forward_above_write_words_choices(i, 3), 17) & to_unsigned(0, 15)))) or
            (to_unsigned(forward_above_write_words_choices(i, 4), 22) & to_unsigned(0, 10)))) or
            (to_unsigned(forward_above_write_words_choices(i, 5), 32)))) or
            (to_unsigned(forward_above_write_words_choices(i, 6), 27) & to_unsigned(0, 5)));
        end loop;
        forward_above_write_words_10 <= to_integer(((((((to_unsigned(forward_above_write_words_choice(10), 12) &
          to_unsigned(0, 10)) or (to_unsigned(forward_above_write_words_10_choices(2), 7) & to_unsigned(0, 15)))) or
          (to_unsigned(forward_above_write_words_10_choices(3), 22)))) or
          (to_unsigned(forward_above_write_words_10_choices(4), 17) & to_unsigned(0, 5))));
        forward_above_write_column <= forward_above_column(11);
      end if;
      -- sums
      for i in 0 to 7 loop
        for j in 2 to 3 loop
          if (sums_right_cost(8 * i + j) - sums_right_cost(8 * i + j - 2)) < 0 then
            sums_right_pair_choice(4 * i + j - 2) := sums_right_cost(8 * i + j);
          else
            sums_right_pair_choice(4 * i + j - 2) := sums_right_cost(8 * i + j - 2);
          end if;
        end loop;
        for j in 6 to 7 loop
          if (sums_right_cost(8 * i + j) - sums_right_cost(8 * i + j - 2)) < 0 then
            sums_right_pair_choice(4 * i + j - 4) := sums_right_cost(8 * i + j);
          else
            sums_right_pair_choice(4 * i + j - 4) := sums_right_cost(8 * i + j - 2);
          end if;
        end loop;
      end loop;
      sums_right_start_cost_0_any := ((((sums_right_tree_next_next_next_next_smallest_0 mod 64) +
        sums_right_relief_beyond) / 64) = 1) or is_set(sums_right_tree_next_next_next_next_smallest_0, 6);
      if is_set(sums_right_relief_largest, 0) then
        sums_right_start_cost_0_choice := (not is_set(sums_right_room, 1)) or (not is_set(sums_right_room, 0));
      else
        sums_right_start_cost_0_choice := not is_set(sums_right_room, 1);
      end if;
      if is_set(sums_right_relief_largest, 1) then
        sums_right_start_cost_0_choices(2) := sums_right_start_cost_0_choice;
      else
        sums_right_start_cost_0_choices(2) := is_set(sums_right_relief_largest, 0) and ((sums_right_room mod 4) = 0);
      end if;
      sums_right_start_cost_0_value := is_set(sums_right_room, 2);
      if sums_right_start_cost_0_choices(2) then
        sums_right_start_cost_0_choices(3) := (not is_set(sums_right_relief_largest, 2)) and
          sums_right_start_cost_0_value;
      else
        sums_right_start_cost_0_choices(3) := (not is_set(sums_right_relief_largest, 2)) or
          sums_right_start_cost_0_value;
      end if;
      for i in 2 to 3 loop
        sums_right_start_cost_0_values(i) := is_set(sums_right_room, i + 1);
        if sums_right_start_cost_0_choices(i + 1) then
          sums_right_start_cost_0_choices(i + 2) := (not is_set(sums_right_relief_largest, i + 1)) or
            sums_right_start_cost_0_values(i);
        else
          sums_right_start_cost_0_choices(i + 2) := (not is_set(sums_right_relief_largest, i + 1)) and
            sums_right_start_cost_0_values(i);
        end if;
      end loop;
      if sums_right_start_cost_0_choices(5) then
        sums_right_start_cost_0_choices(6) := is_set(sums_right_relief_largest, 5) and (not is_set(sums_right_room, 5));
      else
        sums_right_start_cost_0_choices(6) := is_set(sums_right_relief_largest, 5) or (not is_set(sums_right_room, 5));
      end if;
      if sums_right_start_cost_0_choices(6) then
        sums_right_start_cost_0_choices_from_7(7) := 0;
      else
        sums_right_start_cost_0_choices_from_7(7) := (sums_right_room - sums_right_relief_largest) mod 64;
      end if;
      sums_right_start_cost_0_is_less := 127 < ((sums_right_tree_next_next_next_next_smallest_0 mod 64) +
        sums_right_relief_reach_of_best);
      if sums_right_start_cost_0_is_less then
        sums_right_start_cost_0_choices_from_7(8) := (sums_right_tree_next_next_next_next_smallest_0 +
          sums_right_relief_reach_of_best) mod 64;
      else
        sums_right_start_cost_0_choices_from_7(8) := 0;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_start_cost_0_choices_from_7(9) := sums_right_start_cost_0_choices_from_7(7);
      else
        sums_right_start_cost_0_choices_from_7(9) := sums_right_start_cost_0_choices_from_7(8);
      end if;
      sums_right_room_value := (sums_right_start_cost(8) + sums_right_room) mod 64;
      if sums_right_start_cost_0_choices(6) then
        sums_right_room_choice := sums_right_room_value;
      else
        sums_right_room_choice := (sums_right_start_cost(8) + sums_right_relief_largest) mod 64;
      end if;
      if sums_right_start_cost_0_is_less then
        sums_right_room_choices(2) := (sums_right_relief_room_of_best - sums_right_tree_next_next_next_next_smallest_0)
          mod 64;
      else
        sums_right_room_choices(2) := sums_right_room_value;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_room_choices(3) := sums_right_room_choice;
      else
        sums_right_room_choices(3) := sums_right_room_choices(2);
      end if;
      if forward_first(0) then
        sums_right_smallest_choice := 0;
      else
        sums_right_smallest_choice := sums_right_relief_next_0;
      end if;
      sums_right_smallest_difference := sums_right_smallest_choice - (sums_turn_ready_smallest_0 / 8);
      if (sums_right_smallest_choice - sums_right_relief_past(0)) < 0 then
        sums_right_relief_pairs_0_choice := sums_right_relief_past(0);
      else
        sums_right_relief_pairs_0_choice := sums_right_smallest_choice;
      end if;
      if (sums_right_relief_fours(0) - sums_right_relief_fours(2)) < 0 then
        sums_right_relief_older_choice := sums_right_relief_fours(2);
      else
        sums_right_relief_older_choice := sums_right_relief_fours(0);
      end if;
      if ((sums_turn_ready_smallest_0 / 8) - sums_right_smallest_choice) < 0 then
        sums_right_relief_recent_choice := sums_right_smallest_choice;
      else
        sums_right_relief_recent_choice := sums_turn_ready_smallest_0 / 8;
      end if;
      if ((sums_turn_ready_smallest_0 / 8) - sums_right_relief_recent) < 0 then
        sums_right_relief_largest_choice := sums_right_relief_recent;
      else
        sums_right_relief_largest_choice := sums_turn_ready_smallest_0 / 8;
      end if;
      sums_right_relief_reach_of_best_sum := sums_right_room + sums_right_relief_leaves;
      if sums_right_start_cost_0_choices(6) then
        sums_right_relief_reach_of_best_choice := sums_right_relief_reach_of_best_sum;
      else
        sums_right_relief_reach_of_best_choice := sums_right_relief_largest + sums_right_relief_leaves;
      end if;
      if sums_right_start_cost_0_is_less then
        sums_right_relief_reach_of_best_choices(2) := (sums_right_relief_reach_again -
          (sums_right_tree_next_next_next_next_smallest_0 mod 64)) mod 256;
      else
        sums_right_relief_reach_of_best_choices(2) := sums_right_relief_reach_of_best_sum;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_relief_reach_of_best_choices(3) := sums_right_relief_reach_of_best_choice;
      else
        sums_right_relief_reach_of_best_choices(3) := sums_right_relief_reach_of_best_choices(2);
      end if;
      if forward_first(0) then
        sums_right_relief_leaves_choice := 64;
      else
        sums_right_relief_leaves_choice := sums_right_start_cost(7) + 64;
      end if;
      sums_right_g_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest) mod 128;
      sums_right_g_less_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest_less) mod 128;
      for i in 0 to 63 loop
        if (sums_right_arrived(i) - sums_right_cost(i)) < 0 then
          sums_right_cost_choice(i) := sums_right_arrived(i);
        else
          sums_right_cost_choice(i) := sums_right_cost(i);
        end if;
        if is_set(sums_right_cost_choice(i), 6) or sums_right_first(2) then
          sums_right_cost_choice_2(i) := 64;
        else
          sums_right_cost_choice_2(i) := sums_right_cost_choice(i);
        end if;
      end loop;
      if sums_right_first(2) then
        sums_right_arrived_choice(0) := 64;
      else
        sums_right_arrived_choice(0) := sums_right_cost(1);
      end if;
      for i in 1 to 2 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 1);
        end if;
      end loop;
      for i in 4 to 5 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2(i - 1) := 64;
        else
          sums_right_arrived_choice_2(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 5 to 6 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 3);
        end if;
      end loop;
      for i in 8 to 9 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s(i - 1) := 64;
        else
          sums_right_arrived_choice_2s(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 9 to 10 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 5);
        end if;
      end loop;
      for i in 12 to 13 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_11(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_11(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 13 to 14 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 7);
        end if;
      end loop;
      for i in 16 to 17 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_15(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_15(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 17 to 18 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 9);
        end if;
      end loop;
      for i in 20 to 21 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_19(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_19(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 21 to 22 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 11);
        end if;
      end loop;
      for i in 24 to 25 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_23(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_23(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 25 to 26 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 13);
        end if;
      end loop;
      for i in 28 to 29 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_27(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_27(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 29 to 30 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 15);
        end if;
      end loop;
      for i in 32 to 33 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_31(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_31(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 33 to 34 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 17);
        end if;
      end loop;
      for i in 36 to 37 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_35(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_35(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 37 to 38 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 19);
        end if;
      end loop;
      for i in 40 to 41 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_39(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_39(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 41 to 42 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 21);
        end if;
      end loop;
      for i in 44 to 45 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_43(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_43(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 45 to 46 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 23);
        end if;
      end loop;
      for i in 48 to 49 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_47(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_47(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 49 to 50 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 25);
        end if;
      end loop;
      for i in 52 to 53 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_51(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_51(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 53 to 54 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 27);
        end if;
      end loop;
      for i in 56 to 57 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_55(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_55(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 57 to 58 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 29);
        end if;
      end loop;
      for i in 60 to 61 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if sums_right_first(2) then
          sums_right_arrived_choice_2s_from_59(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_59(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 61 to 62 loop
        if sums_right_first(2) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 31);
        end if;
      end loop;
      if sums_right_first(2) then
        sums_right_arrived_choice(63) := 64;
      else
        sums_right_arrived_choice(63) := sums_right_cost(62);
      end if;
      if entry_tag_valid then
        for i in 0 to 15 loop
          sums_turn_ready_sums(i) <= sums_turn_read_sums(i);
        end loop;
        for i in 0 to 5 loop
          sums_turn_ready_costs(i) <= to_integer(sums_turn_read_costs(i));
        end loop;
        sums_turn_ready_costs_6 <= to_integer(sums_turn_read_costs_6);
        sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
        sums_turn_ready_first <= entry_tag_first_cost;
        sums_turn_place(0) <= entry_place;
        for i in 1 to 10 loop
          sums_turn_place(i) <= sums_turn_place(i - 1);
        end loop;
        for i in 0 to 5 loop
          sums_cost(0, 10 * i) <= sums_turn_ready_costs(i) mod 8;
          sums_cost(0, 10 * i + 1) <= (sums_turn_ready_costs(i) mod 64) / 8;
          sums_cost(0, 10 * i + 2) <= (sums_turn_ready_costs(i) / 64) mod 8;
          sums_cost(0, 10 * i + 3) <= (sums_turn_ready_costs(i) / 512) mod 8;
          sums_cost(0, 10 * i + 4) <= (sums_turn_ready_costs(i) / 4096) mod 8;
          sums_cost(0, 10 * i + 5) <= (sums_turn_ready_costs(i) / 32768) mod 8;
          sums_cost(0, 10 * i + 6) <= (sums_turn_ready_costs(i) / 262144) mod 8;
          sums_cost(0, 10 * i + 7) <= (sums_turn_ready_costs(i) / 2097152) mod 8;
          sums_cost(0, 10 * i + 8) <= (sums_turn_ready_costs(i) / 16777216) mod 8;
          sums_cost(0, 10 * i + 9) <= sums_turn_ready_costs(i) / 134217728;
        end loop;
        sums_cost(0, 60) <= sums_turn_ready_costs_6 mod 8;
        sums_cost(0, 61) <= (sums_turn_ready_costs_6 mod 64) / 8;
        sums_cost(0, 62) <= (sums_turn_ready_costs_6 / 64) mod 8;
        sums_cost(0, 63) <= sums_turn_ready_costs_6 / 512;
        for i in 0 to 63 loop
          sums_cost(1, i) <= sums_cost(0, i);
        end loop;
        for i in 0 to 31 loop
          sums_right_pair(i) <= sums_right_pair_choice(i);
        end loop;
        sums_right_smallest <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8)) mod 128;
        sums_right_smallest_less <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8) + 121) mod 128;
        sums_right_first(0) <= forward_first(0);
        sums_right_first(1) <= sums_right_first(0);
        sums_right_first(2) <= sums_right_first(1);
        sums_right_relief_next_0 <= sums_turn_ready_smallest_0 / 8;
        sums_right_relief_past(0) <= sums_right_smallest_choice;
        for i in 1 to 7 loop
          sums_right_relief_past(i) <= sums_right_relief_past(i - 1);
        end loop;
        sums_right_relief_pairs(0) <= sums_right_relief_pairs_0_choice;
        sums_right_relief_pairs(1) <= sums_right_relief_pairs(0);
        sums_right_relief_fours(1) <= sums_right_relief_fours(0);
        sums_right_relief_fours(2) <= sums_right_relief_fours(1);
        sums_right_relief_largest <= sums_right_relief_largest_choice;
        sums_right_relief_beyond <= (sums_right_relief_largest_choice - sums_right_relief_past(7)) mod 64;
        sums_right_relief_leaves <= sums_right_relief_leaves_choice - sums_right_relief_past(6);
        sums_right_relief_room_of_best <= sums_right_relief_past(7) + sums_right_relief_leaves_choice;
        sums_right_relief_reach_again <= (64 - sums_right_relief_past(6)) + sums_right_relief_past(7) +
          sums_right_relief_leaves_choice;
        sums_right_g_copy(0) <= sums_right_g_copy_0_value;
        sums_right_g_copy(1) <= sums_right_g_copy_0_value;
        sums_right_g_copy(2) <= sums_right_g_copy_0_value;
        sums_right_g_copy(3) <= sums_right_g_copy_0_value;
        sums_right_g_less_copy(0) <= sums_right_g_less_copy_0_value;
        sums_right_g_less_copy(1) <= sums_right_g_less_copy_0_value;
        sums_right_g_less_copy(2) <= sums_right_g_less_copy_0_value;
        sums_right_g_less_copy(3) <= sums_right_g_less_copy_0_value;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            sums_right_stay_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_copy(2 * i)) mod 128;
          end loop;
          for j in 16 to 31 loop
            sums_right_stay_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_copy(2 * i + 1)) mod 128;
          end loop;
        end loop;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            sums_right_step_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_less_copy(2 * i)) mod 128;
          end loop;
          for j in 16 to 31 loop
            sums_right_step_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_less_copy(2 * i + 1)) mod
              128;
          end loop;
        end loop;
        for i in 0 to 63 loop
          sums_right_cost(i) <= (sums_right_cost_choice_2(i) + sums_right_stay_change(i)) mod 128;
        end loop;
        sums_right_arrived(0) <= (sums_right_arrived_choice(0) + sums_right_step_change(0)) mod 128;
        sums_right_arrived(1) <= (sums_right_arrived_choice(1) + sums_right_step_change(1)) mod 128;
        sums_right_arrived(2) <= (sums_right_arrived_choice(2) + sums_right_step_change(2)) mod 128;
        sums_right_arrived(3) <= (sums_right_arrived_choice_2(3) + sums_right_step_change(3)) mod 128;
        sums_right_arrived(4) <= (sums_right_arrived_choice_2(4) + sums_right_step_change(4)) mod 128;
        sums_right_arrived(5) <= (sums_right_arrived_choice(5) + sums_right_step_change(5)) mod 128;
        sums_right_arrived(6) <= (sums_right_arrived_choice(6) + sums_right_step_change(6)) mod 128;
        sums_right_arrived(7) <= (sums_right_arrived_choice_2s(7) + sums_right_step_change(7)) mod 128;
        sums_right_arrived(8) <= (sums_right_arrived_choice_2s(8) + sums_right_step_change(8)) mod 128;
        sums_right_arrived(9) <= (sums_right_arrived_choice(9) + sums_right_step_change(9)) mod 128;
        sums_right_arrived(10) <= (sums_right_arrived_choice(10) + sums_right_step_change(10)) mod 128;
        sums_right_arrived(11) <= (sums_right_arrived_choice_2s_from_11(11) + sums_right_step_change(11)) mod 128;
        sums_right_arrived(12) <= (sums_right_arrived_choice_2s_from_11(12) + sums_right_step_change(12)) mod 128;
        sums_right_arrived(13) <= (sums_right_arrived_choice(13) + sums_right_step_change(13)) mod 128;
        sums_right_arrived(14) <= (sums_right_arrived_choice(14) + sums_right_step_change(14)) mod 128;
        sums_right_arrived(15) <= (sums_right_arrived_choice_2s_from_15(15) + sums_right_step_change(15)) mod 128;
        sums_right_arrived(16) <= (sums_right_arrived_choice_2s_from_15(16) + sums_right_step_change(16)) mod 128;
        sums_right_arrived(17) <= (sums_right_arrived_choice(17) + sums_right_step_change(17)) mod 128;
        sums_right_arrived(18) <= (sums_right_arrived_choice(18) + sums_right_step_change(18)) mod 128;
        sums_right_arrived(19) <= (sums_right_arrived_choice_2s_from_19(19) + sums_right_step_change(19)) mod 128;
        sums_right_arrived(20) <= (sums_right_arrived_choice_2s_from_19(20) + sums_right_step_change(20)) mod 128;
        sums_right_arrived(21) <= (sums_right_arrived_choice(21) + sums_right_step_change(21)) mod 128;
        sums_right_arrived(22) <= (sums_right_arrived_choice(22) + sums_right_step_change(22)) mod 128;
        sums_right_arrived(23) <= (sums_right_arrived_choice_2s_from_23(23) + sums_right_step_change(23)) mod 128;
        sums_right_arrived(24) <= (sums_right_arrived_choice_2s_from_23(24) + sums_right_step_change(24)) mod 128;
        sums_right_arrived(25) <= (sums_right_arrived_choice(25) + sums_right_step_change(25)) mod 128;
        sums_right_arrived(26) <= (sums_right_arrived_choice(26) + sums_right_step_change(26)) mod 128;
        sums_right_arrived(27) <= (sums_right_arrived_choice_2s_from_27(27) + sums_right_step_change(27)) mod 128;
        sums_right_arrived(28) <= (sums_right_arrived_choice_2s_from_27(28) + sums_right_step_change(28)) mod 128;
        sums_right_arrived(29) <= (sums_right_arrived_choice(29) + sums_right_step_change(29)) mod 128;
        sums_right_arrived(30) <= (sums_right_arrived_choice(30) + sums_right_step_change(30)) mod 128;
        sums_right_arrived(31) <= (sums_right_arrived_choice_2s_from_31(31) + sums_right_step_change(31)) mod 128;
        sums_right_arrived(32) <= (sums_right_arrived_choice_2s_from_31(32) + sums_right_step_change(32)) mod 128;
        sums_right_arrived(33) <= (sums_right_arrived_choice(33) + sums_right_step_change(33)) mod 128;
        sums_right_arrived(34) <= (sums_right_arrived_choice(34) + sums_right_step_change(34)) mod 128;
        sums_right_arrived(35) <= (sums_right_arrived_choice_2s_from_35(35) + sums_right_step_change(35)) mod 128;
        sums_right_arrived(36) <= (sums_right_arrived_choice_2s_from_35(36) + sums_right_step_change(36)) mod 128;
        sums_right_arrived(37) <= (sums_right_arrived_choice(37) + sums_right_step_change(37)) mod 128;
        sums_right_arrived(38) <= (sums_right_arrived_choice(38) + sums_right_step_change(38)) mod 128;
        sums_right_arrived(39) <= (sums_right_arrived_choice_2s_from_39(39) + sums_right_step_change(39)) mod 128;
        sums_right_arrived(40) <= (sums_right_arrived_choice_2s_from_39(40) + sums_right_step_change(40)) mod 128;
        sums_right_arrived(41) <= (sums_right_arrived_choice(41) + sums_right_step_change(41)) mod 128;
        sums_right_arrived(42) <= (sums_right_arrived_choice(42) + sums_right_step_change(42)) mod 128;
        sums_right_arrived(43) <= (sums_right_arrived_choice_2s_from_43(43) + sums_right_step_change(43)) mod 128;
        sums_right_arrived(44) <= (sums_right_arrived_choice_2s_from_43(44) + sums_right_step_change(44)) mod 128;
        sums_right_arrived(45) <= (sums_right_arrived_choice(45) + sums_right_step_change(45)) mod 128;
        sums_right_arrived(46) <= (sums_right_arrived_choice(46) + sums_right_step_change(46)) mod 128;
        sums_right_arrived(47) <= (sums_right_arrived_choice_2s_from_47(47) + sums_right_step_change(47)) mod 128;
        sums_right_arrived(48) <= (sums_right_arrived_choice_2s_from_47(48) + sums_right_step_change(48)) mod 128;
        sums_right_arrived(49) <= (sums_right_arrived_choice(49) + sums_right_step_change(49)) mod 128;
        sums_right_arrived(50) <= (sums_right_arrived_choice(50) + sums_right_step_change(50)) mod 128;
        sums_right_arrived(51) <= (sums_right_arrived_choice_2s_from_51(51) + sums_right_step_change(51)) mod 128;
        sums_right_arrived(52) <= (sums_right_arrived_choice_2s_from_51(52) + sums_right_step_change(52)) mod 128;
        sums_right_arrived(53) <= (sums_right_arrived_choice(53) + sums_right_step_change(53)) mod 128;
        sums_right_arrived(54) <= (sums_right_arrived_choice(54) + sums_right_step_change(54)) mod 128;
        sums_right_arrived(55) <= (sums_right_arrived_choice_2s_from_55(55) + sums_right_step_change(55)) mod 128;
        sums_right_arrived(56) <= (sums_right_arrived_choice_2s_from_55(56) + sums_right_step_change(56)) mod 128;
        sums_right_arrived(57) <= (sums_right_arrived_choice(57) + sums_right_step_change(57)) mod 128;
        sums_right_arrived(58) <= (sums_right_arrived_choice(58) + sums_right_step_change(58)) mod 128;
        sums_right_arrived(59) <= (sums_right_arrived_choice_2s_from_59(59) + sums_right_step_change(59)) mod 128;
        sums_right_arrived(60) <= (sums_right_arrived_choice_2s_from_59(60) + sums_right_step_change(60)) mod 128;
        sums_right_arrived(61) <= (sums_right_arrived_choice(61) + sums_right_step_change(61)) mod 128;
        sums_right_arrived(62) <= (sums_right_arrived_choice(62) + sums_right_step_change(62)) mod 128;
        sums_right_arrived(63) <= (sums_right_arrived_choice(63) + sums_right_step_change(63)) mod 128;
        sums_sum_delay_ring_write_address <= sums_sum_delay_ring_read_address;
        sums_tags_held_output_column(0) <= entry_turned_output_column;
        sums_tags_held_start_of_frame(0) <= entry_turned_start_of_frame;
        sums_tags_held_end_of_line(0) <= entry_tag_end_of_line;
        for i in 1 to 4 loop
          sums_tags_held_output_column(i) <= sums_tags_held_output_column(i - 1);
          sums_tags_held_start_of_frame(i) <= sums_tags_held_start_of_frame(i - 1);
          sums_tags_held_end_of_line(i) <= sums_tags_held_end_of_line(i - 1);
        end loop;
        for i in 0 to 15 loop
          if (sums_right_pair(2 * i + 1) - sums_right_pair(2 * i)) < 0 then
            sums_right_tree_smallest(i) <= sums_right_pair(2 * i + 1);
          else
            sums_right_tree_smallest(i) <= sums_right_pair(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (sums_right_tree_smallest(2 * i + 1) - sums_right_tree_smallest(2 * i)) < 0 then
            sums_right_tree_next_smallest(i) <= sums_right_tree_smallest(2 * i + 1);
          else
            sums_right_tree_next_smallest(i) <= sums_right_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (sums_right_tree_next_smallest(2 * i + 1) - sums_right_tree_next_smallest(2 * i)) < 0 then
            sums_right_tree_next_next_smallest(i) <= sums_right_tree_next_smallest(2 * i + 1);
          else
            sums_right_tree_next_next_smallest(i) <= sums_right_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (sums_right_tree_next_next_smallest(2 * i + 1) - sums_right_tree_next_next_smallest(2 * i)) < 0 then
            sums_right_tree_next_next_next_smallest(i) <= sums_right_tree_next_next_smallest(2 * i + 1);
          else
            sums_right_tree_next_next_next_smallest(i) <= sums_right_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        if (sums_right_tree_next_next_next_smallest(1) - sums_right_tree_next_next_next_smallest(0)) < 0 then
          sums_right_tree_next_next_next_next_smallest_0 <= sums_right_tree_next_next_next_smallest(1);
        else
          sums_right_tree_next_next_next_next_smallest_0 <= sums_right_tree_next_next_next_smallest(0);
        end if;
        if forward_first(0) then
          sums_right_start_cost(0) <= 60;
          for i in 1 to 8 loop
            sums_right_start_cost(i) <= 0;
          end loop;
          sums_right_room <= 0;
          sums_right_relief_reach_of_best <= 0;
        else
          sums_right_start_cost(0) <= sums_right_start_cost_0_choices_from_7(9);
          for i in 1 to 8 loop
            sums_right_start_cost(i) <= sums_right_start_cost(i - 1);
          end loop;
          sums_right_room <= sums_right_room_choices(3);
          sums_right_relief_reach_of_best <= sums_right_relief_reach_of_best_choices(3);
        end if;
        if (sums_right_relief_pairs_0_choice - sums_right_relief_pairs(1)) < 0 then
          sums_right_relief_fours(0) <= sums_right_relief_pairs(1);
        else
          sums_right_relief_fours(0) <= sums_right_relief_pairs_0_choice;
        end if;
        if (sums_right_smallest_choice - sums_right_relief_older_choice) < 0 then
          sums_right_relief_older <= sums_right_relief_older_choice;
        else
          sums_right_relief_older <= sums_right_smallest_choice;
        end if;
        if (sums_right_relief_recent_choice - sums_right_relief_older) < 0 then
          sums_right_relief_recent <= sums_right_relief_older;
        else
          sums_right_relief_recent <= sums_right_relief_recent_choice;
        end if;
        if sums_sum_delay_ring_read_address = 3 then
          sums_sum_delay_ring_read_address <= 0;
        else
          sums_sum_delay_ring_read_address <= (sums_sum_delay_ring_read_address + 1) mod 4;
        end if;
      end if;
      if entry_tag_valid then
        sums_turn_writes_copy_0_choice := forward_above_comes(9);
      else
        sums_turn_writes_copy_0_choice := forward_above_comes(10);
      end if;
      sums_turn_writes_copy_0 <= entry_next_tag_valid and sums_turn_writes_copy_0_choice;
      for i in 0 to 15 loop
        sums_sum_0(4 * i) <= (sums_right_cost(4 * i) + to_integer(sums_sum_delay_held(i)(7 downto 0))) mod 256;
        sums_sum_0(4 * i + 1) <= (sums_right_cost(4 * i + 1) + to_integer(sums_sum_delay_held(i)(31 downto 8))) mod 256;
        sums_sum_0(4 * i + 2) <= (sums_right_cost(4 * i + 2) + to_integer(sums_sum_delay_held(i)(31 downto 16))) mod
          256;
        sums_sum_0(4 * i + 3) <= (sums_right_cost(4 * i + 3) + to_integer(sums_sum_delay_held(i)(31 downto 24))) mod
          256;
      end loop;
      sums_tag_valid <= sums_tags_moved;
      sums_tag_map_column <= forward_above_comes(4);
      sums_tag_output_column <= sums_tags_held_output_column(4);
      sums_tag_start_of_frame <= sums_tags_held_start_of_frame(4);
      sums_tag_end_of_line <= sums_tags_held_end_of_line(4);
      sums_tags_moved <= entry_tag_valid;
      if sums_turn_writes_copy_0 then
        for i in 0 to 15 loop
          sums_turn_write_sums(i) <= other(15 - i);
        end loop;
        for i in 0 to 5 loop
          sums_turn_write_costs(i) <= (forward_cost(3, 10 * i + 8) * 16777216) + (forward_cost(3, 10 * i + 9) *
            134217728) + (forward_cost(3, 10 * i + 7) * 2097152) + (forward_cost(3, 10 * i + 6) * 262144) +
            (forward_cost(3, 10 * i + 5) * 32768) + (forward_cost(3, 10 * i + 4) * 4096) + (forward_cost(3, 10 * i + 3)
            * 512) + (forward_cost(3, 10 * i + 2) * 64) + forward_cost(3, 10 * i) + (forward_cost(3, 10 * i + 1) * 8);
        end loop;
        sums_turn_write_costs_6 <= (forward_cost(3, 62) * 64) + (forward_cost(3, 63) * 512) + forward_cost(3, 60) +
          (forward_cost(3, 61) * 8);
        sums_turn_write_smallest_0 <= to_integer(((to_unsigned(forward_reliefs_moved(10), 6) & to_unsigned(0, 3)) or
          (to_unsigned(forward_smallest_cost(4), 9))));
        sums_turn_write_place <= sums_turn_place(10);
      end if;
      -- winnerswinner1
      if is_set(sums_sum_0(0), 0) then
        winnerswinner1_of_pair_0_0_choice := (not is_set(sums_sum_0(1), 1)) or (not is_set(sums_sum_0(1), 0));
      else
        winnerswinner1_of_pair_0_0_choice := not is_set(sums_sum_0(1), 1);
      end if;
      if is_set(sums_sum_0(0), 1) then
        winnerswinner1_of_pair_0_0_choices(2) := winnerswinner1_of_pair_0_0_choice;
      else
        winnerswinner1_of_pair_0_0_choices(2) := is_set(sums_sum_0(0), 0) and ((sums_sum_0(1) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_0_value := is_set(sums_sum_0(1), 2);
      if winnerswinner1_of_pair_0_0_choices(2) then
        winnerswinner1_of_pair_0_0_choices(3) := (not is_set(sums_sum_0(0), 2)) and winnerswinner1_of_pair_0_0_value;
      else
        winnerswinner1_of_pair_0_0_choices(3) := (not is_set(sums_sum_0(0), 2)) or winnerswinner1_of_pair_0_0_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_0_values(i) := is_set(sums_sum_0(1), i + 1);
        if winnerswinner1_of_pair_0_0_choices(i + 1) then
          winnerswinner1_of_pair_0_0_choices(i + 2) := (not is_set(sums_sum_0(0), i + 1)) or
            winnerswinner1_of_pair_0_0_values(i);
        else
          winnerswinner1_of_pair_0_0_choices(i + 2) := (not is_set(sums_sum_0(0), i + 1)) and
            winnerswinner1_of_pair_0_0_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_0_choices(7) then
        winnerswinner1_of_pair_0_0_choices(8) := is_set(sums_sum_0(0), 7) and (not is_set(sums_sum_0(1), 7));
      else
        winnerswinner1_of_pair_0_0_choices(8) := is_set(sums_sum_0(0), 7) or (not is_set(sums_sum_0(1), 7));
      end if;
      if is_set(sums_sum_0(2), 0) then
        winnerswinner1_of_pair_0_2_choice := (not is_set(sums_sum_0(3), 1)) or (not is_set(sums_sum_0(3), 0));
      else
        winnerswinner1_of_pair_0_2_choice := not is_set(sums_sum_0(3), 1);
      end if;
      if is_set(sums_sum_0(2), 1) then
        winnerswinner1_of_pair_0_2_choices(2) := winnerswinner1_of_pair_0_2_choice;
      else
        winnerswinner1_of_pair_0_2_choices(2) := is_set(sums_sum_0(2), 0) and ((sums_sum_0(3) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_2_value := is_set(sums_sum_0(3), 2);
      if winnerswinner1_of_pair_0_2_choices(2) then
        winnerswinner1_of_pair_0_2_choices(3) := (not is_set(sums_sum_0(2), 2)) and winnerswinner1_of_pair_0_2_value;
      else
        winnerswinner1_of_pair_0_2_choices(3) := (not is_set(sums_sum_0(2), 2)) or winnerswinner1_of_pair_0_2_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_2_values(i) := is_set(sums_sum_0(3), i + 1);
        if winnerswinner1_of_pair_0_2_choices(i + 1) then
          winnerswinner1_of_pair_0_2_choices(i + 2) := (not is_set(sums_sum_0(2), i + 1)) or
            winnerswinner1_of_pair_0_2_values(i);
        else
          winnerswinner1_of_pair_0_2_choices(i + 2) := (not is_set(sums_sum_0(2), i + 1)) and
            winnerswinner1_of_pair_0_2_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_2_choices(7) then
        winnerswinner1_of_pair_0_2_choices(8) := is_set(sums_sum_0(2), 7) and (not is_set(sums_sum_0(3), 7));
      else
        winnerswinner1_of_pair_0_2_choices(8) := is_set(sums_sum_0(2), 7) or (not is_set(sums_sum_0(3), 7));
      end if;
      if is_set(sums_sum_0(4), 0) then
        winnerswinner1_of_pair_0_4_choice := (not is_set(sums_sum_0(5), 1)) or (not is_set(sums_sum_0(5), 0));
      else
        winnerswinner1_of_pair_0_4_choice := not is_set(sums_sum_0(5), 1);
      end if;
      if is_set(sums_sum_0(4), 1) then
        winnerswinner1_of_pair_0_4_choices(2) := winnerswinner1_of_pair_0_4_choice;
      else
        winnerswinner1_of_pair_0_4_choices(2) := is_set(sums_sum_0(4), 0) and ((sums_sum_0(5) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_4_value := is_set(sums_sum_0(5), 2);
      if winnerswinner1_of_pair_0_4_choices(2) then
        winnerswinner1_of_pair_0_4_choices(3) := (not is_set(sums_sum_0(4), 2)) and winnerswinner1_of_pair_0_4_value;
      else
        winnerswinner1_of_pair_0_4_choices(3) := (not is_set(sums_sum_0(4), 2)) or winnerswinner1_of_pair_0_4_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_4_values(i) := is_set(sums_sum_0(5), i + 1);
        if winnerswinner1_of_pair_0_4_choices(i + 1) then
          winnerswinner1_of_pair_0_4_choices(i + 2) := (not is_set(sums_sum_0(4), i + 1)) or
            winnerswinner1_of_pair_0_4_values(i);
        else
          winnerswinner1_of_pair_0_4_choices(i + 2) := (not is_set(sums_sum_0(4), i + 1)) and
            winnerswinner1_of_pair_0_4_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_4_choices(7) then
        winnerswinner1_of_pair_0_4_choices(8) := is_set(sums_sum_0(4), 7) and (not is_set(sums_sum_0(5), 7));
      else
        winnerswinner1_of_pair_0_4_choices(8) := is_set(sums_sum_0(4), 7) or (not is_set(sums_sum_0(5), 7));
      end if;
      if is_set(sums_sum_0(6), 0) then
        winnerswinner1_of_pair_0_6_choice := (not is_set(sums_sum_0(7), 1)) or (not is_set(sums_sum_0(7), 0));
      else
        winnerswinner1_of_pair_0_6_choice := not is_set(sums_sum_0(7), 1);
      end if;
      if is_set(sums_sum_0(6), 1) then
        winnerswinner1_of_pair_0_6_choices(2) := winnerswinner1_of_pair_0_6_choice;
      else
        winnerswinner1_of_pair_0_6_choices(2) := is_set(sums_sum_0(6), 0) and ((sums_sum_0(7) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_6_value := is_set(sums_sum_0(7), 2);
      if winnerswinner1_of_pair_0_6_choices(2) then
        winnerswinner1_of_pair_0_6_choices(3) := (not is_set(sums_sum_0(6), 2)) and winnerswinner1_of_pair_0_6_value;
      else
        winnerswinner1_of_pair_0_6_choices(3) := (not is_set(sums_sum_0(6), 2)) or winnerswinner1_of_pair_0_6_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_6_values(i) := is_set(sums_sum_0(7), i + 1);
        if winnerswinner1_of_pair_0_6_choices(i + 1) then
          winnerswinner1_of_pair_0_6_choices(i + 2) := (not is_set(sums_sum_0(6), i + 1)) or
            winnerswinner1_of_pair_0_6_values(i);
        else
          winnerswinner1_of_pair_0_6_choices(i + 2) := (not is_set(sums_sum_0(6), i + 1)) and
            winnerswinner1_of_pair_0_6_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_6_choices(7) then
        winnerswinner1_of_pair_0_6_choices(8) := is_set(sums_sum_0(6), 7) and (not is_set(sums_sum_0(7), 7));
      else
        winnerswinner1_of_pair_0_6_choices(8) := is_set(sums_sum_0(6), 7) or (not is_set(sums_sum_0(7), 7));
      end if;
      if is_set(sums_sum_0(8), 0) then
        winnerswinner1_of_pair_0_8_choice := (not is_set(sums_sum_0(9), 1)) or (not is_set(sums_sum_0(9), 0));
      else
        winnerswinner1_of_pair_0_8_choice := not is_set(sums_sum_0(9), 1);
      end if;
      if is_set(sums_sum_0(8), 1) then
        winnerswinner1_of_pair_0_8_choices(2) := winnerswinner1_of_pair_0_8_choice;
      else
        winnerswinner1_of_pair_0_8_choices(2) := is_set(sums_sum_0(8), 0) and ((sums_sum_0(9) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_8_value := is_set(sums_sum_0(9), 2);
      if winnerswinner1_of_pair_0_8_choices(2) then
        winnerswinner1_of_pair_0_8_choices(3) := (not is_set(sums_sum_0(8), 2)) and winnerswinner1_of_pair_0_8_value;
      else
        winnerswinner1_of_pair_0_8_choices(3) := (not is_set(sums_sum_0(8), 2)) or winnerswinner1_of_pair_0_8_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_8_values(i) := is_set(sums_sum_0(9), i + 1);
        if winnerswinner1_of_pair_0_8_choices(i + 1) then
          winnerswinner1_of_pair_0_8_choices(i + 2) := (not is_set(sums_sum_0(8), i + 1)) or
            winnerswinner1_of_pair_0_8_values(i);
        else
          winnerswinner1_of_pair_0_8_choices(i + 2) := (not is_set(sums_sum_0(8), i + 1)) and
            winnerswinner1_of_pair_0_8_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_8_choices(7) then
        winnerswinner1_of_pair_0_8_choices(8) := is_set(sums_sum_0(8), 7) and (not is_set(sums_sum_0(9), 7));
      else
        winnerswinner1_of_pair_0_8_choices(8) := is_set(sums_sum_0(8), 7) or (not is_set(sums_sum_0(9), 7));
      end if;
      if is_set(sums_sum_0(10), 0) then
        winnerswinner1_of_pair_0_10_choice := (not is_set(sums_sum_0(11), 1)) or (not is_set(sums_sum_0(11), 0));
      else
        winnerswinner1_of_pair_0_10_choice := not is_set(sums_sum_0(11), 1);
      end if;
      if is_set(sums_sum_0(10), 1) then
        winnerswinner1_of_pair_0_10_choices(2) := winnerswinner1_of_pair_0_10_choice;
      else
        winnerswinner1_of_pair_0_10_choices(2) := is_set(sums_sum_0(10), 0) and ((sums_sum_0(11) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_10_value := is_set(sums_sum_0(11), 2);
      if winnerswinner1_of_pair_0_10_choices(2) then
        winnerswinner1_of_pair_0_10_choices(3) := (not is_set(sums_sum_0(10), 2)) and winnerswinner1_of_pair_0_10_value;
      else
        winnerswinner1_of_pair_0_10_choices(3) := (not is_set(sums_sum_0(10), 2)) or winnerswinner1_of_pair_0_10_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_10_values(i) := is_set(sums_sum_0(11), i + 1);
        if winnerswinner1_of_pair_0_10_choices(i + 1) then
          winnerswinner1_of_pair_0_10_choices(i + 2) := (not is_set(sums_sum_0(10), i + 1)) or
            winnerswinner1_of_pair_0_10_values(i);
        else
          winnerswinner1_of_pair_0_10_choices(i + 2) := (not is_set(sums_sum_0(10), i + 1)) and
            winnerswinner1_of_pair_0_10_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_10_choices(7) then
        winnerswinner1_of_pair_0_10_choices(8) := is_set(sums_sum_0(10), 7) and (not is_set(sums_sum_0(11), 7));
      else
        winnerswinner1_of_pair_0_10_choices(8) := is_set(sums_sum_0(10), 7) or (not is_set(sums_sum_0(11), 7));
      end if;
      if is_set(sums_sum_0(12), 0) then
        winnerswinner1_of_pair_0_12_choice := (not is_set(sums_sum_0(13), 1)) or (not is_set(sums_sum_0(13), 0));
      else
        winnerswinner1_of_pair_0_12_choice := not is_set(sums_sum_0(13), 1);
      end if;
      if is_set(sums_sum_0(12), 1) then
        winnerswinner1_of_pair_0_12_choices(2) := winnerswinner1_of_pair_0_12_choice;
      else
        winnerswinner1_of_pair_0_12_choices(2) := is_set(sums_sum_0(12), 0) and ((sums_sum_0(13) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_12_value := is_set(sums_sum_0(13), 2);
      if winnerswinner1_of_pair_0_12_choices(2) then
        winnerswinner1_of_pair_0_12_choices(3) := (not is_set(sums_sum_0(12), 2)) and winnerswinner1_of_pair_0_12_value;
      else
        winnerswinner1_of_pair_0_12_choices(3) := (not is_set(sums_sum_0(12), 2)) or winnerswinner1_of_pair_0_12_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_12_values(i) := is_set(sums_sum_0(13), i + 1);
        if winnerswinner1_of_pair_0_12_choices(i + 1) then
          winnerswinner1_of_pair_0_12_choices(i + 2) := (not is_set(sums_sum_0(12), i + 1)) or
            winnerswinner1_of_pair_0_12_values(i);
        else
          winnerswinner1_of_pair_0_12_choices(i + 2) := (not is_set(sums_sum_0(12), i + 1)) and
            winnerswinner1_of_pair_0_12_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_12_choices(7) then
        winnerswinner1_of_pair_0_12_choices(8) := is_set(sums_sum_0(12), 7) and (not is_set(sums_sum_0(13), 7));
      else
        winnerswinner1_of_pair_0_12_choices(8) := is_set(sums_sum_0(12), 7) or (not is_set(sums_sum_0(13), 7));
      end if;
      if is_set(sums_sum_0(14), 0) then
        winnerswinner1_of_pair_0_14_choice := (not is_set(sums_sum_0(15), 1)) or (not is_set(sums_sum_0(15), 0));
      else
        winnerswinner1_of_pair_0_14_choice := not is_set(sums_sum_0(15), 1);
      end if;
      if is_set(sums_sum_0(14), 1) then
        winnerswinner1_of_pair_0_14_choices(2) := winnerswinner1_of_pair_0_14_choice;
      else
        winnerswinner1_of_pair_0_14_choices(2) := is_set(sums_sum_0(14), 0) and ((sums_sum_0(15) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_14_value := is_set(sums_sum_0(15), 2);
      if winnerswinner1_of_pair_0_14_choices(2) then
        winnerswinner1_of_pair_0_14_choices(3) := (not is_set(sums_sum_0(14), 2)) and winnerswinner1_of_pair_0_14_value;
      else
        winnerswinner1_of_pair_0_14_choices(3) := (not is_set(sums_sum_0(14), 2)) or winnerswinner1_of_pair_0_14_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_14_values(i) := is_set(sums_sum_0(15), i + 1);
        if winnerswinner1_of_pair_0_14_choices(i + 1) then
          winnerswinner1_of_pair_0_14_choices(i + 2) := (not is_set(sums_sum_0(14), i + 1)) or
            winnerswinner1_of_pair_0_14_values(i);
        else
          winnerswinner1_of_pair_0_14_choices(i + 2) := (not is_set(sums_sum_0(14), i + 1)) and
            winnerswinner1_of_pair_0_14_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_14_choices(7) then
        winnerswinner1_of_pair_0_14_choices(8) := is_set(sums_sum_0(14), 7) and (not is_set(sums_sum_0(15), 7));
      else
        winnerswinner1_of_pair_0_14_choices(8) := is_set(sums_sum_0(14), 7) or (not is_set(sums_sum_0(15), 7));
      end if;
      if is_set(sums_sum_0(16), 0) then
        winnerswinner1_of_pair_0_16_choice := (not is_set(sums_sum_0(17), 1)) or (not is_set(sums_sum_0(17), 0));
      else
        winnerswinner1_of_pair_0_16_choice := not is_set(sums_sum_0(17), 1);
      end if;
      if is_set(sums_sum_0(16), 1) then
        winnerswinner1_of_pair_0_16_choices(2) := winnerswinner1_of_pair_0_16_choice;
      else
        winnerswinner1_of_pair_0_16_choices(2) := is_set(sums_sum_0(16), 0) and ((sums_sum_0(17) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_16_value := is_set(sums_sum_0(17), 2);
      if winnerswinner1_of_pair_0_16_choices(2) then
        winnerswinner1_of_pair_0_16_choices(3) := (not is_set(sums_sum_0(16), 2)) and winnerswinner1_of_pair_0_16_value;
      else
        winnerswinner1_of_pair_0_16_choices(3) := (not is_set(sums_sum_0(16), 2)) or winnerswinner1_of_pair_0_16_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_16_values(i) := is_set(sums_sum_0(17), i + 1);
        if winnerswinner1_of_pair_0_16_choices(i + 1) then
          winnerswinner1_of_pair_0_16_choices(i + 2) := (not is_set(sums_sum_0(16), i + 1)) or
            winnerswinner1_of_pair_0_16_values(i);
        else
          winnerswinner1_of_pair_0_16_choices(i + 2) := (not is_set(sums_sum_0(16), i + 1)) and
            winnerswinner1_of_pair_0_16_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_16_choices(7) then
        winnerswinner1_of_pair_0_16_choices(8) := is_set(sums_sum_0(16), 7) and (not is_set(sums_sum_0(17), 7));
      else
        winnerswinner1_of_pair_0_16_choices(8) := is_set(sums_sum_0(16), 7) or (not is_set(sums_sum_0(17), 7));
      end if;
      if is_set(sums_sum_0(18), 0) then
        winnerswinner1_of_pair_0_18_choice := (not is_set(sums_sum_0(19), 1)) or (not is_set(sums_sum_0(19), 0));
      else
        winnerswinner1_of_pair_0_18_choice := not is_set(sums_sum_0(19), 1);
      end if;
      if is_set(sums_sum_0(18), 1) then
        winnerswinner1_of_pair_0_18_choices(2) := winnerswinner1_of_pair_0_18_choice;
      else
        winnerswinner1_of_pair_0_18_choices(2) := is_set(sums_sum_0(18), 0) and ((sums_sum_0(19) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_18_value := is_set(sums_sum_0(19), 2);
      if winnerswinner1_of_pair_0_18_choices(2) then
        winnerswinner1_of_pair_0_18_choices(3) := (not is_set(sums_sum_0(18), 2)) and winnerswinner1_of_pair_0_18_value;
      else
        winnerswinner1_of_pair_0_18_choices(3) := (not is_set(sums_sum_0(18), 2)) or winnerswinner1_of_pair_0_18_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_18_values(i) := is_set(sums_sum_0(19), i + 1);
        if winnerswinner1_of_pair_0_18_choices(i + 1) then
          winnerswinner1_of_pair_0_18_choices(i + 2) := (not is_set(sums_sum_0(18), i + 1)) or
            winnerswinner1_of_pair_0_18_values(i);
        else
          winnerswinner1_of_pair_0_18_choices(i + 2) := (not is_set(sums_sum_0(18), i + 1)) and
            winnerswinner1_of_pair_0_18_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_18_choices(7) then
        winnerswinner1_of_pair_0_18_choices(8) := is_set(sums_sum_0(18), 7) and (not is_set(sums_sum_0(19), 7));
      else
        winnerswinner1_of_pair_0_18_choices(8) := is_set(sums_sum_0(18), 7) or (not is_set(sums_sum_0(19), 7));
      end if;
      if is_set(sums_sum_0(20), 0) then
        winnerswinner1_of_pair_0_20_choice := (not is_set(sums_sum_0(21), 1)) or (not is_set(sums_sum_0(21), 0));
      else
        winnerswinner1_of_pair_0_20_choice := not is_set(sums_sum_0(21), 1);
      end if;
      if is_set(sums_sum_0(20), 1) then
        winnerswinner1_of_pair_0_20_choices(2) := winnerswinner1_of_pair_0_20_choice;
      else
        winnerswinner1_of_pair_0_20_choices(2) := is_set(sums_sum_0(20), 0) and ((sums_sum_0(21) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_20_value := is_set(sums_sum_0(21), 2);
      if winnerswinner1_of_pair_0_20_choices(2) then
        winnerswinner1_of_pair_0_20_choices(3) := (not is_set(sums_sum_0(20), 2)) and winnerswinner1_of_pair_0_20_value;
      else
        winnerswinner1_of_pair_0_20_choices(3) := (not is_set(sums_sum_0(20), 2)) or winnerswinner1_of_pair_0_20_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_20_values(i) := is_set(sums_sum_0(21), i + 1);
        if winnerswinner1_of_pair_0_20_choices(i + 1) then
          winnerswinner1_of_pair_0_20_choices(i + 2) := (not is_set(sums_sum_0(20), i + 1)) or
            winnerswinner1_of_pair_0_20_values(i);
        else
          winnerswinner1_of_pair_0_20_choices(i + 2) := (not is_set(sums_sum_0(20), i + 1)) and
            winnerswinner1_of_pair_0_20_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_20_choices(7) then
        winnerswinner1_of_pair_0_20_choices(8) := is_set(sums_sum_0(20), 7) and (not is_set(sums_sum_0(21), 7));
      else
        winnerswinner1_of_pair_0_20_choices(8) := is_set(sums_sum_0(20), 7) or (not is_set(sums_sum_0(21), 7));
      end if;
      if is_set(sums_sum_0(22), 0) then
        winnerswinner1_of_pair_0_22_choice := (not is_set(sums_sum_0(23), 1)) or (not is_set(sums_sum_0(23), 0));
      else
        winnerswinner1_of_pair_0_22_choice := not is_set(sums_sum_0(23), 1);
      end if;
      if is_set(sums_sum_0(22), 1) then
        winnerswinner1_of_pair_0_22_choices(2) := winnerswinner1_of_pair_0_22_choice;
      else
        winnerswinner1_of_pair_0_22_choices(2) := is_set(sums_sum_0(22), 0) and ((sums_sum_0(23) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_22_value := is_set(sums_sum_0(23), 2);
      if winnerswinner1_of_pair_0_22_choices(2) then
        winnerswinner1_of_pair_0_22_choices(3) := (not is_set(sums_sum_0(22), 2)) and winnerswinner1_of_pair_0_22_value;
      else
        winnerswinner1_of_pair_0_22_choices(3) := (not is_set(sums_sum_0(22), 2)) or winnerswinner1_of_pair_0_22_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_22_values(i) := is_set(sums_sum_0(23), i + 1);
        if winnerswinner1_of_pair_0_22_choices(i + 1) then
          winnerswinner1_of_pair_0_22_choices(i + 2) := (not is_set(sums_sum_0(22), i + 1)) or
            winnerswinner1_of_pair_0_22_values(i);
        else
          winnerswinner1_of_pair_0_22_choices(i + 2) := (not is_set(sums_sum_0(22), i + 1)) and
            winnerswinner1_of_pair_0_22_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_22_choices(7) then
        winnerswinner1_of_pair_0_22_choices(8) := is_set(sums_sum_0(22), 7) and (not is_set(sums_sum_0(23), 7));
      else
        winnerswinner1_of_pair_0_22_choices(8) := is_set(sums_sum_0(22), 7) or (not is_set(sums_sum_0(23), 7));
      end if;
      if is_set(sums_sum_0(24), 0) then
        winnerswinner1_of_pair_0_24_choice := (not is_set(sums_sum_0(25), 1)) or (not is_set(sums_sum_0(25), 0));
      else
        winnerswinner1_of_pair_0_24_choice := not is_set(sums_sum_0(25), 1);
      end if;
      if is_set(sums_sum_0(24), 1) then
        winnerswinner1_of_pair_0_24_choices(2) := winnerswinner1_of_pair_0_24_choice;
      else
        winnerswinner1_of_pair_0_24_choices(2) := is_set(sums_sum_0(24), 0) and ((sums_sum_0(25) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_24_value := is_set(sums_sum_0(25), 2);
      if winnerswinner1_of_pair_0_24_choices(2) then
        winnerswinner1_of_pair_0_24_choices(3) := (not is_set(sums_sum_0(24), 2)) and winnerswinner1_of_pair_0_24_value;
      else
        winnerswinner1_of_pair_0_24_choices(3) := (not is_set(sums_sum_0(24), 2)) or winnerswinner1_of_pair_0_24_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_24_values(i) := is_set(sums_sum_0(25), i + 1);
        if winnerswinner1_of_pair_0_24_choices(i + 1) then
          winnerswinner1_of_pair_0_24_choices(i + 2) := (not is_set(sums_sum_0(24), i + 1)) or
            winnerswinner1_of_pair_0_24_values(i);
        else
          winnerswinner1_of_pair_0_24_choices(i + 2) := (not is_set(sums_sum_0(24), i + 1)) and
            winnerswinner1_of_pair_0_24_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_24_choices(7) then
        winnerswinner1_of_pair_0_24_choices(8) := is_set(sums_sum_0(24), 7) and (not is_set(sums_sum_0(25), 7));
      else
        winnerswinner1_of_pair_0_24_choices(8) := is_set(sums_sum_0(24), 7) or (not is_set(sums_sum_0(25), 7));
      end if;
      if is_set(sums_sum_0(26), 0) then
        winnerswinner1_of_pair_0_26_choice := (not is_set(sums_sum_0(27), 1)) or (not is_set(sums_sum_0(27), 0));
      else
        winnerswinner1_of_pair_0_26_choice := not is_set(sums_sum_0(27), 1);
      end if;
      if is_set(sums_sum_0(26), 1) then
        winnerswinner1_of_pair_0_26_choices(2) := winnerswinner1_of_pair_0_26_choice;
      else
        winnerswinner1_of_pair_0_26_choices(2) := is_set(sums_sum_0(26), 0) and ((sums_sum_0(27) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_26_value := is_set(sums_sum_0(27), 2);
      if winnerswinner1_of_pair_0_26_choices(2) then
        winnerswinner1_of_pair_0_26_choices(3) := (not is_set(sums_sum_0(26), 2)) and winnerswinner1_of_pair_0_26_value;
      else
        winnerswinner1_of_pair_0_26_choices(3) := (not is_set(sums_sum_0(26), 2)) or winnerswinner1_of_pair_0_26_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_26_values(i) := is_set(sums_sum_0(27), i + 1);
        if winnerswinner1_of_pair_0_26_choices(i + 1) then
          winnerswinner1_of_pair_0_26_choices(i + 2) := (not is_set(sums_sum_0(26), i + 1)) or
            winnerswinner1_of_pair_0_26_values(i);
        else
          winnerswinner1_of_pair_0_26_choices(i + 2) := (not is_set(sums_sum_0(26), i + 1)) and
            winnerswinner1_of_pair_0_26_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_26_choices(7) then
        winnerswinner1_of_pair_0_26_choices(8) := is_set(sums_sum_0(26), 7) and (not is_set(sums_sum_0(27), 7));
      else
        winnerswinner1_of_pair_0_26_choices(8) := is_set(sums_sum_0(26), 7) or (not is_set(sums_sum_0(27), 7));
      end if;
      if is_set(sums_sum_0(28), 0) then
        winnerswinner1_of_pair_0_28_choice := (not is_set(sums_sum_0(29), 1)) or (not is_set(sums_sum_0(29), 0));
      else
        winnerswinner1_of_pair_0_28_choice := not is_set(sums_sum_0(29), 1);
      end if;
      if is_set(sums_sum_0(28), 1) then
        winnerswinner1_of_pair_0_28_choices(2) := winnerswinner1_of_pair_0_28_choice;
      else
        winnerswinner1_of_pair_0_28_choices(2) := is_set(sums_sum_0(28), 0) and ((sums_sum_0(29) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_28_value := is_set(sums_sum_0(29), 2);
      if winnerswinner1_of_pair_0_28_choices(2) then
        winnerswinner1_of_pair_0_28_choices(3) := (not is_set(sums_sum_0(28), 2)) and winnerswinner1_of_pair_0_28_value;
      else
        winnerswinner1_of_pair_0_28_choices(3) := (not is_set(sums_sum_0(28), 2)) or winnerswinner1_of_pair_0_28_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_28_values(i) := is_set(sums_sum_0(29), i + 1);
        if winnerswinner1_of_pair_0_28_choices(i + 1) then
          winnerswinner1_of_pair_0_28_choices(i + 2) := (not is_set(sums_sum_0(28), i + 1)) or
            winnerswinner1_of_pair_0_28_values(i);
        else
          winnerswinner1_of_pair_0_28_choices(i + 2) := (not is_set(sums_sum_0(28), i + 1)) and
            winnerswinner1_of_pair_0_28_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_28_choices(7) then
        winnerswinner1_of_pair_0_28_choices(8) := is_set(sums_sum_0(28), 7) and (not is_set(sums_sum_0(29), 7));
      else
        winnerswinner1_of_pair_0_28_choices(8) := is_set(sums_sum_0(28), 7) or (not is_set(sums_sum_0(29), 7));
      end if;
      if is_set(sums_sum_0(30), 0) then
        winnerswinner1_of_pair_0_30_choice := (not is_set(sums_sum_0(31), 1)) or (not is_set(sums_sum_0(31), 0));
      else
        winnerswinner1_of_pair_0_30_choice := not is_set(sums_sum_0(31), 1);
      end if;
      if is_set(sums_sum_0(30), 1) then
        winnerswinner1_of_pair_0_30_choices(2) := winnerswinner1_of_pair_0_30_choice;
      else
        winnerswinner1_of_pair_0_30_choices(2) := is_set(sums_sum_0(30), 0) and ((sums_sum_0(31) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_30_value := is_set(sums_sum_0(31), 2);
      if winnerswinner1_of_pair_0_30_choices(2) then
        winnerswinner1_of_pair_0_30_choices(3) := (not is_set(sums_sum_0(30), 2)) and winnerswinner1_of_pair_0_30_value;
      else
        winnerswinner1_of_pair_0_30_choices(3) := (not is_set(sums_sum_0(30), 2)) or winnerswinner1_of_pair_0_30_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_30_values(i) := is_set(sums_sum_0(31), i + 1);
        if winnerswinner1_of_pair_0_30_choices(i + 1) then
          winnerswinner1_of_pair_0_30_choices(i + 2) := (not is_set(sums_sum_0(30), i + 1)) or
            winnerswinner1_of_pair_0_30_values(i);
        else
          winnerswinner1_of_pair_0_30_choices(i + 2) := (not is_set(sums_sum_0(30), i + 1)) and
            winnerswinner1_of_pair_0_30_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_30_choices(7) then
        winnerswinner1_of_pair_0_30_choices(8) := is_set(sums_sum_0(30), 7) and (not is_set(sums_sum_0(31), 7));
      else
        winnerswinner1_of_pair_0_30_choices(8) := is_set(sums_sum_0(30), 7) or (not is_set(sums_sum_0(31), 7));
      end if;
      if is_set(sums_sum_0(32), 0) then
        winnerswinner1_of_pair_0_32_choice := (not is_set(sums_sum_0(33), 1)) or (not is_set(sums_sum_0(33), 0));
      else
        winnerswinner1_of_pair_0_32_choice := not is_set(sums_sum_0(33), 1);
      end if;
      if is_set(sums_sum_0(32), 1) then
        winnerswinner1_of_pair_0_32_choices(2) := winnerswinner1_of_pair_0_32_choice;
      else
        winnerswinner1_of_pair_0_32_choices(2) := is_set(sums_sum_0(32), 0) and ((sums_sum_0(33) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_32_value := is_set(sums_sum_0(33), 2);
      if winnerswinner1_of_pair_0_32_choices(2) then
        winnerswinner1_of_pair_0_32_choices(3) := (not is_set(sums_sum_0(32), 2)) and winnerswinner1_of_pair_0_32_value;
      else
        winnerswinner1_of_pair_0_32_choices(3) := (not is_set(sums_sum_0(32), 2)) or winnerswinner1_of_pair_0_32_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_32_values(i) := is_set(sums_sum_0(33), i + 1);
        if winnerswinner1_of_pair_0_32_choices(i + 1) then
          winnerswinner1_of_pair_0_32_choices(i + 2) := (not is_set(sums_sum_0(32), i + 1)) or
            winnerswinner1_of_pair_0_32_values(i);
        else
          winnerswinner1_of_pair_0_32_choices(i + 2) := (not is_set(sums_sum_0(32), i + 1)) and
            winnerswinner1_of_pair_0_32_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_32_choices(7) then
        winnerswinner1_of_pair_0_32_choices(8) := is_set(sums_sum_0(32), 7) and (not is_set(sums_sum_0(33), 7));
      else
        winnerswinner1_of_pair_0_32_choices(8) := is_set(sums_sum_0(32), 7) or (not is_set(sums_sum_0(33), 7));
      end if;
      if is_set(sums_sum_0(34), 0) then
        winnerswinner1_of_pair_0_34_choice := (not is_set(sums_sum_0(35), 1)) or (not is_set(sums_sum_0(35), 0));
      else
        winnerswinner1_of_pair_0_34_choice := not is_set(sums_sum_0(35), 1);
      end if;
      if is_set(sums_sum_0(34), 1) then
        winnerswinner1_of_pair_0_34_choices(2) := winnerswinner1_of_pair_0_34_choice;
      else
        winnerswinner1_of_pair_0_34_choices(2) := is_set(sums_sum_0(34), 0) and ((sums_sum_0(35) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_34_value := is_set(sums_sum_0(35), 2);
      if winnerswinner1_of_pair_0_34_choices(2) then
        winnerswinner1_of_pair_0_34_choices(3) := (not is_set(sums_sum_0(34), 2)) and winnerswinner1_of_pair_0_34_value;
      else
        winnerswinner1_of_pair_0_34_choices(3) := (not is_set(sums_sum_0(34), 2)) or winnerswinner1_of_pair_0_34_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_34_values(i) := is_set(sums_sum_0(35), i + 1);
        if winnerswinner1_of_pair_0_34_choices(i + 1) then
          winnerswinner1_of_pair_0_34_choices(i + 2) := (not is_set(sums_sum_0(34), i + 1)) or
            winnerswinner1_of_pair_0_34_values(i);
        else
          winnerswinner1_of_pair_0_34_choices(i + 2) := (not is_set(sums_sum_0(34), i + 1)) and
            winnerswinner1_of_pair_0_34_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_34_choices(7) then
        winnerswinner1_of_pair_0_34_choices(8) := is_set(sums_sum_0(34), 7) and (not is_set(sums_sum_0(35), 7));
      else
        winnerswinner1_of_pair_0_34_choices(8) := is_set(sums_sum_0(34), 7) or (not is_set(sums_sum_0(35), 7));
      end if;
      if is_set(sums_sum_0(36), 0) then
        winnerswinner1_of_pair_0_36_choice := (not is_set(sums_sum_0(37), 1)) or (not is_set(sums_sum_0(37), 0));
      else
        winnerswinner1_of_pair_0_36_choice := not is_set(sums_sum_0(37), 1);
      end if;
      if is_set(sums_sum_0(36), 1) then
        winnerswinner1_of_pair_0_36_choices(2) := winnerswinner1_of_pair_0_36_choice;
      else
        winnerswinner1_of_pair_0_36_choices(2) := is_set(sums_sum_0(36), 0) and ((sums_sum_0(37) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_36_value := is_set(sums_sum_0(37), 2);
      if winnerswinner1_of_pair_0_36_choices(2) then
        winnerswinner1_of_pair_0_36_choices(3) := (not is_set(sums_sum_0(36), 2)) and winnerswinner1_of_pair_0_36_value;
      else
        winnerswinner1_of_pair_0_36_choices(3) := (not is_set(sums_sum_0(36), 2)) or winnerswinner1_of_pair_0_36_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_36_values(i) := is_set(sums_sum_0(37), i + 1);
        if winnerswinner1_of_pair_0_36_choices(i + 1) then
          winnerswinner1_of_pair_0_36_choices(i + 2) := (not is_set(sums_sum_0(36), i + 1)) or
            winnerswinner1_of_pair_0_36_values(i);
        else
          winnerswinner1_of_pair_0_36_choices(i + 2) := (not is_set(sums_sum_0(36), i + 1)) and
            winnerswinner1_of_pair_0_36_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_36_choices(7) then
        winnerswinner1_of_pair_0_36_choices(8) := is_set(sums_sum_0(36), 7) and (not is_set(sums_sum_0(37), 7));
      else
        winnerswinner1_of_pair_0_36_choices(8) := is_set(sums_sum_0(36), 7) or (not is_set(sums_sum_0(37), 7));
      end if;
      if is_set(sums_sum_0(38), 0) then
        winnerswinner1_of_pair_0_38_choice := (not is_set(sums_sum_0(39), 1)) or (not is_set(sums_sum_0(39), 0));
      else
        winnerswinner1_of_pair_0_38_choice := not is_set(sums_sum_0(39), 1);
      end if;
      if is_set(sums_sum_0(38), 1) then
        winnerswinner1_of_pair_0_38_choices(2) := winnerswinner1_of_pair_0_38_choice;
      else
        winnerswinner1_of_pair_0_38_choices(2) := is_set(sums_sum_0(38), 0) and ((sums_sum_0(39) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_38_value := is_set(sums_sum_0(39), 2);
      if winnerswinner1_of_pair_0_38_choices(2) then
        winnerswinner1_of_pair_0_38_choices(3) := (not is_set(sums_sum_0(38), 2)) and winnerswinner1_of_pair_0_38_value;
      else
        winnerswinner1_of_pair_0_38_choices(3) := (not is_set(sums_sum_0(38), 2)) or winnerswinner1_of_pair_0_38_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_38_values(i) := is_set(sums_sum_0(39), i + 1);
        if winnerswinner1_of_pair_0_38_choices(i + 1) then
          winnerswinner1_of_pair_0_38_choices(i + 2) := (not is_set(sums_sum_0(38), i + 1)) or
            winnerswinner1_of_pair_0_38_values(i);
        else
          winnerswinner1_of_pair_0_38_choices(i + 2) := (not is_set(sums_sum_0(38), i + 1)) and
            winnerswinner1_of_pair_0_38_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_38_choices(7) then
        winnerswinner1_of_pair_0_38_choices(8) := is_set(sums_sum_0(38), 7) and (not is_set(sums_sum_0(39), 7));
      else
        winnerswinner1_of_pair_0_38_choices(8) := is_set(sums_sum_0(38), 7) or (not is_set(sums_sum_0(39), 7));
      end if;
      if is_set(sums_sum_0(40), 0) then
        winnerswinner1_of_pair_0_40_choice := (not is_set(sums_sum_0(41), 1)) or (not is_set(sums_sum_0(41), 0));
      else
        winnerswinner1_of_pair_0_40_choice := not is_set(sums_sum_0(41), 1);
      end if;
      if is_set(sums_sum_0(40), 1) then
        winnerswinner1_of_pair_0_40_choices(2) := winnerswinner1_of_pair_0_40_choice;
      else
        winnerswinner1_of_pair_0_40_choices(2) := is_set(sums_sum_0(40), 0) and ((sums_sum_0(41) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_40_value := is_set(sums_sum_0(41), 2);
      if winnerswinner1_of_pair_0_40_choices(2) then
        winnerswinner1_of_pair_0_40_choices(3) := (not is_set(sums_sum_0(40), 2)) and winnerswinner1_of_pair_0_40_value;
      else
        winnerswinner1_of_pair_0_40_choices(3) := (not is_set(sums_sum_0(40), 2)) or winnerswinner1_of_pair_0_40_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_40_values(i) := is_set(sums_sum_0(41), i + 1);
        if winnerswinner1_of_pair_0_40_choices(i + 1) then
          winnerswinner1_of_pair_0_40_choices(i + 2) := (not is_set(sums_sum_0(40), i + 1)) or
            winnerswinner1_of_pair_0_40_values(i);
        else
          winnerswinner1_of_pair_0_40_choices(i + 2) := (not is_set(sums_sum_0(40), i + 1)) and
            winnerswinner1_of_pair_0_40_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_40_choices(7) then
        winnerswinner1_of_pair_0_40_choices(8) := is_set(sums_sum_0(40), 7) and (not is_set(sums_sum_0(41), 7));
      else
        winnerswinner1_of_pair_0_40_choices(8) := is_set(sums_sum_0(40), 7) or (not is_set(sums_sum_0(41), 7));
      end if;
      if is_set(sums_sum_0(42), 0) then
        winnerswinner1_of_pair_0_42_choice := (not is_set(sums_sum_0(43), 1)) or (not is_set(sums_sum_0(43), 0));
      else
        winnerswinner1_of_pair_0_42_choice := not is_set(sums_sum_0(43), 1);
      end if;
      if is_set(sums_sum_0(42), 1) then
        winnerswinner1_of_pair_0_42_choices(2) := winnerswinner1_of_pair_0_42_choice;
      else
        winnerswinner1_of_pair_0_42_choices(2) := is_set(sums_sum_0(42), 0) and ((sums_sum_0(43) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_42_value := is_set(sums_sum_0(43), 2);
      if winnerswinner1_of_pair_0_42_choices(2) then
        winnerswinner1_of_pair_0_42_choices(3) := (not is_set(sums_sum_0(42), 2)) and winnerswinner1_of_pair_0_42_value;
      else
        winnerswinner1_of_pair_0_42_choices(3) := (not is_set(sums_sum_0(42), 2)) or winnerswinner1_of_pair_0_42_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_42_values(i) := is_set(sums_sum_0(43), i + 1);
        if winnerswinner1_of_pair_0_42_choices(i + 1) then
          winnerswinner1_of_pair_0_42_choices(i + 2) := (not is_set(sums_sum_0(42), i + 1)) or
            winnerswinner1_of_pair_0_42_values(i);
        else
          winnerswinner1_of_pair_0_42_choices(i + 2) := (not is_set(sums_sum_0(42), i + 1)) and
            winnerswinner1_of_pair_0_42_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_42_choices(7) then
        winnerswinner1_of_pair_0_42_choices(8) := is_set(sums_sum_0(42), 7) and (not is_set(sums_sum_0(43), 7));
      else
        winnerswinner1_of_pair_0_42_choices(8) := is_set(sums_sum_0(42), 7) or (not is_set(sums_sum_0(43), 7));
      end if;
      if is_set(sums_sum_0(44), 0) then
        winnerswinner1_of_pair_0_44_choice := (not is_set(sums_sum_0(45), 1)) or (not is_set(sums_sum_0(45), 0));
      else
        winnerswinner1_of_pair_0_44_choice := not is_set(sums_sum_0(45), 1);
      end if;
      if is_set(sums_sum_0(44), 1) then
        winnerswinner1_of_pair_0_44_choices(2) := winnerswinner1_of_pair_0_44_choice;
      else
        winnerswinner1_of_pair_0_44_choices(2) := is_set(sums_sum_0(44), 0) and ((sums_sum_0(45) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_44_value := is_set(sums_sum_0(45), 2);
      if winnerswinner1_of_pair_0_44_choices(2) then
        winnerswinner1_of_pair_0_44_choices(3) := (not is_set(sums_sum_0(44), 2)) and winnerswinner1_of_pair_0_44_value;
      else
        winnerswinner1_of_pair_0_44_choices(3) := (not is_set(sums_sum_0(44), 2)) or winnerswinner1_of_pair_0_44_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_44_values(i) := is_set(sums_sum_0(45), i + 1);
        if winnerswinner1_of_pair_0_44_choices(i + 1) then
          winnerswinner1_of_pair_0_44_choices(i + 2) := (not is_set(sums_sum_0(44), i + 1)) or
            winnerswinner1_of_pair_0_44_values(i);
        else
          winnerswinner1_of_pair_0_44_choices(i + 2) := (not is_set(sums_sum_0(44), i + 1)) and
            winnerswinner1_of_pair_0_44_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_44_choices(7) then
        winnerswinner1_of_pair_0_44_choices(8) := is_set(sums_sum_0(44), 7) and (not is_set(sums_sum_0(45), 7));
      else
        winnerswinner1_of_pair_0_44_choices(8) := is_set(sums_sum_0(44), 7) or (not is_set(sums_sum_0(45), 7));
      end if;
      if is_set(sums_sum_0(46), 0) then
        winnerswinner1_of_pair_0_46_choice := (not is_set(sums_sum_0(47), 1)) or (not is_set(sums_sum_0(47), 0));
      else
        winnerswinner1_of_pair_0_46_choice := not is_set(sums_sum_0(47), 1);
      end if;
      if is_set(sums_sum_0(46), 1) then
        winnerswinner1_of_pair_0_46_choices(2) := winnerswinner1_of_pair_0_46_choice;
      else
        winnerswinner1_of_pair_0_46_choices(2) := is_set(sums_sum_0(46), 0) and ((sums_sum_0(47) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_46_value := is_set(sums_sum_0(47), 2);
      if winnerswinner1_of_pair_0_46_choices(2) then
        winnerswinner1_of_pair_0_46_choices(3) := (not is_set(sums_sum_0(46), 2)) and winnerswinner1_of_pair_0_46_value;
      else
        winnerswinner1_of_pair_0_46_choices(3) := (not is_set(sums_sum_0(46), 2)) or winnerswinner1_of_pair_0_46_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_46_values(i) := is_set(sums_sum_0(47), i + 1);
        if winnerswinner1_of_pair_0_46_choices(i + 1) then
          winnerswinner1_of_pair_0_46_choices(i + 2) := (not is_set(sums_sum_0(46), i + 1)) or
            winnerswinner1_of_pair_0_46_values(i);
        else
          winnerswinner1_of_pair_0_46_choices(i + 2) := (not is_set(sums_sum_0(46), i + 1)) and
            winnerswinner1_of_pair_0_46_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_46_choices(7) then
        winnerswinner1_of_pair_0_46_choices(8) := is_set(sums_sum_0(46), 7) and (not is_set(sums_sum_0(47), 7));
      else
        winnerswinner1_of_pair_0_46_choices(8) := is_set(sums_sum_0(46), 7) or (not is_set(sums_sum_0(47), 7));
      end if;
      if is_set(sums_sum_0(48), 0) then
        winnerswinner1_of_pair_0_48_choice := (not is_set(sums_sum_0(49), 1)) or (not is_set(sums_sum_0(49), 0));
      else
        winnerswinner1_of_pair_0_48_choice := not is_set(sums_sum_0(49), 1);
      end if;
      if is_set(sums_sum_0(48), 1) then
        winnerswinner1_of_pair_0_48_choices(2) := winnerswinner1_of_pair_0_48_choice;
      else
        winnerswinner1_of_pair_0_48_choices(2) := is_set(sums_sum_0(48), 0) and ((sums_sum_0(49) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_48_value := is_set(sums_sum_0(49), 2);
      if winnerswinner1_of_pair_0_48_choices(2) then
        winnerswinner1_of_pair_0_48_choices(3) := (not is_set(sums_sum_0(48), 2)) and winnerswinner1_of_pair_0_48_value;
      else
        winnerswinner1_of_pair_0_48_choices(3) := (not is_set(sums_sum_0(48), 2)) or winnerswinner1_of_pair_0_48_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_48_values(i) := is_set(sums_sum_0(49), i + 1);
        if winnerswinner1_of_pair_0_48_choices(i + 1) then
          winnerswinner1_of_pair_0_48_choices(i + 2) := (not is_set(sums_sum_0(48), i + 1)) or
            winnerswinner1_of_pair_0_48_values(i);
        else
          winnerswinner1_of_pair_0_48_choices(i + 2) := (not is_set(sums_sum_0(48), i + 1)) and
            winnerswinner1_of_pair_0_48_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_48_choices(7) then
        winnerswinner1_of_pair_0_48_choices(8) := is_set(sums_sum_0(48), 7) and (not is_set(sums_sum_0(49), 7));
      else
        winnerswinner1_of_pair_0_48_choices(8) := is_set(sums_sum_0(48), 7) or (not is_set(sums_sum_0(49), 7));
      end if;
      if is_set(sums_sum_0(50), 0) then
        winnerswinner1_of_pair_0_50_choice := (not is_set(sums_sum_0(51), 1)) or (not is_set(sums_sum_0(51), 0));
      else
        winnerswinner1_of_pair_0_50_choice := not is_set(sums_sum_0(51), 1);
      end if;
      if is_set(sums_sum_0(50), 1) then
        winnerswinner1_of_pair_0_50_choices(2) := winnerswinner1_of_pair_0_50_choice;
      else
        winnerswinner1_of_pair_0_50_choices(2) := is_set(sums_sum_0(50), 0) and ((sums_sum_0(51) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_50_value := is_set(sums_sum_0(51), 2);
      if winnerswinner1_of_pair_0_50_choices(2) then
        winnerswinner1_of_pair_0_50_choices(3) := (not is_set(sums_sum_0(50), 2)) and winnerswinner1_of_pair_0_50_value;
      else
        winnerswinner1_of_pair_0_50_choices(3) := (not is_set(sums_sum_0(50), 2)) or winnerswinner1_of_pair_0_50_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_50_values(i) := is_set(sums_sum_0(51), i + 1);
        if winnerswinner1_of_pair_0_50_choices(i + 1) then
          winnerswinner1_of_pair_0_50_choices(i + 2) := (not is_set(sums_sum_0(50), i + 1)) or
            winnerswinner1_of_pair_0_50_values(i);
        else
          winnerswinner1_of_pair_0_50_choices(i + 2) := (not is_set(sums_sum_0(50), i + 1)) and
            winnerswinner1_of_pair_0_50_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_50_choices(7) then
        winnerswinner1_of_pair_0_50_choices(8) := is_set(sums_sum_0(50), 7) and (not is_set(sums_sum_0(51), 7));
      else
        winnerswinner1_of_pair_0_50_choices(8) := is_set(sums_sum_0(50), 7) or (not is_set(sums_sum_0(51), 7));
      end if;
      if is_set(sums_sum_0(52), 0) then
        winnerswinner1_of_pair_0_52_choice := (not is_set(sums_sum_0(53), 1)) or (not is_set(sums_sum_0(53), 0));
      else
        winnerswinner1_of_pair_0_52_choice := not is_set(sums_sum_0(53), 1);
      end if;
      if is_set(sums_sum_0(52), 1) then
        winnerswinner1_of_pair_0_52_choices(2) := winnerswinner1_of_pair_0_52_choice;
      else
        winnerswinner1_of_pair_0_52_choices(2) := is_set(sums_sum_0(52), 0) and ((sums_sum_0(53) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_52_value := is_set(sums_sum_0(53), 2);
      if winnerswinner1_of_pair_0_52_choices(2) then
        winnerswinner1_of_pair_0_52_choices(3) := (not is_set(sums_sum_0(52), 2)) and winnerswinner1_of_pair_0_52_value;
      else
        winnerswinner1_of_pair_0_52_choices(3) := (not is_set(sums_sum_0(52), 2)) or winnerswinner1_of_pair_0_52_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_52_values(i) := is_set(sums_sum_0(53), i + 1);
        if winnerswinner1_of_pair_0_52_choices(i + 1) then
          winnerswinner1_of_pair_0_52_choices(i + 2) := (not is_set(sums_sum_0(52), i + 1)) or
            winnerswinner1_of_pair_0_52_values(i);
        else
          winnerswinner1_of_pair_0_52_choices(i + 2) := (not is_set(sums_sum_0(52), i + 1)) and
            winnerswinner1_of_pair_0_52_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_52_choices(7) then
        winnerswinner1_of_pair_0_52_choices(8) := is_set(sums_sum_0(52), 7) and (not is_set(sums_sum_0(53), 7));
      else
        winnerswinner1_of_pair_0_52_choices(8) := is_set(sums_sum_0(52), 7) or (not is_set(sums_sum_0(53), 7));
      end if;
      if is_set(sums_sum_0(54), 0) then
        winnerswinner1_of_pair_0_54_choice := (not is_set(sums_sum_0(55), 1)) or (not is_set(sums_sum_0(55), 0));
      else
        winnerswinner1_of_pair_0_54_choice := not is_set(sums_sum_0(55), 1);
      end if;
      if is_set(sums_sum_0(54), 1) then
        winnerswinner1_of_pair_0_54_choices(2) := winnerswinner1_of_pair_0_54_choice;
      else
        winnerswinner1_of_pair_0_54_choices(2) := is_set(sums_sum_0(54), 0) and ((sums_sum_0(55) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_54_value := is_set(sums_sum_0(55), 2);
      if winnerswinner1_of_pair_0_54_choices(2) then
        winnerswinner1_of_pair_0_54_choices(3) := (not is_set(sums_sum_0(54), 2)) and winnerswinner1_of_pair_0_54_value;
      else
        winnerswinner1_of_pair_0_54_choices(3) := (not is_set(sums_sum_0(54), 2)) or winnerswinner1_of_pair_0_54_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_54_values(i) := is_set(sums_sum_0(55), i + 1);
        if winnerswinner1_of_pair_0_54_choices(i + 1) then
          winnerswinner1_of_pair_0_54_choices(i + 2) := (not is_set(sums_sum_0(54), i + 1)) or
            winnerswinner1_of_pair_0_54_values(i);
        else
          winnerswinner1_of_pair_0_54_choices(i + 2) := (not is_set(sums_sum_0(54), i + 1)) and
            winnerswinner1_of_pair_0_54_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_54_choices(7) then
        winnerswinner1_of_pair_0_54_choices(8) := is_set(sums_sum_0(54), 7) and (not is_set(sums_sum_0(55), 7));
      else
        winnerswinner1_of_pair_0_54_choices(8) := is_set(sums_sum_0(54), 7) or (not is_set(sums_sum_0(55), 7));
      end if;
      if is_set(sums_sum_0(56), 0) then
        winnerswinner1_of_pair_0_56_choice := (not is_set(sums_sum_0(57), 1)) or (not is_set(sums_sum_0(57), 0));
      else
        winnerswinner1_of_pair_0_56_choice := not is_set(sums_sum_0(57), 1);
      end if;
      if is_set(sums_sum_0(56), 1) then
        winnerswinner1_of_pair_0_56_choices(2) := winnerswinner1_of_pair_0_56_choice;
      else
        winnerswinner1_of_pair_0_56_choices(2) := is_set(sums_sum_0(56), 0) and ((sums_sum_0(57) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_56_value := is_set(sums_sum_0(57), 2);
      if winnerswinner1_of_pair_0_56_choices(2) then
        winnerswinner1_of_pair_0_56_choices(3) := (not is_set(sums_sum_0(56), 2)) and winnerswinner1_of_pair_0_56_value;
      else
        winnerswinner1_of_pair_0_56_choices(3) := (not is_set(sums_sum_0(56), 2)) or winnerswinner1_of_pair_0_56_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_56_values(i) := is_set(sums_sum_0(57), i + 1);
        if winnerswinner1_of_pair_0_56_choices(i + 1) then
          winnerswinner1_of_pair_0_56_choices(i + 2) := (not is_set(sums_sum_0(56), i + 1)) or
            winnerswinner1_of_pair_0_56_values(i);
        else
          winnerswinner1_of_pair_0_56_choices(i + 2) := (not is_set(sums_sum_0(56), i + 1)) and
            winnerswinner1_of_pair_0_56_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_56_choices(7) then
        winnerswinner1_of_pair_0_56_choices(8) := is_set(sums_sum_0(56), 7) and (not is_set(sums_sum_0(57), 7));
      else
        winnerswinner1_of_pair_0_56_choices(8) := is_set(sums_sum_0(56), 7) or (not is_set(sums_sum_0(57), 7));
      end if;
      if is_set(sums_sum_0(58), 0) then
        winnerswinner1_of_pair_0_58_choice := (not is_set(sums_sum_0(59), 1)) or (not is_set(sums_sum_0(59), 0));
      else
        winnerswinner1_of_pair_0_58_choice := not is_set(sums_sum_0(59), 1);
      end if;
      if is_set(sums_sum_0(58), 1) then
        winnerswinner1_of_pair_0_58_choices(2) := winnerswinner1_of_pair_0_58_choice;
      else
        winnerswinner1_of_pair_0_58_choices(2) := is_set(sums_sum_0(58), 0) and ((sums_sum_0(59) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_58_value := is_set(sums_sum_0(59), 2);
      if winnerswinner1_of_pair_0_58_choices(2) then
        winnerswinner1_of_pair_0_58_choices(3) := (not is_set(sums_sum_0(58), 2)) and winnerswinner1_of_pair_0_58_value;
      else
        winnerswinner1_of_pair_0_58_choices(3) := (not is_set(sums_sum_0(58), 2)) or winnerswinner1_of_pair_0_58_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_58_values(i) := is_set(sums_sum_0(59), i + 1);
        if winnerswinner1_of_pair_0_58_choices(i + 1) then
          winnerswinner1_of_pair_0_58_choices(i + 2) := (not is_set(sums_sum_0(58), i + 1)) or
            winnerswinner1_of_pair_0_58_values(i);
        else
          winnerswinner1_of_pair_0_58_choices(i + 2) := (not is_set(sums_sum_0(58), i + 1)) and
            winnerswinner1_of_pair_0_58_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_58_choices(7) then
        winnerswinner1_of_pair_0_58_choices(8) := is_set(sums_sum_0(58), 7) and (not is_set(sums_sum_0(59), 7));
      else
        winnerswinner1_of_pair_0_58_choices(8) := is_set(sums_sum_0(58), 7) or (not is_set(sums_sum_0(59), 7));
      end if;
      if is_set(sums_sum_0(60), 0) then
        winnerswinner1_of_pair_0_60_choice := (not is_set(sums_sum_0(61), 1)) or (not is_set(sums_sum_0(61), 0));
      else
        winnerswinner1_of_pair_0_60_choice := not is_set(sums_sum_0(61), 1);
      end if;
      if is_set(sums_sum_0(60), 1) then
        winnerswinner1_of_pair_0_60_choices(2) := winnerswinner1_of_pair_0_60_choice;
      else
        winnerswinner1_of_pair_0_60_choices(2) := is_set(sums_sum_0(60), 0) and ((sums_sum_0(61) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_60_value := is_set(sums_sum_0(61), 2);
      if winnerswinner1_of_pair_0_60_choices(2) then
        winnerswinner1_of_pair_0_60_choices(3) := (not is_set(sums_sum_0(60), 2)) and winnerswinner1_of_pair_0_60_value;
      else
        winnerswinner1_of_pair_0_60_choices(3) := (not is_set(sums_sum_0(60), 2)) or winnerswinner1_of_pair_0_60_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_60_values(i) := is_set(sums_sum_0(61), i + 1);
        if winnerswinner1_of_pair_0_60_choices(i + 1) then
          winnerswinner1_of_pair_0_60_choices(i + 2) := (not is_set(sums_sum_0(60), i + 1)) or
            winnerswinner1_of_pair_0_60_values(i);
        else
          winnerswinner1_of_pair_0_60_choices(i + 2) := (not is_set(sums_sum_0(60), i + 1)) and
            winnerswinner1_of_pair_0_60_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_60_choices(7) then
        winnerswinner1_of_pair_0_60_choices(8) := is_set(sums_sum_0(60), 7) and (not is_set(sums_sum_0(61), 7));
      else
        winnerswinner1_of_pair_0_60_choices(8) := is_set(sums_sum_0(60), 7) or (not is_set(sums_sum_0(61), 7));
      end if;
      if is_set(sums_sum_0(62), 0) then
        winnerswinner1_of_pair_0_62_choice := (not is_set(sums_sum_0(63), 1)) or (not is_set(sums_sum_0(63), 0));
      else
        winnerswinner1_of_pair_0_62_choice := not is_set(sums_sum_0(63), 1);
      end if;
      if is_set(sums_sum_0(62), 1) then
        winnerswinner1_of_pair_0_62_choices(2) := winnerswinner1_of_pair_0_62_choice;
      else
        winnerswinner1_of_pair_0_62_choices(2) := is_set(sums_sum_0(62), 0) and ((sums_sum_0(63) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_62_value := is_set(sums_sum_0(63), 2);
      if winnerswinner1_of_pair_0_62_choices(2) then
        winnerswinner1_of_pair_0_62_choices(3) := (not is_set(sums_sum_0(62), 2)) and winnerswinner1_of_pair_0_62_value;
      else
        winnerswinner1_of_pair_0_62_choices(3) := (not is_set(sums_sum_0(62), 2)) or winnerswinner1_of_pair_0_62_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner1_of_pair_0_62_values(i) := is_set(sums_sum_0(63), i + 1);
        if winnerswinner1_of_pair_0_62_choices(i + 1) then
          winnerswinner1_of_pair_0_62_choices(i + 2) := (not is_set(sums_sum_0(62), i + 1)) or
            winnerswinner1_of_pair_0_62_values(i);
        else
          winnerswinner1_of_pair_0_62_choices(i + 2) := (not is_set(sums_sum_0(62), i + 1)) and
            winnerswinner1_of_pair_0_62_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_62_choices(7) then
        winnerswinner1_of_pair_0_62_choices(8) := is_set(sums_sum_0(62), 7) and (not is_set(sums_sum_0(63), 7));
      else
        winnerswinner1_of_pair_0_62_choices(8) := is_set(sums_sum_0(62), 7) or (not is_set(sums_sum_0(63), 7));
      end if;
      if is_set(winnerswinner1_of_pair_0(1), 0) then
        winnerswinner1_of_four_0_0_choice := (not is_set(winnerswinner1_of_pair_0(3), 0)) and (not
          is_set(winnerswinner1_of_pair_0(2), 0));
      else
        winnerswinner1_of_four_0_0_choice := is_set(winnerswinner1_of_pair_0(0), 0) and (not
          is_set(winnerswinner1_of_pair_0(3), 0)) and (not is_set(winnerswinner1_of_pair_0(2), 0));
      end if;
      winnerswinner1_of_four_0_0_value := is_set(winnerswinner1_of_pair_0(1), 1);
      winnerswinner1_of_four_0_0_values(2) := is_set(winnerswinner1_of_pair_0(0), 1);
      if (not is_set(winnerswinner1_of_pair_0(3), 1)) and (not is_set(winnerswinner1_of_pair_0(2), 1)) then
        winnerswinner1_of_four_0_0_choices(2) := winnerswinner1_of_four_0_0_choice or winnerswinner1_of_four_0_0_value
          or winnerswinner1_of_four_0_0_values(2);
      else
        winnerswinner1_of_four_0_0_choices(2) := winnerswinner1_of_four_0_0_choice and
          (winnerswinner1_of_four_0_0_value or winnerswinner1_of_four_0_0_values(2));
      end if;
      winnerswinner1_of_four_0_0_values(3) := is_set(winnerswinner1_of_pair_0(3), 2);
      winnerswinner1_of_four_0_0_values(4) := is_set(winnerswinner1_of_pair_0(2), 2);
      if winnerswinner1_of_four_0_0_choices(2) then
        winnerswinner1_of_four_0_0_choices(3) := (not is_set(winnerswinner1_of_pair_0(1), 2)) and (not
          is_set(winnerswinner1_of_pair_0(0), 2)) and (winnerswinner1_of_four_0_0_values(3) or
          winnerswinner1_of_four_0_0_values(4));
      else
        winnerswinner1_of_four_0_0_choices(3) := ((not is_set(winnerswinner1_of_pair_0(1), 2)) and (not
          is_set(winnerswinner1_of_pair_0(0), 2))) or winnerswinner1_of_four_0_0_values(3) or
          winnerswinner1_of_four_0_0_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_0_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(3), i);
        winnerswinner1_of_four_0_0_values(2 * i) := is_set(winnerswinner1_of_pair_0(2), i);
        if winnerswinner1_of_four_0_0_choices(i) then
          winnerswinner1_of_four_0_0_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(1), i)) and (not
            is_set(winnerswinner1_of_pair_0(0), i))) or winnerswinner1_of_four_0_0_values(2 * i - 1) or
            winnerswinner1_of_four_0_0_values(2 * i);
        else
          winnerswinner1_of_four_0_0_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(1), i)) and (not
            is_set(winnerswinner1_of_pair_0(0), i)) and (winnerswinner1_of_four_0_0_values(2 * i - 1) or
            winnerswinner1_of_four_0_0_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_0_choices(7) then
        winnerswinner1_of_four_0_0_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(1), 7)) and (not
          is_set(winnerswinner1_of_pair_0(0), 7)))) and (not is_set(winnerswinner1_of_pair_0(3), 7)) and (not
          is_set(winnerswinner1_of_pair_0(2), 7));
      else
        winnerswinner1_of_four_0_0_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(1), 7)) and (not
          is_set(winnerswinner1_of_pair_0(0), 7)))) or ((not is_set(winnerswinner1_of_pair_0(3), 7)) and (not
          is_set(winnerswinner1_of_pair_0(2), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(5), 0) then
        winnerswinner1_of_four_0_4_choice := (not is_set(winnerswinner1_of_pair_0(7), 0)) and (not
          is_set(winnerswinner1_of_pair_0(6), 0));
      else
        winnerswinner1_of_four_0_4_choice := is_set(winnerswinner1_of_pair_0(4), 0) and (not
          is_set(winnerswinner1_of_pair_0(7), 0)) and (not is_set(winnerswinner1_of_pair_0(6), 0));
      end if;
      winnerswinner1_of_four_0_4_value := is_set(winnerswinner1_of_pair_0(5), 1);
      winnerswinner1_of_four_0_4_values(2) := is_set(winnerswinner1_of_pair_0(4), 1);
      if (not is_set(winnerswinner1_of_pair_0(7), 1)) and (not is_set(winnerswinner1_of_pair_0(6), 1)) then
        winnerswinner1_of_four_0_4_choices(2) := winnerswinner1_of_four_0_4_choice or winnerswinner1_of_four_0_4_value
          or winnerswinner1_of_four_0_4_values(2);
      else
        winnerswinner1_of_four_0_4_choices(2) := winnerswinner1_of_four_0_4_choice and
          (winnerswinner1_of_four_0_4_value or winnerswinner1_of_four_0_4_values(2));
      end if;
      winnerswinner1_of_four_0_4_values(3) := is_set(winnerswinner1_of_pair_0(7), 2);
      winnerswinner1_of_four_0_4_values(4) := is_set(winnerswinner1_of_pair_0(6), 2);
      if winnerswinner1_of_four_0_4_choices(2) then
        winnerswinner1_of_four_0_4_choices(3) := (not is_set(winnerswinner1_of_pair_0(5), 2)) and (not
          is_set(winnerswinner1_of_pair_0(4), 2)) and (winnerswinner1_of_four_0_4_values(3) or
          winnerswinner1_of_four_0_4_values(4));
      else
        winnerswinner1_of_four_0_4_choices(3) := ((not is_set(winnerswinner1_of_pair_0(5), 2)) and (not
          is_set(winnerswinner1_of_pair_0(4), 2))) or winnerswinner1_of_four_0_4_values(3) or
          winnerswinner1_of_four_0_4_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_4_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(7), i);
        winnerswinner1_of_four_0_4_values(2 * i) := is_set(winnerswinner1_of_pair_0(6), i);
        if winnerswinner1_of_four_0_4_choices(i) then
          winnerswinner1_of_four_0_4_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(5), i)) and (not
            is_set(winnerswinner1_of_pair_0(4), i))) or winnerswinner1_of_four_0_4_values(2 * i - 1) or
            winnerswinner1_of_four_0_4_values(2 * i);
        else
          winnerswinner1_of_four_0_4_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(5), i)) and (not
            is_set(winnerswinner1_of_pair_0(4), i)) and (winnerswinner1_of_four_0_4_values(2 * i - 1) or
            winnerswinner1_of_four_0_4_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_4_choices(7) then
        winnerswinner1_of_four_0_4_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(5), 7)) and (not
          is_set(winnerswinner1_of_pair_0(4), 7)))) and (not is_set(winnerswinner1_of_pair_0(7), 7)) and (not
          is_set(winnerswinner1_of_pair_0(6), 7));
      else
        winnerswinner1_of_four_0_4_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(5), 7)) and (not
          is_set(winnerswinner1_of_pair_0(4), 7)))) or ((not is_set(winnerswinner1_of_pair_0(7), 7)) and (not
          is_set(winnerswinner1_of_pair_0(6), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(9), 0) then
        winnerswinner1_of_four_0_8_choice := (not is_set(winnerswinner1_of_pair_0(11), 0)) and (not
          is_set(winnerswinner1_of_pair_0(10), 0));
      else
        winnerswinner1_of_four_0_8_choice := is_set(winnerswinner1_of_pair_0(8), 0) and (not
          is_set(winnerswinner1_of_pair_0(11), 0)) and (not is_set(winnerswinner1_of_pair_0(10), 0));
      end if;
      winnerswinner1_of_four_0_8_value := is_set(winnerswinner1_of_pair_0(9), 1);
      winnerswinner1_of_four_0_8_values(2) := is_set(winnerswinner1_of_pair_0(8), 1);
      if (not is_set(winnerswinner1_of_pair_0(11), 1)) and (not is_set(winnerswinner1_of_pair_0(10), 1)) then
        winnerswinner1_of_four_0_8_choices(2) := winnerswinner1_of_four_0_8_choice or winnerswinner1_of_four_0_8_value
          or winnerswinner1_of_four_0_8_values(2);
      else
        winnerswinner1_of_four_0_8_choices(2) := winnerswinner1_of_four_0_8_choice and
          (winnerswinner1_of_four_0_8_value or winnerswinner1_of_four_0_8_values(2));
      end if;
      winnerswinner1_of_four_0_8_values(3) := is_set(winnerswinner1_of_pair_0(11), 2);
      winnerswinner1_of_four_0_8_values(4) := is_set(winnerswinner1_of_pair_0(10), 2);
      if winnerswinner1_of_four_0_8_choices(2) then
        winnerswinner1_of_four_0_8_choices(3) := (not is_set(winnerswinner1_of_pair_0(9), 2)) and (not
          is_set(winnerswinner1_of_pair_0(8), 2)) and (winnerswinner1_of_four_0_8_values(3) or
          winnerswinner1_of_four_0_8_values(4));
      else
        winnerswinner1_of_four_0_8_choices(3) := ((not is_set(winnerswinner1_of_pair_0(9), 2)) and (not
          is_set(winnerswinner1_of_pair_0(8), 2))) or winnerswinner1_of_four_0_8_values(3) or
          winnerswinner1_of_four_0_8_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_8_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(11), i);
        winnerswinner1_of_four_0_8_values(2 * i) := is_set(winnerswinner1_of_pair_0(10), i);
        if winnerswinner1_of_four_0_8_choices(i) then
          winnerswinner1_of_four_0_8_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(9), i)) and (not
            is_set(winnerswinner1_of_pair_0(8), i))) or winnerswinner1_of_four_0_8_values(2 * i - 1) or
            winnerswinner1_of_four_0_8_values(2 * i);
        else
          winnerswinner1_of_four_0_8_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(9), i)) and (not
            is_set(winnerswinner1_of_pair_0(8), i)) and (winnerswinner1_of_four_0_8_values(2 * i - 1) or
            winnerswinner1_of_four_0_8_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_8_choices(7) then
        winnerswinner1_of_four_0_8_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(9), 7)) and (not
          is_set(winnerswinner1_of_pair_0(8), 7)))) and (not is_set(winnerswinner1_of_pair_0(11), 7)) and (not
          is_set(winnerswinner1_of_pair_0(10), 7));
      else
        winnerswinner1_of_four_0_8_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(9), 7)) and (not
          is_set(winnerswinner1_of_pair_0(8), 7)))) or ((not is_set(winnerswinner1_of_pair_0(11), 7)) and (not
          is_set(winnerswinner1_of_pair_0(10), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(13), 0) then
        winnerswinner1_of_four_0_12_choice := (not is_set(winnerswinner1_of_pair_0(15), 0)) and (not
          is_set(winnerswinner1_of_pair_0(14), 0));
      else
        winnerswinner1_of_four_0_12_choice := is_set(winnerswinner1_of_pair_0(12), 0) and (not
          is_set(winnerswinner1_of_pair_0(15), 0)) and (not is_set(winnerswinner1_of_pair_0(14), 0));
      end if;
      winnerswinner1_of_four_0_12_value := is_set(winnerswinner1_of_pair_0(13), 1);
      winnerswinner1_of_four_0_12_values(2) := is_set(winnerswinner1_of_pair_0(12), 1);
      if (not is_set(winnerswinner1_of_pair_0(15), 1)) and (not is_set(winnerswinner1_of_pair_0(14), 1)) then
        winnerswinner1_of_four_0_12_choices(2) := winnerswinner1_of_four_0_12_choice or
          winnerswinner1_of_four_0_12_value or winnerswinner1_of_four_0_12_values(2);
      else
        winnerswinner1_of_four_0_12_choices(2) := winnerswinner1_of_four_0_12_choice and
          (winnerswinner1_of_four_0_12_value or winnerswinner1_of_four_0_12_values(2));
      end if;
      winnerswinner1_of_four_0_12_values(3) := is_set(winnerswinner1_of_pair_0(15), 2);
      winnerswinner1_of_four_0_12_values(4) := is_set(winnerswinner1_of_pair_0(14), 2);
      if winnerswinner1_of_four_0_12_choices(2) then
        winnerswinner1_of_four_0_12_choices(3) := (not is_set(winnerswinner1_of_pair_0(13), 2)) and (not
          is_set(winnerswinner1_of_pair_0(12), 2)) and (winnerswinner1_of_four_0_12_values(3) or
          winnerswinner1_of_four_0_12_values(4));
      else
        winnerswinner1_of_four_0_12_choices(3) := ((not is_set(winnerswinner1_of_pair_0(13), 2)) and (not
          is_set(winnerswinner1_of_pair_0(12), 2))) or winnerswinner1_of_four_0_12_values(3) or
          winnerswinner1_of_four_0_12_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_12_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(15), i);
        winnerswinner1_of_four_0_12_values(2 * i) := is_set(winnerswinner1_of_pair_0(14), i);
        if winnerswinner1_of_four_0_12_choices(i) then
          winnerswinner1_of_four_0_12_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(13), i)) and (not
            is_set(winnerswinner1_of_pair_0(12), i))) or winnerswinner1_of_four_0_12_values(2 * i - 1) or
            winnerswinner1_of_four_0_12_values(2 * i);
        else
          winnerswinner1_of_four_0_12_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(13), i)) and (not
            is_set(winnerswinner1_of_pair_0(12), i)) and (winnerswinner1_of_four_0_12_values(2 * i - 1) or
            winnerswinner1_of_four_0_12_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_12_choices(7) then
        winnerswinner1_of_four_0_12_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(13), 7)) and (not
          is_set(winnerswinner1_of_pair_0(12), 7)))) and (not is_set(winnerswinner1_of_pair_0(15), 7)) and (not
          is_set(winnerswinner1_of_pair_0(14), 7));
      else
        winnerswinner1_of_four_0_12_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(13), 7)) and (not
          is_set(winnerswinner1_of_pair_0(12), 7)))) or ((not is_set(winnerswinner1_of_pair_0(15), 7)) and (not
          is_set(winnerswinner1_of_pair_0(14), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(17), 0) then
        winnerswinner1_of_four_0_16_choice := (not is_set(winnerswinner1_of_pair_0(19), 0)) and (not
          is_set(winnerswinner1_of_pair_0(18), 0));
      else
        winnerswinner1_of_four_0_16_choice := is_set(winnerswinner1_of_pair_0(16), 0) and (not
          is_set(winnerswinner1_of_pair_0(19), 0)) and (not is_set(winnerswinner1_of_pair_0(18), 0));
      end if;
      winnerswinner1_of_four_0_16_value := is_set(winnerswinner1_of_pair_0(17), 1);
      winnerswinner1_of_four_0_16_values(2) := is_set(winnerswinner1_of_pair_0(16), 1);
      if (not is_set(winnerswinner1_of_pair_0(19), 1)) and (not is_set(winnerswinner1_of_pair_0(18), 1)) then
        winnerswinner1_of_four_0_16_choices(2) := winnerswinner1_of_four_0_16_choice or
          winnerswinner1_of_four_0_16_value or winnerswinner1_of_four_0_16_values(2);
      else
        winnerswinner1_of_four_0_16_choices(2) := winnerswinner1_of_four_0_16_choice and
          (winnerswinner1_of_four_0_16_value or winnerswinner1_of_four_0_16_values(2));
      end if;
      winnerswinner1_of_four_0_16_values(3) := is_set(winnerswinner1_of_pair_0(19), 2);
      winnerswinner1_of_four_0_16_values(4) := is_set(winnerswinner1_of_pair_0(18), 2);
      if winnerswinner1_of_four_0_16_choices(2) then
        winnerswinner1_of_four_0_16_choices(3) := (not is_set(winnerswinner1_of_pair_0(17), 2)) and (not
          is_set(winnerswinner1_of_pair_0(16), 2)) and (winnerswinner1_of_four_0_16_values(3) or
          winnerswinner1_of_four_0_16_values(4));
      else
        winnerswinner1_of_four_0_16_choices(3) := ((not is_set(winnerswinner1_of_pair_0(17), 2)) and (not
          is_set(winnerswinner1_of_pair_0(16), 2))) or winnerswinner1_of_four_0_16_values(3) or
          winnerswinner1_of_four_0_16_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_16_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(19), i);
        winnerswinner1_of_four_0_16_values(2 * i) := is_set(winnerswinner1_of_pair_0(18), i);
        if winnerswinner1_of_four_0_16_choices(i) then
          winnerswinner1_of_four_0_16_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(17), i)) and (not
            is_set(winnerswinner1_of_pair_0(16), i))) or winnerswinner1_of_four_0_16_values(2 * i - 1) or
            winnerswinner1_of_four_0_16_values(2 * i);
        else
          winnerswinner1_of_four_0_16_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(17), i)) and (not
            is_set(winnerswinner1_of_pair_0(16), i)) and (winnerswinner1_of_four_0_16_values(2 * i - 1) or
            winnerswinner1_of_four_0_16_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_16_choices(7) then
        winnerswinner1_of_four_0_16_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(17), 7)) and (not
          is_set(winnerswinner1_of_pair_0(16), 7)))) and (not is_set(winnerswinner1_of_pair_0(19), 7)) and (not
          is_set(winnerswinner1_of_pair_0(18), 7));
      else
        winnerswinner1_of_four_0_16_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(17), 7)) and (not
          is_set(winnerswinner1_of_pair_0(16), 7)))) or ((not is_set(winnerswinner1_of_pair_0(19), 7)) and (not
          is_set(winnerswinner1_of_pair_0(18), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(21), 0) then
        winnerswinner1_of_four_0_20_choice := (not is_set(winnerswinner1_of_pair_0(23), 0)) and (not
          is_set(winnerswinner1_of_pair_0(22), 0));
      else
        winnerswinner1_of_four_0_20_choice := is_set(winnerswinner1_of_pair_0(20), 0) and (not
          is_set(winnerswinner1_of_pair_0(23), 0)) and (not is_set(winnerswinner1_of_pair_0(22), 0));
      end if;
      winnerswinner1_of_four_0_20_value := is_set(winnerswinner1_of_pair_0(21), 1);
      winnerswinner1_of_four_0_20_values(2) := is_set(winnerswinner1_of_pair_0(20), 1);
      if (not is_set(winnerswinner1_of_pair_0(23), 1)) and (not is_set(winnerswinner1_of_pair_0(22), 1)) then
        winnerswinner1_of_four_0_20_choices(2) := winnerswinner1_of_four_0_20_choice or
          winnerswinner1_of_four_0_20_value or winnerswinner1_of_four_0_20_values(2);
      else
        winnerswinner1_of_four_0_20_choices(2) := winnerswinner1_of_four_0_20_choice and
          (winnerswinner1_of_four_0_20_value or winnerswinner1_of_four_0_20_values(2));
      end if;
      winnerswinner1_of_four_0_20_values(3) := is_set(winnerswinner1_of_pair_0(23), 2);
      winnerswinner1_of_four_0_20_values(4) := is_set(winnerswinner1_of_pair_0(22), 2);
      if winnerswinner1_of_four_0_20_choices(2) then
        winnerswinner1_of_four_0_20_choices(3) := (not is_set(winnerswinner1_of_pair_0(21), 2)) and (not
          is_set(winnerswinner1_of_pair_0(20), 2)) and (winnerswinner1_of_four_0_20_values(3) or
          winnerswinner1_of_four_0_20_values(4));
      else
        winnerswinner1_of_four_0_20_choices(3) := ((not is_set(winnerswinner1_of_pair_0(21), 2)) and (not
          is_set(winnerswinner1_of_pair_0(20), 2))) or winnerswinner1_of_four_0_20_values(3) or
          winnerswinner1_of_four_0_20_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_20_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(23), i);
        winnerswinner1_of_four_0_20_values(2 * i) := is_set(winnerswinner1_of_pair_0(22), i);
        if winnerswinner1_of_four_0_20_choices(i) then
          winnerswinner1_of_four_0_20_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(21), i)) and (not
            is_set(winnerswinner1_of_pair_0(20), i))) or winnerswinner1_of_four_0_20_values(2 * i - 1) or
            winnerswinner1_of_four_0_20_values(2 * i);
        else
          winnerswinner1_of_four_0_20_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(21), i)) and (not
            is_set(winnerswinner1_of_pair_0(20), i)) and (winnerswinner1_of_four_0_20_values(2 * i - 1) or
            winnerswinner1_of_four_0_20_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_20_choices(7) then
        winnerswinner1_of_four_0_20_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(21), 7)) and (not
          is_set(winnerswinner1_of_pair_0(20), 7)))) and (not is_set(winnerswinner1_of_pair_0(23), 7)) and (not
          is_set(winnerswinner1_of_pair_0(22), 7));
      else
        winnerswinner1_of_four_0_20_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(21), 7)) and (not
          is_set(winnerswinner1_of_pair_0(20), 7)))) or ((not is_set(winnerswinner1_of_pair_0(23), 7)) and (not
          is_set(winnerswinner1_of_pair_0(22), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(25), 0) then
        winnerswinner1_of_four_0_24_choice := (not is_set(winnerswinner1_of_pair_0(27), 0)) and (not
          is_set(winnerswinner1_of_pair_0(26), 0));
      else
        winnerswinner1_of_four_0_24_choice := is_set(winnerswinner1_of_pair_0(24), 0) and (not
          is_set(winnerswinner1_of_pair_0(27), 0)) and (not is_set(winnerswinner1_of_pair_0(26), 0));
      end if;
      winnerswinner1_of_four_0_24_value := is_set(winnerswinner1_of_pair_0(25), 1);
      winnerswinner1_of_four_0_24_values(2) := is_set(winnerswinner1_of_pair_0(24), 1);
      if (not is_set(winnerswinner1_of_pair_0(27), 1)) and (not is_set(winnerswinner1_of_pair_0(26), 1)) then
        winnerswinner1_of_four_0_24_choices(2) := winnerswinner1_of_four_0_24_choice or
          winnerswinner1_of_four_0_24_value or winnerswinner1_of_four_0_24_values(2);
      else
        winnerswinner1_of_four_0_24_choices(2) := winnerswinner1_of_four_0_24_choice and
          (winnerswinner1_of_four_0_24_value or winnerswinner1_of_four_0_24_values(2));
      end if;
      winnerswinner1_of_four_0_24_values(3) := is_set(winnerswinner1_of_pair_0(27), 2);
      winnerswinner1_of_four_0_24_values(4) := is_set(winnerswinner1_of_pair_0(26), 2);
      if winnerswinner1_of_four_0_24_choices(2) then
        winnerswinner1_of_four_0_24_choices(3) := (not is_set(winnerswinner1_of_pair_0(25), 2)) and (not
          is_set(winnerswinner1_of_pair_0(24), 2)) and (winnerswinner1_of_four_0_24_values(3) or
          winnerswinner1_of_four_0_24_values(4));
      else
        winnerswinner1_of_four_0_24_choices(3) := ((not is_set(winnerswinner1_of_pair_0(25), 2)) and (not
          is_set(winnerswinner1_of_pair_0(24), 2))) or winnerswinner1_of_four_0_24_values(3) or
          winnerswinner1_of_four_0_24_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_24_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(27), i);
        winnerswinner1_of_four_0_24_values(2 * i) := is_set(winnerswinner1_of_pair_0(26), i);
        if winnerswinner1_of_four_0_24_choices(i) then
          winnerswinner1_of_four_0_24_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(25), i)) and (not
            is_set(winnerswinner1_of_pair_0(24), i))) or winnerswinner1_of_four_0_24_values(2 * i - 1) or
            winnerswinner1_of_four_0_24_values(2 * i);
        else
          winnerswinner1_of_four_0_24_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(25), i)) and (not
            is_set(winnerswinner1_of_pair_0(24), i)) and (winnerswinner1_of_four_0_24_values(2 * i - 1) or
            winnerswinner1_of_four_0_24_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_24_choices(7) then
        winnerswinner1_of_four_0_24_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(25), 7)) and (not
          is_set(winnerswinner1_of_pair_0(24), 7)))) and (not is_set(winnerswinner1_of_pair_0(27), 7)) and (not
          is_set(winnerswinner1_of_pair_0(26), 7));
      else
        winnerswinner1_of_four_0_24_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(25), 7)) and (not
          is_set(winnerswinner1_of_pair_0(24), 7)))) or ((not is_set(winnerswinner1_of_pair_0(27), 7)) and (not
          is_set(winnerswinner1_of_pair_0(26), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(29), 0) then
        winnerswinner1_of_four_0_28_choice := (not is_set(winnerswinner1_of_pair_0(31), 0)) and (not
          is_set(winnerswinner1_of_pair_0(30), 0));
      else
        winnerswinner1_of_four_0_28_choice := is_set(winnerswinner1_of_pair_0(28), 0) and (not
          is_set(winnerswinner1_of_pair_0(31), 0)) and (not is_set(winnerswinner1_of_pair_0(30), 0));
      end if;
      winnerswinner1_of_four_0_28_value := is_set(winnerswinner1_of_pair_0(29), 1);
      winnerswinner1_of_four_0_28_values(2) := is_set(winnerswinner1_of_pair_0(28), 1);
      if (not is_set(winnerswinner1_of_pair_0(31), 1)) and (not is_set(winnerswinner1_of_pair_0(30), 1)) then
        winnerswinner1_of_four_0_28_choices(2) := winnerswinner1_of_four_0_28_choice or
          winnerswinner1_of_four_0_28_value or winnerswinner1_of_four_0_28_values(2);
      else
        winnerswinner1_of_four_0_28_choices(2) := winnerswinner1_of_four_0_28_choice and
          (winnerswinner1_of_four_0_28_value or winnerswinner1_of_four_0_28_values(2));
      end if;
      winnerswinner1_of_four_0_28_values(3) := is_set(winnerswinner1_of_pair_0(31), 2);
      winnerswinner1_of_four_0_28_values(4) := is_set(winnerswinner1_of_pair_0(30), 2);
      if winnerswinner1_of_four_0_28_choices(2) then
        winnerswinner1_of_four_0_28_choices(3) := (not is_set(winnerswinner1_of_pair_0(29), 2)) and (not
          is_set(winnerswinner1_of_pair_0(28), 2)) and (winnerswinner1_of_four_0_28_values(3) or
          winnerswinner1_of_four_0_28_values(4));
      else
        winnerswinner1_of_four_0_28_choices(3) := ((not is_set(winnerswinner1_of_pair_0(29), 2)) and (not
          is_set(winnerswinner1_of_pair_0(28), 2))) or winnerswinner1_of_four_0_28_values(3) or
          winnerswinner1_of_four_0_28_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_28_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(31), i);
        winnerswinner1_of_four_0_28_values(2 * i) := is_set(winnerswinner1_of_pair_0(30), i);
        if winnerswinner1_of_four_0_28_choices(i) then
          winnerswinner1_of_four_0_28_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(29), i)) and (not
            is_set(winnerswinner1_of_pair_0(28), i))) or winnerswinner1_of_four_0_28_values(2 * i - 1) or
            winnerswinner1_of_four_0_28_values(2 * i);
        else
          winnerswinner1_of_four_0_28_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(29), i)) and (not
            is_set(winnerswinner1_of_pair_0(28), i)) and (winnerswinner1_of_four_0_28_values(2 * i - 1) or
            winnerswinner1_of_four_0_28_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_28_choices(7) then
        winnerswinner1_of_four_0_28_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(29), 7)) and (not
          is_set(winnerswinner1_of_pair_0(28), 7)))) and (not is_set(winnerswinner1_of_pair_0(31), 7)) and (not
          is_set(winnerswinner1_of_pair_0(30), 7));
      else
        winnerswinner1_of_four_0_28_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(29), 7)) and (not
          is_set(winnerswinner1_of_pair_0(28), 7)))) or ((not is_set(winnerswinner1_of_pair_0(31), 7)) and (not
          is_set(winnerswinner1_of_pair_0(30), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(33), 0) then
        winnerswinner1_of_four_0_32_choice := (not is_set(winnerswinner1_of_pair_0(35), 0)) and (not
          is_set(winnerswinner1_of_pair_0(34), 0));
      else
        winnerswinner1_of_four_0_32_choice := is_set(winnerswinner1_of_pair_0(32), 0) and (not
          is_set(winnerswinner1_of_pair_0(35), 0)) and (not is_set(winnerswinner1_of_pair_0(34), 0));
      end if;
      winnerswinner1_of_four_0_32_value := is_set(winnerswinner1_of_pair_0(33), 1);
      winnerswinner1_of_four_0_32_values(2) := is_set(winnerswinner1_of_pair_0(32), 1);
      if (not is_set(winnerswinner1_of_pair_0(35), 1)) and (not is_set(winnerswinner1_of_pair_0(34), 1)) then
        winnerswinner1_of_four_0_32_choices(2) := winnerswinner1_of_four_0_32_choice or
          winnerswinner1_of_four_0_32_value or winnerswinner1_of_four_0_32_values(2);
      else
        winnerswinner1_of_four_0_32_choices(2) := winnerswinner1_of_four_0_32_choice and
          (winnerswinner1_of_four_0_32_value or winnerswinner1_of_four_0_32_values(2));
      end if;
      winnerswinner1_of_four_0_32_values(3) := is_set(winnerswinner1_of_pair_0(35), 2);
      winnerswinner1_of_four_0_32_values(4) := is_set(winnerswinner1_of_pair_0(34), 2);
      if winnerswinner1_of_four_0_32_choices(2) then
        winnerswinner1_of_four_0_32_choices(3) := (not is_set(winnerswinner1_of_pair_0(33), 2)) and (not
          is_set(winnerswinner1_of_pair_0(32), 2)) and (winnerswinner1_of_four_0_32_values(3) or
          winnerswinner1_of_four_0_32_values(4));
      else
        winnerswinner1_of_four_0_32_choices(3) := ((not is_set(winnerswinner1_of_pair_0(33), 2)) and (not
          is_set(winnerswinner1_of_pair_0(32), 2))) or winnerswinner1_of_four_0_32_values(3) or
          winnerswinner1_of_four_0_32_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_32_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(35), i);
        winnerswinner1_of_four_0_32_values(2 * i) := is_set(winnerswinner1_of_pair_0(34), i);
        if winnerswinner1_of_four_0_32_choices(i) then
          winnerswinner1_of_four_0_32_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(33), i)) and (not
            is_set(winnerswinner1_of_pair_0(32), i))) or winnerswinner1_of_four_0_32_values(2 * i - 1) or
            winnerswinner1_of_four_0_32_values(2 * i);
        else
          winnerswinner1_of_four_0_32_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(33), i)) and (not
            is_set(winnerswinner1_of_pair_0(32), i)) and (winnerswinner1_of_four_0_32_values(2 * i - 1) or
            winnerswinner1_of_four_0_32_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_32_choices(7) then
        winnerswinner1_of_four_0_32_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(33), 7)) and (not
          is_set(winnerswinner1_of_pair_0(32), 7)))) and (not is_set(winnerswinner1_of_pair_0(35), 7)) and (not
          is_set(winnerswinner1_of_pair_0(34), 7));
      else
        winnerswinner1_of_four_0_32_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(33), 7)) and (not
          is_set(winnerswinner1_of_pair_0(32), 7)))) or ((not is_set(winnerswinner1_of_pair_0(35), 7)) and (not
          is_set(winnerswinner1_of_pair_0(34), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(37), 0) then
        winnerswinner1_of_four_0_36_choice := (not is_set(winnerswinner1_of_pair_0(39), 0)) and (not
          is_set(winnerswinner1_of_pair_0(38), 0));
      else
        winnerswinner1_of_four_0_36_choice := is_set(winnerswinner1_of_pair_0(36), 0) and (not
          is_set(winnerswinner1_of_pair_0(39), 0)) and (not is_set(winnerswinner1_of_pair_0(38), 0));
      end if;
      winnerswinner1_of_four_0_36_value := is_set(winnerswinner1_of_pair_0(37), 1);
      winnerswinner1_of_four_0_36_values(2) := is_set(winnerswinner1_of_pair_0(36), 1);
      if (not is_set(winnerswinner1_of_pair_0(39), 1)) and (not is_set(winnerswinner1_of_pair_0(38), 1)) then
        winnerswinner1_of_four_0_36_choices(2) := winnerswinner1_of_four_0_36_choice or
          winnerswinner1_of_four_0_36_value or winnerswinner1_of_four_0_36_values(2);
      else
        winnerswinner1_of_four_0_36_choices(2) := winnerswinner1_of_four_0_36_choice and
          (winnerswinner1_of_four_0_36_value or winnerswinner1_of_four_0_36_values(2));
      end if;
      winnerswinner1_of_four_0_36_values(3) := is_set(winnerswinner1_of_pair_0(39), 2);
      winnerswinner1_of_four_0_36_values(4) := is_set(winnerswinner1_of_pair_0(38), 2);
      if winnerswinner1_of_four_0_36_choices(2) then
        winnerswinner1_of_four_0_36_choices(3) := (not is_set(winnerswinner1_of_pair_0(37), 2)) and (not
          is_set(winnerswinner1_of_pair_0(36), 2)) and (winnerswinner1_of_four_0_36_values(3) or
          winnerswinner1_of_four_0_36_values(4));
      else
        winnerswinner1_of_four_0_36_choices(3) := ((not is_set(winnerswinner1_of_pair_0(37), 2)) and (not
          is_set(winnerswinner1_of_pair_0(36), 2))) or winnerswinner1_of_four_0_36_values(3) or
          winnerswinner1_of_four_0_36_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_36_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(39), i);
        winnerswinner1_of_four_0_36_values(2 * i) := is_set(winnerswinner1_of_pair_0(38), i);
        if winnerswinner1_of_four_0_36_choices(i) then
          winnerswinner1_of_four_0_36_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(37), i)) and (not
            is_set(winnerswinner1_of_pair_0(36), i))) or winnerswinner1_of_four_0_36_values(2 * i - 1) or
            winnerswinner1_of_four_0_36_values(2 * i);
        else
          winnerswinner1_of_four_0_36_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(37), i)) and (not
            is_set(winnerswinner1_of_pair_0(36), i)) and (winnerswinner1_of_four_0_36_values(2 * i - 1) or
            winnerswinner1_of_four_0_36_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_36_choices(7) then
        winnerswinner1_of_four_0_36_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(37), 7)) and (not
          is_set(winnerswinner1_of_pair_0(36), 7)))) and (not is_set(winnerswinner1_of_pair_0(39), 7)) and (not
          is_set(winnerswinner1_of_pair_0(38), 7));
      else
        winnerswinner1_of_four_0_36_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(37), 7)) and (not
          is_set(winnerswinner1_of_pair_0(36), 7)))) or ((not is_set(winnerswinner1_of_pair_0(39), 7)) and (not
          is_set(winnerswinner1_of_pair_0(38), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(41), 0) then
        winnerswinner1_of_four_0_40_choice := (not is_set(winnerswinner1_of_pair_0(43), 0)) and (not
          is_set(winnerswinner1_of_pair_0(42), 0));
      else
        winnerswinner1_of_four_0_40_choice := is_set(winnerswinner1_of_pair_0(40), 0) and (not
          is_set(winnerswinner1_of_pair_0(43), 0)) and (not is_set(winnerswinner1_of_pair_0(42), 0));
      end if;
      winnerswinner1_of_four_0_40_value := is_set(winnerswinner1_of_pair_0(41), 1);
      winnerswinner1_of_four_0_40_values(2) := is_set(winnerswinner1_of_pair_0(40), 1);
      if (not is_set(winnerswinner1_of_pair_0(43), 1)) and (not is_set(winnerswinner1_of_pair_0(42), 1)) then
        winnerswinner1_of_four_0_40_choices(2) := winnerswinner1_of_four_0_40_choice or
          winnerswinner1_of_four_0_40_value or winnerswinner1_of_four_0_40_values(2);
      else
        winnerswinner1_of_four_0_40_choices(2) := winnerswinner1_of_four_0_40_choice and
          (winnerswinner1_of_four_0_40_value or winnerswinner1_of_four_0_40_values(2));
      end if;
      winnerswinner1_of_four_0_40_values(3) := is_set(winnerswinner1_of_pair_0(43), 2);
      winnerswinner1_of_four_0_40_values(4) := is_set(winnerswinner1_of_pair_0(42), 2);
      if winnerswinner1_of_four_0_40_choices(2) then
        winnerswinner1_of_four_0_40_choices(3) := (not is_set(winnerswinner1_of_pair_0(41), 2)) and (not
          is_set(winnerswinner1_of_pair_0(40), 2)) and (winnerswinner1_of_four_0_40_values(3) or
          winnerswinner1_of_four_0_40_values(4));
      else
        winnerswinner1_of_four_0_40_choices(3) := ((not is_set(winnerswinner1_of_pair_0(41), 2)) and (not
          is_set(winnerswinner1_of_pair_0(40), 2))) or winnerswinner1_of_four_0_40_values(3) or
          winnerswinner1_of_four_0_40_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_40_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(43), i);
        winnerswinner1_of_four_0_40_values(2 * i) := is_set(winnerswinner1_of_pair_0(42), i);
        if winnerswinner1_of_four_0_40_choices(i) then
          winnerswinner1_of_four_0_40_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(41), i)) and (not
            is_set(winnerswinner1_of_pair_0(40), i))) or winnerswinner1_of_four_0_40_values(2 * i - 1) or
            winnerswinner1_of_four_0_40_values(2 * i);
        else
          winnerswinner1_of_four_0_40_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(41), i)) and (not
            is_set(winnerswinner1_of_pair_0(40), i)) and (winnerswinner1_of_four_0_40_values(2 * i - 1) or
            winnerswinner1_of_four_0_40_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_40_choices(7) then
        winnerswinner1_of_four_0_40_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(41), 7)) and (not
          is_set(winnerswinner1_of_pair_0(40), 7)))) and (not is_set(winnerswinner1_of_pair_0(43), 7)) and (not
          is_set(winnerswinner1_of_pair_0(42), 7));
      else
        winnerswinner1_of_four_0_40_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(41), 7)) and (not
          is_set(winnerswinner1_of_pair_0(40), 7)))) or ((not is_set(winnerswinner1_of_pair_0(43), 7)) and (not
          is_set(winnerswinner1_of_pair_0(42), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(45), 0) then
        winnerswinner1_of_four_0_44_choice := (not is_set(winnerswinner1_of_pair_0(47), 0)) and (not
          is_set(winnerswinner1_of_pair_0(46), 0));
      else
        winnerswinner1_of_four_0_44_choice := is_set(winnerswinner1_of_pair_0(44), 0) and (not
          is_set(winnerswinner1_of_pair_0(47), 0)) and (not is_set(winnerswinner1_of_pair_0(46), 0));
      end if;
      winnerswinner1_of_four_0_44_value := is_set(winnerswinner1_of_pair_0(45), 1);
      winnerswinner1_of_four_0_44_values(2) := is_set(winnerswinner1_of_pair_0(44), 1);
      if (not is_set(winnerswinner1_of_pair_0(47), 1)) and (not is_set(winnerswinner1_of_pair_0(46), 1)) then
        winnerswinner1_of_four_0_44_choices(2) := winnerswinner1_of_four_0_44_choice or
          winnerswinner1_of_four_0_44_value or winnerswinner1_of_four_0_44_values(2);
      else
        winnerswinner1_of_four_0_44_choices(2) := winnerswinner1_of_four_0_44_choice and
          (winnerswinner1_of_four_0_44_value or winnerswinner1_of_four_0_44_values(2));
      end if;
      winnerswinner1_of_four_0_44_values(3) := is_set(winnerswinner1_of_pair_0(47), 2);
      winnerswinner1_of_four_0_44_values(4) := is_set(winnerswinner1_of_pair_0(46), 2);
      if winnerswinner1_of_four_0_44_choices(2) then
        winnerswinner1_of_four_0_44_choices(3) := (not is_set(winnerswinner1_of_pair_0(45), 2)) and (not
          is_set(winnerswinner1_of_pair_0(44), 2)) and (winnerswinner1_of_four_0_44_values(3) or
          winnerswinner1_of_four_0_44_values(4));
      else
        winnerswinner1_of_four_0_44_choices(3) := ((not is_set(winnerswinner1_of_pair_0(45), 2)) and (not
          is_set(winnerswinner1_of_pair_0(44), 2))) or winnerswinner1_of_four_0_44_values(3) or
          winnerswinner1_of_four_0_44_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_44_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(47), i);
        winnerswinner1_of_four_0_44_values(2 * i) := is_set(winnerswinner1_of_pair_0(46), i);
        if winnerswinner1_of_four_0_44_choices(i) then
          winnerswinner1_of_four_0_44_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(45), i)) and (not
            is_set(winnerswinner1_of_pair_0(44), i))) or winnerswinner1_of_four_0_44_values(2 * i - 1) or
            winnerswinner1_of_four_0_44_values(2 * i);
        else
          winnerswinner1_of_four_0_44_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(45), i)) and (not
            is_set(winnerswinner1_of_pair_0(44), i)) and (winnerswinner1_of_four_0_44_values(2 * i - 1) or
            winnerswinner1_of_four_0_44_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_44_choices(7) then
        winnerswinner1_of_four_0_44_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(45), 7)) and (not
          is_set(winnerswinner1_of_pair_0(44), 7)))) and (not is_set(winnerswinner1_of_pair_0(47), 7)) and (not
          is_set(winnerswinner1_of_pair_0(46), 7));
      else
        winnerswinner1_of_four_0_44_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(45), 7)) and (not
          is_set(winnerswinner1_of_pair_0(44), 7)))) or ((not is_set(winnerswinner1_of_pair_0(47), 7)) and (not
          is_set(winnerswinner1_of_pair_0(46), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(49), 0) then
        winnerswinner1_of_four_0_48_choice := (not is_set(winnerswinner1_of_pair_0(51), 0)) and (not
          is_set(winnerswinner1_of_pair_0(50), 0));
      else
        winnerswinner1_of_four_0_48_choice := is_set(winnerswinner1_of_pair_0(48), 0) and (not
          is_set(winnerswinner1_of_pair_0(51), 0)) and (not is_set(winnerswinner1_of_pair_0(50), 0));
      end if;
      winnerswinner1_of_four_0_48_value := is_set(winnerswinner1_of_pair_0(49), 1);
      winnerswinner1_of_four_0_48_values(2) := is_set(winnerswinner1_of_pair_0(48), 1);
      if (not is_set(winnerswinner1_of_pair_0(51), 1)) and (not is_set(winnerswinner1_of_pair_0(50), 1)) then
        winnerswinner1_of_four_0_48_choices(2) := winnerswinner1_of_four_0_48_choice or
          winnerswinner1_of_four_0_48_value or winnerswinner1_of_four_0_48_values(2);
      else
        winnerswinner1_of_four_0_48_choices(2) := winnerswinner1_of_four_0_48_choice and
          (winnerswinner1_of_four_0_48_value or winnerswinner1_of_four_0_48_values(2));
      end if;
      winnerswinner1_of_four_0_48_values(3) := is_set(winnerswinner1_of_pair_0(51), 2);
      winnerswinner1_of_four_0_48_values(4) := is_set(winnerswinner1_of_pair_0(50), 2);
      if winnerswinner1_of_four_0_48_choices(2) then
        winnerswinner1_of_four_0_48_choices(3) := (not is_set(winnerswinner1_of_pair_0(49), 2)) and (not
          is_set(winnerswinner1_of_pair_0(48), 2)) and (winnerswinner1_of_four_0_48_values(3) or
          winnerswinner1_of_four_0_48_values(4));
      else
        winnerswinner1_of_four_0_48_choices(3) := ((not is_set(winnerswinner1_of_pair_0(49), 2)) and (not
          is_set(winnerswinner1_of_pair_0(48), 2))) or winnerswinner1_of_four_0_48_values(3) or
          winnerswinner1_of_four_0_48_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_48_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(51), i);
        winnerswinner1_of_four_0_48_values(2 * i) := is_set(winnerswinner1_of_pair_0(50), i);
        if winnerswinner1_of_four_0_48_choices(i) then
          winnerswinner1_of_four_0_48_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(49), i)) and (not
            is_set(winnerswinner1_of_pair_0(48), i))) or winnerswinner1_of_four_0_48_values(2 * i - 1) or
            winnerswinner1_of_four_0_48_values(2 * i);
        else
          winnerswinner1_of_four_0_48_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(49), i)) and (not
            is_set(winnerswinner1_of_pair_0(48), i)) and (winnerswinner1_of_four_0_48_values(2 * i - 1) or
            winnerswinner1_of_four_0_48_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_48_choices(7) then
        winnerswinner1_of_four_0_48_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(49), 7)) and (not
          is_set(winnerswinner1_of_pair_0(48), 7)))) and (not is_set(winnerswinner1_of_pair_0(51), 7)) and (not
          is_set(winnerswinner1_of_pair_0(50), 7));
      else
        winnerswinner1_of_four_0_48_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(49), 7)) and (not
          is_set(winnerswinner1_of_pair_0(48), 7)))) or ((not is_set(winnerswinner1_of_pair_0(51), 7)) and (not
          is_set(winnerswinner1_of_pair_0(50), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(53), 0) then
        winnerswinner1_of_four_0_52_choice := (not is_set(winnerswinner1_of_pair_0(55), 0)) and (not
          is_set(winnerswinner1_of_pair_0(54), 0));
      else
        winnerswinner1_of_four_0_52_choice := is_set(winnerswinner1_of_pair_0(52), 0) and (not
          is_set(winnerswinner1_of_pair_0(55), 0)) and (not is_set(winnerswinner1_of_pair_0(54), 0));
      end if;
      winnerswinner1_of_four_0_52_value := is_set(winnerswinner1_of_pair_0(53), 1);
      winnerswinner1_of_four_0_52_values(2) := is_set(winnerswinner1_of_pair_0(52), 1);
      if (not is_set(winnerswinner1_of_pair_0(55), 1)) and (not is_set(winnerswinner1_of_pair_0(54), 1)) then
        winnerswinner1_of_four_0_52_choices(2) := winnerswinner1_of_four_0_52_choice or
          winnerswinner1_of_four_0_52_value or winnerswinner1_of_four_0_52_values(2);
      else
        winnerswinner1_of_four_0_52_choices(2) := winnerswinner1_of_four_0_52_choice and
          (winnerswinner1_of_four_0_52_value or winnerswinner1_of_four_0_52_values(2));
      end if;
      winnerswinner1_of_four_0_52_values(3) := is_set(winnerswinner1_of_pair_0(55), 2);
      winnerswinner1_of_four_0_52_values(4) := is_set(winnerswinner1_of_pair_0(54), 2);
      if winnerswinner1_of_four_0_52_choices(2) then
        winnerswinner1_of_four_0_52_choices(3) := (not is_set(winnerswinner1_of_pair_0(53), 2)) and (not
          is_set(winnerswinner1_of_pair_0(52), 2)) and (winnerswinner1_of_four_0_52_values(3) or
          winnerswinner1_of_four_0_52_values(4));
      else
        winnerswinner1_of_four_0_52_choices(3) := ((not is_set(winnerswinner1_of_pair_0(53), 2)) and (not
          is_set(winnerswinner1_of_pair_0(52), 2))) or winnerswinner1_of_four_0_52_values(3) or
          winnerswinner1_of_four_0_52_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_52_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(55), i);
        winnerswinner1_of_four_0_52_values(2 * i) := is_set(winnerswinner1_of_pair_0(54), i);
        if winnerswinner1_of_four_0_52_choices(i) then
          winnerswinner1_of_four_0_52_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(53), i)) and (not
            is_set(winnerswinner1_of_pair_0(52), i))) or winnerswinner1_of_four_0_52_values(2 * i - 1) or
            winnerswinner1_of_four_0_52_values(2 * i);
        else
          winnerswinner1_of_four_0_52_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(53), i)) and (not
            is_set(winnerswinner1_of_pair_0(52), i)) and (winnerswinner1_of_four_0_52_values(2 * i - 1) or
            winnerswinner1_of_four_0_52_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_52_choices(7) then
        winnerswinner1_of_four_0_52_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(53), 7)) and (not
          is_set(winnerswinner1_of_pair_0(52), 7)))) and (not is_set(winnerswinner1_of_pair_0(55), 7)) and (not
          is_set(winnerswinner1_of_pair_0(54), 7));
      else
        winnerswinner1_of_four_0_52_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(53), 7)) and (not
          is_set(winnerswinner1_of_pair_0(52), 7)))) or ((not is_set(winnerswinner1_of_pair_0(55), 7)) and (not
          is_set(winnerswinner1_of_pair_0(54), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(57), 0) then
        winnerswinner1_of_four_0_56_choice := (not is_set(winnerswinner1_of_pair_0(59), 0)) and (not
          is_set(winnerswinner1_of_pair_0(58), 0));
      else
        winnerswinner1_of_four_0_56_choice := is_set(winnerswinner1_of_pair_0(56), 0) and (not
          is_set(winnerswinner1_of_pair_0(59), 0)) and (not is_set(winnerswinner1_of_pair_0(58), 0));
      end if;
      winnerswinner1_of_four_0_56_value := is_set(winnerswinner1_of_pair_0(57), 1);
      winnerswinner1_of_four_0_56_values(2) := is_set(winnerswinner1_of_pair_0(56), 1);
      if (not is_set(winnerswinner1_of_pair_0(59), 1)) and (not is_set(winnerswinner1_of_pair_0(58), 1)) then
        winnerswinner1_of_four_0_56_choices(2) := winnerswinner1_of_four_0_56_choice or
          winnerswinner1_of_four_0_56_value or winnerswinner1_of_four_0_56_values(2);
      else
        winnerswinner1_of_four_0_56_choices(2) := winnerswinner1_of_four_0_56_choice and
          (winnerswinner1_of_four_0_56_value or winnerswinner1_of_four_0_56_values(2));
      end if;
      winnerswinner1_of_four_0_56_values(3) := is_set(winnerswinner1_of_pair_0(59), 2);
      winnerswinner1_of_four_0_56_values(4) := is_set(winnerswinner1_of_pair_0(58), 2);
      if winnerswinner1_of_four_0_56_choices(2) then
        winnerswinner1_of_four_0_56_choices(3) := (not is_set(winnerswinner1_of_pair_0(57), 2)) and (not
          is_set(winnerswinner1_of_pair_0(56), 2)) and (winnerswinner1_of_four_0_56_values(3) or
          winnerswinner1_of_four_0_56_values(4));
      else
        winnerswinner1_of_four_0_56_choices(3) := ((not is_set(winnerswinner1_of_pair_0(57), 2)) and (not
          is_set(winnerswinner1_of_pair_0(56), 2))) or winnerswinner1_of_four_0_56_values(3) or
          winnerswinner1_of_four_0_56_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_56_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(59), i);
        winnerswinner1_of_four_0_56_values(2 * i) := is_set(winnerswinner1_of_pair_0(58), i);
        if winnerswinner1_of_four_0_56_choices(i) then
          winnerswinner1_of_four_0_56_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(57), i)) and (not
            is_set(winnerswinner1_of_pair_0(56), i))) or winnerswinner1_of_four_0_56_values(2 * i - 1) or
            winnerswinner1_of_four_0_56_values(2 * i);
        else
          winnerswinner1_of_four_0_56_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(57), i)) and (not
            is_set(winnerswinner1_of_pair_0(56), i)) and (winnerswinner1_of_four_0_56_values(2 * i - 1) or
            winnerswinner1_of_four_0_56_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_56_choices(7) then
        winnerswinner1_of_four_0_56_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(57), 7)) and (not
          is_set(winnerswinner1_of_pair_0(56), 7)))) and (not is_set(winnerswinner1_of_pair_0(59), 7)) and (not
          is_set(winnerswinner1_of_pair_0(58), 7));
      else
        winnerswinner1_of_four_0_56_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(57), 7)) and (not
          is_set(winnerswinner1_of_pair_0(56), 7)))) or ((not is_set(winnerswinner1_of_pair_0(59), 7)) and (not
          is_set(winnerswinner1_of_pair_0(58), 7)));
      end if;
      if is_set(winnerswinner1_of_pair_0(61), 0) then
        winnerswinner1_of_four_0_60_choice := (not is_set(winnerswinner1_of_pair_0(63), 0)) and (not
          is_set(winnerswinner1_of_pair_0(62), 0));
      else
        winnerswinner1_of_four_0_60_choice := is_set(winnerswinner1_of_pair_0(60), 0) and (not
          is_set(winnerswinner1_of_pair_0(63), 0)) and (not is_set(winnerswinner1_of_pair_0(62), 0));
      end if;
      winnerswinner1_of_four_0_60_value := is_set(winnerswinner1_of_pair_0(61), 1);
      winnerswinner1_of_four_0_60_values(2) := is_set(winnerswinner1_of_pair_0(60), 1);
      if (not is_set(winnerswinner1_of_pair_0(63), 1)) and (not is_set(winnerswinner1_of_pair_0(62), 1)) then
        winnerswinner1_of_four_0_60_choices(2) := winnerswinner1_of_four_0_60_choice or
          winnerswinner1_of_four_0_60_value or winnerswinner1_of_four_0_60_values(2);
      else
        winnerswinner1_of_four_0_60_choices(2) := winnerswinner1_of_four_0_60_choice and
          (winnerswinner1_of_four_0_60_value or winnerswinner1_of_four_0_60_values(2));
      end if;
      winnerswinner1_of_four_0_60_values(3) := is_set(winnerswinner1_of_pair_0(63), 2);
      winnerswinner1_of_four_0_60_values(4) := is_set(winnerswinner1_of_pair_0(62), 2);
      if winnerswinner1_of_four_0_60_choices(2) then
        winnerswinner1_of_four_0_60_choices(3) := (not is_set(winnerswinner1_of_pair_0(61), 2)) and (not
          is_set(winnerswinner1_of_pair_0(60), 2)) and (winnerswinner1_of_four_0_60_values(3) or
          winnerswinner1_of_four_0_60_values(4));
      else
        winnerswinner1_of_four_0_60_choices(3) := ((not is_set(winnerswinner1_of_pair_0(61), 2)) and (not
          is_set(winnerswinner1_of_pair_0(60), 2))) or winnerswinner1_of_four_0_60_values(3) or
          winnerswinner1_of_four_0_60_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner1_of_four_0_60_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(63), i);
        winnerswinner1_of_four_0_60_values(2 * i) := is_set(winnerswinner1_of_pair_0(62), i);
        if winnerswinner1_of_four_0_60_choices(i) then
          winnerswinner1_of_four_0_60_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(61), i)) and (not
            is_set(winnerswinner1_of_pair_0(60), i))) or winnerswinner1_of_four_0_60_values(2 * i - 1) or
            winnerswinner1_of_four_0_60_values(2 * i);
        else
          winnerswinner1_of_four_0_60_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(61), i)) and (not
            is_set(winnerswinner1_of_pair_0(60), i)) and (winnerswinner1_of_four_0_60_values(2 * i - 1) or
            winnerswinner1_of_four_0_60_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_60_choices(7) then
        winnerswinner1_of_four_0_60_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(61), 7)) and (not
          is_set(winnerswinner1_of_pair_0(60), 7)))) and (not is_set(winnerswinner1_of_pair_0(63), 7)) and (not
          is_set(winnerswinner1_of_pair_0(62), 7));
      else
        winnerswinner1_of_four_0_60_choices(8) := (not ((not is_set(winnerswinner1_of_pair_0(61), 7)) and (not
          is_set(winnerswinner1_of_pair_0(60), 7)))) or ((not is_set(winnerswinner1_of_pair_0(63), 7)) and (not
          is_set(winnerswinner1_of_pair_0(62), 7)));
      end if;
      winnerswinner1_pair_index_0_0 <= winnerswinner1_of_pair_0_0_choices(8);
      winnerswinner1_pair_tag_valid <= sums_tag_valid;
      winnerswinner1_pair_tag_map_column <= sums_tag_map_column;
      winnerswinner1_pair_tag_output_column <= sums_tag_output_column;
      winnerswinner1_pair_tag_start_of_frame <= sums_tag_start_of_frame;
      winnerswinner1_pair_tag_end_of_line <= sums_tag_end_of_line;
      winnerswinner1_four_tag_valid <= winnerswinner1_pair_tag_valid;
      winnerswinner1_four_tag_map_column <= winnerswinner1_pair_tag_map_column;
      winnerswinner1_four_tag_output_column <= winnerswinner1_pair_tag_output_column;
      winnerswinner1_four_tag_start_of_frame <= winnerswinner1_pair_tag_start_of_frame;
      winnerswinner1_four_tag_end_of_line <= winnerswinner1_pair_tag_end_of_line;
      for i in 0 to 15 loop
        winnerswinner1_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0(4 * i + 2), 8)) or
          (to_unsigned(winnerswinner1_of_four_0(4 * i + 3), 8)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i + 1),
          8)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i), 8))));
      end loop;
      winnerswinner1_best_index_0_0 <= winnerswinner1_four_index_0_0;
      winnerswinner1_best_index_0_1 <= winnerswinner1_four_index_0_1;
      winnerswinner1_best_index_0_2 <= winnerswinner1_four_index_0_2;
      winnerswinner1_best_index_0_3 <= winnerswinner1_four_index_0_3;
      winnerswinner1_best_index_0_4 <= winnerswinner1_four_index_0_4;
      winnerswinner1_best_index_0_5 <= winnerswinner1_four_index_0_5;
      winnerswinner1_best_index_0_6 <= winnerswinner1_four_index_0_6;
      winnerswinner1_best_index_0_7 <= winnerswinner1_four_index_0_7;
      winnerswinner1_best_index_0_8 <= winnerswinner1_four_index_0_8;
      winnerswinner1_best_index_0_9 <= winnerswinner1_four_index_0_9;
      winnerswinner1_best_index_0_10 <= winnerswinner1_four_index_0_10;
      winnerswinner1_best_index_0_11 <= winnerswinner1_four_index_0_11;
      winnerswinner1_best_index_0_12 <= winnerswinner1_four_index_0_12;
      winnerswinner1_best_index_0_13 <= winnerswinner1_four_index_0_13;
      winnerswinner1_best_index_0_14 <= winnerswinner1_four_index_0_14;
      winnerswinner1_best_index_0_15 <= winnerswinner1_four_index_0_15;
      winnerswinner1_tag_valid <= winnerswinner1_four_tag_valid;
      winnerswinner1_tag_map_column <= winnerswinner1_four_tag_map_column;
      winnerswinner1_tag_output_column <= winnerswinner1_four_tag_output_column;
      winnerswinner1_tag_start_of_frame <= winnerswinner1_four_tag_start_of_frame;
      winnerswinner1_tag_end_of_line <= winnerswinner1_four_tag_end_of_line;
      if winnerswinner1_of_pair_0_0_choices(8) then
        winnerswinner1_of_pair_0(0) <= 0;
        winnerswinner1_of_pair_0(1) <= sums_sum_0(1);
      else
        winnerswinner1_of_pair_0(0) <= sums_sum_0(0);
        winnerswinner1_of_pair_0(1) <= 0;
      end if;
      if winnerswinner1_of_pair_0_2_choices(8) then
        winnerswinner1_of_pair_0(2) <= 0;
        winnerswinner1_of_pair_0(3) <= sums_sum_0(3);
        winnerswinner1_pair_index_0_1 <= 3;
      else
        winnerswinner1_of_pair_0(2) <= sums_sum_0(2);
        winnerswinner1_of_pair_0(3) <= 0;
        winnerswinner1_pair_index_0_1 <= 2;
      end if;
      if winnerswinner1_of_pair_0_4_choices(8) then
        winnerswinner1_of_pair_0(4) <= 0;
        winnerswinner1_of_pair_0(5) <= sums_sum_0(5);
        winnerswinner1_pair_index_0_2 <= 5;
      else
        winnerswinner1_of_pair_0(4) <= sums_sum_0(4);
        winnerswinner1_of_pair_0(5) <= 0;
        winnerswinner1_pair_index_0_2 <= 4;
      end if;
      if winnerswinner1_of_pair_0_6_choices(8) then
        winnerswinner1_of_pair_0(6) <= 0;
        winnerswinner1_of_pair_0(7) <= sums_sum_0(7);
        winnerswinner1_pair_index_0_3 <= 7;
      else
        winnerswinner1_of_pair_0(6) <= sums_sum_0(6);
        winnerswinner1_of_pair_0(7) <= 0;
        winnerswinner1_pair_index_0_3 <= 6;
      end if;
      if winnerswinner1_of_pair_0_8_choices(8) then
        winnerswinner1_of_pair_0(8) <= 0;
        winnerswinner1_of_pair_0(9) <= sums_sum_0(9);
        winnerswinner1_pair_index_0_4 <= 9;
      else
        winnerswinner1_of_pair_0(8) <= sums_sum_0(8);
        winnerswinner1_of_pair_0(9) <= 0;
        winnerswinner1_pair_index_0_4 <= 8;
      end if;
      if winnerswinner1_of_pair_0_10_choices(8) then
        winnerswinner1_of_pair_0(10) <= 0;
        winnerswinner1_of_pair_0(11) <= sums_sum_0(11);
        winnerswinner1_pair_index_0_5 <= 11;
      else
        winnerswinner1_of_pair_0(10) <= sums_sum_0(10);
        winnerswinner1_of_pair_0(11) <= 0;
        winnerswinner1_pair_index_0_5 <= 10;
      end if;
      if winnerswinner1_of_pair_0_12_choices(8) then
        winnerswinner1_of_pair_0(12) <= 0;
        winnerswinner1_of_pair_0(13) <= sums_sum_0(13);
        winnerswinner1_pair_index_0_6 <= 13;
      else
        winnerswinner1_of_pair_0(12) <= sums_sum_0(12);
        winnerswinner1_of_pair_0(13) <= 0;
        winnerswinner1_pair_index_0_6 <= 12;
      end if;
      if winnerswinner1_of_pair_0_14_choices(8) then
        winnerswinner1_of_pair_0(14) <= 0;
        winnerswinner1_of_pair_0(15) <= sums_sum_0(15);
        winnerswinner1_pair_index_0_7 <= 15;
      else
        winnerswinner1_of_pair_0(14) <= sums_sum_0(14);
        winnerswinner1_of_pair_0(15) <= 0;
        winnerswinner1_pair_index_0_7 <= 14;
      end if;
      if winnerswinner1_of_pair_0_16_choices(8) then
        winnerswinner1_of_pair_0(16) <= 0;
        winnerswinner1_of_pair_0(17) <= sums_sum_0(17);
        winnerswinner1_pair_index_0_8 <= 17;
      else
        winnerswinner1_of_pair_0(16) <= sums_sum_0(16);
        winnerswinner1_of_pair_0(17) <= 0;
        winnerswinner1_pair_index_0_8 <= 16;
      end if;
      if winnerswinner1_of_pair_0_18_choices(8) then
        winnerswinner1_of_pair_0(18) <= 0;
        winnerswinner1_of_pair_0(19) <= sums_sum_0(19);
        winnerswinner1_pair_index_0_9 <= 19;
      else
        winnerswinner1_of_pair_0(18) <= sums_sum_0(18);
        winnerswinner1_of_pair_0(19) <= 0;
        winnerswinner1_pair_index_0_9 <= 18;
      end if;
      if winnerswinner1_of_pair_0_20_choices(8) then
        winnerswinner1_of_pair_0(20) <= 0;
        winnerswinner1_of_pair_0(21) <= sums_sum_0(21);
        winnerswinner1_pair_index_0_10 <= 21;
      else
        winnerswinner1_of_pair_0(20) <= sums_sum_0(20);
        winnerswinner1_of_pair_0(21) <= 0;
        winnerswinner1_pair_index_0_10 <= 20;
      end if;
      if winnerswinner1_of_pair_0_22_choices(8) then
        winnerswinner1_of_pair_0(22) <= 0;
        winnerswinner1_of_pair_0(23) <= sums_sum_0(23);
        winnerswinner1_pair_index_0_11 <= 23;
      else
        winnerswinner1_of_pair_0(22) <= sums_sum_0(22);
        winnerswinner1_of_pair_0(23) <= 0;
        winnerswinner1_pair_index_0_11 <= 22;
      end if;
      if winnerswinner1_of_pair_0_24_choices(8) then
        winnerswinner1_of_pair_0(24) <= 0;
        winnerswinner1_of_pair_0(25) <= sums_sum_0(25);
        winnerswinner1_pair_index_0_12 <= 25;
      else
        winnerswinner1_of_pair_0(24) <= sums_sum_0(24);
        winnerswinner1_of_pair_0(25) <= 0;
        winnerswinner1_pair_index_0_12 <= 24;
      end if;
      if winnerswinner1_of_pair_0_26_choices(8) then
        winnerswinner1_of_pair_0(26) <= 0;
        winnerswinner1_of_pair_0(27) <= sums_sum_0(27);
        winnerswinner1_pair_index_0_13 <= 27;
      else
        winnerswinner1_of_pair_0(26) <= sums_sum_0(26);
        winnerswinner1_of_pair_0(27) <= 0;
        winnerswinner1_pair_index_0_13 <= 26;
      end if;
      if winnerswinner1_of_pair_0_28_choices(8) then
        winnerswinner1_of_pair_0(28) <= 0;
        winnerswinner1_of_pair_0(29) <= sums_sum_0(29);
        winnerswinner1_pair_index_0_14 <= 29;
      else
        winnerswinner1_of_pair_0(28) <= sums_sum_0(28);
        winnerswinner1_of_pair_0(29) <= 0;
        winnerswinner1_pair_index_0_14 <= 28;
      end if;
      if winnerswinner1_of_pair_0_30_choices(8) then
        winnerswinner1_of_pair_0(30) <= 0;
        winnerswinner1_of_pair_0(31) <= sums_sum_0(31);
        winnerswinner1_pair_index_0_15 <= 31;
      else
        winnerswinner1_of_pair_0(30) <= sums_sum_0(30);
        winnerswinner1_of_pair_0(31) <= 0;
        winnerswinner1_pair_index_0_15 <= 30;
      end if;
      if winnerswinner1_of_pair_0_32_choices(8) then
        winnerswinner1_of_pair_0(32) <= 0;
        winnerswinner1_of_pair_0(33) <= sums_sum_0(33);
        winnerswinner1_pair_index_0_16 <= 33;
      else
        winnerswinner1_of_pair_0(32) <= sums_sum_0(32);
        winnerswinner1_of_pair_0(33) <= 0;
        winnerswinner1_pair_index_0_16 <= 32;
      end if;
      if winnerswinner1_of_pair_0_34_choices(8) then
        winnerswinner1_of_pair_0(34) <= 0;
        winnerswinner1_of_pair_0(35) <= sums_sum_0(35);
        winnerswinner1_pair_index_0_17 <= 35;
      else
        winnerswinner1_of_pair_0(34) <= sums_sum_0(34);
        winnerswinner1_of_pair_0(35) <= 0;
        winnerswinner1_pair_index_0_17 <= 34;
      end if;
      if winnerswinner1_of_pair_0_36_choices(8) then
        winnerswinner1_of_pair_0(36) <= 0;
        winnerswinner1_of_pair_0(37) <= sums_sum_0(37);
        winnerswinner1_pair_index_0_18 <= 37;
      else
        winnerswinner1_of_pair_0(36) <= sums_sum_0(36);
        winnerswinner1_of_pair_0(37) <= 0;
        winnerswinner1_pair_index_0_18 <= 36;
      end if;
      if winnerswinner1_of_pair_0_38_choices(8) then
        winnerswinner1_of_pair_0(38) <= 0;
        winnerswinner1_of_pair_0(39) <= sums_sum_0(39);
        winnerswinner1_pair_index_0_19 <= 39;
      else
        winnerswinner1_of_pair_0(38) <= sums_sum_0(38);
        winnerswinner1_of_pair_0(39) <= 0;
        winnerswinner1_pair_index_0_19 <= 38;
      end if;
      if winnerswinner1_of_pair_0_40_choices(8) then
        winnerswinner1_of_pair_0(40) <= 0;
        winnerswinner1_of_pair_0(41) <= sums_sum_0(41);
        winnerswinner1_pair_index_0_20 <= 41;
      else
        winnerswinner1_of_pair_0(40) <= sums_sum_0(40);
        winnerswinner1_of_pair_0(41) <= 0;
        winnerswinner1_pair_index_0_20 <= 40;
      end if;
      if winnerswinner1_of_pair_0_42_choices(8) then
        winnerswinner1_of_pair_0(42) <= 0;
        winnerswinner1_of_pair_0(43) <= sums_sum_0(43);
        winnerswinner1_pair_index_0_21 <= 43;
      else
        winnerswinner1_of_pair_0(42) <= sums_sum_0(42);
        winnerswinner1_of_pair_0(43) <= 0;
        winnerswinner1_pair_index_0_21 <= 42;
      end if;
      if winnerswinner1_of_pair_0_44_choices(8) then
        winnerswinner1_of_pair_0(44) <= 0;
        winnerswinner1_of_pair_0(45) <= sums_sum_0(45);
        winnerswinner1_pair_index_0_22 <= 45;
      else
        winnerswinner1_of_pair_0(44) <= sums_sum_0(44);
        winnerswinner1_of_pair_0(45) <= 0;
        winnerswinner1_pair_index_0_22 <= 44;
      end if;
      if winnerswinner1_of_pair_0_46_choices(8) then
        winnerswinner1_of_pair_0(46) <= 0;
        winnerswinner1_of_pair_0(47) <= sums_sum_0(47);
        winnerswinner1_pair_index_0_23 <= 47;
      else
        winnerswinner1_of_pair_0(46) <= sums_sum_0(46);
        winnerswinner1_of_pair_0(47) <= 0;
        winnerswinner1_pair_index_0_23 <= 46;
      end if;
      if winnerswinner1_of_pair_0_48_choices(8) then
        winnerswinner1_of_pair_0(48) <= 0;
        winnerswinner1_of_pair_0(49) <= sums_sum_0(49);
        winnerswinner1_pair_index_0_24 <= 49;
      else
        winnerswinner1_of_pair_0(48) <= sums_sum_0(48);
        winnerswinner1_of_pair_0(49) <= 0;
        winnerswinner1_pair_index_0_24 <= 48;
      end if;
      if winnerswinner1_of_pair_0_50_choices(8) then
        winnerswinner1_of_pair_0(50) <= 0;
        winnerswinner1_of_pair_0(51) <= sums_sum_0(51);
        winnerswinner1_pair_index_0_25 <= 51;
      else
        winnerswinner1_of_pair_0(50) <= sums_sum_0(50);
        winnerswinner1_of_pair_0(51) <= 0;
        winnerswinner1_pair_index_0_25 <= 50;
      end if;
      if winnerswinner1_of_pair_0_52_choices(8) then
        winnerswinner1_of_pair_0(52) <= 0;
        winnerswinner1_of_pair_0(53) <= sums_sum_0(53);
        winnerswinner1_pair_index_0_26 <= 53;
      else
        winnerswinner1_of_pair_0(52) <= sums_sum_0(52);
        winnerswinner1_of_pair_0(53) <= 0;
        winnerswinner1_pair_index_0_26 <= 52;
      end if;
      if winnerswinner1_of_pair_0_54_choices(8) then
        winnerswinner1_of_pair_0(54) <= 0;
        winnerswinner1_of_pair_0(55) <= sums_sum_0(55);
        winnerswinner1_pair_index_0_27 <= 55;
      else
        winnerswinner1_of_pair_0(54) <= sums_sum_0(54);
        winnerswinner1_of_pair_0(55) <= 0;
        winnerswinner1_pair_index_0_27 <= 54;
      end if;
      if winnerswinner1_of_pair_0_56_choices(8) then
        winnerswinner1_of_pair_0(56) <= 0;
        winnerswinner1_of_pair_0(57) <= sums_sum_0(57);
        winnerswinner1_pair_index_0_28 <= 57;
      else
        winnerswinner1_of_pair_0(56) <= sums_sum_0(56);
        winnerswinner1_of_pair_0(57) <= 0;
        winnerswinner1_pair_index_0_28 <= 56;
      end if;
      if winnerswinner1_of_pair_0_58_choices(8) then
        winnerswinner1_of_pair_0(58) <= 0;
        winnerswinner1_of_pair_0(59) <= sums_sum_0(59);
        winnerswinner1_pair_index_0_29 <= 59;
      else
        winnerswinner1_of_pair_0(58) <= sums_sum_0(58);
        winnerswinner1_of_pair_0(59) <= 0;
        winnerswinner1_pair_index_0_29 <= 58;
      end if;
      if winnerswinner1_of_pair_0_60_choices(8) then
        winnerswinner1_of_pair_0(60) <= 0;
        winnerswinner1_of_pair_0(61) <= sums_sum_0(61);
        winnerswinner1_pair_index_0_30 <= 61;
      else
        winnerswinner1_of_pair_0(60) <= sums_sum_0(60);
        winnerswinner1_of_pair_0(61) <= 0;
        winnerswinner1_pair_index_0_30 <= 60;
      end if;
      if winnerswinner1_of_pair_0_62_choices(8) then
        winnerswinner1_of_pair_0(62) <= 0;
        winnerswinner1_of_pair_0(63) <= sums_sum_0(63);
        winnerswinner1_pair_index_0_31 <= 63;
      else
        winnerswinner1_of_pair_0(62) <= sums_sum_0(62);
        winnerswinner1_of_pair_0(63) <= 0;
        winnerswinner1_pair_index_0_31 <= 62;
      end if;
      if winnerswinner1_of_four_0_0_choices(8) then
        winnerswinner1_of_four_0(0) <= 0;
        winnerswinner1_of_four_0(1) <= 0;
        winnerswinner1_of_four_0(2) <= winnerswinner1_of_pair_0(2);
        winnerswinner1_of_four_0(3) <= winnerswinner1_of_pair_0(3);
        winnerswinner1_four_index_0_0 <= winnerswinner1_pair_index_0_1;
      else
        winnerswinner1_of_four_0(0) <= winnerswinner1_of_pair_0(0);
        winnerswinner1_of_four_0(1) <= winnerswinner1_of_pair_0(1);
        winnerswinner1_of_four_0(2) <= 0;
        winnerswinner1_of_four_0(3) <= 0;
        winnerswinner1_four_index_0_0 <= as_number(winnerswinner1_pair_index_0_0);
      end if;
      if winnerswinner1_of_four_0_4_choices(8) then
        winnerswinner1_of_four_0(4) <= 0;
        winnerswinner1_of_four_0(5) <= 0;
        winnerswinner1_of_four_0(6) <= winnerswinner1_of_pair_0(6);
        winnerswinner1_of_four_0(7) <= winnerswinner1_of_pair_0(7);
        winnerswinner1_four_index_0_1 <= winnerswinner1_pair_index_0_3;
      else
        winnerswinner1_of_four_0(4) <= winnerswinner1_of_pair_0(4);
        winnerswinner1_of_four_0(5) <= winnerswinner1_of_pair_0(5);
        winnerswinner1_of_four_0(6) <= 0;
        winnerswinner1_of_four_0(7) <= 0;
        winnerswinner1_four_index_0_1 <= winnerswinner1_pair_index_0_2;
      end if;
      if winnerswinner1_of_four_0_8_choices(8) then
        winnerswinner1_of_four_0(8) <= 0;
        winnerswinner1_of_four_0(9) <= 0;
        winnerswinner1_of_four_0(10) <= winnerswinner1_of_pair_0(10);
        winnerswinner1_of_four_0(11) <= winnerswinner1_of_pair_0(11);
        winnerswinner1_four_index_0_2 <= winnerswinner1_pair_index_0_5;
      else
        winnerswinner1_of_four_0(8) <= winnerswinner1_of_pair_0(8);
        winnerswinner1_of_four_0(9) <= winnerswinner1_of_pair_0(9);
        winnerswinner1_of_four_0(10) <= 0;
        winnerswinner1_of_four_0(11) <= 0;
        winnerswinner1_four_index_0_2 <= winnerswinner1_pair_index_0_4;
      end if;
      if winnerswinner1_of_four_0_12_choices(8) then
        winnerswinner1_of_four_0(12) <= 0;
        winnerswinner1_of_four_0(13) <= 0;
        winnerswinner1_of_four_0(14) <= winnerswinner1_of_pair_0(14);
        winnerswinner1_of_four_0(15) <= winnerswinner1_of_pair_0(15);
        winnerswinner1_four_index_0_3 <= winnerswinner1_pair_index_0_7;
      else
        winnerswinner1_of_four_0(12) <= winnerswinner1_of_pair_0(12);
        winnerswinner1_of_four_0(13) <= winnerswinner1_of_pair_0(13);
        winnerswinner1_of_four_0(14) <= 0;
        winnerswinner1_of_four_0(15) <= 0;
        winnerswinner1_four_index_0_3 <= winnerswinner1_pair_index_0_6;
      end if;
      if winnerswinner1_of_four_0_16_choices(8) then
        winnerswinner1_of_four_0(16) <= 0;
        winnerswinner1_of_four_0(17) <= 0;
        winnerswinner1_of_four_0(18) <= winnerswinner1_of_pair_0(18);
        winnerswinner1_of_four_0(19) <= winnerswinner1_of_pair_0(19);
        winnerswinner1_four_index_0_4 <= winnerswinner1_pair_index_0_9;
      else
        winnerswinner1_of_four_0(16) <= winnerswinner1_of_pair_0(16);
        winnerswinner1_of_four_0(17) <= winnerswinner1_of_pair_0(17);
        winnerswinner1_of_four_0(18) <= 0;
        winnerswinner1_of_four_0(19) <= 0;
        winnerswinner1_four_index_0_4 <= winnerswinner1_pair_index_0_8;
      end if;
      if winnerswinner1_of_four_0_20_choices(8) then
        winnerswinner1_of_four_0(20) <= 0;
        winnerswinner1_of_four_0(21) <= 0;
        winnerswinner1_of_four_0(22) <= winnerswinner1_of_pair_0(22);
        winnerswinner1_of_four_0(23) <= winnerswinner1_of_pair_0(23);
        winnerswinner1_four_index_0_5 <= winnerswinner1_pair_index_0_11;
      else
        winnerswinner1_of_four_0(20) <= winnerswinner1_of_pair_0(20);
        winnerswinner1_of_four_0(21) <= winnerswinner1_of_pair_0(21);
        winnerswinner1_of_four_0(22) <= 0;
        winnerswinner1_of_four_0(23) <= 0;
        winnerswinner1_four_index_0_5 <= winnerswinner1_pair_index_0_10;
      end if;
      if winnerswinner1_of_four_0_24_choices(8) then
        winnerswinner1_of_four_0(24) <= 0;
        winnerswinner1_of_four_0(25) <= 0;
        winnerswinner1_of_four_0(26) <= winnerswinner1_of_pair_0(26);
        winnerswinner1_of_four_0(27) <= winnerswinner1_of_pair_0(27);
        winnerswinner1_four_index_0_6 <= winnerswinner1_pair_index_0_13;
      else
        winnerswinner1_of_four_0(24) <= winnerswinner1_of_pair_0(24);
        winnerswinner1_of_four_0(25) <= winnerswinner1_of_pair_0(25);
        winnerswinner1_of_four_0(26) <= 0;
        winnerswinner1_of_four_0(27) <= 0;
        winnerswinner1_four_index_0_6 <= winnerswinner1_pair_index_0_12;
      end if;
      if winnerswinner1_of_four_0_28_choices(8) then
        winnerswinner1_of_four_0(28) <= 0;
        winnerswinner1_of_four_0(29) <= 0;
        winnerswinner1_of_four_0(30) <= winnerswinner1_of_pair_0(30);
        winnerswinner1_of_four_0(31) <= winnerswinner1_of_pair_0(31);
        winnerswinner1_four_index_0_7 <= winnerswinner1_pair_index_0_15;
      else
        winnerswinner1_of_four_0(28) <= winnerswinner1_of_pair_0(28);
        winnerswinner1_of_four_0(29) <= winnerswinner1_of_pair_0(29);
        winnerswinner1_of_four_0(30) <= 0;
        winnerswinner1_of_four_0(31) <= 0;
        winnerswinner1_four_index_0_7 <= winnerswinner1_pair_index_0_14;
      end if;
      if winnerswinner1_of_four_0_32_choices(8) then
        winnerswinner1_of_four_0(32) <= 0;
        winnerswinner1_of_four_0(33) <= 0;
        winnerswinner1_of_four_0(34) <= winnerswinner1_of_pair_0(34);
        winnerswinner1_of_four_0(35) <= winnerswinner1_of_pair_0(35);
        winnerswinner1_four_index_0_8 <= winnerswinner1_pair_index_0_17;
      else
        winnerswinner1_of_four_0(32) <= winnerswinner1_of_pair_0(32);
        winnerswinner1_of_four_0(33) <= winnerswinner1_of_pair_0(33);
        winnerswinner1_of_four_0(34) <= 0;
        winnerswinner1_of_four_0(35) <= 0;
        winnerswinner1_four_index_0_8 <= winnerswinner1_pair_index_0_16;
      end if;
      if winnerswinner1_of_four_0_36_choices(8) then
        winnerswinner1_of_four_0(36) <= 0;
        winnerswinner1_of_four_0(37) <= 0;
        winnerswinner1_of_four_0(38) <= winnerswinner1_of_pair_0(38);
        winnerswinner1_of_four_0(39) <= winnerswinner1_of_pair_0(39);
        winnerswinner1_four_index_0_9 <= winnerswinner1_pair_index_0_19;
      else
        winnerswinner1_of_four_0(36) <= winnerswinner1_of_pair_0(36);
        winnerswinner1_of_four_0(37) <= winnerswinner1_of_pair_0(37);
        winnerswinner1_of_four_0(38) <= 0;
        winnerswinner1_of_four_0(39) <= 0;
        winnerswinner1_four_index_0_9 <= winnerswinner1_pair_index_0_18;
      end if;
      if winnerswinner1_of_four_0_40_choices(8) then
        winnerswinner1_of_four_0(40) <= 0;
        winnerswinner1_of_four_0(41) <= 0;
        winnerswinner1_of_four_0(42) <= winnerswinner1_of_pair_0(42);
        winnerswinner1_of_four_0(43) <= winnerswinner1_of_pair_0(43);
        winnerswinner1_four_index_0_10 <= winnerswinner1_pair_index_0_21;
      else
        winnerswinner1_of_four_0(40) <= winnerswinner1_of_pair_0(40);
        winnerswinner1_of_four_0(41) <= winnerswinner1_of_pair_0(41);
        winnerswinner1_of_four_0(42) <= 0;
        winnerswinner1_of_four_0(43) <= 0;
        winnerswinner1_four_index_0_10 <= winnerswinner1_pair_index_0_20;
      end if;
      if winnerswinner1_of_four_0_44_choices(8) then
        winnerswinner1_of_four_0(44) <= 0;
        winnerswinner1_of_four_0(45) <= 0;
        winnerswinner1_of_four_0(46) <= winnerswinner1_of_pair_0(46);
        winnerswinner1_of_four_0(47) <= winnerswinner1_of_pair_0(47);
        winnerswinner1_four_index_0_11 <= winnerswinner1_pair_index_0_23;
      else
        winnerswinner1_of_four_0(44) <= winnerswinner1_of_pair_0(44);
        winnerswinner1_of_four_0(45) <= winnerswinner1_of_pair_0(45);
        winnerswinner1_of_four_0(46) <= 0;
        winnerswinner1_of_four_0(47) <= 0;
        winnerswinner1_four_index_0_11 <= winnerswinner1_pair_index_0_22;
      end if;
      if winnerswinner1_of_four_0_48_choices(8) then
        winnerswinner1_of_four_0(48) <= 0;
        winnerswinner1_of_four_0(49) <= 0;
        winnerswinner1_of_four_0(50) <= winnerswinner1_of_pair_0(50);
        winnerswinner1_of_four_0(51) <= winnerswinner1_of_pair_0(51);
        winnerswinner1_four_index_0_12 <= winnerswinner1_pair_index_0_25;
      else
        winnerswinner1_of_four_0(48) <= winnerswinner1_of_pair_0(48);
        winnerswinner1_of_four_0(49) <= winnerswinner1_of_pair_0(49);
        winnerswinner1_of_four_0(50) <= 0;
        winnerswinner1_of_four_0(51) <= 0;
        winnerswinner1_four_index_0_12 <= winnerswinner1_pair_index_0_24;
      end if;
      if winnerswinner1_of_four_0_52_choices(8) then
        winnerswinner1_of_four_0(52) <= 0;
        winnerswinner1_of_four_0(53) <= 0;
        winnerswinner1_of_four_0(54) <= winnerswinner1_of_pair_0(54);
        winnerswinner1_of_four_0(55) <= winnerswinner1_of_pair_0(55);
        winnerswinner1_four_index_0_13 <= winnerswinner1_pair_index_0_27;
      else
        winnerswinner1_of_four_0(52) <= winnerswinner1_of_pair_0(52);
        winnerswinner1_of_four_0(53) <= winnerswinner1_of_pair_0(53);
        winnerswinner1_of_four_0(54) <= 0;
        winnerswinner1_of_four_0(55) <= 0;
        winnerswinner1_four_index_0_13 <= winnerswinner1_pair_index_0_26;
      end if;
      if winnerswinner1_of_four_0_56_choices(8) then
        winnerswinner1_of_four_0(56) <= 0;
        winnerswinner1_of_four_0(57) <= 0;
        winnerswinner1_of_four_0(58) <= winnerswinner1_of_pair_0(58);
        winnerswinner1_of_four_0(59) <= winnerswinner1_of_pair_0(59);
        winnerswinner1_four_index_0_14 <= winnerswinner1_pair_index_0_29;
      else
        winnerswinner1_of_four_0(56) <= winnerswinner1_of_pair_0(56);
        winnerswinner1_of_four_0(57) <= winnerswinner1_of_pair_0(57);
        winnerswinner1_of_four_0(58) <= 0;
        winnerswinner1_of_four_0(59) <= 0;
        winnerswinner1_four_index_0_14 <= winnerswinner1_pair_index_0_28;
      end if;
      if winnerswinner1_of_four_0_60_choices(8) then
        winnerswinner1_of_four_0(60) <= 0;
        winnerswinner1_of_four_0(61) <= 0;
        winnerswinner1_of_four_0(62) <= winnerswinner1_of_pair_0(62);
        winnerswinner1_of_four_0(63) <= winnerswinner1_of_pair_0(63);
        winnerswinner1_four_index_0_15 <= winnerswinner1_pair_index_0_31;
      else
        winnerswinner1_of_four_0(60) <= winnerswinner1_of_pair_0(60);
        winnerswinner1_of_four_0(61) <= winnerswinner1_of_pair_0(61);
        winnerswinner1_of_four_0(62) <= 0;
        winnerswinner1_of_four_0(63) <= 0;
        winnerswinner1_four_index_0_15 <= winnerswinner1_pair_index_0_30;
      end if;
      -- winnerswinner2
      if is_set(winnerswinner1_best_cost_0(0), 0) then
        winnerswinner2_of_pair_0_0_choice := (not is_set(winnerswinner1_best_cost_0(1), 1)) or (not
          is_set(winnerswinner1_best_cost_0(1), 0));
      else
        winnerswinner2_of_pair_0_0_choice := not is_set(winnerswinner1_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(0), 1) then
        winnerswinner2_of_pair_0_0_choices(2) := winnerswinner2_of_pair_0_0_choice;
      else
        winnerswinner2_of_pair_0_0_choices(2) := is_set(winnerswinner1_best_cost_0(0), 0) and
          ((winnerswinner1_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_0_value := is_set(winnerswinner1_best_cost_0(1), 2);
      if winnerswinner2_of_pair_0_0_choices(2) then
        winnerswinner2_of_pair_0_0_choices(3) := (not is_set(winnerswinner1_best_cost_0(0), 2)) and
          winnerswinner2_of_pair_0_0_value;
      else
        winnerswinner2_of_pair_0_0_choices(3) := (not is_set(winnerswinner1_best_cost_0(0), 2)) or
          winnerswinner2_of_pair_0_0_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_of_pair_0_0_values(i) := is_set(winnerswinner1_best_cost_0(1), i + 1);
        if winnerswinner2_of_pair_0_0_choices(i + 1) then
          winnerswinner2_of_pair_0_0_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(0), i + 1)) or
            winnerswinner2_of_pair_0_0_values(i);
        else
          winnerswinner2_of_pair_0_0_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(0), i + 1)) and
            winnerswinner2_of_pair_0_0_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_0_choices(7) then
        winnerswinner2_of_pair_0_0_choices(8) := is_set(winnerswinner1_best_cost_0(0), 7) and (not
          is_set(winnerswinner1_best_cost_0(1), 7));
      else
        winnerswinner2_of_pair_0_0_choices(8) := is_set(winnerswinner1_best_cost_0(0), 7) or (not
          is_set(winnerswinner1_best_cost_0(1), 7));
      end if;
      if is_set(winnerswinner1_best_cost_0(2), 0) then
        winnerswinner2_of_pair_0_2_choice := (not is_set(winnerswinner1_best_cost_0(3), 1)) or (not
          is_set(winnerswinner1_best_cost_0(3), 0));
      else
        winnerswinner2_of_pair_0_2_choice := not is_set(winnerswinner1_best_cost_0(3), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(2), 1) then
        winnerswinner2_of_pair_0_2_choices(2) := winnerswinner2_of_pair_0_2_choice;
      else
        winnerswinner2_of_pair_0_2_choices(2) := is_set(winnerswinner1_best_cost_0(2), 0) and
          ((winnerswinner1_best_cost_0(3) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_2_value := is_set(winnerswinner1_best_cost_0(3), 2);
      if winnerswinner2_of_pair_0_2_choices(2) then
        winnerswinner2_of_pair_0_2_choices(3) := (not is_set(winnerswinner1_best_cost_0(2), 2)) and
          winnerswinner2_of_pair_0_2_value;
      else
        winnerswinner2_of_pair_0_2_choices(3) := (not is_set(winnerswinner1_best_cost_0(2), 2)) or
          winnerswinner2_of_pair_0_2_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_of_pair_0_2_values(i) := is_set(winnerswinner1_best_cost_0(3), i + 1);
        if winnerswinner2_of_pair_0_2_choices(i + 1) then
          winnerswinner2_of_pair_0_2_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(2), i + 1)) or
            winnerswinner2_of_pair_0_2_values(i);
        else
          winnerswinner2_of_pair_0_2_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(2), i + 1)) and
            winnerswinner2_of_pair_0_2_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_2_choices(7) then
        winnerswinner2_of_pair_0_2_choices(8) := is_set(winnerswinner1_best_cost_0(2), 7) and (not
          is_set(winnerswinner1_best_cost_0(3), 7));
      else
        winnerswinner2_of_pair_0_2_choices(8) := is_set(winnerswinner1_best_cost_0(2), 7) or (not
          is_set(winnerswinner1_best_cost_0(3), 7));
      end if;
      if is_set(winnerswinner1_best_cost_0(4), 0) then
        winnerswinner2_of_pair_0_4_choice := (not is_set(winnerswinner1_best_cost_0(5), 1)) or (not
          is_set(winnerswinner1_best_cost_0(5), 0));
      else
        winnerswinner2_of_pair_0_4_choice := not is_set(winnerswinner1_best_cost_0(5), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(4), 1) then
        winnerswinner2_of_pair_0_4_choices(2) := winnerswinner2_of_pair_0_4_choice;
      else
        winnerswinner2_of_pair_0_4_choices(2) := is_set(winnerswinner1_best_cost_0(4), 0) and
          ((winnerswinner1_best_cost_0(5) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_4_value := is_set(winnerswinner1_best_cost_0(5), 2);
      if winnerswinner2_of_pair_0_4_choices(2) then
        winnerswinner2_of_pair_0_4_choices(3) := (not is_set(winnerswinner1_best_cost_0(4), 2)) and
          winnerswinner2_of_pair_0_4_value;
      else
        winnerswinner2_of_pair_0_4_choices(3) := (not is_set(winnerswinner1_best_cost_0(4), 2)) or
          winnerswinner2_of_pair_0_4_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_of_pair_0_4_values(i) := is_set(winnerswinner1_best_cost_0(5), i + 1);
        if winnerswinner2_of_pair_0_4_choices(i + 1) then
          winnerswinner2_of_pair_0_4_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(4), i + 1)) or
            winnerswinner2_of_pair_0_4_values(i);
        else
          winnerswinner2_of_pair_0_4_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(4), i + 1)) and
            winnerswinner2_of_pair_0_4_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_4_choices(7) then
        winnerswinner2_of_pair_0_4_choices(8) := is_set(winnerswinner1_best_cost_0(4), 7) and (not
          is_set(winnerswinner1_best_cost_0(5), 7));
      else
        winnerswinner2_of_pair_0_4_choices(8) := is_set(winnerswinner1_best_cost_0(4), 7) or (not
          is_set(winnerswinner1_best_cost_0(5), 7));
      end if;
      if is_set(winnerswinner1_best_cost_0(6), 0) then
        winnerswinner2_of_pair_0_6_choice := (not is_set(winnerswinner1_best_cost_0(7), 1)) or (not
          is_set(winnerswinner1_best_cost_0(7), 0));
      else
        winnerswinner2_of_pair_0_6_choice := not is_set(winnerswinner1_best_cost_0(7), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(6), 1) then
        winnerswinner2_of_pair_0_6_choices(2) := winnerswinner2_of_pair_0_6_choice;
      else
        winnerswinner2_of_pair_0_6_choices(2) := is_set(winnerswinner1_best_cost_0(6), 0) and
          ((winnerswinner1_best_cost_0(7) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_6_value := is_set(winnerswinner1_best_cost_0(7), 2);
      if winnerswinner2_of_pair_0_6_choices(2) then
        winnerswinner2_of_pair_0_6_choices(3) := (not is_set(winnerswinner1_best_cost_0(6), 2)) and
          winnerswinner2_of_pair_0_6_value;
      else
        winnerswinner2_of_pair_0_6_choices(3) := (not is_set(winnerswinner1_best_cost_0(6), 2)) or
          winnerswinner2_of_pair_0_6_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_of_pair_0_6_values(i) := is_set(winnerswinner1_best_cost_0(7), i + 1);
        if winnerswinner2_of_pair_0_6_choices(i + 1) then
          winnerswinner2_of_pair_0_6_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(6), i + 1)) or
            winnerswinner2_of_pair_0_6_values(i);
        else
          winnerswinner2_of_pair_0_6_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(6), i + 1)) and
            winnerswinner2_of_pair_0_6_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_6_choices(7) then
        winnerswinner2_of_pair_0_6_choices(8) := is_set(winnerswinner1_best_cost_0(6), 7) and (not
          is_set(winnerswinner1_best_cost_0(7), 7));
      else
        winnerswinner2_of_pair_0_6_choices(8) := is_set(winnerswinner1_best_cost_0(6), 7) or (not
          is_set(winnerswinner1_best_cost_0(7), 7));
      end if;
      if is_set(winnerswinner1_best_cost_0(8), 0) then
        winnerswinner2_of_pair_0_8_choice := (not is_set(winnerswinner1_best_cost_0(9), 1)) or (not
          is_set(winnerswinner1_best_cost_0(9), 0));
      else
        winnerswinner2_of_pair_0_8_choice := not is_set(winnerswinner1_best_cost_0(9), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(8), 1) then
        winnerswinner2_of_pair_0_8_choices(2) := winnerswinner2_of_pair_0_8_choice;
      else
        winnerswinner2_of_pair_0_8_choices(2) := is_set(winnerswinner1_best_cost_0(8), 0) and
          ((winnerswinner1_best_cost_0(9) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_8_value := is_set(winnerswinner1_best_cost_0(9), 2);
      if winnerswinner2_of_pair_0_8_choices(2) then
        winnerswinner2_of_pair_0_8_choices(3) := (not is_set(winnerswinner1_best_cost_0(8), 2)) and
          winnerswinner2_of_pair_0_8_value;
      else
        winnerswinner2_of_pair_0_8_choices(3) := (not is_set(winnerswinner1_best_cost_0(8), 2)) or
          winnerswinner2_of_pair_0_8_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_of_pair_0_8_values(i) := is_set(winnerswinner1_best_cost_0(9), i + 1);
        if winnerswinner2_of_pair_0_8_choices(i + 1) then
          winnerswinner2_of_pair_0_8_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(8), i + 1)) or
            winnerswinner2_of_pair_0_8_values(i);
        else
          winnerswinner2_of_pair_0_8_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(8), i + 1)) and
            winnerswinner2_of_pair_0_8_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_8_choices(7) then
        winnerswinner2_of_pair_0_8_choices(8) := is_set(winnerswinner1_best_cost_0(8), 7) and (not
          is_set(winnerswinner1_best_cost_0(9), 7));
      else
        winnerswinner2_of_pair_0_8_choices(8) := is_set(winnerswinner1_best_cost_0(8), 7) or (not
          is_set(winnerswinner1_best_cost_0(9), 7));
      end if;
      if is_set(winnerswinner1_best_cost_0(10), 0) then
        winnerswinner2_of_pair_0_10_choice := (not is_set(winnerswinner1_best_cost_0(11), 1)) or (not
          is_set(winnerswinner1_best_cost_0(11), 0));
      else
        winnerswinner2_of_pair_0_10_choice := not is_set(winnerswinner1_best_cost_0(11), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(10), 1) then
        winnerswinner2_of_pair_0_10_choices(2) := winnerswinner2_of_pair_0_10_choice;
      else
        winnerswinner2_of_pair_0_10_choices(2) := is_set(winnerswinner1_best_cost_0(10), 0) and
          ((winnerswinner1_best_cost_0(11) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_10_value := is_set(winnerswinner1_best_cost_0(11), 2);
      if winnerswinner2_of_pair_0_10_choices(2) then
        winnerswinner2_of_pair_0_10_choices(3) := (not is_set(winnerswinner1_best_cost_0(10), 2)) and
          winnerswinner2_of_pair_0_10_value;
      else
        winnerswinner2_of_pair_0_10_choices(3) := (not is_set(winnerswinner1_best_cost_0(10), 2)) or
          winnerswinner2_of_pair_0_10_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_of_pair_0_10_values(i) := is_set(winnerswinner1_best_cost_0(11), i + 1);
        if winnerswinner2_of_pair_0_10_choices(i + 1) then
          winnerswinner2_of_pair_0_10_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(10), i + 1)) or
            winnerswinner2_of_pair_0_10_values(i);
        else
          winnerswinner2_of_pair_0_10_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(10), i + 1)) and
            winnerswinner2_of_pair_0_10_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_10_choices(7) then
        winnerswinner2_of_pair_0_10_choices(8) := is_set(winnerswinner1_best_cost_0(10), 7) and (not
          is_set(winnerswinner1_best_cost_0(11), 7));
      else
        winnerswinner2_of_pair_0_10_choices(8) := is_set(winnerswinner1_best_cost_0(10), 7) or (not
          is_set(winnerswinner1_best_cost_0(11), 7));
      end if;
      if is_set(winnerswinner1_best_cost_0(12), 0) then
        winnerswinner2_of_pair_0_12_choice := (not is_set(winnerswinner1_best_cost_0(13), 1)) or (not
          is_set(winnerswinner1_best_cost_0(13), 0));
      else
        winnerswinner2_of_pair_0_12_choice := not is_set(winnerswinner1_best_cost_0(13), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(12), 1) then
        winnerswinner2_of_pair_0_12_choices(2) := winnerswinner2_of_pair_0_12_choice;
      else
        winnerswinner2_of_pair_0_12_choices(2) := is_set(winnerswinner1_best_cost_0(12), 0) and
          ((winnerswinner1_best_cost_0(13) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_12_value := is_set(winnerswinner1_best_cost_0(13), 2);
      if winnerswinner2_of_pair_0_12_choices(2) then
        winnerswinner2_of_pair_0_12_choices(3) := (not is_set(winnerswinner1_best_cost_0(12), 2)) and
          winnerswinner2_of_pair_0_12_value;
      else
        winnerswinner2_of_pair_0_12_choices(3) := (not is_set(winnerswinner1_best_cost_0(12), 2)) or
          winnerswinner2_of_pair_0_12_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_of_pair_0_12_values(i) := is_set(winnerswinner1_best_cost_0(13), i + 1);
        if winnerswinner2_of_pair_0_12_choices(i + 1) then
          winnerswinner2_of_pair_0_12_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(12), i + 1)) or
            winnerswinner2_of_pair_0_12_values(i);
        else
          winnerswinner2_of_pair_0_12_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(12), i + 1)) and
            winnerswinner2_of_pair_0_12_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_12_choices(7) then
        winnerswinner2_of_pair_0_12_choices(8) := is_set(winnerswinner1_best_cost_0(12), 7) and (not
          is_set(winnerswinner1_best_cost_0(13), 7));
      else
        winnerswinner2_of_pair_0_12_choices(8) := is_set(winnerswinner1_best_cost_0(12), 7) or (not
          is_set(winnerswinner1_best_cost_0(13), 7));
      end if;
      if is_set(winnerswinner1_best_cost_0(14), 0) then
        winnerswinner2_of_pair_0_14_choice := (not is_set(winnerswinner1_best_cost_0(15), 1)) or (not
          is_set(winnerswinner1_best_cost_0(15), 0));
      else
        winnerswinner2_of_pair_0_14_choice := not is_set(winnerswinner1_best_cost_0(15), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(14), 1) then
        winnerswinner2_of_pair_0_14_choices(2) := winnerswinner2_of_pair_0_14_choice;
      else
        winnerswinner2_of_pair_0_14_choices(2) := is_set(winnerswinner1_best_cost_0(14), 0) and
          ((winnerswinner1_best_cost_0(15) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_14_value := is_set(winnerswinner1_best_cost_0(15), 2);
      if winnerswinner2_of_pair_0_14_choices(2) then
        winnerswinner2_of_pair_0_14_choices(3) := (not is_set(winnerswinner1_best_cost_0(14), 2)) and
          winnerswinner2_of_pair_0_14_value;
      else
        winnerswinner2_of_pair_0_14_choices(3) := (not is_set(winnerswinner1_best_cost_0(14), 2)) or
          winnerswinner2_of_pair_0_14_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner2_of_pair_0_14_values(i) := is_set(winnerswinner1_best_cost_0(15), i + 1);
        if winnerswinner2_of_pair_0_14_choices(i + 1) then
          winnerswinner2_of_pair_0_14_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(14), i + 1)) or
            winnerswinner2_of_pair_0_14_values(i);
        else
          winnerswinner2_of_pair_0_14_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(14), i + 1)) and
            winnerswinner2_of_pair_0_14_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_14_choices(7) then
        winnerswinner2_of_pair_0_14_choices(8) := is_set(winnerswinner1_best_cost_0(14), 7) and (not
          is_set(winnerswinner1_best_cost_0(15), 7));
      else
        winnerswinner2_of_pair_0_14_choices(8) := is_set(winnerswinner1_best_cost_0(14), 7) or (not
          is_set(winnerswinner1_best_cost_0(15), 7));
      end if;
      if is_set(winnerswinner2_of_pair_0(1), 0) then
        winnerswinner2_of_four_0_0_choice := (not is_set(winnerswinner2_of_pair_0(3), 0)) and (not
          is_set(winnerswinner2_of_pair_0(2), 0));
      else
        winnerswinner2_of_four_0_0_choice := is_set(winnerswinner2_of_pair_0(0), 0) and (not
          is_set(winnerswinner2_of_pair_0(3), 0)) and (not is_set(winnerswinner2_of_pair_0(2), 0));
      end if;
      winnerswinner2_of_four_0_0_value := is_set(winnerswinner2_of_pair_0(1), 1);
      winnerswinner2_of_four_0_0_values(2) := is_set(winnerswinner2_of_pair_0(0), 1);
      if (not is_set(winnerswinner2_of_pair_0(3), 1)) and (not is_set(winnerswinner2_of_pair_0(2), 1)) then
        winnerswinner2_of_four_0_0_choices(2) := winnerswinner2_of_four_0_0_choice or winnerswinner2_of_four_0_0_value
          or winnerswinner2_of_four_0_0_values(2);
      else
        winnerswinner2_of_four_0_0_choices(2) := winnerswinner2_of_four_0_0_choice and
          (winnerswinner2_of_four_0_0_value or winnerswinner2_of_four_0_0_values(2));
      end if;
      winnerswinner2_of_four_0_0_values(3) := is_set(winnerswinner2_of_pair_0(3), 2);
      winnerswinner2_of_four_0_0_values(4) := is_set(winnerswinner2_of_pair_0(2), 2);
      if winnerswinner2_of_four_0_0_choices(2) then
        winnerswinner2_of_four_0_0_choices(3) := (not is_set(winnerswinner2_of_pair_0(1), 2)) and (not
          is_set(winnerswinner2_of_pair_0(0), 2)) and (winnerswinner2_of_four_0_0_values(3) or
          winnerswinner2_of_four_0_0_values(4));
      else
        winnerswinner2_of_four_0_0_choices(3) := ((not is_set(winnerswinner2_of_pair_0(1), 2)) and (not
          is_set(winnerswinner2_of_pair_0(0), 2))) or winnerswinner2_of_four_0_0_values(3) or
          winnerswinner2_of_four_0_0_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner2_of_four_0_0_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(3), i);
        winnerswinner2_of_four_0_0_values(2 * i) := is_set(winnerswinner2_of_pair_0(2), i);
        if winnerswinner2_of_four_0_0_choices(i) then
          winnerswinner2_of_four_0_0_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(1), i)) and (not
            is_set(winnerswinner2_of_pair_0(0), i))) or winnerswinner2_of_four_0_0_values(2 * i - 1) or
            winnerswinner2_of_four_0_0_values(2 * i);
        else
          winnerswinner2_of_four_0_0_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(1), i)) and (not
            is_set(winnerswinner2_of_pair_0(0), i)) and (winnerswinner2_of_four_0_0_values(2 * i - 1) or
            winnerswinner2_of_four_0_0_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_0_choices(7) then
        winnerswinner2_of_four_0_0_choices(8) := (not ((not is_set(winnerswinner2_of_pair_0(1), 7)) and (not
          is_set(winnerswinner2_of_pair_0(0), 7)))) and (not is_set(winnerswinner2_of_pair_0(3), 7)) and (not
          is_set(winnerswinner2_of_pair_0(2), 7));
      else
        winnerswinner2_of_four_0_0_choices(8) := (not ((not is_set(winnerswinner2_of_pair_0(1), 7)) and (not
          is_set(winnerswinner2_of_pair_0(0), 7)))) or ((not is_set(winnerswinner2_of_pair_0(3), 7)) and (not
          is_set(winnerswinner2_of_pair_0(2), 7)));
      end if;
      if is_set(winnerswinner2_of_pair_0(5), 0) then
        winnerswinner2_of_four_0_4_choice := (not is_set(winnerswinner2_of_pair_0(7), 0)) and (not
          is_set(winnerswinner2_of_pair_0(6), 0));
      else
        winnerswinner2_of_four_0_4_choice := is_set(winnerswinner2_of_pair_0(4), 0) and (not
          is_set(winnerswinner2_of_pair_0(7), 0)) and (not is_set(winnerswinner2_of_pair_0(6), 0));
      end if;
      winnerswinner2_of_four_0_4_value := is_set(winnerswinner2_of_pair_0(5), 1);
      winnerswinner2_of_four_0_4_values(2) := is_set(winnerswinner2_of_pair_0(4), 1);
      if (not is_set(winnerswinner2_of_pair_0(7), 1)) and (not is_set(winnerswinner2_of_pair_0(6), 1)) then
        winnerswinner2_of_four_0_4_choices(2) := winnerswinner2_of_four_0_4_choice or winnerswinner2_of_four_0_4_value
          or winnerswinner2_of_four_0_4_values(2);
      else
        winnerswinner2_of_four_0_4_choices(2) := winnerswinner2_of_four_0_4_choice and
          (winnerswinner2_of_four_0_4_value or winnerswinner2_of_four_0_4_values(2));
      end if;
      winnerswinner2_of_four_0_4_values(3) := is_set(winnerswinner2_of_pair_0(7), 2);
      winnerswinner2_of_four_0_4_values(4) := is_set(winnerswinner2_of_pair_0(6), 2);
      if winnerswinner2_of_four_0_4_choices(2) then
        winnerswinner2_of_four_0_4_choices(3) := (not is_set(winnerswinner2_of_pair_0(5), 2)) and (not
          is_set(winnerswinner2_of_pair_0(4), 2)) and (winnerswinner2_of_four_0_4_values(3) or
          winnerswinner2_of_four_0_4_values(4));
      else
        winnerswinner2_of_four_0_4_choices(3) := ((not is_set(winnerswinner2_of_pair_0(5), 2)) and (not
          is_set(winnerswinner2_of_pair_0(4), 2))) or winnerswinner2_of_four_0_4_values(3) or
          winnerswinner2_of_four_0_4_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner2_of_four_0_4_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(7), i);
        winnerswinner2_of_four_0_4_values(2 * i) := is_set(winnerswinner2_of_pair_0(6), i);
        if winnerswinner2_of_four_0_4_choices(i) then
          winnerswinner2_of_four_0_4_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(5), i)) and (not
            is_set(winnerswinner2_of_pair_0(4), i))) or winnerswinner2_of_four_0_4_values(2 * i - 1) or
            winnerswinner2_of_four_0_4_values(2 * i);
        else
          winnerswinner2_of_four_0_4_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(5), i)) and (not
            is_set(winnerswinner2_of_pair_0(4), i)) and (winnerswinner2_of_four_0_4_values(2 * i - 1) or
            winnerswinner2_of_four_0_4_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_4_choices(7) then
        winnerswinner2_of_four_0_4_choices(8) := (not ((not is_set(winnerswinner2_of_pair_0(5), 7)) and (not
          is_set(winnerswinner2_of_pair_0(4), 7)))) and (not is_set(winnerswinner2_of_pair_0(7), 7)) and (not
          is_set(winnerswinner2_of_pair_0(6), 7));
      else
        winnerswinner2_of_four_0_4_choices(8) := (not ((not is_set(winnerswinner2_of_pair_0(5), 7)) and (not
          is_set(winnerswinner2_of_pair_0(4), 7)))) or ((not is_set(winnerswinner2_of_pair_0(7), 7)) and (not
          is_set(winnerswinner2_of_pair_0(6), 7)));
      end if;
      if is_set(winnerswinner2_of_pair_0(9), 0) then
        winnerswinner2_of_four_0_8_choice := (not is_set(winnerswinner2_of_pair_0(11), 0)) and (not
          is_set(winnerswinner2_of_pair_0(10), 0));
      else
        winnerswinner2_of_four_0_8_choice := is_set(winnerswinner2_of_pair_0(8), 0) and (not
          is_set(winnerswinner2_of_pair_0(11), 0)) and (not is_set(winnerswinner2_of_pair_0(10), 0));
      end if;
      winnerswinner2_of_four_0_8_value := is_set(winnerswinner2_of_pair_0(9), 1);
      winnerswinner2_of_four_0_8_values(2) := is_set(winnerswinner2_of_pair_0(8), 1);
      if (not is_set(winnerswinner2_of_pair_0(11), 1)) and (not is_set(winnerswinner2_of_pair_0(10), 1)) then
        winnerswinner2_of_four_0_8_choices(2) := winnerswinner2_of_four_0_8_choice or winnerswinner2_of_four_0_8_value
          or winnerswinner2_of_four_0_8_values(2);
      else
        winnerswinner2_of_four_0_8_choices(2) := winnerswinner2_of_four_0_8_choice and
          (winnerswinner2_of_four_0_8_value or winnerswinner2_of_four_0_8_values(2));
      end if;
      winnerswinner2_of_four_0_8_values(3) := is_set(winnerswinner2_of_pair_0(11), 2);
      winnerswinner2_of_four_0_8_values(4) := is_set(winnerswinner2_of_pair_0(10), 2);
      if winnerswinner2_of_four_0_8_choices(2) then
        winnerswinner2_of_four_0_8_choices(3) := (not is_set(winnerswinner2_of_pair_0(9), 2)) and (not
          is_set(winnerswinner2_of_pair_0(8), 2)) and (winnerswinner2_of_four_0_8_values(3) or
          winnerswinner2_of_four_0_8_values(4));
      else
        winnerswinner2_of_four_0_8_choices(3) := ((not is_set(winnerswinner2_of_pair_0(9), 2)) and (not
          is_set(winnerswinner2_of_pair_0(8), 2))) or winnerswinner2_of_four_0_8_values(3) or
          winnerswinner2_of_four_0_8_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner2_of_four_0_8_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(11), i);
        winnerswinner2_of_four_0_8_values(2 * i) := is_set(winnerswinner2_of_pair_0(10), i);
        if winnerswinner2_of_four_0_8_choices(i) then
          winnerswinner2_of_four_0_8_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(9), i)) and (not
            is_set(winnerswinner2_of_pair_0(8), i))) or winnerswinner2_of_four_0_8_values(2 * i - 1) or
            winnerswinner2_of_four_0_8_values(2 * i);
        else
          winnerswinner2_of_four_0_8_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(9), i)) and (not
            is_set(winnerswinner2_of_pair_0(8), i)) and (winnerswinner2_of_four_0_8_values(2 * i - 1) or
            winnerswinner2_of_four_0_8_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_8_choices(7) then
        winnerswinner2_of_four_0_8_choices(8) := (not ((not is_set(winnerswinner2_of_pair_0(9), 7)) and (not
          is_set(winnerswinner2_of_pair_0(8), 7)))) and (not is_set(winnerswinner2_of_pair_0(11), 7)) and (not
          is_set(winnerswinner2_of_pair_0(10), 7));
      else
        winnerswinner2_of_four_0_8_choices(8) := (not ((not is_set(winnerswinner2_of_pair_0(9), 7)) and (not
          is_set(winnerswinner2_of_pair_0(8), 7)))) or ((not is_set(winnerswinner2_of_pair_0(11), 7)) and (not
          is_set(winnerswinner2_of_pair_0(10), 7)));
      end if;
      if is_set(winnerswinner2_of_pair_0(13), 0) then
        winnerswinner2_of_four_0_12_choice := (not is_set(winnerswinner2_of_pair_0(15), 0)) and (not
          is_set(winnerswinner2_of_pair_0(14), 0));
      else
        winnerswinner2_of_four_0_12_choice := is_set(winnerswinner2_of_pair_0(12), 0) and (not
          is_set(winnerswinner2_of_pair_0(15), 0)) and (not is_set(winnerswinner2_of_pair_0(14), 0));
      end if;
      winnerswinner2_of_four_0_12_value := is_set(winnerswinner2_of_pair_0(13), 1);
      winnerswinner2_of_four_0_12_values(2) := is_set(winnerswinner2_of_pair_0(12), 1);
      if (not is_set(winnerswinner2_of_pair_0(15), 1)) and (not is_set(winnerswinner2_of_pair_0(14), 1)) then
        winnerswinner2_of_four_0_12_choices(2) := winnerswinner2_of_four_0_12_choice or
          winnerswinner2_of_four_0_12_value or winnerswinner2_of_four_0_12_values(2);
      else
        winnerswinner2_of_four_0_12_choices(2) := winnerswinner2_of_four_0_12_choice and
          (winnerswinner2_of_four_0_12_value or winnerswinner2_of_four_0_12_values(2));
      end if;
      winnerswinner2_of_four_0_12_values(3) := is_set(winnerswinner2_of_pair_0(15), 2);
      winnerswinner2_of_four_0_12_values(4) := is_set(winnerswinner2_of_pair_0(14), 2);
      if winnerswinner2_of_four_0_12_choices(2) then
        winnerswinner2_of_four_0_12_choices(3) := (not is_set(winnerswinner2_of_pair_0(13), 2)) and (not
          is_set(winnerswinner2_of_pair_0(12), 2)) and (winnerswinner2_of_four_0_12_values(3) or
          winnerswinner2_of_four_0_12_values(4));
      else
        winnerswinner2_of_four_0_12_choices(3) := ((not is_set(winnerswinner2_of_pair_0(13), 2)) and (not
          is_set(winnerswinner2_of_pair_0(12), 2))) or winnerswinner2_of_four_0_12_values(3) or
          winnerswinner2_of_four_0_12_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner2_of_four_0_12_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(15), i);
        winnerswinner2_of_four_0_12_values(2 * i) := is_set(winnerswinner2_of_pair_0(14), i);
        if winnerswinner2_of_four_0_12_choices(i) then
          winnerswinner2_of_four_0_12_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(13), i)) and (not
            is_set(winnerswinner2_of_pair_0(12), i))) or winnerswinner2_of_four_0_12_values(2 * i - 1) or
            winnerswinner2_of_four_0_12_values(2 * i);
        else
          winnerswinner2_of_four_0_12_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(13), i)) and (not
            is_set(winnerswinner2_of_pair_0(12), i)) and (winnerswinner2_of_four_0_12_values(2 * i - 1) or
            winnerswinner2_of_four_0_12_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_12_choices(7) then
        winnerswinner2_of_four_0_12_choices(8) := (not ((not is_set(winnerswinner2_of_pair_0(13), 7)) and (not
          is_set(winnerswinner2_of_pair_0(12), 7)))) and (not is_set(winnerswinner2_of_pair_0(15), 7)) and (not
          is_set(winnerswinner2_of_pair_0(14), 7));
      else
        winnerswinner2_of_four_0_12_choices(8) := (not ((not is_set(winnerswinner2_of_pair_0(13), 7)) and (not
          is_set(winnerswinner2_of_pair_0(12), 7)))) or ((not is_set(winnerswinner2_of_pair_0(15), 7)) and (not
          is_set(winnerswinner2_of_pair_0(14), 7)));
      end if;
      winnerswinner2_pair_tag_valid <= winnerswinner1_tag_valid;
      winnerswinner2_pair_tag_map_column <= winnerswinner1_tag_map_column;
      winnerswinner2_pair_tag_output_column <= winnerswinner1_tag_output_column;
      winnerswinner2_pair_tag_start_of_frame <= winnerswinner1_tag_start_of_frame;
      winnerswinner2_pair_tag_end_of_line <= winnerswinner1_tag_end_of_line;
      winnerswinner2_four_tag_valid <= winnerswinner2_pair_tag_valid;
      winnerswinner2_four_tag_map_column <= winnerswinner2_pair_tag_map_column;
      winnerswinner2_four_tag_output_column <= winnerswinner2_pair_tag_output_column;
      winnerswinner2_four_tag_start_of_frame <= winnerswinner2_pair_tag_start_of_frame;
      winnerswinner2_four_tag_end_of_line <= winnerswinner2_pair_tag_end_of_line;
      for i in 0 to 3 loop
        winnerswinner2_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner2_of_four_0(4 * i + 2), 8)) or
          (to_unsigned(winnerswinner2_of_four_0(4 * i + 3), 8)))) or (to_unsigned(winnerswinner2_of_four_0(4 * i + 1),
          8)))) or (to_unsigned(winnerswinner2_of_four_0(4 * i), 8))));
      end loop;
      winnerswinner2_best_index_0_0 <= winnerswinner2_four_index_0_0;
      winnerswinner2_best_index_0_1 <= winnerswinner2_four_index_0_1;
      winnerswinner2_best_index_0_2 <= winnerswinner2_four_index_0_2;
      winnerswinner2_best_index_0_3 <= winnerswinner2_four_index_0_3;
      winnerswinner2_tag_valid <= winnerswinner2_four_tag_valid;
      winnerswinner2_tag_map_column <= winnerswinner2_four_tag_map_column;
      winnerswinner2_tag_output_column <= winnerswinner2_four_tag_output_column;
      winnerswinner2_tag_start_of_frame <= winnerswinner2_four_tag_start_of_frame;
      winnerswinner2_tag_end_of_line <= winnerswinner2_four_tag_end_of_line;
      if winnerswinner2_of_pair_0_0_choices(8) then
        winnerswinner2_of_pair_0(0) <= 0;
        winnerswinner2_of_pair_0(1) <= winnerswinner1_best_cost_0(1);
        winnerswinner2_pair_index_0_0 <= winnerswinner1_best_index_0_1;
      else
        winnerswinner2_of_pair_0(0) <= winnerswinner1_best_cost_0(0);
        winnerswinner2_of_pair_0(1) <= 0;
        winnerswinner2_pair_index_0_0 <= winnerswinner1_best_index_0_0;
      end if;
      if winnerswinner2_of_pair_0_2_choices(8) then
        winnerswinner2_of_pair_0(2) <= 0;
        winnerswinner2_of_pair_0(3) <= winnerswinner1_best_cost_0(3);
        winnerswinner2_pair_index_0_1 <= winnerswinner1_best_index_0_3;
      else
        winnerswinner2_of_pair_0(2) <= winnerswinner1_best_cost_0(2);
        winnerswinner2_of_pair_0(3) <= 0;
        winnerswinner2_pair_index_0_1 <= winnerswinner1_best_index_0_2;
      end if;
      if winnerswinner2_of_pair_0_4_choices(8) then
        winnerswinner2_of_pair_0(4) <= 0;
        winnerswinner2_of_pair_0(5) <= winnerswinner1_best_cost_0(5);
        winnerswinner2_pair_index_0_2 <= winnerswinner1_best_index_0_5;
      else
        winnerswinner2_of_pair_0(4) <= winnerswinner1_best_cost_0(4);
        winnerswinner2_of_pair_0(5) <= 0;
        winnerswinner2_pair_index_0_2 <= winnerswinner1_best_index_0_4;
      end if;
      if winnerswinner2_of_pair_0_6_choices(8) then
        winnerswinner2_of_pair_0(6) <= 0;
        winnerswinner2_of_pair_0(7) <= winnerswinner1_best_cost_0(7);
        winnerswinner2_pair_index_0_3 <= winnerswinner1_best_index_0_7;
      else
        winnerswinner2_of_pair_0(6) <= winnerswinner1_best_cost_0(6);
        winnerswinner2_of_pair_0(7) <= 0;
        winnerswinner2_pair_index_0_3 <= winnerswinner1_best_index_0_6;
      end if;
      if winnerswinner2_of_pair_0_8_choices(8) then
        winnerswinner2_of_pair_0(8) <= 0;
        winnerswinner2_of_pair_0(9) <= winnerswinner1_best_cost_0(9);
        winnerswinner2_pair_index_0_4 <= winnerswinner1_best_index_0_9;
      else
        winnerswinner2_of_pair_0(8) <= winnerswinner1_best_cost_0(8);
        winnerswinner2_of_pair_0(9) <= 0;
        winnerswinner2_pair_index_0_4 <= winnerswinner1_best_index_0_8;
      end if;
      if winnerswinner2_of_pair_0_10_choices(8) then
        winnerswinner2_of_pair_0(10) <= 0;
        winnerswinner2_of_pair_0(11) <= winnerswinner1_best_cost_0(11);
        winnerswinner2_pair_index_0_5 <= winnerswinner1_best_index_0_11;
      else
        winnerswinner2_of_pair_0(10) <= winnerswinner1_best_cost_0(10);
        winnerswinner2_of_pair_0(11) <= 0;
        winnerswinner2_pair_index_0_5 <= winnerswinner1_best_index_0_10;
      end if;
      if winnerswinner2_of_pair_0_12_choices(8) then
        winnerswinner2_of_pair_0(12) <= 0;
        winnerswinner2_of_pair_0(13) <= winnerswinner1_best_cost_0(13);
        winnerswinner2_pair_index_0_6 <= winnerswinner1_best_index_0_13;
      else
        winnerswinner2_of_pair_0(12) <= winnerswinner1_best_cost_0(12);
        winnerswinner2_of_pair_0(13) <= 0;
        winnerswinner2_pair_index_0_6 <= winnerswinner1_best_index_0_12;
      end if;
      if winnerswinner2_of_pair_0_14_choices(8) then
        winnerswinner2_of_pair_0(14) <= 0;
        winnerswinner2_of_pair_0(15) <= winnerswinner1_best_cost_0(15);
        winnerswinner2_pair_index_0_7 <= winnerswinner1_best_index_0_15;
      else
        winnerswinner2_of_pair_0(14) <= winnerswinner1_best_cost_0(14);
        winnerswinner2_of_pair_0(15) <= 0;
        winnerswinner2_pair_index_0_7 <= winnerswinner1_best_index_0_14;
      end if;
      if winnerswinner2_of_four_0_0_choices(8) then
        winnerswinner2_of_four_0(0) <= 0;
        winnerswinner2_of_four_0(1) <= 0;
        winnerswinner2_of_four_0(2) <= winnerswinner2_of_pair_0(2);
        winnerswinner2_of_four_0(3) <= winnerswinner2_of_pair_0(3);
        winnerswinner2_four_index_0_0 <= winnerswinner2_pair_index_0_1;
      else
        winnerswinner2_of_four_0(0) <= winnerswinner2_of_pair_0(0);
        winnerswinner2_of_four_0(1) <= winnerswinner2_of_pair_0(1);
        winnerswinner2_of_four_0(2) <= 0;
        winnerswinner2_of_four_0(3) <= 0;
        winnerswinner2_four_index_0_0 <= winnerswinner2_pair_index_0_0;
      end if;
      if winnerswinner2_of_four_0_4_choices(8) then
        winnerswinner2_of_four_0(4) <= 0;
        winnerswinner2_of_four_0(5) <= 0;
        winnerswinner2_of_four_0(6) <= winnerswinner2_of_pair_0(6);
        winnerswinner2_of_four_0(7) <= winnerswinner2_of_pair_0(7);
        winnerswinner2_four_index_0_1 <= winnerswinner2_pair_index_0_3;
      else
        winnerswinner2_of_four_0(4) <= winnerswinner2_of_pair_0(4);
        winnerswinner2_of_four_0(5) <= winnerswinner2_of_pair_0(5);
        winnerswinner2_of_four_0(6) <= 0;
        winnerswinner2_of_four_0(7) <= 0;
        winnerswinner2_four_index_0_1 <= winnerswinner2_pair_index_0_2;
      end if;
      if winnerswinner2_of_four_0_8_choices(8) then
        winnerswinner2_of_four_0(8) <= 0;
        winnerswinner2_of_four_0(9) <= 0;
        winnerswinner2_of_four_0(10) <= winnerswinner2_of_pair_0(10);
        winnerswinner2_of_four_0(11) <= winnerswinner2_of_pair_0(11);
        winnerswinner2_four_index_0_2 <= winnerswinner2_pair_index_0_5;
      else
        winnerswinner2_of_four_0(8) <= winnerswinner2_of_pair_0(8);
        winnerswinner2_of_four_0(9) <= winnerswinner2_of_pair_0(9);
        winnerswinner2_of_four_0(10) <= 0;
        winnerswinner2_of_four_0(11) <= 0;
        winnerswinner2_four_index_0_2 <= winnerswinner2_pair_index_0_4;
      end if;
      if winnerswinner2_of_four_0_12_choices(8) then
        winnerswinner2_of_four_0(12) <= 0;
        winnerswinner2_of_four_0(13) <= 0;
        winnerswinner2_of_four_0(14) <= winnerswinner2_of_pair_0(14);
        winnerswinner2_of_four_0(15) <= winnerswinner2_of_pair_0(15);
        winnerswinner2_four_index_0_3 <= winnerswinner2_pair_index_0_7;
      else
        winnerswinner2_of_four_0(12) <= winnerswinner2_of_pair_0(12);
        winnerswinner2_of_four_0(13) <= winnerswinner2_of_pair_0(13);
        winnerswinner2_of_four_0(14) <= 0;
        winnerswinner2_of_four_0(15) <= 0;
        winnerswinner2_four_index_0_3 <= winnerswinner2_pair_index_0_6;
      end if;
      -- winnerswinner3
      if is_set(winnerswinner2_best_cost_0(0), 0) then
        winnerswinner3_of_pair_0_0_choice := (not is_set(winnerswinner2_best_cost_0(1), 1)) or (not
          is_set(winnerswinner2_best_cost_0(1), 0));
      else
        winnerswinner3_of_pair_0_0_choice := not is_set(winnerswinner2_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner2_best_cost_0(0), 1) then
        winnerswinner3_of_pair_0_0_choices(2) := winnerswinner3_of_pair_0_0_choice;
      else
        winnerswinner3_of_pair_0_0_choices(2) := is_set(winnerswinner2_best_cost_0(0), 0) and
          ((winnerswinner2_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner3_of_pair_0_0_value := is_set(winnerswinner2_best_cost_0(1), 2);
      if winnerswinner3_of_pair_0_0_choices(2) then
        winnerswinner3_of_pair_0_0_choices(3) := (not is_set(winnerswinner2_best_cost_0(0), 2)) and
          winnerswinner3_of_pair_0_0_value;
      else
        winnerswinner3_of_pair_0_0_choices(3) := (not is_set(winnerswinner2_best_cost_0(0), 2)) or
          winnerswinner3_of_pair_0_0_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner3_of_pair_0_0_values(i) := is_set(winnerswinner2_best_cost_0(1), i + 1);
        if winnerswinner3_of_pair_0_0_choices(i + 1) then
          winnerswinner3_of_pair_0_0_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(0), i + 1)) or
            winnerswinner3_of_pair_0_0_values(i);
        else
          winnerswinner3_of_pair_0_0_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(0), i + 1)) and
            winnerswinner3_of_pair_0_0_values(i);
        end if;
      end loop;
      if winnerswinner3_of_pair_0_0_choices(7) then
        winnerswinner3_of_pair_0_0_choices(8) := is_set(winnerswinner2_best_cost_0(0), 7) and (not
          is_set(winnerswinner2_best_cost_0(1), 7));
      else
        winnerswinner3_of_pair_0_0_choices(8) := is_set(winnerswinner2_best_cost_0(0), 7) or (not
          is_set(winnerswinner2_best_cost_0(1), 7));
      end if;
      if is_set(winnerswinner2_best_cost_0(2), 0) then
        winnerswinner3_of_pair_0_2_choice := (not is_set(winnerswinner2_best_cost_0(3), 1)) or (not
          is_set(winnerswinner2_best_cost_0(3), 0));
      else
        winnerswinner3_of_pair_0_2_choice := not is_set(winnerswinner2_best_cost_0(3), 1);
      end if;
      if is_set(winnerswinner2_best_cost_0(2), 1) then
        winnerswinner3_of_pair_0_2_choices(2) := winnerswinner3_of_pair_0_2_choice;
      else
        winnerswinner3_of_pair_0_2_choices(2) := is_set(winnerswinner2_best_cost_0(2), 0) and
          ((winnerswinner2_best_cost_0(3) mod 4) = 0);
      end if;
      winnerswinner3_of_pair_0_2_value := is_set(winnerswinner2_best_cost_0(3), 2);
      if winnerswinner3_of_pair_0_2_choices(2) then
        winnerswinner3_of_pair_0_2_choices(3) := (not is_set(winnerswinner2_best_cost_0(2), 2)) and
          winnerswinner3_of_pair_0_2_value;
      else
        winnerswinner3_of_pair_0_2_choices(3) := (not is_set(winnerswinner2_best_cost_0(2), 2)) or
          winnerswinner3_of_pair_0_2_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner3_of_pair_0_2_values(i) := is_set(winnerswinner2_best_cost_0(3), i + 1);
        if winnerswinner3_of_pair_0_2_choices(i + 1) then
          winnerswinner3_of_pair_0_2_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(2), i + 1)) or
            winnerswinner3_of_pair_0_2_values(i);
        else
          winnerswinner3_of_pair_0_2_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(2), i + 1)) and
            winnerswinner3_of_pair_0_2_values(i);
        end if;
      end loop;
      if winnerswinner3_of_pair_0_2_choices(7) then
        winnerswinner3_of_pair_0_2_choices(8) := is_set(winnerswinner2_best_cost_0(2), 7) and (not
          is_set(winnerswinner2_best_cost_0(3), 7));
      else
        winnerswinner3_of_pair_0_2_choices(8) := is_set(winnerswinner2_best_cost_0(2), 7) or (not
          is_set(winnerswinner2_best_cost_0(3), 7));
      end if;
      if is_set(winnerswinner3_of_pair_0(1), 0) then
        winnerswinner3_four_index_0_0_choice := (not is_set(winnerswinner3_of_pair_0(3), 0)) and (not
          is_set(winnerswinner3_of_pair_0(2), 0));
      else
        winnerswinner3_four_index_0_0_choice := is_set(winnerswinner3_of_pair_0(0), 0) and (not
          is_set(winnerswinner3_of_pair_0(3), 0)) and (not is_set(winnerswinner3_of_pair_0(2), 0));
      end if;
      winnerswinner3_four_index_0_0_value := is_set(winnerswinner3_of_pair_0(1), 1);
      winnerswinner3_four_index_0_0_values(2) := is_set(winnerswinner3_of_pair_0(0), 1);
      if (not is_set(winnerswinner3_of_pair_0(3), 1)) and (not is_set(winnerswinner3_of_pair_0(2), 1)) then
        winnerswinner3_four_index_0_0_choices(2) := winnerswinner3_four_index_0_0_choice or
          winnerswinner3_four_index_0_0_value or winnerswinner3_four_index_0_0_values(2);
      else
        winnerswinner3_four_index_0_0_choices(2) := winnerswinner3_four_index_0_0_choice and
          (winnerswinner3_four_index_0_0_value or winnerswinner3_four_index_0_0_values(2));
      end if;
      winnerswinner3_four_index_0_0_values(3) := is_set(winnerswinner3_of_pair_0(3), 2);
      winnerswinner3_four_index_0_0_values(4) := is_set(winnerswinner3_of_pair_0(2), 2);
      if winnerswinner3_four_index_0_0_choices(2) then
        winnerswinner3_four_index_0_0_choices(3) := (not is_set(winnerswinner3_of_pair_0(1), 2)) and (not
          is_set(winnerswinner3_of_pair_0(0), 2)) and (winnerswinner3_four_index_0_0_values(3) or
          winnerswinner3_four_index_0_0_values(4));
      else
        winnerswinner3_four_index_0_0_choices(3) := ((not is_set(winnerswinner3_of_pair_0(1), 2)) and (not
          is_set(winnerswinner3_of_pair_0(0), 2))) or winnerswinner3_four_index_0_0_values(3) or
          winnerswinner3_four_index_0_0_values(4);
      end if;
      for i in 3 to 6 loop
        winnerswinner3_four_index_0_0_values(2 * i - 1) := is_set(winnerswinner3_of_pair_0(3), i);
        winnerswinner3_four_index_0_0_values(2 * i) := is_set(winnerswinner3_of_pair_0(2), i);
        if winnerswinner3_four_index_0_0_choices(i) then
          winnerswinner3_four_index_0_0_choices(i + 1) := ((not is_set(winnerswinner3_of_pair_0(1), i)) and (not
            is_set(winnerswinner3_of_pair_0(0), i))) or winnerswinner3_four_index_0_0_values(2 * i - 1) or
            winnerswinner3_four_index_0_0_values(2 * i);
        else
          winnerswinner3_four_index_0_0_choices(i + 1) := (not is_set(winnerswinner3_of_pair_0(1), i)) and (not
            is_set(winnerswinner3_of_pair_0(0), i)) and (winnerswinner3_four_index_0_0_values(2 * i - 1) or
            winnerswinner3_four_index_0_0_values(2 * i));
        end if;
      end loop;
      if winnerswinner3_four_index_0_0_choices(7) then
        winnerswinner3_four_index_0_0_choices(8) := (not ((not is_set(winnerswinner3_of_pair_0(1), 7)) and (not
          is_set(winnerswinner3_of_pair_0(0), 7)))) and (not is_set(winnerswinner3_of_pair_0(3), 7)) and (not
          is_set(winnerswinner3_of_pair_0(2), 7));
      else
        winnerswinner3_four_index_0_0_choices(8) := (not ((not is_set(winnerswinner3_of_pair_0(1), 7)) and (not
          is_set(winnerswinner3_of_pair_0(0), 7)))) or ((not is_set(winnerswinner3_of_pair_0(3), 7)) and (not
          is_set(winnerswinner3_of_pair_0(2), 7)));
      end if;
      winnerswinner3_pair_tag_valid <= winnerswinner2_tag_valid;
      winnerswinner3_pair_tag_map_column <= winnerswinner2_tag_map_column;
      winnerswinner3_pair_tag_output_column <= winnerswinner2_tag_output_column;
      winnerswinner3_pair_tag_start_of_frame <= winnerswinner2_tag_start_of_frame;
      winnerswinner3_pair_tag_end_of_line <= winnerswinner2_tag_end_of_line;
      winnerswinner3_four_tag_valid <= winnerswinner3_pair_tag_valid;
      winnerswinner3_four_tag_map_column <= winnerswinner3_pair_tag_map_column;
      winnerswinner3_four_tag_output_column <= winnerswinner3_pair_tag_output_column;
      winnerswinner3_four_tag_start_of_frame <= winnerswinner3_pair_tag_start_of_frame;
      winnerswinner3_four_tag_end_of_line <= winnerswinner3_pair_tag_end_of_line;
      winnerswinner3_best_index_0_0 <= winnerswinner3_four_index_0_0;
      winnerswinner3_tag_valid <= winnerswinner3_four_tag_valid;
      winnerswinner3_tag_map_column <= winnerswinner3_four_tag_map_column;
      winnerswinner3_tag_output_column <= winnerswinner3_four_tag_output_column;
      winnerswinner3_tag_start_of_frame <= winnerswinner3_four_tag_start_of_frame;
      winnerswinner3_tag_end_of_line <= winnerswinner3_four_tag_end_of_line;
      if winnerswinner3_of_pair_0_0_choices(8) then
        winnerswinner3_of_pair_0(0) <= 0;
        winnerswinner3_of_pair_0(1) <= winnerswinner2_best_cost_0(1);
        winnerswinner3_pair_index_0_0 <= winnerswinner2_best_index_0_1;
      else
        winnerswinner3_of_pair_0(0) <= winnerswinner2_best_cost_0(0);
        winnerswinner3_of_pair_0(1) <= 0;
        winnerswinner3_pair_index_0_0 <= winnerswinner2_best_index_0_0;
      end if;
      if winnerswinner3_of_pair_0_2_choices(8) then
        winnerswinner3_of_pair_0(2) <= 0;
        winnerswinner3_of_pair_0(3) <= winnerswinner2_best_cost_0(3);
        winnerswinner3_pair_index_0_1 <= winnerswinner2_best_index_0_3;
      else
        winnerswinner3_of_pair_0(2) <= winnerswinner2_best_cost_0(2);
        winnerswinner3_of_pair_0(3) <= 0;
        winnerswinner3_pair_index_0_1 <= winnerswinner2_best_index_0_2;
      end if;
      if winnerswinner3_four_index_0_0_choices(8) then
        winnerswinner3_four_index_0_0 <= winnerswinner3_pair_index_0_1;
      else
        winnerswinner3_four_index_0_0 <= winnerswinner3_pair_index_0_0;
      end if;
      -- winners
      winners_best_index_0_0 <= winnerswinner3_best_index_0_0;
      winners_best_tag_valid <= winnerswinner3_tag_valid;
      winners_best_tag_map_column <= winnerswinner3_tag_map_column;
      winners_best_tag_output_column <= winnerswinner3_tag_output_column;
      winners_best_tag_start_of_frame <= winnerswinner3_tag_start_of_frame;
      winners_best_tag_end_of_line <= winnerswinner3_tag_end_of_line;
      -- turn
      turn_order_address_any := turn_order_turned_map_column or (not winners_best_tag_map_column) or (not
        winners_best_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 2047;
      else
        turn_order_address_choice := 1;
      end if;
      if turn_order_falls then
        turn_order_address_choice_2 := 0;
      else
        turn_order_address_choice_2 := 19;
      end if;
      turn_order_address_any_2 := (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 2048;
        else
          turn_order_address <= turn_order_address_choice_2 * 64;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_turned_map_column) and winners_best_tag_map_column and
        winners_best_tag_valid;
      turn_order_complete_all := winners_best_tag_map_column and winners_best_tag_valid;
      turn_ready_tag_row_start_differs := map_counter_group /= 721;
      turn_ready_tag_row_start_is_equal := map_counter_column = 1216;
      if turn_ready_tag_row_start_is_equal then
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start and (map_counter_group /= 720);
      else
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start;
      end if;
      if turn_ready_tag_row_start_differs then
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start_choice;
      else
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start;
      end if;
      turn_ready_tag_row_start_is_equal_2 := map_counter_group = 719;
      turn_ready_tag_row_start_all := turn_ready_tag_row_start_is_equal_2 and turn_ready_tag_row_start_is_equal;
      if turn_ready_tag_row_start_choices(2) then
        turn_ready_tag_row_start_choices(3) := (not turn_ready_tag_start_of_frame) or turn_ready_tag_row_start_all;
      else
        turn_ready_tag_row_start_choices(3) := turn_ready_tag_start_of_frame and turn_ready_tag_row_start_is_equal_2
          and turn_ready_tag_row_start_is_equal;
      end if;
      turn_ready_tag_row_start_all_2 := turn_ready_tag_valid and turn_ready_tag_map_column;
      turn_order_inside <= winners_best_tag_map_column;
      turn_order_turned_valid <= winners_best_tag_valid;
      turn_order_turned_start_of_frame <= (not turn_order_turned_map_column) and winners_best_tag_map_column and
        winners_best_tag_valid and turn_order_first and turn_order_output and turn_order_complete;
      turn_order_turned_end_of_line <= winners_best_tag_end_of_line;
      turn_newest <= winners_best_index_0_0 + 256;
      turn_comes <= turn_order_complete_all;
      turn_read_tag_valid <= turn_order_turned_valid;
      turn_read_tag_map_column <= turn_order_inside;
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
      if turn_ready_tag_row_start_choices(3) then
        turn_ready_tag_row_start <= turn_ready_tag_row_start or turn_ready_tag_row_start_all_2;
      else
        turn_ready_tag_row_start <= turn_ready_tag_row_start and ((not turn_ready_tag_valid) or (not
          turn_ready_tag_map_column));
      end if;
      if turn_order_falls_all then
        turn_order_output <= winners_best_tag_output_column;
        turn_order_first <= winners_best_tag_start_of_frame;
      end if;
      if winners_best_tag_valid then
        turn_order_turned_map_column <= winners_best_tag_map_column;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
        turn_write_place <= turn_order_address;
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
        map_counter_group_choice := 45;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 720;
      if turn_ready_tag_row_start and map_counter_group_is_equal then
        map_counter_group_choices(2) := 1;
      else
        map_counter_group_choices(2) := (map_counter_group + 1) mod 1024;
      end if;
      if turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equal and turn_ready_tag_valid and
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
      map_at_arrives_value := other_16(16) = '1';
      map_of_column_0_b_below_a_value := is_set(map_column(1), 2);
      if map_at_top then
        map_of_column_0_b_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_b_below_a_choice := is_set(other_17, 2);
      end if;
      map_of_column_0_b_below_a_values(2) := is_set(map_column(1), 1);
      if map_at_top then
        map_of_column_0_b_below_a_choices(2) := map_of_column_0_b_below_a_values(2);
      else
        map_of_column_0_b_below_a_choices(2) := is_set(other_17, 1);
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
      map_of_column_0_b_below_a_values(4) := is_set(other_17, 3);
      if map_of_column_0_b_below_a_choices(4) then
        map_of_column_0_b_below_a_choices(5) := map_of_column_0_b_below_a_values(3) and (not
          map_of_column_0_b_below_a_values(4)) and (not map_at_top);
      else
        map_of_column_0_b_below_a_choices(5) := map_of_column_0_b_below_a_values(3) or (not
          map_of_column_0_b_below_a_values(4)) or map_at_top;
      end if;
      for i in 4 to 5 loop
        map_of_column_0_b_below_a_values(2 * i - 3) := is_set(map_column(1), i);
        map_of_column_0_b_below_a_values(2 * i - 2) := is_set(other_17, i);
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
      for i in 3 to 5 loop
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
        map_of_column_0_c_below_a_choices(13) := is_set(map_column(1), 6);
      else
        map_of_column_0_c_below_a_choices(13) := is_set(map_column(2), 6);
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choices(14) := is_set(map_column(1), 6);
      else
        map_of_column_0_c_below_a_choices(14) := is_set(other_17, 6);
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
      for i in 2 to 3 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      for i in 3 to 4 loop
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
      map_counter_next_frame <= other_16(40) = '1';
      map_newest_0 <= ((turn_ready mod 64) * 2) + (turn_ready / 256);
      map_arrives <= turn_ready_tag_row_start_all_2;
      map_behind <= map_line_ended and turn_ready_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_write_column <= to_integer(other_16(10 downto 0));
      map_column(1) <= map_rows_ready_words_0 / 512;
      map_column(2) <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= other_16(24) = '1';
      map_at_top <= other_16(32) = '1';
      map_at_output <= other_16(48) = '1';
      map_of_column_0_b <= map_column(1) / 2;
      map_column_passed_0(0) <= is_set(map_column(1), 0);
      map_column_passed_0(1) <= map_column_passed_0(0);
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
        map_of_column_0_a <= other_17 / 2;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c <= map_column(1) / 2;
      else
        map_of_column_0_c <= map_column(2) / 2;
      end if;
      if map_of_column_0_b_below_a_choices(7) then
        map_of_column_0_b_below_a <= (not is_set(map_column(1), 6)) and is_set(other_17, 6) and (not map_at_top);
      else
        map_of_column_0_b_below_a <= (not is_set(map_column(1), 6)) or is_set(other_17, 6) or map_at_top;
      end if;
      if map_of_column_0_c_below_a_choices(12) then
        map_of_column_0_c_below_a <= (not map_of_column_0_c_below_a_choices(13)) or
          map_of_column_0_c_below_a_choices(14);
      else
        map_of_column_0_c_below_a <= (not map_of_column_0_c_below_a_choices(13)) and
          map_of_column_0_c_below_a_choices(14);
      end if;
      if map_of_column_0_c_below_b_choices(4) then
        map_of_column_0_c_below_b <= (not is_set(map_column(2), 6)) and is_set(map_column(1), 6) and (not
          map_counter_next_frame);
      else
        map_of_column_0_c_below_b <= (not is_set(map_column(2), 6)) or is_set(map_column(1), 6) or
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
      if map_of_low_0_b_below_a_choices(5) then
        map_of_low_0_b_below_a <= is_set(map_low_0(0), 5) and (not is_set(map_low_0(1), 5));
      else
        map_of_low_0_b_below_a <= is_set(map_low_0(0), 5) or (not is_set(map_low_0(1), 5));
      end if;
      if map_of_low_0_c_below_a_choices(5) then
        map_of_low_0_c_below_a <= (not is_set(map_low_0(2), 5)) or is_set(map_low_0(0), 5);
      else
        map_of_low_0_c_below_a <= (not is_set(map_low_0(2), 5)) and is_set(map_low_0(0), 5);
      end if;
      if map_of_low_0_c_below_b_choices(5) then
        map_of_low_0_c_below_b <= (not is_set(map_low_0(2), 5)) or is_set(map_low_0(1), 5);
      else
        map_of_low_0_c_below_b <= (not is_set(map_low_0(2), 5)) and is_set(map_low_0(1), 5);
      end if;
      if map_of_middle_0_b_below_a_choices(5) then
        map_of_middle_0_b_below_a <= is_set(map_middle_0(0), 5) and (not is_set(map_middle_0(1), 5));
      else
        map_of_middle_0_b_below_a <= is_set(map_middle_0(0), 5) or (not is_set(map_middle_0(1), 5));
      end if;
      if map_of_middle_0_c_below_a_choices(5) then
        map_of_middle_0_c_below_a <= (not is_set(map_middle_0(2), 5)) or is_set(map_middle_0(0), 5);
      else
        map_of_middle_0_c_below_a <= (not is_set(map_middle_0(2), 5)) and is_set(map_middle_0(0), 5);
      end if;
      if map_of_middle_0_c_below_b_choices(5) then
        map_of_middle_0_c_below_b <= (not is_set(map_middle_0(2), 5)) or is_set(map_middle_0(1), 5);
      else
        map_of_middle_0_c_below_b <= (not is_set(map_middle_0(2), 5)) and is_set(map_middle_0(1), 5);
      end if;
      if map_of_high_0_b_below_a_choices(5) then
        map_of_high_0_b_below_a <= is_set(map_high_0(0), 5) and (not is_set(map_high_0(1), 5));
      else
        map_of_high_0_b_below_a <= is_set(map_high_0(0), 5) or (not is_set(map_high_0(1), 5));
      end if;
      if map_of_high_0_c_below_a_choices(5) then
        map_of_high_0_c_below_a <= (not is_set(map_high_0(2), 5)) or is_set(map_high_0(0), 5);
      else
        map_of_high_0_c_below_a <= (not is_set(map_high_0(2), 5)) and is_set(map_high_0(0), 5);
      end if;
      if map_of_high_0_c_below_b_choices(5) then
        map_of_high_0_c_below_b <= (not is_set(map_high_0(2), 5)) or is_set(map_high_0(1), 5);
      else
        map_of_high_0_c_below_b <= (not is_set(map_high_0(2), 5)) and is_set(map_high_0(1), 5);
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
      if map_of_all_0_b_below_a_choices(5) then
        map_of_all_0_b_below_a <= is_set(map_largest_low_0, 5) and (not is_set(map_median_middle_0, 5));
      else
        map_of_all_0_b_below_a <= is_set(map_largest_low_0, 5) or (not is_set(map_median_middle_0, 5));
      end if;
      if map_of_all_0_c_below_a_choices(5) then
        map_of_all_0_c_below_a <= (not is_set(map_smallest_high_0, 5)) or is_set(map_largest_low_0, 5);
      else
        map_of_all_0_c_below_a <= (not is_set(map_smallest_high_0, 5)) and is_set(map_largest_low_0, 5);
      end if;
      if map_of_all_0_c_below_b_choices(5) then
        map_of_all_0_c_below_b <= (not is_set(map_smallest_high_0, 5)) or is_set(map_median_middle_0, 5);
      else
        map_of_all_0_c_below_b <= (not is_set(map_smallest_high_0, 5)) and is_set(map_median_middle_0, 5);
      end if;
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choices(2);
      else
        map_out_disparity_0 <= map_out_disparity_0_choices(4);
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= (map_rows_ready_words_0 / 512) + (map_rows_ready_newest_0 * 512);
        map_at_column <= to_integer(other_16(10 downto 0));
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
        relief_centre_column(0) <= transform_left_column(2);
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
      relief_delayed_0 <= relief_newest;
      relief_shown_0 <= relief_delayed_0;
      relief_waiting(0) <= relief_shown_0;
      for i in 1 to 9 loop
        relief_waiting(i) <= relief_waiting(i - 1);
      end loop;
      relief_entered <= relief_entering;
      if ((not ((not ((not ((not relief_newest_choices(9)) and relief_newest_choices(10) and
        relief_newest_choices(11))) and relief_newest_choices(12))) and relief_newest_choices(13))) and
        relief_newest_choices(14)) or relief_newest_choices(15) then
        relief_newest <= 40;
      else
        relief_newest <= relief_newest_choice_17;
      end if;
      if relief_waiting(9) < 40 then
        relief_entering <= relief_waiting(9);
      else
        relief_entering <= 40;
      end if;
      if transform_filtering_valid(1) then
        relief_before <= relief_centre_grey_0;
      end if;
      -- other
      for i in 0 to 15 loop
        if entry_tag_valid then
          other_choices(i) := forward_left_cost(61 - 4 * i) + forward_above_cost(61 - 4 * i);
        else
          other_choices(i) := to_integer(other(i)(15 downto 8));
        end if;
        for j in 2 to 3 loop
          if entry_tag_valid then
            other_choice(i, j) := forward_left_cost(2 * j + 56 - 4 * i) + forward_above_cost(2 * j + 56 - 4 * i);
          else
            other_choice(i, j) := to_integer(other(i)(16 * j - 25 downto 16 * j - 32));
          end if;
        end loop;
        if entry_tag_valid then
          other_choice_4(i) := forward_left_cost(63 - 4 * i) + forward_above_cost(63 - 4 * i);
        else
          other_choice_4(i) := to_integer(other(i)(31 downto 24));
        end if;
      end loop;
      if slice0_tag_0_border_column then
        other_20_choice := 0;
      else
        other_20_choice := slice3cost_single_0(15) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_22_choice := 0;
      else
        other_22_choice := slice3cost_single_0(14) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_24_choice := 0;
      else
        other_24_choice := slice3cost_single_0(13) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_26_choice := 0;
      else
        other_26_choice := slice3cost_single_0(12) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_28_choice := 0;
      else
        other_28_choice := slice3cost_single_0(11) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_30_choice := 0;
      else
        other_30_choice := slice3cost_single_0(10) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_32_choice := 0;
      else
        other_32_choice := slice3cost_single_0(9) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_34_choice := 0;
      else
        other_34_choice := slice3cost_single_0(8) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_36_choice := 0;
      else
        other_36_choice := slice3cost_single_0(7) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_38_choice := 0;
      else
        other_38_choice := slice3cost_single_0(6) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_40_choice := 0;
      else
        other_40_choice := slice3cost_single_0(5) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_42_choice := 0;
      else
        other_42_choice := slice3cost_single_0(4) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_44_choice := 0;
      else
        other_44_choice := slice3cost_single_0(3) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_46_choice := 0;
      else
        other_46_choice := slice3cost_single_0(2) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_48_choice := 0;
      else
        other_48_choice := slice3cost_single_0(1) / 2;
      end if;
      if slice0_tag_0_border_column then
        other_50_choice := 0;
      else
        other_50_choice := slice3cost_single_0(0) / 2;
      end if;
      if slice0window_tag_border_column then
        other_52_choice := 0;
      else
        other_52_choice := slice2cost_single_0(15) / 2;
      end if;
      if slice0window_tag_border_column then
        other_54_choice := 0;
      else
        other_54_choice := slice2cost_single_0(14) / 2;
      end if;
      if slice0window_tag_border_column then
        other_56_choice := 0;
      else
        other_56_choice := slice2cost_single_0(13) / 2;
      end if;
      if slice0window_tag_border_column then
        other_58_choice := 0;
      else
        other_58_choice := slice2cost_single_0(12) / 2;
      end if;
      if slice0window_tag_border_column then
        other_60_choice := 0;
      else
        other_60_choice := slice2cost_single_0(11) / 2;
      end if;
      if slice0window_tag_border_column then
        other_62_choice := 0;
      else
        other_62_choice := slice2cost_single_0(10) / 2;
      end if;
      if slice0window_tag_border_column then
        other_64_choice := 0;
      else
        other_64_choice := slice2cost_single_0(9) / 2;
      end if;
      if slice0window_tag_border_column then
        other_66_choice := 0;
      else
        other_66_choice := slice2cost_single_0(8) / 2;
      end if;
      if slice0window_tag_border_column then
        other_68_choice := 0;
      else
        other_68_choice := slice2cost_single_0(7) / 2;
      end if;
      if slice0window_tag_border_column then
        other_70_choice := 0;
      else
        other_70_choice := slice2cost_single_0(6) / 2;
      end if;
      if slice0window_tag_border_column then
        other_72_choice := 0;
      else
        other_72_choice := slice2cost_single_0(5) / 2;
      end if;
      if slice0window_tag_border_column then
        other_74_choice := 0;
      else
        other_74_choice := slice2cost_single_0(4) / 2;
      end if;
      if slice0window_tag_border_column then
        other_76_choice := 0;
      else
        other_76_choice := slice2cost_single_0(3) / 2;
      end if;
      if slice0window_tag_border_column then
        other_78_choice := 0;
      else
        other_78_choice := slice2cost_single_0(2) / 2;
      end if;
      if slice0window_tag_border_column then
        other_80_choice := 0;
      else
        other_80_choice := slice2cost_single_0(1) / 2;
      end if;
      if slice0window_tag_border_column then
        other_82_choice := 0;
      else
        other_82_choice := slice2cost_single_0(0) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_84_choice := 0;
      else
        other_84_choice := slice1cost_single_0(15) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_86_choice := 0;
      else
        other_86_choice := slice1cost_single_0(14) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_88_choice := 0;
      else
        other_88_choice := slice1cost_single_0(13) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_90_choice := 0;
      else
        other_90_choice := slice1cost_single_0(12) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_92_choice := 0;
      else
        other_92_choice := slice1cost_single_0(11) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_94_choice := 0;
      else
        other_94_choice := slice1cost_single_0(10) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_96_choice := 0;
      else
        other_96_choice := slice1cost_single_0(9) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_98_choice := 0;
      else
        other_98_choice := slice1cost_single_0(8) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_100_choice := 0;
      else
        other_100_choice := slice1cost_single_0(7) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_102_choice := 0;
      else
        other_102_choice := slice1cost_single_0(6) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_104_choice := 0;
      else
        other_104_choice := slice1cost_single_0(5) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_106_choice := 0;
      else
        other_106_choice := slice1cost_single_0(4) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_108_choice := 0;
      else
        other_108_choice := slice1cost_single_0(3) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_110_choice := 0;
      else
        other_110_choice := slice1cost_single_0(2) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_112_choice := 0;
      else
        other_112_choice := slice1cost_single_0(1) / 2;
      end if;
      if slice0cost_tag_border_column then
        other_114_choice := 0;
      else
        other_114_choice := slice1cost_single_0(0) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_116_choice := 0;
      else
        other_116_choice := slice0cost_single_0(15) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_118_choice := 0;
      else
        other_118_choice := slice0cost_single_0(14) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_120_choice := 0;
      else
        other_120_choice := slice0cost_single_0(13) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_122_choice := 0;
      else
        other_122_choice := slice0cost_single_0(12) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_124_choice := 0;
      else
        other_124_choice := slice0cost_single_0(11) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_126_choice := 0;
      else
        other_126_choice := slice0cost_single_0(10) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_128_choice := 0;
      else
        other_128_choice := slice0cost_single_0(9) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_130_choice := 0;
      else
        other_130_choice := slice0cost_single_0(8) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_132_choice := 0;
      else
        other_132_choice := slice0cost_single_0(7) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_134_choice := 0;
      else
        other_134_choice := slice0cost_single_0(6) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_136_choice := 0;
      else
        other_136_choice := slice0cost_single_0(5) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_138_choice := 0;
      else
        other_138_choice := slice0cost_single_0(4) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_140_choice := 0;
      else
        other_140_choice := slice0cost_single_0(3) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_142_choice := 0;
      else
        other_142_choice := slice0cost_single_0(2) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_144_choice := 0;
      else
        other_144_choice := slice0cost_single_0(1) / 2;
      end if;
      if slice0cost_pair_tag_border_column then
        other_146_choice := 0;
      else
        other_146_choice := slice0cost_single_0(0) / 2;
      end if;
      for i in 0 to 15 loop
        other(i) <= to_unsigned(other_choice_4(i), 8) & to_unsigned(other_choice(i, 3), 8) &
          to_unsigned(other_choices(i), 8) & to_unsigned(other_choice(i, 2), 8);
      end loop;
      other_16 <= other_18;
      other_17 <= (((map_rows_ready_words_0 mod 512) / 2) mod 64) * 2;
      other_18 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 721))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      others_from_19(19) <= others_from_19(20);
      others_from_19(20) <= other_20_choice * 2;
      others_from_19(21) <= others_from_19(22);
      others_from_19(22) <= other_22_choice * 2;
      others_from_19(23) <= others_from_19(24);
      others_from_19(24) <= other_24_choice * 2;
      others_from_19(25) <= others_from_19(26);
      others_from_19(26) <= other_26_choice * 2;
      others_from_19(27) <= others_from_19(28);
      others_from_19(28) <= other_28_choice * 2;
      others_from_19(29) <= others_from_19(30);
      others_from_19(30) <= other_30_choice * 2;
      others_from_19(31) <= others_from_19(32);
      others_from_19(32) <= other_32_choice * 2;
      others_from_19(33) <= others_from_19(34);
      others_from_19(34) <= other_34_choice * 2;
      others_from_19(35) <= others_from_19(36);
      others_from_19(36) <= other_36_choice * 2;
      others_from_19(37) <= others_from_19(38);
      others_from_19(38) <= other_38_choice * 2;
      others_from_19(39) <= others_from_19(40);
      others_from_19(40) <= other_40_choice * 2;
      others_from_19(41) <= others_from_19(42);
      others_from_19(42) <= other_42_choice * 2;
      others_from_19(43) <= others_from_19(44);
      others_from_19(44) <= other_44_choice * 2;
      others_from_19(45) <= others_from_19(46);
      others_from_19(46) <= other_46_choice * 2;
      others_from_19(47) <= others_from_19(48);
      others_from_19(48) <= other_48_choice * 2;
      others_from_19(49) <= others_from_19(50);
      others_from_19(50) <= other_50_choice * 2;
      others_from_19(51) <= others_from_19(52);
      others_from_19(52) <= other_52_choice * 2;
      others_from_19(53) <= others_from_19(54);
      others_from_19(54) <= other_54_choice * 2;
      others_from_19(55) <= others_from_19(56);
      others_from_19(56) <= other_56_choice * 2;
      others_from_19(57) <= others_from_19(58);
      others_from_19(58) <= other_58_choice * 2;
      others_from_19(59) <= others_from_19(60);
      others_from_19(60) <= other_60_choice * 2;
      others_from_19(61) <= others_from_19(62);
      others_from_19(62) <= other_62_choice * 2;
      others_from_19(63) <= others_from_19(64);
      others_from_19(64) <= other_64_choice * 2;
      others_from_19(65) <= others_from_19(66);
      others_from_19(66) <= other_66_choice * 2;
      others_from_19(67) <= others_from_19(68);
      others_from_19(68) <= other_68_choice * 2;
      others_from_19(69) <= others_from_19(70);
      others_from_19(70) <= other_70_choice * 2;
      others_from_19(71) <= others_from_19(72);
      others_from_19(72) <= other_72_choice * 2;
      others_from_19(73) <= others_from_19(74);
      others_from_19(74) <= other_74_choice * 2;
      others_from_19(75) <= others_from_19(76);
      others_from_19(76) <= other_76_choice * 2;
      others_from_19(77) <= others_from_19(78);
      others_from_19(78) <= other_78_choice * 2;
      others_from_19(79) <= others_from_19(80);
      others_from_19(80) <= other_80_choice * 2;
      others_from_19(81) <= others_from_19(82);
      others_from_19(82) <= other_82_choice * 2;
      others_from_19(83) <= others_from_19(84);
      others_from_19(84) <= other_84_choice * 2;
      others_from_19(85) <= others_from_19(86);
      others_from_19(86) <= other_86_choice * 2;
      others_from_19(87) <= others_from_19(88);
      others_from_19(88) <= other_88_choice * 2;
      others_from_19(89) <= others_from_19(90);
      others_from_19(90) <= other_90_choice * 2;
      others_from_19(91) <= others_from_19(92);
      others_from_19(92) <= other_92_choice * 2;
      others_from_19(93) <= others_from_19(94);
      others_from_19(94) <= other_94_choice * 2;
      others_from_19(95) <= others_from_19(96);
      others_from_19(96) <= other_96_choice * 2;
      others_from_19(97) <= others_from_19(98);
      others_from_19(98) <= other_98_choice * 2;
      others_from_19(99) <= others_from_19(100);
      others_from_19(100) <= other_100_choice * 2;
      others_from_19(101) <= others_from_19(102);
      others_from_19(102) <= other_102_choice * 2;
      others_from_19(103) <= others_from_19(104);
      others_from_19(104) <= other_104_choice * 2;
      others_from_19(105) <= others_from_19(106);
      others_from_19(106) <= other_106_choice * 2;
      others_from_19(107) <= others_from_19(108);
      others_from_19(108) <= other_108_choice * 2;
      others_from_19(109) <= others_from_19(110);
      others_from_19(110) <= other_110_choice * 2;
      others_from_19(111) <= others_from_19(112);
      others_from_19(112) <= other_112_choice * 2;
      others_from_19(113) <= others_from_19(114);
      others_from_19(114) <= other_114_choice * 2;
      others_from_19(115) <= others_from_19(116);
      others_from_19(116) <= other_116_choice * 2;
      others_from_19(117) <= others_from_19(118);
      others_from_19(118) <= other_118_choice * 2;
      others_from_19(119) <= others_from_19(120);
      others_from_19(120) <= other_120_choice * 2;
      others_from_19(121) <= others_from_19(122);
      others_from_19(122) <= other_122_choice * 2;
      others_from_19(123) <= others_from_19(124);
      others_from_19(124) <= other_124_choice * 2;
      others_from_19(125) <= others_from_19(126);
      others_from_19(126) <= other_126_choice * 2;
      others_from_19(127) <= others_from_19(128);
      others_from_19(128) <= other_128_choice * 2;
      others_from_19(129) <= others_from_19(130);
      others_from_19(130) <= other_130_choice * 2;
      others_from_19(131) <= others_from_19(132);
      others_from_19(132) <= other_132_choice * 2;
      others_from_19(133) <= others_from_19(134);
      others_from_19(134) <= other_134_choice * 2;
      others_from_19(135) <= others_from_19(136);
      others_from_19(136) <= other_136_choice * 2;
      others_from_19(137) <= others_from_19(138);
      others_from_19(138) <= other_138_choice * 2;
      others_from_19(139) <= others_from_19(140);
      others_from_19(140) <= other_140_choice * 2;
      others_from_19(141) <= others_from_19(142);
      others_from_19(142) <= other_142_choice * 2;
      others_from_19(143) <= others_from_19(144);
      others_from_19(144) <= other_144_choice * 2;
      others_from_19(145) <= others_from_19(146);
      others_from_19(146) <= other_146_choice * 2;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 722;
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
        raster_place_group <= 720;
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
        slice0window_tag_valid <= false;
        slice0window_tag_first_cost <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        for i in 0 to 3 loop
          slice0_tag_valid(i) <= false;
          slice0_tag_first_cost(i) <= false;
          slice0_tag_map_column(i) <= false;
          slice0_tag_output_column(i) <= false;
          slice0_tag_start_of_frame(i) <= false;
          slice0_tag_end_of_line(i) <= false;
        end loop;
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
        for i in 0 to 11 loop
          forward_above_comes(i) <= false;
        end loop;
        for i in 0 to 11 loop
          forward_above_column(i) <= 0;
        end loop;
        forward_above_writes_copy_0 <= false;
        forward_above_write_column <= 0;
        for i in 0 to 10 loop
          sums_turn_place(i) <= 0;
        end loop;
        sums_turn_writes_copy_0 <= false;
        sums_turn_write_place <= 0;
        sums_sum_delay_ring_read_address <= 1;
        sums_sum_delay_ring_write_address <= 0;
        sums_tag_valid <= false;
        sums_tag_map_column <= false;
        sums_tag_output_column <= false;
        sums_tag_start_of_frame <= false;
        sums_tag_end_of_line <= false;
        for i in 0 to 4 loop
          sums_tags_held_output_column(i) <= false;
          sums_tags_held_start_of_frame(i) <= false;
          sums_tags_held_end_of_line(i) <= false;
        end loop;
        sums_tags_moved <= false;
        winnerswinner1_pair_tag_valid <= false;
        winnerswinner1_pair_tag_map_column <= false;
        winnerswinner1_pair_tag_output_column <= false;
        winnerswinner1_pair_tag_start_of_frame <= false;
        winnerswinner1_pair_tag_end_of_line <= false;
        winnerswinner1_four_tag_valid <= false;
        winnerswinner1_four_tag_map_column <= false;
        winnerswinner1_four_tag_output_column <= false;
        winnerswinner1_four_tag_start_of_frame <= false;
        winnerswinner1_four_tag_end_of_line <= false;
        winnerswinner1_tag_valid <= false;
        winnerswinner1_tag_map_column <= false;
        winnerswinner1_tag_output_column <= false;
        winnerswinner1_tag_start_of_frame <= false;
        winnerswinner1_tag_end_of_line <= false;
        winnerswinner2_pair_tag_valid <= false;
        winnerswinner2_pair_tag_map_column <= false;
        winnerswinner2_pair_tag_output_column <= false;
        winnerswinner2_pair_tag_start_of_frame <= false;
        winnerswinner2_pair_tag_end_of_line <= false;
        winnerswinner2_four_tag_valid <= false;
        winnerswinner2_four_tag_map_column <= false;
        winnerswinner2_four_tag_output_column <= false;
        winnerswinner2_four_tag_start_of_frame <= false;
        winnerswinner2_four_tag_end_of_line <= false;
        winnerswinner2_tag_valid <= false;
        winnerswinner2_tag_map_column <= false;
        winnerswinner2_tag_output_column <= false;
        winnerswinner2_tag_start_of_frame <= false;
        winnerswinner2_tag_end_of_line <= false;
        winnerswinner3_pair_tag_valid <= false;
        winnerswinner3_pair_tag_map_column <= false;
        winnerswinner3_pair_tag_output_column <= false;
        winnerswinner3_pair_tag_start_of_frame <= false;
        winnerswinner3_pair_tag_end_of_line <= false;
        winnerswinner3_four_tag_valid <= false;
        winnerswinner3_four_tag_map_column <= false;
        winnerswinner3_four_tag_output_column <= false;
        winnerswinner3_four_tag_start_of_frame <= false;
        winnerswinner3_four_tag_end_of_line <= false;
        winnerswinner3_tag_valid <= false;
        winnerswinner3_tag_map_column <= false;
        winnerswinner3_tag_output_column <= false;
        winnerswinner3_tag_start_of_frame <= false;
        winnerswinner3_tag_end_of_line <= false;
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
        map_counter_group <= 721;
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
        other_16 <= to_unsigned(0, 49);
        other_18 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
