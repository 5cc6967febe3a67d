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
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
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
  type boolean_3d is array (natural range <>, natural range <>, natural range <>) of boolean;
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
  type natural_31_2d is array (natural range <>, natural range <>) of natural range 0 to 31;
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
  type tag_6 is record
    valid, map_column, output_column, first_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_5 is record
    valid, map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, map_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_5_b is record
    valid, row_start, map_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_start_of_frame, in_valid : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0, transform_left_rows_ready_newest_0,
    transform_right_rows_read_newest_0, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 2);  -- _2#
  signal transform_left_filter_column, transform_right_filter_column : natural_255_2d(0 to 8, 0 to 2);  -- _#_2#
  signal transform_valid, transform_counter_next_frame, transform_counter_last_column, transform_counter_counts,
    transform_counter_frame_joins, transform_counter_back_to_back, transform_counter_next_frame_after,
    transform_read_row_inside_0 : boolean;
  signal transform_read_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside : boolean_1d(0 to 2);  -- _2#
  signal transform_ready_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_reached_first : boolean_1d(0 to 2);  -- _2#
  signal transform_reached_beyond_last : boolean_1d(2 to 3);
  signal transform_columns_row_inside : boolean_1d(0 to 2);  -- _2#
  signal transform_columns_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_left_filter_low_is_larger_0 : boolean_2d(0 to 1, 0 to 2);  -- _2#_2#
  signal transform_left_filter_low_is_larger_0_4_0, transform_left_filter_low_is_larger_0_4_4 : boolean;
  signal transform_left_filter_low_is_larger_0s : boolean_2d(3 to 4, 0 to 2);  -- _0_2#_2#
  signal transform_right_filter_low_is_larger_0 : boolean_2d(0 to 1, 0 to 2);  -- _2#_2#
  signal transform_right_filter_low_is_larger_0_4_0, transform_right_filter_low_is_larger_0_4_4 : boolean;
  signal transform_right_filter_low_is_larger_0s : boolean_2d(3 to 4, 0 to 2);  -- _0_2#_2#
  signal transform_filtering_0_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_filtering_start_of_frame : boolean_1d(0 to 2);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 2);  -- _#_valid
  signal transform_counter_column, transform_counter_column_after, transform_read_column, transform_ready_column,
    transform_write_column : natural range 0 to 1023;
  signal transform_counter_group, transform_counter_group_after : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0, transform_left_rows_write_words_0,
    transform_right_rows_read_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame, raster_place_last_column, raster_place_counts,
    raster_place_frame_joins, raster_place_back_to_back : boolean;
  signal raster_place_column, raster_place_column_after : natural range 0 to 1023;
  signal raster_place_group, raster_place_group_after : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16383;
  signal delay_column : natural range 0 to 1023;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag : tag_6;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_search, rows_reference : natural_16383_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 1023;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag : tag_6;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag, rows_tag : tag_6;
  -- line
  signal line_centre_map_column_0, line_centre_output_column_0, line_centre_first_column_0,
    line_centre_start_of_frame_0, line_centre_end_of_line_0, line_order_falls, line_order_inside, line_order_complete,
    line_order_output, line_order_first, line_order_held_output, line_order_turned_valid, line_order_turned_map_column,
    line_order_turned_output_column, line_order_turned_first_column, line_order_turned_start_of_frame,
    line_order_turned_end_of_line, line_newest_first_column, line_newest_top : boolean;
  signal line_comes, line_starts_phases : boolean_1d(1 to 33);
  signal line_places_map_column : boolean_1d(0 to 4);  -- _#_map_column
  signal line_places_first_column : boolean_1d(0 to 4);  -- _#_first_column
  signal line_places_0_top : boolean;
  signal line_places_shown_output_column : boolean_1d(0 to 4);  -- _#_shown_output_column
  signal line_places_shown_first_column : boolean_1d(0 to 2);  -- _#_shown_first_column
  signal line_places_shown_start_of_frame : boolean_1d(0 to 4);  -- _#_shown_start_of_frame
  signal line_places_shown_end_of_line : boolean_1d(0 to 4);  -- _#_shown_end_of_line
  signal line_order_address : natural range 0 to 1023;
  signal line_places_address : natural_1023_1d(0 to 2);  -- _#_address
  -- costsshift
  signal costsshift_newest, costsshift_new_reference, costsshift_handed_on,
    costsshift_read_reference : natural_16383_1d(0 to 2);
  signal costsshift_search : natural_16383_2d(0 to 2, 0 to 7);
  signal costsshift_reference : natural_16383_1d(0 to 2);
  signal costsshift_new_tag_valid, costsshift_read_tag_valid : boolean;
  signal costsshift_count_phase, costsshift_read_count_phase, costsshift_write_phase : natural range 0 to 7;
  signal costsshift_read_words : unsigned_28_1d(0 to 11);
  -- costscolumn
  signal costscolumn_pixels_first_count : natural_3_3d(0 to 2, 0 to 7, 0 to 3);  -- _#_#_count_#
  signal costscolumn_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 7);  -- _#_#_count_4
  signal costscolumn_pixels_cost : natural_14_2d(0 to 2, 0 to 7);
  signal costscolumn_single_0 : natural_14_1d(0 to 7);
  signal costscolumn_pair_0 : natural_28_1d(0 to 7);
  signal costscolumn_column_0 : natural_42_1d(0 to 7);
  -- costswindow
  signal costswindow_read_count_phase, costswindow_write_count_phase : natural range 0 to 7;
  signal costswindow_read_words : unsigned_27_1d(0 to 1);
  signal costswindow_read_wordss : unsigned_28_1d(2 to 3);  -- _words_#
  signal costswindow_partial : natural_42_1d(0 to 7);
  signal costswindow_partials : natural_105_1d(8 to 15);  -- _partial_#
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
  signal pathsleft_fresh_past_eight, pathsleft_fresh_past_oldest, pathsleft_fresh_past_cheapest,
    pathsleft_fresh_here : natural range 0 to 64;
  signal pathsleft_fresh_known, pathsleft_q_less, pathsleft_g_less, pathsleft_lower_neighbour : natural range 0 to 127;
  signal pathsleft_stay, pathsleft_step, pathsleft_stay_change, pathsleft_step_change, pathsleft_cost,
    pathsleft_arrived : natural_127_1d(0 to 7);
  signal pathsleft_tree_smallest : natural_127_1d(0 to 3);
  signal pathsleft_tree_next_smallest : natural_127_1d(0 to 1);
  signal pathsleft_tree_next_next_smallest_0, pathsleft_low_0 : natural range 0 to 127;
  signal pathsleft_low_address, pathsleft_low_write_address : natural range 0 to 15;
  signal pathsleft_lowest_0, pathsleft_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsleft_lost, pathsleft_short_of, pathsleft_first, pathsleft_is_first, pathsleft_is_last : boolean;
  signal pathsleft_missing, pathsleft_below, pathsleft_q, pathsleft_room_left, pathsleft_q_now,
    pathsleft_room : natural range 0 to 63;
  signal pathsleft_start_cost : natural_63_1d(1 to 8);
  signal pathsleft_g : natural range 0 to 84;
  signal pathsleft_read_count_phase, pathsleft_ahead_count_phase, pathsleft_write_count_phase : natural range 0 to 7;
  signal pathsleft_read_words : unsigned_28_1d(0 to 3);
  -- pathsabove
  signal pathsabove_memory_read_address_0, pathsabove_memory_write_address_0 : natural range 0 to 4095;
  signal pathsabove_memory_read_address_1, pathsabove_memory_write_address_1 : natural range 0 to 1023;
  signal pathsabove_memory_bank, pathsabove_memory_read_bank, pathsabove_memory_held_bank, pathsabove_ready_top,
    pathsabove_write_address_is_here : boolean;
  signal pathsabove_memory_read_words : unsigned_16_2d(0 to 1, 0 to 1);
  signal pathsabove_memory_read_words_2 : unsigned_8_1d(0 to 1);  -- _#_2
  signal pathsabove_memory_held_words : natural_65535_2d(0 to 1, 0 to 1);
  signal pathsabove_memory_ready_words : natural_65535_1d(0 to 2);  -- _# up to 65535, 65535, 255
  signal pathsabove_memory_write_words : natural_65535_2d(0 to 1, 0 to 1);
  signal pathsabove_memory_held_words_2, pathsabove_memory_write_words_2 : natural_255_1d(0 to 1);  -- _#_2
  signal pathsabove_read_address_address, pathsabove_write_address_address : natural range 0 to 8191;
  signal pathsabove_read_address_count_phase, pathsabove_count_phase,
    pathsabove_write_address_count_phase : natural range 0 to 7;
  signal pathsabove_total : natural_52_1d(0 to 7);
  signal pathsabove_tree_smallest : natural_52_1d(0 to 3);
  signal pathsabove_tree_next_smallest : natural_52_1d(0 to 1);
  signal pathsabove_tree_next_next_smallest_0, pathsabove_smallest_total, pathsabove_smallest : natural range 0 to 52;
  signal pathsabove_delay_held_0 : unsigned(29 downto 0);
  signal pathsabove_delay_held_1 : unsigned(9 downto 0);
  signal pathsabove_cost, pathsabove_held : natural_31_1d(0 to 7);
  signal pathsabove_lower_neighbour : natural range 0 to 31;
  signal pathsabove_beside : natural_31_1d(0 to 7);
  signal pathsabove_own : natural_31_1d(0 to 6);
  signal pathsabove_stay : natural_31_1d(0 to 7);
  signal pathsabove_step : natural_36_1d(0 to 7);
  -- pathsturn
  signal pathsturn_sum_memory_read_address_0, pathsturn_sum_memory_write_address_0,
    pathsturn_cost_memory_read_address_0, pathsturn_cost_memory_write_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_read_address_1, pathsturn_sum_memory_write_address_1,
    pathsturn_cost_memory_read_address_1, pathsturn_cost_memory_write_address_1, pathsturn_smallest_address,
    pathsturn_write_smallest_address : natural range 0 to 1023;
  signal pathsturn_sum_memory_bank, pathsturn_sum_memory_read_bank, pathsturn_sum_memory_held_bank,
    pathsturn_cost_memory_bank, pathsturn_cost_memory_read_bank, pathsturn_cost_memory_held_bank,
    pathsturn_write_address_is_here : boolean;
  signal pathsturn_writes_sums : boolean_1d(0 to 1);
  signal pathsturn_sum_memory_read_words : unsigned_16_2d(0 to 1, 0 to 2);
  signal pathsturn_cost_memory_read_words_0 : unsigned_16_1d(0 to 1);  -- _#_0
  signal pathsturn_sum_memory_read_words_3 : unsigned_8_1d(0 to 1);  -- _#_3
  signal pathsturn_cost_memory_read_words_1 : unsigned_8_1d(0 to 1);  -- _#_1
  signal pathsturn_sum_memory_held_words : natural_65535_2d(0 to 1, 0 to 2);
  signal pathsturn_sum_memory_ready_words : natural_65535_1d(0 to 3);  -- _# up to 65535, 65535, 65535, 255
  signal pathsturn_sum_memory_write_words : natural_65535_2d(0 to 1, 0 to 2);
  signal pathsturn_cost_memory_held_words_0 : natural_65535_1d(0 to 1);  -- _#_0
  signal pathsturn_cost_memory_ready_words : natural_65535_1d(0 to 1);  -- _# up to 65535, 255
  signal pathsturn_cost_memory_write_words_0 : natural_65535_1d(0 to 1);  -- _#_0
  signal pathsturn_sum_memory_held_words_3, pathsturn_sum_memory_write_words_3 : natural_255_1d(0 to 1);  -- _#_3
  signal pathsturn_cost_memory_held_words_1, pathsturn_cost_memory_write_words_1 : natural_255_1d(0 to 1);  -- _#_1
  signal pathsturn_read_smallest_0 : unsigned(4 downto 0);
  signal pathsturn_ready_smallest_0 : natural range 0 to 31;
  signal pathsturn_read_address_address, pathsturn_sum_read_address,
    pathsturn_write_address_address : natural range 0 to 8191;
  signal pathsturn_sum_write_address : natural_8191_1d(0 to 1);
  signal pathsturn_read_address_count_phase, pathsturn_write_address_count_phase : natural range 0 to 7;
  signal pathsturn_write_smallest_0 : natural range 0 to 21;
  -- pathsright
  signal pathsright_fresh_past_newest : natural_64_1d(0 to 1);
  signal pathsright_fresh_past_pairs : natural_64_1d(0 to 2);
  signal pathsright_fresh_past_fours : natural_64_1d(0 to 6);
  signal pathsright_fresh_past_eight, pathsright_fresh_past_oldest, pathsright_fresh_past_cheapest,
    pathsright_fresh_here : natural range 0 to 64;
  signal pathsright_fresh_known, pathsright_q_less, pathsright_g_less,
    pathsright_lower_neighbour : natural range 0 to 127;
  signal pathsright_stay, pathsright_step, pathsright_stay_change, pathsright_step_change, pathsright_cost,
    pathsright_arrived : natural_127_1d(0 to 7);
  signal pathsright_tree_smallest : natural_127_1d(0 to 3);
  signal pathsright_tree_next_smallest : natural_127_1d(0 to 1);
  signal pathsright_tree_next_next_smallest_0, pathsright_low_0 : natural range 0 to 127;
  signal pathsright_lowest_0, pathsright_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsright_lost, pathsright_short_of : boolean;
  signal pathsright_missing, pathsright_below, pathsright_q, pathsright_room_left, pathsright_q_now,
    pathsright_room : natural range 0 to 63;
  signal pathsright_start_cost : natural_63_1d(1 to 8);
  signal pathsright_g : natural range 0 to 94;
  signal pathsright_read_words : unsigned_28_1d(0 to 3);
  -- winnersmask
  signal winnersmask_column : natural range 0 to 1023;
  signal winnersmask_partner : natural range 0 to 4095;
  signal winnersmask_inside : boolean_1d(0 to 7);
  -- winnerswinner1
  signal winnerswinner1_held_0 : natural_254_1d(0 to 7);
  signal winnerswinner1_best_cost_0, winnerswinner1_best_below_0, winnerswinner1_best_above_0,
    winnerswinner1_best_late_cost_0 : natural_254_1d(0 to 3);
  signal winnerswinner1_best_index_0_0, winnerswinner1_best_place_0_2 : boolean;
  signal winnerswinner1_best_index_0 : natural_7_1d(1 to 3);  -- _# up to 3, 5, 7
  signal winnerswinner1_best_but_first_0, winnerswinner1_best_but_last_0 : natural_255_1d(0 to 3);
  -- winnerswinner2
  signal winnerswinner2_best_cost_0, winnerswinner2_best_below_0, winnerswinner2_best_above_0,
    winnerswinner2_best_first_0, winnerswinner2_best_last_0, winnerswinner2_best_late_cost_0 : natural_254_1d(0 to 1);
  signal winnerswinner2_best_index_0 : natural_7_1d(0 to 1);  -- _# up to 3, 7
  signal winnerswinner2_best_place_0, winnerswinner2_best_at_start_0, winnerswinner2_best_at_end_0 : boolean_1d(0 to 1);
  signal winnerswinner2_best_second_0, winnerswinner2_best_but_first_0,
    winnerswinner2_best_but_last_0 : natural_255_1d(0 to 1);
  -- winnerswinner3
  signal winnerswinner3_best_cost_0_0, winnerswinner3_best_below_0_0, winnerswinner3_best_above_0_0,
    winnerswinner3_best_first_0_0, winnerswinner3_best_last_0_0,
    winnerswinner3_best_late_cost_0_0 : natural range 0 to 254;
  signal winnerswinner3_best_index_0_0 : natural range 0 to 7;
  signal winnerswinner3_best_place_0_0, winnerswinner3_best_at_start_0_0, winnerswinner3_best_at_end_0_0 : boolean;
  signal winnerswinner3_best_second_0_0, winnerswinner3_best_but_first_0_0,
    winnerswinner3_best_but_last_0_0 : natural range 0 to 255;
  -- winners
  signal winners_best_cost_0_0, winners_best_index_0_0, winners_best_late_cost_0_0, winners_best_second_0_0,
    winners_best_but_last_0_0 : natural range 0 to 255;
  signal winners_best_below_0_0, winners_best_above_0_0, winners_best_last_0_0 : natural range 0 to 254;
  signal winners_best_place_0_0, winners_best_at_start_0_0, winners_best_at_end_0_0 : boolean;
  signal winners_best_tag : tag_5;
  signal winners_partner_column : natural range 0 to 1023;
  signal winners_partner_at : natural range 0 to 1279;
  -- other
  signal other_read_count_phase, other_count_phase, other_write_count_phase : natural range 0 to 7;
  signal other_next_words, other_words : unsigned_32_1d(0 to 3);
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
  signal refinement_disparity_0 : natural_255_1d(0 to 11);  -- _#_0
  signal refinement_gap_0, refinement_u_0, refinement_v_0 : natural range 0 to 255;
  signal refinement_remainder_0 : natural_255_1d(0 to 7);  -- _#_0 up to 254, 255 x 7
  signal refinement_divisor_0 : natural_255_1d(0 to 7);  -- _#_0
  signal refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- _#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- _#_map_column
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- _#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- _#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- _#_end_of_line
  signal refinement_alone_0_0, refinement_scaled_gap, refinement_scaled_cost : boolean;
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_margin_0 : natural_63_1d(0 to 9);  -- _#_0
  signal refinement_below_0, refinement_above_0 : natural range 0 to 254;
  signal refinement_difference_0 : integer range -254 to 254;
  -- leftright
  signal leftright_other_0 : natural_255_1d(0 to 14);  -- _#_0
  signal leftright_asking_disparity_0, leftright_answered_disparity_0,
    leftright_checked_disparity_0 : natural range 0 to 255;
  signal leftright_ring_read_address, leftright_ring_write_address, leftright_asking_margin_0,
    leftright_answered_margin_0, leftright_checked_margin_0 : natural range 0 to 63;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0 : boolean;
  signal leftright_asking_tag : tag_5;
  signal leftright_answered_passed_0 : boolean;
  signal leftright_answered_tag : tag_5;
  signal leftright_checked_passed_0 : boolean;
  signal leftright_checked_tag : tag_5;
  signal leftright_position, leftright_held_position, leftright_address_0 : natural range 0 to 127;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_held_1 : unsigned(5 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0,
    leftright_checked_fraction_0 : natural range 0 to 31;
  signal leftright_found_0 : unsigned(7 downto 0);
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 1023;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame,
    turn_order_turned_end_of_line, turn_comes : boolean;
  signal turn_read_tag : tag_4;
  signal turn_ready_tag : tag_5_b;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 1048575;
  signal turn_read_words_0 : unsigned(19 downto 0);
  -- support
  signal support_counter_column, support_newest_rest_0, support_rest_rows_read_newest_0,
    support_rest_rows_ready_newest_0, support_read_column, support_ready_column, support_write_column,
    support_column_rest_0 : natural range 0 to 1023;
  signal support_rest_0 : natural_1023_1d(0 to 6);  -- _#_0
  signal support_centre_rest_0 : natural_1023_1d(0 to 2);  -- _#_0
  signal support_out_disparity_0 : natural range 0 to 1023;
  signal support_counter_group : natural range 0 to 511;
  signal support_newest_0, support_rows_read_newest_0, support_rows_ready_newest_0 : natural range 0 to 127;
  signal support_column : natural_127_1d(0 to 4);
  signal support_cells : natural_127_2d(0 to 12, 0 to 4);
  signal support_centre_0 : natural_127_1d(0 to 2);  -- _#_0
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
  signal fill_counter_column, fill_newest_disparity_0, fill_read_column, fill_ready_column, fill_write_column,
    fill_pixel_0_disparity, fill_at_column : natural range 0 to 1023;
  signal fill_asking_0_disparity : natural_1023_1d(0 to 1);  -- _#_0_disparity
  signal fill_asking_at_column : natural_1023_1d(0 to 1);  -- _#_column
  signal fill_known_0_disparity, fill_known_at_column, fill_beside_0_left, fill_beside_0_right,
    fill_beside_0_left_column, fill_beside_0_right_column, fill_measured_0_disparity, fill_measured_at_column,
    fill_measured_beside_0_left, fill_measured_beside_0_right, fill_measured_beside_0_right_column, fill_width_0,
    fill_chosen_0_disparity, fill_chosen_at_column, fill_chosen_beside_0_left, fill_chosen_beside_0_right,
    fill_write_above_column : natural range 0 to 1023;
  signal fill_counter_group, fill_ends_next_place_0, fill_ends_row_place_0, fill_ends_row_above_place_0,
    fill_ends_write_place_0, fill_ends_read_place_0 : natural range 0 to 511;
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
  signal fill_newest_sure_0, fill_pixel_0_sure : natural range 0 to 255;
  signal fill_asking_0_sure : natural_255_1d(0 to 1);  -- _#_0_sure
  signal fill_known_0_sure, fill_measured_0_sure, fill_chosen_0_sure, fill_out_sure_0 : natural range 0 to 255;
  signal fill_rows_read_words_0 : unsigned(18 downto 0);
  signal fill_rows_read_newest_0, fill_rows_ready_words_0, fill_rows_ready_newest_0,
    fill_rows_write_words_0 : natural range 0 to 524287;
  signal fill_ends_write_words_0, fill_ends_ready_words_0 : natural range 0 to 2097151;
  signal fill_ends_read_words_0 : unsigned(20 downto 0);
  signal fill_step_0 : natural range 0 to 127;
  signal fill_above_read_0 : unsigned(15 downto 0);
  signal fill_above_0, fill_write_above_0 : natural range 0 to 65535;
  signal fill_out_disparity_0 : natural range 0 to 32767;
  -- median
  signal median_counter_column, median_read_column, median_ready_column, median_write_column, median_at_column,
    median_comparing_column, median_sorted_column : natural range 0 to 1023;
  signal median_counter_group, median_beside_newest_0, median_beside_rows_read_newest_0,
    median_beside_rows_ready_words_0, median_beside_rows_ready_newest_0, median_beside_rows_write_words_0,
    median_beside_column_0 : natural range 0 to 511;
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
  signal relief_centre_grey : natural_255_1d(0 to 1);
  signal relief_before : natural range 0 to 255;
  signal relief_newest, relief_delayed_0, relief_rows_read_newest_0, relief_rows_ready_words_0,
    relief_rows_ready_newest_0, relief_rows_write_words_0, relief_shown_0, relief_column_0, relief_entering,
    relief_entered, relief_between, relief_write_turned_0 : natural range 0 to 31;
  signal relief_rows_read_words_0, relief_turned_0 : unsigned(4 downto 0);
  signal relief_left, relief_right : natural_64_1d(0 to 2);
  signal relief_write_address : natural range 0 to 1023;

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

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  transform_left_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 10);
    write_address <= to_unsigned(transform_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address,
        transform_left_rows_write_words_0);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 10);
    write_address <= to_unsigned(transform_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address,
        transform_right_rows_write_words_0);
  end block;

  median_beside_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(median_counter_column, 10);
    write_address <= to_unsigned(median_at_column, 10);
    write_data <= to_unsigned(median_beside_rows_write_words_0, 9);
    cell : entity work.line_memory generic map (638, 9, 10)
      port map (clock, true, read_address, median_beside_rows_read_words_0, write_address, write_data);
  end block;

  median_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(median_counter_column, 10);
    write_address <= to_unsigned(median_at_column, 10);
    write_data <= to_unsigned((median_rows_write_words_0 mod 67108864), 26);
    cell : entity work.line_memory generic map (638, 26, 10)
      port map (clock, true, read_address, median_rows_read_words_0, write_address, write_data);
  end block;

  fill_above_read_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(fill_known_at_column, 10);
    write_address <= to_unsigned(fill_write_above_column, 10);
    write_data <= to_unsigned(fill_write_above_0, 16);
    cell : entity work.line_memory generic map (638, 16, 10)
      port map (clock, true, read_address, fill_above_read_0, write_address, write_data);
  end block;

  fill_ends_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(20 downto 0);
  begin
    read_address <= to_unsigned(fill_ends_read_place_0, 9);
    write_address <= to_unsigned(fill_ends_write_place_0, 9);
    write_data <= to_unsigned(fill_ends_write_words_0, 21);
    cell : entity work.line_memory generic map (323, 21, 9)
      port map (clock, true, read_address, fill_ends_read_words_0, write_address, write_data);
  end block;

  fill_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(18 downto 0);
  begin
    read_address <= to_unsigned(fill_counter_column, 10);
    write_address <= to_unsigned(fill_at_column, 10);
    write_data <= to_unsigned(fill_rows_write_words_0, 19);
    cell : entity work.line_memory generic map (638, 19, 10)
      port map (clock, true, read_address, fill_rows_read_words_0, write_address, write_data);
  end block;

  support_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(support_counter_column, 10);
    write_address <= to_unsigned(support_write_column, 10);
    write_data <= to_unsigned(support_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (638, 28, 10)
      port map (clock, true, read_address, support_rows_read_words_0, write_address, write_data);
  end block;

  support_rest_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(support_counter_column, 10);
    write_address <= to_unsigned(support_write_column, 10);
    write_data <= to_unsigned(support_rest_rows_write_words_0, 20);
    cell : entity work.line_memory generic map (638, 20, 10)
      port map (clock, true, read_address, support_rest_rows_read_words_0, write_address, write_data);
  end block;

  turn_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(turn_order_address, 10);
    write_address <= to_unsigned(turn_write_place, 10);
    write_data <= to_unsigned(turn_write_words_0, 20);
    cell : entity work.line_memory generic map (639, 20, 10)
      port map (clock, true, read_address, turn_read_words_0, write_address, write_data);
  end block;

  leftright_found_0_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(leftright_address_0, 7);
    write_address <= to_unsigned(leftright_position, 7);
    write_data <= to_unsigned(leftright_other_0(14), 8);
    cell : entity work.line_memory generic map (128, 8, 7)
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
    write_data <= to_unsigned(other_4, 5) & to_unsigned(as_number(refinement_passed_0(11)), 1) &
      to_unsigned(refinement_disparity_0(11), 8) & to_unsigned(as_number(refinement_tag_end_of_line(11)), 1) &
      to_unsigned(as_number(refinement_tag_start_of_frame(11)), 1) &
      to_unsigned(as_number(refinement_tag_output_column(11)), 1) &
      to_unsigned(as_number(refinement_tag_map_column(11)), 1);
    cell : entity work.line_memory generic map (64, 18, 6)
      port map (clock, true, read_address, leftright_held_0, write_address, write_data);
  end block;

  other_next_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
  begin
    read_address <= to_unsigned(other_read_count_phase, 3);
    write_address <= to_unsigned(other_write_count_phase, 3);
    cell : entity work.line_memory generic map (8, 32, 3)
      port map (clock, true, read_address, other_next_words(i), write_address, other(15 - i));
  end generate;

  pathsright_read_words_memory : for i in 3 downto 2 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsright_arrived(4 * i - 5), 7) & to_unsigned(pathsright_arrived(4 * i - 6), 7) &
      to_unsigned(pathsright_arrived(4 * i - 7), 7) & to_unsigned(pathsright_arrived(4 * i - 8), 7);
    cell : entity work.line_memory generic map (8, 28, 3)
      port map (clock, true, read_address, pathsright_read_words(i), write_address, write_data);
  end generate;

  pathsright_read_words_1_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsright_cost(4 * i + 3), 7) & to_unsigned(pathsright_cost(4 * i + 2), 7) &
      to_unsigned(pathsright_cost(4 * i + 1), 7) & to_unsigned(pathsright_cost(4 * i), 7);
    cell : entity work.line_memory generic map (8, 28, 3)
      port map (clock, true, read_address, pathsright_read_words(i), write_address, write_data);
  end generate;

  pathsright_read_neighbour_0_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(6 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_ahead_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsright_cost(0), 7);
    cell : entity work.line_memory generic map (8, 7, 3)
      port map (clock, true, read_address, pathsright_read_neighbour_0, write_address, write_data);
  end block;

  pathsright_lowest_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(6 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_low_address, 4);
    write_address <= to_unsigned(pathsleft_low_write_address, 4);
    write_data <= to_unsigned(pathsright_low_0, 7);
    cell : entity work.line_memory generic map (16, 7, 4)
      port map (clock, true, read_address, pathsright_lowest_0, write_address, write_data);
  end block;

  pathsturn_read_smallest_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(4 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_smallest_address, 10);
    write_address <= to_unsigned(pathsturn_write_smallest_address, 10);
    write_data <= to_unsigned(pathsturn_write_smallest_0, 5);
    cell : entity work.line_memory generic map (639, 5, 10)
      port map (clock, true, read_address, pathsturn_read_smallest_0, write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_3_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_3(0), 8);
    cell : entity work.line_memory generic map (4096, 8, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words_3(0), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words(0, i), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(0, i), write_address, write_data);
  end generate;

  pathsturn_sum_memory_read_words_3_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 10);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 10);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_3(1), 8);
    cell : entity work.line_memory generic map (1024, 8, 10)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words_3(1), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_2_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 10);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 10);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words(1, i), 16);
    cell : entity work.line_memory generic map (1024, 16, 10)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(1, i), write_address, write_data);
  end generate;

  pathsturn_cost_memory_read_words_1_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_cost_memory_write_words_1(0), 8);
    cell : entity work.line_memory generic map (4096, 8, 12)
      port map (clock, true, read_address, pathsturn_cost_memory_read_words_1(0), write_address, write_data);
  end block;

  pathsturn_cost_memory_read_words_0_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_cost_memory_write_words_0(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_cost_memory_read_words_0(0), write_address, write_data);
  end block;

  pathsturn_cost_memory_read_words_1_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_cost_memory_read_address_1, 10);
    write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 10);
    write_data <= to_unsigned(pathsturn_cost_memory_write_words_1(1), 8);
    cell : entity work.line_memory generic map (1024, 8, 10)
      port map (clock, true, read_address, pathsturn_cost_memory_read_words_1(1), write_address, write_data);
  end block;

  pathsturn_cost_memory_read_words_0_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_cost_memory_read_address_1, 10);
    write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 10);
    write_data <= to_unsigned(pathsturn_cost_memory_write_words_0(1), 16);
    cell : entity work.line_memory generic map (1024, 16, 10)
      port map (clock, true, read_address, pathsturn_cost_memory_read_words_0(1), write_address, write_data);
  end block;

  pathsabove_delay_held_1_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
    write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
    write_data <= ((to_unsigned((pathsabove_total(7) mod 32), 5) & to_unsigned(0, 5)) or
      (to_unsigned(pathsabove_total(6), 10)));
    cell : entity work.line_memory generic map (12, 10, 4)
      port map (clock, true, read_address, pathsabove_delay_held_1, write_address, write_data);
  end block;

  pathsabove_delay_held_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
    write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
    write_data <= ((to_unsigned((pathsabove_total(5) mod 32), 5) &
      to_unsigned(to_integer(((to_unsigned(pathsabove_total(2), 11) & to_unsigned(0, 10)) or
      (to_unsigned(pathsabove_total(3), 6) & to_unsigned(to_integer(((to_unsigned(pathsabove_total(1), 6) &
      to_unsigned(0, 5)) or (to_unsigned(pathsabove_total(0), 11)))), 15)))), 25)) or (to_unsigned(pathsabove_total(4),
      10) & to_unsigned(0, 20)));
    cell : entity work.line_memory generic map (12, 30, 4)
      port map (clock, true, read_address, pathsabove_delay_held_0, write_address, write_data);
  end block;

  pathsabove_memory_read_words_2_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsabove_memory_write_words_2(0), 8);
    cell : entity work.line_memory generic map (4096, 8, 12)
      port map (clock, true, read_address, pathsabove_memory_read_words_2(0), write_address, write_data);
  end block;

  pathsabove_memory_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsabove_memory_write_words(0, i), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsabove_memory_read_words(0, i), write_address, write_data);
  end generate;

  pathsabove_memory_read_words_2_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_1, 10);
    write_address <= to_unsigned(pathsabove_memory_write_address_1, 10);
    write_data <= to_unsigned(pathsabove_memory_write_words_2(1), 8);
    cell : entity work.line_memory generic map (1024, 8, 10)
      port map (clock, true, read_address, pathsabove_memory_read_words_2(1), write_address, write_data);
  end block;

  pathsabove_memory_read_words_1_1_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_1, 10);
    write_address <= to_unsigned(pathsabove_memory_write_address_1, 10);
    write_data <= to_unsigned(pathsabove_memory_write_words(1, i), 16);
    cell : entity work.line_memory generic map (1024, 16, 10)
      port map (clock, true, read_address, pathsabove_memory_read_words(1, i), write_address, write_data);
  end generate;

  pathsleft_read_words_memory : for i in 3 downto 2 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsleft_arrived(4 * i - 5), 7) & to_unsigned(pathsleft_arrived(4 * i - 6), 7) &
      to_unsigned(pathsleft_arrived(4 * i - 7), 7) & to_unsigned(pathsleft_arrived(4 * i - 8), 7);
    cell : entity work.line_memory generic map (8, 28, 3)
      port map (clock, true, read_address, pathsleft_read_words(i), write_address, write_data);
  end generate;

  pathsleft_read_words_1_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsleft_cost(4 * i + 3), 7) & to_unsigned(pathsleft_cost(4 * i + 2), 7) &
      to_unsigned(pathsleft_cost(4 * i + 1), 7) & to_unsigned(pathsleft_cost(4 * i), 7);
    cell : entity work.line_memory generic map (8, 28, 3)
      port map (clock, true, read_address, pathsleft_read_words(i), write_address, write_data);
  end generate;

  pathsleft_read_neighbour_0_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(6 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_ahead_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsleft_cost(0), 7);
    cell : entity work.line_memory generic map (8, 7, 3)
      port map (clock, true, read_address, pathsleft_read_neighbour_0, write_address, write_data);
  end block;

  pathsleft_lowest_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(6 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_low_address, 4);
    write_address <= to_unsigned(pathsleft_low_write_address, 4);
    write_data <= to_unsigned(pathsleft_low_0, 7);
    cell : entity work.line_memory generic map (16, 7, 4)
      port map (clock, true, read_address, pathsleft_lowest_0, write_address, write_data);
  end block;

  paths_cost_delay_held_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
    write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
    write_data <= ((((((((((((((to_unsigned(costs_cost(6), 6) & to_unsigned(0, 18)) or (to_unsigned((costs_cost(7) mod
      8), 3) & to_unsigned(0, 21)))) or (to_unsigned(costs_cost(5), 9) & to_unsigned(0, 15)))) or
      (to_unsigned(costs_cost(4), 12) & to_unsigned(0, 12)))) or (to_unsigned(costs_cost(3), 15) & to_unsigned(0, 9))))
      or (to_unsigned(costs_cost(2), 18) & to_unsigned(0, 6)))) or (to_unsigned(costs_cost(0), 24)))) or
      (to_unsigned(costs_cost(1), 21) & to_unsigned(0, 3)));
    cell : entity work.line_memory generic map (12, 24, 4)
      port map (clock, true, read_address, paths_cost_delay_held_0, write_address, write_data);
  end block;

  relief_turned_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(4 downto 0);
  begin
    read_address <= to_unsigned(line_order_address, 10);
    write_address <= to_unsigned(relief_write_address, 10);
    write_data <= to_unsigned(relief_write_turned_0, 5);
    cell : entity work.line_memory generic map (639, 5, 10)
      port map (clock, true, read_address, relief_turned_0, write_address, write_data);
  end block;

  relief_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(4 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(relief_rows_write_words_0, 5);
    cell : entity work.line_memory generic map (640, 5, 10)
      port map (clock, true, read_address, relief_rows_read_words_0, write_address, write_data);
  end block;

  costswindow_read_wordss_memory : for i in 3 downto 2 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(costswindow_read_count_phase, 3);
    write_address <= to_unsigned(costswindow_write_count_phase, 3);
    write_data <= to_unsigned(costswindow_partials(4 * i + 3), 7) & to_unsigned(costswindow_partials(4 * i + 2), 7) &
      to_unsigned(costswindow_partials(4 * i + 1), 7) & to_unsigned(costswindow_partials(4 * i), 7);
    cell : entity work.line_memory generic map (8, 28, 3)
      port map (clock, true, read_address, costswindow_read_wordss(i), write_address, write_data);
  end generate;

  costswindow_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(costswindow_read_count_phase, 3);
    write_address <= to_unsigned(costswindow_write_count_phase, 3);
    write_data <= to_unsigned(costswindow_partial(4 * i + 3), 6) & to_unsigned(costswindow_partial(4 * i + 2), 7) &
      to_unsigned(costswindow_partial(4 * i + 1), 7) & to_unsigned(costswindow_partial(4 * i), 7);
    cell : entity work.line_memory generic map (8, 27, 3)
      port map (clock, true, read_address, costswindow_read_words(i), write_address, write_data);
  end generate;

  costsshift_read_words_memory : for i in 11 downto 8 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(costsshift_count_phase, 3);
    write_address <= to_unsigned(costsshift_write_phase, 3);
    write_data <= to_unsigned(costsshift_search(2, 2 * i - 15), 14) & to_unsigned(costsshift_search(2, 2 * i - 16), 14);
    cell : entity work.line_memory generic map (8, 28, 3)
      port map (clock, true, read_address, costsshift_read_words(i), write_address, write_data);
  end generate;

  costsshift_read_words_7_memory : for i in 7 downto 4 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(costsshift_count_phase, 3);
    write_address <= to_unsigned(costsshift_write_phase, 3);
    write_data <= to_unsigned(costsshift_search(1, 2 * i - 7), 14) & to_unsigned(costsshift_search(1, 2 * i - 8), 14);
    cell : entity work.line_memory generic map (8, 28, 3)
      port map (clock, true, read_address, costsshift_read_words(i), write_address, write_data);
  end generate;

  costsshift_read_words_3_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(costsshift_count_phase, 3);
    write_address <= to_unsigned(costsshift_write_phase, 3);
    write_data <= to_unsigned(costsshift_search(0, 2 * i + 1), 14) & to_unsigned(costsshift_search(0, 2 * i), 14);
    cell : entity work.line_memory generic map (8, 28, 3)
      port map (clock, true, read_address, costsshift_read_words(i), write_address, write_data);
  end generate;

  rows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (640, 28, 10)
      port map (clock, true, read_address, rows_search_rows_read_words_0, write_address, write_data);
  end block;

  rows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (640, 28, 10)
      port map (clock, true, read_address, rows_reference_rows_read_words_0, write_address, write_data);
  end block;

  process
    variable transform_counter_next_frame_is_equal, transform_counter_frame_joins_choice,
      transform_read_column_inside_0_is_less, transform_left_filter_low_is_larger_0_0_2_any,
      transform_left_filter_low_is_larger_0_0_2_is_equal, transform_right_filter_low_is_larger_0_0_2_any,
      transform_right_filter_low_is_larger_0_0_2_is_equal, raster_place_next_frame_is_equal,
      raster_place_back_to_back_choice, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less,
      delay_tag_map_column_is_not_less, delay_tag_map_column_is_less, delay_tag_first_column_is_equal,
      line_order_address_any, line_order_falls_all, line_order_turned_output_column_choice,
      costsshift_search_0_0_is_equal, costswindow_partial_0_any, pathsleft_read_count_phase_is_equal,
      pathsleft_stay_0_is_equal, pathsleft_cost_0_any, pathsabove_count_phase_is_equal,
      pathsabove_memory_write_words_0_0_choice_4, pathsright_stay_0_is_equal, winnerswinner3_best_below_0_0_is_equal,
      winnerswinner3_best_above_0_0_is_equal, winnerswinner3_best_at_start_0_0_choice, winners_best_index_0_0_is_less,
      winners_best_below_0_0_is_equal, winners_best_above_0_0_is_equal, other_0_is_equal, other_12_any,
      other_12_differs, refinement_below_0_differs, refinement_divisor_0_0_is_less, leftright_holds_winners_choice,
      turn_order_falls_all, turn_order_complete_all, turn_ready_tag_row_start_differs, support_newest_0_value,
      support_moment_0_start_of_frame_choice, support_out_tag_row_start_differs, fill_ends_read_place_0_choice,
      fill_out_filled_0_is_equal, fill_out_filled_0_choice, fill_out_tag_row_start_differs, fill_ends_row_place_0_all,
      fill_beside_0_left_any, median_counter_group_is_equal, median_line_ended_choice, median_window_complete_is_equal,
      median_window_complete_choice : boolean;
    variable transform_counter_group_after_choice, raster_place_group_after_choice, winners_best_cost_0_0_choice,
      fill_takes_left_0_choice : natural range 0 to 511;
    variable transform_left_filter_low_is_larger_0_value,
      transform_right_filter_low_is_larger_0_value : boolean_3d(0 to 4, 0 to 2, 1 to 4);  -- _2#_2#_value_#
    variable transform_left_filter_low_is_larger_0_choice_3,
      transform_right_filter_low_is_larger_0_choice_3 : boolean_2d(0 to 4, 0 to 2);  -- _2#_2#_choice_3
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 3);  -- _value_#
    variable transform_left_filter_feature_0_choice : boolean_1d(3 to 65);
    variable transform_left_filter_feature_0_alls : boolean_1d(1 to 4);  -- _all_#
    variable transform_right_filter_feature_0_choice : boolean_1d(3 to 70);
    variable transform_right_filter_feature_0_alls : boolean_1d(1 to 5);  -- _all_#
    variable transform_counter_group_choice, raster_place_group_choice, support_counter_group_choice,
      fill_counter_group_choice, median_counter_group_choice : natural range 0 to 15;
    variable line_order_address_choice, turn_order_address_choice : natural range 1 to 1023;
    variable line_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 637;
    variable costsshift_count_phase_choice, costswindow_read_count_phase_choice, costswindow_write_count_phase_choice,
      pathsleft_read_count_phase_choice, pathsleft_ahead_count_phase_choice, pathsleft_write_count_phase_choice,
      pathsabove_read_address_count_phase_choice, pathsabove_count_phase_choice,
      pathsabove_write_address_count_phase_choice, pathsturn_read_address_count_phase_choice,
      pathsturn_write_address_count_phase_choice, pathsright_stay_change_5_sum, other_read_count_phase_choice,
      other_count_phase_choice, other_write_count_phase_choice, other_4_choice_2 : natural range 0 to 7;
    variable costsmask_column_sum, winnersmask_column_sum, winners_partner_at_sum : natural range 1 to 1024;
    variable costsmask_column_choice, pathsabove_memory_read_address_1_choice, winnersmask_column_choice,
      fill_takes_left_0_choice_2, fill_out_disparity_0_choice : natural range 0 to 1023;
    variable costsmask_partner_choice, winnersmask_partner_choice, winners_partner_at_choice : natural range 0 to 1024;
    variable costs_cost_choice : natural_21_1d(0 to 7);  -- _#_choice
    variable paths_smallest_cost_choice : natural range 0 to 21;
    variable pathsleft_stay_value, pathsright_stay_value : boolean_2d(0 to 7, 1 to 10);  -- _#_value_#
    variable pathsleft_stay_choice, pathsright_stay_choice : boolean_2d(0 to 7, 7 to 15);  -- _#_choice_#
    variable pathsleft_stay_choice_16, pathsright_stay_choice_16 : natural_127_1d(0 to 7);  -- _#_choice_16
    variable pathsleft_stay_values, pathsright_stay_values : natural_127_2d(1 to 6, 3 to 4);  -- _#_value_#
    variable pathsleft_step_choice, pathsright_step_choice : natural_127_2d(0 to 7, 1 to 2);  -- _#_choice_#
    variable pathsleft_stay_change_value, pathsright_stay_change_value : natural_7_1d(1 to 6);  -- _#_value
    variable pathsleft_low_0_choice, pathsright_low_0_choice : natural range 0 to 127;
    variable pathsleft_q_choices, pathsright_q_choices : natural_63_1d(1 to 2);  -- _choice_#
    variable pathsleft_room_left_choice, pathsright_room_left_choice : natural range 0 to 63;
    variable pathsabove_memory_read_address_0_sum : natural range 1 to 8192;
    variable pathsabove_memory_read_address_0_choice, median_of_column_0_a_choice : natural range 0 to 4095;
    variable pathsabove_memory_read_address_0_sum_2, pathsturn_cost_memory_read_address_0_sum : natural range 0 to 8192;
    variable pathsabove_memory_bank_choices : natural_8191_1d(1 to 2);  -- _choice_#
    variable pathsabove_ready_top_choices, support_next_tag_choices,
      fill_ends_next_place_0_choices : boolean_1d(1 to 2);  -- _choice_#
    variable pathsabove_total_choice, pathsabove_beside_choice : natural_31_1d(0 to 7);  -- _#_choice
    variable pathsabove_smallest_total_choice : natural range 0 to 52;
    variable pathsabove_write_address_address_choice, pathsturn_cost_memory_bank_choice : natural range 0 to 8191;
    variable pathsabove_memory_write_words_0_choice : natural_31_2d(0 to 2, 1 to 3);  -- _#_choice_#
    variable pathsabove_memory_write_words_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
    variable pathsabove_memory_write_words_0_sum : natural_65535_1d(0 to 1);  -- _#_sum
    variable pathsabove_memory_write_words_0_1_choice_4 : natural range 0 to 3;
    variable pathsabove_memory_write_words_0_2_sum, pathsturn_sum_memory_write_words_0_3_sum,
      pathsturn_cost_memory_write_words_0_1_sum, winners_best_cost_0_0_choice_2, winners_best_index_0_0_choice,
      refinement_divisor_0_0_choice, support_out_sure_0_choice : natural range 0 to 255;
    variable pathsabove_memory_write_words_0_all, pathsturn_sum_memory_write_words_0_all,
      pathsturn_cost_memory_write_words_0_all, median_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
    variable pathsturn_sum_memory_write_words_0_sum : natural_158_1d(0 to 2);  -- _#_sum
    variable pathsturn_sum_memory_write_words_0_sum_2 : natural_65535_1d(0 to 2);  -- _#_sum_2
    variable pathsturn_cost_memory_write_words_0_0_sum, fill_write_above_0_choice : natural range 0 to 65535;
    variable winnerswinner1_best_index_0_value : boolean_2d(0 to 3, 1 to 7);  -- _#_value_#
    variable winnerswinner1_best_index_0_choice_8 : boolean_1d(0 to 3);  -- _#_choice_8
    variable winnerswinner2_best_index_0_value : boolean_2d(0 to 1, 1 to 5);  -- _#_value_#
    variable winnerswinner2_best_index_0_choice : boolean_2d(0 to 1, 7 to 8);  -- _#_choice_#
    variable winnerswinner2_best_below_0_is_equal : boolean_1d(0 to 1);  -- _#_is_equal
    variable winnerswinner2_best_below_0_choice, winnerswinner2_best_above_0_choice : natural_254_1d(0 to 1);  -- _#_choice
    variable winnerswinner2_best_at_start_0_choice : boolean_1d(0 to 1);  -- _#_choice
    variable winnerswinner2_best_second_0_choice : natural_255_2d(0 to 1, 1 to 4);  -- _#_choice_#
    variable winnerswinner3_best_index_0_0_values, relief_newest_values : boolean_1d(1 to 5);  -- _value_#
    variable winnerswinner3_best_index_0_0_choice : boolean_1d(7 to 8);
    variable winnerswinner3_best_below_0_0_choice, winnerswinner3_best_above_0_0_choice : natural range 0 to 254;
    variable winnerswinner3_best_second_0_0_choices : natural_255_1d(1 to 4);  -- _choice_#
    variable winners_best_below_0_0_choices, winners_best_above_0_0_choices : natural_254_1d(1 to 2);  -- _choice_#
    variable winners_best_second_0_0_choices : natural_255_1d(1 to 7);  -- _choice_#
    variable other_base_choice, relief_newest_choice_16 : natural range 0 to 31;
    variable other_4_difference : integer range -15 to 0;
    variable other_4_value : natural range 0 to 16;
    variable other_choice : natural_255_1d(4 to 15);  -- _#_choice
    variable other_difference : natural_257_to_1022_1d(5 to 10);  -- _#_difference
    variable other_11_difference : natural range 257 to 766;
    variable other_value : boolean_2d(12 to 13, 1 to 21);  -- _#_value_#
    variable other_choices_from_12 : boolean_2d(12 to 13, 7 to 42);  -- _#_choice_#
    variable other_all : boolean_2d(12 to 13, 1 to 4);  -- _#_all_#
    variable other_12_value_6 : natural range 0 to 248;
    variable other_choices : natural_255_2d(12 to 15, 2 to 44);  -- _#_choice_#
    variable leftright_checked_passed_0_difference : integer range -254 to 256;
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
    variable turn_ready_tag_row_start_is_equals, support_out_tag_row_start_is_equals,
      fill_out_tag_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable turn_ready_tag_row_start_choices, support_out_tag_row_start_choices,
      fill_out_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable turn_ready_tag_row_start_alls, support_out_tag_row_start_alls, fill_out_disparity_0_alls,
      fill_out_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable support_counter_group_choices, fill_counter_group_choices, fill_ends_read_place_0_choices,
      median_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable support_column_choice : natural_63_to_127_1d(0 to 4);  -- _#_choice
    variable support_like_0_0_0_difference : integer range -62 to 1;
    variable support_like_0_value : natural_127_2d(0 to 6, 0 to 4);  -- _#_#_value
    variable support_like_0_0_choice : boolean_1d(0 to 6);  -- _#_0_choice
    variable support_like_0_1_differs : boolean_1d(0 to 6);  -- _#_1_differs
    variable fill_out_disparity_0_choice_2, median_of_column_0_c_choice, median_low_0_0_choice,
      median_middle_0_0_choice, median_high_0_0_choice : natural range 0 to 32767;
    variable median_sorted_low_0_choices, median_sorted_middle_0_choices, median_sorted_high_0_choices,
      median_largest_low_0_choices, median_smallest_high_0_choices : natural_32767_1d(1 to 2);  -- _choice_#
    variable median_median_middle_0_choices, median_out_disparity_0_choices : natural_32767_1d(1 to 4);  -- _choice_#
    variable relief_newest_choice : boolean_1d(7 to 15);
    variable relief_newest_values_from_6 : natural_255_1d(6 to 7);  -- _value_#
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    other_all := (others => (others => false)); other_choice := (others => 0);
    other_choices := (others => (others => 0)); other_choices_from_12 := (others => (others => false));
    other_value := (others => (others => false)); pathsabove_beside_choice := (others => 0);
    pathsabove_memory_write_words_0_choice := (others => (others => 0));
    pathsleft_stay_choice := (others => (others => false)); pathsleft_stay_value := (others => (others => false));
    pathsleft_stay_values := (others => (others => 0)); pathsleft_step_choice := (others => (others => 0));
    pathsright_stay_change_value := (others => 0); pathsright_stay_choice := (others => (others => false));
    pathsright_stay_value := (others => (others => false)); pathsright_stay_values := (others => (others => 0));
    pathsright_step_choice := (others => (others => 0)); support_like_0_0_choice := (others => false);
    support_like_0_1_differs := (others => false); transform_left_filter_feature_0_choice := (others => false);
    transform_left_filter_low_is_larger_0_choice_3 := (others => (others => false));
    transform_left_filter_low_is_larger_0_value := (others => (others => (others => false)));
    transform_right_filter_feature_0_choice := (others => false);
    transform_right_filter_low_is_larger_0_choice_3 := (others => (others => false));
    transform_right_filter_low_is_larger_0_value := (others => (others => (others => false)));
    -- transform
    transform_counter_next_frame_is_equal := transform_counter_column = 639;
    transform_counter_frame_joins_choice := choice(transform_counter_last_column, (not transform_counter_back_to_back)
      and refinement_scaled_gap, refinement_scaled_gap);
    transform_counter_group_after_choice := choice(transform_counter_back_to_back, 2, (transform_counter_group + 1) mod
      512);
    transform_read_column_inside_0_is_less := 3 < transform_counter_column;
    transform_left_filter_low_is_larger_0_value(0, 0, 1) := is_set(transform_left_filter_column(4, 1), 1);
    transform_left_filter_low_is_larger_0_value(0, 0, 2) := is_set(transform_left_filter_column(4, 1), 2);
    transform_left_filter_low_is_larger_0_value(0, 0, 3) := is_set(transform_left_filter_column(0, 0), 2);
    transform_left_filter_low_is_larger_0_choice_3(0, 0) := not is_larger(transform_left_filter_column(4, 1),
      transform_left_filter_column(0, 0), 0, 2, true);
    transform_left_filter_low_is_larger_0_value(0, 0, 4) := is_set(transform_left_filter_column(0, 0), 3);
    transform_left_filter_low_is_larger_0_0_2_any := (not transform_left_filter_low_is_larger_0_value(0, 0, 1)) or (not
      is_set(transform_left_filter_column(4, 1), 0));
    transform_left_filter_low_is_larger_0_0_2_is_equal := (transform_left_filter_column(4, 1) mod 4) = 0;
    for i in 0 to 1 loop
      transform_left_filter_low_is_larger_0_choice_3(2 * i, 1 - i) := not is_larger(transform_left_filter_column(4 * i,
        1 - i), transform_left_filter_column(4, 1), 0, 2, false);
      transform_left_filter_low_is_larger_0_value(2 * i, 1 - i, 1) := is_set(transform_left_filter_column(4 * i, 1 -
        i), 3);
      transform_left_filter_low_is_larger_0_choice_3(2 * i, 2) := not is_larger(transform_left_filter_column(4 * i, 2),
        transform_left_filter_column(4, 1), 0, 2, false);
      transform_left_filter_low_is_larger_0_value(2 * i, 2, 1) := is_set(transform_left_filter_column(4 * i, 2), 3);
      for j in 0 to 2 loop
        transform_left_filter_low_is_larger_0_choice_3(2 * i + 1, j) := not is_larger(transform_left_filter_column(4 *
          i + 2, j), transform_left_filter_column(4, 1), 0, 2, false);
        transform_left_filter_low_is_larger_0_value(2 * i + 1, j, 1) := is_set(transform_left_filter_column(4 * i + 2,
          j), 3);
      end loop;
    end loop;
    for i in 0 to 2 loop
      transform_left_filter_low_is_larger_0_choice_3(4, i) := not is_larger(transform_left_filter_column(8, i),
        transform_left_filter_column(4, 1), 0, 2, false);
      transform_left_filter_low_is_larger_0_value(4, i, 1) := is_set(transform_left_filter_column(8, i), 3);
    end loop;
    transform_left_filter_feature_0_values(1) := is_set(transform_left_filter_column(4, 1), 4);
    transform_left_filter_feature_0_values(2) := is_set(transform_left_filter_column(4, 1), 5);
    transform_left_filter_feature_0_values(3) := is_set(transform_left_filter_column(4, 1), 6);
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(14 * i + 3) := not is_larger(transform_left_filter_column(2 * i, i),
        transform_left_filter_column(4, 1), 4, 6, transform_left_filter_low_is_larger_0(i, i));
      transform_left_filter_feature_0_alls(i + 1) := transform_filtering_0_column_inside(i) and (not
        is_set(transform_left_filter_column(4, 1), 7));
      transform_left_filter_feature_0_choice(14 * i + 4) := choice(is_set(transform_left_filter_column(2 * i, i), 7),
        transform_filtering_0_column_inside(i), transform_left_filter_feature_0_alls(i + 1));
      transform_left_filter_feature_0_choice(14 * i + 5) := choice(transform_left_filter_feature_0_choice(14 * i + 3),
        is_set(transform_left_filter_column(2 * i, i), 7) and transform_filtering_0_column_inside(i) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(14 * i + 4));
      transform_left_filter_feature_0_choice(14 * i + 8) := not is_larger(transform_left_filter_column(2 * i, 1 - i),
        transform_left_filter_column(4, 1), 4, 6, transform_left_filter_low_is_larger_0(i, 1 - i));
      transform_left_filter_feature_0_choice(14 * i + 9) := choice(is_set(transform_left_filter_column(2 * i, 1 - i),
        7), transform_filtering_0_column_inside(i), transform_left_filter_feature_0_alls(i + 1));
      transform_left_filter_feature_0_choice(14 * i + 10) := choice(transform_left_filter_feature_0_choice(14 * i + 8),
        is_set(transform_left_filter_column(2 * i, 1 - i), 7) and transform_filtering_0_column_inside(i) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(14 * i + 9));
      transform_left_filter_feature_0_choice(14 * i + 13) := not is_larger(transform_left_filter_column(2 * i, 2),
        transform_left_filter_column(4, 1), 4, 6, transform_left_filter_low_is_larger_0(i, 2));
      transform_left_filter_feature_0_choice(14 * i + 14) := choice(transform_left_filter_feature_0_choice(14 * i +
        13), transform_filtering_0_column_inside(i) and is_set(transform_left_filter_column(2 * i, 2), 7) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(i) and
        (is_set(transform_left_filter_column(2 * i, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
    end loop;
    transform_left_filter_feature_0_choice(31) := not is_larger(transform_left_filter_column(4, 0),
      transform_left_filter_column(4, 1), 4, 6, transform_left_filter_low_is_larger_0_4_0);
    transform_left_filter_feature_0_choice(32) := choice(is_set(transform_left_filter_column(4, 0), 7),
      transform_filtering_0_column_inside(2), transform_filtering_0_column_inside(2) and (not
      is_set(transform_left_filter_column(4, 1), 7)));
    transform_left_filter_feature_0_choice(33) := choice(transform_left_filter_feature_0_choice(31),
      is_set(transform_left_filter_column(4, 0), 7) and transform_filtering_0_column_inside(2) and (not
      is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(32));
    transform_left_filter_feature_0_choice(36) := not is_larger(transform_left_filter_column(4, 2),
      transform_left_filter_column(4, 1), 4, 6, transform_left_filter_low_is_larger_0_4_4);
    for i in 2 to 3 loop
      transform_left_filter_feature_0_choice(14 * i + 9) := choice(transform_left_filter_feature_0_choice(14 * i + 8),
        transform_filtering_0_column_inside(i) and is_set(transform_left_filter_column(2 * i, 2), 7) and (not
        is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(i) and
        (is_set(transform_left_filter_column(2 * i, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
      transform_left_filter_feature_0_choice(14 * i + 12) := not is_larger(transform_left_filter_column(2 * i + 2, 1),
        transform_left_filter_column(4, 1), 4, 6, transform_left_filter_low_is_larger_0s(i + 1, 1));
      transform_left_filter_feature_0_alls(i + 1) := transform_filtering_0_column_inside(i + 1) and (not
        is_set(transform_left_filter_column(4, 1), 7));
      transform_left_filter_feature_0_choice(14 * i + 13) := choice(is_set(transform_left_filter_column(2 * i + 2, 1),
        7), transform_filtering_0_column_inside(i + 1), transform_left_filter_feature_0_alls(i + 1));
      transform_left_filter_feature_0_choice(14 * i + 14) := choice(transform_left_filter_feature_0_choice(14 * i +
        12), is_set(transform_left_filter_column(2 * i + 2, 1), 7) and transform_filtering_0_column_inside(i + 1) and
        (not is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(14 * i + 13));
      transform_left_filter_feature_0_choice(14 * i + 17) := not is_larger(transform_left_filter_column(2 * i + 2, 0),
        transform_left_filter_column(4, 1), 4, 6, transform_left_filter_low_is_larger_0s(i + 1, 0));
      transform_left_filter_feature_0_choice(14 * i + 18) := choice(is_set(transform_left_filter_column(2 * i + 2, 0),
        7), transform_filtering_0_column_inside(i + 1), transform_left_filter_feature_0_alls(i + 1));
      transform_left_filter_feature_0_choice(14 * i + 19) := choice(transform_left_filter_feature_0_choice(14 * i +
        17), is_set(transform_left_filter_column(2 * i + 2, 0), 7) and transform_filtering_0_column_inside(i + 1) and
        (not is_set(transform_left_filter_column(4, 1), 7)), transform_left_filter_feature_0_choice(14 * i + 18));
      transform_left_filter_feature_0_choice(14 * i + 22) := not is_larger(transform_left_filter_column(2 * i + 2, 2),
        transform_left_filter_column(4, 1), 4, 6, transform_left_filter_low_is_larger_0s(i + 1, 2));
    end loop;
    transform_left_filter_feature_0_choice(65) := choice(transform_left_filter_feature_0_choice(64),
      transform_filtering_0_column_inside(4) and is_set(transform_left_filter_column(8, 2), 7) and (not
      is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(4) and
      (is_set(transform_left_filter_column(8, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
    transform_right_filter_low_is_larger_0_value(0, 0, 1) := is_set(transform_right_filter_column(4, 1), 1);
    transform_right_filter_low_is_larger_0_value(0, 0, 2) := is_set(transform_right_filter_column(4, 1), 2);
    transform_right_filter_low_is_larger_0_value(0, 0, 3) := is_set(transform_right_filter_column(0, 0), 2);
    transform_right_filter_low_is_larger_0_choice_3(0, 0) := not is_larger(transform_right_filter_column(4, 1),
      transform_right_filter_column(0, 0), 0, 2, true);
    transform_right_filter_low_is_larger_0_value(0, 0, 4) := is_set(transform_right_filter_column(0, 0), 3);
    transform_right_filter_low_is_larger_0_0_2_any := (not transform_right_filter_low_is_larger_0_value(0, 0, 1)) or
      (not is_set(transform_right_filter_column(4, 1), 0));
    transform_right_filter_low_is_larger_0_0_2_is_equal := (transform_right_filter_column(4, 1) mod 4) = 0;
    for i in 0 to 1 loop
      transform_right_filter_low_is_larger_0_choice_3(2 * i, 1 - i) := not is_larger(transform_right_filter_column(4 *
        i, 1 - i), transform_right_filter_column(4, 1), 0, 2, false);
      transform_right_filter_low_is_larger_0_value(2 * i, 1 - i, 1) := is_set(transform_right_filter_column(4 * i, 1 -
        i), 3);
      transform_right_filter_low_is_larger_0_choice_3(2 * i, 2) := not is_larger(transform_right_filter_column(4 * i,
        2), transform_right_filter_column(4, 1), 0, 2, false);
      transform_right_filter_low_is_larger_0_value(2 * i, 2, 1) := is_set(transform_right_filter_column(4 * i, 2), 3);
      for j in 0 to 2 loop
        transform_right_filter_low_is_larger_0_choice_3(2 * i + 1, j) := not is_larger(transform_right_filter_column(4
          * i + 2, j), transform_right_filter_column(4, 1), 0, 2, false);
        transform_right_filter_low_is_larger_0_value(2 * i + 1, j, 1) := is_set(transform_right_filter_column(4 * i +
          2, j), 3);
      end loop;
    end loop;
    for i in 0 to 2 loop
      transform_right_filter_low_is_larger_0_choice_3(4, i) := not is_larger(transform_right_filter_column(8, i),
        transform_right_filter_column(4, 1), 0, 2, false);
      transform_right_filter_low_is_larger_0_value(4, i, 1) := is_set(transform_right_filter_column(8, i), 3);
    end loop;
    transform_right_filter_feature_0_values(1) := is_set(transform_right_filter_column(4, 1), 4);
    transform_right_filter_feature_0_values(2) := is_set(transform_right_filter_column(4, 1), 5);
    transform_right_filter_feature_0_values(3) := is_set(transform_right_filter_column(4, 1), 6);
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(15 * i + 3) := not is_larger(transform_right_filter_column(2 * i, i),
        transform_right_filter_column(4, 1), 4, 6, transform_right_filter_low_is_larger_0(i, i));
      transform_right_filter_feature_0_alls(i + 1) := (not is_set(transform_right_filter_column(4, 1), 7)) and
        transform_filtering_0_column_inside(i);
      transform_right_filter_feature_0_choice(15 * i + 4) := choice(is_set(transform_right_filter_column(2 * i, i), 7),
        transform_filtering_0_column_inside(i), transform_right_filter_feature_0_alls(i + 1));
      transform_right_filter_feature_0_choice(15 * i + 5) := choice(transform_right_filter_feature_0_choice(15 * i +
        3), is_set(transform_right_filter_column(2 * i, i), 7) and (not is_set(transform_right_filter_column(4, 1), 7))
        and transform_filtering_0_column_inside(i), transform_right_filter_feature_0_choice(15 * i + 4));
      transform_right_filter_feature_0_choice(15 * i + 8) := not is_larger(transform_right_filter_column(2 * i, 1 - i),
        transform_right_filter_column(4, 1), 4, 6, transform_right_filter_low_is_larger_0(i, 1 - i));
      transform_right_filter_feature_0_choice(15 * i + 9) := choice(is_set(transform_right_filter_column(2 * i, 1 - i),
        7), transform_filtering_0_column_inside(i), transform_right_filter_feature_0_alls(i + 1));
      transform_right_filter_feature_0_choice(15 * i + 10) := choice(transform_right_filter_feature_0_choice(15 * i +
        8), is_set(transform_right_filter_column(2 * i, 1 - i), 7) and (not is_set(transform_right_filter_column(4, 1),
        7)) and transform_filtering_0_column_inside(i), transform_right_filter_feature_0_choice(15 * i + 9));
      transform_right_filter_feature_0_choice(15 * i + 13) := not is_larger(transform_right_filter_column(2 * i, 2),
        transform_right_filter_column(4, 1), 4, 6, transform_right_filter_low_is_larger_0(i, 2));
      transform_right_filter_feature_0_choice(15 * i + 14) := choice(is_set(transform_right_filter_column(2 * i, 2),
        7), transform_filtering_0_column_inside(i), transform_right_filter_feature_0_alls(i + 1));
      transform_right_filter_feature_0_choice(15 * i + 15) := choice(transform_right_filter_feature_0_choice(15 * i +
        13), is_set(transform_right_filter_column(2 * i, 2), 7) and (not is_set(transform_right_filter_column(4, 1),
        7)) and transform_filtering_0_column_inside(i), transform_right_filter_feature_0_choice(15 * i + 14));
    end loop;
    transform_right_filter_feature_0_choice(33) := not is_larger(transform_right_filter_column(4, 0),
      transform_right_filter_column(4, 1), 4, 6, transform_right_filter_low_is_larger_0_4_0);
    transform_right_filter_feature_0_alls(3) := (not is_set(transform_right_filter_column(4, 1), 7)) and
      transform_filtering_0_column_inside(2);
    transform_right_filter_feature_0_choice(34) := choice(is_set(transform_right_filter_column(4, 0), 7),
      transform_filtering_0_column_inside(2), transform_right_filter_feature_0_alls(3));
    transform_right_filter_feature_0_choice(35) := choice(transform_right_filter_feature_0_choice(33),
      is_set(transform_right_filter_column(4, 0), 7) and (not is_set(transform_right_filter_column(4, 1), 7)) and
      transform_filtering_0_column_inside(2), transform_right_filter_feature_0_choice(34));
    transform_right_filter_feature_0_choice(38) := not is_larger(transform_right_filter_column(4, 2),
      transform_right_filter_column(4, 1), 4, 6, transform_right_filter_low_is_larger_0_4_4);
    for i in 2 to 3 loop
      transform_right_filter_feature_0_choice(15 * i + 9) := choice(is_set(transform_right_filter_column(2 * i, 2), 7),
        transform_filtering_0_column_inside(i), transform_right_filter_feature_0_alls(i + 1));
      transform_right_filter_feature_0_choice(15 * i + 10) := choice(transform_right_filter_feature_0_choice(15 * i +
        8), is_set(transform_right_filter_column(2 * i, 2), 7) and (not is_set(transform_right_filter_column(4, 1), 7))
        and transform_filtering_0_column_inside(i), transform_right_filter_feature_0_choice(15 * i + 9));
      transform_right_filter_feature_0_choice(15 * i + 13) := not is_larger(transform_right_filter_column(2 * i + 2,
        1), transform_right_filter_column(4, 1), 4, 6, transform_right_filter_low_is_larger_0s(i + 1, 1));
      transform_right_filter_feature_0_alls(i + 2) := (not is_set(transform_right_filter_column(4, 1), 7)) and
        transform_filtering_0_column_inside(i + 1);
      transform_right_filter_feature_0_choice(15 * i + 14) := choice(is_set(transform_right_filter_column(2 * i + 2,
        1), 7), transform_filtering_0_column_inside(i + 1), transform_right_filter_feature_0_alls(i + 2));
      transform_right_filter_feature_0_choice(15 * i + 15) := choice(transform_right_filter_feature_0_choice(15 * i +
        13), is_set(transform_right_filter_column(2 * i + 2, 1), 7) and (not is_set(transform_right_filter_column(4,
        1), 7)) and transform_filtering_0_column_inside(i + 1), transform_right_filter_feature_0_choice(15 * i + 14));
      transform_right_filter_feature_0_choice(15 * i + 18) := not is_larger(transform_right_filter_column(2 * i + 2,
        0), transform_right_filter_column(4, 1), 4, 6, transform_right_filter_low_is_larger_0s(i + 1, 0));
      transform_right_filter_feature_0_choice(15 * i + 19) := choice(is_set(transform_right_filter_column(2 * i + 2,
        0), 7), transform_filtering_0_column_inside(i + 1), transform_right_filter_feature_0_alls(i + 2));
      transform_right_filter_feature_0_choice(15 * i + 20) := choice(transform_right_filter_feature_0_choice(15 * i +
        18), is_set(transform_right_filter_column(2 * i + 2, 0), 7) and (not is_set(transform_right_filter_column(4,
        1), 7)) and transform_filtering_0_column_inside(i + 1), transform_right_filter_feature_0_choice(15 * i + 19));
      transform_right_filter_feature_0_choice(15 * i + 23) := not is_larger(transform_right_filter_column(2 * i + 2,
        2), transform_right_filter_column(4, 1), 4, 6, transform_right_filter_low_is_larger_0s(i + 1, 2));
    end loop;
    transform_right_filter_feature_0_choice(69) := choice(is_set(transform_right_filter_column(8, 2), 7),
      transform_filtering_0_column_inside(4), transform_right_filter_feature_0_alls(5));
    transform_right_filter_feature_0_choice(70) := choice(transform_right_filter_feature_0_choice(68),
      is_set(transform_right_filter_column(8, 2), 7) and (not is_set(transform_right_filter_column(4, 1), 7)) and
      transform_filtering_0_column_inside(4), transform_right_filter_feature_0_choice(69));
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
    transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
    transform_read_column_inside(1) <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
    transform_read_column_inside(2) <= true;
    transform_read_column_inside(3) <= (transform_counter_column < 6) /= transform_read_column_inside_0_is_less;
    transform_read_column_inside(4) <= (transform_counter_column < 8) /= transform_read_column_inside_0_is_less;
    transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
    transform_read_valid <= transform_valid;
    transform_ready_column <= transform_read_column;
    transform_ready_row_inside(0) <= transform_reached_first(0) and (not transform_counter_next_frame_after);
    transform_ready_row_inside(1) <= transform_reached_first(1) and (not transform_reached_beyond_last(3));
    transform_ready_row_inside(2) <= transform_read_column_inside(2) and (not transform_reached_beyond_last(2));
    transform_ready_column_inside(0 to 1) <= transform_read_column_inside(0 to 1);
    transform_ready_column_inside(2) <= transform_reached_first(2);
    transform_ready_column_inside(3 to 4) <= transform_read_column_inside(3 to 4);
    transform_ready_start_of_frame <= transform_read_start_of_frame;
    transform_ready_valid <= transform_read_valid;
    transform_reached_first(0) <= 3 < transform_counter_group;
    transform_reached_first(1) <= 1 < transform_counter_group;
    transform_reached_first(2) <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
    transform_reached_beyond_last(2) <= 479 < transform_counter_group;
    transform_reached_beyond_last(3) <= 481 < transform_counter_group;
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
    transform_left_filter_feature_0 <= as_number(transform_left_filter_feature_0_choice(5)) +
      (as_number(transform_left_filter_feature_0_choice(10)) * 2) +
      (as_number(transform_left_filter_feature_0_choice(14)) * 4) +
      (as_number(transform_left_filter_feature_0_choice(19)) * 16) +
      (as_number(transform_left_filter_feature_0_choice(24)) * 8) +
      (as_number(transform_left_filter_feature_0_choice(28)) * 32) +
      (as_number(transform_left_filter_feature_0_choice(33)) * 64) +
      (as_number(transform_left_filter_feature_0_choice(37)) * 128) +
      (as_number(transform_left_filter_feature_0_choice(42)) * 512) +
      (as_number(transform_left_filter_feature_0_choice(47)) * 256) +
      (as_number(transform_left_filter_feature_0_choice(51)) * 1024) +
      (as_number(transform_left_filter_feature_0_choice(56)) * 4096) +
      (as_number(transform_left_filter_feature_0_choice(61)) * 2048) +
      (as_number(transform_left_filter_feature_0_choice(65)) * 8192);
    transform_right_filter_feature_0 <= as_number(transform_right_filter_feature_0_choice(5)) +
      (as_number(transform_right_filter_feature_0_choice(10)) * 2) +
      (as_number(transform_right_filter_feature_0_choice(15)) * 4) +
      (as_number(transform_right_filter_feature_0_choice(20)) * 16) +
      (as_number(transform_right_filter_feature_0_choice(25)) * 8) +
      (as_number(transform_right_filter_feature_0_choice(30)) * 32) +
      (as_number(transform_right_filter_feature_0_choice(35)) * 64) +
      (as_number(transform_right_filter_feature_0_choice(40)) * 128) +
      (as_number(transform_right_filter_feature_0_choice(45)) * 512) +
      (as_number(transform_right_filter_feature_0_choice(50)) * 256) +
      (as_number(transform_right_filter_feature_0_choice(55)) * 1024) +
      (as_number(transform_right_filter_feature_0_choice(60)) * 4096) +
      (as_number(transform_right_filter_feature_0_choice(65)) * 2048) +
      (as_number(transform_right_filter_feature_0_choice(70)) * 8192);
    transform_filtering_0_column_inside <= transform_columns_column_inside;
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
    transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
    transform_filtering_valid(1) <= transform_filtering_valid(0);
    transform_filtering_start_of_frame(2) <= transform_filtering_start_of_frame(1);
    transform_filtering_valid(2) <= transform_filtering_valid(1);
    transform_counter_frame_joins <= choice(transform_counter_counts, transform_counter_frame_joins_choice,
      refinement_scaled_gap);
    transform_counter_column_after <= choice(transform_counter_last_column, 0, (transform_counter_column + 1) mod 1024);
    transform_counter_group_after <= choice((not transform_counter_counts) or (not transform_counter_last_column),
      transform_counter_group, transform_counter_group_after_choice);
    transform_left_filter_low_is_larger_0(0, 0) <= carry(transform_left_filter_low_is_larger_0_choice_3(0, 0), not
      is_set(transform_left_filter_column(4, 1), 3), transform_left_filter_low_is_larger_0_value(0, 0, 4));
    transform_left_filter_low_is_larger_0(0, 1) <= inverted_carry(transform_left_filter_low_is_larger_0_choice_3(0, 1),
      transform_left_filter_low_is_larger_0_value(0, 1, 1), not is_set(transform_left_filter_column(4, 1), 3));
    transform_left_filter_low_is_larger_0(0, 2) <= inverted_carry(transform_left_filter_low_is_larger_0_choice_3(0, 2),
      transform_left_filter_low_is_larger_0_value(0, 2, 1), not is_set(transform_left_filter_column(4, 1), 3));
    for i in 0 to 2 loop
      transform_left_filter_low_is_larger_0(1, i) <= inverted_carry(transform_left_filter_low_is_larger_0_choice_3(1,
        i), transform_left_filter_low_is_larger_0_value(1, i, 1), not is_set(transform_left_filter_column(4, 1), 3));
    end loop;
    transform_left_filter_low_is_larger_0_4_0 <= inverted_carry(transform_left_filter_low_is_larger_0_choice_3(2, 0),
      transform_left_filter_low_is_larger_0_value(2, 0, 1), not is_set(transform_left_filter_column(4, 1), 3));
    transform_left_filter_low_is_larger_0_4_4 <= inverted_carry(transform_left_filter_low_is_larger_0_choice_3(2, 2),
      transform_left_filter_low_is_larger_0_value(2, 2, 1), not is_set(transform_left_filter_column(4, 1), 3));
    for i in 3 to 4 loop
      for j in 0 to 2 loop
        transform_left_filter_low_is_larger_0s(i, j) <=
          inverted_carry(transform_left_filter_low_is_larger_0_choice_3(i, j),
          transform_left_filter_low_is_larger_0_value(i, j, 1), not is_set(transform_left_filter_column(4, 1), 3));
      end loop;
    end loop;
    transform_right_filter_low_is_larger_0(0, 0) <= carry(transform_right_filter_low_is_larger_0_choice_3(0, 0), not
      is_set(transform_right_filter_column(4, 1), 3), transform_right_filter_low_is_larger_0_value(0, 0, 4));
    transform_right_filter_low_is_larger_0(0, 1) <= inverted_carry(transform_right_filter_low_is_larger_0_choice_3(0,
      1), transform_right_filter_low_is_larger_0_value(0, 1, 1), not is_set(transform_right_filter_column(4, 1), 3));
    transform_right_filter_low_is_larger_0(0, 2) <= inverted_carry(transform_right_filter_low_is_larger_0_choice_3(0,
      2), transform_right_filter_low_is_larger_0_value(0, 2, 1), not is_set(transform_right_filter_column(4, 1), 3));
    for i in 0 to 2 loop
      transform_right_filter_low_is_larger_0(1, i) <= inverted_carry(transform_right_filter_low_is_larger_0_choice_3(1,
        i), transform_right_filter_low_is_larger_0_value(1, i, 1), not is_set(transform_right_filter_column(4, 1), 3));
    end loop;
    transform_right_filter_low_is_larger_0_4_0 <= inverted_carry(transform_right_filter_low_is_larger_0_choice_3(2, 0),
      transform_right_filter_low_is_larger_0_value(2, 0, 1), not is_set(transform_right_filter_column(4, 1), 3));
    transform_right_filter_low_is_larger_0_4_4 <= inverted_carry(transform_right_filter_low_is_larger_0_choice_3(2, 2),
      transform_right_filter_low_is_larger_0_value(2, 2, 1), not is_set(transform_right_filter_column(4, 1), 3));
    for i in 3 to 4 loop
      for j in 0 to 2 loop
        transform_right_filter_low_is_larger_0s(i, j) <=
          inverted_carry(transform_right_filter_low_is_larger_0_choice_3(i, j),
          transform_right_filter_low_is_larger_0_value(i, j, 1), not is_set(transform_right_filter_column(4, 1), 3));
      end loop;
    end loop;
    transform_counter_group_choice := choice(transform_counter_next_frame, 15, 0);
    if in_valid then
      transform_counter_column <= choice(in_start_of_frame, 0, transform_counter_column_after);
      transform_counter_group <= choice(in_start_of_frame, transform_counter_group_choice * 32,
        transform_counter_group_after);
    end if;
    if transform_ready_valid then
      transform_left_rows_write_words_0 <= to_unsigned(transform_left_rows_ready_newest_0, 8) &
        transform_left_rows_ready_words_0(31 downto 8);
      transform_right_rows_write_words_0 <= to_unsigned(transform_right_rows_ready_newest_0, 8) &
        transform_right_rows_ready_words_0(31 downto 8);
      transform_write_column <= transform_ready_column;
    end if;
    if transform_filtering_valid(2) then
      transform_read_row_inside_0 <= choice(transform_filtering_start_of_frame(2), raster_place_next_frame,
        raster_place_back_to_back);
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
    raster_place_next_frame_is_equal := raster_place_column = 639;
    raster_place_back_to_back_choice := choice(raster_place_last_column, (not raster_place_frame_joins) and
      transform_read_row_inside_0, transform_read_row_inside_0);
    raster_place_group_after_choice := choice(raster_place_frame_joins, 1, (raster_place_group + 1) mod 512);
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(2);
    raster_place_next_frame <= raster_place_next_frame_is_equal and (raster_place_group = 479);
    raster_place_last_column <= raster_place_next_frame_is_equal;
    raster_place_counts <= raster_place_group < 480;
    raster_place_frame_joins <= (raster_place_group = 480) and transform_read_row_inside_0;
    raster_place_back_to_back <= choice(delay_row_inside(2), raster_place_back_to_back_choice,
      transform_read_row_inside_0);
    raster_place_column_after <= choice(raster_place_last_column, 0, (raster_place_column + 1) mod 1024);
    raster_place_group_after <= choice((not delay_row_inside(2)) or (not raster_place_last_column), raster_place_group,
      raster_place_group_after_choice);
    raster_place_group_choice := choice(raster_place_next_frame, 15, 0);
    if transform_filtering_valid(2) then
      raster_place_column <= choice(transform_filtering_start_of_frame(2), 0, raster_place_column_after);
      raster_place_group <= choice(transform_filtering_start_of_frame(2), raster_place_group_choice * 32,
        raster_place_group_after);
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
    delay_tag.valid <= raster_features_valid;
    delay_tag.map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.output_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less and
      delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
    delay_tag.first_column <= delay_tag_first_column_is_equal;
    delay_tag.start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 1);
    delay_tag.end_of_line <= raster_place_column = 638;
    -- rows
    rows_search_rows_read_newest_0 <= delay_delayed_0;
    rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= delay_ahead_0;
    rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside(0 to 1) <= delay_row_inside(0 to 1);
    rows_read_inside(2) <= raster_place_counts;
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
    -- line
    if rows_tag.valid then
      line_centre_map_column_0 <= rows_tag.map_column;
      line_centre_output_column_0 <= rows_tag.output_column;
      line_centre_first_column_0 <= rows_tag.first_column;
      line_centre_start_of_frame_0 <= rows_tag.start_of_frame;
      line_centre_end_of_line_0 <= rows_tag.end_of_line;
      line_order_inside <= line_centre_map_column_0;
      line_newest_first_column <= line_centre_first_column_0;
      line_newest_top <= line_centre_start_of_frame_0;
    end if;
    line_order_address_any := (not line_centre_map_column_0) or line_order_inside or (not rows_tag.valid);
    line_order_address_choice := choice(line_order_falls, 1023, 1);
    line_order_address_choice_2 := choice(line_order_falls, 0, 637);
    if not ((not line_centre_map_column_0) or (not rows_tag.valid)) then
      line_order_address <= choice(line_order_address_any, (line_order_address_choice + line_order_address) mod 1024,
        line_order_address_choice_2);
    end if;
    line_order_falls_all := line_centre_map_column_0 and (not line_order_inside) and rows_tag.valid;
    line_order_turned_output_column_choice := choice(line_order_falls_all, line_order_output and line_order_complete,
      line_order_held_output);
    line_order_turned_valid <= rows_tag.valid;
    line_order_turned_map_column <= line_centre_map_column_0;
    line_order_turned_output_column <= line_order_turned_output_column_choice and line_centre_map_column_0;
    line_order_turned_first_column <= line_order_falls_all;
    line_order_turned_start_of_frame <= line_centre_map_column_0 and (not line_order_inside) and rows_tag.valid and
      line_order_first and line_order_output and line_order_complete;
    line_order_turned_end_of_line <= line_centre_end_of_line_0;
    line_comes(1) <= line_order_turned_valid;
    line_comes(2 to 33) <= line_comes(1 to 32);
    line_starts_phases(1) <= line_order_inside and line_order_turned_valid;
    line_starts_phases(2 to 33) <= line_starts_phases(1 to 32);
    line_order_falls <= choice(line_order_falls, line_order_address_any, line_order_falls_all);
    line_order_complete <= choice(line_order_complete, line_centre_end_of_line_0 or (not line_centre_map_column_0) or
      (not rows_tag.valid), line_centre_end_of_line_0 and line_centre_map_column_0 and rows_tag.valid);
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
    if rows_tag.valid then
      costsshift_newest <= rows_search;
      costsshift_new_reference <= rows_reference;
    end if;
    costsshift_count_phase_choice := choice(costsshift_count_phase = 7, 7, (costsshift_count_phase + 1) mod 8);
    costsshift_new_tag_valid <= rows_tag.valid or (not is_set(costsshift_count_phase, 2)) or (not
      is_set(costsshift_count_phase, 1)) or (not is_set(costsshift_count_phase, 0));
    costsshift_handed_on(0) <= to_integer(costsshift_read_words(3)(27 downto 14));
    costsshift_handed_on(1) <= to_integer(costsshift_read_words(7)(27 downto 14));
    costsshift_handed_on(2) <= to_integer(costsshift_read_words(11)(27 downto 14));
    costsshift_read_reference <= costsshift_new_reference;
    costsshift_read_tag_valid <= costsshift_new_tag_valid;
    costsshift_read_count_phase <= costsshift_count_phase;
    costsshift_reference <= costsshift_read_reference;
    costsshift_write_phase <= costsshift_read_count_phase;
    costsshift_count_phase <= choice(rows_tag.valid, 0, costsshift_count_phase_choice);
    costsshift_search_0_0_is_equal := costsshift_read_count_phase = 0;
    if costsshift_read_tag_valid then
      for i in 0 to 2 loop
        for j in 0 to 2 loop
          costsshift_search(i, 2 * j + 1) <= to_integer(costsshift_read_words(4 * i + j)(13 downto 0));
          costsshift_search(i, 2 * j + 2) <= to_integer(costsshift_read_words(4 * i + j)(27 downto 14));
        end loop;
        costsshift_search(i, 7) <= to_integer(costsshift_read_words(4 * i + 3)(13 downto 0));
      end loop;
      for i in 0 to 2 loop
        costsshift_search(i, 0) <= choice(costsshift_search_0_0_is_equal, costsshift_newest(i),
          costsshift_handed_on(i));
      end loop;
    end if;
    -- costscolumn
    for i in 0 to 2 loop
      costscolumn_pixels_first_count(i, 0, 0) <= differing(costsshift_search(i, 0), costsshift_reference(i), 0) +
        differing(costsshift_reference(i), costsshift_search(i, 0), 2) + differing(costsshift_reference(i),
        costsshift_search(i, 0), 1);
      costscolumn_pixels_first_count(i, 0, 1) <= differing(costsshift_reference(i), costsshift_search(i, 0), 3, 5, 4);
      costscolumn_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((costsshift_search(i, 0) mod 256), 8)) xor
        (to_unsigned((costsshift_reference(i) mod 256), 8)))) / 128) + differing(costsshift_reference(i),
        costsshift_search(i, 0), 8) + differing(costsshift_reference(i), costsshift_search(i, 0), 6);
      costscolumn_pixels_first_count(i, 0, 3) <= differing(costsshift_reference(i), costsshift_search(i, 0), 9, 11, 10);
      costscolumn_pixels_first_count_4(i, 0) <= differing(costsshift_reference(i), costsshift_search(i, 0), 13) +
        differing(costsshift_reference(i), costsshift_search(i, 0), 12);
      for j in 1 to 7 loop
        costscolumn_pixels_first_count(i, j, 0) <= differing(costsshift_search(i, j), costsshift_reference(i), 0, 2, 1);
        costscolumn_pixels_first_count(i, j, 1) <= differing(costsshift_search(i, j), costsshift_reference(i), 3, 5, 4);
        costscolumn_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((costsshift_search(i, j) mod 256), 8)) xor
          (to_unsigned((costsshift_reference(i) mod 256), 8)))) / 128) + differing(costsshift_search(i, j),
          costsshift_reference(i), 8) + differing(costsshift_search(i, j), costsshift_reference(i), 6);
        costscolumn_pixels_first_count(i, j, 3) <= differing(costsshift_search(i, j), costsshift_reference(i), 9, 11,
          10);
        costscolumn_pixels_first_count_4(i, j) <= differing(costsshift_search(i, j), costsshift_reference(i), 13) +
          differing(costsshift_search(i, j), costsshift_reference(i), 12);
      end loop;
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 7 loop
        costscolumn_pixels_cost(i, j) <= costscolumn_pixels_first_count(i, j, 3) + costscolumn_pixels_first_count(i, j,
          0) + costscolumn_pixels_first_count(i, j, 1) + costscolumn_pixels_first_count_4(i, j) +
          costscolumn_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    for i in 0 to 7 loop
      costscolumn_pair_0(i) <= costscolumn_pixels_cost(1, i) + costscolumn_pixels_cost(2, i);
    end loop;
    for i in 0 to 7 loop costscolumn_single_0(i) <= costscolumn_pixels_cost(0, i); end loop;
    for i in 0 to 7 loop costscolumn_column_0(i) <= costscolumn_pair_0(i) + costscolumn_single_0(i); end loop;
    -- costswindow
    costswindow_read_count_phase_choice := choice(costswindow_read_count_phase = 7, 7, (costswindow_read_count_phase +
      1) mod 8);
    costswindow_write_count_phase_choice := choice(costswindow_write_count_phase = 7, 7, (costswindow_write_count_phase
      + 1) mod 8);
    for i in 2 to 3 loop
      for j in 0 to 3 loop
        costswindow_sum_0(4 * i + j - 8) <= costscolumn_column_0(4 * i + j - 8) +
          to_integer(costswindow_read_wordss(i)(7 * j + 6 downto 7 * j));
      end loop;
    end loop;
    costswindow_read_count_phase <= choice(line_comes(4), 0, costswindow_read_count_phase_choice);
    costswindow_write_count_phase <= choice(line_comes(6), 0, costswindow_write_count_phase_choice);
    costswindow_partial_0_any := (not is_set(costswindow_write_count_phase, 2)) or (not
      is_set(costswindow_write_count_phase, 1)) or (not is_set(costswindow_write_count_phase, 0)) or line_comes(6);
    if costswindow_partial_0_any then
      costswindow_partial <= costscolumn_column_0;
      for i in 0 to 1 loop
        for j in 8 to 11 loop
          costswindow_partials(4 * i + j) <= costscolumn_column_0(4 * i + j - 8) +
            to_integer(costswindow_read_words(i)(7 * j - 51 downto 7 * j - 56));
        end loop;
      end loop;
    end if;
    -- costsmask
    costsmask_column_sum := costsmask_column + 1;
    costsmask_column_choice := choice(line_places_shown_first_column(0), 0, costsmask_column_sum mod 1024);
    if line_comes(5) then costsmask_column <= costsmask_column_choice; end if;
    costsmask_partner_choice := choice(line_places_shown_first_column(0), 0, costsmask_column_sum);
    costsmask_inside(0) <= (((((costsmask_partner / 1024) + 63) mod 64) * 1024) + (costsmask_partner mod 1024)) < 638;
    costsmask_inside(1) <= (costsmask_partner >= 1025) and (costsmask_partner < 1663);
    costsmask_inside(2) <= (((((costsmask_partner / 2) + 32255) mod 32768) * 2) + (costsmask_partner mod 2)) < 638;
    costsmask_inside(3) <= (costsmask_partner >= 1027) and (costsmask_partner < 1665);
    costsmask_inside(4) <= (((((costsmask_partner / 4) + 16127) mod 16384) * 4) + (costsmask_partner mod 4)) < 638;
    costsmask_inside(5) <= (costsmask_partner >= 1029) and (costsmask_partner < 1667);
    costsmask_inside(6) <= (((((costsmask_partner / 2) + 32253) mod 32768) * 2) + (costsmask_partner mod 2)) < 638;
    costsmask_inside(7) <= (costsmask_partner >= 1031) and (costsmask_partner < 1669);
    costsmask_partner <= choice(line_comes(5), (((costsmask_partner_choice / 1024) + 1) * 1024) +
      costsmask_column_choice, ((((costsmask_partner / 8) + 511) mod 512) * 8) + (costsmask_partner mod 8));
    -- costs
    for i in 0 to 7 loop
      costs_cost_choice(i) := choice((not ((not is_set(costswindow_sum_0(i), 6)) and ((not is_set(costswindow_sum_0(i),
        5)) or (not is_set(costswindow_sum_0(i), 4)) or (not is_set(costswindow_sum_0(i), 3))))) or
        is_set(costswindow_sum_0(i), 7), 6, costswindow_sum_0(i) / 8);
    end loop;
    for i in 0 to 7 loop costs_cost(i) <= choice(costsmask_inside(i), costs_cost_choice(i), 3); end loop;
    -- paths
    paths_smallest_cost_choice := choice(line_comes(11), 7, paths_smallest_cost);
    paths_cost_delay_ring_write_address <= paths_cost_delay_ring_read_address;
    paths_sum(0) <= (pathsturn_sum_memory_ready_words(0) mod 128) + pathsright_cost(0);
    paths_sum(1) <= ((pathsturn_sum_memory_ready_words(0) / 128) mod 128) + pathsright_cost(1);
    paths_sum(2) <= ((pathsturn_sum_memory_ready_words(1) mod 32) * 4) + (pathsturn_sum_memory_ready_words(0) / 16384)
      + pathsright_cost(2);
    paths_sum(3) <= ((pathsturn_sum_memory_ready_words(1) / 32) mod 128) + pathsright_cost(3);
    paths_sum(4) <= ((pathsturn_sum_memory_ready_words(2) mod 8) * 16) + (pathsturn_sum_memory_ready_words(1) / 4096) +
      pathsright_cost(4);
    paths_sum(5) <= ((pathsturn_sum_memory_ready_words(2) / 8) mod 128) + pathsright_cost(5);
    paths_sum(6) <= ((pathsturn_sum_memory_ready_words(3) mod 2) * 64) + (pathsturn_sum_memory_ready_words(2) / 1024) +
      pathsright_cost(6);
    paths_sum(7) <= (pathsturn_sum_memory_ready_words(3) / 2) + pathsright_cost(7);
    paths_tree_smallest(0) <= smaller(costs_cost(1), costs_cost(0));
    paths_tree_smallest(1) <= smaller(costs_cost(3), costs_cost(2));
    paths_tree_smallest(2) <= smaller(costs_cost(5), costs_cost(4));
    paths_tree_smallest(3) <= smaller(costs_cost(7), costs_cost(6));
    paths_tree_next_smallest(0) <= smaller(paths_tree_smallest(1), paths_tree_smallest(0));
    paths_tree_next_smallest(1) <= smaller(paths_tree_smallest(3), paths_tree_smallest(2));
    paths_tree_next_next_smallest_0 <= smaller(paths_tree_next_smallest(1), paths_tree_next_smallest(0));
    paths_smallest_cost <= smaller(paths_tree_next_next_smallest_0, paths_smallest_cost_choice);
    paths_cost_delay_ring_read_address <= choice(paths_cost_delay_ring_read_address = 11, 0,
      (paths_cost_delay_ring_read_address + 1) mod 16);
    -- pathsleft
    if line_starts_phases(10) then
      pathsleft_fresh_past_newest(0) <= relief_left(1);
      pathsleft_fresh_past_newest(1) <= pathsleft_fresh_past_newest(0);
    end if;
    if line_starts_phases(11) then
      pathsleft_fresh_past_pairs(1 to 2) <= pathsleft_fresh_past_pairs(0 to 1);
      pathsleft_fresh_past_pairs(0) <= smaller(pathsleft_fresh_past_newest(1), pathsleft_fresh_past_newest(0));
    end if;
    if line_starts_phases(12) then
      pathsleft_fresh_past_fours(1 to 6) <= pathsleft_fresh_past_fours(0 to 5);
      pathsleft_fresh_past_fours(0) <= smaller(pathsleft_fresh_past_pairs(2), pathsleft_fresh_past_pairs(0));
    end if;
    pathsleft_read_count_phase_is_equal := pathsleft_read_count_phase = 7;
    pathsleft_read_count_phase_choice := choice(pathsleft_read_count_phase_is_equal, 7, (pathsleft_read_count_phase +
      1) mod 8);
    pathsleft_ahead_count_phase_choice := choice(pathsleft_ahead_count_phase = 7, 7, (pathsleft_ahead_count_phase + 1)
      mod 8);
    pathsleft_stay_value(0, 1) := is_set(pathsleft_fresh_here, 1);
    pathsleft_stay_0_is_equal := (pathsleft_fresh_here mod 4) = 0;
    pathsleft_stay_value(0, 2) := is_set(pathsleft_fresh_here, 2);
    pathsleft_stay_value(0, 3) := is_set(pathsleft_fresh_here, 3);
    pathsleft_stay_value(0, 4) := is_set(pathsleft_fresh_here, 4);
    pathsleft_stay_value(0, 5) := is_set(pathsleft_fresh_here, 5);
    pathsleft_stay_choice(0, 7) := not is_larger(to_integer(pathsleft_read_words(2)(6 downto 0)), pathsleft_fresh_here,
      0, 6, true);
    for i in 6 to 10 loop pathsleft_stay_value(0, i) := pathsleft_read_words(0)(i - 4) = '1'; end loop;
    pathsleft_stay_choice(0, 14) := not is_larger(pathsleft_fresh_here, to_integer(pathsleft_read_words(0)(6 downto
      0)), 0, 6, false);
    pathsleft_stay_choice(0, 15) := choice(pathsleft_stay_choice(0, 7), not pathsleft_first, (not
      pathsleft_stay_choice(0, 14)) and (not pathsleft_first));
    pathsleft_stay_choice_16(0) := smaller(to_integer(pathsleft_read_words(2)(6 downto 0)),
      to_integer(pathsleft_read_words(0)(6 downto 0)));
    for i in 1 to 2 loop
      pathsleft_stay_value(i, 1) := pathsleft_read_words(2)(7 * i) = '1';
      pathsleft_stay_choice(i, 7) := not is_larger(to_integer(pathsleft_read_words(2)(7 * i + 6 downto 7 * i)),
        pathsleft_fresh_here, 0, 6, true);
      pathsleft_stay_value(i, 2) := pathsleft_read_words(0)(7 * i) = '1';
      pathsleft_stay_choice(i, 14) := not is_larger(to_integer(pathsleft_read_words(0)(7 * i + 6 downto 7 * i)),
        pathsleft_fresh_here, 0, 6, true);
      pathsleft_stay_choice(i, 15) := choice(pathsleft_stay_choice(i, 7), not pathsleft_first, pathsleft_stay_choice(i,
        14) and (not pathsleft_first));
      pathsleft_stay_values(i, 3) := to_integer(pathsleft_read_words(2)(7 * i + 6 downto 7 * i));
      pathsleft_stay_values(i, 4) := to_integer(pathsleft_read_words(0)(7 * i + 6 downto 7 * i));
      pathsleft_stay_choice_16(i) := smaller(pathsleft_stay_values(i, 3), pathsleft_stay_values(i, 4));
    end loop;
    pathsleft_stay_value(3, 1) := pathsleft_read_words(2)(21) = '1';
    pathsleft_stay_choice(3, 7) := not is_larger(to_integer(pathsleft_read_words(2)(27 downto 21)),
      pathsleft_fresh_here, 0, 6, true);
    pathsleft_stay_value(3, 2) := pathsleft_read_words(0)(21) = '1';
    pathsleft_stay_choice(3, 14) := not is_larger(to_integer(pathsleft_read_words(0)(27 downto 21)),
      pathsleft_fresh_here, 0, 6, true);
    pathsleft_stay_choice(3, 15) := choice(pathsleft_stay_choice(3, 7), not pathsleft_first, pathsleft_stay_choice(3,
      14) and (not pathsleft_first));
    pathsleft_stay_choice_16(3) := smaller(to_integer(pathsleft_read_words(2)(27 downto 21)),
      to_integer(pathsleft_read_words(0)(27 downto 21)));
    pathsleft_stay_choice(4, 7) := not is_larger(to_integer(pathsleft_read_words(3)(6 downto 0)), pathsleft_fresh_here,
      0, 6, true);
    pathsleft_stay_choice(4, 14) := not is_larger(to_integer(pathsleft_read_words(1)(6 downto 0)),
      pathsleft_fresh_here, 0, 6, true);
    pathsleft_stay_choice(4, 15) := choice(pathsleft_stay_choice(4, 7), not pathsleft_first, pathsleft_stay_choice(4,
      14) and (not pathsleft_first));
    pathsleft_stay_choice_16(4) := smaller(to_integer(pathsleft_read_words(3)(6 downto 0)),
      to_integer(pathsleft_read_words(1)(6 downto 0)));
    for i in 5 to 6 loop
      pathsleft_stay_value(i, 1) := pathsleft_read_words(3)(7 * i - 28) = '1';
      pathsleft_stay_choice(i, 7) := not is_larger(to_integer(pathsleft_read_words(3)(7 * i - 22 downto 7 * i - 28)),
        pathsleft_fresh_here, 0, 6, true);
      pathsleft_stay_value(i, 2) := pathsleft_read_words(1)(7 * i - 28) = '1';
      pathsleft_stay_choice(i, 14) := not is_larger(to_integer(pathsleft_read_words(1)(7 * i - 22 downto 7 * i - 28)),
        pathsleft_fresh_here, 0, 6, true);
      pathsleft_stay_choice(i, 15) := choice(pathsleft_stay_choice(i, 7), not pathsleft_first, pathsleft_stay_choice(i,
        14) and (not pathsleft_first));
      pathsleft_stay_values(i, 3) := to_integer(pathsleft_read_words(3)(7 * i - 22 downto 7 * i - 28));
      pathsleft_stay_values(i, 4) := to_integer(pathsleft_read_words(1)(7 * i - 22 downto 7 * i - 28));
      pathsleft_stay_choice_16(i) := smaller(pathsleft_stay_values(i, 3), pathsleft_stay_values(i, 4));
    end loop;
    pathsleft_stay_value(7, 1) := pathsleft_read_words(3)(21) = '1';
    pathsleft_stay_choice(7, 7) := not is_larger(to_integer(pathsleft_read_words(3)(27 downto 21)),
      pathsleft_fresh_here, 0, 6, true);
    pathsleft_stay_value(7, 2) := pathsleft_read_words(1)(21) = '1';
    pathsleft_stay_choice(7, 14) := not is_larger(to_integer(pathsleft_read_words(1)(27 downto 21)),
      pathsleft_fresh_here, 0, 6, true);
    pathsleft_stay_choice(7, 15) := choice(pathsleft_stay_choice(7, 7), not pathsleft_first, pathsleft_stay_choice(7,
      14) and (not pathsleft_first));
    pathsleft_stay_choice_16(7) := smaller(to_integer(pathsleft_read_words(3)(27 downto 21)),
      to_integer(pathsleft_read_words(1)(27 downto 21)));
    pathsleft_step_choice(0, 1) := choice(pathsleft_is_first, pathsleft_stay_values(1, 4), pathsleft_lower_neighbour);
    pathsleft_step_choice(0, 2) := smaller(pathsleft_stay_values(1, 4), pathsleft_step_choice(0, 1));
    pathsleft_step_choice(1, 1) := smaller(pathsleft_stay_values(2, 4), to_integer(pathsleft_read_words(0)(6 downto
      0)));
    pathsleft_step_choice(2, 1) := smaller(to_integer(pathsleft_read_words(0)(27 downto 21)), pathsleft_stay_values(1,
      4));
    pathsleft_step_choice(3, 1) := smaller(to_integer(pathsleft_read_words(1)(6 downto 0)), pathsleft_stay_values(2,
      4));
    pathsleft_step_choice(4, 1) := smaller(pathsleft_stay_values(5, 4), to_integer(pathsleft_read_words(0)(27 downto
      21)));
    pathsleft_step_choice(5, 1) := smaller(pathsleft_stay_values(6, 4), to_integer(pathsleft_read_words(1)(6 downto
      0)));
    pathsleft_step_choice(6, 1) := smaller(to_integer(pathsleft_read_words(1)(27 downto 21)), pathsleft_stay_values(5,
      4));
    pathsleft_step_choice(7, 1) := choice(pathsleft_is_last, pathsleft_stay_values(6, 4),
      to_integer(pathsleft_read_neighbour_0));
    pathsleft_step_choice(7, 2) := smaller(pathsleft_step_choice(7, 1), pathsleft_stay_values(6, 4));
    pathsleft_stay_change_value(1) := to_integer(paths_cost_delay_held_0(5 downto 0)) / 8;
    for i in 2 to 6 loop
      pathsleft_stay_change_value(i) := to_integer(paths_cost_delay_held_0(3 * i + 2 downto 3 * i));
    end loop;
    pathsleft_write_count_phase_choice := choice(pathsleft_write_count_phase = 7, 7, (pathsleft_write_count_phase + 1)
      mod 8);
    pathsleft_low_0_choice := choice(line_comes(25), 127, pathsleft_low_0);
    pathsleft_fresh_past_oldest <= pathsleft_fresh_past_fours(6);
    pathsleft_lost <= is_set(pathsleft_fresh_known, 6);
    pathsleft_short_of <= (((pathsleft_fresh_known mod 64) + pathsleft_room) / 64) = 1;
    pathsleft_missing <= (pathsleft_fresh_known + pathsleft_room) mod 64;
    pathsleft_below <= (0 - pathsleft_fresh_known) mod 64;
    pathsleft_is_first <= pathsleft_read_count_phase = 0;
    pathsleft_is_last <= pathsleft_read_count_phase_is_equal;
    pathsleft_lower_neighbour <= to_integer(pathsleft_read_words(1)(27 downto 21));
    pathsleft_stay_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g) mod 128;
    for i in 1 to 6 loop pathsleft_stay_change(i) <= (pathsleft_stay_change_value(i) - pathsleft_g) mod 128; end loop;
    pathsleft_stay_change(7) <= (to_integer(paths_cost_delay_held_0(23 downto 21)) - pathsleft_g) mod 128;
    pathsleft_step_change(0) <= (to_integer(paths_cost_delay_held_0(2 downto 0)) - pathsleft_g_less) mod 128;
    for i in 1 to 6 loop
      pathsleft_step_change(i) <= (pathsleft_stay_change_value(i) - pathsleft_g_less) mod 128;
    end loop;
    pathsleft_step_change(7) <= (to_integer(paths_cost_delay_held_0(23 downto 21)) - pathsleft_g_less) mod 128;
    pathsleft_fresh_past_eight <= smaller(pathsleft_fresh_past_fours(4), pathsleft_fresh_past_fours(0));
    pathsleft_fresh_past_cheapest <= smaller(pathsleft_fresh_past_oldest, pathsleft_fresh_past_eight);
    pathsleft_fresh_known <= smaller(pathsleft_fresh_past_cheapest, to_integer(pathsleft_lowest_0));
    pathsleft_read_count_phase <= choice(line_starts_phases(18), 0, pathsleft_read_count_phase_choice);
    pathsleft_ahead_count_phase <= choice(line_starts_phases(17), 0, pathsleft_ahead_count_phase_choice);
    for i in 0 to 7 loop
      pathsleft_stay(i) <= choice(pathsleft_stay_choice(i, 15), pathsleft_stay_choice_16(i), pathsleft_fresh_here);
    end loop;
    pathsleft_step(0) <= choice(pathsleft_first, 64, pathsleft_step_choice(0, 2));
    for i in 1 to 6 loop pathsleft_step(i) <= choice(pathsleft_first, 64, pathsleft_step_choice(i, 1)); end loop;
    pathsleft_step(7) <= choice(pathsleft_first, 64, pathsleft_step_choice(7, 2));
    pathsleft_write_count_phase <= choice(line_starts_phases(21), 0, pathsleft_write_count_phase_choice);
    pathsleft_tree_smallest(0) <= smaller(pathsleft_cost(1), pathsleft_cost(0));
    pathsleft_tree_smallest(1) <= smaller(pathsleft_cost(3), pathsleft_cost(2));
    pathsleft_tree_smallest(2) <= smaller(pathsleft_cost(5), pathsleft_cost(4));
    pathsleft_tree_smallest(3) <= smaller(pathsleft_cost(7), pathsleft_cost(6));
    pathsleft_tree_next_smallest(0) <= smaller(pathsleft_tree_smallest(1), pathsleft_tree_smallest(0));
    pathsleft_tree_next_smallest(1) <= smaller(pathsleft_tree_smallest(3), pathsleft_tree_smallest(2));
    pathsleft_tree_next_next_smallest_0 <= smaller(pathsleft_tree_next_smallest(1), pathsleft_tree_next_smallest(0));
    pathsleft_low_0 <= smaller(pathsleft_tree_next_next_smallest_0, pathsleft_low_0_choice);
    if line_starts_phases(19) then
      pathsleft_fresh_here <= relief_left(2);
      pathsleft_first <= line_places_shown_first_column(2);
      pathsleft_g <= paths_smallest_cost + pathsleft_q_now;
      pathsleft_g_less <= (paths_smallest_cost + pathsleft_q_less) mod 128;
    end if;
    if line_starts_phases(13) then pathsleft_low_address <= (pathsleft_low_address + 1) mod 16; end if;
    pathsleft_q_choices(1) := choice(pathsleft_short_of, pathsleft_missing, 0);
    pathsleft_q_choices(2) := choice(pathsleft_lost, pathsleft_room, pathsleft_q_choices(1));
    pathsleft_room_left_choice := choice(pathsleft_short_of, pathsleft_below, pathsleft_room);
    if line_starts_phases(17) then
      pathsleft_q <= choice(line_places_shown_first_column(2), 40, pathsleft_q_choices(2));
      pathsleft_room_left <= choice(pathsleft_lost, 0, pathsleft_room_left_choice);
    end if;
    if line_starts_phases(18) then
      pathsleft_q_now <= pathsleft_q;
      pathsleft_q_less <= (pathsleft_q + 119) mod 128;
      pathsleft_room <= choice(line_places_shown_first_column(2), 0, (pathsleft_room_left + pathsleft_start_cost(8))
        mod 64);
      pathsleft_start_cost(1) <= choice(line_places_shown_first_column(2), 0, pathsleft_q_now);
      for i in 2 to 8 loop
        pathsleft_start_cost(i) <= choice(line_places_shown_first_column(2), 0, pathsleft_start_cost(i - 1));
      end loop;
    end if;
    pathsleft_cost_0_any := (not is_set(pathsleft_write_count_phase, 2)) or (not is_set(pathsleft_write_count_phase,
      1)) or (not is_set(pathsleft_write_count_phase, 0)) or line_starts_phases(21);
    if pathsleft_cost_0_any then
      for i in 0 to 7 loop pathsleft_cost(i) <= (pathsleft_stay(i) + pathsleft_stay_change(i)) mod 128; end loop;
      for i in 0 to 7 loop pathsleft_arrived(i) <= (pathsleft_step(i) + pathsleft_step_change(i)) mod 128; end loop;
    end if;
    if line_starts_phases(33) then pathsleft_low_write_address <= (pathsleft_low_write_address + 1) mod 16; end if;
    -- pathsabove
    pathsabove_memory_read_address_0_sum := pathsabove_read_address_address + 1;
    pathsabove_memory_read_address_0_choice := choice(line_places_shown_first_column(0), 0,
      pathsabove_memory_read_address_0_sum mod 4096);
    pathsabove_memory_read_address_0_sum_2 := pathsabove_read_address_address + as_number(((not
      is_set(pathsabove_read_address_count_phase, 2)) or (not is_set(pathsabove_read_address_count_phase, 1)) or (not
      is_set(pathsabove_read_address_count_phase, 0))));
    pathsabove_memory_read_address_1_choice := choice(line_places_shown_first_column(0), 0,
      pathsabove_memory_read_address_0_sum mod 1024);
    pathsabove_memory_bank_choices(1) := choice(line_places_shown_first_column(0), 0,
      pathsabove_memory_read_address_0_sum mod 8192);
    pathsabove_memory_bank_choices(2) := choice(line_starts_phases(4), pathsabove_memory_bank_choices(1),
      pathsabove_memory_read_address_0_sum_2 mod 8192);
    pathsabove_read_address_count_phase_choice := choice(pathsabove_read_address_count_phase = 7, 7,
      (pathsabove_read_address_count_phase + 1) mod 8);
    pathsabove_ready_top_choices(1) := choice(line_starts_phases(7), line_places_shown_first_column(0) or
      pathsabove_ready_top, pathsabove_ready_top);
    pathsabove_ready_top_choices(2) := choice(line_starts_phases(7), (not line_places_shown_first_column(0)) and
      pathsabove_ready_top, pathsabove_ready_top);
    pathsabove_total_choice(0) := choice(pathsabove_ready_top, 20, pathsabove_memory_ready_words(0) mod 32);
    pathsabove_total_choice(1) := choice(pathsabove_ready_top, 20, (pathsabove_memory_ready_words(0) / 32) mod 32);
    pathsabove_total_choice(2) := choice(pathsabove_ready_top, 20, (pathsabove_memory_ready_words(0) / 1024) mod 32);
    pathsabove_total_choice(3) := choice(pathsabove_ready_top, 20, ((pathsabove_memory_ready_words(1) mod 16) * 2) +
      (pathsabove_memory_ready_words(0) / 32768));
    pathsabove_total_choice(4) := choice(pathsabove_ready_top, 20, (pathsabove_memory_ready_words(1) / 16) mod 32);
    pathsabove_total_choice(5) := choice(pathsabove_ready_top, 20, (pathsabove_memory_ready_words(1) / 512) mod 32);
    pathsabove_total_choice(6) := choice(pathsabove_ready_top, 20, ((pathsabove_memory_ready_words(2) mod 8) * 4) +
      (pathsabove_memory_ready_words(1) / 16384));
    pathsabove_total_choice(7) := choice(pathsabove_ready_top, 20, pathsabove_memory_ready_words(2) / 8);
    pathsabove_smallest_total_choice := choice(line_comes(12), 31, pathsabove_smallest_total);
    pathsabove_count_phase_is_equal := pathsabove_count_phase = 7;
    pathsabove_count_phase_choice := choice(pathsabove_count_phase_is_equal, 7, (pathsabove_count_phase + 1) mod 8);
    pathsabove_beside_choice(0) := choice(pathsabove_count_phase = 0, pathsabove_held(1), pathsabove_lower_neighbour);
    pathsabove_beside_choice(7) := choice(pathsabove_count_phase_is_equal, pathsabove_held(6), pathsabove_cost(0));
    pathsabove_write_address_address_choice := choice(line_places_shown_first_column(2), 0,
      (pathsabove_write_address_address + 1) mod 8192);
    pathsabove_write_address_count_phase_choice := choice(pathsabove_write_address_count_phase = 7, 7,
      (pathsabove_write_address_count_phase + 1) mod 8);
    pathsabove_memory_bank <= is_set(pathsabove_memory_bank_choices(2), 12);
    pathsabove_memory_read_bank <= pathsabove_memory_bank;
    pathsabove_memory_held_words(0, 0) <= to_integer(pathsabove_memory_read_words(0, 0));
    pathsabove_memory_held_words(0, 1) <= to_integer(pathsabove_memory_read_words(0, 1));
    pathsabove_memory_held_words_2(0) <= to_integer(pathsabove_memory_read_words_2(0));
    pathsabove_memory_held_words(1, 0) <= to_integer(pathsabove_memory_read_words(1, 0));
    pathsabove_memory_held_words(1, 1) <= to_integer(pathsabove_memory_read_words(1, 1));
    pathsabove_memory_held_words_2(1) <= to_integer(pathsabove_memory_read_words_2(1));
    pathsabove_memory_held_bank <= pathsabove_memory_read_bank;
    pathsabove_read_address_address <= pathsabove_memory_bank_choices(2);
    for i in 0 to 7 loop pathsabove_total(i) <= costs_cost(i) + pathsabove_total_choice(i); end loop;
    pathsabove_cost(0) <= (to_integer(pathsabove_delay_held_0) - pathsabove_smallest) mod 32;
    pathsabove_cost(1) <= (to_integer(pathsabove_delay_held_0(29 downto 5)) - pathsabove_smallest) mod 32;
    pathsabove_cost(2) <= (to_integer(pathsabove_delay_held_0(29 downto 10)) - pathsabove_smallest) mod 32;
    pathsabove_cost(3) <= (to_integer(pathsabove_delay_held_0(29 downto 15)) - pathsabove_smallest) mod 32;
    pathsabove_cost(4) <= (to_integer(pathsabove_delay_held_0(29 downto 20)) - pathsabove_smallest) mod 32;
    pathsabove_cost(5) <= (to_integer(pathsabove_delay_held_0(29 downto 25)) - pathsabove_smallest) mod 32;
    pathsabove_cost(6) <= (to_integer(pathsabove_delay_held_1) - pathsabove_smallest) mod 32;
    pathsabove_cost(7) <= (to_integer(pathsabove_delay_held_1(9 downto 5)) - pathsabove_smallest) mod 32;
    pathsabove_held <= pathsabove_cost;
    pathsabove_lower_neighbour <= pathsabove_held(7);
    pathsabove_own <= pathsabove_held(0 to 6);
    for i in 0 to 7 loop pathsabove_step(i) <= pathsabove_beside(i) + 5; end loop;
    pathsabove_write_address_is_here <= line_starts_phases(24) or (not is_set(pathsabove_write_address_count_phase, 2))
      or (not is_set(pathsabove_write_address_count_phase, 1)) or (not is_set(pathsabove_write_address_count_phase, 0));
    pathsabove_memory_read_address_0 <= choice(line_starts_phases(4), pathsabove_memory_read_address_0_choice,
      pathsabove_memory_read_address_0_sum_2 mod 4096);
    pathsabove_memory_read_address_1 <= choice(line_starts_phases(4), pathsabove_memory_read_address_1_choice,
      pathsabove_memory_read_address_0_sum_2 mod 1024);
    pathsabove_read_address_count_phase <= choice(line_starts_phases(4), 0, pathsabove_read_address_count_phase_choice);
    pathsabove_memory_ready_words(0) <= choice(pathsabove_memory_held_bank, pathsabove_memory_held_words(1, 0),
      pathsabove_memory_held_words(0, 0));
    pathsabove_memory_ready_words(1) <= choice(pathsabove_memory_held_bank, pathsabove_memory_held_words(1, 1),
      pathsabove_memory_held_words(0, 1));
    pathsabove_memory_ready_words(2) <= choice(pathsabove_memory_held_bank, pathsabove_memory_held_words_2(1),
      pathsabove_memory_held_words_2(0));
    pathsabove_ready_top <= choice(line_places_0_top, pathsabove_ready_top_choices(1), pathsabove_ready_top_choices(2));
    pathsabove_tree_smallest(0) <= smaller(pathsabove_total(1), pathsabove_total(0));
    pathsabove_tree_smallest(1) <= smaller(pathsabove_total(3), pathsabove_total(2));
    pathsabove_tree_smallest(2) <= smaller(pathsabove_total(5), pathsabove_total(4));
    pathsabove_tree_smallest(3) <= smaller(pathsabove_total(7), pathsabove_total(6));
    pathsabove_tree_next_smallest(0) <= smaller(pathsabove_tree_smallest(1), pathsabove_tree_smallest(0));
    pathsabove_tree_next_smallest(1) <= smaller(pathsabove_tree_smallest(3), pathsabove_tree_smallest(2));
    pathsabove_tree_next_next_smallest_0 <= smaller(pathsabove_tree_next_smallest(1), pathsabove_tree_next_smallest(0));
    pathsabove_smallest_total <= smaller(pathsabove_tree_next_next_smallest_0, pathsabove_smallest_total_choice);
    pathsabove_count_phase <= choice(line_starts_phases(22), 0, pathsabove_count_phase_choice);
    pathsabove_beside(0) <= smaller(pathsabove_held(1), pathsabove_beside_choice(0));
    for i in 1 to 6 loop pathsabove_beside(i) <= smaller(pathsabove_held(i + 1), pathsabove_held(i - 1)); end loop;
    pathsabove_beside(7) <= smaller(pathsabove_beside_choice(7), pathsabove_held(6));
    for i in 0 to 6 loop pathsabove_stay(i) <= choice(pathsabove_own(i) < 20, pathsabove_own(i), 20); end loop;
    pathsabove_stay(7) <= choice(pathsabove_lower_neighbour < 20, pathsabove_lower_neighbour, 20);
    pathsabove_write_address_address <= choice(line_starts_phases(24), pathsabove_write_address_address_choice,
      (pathsabove_write_address_address + as_number(((not is_set(pathsabove_write_address_count_phase, 2)) or (not
      is_set(pathsabove_write_address_count_phase, 1)) or (not is_set(pathsabove_write_address_count_phase, 0))))) mod
      8192);
    pathsabove_write_address_count_phase <= choice(line_starts_phases(24), 0,
      pathsabove_write_address_count_phase_choice);
    pathsabove_memory_write_words_0_choice(0, 1) := choice((pathsabove_step(1) - pathsabove_stay(1)) < 0,
      pathsabove_step(1) mod 32, pathsabove_stay(1));
    pathsabove_memory_write_words_0_choice(0, 2) := choice((pathsabove_step(0) - pathsabove_stay(0)) < 0,
      pathsabove_step(0) mod 32, pathsabove_stay(0));
    pathsabove_memory_write_words_0_choice(0, 3) := choice((pathsabove_step(2) - pathsabove_stay(2)) < 0,
      pathsabove_step(2) mod 32, pathsabove_stay(2));
    pathsabove_memory_write_words_0_is_less(0) := (pathsabove_step(3) - pathsabove_stay(3)) < 0;
    pathsabove_memory_write_words_0_0_choice_4 := choice(pathsabove_memory_write_words_0_is_less(0),
      is_set(pathsabove_step(3), 0), is_set(pathsabove_stay(3), 0));
    pathsabove_memory_write_words_0_sum(0) := (pathsabove_memory_write_words_0_choice(0, 1) * 32) +
      pathsabove_memory_write_words_0_choice(0, 2) + (pathsabove_memory_write_words_0_choice(0, 3) * 1024) +
      (as_number(pathsabove_memory_write_words_0_0_choice_4) * 32768);
    pathsabove_memory_write_words_0_choice(1, 1) := choice((pathsabove_step(4) - pathsabove_stay(4)) < 0,
      pathsabove_step(4) mod 32, pathsabove_stay(4));
    pathsabove_memory_write_words_0_choice(1, 2) := choice(pathsabove_memory_write_words_0_is_less(0),
      pathsabove_step(3) mod 32, pathsabove_stay(3));
    pathsabove_memory_write_words_0_choice(1, 3) := choice((pathsabove_step(5) - pathsabove_stay(5)) < 0,
      pathsabove_step(5) mod 32, pathsabove_stay(5));
    pathsabove_memory_write_words_0_is_less(1) := (pathsabove_step(6) - pathsabove_stay(6)) < 0;
    pathsabove_memory_write_words_0_1_choice_4 := choice(pathsabove_memory_write_words_0_is_less(1), pathsabove_step(6)
      mod 4, pathsabove_stay(6) mod 4);
    pathsabove_memory_write_words_0_sum(1) := (pathsabove_memory_write_words_0_choice(1, 1) * 16) +
      (pathsabove_memory_write_words_0_choice(1, 2) / 2) + (pathsabove_memory_write_words_0_choice(1, 3) * 512) +
      (pathsabove_memory_write_words_0_1_choice_4 * 16384);
    pathsabove_memory_write_words_0_choice(2, 1) := choice(pathsabove_memory_write_words_0_is_less(1),
      pathsabove_step(6) mod 32, pathsabove_stay(6));
    pathsabove_memory_write_words_0_choice(2, 2) := choice((pathsabove_step(7) - pathsabove_stay(7)) < 0,
      pathsabove_step(7) mod 32, pathsabove_stay(7));
    pathsabove_memory_write_words_0_2_sum := (pathsabove_memory_write_words_0_choice(2, 1) / 4) +
      (pathsabove_memory_write_words_0_choice(2, 2) * 8);
    pathsabove_memory_write_words_0_all(0) := pathsabove_write_address_is_here and (pathsabove_write_address_address <
      4096);
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
    if line_comes(20) then pathsabove_smallest <= pathsabove_smallest_total; end if;
    -- pathsturn
    pathsturn_cost_memory_read_address_0_sum := pathsturn_read_address_address + as_number(((not
      is_set(pathsturn_read_address_count_phase, 2)) or (not is_set(pathsturn_read_address_count_phase, 1)) or (not
      is_set(pathsturn_read_address_count_phase, 0))));
    pathsturn_cost_memory_bank_choice := choice(line_starts_phases(16), line_places_address(1) * 8,
      pathsturn_cost_memory_read_address_0_sum mod 8192);
    pathsturn_read_address_count_phase_choice := choice(pathsturn_read_address_count_phase = 7, 7,
      (pathsturn_read_address_count_phase + 1) mod 8);
    pathsturn_write_address_count_phase_choice := choice(pathsturn_write_address_count_phase = 7, 7,
      (pathsturn_write_address_count_phase + 1) mod 8);
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
    for i in 0 to 2 loop
      pathsturn_sum_memory_ready_words(i) <= choice(pathsturn_sum_memory_held_bank, pathsturn_sum_memory_held_words(1,
        i), pathsturn_sum_memory_held_words(0, i));
    end loop;
    pathsturn_sum_memory_ready_words(3) <= choice(pathsturn_sum_memory_held_bank, pathsturn_sum_memory_held_words_3(1),
      pathsturn_sum_memory_held_words_3(0));
    pathsturn_cost_memory_read_address_0 <= choice(line_starts_phases(16), (line_places_address(1) mod 512) * 8,
      pathsturn_cost_memory_read_address_0_sum mod 4096);
    pathsturn_cost_memory_read_address_1 <= choice(line_starts_phases(16), (line_places_address(1) mod 128) * 8,
      pathsturn_cost_memory_read_address_0_sum mod 1024);
    pathsturn_read_address_count_phase <= choice(line_starts_phases(16), 0, pathsturn_read_address_count_phase_choice);
    pathsturn_cost_memory_ready_words(0) <= choice(pathsturn_cost_memory_held_bank,
      pathsturn_cost_memory_held_words_0(1), pathsturn_cost_memory_held_words_0(0));
    pathsturn_cost_memory_ready_words(1) <= choice(pathsturn_cost_memory_held_bank,
      pathsturn_cost_memory_held_words_1(1), pathsturn_cost_memory_held_words_1(0));
    pathsturn_write_smallest_address <= choice(line_starts_phases(19), line_places_address(2), 638);
    pathsturn_write_address_address <= choice(line_starts_phases(19), line_places_address(2) * 8,
      (pathsturn_write_address_address + as_number(((not is_set(pathsturn_write_address_count_phase, 2)) or (not
      is_set(pathsturn_write_address_count_phase, 1)) or (not is_set(pathsturn_write_address_count_phase, 0))))) mod
      8192);
    pathsturn_write_address_count_phase <= choice(line_starts_phases(19), 0,
      pathsturn_write_address_count_phase_choice);
    pathsturn_sum_memory_write_words_0_sum(0) := pathsleft_cost(2) + pathsabove_cost(2);
    pathsturn_sum_memory_write_words_0_sum_2(0) := (((pathsleft_cost(1) + pathsabove_cost(1)) mod 128) * 128) +
      ((pathsleft_cost(0) + pathsabove_cost(0)) mod 128) + ((pathsturn_sum_memory_write_words_0_sum(0) mod 4) * 16384);
    pathsturn_sum_memory_write_words_0_sum(1) := pathsleft_cost(4) + pathsabove_cost(4);
    pathsturn_sum_memory_write_words_0_sum_2(1) := (((pathsleft_cost(3) + pathsabove_cost(3)) mod 128) * 32) +
      ((pathsturn_sum_memory_write_words_0_sum(0) mod 128) / 4) + ((pathsturn_sum_memory_write_words_0_sum(1) mod 16) *
      4096);
    pathsturn_sum_memory_write_words_0_sum(2) := pathsleft_cost(6) + pathsabove_cost(6);
    pathsturn_sum_memory_write_words_0_sum_2(2) := (((pathsleft_cost(5) + pathsabove_cost(5)) mod 128) * 8) +
      ((pathsturn_sum_memory_write_words_0_sum(1) mod 128) / 16) + ((pathsturn_sum_memory_write_words_0_sum(2) mod 64)
      * 1024);
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
    pathsturn_cost_memory_write_words_0_all(0) := pathsturn_write_address_is_here and (pathsturn_write_address_address
      < 4096);
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
    if line_starts_phases(16) then pathsturn_smallest_address <= line_places_address(1); end if;
    -- pathsright
    if line_starts_phases(10) then
      pathsright_fresh_past_newest(0) <= relief_right(1);
      pathsright_fresh_past_newest(1) <= pathsright_fresh_past_newest(0);
    end if;
    if line_starts_phases(11) then
      pathsright_fresh_past_pairs(1 to 2) <= pathsright_fresh_past_pairs(0 to 1);
      pathsright_fresh_past_pairs(0) <= smaller(pathsright_fresh_past_newest(1), pathsright_fresh_past_newest(0));
    end if;
    if line_starts_phases(12) then
      pathsright_fresh_past_fours(1 to 6) <= pathsright_fresh_past_fours(0 to 5);
      pathsright_fresh_past_fours(0) <= smaller(pathsright_fresh_past_pairs(2), pathsright_fresh_past_pairs(0));
    end if;
    pathsright_stay_value(0, 1) := is_set(pathsright_fresh_here, 1);
    pathsright_stay_0_is_equal := (pathsright_fresh_here mod 4) = 0;
    pathsright_stay_value(0, 2) := is_set(pathsright_fresh_here, 2);
    pathsright_stay_value(0, 3) := is_set(pathsright_fresh_here, 3);
    pathsright_stay_value(0, 4) := is_set(pathsright_fresh_here, 4);
    pathsright_stay_value(0, 5) := is_set(pathsright_fresh_here, 5);
    pathsright_stay_choice(0, 7) := not is_larger(to_integer(pathsright_read_words(2)(6 downto 0)),
      pathsright_fresh_here, 0, 6, true);
    for i in 6 to 10 loop pathsright_stay_value(0, i) := pathsright_read_words(0)(i - 4) = '1'; end loop;
    pathsright_stay_choice(0, 14) := not is_larger(pathsright_fresh_here, to_integer(pathsright_read_words(0)(6 downto
      0)), 0, 6, false);
    pathsright_stay_choice(0, 15) := choice(pathsright_stay_choice(0, 7), not pathsleft_first, (not
      pathsright_stay_choice(0, 14)) and (not pathsleft_first));
    pathsright_stay_choice_16(0) := smaller(to_integer(pathsright_read_words(2)(6 downto 0)),
      to_integer(pathsright_read_words(0)(6 downto 0)));
    for i in 1 to 2 loop
      pathsright_stay_value(i, 1) := pathsright_read_words(2)(7 * i) = '1';
      pathsright_stay_choice(i, 7) := not is_larger(to_integer(pathsright_read_words(2)(7 * i + 6 downto 7 * i)),
        pathsright_fresh_here, 0, 6, true);
      pathsright_stay_value(i, 2) := pathsright_read_words(0)(7 * i) = '1';
      pathsright_stay_choice(i, 14) := not is_larger(to_integer(pathsright_read_words(0)(7 * i + 6 downto 7 * i)),
        pathsright_fresh_here, 0, 6, true);
      pathsright_stay_choice(i, 15) := choice(pathsright_stay_choice(i, 7), not pathsleft_first,
        pathsright_stay_choice(i, 14) and (not pathsleft_first));
      pathsright_stay_values(i, 3) := to_integer(pathsright_read_words(2)(7 * i + 6 downto 7 * i));
      pathsright_stay_values(i, 4) := to_integer(pathsright_read_words(0)(7 * i + 6 downto 7 * i));
      pathsright_stay_choice_16(i) := smaller(pathsright_stay_values(i, 3), pathsright_stay_values(i, 4));
    end loop;
    pathsright_stay_value(3, 1) := pathsright_read_words(2)(21) = '1';
    pathsright_stay_choice(3, 7) := not is_larger(to_integer(pathsright_read_words(2)(27 downto 21)),
      pathsright_fresh_here, 0, 6, true);
    pathsright_stay_value(3, 2) := pathsright_read_words(0)(21) = '1';
    pathsright_stay_choice(3, 14) := not is_larger(to_integer(pathsright_read_words(0)(27 downto 21)),
      pathsright_fresh_here, 0, 6, true);
    pathsright_stay_choice(3, 15) := choice(pathsright_stay_choice(3, 7), not pathsleft_first,
      pathsright_stay_choice(3, 14) and (not pathsleft_first));
    pathsright_stay_choice_16(3) := smaller(to_integer(pathsright_read_words(2)(27 downto 21)),
      to_integer(pathsright_read_words(0)(27 downto 21)));
    pathsright_stay_choice(4, 7) := not is_larger(to_integer(pathsright_read_words(3)(6 downto 0)),
      pathsright_fresh_here, 0, 6, true);
    pathsright_stay_choice(4, 14) := not is_larger(to_integer(pathsright_read_words(1)(6 downto 0)),
      pathsright_fresh_here, 0, 6, true);
    pathsright_stay_choice(4, 15) := choice(pathsright_stay_choice(4, 7), not pathsleft_first,
      pathsright_stay_choice(4, 14) and (not pathsleft_first));
    pathsright_stay_choice_16(4) := smaller(to_integer(pathsright_read_words(3)(6 downto 0)),
      to_integer(pathsright_read_words(1)(6 downto 0)));
    for i in 5 to 6 loop
      pathsright_stay_value(i, 1) := pathsright_read_words(3)(7 * i - 28) = '1';
      pathsright_stay_choice(i, 7) := not is_larger(to_integer(pathsright_read_words(3)(7 * i - 22 downto 7 * i - 28)),
        pathsright_fresh_here, 0, 6, true);
      pathsright_stay_value(i, 2) := pathsright_read_words(1)(7 * i - 28) = '1';
      pathsright_stay_choice(i, 14) := not is_larger(to_integer(pathsright_read_words(1)(7 * i - 22 downto 7 * i -
        28)), pathsright_fresh_here, 0, 6, true);
      pathsright_stay_choice(i, 15) := choice(pathsright_stay_choice(i, 7), not pathsleft_first,
        pathsright_stay_choice(i, 14) and (not pathsleft_first));
      pathsright_stay_values(i, 3) := to_integer(pathsright_read_words(3)(7 * i - 22 downto 7 * i - 28));
      pathsright_stay_values(i, 4) := to_integer(pathsright_read_words(1)(7 * i - 22 downto 7 * i - 28));
      pathsright_stay_choice_16(i) := smaller(pathsright_stay_values(i, 3), pathsright_stay_values(i, 4));
    end loop;
    pathsright_stay_value(7, 1) := pathsright_read_words(3)(21) = '1';
    pathsright_stay_choice(7, 7) := not is_larger(to_integer(pathsright_read_words(3)(27 downto 21)),
      pathsright_fresh_here, 0, 6, true);
    pathsright_stay_value(7, 2) := pathsright_read_words(1)(21) = '1';
    pathsright_stay_choice(7, 14) := not is_larger(to_integer(pathsright_read_words(1)(27 downto 21)),
      pathsright_fresh_here, 0, 6, true);
    pathsright_stay_choice(7, 15) := choice(pathsright_stay_choice(7, 7), not pathsleft_first,
      pathsright_stay_choice(7, 14) and (not pathsleft_first));
    pathsright_stay_choice_16(7) := smaller(to_integer(pathsright_read_words(3)(27 downto 21)),
      to_integer(pathsright_read_words(1)(27 downto 21)));
    pathsright_step_choice(0, 1) := choice(pathsleft_is_first, pathsright_stay_values(1, 4),
      pathsright_lower_neighbour);
    pathsright_step_choice(0, 2) := smaller(pathsright_stay_values(1, 4), pathsright_step_choice(0, 1));
    pathsright_step_choice(1, 1) := smaller(pathsright_stay_values(2, 4), to_integer(pathsright_read_words(0)(6 downto
      0)));
    pathsright_step_choice(2, 1) := smaller(to_integer(pathsright_read_words(0)(27 downto 21)),
      pathsright_stay_values(1, 4));
    pathsright_step_choice(3, 1) := smaller(to_integer(pathsright_read_words(1)(6 downto 0)), pathsright_stay_values(2,
      4));
    pathsright_step_choice(4, 1) := smaller(pathsright_stay_values(5, 4), to_integer(pathsright_read_words(0)(27 downto
      21)));
    pathsright_step_choice(5, 1) := smaller(pathsright_stay_values(6, 4), to_integer(pathsright_read_words(1)(6 downto
      0)));
    pathsright_step_choice(6, 1) := smaller(to_integer(pathsright_read_words(1)(27 downto 21)),
      pathsright_stay_values(5, 4));
    pathsright_step_choice(7, 1) := choice(pathsleft_is_last, pathsright_stay_values(6, 4),
      to_integer(pathsright_read_neighbour_0));
    pathsright_step_choice(7, 2) := smaller(pathsright_step_choice(7, 1), pathsright_stay_values(6, 4));
    pathsright_stay_change_value(1) := (pathsturn_cost_memory_ready_words(0) mod 64) / 8;
    pathsright_stay_change_value(2) := (pathsturn_cost_memory_ready_words(0) / 64) mod 8;
    pathsright_stay_change_value(3) := (pathsturn_cost_memory_ready_words(0) / 512) mod 8;
    pathsright_stay_change_value(4) := (pathsturn_cost_memory_ready_words(0) / 4096) mod 8;
    pathsright_stay_change_5_sum := ((pathsturn_cost_memory_ready_words(1) mod 4) * 2) +
      (pathsturn_cost_memory_ready_words(0) / 32768);
    pathsright_stay_change_value(6) := (pathsturn_cost_memory_ready_words(1) / 4) mod 8;
    pathsright_low_0_choice := choice(line_comes(25), 127, pathsright_low_0);
    pathsright_fresh_past_oldest <= pathsright_fresh_past_fours(6);
    pathsright_lost <= is_set(pathsright_fresh_known, 6);
    pathsright_short_of <= (((pathsright_fresh_known mod 64) + pathsright_room) / 64) = 1;
    pathsright_missing <= (pathsright_fresh_known + pathsright_room) mod 64;
    pathsright_below <= (0 - pathsright_fresh_known) mod 64;
    pathsright_lower_neighbour <= to_integer(pathsright_read_words(1)(27 downto 21));
    pathsright_stay_change(0) <= ((pathsturn_cost_memory_ready_words(0) mod 8) - pathsright_g) mod 128;
    pathsright_stay_change(1) <= (pathsright_stay_change_value(1) - pathsright_g) mod 128;
    pathsright_stay_change(2) <= (pathsright_stay_change_value(2) - pathsright_g) mod 128;
    pathsright_stay_change(3) <= (pathsright_stay_change_value(3) - pathsright_g) mod 128;
    pathsright_stay_change(4) <= (pathsright_stay_change_value(4) - pathsright_g) mod 128;
    pathsright_stay_change(5) <= (pathsright_stay_change_5_sum - pathsright_g) mod 128;
    pathsright_stay_change(6) <= (pathsright_stay_change_value(6) - pathsright_g) mod 128;
    pathsright_stay_change(7) <= ((pathsturn_cost_memory_ready_words(1) / 32) - pathsright_g) mod 128;
    pathsright_step_change(0) <= ((pathsturn_cost_memory_ready_words(0) mod 8) - pathsright_g_less) mod 128;
    pathsright_step_change(1) <= (pathsright_stay_change_value(1) - pathsright_g_less) mod 128;
    pathsright_step_change(2) <= (pathsright_stay_change_value(2) - pathsright_g_less) mod 128;
    pathsright_step_change(3) <= (pathsright_stay_change_value(3) - pathsright_g_less) mod 128;
    pathsright_step_change(4) <= (pathsright_stay_change_value(4) - pathsright_g_less) mod 128;
    pathsright_step_change(5) <= (pathsright_stay_change_5_sum - pathsright_g_less) mod 128;
    pathsright_step_change(6) <= (pathsright_stay_change_value(6) - pathsright_g_less) mod 128;
    pathsright_step_change(7) <= ((pathsturn_cost_memory_ready_words(1) / 32) - pathsright_g_less) mod 128;
    pathsright_fresh_past_eight <= smaller(pathsright_fresh_past_fours(4), pathsright_fresh_past_fours(0));
    pathsright_fresh_past_cheapest <= smaller(pathsright_fresh_past_oldest, pathsright_fresh_past_eight);
    pathsright_fresh_known <= smaller(pathsright_fresh_past_cheapest, to_integer(pathsright_lowest_0));
    for i in 0 to 7 loop
      pathsright_stay(i) <= choice(pathsright_stay_choice(i, 15), pathsright_stay_choice_16(i), pathsright_fresh_here);
    end loop;
    pathsright_step(0) <= choice(pathsleft_first, 64, pathsright_step_choice(0, 2));
    for i in 1 to 6 loop pathsright_step(i) <= choice(pathsleft_first, 64, pathsright_step_choice(i, 1)); end loop;
    pathsright_step(7) <= choice(pathsleft_first, 64, pathsright_step_choice(7, 2));
    pathsright_tree_smallest(0) <= smaller(pathsright_cost(1), pathsright_cost(0));
    pathsright_tree_smallest(1) <= smaller(pathsright_cost(3), pathsright_cost(2));
    pathsright_tree_smallest(2) <= smaller(pathsright_cost(5), pathsright_cost(4));
    pathsright_tree_smallest(3) <= smaller(pathsright_cost(7), pathsright_cost(6));
    pathsright_tree_next_smallest(0) <= smaller(pathsright_tree_smallest(1), pathsright_tree_smallest(0));
    pathsright_tree_next_smallest(1) <= smaller(pathsright_tree_smallest(3), pathsright_tree_smallest(2));
    pathsright_tree_next_next_smallest_0 <= smaller(pathsright_tree_next_smallest(1), pathsright_tree_next_smallest(0));
    pathsright_low_0 <= smaller(pathsright_tree_next_next_smallest_0, pathsright_low_0_choice);
    if line_starts_phases(19) then
      pathsright_fresh_here <= relief_right(2);
      pathsright_g <= pathsturn_ready_smallest_0 + pathsright_q_now;
      pathsright_g_less <= (pathsturn_ready_smallest_0 + pathsright_q_less) mod 128;
    end if;
    pathsright_q_choices(1) := choice(pathsright_short_of, pathsright_missing, 0);
    pathsright_q_choices(2) := choice(pathsright_lost, pathsright_room, pathsright_q_choices(1));
    pathsright_room_left_choice := choice(pathsright_short_of, pathsright_below, pathsright_room);
    if line_starts_phases(17) then
      pathsright_q <= choice(line_places_shown_first_column(2), 40, pathsright_q_choices(2));
      pathsright_room_left <= choice(pathsright_lost, 0, pathsright_room_left_choice);
    end if;
    if line_starts_phases(18) then
      pathsright_q_now <= pathsright_q;
      pathsright_q_less <= (pathsright_q + 119) mod 128;
      pathsright_room <= choice(line_places_shown_first_column(2), 0, (pathsright_room_left + pathsright_start_cost(8))
        mod 64);
      pathsright_start_cost(1) <= choice(line_places_shown_first_column(2), 0, pathsright_q_now);
      for i in 2 to 8 loop
        pathsright_start_cost(i) <= choice(line_places_shown_first_column(2), 0, pathsright_start_cost(i - 1));
      end loop;
    end if;
    if pathsleft_cost_0_any then
      for i in 0 to 7 loop pathsright_cost(i) <= (pathsright_stay(i) + pathsright_stay_change(i)) mod 128; end loop;
      for i in 0 to 7 loop pathsright_arrived(i) <= (pathsright_step(i) + pathsright_step_change(i)) mod 128; end loop;
    end if;
    -- winnersmask
    winnersmask_column_sum := winnersmask_column + 1;
    winnersmask_column_choice := choice(line_places_first_column(2), 0, winnersmask_column_sum mod 1024);
    if line_comes(21) then winnersmask_column <= winnersmask_column_choice; end if;
    winnersmask_partner_choice := choice(line_places_first_column(2), 0, winnersmask_column_sum);
    winnersmask_inside(0) <= (((((winnersmask_partner / 1024) + 63) mod 64) * 1024) + (winnersmask_partner mod 1024)) <
      638;
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
    winnersmask_partner <= choice(line_comes(21), (((winnersmask_partner_choice / 1024) + 1) * 1024) +
      winnersmask_column_choice, ((((winnersmask_partner / 8) + 1) mod 512) * 8) + (winnersmask_partner mod 8));
    -- winnerswinner1
    for i in 0 to 3 loop
      winnerswinner1_best_index_0_value(i, 1) := is_set(paths_sum(2 * i + 1), 1);
      for j in 2 to 7 loop winnerswinner1_best_index_0_value(i, j) := is_set(paths_sum(2 * i), j - 1); end loop;
      winnerswinner1_best_index_0_choice_8(i) := not is_larger(paths_sum(2 * i + 1), paths_sum(2 * i), 0, 7, true);
    end loop;
    winnerswinner1_held_0 <= paths_sum;
    winnerswinner1_best_index_0_0 <= winnerswinner1_best_index_0_choice_8(0);
    winnerswinner1_best_place_0_2 <= winnerswinner1_best_index_0_choice_8(2);
    winnerswinner1_best_late_cost_0 <= winnerswinner1_best_cost_0;
    winnerswinner1_best_but_first_0(0) <= winnerswinner1_held_0(1);
    winnerswinner1_best_but_first_0(1) <= winnerswinner1_held_0(3);
    winnerswinner1_best_but_first_0(2) <= winnerswinner1_held_0(5);
    winnerswinner1_best_but_first_0(3) <= winnerswinner1_held_0(7);
    winnerswinner1_best_but_last_0(0) <= winnerswinner1_held_0(0);
    winnerswinner1_best_but_last_0(1) <= winnerswinner1_held_0(2);
    winnerswinner1_best_but_last_0(2) <= winnerswinner1_held_0(4);
    winnerswinner1_best_but_last_0(3) <= winnerswinner1_held_0(6);
    winnerswinner1_best_cost_0(0) <= smaller(paths_sum(1), paths_sum(0));
    winnerswinner1_best_cost_0(1) <= smaller(paths_sum(3), paths_sum(2));
    winnerswinner1_best_cost_0(2) <= smaller(paths_sum(5), paths_sum(4));
    winnerswinner1_best_cost_0(3) <= smaller(paths_sum(7), paths_sum(6));
    for i in 1 to 3 loop
      winnerswinner1_best_index_0(i) <= choice(winnerswinner1_best_index_0_choice_8(i), 2 * i + 1, 2 * i);
      winnerswinner1_best_below_0(i) <= choice(winnerswinner1_best_index_0_choice_8(i), paths_sum(2 * i), 0);
      winnerswinner1_best_above_0(i) <= choice(winnerswinner1_best_index_0_choice_8(i), 0, paths_sum(2 * i + 1));
    end loop;
    winnerswinner1_best_below_0(0) <= choice(winnerswinner1_best_index_0_choice_8(0), paths_sum(0), 0);
    winnerswinner1_best_above_0(0) <= choice(winnerswinner1_best_index_0_choice_8(0), 0, paths_sum(1));
    -- winnerswinner2
    for i in 0 to 1 loop
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
    winnerswinner2_best_above_0_choice(0) := choice(winnerswinner1_best_index_0_0, winnerswinner1_held_0(2),
      winnerswinner1_best_above_0(0));
    winnerswinner2_best_above_0_choice(1) := choice(winnerswinner1_best_place_0_2, winnerswinner1_held_0(6),
      winnerswinner1_best_above_0(2));
    winnerswinner2_best_at_start_0_choice(0) := carry(winnerswinner2_best_index_0_choice(0, 7), not
      is_set(winnerswinner1_best_cost_0(0), 7), is_set(winnerswinner1_best_cost_0(1), 7));
    winnerswinner2_best_at_start_0_choice(1) := carry(winnerswinner2_best_index_0_choice(1, 7), not
      is_set(winnerswinner1_best_cost_0(2), 7), is_set(winnerswinner1_best_cost_0(3), 7));
    for i in 0 to 1 loop
      winnerswinner2_best_second_0_choice(i, 1) := choice(winnerswinner2_best_place_0(i), 255,
        winnerswinner1_best_late_cost_0(2 * i + 1));
      winnerswinner2_best_second_0_choice(i, 2) := choice(winnerswinner2_best_at_end_0(i),
        winnerswinner1_best_but_first_0(2 * i + 1), winnerswinner2_best_second_0_choice(i, 1));
      winnerswinner2_best_second_0_choice(i, 3) := choice(winnerswinner2_best_place_0(i),
        winnerswinner1_best_late_cost_0(2 * i), 255);
      winnerswinner2_best_second_0_choice(i, 4) := choice(winnerswinner2_best_at_start_0(i),
        winnerswinner1_best_but_last_0(2 * i), winnerswinner2_best_second_0_choice(i, 3));
    end loop;
    winnerswinner2_best_first_0(0) <= winnerswinner1_held_0(0);
    winnerswinner2_best_first_0(1) <= winnerswinner1_held_0(4);
    winnerswinner2_best_last_0(0) <= winnerswinner1_held_0(3);
    winnerswinner2_best_last_0(1) <= winnerswinner1_held_0(7);
    winnerswinner2_best_place_0(0) <= winnerswinner2_best_index_0_choice(0, 8);
    winnerswinner2_best_place_0(1) <= winnerswinner2_best_index_0_choice(1, 8);
    winnerswinner2_best_at_start_0(0) <= (not winnerswinner2_best_at_start_0_choice(0)) and
      winnerswinner2_best_below_0_is_equal(0);
    winnerswinner2_best_at_start_0(1) <= (not winnerswinner2_best_at_start_0_choice(1)) and
      winnerswinner2_best_below_0_is_equal(1);
    winnerswinner2_best_at_end_0(0) <= winnerswinner2_best_at_start_0_choice(0) and winnerswinner1_best_index_0_0;
    winnerswinner2_best_at_end_0(1) <= winnerswinner2_best_at_start_0_choice(1) and winnerswinner1_best_place_0_2;
    winnerswinner2_best_late_cost_0 <= winnerswinner2_best_cost_0;
    winnerswinner2_best_cost_0(0) <= smaller(winnerswinner1_best_cost_0(1), winnerswinner1_best_cost_0(0));
    winnerswinner2_best_cost_0(1) <= smaller(winnerswinner1_best_cost_0(3), winnerswinner1_best_cost_0(2));
    winnerswinner2_best_index_0(0) <= choice(winnerswinner2_best_index_0_choice(0, 8), winnerswinner1_best_index_0(1),
      as_number(winnerswinner1_best_index_0_0));
    winnerswinner2_best_below_0(0) <= choice(winnerswinner2_best_index_0_choice(0, 8),
      winnerswinner2_best_below_0_choice(0), winnerswinner1_best_below_0(0));
    winnerswinner2_best_above_0(0) <= choice(winnerswinner2_best_index_0_choice(0, 8), winnerswinner1_best_above_0(1),
      winnerswinner2_best_above_0_choice(0));
    winnerswinner2_best_index_0(1) <= choice(winnerswinner2_best_index_0_choice(1, 8), winnerswinner1_best_index_0(3),
      winnerswinner1_best_index_0(2));
    winnerswinner2_best_below_0(1) <= choice(winnerswinner2_best_index_0_choice(1, 8),
      winnerswinner2_best_below_0_choice(1), winnerswinner1_best_below_0(2));
    winnerswinner2_best_above_0(1) <= choice(winnerswinner2_best_index_0_choice(1, 8), winnerswinner1_best_above_0(3),
      winnerswinner2_best_above_0_choice(1));
    winnerswinner2_best_second_0(0) <= smaller(winnerswinner2_best_second_0_choice(0, 2),
      winnerswinner2_best_second_0_choice(0, 4));
    winnerswinner2_best_second_0(1) <= smaller(winnerswinner2_best_second_0_choice(1, 2),
      winnerswinner2_best_second_0_choice(1, 4));
    winnerswinner2_best_but_first_0(0) <= smaller(winnerswinner1_best_late_cost_0(1),
      winnerswinner1_best_but_first_0(0));
    winnerswinner2_best_but_first_0(1) <= smaller(winnerswinner1_best_late_cost_0(3),
      winnerswinner1_best_but_first_0(2));
    winnerswinner2_best_but_last_0(0) <= smaller(winnerswinner1_best_but_last_0(1), winnerswinner1_best_late_cost_0(0));
    winnerswinner2_best_but_last_0(1) <= smaller(winnerswinner1_best_but_last_0(3), winnerswinner1_best_late_cost_0(2));
    -- winnerswinner3
    for i in 1 to 5 loop
      winnerswinner3_best_index_0_0_values(i) := is_set(winnerswinner2_best_cost_0(1), i + 1);
    end loop;
    winnerswinner3_best_index_0_0_choice(7) := not is_larger(winnerswinner2_best_cost_0(0),
      winnerswinner2_best_cost_0(1), 0, 6, false);
    winnerswinner3_best_index_0_0_choice(8) := inverted_carry(winnerswinner3_best_index_0_0_choice(7),
      is_set(winnerswinner2_best_cost_0(0), 7), not is_set(winnerswinner2_best_cost_0(1), 7));
    winnerswinner3_best_below_0_0_is_equal := winnerswinner2_best_index_0(1) = 4;
    winnerswinner3_best_below_0_0_choice := choice(winnerswinner3_best_below_0_0_is_equal,
      winnerswinner2_best_last_0(0), winnerswinner2_best_below_0(1));
    winnerswinner3_best_above_0_0_is_equal := winnerswinner2_best_index_0(0) = 3;
    winnerswinner3_best_above_0_0_choice := choice(winnerswinner3_best_above_0_0_is_equal,
      winnerswinner2_best_first_0(1), winnerswinner2_best_above_0(0));
    winnerswinner3_best_at_start_0_0_choice := carry(winnerswinner3_best_index_0_0_choice(7), not
      is_set(winnerswinner2_best_cost_0(0), 7), is_set(winnerswinner2_best_cost_0(1), 7));
    winnerswinner3_best_second_0_0_choices(1) := choice(winnerswinner3_best_place_0_0, winnerswinner2_best_second_0(1),
      winnerswinner2_best_late_cost_0(1));
    winnerswinner3_best_second_0_0_choices(2) := choice(winnerswinner3_best_at_end_0_0,
      winnerswinner2_best_but_first_0(1), winnerswinner3_best_second_0_0_choices(1));
    winnerswinner3_best_second_0_0_choices(3) := choice(winnerswinner3_best_place_0_0,
      winnerswinner2_best_late_cost_0(0), winnerswinner2_best_second_0(0));
    winnerswinner3_best_second_0_0_choices(4) := choice(winnerswinner3_best_at_start_0_0,
      winnerswinner2_best_but_last_0(0), winnerswinner3_best_second_0_0_choices(3));
    winnerswinner3_best_first_0_0 <= winnerswinner2_best_first_0(0);
    winnerswinner3_best_last_0_0 <= winnerswinner2_best_last_0(1);
    winnerswinner3_best_place_0_0 <= winnerswinner3_best_index_0_0_choice(8);
    winnerswinner3_best_at_start_0_0 <= (not winnerswinner3_best_at_start_0_0_choice) and
      winnerswinner3_best_below_0_0_is_equal;
    winnerswinner3_best_at_end_0_0 <= winnerswinner3_best_at_start_0_0_choice and
      winnerswinner3_best_above_0_0_is_equal;
    winnerswinner3_best_late_cost_0_0 <= winnerswinner3_best_cost_0_0;
    winnerswinner3_best_cost_0_0 <= smaller(winnerswinner2_best_cost_0(1), winnerswinner2_best_cost_0(0));
    winnerswinner3_best_index_0_0 <= choice(winnerswinner3_best_index_0_0_choice(8), winnerswinner2_best_index_0(1),
      winnerswinner2_best_index_0(0));
    winnerswinner3_best_below_0_0 <= choice(winnerswinner3_best_index_0_0_choice(8),
      winnerswinner3_best_below_0_0_choice, winnerswinner2_best_below_0(0));
    winnerswinner3_best_above_0_0 <= choice(winnerswinner3_best_index_0_0_choice(8), winnerswinner2_best_above_0(1),
      winnerswinner3_best_above_0_0_choice);
    winnerswinner3_best_second_0_0 <= smaller(winnerswinner3_best_second_0_0_choices(2),
      winnerswinner3_best_second_0_0_choices(4));
    winnerswinner3_best_but_first_0_0 <= smaller(winnerswinner2_best_late_cost_0(1),
      winnerswinner2_best_but_first_0(0));
    winnerswinner3_best_but_last_0_0 <= smaller(winnerswinner2_best_but_last_0(1), winnerswinner2_best_late_cost_0(0));
    -- winners
    winners_best_cost_0_0_choice := choice(line_comes(26), 511, winners_best_cost_0_0);
    winners_best_cost_0_0_choice_2 := choice(line_comes(26), 255, winners_best_cost_0_0);
    winners_best_index_0_0_is_less := (winnerswinner3_best_cost_0_0 - winners_best_cost_0_0_choice) < 0;
    winners_best_index_0_0_choice := choice(winners_best_index_0_0_is_less, winnerswinner3_best_index_0_0 + 56,
      ((((winners_best_index_0_0 / 8) + 31) mod 32) * 8) + (winners_best_index_0_0 mod 8));
    winners_best_below_0_0_is_equal := winnerswinner3_best_index_0_0 = 0;
    winners_best_below_0_0_choices(1) := choice((not line_comes(26)) and winners_best_below_0_0_is_equal,
      winners_best_last_0_0, winnerswinner3_best_below_0_0);
    winners_best_below_0_0_choices(2) := choice(line_comes(26), 0, winners_best_below_0_0);
    winners_best_above_0_0_is_equal := winners_best_index_0_0 = 63;
    winners_best_above_0_0_choices(1) := choice(line_comes(26), 0, winners_best_above_0_0);
    winners_best_above_0_0_choices(2) := choice(winners_best_above_0_0_is_equal, winnerswinner3_best_first_0_0,
      winners_best_above_0_0_choices(1));
    winners_best_second_0_0_choices(1) := choice(winners_best_place_0_0, winnerswinner3_best_second_0_0,
      winnerswinner3_best_late_cost_0_0);
    winners_best_second_0_0_choices(2) := choice(winners_best_at_end_0_0, winnerswinner3_best_but_first_0_0,
      winners_best_second_0_0_choices(1));
    winners_best_second_0_0_choices(3) := choice(line_comes(27), 255, winners_best_but_last_0_0);
    winners_best_second_0_0_choices(4) := choice(line_comes(27), 255, winners_best_late_cost_0_0);
    winners_best_second_0_0_choices(5) := choice(line_comes(27), 255, winners_best_second_0_0);
    winners_best_second_0_0_choices(6) := choice(winners_best_place_0_0, winners_best_second_0_0_choices(4),
      winners_best_second_0_0_choices(5));
    winners_best_second_0_0_choices(7) := choice(winners_best_at_start_0_0, winners_best_second_0_0_choices(3),
      winners_best_second_0_0_choices(6));
    winners_partner_at_sum := winners_partner_column + 1;
    winners_partner_at_choice := choice(line_places_first_column(4), 0, winners_partner_at_sum);
    winners_best_index_0_0 <= winners_best_index_0_0_choice;
    winners_best_last_0_0 <= winnerswinner3_best_last_0_0;
    winners_best_place_0_0 <= winners_best_index_0_0_is_less;
    winners_best_at_start_0_0 <= (not line_comes(26)) and winners_best_below_0_0_is_equal and
      winners_best_index_0_0_is_less;
    winners_best_at_end_0_0 <= winners_best_above_0_0_is_equal and ((winnerswinner3_best_cost_0_0 -
      winners_best_cost_0_0_choice) >= 0);
    winners_best_late_cost_0_0 <= winners_best_cost_0_0;
    winners_best_tag.valid <= line_comes(33);
    winners_best_tag.map_column <= line_places_map_column(4);
    winners_best_tag.output_column <= line_places_shown_output_column(4);
    winners_best_tag.start_of_frame <= line_places_shown_start_of_frame(4);
    winners_best_tag.end_of_line <= line_places_shown_end_of_line(4);
    winners_partner_at <= winners_partner_at_choice + winners_best_index_0_0_choice;
    winners_best_cost_0_0 <= choice((winners_best_cost_0_0_choice - winnerswinner3_best_cost_0_0) < 0,
      winners_best_cost_0_0_choice_2, winnerswinner3_best_cost_0_0);
    winners_best_below_0_0 <= choice(winners_best_index_0_0_is_less, winners_best_below_0_0_choices(1),
      winners_best_below_0_0_choices(2));
    winners_best_above_0_0 <= choice(winners_best_index_0_0_is_less, winnerswinner3_best_above_0_0,
      winners_best_above_0_0_choices(2));
    winners_best_second_0_0 <= smaller(winners_best_second_0_0_choices(2), winners_best_second_0_0_choices(7));
    winners_best_but_last_0_0 <= smaller(winnerswinner3_best_but_last_0_0, winners_best_second_0_0_choices(4));
    if line_comes(33) then
      winners_partner_column <= choice(line_places_first_column(4), 0, winners_partner_at_sum mod 1024);
    end if;
    -- other
    other_read_count_phase_choice := choice(other_read_count_phase = 7, 7, (other_read_count_phase + 1) mod 8);
    other_count_phase_choice := choice(other_count_phase = 7, 7, (other_count_phase + 1) mod 8);
    other_base_choice := choice(line_comes(22), 0, ((other_base / 8) + 1) mod 32);
    other_write_count_phase_choice := choice(other_write_count_phase = 7, 7, (other_write_count_phase + 1) mod 8);
    other_0_is_equal := fill_ready_column = 0;
    other_4_difference := 0 - (refinement_quotient_8_0 / 16);
    other_4_value := (refinement_quotient_8_0 + 15) / 16;
    other_choice(4) := choice(refinement_negative_0(8), other_4_difference mod 256, other_4_value);
    other_4_choice_2 := choice(refinement_negative_0(8), other_4_difference mod 8, other_4_value mod 8);
    for i in 5 to 10 loop
      other_difference(i) := ((refinement_remainder_0(11 - i) * 2) + 512) - refinement_divisor_0(11 - i);
    end loop;
    other_11_difference := (refinement_remainder_0(0) + 512) - refinement_divisor_0(0);
    other_12_any := line_comes(23) or (not is_set(other_write_count_phase, 2)) or (not is_set(other_write_count_phase,
      1)) or (not is_set(other_write_count_phase, 0));
    for i in 1 to 5 loop other_value(12, i) := other_words(1)(i + 17) = '1'; end loop;
    other_choices_from_12(12, 7) := not is_larger(paths_sum(5), to_integer(other_words(1)(22 downto 16)), 0, 6, false);
    other_choices_from_12(12, 8) := choice(is_set(paths_sum(5), 7), not other_first_column, (not (other_words(1)(23) =
      '1')) and (not other_first_column));
    other_choices_from_12(12, 9) := choice(other_choices_from_12(12, 7), is_set(paths_sum(5), 7) and (not
      (other_words(1)(23) = '1')) and (not other_first_column), other_choices_from_12(12, 8));
    other_all(12, 1) := (not other_choices_from_12(12, 9)) and winnersmask_inside(5) and other_output_column;
    other_12_value_6 := (other_base / 8) * 8;
    for i in 1 to 2 loop
      other_choices(12, 11 * i - 1) := choice(other_all(12, i), other_12_value_6 + (6 - i),
        to_integer(other_words(3)(31 - 8 * i downto 24 - 8 * i)));
      other_choices(12, 11 * i) := choice(other_12_any, other_choices(12, 11 * i - 1), to_integer(other(12)(23 - 8 * i
        downto 16 - 8 * i)));
      for j in 2 to 6 loop other_value(12, 5 * i + j) := other_words(1)(16 * i + j - 8) = '1'; end loop;
      other_choices_from_12(12, 11 * i + 7) := not is_larger(paths_sum(2 * i + 2), to_integer(other_words(1)(16 * i - 2
        downto 16 * i - 8)), 0, 6, false);
      other_choices_from_12(12, 11 * i + 8) := choice(is_set(paths_sum(2 * i + 2), 7), not other_first_column, (not
        (other_words(1)(16 * i - 1) = '1')) and (not other_first_column));
      other_choices_from_12(12, 11 * i + 9) := choice(other_choices_from_12(12, 11 * i + 7), is_set(paths_sum(2 * i +
        2), 7) and (not (other_words(1)(16 * i - 1) = '1')) and (not other_first_column), other_choices_from_12(12, 11
        * i + 8));
      other_all(12, i + 1) := (not other_choices_from_12(12, 11 * i + 9)) and winnersmask_inside(2 * i + 2) and
        other_output_column;
    end loop;
    other_choices(12, 32) := choice(other_all(12, 3), other_12_value_6 + 6, to_integer(other_words(3)(31 downto 24)));
    other_choices(12, 33) := choice(other_12_any, other_choices(12, 32), to_integer(other(12)(23 downto 16)));
    for i in 17 to 21 loop other_value(12, i) := other_next_words(0)(i - 15) = '1'; end loop;
    other_choices_from_12(12, 40) := not is_larger(paths_sum(7), to_integer(other_next_words(0)(6 downto 0)), 0, 6,
      false);
    other_12_differs := other_count_phase /= 7;
    other_choices_from_12(12, 41) := choice(other_choices_from_12(12, 40), other_12_differs and is_set(paths_sum(7), 7)
      and (not (other_next_words(0)(7) = '1')), other_12_differs and (is_set(paths_sum(7), 7) or (not
      (other_next_words(0)(7) = '1'))));
    other_choices_from_12(12, 42) := choice(other_choices_from_12(12, 41), winnersmask_inside(7) and
      other_output_column and other_first_column, winnersmask_inside(7) and other_output_column);
    other_choices(12, 43) := choice(other_choices_from_12(12, 42), other_12_value_6 + 7,
      to_integer(other_next_words(2)(7 downto 0)));
    other_choices(12, 44) := choice(other_12_any, other_choices(12, 43), to_integer(other(12)(31 downto 24)));
    for i in 1 to 5 loop other_value(13, i) := other_words(0)(i + 17) = '1'; end loop;
    other_choices_from_12(13, 7) := not is_larger(paths_sum(1), to_integer(other_words(0)(22 downto 16)), 0, 6, false);
    other_choices_from_12(13, 8) := choice(is_set(paths_sum(1), 7), not other_first_column, (not (other_words(0)(23) =
      '1')) and (not other_first_column));
    other_choices_from_12(13, 9) := choice(other_choices_from_12(13, 7), is_set(paths_sum(1), 7) and (not
      (other_words(0)(23) = '1')) and (not other_first_column), other_choices_from_12(13, 8));
    other_all(13, 1) := (not other_choices_from_12(13, 9)) and winnersmask_inside(1) and other_output_column;
    other_choices(13, 10) := choice(other_all(13, 1), other_12_value_6 + 1, to_integer(other_words(2)(23 downto 16)));
    other_choices(13, 11) := choice(other_12_any, other_choices(13, 10), to_integer(other(13)(15 downto 8)));
    for i in 6 to 10 loop other_value(13, i) := other_words(0)(i + 4) = '1'; end loop;
    other_choices_from_12(13, 18) := not is_larger(paths_sum(0), to_integer(other_words(0)(14 downto 8)), 0, 6, false);
    other_choices_from_12(13, 19) := choice(other_choices_from_12(13, 18), (not other_first_column) and
      is_set(paths_sum(0), 7) and (not (other_words(0)(15) = '1')), (not other_first_column) and (is_set(paths_sum(0),
      7) or (not (other_words(0)(15) = '1'))));
    other_all(13, 2) := (not other_choices_from_12(13, 19)) and winnersmask_inside(0) and other_output_column;
    other_choices(13, 20) := choice(other_all(13, 2), other_base, to_integer(other_words(2)(15 downto 8)));
    for i in 0 to 1 loop
      other_choices(13, 11 * i + 21) := choice(other_12_any, other_choices(13, 11 * i + 20), to_integer(other(13)(16 *
        i + 7 downto 16 * i)));
      for j in 11 to 15 loop other_value(13, 5 * i + j) := other_words(i)(j + 15 - 24 * i) = '1'; end loop;
      other_choices_from_12(13, 11 * i + 28) := not is_larger(paths_sum(i + 2), to_integer(other_words(i)(30 - 24 * i
        downto 24 - 24 * i)), 0, 6, false);
      other_choices_from_12(13, 11 * i + 29) := choice(is_set(paths_sum(i + 2), 7), not other_first_column, (not
        (other_words(i)(31 - 24 * i) = '1')) and (not other_first_column));
      other_choices_from_12(13, 11 * i + 30) := choice(other_choices_from_12(13, 11 * i + 28), is_set(paths_sum(i + 2),
        7) and (not (other_words(i)(31 - 24 * i) = '1')) and (not other_first_column), other_choices_from_12(13, 11 * i
        + 29));
      other_all(13, i + 3) := (not other_choices_from_12(13, 11 * i + 30)) and winnersmask_inside(i + 2) and
        other_output_column;
      other_choices(13, 11 * i + 31) := choice(other_all(13, i + 3), other_12_value_6 + (i + 2),
        to_integer(other_words(i + 2)(31 - 24 * i downto 24 - 24 * i)));
    end loop;
    other_choices(13, 43) := choice(other_12_any, other_choices(13, 42), to_integer(other(13)(31 downto 24)));
    other_choice(14) := choice(other_all(12, 1), paths_sum(5), to_integer(other_words(1)(23 downto 16)));
    other_choices(14, 2) := choice(other_12_any, other_choice(14), to_integer(other(14)(15 downto 8)));
    for i in 2 to 3 loop
      other_choices(14, 2 * i - 1) := choice(other_all(12, i), paths_sum(2 * i), to_integer(other_words(1)(16 * i - 17
        downto 16 * i - 24)));
      other_choices(14, 2 * i) := choice(other_12_any, other_choices(14, 2 * i - 1), to_integer(other(14)(16 * i - 25
        downto 16 * i - 32)));
    end loop;
    other_choices(14, 7) := choice(other_choices_from_12(12, 42), paths_sum(7), to_integer(other_next_words(0)(7 downto
      0)));
    other_choices(14, 8) := choice(other_12_any, other_choices(14, 7), to_integer(other(14)(31 downto 24)));
    other_choice(15) := choice(other_all(13, 1), paths_sum(1), to_integer(other_words(0)(23 downto 16)));
    other_choices(15, 2) := choice(other_12_any, other_choice(15), to_integer(other(15)(15 downto 8)));
    for i in 2 to 3 loop
      other_choices(15, 2 * i - 1) := choice(other_all(13, i), paths_sum(2 * i - 4), to_integer(other_words(0)(16 * i -
        17 downto 16 * i - 24)));
      other_choices(15, 2 * i) := choice(other_12_any, other_choices(15, 2 * i - 1), to_integer(other(15)(16 * i - 25
        downto 16 * i - 32)));
    end loop;
    other_choices(15, 7) := choice(other_all(13, 4), paths_sum(3), to_integer(other_words(1)(7 downto 0)));
    other_choices(15, 8) := choice(other_12_any, other_choices(15, 7), to_integer(other(15)(31 downto 24)));
    other_words <= other_next_words;
    other_base <= other_base_choice * 8;
    other_0 <= other_0_is_equal;
    other_1 <= ((median_rows_ready_words_0 mod 8192) / 2) * 2;
    other_2 <= support_centre_rest_0(2) mod 16;
    other_3 <= support_centre_0(2) mod 64;
    other_4 <= ((((other_choice(4) / 8) + 1) mod 4) * 8) + other_4_choice_2;
    other_5 <= ((other_difference(5) / 512) * 2) + ((other_6 / 4) * 4);
    other_6 <= ((other_difference(6) / 512) * 4) + ((other_7 / 8) * 8);
    other_7 <= ((other_difference(7) / 512) * 8) + ((other_8 / 16) * 16);
    other_8 <= ((other_difference(8) / 512) * 16) + ((other_9 / 32) * 32);
    other_9 <= ((other_difference(9) / 512) * 32) + ((other_10 / 64) * 64);
    other_10 <= ((other_difference(10) / 512) * 64) + ((other_11 / 128) * 128);
    other_11 <= (other_11_difference / 512) * 128;
    for i in 0 to 1 loop
      other(2 * i + 12) <= to_unsigned(other_choices(2 * i + 12, 44 - 36 * i), 8) & to_unsigned(other_choices(2 * i +
        12, 33 - 27 * i), 8) & to_unsigned(other_choices(2 * i + 12, 11 - 9 * i), 8) & to_unsigned(other_choices(2 * i
        + 12, 22 - 18 * i), 8);
      other(2 * i + 13) <= to_unsigned(other_choices(2 * i + 13, 43 - 35 * i), 8) & to_unsigned(other_choices(2 * i +
        13, 32 - 26 * i), 8) & to_unsigned(other_choices(2 * i + 13, 11 - 9 * i), 8) & to_unsigned(other_choices(2 * i
        + 13, 21 - 17 * i), 8);
    end loop;
    other_read_count_phase <= choice(line_comes(20), 0, other_read_count_phase_choice);
    other_count_phase <= choice(line_comes(22), 0, other_count_phase_choice);
    other_write_count_phase <= choice(line_comes(23), 0, other_write_count_phase_choice);
    if line_comes(22) then
      other_first_column <= line_places_first_column(2);
      other_output_column <= line_places_shown_output_column(2);
    end if;
    if other_write_count_phase = 0 then other_left <= to_integer(other(13)(7 downto 0)); end if;
    -- refinement
    refinement_below_0_differs := winners_best_index_0_0 /= 0;
    refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
    refinement_divisor_0_0_choice := choice(refinement_divisor_0_0_is_less, refinement_v_0, refinement_u_0);
    refinement_disparity_0(0) <= winners_best_index_0_0;
    refinement_disparity_0(1 to 11) <= refinement_disparity_0(0 to 10);
    refinement_passed_0(0) <= winners_partner_at < 638;
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
    refinement_scaled_cost <= median_read_bottom;
    refinement_margin_0(1 to 9) <= refinement_margin_0(0 to 8);
    refinement_u_0 <= (refinement_below_0 - winners_best_late_cost_0_0) mod 256;
    refinement_v_0 <= (refinement_above_0 - winners_best_late_cost_0_0) mod 256;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 8)) or
      (to_unsigned(as_number(((refinement_v_0 = 0) and (refinement_u_0 = 0))), 8))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((refinement_remainder_0(7) * 2) + 512) - refinement_divisor_0(7)) / 512) + ((other_5
      / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_margin_0(0) <= choice((not refinement_alone_0_0) and ((refinement_gap_0 / 64) = 0), refinement_gap_0 mod
      64, 63);
    refinement_below_0 <= choice(refinement_below_0_differs, winners_best_below_0_0, winners_best_above_0_0);
    refinement_above_0 <= choice(refinement_below_0_differs and winners_best_above_0_0_is_equal,
      winners_best_below_0_0, winners_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(other_11_difference, 9), other_11_difference mod 256,
      refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(other_difference(12 - i), 9), other_difference(12 - i) mod 256,
        (refinement_remainder_0(i - 1) mod 128) * 2);
    end loop;
    if in_valid then
      refinement_scaled_gap <= choice(in_start_of_frame, transform_counter_next_frame, transform_counter_frame_joins);
    end if;
    -- leftright
    leftright_holds_winners_choice := choice((not is_set(leftright_ring_read_address, 5)) and
      ((leftright_ring_read_address mod 8) = 0), (not leftright_holds_winners) and (is_set(leftright_ring_read_address,
      4) or is_set(leftright_ring_read_address, 3)), not leftright_holds_winners);
    leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
    leftright_other_0(0) <= other_left;
    leftright_other_0(1 to 14) <= leftright_other_0(0 to 13);
    leftright_position <= (leftright_position + as_number(refinement_tag_valid(11))) mod 128;
    leftright_held_position <= leftright_position;
    leftright_held_valid <= (not leftright_holds_winners_choice) and refinement_tag_valid(11);
    leftright_address_0 <= (to_integer(leftright_held_0(17 downto 4)) + leftright_held_position + 65) mod 128;
    leftright_asking_disparity_0 <= to_integer(leftright_held_0(11 downto 4));
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
    turn_order_address_choice := choice(turn_order_falls, 1023, 1);
    turn_order_address_choice_2 := choice(turn_order_falls, 0, 637);
    turn_order_address_anys(2) := (not leftright_checked_tag.map_column) or (not leftright_checked_tag.valid);
    if not turn_order_address_anys(2) then
      turn_order_address <= choice(turn_order_address_anys(1), (turn_order_address_choice + turn_order_address) mod
        1024, turn_order_address_choice_2);
    end if;
    turn_order_falls_all := (not turn_order_inside) and leftright_checked_tag.map_column and
      leftright_checked_tag.valid;
    turn_order_complete_all := leftright_checked_tag.map_column and leftright_checked_tag.valid;
    turn_ready_tag_row_start_differs := support_counter_group /= 482;
    turn_ready_tag_row_start_is_equals(1) := support_counter_column = 637;
    turn_ready_tag_row_start_choices(1) := choice(turn_ready_tag_row_start_is_equals(1), (support_counter_group /= 481)
      and turn_ready_tag.row_start, turn_ready_tag.row_start);
    turn_ready_tag_row_start_choices(2) := choice(turn_ready_tag_row_start_differs,
      turn_ready_tag_row_start_choices(1), turn_ready_tag.row_start);
    turn_ready_tag_row_start_is_equals(2) := support_counter_group = 479;
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
    turn_write_place <= choice(turn_comes, turn_order_address, 638);
    turn_ready_tag.row_start <= choice(turn_ready_tag_row_start_choices(3), turn_ready_tag.row_start or
      turn_ready_tag_row_start_alls(2), turn_ready_tag.row_start and ((not turn_ready_tag.map_column) or (not
      turn_ready_tag.valid)));
    if leftright_checked_tag.valid then turn_order_inside <= leftright_checked_tag.map_column; end if;
    if turn_order_falls_all then
      turn_order_output <= leftright_checked_tag.output_column;
      turn_order_first <= leftright_checked_tag.start_of_frame;
    end if;
    if turn_comes then turn_write_words_0 <= turn_newest; end if;
    -- support
    if turn_ready_tag_row_start_alls(2) then
      support_counter_column <= choice(turn_ready_tag.start_of_frame or turn_ready_tag_row_start_is_equals(1), 0,
        (support_counter_column + 1) mod 1024);
    end if;
    support_counter_group_choice := choice(turn_ready_tag_row_start_alls(1), 15, 0);
    support_counter_group_choices(2) := choice((support_counter_group = 481) and turn_ready_tag.row_start, 2,
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
    support_out_tag_row_start_differs := fill_counter_group /= 481;
    support_out_tag_row_start_is_equals(1) := fill_counter_column = 637;
    support_out_tag_row_start_choices(1) := choice(support_out_tag_row_start_is_equals(1), (fill_counter_group /= 480)
      and support_out_tag.row_start, support_out_tag.row_start);
    support_out_tag_row_start_choices(2) := choice(support_out_tag_row_start_differs,
      support_out_tag_row_start_choices(1), support_out_tag.row_start);
    support_out_tag_row_start_is_equals(2) := fill_counter_group = 479;
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
      turn_ready_tag.valid, support_counter_group_choice * 32, support_counter_group_choices(3));
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
        (fill_counter_column + 1) mod 1024);
    end if;
    fill_counter_group_choice := choice(support_out_tag_row_start_alls(1), 15, 0);
    fill_counter_group_choices(2) := choice((fill_counter_group = 480) and support_out_tag.row_start, 1,
      (fill_counter_group + 1) mod 512);
    fill_counter_group_choices(3) := choice(support_out_tag_row_start_differs and
      support_out_tag_row_start_is_equals(1) and support_out_tag.map_column and support_out_tag.valid,
      fill_counter_group_choices(2), fill_counter_group);
    fill_ends_read_place_0_choice := choice(other_0, fill_at_arrives and (not fill_pixel_0_passed), fill_at_arrives and
      (not fill_pixel_0_passed) and (not fill_in_hole_0));
    fill_ends_read_place_0_choices(2) := choice(fill_ends_read_place_0 = 322, 0, (fill_ends_read_place_0 + 1) mod 512);
    fill_ends_read_place_0_choices(3) := choice(fill_ends_read_place_0_choice, fill_ends_read_place_0_choices(2),
      fill_ends_read_place_0);
    fill_takes_left_0_choice := choice((fill_step_0 - fill_width_0) < 0, ((fill_width_0 - fill_step_0) mod 1024) / 2,
      0);
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
    fill_out_tag_row_start_differs := median_counter_group /= 481;
    fill_out_tag_row_start_is_equals(1) := median_counter_column = 637;
    fill_out_tag_row_start_choices(1) := choice(fill_out_tag_row_start_is_equals(1), (median_counter_group /= 480) and
      fill_out_tag.row_start, fill_out_tag.row_start);
    fill_out_tag_row_start_choices(2) := choice(fill_out_tag_row_start_differs, fill_out_tag_row_start_choices(1),
      fill_out_tag.row_start);
    fill_out_tag_row_start_is_equals(2) := median_counter_group = 479;
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
      support_out_tag.valid, fill_counter_group_choice * 32, fill_counter_group_choices(3));
    fill_ends_open_0 <= choice(fill_newest_passed_0, fill_ends_open_0 and (not fill_arrives), fill_ends_open_0 or
      fill_arrives);
    fill_ends_read_place_0 <= choice(other_0_is_equal and fill_ready_arrives, fill_ends_row_above_place_0,
      fill_ends_read_place_0_choices(3));
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
      fill_ends_next_place_0 <= choice(fill_ends_next_place_0 = 322, 0, (fill_ends_next_place_0 + 1) mod 512);
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
      fill_beside_0_has_right <= is_set(fill_ends_ready_words_0, 20);
      fill_beside_0_right_column <= (fill_ends_ready_words_0 / 1024) mod 1024;
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
        (median_counter_column + 1) mod 1024);
    end if;
    median_counter_group_choice := choice(fill_out_tag_row_start_alls(1), 15, 0);
    median_counter_group_is_equal := median_counter_group = 480;
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
    median_counter_next_frame <= refinement_scaled_cost;
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
      median_counter_group_choice * 32, median_counter_group_choices(3));
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
    relief_newest_choice(7) := not is_larger(relief_centre_grey(1), relief_before, 0, 6, false);
    relief_newest_choice(8) := carry(relief_newest_choice(7), not is_set(relief_centre_grey(1), 7),
      is_set(relief_before, 7));
    relief_newest_values_from_6(6) := (relief_before - relief_centre_grey(1)) mod 256;
    relief_newest_values_from_6(7) := (relief_centre_grey(1) - relief_before) mod 256;
    for i in 5 to 6 loop
      relief_newest_choice(3 * i - 6) := choice(relief_newest_choice(8), is_set(relief_newest_values_from_6(6), 2 * i -
        8), is_set(relief_newest_values_from_6(7), 2 * i - 8));
      relief_newest_choice(3 * i - 5) := choice(relief_newest_choice(8), not is_set(relief_newest_values_from_6(6), 4 *
        i - 17), not is_set(relief_newest_values_from_6(7), 4 * i - 17));
      relief_newest_choice(3 * i - 4) := choice(relief_newest_choice(8), is_set(relief_newest_values_from_6(6), i),
        is_set(relief_newest_values_from_6(7), i));
    end loop;
    relief_newest_choice(15) := inverted_carry(relief_newest_choice(7), is_set(relief_centre_grey(1), 7), not
      is_set(relief_before, 7));
    relief_newest_choice_16 := choice(relief_newest_choice(15), (relief_newest_values_from_6(7) / 2) mod 32,
      (relief_newest_values_from_6(6) / 2) mod 32);
    relief_centre_grey(0) <= relief_centre_column(4);
    relief_centre_grey(1) <= relief_centre_grey(0);
    relief_delayed_0 <= relief_newest;
    relief_rows_read_newest_0 <= relief_delayed_0;
    relief_rows_ready_words_0 <= to_integer(relief_rows_read_words_0);
    relief_rows_ready_newest_0 <= relief_rows_read_newest_0;
    relief_shown_0 <= relief_rows_ready_words_0;
    relief_write_turned_0 <= relief_entered;
    relief_newest <= choice((not ((not ((not ((not relief_newest_choice(9)) and relief_newest_choice(10))) and
      relief_newest_choice(11) and relief_newest_choice(12))) and relief_newest_choice(13))) or
      relief_newest_choice(14), 25, relief_newest_choice_16);
    relief_entered <= choice(relief_entering < 25, relief_entering, 25);
    relief_write_address <= choice(line_starts_phases(1), line_order_address, 638);
    if transform_filtering_valid(2) then relief_before <= relief_centre_grey(1); end if;
    if rows_ready_tag.valid then relief_rows_write_words_0 <= relief_rows_ready_newest_0; end if;
    if rows_tag.valid then
      relief_column_0 <= relief_shown_0;
      relief_entering <= relief_column_0;
    end if;
    if line_comes(1) then
      relief_between <= to_integer(relief_turned_0);
      relief_left(0) <= choice(line_newest_first_column, 64, 64 - relief_entered);
      relief_right(0) <= choice(line_newest_first_column, 64, 64 - relief_between);
    end if;
    for i in 1 to 2 loop
      if line_comes(8 * i + 1) then
        relief_left(i) <= relief_left(i - 1);
        relief_right(i) <= relief_right(i - 1);
      end if;
    end loop;
    if reset = '1' then
      transform_left_0 <= 0; transform_right_0 <= 0; transform_valid <= false; transform_counter_column <= 0;
      transform_counter_group <= 482; transform_counter_next_frame <= false; transform_counter_last_column <= false;
      transform_counter_counts <= false; transform_counter_frame_joins <= false;
      transform_counter_back_to_back <= false; transform_counter_column_after <= 1;
      transform_counter_group_after <= 482; transform_counter_next_frame_after <= false;
      transform_left_rows_read_newest_0 <= 0; transform_left_rows_ready_words_0 <= to_unsigned(0, 32);
      transform_left_rows_ready_newest_0 <= 0; transform_left_rows_write_words_0 <= to_unsigned(0, 32);
      transform_right_rows_read_newest_0 <= 0; transform_right_rows_ready_words_0 <= to_unsigned(0, 32);
      transform_right_rows_ready_newest_0 <= 0; transform_right_rows_write_words_0 <= to_unsigned(0, 32);
      transform_read_column <= 0; transform_read_row_inside_0 <= false;
      transform_read_column_inside <= (others => false); transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_row_inside <= (others => false);
      transform_ready_column_inside <= (others => false); transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_reached_first <= (others => false);
      transform_reached_beyond_last <= (others => false); transform_write_column <= 0;
      transform_left_column <= (others => 0); transform_right_column <= (others => 0);
      transform_columns_row_inside <= (others => false); transform_columns_column_inside <= (others => false);
      transform_columns_start_of_frame <= false; transform_columns_valid <= false;
      transform_left_filter_column <= (others => (others => 0));
      transform_left_filter_low_is_larger_0 <= (others => (others => false));
      transform_left_filter_low_is_larger_0_4_0 <= false; transform_left_filter_low_is_larger_0_4_4 <= false;
      transform_left_filter_low_is_larger_0s <= (others => (others => false)); transform_left_filter_feature_0 <= 0;
      transform_right_filter_column <= (others => (others => 0));
      transform_right_filter_low_is_larger_0 <= (others => (others => false));
      transform_right_filter_low_is_larger_0_4_0 <= false; transform_right_filter_low_is_larger_0_4_4 <= false;
      transform_right_filter_low_is_larger_0s <= (others => (others => false)); transform_right_filter_feature_0 <= 0;
      transform_filtering_0_column_inside <= (others => false);
      for i in 0 to 2 loop
        transform_filtering_start_of_frame(i) <= false; transform_filtering_valid(i) <= false;
      end loop;
      raster_features_search_0 <= 0; raster_features_reference_0 <= 0; raster_features_valid <= false;
      raster_place_column <= 0; raster_place_group <= 481; raster_place_next_frame <= false;
      raster_place_last_column <= false; raster_place_counts <= false; raster_place_frame_joins <= false;
      raster_place_back_to_back <= false; raster_place_column_after <= 1; raster_place_group_after <= 481;
      delay_ahead_0 <= 0; delay_delayed_0 <= 0; delay_column <= 0; delay_row_inside <= (others => false);
      delay_tag <= (others => false); rows_search_rows_read_newest_0 <= 0; rows_search_rows_ready_words_0 <= 0;
      rows_search_rows_ready_newest_0 <= 0; rows_search_rows_write_words_0 <= 0; rows_reference_rows_read_newest_0 <= 0;
      rows_reference_rows_ready_words_0 <= 0; rows_reference_rows_ready_newest_0 <= 0;
      rows_reference_rows_write_words_0 <= 0; rows_read_column <= 0; rows_read_inside <= (others => false);
      rows_read_tag <= (others => false); rows_ready_column <= 0; rows_ready_inside <= (others => false);
      rows_ready_tag <= (others => false); rows_write_column <= 0; rows_search <= (others => 0);
      rows_reference <= (others => 0); rows_tag <= (others => false); line_centre_map_column_0 <= false;
      line_centre_output_column_0 <= false; line_centre_first_column_0 <= false; line_centre_start_of_frame_0 <= false;
      line_centre_end_of_line_0 <= false; line_order_address <= 0; line_order_falls <= false;
      line_order_inside <= false; line_order_complete <= false; line_order_output <= false; line_order_first <= false;
      line_order_held_output <= false; line_order_turned_valid <= false; line_order_turned_map_column <= false;
      line_order_turned_output_column <= false; line_order_turned_first_column <= false;
      line_order_turned_start_of_frame <= false; line_order_turned_end_of_line <= false;
      line_newest_first_column <= false; line_newest_top <= false; line_comes <= (others => false);
      line_starts_phases <= (others => false); line_places_map_column(0) <= false; line_places_first_column(0) <= false;
      line_places_0_top <= false;
      for i in 0 to 2 loop
        line_places_address(i) <= 0; line_places_shown_output_column(i) <= false;
        line_places_shown_first_column(i) <= false; line_places_shown_start_of_frame(i) <= false;
        line_places_shown_end_of_line(i) <= false; line_places_map_column(i + 1) <= false;
        line_places_first_column(i + 1) <= false;
      end loop;
      line_places_shown_output_column(3) <= false; line_places_shown_start_of_frame(3) <= false;
      line_places_shown_end_of_line(3) <= false; line_places_map_column(4) <= false;
      line_places_first_column(4) <= false; line_places_shown_output_column(4) <= false;
      line_places_shown_start_of_frame(4) <= false; line_places_shown_end_of_line(4) <= false;
      costsshift_newest <= (others => 0); costsshift_new_reference <= (others => 0); costsshift_new_tag_valid <= false;
      costsshift_count_phase <= 7; costsshift_handed_on <= (others => 0); costsshift_read_reference <= (others => 0);
      costsshift_read_tag_valid <= false; costsshift_read_count_phase <= 7;
      costsshift_search <= (others => (others => 0)); costsshift_reference <= (others => 0);
      costsshift_write_phase <= 7;
      for i in 0 to 2 loop
        for j in 0 to 7 loop
          costscolumn_pixels_first_count(i, j, 0) <= 0; costscolumn_pixels_first_count(i, j, 1) <= 0;
          costscolumn_pixels_first_count(i, j, 2) <= 0; costscolumn_pixels_first_count(i, j, 3) <= 0;
          costscolumn_pixels_first_count_4(i, j) <= 0;
        end loop;
      end loop;
      costscolumn_pixels_cost <= (others => (others => 0)); costscolumn_pair_0 <= (others => 0);
      costscolumn_single_0 <= (others => 0); costscolumn_column_0 <= (others => 0); costswindow_read_count_phase <= 7;
      costswindow_partial <= (others => 0); costswindow_partials <= (others => 0); costswindow_write_count_phase <= 7;
      costswindow_sum_0 <= (others => 0); costsmask_column <= 0; costsmask_partner <= 0;
      costsmask_inside <= (others => false); costs_cost <= (others => 0); paths_tree_smallest <= (others => 0);
      paths_tree_next_smallest <= (others => 0); paths_tree_next_next_smallest_0 <= 0; paths_smallest_cost <= 0;
      paths_cost_delay_ring_read_address <= 1; paths_cost_delay_ring_write_address <= 0;
      pathsleft_fresh_past_newest <= (others => 0); pathsleft_fresh_past_pairs <= (others => 0);
      pathsleft_fresh_past_fours <= (others => 0); pathsleft_fresh_past_eight <= 0; pathsleft_fresh_past_oldest <= 0;
      pathsleft_fresh_past_cheapest <= 0; pathsleft_fresh_known <= 0; pathsleft_fresh_here <= 0;
      pathsleft_low_address <= 5; pathsleft_lost <= false; pathsleft_short_of <= false; pathsleft_missing <= 0;
      pathsleft_below <= 0; pathsleft_q <= 0; pathsleft_room_left <= 0; pathsleft_q_now <= 0; pathsleft_q_less <= 0;
      pathsleft_room <= 0; pathsleft_start_cost <= (others => 0); pathsleft_first <= false; pathsleft_g <= 0;
      pathsleft_g_less <= 0; pathsleft_read_count_phase <= 7; pathsleft_ahead_count_phase <= 7;
      pathsleft_is_first <= false; pathsleft_is_last <= true; pathsleft_lower_neighbour <= 0;
      pathsleft_stay <= (others => 0); pathsleft_step <= (others => 0); pathsleft_stay_change <= (others => 0);
      pathsleft_step_change <= (others => 0); pathsleft_cost <= (others => 0); pathsleft_arrived <= (others => 0);
      pathsleft_write_count_phase <= 7; pathsleft_tree_smallest <= (others => 0);
      pathsleft_tree_next_smallest <= (others => 0); pathsleft_tree_next_next_smallest_0 <= 0; pathsleft_low_0 <= 0;
      pathsleft_low_write_address <= 0; pathsabove_memory_read_address_0 <= 0; pathsabove_memory_read_address_1 <= 0;
      pathsabove_memory_bank <= false; pathsabove_memory_read_bank <= false; pathsabove_memory_held_words(0, 0) <= 0;
      pathsabove_memory_held_words(0, 1) <= 0; pathsabove_memory_held_words_2(0) <= 0;
      pathsabove_memory_held_words(1, 0) <= 0; pathsabove_memory_held_words(1, 1) <= 0;
      pathsabove_memory_held_words_2(1) <= 0; pathsabove_memory_held_bank <= false;
      pathsabove_memory_ready_words <= (others => 0); pathsabove_memory_write_words(0, 0) <= 0;
      pathsabove_memory_write_words(0, 1) <= 0; pathsabove_memory_write_words_2(0) <= 0;
      pathsabove_memory_write_words(1, 0) <= 0; pathsabove_memory_write_words(1, 1) <= 0;
      pathsabove_memory_write_words_2(1) <= 0; pathsabove_memory_write_address_0 <= 0;
      pathsabove_memory_write_address_1 <= 0; pathsabove_read_address_address <= 0;
      pathsabove_read_address_count_phase <= 7; pathsabove_ready_top <= false; pathsabove_total <= (others => 0);
      pathsabove_tree_smallest <= (others => 0); pathsabove_tree_next_smallest <= (others => 0);
      pathsabove_tree_next_next_smallest_0 <= 0; pathsabove_smallest_total <= 0; pathsabove_smallest <= 0;
      pathsabove_cost <= (others => 0); pathsabove_held <= (others => 0); pathsabove_lower_neighbour <= 0;
      pathsabove_count_phase <= 7; pathsabove_beside <= (others => 0); pathsabove_own <= (others => 0);
      pathsabove_step <= (others => 0); pathsabove_stay <= (others => 0); pathsabove_write_address_address <= 0;
      pathsabove_write_address_is_here <= false; pathsabove_write_address_count_phase <= 7;
      pathsturn_sum_memory_read_address_0 <= 0; pathsturn_sum_memory_read_address_1 <= 0;
      pathsturn_sum_memory_bank <= false; pathsturn_sum_memory_read_bank <= false;
      for i in 0 to 1 loop
        pathsturn_sum_memory_held_words(i, 0) <= 0; pathsturn_sum_memory_held_words(i, 1) <= 0;
        pathsturn_sum_memory_held_words(i, 2) <= 0; pathsturn_sum_memory_held_words_3(i) <= 0;
      end loop;
      pathsturn_sum_memory_held_bank <= false; pathsturn_sum_memory_ready_words <= (others => 0);
      for i in 0 to 1 loop
        pathsturn_sum_memory_write_words(i, 0) <= 0; pathsturn_sum_memory_write_words(i, 1) <= 0;
        pathsturn_sum_memory_write_words(i, 2) <= 0; pathsturn_sum_memory_write_words_3(i) <= 0;
      end loop;
      pathsturn_sum_memory_write_address_0 <= 0; pathsturn_sum_memory_write_address_1 <= 0;
      pathsturn_cost_memory_read_address_0 <= 0; pathsturn_cost_memory_read_address_1 <= 0;
      pathsturn_cost_memory_bank <= false; pathsturn_cost_memory_read_bank <= false;
      pathsturn_cost_memory_held_words_0(0) <= 0; pathsturn_cost_memory_held_words_1(0) <= 0;
      pathsturn_cost_memory_held_words_0(1) <= 0; pathsturn_cost_memory_held_words_1(1) <= 0;
      pathsturn_cost_memory_held_bank <= false; pathsturn_cost_memory_ready_words <= (others => 0);
      pathsturn_cost_memory_write_words_0(0) <= 0; pathsturn_cost_memory_write_words_1(0) <= 0;
      pathsturn_cost_memory_write_words_0(1) <= 0; pathsturn_cost_memory_write_words_1(1) <= 0;
      pathsturn_cost_memory_write_address_0 <= 0; pathsturn_cost_memory_write_address_1 <= 0;
      pathsturn_smallest_address <= 0; pathsturn_ready_smallest_0 <= 0; pathsturn_read_address_address <= 0;
      pathsturn_read_address_count_phase <= 7; pathsturn_sum_read_address <= 0; pathsturn_write_smallest_0 <= 0;
      pathsturn_write_smallest_address <= 0; pathsturn_write_address_address <= 0;
      pathsturn_write_address_is_here <= false; pathsturn_write_address_count_phase <= 7;
      pathsturn_sum_write_address <= (others => 0); pathsturn_writes_sums <= (others => false);
      pathsright_fresh_past_newest <= (others => 0); pathsright_fresh_past_pairs <= (others => 0);
      pathsright_fresh_past_fours <= (others => 0); pathsright_fresh_past_eight <= 0; pathsright_fresh_past_oldest <= 0;
      pathsright_fresh_past_cheapest <= 0; pathsright_fresh_known <= 0; pathsright_fresh_here <= 0;
      pathsright_lost <= false; pathsright_short_of <= false; pathsright_missing <= 0; pathsright_below <= 0;
      pathsright_q <= 0; pathsright_room_left <= 0; pathsright_q_now <= 0; pathsright_q_less <= 0; pathsright_room <= 0;
      pathsright_start_cost <= (others => 0); pathsright_g <= 0; pathsright_g_less <= 0;
      pathsright_lower_neighbour <= 0; pathsright_stay <= (others => 0); pathsright_step <= (others => 0);
      pathsright_stay_change <= (others => 0); pathsright_step_change <= (others => 0);
      pathsright_cost <= (others => 0); pathsright_arrived <= (others => 0); pathsright_tree_smallest <= (others => 0);
      pathsright_tree_next_smallest <= (others => 0); pathsright_tree_next_next_smallest_0 <= 0; pathsright_low_0 <= 0;
      paths_sum <= (others => 0); winnersmask_column <= 0; winnersmask_partner <= 0;
      winnersmask_inside <= (others => false); winnerswinner1_held_0 <= (others => 0);
      winnerswinner1_best_cost_0 <= (others => 0); winnerswinner1_best_index_0_0 <= false;
      winnerswinner1_best_index_0 <= (others => 0); winnerswinner1_best_below_0 <= (others => 0);
      winnerswinner1_best_above_0 <= (others => 0); winnerswinner1_best_place_0_2 <= false;
      winnerswinner1_best_late_cost_0 <= (others => 0); winnerswinner1_best_but_first_0 <= (others => 255);
      winnerswinner1_best_but_last_0 <= (others => 255); winnerswinner2_best_cost_0 <= (others => 0);
      winnerswinner2_best_index_0 <= (others => 0); winnerswinner2_best_below_0 <= (others => 0);
      winnerswinner2_best_above_0 <= (others => 0); winnerswinner2_best_first_0 <= (others => 0);
      winnerswinner2_best_last_0 <= (others => 0); winnerswinner2_best_place_0 <= (others => false);
      winnerswinner2_best_at_start_0 <= (others => false); winnerswinner2_best_at_end_0 <= (others => false);
      winnerswinner2_best_late_cost_0 <= (others => 0); winnerswinner2_best_second_0 <= (others => 255);
      winnerswinner2_best_but_first_0 <= (others => 255); winnerswinner2_best_but_last_0 <= (others => 255);
      winnerswinner3_best_cost_0_0 <= 0; winnerswinner3_best_index_0_0 <= 0; winnerswinner3_best_below_0_0 <= 0;
      winnerswinner3_best_above_0_0 <= 0; winnerswinner3_best_first_0_0 <= 0; winnerswinner3_best_last_0_0 <= 0;
      winnerswinner3_best_place_0_0 <= false; winnerswinner3_best_at_start_0_0 <= false;
      winnerswinner3_best_at_end_0_0 <= false; winnerswinner3_best_late_cost_0_0 <= 0;
      winnerswinner3_best_second_0_0 <= 255; winnerswinner3_best_but_first_0_0 <= 255;
      winnerswinner3_best_but_last_0_0 <= 255; winners_best_cost_0_0 <= 0; winners_best_index_0_0 <= 0;
      winners_best_below_0_0 <= 0; winners_best_above_0_0 <= 0; winners_best_last_0_0 <= 0;
      winners_best_place_0_0 <= false; winners_best_at_start_0_0 <= false; winners_best_at_end_0_0 <= false;
      winners_best_late_cost_0_0 <= 0; winners_best_second_0_0 <= 255; winners_best_but_last_0_0 <= 255;
      winners_best_tag <= (others => false); winners_partner_column <= 0; winners_partner_at <= 0;
      other_read_count_phase <= 7; other_words(0) <= to_unsigned(0, 32); other_words(1) <= to_unsigned(0, 32);
      other_words(2) <= to_unsigned(0, 32); other_words(3) <= to_unsigned(0, 32); other_count_phase <= 7;
      other_base <= 0; other_first_column <= false; other_output_column <= false; other_write_count_phase <= 7;
      other_left <= 0; refinement_disparity_0 <= (others => 0); refinement_passed_0 <= (others => false);
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_map_column(i) <= false;
        refinement_tag_output_column(i) <= false; refinement_tag_start_of_frame(i) <= false;
        refinement_tag_end_of_line(i) <= false;
      end loop;
      refinement_alone_0_0 <= false; refinement_gap_0 <= 0; refinement_scaled_gap <= false;
      refinement_margin_0 <= (others => 0); refinement_below_0 <= 0; refinement_above_0 <= 0; refinement_u_0 <= 0;
      refinement_v_0 <= 0; refinement_difference_0 <= 0; refinement_remainder_0 <= (others => 0);
      refinement_divisor_0 <= (others => 1); refinement_quotient_8_0 <= 0; refinement_negative_0 <= (others => false);
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
      turn_ready <= 0; turn_ready_tag <= (others => false); support_counter_column <= 0; support_counter_group <= 482;
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
      fill_counter_group <= 481; fill_newest_disparity_0 <= 0; fill_newest_passed_0 <= false; fill_newest_sure_0 <= 0;
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
      median_counter_group <= 481; median_arrives <= false; median_behind <= false; median_line_ended <= false;
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
      relief_centre_column <= (others => 0); relief_centre_grey <= (others => 0); relief_before <= 0;
      relief_newest <= 0; relief_delayed_0 <= 0; relief_rows_read_newest_0 <= 0; relief_rows_ready_words_0 <= 0;
      relief_rows_ready_newest_0 <= 0; relief_rows_write_words_0 <= 0; relief_shown_0 <= 0; relief_column_0 <= 0;
      relief_entering <= 0; relief_entered <= 0; relief_left <= (others => 0); relief_right <= (others => 0);
      relief_between <= 0; relief_write_turned_0 <= 0; relief_write_address <= 0; other_0 <= true; other_2 <= 0;
      other_3 <= 0; other_4 <= 8; other_5 <= 0; other_6 <= 0; other_7 <= 0; other_8 <= 0; other_9 <= 0; other_10 <= 0;
      other_11 <= 0; other(12) <= to_unsigned(0, 32); other(13) <= to_unsigned(0, 32); other(14) <= to_unsigned(0, 32);
      other(15) <= to_unsigned(0, 32);
    end if;
  end process;
end architecture;
