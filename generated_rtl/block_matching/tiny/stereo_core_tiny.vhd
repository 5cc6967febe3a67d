-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny: 32x12, 8 disparities, window 3x3, 1 pixel pair a clock.
-- Options: disparities 8, slice_disparities 3.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 8;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 24;
    latency_clocks : positive := 16;
    flush_groups : positive := 32;
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
  assert width_px = 32 report "stereo_core_tiny: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 8 report "stereo_core_tiny: disparities is " & integer'image(disparities) & " but this core has 8" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 24 report "stereo_core_tiny: output_width_px is " & integer'image(output_width_px) & " but this core has 24" severity failure;
  assert latency_clocks = 16 report "stereo_core_tiny: latency_clocks is " & integer'image(latency_clocks) & " but this core has 16" severity failure;
  assert flush_groups = 32 report "stereo_core_tiny: flush_groups is " & integer'image(flush_groups) & " but this core has 32" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny is
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
  type integer_minus_255_to_255_2d is array (natural range <>, natural range <>) of integer range -255 to 255;
  type natural_1534_1d is array (natural range <>) of natural range 0 to 1534;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_2301_1d is array (natural range <>) of natural range 0 to 2301;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_767_1d is array (natural range <>) of natural range 0 to 767;
  type tag_5 is record
    valid, border_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_start_of_frame, in_valid : boolean;
  signal in_left_pixel, in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 255;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 31;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 7;
  signal delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 31;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag : tag_5;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(15 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_search, rows_reference : natural_255_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : natural range 0 to 65535;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag : tag_5;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag, rows_tag : tag_5;
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 2, 0 to 2);
  signal slice0shift_reference, slice0shift_search_out : natural_255_1d(0 to 2);
  signal slice0shift_tag : tag_5;
  -- slice0cost
  signal slice0cost_difference : integer_minus_255_to_255_2d(0 to 2, 0 to 2);
  signal slice0cost_difference_tag : tag_5;
  signal slice0cost_negative_0 : boolean_1d(0 to 2);
  signal slice0cost_pair_tag, slice0cost_tag : tag_5;
  signal slice0cost_pair_0 : natural_511_1d(0 to 2);
  signal slice0cost_single_0 : natural_255_1d(0 to 2);
  signal slice0cost_column_0 : natural_767_1d(0 to 2);
  -- slice0window
  signal slice0window_partial_0_0 : natural_767_1d(0 to 2);
  signal slice0window_partial_0_1 : natural_1534_1d(0 to 2);
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0,
    slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_4;
  signal slice0window_sum_0 : natural_2301_1d(0 to 2);
  -- slice0winner1
  signal slice0winner1_of_pair_0, slice0winner1_of_four_0 : natural_2301_1d(0 to 2);
  signal slice0winner1_pair_index_0_0 : boolean;
  signal slice0winner1_pair_tag, slice0winner1_four_tag, slice0winner1_tag : tag_4;
  signal slice0winner1_pair_index_0_1, slice0winner1_four_index_0_0,
    slice0winner1_best_index_0_0 : natural range 0 to 2;
  signal slice0winner1_best_cost_0_0 : natural range 0 to 4095;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 4095;
  signal slice0_best_index_0_0 : natural range 0 to 7;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_255_2d(0 to 2, 0 to 2);
  signal slice1shift_reference, slice1shift_search_out : natural_255_1d(0 to 2);
  -- slice1cost
  signal slice1cost_difference : integer_minus_255_to_255_2d(0 to 2, 0 to 2);
  signal slice1cost_pair_0 : natural_511_1d(0 to 2);
  signal slice1cost_negative_0 : boolean_1d(0 to 2);
  signal slice1cost_tag_border_column : boolean;
  signal slice1cost_single_0 : natural_255_1d(0 to 2);
  signal slice1cost_column_0 : natural_767_1d(0 to 2);
  -- slice1window
  signal slice1window_partial_0_0 : natural_767_1d(0 to 2);
  signal slice1window_partial_0_1 : natural_1534_1d(0 to 2);
  signal slice1window_sum_0 : natural_2301_1d(0 to 2);
  -- slice1winner1
  signal slice1winner1_of_pair_0, slice1winner1_of_four_0 : natural_2301_1d(0 to 2);
  signal slice1winner1_pair_index_0_0 : boolean;
  signal slice1winner1_four_index_0_0, slice1winner1_best_index_0_0 : natural range 0 to 2;
  signal slice1winner1_best_cost_0_0 : natural range 0 to 4095;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 4095;
  signal slice1_best_index_0_0 : natural range 0 to 7;
  signal slice1_best_tag : tag_4;
  -- slice2shift
  signal slice2shift_search : natural_255_2d(0 to 2, 0 to 1);
  signal slice2shift_reference : natural_255_1d(0 to 2);
  -- slice2cost
  signal slice2cost_difference : integer_minus_255_to_255_2d(0 to 2, 0 to 1);
  signal slice2cost_pair_0 : natural_511_1d(0 to 1);
  signal slice2cost_negative_0 : boolean_1d(0 to 1);
  signal slice2cost_single_0 : natural_255_1d(0 to 1);
  signal slice2cost_column_0 : natural_767_1d(0 to 1);
  -- slice2window
  signal slice2window_partial_0_0 : natural_767_1d(0 to 1);
  signal slice2window_partial_0_1 : natural_1534_1d(0 to 1);
  signal slice2window_sum_0 : natural_2301_1d(0 to 1);
  -- slice2winner1
  signal slice2winner1_best_cost_0_0 : natural range 0 to 2301;
  signal slice2winner1_best_index_0_0 : boolean;
  -- slice2winner2
  signal slice2winner2_best_cost_0_0 : natural range 0 to 2301;
  signal slice2winner2_best_index_0_0 : boolean;
  -- slice2winner3
  signal slice2winner3_best_cost_0_0 : natural range 0 to 2301;
  signal slice2winner3_best_index_0_0 : boolean;
  -- slice2
  signal slice2_best_index_0_0 : natural range 0 to 7;
  signal slice2_best_tag : tag_4;

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice2_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice2_best_tag.valid and slice2_best_tag.output_column);
  disparity_start_of_frame <= as_bit(slice2_best_tag.start_of_frame and slice2_best_tag.valid and slice2_best_tag.output_column);
  disparity_end_of_line <= as_bit(slice2_best_tag.end_of_line and slice2_best_tag.valid and slice2_best_tag.output_column);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  rows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 5);
    write_address <= to_unsigned(rows_write_column, 5);
    write_data <= to_unsigned(rows_search_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (32, 16, 5)
      port map (clock, true, read_address, rows_search_rows_read_words_0, write_address, write_data);
  end block;

  rows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 5);
    write_address <= to_unsigned(rows_write_column, 5);
    write_data <= to_unsigned(rows_reference_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (32, 16, 5)
      port map (clock, true, read_address, rows_reference_rows_read_words_0, write_address, write_data);
  end block;

  delay_delayed_0_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 3);
    write_address <= to_unsigned(delay_ring_write_address, 3);
    write_data <= to_unsigned(raster_features_reference_0, 8);
    cell : entity work.line_memory generic map (8, 8, 3)
      port map (clock, true, read_address, delay_delayed_0, write_address, write_data);
  end block;

  process
    variable raster_place_group_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable raster_place_group_all, raster_place_group_choice_2, delay_row_inside_1_is_not_less,
      delay_row_inside_1_is_less, slice0winner1_of_pair_0_0_is_less, slice0winner1_of_four_0_0_is_less,
      slice1winner1_of_pair_0_0_is_less, slice1winner1_of_four_0_0_is_less, slice1_best_cost_0_0_is_less,
      slice2winner1_best_cost_0_0_is_less : boolean;
    variable raster_place_group_choice : natural range 0 to 3;
    variable raster_place_group_choices : natural_15_1d(3 to 4);  -- _choice_#
    variable raster_place_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
  begin
    wait until rising_edge(clock);
    -- raster
    raster_place_group_is_equals(1) := raster_place_column = 31;
    raster_place_group_is_equals(2) := raster_place_group = 11;
    raster_place_group_all := raster_place_group_is_equals(1) and raster_place_group_is_equals(2);
    raster_place_group_choice := choice(raster_place_group_all, 3, 0);
    raster_place_group_is_equals(3) := (raster_place_group / 2) = 6;
    raster_place_group_choice_2 := choice(raster_place_group_is_equals(3), raster_place_group_is_equals(1) and in_valid
      and (not is_set(raster_place_group, 0)), raster_place_group_is_equals(1) and in_valid);
    raster_place_group_choices(3) := choice(raster_place_next_frame and (raster_place_group = 12), 1,
      (raster_place_group + 1) mod 16);
    raster_place_group_choices(4) := choice(raster_place_group_choice_2, raster_place_group_choices(3),
      raster_place_group);
    raster_features_search_0 <= in_left_pixel;
    raster_features_reference_0 <= in_right_pixel;
    raster_features_valid <= in_valid;
    raster_place_group <= choice(in_start_of_frame and in_valid, raster_place_group_choice * 4,
      raster_place_group_choices(4));
    raster_place_next_frame_choices(1) := choice(raster_place_group_is_equals(1), raster_place_next_frame and
      is_set(raster_place_group, 0), raster_place_next_frame);
    raster_place_next_frame_choices(2) := choice(raster_place_group_is_equals(3), raster_place_next_frame_choices(1),
      raster_place_next_frame);
    if in_valid then
      raster_place_column <= choice(raster_place_group_is_equals(1) or in_start_of_frame, 0, (raster_place_column + 1)
        mod 32);
      raster_place_next_frame <= choice(raster_place_next_frame_choices(2), raster_place_group_all or (not
        in_start_of_frame), raster_place_group_is_equals(1) and raster_place_group_is_equals(2) and in_start_of_frame);
    end if;
    -- delay
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 7, 0, (delay_ring_read_address + 1) mod 8);
    end if;
    delay_row_inside_1_is_not_less := raster_place_group >= 1;
    delay_row_inside_1_is_less := raster_place_group < 13;
    delay_ahead_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 12;
    delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
    delay_row_inside(2) <= (not is_set(raster_place_group, 3)) or (not is_set(raster_place_group, 2));
    delay_tag.valid <= raster_features_valid;
    delay_tag.output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and (raster_place_column
      >= 7) and (raster_place_column < 31);
    delay_tag.start_of_frame <= (raster_place_column = 7) and (raster_place_group = 1);
    delay_tag.end_of_line <= raster_place_column = 30;
    delay_tag.border_column <= choice((raster_place_column mod 4) = 3, (raster_place_column / 4) = 0,
      (raster_place_column / 8) = 0);
    -- rows
    rows_search_rows_read_newest_0 <= delay_ahead_0;
    rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
    rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_tag <= rows_ready_tag;
    rows_search(0) <= choice(rows_ready_inside(0), rows_search_rows_ready_words_0 mod 256, 0);
    rows_reference(0) <= choice(rows_ready_inside(0), rows_reference_rows_ready_words_0 mod 256, 0);
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_words_0 / 256, 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_words_0 / 256, 0);
    rows_search(2) <= choice(rows_ready_inside(2), rows_search_rows_ready_newest_0, 0);
    rows_reference(2) <= choice(rows_ready_inside(2), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words_0 <= (rows_search_rows_ready_newest_0 * 256) + (rows_search_rows_ready_words_0 /
        256);
      rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_newest_0 * 256) +
        (rows_reference_rows_ready_words_0 / 256);
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 2 loop
        slice0shift_search(i, 0) <= slice0shift_search(i, 1);
        slice0shift_search(i, 1) <= slice0shift_search(i, 2);
        slice0shift_search(i, 2) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 0);
    slice0shift_search_out(1) <= slice0shift_search(1, 0);
    slice0shift_search_out(2) <= slice0shift_search(2, 0);
    slice0shift_tag <= rows_tag;
    -- slice0cost
    for i in 0 to 2 loop
      slice0cost_difference(i, 0) <= slice0shift_search(i, 0) - slice0shift_reference(i);
      slice0cost_difference(i, 1) <= slice0shift_search(i, 1) - slice0shift_reference(i);
      slice0cost_difference(i, 2) <= slice0shift_search(i, 2) - slice0shift_reference(i);
    end loop;
    slice0cost_difference_tag <= slice0shift_tag;
    for i in 0 to 2 loop
      slice0cost_pair_0(i) <= folded(slice0cost_difference(2, i)) + folded(slice0cost_difference(1, i)) +
        as_number((slice0cost_difference(1, i) < 0));
    end loop;
    slice0cost_negative_0(0) <= slice0cost_difference(2, 0) < 0;
    slice0cost_negative_0(1) <= slice0cost_difference(2, 1) < 0;
    slice0cost_negative_0(2) <= slice0cost_difference(2, 2) < 0;
    for i in 0 to 2 loop
      slice0cost_single_0(i) <= (folded(slice0cost_difference(0, i)) + as_number((slice0cost_difference(0, i) < 0)))
        mod 256;
    end loop;
    slice0cost_pair_tag <= slice0cost_difference_tag;
    slice0cost_tag <= slice0cost_pair_tag;
    for i in 0 to 2 loop
      slice0cost_column_0(i) <= choice(slice0cost_pair_tag.border_column, 0, as_number(slice0cost_negative_0(i)) +
        slice0cost_pair_0(i) + slice0cost_single_0(i));
    end loop;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_partial_0_0 <= slice0cost_column_0;
      slice0window_partial_0_1(0) <= slice0cost_column_0(0) + slice0window_partial_0_0(0);
      slice0window_partial_0_1(1) <= slice0cost_column_0(1) + slice0window_partial_0_0(1);
      slice0window_partial_0_1(2) <= slice0cost_column_0(2) + slice0window_partial_0_0(2);
    end if;
    slice0window_centre_output_column_0 <= slice0cost_tag.output_column;
    slice0window_centre_start_of_frame_0 <= slice0cost_tag.start_of_frame;
    slice0window_centre_end_of_line_0 <= slice0cost_tag.end_of_line;
    slice0window_sum_0(0) <= slice0cost_column_0(0) + slice0window_partial_0_1(0);
    slice0window_sum_0(1) <= slice0cost_column_0(1) + slice0window_partial_0_1(1);
    slice0window_sum_0(2) <= slice0cost_column_0(2) + slice0window_partial_0_1(2);
    slice0window_tag.valid <= slice0cost_tag.valid;
    slice0window_tag.output_column <= slice0window_centre_output_column_0;
    slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame_0;
    slice0window_tag.end_of_line <= slice0window_centre_end_of_line_0;
    -- slice0winner1
    slice0winner1_of_pair_0_0_is_less := (slice0window_sum_0(1) - slice0window_sum_0(0)) < 0;
    slice0winner1_of_four_0_0_is_less := (slice0winner1_of_pair_0(2) -
      to_integer(((to_unsigned(slice0winner1_of_pair_0(0), 12)) or (to_unsigned(slice0winner1_of_pair_0(1), 12))))) < 0;
    slice0winner1_of_pair_0(2) <= slice0window_sum_0(2);
    slice0winner1_pair_index_0_0 <= slice0winner1_of_pair_0_0_is_less;
    slice0winner1_pair_index_0_1 <= 2;
    slice0winner1_pair_tag.valid <= slice0window_tag.valid;
    slice0winner1_four_tag <= slice0winner1_pair_tag;
    slice0winner1_best_cost_0_0 <= to_integer(((((to_unsigned(slice0winner1_of_four_0(1), 12)) or
      (to_unsigned(slice0winner1_of_four_0(2), 12)))) or (to_unsigned(slice0winner1_of_four_0(0), 12))));
    slice0winner1_best_index_0_0 <= slice0winner1_four_index_0_0;
    slice0winner1_tag <= slice0winner1_four_tag;
    slice0winner1_of_pair_0(0) <= choice(slice0winner1_of_pair_0_0_is_less, 0, slice0window_sum_0(0));
    slice0winner1_of_pair_0(1) <= choice(slice0winner1_of_pair_0_0_is_less, slice0window_sum_0(1), 0);
    slice0winner1_of_four_0(0) <= choice(slice0winner1_of_four_0_0_is_less, 0, slice0winner1_of_pair_0(0));
    slice0winner1_of_four_0(1) <= choice(slice0winner1_of_four_0_0_is_less, 0, slice0winner1_of_pair_0(1));
    slice0winner1_of_four_0(2) <= choice(slice0winner1_of_four_0_0_is_less, slice0winner1_of_pair_0(2), 0);
    slice0winner1_four_index_0_0 <= choice(slice0winner1_of_four_0_0_is_less, slice0winner1_pair_index_0_1,
      as_number(slice0winner1_pair_index_0_0));
    if slice0winner1_pair_tag.valid then
      slice0winner1_pair_tag.output_column <= slice0window_tag.output_column;
      slice0winner1_pair_tag.start_of_frame <= slice0window_tag.start_of_frame;
      slice0winner1_pair_tag.end_of_line <= slice0window_tag.end_of_line;
    end if;
    -- slice0
    slice0_best_cost_0_0 <= slice0winner1_best_cost_0_0;
    slice0_best_index_0_0 <= slice0winner1_best_index_0_0 + 5;
    slice0_best_tag <= slice0winner1_tag;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 2 loop
        slice1shift_search(i, 0) <= slice1shift_search(i, 1);
        slice1shift_search(i, 1) <= slice1shift_search(i, 2);
        slice1shift_search(i, 2) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    slice1shift_search_out(0) <= slice1shift_search(0, 0);
    slice1shift_search_out(1) <= slice1shift_search(1, 0);
    slice1shift_search_out(2) <= slice1shift_search(2, 0);
    -- slice1cost
    for i in 0 to 2 loop
      slice1cost_difference(i, 0) <= slice1shift_search(i, 0) - slice1shift_reference(i);
      slice1cost_difference(i, 1) <= slice1shift_search(i, 1) - slice1shift_reference(i);
      slice1cost_difference(i, 2) <= slice1shift_search(i, 2) - slice1shift_reference(i);
    end loop;
    for i in 0 to 2 loop
      slice1cost_pair_0(i) <= folded(slice1cost_difference(2, i)) + folded(slice1cost_difference(1, i)) +
        as_number((slice1cost_difference(1, i) < 0));
    end loop;
    slice1cost_negative_0(0) <= slice1cost_difference(2, 0) < 0;
    slice1cost_negative_0(1) <= slice1cost_difference(2, 1) < 0;
    slice1cost_negative_0(2) <= slice1cost_difference(2, 2) < 0;
    for i in 0 to 2 loop
      slice1cost_single_0(i) <= (folded(slice1cost_difference(0, i)) + as_number((slice1cost_difference(0, i) < 0)))
        mod 256;
    end loop;
    slice1cost_tag_border_column <= slice0cost_tag.border_column;
    for i in 0 to 2 loop
      slice1cost_column_0(i) <= choice(slice0cost_tag.border_column, 0, as_number(slice1cost_negative_0(i)) +
        slice1cost_pair_0(i) + slice1cost_single_0(i));
    end loop;
    -- slice1window
    if slice0window_tag.valid then
      slice1window_partial_0_0 <= slice1cost_column_0;
      slice1window_partial_0_1(0) <= slice1cost_column_0(0) + slice1window_partial_0_0(0);
      slice1window_partial_0_1(1) <= slice1cost_column_0(1) + slice1window_partial_0_0(1);
      slice1window_partial_0_1(2) <= slice1cost_column_0(2) + slice1window_partial_0_0(2);
    end if;
    slice1window_sum_0(0) <= slice1cost_column_0(0) + slice1window_partial_0_1(0);
    slice1window_sum_0(1) <= slice1cost_column_0(1) + slice1window_partial_0_1(1);
    slice1window_sum_0(2) <= slice1cost_column_0(2) + slice1window_partial_0_1(2);
    -- slice1winner1
    slice1winner1_of_pair_0_0_is_less := (slice1window_sum_0(1) - slice1window_sum_0(0)) < 0;
    slice1winner1_of_four_0_0_is_less := (slice1winner1_of_pair_0(2) -
      to_integer(((to_unsigned(slice1winner1_of_pair_0(0), 12)) or (to_unsigned(slice1winner1_of_pair_0(1), 12))))) < 0;
    slice1winner1_of_pair_0(2) <= slice1window_sum_0(2);
    slice1winner1_pair_index_0_0 <= slice1winner1_of_pair_0_0_is_less;
    slice1winner1_best_cost_0_0 <= to_integer(((((to_unsigned(slice1winner1_of_four_0(1), 12)) or
      (to_unsigned(slice1winner1_of_four_0(2), 12)))) or (to_unsigned(slice1winner1_of_four_0(0), 12))));
    slice1winner1_best_index_0_0 <= slice1winner1_four_index_0_0;
    slice1winner1_of_pair_0(0) <= choice(slice1winner1_of_pair_0_0_is_less, 0, slice1window_sum_0(0));
    slice1winner1_of_pair_0(1) <= choice(slice1winner1_of_pair_0_0_is_less, slice1window_sum_0(1), 0);
    slice1winner1_of_four_0(0) <= choice(slice1winner1_of_four_0_0_is_less, 0, slice1winner1_of_pair_0(0));
    slice1winner1_of_four_0(1) <= choice(slice1winner1_of_four_0_0_is_less, 0, slice1winner1_of_pair_0(1));
    slice1winner1_of_four_0(2) <= choice(slice1winner1_of_four_0_0_is_less, slice1winner1_of_pair_0(2), 0);
    slice1winner1_four_index_0_0 <= choice(slice1winner1_of_four_0_0_is_less, slice0winner1_pair_index_0_1,
      as_number(slice1winner1_pair_index_0_0));
    -- slice1
    slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner1_best_cost_0_0) < 0;
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_cost_0_0, slice1winner1_best_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_index_0_0,
      (((slice1winner1_best_index_0_0 / 2) + 1) * 2) + (slice1winner1_best_index_0_0 mod 2));
    -- slice2shift
    if slice0cost_difference_tag.valid then
      for i in 0 to 2 loop
        slice2shift_search(i, 0) <= slice2shift_search(i, 1);
        slice2shift_search(i, 1) <= slice1shift_search_out(i);
      end loop;
    end if;
    slice2shift_reference <= slice1shift_reference;
    -- slice2cost
    for i in 0 to 2 loop
      slice2cost_difference(i, 0) <= slice2shift_search(i, 0) - slice2shift_reference(i);
      slice2cost_difference(i, 1) <= slice2shift_search(i, 1) - slice2shift_reference(i);
    end loop;
    slice2cost_pair_0(0) <= as_number((slice2cost_difference(1, 0) < 0)) + folded(slice2cost_difference(1, 0)) +
      folded(slice2cost_difference(2, 0));
    slice2cost_pair_0(1) <= as_number((slice2cost_difference(1, 1) < 0)) + folded(slice2cost_difference(1, 1)) +
      folded(slice2cost_difference(2, 1));
    slice2cost_negative_0(0) <= slice2cost_difference(2, 0) < 0;
    slice2cost_negative_0(1) <= slice2cost_difference(2, 1) < 0;
    slice2cost_single_0(0) <= (folded(slice2cost_difference(0, 0)) + as_number((slice2cost_difference(0, 0) < 0))) mod
      256;
    slice2cost_single_0(1) <= (folded(slice2cost_difference(0, 1)) + as_number((slice2cost_difference(0, 1) < 0))) mod
      256;
    slice2cost_column_0(0) <= choice(slice1cost_tag_border_column, 0, as_number(slice2cost_negative_0(0)) +
      slice2cost_pair_0(0) + slice2cost_single_0(0));
    slice2cost_column_0(1) <= choice(slice1cost_tag_border_column, 0, as_number(slice2cost_negative_0(1)) +
      slice2cost_pair_0(1) + slice2cost_single_0(1));
    -- slice2window
    if slice0winner1_pair_tag.valid then
      slice2window_partial_0_0 <= slice2cost_column_0;
      slice2window_partial_0_1(0) <= slice2cost_column_0(0) + slice2window_partial_0_0(0);
      slice2window_partial_0_1(1) <= slice2cost_column_0(1) + slice2window_partial_0_0(1);
    end if;
    slice2window_sum_0(0) <= slice2cost_column_0(0) + slice2window_partial_0_1(0);
    slice2window_sum_0(1) <= slice2cost_column_0(1) + slice2window_partial_0_1(1);
    -- slice2winner1
    slice2winner1_best_cost_0_0_is_less := (slice2window_sum_0(1) - slice2window_sum_0(0)) < 0;
    slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_0_is_less;
    slice2winner1_best_cost_0_0 <= choice(slice2winner1_best_cost_0_0_is_less, slice2window_sum_0(1),
      slice2window_sum_0(0));
    -- slice2winner2
    slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_0;
    slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_0;
    -- slice2winner3
    slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_0;
    slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
    -- slice2
    slice2_best_tag <= slice1_best_tag;
    slice2_best_index_0_0 <= choice((slice1_best_cost_0_0 - slice2winner3_best_cost_0_0) < 0, slice1_best_index_0_0,
      as_number(slice2winner3_best_index_0_0));
    if reset = '1' then
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 13;
      raster_place_next_frame <= false; delay_ring_read_address <= 1; delay_ring_write_address <= 0; delay_column <= 0;
      delay_tag.valid <= false; delay_tag.output_column <= false; delay_tag.start_of_frame <= false;
      delay_tag.end_of_line <= false; rows_read_column <= 0; rows_read_tag.valid <= false;
      rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false;
      rows_ready_column <= 0; rows_ready_tag.valid <= false; rows_ready_tag.output_column <= false;
      rows_ready_tag.start_of_frame <= false; rows_ready_tag.end_of_line <= false; rows_write_column <= 0;
      rows_tag.valid <= false; rows_tag.output_column <= false; rows_tag.start_of_frame <= false;
      rows_tag.end_of_line <= false; slice0shift_tag.valid <= false; slice0shift_tag.output_column <= false;
      slice0shift_tag.start_of_frame <= false; slice0shift_tag.end_of_line <= false;
      slice0cost_difference_tag.valid <= false; slice0cost_difference_tag.output_column <= false;
      slice0cost_difference_tag.start_of_frame <= false; slice0cost_difference_tag.end_of_line <= false;
      slice0cost_pair_tag.valid <= false; slice0cost_pair_tag.output_column <= false;
      slice0cost_pair_tag.start_of_frame <= false; slice0cost_pair_tag.end_of_line <= false;
      slice0cost_tag.valid <= false; slice0cost_tag.output_column <= false; slice0cost_tag.start_of_frame <= false;
      slice0cost_tag.end_of_line <= false; slice0window_centre_output_column_0 <= false;
      slice0window_centre_start_of_frame_0 <= false; slice0window_centre_end_of_line_0 <= false;
      slice0window_tag <= (others => false); slice0winner1_pair_tag <= (others => false);
      slice0winner1_four_tag <= (others => false); slice0winner1_tag <= (others => false);
      slice0_best_tag <= (others => false); slice1_best_tag <= (others => false); slice2_best_tag <= (others => false);
    end if;
  end process;
end architecture;
