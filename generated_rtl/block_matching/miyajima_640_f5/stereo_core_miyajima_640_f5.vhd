-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration miyajima_640_f5: 640x480, 200 disparities, window 7x7, 1 pixel pair a clock.
-- Options: disparities 200, window_px 7, aggregation recursive, clocks_per_pixel 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config miyajima_640_f5
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_miyajima_640_f5 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 200;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 440;
    latency_clocks : positive := 8;
    flush_groups : positive := 3000;
    gap_groups : positive := 1920
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
  assert width_px = 640 report "stereo_core_miyajima_640_f5: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_miyajima_640_f5: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 200 report "stereo_core_miyajima_640_f5: disparities is " & integer'image(disparities) & " but this core has 200" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_miyajima_640_f5: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_miyajima_640_f5: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 440 report "stereo_core_miyajima_640_f5: output_width_px is " & integer'image(output_width_px) & " but this core has 440" severity failure;
  assert latency_clocks = 8 report "stereo_core_miyajima_640_f5: latency_clocks is " & integer'image(latency_clocks) & " but this core has 8" severity failure;
  assert flush_groups = 3000 report "stereo_core_miyajima_640_f5: flush_groups is " & integer'image(flush_groups) & " but this core has 3000" severity failure;
  assert gap_groups = 1920 report "stereo_core_miyajima_640_f5: gap_groups is " & integer'image(gap_groups) & " but this core has 1920" severity failure;
end entity;

