-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_320_64_f16: 320x240, 64 disparities, window 3x3, P1 7, P2 60, 1 pixel pair a clock.
-- Options: reference left, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap 5, p1 7, p2 60,
--   above_p1 5, above_p2 31, median true, slice_disparities 16, clocks_per_pixel 16, front_clocks 2.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_320_64_f16
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
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
  type natural_105_1d is array (natural range <>) of natural range 0 to 105;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_14_1d is array (natural range <>) of natural range 0 to 14;
  type natural_14_2d is array (natural range <>, natural range <>) of natural range 0 to 14;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16383_2d is array (natural range <>, natural range <>) of natural range 0 to 16383;
  type natural_169_1d is array (natural range <>) of natural range 0 to 169;
  type natural_21_1d is array (natural range <>) of natural range 0 to 21;
  type natural_254_1d is array (natural range <>) of natural range 0 to 254;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_28_1d is array (natural range <>) of natural range 0 to 28;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_31_2d is array (natural range <>, natural range <>) of natural range 0 to 31;
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
  type tag_6 is record
    valid, border_column, first_cost, map_column, output_column, start_of_frame : boolean;
  end record;
  type tag_7 is record
    valid, border_column, first_cost, map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_2 is record
    valid, border_column : boolean;
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
  signal transform_left_0, transform_right_0, transform_counter_group, transform_counter_group_after,
    transform_left_rows_read_newest_0, transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0,
    transform_right_rows_ready_newest_0 : natural range 0 to 255;
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
    transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0, transform_left_rows_write_words_0,
    transform_right_rows_read_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame, raster_place_last_column, raster_place_counts,
    raster_place_frame_joins, raster_place_back_to_back : boolean;
  signal raster_place_column, raster_place_column_after : natural range 0 to 511;
  signal raster_place_group, raster_place_group_after : natural range 0 to 255;
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
  signal rows_read_tag : tag_7;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag, rows_tag : tag_7;
  -- line
  signal line_centre_map_column_0, line_centre_output_column_0, line_centre_first_column_0,
    line_centre_start_of_frame_0, line_centre_end_of_line_0, line_order_falls, line_order_inside, line_order_complete,
    line_order_output, line_order_first, line_order_held_output, line_order_turned_valid, line_order_turned_map_column,
    line_order_turned_output_column, line_order_turned_start_of_frame, line_order_turned_end_of_line,
    line_newest_first_column, line_newest_top : boolean;
  signal line_comes, line_starts_phases : boolean_1d(1 to 47);
  signal line_places_map_column : boolean_1d(0 to 2);  -- _#_map_column
  signal line_places_first_column : boolean_1d(0 to 1);  -- _#_first_column
  signal line_places_0_top : boolean;
  signal line_places_shown_output_column : boolean_1d(0 to 2);  -- _#_shown_output_column
  signal line_places_shown_start_of_frame : boolean_1d(0 to 2);  -- _#_shown_start_of_frame
  signal line_places_shown_end_of_line : boolean_1d(0 to 2);  -- _#_shown_end_of_line
  signal line_order_address : natural range 0 to 511;
  signal line_places_address : natural_511_1d(0 to 1);  -- _#_address
  -- costsshift
  signal costsshift_newest, costsshift_new_reference, costsshift_handed_on,
    costsshift_read_reference : natural_16383_1d(0 to 2);
  signal costsshift_search : natural_16383_2d(0 to 2, 0 to 3);
  signal costsshift_reference : natural_16383_1d(0 to 2);
  signal costsshift_new_tag, costsshift_read_tag : tag_2;
  signal costsshift_tag_border_column : boolean;
  signal costsshift_count_phase, costsshift_read_count_phase, costsshift_write_phase : natural range 0 to 15;
  signal costsshift_read_words : unsigned_28_1d(0 to 5);
  -- costscolumn
  signal costscolumn_pixels_first_count : natural_3_3d(0 to 2, 0 to 3, 0 to 3);  -- _#_#_count_#
  signal costscolumn_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 3);  -- _#_#_count_4
  signal costscolumn_pixels_first_tag_border_column, costscolumn_pixels_tag_border_column,
    costscolumn_pair_tag_border_column : boolean;
  signal costscolumn_pixels_cost : natural_14_2d(0 to 2, 0 to 3);
  signal costscolumn_single_0 : natural_14_1d(0 to 3);
  signal costscolumn_pair_0 : natural_28_1d(0 to 3);
  signal costscolumn_column_0 : natural_42_1d(0 to 3);
  -- costswindow
  signal costswindow_read_count_phase, costswindow_write_count_phase : natural range 0 to 15;
  signal costswindow_read_words_0 : unsigned(26 downto 0);
  signal costswindow_read_words_1 : unsigned(27 downto 0);
  signal costswindow_partial : natural_42_1d(0 to 3);
  signal costswindow_partials : natural_105_1d(4 to 7);  -- _partial_#
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
  signal pathsleft_low_address, pathsleft_read_count_phase, pathsleft_ahead_count_phase, pathsleft_write_count_phase,
    pathsleft_low_write_address : natural range 0 to 15;
  signal pathsleft_lowest_0, pathsleft_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsleft_lost, pathsleft_short_of, pathsleft_first, pathsleft_is_first, pathsleft_is_last : boolean;
  signal pathsleft_missing, pathsleft_below, pathsleft_q, pathsleft_room_left, pathsleft_q_now,
    pathsleft_room : natural range 0 to 63;
  signal pathsleft_start_cost : natural_63_1d(1 to 8);
  signal pathsleft_q_less, pathsleft_g_less, pathsleft_lower_neighbour : natural range 0 to 127;
  signal pathsleft_stay, pathsleft_step, pathsleft_stay_change, pathsleft_step_change, pathsleft_cost,
    pathsleft_arrived : natural_127_1d(0 to 3);
  signal pathsleft_tree_smallest : natural_127_1d(0 to 1);
  signal pathsleft_tree_next_smallest_0, pathsleft_low_0 : natural range 0 to 127;
  signal pathsleft_g : natural range 0 to 84;
  signal pathsleft_read_words : unsigned_28_1d(0 to 1);
  -- pathsabove
  signal pathsabove_memory_read_address_0, pathsabove_memory_write_address_0 : natural range 0 to 4095;
  signal pathsabove_memory_read_address_1 : natural range 0 to 15;
  signal pathsabove_memory_held_words_1 : natural_15_1d(0 to 1);  -- _#_1
  signal pathsabove_memory_ready_words : natural_65535_1d(0 to 1);  -- _# up to 65535, 15
  signal pathsabove_memory_write_words_1 : natural_15_1d(0 to 1);  -- _#_1
  signal pathsabove_memory_write_address_1, pathsabove_read_address_count_phase, pathsabove_count_phase,
    pathsabove_write_address_count_phase : natural range 0 to 15;
  signal pathsabove_memory_bank, pathsabove_memory_read_bank, pathsabove_memory_held_bank, pathsabove_ready_top,
    pathsabove_write_address_is_here : boolean;
  signal pathsabove_memory_read_words_0 : unsigned_16_1d(0 to 1);  -- _#_0
  signal pathsabove_memory_read_words_1 : unsigned_4_1d(0 to 1);  -- _#_1
  signal pathsabove_memory_held_words_0, pathsabove_memory_write_words_0 : natural_65535_1d(0 to 1);  -- _#_0
  signal pathsabove_read_address_address, pathsabove_write_address_address : natural range 0 to 8191;
  signal pathsabove_total : natural_52_1d(0 to 3);
  signal pathsabove_tree_smallest : natural_52_1d(0 to 1);
  signal pathsabove_tree_next_smallest_0 : natural range 0 to 52;
  signal pathsabove_delay_held_0 : unsigned(23 downto 0);
  signal pathsabove_smallest_total, pathsabove_smallest : natural range 0 to 63;
  signal pathsabove_cost, pathsabove_held : natural_63_1d(0 to 3);
  signal pathsabove_lower_neighbour : natural range 0 to 63;
  signal pathsabove_beside : natural_63_1d(0 to 3);
  signal pathsabove_own : natural_63_1d(0 to 2);
  signal pathsabove_step : natural_68_1d(0 to 3);
  signal pathsabove_stay : natural_31_1d(0 to 3);
  -- pathsturn
  signal pathsturn_sum_memory_read_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_held_words_1 : natural_4095_1d(0 to 1);  -- _#_1
  signal pathsturn_sum_memory_ready_words : natural_65535_1d(0 to 1);  -- _# up to 65535, 4095
  signal pathsturn_sum_memory_write_words_1 : natural_4095_1d(0 to 1);  -- _#_1
  signal pathsturn_sum_memory_write_address_0, pathsturn_cost_memory_read_address_0 : natural range 0 to 4095;
  signal pathsturn_cost_memory_held_words_0 : natural_4095_1d(0 to 1);  -- _#_0
  signal pathsturn_cost_memory_ready_words_0 : natural range 0 to 4095;
  signal pathsturn_cost_memory_write_words_0 : natural_4095_1d(0 to 1);  -- _#_0
  signal pathsturn_cost_memory_write_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_read_address_1, pathsturn_sum_memory_write_address_1,
    pathsturn_cost_memory_read_address_1, pathsturn_cost_memory_write_address_1, pathsturn_read_address_count_phase,
    pathsturn_write_address_count_phase : natural range 0 to 15;
  signal pathsturn_sum_memory_bank, pathsturn_sum_memory_read_bank, pathsturn_sum_memory_held_bank,
    pathsturn_cost_memory_bank, pathsturn_cost_memory_read_bank, pathsturn_cost_memory_held_bank,
    pathsturn_write_address_is_here : boolean;
  signal pathsturn_writes_sums : boolean_1d(0 to 1);
  signal pathsturn_sum_memory_read_words_0 : unsigned_16_1d(0 to 1);  -- _#_0
  signal pathsturn_sum_memory_read_words_1 : unsigned_12_1d(0 to 1);  -- _#_1
  signal pathsturn_cost_memory_read_words_0 : unsigned_12_1d(0 to 1);  -- _#_0
  signal pathsturn_sum_memory_held_words_0, pathsturn_sum_memory_write_words_0 : natural_65535_1d(0 to 1);  -- _#_0
  signal pathsturn_smallest_address, pathsturn_write_smallest_address : natural range 0 to 511;
  signal pathsturn_read_smallest_0 : unsigned(4 downto 0);
  signal pathsturn_ready_smallest_0 : natural range 0 to 31;
  signal pathsturn_read_address_address, pathsturn_sum_read_address,
    pathsturn_write_address_address : natural range 0 to 8191;
  signal pathsturn_sum_write_address : natural_8191_1d(0 to 1);
  signal pathsturn_write_smallest_0 : natural range 0 to 21;
  -- pathsright
  signal pathsright_lowest_0, pathsright_read_neighbour_0 : unsigned(6 downto 0);
  signal pathsright_lost, pathsright_short_of : boolean;
  signal pathsright_missing, pathsright_below, pathsright_q, pathsright_room_left, pathsright_q_now,
    pathsright_room : natural range 0 to 63;
  signal pathsright_start_cost : natural_63_1d(1 to 8);
  signal pathsright_q_less, pathsright_g_less, pathsright_lower_neighbour : natural range 0 to 127;
  signal pathsright_stay, pathsright_step, pathsright_stay_change, pathsright_step_change, pathsright_cost,
    pathsright_arrived : natural_127_1d(0 to 3);
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
  signal winners_best_tag : tag_5;
  -- turn
  signal turn_order_address, turn_newest, turn_write_words_0, turn_write_place, turn_ready : natural range 0 to 511;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame,
    turn_order_turned_end_of_line, turn_comes : boolean;
  signal turn_read_tag : tag_4;
  signal turn_ready_tag : tag_5_b;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- map
  signal map_counter_column, map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0,
    map_write_column : natural range 0 to 511;
  signal map_column : natural_511_1d(1 to 2);
  signal map_at_column, map_comparing_column, map_sorted_column : natural range 0 to 511;
  signal map_counter_group, map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0,
    map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 255;
  signal map_low_0, map_middle_0, map_high_0 : natural_255_1d(0 to 2);  -- _#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b, map_of_middle_0_c,
    map_of_high_0_a, map_of_high_0_b, map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0,
    map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 255;
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
  signal map_rows_read_words_0 : unsigned(17 downto 0);
  signal map_rows_ready_words_0, map_rows_write_words_0 : natural range 0 to 262143;
  -- other
  signal other : unsigned_49_1d(0 to 1);
  signal other_2 : natural range 0 to 510;

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

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  transform_left_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (320, 32, 9)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address,
        transform_left_rows_write_words_0);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (320, 32, 9)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address,
        transform_right_rows_write_words_0);
  end block;

  map_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(17 downto 0);
  begin
    read_address <= to_unsigned(map_counter_column, 9);
    write_address <= to_unsigned(map_write_column, 9);
    write_data <= to_unsigned(map_rows_write_words_0, 18);
    cell : entity work.line_memory generic map (257, 18, 9)
      port map (clock, true, read_address, map_rows_read_words_0, write_address, write_data);
  end block;

  turn_read_words_0_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(turn_order_address, 9);
    write_address <= to_unsigned(turn_write_place, 9);
    write_data <= to_unsigned(turn_write_words_0, 9);
    cell : entity work.line_memory generic map (258, 9, 9)
      port map (clock, true, read_address, turn_read_words_0, write_address, write_data);
  end block;

  pathsright_read_words_1_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 4);
    write_address <= to_unsigned(pathsleft_write_count_phase, 4);
    write_data <= to_unsigned(pathsright_arrived(3), 7) & to_unsigned(pathsright_arrived(2), 7) &
      to_unsigned(pathsright_arrived(1), 7) & to_unsigned(pathsright_arrived(0), 7);
    cell : entity work.line_memory generic map (16, 28, 4)
      port map (clock, true, read_address, pathsright_read_words(1), write_address, write_data);
  end block;

  pathsright_read_words_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 4);
    write_address <= to_unsigned(pathsleft_write_count_phase, 4);
    write_data <= to_unsigned(pathsright_cost(3), 7) & to_unsigned(pathsright_cost(2), 7) &
      to_unsigned(pathsright_cost(1), 7) & to_unsigned(pathsright_cost(0), 7);
    cell : entity work.line_memory generic map (16, 28, 4)
      port map (clock, true, read_address, pathsright_read_words(0), write_address, write_data);
  end block;

  pathsright_read_neighbour_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(6 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_ahead_count_phase, 4);
    write_address <= to_unsigned(pathsleft_write_count_phase, 4);
    write_data <= to_unsigned(pathsright_cost(0), 7);
    cell : entity work.line_memory generic map (16, 7, 4)
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
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(4 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_smallest_address, 9);
    write_address <= to_unsigned(pathsturn_write_smallest_address, 9);
    write_data <= to_unsigned(pathsturn_write_smallest_0, 5);
    cell : entity work.line_memory generic map (258, 5, 9)
      port map (clock, true, read_address, pathsturn_read_smallest_0, write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_0_memory : block
    signal read_address, write_address, write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_1(0), 12);
    cell : entity work.line_memory generic map (4096, 12, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words_1(0), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_0(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words_0(0), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_1_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 4);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 4);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_1(1), 12);
    cell : entity work.line_memory generic map (16, 12, 4)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words_1(1), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_1_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 4);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 4);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_0(1), 16);
    cell : entity work.line_memory generic map (16, 16, 4)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words_0(1), write_address, write_data);
  end block;

  pathsturn_cost_memory_read_words_0_0_memory : block
    signal read_address, write_address, write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_cost_memory_write_words_0(0), 12);
    cell : entity work.line_memory generic map (4096, 12, 12)
      port map (clock, true, read_address, pathsturn_cost_memory_read_words_0(0), write_address, write_data);
  end block;

  pathsturn_cost_memory_read_words_0_1_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_cost_memory_read_address_1, 4);
    write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 4);
    write_data <= to_unsigned(pathsturn_cost_memory_write_words_0(1), 12);
    cell : entity work.line_memory generic map (16, 12, 4)
      port map (clock, true, read_address, pathsturn_cost_memory_read_words_0(1), write_address, write_data);
  end block;

  pathsabove_delay_held_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(paths_cost_delay_ring_read_address, 5);
    write_address <= to_unsigned(paths_cost_delay_ring_write_address, 5);
    write_data <= to_unsigned(pathsabove_total(3), 6) & to_unsigned(pathsabove_total(2), 6) &
      to_unsigned(pathsabove_total(1), 6) & to_unsigned(pathsabove_total(0), 6);
    cell : entity work.line_memory generic map (19, 24, 5)
      port map (clock, true, read_address, pathsabove_delay_held_0, write_address, write_data);
  end block;

  pathsabove_memory_read_words_1_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(3 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsabove_memory_write_words_1(0), 4);
    cell : entity work.line_memory generic map (4096, 4, 12)
      port map (clock, true, read_address, pathsabove_memory_read_words_1(0), write_address, write_data);
  end block;

  pathsabove_memory_read_words_0_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsabove_memory_write_words_0(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsabove_memory_read_words_0(0), write_address, write_data);
  end block;

  pathsabove_memory_read_words_1_1_memory : block
    signal read_address, write_address, write_data : unsigned(3 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_1, 4);
    write_address <= to_unsigned(pathsabove_memory_write_address_1, 4);
    write_data <= to_unsigned(pathsabove_memory_write_words_1(1), 4);
    cell : entity work.line_memory generic map (16, 4, 4)
      port map (clock, true, read_address, pathsabove_memory_read_words_1(1), write_address, write_data);
  end block;

  pathsabove_memory_read_words_0_1_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_1, 4);
    write_address <= to_unsigned(pathsabove_memory_write_address_1, 4);
    write_data <= to_unsigned(pathsabove_memory_write_words_0(1), 16);
    cell : entity work.line_memory generic map (16, 16, 4)
      port map (clock, true, read_address, pathsabove_memory_read_words_0(1), write_address, write_data);
  end block;

  pathsleft_read_words_1_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 4);
    write_address <= to_unsigned(pathsleft_write_count_phase, 4);
    write_data <= to_unsigned(pathsleft_arrived(3), 7) & to_unsigned(pathsleft_arrived(2), 7) &
      to_unsigned(pathsleft_arrived(1), 7) & to_unsigned(pathsleft_arrived(0), 7);
    cell : entity work.line_memory generic map (16, 28, 4)
      port map (clock, true, read_address, pathsleft_read_words(1), write_address, write_data);
  end block;

  pathsleft_read_words_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 4);
    write_address <= to_unsigned(pathsleft_write_count_phase, 4);
    write_data <= to_unsigned(pathsleft_cost(3), 7) & to_unsigned(pathsleft_cost(2), 7) &
      to_unsigned(pathsleft_cost(1), 7) & to_unsigned(pathsleft_cost(0), 7);
    cell : entity work.line_memory generic map (16, 28, 4)
      port map (clock, true, read_address, pathsleft_read_words(0), write_address, write_data);
  end block;

  pathsleft_read_neighbour_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(6 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_ahead_count_phase, 4);
    write_address <= to_unsigned(pathsleft_write_count_phase, 4);
    write_data <= to_unsigned(pathsleft_cost(0), 7);
    cell : entity work.line_memory generic map (16, 7, 4)
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
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(paths_cost_delay_ring_read_address, 5);
    write_address <= to_unsigned(paths_cost_delay_ring_write_address, 5);
    write_data <= ((((((to_unsigned(costs_cost(2), 6) & to_unsigned(0, 6)) or (to_unsigned((costs_cost(3) mod 8), 3) &
      to_unsigned(0, 9)))) or (to_unsigned(costs_cost(0), 12)))) or (to_unsigned(costs_cost(1), 9) & to_unsigned(0,
      3)));
    cell : entity work.line_memory generic map (19, 12, 5)
      port map (clock, true, read_address, paths_cost_delay_held_0, write_address, write_data);
  end block;

  costswindow_read_words_1_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(costswindow_read_count_phase, 4);
    write_address <= to_unsigned(costswindow_write_count_phase, 4);
    write_data <= to_unsigned(costswindow_partials(7), 7) & to_unsigned(costswindow_partials(6), 7) &
      to_unsigned(costswindow_partials(5), 7) & to_unsigned(costswindow_partials(4), 7);
    cell : entity work.line_memory generic map (16, 28, 4)
      port map (clock, true, read_address, costswindow_read_words_1, write_address, write_data);
  end block;

  costswindow_read_words_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(costswindow_read_count_phase, 4);
    write_address <= to_unsigned(costswindow_write_count_phase, 4);
    write_data <= to_unsigned(costswindow_partial(3), 6) & to_unsigned(costswindow_partial(2), 7) &
      to_unsigned(costswindow_partial(1), 7) & to_unsigned(costswindow_partial(0), 7);
    cell : entity work.line_memory generic map (16, 27, 4)
      port map (clock, true, read_address, costswindow_read_words_0, write_address, write_data);
  end block;

  costsshift_read_words_memory : for i in 5 downto 4 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(costsshift_count_phase, 4);
    write_address <= to_unsigned(costsshift_write_phase, 4);
    write_data <= to_unsigned(costsshift_search(2, 2 * i - 7), 14) & to_unsigned(costsshift_search(2, 2 * i - 8), 14);
    cell : entity work.line_memory generic map (16, 28, 4)
      port map (clock, true, read_address, costsshift_read_words(i), write_address, write_data);
  end generate;

  costsshift_read_words_3_memory : for i in 3 downto 2 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(costsshift_count_phase, 4);
    write_address <= to_unsigned(costsshift_write_phase, 4);
    write_data <= to_unsigned(costsshift_search(1, 2 * i - 3), 14) & to_unsigned(costsshift_search(1, 2 * i - 4), 14);
    cell : entity work.line_memory generic map (16, 28, 4)
      port map (clock, true, read_address, costsshift_read_words(i), write_address, write_data);
  end generate;

  costsshift_read_words_1_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(costsshift_count_phase, 4);
    write_address <= to_unsigned(costsshift_write_phase, 4);
    write_data <= to_unsigned(costsshift_search(0, 2 * i + 1), 14) & to_unsigned(costsshift_search(0, 2 * i), 14);
    cell : entity work.line_memory generic map (16, 28, 4)
      port map (clock, true, read_address, costsshift_read_words(i), write_address, write_data);
  end generate;

  rows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (320, 28, 9)
      port map (clock, true, read_address, rows_search_rows_read_words_0, write_address, write_data);
  end block;

  rows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (320, 28, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words_0, write_address, write_data);
  end block;

  process
    variable transform_counter_next_frame_is_equal, transform_counter_frame_joins_choice,
      transform_counter_next_frame_after_any, transform_counter_next_frame_after_is_equal,
      transform_read_column_inside_0_is_less, transform_reached_first_0_value, transform_reached_beyond_last_3_value,
      transform_reached_beyond_last_3_choice, transform_left_filter_low_is_larger_0_0_2_any,
      transform_left_filter_low_is_larger_0_0_2_is_equal, transform_right_filter_low_is_larger_0_0_2_any,
      transform_right_filter_low_is_larger_0_0_2_is_equal, raster_place_next_frame_is_equal,
      raster_place_back_to_back_choice, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less,
      delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less,
      line_order_address_any, line_order_falls_all, line_order_turned_output_column_choice,
      costsshift_search_0_0_is_equal, costswindow_partial_0_any, pathsleft_read_count_phase_is_equal,
      pathsleft_cost_0_any, pathsabove_count_phase_is_equal, pathsabove_memory_write_words_0_0_is_less,
      pathsabove_memory_write_words_0_0_choice_4, winnerswinner2_best_index_0_0_choice_8, turn_order_falls_all,
      turn_order_complete_all, map_line_ended_choice, map_at_arrives_value, map_window_complete_is_equal,
      map_window_complete_choice, map_of_low_0_b_below_a_is_equal, map_of_low_0_b_below_a_choice_7,
      map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice_7, map_of_low_0_c_below_b_choice_7,
      map_of_middle_0_b_below_a_is_equal, map_of_middle_0_b_below_a_choice_7, map_of_middle_0_c_below_a_value,
      map_of_middle_0_c_below_a_choice_7, map_of_middle_0_c_below_b_choice_7, map_of_high_0_b_below_a_is_equal,
      map_of_high_0_b_below_a_choice_7, map_of_high_0_c_below_a_value, map_of_high_0_c_below_a_choice_7,
      map_of_high_0_c_below_b_choice_7, map_of_all_0_b_below_a_is_equal, map_of_all_0_b_below_a_choice_7,
      map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice_7, map_of_all_0_c_below_b_choice_7 : boolean;
    variable transform_counter_group_after_choice, raster_place_group_after_choice, winners_best_cost_0_0_choice_2,
      map_low_0_0_choice, map_middle_0_0_choice, map_high_0_0_choice : natural range 0 to 255;
    variable transform_left_filter_low_is_larger_0_value,
      transform_right_filter_low_is_larger_0_value : boolean_3d(0 to 4, 0 to 2, 1 to 4);  -- _2#_2#_value_#
    variable transform_left_filter_low_is_larger_0_choice_3,
      transform_right_filter_low_is_larger_0_choice_3 : boolean_2d(0 to 4, 0 to 2);  -- _2#_2#_choice_3
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 3);  -- _value_#
    variable transform_left_filter_feature_0_choice : boolean_1d(3 to 65);
    variable transform_left_filter_feature_0_alls : boolean_1d(1 to 4);  -- _all_#
    variable transform_right_filter_feature_0_choice : boolean_1d(3 to 70);
    variable transform_right_filter_feature_0_alls : boolean_1d(1 to 5);  -- _all_#
    variable transform_counter_group_choice, raster_place_group_choice, costsshift_count_phase_choice,
      costswindow_read_count_phase_choice, costswindow_write_count_phase_choice, pathsleft_read_count_phase_choice,
      pathsleft_ahead_count_phase_choice, pathsleft_write_count_phase_choice, pathsabove_memory_read_address_1_choice,
      pathsabove_read_address_count_phase_choice, pathsabove_count_phase_choice,
      pathsabove_write_address_count_phase_choice, pathsturn_read_address_count_phase_choice,
      pathsturn_write_address_count_phase_choice, map_counter_group_choice : natural range 0 to 15;
    variable line_order_address_choice, turn_order_address_choice : natural range 1 to 511;
    variable paths_smallest_cost_choice : natural range 0 to 21;
    variable pathsleft_stay_choice, pathsright_stay_choice : natural_127_1d(0 to 3);  -- _#_choice
    variable pathsleft_stay_value, pathsright_stay_value : natural_127_2d(1 to 2, 1 to 2);  -- _#_value_#
    variable pathsleft_step_choice, pathsright_step_choice : natural_127_2d(0 to 3, 1 to 2);  -- _#_choice_#
    variable pathsleft_stay_change_value, pathsright_stay_change_value : natural_7_1d(1 to 2);  -- _#_value
    variable pathsleft_low_0_choice, pathsright_low_0_choice : natural range 0 to 127;
    variable pathsleft_q_choices, pathsright_q_choices : natural_63_1d(1 to 2);  -- _choice_#
    variable pathsleft_room_left_choice, pathsabove_smallest_total_choice,
      pathsright_room_left_choice : natural range 0 to 63;
    variable pathsabove_memory_read_address_0_sum : natural range 1 to 8192;
    variable pathsabove_memory_read_address_0_choice,
      pathsturn_sum_memory_write_words_0_1_sum : natural range 0 to 4095;
    variable pathsabove_memory_read_address_0_sum_2, pathsturn_cost_memory_read_address_0_sum : natural range 0 to 8192;
    variable pathsabove_memory_bank_choices : natural_8191_1d(1 to 2);  -- _choice_#
    variable pathsabove_ready_top_choices : boolean_1d(1 to 2);  -- _choice_#
    variable pathsabove_total_choice : natural_31_1d(0 to 3);  -- _#_choice
    variable pathsabove_beside_choice : natural_63_1d(0 to 3);  -- _#_choice
    variable pathsabove_write_address_address_choice, pathsturn_cost_memory_bank_choice : natural range 0 to 8191;
    variable pathsabove_memory_write_words_0_choice : natural_31_2d(0 to 1, 1 to 3);  -- _#_choice_#
    variable pathsabove_memory_write_words_0_0_sum,
      pathsturn_sum_memory_write_words_0_0_sum_2 : natural range 0 to 65535;
    variable pathsabove_memory_write_words_0_all, pathsturn_sum_memory_write_words_0_all,
      pathsturn_cost_memory_write_words_0_all, map_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
    variable pathsturn_sum_memory_write_words_0_0_sum : natural range 0 to 190;
    variable winnerswinner1_best_index_0_value : boolean_2d(0 to 1, 1 to 5);  -- _#_value_#
    variable winnerswinner1_best_index_0_choice : boolean_2d(0 to 1, 7 to 8);  -- _#_choice_#
    variable winnerswinner2_best_index_0_0_values : boolean_1d(1 to 5);  -- _value_#
    variable winners_best_cost_0_0_choice : natural range 0 to 511;
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
    variable turn_ready_tag_row_start_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable turn_ready_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable turn_ready_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable map_counter_group_choices : natural_255_1d(2 to 3);  -- _choice_#
    variable map_of_column_0_b_below_a_values : boolean_1d(1 to 12);  -- _value_#
    variable map_of_column_0_b_below_a_choices : boolean_1d(1 to 9);  -- _choice_#
    variable map_of_column_0_c_below_a_values : boolean_1d(1 to 7);  -- _value_#
    variable map_of_column_0_c_below_a_choices : boolean_1d(1 to 20);  -- _choice_#
    variable map_of_column_0_c_below_b_choices : boolean_1d(1 to 6);  -- _choice_#
    variable map_sorted_low_0_choices, map_sorted_middle_0_choices, map_sorted_high_0_choices,
      map_largest_low_0_choices, map_smallest_high_0_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable map_of_low_0_b_below_a_values, map_of_middle_0_b_below_a_values, map_of_high_0_b_below_a_values,
      map_of_all_0_b_below_a_values : boolean_1d(1 to 11);  -- _value_#
    variable map_median_middle_0_choices, map_out_disparity_0_choices : natural_255_1d(1 to 4);  -- _choice_#
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    pathsabove_beside_choice := (others => 0); pathsabove_memory_write_words_0_choice := (others => (others => 0));
    pathsleft_step_choice := (others => (others => 0)); pathsright_step_choice := (others => (others => 0));
    transform_left_filter_feature_0_choice := (others => false);
    transform_left_filter_low_is_larger_0_choice_3 := (others => (others => false));
    transform_left_filter_low_is_larger_0_value := (others => (others => (others => false)));
    transform_right_filter_feature_0_choice := (others => false);
    transform_right_filter_low_is_larger_0_choice_3 := (others => (others => false));
    transform_right_filter_low_is_larger_0_value := (others => (others => (others => false)));
    winnerswinner1_best_index_0_choice := (others => (others => false));
    -- transform
    transform_counter_next_frame_is_equal := transform_counter_column = 319;
    transform_counter_frame_joins_choice := choice(transform_counter_last_column, (not transform_counter_back_to_back)
      and winnerswinner1_best_below_0, winnerswinner1_best_below_0);
    transform_counter_group_after_choice := choice(transform_counter_back_to_back, 2, (transform_counter_group + 1) mod
      256);
    transform_counter_next_frame_after_any := is_set(transform_counter_group, 3) or is_set(transform_counter_group, 2);
    transform_counter_next_frame_after_is_equal := (transform_counter_group / 16) = 15;
    transform_read_column_inside_0_is_less := 3 < transform_counter_column;
    transform_reached_first_0_value := is_set(transform_counter_group, 6);
    transform_reached_beyond_last_3_value := is_set(transform_counter_group, 4);
    transform_reached_beyond_last_3_choice := choice(is_set(transform_counter_group, 1),
      transform_reached_beyond_last_3_value, transform_reached_beyond_last_3_value and
      transform_counter_next_frame_after_any);
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
    transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
    transform_read_column_inside(1) <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
    transform_read_column_inside(2) <= true;
    transform_read_column_inside(3) <= (transform_counter_column < 6) /= transform_read_column_inside_0_is_less;
    transform_read_column_inside(4) <= (transform_counter_column < 8) /= transform_read_column_inside_0_is_less;
    transform_read_start_of_frame <= (transform_counter_column = 4) and (transform_counter_group = 2);
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
    transform_reached_first(0) <= (((transform_counter_group / 4) mod 16) /= 0) or is_set(transform_counter_group, 7)
      or transform_reached_first_0_value;
    transform_reached_first(1) <= (((transform_counter_group / 2) mod 16) /= 0) or is_set(transform_counter_group, 7)
      or transform_reached_first_0_value or is_set(transform_counter_group, 5);
    transform_reached_first(2) <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
    transform_reached_beyond_last(2) <= transform_counter_next_frame_after_is_equal;
    transform_reached_beyond_last(3) <= transform_reached_beyond_last_3_choice and ((transform_counter_group / 32) = 7);
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
      winnerswinner1_best_below_0);
    transform_counter_column_after <= choice(transform_counter_last_column, 0, (transform_counter_column + 1) mod 512);
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
      transform_counter_group <= choice(in_start_of_frame, transform_counter_group_choice * 16,
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
    raster_place_next_frame_is_equal := raster_place_column = 319;
    raster_place_back_to_back_choice := choice(raster_place_last_column, (not raster_place_frame_joins) and
      transform_read_row_inside_0, transform_read_row_inside_0);
    raster_place_group_after_choice := choice(raster_place_frame_joins, 1, (raster_place_group + 1) mod 256);
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(2);
    raster_place_next_frame <= raster_place_next_frame_is_equal and (raster_place_group = 239);
    raster_place_last_column <= raster_place_next_frame_is_equal;
    raster_place_counts <= (not is_set(raster_place_group, 7)) or (not is_set(raster_place_group, 6)) or (not
      is_set(raster_place_group, 5)) or (not is_set(raster_place_group, 4));
    raster_place_frame_joins <= transform_read_row_inside_0 and (raster_place_group = 240);
    raster_place_back_to_back <= choice(delay_row_inside(2), raster_place_back_to_back_choice,
      transform_read_row_inside_0);
    raster_place_column_after <= choice(raster_place_last_column, 0, (raster_place_column + 1) mod 512);
    raster_place_group_after <= choice((not delay_row_inside(2)) or (not raster_place_last_column), raster_place_group,
      raster_place_group_after_choice);
    raster_place_group_choice := choice(raster_place_next_frame, 15, 0);
    if transform_filtering_valid(2) then
      raster_place_column <= choice(transform_filtering_start_of_frame(2), 0, raster_place_column_after);
      raster_place_group <= choice(transform_filtering_start_of_frame(2), raster_place_group_choice * 16,
        raster_place_group_after);
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
    delay_tag.valid <= raster_features_valid;
    delay_tag.border_column <= raster_place_column < 63;
    delay_tag.first_cost <= delay_tag_first_cost_is_equal;
    delay_tag.map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and
      delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 1);
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
    rows_read_tag.valid <= delay_tag.valid;
    rows_read_tag.border_column <= delay_tag.border_column;
    rows_read_tag.first_cost <= delay_tag.first_cost;
    rows_read_tag.map_column <= delay_tag.map_column;
    rows_read_tag.output_column <= delay_tag.output_column;
    rows_read_tag.start_of_frame <= delay_tag.start_of_frame;
    rows_read_tag.end_of_line <= raster_place_last_column;
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
      line_centre_first_column_0 <= rows_tag.first_cost;
      line_centre_start_of_frame_0 <= rows_tag.start_of_frame;
      line_centre_end_of_line_0 <= rows_tag.end_of_line;
      line_order_inside <= line_centre_map_column_0;
      line_newest_first_column <= line_centre_first_column_0;
      line_newest_top <= line_centre_start_of_frame_0;
    end if;
    line_order_address_any := (not line_centre_map_column_0) or line_order_inside or (not rows_tag.valid);
    line_order_address_choice := choice(line_order_falls, 511, 1);
    if not ((not line_centre_map_column_0) or (not rows_tag.valid)) then
      line_order_address <= choice(line_order_address_any, (line_order_address_choice + line_order_address) mod 512,
        as_number((not line_order_falls)) * 256);
    end if;
    line_order_falls_all := line_centre_map_column_0 and (not line_order_inside) and rows_tag.valid;
    line_order_turned_output_column_choice := choice(line_order_falls_all, line_order_output and line_order_complete,
      line_order_held_output);
    line_order_turned_valid <= rows_tag.valid;
    line_order_turned_map_column <= line_centre_map_column_0;
    line_order_turned_output_column <= line_order_turned_output_column_choice and line_centre_map_column_0;
    line_order_turned_start_of_frame <= line_centre_map_column_0 and (not line_order_inside) and rows_tag.valid and
      line_order_first and line_order_output and line_order_complete;
    line_order_turned_end_of_line <= line_centre_end_of_line_0;
    line_comes(1) <= line_order_turned_valid;
    line_comes(2 to 47) <= line_comes(1 to 46);
    line_starts_phases(1) <= line_order_inside and line_order_turned_valid;
    line_starts_phases(2 to 26) <= line_starts_phases(1 to 25);
    line_starts_phases(27) <= pathsleft_read_count_phase = 0;
    line_starts_phases(28) <= pathsleft_is_first;
    line_starts_phases(29 to 47) <= line_starts_phases(28 to 46);
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
    if rows_tag.valid then
      costsshift_newest <= rows_search;
      costsshift_new_reference <= rows_reference;
      costsshift_new_tag.border_column <= rows_tag.border_column;
    end if;
    costsshift_count_phase_choice := choice(costsshift_count_phase = 15, 15, (costsshift_count_phase + 1) mod 16);
    costsshift_new_tag.valid <= (costsshift_count_phase /= 15) or rows_tag.valid;
    costsshift_handed_on(0) <= to_integer(costsshift_read_words(1)(27 downto 14));
    costsshift_handed_on(1) <= to_integer(costsshift_read_words(3)(27 downto 14));
    costsshift_handed_on(2) <= to_integer(costsshift_read_words(5)(27 downto 14));
    costsshift_read_reference <= costsshift_new_reference;
    costsshift_read_tag <= costsshift_new_tag;
    costsshift_read_count_phase <= costsshift_count_phase;
    costsshift_reference <= costsshift_read_reference;
    costsshift_tag_border_column <= costsshift_read_tag.border_column;
    costsshift_write_phase <= costsshift_read_count_phase;
    costsshift_count_phase <= choice(rows_tag.valid, 0, costsshift_count_phase_choice);
    costsshift_search_0_0_is_equal := costsshift_read_count_phase = 0;
    if costsshift_read_tag.valid then
      for i in 0 to 2 loop
        costsshift_search(i, 1) <= to_integer(costsshift_read_words(2 * i)(13 downto 0));
        costsshift_search(i, 2) <= to_integer(costsshift_read_words(2 * i)(27 downto 14));
        costsshift_search(i, 3) <= to_integer(costsshift_read_words(2 * i + 1)(13 downto 0));
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
      for j in 1 to 3 loop
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
    costscolumn_pixels_first_tag_border_column <= costsshift_tag_border_column;
    for i in 0 to 2 loop
      for j in 0 to 3 loop
        costscolumn_pixels_cost(i, j) <= costscolumn_pixels_first_count(i, j, 3) + costscolumn_pixels_first_count(i, j,
          0) + costscolumn_pixels_first_count(i, j, 1) + costscolumn_pixels_first_count_4(i, j) +
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
    for i in 0 to 3 loop
      costscolumn_column_0(i) <= choice(costscolumn_pair_tag_border_column, 0, costscolumn_pair_0(i) +
        costscolumn_single_0(i));
    end loop;
    -- costswindow
    costswindow_read_count_phase_choice := choice(costswindow_read_count_phase = 15, 15, (costswindow_read_count_phase
      + 1) mod 16);
    costswindow_write_count_phase_choice := choice(costswindow_write_count_phase = 15, 15,
      (costswindow_write_count_phase + 1) mod 16);
    for i in 0 to 3 loop
      costswindow_sum_0(i) <= costscolumn_column_0(i) + to_integer(costswindow_read_words_1(7 * i + 6 downto 7 * i));
    end loop;
    costswindow_read_count_phase <= choice(line_comes(4), 0, costswindow_read_count_phase_choice);
    costswindow_write_count_phase <= choice(line_comes(6), 0, costswindow_write_count_phase_choice);
    costswindow_partial_0_any := (costswindow_write_count_phase /= 15) or line_comes(6);
    if costswindow_partial_0_any then
      costswindow_partial <= costscolumn_column_0;
      for i in 4 to 6 loop
        costswindow_partials(i) <= costscolumn_column_0(i - 4) + to_integer(costswindow_read_words_0(7 * i - 23 downto
          7 * i - 28));
      end loop;
      costswindow_partials(7) <= to_integer(costswindow_read_words_0(26 downto 21)) + costscolumn_column_0(3);
    end if;
    -- costs
    for i in 0 to 3 loop
      costs_cost(i) <= choice(is_set(costswindow_sum_0(i), 7) or is_set(costswindow_sum_0(i), 6) or
        (((costswindow_sum_0(i) / 16) mod 4) = 3), 5, costswindow_sum_0(i) / 8);
    end loop;
    -- paths
    paths_smallest_cost_choice := choice(line_comes(10), 7, paths_smallest_cost);
    paths_cost_delay_ring_write_address <= paths_cost_delay_ring_read_address;
    paths_sum(0) <= (pathsturn_sum_memory_ready_words(0) mod 128) + pathsright_cost(0);
    paths_sum(1) <= ((pathsturn_sum_memory_ready_words(0) / 128) mod 128) + pathsright_cost(1);
    paths_sum(2) <= ((pathsturn_sum_memory_ready_words(1) mod 32) * 4) + (pathsturn_sum_memory_ready_words(0) / 16384)
      + pathsright_cost(2);
    paths_sum(3) <= (pathsturn_sum_memory_ready_words(1) / 32) + pathsright_cost(3);
    paths_tree_smallest(0) <= smaller(costs_cost(1), costs_cost(0));
    paths_tree_smallest(1) <= smaller(costs_cost(3), costs_cost(2));
    paths_tree_next_smallest_0 <= smaller(paths_tree_smallest(1), paths_tree_smallest(0));
    paths_smallest_cost <= smaller(paths_tree_next_smallest_0, paths_smallest_cost_choice);
    paths_cost_delay_ring_read_address <= choice(paths_cost_delay_ring_read_address = 18, 0,
      (paths_cost_delay_ring_read_address + 1) mod 32);
    -- pathsleft
    if line_starts_phases(21) then pathsleft_low_address <= (pathsleft_low_address + 1) mod 16; end if;
    pathsleft_read_count_phase_is_equal := pathsleft_read_count_phase = 15;
    pathsleft_read_count_phase_choice := choice(pathsleft_read_count_phase_is_equal, 15, (pathsleft_read_count_phase +
      1) mod 16);
    pathsleft_ahead_count_phase_choice := choice(pathsleft_ahead_count_phase = 15, 15, (pathsleft_ahead_count_phase +
      1) mod 16);
    pathsleft_stay_choice(0) := smaller(to_integer(pathsleft_read_words(1)(6 downto 0)),
      to_integer(pathsleft_read_words(0)(6 downto 0)));
    pathsleft_stay_value(1, 1) := to_integer(pathsleft_read_words(1)(13 downto 7));
    pathsleft_stay_value(1, 2) := to_integer(pathsleft_read_words(0)(13 downto 7));
    pathsleft_stay_choice(1) := smaller(pathsleft_stay_value(1, 1), pathsleft_stay_value(1, 2));
    pathsleft_stay_value(2, 1) := to_integer(pathsleft_read_words(1)(20 downto 14));
    pathsleft_stay_value(2, 2) := to_integer(pathsleft_read_words(0)(20 downto 14));
    pathsleft_stay_choice(2) := smaller(pathsleft_stay_value(2, 1), pathsleft_stay_value(2, 2));
    pathsleft_stay_choice(3) := smaller(to_integer(pathsleft_read_words(1)(27 downto 21)),
      to_integer(pathsleft_read_words(0)(27 downto 21)));
    pathsleft_step_choice(0, 1) := choice(line_starts_phases(27), pathsleft_stay_value(1, 2),
      pathsleft_lower_neighbour);
    pathsleft_step_choice(0, 2) := smaller(pathsleft_stay_value(1, 2), pathsleft_step_choice(0, 1));
    pathsleft_step_choice(1, 1) := smaller(pathsleft_stay_value(2, 2), to_integer(pathsleft_read_words(0)(6 downto 0)));
    pathsleft_step_choice(2, 1) := smaller(to_integer(pathsleft_read_words(0)(27 downto 21)), pathsleft_stay_value(1,
      2));
    pathsleft_step_choice(3, 1) := choice(pathsleft_is_last, pathsleft_stay_value(2, 2),
      to_integer(pathsleft_read_neighbour_0));
    pathsleft_step_choice(3, 2) := smaller(pathsleft_step_choice(3, 1), pathsleft_stay_value(2, 2));
    pathsleft_stay_change_value(1) := to_integer(paths_cost_delay_held_0(5 downto 0)) / 8;
    pathsleft_stay_change_value(2) := to_integer(paths_cost_delay_held_0(8 downto 6));
    pathsleft_write_count_phase_choice := choice(pathsleft_write_count_phase = 15, 15, (pathsleft_write_count_phase +
      1) mod 16);
    pathsleft_low_0_choice := choice(line_comes(31), 127, pathsleft_low_0);
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
    pathsleft_read_count_phase <= choice(line_starts_phases(25), 0, pathsleft_read_count_phase_choice);
    pathsleft_ahead_count_phase <= choice(line_starts_phases(24), 0, pathsleft_ahead_count_phase_choice);
    for i in 0 to 3 loop
      pathsleft_stay(i) <= choice((not is_set(pathsleft_stay_choice(i), 6)) and (not pathsleft_first),
        pathsleft_stay_choice(i), 64);
    end loop;
    pathsleft_step(0) <= choice(pathsleft_first, 64, pathsleft_step_choice(0, 2));
    pathsleft_step(1) <= choice(pathsleft_first, 64, pathsleft_step_choice(1, 1));
    pathsleft_step(2) <= choice(pathsleft_first, 64, pathsleft_step_choice(2, 1));
    pathsleft_step(3) <= choice(pathsleft_first, 64, pathsleft_step_choice(3, 2));
    pathsleft_write_count_phase <= choice(line_starts_phases(28), 0, pathsleft_write_count_phase_choice);
    pathsleft_tree_smallest(0) <= smaller(pathsleft_cost(1), pathsleft_cost(0));
    pathsleft_tree_smallest(1) <= smaller(pathsleft_cost(3), pathsleft_cost(2));
    pathsleft_tree_next_smallest_0 <= smaller(pathsleft_tree_smallest(1), pathsleft_tree_smallest(0));
    pathsleft_low_0 <= smaller(pathsleft_tree_next_smallest_0, pathsleft_low_0_choice);
    pathsleft_q_choices(1) := choice(pathsright_short_of, pathsleft_missing, 0);
    pathsleft_q_choices(2) := choice(pathsleft_lost, pathsleft_room, pathsleft_q_choices(1));
    pathsleft_room_left_choice := choice(pathsright_short_of, pathsleft_below, pathsleft_room);
    if line_starts_phases(24) then
      pathsleft_q <= choice(line_places_first_column(1), 60, pathsleft_q_choices(2));
      pathsleft_room_left <= choice(pathsleft_lost, 0, pathsleft_room_left_choice);
    end if;
    if line_starts_phases(25) then
      pathsleft_q_now <= pathsleft_q;
      pathsleft_q_less <= (pathsleft_q + 121) mod 128;
      pathsleft_room <= choice(line_places_first_column(1), 0, (pathsleft_room_left + pathsleft_start_cost(8)) mod 64);
      pathsleft_start_cost(1) <= choice(line_places_first_column(1), 0, pathsleft_q_now);
      for i in 2 to 8 loop
        pathsleft_start_cost(i) <= choice(line_places_first_column(1), 0, pathsleft_start_cost(i - 1));
      end loop;
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
    if line_starts_phases(47) then pathsleft_low_write_address <= (pathsleft_low_write_address + 1) mod 16; end if;
    -- pathsabove
    pathsabove_memory_read_address_0_sum := pathsabove_read_address_address + 1;
    pathsabove_memory_read_address_0_choice := choice(line_places_first_column(0), 0,
      pathsabove_memory_read_address_0_sum mod 4096);
    pathsabove_memory_read_address_0_sum_2 := pathsabove_read_address_address + as_number(((not
      is_set(pathsabove_read_address_count_phase, 3)) or (not is_set(pathsabove_read_address_count_phase, 2)) or (not
      is_set(pathsabove_read_address_count_phase, 1)) or (not is_set(pathsabove_read_address_count_phase, 0))));
    pathsabove_memory_read_address_1_choice := choice(line_places_first_column(0), 0,
      pathsabove_memory_read_address_0_sum mod 16);
    pathsabove_memory_bank_choices(1) := choice(line_places_first_column(0), 0, pathsabove_memory_read_address_0_sum
      mod 8192);
    pathsabove_memory_bank_choices(2) := choice(line_starts_phases(4), pathsabove_memory_bank_choices(1),
      pathsabove_memory_read_address_0_sum_2 mod 8192);
    pathsabove_read_address_count_phase_choice := choice(pathsabove_read_address_count_phase = 15, 15,
      (pathsabove_read_address_count_phase + 1) mod 16);
    pathsabove_ready_top_choices(1) := choice(line_starts_phases(7), line_places_first_column(0) or
      pathsabove_ready_top, pathsabove_ready_top);
    pathsabove_ready_top_choices(2) := choice(line_starts_phases(7), (not line_places_first_column(0)) and
      pathsabove_ready_top, pathsabove_ready_top);
    pathsabove_total_choice(0) := choice(pathsabove_ready_top, 31, pathsabove_memory_ready_words(0) mod 32);
    pathsabove_total_choice(1) := choice(pathsabove_ready_top, 31, (pathsabove_memory_ready_words(0) / 32) mod 32);
    pathsabove_total_choice(2) := choice(pathsabove_ready_top, 31, (pathsabove_memory_ready_words(0) / 1024) mod 32);
    pathsabove_total_choice(3) := choice(pathsabove_ready_top, 31, (pathsabove_memory_ready_words(1) * 2) +
      (pathsabove_memory_ready_words(0) / 32768));
    pathsabove_smallest_total_choice := choice(line_comes(11), 63, pathsabove_smallest_total);
    pathsabove_count_phase_is_equal := pathsabove_count_phase = 15;
    pathsabove_count_phase_choice := choice(pathsabove_count_phase_is_equal, 15, (pathsabove_count_phase + 1) mod 16);
    pathsabove_beside_choice(0) := choice(pathsabove_count_phase = 0, pathsabove_held(1), pathsabove_lower_neighbour);
    pathsabove_beside_choice(3) := choice(pathsabove_count_phase_is_equal, pathsabove_held(2), pathsabove_cost(0));
    pathsabove_write_address_address_choice := choice(line_places_first_column(1), 0, (pathsabove_write_address_address
      + 1) mod 8192);
    pathsabove_write_address_count_phase_choice := choice(pathsabove_write_address_count_phase = 15, 15,
      (pathsabove_write_address_count_phase + 1) mod 16);
    pathsabove_memory_bank <= is_set(pathsabove_memory_bank_choices(2), 12);
    pathsabove_memory_read_bank <= pathsabove_memory_bank;
    pathsabove_memory_held_words_0(0) <= to_integer(pathsabove_memory_read_words_0(0));
    pathsabove_memory_held_words_1(0) <= to_integer(pathsabove_memory_read_words_1(0));
    pathsabove_memory_held_words_0(1) <= to_integer(pathsabove_memory_read_words_0(1));
    pathsabove_memory_held_words_1(1) <= to_integer(pathsabove_memory_read_words_1(1));
    pathsabove_memory_held_bank <= pathsabove_memory_read_bank;
    pathsabove_read_address_address <= pathsabove_memory_bank_choices(2);
    pathsabove_total(0) <= costs_cost(0) + pathsabove_total_choice(0);
    pathsabove_total(1) <= costs_cost(1) + pathsabove_total_choice(1);
    pathsabove_total(2) <= costs_cost(2) + pathsabove_total_choice(2);
    pathsabove_total(3) <= costs_cost(3) + pathsabove_total_choice(3);
    pathsabove_cost(0) <= (to_integer(pathsabove_delay_held_0) - pathsabove_smallest) mod 64;
    pathsabove_cost(1) <= (to_integer(pathsabove_delay_held_0(23 downto 6)) - pathsabove_smallest) mod 64;
    pathsabove_cost(2) <= (to_integer(pathsabove_delay_held_0(23 downto 12)) - pathsabove_smallest) mod 64;
    pathsabove_cost(3) <= (to_integer(pathsabove_delay_held_0(23 downto 18)) - pathsabove_smallest) mod 64;
    pathsabove_held <= pathsabove_cost;
    pathsabove_lower_neighbour <= pathsabove_held(3);
    pathsabove_own <= pathsabove_held(0 to 2);
    pathsabove_step(0) <= pathsabove_beside(0) + 5;
    pathsabove_step(1) <= pathsabove_beside(1) + 5;
    pathsabove_step(2) <= pathsabove_beside(2) + 5;
    pathsabove_step(3) <= pathsabove_beside(3) + 5;
    pathsabove_write_address_is_here <= (pathsabove_write_address_count_phase /= 15) or line_starts_phases(31);
    pathsabove_memory_read_address_0 <= choice(line_starts_phases(4), pathsabove_memory_read_address_0_choice,
      pathsabove_memory_read_address_0_sum_2 mod 4096);
    pathsabove_memory_read_address_1 <= choice(line_starts_phases(4), pathsabove_memory_read_address_1_choice,
      pathsabove_memory_read_address_0_sum_2 mod 16);
    pathsabove_read_address_count_phase <= choice(line_starts_phases(4), 0, pathsabove_read_address_count_phase_choice);
    pathsabove_memory_ready_words(0) <= choice(pathsabove_memory_held_bank, pathsabove_memory_held_words_0(1),
      pathsabove_memory_held_words_0(0));
    pathsabove_memory_ready_words(1) <= choice(pathsabove_memory_held_bank, pathsabove_memory_held_words_1(1),
      pathsabove_memory_held_words_1(0));
    pathsabove_ready_top <= choice(line_places_0_top, pathsabove_ready_top_choices(1), pathsabove_ready_top_choices(2));
    pathsabove_tree_smallest(0) <= smaller(pathsabove_total(1), pathsabove_total(0));
    pathsabove_tree_smallest(1) <= smaller(pathsabove_total(3), pathsabove_total(2));
    pathsabove_tree_next_smallest_0 <= smaller(pathsabove_tree_smallest(1), pathsabove_tree_smallest(0));
    pathsabove_smallest_total <= smaller(pathsabove_tree_next_smallest_0, pathsabove_smallest_total_choice);
    pathsabove_count_phase <= choice(line_starts_phases(29), 0, pathsabove_count_phase_choice);
    pathsabove_beside(0) <= smaller(pathsabove_held(1), pathsabove_beside_choice(0));
    pathsabove_beside(1) <= smaller(pathsabove_held(2), pathsabove_held(0));
    pathsabove_beside(2) <= smaller(pathsabove_held(3), pathsabove_held(1));
    pathsabove_beside(3) <= smaller(pathsabove_beside_choice(3), pathsabove_held(2));
    pathsabove_stay(0) <= choice(pathsabove_own(0) < 31, pathsabove_own(0) mod 32, 31);
    pathsabove_stay(1) <= choice(pathsabove_own(1) < 31, pathsabove_own(1) mod 32, 31);
    pathsabove_stay(2) <= choice(pathsabove_own(2) < 31, pathsabove_own(2) mod 32, 31);
    pathsabove_stay(3) <= choice(pathsabove_lower_neighbour < 31, pathsabove_lower_neighbour mod 32, 31);
    pathsabove_write_address_address <= choice(line_starts_phases(31), pathsabove_write_address_address_choice,
      (pathsabove_write_address_address + as_number(((not is_set(pathsabove_write_address_count_phase, 3)) or (not
      is_set(pathsabove_write_address_count_phase, 2)) or (not is_set(pathsabove_write_address_count_phase, 1)) or (not
      is_set(pathsabove_write_address_count_phase, 0))))) mod 8192);
    pathsabove_write_address_count_phase <= choice(line_starts_phases(31), 0,
      pathsabove_write_address_count_phase_choice);
    pathsabove_memory_write_words_0_choice(0, 1) := choice((pathsabove_step(1) - pathsabove_stay(1)) < 0,
      pathsabove_step(1) mod 32, pathsabove_stay(1));
    pathsabove_memory_write_words_0_choice(0, 2) := choice((pathsabove_step(0) - pathsabove_stay(0)) < 0,
      pathsabove_step(0) mod 32, pathsabove_stay(0));
    pathsabove_memory_write_words_0_choice(0, 3) := choice((pathsabove_step(2) - pathsabove_stay(2)) < 0,
      pathsabove_step(2) mod 32, pathsabove_stay(2));
    pathsabove_memory_write_words_0_0_is_less := (pathsabove_step(3) - pathsabove_stay(3)) < 0;
    pathsabove_memory_write_words_0_0_choice_4 := choice(pathsabove_memory_write_words_0_0_is_less,
      is_set(pathsabove_step(3), 0), is_set(pathsabove_stay(3), 0));
    pathsabove_memory_write_words_0_0_sum := (pathsabove_memory_write_words_0_choice(0, 1) * 32) +
      pathsabove_memory_write_words_0_choice(0, 2) + (pathsabove_memory_write_words_0_choice(0, 3) * 1024) +
      (as_number(pathsabove_memory_write_words_0_0_choice_4) * 32768);
    pathsabove_memory_write_words_0_choice(1, 1) := choice(pathsabove_memory_write_words_0_0_is_less,
      pathsabove_step(3) mod 32, pathsabove_stay(3));
    pathsabove_memory_write_words_0_all(0) := pathsabove_write_address_is_here and (pathsabove_write_address_address <
      4096);
    if pathsabove_memory_write_words_0_all(0) then
      pathsabove_memory_write_words_0(0) <= pathsabove_memory_write_words_0_0_sum;
      pathsabove_memory_write_words_1(0) <= pathsabove_memory_write_words_0_choice(1, 1) / 2;
      pathsabove_memory_write_address_0 <= pathsabove_write_address_address mod 4096;
    end if;
    pathsabove_memory_write_words_0_all(1) := (4095 < pathsabove_write_address_address) and
      pathsabove_write_address_is_here;
    if pathsabove_memory_write_words_0_all(1) then
      pathsabove_memory_write_words_0(1) <= pathsabove_memory_write_words_0_0_sum;
      pathsabove_memory_write_words_1(1) <= pathsabove_memory_write_words_0_choice(1, 1) / 2;
      pathsabove_memory_write_address_1 <= pathsabove_write_address_address mod 16;
    end if;
    if line_comes(27) then pathsabove_smallest <= pathsabove_smallest_total; end if;
    -- pathsturn
    pathsturn_cost_memory_read_address_0_sum := pathsturn_read_address_address + as_number(((not
      is_set(pathsturn_read_address_count_phase, 3)) or (not is_set(pathsturn_read_address_count_phase, 2)) or (not
      is_set(pathsturn_read_address_count_phase, 1)) or (not is_set(pathsturn_read_address_count_phase, 0))));
    pathsturn_cost_memory_bank_choice := choice(line_starts_phases(23), line_places_address(1) * 16,
      pathsturn_cost_memory_read_address_0_sum mod 8192);
    pathsturn_read_address_count_phase_choice := choice(pathsturn_read_address_count_phase = 15, 15,
      (pathsturn_read_address_count_phase + 1) mod 16);
    pathsturn_write_address_count_phase_choice := choice(pathsturn_write_address_count_phase = 15, 15,
      (pathsturn_write_address_count_phase + 1) mod 16);
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
    pathsturn_sum_memory_ready_words(0) <= choice(pathsturn_sum_memory_held_bank, pathsturn_sum_memory_held_words_0(1),
      pathsturn_sum_memory_held_words_0(0));
    pathsturn_sum_memory_ready_words(1) <= choice(pathsturn_sum_memory_held_bank, pathsturn_sum_memory_held_words_1(1),
      pathsturn_sum_memory_held_words_1(0));
    pathsturn_cost_memory_read_address_0 <= choice(line_starts_phases(23), (line_places_address(1) mod 256) * 16,
      pathsturn_cost_memory_read_address_0_sum mod 4096);
    pathsturn_cost_memory_read_address_1 <= choice(line_starts_phases(23), 0, pathsturn_cost_memory_read_address_0_sum
      mod 16);
    pathsturn_read_address_count_phase <= choice(line_starts_phases(23), 0, pathsturn_read_address_count_phase_choice);
    pathsturn_cost_memory_ready_words_0 <= choice(pathsturn_sum_memory_bank, pathsturn_cost_memory_held_words_0(1),
      pathsturn_cost_memory_held_words_0(0));
    pathsturn_write_smallest_address <= choice(line_starts_phases(26), line_places_address(1), 257);
    pathsturn_write_address_address <= choice(line_starts_phases(26), line_places_address(1) * 16,
      (pathsturn_write_address_address + as_number(((not is_set(pathsturn_write_address_count_phase, 3)) or (not
      is_set(pathsturn_write_address_count_phase, 2)) or (not is_set(pathsturn_write_address_count_phase, 1)) or (not
      is_set(pathsturn_write_address_count_phase, 0))))) mod 8192);
    pathsturn_write_address_count_phase <= choice(line_starts_phases(26), 0,
      pathsturn_write_address_count_phase_choice);
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
    pathsturn_cost_memory_write_words_0_all(0) := pathsturn_write_address_is_here and (pathsturn_write_address_address
      < 4096);
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
    if line_starts_phases(23) then pathsturn_smallest_address <= line_places_address(1); end if;
    -- pathsright
    pathsright_stay_choice(0) := smaller(to_integer(pathsright_read_words(1)(6 downto 0)),
      to_integer(pathsright_read_words(0)(6 downto 0)));
    pathsright_stay_value(1, 1) := to_integer(pathsright_read_words(1)(13 downto 7));
    pathsright_stay_value(1, 2) := to_integer(pathsright_read_words(0)(13 downto 7));
    pathsright_stay_choice(1) := smaller(pathsright_stay_value(1, 1), pathsright_stay_value(1, 2));
    pathsright_stay_value(2, 1) := to_integer(pathsright_read_words(1)(20 downto 14));
    pathsright_stay_value(2, 2) := to_integer(pathsright_read_words(0)(20 downto 14));
    pathsright_stay_choice(2) := smaller(pathsright_stay_value(2, 1), pathsright_stay_value(2, 2));
    pathsright_stay_choice(3) := smaller(to_integer(pathsright_read_words(1)(27 downto 21)),
      to_integer(pathsright_read_words(0)(27 downto 21)));
    pathsright_step_choice(0, 1) := choice(line_starts_phases(27), pathsright_stay_value(1, 2),
      pathsright_lower_neighbour);
    pathsright_step_choice(0, 2) := smaller(pathsright_stay_value(1, 2), pathsright_step_choice(0, 1));
    pathsright_step_choice(1, 1) := smaller(pathsright_stay_value(2, 2), to_integer(pathsright_read_words(0)(6 downto
      0)));
    pathsright_step_choice(2, 1) := smaller(to_integer(pathsright_read_words(0)(27 downto 21)),
      pathsright_stay_value(1, 2));
    pathsright_step_choice(3, 1) := choice(pathsleft_is_last, pathsright_stay_value(2, 2),
      to_integer(pathsright_read_neighbour_0));
    pathsright_step_choice(3, 2) := smaller(pathsright_step_choice(3, 1), pathsright_stay_value(2, 2));
    pathsright_stay_change_value(1) := (pathsturn_cost_memory_ready_words_0 mod 64) / 8;
    pathsright_stay_change_value(2) := (pathsturn_cost_memory_ready_words_0 / 64) mod 8;
    pathsright_low_0_choice := choice(line_comes(31), 127, pathsright_low_0);
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
    pathsright_stay(0) <= choice((not pathsleft_first) and (not is_set(pathsright_stay_choice(0), 6)),
      pathsright_stay_choice(0), 64);
    for i in 1 to 3 loop
      pathsright_stay(i) <= choice((not is_set(pathsright_stay_choice(i), 6)) and (not pathsleft_first),
        pathsright_stay_choice(i), 64);
    end loop;
    pathsright_step(0) <= choice(pathsleft_first, 64, pathsright_step_choice(0, 2));
    pathsright_step(1) <= choice(pathsleft_first, 64, pathsright_step_choice(1, 1));
    pathsright_step(2) <= choice(pathsleft_first, 64, pathsright_step_choice(2, 1));
    pathsright_step(3) <= choice(pathsleft_first, 64, pathsright_step_choice(3, 2));
    pathsright_tree_smallest(0) <= smaller(pathsright_cost(1), pathsright_cost(0));
    pathsright_tree_smallest(1) <= smaller(pathsright_cost(3), pathsright_cost(2));
    pathsright_tree_next_smallest_0 <= smaller(pathsright_tree_smallest(1), pathsright_tree_smallest(0));
    pathsright_low_0 <= smaller(pathsright_tree_next_smallest_0, pathsright_low_0_choice);
    pathsright_q_choices(1) := choice(pathsleft_short_of, pathsright_missing, 0);
    pathsright_q_choices(2) := choice(pathsright_lost, pathsright_room, pathsright_q_choices(1));
    pathsright_room_left_choice := choice(pathsleft_short_of, pathsright_below, pathsright_room);
    if line_starts_phases(24) then
      pathsright_q <= choice(line_places_first_column(1), 60, pathsright_q_choices(2));
      pathsright_room_left <= choice(pathsright_lost, 0, pathsright_room_left_choice);
    end if;
    if line_starts_phases(25) then
      pathsright_q_now <= pathsright_q;
      pathsright_q_less <= (pathsright_q + 121) mod 128;
      pathsright_room <= choice(line_places_first_column(1), 0, (pathsright_room_left + pathsright_start_cost(8)) mod
        64);
      pathsright_start_cost(1) <= choice(line_places_first_column(1), 0, pathsright_q_now);
      for i in 2 to 8 loop
        pathsright_start_cost(i) <= choice(line_places_first_column(1), 0, pathsright_start_cost(i - 1));
      end loop;
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
    for i in 1 to 5 loop winnerswinner1_best_index_0_value(0, i) := is_set(paths_sum(1), i + 1); end loop;
    winnerswinner1_best_index_0_choice(0, 7) := not is_larger(paths_sum(0), paths_sum(1), 0, 6, false);
    for i in 1 to 5 loop winnerswinner1_best_index_0_value(1, i) := is_set(paths_sum(3), i + 1); end loop;
    winnerswinner1_best_index_0_choice(1, 8) := is_larger(paths_sum(2), paths_sum(3), 0, 7, false);
    winnerswinner1_best_cost_0(0) <= smaller(paths_sum(1), paths_sum(0));
    winnerswinner1_best_cost_0(1) <= smaller(paths_sum(3), paths_sum(2));
    winnerswinner1_best_index_0_0 <= inverted_carry(winnerswinner1_best_index_0_choice(0, 7), is_set(paths_sum(0), 7),
      not is_set(paths_sum(1), 7));
    winnerswinner1_best_index_0_1 <= choice(winnerswinner1_best_index_0_choice(1, 8), 3, 2);
    if in_valid then
      winnerswinner1_best_below_0 <= choice(in_start_of_frame, transform_counter_next_frame,
        transform_counter_frame_joins);
    end if;
    -- winnerswinner2
    for i in 1 to 5 loop
      winnerswinner2_best_index_0_0_values(i) := is_set(winnerswinner1_best_cost_0(1), i + 1);
    end loop;
    winnerswinner2_best_index_0_0_choice_8 := is_larger(winnerswinner1_best_cost_0(0), winnerswinner1_best_cost_0(1),
      0, 7, false);
    winnerswinner2_best_cost_0_0 <= smaller(winnerswinner1_best_cost_0(1), winnerswinner1_best_cost_0(0));
    winnerswinner2_best_index_0_0 <= choice(winnerswinner2_best_index_0_0_choice_8, winnerswinner1_best_index_0_1,
      as_number(winnerswinner1_best_index_0_0));
    -- winners
    winners_best_cost_0_0_choice := choice(line_comes(32), 511, winners_best_cost_0_0);
    winners_best_cost_0_0_choice_2 := choice(line_comes(32), 255, winners_best_cost_0_0);
    winners_best_tag.valid <= line_comes(47);
    winners_best_tag.map_column <= line_places_map_column(2);
    winners_best_tag.output_column <= line_places_shown_output_column(2);
    winners_best_tag.start_of_frame <= line_places_shown_start_of_frame(2);
    winners_best_tag.end_of_line <= line_places_shown_end_of_line(2);
    winners_best_cost_0_0 <= choice((winners_best_cost_0_0_choice - winnerswinner2_best_cost_0_0) < 0,
      winners_best_cost_0_0_choice_2, winnerswinner2_best_cost_0_0);
    winners_best_index_0_0 <= choice((winnerswinner2_best_cost_0_0 - winners_best_cost_0_0_choice) < 0,
      winnerswinner2_best_index_0_0 + 60, ((((winners_best_index_0_0 / 4) + 63) mod 64) * 4) + (winners_best_index_0_0
      mod 4));
    -- turn
    turn_order_address_anys(1) := turn_order_inside or (not winners_best_tag.map_column) or (not
      winners_best_tag.valid);
    turn_order_address_choice := choice(turn_order_falls, 511, 1);
    turn_order_address_anys(2) := (not winners_best_tag.map_column) or (not winners_best_tag.valid);
    if not turn_order_address_anys(2) then
      turn_order_address <= choice(turn_order_address_anys(1), (turn_order_address_choice + turn_order_address) mod
        512, as_number((not turn_order_falls)) * 256);
    end if;
    turn_order_falls_all := (not turn_order_inside) and winners_best_tag.map_column and winners_best_tag.valid;
    turn_order_complete_all := winners_best_tag.map_column and winners_best_tag.valid;
    turn_ready_tag_row_start_is_equals(1) := map_counter_group = 240;
    turn_ready_tag_row_start_choices(1) := choice(turn_ready_tag_row_start_is_equals(1), (map_counter_column /= 256)
      and turn_ready_tag.row_start, turn_ready_tag.row_start);
    turn_ready_tag_row_start_choices(2) := choice(map_counter_group = 241, turn_ready_tag.row_start,
      turn_ready_tag_row_start_choices(1));
    turn_ready_tag_row_start_is_equals(2) := map_counter_column = 256;
    turn_ready_tag_row_start_is_equals(3) := map_counter_group = 239;
    turn_ready_tag_row_start_alls(1) := turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_row_start_is_equals(3);
    turn_ready_tag_row_start_choices(3) := choice(turn_ready_tag_row_start_choices(2), turn_ready_tag_row_start_alls(1)
      or (not turn_ready_tag.start_of_frame), turn_ready_tag_row_start_is_equals(2) and
      turn_ready_tag_row_start_is_equals(3) and turn_ready_tag.start_of_frame);
    turn_ready_tag_row_start_alls(2) := turn_ready_tag.valid and turn_ready_tag.map_column;
    turn_order_turned_valid <= winners_best_tag.valid;
    turn_order_turned_map_column <= winners_best_tag.map_column;
    turn_order_turned_start_of_frame <= (not turn_order_inside) and winners_best_tag.map_column and
      winners_best_tag.valid and turn_order_first and turn_order_complete and turn_order_output;
    turn_order_turned_end_of_line <= winners_best_tag.end_of_line;
    turn_newest <= winners_best_index_0_0 + 256;
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
    turn_order_complete <= choice(winners_best_tag.end_of_line, turn_order_complete or turn_order_complete_all,
      turn_order_complete and turn_order_address_anys(2));
    turn_write_place <= choice(turn_comes, turn_order_address, 257);
    turn_ready_tag.row_start <= choice(turn_ready_tag_row_start_choices(3), turn_ready_tag.row_start or
      turn_ready_tag_row_start_alls(2), turn_ready_tag.row_start and ((not turn_ready_tag.valid) or (not
      turn_ready_tag.map_column)));
    if winners_best_tag.valid then turn_order_inside <= winners_best_tag.map_column; end if;
    if turn_order_falls_all then
      turn_order_output <= winners_best_tag.output_column;
      turn_order_first <= winners_best_tag.start_of_frame;
    end if;
    if turn_comes then turn_write_words_0 <= turn_newest; end if;
    -- map
    if turn_ready_tag_row_start_alls(2) then
      map_counter_column <= choice(turn_ready_tag.start_of_frame or turn_ready_tag_row_start_is_equals(2), 0,
        (map_counter_column + 1) mod 512);
    end if;
    map_counter_group_choice := choice(turn_ready_tag_row_start_alls(1), 15, 0);
    map_counter_group_choices(2) := choice(turn_ready_tag_row_start_is_equals(1) and turn_ready_tag.row_start, 1,
      (map_counter_group + 1) mod 256);
    map_counter_group_choices(3) := choice((map_counter_group /= 241) and turn_ready_tag_row_start_is_equals(2) and
      turn_ready_tag.valid and turn_ready_tag.map_column, map_counter_group_choices(2), map_counter_group);
    map_line_ended_choice := choice(turn_ready_tag.valid, turn_ready_tag.map_column, map_line_ended);
    map_at_arrives_value := other(1)(16) = '1';
    map_of_column_0_b_below_a_values(1) := is_set(map_column(1), 2);
    map_of_column_0_b_below_a_choices(1) := choice(map_at_top, map_of_column_0_b_below_a_values(1), is_set(other_2, 2));
    map_of_column_0_b_below_a_values(2) := is_set(map_column(1), 1);
    map_of_column_0_b_below_a_choices(2) := choice(map_at_top, map_of_column_0_b_below_a_values(2), is_set(other_2, 1));
    map_of_column_0_b_below_a_choices(3) := choice(map_of_column_0_b_below_a_choices(2), (not
      map_of_column_0_b_below_a_values(1)) or (not map_of_column_0_b_below_a_values(2)), not
      map_of_column_0_b_below_a_values(1));
    map_of_column_0_b_below_a_choices(4) := choice(map_of_column_0_b_below_a_choices(1),
      map_of_column_0_b_below_a_choices(3), map_of_column_0_b_below_a_choices(2) and (((map_column(1) / 2) mod 4) = 0));
    map_of_column_0_b_below_a_values(3) := is_set(map_column(1), 3);
    map_of_column_0_b_below_a_values(4) := is_set(other_2, 3);
    map_of_column_0_b_below_a_choices(5) := choice(map_of_column_0_b_below_a_choices(4),
      map_of_column_0_b_below_a_values(3) and (not map_of_column_0_b_below_a_values(4)) and (not map_at_top),
      map_of_column_0_b_below_a_values(3) or (not map_of_column_0_b_below_a_values(4)) or map_at_top);
    for i in 4 to 7 loop
      map_of_column_0_b_below_a_values(2 * i - 3) := is_set(map_column(1), i);
      map_of_column_0_b_below_a_values(2 * i - 2) := is_set(other_2, i);
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
    for i in 3 to 7 loop
      map_of_column_0_c_below_a_values(i) := is_set(map_column(2), i);
      map_of_column_0_c_below_a_choices(3 * i - 5) := choice(map_counter_next_frame, map_of_column_0_b_below_a_values(2
        * i - 3), map_of_column_0_c_below_a_values(i));
      map_of_column_0_c_below_a_choices(3 * i - 4) := choice(map_at_top, map_of_column_0_b_below_a_values(2 * i - 3),
        map_of_column_0_b_below_a_values(2 * i - 2));
      map_of_column_0_c_below_a_choices(3 * i - 3) := carry(map_of_column_0_c_below_a_choices(3 * i - 6), not
        map_of_column_0_c_below_a_choices(3 * i - 5), map_of_column_0_c_below_a_choices(3 * i - 4));
    end loop;
    map_of_column_0_c_below_a_choices(19) := choice(map_counter_next_frame, is_set(map_column(1), 8),
      is_set(map_column(2), 8));
    map_of_column_0_c_below_a_choices(20) := choice(map_at_top, is_set(map_column(1), 8), is_set(other_2, 8));
    map_of_column_0_c_below_b_choices(1) := choice((not map_of_column_0_c_below_a_values(2)) and
      map_of_column_0_b_below_a_values(2) and (not map_counter_next_frame), map_of_column_0_c_below_a_values(1) and
      (not map_of_column_0_b_below_a_values(1)) and (not map_counter_next_frame), map_of_column_0_c_below_a_values(1)
      or (not map_of_column_0_b_below_a_values(1)) or map_counter_next_frame);
    for i in 2 to 6 loop
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
    for i in 2 to 6 loop
      map_of_low_0_b_below_a_values(2 * i - 2) := is_set(map_low_0(0), i);
      map_of_low_0_b_below_a_values(2 * i - 1) := is_set(map_low_0(1), i);
    end loop;
    map_of_low_0_b_below_a_choice_7 := not is_larger(map_low_0(0), map_low_0(1), 0, 6, false);
    map_of_low_0_c_below_a_value := is_set(map_low_0(2), 1);
    map_of_low_0_c_below_a_choice_7 := not is_larger(map_low_0(2), map_low_0(0), 0, 6, true);
    map_of_low_0_c_below_b_choice_7 := not is_larger(map_low_0(2), map_low_0(1), 0, 6, true);
    map_of_middle_0_b_below_a_values(1) := is_set(map_middle_0(0), 1);
    map_of_middle_0_b_below_a_is_equal := (map_middle_0(1) mod 4) = 0;
    for i in 2 to 6 loop
      map_of_middle_0_b_below_a_values(2 * i - 2) := is_set(map_middle_0(0), i);
      map_of_middle_0_b_below_a_values(2 * i - 1) := is_set(map_middle_0(1), i);
    end loop;
    map_of_middle_0_b_below_a_choice_7 := not is_larger(map_middle_0(0), map_middle_0(1), 0, 6, false);
    map_of_middle_0_c_below_a_value := is_set(map_middle_0(2), 1);
    map_of_middle_0_c_below_a_choice_7 := not is_larger(map_middle_0(2), map_middle_0(0), 0, 6, true);
    map_of_middle_0_c_below_b_choice_7 := not is_larger(map_middle_0(2), map_middle_0(1), 0, 6, true);
    map_of_high_0_b_below_a_values(1) := is_set(map_high_0(0), 1);
    map_of_high_0_b_below_a_is_equal := (map_high_0(1) mod 4) = 0;
    for i in 2 to 6 loop
      map_of_high_0_b_below_a_values(2 * i - 2) := is_set(map_high_0(0), i);
      map_of_high_0_b_below_a_values(2 * i - 1) := is_set(map_high_0(1), i);
    end loop;
    map_of_high_0_b_below_a_choice_7 := not is_larger(map_high_0(0), map_high_0(1), 0, 6, false);
    map_of_high_0_c_below_a_value := is_set(map_high_0(2), 1);
    map_of_high_0_c_below_a_choice_7 := not is_larger(map_high_0(2), map_high_0(0), 0, 6, true);
    map_of_high_0_c_below_b_choice_7 := not is_larger(map_high_0(2), map_high_0(1), 0, 6, true);
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
    for i in 2 to 6 loop
      map_of_all_0_b_below_a_values(2 * i - 2) := is_set(map_largest_low_0, i);
      map_of_all_0_b_below_a_values(2 * i - 1) := is_set(map_median_middle_0, i);
    end loop;
    map_of_all_0_b_below_a_choice_7 := not is_larger(map_largest_low_0, map_median_middle_0, 0, 6, false);
    map_of_all_0_c_below_a_value := is_set(map_smallest_high_0, 1);
    map_of_all_0_c_below_a_choice_7 := not is_larger(map_smallest_high_0, map_largest_low_0, 0, 6, true);
    map_of_all_0_c_below_b_choice_7 := not is_larger(map_smallest_high_0, map_median_middle_0, 0, 6, true);
    map_out_disparity_0_choices(1) := choice(map_of_all_0_c_below_a, map_of_all_0_c, map_of_all_0_a);
    map_out_disparity_0_choices(2) := choice(map_of_all_0_c_below_b, map_of_all_0_b, map_out_disparity_0_choices(1));
    map_out_disparity_0_choices(3) := choice(map_of_all_0_c_below_b, map_of_all_0_c, map_of_all_0_b);
    map_out_disparity_0_choices(4) := choice(map_of_all_0_c_below_a, map_of_all_0_a, map_out_disparity_0_choices(3));
    map_counter_next_frame <= other(1)(40) = '1';
    map_newest_0 <= ((turn_ready mod 256) * 2) + (turn_ready / 256);
    map_arrives <= turn_ready_tag_row_start_alls(2);
    map_behind <= map_line_ended and turn_ready_tag.valid;
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
    map_waiting_passed_0(1 to 2) <= map_waiting_passed_0(0 to 1);
    map_out_passed_0 <= map_waiting_passed_0(2);
    map_out_valid <= map_waiting_complete(2);
    map_out_start_of_frame <= map_waiting_first(2) and map_waiting_complete(2);
    map_out_end_of_line <= map_waiting_last(2) and map_waiting_complete(2);
    map_counter_group <= choice(turn_ready_tag.start_of_frame and turn_ready_tag.valid and turn_ready_tag.map_column,
      map_counter_group_choice * 16, map_counter_group_choices(3));
    map_line_ended <= choice(turn_ready_tag.end_of_line, map_line_ended_choice, map_line_ended and (not
      turn_ready_tag.valid));
    map_of_column_0_a <= choice(map_at_top, map_column(1) / 2, other_2 / 2);
    map_of_column_0_c <= choice(map_counter_next_frame, map_column(1) / 2, map_column(2) / 2);
    map_of_column_0_b_below_a <= choice(map_of_column_0_b_below_a_choices(9), (not is_set(map_column(1), 8)) and
      is_set(other_2, 8) and (not map_at_top), (not is_set(map_column(1), 8)) or is_set(other_2, 8) or map_at_top);
    map_of_column_0_c_below_a <= carry(map_of_column_0_c_below_a_choices(18), not
      map_of_column_0_c_below_a_choices(19), map_of_column_0_c_below_a_choices(20));
    map_of_column_0_c_below_b <= choice(map_of_column_0_c_below_b_choices(6), (not is_set(map_column(2), 8)) and
      is_set(map_column(1), 8) and (not map_counter_next_frame), (not is_set(map_column(2), 8)) or
      is_set(map_column(1), 8) or map_counter_next_frame);
    map_sorted_low_0 <= choice(map_of_column_0_b_below_a, map_sorted_low_0_choices(1), map_sorted_low_0_choices(2));
    map_sorted_middle_0 <= choice(map_of_column_0_b_below_a, map_sorted_middle_0_choices(1),
      map_sorted_middle_0_choices(2));
    map_sorted_high_0 <= choice(map_of_column_0_b_below_a, map_sorted_high_0_choices(1), map_sorted_high_0_choices(2));
    map_passed_0(1) <= choice(map_passed_0(0), map_passed_0(1) or map_sorted_arrives or map_sorted_behind,
      map_passed_0(1) and (not map_sorted_arrives) and (not map_sorted_behind));
    map_of_low_0_b_below_a <= inverted_carry(map_of_low_0_b_below_a_choice_7, is_set(map_low_0(0), 7), not
      is_set(map_low_0(1), 7));
    map_of_low_0_c_below_a <= carry(map_of_low_0_c_below_a_choice_7, not is_set(map_low_0(2), 7), is_set(map_low_0(0),
      7));
    map_of_low_0_c_below_b <= carry(map_of_low_0_c_below_b_choice_7, not is_set(map_low_0(2), 7), is_set(map_low_0(1),
      7));
    map_of_middle_0_b_below_a <= inverted_carry(map_of_middle_0_b_below_a_choice_7, is_set(map_middle_0(0), 7), not
      is_set(map_middle_0(1), 7));
    map_of_middle_0_c_below_a <= carry(map_of_middle_0_c_below_a_choice_7, not is_set(map_middle_0(2), 7),
      is_set(map_middle_0(0), 7));
    map_of_middle_0_c_below_b <= carry(map_of_middle_0_c_below_b_choice_7, not is_set(map_middle_0(2), 7),
      is_set(map_middle_0(1), 7));
    map_of_high_0_b_below_a <= inverted_carry(map_of_high_0_b_below_a_choice_7, is_set(map_high_0(0), 7), not
      is_set(map_high_0(1), 7));
    map_of_high_0_c_below_a <= carry(map_of_high_0_c_below_a_choice_7, not is_set(map_high_0(2), 7),
      is_set(map_high_0(0), 7));
    map_of_high_0_c_below_b <= carry(map_of_high_0_c_below_b_choice_7, not is_set(map_high_0(2), 7),
      is_set(map_high_0(1), 7));
    map_largest_low_0 <= choice(map_of_low_0_b_below_a, map_largest_low_0_choices(1), map_largest_low_0_choices(2));
    map_median_middle_0 <= choice(map_of_middle_0_b_below_a, map_median_middle_0_choices(2),
      map_median_middle_0_choices(4));
    map_smallest_high_0 <= choice(map_of_high_0_b_below_a, map_smallest_high_0_choices(1),
      map_smallest_high_0_choices(2));
    map_of_all_0_b_below_a <= inverted_carry(map_of_all_0_b_below_a_choice_7, is_set(map_largest_low_0, 7), not
      is_set(map_median_middle_0, 7));
    map_of_all_0_c_below_a <= carry(map_of_all_0_c_below_a_choice_7, not is_set(map_smallest_high_0, 7),
      is_set(map_largest_low_0, 7));
    map_of_all_0_c_below_b <= carry(map_of_all_0_c_below_b_choice_7, not is_set(map_smallest_high_0, 7),
      is_set(map_median_middle_0, 7));
    map_out_disparity_0 <= choice(map_of_all_0_b_below_a, map_out_disparity_0_choices(2),
      map_out_disparity_0_choices(4));
    if map_at_arrives_value then
      map_rows_write_words_0 <= (map_rows_ready_newest_0 * 512) + (map_rows_ready_words_0 / 512);
      map_write_column <= to_integer(other(1)(8 downto 0));
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
    -- other
    other(0) <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 241))), 1) &
      to_unsigned(as_number(turn_ready_tag_row_start_is_equals(1)), 8) & to_unsigned(as_number((map_counter_group =
      1)), 8) & to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
      to_unsigned(map_counter_column, 16);
    other(1) <= other(0);
    other_2 <= ((map_rows_ready_words_0 mod 512) / 2) * 2;
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 242;
      transform_counter_next_frame <= false; transform_counter_last_column <= false; transform_counter_counts <= false;
      transform_counter_frame_joins <= false; transform_counter_back_to_back <= false;
      transform_counter_column_after <= 1; transform_counter_group_after <= 242; transform_read_column <= 0;
      transform_read_row_inside_0 <= false; transform_read_start_of_frame <= false; transform_read_valid <= false;
      transform_ready_column <= 0; transform_ready_start_of_frame <= false; transform_ready_valid <= false;
      transform_write_column <= 0; transform_columns_start_of_frame <= false; transform_columns_valid <= false;
      for i in 0 to 2 loop
        transform_filtering_start_of_frame(i) <= false; transform_filtering_valid(i) <= false;
      end loop;
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 241;
      raster_place_next_frame <= false; raster_place_last_column <= false; raster_place_frame_joins <= false;
      raster_place_back_to_back <= false; raster_place_column_after <= 1; raster_place_group_after <= 241;
      delay_column <= 0; delay_row_inside(2) <= false; delay_tag.valid <= false; delay_tag.first_cost <= false;
      delay_tag.map_column <= false; delay_tag.output_column <= false; delay_tag.start_of_frame <= false;
      rows_read_column <= 0; rows_read_tag.valid <= false; rows_read_tag.first_cost <= false;
      rows_read_tag.map_column <= false; rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false;
      rows_read_tag.end_of_line <= false; rows_ready_column <= 0; rows_ready_tag.valid <= false;
      rows_ready_tag.first_cost <= false; rows_ready_tag.map_column <= false; rows_ready_tag.output_column <= false;
      rows_ready_tag.start_of_frame <= false; rows_ready_tag.end_of_line <= false; rows_write_column <= 0;
      rows_tag.valid <= false; rows_tag.first_cost <= false; rows_tag.map_column <= false;
      rows_tag.output_column <= false; rows_tag.start_of_frame <= false; rows_tag.end_of_line <= false;
      line_centre_map_column_0 <= false; line_centre_output_column_0 <= false; line_centre_first_column_0 <= false;
      line_centre_start_of_frame_0 <= false; line_centre_end_of_line_0 <= false; line_order_address <= 0;
      line_order_falls <= false; line_order_inside <= false; line_order_complete <= false; line_order_output <= false;
      line_order_first <= false; line_order_held_output <= false; line_order_turned_valid <= false;
      line_order_turned_map_column <= false; line_order_turned_output_column <= false;
      line_order_turned_start_of_frame <= false; line_order_turned_end_of_line <= false;
      line_newest_first_column <= false; line_comes <= (others => false);
      line_starts_phases(1 to 26) <= (others => false); line_starts_phases(28 to 47) <= (others => false);
      for i in 0 to 1 loop
        line_places_map_column(i) <= false; line_places_first_column(i) <= false; line_places_address(i) <= 0;
        line_places_shown_output_column(i) <= false; line_places_shown_start_of_frame(i) <= false;
        line_places_shown_end_of_line(i) <= false;
      end loop;
      line_places_map_column(2) <= false; line_places_shown_output_column(2) <= false;
      line_places_shown_start_of_frame(2) <= false; line_places_shown_end_of_line(2) <= false;
      costsshift_new_tag.valid <= false; costsshift_count_phase <= 15; costsshift_read_tag.valid <= false;
      costsshift_read_count_phase <= 15; costsshift_write_phase <= 15; costswindow_read_count_phase <= 15;
      costswindow_write_count_phase <= 15; paths_cost_delay_ring_read_address <= 1;
      paths_cost_delay_ring_write_address <= 0; pathsleft_low_address <= 5; pathsleft_read_count_phase <= 15;
      pathsleft_ahead_count_phase <= 15; pathsleft_is_first <= false; pathsleft_write_count_phase <= 15;
      pathsleft_low_write_address <= 0; pathsabove_memory_read_address_0 <= 0; pathsabove_memory_read_address_1 <= 0;
      pathsabove_memory_write_address_0 <= 0; pathsabove_memory_write_address_1 <= 0;
      pathsabove_read_address_address <= 0; pathsabove_read_address_count_phase <= 15;
      pathsabove_write_address_address <= 0; pathsabove_write_address_is_here <= false;
      pathsabove_write_address_count_phase <= 15; pathsturn_sum_memory_read_address_0 <= 0;
      pathsturn_sum_memory_read_address_1 <= 0; pathsturn_sum_memory_write_address_0 <= 0;
      pathsturn_sum_memory_write_address_1 <= 0; pathsturn_cost_memory_read_address_0 <= 0;
      pathsturn_cost_memory_read_address_1 <= 0; pathsturn_cost_memory_write_address_0 <= 0;
      pathsturn_cost_memory_write_address_1 <= 0; pathsturn_smallest_address <= 0; pathsturn_read_address_address <= 0;
      pathsturn_read_address_count_phase <= 15; pathsturn_sum_read_address <= 0; pathsturn_write_smallest_address <= 0;
      pathsturn_write_address_address <= 0; pathsturn_write_address_is_here <= false;
      pathsturn_write_address_count_phase <= 15; pathsturn_sum_write_address <= (others => 0);
      pathsturn_writes_sums <= (others => false); winnerswinner1_best_below_0 <= false;
      winners_best_tag <= (others => false); turn_order_address <= 0; turn_order_falls <= false;
      turn_order_inside <= false; turn_order_complete <= false; turn_order_output <= false; turn_order_first <= false;
      turn_order_turned_valid <= false; turn_order_turned_map_column <= false;
      turn_order_turned_start_of_frame <= false; turn_order_turned_end_of_line <= false; turn_comes <= false;
      turn_read_tag <= (others => false); turn_write_place <= 0; turn_ready_tag <= (others => false);
      map_counter_column <= 0; map_counter_group <= 241; map_arrives <= false; map_behind <= false;
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
      other(0) <= to_unsigned(0, 49); other(1) <= to_unsigned(0, 49);
    end if;
  end process;
end architecture;
