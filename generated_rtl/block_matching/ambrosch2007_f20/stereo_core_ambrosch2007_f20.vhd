-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration ambrosch2007_f20: 320x240, 100 disparities, window 3x3, 1 pixel pair a clock.
-- Options: disparities 100, clocks_per_pixel 20.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config ambrosch2007_f20
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_ambrosch2007_f20 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 240;
    disparities : positive := 100;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 220;
    latency_clocks : positive := 8;
    flush_groups : positive := 860;
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
  assert width_px = 320 report "stereo_core_ambrosch2007_f20: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 240 report "stereo_core_ambrosch2007_f20: height_px is " & integer'image(height_px) & " but this core has 240" severity failure;
  assert disparities = 100 report "stereo_core_ambrosch2007_f20: disparities is " & integer'image(disparities) & " but this core has 100" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_ambrosch2007_f20: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_ambrosch2007_f20: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 220 report "stereo_core_ambrosch2007_f20: output_width_px is " & integer'image(output_width_px) & " but this core has 220" severity failure;
  assert latency_clocks = 8 report "stereo_core_ambrosch2007_f20: latency_clocks is " & integer'image(latency_clocks) & " but this core has 8" severity failure;
  assert flush_groups = 860 report "stereo_core_ambrosch2007_f20: flush_groups is " & integer'image(flush_groups) & " but this core has 860" severity failure;
  assert gap_groups = 0 report "stereo_core_ambrosch2007_f20: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_ambrosch2007_f20 is
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
  type natural_2301_1d is array (natural range <>) of natural range 0 to 2301;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_4_1d is array (natural range <>) of natural range 0 to 4;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_767_1d is array (natural range <>) of natural range 0 to 767;
  type tag_4 is record
    valid, row_start, output_column, start_of_frame : boolean;
  end record;
  type tag_5 is record
    valid, border_column, first_cost, map_column, end_of_line : boolean;
  end record;
  type tag_4_b is record
    valid, border_column, first_cost, map_column : boolean;
  end record;
  type tag_3 is record
    valid, first_cost, map_column : boolean;
  end record;
  type tag_3_b is record
    valid, map_column, first_column : boolean;
  end record;
  type tag_4_c is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_start_of_frame, in_valid : boolean;
  signal in_left_pixel, in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0, raster_place_group : natural range 0 to 255;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 255;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag : tag_4;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(15 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0, rows_search_2, rows_reference_2 : natural range 0 to 255;
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : natural range 0 to 65535;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag : tag_4;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag, rows_tag : tag_4;
  -- passes
  signal passes_row, passes_coming_output, passes_coming_starts, passes_row_ended, passes_ended_last, passes_arrived,
    passes_shows, passes_showing_output, passes_showing_starts, passes_inside_0, passes_pass_ends, passes_last_pass,
    passes_leaving_starts : boolean;
  signal passes_read_tag : tag_5;
  signal passes_tag : tag_4_b;
  signal passes_write_address, passes_search_address, passes_reference_address : natural range 0 to 1023;
  signal passes_write_search_0, passes_write_reference_0 : natural range 0 to 16777215;
  signal passes_pass : natural range 0 to 31;
  signal passes_column : natural range 0 to 255;
  signal passes_search, passes_reference : natural_255_1d(0 to 2);
  signal passes_search_start : natural range 0 to 511;
  signal passes_read_search_0, passes_read_reference_0 : unsigned(23 downto 0);
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 2, 0 to 4);
  signal slice0shift_reference : natural_255_1d(0 to 2);
  signal slice0shift_tag : tag_4_b;
  -- slice0cost
  signal slice0cost_difference : integer_minus_255_to_255_2d(0 to 2, 0 to 4);
  signal slice0cost_difference_tag : tag_4_b;
  signal slice0cost_negative_0 : boolean_1d(0 to 4);
  signal slice0cost_pair_tag : tag_4_b;
  signal slice0cost_tag : tag_3;
  signal slice0cost_pair_0 : natural_511_1d(0 to 4);
  signal slice0cost_single_0 : natural_255_1d(0 to 4);
  signal slice0cost_column_0 : natural_767_1d(0 to 4);
  -- slice0window
  signal slice0window_partial_0_0 : natural_767_1d(0 to 4);
  signal slice0window_partial_0_1 : natural_1534_1d(0 to 4);
  signal slice0window_centre_map_column_0, slice0window_centre_first_column_0 : boolean;
  signal slice0window_tag : tag_3_b;
  signal slice0window_sum_0 : natural_2301_1d(0 to 4);
  -- slice0winner1
  signal slice0winner1_of_pair_0, slice0winner1_of_four_0 : natural_2301_1d(0 to 4);
  signal slice0winner1_best_cost_0 : natural_4095_1d(0 to 1);  -- _# up to 4095, 2301
  signal slice0winner1_pair_index_0_0 : boolean;
  signal slice0winner1_pair_tag, slice0winner1_four_tag, slice0winner1_tag : tag_3_b;
  signal slice0winner1_pair_index_0 : natural_4_1d(1 to 2);  -- _# up to 3, 4
  signal slice0winner1_four_index_0, slice0winner1_best_index_0 : natural_4_1d(0 to 1);  -- _# up to 3, 4
  -- slice0winner2
  signal slice0winner2_best_cost_0_0 : natural range 0 to 4095;
  signal slice0winner2_best_index_0_0 : natural range 0 to 4;
  signal slice0winner2_tag : tag_3_b;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 4095;
  signal slice0_best_index_0_0 : natural range 0 to 4;
  signal slice0_best_tag : tag_3_b;
  -- best
  signal best_read_cost_0_0, best_waiting_cost_0_0, best_ready_cost_0_0, best_compared_cost_0_0,
    best_best_cost_0_0 : natural range 0 to 4095;
  signal best_read_index_0_0, best_waiting_index_0_0, best_ready_index_0_0 : natural range 0 to 4;
  signal best_read_tag, best_waiting_tag, best_ready_tag, best_compared_tag : tag_3_b;
  signal best_last_pass, best_here_wins : boolean;
  signal best_best_tag : tag_3_b;
  signal best_column, best_place_column, best_write_column : natural range 0 to 511;
  signal best_read_words_0 : unsigned(19 downto 0);
  signal best_ready_words_0, best_compared_words_0 : natural range 0 to 1048575;
  signal best_pass : natural range 0 to 31;
  signal best_base, best_compared_index_0_0, best_best_index_0_0 : natural range 0 to 255;
  -- winners
  signal winners_row : boolean;
  signal winners_read_tag, winners_winners_tag : tag_4_c;
  signal winners_column : natural range 0 to 511;
  signal winners_write_address : natural range 0 to 1023;
  signal winners_write_word_0, winners_winners_disparity_0 : natural range 0 to 127;
  signal winners_read_word_0 : unsigned(6 downto 0);
  -- other
  signal other : natural_65535_1d(0 to 1);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(winners_winners_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(winners_winners_tag.valid and winners_winners_tag.output_column);
  disparity_start_of_frame <= as_bit(winners_winners_tag.start_of_frame and winners_winners_tag.valid and winners_winners_tag.output_column);
  disparity_end_of_line <= as_bit(winners_winners_tag.end_of_line and winners_winners_tag.valid and winners_winners_tag.output_column);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  winners_read_word_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(6 downto 0);
  begin
    read_address <= to_unsigned(passes_write_address, 10);
    write_address <= to_unsigned(winners_write_address, 10);
    write_data <= to_unsigned(winners_write_word_0, 7);
    cell : entity work.line_memory generic map (1024, 7, 10)
      port map (clock, true, read_address, winners_read_word_0, write_address, write_data);
  end block;

  best_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(best_column, 9);
    write_address <= to_unsigned(best_write_column, 9);
    write_data <= to_unsigned(best_best_index_0_0, 8) & to_unsigned(best_best_cost_0_0, 12);
    cell : entity work.line_memory generic map (512, 20, 9)
      port map (clock, true, read_address, best_read_words_0, write_address, write_data);
  end block;

  passes_read_search_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(passes_search_address, 10);
    write_address <= to_unsigned(passes_write_address, 10);
    write_data <= to_unsigned(passes_write_search_0, 24);
    cell : entity work.line_memory generic map (1024, 24, 10)
      port map (clock, true, read_address, passes_read_search_0, write_address, write_data);
  end block;

  passes_read_reference_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(passes_reference_address, 10);
    write_address <= to_unsigned(passes_write_address, 10);
    write_data <= to_unsigned(passes_write_reference_0, 24);
    cell : entity work.line_memory generic map (1024, 24, 10)
      port map (clock, true, read_address, passes_read_reference_0, write_address, write_data);
  end block;

  rows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (320, 16, 9)
      port map (clock, true, read_address, rows_search_rows_read_words_0, write_address, write_data);
  end block;

  rows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (320, 16, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words_0, write_address, write_data);
  end block;

  process
    variable raster_place_group_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable raster_place_group_all, raster_place_group_choice_2, raster_place_next_frame_choice,
      delay_row_inside_1_is_not_less, delay_row_inside_1_is_less, delay_tag_row_start_is_equal, passes_row_is_equal,
      passes_coming_output_all, passes_coming_output_any, passes_row_ended_all, passes_shows_any,
      passes_showing_output_differs, passes_showing_output_any, passes_read_tag_first_cost_is_equal,
      slice0winner1_of_four_0_0_is_less, slice0winner2_best_cost_0_0_is_less, best_last_pass_is_equal,
      best_here_wins_is_less, best_pass_any, winners_row_differs, winners_column_any : boolean;
    variable raster_place_group_choice : natural range 0 to 15;
    variable raster_place_group_choices : natural_255_1d(3 to 4);  -- _choice_#
    variable passes_inside_0_choices, passes_leaving_starts_choices,
      passes_read_tag_border_column_choices : boolean_1d(1 to 2);  -- _choice_#
    variable passes_search_address_value : natural range 0 to 512;
    variable passes_search_address_choices, best_write_column_choices : natural_511_1d(1 to 2);  -- _choice_#
    variable passes_reference_address_choice, winners_column_choice : natural range 0 to 511;
    variable passes_read_tag_border_column_differss : boolean_1d(1 to 2);  -- _differs_#
    variable slice0winner1_of_pair_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable other_choice : natural_255_2d(0 to 1, 1 to 2);  -- _#_choice_#
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    slice0winner1_of_pair_0_is_less := (others => false);
    -- raster
    raster_place_group_is_equals(1) := raster_place_column = 319;
    raster_place_group_is_equals(2) := raster_place_group = 239;
    raster_place_group_all := raster_place_group_is_equals(1) and raster_place_group_is_equals(2);
    raster_place_group_choice := choice(raster_place_group_all, 15, 0);
    raster_place_group_choice_2 := choice((raster_place_group mod 16) = 1, ((raster_place_group / 16) /= 15) and
      raster_place_group_is_equals(1) and in_valid, raster_place_group_is_equals(1) and in_valid);
    raster_place_group_is_equals(3) := raster_place_group = 240;
    raster_place_group_choices(3) := choice(raster_place_group_is_equals(3) and raster_place_next_frame, 1,
      (raster_place_group + 1) mod 256);
    raster_place_group_choices(4) := choice(raster_place_group_choice_2, raster_place_group_choices(3),
      raster_place_group);
    raster_features_search_0 <= in_left_pixel;
    raster_features_reference_0 <= in_right_pixel;
    raster_features_valid <= in_valid;
    raster_place_group <= choice(in_start_of_frame and in_valid, raster_place_group_choice * 16,
      raster_place_group_choices(4));
    raster_place_next_frame_choice := choice(raster_place_group_is_equals(3), (raster_place_column /= 319) and
      raster_place_next_frame, raster_place_next_frame);
    if in_valid then
      raster_place_column <= choice(raster_place_group_is_equals(1) or in_start_of_frame, 0, (raster_place_column + 1)
        mod 512);
      raster_place_next_frame <= choice(raster_place_next_frame_choice, raster_place_group_all or (not
        in_start_of_frame), raster_place_group_is_equals(1) and raster_place_group_is_equals(2) and in_start_of_frame);
    end if;
    -- delay
    delay_row_inside_1_is_not_less := raster_place_group >= 1;
    delay_row_inside_1_is_less := raster_place_group < 241;
    delay_tag_row_start_is_equal := raster_place_column = 0;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 240;
    delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
    delay_row_inside(2) <= (not is_set(raster_place_group, 7)) or (not is_set(raster_place_group, 6)) or (not
      is_set(raster_place_group, 5)) or (not is_set(raster_place_group, 4));
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= delay_tag_row_start_is_equal;
    delay_tag.output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and (raster_place_column <
      319);
    delay_tag.start_of_frame <= delay_tag_row_start_is_equal and (raster_place_group = 1);
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
    rows_search_2 <= choice(rows_ready_inside(2), rows_search_rows_ready_newest_0, 0);
    rows_reference_2 <= choice(rows_ready_inside(2), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words_0 <= (rows_search_rows_ready_newest_0 * 256) + (rows_search_rows_ready_words_0 /
        256);
      rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_newest_0 * 256) +
        (rows_reference_rows_ready_words_0 / 256);
      rows_write_column <= rows_ready_column;
    end if;
    -- passes
    passes_row_is_equal := rows_write_column = 319;
    if passes_row_is_equal then passes_row <= rows_tag.valid /= passes_row; end if;
    passes_coming_output_all := rows_tag.row_start and rows_tag.valid;
    passes_coming_output_any := (not rows_tag.row_start) or (not rows_tag.valid);
    passes_row_ended_all := passes_row_is_equal and rows_tag.valid;
    passes_shows_any := (not passes_last_pass) or (not passes_pass_ends);
    passes_showing_output_differs := rows_write_column /= 319;
    passes_showing_output_any := passes_showing_output_differs or (not rows_tag.valid);
    passes_inside_0_choices(1) := choice(passes_ended_last, passes_inside_0, (not rows_tag.valid) and passes_inside_0);
    passes_inside_0_choices(2) := choice(rows_tag.row_start, passes_inside_0_choices(1), passes_inside_0);
    passes_search_address_value := as_number((not passes_row)) * 512;
    passes_search_address_choices(1) := choice(passes_shows_any, passes_search_start, 0);
    passes_search_address_choices(2) := choice(passes_pass_ends, passes_search_address_choices(1),
      (passes_search_address + as_number(passes_shows)) mod 512);
    passes_reference_address_choice := choice(passes_pass_ends, 508, (passes_reference_address +
      as_number(passes_shows)) mod 512);
    passes_leaving_starts_choices(1) := choice(passes_row_is_equal, rows_tag.valid or passes_leaving_starts,
      passes_leaving_starts);
    passes_leaving_starts_choices(2) := choice(passes_row_is_equal, (not rows_tag.valid) and passes_leaving_starts,
      passes_leaving_starts);
    passes_read_tag_border_column_differss(1) := (passes_column / 16) /= 0;
    passes_read_tag_border_column_choices(1) := choice((passes_column / 2) = 112,
      passes_read_tag_border_column_differss(1) and (not is_set(passes_column, 0)),
      passes_read_tag_border_column_differss(1));
    passes_read_tag_border_column_choices(2) := choice((passes_column mod 16) = 0,
      passes_read_tag_border_column_choices(1), ((passes_column / 2) /= 112) or (not is_set(passes_column, 0)));
    passes_read_tag_border_column_differss(2) := passes_column /= 4;
    passes_read_tag_first_cost_is_equal := passes_column = 4;
    passes_row_ended <= passes_row_ended_all;
    passes_arrived <= rows_tag.valid;
    passes_pass_ends <= passes_column = 224;
    passes_last_pass <= passes_pass = 19;
    passes_search_address <= passes_search_address_value + passes_search_address_choices(2);
    passes_reference_address <= passes_search_address_value + passes_reference_address_choice;
    passes_read_tag.valid <= passes_shows;
    passes_read_tag.first_cost <= passes_read_tag_first_cost_is_equal;
    passes_read_tag.map_column <= passes_read_tag_first_cost_is_equal or (passes_read_tag.map_column and (not
      passes_read_tag.end_of_line));
    passes_read_tag.end_of_line <= passes_column = 223;
    passes_search(0) <= to_integer(passes_read_search_0(7 downto 0));
    passes_search(1) <= to_integer(passes_read_search_0(15 downto 8));
    passes_search(2) <= to_integer(passes_read_search_0(23 downto 16));
    passes_reference(0) <= to_integer(passes_read_reference_0(7 downto 0));
    passes_reference(1) <= to_integer(passes_read_reference_0(15 downto 8));
    passes_reference(2) <= to_integer(passes_read_reference_0(23 downto 16));
    passes_tag.valid <= passes_read_tag.valid;
    passes_tag.border_column <= passes_read_tag.border_column;
    passes_tag.first_cost <= passes_read_tag.first_cost;
    passes_tag.map_column <= passes_read_tag.map_column;
    passes_coming_output <= choice(rows_tag.output_column, passes_coming_output or passes_coming_output_all,
      passes_coming_output and passes_coming_output_any);
    passes_coming_starts <= choice(rows_tag.start_of_frame, passes_coming_starts or passes_coming_output_all,
      passes_coming_starts and passes_coming_output_any);
    passes_shows <= choice(passes_row_ended, (not passes_shows) or (not passes_last_pass) or (not passes_pass_ends),
      passes_shows and passes_shows_any);
    passes_showing_output <= choice(passes_coming_output, passes_showing_output or passes_row_ended_all,
      passes_showing_output and passes_showing_output_any);
    passes_showing_starts <= choice(passes_coming_starts, passes_showing_starts or passes_row_ended_all,
      passes_showing_starts and passes_showing_output_any);
    passes_inside_0 <= choice(passes_inside_0_choices(2), passes_showing_output or passes_showing_output_differs or
      (not rows_tag.valid), passes_showing_output and passes_row_is_equal and rows_tag.valid);
    passes_column <= choice(passes_pass_ends, 0, (as_number(passes_shows) + passes_column) mod 256);
    passes_leaving_starts <= choice(passes_showing_starts, passes_leaving_starts_choices(1),
      passes_leaving_starts_choices(2));
    passes_read_tag.border_column <= choice(passes_read_tag_border_column_choices(2),
      passes_read_tag_border_column_differss(2) and passes_read_tag.border_column,
      passes_read_tag_border_column_differss(2));
    if rows_tag.valid then
      passes_ended_last <= passes_row_is_equal;
      passes_write_address <= rows_write_column + (as_number(passes_row) * 512);
      passes_write_search_0 <= (rows_search_2 * 65536) + other(1);
      passes_write_reference_0 <= (rows_reference_2 * 65536) + other(0);
    end if;
    if passes_pass_ends then
      passes_pass <= choice(passes_shows_any, (passes_pass + 1) mod 32, 0);
      passes_search_start <= choice(passes_shows_any, (passes_search_start + 5) mod 512, 5);
    end if;
    -- slice0shift
    if passes_tag.valid then
      for i in 0 to 2 loop
        slice0shift_search(i, 0) <= slice0shift_search(i, 1);
        slice0shift_search(i, 1) <= slice0shift_search(i, 2);
        slice0shift_search(i, 2) <= slice0shift_search(i, 3);
        slice0shift_search(i, 3) <= slice0shift_search(i, 4);
        slice0shift_search(i, 4) <= passes_search(i);
      end loop;
    end if;
    slice0shift_reference <= passes_reference;
    slice0shift_tag <= passes_tag;
    -- slice0cost
    for i in 0 to 2 loop
      for j in 0 to 4 loop slice0cost_difference(i, j) <= slice0shift_search(i, j) - slice0shift_reference(i); end loop;
    end loop;
    slice0cost_difference_tag <= slice0shift_tag;
    for i in 0 to 4 loop
      slice0cost_pair_0(i) <= folded(slice0cost_difference(2, i)) + folded(slice0cost_difference(1, i)) +
        as_number((slice0cost_difference(1, i) < 0));
    end loop;
    for i in 0 to 4 loop slice0cost_negative_0(i) <= slice0cost_difference(2, i) < 0; end loop;
    for i in 0 to 4 loop
      slice0cost_single_0(i) <= (folded(slice0cost_difference(0, i)) + as_number((slice0cost_difference(0, i) < 0)))
        mod 256;
    end loop;
    slice0cost_pair_tag <= slice0cost_difference_tag;
    slice0cost_tag.valid <= slice0cost_pair_tag.valid;
    slice0cost_tag.first_cost <= slice0cost_pair_tag.first_cost;
    slice0cost_tag.map_column <= slice0cost_pair_tag.map_column;
    for i in 0 to 4 loop
      slice0cost_column_0(i) <= choice(slice0cost_pair_tag.border_column, 0, as_number(slice0cost_negative_0(i)) +
        slice0cost_pair_0(i) + slice0cost_single_0(i));
    end loop;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_partial_0_0 <= slice0cost_column_0;
      for i in 0 to 4 loop
        slice0window_partial_0_1(i) <= slice0cost_column_0(i) + slice0window_partial_0_0(i);
      end loop;
      slice0window_centre_map_column_0 <= slice0cost_tag.map_column;
      slice0window_centre_first_column_0 <= slice0cost_tag.first_cost;
    end if;
    for i in 0 to 4 loop slice0window_sum_0(i) <= slice0cost_column_0(i) + slice0window_partial_0_1(i); end loop;
    slice0window_tag.valid <= slice0cost_tag.valid;
    slice0window_tag.map_column <= slice0window_centre_map_column_0;
    slice0window_tag.first_column <= slice0window_centre_first_column_0;
    -- slice0winner1
    slice0winner1_of_pair_0_is_less(0) := (slice0window_sum_0(1) - slice0window_sum_0(0)) < 0;
    slice0winner1_of_pair_0_is_less(2) := (slice0window_sum_0(3) - slice0window_sum_0(2)) < 0;
    slice0winner1_of_four_0_0_is_less := (to_integer(((to_unsigned(slice0winner1_of_pair_0(2), 12)) or
      (to_unsigned(slice0winner1_of_pair_0(3), 12)))) - to_integer(((to_unsigned(slice0winner1_of_pair_0(0), 12)) or
      (to_unsigned(slice0winner1_of_pair_0(1), 12))))) < 0;
    slice0winner1_of_pair_0(4) <= slice0window_sum_0(4);
    slice0winner1_pair_index_0_0 <= slice0winner1_of_pair_0_is_less(0);
    slice0winner1_pair_index_0(2) <= 4;
    slice0winner1_pair_tag <= slice0window_tag;
    slice0winner1_of_four_0(4) <= slice0winner1_of_pair_0(4);
    slice0winner1_four_index_0(1) <= slice0winner1_pair_index_0(2);
    slice0winner1_four_tag <= slice0winner1_pair_tag;
    slice0winner1_best_cost_0(0) <= to_integer(((((((to_unsigned(slice0winner1_of_four_0(2), 12)) or
      (to_unsigned(slice0winner1_of_four_0(3), 12)))) or (to_unsigned(slice0winner1_of_four_0(1), 12)))) or
      (to_unsigned(slice0winner1_of_four_0(0), 12))));
    slice0winner1_best_cost_0(1) <= slice0winner1_of_four_0(4);
    slice0winner1_best_index_0 <= slice0winner1_four_index_0;
    slice0winner1_tag <= slice0winner1_four_tag;
    for i in 0 to 1 loop
      slice0winner1_of_pair_0(2 * i) <= choice(slice0winner1_of_pair_0_is_less(2 * i), 0, slice0window_sum_0(2 * i));
      slice0winner1_of_pair_0(2 * i + 1) <= choice(slice0winner1_of_pair_0_is_less(2 * i), slice0window_sum_0(2 * i +
        1), 0);
    end loop;
    slice0winner1_pair_index_0(1) <= choice(slice0winner1_of_pair_0_is_less(2), 3, 2);
    slice0winner1_of_four_0(0) <= choice(slice0winner1_of_four_0_0_is_less, 0, slice0winner1_of_pair_0(0));
    slice0winner1_of_four_0(1) <= choice(slice0winner1_of_four_0_0_is_less, 0, slice0winner1_of_pair_0(1));
    slice0winner1_of_four_0(2) <= choice(slice0winner1_of_four_0_0_is_less, slice0winner1_of_pair_0(2), 0);
    slice0winner1_of_four_0(3) <= choice(slice0winner1_of_four_0_0_is_less, slice0winner1_of_pair_0(3), 0);
    slice0winner1_four_index_0(0) <= choice(slice0winner1_of_four_0_0_is_less, slice0winner1_pair_index_0(1),
      as_number(slice0winner1_pair_index_0_0));
    -- slice0winner2
    slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0(1) - slice0winner1_best_cost_0(0)) < 0;
    slice0winner2_tag <= slice0winner1_tag;
    slice0winner2_best_cost_0_0 <= choice(slice0winner2_best_cost_0_0_is_less, slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0_0 <= choice(slice0winner2_best_cost_0_0_is_less, slice0winner1_best_index_0(1),
      slice0winner1_best_index_0(0));
    -- slice0
    slice0_best_cost_0_0 <= slice0winner2_best_cost_0_0;
    slice0_best_index_0_0 <= slice0winner2_best_index_0_0;
    slice0_best_tag <= slice0winner2_tag;
    -- best
    best_last_pass_is_equal := best_pass = 19;
    best_here_wins_is_less := (best_ready_cost_0_0 - (best_ready_words_0 mod 4096)) < 0;
    best_write_column_choices(1) := choice(best_compared_tag.first_column, 0, (best_place_column + 1) mod 512);
    best_write_column_choices(2) := choice(best_compared_tag.valid, best_write_column_choices(1), best_place_column);
    best_read_cost_0_0 <= slice0_best_cost_0_0;
    best_read_index_0_0 <= slice0_best_index_0_0;
    best_read_tag <= slice0_best_tag;
    best_waiting_cost_0_0 <= best_read_cost_0_0;
    best_waiting_index_0_0 <= best_read_index_0_0;
    best_waiting_tag <= best_read_tag;
    best_ready_cost_0_0 <= best_waiting_cost_0_0;
    best_ready_index_0_0 <= best_waiting_index_0_0;
    best_ready_tag <= best_waiting_tag;
    best_ready_words_0 <= to_integer(best_read_words_0);
    best_compared_cost_0_0 <= best_ready_cost_0_0;
    best_compared_index_0_0 <= (best_base + best_ready_index_0_0) mod 256;
    best_compared_tag <= best_ready_tag;
    best_compared_words_0 <= best_ready_words_0;
    best_last_pass <= best_last_pass_is_equal;
    best_best_tag.valid <= best_compared_tag.valid;
    best_best_tag.map_column <= best_last_pass and best_compared_tag.map_column;
    best_best_tag.first_column <= best_last_pass and best_compared_tag.first_column;
    best_here_wins <= choice((best_pass / 2) = 0, best_here_wins_is_less or (not is_set(best_pass, 0)),
      best_here_wins_is_less);
    best_best_cost_0_0 <= choice(best_here_wins, best_compared_cost_0_0, best_compared_words_0 mod 4096);
    best_best_index_0_0 <= choice(best_here_wins, best_compared_index_0_0, best_compared_words_0 / 4096);
    best_write_column <= choice((not best_compared_tag.map_column) or (not best_compared_tag.valid), 511,
      best_write_column_choices(2));
    if slice0_best_tag.valid then
      best_column <= choice(slice0_best_tag.first_column, 0, (best_column + 1) mod 512);
    end if;
    best_pass_any := (not best_waiting_tag.valid) or (not best_waiting_tag.first_column);
    if not best_pass_any then
      best_pass <= choice(best_last_pass_is_equal, 0, (best_pass + 1) mod 32);
      best_base <= choice(best_last_pass_is_equal, 0, (best_base + 5) mod 256);
    end if;
    if best_compared_tag.valid then best_place_column <= best_write_column_choices(1); end if;
    -- winners
    winners_row_differs := winners_row /= best_best_tag.first_column;
    if best_best_tag.valid then
      winners_row <= choice(best_best_tag.map_column, winners_row_differs, winners_row);
    end if;
    winners_column_choice := choice(best_best_tag.first_column, 0, winners_column);
    winners_column_any := (not best_best_tag.valid) or (not best_best_tag.map_column);
    if not winners_column_any then winners_column <= (winners_column_choice + 1) mod 512; end if;
    winners_write_word_0 <= best_best_index_0_0 mod 128;
    winners_read_tag.valid <= passes_arrived;
    winners_read_tag.output_column <= ((passes_write_address mod 512) < 220) and passes_inside_0;
    winners_read_tag.start_of_frame <= ((passes_write_address mod 512) = 0) and passes_leaving_starts;
    winners_read_tag.end_of_line <= (passes_write_address mod 512) = 219;
    winners_winners_disparity_0 <= to_integer(winners_read_word_0);
    winners_winners_tag <= winners_read_tag;
    winners_write_address <= choice(winners_column_any, 1023, winners_column_choice + (as_number(winners_row_differs) *
      512));
    -- other
    other_choice(0, 1) := choice(rows_ready_inside(0), rows_reference_rows_ready_words_0 mod 256, 0);
    other_choice(0, 2) := choice(rows_ready_inside(1), rows_reference_rows_ready_words_0 / 256, 0);
    other_choice(1, 1) := choice(rows_ready_inside(0), rows_search_rows_ready_words_0 mod 256, 0);
    other_choice(1, 2) := choice(rows_ready_inside(1), rows_search_rows_ready_words_0 / 256, 0);
    other(0) <= other_choice(0, 1) + (other_choice(0, 2) * 256);
    other(1) <= other_choice(1, 1) + (other_choice(1, 2) * 256);
    if reset = '1' then
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 241;
      raster_place_next_frame <= false; delay_column <= 0; delay_tag <= (others => false); rows_read_column <= 0;
      rows_read_tag <= (others => false); rows_ready_column <= 0; rows_ready_tag <= (others => false);
      rows_write_column <= 0; rows_tag <= (others => false); passes_row <= false; passes_coming_output <= false;
      passes_coming_starts <= false; passes_row_ended <= false; passes_ended_last <= false; passes_arrived <= false;
      passes_write_address <= 0; passes_shows <= false; passes_showing_output <= false; passes_showing_starts <= false;
      passes_inside_0 <= false; passes_pass <= 0; passes_column <= 0; passes_pass_ends <= false;
      passes_last_pass <= false; passes_search_start <= 5; passes_search_address <= 0; passes_reference_address <= 508;
      passes_leaving_starts <= false; passes_read_tag.valid <= false; passes_read_tag.first_cost <= false;
      passes_read_tag.map_column <= false; passes_read_tag.end_of_line <= false; passes_tag.valid <= false;
      passes_tag.first_cost <= false; passes_tag.map_column <= false; slice0shift_tag.valid <= false;
      slice0shift_tag.first_cost <= false; slice0shift_tag.map_column <= false;
      slice0cost_difference_tag.valid <= false; slice0cost_difference_tag.first_cost <= false;
      slice0cost_difference_tag.map_column <= false; slice0cost_pair_tag.valid <= false;
      slice0cost_pair_tag.first_cost <= false; slice0cost_pair_tag.map_column <= false;
      slice0cost_tag <= (others => false); slice0window_centre_map_column_0 <= false;
      slice0window_centre_first_column_0 <= false; slice0window_tag <= (others => false);
      slice0winner1_pair_tag <= (others => false); slice0winner1_four_tag <= (others => false);
      slice0winner1_tag <= (others => false); slice0winner2_tag <= (others => false);
      slice0_best_tag <= (others => false); best_read_tag <= (others => false); best_column <= 0;
      best_waiting_tag <= (others => false); best_ready_tag <= (others => false); best_pass <= 19;
      best_compared_tag <= (others => false); best_last_pass <= false; best_best_tag <= (others => false);
      best_place_column <= 0; best_write_column <= 0; winners_row <= true; winners_column <= 0;
      winners_write_address <= 0; winners_read_tag <= (others => false); winners_winners_tag <= (others => false);
    end if;
  end process;
end architecture;
