-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration tiny_sgm: 40x12, 12 disparities, window 3x3, P1 5, P2 22, 1 pixel pair a clock.
-- Options: disparities 12, slice_disparities 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_sgm
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_sgm is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 12;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 29;
    latency_clocks : positive := 34;
    flush_groups : positive := 207;
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
  assert width_px = 40 report "stereo_core_tiny_sgm: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 12 report "stereo_core_tiny_sgm: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 12 report "stereo_core_tiny_sgm: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_sgm: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_sgm: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 29 report "stereo_core_tiny_sgm: output_width_px is " & integer'image(output_width_px) & " but this core has 29" severity failure;
  assert latency_clocks = 34 report "stereo_core_tiny_sgm: latency_clocks is " & integer'image(latency_clocks) & " but this core has 34" severity failure;
  assert flush_groups = 207 report "stereo_core_tiny_sgm: flush_groups is " & integer'image(flush_groups) & " but this core has 207" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_sgm: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_sgm is
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
  type natural_11_1d is array (natural range <>) of natural range 0 to 11;
  type natural_126_1d is array (natural range <>) of natural range 0 to 126;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_13_1d is array (natural range <>) of natural range 0 to 13;
  type natural_13_2d is array (natural range <>, natural range <>) of natural range 0 to 13;
  type natural_144_1d is array (natural range <>) of natural range 0 to 144;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_15_2d is array (natural range <>, natural range <>) of natural range 0 to 15;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_16777215_2d is array (natural range <>, natural range <>) of natural range 0 to 16777215;
  type natural_216_1d is array (natural range <>) of natural range 0 to 216;
  type natural_24_1d is array (natural range <>) of natural range 0 to 24;
  type natural_24_2d is array (natural range <>, natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_266321790_1d is array (natural range <>) of natural range 0 to 266321790;
  type natural_268435455_1d is array (natural range <>) of natural range 0 to 268435455;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_44_1d is array (natural range <>) of natural range 0 to 44;
  type natural_48_1d is array (natural range <>) of natural range 0 to 48;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_2d is array (natural range <>, natural range <>) of natural range 0 to 63;
  type natural_68_1d is array (natural range <>) of natural range 0 to 68;
  type natural_68_2d is array (natural range <>, natural range <>) of natural range 0 to 68;
  type natural_72_1d is array (natural range <>) of natural range 0 to 72;
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
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
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0, transform_left_rows_ready_newest_0,
    transform_right_rows_read_newest_0, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 4);
  signal transform_left_filter_column, transform_right_filter_column : natural_255_2d(0 to 4, 0 to 4);
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_read_row_inside, transform_read_column_inside : boolean_1d(0 to 4);
  signal transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside, transform_ready_column_inside : boolean_1d(0 to 4);
  signal transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_columns_row_inside, transform_columns_column_inside : boolean_1d(0 to 4);
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside : boolean_1d(0 to 4);
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- _#_valid
  signal transform_counter_column, transform_read_column, transform_ready_column,
    transform_write_column : natural range 0 to 63;
  signal transform_counter_group : natural range 0 to 15;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0, transform_left_rows_write_words_0,
    transform_right_rows_read_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16777215;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16777215;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 16777215;
  signal delay_delayed_0 : unsigned(23 downto 0);
  signal delay_column : natural range 0 to 63;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag : tag_7;
  -- rows
  signal rows_search_rows_read_words, rows_reference_rows_read_words : unsigned_24_1d(0 to 1);
  signal rows_search_rows_read_newest_0 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words : natural_16777215_1d(0 to 1);
  signal rows_search_rows_ready_newest_0 : natural range 0 to 16777215;
  signal rows_search_rows_write_words : natural_16777215_1d(0 to 1);
  signal rows_reference_rows_read_newest_0 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words : natural_16777215_1d(0 to 1);
  signal rows_reference_rows_ready_newest_0 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words : natural_16777215_1d(0 to 1);
  signal rows_search, rows_reference : natural_16777215_1d(0 to 2);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 63;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag : tag_7;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag, rows_tag : tag_7;
  -- slice0shift
  signal slice0shift_search : natural_16777215_2d(0 to 2, 0 to 4);
  signal slice0shift_reference, slice0shift_search_out : natural_16777215_1d(0 to 2);
  signal slice0shift_tag : tag_7;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 4, 0 to 7);  -- _#_#_count_#
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_pair_tag, slice0cost_tag : tag_7;
  signal slice0cost_pixels_cost : natural_24_2d(0 to 2, 0 to 4);
  signal slice0cost_single_0 : natural_24_1d(0 to 4);
  signal slice0cost_pair_0 : natural_48_1d(0 to 4);
  signal slice0cost_column_0 : natural_72_1d(0 to 4);
  -- slice0window
  signal slice0window_partial_0_0 : natural_72_1d(0 to 4);
  signal slice0window_partial_0_1 : natural_144_1d(0 to 4);
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0, slice0window_centre_first_column_0,
    slice0window_centre_start_of_frame_0, slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_6;
  signal slice0window_sum_0 : natural_216_1d(0 to 4);
  -- slice0
  signal slice0_held : natural_13_2d(0 to 2, 0 to 4);
  signal slice0_tag_valid : boolean_1d(0 to 2);  -- _#_valid
  signal slice0_tag_map_column : boolean_1d(0 to 2);  -- _#_map_column
  signal slice0_tag_output_column : boolean_1d(0 to 2);  -- _#_output_column
  signal slice0_tag_first_column : boolean_1d(0 to 2);  -- _#_first_column
  signal slice0_tag_start_of_frame : boolean_1d(0 to 2);  -- _#_start_of_frame
  signal slice0_tag_end_of_line : boolean_1d(0 to 2);  -- _#_end_of_line
  -- slice1shift
  signal slice1shift_search : natural_16777215_2d(0 to 2, 0 to 4);
  signal slice1shift_reference, slice1shift_search_out : natural_16777215_1d(0 to 2);
  -- slice1cost
  signal slice1cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 4, 0 to 7);  -- _#_#_count_#
  signal slice1cost_pixels_cost : natural_24_2d(0 to 2, 0 to 4);
  signal slice1cost_single_0 : natural_24_1d(0 to 4);
  signal slice1cost_pair_0 : natural_48_1d(0 to 4);
  signal slice1cost_column_0 : natural_72_1d(0 to 4);
  signal slice1cost_tag_border_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0 : natural_72_1d(0 to 4);
  signal slice1window_partial_0_1 : natural_144_1d(0 to 4);
  signal slice1window_sum_0 : natural_216_1d(0 to 4);
  -- slice1
  signal slice1_held : natural_13_2d(0 to 1, 0 to 4);
  -- slice2shift
  signal slice2shift_search : natural_16777215_2d(0 to 2, 0 to 1);
  signal slice2shift_reference : natural_16777215_1d(0 to 2);
  -- slice2cost
  signal slice2cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 1, 0 to 7);  -- _#_#_count_#
  signal slice2cost_pixels_cost : natural_24_2d(0 to 2, 0 to 1);
  signal slice2cost_single_0 : natural_24_1d(0 to 1);
  signal slice2cost_pair_0 : natural_48_1d(0 to 1);
  signal slice2cost_column_0 : natural_72_1d(0 to 1);
  -- slice2window
  signal slice2window_partial_0_0 : natural_72_1d(0 to 1);
  signal slice2window_partial_0_1 : natural_144_1d(0 to 1);
  signal slice2window_sum_0 : natural_216_1d(0 to 1);
  -- slice2
  signal slice2_held_0 : natural_13_1d(0 to 1);
  -- entry
  signal entry_next_cost, entry_cost : natural_13_1d(0 to 11);
  signal entry_next_tag : tag_4;
  signal entry_next_top, entry_order_falls, entry_order_inside, entry_order_complete, entry_order_output,
    entry_order_first, entry_order_held_output, entry_order_turned_output_column, entry_order_turned_first_column,
    entry_order_turned_start_of_frame : boolean;
  signal entry_tag : tag_4;
  signal entry_top, entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 31;
  -- forward
  signal forward_smallest_smallest : natural_13_1d(0 to 5);
  signal forward_smallest_next_smallest : natural_13_1d(0 to 2);
  signal forward_smallest_next_next_smallest : natural_13_1d(0 to 1);
  signal forward_smallest_next_next_next_smallest_0, forward_left_smallest : natural range 0 to 13;
  signal forward_above_ready_cost : natural_13_1d(0 to 11);
  signal forward_smallest_cost : natural_13_1d(0 to 4);
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address,
    forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost_delay_held_0 : unsigned(31 downto 0);
  signal forward_above_read_words, forward_above_ready_words, forward_above_write_words : unsigned_32_1d(0 to 1);
  signal forward_cost_delay_held_1 : unsigned(15 downto 0);
  signal forward_left_pair : natural_63_1d(0 to 5);
  signal forward_left_tree_smallest : natural_63_1d(0 to 2);
  signal forward_left_tree_next_smallest : natural_63_1d(0 to 1);
  signal forward_left_tree_next_next_smallest_0, forward_left_smallest_less, forward_left_g_copy_0,
    forward_left_g_less_copy_0 : natural range 0 to 63;
  signal forward_left_stay_change, forward_left_step_change, forward_left_cost, forward_left_arrived,
    forward_above_cost, forward_above_beside : natural_63_1d(0 to 11);
  signal forward_above_own_0 : natural range 0 to 63;
  signal forward_above_own : natural_63_1d(2 to 9);
  signal forward_above_own_11 : natural range 0 to 63;
  signal forward_left_start_cost : natural_255_1d(0 to 6);
  signal forward_left_room : natural range 0 to 31;
  signal forward_above_stay : natural_31_1d(0 to 11);
  signal forward_above_column : natural_31_1d(0 to 9);
  signal forward_above_write_column : natural range 0 to 31;
  signal forward_left_first : boolean_1d(0 to 2);
  signal forward_above_ready_top : boolean;
  signal forward_above_comes : boolean_1d(0 to 9);
  signal forward_above_writes_copy_0 : boolean;
  signal forward_first : boolean_1d(0 to 3);
  signal forward_above_total : natural_44_1d(0 to 11);
  signal forward_above_tree_smallest : natural_44_1d(0 to 5);
  signal forward_above_tree_next_smallest : natural_44_1d(0 to 2);
  signal forward_above_tree_next_next_smallest : natural_44_1d(0 to 1);
  signal forward_above_tree_next_next_next_smallest_0, forward_above_smallest_copy_0 : natural range 0 to 44;
  signal forward_above_delay_held : unsigned_30_1d(0 to 1);
  signal forward_above_delay_held_2 : unsigned(11 downto 0);
  signal forward_above_step : natural_68_1d(0 to 11);
  signal forward_sum : natural_126_1d(0 to 11);
  signal forward_cost : natural_15_2d(0 to 3, 0 to 11);
  -- sums
  signal sums_turn_read_sums, sums_sum_delay_held : unsigned_28_1d(0 to 2);
  signal sums_turn_read_costs_0, sums_turn_ready_costs_0, sums_turn_write_costs_0 : unsigned(31 downto 0);
  signal sums_turn_read_costs_1 : unsigned(15 downto 0);
  signal sums_turn_read_smallest_0 : unsigned(3 downto 0);
  signal sums_turn_ready_sums : natural_268435455_1d(0 to 2);
  signal sums_turn_ready_costs_1, sums_turn_write_costs_1 : natural range 0 to 65535;
  signal sums_turn_ready_smallest_0 : natural range 0 to 15;
  signal sums_cost : natural_15_2d(0 to 1, 0 to 11);
  signal sums_right_smallest : natural range 0 to 15;
  signal sums_turn_ready_first, sums_turn_writes_copy_0 : boolean;
  signal sums_right_first : boolean_1d(0 to 2);
  signal sums_tag : tag_5;
  signal sums_tags_held_output_column : boolean_1d(0 to 4);  -- _#_output_column
  signal sums_tags_held_start_of_frame : boolean_1d(0 to 4);  -- _#_start_of_frame
  signal sums_tags_held_end_of_line : boolean_1d(0 to 4);  -- _#_end_of_line
  signal sums_tags_moved : boolean;
  signal sums_turn_place : natural_31_1d(0 to 8);
  signal sums_turn_write_place, sums_right_room : natural range 0 to 31;
  signal sums_turn_write_sums : natural_266321790_1d(0 to 2);
  signal sums_turn_write_smallest_0 : natural range 0 to 13;
  signal sums_right_pair : natural_63_1d(0 to 5);
  signal sums_right_tree_smallest : natural_63_1d(0 to 2);
  signal sums_right_tree_next_smallest : natural_63_1d(0 to 1);
  signal sums_right_tree_next_next_smallest_0, sums_right_smallest_less, sums_right_g_copy_0,
    sums_right_g_less_copy_0 : natural range 0 to 63;
  signal sums_right_stay_change, sums_right_step_change, sums_right_cost, sums_right_arrived : natural_63_1d(0 to 11);
  signal sums_right_start_cost : natural_255_1d(0 to 6);
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  signal sums_sum_0 : natural_127_1d(0 to 11);
  -- winnerswinner1
  signal winnerswinner1_of_pair_0, winnerswinner1_of_four_0 : natural_127_1d(0 to 11);
  signal winnerswinner1_best_cost_0 : natural_127_1d(0 to 2);
  signal winnerswinner1_pair_index_0_0 : boolean;
  signal winnerswinner1_pair_tag, winnerswinner1_four_tag, winnerswinner1_tag : tag_5;
  signal winnerswinner1_pair_index_0 : natural_11_1d(1 to 5);  -- _# up to 3, 5 .. 11
  signal winnerswinner1_four_index_0, winnerswinner1_best_index_0 : natural_11_1d(0 to 2);  -- _# up to 3, 7, 11
  -- winnerswinner2
  signal winnerswinner2_of_pair_0 : natural_127_1d(0 to 2);
  signal winnerswinner2_pair_index_0 : natural_11_1d(0 to 1);  -- _# up to 7, 11
  signal winnerswinner2_four_index_0_0, winnerswinner2_best_index_0_0 : natural range 0 to 11;
  signal winnerswinner2_pair_tag, winnerswinner2_four_tag, winnerswinner2_tag : tag_5;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 11;
  signal winners_best_tag : tag_5;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 31;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_held_output, turn_order_turned_valid, turn_order_turned_output_column, turn_order_turned_start_of_frame,
    turn_order_turned_end_of_line, turn_comes : boolean;
  signal turn_read_tag, turn_ready_tag : tag_4_b;
  signal turn_newest, turn_write_words_0 : natural range 0 to 267;
  signal turn_read_words_0 : unsigned(8 downto 0);
  signal turn_ready : natural range 0 to 511;

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned((turn_ready mod 16), 8));
  pixel_valid <= std_logic_vector(to_unsigned((turn_ready / 256), 1));
  disparity_valid <= as_bit(turn_ready_tag.valid and turn_ready_tag.output_column);
  disparity_start_of_frame <= as_bit(turn_ready_tag.start_of_frame and turn_ready_tag.valid and turn_ready_tag.output_column);
  disparity_end_of_line <= as_bit(turn_ready_tag.end_of_line and turn_ready_tag.valid and turn_ready_tag.output_column);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  transform_left_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 6);
    write_address <= to_unsigned(transform_write_column, 6);
    cell : entity work.line_memory generic map (40, 32, 6)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address,
        transform_left_rows_write_words_0);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 6);
    write_address <= to_unsigned(transform_write_column, 6);
    cell : entity work.line_memory generic map (40, 32, 6)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address,
        transform_right_rows_write_words_0);
  end block;

  turn_read_words_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(turn_order_address, 5);
    write_address <= to_unsigned(turn_write_place, 5);
    write_data <= to_unsigned(turn_write_words_0, 9);
    cell : entity work.line_memory generic map (29, 9, 5)
      port map (clock, true, read_address, turn_read_words_0, write_address, write_data);
  end block;

  sums_sum_delay_held_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(1 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
    write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
    write_data <= to_unsigned(sums_turn_ready_sums(i), 28);
    cell : entity work.line_memory generic map (4, 28, 2)
      port map (clock, entry_tag.valid, read_address, sums_sum_delay_held(i), write_address, write_data);
  end generate;

  sums_turn_read_sums_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 5);
    write_address <= to_unsigned(sums_turn_write_place, 5);
    write_data <= to_unsigned(sums_turn_write_sums(i), 28);
    cell : entity work.line_memory generic map (29, 28, 5)
      port map (clock, true, read_address, sums_turn_read_sums(i), write_address, write_data);
  end generate;

  sums_turn_read_costs_1_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 5);
    write_address <= to_unsigned(sums_turn_write_place, 5);
    write_data <= to_unsigned(sums_turn_write_costs_1, 16);
    cell : entity work.line_memory generic map (29, 16, 5)
      port map (clock, true, read_address, sums_turn_read_costs_1, write_address, write_data);
  end block;

  sums_turn_read_costs_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 5);
    write_address <= to_unsigned(sums_turn_write_place, 5);
    cell : entity work.line_memory generic map (29, 32, 5)
      port map (clock, true, read_address, sums_turn_read_costs_0, write_address, sums_turn_write_costs_0);
  end block;

  sums_turn_read_smallest_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(3 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 5);
    write_address <= to_unsigned(sums_turn_write_place, 5);
    write_data <= to_unsigned(sums_turn_write_smallest_0, 4);
    cell : entity work.line_memory generic map (29, 4, 5)
      port map (clock, true, read_address, sums_turn_read_smallest_0, write_address, write_data);
  end block;

  forward_above_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(4 downto 0);
  begin
    read_address <= to_unsigned(entry_next_column, 5);
    write_address <= to_unsigned(forward_above_write_column, 5);
    cell : entity work.line_memory generic map (29, 32, 5)
      port map (clock, true, read_address, forward_above_read_words(i), write_address, forward_above_write_words(i));
  end generate;

  forward_above_delay_held_2_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= to_unsigned(forward_above_total(11), 6) & to_unsigned(forward_above_total(10), 6);
    cell : entity work.line_memory generic map (5, 12, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held_2, write_address, write_data);
  end block;

  forward_above_delay_held_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
    write_data <= to_unsigned(forward_above_total(5 * i + 4), 6) & to_unsigned(forward_above_total(5 * i + 3), 6) &
      to_unsigned(forward_above_total(5 * i + 2), 6) & to_unsigned(forward_above_total(5 * i + 1), 6) &
      to_unsigned(forward_above_total(5 * i), 6);
    cell : entity work.line_memory generic map (5, 30, 3)
      port map (clock, entry_tag.valid, read_address, forward_above_delay_held(i), write_address, write_data);
  end generate;

  forward_cost_delay_held_1_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
    write_data <= to_unsigned(entry_cost(11), 4) & to_unsigned(entry_cost(10), 4) & to_unsigned(entry_cost(9), 4) &
      to_unsigned(entry_cost(8), 4);
    cell : entity work.line_memory generic map (5, 16, 3)
      port map (clock, entry_tag.valid, read_address, forward_cost_delay_held_1, write_address, write_data);
  end block;

  forward_cost_delay_held_0_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
    write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
    write_data <= to_unsigned(entry_cost(7), 4) & to_unsigned(entry_cost(6), 4) & to_unsigned(entry_cost(5), 4) &
      to_unsigned(entry_cost(4), 4) & to_unsigned(entry_cost(3), 4) & to_unsigned(entry_cost(2), 4) &
      to_unsigned(entry_cost(1), 4) & to_unsigned(entry_cost(0), 4);
    cell : entity work.line_memory generic map (5, 32, 3)
      port map (clock, entry_tag.valid, read_address, forward_cost_delay_held_0, write_address, write_data);
  end block;

  rows_search_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 6);
    write_address <= to_unsigned(rows_write_column, 6);
    write_data <= to_unsigned(rows_search_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (40, 24, 6)
      port map (clock, true, read_address, rows_search_rows_read_words(i), write_address, write_data);
  end generate;

  rows_reference_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 6);
    write_address <= to_unsigned(rows_write_column, 6);
    write_data <= to_unsigned(rows_reference_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (40, 24, 6)
      port map (clock, true, read_address, rows_reference_rows_read_words(i), write_address, write_data);
  end generate;

  delay_delayed_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 4);
    write_address <= to_unsigned(delay_ring_write_address, 4);
    write_data <= to_unsigned(raster_features_reference_0, 24);
    cell : entity work.line_memory generic map (12, 24, 4)
      port map (clock, true, read_address, delay_delayed_0, write_address, write_data);
  end block;

  process
    variable transform_counter_group_is_equals, raster_place_group_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable transform_counter_group_all, transform_read_column_inside_1_differs, transform_left_filter_feature_0_any,
      transform_left_filter_feature_0_is_equal, transform_right_filter_feature_0_any,
      transform_right_filter_feature_0_is_equal, transform_counter_next_frame_choice, raster_place_group_all,
      raster_place_group_choice_2, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less,
      delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less,
      entry_order_falls_any, entry_order_falls_all, entry_order_complete_all, entry_order_complete_any,
      entry_order_turned_output_column_choice, forward_left_start_cost_0_value, sums_right_start_cost_0_value,
      sums_turn_writes_copy_0_choice, winnerswinner2_of_pair_0_0_choice_7, turn_order_falls_all,
      turn_order_complete_all, turn_order_turned_output_column_choice : boolean;
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 3;
    variable transform_counter_group_choices : natural_15_1d(2 to 3);  -- _choice_#
    variable transform_read_column_inside_1_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_read_column_inside_choice : boolean_2d(1 to 3, 1 to 2);  -- _#_choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(8 to 192);
    variable transform_left_filter_feature_0_choice_193,
      transform_right_filter_feature_0_choice_193 : natural range 0 to 31;
    variable transform_left_filter_feature_0_choice_194,
      transform_right_filter_feature_0_choice_194 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_195,
      transform_right_filter_feature_0_choice_195 : natural range 0 to 8191;
    variable transform_left_filter_feature_0_choice_196,
      transform_right_filter_feature_0_choice_196 : natural range 0 to 524287;
    variable raster_place_group_choices : natural_15_1d(3 to 4);  -- _choice_#
    variable raster_place_next_frame_choices : boolean_1d(1 to 4);  -- _choice_#
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 31;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 7;
    variable forward_left_pair_choice, sums_right_pair_choice : natural_63_1d(0 to 5);  -- _#_choice
    variable forward_left_start_cost_0_choices, sums_right_start_cost_0_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable forward_left_room_choices, sums_right_room_choices : natural_31_1d(1 to 2);  -- _choice_#
    variable forward_left_cost_choice, forward_left_arrived_choice, sums_right_cost_choice,
      sums_right_arrived_choice : natural_63_2d(0 to 11, 1 to 2);  -- _#_choice_#
    variable forward_above_total_choice : natural_31_1d(0 to 11);  -- _#_choice
    variable forward_above_write_words_choice : natural_68_2d(0 to 1, 1 to 6);  -- _#_choice_#
    variable winnerswinner1_of_pair_0_value : boolean_2d(0 to 5, 1 to 4);  -- _2#_value_#
    variable winnerswinner1_of_pair_0_choice_7 : boolean_1d(0 to 5);  -- _2#_choice_7
    variable winnerswinner1_of_four_0_choice : boolean_2d(0 to 2, 1 to 7);  -- _4#_choice_#
    variable winnerswinner1_of_four_0_value : boolean_2d(0 to 2, 1 to 10);  -- _4#_value_#
    variable winnerswinner2_of_pair_0_0_values : boolean_1d(1 to 4);  -- _value_#
    variable winnerswinner2_four_index_0_0_values : boolean_1d(1 to 10);  -- _value_#
    variable winnerswinner2_four_index_0_0_choices : boolean_1d(1 to 6);  -- _choice_#
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    forward_left_arrived_choice := (others => (others => 0)); sums_right_arrived_choice := (others => (others => 0));
    transform_left_filter_feature_0_choice := (others => false);
    transform_read_column_inside_choice := (others => (others => false));
    transform_right_filter_feature_0_choice := (others => false);
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_column = 39;
    transform_counter_group_is_equals(2) := transform_counter_group = 11;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 3, 0);
    transform_counter_group_is_equals(3) := transform_counter_group = 13;
    transform_counter_group_choices(2) := choice(transform_counter_next_frame and transform_counter_group_is_equals(3),
      2, (transform_counter_group + 1) mod 16);
    transform_counter_group_choices(3) := choice((transform_counter_group /= 14) and
      transform_counter_group_is_equals(1) and in_valid, transform_counter_group_choices(2), transform_counter_group);
    transform_read_column_inside_1_is_equals(1) := (transform_counter_column / 4) = 0;
    transform_read_column_inside_1_is_equals(2) := (transform_counter_column / 2) = 0;
    transform_read_column_inside_choice(1, 1) := choice(transform_read_column_inside_1_is_equals(2),
      (transform_counter_column mod 4) = 0, is_set(transform_counter_column, 0) or is_set(transform_counter_column, 1));
    transform_read_column_inside_1_differs := (transform_counter_column / 2) /= 0;
    transform_read_column_inside_choice(3, 1) := choice(is_set(transform_counter_column, 0), ((transform_counter_column
      / 2) mod 8) = 0, ((transform_counter_column / 4) mod 4) = 0);
    transform_read_column_inside_choice(3, 2) := choice(transform_read_column_inside_1_is_equals(2),
      (transform_counter_column / 16) = 0, is_set(transform_counter_column, 5) or is_set(transform_counter_column, 4));
    transform_left_filter_feature_0_values(1) := is_set(transform_left_filter_column(2, 2), 1);
    transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_values(1)) or (not
      is_set(transform_left_filter_column(2, 2), 0));
    transform_left_filter_feature_0_is_equal := (transform_left_filter_column(2, 2) mod 4) = 0;
    for i in 2 to 6 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(2, 2), i);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 4 loop
        transform_left_filter_feature_0_choice(40 * i + 8 * j + 8) := is_larger(transform_left_filter_column(4 - i, j),
          transform_left_filter_column(2, 2), 0, 7, false);
      end loop;
    end loop;
    transform_left_filter_feature_0_choice(87) := not is_larger(transform_left_filter_column(2, 4),
      transform_left_filter_column(2, 2), 0, 6, false);
    transform_left_filter_feature_0_choice(88) := choice(transform_left_filter_feature_0_choice(87),
      transform_filtering_0_column_inside(2) and is_set(transform_left_filter_column(2, 4), 7) and (not
      is_set(transform_left_filter_column(2, 2), 7)), transform_filtering_0_column_inside(2) and
      (is_set(transform_left_filter_column(2, 4), 7) or (not is_set(transform_left_filter_column(2, 2), 7))));
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(16 * i + 96) := is_larger(transform_left_filter_column(2, 1 - i),
        transform_left_filter_column(2, 2), 0, 7, false);
      transform_left_filter_feature_0_choice(16 * i + 104) := is_larger(transform_left_filter_column(2 - i, 3),
        transform_left_filter_column(2, 2), 0, 7, false);
    end loop;
    transform_left_filter_feature_0_choice(128) := is_larger(transform_left_filter_column(1, 4),
      transform_left_filter_column(2, 2), 0, 7, false);
    for i in 0 to 2 loop
      transform_left_filter_feature_0_choice(8 * i + 136) := is_larger(transform_left_filter_column(1, 2 - i),
        transform_left_filter_column(2, 2), 0, 7, false);
    end loop;
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(16 * i + 160) := is_larger(transform_left_filter_column(0, 3 - i),
        transform_left_filter_column(2, 2), 0, 7, false);
      transform_left_filter_feature_0_choice(16 * i + 168) := is_larger(transform_left_filter_column(0, 4 - 3 * i),
        transform_left_filter_column(2, 2), 0, 7, false);
    end loop;
    for i in 7 to 11 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(0, 0), i - 5);
    end loop;
    transform_left_filter_feature_0_choice(192) := not is_larger(transform_left_filter_column(2, 2),
      transform_left_filter_column(0, 0), 0, 7, true);
    transform_left_filter_feature_0_choice_193 := choice(transform_filtering_0_column_inside(0),
      (as_number(transform_left_filter_feature_0_choice(160)) * 8) +
      (as_number(transform_left_filter_feature_0_choice(168)) * 16) +
      (as_number(transform_left_filter_feature_0_choice(176)) * 4) +
      (as_number(transform_left_filter_feature_0_choice(184)) * 2) +
      as_number(transform_left_filter_feature_0_choice(192)), 0);
    transform_left_filter_feature_0_choice_194 := choice(transform_filtering_0_column_inside(1),
      (as_number(transform_left_filter_feature_0_choice(120)) * 256) +
      (as_number(transform_left_filter_feature_0_choice(128)) * 512) +
      (as_number(transform_left_filter_feature_0_choice(136)) * 128) +
      (as_number(transform_left_filter_feature_0_choice(144)) * 64) +
      (as_number(transform_left_filter_feature_0_choice(152)) * 32) + transform_left_filter_feature_0_choice_193,
      transform_left_filter_feature_0_choice_193);
    transform_left_filter_feature_0_choice_195 := choice(transform_filtering_0_column_inside(2),
      (as_number(transform_left_filter_feature_0_choice(96)) * 2048) +
      (as_number(transform_left_filter_feature_0_choice(104)) * 4096) +
      (as_number(transform_left_filter_feature_0_choice(112)) * 1024) + transform_left_filter_feature_0_choice_194,
      transform_left_filter_feature_0_choice_194);
    transform_left_filter_feature_0_choice_196 := choice(transform_filtering_0_column_inside(3),
      (as_number(transform_left_filter_feature_0_choice(48)) * 16384) +
      (as_number(transform_left_filter_feature_0_choice(56)) * 32768) +
      (as_number(transform_left_filter_feature_0_choice(64)) * 65536) +
      (as_number(transform_left_filter_feature_0_choice(72)) * 131072) +
      (as_number(transform_left_filter_feature_0_choice(80)) * 262144) +
      (as_number(transform_left_filter_feature_0_choice(88)) * 8192) + transform_left_filter_feature_0_choice_195,
      (as_number(transform_left_filter_feature_0_choice(88)) * 8192) + transform_left_filter_feature_0_choice_195);
    transform_right_filter_feature_0_values(1) := is_set(transform_right_filter_column(2, 2), 1);
    transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_values(1)) or (not
      is_set(transform_right_filter_column(2, 2), 0));
    transform_right_filter_feature_0_is_equal := (transform_right_filter_column(2, 2) mod 4) = 0;
    for i in 2 to 6 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(2, 2), i);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 4 loop
        transform_right_filter_feature_0_choice(40 * i + 8 * j + 8) := is_larger(transform_right_filter_column(4 - i,
          j), transform_right_filter_column(2, 2), 0, 7, false);
      end loop;
    end loop;
    transform_right_filter_feature_0_choice(87) := not is_larger(transform_right_filter_column(2, 4),
      transform_right_filter_column(2, 2), 0, 6, false);
    transform_right_filter_feature_0_choice(88) := choice(transform_right_filter_feature_0_choice(87),
      transform_filtering_0_column_inside(2) and is_set(transform_right_filter_column(2, 4), 7) and (not
      is_set(transform_right_filter_column(2, 2), 7)), transform_filtering_0_column_inside(2) and
      (is_set(transform_right_filter_column(2, 4), 7) or (not is_set(transform_right_filter_column(2, 2), 7))));
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(16 * i + 96) := is_larger(transform_right_filter_column(2, 1 - i),
        transform_right_filter_column(2, 2), 0, 7, false);
      transform_right_filter_feature_0_choice(16 * i + 104) := is_larger(transform_right_filter_column(2 - i, 3),
        transform_right_filter_column(2, 2), 0, 7, false);
    end loop;
    transform_right_filter_feature_0_choice(128) := is_larger(transform_right_filter_column(1, 4),
      transform_right_filter_column(2, 2), 0, 7, false);
    for i in 0 to 2 loop
      transform_right_filter_feature_0_choice(8 * i + 136) := is_larger(transform_right_filter_column(1, 2 - i),
        transform_right_filter_column(2, 2), 0, 7, false);
    end loop;
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(16 * i + 160) := is_larger(transform_right_filter_column(0, 3 - i),
        transform_right_filter_column(2, 2), 0, 7, false);
      transform_right_filter_feature_0_choice(16 * i + 168) := is_larger(transform_right_filter_column(0, 4 - 3 * i),
        transform_right_filter_column(2, 2), 0, 7, false);
    end loop;
    for i in 7 to 11 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(0, 0), i - 5);
    end loop;
    transform_right_filter_feature_0_choice(192) := not is_larger(transform_right_filter_column(2, 2),
      transform_right_filter_column(0, 0), 0, 7, true);
    transform_right_filter_feature_0_choice_193 := choice(transform_filtering_0_column_inside(0),
      (as_number(transform_right_filter_feature_0_choice(160)) * 8) +
      (as_number(transform_right_filter_feature_0_choice(168)) * 16) +
      (as_number(transform_right_filter_feature_0_choice(176)) * 4) +
      (as_number(transform_right_filter_feature_0_choice(184)) * 2) +
      as_number(transform_right_filter_feature_0_choice(192)), 0);
    transform_right_filter_feature_0_choice_194 := choice(transform_filtering_0_column_inside(1),
      (as_number(transform_right_filter_feature_0_choice(120)) * 256) +
      (as_number(transform_right_filter_feature_0_choice(128)) * 512) +
      (as_number(transform_right_filter_feature_0_choice(136)) * 128) +
      (as_number(transform_right_filter_feature_0_choice(144)) * 64) +
      (as_number(transform_right_filter_feature_0_choice(152)) * 32) + transform_right_filter_feature_0_choice_193,
      transform_right_filter_feature_0_choice_193);
    transform_right_filter_feature_0_choice_195 := choice(transform_filtering_0_column_inside(2),
      (as_number(transform_right_filter_feature_0_choice(96)) * 2048) +
      (as_number(transform_right_filter_feature_0_choice(104)) * 4096) +
      (as_number(transform_right_filter_feature_0_choice(112)) * 1024) + transform_right_filter_feature_0_choice_194,
      transform_right_filter_feature_0_choice_194);
    transform_right_filter_feature_0_choice_196 := choice(transform_filtering_0_column_inside(3),
      (as_number(transform_right_filter_feature_0_choice(48)) * 16384) +
      (as_number(transform_right_filter_feature_0_choice(56)) * 32768) +
      (as_number(transform_right_filter_feature_0_choice(64)) * 65536) +
      (as_number(transform_right_filter_feature_0_choice(72)) * 131072) +
      (as_number(transform_right_filter_feature_0_choice(80)) * 262144) +
      (as_number(transform_right_filter_feature_0_choice(88)) * 8192) + transform_right_filter_feature_0_choice_195,
      (as_number(transform_right_filter_feature_0_choice(88)) * 8192) + transform_right_filter_feature_0_choice_195);
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
      (transform_counter_group mod 4)) < 12;
    transform_read_row_inside(1) <= (transform_counter_group >= 3) and (transform_counter_group < 15);
    transform_read_row_inside(2) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 12;
    transform_read_row_inside(3) <= (transform_counter_group >= 1) and (transform_counter_group < 13);
    transform_read_row_inside(4) <= (not is_set(transform_counter_group, 3)) or (not is_set(transform_counter_group,
      2));
    transform_read_column_inside(0) <= (((transform_counter_column / 2) mod 16) /= 0) or
      is_set(transform_counter_column, 5);
    transform_read_column_inside(2) <= true;
    transform_read_column_inside(4) <= transform_read_column_inside_1_is_equals(1) /=
      transform_read_column_inside_1_differs;
    transform_read_start_of_frame <= (transform_counter_column = 2) and (transform_counter_group = 2);
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
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice * 4,
      transform_counter_group_choices(3));
    transform_read_column_inside(1) <= choice(transform_read_column_inside_1_is_equals(1),
      transform_read_column_inside_choice(1, 1), transform_read_column_inside_1_differs);
    transform_read_column_inside(3) <= choice(transform_read_column_inside_choice(3, 1),
      transform_read_column_inside_choice(3, 2), transform_read_column_inside_1_differs);
    transform_left_filter_feature_0 <= choice(transform_filtering_0_column_inside(4),
      (as_number(transform_left_filter_feature_0_choice(8)) * 524288) +
      (as_number(transform_left_filter_feature_0_choice(16)) * 1048576) +
      (as_number(transform_left_filter_feature_0_choice(24)) * 2097152) +
      (as_number(transform_left_filter_feature_0_choice(32)) * 4194304) +
      (as_number(transform_left_filter_feature_0_choice(40)) * 8388608) + transform_left_filter_feature_0_choice_196,
      transform_left_filter_feature_0_choice_196);
    transform_right_filter_feature_0 <= choice(transform_filtering_0_column_inside(4),
      (as_number(transform_right_filter_feature_0_choice(8)) * 524288) +
      (as_number(transform_right_filter_feature_0_choice(16)) * 1048576) +
      (as_number(transform_right_filter_feature_0_choice(24)) * 2097152) +
      (as_number(transform_right_filter_feature_0_choice(32)) * 4194304) +
      (as_number(transform_right_filter_feature_0_choice(40)) * 8388608) + transform_right_filter_feature_0_choice_196,
      transform_right_filter_feature_0_choice_196);
    transform_counter_next_frame_choice := choice(in_start_of_frame, transform_counter_group_all,
      transform_counter_next_frame);
    if in_valid then
      transform_counter_column <= choice(transform_counter_group_is_equals(1) or in_start_of_frame, 0,
        (transform_counter_column + 1) mod 64);
      transform_counter_next_frame <= choice(transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(3), transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2) and in_start_of_frame, transform_counter_next_frame_choice);
    end if;
    if transform_ready_valid then
      transform_left_rows_write_words_0 <= to_unsigned(transform_left_rows_ready_newest_0, 8) &
        transform_left_rows_ready_words_0(31 downto 8);
      transform_right_rows_write_words_0 <= to_unsigned(transform_right_rows_ready_newest_0, 8) &
        transform_right_rows_ready_words_0(31 downto 8);
      transform_write_column <= transform_ready_column;
    end if;
    if transform_columns_valid then
      for i in 1 to 4 loop
        for j in 0 to 4 loop transform_left_filter_column(i, j) <= transform_left_filter_column(i - 1, j); end loop;
      end loop;
      for i in 1 to 4 loop
        for j in 0 to 4 loop transform_right_filter_column(i, j) <= transform_right_filter_column(i - 1, j); end loop;
      end loop;
      for i in 0 to 4 loop
        transform_left_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_left_column(i), 0);
        transform_right_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_right_column(i), 0);
      end loop;
    end if;
    -- raster
    raster_place_group_is_equals(1) := raster_place_group = 11;
    raster_place_group_is_equals(2) := raster_place_column = 39;
    raster_place_group_all := raster_place_group_is_equals(1) and raster_place_group_is_equals(2);
    raster_place_group_choice := choice(raster_place_group_all, 3, 0);
    raster_place_group_is_equals(3) := (raster_place_group / 2) = 6;
    raster_place_group_choice_2 := choice(raster_place_group_is_equals(3), raster_place_group_is_equals(2) and
      transform_filtering_valid(1) and (not is_set(raster_place_group, 0)), raster_place_group_is_equals(2) and
      transform_filtering_valid(1));
    raster_place_group_choices(3) := choice(raster_place_next_frame and (raster_place_group = 12), 1,
      (raster_place_group + 1) mod 16);
    raster_place_group_choices(4) := choice(raster_place_group_choice_2, raster_place_group_choices(3),
      raster_place_group);
    raster_place_next_frame_choices(1) := choice(raster_place_group_is_equals(2), raster_place_next_frame and
      is_set(raster_place_group, 0), raster_place_next_frame);
    raster_place_next_frame_choices(2) := choice(raster_place_group_is_equals(3), raster_place_next_frame_choices(1),
      raster_place_next_frame);
    raster_place_next_frame_choices(3) := choice(raster_place_group_all, transform_filtering_valid(1),
      transform_filtering_valid(1) and (not transform_filtering_start_of_frame(1)));
    raster_place_next_frame_choices(4) := choice(raster_place_next_frame_choices(2),
      raster_place_next_frame_choices(3), raster_place_group_is_equals(1) and raster_place_group_is_equals(2) and
      transform_filtering_valid(1) and transform_filtering_start_of_frame(1));
    raster_features_search_0 <= transform_left_filter_feature_0;
    raster_features_reference_0 <= transform_right_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(1);
    raster_place_next_frame <= raster_place_next_frame_choices(4) or ((not transform_filtering_valid(1)) and
      raster_place_next_frame);
    raster_place_group <= choice(transform_filtering_valid(1) and transform_filtering_start_of_frame(1),
      raster_place_group_choice * 4, raster_place_group_choices(4));
    if transform_filtering_valid(1) then
      raster_place_column <= choice(raster_place_group_is_equals(2) or transform_filtering_start_of_frame(1), 0,
        (raster_place_column + 1) mod 64);
    end if;
    -- delay
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 11, 0, (delay_ring_read_address + 1) mod 16);
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
    delay_tag.valid <= raster_features_valid;
    delay_tag.border_column <= (not (is_set(raster_place_column, 3) and (is_set(raster_place_column, 2) or
      ((raster_place_column mod 4) = 3)))) and ((raster_place_column / 16) = 0);
    delay_tag.first_cost <= delay_tag_first_cost_is_equal;
    delay_tag.map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and
      delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
    delay_tag.start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 1);
    delay_tag.end_of_line <= raster_place_group_is_equals(2);
    -- rows
    rows_search_rows_read_newest_0 <= delay_ahead_0;
    rows_search_rows_ready_words(0) <= to_integer(rows_search_rows_read_words(0));
    rows_search_rows_ready_words(1) <= to_integer(rows_search_rows_read_words(1));
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
    rows_reference_rows_ready_words(0) <= to_integer(rows_reference_rows_read_words(0));
    rows_reference_rows_ready_words(1) <= to_integer(rows_reference_rows_read_words(1));
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_tag <= rows_ready_tag;
    rows_search(0) <= choice(rows_ready_inside(0), rows_search_rows_ready_words(0), 0);
    rows_reference(0) <= choice(rows_ready_inside(0), rows_reference_rows_ready_words(0), 0);
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_words(1), 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_words(1), 0);
    rows_search(2) <= choice(rows_ready_inside(2), rows_search_rows_ready_newest_0, 0);
    rows_reference(2) <= choice(rows_ready_inside(2), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words(0) <= rows_search_rows_ready_words(1);
      rows_search_rows_write_words(1) <= rows_search_rows_ready_newest_0;
      rows_reference_rows_write_words(0) <= rows_reference_rows_ready_words(1);
      rows_reference_rows_write_words(1) <= rows_reference_rows_ready_newest_0;
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 2 loop
        slice0shift_search(i, 0) <= slice0shift_search(i, 1);
        slice0shift_search(i, 1) <= slice0shift_search(i, 2);
        slice0shift_search(i, 2) <= slice0shift_search(i, 3);
        slice0shift_search(i, 3) <= slice0shift_search(i, 4);
        slice0shift_search(i, 4) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 0);
    slice0shift_search_out(1) <= slice0shift_search(1, 0);
    slice0shift_search_out(2) <= slice0shift_search(2, 0);
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
      for j in 3 to 7 loop
        slice0cost_pixels_first_count(i, 0, j) <= differing(slice0shift_reference(i), slice0shift_search(i, 0), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 4 loop
        slice0cost_pixels_first_count(i, j, 0) <= differing(slice0shift_search(i, j), slice0shift_reference(i), 0, 2,
          1);
        slice0cost_pixels_first_count(i, j, 1) <= differing(slice0shift_search(i, j), slice0shift_reference(i), 3, 5,
          4);
        slice0cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice0shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice0shift_reference(i) mod 256), 8)))) / 128) + differing(slice0shift_search(i, j),
          slice0shift_reference(i), 8) + differing(slice0shift_search(i, j), slice0shift_reference(i), 6);
        for k in 3 to 7 loop
          slice0cost_pixels_first_count(i, j, k) <= differing(slice0shift_search(i, j), slice0shift_reference(i), 3 *
            k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 2 loop
      for j in 0 to 4 loop
        slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 0) + slice0cost_pixels_first_count(i, j, 2)
          + slice0cost_pixels_first_count(i, j, 3) + slice0cost_pixels_first_count(i, j, 5) +
          slice0cost_pixels_first_count(i, j, 6) + slice0cost_pixels_first_count(i, j, 4) +
          slice0cost_pixels_first_count(i, j, 7) + slice0cost_pixels_first_count(i, j, 1);
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    for i in 0 to 4 loop slice0cost_pair_0(i) <= slice0cost_pixels_cost(1, i) + slice0cost_pixels_cost(2, i); end loop;
    for i in 0 to 4 loop slice0cost_single_0(i) <= slice0cost_pixels_cost(0, i); end loop;
    slice0cost_pair_tag <= slice0cost_pixels_tag;
    slice0cost_tag <= slice0cost_pair_tag;
    for i in 0 to 4 loop
      slice0cost_column_0(i) <= choice(slice0cost_pair_tag.border_column, 0, slice0cost_pair_0(i) +
        slice0cost_single_0(i));
    end loop;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_partial_0_0 <= slice0cost_column_0;
      for i in 0 to 4 loop
        slice0window_partial_0_1(i) <= slice0cost_column_0(i) + slice0window_partial_0_0(i);
      end loop;
      slice0window_centre_map_column_0 <= slice0cost_tag.map_column;
      slice0window_centre_output_column_0 <= slice0cost_tag.output_column;
      slice0window_centre_first_column_0 <= slice0cost_tag.first_cost;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag.start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag.end_of_line;
    end if;
    for i in 0 to 4 loop slice0window_sum_0(i) <= slice0cost_column_0(i) + slice0window_partial_0_1(i); end loop;
    slice0window_tag.valid <= slice0cost_tag.valid;
    slice0window_tag.map_column <= slice0window_centre_map_column_0;
    slice0window_tag.output_column <= slice0window_centre_output_column_0;
    slice0window_tag.first_column <= slice0window_centre_first_column_0;
    slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame_0;
    slice0window_tag.end_of_line <= slice0window_centre_end_of_line_0;
    -- slice0
    for i in 0 to 4 loop slice0_held(0, i) <= slice0window_sum_0(i) / 16; end loop;
    for i in 0 to 4 loop slice0_held(1, i) <= slice0_held(0, i); end loop;
    for i in 0 to 4 loop slice0_held(2, i) <= slice0_held(1, i); end loop;
    slice0_tag_valid(0) <= slice0window_tag.valid;
    slice0_tag_map_column(0) <= slice0window_tag.map_column;
    slice0_tag_output_column(0) <= slice0window_tag.output_column;
    slice0_tag_first_column(0) <= slice0window_tag.first_column;
    slice0_tag_start_of_frame(0) <= slice0window_tag.start_of_frame;
    slice0_tag_end_of_line(0) <= slice0window_tag.end_of_line;
    for i in 1 to 2 loop
      slice0_tag_valid(i) <= slice0_tag_valid(i - 1);
      slice0_tag_map_column(i) <= slice0_tag_map_column(i - 1);
      slice0_tag_output_column(i) <= slice0_tag_output_column(i - 1);
      slice0_tag_first_column(i) <= slice0_tag_first_column(i - 1);
      slice0_tag_start_of_frame(i) <= slice0_tag_start_of_frame(i - 1);
      slice0_tag_end_of_line(i) <= slice0_tag_end_of_line(i - 1);
    end loop;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 2 loop
        slice1shift_search(i, 0) <= slice1shift_search(i, 1);
        slice1shift_search(i, 1) <= slice1shift_search(i, 2);
        slice1shift_search(i, 2) <= slice1shift_search(i, 3);
        slice1shift_search(i, 3) <= slice1shift_search(i, 4);
        slice1shift_search(i, 4) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    slice1shift_search_out(0) <= slice1shift_search(0, 0);
    slice1shift_search_out(1) <= slice1shift_search(1, 0);
    slice1shift_search_out(2) <= slice1shift_search(2, 0);
    -- slice1cost
    for i in 0 to 2 loop
      slice1cost_pixels_first_count(i, 0, 0) <= differing(slice1shift_search(i, 0), slice1shift_reference(i), 0) +
        differing(slice1shift_reference(i), slice1shift_search(i, 0), 2) + differing(slice1shift_reference(i),
        slice1shift_search(i, 0), 1);
      slice1cost_pixels_first_count(i, 0, 1) <= differing(slice1shift_reference(i), slice1shift_search(i, 0), 3, 5, 4);
      slice1cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice1shift_search(i, 0) mod 256), 8)) xor
        (to_unsigned((slice1shift_reference(i) mod 256), 8)))) / 128) + differing(slice1shift_reference(i),
        slice1shift_search(i, 0), 8) + differing(slice1shift_reference(i), slice1shift_search(i, 0), 6);
      for j in 3 to 7 loop
        slice1cost_pixels_first_count(i, 0, j) <= differing(slice1shift_reference(i), slice1shift_search(i, 0), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 4 loop
        slice1cost_pixels_first_count(i, j, 0) <= differing(slice1shift_search(i, j), slice1shift_reference(i), 0, 2,
          1);
        slice1cost_pixels_first_count(i, j, 1) <= differing(slice1shift_search(i, j), slice1shift_reference(i), 3, 5,
          4);
        slice1cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice1shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice1shift_reference(i) mod 256), 8)))) / 128) + differing(slice1shift_search(i, j),
          slice1shift_reference(i), 8) + differing(slice1shift_search(i, j), slice1shift_reference(i), 6);
        for k in 3 to 7 loop
          slice1cost_pixels_first_count(i, j, k) <= differing(slice1shift_search(i, j), slice1shift_reference(i), 3 *
            k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 4 loop
        slice1cost_pixels_cost(i, j) <= slice1cost_pixels_first_count(i, j, 0) + slice1cost_pixels_first_count(i, j, 2)
          + slice1cost_pixels_first_count(i, j, 3) + slice1cost_pixels_first_count(i, j, 5) +
          slice1cost_pixels_first_count(i, j, 6) + slice1cost_pixels_first_count(i, j, 4) +
          slice1cost_pixels_first_count(i, j, 7) + slice1cost_pixels_first_count(i, j, 1);
      end loop;
    end loop;
    for i in 0 to 4 loop slice1cost_pair_0(i) <= slice1cost_pixels_cost(1, i) + slice1cost_pixels_cost(2, i); end loop;
    for i in 0 to 4 loop slice1cost_single_0(i) <= slice1cost_pixels_cost(0, i); end loop;
    slice1cost_tag_border_column <= slice0cost_tag.border_column;
    for i in 0 to 4 loop
      slice1cost_column_0(i) <= choice(slice0cost_tag.border_column, 0, slice1cost_pair_0(i) + slice1cost_single_0(i));
    end loop;
    -- slice1window
    if slice0window_tag.valid then
      slice1window_partial_0_0 <= slice1cost_column_0;
      for i in 0 to 4 loop
        slice1window_partial_0_1(i) <= slice1cost_column_0(i) + slice1window_partial_0_0(i);
      end loop;
    end if;
    for i in 0 to 4 loop slice1window_sum_0(i) <= slice1cost_column_0(i) + slice1window_partial_0_1(i); end loop;
    -- slice1
    for i in 0 to 4 loop slice1_held(0, i) <= slice1window_sum_0(i) / 16; end loop;
    for i in 0 to 4 loop slice1_held(1, i) <= slice1_held(0, i); end loop;
    -- slice2shift
    if slice0cost_pixels_first_tag.valid then
      for i in 0 to 2 loop
        slice2shift_search(i, 0) <= slice2shift_search(i, 1);
        slice2shift_search(i, 1) <= slice1shift_search_out(i);
      end loop;
    end if;
    slice2shift_reference <= slice1shift_reference;
    -- slice2cost
    for i in 0 to 2 loop
      slice2cost_pixels_first_count(i, 0, 0) <= differing(slice2shift_search(i, 0), slice2shift_reference(i), 0) +
        differing(slice2shift_reference(i), slice2shift_search(i, 0), 2) + differing(slice2shift_reference(i),
        slice2shift_search(i, 0), 1);
      slice2cost_pixels_first_count(i, 0, 1) <= differing(slice2shift_reference(i), slice2shift_search(i, 0), 3, 5, 4);
      slice2cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, 0) mod 256), 8)) xor
        (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) + differing(slice2shift_reference(i),
        slice2shift_search(i, 0), 8) + differing(slice2shift_reference(i), slice2shift_search(i, 0), 6);
      for j in 3 to 7 loop
        slice2cost_pixels_first_count(i, 0, j) <= differing(slice2shift_reference(i), slice2shift_search(i, 0), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
      slice2cost_pixels_first_count(i, 1, 0) <= differing(slice2shift_search(i, 1), slice2shift_reference(i), 0, 2, 1);
      slice2cost_pixels_first_count(i, 1, 1) <= differing(slice2shift_search(i, 1), slice2shift_reference(i), 3, 5, 4);
      slice2cost_pixels_first_count(i, 1, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, 1) mod 256), 8)) xor
        (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) + differing(slice2shift_search(i, 1),
        slice2shift_reference(i), 8) + differing(slice2shift_search(i, 1), slice2shift_reference(i), 6);
      for j in 3 to 7 loop
        slice2cost_pixels_first_count(i, 1, j) <= differing(slice2shift_search(i, 1), slice2shift_reference(i), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
    end loop;
    for i in 0 to 2 loop
      slice2cost_pixels_cost(i, 0) <= slice2cost_pixels_first_count(i, 0, 0) + slice2cost_pixels_first_count(i, 0, 2) +
        slice2cost_pixels_first_count(i, 0, 3) + slice2cost_pixels_first_count(i, 0, 5) +
        slice2cost_pixels_first_count(i, 0, 6) + slice2cost_pixels_first_count(i, 0, 4) +
        slice2cost_pixels_first_count(i, 0, 7) + slice2cost_pixels_first_count(i, 0, 1);
      slice2cost_pixels_cost(i, 1) <= slice2cost_pixels_first_count(i, 1, 0) + slice2cost_pixels_first_count(i, 1, 2) +
        slice2cost_pixels_first_count(i, 1, 3) + slice2cost_pixels_first_count(i, 1, 5) +
        slice2cost_pixels_first_count(i, 1, 6) + slice2cost_pixels_first_count(i, 1, 4) +
        slice2cost_pixels_first_count(i, 1, 7) + slice2cost_pixels_first_count(i, 1, 1);
    end loop;
    slice2cost_pair_0(0) <= slice2cost_pixels_cost(1, 0) + slice2cost_pixels_cost(2, 0);
    slice2cost_pair_0(1) <= slice2cost_pixels_cost(1, 1) + slice2cost_pixels_cost(2, 1);
    slice2cost_single_0(0) <= slice2cost_pixels_cost(0, 0);
    slice2cost_single_0(1) <= slice2cost_pixels_cost(0, 1);
    slice2cost_column_0(0) <= choice(slice1cost_tag_border_column, 0, slice2cost_pair_0(0) + slice2cost_single_0(0));
    slice2cost_column_0(1) <= choice(slice1cost_tag_border_column, 0, slice2cost_pair_0(1) + slice2cost_single_0(1));
    -- slice2window
    if slice0_tag_valid(0) then
      slice2window_partial_0_0 <= slice2cost_column_0;
      slice2window_partial_0_1(0) <= slice2cost_column_0(0) + slice2window_partial_0_0(0);
      slice2window_partial_0_1(1) <= slice2cost_column_0(1) + slice2window_partial_0_0(1);
    end if;
    slice2window_sum_0(0) <= slice2cost_column_0(0) + slice2window_partial_0_1(0);
    slice2window_sum_0(1) <= slice2cost_column_0(1) + slice2window_partial_0_1(1);
    -- slice2
    slice2_held_0(0) <= slice2window_sum_0(0) / 16;
    slice2_held_0(1) <= slice2window_sum_0(1) / 16;
    -- entry
    entry_order_falls_any := entry_order_inside or (not slice0_tag_map_column(2)) or (not slice0_tag_valid(2));
    entry_order_falls_all := (not entry_order_inside) and slice0_tag_map_column(2) and slice0_tag_valid(2);
    entry_order_complete_all := slice0_tag_map_column(2) and slice0_tag_valid(2);
    entry_order_complete_any := (not slice0_tag_map_column(2)) or (not slice0_tag_valid(2));
    entry_order_turned_output_column_choice := choice(entry_order_falls_all, entry_order_output and
      entry_order_complete, entry_order_held_output);
    entry_next_cost(0) <= slice2_held_0(0);
    entry_next_cost(1) <= slice2_held_0(1);
    for i in 2 to 6 loop entry_next_cost(i) <= slice1_held(1, i - 2); end loop;
    for i in 7 to 11 loop entry_next_cost(i) <= slice0_held(2, i - 7); end loop;
    entry_next_tag.valid <= slice0_tag_valid(2);
    entry_next_tag.map_column <= slice0_tag_map_column(2);
    entry_next_tag.first_column <= slice0_tag_first_column(2);
    entry_next_tag.end_of_line <= slice0_tag_end_of_line(2);
    entry_order_turned_output_column <= entry_order_turned_output_column_choice and slice0_tag_map_column(2);
    entry_order_turned_first_column <= entry_order_falls_all;
    entry_order_turned_start_of_frame <= (not entry_order_inside) and slice0_tag_map_column(2) and slice0_tag_valid(2)
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
    entry_order_complete <= choice(slice0_tag_end_of_line(2), entry_order_complete or entry_order_complete_all,
      entry_order_complete and entry_order_complete_any);
    if entry_order_complete_all then
      entry_next_column <= choice(slice0_tag_first_column(2), 0, (entry_next_column + 1) mod 32);
      entry_next_top <= choice(slice0_tag_first_column(2), slice0_tag_start_of_frame(2), entry_next_top);
    end if;
    entry_order_address_choice := choice(entry_order_falls, 31, 1);
    entry_order_address_choice_2 := choice(entry_order_falls, 0, 7);
    if not entry_order_complete_any then
      entry_order_address <= choice(entry_order_falls_any, (entry_order_address_choice + entry_order_address) mod 32,
        entry_order_address_choice_2 * 4);
    end if;
    if slice0_tag_valid(2) then entry_order_inside <= slice0_tag_map_column(2); end if;
    if entry_order_falls_all then
      entry_order_output <= slice0_tag_output_column(2);
      entry_order_first <= slice0_tag_start_of_frame(2);
      entry_order_held_output <= entry_order_output and entry_order_complete;
    end if;
    -- forward
    for i in 0 to 2 loop
      forward_left_pair_choice(2 * i) := smaller(forward_left_cost(4 * i + 2), forward_left_cost(4 * i));
      forward_left_pair_choice(2 * i + 1) := smaller(forward_left_cost(4 * i + 3), forward_left_cost(4 * i + 1));
    end loop;
    forward_left_start_cost_0_value := (((forward_left_tree_next_next_smallest_0 mod 32) + forward_left_room) / 32) = 1;
    forward_left_start_cost_0_choices(1) := choice(forward_left_start_cost_0_value,
      (((as_number(forward_left_start_cost_0_value) + 7) mod 8) * 32) + ((forward_left_tree_next_next_smallest_0 +
      forward_left_room) mod 32), 0);
    forward_left_start_cost_0_choices(2) := choice(is_set(forward_left_tree_next_next_smallest_0, 5),
      forward_left_room, forward_left_start_cost_0_choices(1));
    forward_left_room_choices(1) := choice(forward_left_start_cost_0_value, (0 -
      forward_left_tree_next_next_smallest_0) mod 32, forward_left_room);
    forward_left_room_choices(2) := choice(is_set(forward_left_tree_next_next_smallest_0, 5), 0,
      forward_left_room_choices(1));
    for i in 0 to 11 loop
      forward_left_cost_choice(i, 1) := smaller(forward_left_arrived(i), forward_left_cost(i));
      forward_left_cost_choice(i, 2) := choice(is_set(forward_left_cost_choice(i, 1), 5) or forward_left_first(2), 32,
        forward_left_cost_choice(i, 1));
    end loop;
    forward_left_arrived_choice(0, 1) := choice(forward_left_first(2), 32, forward_left_cost(1));
    for i in 0 to 1 loop
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
    forward_left_arrived_choice(9, 1) := choice(forward_left_first(2), 32, forward_left_pair_choice(4));
    forward_left_arrived_choice(10, 1) := choice(forward_left_first(2), 32, forward_left_pair_choice(5));
    forward_left_arrived_choice(11, 1) := choice(forward_left_first(2), 32, forward_left_cost(10));
    for i in 0 to 1 loop
      for j in 0 to 5 loop
        forward_above_total_choice(6 * i + j) := choice(forward_above_ready_top, 22,
          to_integer(forward_above_ready_words(i)(5 * j + 4 downto 5 * j)));
      end loop;
    end loop;
    if entry_tag.valid then
      forward_smallest_next_next_smallest(1) <= forward_smallest_next_smallest(2);
      forward_cost_delay_ring_write_address <= forward_cost_delay_ring_read_address;
      forward_left_pair <= forward_left_pair_choice;
      forward_left_tree_next_smallest(1) <= forward_left_tree_smallest(2);
      forward_left_smallest <= forward_smallest_next_next_next_smallest_0;
      forward_left_smallest_less <= (forward_smallest_next_next_next_smallest_0 + 59) mod 64;
      forward_left_first(0) <= sums_right_first(2);
      forward_left_first(1 to 2) <= forward_left_first(0 to 1);
      forward_left_g_copy_0 <= (forward_left_start_cost(0) + forward_smallest_cost(0)) mod 64;
      forward_left_g_less_copy_0 <= (forward_left_start_cost(0) + forward_left_smallest_less) mod 64;
      for i in 0 to 11 loop
        forward_left_stay_change(i) <= (forward_cost(0, i) - forward_left_g_copy_0) mod 64;
      end loop;
      for i in 0 to 11 loop
        forward_left_step_change(i) <= (forward_cost(0, i) - forward_left_g_less_copy_0) mod 64;
      end loop;
      for i in 0 to 11 loop
        forward_left_cost(i) <= (forward_left_cost_choice(i, 2) + forward_left_stay_change(i)) mod 64;
      end loop;
      for i in 0 to 2 loop
        forward_left_arrived(i) <= (forward_left_arrived_choice(i, 1) + forward_left_step_change(i)) mod 64;
      end loop;
      for i in 1 to 2 loop
        forward_left_arrived(3 * i) <= (forward_left_arrived_choice(3 * i, 3 - i) + forward_left_step_change(3 * i))
          mod 64;
        forward_left_arrived(3 * i + 1) <= (forward_left_arrived_choice(3 * i + 1, 2) + forward_left_step_change(3 * i
          + 1)) mod 64;
        forward_left_arrived(3 * i + 2) <= (forward_left_arrived_choice(3 * i + 2, i) + forward_left_step_change(3 * i
          + 2)) mod 64;
      end loop;
      for i in 9 to 11 loop
        forward_left_arrived(i) <= (forward_left_arrived_choice(i, 1) + forward_left_step_change(i)) mod 64;
      end loop;
      forward_above_ready_words <= forward_above_read_words;
      forward_above_ready_cost <= entry_cost;
      forward_above_ready_top <= entry_top;
      for i in 0 to 11 loop
        forward_above_total(i) <= forward_above_total_choice(i) + forward_above_ready_cost(i);
      end loop;
      forward_above_tree_next_next_smallest(1) <= forward_above_tree_next_smallest(2);
      forward_above_delay_ring_write_address <= forward_above_delay_ring_read_address;
      forward_above_smallest_copy_0 <= forward_above_tree_next_next_next_smallest_0;
      for i in 0 to 1 loop
        forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy_0) mod 64;
        forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
          forward_above_smallest_copy_0) mod 64;
        forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
          forward_above_smallest_copy_0) mod 64;
        forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
          forward_above_smallest_copy_0) mod 64;
        forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
          forward_above_smallest_copy_0) mod 64;
      end loop;
      forward_above_cost(10) <= (to_integer(forward_above_delay_held_2) - forward_above_smallest_copy_0) mod 64;
      forward_above_cost(11) <= (to_integer(forward_above_delay_held_2(11 downto 6)) - forward_above_smallest_copy_0)
        mod 64;
      forward_above_beside(0) <= forward_above_cost(1);
      forward_above_beside(11) <= forward_above_cost(10);
      forward_above_own_0 <= forward_above_cost(0);
      forward_above_own <= forward_above_cost(2 to 9);
      forward_above_own_11 <= forward_above_cost(11);
      for i in 0 to 11 loop forward_above_step(i) <= forward_above_beside(i) + 5; end loop;
      forward_above_comes(0) <= entry_tag.map_column;
      forward_above_comes(1 to 9) <= forward_above_comes(0 to 8);
      forward_above_column(0) <= entry_column;
      forward_above_column(1 to 9) <= forward_above_column(0 to 8);
      for i in 0 to 11 loop forward_sum(i) <= forward_left_cost(i) + forward_above_cost(i); end loop;
      forward_first(0) <= entry_turned_first_column;
      forward_first(1 to 3) <= forward_first(0 to 2);
      forward_cost(0, 0) <= to_integer(forward_cost_delay_held_0(3 downto 0));
      forward_cost(0, 1) <= to_integer(forward_cost_delay_held_0(7 downto 0)) / 16;
      for i in 2 to 7 loop
        forward_cost(0, i) <= to_integer(forward_cost_delay_held_0(4 * i + 3 downto 4 * i));
      end loop;
      forward_cost(0, 8) <= to_integer(forward_cost_delay_held_1(3 downto 0));
      forward_cost(0, 9) <= to_integer(forward_cost_delay_held_1(7 downto 0)) / 16;
      forward_cost(0, 10) <= to_integer(forward_cost_delay_held_1(11 downto 8));
      forward_cost(0, 11) <= to_integer(forward_cost_delay_held_1(15 downto 12));
      for i in 1 to 3 loop
        for j in 0 to 11 loop forward_cost(i, j) <= forward_cost(i - 1, j); end loop;
      end loop;
      forward_smallest_cost(0) <= forward_smallest_next_next_next_smallest_0;
      forward_smallest_cost(1) <= forward_left_smallest;
      forward_smallest_cost(2 to 4) <= forward_smallest_cost(1 to 3);
      for i in 0 to 5 loop forward_smallest_smallest(i) <= smaller(entry_cost(2 * i + 1), entry_cost(2 * i)); end loop;
      for i in 0 to 2 loop
        forward_smallest_next_smallest(i) <= smaller(forward_smallest_smallest(2 * i + 1), forward_smallest_smallest(2
          * i));
      end loop;
      forward_smallest_next_next_smallest(0) <= smaller(forward_smallest_next_smallest(1),
        forward_smallest_next_smallest(0));
      forward_smallest_next_next_next_smallest_0 <= smaller(forward_smallest_next_next_smallest(1),
        forward_smallest_next_next_smallest(0));
      forward_cost_delay_ring_read_address <= choice(forward_cost_delay_ring_read_address = 4, 0,
        (forward_cost_delay_ring_read_address + 1) mod 8);
      forward_left_tree_smallest(0) <= smaller(forward_left_pair(1), forward_left_pair(0));
      forward_left_tree_smallest(1) <= smaller(forward_left_pair(3), forward_left_pair(2));
      forward_left_tree_smallest(2) <= smaller(forward_left_pair(5), forward_left_pair(4));
      forward_left_tree_next_smallest(0) <= smaller(forward_left_tree_smallest(1), forward_left_tree_smallest(0));
      forward_left_tree_next_next_smallest_0 <= smaller(forward_left_tree_next_smallest(1),
        forward_left_tree_next_smallest(0));
      forward_left_start_cost(0) <= choice(sums_right_first(2), 22, forward_left_start_cost_0_choices(2));
      for i in 1 to 6 loop
        forward_left_start_cost(i) <= choice(sums_right_first(2), 0, forward_left_start_cost(i - 1));
      end loop;
      forward_left_room <= choice(sums_right_first(2), 0, (forward_left_room_choices(2) + forward_left_start_cost(6))
        mod 32);
      for i in 0 to 5 loop
        forward_above_tree_smallest(i) <= smaller(forward_above_total(2 * i + 1), forward_above_total(2 * i));
      end loop;
      for i in 0 to 2 loop
        forward_above_tree_next_smallest(i) <= smaller(forward_above_tree_smallest(2 * i + 1),
          forward_above_tree_smallest(2 * i));
      end loop;
      forward_above_tree_next_next_smallest(0) <= smaller(forward_above_tree_next_smallest(1),
        forward_above_tree_next_smallest(0));
      forward_above_tree_next_next_next_smallest_0 <= smaller(forward_above_tree_next_next_smallest(1),
        forward_above_tree_next_next_smallest(0));
      forward_above_delay_ring_read_address <= choice(forward_above_delay_ring_read_address = 4, 0,
        (forward_above_delay_ring_read_address + 1) mod 8);
      for i in 1 to 10 loop
        forward_above_beside(i) <= smaller(forward_above_cost(i + 1), forward_above_cost(i - 1));
      end loop;
      forward_above_stay(0) <= choice(forward_above_own_0 < 22, forward_above_own_0 mod 32, 22);
      forward_above_stay(1) <= choice(forward_above_beside(0) < 22, forward_above_beside(0) mod 32, 22);
      for i in 2 to 9 loop
        forward_above_stay(i) <= choice(forward_above_own(i) < 22, forward_above_own(i) mod 32, 22);
      end loop;
      forward_above_stay(10) <= choice(forward_above_beside(11) < 22, forward_above_beside(11) mod 32, 22);
      forward_above_stay(11) <= choice(forward_above_own_11 < 22, forward_above_own_11 mod 32, 22);
    end if;
    forward_above_writes_copy_0 <= choice(forward_above_comes(9), entry_next_tag.valid and (forward_above_comes(8) or
      (not entry_tag.valid)), entry_next_tag.valid and forward_above_comes(8) and entry_tag.valid);
    for i in 0 to 1 loop
      forward_above_write_words_choice(i, 1) := smaller(forward_above_step(6 * i + 4), forward_above_stay(6 * i + 4));
      forward_above_write_words_choice(i, 2) := smaller(forward_above_step(6 * i + 5), forward_above_stay(6 * i + 5));
      forward_above_write_words_choice(i, 3) := smaller(forward_above_step(6 * i + 3), forward_above_stay(6 * i + 3));
      forward_above_write_words_choice(i, 4) := smaller(forward_above_step(6 * i + 2), forward_above_stay(6 * i + 2));
      forward_above_write_words_choice(i, 5) := smaller(forward_above_step(6 * i), forward_above_stay(6 * i));
      forward_above_write_words_choice(i, 6) := smaller(forward_above_step(6 * i + 1), forward_above_stay(6 * i + 1));
    end loop;
    if forward_above_writes_copy_0 then
      for i in 0 to 1 loop
        forward_above_write_words(i) <= ((((((((((to_unsigned(forward_above_write_words_choice(i, 1), 12) &
          to_unsigned(0, 20)) or (to_unsigned(forward_above_write_words_choice(i, 2), 7) & to_unsigned(0, 25)))) or
          (to_unsigned(forward_above_write_words_choice(i, 3), 17) & to_unsigned(0, 15)))) or
          (to_unsigned(forward_above_write_words_choice(i, 4), 22) & to_unsigned(0, 10)))) or
          (to_unsigned(forward_above_write_words_choice(i, 5), 32)))) or
          (to_unsigned(forward_above_write_words_choice(i, 6), 27) & to_unsigned(0, 5)));
      end loop;
      forward_above_write_column <= forward_above_column(9);
    end if;
    -- sums
    for i in 0 to 2 loop
      sums_right_pair_choice(2 * i) := smaller(sums_right_cost(4 * i + 2), sums_right_cost(4 * i));
      sums_right_pair_choice(2 * i + 1) := smaller(sums_right_cost(4 * i + 3), sums_right_cost(4 * i + 1));
    end loop;
    sums_right_start_cost_0_value := (((sums_right_tree_next_next_smallest_0 mod 32) + sums_right_room) / 32) = 1;
    sums_right_start_cost_0_choices(1) := choice(sums_right_start_cost_0_value,
      (((as_number(sums_right_start_cost_0_value) + 7) mod 8) * 32) + ((sums_right_tree_next_next_smallest_0 +
      sums_right_room) mod 32), 0);
    sums_right_start_cost_0_choices(2) := choice(is_set(sums_right_tree_next_next_smallest_0, 5), sums_right_room,
      sums_right_start_cost_0_choices(1));
    sums_right_room_choices(1) := choice(sums_right_start_cost_0_value, (0 - sums_right_tree_next_next_smallest_0) mod
      32, sums_right_room);
    sums_right_room_choices(2) := choice(is_set(sums_right_tree_next_next_smallest_0, 5), 0,
      sums_right_room_choices(1));
    for i in 0 to 11 loop
      sums_right_cost_choice(i, 1) := smaller(sums_right_arrived(i), sums_right_cost(i));
      sums_right_cost_choice(i, 2) := choice(is_set(sums_right_cost_choice(i, 1), 5) or forward_first(3), 32,
        sums_right_cost_choice(i, 1));
    end loop;
    sums_right_arrived_choice(0, 1) := choice(forward_first(3), 32, sums_right_cost(1));
    for i in 0 to 1 loop
      sums_right_arrived_choice(4 * i + 1, 1) := choice(forward_first(3), 32, sums_right_pair_choice(2 * i));
      sums_right_arrived_choice(4 * i + 2, 1) := choice(forward_first(3), 32, sums_right_pair_choice(2 * i + 1));
      sums_right_arrived_choice(4 * i + 3, 1) := smaller(sums_right_cost(4 * i + 4), sums_right_cost(4 * i + 2));
      sums_right_arrived_choice(4 * i + 3, 2) := choice(forward_first(3), 32, sums_right_arrived_choice(4 * i + 3, 1));
      sums_right_arrived_choice(4 * i + 4, 1) := smaller(sums_right_cost(4 * i + 5), sums_right_cost(4 * i + 3));
      sums_right_arrived_choice(4 * i + 4, 2) := choice(forward_first(3), 32, sums_right_arrived_choice(4 * i + 4, 1));
    end loop;
    sums_right_arrived_choice(9, 1) := choice(forward_first(3), 32, sums_right_pair_choice(4));
    sums_right_arrived_choice(10, 1) := choice(forward_first(3), 32, sums_right_pair_choice(5));
    sums_right_arrived_choice(11, 1) := choice(forward_first(3), 32, sums_right_cost(10));
    if entry_tag.valid then
      sums_turn_ready_sums(0) <= to_integer(sums_turn_read_sums(0));
      sums_turn_ready_sums(1) <= to_integer(sums_turn_read_sums(1));
      sums_turn_ready_sums(2) <= to_integer(sums_turn_read_sums(2));
      sums_turn_ready_costs_0 <= sums_turn_read_costs_0;
      sums_turn_ready_costs_1 <= to_integer(sums_turn_read_costs_1);
      sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
      sums_turn_ready_first <= entry_tag.first_column;
      sums_turn_place(0) <= entry_place;
      sums_turn_place(1 to 8) <= sums_turn_place(0 to 7);
      sums_cost(0, 0) <= to_integer(sums_turn_ready_costs_0(3 downto 0));
      sums_cost(0, 1) <= to_integer(sums_turn_ready_costs_0(7 downto 0)) / 16;
      for i in 2 to 7 loop sums_cost(0, i) <= to_integer(sums_turn_ready_costs_0(4 * i + 3 downto 4 * i)); end loop;
      sums_cost(0, 8) <= sums_turn_ready_costs_1 mod 16;
      sums_cost(0, 9) <= (sums_turn_ready_costs_1 mod 256) / 16;
      sums_cost(0, 10) <= (sums_turn_ready_costs_1 / 256) mod 16;
      sums_cost(0, 11) <= sums_turn_ready_costs_1 / 4096;
      for i in 0 to 11 loop sums_cost(1, i) <= sums_cost(0, i); end loop;
      sums_right_pair <= sums_right_pair_choice;
      sums_right_tree_next_smallest(1) <= sums_right_tree_smallest(2);
      sums_right_smallest <= sums_turn_ready_smallest_0;
      sums_right_smallest_less <= (sums_turn_ready_smallest_0 + 59) mod 64;
      sums_right_first(0) <= sums_turn_ready_first;
      sums_right_first(1 to 2) <= sums_right_first(0 to 1);
      sums_right_g_copy_0 <= (sums_right_start_cost(0) + sums_right_smallest) mod 64;
      sums_right_g_less_copy_0 <= (sums_right_start_cost(0) + sums_right_smallest_less) mod 64;
      for i in 0 to 11 loop sums_right_stay_change(i) <= (sums_cost(1, i) - sums_right_g_copy_0) mod 64; end loop;
      for i in 0 to 11 loop sums_right_step_change(i) <= (sums_cost(1, i) - sums_right_g_less_copy_0) mod 64; end loop;
      for i in 0 to 11 loop
        sums_right_cost(i) <= (sums_right_cost_choice(i, 2) + sums_right_stay_change(i)) mod 64;
      end loop;
      for i in 1 to 2 loop
        sums_right_arrived(6 * i - 6) <= (sums_right_arrived_choice(6 * i - 6, 1) + sums_right_step_change(6 * i - 6))
          mod 64;
        sums_right_arrived(6 * i - 5) <= (sums_right_arrived_choice(6 * i - 5, i) + sums_right_step_change(6 * i - 5))
          mod 64;
        sums_right_arrived(6 * i - 4) <= (sums_right_arrived_choice(6 * i - 4, i) + sums_right_step_change(6 * i - 4))
          mod 64;
        sums_right_arrived(6 * i - 3) <= (sums_right_arrived_choice(6 * i - 3, 3 - i) + sums_right_step_change(6 * i -
          3)) mod 64;
        sums_right_arrived(6 * i - 2) <= (sums_right_arrived_choice(6 * i - 2, 3 - i) + sums_right_step_change(6 * i -
          2)) mod 64;
        sums_right_arrived(6 * i - 1) <= (sums_right_arrived_choice(6 * i - 1, 1) + sums_right_step_change(6 * i - 1))
          mod 64;
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
      sums_right_tree_smallest(0) <= smaller(sums_right_pair(1), sums_right_pair(0));
      sums_right_tree_smallest(1) <= smaller(sums_right_pair(3), sums_right_pair(2));
      sums_right_tree_smallest(2) <= smaller(sums_right_pair(5), sums_right_pair(4));
      sums_right_tree_next_smallest(0) <= smaller(sums_right_tree_smallest(1), sums_right_tree_smallest(0));
      sums_right_tree_next_next_smallest_0 <= smaller(sums_right_tree_next_smallest(1),
        sums_right_tree_next_smallest(0));
      sums_right_start_cost(0) <= choice(forward_first(0), 22, sums_right_start_cost_0_choices(2));
      for i in 1 to 6 loop
        sums_right_start_cost(i) <= choice(forward_first(0), 0, sums_right_start_cost(i - 1));
      end loop;
      sums_right_room <= choice(forward_first(0), 0, (sums_right_room_choices(2) + sums_right_start_cost(6)) mod 32);
      sums_sum_delay_ring_read_address <= choice(sums_sum_delay_ring_read_address = 3, 0,
        (sums_sum_delay_ring_read_address + 1) mod 4);
    end if;
    sums_turn_writes_copy_0_choice := choice(entry_tag.valid, forward_above_comes(7), forward_above_comes(8));
    sums_turn_writes_copy_0 <= entry_next_tag.valid and sums_turn_writes_copy_0_choice;
    for i in 0 to 2 loop
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
      for i in 0 to 2 loop
        sums_turn_write_sums(i) <= (forward_sum(4 * i + 2) * 16384) + (forward_sum(4 * i + 3) * 2097152) +
          forward_sum(4 * i) + (forward_sum(4 * i + 1) * 128);
      end loop;
      sums_turn_write_costs_0 <= to_unsigned(forward_cost(3, 7), 4) & to_unsigned(forward_cost(3, 6), 4) &
        to_unsigned(forward_cost(3, 5), 4) & to_unsigned(forward_cost(3, 4), 4) & to_unsigned(forward_cost(3, 3), 4) &
        to_unsigned(forward_cost(3, 2), 4) & to_unsigned(forward_cost(3, 1), 4) & to_unsigned(forward_cost(3, 0), 4);
      sums_turn_write_costs_1 <= (forward_cost(3, 10) * 256) + (forward_cost(3, 11) * 4096) + forward_cost(3, 8) +
        (forward_cost(3, 9) * 16);
      sums_turn_write_smallest_0 <= forward_smallest_cost(4);
      sums_turn_write_place <= sums_turn_place(8);
    end if;
    -- winnerswinner1
    for i in 0 to 5 loop
      winnerswinner1_of_pair_0_value(i, 1) := is_set(sums_sum_0(2 * i + 1), 2);
      winnerswinner1_of_pair_0_value(i, 2) := is_set(sums_sum_0(2 * i + 1), 3);
      winnerswinner1_of_pair_0_value(i, 3) := is_set(sums_sum_0(2 * i + 1), 4);
      winnerswinner1_of_pair_0_value(i, 4) := is_set(sums_sum_0(2 * i + 1), 5);
      winnerswinner1_of_pair_0_choice_7(i) := is_larger(sums_sum_0(2 * i), sums_sum_0(2 * i + 1), 0, 6, false);
    end loop;
    for i in 0 to 2 loop
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
    for i in 0 to 2 loop
      winnerswinner1_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0(4 * i + 2), 7)) or
        (to_unsigned(winnerswinner1_of_four_0(4 * i + 3), 7)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i + 1),
        7)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i), 7))));
    end loop;
    winnerswinner1_best_index_0 <= winnerswinner1_four_index_0;
    winnerswinner1_tag <= winnerswinner1_four_tag;
    winnerswinner1_of_pair_0(0) <= choice(winnerswinner1_of_pair_0_choice_7(0), 0, sums_sum_0(0));
    winnerswinner1_of_pair_0(1) <= choice(winnerswinner1_of_pair_0_choice_7(0), sums_sum_0(1), 0);
    for i in 1 to 5 loop
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
    for i in 1 to 2 loop
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
    winnerswinner2_of_pair_0_0_values(1) := is_set(winnerswinner1_best_cost_0(1), 2);
    winnerswinner2_of_pair_0_0_values(2) := is_set(winnerswinner1_best_cost_0(1), 3);
    winnerswinner2_of_pair_0_0_values(3) := is_set(winnerswinner1_best_cost_0(1), 4);
    winnerswinner2_of_pair_0_0_values(4) := is_set(winnerswinner1_best_cost_0(1), 5);
    winnerswinner2_of_pair_0_0_choice_7 := is_larger(winnerswinner1_best_cost_0(0), winnerswinner1_best_cost_0(1), 0,
      6, false);
    winnerswinner2_four_index_0_0_values(1) := is_set(winnerswinner2_of_pair_0(1), 1);
    winnerswinner2_four_index_0_0_values(2) := is_set(winnerswinner2_of_pair_0(0), 1);
    winnerswinner2_four_index_0_0_choices(1) := choice((not is_set(winnerswinner2_of_pair_0(2), 0)) and
      (is_set(winnerswinner2_of_pair_0(1), 0) or is_set(winnerswinner2_of_pair_0(0), 0)), (not
      is_set(winnerswinner2_of_pair_0(2), 1)) or winnerswinner2_four_index_0_0_values(1) or
      winnerswinner2_four_index_0_0_values(2), (not is_set(winnerswinner2_of_pair_0(2), 1)) and
      (winnerswinner2_four_index_0_0_values(1) or winnerswinner2_four_index_0_0_values(2)));
    for i in 2 to 5 loop
      winnerswinner2_four_index_0_0_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(1), i);
      winnerswinner2_four_index_0_0_values(2 * i) := is_set(winnerswinner2_of_pair_0(0), i);
      winnerswinner2_four_index_0_0_choices(i) := choice(winnerswinner2_four_index_0_0_choices(i - 1), (not
        is_set(winnerswinner2_of_pair_0(2), i)) or winnerswinner2_four_index_0_0_values(2 * i - 1) or
        winnerswinner2_four_index_0_0_values(2 * i), (not is_set(winnerswinner2_of_pair_0(2), i)) and
        (winnerswinner2_four_index_0_0_values(2 * i - 1) or winnerswinner2_four_index_0_0_values(2 * i)));
    end loop;
    winnerswinner2_four_index_0_0_choices(6) := choice(winnerswinner2_four_index_0_0_choices(5), (not
      is_set(winnerswinner2_of_pair_0(2), 6)) or is_set(winnerswinner2_of_pair_0(1), 6) or
      is_set(winnerswinner2_of_pair_0(0), 6), (not is_set(winnerswinner2_of_pair_0(2), 6)) and
      (is_set(winnerswinner2_of_pair_0(1), 6) or is_set(winnerswinner2_of_pair_0(0), 6)));
    winnerswinner2_of_pair_0(2) <= winnerswinner1_best_cost_0(2);
    winnerswinner2_pair_index_0(1) <= winnerswinner1_best_index_0(2);
    winnerswinner2_pair_tag <= winnerswinner1_tag;
    winnerswinner2_four_tag <= winnerswinner2_pair_tag;
    winnerswinner2_best_index_0_0 <= winnerswinner2_four_index_0_0;
    winnerswinner2_tag <= winnerswinner2_four_tag;
    winnerswinner2_of_pair_0(0) <= choice(winnerswinner2_of_pair_0_0_choice_7, 0, winnerswinner1_best_cost_0(0));
    winnerswinner2_of_pair_0(1) <= choice(winnerswinner2_of_pair_0_0_choice_7, winnerswinner1_best_cost_0(1), 0);
    winnerswinner2_pair_index_0(0) <= choice(winnerswinner2_of_pair_0_0_choice_7, winnerswinner1_best_index_0(1),
      winnerswinner1_best_index_0(0));
    winnerswinner2_four_index_0_0 <= choice(winnerswinner2_four_index_0_0_choices(6), winnerswinner2_pair_index_0(1),
      winnerswinner2_pair_index_0(0));
    -- winners
    winners_best_index_0_0 <= winnerswinner2_best_index_0_0;
    winners_best_tag <= winnerswinner2_tag;
    -- turn
    turn_order_address_anys(1) := turn_order_inside or (not winners_best_tag.map_column) or (not
      winners_best_tag.valid);
    turn_order_address_choice := choice(turn_order_falls, 31, 1);
    turn_order_address_choice_2 := choice(turn_order_falls, 0, 7);
    turn_order_address_anys(2) := (not winners_best_tag.map_column) or (not winners_best_tag.valid);
    if not turn_order_address_anys(2) then
      turn_order_address <= choice(turn_order_address_anys(1), (turn_order_address_choice + turn_order_address) mod 32,
        turn_order_address_choice_2 * 4);
    end if;
    turn_order_falls_all := (not turn_order_inside) and winners_best_tag.map_column and winners_best_tag.valid;
    turn_order_complete_all := winners_best_tag.map_column and winners_best_tag.valid;
    turn_order_turned_output_column_choice := choice(turn_order_falls_all, turn_order_output and turn_order_complete,
      turn_order_held_output);
    turn_order_turned_valid <= winners_best_tag.valid;
    turn_order_turned_output_column <= turn_order_turned_output_column_choice and winners_best_tag.map_column;
    turn_order_turned_start_of_frame <= (not turn_order_inside) and winners_best_tag.map_column and
      winners_best_tag.valid and turn_order_first and turn_order_output and turn_order_complete;
    turn_order_turned_end_of_line <= winners_best_tag.end_of_line;
    turn_newest <= winners_best_index_0_0 + 256;
    turn_comes <= turn_order_complete_all;
    turn_read_tag.valid <= turn_order_turned_valid;
    turn_read_tag.output_column <= turn_order_turned_output_column;
    turn_read_tag.start_of_frame <= turn_order_turned_start_of_frame;
    turn_read_tag.end_of_line <= turn_order_turned_end_of_line;
    turn_ready <= to_integer(turn_read_words_0);
    turn_ready_tag <= turn_read_tag;
    turn_order_falls <= choice(turn_order_falls, turn_order_address_anys(1), turn_order_falls_all);
    turn_order_complete <= choice(winners_best_tag.end_of_line, turn_order_complete or turn_order_complete_all,
      turn_order_complete and turn_order_address_anys(2));
    if winners_best_tag.valid then turn_order_inside <= winners_best_tag.map_column; end if;
    if turn_order_falls_all then
      turn_order_output <= winners_best_tag.output_column;
      turn_order_first <= winners_best_tag.start_of_frame;
      turn_order_held_output <= turn_order_output and turn_order_complete;
    end if;
    if turn_comes then
      turn_write_words_0 <= turn_newest;
      turn_write_place <= turn_order_address;
    end if;
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 14;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 13; raster_place_next_frame <= false; delay_ring_read_address <= 1;
      delay_ring_write_address <= 0; delay_column <= 0; delay_tag.valid <= false; delay_tag.first_cost <= false;
      delay_tag.map_column <= false; delay_tag.output_column <= false; delay_tag.start_of_frame <= false;
      delay_tag.end_of_line <= false; rows_read_column <= 0; rows_read_tag.valid <= false;
      rows_read_tag.first_cost <= false; rows_read_tag.map_column <= false; rows_read_tag.output_column <= false;
      rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false; rows_ready_column <= 0;
      rows_ready_tag.valid <= false; rows_ready_tag.first_cost <= false; rows_ready_tag.map_column <= false;
      rows_ready_tag.output_column <= false; rows_ready_tag.start_of_frame <= false;
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
      for i in 0 to 2 loop
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
      winnerswinner2_tag <= (others => false); winners_best_tag <= (others => false); turn_order_address <= 0;
      turn_order_falls <= false; turn_order_inside <= false; turn_order_complete <= false; turn_order_output <= false;
      turn_order_first <= false; turn_order_held_output <= false; turn_order_turned_valid <= false;
      turn_order_turned_output_column <= false; turn_order_turned_start_of_frame <= false;
      turn_order_turned_end_of_line <= false; turn_comes <= false; turn_read_tag <= (others => false);
      turn_write_place <= 0; turn_ready_tag <= (others => false);
    end if;
  end process;
end architecture;
