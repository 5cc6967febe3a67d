-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_640: 640x480, 128 disparities, window 1x1, P1 4, P2 24, 1 pixel pair a clock.
-- Options: disparities 128, window_px 1, reference left, census_width_px 9, cost_shift 2, p1 4, p2 24, median
--   true, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_640
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_640 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 128;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 513;
    latency_clocks : positive := 52;
    flush_groups : positive := 3209;
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
  assert width_px = 640 report "stereo_core_sgm_640: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_sgm_640: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 128 report "stereo_core_sgm_640: disparities is " & integer'image(disparities) & " but this core has 128" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_640: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_sgm_640: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 513 report "stereo_core_sgm_640: output_width_px is " & integer'image(output_width_px) & " but this core has 513" severity failure;
  assert latency_clocks = 52 report "stereo_core_sgm_640: latency_clocks is " & integer'image(latency_clocks) & " but this core has 52" severity failure;
  assert flush_groups = 3209 report "stereo_core_sgm_640: flush_groups is " & integer'image(flush_groups) & " but this core has 3209" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_640: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_640 is
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

  type boolean_1d is array (natural range <>) of boolean;
  type boolean_2d is array (natural range <>, natural range <>) of boolean;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_11_1d is array (natural range <>) of natural range 0 to 11;
  type natural_11_2d is array (natural range <>, natural range <>) of natural range 0 to 11;
  type natural_126_1d is array (natural range <>) of natural range 0 to 126;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_15_2d is array (natural range <>, natural range <>) of natural range 0 to 15;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_266321790_1d is array (natural range <>) of natural range 0 to 266321790;
  type natural_268435455_1d is array (natural range <>) of natural range 0 to 268435455;
  type natural_2_1d is array (natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_3_2d is array (natural range <>, natural range <>) of natural range 0 to 3;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_44_1d is array (natural range <>) of natural range 0 to 44;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_2d is array (natural range <>, natural range <>) of natural range 0 to 63;
  type natural_67_1d is array (natural range <>) of natural range 0 to 67;
  type natural_67_2d is array (natural range <>, natural range <>) of natural range 0 to 67;
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type unsigned_44_1d is array (natural range <>) of unsigned(43 downto 0);
  type tag_7 is record
    valid, border_column, first_cost, map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, first_cost, map_column, end_of_line : boolean;
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
  signal delay_tag : tag_7;
  -- rows
  signal rows_search_0, rows_reference_0 : unsigned(43 downto 0);
  signal rows_tag : tag_7;
  -- slice0shift
  signal slice0shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice0shift_reference_0, slice0shift_search_out_0 : unsigned(43 downto 0);
  signal slice0shift_tag : tag_7;
  -- slice0cost
  signal slice0cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal slice0cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_pair_tag, slice0cost_tag : tag_7;
  signal slice0cost_pixels_cost_0, slice0cost_single_0 : natural_44_1d(0 to 15);
  -- slice0window
  signal slice0window_tag : tag_7;
  -- slice0
  signal slice0_held : natural_11_2d(0 to 7, 0 to 15);
  signal slice0_tag_valid : boolean_1d(0 to 7);  -- _#_valid
  signal slice0_tag_border_column : boolean_1d(0 to 4);  -- _#_border_column
  signal slice0_tag_first_cost : boolean_1d(0 to 7);  -- _#_first_cost
  signal slice0_tag_map_column : boolean_1d(0 to 7);  -- _#_map_column
  signal slice0_tag_output_column : boolean_1d(0 to 7);  -- _#_output_column
  signal slice0_tag_start_of_frame : boolean_1d(0 to 7);  -- _#_start_of_frame
  signal slice0_tag_end_of_line : boolean_1d(0 to 7);  -- _#_end_of_line
  -- slice1shift
  signal slice1shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice1shift_reference_0, slice1shift_search_out_0 : unsigned(43 downto 0);
  -- slice1cost
  signal slice1cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal slice1cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal slice1cost_pixels_cost_0, slice1cost_single_0 : natural_44_1d(0 to 15);
  -- slice1
  signal slice1_held : natural_11_2d(0 to 6, 0 to 15);
  -- slice2shift
  signal slice2shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice2shift_reference_0, slice2shift_search_out_0 : unsigned(43 downto 0);
  -- slice2cost
  signal slice2cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal slice2cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal slice2cost_pixels_cost_0, slice2cost_single_0 : natural_44_1d(0 to 15);
  -- slice2
  signal slice2_held : natural_11_2d(0 to 5, 0 to 15);
  -- slice3shift
  signal slice3shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice3shift_reference_0, slice3shift_search_out_0 : unsigned(43 downto 0);
  -- slice3cost
  signal slice3cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal slice3cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal slice3cost_pixels_cost_0, slice3cost_single_0 : natural_44_1d(0 to 15);
  -- slice3
  signal slice3_held : natural_11_2d(0 to 4, 0 to 15);
  -- slice4shift
  signal slice4shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice4shift_reference_0, slice4shift_search_out_0 : unsigned(43 downto 0);
  -- slice4cost
  signal slice4cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal slice4cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal slice4cost_pixels_cost_0, slice4cost_single_0 : natural_44_1d(0 to 15);
  -- slice4
  signal slice4_held : natural_11_2d(0 to 3, 0 to 15);
  -- slice5shift
  signal slice5shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice5shift_reference_0, slice5shift_search_out_0 : unsigned(43 downto 0);
  -- slice5cost
  signal slice5cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal slice5cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal slice5cost_pixels_cost_0, slice5cost_single_0 : natural_44_1d(0 to 15);
  -- slice5
  signal slice5_held : natural_11_2d(0 to 2, 0 to 15);
  -- slice6shift
  signal slice6shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice6shift_reference_0, slice6shift_search_out_0 : unsigned(43 downto 0);
  -- slice6cost
  signal slice6cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal slice6cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal slice6cost_pixels_cost_0, slice6cost_single_0 : natural_44_1d(0 to 15);
  -- slice6
  signal slice6_held : natural_11_2d(0 to 1, 0 to 15);
  -- slice7shift
  signal slice7shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice7shift_reference_0 : unsigned(43 downto 0);
  -- slice7cost
  signal slice7cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- _#_count_#
  signal slice7cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- _#_count_14
  signal slice7cost_pixels_cost_0, slice7cost_single_0 : natural_44_1d(0 to 15);
  -- slice7
  signal slice7_held_0 : natural_11_1d(0 to 15);
  -- entry
  signal entry_next_cost, entry_cost : natural_11_1d(0 to 127);
  signal entry_next_tag : tag_4;
  signal entry_next_top, entry_order_falls, entry_order_inside, entry_order_complete, entry_order_output,
    entry_order_first, entry_order_held_output, entry_order_turned_output_column, entry_order_turned_first_column,
    entry_order_turned_start_of_frame : boolean;
  signal entry_tag : tag_4;
  signal entry_top, entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 1023;
  -- forward
  signal forward_smallest_smallest : natural_11_1d(0 to 63);
  signal forward_smallest_next_smallest : natural_11_1d(0 to 31);
  signal forward_smallest_next_next_smallest : natural_11_1d(0 to 15);
  signal forward_smallest_next_next_next_smallest : natural_11_1d(0 to 7);
  signal forward_smallest_next_next_next_next_smallest : natural_11_1d(0 to 3);
  signal forward_smallest_next_next_next_next_next_smallest : natural_11_1d(0 to 1);
  signal forward_smallest_next_next_next_next_next_next_smallest_0, forward_left_smallest : natural range 0 to 11;
  signal forward_above_ready_cost : natural_11_1d(0 to 127);
  signal forward_smallest_cost : natural_11_1d(0 to 4);
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address,
    forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost_delay_held : unsigned_32_1d(0 to 15);
  signal forward_above_read_words, forward_above_ready_words, forward_above_write_words : unsigned_32_1d(0 to 20);
  signal forward_left_pair : natural_63_1d(0 to 63);
  signal forward_left_tree_smallest : natural_63_1d(0 to 31);
  signal forward_left_tree_next_smallest : natural_63_1d(0 to 15);
  signal forward_left_tree_next_next_smallest : natural_63_1d(0 to 7);
  signal forward_left_tree_next_next_next_smallest : natural_63_1d(0 to 3);
  signal forward_left_tree_next_next_next_next_smallest : natural_63_1d(0 to 1);
  signal forward_left_tree_next_next_next_next_next_smallest_0, forward_left_smallest_less : natural range 0 to 63;
  signal forward_left_g_copy, forward_left_g_less_copy : natural_63_1d(0 to 7);
  signal forward_left_stay_change, forward_left_step_change, forward_left_cost, forward_left_arrived,
    forward_above_cost, forward_above_beside : natural_63_1d(0 to 127);
  signal forward_above_own_0 : natural range 0 to 63;
  signal forward_above_own : natural_63_1d(2 to 125);
  signal forward_above_own_127 : natural range 0 to 63;
  signal forward_left_start_cost : natural_255_1d(0 to 9);
  signal forward_left_room : natural range 0 to 31;
  signal forward_above_stay : natural_31_1d(0 to 127);
  signal forward_left_first : boolean_1d(0 to 2);
  signal forward_above_ready_top : boolean;
  signal forward_above_comes : boolean_1d(0 to 12);
  signal forward_above_writes_copy_0 : boolean;
  signal forward_first : boolean_1d(0 to 6);
  signal forward_above_read_words_21 : unsigned(11 downto 0);
  signal forward_above_ready_words_21, forward_above_write_words_21 : natural range 0 to 4095;
  signal forward_above_total : natural_42_1d(0 to 127);
  signal forward_above_tree_smallest : natural_42_1d(0 to 63);
  signal forward_above_tree_next_smallest : natural_42_1d(0 to 31);
  signal forward_above_tree_next_next_smallest : natural_42_1d(0 to 15);
  signal forward_above_tree_next_next_next_smallest : natural_42_1d(0 to 7);
  signal forward_above_tree_next_next_next_next_smallest : natural_42_1d(0 to 3);
  signal forward_above_tree_next_next_next_next_next_smallest : natural_42_1d(0 to 1);
  signal forward_above_tree_next_next_next_next_next_next_smallest_0 : natural range 0 to 42;
  signal forward_above_smallest_copy : natural_42_1d(0 to 7);
  signal forward_above_delay_held : unsigned_30_1d(0 to 24);
  signal forward_above_delay_held_25 : unsigned(17 downto 0);
  signal forward_above_step : natural_67_1d(0 to 127);
  signal forward_above_column : natural_1023_1d(0 to 12);
  signal forward_above_write_column : natural range 0 to 1023;
  signal forward_sum : natural_126_1d(0 to 127);
  signal forward_cost : natural_15_2d(0 to 3, 0 to 127);
  -- sums
  signal sums_turn_read_sums, sums_sum_delay_held : unsigned_28_1d(0 to 31);
  signal sums_turn_read_costs, sums_turn_ready_costs, sums_turn_write_costs : unsigned_32_1d(0 to 15);
  signal sums_turn_read_smallest_0 : unsigned(3 downto 0);
  signal sums_turn_ready_sums : natural_268435455_1d(0 to 31);
  signal sums_turn_ready_smallest_0 : natural range 0 to 15;
  signal sums_cost : natural_15_2d(0 to 1, 0 to 127);
  signal sums_right_smallest : natural range 0 to 15;
  signal sums_turn_ready_first, sums_turn_writes_copy_0 : boolean;
  signal sums_right_first : boolean_1d(0 to 2);
  signal sums_tag : tag_5;
  signal sums_tags_held_output_column : boolean_1d(0 to 4);  -- _#_output_column
  signal sums_tags_held_start_of_frame : boolean_1d(0 to 4);  -- _#_start_of_frame
  signal sums_tags_held_end_of_line : boolean_1d(0 to 4);  -- _#_end_of_line
  signal sums_tags_moved : boolean;
  signal sums_turn_place : natural_1023_1d(0 to 11);
  signal sums_turn_write_place : natural range 0 to 1023;
  signal sums_turn_write_sums : natural_266321790_1d(0 to 31);
  signal sums_turn_write_smallest_0 : natural range 0 to 11;
  signal sums_right_pair : natural_63_1d(0 to 63);
  signal sums_right_tree_smallest : natural_63_1d(0 to 31);
  signal sums_right_tree_next_smallest : natural_63_1d(0 to 15);
  signal sums_right_tree_next_next_smallest : natural_63_1d(0 to 7);
  signal sums_right_tree_next_next_next_smallest : natural_63_1d(0 to 3);
  signal sums_right_tree_next_next_next_next_smallest : natural_63_1d(0 to 1);
  signal sums_right_tree_next_next_next_next_next_smallest_0, sums_right_smallest_less : natural range 0 to 63;
  signal sums_right_g_copy, sums_right_g_less_copy : natural_63_1d(0 to 7);
  signal sums_right_stay_change, sums_right_step_change, sums_right_cost, sums_right_arrived : natural_63_1d(0 to 127);
  signal sums_right_start_cost : natural_255_1d(0 to 9);
  signal sums_right_room : natural range 0 to 31;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  signal sums_sum_0 : natural_127_1d(0 to 127);
  -- winnerswinner1
  signal winnerswinner1_of_pair_0 : natural_127_1d(0 to 127);
  signal winnerswinner1_pair_index_0 : natural_127_1d(1 to 63);  -- _# up to 3, 5 .. 127
  signal winnerswinner1_of_four_0 : natural_127_1d(0 to 127);
  signal winnerswinner1_four_index_0 : natural_127_1d(0 to 31);  -- _# up to 3, 7 .. 127
  signal winnerswinner1_best_cost_0 : natural_127_1d(0 to 31);
  signal winnerswinner1_best_index_0 : natural_127_1d(0 to 31);  -- _# up to 3, 7 .. 127
  signal winnerswinner1_pair_index_0_0 : boolean;
  signal winnerswinner1_pair_tag, winnerswinner1_four_tag, winnerswinner1_tag : tag_5;
  -- winnerswinner2
  signal winnerswinner2_of_pair_0 : natural_127_1d(0 to 31);
  signal winnerswinner2_pair_index_0 : natural_127_1d(0 to 15);  -- _# up to 7, 15 .. 127
  signal winnerswinner2_of_four_0 : natural_127_1d(0 to 31);
  signal winnerswinner2_four_index_0 : natural_127_1d(0 to 7);  -- _# up to 15, 31 .. 127
  signal winnerswinner2_best_cost_0 : natural_127_1d(0 to 7);
  signal winnerswinner2_best_index_0 : natural_127_1d(0 to 7);  -- _# up to 15, 31 .. 127
  signal winnerswinner2_pair_tag, winnerswinner2_four_tag, winnerswinner2_tag : tag_5;
  -- winnerswinner3
  signal winnerswinner3_of_pair_0 : natural_127_1d(0 to 7);
  signal winnerswinner3_pair_index_0 : natural_127_1d(0 to 3);  -- _# up to 31, 63 .. 127
  signal winnerswinner3_of_four_0 : natural_127_1d(0 to 7);
  signal winnerswinner3_four_index_0 : natural_127_1d(0 to 1);  -- _# up to 63, 127
  signal winnerswinner3_best_cost_0 : natural_127_1d(0 to 1);
  signal winnerswinner3_best_index_0 : natural_127_1d(0 to 1);  -- _# up to 63, 127
  signal winnerswinner3_pair_tag, winnerswinner3_four_tag, winnerswinner3_tag : tag_5;
  -- winnerswinner4
  signal winnerswinner4_best_index_0_0 : natural range 0 to 127;
  signal winnerswinner4_tag : tag_5;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 127;
  signal winners_best_tag : tag_5;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 1023;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame,
    turn_order_turned_end_of_line, turn_comes : boolean;
  signal turn_read_tag : tag_4_b;
  signal turn_ready_tag : tag_5_b;
  signal turn_newest, turn_write_words_0 : natural range 0 to 383;
  signal turn_read_words_0 : unsigned(8 downto 0);
  signal turn_ready : natural range 0 to 511;
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column,
    map_sorted_column : natural range 0 to 1023;
  signal map_counter_group : natural range 0 to 511;
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
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 255;
  signal map_column : natural_255_1d(1 to 2);
  signal map_rows_read_words_0 : unsigned(16 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 131071;
  signal map_rows_write_words_0 : natural range 0 to 130815;
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0, map_sorted_middle_0,
    map_sorted_high_0 : natural range 0 to 127;
  signal map_low_0, map_middle_0, map_high_0 : natural_127_1d(0 to 2);  -- _#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b, map_of_middle_0_c,
    map_of_high_0_a, map_of_high_0_b, map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0,
    map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 127;
  -- other
  signal other_0, other_2 : unsigned(48 downto 0);
  signal other_1 : natural range 0 to 254;
  signal other : natural_44_1d(3 to 258);

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
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(map_counter_column, 10);
    write_address <= to_unsigned(map_at_column, 10);
    write_data <= to_unsigned(map_rows_write_words_0, 17);
    cell : entity work.line_memory generic map (513, 17, 10)
      port map (clock, true, read_address, map_rows_read_words_0, write_address, write_data);
  end block;

  turn_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(turn_order_address, 10);
    write_address <= to_unsigned(turn_write_place, 10);
    write_data <= to_unsigned(turn_write_words_0, 9);
    cell : entity work.line_memory generic map (513, 9, 10)
      port map (clock, true, read_address, turn_read_words_0, write_address, write_data);
  end block;

  sums_sum_delay_held_memory : for i in 31 downto 0 generate
    signal read_address, write_address : unsigned(1 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
    write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
    write_data <= to_unsigned(sums_turn_ready_sums(i), 28);
    cell : entity work.line_memory generic map (4, 28, 2)
      port map (clock, entry_tag.valid, read_address, sums_sum_delay_held(i), write_address, write_data);
  end generate;

  sums_turn_read_sums_memory : for i in 31 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 10);
    write_address <= to_unsigned(sums_turn_write_place, 10);
    write_data <= to_unsigned(sums_turn_write_sums(i), 28);
    cell : entity work.line_memory generic map (513, 28, 10)
      port map (clock, true, read_address, sums_turn_read_sums(i), write_address, write_data);
  end generate;

  sums_turn_read_costs_memory : for i in 15 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 10);
    write_address <= to_unsigned(sums_turn_write_place, 10);
    cell : entity work.line_memory generic map (513, 32, 10)
      port map (clock, true, read_address, sums_turn_read_costs(i), write_address, sums_turn_write_costs(i));
  end generate;

  sums_turn_read_smallest_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(3 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 10);
    write_address <= to_unsigned(sums_turn_write_place, 10);
    write_data <= to_unsigned(sums_turn_write_smallest_0, 4);
    cell : entity work.line_memory generic map (513, 4, 10)
      port map (clock, true, read_address, sums_turn_read_smallest_0, write_address, write_data);
  end block;

  forward_above_read_words_21_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(entry_next_column, 10);
    write_address <= to_unsigned(forward_above_write_column, 10);
    write_data <= to_unsigned(forward_above_write_words_21, 12);
    cell : entity work.line_memory generic map (513, 12, 10)
      port map (clock, true, read_address, forward_above_read_words_21, write_address, write_data);
  end block;

  forward_above_read_words_memory : for i in 20 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(entry_next_column, 10);
    write_address <= to_unsigned(forward_above_write_column, 10);
    cell : entity work.line_memory generic map (513, 32, 10)
      port map (clock, true, read_address, forward_above_read_words(i), write_address, forward_above_write_words(i));
  end generate;

  forward_above_delay_held_25_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(17 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= to_unsigned(forward_above_total(127), 6) & to_unsigned(forward_above_total(126), 6) &
      to_unsigned(forward_above_total(125), 6);
    cell : entity work.line_memory generic map (8, 18, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held_25, write_address, write_data);
  end block;

  forward_above_delay_held_memory : for i in 24 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= to_unsigned(forward_above_total(5 * i + 4), 6) & to_unsigned(forward_above_total(5 * i + 3), 6) &
      to_unsigned(forward_above_total(5 * i + 2), 6) & to_unsigned(forward_above_total(5 * i + 1), 6) &
      to_unsigned(forward_above_total(5 * i), 6);
    cell : entity work.line_memory generic map (8, 30, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held(i), write_address, write_data);
  end generate;

  forward_cost_delay_held_memory : for i in 15 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
    write_data <= to_unsigned(entry_cost(8 * i + 7), 4) & to_unsigned(entry_cost(8 * i + 6), 4) &
      to_unsigned(entry_cost(8 * i + 5), 4) & to_unsigned(entry_cost(8 * i + 4), 4) & to_unsigned(entry_cost(8 * i +
      3), 4) & to_unsigned(entry_cost(8 * i + 2), 4) & to_unsigned(entry_cost(8 * i + 1), 4) & to_unsigned(entry_cost(8
      * i), 4);
    cell : entity work.line_memory generic map (8, 32, 3)
      port map (clock, entry_tag.valid, read_address, forward_cost_delay_held(i), write_address, write_data);
  end generate;

  process
    variable transform_counter_group_is_equals, turn_ready_tag_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_is_equal,
      delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less,
      entry_order_falls_any, entry_order_falls_all, entry_order_complete_all, entry_order_complete_any,
      entry_order_turned_output_column_choice, forward_left_start_cost_0_value, sums_right_start_cost_0_value,
      sums_turn_writes_copy_0_choice, winnerswinner4_best_index_0_0_choice_7, turn_order_falls_all,
      turn_order_complete_all, turn_ready_tag_row_start_differs, map_counter_group_is_equal, map_line_ended_choice,
      map_at_arrives_value, map_window_complete_is_equal, map_window_complete_choice, map_of_low_0_b_below_a_is_equal,
      map_of_low_0_b_below_a_choice_6, map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice_6,
      map_of_low_0_c_below_b_choice_6, map_of_middle_0_b_below_a_is_equal, map_of_middle_0_b_below_a_choice_6,
      map_of_middle_0_c_below_a_value, map_of_middle_0_c_below_a_choice_6, map_of_middle_0_c_below_b_choice_6,
      map_of_high_0_b_below_a_is_equal, map_of_high_0_b_below_a_choice_6, map_of_high_0_c_below_a_value,
      map_of_high_0_c_below_a_choice_6, map_of_high_0_c_below_b_choice_6, map_of_all_0_b_below_a_is_equal,
      map_of_all_0_b_below_a_choice_6, map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice_6,
      map_of_all_0_c_below_b_choice_6 : boolean;
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choices, map_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_counter_next_frame_choices : boolean_1d(1 to 4);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(8 to 353);
    variable transform_left_filter_feature_0_choice_354,
      transform_right_filter_feature_0_choice_354 : natural range 0 to 31;
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
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 1023;
    variable forward_left_pair_choice, sums_right_pair_choice : natural_63_1d(0 to 63);  -- _#_choice
    variable forward_left_start_cost_0_choices, sums_right_start_cost_0_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable forward_left_room_choices, sums_right_room_choices : natural_31_1d(1 to 2);  -- _choice_#
    variable forward_left_g_copy_0_value, forward_left_g_less_copy_0_value, sums_right_g_copy_0_value,
      sums_right_g_less_copy_0_value : natural range 0 to 63;
    variable forward_left_cost_choice, forward_left_arrived_choice, sums_right_cost_choice,
      sums_right_arrived_choice : natural_63_2d(0 to 127, 1 to 2);  -- _#_choice_#
    variable forward_above_total_choice : natural_31_1d(0 to 127);  -- _#_choice
    variable forward_above_write_words_choice : natural_67_2d(0 to 21, 1 to 6);  -- _#_choice_#
    variable winnerswinner1_of_pair_0_value : boolean_2d(0 to 63, 1 to 4);  -- _2#_value_#
    variable winnerswinner1_of_pair_0_choice_7 : boolean_1d(0 to 63);  -- _2#_choice_7
    variable winnerswinner1_of_four_0_choice : boolean_2d(0 to 31, 1 to 7);  -- _4#_choice_#
    variable winnerswinner1_of_four_0_value : boolean_2d(0 to 31, 1 to 10);  -- _4#_value_#
    variable winnerswinner2_of_pair_0_value : boolean_2d(0 to 15, 1 to 4);  -- _2#_value_#
    variable winnerswinner2_of_pair_0_choice_7 : boolean_1d(0 to 15);  -- _2#_choice_7
    variable winnerswinner2_of_four_0_choice : boolean_2d(0 to 7, 1 to 7);  -- _4#_choice_#
    variable winnerswinner2_of_four_0_value : boolean_2d(0 to 7, 1 to 10);  -- _4#_value_#
    variable winnerswinner3_of_pair_0_value : boolean_2d(0 to 3, 1 to 4);  -- _2#_value_#
    variable winnerswinner3_of_pair_0_choice_7 : boolean_1d(0 to 3);  -- _2#_choice_7
    variable winnerswinner3_of_four_0_choice : boolean_2d(0 to 4, 1 to 7);  -- _#_choice_#
    variable winnerswinner3_of_four_0_value : boolean_2d(0 to 4, 1 to 10);  -- _#_value_#
    variable winnerswinner4_best_index_0_0_values : boolean_1d(1 to 4);  -- _value_#
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
    variable turn_ready_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable turn_ready_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable map_of_column_0_b_below_a_values : boolean_1d(1 to 10);  -- _value_#
    variable map_of_column_0_b_below_a_choices : boolean_1d(1 to 8);  -- _choice_#
    variable map_of_column_0_c_below_a_values : boolean_1d(1 to 6);  -- _value_#
    variable map_of_column_0_c_below_a_choices : boolean_1d(1 to 17);  -- _choice_#
    variable map_of_column_0_c_below_b_choices : boolean_1d(1 to 5);  -- _choice_#
    variable map_sorted_low_0_choices, map_sorted_middle_0_choices, map_sorted_high_0_choices,
      map_largest_low_0_choices, map_smallest_high_0_choices : natural_127_1d(1 to 2);  -- _choice_#
    variable map_of_low_0_b_below_a_values, map_of_middle_0_b_below_a_values, map_of_high_0_b_below_a_values,
      map_of_all_0_b_below_a_values : boolean_1d(1 to 9);  -- _value_#
    variable map_median_middle_0_choices, map_out_disparity_0_choices : natural_127_1d(1 to 4);  -- _choice_#
    variable map_low_0_0_choice, map_middle_0_0_choice, map_high_0_0_choice : natural range 0 to 127;
    variable map_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
    variable other_choice : natural_11_1d(2 to 129);  -- _2#_choice
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    forward_above_write_words_choice := (others => (others => 0));
    forward_left_arrived_choice := (others => (others => 0)); sums_right_arrived_choice := (others => (others => 0));
    transform_left_filter_feature_0_choice := (others => false);
    transform_right_filter_feature_0_choice := (others => false);
    winnerswinner3_of_four_0_choice := (others => (others => false));
    winnerswinner3_of_four_0_value := (others => (others => false));
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
    delay_tag.border_column <= raster_place_column < 127;
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
    -- slice0shift
    if rows_tag.valid then
      slice0shift_search_0(0) <= rows_search_0;
      slice0shift_search_0(1 to 15) <= slice0shift_search_0(0 to 14);
    end if;
    slice0shift_reference_0 <= rows_reference_0;
    slice0shift_search_out_0 <= slice0shift_search_0(15);
    slice0shift_tag <= rows_tag;
    -- slice0cost
    slice0cost_pixels_first_0_count(0, 0) <= differing_bits(slice0shift_search_0(0), slice0shift_reference_0, 0) +
      differing_bits(slice0shift_reference_0, slice0shift_search_0(0), 2) + differing_bits(slice0shift_reference_0,
      slice0shift_search_0(0), 1);
    slice0cost_pixels_first_0_count(0, 1) <= differing_bits(slice0shift_reference_0, slice0shift_search_0(0), 3, 5, 4);
    slice0cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0(0)(7 downto 0)),
      8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
      differing_bits(slice0shift_reference_0, slice0shift_search_0(0), 8) + differing_bits(slice0shift_reference_0,
      slice0shift_search_0(0), 6);
    for i in 3 to 13 loop
      slice0cost_pixels_first_0_count(0, i) <= differing_bits(slice0shift_reference_0, slice0shift_search_0(0), 3 * i,
        3 * i + 2, 3 * i + 1);
    end loop;
    slice0cost_pixels_first_0_count_14(0) <= differing_bits(slice0shift_reference_0, slice0shift_search_0(0), 43) +
      differing_bits(slice0shift_reference_0, slice0shift_search_0(0), 42);
    for i in 1 to 15 loop
      slice0cost_pixels_first_0_count(i, 0) <= differing_bits(slice0shift_search_0(i), slice0shift_reference_0, 0, 2,
        1);
      slice0cost_pixels_first_0_count(i, 1) <= differing_bits(slice0shift_search_0(i), slice0shift_reference_0, 3, 5,
        4);
      slice0cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0(i)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
        differing_bits(slice0shift_search_0(i), slice0shift_reference_0, 8) + differing_bits(slice0shift_search_0(i),
        slice0shift_reference_0, 6);
      for j in 3 to 13 loop
        slice0cost_pixels_first_0_count(i, j) <= differing_bits(slice0shift_search_0(i), slice0shift_reference_0, 3 *
          j, 3 * j + 2, 3 * j + 1);
      end loop;
      slice0cost_pixels_first_0_count_14(i) <= differing_bits(slice0shift_search_0(i), slice0shift_reference_0, 43) +
        differing_bits(slice0shift_search_0(i), slice0shift_reference_0, 42);
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 15 loop
      slice0cost_pixels_cost_0(i) <= slice0cost_pixels_first_0_count(i, 3) + slice0cost_pixels_first_0_count(i, 7) +
        slice0cost_pixels_first_0_count(i, 12) + slice0cost_pixels_first_0_count(i, 6) +
        slice0cost_pixels_first_0_count(i, 9) + slice0cost_pixels_first_0_count_14(i) +
        slice0cost_pixels_first_0_count(i, 11) + slice0cost_pixels_first_0_count(i, 2) +
        slice0cost_pixels_first_0_count(i, 10) + slice0cost_pixels_first_0_count(i, 4) +
        slice0cost_pixels_first_0_count(i, 8) + slice0cost_pixels_first_0_count(i, 1) +
        slice0cost_pixels_first_0_count(i, 5) + slice0cost_pixels_first_0_count(i, 0) +
        slice0cost_pixels_first_0_count(i, 13);
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    slice0cost_single_0 <= slice0cost_pixels_cost_0;
    slice0cost_pair_tag <= slice0cost_pixels_tag;
    slice0cost_tag <= slice0cost_pair_tag;
    -- slice0window
    slice0window_tag <= slice0cost_tag;
    -- slice0
    for i in 0 to 15 loop slice0_held(0, i) <= other(257 - 2 * i) / 4; end loop;
    for i in 0 to 2 loop
      for j in 0 to 15 loop slice0_held(2 * i + 1, j) <= slice0_held(2 * i, j); end loop;
      for j in 0 to 15 loop slice0_held(2 * i + 2, j) <= slice0_held(2 * i + 1, j); end loop;
    end loop;
    for i in 0 to 15 loop slice0_held(7, i) <= slice0_held(6, i); end loop;
    slice0_tag_valid(0) <= slice0window_tag.valid;
    slice0_tag_border_column(0) <= slice0window_tag.border_column;
    slice0_tag_first_cost(0) <= slice0window_tag.first_cost;
    slice0_tag_map_column(0) <= slice0window_tag.map_column;
    slice0_tag_output_column(0) <= slice0window_tag.output_column;
    slice0_tag_start_of_frame(0) <= slice0window_tag.start_of_frame;
    slice0_tag_end_of_line(0) <= slice0window_tag.end_of_line;
    for i in 1 to 3 loop
      slice0_tag_valid(i) <= slice0_tag_valid(i - 1);
      slice0_tag_border_column(i) <= slice0_tag_border_column(i - 1);
      slice0_tag_first_cost(i) <= slice0_tag_first_cost(i - 1);
      slice0_tag_map_column(i) <= slice0_tag_map_column(i - 1);
      slice0_tag_output_column(i) <= slice0_tag_output_column(i - 1);
      slice0_tag_start_of_frame(i) <= slice0_tag_start_of_frame(i - 1);
      slice0_tag_end_of_line(i) <= slice0_tag_end_of_line(i - 1);
    end loop;
    slice0_tag_valid(4) <= slice0_tag_valid(3);
    slice0_tag_border_column(4) <= slice0_tag_border_column(3);
    for i in 4 to 6 loop
      slice0_tag_first_cost(i) <= slice0_tag_first_cost(i - 1);
      slice0_tag_map_column(i) <= slice0_tag_map_column(i - 1);
      slice0_tag_output_column(i) <= slice0_tag_output_column(i - 1);
      slice0_tag_start_of_frame(i) <= slice0_tag_start_of_frame(i - 1);
      slice0_tag_end_of_line(i) <= slice0_tag_end_of_line(i - 1);
      slice0_tag_valid(i + 1) <= slice0_tag_valid(i);
    end loop;
    slice0_tag_first_cost(7) <= slice0_tag_first_cost(6);
    slice0_tag_map_column(7) <= slice0_tag_map_column(6);
    slice0_tag_output_column(7) <= slice0_tag_output_column(6);
    slice0_tag_start_of_frame(7) <= slice0_tag_start_of_frame(6);
    slice0_tag_end_of_line(7) <= slice0_tag_end_of_line(6);
    -- slice1shift
    if slice0shift_tag.valid then
      slice1shift_search_0(0) <= slice0shift_search_out_0;
      slice1shift_search_0(1 to 15) <= slice1shift_search_0(0 to 14);
    end if;
    slice1shift_reference_0 <= slice0shift_reference_0;
    slice1shift_search_out_0 <= slice1shift_search_0(15);
    -- slice1cost
    slice1cost_pixels_first_0_count(0, 0) <= differing_bits(slice1shift_search_0(0), slice1shift_reference_0, 0) +
      differing_bits(slice1shift_reference_0, slice1shift_search_0(0), 2) + differing_bits(slice1shift_reference_0,
      slice1shift_search_0(0), 1);
    slice1cost_pixels_first_0_count(0, 1) <= differing_bits(slice1shift_reference_0, slice1shift_search_0(0), 3, 5, 4);
    slice1cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0(0)(7 downto 0)),
      8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
      differing_bits(slice1shift_reference_0, slice1shift_search_0(0), 8) + differing_bits(slice1shift_reference_0,
      slice1shift_search_0(0), 6);
    for i in 3 to 13 loop
      slice1cost_pixels_first_0_count(0, i) <= differing_bits(slice1shift_reference_0, slice1shift_search_0(0), 3 * i,
        3 * i + 2, 3 * i + 1);
    end loop;
    slice1cost_pixels_first_0_count_14(0) <= differing_bits(slice1shift_reference_0, slice1shift_search_0(0), 43) +
      differing_bits(slice1shift_reference_0, slice1shift_search_0(0), 42);
    for i in 1 to 15 loop
      slice1cost_pixels_first_0_count(i, 0) <= differing_bits(slice1shift_search_0(i), slice1shift_reference_0, 0, 2,
        1);
      slice1cost_pixels_first_0_count(i, 1) <= differing_bits(slice1shift_search_0(i), slice1shift_reference_0, 3, 5,
        4);
      slice1cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0(i)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
        differing_bits(slice1shift_search_0(i), slice1shift_reference_0, 8) + differing_bits(slice1shift_search_0(i),
        slice1shift_reference_0, 6);
      for j in 3 to 13 loop
        slice1cost_pixels_first_0_count(i, j) <= differing_bits(slice1shift_search_0(i), slice1shift_reference_0, 3 *
          j, 3 * j + 2, 3 * j + 1);
      end loop;
      slice1cost_pixels_first_0_count_14(i) <= differing_bits(slice1shift_search_0(i), slice1shift_reference_0, 43) +
        differing_bits(slice1shift_search_0(i), slice1shift_reference_0, 42);
    end loop;
    for i in 0 to 15 loop
      slice1cost_pixels_cost_0(i) <= slice1cost_pixels_first_0_count(i, 3) + slice1cost_pixels_first_0_count(i, 7) +
        slice1cost_pixels_first_0_count(i, 12) + slice1cost_pixels_first_0_count(i, 6) +
        slice1cost_pixels_first_0_count(i, 9) + slice1cost_pixels_first_0_count_14(i) +
        slice1cost_pixels_first_0_count(i, 11) + slice1cost_pixels_first_0_count(i, 2) +
        slice1cost_pixels_first_0_count(i, 10) + slice1cost_pixels_first_0_count(i, 4) +
        slice1cost_pixels_first_0_count(i, 8) + slice1cost_pixels_first_0_count(i, 1) +
        slice1cost_pixels_first_0_count(i, 5) + slice1cost_pixels_first_0_count(i, 0) +
        slice1cost_pixels_first_0_count(i, 13);
    end loop;
    slice1cost_single_0 <= slice1cost_pixels_cost_0;
    -- slice1
    for i in 0 to 15 loop slice1_held(0, i) <= other(225 - 2 * i) / 4; end loop;
    for i in 0 to 2 loop
      for j in 0 to 15 loop slice1_held(2 * i + 1, j) <= slice1_held(2 * i, j); end loop;
      for j in 0 to 15 loop slice1_held(2 * i + 2, j) <= slice1_held(2 * i + 1, j); end loop;
    end loop;
    -- slice2shift
    if slice0cost_pixels_first_tag.valid then
      slice2shift_search_0(0) <= slice1shift_search_out_0;
      slice2shift_search_0(1 to 15) <= slice2shift_search_0(0 to 14);
    end if;
    slice2shift_reference_0 <= slice1shift_reference_0;
    slice2shift_search_out_0 <= slice2shift_search_0(15);
    -- slice2cost
    slice2cost_pixels_first_0_count(0, 0) <= differing_bits(slice2shift_search_0(0), slice2shift_reference_0, 0) +
      differing_bits(slice2shift_reference_0, slice2shift_search_0(0), 2) + differing_bits(slice2shift_reference_0,
      slice2shift_search_0(0), 1);
    slice2cost_pixels_first_0_count(0, 1) <= differing_bits(slice2shift_reference_0, slice2shift_search_0(0), 3, 5, 4);
    slice2cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice2shift_search_0(0)(7 downto 0)),
      8)) xor (to_unsigned(to_integer(slice2shift_reference_0(7 downto 0)), 8)))) / 128) +
      differing_bits(slice2shift_reference_0, slice2shift_search_0(0), 8) + differing_bits(slice2shift_reference_0,
      slice2shift_search_0(0), 6);
    for i in 3 to 13 loop
      slice2cost_pixels_first_0_count(0, i) <= differing_bits(slice2shift_reference_0, slice2shift_search_0(0), 3 * i,
        3 * i + 2, 3 * i + 1);
    end loop;
    slice2cost_pixels_first_0_count_14(0) <= differing_bits(slice2shift_reference_0, slice2shift_search_0(0), 43) +
      differing_bits(slice2shift_reference_0, slice2shift_search_0(0), 42);
    for i in 1 to 15 loop
      slice2cost_pixels_first_0_count(i, 0) <= differing_bits(slice2shift_search_0(i), slice2shift_reference_0, 0, 2,
        1);
      slice2cost_pixels_first_0_count(i, 1) <= differing_bits(slice2shift_search_0(i), slice2shift_reference_0, 3, 5,
        4);
      slice2cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice2shift_search_0(i)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice2shift_reference_0(7 downto 0)), 8)))) / 128) +
        differing_bits(slice2shift_search_0(i), slice2shift_reference_0, 8) + differing_bits(slice2shift_search_0(i),
        slice2shift_reference_0, 6);
      for j in 3 to 13 loop
        slice2cost_pixels_first_0_count(i, j) <= differing_bits(slice2shift_search_0(i), slice2shift_reference_0, 3 *
          j, 3 * j + 2, 3 * j + 1);
      end loop;
      slice2cost_pixels_first_0_count_14(i) <= differing_bits(slice2shift_search_0(i), slice2shift_reference_0, 43) +
        differing_bits(slice2shift_search_0(i), slice2shift_reference_0, 42);
    end loop;
    for i in 0 to 15 loop
      slice2cost_pixels_cost_0(i) <= slice2cost_pixels_first_0_count(i, 3) + slice2cost_pixels_first_0_count(i, 7) +
        slice2cost_pixels_first_0_count(i, 12) + slice2cost_pixels_first_0_count(i, 6) +
        slice2cost_pixels_first_0_count(i, 9) + slice2cost_pixels_first_0_count_14(i) +
        slice2cost_pixels_first_0_count(i, 11) + slice2cost_pixels_first_0_count(i, 2) +
        slice2cost_pixels_first_0_count(i, 10) + slice2cost_pixels_first_0_count(i, 4) +
        slice2cost_pixels_first_0_count(i, 8) + slice2cost_pixels_first_0_count(i, 1) +
        slice2cost_pixels_first_0_count(i, 5) + slice2cost_pixels_first_0_count(i, 0) +
        slice2cost_pixels_first_0_count(i, 13);
    end loop;
    slice2cost_single_0 <= slice2cost_pixels_cost_0;
    -- slice2
    for i in 0 to 15 loop slice2_held(0, i) <= other(193 - 2 * i) / 4; end loop;
    for i in 1 to 5 loop
      for j in 0 to 15 loop slice2_held(i, j) <= slice2_held(i - 1, j); end loop;
    end loop;
    -- slice3shift
    if slice0cost_pixels_tag.valid then
      slice3shift_search_0(0) <= slice2shift_search_out_0;
      slice3shift_search_0(1 to 15) <= slice3shift_search_0(0 to 14);
    end if;
    slice3shift_reference_0 <= slice2shift_reference_0;
    slice3shift_search_out_0 <= slice3shift_search_0(15);
    -- slice3cost
    slice3cost_pixels_first_0_count(0, 0) <= differing_bits(slice3shift_search_0(0), slice3shift_reference_0, 0) +
      differing_bits(slice3shift_reference_0, slice3shift_search_0(0), 2) + differing_bits(slice3shift_reference_0,
      slice3shift_search_0(0), 1);
    slice3cost_pixels_first_0_count(0, 1) <= differing_bits(slice3shift_reference_0, slice3shift_search_0(0), 3, 5, 4);
    slice3cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice3shift_search_0(0)(7 downto 0)),
      8)) xor (to_unsigned(to_integer(slice3shift_reference_0(7 downto 0)), 8)))) / 128) +
      differing_bits(slice3shift_reference_0, slice3shift_search_0(0), 8) + differing_bits(slice3shift_reference_0,
      slice3shift_search_0(0), 6);
    for i in 3 to 13 loop
      slice3cost_pixels_first_0_count(0, i) <= differing_bits(slice3shift_reference_0, slice3shift_search_0(0), 3 * i,
        3 * i + 2, 3 * i + 1);
    end loop;
    slice3cost_pixels_first_0_count_14(0) <= differing_bits(slice3shift_reference_0, slice3shift_search_0(0), 43) +
      differing_bits(slice3shift_reference_0, slice3shift_search_0(0), 42);
    for i in 1 to 15 loop
      slice3cost_pixels_first_0_count(i, 0) <= differing_bits(slice3shift_search_0(i), slice3shift_reference_0, 0, 2,
        1);
      slice3cost_pixels_first_0_count(i, 1) <= differing_bits(slice3shift_search_0(i), slice3shift_reference_0, 3, 5,
        4);
      slice3cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice3shift_search_0(i)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice3shift_reference_0(7 downto 0)), 8)))) / 128) +
        differing_bits(slice3shift_search_0(i), slice3shift_reference_0, 8) + differing_bits(slice3shift_search_0(i),
        slice3shift_reference_0, 6);
      for j in 3 to 13 loop
        slice3cost_pixels_first_0_count(i, j) <= differing_bits(slice3shift_search_0(i), slice3shift_reference_0, 3 *
          j, 3 * j + 2, 3 * j + 1);
      end loop;
      slice3cost_pixels_first_0_count_14(i) <= differing_bits(slice3shift_search_0(i), slice3shift_reference_0, 43) +
        differing_bits(slice3shift_search_0(i), slice3shift_reference_0, 42);
    end loop;
    for i in 0 to 15 loop
      slice3cost_pixels_cost_0(i) <= slice3cost_pixels_first_0_count(i, 3) + slice3cost_pixels_first_0_count(i, 7) +
        slice3cost_pixels_first_0_count(i, 12) + slice3cost_pixels_first_0_count(i, 6) +
        slice3cost_pixels_first_0_count(i, 9) + slice3cost_pixels_first_0_count_14(i) +
        slice3cost_pixels_first_0_count(i, 11) + slice3cost_pixels_first_0_count(i, 2) +
        slice3cost_pixels_first_0_count(i, 10) + slice3cost_pixels_first_0_count(i, 4) +
        slice3cost_pixels_first_0_count(i, 8) + slice3cost_pixels_first_0_count(i, 1) +
        slice3cost_pixels_first_0_count(i, 5) + slice3cost_pixels_first_0_count(i, 0) +
        slice3cost_pixels_first_0_count(i, 13);
    end loop;
    slice3cost_single_0 <= slice3cost_pixels_cost_0;
    -- slice3
    for i in 0 to 15 loop slice3_held(0, i) <= other(161 - 2 * i) / 4; end loop;
    for i in 1 to 4 loop
      for j in 0 to 15 loop slice3_held(i, j) <= slice3_held(i - 1, j); end loop;
    end loop;
    -- slice4shift
    if slice0cost_pair_tag.valid then
      slice4shift_search_0(0) <= slice3shift_search_out_0;
      slice4shift_search_0(1 to 15) <= slice4shift_search_0(0 to 14);
    end if;
    slice4shift_reference_0 <= slice3shift_reference_0;
    slice4shift_search_out_0 <= slice4shift_search_0(15);
    -- slice4cost
    slice4cost_pixels_first_0_count(0, 0) <= differing_bits(slice4shift_search_0(0), slice4shift_reference_0, 0) +
      differing_bits(slice4shift_reference_0, slice4shift_search_0(0), 2) + differing_bits(slice4shift_reference_0,
      slice4shift_search_0(0), 1);
    slice4cost_pixels_first_0_count(0, 1) <= differing_bits(slice4shift_reference_0, slice4shift_search_0(0), 3, 5, 4);
    slice4cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice4shift_search_0(0)(7 downto 0)),
      8)) xor (to_unsigned(to_integer(slice4shift_reference_0(7 downto 0)), 8)))) / 128) +
      differing_bits(slice4shift_reference_0, slice4shift_search_0(0), 8) + differing_bits(slice4shift_reference_0,
      slice4shift_search_0(0), 6);
    for i in 3 to 13 loop
      slice4cost_pixels_first_0_count(0, i) <= differing_bits(slice4shift_reference_0, slice4shift_search_0(0), 3 * i,
        3 * i + 2, 3 * i + 1);
    end loop;
    slice4cost_pixels_first_0_count_14(0) <= differing_bits(slice4shift_reference_0, slice4shift_search_0(0), 43) +
      differing_bits(slice4shift_reference_0, slice4shift_search_0(0), 42);
    for i in 1 to 15 loop
      slice4cost_pixels_first_0_count(i, 0) <= differing_bits(slice4shift_search_0(i), slice4shift_reference_0, 0, 2,
        1);
      slice4cost_pixels_first_0_count(i, 1) <= differing_bits(slice4shift_search_0(i), slice4shift_reference_0, 3, 5,
        4);
      slice4cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice4shift_search_0(i)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice4shift_reference_0(7 downto 0)), 8)))) / 128) +
        differing_bits(slice4shift_search_0(i), slice4shift_reference_0, 8) + differing_bits(slice4shift_search_0(i),
        slice4shift_reference_0, 6);
      for j in 3 to 13 loop
        slice4cost_pixels_first_0_count(i, j) <= differing_bits(slice4shift_search_0(i), slice4shift_reference_0, 3 *
          j, 3 * j + 2, 3 * j + 1);
      end loop;
      slice4cost_pixels_first_0_count_14(i) <= differing_bits(slice4shift_search_0(i), slice4shift_reference_0, 43) +
        differing_bits(slice4shift_search_0(i), slice4shift_reference_0, 42);
    end loop;
    for i in 0 to 15 loop
      slice4cost_pixels_cost_0(i) <= slice4cost_pixels_first_0_count(i, 3) + slice4cost_pixels_first_0_count(i, 7) +
        slice4cost_pixels_first_0_count(i, 12) + slice4cost_pixels_first_0_count(i, 6) +
        slice4cost_pixels_first_0_count(i, 9) + slice4cost_pixels_first_0_count_14(i) +
        slice4cost_pixels_first_0_count(i, 11) + slice4cost_pixels_first_0_count(i, 2) +
        slice4cost_pixels_first_0_count(i, 10) + slice4cost_pixels_first_0_count(i, 4) +
        slice4cost_pixels_first_0_count(i, 8) + slice4cost_pixels_first_0_count(i, 1) +
        slice4cost_pixels_first_0_count(i, 5) + slice4cost_pixels_first_0_count(i, 0) +
        slice4cost_pixels_first_0_count(i, 13);
    end loop;
    slice4cost_single_0 <= slice4cost_pixels_cost_0;
    -- slice4
    for i in 0 to 15 loop slice4_held(0, i) <= other(129 - 2 * i) / 4; end loop;
    for i in 1 to 3 loop
      for j in 0 to 15 loop slice4_held(i, j) <= slice4_held(i - 1, j); end loop;
    end loop;
    -- slice5shift
    if slice0cost_tag.valid then
      slice5shift_search_0(0) <= slice4shift_search_out_0;
      slice5shift_search_0(1 to 15) <= slice5shift_search_0(0 to 14);
    end if;
    slice5shift_reference_0 <= slice4shift_reference_0;
    slice5shift_search_out_0 <= slice5shift_search_0(15);
    -- slice5cost
    slice5cost_pixels_first_0_count(0, 0) <= differing_bits(slice5shift_search_0(0), slice5shift_reference_0, 0) +
      differing_bits(slice5shift_reference_0, slice5shift_search_0(0), 2) + differing_bits(slice5shift_reference_0,
      slice5shift_search_0(0), 1);
    slice5cost_pixels_first_0_count(0, 1) <= differing_bits(slice5shift_reference_0, slice5shift_search_0(0), 3, 5, 4);
    slice5cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice5shift_search_0(0)(7 downto 0)),
      8)) xor (to_unsigned(to_integer(slice5shift_reference_0(7 downto 0)), 8)))) / 128) +
      differing_bits(slice5shift_reference_0, slice5shift_search_0(0), 8) + differing_bits(slice5shift_reference_0,
      slice5shift_search_0(0), 6);
    for i in 3 to 13 loop
      slice5cost_pixels_first_0_count(0, i) <= differing_bits(slice5shift_reference_0, slice5shift_search_0(0), 3 * i,
        3 * i + 2, 3 * i + 1);
    end loop;
    slice5cost_pixels_first_0_count_14(0) <= differing_bits(slice5shift_reference_0, slice5shift_search_0(0), 43) +
      differing_bits(slice5shift_reference_0, slice5shift_search_0(0), 42);
    for i in 1 to 15 loop
      slice5cost_pixels_first_0_count(i, 0) <= differing_bits(slice5shift_search_0(i), slice5shift_reference_0, 0, 2,
        1);
      slice5cost_pixels_first_0_count(i, 1) <= differing_bits(slice5shift_search_0(i), slice5shift_reference_0, 3, 5,
        4);
      slice5cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice5shift_search_0(i)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice5shift_reference_0(7 downto 0)), 8)))) / 128) +
        differing_bits(slice5shift_search_0(i), slice5shift_reference_0, 8) + differing_bits(slice5shift_search_0(i),
        slice5shift_reference_0, 6);
      for j in 3 to 13 loop
        slice5cost_pixels_first_0_count(i, j) <= differing_bits(slice5shift_search_0(i), slice5shift_reference_0, 3 *
          j, 3 * j + 2, 3 * j + 1);
      end loop;
      slice5cost_pixels_first_0_count_14(i) <= differing_bits(slice5shift_search_0(i), slice5shift_reference_0, 43) +
        differing_bits(slice5shift_search_0(i), slice5shift_reference_0, 42);
    end loop;
    for i in 0 to 15 loop
      slice5cost_pixels_cost_0(i) <= slice5cost_pixels_first_0_count(i, 3) + slice5cost_pixels_first_0_count(i, 7) +
        slice5cost_pixels_first_0_count(i, 12) + slice5cost_pixels_first_0_count(i, 6) +
        slice5cost_pixels_first_0_count(i, 9) + slice5cost_pixels_first_0_count_14(i) +
        slice5cost_pixels_first_0_count(i, 11) + slice5cost_pixels_first_0_count(i, 2) +
        slice5cost_pixels_first_0_count(i, 10) + slice5cost_pixels_first_0_count(i, 4) +
        slice5cost_pixels_first_0_count(i, 8) + slice5cost_pixels_first_0_count(i, 1) +
        slice5cost_pixels_first_0_count(i, 5) + slice5cost_pixels_first_0_count(i, 0) +
        slice5cost_pixels_first_0_count(i, 13);
    end loop;
    slice5cost_single_0 <= slice5cost_pixels_cost_0;
    -- slice5
    for i in 0 to 15 loop slice5_held(0, i) <= other(97 - 2 * i) / 4; end loop;
    for i in 0 to 15 loop slice5_held(1, i) <= slice5_held(0, i); end loop;
    for i in 0 to 15 loop slice5_held(2, i) <= slice5_held(1, i); end loop;
    -- slice6shift
    if slice0window_tag.valid then
      slice6shift_search_0(0) <= slice5shift_search_out_0;
      slice6shift_search_0(1 to 15) <= slice6shift_search_0(0 to 14);
    end if;
    slice6shift_reference_0 <= slice5shift_reference_0;
    slice6shift_search_out_0 <= slice6shift_search_0(15);
    -- slice6cost
    slice6cost_pixels_first_0_count(0, 0) <= differing_bits(slice6shift_search_0(0), slice6shift_reference_0, 0) +
      differing_bits(slice6shift_reference_0, slice6shift_search_0(0), 2) + differing_bits(slice6shift_reference_0,
      slice6shift_search_0(0), 1);
    slice6cost_pixels_first_0_count(0, 1) <= differing_bits(slice6shift_reference_0, slice6shift_search_0(0), 3, 5, 4);
    slice6cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice6shift_search_0(0)(7 downto 0)),
      8)) xor (to_unsigned(to_integer(slice6shift_reference_0(7 downto 0)), 8)))) / 128) +
      differing_bits(slice6shift_reference_0, slice6shift_search_0(0), 8) + differing_bits(slice6shift_reference_0,
      slice6shift_search_0(0), 6);
    for i in 3 to 13 loop
      slice6cost_pixels_first_0_count(0, i) <= differing_bits(slice6shift_reference_0, slice6shift_search_0(0), 3 * i,
        3 * i + 2, 3 * i + 1);
    end loop;
    slice6cost_pixels_first_0_count_14(0) <= differing_bits(slice6shift_reference_0, slice6shift_search_0(0), 43) +
      differing_bits(slice6shift_reference_0, slice6shift_search_0(0), 42);
    for i in 1 to 15 loop
      slice6cost_pixels_first_0_count(i, 0) <= differing_bits(slice6shift_search_0(i), slice6shift_reference_0, 0, 2,
        1);
      slice6cost_pixels_first_0_count(i, 1) <= differing_bits(slice6shift_search_0(i), slice6shift_reference_0, 3, 5,
        4);
      slice6cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice6shift_search_0(i)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice6shift_reference_0(7 downto 0)), 8)))) / 128) +
        differing_bits(slice6shift_search_0(i), slice6shift_reference_0, 8) + differing_bits(slice6shift_search_0(i),
        slice6shift_reference_0, 6);
      for j in 3 to 13 loop
        slice6cost_pixels_first_0_count(i, j) <= differing_bits(slice6shift_search_0(i), slice6shift_reference_0, 3 *
          j, 3 * j + 2, 3 * j + 1);
      end loop;
      slice6cost_pixels_first_0_count_14(i) <= differing_bits(slice6shift_search_0(i), slice6shift_reference_0, 43) +
        differing_bits(slice6shift_search_0(i), slice6shift_reference_0, 42);
    end loop;
    for i in 0 to 15 loop
      slice6cost_pixels_cost_0(i) <= slice6cost_pixels_first_0_count(i, 3) + slice6cost_pixels_first_0_count(i, 7) +
        slice6cost_pixels_first_0_count(i, 12) + slice6cost_pixels_first_0_count(i, 6) +
        slice6cost_pixels_first_0_count(i, 9) + slice6cost_pixels_first_0_count_14(i) +
        slice6cost_pixels_first_0_count(i, 11) + slice6cost_pixels_first_0_count(i, 2) +
        slice6cost_pixels_first_0_count(i, 10) + slice6cost_pixels_first_0_count(i, 4) +
        slice6cost_pixels_first_0_count(i, 8) + slice6cost_pixels_first_0_count(i, 1) +
        slice6cost_pixels_first_0_count(i, 5) + slice6cost_pixels_first_0_count(i, 0) +
        slice6cost_pixels_first_0_count(i, 13);
    end loop;
    slice6cost_single_0 <= slice6cost_pixels_cost_0;
    -- slice6
    for i in 0 to 15 loop slice6_held(0, i) <= other(65 - 2 * i) / 4; end loop;
    for i in 0 to 15 loop slice6_held(1, i) <= slice6_held(0, i); end loop;
    -- slice7shift
    if slice0_tag_valid(0) then
      slice7shift_search_0(0) <= slice6shift_search_out_0;
      slice7shift_search_0(1 to 15) <= slice7shift_search_0(0 to 14);
    end if;
    slice7shift_reference_0 <= slice6shift_reference_0;
    -- slice7cost
    slice7cost_pixels_first_0_count(0, 0) <= differing_bits(slice7shift_search_0(0), slice7shift_reference_0, 0) +
      differing_bits(slice7shift_reference_0, slice7shift_search_0(0), 2) + differing_bits(slice7shift_reference_0,
      slice7shift_search_0(0), 1);
    slice7cost_pixels_first_0_count(0, 1) <= differing_bits(slice7shift_reference_0, slice7shift_search_0(0), 3, 5, 4);
    slice7cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice7shift_search_0(0)(7 downto 0)),
      8)) xor (to_unsigned(to_integer(slice7shift_reference_0(7 downto 0)), 8)))) / 128) +
      differing_bits(slice7shift_reference_0, slice7shift_search_0(0), 8) + differing_bits(slice7shift_reference_0,
      slice7shift_search_0(0), 6);
    for i in 3 to 13 loop
      slice7cost_pixels_first_0_count(0, i) <= differing_bits(slice7shift_reference_0, slice7shift_search_0(0), 3 * i,
        3 * i + 2, 3 * i + 1);
    end loop;
    slice7cost_pixels_first_0_count_14(0) <= differing_bits(slice7shift_reference_0, slice7shift_search_0(0), 43) +
      differing_bits(slice7shift_reference_0, slice7shift_search_0(0), 42);
    for i in 1 to 15 loop
      slice7cost_pixels_first_0_count(i, 0) <= differing_bits(slice7shift_search_0(i), slice7shift_reference_0, 0, 2,
        1);
      slice7cost_pixels_first_0_count(i, 1) <= differing_bits(slice7shift_search_0(i), slice7shift_reference_0, 3, 5,
        4);
      slice7cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice7shift_search_0(i)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice7shift_reference_0(7 downto 0)), 8)))) / 128) +
        differing_bits(slice7shift_search_0(i), slice7shift_reference_0, 8) + differing_bits(slice7shift_search_0(i),
        slice7shift_reference_0, 6);
      for j in 3 to 13 loop
        slice7cost_pixels_first_0_count(i, j) <= differing_bits(slice7shift_search_0(i), slice7shift_reference_0, 3 *
          j, 3 * j + 2, 3 * j + 1);
      end loop;
      slice7cost_pixels_first_0_count_14(i) <= differing_bits(slice7shift_search_0(i), slice7shift_reference_0, 43) +
        differing_bits(slice7shift_search_0(i), slice7shift_reference_0, 42);
    end loop;
    for i in 0 to 15 loop
      slice7cost_pixels_cost_0(i) <= slice7cost_pixels_first_0_count(i, 3) + slice7cost_pixels_first_0_count(i, 7) +
        slice7cost_pixels_first_0_count(i, 12) + slice7cost_pixels_first_0_count(i, 6) +
        slice7cost_pixels_first_0_count(i, 9) + slice7cost_pixels_first_0_count_14(i) +
        slice7cost_pixels_first_0_count(i, 11) + slice7cost_pixels_first_0_count(i, 2) +
        slice7cost_pixels_first_0_count(i, 10) + slice7cost_pixels_first_0_count(i, 4) +
        slice7cost_pixels_first_0_count(i, 8) + slice7cost_pixels_first_0_count(i, 1) +
        slice7cost_pixels_first_0_count(i, 5) + slice7cost_pixels_first_0_count(i, 0) +
        slice7cost_pixels_first_0_count(i, 13);
    end loop;
    slice7cost_single_0 <= slice7cost_pixels_cost_0;
    -- slice7
    for i in 0 to 15 loop slice7_held_0(i) <= other(33 - 2 * i) / 4; end loop;
    -- entry
    entry_order_falls_any := entry_next_tag.map_column or (not slice0_tag_map_column(7)) or (not slice0_tag_valid(7));
    entry_order_falls_all := (not entry_next_tag.map_column) and slice0_tag_map_column(7) and slice0_tag_valid(7);
    entry_order_complete_all := slice0_tag_map_column(7) and slice0_tag_valid(7);
    entry_order_complete_any := (not slice0_tag_map_column(7)) or (not slice0_tag_valid(7));
    entry_order_turned_output_column_choice := choice(entry_order_falls_all, entry_order_output and
      entry_order_complete, entry_order_held_output);
    for i in 0 to 15 loop entry_next_cost(i) <= slice0_held(7, i); end loop;
    for i in 16 to 31 loop entry_next_cost(i) <= slice1_held(6, i - 16); end loop;
    for i in 32 to 47 loop entry_next_cost(i) <= slice2_held(5, i - 32); end loop;
    for i in 48 to 63 loop entry_next_cost(i) <= slice3_held(4, i - 48); end loop;
    for i in 64 to 79 loop entry_next_cost(i) <= slice4_held(3, i - 64); end loop;
    for i in 80 to 95 loop entry_next_cost(i) <= slice5_held(2, i - 80); end loop;
    for i in 96 to 111 loop entry_next_cost(i) <= slice6_held(1, i - 96); end loop;
    entry_next_cost(112) <= slice7_held_0(0);
    entry_next_cost(113 to 127) <= slice7_held_0(1 to 15);
    entry_next_tag.valid <= slice0_tag_valid(7);
    entry_next_tag.first_cost <= slice0_tag_first_cost(7);
    entry_next_tag.end_of_line <= slice0_tag_end_of_line(7);
    entry_order_inside <= slice0_tag_map_column(7);
    entry_order_turned_output_column <= entry_order_turned_output_column_choice and slice0_tag_map_column(7);
    entry_order_turned_first_column <= entry_order_falls_all;
    entry_order_turned_start_of_frame <= (not entry_next_tag.map_column) and slice0_tag_map_column(7) and
      slice0_tag_valid(7) and entry_order_first and entry_order_output and entry_order_complete;
    entry_cost <= entry_next_cost;
    entry_tag.valid <= entry_next_tag.valid;
    entry_tag.first_cost <= entry_next_tag.first_cost;
    entry_tag.map_column <= entry_order_inside;
    entry_tag.end_of_line <= entry_next_tag.end_of_line;
    entry_column <= entry_next_column;
    entry_top <= entry_next_top;
    entry_place <= entry_order_address;
    entry_turned_output_column <= entry_order_turned_output_column;
    entry_turned_first_column <= entry_order_turned_first_column;
    entry_turned_start_of_frame <= entry_order_turned_start_of_frame;
    entry_order_falls <= choice(entry_order_falls, entry_order_falls_any, entry_order_falls_all);
    entry_order_complete <= choice(slice0_tag_end_of_line(7), entry_order_complete or entry_order_complete_all,
      entry_order_complete and entry_order_complete_any);
    if slice0_tag_valid(7) then entry_next_tag.map_column <= slice0_tag_map_column(7); end if;
    if entry_order_complete_all then
      entry_next_column <= choice(slice0_tag_first_cost(7), 0, (entry_next_column + 1) mod 1024);
      entry_next_top <= choice(slice0_tag_first_cost(7), slice0_tag_start_of_frame(7), entry_next_top);
    end if;
    entry_order_address_choice := choice(entry_order_falls, 1023, 1);
    if not entry_order_complete_any then
      entry_order_address <= choice(entry_order_falls_any, (entry_order_address_choice + entry_order_address) mod 1024,
        as_number((not entry_order_falls)) * 512);
    end if;
    if entry_order_falls_all then
      entry_order_output <= slice0_tag_output_column(7);
      entry_order_first <= slice0_tag_start_of_frame(7);
      entry_order_held_output <= entry_order_output and entry_order_complete;
    end if;
    -- forward
    for i in 0 to 31 loop
      forward_left_pair_choice(2 * i) := smaller(forward_left_cost(4 * i + 2), forward_left_cost(4 * i));
      forward_left_pair_choice(2 * i + 1) := smaller(forward_left_cost(4 * i + 3), forward_left_cost(4 * i + 1));
    end loop;
    forward_left_start_cost_0_value := (((forward_left_tree_next_next_next_next_next_smallest_0 mod 32) +
      forward_left_room) / 32) = 1;
    forward_left_start_cost_0_choices(1) := choice(forward_left_start_cost_0_value,
      (((as_number(forward_left_start_cost_0_value) + 7) mod 8) * 32) +
      ((forward_left_tree_next_next_next_next_next_smallest_0 + forward_left_room) mod 32), 0);
    forward_left_start_cost_0_choices(2) := choice(is_set(forward_left_tree_next_next_next_next_next_smallest_0, 5),
      forward_left_room, forward_left_start_cost_0_choices(1));
    forward_left_room_choices(1) := choice(forward_left_start_cost_0_value, (0 -
      forward_left_tree_next_next_next_next_next_smallest_0) mod 32, forward_left_room);
    forward_left_room_choices(2) := choice(is_set(forward_left_tree_next_next_next_next_next_smallest_0, 5), 0,
      forward_left_room_choices(1));
    forward_left_g_copy_0_value := (forward_left_start_cost(0) + forward_smallest_cost(0)) mod 64;
    forward_left_g_less_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest_less) mod 64;
    for i in 0 to 127 loop
      forward_left_cost_choice(i, 1) := smaller(forward_left_arrived(i), forward_left_cost(i));
      forward_left_cost_choice(i, 2) := choice(is_set(forward_left_cost_choice(i, 1), 5) or forward_left_first(2), 32,
        forward_left_cost_choice(i, 1));
    end loop;
    forward_left_arrived_choice(0, 1) := choice(forward_left_first(2), 32, forward_left_cost(1));
    for i in 0 to 30 loop
      forward_left_arrived_choice(4 * i + 1, 1) := choice(forward_left_first(2), 32, forward_left_pair_choice(2 * i));
      forward_left_arrived_choice(4 * i + 2, 1) := choice(forward_left_first(2), 32, forward_left_pair_choice(2 * i +
        1));
      forward_left_arrived_choice(4 * i + 3, 1) := smaller(forward_left_cost(4 * i + 4), forward_left_cost(4 * i + 2));
      forward_left_arrived_choice(4 * i + 3, 2) := choice(forward_left_first(2), 32, forward_left_arrived_choice(4 * i
        + 3, 1));
      forward_left_arrived_choice(4 * i + 4, 1) := smaller(forward_left_cost(4 * i + 5), forward_left_cost(4 * i + 3));
      forward_left_arrived_choice(4 * i + 4, 2) := choice(forward_left_first(2), 32, forward_left_arrived_choice(4 * i
        + 4, 1));
    end loop;
    forward_left_arrived_choice(125, 1) := choice(forward_left_first(2), 32, forward_left_pair_choice(62));
    forward_left_arrived_choice(126, 1) := choice(forward_left_first(2), 32, forward_left_pair_choice(63));
    forward_left_arrived_choice(127, 1) := choice(forward_left_first(2), 32, forward_left_cost(126));
    for i in 0 to 9 loop
      for j in 0 to 5 loop
        forward_above_total_choice(12 * i + j) := choice(forward_above_ready_top, 24,
          to_integer(forward_above_ready_words(2 * i)(5 * j + 4 downto 5 * j)));
      end loop;
      for j in 6 to 11 loop
        forward_above_total_choice(12 * i + j) := choice(forward_above_ready_top, 24,
          to_integer(forward_above_ready_words(2 * i + 1)(5 * j - 26 downto 5 * j - 30)));
      end loop;
    end loop;
    for i in 120 to 125 loop
      forward_above_total_choice(i) := choice(forward_above_ready_top, 24, to_integer(forward_above_ready_words(20)(5 *
        i - 596 downto 5 * i - 600)));
    end loop;
    forward_above_total_choice(126) := choice(forward_above_ready_top, 24, forward_above_ready_words_21 mod 32);
    forward_above_total_choice(127) := choice(forward_above_ready_top, 24, (forward_above_ready_words_21 / 32) mod 32);
    if entry_tag.valid then
      forward_cost_delay_ring_write_address <= forward_cost_delay_ring_read_address;
      forward_left_pair <= forward_left_pair_choice;
      forward_left_smallest <= forward_smallest_next_next_next_next_next_next_smallest_0;
      forward_left_smallest_less <= ((((forward_smallest_next_next_next_next_next_next_smallest_0 / 4) + 15) mod 16) *
        4) + (forward_smallest_next_next_next_next_next_next_smallest_0 mod 4);
      forward_left_first(0) <= forward_first(6);
      forward_left_first(1 to 2) <= forward_left_first(0 to 1);
      for i in 0 to 7 loop forward_left_g_copy(i) <= forward_left_g_copy_0_value; end loop;
      for i in 0 to 7 loop forward_left_g_less_copy(i) <= forward_left_g_less_copy_0_value; end loop;
      for i in 0 to 3 loop
        for j in 0 to 15 loop
          forward_left_stay_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_copy(2 * i)) mod 64;
        end loop;
        for j in 16 to 31 loop
          forward_left_stay_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_copy(2 * i + 1)) mod 64;
        end loop;
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 15 loop
          forward_left_step_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_less_copy(2 * i)) mod
            64;
        end loop;
        for j in 16 to 31 loop
          forward_left_step_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_less_copy(2 * i + 1))
            mod 64;
        end loop;
      end loop;
      for i in 0 to 127 loop
        forward_left_cost(i) <= (forward_left_cost_choice(i, 2) + forward_left_stay_change(i)) mod 64;
      end loop;
      for i in 0 to 2 loop
        forward_left_arrived(i) <= (forward_left_arrived_choice(i, 1) + forward_left_step_change(i)) mod 64;
      end loop;
      for i in 0 to 29 loop
        forward_left_arrived(4 * i + 3) <= (forward_left_arrived_choice(4 * i + 3, 2) + forward_left_step_change(4 * i
          + 3)) mod 64;
        forward_left_arrived(4 * i + 4) <= (forward_left_arrived_choice(4 * i + 4, 2) + forward_left_step_change(4 * i
          + 4)) mod 64;
        forward_left_arrived(4 * i + 5) <= (forward_left_arrived_choice(4 * i + 5, 1) + forward_left_step_change(4 * i
          + 5)) mod 64;
        forward_left_arrived(4 * i + 6) <= (forward_left_arrived_choice(4 * i + 6, 1) + forward_left_step_change(4 * i
          + 6)) mod 64;
      end loop;
      forward_left_arrived(123) <= (forward_left_arrived_choice(123, 2) + forward_left_step_change(123)) mod 64;
      forward_left_arrived(124) <= (forward_left_arrived_choice(124, 2) + forward_left_step_change(124)) mod 64;
      for i in 125 to 127 loop
        forward_left_arrived(i) <= (forward_left_arrived_choice(i, 1) + forward_left_step_change(i)) mod 64;
      end loop;
      forward_above_ready_words <= forward_above_read_words;
      forward_above_ready_words_21 <= to_integer(forward_above_read_words_21);
      forward_above_ready_cost <= entry_cost;
      forward_above_ready_top <= entry_top;
      for i in 0 to 127 loop
        forward_above_total(i) <= forward_above_total_choice(i) + forward_above_ready_cost(i);
      end loop;
      forward_above_delay_ring_write_address <= forward_above_delay_ring_read_address;
      for i in 0 to 7 loop
        forward_above_smallest_copy(i) <= forward_above_tree_next_next_next_next_next_next_smallest_0;
      end loop;
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
      forward_above_cost(47) <= (to_integer(forward_above_delay_held(9)(29 downto 12)) -
        forward_above_smallest_copy(2)) mod 64;
      for i in 9 to 11 loop
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(5 * i + 5) <= (to_integer(forward_above_delay_held(i + 1)) - forward_above_smallest_copy(3))
          mod 64;
        forward_above_cost(5 * i + 6) <= (to_integer(forward_above_delay_held(i + 1)(29 downto 6)) -
          forward_above_smallest_copy(3)) mod 64;
        forward_above_cost(5 * i + 7) <= (to_integer(forward_above_delay_held(i + 1)(29 downto 12)) -
          forward_above_smallest_copy(3)) mod 64;
      end loop;
      forward_above_cost(63) <= (to_integer(forward_above_delay_held(12)(29 downto 18)) -
        forward_above_smallest_copy(3)) mod 64;
      for i in 12 to 14 loop
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(4)) mod 64;
        forward_above_cost(5 * i + 5) <= (to_integer(forward_above_delay_held(i + 1)) - forward_above_smallest_copy(4))
          mod 64;
        forward_above_cost(5 * i + 6) <= (to_integer(forward_above_delay_held(i + 1)(29 downto 6)) -
          forward_above_smallest_copy(4)) mod 64;
        forward_above_cost(5 * i + 7) <= (to_integer(forward_above_delay_held(i + 1)(29 downto 12)) -
          forward_above_smallest_copy(4)) mod 64;
        forward_above_cost(5 * i + 8) <= (to_integer(forward_above_delay_held(i + 1)(29 downto 18)) -
          forward_above_smallest_copy(4)) mod 64;
      end loop;
      forward_above_cost(79) <= (to_integer(forward_above_delay_held(15)(29 downto 24)) -
        forward_above_smallest_copy(4)) mod 64;
      for i in 16 to 18 loop
        forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(5)) mod 64;
        forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
          forward_above_smallest_copy(5)) mod 64;
        forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
          forward_above_smallest_copy(5)) mod 64;
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy(5)) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(5)) mod 64;
      end loop;
      forward_above_cost(95) <= (to_integer(forward_above_delay_held(19)) - forward_above_smallest_copy(5)) mod 64;
      for i in 19 to 21 loop
        forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
          forward_above_smallest_copy(6)) mod 64;
        forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
          forward_above_smallest_copy(6)) mod 64;
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy(6)) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(6)) mod 64;
        forward_above_cost(5 * i + 5) <= (to_integer(forward_above_delay_held(i + 1)) - forward_above_smallest_copy(6))
          mod 64;
      end loop;
      for i in 22 to 23 loop
        forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
          forward_above_smallest_copy(i - 16)) mod 64;
        forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
          forward_above_smallest_copy(7)) mod 64;
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy(7)) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy(7)) mod 64;
        forward_above_cost(5 * i + 5) <= (to_integer(forward_above_delay_held(i + 1)) - forward_above_smallest_copy(7))
          mod 64;
      end loop;
      forward_above_cost(121) <= (to_integer(forward_above_delay_held(24)(29 downto 6)) -
        forward_above_smallest_copy(7)) mod 64;
      forward_above_cost(122) <= (to_integer(forward_above_delay_held(24)(29 downto 12)) -
        forward_above_smallest_copy(7)) mod 64;
      forward_above_cost(123) <= (to_integer(forward_above_delay_held(24)(29 downto 18)) -
        forward_above_smallest_copy(7)) mod 64;
      forward_above_cost(124) <= (to_integer(forward_above_delay_held(24)(29 downto 24)) -
        forward_above_smallest_copy(7)) mod 64;
      forward_above_cost(125) <= (to_integer(forward_above_delay_held_25) - forward_above_smallest_copy(7)) mod 64;
      forward_above_cost(126) <= (to_integer(forward_above_delay_held_25(17 downto 6)) -
        forward_above_smallest_copy(7)) mod 64;
      forward_above_cost(127) <= (to_integer(forward_above_delay_held_25(17 downto 12)) -
        forward_above_smallest_copy(7)) mod 64;
      forward_above_beside(0) <= forward_above_cost(1);
      forward_above_beside(127) <= forward_above_cost(126);
      forward_above_own_0 <= forward_above_cost(0);
      forward_above_own <= forward_above_cost(2 to 125);
      forward_above_own_127 <= forward_above_cost(127);
      for i in 0 to 127 loop
        forward_above_step(i) <= (((forward_above_beside(i) / 4) + 1) * 4) + (forward_above_beside(i) mod 4);
      end loop;
      forward_above_comes(0) <= entry_tag.map_column;
      forward_above_comes(1 to 12) <= forward_above_comes(0 to 11);
      forward_above_column(0) <= entry_column;
      forward_above_column(1 to 12) <= forward_above_column(0 to 11);
      for i in 0 to 127 loop forward_sum(i) <= forward_left_cost(i) + forward_above_cost(i); end loop;
      forward_first(0) <= entry_turned_first_column;
      forward_first(1 to 3) <= forward_first(0 to 2);
      forward_first(4) <= sums_right_first(2);
      forward_first(5 to 6) <= forward_first(4 to 5);
      for i in 0 to 15 loop
        forward_cost(0, 8 * i) <= to_integer(forward_cost_delay_held(i)(3 downto 0));
        forward_cost(0, 8 * i + 1) <= to_integer(forward_cost_delay_held(i)(7 downto 0)) / 16;
        for j in 2 to 7 loop
          forward_cost(0, 8 * i + j) <= to_integer(forward_cost_delay_held(i)(4 * j + 3 downto 4 * j));
        end loop;
      end loop;
      for i in 1 to 3 loop
        for j in 0 to 127 loop forward_cost(i, j) <= forward_cost(i - 1, j); end loop;
      end loop;
      forward_smallest_cost(0) <= forward_smallest_next_next_next_next_next_next_smallest_0;
      forward_smallest_cost(1) <= forward_left_smallest;
      forward_smallest_cost(2 to 4) <= forward_smallest_cost(1 to 3);
      for i in 0 to 63 loop forward_smallest_smallest(i) <= smaller(entry_cost(2 * i + 1), entry_cost(2 * i)); end loop;
      for i in 0 to 31 loop
        forward_smallest_next_smallest(i) <= smaller(forward_smallest_smallest(2 * i + 1), forward_smallest_smallest(2
          * i));
      end loop;
      for i in 0 to 15 loop
        forward_smallest_next_next_smallest(i) <= smaller(forward_smallest_next_smallest(2 * i + 1),
          forward_smallest_next_smallest(2 * i));
      end loop;
      for i in 0 to 7 loop
        forward_smallest_next_next_next_smallest(i) <= smaller(forward_smallest_next_next_smallest(2 * i + 1),
          forward_smallest_next_next_smallest(2 * i));
      end loop;
      for i in 0 to 3 loop
        forward_smallest_next_next_next_next_smallest(i) <= smaller(forward_smallest_next_next_next_smallest(2 * i +
          1), forward_smallest_next_next_next_smallest(2 * i));
      end loop;
      forward_smallest_next_next_next_next_next_smallest(0) <=
        smaller(forward_smallest_next_next_next_next_smallest(1), forward_smallest_next_next_next_next_smallest(0));
      forward_smallest_next_next_next_next_next_smallest(1) <=
        smaller(forward_smallest_next_next_next_next_smallest(3), forward_smallest_next_next_next_next_smallest(2));
      forward_smallest_next_next_next_next_next_next_smallest_0 <=
        smaller(forward_smallest_next_next_next_next_next_smallest(1),
        forward_smallest_next_next_next_next_next_smallest(0));
      forward_cost_delay_ring_read_address <= choice(forward_cost_delay_ring_read_address = 7, 0,
        (forward_cost_delay_ring_read_address + 1) mod 8);
      for i in 0 to 31 loop
        forward_left_tree_smallest(i) <= smaller(forward_left_pair(2 * i + 1), forward_left_pair(2 * i));
      end loop;
      for i in 0 to 15 loop
        forward_left_tree_next_smallest(i) <= smaller(forward_left_tree_smallest(2 * i + 1),
          forward_left_tree_smallest(2 * i));
      end loop;
      for i in 0 to 7 loop
        forward_left_tree_next_next_smallest(i) <= smaller(forward_left_tree_next_smallest(2 * i + 1),
          forward_left_tree_next_smallest(2 * i));
      end loop;
      for i in 0 to 3 loop
        forward_left_tree_next_next_next_smallest(i) <= smaller(forward_left_tree_next_next_smallest(2 * i + 1),
          forward_left_tree_next_next_smallest(2 * i));
      end loop;
      forward_left_tree_next_next_next_next_smallest(0) <= smaller(forward_left_tree_next_next_next_smallest(1),
        forward_left_tree_next_next_next_smallest(0));
      forward_left_tree_next_next_next_next_smallest(1) <= smaller(forward_left_tree_next_next_next_smallest(3),
        forward_left_tree_next_next_next_smallest(2));
      forward_left_tree_next_next_next_next_next_smallest_0 <=
        smaller(forward_left_tree_next_next_next_next_smallest(1), forward_left_tree_next_next_next_next_smallest(0));
      forward_left_start_cost(0) <= choice(forward_first(6), 24, forward_left_start_cost_0_choices(2));
      for i in 1 to 9 loop
        forward_left_start_cost(i) <= choice(forward_first(6), 0, forward_left_start_cost(i - 1));
      end loop;
      forward_left_room <= choice(forward_first(6), 0, (forward_left_room_choices(2) + forward_left_start_cost(9)) mod
        32);
      for i in 0 to 63 loop
        forward_above_tree_smallest(i) <= smaller(forward_above_total(2 * i + 1), forward_above_total(2 * i));
      end loop;
      for i in 0 to 31 loop
        forward_above_tree_next_smallest(i) <= smaller(forward_above_tree_smallest(2 * i + 1),
          forward_above_tree_smallest(2 * i));
      end loop;
      for i in 0 to 15 loop
        forward_above_tree_next_next_smallest(i) <= smaller(forward_above_tree_next_smallest(2 * i + 1),
          forward_above_tree_next_smallest(2 * i));
      end loop;
      for i in 0 to 7 loop
        forward_above_tree_next_next_next_smallest(i) <= smaller(forward_above_tree_next_next_smallest(2 * i + 1),
          forward_above_tree_next_next_smallest(2 * i));
      end loop;
      for i in 0 to 3 loop
        forward_above_tree_next_next_next_next_smallest(i) <= smaller(forward_above_tree_next_next_next_smallest(2 * i
          + 1), forward_above_tree_next_next_next_smallest(2 * i));
      end loop;
      forward_above_tree_next_next_next_next_next_smallest(0) <=
        smaller(forward_above_tree_next_next_next_next_smallest(1), forward_above_tree_next_next_next_next_smallest(0));
      forward_above_tree_next_next_next_next_next_smallest(1) <=
        smaller(forward_above_tree_next_next_next_next_smallest(3), forward_above_tree_next_next_next_next_smallest(2));
      forward_above_tree_next_next_next_next_next_next_smallest_0 <=
        smaller(forward_above_tree_next_next_next_next_next_smallest(1),
        forward_above_tree_next_next_next_next_next_smallest(0));
      forward_above_delay_ring_read_address <= choice(forward_above_delay_ring_read_address = 7, 0,
        (forward_above_delay_ring_read_address + 1) mod 8);
      for i in 1 to 126 loop
        forward_above_beside(i) <= smaller(forward_above_cost(i + 1), forward_above_cost(i - 1));
      end loop;
      forward_above_stay(0) <= choice(forward_above_own_0 < 24, forward_above_own_0 mod 32, 24);
      forward_above_stay(1) <= choice(forward_above_beside(0) < 24, forward_above_beside(0) mod 32, 24);
      for i in 2 to 125 loop
        forward_above_stay(i) <= choice(forward_above_own(i) < 24, forward_above_own(i) mod 32, 24);
      end loop;
      forward_above_stay(126) <= choice(forward_above_beside(127) < 24, forward_above_beside(127) mod 32, 24);
      forward_above_stay(127) <= choice(forward_above_own_127 < 24, forward_above_own_127 mod 32, 24);
    end if;
    forward_above_writes_copy_0 <= choice(forward_above_comes(12), entry_next_tag.valid and (forward_above_comes(11) or
      (not entry_tag.valid)), entry_next_tag.valid and forward_above_comes(11) and entry_tag.valid);
    for i in 0 to 20 loop
      forward_above_write_words_choice(i, 1) := smaller(forward_above_step(6 * i + 4), forward_above_stay(6 * i + 4));
      forward_above_write_words_choice(i, 2) := smaller(forward_above_step(6 * i + 5), forward_above_stay(6 * i + 5));
      forward_above_write_words_choice(i, 3) := smaller(forward_above_step(6 * i + 3), forward_above_stay(6 * i + 3));
      forward_above_write_words_choice(i, 4) := smaller(forward_above_step(6 * i + 2), forward_above_stay(6 * i + 2));
      forward_above_write_words_choice(i, 5) := smaller(forward_above_step(6 * i), forward_above_stay(6 * i));
      forward_above_write_words_choice(i, 6) := smaller(forward_above_step(6 * i + 1), forward_above_stay(6 * i + 1));
    end loop;
    forward_above_write_words_choice(21, 1) := smaller(forward_above_step(127), forward_above_stay(127));
    forward_above_write_words_choice(21, 2) := smaller(forward_above_step(126), forward_above_stay(126));
    if forward_above_writes_copy_0 then
      for i in 0 to 20 loop
        forward_above_write_words(i) <= ((((((((((to_unsigned(forward_above_write_words_choice(i, 1), 12) &
          to_unsigned(0, 20)) or (to_unsigned(forward_above_write_words_choice(i, 2), 7) & to_unsigned(0, 25)))) or
          (to_unsigned(forward_above_write_words_choice(i, 3), 17) & to_unsigned(0, 15)))) or
          (to_unsigned(forward_above_write_words_choice(i, 4), 22) & to_unsigned(0, 10)))) or
          (to_unsigned(forward_above_write_words_choice(i, 5), 32)))) or
          (to_unsigned(forward_above_write_words_choice(i, 6), 27) & to_unsigned(0, 5)));
      end loop;
      forward_above_write_words_21 <= to_integer(((to_unsigned(forward_above_write_words_choice(21, 1), 7) &
        to_unsigned(0, 5)) or (to_unsigned(forward_above_write_words_choice(21, 2), 12))));
      forward_above_write_column <= forward_above_column(12);
    end if;
    -- sums
    for i in 0 to 31 loop
      sums_right_pair_choice(2 * i) := smaller(sums_right_cost(4 * i + 2), sums_right_cost(4 * i));
      sums_right_pair_choice(2 * i + 1) := smaller(sums_right_cost(4 * i + 3), sums_right_cost(4 * i + 1));
    end loop;
    sums_right_start_cost_0_value := (((sums_right_tree_next_next_next_next_next_smallest_0 mod 32) + sums_right_room)
      / 32) = 1;
    sums_right_start_cost_0_choices(1) := choice(sums_right_start_cost_0_value,
      (((as_number(sums_right_start_cost_0_value) + 7) mod 8) * 32) +
      ((sums_right_tree_next_next_next_next_next_smallest_0 + sums_right_room) mod 32), 0);
    sums_right_start_cost_0_choices(2) := choice(is_set(sums_right_tree_next_next_next_next_next_smallest_0, 5),
      sums_right_room, sums_right_start_cost_0_choices(1));
    sums_right_room_choices(1) := choice(sums_right_start_cost_0_value, (0 -
      sums_right_tree_next_next_next_next_next_smallest_0) mod 32, sums_right_room);
    sums_right_room_choices(2) := choice(is_set(sums_right_tree_next_next_next_next_next_smallest_0, 5), 0,
      sums_right_room_choices(1));
    sums_right_g_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest) mod 64;
    sums_right_g_less_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest_less) mod 64;
    for i in 0 to 127 loop
      sums_right_cost_choice(i, 1) := smaller(sums_right_arrived(i), sums_right_cost(i));
      sums_right_cost_choice(i, 2) := choice(is_set(sums_right_cost_choice(i, 1), 5) or forward_first(3), 32,
        sums_right_cost_choice(i, 1));
    end loop;
    sums_right_arrived_choice(0, 1) := choice(forward_first(3), 32, sums_right_cost(1));
    for i in 0 to 30 loop
      sums_right_arrived_choice(4 * i + 1, 1) := choice(forward_first(3), 32, sums_right_pair_choice(2 * i));
      sums_right_arrived_choice(4 * i + 2, 1) := choice(forward_first(3), 32, sums_right_pair_choice(2 * i + 1));
      sums_right_arrived_choice(4 * i + 3, 1) := smaller(sums_right_cost(4 * i + 4), sums_right_cost(4 * i + 2));
      sums_right_arrived_choice(4 * i + 3, 2) := choice(forward_first(3), 32, sums_right_arrived_choice(4 * i + 3, 1));
      sums_right_arrived_choice(4 * i + 4, 1) := smaller(sums_right_cost(4 * i + 5), sums_right_cost(4 * i + 3));
      sums_right_arrived_choice(4 * i + 4, 2) := choice(forward_first(3), 32, sums_right_arrived_choice(4 * i + 4, 1));
    end loop;
    sums_right_arrived_choice(125, 1) := choice(forward_first(3), 32, sums_right_pair_choice(62));
    sums_right_arrived_choice(126, 1) := choice(forward_first(3), 32, sums_right_pair_choice(63));
    sums_right_arrived_choice(127, 1) := choice(forward_first(3), 32, sums_right_cost(126));
    if entry_tag.valid then
      for i in 0 to 31 loop sums_turn_ready_sums(i) <= to_integer(sums_turn_read_sums(i)); end loop;
      sums_turn_ready_costs <= sums_turn_read_costs;
      sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
      sums_turn_ready_first <= entry_tag.first_cost;
      sums_turn_place(0) <= entry_place;
      sums_turn_place(1 to 11) <= sums_turn_place(0 to 10);
      for i in 0 to 15 loop
        sums_cost(0, 8 * i) <= to_integer(sums_turn_ready_costs(i)(3 downto 0));
        sums_cost(0, 8 * i + 1) <= to_integer(sums_turn_ready_costs(i)(7 downto 0)) / 16;
        for j in 2 to 7 loop
          sums_cost(0, 8 * i + j) <= to_integer(sums_turn_ready_costs(i)(4 * j + 3 downto 4 * j));
        end loop;
      end loop;
      for i in 0 to 127 loop sums_cost(1, i) <= sums_cost(0, i); end loop;
      sums_right_pair <= sums_right_pair_choice;
      sums_right_smallest <= sums_turn_ready_smallest_0;
      sums_right_smallest_less <= ((((sums_turn_ready_smallest_0 / 4) + 15) mod 16) * 4) + (sums_turn_ready_smallest_0
        mod 4);
      sums_right_first(0) <= sums_turn_ready_first;
      sums_right_first(1 to 2) <= sums_right_first(0 to 1);
      for i in 0 to 7 loop sums_right_g_copy(i) <= sums_right_g_copy_0_value; end loop;
      for i in 0 to 7 loop sums_right_g_less_copy(i) <= sums_right_g_less_copy_0_value; end loop;
      for i in 0 to 3 loop
        for j in 0 to 15 loop
          sums_right_stay_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_copy(2 * i)) mod 64;
        end loop;
        for j in 16 to 31 loop
          sums_right_stay_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_copy(2 * i + 1)) mod 64;
        end loop;
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 15 loop
          sums_right_step_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_less_copy(2 * i)) mod 64;
        end loop;
        for j in 16 to 31 loop
          sums_right_step_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_less_copy(2 * i + 1)) mod 64;
        end loop;
      end loop;
      for i in 0 to 127 loop
        sums_right_cost(i) <= (sums_right_cost_choice(i, 2) + sums_right_stay_change(i)) mod 64;
      end loop;
      sums_right_arrived(0) <= (sums_right_arrived_choice(0, 1) + sums_right_step_change(0)) mod 64;
      for i in 0 to 30 loop
        sums_right_arrived(4 * i + 1) <= (sums_right_arrived_choice(4 * i + 1, 1) + sums_right_step_change(4 * i + 1))
          mod 64;
        sums_right_arrived(4 * i + 2) <= (sums_right_arrived_choice(4 * i + 2, 1) + sums_right_step_change(4 * i + 2))
          mod 64;
        sums_right_arrived(4 * i + 3) <= (sums_right_arrived_choice(4 * i + 3, 2) + sums_right_step_change(4 * i + 3))
          mod 64;
        sums_right_arrived(4 * i + 4) <= (sums_right_arrived_choice(4 * i + 4, 2) + sums_right_step_change(4 * i + 4))
          mod 64;
      end loop;
      for i in 125 to 127 loop
        sums_right_arrived(i) <= (sums_right_arrived_choice(i, 1) + sums_right_step_change(i)) mod 64;
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
      for i in 0 to 31 loop
        sums_right_tree_smallest(i) <= smaller(sums_right_pair(2 * i + 1), sums_right_pair(2 * i));
      end loop;
      for i in 0 to 15 loop
        sums_right_tree_next_smallest(i) <= smaller(sums_right_tree_smallest(2 * i + 1), sums_right_tree_smallest(2 *
          i));
      end loop;
      for i in 0 to 7 loop
        sums_right_tree_next_next_smallest(i) <= smaller(sums_right_tree_next_smallest(2 * i + 1),
          sums_right_tree_next_smallest(2 * i));
      end loop;
      for i in 0 to 3 loop
        sums_right_tree_next_next_next_smallest(i) <= smaller(sums_right_tree_next_next_smallest(2 * i + 1),
          sums_right_tree_next_next_smallest(2 * i));
      end loop;
      sums_right_tree_next_next_next_next_smallest(0) <= smaller(sums_right_tree_next_next_next_smallest(1),
        sums_right_tree_next_next_next_smallest(0));
      sums_right_tree_next_next_next_next_smallest(1) <= smaller(sums_right_tree_next_next_next_smallest(3),
        sums_right_tree_next_next_next_smallest(2));
      sums_right_tree_next_next_next_next_next_smallest_0 <= smaller(sums_right_tree_next_next_next_next_smallest(1),
        sums_right_tree_next_next_next_next_smallest(0));
      sums_right_start_cost(0) <= choice(forward_first(0), 24, sums_right_start_cost_0_choices(2));
      for i in 1 to 9 loop
        sums_right_start_cost(i) <= choice(forward_first(0), 0, sums_right_start_cost(i - 1));
      end loop;
      sums_right_room <= choice(forward_first(0), 0, (sums_right_room_choices(2) + sums_right_start_cost(9)) mod 32);
      sums_sum_delay_ring_read_address <= choice(sums_sum_delay_ring_read_address = 3, 0,
        (sums_sum_delay_ring_read_address + 1) mod 4);
    end if;
    sums_turn_writes_copy_0_choice := choice(entry_tag.valid, forward_above_comes(10), forward_above_comes(11));
    sums_turn_writes_copy_0 <= entry_next_tag.valid and sums_turn_writes_copy_0_choice;
    for i in 0 to 31 loop
      sums_sum_0(4 * i) <= (sums_right_cost(4 * i) + to_integer(sums_sum_delay_held(i))) mod 128;
      sums_sum_0(4 * i + 1) <= (sums_right_cost(4 * i + 1) + to_integer(sums_sum_delay_held(i)(27 downto 7))) mod 128;
      sums_sum_0(4 * i + 2) <= (sums_right_cost(4 * i + 2) + to_integer(sums_sum_delay_held(i)(27 downto 14))) mod 128;
      sums_sum_0(4 * i + 3) <= (sums_right_cost(4 * i + 3) + to_integer(sums_sum_delay_held(i)(27 downto 21))) mod 128;
    end loop;
    sums_tag.valid <= sums_tags_moved;
    sums_tag.map_column <= forward_above_comes(4);
    sums_tag.output_column <= sums_tags_held_output_column(4);
    sums_tag.start_of_frame <= sums_tags_held_start_of_frame(4);
    sums_tag.end_of_line <= sums_tags_held_end_of_line(4);
    sums_tags_moved <= entry_tag.valid;
    if sums_turn_writes_copy_0 then
      for i in 0 to 31 loop
        sums_turn_write_sums(i) <= (forward_sum(4 * i + 2) * 16384) + (forward_sum(4 * i + 3) * 2097152) +
          forward_sum(4 * i) + (forward_sum(4 * i + 1) * 128);
      end loop;
      for i in 0 to 15 loop
        sums_turn_write_costs(i) <= to_unsigned(forward_cost(3, 8 * i + 7), 4) & to_unsigned(forward_cost(3, 8 * i +
          6), 4) & to_unsigned(forward_cost(3, 8 * i + 5), 4) & to_unsigned(forward_cost(3, 8 * i + 4), 4) &
          to_unsigned(forward_cost(3, 8 * i + 3), 4) & to_unsigned(forward_cost(3, 8 * i + 2), 4) &
          to_unsigned(forward_cost(3, 8 * i + 1), 4) & to_unsigned(forward_cost(3, 8 * i), 4);
      end loop;
      sums_turn_write_smallest_0 <= forward_smallest_cost(4);
      sums_turn_write_place <= sums_turn_place(11);
    end if;
    -- winnerswinner1
    for i in 0 to 63 loop
      winnerswinner1_of_pair_0_value(i, 1) := is_set(sums_sum_0(2 * i + 1), 2);
      winnerswinner1_of_pair_0_value(i, 2) := is_set(sums_sum_0(2 * i + 1), 3);
      winnerswinner1_of_pair_0_value(i, 3) := is_set(sums_sum_0(2 * i + 1), 4);
      winnerswinner1_of_pair_0_value(i, 4) := is_set(sums_sum_0(2 * i + 1), 5);
      winnerswinner1_of_pair_0_choice_7(i) := is_larger(sums_sum_0(2 * i), sums_sum_0(2 * i + 1), 0, 6, false);
    end loop;
    for i in 0 to 31 loop
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
      for j in 3 to 5 loop
        winnerswinner1_of_four_0_value(i, 2 * j - 1) := is_set(winnerswinner1_of_pair_0(4 * i + 3), j);
        winnerswinner1_of_four_0_value(i, 2 * j) := is_set(winnerswinner1_of_pair_0(4 * i + 2), j);
        winnerswinner1_of_four_0_choice(i, j + 1) := choice(winnerswinner1_of_four_0_choice(i, j), ((not
          is_set(winnerswinner1_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner1_of_pair_0(4 * i), j))) or
          winnerswinner1_of_four_0_value(i, 2 * j - 1) or winnerswinner1_of_four_0_value(i, 2 * j), (not
          is_set(winnerswinner1_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner1_of_pair_0(4 * i), j)) and
          (winnerswinner1_of_four_0_value(i, 2 * j - 1) or winnerswinner1_of_four_0_value(i, 2 * j)));
      end loop;
      winnerswinner1_of_four_0_choice(i, 7) := choice(winnerswinner1_of_four_0_choice(i, 6), (not ((not
        is_set(winnerswinner1_of_pair_0(4 * i + 1), 6)) and (not is_set(winnerswinner1_of_pair_0(4 * i), 6)))) and (not
        is_set(winnerswinner1_of_pair_0(4 * i + 3), 6)) and (not is_set(winnerswinner1_of_pair_0(4 * i + 2), 6)), (not
        ((not is_set(winnerswinner1_of_pair_0(4 * i + 1), 6)) and (not is_set(winnerswinner1_of_pair_0(4 * i), 6)))) or
        ((not is_set(winnerswinner1_of_pair_0(4 * i + 3), 6)) and (not is_set(winnerswinner1_of_pair_0(4 * i + 2),
        6))));
    end loop;
    winnerswinner1_pair_index_0_0 <= winnerswinner1_of_pair_0_choice_7(0);
    winnerswinner1_pair_tag <= sums_tag;
    winnerswinner1_four_tag <= winnerswinner1_pair_tag;
    for i in 0 to 31 loop
      winnerswinner1_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0(4 * i + 2), 7)) or
        (to_unsigned(winnerswinner1_of_four_0(4 * i + 3), 7)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i + 1),
        7)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i), 7))));
    end loop;
    winnerswinner1_best_index_0 <= winnerswinner1_four_index_0;
    winnerswinner1_tag <= winnerswinner1_four_tag;
    winnerswinner1_of_pair_0(0) <= choice(winnerswinner1_of_pair_0_choice_7(0), 0, sums_sum_0(0));
    winnerswinner1_of_pair_0(1) <= choice(winnerswinner1_of_pair_0_choice_7(0), sums_sum_0(1), 0);
    for i in 1 to 63 loop
      winnerswinner1_of_pair_0(2 * i) <= choice(winnerswinner1_of_pair_0_choice_7(i), 0, sums_sum_0(2 * i));
      winnerswinner1_of_pair_0(2 * i + 1) <= choice(winnerswinner1_of_pair_0_choice_7(i), sums_sum_0(2 * i + 1), 0);
      winnerswinner1_pair_index_0(i) <= choice(winnerswinner1_of_pair_0_choice_7(i), 2 * i + 1, 2 * i);
    end loop;
    winnerswinner1_of_four_0(0) <= choice(winnerswinner1_of_four_0_choice(0, 7), 0, winnerswinner1_of_pair_0(0));
    winnerswinner1_of_four_0(1) <= choice(winnerswinner1_of_four_0_choice(0, 7), 0, winnerswinner1_of_pair_0(1));
    winnerswinner1_of_four_0(2) <= choice(winnerswinner1_of_four_0_choice(0, 7), winnerswinner1_of_pair_0(2), 0);
    winnerswinner1_of_four_0(3) <= choice(winnerswinner1_of_four_0_choice(0, 7), winnerswinner1_of_pair_0(3), 0);
    winnerswinner1_four_index_0(0) <= choice(winnerswinner1_of_four_0_choice(0, 7), winnerswinner1_pair_index_0(1),
      as_number(winnerswinner1_pair_index_0_0));
    for i in 1 to 31 loop
      winnerswinner1_of_four_0(4 * i) <= choice(winnerswinner1_of_four_0_choice(i, 7), 0, winnerswinner1_of_pair_0(4 *
        i));
      winnerswinner1_of_four_0(4 * i + 1) <= choice(winnerswinner1_of_four_0_choice(i, 7), 0,
        winnerswinner1_of_pair_0(4 * i + 1));
      winnerswinner1_of_four_0(4 * i + 2) <= choice(winnerswinner1_of_four_0_choice(i, 7), winnerswinner1_of_pair_0(4 *
        i + 2), 0);
      winnerswinner1_of_four_0(4 * i + 3) <= choice(winnerswinner1_of_four_0_choice(i, 7), winnerswinner1_of_pair_0(4 *
        i + 3), 0);
      winnerswinner1_four_index_0(i) <= choice(winnerswinner1_of_four_0_choice(i, 7), winnerswinner1_pair_index_0(2 * i
        + 1), winnerswinner1_pair_index_0(2 * i));
    end loop;
    -- winnerswinner2
    for i in 0 to 15 loop
      winnerswinner2_of_pair_0_value(i, 1) := is_set(winnerswinner1_best_cost_0(2 * i + 1), 2);
      winnerswinner2_of_pair_0_value(i, 2) := is_set(winnerswinner1_best_cost_0(2 * i + 1), 3);
      winnerswinner2_of_pair_0_value(i, 3) := is_set(winnerswinner1_best_cost_0(2 * i + 1), 4);
      winnerswinner2_of_pair_0_value(i, 4) := is_set(winnerswinner1_best_cost_0(2 * i + 1), 5);
      winnerswinner2_of_pair_0_choice_7(i) := is_larger(winnerswinner1_best_cost_0(2 * i), winnerswinner1_best_cost_0(2
        * i + 1), 0, 6, false);
    end loop;
    for i in 0 to 7 loop
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
      for j in 3 to 5 loop
        winnerswinner2_of_four_0_value(i, 2 * j - 1) := is_set(winnerswinner2_of_pair_0(4 * i + 3), j);
        winnerswinner2_of_four_0_value(i, 2 * j) := is_set(winnerswinner2_of_pair_0(4 * i + 2), j);
        winnerswinner2_of_four_0_choice(i, j + 1) := choice(winnerswinner2_of_four_0_choice(i, j), ((not
          is_set(winnerswinner2_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner2_of_pair_0(4 * i), j))) or
          winnerswinner2_of_four_0_value(i, 2 * j - 1) or winnerswinner2_of_four_0_value(i, 2 * j), (not
          is_set(winnerswinner2_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner2_of_pair_0(4 * i), j)) and
          (winnerswinner2_of_four_0_value(i, 2 * j - 1) or winnerswinner2_of_four_0_value(i, 2 * j)));
      end loop;
      winnerswinner2_of_four_0_choice(i, 7) := choice(winnerswinner2_of_four_0_choice(i, 6), (not ((not
        is_set(winnerswinner2_of_pair_0(4 * i + 1), 6)) and (not is_set(winnerswinner2_of_pair_0(4 * i), 6)))) and (not
        is_set(winnerswinner2_of_pair_0(4 * i + 3), 6)) and (not is_set(winnerswinner2_of_pair_0(4 * i + 2), 6)), (not
        ((not is_set(winnerswinner2_of_pair_0(4 * i + 1), 6)) and (not is_set(winnerswinner2_of_pair_0(4 * i), 6)))) or
        ((not is_set(winnerswinner2_of_pair_0(4 * i + 3), 6)) and (not is_set(winnerswinner2_of_pair_0(4 * i + 2),
        6))));
    end loop;
    winnerswinner2_pair_tag <= winnerswinner1_tag;
    winnerswinner2_four_tag <= winnerswinner2_pair_tag;
    for i in 0 to 7 loop
      winnerswinner2_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner2_of_four_0(4 * i + 2), 7)) or
        (to_unsigned(winnerswinner2_of_four_0(4 * i + 3), 7)))) or (to_unsigned(winnerswinner2_of_four_0(4 * i + 1),
        7)))) or (to_unsigned(winnerswinner2_of_four_0(4 * i), 7))));
    end loop;
    winnerswinner2_best_index_0 <= winnerswinner2_four_index_0;
    winnerswinner2_tag <= winnerswinner2_four_tag;
    for i in 0 to 15 loop
      winnerswinner2_of_pair_0(2 * i) <= choice(winnerswinner2_of_pair_0_choice_7(i), 0, winnerswinner1_best_cost_0(2 *
        i));
      winnerswinner2_of_pair_0(2 * i + 1) <= choice(winnerswinner2_of_pair_0_choice_7(i), winnerswinner1_best_cost_0(2
        * i + 1), 0);
      winnerswinner2_pair_index_0(i) <= choice(winnerswinner2_of_pair_0_choice_7(i), winnerswinner1_best_index_0(2 * i
        + 1), winnerswinner1_best_index_0(2 * i));
    end loop;
    for i in 0 to 7 loop
      winnerswinner2_of_four_0(4 * i) <= choice(winnerswinner2_of_four_0_choice(i, 7), 0, winnerswinner2_of_pair_0(4 *
        i));
      winnerswinner2_of_four_0(4 * i + 1) <= choice(winnerswinner2_of_four_0_choice(i, 7), 0,
        winnerswinner2_of_pair_0(4 * i + 1));
      winnerswinner2_of_four_0(4 * i + 2) <= choice(winnerswinner2_of_four_0_choice(i, 7), winnerswinner2_of_pair_0(4 *
        i + 2), 0);
      winnerswinner2_of_four_0(4 * i + 3) <= choice(winnerswinner2_of_four_0_choice(i, 7), winnerswinner2_of_pair_0(4 *
        i + 3), 0);
      winnerswinner2_four_index_0(i) <= choice(winnerswinner2_of_four_0_choice(i, 7), winnerswinner2_pair_index_0(2 * i
        + 1), winnerswinner2_pair_index_0(2 * i));
    end loop;
    -- winnerswinner3
    for i in 0 to 3 loop
      winnerswinner3_of_pair_0_value(i, 1) := is_set(winnerswinner2_best_cost_0(2 * i + 1), 2);
      winnerswinner3_of_pair_0_value(i, 2) := is_set(winnerswinner2_best_cost_0(2 * i + 1), 3);
      winnerswinner3_of_pair_0_value(i, 3) := is_set(winnerswinner2_best_cost_0(2 * i + 1), 4);
      winnerswinner3_of_pair_0_value(i, 4) := is_set(winnerswinner2_best_cost_0(2 * i + 1), 5);
      winnerswinner3_of_pair_0_choice_7(i) := is_larger(winnerswinner2_best_cost_0(2 * i), winnerswinner2_best_cost_0(2
        * i + 1), 0, 6, false);
    end loop;
    for i in 0 to 1 loop
      winnerswinner3_of_four_0_choice(4 * i, 1) := choice(is_set(winnerswinner3_of_pair_0(4 * i + 1), 0), (not
        is_set(winnerswinner3_of_pair_0(4 * i + 3), 0)) and (not is_set(winnerswinner3_of_pair_0(4 * i + 2), 0)),
        is_set(winnerswinner3_of_pair_0(4 * i), 0) and (not is_set(winnerswinner3_of_pair_0(4 * i + 3), 0)) and (not
        is_set(winnerswinner3_of_pair_0(4 * i + 2), 0)));
      winnerswinner3_of_four_0_value(4 * i, 1) := is_set(winnerswinner3_of_pair_0(4 * i + 1), 1);
      winnerswinner3_of_four_0_value(4 * i, 2) := is_set(winnerswinner3_of_pair_0(4 * i), 1);
      winnerswinner3_of_four_0_choice(4 * i, 2) := choice((not is_set(winnerswinner3_of_pair_0(4 * i + 3), 1)) and (not
        is_set(winnerswinner3_of_pair_0(4 * i + 2), 1)), winnerswinner3_of_four_0_choice(4 * i, 1) or
        winnerswinner3_of_four_0_value(4 * i, 1) or winnerswinner3_of_four_0_value(4 * i, 2),
        winnerswinner3_of_four_0_choice(4 * i, 1) and (winnerswinner3_of_four_0_value(4 * i, 1) or
        winnerswinner3_of_four_0_value(4 * i, 2)));
      winnerswinner3_of_four_0_value(4 * i, 3) := is_set(winnerswinner3_of_pair_0(4 * i + 3), 2);
      winnerswinner3_of_four_0_value(4 * i, 4) := is_set(winnerswinner3_of_pair_0(4 * i + 2), 2);
      winnerswinner3_of_four_0_choice(4 * i, 3) := choice(winnerswinner3_of_four_0_choice(4 * i, 2), (not
        is_set(winnerswinner3_of_pair_0(4 * i + 1), 2)) and (not is_set(winnerswinner3_of_pair_0(4 * i), 2)) and
        (winnerswinner3_of_four_0_value(4 * i, 3) or winnerswinner3_of_four_0_value(4 * i, 4)), ((not
        is_set(winnerswinner3_of_pair_0(4 * i + 1), 2)) and (not is_set(winnerswinner3_of_pair_0(4 * i), 2))) or
        winnerswinner3_of_four_0_value(4 * i, 3) or winnerswinner3_of_four_0_value(4 * i, 4));
      for j in 3 to 5 loop
        winnerswinner3_of_four_0_value(4 * i, 2 * j - 1) := is_set(winnerswinner3_of_pair_0(4 * i + 3), j);
        winnerswinner3_of_four_0_value(4 * i, 2 * j) := is_set(winnerswinner3_of_pair_0(4 * i + 2), j);
        winnerswinner3_of_four_0_choice(4 * i, j + 1) := choice(winnerswinner3_of_four_0_choice(4 * i, j), ((not
          is_set(winnerswinner3_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner3_of_pair_0(4 * i), j))) or
          winnerswinner3_of_four_0_value(4 * i, 2 * j - 1) or winnerswinner3_of_four_0_value(4 * i, 2 * j), (not
          is_set(winnerswinner3_of_pair_0(4 * i + 1), j)) and (not is_set(winnerswinner3_of_pair_0(4 * i), j)) and
          (winnerswinner3_of_four_0_value(4 * i, 2 * j - 1) or winnerswinner3_of_four_0_value(4 * i, 2 * j)));
      end loop;
      winnerswinner3_of_four_0_choice(4 * i, 7) := choice(winnerswinner3_of_four_0_choice(4 * i, 6), (not ((not
        is_set(winnerswinner3_of_pair_0(4 * i + 1), 6)) and (not is_set(winnerswinner3_of_pair_0(4 * i), 6)))) and (not
        is_set(winnerswinner3_of_pair_0(4 * i + 3), 6)) and (not is_set(winnerswinner3_of_pair_0(4 * i + 2), 6)), (not
        ((not is_set(winnerswinner3_of_pair_0(4 * i + 1), 6)) and (not is_set(winnerswinner3_of_pair_0(4 * i), 6)))) or
        ((not is_set(winnerswinner3_of_pair_0(4 * i + 3), 6)) and (not is_set(winnerswinner3_of_pair_0(4 * i + 2),
        6))));
    end loop;
    winnerswinner3_pair_tag <= winnerswinner2_tag;
    winnerswinner3_four_tag <= winnerswinner3_pair_tag;
    winnerswinner3_best_cost_0(0) <= to_integer(((((((to_unsigned(winnerswinner3_of_four_0(2), 7)) or
      (to_unsigned(winnerswinner3_of_four_0(3), 7)))) or (to_unsigned(winnerswinner3_of_four_0(1), 7)))) or
      (to_unsigned(winnerswinner3_of_four_0(0), 7))));
    winnerswinner3_best_cost_0(1) <= to_integer(((((((to_unsigned(winnerswinner3_of_four_0(6), 7)) or
      (to_unsigned(winnerswinner3_of_four_0(7), 7)))) or (to_unsigned(winnerswinner3_of_four_0(5), 7)))) or
      (to_unsigned(winnerswinner3_of_four_0(4), 7))));
    winnerswinner3_best_index_0 <= winnerswinner3_four_index_0;
    winnerswinner3_tag <= winnerswinner3_four_tag;
    for i in 0 to 3 loop
      winnerswinner3_of_pair_0(2 * i) <= choice(winnerswinner3_of_pair_0_choice_7(i), 0, winnerswinner2_best_cost_0(2 *
        i));
      winnerswinner3_of_pair_0(2 * i + 1) <= choice(winnerswinner3_of_pair_0_choice_7(i), winnerswinner2_best_cost_0(2
        * i + 1), 0);
      winnerswinner3_pair_index_0(i) <= choice(winnerswinner3_of_pair_0_choice_7(i), winnerswinner2_best_index_0(2 * i
        + 1), winnerswinner2_best_index_0(2 * i));
    end loop;
    for i in 0 to 1 loop
      winnerswinner3_of_four_0(4 * i) <= choice(winnerswinner3_of_four_0_choice(4 * i, 7), 0,
        winnerswinner3_of_pair_0(4 * i));
      winnerswinner3_of_four_0(4 * i + 1) <= choice(winnerswinner3_of_four_0_choice(4 * i, 7), 0,
        winnerswinner3_of_pair_0(4 * i + 1));
      winnerswinner3_of_four_0(4 * i + 2) <= choice(winnerswinner3_of_four_0_choice(4 * i, 7),
        winnerswinner3_of_pair_0(4 * i + 2), 0);
      winnerswinner3_of_four_0(4 * i + 3) <= choice(winnerswinner3_of_four_0_choice(4 * i, 7),
        winnerswinner3_of_pair_0(4 * i + 3), 0);
      winnerswinner3_four_index_0(i) <= choice(winnerswinner3_of_four_0_choice(4 * i, 7), winnerswinner3_pair_index_0(2
        * i + 1), winnerswinner3_pair_index_0(2 * i));
    end loop;
    -- winnerswinner4
    winnerswinner4_best_index_0_0_values(1) := is_set(winnerswinner3_best_cost_0(1), 2);
    winnerswinner4_best_index_0_0_values(2) := is_set(winnerswinner3_best_cost_0(1), 3);
    winnerswinner4_best_index_0_0_values(3) := is_set(winnerswinner3_best_cost_0(1), 4);
    winnerswinner4_best_index_0_0_values(4) := is_set(winnerswinner3_best_cost_0(1), 5);
    winnerswinner4_best_index_0_0_choice_7 := is_larger(winnerswinner3_best_cost_0(0), winnerswinner3_best_cost_0(1),
      0, 6, false);
    winnerswinner4_tag <= winnerswinner3_tag;
    winnerswinner4_best_index_0_0 <= choice(winnerswinner4_best_index_0_0_choice_7, winnerswinner3_best_index_0(1),
      winnerswinner3_best_index_0(0));
    -- winners
    winners_best_index_0_0 <= winnerswinner4_best_index_0_0;
    winners_best_tag <= winnerswinner4_tag;
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
        (map_counter_column + 1) mod 1024);
    end if;
    map_counter_group_choice := choice(turn_ready_tag_row_start_alls(1), 15, 0);
    map_counter_group_is_equal := map_counter_group = 480;
    map_counter_group_choices(2) := choice(turn_ready_tag.row_start and map_counter_group_is_equal, 1,
      (map_counter_group + 1) mod 512);
    map_counter_group_choices(3) := choice(turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equals(1)
      and turn_ready_tag.valid and turn_ready_tag.map_column, map_counter_group_choices(2), map_counter_group);
    map_line_ended_choice := choice(turn_ready_tag.valid, turn_ready_tag.map_column, map_line_ended);
    map_at_arrives_value := other_0(16) = '1';
    map_of_column_0_b_below_a_values(1) := is_set(map_column(1), 2);
    map_of_column_0_b_below_a_choices(1) := choice(map_at_top, map_of_column_0_b_below_a_values(1), is_set(other_1, 2));
    map_of_column_0_b_below_a_values(2) := is_set(map_column(1), 1);
    map_of_column_0_b_below_a_choices(2) := choice(map_at_top, map_of_column_0_b_below_a_values(2), is_set(other_1, 1));
    map_of_column_0_b_below_a_choices(3) := choice(map_of_column_0_b_below_a_choices(2), (not
      map_of_column_0_b_below_a_values(1)) or (not map_of_column_0_b_below_a_values(2)), not
      map_of_column_0_b_below_a_values(1));
    map_of_column_0_b_below_a_choices(4) := choice(map_of_column_0_b_below_a_choices(1),
      map_of_column_0_b_below_a_choices(3), map_of_column_0_b_below_a_choices(2) and (((map_column(1) / 2) mod 4) = 0));
    map_of_column_0_b_below_a_values(3) := is_set(map_column(1), 3);
    map_of_column_0_b_below_a_values(4) := is_set(other_1, 3);
    map_of_column_0_b_below_a_choices(5) := choice(map_of_column_0_b_below_a_choices(4),
      map_of_column_0_b_below_a_values(3) and (not map_of_column_0_b_below_a_values(4)) and (not map_at_top),
      map_of_column_0_b_below_a_values(3) or (not map_of_column_0_b_below_a_values(4)) or map_at_top);
    for i in 4 to 6 loop
      map_of_column_0_b_below_a_values(2 * i - 3) := is_set(map_column(1), i);
      map_of_column_0_b_below_a_values(2 * i - 2) := is_set(other_1, i);
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
    for i in 3 to 6 loop
      map_of_column_0_c_below_a_values(i) := is_set(map_column(2), i);
      map_of_column_0_c_below_a_choices(3 * i - 5) := choice(map_counter_next_frame, map_of_column_0_b_below_a_values(2
        * i - 3), map_of_column_0_c_below_a_values(i));
      map_of_column_0_c_below_a_choices(3 * i - 4) := choice(map_at_top, map_of_column_0_b_below_a_values(2 * i - 3),
        map_of_column_0_b_below_a_values(2 * i - 2));
      map_of_column_0_c_below_a_choices(3 * i - 3) := carry(map_of_column_0_c_below_a_choices(3 * i - 6), not
        map_of_column_0_c_below_a_choices(3 * i - 5), map_of_column_0_c_below_a_choices(3 * i - 4));
    end loop;
    map_of_column_0_c_below_a_choices(16) := choice(map_counter_next_frame, is_set(map_column(1), 7),
      is_set(map_column(2), 7));
    map_of_column_0_c_below_a_choices(17) := choice(map_at_top, is_set(map_column(1), 7), is_set(other_1, 7));
    map_of_column_0_c_below_b_choices(1) := choice((not map_of_column_0_c_below_a_values(2)) and
      map_of_column_0_b_below_a_values(2) and (not map_counter_next_frame), map_of_column_0_c_below_a_values(1) and
      (not map_of_column_0_b_below_a_values(1)) and (not map_counter_next_frame), map_of_column_0_c_below_a_values(1)
      or (not map_of_column_0_b_below_a_values(1)) or map_counter_next_frame);
    for i in 2 to 5 loop
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
    for i in 2 to 5 loop
      map_of_low_0_b_below_a_values(2 * i - 2) := is_set(map_low_0(0), i);
      map_of_low_0_b_below_a_values(2 * i - 1) := is_set(map_low_0(1), i);
    end loop;
    map_of_low_0_b_below_a_choice_6 := not is_larger(map_low_0(0), map_low_0(1), 0, 5, false);
    map_of_low_0_c_below_a_value := is_set(map_low_0(2), 1);
    map_of_low_0_c_below_a_choice_6 := not is_larger(map_low_0(2), map_low_0(0), 0, 5, true);
    map_of_low_0_c_below_b_choice_6 := not is_larger(map_low_0(2), map_low_0(1), 0, 5, true);
    map_of_middle_0_b_below_a_values(1) := is_set(map_middle_0(0), 1);
    map_of_middle_0_b_below_a_is_equal := (map_middle_0(1) mod 4) = 0;
    for i in 2 to 5 loop
      map_of_middle_0_b_below_a_values(2 * i - 2) := is_set(map_middle_0(0), i);
      map_of_middle_0_b_below_a_values(2 * i - 1) := is_set(map_middle_0(1), i);
    end loop;
    map_of_middle_0_b_below_a_choice_6 := not is_larger(map_middle_0(0), map_middle_0(1), 0, 5, false);
    map_of_middle_0_c_below_a_value := is_set(map_middle_0(2), 1);
    map_of_middle_0_c_below_a_choice_6 := not is_larger(map_middle_0(2), map_middle_0(0), 0, 5, true);
    map_of_middle_0_c_below_b_choice_6 := not is_larger(map_middle_0(2), map_middle_0(1), 0, 5, true);
    map_of_high_0_b_below_a_values(1) := is_set(map_high_0(0), 1);
    map_of_high_0_b_below_a_is_equal := (map_high_0(1) mod 4) = 0;
    for i in 2 to 5 loop
      map_of_high_0_b_below_a_values(2 * i - 2) := is_set(map_high_0(0), i);
      map_of_high_0_b_below_a_values(2 * i - 1) := is_set(map_high_0(1), i);
    end loop;
    map_of_high_0_b_below_a_choice_6 := not is_larger(map_high_0(0), map_high_0(1), 0, 5, false);
    map_of_high_0_c_below_a_value := is_set(map_high_0(2), 1);
    map_of_high_0_c_below_a_choice_6 := not is_larger(map_high_0(2), map_high_0(0), 0, 5, true);
    map_of_high_0_c_below_b_choice_6 := not is_larger(map_high_0(2), map_high_0(1), 0, 5, true);
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
    for i in 2 to 5 loop
      map_of_all_0_b_below_a_values(2 * i - 2) := is_set(map_largest_low_0, i);
      map_of_all_0_b_below_a_values(2 * i - 1) := is_set(map_median_middle_0, i);
    end loop;
    map_of_all_0_b_below_a_choice_6 := not is_larger(map_largest_low_0, map_median_middle_0, 0, 5, false);
    map_of_all_0_c_below_a_value := is_set(map_smallest_high_0, 1);
    map_of_all_0_c_below_a_choice_6 := not is_larger(map_smallest_high_0, map_largest_low_0, 0, 5, true);
    map_of_all_0_c_below_b_choice_6 := not is_larger(map_smallest_high_0, map_median_middle_0, 0, 5, true);
    map_out_disparity_0_choices(1) := choice(map_of_all_0_c_below_a, map_of_all_0_c, map_of_all_0_a);
    map_out_disparity_0_choices(2) := choice(map_of_all_0_c_below_b, map_of_all_0_b, map_out_disparity_0_choices(1));
    map_out_disparity_0_choices(3) := choice(map_of_all_0_c_below_b, map_of_all_0_c, map_of_all_0_b);
    map_out_disparity_0_choices(4) := choice(map_of_all_0_c_below_a, map_of_all_0_a, map_out_disparity_0_choices(3));
    map_counter_next_frame <= other_0(40) = '1';
    map_newest_0 <= ((turn_ready mod 128) * 2) + (turn_ready / 256);
    map_arrives <= turn_ready_tag_row_start_alls(2);
    map_behind <= map_line_ended and turn_ready_tag.valid;
    map_rows_read_newest_0 <= map_newest_0;
    map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
    map_rows_ready_newest_0 <= map_rows_read_newest_0;
    map_write_column <= to_integer(other_0(9 downto 0));
    map_column(1) <= map_rows_ready_words_0 / 512;
    map_column(2) <= map_rows_ready_newest_0;
    map_at_arrives <= map_at_arrives_value;
    map_at_behind <= other_0(24) = '1';
    map_at_top <= other_0(32) = '1';
    map_at_output <= other_0(48) = '1';
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
      map_counter_group_choice * 32, map_counter_group_choices(3));
    map_line_ended <= choice(turn_ready_tag.end_of_line, map_line_ended_choice, map_line_ended and (not
      turn_ready_tag.valid));
    map_of_column_0_a <= choice(map_at_top, map_column(1) / 2, other_1 / 2);
    map_of_column_0_c <= choice(map_counter_next_frame, map_column(1) / 2, map_column(2) / 2);
    map_of_column_0_b_below_a <= choice(map_of_column_0_b_below_a_choices(8), (not is_set(map_column(1), 7)) and
      is_set(other_1, 7) and (not map_at_top), (not is_set(map_column(1), 7)) or is_set(other_1, 7) or map_at_top);
    map_of_column_0_c_below_a <= carry(map_of_column_0_c_below_a_choices(15), not
      map_of_column_0_c_below_a_choices(16), map_of_column_0_c_below_a_choices(17));
    map_of_column_0_c_below_b <= choice(map_of_column_0_c_below_b_choices(5), (not is_set(map_column(2), 7)) and
      is_set(map_column(1), 7) and (not map_counter_next_frame), (not is_set(map_column(2), 7)) or
      is_set(map_column(1), 7) or map_counter_next_frame);
    map_sorted_low_0 <= choice(map_of_column_0_b_below_a, map_sorted_low_0_choices(1), map_sorted_low_0_choices(2));
    map_sorted_middle_0 <= choice(map_of_column_0_b_below_a, map_sorted_middle_0_choices(1),
      map_sorted_middle_0_choices(2));
    map_sorted_high_0 <= choice(map_of_column_0_b_below_a, map_sorted_high_0_choices(1), map_sorted_high_0_choices(2));
    map_passed_0(1) <= choice(map_passed_0(0), map_passed_0(1) or map_sorted_arrives or map_sorted_behind,
      map_passed_0(1) and (not map_sorted_arrives) and (not map_sorted_behind));
    map_of_low_0_b_below_a <= inverted_carry(map_of_low_0_b_below_a_choice_6, is_set(map_low_0(0), 6), not
      is_set(map_low_0(1), 6));
    map_of_low_0_c_below_a <= carry(map_of_low_0_c_below_a_choice_6, not is_set(map_low_0(2), 6), is_set(map_low_0(0),
      6));
    map_of_low_0_c_below_b <= carry(map_of_low_0_c_below_b_choice_6, not is_set(map_low_0(2), 6), is_set(map_low_0(1),
      6));
    map_of_middle_0_b_below_a <= inverted_carry(map_of_middle_0_b_below_a_choice_6, is_set(map_middle_0(0), 6), not
      is_set(map_middle_0(1), 6));
    map_of_middle_0_c_below_a <= carry(map_of_middle_0_c_below_a_choice_6, not is_set(map_middle_0(2), 6),
      is_set(map_middle_0(0), 6));
    map_of_middle_0_c_below_b <= carry(map_of_middle_0_c_below_b_choice_6, not is_set(map_middle_0(2), 6),
      is_set(map_middle_0(1), 6));
    map_of_high_0_b_below_a <= inverted_carry(map_of_high_0_b_below_a_choice_6, is_set(map_high_0(0), 6), not
      is_set(map_high_0(1), 6));
    map_of_high_0_c_below_a <= carry(map_of_high_0_c_below_a_choice_6, not is_set(map_high_0(2), 6),
      is_set(map_high_0(0), 6));
    map_of_high_0_c_below_b <= carry(map_of_high_0_c_below_b_choice_6, not is_set(map_high_0(2), 6),
      is_set(map_high_0(1), 6));
    map_largest_low_0 <= choice(map_of_low_0_b_below_a, map_largest_low_0_choices(1), map_largest_low_0_choices(2));
    map_median_middle_0 <= choice(map_of_middle_0_b_below_a, map_median_middle_0_choices(2),
      map_median_middle_0_choices(4));
    map_smallest_high_0 <= choice(map_of_high_0_b_below_a, map_smallest_high_0_choices(1),
      map_smallest_high_0_choices(2));
    map_of_all_0_b_below_a <= inverted_carry(map_of_all_0_b_below_a_choice_6, is_set(map_largest_low_0, 6), not
      is_set(map_median_middle_0, 6));
    map_of_all_0_c_below_a <= carry(map_of_all_0_c_below_a_choice_6, not is_set(map_smallest_high_0, 6),
      is_set(map_largest_low_0, 6));
    map_of_all_0_c_below_b <= carry(map_of_all_0_c_below_b_choice_6, not is_set(map_smallest_high_0, 6),
      is_set(map_median_middle_0, 6));
    map_out_disparity_0 <= choice(map_of_all_0_b_below_a, map_out_disparity_0_choices(2),
      map_out_disparity_0_choices(4));
    if map_at_arrives_value then
      map_rows_write_words_0 <= (map_rows_ready_words_0 / 512) + (map_rows_ready_newest_0 * 512);
      map_at_column <= to_integer(other_0(9 downto 0));
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
    for i in 2 to 17 loop
      other_choice(i) := choice(slice0_tag_border_column(4), 0, slice7cost_single_0(17 - i) / 4);
    end loop;
    for i in 18 to 33 loop
      other_choice(i) := choice(slice0_tag_border_column(3), 0, slice6cost_single_0(33 - i) / 4);
    end loop;
    for i in 34 to 49 loop
      other_choice(i) := choice(slice0_tag_border_column(2), 0, slice5cost_single_0(49 - i) / 4);
    end loop;
    for i in 50 to 65 loop
      other_choice(i) := choice(slice0_tag_border_column(1), 0, slice4cost_single_0(65 - i) / 4);
    end loop;
    for i in 66 to 81 loop
      other_choice(i) := choice(slice0_tag_border_column(0), 0, slice3cost_single_0(81 - i) / 4);
    end loop;
    for i in 82 to 97 loop
      other_choice(i) := choice(slice0window_tag.border_column, 0, slice2cost_single_0(97 - i) / 4);
    end loop;
    for i in 98 to 113 loop
      other_choice(i) := choice(slice0cost_tag.border_column, 0, slice1cost_single_0(113 - i) / 4);
    end loop;
    for i in 114 to 129 loop
      other_choice(i) := choice(slice0cost_pair_tag.border_column, 0, slice0cost_single_0(129 - i) / 4);
    end loop;
    other_0 <= other_2;
    other_1 <= (((map_rows_ready_words_0 mod 512) / 2) mod 128) * 2;
    other_2 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 481))), 1) &
      to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
      to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) & to_unsigned(map_counter_column,
      16);
    for i in 2 to 129 loop
      other(2 * i - 1) <= other(2 * i);
      other(2 * i) <= other_choice(i) * 4;
    end loop;
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 482;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 480; delay_tag.valid <= false; delay_tag.first_cost <= false; delay_tag.map_column <= false;
      delay_tag.output_column <= false; delay_tag.start_of_frame <= false; delay_tag.end_of_line <= false;
      rows_tag.valid <= false; rows_tag.first_cost <= false; rows_tag.map_column <= false;
      rows_tag.output_column <= false; rows_tag.start_of_frame <= false; rows_tag.end_of_line <= false;
      slice0shift_tag.valid <= false; slice0shift_tag.first_cost <= false; slice0shift_tag.map_column <= false;
      slice0shift_tag.output_column <= false; slice0shift_tag.start_of_frame <= false;
      slice0shift_tag.end_of_line <= false; slice0cost_pixels_first_tag.valid <= false;
      slice0cost_pixels_first_tag.first_cost <= false; slice0cost_pixels_first_tag.map_column <= false;
      slice0cost_pixels_first_tag.output_column <= false; slice0cost_pixels_first_tag.start_of_frame <= false;
      slice0cost_pixels_first_tag.end_of_line <= false; slice0cost_pixels_tag.valid <= false;
      slice0cost_pixels_tag.first_cost <= false; slice0cost_pixels_tag.map_column <= false;
      slice0cost_pixels_tag.output_column <= false; slice0cost_pixels_tag.start_of_frame <= false;
      slice0cost_pixels_tag.end_of_line <= false; slice0cost_pair_tag.valid <= false;
      slice0cost_pair_tag.first_cost <= false; slice0cost_pair_tag.map_column <= false;
      slice0cost_pair_tag.output_column <= false; slice0cost_pair_tag.start_of_frame <= false;
      slice0cost_pair_tag.end_of_line <= false; slice0cost_tag.valid <= false; slice0cost_tag.first_cost <= false;
      slice0cost_tag.map_column <= false; slice0cost_tag.output_column <= false; slice0cost_tag.start_of_frame <= false;
      slice0cost_tag.end_of_line <= false; slice0window_tag.valid <= false; slice0window_tag.first_cost <= false;
      slice0window_tag.map_column <= false; slice0window_tag.output_column <= false;
      slice0window_tag.start_of_frame <= false; slice0window_tag.end_of_line <= false;
      for i in 0 to 7 loop
        slice0_tag_valid(i) <= false; slice0_tag_first_cost(i) <= false; slice0_tag_map_column(i) <= false;
        slice0_tag_output_column(i) <= false; slice0_tag_start_of_frame(i) <= false; slice0_tag_end_of_line(i) <= false;
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
      winnerswinner4_tag <= (others => false); winners_best_tag <= (others => false); turn_order_address <= 0;
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
      other_0 <= to_unsigned(0, 49); other_2 <= to_unsigned(0, 49);
    end if;
  end process;
end architecture;
