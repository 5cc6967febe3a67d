-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_640_f8: 640x480, 128 disparities, window 1x1, P1 4, P2 24, 1 pixel pair a clock.
-- Options: disparities 128, window_px 1, reference left, census_width_px 9, cost_shift 2, p1 4, p2 24, median
--   true, slice_disparities 16, clocks_per_pixel 8.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_640_f8
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_640_f8 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 128;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 513;
    latency_clocks : positive := 58;
    flush_groups : positive := 3205;
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
  assert width_px = 640 report "stereo_core_sgm_640_f8: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_sgm_640_f8: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 128 report "stereo_core_sgm_640_f8: disparities is " & integer'image(disparities) & " but this core has 128" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_640_f8: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_sgm_640_f8: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 513 report "stereo_core_sgm_640_f8: output_width_px is " & integer'image(output_width_px) & " but this core has 513" severity failure;
  assert latency_clocks = 58 report "stereo_core_sgm_640_f8: latency_clocks is " & integer'image(latency_clocks) & " but this core has 58" severity failure;
  assert flush_groups = 3205 report "stereo_core_sgm_640_f8: flush_groups is " & integer'image(flush_groups) & " but this core has 3205" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_640_f8: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_640_f8 is
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
  function differing_bits(a : unsigned; b : unsigned; place : natural) return natural is
  begin
    return as_number((a(place) = '1') /= (b(place) = '1'));
  end function;

  function differing_bits(a : unsigned; b : unsigned; p : natural; q : natural; r : natural) return natural is
  begin
    return differing_bits(a, b, p) + differing_bits(a, b, q) + differing_bits(a, b, r);
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

  function choice(test : boolean; yes : unsigned; no : unsigned) return unsigned is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

  type boolean_1d is array (natural range <>) of boolean;
  type boolean_2d is array (natural range <>, natural range <>) of boolean;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_126_1d is array (natural range <>) of natural range 0 to 126;
  type natural_135007244_1d is array (natural range <>) of natural range 0 to 135007244;
  type natural_13_1d is array (natural range <>) of natural range 0 to 13;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_190_1d is array (natural range <>) of natural range 0 to 190;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_2_1d is array (natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_31_2d is array (natural range <>, natural range <>) of natural range 0 to 31;
  type natural_3_2d is array (natural range <>, natural range <>) of natural range 0 to 3;
  type natural_44_1d is array (natural range <>) of natural range 0 to 44;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_53_1d is array (natural range <>) of natural range 0 to 53;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_2d is array (natural range <>, natural range <>) of natural range 0 to 63;
  type natural_65019_1d is array (natural range <>) of natural range 0 to 65019;
  type natural_65277_1d is array (natural range <>) of natural range 0 to 65277;
  type natural_65406_1d is array (natural range <>) of natural range 0 to 65406;
  type natural_65471_1d is array (natural range <>) of natural range 0 to 65471;
  type natural_65503_1d is array (natural range <>) of natural range 0 to 65503;
  type natural_65519_1d is array (natural range <>) of natural range 0 to 65519;
  type natural_65527_1d is array (natural range <>) of natural range 0 to 65527;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_65535_2d is array (natural range <>, natural range <>) of natural range 0 to 65535;
  type natural_67_1d is array (natural range <>) of natural range 0 to 67;
  type natural_8191_1d is array (natural range <>) of natural range 0 to 8191;
  type unsigned_16_2d is array (natural range <>, natural range <>) of unsigned(15 downto 0);
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type unsigned_44_1d is array (natural range <>) of unsigned(43 downto 0);
  type unsigned_49_1d is array (natural range <>) of unsigned(48 downto 0);
  type tag_6 is record
    valid, first_cost, map_column, output_column, start_of_frame, end_of_line : boolean;
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
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0, transform_left_rows_ready_newest_0,
    transform_right_rows_read_newest_0, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 4);
  signal transform_left_filter_column, transform_right_filter_column : natural_255_2d(0 to 8, 0 to 4);
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
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- _#_valid
  signal transform_counter_column, transform_read_column, transform_ready_column,
    transform_write_column : natural range 0 to 1023;
  signal transform_counter_group : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0, transform_left_rows_write_words_0,
    transform_right_rows_read_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : unsigned(43 downto 0);
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : unsigned(43 downto 0);
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : unsigned(43 downto 0);
  signal delay_tag : tag_6;
  -- rows
  signal rows_search_0, rows_reference_0 : unsigned(43 downto 0);
  signal rows_tag : tag_6;
  -- line
  signal line_centre_map_column_0, line_centre_first_column_0, line_centre_start_of_frame_0, line_centre_end_of_line_0,
    line_order_falls, line_order_inside, line_order_complete, line_order_output, line_order_first,
    line_order_held_output, line_order_turned_valid, line_order_turned_output_column,
    line_order_turned_start_of_frame : boolean;
  signal line_comes, line_starts_phases : boolean_1d(1 to 33);
  signal line_places_map_column : boolean_1d(0 to 4);  -- _#_map_column
  signal line_places_first_column : boolean_1d(0 to 2);  -- _#_first_column
  signal line_places_0_top : boolean;
  signal line_places_shown_output_column : boolean_1d(0 to 4);  -- _#_shown_output_column
  signal line_places_shown_start_of_frame : boolean_1d(0 to 4);  -- _#_shown_start_of_frame
  signal line_places_shown_end_of_line : boolean_1d(0 to 4);  -- _#_shown_end_of_line
  signal line_order_address : natural range 0 to 1023;
  signal line_places_address : natural_1023_1d(0 to 2);  -- _#_address
  -- costsshift
  signal costsshift_newest_0, costsshift_new_reference_0 : unsigned(43 downto 0);
  signal costsshift_read_words : unsigned_44_1d(0 to 15);
  signal costsshift_handed_on_0, costsshift_read_reference_0 : unsigned(43 downto 0);
  signal costsshift_search_0 : unsigned_44_1d(0 to 15);
  signal costsshift_reference_0 : unsigned(43 downto 0);
  signal costsshift_new_tag_valid, costsshift_read_tag_valid : boolean;
  signal costsshift_count_phase, costsshift_read_count_phase, costsshift_write_phase : natural range 0 to 7;
  -- costswindow
  signal costswindow_first_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal costswindow_first_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal costswindow_sum_0 : natural_53_1d(0 to 15);
  -- costs
  signal costs_cost : natural_13_1d(0 to 15);
  -- paths
  signal paths_tree_smallest : natural_13_1d(0 to 7);
  signal paths_tree_next_smallest : natural_13_1d(0 to 3);
  signal paths_tree_next_next_smallest : natural_13_1d(0 to 1);
  signal paths_tree_next_next_next_smallest_0 : natural range 0 to 13;
  signal paths_smallest_cost, paths_cost_delay_ring_read_address,
    paths_cost_delay_ring_write_address : natural range 0 to 15;
  signal paths_cost_delay_held : unsigned_32_1d(0 to 1);
  signal paths_sum : natural_190_1d(0 to 15);
  -- pathsleft
  signal pathsleft_low_address, pathsleft_low_write_address : natural range 0 to 15;
  signal pathsleft_lowest_0, pathsleft_read_neighbour_0 : unsigned(5 downto 0);
  signal pathsleft_lost, pathsleft_short_of, pathsleft_first, pathsleft_is_first, pathsleft_is_last : boolean;
  signal pathsleft_missing, pathsleft_below, pathsleft_q, pathsleft_room_left, pathsleft_q_now,
    pathsleft_room : natural range 0 to 31;
  signal pathsleft_start_cost : natural_31_1d(1 to 9);
  signal pathsleft_q_less, pathsleft_g_less, pathsleft_lower_neighbour : natural range 0 to 63;
  signal pathsleft_stay, pathsleft_step, pathsleft_stay_change, pathsleft_step_change, pathsleft_cost,
    pathsleft_arrived : natural_63_1d(0 to 15);
  signal pathsleft_tree_smallest : natural_63_1d(0 to 7);
  signal pathsleft_tree_next_smallest : natural_63_1d(0 to 3);
  signal pathsleft_tree_next_next_smallest : natural_63_1d(0 to 1);
  signal pathsleft_tree_next_next_next_smallest_0, pathsleft_low_0 : natural range 0 to 63;
  signal pathsleft_g : natural range 0 to 46;
  signal pathsleft_read_count_phase, pathsleft_ahead_count_phase, pathsleft_write_count_phase : natural range 0 to 7;
  signal pathsleft_read_words : unsigned_30_1d(0 to 5);
  signal pathsleft_read_words_6 : unsigned(11 downto 0);
  -- pathsabove
  signal pathsabove_memory_read_address_0, pathsabove_memory_write_address_0 : natural range 0 to 4095;
  signal pathsabove_memory_read_address_1, pathsabove_memory_write_address_1, pathsabove_read_address_count_phase,
    pathsabove_count_phase, pathsabove_write_address_count_phase : natural range 0 to 7;
  signal pathsabove_memory_bank, pathsabove_memory_read_bank, pathsabove_memory_held_bank, pathsabove_ready_top,
    pathsabove_write_address_is_here : boolean;
  signal pathsabove_memory_read_words : unsigned_16_2d(0 to 1, 0 to 4);
  signal pathsabove_memory_held_words : natural_65535_2d(0 to 1, 0 to 4);
  signal pathsabove_memory_ready_words : natural_65535_1d(0 to 4);
  signal pathsabove_memory_write_words : natural_65535_2d(0 to 1, 0 to 4);
  signal pathsabove_read_address_address, pathsabove_write_address_address : natural range 0 to 8191;
  signal pathsabove_total : natural_44_1d(0 to 15);
  signal pathsabove_tree_smallest : natural_44_1d(0 to 7);
  signal pathsabove_tree_next_smallest : natural_44_1d(0 to 3);
  signal pathsabove_tree_next_next_smallest : natural_44_1d(0 to 1);
  signal pathsabove_tree_next_next_next_smallest_0 : natural range 0 to 44;
  signal pathsabove_delay_held : unsigned_30_1d(0 to 2);
  signal pathsabove_delay_held_3 : unsigned(5 downto 0);
  signal pathsabove_smallest_total, pathsabove_smallest : natural range 0 to 63;
  signal pathsabove_cost, pathsabove_held : natural_63_1d(0 to 15);
  signal pathsabove_lower_neighbour : natural range 0 to 63;
  signal pathsabove_beside : natural_63_1d(0 to 15);
  signal pathsabove_own : natural_63_1d(0 to 14);
  signal pathsabove_step : natural_67_1d(0 to 15);
  signal pathsabove_stay : natural_31_1d(0 to 15);
  -- pathsturn
  signal pathsturn_sum_memory_read_address_0, pathsturn_sum_memory_write_address_0,
    pathsturn_cost_memory_read_address_0, pathsturn_cost_memory_write_address_0 : natural range 0 to 4095;
  signal pathsturn_sum_memory_read_address_1, pathsturn_sum_memory_write_address_1,
    pathsturn_cost_memory_read_address_1, pathsturn_cost_memory_write_address_1, pathsturn_read_address_count_phase,
    pathsturn_write_address_count_phase : natural range 0 to 7;
  signal pathsturn_sum_memory_bank, pathsturn_sum_memory_read_bank, pathsturn_sum_memory_held_bank,
    pathsturn_cost_memory_bank, pathsturn_cost_memory_read_bank, pathsturn_cost_memory_held_bank,
    pathsturn_write_address_is_here : boolean;
  signal pathsturn_writes_sums : boolean_1d(0 to 1);
  signal pathsturn_sum_memory_read_words : unsigned_16_2d(0 to 1, 0 to 6);
  signal pathsturn_cost_memory_read_words : unsigned_16_2d(0 to 1, 0 to 3);
  signal pathsturn_sum_memory_held_words : natural_65535_2d(0 to 1, 0 to 6);
  signal pathsturn_sum_memory_ready_words : natural_65535_1d(0 to 6);
  signal pathsturn_cost_memory_held_words : natural_65535_2d(0 to 1, 0 to 3);
  signal pathsturn_cost_memory_ready_words : natural_65535_1d(0 to 3);
  signal pathsturn_cost_memory_write_words : natural_65535_2d(0 to 1, 0 to 3);
  signal pathsturn_sum_memory_write_words_0 : natural_65406_1d(0 to 1);  -- _#_0
  signal pathsturn_sum_memory_write_words_1 : natural_65503_1d(0 to 1);  -- _#_1
  signal pathsturn_sum_memory_write_words_2 : natural_65527_1d(0 to 1);  -- _#_2
  signal pathsturn_sum_memory_write_words_3 : natural_65277_1d(0 to 1);  -- _#_3
  signal pathsturn_sum_memory_write_words_4 : natural_65471_1d(0 to 1);  -- _#_4
  signal pathsturn_sum_memory_write_words_5 : natural_65519_1d(0 to 1);  -- _#_5
  signal pathsturn_sum_memory_write_words_6 : natural_65019_1d(0 to 1);  -- _#_6
  signal pathsturn_smallest_address, pathsturn_write_smallest_address : natural range 0 to 1023;
  signal pathsturn_read_smallest_0 : unsigned(3 downto 0);
  signal pathsturn_ready_smallest_0, pathsturn_write_smallest_0 : natural range 0 to 15;
  signal pathsturn_read_address_address, pathsturn_sum_read_address,
    pathsturn_write_address_address : natural range 0 to 8191;
  signal pathsturn_sum_write_address : natural_8191_1d(0 to 1);
  -- pathsright
  signal pathsright_lowest_0, pathsright_read_neighbour_0 : unsigned(5 downto 0);
  signal pathsright_lost, pathsright_short_of : boolean;
  signal pathsright_missing, pathsright_below, pathsright_q, pathsright_room_left, pathsright_q_now,
    pathsright_room : natural range 0 to 31;
  signal pathsright_start_cost : natural_31_1d(1 to 9);
  signal pathsright_q_less, pathsright_g_less, pathsright_lower_neighbour : natural range 0 to 63;
  signal pathsright_stay, pathsright_step, pathsright_stay_change, pathsright_step_change, pathsright_cost,
    pathsright_arrived : natural_63_1d(0 to 15);
  signal pathsright_tree_smallest : natural_63_1d(0 to 7);
  signal pathsright_tree_next_smallest : natural_63_1d(0 to 3);
  signal pathsright_tree_next_next_smallest : natural_63_1d(0 to 1);
  signal pathsright_tree_next_next_next_smallest_0, pathsright_low_0 : natural range 0 to 63;
  signal pathsright_g : natural range 0 to 46;
  signal pathsright_read_words : unsigned_30_1d(0 to 5);
  signal pathsright_read_words_6 : unsigned(11 downto 0);
  -- winnerswinner1
  signal winnerswinner1_best_cost_0 : natural_190_1d(0 to 7);
  signal winnerswinner1_best_index_0_0 : boolean;
  signal winnerswinner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- winnerswinner2
  signal winnerswinner2_best_cost_0 : natural_190_1d(0 to 3);
  signal winnerswinner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  -- winnerswinner3
  signal winnerswinner3_best_cost_0 : natural_190_1d(0 to 1);
  signal winnerswinner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  -- winnerswinner4
  signal winnerswinner4_best_cost_0_0 : natural range 0 to 190;
  signal winnerswinner4_best_index_0_0 : natural range 0 to 15;
  -- winners
  signal winners_best_cost_0_0, winners_best_index_0_0 : natural range 0 to 255;
  signal winners_best_tag : tag_5;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 1023;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame,
    turn_order_turned_end_of_line, turn_comes : boolean;
  signal turn_read_tag : tag_4;
  signal turn_ready_tag : tag_5_b;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 511;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column,
    map_sorted_column : natural range 0 to 1023;
  signal map_counter_group, map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 511;
  signal map_column : natural_511_1d(1 to 2);
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
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0, map_sorted_middle_0,
    map_sorted_high_0 : natural range 0 to 255;
  signal map_low_0, map_middle_0, map_high_0 : natural_255_1d(0 to 2);  -- _#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b, map_of_middle_0_c,
    map_of_high_0_a, map_of_high_0_b, map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0,
    map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 255;
  -- other
  signal other : unsigned_49_1d(0 to 1);
  signal other_2 : natural range 0 to 510;
  signal others_from_3 : natural_135007244_1d(3 to 18);  -- other_#

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

  map_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(17 downto 0);
  begin
    read_address <= to_unsigned(map_counter_column, 10);
    write_address <= to_unsigned(map_write_column, 10);
    write_data <= to_unsigned(map_rows_write_words_0, 18);
    cell : entity work.line_memory generic map (513, 18, 10)
      port map (clock, true, read_address, map_rows_read_words_0, write_address, write_data);
  end block;

  turn_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(turn_order_address, 10);
    write_address <= to_unsigned(turn_write_place, 10);
    write_data <= to_unsigned(turn_write_words_0, 9);
    cell : entity work.line_memory generic map (514, 9, 10)
      port map (clock, true, read_address, turn_read_words_0, write_address, write_data);
  end block;

  pathsright_read_words_6_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsright_arrived(15), 6) & to_unsigned(pathsright_arrived(14), 6);
    cell : entity work.line_memory generic map (8, 12, 3)
      port map (clock, true, read_address, pathsright_read_words_6, write_address, write_data);
  end block;

  pathsright_read_words_memory : for i in 5 downto 4 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsright_arrived(5 * i - 12), 6) & to_unsigned(pathsright_arrived(5 * i - 13), 6) &
      to_unsigned(pathsright_arrived(5 * i - 14), 6) & to_unsigned(pathsright_arrived(5 * i - 15), 6) &
      to_unsigned(pathsright_arrived(5 * i - 16), 6);
    cell : entity work.line_memory generic map (8, 30, 3)
      port map (clock, true, read_address, pathsright_read_words(i), write_address, write_data);
  end generate;

  pathsright_read_words_3_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsright_arrived(3), 6) & to_unsigned(pathsright_arrived(2), 6) &
      to_unsigned(pathsright_arrived(1), 6) & to_unsigned(pathsright_arrived(0), 6) & to_unsigned(pathsright_cost(15),
      6);
    cell : entity work.line_memory generic map (8, 30, 3)
      port map (clock, true, read_address, pathsright_read_words(3), write_address, write_data);
  end block;

  pathsright_read_words_2_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsright_cost(5 * i + 4), 6) & to_unsigned(pathsright_cost(5 * i + 3), 6) &
      to_unsigned(pathsright_cost(5 * i + 2), 6) & to_unsigned(pathsright_cost(5 * i + 1), 6) &
      to_unsigned(pathsright_cost(5 * i), 6);
    cell : entity work.line_memory generic map (8, 30, 3)
      port map (clock, true, read_address, pathsright_read_words(i), write_address, write_data);
  end generate;

  pathsright_read_neighbour_0_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_ahead_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsright_cost(0), 6);
    cell : entity work.line_memory generic map (8, 6, 3)
      port map (clock, true, read_address, pathsright_read_neighbour_0, write_address, write_data);
  end block;

  pathsright_lowest_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_low_address, 4);
    write_address <= to_unsigned(pathsleft_low_write_address, 4);
    write_data <= to_unsigned(pathsright_low_0, 6);
    cell : entity work.line_memory generic map (16, 6, 4)
      port map (clock, true, read_address, pathsright_lowest_0, write_address, write_data);
  end block;

  pathsturn_read_smallest_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(3 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_smallest_address, 10);
    write_address <= to_unsigned(pathsturn_write_smallest_address, 10);
    write_data <= to_unsigned(pathsturn_write_smallest_0, 4);
    cell : entity work.line_memory generic map (514, 4, 10)
      port map (clock, true, read_address, pathsturn_read_smallest_0, write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_6_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_6(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(0, 6), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_5_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_5(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(0, 5), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_4_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_4(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(0, 4), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_3_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_3(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(0, 3), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_2_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_2(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(0, 2), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_1_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_1(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(0, 1), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_0_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_0(0), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(0, 0), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_6_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_6(1), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(1, 6), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_5_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_5(1), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(1, 5), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_4_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_4(1), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(1, 4), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_3_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_3(1), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(1, 3), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_2_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_2(1), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(1, 2), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_1_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_1(1), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(1, 1), write_address, write_data);
  end block;

  pathsturn_sum_memory_read_words_1_0_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_sum_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsturn_sum_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsturn_sum_memory_write_words_0(1), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsturn_sum_memory_read_words(1, 0), write_address, write_data);
  end block;

  pathsturn_cost_memory_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_cost_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsturn_cost_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsturn_cost_memory_write_words(0, i), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsturn_cost_memory_read_words(0, i), write_address, write_data);
  end generate;

  pathsturn_cost_memory_read_words_1_3_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsturn_cost_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsturn_cost_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsturn_cost_memory_write_words(1, i), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsturn_cost_memory_read_words(1, i), write_address, write_data);
  end generate;

  pathsabove_delay_held_3_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
    write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
    write_data <= to_unsigned(pathsabove_total(15), 6);
    cell : entity work.line_memory generic map (13, 6, 4)
      port map (clock, true, read_address, pathsabove_delay_held_3, write_address, write_data);
  end block;

  pathsabove_delay_held_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
    write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
    write_data <= to_unsigned(pathsabove_total(5 * i + 4), 6) & to_unsigned(pathsabove_total(5 * i + 3), 6) &
      to_unsigned(pathsabove_total(5 * i + 2), 6) & to_unsigned(pathsabove_total(5 * i + 1), 6) &
      to_unsigned(pathsabove_total(5 * i), 6);
    cell : entity work.line_memory generic map (13, 30, 4)
      port map (clock, true, read_address, pathsabove_delay_held(i), write_address, write_data);
  end generate;

  pathsabove_memory_read_words_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_0, 12);
    write_address <= to_unsigned(pathsabove_memory_write_address_0, 12);
    write_data <= to_unsigned(pathsabove_memory_write_words(0, i), 16);
    cell : entity work.line_memory generic map (4096, 16, 12)
      port map (clock, true, read_address, pathsabove_memory_read_words(0, i), write_address, write_data);
  end generate;

  pathsabove_memory_read_words_1_4_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(pathsabove_memory_read_address_1, 3);
    write_address <= to_unsigned(pathsabove_memory_write_address_1, 3);
    write_data <= to_unsigned(pathsabove_memory_write_words(1, i), 16);
    cell : entity work.line_memory generic map (8, 16, 3)
      port map (clock, true, read_address, pathsabove_memory_read_words(1, i), write_address, write_data);
  end generate;

  pathsleft_read_words_6_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsleft_arrived(15), 6) & to_unsigned(pathsleft_arrived(14), 6);
    cell : entity work.line_memory generic map (8, 12, 3)
      port map (clock, true, read_address, pathsleft_read_words_6, write_address, write_data);
  end block;

  pathsleft_read_words_memory : for i in 5 downto 4 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsleft_arrived(5 * i - 12), 6) & to_unsigned(pathsleft_arrived(5 * i - 13), 6) &
      to_unsigned(pathsleft_arrived(5 * i - 14), 6) & to_unsigned(pathsleft_arrived(5 * i - 15), 6) &
      to_unsigned(pathsleft_arrived(5 * i - 16), 6);
    cell : entity work.line_memory generic map (8, 30, 3)
      port map (clock, true, read_address, pathsleft_read_words(i), write_address, write_data);
  end generate;

  pathsleft_read_words_3_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsleft_arrived(3), 6) & to_unsigned(pathsleft_arrived(2), 6) &
      to_unsigned(pathsleft_arrived(1), 6) & to_unsigned(pathsleft_arrived(0), 6) & to_unsigned(pathsleft_cost(15), 6);
    cell : entity work.line_memory generic map (8, 30, 3)
      port map (clock, true, read_address, pathsleft_read_words(3), write_address, write_data);
  end block;

  pathsleft_read_words_2_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_read_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsleft_cost(5 * i + 4), 6) & to_unsigned(pathsleft_cost(5 * i + 3), 6) &
      to_unsigned(pathsleft_cost(5 * i + 2), 6) & to_unsigned(pathsleft_cost(5 * i + 1), 6) &
      to_unsigned(pathsleft_cost(5 * i), 6);
    cell : entity work.line_memory generic map (8, 30, 3)
      port map (clock, true, read_address, pathsleft_read_words(i), write_address, write_data);
  end generate;

  pathsleft_read_neighbour_0_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_ahead_count_phase, 3);
    write_address <= to_unsigned(pathsleft_write_count_phase, 3);
    write_data <= to_unsigned(pathsleft_cost(0), 6);
    cell : entity work.line_memory generic map (8, 6, 3)
      port map (clock, true, read_address, pathsleft_read_neighbour_0, write_address, write_data);
  end block;

  pathsleft_lowest_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(pathsleft_low_address, 4);
    write_address <= to_unsigned(pathsleft_low_write_address, 4);
    write_data <= to_unsigned(pathsleft_low_0, 6);
    cell : entity work.line_memory generic map (16, 6, 4)
      port map (clock, true, read_address, pathsleft_lowest_0, write_address, write_data);
  end block;

  paths_cost_delay_held_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(paths_cost_delay_ring_read_address, 4);
    write_address <= to_unsigned(paths_cost_delay_ring_write_address, 4);
    write_data <= to_unsigned(costs_cost(8 * i + 7), 4) & to_unsigned(costs_cost(8 * i + 6), 4) &
      to_unsigned(costs_cost(8 * i + 5), 4) & to_unsigned(costs_cost(8 * i + 4), 4) & to_unsigned(costs_cost(8 * i +
      3), 4) & to_unsigned(costs_cost(8 * i + 2), 4) & to_unsigned(costs_cost(8 * i + 1), 4) & to_unsigned(costs_cost(8
      * i), 4);
    cell : entity work.line_memory generic map (13, 32, 4)
      port map (clock, true, read_address, paths_cost_delay_held(i), write_address, write_data);
  end generate;

  costsshift_read_words_memory : for i in 15 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
  begin
    read_address <= to_unsigned(costsshift_count_phase, 3);
    write_address <= to_unsigned(costsshift_write_phase, 3);
    cell : entity work.line_memory generic map (8, 44, 3)
      port map (clock, true, read_address, costsshift_read_words(i), write_address, costsshift_search_0(i));
  end generate;

  process
    variable transform_counter_group_is_equals, turn_ready_tag_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_is_equal,
      delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less,
      line_order_falls_any, line_order_falls_all, line_order_complete_any, line_order_turned_output_column_choice,
      pathsleft_read_count_phase_is_equal, pathsleft_cost_0_any, pathsabove_count_phase_is_equal,
      pathsabove_memory_write_words_0_0_choice_4, winnerswinner4_best_index_0_0_choice_8, turn_order_falls_all,
      turn_order_complete_all, turn_ready_tag_row_start_differs, map_counter_group_is_equal, map_line_ended_choice,
      map_at_arrives_value, map_window_complete_is_equal, map_window_complete_choice, map_of_low_0_b_below_a_is_equal,
      map_of_low_0_b_below_a_choice_7, map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice_7,
      map_of_low_0_c_below_b_choice_7, map_of_middle_0_b_below_a_is_equal, map_of_middle_0_b_below_a_choice_7,
      map_of_middle_0_c_below_a_value, map_of_middle_0_c_below_a_choice_7, map_of_middle_0_c_below_b_choice_7,
      map_of_high_0_b_below_a_is_equal, map_of_high_0_b_below_a_choice_7, map_of_high_0_c_below_a_value,
      map_of_high_0_c_below_a_choice_7, map_of_high_0_c_below_b_choice_7, map_of_all_0_b_below_a_is_equal,
      map_of_all_0_b_below_a_choice_7, map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice_7,
      map_of_all_0_c_below_b_choice_7 : boolean;
    variable transform_counter_group_choice, paths_smallest_cost_choice, pathsabove_memory_write_words_0_3_choice_4,
      map_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choices, map_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_counter_next_frame_choices : boolean_1d(1 to 4);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values,
      map_of_low_0_b_below_a_values, map_of_middle_0_b_below_a_values, map_of_high_0_b_below_a_values,
      map_of_all_0_b_below_a_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(8 to 353);
    variable transform_left_filter_feature_0_choice_354, transform_right_filter_feature_0_choice_354,
      pathsleft_room_left_choice, pathsright_room_left_choice : natural range 0 to 31;
    variable transform_left_filter_feature_0_choice_355,
      transform_right_filter_feature_0_choice_355 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_356,
      transform_right_filter_feature_0_choice_356 : natural range 0 to 32767;
    variable transform_left_filter_feature_0_choice_357,
      transform_right_filter_feature_0_choice_357 : natural range 0 to 1048575;
    variable transform_left_filter_feature_0_choice_358,
      transform_right_filter_feature_0_choice_358 : natural range 0 to 8388607;
    variable transform_left_filter_feature_0_choice_359,
      transform_right_filter_feature_0_choice_359 : natural range 0 to 536870911;
    variable transform_left_filter_feature_0_choice_360,
      transform_right_filter_feature_0_choice_360 : unsigned(33 downto 0);
    variable transform_left_filter_feature_0_choice_361,
      transform_right_filter_feature_0_choice_361 : unsigned(38 downto 0);
    variable line_order_address_choice, turn_order_address_choice : natural range 1 to 1023;
    variable costsshift_count_phase_choice, pathsleft_read_count_phase_choice, pathsleft_ahead_count_phase_choice,
      pathsleft_write_count_phase_choice, pathsabove_memory_read_address_1_choice,
      pathsabove_read_address_count_phase_choice, pathsabove_count_phase_choice,
      pathsabove_write_address_count_phase_choice, pathsabove_memory_write_words_0_2_choice_4,
      pathsturn_read_address_count_phase_choice, pathsturn_write_address_count_phase_choice : natural range 0 to 7;
    variable pathsleft_stay_value, pathsright_stay_value : natural_63_2d(0 to 13, 1 to 2);  -- _#_value_#
    variable pathsleft_stay_choice, pathsabove_beside_choice, pathsright_stay_choice : natural_63_1d(0 to 15);  -- _#_choice
    variable pathsleft_step_choice, pathsright_step_choice : natural_63_2d(0 to 15, 1 to 2);  -- _#_choice_#
    variable pathsleft_stay_change_value, pathsright_stay_change_value : natural_15_1d(1 to 14);  -- _#_value
    variable pathsleft_low_0_choice, pathsabove_smallest_total_choice, pathsright_low_0_choice : natural range 0 to 63;
    variable pathsleft_q_choices, pathsright_q_choices : natural_31_1d(1 to 2);  -- _choice_#
    variable pathsabove_memory_read_address_0_sum : natural range 1 to 8192;
    variable pathsabove_memory_read_address_0_choice : natural range 0 to 4095;
    variable pathsabove_memory_read_address_0_sum_2, pathsturn_cost_memory_read_address_0_sum : natural range 0 to 8192;
    variable pathsabove_memory_bank_choices : natural_8191_1d(1 to 2);  -- _choice_#
    variable pathsabove_ready_top_choices : boolean_1d(1 to 2);  -- _choice_#
    variable pathsabove_total_choice : natural_31_1d(0 to 15);  -- _#_choice
    variable pathsabove_write_address_address_choice, pathsturn_cost_memory_bank_choice : natural range 0 to 8191;
    variable pathsabove_memory_write_words_0_choice : natural_31_2d(0 to 4, 1 to 4);  -- _#_choice_#
    variable pathsabove_memory_write_words_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable pathsabove_memory_write_words_0_sum : natural_65535_1d(0 to 4);  -- _#_sum
    variable pathsabove_memory_write_words_0_1_choice_4 : natural range 0 to 3;
    variable pathsabove_memory_write_words_0_all, pathsturn_sum_memory_write_words_0_all,
      pathsturn_cost_memory_write_words_0_all, map_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
    variable pathsturn_sum_memory_write_words_0_sum : natural_126_1d(0 to 5);  -- _#_sum
    variable pathsturn_sum_memory_write_words_0_0_sum_2 : natural range 0 to 65406;
    variable pathsturn_sum_memory_write_words_0_1_sum_2 : natural range 0 to 65503;
    variable pathsturn_sum_memory_write_words_0_2_sum_2 : natural range 0 to 65527;
    variable pathsturn_sum_memory_write_words_0_3_sum_2 : natural range 0 to 65277;
    variable pathsturn_sum_memory_write_words_0_4_sum_2 : natural range 0 to 65471;
    variable pathsturn_sum_memory_write_words_0_5_sum_2 : natural range 0 to 65519;
    variable pathsturn_sum_memory_write_words_0_6_sum : natural range 0 to 65019;
    variable winnerswinner1_best_index_0_value : boolean_2d(0 to 7, 1 to 5);  -- _#_value_#
    variable winnerswinner1_best_index_0_choice : boolean_2d(0 to 7, 7 to 8);  -- _#_choice_#
    variable winnerswinner2_best_index_0_value : boolean_2d(0 to 3, 1 to 5);  -- _#_value_#
    variable winnerswinner2_best_index_0_choice_8 : boolean_1d(0 to 3);  -- _#_choice_8
    variable winnerswinner3_best_index_0_value : boolean_2d(0 to 1, 1 to 5);  -- _#_value_#
    variable winnerswinner3_best_index_0_choice_8 : boolean_1d(0 to 1);  -- _#_choice_8
    variable winnerswinner4_best_index_0_0_values : boolean_1d(1 to 5);  -- _value_#
    variable winners_best_cost_0_0_choice, map_low_0_0_choice, map_middle_0_0_choice,
      map_high_0_0_choice : natural range 0 to 255;
    variable winners_best_index_0_0_values : boolean_1d(1 to 6);  -- _value_#
    variable winners_best_index_0_0_choices : boolean_1d(1 to 7);  -- _choice_#
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
    variable turn_ready_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable turn_ready_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable map_of_column_0_b_below_a_values : boolean_1d(1 to 12);  -- _value_#
    variable map_of_column_0_b_below_a_choices : boolean_1d(1 to 9);  -- _choice_#
    variable map_of_column_0_c_below_a_values : boolean_1d(1 to 7);  -- _value_#
    variable map_of_column_0_c_below_a_choices : boolean_1d(1 to 20);  -- _choice_#
    variable map_of_column_0_c_below_b_choices : boolean_1d(1 to 6);  -- _choice_#
    variable map_sorted_low_0_choices, map_sorted_middle_0_choices, map_sorted_high_0_choices,
      map_largest_low_0_choices, map_smallest_high_0_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable map_median_middle_0_choices, map_out_disparity_0_choices : natural_255_1d(1 to 4);  -- _choice_#
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    pathsabove_beside_choice := (others => 0); pathsabove_memory_write_words_0_choice := (others => (others => 0));
    pathsleft_stay_change_value := (others => 0); pathsleft_stay_value := (others => (others => 0));
    pathsleft_step_choice := (others => (others => 0)); pathsright_stay_change_value := (others => 0);
    pathsright_stay_value := (others => (others => 0)); pathsright_step_choice := (others => (others => 0));
    transform_left_filter_feature_0_choice := (others => false);
    transform_right_filter_feature_0_choice := (others => false);
    winnerswinner1_best_index_0_choice := (others => (others => false));
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_group = 479;
    transform_counter_group_is_equals(2) := transform_counter_column = 639;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 15, 0);
    transform_counter_group_differs := transform_counter_group /= 482;
    transform_counter_group_choices(2) := choice((transform_counter_group = 481) and transform_counter_next_frame, 2,
      (transform_counter_group + 1) mod 512);
    transform_counter_group_choices(3) := choice(transform_counter_group_differs and in_valid and
      transform_counter_group_is_equals(2), transform_counter_group_choices(2), transform_counter_group);
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(2), (transform_counter_group /=
      481) and transform_counter_next_frame, transform_counter_next_frame);
    transform_counter_next_frame_choices(2) := choice(transform_counter_group_differs,
      transform_counter_next_frame_choices(1), transform_counter_next_frame);
    transform_counter_next_frame_choices(3) := choice(transform_counter_group_all, in_valid, in_valid and (not
      in_start_of_frame));
    transform_counter_next_frame_choices(4) := choice(transform_counter_next_frame_choices(2),
      transform_counter_next_frame_choices(3), transform_counter_group_is_equals(1) and
      transform_counter_group_is_equals(2) and in_valid and in_start_of_frame);
    transform_read_column_inside_0_is_less := 3 < transform_counter_column;
    transform_left_filter_feature_0_values(1) := is_set(transform_left_filter_column(4, 2), 1);
    transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_values(1)) or (not
      is_set(transform_left_filter_column(4, 2), 0));
    transform_left_filter_feature_0_is_equal := (transform_left_filter_column(4, 2) mod 4) = 0;
    for i in 2 to 6 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(4, 2), i);
    end loop;
    for i in 0 to 3 loop
      for j in 0 to 4 loop
        transform_left_filter_feature_0_choice(40 * i + 8 * j + 8) := is_larger(transform_left_filter_column(8 - i, j),
          transform_left_filter_column(4, 2), 0, 7, false);
      end loop;
    end loop;
    transform_left_filter_feature_0_choice(167) := not is_larger(transform_left_filter_column(4, 4),
      transform_left_filter_column(4, 2), 0, 6, false);
    transform_left_filter_feature_0_choice(168) := choice(is_set(transform_left_filter_column(4, 4), 7),
      transform_filtering_0_column_inside(4), transform_filtering_0_column_inside(4) and (not
      is_set(transform_left_filter_column(4, 2), 7)));
    transform_left_filter_feature_0_choice(169) := choice(transform_left_filter_feature_0_choice(167),
      is_set(transform_left_filter_column(4, 4), 7) and transform_filtering_0_column_inside(4) and (not
      is_set(transform_left_filter_column(4, 2), 7)), transform_left_filter_feature_0_choice(168));
    transform_left_filter_feature_0_choice(177) := is_larger(transform_left_filter_column(4, 1),
      transform_left_filter_column(4, 2), 0, 7, false);
    transform_left_filter_feature_0_choice(185) := is_larger(transform_left_filter_column(4, 3),
      transform_left_filter_column(4, 2), 0, 7, false);
    transform_left_filter_feature_0_choice(193) := is_larger(transform_left_filter_column(4, 0),
      transform_left_filter_column(4, 2), 0, 7, false);
    for i in 0 to 2 loop
      transform_left_filter_feature_0_choice(40 * i + 201) := is_larger(transform_left_filter_column(3 - i, 3),
        transform_left_filter_column(4, 2), 0, 7, false);
      transform_left_filter_feature_0_choice(40 * i + 209) := is_larger(transform_left_filter_column(3 - i, 4),
        transform_left_filter_column(4, 2), 0, 7, false);
      for j in 0 to 2 loop
        transform_left_filter_feature_0_choice(40 * i + 8 * j + 217) := is_larger(transform_left_filter_column(3 - i, 2
          - j), transform_left_filter_column(4, 2), 0, 7, false);
      end loop;
    end loop;
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(16 * i + 321) := is_larger(transform_left_filter_column(0, 3 - i),
        transform_left_filter_column(4, 2), 0, 7, false);
      transform_left_filter_feature_0_choice(16 * i + 329) := is_larger(transform_left_filter_column(0, 4 - 3 * i),
        transform_left_filter_column(4, 2), 0, 7, false);
    end loop;
    for i in 7 to 11 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(0, 0), i - 5);
    end loop;
    transform_left_filter_feature_0_choice(353) := not is_larger(transform_left_filter_column(4, 2),
      transform_left_filter_column(0, 0), 0, 7, true);
    transform_left_filter_feature_0_choice_354 := choice(transform_filtering_0_column_inside(0),
      (as_number(transform_left_filter_feature_0_choice(321)) * 8) +
      (as_number(transform_left_filter_feature_0_choice(329)) * 16) +
      (as_number(transform_left_filter_feature_0_choice(337)) * 4) +
      (as_number(transform_left_filter_feature_0_choice(345)) * 2) +
      as_number(transform_left_filter_feature_0_choice(353)), 0);
    transform_left_filter_feature_0_choice_355 := choice(transform_filtering_0_column_inside(1),
      (as_number(transform_left_filter_feature_0_choice(281)) * 256) +
      (as_number(transform_left_filter_feature_0_choice(289)) * 512) +
      (as_number(transform_left_filter_feature_0_choice(297)) * 128) +
      (as_number(transform_left_filter_feature_0_choice(305)) * 64) +
      (as_number(transform_left_filter_feature_0_choice(313)) * 32) + transform_left_filter_feature_0_choice_354,
      transform_left_filter_feature_0_choice_354);
    transform_left_filter_feature_0_choice_356 := choice(transform_filtering_0_column_inside(2),
      (as_number(transform_left_filter_feature_0_choice(241)) * 8192) +
      (as_number(transform_left_filter_feature_0_choice(249)) * 16384) +
      (as_number(transform_left_filter_feature_0_choice(257)) * 4096) +
      (as_number(transform_left_filter_feature_0_choice(265)) * 2048) +
      (as_number(transform_left_filter_feature_0_choice(273)) * 1024) + transform_left_filter_feature_0_choice_355,
      transform_left_filter_feature_0_choice_355);
    transform_left_filter_feature_0_choice_357 := choice(transform_filtering_0_column_inside(3),
      (as_number(transform_left_filter_feature_0_choice(201)) * 262144) +
      (as_number(transform_left_filter_feature_0_choice(209)) * 524288) +
      (as_number(transform_left_filter_feature_0_choice(217)) * 131072) +
      (as_number(transform_left_filter_feature_0_choice(225)) * 65536) +
      (as_number(transform_left_filter_feature_0_choice(233)) * 32768) + transform_left_filter_feature_0_choice_356,
      transform_left_filter_feature_0_choice_356);
    transform_left_filter_feature_0_choice_358 := choice(transform_filtering_0_column_inside(4),
      (as_number(transform_left_filter_feature_0_choice(177)) * 2097152) +
      (as_number(transform_left_filter_feature_0_choice(185)) * 4194304) +
      (as_number(transform_left_filter_feature_0_choice(193)) * 1048576) + transform_left_filter_feature_0_choice_357,
      transform_left_filter_feature_0_choice_357);
    transform_left_filter_feature_0_choice_359 := choice(transform_filtering_0_column_inside(5),
      (as_number(transform_left_filter_feature_0_choice(128)) * 16777216) +
      (as_number(transform_left_filter_feature_0_choice(136)) * 33554432) +
      (as_number(transform_left_filter_feature_0_choice(144)) * 67108864) +
      (as_number(transform_left_filter_feature_0_choice(152)) * 134217728) +
      (as_number(transform_left_filter_feature_0_choice(160)) * 268435456) +
      (as_number(transform_left_filter_feature_0_choice(169)) * 8388608) + transform_left_filter_feature_0_choice_358,
      (as_number(transform_left_filter_feature_0_choice(169)) * 8388608) + transform_left_filter_feature_0_choice_358);
    if transform_filtering_0_column_inside(6) then
      transform_left_filter_feature_0_choice_360 := to_unsigned(as_number(transform_left_filter_feature_0_choice(120)),
        1) & to_unsigned(as_number(transform_left_filter_feature_0_choice(112)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(104)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(96)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(88)), 1) &
        to_unsigned(transform_left_filter_feature_0_choice_359, 29);
    else
      transform_left_filter_feature_0_choice_360 := to_unsigned(transform_left_filter_feature_0_choice_359, 34);
    end if;
    if transform_filtering_0_column_inside(7) then
      transform_left_filter_feature_0_choice_361 := to_unsigned(as_number(transform_left_filter_feature_0_choice(80)),
        1) & to_unsigned(as_number(transform_left_filter_feature_0_choice(72)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(64)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(56)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(48)), 1) &
        transform_left_filter_feature_0_choice_360(33 downto 0);
    else
      transform_left_filter_feature_0_choice_361 := resize(transform_left_filter_feature_0_choice_360, 39);
    end if;
    transform_right_filter_feature_0_values(1) := is_set(transform_right_filter_column(4, 2), 1);
    transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_values(1)) or (not
      is_set(transform_right_filter_column(4, 2), 0));
    transform_right_filter_feature_0_is_equal := (transform_right_filter_column(4, 2) mod 4) = 0;
    for i in 2 to 6 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(4, 2), i);
    end loop;
    for i in 0 to 3 loop
      for j in 0 to 4 loop
        transform_right_filter_feature_0_choice(40 * i + 8 * j + 8) := is_larger(transform_right_filter_column(8 - i,
          j), transform_right_filter_column(4, 2), 0, 7, false);
      end loop;
    end loop;
    transform_right_filter_feature_0_choice(167) := not is_larger(transform_right_filter_column(4, 4),
      transform_right_filter_column(4, 2), 0, 6, false);
    transform_right_filter_feature_0_choice(168) := choice(is_set(transform_right_filter_column(4, 4), 7),
      transform_filtering_0_column_inside(4), transform_filtering_0_column_inside(4) and (not
      is_set(transform_right_filter_column(4, 2), 7)));
    transform_right_filter_feature_0_choice(169) := choice(transform_right_filter_feature_0_choice(167),
      is_set(transform_right_filter_column(4, 4), 7) and transform_filtering_0_column_inside(4) and (not
      is_set(transform_right_filter_column(4, 2), 7)), transform_right_filter_feature_0_choice(168));
    transform_right_filter_feature_0_choice(177) := is_larger(transform_right_filter_column(4, 1),
      transform_right_filter_column(4, 2), 0, 7, false);
    transform_right_filter_feature_0_choice(185) := is_larger(transform_right_filter_column(4, 3),
      transform_right_filter_column(4, 2), 0, 7, false);
    transform_right_filter_feature_0_choice(193) := is_larger(transform_right_filter_column(4, 0),
      transform_right_filter_column(4, 2), 0, 7, false);
    for i in 0 to 2 loop
      transform_right_filter_feature_0_choice(40 * i + 201) := is_larger(transform_right_filter_column(3 - i, 3),
        transform_right_filter_column(4, 2), 0, 7, false);
      transform_right_filter_feature_0_choice(40 * i + 209) := is_larger(transform_right_filter_column(3 - i, 4),
        transform_right_filter_column(4, 2), 0, 7, false);
      for j in 0 to 2 loop
        transform_right_filter_feature_0_choice(40 * i + 8 * j + 217) := is_larger(transform_right_filter_column(3 - i,
          2 - j), transform_right_filter_column(4, 2), 0, 7, false);
      end loop;
    end loop;
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(16 * i + 321) := is_larger(transform_right_filter_column(0, 3 - i),
        transform_right_filter_column(4, 2), 0, 7, false);
      transform_right_filter_feature_0_choice(16 * i + 329) := is_larger(transform_right_filter_column(0, 4 - 3 * i),
        transform_right_filter_column(4, 2), 0, 7, false);
    end loop;
    for i in 7 to 11 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(0, 0), i - 5);
    end loop;
    transform_right_filter_feature_0_choice(353) := not is_larger(transform_right_filter_column(4, 2),
      transform_right_filter_column(0, 0), 0, 7, true);
    transform_right_filter_feature_0_choice_354 := choice(transform_filtering_0_column_inside(0),
      (as_number(transform_right_filter_feature_0_choice(321)) * 8) +
      (as_number(transform_right_filter_feature_0_choice(329)) * 16) +
      (as_number(transform_right_filter_feature_0_choice(337)) * 4) +
      (as_number(transform_right_filter_feature_0_choice(345)) * 2) +
      as_number(transform_right_filter_feature_0_choice(353)), 0);
    transform_right_filter_feature_0_choice_355 := choice(transform_filtering_0_column_inside(1),
      (as_number(transform_right_filter_feature_0_choice(281)) * 256) +
      (as_number(transform_right_filter_feature_0_choice(289)) * 512) +
      (as_number(transform_right_filter_feature_0_choice(297)) * 128) +
      (as_number(transform_right_filter_feature_0_choice(305)) * 64) +
      (as_number(transform_right_filter_feature_0_choice(313)) * 32) + transform_right_filter_feature_0_choice_354,
      transform_right_filter_feature_0_choice_354);
    transform_right_filter_feature_0_choice_356 := choice(transform_filtering_0_column_inside(2),
      (as_number(transform_right_filter_feature_0_choice(241)) * 8192) +
      (as_number(transform_right_filter_feature_0_choice(249)) * 16384) +
      (as_number(transform_right_filter_feature_0_choice(257)) * 4096) +
      (as_number(transform_right_filter_feature_0_choice(265)) * 2048) +
      (as_number(transform_right_filter_feature_0_choice(273)) * 1024) + transform_right_filter_feature_0_choice_355,
      transform_right_filter_feature_0_choice_355);
    transform_right_filter_feature_0_choice_357 := choice(transform_filtering_0_column_inside(3),
      (as_number(transform_right_filter_feature_0_choice(201)) * 262144) +
      (as_number(transform_right_filter_feature_0_choice(209)) * 524288) +
      (as_number(transform_right_filter_feature_0_choice(217)) * 131072) +
      (as_number(transform_right_filter_feature_0_choice(225)) * 65536) +
      (as_number(transform_right_filter_feature_0_choice(233)) * 32768) + transform_right_filter_feature_0_choice_356,
      transform_right_filter_feature_0_choice_356);
    transform_right_filter_feature_0_choice_358 := choice(transform_filtering_0_column_inside(4),
      (as_number(transform_right_filter_feature_0_choice(177)) * 2097152) +
      (as_number(transform_right_filter_feature_0_choice(185)) * 4194304) +
      (as_number(transform_right_filter_feature_0_choice(193)) * 1048576) +
      transform_right_filter_feature_0_choice_357, transform_right_filter_feature_0_choice_357);
    transform_right_filter_feature_0_choice_359 := choice(transform_filtering_0_column_inside(5),
      (as_number(transform_right_filter_feature_0_choice(128)) * 16777216) +
      (as_number(transform_right_filter_feature_0_choice(136)) * 33554432) +
      (as_number(transform_right_filter_feature_0_choice(144)) * 67108864) +
      (as_number(transform_right_filter_feature_0_choice(152)) * 134217728) +
      (as_number(transform_right_filter_feature_0_choice(160)) * 268435456) +
      (as_number(transform_right_filter_feature_0_choice(169)) * 8388608) +
      transform_right_filter_feature_0_choice_358, (as_number(transform_right_filter_feature_0_choice(169)) * 8388608)
      + transform_right_filter_feature_0_choice_358);
    if transform_filtering_0_column_inside(6) then
      transform_right_filter_feature_0_choice_360 :=
        to_unsigned(as_number(transform_right_filter_feature_0_choice(120)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(112)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(104)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(96)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(88)), 1) &
        to_unsigned(transform_right_filter_feature_0_choice_359, 29);
    else
      transform_right_filter_feature_0_choice_360 := to_unsigned(transform_right_filter_feature_0_choice_359, 34);
    end if;
    if transform_filtering_0_column_inside(7) then
      transform_right_filter_feature_0_choice_361 :=
        to_unsigned(as_number(transform_right_filter_feature_0_choice(80)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(72)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(64)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(56)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(48)), 1) &
        transform_right_filter_feature_0_choice_360(33 downto 0);
    else
      transform_right_filter_feature_0_choice_361 := resize(transform_right_filter_feature_0_choice_360, 39);
    end if;
    transform_left_0 <= in_left_pixel;
    transform_right_0 <= in_right_pixel;
    transform_valid <= in_valid;
    transform_counter_next_frame <= transform_counter_next_frame_choices(4) or ((not in_valid) and
      transform_counter_next_frame);
    transform_left_rows_read_newest_0 <= transform_left_0;
    transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
    transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
    transform_right_rows_read_newest_0 <= transform_right_0;
    transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
    transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
    transform_read_column <= transform_counter_column;
    transform_read_row_inside(0) <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
      (transform_counter_group mod 4)) < 480;
    transform_read_row_inside(1) <= (transform_counter_group >= 3) and (transform_counter_group < 483);
    transform_read_row_inside(2) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 480;
    transform_read_row_inside(3) <= (transform_counter_group >= 1) and (transform_counter_group < 481);
    transform_read_row_inside(4) <= transform_counter_group < 480;
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
    transform_ready_row_inside <= transform_read_row_inside;
    transform_ready_column_inside <= transform_read_column_inside;
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
    transform_columns_row_inside <= transform_ready_row_inside;
    transform_columns_column_inside <= transform_ready_column_inside;
    transform_columns_start_of_frame <= transform_ready_start_of_frame;
    transform_columns_valid <= transform_ready_valid;
    transform_filtering_0_column_inside <= transform_columns_column_inside;
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
    transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
    transform_filtering_valid(1) <= transform_filtering_valid(0);
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice * 32,
      transform_counter_group_choices(3));
    if transform_filtering_0_column_inside(8) then
      transform_left_filter_feature_0 <= to_unsigned(as_number(transform_left_filter_feature_0_choice(40)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(32)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(24)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(16)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(8)), 1) &
        transform_left_filter_feature_0_choice_361(38 downto 0);
      transform_right_filter_feature_0 <= to_unsigned(as_number(transform_right_filter_feature_0_choice(40)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(32)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(24)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(16)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(8)), 1) &
        transform_right_filter_feature_0_choice_361(38 downto 0);
    else
      transform_left_filter_feature_0 <= resize(transform_left_filter_feature_0_choice_361, 44);
      transform_right_filter_feature_0 <= resize(transform_right_filter_feature_0_choice_361, 44);
    end if;
    if in_valid then
      transform_counter_column <= choice(in_start_of_frame or transform_counter_group_is_equals(2), 0,
        (transform_counter_column + 1) mod 1024);
    end if;
    if transform_ready_valid then
      transform_left_rows_write_words_0 <= to_unsigned(transform_left_rows_ready_newest_0, 8) &
        transform_left_rows_ready_words_0(31 downto 8);
      transform_right_rows_write_words_0 <= to_unsigned(transform_right_rows_ready_newest_0, 8) &
        transform_right_rows_ready_words_0(31 downto 8);
      transform_write_column <= transform_ready_column;
    end if;
    if transform_columns_valid then
      for i in 0 to 3 loop
        for j in 0 to 4 loop
          transform_left_filter_column(2 * i + 1, j) <= transform_left_filter_column(2 * i, j);
        end loop;
        for j in 0 to 4 loop
          transform_left_filter_column(2 * i + 2, j) <= transform_left_filter_column(2 * i + 1, j);
        end loop;
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 4 loop
          transform_right_filter_column(2 * i + 1, j) <= transform_right_filter_column(2 * i, j);
        end loop;
        for j in 0 to 4 loop
          transform_right_filter_column(2 * i + 2, j) <= transform_right_filter_column(2 * i + 1, j);
        end loop;
      end loop;
      for i in 0 to 4 loop
        transform_left_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_left_column(i), 0);
        transform_right_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_right_column(i), 0);
      end loop;
    end if;
    -- raster
    raster_place_group_is_equal := raster_place_column = 639;
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(1);
    raster_place_group <= choice(transform_filtering_valid(1) and transform_filtering_start_of_frame(1), 0,
      (raster_place_group + as_number(((raster_place_group /= 480) and transform_filtering_valid(1) and
      raster_place_group_is_equal))) mod 512);
    if transform_filtering_valid(1) then
      raster_place_column <= choice(raster_place_group_is_equal or transform_filtering_start_of_frame(1), 0,
        (raster_place_column + 1) mod 1024);
    end if;
    -- delay
    delay_tag_first_cost_is_equal := raster_place_column = 127;
    delay_tag_map_column_is_not_less := raster_place_column >= 127;
    delay_tag_map_column_is_less := raster_place_column < 640;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_tag.valid <= raster_features_valid;
    delay_tag.first_cost <= delay_tag_first_cost_is_equal;
    delay_tag.map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.output_column <= (raster_place_group < 480) and delay_tag_map_column_is_not_less and
      delay_tag_map_column_is_less;
    delay_tag.start_of_frame <= (raster_place_group = 0) and delay_tag_first_cost_is_equal;
    delay_tag.end_of_line <= raster_place_group_is_equal;
    -- rows
    rows_search_0 <= delay_delayed_0;
    rows_reference_0 <= delay_ahead_0;
    rows_tag <= delay_tag;
    -- line
    if rows_tag.valid then
      line_centre_map_column_0 <= rows_tag.map_column;
      line_centre_first_column_0 <= rows_tag.first_cost;
      line_centre_start_of_frame_0 <= rows_tag.start_of_frame;
    end if;
    line_order_falls_any := (not rows_tag.map_column) or line_centre_map_column_0 or (not rows_tag.valid);
    line_order_falls_all := rows_tag.map_column and (not line_centre_map_column_0) and rows_tag.valid;
    line_order_complete_any := (not rows_tag.map_column) or (not rows_tag.valid);
    line_order_turned_output_column_choice := choice(line_order_falls_all, line_order_output and line_order_complete,
      line_order_held_output);
    line_centre_end_of_line_0 <= rows_tag.end_of_line;
    line_order_inside <= rows_tag.map_column;
    line_order_turned_valid <= rows_tag.valid;
    line_order_turned_output_column <= line_order_turned_output_column_choice and rows_tag.map_column;
    line_order_turned_start_of_frame <= rows_tag.map_column and (not line_centre_map_column_0) and rows_tag.valid and
      line_order_first and line_order_output and line_order_complete;
    line_comes(1) <= line_order_turned_valid;
    line_comes(2 to 33) <= line_comes(1 to 32);
    line_starts_phases(1) <= line_order_turned_valid and line_centre_map_column_0;
    line_starts_phases(2 to 33) <= line_starts_phases(1 to 32);
    line_order_falls <= choice(line_order_falls, line_order_falls_any, line_order_falls_all);
    line_order_complete <= choice(rows_tag.end_of_line, line_order_complete or (rows_tag.map_column and
      rows_tag.valid), line_order_complete and line_order_complete_any);
    line_order_address_choice := choice(line_order_falls, 1023, 1);
    if not line_order_complete_any then
      line_order_address <= choice(line_order_falls_any, (line_order_address_choice + line_order_address) mod 1024,
        as_number((not line_order_falls)) * 512);
    end if;
    if line_order_falls_all then
      line_order_output <= rows_tag.output_column;
      line_order_first <= rows_tag.start_of_frame;
      line_order_held_output <= line_order_output and line_order_complete;
    end if;
    if line_order_turned_valid then
      line_places_map_column(0) <= line_order_inside;
      line_places_first_column(0) <= line_centre_first_column_0;
      line_places_0_top <= line_centre_start_of_frame_0;
      line_places_address(0) <= line_order_address;
      line_places_shown_output_column(0) <= line_order_turned_output_column;
      line_places_shown_start_of_frame(0) <= line_order_turned_start_of_frame;
      line_places_shown_end_of_line(0) <= line_centre_end_of_line_0;
    end if;
    for i in 1 to 2 loop
      if line_comes(8 * i) then
        line_places_map_column(i) <= line_places_map_column(i - 1);
        line_places_first_column(i) <= line_places_first_column(i - 1);
        line_places_address(i) <= line_places_address(i - 1);
        line_places_shown_output_column(i) <= line_places_shown_output_column(i - 1);
        line_places_shown_start_of_frame(i) <= line_places_shown_start_of_frame(i - 1);
        line_places_shown_end_of_line(i) <= line_places_shown_end_of_line(i - 1);
      end if;
    end loop;
    for i in 3 to 4 loop
      if line_comes(8 * i) then
        line_places_map_column(i) <= line_places_map_column(i - 1);
        line_places_shown_output_column(i) <= line_places_shown_output_column(i - 1);
        line_places_shown_start_of_frame(i) <= line_places_shown_start_of_frame(i - 1);
        line_places_shown_end_of_line(i) <= line_places_shown_end_of_line(i - 1);
      end if;
    end loop;
    -- costsshift
    if rows_tag.valid then
      costsshift_newest_0 <= rows_search_0;
      costsshift_new_reference_0 <= rows_reference_0;
    end if;
    costsshift_count_phase_choice := choice(costsshift_count_phase = 7, 7, (costsshift_count_phase + 1) mod 8);
    costsshift_new_tag_valid <= rows_tag.valid or (not is_set(costsshift_count_phase, 2)) or (not
      is_set(costsshift_count_phase, 1)) or (not is_set(costsshift_count_phase, 0));
    costsshift_handed_on_0 <= costsshift_read_words(15);
    costsshift_read_reference_0 <= costsshift_new_reference_0;
    costsshift_read_tag_valid <= costsshift_new_tag_valid;
    costsshift_read_count_phase <= costsshift_count_phase;
    costsshift_reference_0 <= costsshift_read_reference_0;
    costsshift_write_phase <= costsshift_read_count_phase;
    costsshift_count_phase <= choice(rows_tag.valid, 0, costsshift_count_phase_choice);
    if costsshift_read_tag_valid then
      costsshift_search_0(1 to 15) <= costsshift_read_words(0 to 14);
      costsshift_search_0(0) <= choice(costsshift_read_count_phase = 0, costsshift_newest_0, costsshift_handed_on_0);
    end if;
    -- costswindow
    costswindow_first_count(0, 0) <= differing_bits(costsshift_reference_0, costsshift_search_0(0), 0, 2, 1);
    for i in 1 to 7 loop
      costswindow_first_count(0, i) <= differing_bits(costsshift_reference_0, costsshift_search_0(0), 3 * i, 3 * i + 1,
        3 * i + 2);
    end loop;
    costswindow_first_count(0, 8) <= differing_bits(costsshift_reference_0, costsshift_search_0(0), 24, 26, 25);
    for i in 9 to 13 loop
      costswindow_first_count(0, i) <= differing_bits(costsshift_reference_0, costsshift_search_0(0), 3 * i, 3 * i + 1,
        3 * i + 2);
    end loop;
    costswindow_first_count_14(0) <= differing_bits(costsshift_reference_0, costsshift_search_0(0), 43) +
      differing_bits(costsshift_reference_0, costsshift_search_0(0), 42);
    for i in 1 to 15 loop
      costswindow_first_count(i, 0) <= differing_bits(costsshift_search_0(i), costsshift_reference_0, 0, 2, 1);
      for j in 1 to 7 loop
        costswindow_first_count(i, j) <= differing_bits(costsshift_search_0(i), costsshift_reference_0, 3 * j, 3 * j +
          1, 3 * j + 2);
      end loop;
      costswindow_first_count(i, 8) <= differing_bits(costsshift_search_0(i), costsshift_reference_0, 24, 26, 25);
      for j in 9 to 13 loop
        costswindow_first_count(i, j) <= differing_bits(costsshift_search_0(i), costsshift_reference_0, 3 * j, 3 * j +
          1, 3 * j + 2);
      end loop;
      costswindow_first_count_14(i) <= differing_bits(costsshift_search_0(i), costsshift_reference_0, 43) +
        differing_bits(costsshift_search_0(i), costsshift_reference_0, 42);
    end loop;
    for i in 0 to 15 loop
      costswindow_sum_0(i) <= ((others_from_3(18 - i) / 65536) mod 16) + ((others_from_3(18 - i) / 256) mod 16) +
        (others_from_3(18 - i) / 16777216) + (others_from_3(18 - i) mod 16);
    end loop;
    -- costs
    for i in 0 to 15 loop costs_cost(i) <= costswindow_sum_0(i) / 4; end loop;
    -- paths
    paths_smallest_cost_choice := choice(line_comes(10), 15, paths_smallest_cost);
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
    paths_sum(7) <= ((pathsturn_sum_memory_ready_words(3) mod 256) / 2) + pathsright_cost(7);
    paths_sum(8) <= ((pathsturn_sum_memory_ready_words(3) / 256) mod 128) + pathsright_cost(8);
    paths_sum(9) <= ((pathsturn_sum_memory_ready_words(4) mod 64) * 2) + (pathsturn_sum_memory_ready_words(3) / 32768)
      + pathsright_cost(9);
    paths_sum(10) <= ((pathsturn_sum_memory_ready_words(4) / 64) mod 128) + pathsright_cost(10);
    paths_sum(11) <= ((pathsturn_sum_memory_ready_words(5) mod 16) * 8) + (pathsturn_sum_memory_ready_words(4) / 8192)
      + pathsright_cost(11);
    paths_sum(12) <= ((pathsturn_sum_memory_ready_words(5) / 16) mod 128) + pathsright_cost(12);
    paths_sum(13) <= ((pathsturn_sum_memory_ready_words(6) mod 4) * 32) + (pathsturn_sum_memory_ready_words(5) / 2048)
      + pathsright_cost(13);
    paths_sum(14) <= ((pathsturn_sum_memory_ready_words(6) / 4) mod 128) + pathsright_cost(14);
    paths_sum(15) <= pathsright_cost(15) + (pathsturn_sum_memory_ready_words(6) / 512);
    for i in 0 to 7 loop paths_tree_smallest(i) <= smaller(costs_cost(2 * i + 1), costs_cost(2 * i)); end loop;
    paths_tree_next_smallest(0) <= smaller(paths_tree_smallest(1), paths_tree_smallest(0));
    paths_tree_next_smallest(1) <= smaller(paths_tree_smallest(3), paths_tree_smallest(2));
    paths_tree_next_smallest(2) <= smaller(paths_tree_smallest(5), paths_tree_smallest(4));
    paths_tree_next_smallest(3) <= smaller(paths_tree_smallest(7), paths_tree_smallest(6));
    paths_tree_next_next_smallest(0) <= smaller(paths_tree_next_smallest(1), paths_tree_next_smallest(0));
    paths_tree_next_next_smallest(1) <= smaller(paths_tree_next_smallest(3), paths_tree_next_smallest(2));
    paths_tree_next_next_next_smallest_0 <= smaller(paths_tree_next_next_smallest(1), paths_tree_next_next_smallest(0));
    paths_smallest_cost <= smaller(paths_tree_next_next_next_smallest_0, paths_smallest_cost_choice);
    paths_cost_delay_ring_read_address <= choice(paths_cost_delay_ring_read_address = 12, 0,
      (paths_cost_delay_ring_read_address + 1) mod 16);
    -- pathsleft
    if line_starts_phases(13) then pathsleft_low_address <= (pathsleft_low_address + 1) mod 16; end if;
    pathsleft_read_count_phase_is_equal := pathsleft_read_count_phase = 7;
    pathsleft_read_count_phase_choice := choice(pathsleft_read_count_phase_is_equal, 7, (pathsleft_read_count_phase +
      1) mod 8);
    pathsleft_ahead_count_phase_choice := choice(pathsleft_ahead_count_phase = 7, 7, (pathsleft_ahead_count_phase + 1)
      mod 8);
    for i in 3 to 4 loop
      pathsleft_stay_value(5 * i - 15, 1) := to_integer(pathsleft_read_words(i)(11 downto 6));
      pathsleft_stay_choice(5 * i - 15) := smaller(pathsleft_stay_value(5 * i - 15, 1),
        to_integer(pathsleft_read_words(i - 3)(5 downto 0)));
      pathsleft_stay_value(5 * i - 14, 1) := to_integer(pathsleft_read_words(i)(17 downto 12));
      pathsleft_stay_value(5 * i - 14, 2) := to_integer(pathsleft_read_words(i - 3)(11 downto 6));
      pathsleft_stay_choice(5 * i - 14) := smaller(pathsleft_stay_value(5 * i - 14, 1), pathsleft_stay_value(5 * i -
        14, 2));
      pathsleft_stay_value(5 * i - 13, 1) := to_integer(pathsleft_read_words(i)(23 downto 18));
      pathsleft_stay_value(5 * i - 13, 2) := to_integer(pathsleft_read_words(i - 3)(17 downto 12));
      pathsleft_stay_choice(5 * i - 13) := smaller(pathsleft_stay_value(5 * i - 13, 1), pathsleft_stay_value(5 * i -
        13, 2));
      pathsleft_stay_value(5 * i - 12, 1) := to_integer(pathsleft_read_words(i - 3)(23 downto 18));
      pathsleft_stay_choice(5 * i - 12) := smaller(to_integer(pathsleft_read_words(i)(29 downto 24)),
        pathsleft_stay_value(5 * i - 12, 1));
      pathsleft_stay_choice(5 * i - 11) := smaller(to_integer(pathsleft_read_words(i + 1)(5 downto 0)),
        to_integer(pathsleft_read_words(i - 3)(29 downto 24)));
    end loop;
    pathsleft_stay_value(10, 1) := to_integer(pathsleft_read_words(5)(11 downto 6));
    pathsleft_stay_choice(10) := smaller(pathsleft_stay_value(10, 1), to_integer(pathsleft_read_words(2)(5 downto 0)));
    pathsleft_stay_value(11, 1) := to_integer(pathsleft_read_words(5)(17 downto 12));
    pathsleft_stay_value(11, 2) := to_integer(pathsleft_read_words(2)(11 downto 6));
    pathsleft_stay_choice(11) := smaller(pathsleft_stay_value(11, 1), pathsleft_stay_value(11, 2));
    pathsleft_stay_value(12, 1) := to_integer(pathsleft_read_words(5)(23 downto 18));
    pathsleft_stay_value(12, 2) := to_integer(pathsleft_read_words(2)(17 downto 12));
    pathsleft_stay_choice(12) := smaller(pathsleft_stay_value(12, 1), pathsleft_stay_value(12, 2));
    pathsleft_stay_value(13, 1) := to_integer(pathsleft_read_words(2)(23 downto 18));
    pathsleft_stay_choice(13) := smaller(to_integer(pathsleft_read_words(5)(29 downto 24)), pathsleft_stay_value(13,
      1));
    pathsleft_stay_choice(14) := smaller(to_integer(pathsleft_read_words_6(5 downto 0)),
      to_integer(pathsleft_read_words(2)(29 downto 24)));
    pathsleft_stay_choice(15) := smaller(to_integer(pathsleft_read_words_6(11 downto 6)),
      to_integer(pathsleft_read_words(3)(5 downto 0)));
    pathsleft_step_choice(0, 1) := choice(pathsleft_is_first, pathsleft_stay_value(1, 2), pathsleft_lower_neighbour);
    pathsleft_step_choice(0, 2) := smaller(pathsleft_stay_value(1, 2), pathsleft_step_choice(0, 1));
    for i in 0 to 1 loop
      pathsleft_step_choice(5 * i + 1, 1) := smaller(pathsleft_stay_value(5 * i + 2, 2),
        to_integer(pathsleft_read_words(i)(5 downto 0)));
      pathsleft_step_choice(5 * i + 2, 1) := smaller(pathsleft_stay_value(5 * i + 3, 1), pathsleft_stay_value(5 * i +
        1, 2));
      pathsleft_step_choice(5 * i + 3, 1) := smaller(to_integer(pathsleft_read_words(i)(29 downto 24)),
        pathsleft_stay_value(5 * i + 2, 2));
      pathsleft_step_choice(5 * i + 4, 1) := smaller(to_integer(pathsleft_read_words(i + 1)(5 downto 0)),
        pathsleft_stay_value(5 * i + 3, 1));
      pathsleft_step_choice(5 * i + 5, 1) := smaller(pathsleft_stay_value(5 * i + 6, 2),
        to_integer(pathsleft_read_words(i)(29 downto 24)));
    end loop;
    pathsleft_step_choice(11, 1) := smaller(pathsleft_stay_value(12, 2), to_integer(pathsleft_read_words(2)(5 downto
      0)));
    pathsleft_step_choice(12, 1) := smaller(pathsleft_stay_value(13, 1), pathsleft_stay_value(11, 2));
    pathsleft_step_choice(13, 1) := smaller(to_integer(pathsleft_read_words(2)(29 downto 24)), pathsleft_stay_value(12,
      2));
    pathsleft_step_choice(14, 1) := smaller(to_integer(pathsleft_read_words(3)(5 downto 0)), pathsleft_stay_value(13,
      1));
    pathsleft_step_choice(15, 1) := choice(pathsleft_is_last, to_integer(pathsleft_read_words(2)(29 downto 24)),
      to_integer(pathsleft_read_neighbour_0));
    pathsleft_step_choice(15, 2) := smaller(pathsleft_step_choice(15, 1), to_integer(pathsleft_read_words(2)(29 downto
      24)));
    for i in 0 to 1 loop
      pathsleft_stay_change_value(8 * i + 1) := to_integer(paths_cost_delay_held(i)(7 downto 0)) / 16;
      for j in 2 to 6 loop
        pathsleft_stay_change_value(8 * i + j) := to_integer(paths_cost_delay_held(i)(4 * j + 3 downto 4 * j));
      end loop;
    end loop;
    pathsleft_write_count_phase_choice := choice(pathsleft_write_count_phase = 7, 7, (pathsleft_write_count_phase + 1)
      mod 8);
    pathsleft_low_0_choice := choice(line_comes(25), 63, pathsleft_low_0);
    pathsleft_lost <= pathsleft_lowest_0(5) = '1';
    pathsleft_short_of <= ((to_integer(pathsleft_lowest_0(4 downto 0)) + pathsleft_room) / 32) = 1;
    pathsleft_missing <= (to_integer(pathsleft_lowest_0) + pathsleft_room) mod 32;
    pathsleft_below <= (0 - to_integer(pathsleft_lowest_0)) mod 32;
    pathsleft_is_first <= pathsleft_read_count_phase = 0;
    pathsleft_is_last <= pathsleft_read_count_phase_is_equal;
    pathsleft_lower_neighbour <= to_integer(pathsleft_read_words(3)(5 downto 0));
    for i in 0 to 1 loop
      pathsleft_stay_change(8 * i) <= (to_integer(paths_cost_delay_held(i)(3 downto 0)) - pathsleft_g) mod 64;
      for j in 1 to 6 loop
        pathsleft_stay_change(8 * i + j) <= (pathsleft_stay_change_value(8 * i + j) - pathsleft_g) mod 64;
      end loop;
      pathsleft_stay_change(8 * i + 7) <= (to_integer(paths_cost_delay_held(i)(31 downto 28)) - pathsleft_g) mod 64;
    end loop;
    for i in 0 to 1 loop
      pathsleft_step_change(8 * i) <= (to_integer(paths_cost_delay_held(i)(3 downto 0)) - pathsleft_g_less) mod 64;
      for j in 1 to 6 loop
        pathsleft_step_change(8 * i + j) <= (pathsleft_stay_change_value(8 * i + j) - pathsleft_g_less) mod 64;
      end loop;
      pathsleft_step_change(8 * i + 7) <= (to_integer(paths_cost_delay_held(i)(31 downto 28)) - pathsleft_g_less) mod
        64;
    end loop;
    pathsleft_read_count_phase <= choice(line_starts_phases(17), 0, pathsleft_read_count_phase_choice);
    pathsleft_ahead_count_phase <= choice(line_starts_phases(16), 0, pathsleft_ahead_count_phase_choice);
    for i in 0 to 15 loop
      pathsleft_stay(i) <= choice((not is_set(pathsleft_stay_choice(i), 5)) and (not pathsleft_first),
        pathsleft_stay_choice(i), 32);
    end loop;
    pathsleft_step(0) <= choice(pathsleft_first, 32, pathsleft_step_choice(0, 2));
    for i in 1 to 14 loop pathsleft_step(i) <= choice(pathsleft_first, 32, pathsleft_step_choice(i, 1)); end loop;
    pathsleft_step(15) <= choice(pathsleft_first, 32, pathsleft_step_choice(15, 2));
    pathsleft_write_count_phase <= choice(line_starts_phases(20), 0, pathsleft_write_count_phase_choice);
    for i in 0 to 7 loop
      pathsleft_tree_smallest(i) <= smaller(pathsleft_cost(2 * i + 1), pathsleft_cost(2 * i));
    end loop;
    for i in 0 to 3 loop
      pathsleft_tree_next_smallest(i) <= smaller(pathsleft_tree_smallest(2 * i + 1), pathsleft_tree_smallest(2 * i));
    end loop;
    pathsleft_tree_next_next_smallest(0) <= smaller(pathsleft_tree_next_smallest(1), pathsleft_tree_next_smallest(0));
    pathsleft_tree_next_next_smallest(1) <= smaller(pathsleft_tree_next_smallest(3), pathsleft_tree_next_smallest(2));
    pathsleft_tree_next_next_next_smallest_0 <= smaller(pathsleft_tree_next_next_smallest(1),
      pathsleft_tree_next_next_smallest(0));
    pathsleft_low_0 <= smaller(pathsleft_tree_next_next_next_smallest_0, pathsleft_low_0_choice);
    pathsleft_q_choices(1) := choice(pathsleft_short_of, pathsleft_missing, 0);
    pathsleft_q_choices(2) := choice(pathsleft_lost, pathsleft_room, pathsleft_q_choices(1));
    pathsleft_room_left_choice := choice(pathsleft_short_of, pathsleft_below, pathsleft_room);
    if line_starts_phases(16) then
      pathsleft_q <= choice(line_places_first_column(1), 24, pathsleft_q_choices(2));
      pathsleft_room_left <= choice(pathsleft_lost, 0, pathsleft_room_left_choice);
    end if;
    if line_starts_phases(17) then
      pathsleft_q_now <= pathsleft_q;
      pathsleft_q_less <= ((((pathsleft_q / 4) + 15) mod 16) * 4) + (pathsleft_q mod 4);
      pathsleft_room <= choice(line_places_first_column(2), 0, (pathsleft_room_left + pathsleft_start_cost(9)) mod 32);
      pathsleft_start_cost(1) <= choice(line_places_first_column(2), 0, pathsleft_q_now);
      for i in 2 to 9 loop
        pathsleft_start_cost(i) <= choice(line_places_first_column(2), 0, pathsleft_start_cost(i - 1));
      end loop;
    end if;
    if line_starts_phases(18) then
      pathsleft_first <= line_places_first_column(2);
      pathsleft_g <= paths_smallest_cost + pathsleft_q_now;
      pathsleft_g_less <= (paths_smallest_cost + pathsleft_q_less) mod 64;
    end if;
    pathsleft_cost_0_any := (not is_set(pathsleft_write_count_phase, 2)) or (not is_set(pathsleft_write_count_phase,
      1)) or (not is_set(pathsleft_write_count_phase, 0)) or line_starts_phases(20);
    if pathsleft_cost_0_any then
      for i in 0 to 15 loop pathsleft_cost(i) <= (pathsleft_stay(i) + pathsleft_stay_change(i)) mod 64; end loop;
      for i in 0 to 15 loop pathsleft_arrived(i) <= (pathsleft_step(i) + pathsleft_step_change(i)) mod 64; end loop;
    end if;
    if line_starts_phases(33) then pathsleft_low_write_address <= (pathsleft_low_write_address + 1) mod 16; end if;
    -- pathsabove
    pathsabove_memory_read_address_0_sum := pathsabove_read_address_address + 1;
    pathsabove_memory_read_address_0_choice := choice(line_places_first_column(0), 0,
      pathsabove_memory_read_address_0_sum mod 4096);
    pathsabove_memory_read_address_0_sum_2 := pathsabove_read_address_address + as_number(((not
      is_set(pathsabove_read_address_count_phase, 2)) or (not is_set(pathsabove_read_address_count_phase, 1)) or (not
      is_set(pathsabove_read_address_count_phase, 0))));
    pathsabove_memory_read_address_1_choice := choice(line_places_first_column(0), 0,
      pathsabove_memory_read_address_0_sum mod 8);
    pathsabove_memory_bank_choices(1) := choice(line_places_first_column(0), 0, pathsabove_memory_read_address_0_sum
      mod 8192);
    pathsabove_memory_bank_choices(2) := choice(line_starts_phases(2), pathsabove_memory_bank_choices(1),
      pathsabove_memory_read_address_0_sum_2 mod 8192);
    pathsabove_read_address_count_phase_choice := choice(pathsabove_read_address_count_phase = 7, 7,
      (pathsabove_read_address_count_phase + 1) mod 8);
    pathsabove_ready_top_choices(1) := choice(line_starts_phases(5), line_places_first_column(0) or
      pathsabove_ready_top, pathsabove_ready_top);
    pathsabove_ready_top_choices(2) := choice(line_starts_phases(5), (not line_places_first_column(0)) and
      pathsabove_ready_top, pathsabove_ready_top);
    pathsabove_total_choice(0) := choice(pathsabove_ready_top, 24, pathsabove_memory_ready_words(0) mod 32);
    pathsabove_total_choice(1) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(0) / 32) mod 32);
    pathsabove_total_choice(2) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(0) / 1024) mod 32);
    pathsabove_total_choice(3) := choice(pathsabove_ready_top, 24, ((pathsabove_memory_ready_words(1) mod 16) * 2) +
      (pathsabove_memory_ready_words(0) / 32768));
    pathsabove_total_choice(4) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(1) / 16) mod 32);
    pathsabove_total_choice(5) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(1) / 512) mod 32);
    pathsabove_total_choice(6) := choice(pathsabove_ready_top, 24, ((pathsabove_memory_ready_words(2) mod 8) * 4) +
      (pathsabove_memory_ready_words(1) / 16384));
    pathsabove_total_choice(7) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(2) mod 256) / 8);
    pathsabove_total_choice(8) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(2) / 256) mod 32);
    pathsabove_total_choice(9) := choice(pathsabove_ready_top, 24, ((pathsabove_memory_ready_words(3) mod 4) * 8) +
      (pathsabove_memory_ready_words(2) / 8192));
    pathsabove_total_choice(10) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(3) mod 128) / 4);
    pathsabove_total_choice(11) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(3) / 128) mod 32);
    pathsabove_total_choice(12) := choice(pathsabove_ready_top, 24, ((pathsabove_memory_ready_words(4) mod 2) * 16) +
      (pathsabove_memory_ready_words(3) / 4096));
    pathsabove_total_choice(13) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(4) mod 64) / 2);
    pathsabove_total_choice(14) := choice(pathsabove_ready_top, 24, (pathsabove_memory_ready_words(4) / 64) mod 32);
    pathsabove_total_choice(15) := choice(pathsabove_ready_top, 24, pathsabove_memory_ready_words(4) / 2048);
    pathsabove_smallest_total_choice := choice(line_comes(11), 63, pathsabove_smallest_total);
    pathsabove_count_phase_is_equal := pathsabove_count_phase = 7;
    pathsabove_count_phase_choice := choice(pathsabove_count_phase_is_equal, 7, (pathsabove_count_phase + 1) mod 8);
    pathsabove_beside_choice(0) := choice(pathsabove_count_phase = 0, pathsabove_held(1), pathsabove_lower_neighbour);
    pathsabove_beside_choice(15) := choice(pathsabove_count_phase_is_equal, pathsabove_held(14), pathsabove_cost(0));
    pathsabove_write_address_address_choice := choice(line_places_first_column(2), 0, (pathsabove_write_address_address
      + 1) mod 8192);
    pathsabove_write_address_count_phase_choice := choice(pathsabove_write_address_count_phase = 7, 7,
      (pathsabove_write_address_count_phase + 1) mod 8);
    pathsabove_memory_bank <= is_set(pathsabove_memory_bank_choices(2), 12);
    pathsabove_memory_read_bank <= pathsabove_memory_bank;
    for i in 0 to 4 loop pathsabove_memory_held_words(0, i) <= to_integer(pathsabove_memory_read_words(0, i)); end loop;
    for i in 0 to 4 loop pathsabove_memory_held_words(1, i) <= to_integer(pathsabove_memory_read_words(1, i)); end loop;
    pathsabove_memory_held_bank <= pathsabove_memory_read_bank;
    pathsabove_read_address_address <= pathsabove_memory_bank_choices(2);
    for i in 0 to 15 loop pathsabove_total(i) <= costs_cost(i) + pathsabove_total_choice(i); end loop;
    for i in 0 to 2 loop
      pathsabove_cost(5 * i) <= (to_integer(pathsabove_delay_held(i)) - pathsabove_smallest) mod 64;
      pathsabove_cost(5 * i + 1) <= (to_integer(pathsabove_delay_held(i)(29 downto 6)) - pathsabove_smallest) mod 64;
      pathsabove_cost(5 * i + 2) <= (to_integer(pathsabove_delay_held(i)(29 downto 12)) - pathsabove_smallest) mod 64;
      pathsabove_cost(5 * i + 3) <= (to_integer(pathsabove_delay_held(i)(29 downto 18)) - pathsabove_smallest) mod 64;
      pathsabove_cost(5 * i + 4) <= (to_integer(pathsabove_delay_held(i)(29 downto 24)) - pathsabove_smallest) mod 64;
    end loop;
    pathsabove_cost(15) <= (to_integer(pathsabove_delay_held_3) - pathsabove_smallest) mod 64;
    pathsabove_held <= pathsabove_cost;
    pathsabove_lower_neighbour <= pathsabove_held(15);
    pathsabove_own <= pathsabove_held(0 to 14);
    for i in 0 to 15 loop
      pathsabove_step(i) <= (((pathsabove_beside(i) / 4) + 1) * 4) + (pathsabove_beside(i) mod 4);
    end loop;
    pathsabove_write_address_is_here <= line_starts_phases(23) or (not is_set(pathsabove_write_address_count_phase, 2))
      or (not is_set(pathsabove_write_address_count_phase, 1)) or (not is_set(pathsabove_write_address_count_phase, 0));
    pathsabove_memory_read_address_0 <= choice(line_starts_phases(2), pathsabove_memory_read_address_0_choice,
      pathsabove_memory_read_address_0_sum_2 mod 4096);
    pathsabove_memory_read_address_1 <= choice(line_starts_phases(2), pathsabove_memory_read_address_1_choice,
      pathsabove_memory_read_address_0_sum_2 mod 8);
    pathsabove_read_address_count_phase <= choice(line_starts_phases(2), 0, pathsabove_read_address_count_phase_choice);
    for i in 0 to 4 loop
      pathsabove_memory_ready_words(i) <= choice(pathsabove_memory_held_bank, pathsabove_memory_held_words(1, i),
        pathsabove_memory_held_words(0, i));
    end loop;
    pathsabove_ready_top <= choice(line_places_0_top, pathsabove_ready_top_choices(1), pathsabove_ready_top_choices(2));
    for i in 0 to 7 loop
      pathsabove_tree_smallest(i) <= smaller(pathsabove_total(2 * i + 1), pathsabove_total(2 * i));
    end loop;
    for i in 0 to 3 loop
      pathsabove_tree_next_smallest(i) <= smaller(pathsabove_tree_smallest(2 * i + 1), pathsabove_tree_smallest(2 * i));
    end loop;
    pathsabove_tree_next_next_smallest(0) <= smaller(pathsabove_tree_next_smallest(1),
      pathsabove_tree_next_smallest(0));
    pathsabove_tree_next_next_smallest(1) <= smaller(pathsabove_tree_next_smallest(3),
      pathsabove_tree_next_smallest(2));
    pathsabove_tree_next_next_next_smallest_0 <= smaller(pathsabove_tree_next_next_smallest(1),
      pathsabove_tree_next_next_smallest(0));
    pathsabove_smallest_total <= smaller(pathsabove_tree_next_next_next_smallest_0, pathsabove_smallest_total_choice);
    pathsabove_count_phase <= choice(line_starts_phases(21), 0, pathsabove_count_phase_choice);
    pathsabove_beside(0) <= smaller(pathsabove_held(1), pathsabove_beside_choice(0));
    for i in 1 to 14 loop pathsabove_beside(i) <= smaller(pathsabove_held(i + 1), pathsabove_held(i - 1)); end loop;
    pathsabove_beside(15) <= smaller(pathsabove_beside_choice(15), pathsabove_held(14));
    for i in 0 to 14 loop pathsabove_stay(i) <= choice(pathsabove_own(i) < 24, pathsabove_own(i) mod 32, 24); end loop;
    pathsabove_stay(15) <= choice(pathsabove_lower_neighbour < 24, pathsabove_lower_neighbour mod 32, 24);
    pathsabove_write_address_address <= choice(line_starts_phases(23), pathsabove_write_address_address_choice,
      (pathsabove_write_address_address + as_number(((not is_set(pathsabove_write_address_count_phase, 2)) or (not
      is_set(pathsabove_write_address_count_phase, 1)) or (not is_set(pathsabove_write_address_count_phase, 0))))) mod
      8192);
    pathsabove_write_address_count_phase <= choice(line_starts_phases(23), 0,
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
    pathsabove_memory_write_words_0_choice(2, 1) := choice((pathsabove_step(8) - pathsabove_stay(8)) < 0,
      pathsabove_step(8) mod 32, pathsabove_stay(8));
    pathsabove_memory_write_words_0_choice(2, 2) := choice(pathsabove_memory_write_words_0_is_less(1),
      pathsabove_step(6) mod 32, pathsabove_stay(6));
    pathsabove_memory_write_words_0_choice(2, 3) := choice((pathsabove_step(7) - pathsabove_stay(7)) < 0,
      pathsabove_step(7) mod 32, pathsabove_stay(7));
    pathsabove_memory_write_words_0_is_less(2) := (pathsabove_step(9) - pathsabove_stay(9)) < 0;
    pathsabove_memory_write_words_0_2_choice_4 := choice(pathsabove_memory_write_words_0_is_less(2), pathsabove_step(9)
      mod 8, pathsabove_stay(9) mod 8);
    pathsabove_memory_write_words_0_sum(2) := (pathsabove_memory_write_words_0_choice(2, 1) * 256) +
      (pathsabove_memory_write_words_0_choice(2, 2) / 4) + (pathsabove_memory_write_words_0_choice(2, 3) * 8) +
      (pathsabove_memory_write_words_0_2_choice_4 * 8192);
    pathsabove_memory_write_words_0_choice(3, 1) := choice((pathsabove_step(11) - pathsabove_stay(11)) < 0,
      pathsabove_step(11) mod 32, pathsabove_stay(11));
    pathsabove_memory_write_words_0_choice(3, 2) := choice(pathsabove_memory_write_words_0_is_less(2),
      pathsabove_step(9) mod 32, pathsabove_stay(9));
    pathsabove_memory_write_words_0_choice(3, 3) := choice((pathsabove_step(10) - pathsabove_stay(10)) < 0,
      pathsabove_step(10) mod 32, pathsabove_stay(10));
    pathsabove_memory_write_words_0_is_less(3) := (pathsabove_step(12) - pathsabove_stay(12)) < 0;
    pathsabove_memory_write_words_0_3_choice_4 := choice(pathsabove_memory_write_words_0_is_less(3),
      pathsabove_step(12) mod 16, pathsabove_stay(12) mod 16);
    pathsabove_memory_write_words_0_sum(3) := (pathsabove_memory_write_words_0_choice(3, 1) * 128) +
      (pathsabove_memory_write_words_0_choice(3, 2) / 8) + (pathsabove_memory_write_words_0_choice(3, 3) * 4) +
      (pathsabove_memory_write_words_0_3_choice_4 * 4096);
    pathsabove_memory_write_words_0_choice(4, 1) := choice((pathsabove_step(14) - pathsabove_stay(14)) < 0,
      pathsabove_step(14) mod 32, pathsabove_stay(14));
    pathsabove_memory_write_words_0_choice(4, 2) := choice(pathsabove_memory_write_words_0_is_less(3),
      pathsabove_step(12) mod 32, pathsabove_stay(12));
    pathsabove_memory_write_words_0_choice(4, 3) := choice((pathsabove_step(13) - pathsabove_stay(13)) < 0,
      pathsabove_step(13) mod 32, pathsabove_stay(13));
    pathsabove_memory_write_words_0_choice(4, 4) := choice((pathsabove_step(15) - pathsabove_stay(15)) < 0,
      pathsabove_step(15) mod 32, pathsabove_stay(15));
    pathsabove_memory_write_words_0_sum(4) := (pathsabove_memory_write_words_0_choice(4, 1) * 64) +
      (pathsabove_memory_write_words_0_choice(4, 2) / 16) + (pathsabove_memory_write_words_0_choice(4, 3) * 2) +
      (pathsabove_memory_write_words_0_choice(4, 4) * 2048);
    pathsabove_memory_write_words_0_all(0) := pathsabove_write_address_is_here and (pathsabove_write_address_address <
      4096);
    if pathsabove_memory_write_words_0_all(0) then
      for i in 0 to 4 loop pathsabove_memory_write_words(0, i) <= pathsabove_memory_write_words_0_sum(i); end loop;
      pathsabove_memory_write_address_0 <= pathsabove_write_address_address mod 4096;
    end if;
    pathsabove_memory_write_words_0_all(1) := (4095 < pathsabove_write_address_address) and
      pathsabove_write_address_is_here;
    if pathsabove_memory_write_words_0_all(1) then
      for i in 0 to 4 loop pathsabove_memory_write_words(1, i) <= pathsabove_memory_write_words_0_sum(i); end loop;
      pathsabove_memory_write_address_1 <= pathsabove_write_address_address mod 8;
    end if;
    if line_comes(19) then pathsabove_smallest <= pathsabove_smallest_total; end if;
    -- pathsturn
    pathsturn_cost_memory_read_address_0_sum := pathsturn_read_address_address + as_number(((not
      is_set(pathsturn_read_address_count_phase, 2)) or (not is_set(pathsturn_read_address_count_phase, 1)) or (not
      is_set(pathsturn_read_address_count_phase, 0))));
    pathsturn_cost_memory_bank_choice := choice(line_starts_phases(15), line_places_address(1) * 8,
      pathsturn_cost_memory_read_address_0_sum mod 8192);
    pathsturn_read_address_count_phase_choice := choice(pathsturn_read_address_count_phase = 7, 7,
      (pathsturn_read_address_count_phase + 1) mod 8);
    pathsturn_write_address_count_phase_choice := choice(pathsturn_write_address_count_phase = 7, 7,
      (pathsturn_write_address_count_phase + 1) mod 8);
    pathsturn_sum_memory_read_address_0 <= pathsturn_sum_read_address mod 4096;
    pathsturn_sum_memory_read_address_1 <= pathsturn_sum_read_address mod 8;
    pathsturn_sum_memory_bank <= pathsturn_cost_memory_read_bank;
    pathsturn_sum_memory_read_bank <= pathsturn_cost_memory_held_bank;
    for i in 0 to 6 loop
      pathsturn_sum_memory_held_words(0, i) <= to_integer(pathsturn_sum_memory_read_words(0, i));
    end loop;
    for i in 0 to 6 loop
      pathsturn_sum_memory_held_words(1, i) <= to_integer(pathsturn_sum_memory_read_words(1, i));
    end loop;
    pathsturn_sum_memory_held_bank <= pathsturn_sum_memory_read_bank;
    pathsturn_cost_memory_bank <= is_set(pathsturn_cost_memory_bank_choice, 12);
    pathsturn_cost_memory_read_bank <= pathsturn_cost_memory_bank;
    for i in 0 to 1 loop
      pathsturn_cost_memory_held_words(i, 0) <= to_integer(pathsturn_cost_memory_read_words(i, 0));
      pathsturn_cost_memory_held_words(i, 1) <= to_integer(pathsturn_cost_memory_read_words(i, 1));
      pathsturn_cost_memory_held_words(i, 2) <= to_integer(pathsturn_cost_memory_read_words(i, 2));
      pathsturn_cost_memory_held_words(i, 3) <= to_integer(pathsturn_cost_memory_read_words(i, 3));
    end loop;
    pathsturn_cost_memory_held_bank <= is_set(pathsturn_sum_read_address, 12);
    pathsturn_ready_smallest_0 <= to_integer(pathsturn_read_smallest_0);
    pathsturn_read_address_address <= pathsturn_cost_memory_bank_choice;
    pathsturn_sum_read_address <= pathsturn_read_address_address;
    pathsturn_write_smallest_0 <= paths_smallest_cost;
    pathsturn_write_address_is_here <= line_starts_phases(18) or (not is_set(pathsturn_write_address_count_phase, 2))
      or (not is_set(pathsturn_write_address_count_phase, 1)) or (not is_set(pathsturn_write_address_count_phase, 0));
    pathsturn_sum_write_address(0) <= pathsturn_write_address_address;
    pathsturn_sum_write_address(1) <= pathsturn_sum_write_address(0);
    pathsturn_writes_sums(0) <= pathsturn_write_address_is_here;
    pathsturn_writes_sums(1) <= pathsturn_writes_sums(0);
    for i in 0 to 6 loop
      pathsturn_sum_memory_ready_words(i) <= choice(pathsturn_sum_memory_held_bank, pathsturn_sum_memory_held_words(1,
        i), pathsturn_sum_memory_held_words(0, i));
    end loop;
    pathsturn_cost_memory_read_address_0 <= choice(line_starts_phases(15), (line_places_address(1) mod 512) * 8,
      pathsturn_cost_memory_read_address_0_sum mod 4096);
    pathsturn_cost_memory_read_address_1 <= choice(line_starts_phases(15), 0, pathsturn_cost_memory_read_address_0_sum
      mod 8);
    pathsturn_read_address_count_phase <= choice(line_starts_phases(15), 0, pathsturn_read_address_count_phase_choice);
    for i in 0 to 3 loop
      pathsturn_cost_memory_ready_words(i) <= choice(pathsturn_sum_memory_bank, pathsturn_cost_memory_held_words(1, i),
        pathsturn_cost_memory_held_words(0, i));
    end loop;
    pathsturn_write_smallest_address <= choice(line_starts_phases(18), line_places_address(2), 513);
    pathsturn_write_address_address <= choice(line_starts_phases(18), line_places_address(2) * 8,
      (pathsturn_write_address_address + as_number(((not is_set(pathsturn_write_address_count_phase, 2)) or (not
      is_set(pathsturn_write_address_count_phase, 1)) or (not is_set(pathsturn_write_address_count_phase, 0))))) mod
      8192);
    pathsturn_write_address_count_phase <= choice(line_starts_phases(18), 0,
      pathsturn_write_address_count_phase_choice);
    pathsturn_sum_memory_write_words_0_sum(0) := pathsleft_cost(2) + pathsabove_cost(2);
    pathsturn_sum_memory_write_words_0_0_sum_2 := ((pathsleft_cost(1) + pathsabove_cost(1)) * 128) + pathsleft_cost(0)
      + pathsabove_cost(0) + ((pathsturn_sum_memory_write_words_0_sum(0) mod 4) * 16384);
    pathsturn_sum_memory_write_words_0_sum(1) := pathsleft_cost(4) + pathsabove_cost(4);
    pathsturn_sum_memory_write_words_0_1_sum_2 := ((pathsleft_cost(3) + pathsabove_cost(3)) * 32) +
      (pathsturn_sum_memory_write_words_0_sum(0) / 4) + ((pathsturn_sum_memory_write_words_0_sum(1) mod 16) * 4096);
    pathsturn_sum_memory_write_words_0_sum(2) := pathsleft_cost(6) + pathsabove_cost(6);
    pathsturn_sum_memory_write_words_0_2_sum_2 := ((pathsleft_cost(5) + pathsabove_cost(5)) * 8) +
      (pathsturn_sum_memory_write_words_0_sum(1) / 16) + ((pathsturn_sum_memory_write_words_0_sum(2) mod 64) * 1024);
    pathsturn_sum_memory_write_words_0_sum(3) := pathsleft_cost(9) + pathsabove_cost(9);
    pathsturn_sum_memory_write_words_0_3_sum_2 := ((pathsleft_cost(8) + pathsabove_cost(8)) * 256) +
      (pathsturn_sum_memory_write_words_0_sum(2) / 64) + ((pathsleft_cost(7) + pathsabove_cost(7)) * 2) +
      ((pathsturn_sum_memory_write_words_0_sum(3) mod 2) * 32768);
    pathsturn_sum_memory_write_words_0_sum(4) := pathsleft_cost(11) + pathsabove_cost(11);
    pathsturn_sum_memory_write_words_0_4_sum_2 := ((pathsleft_cost(10) + pathsabove_cost(10)) * 64) +
      (pathsturn_sum_memory_write_words_0_sum(3) / 2) + ((pathsturn_sum_memory_write_words_0_sum(4) mod 8) * 8192);
    pathsturn_sum_memory_write_words_0_sum(5) := pathsleft_cost(13) + pathsabove_cost(13);
    pathsturn_sum_memory_write_words_0_5_sum_2 := ((pathsleft_cost(12) + pathsabove_cost(12)) * 16) +
      (pathsturn_sum_memory_write_words_0_sum(4) / 8) + ((pathsturn_sum_memory_write_words_0_sum(5) mod 32) * 2048);
    pathsturn_sum_memory_write_words_0_6_sum := ((pathsleft_cost(14) + pathsabove_cost(14)) * 4) +
      (pathsturn_sum_memory_write_words_0_sum(5) / 32) + ((pathsleft_cost(15) + pathsabove_cost(15)) * 512);
    pathsturn_sum_memory_write_words_0_all(0) := (pathsturn_sum_write_address(1) < 4096) and pathsturn_writes_sums(1);
    if pathsturn_sum_memory_write_words_0_all(0) then
      pathsturn_sum_memory_write_words_0(0) <= pathsturn_sum_memory_write_words_0_0_sum_2;
      pathsturn_sum_memory_write_words_1(0) <= pathsturn_sum_memory_write_words_0_1_sum_2;
      pathsturn_sum_memory_write_words_2(0) <= pathsturn_sum_memory_write_words_0_2_sum_2;
      pathsturn_sum_memory_write_words_3(0) <= pathsturn_sum_memory_write_words_0_3_sum_2;
      pathsturn_sum_memory_write_words_4(0) <= pathsturn_sum_memory_write_words_0_4_sum_2;
      pathsturn_sum_memory_write_words_5(0) <= pathsturn_sum_memory_write_words_0_5_sum_2;
      pathsturn_sum_memory_write_words_6(0) <= pathsturn_sum_memory_write_words_0_6_sum;
      pathsturn_sum_memory_write_address_0 <= pathsturn_sum_write_address(1) mod 4096;
    end if;
    pathsturn_sum_memory_write_words_0_all(1) := is_set(pathsturn_sum_write_address(1), 12) and
      pathsturn_writes_sums(1);
    if pathsturn_sum_memory_write_words_0_all(1) then
      pathsturn_sum_memory_write_words_0(1) <= pathsturn_sum_memory_write_words_0_0_sum_2;
      pathsturn_sum_memory_write_words_1(1) <= pathsturn_sum_memory_write_words_0_1_sum_2;
      pathsturn_sum_memory_write_words_2(1) <= pathsturn_sum_memory_write_words_0_2_sum_2;
      pathsturn_sum_memory_write_words_3(1) <= pathsturn_sum_memory_write_words_0_3_sum_2;
      pathsturn_sum_memory_write_words_4(1) <= pathsturn_sum_memory_write_words_0_4_sum_2;
      pathsturn_sum_memory_write_words_5(1) <= pathsturn_sum_memory_write_words_0_5_sum_2;
      pathsturn_sum_memory_write_words_6(1) <= pathsturn_sum_memory_write_words_0_6_sum;
      pathsturn_sum_memory_write_address_1 <= pathsturn_sum_write_address(1) mod 8;
    end if;
    pathsturn_cost_memory_write_words_0_all(0) := pathsturn_write_address_is_here and (pathsturn_write_address_address
      < 4096);
    if pathsturn_cost_memory_write_words_0_all(0) then
      pathsturn_cost_memory_write_words(0, 0) <= to_integer(paths_cost_delay_held(0)(15 downto 0));
      pathsturn_cost_memory_write_words(0, 1) <= to_integer(paths_cost_delay_held(0)(31 downto 16));
      pathsturn_cost_memory_write_words(0, 2) <= to_integer(paths_cost_delay_held(1)(15 downto 0));
      pathsturn_cost_memory_write_words(0, 3) <= to_integer(paths_cost_delay_held(1)(31 downto 16));
      pathsturn_cost_memory_write_address_0 <= pathsturn_write_address_address mod 4096;
    end if;
    pathsturn_cost_memory_write_words_0_all(1) := (4095 < pathsturn_write_address_address) and
      pathsturn_write_address_is_here;
    if pathsturn_cost_memory_write_words_0_all(1) then
      pathsturn_cost_memory_write_words(1, 0) <= to_integer(paths_cost_delay_held(0)(15 downto 0));
      pathsturn_cost_memory_write_words(1, 1) <= to_integer(paths_cost_delay_held(0)(31 downto 16));
      pathsturn_cost_memory_write_words(1, 2) <= to_integer(paths_cost_delay_held(1)(15 downto 0));
      pathsturn_cost_memory_write_words(1, 3) <= to_integer(paths_cost_delay_held(1)(31 downto 16));
      pathsturn_cost_memory_write_address_1 <= pathsturn_write_address_address mod 8;
    end if;
    if line_starts_phases(15) then pathsturn_smallest_address <= line_places_address(1); end if;
    -- pathsright
    for i in 3 to 4 loop
      pathsright_stay_value(5 * i - 15, 1) := to_integer(pathsright_read_words(i)(11 downto 6));
      pathsright_stay_choice(5 * i - 15) := smaller(pathsright_stay_value(5 * i - 15, 1),
        to_integer(pathsright_read_words(i - 3)(5 downto 0)));
      pathsright_stay_value(5 * i - 14, 1) := to_integer(pathsright_read_words(i)(17 downto 12));
      pathsright_stay_value(5 * i - 14, 2) := to_integer(pathsright_read_words(i - 3)(11 downto 6));
      pathsright_stay_choice(5 * i - 14) := smaller(pathsright_stay_value(5 * i - 14, 1), pathsright_stay_value(5 * i -
        14, 2));
      pathsright_stay_value(5 * i - 13, 1) := to_integer(pathsright_read_words(i)(23 downto 18));
      pathsright_stay_value(5 * i - 13, 2) := to_integer(pathsright_read_words(i - 3)(17 downto 12));
      pathsright_stay_choice(5 * i - 13) := smaller(pathsright_stay_value(5 * i - 13, 1), pathsright_stay_value(5 * i -
        13, 2));
      pathsright_stay_value(5 * i - 12, 1) := to_integer(pathsright_read_words(i - 3)(23 downto 18));
      pathsright_stay_choice(5 * i - 12) := smaller(to_integer(pathsright_read_words(i)(29 downto 24)),
        pathsright_stay_value(5 * i - 12, 1));
      pathsright_stay_choice(5 * i - 11) := smaller(to_integer(pathsright_read_words(i + 1)(5 downto 0)),
        to_integer(pathsright_read_words(i - 3)(29 downto 24)));
    end loop;
    pathsright_stay_value(10, 1) := to_integer(pathsright_read_words(5)(11 downto 6));
    pathsright_stay_choice(10) := smaller(pathsright_stay_value(10, 1), to_integer(pathsright_read_words(2)(5 downto
      0)));
    for i in 11 to 12 loop
      pathsright_stay_value(i, 1) := to_integer(pathsright_read_words(5)(6 * i - 49 downto 6 * i - 54));
      pathsright_stay_value(i, 2) := to_integer(pathsright_read_words(2)(6 * i - 55 downto 6 * i - 60));
      pathsright_stay_choice(i) := smaller(pathsright_stay_value(i, 1), pathsright_stay_value(i, 2));
    end loop;
    pathsright_stay_value(13, 1) := to_integer(pathsright_read_words(2)(23 downto 18));
    pathsright_stay_choice(13) := smaller(to_integer(pathsright_read_words(5)(29 downto 24)), pathsright_stay_value(13,
      1));
    pathsright_stay_choice(14) := smaller(to_integer(pathsright_read_words_6(5 downto 0)),
      to_integer(pathsright_read_words(2)(29 downto 24)));
    pathsright_stay_choice(15) := smaller(to_integer(pathsright_read_words_6(11 downto 6)),
      to_integer(pathsright_read_words(3)(5 downto 0)));
    pathsright_step_choice(0, 1) := choice(pathsleft_is_first, pathsright_stay_value(1, 2), pathsright_lower_neighbour);
    pathsright_step_choice(0, 2) := smaller(pathsright_stay_value(1, 2), pathsright_step_choice(0, 1));
    for i in 0 to 1 loop
      pathsright_step_choice(5 * i + 1, 1) := smaller(pathsright_stay_value(5 * i + 2, 2),
        to_integer(pathsright_read_words(i)(5 downto 0)));
      pathsright_step_choice(5 * i + 2, 1) := smaller(pathsright_stay_value(5 * i + 3, 1), pathsright_stay_value(5 * i
        + 1, 2));
      pathsright_step_choice(5 * i + 3, 1) := smaller(to_integer(pathsright_read_words(i)(29 downto 24)),
        pathsright_stay_value(5 * i + 2, 2));
      pathsright_step_choice(5 * i + 4, 1) := smaller(to_integer(pathsright_read_words(i + 1)(5 downto 0)),
        pathsright_stay_value(5 * i + 3, 1));
      pathsright_step_choice(5 * i + 5, 1) := smaller(pathsright_stay_value(5 * i + 6, 2),
        to_integer(pathsright_read_words(i)(29 downto 24)));
    end loop;
    pathsright_step_choice(11, 1) := smaller(pathsright_stay_value(12, 2), to_integer(pathsright_read_words(2)(5 downto
      0)));
    pathsright_step_choice(12, 1) := smaller(pathsright_stay_value(13, 1), pathsright_stay_value(11, 2));
    pathsright_step_choice(13, 1) := smaller(to_integer(pathsright_read_words(2)(29 downto 24)),
      pathsright_stay_value(12, 2));
    pathsright_step_choice(14, 1) := smaller(to_integer(pathsright_read_words(3)(5 downto 0)),
      pathsright_stay_value(13, 1));
    pathsright_step_choice(15, 1) := choice(pathsleft_is_last, to_integer(pathsright_read_words(2)(29 downto 24)),
      to_integer(pathsright_read_neighbour_0));
    pathsright_step_choice(15, 2) := smaller(pathsright_step_choice(15, 1), to_integer(pathsright_read_words(2)(29
      downto 24)));
    for i in 0 to 3 loop
      pathsright_stay_change_value(4 * i + 1) := (pathsturn_cost_memory_ready_words(i) mod 256) / 16;
      pathsright_stay_change_value(4 * i + 2) := (pathsturn_cost_memory_ready_words(i) / 256) mod 16;
    end loop;
    pathsright_low_0_choice := choice(line_comes(25), 63, pathsright_low_0);
    pathsright_lost <= pathsright_lowest_0(5) = '1';
    pathsright_short_of <= ((to_integer(pathsright_lowest_0(4 downto 0)) + pathsright_room) / 32) = 1;
    pathsright_missing <= (to_integer(pathsright_lowest_0) + pathsright_room) mod 32;
    pathsright_below <= (0 - to_integer(pathsright_lowest_0)) mod 32;
    pathsright_lower_neighbour <= to_integer(pathsright_read_words(3)(5 downto 0));
    for i in 0 to 3 loop
      pathsright_stay_change(4 * i) <= ((pathsturn_cost_memory_ready_words(i) mod 16) - pathsright_g) mod 64;
      pathsright_stay_change(4 * i + 1) <= (pathsright_stay_change_value(4 * i + 1) - pathsright_g) mod 64;
      pathsright_stay_change(4 * i + 2) <= (pathsright_stay_change_value(4 * i + 2) - pathsright_g) mod 64;
      pathsright_stay_change(4 * i + 3) <= ((pathsturn_cost_memory_ready_words(i) / 4096) - pathsright_g) mod 64;
    end loop;
    for i in 0 to 3 loop
      pathsright_step_change(4 * i) <= ((pathsturn_cost_memory_ready_words(i) mod 16) - pathsright_g_less) mod 64;
      pathsright_step_change(4 * i + 1) <= (pathsright_stay_change_value(4 * i + 1) - pathsright_g_less) mod 64;
      pathsright_step_change(4 * i + 2) <= (pathsright_stay_change_value(4 * i + 2) - pathsright_g_less) mod 64;
      pathsright_step_change(4 * i + 3) <= ((pathsturn_cost_memory_ready_words(i) / 4096) - pathsright_g_less) mod 64;
    end loop;
    pathsright_stay(0) <= choice((not pathsleft_first) and (not is_set(pathsright_stay_choice(0), 5)),
      pathsright_stay_choice(0), 32);
    for i in 1 to 15 loop
      pathsright_stay(i) <= choice((not is_set(pathsright_stay_choice(i), 5)) and (not pathsleft_first),
        pathsright_stay_choice(i), 32);
    end loop;
    pathsright_step(0) <= choice(pathsleft_first, 32, pathsright_step_choice(0, 2));
    for i in 1 to 14 loop pathsright_step(i) <= choice(pathsleft_first, 32, pathsright_step_choice(i, 1)); end loop;
    pathsright_step(15) <= choice(pathsleft_first, 32, pathsright_step_choice(15, 2));
    for i in 0 to 7 loop
      pathsright_tree_smallest(i) <= smaller(pathsright_cost(2 * i + 1), pathsright_cost(2 * i));
    end loop;
    for i in 0 to 3 loop
      pathsright_tree_next_smallest(i) <= smaller(pathsright_tree_smallest(2 * i + 1), pathsright_tree_smallest(2 * i));
    end loop;
    pathsright_tree_next_next_smallest(0) <= smaller(pathsright_tree_next_smallest(1),
      pathsright_tree_next_smallest(0));
    pathsright_tree_next_next_smallest(1) <= smaller(pathsright_tree_next_smallest(3),
      pathsright_tree_next_smallest(2));
    pathsright_tree_next_next_next_smallest_0 <= smaller(pathsright_tree_next_next_smallest(1),
      pathsright_tree_next_next_smallest(0));
    pathsright_low_0 <= smaller(pathsright_tree_next_next_next_smallest_0, pathsright_low_0_choice);
    pathsright_q_choices(1) := choice(pathsright_short_of, pathsright_missing, 0);
    pathsright_q_choices(2) := choice(pathsright_lost, pathsright_room, pathsright_q_choices(1));
    pathsright_room_left_choice := choice(pathsright_short_of, pathsright_below, pathsright_room);
    if line_starts_phases(16) then
      pathsright_q <= choice(line_places_first_column(1), 24, pathsright_q_choices(2));
      pathsright_room_left <= choice(pathsright_lost, 0, pathsright_room_left_choice);
    end if;
    if line_starts_phases(17) then
      pathsright_q_now <= pathsright_q;
      pathsright_q_less <= ((((pathsright_q / 4) + 15) mod 16) * 4) + (pathsright_q mod 4);
      pathsright_room <= choice(line_places_first_column(2), 0, (pathsright_room_left + pathsright_start_cost(9)) mod
        32);
      pathsright_start_cost(1) <= choice(line_places_first_column(2), 0, pathsright_q_now);
      for i in 2 to 9 loop
        pathsright_start_cost(i) <= choice(line_places_first_column(2), 0, pathsright_start_cost(i - 1));
      end loop;
    end if;
    if line_starts_phases(18) then
      pathsright_g <= pathsturn_ready_smallest_0 + pathsright_q_now;
      pathsright_g_less <= (pathsturn_ready_smallest_0 + pathsright_q_less) mod 64;
    end if;
    if pathsleft_cost_0_any then
      for i in 0 to 15 loop pathsright_cost(i) <= (pathsright_stay(i) + pathsright_stay_change(i)) mod 64; end loop;
      for i in 0 to 15 loop pathsright_arrived(i) <= (pathsright_step(i) + pathsright_step_change(i)) mod 64; end loop;
    end if;
    -- winnerswinner1
    for i in 1 to 5 loop winnerswinner1_best_index_0_value(0, i) := is_set(paths_sum(1), i + 1); end loop;
    winnerswinner1_best_index_0_choice(0, 7) := not is_larger(paths_sum(0), paths_sum(1), 0, 6, false);
    for i in 1 to 7 loop
      for j in 1 to 5 loop winnerswinner1_best_index_0_value(i, j) := is_set(paths_sum(2 * i + 1), j + 1); end loop;
      winnerswinner1_best_index_0_choice(i, 8) := is_larger(paths_sum(2 * i), paths_sum(2 * i + 1), 0, 7, false);
    end loop;
    for i in 0 to 7 loop winnerswinner1_best_cost_0(i) <= smaller(paths_sum(2 * i + 1), paths_sum(2 * i)); end loop;
    winnerswinner1_best_index_0_0 <= inverted_carry(winnerswinner1_best_index_0_choice(0, 7), is_set(paths_sum(0), 7),
      not is_set(paths_sum(1), 7));
    for i in 1 to 7 loop
      winnerswinner1_best_index_0(i) <= choice(winnerswinner1_best_index_0_choice(i, 8), 2 * i + 1, 2 * i);
    end loop;
    -- winnerswinner2
    for i in 0 to 3 loop
      for j in 1 to 5 loop
        winnerswinner2_best_index_0_value(i, j) := is_set(winnerswinner1_best_cost_0(2 * i + 1), j + 1);
      end loop;
      winnerswinner2_best_index_0_choice_8(i) := is_larger(winnerswinner1_best_cost_0(2 * i),
        winnerswinner1_best_cost_0(2 * i + 1), 0, 7, false);
    end loop;
    for i in 0 to 3 loop
      winnerswinner2_best_cost_0(i) <= smaller(winnerswinner1_best_cost_0(2 * i + 1), winnerswinner1_best_cost_0(2 *
        i));
    end loop;
    winnerswinner2_best_index_0(0) <= choice(winnerswinner2_best_index_0_choice_8(0), winnerswinner1_best_index_0(1),
      as_number(winnerswinner1_best_index_0_0));
    for i in 1 to 3 loop
      winnerswinner2_best_index_0(i) <= choice(winnerswinner2_best_index_0_choice_8(i), winnerswinner1_best_index_0(2 *
        i + 1), winnerswinner1_best_index_0(2 * i));
    end loop;
    -- winnerswinner3
    for i in 0 to 1 loop
      for j in 1 to 5 loop
        winnerswinner3_best_index_0_value(i, j) := is_set(winnerswinner2_best_cost_0(2 * i + 1), j + 1);
      end loop;
      winnerswinner3_best_index_0_choice_8(i) := is_larger(winnerswinner2_best_cost_0(2 * i),
        winnerswinner2_best_cost_0(2 * i + 1), 0, 7, false);
    end loop;
    winnerswinner3_best_cost_0(0) <= smaller(winnerswinner2_best_cost_0(1), winnerswinner2_best_cost_0(0));
    winnerswinner3_best_cost_0(1) <= smaller(winnerswinner2_best_cost_0(3), winnerswinner2_best_cost_0(2));
    winnerswinner3_best_index_0(0) <= choice(winnerswinner3_best_index_0_choice_8(0), winnerswinner2_best_index_0(1),
      winnerswinner2_best_index_0(0));
    winnerswinner3_best_index_0(1) <= choice(winnerswinner3_best_index_0_choice_8(1), winnerswinner2_best_index_0(3),
      winnerswinner2_best_index_0(2));
    -- winnerswinner4
    for i in 1 to 5 loop
      winnerswinner4_best_index_0_0_values(i) := is_set(winnerswinner3_best_cost_0(1), i + 1);
    end loop;
    winnerswinner4_best_index_0_0_choice_8 := is_larger(winnerswinner3_best_cost_0(0), winnerswinner3_best_cost_0(1),
      0, 7, false);
    winnerswinner4_best_cost_0_0 <= smaller(winnerswinner3_best_cost_0(1), winnerswinner3_best_cost_0(0));
    winnerswinner4_best_index_0_0 <= choice(winnerswinner4_best_index_0_0_choice_8, winnerswinner3_best_index_0(1),
      winnerswinner3_best_index_0(0));
    -- winners
    winners_best_cost_0_0_choice := choice(line_comes(26), 255, winners_best_cost_0_0);
    winners_best_index_0_0_values(1) := is_set(winners_best_cost_0_0, 1);
    winners_best_index_0_0_choices(1) := choice((not is_set(winnerswinner4_best_cost_0_0, 0)) and
      (is_set(winners_best_cost_0_0, 0) or line_comes(26)), (not is_set(winnerswinner4_best_cost_0_0, 1)) or
      winners_best_index_0_0_values(1) or line_comes(26), (not is_set(winnerswinner4_best_cost_0_0, 1)) and
      (winners_best_index_0_0_values(1) or line_comes(26)));
    for i in 2 to 6 loop
      winners_best_index_0_0_values(i) := is_set(winners_best_cost_0_0, i);
      winners_best_index_0_0_choices(i) := choice(winners_best_index_0_0_choices(i - 1), (not
        is_set(winnerswinner4_best_cost_0_0, i)) or winners_best_index_0_0_values(i) or line_comes(26), (not
        is_set(winnerswinner4_best_cost_0_0, i)) and (winners_best_index_0_0_values(i) or line_comes(26)));
    end loop;
    winners_best_index_0_0_choices(7) := choice(winners_best_index_0_0_choices(6), (not
      is_set(winnerswinner4_best_cost_0_0, 7)) or is_set(winners_best_cost_0_0, 7) or line_comes(26), (not
      is_set(winnerswinner4_best_cost_0_0, 7)) and (is_set(winners_best_cost_0_0, 7) or line_comes(26)));
    winners_best_tag.valid <= line_comes(33);
    winners_best_tag.map_column <= line_places_map_column(4);
    winners_best_tag.output_column <= line_places_shown_output_column(4);
    winners_best_tag.start_of_frame <= line_places_shown_start_of_frame(4);
    winners_best_tag.end_of_line <= line_places_shown_end_of_line(4);
    winners_best_cost_0_0 <= smaller(winnerswinner4_best_cost_0_0, winners_best_cost_0_0_choice);
    winners_best_index_0_0 <= choice(winners_best_index_0_0_choices(7), winnerswinner4_best_index_0_0 + 112,
      ((((winners_best_index_0_0 / 16) + 15) mod 16) * 16) + (winners_best_index_0_0 mod 16));
    -- turn
    turn_order_address_anys(1) := turn_order_turned_map_column or (not winners_best_tag.map_column) or (not
      winners_best_tag.valid);
    turn_order_address_choice := choice(turn_order_falls, 1023, 1);
    turn_order_address_anys(2) := (not winners_best_tag.map_column) or (not winners_best_tag.valid);
    if not turn_order_address_anys(2) then
      turn_order_address <= choice(turn_order_address_anys(1), (turn_order_address_choice + turn_order_address) mod
        1024, as_number((not turn_order_falls)) * 512);
    end if;
    turn_order_falls_all := (not turn_order_turned_map_column) and winners_best_tag.map_column and
      winners_best_tag.valid;
    turn_order_complete_all := winners_best_tag.map_column and winners_best_tag.valid;
    turn_ready_tag_row_start_differs := map_counter_group /= 481;
    turn_ready_tag_row_start_is_equals(1) := map_counter_column = 512;
    turn_ready_tag_row_start_choices(1) := choice(turn_ready_tag_row_start_is_equals(1), turn_ready_tag.row_start and
      (map_counter_group /= 480), turn_ready_tag.row_start);
    turn_ready_tag_row_start_choices(2) := choice(turn_ready_tag_row_start_differs,
      turn_ready_tag_row_start_choices(1), turn_ready_tag.row_start);
    turn_ready_tag_row_start_is_equals(2) := map_counter_group = 479;
    turn_ready_tag_row_start_alls(1) := turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_row_start_is_equals(1);
    turn_ready_tag_row_start_choices(3) := choice(turn_ready_tag_row_start_choices(2), (not
      turn_ready_tag.start_of_frame) or turn_ready_tag_row_start_alls(1), turn_ready_tag.start_of_frame and
      turn_ready_tag_row_start_is_equals(2) and turn_ready_tag_row_start_is_equals(1));
    turn_ready_tag_row_start_alls(2) := turn_ready_tag.valid and turn_ready_tag.map_column;
    turn_order_inside <= winners_best_tag.map_column;
    turn_order_turned_valid <= winners_best_tag.valid;
    turn_order_turned_start_of_frame <= (not turn_order_turned_map_column) and winners_best_tag.map_column and
      winners_best_tag.valid and turn_order_first and turn_order_complete and turn_order_output;
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
    turn_write_place <= choice(turn_comes, turn_order_address, 513);
    turn_ready_tag.row_start <= choice(turn_ready_tag_row_start_choices(3), turn_ready_tag.row_start or
      turn_ready_tag_row_start_alls(2), turn_ready_tag.row_start and ((not turn_ready_tag.valid) or (not
      turn_ready_tag.map_column)));
    if turn_order_falls_all then
      turn_order_output <= winners_best_tag.output_column;
      turn_order_first <= winners_best_tag.start_of_frame;
    end if;
    if winners_best_tag.valid then turn_order_turned_map_column <= winners_best_tag.map_column; end if;
    if turn_comes then turn_write_words_0 <= turn_newest; end if;
    -- map
    if turn_ready_tag_row_start_alls(2) then
      map_counter_column <= choice(turn_ready_tag.start_of_frame or turn_ready_tag_row_start_is_equals(1), 0,
        (map_counter_column + 1) mod 1024);
    end if;
    map_counter_group_choice := choice(turn_ready_tag_row_start_alls(1), 15, 0);
    map_counter_group_is_equal := map_counter_group = 480;
    map_counter_group_choices(2) := choice(turn_ready_tag.row_start and map_counter_group_is_equal, 1,
      (map_counter_group + 1) mod 512);
    map_counter_group_choices(3) := choice(turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equals(1)
      and turn_ready_tag.valid and turn_ready_tag.map_column, map_counter_group_choices(2), map_counter_group);
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
    map_at_column <= to_integer(other(1)(9 downto 0));
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
      map_counter_group_choice * 32, map_counter_group_choices(3));
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
      map_write_column <= to_integer(other(1)(9 downto 0));
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
    other(0) <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 481))), 1) &
      to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
      to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) & to_unsigned(map_counter_column,
      16);
    other(1) <= other(0);
    other_2 <= ((map_rows_ready_words_0 mod 512) / 2) * 2;
    for i in 3 to 18 loop
      others_from_3(i) <= ((costswindow_first_count(18 - i, 5) + costswindow_first_count(18 - i, 6) +
        costswindow_first_count(18 - i, 4) + costswindow_first_count(18 - i, 7)) * 256) + ((costswindow_first_count(18
        - i, 9) + costswindow_first_count(18 - i, 10) + costswindow_first_count(18 - i, 8) + costswindow_first_count(18
        - i, 11)) * 65536) + ((costswindow_first_count_14(18 - i) + costswindow_first_count(18 - i, 12) +
        costswindow_first_count(18 - i, 13)) * 16777216) + costswindow_first_count(18 - i, 1) +
        costswindow_first_count(18 - i, 2) + costswindow_first_count(18 - i, 0) + costswindow_first_count(18 - i, 3);
    end loop;
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 482;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 480; delay_tag <= (others => false); rows_tag <= (others => false);
      line_centre_map_column_0 <= false; line_centre_first_column_0 <= false; line_centre_end_of_line_0 <= false;
      line_order_address <= 0; line_order_falls <= false; line_order_inside <= false; line_order_complete <= false;
      line_order_output <= false; line_order_first <= false; line_order_held_output <= false;
      line_order_turned_valid <= false; line_order_turned_output_column <= false;
      line_order_turned_start_of_frame <= false; line_comes <= (others => false);
      line_starts_phases <= (others => false);
      for i in 0 to 2 loop
        line_places_map_column(i) <= false; line_places_first_column(i) <= false; line_places_address(i) <= 0;
        line_places_shown_output_column(i) <= false; line_places_shown_start_of_frame(i) <= false;
        line_places_shown_end_of_line(i) <= false;
      end loop;
      for i in 3 to 4 loop
        line_places_map_column(i) <= false; line_places_shown_output_column(i) <= false;
        line_places_shown_start_of_frame(i) <= false; line_places_shown_end_of_line(i) <= false;
      end loop;
      costsshift_new_tag_valid <= false; costsshift_count_phase <= 7; costsshift_read_tag_valid <= false;
      costsshift_read_count_phase <= 7; costsshift_write_phase <= 7; paths_cost_delay_ring_read_address <= 1;
      paths_cost_delay_ring_write_address <= 0; pathsleft_low_address <= 4; pathsleft_read_count_phase <= 7;
      pathsleft_ahead_count_phase <= 7; pathsleft_write_count_phase <= 7; pathsleft_low_write_address <= 0;
      pathsabove_memory_read_address_0 <= 0; pathsabove_memory_read_address_1 <= 0;
      pathsabove_memory_write_address_0 <= 0; pathsabove_memory_write_address_1 <= 0;
      pathsabove_read_address_address <= 0; pathsabove_read_address_count_phase <= 7;
      pathsabove_write_address_address <= 0; pathsabove_write_address_is_here <= false;
      pathsabove_write_address_count_phase <= 7; pathsturn_sum_memory_read_address_0 <= 0;
      pathsturn_sum_memory_read_address_1 <= 0; pathsturn_sum_memory_write_address_0 <= 0;
      pathsturn_sum_memory_write_address_1 <= 0; pathsturn_cost_memory_read_address_0 <= 0;
      pathsturn_cost_memory_read_address_1 <= 0; pathsturn_cost_memory_write_address_0 <= 0;
      pathsturn_cost_memory_write_address_1 <= 0; pathsturn_smallest_address <= 0; pathsturn_read_address_address <= 0;
      pathsturn_read_address_count_phase <= 7; pathsturn_sum_read_address <= 0; pathsturn_write_smallest_address <= 0;
      pathsturn_write_address_address <= 0; pathsturn_write_address_is_here <= false;
      pathsturn_write_address_count_phase <= 7; pathsturn_sum_write_address <= (others => 0);
      pathsturn_writes_sums <= (others => false); winners_best_tag <= (others => false); turn_order_address <= 0;
      turn_order_falls <= false; turn_order_inside <= false; turn_order_complete <= false; turn_order_output <= false;
      turn_order_first <= false; turn_order_turned_valid <= false; turn_order_turned_map_column <= false;
      turn_order_turned_start_of_frame <= false; turn_order_turned_end_of_line <= false; turn_comes <= false;
      turn_read_tag <= (others => false); turn_write_place <= 0; turn_ready_tag <= (others => false);
      map_counter_column <= 0; map_counter_group <= 481; map_arrives <= false; map_behind <= false;
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
