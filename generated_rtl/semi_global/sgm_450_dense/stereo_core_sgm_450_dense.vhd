-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_450_dense: 450x375, 64 disparities, window 3x3, P1 9, P2 40, 1 pixel pair a clock.
-- Options: reference left, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap 6, p1 9, p2 40,
--   p2_least 15, above_p1 5, above_p2 20, left_right_threshold 1, subpixel true, median true, full_width
--   true, border_cost 3, support_threshold 10, confidence true, margin_weight 4, support_weight 2, fill_holes
--   true, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_450_dense
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_450_dense is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 24;
    output_width_px : positive := 448;
    latency_clocks : positive := 82;
    flush_groups : positive := 4139;
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
  assert width_px = 450 report "stereo_core_sgm_450_dense: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_sgm_450_dense: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 64 report "stereo_core_sgm_450_dense: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_450_dense: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 24 report "stereo_core_sgm_450_dense: disparity_bits is " & integer'image(disparity_bits) & " but this core has 24" severity failure;
  assert output_width_px = 448 report "stereo_core_sgm_450_dense: output_width_px is " & integer'image(output_width_px) & " but this core has 448" severity failure;
  assert latency_clocks = 82 report "stereo_core_sgm_450_dense: latency_clocks is " & integer'image(latency_clocks) & " but this core has 82" severity failure;
  assert flush_groups = 4139 report "stereo_core_sgm_450_dense: flush_groups is " & integer'image(flush_groups) & " but this core has 4139" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_450_dense: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_450_dense is
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
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
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
  type natural_2147483647_1d is array (natural range <>) of natural range 0 to 2147483647;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_257_to_1022_1d is array (natural range <>) of natural range 257 to 1022;
  type natural_268435455_1d is array (natural range <>) of natural range 0 to 268435455;
  type natural_28_1d is array (natural range <>) of natural range 0 to 28;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_36_1d is array (natural range <>) of natural range 0 to 36;
  type natural_36_2d is array (natural range <>, natural range <>) of natural range 0 to 36;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_46_1d is array (natural range <>) of natural range 0 to 46;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_5_1d is array (natural range <>) of natural range 0 to 5;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_to_127_1d is array (natural range <>) of natural range 63 to 127;
  type natural_7_2d is array (natural range <>, natural range <>) of natural range 0 to 7;
  type natural_84_1d is array (natural range <>) of natural range 0 to 84;
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type unsigned_31_1d is array (natural range <>) of unsigned(30 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
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
  signal delay_tag : tag_6;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_search, rows_reference : natural_16383_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag : tag_6;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag, rows_tag : tag_6;
  -- slice0shift
  signal slice0shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice0shift_reference, slice0shift_search_out : natural_16383_1d(0 to 2);
  signal slice0shift_tag : tag_6;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- _#_#_count_#
  signal slice0cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- _#_#_count_4
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_pair_tag, slice0cost_tag : tag_6;
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
  -- slice0mask
  signal slice0mask_inside : boolean_1d(0 to 15);
  signal slice0mask_left_out : boolean;
  signal slice0mask_column : natural range 0 to 511;
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
  signal slice1cost_tag_first_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice1window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice1window_centre_first_column_0, slice1window_tag_first_column : boolean;
  signal slice1window_sum_0 : natural_126_1d(0 to 15);
  -- slice1mask
  signal slice1mask_inside : boolean_1d(0 to 15);
  signal slice1mask_left_out : boolean;
  -- slice1
  signal slice1_held : natural_15_2d(0 to 2, 0 to 15);
  signal slice1_tag_0_first_column : boolean;
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
  signal slice2cost_tag_first_column : boolean;
  -- slice2window
  signal slice2window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice2window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice2window_centre_first_column_0 : boolean;
  signal slice2window_sum_0 : natural_126_1d(0 to 15);
  -- slice2mask
  signal slice2mask_inside : boolean_1d(0 to 15);
  signal slice2mask_left_out : boolean;
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
  -- slice3mask
  signal slice3mask_inside : boolean_1d(0 to 15);
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
  signal forward_cost_delay_held_6 : unsigned(13 downto 0);
  signal forward_left_pair : natural_127_1d(0 to 31);
  signal forward_left_tree_smallest : natural_127_1d(0 to 15);
  signal forward_left_tree_next_smallest : natural_127_1d(0 to 7);
  signal forward_left_tree_next_next_smallest : natural_127_1d(0 to 3);
  signal forward_left_tree_next_next_next_smallest : natural_127_1d(0 to 1);
  signal forward_left_tree_next_next_next_next_smallest_0, forward_left_smallest, forward_left_smallest_less,
    forward_left_relief_leaves : natural range 0 to 127;
  signal forward_left_g_copy, forward_left_g_less_copy : natural_127_1d(0 to 3);
  signal forward_left_stay_change, forward_left_step_change, forward_left_cost, forward_left_arrived,
    forward_sum : natural_127_1d(0 to 63);
  signal forward_left_start_cost : natural_63_1d(0 to 8);
  signal forward_left_room : natural range 0 to 63;
  signal forward_left_first : boolean_1d(0 to 2);
  signal forward_above_ready_top : boolean;
  signal forward_above_comes : boolean_1d(0 to 11);
  signal forward_above_writes_copy_0 : boolean;
  signal forward_first : boolean_1d(0 to 10);
  signal forward_left_relief_next : natural_31_1d(0 to 3);
  signal forward_left_relief_past : natural_31_1d(0 to 7);
  signal forward_left_relief_pairs : natural_31_1d(0 to 1);
  signal forward_left_relief_fours : natural_31_1d(0 to 2);
  signal forward_left_relief_older, forward_left_relief_recent, forward_left_relief_largest,
    forward_left_relief_beyond : natural range 0 to 31;
  signal forward_above_cost, forward_above_beside : natural_31_1d(0 to 63);
  signal forward_above_own_0 : natural range 0 to 31;
  signal forward_above_own : natural_31_1d(2 to 61);
  signal forward_above_own_63 : natural range 0 to 31;
  signal forward_above_stay : natural_31_1d(0 to 63);
  signal forward_reliefs_moved : natural_31_1d(0 to 10);
  signal forward_left_relief_reach_of_best : natural range 0 to 255;
  signal forward_left_relief_room_of_best : natural range 0 to 158;
  signal forward_left_relief_reach_again : natural range 0 to 222;
  signal forward_above_read_words, forward_above_delay_held : unsigned_31_1d(0 to 9);
  signal forward_above_read_words_10, forward_above_delay_held_10 : unsigned(20 downto 0);
  signal forward_above_ready_words, forward_above_write_words : natural_2147483647_1d(0 to 9);
  signal forward_above_ready_words_10, forward_above_write_words_10 : natural range 0 to 2097151;
  signal forward_above_total : natural_46_1d(0 to 63);
  signal forward_above_tree_smallest : natural_46_1d(0 to 31);
  signal forward_above_tree_next_smallest : natural_46_1d(0 to 15);
  signal forward_above_tree_next_next_smallest : natural_46_1d(0 to 7);
  signal forward_above_tree_next_next_next_smallest : natural_46_1d(0 to 3);
  signal forward_above_tree_next_next_next_next_smallest : natural_46_1d(0 to 1);
  signal forward_above_tree_next_next_next_next_next_smallest_0 : natural range 0 to 46;
  signal forward_above_smallest_copy : natural_46_1d(0 to 3);
  signal forward_above_step : natural_36_1d(0 to 63);
  signal forward_above_column : natural_511_1d(0 to 11);
  signal forward_above_write_column : natural range 0 to 511;
  -- sums
  signal sums_turn_read_sums, sums_sum_delay_held : unsigned_28_1d(0 to 15);
  signal sums_turn_read_costs : unsigned_30_1d(0 to 5);
  signal sums_turn_read_costs_6 : unsigned(11 downto 0);
  signal sums_turn_read_smallest_0 : unsigned(7 downto 0);
  signal sums_turn_ready_sums, sums_turn_write_sums : natural_268435455_1d(0 to 15);
  signal sums_turn_ready_costs, sums_turn_write_costs : natural_1073741823_1d(0 to 5);
  signal sums_turn_ready_costs_6, sums_turn_write_costs_6 : natural range 0 to 4095;
  signal sums_turn_ready_smallest_0, sums_turn_write_smallest_0,
    sums_right_relief_reach_of_best : natural range 0 to 255;
  signal sums_sum_0 : natural_255_1d(0 to 63);
  signal sums_turn_ready_first, sums_turn_writes_copy_0 : boolean;
  signal sums_turn_waiting_first : boolean_1d(0 to 5);
  signal sums_right_first : boolean_1d(0 to 2);
  signal sums_tag : tag_6;
  signal sums_tags_held_output_column : boolean_1d(0 to 15);  -- _#_output_column
  signal sums_tags_held_start_of_frame : boolean_1d(0 to 15);  -- _#_start_of_frame
  signal sums_tags_held_end_of_line : boolean_1d(0 to 15);  -- _#_end_of_line
  signal sums_tags_held_map_column : boolean_1d(12 to 15);  -- _#_map_column
  signal sums_tags_held_first_column : boolean_1d(12 to 15);  -- _#_first_column
  signal sums_tags_moved : boolean;
  signal sums_turn_place : natural_511_1d(0 to 10);
  signal sums_turn_write_place, sums_turn_waiting_read_place : natural range 0 to 511;
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
  signal sums_right_room : natural range 0 to 63;
  signal sums_right_relief_next : natural_31_1d(0 to 3);
  signal sums_right_relief_past : natural_31_1d(0 to 7);
  signal sums_right_relief_pairs : natural_31_1d(0 to 1);
  signal sums_right_relief_fours : natural_31_1d(0 to 2);
  signal sums_right_relief_older, sums_right_relief_recent, sums_right_relief_largest,
    sums_right_relief_beyond : natural range 0 to 31;
  signal sums_right_relief_room_of_best : natural range 0 to 158;
  signal sums_right_relief_reach_again : natural range 0 to 222;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  -- winnersmask
  signal winnersmask_inside : boolean_1d(0 to 63);
  signal winnersmask_column : natural range 0 to 511;
  -- winnersother
  signal winnersother_cost_0 : natural_255_1d(1 to 63);
  signal winnersother_winner_0 : natural_63_1d(0 to 63);
  signal winnersother_winner_out_0 : natural range 0 to 63;
  -- winnerswinner1
  signal winnerswinner1_held_0 : natural_255_1d(0 to 63);
  signal winnerswinner1_best_cost_0, winnerswinner1_best_below_0, winnerswinner1_best_above_0,
    winnerswinner1_best_late_cost_0 : natural_255_1d(0 to 31);
  signal winnerswinner1_best_but_first_0 : natural_255_1d(1 to 31);
  signal winnerswinner1_best_but_last_0 : natural_255_1d(0 to 30);
  signal winnerswinner1_best_index_0_0 : boolean;
  signal winnerswinner1_best_place_0 : boolean_1d(1 to 15);  -- _2#
  signal winnerswinner1_tag : tag_6;
  signal winnerswinner1_best_index_0 : natural_63_1d(1 to 31);  -- _# up to 3, 5 .. 63
  -- winnerswinner2
  signal winnerswinner2_best_cost_0, winnerswinner2_best_below_0, winnerswinner2_best_above_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_first_0 : natural_255_1d(1 to 15);
  signal winnerswinner2_best_last_0 : natural_255_1d(0 to 14);
  signal winnerswinner2_best_late_cost_0, winnerswinner2_best_second_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_but_first_0 : natural_255_1d(1 to 15);
  signal winnerswinner2_best_but_last_0 : natural_255_1d(0 to 14);
  signal winnerswinner2_best_index_0 : natural_63_1d(0 to 15);  -- _# up to 3, 7 .. 63
  signal winnerswinner2_best_place_0, winnerswinner2_best_at_start_0,
    winnerswinner2_best_at_end_0 : boolean_1d(0 to 15);
  signal winnerswinner2_tag : tag_6;
  -- winnerswinner3
  signal winnerswinner3_best_cost_0, winnerswinner3_best_below_0, winnerswinner3_best_above_0 : natural_255_1d(0 to 7);
  signal winnerswinner3_best_first_0 : natural_255_1d(1 to 7);
  signal winnerswinner3_best_last_0 : natural_255_1d(0 to 6);
  signal winnerswinner3_best_late_cost_0, winnerswinner3_best_second_0 : natural_255_1d(0 to 7);
  signal winnerswinner3_best_but_first_0 : natural_255_1d(1 to 7);
  signal winnerswinner3_best_but_last_0 : natural_255_1d(0 to 6);
  signal winnerswinner3_best_index_0 : natural_63_1d(0 to 7);  -- _# up to 7, 15 .. 63
  signal winnerswinner3_best_place_0, winnerswinner3_best_at_start_0, winnerswinner3_best_at_end_0 : boolean_1d(0 to 7);
  signal winnerswinner3_tag : tag_6;
  -- winnerswinner4
  signal winnerswinner4_best_cost_0, winnerswinner4_best_below_0, winnerswinner4_best_above_0 : natural_255_1d(0 to 3);
  signal winnerswinner4_best_first_0 : natural_255_1d(1 to 3);
  signal winnerswinner4_best_last_0 : natural_255_1d(0 to 2);
  signal winnerswinner4_best_late_cost_0, winnerswinner4_best_second_0 : natural_255_1d(0 to 3);
  signal winnerswinner4_best_but_first_0 : natural_255_1d(1 to 3);
  signal winnerswinner4_best_but_last_0 : natural_255_1d(0 to 2);
  signal winnerswinner4_best_index_0 : natural_63_1d(0 to 3);  -- _# up to 15, 31 .. 63
  signal winnerswinner4_best_place_0, winnerswinner4_best_at_start_0, winnerswinner4_best_at_end_0 : boolean_1d(0 to 3);
  signal winnerswinner4_tag : tag_6;
  -- winnerswinner5
  signal winnerswinner5_best_cost_0, winnerswinner5_best_below_0, winnerswinner5_best_above_0 : natural_255_1d(0 to 1);
  signal winnerswinner5_best_first_0_1, winnerswinner5_best_last_0_0 : natural range 0 to 255;
  signal winnerswinner5_best_late_cost_0, winnerswinner5_best_second_0 : natural_255_1d(0 to 1);
  signal winnerswinner5_best_but_first_0_1, winnerswinner5_best_but_last_0_0 : natural range 0 to 255;
  signal winnerswinner5_best_index_0 : natural_63_1d(0 to 1);  -- _# up to 31, 63
  signal winnerswinner5_best_place_0, winnerswinner5_best_at_start_0, winnerswinner5_best_at_end_0 : boolean_1d(0 to 1);
  signal winnerswinner5_tag : tag_6;
  -- winnerswinner6
  signal winnerswinner6_best_cost_0_0, winnerswinner6_best_below_0_0, winnerswinner6_best_above_0_0,
    winnerswinner6_best_late_cost_0_0, winnerswinner6_best_second_0_0 : natural range 0 to 255;
  signal winnerswinner6_best_index_0_0 : natural range 0 to 63;
  signal winnerswinner6_best_place_0_0, winnerswinner6_best_at_start_0_0, winnerswinner6_best_at_end_0_0 : boolean;
  signal winnerswinner6_tag : tag_6;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 63;
  signal winners_best_below_0_0, winners_best_above_0_0, winners_best_late_cost_0_0,
    winners_best_second_0_0 : natural range 0 to 255;
  signal winners_best_place_0 : boolean;
  signal winners_best_tag : tag_5;
  signal winners_partner_column : natural range 0 to 511;
  signal winners_partner_at : natural range 0 to 575;
  -- refinement
  signal refinement_disparity_0 : natural_63_1d(0 to 11);  -- _#_0
  signal refinement_margin_0 : natural_63_1d(0 to 9);  -- _#_0
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- _#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- _#_map_column
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- _#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- _#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- _#_end_of_line
  signal refinement_alone_0_0 : boolean;
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_gap_0, refinement_below_0, refinement_above_0, refinement_u_0,
    refinement_v_0 : natural range 0 to 255;
  signal refinement_remainder_0, refinement_divisor_0 : natural_255_1d(0 to 7);  -- _#_0
  signal refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_difference_0 : integer range -255 to 255;
  signal refinement_fraction_0 : natural range 0 to 31;
  -- leftright
  signal leftright_other_0 : natural_63_1d(1 to 17);  -- _#_0
  signal leftright_ring_read_address, leftright_ring_write_address, leftright_asking_disparity_0,
    leftright_asking_margin_0, leftright_answered_disparity_0, leftright_answered_margin_0,
    leftright_checked_disparity_0, leftright_checked_margin_0 : natural range 0 to 63;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0 : boolean;
  signal leftright_asking_tag : tag_5;
  signal leftright_answered_passed_0 : boolean;
  signal leftright_answered_tag : tag_5;
  signal leftright_checked_passed_0 : boolean;
  signal leftright_checked_tag : tag_5;
  signal leftright_position, leftright_held_position, leftright_address_0 : natural range 0 to 127;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_held_1, leftright_found_0 : unsigned(5 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0,
    leftright_checked_fraction_0 : natural range 0 to 31;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 511;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame,
    turn_order_turned_end_of_line, turn_comes : boolean;
  signal turn_read_tag : tag_4_b;
  signal turn_ready_tag : tag_5_b;
  signal turn_newest, turn_write_words_0 : natural range 0 to 1048383;
  signal turn_read_words_0 : unsigned(19 downto 0);
  signal turn_ready : natural range 0 to 1048575;
  -- support
  signal support_counter_column, support_counter_group, support_read_column, support_ready_column,
    support_write_column : natural range 0 to 511;
  signal support_newest_0, support_rows_read_newest_0, support_rows_ready_newest_0 : natural range 0 to 127;
  signal support_column : natural_127_1d(0 to 4);
  signal support_cells : natural_127_2d(0 to 12, 0 to 4);
  signal support_centre_0 : natural_127_1d(0 to 2);  -- _#_0
  signal support_newest_rest_0, support_rest_rows_read_newest_0, support_rest_rows_ready_newest_0,
    support_column_rest_0 : natural range 0 to 1023;
  signal support_rest_0 : natural_1023_1d(0 to 6);  -- _#_0
  signal support_centre_rest_0 : natural_1023_1d(0 to 2);  -- _#_0
  signal support_out_disparity_0 : natural range 0 to 1023;
  signal support_moves, support_arrives, support_last, support_read_moves, support_read_arrives, support_read_above2,
    support_read_above1, support_read_below1, support_read_below2, support_read_first, support_read_last,
    support_ready_moves, support_ready_arrives, support_ready_above2, support_ready_above1, support_ready_below1,
    support_ready_below2, support_ready_first, support_ready_last, support_at_moves, support_at_arrives,
    support_at_first, support_at_last : boolean;
  signal support_row_tag : boolean_1d(0 to 12);
  signal support_moment_map_column : boolean_1d(0 to 6);  -- _#_map_column
  signal support_moment_start_of_frame : boolean_1d(0 to 6);  -- _#_start_of_frame
  signal support_moment_last : boolean_1d(0 to 6);  -- _#_last
  signal support_next_tag, support_moved : boolean;
  signal support_like_0 : boolean_2d(0 to 6, 0 to 4);
  signal support_enough_0 : boolean;
  signal support_centre_moment_map_column : boolean_1d(0 to 3);  -- _#_map_column
  signal support_centre_moment_start_of_frame : boolean_1d(0 to 3);  -- _#_start_of_frame
  signal support_centre_moment_last : boolean_1d(0 to 3);  -- _#_last
  signal support_centre_moved : boolean_1d(0 to 3);
  signal support_out_passed_0 : boolean;
  signal support_out_tag : tag_5_b;
  signal support_rows_read_words_0 : unsigned(27 downto 0);
  signal support_rows_ready_words_0, support_rows_write_words_0 : natural range 0 to 268435455;
  signal support_rest_rows_read_words_0 : unsigned(19 downto 0);
  signal support_rest_rows_ready_words_0, support_rest_rows_write_words_0 : natural range 0 to 1048575;
  signal support_partial_0 : natural_5_1d(0 to 6);
  signal support_count_0 : natural range 0 to 35;
  signal support_sum_0 : natural range 0 to 322;
  signal support_out_sure_0 : natural range 0 to 255;
  -- fill
  signal fill_counter_column, fill_counter_group, fill_read_column, fill_ready_column, fill_write_column,
    fill_at_column : natural range 0 to 511;
  signal fill_asking_at_column : natural_511_1d(0 to 1);  -- _#_column
  signal fill_known_at_column, fill_beside_0_left_column, fill_beside_0_right_column, fill_measured_at_column,
    fill_measured_beside_0_right_column, fill_width_0, fill_chosen_at_column,
    fill_write_above_column : natural range 0 to 511;
  signal fill_newest_disparity_0, fill_pixel_0_disparity : natural range 0 to 1023;
  signal fill_asking_0_disparity : natural_1023_1d(0 to 1);  -- _#_0_disparity
  signal fill_known_0_disparity, fill_beside_0_left, fill_beside_0_right, fill_measured_0_disparity,
    fill_measured_beside_0_left, fill_measured_beside_0_right, fill_chosen_0_disparity, fill_chosen_beside_0_left,
    fill_chosen_beside_0_right : natural range 0 to 1023;
  signal fill_newest_passed_0, fill_moves, fill_arrives, fill_last, fill_read_moves, fill_read_arrives, fill_read_top,
    fill_read_last, fill_ready_moves, fill_ready_arrives, fill_ready_top, fill_ready_last, fill_ends_open_0,
    fill_pixel_0_passed, fill_at_moves, fill_at_arrives, fill_at_top, fill_at_last, fill_in_hole_0 : boolean;
  signal fill_asking_0_passed : boolean_1d(0 to 1);  -- _#_0_passed
  signal fill_asking_at_moves : boolean_1d(0 to 1);  -- _#_moves
  signal fill_asking_at_arrives : boolean_1d(0 to 1);  -- _#_arrives
  signal fill_asking_at_top : boolean_1d(0 to 1);  -- _#_top
  signal fill_asking_at_last : boolean_1d(0 to 1);  -- _#_last
  signal fill_hole_starts_0 : boolean_1d(0 to 1);  -- _#_0
  signal fill_known_0_passed, fill_known_at_moves, fill_known_at_arrives, fill_known_at_top, fill_known_at_last,
    fill_beside_0_has_left, fill_beside_0_has_right, fill_measured_0_passed, fill_measured_at_moves,
    fill_measured_at_arrives, fill_measured_at_top, fill_measured_at_last, fill_measured_beside_0_has_left,
    fill_measured_beside_0_has_right, fill_rises_0, fill_chosen_0_passed, fill_chosen_at_moves, fill_chosen_at_arrives,
    fill_chosen_at_top, fill_chosen_at_last, fill_chosen_beside_0_has_left, fill_chosen_beside_0_has_right,
    fill_takes_left_0, fill_out_passed_0, fill_out_filled_0 : boolean;
  signal fill_out_tag : tag_5_b;
  signal fill_has_values, fill_had_values : boolean;
  signal fill_newest_sure_0, fill_ends_next_place_0, fill_ends_row_place_0, fill_ends_row_above_place_0,
    fill_ends_write_place_0, fill_ends_read_place_0, fill_pixel_0_sure : natural range 0 to 255;
  signal fill_asking_0_sure : natural_255_1d(0 to 1);  -- _#_0_sure
  signal fill_known_0_sure, fill_measured_0_sure, fill_chosen_0_sure, fill_out_sure_0 : natural range 0 to 255;
  signal fill_rows_read_words_0 : unsigned(18 downto 0);
  signal fill_rows_read_newest_0, fill_rows_ready_words_0, fill_rows_ready_newest_0,
    fill_rows_write_words_0 : natural range 0 to 524287;
  signal fill_ends_write_words_0, fill_ends_ready_words_0 : natural range 0 to 1048575;
  signal fill_ends_read_words_0 : unsigned(19 downto 0);
  signal fill_step_0 : natural range 0 to 127;
  signal fill_above_read_0 : unsigned(15 downto 0);
  signal fill_above_0, fill_write_above_0 : natural range 0 to 65535;
  signal fill_out_disparity_0 : natural range 0 to 32767;
  -- median
  signal median_counter_column, median_counter_group, median_read_column, median_ready_column, median_write_column,
    median_at_column, median_comparing_column, median_sorted_column, median_beside_newest_0,
    median_beside_rows_read_newest_0, median_beside_rows_ready_words_0, median_beside_rows_ready_newest_0,
    median_beside_rows_write_words_0, median_beside_column_0 : natural range 0 to 511;
  signal median_beside_of_column_0, median_beside_in_window_0 : natural_511_1d(0 to 1);  -- _#_0
  signal median_beside_waiting_0 : natural_511_1d(0 to 2);  -- _#_0
  signal median_counter_next_frame, median_arrives, median_behind, median_line_ended, median_read_arrives,
    median_read_behind, median_read_top, median_read_bottom, median_read_output, median_ready_arrives,
    median_ready_behind, median_ready_top, median_ready_output, median_at_arrives, median_at_behind, median_at_top,
    median_at_output, median_of_column_0_b_below_a, median_of_column_0_c_below_a,
    median_of_column_0_c_below_b : boolean;
  signal median_column_passed_0 : boolean_1d(0 to 1);  -- _#_0
  signal median_comparing_arrives, median_comparing_behind, median_comparing_top, median_comparing_output,
    median_sorted_arrives, median_sorted_behind, median_sorted_top, median_sorted_output : boolean;
  signal median_passed_0 : boolean_1d(0 to 1);  -- _#_0
  signal median_window_complete, median_window_first, median_window_last, median_of_low_0_b_below_a,
    median_of_low_0_c_below_a, median_of_low_0_c_below_b, median_of_middle_0_b_below_a, median_of_middle_0_c_below_a,
    median_of_middle_0_c_below_b, median_of_high_0_b_below_a, median_of_high_0_c_below_a, median_of_high_0_c_below_b,
    median_of_all_0_b_below_a, median_of_all_0_c_below_a, median_of_all_0_c_below_b : boolean;
  signal median_waiting_complete : boolean_1d(0 to 2);  -- _#_complete
  signal median_waiting_first : boolean_1d(0 to 2);  -- _#_first
  signal median_waiting_last : boolean_1d(0 to 2);  -- _#_last
  signal median_waiting_passed_0 : boolean_1d(0 to 2);  -- _#_0
  signal median_out_passed_0, median_out_filled_0, median_out_valid, median_out_start_of_frame,
    median_out_end_of_line : boolean;
  signal median_newest_0, median_rows_read_newest_0, median_rows_ready_newest_0,
    median_column_2 : natural range 0 to 65535;
  signal median_rows_read_words_0 : unsigned(25 downto 0);
  signal median_rows_ready_words_0 : natural range 0 to 67108863;
  signal median_rows_write_words_0 : natural range 0 to 536870911;
  signal median_column_1 : natural range 0 to 8191;
  signal median_of_column_0_a, median_of_column_0_b : natural range 0 to 4095;
  signal median_of_column_0_c, median_sorted_low_0, median_sorted_middle_0,
    median_sorted_high_0 : natural range 0 to 32767;
  signal median_low_0, median_middle_0, median_high_0 : natural_32767_1d(0 to 2);  -- _#_0
  signal median_of_low_0_a, median_of_low_0_b, median_of_low_0_c, median_of_middle_0_a, median_of_middle_0_b,
    median_of_middle_0_c, median_of_high_0_a, median_of_high_0_b, median_of_high_0_c, median_largest_low_0,
    median_median_middle_0, median_smallest_high_0, median_of_all_0_a, median_of_all_0_b, median_of_all_0_c,
    median_out_disparity_0 : natural range 0 to 32767;
  signal median_beside_rows_read_words_0 : unsigned(8 downto 0);
  signal median_out_confidence_0 : natural range 0 to 255;
  -- relief
  signal relief_centre_column : natural_255_1d(0 to 4);
  signal relief_centre_grey_0, relief_before : natural range 0 to 255;
  signal relief_newest, relief_delayed_0, relief_rows_read_newest_0, relief_rows_ready_words_0,
    relief_rows_ready_newest_0, relief_rows_write_words_0, relief_shown_0, relief_column_0 : natural range 0 to 31;
  signal relief_waiting : natural_31_1d(0 to 9);
  signal relief_entering, relief_entered : natural range 0 to 31;
  signal relief_rows_read_words_0 : unsigned(4 downto 0);
  -- other
  signal other_0 : boolean;
  signal other_1 : natural range 0 to 8190;
  signal other_2 : natural range 0 to 15;
  signal other_3 : natural range 0 to 63;
  signal other_4 : natural range 0 to 254;
  signal other_5 : natural range 0 to 252;
  signal other_6 : natural range 0 to 248;
  signal other_7 : natural range 0 to 240;
  signal other_8 : natural range 0 to 224;
  signal other_9 : natural range 0 to 192;
  signal other_10 : natural range 0 to 128;

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(unsigned'(to_unsigned(median_out_confidence_0, 8) & to_unsigned(as_number(median_out_filled_0), 1) & to_unsigned(median_out_disparity_0, 15)));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(median_out_passed_0), 1));
  disparity_valid <= as_bit(median_out_valid);
  disparity_start_of_frame <= as_bit(median_out_start_of_frame);
  disparity_end_of_line <= as_bit(median_out_end_of_line);

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

  median_beside_rows_read_words_0_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(median_counter_column, 9);
    write_address <= to_unsigned(median_at_column, 9);
    write_data <= to_unsigned(median_beside_rows_write_words_0, 9);
    cell : entity work.line_memory generic map (448, 9, 9)
      port map (clock, true, read_address, median_beside_rows_read_words_0, write_address, write_data);
  end block;

  median_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(median_counter_column, 9);
    write_address <= to_unsigned(median_at_column, 9);
    write_data <= to_unsigned((median_rows_write_words_0 mod 67108864), 26);
    cell : entity work.line_memory generic map (448, 26, 9)
      port map (clock, true, read_address, median_rows_read_words_0, write_address, write_data);
  end block;

  fill_above_read_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(fill_known_at_column, 9);
    write_address <= to_unsigned(fill_write_above_column, 9);
    write_data <= to_unsigned(fill_write_above_0, 16);
    cell : entity work.line_memory generic map (448, 16, 9)
      port map (clock, true, read_address, fill_above_read_0, write_address, write_data);
  end block;

  fill_ends_read_words_0_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(fill_ends_read_place_0, 8);
    write_address <= to_unsigned(fill_ends_write_place_0, 8);
    write_data <= to_unsigned(fill_ends_write_words_0, 20);
    cell : entity work.line_memory generic map (228, 20, 8)
      port map (clock, true, read_address, fill_ends_read_words_0, write_address, write_data);
  end block;

  fill_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(18 downto 0);
  begin
    read_address <= to_unsigned(fill_counter_column, 9);
    write_address <= to_unsigned(fill_at_column, 9);
    write_data <= to_unsigned(fill_rows_write_words_0, 19);
    cell : entity work.line_memory generic map (448, 19, 9)
      port map (clock, true, read_address, fill_rows_read_words_0, write_address, write_data);
  end block;

  support_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(support_counter_column, 9);
    write_address <= to_unsigned(support_write_column, 9);
    write_data <= to_unsigned(support_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (448, 28, 9)
      port map (clock, true, read_address, support_rows_read_words_0, write_address, write_data);
  end block;

  support_rest_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(support_counter_column, 9);
    write_address <= to_unsigned(support_write_column, 9);
    write_data <= to_unsigned(support_rest_rows_write_words_0, 20);
    cell : entity work.line_memory generic map (448, 20, 9)
      port map (clock, true, read_address, support_rest_rows_read_words_0, write_address, write_data);
  end block;

  turn_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(turn_order_address, 9);
    write_address <= to_unsigned(turn_write_place, 9);
    write_data <= to_unsigned(turn_write_words_0, 20);
    cell : entity work.line_memory generic map (448, 20, 9)
      port map (clock, true, read_address, turn_read_words_0, write_address, write_data);
  end block;

  leftright_found_0_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(leftright_address_0, 7);
    write_address <= to_unsigned(leftright_position, 7);
    write_data <= to_unsigned(leftright_other_0(17), 6);
    cell : entity work.line_memory generic map (128, 6, 7)
      port map (clock, true, read_address, leftright_found_0, write_address, write_data);
  end block;

  leftright_held_1_memory : block
    signal read_address, write_address, write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(leftright_ring_read_address, 6);
    write_address <= to_unsigned(leftright_ring_write_address, 6);
    write_data <= to_unsigned(refinement_margin_0(9), 6);
    cell : entity work.line_memory generic map (64, 6, 6)
      port map (clock, true, read_address, leftright_held_1, write_address, write_data);
  end block;

  leftright_held_0_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(17 downto 0);
  begin
    read_address <= to_unsigned(leftright_ring_read_address, 6);
    write_address <= to_unsigned(leftright_ring_write_address, 6);
    write_data <= to_unsigned(refinement_fraction_0, 5) & to_unsigned(as_number(refinement_passed_0(11)), 1) &
      to_unsigned(refinement_disparity_0(11), 8) & to_unsigned(as_number(refinement_tag_end_of_line(11)), 1) &
      to_unsigned(as_number(refinement_tag_start_of_frame(11)), 1) &
      to_unsigned(as_number(refinement_tag_output_column(11)), 1) &
      to_unsigned(as_number(refinement_tag_map_column(11)), 1);
    cell : entity work.line_memory generic map (64, 18, 6)
      port map (clock, true, read_address, leftright_held_0, write_address, write_data);
  end block;

  sums_sum_delay_held_memory : for i in 15 downto 0 generate
    signal read_address, write_address : unsigned(1 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
    write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
    write_data <= to_unsigned(sums_turn_ready_sums(i), 28);
    cell : entity work.line_memory generic map (4, 28, 2)
      port map (clock, entry_tag.valid, read_address, sums_sum_delay_held(i), write_address, write_data);
  end generate;

  sums_turn_read_sums_memory : for i in 15 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
    write_address <= to_unsigned(sums_turn_write_place, 9);
    write_data <= to_unsigned(sums_turn_write_sums(i), 28);
    cell : entity work.line_memory generic map (448, 28, 9)
      port map (clock, true, read_address, sums_turn_read_sums(i), write_address, write_data);
  end generate;

  sums_turn_read_costs_6_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
    write_address <= to_unsigned(sums_turn_write_place, 9);
    write_data <= to_unsigned(sums_turn_write_costs_6, 12);
    cell : entity work.line_memory generic map (448, 12, 9)
      port map (clock, true, read_address, sums_turn_read_costs_6, write_address, write_data);
  end block;

  sums_turn_read_costs_memory : for i in 5 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
    write_address <= to_unsigned(sums_turn_write_place, 9);
    write_data <= to_unsigned(sums_turn_write_costs(i), 30);
    cell : entity work.line_memory generic map (448, 30, 9)
      port map (clock, true, read_address, sums_turn_read_costs(i), write_address, write_data);
  end generate;

  sums_turn_read_smallest_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
    write_address <= to_unsigned(sums_turn_write_place, 9);
    write_data <= to_unsigned(sums_turn_write_smallest_0, 8);
    cell : entity work.line_memory generic map (448, 8, 9)
      port map (clock, true, read_address, sums_turn_read_smallest_0, write_address, write_data);
  end block;

  forward_above_read_words_10_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(20 downto 0);
  begin
    read_address <= to_unsigned(entry_next_column, 9);
    write_address <= to_unsigned(forward_above_write_column, 9);
    write_data <= to_unsigned(forward_above_write_words_10, 21);
    cell : entity work.line_memory generic map (448, 21, 9)
      port map (clock, true, read_address, forward_above_read_words_10, write_address, write_data);
  end block;

  forward_above_read_words_memory : for i in 9 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(30 downto 0);
  begin
    read_address <= to_unsigned(entry_next_column, 9);
    write_address <= to_unsigned(forward_above_write_column, 9);
    write_data <= to_unsigned(forward_above_write_words(i), 31);
    cell : entity work.line_memory generic map (448, 31, 9)
      port map (clock, true, read_address, forward_above_read_words(i), write_address, write_data);
  end generate;

  forward_above_delay_held_10_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(20 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= ((((((to_unsigned(forward_above_total(62), 11) & to_unsigned(0, 10)) or
      (to_unsigned(forward_above_total(63), 6) & to_unsigned(0, 15)))) or (to_unsigned(forward_above_total(60), 21))))
      or (to_unsigned(forward_above_total(61), 16) & to_unsigned(0, 5)));
    cell : entity work.line_memory generic map (7, 21, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held_10, write_address, write_data);
  end block;

  forward_above_delay_held_memory : for i in 9 downto 5 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(30 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= ((((((((((to_unsigned(forward_above_total(6 * i + 4), 11) & to_unsigned(0, 20)) or
      (to_unsigned(forward_above_total(6 * i + 5), 6) & to_unsigned(0, 25)))) or (to_unsigned(forward_above_total(6 * i
      + 3), 16) & to_unsigned(0, 15)))) or (to_unsigned(forward_above_total(6 * i + 2), 21) & to_unsigned(0, 10)))) or
      (to_unsigned(forward_above_total(6 * i), 31)))) or (to_unsigned(forward_above_total(6 * i + 1), 26) &
      to_unsigned(0, 5)));
    cell : entity work.line_memory generic map (7, 31, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held(i), write_address, write_data);
  end generate;

  forward_above_delay_held_4_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(30 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= ((((((to_unsigned(forward_above_total(28), 11) & to_unsigned(0, 20)) or
      (to_unsigned(forward_above_total(29), 6) & to_unsigned(0, 25)))) or (to_unsigned(forward_above_total(26), 21) &
      to_unsigned(0, 10)))) or (to_unsigned(forward_above_total(27), 16) &
      to_unsigned(to_integer(((to_unsigned(forward_above_total(25), 6) & to_unsigned(0, 5)) or
      (to_unsigned(forward_above_total(24), 11)))), 15)));
    cell : entity work.line_memory generic map (7, 31, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held(4), write_address, write_data);
  end block;

  forward_above_delay_held_3_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(30 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= ((to_unsigned(forward_above_total(6 * i + 5), 6) &
      to_unsigned(to_integer(((to_unsigned(forward_above_total(6 * i + 2), 11) & to_unsigned(0, 10)) or
      (to_unsigned(forward_above_total(6 * i + 3), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(6 * i
      + 1), 6) & to_unsigned(0, 5)) or (to_unsigned(forward_above_total(6 * i), 11)))), 15)))), 25)) or
      (to_unsigned(forward_above_total(6 * i + 4), 11) & to_unsigned(0, 20)));
    cell : entity work.line_memory generic map (7, 31, 3)
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
    signal write_data : unsigned(4 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(relief_rows_write_words_0, 5);
    cell : entity work.line_memory generic map (450, 5, 9)
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
    variable transform_counter_group_is_equals, raster_place_group_is_equals, turn_ready_tag_row_start_is_equals,
      support_out_tag_row_start_is_equals, fill_out_tag_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_all,
      raster_place_group_differs, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less,
      delay_tag_map_column_is_not_less, delay_tag_map_column_is_less, delay_tag_first_column_is_equal,
      slice1mask_inside_0_all, slice2mask_inside_0_all, slice3mask_inside_0_all, entry_order_falls_any,
      entry_order_falls_all, entry_order_complete_all, entry_order_complete_any,
      entry_order_turned_output_column_choice, forward_left_start_cost_0_any, forward_left_start_cost_0_is_equal,
      forward_left_start_cost_0_is_less, forward_above_writes_copy_0_choice, sums_right_start_cost_0_any,
      sums_right_start_cost_0_is_equal, sums_right_start_cost_0_is_less, sums_turn_writes_copy_0_choice,
      winnersmask_inside_63_choice, winnerswinner4_best_below_0_2_value, winnerswinner5_best_above_0_1_value,
      winnerswinner6_best_below_0_0_is_equal, winnerswinner6_best_above_0_0_is_equal,
      winnerswinner6_best_at_start_0_0_choice, refinement_below_0_all, refinement_above_0_choice,
      refinement_divisor_0_0_is_less, leftright_holds_winners_choice, turn_order_falls_all, turn_order_complete_all,
      turn_ready_tag_row_start_differs, support_newest_0_value, support_moment_0_start_of_frame_choice,
      support_out_tag_row_start_differs, fill_ends_read_place_0_is_equal, fill_ends_read_place_0_choice,
      fill_out_filled_0_is_equal, fill_out_filled_0_choice, fill_out_tag_row_start_differs, fill_ends_row_place_0_all,
      fill_beside_0_left_any, median_counter_group_is_equal, median_line_ended_choice, median_window_complete_is_equal,
      median_window_complete_choice : boolean;
    variable transform_counter_group_choice, raster_place_group_choice, support_counter_group_choice,
      fill_counter_group_choice, median_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choices, raster_place_group_choices, support_counter_group_choices,
      fill_counter_group_choices, median_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice : boolean_1d(8 to 121);
    variable transform_left_filter_feature_0_choice_17,
      transform_right_filter_feature_0_choice_17 : natural range 0 to 3;
    variable transform_left_filter_feature_0_alls, transform_right_filter_feature_0_alls : boolean_1d(1 to 4);  -- _all_#
    variable transform_right_filter_feature_0_choice : boolean_1d(8 to 125);
    variable transform_counter_next_frame_choices, raster_place_next_frame_choices, support_next_tag_choices,
      fill_ends_next_place_0_choices : boolean_1d(1 to 2);  -- _choice_#
    variable slice0mask_inside_choice, slice1mask_inside_choice, slice2mask_inside_choice, slice3mask_inside_choice,
      winnerswinner2_best_at_start_0_choice : boolean_1d(0 to 15);  -- _#_choice
    variable slice0_held_0_choice, slice1_held_0_choice, slice2_held_0_choice,
      slice3_held_0_choice : natural_15_1d(0 to 15);  -- _#_choice
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 511;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 447;
    variable forward_left_pair_choice, sums_right_pair_choice : natural_127_1d(0 to 31);  -- _#_choice
    variable forward_left_start_cost_0_values, sums_right_start_cost_0_values : boolean_1d(1 to 2);  -- _value_#
    variable forward_left_start_cost_0_choice, sums_right_start_cost_0_choice : boolean_1d(4 to 6);
    variable forward_left_start_cost_0_choices, sums_right_start_cost_0_choices : natural_63_1d(7 to 9);  -- _choice_#
    variable forward_left_room_value, sums_right_room_value, leftright_address_0_value : natural range 0 to 63;
    variable forward_left_room_choices, sums_right_room_choices : natural_63_1d(1 to 3);  -- _choice_#
    variable forward_left_smallest_choice, forward_left_relief_pairs_0_choice, forward_left_relief_older_choice,
      forward_left_relief_recent_choice, forward_left_relief_largest_choice, sums_right_smallest_choice,
      sums_right_relief_pairs_0_choice, sums_right_relief_older_choice, sums_right_relief_recent_choice,
      sums_right_relief_largest_choice, relief_newest_choice_16 : natural range 0 to 31;
    variable forward_left_smallest_difference : integer range -31 to 46;
    variable forward_left_relief_reach_of_best_sum, forward_left_relief_reach_of_best_choice,
      sums_right_relief_reach_of_best_sum, sums_right_relief_reach_of_best_choice : natural range 0 to 190;
    variable forward_left_relief_reach_of_best_choices, sums_right_relief_reach_of_best_choices,
      fill_ends_read_place_0_choices : natural_255_1d(2 to 3);  -- _choice_#
    variable forward_left_relief_leaves_choice, sums_right_relief_leaves_choice : natural range 64 to 127;
    variable forward_left_g_copy_0_value, forward_left_g_less_copy_0_value, sums_right_g_copy_0_value,
      sums_right_g_less_copy_0_value : natural range 0 to 127;
    variable forward_left_cost_choice, forward_left_arrived_choice, sums_right_cost_choice,
      sums_right_arrived_choice : natural_127_2d(0 to 63, 1 to 2);  -- _#_choice_#
    variable forward_above_total_choice : natural_31_1d(0 to 63);  -- _#_choice
    variable forward_above_write_words_choice : natural_36_2d(0 to 10, 1 to 6);  -- _#_choice_#
    variable sums_right_smallest_difference : integer range -31 to 31;
    variable sums_turn_waiting_read_place_choices : natural_511_1d(1 to 2);  -- _choice_#
    variable winnersother_cost_0_is_equal : boolean_1d(1 to 61);  -- _#_is_equal
    variable winnersother_cost_0_value : boolean_2d(1 to 62, 1 to 6);  -- _#_value_#
    variable winnersother_cost_0_choice : boolean_2d(1 to 62, 7 to 9);  -- _#_choice_#
    variable winnersother_cost_0_all : boolean_1d(1 to 63);  -- _#_all
    variable winnersother_winner_0_0_values : boolean_1d(1 to 6);  -- _value_#
    variable winnersother_winner_0_0_choice, winnerswinner6_best_index_0_0_choice : boolean_1d(7 to 8);
    variable winnerswinner1_best_index_0_choice_8 : boolean_1d(0 to 31);  -- _#_choice_8
    variable winnerswinner1_best_index_0_31_values, winnerswinner6_best_index_0_0_values,
      relief_newest_values : boolean_1d(1 to 5);  -- _value_#
    variable winnerswinner2_best_index_0_value : boolean_2d(0 to 15, 1 to 5);  -- _#_value_#
    variable winnerswinner2_best_index_0_choice : boolean_2d(0 to 15, 7 to 8);  -- _#_choice_#
    variable winnerswinner2_best_below_0_is_equal : boolean_1d(0 to 15);  -- _#_is_equal
    variable winnerswinner2_best_below_0_choice, winnerswinner2_best_above_0_choice : natural_255_1d(0 to 15);  -- _#_choice
    variable winnerswinner2_best_below_0_value : boolean_2d(4 to 14, 1 to 2);  -- _#_value_#
    variable winnerswinner2_best_second_0_choice : natural_255_2d(0 to 15, 1 to 4);  -- _#_choice_#
    variable winnerswinner3_best_index_0_value : boolean_2d(0 to 7, 1 to 5);  -- _#_value_#
    variable winnerswinner3_best_index_0_choice : boolean_2d(0 to 7, 7 to 8);  -- _#_choice_#
    variable winnerswinner3_best_below_0_is_equal, winnerswinner3_best_above_0_is_equal : boolean_1d(0 to 7);  -- _#_is_equal
    variable winnerswinner3_best_below_0_choice, winnerswinner3_best_above_0_choice : natural_255_1d(0 to 7);  -- _#_choice
    variable winnerswinner3_best_below_0_value : boolean_1d(2 to 6);  -- _#_value
    variable winnerswinner3_best_above_0_value : boolean_2d(2 to 7, 1 to 2);  -- _#_value_#
    variable winnerswinner3_best_at_start_0_choice : boolean_1d(0 to 7);  -- _#_choice
    variable winnerswinner3_best_second_0_choice : natural_255_2d(0 to 7, 1 to 4);  -- _#_choice_#
    variable winnerswinner4_best_index_0_value : boolean_2d(0 to 3, 1 to 5);  -- _#_value_#
    variable winnerswinner4_best_index_0_choice : boolean_2d(0 to 3, 7 to 8);  -- _#_choice_#
    variable winnerswinner4_best_below_0_is_equal, winnerswinner4_best_above_0_is_equal : boolean_1d(0 to 3);  -- _#_is_equal
    variable winnerswinner4_best_below_0_choice, winnerswinner4_best_above_0_choice : natural_255_1d(0 to 3);  -- _#_choice
    variable winnerswinner4_best_above_0_value : boolean_2d(1 to 3, 1 to 2);  -- _#_value_#
    variable winnerswinner4_best_at_start_0_choice : boolean_1d(0 to 3);  -- _#_choice
    variable winnerswinner4_best_second_0_choice : natural_255_2d(0 to 3, 1 to 4);  -- _#_choice_#
    variable winnerswinner5_best_index_0_value : boolean_2d(0 to 1, 1 to 5);  -- _#_value_#
    variable winnerswinner5_best_index_0_choice : boolean_2d(0 to 1, 7 to 8);  -- _#_choice_#
    variable winnerswinner5_best_below_0_is_equal, winnerswinner5_best_above_0_is_equal : boolean_1d(0 to 1);  -- _#_is_equal
    variable winnerswinner5_best_below_0_choice, winnerswinner5_best_above_0_choice : natural_255_1d(0 to 1);  -- _#_choice
    variable winnerswinner5_best_at_start_0_choice : boolean_1d(0 to 1);  -- _#_choice
    variable winnerswinner5_best_second_0_choice : natural_255_2d(0 to 1, 1 to 4);  -- _#_choice_#
    variable winnerswinner6_best_below_0_0_choice, winnerswinner6_best_above_0_0_choice, refinement_divisor_0_0_choice,
      refinement_fraction_0_choice, support_out_sure_0_choice, fill_takes_left_0_choice : natural range 0 to 255;
    variable winnerswinner6_best_second_0_0_choices : natural_255_1d(1 to 4);  -- _choice_#
    variable winners_partner_at_sum : natural range 1 to 512;
    variable winners_partner_at_choice : natural range 0 to 512;
    variable refinement_below_0_differss : boolean_1d(1 to 2);  -- _differs_#
    variable refinement_remainder_1_0_difference : natural range 257 to 767;
    variable refinement_remainder_0_difference : natural_257_to_1022_1d(2 to 7);  -- _#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable leftright_checked_passed_0_difference : integer range -62 to 64;
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
    variable turn_ready_tag_row_start_choices, support_out_tag_row_start_choices,
      fill_out_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable turn_ready_tag_row_start_alls, support_out_tag_row_start_alls, fill_out_disparity_0_alls,
      fill_out_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable support_column_choice : natural_63_to_127_1d(0 to 4);  -- _#_choice
    variable support_like_0_0_0_difference : integer range -62 to 1;
    variable support_like_0_value : natural_127_2d(0 to 6, 0 to 4);  -- _#_#_value
    variable support_like_0_0_choice : boolean_1d(0 to 6);  -- _#_0_choice
    variable support_like_0_1_differs : boolean_1d(0 to 6);  -- _#_1_differs
    variable fill_takes_left_0_choice_2 : natural range 0 to 511;
    variable fill_out_disparity_0_choice : natural range 0 to 1023;
    variable fill_out_disparity_0_choice_2, median_of_column_0_c_choice, median_low_0_0_choice,
      median_middle_0_0_choice, median_high_0_0_choice : natural range 0 to 32767;
    variable fill_write_above_0_choice : natural range 0 to 65535;
    variable median_of_column_0_a_choice : natural range 0 to 4095;
    variable median_sorted_low_0_choices, median_sorted_middle_0_choices, median_sorted_high_0_choices,
      median_largest_low_0_choices, median_smallest_high_0_choices : natural_32767_1d(1 to 2);  -- _choice_#
    variable median_median_middle_0_choices, median_out_disparity_0_choices : natural_32767_1d(1 to 4);  -- _choice_#
    variable median_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
    variable relief_newest_choice : boolean_1d(7 to 15);
    variable relief_newest_values_from_6 : natural_255_1d(6 to 7);  -- _value_#
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    forward_above_write_words_choice := (others => (others => 0));
    forward_left_arrived_choice := (others => (others => 0)); sums_right_arrived_choice := (others => (others => 0));
    support_like_0_0_choice := (others => false); support_like_0_1_differs := (others => false);
    transform_left_filter_feature_0_choice := (others => false);
    transform_right_filter_feature_0_choice := (others => false); winnersother_cost_0_is_equal := (others => false);
    winnersother_cost_0_value := (others => (others => false));
    winnerswinner2_best_below_0_is_equal := (others => false);
    winnerswinner2_best_below_0_value := (others => (others => false));
    winnerswinner3_best_above_0_is_equal := (others => false);
    winnerswinner3_best_above_0_value := (others => (others => false));
    winnerswinner3_best_below_0_is_equal := (others => false); winnerswinner3_best_below_0_value := (others => false);
    winnerswinner4_best_above_0_is_equal := (others => false);
    winnerswinner4_best_above_0_value := (others => (others => false));
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
    transform_left_filter_feature_0_values(1) := is_set(transform_left_filter_column(4, 1), 1);
    transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_values(1)) or (not
      is_set(transform_left_filter_column(4, 1), 0));
    transform_left_filter_feature_0_is_equal := (transform_left_filter_column(4, 1) mod 4) = 0;
    for i in 2 to 6 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(4, 1), i);
    end loop;
    transform_left_filter_feature_0_choice(8) := is_larger(transform_left_filter_column(4, 0),
      transform_left_filter_column(4, 1), 0, 7, false);
    transform_left_filter_feature_0_choice(16) := is_larger(transform_left_filter_column(4, 2),
      transform_left_filter_column(4, 1), 0, 7, false);
    transform_left_filter_feature_0_choice_17 := choice(transform_filtering_0_column_inside(2),
      as_number(transform_left_filter_feature_0_choice(8)) + (as_number(transform_left_filter_feature_0_choice(16)) *
      2), 0);
    transform_left_filter_feature_0_choice(24) := not is_larger(transform_left_filter_column(0, 1),
      transform_left_filter_column(4, 1), 0, 6, false);
    transform_left_filter_feature_0_alls(1) := transform_filtering_0_column_inside(0) and (not
      is_set(transform_left_filter_column(4, 1), 7));
    transform_left_filter_feature_0_choice(25) := choice(is_set(transform_left_filter_column(0, 1), 7),
      transform_filtering_0_column_inside(0), transform_left_filter_feature_0_alls(1));
    transform_left_filter_feature_0_choice(26) := choice(transform_left_filter_feature_0_choice(24),
      is_set(transform_left_filter_column(0, 1), 7) and transform_filtering_0_column_inside(0) and (not
      is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(25));
    transform_left_filter_feature_0_choice(27) := choice(is_set(transform_left_filter_column(0, 0), 0),
      (transform_left_filter_column(4, 1) mod 4) = 3, transform_left_filter_feature_0_values(1));
    transform_left_filter_feature_0_choice(28) := choice(is_set(transform_left_filter_column(0, 0), 1),
      transform_left_filter_feature_0_choice(27), (not is_set(transform_left_filter_column(0, 0), 0)) or
      transform_left_filter_feature_0_values(1) or is_set(transform_left_filter_column(4, 1), 0));
    transform_left_filter_feature_0_values(7) := is_set(transform_left_filter_column(0, 0), 2);
    transform_left_filter_feature_0_choice(29) := inverted_carry(transform_left_filter_feature_0_choice(28),
      transform_left_filter_feature_0_values(7), not transform_left_filter_feature_0_values(2));
    for i in 8 to 11 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(0, 0), i - 5);
      transform_left_filter_feature_0_choice(i + 22) := carry(transform_left_filter_feature_0_choice(i + 21),
        transform_left_filter_feature_0_values(i), not transform_left_filter_feature_0_values(i - 5));
    end loop;
    transform_left_filter_feature_0_choice(34) := choice(is_set(transform_left_filter_column(0, 0), 7),
      transform_filtering_0_column_inside(0), transform_left_filter_feature_0_alls(1));
    transform_left_filter_feature_0_choice(35) := choice(transform_left_filter_feature_0_choice(33),
      transform_left_filter_feature_0_choice(34), is_set(transform_left_filter_column(0, 0), 7) and
      transform_filtering_0_column_inside(0) and (not is_set(transform_left_filter_column(4, 1), 7)));
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(26 * i + 42) := not is_larger(transform_left_filter_column(2 * i, 2),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_choice(26 * i + 43) := choice(transform_left_filter_feature_0_choice(26 * i +
        42), transform_filtering_0_column_inside(i) and is_set(transform_left_filter_column(2 * i, 2), 7) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(i) and
        (is_set(transform_left_filter_column(2 * i, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
      transform_left_filter_feature_0_choice(26 * i + 50) := not is_larger(transform_left_filter_column(4 * i + 2, 1),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_alls(i + 2) := transform_filtering_0_column_inside(2 * i + 1) and (not
        is_set(transform_left_filter_column(4, 1), 7));
      transform_left_filter_feature_0_choice(26 * i + 51) := choice(is_set(transform_left_filter_column(4 * i + 2, 1),
        7), transform_filtering_0_column_inside(2 * i + 1), transform_left_filter_feature_0_alls(i + 2));
      transform_left_filter_feature_0_choice(26 * i + 52) := choice(transform_left_filter_feature_0_choice(26 * i +
        50), is_set(transform_left_filter_column(4 * i + 2, 1), 7) and transform_filtering_0_column_inside(2 * i + 1)
        and (not is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(26 * i + 51));
      transform_left_filter_feature_0_choice(26 * i + 59) := not is_larger(transform_left_filter_column(4 * i + 2, 0),
        transform_left_filter_column(4, 1), 0, 6, false);
      transform_left_filter_feature_0_choice(26 * i + 60) := choice(is_set(transform_left_filter_column(4 * i + 2, 0),
        7), transform_filtering_0_column_inside(2 * i + 1), transform_left_filter_feature_0_alls(i + 2));
      transform_left_filter_feature_0_choice(26 * i + 61) := choice(transform_left_filter_feature_0_choice(26 * i +
        59), is_set(transform_left_filter_column(4 * i + 2, 0), 7) and transform_filtering_0_column_inside(2 * i + 1)
        and (not is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(26 * i + 60));
    end loop;
    transform_left_filter_feature_0_choice(94) := not is_larger(transform_left_filter_column(6, 2),
      transform_left_filter_column(4, 1), 0, 6, false);
    transform_left_filter_feature_0_choice(95) := choice(transform_left_filter_feature_0_choice(94),
      transform_filtering_0_column_inside(3) and is_set(transform_left_filter_column(6, 2), 7) and (not
      is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(3) and
      (is_set(transform_left_filter_column(6, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
    transform_left_filter_feature_0_choice(102) := not is_larger(transform_left_filter_column(8, 1),
      transform_left_filter_column(4, 1), 0, 6, false);
    transform_left_filter_feature_0_alls(4) := transform_filtering_0_column_inside(4) and (not
      is_set(transform_left_filter_column(4, 1), 7));
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(9 * i + 103) := choice(is_set(transform_left_filter_column(8, 1 - i), 7),
        transform_filtering_0_column_inside(4), transform_left_filter_feature_0_alls(4));
      transform_left_filter_feature_0_choice(9 * i + 104) := choice(transform_left_filter_feature_0_choice(9 * i +
        102), is_set(transform_left_filter_column(8, 1 - i), 7) and transform_filtering_0_column_inside(4) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(9 * i + 103));
      transform_left_filter_feature_0_choice(9 * i + 111) := not is_larger(transform_left_filter_column(8, 2 * i),
        transform_left_filter_column(4, 1), 0, 6, false);
    end loop;
    transform_left_filter_feature_0_choice(121) := choice(transform_left_filter_feature_0_choice(120),
      transform_filtering_0_column_inside(4) and is_set(transform_left_filter_column(8, 2), 7) and (not
      is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(4) and
      (is_set(transform_left_filter_column(8, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
    transform_right_filter_feature_0_values(1) := is_set(transform_right_filter_column(4, 1), 1);
    transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_values(1)) or (not
      is_set(transform_right_filter_column(4, 1), 0));
    transform_right_filter_feature_0_is_equal := (transform_right_filter_column(4, 1) mod 4) = 0;
    for i in 2 to 6 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(4, 1), i);
    end loop;
    transform_right_filter_feature_0_choice(8) := is_larger(transform_right_filter_column(4, 0),
      transform_right_filter_column(4, 1), 0, 7, false);
    transform_right_filter_feature_0_choice(16) := is_larger(transform_right_filter_column(4, 2),
      transform_right_filter_column(4, 1), 0, 7, false);
    transform_right_filter_feature_0_choice_17 := choice(transform_filtering_0_column_inside(2),
      as_number(transform_right_filter_feature_0_choice(8)) + (as_number(transform_right_filter_feature_0_choice(16)) *
      2), 0);
    transform_right_filter_feature_0_choice(24) := not is_larger(transform_right_filter_column(0, 1),
      transform_right_filter_column(4, 1), 0, 6, false);
    transform_right_filter_feature_0_alls(1) := transform_filtering_0_column_inside(0) and (not
      is_set(transform_right_filter_column(4, 1), 7));
    transform_right_filter_feature_0_choice(25) := choice(is_set(transform_right_filter_column(0, 1), 7),
      transform_filtering_0_column_inside(0), transform_right_filter_feature_0_alls(1));
    transform_right_filter_feature_0_choice(26) := choice(transform_right_filter_feature_0_choice(24),
      is_set(transform_right_filter_column(0, 1), 7) and transform_filtering_0_column_inside(0) and (not
      is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(25));
    transform_right_filter_feature_0_choice(27) := choice(is_set(transform_right_filter_column(0, 0), 0),
      (transform_right_filter_column(4, 1) mod 4) = 3, transform_right_filter_feature_0_values(1));
    transform_right_filter_feature_0_choice(28) := choice(is_set(transform_right_filter_column(0, 0), 1),
      transform_right_filter_feature_0_choice(27), (not is_set(transform_right_filter_column(0, 0), 0)) or
      transform_right_filter_feature_0_values(1) or is_set(transform_right_filter_column(4, 1), 0));
    transform_right_filter_feature_0_values(7) := is_set(transform_right_filter_column(0, 0), 2);
    transform_right_filter_feature_0_choice(29) := inverted_carry(transform_right_filter_feature_0_choice(28),
      transform_right_filter_feature_0_values(7), not transform_right_filter_feature_0_values(2));
    for i in 8 to 11 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(0, 0), i - 5);
      transform_right_filter_feature_0_choice(i + 22) := carry(transform_right_filter_feature_0_choice(i + 21),
        transform_right_filter_feature_0_values(i), not transform_right_filter_feature_0_values(i - 5));
    end loop;
    transform_right_filter_feature_0_choice(34) := choice(is_set(transform_right_filter_column(0, 0), 7),
      transform_filtering_0_column_inside(0), transform_right_filter_feature_0_alls(1));
    transform_right_filter_feature_0_choice(35) := choice(transform_right_filter_feature_0_choice(33),
      transform_right_filter_feature_0_choice(34), is_set(transform_right_filter_column(0, 0), 7) and
      transform_filtering_0_column_inside(0) and (not is_set(transform_right_filter_column(4, 1), 7)));
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(27 * i + 42) := not is_larger(transform_right_filter_column(2 * i, 2),
        transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_choice(27 * i + 43) := choice(is_set(transform_right_filter_column(2 * i, 2),
        7), transform_filtering_0_column_inside(i), transform_right_filter_feature_0_alls(i + 1));
      transform_right_filter_feature_0_choice(27 * i + 44) := choice(transform_right_filter_feature_0_choice(27 * i +
        42), is_set(transform_right_filter_column(2 * i, 2), 7) and transform_filtering_0_column_inside(i) and (not
        is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(27 * i + 43));
      transform_right_filter_feature_0_choice(27 * i + 51) := not is_larger(transform_right_filter_column(4 * i + 2,
        1), transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_alls(i + 2) := transform_filtering_0_column_inside(2 * i + 1) and (not
        is_set(transform_right_filter_column(4, 1), 7));
      transform_right_filter_feature_0_choice(27 * i + 52) := choice(is_set(transform_right_filter_column(4 * i + 2,
        1), 7), transform_filtering_0_column_inside(2 * i + 1), transform_right_filter_feature_0_alls(i + 2));
      transform_right_filter_feature_0_choice(27 * i + 53) := choice(transform_right_filter_feature_0_choice(27 * i +
        51), is_set(transform_right_filter_column(4 * i + 2, 1), 7) and transform_filtering_0_column_inside(2 * i + 1)
        and (not is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(27 * i + 52));
      transform_right_filter_feature_0_choice(27 * i + 60) := not is_larger(transform_right_filter_column(4 * i + 2,
        0), transform_right_filter_column(4, 1), 0, 6, false);
      transform_right_filter_feature_0_choice(27 * i + 61) := choice(is_set(transform_right_filter_column(4 * i + 2,
        0), 7), transform_filtering_0_column_inside(2 * i + 1), transform_right_filter_feature_0_alls(i + 2));
      transform_right_filter_feature_0_choice(27 * i + 62) := choice(transform_right_filter_feature_0_choice(27 * i +
        60), is_set(transform_right_filter_column(4 * i + 2, 0), 7) and transform_filtering_0_column_inside(2 * i + 1)
        and (not is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(27 * i + 61));
    end loop;
    transform_right_filter_feature_0_choice(96) := not is_larger(transform_right_filter_column(6, 2),
      transform_right_filter_column(4, 1), 0, 6, false);
    transform_right_filter_feature_0_choice(97) := choice(is_set(transform_right_filter_column(6, 2), 7),
      transform_filtering_0_column_inside(3), transform_right_filter_feature_0_alls(3));
    transform_right_filter_feature_0_choice(98) := choice(transform_right_filter_feature_0_choice(96),
      is_set(transform_right_filter_column(6, 2), 7) and transform_filtering_0_column_inside(3) and (not
      is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(97));
    transform_right_filter_feature_0_choice(105) := not is_larger(transform_right_filter_column(8, 1),
      transform_right_filter_column(4, 1), 0, 6, false);
    transform_right_filter_feature_0_alls(4) := transform_filtering_0_column_inside(4) and (not
      is_set(transform_right_filter_column(4, 1), 7));
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(9 * i + 106) := choice(is_set(transform_right_filter_column(8, 1 - i),
        7), transform_filtering_0_column_inside(4), transform_right_filter_feature_0_alls(4));
      transform_right_filter_feature_0_choice(9 * i + 107) := choice(transform_right_filter_feature_0_choice(9 * i +
        105), is_set(transform_right_filter_column(8, 1 - i), 7) and transform_filtering_0_column_inside(4) and (not
        is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(9 * i + 106));
      transform_right_filter_feature_0_choice(9 * i + 114) := not is_larger(transform_right_filter_column(8, 2 * i),
        transform_right_filter_column(4, 1), 0, 6, false);
    end loop;
    transform_right_filter_feature_0_choice(124) := choice(is_set(transform_right_filter_column(8, 2), 7),
      transform_filtering_0_column_inside(4), transform_right_filter_feature_0_alls(4));
    transform_right_filter_feature_0_choice(125) := choice(transform_right_filter_feature_0_choice(123),
      is_set(transform_right_filter_column(8, 2), 7) and transform_filtering_0_column_inside(4) and (not
      is_set(transform_right_filter_column(4, 1), 7)), transform_right_filter_feature_0_choice(124));
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
    delay_tag_map_column_is_not_less := raster_place_column >= 1;
    delay_tag_map_column_is_less := raster_place_column < 449;
    delay_tag_first_column_is_equal := raster_place_column = 1;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 375;
    delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
    delay_row_inside(2) <= raster_place_group < 375;
    delay_tag.valid <= raster_features_valid;
    delay_tag.map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.output_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less and
      delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
    delay_tag.first_column <= delay_tag_first_column_is_equal;
    delay_tag.start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 1);
    delay_tag.end_of_line <= raster_place_column = 448;
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
    for i in 0 to 15 loop slice0cost_column_0(i) <= slice0cost_pair_0(i) + slice0cost_single_0(i); end loop;
    slice0cost_tag <= slice0cost_pair_tag;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_partial_0_0 <= slice0cost_column_0;
      for i in 0 to 15 loop
        slice0window_partial_0_1(i) <= slice0cost_column_0(i) + slice0window_partial_0_0(i);
      end loop;
      slice0window_centre_map_column_0 <= slice0cost_tag.map_column;
      slice0window_centre_output_column_0 <= slice0cost_tag.output_column;
      slice0window_centre_first_column_0 <= slice0cost_tag.first_column;
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
    -- slice0mask
    slice0mask_inside_choice(0) := choice(slice0cost_tag.valid, slice0window_centre_first_column_0,
      slice0mask_inside(0));
    for i in 1 to 15 loop
      slice0mask_inside_choice(i) := choice(slice0cost_tag.valid, slice0mask_inside(i - 1), slice0mask_inside(i));
    end loop;
    slice0mask_left_out <= slice0mask_inside(15);
    slice0mask_inside(0) <= choice(slice0mask_column < 447, slice0cost_tag.valid or slice0mask_inside(0),
      slice0mask_inside_choice(0));
    for i in 1 to 15 loop
      slice0mask_inside(i) <= choice(slice0window_centre_first_column_0, (not slice0cost_tag.valid) and
        slice0mask_inside(i), slice0mask_inside_choice(i));
    end loop;
    if slice0cost_tag.valid then
      slice0mask_column <= choice(slice0window_centre_first_column_0, 0, (slice0mask_column + 1) mod 512);
    end if;
    -- slice0
    for i in 0 to 15 loop
      slice0_held_0_choice(i) := choice((not is_set(slice0window_sum_0(i), 6)) and ((not is_set(slice0window_sum_0(i),
        5)) or (not is_set(slice0window_sum_0(i), 4)) or (not is_set(slice0window_sum_0(i), 3))), slice0window_sum_0(i)
        / 8, 6);
    end loop;
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
    for i in 0 to 15 loop slice0_held(0, i) <= choice(slice0mask_inside(i), slice0_held_0_choice(i), 3); end loop;
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
    for i in 0 to 15 loop slice1cost_column_0(i) <= slice1cost_pair_0(i) + slice1cost_single_0(i); end loop;
    slice1cost_tag_first_column <= slice0cost_tag.first_column;
    -- slice1window
    if slice0window_tag.valid then
      slice1window_partial_0_0 <= slice1cost_column_0;
      for i in 0 to 15 loop
        slice1window_partial_0_1(i) <= slice1cost_column_0(i) + slice1window_partial_0_0(i);
      end loop;
      slice1window_centre_first_column_0 <= slice1cost_tag_first_column;
    end if;
    for i in 0 to 15 loop slice1window_sum_0(i) <= slice1cost_column_0(i) + slice1window_partial_0_1(i); end loop;
    if slice0_tag_valid(0) then slice1window_tag_first_column <= slice2cost_tag_first_column; end if;
    -- slice1mask
    slice1mask_inside_0_all := (not slice0window_tag.valid) and slice1mask_inside(0);
    slice1mask_inside_choice(0) := choice(slice1window_centre_first_column_0, slice1mask_inside_0_all,
      slice0window_tag.valid or slice1mask_inside(0));
    for i in 1 to 15 loop
      slice1mask_inside_choice(i) := choice(slice0window_tag.valid, slice1mask_inside(i - 1), slice1mask_inside(i));
    end loop;
    slice1mask_left_out <= slice1mask_inside(15);
    slice1mask_inside(0) <= choice(slice0mask_left_out, slice1mask_inside_choice(0), slice1mask_inside_0_all);
    for i in 1 to 15 loop
      slice1mask_inside(i) <= choice(slice1window_centre_first_column_0, (not slice0window_tag.valid) and
        slice1mask_inside(i), slice1mask_inside_choice(i));
    end loop;
    -- slice1
    for i in 0 to 15 loop
      slice1_held_0_choice(i) := choice((not is_set(slice1window_sum_0(i), 6)) and ((not is_set(slice1window_sum_0(i),
        5)) or (not is_set(slice1window_sum_0(i), 4)) or (not is_set(slice1window_sum_0(i), 3))), slice1window_sum_0(i)
        / 8, 6);
    end loop;
    for i in 0 to 15 loop slice1_held(1, i) <= slice1_held(0, i); end loop;
    for i in 0 to 15 loop slice1_held(2, i) <= slice1_held(1, i); end loop;
    for i in 0 to 15 loop slice1_held(0, i) <= choice(slice1mask_inside(i), slice1_held_0_choice(i), 3); end loop;
    if slice0_tag_valid(1) then slice1_tag_0_first_column <= slice2window_centre_first_column_0; end if;
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
    for i in 0 to 15 loop slice2cost_column_0(i) <= slice2cost_pair_0(i) + slice2cost_single_0(i); end loop;
    slice2cost_tag_first_column <= slice1cost_tag_first_column;
    -- slice2window
    if slice0_tag_valid(0) then
      slice2window_partial_0_0 <= slice2cost_column_0;
      for i in 0 to 15 loop
        slice2window_partial_0_1(i) <= slice2cost_column_0(i) + slice2window_partial_0_0(i);
      end loop;
    end if;
    slice2window_centre_first_column_0 <= slice2cost_tag_first_column;
    for i in 0 to 15 loop slice2window_sum_0(i) <= slice2cost_column_0(i) + slice2window_partial_0_1(i); end loop;
    -- slice2mask
    slice2mask_inside_0_all := (not slice0_tag_valid(0)) and slice2mask_inside(0);
    slice2mask_inside_choice(0) := choice(slice1window_tag_first_column, slice2mask_inside_0_all, slice0_tag_valid(0)
      or slice2mask_inside(0));
    for i in 1 to 15 loop
      slice2mask_inside_choice(i) := choice(slice0_tag_valid(0), slice2mask_inside(i - 1), slice2mask_inside(i));
    end loop;
    slice2mask_left_out <= slice2mask_inside(15);
    slice2mask_inside(0) <= choice(slice1mask_left_out, slice2mask_inside_choice(0), slice2mask_inside_0_all);
    for i in 1 to 15 loop
      slice2mask_inside(i) <= choice(slice1window_tag_first_column, (not slice0_tag_valid(0)) and slice2mask_inside(i),
        slice2mask_inside_choice(i));
    end loop;
    -- slice2
    for i in 0 to 15 loop
      slice2_held_0_choice(i) := choice((not is_set(slice2window_sum_0(i), 6)) and ((not is_set(slice2window_sum_0(i),
        5)) or (not is_set(slice2window_sum_0(i), 4)) or (not is_set(slice2window_sum_0(i), 3))), slice2window_sum_0(i)
        / 8, 6);
    end loop;
    for i in 0 to 15 loop slice2_held(1, i) <= slice2_held(0, i); end loop;
    for i in 0 to 15 loop slice2_held(0, i) <= choice(slice2mask_inside(i), slice2_held_0_choice(i), 3); end loop;
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
    for i in 0 to 15 loop slice3cost_column_0(i) <= slice3cost_pair_0(i) + slice3cost_single_0(i); end loop;
    -- slice3window
    if slice0_tag_valid(1) then
      slice3window_partial_0_0 <= slice3cost_column_0;
      for i in 0 to 15 loop
        slice3window_partial_0_1(i) <= slice3cost_column_0(i) + slice3window_partial_0_0(i);
      end loop;
    end if;
    for i in 0 to 15 loop slice3window_sum_0(i) <= slice3cost_column_0(i) + slice3window_partial_0_1(i); end loop;
    -- slice3mask
    slice3mask_inside_0_all := (not slice0_tag_valid(1)) and slice3mask_inside(0);
    slice3mask_inside_choice(0) := choice(slice1_tag_0_first_column, slice3mask_inside_0_all, slice0_tag_valid(1) or
      slice3mask_inside(0));
    for i in 1 to 15 loop
      slice3mask_inside_choice(i) := choice(slice0_tag_valid(1), slice3mask_inside(i - 1), slice3mask_inside(i));
    end loop;
    slice3mask_inside(0) <= choice(slice2mask_left_out, slice3mask_inside_choice(0), slice3mask_inside_0_all);
    for i in 1 to 15 loop
      slice3mask_inside(i) <= choice(slice1_tag_0_first_column, (not slice0_tag_valid(1)) and slice3mask_inside(i),
        slice3mask_inside_choice(i));
    end loop;
    -- slice3
    for i in 0 to 15 loop
      slice3_held_0_choice(i) := choice((not is_set(slice3window_sum_0(i), 6)) and ((not is_set(slice3window_sum_0(i),
        5)) or (not is_set(slice3window_sum_0(i), 4)) or (not is_set(slice3window_sum_0(i), 3))), slice3window_sum_0(i)
        / 8, 6);
    end loop;
    for i in 0 to 15 loop slice3_held_0(i) <= choice(slice3mask_inside(i), slice3_held_0_choice(i), 3); end loop;
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
    entry_order_address_choice_2 := choice(entry_order_falls, 0, 447);
    if not entry_order_complete_any then
      entry_order_address <= choice(entry_order_falls_any, (entry_order_address_choice + entry_order_address) mod 512,
        entry_order_address_choice_2);
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
    forward_left_start_cost_0_choice(4) := not is_larger(forward_left_relief_largest, forward_left_room, 0, 3, false);
    forward_left_start_cost_0_is_equal := (forward_left_room / 16) = 0;
    forward_left_start_cost_0_choice(5) := choice(is_set(forward_left_relief_largest, 4), not is_set(forward_left_room,
      5), forward_left_start_cost_0_is_equal);
    forward_left_start_cost_0_choice(6) := choice(forward_left_start_cost_0_choice(4),
      is_set(forward_left_relief_largest, 4) and forward_left_start_cost_0_is_equal,
      forward_left_start_cost_0_choice(5));
    forward_left_start_cost_0_choices(7) := choice(forward_left_start_cost_0_choice(6), 0, (forward_left_room -
      forward_left_relief_largest) mod 64);
    forward_left_start_cost_0_is_less := 127 < ((forward_left_tree_next_next_next_next_smallest_0 mod 64) +
      forward_left_relief_reach_of_best);
    forward_left_start_cost_0_choices(8) := choice(forward_left_start_cost_0_is_less,
      (forward_left_tree_next_next_next_next_smallest_0 + forward_left_relief_reach_of_best) mod 64, 0);
    forward_left_start_cost_0_choices(9) := choice(forward_left_start_cost_0_any, forward_left_start_cost_0_choices(7),
      forward_left_start_cost_0_choices(8));
    forward_left_room_value := (forward_left_start_cost(8) + forward_left_room) mod 64;
    forward_left_room_choices(1) := choice(forward_left_start_cost_0_choice(6), forward_left_room_value,
      (forward_left_start_cost(8) + forward_left_relief_largest) mod 64);
    forward_left_room_choices(2) := choice(forward_left_start_cost_0_is_less, (forward_left_relief_room_of_best -
      forward_left_tree_next_next_next_next_smallest_0) mod 64, forward_left_room_value);
    forward_left_room_choices(3) := choice(forward_left_start_cost_0_any, forward_left_room_choices(1),
      forward_left_room_choices(2));
    forward_left_smallest_choice := choice(sums_turn_waiting_first(5), 0, forward_reliefs_moved(5));
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
    forward_left_relief_reach_of_best_choice := choice(forward_left_start_cost_0_choice(6),
      forward_left_relief_reach_of_best_sum, forward_left_relief_largest + forward_left_relief_leaves);
    forward_left_relief_reach_of_best_choices(2) := choice(forward_left_start_cost_0_is_less,
      (forward_left_relief_reach_again - (forward_left_tree_next_next_next_next_smallest_0 mod 64)) mod 256,
      forward_left_relief_reach_of_best_sum);
    forward_left_relief_reach_of_best_choices(3) := choice(forward_left_start_cost_0_any,
      forward_left_relief_reach_of_best_choice, forward_left_relief_reach_of_best_choices(2));
    forward_left_relief_leaves_choice := choice(sums_turn_waiting_first(5), 64, forward_left_start_cost(7) + 64);
    forward_left_g_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest) mod 128;
    forward_left_g_less_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest_less) mod 128;
    for i in 0 to 63 loop
      forward_left_cost_choice(i, 1) := smaller(forward_left_arrived(i), forward_left_cost(i));
      forward_left_cost_choice(i, 2) := choice(is_set(forward_left_cost_choice(i, 1), 6) or forward_first(8), 64,
        forward_left_cost_choice(i, 1));
    end loop;
    forward_left_arrived_choice(0, 1) := choice(forward_first(8), 64, forward_left_cost(1));
    for i in 0 to 14 loop
      forward_left_arrived_choice(4 * i + 1, 1) := choice(forward_first(8), 64, forward_left_pair_choice(2 * i));
      forward_left_arrived_choice(4 * i + 2, 1) := choice(forward_first(8), 64, forward_left_pair_choice(2 * i + 1));
      forward_left_arrived_choice(4 * i + 3, 1) := smaller(forward_left_cost(4 * i + 4), forward_left_cost(4 * i + 2));
      forward_left_arrived_choice(4 * i + 3, 2) := choice(forward_first(8), 64, forward_left_arrived_choice(4 * i + 3,
        1));
      forward_left_arrived_choice(4 * i + 4, 1) := smaller(forward_left_cost(4 * i + 5), forward_left_cost(4 * i + 3));
      forward_left_arrived_choice(4 * i + 4, 2) := choice(forward_first(8), 64, forward_left_arrived_choice(4 * i + 4,
        1));
    end loop;
    forward_left_arrived_choice(61, 1) := choice(forward_first(8), 64, forward_left_pair_choice(30));
    forward_left_arrived_choice(62, 1) := choice(forward_first(8), 64, forward_left_pair_choice(31));
    forward_left_arrived_choice(63, 1) := choice(forward_first(8), 64, forward_left_cost(62));
    for i in 0 to 9 loop
      forward_above_total_choice(6 * i) := choice(forward_above_ready_top, 20, forward_above_ready_words(i) mod 32);
      forward_above_total_choice(6 * i + 1) := choice(forward_above_ready_top, 20, (forward_above_ready_words(i) / 32)
        mod 32);
      forward_above_total_choice(6 * i + 2) := choice(forward_above_ready_top, 20, (forward_above_ready_words(i) /
        1024) mod 32);
      forward_above_total_choice(6 * i + 3) := choice(forward_above_ready_top, 20, (forward_above_ready_words(i) /
        32768) mod 32);
      forward_above_total_choice(6 * i + 4) := choice(forward_above_ready_top, 20, (forward_above_ready_words(i) /
        1048576) mod 32);
      forward_above_total_choice(6 * i + 5) := choice(forward_above_ready_top, 20, (forward_above_ready_words(i) /
        33554432) mod 32);
    end loop;
    forward_above_total_choice(60) := choice(forward_above_ready_top, 20, forward_above_ready_words_10 mod 32);
    forward_above_total_choice(61) := choice(forward_above_ready_top, 20, (forward_above_ready_words_10 / 32) mod 32);
    forward_above_total_choice(62) := choice(forward_above_ready_top, 20, (forward_above_ready_words_10 / 1024) mod 32);
    forward_above_total_choice(63) := choice(forward_above_ready_top, 20, (forward_above_ready_words_10 / 32768) mod
      32);
    if entry_tag.valid then
      forward_cost_delay_ring_write_address <= forward_cost_delay_ring_read_address;
      forward_left_pair <= forward_left_pair_choice;
      forward_left_smallest <= forward_left_smallest_difference mod 128;
      forward_left_smallest_less <= (forward_left_smallest_difference + 119) mod 128;
      forward_left_first(0) <= forward_first(5);
      forward_left_first(1 to 2) <= forward_left_first(0 to 1);
      forward_left_relief_next(0) <= forward_reliefs_moved(4);
      forward_left_relief_next(1 to 3) <= forward_left_relief_next(0 to 2);
      forward_left_relief_past(0) <= forward_left_smallest_choice;
      forward_left_relief_past(1 to 7) <= forward_left_relief_past(0 to 6);
      forward_left_relief_pairs(0) <= forward_left_relief_pairs_0_choice;
      forward_left_relief_pairs(1) <= forward_left_relief_pairs(0);
      forward_left_relief_fours(1 to 2) <= forward_left_relief_fours(0 to 1);
      forward_left_relief_largest <= forward_left_relief_largest_choice;
      forward_left_relief_beyond <= (forward_left_relief_largest_choice - forward_left_relief_past(7)) mod 32;
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
      for i in 0 to 9 loop forward_above_ready_words(i) <= to_integer(forward_above_read_words(i)); end loop;
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
      for i in 0 to 1 loop
        forward_above_cost(30 * i) <= (to_integer(forward_above_delay_held(5 * i)) - forward_above_smallest_copy(i))
          mod 32;
        forward_above_cost(30 * i + 1) <= (to_integer(forward_above_delay_held(5 * i)(30 downto 5)) -
          forward_above_smallest_copy(i)) mod 32;
        forward_above_cost(30 * i + 2) <= (to_integer(forward_above_delay_held(5 * i)(30 downto 10)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 3) <= (to_integer(forward_above_delay_held(5 * i)(30 downto 15)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 4) <= (to_integer(forward_above_delay_held(5 * i)(30 downto 20)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 5) <= (to_integer(forward_above_delay_held(5 * i)(30 downto 25)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 6) <= (to_integer(forward_above_delay_held(5 * i + 1)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 7) <= (to_integer(forward_above_delay_held(5 * i + 1)(30 downto 5)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 8) <= (to_integer(forward_above_delay_held(5 * i + 1)(30 downto 10)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 9) <= (to_integer(forward_above_delay_held(5 * i + 1)(30 downto 15)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 10) <= (to_integer(forward_above_delay_held(5 * i + 1)(30 downto 20)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 11) <= (to_integer(forward_above_delay_held(5 * i + 1)(30 downto 25)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 12) <= (to_integer(forward_above_delay_held(5 * i + 2)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 13) <= (to_integer(forward_above_delay_held(5 * i + 2)(30 downto 5)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 14) <= (to_integer(forward_above_delay_held(5 * i + 2)(30 downto 10)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 15) <= (to_integer(forward_above_delay_held(5 * i + 2)(30 downto 15)) -
          forward_above_smallest_copy(2 * i)) mod 32;
        forward_above_cost(30 * i + 16) <= (to_integer(forward_above_delay_held(5 * i + 2)(30 downto 20)) -
          forward_above_smallest_copy(i + 1)) mod 32;
        forward_above_cost(30 * i + 17) <= (to_integer(forward_above_delay_held(5 * i + 2)(30 downto 25)) -
          forward_above_smallest_copy(i + 1)) mod 32;
        forward_above_cost(30 * i + 18) <= (to_integer(forward_above_delay_held(5 * i + 3)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 19) <= (to_integer(forward_above_delay_held(5 * i + 3)(30 downto 5)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 20) <= (to_integer(forward_above_delay_held(5 * i + 3)(30 downto 10)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 21) <= (to_integer(forward_above_delay_held(5 * i + 3)(30 downto 15)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 22) <= (to_integer(forward_above_delay_held(5 * i + 3)(30 downto 20)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 23) <= (to_integer(forward_above_delay_held(5 * i + 3)(30 downto 25)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 24) <= (to_integer(forward_above_delay_held(5 * i + 4)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 25) <= (to_integer(forward_above_delay_held(5 * i + 4)(30 downto 5)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 26) <= (to_integer(forward_above_delay_held(5 * i + 4)(30 downto 10)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 27) <= (to_integer(forward_above_delay_held(5 * i + 4)(30 downto 15)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 28) <= (to_integer(forward_above_delay_held(5 * i + 4)(30 downto 20)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
        forward_above_cost(30 * i + 29) <= (to_integer(forward_above_delay_held(5 * i + 4)(30 downto 25)) -
          forward_above_smallest_copy(2 * i + 1)) mod 32;
      end loop;
      forward_above_cost(60) <= (to_integer(forward_above_delay_held_10) - forward_above_smallest_copy(3)) mod 32;
      forward_above_cost(61) <= (to_integer(forward_above_delay_held_10(20 downto 5)) - forward_above_smallest_copy(3))
        mod 32;
      forward_above_cost(62) <= (to_integer(forward_above_delay_held_10(20 downto 10)) -
        forward_above_smallest_copy(3)) mod 32;
      forward_above_cost(63) <= (to_integer(forward_above_delay_held_10(20 downto 15)) -
        forward_above_smallest_copy(3)) mod 32;
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
      for i in 0 to 63 loop
        forward_sum(i) <= ((forward_left_cost(i) + forward_above_cost(i)) - forward_reliefs_moved(8)) mod 128;
      end loop;
      forward_first(0) <= entry_turned_first_column;
      forward_first(1 to 5) <= forward_first(0 to 4);
      forward_first(6) <= sums_turn_waiting_first(5);
      forward_first(7 to 8) <= forward_first(6 to 7);
      forward_first(9) <= forward_left_first(2);
      forward_first(10) <= forward_first(9);
      forward_reliefs_moved(0) <= relief_entered;
      forward_reliefs_moved(1 to 8) <= forward_reliefs_moved(0 to 7);
      forward_reliefs_moved(9) <= forward_left_relief_next(3);
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
      forward_left_start_cost(0) <= choice(sums_turn_waiting_first(5), 40, forward_left_start_cost_0_choices(9));
      for i in 1 to 8 loop
        forward_left_start_cost(i) <= choice(sums_turn_waiting_first(5), 0, forward_left_start_cost(i - 1));
      end loop;
      forward_left_room <= choice(sums_turn_waiting_first(5), 0, forward_left_room_choices(3));
      forward_left_relief_reach_of_best <= choice(sums_turn_waiting_first(5), 0,
        forward_left_relief_reach_of_best_choices(3));
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
      forward_above_stay(0) <= choice(forward_above_own_0 < 20, forward_above_own_0, 20);
      forward_above_stay(1) <= choice(forward_above_beside(0) < 20, forward_above_beside(0), 20);
      for i in 2 to 61 loop
        forward_above_stay(i) <= choice(forward_above_own(i) < 20, forward_above_own(i), 20);
      end loop;
      forward_above_stay(62) <= choice(forward_above_beside(63) < 20, forward_above_beside(63), 20);
      forward_above_stay(63) <= choice(forward_above_own_63 < 20, forward_above_own_63, 20);
    end if;
    forward_above_writes_copy_0_choice := choice(entry_tag.valid, forward_above_comes(10), forward_above_comes(11));
    forward_above_writes_copy_0 <= entry_next_tag.valid and forward_above_writes_copy_0_choice;
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
        forward_above_write_words(i) <= to_integer(((((((((((to_unsigned(forward_above_write_words_choice(i, 1), 11) &
          to_unsigned(0, 20)) or (to_unsigned(forward_above_write_words_choice(i, 2), 6) & to_unsigned(0, 25)))) or
          (to_unsigned(forward_above_write_words_choice(i, 3), 16) & to_unsigned(0, 15)))) or
          (to_unsigned(forward_above_write_words_choice(i, 4), 21) & to_unsigned(0, 10)))) or
          (to_unsigned(forward_above_write_words_choice(i, 5), 31)))) or
          (to_unsigned(forward_above_write_words_choice(i, 6), 26) & to_unsigned(0, 5))));
      end loop;
      forward_above_write_words_10 <= to_integer(((((((to_unsigned(forward_above_write_words_choice(10, 1), 11) &
        to_unsigned(0, 10)) or (to_unsigned(forward_above_write_words_choice(10, 2), 6) & to_unsigned(0, 15)))) or
        (to_unsigned(forward_above_write_words_choice(10, 3), 21)))) or
        (to_unsigned(forward_above_write_words_choice(10, 4), 16) & to_unsigned(0, 5))));
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
    sums_right_start_cost_0_choice(4) := not is_larger(sums_right_relief_largest, sums_right_room, 0, 3, false);
    sums_right_start_cost_0_is_equal := (sums_right_room / 16) = 0;
    sums_right_start_cost_0_choice(5) := choice(is_set(sums_right_relief_largest, 4), not is_set(sums_right_room, 5),
      sums_right_start_cost_0_is_equal);
    sums_right_start_cost_0_choice(6) := choice(sums_right_start_cost_0_choice(4), is_set(sums_right_relief_largest, 4)
      and sums_right_start_cost_0_is_equal, sums_right_start_cost_0_choice(5));
    sums_right_start_cost_0_choices(7) := choice(sums_right_start_cost_0_choice(6), 0, (sums_right_room -
      sums_right_relief_largest) mod 64);
    sums_right_start_cost_0_is_less := 127 < ((sums_right_tree_next_next_next_next_smallest_0 mod 64) +
      sums_right_relief_reach_of_best);
    sums_right_start_cost_0_choices(8) := choice(sums_right_start_cost_0_is_less,
      (sums_right_tree_next_next_next_next_smallest_0 + sums_right_relief_reach_of_best) mod 64, 0);
    sums_right_start_cost_0_choices(9) := choice(sums_right_start_cost_0_any, sums_right_start_cost_0_choices(7),
      sums_right_start_cost_0_choices(8));
    sums_right_room_value := (sums_right_start_cost(8) + sums_right_room) mod 64;
    sums_right_room_choices(1) := choice(sums_right_start_cost_0_choice(6), sums_right_room_value,
      (sums_right_start_cost(8) + sums_right_relief_largest) mod 64);
    sums_right_room_choices(2) := choice(sums_right_start_cost_0_is_less, (sums_right_relief_room_of_best -
      sums_right_tree_next_next_next_next_smallest_0) mod 64, sums_right_room_value);
    sums_right_room_choices(3) := choice(sums_right_start_cost_0_any, sums_right_room_choices(1),
      sums_right_room_choices(2));
    sums_right_smallest_choice := choice(sums_turn_ready_first, 0, sums_right_relief_next(0));
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
    sums_right_relief_reach_of_best_choice := choice(sums_right_start_cost_0_choice(6),
      sums_right_relief_reach_of_best_sum, sums_right_relief_largest + sums_right_relief_leaves);
    sums_right_relief_reach_of_best_choices(2) := choice(sums_right_start_cost_0_is_less,
      (sums_right_relief_reach_again - (sums_right_tree_next_next_next_next_smallest_0 mod 64)) mod 256,
      sums_right_relief_reach_of_best_sum);
    sums_right_relief_reach_of_best_choices(3) := choice(sums_right_start_cost_0_any,
      sums_right_relief_reach_of_best_choice, sums_right_relief_reach_of_best_choices(2));
    sums_right_relief_leaves_choice := choice(sums_turn_ready_first, 64, sums_right_start_cost(7) + 64);
    sums_right_g_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest) mod 128;
    sums_right_g_less_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest_less) mod 128;
    for i in 0 to 63 loop
      sums_right_cost_choice(i, 1) := smaller(sums_right_arrived(i), sums_right_cost(i));
      sums_right_cost_choice(i, 2) := choice(is_set(sums_right_cost_choice(i, 1), 6) or
        sums_tags_held_first_column(14), 64, sums_right_cost_choice(i, 1));
    end loop;
    sums_right_arrived_choice(0, 1) := choice(sums_tags_held_first_column(14), 64, sums_right_cost(1));
    for i in 0 to 14 loop
      sums_right_arrived_choice(4 * i + 1, 1) := choice(sums_tags_held_first_column(14), 64, sums_right_pair_choice(2 *
        i));
      sums_right_arrived_choice(4 * i + 2, 1) := choice(sums_tags_held_first_column(14), 64, sums_right_pair_choice(2 *
        i + 1));
      sums_right_arrived_choice(4 * i + 3, 1) := smaller(sums_right_cost(4 * i + 4), sums_right_cost(4 * i + 2));
      sums_right_arrived_choice(4 * i + 3, 2) := choice(sums_tags_held_first_column(14), 64,
        sums_right_arrived_choice(4 * i + 3, 1));
      sums_right_arrived_choice(4 * i + 4, 1) := smaller(sums_right_cost(4 * i + 5), sums_right_cost(4 * i + 3));
      sums_right_arrived_choice(4 * i + 4, 2) := choice(sums_tags_held_first_column(14), 64,
        sums_right_arrived_choice(4 * i + 4, 1));
    end loop;
    sums_right_arrived_choice(61, 1) := choice(sums_tags_held_first_column(14), 64, sums_right_pair_choice(30));
    sums_right_arrived_choice(62, 1) := choice(sums_tags_held_first_column(14), 64, sums_right_pair_choice(31));
    sums_right_arrived_choice(63, 1) := choice(sums_tags_held_first_column(14), 64, sums_right_cost(62));
    if entry_tag.valid then
      for i in 0 to 15 loop sums_turn_ready_sums(i) <= to_integer(sums_turn_read_sums(i)); end loop;
      for i in 0 to 5 loop sums_turn_ready_costs(i) <= to_integer(sums_turn_read_costs(i)); end loop;
      sums_turn_ready_costs_6 <= to_integer(sums_turn_read_costs_6);
      sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
      sums_turn_ready_first <= forward_first(10);
      sums_turn_place(0) <= entry_place;
      sums_turn_place(1 to 10) <= sums_turn_place(0 to 9);
      sums_turn_waiting_first(0) <= entry_tag.first_column;
      sums_turn_waiting_first(1 to 5) <= sums_turn_waiting_first(0 to 4);
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
      sums_right_smallest_less <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8) + 119) mod 128;
      sums_right_first(0) <= sums_turn_ready_first;
      sums_right_first(1 to 2) <= sums_right_first(0 to 1);
      sums_right_relief_next(0) <= sums_turn_ready_smallest_0 / 8;
      sums_right_relief_next(1 to 3) <= sums_right_relief_next(0 to 2);
      sums_right_relief_past(0) <= sums_right_smallest_choice;
      sums_right_relief_past(1 to 7) <= sums_right_relief_past(0 to 6);
      sums_right_relief_pairs(0) <= sums_right_relief_pairs_0_choice;
      sums_right_relief_pairs(1) <= sums_right_relief_pairs(0);
      sums_right_relief_fours(1 to 2) <= sums_right_relief_fours(0 to 1);
      sums_right_relief_largest <= sums_right_relief_largest_choice;
      sums_right_relief_beyond <= (sums_right_relief_largest_choice - sums_right_relief_past(7)) mod 32;
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
      for i in 1 to 11 loop
        sums_tags_held_output_column(i) <= sums_tags_held_output_column(i - 1);
        sums_tags_held_start_of_frame(i) <= sums_tags_held_start_of_frame(i - 1);
        sums_tags_held_end_of_line(i) <= sums_tags_held_end_of_line(i - 1);
      end loop;
      sums_tags_held_map_column(12) <= forward_above_comes(11);
      sums_tags_held_output_column(12) <= sums_tags_held_output_column(11);
      sums_tags_held_first_column(12) <= sums_turn_ready_first;
      for i in 12 to 13 loop
        sums_tags_held_start_of_frame(i) <= sums_tags_held_start_of_frame(i - 1);
        sums_tags_held_end_of_line(i) <= sums_tags_held_end_of_line(i - 1);
        sums_tags_held_map_column(i + 1) <= sums_tags_held_map_column(i);
        sums_tags_held_output_column(i + 1) <= sums_tags_held_output_column(i);
        sums_tags_held_first_column(i + 1) <= sums_tags_held_first_column(i);
      end loop;
      sums_tags_held_start_of_frame(14) <= sums_tags_held_start_of_frame(13);
      sums_tags_held_end_of_line(14) <= sums_tags_held_end_of_line(13);
      sums_tags_held_map_column(15) <= sums_tags_held_map_column(14);
      sums_tags_held_output_column(15) <= sums_tags_held_output_column(14);
      sums_tags_held_first_column(15) <= sums_right_first(2);
      sums_tags_held_start_of_frame(15) <= sums_tags_held_start_of_frame(14);
      sums_tags_held_end_of_line(15) <= sums_tags_held_end_of_line(14);
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
      sums_right_start_cost(0) <= choice(sums_turn_ready_first, 40, sums_right_start_cost_0_choices(9));
      for i in 1 to 8 loop
        sums_right_start_cost(i) <= choice(sums_turn_ready_first, 0, sums_right_start_cost(i - 1));
      end loop;
      sums_right_room <= choice(sums_turn_ready_first, 0, sums_right_room_choices(3));
      sums_right_relief_reach_of_best <= choice(sums_turn_ready_first, 0, sums_right_relief_reach_of_best_choices(3));
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
    sums_turn_waiting_read_place_choices(1) := choice(entry_tag.valid, sums_turn_place(8), sums_turn_place(9));
    sums_turn_waiting_read_place_choices(2) := choice(entry_tag.valid, sums_turn_place(9), sums_turn_place(10));
    sums_turn_writes_copy_0 <= entry_next_tag.valid and sums_turn_writes_copy_0_choice;
    for i in 0 to 7 loop
      for j in 0 to 3 loop
        sums_sum_0(8 * i + j) <= ((sums_right_cost(8 * i + j) + to_integer(sums_sum_delay_held(2 * i)(7 * j + 6 downto
          7 * j))) - sums_right_relief_next(3)) mod 256;
      end loop;
      for j in 4 to 7 loop
        sums_sum_0(8 * i + j) <= ((sums_right_cost(8 * i + j) + to_integer(sums_sum_delay_held(2 * i + 1)(7 * j - 22
          downto 7 * j - 28))) - sums_right_relief_next(3)) mod 256;
      end loop;
    end loop;
    sums_tag.valid <= sums_tags_moved;
    sums_tag.map_column <= sums_tags_held_map_column(15);
    sums_tag.output_column <= sums_tags_held_output_column(15);
    sums_tag.first_column <= sums_tags_held_first_column(15);
    sums_tag.start_of_frame <= sums_tags_held_start_of_frame(15);
    sums_tag.end_of_line <= sums_tags_held_end_of_line(15);
    sums_tags_moved <= entry_tag.valid;
    sums_turn_waiting_read_place <= choice(entry_next_tag.valid, sums_turn_waiting_read_place_choices(1),
      sums_turn_waiting_read_place_choices(2));
    if sums_turn_writes_copy_0 then
      for i in 0 to 15 loop
        sums_turn_write_sums(i) <= (forward_sum(4 * i + 2) * 16384) + (forward_sum(4 * i + 3) * 2097152) +
          forward_sum(4 * i) + (forward_sum(4 * i + 1) * 128);
      end loop;
      for i in 0 to 5 loop
        sums_turn_write_costs(i) <= (forward_cost(3, 10 * i + 8) * 16777216) + (forward_cost(3, 10 * i + 9) *
          134217728) + (forward_cost(3, 10 * i + 7) * 2097152) + (forward_cost(3, 10 * i + 6) * 262144) +
          (forward_cost(3, 10 * i + 5) * 32768) + (forward_cost(3, 10 * i + 4) * 4096) + (forward_cost(3, 10 * i + 3) *
          512) + (forward_cost(3, 10 * i + 2) * 64) + forward_cost(3, 10 * i) + (forward_cost(3, 10 * i + 1) * 8);
      end loop;
      sums_turn_write_costs_6 <= (forward_cost(3, 62) * 64) + (forward_cost(3, 63) * 512) + forward_cost(3, 60) +
        (forward_cost(3, 61) * 8);
      sums_turn_write_smallest_0 <= to_integer(((to_unsigned(forward_reliefs_moved(10), 5) & to_unsigned(0, 3)) or
        (to_unsigned(forward_smallest_cost(4), 8))));
      sums_turn_write_place <= sums_turn_place(10);
    end if;
    -- winnersmask
    if sums_tags_moved then
      for i in 0 to 62 loop
        winnersmask_inside(i) <= sums_tags_held_first_column(15) or winnersmask_inside(i + 1);
      end loop;
      winnersmask_column <= choice(sums_tags_held_first_column(15), 0, (winnersmask_column + 1) mod 512);
    end if;
    winnersmask_inside_63_choice := choice(sums_tags_moved, sums_tags_held_first_column(15), winnersmask_inside(63));
    winnersmask_inside(63) <= choice(winnersmask_column < 384, sums_tags_moved or winnersmask_inside(63),
      winnersmask_inside_63_choice);
    -- winnersother
    for i in 0 to 30 loop
      winnersother_cost_0_is_equal(2 * i + 1) := (sums_sum_0(2 * i + 1) mod 4) = 0;
      for j in 1 to 5 loop winnersother_cost_0_value(2 * i + 1, j) := is_set(sums_sum_0(2 * i + 1), j + 1); end loop;
      winnersother_cost_0_choice(2 * i + 1, 7) := not is_larger(winnersother_cost_0(2 * i + 2), sums_sum_0(2 * i + 1),
        0, 6, true);
      winnersother_cost_0_choice(2 * i + 1, 8) := choice(is_set(winnersother_cost_0(2 * i + 2), 7), (not
        sums_tag.first_column) and is_set(sums_sum_0(2 * i + 1), 7), not sums_tag.first_column);
      winnersother_cost_0_choice(2 * i + 1, 9) := choice(winnersother_cost_0_choice(2 * i + 1, 7),
        winnersother_cost_0_choice(2 * i + 1, 8), (not is_set(winnersother_cost_0(2 * i + 2), 7)) and (not
        sums_tag.first_column) and is_set(sums_sum_0(2 * i + 1), 7));
      winnersother_cost_0_all(2 * i + 1) := (not winnersother_cost_0_choice(2 * i + 1, 9)) and winnersmask_inside(2 * i
        + 1) and sums_tag.output_column;
      for j in 1 to 6 loop winnersother_cost_0_value(2 * i + 2, j) := is_set(sums_sum_0(2 * i + 2), j); end loop;
      winnersother_cost_0_choice(2 * i + 2, 7) := not is_larger(winnersother_cost_0(2 * i + 3), sums_sum_0(2 * i + 2),
        0, 6, true);
      winnersother_cost_0_choice(2 * i + 2, 8) := choice(is_set(winnersother_cost_0(2 * i + 3), 7), (not
        sums_tag.first_column) and is_set(sums_sum_0(2 * i + 2), 7), not sums_tag.first_column);
      winnersother_cost_0_choice(2 * i + 2, 9) := choice(winnersother_cost_0_choice(2 * i + 2, 7),
        winnersother_cost_0_choice(2 * i + 2, 8), (not is_set(winnersother_cost_0(2 * i + 3), 7)) and (not
        sums_tag.first_column) and is_set(sums_sum_0(2 * i + 2), 7));
      winnersother_cost_0_all(2 * i + 2) := (not winnersother_cost_0_choice(2 * i + 2, 9)) and winnersmask_inside(2 * i
        + 2) and sums_tag.output_column;
    end loop;
    winnersother_cost_0_all(63) := winnersmask_inside(63) and sums_tag.output_column;
    for i in 1 to 6 loop winnersother_winner_0_0_values(i) := is_set(sums_sum_0(0), i); end loop;
    winnersother_winner_0_0_choice(7) := not is_larger(winnersother_cost_0(1), sums_sum_0(0), 0, 6, true);
    winnersother_winner_0_0_choice(8) := choice(winnersother_winner_0_0_choice(7), (not sums_tag.first_column) and
      ((not is_set(winnersother_cost_0(1), 7)) or is_set(sums_sum_0(0), 7)), (not sums_tag.first_column) and (not
      is_set(winnersother_cost_0(1), 7)) and is_set(sums_sum_0(0), 7));
    if sums_tag.valid then
      for i in 1 to 62 loop
        winnersother_cost_0(i) <= choice(winnersother_cost_0_all(i), sums_sum_0(i), winnersother_cost_0(i + 1));
        winnersother_winner_0(i) <= choice(winnersother_cost_0_all(i), i, winnersother_winner_0(i + 1));
      end loop;
      winnersother_cost_0(63) <= choice(winnersother_cost_0_all(63), sums_sum_0(63), 0);
      winnersother_winner_0(63) <= choice(winnersother_cost_0_all(63), 63, 0);
      winnersother_winner_0(0) <= choice((not winnersother_winner_0_0_choice(8)) and sums_tag.output_column and
        winnersmask_inside(0), 0, winnersother_winner_0(1));
    end if;
    winnersother_winner_out_0 <= winnersother_winner_0(0);
    -- winnerswinner1
    for i in 0 to 30 loop
      winnerswinner1_best_index_0_choice_8(i) := is_larger(sums_sum_0(2 * i), sums_sum_0(2 * i + 1), 0, 7, false);
    end loop;
    for i in 1 to 5 loop winnerswinner1_best_index_0_31_values(i) := is_set(sums_sum_0(63), i + 1); end loop;
    winnerswinner1_best_index_0_choice_8(31) := is_larger(sums_sum_0(62), sums_sum_0(63), 0, 7, false);
    winnerswinner1_held_0 <= sums_sum_0;
    winnerswinner1_best_index_0_0 <= winnerswinner1_best_index_0_choice_8(0);
    for i in 1 to 15 loop winnerswinner1_best_place_0(i) <= winnerswinner1_best_index_0_choice_8(2 * i); end loop;
    winnerswinner1_best_late_cost_0 <= winnerswinner1_best_cost_0;
    for i in 1 to 31 loop winnerswinner1_best_but_first_0(i) <= winnerswinner1_held_0(2 * i + 1); end loop;
    for i in 0 to 30 loop winnerswinner1_best_but_last_0(i) <= winnerswinner1_held_0(2 * i); end loop;
    winnerswinner1_tag <= sums_tag;
    for i in 0 to 31 loop winnerswinner1_best_cost_0(i) <= smaller(sums_sum_0(2 * i + 1), sums_sum_0(2 * i)); end loop;
    for i in 1 to 31 loop
      winnerswinner1_best_index_0(i) <= choice(winnerswinner1_best_index_0_choice_8(i), 2 * i + 1, 2 * i);
      winnerswinner1_best_below_0(i) <= choice(winnerswinner1_best_index_0_choice_8(i), sums_sum_0(2 * i), 0);
      winnerswinner1_best_above_0(i) <= choice(winnerswinner1_best_index_0_choice_8(i), 0, sums_sum_0(2 * i + 1));
    end loop;
    winnerswinner1_best_below_0(0) <= choice(winnerswinner1_best_index_0_choice_8(0), sums_sum_0(0), 0);
    winnerswinner1_best_above_0(0) <= choice(winnerswinner1_best_index_0_choice_8(0), 0, sums_sum_0(1));
    -- winnerswinner2
    for i in 0 to 15 loop
      for j in 1 to 5 loop
        winnerswinner2_best_index_0_value(i, j) := is_set(winnerswinner1_best_cost_0(2 * i + 1), j + 1);
      end loop;
      winnerswinner2_best_index_0_choice(i, 7) := not is_larger(winnerswinner1_best_cost_0(2 * i),
        winnerswinner1_best_cost_0(2 * i + 1), 0, 6, false);
      winnerswinner2_best_index_0_choice(i, 8) := inverted_carry(winnerswinner2_best_index_0_choice(i, 7),
        is_set(winnerswinner1_best_cost_0(2 * i), 7), not is_set(winnerswinner1_best_cost_0(2 * i + 1), 7));
    end loop;
    winnerswinner2_best_below_0_is_equal(0) := winnerswinner1_best_index_0(1) = 2;
    winnerswinner2_best_below_0_choice(0) := choice(winnerswinner2_best_below_0_is_equal(0), winnerswinner1_held_0(1),
      winnerswinner1_best_below_0(1));
    winnerswinner2_best_below_0_is_equal(1) := winnerswinner1_best_index_0(3) = 6;
    winnerswinner2_best_below_0_choice(1) := choice(winnerswinner2_best_below_0_is_equal(1), winnerswinner1_held_0(5),
      winnerswinner1_best_below_0(3));
    winnerswinner2_best_below_0_is_equal(2) := (winnerswinner1_best_index_0(5) mod 4) = 2;
    winnerswinner2_best_below_0_choice(2) := choice(is_set(winnerswinner1_best_index_0(5), 3) and
      winnerswinner2_best_below_0_is_equal(2), winnerswinner1_held_0(9), winnerswinner1_best_below_0(5));
    winnerswinner2_best_below_0_is_equal(3) := winnerswinner1_best_index_0(7) = 14;
    winnerswinner2_best_below_0_choice(3) := choice(winnerswinner2_best_below_0_is_equal(3), winnerswinner1_held_0(13),
      winnerswinner1_best_below_0(7));
    winnerswinner2_best_below_0_value(4, 1) := is_set(winnerswinner1_best_index_0(9), 1);
    winnerswinner2_best_below_0_choice(4) := choice(winnerswinner2_best_below_0_value(4, 1) and (not
      is_set(winnerswinner1_best_index_0(9), 0)) and is_set(winnerswinner1_best_index_0(9), 4),
      winnerswinner1_held_0(17), winnerswinner1_best_below_0(9));
    winnerswinner2_best_below_0_value(5, 1) := is_set(winnerswinner1_best_index_0(11), 1);
    winnerswinner2_best_below_0_value(5, 2) := is_set(winnerswinner1_best_index_0(11), 2);
    winnerswinner2_best_below_0_choice(5) := choice(winnerswinner2_best_below_0_value(5, 1) and (not
      is_set(winnerswinner1_best_index_0(11), 0)) and is_set(winnerswinner1_best_index_0(11), 4) and
      winnerswinner2_best_below_0_value(5, 2), winnerswinner1_held_0(21), winnerswinner1_best_below_0(11));
    winnerswinner2_best_below_0_value(6, 1) := is_set(winnerswinner1_best_index_0(13), 1);
    winnerswinner2_best_below_0_is_equal(6) := (winnerswinner1_best_index_0(13) / 8) = 3;
    winnerswinner2_best_below_0_choice(6) := choice(winnerswinner2_best_below_0_value(6, 1) and (not
      is_set(winnerswinner1_best_index_0(13), 0)) and winnerswinner2_best_below_0_is_equal(6),
      winnerswinner1_held_0(25), winnerswinner1_best_below_0(13));
    winnerswinner2_best_below_0_is_equal(7) := winnerswinner1_best_index_0(15) = 30;
    winnerswinner2_best_below_0_choice(7) := choice(winnerswinner2_best_below_0_is_equal(7), winnerswinner1_held_0(29),
      winnerswinner1_best_below_0(15));
    winnerswinner2_best_below_0_is_equal(8) := (winnerswinner1_best_index_0(17) mod 4) = 2;
    winnerswinner2_best_below_0_choice(8) := choice(is_set(winnerswinner1_best_index_0(17), 5) and
      winnerswinner2_best_below_0_is_equal(8), winnerswinner1_held_0(33), winnerswinner1_best_below_0(17));
    winnerswinner2_best_below_0_is_equal(9) := (winnerswinner1_best_index_0(19) mod 8) = 6;
    winnerswinner2_best_below_0_choice(9) := choice(is_set(winnerswinner1_best_index_0(19), 5) and
      winnerswinner2_best_below_0_is_equal(9), winnerswinner1_held_0(37), winnerswinner1_best_below_0(19));
    for i in 3 to 4 loop
      winnerswinner2_best_below_0_value(2 * i + 4, 1) := is_set(winnerswinner1_best_index_0(4 * i + 9), i);
      winnerswinner2_best_below_0_is_equal(2 * i + 4) := (winnerswinner1_best_index_0(4 * i + 9) mod 4) = 2;
      winnerswinner2_best_below_0_choice(2 * i + 4) := choice(is_set(winnerswinner1_best_index_0(4 * i + 9), 5) and
        winnerswinner2_best_below_0_value(2 * i + 4, 1) and winnerswinner2_best_below_0_is_equal(2 * i + 4),
        winnerswinner1_held_0(8 * i + 17), winnerswinner1_best_below_0(4 * i + 9));
      winnerswinner2_best_below_0_is_equal(2 * i + 5) := (winnerswinner1_best_index_0(4 * i + 11) mod 8) = 6;
      winnerswinner2_best_below_0_value(2 * i + 5, 1) := is_set(winnerswinner1_best_index_0(4 * i + 11), i);
      winnerswinner2_best_below_0_choice(2 * i + 5) := choice(is_set(winnerswinner1_best_index_0(4 * i + 11), 5) and
        winnerswinner2_best_below_0_is_equal(2 * i + 5) and winnerswinner2_best_below_0_value(2 * i + 5, 1),
        winnerswinner1_held_0(8 * i + 21), winnerswinner1_best_below_0(4 * i + 11));
    end loop;
    winnerswinner2_best_below_0_value(14, 1) := is_set(winnerswinner1_best_index_0(29), 4);
    winnerswinner2_best_below_0_is_equal(14) := (winnerswinner1_best_index_0(29) mod 4) = 2;
    winnerswinner2_best_below_0_value(14, 2) := is_set(winnerswinner1_best_index_0(29), 3);
    winnerswinner2_best_below_0_choice(14) := choice(is_set(winnerswinner1_best_index_0(29), 5) and
      winnerswinner2_best_below_0_value(14, 1) and winnerswinner2_best_below_0_is_equal(14) and
      winnerswinner2_best_below_0_value(14, 2), winnerswinner1_held_0(57), winnerswinner1_best_below_0(29));
    winnerswinner2_best_below_0_is_equal(15) := winnerswinner1_best_index_0(31) = 62;
    winnerswinner2_best_below_0_choice(15) := choice(winnerswinner2_best_below_0_is_equal(15),
      winnerswinner1_held_0(61), winnerswinner1_best_below_0(31));
    winnerswinner2_best_above_0_choice(0) := choice(winnerswinner1_best_index_0_0, winnerswinner1_held_0(2),
      winnerswinner1_best_above_0(0));
    for i in 1 to 15 loop
      winnerswinner2_best_above_0_choice(i) := choice(winnerswinner1_best_place_0(i), winnerswinner1_held_0(4 * i + 2),
        winnerswinner1_best_above_0(2 * i));
    end loop;
    for i in 0 to 15 loop
      winnerswinner2_best_at_start_0_choice(i) := carry(winnerswinner2_best_index_0_choice(i, 7), not
        is_set(winnerswinner1_best_cost_0(2 * i), 7), is_set(winnerswinner1_best_cost_0(2 * i + 1), 7));
    end loop;
    for i in 0 to 15 loop
      winnerswinner2_best_second_0_choice(i, 1) := choice(winnerswinner2_best_place_0(i), 255,
        winnerswinner1_best_late_cost_0(2 * i + 1));
      winnerswinner2_best_second_0_choice(i, 2) := choice(winnerswinner2_best_at_end_0(i),
        winnerswinner1_best_but_first_0(2 * i + 1), winnerswinner2_best_second_0_choice(i, 1));
      winnerswinner2_best_second_0_choice(i, 3) := choice(winnerswinner2_best_place_0(i),
        winnerswinner1_best_late_cost_0(2 * i), 255);
      winnerswinner2_best_second_0_choice(i, 4) := choice(winnerswinner2_best_at_start_0(i),
        winnerswinner1_best_but_last_0(2 * i), winnerswinner2_best_second_0_choice(i, 3));
    end loop;
    for i in 1 to 15 loop winnerswinner2_best_first_0(i) <= winnerswinner1_held_0(4 * i); end loop;
    for i in 0 to 14 loop winnerswinner2_best_last_0(i) <= winnerswinner1_held_0(4 * i + 3); end loop;
    for i in 0 to 15 loop winnerswinner2_best_place_0(i) <= winnerswinner2_best_index_0_choice(i, 8); end loop;
    winnerswinner2_best_at_start_0(0) <= (not winnerswinner2_best_at_start_0_choice(0)) and
      winnerswinner2_best_below_0_is_equal(0);
    winnerswinner2_best_at_start_0(1) <= (not winnerswinner2_best_at_start_0_choice(1)) and
      winnerswinner2_best_below_0_is_equal(1);
    winnerswinner2_best_at_start_0(2) <= (not winnerswinner2_best_at_start_0_choice(2)) and
      is_set(winnerswinner1_best_index_0(5), 3) and winnerswinner2_best_below_0_is_equal(2);
    winnerswinner2_best_at_start_0(3) <= winnerswinner2_best_below_0_is_equal(3) and (not
      winnerswinner2_best_at_start_0_choice(3));
    winnerswinner2_best_at_start_0(4) <= (not winnerswinner2_best_at_start_0_choice(4)) and
      winnerswinner2_best_below_0_value(4, 1) and (not is_set(winnerswinner1_best_index_0(9), 0)) and
      is_set(winnerswinner1_best_index_0(9), 4);
    winnerswinner2_best_at_start_0(5) <= winnerswinner2_best_below_0_value(5, 1) and (not
      is_set(winnerswinner1_best_index_0(11), 0)) and is_set(winnerswinner1_best_index_0(11), 4) and
      winnerswinner2_best_below_0_value(5, 2) and (not winnerswinner2_best_at_start_0_choice(5));
    winnerswinner2_best_at_start_0(6) <= winnerswinner2_best_below_0_value(6, 1) and (not
      is_set(winnerswinner1_best_index_0(13), 0)) and winnerswinner2_best_below_0_is_equal(6) and (not
      winnerswinner2_best_at_start_0_choice(6));
    winnerswinner2_best_at_start_0(7) <= winnerswinner2_best_below_0_is_equal(7) and (not
      winnerswinner2_best_at_start_0_choice(7));
    winnerswinner2_best_at_start_0(8) <= (not winnerswinner2_best_at_start_0_choice(8)) and
      is_set(winnerswinner1_best_index_0(17), 5) and winnerswinner2_best_below_0_is_equal(8);
    winnerswinner2_best_at_start_0(9) <= is_set(winnerswinner1_best_index_0(19), 5) and
      winnerswinner2_best_below_0_is_equal(9) and (not winnerswinner2_best_at_start_0_choice(9));
    for i in 0 to 1 loop
      winnerswinner2_best_at_start_0(2 * i + 10) <= is_set(winnerswinner1_best_index_0(4 * i + 21), 5) and
        winnerswinner2_best_below_0_value(2 * i + 10, 1) and winnerswinner2_best_below_0_is_equal(2 * i + 10) and (not
        winnerswinner2_best_at_start_0_choice(2 * i + 10));
      winnerswinner2_best_at_start_0(2 * i + 11) <= is_set(winnerswinner1_best_index_0(4 * i + 23), 5) and
        winnerswinner2_best_below_0_is_equal(2 * i + 11) and winnerswinner2_best_below_0_value(2 * i + 11, 1) and (not
        winnerswinner2_best_at_start_0_choice(2 * i + 11));
    end loop;
    winnerswinner2_best_at_start_0(14) <= is_set(winnerswinner1_best_index_0(29), 5) and
      winnerswinner2_best_below_0_value(14, 1) and winnerswinner2_best_below_0_is_equal(14) and
      winnerswinner2_best_below_0_value(14, 2) and (not winnerswinner2_best_at_start_0_choice(14));
    winnerswinner2_best_at_start_0(15) <= winnerswinner2_best_below_0_is_equal(15) and (not
      winnerswinner2_best_at_start_0_choice(15));
    winnerswinner2_best_at_end_0(0) <= winnerswinner2_best_at_start_0_choice(0) and winnerswinner1_best_index_0_0;
    for i in 1 to 15 loop
      winnerswinner2_best_at_end_0(i) <= winnerswinner2_best_at_start_0_choice(i) and winnerswinner1_best_place_0(i);
    end loop;
    winnerswinner2_best_late_cost_0 <= winnerswinner2_best_cost_0;
    winnerswinner2_tag <= winnerswinner1_tag;
    for i in 0 to 15 loop
      winnerswinner2_best_cost_0(i) <= smaller(winnerswinner1_best_cost_0(2 * i + 1), winnerswinner1_best_cost_0(2 *
        i));
    end loop;
    winnerswinner2_best_index_0(0) <= choice(winnerswinner2_best_index_0_choice(0, 8), winnerswinner1_best_index_0(1),
      as_number(winnerswinner1_best_index_0_0));
    for i in 0 to 14 loop
      winnerswinner2_best_below_0(i) <= choice(winnerswinner2_best_index_0_choice(i, 8),
        winnerswinner2_best_below_0_choice(i), winnerswinner1_best_below_0(2 * i));
      winnerswinner2_best_above_0(i) <= choice(winnerswinner2_best_index_0_choice(i, 8), winnerswinner1_best_above_0(2
        * i + 1), winnerswinner2_best_above_0_choice(i));
      winnerswinner2_best_index_0(i + 1) <= choice(winnerswinner2_best_index_0_choice(i + 1, 8),
        winnerswinner1_best_index_0(2 * i + 3), winnerswinner1_best_index_0(2 * i + 2));
    end loop;
    winnerswinner2_best_below_0(15) <= choice(winnerswinner2_best_index_0_choice(15, 8),
      winnerswinner2_best_below_0_choice(15), winnerswinner1_best_below_0(30));
    winnerswinner2_best_above_0(15) <= choice(winnerswinner2_best_index_0_choice(15, 8),
      winnerswinner1_best_above_0(31), winnerswinner2_best_above_0_choice(15));
    for i in 0 to 15 loop
      winnerswinner2_best_second_0(i) <= smaller(winnerswinner2_best_second_0_choice(i, 2),
        winnerswinner2_best_second_0_choice(i, 4));
    end loop;
    for i in 1 to 15 loop
      winnerswinner2_best_but_first_0(i) <= smaller(winnerswinner1_best_late_cost_0(2 * i + 1),
        winnerswinner1_best_but_first_0(2 * i));
    end loop;
    for i in 0 to 14 loop
      winnerswinner2_best_but_last_0(i) <= smaller(winnerswinner1_best_but_last_0(2 * i + 1),
        winnerswinner1_best_late_cost_0(2 * i));
    end loop;
    -- winnerswinner3
    for i in 0 to 7 loop
      for j in 1 to 5 loop
        winnerswinner3_best_index_0_value(i, j) := is_set(winnerswinner2_best_cost_0(2 * i + 1), j + 1);
      end loop;
      winnerswinner3_best_index_0_choice(i, 7) := not is_larger(winnerswinner2_best_cost_0(2 * i),
        winnerswinner2_best_cost_0(2 * i + 1), 0, 6, false);
      winnerswinner3_best_index_0_choice(i, 8) := inverted_carry(winnerswinner3_best_index_0_choice(i, 7),
        is_set(winnerswinner2_best_cost_0(2 * i), 7), not is_set(winnerswinner2_best_cost_0(2 * i + 1), 7));
    end loop;
    winnerswinner3_best_below_0_is_equal(0) := winnerswinner2_best_index_0(1) = 4;
    winnerswinner3_best_below_0_choice(0) := choice(winnerswinner3_best_below_0_is_equal(0),
      winnerswinner2_best_last_0(0), winnerswinner2_best_below_0(1));
    winnerswinner3_best_below_0_is_equal(1) := winnerswinner2_best_index_0(3) = 12;
    winnerswinner3_best_below_0_choice(1) := choice(winnerswinner3_best_below_0_is_equal(1),
      winnerswinner2_best_last_0(2), winnerswinner2_best_below_0(3));
    winnerswinner3_best_below_0_value(2) := is_set(winnerswinner2_best_index_0(5), 2);
    winnerswinner3_best_below_0_choice(2) := choice((not is_set(winnerswinner2_best_index_0(5), 1)) and (not
      is_set(winnerswinner2_best_index_0(5), 0)) and is_set(winnerswinner2_best_index_0(5), 4) and
      winnerswinner3_best_below_0_value(2), winnerswinner2_best_last_0(4), winnerswinner2_best_below_0(5));
    winnerswinner3_best_below_0_is_equal(3) := winnerswinner2_best_index_0(7) = 28;
    winnerswinner3_best_below_0_choice(3) := choice(winnerswinner3_best_below_0_is_equal(3),
      winnerswinner2_best_last_0(6), winnerswinner2_best_below_0(7));
    winnerswinner3_best_below_0_is_equal(4) := (winnerswinner2_best_index_0(9) mod 8) = 4;
    winnerswinner3_best_below_0_choice(4) := choice(is_set(winnerswinner2_best_index_0(9), 5) and
      winnerswinner3_best_below_0_is_equal(4), winnerswinner2_best_last_0(8), winnerswinner2_best_below_0(9));
    for i in 5 to 6 loop
      winnerswinner3_best_below_0_is_equal(i) := (winnerswinner2_best_index_0(2 * i + 1) mod 8) = 4;
      winnerswinner3_best_below_0_value(i) := is_set(winnerswinner2_best_index_0(2 * i + 1), i - 2);
      winnerswinner3_best_below_0_choice(i) := choice(is_set(winnerswinner2_best_index_0(2 * i + 1), 5) and
        winnerswinner3_best_below_0_is_equal(i) and winnerswinner3_best_below_0_value(i), winnerswinner2_best_last_0(2
        * i), winnerswinner2_best_below_0(2 * i + 1));
    end loop;
    winnerswinner3_best_below_0_is_equal(7) := winnerswinner2_best_index_0(15) = 60;
    winnerswinner3_best_below_0_choice(7) := choice(winnerswinner3_best_below_0_is_equal(7),
      winnerswinner2_best_last_0(14), winnerswinner2_best_below_0(15));
    winnerswinner3_best_above_0_is_equal(0) := winnerswinner2_best_index_0(0) = 3;
    winnerswinner3_best_above_0_choice(0) := choice(winnerswinner3_best_above_0_is_equal(0),
      winnerswinner2_best_first_0(1), winnerswinner2_best_above_0(0));
    winnerswinner3_best_above_0_is_equal(1) := (winnerswinner2_best_index_0(2) mod 4) = 3;
    winnerswinner3_best_above_0_choice(1) := choice(is_set(winnerswinner2_best_index_0(2), 3) and
      winnerswinner3_best_above_0_is_equal(1), winnerswinner2_best_first_0(3), winnerswinner2_best_above_0(2));
    winnerswinner3_best_above_0_value(2, 1) := is_set(winnerswinner2_best_index_0(4), 1);
    winnerswinner3_best_above_0_choice(2) := choice(winnerswinner3_best_above_0_value(2, 1) and
      is_set(winnerswinner2_best_index_0(4), 0) and is_set(winnerswinner2_best_index_0(4), 4),
      winnerswinner2_best_first_0(5), winnerswinner2_best_above_0(4));
    winnerswinner3_best_above_0_value(3, 1) := is_set(winnerswinner2_best_index_0(6), 1);
    winnerswinner3_best_above_0_is_equal(3) := (winnerswinner2_best_index_0(6) / 8) = 3;
    winnerswinner3_best_above_0_choice(3) := choice(winnerswinner3_best_above_0_value(3, 1) and
      is_set(winnerswinner2_best_index_0(6), 0) and winnerswinner3_best_above_0_is_equal(3),
      winnerswinner2_best_first_0(7), winnerswinner2_best_above_0(6));
    winnerswinner3_best_above_0_is_equal(4) := (winnerswinner2_best_index_0(8) mod 4) = 3;
    winnerswinner3_best_above_0_choice(4) := choice(is_set(winnerswinner2_best_index_0(8), 5) and
      winnerswinner3_best_above_0_is_equal(4), winnerswinner2_best_first_0(9), winnerswinner2_best_above_0(8));
    for i in 5 to 6 loop
      winnerswinner3_best_above_0_value(i, 1) := is_set(winnerswinner2_best_index_0(2 * i), i - 2);
      winnerswinner3_best_above_0_is_equal(i) := (winnerswinner2_best_index_0(2 * i) mod 4) = 3;
      winnerswinner3_best_above_0_choice(i) := choice(is_set(winnerswinner2_best_index_0(2 * i), 5) and
        winnerswinner3_best_above_0_value(i, 1) and winnerswinner3_best_above_0_is_equal(i),
        winnerswinner2_best_first_0(2 * i + 1), winnerswinner2_best_above_0(2 * i));
    end loop;
    winnerswinner3_best_above_0_value(7, 1) := is_set(winnerswinner2_best_index_0(14), 4);
    winnerswinner3_best_above_0_is_equal(7) := (winnerswinner2_best_index_0(14) mod 4) = 3;
    winnerswinner3_best_above_0_value(7, 2) := is_set(winnerswinner2_best_index_0(14), 3);
    winnerswinner3_best_above_0_choice(7) := choice(is_set(winnerswinner2_best_index_0(14), 5) and
      winnerswinner3_best_above_0_value(7, 1) and winnerswinner3_best_above_0_is_equal(7) and
      winnerswinner3_best_above_0_value(7, 2), winnerswinner2_best_first_0(15), winnerswinner2_best_above_0(14));
    for i in 0 to 7 loop
      winnerswinner3_best_at_start_0_choice(i) := carry(winnerswinner3_best_index_0_choice(i, 7), not
        is_set(winnerswinner2_best_cost_0(2 * i), 7), is_set(winnerswinner2_best_cost_0(2 * i + 1), 7));
    end loop;
    for i in 0 to 7 loop
      winnerswinner3_best_second_0_choice(i, 1) := choice(winnerswinner3_best_place_0(i),
        winnerswinner2_best_second_0(2 * i + 1), winnerswinner2_best_late_cost_0(2 * i + 1));
      winnerswinner3_best_second_0_choice(i, 2) := choice(winnerswinner3_best_at_end_0(i),
        winnerswinner2_best_but_first_0(2 * i + 1), winnerswinner3_best_second_0_choice(i, 1));
      winnerswinner3_best_second_0_choice(i, 3) := choice(winnerswinner3_best_place_0(i),
        winnerswinner2_best_late_cost_0(2 * i), winnerswinner2_best_second_0(2 * i));
      winnerswinner3_best_second_0_choice(i, 4) := choice(winnerswinner3_best_at_start_0(i),
        winnerswinner2_best_but_last_0(2 * i), winnerswinner3_best_second_0_choice(i, 3));
    end loop;
    for i in 1 to 7 loop winnerswinner3_best_first_0(i) <= winnerswinner2_best_first_0(2 * i); end loop;
    for i in 0 to 6 loop winnerswinner3_best_last_0(i) <= winnerswinner2_best_last_0(2 * i + 1); end loop;
    for i in 0 to 7 loop winnerswinner3_best_place_0(i) <= winnerswinner3_best_index_0_choice(i, 8); end loop;
    winnerswinner3_best_at_start_0(0) <= (not winnerswinner3_best_at_start_0_choice(0)) and
      winnerswinner3_best_below_0_is_equal(0);
    winnerswinner3_best_at_start_0(1) <= winnerswinner3_best_below_0_is_equal(1) and (not
      winnerswinner3_best_at_start_0_choice(1));
    winnerswinner3_best_at_start_0(2) <= (not is_set(winnerswinner2_best_index_0(5), 1)) and (not
      is_set(winnerswinner2_best_index_0(5), 0)) and is_set(winnerswinner2_best_index_0(5), 4) and
      winnerswinner3_best_below_0_value(2) and (not winnerswinner3_best_at_start_0_choice(2));
    winnerswinner3_best_at_start_0(3) <= winnerswinner3_best_below_0_is_equal(3) and (not
      winnerswinner3_best_at_start_0_choice(3));
    winnerswinner3_best_at_start_0(4) <= is_set(winnerswinner2_best_index_0(9), 5) and
      winnerswinner3_best_below_0_is_equal(4) and (not winnerswinner3_best_at_start_0_choice(4));
    winnerswinner3_best_at_start_0(5) <= is_set(winnerswinner2_best_index_0(11), 5) and
      winnerswinner3_best_below_0_is_equal(5) and winnerswinner3_best_below_0_value(5) and (not
      winnerswinner3_best_at_start_0_choice(5));
    winnerswinner3_best_at_start_0(6) <= is_set(winnerswinner2_best_index_0(13), 5) and
      winnerswinner3_best_below_0_is_equal(6) and winnerswinner3_best_below_0_value(6) and (not
      winnerswinner3_best_at_start_0_choice(6));
    winnerswinner3_best_at_start_0(7) <= winnerswinner3_best_below_0_is_equal(7) and (not
      winnerswinner3_best_at_start_0_choice(7));
    winnerswinner3_best_at_end_0(0) <= winnerswinner3_best_at_start_0_choice(0) and
      winnerswinner3_best_above_0_is_equal(0);
    winnerswinner3_best_at_end_0(1) <= winnerswinner3_best_at_start_0_choice(1) and
      is_set(winnerswinner2_best_index_0(2), 3) and winnerswinner3_best_above_0_is_equal(1);
    winnerswinner3_best_at_end_0(2) <= winnerswinner3_best_at_start_0_choice(2) and
      winnerswinner3_best_above_0_value(2, 1) and is_set(winnerswinner2_best_index_0(4), 0) and
      is_set(winnerswinner2_best_index_0(4), 4);
    winnerswinner3_best_at_end_0(3) <= winnerswinner3_best_above_0_value(3, 1) and
      is_set(winnerswinner2_best_index_0(6), 0) and winnerswinner3_best_above_0_is_equal(3) and
      winnerswinner3_best_at_start_0_choice(3);
    winnerswinner3_best_at_end_0(4) <= winnerswinner3_best_at_start_0_choice(4) and
      is_set(winnerswinner2_best_index_0(8), 5) and winnerswinner3_best_above_0_is_equal(4);
    winnerswinner3_best_at_end_0(5) <= is_set(winnerswinner2_best_index_0(10), 5) and
      winnerswinner3_best_above_0_value(5, 1) and winnerswinner3_best_above_0_is_equal(5) and
      winnerswinner3_best_at_start_0_choice(5);
    winnerswinner3_best_at_end_0(6) <= is_set(winnerswinner2_best_index_0(12), 5) and
      winnerswinner3_best_above_0_value(6, 1) and winnerswinner3_best_above_0_is_equal(6) and
      winnerswinner3_best_at_start_0_choice(6);
    winnerswinner3_best_at_end_0(7) <= is_set(winnerswinner2_best_index_0(14), 5) and
      winnerswinner3_best_above_0_value(7, 1) and winnerswinner3_best_above_0_is_equal(7) and
      winnerswinner3_best_above_0_value(7, 2) and winnerswinner3_best_at_start_0_choice(7);
    winnerswinner3_best_late_cost_0 <= winnerswinner3_best_cost_0;
    winnerswinner3_tag <= winnerswinner2_tag;
    for i in 0 to 7 loop
      winnerswinner3_best_cost_0(i) <= smaller(winnerswinner2_best_cost_0(2 * i + 1), winnerswinner2_best_cost_0(2 *
        i));
    end loop;
    for i in 0 to 7 loop
      winnerswinner3_best_index_0(i) <= choice(winnerswinner3_best_index_0_choice(i, 8), winnerswinner2_best_index_0(2
        * i + 1), winnerswinner2_best_index_0(2 * i));
      winnerswinner3_best_below_0(i) <= choice(winnerswinner3_best_index_0_choice(i, 8),
        winnerswinner3_best_below_0_choice(i), winnerswinner2_best_below_0(2 * i));
      winnerswinner3_best_above_0(i) <= choice(winnerswinner3_best_index_0_choice(i, 8), winnerswinner2_best_above_0(2
        * i + 1), winnerswinner3_best_above_0_choice(i));
    end loop;
    for i in 0 to 7 loop
      winnerswinner3_best_second_0(i) <= smaller(winnerswinner3_best_second_0_choice(i, 2),
        winnerswinner3_best_second_0_choice(i, 4));
    end loop;
    for i in 1 to 7 loop
      winnerswinner3_best_but_first_0(i) <= smaller(winnerswinner2_best_late_cost_0(2 * i + 1),
        winnerswinner2_best_but_first_0(2 * i));
    end loop;
    for i in 0 to 6 loop
      winnerswinner3_best_but_last_0(i) <= smaller(winnerswinner2_best_but_last_0(2 * i + 1),
        winnerswinner2_best_late_cost_0(2 * i));
    end loop;
    -- winnerswinner4
    for i in 0 to 3 loop
      for j in 1 to 5 loop
        winnerswinner4_best_index_0_value(i, j) := is_set(winnerswinner3_best_cost_0(2 * i + 1), j + 1);
      end loop;
      winnerswinner4_best_index_0_choice(i, 7) := not is_larger(winnerswinner3_best_cost_0(2 * i),
        winnerswinner3_best_cost_0(2 * i + 1), 0, 6, false);
      winnerswinner4_best_index_0_choice(i, 8) := inverted_carry(winnerswinner4_best_index_0_choice(i, 7),
        is_set(winnerswinner3_best_cost_0(2 * i), 7), not is_set(winnerswinner3_best_cost_0(2 * i + 1), 7));
    end loop;
    winnerswinner4_best_below_0_is_equal(0) := winnerswinner3_best_index_0(1) = 8;
    winnerswinner4_best_below_0_choice(0) := choice(winnerswinner4_best_below_0_is_equal(0),
      winnerswinner3_best_last_0(0), winnerswinner3_best_below_0(1));
    winnerswinner4_best_below_0_is_equal(1) := winnerswinner3_best_index_0(3) = 24;
    winnerswinner4_best_below_0_choice(1) := choice(winnerswinner4_best_below_0_is_equal(1),
      winnerswinner3_best_last_0(2), winnerswinner3_best_below_0(3));
    winnerswinner4_best_below_0_is_equal(2) := (winnerswinner3_best_index_0(5) mod 8) = 0;
    winnerswinner4_best_below_0_2_value := is_set(winnerswinner3_best_index_0(5), 3);
    winnerswinner4_best_below_0_choice(2) := choice(is_set(winnerswinner3_best_index_0(5), 5) and
      winnerswinner4_best_below_0_is_equal(2) and winnerswinner4_best_below_0_2_value, winnerswinner3_best_last_0(4),
      winnerswinner3_best_below_0(5));
    winnerswinner4_best_below_0_is_equal(3) := winnerswinner3_best_index_0(7) = 56;
    winnerswinner4_best_below_0_choice(3) := choice(winnerswinner4_best_below_0_is_equal(3),
      winnerswinner3_best_last_0(6), winnerswinner3_best_below_0(7));
    winnerswinner4_best_above_0_is_equal(0) := winnerswinner3_best_index_0(0) = 7;
    winnerswinner4_best_above_0_choice(0) := choice(winnerswinner4_best_above_0_is_equal(0),
      winnerswinner3_best_first_0(1), winnerswinner3_best_above_0(0));
    winnerswinner4_best_above_0_value(1, 1) := is_set(winnerswinner3_best_index_0(2), 1);
    winnerswinner4_best_above_0_value(1, 2) := is_set(winnerswinner3_best_index_0(2), 2);
    winnerswinner4_best_above_0_choice(1) := choice(winnerswinner4_best_above_0_value(1, 1) and
      is_set(winnerswinner3_best_index_0(2), 0) and is_set(winnerswinner3_best_index_0(2), 4) and
      winnerswinner4_best_above_0_value(1, 2), winnerswinner3_best_first_0(3), winnerswinner3_best_above_0(2));
    winnerswinner4_best_above_0_is_equal(2) := (winnerswinner3_best_index_0(4) mod 8) = 7;
    winnerswinner4_best_above_0_choice(2) := choice(is_set(winnerswinner3_best_index_0(4), 5) and
      winnerswinner4_best_above_0_is_equal(2), winnerswinner3_best_first_0(5), winnerswinner3_best_above_0(4));
    winnerswinner4_best_above_0_is_equal(3) := (winnerswinner3_best_index_0(6) mod 8) = 7;
    winnerswinner4_best_above_0_value(3, 1) := is_set(winnerswinner3_best_index_0(6), 4);
    winnerswinner4_best_above_0_choice(3) := choice(is_set(winnerswinner3_best_index_0(6), 5) and
      winnerswinner4_best_above_0_is_equal(3) and winnerswinner4_best_above_0_value(3, 1),
      winnerswinner3_best_first_0(7), winnerswinner3_best_above_0(6));
    for i in 0 to 3 loop
      winnerswinner4_best_at_start_0_choice(i) := carry(winnerswinner4_best_index_0_choice(i, 7), not
        is_set(winnerswinner3_best_cost_0(2 * i), 7), is_set(winnerswinner3_best_cost_0(2 * i + 1), 7));
    end loop;
    for i in 0 to 3 loop
      winnerswinner4_best_second_0_choice(i, 1) := choice(winnerswinner4_best_place_0(i),
        winnerswinner3_best_second_0(2 * i + 1), winnerswinner3_best_late_cost_0(2 * i + 1));
      winnerswinner4_best_second_0_choice(i, 2) := choice(winnerswinner4_best_at_end_0(i),
        winnerswinner3_best_but_first_0(2 * i + 1), winnerswinner4_best_second_0_choice(i, 1));
      winnerswinner4_best_second_0_choice(i, 3) := choice(winnerswinner4_best_place_0(i),
        winnerswinner3_best_late_cost_0(2 * i), winnerswinner3_best_second_0(2 * i));
      winnerswinner4_best_second_0_choice(i, 4) := choice(winnerswinner4_best_at_start_0(i),
        winnerswinner3_best_but_last_0(2 * i), winnerswinner4_best_second_0_choice(i, 3));
    end loop;
    winnerswinner4_best_first_0(1) <= winnerswinner3_best_first_0(2);
    winnerswinner4_best_first_0(2) <= winnerswinner3_best_first_0(4);
    winnerswinner4_best_first_0(3) <= winnerswinner3_best_first_0(6);
    winnerswinner4_best_last_0(0) <= winnerswinner3_best_last_0(1);
    winnerswinner4_best_last_0(1) <= winnerswinner3_best_last_0(3);
    winnerswinner4_best_last_0(2) <= winnerswinner3_best_last_0(5);
    winnerswinner4_best_place_0(0) <= winnerswinner4_best_index_0_choice(0, 8);
    winnerswinner4_best_place_0(1) <= winnerswinner4_best_index_0_choice(1, 8);
    winnerswinner4_best_place_0(2) <= winnerswinner4_best_index_0_choice(2, 8);
    winnerswinner4_best_place_0(3) <= winnerswinner4_best_index_0_choice(3, 8);
    winnerswinner4_best_at_start_0(0) <= winnerswinner4_best_below_0_is_equal(0) and (not
      winnerswinner4_best_at_start_0_choice(0));
    winnerswinner4_best_at_start_0(1) <= winnerswinner4_best_below_0_is_equal(1) and (not
      winnerswinner4_best_at_start_0_choice(1));
    winnerswinner4_best_at_start_0(2) <= is_set(winnerswinner3_best_index_0(5), 5) and
      winnerswinner4_best_below_0_is_equal(2) and winnerswinner4_best_below_0_2_value and (not
      winnerswinner4_best_at_start_0_choice(2));
    winnerswinner4_best_at_start_0(3) <= winnerswinner4_best_below_0_is_equal(3) and (not
      winnerswinner4_best_at_start_0_choice(3));
    winnerswinner4_best_at_end_0(0) <= winnerswinner4_best_at_start_0_choice(0) and
      winnerswinner4_best_above_0_is_equal(0);
    winnerswinner4_best_at_end_0(1) <= winnerswinner4_best_above_0_value(1, 1) and
      is_set(winnerswinner3_best_index_0(2), 0) and is_set(winnerswinner3_best_index_0(2), 4) and
      winnerswinner4_best_above_0_value(1, 2) and winnerswinner4_best_at_start_0_choice(1);
    winnerswinner4_best_at_end_0(2) <= is_set(winnerswinner3_best_index_0(4), 5) and
      winnerswinner4_best_above_0_is_equal(2) and winnerswinner4_best_at_start_0_choice(2);
    winnerswinner4_best_at_end_0(3) <= is_set(winnerswinner3_best_index_0(6), 5) and
      winnerswinner4_best_above_0_is_equal(3) and winnerswinner4_best_above_0_value(3, 1) and
      winnerswinner4_best_at_start_0_choice(3);
    winnerswinner4_best_late_cost_0 <= winnerswinner4_best_cost_0;
    winnerswinner4_tag <= winnerswinner3_tag;
    for i in 0 to 3 loop
      winnerswinner4_best_cost_0(i) <= smaller(winnerswinner3_best_cost_0(2 * i + 1), winnerswinner3_best_cost_0(2 *
        i));
    end loop;
    for i in 0 to 3 loop
      winnerswinner4_best_index_0(i) <= choice(winnerswinner4_best_index_0_choice(i, 8), winnerswinner3_best_index_0(2
        * i + 1), winnerswinner3_best_index_0(2 * i));
      winnerswinner4_best_below_0(i) <= choice(winnerswinner4_best_index_0_choice(i, 8),
        winnerswinner4_best_below_0_choice(i), winnerswinner3_best_below_0(2 * i));
      winnerswinner4_best_above_0(i) <= choice(winnerswinner4_best_index_0_choice(i, 8), winnerswinner3_best_above_0(2
        * i + 1), winnerswinner4_best_above_0_choice(i));
    end loop;
    for i in 0 to 3 loop
      winnerswinner4_best_second_0(i) <= smaller(winnerswinner4_best_second_0_choice(i, 2),
        winnerswinner4_best_second_0_choice(i, 4));
    end loop;
    for i in 1 to 3 loop
      winnerswinner4_best_but_first_0(i) <= smaller(winnerswinner3_best_late_cost_0(2 * i + 1),
        winnerswinner3_best_but_first_0(2 * i));
    end loop;
    for i in 0 to 2 loop
      winnerswinner4_best_but_last_0(i) <= smaller(winnerswinner3_best_but_last_0(2 * i + 1),
        winnerswinner3_best_late_cost_0(2 * i));
    end loop;
    -- winnerswinner5
    for i in 0 to 1 loop
      for j in 1 to 5 loop
        winnerswinner5_best_index_0_value(i, j) := is_set(winnerswinner4_best_cost_0(2 * i + 1), j + 1);
      end loop;
      winnerswinner5_best_index_0_choice(i, 7) := not is_larger(winnerswinner4_best_cost_0(2 * i),
        winnerswinner4_best_cost_0(2 * i + 1), 0, 6, false);
      winnerswinner5_best_index_0_choice(i, 8) := inverted_carry(winnerswinner5_best_index_0_choice(i, 7),
        is_set(winnerswinner4_best_cost_0(2 * i), 7), not is_set(winnerswinner4_best_cost_0(2 * i + 1), 7));
    end loop;
    winnerswinner5_best_below_0_is_equal(0) := winnerswinner4_best_index_0(1) = 16;
    winnerswinner5_best_below_0_choice(0) := choice(winnerswinner5_best_below_0_is_equal(0),
      winnerswinner4_best_last_0(0), winnerswinner4_best_below_0(1));
    winnerswinner5_best_below_0_is_equal(1) := winnerswinner4_best_index_0(3) = 48;
    winnerswinner5_best_below_0_choice(1) := choice(winnerswinner5_best_below_0_is_equal(1),
      winnerswinner4_best_last_0(2), winnerswinner4_best_below_0(3));
    winnerswinner5_best_above_0_is_equal(0) := winnerswinner4_best_index_0(0) = 15;
    winnerswinner5_best_above_0_choice(0) := choice(winnerswinner5_best_above_0_is_equal(0),
      winnerswinner4_best_first_0(1), winnerswinner4_best_above_0(0));
    winnerswinner5_best_above_0_is_equal(1) := (winnerswinner4_best_index_0(2) mod 8) = 7;
    winnerswinner5_best_above_0_1_value := is_set(winnerswinner4_best_index_0(2), 3);
    winnerswinner5_best_above_0_choice(1) := choice(is_set(winnerswinner4_best_index_0(2), 5) and
      winnerswinner5_best_above_0_is_equal(1) and winnerswinner5_best_above_0_1_value, winnerswinner4_best_first_0(3),
      winnerswinner4_best_above_0(2));
    winnerswinner5_best_at_start_0_choice(0) := carry(winnerswinner5_best_index_0_choice(0, 7), not
      is_set(winnerswinner4_best_cost_0(0), 7), is_set(winnerswinner4_best_cost_0(1), 7));
    winnerswinner5_best_at_start_0_choice(1) := carry(winnerswinner5_best_index_0_choice(1, 7), not
      is_set(winnerswinner4_best_cost_0(2), 7), is_set(winnerswinner4_best_cost_0(3), 7));
    for i in 0 to 1 loop
      winnerswinner5_best_second_0_choice(i, 1) := choice(winnerswinner5_best_place_0(i),
        winnerswinner4_best_second_0(2 * i + 1), winnerswinner4_best_late_cost_0(2 * i + 1));
      winnerswinner5_best_second_0_choice(i, 2) := choice(winnerswinner5_best_at_end_0(i),
        winnerswinner4_best_but_first_0(2 * i + 1), winnerswinner5_best_second_0_choice(i, 1));
      winnerswinner5_best_second_0_choice(i, 3) := choice(winnerswinner5_best_place_0(i),
        winnerswinner4_best_late_cost_0(2 * i), winnerswinner4_best_second_0(2 * i));
      winnerswinner5_best_second_0_choice(i, 4) := choice(winnerswinner5_best_at_start_0(i),
        winnerswinner4_best_but_last_0(2 * i), winnerswinner5_best_second_0_choice(i, 3));
    end loop;
    winnerswinner5_best_first_0_1 <= winnerswinner4_best_first_0(2);
    winnerswinner5_best_last_0_0 <= winnerswinner4_best_last_0(1);
    winnerswinner5_best_place_0(0) <= winnerswinner5_best_index_0_choice(0, 8);
    winnerswinner5_best_place_0(1) <= winnerswinner5_best_index_0_choice(1, 8);
    winnerswinner5_best_at_start_0(0) <= winnerswinner5_best_below_0_is_equal(0) and (not
      winnerswinner5_best_at_start_0_choice(0));
    winnerswinner5_best_at_start_0(1) <= winnerswinner5_best_below_0_is_equal(1) and (not
      winnerswinner5_best_at_start_0_choice(1));
    winnerswinner5_best_at_end_0(0) <= winnerswinner5_best_above_0_is_equal(0) and
      winnerswinner5_best_at_start_0_choice(0);
    winnerswinner5_best_at_end_0(1) <= is_set(winnerswinner4_best_index_0(2), 5) and
      winnerswinner5_best_above_0_is_equal(1) and winnerswinner5_best_above_0_1_value and
      winnerswinner5_best_at_start_0_choice(1);
    winnerswinner5_best_late_cost_0 <= winnerswinner5_best_cost_0;
    winnerswinner5_tag <= winnerswinner4_tag;
    winnerswinner5_best_cost_0(0) <= smaller(winnerswinner4_best_cost_0(1), winnerswinner4_best_cost_0(0));
    winnerswinner5_best_cost_0(1) <= smaller(winnerswinner4_best_cost_0(3), winnerswinner4_best_cost_0(2));
    for i in 0 to 1 loop
      winnerswinner5_best_index_0(i) <= choice(winnerswinner5_best_index_0_choice(i, 8), winnerswinner4_best_index_0(2
        * i + 1), winnerswinner4_best_index_0(2 * i));
      winnerswinner5_best_below_0(i) <= choice(winnerswinner5_best_index_0_choice(i, 8),
        winnerswinner5_best_below_0_choice(i), winnerswinner4_best_below_0(2 * i));
      winnerswinner5_best_above_0(i) <= choice(winnerswinner5_best_index_0_choice(i, 8), winnerswinner4_best_above_0(2
        * i + 1), winnerswinner5_best_above_0_choice(i));
    end loop;
    winnerswinner5_best_second_0(0) <= smaller(winnerswinner5_best_second_0_choice(0, 2),
      winnerswinner5_best_second_0_choice(0, 4));
    winnerswinner5_best_second_0(1) <= smaller(winnerswinner5_best_second_0_choice(1, 2),
      winnerswinner5_best_second_0_choice(1, 4));
    winnerswinner5_best_but_first_0_1 <= smaller(winnerswinner4_best_late_cost_0(3),
      winnerswinner4_best_but_first_0(2));
    winnerswinner5_best_but_last_0_0 <= smaller(winnerswinner4_best_but_last_0(1), winnerswinner4_best_late_cost_0(0));
    -- winnerswinner6
    for i in 1 to 5 loop
      winnerswinner6_best_index_0_0_values(i) := is_set(winnerswinner5_best_cost_0(1), i + 1);
    end loop;
    winnerswinner6_best_index_0_0_choice(7) := not is_larger(winnerswinner5_best_cost_0(0),
      winnerswinner5_best_cost_0(1), 0, 6, false);
    winnerswinner6_best_index_0_0_choice(8) := inverted_carry(winnerswinner6_best_index_0_0_choice(7),
      is_set(winnerswinner5_best_cost_0(0), 7), not is_set(winnerswinner5_best_cost_0(1), 7));
    winnerswinner6_best_below_0_0_is_equal := winnerswinner5_best_index_0(1) = 32;
    winnerswinner6_best_below_0_0_choice := choice(winnerswinner6_best_below_0_0_is_equal,
      winnerswinner5_best_last_0_0, winnerswinner5_best_below_0(1));
    winnerswinner6_best_above_0_0_is_equal := winnerswinner5_best_index_0(0) = 31;
    winnerswinner6_best_above_0_0_choice := choice(winnerswinner6_best_above_0_0_is_equal,
      winnerswinner5_best_first_0_1, winnerswinner5_best_above_0(0));
    winnerswinner6_best_at_start_0_0_choice := carry(winnerswinner6_best_index_0_0_choice(7), not
      is_set(winnerswinner5_best_cost_0(0), 7), is_set(winnerswinner5_best_cost_0(1), 7));
    winnerswinner6_best_second_0_0_choices(1) := choice(winnerswinner6_best_place_0_0, winnerswinner5_best_second_0(1),
      winnerswinner5_best_late_cost_0(1));
    winnerswinner6_best_second_0_0_choices(2) := choice(winnerswinner6_best_at_end_0_0,
      winnerswinner5_best_but_first_0_1, winnerswinner6_best_second_0_0_choices(1));
    winnerswinner6_best_second_0_0_choices(3) := choice(winnerswinner6_best_place_0_0,
      winnerswinner5_best_late_cost_0(0), winnerswinner5_best_second_0(0));
    winnerswinner6_best_second_0_0_choices(4) := choice(winnerswinner6_best_at_start_0_0,
      winnerswinner5_best_but_last_0_0, winnerswinner6_best_second_0_0_choices(3));
    winnerswinner6_best_place_0_0 <= winnerswinner6_best_index_0_0_choice(8);
    winnerswinner6_best_at_start_0_0 <= winnerswinner6_best_below_0_0_is_equal and (not
      winnerswinner6_best_at_start_0_0_choice);
    winnerswinner6_best_at_end_0_0 <= winnerswinner6_best_at_start_0_0_choice and
      winnerswinner6_best_above_0_0_is_equal;
    winnerswinner6_best_late_cost_0_0 <= winnerswinner6_best_cost_0_0;
    winnerswinner6_tag <= winnerswinner5_tag;
    winnerswinner6_best_cost_0_0 <= smaller(winnerswinner5_best_cost_0(1), winnerswinner5_best_cost_0(0));
    winnerswinner6_best_index_0_0 <= choice(winnerswinner6_best_index_0_0_choice(8), winnerswinner5_best_index_0(1),
      winnerswinner5_best_index_0(0));
    winnerswinner6_best_below_0_0 <= choice(winnerswinner6_best_index_0_0_choice(8),
      winnerswinner6_best_below_0_0_choice, winnerswinner5_best_below_0(0));
    winnerswinner6_best_above_0_0 <= choice(winnerswinner6_best_index_0_0_choice(8), winnerswinner5_best_above_0(1),
      winnerswinner6_best_above_0_0_choice);
    winnerswinner6_best_second_0_0 <= smaller(winnerswinner6_best_second_0_0_choices(2),
      winnerswinner6_best_second_0_0_choices(4));
    -- winners
    winners_partner_at_sum := winners_partner_column + 1;
    winners_partner_at_choice := choice(winnerswinner6_tag.first_column, 0, winners_partner_at_sum);
    winners_best_index_0_0 <= winnerswinner6_best_index_0_0;
    winners_best_below_0_0 <= winnerswinner6_best_below_0_0;
    winners_best_above_0_0 <= winnerswinner6_best_above_0_0;
    winners_best_place_0 <= median_read_bottom;
    winners_best_late_cost_0_0 <= winnerswinner6_best_late_cost_0_0;
    winners_best_second_0_0 <= winnerswinner6_best_second_0_0;
    winners_best_tag.valid <= winnerswinner6_tag.valid;
    winners_best_tag.map_column <= winnerswinner6_tag.map_column;
    winners_best_tag.output_column <= winnerswinner6_tag.output_column;
    winners_best_tag.start_of_frame <= winnerswinner6_tag.start_of_frame;
    winners_best_tag.end_of_line <= winnerswinner6_tag.end_of_line;
    winners_partner_at <= winners_partner_at_choice + winnerswinner6_best_index_0_0;
    if winnerswinner6_tag.valid then
      winners_partner_column <= choice(winnerswinner6_tag.first_column, 0, winners_partner_at_sum mod 512);
    end if;
    -- refinement
    refinement_below_0_differss(1) := winners_best_index_0_0 /= 0;
    refinement_below_0_differss(2) := winners_best_below_0_0 /= 255;
    refinement_below_0_all := refinement_below_0_differss(1) and refinement_below_0_differss(2);
    refinement_above_0_choice := choice(winners_best_index_0_0 = 63, refinement_below_0_all, (winners_best_above_0_0 =
      255) and refinement_below_0_differss(1) and refinement_below_0_differss(2));
    refinement_remainder_1_0_difference := (refinement_remainder_0(0) + 512) - refinement_divisor_0(0);
    for i in 2 to 7 loop
      refinement_remainder_0_difference(i) := ((refinement_remainder_0(i - 1) * 2) + 512) - refinement_divisor_0(i - 1);
    end loop;
    refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
    refinement_divisor_0_0_choice := choice(refinement_divisor_0_0_is_less, refinement_v_0, refinement_u_0);
    refinement_fraction_0_difference := 0 - (refinement_quotient_8_0 / 16);
    refinement_fraction_0_value := (refinement_quotient_8_0 + 15) / 16;
    refinement_fraction_0_choice := choice(refinement_negative_0(8), refinement_fraction_0_difference mod 256,
      refinement_fraction_0_value);
    refinement_fraction_0_choice_2 := choice(refinement_negative_0(8), refinement_fraction_0_difference mod 8,
      refinement_fraction_0_value mod 8);
    refinement_disparity_0(0) <= winners_best_index_0_0;
    refinement_disparity_0(1 to 11) <= refinement_disparity_0(0 to 10);
    refinement_passed_0(0) <= winners_partner_at < 448;
    refinement_passed_0(1 to 11) <= refinement_passed_0(0 to 10);
    refinement_tag_valid(0) <= winners_best_tag.valid;
    refinement_tag_map_column(0) <= winners_best_tag.map_column;
    refinement_tag_output_column(0) <= winners_best_tag.output_column;
    refinement_tag_start_of_frame(0) <= winners_best_tag.start_of_frame;
    refinement_tag_end_of_line(0) <= winners_best_tag.end_of_line;
    for i in 1 to 11 loop
      refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
      refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
      refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
      refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
      refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
    end loop;
    refinement_alone_0_0 <= winners_best_second_0_0 = 255;
    refinement_gap_0 <= (winners_best_second_0_0 - winners_best_late_cost_0_0) mod 256;
    refinement_margin_0(1 to 9) <= refinement_margin_0(0 to 8);
    refinement_u_0 <= (refinement_below_0 - winners_best_late_cost_0_0) mod 256;
    refinement_v_0 <= (refinement_above_0 - winners_best_late_cost_0_0) mod 256;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 8)) or
      (to_unsigned(as_number(((refinement_v_0 = 0) and (refinement_u_0 = 0))), 8))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((refinement_remainder_0(7) * 2) + 512) - refinement_divisor_0(7)) / 512) + ((other_4
      / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 4) * 8) + refinement_fraction_0_choice_2;
    refinement_margin_0(0) <= choice((not refinement_alone_0_0) and ((refinement_gap_0 / 64) = 0), refinement_gap_0 mod
      64, 63);
    refinement_below_0 <= choice(refinement_below_0_all, winners_best_below_0_0, winners_best_above_0_0);
    refinement_above_0 <= choice(refinement_above_0_choice, winners_best_below_0_0, winners_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 9),
      refinement_remainder_1_0_difference mod 256, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 9),
        refinement_remainder_0_difference(i) mod 256, (refinement_remainder_0(i - 1) mod 128) * 2);
    end loop;
    -- leftright
    leftright_holds_winners_choice := choice((not is_set(leftright_ring_read_address, 5)) and
      ((leftright_ring_read_address mod 8) = 0), (not leftright_holds_winners) and (is_set(leftright_ring_read_address,
      4) or is_set(leftright_ring_read_address, 3)), not leftright_holds_winners);
    leftright_address_0_value := to_integer(leftright_held_0(9 downto 4));
    leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
    leftright_other_0(1) <= winnersother_winner_out_0;
    leftright_other_0(2 to 17) <= leftright_other_0(1 to 16);
    leftright_position <= (leftright_position + as_number(refinement_tag_valid(11))) mod 128;
    leftright_held_position <= leftright_position;
    leftright_held_valid <= (not leftright_holds_winners_choice) and refinement_tag_valid(11);
    leftright_address_0 <= (leftright_address_0_value + leftright_held_position + 65) mod 128;
    leftright_asking_disparity_0 <= leftright_address_0_value;
    leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
    leftright_asking_passed_0 <= leftright_held_0(12) = '1';
    leftright_asking_margin_0 <= to_integer(leftright_held_1);
    leftright_asking_tag.valid <= leftright_held_valid;
    leftright_asking_tag.map_column <= leftright_held_0(0) = '1';
    leftright_asking_tag.output_column <= leftright_held_0(1) = '1';
    leftright_asking_tag.start_of_frame <= leftright_held_0(2) = '1';
    leftright_asking_tag.end_of_line <= leftright_held_0(3) = '1';
    leftright_answered_disparity_0 <= leftright_asking_disparity_0;
    leftright_answered_fraction_0 <= leftright_asking_fraction_0;
    leftright_answered_passed_0 <= leftright_asking_passed_0;
    leftright_answered_margin_0 <= leftright_asking_margin_0;
    leftright_answered_tag <= leftright_asking_tag;
    leftright_checked_disparity_0 <= leftright_answered_disparity_0;
    leftright_checked_fraction_0 <= leftright_answered_fraction_0;
    leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
      (leftright_checked_passed_0_difference < 3);
    leftright_checked_margin_0 <= leftright_answered_margin_0;
    leftright_checked_tag <= leftright_answered_tag;
    leftright_holds_winners <= choice(leftright_holds_winners_choice, (not refinement_tag_valid(11)) and
      leftright_holds_winners, refinement_tag_valid(11) or leftright_holds_winners);
    if refinement_tag_valid(11) then
      leftright_ring_write_address <= leftright_ring_read_address;
      leftright_ring_read_address <= choice(leftright_ring_read_address = 63, 0, (leftright_ring_read_address + 1) mod
        64);
    end if;
    -- turn
    turn_order_address_anys(1) := turn_order_inside or (not leftright_checked_tag.map_column) or (not
      leftright_checked_tag.valid);
    turn_order_address_choice := choice(turn_order_falls, 511, 1);
    turn_order_address_choice_2 := choice(turn_order_falls, 0, 447);
    turn_order_address_anys(2) := (not leftright_checked_tag.map_column) or (not leftright_checked_tag.valid);
    if not turn_order_address_anys(2) then
      turn_order_address <= choice(turn_order_address_anys(1), (turn_order_address_choice + turn_order_address) mod
        512, turn_order_address_choice_2);
    end if;
    turn_order_falls_all := (not turn_order_inside) and leftright_checked_tag.map_column and
      leftright_checked_tag.valid;
    turn_order_complete_all := leftright_checked_tag.map_column and leftright_checked_tag.valid;
    turn_ready_tag_row_start_differs := support_counter_group /= 377;
    turn_ready_tag_row_start_is_equals(1) := support_counter_column = 447;
    turn_ready_tag_row_start_choices(1) := choice(turn_ready_tag_row_start_is_equals(1), (support_counter_group /= 376)
      and turn_ready_tag.row_start, turn_ready_tag.row_start);
    turn_ready_tag_row_start_choices(2) := choice(turn_ready_tag_row_start_differs,
      turn_ready_tag_row_start_choices(1), turn_ready_tag.row_start);
    turn_ready_tag_row_start_is_equals(2) := support_counter_group = 374;
    turn_ready_tag_row_start_alls(1) := turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_row_start_is_equals(1);
    turn_ready_tag_row_start_choices(3) := choice(turn_ready_tag_row_start_choices(2), (not
      turn_ready_tag.start_of_frame) or turn_ready_tag_row_start_alls(1), turn_ready_tag.start_of_frame and
      turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_row_start_is_equals(1));
    turn_ready_tag_row_start_alls(2) := turn_ready_tag.map_column and turn_ready_tag.valid;
    turn_order_turned_valid <= leftright_checked_tag.valid;
    turn_order_turned_map_column <= leftright_checked_tag.map_column;
    turn_order_turned_start_of_frame <= (not turn_order_inside) and leftright_checked_tag.map_column and
      leftright_checked_tag.valid and turn_order_first and turn_order_output and turn_order_complete;
    turn_order_turned_end_of_line <= leftright_checked_tag.end_of_line;
    turn_newest <= (leftright_checked_fraction_0 * 512) + leftright_checked_disparity_0 +
      (as_number(leftright_checked_passed_0) * 256) + (leftright_checked_margin_0 * 16384);
    turn_comes <= turn_order_complete_all;
    turn_read_tag.valid <= turn_order_turned_valid;
    turn_read_tag.map_column <= turn_order_turned_map_column;
    turn_read_tag.start_of_frame <= turn_order_turned_start_of_frame;
    turn_read_tag.end_of_line <= turn_order_turned_end_of_line;
    turn_ready <= to_integer(turn_read_words_0);
    turn_ready_tag.valid <= turn_read_tag.valid;
    turn_ready_tag.map_column <= turn_read_tag.map_column;
    turn_ready_tag.start_of_frame <= turn_read_tag.start_of_frame;
    turn_ready_tag.end_of_line <= turn_read_tag.end_of_line;
    turn_order_falls <= choice(turn_order_falls, turn_order_address_anys(1), turn_order_falls_all);
    turn_order_complete <= choice(leftright_checked_tag.end_of_line, turn_order_complete or turn_order_complete_all,
      turn_order_complete and turn_order_address_anys(2));
    turn_ready_tag.row_start <= choice(turn_ready_tag_row_start_choices(3), turn_ready_tag.row_start or
      turn_ready_tag_row_start_alls(2), turn_ready_tag.row_start and ((not turn_ready_tag.map_column) or (not
      turn_ready_tag.valid)));
    if leftright_checked_tag.valid then turn_order_inside <= leftright_checked_tag.map_column; end if;
    if turn_order_falls_all then
      turn_order_output <= leftright_checked_tag.output_column;
      turn_order_first <= leftright_checked_tag.start_of_frame;
    end if;
    if turn_comes then
      turn_write_words_0 <= turn_newest;
      turn_write_place <= turn_order_address;
    end if;
    -- support
    if turn_ready_tag_row_start_alls(2) then
      support_counter_column <= choice(turn_ready_tag.start_of_frame or turn_ready_tag_row_start_is_equals(1), 0,
        (support_counter_column + 1) mod 512);
    end if;
    support_counter_group_choice := choice(turn_ready_tag_row_start_alls(1), 375, 0);
    support_counter_group_choices(2) := choice((support_counter_group = 376) and turn_ready_tag.row_start, 2,
      (support_counter_group + 1) mod 512);
    support_counter_group_choices(3) := choice(turn_ready_tag_row_start_differs and
      turn_ready_tag_row_start_is_equals(1) and turn_ready_tag.map_column and turn_ready_tag.valid,
      support_counter_group_choices(2), support_counter_group);
    support_newest_0_value := (((turn_ready / 512) mod 16) / 8) = 1;
    support_column_choice(0) := choice(support_ready_arrives and support_ready_above2, 127, 63);
    support_column_choice(1) := choice(support_ready_above1 and support_ready_arrives, 127, 63);
    support_column_choice(2) := choice(support_ready_arrives, 127, 63);
    support_column_choice(3) := choice(support_ready_below2 and support_ready_arrives, 127, 63);
    support_column_choice(4) := choice(support_ready_below1 and support_ready_arrives, 127, 63);
    support_moment_0_start_of_frame_choice := choice(support_at_moves, support_at_arrives,
      support_moment_start_of_frame(0));
    support_next_tag_choices(1) := choice(support_row_tag(0), (not support_at_moves) and support_next_tag,
      support_at_moves or support_next_tag);
    support_next_tag_choices(2) := choice(support_at_moves, support_row_tag(0), support_next_tag);
    support_like_0_0_0_difference := 1 - (support_cells(6, 2) mod 64);
    support_like_0_value(0, 0) := ((support_cells(0, 0) mod 64) + support_like_0_0_0_difference) mod 128;
    support_like_0_0_choice(0) := choice(support_row_tag(6), support_next_tag and is_set(support_cells(0, 0), 6), (not
      support_next_tag) and is_set(support_cells(0, 0), 6));
    support_like_0_value(0, 1) := ((support_cells(0, 1) mod 64) + support_like_0_0_0_difference) mod 128;
    support_like_0_1_differs(0) := support_row_tag(6) /= (not support_next_tag);
    for i in 0 to 1 loop
      for j in 2 to 4 loop
        support_like_0_value(i, j) := ((support_cells(2 * i, j) mod 64) + support_like_0_0_0_difference) mod 128;
      end loop;
      support_like_0_value(i + 1, 0) := ((support_cells(2 * i + 2, 0) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_0_choice(i + 1) := choice(support_row_tag(2 * i + 2), is_set(support_cells(2 * i + 2, 0), 6) and
        support_row_tag(6), is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6)));
      support_like_0_value(i + 1, 1) := ((support_cells(2 * i + 2, 1) mod 64) + support_like_0_0_0_difference) mod 128;
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
      support_like_0_value(i + 1, 0) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 0) mod 64)) mod 128;
      support_like_0_0_choice(i + 1) := choice(support_row_tag(2 * i + 2), is_set(support_cells(2 * i + 2, 0), 6) and
        support_row_tag(6), is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6)));
      support_like_0_value(i + 1, 1) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 1) mod 64)) mod 128;
      support_like_0_1_differs(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
    end loop;
    for i in 2 to 4 loop
      support_like_0_value(6, i) := (support_like_0_0_0_difference + (support_cells(12, i) mod 64)) mod 128;
    end loop;
    support_out_sure_0_choice := choice(support_sum_0 < 255, support_sum_0 mod 256, 255);
    support_out_tag_row_start_differs := fill_counter_group /= 376;
    support_out_tag_row_start_is_equals(1) := fill_counter_column = 447;
    support_out_tag_row_start_choices(1) := choice(support_out_tag_row_start_is_equals(1), (fill_counter_group /= 375)
      and support_out_tag.row_start, support_out_tag.row_start);
    support_out_tag_row_start_choices(2) := choice(support_out_tag_row_start_differs,
      support_out_tag_row_start_choices(1), support_out_tag.row_start);
    support_out_tag_row_start_is_equals(2) := fill_counter_group = 374;
    support_out_tag_row_start_alls(1) := support_out_tag_row_start_is_equals(2) and
      support_out_tag_row_start_is_equals(1);
    support_out_tag_row_start_choices(3) := choice(support_out_tag_row_start_choices(2), (not
      support_out_tag.start_of_frame) or support_out_tag_row_start_alls(1), support_out_tag.start_of_frame and
      support_out_tag_row_start_is_equals(2) and support_out_tag_row_start_is_equals(1));
    support_out_tag_row_start_alls(2) := support_out_tag.map_column and support_out_tag.valid;
    support_newest_0 <= ((((((turn_ready + (((turn_ready / 512) mod 32) / 16)) mod 64) * 2) +
      as_number(support_newest_0_value)) * 8) / 16) + (((turn_ready / 256) mod 2) * 64);
    support_newest_rest_0 <= (as_number(support_newest_0_value) * 8) + ((turn_ready / 512) mod 8) + ((turn_ready /
      16384) * 16);
    support_moves <= turn_ready_tag.valid;
    support_arrives <= turn_ready_tag_row_start_alls(2);
    support_last <= turn_ready_tag.end_of_line and turn_ready_tag.map_column and turn_ready_tag.valid;
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
    support_read_below1 <= support_counter_group < 375;
    support_read_below2 <= support_counter_group < 376;
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
        support_like_0_0_choice(i);
      for j in 1 to 4 loop
        support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_like_0_0_0_difference +
          support_cells(2 * i, j)) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and is_set(support_cells(2
          * i, j), 6) and support_like_0_1_differs(i);
      end loop;
    end loop;
    for i in 0 to 6 loop
      support_partial_0(i) <= as_number(support_like_0(i, 3)) + as_number(support_like_0(i, 0)) +
        as_number(support_like_0(i, 1)) + as_number(support_like_0(i, 4)) + as_number(support_like_0(i, 2));
    end loop;
    support_count_0 <= support_partial_0(6) + support_partial_0(4) + support_partial_0(3) + support_partial_0(1) +
      support_partial_0(5) + support_partial_0(0) + support_partial_0(2);
    support_sum_0 <= ((((support_centre_rest_0(2) / 16) + ((support_count_0 * 2) / 4)) * 2) + (support_count_0 mod 2))
      * 2;
    support_centre_0(0) <= support_cells(6, 2);
    support_centre_0(1 to 2) <= support_centre_0(0 to 1);
    support_centre_rest_0(0) <= support_rest_0(6);
    support_centre_rest_0(1 to 2) <= support_centre_rest_0(0 to 1);
    support_centre_moment_map_column(0) <= support_moment_map_column(6);
    support_centre_moment_start_of_frame(0) <= support_moment_start_of_frame(6);
    support_centre_moment_last(0) <= support_moment_last(6);
    for i in 1 to 3 loop
      support_centre_moment_map_column(i) <= support_centre_moment_map_column(i - 1);
      support_centre_moment_start_of_frame(i) <= support_centre_moment_start_of_frame(i - 1);
      support_centre_moment_last(i) <= support_centre_moment_last(i - 1);
    end loop;
    support_centre_moved(0) <= support_moved;
    support_centre_moved(1 to 3) <= support_centre_moved(0 to 2);
    support_out_disparity_0 <= ((((other_3 * 2) + (other_2 / 8) + 127) mod 128) * 8) + (other_2 mod 8);
    support_out_passed_0 <= support_enough_0;
    support_out_tag.valid <= support_centre_moved(3);
    support_out_tag.map_column <= support_centre_moment_map_column(3);
    support_out_tag.start_of_frame <= support_centre_moment_start_of_frame(3);
    support_out_tag.end_of_line <= support_centre_moment_last(3);
    support_counter_group <= choice(turn_ready_tag.start_of_frame and turn_ready_tag.map_column and
      turn_ready_tag.valid, support_counter_group_choice, support_counter_group_choices(3));
    support_row_tag(0) <= choice(support_row_tag(0), (not support_at_arrives) or support_moment_map_column(0) or (not
      support_at_moves), support_at_arrives and (not support_moment_map_column(0)) and support_at_moves);
    support_moment_start_of_frame(0) <= choice(support_at_first, support_moment_0_start_of_frame_choice,
      support_moment_start_of_frame(0) and (not support_at_moves));
    support_next_tag <= choice(support_at_arrives and (not support_moment_map_column(0)), support_next_tag_choices(1),
      support_next_tag_choices(2));
    support_enough_0 <= choice((not is_set(support_count_0, 4)) and ((not is_set(support_count_0, 3)) or
      (((support_count_0 / 2) mod 4) = 0)), is_set(support_centre_0(2), 6) and is_set(support_count_0, 5),
      is_set(support_centre_0(2), 6));
    support_out_sure_0 <= choice(support_enough_0, support_out_sure_0_choice, 0);
    support_out_tag.row_start <= choice(support_out_tag_row_start_choices(3), support_out_tag.row_start or
      support_out_tag_row_start_alls(2), support_out_tag.row_start and ((not support_out_tag.map_column) or (not
      support_out_tag.valid)));
    if support_ready_arrives then
      support_rows_write_words_0 <= (support_rows_ready_words_0 / 128) + (support_rows_ready_newest_0 * 2097152);
      support_rest_rows_write_words_0 <= (support_rest_rows_ready_words_0 / 1024) + (support_rest_rows_ready_newest_0 *
        1024);
      support_write_column <= support_ready_column;
    end if;
    if support_at_moves then
      for i in 0 to 4 loop support_cells(0, i) <= support_column(i); end loop;
      for i in 0 to 5 loop
        for j in 0 to 4 loop support_cells(2 * i + 1, j) <= support_cells(2 * i, j); end loop;
        for j in 0 to 4 loop support_cells(2 * i + 2, j) <= support_cells(2 * i + 1, j); end loop;
      end loop;
      support_row_tag(1) <= support_next_tag;
      support_row_tag(2 to 12) <= support_row_tag(1 to 11);
      support_rest_0(0) <= support_column_rest_0;
      support_rest_0(1 to 6) <= support_rest_0(0 to 5);
      support_moment_map_column(0) <= support_at_arrives;
      support_moment_last(0) <= support_at_last;
      for i in 1 to 6 loop
        support_moment_map_column(i) <= support_moment_map_column(i - 1);
        support_moment_start_of_frame(i) <= support_moment_start_of_frame(i - 1);
        support_moment_last(i) <= support_moment_last(i - 1);
      end loop;
    end if;
    -- fill
    if support_out_tag_row_start_alls(2) then
      fill_counter_column <= choice(support_out_tag.start_of_frame or support_out_tag_row_start_is_equals(1), 0,
        (fill_counter_column + 1) mod 512);
    end if;
    fill_counter_group_choice := choice(support_out_tag_row_start_alls(1), 375, 0);
    fill_counter_group_choices(2) := choice((fill_counter_group = 375) and support_out_tag.row_start, 1,
      (fill_counter_group + 1) mod 512);
    fill_counter_group_choices(3) := choice(support_out_tag_row_start_differs and
      support_out_tag_row_start_is_equals(1) and support_out_tag.map_column and support_out_tag.valid,
      fill_counter_group_choices(2), fill_counter_group);
    fill_ends_read_place_0_is_equal := fill_ready_column = 0;
    fill_ends_read_place_0_choice := choice(other_0, fill_at_arrives and (not fill_pixel_0_passed), fill_at_arrives and
      (not fill_pixel_0_passed) and (not fill_in_hole_0));
    fill_ends_read_place_0_choices(2) := choice(fill_ends_read_place_0 = 227, 0, (fill_ends_read_place_0 + 1) mod 256);
    fill_ends_read_place_0_choices(3) := choice(fill_ends_read_place_0_choice, fill_ends_read_place_0_choices(2),
      fill_ends_read_place_0);
    fill_takes_left_0_choice := choice((fill_step_0 - fill_width_0) < 0, ((fill_width_0 - fill_step_0) mod 512) / 2, 0);
    fill_takes_left_0_choice_2 := choice(fill_rises_0, fill_takes_left_0_choice * 2, fill_width_0);
    fill_out_disparity_0_alls(1) := (not fill_chosen_0_passed) and ((not fill_chosen_at_top) or
      fill_chosen_beside_0_has_right or fill_chosen_beside_0_has_left);
    fill_out_disparity_0_alls(2) := (not fill_chosen_beside_0_has_right) and (not fill_chosen_beside_0_has_left);
    fill_out_disparity_0_choice := choice(fill_takes_left_0, fill_chosen_beside_0_left, fill_chosen_beside_0_right);
    fill_out_disparity_0_choice_2 := choice(fill_out_disparity_0_alls(2), fill_above_0 mod 32768,
      fill_out_disparity_0_choice);
    fill_out_filled_0_is_equal := fill_chosen_at_column = 0;
    fill_out_filled_0_choice := choice(fill_out_filled_0_is_equal and fill_chosen_at_arrives, fill_has_values and (not
      fill_chosen_at_top), fill_had_values);
    fill_out_tag_row_start_differs := median_counter_group /= 376;
    fill_out_tag_row_start_is_equals(1) := median_counter_column = 447;
    fill_out_tag_row_start_choices(1) := choice(fill_out_tag_row_start_is_equals(1), (median_counter_group /= 375) and
      fill_out_tag.row_start, fill_out_tag.row_start);
    fill_out_tag_row_start_choices(2) := choice(fill_out_tag_row_start_differs, fill_out_tag_row_start_choices(1),
      fill_out_tag.row_start);
    fill_out_tag_row_start_is_equals(2) := median_counter_group = 374;
    fill_out_tag_row_start_alls(1) := fill_out_tag_row_start_is_equals(2) and fill_out_tag_row_start_is_equals(1);
    fill_out_tag_row_start_choices(3) := choice(fill_out_tag_row_start_choices(2), (not fill_out_tag.start_of_frame) or
      fill_out_tag_row_start_alls(1), fill_out_tag.start_of_frame and fill_out_tag_row_start_is_equals(2) and
      fill_out_tag_row_start_is_equals(1));
    fill_out_tag_row_start_alls(2) := fill_out_tag.map_column and fill_out_tag.valid;
    fill_newest_disparity_0 <= support_out_disparity_0;
    fill_newest_passed_0 <= support_out_passed_0;
    fill_newest_sure_0 <= support_out_sure_0;
    fill_moves <= support_out_tag.valid;
    fill_arrives <= support_out_tag_row_start_alls(2);
    fill_last <= support_out_tag.end_of_line and support_out_tag.map_column and support_out_tag.valid;
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
      (as_number(fill_newest_passed_0) * 524288);
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
    fill_width_0 <= (fill_beside_0_right_column + (65535 - fill_beside_0_left_column)) mod 512;
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
    fill_takes_left_0 <= fill_measured_beside_0_has_left and ((((fill_measured_at_column + (fill_takes_left_0_choice_2
      / 2)) - fill_measured_beside_0_right_column) < 0) or (not fill_measured_beside_0_has_right));
    fill_above_0 <= to_integer(fill_above_read_0);
    fill_out_passed_0 <= fill_chosen_0_passed;
    fill_out_sure_0 <= fill_chosen_0_sure;
    fill_out_tag.valid <= fill_chosen_at_moves;
    fill_out_tag.map_column <= fill_chosen_at_arrives;
    fill_out_tag.start_of_frame <= fill_out_filled_0_is_equal and fill_chosen_at_arrives and fill_chosen_at_top;
    fill_out_tag.end_of_line <= fill_chosen_at_last;
    fill_counter_group <= choice(support_out_tag.start_of_frame and support_out_tag.map_column and
      support_out_tag.valid, fill_counter_group_choice, fill_counter_group_choices(3));
    fill_ends_open_0 <= choice(fill_newest_passed_0, fill_ends_open_0 and (not fill_arrives), fill_ends_open_0 or
      fill_arrives);
    fill_ends_read_place_0 <= choice(fill_ends_read_place_0_is_equal and fill_ready_arrives,
      fill_ends_row_above_place_0, fill_ends_read_place_0_choices(3));
    fill_beside_0_has_left <= choice(fill_beside_0_has_left, (fill_asking_at_column(1) /= 0) or fill_asking_0_passed(1)
      or (not fill_asking_at_arrives(1)), fill_asking_0_passed(1) and fill_asking_at_arrives(1));
    fill_out_disparity_0 <= choice(fill_out_disparity_0_alls(1), fill_out_disparity_0_choice_2,
      fill_chosen_0_disparity);
    fill_out_filled_0 <= choice(fill_out_filled_0_choice, not fill_chosen_0_passed, (not fill_chosen_0_passed) and
      (fill_chosen_beside_0_has_right or fill_chosen_beside_0_has_left));
    fill_out_tag.row_start <= choice(fill_out_tag_row_start_choices(3), fill_out_tag.row_start or
      fill_out_tag_row_start_alls(2), fill_out_tag.row_start and ((not fill_out_tag.map_column) or (not
      fill_out_tag.valid)));
    fill_has_values <= choice((not fill_out_filled_0_choice) and (not fill_chosen_0_passed) and (not
      fill_chosen_beside_0_has_right) and (not fill_chosen_beside_0_has_left), fill_has_values and (not
      fill_chosen_at_arrives), fill_has_values or fill_chosen_at_arrives);
    if fill_ready_arrives then
      fill_rows_write_words_0 <= fill_rows_ready_newest_0;
      fill_at_column <= fill_ready_column;
    end if;
    fill_ends_next_place_0_choices(1) := choice(fill_last, fill_arrives, fill_newest_passed_0 and fill_arrives);
    fill_ends_next_place_0_choices(2) := choice(fill_ends_open_0 and ((not fill_arrives) or (fill_counter_column /=
      0)), fill_ends_next_place_0_choices(1), fill_last and (not fill_newest_passed_0) and fill_arrives);
    if fill_ends_next_place_0_choices(2) then
      fill_ends_next_place_0 <= choice(fill_ends_next_place_0 = 227, 0, (fill_ends_next_place_0 + 1) mod 256);
    end if;
    fill_ends_row_place_0_all := fill_arrives and (fill_counter_column = 0);
    if fill_ends_row_place_0_all then
      fill_ends_row_place_0 <= fill_ends_next_place_0;
      fill_ends_row_above_place_0 <= fill_ends_row_place_0;
    end if;
    if fill_at_arrives then fill_in_hole_0 <= not fill_pixel_0_passed; end if;
    fill_beside_0_left_any := (not fill_asking_0_passed(1)) or (not fill_asking_at_arrives(1));
    if not fill_beside_0_left_any then
      fill_beside_0_left <= fill_asking_0_disparity(1);
      fill_beside_0_left_column <= fill_asking_at_column(1);
    end if;
    if fill_hole_starts_0(1) then
      fill_beside_0_right <= fill_ends_ready_words_0 mod 1024;
      fill_beside_0_has_right <= is_set(fill_ends_ready_words_0, 19);
      fill_beside_0_right_column <= (fill_ends_ready_words_0 / 1024) mod 512;
    end if;
    fill_write_above_0_choice := choice(fill_out_disparity_0_alls(2), fill_above_0, fill_out_disparity_0_choice);
    if fill_chosen_at_arrives then
      fill_had_values <= fill_out_filled_0_choice;
      fill_write_above_column <= fill_chosen_at_column;
      fill_write_above_0 <= choice(fill_out_disparity_0_alls(1), fill_write_above_0_choice, fill_chosen_0_disparity);
    end if;
    -- median
    if fill_out_tag_row_start_alls(2) then
      median_counter_column <= choice(fill_out_tag.start_of_frame or fill_out_tag_row_start_is_equals(1), 0,
        (median_counter_column + 1) mod 512);
    end if;
    median_counter_group_choice := choice(fill_out_tag_row_start_alls(1), 375, 0);
    median_counter_group_is_equal := median_counter_group = 375;
    median_counter_group_choices(2) := choice(median_counter_group_is_equal and fill_out_tag.row_start, 1,
      (median_counter_group + 1) mod 512);
    median_counter_group_choices(3) := choice(fill_out_tag_row_start_differs and fill_out_tag_row_start_is_equals(1)
      and fill_out_tag.map_column and fill_out_tag.valid, median_counter_group_choices(2), median_counter_group);
    median_line_ended_choice := choice(fill_out_tag.valid, fill_out_tag.map_column, median_line_ended);
    median_of_column_0_a_choice := choice(median_at_top, median_column_1 / 2, other_1 / 2);
    median_of_column_0_c_choice := choice(median_counter_next_frame, median_column_1 / 2, median_column_2 / 2);
    median_sorted_low_0_choices(1) := choice(median_of_column_0_c_below_b, median_of_column_0_c, median_of_column_0_b);
    median_sorted_low_0_choices(2) := choice(median_of_column_0_c_below_a, median_of_column_0_c, median_of_column_0_a);
    median_sorted_middle_0_choices(1) := choice(median_of_column_0_c_below_b, median_of_column_0_b,
      median_sorted_low_0_choices(2));
    median_sorted_middle_0_choices(2) := choice(median_of_column_0_c_below_a, median_of_column_0_a,
      median_sorted_low_0_choices(1));
    median_sorted_high_0_choices(1) := choice(median_of_column_0_c_below_a, median_of_column_0_a, median_of_column_0_c);
    median_sorted_high_0_choices(2) := choice(median_of_column_0_c_below_b, median_of_column_0_b, median_of_column_0_c);
    median_window_complete_is_equal := median_sorted_column = 0;
    median_window_complete_choice := choice(median_window_complete_is_equal, median_sorted_behind,
      median_sorted_arrives or median_sorted_behind);
    median_largest_low_0_choices(1) := choice(median_of_low_0_c_below_a, median_of_low_0_a, median_of_low_0_c);
    median_largest_low_0_choices(2) := choice(median_of_low_0_c_below_b, median_of_low_0_b, median_of_low_0_c);
    median_median_middle_0_choices(1) := choice(median_of_middle_0_c_below_a, median_of_middle_0_c,
      median_of_middle_0_a);
    median_median_middle_0_choices(2) := choice(median_of_middle_0_c_below_b, median_of_middle_0_b,
      median_median_middle_0_choices(1));
    median_median_middle_0_choices(3) := choice(median_of_middle_0_c_below_b, median_of_middle_0_c,
      median_of_middle_0_b);
    median_median_middle_0_choices(4) := choice(median_of_middle_0_c_below_a, median_of_middle_0_a,
      median_median_middle_0_choices(3));
    median_smallest_high_0_choices(1) := choice(median_of_high_0_c_below_b, median_of_high_0_c, median_of_high_0_b);
    median_smallest_high_0_choices(2) := choice(median_of_high_0_c_below_a, median_of_high_0_c, median_of_high_0_a);
    median_out_disparity_0_choices(1) := choice(median_of_all_0_c_below_a, median_of_all_0_c, median_of_all_0_a);
    median_out_disparity_0_choices(2) := choice(median_of_all_0_c_below_b, median_of_all_0_b,
      median_out_disparity_0_choices(1));
    median_out_disparity_0_choices(3) := choice(median_of_all_0_c_below_b, median_of_all_0_c, median_of_all_0_b);
    median_out_disparity_0_choices(4) := choice(median_of_all_0_c_below_a, median_of_all_0_a,
      median_out_disparity_0_choices(3));
    median_counter_next_frame <= winners_best_place_0;
    median_newest_0 <= (fill_out_disparity_0 * 2) + as_number(fill_out_passed_0);
    median_arrives <= fill_out_tag_row_start_alls(2);
    median_behind <= median_line_ended and fill_out_tag.valid;
    median_rows_read_newest_0 <= median_newest_0;
    median_rows_ready_words_0 <= to_integer(median_rows_read_words_0);
    median_rows_ready_newest_0 <= median_rows_read_newest_0;
    median_read_column <= median_counter_column;
    median_read_arrives <= median_arrives;
    median_read_behind <= median_behind;
    median_read_top <= median_counter_group = 1;
    median_read_bottom <= median_counter_group_is_equal;
    median_read_output <= (median_counter_group >= 1) and (median_counter_group < 376);
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
    median_waiting_passed_0(1 to 2) <= median_waiting_passed_0(0 to 1);
    median_beside_newest_0 <= (fill_out_sure_0 * 2) + as_number(fill_out_filled_0);
    median_beside_rows_read_newest_0 <= median_beside_newest_0;
    median_beside_rows_ready_words_0 <= to_integer(median_beside_rows_read_words_0);
    median_beside_rows_ready_newest_0 <= median_beside_rows_read_newest_0;
    median_beside_column_0 <= median_beside_rows_ready_words_0;
    median_beside_of_column_0(0) <= median_beside_column_0;
    median_beside_of_column_0(1) <= median_beside_of_column_0(0);
    median_beside_waiting_0(0) <= median_beside_in_window_0(1);
    median_beside_waiting_0(1 to 2) <= median_beside_waiting_0(0 to 1);
    median_out_passed_0 <= median_waiting_passed_0(2);
    median_out_confidence_0 <= median_beside_waiting_0(2) / 2;
    median_out_filled_0 <= is_set(median_beside_waiting_0(2), 0);
    median_out_valid <= median_waiting_complete(2);
    median_out_start_of_frame <= median_waiting_first(2) and median_waiting_complete(2);
    median_out_end_of_line <= median_waiting_last(2) and median_waiting_complete(2);
    median_counter_group <= choice(fill_out_tag.start_of_frame and fill_out_tag.map_column and fill_out_tag.valid,
      median_counter_group_choice, median_counter_group_choices(3));
    median_line_ended <= choice(fill_out_tag.end_of_line, median_line_ended_choice, median_line_ended and (not
      fill_out_tag.valid));
    median_sorted_low_0 <= choice(median_of_column_0_b_below_a, median_sorted_low_0_choices(1),
      median_sorted_low_0_choices(2));
    median_sorted_middle_0 <= choice(median_of_column_0_b_below_a, median_sorted_middle_0_choices(1),
      median_sorted_middle_0_choices(2));
    median_sorted_high_0 <= choice(median_of_column_0_b_below_a, median_sorted_high_0_choices(1),
      median_sorted_high_0_choices(2));
    median_passed_0(1) <= choice(median_passed_0(0), median_passed_0(1) or median_sorted_arrives or
      median_sorted_behind, median_passed_0(1) and (not median_sorted_arrives) and (not median_sorted_behind));
    median_largest_low_0 <= choice(median_of_low_0_b_below_a, median_largest_low_0_choices(1),
      median_largest_low_0_choices(2));
    median_median_middle_0 <= choice(median_of_middle_0_b_below_a, median_median_middle_0_choices(2),
      median_median_middle_0_choices(4));
    median_smallest_high_0 <= choice(median_of_high_0_b_below_a, median_smallest_high_0_choices(1),
      median_smallest_high_0_choices(2));
    median_out_disparity_0 <= choice(median_of_all_0_b_below_a, median_out_disparity_0_choices(2),
      median_out_disparity_0_choices(4));
    if median_ready_arrives then
      median_rows_write_words_0 <= (median_rows_ready_words_0 / 8192) + (median_rows_ready_newest_0 * 8192);
      median_at_column <= median_ready_column;
      median_beside_rows_write_words_0 <= median_beside_rows_ready_newest_0;
    end if;
    median_low_0_0_choice := choice(median_sorted_behind, median_low_0(0), median_sorted_low_0);
    median_low_0_all(1) := median_window_complete_is_equal and median_sorted_arrives;
    median_middle_0_0_choice := choice(median_sorted_behind, median_middle_0(0), median_sorted_middle_0);
    median_high_0_0_choice := choice(median_sorted_behind, median_high_0(0), median_sorted_high_0);
    median_low_0_all(0) := (not median_sorted_arrives) and (not median_sorted_behind);
    if not median_low_0_all(0) then
      median_low_0(0) <= median_low_0_0_choice;
      median_low_0(2) <= median_low_0(1);
      median_middle_0(0) <= median_middle_0_0_choice;
      median_middle_0(2) <= median_middle_0(1);
      median_high_0(0) <= median_high_0_0_choice;
      median_high_0(2) <= median_high_0(1);
      median_beside_in_window_0(1) <= median_beside_in_window_0(0);
      median_low_0(1) <= choice(median_low_0_all(1), median_low_0_0_choice, median_low_0(0));
      median_middle_0(1) <= choice(median_low_0_all(1), median_middle_0_0_choice, median_middle_0(0));
      median_high_0(1) <= choice(median_low_0_all(1), median_high_0_0_choice, median_high_0(0));
    end if;
    if median_sorted_arrives then
      median_passed_0(0) <= median_column_passed_0(1);
      median_beside_in_window_0(0) <= median_beside_of_column_0(1);
    end if;
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
    for i in 5 to 6 loop
      relief_newest_choice(3 * i - 6) := choice(relief_newest_choice(8), is_set(relief_newest_values_from_6(6), 2 * i -
        8), is_set(relief_newest_values_from_6(7), 2 * i - 8));
      relief_newest_choice(3 * i - 5) := choice(relief_newest_choice(8), not is_set(relief_newest_values_from_6(6), 4 *
        i - 17), not is_set(relief_newest_values_from_6(7), 4 * i - 17));
      relief_newest_choice(3 * i - 4) := choice(relief_newest_choice(8), is_set(relief_newest_values_from_6(6), i),
        is_set(relief_newest_values_from_6(7), i));
    end loop;
    relief_newest_choice(15) := inverted_carry(relief_newest_choice(7), is_set(relief_centre_grey_0, 7), not
      is_set(relief_before, 7));
    relief_newest_choice_16 := choice(relief_newest_choice(15), (relief_newest_values_from_6(7) / 2) mod 32,
      (relief_newest_values_from_6(6) / 2) mod 32);
    relief_centre_grey_0 <= relief_centre_column(4);
    relief_delayed_0 <= relief_newest;
    relief_rows_read_newest_0 <= relief_delayed_0;
    relief_rows_ready_words_0 <= to_integer(relief_rows_read_words_0);
    relief_rows_ready_newest_0 <= relief_rows_read_newest_0;
    relief_shown_0 <= relief_rows_ready_words_0;
    relief_waiting(0) <= relief_column_0;
    relief_waiting(1 to 9) <= relief_waiting(0 to 8);
    relief_entered <= relief_entering;
    relief_newest <= choice((not ((not ((not ((not relief_newest_choice(9)) and relief_newest_choice(10))) and
      relief_newest_choice(11) and relief_newest_choice(12))) and relief_newest_choice(13))) or
      relief_newest_choice(14), 25, relief_newest_choice_16);
    relief_entering <= choice(relief_waiting(9) < 25, relief_waiting(9), 25);
    if transform_filtering_valid(1) then relief_before <= relief_centre_grey_0; end if;
    if rows_ready_tag.valid then relief_rows_write_words_0 <= relief_rows_ready_newest_0; end if;
    if rows_tag.valid then relief_column_0 <= relief_shown_0; end if;
    -- other
    other_0 <= fill_ends_read_place_0_is_equal;
    other_1 <= ((median_rows_ready_words_0 mod 8192) / 2) * 2;
    other_2 <= support_centre_rest_0(2) mod 16;
    other_3 <= support_centre_0(2) mod 64;
    other_4 <= ((refinement_remainder_0_difference(7) / 512) * 2) + ((other_5 / 4) * 4);
    other_5 <= ((refinement_remainder_0_difference(6) / 512) * 4) + ((other_6 / 8) * 8);
    other_6 <= ((refinement_remainder_0_difference(5) / 512) * 8) + ((other_7 / 16) * 16);
    other_7 <= ((refinement_remainder_0_difference(4) / 512) * 16) + ((other_8 / 32) * 32);
    other_8 <= ((refinement_remainder_0_difference(3) / 512) * 32) + ((other_9 / 64) * 64);
    other_9 <= ((refinement_remainder_0_difference(2) / 512) * 64) + ((other_10 / 128) * 128);
    other_10 <= (refinement_remainder_1_0_difference / 512) * 128;
    if reset = '1' then
      transform_left_0 <= 0; transform_right_0 <= 0; transform_valid <= false; transform_counter_column <= 0;
      transform_counter_group <= 377; transform_counter_next_frame <= false; transform_left_rows_read_newest_0 <= 0;
      transform_left_rows_ready_words_0 <= to_unsigned(0, 32); transform_left_rows_ready_newest_0 <= 0;
      transform_left_rows_write_words_0 <= to_unsigned(0, 32); transform_right_rows_read_newest_0 <= 0;
      transform_right_rows_ready_words_0 <= to_unsigned(0, 32); transform_right_rows_ready_newest_0 <= 0;
      transform_right_rows_write_words_0 <= to_unsigned(0, 32); transform_read_column <= 0;
      transform_read_row_inside <= (others => false); transform_read_column_inside <= (others => false);
      transform_read_start_of_frame <= false; transform_read_valid <= false; transform_ready_column <= 0;
      transform_ready_row_inside <= (others => false); transform_ready_column_inside <= (others => false);
      transform_ready_start_of_frame <= false; transform_ready_valid <= false; transform_write_column <= 0;
      transform_left_column <= (others => 0); transform_right_column <= (others => 0);
      transform_columns_row_inside <= (others => false); transform_columns_column_inside <= (others => false);
      transform_columns_start_of_frame <= false; transform_columns_valid <= false;
      transform_left_filter_column <= (others => (others => 0)); transform_left_filter_feature_0 <= 0;
      transform_right_filter_column <= (others => (others => 0)); transform_right_filter_feature_0 <= 0;
      transform_filtering_0_column_inside <= (others => false); transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_search_0 <= 0; raster_features_reference_0 <= 0;
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 376;
      raster_place_next_frame <= false; delay_ahead_0 <= 0; delay_delayed_0 <= 0; delay_column <= 0;
      delay_row_inside <= (others => false); delay_tag <= (others => false); rows_search_rows_read_newest_0 <= 0;
      rows_search_rows_ready_words_0 <= 0; rows_search_rows_ready_newest_0 <= 0; rows_search_rows_write_words_0 <= 0;
      rows_reference_rows_read_newest_0 <= 0; rows_reference_rows_ready_words_0 <= 0;
      rows_reference_rows_ready_newest_0 <= 0; rows_reference_rows_write_words_0 <= 0; rows_read_column <= 0;
      rows_read_inside <= (others => false); rows_read_tag <= (others => false); rows_ready_column <= 0;
      rows_ready_inside <= (others => false); rows_ready_tag <= (others => false); rows_write_column <= 0;
      rows_search <= (others => 0); rows_reference <= (others => 0); rows_tag <= (others => false);
      slice0shift_search <= (others => (others => 0)); slice0shift_reference <= (others => 0);
      slice0shift_search_out <= (others => 0); slice0shift_tag <= (others => false);
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice0cost_pixels_first_count(i, j, 0) <= 0; slice0cost_pixels_first_count(i, j, 1) <= 0;
          slice0cost_pixels_first_count(i, j, 2) <= 0; slice0cost_pixels_first_count(i, j, 3) <= 0;
          slice0cost_pixels_first_count_4(i, j) <= 0;
        end loop;
      end loop;
      slice0cost_pixels_first_tag <= (others => false); slice0cost_pixels_cost <= (others => (others => 0));
      slice0cost_pixels_tag <= (others => false); slice0cost_pair_0 <= (others => 0);
      slice0cost_single_0 <= (others => 0); slice0cost_pair_tag <= (others => false);
      slice0cost_column_0 <= (others => 0); slice0cost_tag <= (others => false);
      slice0window_partial_0_0 <= (others => 0); slice0window_partial_0_1 <= (others => 0);
      slice0window_centre_map_column_0 <= false; slice0window_centre_output_column_0 <= false;
      slice0window_centre_first_column_0 <= false; slice0window_centre_start_of_frame_0 <= false;
      slice0window_centre_end_of_line_0 <= false; slice0window_sum_0 <= (others => 0);
      slice0window_tag <= (others => false); slice0mask_inside <= (others => false); slice0mask_left_out <= false;
      slice0mask_column <= 0; slice0_held <= (others => (others => 0));
      for i in 0 to 3 loop
        slice0_tag_valid(i) <= false; slice0_tag_map_column(i) <= false; slice0_tag_output_column(i) <= false;
        slice0_tag_first_column(i) <= false; slice0_tag_start_of_frame(i) <= false; slice0_tag_end_of_line(i) <= false;
      end loop;
      slice1shift_search <= (others => (others => 0)); slice1shift_reference <= (others => 0);
      slice1shift_search_out <= (others => 0);
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice1cost_pixels_first_count(i, j, 0) <= 0; slice1cost_pixels_first_count(i, j, 1) <= 0;
          slice1cost_pixels_first_count(i, j, 2) <= 0; slice1cost_pixels_first_count(i, j, 3) <= 0;
          slice1cost_pixels_first_count_4(i, j) <= 0;
        end loop;
      end loop;
      slice1cost_pixels_cost <= (others => (others => 0)); slice1cost_pair_0 <= (others => 0);
      slice1cost_single_0 <= (others => 0); slice1cost_column_0 <= (others => 0); slice1cost_tag_first_column <= false;
      slice1window_partial_0_0 <= (others => 0); slice1window_partial_0_1 <= (others => 0);
      slice1window_centre_first_column_0 <= false; slice1window_sum_0 <= (others => 0);
      slice1window_tag_first_column <= false; slice1mask_inside <= (others => false); slice1mask_left_out <= false;
      slice1_held <= (others => (others => 0)); slice1_tag_0_first_column <= false;
      slice2shift_search <= (others => (others => 0)); slice2shift_reference <= (others => 0);
      slice2shift_search_out <= (others => 0);
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice2cost_pixels_first_count(i, j, 0) <= 0; slice2cost_pixels_first_count(i, j, 1) <= 0;
          slice2cost_pixels_first_count(i, j, 2) <= 0; slice2cost_pixels_first_count(i, j, 3) <= 0;
          slice2cost_pixels_first_count_4(i, j) <= 0;
        end loop;
      end loop;
      slice2cost_pixels_cost <= (others => (others => 0)); slice2cost_pair_0 <= (others => 0);
      slice2cost_single_0 <= (others => 0); slice2cost_column_0 <= (others => 0); slice2cost_tag_first_column <= false;
      slice2window_partial_0_0 <= (others => 0); slice2window_partial_0_1 <= (others => 0);
      slice2window_centre_first_column_0 <= false; slice2window_sum_0 <= (others => 0);
      slice2mask_inside <= (others => false); slice2mask_left_out <= false; slice2_held <= (others => (others => 0));
      slice3shift_search <= (others => (others => 0)); slice3shift_reference <= (others => 0);
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice3cost_pixels_first_count(i, j, 0) <= 0; slice3cost_pixels_first_count(i, j, 1) <= 0;
          slice3cost_pixels_first_count(i, j, 2) <= 0; slice3cost_pixels_first_count(i, j, 3) <= 0;
          slice3cost_pixels_first_count_4(i, j) <= 0;
        end loop;
      end loop;
      slice3cost_pixels_cost <= (others => (others => 0)); slice3cost_pair_0 <= (others => 0);
      slice3cost_single_0 <= (others => 0); slice3cost_column_0 <= (others => 0);
      slice3window_partial_0_0 <= (others => 0); slice3window_partial_0_1 <= (others => 0);
      slice3window_sum_0 <= (others => 0); slice3mask_inside <= (others => false); slice3_held_0 <= (others => 0);
      entry_next_cost <= (others => 0); entry_next_tag <= (others => false); entry_next_column <= 0;
      entry_next_top <= false; entry_order_address <= 0; entry_order_falls <= false; entry_order_inside <= false;
      entry_order_complete <= false; entry_order_output <= false; entry_order_first <= false;
      entry_order_held_output <= false; entry_order_turned_output_column <= false;
      entry_order_turned_first_column <= false; entry_order_turned_start_of_frame <= false; entry_cost <= (others => 0);
      entry_tag <= (others => false); entry_column <= 0; entry_top <= false; entry_place <= 0;
      entry_turned_output_column <= false; entry_turned_first_column <= false; entry_turned_start_of_frame <= false;
      forward_smallest_smallest <= (others => 0); forward_smallest_next_smallest <= (others => 0);
      forward_smallest_next_next_smallest <= (others => 0); forward_smallest_next_next_next_smallest <= (others => 0);
      forward_smallest_next_next_next_next_smallest <= (others => 0);
      forward_smallest_next_next_next_next_next_smallest_0 <= 0; forward_cost_delay_ring_read_address <= 1;
      forward_cost_delay_ring_write_address <= 0; forward_left_pair <= (others => 0);
      forward_left_tree_smallest <= (others => 0); forward_left_tree_next_smallest <= (others => 0);
      forward_left_tree_next_next_smallest <= (others => 0); forward_left_tree_next_next_next_smallest <= (others => 0);
      forward_left_tree_next_next_next_next_smallest_0 <= 0; forward_left_start_cost <= (others => 0);
      forward_left_room <= 0; forward_left_smallest <= 0; forward_left_smallest_less <= 0;
      forward_left_first <= (others => false); forward_left_relief_next <= (others => 0);
      forward_left_relief_past <= (others => 0); forward_left_relief_pairs <= (others => 0);
      forward_left_relief_fours <= (others => 0); forward_left_relief_older <= 0; forward_left_relief_recent <= 0;
      forward_left_relief_largest <= 0; forward_left_relief_beyond <= 0; forward_left_relief_reach_of_best <= 0;
      forward_left_relief_leaves <= 0; forward_left_relief_room_of_best <= 0; forward_left_relief_reach_again <= 0;
      forward_left_g_copy(0) <= 0; forward_left_g_copy(1) <= 1; forward_left_g_copy(2) <= 2;
      forward_left_g_copy(3) <= 3; forward_left_g_less_copy(0) <= 0; forward_left_g_less_copy(1) <= 1;
      forward_left_g_less_copy(2) <= 2; forward_left_g_less_copy(3) <= 3; forward_left_stay_change <= (others => 0);
      forward_left_step_change <= (others => 0); forward_left_cost <= (others => 0);
      forward_left_arrived <= (others => 0); forward_above_ready_words <= (others => 0);
      forward_above_ready_words_10 <= 0; forward_above_ready_cost <= (others => 0); forward_above_ready_top <= false;
      forward_above_total <= (others => 0); forward_above_tree_smallest <= (others => 0);
      forward_above_tree_next_smallest <= (others => 0); forward_above_tree_next_next_smallest <= (others => 0);
      forward_above_tree_next_next_next_smallest <= (others => 0);
      forward_above_tree_next_next_next_next_smallest <= (others => 0);
      forward_above_tree_next_next_next_next_next_smallest_0 <= 0; forward_above_delay_ring_read_address <= 1;
      forward_above_delay_ring_write_address <= 0; forward_above_smallest_copy(0) <= 0;
      forward_above_smallest_copy(1) <= 1; forward_above_smallest_copy(2) <= 2; forward_above_smallest_copy(3) <= 3;
      forward_above_cost <= (others => 0); forward_above_beside <= (others => 0); forward_above_own_0 <= 0;
      forward_above_own <= (others => 0); forward_above_own_63 <= 0; forward_above_step <= (others => 0);
      forward_above_stay <= (others => 0); forward_above_comes <= (others => false);
      forward_above_column <= (others => 0); forward_above_writes_copy_0 <= false;
      forward_above_write_words <= (others => 0); forward_above_write_words_10 <= 0; forward_above_write_column <= 0;
      forward_sum <= (others => 0); forward_first <= (others => false); forward_reliefs_moved <= (others => 0);
      forward_cost <= (others => (others => 0)); forward_smallest_cost <= (others => 0);
      sums_turn_ready_sums <= (others => 0); sums_turn_ready_costs <= (others => 0); sums_turn_ready_costs_6 <= 0;
      sums_turn_ready_smallest_0 <= 0; sums_turn_ready_first <= false; sums_turn_place <= (others => 0);
      sums_turn_writes_copy_0 <= false; sums_turn_write_sums <= (others => 0); sums_turn_write_costs <= (others => 0);
      sums_turn_write_costs_6 <= 0; sums_turn_write_smallest_0 <= 0; sums_turn_write_place <= 0;
      sums_turn_waiting_read_place <= 0; sums_turn_waiting_first <= (others => false);
      sums_cost <= (others => (others => 0)); sums_right_pair <= (others => 0);
      sums_right_tree_smallest <= (others => 0); sums_right_tree_next_smallest <= (others => 0);
      sums_right_tree_next_next_smallest <= (others => 0); sums_right_tree_next_next_next_smallest <= (others => 0);
      sums_right_tree_next_next_next_next_smallest_0 <= 0; sums_right_start_cost <= (others => 0); sums_right_room <= 0;
      sums_right_smallest <= 0; sums_right_smallest_less <= 0; sums_right_first <= (others => false);
      sums_right_relief_next <= (others => 0); sums_right_relief_past <= (others => 0);
      sums_right_relief_pairs <= (others => 0); sums_right_relief_fours <= (others => 0); sums_right_relief_older <= 0;
      sums_right_relief_recent <= 0; sums_right_relief_largest <= 0; sums_right_relief_beyond <= 0;
      sums_right_relief_reach_of_best <= 0; sums_right_relief_leaves <= 0; sums_right_relief_room_of_best <= 0;
      sums_right_relief_reach_again <= 0; sums_right_g_copy(0) <= 0; sums_right_g_copy(1) <= 1;
      sums_right_g_copy(2) <= 2; sums_right_g_copy(3) <= 3; sums_right_g_less_copy(0) <= 0;
      sums_right_g_less_copy(1) <= 1; sums_right_g_less_copy(2) <= 2; sums_right_g_less_copy(3) <= 3;
      sums_right_stay_change <= (others => 0); sums_right_step_change <= (others => 0);
      sums_right_cost <= (others => 0); sums_right_arrived <= (others => 0); sums_sum_delay_ring_read_address <= 1;
      sums_sum_delay_ring_write_address <= 0; sums_sum_0 <= (others => 0); sums_tag <= (others => false);
      for i in 0 to 11 loop
        sums_tags_held_output_column(i) <= false; sums_tags_held_start_of_frame(i) <= false;
        sums_tags_held_end_of_line(i) <= false;
      end loop;
      for i in 12 to 15 loop
        sums_tags_held_map_column(i) <= false; sums_tags_held_output_column(i) <= false;
        sums_tags_held_first_column(i) <= false; sums_tags_held_start_of_frame(i) <= false;
        sums_tags_held_end_of_line(i) <= false;
      end loop;
      sums_tags_moved <= false; winnersmask_inside <= (others => false); winnersmask_column <= 0;
      winnersother_cost_0 <= (others => 0); winnersother_winner_0 <= (others => 0); winnersother_winner_out_0 <= 0;
      winnerswinner1_held_0 <= (others => 0); winnerswinner1_best_cost_0 <= (others => 0);
      winnerswinner1_best_index_0_0 <= false; winnerswinner1_best_index_0 <= (others => 0);
      winnerswinner1_best_below_0 <= (others => 0); winnerswinner1_best_above_0 <= (others => 0);
      winnerswinner1_best_place_0 <= (others => false); winnerswinner1_best_late_cost_0 <= (others => 0);
      winnerswinner1_best_but_first_0 <= (others => 255); winnerswinner1_best_but_last_0 <= (others => 255);
      winnerswinner1_tag <= (others => false); winnerswinner2_best_cost_0 <= (others => 0);
      winnerswinner2_best_index_0 <= (others => 0); winnerswinner2_best_below_0 <= (others => 0);
      winnerswinner2_best_above_0 <= (others => 0); winnerswinner2_best_first_0 <= (others => 0);
      winnerswinner2_best_last_0 <= (others => 0); winnerswinner2_best_place_0 <= (others => false);
      winnerswinner2_best_at_start_0 <= (others => false); winnerswinner2_best_at_end_0 <= (others => false);
      winnerswinner2_best_late_cost_0 <= (others => 0); winnerswinner2_best_second_0 <= (others => 255);
      winnerswinner2_best_but_first_0 <= (others => 255); winnerswinner2_best_but_last_0 <= (others => 255);
      winnerswinner2_tag <= (others => false); winnerswinner3_best_cost_0 <= (others => 0);
      winnerswinner3_best_index_0 <= (others => 0); winnerswinner3_best_below_0 <= (others => 0);
      winnerswinner3_best_above_0 <= (others => 0); winnerswinner3_best_first_0 <= (others => 0);
      winnerswinner3_best_last_0 <= (others => 0); winnerswinner3_best_place_0 <= (others => false);
      winnerswinner3_best_at_start_0 <= (others => false); winnerswinner3_best_at_end_0 <= (others => false);
      winnerswinner3_best_late_cost_0 <= (others => 0); winnerswinner3_best_second_0 <= (others => 255);
      winnerswinner3_best_but_first_0 <= (others => 255); winnerswinner3_best_but_last_0 <= (others => 255);
      winnerswinner3_tag <= (others => false); winnerswinner4_best_cost_0 <= (others => 0);
      winnerswinner4_best_index_0 <= (others => 0); winnerswinner4_best_below_0 <= (others => 0);
      winnerswinner4_best_above_0 <= (others => 0); winnerswinner4_best_first_0 <= (others => 0);
      winnerswinner4_best_last_0 <= (others => 0); winnerswinner4_best_place_0 <= (others => false);
      winnerswinner4_best_at_start_0 <= (others => false); winnerswinner4_best_at_end_0 <= (others => false);
      winnerswinner4_best_late_cost_0 <= (others => 0); winnerswinner4_best_second_0 <= (others => 255);
      winnerswinner4_best_but_first_0 <= (others => 255); winnerswinner4_best_but_last_0 <= (others => 255);
      winnerswinner4_tag <= (others => false); winnerswinner5_best_cost_0 <= (others => 0);
      winnerswinner5_best_index_0 <= (others => 0); winnerswinner5_best_below_0 <= (others => 0);
      winnerswinner5_best_above_0 <= (others => 0); winnerswinner5_best_first_0_1 <= 0;
      winnerswinner5_best_last_0_0 <= 0; winnerswinner5_best_place_0 <= (others => false);
      winnerswinner5_best_at_start_0 <= (others => false); winnerswinner5_best_at_end_0 <= (others => false);
      winnerswinner5_best_late_cost_0 <= (others => 0); winnerswinner5_best_second_0 <= (others => 255);
      winnerswinner5_best_but_first_0_1 <= 255; winnerswinner5_best_but_last_0_0 <= 255;
      winnerswinner5_tag <= (others => false); winnerswinner6_best_cost_0_0 <= 0; winnerswinner6_best_index_0_0 <= 0;
      winnerswinner6_best_below_0_0 <= 0; winnerswinner6_best_above_0_0 <= 0; winnerswinner6_best_place_0_0 <= false;
      winnerswinner6_best_at_start_0_0 <= false; winnerswinner6_best_at_end_0_0 <= false;
      winnerswinner6_best_late_cost_0_0 <= 0; winnerswinner6_best_second_0_0 <= 255;
      winnerswinner6_tag <= (others => false); winners_best_index_0_0 <= 0; winners_best_below_0_0 <= 0;
      winners_best_above_0_0 <= 0; winners_best_late_cost_0_0 <= 0; winners_best_second_0_0 <= 255;
      winners_best_tag <= (others => false); winners_partner_column <= 0; winners_partner_at <= 0;
      refinement_disparity_0 <= (others => 0); refinement_passed_0 <= (others => false);
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_map_column(i) <= false;
        refinement_tag_output_column(i) <= false; refinement_tag_start_of_frame(i) <= false;
        refinement_tag_end_of_line(i) <= false;
      end loop;
      refinement_alone_0_0 <= false; refinement_gap_0 <= 0; refinement_margin_0 <= (others => 0);
      refinement_below_0 <= 0; refinement_above_0 <= 0; refinement_u_0 <= 0; refinement_v_0 <= 0;
      refinement_difference_0 <= 0; refinement_remainder_0 <= (others => 0); refinement_divisor_0 <= (others => 1);
      refinement_quotient_8_0 <= 0; refinement_negative_0 <= (others => false); refinement_fraction_0 <= 8;
      leftright_other_0 <= (others => 0); leftright_ring_read_address <= 1; leftright_ring_write_address <= 0;
      leftright_holds_winners <= false; leftright_position <= 0; leftright_held_position <= 0;
      leftright_held_valid <= false; leftright_address_0 <= 0; leftright_asking_disparity_0 <= 0;
      leftright_asking_fraction_0 <= 8; leftright_asking_passed_0 <= true; leftright_asking_margin_0 <= 0;
      leftright_asking_tag <= (others => false); leftright_answered_disparity_0 <= 0;
      leftright_answered_fraction_0 <= 8; leftright_answered_passed_0 <= true; leftright_answered_margin_0 <= 0;
      leftright_answered_tag <= (others => false); leftright_checked_disparity_0 <= 0;
      leftright_checked_fraction_0 <= 8; leftright_checked_passed_0 <= true; leftright_checked_margin_0 <= 0;
      leftright_checked_tag <= (others => false); turn_order_address <= 0; turn_order_falls <= false;
      turn_order_inside <= false; turn_order_complete <= false; turn_order_output <= false; turn_order_first <= false;
      turn_order_turned_valid <= false; turn_order_turned_map_column <= false;
      turn_order_turned_start_of_frame <= false; turn_order_turned_end_of_line <= false; turn_newest <= 0;
      turn_comes <= false; turn_read_tag <= (others => false); turn_write_words_0 <= 0; turn_write_place <= 0;
      turn_ready <= 0; turn_ready_tag <= (others => false); support_counter_column <= 0; support_counter_group <= 377;
      support_newest_0 <= 0; support_newest_rest_0 <= 0; support_moves <= false; support_arrives <= false;
      support_last <= false; support_rows_read_newest_0 <= 0; support_rows_ready_words_0 <= 0;
      support_rows_ready_newest_0 <= 0; support_rows_write_words_0 <= 0; support_rest_rows_read_newest_0 <= 0;
      support_rest_rows_ready_words_0 <= 0; support_rest_rows_ready_newest_0 <= 0; support_rest_rows_write_words_0 <= 0;
      support_read_column <= 0; support_read_moves <= false; support_read_arrives <= false;
      support_read_above2 <= false; support_read_above1 <= false; support_read_below1 <= false;
      support_read_below2 <= false; support_read_first <= false; support_read_last <= false; support_ready_column <= 0;
      support_ready_moves <= false; support_ready_arrives <= false; support_ready_above2 <= false;
      support_ready_above1 <= false; support_ready_below1 <= false; support_ready_below2 <= false;
      support_ready_first <= false; support_ready_last <= false; support_write_column <= 0;
      support_column <= (others => 0); support_column_rest_0 <= 0; support_at_moves <= false;
      support_at_arrives <= false; support_at_first <= false; support_at_last <= false;
      support_cells <= (others => (others => 0)); support_row_tag <= (others => false); support_rest_0 <= (others => 0);
      for i in 0 to 6 loop
        support_moment_map_column(i) <= false; support_moment_start_of_frame(i) <= false;
        support_moment_last(i) <= false;
      end loop;
      support_next_tag <= false; support_moved <= false; support_like_0 <= (others => (others => false));
      support_partial_0 <= (others => 0); support_count_0 <= 0; support_enough_0 <= false; support_sum_0 <= 0;
      support_centre_0 <= (others => 0); support_centre_rest_0 <= (others => 0);
      for i in 0 to 3 loop
        support_centre_moment_map_column(i) <= false; support_centre_moment_start_of_frame(i) <= false;
        support_centre_moment_last(i) <= false;
      end loop;
      support_centre_moved <= (others => false); support_out_disparity_0 <= 0; support_out_passed_0 <= false;
      support_out_sure_0 <= 0; support_out_tag <= (others => false); fill_counter_column <= 0;
      fill_counter_group <= 376; fill_newest_disparity_0 <= 0; fill_newest_passed_0 <= false; fill_newest_sure_0 <= 0;
      fill_moves <= false; fill_arrives <= false; fill_last <= false; fill_rows_read_newest_0 <= 0;
      fill_rows_ready_words_0 <= 0; fill_rows_ready_newest_0 <= 0; fill_rows_write_words_0 <= 0; fill_read_column <= 0;
      fill_read_moves <= false; fill_read_arrives <= false; fill_read_top <= false; fill_read_last <= false;
      fill_ready_column <= 0; fill_ready_moves <= false; fill_ready_arrives <= false; fill_ready_top <= false;
      fill_ready_last <= false; fill_write_column <= 0; fill_ends_open_0 <= false; fill_pixel_0_passed <= false;
      fill_at_column <= 0; fill_at_moves <= false; fill_at_arrives <= false; fill_at_top <= false;
      fill_at_last <= false; fill_in_hole_0 <= false; fill_asking_0_passed <= (others => false);
      for i in 0 to 1 loop
        fill_asking_at_column(i) <= 0; fill_asking_at_moves(i) <= false; fill_asking_at_arrives(i) <= false;
        fill_asking_at_top(i) <= false; fill_asking_at_last(i) <= false;
      end loop;
      fill_hole_starts_0 <= (others => false); fill_known_at_column <= 0; fill_known_at_moves <= false;
      fill_known_at_arrives <= false; fill_known_at_top <= false; fill_known_at_last <= false;
      fill_measured_at_column <= 0; fill_measured_at_moves <= false; fill_measured_at_arrives <= false;
      fill_measured_at_top <= false; fill_measured_at_last <= false; fill_chosen_at_column <= 0;
      fill_chosen_at_moves <= false; fill_chosen_at_arrives <= false; fill_chosen_at_top <= false;
      fill_chosen_at_last <= false; fill_out_tag <= (others => false); median_counter_column <= 0;
      median_counter_group <= 376; median_arrives <= false; median_behind <= false; median_line_ended <= false;
      median_read_column <= 0; median_read_arrives <= false; median_read_behind <= false; median_read_top <= false;
      median_read_output <= false; median_ready_column <= 0; median_ready_arrives <= false;
      median_ready_behind <= false; median_ready_top <= false; median_ready_output <= false; median_write_column <= 0;
      median_at_arrives <= false; median_at_behind <= false; median_at_top <= false; median_at_output <= false;
      median_comparing_column <= 0; median_comparing_arrives <= false; median_comparing_behind <= false;
      median_comparing_top <= false; median_comparing_output <= false; median_sorted_column <= 0;
      median_sorted_arrives <= false; median_sorted_behind <= false; median_sorted_top <= false;
      median_sorted_output <= false; median_window_complete <= false; median_window_first <= false;
      median_window_last <= false;
      for i in 0 to 2 loop
        median_waiting_complete(i) <= false; median_waiting_first(i) <= false; median_waiting_last(i) <= false;
      end loop;
      median_out_valid <= false; median_out_start_of_frame <= false; median_out_end_of_line <= false;
      relief_centre_column <= (others => 0); relief_centre_grey_0 <= 0; relief_before <= 0; relief_newest <= 0;
      relief_delayed_0 <= 0; relief_rows_read_newest_0 <= 0; relief_rows_ready_words_0 <= 0;
      relief_rows_ready_newest_0 <= 0; relief_rows_write_words_0 <= 0; relief_shown_0 <= 0; relief_column_0 <= 0;
      relief_waiting <= (others => 0); relief_entering <= 0; relief_entered <= 0; other_0 <= true; other_2 <= 0;
      other_3 <= 0; other_4 <= 0; other_5 <= 0; other_6 <= 0; other_7 <= 0; other_8 <= 0; other_9 <= 0; other_10 <= 0;
    end if;
  end process;
end architecture;
