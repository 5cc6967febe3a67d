-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, trellis, configuration tiny_trellis: 40x12, 12 disparities, window 3x3, drop 4 or by 6, occlusion 7, 1 pixel pair a clock.
-- Options: disparities 12, slice_disparities 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_trellis
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_trellis is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 12;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 29;
    latency_clocks : positive := 28;
    flush_groups : positive := 204;
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
  assert width_px = 40 report "stereo_core_tiny_trellis: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 12 report "stereo_core_tiny_trellis: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 12 report "stereo_core_tiny_trellis: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_trellis: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_trellis: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 29 report "stereo_core_tiny_trellis: output_width_px is " & integer'image(output_width_px) & " but this core has 29" severity failure;
  assert latency_clocks = 28 report "stereo_core_tiny_trellis: latency_clocks is " & integer'image(latency_clocks) & " but this core has 28" severity failure;
  assert flush_groups = 204 report "stereo_core_tiny_trellis: flush_groups is " & integer'image(flush_groups) & " but this core has 204" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_trellis: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_trellis is
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
  type natural_13_1d is array (natural range <>) of natural range 0 to 13;
  type natural_13_2d is array (natural range <>, natural range <>) of natural range 0 to 13;
  type natural_144_1d is array (natural range <>) of natural range 0 to 144;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_16777215_2d is array (natural range <>, natural range <>) of natural range 0 to 16777215;
  type natural_1_to_2_1d is array (natural range <>) of natural range 1 to 2;
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
  type natural_511_2d is array (natural range <>, natural range <>) of natural range 0 to 511;
  type natural_72_1d is array (natural range <>) of natural range 0 to 72;
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
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
  type tag_3_b is record
    map_column, output_column, first_column : boolean;
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
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16777215;
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
    entry_order_held_output, entry_order_turned_output_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag : tag_4;
  signal entry_turned_output_column, entry_turned_start_of_frame : boolean;
  signal entry_order_address, entry_place : natural range 0 to 31;
  -- forward
  signal forward_next_cost : natural_13_1d(0 to 11);
  signal forward_next_first : boolean;
  signal forward_far : boolean_1d(0 to 5);
  signal forward_pair_cost : natural_31_1d(0 to 11);
  signal forward_path, forward_stayed : natural_511_1d(0 to 11);
  signal forward_occluding : natural_511_1d(0 to 10);
  signal forward_dropped : natural_511_1d(0 to 11);
  signal forward_decision : natural_3_1d(0 to 11);  -- _# up to 2, 3 x 11
  -- decisions
  signal decisions_read_words_0 : unsigned(23 downto 0);
  signal decisions_ready_decision : natural_3_1d(0 to 11);
  signal decisions_ready_inside : boolean;
  signal decisions_comes : boolean_1d(0 to 2);
  signal decisions_place : natural_31_1d(0 to 2);
  signal decisions_write_place : natural range 0 to 31;
  signal decisions_write_words_0 : natural range 0 to 16777214;
  -- last
  signal last_tags_held_end_of_line : boolean_1d(0 to 2);  -- _#_end_of_line
  signal last_tags_held_map_column : boolean_1d(1 to 2);  -- _#_map_column
  signal last_tags_moved : boolean;
  signal last_tag : tag_3;
  signal last_path_0 : natural_511_1d(0 to 11);  -- _# up to 256, 511 x 11
  signal last_state : natural range 0 to 11;
  -- lastwinner1
  signal lastwinner1_best_cost_0 : natural_511_1d(0 to 5);
  signal lastwinner1_best_index_0_0 : boolean;
  signal lastwinner1_tag : tag_3;
  signal lastwinner1_best_index_0 : natural_11_1d(1 to 5);  -- _# up to 3, 5 .. 11
  -- lastwinner2
  signal lastwinner2_best_cost_0 : natural_511_1d(0 to 2);
  signal lastwinner2_best_index_0 : natural_11_1d(0 to 2);  -- _# up to 3, 7, 11
  signal lastwinner2_tag : tag_3;
  -- lastwinner3
  signal lastwinner3_best_cost_0 : natural_511_1d(0 to 1);
  signal lastwinner3_best_index_0 : natural_11_1d(0 to 1);  -- _# up to 7, 11
  signal lastwinner3_tag : tag_3;
  -- lastwinner4
  signal lastwinner4_best_index_0_0 : natural range 0 to 11;
  signal lastwinner4_tag : tag_3;
  -- traceback
  signal traceback_state, traceback_out_disparity_0 : natural range 0 to 255;
  signal traceback_decision, traceback_falling : natural range 0 to 3;
  signal traceback_tags_held_output_column : boolean_1d(0 to 1);  -- _#_output_column
  signal traceback_tags_held_start_of_frame : boolean_1d(0 to 1);  -- _#_start_of_frame
  signal traceback_out_passed_0 : boolean;
  signal traceback_out_tag : tag_4_b;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 31;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first,
    turn_order_held_output, turn_order_turned_map_column, turn_order_turned_output_column,
    turn_order_turned_first_column, turn_comes : boolean;
  signal turn_read_tag, turn_ready_tag : tag_3_b;
  signal turn_newest, turn_write_words_0, turn_ready : natural range 0 to 511;
  signal turn_read_words_0 : unsigned(8 downto 0);
  -- fill
  signal fill_out_disparity_0 : natural range 0 to 255;
  signal fill_out_passed_0, fill_out_tag_output_column : boolean;
  -- other
  signal other : natural_257_1d(0 to 3);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(fill_out_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(fill_out_passed_0), 1));
  disparity_valid <= as_bit(lastwinner4_tag.valid and fill_out_tag_output_column);
  disparity_start_of_frame <= as_bit(((other(1) mod 2) = 1) and lastwinner4_tag.valid and fill_out_tag_output_column);
  disparity_end_of_line <= as_bit(((other(1) / 256) = 1) and lastwinner4_tag.valid and fill_out_tag_output_column);

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

  decisions_read_words_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(entry_order_address, 5);
    write_address <= to_unsigned(decisions_write_place, 5);
    write_data <= to_unsigned(decisions_write_words_0, 24);
    cell : entity work.line_memory generic map (29, 24, 5)
      port map (clock, true, read_address, decisions_read_words_0, write_address, write_data);
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

  process
    variable transform_counter_group_is_equals, raster_place_group_is_equals,
      traceback_state_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable transform_counter_group_all, transform_read_column_inside_1_differs, transform_left_filter_feature_0_any,
      transform_left_filter_feature_0_is_equal, transform_right_filter_feature_0_any,
      transform_right_filter_feature_0_is_equal, transform_counter_next_frame_choice, raster_place_group_all,
      raster_place_group_choice_2, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less,
      delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less, delay_tag_map_column_is_less,
      entry_order_falls_any, entry_order_falls_all, entry_order_complete_any, entry_order_turned_output_column_choice,
      forward_far_1_any, decisions_write_words_0_all, lastwinner3_best_cost_0_0_is_less, traceback_state_all,
      turn_order_falls_all, turn_order_complete_all, turn_order_turned_output_column_choice : boolean;
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
    variable forward_pair_cost_sum : natural_26_1d(0 to 11);  -- _#_sum
    variable forward_path_value : boolean_1d(0 to 11);  -- _#_value
    variable forward_path_choice : natural_511_2d(0 to 11, 1 to 3);  -- _#_choice_#
    variable forward_path_any : boolean_1d(1 to 11);  -- _#_any
    variable forward_dropped_value : boolean_1d(0 to 5);  -- _#_value
    variable forward_dropped_choice : natural_511_1d(0 to 5);  -- _#_choice
    variable forward_decision_choice : natural_1_to_2_1d(0 to 5);  -- _#_choice
    variable forward_decision_choice_2 : natural_2_1d(1 to 5);  -- _#_choice_2
    variable forward_far_choice : boolean_1d(1 to 5);  -- _#_choice
    variable last_path_0_2_difference : integer range -255 to 256;
    variable lastwinner1_best_cost_0_is_less : boolean_1d(0 to 5);  -- _#_is_less
    variable lastwinner2_best_cost_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable traceback_state_sum : natural range 1 to 256;
    variable traceback_state_sum_2 : natural range 3 to 130;
    variable traceback_state_sum_3 : natural range 255 to 510;
    variable traceback_state_choices : natural_255_1d(1 to 3);  -- _choice_#
    variable traceback_decision_values : boolean_1d(1 to 3);  -- _value_#
    variable traceback_decision_choices : natural_3_1d(1 to 41);  -- _choice_#
    variable turn_order_address_anys : boolean_1d(1 to 2);  -- _any_#
    variable fill_out_disparity_0_choice : natural range 0 to 255;
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    forward_path_choice := (others => (others => 0)); transform_left_filter_feature_0_choice := (others => false);
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
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
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
    delay_row_inside_1_is_not_less := raster_place_group >= 1;
    delay_row_inside_1_is_less := raster_place_group < 13;
    delay_tag_first_cost_is_equal := raster_place_column = 11;
    delay_tag_map_column_is_not_less := raster_place_column >= 11;
    delay_tag_map_column_is_less := raster_place_column < 40;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
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
        slice0shift_search(i, 1) <= slice0shift_search(i, 0);
        slice0shift_search(i, 2) <= slice0shift_search(i, 1);
        slice0shift_search(i, 3) <= slice0shift_search(i, 2);
        slice0shift_search(i, 4) <= slice0shift_search(i, 3);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 4);
    slice0shift_search_out(1) <= slice0shift_search(1, 4);
    slice0shift_search_out(2) <= slice0shift_search(2, 4);
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
        slice1shift_search(i, 0) <= slice0shift_search_out(i);
        slice1shift_search(i, 1) <= slice1shift_search(i, 0);
        slice1shift_search(i, 2) <= slice1shift_search(i, 1);
        slice1shift_search(i, 3) <= slice1shift_search(i, 2);
        slice1shift_search(i, 4) <= slice1shift_search(i, 3);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    slice1shift_search_out(0) <= slice1shift_search(0, 4);
    slice1shift_search_out(1) <= slice1shift_search(1, 4);
    slice1shift_search_out(2) <= slice1shift_search(2, 4);
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
        slice2shift_search(i, 0) <= slice1shift_search_out(i);
        slice2shift_search(i, 1) <= slice2shift_search(i, 0);
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
    entry_order_falls_any := (not slice0_tag_valid(2)) or (not slice0_tag_map_column(2)) or entry_order_inside;
    entry_order_falls_all := slice0_tag_valid(2) and slice0_tag_map_column(2) and (not entry_order_inside);
    entry_order_complete_any := (not slice0_tag_valid(2)) or (not slice0_tag_map_column(2));
    entry_order_turned_output_column_choice := choice(entry_order_falls_all, entry_order_output and
      entry_order_complete, entry_order_held_output);
    for i in 0 to 4 loop entry_next_cost(i) <= slice0_held(2, i); end loop;
    for i in 5 to 9 loop entry_next_cost(i) <= slice1_held(1, i - 5); end loop;
    entry_next_cost(10) <= slice2_held_0(0);
    entry_next_cost(11) <= slice2_held_0(1);
    entry_next_tag.valid <= slice0_tag_valid(2);
    entry_next_tag.map_column <= slice0_tag_map_column(2);
    entry_next_tag.first_column <= slice0_tag_first_column(2);
    entry_next_tag.end_of_line <= slice0_tag_end_of_line(2);
    entry_order_turned_output_column <= entry_order_turned_output_column_choice and slice0_tag_map_column(2);
    entry_order_turned_start_of_frame <= slice0_tag_valid(2) and slice0_tag_map_column(2) and (not entry_order_inside)
      and entry_next_top and entry_order_output and entry_order_complete;
    entry_cost <= entry_next_cost;
    entry_tag <= entry_next_tag;
    entry_place <= entry_order_address;
    entry_turned_output_column <= entry_order_turned_output_column;
    entry_turned_start_of_frame <= entry_order_turned_start_of_frame;
    entry_order_falls <= choice(entry_order_falls, entry_order_falls_any, entry_order_falls_all);
    entry_order_complete <= choice(slice0_tag_end_of_line(2), entry_order_complete or (slice0_tag_valid(2) and
      slice0_tag_map_column(2)), entry_order_complete and entry_order_complete_any);
    if entry_order_falls_all then
      entry_next_top <= slice0_tag_start_of_frame(2);
      entry_order_output <= slice0_tag_output_column(2);
      entry_order_held_output <= entry_order_output and entry_order_complete;
    end if;
    entry_order_address_choice := choice(entry_order_falls, 31, 1);
    entry_order_address_choice_2 := choice(entry_order_falls, 0, 7);
    if not entry_order_complete_any then
      entry_order_address <= choice(entry_order_falls_any, (entry_order_address_choice + entry_order_address) mod 32,
        entry_order_address_choice_2 * 4);
    end if;
    if slice0_tag_valid(2) then entry_order_inside <= slice0_tag_map_column(2); end if;
    -- forward
    for i in 0 to 11 loop forward_pair_cost_sum(i) := entry_cost(i) + forward_next_cost(i); end loop;
    forward_path_value(0) := (((forward_dropped(0) - forward_stayed(0)) mod 512) / 256) = 1;
    forward_path_choice(0, 1) := choice(forward_path_value(0), forward_dropped(0), forward_stayed(0));
    forward_path_choice(0, 2) := choice(forward_next_first, 0, forward_path_choice(0, 1));
    for i in 1 to 11 loop
      forward_path_any(i) := (not ((((forward_occluding(i - 1) - forward_stayed(i)) mod 512) / 256) = 1)) or (not
        ((((forward_occluding(i - 1) - forward_dropped(i)) mod 512) / 256) = 1));
      forward_path_value(i) := (((forward_dropped(i) - forward_stayed(i)) mod 512) / 256) = 1;
      forward_path_choice(i, 1) := choice(forward_path_value(i), forward_dropped(i), forward_stayed(i));
      forward_path_choice(i, 2) := choice(forward_path_any(i), forward_path_choice(i, 1), forward_occluding(i - 1));
      forward_path_choice(i, 3) := choice(forward_next_first, 0, forward_path_choice(i, 2));
    end loop;
    for i in 0 to 5 loop
      forward_dropped_value(i) := (((forward_path(i + 6) - forward_path(i + 1)) mod 512) / 256) = 1;
      forward_dropped_choice(i) := choice(forward_dropped_value(i), forward_path(i + 6), forward_path(i + 1));
    end loop;
    forward_decision_choice(0) := choice(forward_far(0), 2, 1);
    for i in 1 to 5 loop
      forward_decision_choice(i) := choice(forward_far(i), 2, 1);
      forward_decision_choice_2(i) := choice(forward_path_value(i), forward_decision_choice(i), 0);
    end loop;
    if entry_tag.valid then
      forward_next_cost <= entry_cost;
      forward_next_first <= entry_tag.first_column;
      for i in 0 to 11 loop
        forward_pair_cost(i) <= (((forward_pair_cost_sum(i) / 4) + 1) * 4) + (forward_pair_cost_sum(i) mod 4);
      end loop;
      forward_path(0) <= forward_path_choice(0, 2);
      for i in 1 to 11 loop forward_path(i) <= forward_path_choice(i, 3); end loop;
      forward_stayed(0) <= (forward_path_choice(0, 2) + forward_next_cost(0)) mod 512;
      for i in 1 to 11 loop forward_stayed(i) <= (forward_path_choice(i, 3) + forward_next_cost(i)) mod 512; end loop;
      forward_far(0) <= forward_dropped_value(0) and (not forward_next_first);
      forward_occluding(0) <= choice(forward_next_first, 128, (forward_path_choice(0, 2) + 7) mod 512);
      for i in 1 to 10 loop
        forward_occluding(i) <= choice(forward_next_first, 128, (forward_path_choice(i, 3) + 7) mod 512);
      end loop;
      for i in 0 to 5 loop
        forward_dropped(i) <= choice(forward_next_first, 128, (forward_pair_cost(i) + forward_dropped_choice(i)) mod
          512);
      end loop;
      for i in 6 to 10 loop
        forward_dropped(i) <= choice(forward_next_first, 128, (forward_pair_cost(i) + forward_path(i + 1)) mod 512);
      end loop;
      forward_dropped(11) <= choice(forward_next_first, 128, (forward_pair_cost(11) + forward_path(11)) mod 512);
      forward_decision(0) <= choice(forward_path_value(0), forward_decision_choice(0), 0);
      for i in 1 to 5 loop
        forward_decision(i) <= choice(forward_path_any(i), forward_decision_choice_2(i), 3);
      end loop;
      for i in 6 to 11 loop
        forward_decision(i) <= choice(forward_path_any(i), as_number(forward_path_value(i)), 3);
      end loop;
    end if;
    forward_far_1_any := (not entry_tag.valid) or (not forward_next_first);
    for i in 1 to 5 loop
      forward_far_choice(i) := choice(forward_dropped_value(i), forward_far_1_any, not entry_tag.valid);
    end loop;
    for i in 1 to 5 loop
      forward_far(i) <= choice(forward_far(i), forward_far_choice(i), forward_dropped_value(i) and entry_tag.valid and
        (not forward_next_first));
    end loop;
    -- decisions
    if entry_tag.valid then
      decisions_ready_decision(0) <= to_integer(decisions_read_words_0(1 downto 0));
      decisions_ready_decision(1) <= (to_integer(decisions_read_words_0(7 downto 0)) / 4) mod 4;
      decisions_ready_decision(2) <= (to_integer(decisions_read_words_0(7 downto 0)) / 16) mod 4;
      decisions_ready_decision(3) <= to_integer(decisions_read_words_0(7 downto 0)) / 64;
      for i in 4 to 11 loop
        decisions_ready_decision(i) <= to_integer(decisions_read_words_0(2 * i + 1 downto 2 * i));
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
      decisions_write_words_0 <= (forward_decision(10) * 1048576) + (forward_decision(11) * 4194304) +
        (forward_decision(9) * 262144) + (forward_decision(8) * 65536) + (forward_decision(7) * 16384) +
        (forward_decision(6) * 4096) + (forward_decision(5) * 1024) + (forward_decision(4) * 256) +
        (forward_decision(3) * 64) + (forward_decision(2) * 16) + forward_decision(0) + (forward_decision(1) * 4);
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
    last_path_0_2_difference := 256 - forward_path(0);
    last_tags_moved <= entry_tag.valid;
    last_path_0(0) <= 256;
    last_path_0(1) <= ((((((forward_path(1) / 256) + 1) mod 2) * 256) + (forward_path(1) mod 256)) - forward_path(0))
      mod 512;
    for i in 2 to 11 loop last_path_0(i) <= (last_path_0_2_difference + forward_path(i)) mod 512; end loop;
    last_tag.valid <= last_tags_moved;
    last_tag.map_column <= last_tags_held_map_column(2);
    last_tag.end_of_line <= last_tags_held_end_of_line(2);
    if not ((not lastwinner4_tag.end_of_line) or (not lastwinner4_tag.map_column) or (not lastwinner4_tag.valid)) then
      last_state <= lastwinner4_best_index_0_0;
    end if;
    -- lastwinner1
    for i in 0 to 5 loop
      lastwinner1_best_cost_0_is_less(i) := (last_path_0(2 * i + 1) - last_path_0(2 * i)) < 0;
    end loop;
    lastwinner1_best_index_0_0 <= lastwinner1_best_cost_0_is_less(0);
    lastwinner1_tag <= last_tag;
    lastwinner1_best_cost_0(0) <= choice(lastwinner1_best_cost_0_is_less(0), last_path_0(1), last_path_0(0));
    for i in 1 to 5 loop
      lastwinner1_best_cost_0(i) <= choice(lastwinner1_best_cost_0_is_less(i), last_path_0(2 * i + 1), last_path_0(2 *
        i));
      lastwinner1_best_index_0(i) <= choice(lastwinner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- lastwinner2
    for i in 0 to 2 loop
      lastwinner2_best_cost_0_is_less(i) := (lastwinner1_best_cost_0(2 * i + 1) - lastwinner1_best_cost_0(2 * i)) < 0;
    end loop;
    lastwinner2_tag <= lastwinner1_tag;
    lastwinner2_best_cost_0(0) <= choice(lastwinner2_best_cost_0_is_less(0), lastwinner1_best_cost_0(1),
      lastwinner1_best_cost_0(0));
    lastwinner2_best_index_0(0) <= choice(lastwinner2_best_cost_0_is_less(0), lastwinner1_best_index_0(1),
      as_number(lastwinner1_best_index_0_0));
    for i in 1 to 2 loop
      lastwinner2_best_cost_0(i) <= choice(lastwinner2_best_cost_0_is_less(i), lastwinner1_best_cost_0(2 * i + 1),
        lastwinner1_best_cost_0(2 * i));
      lastwinner2_best_index_0(i) <= choice(lastwinner2_best_cost_0_is_less(i), lastwinner1_best_index_0(2 * i + 1),
        lastwinner1_best_index_0(2 * i));
    end loop;
    -- lastwinner3
    lastwinner3_best_cost_0_0_is_less := (lastwinner2_best_cost_0(1) - lastwinner2_best_cost_0(0)) < 0;
    lastwinner3_best_cost_0(1) <= lastwinner2_best_cost_0(2);
    lastwinner3_best_index_0(1) <= lastwinner2_best_index_0(2);
    lastwinner3_tag <= lastwinner2_tag;
    lastwinner3_best_cost_0(0) <= choice(lastwinner3_best_cost_0_0_is_less, lastwinner2_best_cost_0(1),
      lastwinner2_best_cost_0(0));
    lastwinner3_best_index_0(0) <= choice(lastwinner3_best_cost_0_0_is_less, lastwinner2_best_index_0(1),
      lastwinner2_best_index_0(0));
    -- lastwinner4
    lastwinner4_tag <= lastwinner3_tag;
    lastwinner4_best_index_0_0 <= choice((lastwinner3_best_cost_0(1) - lastwinner3_best_cost_0(0)) < 0,
      lastwinner3_best_index_0(1), lastwinner3_best_index_0(0));
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
    traceback_decision_values(1) := (((traceback_state_sum mod 256) / 2) mod 2) = 1;
    for i in 0 to 2 loop
      traceback_decision_choices(3 * i + 1) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(11 - 4 *
        i), decisions_ready_decision(10 - 4 * i));
      traceback_decision_choices(3 * i + 2) := choice(is_set(traceback_state_sum, 0), decisions_ready_decision(9 - 4 *
        i), decisions_ready_decision(8 - 4 * i));
      traceback_decision_choices(3 * i + 3) := choice(traceback_decision_values(1), traceback_decision_choices(3 * i +
        1), traceback_decision_choices(3 * i + 2));
    end loop;
    traceback_decision_choices(10) := choice((((traceback_state_sum mod 256) / 4) mod 2) = 1,
      traceback_decision_choices(6), traceback_decision_choices(9));
    traceback_decision_choices(11) := choice((((traceback_state_sum mod 256) / 8) mod 2) = 1,
      traceback_decision_choices(3), traceback_decision_choices(10));
    for i in 0 to 2 loop
      traceback_decision_choices(3 * i + 12) := choice(is_set(traceback_state, 0), decisions_ready_decision(11 - 4 *
        i), decisions_ready_decision(10 - 4 * i));
      traceback_decision_choices(3 * i + 13) := choice(is_set(traceback_state, 0), decisions_ready_decision(9 - 4 * i),
        decisions_ready_decision(8 - 4 * i));
      traceback_decision_choices(3 * i + 14) := choice(is_set(traceback_state_sum_2, 0), traceback_decision_choices(3 *
        i + 12), traceback_decision_choices(3 * i + 13));
    end loop;
    traceback_decision_choices(21) := choice((((traceback_state_sum_2 mod 128) / 2) mod 2) = 1,
      traceback_decision_choices(17), traceback_decision_choices(20));
    traceback_decision_choices(22) := choice((((traceback_state_sum_2 mod 128) / 4) mod 2) = 1,
      traceback_decision_choices(14), traceback_decision_choices(21));
    traceback_decision_values(2) := (((traceback_state_sum_3 mod 256) / 2) mod 2) = 1;
    for i in 0 to 2 loop
      traceback_decision_choices(3 * i + 23) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(11 -
        4 * i), decisions_ready_decision(10 - 4 * i));
      traceback_decision_choices(3 * i + 24) := choice(is_set(traceback_state_sum_3, 0), decisions_ready_decision(9 - 4
        * i), decisions_ready_decision(8 - 4 * i));
      traceback_decision_choices(3 * i + 25) := choice(traceback_decision_values(2), traceback_decision_choices(3 * i +
        23), traceback_decision_choices(3 * i + 24));
    end loop;
    traceback_decision_choices(32) := choice((((traceback_state_sum_3 mod 256) / 4) mod 2) = 1,
      traceback_decision_choices(28), traceback_decision_choices(31));
    traceback_decision_choices(33) := choice((((traceback_state_sum_3 mod 256) / 8) mod 2) = 1,
      traceback_decision_choices(25), traceback_decision_choices(32));
    traceback_decision_values(3) := is_set(traceback_state, 1);
    for i in 34 to 36 loop
      traceback_decision_choices(i) := choice(traceback_decision_values(3), traceback_decision_choices(3 * i - 90),
        traceback_decision_choices(3 * i - 89));
    end loop;
    traceback_decision_choices(37) := choice(is_set(traceback_state, 2), traceback_decision_choices(35),
      traceback_decision_choices(36));
    traceback_decision_choices(38) := choice(is_set(traceback_state, 3), traceback_decision_choices(34),
      traceback_decision_choices(37));
    traceback_decision_choices(39) := choice(traceback_state_all, traceback_decision_choices(33),
      traceback_decision_choices(38));
    traceback_decision_choices(40) := choice(traceback_state_is_equals(2), traceback_decision_choices(22),
      traceback_decision_choices(39));
    traceback_decision_choices(41) := choice(traceback_state_is_equals(1), traceback_decision_choices(11),
      traceback_decision_choices(40));
    if entry_tag.valid then
      traceback_tags_held_output_column(0) <= entry_turned_output_column;
      traceback_tags_held_start_of_frame(0) <= entry_turned_start_of_frame;
      traceback_tags_held_output_column(1) <= traceback_tags_held_output_column(0);
      traceback_tags_held_start_of_frame(1) <= traceback_tags_held_start_of_frame(0);
      traceback_state <= choice(decisions_comes(0), traceback_state_choices(3), last_state);
      traceback_decision <= choice(decisions_comes(0), traceback_decision_choices(41), 0);
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
    turn_order_address_choice := choice(turn_order_falls, 31, 1);
    turn_order_address_choice_2 := choice(turn_order_falls, 0, 7);
    turn_order_address_anys(2) := (not traceback_out_tag.map_column) or (not last_tag.valid);
    if not turn_order_address_anys(2) then
      turn_order_address <= choice(turn_order_address_anys(1), (turn_order_address_choice + turn_order_address) mod 32,
        turn_order_address_choice_2 * 4);
    end if;
    turn_order_falls_all := (not turn_order_inside) and traceback_out_tag.map_column and last_tag.valid;
    turn_order_complete_all := traceback_out_tag.map_column and last_tag.valid;
    turn_order_turned_output_column_choice := choice(turn_order_falls_all, turn_order_output and turn_order_complete,
      turn_order_held_output);
    turn_order_turned_map_column <= traceback_out_tag.map_column;
    turn_order_turned_output_column <= turn_order_turned_output_column_choice and traceback_out_tag.map_column;
    turn_order_turned_first_column <= turn_order_falls_all;
    turn_newest <= (as_number(traceback_out_passed_0) * 256) + traceback_out_disparity_0;
    turn_comes <= turn_order_complete_all;
    turn_read_tag.map_column <= turn_order_turned_map_column;
    turn_read_tag.output_column <= turn_order_turned_output_column;
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
      turn_order_held_output <= turn_order_output and turn_order_complete;
    end if;
    if turn_comes then
      turn_write_words_0 <= turn_newest;
      turn_write_place <= turn_order_address;
    end if;
    -- fill
    fill_out_disparity_0_choice := choice(turn_ready_tag.first_column, 0, fill_out_disparity_0);
    if turn_ready_tag.map_column and lastwinner3_tag.valid then
      fill_out_disparity_0 <= choice(is_set(turn_ready, 8), turn_ready mod 256, fill_out_disparity_0_choice);
    end if;
    fill_out_passed_0 <= is_set(turn_ready, 8);
    fill_out_tag_output_column <= turn_ready_tag.output_column;
    -- other
    other(0) <= other(3);
    other(1) <= other(0);
    other(2) <= (as_number(traceback_out_tag.end_of_line) * 256) + as_number(((not turn_order_inside) and
      traceback_out_tag.map_column and last_tag.valid and turn_order_first and turn_order_output and
      turn_order_complete));
    other(3) <= other(2);
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 14;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 13; raster_place_next_frame <= false; delay_column <= 0; delay_tag.valid <= false;
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
      for i in 0 to 2 loop
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
      lastwinner4_tag <= (others => false); traceback_tags_held_output_column(0) <= false;
      traceback_tags_held_start_of_frame(0) <= false; traceback_tags_held_output_column(1) <= false;
      traceback_tags_held_start_of_frame(1) <= false; traceback_out_tag <= (others => false); turn_order_address <= 0;
      turn_order_falls <= false; turn_order_inside <= false; turn_order_complete <= false; turn_order_output <= false;
      turn_order_first <= false; turn_order_held_output <= false; turn_order_turned_map_column <= false;
      turn_order_turned_output_column <= false; turn_comes <= false; turn_read_tag.map_column <= false;
      turn_read_tag.output_column <= false; turn_write_place <= 0; turn_ready_tag.map_column <= false;
      turn_ready_tag.output_column <= false; fill_out_tag_output_column <= false; other <= (others => 0);
    end if;
  end process;
end architecture;
