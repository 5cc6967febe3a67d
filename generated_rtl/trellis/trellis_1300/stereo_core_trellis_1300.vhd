-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, trellis, configuration trellis_1300: 1300x640, 64 disparities, window 3x3, drop 4 or by 6, occlusion 7, 1 pixel pair a clock.
-- Options: median true, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config trellis_1300
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_trellis_1300 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 1300;
    height_px : positive := 640;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 1237;
    latency_clocks : positive := 40;
    flush_groups : positive := 7805;
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
  assert width_px = 1300 report "stereo_core_trellis_1300: width_px is " & integer'image(width_px) & " but this core has 1300" severity failure;
  assert height_px = 640 report "stereo_core_trellis_1300: height_px is " & integer'image(height_px) & " but this core has 640" severity failure;
  assert disparities = 64 report "stereo_core_trellis_1300: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_trellis_1300: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_trellis_1300: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 1237 report "stereo_core_trellis_1300: output_width_px is " & integer'image(output_width_px) & " but this core has 1237" severity failure;
  assert latency_clocks = 40 report "stereo_core_trellis_1300: latency_clocks is " & integer'image(latency_clocks) & " but this core has 40" severity failure;
  assert flush_groups = 7805 report "stereo_core_trellis_1300: flush_groups is " & integer'image(flush_groups) & " but this core has 7805" severity failure;
  assert gap_groups = 0 report "stereo_core_trellis_1300: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_trellis_1300 is
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
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_13_1d is array (natural range <>) of natural range 0 to 13;
  type natural_13_2d is array (natural range <>, natural range <>) of natural range 0 to 13;
  type natural_144_1d is array (natural range <>) of natural range 0 to 144;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_16777215_2d is array (natural range <>, natural range <>) of natural range 0 to 16777215;
  type natural_1_to_2_1d is array (natural range <>) of natural range 1 to 2;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2047_2d is array (natural range <>, natural range <>) of natural range 0 to 2047;
  type natural_216_1d is array (natural range <>) of natural range 0 to 216;
  type natural_24_1d is array (natural range <>) of natural range 0 to 24;
  type natural_24_2d is array (natural range <>, natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_257_1d is array (natural range <>) of natural range 0 to 257;
  type natural_26_1d is array (natural range <>) of natural range 0 to 26;
  type natural_2_1d is array (natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_3_1d is array (natural range <>) of natural range 0 to 3;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_48_1d is array (natural range <>) of natural range 0 to 48;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_72_1d is array (natural range <>) of natural range 0 to 72;
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
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
  type tag_3 is record
    valid, map_column, end_of_line : boolean;
  end record;
  type tag_4_b is record
    map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_2 is record
    map_column, first_column : boolean;
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
    transform_write_column : natural range 0 to 2047;
  signal transform_counter_group : natural range 0 to 1023;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0, transform_left_rows_write_words_0,
    transform_right_rows_read_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16777215;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16777215;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 2047;
  signal raster_place_group : natural range 0 to 1023;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16777215;
  signal delay_column : natural range 0 to 2047;
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
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 2047;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag : tag_7;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag, rows_tag : tag_7;
  -- slice0shift
  signal slice0shift_search : natural_16777215_2d(0 to 2, 0 to 15);
  signal slice0shift_reference, slice0shift_search_out : natural_16777215_1d(0 to 2);
  signal slice0shift_tag : tag_7;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_pair_tag, slice0cost_tag : tag_7;
  signal slice0cost_pixels_cost : natural_24_2d(0 to 2, 0 to 15);
  signal slice0cost_single_0 : natural_24_1d(0 to 15);
  signal slice0cost_pair_0 : natural_48_1d(0 to 15);
  signal slice0cost_column_0 : natural_72_1d(0 to 15);
  -- slice0window
  signal slice0window_partial_0_0 : natural_72_1d(0 to 15);
  signal slice0window_partial_0_1 : natural_144_1d(0 to 15);
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0, slice0window_centre_first_column_0,
    slice0window_centre_start_of_frame_0, slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_6;
  signal slice0window_sum_0 : natural_216_1d(0 to 15);
  -- slice0
  signal slice0_held : natural_13_2d(0 to 3, 0 to 15);
  signal slice0_tag_valid : boolean_1d(0 to 3);  -- _#_valid
  signal slice0_tag_map_column : boolean_1d(0 to 3);  -- _#_map_column
  signal slice0_tag_output_column : boolean_1d(0 to 3);  -- _#_output_column
  signal slice0_tag_first_column : boolean_1d(0 to 3);  -- _#_first_column
  signal slice0_tag_start_of_frame : boolean_1d(0 to 3);  -- _#_start_of_frame
  signal slice0_tag_end_of_line : boolean_1d(0 to 3);  -- _#_end_of_line
  -- slice1shift
  signal slice1shift_search : natural_16777215_2d(0 to 2, 0 to 15);
  signal slice1shift_reference, slice1shift_search_out : natural_16777215_1d(0 to 2);
  -- slice1cost
  signal slice1cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice1cost_pixels_cost : natural_24_2d(0 to 2, 0 to 15);
  signal slice1cost_single_0 : natural_24_1d(0 to 15);
  signal slice1cost_pair_0 : natural_48_1d(0 to 15);
  signal slice1cost_column_0 : natural_72_1d(0 to 15);
  signal slice1cost_tag_border_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0 : natural_72_1d(0 to 15);
  signal slice1window_partial_0_1 : natural_144_1d(0 to 15);
  signal slice1window_sum_0 : natural_216_1d(0 to 15);
  -- slice1
  signal slice1_held : natural_13_2d(0 to 2, 0 to 15);
  -- slice2shift
  signal slice2shift_search : natural_16777215_2d(0 to 2, 0 to 15);
  signal slice2shift_reference, slice2shift_search_out : natural_16777215_1d(0 to 2);
  -- slice2cost
  signal slice2cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice2cost_pixels_cost : natural_24_2d(0 to 2, 0 to 15);
  signal slice2cost_single_0 : natural_24_1d(0 to 15);
  signal slice2cost_pair_0 : natural_48_1d(0 to 15);
  signal slice2cost_column_0 : natural_72_1d(0 to 15);
  signal slice2cost_tag_border_column : boolean;
  -- slice2window
  signal slice2window_partial_0_0 : natural_72_1d(0 to 15);
  signal slice2window_partial_0_1 : natural_144_1d(0 to 15);
  signal slice2window_sum_0 : natural_216_1d(0 to 15);
  -- slice2
  signal slice2_held : natural_13_2d(0 to 1, 0 to 15);
  -- slice3shift
  signal slice3shift_search : natural_16777215_2d(0 to 2, 0 to 15);
  signal slice3shift_reference : natural_16777215_1d(0 to 2);
  -- slice3cost
  signal slice3cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice3cost_pixels_cost : natural_24_2d(0 to 2, 0 to 15);
  signal slice3cost_single_0 : natural_24_1d(0 to 15);
  signal slice3cost_pair_0 : natural_48_1d(0 to 15);
  signal slice3cost_column_0 : natural_72_1d(0 to 15);
  -- slice3window
  signal slice3window_partial_0_0 : natural_72_1d(0 to 15);
  signal slice3window_partial_0_1 : natural_144_1d(0 to 15);
  signal slice3window_sum_0 : natural_216_1d(0 to 15);
  -- slice3
  signal slice3_held_0 : natural_13_1d(0 to 15);
  -- entry
  signal entry_next_cost, entry_cost : natural_13_1d(0 to 63);
  signal entry_next_tag : tag_4;
  signal entry_next_top, entry_order_falls, entry_order_inside, entry_order_complete, entry_order_output,
    entry_order_held_output, entry_order_turned_output_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag : tag_4;
  signal entry_turned_output_column, entry_turned_start_of_frame : boolean;
  signal entry_order_address, entry_place : natural range 0 to 2047;
  -- forward
  signal forward_next_cost : natural_13_1d(0 to 63);
  signal forward_next_first : boolean;
  signal forward_far : boolean_1d(0 to 57);
  signal forward_pair_cost : natural_31_1d(0 to 63);
  signal forward_path, forward_stayed : natural_2047_1d(0 to 63);
  signal forward_occluding : natural_2047_1d(0 to 62);
  signal forward_dropped : natural_2047_1d(0 to 63);
  signal forward_decision : natural_3_1d(0 to 63);  -- _# up to 2, 3 x 63
  -- decisions
  signal decisions_read_words, decisions_write_words : unsigned_32_1d(0 to 3);
  signal decisions_ready_decision : natural_3_1d(0 to 63);
  signal decisions_ready_inside : boolean;
  signal decisions_comes : boolean_1d(0 to 2);
  signal decisions_place : natural_2047_1d(0 to 2);
  signal decisions_write_place : natural range 0 to 2047;
  -- last
  signal last_tags_held_end_of_line : boolean_1d(0 to 2);  -- _#_end_of_line
  signal last_tags_held_map_column : boolean_1d(1 to 2);  -- _#_map_column
  signal last_tags_moved : boolean;
  signal last_tag : tag_3;
  signal last_path_0 : natural_2047_1d(0 to 63);  -- _# up to 1024, 2047 x 63
  signal last_state : natural range 0 to 63;
  -- lastwinner1
  signal lastwinner1_best_cost_0 : natural_2047_1d(0 to 31);
  signal lastwinner1_best_index_0_0 : boolean;
  signal lastwinner1_tag : tag_3;
  signal lastwinner1_best_index_0 : natural_63_1d(1 to 31);  -- _# up to 3, 5 .. 63
  -- lastwinner2
  signal lastwinner2_best_cost_0 : natural_2047_1d(0 to 15);
  signal lastwinner2_best_index_0 : natural_63_1d(0 to 15);  -- _# up to 3, 7 .. 63
  signal lastwinner2_tag : tag_3;
  -- lastwinner3
  signal lastwinner3_best_cost_0 : natural_2047_1d(0 to 7);
  signal lastwinner3_best_index_0 : natural_63_1d(0 to 7);  -- _# up to 7, 15 .. 63
  signal lastwinner3_tag : tag_3;
  -- lastwinner4
  signal lastwinner4_best_cost_0 : natural_2047_1d(0 to 3);
  signal lastwinner4_best_index_0 : natural_63_1d(0 to 3);  -- _# up to 15, 31 .. 63
  signal lastwinner4_tag : tag_3;
  -- lastwinner5
  signal lastwinner5_best_cost_0 : natural_2047_1d(0 to 1);
  signal lastwinner5_best_index_0 : natural_63_1d(0 to 1);  -- _# up to 31, 63
  signal lastwinner5_tag : tag_3;
  -- lastwinner6
  signal lastwinner6_best_index_0_0 : natural range 0 to 63;
  signal lastwinner6_tag : tag_3;
  -- traceback
  signal traceback_state, traceback_out_disparity_0 : natural range 0 to 255;
  signal traceback_decision, traceback_falling : natural range 0 to 3;
  signal traceback_tags_held_output_column : boolean_1d(0 to 1);  -- _#_output_column
  signal traceback_tags_held_start_of_frame : boolean_1d(0 to 1);  -- _#_start_of_frame
  signal traceback_out_passed_0 : boolean;
  signal traceback_out_tag : tag_4_b;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 2047;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_turned_map_column, turn_order_turned_first_column, turn_comes : boolean;
  signal turn_read_tag, turn_ready_tag : tag_2;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 511;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- fill
  signal fill_out_disparity_0 : natural range 0 to 255;
  signal fill_out_passed_0, fill_out_tag_map_column : boolean;
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column,
    map_sorted_column : natural range 0 to 2047;
  signal map_counter_group : natural range 0 to 1023;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_read_bottom, map_at_arrives,
    map_at_behind, map_at_top, map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a,
    map_of_column_0_c_below_b : boolean;
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
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 511;
  signal map_column : natural_511_1d(1 to 2);
  signal map_rows_read_words_0 : unsigned(17 downto 0);
  signal map_rows_ready_words_0, map_rows_write_words_0 : natural range 0 to 262143;
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0, map_sorted_middle_0,
    map_sorted_high_0 : natural range 0 to 255;
  signal map_low_0, map_middle_0, map_high_0 : natural_255_1d(0 to 2);  -- _#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b, map_of_middle_0_c,
    map_of_high_0_a, map_of_high_0_b, map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0,
    map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 255;
  -- other
  signal other_0 : boolean;
  signal other_1, other_3 : unsigned(48 downto 0);
  signal other_2 : natural range 0 to 510;
  signal other : natural_257_1d(4 to 7);

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
    signal read_address, write_address : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 11);
    write_address <= to_unsigned(transform_write_column, 11);
    cell : entity work.line_memory generic map (1300, 32, 11)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address,
        transform_left_rows_write_words_0);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 11);
    write_address <= to_unsigned(transform_write_column, 11);
    cell : entity work.line_memory generic map (1300, 32, 11)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address,
        transform_right_rows_write_words_0);
  end block;

  map_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(17 downto 0);
  begin
    read_address <= to_unsigned(map_counter_column, 11);
    write_address <= to_unsigned(map_at_column, 11);
    write_data <= to_unsigned(map_rows_write_words_0, 18);
    cell : entity work.line_memory generic map (1237, 18, 11)
      port map (clock, true, read_address, map_rows_read_words_0, write_address, write_data);
  end block;

  turn_read_words_0_memory : block
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(turn_order_address, 11);
    write_address <= to_unsigned(turn_write_place, 11);
    write_data <= to_unsigned(turn_write_words_0, 9);
    cell : entity work.line_memory generic map (1237, 9, 11)
      port map (clock, true, read_address, turn_read_words_0, write_address, write_data);
  end block;

  decisions_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 11);
    write_address <= to_unsigned(decisions_write_place, 11);
    cell : entity work.line_memory generic map (1237, 32, 11)
      port map (clock, true, read_address, decisions_read_words(i), write_address, decisions_write_words(i));
  end generate;

  rows_search_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 11);
    write_address <= to_unsigned(rows_write_column, 11);
    write_data <= to_unsigned(rows_search_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (1300, 24, 11)
      port map (clock, true, read_address, rows_search_rows_read_words(i), write_address, write_data);
  end generate;

  rows_reference_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 11);
    write_address <= to_unsigned(rows_write_column, 11);
    write_data <= to_unsigned(rows_reference_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (1300, 24, 11)
      port map (clock, true, read_address, rows_reference_rows_read_words(i), write_address, write_data);
  end generate;

  process
    variable transform_counter_group_is_equals, raster_place_group_is_equals,
      map_counter_group_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_all,
      raster_place_group_differs, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less,
      delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less,
      entry_order_falls_any, entry_order_falls_all, entry_order_complete_any, entry_order_turned_output_column_choice,
      forward_far_1_any, decisions_write_words_0_all, traceback_state_all, turn_order_falls_all,
      turn_order_complete_all, fill_out_disparity_0_all, map_counter_column_is_equal, map_counter_group_all,
      map_counter_group_differs, map_line_ended_choice, map_at_arrives_value, map_window_complete_is_equal,
      map_window_complete_choice, map_of_low_0_b_below_a_is_equal, map_of_low_0_b_below_a_choice_7,
      map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice_7, map_of_low_0_c_below_b_choice_7,
      map_of_middle_0_b_below_a_is_equal, map_of_middle_0_b_below_a_choice_7, map_of_middle_0_c_below_a_value,
      map_of_middle_0_c_below_a_choice_7, map_of_middle_0_c_below_b_choice_7, map_of_high_0_b_below_a_is_equal,
      map_of_high_0_b_below_a_choice_7, map_of_high_0_c_below_a_value, map_of_high_0_c_below_a_choice_7,
      map_of_high_0_c_below_b_choice_7, map_of_all_0_b_below_a_is_equal, map_of_all_0_b_below_a_choice_7,
      map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice_7, map_of_all_0_c_below_b_choice_7 : boolean;
    variable transform_counter_group_choice, raster_place_group_choice, map_counter_group_choice : natural range 0 to 5;
    variable transform_counter_group_choices, raster_place_group_choices,
      map_counter_group_choices : natural_1023_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values,
      map_of_low_0_b_below_a_values, map_of_middle_0_b_below_a_values, map_of_high_0_b_below_a_values,
      map_of_all_0_b_below_a_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(8 to 192);
    variable transform_left_filter_feature_0_choice_193,
      transform_right_filter_feature_0_choice_193 : natural range 0 to 31;
    variable transform_left_filter_feature_0_choice_194,
      transform_right_filter_feature_0_choice_194 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_195,
      transform_right_filter_feature_0_choice_195 : natural range 0 to 8191;
    variable transform_left_filter_feature_0_choice_196,
      transform_right_filter_feature_0_choice_196 : natural range 0 to 524287;
    variable transform_counter_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
    variable raster_place_next_frame_choices, map_counter_next_frame_choices : boolean_1d(1 to 4);  -- _choice_#
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 2047;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 309;
    variable forward_pair_cost_sum : natural_26_1d(0 to 63);  -- _#_sum
    variable forward_path_value : boolean_1d(0 to 63);  -- _#_value
    variable forward_path_choice : natural_2047_2d(0 to 63, 1 to 3);  -- _#_choice_#
    variable forward_path_any : boolean_1d(1 to 63);  -- _#_any
    variable forward_dropped_value : boolean_1d(0 to 57);  -- _#_value
    variable forward_dropped_choice : natural_2047_1d(0 to 57);  -- _#_choice
    variable forward_decision_choice : natural_1_to_2_1d(0 to 57);  -- _#_choice
    variable forward_decision_choice_2 : natural_2_1d(1 to 57);  -- _#_choice_2
    variable forward_far_choice : boolean_1d(1 to 57);  -- _#_choice
    variable last_path_0_2_difference : integer range -1023 to 1024;
    variable lastwinner1_best_cost_0_is_less : boolean_1d(0 to 31);  -- _#_is_less
    variable lastwinner2_best_cost_0_is_less : boolean_1d(0 to 15);  -- _#_is_less
    variable lastwinner3_best_cost_0_is_less : boolean_1d(0 to 7);  -- _#_is_less
    variable lastwinner4_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable lastwinner5_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
    variable traceback_state_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable traceback_state_sum : natural range 1 to 256;
    variable traceback_state_sum_2 : natural range 3 to 130;
    variable traceback_state_sum_3 : natural range 255 to 510;
    variable traceback_state_choices : natural_255_1d(1 to 3);  -- _choice_#
    variable traceback_decision_values : boolean_1d(1 to 15);  -- _value_#
    variable traceback_decision_choices : natural_3_1d(1 to 223);  -- _choice_#
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
    variable fill_out_disparity_0_choice, map_low_0_0_choice, map_middle_0_0_choice,
      map_high_0_0_choice : natural range 0 to 255;
    variable map_of_column_0_b_below_a_values : boolean_1d(1 to 12);  -- _value_#
    variable map_of_column_0_b_below_a_choices : boolean_1d(1 to 9);  -- _choice_#
    variable map_of_column_0_c_below_a_values : boolean_1d(1 to 7);  -- _value_#
    variable map_of_column_0_c_below_a_choices : boolean_1d(1 to 20);  -- _choice_#
    variable map_of_column_0_c_below_b_choices : boolean_1d(1 to 6);  -- _choice_#
    variable map_sorted_low_0_choices, map_sorted_middle_0_choices, map_sorted_high_0_choices,
      map_largest_low_0_choices, map_smallest_high_0_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable map_median_middle_0_choices, map_out_disparity_0_choices : natural_255_1d(1 to 4);  -- _choice_#
    variable map_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    forward_far_choice := (others => false); forward_path_choice := (others => (others => 0));
    transform_left_filter_feature_0_choice := (others => false);
    transform_right_filter_feature_0_choice := (others => false);
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_group = 639;
    transform_counter_group_is_equals(2) := transform_counter_column = 1299;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 5, 0);
    transform_counter_group_differs := transform_counter_group /= 642;
    transform_counter_group_choices(2) := choice((transform_counter_group = 641) and transform_counter_next_frame, 2,
      (transform_counter_group + 1) mod 1024);
    transform_counter_group_choices(3) := choice(transform_counter_group_differs and in_valid and
      transform_counter_group_is_equals(2), transform_counter_group_choices(2), transform_counter_group);
    transform_read_column_inside_0_is_less := 1 < transform_counter_column;
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
      (transform_counter_group mod 4)) < 640;
    transform_read_row_inside(1) <= (transform_counter_group >= 3) and (transform_counter_group < 643);
    transform_read_row_inside(2) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 640;
    transform_read_row_inside(3) <= (transform_counter_group >= 1) and (transform_counter_group < 641);
    transform_read_row_inside(4) <= transform_counter_group < 640;
    transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
    transform_read_column_inside(1) <= (transform_counter_column = 0) /= transform_read_column_inside_0_is_less;
    for i in 2 to 4 loop
      transform_read_column_inside(i) <= (transform_counter_column < i) /= transform_read_column_inside_0_is_less;
    end loop;
    transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 2);
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
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice * 128,
      transform_counter_group_choices(3));
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
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(2), (transform_counter_group /=
      641) and transform_counter_next_frame, transform_counter_next_frame);
    transform_counter_next_frame_choices(2) := choice(transform_counter_group_differs,
      transform_counter_next_frame_choices(1), transform_counter_next_frame);
    if in_valid then
      transform_counter_column <= choice(in_start_of_frame or transform_counter_group_is_equals(2), 0,
        (transform_counter_column + 1) mod 2048);
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
    raster_place_group_is_equals(1) := raster_place_group = 639;
    raster_place_group_is_equals(2) := raster_place_column = 1299;
    raster_place_group_all := raster_place_group_is_equals(1) and raster_place_group_is_equals(2);
    raster_place_group_choice := choice(raster_place_group_all, 5, 0);
    raster_place_group_differs := raster_place_group /= 641;
    raster_place_group_choices(2) := choice((raster_place_group = 640) and raster_place_next_frame, 1,
      (raster_place_group + 1) mod 1024);
    raster_place_group_choices(3) := choice(raster_place_group_differs and transform_filtering_valid(1) and
      raster_place_group_is_equals(2), raster_place_group_choices(2), raster_place_group);
    raster_place_next_frame_choices(1) := choice(raster_place_group_is_equals(2), (raster_place_group /= 640) and
      raster_place_next_frame, raster_place_next_frame);
    raster_place_next_frame_choices(2) := choice(raster_place_group_differs, raster_place_next_frame_choices(1),
      raster_place_next_frame);
    raster_place_next_frame_choices(3) := choice(raster_place_group_all, transform_filtering_valid(1),
      transform_filtering_valid(1) and (not transform_filtering_start_of_frame(1)));
    raster_place_next_frame_choices(4) := choice(raster_place_next_frame_choices(2),
      raster_place_next_frame_choices(3), raster_place_group_is_equals(1) and raster_place_group_is_equals(2) and
      transform_filtering_valid(1) and transform_filtering_start_of_frame(1));
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(1);
    raster_place_next_frame <= raster_place_next_frame_choices(4) or ((not transform_filtering_valid(1)) and
      raster_place_next_frame);
    raster_place_group <= choice(transform_filtering_valid(1) and transform_filtering_start_of_frame(1),
      raster_place_group_choice * 128, raster_place_group_choices(3));
    if transform_filtering_valid(1) then
      raster_place_column <= choice(transform_filtering_start_of_frame(1) or raster_place_group_is_equals(2), 0,
        (raster_place_column + 1) mod 2048);
    end if;
    -- delay
    delay_row_inside_1_is_not_less := raster_place_group >= 1;
    delay_row_inside_1_is_less := raster_place_group < 641;
    delay_tag_first_cost_is_equal := raster_place_column = 63;
    delay_tag_map_column_is_not_less := raster_place_column >= 63;
    delay_tag_map_column_is_less := raster_place_column < 1300;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 640;
    delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
    delay_row_inside(2) <= raster_place_group < 640;
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
    rows_search_rows_ready_words(0) <= to_integer(rows_search_rows_read_words(0));
    rows_search_rows_ready_words(1) <= to_integer(rows_search_rows_read_words(1));
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= delay_ahead_0;
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
      for j in 3 to 7 loop
        slice0cost_pixels_first_count(i, 0, j) <= differing(slice0shift_reference(i), slice0shift_search(i, 0), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 15 loop
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
      for j in 0 to 15 loop
        slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 0) + slice0cost_pixels_first_count(i, j, 2)
          + slice0cost_pixels_first_count(i, j, 3) + slice0cost_pixels_first_count(i, j, 5) +
          slice0cost_pixels_first_count(i, j, 6) + slice0cost_pixels_first_count(i, j, 4) +
          slice0cost_pixels_first_count(i, j, 7) + slice0cost_pixels_first_count(i, j, 1);
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
    for i in 0 to 15 loop slice0_held(0, i) <= slice0window_sum_0(i) / 16; end loop;
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
      for j in 3 to 7 loop
        slice1cost_pixels_first_count(i, 0, j) <= differing(slice1shift_reference(i), slice1shift_search(i, 0), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 15 loop
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
      for j in 0 to 15 loop
        slice1cost_pixels_cost(i, j) <= slice1cost_pixels_first_count(i, j, 0) + slice1cost_pixels_first_count(i, j, 2)
          + slice1cost_pixels_first_count(i, j, 3) + slice1cost_pixels_first_count(i, j, 5) +
          slice1cost_pixels_first_count(i, j, 6) + slice1cost_pixels_first_count(i, j, 4) +
          slice1cost_pixels_first_count(i, j, 7) + slice1cost_pixels_first_count(i, j, 1);
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
    for i in 0 to 15 loop slice1_held(0, i) <= slice1window_sum_0(i) / 16; end loop;
    for i in 0 to 15 loop slice1_held(1, i) <= slice1_held(0, i); end loop;
    for i in 0 to 15 loop slice1_held(2, i) <= slice1_held(1, i); end loop;
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
      for j in 3 to 7 loop
        slice2cost_pixels_first_count(i, 0, j) <= differing(slice2shift_reference(i), slice2shift_search(i, 0), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 15 loop
        slice2cost_pixels_first_count(i, j, 0) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 0, 2,
          1);
        slice2cost_pixels_first_count(i, j, 1) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 3, 5,
          4);
        slice2cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) + differing(slice2shift_search(i, j),
          slice2shift_reference(i), 8) + differing(slice2shift_search(i, j), slice2shift_reference(i), 6);
        for k in 3 to 7 loop
          slice2cost_pixels_first_count(i, j, k) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 3 *
            k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 15 loop
        slice2cost_pixels_cost(i, j) <= slice2cost_pixels_first_count(i, j, 0) + slice2cost_pixels_first_count(i, j, 2)
          + slice2cost_pixels_first_count(i, j, 3) + slice2cost_pixels_first_count(i, j, 5) +
          slice2cost_pixels_first_count(i, j, 6) + slice2cost_pixels_first_count(i, j, 4) +
          slice2cost_pixels_first_count(i, j, 7) + slice2cost_pixels_first_count(i, j, 1);
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
    for i in 0 to 15 loop slice2_held(0, i) <= slice2window_sum_0(i) / 16; end loop;
    for i in 0 to 15 loop slice2_held(1, i) <= slice2_held(0, i); end loop;
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
      for j in 3 to 7 loop
        slice3cost_pixels_first_count(i, 0, j) <= differing(slice3shift_reference(i), slice3shift_search(i, 0), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 15 loop
        slice3cost_pixels_first_count(i, j, 0) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 0, 2,
          1);
        slice3cost_pixels_first_count(i, j, 1) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 3, 5,
          4);
        slice3cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice3shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice3shift_reference(i) mod 256), 8)))) / 128) + differing(slice3shift_search(i, j),
          slice3shift_reference(i), 8) + differing(slice3shift_search(i, j), slice3shift_reference(i), 6);
        for k in 3 to 7 loop
          slice3cost_pixels_first_count(i, j, k) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 3 *
            k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 15 loop
        slice3cost_pixels_cost(i, j) <= slice3cost_pixels_first_count(i, j, 0) + slice3cost_pixels_first_count(i, j, 2)
          + slice3cost_pixels_first_count(i, j, 3) + slice3cost_pixels_first_count(i, j, 5) +
          slice3cost_pixels_first_count(i, j, 6) + slice3cost_pixels_first_count(i, j, 4) +
          slice3cost_pixels_first_count(i, j, 7) + slice3cost_pixels_first_count(i, j, 1);
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
    for i in 0 to 15 loop slice3_held_0(i) <= slice3window_sum_0(i) / 16; end loop;
    -- entry
    entry_order_falls_any := (not slice0_tag_valid(3)) or (not slice0_tag_map_column(3)) or entry_order_inside;
    entry_order_falls_all := slice0_tag_valid(3) and slice0_tag_map_column(3) and (not entry_order_inside);
    entry_order_complete_any := (not slice0_tag_valid(3)) or (not slice0_tag_map_column(3));
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
    entry_order_turned_start_of_frame <= slice0_tag_valid(3) and slice0_tag_map_column(3) and (not entry_order_inside)
      and entry_next_top and entry_order_output and entry_order_complete;
    entry_cost <= entry_next_cost;
    entry_tag <= entry_next_tag;
    entry_place <= entry_order_address;
    entry_turned_output_column <= entry_order_turned_output_column;
    entry_turned_start_of_frame <= entry_order_turned_start_of_frame;
    entry_order_falls <= choice(entry_order_falls, entry_order_falls_any, entry_order_falls_all);
    entry_order_complete <= choice(slice0_tag_end_of_line(3), entry_order_complete or (slice0_tag_valid(3) and
      slice0_tag_map_column(3)), entry_order_complete and entry_order_complete_any);
    if entry_order_falls_all then
      entry_next_top <= slice0_tag_start_of_frame(3);
      entry_order_output <= slice0_tag_output_column(3);
      entry_order_held_output <= entry_order_output and entry_order_complete;
    end if;
    entry_order_address_choice := choice(entry_order_falls, 2047, 1);
    entry_order_address_choice_2 := choice(entry_order_falls, 0, 309);
    if not entry_order_complete_any then
      entry_order_address <= choice(entry_order_falls_any, (entry_order_address_choice + entry_order_address) mod 2048,
        entry_order_address_choice_2 * 4);
    end if;
    if slice0_tag_valid(3) then entry_order_inside <= slice0_tag_map_column(3); end if;
    -- forward
    for i in 0 to 63 loop forward_pair_cost_sum(i) := entry_cost(i) + forward_next_cost(i); end loop;
    forward_path_value(0) := (((forward_dropped(0) - forward_stayed(0)) mod 2048) / 1024) = 1;
    forward_path_choice(0, 1) := choice(forward_path_value(0), forward_dropped(0), forward_stayed(0));
    forward_path_choice(0, 2) := choice(forward_next_first, 0, forward_path_choice(0, 1));
    for i in 1 to 63 loop
      forward_path_any(i) := (not ((((forward_occluding(i - 1) - forward_stayed(i)) mod 2048) / 1024) = 1)) or (not
        ((((forward_occluding(i - 1) - forward_dropped(i)) mod 2048) / 1024) = 1));
      forward_path_value(i) := (((forward_dropped(i) - forward_stayed(i)) mod 2048) / 1024) = 1;
      forward_path_choice(i, 1) := choice(forward_path_value(i), forward_dropped(i), forward_stayed(i));
      forward_path_choice(i, 2) := choice(forward_path_any(i), forward_path_choice(i, 1), forward_occluding(i - 1));
      forward_path_choice(i, 3) := choice(forward_next_first, 0, forward_path_choice(i, 2));
    end loop;
    for i in 0 to 57 loop
      forward_dropped_value(i) := (((forward_path(i + 6) - forward_path(i + 1)) mod 2048) / 1024) = 1;
      forward_dropped_choice(i) := choice(forward_dropped_value(i), forward_path(i + 6), forward_path(i + 1));
    end loop;
    forward_decision_choice(0) := choice(forward_far(0), 2, 1);
    for i in 1 to 57 loop
      forward_decision_choice(i) := choice(forward_far(i), 2, 1);
      forward_decision_choice_2(i) := choice(forward_path_value(i), forward_decision_choice(i), 0);
    end loop;
    if entry_tag.valid then
      forward_next_cost <= entry_cost;
      forward_next_first <= entry_tag.first_column;
      for i in 0 to 63 loop
        forward_pair_cost(i) <= (((forward_pair_cost_sum(i) / 4) + 1) * 4) + (forward_pair_cost_sum(i) mod 4);
      end loop;
      forward_path(0) <= forward_path_choice(0, 2);
      for i in 1 to 63 loop forward_path(i) <= forward_path_choice(i, 3); end loop;
      forward_stayed(0) <= (forward_path_choice(0, 2) + forward_next_cost(0)) mod 2048;
      for i in 1 to 63 loop forward_stayed(i) <= (forward_path_choice(i, 3) + forward_next_cost(i)) mod 2048; end loop;
      forward_far(0) <= forward_dropped_value(0) and (not forward_next_first);
      forward_far(16) <= forward_dropped_value(16) and (not forward_next_first);
      forward_far(32) <= forward_dropped_value(32) and (not forward_next_first);
      forward_far(48) <= forward_dropped_value(48) and (not forward_next_first);
      forward_occluding(0) <= choice(forward_next_first, 512, (forward_path_choice(0, 2) + 7) mod 2048);
      for i in 1 to 62 loop
        forward_occluding(i) <= choice(forward_next_first, 512, (forward_path_choice(i, 3) + 7) mod 2048);
      end loop;
      for i in 0 to 57 loop
        forward_dropped(i) <= choice(forward_next_first, 512, (forward_pair_cost(i) + forward_dropped_choice(i)) mod
          2048);
      end loop;
      for i in 58 to 62 loop
        forward_dropped(i) <= choice(forward_next_first, 512, (forward_pair_cost(i) + forward_path(i + 1)) mod 2048);
      end loop;
      forward_dropped(63) <= choice(forward_next_first, 512, (forward_pair_cost(63) + forward_path(63)) mod 2048);
      forward_decision(0) <= choice(forward_path_value(0), forward_decision_choice(0), 0);
      for i in 1 to 57 loop
        forward_decision(i) <= choice(forward_path_any(i), forward_decision_choice_2(i), 3);
      end loop;
      for i in 58 to 63 loop
        forward_decision(i) <= choice(forward_path_any(i), as_number(forward_path_value(i)), 3);
      end loop;
    end if;
    forward_far_1_any := (not entry_tag.valid) or (not forward_next_first);
    for i in 0 to 2 loop
      for j in 1 to 15 loop
        forward_far_choice(16 * i + j) := choice(forward_dropped_value(16 * i + j), forward_far_1_any, not
          entry_tag.valid);
      end loop;
    end loop;
    for i in 49 to 57 loop
      forward_far_choice(i) := choice(forward_dropped_value(i), forward_far_1_any, not entry_tag.valid);
    end loop;
    for i in 0 to 2 loop
      for j in 1 to 15 loop
        forward_far(16 * i + j) <= choice(forward_far(16 * i + j), forward_far_choice(16 * i + j),
          forward_dropped_value(16 * i + j) and entry_tag.valid and (not forward_next_first));
      end loop;
    end loop;
    for i in 49 to 57 loop
      forward_far(i) <= choice(forward_far(i), forward_far_choice(i), forward_dropped_value(i) and entry_tag.valid and
        (not forward_next_first));
    end loop;
    -- decisions
    if entry_tag.valid then
      for i in 0 to 3 loop
        decisions_ready_decision(16 * i) <= to_integer(decisions_read_words(i)(1 downto 0));
        decisions_ready_decision(16 * i + 1) <= (to_integer(decisions_read_words(i)(7 downto 0)) / 4) mod 4;
        decisions_ready_decision(16 * i + 2) <= (to_integer(decisions_read_words(i)(7 downto 0)) / 16) mod 4;
        decisions_ready_decision(16 * i + 3) <= to_integer(decisions_read_words(i)(7 downto 0)) / 64;
        for j in 4 to 15 loop
          decisions_ready_decision(16 * i + j) <= to_integer(decisions_read_words(i)(2 * j + 1 downto 2 * j));
        end loop;
      end loop;
      decisions_ready_inside <= entry_tag.map_column;
      decisions_comes(0) <= entry_tag.map_column;
      decisions_comes(1) <= decisions_ready_inside;
      decisions_comes(2) <= last_tags_held_map_column(1);
      decisions_place(0) <= entry_place;
      decisions_place(1 to 2) <= decisions_place(0 to 1);
    end if;
    decisions_write_words_0_all := decisions_comes(2) and entry_tag.valid;
    if decisions_write_words_0_all then
      for i in 0 to 3 loop
        decisions_write_words(i) <= to_unsigned(forward_decision(16 * i + 15), 2) & to_unsigned(forward_decision(16 * i
          + 14), 2) & to_unsigned(forward_decision(16 * i + 13), 2) & to_unsigned(forward_decision(16 * i + 12), 2) &
          to_unsigned(forward_decision(16 * i + 11), 2) & to_unsigned(forward_decision(16 * i + 10), 2) &
          to_unsigned(forward_decision(16 * i + 9), 2) & to_unsigned(forward_decision(16 * i + 8), 2) &
          to_unsigned(forward_decision(16 * i + 7), 2) & to_unsigned(forward_decision(16 * i + 6), 2) &
          to_unsigned(forward_decision(16 * i + 5), 2) & to_unsigned(forward_decision(16 * i + 4), 2) &
          to_unsigned(forward_decision(16 * i + 3), 2) & to_unsigned(forward_decision(16 * i + 2), 2) &
          to_unsigned(forward_decision(16 * i + 1), 2) & to_unsigned(forward_decision(16 * i), 2);
      end loop;
      decisions_write_place <= decisions_place(2);
    end if;
    -- last
    if entry_tag.valid then
      last_tags_held_end_of_line(0) <= entry_tag.end_of_line;
      last_tags_held_map_column(1) <= decisions_comes(0);
      last_tags_held_end_of_line(1) <= last_tags_held_end_of_line(0);
      last_tags_held_map_column(2) <= decisions_comes(1);
      last_tags_held_end_of_line(2) <= last_tags_held_end_of_line(1);
    end if;
    last_path_0_2_difference := 1024 - forward_path(0);
    last_tags_moved <= entry_tag.valid;
    last_path_0(0) <= 1024;
    last_path_0(1) <= ((((((forward_path(1) / 1024) + 1) mod 2) * 1024) + (forward_path(1) mod 1024)) -
      forward_path(0)) mod 2048;
    for i in 2 to 63 loop last_path_0(i) <= (last_path_0_2_difference + forward_path(i)) mod 2048; end loop;
    last_tag.valid <= last_tags_moved;
    last_tag.map_column <= last_tags_held_map_column(2);
    last_tag.end_of_line <= last_tags_held_end_of_line(2);
    if not ((not lastwinner6_tag.end_of_line) or (not lastwinner6_tag.map_column) or (not lastwinner6_tag.valid)) then
      last_state <= lastwinner6_best_index_0_0;
    end if;
    -- lastwinner1
    for i in 0 to 31 loop
      lastwinner1_best_cost_0_is_less(i) := (last_path_0(2 * i + 1) - last_path_0(2 * i)) < 0;
    end loop;
    lastwinner1_best_index_0_0 <= lastwinner1_best_cost_0_is_less(0);
    lastwinner1_tag <= last_tag;
    lastwinner1_best_cost_0(0) <= choice(lastwinner1_best_cost_0_is_less(0), last_path_0(1), last_path_0(0));
    for i in 1 to 31 loop
      lastwinner1_best_cost_0(i) <= choice(lastwinner1_best_cost_0_is_less(i), last_path_0(2 * i + 1), last_path_0(2 *
        i));
      lastwinner1_best_index_0(i) <= choice(lastwinner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- lastwinner2
    for i in 0 to 15 loop
      lastwinner2_best_cost_0_is_less(i) := (lastwinner1_best_cost_0(2 * i + 1) - lastwinner1_best_cost_0(2 * i)) < 0;
    end loop;
    lastwinner2_tag <= lastwinner1_tag;
    lastwinner2_best_cost_0(0) <= choice(lastwinner2_best_cost_0_is_less(0), lastwinner1_best_cost_0(1),
      lastwinner1_best_cost_0(0));
    lastwinner2_best_index_0(0) <= choice(lastwinner2_best_cost_0_is_less(0), lastwinner1_best_index_0(1),
      as_number(lastwinner1_best_index_0_0));
    for i in 1 to 15 loop
      lastwinner2_best_cost_0(i) <= choice(lastwinner2_best_cost_0_is_less(i), lastwinner1_best_cost_0(2 * i + 1),
        lastwinner1_best_cost_0(2 * i));
      lastwinner2_best_index_0(i) <= choice(lastwinner2_best_cost_0_is_less(i), lastwinner1_best_index_0(2 * i + 1),
        lastwinner1_best_index_0(2 * i));
    end loop;
    -- lastwinner3
    for i in 0 to 7 loop
      lastwinner3_best_cost_0_is_less(i) := (lastwinner2_best_cost_0(2 * i + 1) - lastwinner2_best_cost_0(2 * i)) < 0;
    end loop;
    lastwinner3_tag <= lastwinner2_tag;
    for i in 0 to 7 loop
      lastwinner3_best_cost_0(i) <= choice(lastwinner3_best_cost_0_is_less(i), lastwinner2_best_cost_0(2 * i + 1),
        lastwinner2_best_cost_0(2 * i));
      lastwinner3_best_index_0(i) <= choice(lastwinner3_best_cost_0_is_less(i), lastwinner2_best_index_0(2 * i + 1),
        lastwinner2_best_index_0(2 * i));
    end loop;
    -- lastwinner4
    for i in 0 to 3 loop
      lastwinner4_best_cost_0_is_less(i) := (lastwinner3_best_cost_0(2 * i + 1) - lastwinner3_best_cost_0(2 * i)) < 0;
    end loop;
    lastwinner4_tag <= lastwinner3_tag;
    for i in 0 to 3 loop
      lastwinner4_best_cost_0(i) <= choice(lastwinner4_best_cost_0_is_less(i), lastwinner3_best_cost_0(2 * i + 1),
        lastwinner3_best_cost_0(2 * i));
      lastwinner4_best_index_0(i) <= choice(lastwinner4_best_cost_0_is_less(i), lastwinner3_best_index_0(2 * i + 1),
        lastwinner3_best_index_0(2 * i));
    end loop;
    -- lastwinner5
    lastwinner5_best_cost_0_is_less(0) := (lastwinner4_best_cost_0(1) - lastwinner4_best_cost_0(0)) < 0;
    lastwinner5_best_cost_0_is_less(1) := (lastwinner4_best_cost_0(3) - lastwinner4_best_cost_0(2)) < 0;
    lastwinner5_tag <= lastwinner4_tag;
    for i in 0 to 1 loop
      lastwinner5_best_cost_0(i) <= choice(lastwinner5_best_cost_0_is_less(i), lastwinner4_best_cost_0(2 * i + 1),
        lastwinner4_best_cost_0(2 * i));
      lastwinner5_best_index_0(i) <= choice(lastwinner5_best_cost_0_is_less(i), lastwinner4_best_index_0(2 * i + 1),
        lastwinner4_best_index_0(2 * i));
    end loop;
    -- lastwinner6
    lastwinner6_tag <= lastwinner5_tag;
    lastwinner6_best_index_0_0 <= choice((lastwinner5_best_cost_0(1) - lastwinner5_best_cost_0(0)) < 0,
      lastwinner5_best_index_0(1), lastwinner5_best_index_0(0));
    -- traceback
    traceback_state_is_equals(1) := traceback_falling = 1;
    traceback_state_sum := traceback_state + 1;
    traceback_state_is_equals(2) := traceback_falling = 2;
    traceback_state_sum_2 := (traceback_state / 2) + 3;
    traceback_state_is_equals(3) := traceback_falling = 0;
    traceback_state_all := (traceback_decision = 3) and traceback_state_is_equals(3);
    traceback_state_sum_3 := traceback_state + 255;
    traceback_state_choices(1) := choice(traceback_state_all, traceback_state_sum_3 mod 256, traceback_state);
    traceback_state_choices(2) := choice(traceback_state_is_equals(2), ((traceback_state_sum_2 mod 128) * 2) +
      (traceback_state mod 2), traceback_state_choices(1));
    traceback_state_choices(3) := choice(traceback_state_is_equals(1), traceback_state_sum mod 256,
      traceback_state_choices(2));
    traceback_decision_values(1) := (((traceback_state_sum mod 256) / 16) mod 2) = 1;
    traceback_decision_values(2) := (((traceback_state_sum mod 256) / 8) mod 2) = 1;
    traceback_decision_values(3) := (((traceback_state_sum mod 256) / 4) mod 2) = 1;
    traceback_decision_values(4) := (((traceback_state_sum mod 256) / 2) mod 2) = 1;
    for i in 0 to 1 loop
      traceback_decision_choices(31 * i + 1) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(63 - 32
        * i), decisions_ready_decision(62 - 32 * i));
      traceback_decision_choices(31 * i + 2) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(61 - 32
        * i), decisions_ready_decision(60 - 32 * i));
      traceback_decision_choices(31 * i + 3) := choice(traceback_decision_values(4), traceback_decision_choices(31 * i
        + 1), traceback_decision_choices(31 * i + 2));
      traceback_decision_choices(31 * i + 4) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(59 - 32
        * i), decisions_ready_decision(58 - 32 * i));
      traceback_decision_choices(31 * i + 5) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(57 - 32
        * i), decisions_ready_decision(56 - 32 * i));
      traceback_decision_choices(31 * i + 6) := choice(traceback_decision_values(4), traceback_decision_choices(31 * i
        + 4), traceback_decision_choices(31 * i + 5));
      traceback_decision_choices(31 * i + 7) := choice(traceback_decision_values(3), traceback_decision_choices(31 * i
        + 3), traceback_decision_choices(31 * i + 6));
      traceback_decision_choices(31 * i + 8) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(55 - 32
        * i), decisions_ready_decision(54 - 32 * i));
      traceback_decision_choices(31 * i + 9) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(53 - 32
        * i), decisions_ready_decision(52 - 32 * i));
      traceback_decision_choices(31 * i + 10) := choice(traceback_decision_values(4), traceback_decision_choices(31 * i
        + 8), traceback_decision_choices(31 * i + 9));
      traceback_decision_choices(31 * i + 11) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(51 -
        32 * i), decisions_ready_decision(50 - 32 * i));
      traceback_decision_choices(31 * i + 12) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(49 -
        32 * i), decisions_ready_decision(48 - 32 * i));
      traceback_decision_choices(31 * i + 13) := choice(traceback_decision_values(4), traceback_decision_choices(31 * i
        + 11), traceback_decision_choices(31 * i + 12));
      traceback_decision_choices(31 * i + 14) := choice(traceback_decision_values(3), traceback_decision_choices(31 * i
        + 10), traceback_decision_choices(31 * i + 13));
      traceback_decision_choices(31 * i + 15) := choice(traceback_decision_values(2), traceback_decision_choices(31 * i
        + 7), traceback_decision_choices(31 * i + 14));
      traceback_decision_choices(31 * i + 16) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(47 -
        32 * i), decisions_ready_decision(46 - 32 * i));
      traceback_decision_choices(31 * i + 17) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(45 -
        32 * i), decisions_ready_decision(44 - 32 * i));
      traceback_decision_choices(31 * i + 18) := choice(traceback_decision_values(4), traceback_decision_choices(31 * i
        + 16), traceback_decision_choices(31 * i + 17));
      traceback_decision_choices(31 * i + 19) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(43 -
        32 * i), decisions_ready_decision(42 - 32 * i));
      traceback_decision_choices(31 * i + 20) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(41 -
        32 * i), decisions_ready_decision(40 - 32 * i));
      traceback_decision_choices(31 * i + 21) := choice(traceback_decision_values(4), traceback_decision_choices(31 * i
        + 19), traceback_decision_choices(31 * i + 20));
      traceback_decision_choices(31 * i + 22) := choice(traceback_decision_values(3), traceback_decision_choices(31 * i
        + 18), traceback_decision_choices(31 * i + 21));
      traceback_decision_choices(31 * i + 23) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(39 -
        32 * i), decisions_ready_decision(38 - 32 * i));
      traceback_decision_choices(31 * i + 24) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(37 -
        32 * i), decisions_ready_decision(36 - 32 * i));
      traceback_decision_choices(31 * i + 25) := choice(traceback_decision_values(4), traceback_decision_choices(31 * i
        + 23), traceback_decision_choices(31 * i + 24));
      traceback_decision_choices(31 * i + 26) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(35 -
        32 * i), decisions_ready_decision(34 - 32 * i));
      traceback_decision_choices(31 * i + 27) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(33 -
        32 * i), decisions_ready_decision(32 - 32 * i));
      traceback_decision_choices(31 * i + 28) := choice(traceback_decision_values(4), traceback_decision_choices(31 * i
        + 26), traceback_decision_choices(31 * i + 27));
      traceback_decision_choices(31 * i + 29) := choice(traceback_decision_values(3), traceback_decision_choices(31 * i
        + 25), traceback_decision_choices(31 * i + 28));
      traceback_decision_choices(31 * i + 30) := choice(traceback_decision_values(2), traceback_decision_choices(31 * i
        + 22), traceback_decision_choices(31 * i + 29));
      traceback_decision_choices(31 * i + 31) := choice(traceback_decision_values(1), traceback_decision_choices(31 * i
        + 15), traceback_decision_choices(31 * i + 30));
    end loop;
    traceback_decision_choices(63) := choice((((traceback_state_sum mod 256) / 32) mod 2) = 1,
      traceback_decision_choices(31), traceback_decision_choices(62));
    traceback_decision_values(5) := (((traceback_state_sum_2 mod 128) / 8) mod 2) = 1;
    traceback_decision_values(6) := (((traceback_state_sum_2 mod 128) / 4) mod 2) = 1;
    traceback_decision_values(7) := (((traceback_state_sum_2 mod 128) / 2) mod 2) = 1;
    for i in 0 to 1 loop
      traceback_decision_choices(31 * i + 64) := choice(is_set(traceback_state, 0), decisions_ready_decision(63 - 32 *
        i), decisions_ready_decision(62 - 32 * i));
      traceback_decision_choices(31 * i + 65) := choice(is_set(traceback_state, 0), decisions_ready_decision(61 - 32 *
        i), decisions_ready_decision(60 - 32 * i));
      traceback_decision_choices(31 * i + 66) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(31
        * i + 64), traceback_decision_choices(31 * i + 65));
      traceback_decision_choices(31 * i + 67) := choice(is_set(traceback_state, 0), decisions_ready_decision(59 - 32 *
        i), decisions_ready_decision(58 - 32 * i));
      traceback_decision_choices(31 * i + 68) := choice(is_set(traceback_state, 0), decisions_ready_decision(57 - 32 *
        i), decisions_ready_decision(56 - 32 * i));
      traceback_decision_choices(31 * i + 69) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(31
        * i + 67), traceback_decision_choices(31 * i + 68));
      traceback_decision_choices(31 * i + 70) := choice(traceback_decision_values(7), traceback_decision_choices(31 * i
        + 66), traceback_decision_choices(31 * i + 69));
      traceback_decision_choices(31 * i + 71) := choice(is_set(traceback_state, 0), decisions_ready_decision(55 - 32 *
        i), decisions_ready_decision(54 - 32 * i));
      traceback_decision_choices(31 * i + 72) := choice(is_set(traceback_state, 0), decisions_ready_decision(53 - 32 *
        i), decisions_ready_decision(52 - 32 * i));
      traceback_decision_choices(31 * i + 73) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(31
        * i + 71), traceback_decision_choices(31 * i + 72));
      traceback_decision_choices(31 * i + 74) := choice(is_set(traceback_state, 0), decisions_ready_decision(51 - 32 *
        i), decisions_ready_decision(50 - 32 * i));
      traceback_decision_choices(31 * i + 75) := choice(is_set(traceback_state, 0), decisions_ready_decision(49 - 32 *
        i), decisions_ready_decision(48 - 32 * i));
      traceback_decision_choices(31 * i + 76) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(31
        * i + 74), traceback_decision_choices(31 * i + 75));
      traceback_decision_choices(31 * i + 77) := choice(traceback_decision_values(7), traceback_decision_choices(31 * i
        + 73), traceback_decision_choices(31 * i + 76));
      traceback_decision_choices(31 * i + 78) := choice(traceback_decision_values(6), traceback_decision_choices(31 * i
        + 70), traceback_decision_choices(31 * i + 77));
      traceback_decision_choices(31 * i + 79) := choice(is_set(traceback_state, 0), decisions_ready_decision(47 - 32 *
        i), decisions_ready_decision(46 - 32 * i));
      traceback_decision_choices(31 * i + 80) := choice(is_set(traceback_state, 0), decisions_ready_decision(45 - 32 *
        i), decisions_ready_decision(44 - 32 * i));
      traceback_decision_choices(31 * i + 81) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(31
        * i + 79), traceback_decision_choices(31 * i + 80));
      traceback_decision_choices(31 * i + 82) := choice(is_set(traceback_state, 0), decisions_ready_decision(43 - 32 *
        i), decisions_ready_decision(42 - 32 * i));
      traceback_decision_choices(31 * i + 83) := choice(is_set(traceback_state, 0), decisions_ready_decision(41 - 32 *
        i), decisions_ready_decision(40 - 32 * i));
      traceback_decision_choices(31 * i + 84) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(31
        * i + 82), traceback_decision_choices(31 * i + 83));
      traceback_decision_choices(31 * i + 85) := choice(traceback_decision_values(7), traceback_decision_choices(31 * i
        + 81), traceback_decision_choices(31 * i + 84));
      traceback_decision_choices(31 * i + 86) := choice(is_set(traceback_state, 0), decisions_ready_decision(39 - 32 *
        i), decisions_ready_decision(38 - 32 * i));
      traceback_decision_choices(31 * i + 87) := choice(is_set(traceback_state, 0), decisions_ready_decision(37 - 32 *
        i), decisions_ready_decision(36 - 32 * i));
      traceback_decision_choices(31 * i + 88) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(31
        * i + 86), traceback_decision_choices(31 * i + 87));
      traceback_decision_choices(31 * i + 89) := choice(is_set(traceback_state, 0), decisions_ready_decision(35 - 32 *
        i), decisions_ready_decision(34 - 32 * i));
      traceback_decision_choices(31 * i + 90) := choice(is_set(traceback_state, 0), decisions_ready_decision(33 - 32 *
        i), decisions_ready_decision(32 - 32 * i));
      traceback_decision_choices(31 * i + 91) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(31
        * i + 89), traceback_decision_choices(31 * i + 90));
      traceback_decision_choices(31 * i + 92) := choice(traceback_decision_values(7), traceback_decision_choices(31 * i
        + 88), traceback_decision_choices(31 * i + 91));
      traceback_decision_choices(31 * i + 93) := choice(traceback_decision_values(6), traceback_decision_choices(31 * i
        + 85), traceback_decision_choices(31 * i + 92));
      traceback_decision_choices(31 * i + 94) := choice(traceback_decision_values(5), traceback_decision_choices(31 * i
        + 78), traceback_decision_choices(31 * i + 93));
    end loop;
    traceback_decision_choices(126) := choice((((traceback_state_sum_2 mod 128) / 16) mod 2) = 1,
      traceback_decision_choices(94), traceback_decision_choices(125));
    traceback_decision_values(8) := (((traceback_state_sum_3 mod 256) / 16) mod 2) = 1;
    traceback_decision_values(9) := (((traceback_state_sum_3 mod 256) / 8) mod 2) = 1;
    traceback_decision_values(10) := (((traceback_state_sum_3 mod 256) / 4) mod 2) = 1;
    traceback_decision_values(11) := (((traceback_state_sum_3 mod 256) / 2) mod 2) = 1;
    for i in 0 to 1 loop
      traceback_decision_choices(31 * i + 127) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(63
        - 32 * i), decisions_ready_decision(62 - 32 * i));
      traceback_decision_choices(31 * i + 128) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(61
        - 32 * i), decisions_ready_decision(60 - 32 * i));
      traceback_decision_choices(31 * i + 129) := choice(traceback_decision_values(11), traceback_decision_choices(31 *
        i + 127), traceback_decision_choices(31 * i + 128));
      traceback_decision_choices(31 * i + 130) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(59
        - 32 * i), decisions_ready_decision(58 - 32 * i));
      traceback_decision_choices(31 * i + 131) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(57
        - 32 * i), decisions_ready_decision(56 - 32 * i));
      traceback_decision_choices(31 * i + 132) := choice(traceback_decision_values(11), traceback_decision_choices(31 *
        i + 130), traceback_decision_choices(31 * i + 131));
      traceback_decision_choices(31 * i + 133) := choice(traceback_decision_values(10), traceback_decision_choices(31 *
        i + 129), traceback_decision_choices(31 * i + 132));
      traceback_decision_choices(31 * i + 134) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(55
        - 32 * i), decisions_ready_decision(54 - 32 * i));
      traceback_decision_choices(31 * i + 135) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(53
        - 32 * i), decisions_ready_decision(52 - 32 * i));
      traceback_decision_choices(31 * i + 136) := choice(traceback_decision_values(11), traceback_decision_choices(31 *
        i + 134), traceback_decision_choices(31 * i + 135));
      traceback_decision_choices(31 * i + 137) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(51
        - 32 * i), decisions_ready_decision(50 - 32 * i));
      traceback_decision_choices(31 * i + 138) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(49
        - 32 * i), decisions_ready_decision(48 - 32 * i));
      traceback_decision_choices(31 * i + 139) := choice(traceback_decision_values(11), traceback_decision_choices(31 *
        i + 137), traceback_decision_choices(31 * i + 138));
      traceback_decision_choices(31 * i + 140) := choice(traceback_decision_values(10), traceback_decision_choices(31 *
        i + 136), traceback_decision_choices(31 * i + 139));
      traceback_decision_choices(31 * i + 141) := choice(traceback_decision_values(9), traceback_decision_choices(31 *
        i + 133), traceback_decision_choices(31 * i + 140));
      traceback_decision_choices(31 * i + 142) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(47
        - 32 * i), decisions_ready_decision(46 - 32 * i));
      traceback_decision_choices(31 * i + 143) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(45
        - 32 * i), decisions_ready_decision(44 - 32 * i));
      traceback_decision_choices(31 * i + 144) := choice(traceback_decision_values(11), traceback_decision_choices(31 *
        i + 142), traceback_decision_choices(31 * i + 143));
      traceback_decision_choices(31 * i + 145) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(43
        - 32 * i), decisions_ready_decision(42 - 32 * i));
      traceback_decision_choices(31 * i + 146) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(41
        - 32 * i), decisions_ready_decision(40 - 32 * i));
      traceback_decision_choices(31 * i + 147) := choice(traceback_decision_values(11), traceback_decision_choices(31 *
        i + 145), traceback_decision_choices(31 * i + 146));
      traceback_decision_choices(31 * i + 148) := choice(traceback_decision_values(10), traceback_decision_choices(31 *
        i + 144), traceback_decision_choices(31 * i + 147));
      traceback_decision_choices(31 * i + 149) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(39
        - 32 * i), decisions_ready_decision(38 - 32 * i));
      traceback_decision_choices(31 * i + 150) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(37
        - 32 * i), decisions_ready_decision(36 - 32 * i));
      traceback_decision_choices(31 * i + 151) := choice(traceback_decision_values(11), traceback_decision_choices(31 *
        i + 149), traceback_decision_choices(31 * i + 150));
      traceback_decision_choices(31 * i + 152) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(35
        - 32 * i), decisions_ready_decision(34 - 32 * i));
      traceback_decision_choices(31 * i + 153) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(33
        - 32 * i), decisions_ready_decision(32 - 32 * i));
      traceback_decision_choices(31 * i + 154) := choice(traceback_decision_values(11), traceback_decision_choices(31 *
        i + 152), traceback_decision_choices(31 * i + 153));
      traceback_decision_choices(31 * i + 155) := choice(traceback_decision_values(10), traceback_decision_choices(31 *
        i + 151), traceback_decision_choices(31 * i + 154));
      traceback_decision_choices(31 * i + 156) := choice(traceback_decision_values(9), traceback_decision_choices(31 *
        i + 148), traceback_decision_choices(31 * i + 155));
      traceback_decision_choices(31 * i + 157) := choice(traceback_decision_values(8), traceback_decision_choices(31 *
        i + 141), traceback_decision_choices(31 * i + 156));
    end loop;
    traceback_decision_choices(189) := choice((((traceback_state_sum_3 mod 256) / 32) mod 2) = 1,
      traceback_decision_choices(157), traceback_decision_choices(188));
    traceback_decision_values(12) := is_set(traceback_state, 4);
    traceback_decision_values(13) := is_set(traceback_state, 3);
    traceback_decision_values(14) := is_set(traceback_state, 2);
    traceback_decision_values(15) := is_set(traceback_state, 1);
    for i in 0 to 1 loop
      traceback_decision_choices(15 * i + 190) := choice(traceback_decision_values(15), traceback_decision_choices(31 *
        i + 64), traceback_decision_choices(31 * i + 65));
      traceback_decision_choices(15 * i + 191) := choice(traceback_decision_values(15), traceback_decision_choices(31 *
        i + 67), traceback_decision_choices(31 * i + 68));
      traceback_decision_choices(15 * i + 192) := choice(traceback_decision_values(14), traceback_decision_choices(15 *
        i + 190), traceback_decision_choices(15 * i + 191));
      traceback_decision_choices(15 * i + 193) := choice(traceback_decision_values(15), traceback_decision_choices(31 *
        i + 71), traceback_decision_choices(31 * i + 72));
      traceback_decision_choices(15 * i + 194) := choice(traceback_decision_values(15), traceback_decision_choices(31 *
        i + 74), traceback_decision_choices(31 * i + 75));
      traceback_decision_choices(15 * i + 195) := choice(traceback_decision_values(14), traceback_decision_choices(15 *
        i + 193), traceback_decision_choices(15 * i + 194));
      traceback_decision_choices(15 * i + 196) := choice(traceback_decision_values(13), traceback_decision_choices(15 *
        i + 192), traceback_decision_choices(15 * i + 195));
      traceback_decision_choices(15 * i + 197) := choice(traceback_decision_values(15), traceback_decision_choices(31 *
        i + 79), traceback_decision_choices(31 * i + 80));
      traceback_decision_choices(15 * i + 198) := choice(traceback_decision_values(15), traceback_decision_choices(31 *
        i + 82), traceback_decision_choices(31 * i + 83));
      traceback_decision_choices(15 * i + 199) := choice(traceback_decision_values(14), traceback_decision_choices(15 *
        i + 197), traceback_decision_choices(15 * i + 198));
      traceback_decision_choices(15 * i + 200) := choice(traceback_decision_values(15), traceback_decision_choices(31 *
        i + 86), traceback_decision_choices(31 * i + 87));
      traceback_decision_choices(15 * i + 201) := choice(traceback_decision_values(15), traceback_decision_choices(31 *
        i + 89), traceback_decision_choices(31 * i + 90));
      traceback_decision_choices(15 * i + 202) := choice(traceback_decision_values(14), traceback_decision_choices(15 *
        i + 200), traceback_decision_choices(15 * i + 201));
      traceback_decision_choices(15 * i + 203) := choice(traceback_decision_values(13), traceback_decision_choices(15 *
        i + 199), traceback_decision_choices(15 * i + 202));
      traceback_decision_choices(15 * i + 204) := choice(traceback_decision_values(12), traceback_decision_choices(15 *
        i + 196), traceback_decision_choices(15 * i + 203));
    end loop;
    traceback_decision_choices(220) := choice(is_set(traceback_state, 5), traceback_decision_choices(204),
      traceback_decision_choices(219));
    traceback_decision_choices(221) := choice(traceback_state_all, traceback_decision_choices(189),
      traceback_decision_choices(220));
    traceback_decision_choices(222) := choice(traceback_state_is_equals(2), traceback_decision_choices(126),
      traceback_decision_choices(221));
    traceback_decision_choices(223) := choice(traceback_state_is_equals(1), traceback_decision_choices(63),
      traceback_decision_choices(222));
    if entry_tag.valid then
      traceback_tags_held_output_column(0) <= entry_turned_output_column;
      traceback_tags_held_start_of_frame(0) <= entry_turned_start_of_frame;
      traceback_tags_held_output_column(1) <= traceback_tags_held_output_column(0);
      traceback_tags_held_start_of_frame(1) <= traceback_tags_held_start_of_frame(0);
      traceback_state <= choice(decisions_comes(0), traceback_state_choices(3), last_state);
      traceback_decision <= choice(decisions_comes(0), traceback_decision_choices(223), 0);
      traceback_falling <= choice(((((traceback_decision + 255) mod 256) / 2) = 0) and decisions_comes(0) and
        traceback_state_is_equals(3), traceback_decision, 0);
    end if;
    traceback_out_disparity_0 <= traceback_state;
    traceback_out_passed_0 <= is_set(traceback_falling, 1) or is_set(traceback_falling, 0) or (not
      is_set(traceback_decision, 1)) or (not is_set(traceback_decision, 0));
    traceback_out_tag.map_column <= decisions_comes(1);
    traceback_out_tag.output_column <= traceback_tags_held_output_column(1);
    traceback_out_tag.start_of_frame <= traceback_tags_held_start_of_frame(1);
    traceback_out_tag.end_of_line <= last_tags_held_end_of_line(1);
    -- turn
    turn_order_address_anys(1) := turn_order_inside or (not traceback_out_tag.map_column) or (not last_tag.valid);
    turn_order_address_choice := choice(turn_order_falls, 2047, 1);
    turn_order_address_choice_2 := choice(turn_order_falls, 0, 309);
    turn_order_address_anys(2) := (not traceback_out_tag.map_column) or (not last_tag.valid);
    if not turn_order_address_anys(2) then
      turn_order_address <= choice(turn_order_address_anys(1), (turn_order_address_choice + turn_order_address) mod
        2048, turn_order_address_choice_2 * 4);
    end if;
    turn_order_falls_all := (not turn_order_inside) and traceback_out_tag.map_column and last_tag.valid;
    turn_order_complete_all := traceback_out_tag.map_column and last_tag.valid;
    turn_order_turned_map_column <= traceback_out_tag.map_column;
    turn_order_turned_first_column <= turn_order_falls_all;
    turn_newest <= (as_number(traceback_out_passed_0) * 256) + traceback_out_disparity_0;
    turn_comes <= turn_order_complete_all;
    turn_read_tag.map_column <= turn_order_turned_map_column;
    turn_read_tag.first_column <= turn_order_turned_first_column;
    turn_ready <= to_integer(turn_read_words_0);
    turn_ready_tag <= turn_read_tag;
    turn_order_falls <= choice(turn_order_falls, turn_order_address_anys(1), turn_order_falls_all);
    turn_order_complete <= choice(traceback_out_tag.end_of_line, turn_order_complete or turn_order_complete_all,
      turn_order_complete and turn_order_address_anys(2));
    if last_tag.valid then turn_order_inside <= traceback_out_tag.map_column; end if;
    if turn_order_falls_all then
      turn_order_output <= traceback_out_tag.output_column;
      turn_order_first <= traceback_out_tag.start_of_frame;
    end if;
    if turn_comes then
      turn_write_words_0 <= turn_newest;
      turn_write_place <= turn_order_address;
    end if;
    -- fill
    fill_out_disparity_0_choice := choice(turn_ready_tag.first_column, 0, fill_out_disparity_0);
    fill_out_disparity_0_all := lastwinner3_tag.valid and turn_ready_tag.map_column;
    if fill_out_disparity_0_all then
      fill_out_disparity_0 <= choice(is_set(turn_ready, 8), turn_ready mod 256, fill_out_disparity_0_choice);
    end if;
    fill_out_passed_0 <= is_set(turn_ready, 8);
    fill_out_tag_map_column <= turn_ready_tag.map_column;
    -- map
    map_counter_column_is_equal := map_counter_column = 1236;
    if other_0 then
      map_counter_column <= choice(is_set(other(4), 0) or map_counter_column_is_equal, 0, (map_counter_column + 1) mod
        2048);
    end if;
    map_counter_group_is_equals(1) := map_counter_group = 639;
    map_counter_group_all := map_counter_group_is_equals(1) and map_counter_column_is_equal;
    map_counter_group_choice := choice(map_counter_group_all, 5, 0);
    map_counter_group_differs := map_counter_group /= 641;
    map_counter_group_is_equals(2) := map_counter_group = 640;
    map_counter_group_choices(2) := choice(map_counter_next_frame and map_counter_group_is_equals(2), 1,
      (map_counter_group + 1) mod 1024);
    map_counter_group_choices(3) := choice(map_counter_group_differs and other_0 and map_counter_column_is_equal,
      map_counter_group_choices(2), map_counter_group);
    map_counter_next_frame_choices(1) := choice(map_counter_column_is_equal, map_counter_next_frame and
      (map_counter_group /= 640), map_counter_next_frame);
    map_counter_next_frame_choices(2) := choice(map_counter_group_differs, map_counter_next_frame_choices(1),
      map_counter_next_frame);
    map_counter_next_frame_choices(3) := choice(map_counter_group_all, other_0, other_0 and (not is_set(other(4), 0)));
    map_counter_next_frame_choices(4) := choice(map_counter_next_frame_choices(2), map_counter_next_frame_choices(3),
      map_counter_group_is_equals(1) and map_counter_column_is_equal and other_0 and is_set(other(4), 0));
    map_line_ended_choice := choice(lastwinner4_tag.valid, 255 < other(4), map_line_ended);
    map_at_arrives_value := other_1(16) = '1';
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
    map_of_column_0_c_below_a_choices(1) := choice(map_read_bottom, map_of_column_0_b_below_a_values(1),
      map_of_column_0_c_below_a_values(1));
    map_of_column_0_c_below_a_values(2) := is_set(map_column(2), 1);
    map_of_column_0_c_below_a_choices(2) := choice(map_of_column_0_c_below_a_values(2), (not
      map_of_column_0_b_below_a_values(2)) and map_read_bottom, (not map_of_column_0_b_below_a_values(2)) or (not
      map_read_bottom));
    map_of_column_0_c_below_a_choices(3) := choice(map_of_column_0_c_below_a_choices(1),
      map_of_column_0_b_below_a_choices(2) and map_of_column_0_c_below_a_choices(2) and
      map_of_column_0_b_below_a_choices(1), (map_of_column_0_b_below_a_choices(2) and
      map_of_column_0_c_below_a_choices(2)) or map_of_column_0_b_below_a_choices(1));
    for i in 3 to 7 loop
      map_of_column_0_c_below_a_values(i) := is_set(map_column(2), i);
      map_of_column_0_c_below_a_choices(3 * i - 5) := choice(map_read_bottom, map_of_column_0_b_below_a_values(2 * i -
        3), map_of_column_0_c_below_a_values(i));
      map_of_column_0_c_below_a_choices(3 * i - 4) := choice(map_at_top, map_of_column_0_b_below_a_values(2 * i - 3),
        map_of_column_0_b_below_a_values(2 * i - 2));
      map_of_column_0_c_below_a_choices(3 * i - 3) := carry(map_of_column_0_c_below_a_choices(3 * i - 6), not
        map_of_column_0_c_below_a_choices(3 * i - 5), map_of_column_0_c_below_a_choices(3 * i - 4));
    end loop;
    map_of_column_0_c_below_a_choices(19) := choice(map_read_bottom, is_set(map_column(1), 8), is_set(map_column(2),
      8));
    map_of_column_0_c_below_a_choices(20) := choice(map_at_top, is_set(map_column(1), 8), is_set(other_2, 8));
    map_of_column_0_c_below_b_choices(1) := choice((not map_of_column_0_c_below_a_values(2)) and
      map_of_column_0_b_below_a_values(2) and (not map_read_bottom), map_of_column_0_c_below_a_values(1) and (not
      map_of_column_0_b_below_a_values(1)) and (not map_read_bottom), map_of_column_0_c_below_a_values(1) or (not
      map_of_column_0_b_below_a_values(1)) or map_read_bottom);
    for i in 2 to 6 loop
      map_of_column_0_c_below_b_choices(i) := choice(map_of_column_0_c_below_b_choices(i - 1),
        map_of_column_0_c_below_a_values(i + 1) or (not map_of_column_0_b_below_a_values(2 * i - 1)) or
        map_read_bottom, map_of_column_0_c_below_a_values(i + 1) and (not map_of_column_0_b_below_a_values(2 * i - 1))
        and (not map_read_bottom));
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
    map_counter_next_frame <= map_counter_next_frame_choices(4) or ((not other_0) and map_counter_next_frame);
    map_newest_0 <= (fill_out_disparity_0 * 2) + as_number(fill_out_passed_0);
    map_arrives <= other_0;
    map_behind <= map_line_ended and lastwinner4_tag.valid;
    map_rows_read_newest_0 <= map_newest_0;
    map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
    map_rows_ready_newest_0 <= map_rows_read_newest_0;
    map_read_bottom <= other_1(40) = '1';
    map_write_column <= to_integer(other_1(10 downto 0));
    map_column(1) <= map_rows_ready_words_0 / 512;
    map_column(2) <= map_rows_ready_newest_0;
    map_at_arrives <= map_at_arrives_value;
    map_at_behind <= other_1(24) = '1';
    map_at_top <= other_1(32) = '1';
    map_at_output <= other_1(48) = '1';
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
    map_counter_group <= choice(other_0 and is_set(other(4), 0), map_counter_group_choice * 128,
      map_counter_group_choices(3));
    map_line_ended <= choice(fill_out_tag_map_column, map_line_ended_choice, (not lastwinner4_tag.valid) and
      map_line_ended);
    map_of_column_0_a <= choice(map_at_top, map_column(1) / 2, other_2 / 2);
    map_of_column_0_c <= choice(map_read_bottom, map_column(1) / 2, map_column(2) / 2);
    map_of_column_0_b_below_a <= choice(map_of_column_0_b_below_a_choices(9), (not is_set(map_column(1), 8)) and
      is_set(other_2, 8) and (not map_at_top), (not is_set(map_column(1), 8)) or is_set(other_2, 8) or map_at_top);
    map_of_column_0_c_below_a <= carry(map_of_column_0_c_below_a_choices(18), not
      map_of_column_0_c_below_a_choices(19), map_of_column_0_c_below_a_choices(20));
    map_of_column_0_c_below_b <= choice(map_of_column_0_c_below_b_choices(6), (not is_set(map_column(2), 8)) and
      is_set(map_column(1), 8) and (not map_read_bottom), (not is_set(map_column(2), 8)) or is_set(map_column(1), 8) or
      map_read_bottom);
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
      map_rows_write_words_0 <= (map_rows_ready_words_0 / 512) + (map_rows_ready_newest_0 * 512);
      map_at_column <= to_integer(other_1(10 downto 0));
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
    other_0 <= fill_out_disparity_0_all;
    other_1 <= other_3;
    other_2 <= ((map_rows_ready_words_0 mod 512) / 2) * 2;
    other_3 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 641))), 1) &
      to_unsigned(as_number(map_counter_group_is_equals(2)), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
      to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) & to_unsigned(map_counter_column,
      16);
    other(4) <= other(7);
    other(5) <= (as_number(traceback_out_tag.end_of_line) * 256) + as_number(((not turn_order_inside) and
      traceback_out_tag.map_column and last_tag.valid and turn_order_first and turn_order_output and
      turn_order_complete));
    other(6 to 7) <= other(5 to 6);
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 642;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 641; raster_place_next_frame <= false; delay_column <= 0; delay_tag.valid <= false;
      delay_tag.map_column <= false; delay_tag.output_column <= false; delay_tag.start_of_frame <= false;
      delay_tag.end_of_line <= false; rows_read_column <= 0; rows_read_tag.valid <= false;
      rows_read_tag.map_column <= false; rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false;
      rows_read_tag.end_of_line <= false; rows_ready_column <= 0; rows_ready_tag.valid <= false;
      rows_ready_tag.map_column <= false; rows_ready_tag.output_column <= false; rows_ready_tag.start_of_frame <= false;
      rows_ready_tag.end_of_line <= false; rows_write_column <= 0; rows_tag.valid <= false;
      rows_tag.map_column <= false; rows_tag.output_column <= false; rows_tag.start_of_frame <= false;
      rows_tag.end_of_line <= false; slice0shift_tag.valid <= false; slice0shift_tag.map_column <= false;
      slice0shift_tag.output_column <= false; slice0shift_tag.start_of_frame <= false;
      slice0shift_tag.end_of_line <= false; slice0cost_pixels_first_tag.valid <= false;
      slice0cost_pixels_first_tag.map_column <= false; slice0cost_pixels_first_tag.output_column <= false;
      slice0cost_pixels_first_tag.start_of_frame <= false; slice0cost_pixels_first_tag.end_of_line <= false;
      slice0cost_pixels_tag.valid <= false; slice0cost_pixels_tag.map_column <= false;
      slice0cost_pixels_tag.output_column <= false; slice0cost_pixels_tag.start_of_frame <= false;
      slice0cost_pixels_tag.end_of_line <= false; slice0cost_pair_tag.valid <= false;
      slice0cost_pair_tag.map_column <= false; slice0cost_pair_tag.output_column <= false;
      slice0cost_pair_tag.start_of_frame <= false; slice0cost_pair_tag.end_of_line <= false;
      slice0cost_tag.valid <= false; slice0cost_tag.map_column <= false; slice0cost_tag.output_column <= false;
      slice0cost_tag.start_of_frame <= false; slice0cost_tag.end_of_line <= false;
      slice0window_centre_map_column_0 <= false; slice0window_centre_output_column_0 <= false;
      slice0window_centre_start_of_frame_0 <= false; slice0window_centre_end_of_line_0 <= false;
      slice0window_tag.valid <= false; slice0window_tag.map_column <= false; slice0window_tag.output_column <= false;
      slice0window_tag.start_of_frame <= false; slice0window_tag.end_of_line <= false;
      for i in 0 to 3 loop
        slice0_tag_valid(i) <= false; slice0_tag_map_column(i) <= false; slice0_tag_output_column(i) <= false;
        slice0_tag_start_of_frame(i) <= false; slice0_tag_end_of_line(i) <= false;
      end loop;
      entry_next_tag.valid <= false; entry_next_tag.map_column <= false; entry_next_tag.end_of_line <= false;
      entry_next_top <= false; entry_order_address <= 0; entry_order_falls <= false; entry_order_inside <= false;
      entry_order_complete <= false; entry_order_output <= false; entry_order_held_output <= false;
      entry_order_turned_output_column <= false; entry_order_turned_start_of_frame <= false; entry_tag.valid <= false;
      entry_tag.map_column <= false; entry_tag.end_of_line <= false; entry_place <= 0;
      entry_turned_output_column <= false; entry_turned_start_of_frame <= false; decisions_ready_inside <= false;
      decisions_comes <= (others => false); decisions_place <= (others => 0); decisions_write_place <= 0;
      last_tags_held_end_of_line(0) <= false; last_tags_held_map_column(1) <= false;
      last_tags_held_end_of_line(1) <= false; last_tags_held_map_column(2) <= false;
      last_tags_held_end_of_line(2) <= false; last_tags_moved <= false; last_tag <= (others => false);
      lastwinner1_tag <= (others => false); lastwinner2_tag <= (others => false); lastwinner3_tag <= (others => false);
      lastwinner4_tag <= (others => false); lastwinner5_tag <= (others => false); lastwinner6_tag <= (others => false);
      traceback_tags_held_output_column(0) <= false; traceback_tags_held_start_of_frame(0) <= false;
      traceback_tags_held_output_column(1) <= false; traceback_tags_held_start_of_frame(1) <= false;
      traceback_out_tag <= (others => false); turn_order_address <= 0; turn_order_falls <= false;
      turn_order_inside <= false; turn_order_complete <= false; turn_order_output <= false; turn_order_first <= false;
      turn_order_turned_map_column <= false; turn_comes <= false; turn_read_tag.map_column <= false;
      turn_write_place <= 0; turn_ready_tag.map_column <= false; fill_out_tag_map_column <= false;
      map_counter_column <= 0; map_counter_group <= 641; map_counter_next_frame <= false; map_arrives <= false;
      map_behind <= false; map_line_ended <= false; map_write_column <= 0; map_at_column <= 0; map_at_arrives <= false;
      map_at_behind <= false; map_at_top <= false; map_at_output <= false; map_comparing_column <= 0;
      map_comparing_arrives <= false; map_comparing_behind <= false; map_comparing_top <= false;
      map_comparing_output <= false; map_sorted_column <= 0; map_sorted_arrives <= false; map_sorted_behind <= false;
      map_sorted_top <= false; map_sorted_output <= false; map_window_complete <= false; map_window_first <= false;
      map_window_last <= false;
      for i in 0 to 2 loop
        map_waiting_complete(i) <= false; map_waiting_first(i) <= false; map_waiting_last(i) <= false;
      end loop;
      map_out_valid <= false; map_out_start_of_frame <= false; map_out_end_of_line <= false; other_0 <= false;
      other_1 <= to_unsigned(0, 49); other_3 <= to_unsigned(0, 49); other <= (others => 0);
    end if;
  end process;
end architecture;