architecture rtl of stereo_core_miyajima_640_f5 is
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
  type integer_minus_2047_to_2047_1d is array (natural range <>) of integer range -2047 to 2047;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type integer_minus_255_to_255_2d is array (natural range <>, natural range <>) of integer range -255 to 255;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_14_1d is array (natural range <>) of natural range 0 to 14;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2047_2d is array (natural range <>, natural range <>) of natural range 0 to 2047;
  type natural_24_1d is array (natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_4194303_1d is array (natural range <>) of natural range 0 to 4194303;
  type unsigned_22_1d is array (natural range <>) of unsigned(21 downto 0);
  type tag_5 is record
    valid, row_start, first_group, output_column, start_of_frame : boolean;
  end record;
  type tag_8 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, map_column, end_of_line : boolean;
  end record;
  type tag_7 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, map_column : boolean;
  end record;
  type tag_6 is record
    valid, first_group, border_column, first_cost, leaves_window, map_column : boolean;
  end record;
  type tag_4 is record
    valid, first_cost, leaves_window, map_column : boolean;
  end record;
  type tag_3 is record
    valid, map_column, first_column : boolean;
  end record;
  type tag_4_b is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_start_of_frame, in_valid : boolean;
  signal in_left_pixel, in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 255;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 255;
  signal delay_column : natural range 0 to 1023;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag : tag_5;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_ready_words_0, rows_search_rows_write_words_0,
    rows_reference_rows_read_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_read_words_1, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_search_rows_ready_words_1, rows_search_rows_write_words_1, rows_reference_rows_ready_words_1,
    rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 1023;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag : tag_5;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag, rows_tag : tag_5;
  signal rows_search, rows_reference : natural range 0 to 65535;
  -- passes
  signal passes_row, passes_coming_first_group, passes_coming_output, passes_coming_starts, passes_row_ended,
    passes_ended_last, passes_arrived, passes_shows, passes_showing_first_group, passes_showing_output,
    passes_showing_starts, passes_pass_ends, passes_last_pass, passes_leaving_output, passes_leaving_starts : boolean;
  signal passes_read_tag : tag_8;
  signal passes_tag : tag_7;
  signal passes_write_address, passes_search_address, passes_reference_address : natural range 0 to 2047;
  signal passes_write_search_0, passes_write_reference_0 : natural range 0 to 65535;
  signal passes_pass : natural range 0 to 7;
  signal passes_column : natural range 0 to 511;
  signal passes_search_start : natural range 0 to 1023;
  signal passes_read_search_0, passes_read_reference_0 : unsigned(15 downto 0);
  signal passes_search, passes_reference : natural_255_1d(0 to 1);
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice0shift_reference, slice0shift_search_out : natural_255_1d(0 to 1);
  signal slice0shift_tag : tag_7;
  -- slice0cost
  signal slice0cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice0cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice0cost_pixels_first_tag : tag_7;
  signal slice0cost_pixels_tag, slice0cost_ready_tag, slice0cost_tag : tag_6;
  signal slice0cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column,
    slice0cost_write_column : natural range 0 to 4095;
  signal slice0cost_read_words : unsigned_22_1d(0 to 11);
  signal slice0cost_read_words_12 : unsigned(10 downto 0);
  signal slice0cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice0cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice0cost_ready_words_12 : natural range 0 to 2047;
  signal slice0cost_column_0 : natural_2047_1d(0 to 24);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 7;
  signal slice0window_leaving : unsigned_22_1d(0 to 11);
  signal slice0window_leaving_12 : unsigned(10 downto 0);
  signal slice0window_entering_0 : natural_2047_1d(0 to 24);
  signal slice0window_entering_tag, slice0window_change_tag : tag_4;
  signal slice0window_centre_map_column, slice0window_centre_first_column : boolean_1d(0 to 2);
  signal slice0window_tag : tag_3;
  signal slice0window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice0window_sum_0 : natural_16383_1d(0 to 24);
  -- slice0winner1
  signal slice0winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_tag : tag_3;
  signal slice0winner1_best_index_0 : natural_24_1d(1 to 12);  -- _# up to 3, 5 .. 23, 24
  -- slice0winner2
  signal slice0winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice0winner2_best_index_0 : natural_24_1d(0 to 6);  -- _# up to 3, 7 .. 23, 24
  signal slice0winner2_tag : tag_3;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice0winner3_best_index_0 : natural_24_1d(0 to 3);  -- _# up to 7, 15, 23, 24
  signal slice0winner3_tag : tag_3;
  -- slice0winner4
  signal slice0winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice0winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  signal slice0winner4_tag : tag_3;
  -- slice0winner5
  signal slice0winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice0winner5_best_index_0_0 : natural range 0 to 24;
  signal slice0winner5_tag : tag_3;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 16383;
  signal slice0_best_index_0_0 : natural range 0 to 39;
  signal slice0_best_tag : tag_3;
  -- slice1shift
  signal slice1shift_search : natural_255_2d(0 to 1, 0 to 14);
  signal slice1shift_reference : natural_255_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 14);
  signal slice1cost_change_0 : integer_minus_255_to_255_1d(0 to 14);
  signal slice1cost_pixels_cost : natural_255_2d(0 to 1, 0 to 14);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column,
    slice1cost_write_column : natural range 0 to 4095;
  signal slice1cost_read_words : unsigned_22_1d(0 to 6);
  signal slice1cost_read_words_7 : unsigned(10 downto 0);
  signal slice1cost_ready_words : natural_4194303_1d(0 to 6);
  signal slice1cost_write_words : natural_4194303_1d(0 to 7);  -- _# up to 4194303 x 7, 2047
  signal slice1cost_ready_words_7 : natural range 0 to 2047;
  signal slice1cost_column_0 : natural_2047_1d(0 to 14);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 7;
  signal slice1window_leaving : unsigned_22_1d(0 to 6);
  signal slice1window_leaving_7 : unsigned(10 downto 0);
  signal slice1window_entering_0 : natural_2047_1d(0 to 14);
  signal slice1window_change_0 : integer_minus_2047_to_2047_1d(0 to 14);
  signal slice1window_sum_0 : natural_16383_1d(0 to 14);
  -- slice1winner1
  signal slice1winner1_best_cost_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_14_1d(1 to 7);  -- _# up to 3, 5 .. 13, 14
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_index_0 : natural_14_1d(0 to 3);  -- _# up to 3, 7, 11, 14
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_index_0 : natural_14_1d(0 to 1);  -- _# up to 7, 14
  -- slice1winner4
  signal slice1winner4_best_cost_0_0 : natural range 0 to 16383;
  signal slice1winner4_best_index_0_0 : natural range 0 to 14;
  -- slice1winner5
  signal slice1winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice1winner5_best_index_0_0 : natural range 0 to 14;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 16383;
  signal slice1_best_index_0_0 : natural range 0 to 39;
  signal slice1_best_tag : tag_3;
  -- best
  signal best_read_cost_0_0, best_waiting_cost_0_0, best_ready_cost_0_0, best_compared_cost_0_0,
    best_best_cost_0_0 : natural range 0 to 16383;
  signal best_read_index_0_0, best_waiting_index_0_0, best_ready_index_0_0 : natural range 0 to 39;
  signal best_read_tag, best_waiting_tag, best_ready_tag, best_compared_tag : tag_3;
  signal best_last_pass, best_here_wins : boolean;
  signal best_best_tag : tag_3;
  signal best_column, best_place_column, best_write_column : natural range 0 to 1023;
  signal best_read_words_0 : unsigned(21 downto 0);
  signal best_ready_words_0, best_compared_words_0 : natural range 0 to 4194303;
  signal best_pass : natural range 0 to 7;
  signal best_base : natural range 0 to 248;
  signal best_compared_index_0_0, best_best_index_0_0 : natural range 0 to 255;
  -- winners
  signal winners_row : boolean;
  signal winners_read_tag, winners_winners_tag : tag_4_b;
  signal winners_column : natural range 0 to 1023;
  signal winners_write_address : natural range 0 to 2047;
  signal winners_write_word_0, winners_winners_disparity_0 : natural range 0 to 255;
  signal winners_read_word_0 : unsigned(7 downto 0);

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
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(passes_write_address, 11);
    write_address <= to_unsigned(winners_write_address, 11);
    write_data <= to_unsigned(winners_write_word_0, 8);
    cell : entity work.line_memory generic map (2048, 8, 11)
      port map (clock, true, read_address, winners_read_word_0, write_address, write_data);
  end block;

  best_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(best_column, 10);
    write_address <= to_unsigned(best_write_column, 10);
    write_data <= to_unsigned(best_best_index_0_0, 8) & to_unsigned(best_best_cost_0_0, 14);
    cell : entity work.line_memory generic map (1024, 22, 10)
      port map (clock, true, read_address, best_read_words_0, write_address, write_data);
  end block;

  slice1window_leaving_7_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 3);
    write_address <= to_unsigned(slice1window_ring_write_address, 3);
    write_data <= to_unsigned(slice1cost_column_0(14), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice1window_leaving_7, write_address, write_data);
  end block;

  slice1window_leaving_memory : for i in 6 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 3);
    write_address <= to_unsigned(slice1window_ring_write_address, 3);
    write_data <= to_unsigned(slice1cost_column_0(2 * i + 1), 11) & to_unsigned(slice1cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice1window_leaving(i), write_address, write_data);
  end generate;

  slice1cost_read_words_7_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 12);
    write_address <= to_unsigned(slice1cost_write_column, 12);
    write_data <= to_unsigned(slice1cost_write_words(7), 11);
    cell : entity work.line_memory generic map (2415, 11, 12)
      port map (clock, true, read_address, slice1cost_read_words_7, write_address, write_data);
  end block;

  slice1cost_read_words_memory : for i in 6 downto 0 generate
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 12);
    write_address <= to_unsigned(slice1cost_write_column, 12);
    write_data <= to_unsigned(slice1cost_write_words(i), 22);
    cell : entity work.line_memory generic map (2415, 22, 12)
      port map (clock, true, read_address, slice1cost_read_words(i), write_address, write_data);
  end generate;

  slice0window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 3);
    write_address <= to_unsigned(slice0window_ring_write_address, 3);
    write_data <= to_unsigned(slice0cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice0window_leaving_12, write_address, write_data);
  end block;

  slice0window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 3);
    write_address <= to_unsigned(slice0window_ring_write_address, 3);
    write_data <= to_unsigned(slice0cost_column_0(2 * i + 1), 11) & to_unsigned(slice0cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice0window_leaving(i), write_address, write_data);
  end generate;

  slice0cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 12);
    write_address <= to_unsigned(slice1cost_ready_column, 12);
    write_data <= to_unsigned(slice0cost_write_words(12), 11);
    cell : entity work.line_memory generic map (2415, 11, 12)
      port map (clock, true, read_address, slice0cost_read_words_12, write_address, write_data);
  end block;

  slice0cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 12);
    write_address <= to_unsigned(slice1cost_ready_column, 12);
    write_data <= to_unsigned(slice0cost_write_words(i), 22);
    cell : entity work.line_memory generic map (2415, 22, 12)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, write_data);
  end generate;

  passes_read_search_0_memory : block
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(passes_search_address, 11);
    write_address <= to_unsigned(passes_write_address, 11);
    write_data <= to_unsigned(passes_write_search_0, 16);
    cell : entity work.line_memory generic map (2048, 16, 11)
      port map (clock, true, read_address, passes_read_search_0, write_address, write_data);
  end block;

  passes_read_reference_0_memory : block
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(passes_reference_address, 11);
    write_address <= to_unsigned(passes_write_address, 11);
    write_data <= to_unsigned(passes_write_reference_0, 16);
    cell : entity work.line_memory generic map (2048, 16, 11)
      port map (clock, true, read_address, passes_read_reference_0, write_address, write_data);
  end block;

  rows_search_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(rows_search_rows_write_words_1, 24);
    cell : entity work.line_memory generic map (640, 24, 10)
      port map (clock, true, read_address, rows_search_rows_read_words_1, write_address, write_data);
  end block;

  rows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, rows_search_rows_read_words_0, write_address,
        rows_search_rows_write_words_0);
  end block;

  rows_reference_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(rows_reference_rows_write_words_1, 24);
    cell : entity work.line_memory generic map (640, 24, 10)
      port map (clock, true, read_address, rows_reference_rows_read_words_1, write_address, write_data);
  end block;

  rows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, rows_reference_rows_read_words_0, write_address,
        rows_reference_rows_write_words_0);
  end block;

  process
    variable raster_place_group_is_equal, delay_tag_row_start_is_equal, passes_row_is_equal,
      passes_coming_first_group_all, passes_coming_first_group_any, passes_row_ended_all, passes_shows_any,
      passes_showing_first_group_differs, passes_showing_output_any, passes_read_tag_border_column_differs,
      passes_read_tag_border_column_choice, passes_read_tag_first_cost_is_equal, passes_read_tag_leaves_window_differs,
      slice0winner5_best_cost_0_0_is_less, slice1winner4_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less,
      best_base_any, best_base_is_equal, winners_row_differs, winners_column_any : boolean;
    variable rows_search_choices, rows_reference_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable passes_search_start_choices : natural_127_1d(1 to 2);  -- _choice_#
    variable passes_search_address_value : natural range 0 to 1024;
    variable passes_search_address_choice : natural range 0 to 127;
    variable passes_search_address_choice_2, passes_reference_address_choice,
      winners_column_choice : natural range 0 to 1023;
    variable passes_leaving_output_choices, passes_leaving_starts_choices : boolean_1d(1 to 2);  -- _choice_#
    variable slice0cost_column_0_choice : natural_2047_2d(0 to 24, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice : natural_2047_1d(0 to 24);  -- _#_choice
    variable slice0window_sum_0_choice : natural_16383_1d(0 to 24);  -- _#_choice
    variable slice0winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- _#_is_less
    variable slice0winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable slice0winner4_best_cost_0_is_less, slice1winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
    variable slice1cost_column_0_choice : natural_2047_2d(0 to 14, 1 to 2);  -- _#_choice_#
    variable slice1window_change_0_choice : natural_2047_1d(0 to 14);  -- _#_choice
    variable slice1window_sum_0_choice : natural_16383_1d(0 to 14);  -- _#_choice
    variable slice1winner1_best_cost_0_is_less : boolean_1d(0 to 6);  -- _#_is_less
    variable slice1winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable best_base_choices : natural_31_1d(1 to 2);  -- _choice_#
    variable best_write_column_choices : natural_1023_1d(1 to 2);  -- _choice_#
  begin
    wait until rising_edge(clock);
    -- raster
    raster_place_group_is_equal := raster_place_column = 639;
    raster_features_search_0 <= in_left_pixel;
    raster_features_reference_0 <= in_right_pixel;
    raster_features_valid <= in_valid;
    raster_place_group <= choice(in_start_of_frame and in_valid, 0, (raster_place_group +
      as_number(((raster_place_group /= 483) and raster_place_group_is_equal and in_valid))) mod 512);
    if in_valid then
      raster_place_column <= choice(raster_place_group_is_equal or in_start_of_frame, 0, (raster_place_column + 1) mod
        1024);
    end if;
    -- delay
    delay_tag_row_start_is_equal := raster_place_column = 0;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 7) and (raster_place_group < 487);
    delay_row_inside(1) <= raster_place_group < 480;
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= delay_tag_row_start_is_equal;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.output_column <= (raster_place_group >= 3) and (raster_place_group < 483) and (raster_place_column < 639);
    delay_tag.start_of_frame <= (raster_place_group = 3) and delay_tag_row_start_is_equal;
    -- rows
    rows_search_choices(1) := choice(rows_ready_inside(0), to_integer(rows_search_rows_ready_words_0(7 downto 0)), 0);
    rows_search_choices(2) := choice(rows_ready_inside(1), rows_search_rows_ready_newest_0, 0);
    rows_reference_choices(1) := choice(rows_ready_inside(0), to_integer(rows_reference_rows_ready_words_0(7 downto
      0)), 0);
    rows_reference_choices(2) := choice(rows_ready_inside(1), rows_reference_rows_ready_newest_0, 0);
    rows_search_rows_read_newest_0 <= delay_delayed_0;
    rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
    rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= delay_ahead_0;
    rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
    rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_search <= rows_search_choices(1) + (rows_search_choices(2) * 256);
    rows_reference <= rows_reference_choices(1) + (rows_reference_choices(2) * 256);
    rows_tag <= rows_ready_tag;
    if rows_ready_tag.valid then
      rows_search_rows_write_words_0 <= to_unsigned((rows_search_rows_ready_words_1 mod 256), 8) &
        rows_search_rows_ready_words_0(31 downto 8);
      rows_search_rows_write_words_1 <= (rows_search_rows_ready_newest_0 * 65536) + ((rows_search_rows_ready_words_1 /
        65536) * 256) + ((rows_search_rows_ready_words_1 mod 65536) / 256);
      rows_reference_rows_write_words_0 <= to_unsigned((rows_reference_rows_ready_words_1 mod 256), 8) &
        rows_reference_rows_ready_words_0(31 downto 8);
      rows_reference_rows_write_words_1 <= (rows_reference_rows_ready_newest_0 * 65536) +
        ((rows_reference_rows_ready_words_1 / 65536) * 256) + ((rows_reference_rows_ready_words_1 mod 65536) / 256);
      rows_write_column <= rows_ready_column;
    end if;
    -- passes
    passes_row_is_equal := rows_write_column = 639;
    if passes_row_is_equal then passes_row <= rows_tag.valid /= passes_row; end if;
    passes_coming_first_group_all := rows_tag.row_start and rows_tag.valid;
    passes_coming_first_group_any := (not rows_tag.row_start) or (not rows_tag.valid);
    passes_row_ended_all := passes_row_is_equal and rows_tag.valid;
    passes_shows_any := (not passes_last_pass) or (not passes_pass_ends);
    passes_showing_first_group_differs := rows_write_column /= 639;
    passes_showing_output_any := passes_showing_first_group_differs or (not rows_tag.valid);
    passes_search_start_choices(1) := choice(passes_shows_any, ((passes_search_start / 8) + 5) mod 128, 5);
    passes_search_start_choices(2) := choice(passes_pass_ends, passes_search_start_choices(1), passes_search_start / 8);
    passes_search_address_value := as_number((not passes_row)) * 1024;
    passes_search_address_choice := choice(passes_shows_any, passes_search_start / 8, 0);
    passes_search_address_choice_2 := choice(passes_pass_ends, passes_search_address_choice * 8, (passes_search_address
      + as_number(passes_shows)) mod 1024);
    passes_reference_address_choice := choice(passes_pass_ends, 985, (passes_reference_address +
      as_number(passes_shows)) mod 1024);
    passes_leaving_output_choices(1) := choice(passes_ended_last, passes_leaving_output, (not rows_tag.valid) and
      passes_leaving_output);
    passes_leaving_output_choices(2) := choice(rows_tag.row_start, passes_leaving_output_choices(1),
      passes_leaving_output);
    passes_leaving_starts_choices(1) := choice(passes_row_is_equal, rows_tag.valid or passes_leaving_starts,
      passes_leaving_starts);
    passes_leaving_starts_choices(2) := choice(passes_row_is_equal, (not rows_tag.valid) and passes_leaving_starts,
      passes_leaving_starts);
    passes_read_tag_border_column_differs := passes_column /= 39;
    passes_read_tag_border_column_choice := choice(passes_column = 0, passes_read_tag_border_column_differs,
      (passes_column = 480) and passes_read_tag_border_column_differs);
    passes_read_tag_first_cost_is_equal := passes_column = 39;
    passes_read_tag_leaves_window_differs := passes_column /= 0;
    passes_row_ended <= passes_row_ended_all;
    passes_arrived <= rows_tag.valid;
    passes_pass_ends <= passes_column = 481;
    passes_last_pass <= passes_pass = 4;
    passes_search_start <= passes_search_start_choices(2) * 8;
    passes_search_address <= passes_search_address_value + passes_search_address_choice_2;
    passes_reference_address <= passes_search_address_value + passes_reference_address_choice;
    passes_read_tag.valid <= passes_shows;
    passes_read_tag.row_start <= to_integer(((to_unsigned(passes_pass, 9)) or (to_unsigned(passes_column, 9)))) = 0;
    passes_read_tag.first_group <= passes_showing_first_group;
    passes_read_tag.first_cost <= passes_read_tag_first_cost_is_equal;
    passes_read_tag.end_of_line <= passes_column = 478;
    passes_search(0) <= to_integer(passes_read_search_0(7 downto 0));
    passes_search(1) <= to_integer(passes_read_search_0(15 downto 8));
    passes_reference(0) <= to_integer(passes_read_reference_0(7 downto 0));
    passes_reference(1) <= to_integer(passes_read_reference_0(15 downto 8));
    passes_tag.valid <= passes_read_tag.valid;
    passes_tag.row_start <= passes_read_tag.row_start;
    passes_tag.first_group <= passes_read_tag.first_group;
    passes_tag.border_column <= passes_read_tag.border_column;
    passes_tag.first_cost <= passes_read_tag.first_cost;
    passes_tag.leaves_window <= passes_read_tag.leaves_window;
    passes_tag.map_column <= passes_read_tag.map_column;
    passes_coming_first_group <= choice(rows_tag.first_group, passes_coming_first_group or
      passes_coming_first_group_all, passes_coming_first_group and passes_coming_first_group_any);
    passes_coming_output <= choice(rows_tag.output_column, passes_coming_output or passes_coming_first_group_all,
      passes_coming_output and passes_coming_first_group_any);
    passes_coming_starts <= choice(rows_tag.start_of_frame, passes_coming_starts or passes_coming_first_group_all,
      passes_coming_starts and passes_coming_first_group_any);
    passes_shows <= choice(passes_row_ended, (not passes_shows) or (not passes_last_pass) or (not passes_pass_ends),
      passes_shows and passes_shows_any);
    passes_showing_first_group <= choice(passes_showing_first_group, passes_coming_first_group or
      passes_showing_first_group_differs or (not rows_tag.valid), passes_coming_first_group and passes_row_is_equal and
      rows_tag.valid);
    passes_showing_output <= choice(passes_coming_output, passes_showing_output or passes_row_ended_all,
      passes_showing_output and passes_showing_output_any);
    passes_showing_starts <= choice(passes_coming_starts, passes_showing_starts or passes_row_ended_all,
      passes_showing_starts and passes_showing_output_any);
    passes_column <= choice(passes_pass_ends, 0, (passes_column + as_number(passes_shows)) mod 512);
    passes_leaving_output <= choice(passes_leaving_output_choices(2), passes_showing_output or
      passes_showing_first_group_differs or (not rows_tag.valid), passes_showing_output and passes_row_is_equal and
      rows_tag.valid);
    passes_leaving_starts <= choice(passes_showing_starts, passes_leaving_starts_choices(1),
      passes_leaving_starts_choices(2));
    passes_read_tag.border_column <= choice(passes_read_tag.border_column, passes_read_tag_border_column_differs,
      passes_read_tag_border_column_choice);
    passes_read_tag.leaves_window <= choice(passes_read_tag.leaves_window, passes_read_tag_leaves_window_differs,
      (passes_column = 46) and passes_read_tag_leaves_window_differs);
    passes_read_tag.map_column <= choice(passes_read_tag.map_column, passes_read_tag_first_cost_is_equal or (not
      passes_read_tag.end_of_line), passes_read_tag_first_cost_is_equal);
    if rows_tag.valid then
      passes_ended_last <= passes_row_is_equal;
      passes_write_address <= rows_write_column + (as_number(passes_row) * 1024);
      passes_write_search_0 <= rows_search;
      passes_write_reference_0 <= rows_reference;
    end if;
    if passes_pass_ends then passes_pass <= choice(passes_shows_any, (passes_pass + 1) mod 8, 0); end if;
    -- slice0shift
    if passes_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice0shift_search(i, j) <= slice0shift_search(i, j + 1); end loop;
        slice0shift_search(i, 24) <= passes_search(i);
      end loop;
    end if;
    slice0shift_reference <= passes_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 0);
    slice0shift_search_out(1) <= slice0shift_search(1, 0);
    slice0shift_tag <= passes_tag;
    -- slice0cost
    for i in 0 to 11 loop
      slice0cost_column_0_choice(2 * i, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i) mod
        2048);
      slice0cost_column_0_choice(2 * i, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(2 * i)
        + slice0cost_column_0_choice(2 * i, 1)) mod 2048);
      slice0cost_column_0_choice(2 * i + 1, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i)
        / 2048);
      slice0cost_column_0_choice(2 * i + 1, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(2
        * i + 1) + slice0cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice0cost_column_0_choice(24, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words_12);
    slice0cost_column_0_choice(24, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(24) +
      slice0cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice0cost_pixels_first(0, i) <= slice0shift_search(0, i) - slice0shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice0cost_pixels_first(1, i) <= slice0shift_search(1, i) - slice0shift_reference(1);
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice0cost_pixels_cost(i, j) <= (folded(slice0cost_pixels_first(i, j)) + as_number((slice0cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice0cost_pixels_tag.valid <= slice0cost_pixels_first_tag.valid;
    slice0cost_pixels_tag.first_group <= slice0cost_pixels_first_tag.first_group;
    slice0cost_pixels_tag.border_column <= slice0cost_pixels_first_tag.border_column;
    slice0cost_pixels_tag.first_cost <= slice0cost_pixels_first_tag.first_cost;
    slice0cost_pixels_tag.leaves_window <= slice0cost_pixels_first_tag.leaves_window;
    slice0cost_pixels_tag.map_column <= slice0cost_pixels_first_tag.map_column;
    for i in 0 to 24 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice0cost_ready_words(i) <= to_integer(slice0cost_read_words(i)); end loop;
    slice0cost_ready_words_12 <= to_integer(slice0cost_read_words_12);
    slice0cost_ready_column <= slice0cost_change_column;
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    for i in 0 to 24 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
    slice0cost_write_column <= slice0cost_ready_column;
    slice0cost_tag <= slice0cost_ready_tag;
    if slice0shift_tag.valid then
      slice0cost_read_column <= choice(slice0shift_tag.row_start, 0, (slice0cost_read_column + 1) mod 4096);
    end if;
    if slice0cost_pixels_first_tag.valid then
      slice0cost_change_column <= choice(slice0cost_pixels_first_tag.row_start, 0, (slice0cost_change_column + 1) mod
        4096);
    end if;
    if slice0cost_ready_tag.valid then
      for i in 0 to 11 loop
        slice0cost_write_words(i) <= (slice0cost_column_0_choice(2 * i + 1, 2) * 2048) + slice0cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice0cost_write_words(12) <= slice0cost_column_0_choice(24, 2);
    end if;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_ring_write_address <= slice0window_ring_read_address;
      slice0window_ring_read_address <= choice(slice0window_ring_read_address = 7, 0, (slice0window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice0window_change_0_choice(2 * i) := choice(slice0window_entering_tag.leaves_window,
        to_integer(slice0window_leaving(i)(10 downto 0)), 0);
      slice0window_change_0_choice(2 * i + 1) := choice(slice0window_entering_tag.leaves_window,
        to_integer(slice0window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice0window_change_0_choice(24) := choice(slice0window_entering_tag.leaves_window,
      to_integer(slice0window_leaving_12), 0);
    slice0window_entering_0 <= slice0cost_column_0;
    slice0window_entering_tag.valid <= slice0cost_tag.valid;
    slice0window_entering_tag.first_cost <= slice0cost_tag.first_cost;
    slice0window_entering_tag.leaves_window <= slice0cost_tag.leaves_window;
    slice0window_entering_tag.map_column <= slice0cost_tag.map_column;
    for i in 0 to 24 loop
      slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
    end loop;
    slice0window_change_tag <= slice0window_entering_tag;
    slice0window_centre_map_column(0) <= slice0window_change_tag.map_column;
    slice0window_centre_first_column(0) <= slice0window_change_tag.first_cost;
    slice0window_tag.valid <= slice0window_change_tag.valid;
    for i in 0 to 24 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 24 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 16384;
      end loop;
    end if;
    if slice0window_tag.valid then
      slice0window_centre_map_column(1 to 2) <= slice0window_centre_map_column(0 to 1);
      slice0window_centre_first_column(1 to 2) <= slice0window_centre_first_column(0 to 1);
      slice0window_tag.map_column <= slice0window_centre_map_column(2);
      slice0window_tag.first_column <= slice0window_centre_first_column(2);
    end if;
    -- slice0winner1
    for i in 0 to 11 loop
      slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
    end loop;
    slice0winner1_best_cost_0(12) <= slice0window_sum_0(24);
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    slice0winner1_best_index_0(12) <= 24;
    slice0winner1_tag <= slice0window_tag;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0window_sum_0(1),
      slice0window_sum_0(0));
    for i in 1 to 11 loop
      slice0winner1_best_cost_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0window_sum_0(2 * i + 1),
        slice0window_sum_0(2 * i));
      slice0winner1_best_index_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice0winner2
    for i in 0 to 5 loop
      slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner2_best_cost_0(6) <= slice0winner1_best_cost_0(12);
    slice0winner2_best_index_0(6) <= slice0winner1_best_index_0(12);
    slice0winner2_tag <= slice0winner1_tag;
    slice0winner2_best_cost_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice0winner2_best_cost_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_cost_0(2 * i +
        1), slice0winner1_best_cost_0(2 * i));
      slice0winner2_best_index_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_index_0(2 * i +
        1), slice0winner1_best_index_0(2 * i));
    end loop;
    -- slice0winner3
    for i in 0 to 2 loop
      slice0winner3_best_cost_0_is_less(i) := (slice0winner2_best_cost_0(2 * i + 1) - slice0winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner3_best_cost_0(3) <= slice0winner2_best_cost_0(6);
    slice0winner3_best_index_0(3) <= slice0winner2_best_index_0(6);
    slice0winner3_tag <= slice0winner2_tag;
    for i in 0 to 2 loop
      slice0winner3_best_cost_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_cost_0(2 * i +
        1), slice0winner2_best_cost_0(2 * i));
      slice0winner3_best_index_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_index_0(2 * i +
        1), slice0winner2_best_index_0(2 * i));
    end loop;
    -- slice0winner4
    slice0winner4_best_cost_0_is_less(0) := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
    slice0winner4_best_cost_0_is_less(1) := (slice0winner3_best_cost_0(3) - slice0winner3_best_cost_0(2)) < 0;
    slice0winner4_tag <= slice0winner3_tag;
    for i in 0 to 1 loop
      slice0winner4_best_cost_0(i) <= choice(slice0winner4_best_cost_0_is_less(i), slice0winner3_best_cost_0(2 * i +
        1), slice0winner3_best_cost_0(2 * i));
      slice0winner4_best_index_0(i) <= choice(slice0winner4_best_cost_0_is_less(i), slice0winner3_best_index_0(2 * i +
        1), slice0winner3_best_index_0(2 * i));
    end loop;
    -- slice0winner5
    slice0winner5_best_cost_0_0_is_less := (slice0winner4_best_cost_0(1) - slice0winner4_best_cost_0(0)) < 0;
    slice0winner5_tag <= slice0winner4_tag;
    slice0winner5_best_cost_0_0 <= choice(slice0winner5_best_cost_0_0_is_less, slice0winner4_best_cost_0(1),
      slice0winner4_best_cost_0(0));
    slice0winner5_best_index_0_0 <= choice(slice0winner5_best_cost_0_0_is_less, slice0winner4_best_index_0(1),
      slice0winner4_best_index_0(0));
    -- slice0
    slice0_best_cost_0_0 <= slice0winner5_best_cost_0_0;
    slice0_best_index_0_0 <= slice0winner5_best_index_0_0 + 15;
    slice0_best_tag <= slice0winner5_tag;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 13 loop slice1shift_search(i, j) <= slice1shift_search(i, j + 1); end loop;
        slice1shift_search(i, 14) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    -- slice1cost
    for i in 0 to 6 loop
      slice1cost_column_0_choice(2 * i, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) mod 2048);
      slice1cost_column_0_choice(2 * i, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(2 * i) +
        slice1cost_column_0_choice(2 * i, 1)) mod 2048);
      slice1cost_column_0_choice(2 * i + 1, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) /
        2048);
      slice1cost_column_0_choice(2 * i + 1, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(2 * i +
        1) + slice1cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice1cost_column_0_choice(14, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words_7);
    slice1cost_column_0_choice(14, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(14) +
      slice1cost_column_0_choice(14, 1)) mod 2048);
    for i in 0 to 14 loop
      slice1cost_pixels_first(0, i) <= slice1shift_search(0, i) - slice1shift_reference(0);
    end loop;
    for i in 0 to 14 loop
      slice1cost_pixels_first(1, i) <= slice1shift_search(1, i) - slice1shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 14 loop
        slice1cost_pixels_cost(i, j) <= (folded(slice1cost_pixels_first(i, j)) + as_number((slice1cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice1cost_read_column <= slice0cost_read_column;
    slice1cost_change_column <= slice1cost_read_column;
    for i in 0 to 14 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 6 loop slice1cost_ready_words(i) <= to_integer(slice1cost_read_words(i)); end loop;
    slice1cost_ready_words_7 <= to_integer(slice1cost_read_words_7);
    for i in 0 to 14 loop slice1cost_column_0(i) <= slice1cost_column_0_choice(i, 2); end loop;
    if slice0cost_ready_tag.valid then slice1cost_ready_column <= slice1cost_change_column; end if;
    if slice0cost_tag.valid then
      slice1cost_write_column <= slice0cost_write_column;
      for i in 0 to 6 loop
        slice1cost_write_words(i) <= (slice1cost_column_0_choice(2 * i + 1, 2) * 2048) + slice1cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice1cost_write_words(7) <= slice1cost_column_0_choice(14, 2);
    end if;
    -- slice1window
    if slice0window_entering_tag.valid then
      slice1window_ring_write_address <= slice1window_ring_read_address;
      slice1window_ring_read_address <= choice(slice1window_ring_read_address = 7, 0, (slice1window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 6 loop
      slice1window_change_0_choice(2 * i) := choice(slice0window_change_tag.leaves_window,
        to_integer(slice1window_leaving(i)(10 downto 0)), 0);
      slice1window_change_0_choice(2 * i + 1) := choice(slice0window_change_tag.leaves_window,
        to_integer(slice1window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice1window_change_0_choice(14) := choice(slice0window_change_tag.leaves_window,
      to_integer(slice1window_leaving_7), 0);
    slice1window_entering_0 <= slice1cost_column_0;
    for i in 0 to 14 loop
      slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
    end loop;
    for i in 0 to 14 loop
      slice1window_sum_0_choice(i) := choice(slice0window_centre_first_column(0), 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag.valid then
      for i in 0 to 14 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 16384;
      end loop;
    end if;
    -- slice1winner1
    for i in 0 to 6 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
    end loop;
    slice1winner1_best_cost_0(7) <= slice1window_sum_0(14);
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    slice1winner1_best_index_0(7) <= 14;
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1window_sum_0(1),
      slice1window_sum_0(0));
    for i in 1 to 6 loop
      slice1winner1_best_cost_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1window_sum_0(2 * i + 1),
        slice1window_sum_0(2 * i));
      slice1winner1_best_index_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice1winner2
    for i in 0 to 3 loop
      slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner2_best_cost_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_cost_0(1),
      slice1winner1_best_cost_0(0));
    slice1winner2_best_index_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_index_0(1),
      as_number(slice1winner1_best_index_0_0));
    for i in 1 to 3 loop
      slice1winner2_best_cost_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_cost_0(2 * i +
        1), slice1winner1_best_cost_0(2 * i));
      slice1winner2_best_index_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_index_0(2 * i +
        1), slice1winner1_best_index_0(2 * i));
    end loop;
    -- slice1winner3
    slice1winner3_best_cost_0_is_less(0) := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
    slice1winner3_best_cost_0_is_less(1) := (slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) < 0;
    for i in 0 to 1 loop
      slice1winner3_best_cost_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_cost_0(2 * i +
        1), slice1winner2_best_cost_0(2 * i));
      slice1winner3_best_index_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_index_0(2 * i +
        1), slice1winner2_best_index_0(2 * i));
    end loop;
    -- slice1winner4
    slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
    slice1winner4_best_cost_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_cost_0(1),
      slice1winner3_best_cost_0(0));
    slice1winner4_best_index_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_index_0(1),
      slice1winner3_best_index_0(0));
    -- slice1winner5
    slice1winner5_best_cost_0_0 <= slice1winner4_best_cost_0_0;
    slice1winner5_best_index_0_0 <= slice1winner4_best_index_0_0;
    -- slice1
    slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner5_best_cost_0_0) < 0;
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_cost_0_0, slice1winner5_best_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_index_0_0, slice1winner5_best_index_0_0);
    -- best
    best_base_any := (not best_waiting_tag.valid) or (not best_waiting_tag.first_column);
    best_base_is_equal := best_pass = 4;
    best_base_choices(1) := choice(best_base_is_equal, 0, ((best_base / 8) + 5) mod 32);
    best_base_choices(2) := choice(best_base_any, best_base / 8, best_base_choices(1));
    best_write_column_choices(1) := choice(best_compared_tag.first_column, 0, (best_place_column + 1) mod 1024);
    best_write_column_choices(2) := choice(best_compared_tag.valid, best_write_column_choices(1), best_place_column);
    best_read_cost_0_0 <= slice1_best_cost_0_0;
    best_read_index_0_0 <= slice1_best_index_0_0;
    best_read_tag <= slice1_best_tag;
    best_waiting_cost_0_0 <= best_read_cost_0_0;
    best_waiting_index_0_0 <= best_read_index_0_0;
    best_waiting_tag <= best_read_tag;
    best_ready_cost_0_0 <= best_waiting_cost_0_0;
    best_ready_index_0_0 <= best_waiting_index_0_0;
    best_ready_tag <= best_waiting_tag;
    best_ready_words_0 <= to_integer(best_read_words_0);
    best_base <= best_base_choices(2) * 8;
    best_compared_cost_0_0 <= best_ready_cost_0_0;
    best_compared_index_0_0 <= ((((best_base / 8) + (best_ready_index_0_0 / 8)) mod 32) * 8) + (best_ready_index_0_0
      mod 8);
    best_compared_tag <= best_ready_tag;
    best_compared_words_0 <= best_ready_words_0;
    best_last_pass <= best_base_is_equal;
    best_here_wins <= ((best_ready_cost_0_0 - (best_ready_words_0 mod 16384)) < 0) or (best_pass = 0);
    best_best_tag.valid <= best_compared_tag.valid;
    best_best_tag.map_column <= best_last_pass and best_compared_tag.map_column;
    best_best_tag.first_column <= best_last_pass and best_compared_tag.first_column;
    best_best_cost_0_0 <= choice(best_here_wins, best_compared_cost_0_0, best_compared_words_0 mod 16384);
    best_best_index_0_0 <= choice(best_here_wins, best_compared_index_0_0, best_compared_words_0 / 16384);
    best_write_column <= choice((not best_compared_tag.map_column) or (not best_compared_tag.valid), 1023,
      best_write_column_choices(2));
    if slice1_best_tag.valid then
      best_column <= choice(slice1_best_tag.first_column, 0, (best_column + 1) mod 1024);
    end if;
    if not best_base_any then best_pass <= choice(best_base_is_equal, 0, (best_pass + 1) mod 8); end if;
    if best_compared_tag.valid then best_place_column <= best_write_column_choices(1); end if;
    -- winners
    winners_row_differs := winners_row /= best_best_tag.first_column;
    if best_best_tag.valid then
      winners_row <= choice(best_best_tag.map_column, winners_row_differs, winners_row);
    end if;
    winners_column_choice := choice(best_best_tag.first_column, 0, winners_column);
    winners_column_any := (not best_best_tag.valid) or (not best_best_tag.map_column);
    if not winners_column_any then winners_column <= (winners_column_choice + 1) mod 1024; end if;
    winners_write_word_0 <= best_best_index_0_0;
    winners_read_tag.valid <= passes_arrived;
    winners_read_tag.output_column <= ((passes_write_address mod 1024) < 440) and passes_leaving_output;
    winners_read_tag.start_of_frame <= ((passes_write_address mod 1024) = 0) and passes_leaving_starts;
    winners_read_tag.end_of_line <= (passes_write_address mod 1024) = 439;
    winners_winners_disparity_0 <= to_integer(winners_read_word_0);
    winners_winners_tag <= winners_read_tag;
    winners_write_address <= choice(winners_column_any, 2047, winners_column_choice + (as_number(winners_row_differs) *
      1024));
    if reset = '1' then
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 483; delay_column <= 0;
      delay_tag.valid <= false; delay_tag.row_start <= false; delay_tag.output_column <= false;
      delay_tag.start_of_frame <= false; rows_read_column <= 0; rows_read_tag.valid <= false;
      rows_read_tag.row_start <= false; rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false;
      rows_ready_column <= 0; rows_ready_tag.valid <= false; rows_ready_tag.row_start <= false;
      rows_ready_tag.output_column <= false; rows_ready_tag.start_of_frame <= false; rows_write_column <= 0;
      rows_tag.valid <= false; rows_tag.row_start <= false; rows_tag.output_column <= false;
      rows_tag.start_of_frame <= false; passes_row <= false; passes_coming_output <= false;
      passes_coming_starts <= false; passes_row_ended <= false; passes_ended_last <= false; passes_arrived <= false;
      passes_write_address <= 0; passes_shows <= false; passes_showing_output <= false; passes_showing_starts <= false;
      passes_pass <= 0; passes_column <= 0; passes_pass_ends <= false; passes_last_pass <= false;
      passes_search_start <= 40; passes_search_address <= 0; passes_reference_address <= 985;
      passes_leaving_output <= false; passes_leaving_starts <= false; passes_read_tag.valid <= false;
      passes_read_tag.row_start <= false; passes_read_tag.first_cost <= false; passes_read_tag.map_column <= false;
      passes_read_tag.end_of_line <= false; passes_tag.valid <= false; passes_tag.row_start <= false;
      passes_tag.first_cost <= false; passes_tag.map_column <= false; slice0shift_tag.valid <= false;
      slice0shift_tag.row_start <= false; slice0shift_tag.first_cost <= false; slice0shift_tag.map_column <= false;
      slice0cost_pixels_first_tag.valid <= false; slice0cost_pixels_first_tag.row_start <= false;
      slice0cost_pixels_first_tag.first_cost <= false; slice0cost_pixels_first_tag.map_column <= false;
      slice0cost_pixels_tag.valid <= false; slice0cost_pixels_tag.first_cost <= false;
      slice0cost_pixels_tag.map_column <= false; slice0cost_read_column <= 0; slice0cost_change_column <= 0;
      slice0cost_ready_column <= 0; slice0cost_ready_tag.valid <= false; slice0cost_ready_tag.first_cost <= false;
      slice0cost_ready_tag.map_column <= false; slice0cost_write_column <= 0; slice0cost_tag.valid <= false;
      slice0cost_tag.first_cost <= false; slice0cost_tag.map_column <= false; slice0window_ring_read_address <= 1;
      slice0window_ring_write_address <= 0; slice0window_entering_tag.valid <= false;
      slice0window_entering_tag.first_cost <= false; slice0window_entering_tag.map_column <= false;
      slice0window_change_tag.valid <= false; slice0window_change_tag.first_cost <= false;
      slice0window_change_tag.map_column <= false; slice0window_centre_map_column <= (others => false);
      slice0window_centre_first_column <= (others => false); slice0window_tag <= (others => false);
      slice0winner1_tag <= (others => false); slice0winner2_tag <= (others => false);
      slice0winner3_tag <= (others => false); slice0winner4_tag <= (others => false);
      slice0winner5_tag <= (others => false); slice0_best_tag <= (others => false); slice1cost_read_column <= 0;
      slice1cost_change_column <= 0; slice1cost_ready_column <= 0; slice1cost_write_column <= 0;
      slice1window_ring_read_address <= 1; slice1window_ring_write_address <= 0; slice1_best_tag <= (others => false);
      best_read_tag <= (others => false); best_column <= 0; best_waiting_tag <= (others => false);
      best_ready_tag <= (others => false); best_pass <= 4; best_compared_tag <= (others => false);
      best_last_pass <= false; best_best_tag <= (others => false); best_place_column <= 0; best_write_column <= 0;
      winners_row <= true; winners_column <= 0; winners_write_address <= 0; winners_read_tag <= (others => false);
      winners_winners_tag <= (others => false);
    end if;
  end process;
end architecture;
