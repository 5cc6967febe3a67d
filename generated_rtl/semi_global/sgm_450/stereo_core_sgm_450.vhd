-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_450: 450x375, 64 disparities, window 3x3, P1 7, P2 60, 1 pixel pair a clock.
-- Options: reference left, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap 5, p1 7, p2 60,
--   p2_least 20, above_p1 5, above_p2 31, median true, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_450
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_450 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 387;
    latency_clocks : positive := 49;
    flush_groups : positive := 2710;
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
  assert width_px = 450 report "stereo_core_sgm_450: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_sgm_450: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 64 report "stereo_core_sgm_450: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_450: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_sgm_450: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 387 report "stereo_core_sgm_450: output_width_px is " & integer'image(output_width_px) & " but this core has 387" severity failure;
  assert latency_clocks = 49 report "stereo_core_sgm_450: latency_clocks is " & integer'image(latency_clocks) & " but this core has 49" severity failure;
  assert flush_groups = 2710 report "stereo_core_sgm_450: flush_groups is " & integer'image(flush_groups) & " but this core has 2710" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_450: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_450 is
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

  -- the majority: a comparison or a sum as a chain of its bits
  function carry(before : boolean; a : boolean; b : boolean) return boolean is
  begin
    if before then
      return a or b;
    end if;
    return a and b;
  end function;

  function inverted_carry(before : boolean; a : boolean; b : boolean) return boolean is
  begin
    if before then
      return a and b;
    end if;
    return a or b;
  end function;

  -- whether a > b, of bits `low` to `high`; of equal ones, `before`: bit by bit, as the tool has split it
  function is_larger(a : natural; b : natural; low : natural; high : natural; before : boolean) return boolean is
    variable is_not : boolean := not before;
  begin
    for place in low to high loop
      is_not := carry(is_not, not is_set(a, place), is_set(b, place));
    end loop;
    return not is_not;
  end function;

  function smaller(a : integer; b : integer) return integer is
  begin
    if (a - b) < 0 then
      return a;
    end if;
    return b;
  end function;

  -- 1 where this bit differs
  function differing(a : natural; b : natural; place : natural) return natural is
  begin
    return as_number(is_set(a, place) /= is_set(b, place));
  end function;

  function differing(a : natural; b : natural; p : natural; q : natural; r : natural) return natural is
  begin
    return differing(a, b, p) + differing(a, b, q) + differing(a, b, r);
  end function;

  function choice(test : boolean; yes : boolean; no : boolean) return boolean is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

  function choice(test : boolean; yes : integer; no : integer) return integer is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

  type boolean_1d is array (natural range <>) of boolean;
  type boolean_2d is array (natural range <>, natural range <>) of boolean;
  type natural_1073741823_1d is array (natural range <>) of natural range 0 to 1073741823;
  type natural_126_1d is array (natural range <>) of natural range 0 to 126;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_14_1d is array (natural range <>) of natural range 0 to 14;
  type natural_14_2d is array (natural range <>, natural range <>) of natural range 0 to 14;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_15_2d is array (natural range <>, natural range <>) of natural range 0 to 15;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16383_2d is array (natural range <>, natural range <>) of natural range 0 to 16383;
  type natural_190_1d is array (natural range <>) of natural range 0 to 190;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_28_1d is array (natural range <>) of natural range 0 to 28;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_46_1d is array (natural range <>) of natural range 0 to 46;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_68_1d is array (natural range <>) of natural range 0 to 68;
  type natural_68_2d is array (natural range <>, natural range <>) of natural range 0 to 68;
  type natural_7_2d is array (natural range <>, natural range <>) of natural range 0 to 7;
  type natural_84_1d is array (natural range <>) of natural range 0 to 84;
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type tag_7 is record
    valid, border_column, first_cost, map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_6 is record
    valid, map_column, output_column, first_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, map_column, first_column, end_of_line : boolean;
  end record;
  type tag_5 is record
    valid, map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4_b is record
    valid, map_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_5_b is record
    valid, row_start, map_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0, transform_left_rows_ready_newest_0,
    transform_right_rows_read_newest_0, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 2);  -- _2#
  signal transform_left_filter_column, transform_right_filter_column : natural_255_2d(0 to 8, 0 to 2);  -- _#_2#
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_read_row_inside : boolean_1d(0 to 2);  -- _2#
  signal transform_read_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside : boolean_1d(0 to 2);  -- _2#
  signal transform_ready_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_columns_row_inside : boolean_1d(0 to 2);  -- _2#
  signal transform_columns_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- _#_valid
  signal transform_counter_column, transform_counter_group, transform_read_column, transform_ready_column,
    transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0, transform_left_rows_write_words_0,
    transform_right_rows_read_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16383;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag : tag_7;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_search, rows_reference : natural_16383_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag : tag_7;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag, rows_tag : tag_7;
  -- slice0shift
  signal slice0shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice0shift_reference, slice0shift_search_out : natural_16383_1d(0 to 2);
  signal slice0shift_tag : tag_7;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- _#_#_count_#
  signal slice0cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- _#_#_count_4
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_pair_tag, slice0cost_tag : tag_7;
  signal slice0cost_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal slice0cost_single_0 : natural_14_1d(0 to 15);
  signal slice0cost_pair_0 : natural_28_1d(0 to 15);
  signal slice0cost_column_0 : natural_42_1d(0 to 15);
  -- slice0window
  signal slice0window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice0window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0, slice0window_centre_first_column_0,
    slice0window_centre_start_of_frame_0, slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_6;
  signal slice0window_sum_0 : natural_126_1d(0 to 15);
  -- slice0
  signal slice0_held : natural_15_2d(0 to 3, 0 to 15);
  signal slice0_tag_valid : boolean_1d(0 to 3);  -- _#_valid
  signal slice0_tag_map_column : boolean_1d(0 to 3);  -- _#_map_column
  signal slice0_tag_output_column : boolean_1d(0 to 3);  -- _#_output_column
  signal slice0_tag_first_column : boolean_1d(0 to 3);  -- _#_first_column
  signal slice0_tag_start_of_frame : boolean_1d(0 to 3);  -- _#_start_of_frame
  signal slice0_tag_end_of_line : boolean_1d(0 to 3);  -- _#_end_of_line
  -- slice1shift
  signal slice1shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice1shift_reference, slice1shift_search_out : natural_16383_1d(0 to 2);
  -- slice1cost
  signal slice1cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- _#_#_count_#
  signal slice1cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- _#_#_count_4
  signal slice1cost_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal slice1cost_single_0 : natural_14_1d(0 to 15);
  signal slice1cost_pair_0 : natural_28_1d(0 to 15);
  signal slice1cost_column_0 : natural_42_1d(0 to 15);
  signal slice1cost_tag_border_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice1window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice1window_sum_0 : natural_126_1d(0 to 15);
  -- slice1
  signal slice1_held : natural_15_2d(0 to 2, 0 to 15);
  -- slice2shift
  signal slice2shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice2shift_reference, slice2shift_search_out : natural_16383_1d(0 to 2);
  -- slice2cost
  signal slice2cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- _#_#_count_#
  signal slice2cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- _#_#_count_4
  signal slice2cost_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal slice2cost_single_0 : natural_14_1d(0 to 15);
  signal slice2cost_pair_0 : natural_28_1d(0 to 15);
  signal slice2cost_column_0 : natural_42_1d(0 to 15);
  signal slice2cost_tag_border_column : boolean;
  -- slice2window
  signal slice2window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice2window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice2window_sum_0 : natural_126_1d(0 to 15);
  -- slice2
  signal slice2_held : natural_15_2d(0 to 1, 0 to 15);
  -- slice3shift
  signal slice3shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice3shift_reference : natural_16383_1d(0 to 2);
  -- slice3cost
  signal slice3cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- _#_#_count_#
  signal slice3cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- _#_#_count_4
  signal slice3cost_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal slice3cost_single_0 : natural_14_1d(0 to 15);
  signal slice3cost_pair_0 : natural_28_1d(0 to 15);
  signal slice3cost_column_0 : natural_42_1d(0 to 15);
  -- slice3window
  signal slice3window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice3window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice3window_sum_0 : natural_126_1d(0 to 15);
  -- slice3
  signal slice3_held_0 : natural_15_1d(0 to 15);
  -- entry
  signal entry_next_cost, entry_cost : natural_15_1d(0 to 63);
  signal entry_next_tag : tag_4;
  signal entry_next_top, entry_order_falls, entry_order_inside, entry_order_complete, entry_order_output,
    entry_order_first, entry_order_held_output, entry_order_turned_output_column, entry_order_turned_first_column,
    entry_order_turned_start_of_frame : boolean;
  signal entry_tag : tag_4;
  signal entry_top, entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 511;
  -- forward
  signal forward_smallest_smallest : natural_15_1d(0 to 31);
  signal forward_smallest_next_smallest : natural_15_1d(0 to 15);
  signal forward_smallest_next_next_smallest : natural_15_1d(0 to 7);
  signal forward_smallest_next_next_next_smallest : natural_15_1d(0 to 3);
  signal forward_smallest_next_next_next_next_smallest : natural_15_1d(0 to 1);
  signal forward_smallest_next_next_next_next_next_smallest_0 : natural range 0 to 15;
  signal forward_above_ready_cost : natural_15_1d(0 to 63);
  signal forward_smallest_cost : natural_15_1d(0 to 4);
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address,
    forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost : natural_7_2d(0 to 3, 0 to 63);
  signal forward_cost_delay_held : unsigned_32_1d(0 to 5);
  signal forward_above_read_words, forward_above_ready_words, forward_above_write_words : unsigned_32_1d(0 to 9);
  signal forward_cost_delay_held_6 : unsigned(13 downto 0);
  signal forward_left_pair : natural_127_1d(0 to 31);
  signal forward_left_tree_smallest : natural_127_1d(0 to 15);
  signal forward_left_tree_next_smallest : natural_127_1d(0 to 7);
  signal forward_left_tree_next_next_smallest : natural_127_1d(0 to 3);
  signal forward_left_tree_next_next_next_smallest : natural_127_1d(0 to 1);
  signal forward_left_tree_next_next_next_next_smallest_0, forward_left_smallest, forward_left_smallest_less,
    forward_left_relief_leaves : natural range 0 to 127;
  signal forward_left_g_copy, forward_left_g_less_copy : natural_127_1d(0 to 3);
  signal forward_left_stay_change, forward_left_step_change, forward_left_cost,
    forward_left_arrived : natural_127_1d(0 to 63);
  signal forward_left_start_cost : natural_63_1d(0 to 8);
  signal forward_left_room, forward_left_relief_next_0 : natural range 0 to 63;
  signal forward_left_relief_past : natural_63_1d(0 to 7);
  signal forward_left_relief_pairs : natural_63_1d(0 to 1);
  signal forward_left_relief_fours : natural_63_1d(0 to 2);
  signal forward_left_relief_older, forward_left_relief_recent, forward_left_relief_largest,
    forward_left_relief_beyond : natural range 0 to 63;
  signal forward_above_cost, forward_above_beside : natural_63_1d(0 to 63);
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
  signal forward_above_read_words_10 : unsigned(21 downto 0);
  signal forward_above_ready_words_10, forward_above_write_words_10 : natural range 0 to 4194303;
  signal forward_above_total : natural_46_1d(0 to 63);
  signal forward_above_tree_smallest : natural_46_1d(0 to 31);
  signal forward_above_tree_next_smallest : natural_46_1d(0 to 15);
  signal forward_above_tree_next_next_smallest : natural_46_1d(0 to 7);
  signal forward_above_tree_next_next_next_smallest : natural_46_1d(0 to 3);
  signal forward_above_tree_next_next_next_next_smallest : natural_46_1d(0 to 1);
  signal forward_above_tree_next_next_next_next_next_smallest_0 : natural range 0 to 46;
  signal forward_above_smallest_copy : natural_46_1d(0 to 3);
  signal forward_above_delay_held : unsigned_30_1d(0 to 11);
  signal forward_above_delay_held_12 : unsigned(23 downto 0);
  signal forward_above_step : natural_68_1d(0 to 63);
  signal forward_above_stay : natural_31_1d(0 to 63);
  signal forward_above_column : natural_511_1d(0 to 11);
  signal forward_above_write_column : natural range 0 to 511;
  -- sums
  signal sums_turn_read_sums, sums_turn_ready_sums, sums_turn_write_sums, sums_sum_delay_held : unsigned_32_1d(0 to 15);
  signal sums_turn_read_costs : unsigned_30_1d(0 to 5);
  signal sums_turn_read_costs_6 : unsigned(11 downto 0);
  signal sums_turn_read_smallest_0 : unsigned(8 downto 0);
  signal sums_turn_ready_costs, sums_turn_write_costs : natural_1073741823_1d(0 to 5);
  signal sums_turn_ready_costs_6, sums_turn_write_costs_6 : natural range 0 to 4095;
  signal sums_turn_ready_smallest_0 : natural range 0 to 511;
  signal sums_turn_place : natural_511_1d(0 to 10);
  signal sums_turn_write_smallest_0, sums_turn_write_place : natural range 0 to 511;
  signal sums_turn_ready_first, sums_turn_writes_copy_0 : boolean;
  signal sums_right_first : boolean_1d(0 to 2);
  signal sums_tag : tag_5;
  signal sums_tags_held_output_column : boolean_1d(0 to 4);  -- _#_output_column
  signal sums_tags_held_start_of_frame : boolean_1d(0 to 4);  -- _#_start_of_frame
  signal sums_tags_held_end_of_line : boolean_1d(0 to 4);  -- _#_end_of_line
  signal sums_tags_moved : boolean;
  signal sums_cost : natural_7_2d(0 to 1, 0 to 63);
  signal sums_right_pair : natural_127_1d(0 to 31);
  signal sums_right_tree_smallest : natural_127_1d(0 to 15);
  signal sums_right_tree_next_smallest : natural_127_1d(0 to 7);
  signal sums_right_tree_next_next_smallest : natural_127_1d(0 to 3);
  signal sums_right_tree_next_next_next_smallest : natural_127_1d(0 to 1);
  signal sums_right_tree_next_next_next_next_smallest_0, sums_right_smallest, sums_right_smallest_less,
    sums_right_relief_leaves : natural range 0 to 127;
  signal sums_right_g_copy, sums_right_g_less_copy : natural_127_1d(0 to 3);
  signal sums_right_stay_change, sums_right_step_change, sums_right_cost, sums_right_arrived : natural_127_1d(0 to 63);
  signal sums_right_start_cost : natural_63_1d(0 to 8);
  signal sums_right_room, sums_right_relief_next_0 : natural range 0 to 63;
  signal sums_right_relief_past : natural_63_1d(0 to 7);
  signal sums_right_relief_pairs : natural_63_1d(0 to 1);
  signal sums_right_relief_fours : natural_63_1d(0 to 2);
  signal sums_right_relief_older, sums_right_relief_recent, sums_right_relief_largest,
    sums_right_relief_beyond : natural range 0 to 63;
  signal sums_right_relief_reach_of_best : natural range 0 to 255;
  signal sums_sum_0 : natural_255_1d(0 to 63);
  signal sums_right_relief_room_of_best : natural range 0 to 190;
  signal sums_right_relief_reach_again : natural range 0 to 254;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  -- winnerswinner1
  signal winnerswinner1_of_pair_0, winnerswinner1_of_four_0 : natural_255_1d(0 to 63);
  signal winnerswinner1_best_cost_0 : natural_255_1d(0 to 15);
  signal winnerswinner1_pair_index_0_0 : boolean;
  signal winnerswinner1_pair_tag, winnerswinner1_four_tag, winnerswinner1_tag : tag_5;
  signal winnerswinner1_pair_index_0 : natural_63_1d(1 to 31);  -- _# up to 3, 5 .. 63
  signal winnerswinner1_four_index_0, winnerswinner1_best_index_0 : natural_63_1d(0 to 15);  -- _# up to 3, 7 .. 63
  -- winnerswinner2
  signal winnerswinner2_of_pair_0, winnerswinner2_of_four_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_cost_0 : natural_255_1d(0 to 3);
  signal winnerswinner2_pair_index_0 : natural_63_1d(0 to 7);  -- _# up to 7, 15 .. 63
  signal winnerswinner2_four_index_0, winnerswinner2_best_index_0 : natural_63_1d(0 to 3);  -- _# up to 15, 31 .. 63
  signal winnerswinner2_pair_tag, winnerswinner2_four_tag, winnerswinner2_tag : tag_5;
  -- winnerswinner3
  signal winnerswinner3_of_pair_0 : natural_255_1d(0 to 3);
  signal winnerswinner3_pair_index_0 : natural_63_1d(0 to 1);  -- _# up to 31, 63
  signal winnerswinner3_four_index_0_0, winnerswinner3_best_index_0_0 : natural range 0 to 63;
  signal winnerswinner3_pair_tag, winnerswinner3_four_tag, winnerswinner3_tag : tag_5;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 63;
  signal winners_best_tag : tag_5;
  -- turn
  signal turn_order_address, turn_write_place, turn_ready : natural range 0 to 511;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame,
    turn_order_turned_end_of_line, turn_comes : boolean;
  signal turn_read_tag : tag_4_b;
  signal turn_ready_tag : tag_5_b;
  signal turn_newest, turn_write_words_0 : natural range 0 to 319;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- map
  signal map_counter_column, map_counter_group, map_write_column, map_at_column, map_comparing_column,
    map_sorted_column : natural range 0 to 511;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_at_arrives, map_at_behind, map_at_top,
    map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a, map_of_column_0_c_below_b : boolean;
  signal map_column_passed_0 : boolean_1d(0 to 1);  -- _#_0
  signal map_comparing_arrives, map_comparing_behind, map_comparing_top, map_comparing_output, map_sorted_arrives,
    map_sorted_behind, map_sorted_top, map_sorted_output : boolean;
  signal map_passed_0 : boolean_1d(0 to 1);  -- _#_0
  signal map_window_complete, map_window_first, map_window_last, map_of_low_0_b_below_a, map_of_low_0_c_below_a,
    map_of_low_0_c_below_b, map_of_middle_0_b_below_a, map_of_middle_0_c_below_a, map_of_middle_0_c_below_b,
    map_of_high_0_b_below_a, map_of_high_0_c_below_a, map_of_high_0_c_below_b, map_of_all_0_b_below_a,
    map_of_all_0_c_below_a, map_of_all_0_c_below_b : boolean;
  signal map_waiting_complete : boolean_1d(0 to 2);  -- _#_complete
  signal map_waiting_first : boolean_1d(0 to 2);  -- _#_first
  signal map_waiting_last : boolean_1d(0 to 2);  -- _#_last
  signal map_waiting_passed_0 : boolean_1d(0 to 2);  -- _#_0
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 127;
  signal map_column : natural_127_1d(1 to 2);
  signal map_rows_read_words_0 : unsigned(15 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 65535;
  signal map_rows_write_words_0 : natural range 0 to 65151;
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0, map_sorted_middle_0,
    map_sorted_high_0 : natural range 0 to 63;
  signal map_low_0, map_middle_0, map_high_0 : natural_63_1d(0 to 2);  -- _#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b, map_of_middle_0_c,
    map_of_high_0_a, map_of_high_0_b, map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0,
    map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 63;
  -- relief
  signal relief_centre_column : natural_255_1d(0 to 4);
  signal relief_centre_grey_0, relief_before : natural range 0 to 255;
  signal relief_newest, relief_delayed_0, relief_rows_read_newest_0, relief_rows_ready_words_0,
    relief_rows_ready_newest_0, relief_rows_write_words_0, relief_shown_0, relief_column_0 : natural range 0 to 63;
  signal relief_waiting : natural_63_1d(0 to 9);
  signal relief_entering, relief_entered : natural range 0 to 63;
  signal relief_rows_read_words_0 : unsigned(5 downto 0);
  -- other
  signal other : unsigned_32_1d(0 to 15);
  signal other_16, other_18 : unsigned(48 downto 0);
  signal other_17 : natural range 0 to 126;

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

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  transform_left_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (450, 32, 9)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address,
        transform_left_rows_write_words_0);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (450, 32, 9)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address,
        transform_right_rows_write_words_0);
  end block;

  map_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(map_counter_column, 9);
    write_address <= to_unsigned(map_at_column, 9);
    write_data <= to_unsigned(map_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (387, 16, 9)
      port map (clock, true, read_address, map_rows_read_words_0, write_address, write_data);
  end block;

  turn_read_words_0_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(turn_order_address, 9);
    write_address <= to_unsigned(turn_write_place, 9);
    write_data <= to_unsigned(turn_write_words_0, 9);
    cell : entity work.line_memory generic map (387, 9, 9)
      port map (clock, true, read_address, turn_read_words_0, write_address, write_data);
  end block;

  sums_sum_delay_held_memory : for i in 15 downto 0 generate
    signal read_address, write_address : unsigned(1 downto 0);
  begin
    read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
    write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
    cell : entity work.line_memory generic map (4, 32, 2)
      port map (clock, entry_tag.valid, read_address, sums_sum_delay_held(i), write_address, sums_turn_ready_sums(i));
  end generate;

  sums_turn_read_sums_memory : for i in 15 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 9);
    write_address <= to_unsigned(sums_turn_write_place, 9);
    cell : entity work.line_memory generic map (387, 32, 9)
      port map (clock, true, read_address, sums_turn_read_sums(i), write_address, sums_turn_write_sums(i));
  end generate;

  sums_turn_read_costs_6_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 9);
    write_address <= to_unsigned(sums_turn_write_place, 9);
    write_data <= to_unsigned(sums_turn_write_costs_6, 12);
    cell : entity work.line_memory generic map (387, 12, 9)
      port map (clock, true, read_address, sums_turn_read_costs_6, write_address, write_data);
  end block;

  sums_turn_read_costs_memory : for i in 5 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 9);
    write_address <= to_unsigned(sums_turn_write_place, 9);
    write_data <= to_unsigned(sums_turn_write_costs(i), 30);
    cell : entity work.line_memory generic map (387, 30, 9)
      port map (clock, true, read_address, sums_turn_read_costs(i), write_address, write_data);
  end generate;

  sums_turn_read_smallest_0_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 9);
    write_address <= to_unsigned(sums_turn_write_place, 9);
    write_data <= to_unsigned(sums_turn_write_smallest_0, 9);
    cell : entity work.line_memory generic map (387, 9, 9)
      port map (clock, true, read_address, sums_turn_read_smallest_0, write_address, write_data);
  end block;

  forward_above_read_words_10_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(entry_next_column, 9);
    write_address <= to_unsigned(forward_above_write_column, 9);
    write_data <= to_unsigned(forward_above_write_words_10, 22);
    cell : entity work.line_memory generic map (387, 22, 9)
      port map (clock, true, read_address, forward_above_read_words_10, write_address, write_data);
  end block;

  forward_above_read_words_memory : for i in 9 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(entry_next_column, 9);
    write_address <= to_unsigned(forward_above_write_column, 9);
    cell : entity work.line_memory generic map (387, 32, 9)
      port map (clock, true, read_address, forward_above_read_words(i), write_address, forward_above_write_words(i));
  end generate;

  forward_above_delay_held_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= to_unsigned(forward_above_total(63), 6) & to_unsigned(forward_above_total(62), 6) &
      to_unsigned(forward_above_total(61), 6) & to_unsigned(forward_above_total(60), 6);
    cell : entity work.line_memory generic map (7, 24, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held_12, write_address, write_data);
  end block;

  forward_above_delay_held_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= to_unsigned(forward_above_total(5 * i + 4), 6) & to_unsigned(forward_above_total(5 * i + 3), 6) &
      to_unsigned(forward_above_total(5 * i + 2), 6) & to_unsigned(forward_above_total(5 * i + 1), 6) &
      to_unsigned(forward_above_total(5 * i), 6);
    cell : entity work.line_memory generic map (7, 30, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held(i), write_address, write_data);
  end generate;

  forward_cost_delay_held_6_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(13 downto 0);
  begin
    read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
    write_data <= ((((((to_unsigned(entry_cost(62), 8) & to_unsigned(0, 6)) or (to_unsigned(entry_cost(63), 5) &
      to_unsigned(0, 9)))) or (to_unsigned(entry_cost(60), 14)))) or (to_unsigned(entry_cost(61), 11) & to_unsigned(0,
      3)));
    cell : entity work.line_memory generic map (7, 14, 3)
      port map (clock, entry_tag.valid, read_address, forward_cost_delay_held_6, write_address, write_data);
  end block;

  forward_cost_delay_held_memory : for i in 5 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
    write_data <= ((((((((((((((((((to_unsigned(entry_cost(10 * i + 8), 8) & to_unsigned(0, 24)) or
      (to_unsigned(entry_cost(10 * i + 9), 5) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(10 * i + 7), 11) &
      to_unsigned(0, 21)))) or (to_unsigned(entry_cost(10 * i + 6), 14) & to_unsigned(0, 18)))) or
      (to_unsigned(entry_cost(10 * i + 5), 17) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(10 * i + 4), 20) &
      to_unsigned(0, 12)))) or (to_unsigned(entry_cost(10 * i + 3), 23) & to_unsigned(0, 9)))) or
      (to_unsigned(entry_cost(10 * i + 2), 26) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(10 * i), 32)))) or
      (to_unsigned(entry_cost(10 * i + 1), 29) & to_unsigned(0, 3)));
    cell : entity work.line_memory generic map (7, 32, 3)
      port map (clock, entry_tag.valid, read_address, forward_cost_delay_held(i), write_address, write_data);
  end generate;

  relief_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(relief_rows_write_words_0, 6);
    cell : entity work.line_memory generic map (450, 6, 9)
      port map (clock, true, read_address, relief_rows_read_words_0, write_address, write_data);
  end block;

  rows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (450, 28, 9)
      port map (clock, true, read_address, rows_search_rows_read_words_0, write_address, write_data);
  end block;

  rows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (450, 28, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words_0, write_address, write_data);
  end block;

  process
    variable transform_counter_group_is_equals, raster_place_group_is_equals,
      turn_ready_tag_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_all,
      raster_place_group_differs, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less,
      delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less,
      entry_order_falls_any, entry_order_falls_all, entry_order_complete_all, entry_order_complete_any,
      entry_order_turned_output_column_choice, forward_left_start_cost_0_any, forward_left_start_cost_0_choice_6,
      forward_left_start_cost_0_is_less, sums_right_start_cost_0_any, sums_right_start_cost_0_choice_6,
      sums_right_start_cost_0_is_less, sums_turn_writes_copy_0_choice, turn_order_falls_all, turn_order_complete_all,
      turn_ready_tag_row_start_differs, map_counter_group_is_equal, map_line_ended_choice, map_at_arrives_value,
      map_window_complete_is_equal, map_window_complete_choice, map_of_low_0_b_below_a_is_equal,
      map_of_low_0_b_below_a_choice_5, map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice_5,
      map_of_low_0_c_below_b_choice_5, map_of_middle_0_b_below_a_is_equal, map_of_middle_0_b_below_a_choice_5,
      map_of_middle_0_c_below_a_value, map_of_middle_0_c_below_a_choice_5, map_of_middle_0_c_below_b_choice_5,
      map_of_high_0_b_below_a_is_equal, map_of_high_0_b_below_a_choice_5, map_of_high_0_c_below_a_value,
      map_of_high_0_c_below_a_choice_5, map_of_high_0_c_below_b_choice_5, map_of_all_0_b_below_a_is_equal,
      map_of_all_0_b_below_a_choice_5, map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice_5,
      map_of_all_0_c_below_b_choice_5 : boolean;
    variable transform_counter_group_choice, raster_place_group_choice,
      map_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choices, raster_place_group_choices,
      map_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values,
      map_of_column_0_c_below_a_values, relief_newest_values : boolean_1d(1 to 5);  -- _value_#
    variable transform_left_filter_feature_0_choice : boolean_1d(8 to 121);
    variable transform_left_filter_feature_0_choice_17,
      transform_right_filter_feature_0_choice_17 : natural range 0 to 3;
    variable transform_left_filter_feature_0_alls, transform_right_filter_feature_0_alls : boolean_1d(1 to 4);  -- _all_#
    variable transform_right_filter_feature_0_choice : boolean_1d(8 to 125);
    variable transform_counter_next_frame_choices, raster_place_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 511;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 193;
    variable forward_left_pair_choice, sums_right_pair_choice : natural_127_1d(0 to 31);  -- _#_choice
    variable forward_left_start_cost_0_values, sums_right_start_cost_0_values : boolean_1d(1 to 3);  -- _value_#
    variable forward_left_start_cost_0_choice, sums_right_start_cost_0_choice : natural_63_1d(7 to 9);
    variable forward_left_room_value, forward_left_smallest_choice, forward_left_relief_pairs_0_choice,
      forward_left_relief_older_choice, forward_left_relief_recent_choice, forward_left_relief_largest_choice,
      sums_right_room_value, sums_right_smallest_choice, sums_right_relief_pairs_0_choice,
      sums_right_relief_older_choice, sums_right_relief_recent_choice, sums_right_relief_largest_choice,
      map_low_0_0_choice, map_middle_0_0_choice, map_high_0_0_choice, relief_newest_choice_17 : natural range 0 to 63;
    variable forward_left_room_choices, sums_right_room_choices : natural_63_1d(1 to 3);  -- _choice_#
    variable forward_left_smallest_difference : integer range -63 to 78;
    variable forward_left_relief_reach_of_best_sum, forward_left_relief_reach_of_best_choice,
      sums_right_relief_reach_of_best_sum, sums_right_relief_reach_of_best_choice : natural range 0 to 190;
    variable forward_left_relief_reach_of_best_choices,
      sums_right_relief_reach_of_best_choices : natural_255_1d(2 to 3);  -- _choice_#
    variable forward_left_relief_leaves_choice, sums_right_relief_leaves_choice : natural range 64 to 127;
    variable forward_left_g_copy_0_value, forward_left_g_less_copy_0_value, sums_right_g_copy_0_value,
      sums_right_g_less_copy_0_value : natural range 0 to 127;
    variable forward_left_cost_choice, forward_left_arrived_choice, sums_right_cost_choice,
      sums_right_arrived_choice : natural_127_2d(0 to 63, 1 to 2);  -- _#_choice_#
    variable forward_above_total_choice : natural_31_1d(0 to 63);  -- _#_choice
    variable forward_above_write_words_choice : natural_68_2d(0 to 10, 1 to 6);  -- _#_choice_#
    variable sums_right_smallest_difference : integer range -63 to 63;
    variable winnerswinner1_of_pair_0_value : boolean_2d(0 to 31, 1 to 5);  -- _2#_value_#
    variable winnerswinner1_of_pair_0_choice_8 : boolean_1d(0 to 31);  -- _2#_choice_8
    variable winnerswinner1_of_four_0_choice : boolean_2d(0 to 15, 1 to 8);  -- _4#_choice_#
    variable winnerswinner1_of_four_0_value : boolean_2d(0 to 15, 1 to 12);  -- _4#_value_#
    variable winnerswinner2_of_pair_0_value : boolean_2d(0 to 7, 1 to 5);  -- _2#_value_#
    variable winnerswinner2_of_pair_0_choice_8 : boolean_1d(0 to 7);  -- _2#_choice_8
    variable winnerswinner2_of_four_0_choice : boolean_2d(0 to 3, 1 to 8);  -- _4#_choice_#
    variable winnerswinner2_of_four_0_value : boolean_2d(0 to 3, 1 to 12);  -- _4#_value_#
    variable winnerswinner3_of_pair_0_value : boolean_2d(0 to 2, 1 to 5);  -- _#_value_#
    variable winnerswinner3_of_pair_0_choice_8 : boolean_1d(0 to 2);  -- _#_choice_8
    variable winnerswinner3_four_index_0_0_choices : boolean_1d(1 to 8);  -- _choice_#
    variable winnerswinner3_four_index_0_0_values : boolean_1d(1 to 12);  -- _value_#
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
    variable turn_ready_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable turn_ready_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable map_of_column_0_b_below_a_values : boolean_1d(1 to 8);  -- _value_#
    variable map_of_column_0_b_below_a_choices : boolean_1d(1 to 7);  -- _choice_#
    variable map_of_column_0_c_below_a_choices : boolean_1d(1 to 14);  -- _choice_#
    variable map_of_column_0_c_below_b_choices : boolean_1d(1 to 4);  -- _choice_#
    variable map_sorted_low_0_choices, map_sorted_middle_0_choices, map_sorted_high_0_choices,
      map_largest_low_0_choices, map_smallest_high_0_choices : natural_63_1d(1 to 2);  -- _choice_#
    variable map_of_low_0_b_below_a_values, map_of_middle_0_b_below_a_values, map_of_high_0_b_below_a_values,
      map_of_all_0_b_below_a_values : boolean_1d(1 to 7);  -- _value_#
    variable map_median_middle_0_choices, map_out_disparity_0_choices : natural_63_1d(1 to 4);  -- _choice_#
    variable map_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
    variable relief_newest_choice : boolean_1d(7 to 16);
    variable relief_newest_values_from_6 : natural_255_1d(6 to 7);  -- _value_#
    variable other_choice : natural_255_2d(0 to 15, 1 to 3);  -- _#_choice_#
    variable other_choice_4 : natural_190_1d(0 to 15);  -- _#_choice_4
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    forward_above_write_words_choice := (others => (others => 0));
    forward_left_arrived_choice := (others => (others => 0)); sums_right_arrived_choice := (others => (others => 0));
    transform_left_filter_feature_0_choice := (others => false);
    transform_right_filter_feature_0_choice := (others => false);
    winnerswinner3_of_pair_0_choice_8 := (others => false);
    winnerswinner3_of_pair_0_value := (others => (others => false));
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_group = 374;
    transform_counter_group_is_equals(2) := transform_counter_column = 449;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 375, 0);
    transform_counter_group_differs := transform_counter_group /= 377;
    transform_counter_group_choices(2) := choice((transform_counter_group = 376) and transform_counter_next_frame, 2,
      (transform_counter_group + 1) mod 512);
    transform_counter_group_choices(3) := choice(transform_counter_group_differs and in_valid and
      transform_counter_group_is_equals(2), transform_counter_group_choices(2), transform_counter_group);
    transform_read_column_inside_0_is_less := 3 < transform_counter_column;
    transform_left_filter_feature_0_any := (not is_set(transform_left_filter_column(4, 1), 1)) or (not
      is_set(transform_left_filter_column(4, 1), 0));
    transform_left_filter_feature_0_is_equal := (transform_left_filter_column(4, 1) mod 4) = 0;
    for i in 1 to 5 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(4, 1), i + 1);
    end loop;
    transform_left_filter_feature_0_choice(8) := is_larger(transform_left_filter_column(4, 0),
      transform_left_filter_column(4, 1), 0, 7, false);
    transform_left_filter_feature_0_choice(16) := is_larger(transform_left_filter_column(4, 2),
      transform_left_filter_column(4, 1), 0, 7, false);
    transform_left_filter_feature_0_choice_17 := choice(transform_filtering_0_column_inside(2),
      as_number(transform_left_filter_feature_0_choice(8)) + (as_number(transform_left_filter_feature_0_choice(16)) *
      2), 0);
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(52 * i + 24) := not is_larger(transform_left_filter_column(6 * i, 1),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_alls(2 * i + 1) := transform_filtering_0_column_inside(3 * i) and (not
        is_set(transform_left_filter_column(4, 1), 7));
      transform_left_filter_feature_0_choice(52 * i + 25) := choice(is_set(transform_left_filter_column(6 * i, 1), 7),
        transform_filtering_0_column_inside(3 * i), transform_left_filter_feature_0_alls(2 * i + 1));
      transform_left_filter_feature_0_choice(52 * i + 26) := choice(transform_left_filter_feature_0_choice(52 * i +
        24), is_set(transform_left_filter_column(6 * i, 1), 7) and transform_filtering_0_column_inside(3 * i) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(52 * i + 25));
      transform_left_filter_feature_0_choice(52 * i + 33) := not is_larger(transform_left_filter_column(6 * i, 0),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_choice(52 * i + 34) := choice(is_set(transform_left_filter_column(6 * i, 0), 7),
        transform_filtering_0_column_inside(3 * i), transform_left_filter_feature_0_alls(2 * i + 1));
      transform_left_filter_feature_0_choice(52 * i + 35) := choice(transform_left_filter_feature_0_choice(52 * i +
        33), is_set(transform_left_filter_column(6 * i, 0), 7) and transform_filtering_0_column_inside(3 * i) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(52 * i + 34));
      transform_left_filter_feature_0_choice(52 * i + 42) := not is_larger(transform_left_filter_column(6 * i, 2),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_choice(52 * i + 43) := choice(transform_left_filter_feature_0_choice(52 * i +
        42), transform_filtering_0_column_inside(3 * i) and is_set(transform_left_filter_column(6 * i, 2), 7) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(3 * i) and
        (is_set(transform_left_filter_column(6 * i, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
      transform_left_filter_feature_0_choice(52 * i + 50) := not is_larger(transform_left_filter_column(6 * i + 2, 1),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_alls(2 * i + 2) := transform_filtering_0_column_inside(3 * i + 1) and (not
        is_set(transform_left_filter_column(4, 1), 7));
      transform_left_filter_feature_0_choice(52 * i + 51) := choice(is_set(transform_left_filter_column(6 * i + 2, 1),
        7), transform_filtering_0_column_inside(3 * i + 1), transform_left_filter_feature_0_alls(2 * i + 2));
      transform_left_filter_feature_0_choice(52 * i + 52) := choice(transform_left_filter_feature_0_choice(52 * i +
        50), is_set(transform_left_filter_column(6 * i + 2, 1), 7) and transform_filtering_0_column_inside(3 * i + 1)
        and (not is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(52 * i + 51));
      transform_left_filter_feature_0_choice(52 * i + 59) := not is_larger(transform_left_filter_column(6 * i + 2, 0),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_choice(52 * i + 60) := choice(is_set(transform_left_filter_column(6 * i + 2, 0),
        7), transform_filtering_0_column_inside(3 * i + 1), transform_left_filter_feature_0_alls(2 * i + 2));
      transform_left_filter_feature_0_choice(52 * i + 61) := choice(transform_left_filter_feature_0_choice(52 * i +
        59), is_set(transform_left_filter_column(6 * i + 2, 0), 7) and transform_filtering_0_column_inside(3 * i + 1)
        and (not is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(52 * i + 60));
      transform_left_filter_feature_0_choice(52 * i + 68) := not is_larger(transform_left_filter_column(6 * i + 2, 2),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_choice(52 * i + 69) := choice(transform_left_filter_feature_0_choice(52 * i +
        68), transform_filtering_0_column_inside(3 * i + 1) and is_set(transform_left_filter_column(6 * i + 2, 2), 7)
        and (not is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(3 * i + 1) and
        (is_set(transform_left_filter_column(6 * i + 2, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
    end loop;
    transform_right_filter_feature_0_any := (not is_set(transform_right_filter_column(4, 1), 1)) or (not
      is_set(transform_right_filter_column(4, 1), 0));
    transform_right_filter_feature_0_is_equal := (transform_right_filter_column(4, 1) mod 4) = 0;
    for i in 1 to 5 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(4, 1), i + 1);
    end loop;
    transform_right_filter_feature_0_choice(8) := is_larger(transform_right_filter_column(4, 0),
      transform_right_filter_column(4, 1), 0, 7, false);
    transform_right_filter_feature_0_choice(16) := is_larger(transform_right_filter_column(4, 2),
      transform_right_filter_column(4, 1), 0, 7, false);
    transform_right_filter_feature_0_choice_17 := choice(transform_filtering_0_column_inside(2),
      as_number(transform_right_filter_feature_0_choice(8)) + (as_number(transform_right_filter_feature_0_choice(16)) *
      2), 0);
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(54 * i + 24) := not is_larger(transform_right_filter_column(6 * i, 1),
        transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_alls(2 * i + 1) := transform_filtering_0_column_inside(3 * i) and (not
        is_set(transform_right_filter_column(4, 1), 7));
      transform_right_filter_feature_0_choice(54 * i + 25) := choice(is_set(transform_right_filter_column(6 * i, 1),
        7), transform_filtering_0_column_inside(3 * i), transform_right_filter_feature_0_alls(2 * i + 1));
      transform_right_filter_feature_0_choice(54 * i + 26) := choice(transform_right_filter_feature_0_choice(54 * i +
        24), is_set(transform_right_filter_column(6 * i, 1), 7) and transform_filtering_0_column_inside(3 * i) and (not
        is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(54 * i + 25));
      transform_right_filter_feature_0_choice(54 * i + 33) := not is_larger(transform_right_filter_column(6 * i, 0),
        transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_choice(54 * i + 34) := choice(is_set(transform_right_filter_column(6 * i, 0),
        7), transform_filtering_0_column_inside(3 * i), transform_right_filter_feature_0_alls(2 * i + 1));
      transform_right_filter_feature_0_choice(54 * i + 35) := choice(transform_right_filter_feature_0_choice(54 * i +
        33), is_set(transform_right_filter_column(6 * i, 0), 7) and transform_filtering_0_column_inside(3 * i) and (not
        is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(54 * i + 34));
      transform_right_filter_feature_0_choice(54 * i + 42) := not is_larger(transform_right_filter_column(6 * i, 2),
        transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_choice(54 * i + 43) := choice(is_set(transform_right_filter_column(6 * i, 2),
        7), transform_filtering_0_column_inside(3 * i), transform_right_filter_feature_0_alls(2 * i + 1));
      transform_right_filter_feature_0_choice(54 * i + 44) := choice(transform_right_filter_feature_0_choice(54 * i +
        42), is_set(transform_right_filter_column(6 * i, 2), 7) and transform_filtering_0_column_inside(3 * i) and (not
        is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(54 * i + 43));
      transform_right_filter_feature_0_choice(54 * i + 51) := not is_larger(transform_right_filter_column(6 * i + 2,
        1), transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_alls(2 * i + 2) := transform_filtering_0_column_inside(3 * i + 1) and (not
        is_set(transform_right_filter_column(4, 1), 7));
      transform_right_filter_feature_0_choice(54 * i + 52) := choice(is_set(transform_right_filter_column(6 * i + 2,
        1), 7), transform_filtering_0_column_inside(3 * i + 1), transform_right_filter_feature_0_alls(2 * i + 2));
      transform_right_filter_feature_0_choice(54 * i + 53) := choice(transform_right_filter_feature_0_choice(54 * i +
        51), is_set(transform_right_filter_column(6 * i + 2, 1), 7) and transform_filtering_0_column_inside(3 * i + 1)
        and (not is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(54 * i + 52));
      transform_right_filter_feature_0_choice(54 * i + 60) := not is_larger(transform_right_filter_column(6 * i + 2,
        0), transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_choice(54 * i + 61) := choice(is_set(transform_right_filter_column(6 * i + 2,
        0), 7), transform_filtering_0_column_inside(3 * i + 1), transform_right_filter_feature_0_alls(2 * i + 2));
      transform_right_filter_feature_0_choice(54 * i + 62) := choice(transform_right_filter_feature_0_choice(54 * i +
        60), is_set(transform_right_filter_column(6 * i + 2, 0), 7) and transform_filtering_0_column_inside(3 * i + 1)
        and (not is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(54 * i + 61));
      transform_right_filter_feature_0_choice(54 * i + 69) := not is_larger(transform_right_filter_column(6 * i + 2,
        2), transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_choice(54 * i + 70) := choice(is_set(transform_right_filter_column(6 * i + 2,
        2), 7), transform_filtering_0_column_inside(3 * i + 1), transform_right_filter_feature_0_alls(2 * i + 2));
      transform_right_filter_feature_0_choice(54 * i + 71) := choice(transform_right_filter_feature_0_choice(54 * i +
        69), is_set(transform_right_filter_column(6 * i + 2, 2), 7) and transform_filtering_0_column_inside(3 * i + 1)
        and (not is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(54 * i + 70));
    end loop;
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
      (transform_counter_group mod 4)) < 375;
    transform_read_row_inside(1) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 375;
    transform_read_row_inside(2) <= transform_counter_group < 375;
    transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
    for i in 1 to 4 loop
      transform_read_column_inside(i) <= (transform_counter_column < (2 * i)) /= transform_read_column_inside_0_is_less;
    end loop;
    transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
    transform_read_valid <= transform_valid;
    transform_ready_column <= transform_read_column;
    transform_ready_row_inside <= transform_read_row_inside;
    transform_ready_column_inside <= transform_read_column_inside;
    transform_ready_start_of_frame <= transform_read_start_of_frame;
    transform_ready_valid <= transform_read_valid;
    transform_left_column(0) <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
    transform_left_column(1) <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
    transform_left_column(2) <= transform_left_rows_ready_newest_0;
    transform_right_column(0) <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
    transform_right_column(1) <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
    transform_right_column(2) <= transform_right_rows_ready_newest_0;
    transform_columns_row_inside <= transform_ready_row_inside;
    transform_columns_column_inside <= transform_ready_column_inside;
    transform_columns_start_of_frame <= transform_ready_start_of_frame;
    transform_columns_valid <= transform_ready_valid;
    transform_left_filter_feature_0 <= (transform_left_filter_feature_0_choice_17 * 64) +
      (as_number(transform_left_filter_feature_0_choice(26)) * 2) +
      as_number(transform_left_filter_feature_0_choice(35)) + (as_number(transform_left_filter_feature_0_choice(43)) *
      4) + (as_number(transform_left_filter_feature_0_choice(52)) * 16) +
      (as_number(transform_left_filter_feature_0_choice(61)) * 8) +
      (as_number(transform_left_filter_feature_0_choice(69)) * 32) +
      (as_number(transform_left_filter_feature_0_choice(78)) * 512) +
      (as_number(transform_left_filter_feature_0_choice(87)) * 256) +
      (as_number(transform_left_filter_feature_0_choice(95)) * 1024) +
      (as_number(transform_left_filter_feature_0_choice(104)) * 4096) +
      (as_number(transform_left_filter_feature_0_choice(113)) * 2048) +
      (as_number(transform_left_filter_feature_0_choice(121)) * 8192);
    transform_right_filter_feature_0 <= (transform_right_filter_feature_0_choice_17 * 64) +
      (as_number(transform_right_filter_feature_0_choice(26)) * 2) +
      as_number(transform_right_filter_feature_0_choice(35)) + (as_number(transform_right_filter_feature_0_choice(44))
      * 4) + (as_number(transform_right_filter_feature_0_choice(53)) * 16) +
      (as_number(transform_right_filter_feature_0_choice(62)) * 8) +
      (as_number(transform_right_filter_feature_0_choice(71)) * 32) +
      (as_number(transform_right_filter_feature_0_choice(80)) * 512) +
      (as_number(transform_right_filter_feature_0_choice(89)) * 256) +
      (as_number(transform_right_filter_feature_0_choice(98)) * 1024) +
      (as_number(transform_right_filter_feature_0_choice(107)) * 4096) +
      (as_number(transform_right_filter_feature_0_choice(116)) * 2048) +
      (as_number(transform_right_filter_feature_0_choice(125)) * 8192);
    transform_filtering_0_column_inside <= transform_columns_column_inside;
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
    transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
    transform_filtering_valid(1) <= transform_filtering_valid(0);
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice,
      transform_counter_group_choices(3));
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(2), (transform_counter_group /=
      376) and transform_counter_next_frame, transform_counter_next_frame);
    transform_counter_next_frame_choices(2) := choice(transform_counter_group_differs,
      transform_counter_next_frame_choices(1), transform_counter_next_frame);
    if in_valid then
      transform_counter_column <= choice(in_start_of_frame or transform_counter_group_is_equals(2), 0,
        (transform_counter_column + 1) mod 512);
      transform_counter_next_frame <= choice(transform_counter_next_frame_choices(2), (not in_start_of_frame) or
        transform_counter_group_all, in_start_of_frame and transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2));
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
        transform_left_filter_column(i, 0) <= transform_left_filter_column(i - 1, 0);
        transform_left_filter_column(i, 1) <= transform_left_filter_column(i - 1, 1);
        transform_left_filter_column(i, 2) <= transform_left_filter_column(i - 1, 2);
      end loop;
      for i in 1 to 8 loop
        transform_right_filter_column(i, 0) <= transform_right_filter_column(i - 1, 0);
        transform_right_filter_column(i, 1) <= transform_right_filter_column(i - 1, 1);
        transform_right_filter_column(i, 2) <= transform_right_filter_column(i - 1, 2);
      end loop;
      for i in 0 to 2 loop
        transform_left_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_left_column(i), 0);
        transform_right_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_right_column(i), 0);
      end loop;
    end if;
    -- raster
    raster_place_group_is_equals(1) := raster_place_group = 374;
    raster_place_group_is_equals(2) := raster_place_column = 449;
    raster_place_group_all := raster_place_group_is_equals(1) and raster_place_group_is_equals(2);
    raster_place_group_choice := choice(raster_place_group_all, 375, 0);
    raster_place_group_differs := raster_place_group /= 376;
    raster_place_group_choices(2) := choice((raster_place_group = 375) and raster_place_next_frame, 1,
      (raster_place_group + 1) mod 512);
    raster_place_group_choices(3) := choice(raster_place_group_differs and raster_place_group_is_equals(2) and
      transform_filtering_valid(1), raster_place_group_choices(2), raster_place_group);
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(1);
    raster_place_group <= choice(transform_filtering_start_of_frame(1) and transform_filtering_valid(1),
      raster_place_group_choice, raster_place_group_choices(3));
    raster_place_next_frame_choices(1) := choice(raster_place_group_is_equals(2), (raster_place_group /= 375) and
      raster_place_next_frame, raster_place_next_frame);
    raster_place_next_frame_choices(2) := choice(raster_place_group_differs, raster_place_next_frame_choices(1),
      raster_place_next_frame);
    if transform_filtering_valid(1) then
      raster_place_column <= choice(transform_filtering_start_of_frame(1) or raster_place_group_is_equals(2), 0,
        (raster_place_column + 1) mod 512);
      raster_place_next_frame <= choice(raster_place_next_frame_choices(2), (not transform_filtering_start_of_frame(1))
        or raster_place_group_all, transform_filtering_start_of_frame(1) and raster_place_group_is_equals(1) and
        raster_place_group_is_equals(2));
    end if;
    -- delay
    delay_row_inside_1_is_not_less := raster_place_group >= 1;
    delay_row_inside_1_is_less := raster_place_group < 376;
    delay_tag_first_cost_is_equal := raster_place_column = 63;
    delay_tag_map_column_is_not_less := raster_place_column >= 63;
    delay_tag_map_column_is_less := raster_place_column < 450;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 375;
    delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
    delay_row_inside(2) <= raster_place_group < 375;
    delay_tag.valid <= raster_features_valid;
    delay_tag.border_column <= raster_place_column < 63;
    delay_tag.first_cost <= delay_tag_first_cost_is_equal;
    delay_tag.map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and
      delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.start_of_frame <= (raster_place_group = 1) and delay_tag_first_cost_is_equal;
    delay_tag.end_of_line <= raster_place_group_is_equals(2);
    -- rows
    rows_search_rows_read_newest_0 <= delay_delayed_0;
    rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= delay_ahead_0;
    rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_tag <= rows_ready_tag;
    rows_search(0) <= choice(rows_ready_inside(0), rows_search_rows_ready_words_0 mod 16384, 0);
    rows_reference(0) <= choice(rows_ready_inside(0), rows_reference_rows_ready_words_0 mod 16384, 0);
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_words_0 / 16384, 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_words_0 / 16384, 0);
    rows_search(2) <= choice(rows_ready_inside(2), rows_search_rows_ready_newest_0, 0);
    rows_reference(2) <= choice(rows_ready_inside(2), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 16384) + (rows_search_rows_ready_newest_0 *
        16384);
      rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 16384) +
        (rows_reference_rows_ready_newest_0 * 16384);
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 2 loop
        slice0shift_search(i, 0) <= rows_search(i);
        for j in 1 to 15 loop slice0shift_search(i, j) <= slice0shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 15);
    slice0shift_search_out(1) <= slice0shift_search(1, 15);
    slice0shift_search_out(2) <= slice0shift_search(2, 15);
    slice0shift_tag <= rows_tag;
    -- slice0cost
    for i in 0 to 2 loop
      slice0cost_pixels_first_count(i, 0, 0) <= differing(slice0shift_search(i, 0), slice0shift_reference(i), 0) +
        differing(slice0shift_reference(i), slice0shift_search(i, 0), 2) + differing(slice0shift_reference(i),
        slice0shift_search(i, 0), 1);
      slice0cost_pixels_first_count(i, 0, 1) <= differing(slice0shift_reference(i), slice0shift_search(i, 0), 3, 5, 4);
      slice0cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice0shift_search(i, 0) mod 256), 8)) xor
        (to_unsigned((slice0shift_reference(i) mod 256), 8)))) / 128) + differing(slice0shift_reference(i),
        slice0shift_search(i, 0), 8) + differing(slice0shift_reference(i), slice0shift_search(i, 0), 6);
      slice0cost_pixels_first_count(i, 0, 3) <= differing(slice0shift_reference(i), slice0shift_search(i, 0), 9, 11,
        10);
      slice0cost_pixels_first_count_4(i, 0) <= differing(slice0shift_reference(i), slice0shift_search(i, 0), 13) +
        differing(slice0shift_reference(i), slice0shift_search(i, 0), 12);
      for j in 1 to 15 loop
        slice0cost_pixels_first_count(i, j, 0) <= differing(slice0shift_search(i, j), slice0shift_reference(i), 0, 2,
          1);
        slice0cost_pixels_first_count(i, j, 1) <= differing(slice0shift_search(i, j), slice0shift_reference(i), 3, 5,
          4);
        slice0cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice0shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice0shift_reference(i) mod 256), 8)))) / 128) + differing(slice0shift_search(i, j),
          slice0shift_reference(i), 8) + differing(slice0shift_search(i, j), slice0shift_reference(i), 6);
        slice0cost_pixels_first_count(i, j, 3) <= differing(slice0shift_search(i, j), slice0shift_reference(i), 9, 11,
          10);
        slice0cost_pixels_first_count_4(i, j) <= differing(slice0shift_search(i, j), slice0shift_reference(i), 13) +
          differing(slice0shift_search(i, j), slice0shift_reference(i), 12);
      end loop;
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 2 loop
      for j in 0 to 15 loop
        slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 3) + slice0cost_pixels_first_count(i, j, 0)
          + slice0cost_pixels_first_count(i, j, 1) + slice0cost_pixels_first_count_4(i, j) +
          slice0cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    for i in 0 to 15 loop slice0cost_pair_0(i) <= slice0cost_pixels_cost(1, i) + slice0cost_pixels_cost(2, i); end loop;
    for i in 0 to 15 loop slice0cost_single_0(i) <= slice0cost_pixels_cost(0, i); end loop;
    slice0cost_pair_tag <= slice0cost_pixels_tag;
    slice0cost_tag <= slice0cost_pair_tag;
    for i in 0 to 15 loop
      slice0cost_column_0(i) <= choice(slice0cost_pair_tag.border_column, 0, slice0cost_pair_0(i) +
        slice0cost_single_0(i));
    end loop;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_partial_0_0 <= slice0cost_column_0;
      for i in 0 to 15 loop
        slice0window_partial_0_1(i) <= slice0cost_column_0(i) + slice0window_partial_0_0(i);
      end loop;
      slice0window_centre_map_column_0 <= slice0cost_tag.map_column;
      slice0window_centre_output_column_0 <= slice0cost_tag.output_column;
      slice0window_centre_first_column_0 <= slice0cost_tag.first_cost;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag.start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag.end_of_line;
    end if;
    for i in 0 to 15 loop slice0window_sum_0(i) <= slice0cost_column_0(i) + slice0window_partial_0_1(i); end loop;
    slice0window_tag.valid <= slice0cost_tag.valid;
    slice0window_tag.map_column <= slice0window_centre_map_column_0;
    slice0window_tag.output_column <= slice0window_centre_output_column_0;
    slice0window_tag.first_column <= slice0window_centre_first_column_0;
    slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame_0;
    slice0window_tag.end_of_line <= slice0window_centre_end_of_line_0;
    -- slice0
    for i in 1 to 3 loop
      for j in 0 to 15 loop slice0_held(i, j) <= slice0_held(i - 1, j); end loop;
    end loop;
    slice0_tag_valid(0) <= slice0window_tag.valid;
    slice0_tag_map_column(0) <= slice0window_tag.map_column;
    slice0_tag_output_column(0) <= slice0window_tag.output_column;
    slice0_tag_first_column(0) <= slice0window_tag.first_column;
    slice0_tag_start_of_frame(0) <= slice0window_tag.start_of_frame;
    slice0_tag_end_of_line(0) <= slice0window_tag.end_of_line;
    for i in 1 to 3 loop
      slice0_tag_valid(i) <= slice0_tag_valid(i - 1);
      slice0_tag_map_column(i) <= slice0_tag_map_column(i - 1);
      slice0_tag_output_column(i) <= slice0_tag_output_column(i - 1);
      slice0_tag_first_column(i) <= slice0_tag_first_column(i - 1);
      slice0_tag_start_of_frame(i) <= slice0_tag_start_of_frame(i - 1);
      slice0_tag_end_of_line(i) <= slice0_tag_end_of_line(i - 1);
    end loop;
    for i in 0 to 15 loop
      slice0_held(0, i) <= choice(is_set(slice0window_sum_0(i), 6) or (((slice0window_sum_0(i) / 16) mod 4) = 3), 5,
        slice0window_sum_0(i) / 8);
    end loop;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 2 loop
        slice1shift_search(i, 0) <= slice0shift_search_out(i);
        for j in 1 to 15 loop slice1shift_search(i, j) <= slice1shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    slice1shift_search_out(0) <= slice1shift_search(0, 15);
    slice1shift_search_out(1) <= slice1shift_search(1, 15);
    slice1shift_search_out(2) <= slice1shift_search(2, 15);
    -- slice1cost
    for i in 0 to 2 loop
      slice1cost_pixels_first_count(i, 0, 0) <= differing(slice1shift_search(i, 0), slice1shift_reference(i), 0) +
        differing(slice1shift_reference(i), slice1shift_search(i, 0), 2) + differing(slice1shift_reference(i),
        slice1shift_search(i, 0), 1);
      slice1cost_pixels_first_count(i, 0, 1) <= differing(slice1shift_reference(i), slice1shift_search(i, 0), 3, 5, 4);
      slice1cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice1shift_search(i, 0) mod 256), 8)) xor
        (to_unsigned((slice1shift_reference(i) mod 256), 8)))) / 128) + differing(slice1shift_reference(i),
        slice1shift_search(i, 0), 8) + differing(slice1shift_reference(i), slice1shift_search(i, 0), 6);
      slice1cost_pixels_first_count(i, 0, 3) <= differing(slice1shift_reference(i), slice1shift_search(i, 0), 9, 11,
        10);
      slice1cost_pixels_first_count_4(i, 0) <= differing(slice1shift_reference(i), slice1shift_search(i, 0), 13) +
        differing(slice1shift_reference(i), slice1shift_search(i, 0), 12);
      for j in 1 to 15 loop
        slice1cost_pixels_first_count(i, j, 0) <= differing(slice1shift_search(i, j), slice1shift_reference(i), 0, 2,
          1);
        slice1cost_pixels_first_count(i, j, 1) <= differing(slice1shift_search(i, j), slice1shift_reference(i), 3, 5,
          4);
        slice1cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice1shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice1shift_reference(i) mod 256), 8)))) / 128) + differing(slice1shift_search(i, j),
          slice1shift_reference(i), 8) + differing(slice1shift_search(i, j), slice1shift_reference(i), 6);
        slice1cost_pixels_first_count(i, j, 3) <= differing(slice1shift_search(i, j), slice1shift_reference(i), 9, 11,
          10);
        slice1cost_pixels_first_count_4(i, j) <= differing(slice1shift_search(i, j), slice1shift_reference(i), 13) +
          differing(slice1shift_search(i, j), slice1shift_reference(i), 12);
      end loop;
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 15 loop
        slice1cost_pixels_cost(i, j) <= slice1cost_pixels_first_count(i, j, 3) + slice1cost_pixels_first_count(i, j, 0)
          + slice1cost_pixels_first_count(i, j, 1) + slice1cost_pixels_first_count_4(i, j) +
          slice1cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    for i in 0 to 15 loop slice1cost_pair_0(i) <= slice1cost_pixels_cost(1, i) + slice1cost_pixels_cost(2, i); end loop;
    for i in 0 to 15 loop slice1cost_single_0(i) <= slice1cost_pixels_cost(0, i); end loop;
    slice1cost_tag_border_column <= slice0cost_tag.border_column;
    for i in 0 to 15 loop
      slice1cost_column_0(i) <= choice(slice0cost_tag.border_column, 0, slice1cost_pair_0(i) + slice1cost_single_0(i));
    end loop;
    -- slice1window
    if slice0window_tag.valid then
      slice1window_partial_0_0 <= slice1cost_column_0;
      for i in 0 to 15 loop
        slice1window_partial_0_1(i) <= slice1cost_column_0(i) + slice1window_partial_0_0(i);
      end loop;
    end if;
    for i in 0 to 15 loop slice1window_sum_0(i) <= slice1cost_column_0(i) + slice1window_partial_0_1(i); end loop;
    -- slice1
    for i in 0 to 15 loop slice1_held(1, i) <= slice1_held(0, i); end loop;
    for i in 0 to 15 loop slice1_held(2, i) <= slice1_held(1, i); end loop;
    for i in 0 to 15 loop
      slice1_held(0, i) <= choice(is_set(slice1window_sum_0(i), 6) or (((slice1window_sum_0(i) / 16) mod 4) = 3), 5,
        slice1window_sum_0(i) / 8);
    end loop;
    -- slice2shift
    if slice0cost_pixels_first_tag.valid then
      for i in 0 to 2 loop
        slice2shift_search(i, 0) <= slice1shift_search_out(i);
        for j in 1 to 15 loop slice2shift_search(i, j) <= slice2shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice2shift_reference <= slice1shift_reference;
    slice2shift_search_out(0) <= slice2shift_search(0, 15);
    slice2shift_search_out(1) <= slice2shift_search(1, 15);
    slice2shift_search_out(2) <= slice2shift_search(2, 15);
    -- slice2cost
    for i in 0 to 2 loop
      slice2cost_pixels_first_count(i, 0, 0) <= differing(slice2shift_search(i, 0), slice2shift_reference(i), 0) +
        differing(slice2shift_reference(i), slice2shift_search(i, 0), 2) + differing(slice2shift_reference(i),
        slice2shift_search(i, 0), 1);
      slice2cost_pixels_first_count(i, 0, 1) <= differing(slice2shift_reference(i), slice2shift_search(i, 0), 3, 5, 4);
      slice2cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, 0) mod 256), 8)) xor
        (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) + differing(slice2shift_reference(i),
        slice2shift_search(i, 0), 8) + differing(slice2shift_reference(i), slice2shift_search(i, 0), 6);
      slice2cost_pixels_first_count(i, 0, 3) <= differing(slice2shift_reference(i), slice2shift_search(i, 0), 9, 11,
        10);
      slice2cost_pixels_first_count_4(i, 0) <= differing(slice2shift_reference(i), slice2shift_search(i, 0), 13) +
        differing(slice2shift_reference(i), slice2shift_search(i, 0), 12);
      for j in 1 to 15 loop
        slice2cost_pixels_first_count(i, j, 0) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 0, 2,
          1);
        slice2cost_pixels_first_count(i, j, 1) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 3, 5,
          4);
        slice2cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) + differing(slice2shift_search(i, j),
          slice2shift_reference(i), 8) + differing(slice2shift_search(i, j), slice2shift_reference(i), 6);
        slice2cost_pixels_first_count(i, j, 3) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 9, 11,
          10);
        slice2cost_pixels_first_count_4(i, j) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 13) +
          differing(slice2shift_search(i, j), slice2shift_reference(i), 12);
      end loop;
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 15 loop
        slice2cost_pixels_cost(i, j) <= slice2cost_pixels_first_count(i, j, 3) + slice2cost_pixels_first_count(i, j, 0)
          + slice2cost_pixels_first_count(i, j, 1) + slice2cost_pixels_first_count_4(i, j) +
          slice2cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    for i in 0 to 15 loop slice2cost_pair_0(i) <= slice2cost_pixels_cost(1, i) + slice2cost_pixels_cost(2, i); end loop;
    for i in 0 to 15 loop slice2cost_single_0(i) <= slice2cost_pixels_cost(0, i); end loop;
    slice2cost_tag_border_column <= slice1cost_tag_border_column;
    for i in 0 to 15 loop
      slice2cost_column_0(i) <= choice(slice1cost_tag_border_column, 0, slice2cost_pair_0(i) + slice2cost_single_0(i));
    end loop;
    -- slice2window
    if slice0_tag_valid(0) then
      slice2window_partial_0_0 <= slice2cost_column_0;
      for i in 0 to 15 loop
        slice2window_partial_0_1(i) <= slice2cost_column_0(i) + slice2window_partial_0_0(i);
      end loop;
    end if;
    for i in 0 to 15 loop slice2window_sum_0(i) <= slice2cost_column_0(i) + slice2window_partial_0_1(i); end loop;
    -- slice2
    for i in 0 to 15 loop slice2_held(1, i) <= slice2_held(0, i); end loop;
    for i in 0 to 15 loop
      slice2_held(0, i) <= choice(is_set(slice2window_sum_0(i), 6) or (((slice2window_sum_0(i) / 16) mod 4) = 3), 5,
        slice2window_sum_0(i) / 8);
    end loop;
    -- slice3shift
    if slice0cost_pixels_tag.valid then
      for i in 0 to 2 loop
        slice3shift_search(i, 0) <= slice2shift_search_out(i);
        for j in 1 to 15 loop slice3shift_search(i, j) <= slice3shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice3shift_reference <= slice2shift_reference;
    -- slice3cost
    for i in 0 to 2 loop
      slice3cost_pixels_first_count(i, 0, 0) <= differing(slice3shift_search(i, 0), slice3shift_reference(i), 0) +
        differing(slice3shift_reference(i), slice3shift_search(i, 0), 2) + differing(slice3shift_reference(i),
        slice3shift_search(i, 0), 1);
      slice3cost_pixels_first_count(i, 0, 1) <= differing(slice3shift_reference(i), slice3shift_search(i, 0), 3, 5, 4);
      slice3cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice3shift_search(i, 0) mod 256), 8)) xor
        (to_unsigned((slice3shift_reference(i) mod 256), 8)))) / 128) + differing(slice3shift_reference(i),
        slice3shift_search(i, 0), 8) + differing(slice3shift_reference(i), slice3shift_search(i, 0), 6);
      slice3cost_pixels_first_count(i, 0, 3) <= differing(slice3shift_reference(i), slice3shift_search(i, 0), 9, 11,
        10);
      slice3cost_pixels_first_count_4(i, 0) <= differing(slice3shift_reference(i), slice3shift_search(i, 0), 13) +
        differing(slice3shift_reference(i), slice3shift_search(i, 0), 12);
      for j in 1 to 15 loop
        slice3cost_pixels_first_count(i, j, 0) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 0, 2,
          1);
        slice3cost_pixels_first_count(i, j, 1) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 3, 5,
          4);
        slice3cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice3shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice3shift_reference(i) mod 256), 8)))) / 128) + differing(slice3shift_search(i, j),
          slice3shift_reference(i), 8) + differing(slice3shift_search(i, j), slice3shift_reference(i), 6);
        slice3cost_pixels_first_count(i, j, 3) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 9, 11,
          10);
        slice3cost_pixels_first_count_4(i, j) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 13) +
          differing(slice3shift_search(i, j), slice3shift_reference(i), 12);
      end loop;
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 15 loop
        slice3cost_pixels_cost(i, j) <= slice3cost_pixels_first_count(i, j, 3) + slice3cost_pixels_first_count(i, j, 0)
          + slice3cost_pixels_first_count(i, j, 1) + slice3cost_pixels_first_count_4(i, j) +
          slice3cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    for i in 0 to 15 loop slice3cost_pair_0(i) <= slice3cost_pixels_cost(1, i) + slice3cost_pixels_cost(2, i); end loop;
    for i in 0 to 15 loop slice3cost_single_0(i) <= slice3cost_pixels_cost(0, i); end loop;
    for i in 0 to 15 loop
      slice3cost_column_0(i) <= choice(slice2cost_tag_border_column, 0, slice3cost_pair_0(i) + slice3cost_single_0(i));
    end loop;
    -- slice3window
    if slice0_tag_valid(1) then
      slice3window_partial_0_0 <= slice3cost_column_0;
      for i in 0 to 15 loop
        slice3window_partial_0_1(i) <= slice3cost_column_0(i) + slice3window_partial_0_0(i);
      end loop;
    end if;
    for i in 0 to 15 loop slice3window_sum_0(i) <= slice3cost_column_0(i) + slice3window_partial_0_1(i); end loop;
    -- slice3
    for i in 0 to 15 loop
      slice3_held_0(i) <= choice(is_set(slice3window_sum_0(i), 6) or (((slice3window_sum_0(i) / 16) mod 4) = 3), 5,
        slice3window_sum_0(i) / 8);
    end loop;
    -- entry
    entry_order_falls_any := entry_order_inside or (not slice0_tag_map_column(3)) or (not slice0_tag_valid(3));
    entry_order_falls_all := (not entry_order_inside) and slice0_tag_map_column(3) and slice0_tag_valid(3);
    entry_order_complete_all := slice0_tag_map_column(3) and slice0_tag_valid(3);
    entry_order_complete_any := (not slice0_tag_map_column(3)) or (not slice0_tag_valid(3));
    entry_order_turned_output_column_choice := choice(entry_order_falls_all, entry_order_output and
      entry_order_complete, entry_order_held_output);
    for i in 0 to 15 loop entry_next_cost(i) <= slice0_held(3, i); end loop;
    for i in 16 to 31 loop entry_next_cost(i) <= slice1_held(2, i - 16); end loop;
    for i in 32 to 47 loop entry_next_cost(i) <= slice2_held(1, i - 32); end loop;
    entry_next_cost(48) <= slice3_held_0(0);
    entry_next_cost(49 to 63) <= slice3_held_0(1 to 15);
    entry_next_tag.valid <= slice0_tag_valid(3);
    entry_next_tag.map_column <= slice0_tag_map_column(3);
    entry_next_tag.first_column <= slice0_tag_first_column(3);
    entry_next_tag.end_of_line <= slice0_tag_end_of_line(3);
    entry_order_turned_output_column <= entry_order_turned_output_column_choice and slice0_tag_map_column(3);
    entry_order_turned_first_column <= entry_order_falls_all;
    entry_order_turned_start_of_frame <= (not entry_order_inside) and slice0_tag_map_column(3) and slice0_tag_valid(3)
      and entry_order_first and entry_order_output and entry_order_complete;
    entry_cost <= entry_next_cost;
    entry_tag <= entry_next_tag;
    entry_column <= entry_next_column;
    entry_top <= entry_next_top;
    entry_place <= entry_order_address;
    entry_turned_output_column <= entry_order_turned_output_column;
    entry_turned_first_column <= entry_order_turned_first_column;
    entry_turned_start_of_frame <= entry_order_turned_start_of_frame;
    entry_order_falls <= choice(entry_order_falls, entry_order_falls_any, entry_order_falls_all);
    entry_order_complete <= choice(slice0_tag_end_of_line(3), entry_order_complete or entry_order_complete_all,
      entry_order_complete and entry_order_complete_any);
    if entry_order_complete_all then
      entry_next_column <= choice(slice0_tag_first_column(3), 0, (entry_next_column + 1) mod 512);
      entry_next_top <= choice(slice0_tag_first_column(3), slice0_tag_start_of_frame(3), entry_next_top);
    end if;
    entry_order_address_choice := choice(entry_order_falls, 511, 1);
    entry_order_address_choice_2 := choice(entry_order_falls, 0, 193);
    if not entry_order_complete_any then
      entry_order_address <= choice(entry_order_falls_any, (entry_order_address_choice + entry_order_address) mod 512,
        entry_order_address_choice_2 * 2);
    end if;
    if slice0_tag_valid(3) then entry_order_inside <= slice0_tag_map_column(3); end if;
    if entry_order_falls_all then
      entry_order_output <= slice0_tag_output_column(3);
      entry_order_first <= slice0_tag_start_of_frame(3);
      entry_order_held_output <= entry_order_output and entry_order_complete;
    end if;
    -- forward
    for i in 0 to 15 loop
      forward_left_pair_choice(2 * i) := smaller(forward_left_cost(4 * i + 2), forward_left_cost(4 * i));
      forward_left_pair_choice(2 * i + 1) := smaller(forward_left_cost(4 * i + 3), forward_left_cost(4 * i + 1));
    end loop;
    forward_left_start_cost_0_any := ((((forward_left_tree_next_next_next_next_smallest_0 mod 64) +
      forward_left_relief_beyond) / 64) = 1) or is_set(forward_left_tree_next_next_next_next_smallest_0, 6);
    forward_left_start_cost_0_values(1) := is_set(forward_left_room, 2);
    forward_left_start_cost_0_values(2) := is_set(forward_left_room, 3);
    forward_left_start_cost_0_values(3) := is_set(forward_left_room, 4);
    forward_left_start_cost_0_choice_6 := is_larger(forward_left_relief_largest, forward_left_room, 0, 5, false);
    forward_left_start_cost_0_choice(7) := choice(forward_left_start_cost_0_choice_6, 0, (forward_left_room -
      forward_left_relief_largest) mod 64);
    forward_left_start_cost_0_is_less := 127 < ((forward_left_tree_next_next_next_next_smallest_0 mod 64) +
      forward_left_relief_reach_of_best);
    forward_left_start_cost_0_choice(8) := choice(forward_left_start_cost_0_is_less,
      (forward_left_tree_next_next_next_next_smallest_0 + forward_left_relief_reach_of_best) mod 64, 0);
    forward_left_start_cost_0_choice(9) := choice(forward_left_start_cost_0_any, forward_left_start_cost_0_choice(7),
      forward_left_start_cost_0_choice(8));
    forward_left_room_value := (forward_left_start_cost(8) + forward_left_room) mod 64;
    forward_left_room_choices(1) := choice(forward_left_start_cost_0_choice_6, forward_left_room_value,
      (forward_left_start_cost(8) + forward_left_relief_largest) mod 64);
    forward_left_room_choices(2) := choice(forward_left_start_cost_0_is_less, (forward_left_relief_room_of_best -
      forward_left_tree_next_next_next_next_smallest_0) mod 64, forward_left_room_value);
    forward_left_room_choices(3) := choice(forward_left_start_cost_0_any, forward_left_room_choices(1),
      forward_left_room_choices(2));
    forward_left_smallest_choice := choice(forward_first(5), 0, forward_reliefs_moved(5));
    forward_left_smallest_difference := (forward_smallest_next_next_next_next_next_smallest_0 +
      forward_left_smallest_choice) - forward_reliefs_moved(4);
    forward_left_relief_pairs_0_choice := choice((forward_left_smallest_choice - forward_left_relief_past(0)) < 0,
      forward_left_relief_past(0), forward_left_smallest_choice);
    forward_left_relief_older_choice := choice((forward_left_relief_fours(0) - forward_left_relief_fours(2)) < 0,
      forward_left_relief_fours(2), forward_left_relief_fours(0));
    forward_left_relief_recent_choice := choice((forward_reliefs_moved(4) - forward_left_smallest_choice) < 0,
      forward_left_smallest_choice, forward_reliefs_moved(4));
    forward_left_relief_largest_choice := choice((forward_reliefs_moved(4) - forward_left_relief_recent) < 0,
      forward_left_relief_recent, forward_reliefs_moved(4));
    forward_left_relief_reach_of_best_sum := forward_left_room + forward_left_relief_leaves;
    forward_left_relief_reach_of_best_choice := choice(forward_left_start_cost_0_choice_6,
      forward_left_relief_reach_of_best_sum, forward_left_relief_largest + forward_left_relief_leaves);
    forward_left_relief_reach_of_best_choices(2) := choice(forward_left_start_cost_0_is_less,
      (forward_left_relief_reach_again - (forward_left_tree_next_next_next_next_smallest_0 mod 64)) mod 256,
      forward_left_relief_reach_of_best_sum);
    forward_left_relief_reach_of_best_choices(3) := choice(forward_left_start_cost_0_any,
      forward_left_relief_reach_of_best_choice, forward_left_relief_reach_of_best_choices(2));
    forward_left_relief_leaves_choice := choice(forward_first(5), 64, forward_left_start_cost(7) + 64);
    forward_left_g_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest) mod 128;
    forward_left_g_less_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest_less) mod 128;
    for i in 0 to 63 loop
      forward_left_cost_choice(i, 1) := smaller(forward_left_arrived(i), forward_left_cost(i));
      forward_left_cost_choice(i, 2) := choice(is_set(forward_left_cost_choice(i, 1), 6) or forward_left_first(2), 64,
        forward_left_cost_choice(i, 1));
    end loop;
    forward_left_arrived_choice(0, 1) := choice(forward_left_first(2), 64, forward_left_cost(1));
    for i in 0 to 14 loop
      forward_left_arrived_choice(4 * i + 1, 1) := choice(forward_left_first(2), 64, forward_left_pair_choice(2 * i));
      forward_left_arrived_choice(4 * i + 2, 1) := choice(forward_left_first(2), 64, forward_left_pair_choice(2 * i +
        1));
      forward_left_arrived_choice(4 * i + 3, 1) := smaller(forward_left_cost(4 * i + 4), forward_left_cost(4 * i + 2));
      forward_left_arrived_choice(4 * i + 3, 2) := choice(forward_left_first(2), 64, forward_left_arrived_choice(4 * i
        + 3, 1));
      forward_left_arrived_choice(4 * i + 4, 1) := smaller(forward_left_cost(4 * i + 5), forward_left_cost(4 * i + 3));
      forward_left_arrived_choice(4 * i + 4, 2) := choice(forward_left_first(2), 64, forward_left_arrived_choice(4 * i
        + 4, 1));
    end loop;
    forward_left_arrived_choice(61, 1) := choice(forward_left_first(2), 64, forward_left_pair_choice(30));
    forward_left_arrived_choice(62, 1) := choice(forward_left_first(2), 64, forward_left_pair_choice(31));
    forward_left_arrived_choice(63, 1) := choice(forward_left_first(2), 64, forward_left_cost(62));
    for i in 0 to 4 loop
      for j in 0 to 5 loop
        forward_above_total_choice(12 * i + j) := choice(forward_above_ready_top, 31,
          to_integer(forward_above_ready_words(2 * i)(5 * j + 4 downto 5 * j)));
      end loop;
      for j in 6 to 11 loop
        forward_above_total_choice(12 * i + j) := choice(forward_above_ready_top, 31,
          to_integer(forward_above_ready_words(2 * i + 1)(5 * j - 26 downto 5 * j - 30)));
      end loop;
    end loop;
    forward_above_total_choice(60) := choice(forward_above_ready_top, 31, forward_above_ready_words_10 mod 32);
    forward_above_total_choice(61) := choice(forward_above_ready_top, 31, (forward_above_ready_words_10 / 32) mod 32);
    forward_above_total_choice(62) := choice(forward_above_ready_top, 31, (forward_above_ready_words_10 / 1024) mod 32);
    forward_above_total_choice(63) := choice(forward_above_ready_top, 31, (forward_above_ready_words_10 / 32768) mod
      32);
    if entry_tag.valid then
      forward_cost_delay_ring_write_address <= forward_cost_delay_ring_read_address;
      forward_left_pair <= forward_left_pair_choice;
      forward_left_smallest <= forward_left_smallest_difference mod 128;
      forward_left_smallest_less <= (forward_left_smallest_difference + 121) mod 128;
      forward_left_first(0) <= forward_first(5);
      forward_left_first(1 to 2) <= forward_left_first(0 to 1);
      forward_left_relief_next_0 <= forward_reliefs_moved(4);
      forward_left_relief_past(0) <= forward_left_smallest_choice;
      forward_left_relief_past(1 to 7) <= forward_left_relief_past(0 to 6);
      forward_left_relief_pairs(0) <= forward_left_relief_pairs_0_choice;
      forward_left_relief_pairs(1) <= forward_left_relief_pairs(0);
      forward_left_relief_fours(1 to 2) <= forward_left_relief_fours(0 to 1);
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
      for i in 0 to 3 loop
        for j in 0 to 15 loop
          forward_left_stay_change(16 * i + j) <= (forward_cost(0, 16 * i + j) - forward_left_g_copy(i)) mod 128;
        end loop;
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 15 loop
          forward_left_step_change(16 * i + j) <= (forward_cost(0, 16 * i + j) - forward_left_g_less_copy(i)) mod 128;
        end loop;
      end loop;
      for i in 0 to 63 loop
        forward_left_cost(i) <= (forward_left_cost_choice(i, 2) + forward_left_stay_change(i)) mod 128;
      end loop;
      for i in 0 to 2 loop
        forward_left_arrived(i) <= (forward_left_arrived_choice(i, 1) + forward_left_step_change(i)) mod 128;
      end loop;
      for i in 0 to 13 loop
        forward_left_arrived(4 * i + 3) <= (forward_left_arrived_choice(4 * i + 3, 2) + forward_left_step_change(4 * i
          + 3)) mod 128;
        forward_left_arrived(4 * i + 4) <= (forward_left_arrived_choice(4 * i + 4, 2) + forward_left_step_change(4 * i
          + 4)) mod 128;
        forward_left_arrived(4 * i + 5) <= (forward_left_arrived_choice(4 * i + 5, 1) + forward_left_step_change(4 * i
          + 5)) mod 128;
        forward_left_arrived(4 * i + 6) <= (forward_left_arrived_choice(4 * i + 6, 1) + forward_left_step_change(4 * i
          + 6)) mod 128;
      end loop;
      forward_left_arrived(59) <= (forward_left_arrived_choice(59, 2) + forward_left_step_change(59)) mod 128;
      forward_left_arrived(60) <= (forward_left_arrived_choice(60, 2) + forward_left_step_change(60)) mod 128;
      for i in 61 to 63 loop
        forward_left_arrived(i) <= (forward_left_arrived_choice(i, 1) + forward_left_step_change(i)) mod 128;
      end loop;
      forward_above_ready_words <= forward_above_read_words;
      forward_above_ready_words_10 <= to_integer(forward_above_read_words_10);
      forward_above_ready_cost <= entry_cost;
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
        forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(0)) mod 64;
        forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
          forward_above_smallest_copy(0)) mod 64;
        forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
          forward_above_smallest_copy(0)) mod 64;
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy(0)) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(0)) mod 64;
      end loop;
      forward_above_cost(15) <= (to_integer(forward_above_delay_held(3)) - forward_above_smallest_copy(0)) mod 64;
      for i in 3 to 5 loop
        forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
          forward_above_smallest_copy(1)) mod 64;
        forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
          forward_above_smallest_copy(1)) mod 64;
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy(1)) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(1)) mod 64;
        forward_above_cost(5 * i + 5) <= (to_integer(forward_above_delay_held(i + 1)) - forward_above_smallest_copy(1))
          mod 64;
      end loop;
      forward_above_cost(31) <= (to_integer(forward_above_delay_held(6)(29 downto 6)) - forward_above_smallest_copy(1))
        mod 64;
      for i in 6 to 8 loop
        forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
          forward_above_smallest_copy(2)) mod 64;
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy(2)) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(2)) mod 64;
        forward_above_cost(5 * i + 5) <= (to_integer(forward_above_delay_held(i + 1)) - forward_above_smallest_copy(2))
          mod 64;
        forward_above_cost(5 * i + 6) <= (to_integer(forward_above_delay_held(i + 1)(29 downto 6)) -
          forward_above_smallest_copy(2)) mod 64;
      end loop;
      for i in 9 to 10 loop
        forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
          forward_above_smallest_copy(i - 7)) mod 64;
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(5 * i + 5) <= (to_integer(forward_above_delay_held(i + 1)) - forward_above_smallest_copy(3))
          mod 64;
        forward_above_cost(5 * i + 6) <= (to_integer(forward_above_delay_held(i + 1)(29 downto 6)) -
          forward_above_smallest_copy(3)) mod 64;
      end loop;
      forward_above_cost(57) <= (to_integer(forward_above_delay_held(11)(29 downto 12)) -
        forward_above_smallest_copy(3)) mod 64;
      forward_above_cost(58) <= (to_integer(forward_above_delay_held(11)(29 downto 18)) -
        forward_above_smallest_copy(3)) mod 64;
      forward_above_cost(59) <= (to_integer(forward_above_delay_held(11)(29 downto 24)) -
        forward_above_smallest_copy(3)) mod 64;
      forward_above_cost(60) <= (to_integer(forward_above_delay_held_12) - forward_above_smallest_copy(3)) mod 64;
      forward_above_cost(61) <= (to_integer(forward_above_delay_held_12(23 downto 6)) - forward_above_smallest_copy(3))
        mod 64;
      forward_above_cost(62) <= (to_integer(forward_above_delay_held_12(23 downto 12)) -
        forward_above_smallest_copy(3)) mod 64;
      forward_above_cost(63) <= (to_integer(forward_above_delay_held_12(23 downto 18)) -
        forward_above_smallest_copy(3)) mod 64;
      forward_above_beside(0) <= forward_above_cost(1);
      forward_above_beside(63) <= forward_above_cost(62);
      forward_above_own_0 <= forward_above_cost(0);
      forward_above_own <= forward_above_cost(2 to 61);
      forward_above_own_63 <= forward_above_cost(63);
      for i in 0 to 63 loop forward_above_step(i) <= forward_above_beside(i) + 5; end loop;
      forward_above_comes(0) <= entry_tag.map_column;
      forward_above_comes(1 to 11) <= forward_above_comes(0 to 10);
      forward_above_column(0) <= entry_column;
      forward_above_column(1 to 11) <= forward_above_column(0 to 10);
      forward_first(0) <= entry_turned_first_column;
      forward_first(1) <= sums_turn_ready_first;
      forward_first(2 to 5) <= forward_first(1 to 4);
      forward_reliefs_moved(0) <= relief_entered;
      forward_reliefs_moved(1 to 5) <= forward_reliefs_moved(0 to 4);
      forward_reliefs_moved(6) <= forward_left_relief_next_0;
      forward_reliefs_moved(7 to 10) <= forward_reliefs_moved(6 to 9);
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
        for j in 0 to 63 loop forward_cost(i, j) <= forward_cost(i - 1, j); end loop;
      end loop;
      forward_smallest_cost(0) <= forward_smallest_next_next_next_next_next_smallest_0;
      forward_smallest_cost(1 to 4) <= forward_smallest_cost(0 to 3);
      for i in 0 to 31 loop forward_smallest_smallest(i) <= smaller(entry_cost(2 * i + 1), entry_cost(2 * i)); end loop;
      for i in 0 to 15 loop
        forward_smallest_next_smallest(i) <= smaller(forward_smallest_smallest(2 * i + 1), forward_smallest_smallest(2
          * i));
      end loop;
      for i in 0 to 7 loop
        forward_smallest_next_next_smallest(i) <= smaller(forward_smallest_next_smallest(2 * i + 1),
          forward_smallest_next_smallest(2 * i));
      end loop;
      for i in 0 to 3 loop
        forward_smallest_next_next_next_smallest(i) <= smaller(forward_smallest_next_next_smallest(2 * i + 1),
          forward_smallest_next_next_smallest(2 * i));
      end loop;
      forward_smallest_next_next_next_next_smallest(0) <= smaller(forward_smallest_next_next_next_smallest(1),
        forward_smallest_next_next_next_smallest(0));
      forward_smallest_next_next_next_next_smallest(1) <= smaller(forward_smallest_next_next_next_smallest(3),
        forward_smallest_next_next_next_smallest(2));
      forward_smallest_next_next_next_next_next_smallest_0 <= smaller(forward_smallest_next_next_next_next_smallest(1),
        forward_smallest_next_next_next_next_smallest(0));
      forward_cost_delay_ring_read_address <= choice(forward_cost_delay_ring_read_address = 6, 0,
        (forward_cost_delay_ring_read_address + 1) mod 8);
      for i in 0 to 15 loop
        forward_left_tree_smallest(i) <= smaller(forward_left_pair(2 * i + 1), forward_left_pair(2 * i));
      end loop;
      for i in 0 to 7 loop
        forward_left_tree_next_smallest(i) <= smaller(forward_left_tree_smallest(2 * i + 1),
          forward_left_tree_smallest(2 * i));
      end loop;
      for i in 0 to 3 loop
        forward_left_tree_next_next_smallest(i) <= smaller(forward_left_tree_next_smallest(2 * i + 1),
          forward_left_tree_next_smallest(2 * i));
      end loop;
      forward_left_tree_next_next_next_smallest(0) <= smaller(forward_left_tree_next_next_smallest(1),
        forward_left_tree_next_next_smallest(0));
      forward_left_tree_next_next_next_smallest(1) <= smaller(forward_left_tree_next_next_smallest(3),
        forward_left_tree_next_next_smallest(2));
      forward_left_tree_next_next_next_next_smallest_0 <= smaller(forward_left_tree_next_next_next_smallest(1),
        forward_left_tree_next_next_next_smallest(0));
      forward_left_start_cost(0) <= choice(forward_first(5), 60, forward_left_start_cost_0_choice(9));
      for i in 1 to 8 loop
        forward_left_start_cost(i) <= choice(forward_first(5), 0, forward_left_start_cost(i - 1));
      end loop;
      forward_left_room <= choice(forward_first(5), 0, forward_left_room_choices(3));
      forward_left_relief_reach_of_best <= choice(forward_first(5), 0, forward_left_relief_reach_of_best_choices(3));
      forward_left_relief_fours(0) <= choice((forward_left_relief_pairs_0_choice - forward_left_relief_pairs(1)) < 0,
        forward_left_relief_pairs(1), forward_left_relief_pairs_0_choice);
      forward_left_relief_older <= choice((forward_left_smallest_choice - forward_left_relief_older_choice) < 0,
        forward_left_relief_older_choice, forward_left_smallest_choice);
      forward_left_relief_recent <= choice((forward_left_relief_recent_choice - forward_left_relief_older) < 0,
        forward_left_relief_older, forward_left_relief_recent_choice);
      for i in 0 to 31 loop
        forward_above_tree_smallest(i) <= smaller(forward_above_total(2 * i + 1), forward_above_total(2 * i));
      end loop;
      for i in 0 to 15 loop
        forward_above_tree_next_smallest(i) <= smaller(forward_above_tree_smallest(2 * i + 1),
          forward_above_tree_smallest(2 * i));
      end loop;
      for i in 0 to 7 loop
        forward_above_tree_next_next_smallest(i) <= smaller(forward_above_tree_next_smallest(2 * i + 1),
          forward_above_tree_next_smallest(2 * i));
      end loop;
      for i in 0 to 3 loop
        forward_above_tree_next_next_next_smallest(i) <= smaller(forward_above_tree_next_next_smallest(2 * i + 1),
          forward_above_tree_next_next_smallest(2 * i));
      end loop;
      forward_above_tree_next_next_next_next_smallest(0) <= smaller(forward_above_tree_next_next_next_smallest(1),
        forward_above_tree_next_next_next_smallest(0));
      forward_above_tree_next_next_next_next_smallest(1) <= smaller(forward_above_tree_next_next_next_smallest(3),
        forward_above_tree_next_next_next_smallest(2));
      forward_above_tree_next_next_next_next_next_smallest_0 <=
        smaller(forward_above_tree_next_next_next_next_smallest(1), forward_above_tree_next_next_next_next_smallest(0));
      forward_above_delay_ring_read_address <= choice(forward_above_delay_ring_read_address = 6, 0,
        (forward_above_delay_ring_read_address + 1) mod 8);
      for i in 1 to 62 loop
        forward_above_beside(i) <= smaller(forward_above_cost(i + 1), forward_above_cost(i - 1));
      end loop;
      forward_above_stay(0) <= choice(forward_above_own_0 < 31, forward_above_own_0 mod 32, 31);
      forward_above_stay(1) <= choice(forward_above_beside(0) < 31, forward_above_beside(0) mod 32, 31);
      for i in 2 to 61 loop
        forward_above_stay(i) <= choice(forward_above_own(i) < 31, forward_above_own(i) mod 32, 31);
      end loop;
      forward_above_stay(62) <= choice(forward_above_beside(63) < 31, forward_above_beside(63) mod 32, 31);
      forward_above_stay(63) <= choice(forward_above_own_63 < 31, forward_above_own_63 mod 32, 31);
    end if;
    forward_above_writes_copy_0 <= choice(forward_above_comes(11), entry_next_tag.valid and (forward_above_comes(10) or
      (not entry_tag.valid)), entry_next_tag.valid and forward_above_comes(10) and entry_tag.valid);
    for i in 0 to 9 loop
      forward_above_write_words_choice(i, 1) := smaller(forward_above_step(6 * i + 4), forward_above_stay(6 * i + 4));
      forward_above_write_words_choice(i, 2) := smaller(forward_above_step(6 * i + 5), forward_above_stay(6 * i + 5));
      forward_above_write_words_choice(i, 3) := smaller(forward_above_step(6 * i + 3), forward_above_stay(6 * i + 3));
      forward_above_write_words_choice(i, 4) := smaller(forward_above_step(6 * i + 2), forward_above_stay(6 * i + 2));
      forward_above_write_words_choice(i, 5) := smaller(forward_above_step(6 * i), forward_above_stay(6 * i));
      forward_above_write_words_choice(i, 6) := smaller(forward_above_step(6 * i + 1), forward_above_stay(6 * i + 1));
    end loop;
    for i in 0 to 1 loop
      forward_above_write_words_choice(10, 2 * i + 1) := smaller(forward_above_step(62 - 2 * i), forward_above_stay(62
        - 2 * i));
      forward_above_write_words_choice(10, 2 * i + 2) := smaller(forward_above_step(63 - 2 * i), forward_above_stay(63
        - 2 * i));
    end loop;
    if forward_above_writes_copy_0 then
      for i in 0 to 9 loop
        forward_above_write_words(i) <= ((((((((((to_unsigned(forward_above_write_words_choice(i, 1), 12) &
          to_unsigned(0, 20)) or (to_unsigned(forward_above_write_words_choice(i, 2), 7) & to_unsigned(0, 25)))) or
          (to_unsigned(forward_above_write_words_choice(i, 3), 17) & to_unsigned(0, 15)))) or
          (to_unsigned(forward_above_write_words_choice(i, 4), 22) & to_unsigned(0, 10)))) or
          (to_unsigned(forward_above_write_words_choice(i, 5), 32)))) or
          (to_unsigned(forward_above_write_words_choice(i, 6), 27) & to_unsigned(0, 5)));
      end loop;
      forward_above_write_words_10 <= to_integer(((((((to_unsigned(forward_above_write_words_choice(10, 1), 12) &
        to_unsigned(0, 10)) or (to_unsigned(forward_above_write_words_choice(10, 2), 7) & to_unsigned(0, 15)))) or
        (to_unsigned(forward_above_write_words_choice(10, 3), 22)))) or
        (to_unsigned(forward_above_write_words_choice(10, 4), 17) & to_unsigned(0, 5))));
      forward_above_write_column <= forward_above_column(11);
    end if;
    -- sums
    for i in 0 to 15 loop
      sums_right_pair_choice(2 * i) := smaller(sums_right_cost(4 * i + 2), sums_right_cost(4 * i));
      sums_right_pair_choice(2 * i + 1) := smaller(sums_right_cost(4 * i + 3), sums_right_cost(4 * i + 1));
    end loop;
    sums_right_start_cost_0_any := ((((sums_right_tree_next_next_next_next_smallest_0 mod 64) +
      sums_right_relief_beyond) / 64) = 1) or is_set(sums_right_tree_next_next_next_next_smallest_0, 6);
    sums_right_start_cost_0_values(1) := is_set(sums_right_room, 2);
    sums_right_start_cost_0_values(2) := is_set(sums_right_room, 3);
    sums_right_start_cost_0_values(3) := is_set(sums_right_room, 4);
    sums_right_start_cost_0_choice_6 := is_larger(sums_right_relief_largest, sums_right_room, 0, 5, false);
    sums_right_start_cost_0_choice(7) := choice(sums_right_start_cost_0_choice_6, 0, (sums_right_room -
      sums_right_relief_largest) mod 64);
    sums_right_start_cost_0_is_less := 127 < ((sums_right_tree_next_next_next_next_smallest_0 mod 64) +
      sums_right_relief_reach_of_best);
    sums_right_start_cost_0_choice(8) := choice(sums_right_start_cost_0_is_less,
      (sums_right_tree_next_next_next_next_smallest_0 + sums_right_relief_reach_of_best) mod 64, 0);
    sums_right_start_cost_0_choice(9) := choice(sums_right_start_cost_0_any, sums_right_start_cost_0_choice(7),
      sums_right_start_cost_0_choice(8));
    sums_right_room_value := (sums_right_start_cost(8) + sums_right_room) mod 64;
    sums_right_room_choices(1) := choice(sums_right_start_cost_0_choice_6, sums_right_room_value,
      (sums_right_start_cost(8) + sums_right_relief_largest) mod 64);
    sums_right_room_choices(2) := choice(sums_right_start_cost_0_is_less, (sums_right_relief_room_of_best -
      sums_right_tree_next_next_next_next_smallest_0) mod 64, sums_right_room_value);
    sums_right_room_choices(3) := choice(sums_right_start_cost_0_any, sums_right_room_choices(1),
      sums_right_room_choices(2));
    sums_right_smallest_choice := choice(forward_first(0), 0, sums_right_relief_next_0);
    sums_right_smallest_difference := sums_right_smallest_choice - (sums_turn_ready_smallest_0 / 8);
    sums_right_relief_pairs_0_choice := choice((sums_right_smallest_choice - sums_right_relief_past(0)) < 0,
      sums_right_relief_past(0), sums_right_smallest_choice);
    sums_right_relief_older_choice := choice((sums_right_relief_fours(0) - sums_right_relief_fours(2)) < 0,
      sums_right_relief_fours(2), sums_right_relief_fours(0));
    sums_right_relief_recent_choice := choice(((sums_turn_ready_smallest_0 / 8) - sums_right_smallest_choice) < 0,
      sums_right_smallest_choice, sums_turn_ready_smallest_0 / 8);
    sums_right_relief_largest_choice := choice(((sums_turn_ready_smallest_0 / 8) - sums_right_relief_recent) < 0,
      sums_right_relief_recent, sums_turn_ready_smallest_0 / 8);
    sums_right_relief_reach_of_best_sum := sums_right_room + sums_right_relief_leaves;
    sums_right_relief_reach_of_best_choice := choice(sums_right_start_cost_0_choice_6,
      sums_right_relief_reach_of_best_sum, sums_right_relief_largest + sums_right_relief_leaves);
    sums_right_relief_reach_of_best_choices(2) := choice(sums_right_start_cost_0_is_less,
      (sums_right_relief_reach_again - (sums_right_tree_next_next_next_next_smallest_0 mod 64)) mod 256,
      sums_right_relief_reach_of_best_sum);
    sums_right_relief_reach_of_best_choices(3) := choice(sums_right_start_cost_0_any,
      sums_right_relief_reach_of_best_choice, sums_right_relief_reach_of_best_choices(2));
    sums_right_relief_leaves_choice := choice(forward_first(0), 64, sums_right_start_cost(7) + 64);
    sums_right_g_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest) mod 128;
    sums_right_g_less_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest_less) mod 128;
    for i in 0 to 63 loop
      sums_right_cost_choice(i, 1) := smaller(sums_right_arrived(i), sums_right_cost(i));
      sums_right_cost_choice(i, 2) := choice(is_set(sums_right_cost_choice(i, 1), 6) or sums_right_first(2), 64,
        sums_right_cost_choice(i, 1));
    end loop;
    sums_right_arrived_choice(0, 1) := choice(sums_right_first(2), 64, sums_right_cost(1));
    for i in 0 to 14 loop
      sums_right_arrived_choice(4 * i + 1, 1) := choice(sums_right_first(2), 64, sums_right_pair_choice(2 * i));
      sums_right_arrived_choice(4 * i + 2, 1) := choice(sums_right_first(2), 64, sums_right_pair_choice(2 * i + 1));
      sums_right_arrived_choice(4 * i + 3, 1) := smaller(sums_right_cost(4 * i + 4), sums_right_cost(4 * i + 2));
      sums_right_arrived_choice(4 * i + 3, 2) := choice(sums_right_first(2), 64, sums_right_arrived_choice(4 * i + 3,
        1));
      sums_right_arrived_choice(4 * i + 4, 1) := smaller(sums_right_cost(4 * i + 5), sums_right_cost(4 * i + 3));
      sums_right_arrived_choice(4 * i + 4, 2) := choice(sums_right_first(2), 64, sums_right_arrived_choice(4 * i + 4,
        1));
    end loop;
    sums_right_arrived_choice(61, 1) := choice(sums_right_first(2), 64, sums_right_pair_choice(30));
    sums_right_arrived_choice(62, 1) := choice(sums_right_first(2), 64, sums_right_pair_choice(31));
    sums_right_arrived_choice(63, 1) := choice(sums_right_first(2), 64, sums_right_cost(62));
    if entry_tag.valid then
      sums_turn_ready_sums <= sums_turn_read_sums;
      for i in 0 to 5 loop sums_turn_ready_costs(i) <= to_integer(sums_turn_read_costs(i)); end loop;
      sums_turn_ready_costs_6 <= to_integer(sums_turn_read_costs_6);
      sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
      sums_turn_ready_first <= entry_tag.first_column;
      sums_turn_place(0) <= entry_place;
      sums_turn_place(1 to 10) <= sums_turn_place(0 to 9);
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
      for i in 0 to 63 loop sums_cost(1, i) <= sums_cost(0, i); end loop;
      sums_right_pair <= sums_right_pair_choice;
      sums_right_smallest <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8)) mod 128;
      sums_right_smallest_less <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8) + 121) mod 128;
      sums_right_first(0) <= forward_first(0);
      sums_right_first(1 to 2) <= sums_right_first(0 to 1);
      sums_right_relief_next_0 <= sums_turn_ready_smallest_0 / 8;
      sums_right_relief_past(0) <= sums_right_smallest_choice;
      sums_right_relief_past(1 to 7) <= sums_right_relief_past(0 to 6);
      sums_right_relief_pairs(0) <= sums_right_relief_pairs_0_choice;
      sums_right_relief_pairs(1) <= sums_right_relief_pairs(0);
      sums_right_relief_fours(1 to 2) <= sums_right_relief_fours(0 to 1);
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
      for i in 0 to 3 loop
        for j in 0 to 15 loop
          sums_right_stay_change(16 * i + j) <= (sums_cost(1, 16 * i + j) - sums_right_g_copy(i)) mod 128;
        end loop;
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 15 loop
          sums_right_step_change(16 * i + j) <= (sums_cost(1, 16 * i + j) - sums_right_g_less_copy(i)) mod 128;
        end loop;
      end loop;
      for i in 0 to 63 loop
        sums_right_cost(i) <= (sums_right_cost_choice(i, 2) + sums_right_stay_change(i)) mod 128;
      end loop;
      sums_right_arrived(0) <= (sums_right_arrived_choice(0, 1) + sums_right_step_change(0)) mod 128;
      for i in 0 to 14 loop
        sums_right_arrived(4 * i + 1) <= (sums_right_arrived_choice(4 * i + 1, 1) + sums_right_step_change(4 * i + 1))
          mod 128;
        sums_right_arrived(4 * i + 2) <= (sums_right_arrived_choice(4 * i + 2, 1) + sums_right_step_change(4 * i + 2))
          mod 128;
        sums_right_arrived(4 * i + 3) <= (sums_right_arrived_choice(4 * i + 3, 2) + sums_right_step_change(4 * i + 3))
          mod 128;
        sums_right_arrived(4 * i + 4) <= (sums_right_arrived_choice(4 * i + 4, 2) + sums_right_step_change(4 * i + 4))
          mod 128;
      end loop;
      for i in 61 to 63 loop
        sums_right_arrived(i) <= (sums_right_arrived_choice(i, 1) + sums_right_step_change(i)) mod 128;
      end loop;
      sums_sum_delay_ring_write_address <= sums_sum_delay_ring_read_address;
      sums_tags_held_output_column(0) <= entry_turned_output_column;
      sums_tags_held_start_of_frame(0) <= entry_turned_start_of_frame;
      sums_tags_held_end_of_line(0) <= entry_tag.end_of_line;
      for i in 1 to 4 loop
        sums_tags_held_output_column(i) <= sums_tags_held_output_column(i - 1);
        sums_tags_held_start_of_frame(i) <= sums_tags_held_start_of_frame(i - 1);
        sums_tags_held_end_of_line(i) <= sums_tags_held_end_of_line(i - 1);
      end loop;
      for i in 0 to 15 loop
        sums_right_tree_smallest(i) <= smaller(sums_right_pair(2 * i + 1), sums_right_pair(2 * i));
      end loop;
      for i in 0 to 7 loop
        sums_right_tree_next_smallest(i) <= smaller(sums_right_tree_smallest(2 * i + 1), sums_right_tree_smallest(2 *
          i));
      end loop;
      for i in 0 to 3 loop
        sums_right_tree_next_next_smallest(i) <= smaller(sums_right_tree_next_smallest(2 * i + 1),
          sums_right_tree_next_smallest(2 * i));
      end loop;
      sums_right_tree_next_next_next_smallest(0) <= smaller(sums_right_tree_next_next_smallest(1),
        sums_right_tree_next_next_smallest(0));
      sums_right_tree_next_next_next_smallest(1) <= smaller(sums_right_tree_next_next_smallest(3),
        sums_right_tree_next_next_smallest(2));
      sums_right_tree_next_next_next_next_smallest_0 <= smaller(sums_right_tree_next_next_next_smallest(1),
        sums_right_tree_next_next_next_smallest(0));
      sums_right_start_cost(0) <= choice(forward_first(0), 60, sums_right_start_cost_0_choice(9));
      for i in 1 to 8 loop
        sums_right_start_cost(i) <= choice(forward_first(0), 0, sums_right_start_cost(i - 1));
      end loop;
      sums_right_room <= choice(forward_first(0), 0, sums_right_room_choices(3));
      sums_right_relief_reach_of_best <= choice(forward_first(0), 0, sums_right_relief_reach_of_best_choices(3));
      sums_right_relief_fours(0) <= choice((sums_right_relief_pairs_0_choice - sums_right_relief_pairs(1)) < 0,
        sums_right_relief_pairs(1), sums_right_relief_pairs_0_choice);
      sums_right_relief_older <= choice((sums_right_smallest_choice - sums_right_relief_older_choice) < 0,
        sums_right_relief_older_choice, sums_right_smallest_choice);
      sums_right_relief_recent <= choice((sums_right_relief_recent_choice - sums_right_relief_older) < 0,
        sums_right_relief_older, sums_right_relief_recent_choice);
      sums_sum_delay_ring_read_address <= choice(sums_sum_delay_ring_read_address = 3, 0,
        (sums_sum_delay_ring_read_address + 1) mod 4);
    end if;
    sums_turn_writes_copy_0_choice := choice(entry_tag.valid, forward_above_comes(9), forward_above_comes(10));
    sums_turn_writes_copy_0 <= entry_next_tag.valid and sums_turn_writes_copy_0_choice;
    for i in 0 to 15 loop
      sums_sum_0(4 * i) <= (sums_right_cost(4 * i) + to_integer(sums_sum_delay_held(i)(7 downto 0))) mod 256;
      sums_sum_0(4 * i + 1) <= (sums_right_cost(4 * i + 1) + to_integer(sums_sum_delay_held(i)(31 downto 8))) mod 256;
      sums_sum_0(4 * i + 2) <= (sums_right_cost(4 * i + 2) + to_integer(sums_sum_delay_held(i)(31 downto 16))) mod 256;
      sums_sum_0(4 * i + 3) <= (sums_right_cost(4 * i + 3) + to_integer(sums_sum_delay_held(i)(31 downto 24))) mod 256;
    end loop;
    sums_tag.valid <= sums_tags_moved;
    sums_tag.map_column <= forward_above_comes(4);
    sums_tag.output_column <= sums_tags_held_output_column(4);
    sums_tag.start_of_frame <= sums_tags_held_start_of_frame(4);
    sums_tag.end_of_line <= sums_tags_held_end_of_line(4);
    sums_tags_moved <= entry_tag.valid;
    if sums_turn_writes_copy_0 then
      for i in 0 to 15 loop sums_turn_write_sums(i) <= other(15 - i); end loop;
      for i in 0 to 5 loop
        sums_turn_write_costs(i) <= (forward_cost(3, 10 * i + 8) * 16777216) + (forward_cost(3, 10 * i + 9) *
          134217728) + (forward_cost(3, 10 * i + 7) * 2097152) + (forward_cost(3, 10 * i + 6) * 262144) +
          (forward_cost(3, 10 * i + 5) * 32768) + (forward_cost(3, 10 * i + 4) * 4096) + (forward_cost(3, 10 * i + 3) *
          512) + (forward_cost(3, 10 * i + 2) * 64) + forward_cost(3, 10 * i) + (forward_cost(3, 10 * i + 1) * 8);
      end loop;
      sums_turn_write_costs_6 <= (forward_cost(3, 62) * 64) + (forward_cost(3, 63) * 512) + forward_cost(3, 60) +
        (forward_cost(3, 61) * 8);
      sums_turn_write_smallest_0 <= to_integer(((to_unsigned(forward_reliefs_moved(10), 6) & to_unsigned(0, 3)) or
        (to_unsigned(forward_smallest_cost(4), 9))));
      sums_turn_write_place <= sums_turn_place(10);
    end if;
    -- winnerswinner1
    for i in 0 to 31 loop
      for j in 1 to 5 loop winnerswinner1_of_pair_0_value(i, j) := is_set(sums_sum_0(2 * i + 1), j + 1); end loop;
      winnerswinner1_of_pair_0_choice_8(i) := is_larger(sums_sum_0(2 * i), sums_sum_0(2 * i + 1), 0, 7, false);
    end loop;
    for i in 0 to 15 loop
      winnerswinner1_of_four_0_choice(i, 1) := choice(is_set(winnerswinner1_of_pair_0(4 * i + 1), 0), (not
        is_set(winnerswinner1_of_pair_0(4 * i + 3), 0)) and (not is_set(winnerswinner1_of_pair_0(4 * i + 2), 0)),
        is_set(winnerswinner1_of_pair_0(4 * i), 0) and (not is_set(winnerswinner1_of_pair_0(4 * i + 3), 0)) and (not
        is_set(winnerswinner1_of_pair_0(4 * i + 2), 0)));
      winnerswinner1_of_four_0_value(i, 1) := is_set(winnerswinner1_of_pair_0(4 * i + 1), 1);
      winnerswinner1_of_four_0_value(i, 2) := is_set(winnerswinner1_of_pair_0(4 * i), 1);
      winnerswinner1_of_four_0_choice(i, 2) := choice((not is_set(winnerswinner1_of_pair_0(4 * i + 3), 1)) and (not
        is_set(winnerswinner1_of_pair_0(4 * i + 2), 1)), winnerswinner1_of_four_0_choice(i, 1) or
        winnerswinner1_of_four_0_value(i, 1) or winnerswinner1_of_four_0_value(i, 2),
        winnerswinner1_of_four_0_choice(i, 1) and (winnerswinner1_of_four_0_value(i, 1) or
        winnerswinner1_of_four_0_value(i, 2)));
      winnerswinner1_of_four_0_value(i, 3) := is_set(winnerswinner1_of_pair_0(4 * i + 3), 2);
      winnerswinner1_of_four_0_value(i, 4) := is_set(winnerswinner1_of_pair_0(4 * i + 2), 2);
      winnerswinner1_of_four_0_choice(i, 3) := choice(winnerswinner1_of_four_0_choice(i, 2), (not
        is_set(winnerswinner1_of_pair_0(4 * i + 1), 2)) and (not is_set(winnerswinner1_of_pair_0(4 * i), 2)) and
        (winnerswinner1_of_four_0_value(i, 3) or winnerswinner1_of_four_0_value(i, 4)), ((not
        is_set(winnerswinner1_of_pair_0(4 * i + 1), 2)) and (not is_set(winnerswinner1_of_pair_0(4 * i), 2))) or
        winnerswinner1_of_four_0_value(i, 3) or winnerswinner1_of_four_0_value(i, 4));
      for j in 3 to 6 loop
        winnerswinner1_of_four_0_value(i, 2 * j - 1) := is_set(winnerswinner1_of_pair_0(4 * i + 3), j);
        winnerswinner1_of_four_0_value(i, 2 * j) := is_set(winnerswinner1_of_pair_0(4 * i + 2), j);
        winnerswinner1_of_four_0_choice(i, j + 1) := choice(winnerswinner1_of_four_0_choice(i, j), ((not
          is_set(winnerswinner1_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner1_of_pair_0(4 * i), j))) or
          winnerswinner1_of_four_0_value(i, 2 * j - 1) or winnerswinner1_of_four_0_value(i, 2 * j), (not
          is_set(winnerswinner1_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner1_of_pair_0(4 * i), j)) and
          (winnerswinner1_of_four_0_value(i, 2 * j - 1) or winnerswinner1_of_four_0_value(i, 2 * j)));
      end loop;
      winnerswinner1_of_four_0_choice(i, 8) := choice(winnerswinner1_of_four_0_choice(i, 7), (not ((not
        is_set(winnerswinner1_of_pair_0(4 * i + 1), 7)) and (not is_set(winnerswinner1_of_pair_0(4 * i), 7)))) and (not
        is_set(winnerswinner1_of_pair_0(4 * i + 3), 7)) and (not is_set(winnerswinner1_of_pair_0(4 * i + 2), 7)), (not
        ((not is_set(winnerswinner1_of_pair_0(4 * i + 1), 7)) and (not is_set(winnerswinner1_of_pair_0(4 * i), 7)))) or
        ((not is_set(winnerswinner1_of_pair_0(4 * i + 3), 7)) and (not is_set(winnerswinner1_of_pair_0(4 * i + 2),
        7))));
    end loop;
    winnerswinner1_pair_index_0_0 <= winnerswinner1_of_pair_0_choice_8(0);
    winnerswinner1_pair_tag <= sums_tag;
    winnerswinner1_four_tag <= winnerswinner1_pair_tag;
    for i in 0 to 15 loop
      winnerswinner1_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0(4 * i + 2), 8)) or
        (to_unsigned(winnerswinner1_of_four_0(4 * i + 3), 8)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i + 1),
        8)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i), 8))));
    end loop;
    winnerswinner1_best_index_0 <= winnerswinner1_four_index_0;
    winnerswinner1_tag <= winnerswinner1_four_tag;
    winnerswinner1_of_pair_0(0) <= choice(winnerswinner1_of_pair_0_choice_8(0), 0, sums_sum_0(0));
    winnerswinner1_of_pair_0(1) <= choice(winnerswinner1_of_pair_0_choice_8(0), sums_sum_0(1), 0);
    for i in 1 to 31 loop
      winnerswinner1_of_pair_0(2 * i) <= choice(winnerswinner1_of_pair_0_choice_8(i), 0, sums_sum_0(2 * i));
      winnerswinner1_of_pair_0(2 * i + 1) <= choice(winnerswinner1_of_pair_0_choice_8(i), sums_sum_0(2 * i + 1), 0);
      winnerswinner1_pair_index_0(i) <= choice(winnerswinner1_of_pair_0_choice_8(i), 2 * i + 1, 2 * i);
    end loop;
    winnerswinner1_of_four_0(0) <= choice(winnerswinner1_of_four_0_choice(0, 8), 0, winnerswinner1_of_pair_0(0));
    winnerswinner1_of_four_0(1) <= choice(winnerswinner1_of_four_0_choice(0, 8), 0, winnerswinner1_of_pair_0(1));
    winnerswinner1_of_four_0(2) <= choice(winnerswinner1_of_four_0_choice(0, 8), winnerswinner1_of_pair_0(2), 0);
    winnerswinner1_of_four_0(3) <= choice(winnerswinner1_of_four_0_choice(0, 8), winnerswinner1_of_pair_0(3), 0);
    winnerswinner1_four_index_0(0) <= choice(winnerswinner1_of_four_0_choice(0, 8), winnerswinner1_pair_index_0(1),
      as_number(winnerswinner1_pair_index_0_0));
    for i in 1 to 15 loop
      winnerswinner1_of_four_0(4 * i) <= choice(winnerswinner1_of_four_0_choice(i, 8), 0, winnerswinner1_of_pair_0(4 *
        i));
      winnerswinner1_of_four_0(4 * i + 1) <= choice(winnerswinner1_of_four_0_choice(i, 8), 0,
        winnerswinner1_of_pair_0(4 * i + 1));
      winnerswinner1_of_four_0(4 * i + 2) <= choice(winnerswinner1_of_four_0_choice(i, 8), winnerswinner1_of_pair_0(4 *
        i + 2), 0);
      winnerswinner1_of_four_0(4 * i + 3) <= choice(winnerswinner1_of_four_0_choice(i, 8), winnerswinner1_of_pair_0(4 *
        i + 3), 0);
      winnerswinner1_four_index_0(i) <= choice(winnerswinner1_of_four_0_choice(i, 8), winnerswinner1_pair_index_0(2 * i
        + 1), winnerswinner1_pair_index_0(2 * i));
    end loop;
    -- winnerswinner2
    for i in 0 to 7 loop
      for j in 1 to 5 loop
        winnerswinner2_of_pair_0_value(i, j) := is_set(winnerswinner1_best_cost_0(2 * i + 1), j + 1);
      end loop;
      winnerswinner2_of_pair_0_choice_8(i) := is_larger(winnerswinner1_best_cost_0(2 * i), winnerswinner1_best_cost_0(2
        * i + 1), 0, 7, false);
    end loop;
    for i in 0 to 3 loop
      winnerswinner2_of_four_0_choice(i, 1) := choice(is_set(winnerswinner2_of_pair_0(4 * i + 1), 0), (not
        is_set(winnerswinner2_of_pair_0(4 * i + 3), 0)) and (not is_set(winnerswinner2_of_pair_0(4 * i + 2), 0)),
        is_set(winnerswinner2_of_pair_0(4 * i), 0) and (not is_set(winnerswinner2_of_pair_0(4 * i + 3), 0)) and (not
        is_set(winnerswinner2_of_pair_0(4 * i + 2), 0)));
      winnerswinner2_of_four_0_value(i, 1) := is_set(winnerswinner2_of_pair_0(4 * i + 1), 1);
      winnerswinner2_of_four_0_value(i, 2) := is_set(winnerswinner2_of_pair_0(4 * i), 1);
      winnerswinner2_of_four_0_choice(i, 2) := choice((not is_set(winnerswinner2_of_pair_0(4 * i + 3), 1)) and (not
        is_set(winnerswinner2_of_pair_0(4 * i + 2), 1)), winnerswinner2_of_four_0_choice(i, 1) or
        winnerswinner2_of_four_0_value(i, 1) or winnerswinner2_of_four_0_value(i, 2),
        winnerswinner2_of_four_0_choice(i, 1) and (winnerswinner2_of_four_0_value(i, 1) or
        winnerswinner2_of_four_0_value(i, 2)));
      winnerswinner2_of_four_0_value(i, 3) := is_set(winnerswinner2_of_pair_0(4 * i + 3), 2);
      winnerswinner2_of_four_0_value(i, 4) := is_set(winnerswinner2_of_pair_0(4 * i + 2), 2);
      winnerswinner2_of_four_0_choice(i, 3) := choice(winnerswinner2_of_four_0_choice(i, 2), (not
        is_set(winnerswinner2_of_pair_0(4 * i + 1), 2)) and (not is_set(winnerswinner2_of_pair_0(4 * i), 2)) and
        (winnerswinner2_of_four_0_value(i, 3) or winnerswinner2_of_four_0_value(i, 4)), ((not
        is_set(winnerswinner2_of_pair_0(4 * i + 1), 2)) and (not is_set(winnerswinner2_of_pair_0(4 * i), 2))) or
        winnerswinner2_of_four_0_value(i, 3) or winnerswinner2_of_four_0_value(i, 4));
      for j in 3 to 6 loop
        winnerswinner2_of_four_0_value(i, 2 * j - 1) := is_set(winnerswinner2_of_pair_0(4 * i + 3), j);
        winnerswinner2_of_four_0_value(i, 2 * j) := is_set(winnerswinner2_of_pair_0(4 * i + 2), j);
        winnerswinner2_of_four_0_choice(i, j + 1) := choice(winnerswinner2_of_four_0_choice(i, j), ((not
          is_set(winnerswinner2_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner2_of_pair_0(4 * i), j))) or
          winnerswinner2_of_four_0_value(i, 2 * j - 1) or winnerswinner2_of_four_0_value(i, 2 * j), (not
          is_set(winnerswinner2_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner2_of_pair_0(4 * i), j)) and
          (winnerswinner2_of_four_0_value(i, 2 * j - 1) or winnerswinner2_of_four_0_value(i, 2 * j)));
      end loop;
      winnerswinner2_of_four_0_choice(i, 8) := choice(winnerswinner2_of_four_0_choice(i, 7), (not ((not
        is_set(winnerswinner2_of_pair_0(4 * i + 1), 7)) and (not is_set(winnerswinner2_of_pair_0(4 * i), 7)))) and (not
        is_set(winnerswinner2_of_pair_0(4 * i + 3), 7)) and (not is_set(winnerswinner2_of_pair_0(4 * i + 2), 7)), (not
        ((not is_set(winnerswinner2_of_pair_0(4 * i + 1), 7)) and (not is_set(winnerswinner2_of_pair_0(4 * i), 7)))) or
        ((not is_set(winnerswinner2_of_pair_0(4 * i + 3), 7)) and (not is_set(winnerswinner2_of_pair_0(4 * i + 2),
        7))));
    end loop;
    winnerswinner2_pair_tag <= winnerswinner1_tag;
    winnerswinner2_four_tag <= winnerswinner2_pair_tag;
    for i in 0 to 3 loop
      winnerswinner2_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner2_of_four_0(4 * i + 2), 8)) or
        (to_unsigned(winnerswinner2_of_four_0(4 * i + 3), 8)))) or (to_unsigned(winnerswinner2_of_four_0(4 * i + 1),
        8)))) or (to_unsigned(winnerswinner2_of_four_0(4 * i), 8))));
    end loop;
    winnerswinner2_best_index_0 <= winnerswinner2_four_index_0;
    winnerswinner2_tag <= winnerswinner2_four_tag;
    for i in 0 to 7 loop
      winnerswinner2_of_pair_0(2 * i) <= choice(winnerswinner2_of_pair_0_choice_8(i), 0, winnerswinner1_best_cost_0(2 *
        i));
      winnerswinner2_of_pair_0(2 * i + 1) <= choice(winnerswinner2_of_pair_0_choice_8(i), winnerswinner1_best_cost_0(2
        * i + 1), 0);
      winnerswinner2_pair_index_0(i) <= choice(winnerswinner2_of_pair_0_choice_8(i), winnerswinner1_best_index_0(2 * i
        + 1), winnerswinner1_best_index_0(2 * i));
    end loop;
    for i in 0 to 3 loop
      winnerswinner2_of_four_0(4 * i) <= choice(winnerswinner2_of_four_0_choice(i, 8), 0, winnerswinner2_of_pair_0(4 *
        i));
      winnerswinner2_of_four_0(4 * i + 1) <= choice(winnerswinner2_of_four_0_choice(i, 8), 0,
        winnerswinner2_of_pair_0(4 * i + 1));
      winnerswinner2_of_four_0(4 * i + 2) <= choice(winnerswinner2_of_four_0_choice(i, 8), winnerswinner2_of_pair_0(4 *
        i + 2), 0);
      winnerswinner2_of_four_0(4 * i + 3) <= choice(winnerswinner2_of_four_0_choice(i, 8), winnerswinner2_of_pair_0(4 *
        i + 3), 0);
      winnerswinner2_four_index_0(i) <= choice(winnerswinner2_of_four_0_choice(i, 8), winnerswinner2_pair_index_0(2 * i
        + 1), winnerswinner2_pair_index_0(2 * i));
    end loop;
    -- winnerswinner3
    for i in 0 to 1 loop
      for j in 1 to 5 loop
        winnerswinner3_of_pair_0_value(2 * i, j) := is_set(winnerswinner2_best_cost_0(2 * i + 1), j + 1);
      end loop;
      winnerswinner3_of_pair_0_choice_8(2 * i) := is_larger(winnerswinner2_best_cost_0(2 * i),
        winnerswinner2_best_cost_0(2 * i + 1), 0, 7, false);
    end loop;
    winnerswinner3_four_index_0_0_choices(1) := choice(is_set(winnerswinner3_of_pair_0(1), 0), (not
      is_set(winnerswinner3_of_pair_0(3), 0)) and (not is_set(winnerswinner3_of_pair_0(2), 0)),
      is_set(winnerswinner3_of_pair_0(0), 0) and (not is_set(winnerswinner3_of_pair_0(3), 0)) and (not
      is_set(winnerswinner3_of_pair_0(2), 0)));
    winnerswinner3_four_index_0_0_values(1) := is_set(winnerswinner3_of_pair_0(1), 1);
    winnerswinner3_four_index_0_0_values(2) := is_set(winnerswinner3_of_pair_0(0), 1);
    winnerswinner3_four_index_0_0_choices(2) := choice((not is_set(winnerswinner3_of_pair_0(3), 1)) and (not
      is_set(winnerswinner3_of_pair_0(2), 1)), winnerswinner3_four_index_0_0_choices(1) or
      winnerswinner3_four_index_0_0_values(1) or winnerswinner3_four_index_0_0_values(2),
      winnerswinner3_four_index_0_0_choices(1) and (winnerswinner3_four_index_0_0_values(1) or
      winnerswinner3_four_index_0_0_values(2)));
    winnerswinner3_four_index_0_0_values(3) := is_set(winnerswinner3_of_pair_0(3), 2);
    winnerswinner3_four_index_0_0_values(4) := is_set(winnerswinner3_of_pair_0(2), 2);
    winnerswinner3_four_index_0_0_choices(3) := choice(winnerswinner3_four_index_0_0_choices(2), (not
      is_set(winnerswinner3_of_pair_0(1), 2)) and (not is_set(winnerswinner3_of_pair_0(0), 2)) and
      (winnerswinner3_four_index_0_0_values(3) or winnerswinner3_four_index_0_0_values(4)), ((not
      is_set(winnerswinner3_of_pair_0(1), 2)) and (not is_set(winnerswinner3_of_pair_0(0), 2))) or
      winnerswinner3_four_index_0_0_values(3) or winnerswinner3_four_index_0_0_values(4));
    for i in 3 to 6 loop
      winnerswinner3_four_index_0_0_values(2 * i - 1) := is_set(winnerswinner3_of_pair_0(3), i);
      winnerswinner3_four_index_0_0_values(2 * i) := is_set(winnerswinner3_of_pair_0(2), i);
      winnerswinner3_four_index_0_0_choices(i + 1) := choice(winnerswinner3_four_index_0_0_choices(i), ((not
        is_set(winnerswinner3_of_pair_0(1), i)) and (not is_set(winnerswinner3_of_pair_0(0), i))) or
        winnerswinner3_four_index_0_0_values(2 * i - 1) or winnerswinner3_four_index_0_0_values(2 * i), (not
        is_set(winnerswinner3_of_pair_0(1), i)) and (not is_set(winnerswinner3_of_pair_0(0), i)) and
        (winnerswinner3_four_index_0_0_values(2 * i - 1) or winnerswinner3_four_index_0_0_values(2 * i)));
    end loop;
    winnerswinner3_four_index_0_0_choices(8) := choice(winnerswinner3_four_index_0_0_choices(7), (not ((not
      is_set(winnerswinner3_of_pair_0(1), 7)) and (not is_set(winnerswinner3_of_pair_0(0), 7)))) and (not
      is_set(winnerswinner3_of_pair_0(3), 7)) and (not is_set(winnerswinner3_of_pair_0(2), 7)), (not ((not
      is_set(winnerswinner3_of_pair_0(1), 7)) and (not is_set(winnerswinner3_of_pair_0(0), 7)))) or ((not
      is_set(winnerswinner3_of_pair_0(3), 7)) and (not is_set(winnerswinner3_of_pair_0(2), 7))));
    winnerswinner3_pair_tag <= winnerswinner2_tag;
    winnerswinner3_four_tag <= winnerswinner3_pair_tag;
    winnerswinner3_best_index_0_0 <= winnerswinner3_four_index_0_0;
    winnerswinner3_tag <= winnerswinner3_four_tag;
    for i in 0 to 1 loop
      winnerswinner3_of_pair_0(2 * i) <= choice(winnerswinner3_of_pair_0_choice_8(2 * i), 0,
        winnerswinner2_best_cost_0(2 * i));
      winnerswinner3_of_pair_0(2 * i + 1) <= choice(winnerswinner3_of_pair_0_choice_8(2 * i),
        winnerswinner2_best_cost_0(2 * i + 1), 0);
      winnerswinner3_pair_index_0(i) <= choice(winnerswinner3_of_pair_0_choice_8(2 * i), winnerswinner2_best_index_0(2
        * i + 1), winnerswinner2_best_index_0(2 * i));
    end loop;
    winnerswinner3_four_index_0_0 <= choice(winnerswinner3_four_index_0_0_choices(8), winnerswinner3_pair_index_0(1),
      winnerswinner3_pair_index_0(0));
    -- winners
    winners_best_index_0_0 <= winnerswinner3_best_index_0_0;
    winners_best_tag <= winnerswinner3_tag;
    -- turn
    turn_order_address_anys(1) := turn_order_turned_map_column or (not winners_best_tag.map_column) or (not
      winners_best_tag.valid);
    turn_order_address_choice := choice(turn_order_falls, 511, 1);
    turn_order_address_choice_2 := choice(turn_order_falls, 0, 193);
    turn_order_address_anys(2) := (not winners_best_tag.map_column) or (not winners_best_tag.valid);
    if not turn_order_address_anys(2) then
      turn_order_address <= choice(turn_order_address_anys(1), (turn_order_address_choice + turn_order_address) mod
        512, turn_order_address_choice_2 * 2);
    end if;
    turn_order_falls_all := (not turn_order_turned_map_column) and winners_best_tag.map_column and
      winners_best_tag.valid;
    turn_order_complete_all := winners_best_tag.map_column and winners_best_tag.valid;
    turn_ready_tag_row_start_differs := map_counter_group /= 376;
    turn_ready_tag_row_start_is_equals(1) := map_counter_column = 386;
    turn_ready_tag_row_start_choices(1) := choice(turn_ready_tag_row_start_is_equals(1), turn_ready_tag.row_start and
      (map_counter_group /= 375), turn_ready_tag.row_start);
    turn_ready_tag_row_start_choices(2) := choice(turn_ready_tag_row_start_differs,
      turn_ready_tag_row_start_choices(1), turn_ready_tag.row_start);
    turn_ready_tag_row_start_is_equals(2) := map_counter_group = 374;
    turn_ready_tag_row_start_alls(1) := turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_row_start_is_equals(1);
    turn_ready_tag_row_start_choices(3) := choice(turn_ready_tag_row_start_choices(2), (not
      turn_ready_tag.start_of_frame) or turn_ready_tag_row_start_alls(1), turn_ready_tag.start_of_frame and
      turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_row_start_is_equals(1));
    turn_ready_tag_row_start_alls(2) := turn_ready_tag.valid and turn_ready_tag.map_column;
    turn_order_inside <= winners_best_tag.map_column;
    turn_order_turned_valid <= winners_best_tag.valid;
    turn_order_turned_start_of_frame <= (not turn_order_turned_map_column) and winners_best_tag.map_column and
      winners_best_tag.valid and turn_order_first and turn_order_output and turn_order_complete;
    turn_order_turned_end_of_line <= winners_best_tag.end_of_line;
    turn_newest <= winners_best_index_0_0 + 256;
    turn_comes <= turn_order_complete_all;
    turn_read_tag.valid <= turn_order_turned_valid;
    turn_read_tag.map_column <= turn_order_inside;
    turn_read_tag.start_of_frame <= turn_order_turned_start_of_frame;
    turn_read_tag.end_of_line <= turn_order_turned_end_of_line;
    turn_ready <= to_integer(turn_read_words_0);
    turn_ready_tag.valid <= turn_read_tag.valid;
    turn_ready_tag.map_column <= turn_read_tag.map_column;
    turn_ready_tag.start_of_frame <= turn_read_tag.start_of_frame;
    turn_ready_tag.end_of_line <= turn_read_tag.end_of_line;
    turn_order_falls <= choice(turn_order_falls, turn_order_address_anys(1), turn_order_falls_all);
    turn_order_complete <= choice(winners_best_tag.end_of_line, turn_order_complete or turn_order_complete_all,
      turn_order_complete and turn_order_address_anys(2));
    turn_ready_tag.row_start <= choice(turn_ready_tag_row_start_choices(3), turn_ready_tag.row_start or
      turn_ready_tag_row_start_alls(2), turn_ready_tag.row_start and ((not turn_ready_tag.valid) or (not
      turn_ready_tag.map_column)));
    if turn_order_falls_all then
      turn_order_output <= winners_best_tag.output_column;
      turn_order_first <= winners_best_tag.start_of_frame;
    end if;
    if winners_best_tag.valid then turn_order_turned_map_column <= winners_best_tag.map_column; end if;
    if turn_comes then
      turn_write_words_0 <= turn_newest;
      turn_write_place <= turn_order_address;
    end if;
    -- map
    if turn_ready_tag_row_start_alls(2) then
      map_counter_column <= choice(turn_ready_tag.start_of_frame or turn_ready_tag_row_start_is_equals(1), 0,
        (map_counter_column + 1) mod 512);
    end if;
    map_counter_group_choice := choice(turn_ready_tag_row_start_alls(1), 375, 0);
    map_counter_group_is_equal := map_counter_group = 375;
    map_counter_group_choices(2) := choice(turn_ready_tag.row_start and map_counter_group_is_equal, 1,
      (map_counter_group + 1) mod 512);
    map_counter_group_choices(3) := choice(turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equals(1)
      and turn_ready_tag.valid and turn_ready_tag.map_column, map_counter_group_choices(2), map_counter_group);
    map_line_ended_choice := choice(turn_ready_tag.valid, turn_ready_tag.map_column, map_line_ended);
    map_at_arrives_value := other_16(16) = '1';
    map_of_column_0_b_below_a_values(1) := is_set(map_column(1), 2);
    map_of_column_0_b_below_a_choices(1) := choice(map_at_top, map_of_column_0_b_below_a_values(1), is_set(other_17,
      2));
    map_of_column_0_b_below_a_values(2) := is_set(map_column(1), 1);
    map_of_column_0_b_below_a_choices(2) := choice(map_at_top, map_of_column_0_b_below_a_values(2), is_set(other_17,
      1));
    map_of_column_0_b_below_a_choices(3) := choice(map_of_column_0_b_below_a_choices(2), (not
      map_of_column_0_b_below_a_values(1)) or (not map_of_column_0_b_below_a_values(2)), not
      map_of_column_0_b_below_a_values(1));
    map_of_column_0_b_below_a_choices(4) := choice(map_of_column_0_b_below_a_choices(1),
      map_of_column_0_b_below_a_choices(3), map_of_column_0_b_below_a_choices(2) and (((map_column(1) / 2) mod 4) = 0));
    map_of_column_0_b_below_a_values(3) := is_set(map_column(1), 3);
    map_of_column_0_b_below_a_values(4) := is_set(other_17, 3);
    map_of_column_0_b_below_a_choices(5) := choice(map_of_column_0_b_below_a_choices(4),
      map_of_column_0_b_below_a_values(3) and (not map_of_column_0_b_below_a_values(4)) and (not map_at_top),
      map_of_column_0_b_below_a_values(3) or (not map_of_column_0_b_below_a_values(4)) or map_at_top);
    for i in 4 to 5 loop
      map_of_column_0_b_below_a_values(2 * i - 3) := is_set(map_column(1), i);
      map_of_column_0_b_below_a_values(2 * i - 2) := is_set(other_17, i);
      map_of_column_0_b_below_a_choices(i + 2) := choice(map_of_column_0_b_below_a_choices(i + 1),
        map_of_column_0_b_below_a_values(2 * i - 3) or (not map_of_column_0_b_below_a_values(2 * i - 2)) or map_at_top,
        map_of_column_0_b_below_a_values(2 * i - 3) and (not map_of_column_0_b_below_a_values(2 * i - 2)) and (not
        map_at_top));
    end loop;
    map_of_column_0_c_below_a_values(1) := is_set(map_column(2), 2);
    map_of_column_0_c_below_a_choices(1) := choice(map_counter_next_frame, map_of_column_0_b_below_a_values(1),
      map_of_column_0_c_below_a_values(1));
    map_of_column_0_c_below_a_values(2) := is_set(map_column(2), 1);
    map_of_column_0_c_below_a_choices(2) := choice(map_of_column_0_c_below_a_values(2), (not
      map_of_column_0_b_below_a_values(2)) and map_counter_next_frame, (not map_of_column_0_b_below_a_values(2)) or
      (not map_counter_next_frame));
    map_of_column_0_c_below_a_choices(3) := choice(map_of_column_0_c_below_a_choices(1),
      map_of_column_0_b_below_a_choices(2) and map_of_column_0_c_below_a_choices(2) and
      map_of_column_0_b_below_a_choices(1), (map_of_column_0_b_below_a_choices(2) and
      map_of_column_0_c_below_a_choices(2)) or map_of_column_0_b_below_a_choices(1));
    for i in 3 to 5 loop
      map_of_column_0_c_below_a_values(i) := is_set(map_column(2), i);
      map_of_column_0_c_below_a_choices(3 * i - 5) := choice(map_counter_next_frame, map_of_column_0_b_below_a_values(2
        * i - 3), map_of_column_0_c_below_a_values(i));
      map_of_column_0_c_below_a_choices(3 * i - 4) := choice(map_at_top, map_of_column_0_b_below_a_values(2 * i - 3),
        map_of_column_0_b_below_a_values(2 * i - 2));
      map_of_column_0_c_below_a_choices(3 * i - 3) := carry(map_of_column_0_c_below_a_choices(3 * i - 6), not
        map_of_column_0_c_below_a_choices(3 * i - 5), map_of_column_0_c_below_a_choices(3 * i - 4));
    end loop;
    map_of_column_0_c_below_a_choices(13) := choice(map_counter_next_frame, is_set(map_column(1), 6),
      is_set(map_column(2), 6));
    map_of_column_0_c_below_a_choices(14) := choice(map_at_top, is_set(map_column(1), 6), is_set(other_17, 6));
    map_of_column_0_c_below_b_choices(1) := choice((not map_of_column_0_c_below_a_values(2)) and
      map_of_column_0_b_below_a_values(2) and (not map_counter_next_frame), map_of_column_0_c_below_a_values(1) and
      (not map_of_column_0_b_below_a_values(1)) and (not map_counter_next_frame), map_of_column_0_c_below_a_values(1)
      or (not map_of_column_0_b_below_a_values(1)) or map_counter_next_frame);
    for i in 2 to 4 loop
      map_of_column_0_c_below_b_choices(i) := choice(map_of_column_0_c_below_b_choices(i - 1),
        map_of_column_0_c_below_a_values(i + 1) or (not map_of_column_0_b_below_a_values(2 * i - 1)) or
        map_counter_next_frame, map_of_column_0_c_below_a_values(i + 1) and (not map_of_column_0_b_below_a_values(2 * i
        - 1)) and (not map_counter_next_frame));
    end loop;
    map_sorted_low_0_choices(1) := choice(map_of_column_0_c_below_b, map_of_column_0_c, map_of_column_0_b);
    map_sorted_low_0_choices(2) := choice(map_of_column_0_c_below_a, map_of_column_0_c, map_of_column_0_a);
    map_sorted_middle_0_choices(1) := choice(map_of_column_0_c_below_b, map_of_column_0_b, map_sorted_low_0_choices(2));
    map_sorted_middle_0_choices(2) := choice(map_of_column_0_c_below_a, map_of_column_0_a, map_sorted_low_0_choices(1));
    map_sorted_high_0_choices(1) := choice(map_of_column_0_c_below_a, map_of_column_0_a, map_of_column_0_c);
    map_sorted_high_0_choices(2) := choice(map_of_column_0_c_below_b, map_of_column_0_b, map_of_column_0_c);
    map_window_complete_is_equal := map_sorted_column = 0;
    map_window_complete_choice := choice(map_window_complete_is_equal, map_sorted_behind, map_sorted_arrives or
      map_sorted_behind);
    map_of_low_0_b_below_a_values(1) := is_set(map_low_0(0), 1);
    map_of_low_0_b_below_a_is_equal := (map_low_0(1) mod 4) = 0;
    for i in 2 to 4 loop
      map_of_low_0_b_below_a_values(2 * i - 2) := is_set(map_low_0(0), i);
      map_of_low_0_b_below_a_values(2 * i - 1) := is_set(map_low_0(1), i);
    end loop;
    map_of_low_0_b_below_a_choice_5 := not is_larger(map_low_0(0), map_low_0(1), 0, 4, false);
    map_of_low_0_c_below_a_value := is_set(map_low_0(2), 1);
    map_of_low_0_c_below_a_choice_5 := not is_larger(map_low_0(2), map_low_0(0), 0, 4, true);
    map_of_low_0_c_below_b_choice_5 := not is_larger(map_low_0(2), map_low_0(1), 0, 4, true);
    map_of_middle_0_b_below_a_values(1) := is_set(map_middle_0(0), 1);
    map_of_middle_0_b_below_a_is_equal := (map_middle_0(1) mod 4) = 0;
    for i in 2 to 4 loop
      map_of_middle_0_b_below_a_values(2 * i - 2) := is_set(map_middle_0(0), i);
      map_of_middle_0_b_below_a_values(2 * i - 1) := is_set(map_middle_0(1), i);
    end loop;
    map_of_middle_0_b_below_a_choice_5 := not is_larger(map_middle_0(0), map_middle_0(1), 0, 4, false);
    map_of_middle_0_c_below_a_value := is_set(map_middle_0(2), 1);
    map_of_middle_0_c_below_a_choice_5 := not is_larger(map_middle_0(2), map_middle_0(0), 0, 4, true);
    map_of_middle_0_c_below_b_choice_5 := not is_larger(map_middle_0(2), map_middle_0(1), 0, 4, true);
    map_of_high_0_b_below_a_values(1) := is_set(map_high_0(0), 1);
    map_of_high_0_b_below_a_is_equal := (map_high_0(1) mod 4) = 0;
    for i in 2 to 4 loop
      map_of_high_0_b_below_a_values(2 * i - 2) := is_set(map_high_0(0), i);
      map_of_high_0_b_below_a_values(2 * i - 1) := is_set(map_high_0(1), i);
    end loop;
    map_of_high_0_b_below_a_choice_5 := not is_larger(map_high_0(0), map_high_0(1), 0, 4, false);
    map_of_high_0_c_below_a_value := is_set(map_high_0(2), 1);
    map_of_high_0_c_below_a_choice_5 := not is_larger(map_high_0(2), map_high_0(0), 0, 4, true);
    map_of_high_0_c_below_b_choice_5 := not is_larger(map_high_0(2), map_high_0(1), 0, 4, true);
    map_largest_low_0_choices(1) := choice(map_of_low_0_c_below_a, map_of_low_0_a, map_of_low_0_c);
    map_largest_low_0_choices(2) := choice(map_of_low_0_c_below_b, map_of_low_0_b, map_of_low_0_c);
    map_median_middle_0_choices(1) := choice(map_of_middle_0_c_below_a, map_of_middle_0_c, map_of_middle_0_a);
    map_median_middle_0_choices(2) := choice(map_of_middle_0_c_below_b, map_of_middle_0_b,
      map_median_middle_0_choices(1));
    map_median_middle_0_choices(3) := choice(map_of_middle_0_c_below_b, map_of_middle_0_c, map_of_middle_0_b);
    map_median_middle_0_choices(4) := choice(map_of_middle_0_c_below_a, map_of_middle_0_a,
      map_median_middle_0_choices(3));
    map_smallest_high_0_choices(1) := choice(map_of_high_0_c_below_b, map_of_high_0_c, map_of_high_0_b);
    map_smallest_high_0_choices(2) := choice(map_of_high_0_c_below_a, map_of_high_0_c, map_of_high_0_a);
    map_of_all_0_b_below_a_values(1) := is_set(map_largest_low_0, 1);
    map_of_all_0_b_below_a_is_equal := (map_median_middle_0 mod 4) = 0;
    for i in 2 to 4 loop
      map_of_all_0_b_below_a_values(2 * i - 2) := is_set(map_largest_low_0, i);
      map_of_all_0_b_below_a_values(2 * i - 1) := is_set(map_median_middle_0, i);
    end loop;
    map_of_all_0_b_below_a_choice_5 := not is_larger(map_largest_low_0, map_median_middle_0, 0, 4, false);
    map_of_all_0_c_below_a_value := is_set(map_smallest_high_0, 1);
    map_of_all_0_c_below_a_choice_5 := not is_larger(map_smallest_high_0, map_largest_low_0, 0, 4, true);
    map_of_all_0_c_below_b_choice_5 := not is_larger(map_smallest_high_0, map_median_middle_0, 0, 4, true);
    map_out_disparity_0_choices(1) := choice(map_of_all_0_c_below_a, map_of_all_0_c, map_of_all_0_a);
    map_out_disparity_0_choices(2) := choice(map_of_all_0_c_below_b, map_of_all_0_b, map_out_disparity_0_choices(1));
    map_out_disparity_0_choices(3) := choice(map_of_all_0_c_below_b, map_of_all_0_c, map_of_all_0_b);
    map_out_disparity_0_choices(4) := choice(map_of_all_0_c_below_a, map_of_all_0_a, map_out_disparity_0_choices(3));
    map_counter_next_frame <= other_16(40) = '1';
    map_newest_0 <= ((turn_ready mod 64) * 2) + (turn_ready / 256);
    map_arrives <= turn_ready_tag_row_start_alls(2);
    map_behind <= map_line_ended and turn_ready_tag.valid;
    map_rows_read_newest_0 <= map_newest_0;
    map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
    map_rows_ready_newest_0 <= map_rows_read_newest_0;
    map_write_column <= to_integer(other_16(8 downto 0));
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
    map_waiting_passed_0(1 to 2) <= map_waiting_passed_0(0 to 1);
    map_out_passed_0 <= map_waiting_passed_0(2);
    map_out_valid <= map_waiting_complete(2);
    map_out_start_of_frame <= map_waiting_first(2) and map_waiting_complete(2);
    map_out_end_of_line <= map_waiting_last(2) and map_waiting_complete(2);
    map_counter_group <= choice(turn_ready_tag.start_of_frame and turn_ready_tag.valid and turn_ready_tag.map_column,
      map_counter_group_choice, map_counter_group_choices(3));
    map_line_ended <= choice(turn_ready_tag.end_of_line, map_line_ended_choice, map_line_ended and (not
      turn_ready_tag.valid));
    map_of_column_0_a <= choice(map_at_top, map_column(1) / 2, other_17 / 2);
    map_of_column_0_c <= choice(map_counter_next_frame, map_column(1) / 2, map_column(2) / 2);
    map_of_column_0_b_below_a <= choice(map_of_column_0_b_below_a_choices(7), (not is_set(map_column(1), 6)) and
      is_set(other_17, 6) and (not map_at_top), (not is_set(map_column(1), 6)) or is_set(other_17, 6) or map_at_top);
    map_of_column_0_c_below_a <= carry(map_of_column_0_c_below_a_choices(12), not
      map_of_column_0_c_below_a_choices(13), map_of_column_0_c_below_a_choices(14));
    map_of_column_0_c_below_b <= choice(map_of_column_0_c_below_b_choices(4), (not is_set(map_column(2), 6)) and
      is_set(map_column(1), 6) and (not map_counter_next_frame), (not is_set(map_column(2), 6)) or
      is_set(map_column(1), 6) or map_counter_next_frame);
    map_sorted_low_0 <= choice(map_of_column_0_b_below_a, map_sorted_low_0_choices(1), map_sorted_low_0_choices(2));
    map_sorted_middle_0 <= choice(map_of_column_0_b_below_a, map_sorted_middle_0_choices(1),
      map_sorted_middle_0_choices(2));
    map_sorted_high_0 <= choice(map_of_column_0_b_below_a, map_sorted_high_0_choices(1), map_sorted_high_0_choices(2));
    map_passed_0(1) <= choice(map_passed_0(0), map_passed_0(1) or map_sorted_arrives or map_sorted_behind,
      map_passed_0(1) and (not map_sorted_arrives) and (not map_sorted_behind));
    map_of_low_0_b_below_a <= inverted_carry(map_of_low_0_b_below_a_choice_5, is_set(map_low_0(0), 5), not
      is_set(map_low_0(1), 5));
    map_of_low_0_c_below_a <= carry(map_of_low_0_c_below_a_choice_5, not is_set(map_low_0(2), 5), is_set(map_low_0(0),
      5));
    map_of_low_0_c_below_b <= carry(map_of_low_0_c_below_b_choice_5, not is_set(map_low_0(2), 5), is_set(map_low_0(1),
      5));
    map_of_middle_0_b_below_a <= inverted_carry(map_of_middle_0_b_below_a_choice_5, is_set(map_middle_0(0), 5), not
      is_set(map_middle_0(1), 5));
    map_of_middle_0_c_below_a <= carry(map_of_middle_0_c_below_a_choice_5, not is_set(map_middle_0(2), 5),
      is_set(map_middle_0(0), 5));
    map_of_middle_0_c_below_b <= carry(map_of_middle_0_c_below_b_choice_5, not is_set(map_middle_0(2), 5),
      is_set(map_middle_0(1), 5));
    map_of_high_0_b_below_a <= inverted_carry(map_of_high_0_b_below_a_choice_5, is_set(map_high_0(0), 5), not
      is_set(map_high_0(1), 5));
    map_of_high_0_c_below_a <= carry(map_of_high_0_c_below_a_choice_5, not is_set(map_high_0(2), 5),
      is_set(map_high_0(0), 5));
    map_of_high_0_c_below_b <= carry(map_of_high_0_c_below_b_choice_5, not is_set(map_high_0(2), 5),
      is_set(map_high_0(1), 5));
    map_largest_low_0 <= choice(map_of_low_0_b_below_a, map_largest_low_0_choices(1), map_largest_low_0_choices(2));
    map_median_middle_0 <= choice(map_of_middle_0_b_below_a, map_median_middle_0_choices(2),
      map_median_middle_0_choices(4));
    map_smallest_high_0 <= choice(map_of_high_0_b_below_a, map_smallest_high_0_choices(1),
      map_smallest_high_0_choices(2));
    map_of_all_0_b_below_a <= inverted_carry(map_of_all_0_b_below_a_choice_5, is_set(map_largest_low_0, 5), not
      is_set(map_median_middle_0, 5));
    map_of_all_0_c_below_a <= carry(map_of_all_0_c_below_a_choice_5, not is_set(map_smallest_high_0, 5),
      is_set(map_largest_low_0, 5));
    map_of_all_0_c_below_b <= carry(map_of_all_0_c_below_b_choice_5, not is_set(map_smallest_high_0, 5),
      is_set(map_median_middle_0, 5));
    map_out_disparity_0 <= choice(map_of_all_0_b_below_a, map_out_disparity_0_choices(2),
      map_out_disparity_0_choices(4));
    if map_at_arrives_value then
      map_rows_write_words_0 <= (map_rows_ready_words_0 / 512) + (map_rows_ready_newest_0 * 512);
      map_at_column <= to_integer(other_16(8 downto 0));
    end if;
    map_low_0_0_choice := choice(map_sorted_behind, map_low_0(0), map_sorted_low_0);
    map_low_0_all(1) := map_window_complete_is_equal and map_sorted_arrives;
    map_middle_0_0_choice := choice(map_sorted_behind, map_middle_0(0), map_sorted_middle_0);
    map_high_0_0_choice := choice(map_sorted_behind, map_high_0(0), map_sorted_high_0);
    map_low_0_all(0) := (not map_sorted_arrives) and (not map_sorted_behind);
    if not map_low_0_all(0) then
      map_low_0(0) <= map_low_0_0_choice;
      map_low_0(2) <= map_low_0(1);
      map_middle_0(0) <= map_middle_0_0_choice;
      map_middle_0(2) <= map_middle_0(1);
      map_high_0(0) <= map_high_0_0_choice;
      map_high_0(2) <= map_high_0(1);
      map_low_0(1) <= choice(map_low_0_all(1), map_low_0_0_choice, map_low_0(0));
      map_middle_0(1) <= choice(map_low_0_all(1), map_middle_0_0_choice, map_middle_0(0));
      map_high_0(1) <= choice(map_low_0_all(1), map_high_0_0_choice, map_high_0(0));
    end if;
    if map_sorted_arrives then map_passed_0(0) <= map_column_passed_0(1); end if;
    -- relief
    if transform_columns_valid then
      relief_centre_column(0) <= transform_left_column(1);
      relief_centre_column(1 to 4) <= relief_centre_column(0 to 3);
    end if;
    for i in 1 to 5 loop relief_newest_values(i) := is_set(relief_before, i + 1); end loop;
    relief_newest_choice(7) := not is_larger(relief_centre_grey_0, relief_before, 0, 6, false);
    relief_newest_choice(8) := carry(relief_newest_choice(7), not is_set(relief_centre_grey_0, 7),
      is_set(relief_before, 7));
    relief_newest_values_from_6(6) := (relief_before - relief_centre_grey_0) mod 256;
    relief_newest_values_from_6(7) := (relief_centre_grey_0 - relief_before) mod 256;
    relief_newest_choice(9) := choice(relief_newest_choice(8), is_set(relief_newest_values_from_6(6), 2),
      is_set(relief_newest_values_from_6(7), 2));
    relief_newest_choice(10) := choice(relief_newest_choice(8), not is_set(relief_newest_values_from_6(6), 3), not
      is_set(relief_newest_values_from_6(7), 3));
    for i in 0 to 1 loop
      relief_newest_choice(2 * i + 11) := choice(relief_newest_choice(8), not is_set(relief_newest_values_from_6(6), 4
        * i + 1), not is_set(relief_newest_values_from_6(7), 4 * i + 1));
      relief_newest_choice(2 * i + 12) := choice(relief_newest_choice(8), is_set(relief_newest_values_from_6(6), 2 * i
        + 4), is_set(relief_newest_values_from_6(7), 2 * i + 4));
    end loop;
    relief_newest_choice(15) := choice(relief_newest_choice(8), is_set(relief_newest_values_from_6(6), 7),
      is_set(relief_newest_values_from_6(7), 7));
    relief_newest_choice(16) := inverted_carry(relief_newest_choice(7), is_set(relief_centre_grey_0, 7), not
      is_set(relief_before, 7));
    relief_newest_choice_17 := choice(relief_newest_choice(16), (relief_newest_values_from_6(7) / 2) mod 64,
      (relief_newest_values_from_6(6) / 2) mod 64);
    relief_centre_grey_0 <= relief_centre_column(4);
    relief_delayed_0 <= relief_newest;
    relief_rows_read_newest_0 <= relief_delayed_0;
    relief_rows_ready_words_0 <= to_integer(relief_rows_read_words_0);
    relief_rows_ready_newest_0 <= relief_rows_read_newest_0;
    relief_shown_0 <= relief_rows_ready_words_0;
    relief_waiting(0) <= relief_column_0;
    relief_waiting(1 to 9) <= relief_waiting(0 to 8);
    relief_entered <= relief_entering;
    relief_newest <= choice(((not ((not ((not ((not relief_newest_choice(9)) and relief_newest_choice(10) and
      relief_newest_choice(11))) and relief_newest_choice(12))) and relief_newest_choice(13))) and
      relief_newest_choice(14)) or relief_newest_choice(15), 40, relief_newest_choice_17);
    relief_entering <= choice(relief_waiting(9) < 40, relief_waiting(9), 40);
    if transform_filtering_valid(1) then relief_before <= relief_centre_grey_0; end if;
    if rows_ready_tag.valid then relief_rows_write_words_0 <= relief_rows_ready_newest_0; end if;
    if rows_tag.valid then relief_column_0 <= relief_shown_0; end if;
    -- other
    for i in 0 to 15 loop
      other_choice(i, 1) := choice(entry_tag.valid, forward_left_cost(61 - 4 * i) + forward_above_cost(61 - 4 * i),
        to_integer(other(i)(15 downto 8)));
      other_choice(i, 2) := choice(entry_tag.valid, forward_left_cost(60 - 4 * i) + forward_above_cost(60 - 4 * i),
        to_integer(other(i)(7 downto 0)));
      other_choice(i, 3) := choice(entry_tag.valid, forward_left_cost(62 - 4 * i) + forward_above_cost(62 - 4 * i),
        to_integer(other(i)(23 downto 16)));
      other_choice_4(i) := choice(entry_tag.valid, forward_left_cost(63 - 4 * i) + forward_above_cost(63 - 4 * i),
        to_integer(other(i)(31 downto 24)));
    end loop;
    for i in 0 to 15 loop
      other(i) <= to_unsigned(other_choice_4(i), 8) & to_unsigned(other_choice(i, 3), 8) & to_unsigned(other_choice(i,
        1), 8) & to_unsigned(other_choice(i, 2), 8);
    end loop;
    other_16 <= other_18;
    other_17 <= (((map_rows_ready_words_0 mod 512) / 2) mod 64) * 2;
    other_18 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 376))), 1) &
      to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
      to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) & to_unsigned(map_counter_column,
      16);
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 377;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 376; raster_place_next_frame <= false; delay_column <= 0; delay_tag.valid <= false;
      delay_tag.first_cost <= false; delay_tag.map_column <= false; delay_tag.output_column <= false;
      delay_tag.start_of_frame <= false; delay_tag.end_of_line <= false; rows_read_column <= 0;
      rows_read_tag.valid <= false; rows_read_tag.first_cost <= false; rows_read_tag.map_column <= false;
      rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false;
      rows_ready_column <= 0; rows_ready_tag.valid <= false; rows_ready_tag.first_cost <= false;
      rows_ready_tag.map_column <= false; rows_ready_tag.output_column <= false; rows_ready_tag.start_of_frame <= false;
      rows_ready_tag.end_of_line <= false; rows_write_column <= 0; rows_tag.valid <= false;
      rows_tag.first_cost <= false; rows_tag.map_column <= false; rows_tag.output_column <= false;
      rows_tag.start_of_frame <= false; rows_tag.end_of_line <= false; slice0shift_tag.valid <= false;
      slice0shift_tag.first_cost <= false; slice0shift_tag.map_column <= false; slice0shift_tag.output_column <= false;
      slice0shift_tag.start_of_frame <= false; slice0shift_tag.end_of_line <= false;
      slice0cost_pixels_first_tag.valid <= false; slice0cost_pixels_first_tag.first_cost <= false;
      slice0cost_pixels_first_tag.map_column <= false; slice0cost_pixels_first_tag.output_column <= false;
      slice0cost_pixels_first_tag.start_of_frame <= false; slice0cost_pixels_first_tag.end_of_line <= false;
      slice0cost_pixels_tag.valid <= false; slice0cost_pixels_tag.first_cost <= false;
      slice0cost_pixels_tag.map_column <= false; slice0cost_pixels_tag.output_column <= false;
      slice0cost_pixels_tag.start_of_frame <= false; slice0cost_pixels_tag.end_of_line <= false;
      slice0cost_pair_tag.valid <= false; slice0cost_pair_tag.first_cost <= false;
      slice0cost_pair_tag.map_column <= false; slice0cost_pair_tag.output_column <= false;
      slice0cost_pair_tag.start_of_frame <= false; slice0cost_pair_tag.end_of_line <= false;
      slice0cost_tag.valid <= false; slice0cost_tag.first_cost <= false; slice0cost_tag.map_column <= false;
      slice0cost_tag.output_column <= false; slice0cost_tag.start_of_frame <= false;
      slice0cost_tag.end_of_line <= false; slice0window_centre_map_column_0 <= false;
      slice0window_centre_output_column_0 <= false; slice0window_centre_first_column_0 <= false;
      slice0window_centre_start_of_frame_0 <= false; slice0window_centre_end_of_line_0 <= false;
      slice0window_tag <= (others => false);
      for i in 0 to 3 loop
        slice0_tag_valid(i) <= false; slice0_tag_map_column(i) <= false; slice0_tag_output_column(i) <= false;
        slice0_tag_first_column(i) <= false; slice0_tag_start_of_frame(i) <= false; slice0_tag_end_of_line(i) <= false;
      end loop;
      entry_next_tag.valid <= false; entry_next_tag.map_column <= false; entry_next_tag.end_of_line <= false;
      entry_next_column <= 0; entry_order_address <= 0; entry_order_falls <= false; entry_order_inside <= false;
      entry_order_complete <= false; entry_order_output <= false; entry_order_first <= false;
      entry_order_held_output <= false; entry_order_turned_output_column <= false;
      entry_order_turned_start_of_frame <= false; entry_tag.valid <= false; entry_tag.map_column <= false;
      entry_tag.end_of_line <= false; entry_column <= 0; entry_place <= 0; entry_turned_output_column <= false;
      entry_turned_start_of_frame <= false; forward_cost_delay_ring_read_address <= 1;
      forward_cost_delay_ring_write_address <= 0; forward_above_delay_ring_read_address <= 1;
      forward_above_delay_ring_write_address <= 0; forward_above_comes <= (others => false);
      forward_above_column <= (others => 0); forward_above_writes_copy_0 <= false; forward_above_write_column <= 0;
      sums_turn_place <= (others => 0); sums_turn_writes_copy_0 <= false; sums_turn_write_place <= 0;
      sums_sum_delay_ring_read_address <= 1; sums_sum_delay_ring_write_address <= 0; sums_tag <= (others => false);
      for i in 0 to 4 loop
        sums_tags_held_output_column(i) <= false; sums_tags_held_start_of_frame(i) <= false;
        sums_tags_held_end_of_line(i) <= false;
      end loop;
      sums_tags_moved <= false; winnerswinner1_pair_tag <= (others => false);
      winnerswinner1_four_tag <= (others => false); winnerswinner1_tag <= (others => false);
      winnerswinner2_pair_tag <= (others => false); winnerswinner2_four_tag <= (others => false);
      winnerswinner2_tag <= (others => false); winnerswinner3_pair_tag <= (others => false);
      winnerswinner3_four_tag <= (others => false); winnerswinner3_tag <= (others => false);
      winners_best_tag <= (others => false); turn_order_address <= 0; turn_order_falls <= false;
      turn_order_inside <= false; turn_order_complete <= false; turn_order_output <= false; turn_order_first <= false;
      turn_order_turned_valid <= false; turn_order_turned_map_column <= false;
      turn_order_turned_start_of_frame <= false; turn_order_turned_end_of_line <= false; turn_comes <= false;
      turn_read_tag <= (others => false); turn_write_place <= 0; turn_ready_tag <= (others => false);
      map_counter_column <= 0; map_counter_group <= 376; map_arrives <= false; map_behind <= false;
      map_line_ended <= false; map_write_column <= 0; map_at_column <= 0; map_at_arrives <= false;
      map_at_behind <= false; map_at_top <= false; map_at_output <= false; map_comparing_column <= 0;
      map_comparing_arrives <= false; map_comparing_behind <= false; map_comparing_top <= false;
      map_comparing_output <= false; map_sorted_column <= 0; map_sorted_arrives <= false; map_sorted_behind <= false;
      map_sorted_top <= false; map_sorted_output <= false; map_window_complete <= false; map_window_first <= false;
      map_window_last <= false;
      for i in 0 to 2 loop
        map_waiting_complete(i) <= false; map_waiting_first(i) <= false; map_waiting_last(i) <= false;
      end loop;
      map_out_valid <= false; map_out_start_of_frame <= false; map_out_end_of_line <= false;
      other_16 <= to_unsigned(0, 49); other_18 <= to_unsigned(0, 49);
    end if;
  end process;
end architecture;
