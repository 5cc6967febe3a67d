-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration yi_270: 270x270, 34 disparities, window 9x9, 1 pixel pair a clock.
-- Options: disparities 34, window_px 9, aggregation recursive, slice_disparities 17.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config yi_270
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_yi_270 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 270;
    height_px : positive := 270;
    disparities : positive := 34;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 236;
    latency_clocks : positive := 20;
    flush_groups : positive := 1083;
    gap_groups : positive := 1080
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
  assert width_px = 270 report "stereo_core_yi_270: width_px is " & integer'image(width_px) & " but this core has 270" severity failure;
  assert height_px = 270 report "stereo_core_yi_270: height_px is " & integer'image(height_px) & " but this core has 270" severity failure;
  assert disparities = 34 report "stereo_core_yi_270: disparities is " & integer'image(disparities) & " but this core has 34" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_yi_270: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_yi_270: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 236 report "stereo_core_yi_270: output_width_px is " & integer'image(output_width_px) & " but this core has 236" severity failure;
  assert latency_clocks = 20 report "stereo_core_yi_270: latency_clocks is " & integer'image(latency_clocks) & " but this core has 20" severity failure;
  assert flush_groups = 1083 report "stereo_core_yi_270: flush_groups is " & integer'image(flush_groups) & " but this core has 1083" severity failure;
  assert gap_groups = 1080 report "stereo_core_yi_270: gap_groups is " & integer'image(gap_groups) & " but this core has 1080" severity failure;
end entity;

architecture rtl of stereo_core_yi_270 is
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

  function choice(test : boolean; yes : integer; no : integer) return integer is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

  type boolean_1d is array (natural range <>) of boolean;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type integer_minus_255_to_255_2d is array (natural range <>, natural range <>) of integer range -255 to 255;
  type integer_minus_4095_to_4095_1d is array (natural range <>) of integer range -4095 to 4095;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_16_1d is array (natural range <>) of natural range 0 to 16;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_4095_2d is array (natural range <>, natural range <>) of natural range 0 to 4095;
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type tag_9 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame : boolean;
    end_of_line : boolean;
  end record;
  type tag_8 is record
    valid, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_6 is record
    valid, first_cost, leaves_window, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_start_of_frame, in_valid : boolean;
  signal in_left_pixel, in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 255;
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 63;
  signal delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag : tag_9;
  -- rows
  signal rows_search_rows_read_words, rows_search_rows_ready_words, rows_search_rows_write_words,
    rows_reference_rows_read_words, rows_reference_rows_ready_words,
    rows_reference_rows_write_words : unsigned_32_1d(0 to 1);
  signal rows_search_rows_read_words_2, rows_reference_rows_read_words_2 : unsigned(7 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_words_2, rows_search_rows_ready_newest_0,
    rows_search_rows_write_words_2, rows_reference_rows_read_newest_0, rows_reference_rows_ready_words_2,
    rows_reference_rows_ready_newest_0, rows_reference_rows_write_words_2 : natural range 0 to 255;
  signal rows_search, rows_reference : natural_255_1d(0 to 1);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag : tag_9;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag, rows_tag : tag_9;
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 1, 0 to 16);
  signal slice0shift_reference, slice0shift_search_out : natural_255_1d(0 to 1);
  signal slice0shift_tag : tag_9;
  -- slice0cost
  signal slice0cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 16);
  signal slice0cost_change_0 : integer_minus_255_to_255_1d(0 to 16);
  signal slice0cost_pixels_first_tag : tag_9;
  signal slice0cost_pixels_tag, slice0cost_ready_tag, slice0cost_tag : tag_8;
  signal slice0cost_pixels_cost : natural_255_2d(0 to 1, 0 to 16);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column,
    slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words : unsigned_24_1d(0 to 7);
  signal slice0cost_read_words_8 : unsigned(11 downto 0);
  signal slice0cost_ready_words : natural_16777215_1d(0 to 7);
  signal slice0cost_write_words : natural_16777215_1d(0 to 8);  -- _# up to 16777215 x 8, 4095
  signal slice0cost_ready_words_8 : natural range 0 to 4095;
  signal slice0cost_column_0 : natural_4095_1d(0 to 16);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving : unsigned_24_1d(0 to 7);
  signal slice0window_leaving_8 : unsigned(11 downto 0);
  signal slice0window_entering_0 : natural_4095_1d(0 to 16);
  signal slice0window_entering_tag, slice0window_change_tag : tag_6;
  signal slice0window_centre_output_column_0, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_start_of_frame : boolean_1d(0 to 1);
  signal slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_4;
  signal slice0window_change_0 : integer_minus_4095_to_4095_1d(0 to 16);
  signal slice0window_sum_0 : natural_32767_1d(0 to 16);
  -- slice0winner1
  signal slice0winner1_best_cost_0 : natural_32767_1d(0 to 8);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_tag : tag_4;
  signal slice0winner1_best_index_0 : natural_16_1d(1 to 8);  -- _# up to 3, 5 .. 15, 16
  -- slice0winner2
  signal slice0winner2_best_cost_0 : natural_32767_1d(0 to 4);
  signal slice0winner2_best_index_0 : natural_16_1d(0 to 4);  -- _# up to 3, 7 .. 15, 16
  signal slice0winner2_tag : tag_4;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_32767_1d(0 to 2);
  signal slice0winner3_best_index_0 : natural_16_1d(0 to 2);  -- _# up to 7, 15, 16
  signal slice0winner3_tag : tag_4;
  -- slice0winner4
  signal slice0winner4_best_cost_0 : natural_32767_1d(0 to 1);
  signal slice0winner4_best_index_0 : natural_16_1d(0 to 1);  -- _# up to 15, 16
  signal slice0winner4_tag : tag_4;
  -- slice0winner5
  signal slice0winner5_best_cost_0_0 : natural range 0 to 32767;
  signal slice0winner5_best_index_0_0 : natural range 0 to 16;
  signal slice0winner5_tag : tag_4;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 32767;
  signal slice0_best_index_0_0 : natural range 0 to 33;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_255_2d(0 to 1, 0 to 16);
  signal slice1shift_reference : natural_255_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 16);
  signal slice1cost_change_0 : integer_minus_255_to_255_1d(0 to 16);
  signal slice1cost_pixels_cost : natural_255_2d(0 to 1, 0 to 16);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column,
    slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words : unsigned_24_1d(0 to 7);
  signal slice1cost_read_words_8 : unsigned(11 downto 0);
  signal slice1cost_ready_words : natural_16777215_1d(0 to 7);
  signal slice1cost_write_words : natural_16777215_1d(0 to 8);  -- _# up to 16777215 x 8, 4095
  signal slice1cost_ready_words_8 : natural range 0 to 4095;
  signal slice1cost_column_0 : natural_4095_1d(0 to 16);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving : unsigned_24_1d(0 to 7);
  signal slice1window_leaving_8 : unsigned(11 downto 0);
  signal slice1window_entering_0 : natural_4095_1d(0 to 16);
  signal slice1window_change_0 : integer_minus_4095_to_4095_1d(0 to 16);
  signal slice1window_sum_0 : natural_32767_1d(0 to 16);
  signal slice1window_centre_output_column : boolean_1d(0 to 2);
  signal slice1window_centre_start_of_frame : boolean_1d(1 to 2);
  signal slice1window_centre_end_of_line : boolean_1d(0 to 2);
  -- slice1winner1
  signal slice1winner1_best_cost_0 : natural_32767_1d(0 to 8);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_32767_1d(0 to 4);
  signal slice1winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_32767_1d(0 to 2);
  signal slice1winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  -- slice1winner4
  signal slice1winner4_best_cost_0 : natural_32767_1d(0 to 1);
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  -- slice1winner5
  signal slice1winner5_best_cost_0_0 : natural range 0 to 32767;
  signal slice1winner5_best_index_0_0 : natural range 0 to 16;
  -- slice1
  signal slice1_best_index_0_0 : natural range 0 to 33;
  signal slice1_best_tag : tag_4;

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice1_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice1_best_tag.valid and slice1_best_tag.output_column);
  disparity_start_of_frame <= as_bit(slice1_best_tag.start_of_frame and slice1_best_tag.valid and slice1_best_tag.output_column);
  disparity_end_of_line <= as_bit(slice1_best_tag.end_of_line and slice1_best_tag.valid and slice1_best_tag.output_column);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  slice1window_leaving_8_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 4);
    write_address <= to_unsigned(slice1window_ring_write_address, 4);
    write_data <= to_unsigned(slice1cost_column_0(16), 12);
    cell : entity work.line_memory generic map (10, 12, 4)
      port map (clock, true, read_address, slice1window_leaving_8, write_address, write_data);
  end block;

  slice1window_leaving_memory : for i in 7 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 4);
    write_address <= to_unsigned(slice1window_ring_write_address, 4);
    write_data <= to_unsigned(slice1cost_column_0(2 * i + 1), 12) & to_unsigned(slice1cost_column_0(2 * i), 12);
    cell : entity work.line_memory generic map (10, 24, 4)
      port map (clock, true, read_address, slice1window_leaving(i), write_address, write_data);
  end generate;

  slice1cost_read_words_8_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 9);
    write_address <= to_unsigned(slice1cost_write_column, 9);
    write_data <= to_unsigned(slice1cost_write_words(8), 12);
    cell : entity work.line_memory generic map (270, 12, 9)
      port map (clock, true, read_address, slice1cost_read_words_8, write_address, write_data);
  end block;

  slice1cost_read_words_memory : for i in 7 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 9);
    write_address <= to_unsigned(slice1cost_write_column, 9);
    write_data <= to_unsigned(slice1cost_write_words(i), 24);
    cell : entity work.line_memory generic map (270, 24, 9)
      port map (clock, true, read_address, slice1cost_read_words(i), write_address, write_data);
  end generate;

  slice0window_leaving_8_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 4);
    write_address <= to_unsigned(slice0window_ring_write_address, 4);
    write_data <= to_unsigned(slice0cost_column_0(16), 12);
    cell : entity work.line_memory generic map (10, 12, 4)
      port map (clock, true, read_address, slice0window_leaving_8, write_address, write_data);
  end block;

  slice0window_leaving_memory : for i in 7 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 4);
    write_address <= to_unsigned(slice0window_ring_write_address, 4);
    write_data <= to_unsigned(slice0cost_column_0(2 * i + 1), 12) & to_unsigned(slice0cost_column_0(2 * i), 12);
    cell : entity work.line_memory generic map (10, 24, 4)
      port map (clock, true, read_address, slice0window_leaving(i), write_address, write_data);
  end generate;

  slice0cost_read_words_8_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    write_data <= to_unsigned(slice0cost_write_words(8), 12);
    cell : entity work.line_memory generic map (270, 12, 9)
      port map (clock, true, read_address, slice0cost_read_words_8, write_address, write_data);
  end block;

  slice0cost_read_words_memory : for i in 7 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    write_data <= to_unsigned(slice0cost_write_words(i), 24);
    cell : entity work.line_memory generic map (270, 24, 9)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, write_data);
  end generate;

  rows_search_rows_read_words_2_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words_2, 8);
    cell : entity work.line_memory generic map (270, 8, 9)
      port map (clock, true, read_address, rows_search_rows_read_words_2, write_address, write_data);
  end block;

  rows_search_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    cell : entity work.line_memory generic map (270, 32, 9)
      port map (clock, true, read_address, rows_search_rows_read_words(i), write_address,
        rows_search_rows_write_words(i));
  end generate;

  rows_reference_rows_read_words_2_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words_2, 8);
    cell : entity work.line_memory generic map (270, 8, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words_2, write_address, write_data);
  end block;

  rows_reference_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    cell : entity work.line_memory generic map (270, 32, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words(i), write_address,
        rows_reference_rows_write_words(i));
  end generate;

  delay_delayed_0_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 6);
    write_address <= to_unsigned(delay_ring_write_address, 6);
    write_data <= to_unsigned(raster_features_reference_0, 8);
    cell : entity work.line_memory generic map (34, 8, 6)
      port map (clock, true, read_address, delay_delayed_0, write_address, write_data);
  end block;

  process
    variable raster_place_group_is_equal, delay_tag_first_cost_is_equal, slice0winner4_best_cost_0_0_is_less,
      slice0winner5_best_cost_0_0_is_less, slice1winner4_best_cost_0_0_is_less,
      slice1winner5_best_cost_0_0_is_less : boolean;
    variable slice0cost_column_0_choice, slice1cost_column_0_choice : natural_4095_2d(0 to 16, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice, slice1window_change_0_choice : natural_4095_1d(0 to 16);  -- _#_choice
    variable slice0window_sum_0_choice, slice1window_sum_0_choice : natural_32767_1d(0 to 16);  -- _#_choice
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less, slice1winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable slice0winner3_best_cost_0_is_less, slice1winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
  begin
    wait until rising_edge(clock);
    -- raster
    raster_place_group_is_equal := raster_place_column = 269;
    raster_features_search_0 <= in_left_pixel;
    raster_features_reference_0 <= in_right_pixel;
    raster_features_valid <= in_valid;
    raster_place_group <= choice(in_start_of_frame and in_valid, 0, (raster_place_group +
      as_number(((raster_place_group /= 274) and raster_place_group_is_equal and in_valid))) mod 512);
    if in_valid then
      raster_place_column <= choice(raster_place_group_is_equal or in_start_of_frame, 0, (raster_place_column + 1) mod
        512);
    end if;
    -- delay
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 33, 0, (delay_ring_read_address + 1) mod 64);
    end if;
    delay_tag_first_cost_is_equal := raster_place_column = 33;
    delay_ahead_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 279);
    delay_row_inside(1) <= raster_place_group < 270;
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= raster_place_column = 0;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.border_column <= raster_place_column < 33;
    delay_tag.first_cost <= delay_tag_first_cost_is_equal;
    delay_tag.leaves_window <= (((((raster_place_column / 2) + 32747) mod 32768) * 2) + (raster_place_column mod 2)) <
      65498;
    delay_tag.output_column <= ((((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) <
      270) and (raster_place_column >= 33) and (raster_place_column < 269);
    delay_tag.start_of_frame <= (raster_place_group = 4) and delay_tag_first_cost_is_equal;
    delay_tag.end_of_line <= raster_place_column = 268;
    -- rows
    rows_search_rows_read_newest_0 <= delay_ahead_0;
    rows_search_rows_ready_words <= rows_search_rows_read_words;
    rows_search_rows_ready_words_2 <= to_integer(rows_search_rows_read_words_2);
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
    rows_reference_rows_ready_words <= rows_reference_rows_read_words;
    rows_reference_rows_ready_words_2 <= to_integer(rows_reference_rows_read_words_2);
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_tag <= rows_ready_tag;
    rows_search(0) <= choice(rows_ready_inside(0), to_integer(rows_search_rows_ready_words(0)(7 downto 0)), 0);
    rows_reference(0) <= choice(rows_ready_inside(0), to_integer(rows_reference_rows_ready_words(0)(7 downto 0)), 0);
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_newest_0, 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words(0) <= rows_search_rows_ready_words(1)(7 downto 0) &
        rows_search_rows_ready_words(0)(31 downto 8);
      rows_search_rows_write_words(1) <= to_unsigned(rows_search_rows_ready_words_2, 8) &
        rows_search_rows_ready_words(1)(31 downto 8);
      rows_search_rows_write_words_2 <= rows_search_rows_ready_newest_0;
      rows_reference_rows_write_words(0) <= rows_reference_rows_ready_words(1)(7 downto 0) &
        rows_reference_rows_ready_words(0)(31 downto 8);
      rows_reference_rows_write_words(1) <= to_unsigned(rows_reference_rows_ready_words_2, 8) &
        rows_reference_rows_ready_words(1)(31 downto 8);
      rows_reference_rows_write_words_2 <= rows_reference_rows_ready_newest_0;
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 15 loop slice0shift_search(i, j) <= slice0shift_search(i, j + 1); end loop;
        slice0shift_search(i, 16) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 0);
    slice0shift_search_out(1) <= slice0shift_search(1, 0);
    slice0shift_tag <= rows_tag;
    -- slice0cost
    for i in 0 to 7 loop
      slice0cost_column_0_choice(2 * i, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i) mod
        4096);
      slice0cost_column_0_choice(2 * i, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(2 * i)
        + slice0cost_column_0_choice(2 * i, 1)) mod 4096);
      slice0cost_column_0_choice(2 * i + 1, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i)
        / 4096);
      slice0cost_column_0_choice(2 * i + 1, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(2
        * i + 1) + slice0cost_column_0_choice(2 * i + 1, 1)) mod 4096);
    end loop;
    slice0cost_column_0_choice(16, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words_8);
    slice0cost_column_0_choice(16, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(16) +
      slice0cost_column_0_choice(16, 1)) mod 4096);
    for i in 0 to 16 loop
      slice0cost_pixels_first(0, i) <= slice0shift_search(0, i) - slice0shift_reference(0);
    end loop;
    for i in 0 to 16 loop
      slice0cost_pixels_first(1, i) <= slice0shift_search(1, i) - slice0shift_reference(1);
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 1 loop
      for j in 0 to 16 loop
        slice0cost_pixels_cost(i, j) <= (folded(slice0cost_pixels_first(i, j)) + as_number((slice0cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice0cost_pixels_tag.valid <= slice0cost_pixels_first_tag.valid;
    slice0cost_pixels_tag.first_group <= slice0cost_pixels_first_tag.first_group;
    slice0cost_pixels_tag.border_column <= slice0cost_pixels_first_tag.border_column;
    slice0cost_pixels_tag.first_cost <= slice0cost_pixels_first_tag.first_cost;
    slice0cost_pixels_tag.leaves_window <= slice0cost_pixels_first_tag.leaves_window;
    slice0cost_pixels_tag.output_column <= slice0cost_pixels_first_tag.output_column;
    slice0cost_pixels_tag.start_of_frame <= slice0cost_pixels_first_tag.start_of_frame;
    slice0cost_pixels_tag.end_of_line <= slice0cost_pixels_first_tag.end_of_line;
    for i in 0 to 16 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 7 loop slice0cost_ready_words(i) <= to_integer(slice0cost_read_words(i)); end loop;
    slice0cost_ready_words_8 <= to_integer(slice0cost_read_words_8);
    slice0cost_ready_column <= slice0cost_change_column;
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    for i in 0 to 16 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
    slice0cost_write_column <= slice0cost_ready_column;
    slice0cost_tag <= slice0cost_ready_tag;
    if slice0shift_tag.valid then
      slice0cost_read_column <= choice(slice0shift_tag.row_start, 0, (slice0cost_read_column + 1) mod 512);
    end if;
    if slice0cost_pixels_first_tag.valid then
      slice0cost_change_column <= choice(slice0cost_pixels_first_tag.row_start, 0, (slice0cost_change_column + 1) mod
        512);
    end if;
    if slice0cost_ready_tag.valid then
      for i in 0 to 7 loop
        slice0cost_write_words(i) <= (slice0cost_column_0_choice(2 * i + 1, 2) * 4096) + slice0cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice0cost_write_words(8) <= slice0cost_column_0_choice(16, 2);
    end if;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_ring_write_address <= slice0window_ring_read_address;
      slice0window_ring_read_address <= choice(slice0window_ring_read_address = 9, 0, (slice0window_ring_read_address +
        1) mod 16);
    end if;
    for i in 0 to 7 loop
      slice0window_change_0_choice(2 * i) := choice(slice0window_entering_tag.leaves_window,
        to_integer(slice0window_leaving(i)(11 downto 0)), 0);
      slice0window_change_0_choice(2 * i + 1) := choice(slice0window_entering_tag.leaves_window,
        to_integer(slice0window_leaving(i)(23 downto 12)), 0);
    end loop;
    slice0window_change_0_choice(16) := choice(slice0window_entering_tag.leaves_window,
      to_integer(slice0window_leaving_8), 0);
    slice0window_entering_0 <= slice0cost_column_0;
    slice0window_entering_tag.valid <= slice0cost_tag.valid;
    slice0window_entering_tag.first_cost <= slice0cost_tag.first_cost;
    slice0window_entering_tag.leaves_window <= slice0cost_tag.leaves_window;
    slice0window_entering_tag.output_column <= slice0cost_tag.output_column;
    slice0window_entering_tag.start_of_frame <= slice0cost_tag.start_of_frame;
    slice0window_entering_tag.end_of_line <= slice0cost_tag.end_of_line;
    for i in 0 to 16 loop
      slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
    end loop;
    slice0window_change_tag <= slice0window_entering_tag;
    slice0window_centre_output_column_0 <= slice0window_change_tag.output_column;
    slice0window_centre_first_column_0 <= slice0window_change_tag.first_cost;
    slice0window_centre_start_of_frame(0) <= slice0window_change_tag.start_of_frame;
    slice0window_centre_end_of_line_0 <= slice0window_change_tag.end_of_line;
    slice0window_tag.valid <= slice0window_change_tag.valid;
    for i in 0 to 16 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 16 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 32768;
      end loop;
    end if;
    if slice0window_tag.valid then
      slice0window_centre_start_of_frame(1) <= slice0window_centre_start_of_frame(0);
      slice0window_tag.output_column <= slice1window_centre_output_column(2);
      slice0window_tag.start_of_frame <= slice1window_centre_start_of_frame(2);
      slice0window_tag.end_of_line <= slice1window_centre_end_of_line(2);
    end if;
    -- slice0winner1
    for i in 0 to 7 loop
      slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
    end loop;
    slice0winner1_best_cost_0(8) <= slice0window_sum_0(16);
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    slice0winner1_best_index_0(8) <= 16;
    slice0winner1_tag <= slice0window_tag;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0window_sum_0(1),
      slice0window_sum_0(0));
    for i in 1 to 7 loop
      slice0winner1_best_cost_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0window_sum_0(2 * i + 1),
        slice0window_sum_0(2 * i));
      slice0winner1_best_index_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice0winner2
    for i in 0 to 3 loop
      slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner2_best_cost_0(4) <= slice0winner1_best_cost_0(8);
    slice0winner2_best_index_0(4) <= slice0winner1_best_index_0(8);
    slice0winner2_tag <= slice0winner1_tag;
    slice0winner2_best_cost_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    for i in 1 to 3 loop
      slice0winner2_best_cost_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_cost_0(2 * i +
        1), slice0winner1_best_cost_0(2 * i));
      slice0winner2_best_index_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_index_0(2 * i +
        1), slice0winner1_best_index_0(2 * i));
    end loop;
    -- slice0winner3
    slice0winner3_best_cost_0_is_less(0) := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
    slice0winner3_best_cost_0_is_less(1) := (slice0winner2_best_cost_0(3) - slice0winner2_best_cost_0(2)) < 0;
    slice0winner3_best_cost_0(2) <= slice0winner2_best_cost_0(4);
    slice0winner3_best_index_0(2) <= slice0winner2_best_index_0(4);
    slice0winner3_tag <= slice0winner2_tag;
    for i in 0 to 1 loop
      slice0winner3_best_cost_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_cost_0(2 * i +
        1), slice0winner2_best_cost_0(2 * i));
      slice0winner3_best_index_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_index_0(2 * i +
        1), slice0winner2_best_index_0(2 * i));
    end loop;
    -- slice0winner4
    slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
    slice0winner4_best_cost_0(1) <= slice0winner3_best_cost_0(2);
    slice0winner4_best_index_0(1) <= slice0winner3_best_index_0(2);
    slice0winner4_tag <= slice0winner3_tag;
    slice0winner4_best_cost_0(0) <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_cost_0(1),
      slice0winner3_best_cost_0(0));
    slice0winner4_best_index_0(0) <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_index_0(1),
      slice0winner3_best_index_0(0));
    -- slice0winner5
    slice0winner5_best_cost_0_0_is_less := (slice0winner4_best_cost_0(1) - slice0winner4_best_cost_0(0)) < 0;
    slice0winner5_tag <= slice0winner4_tag;
    slice0winner5_best_cost_0_0 <= choice(slice0winner5_best_cost_0_0_is_less, slice0winner4_best_cost_0(1),
      slice0winner4_best_cost_0(0));
    slice0winner5_best_index_0_0 <= choice(slice0winner5_best_cost_0_0_is_less, slice0winner4_best_index_0(1),
      slice0winner4_best_index_0(0));
    -- slice0
    slice0_best_cost_0_0 <= slice0winner5_best_cost_0_0;
    slice0_best_index_0_0 <= slice0winner5_best_index_0_0 + 17;
    slice0_best_tag <= slice0winner5_tag;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 15 loop slice1shift_search(i, j) <= slice1shift_search(i, j + 1); end loop;
        slice1shift_search(i, 16) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    -- slice1cost
    for i in 0 to 7 loop
      slice1cost_column_0_choice(2 * i, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) mod 4096);
      slice1cost_column_0_choice(2 * i, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(2 * i) +
        slice1cost_column_0_choice(2 * i, 1)) mod 4096);
      slice1cost_column_0_choice(2 * i + 1, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) /
        4096);
      slice1cost_column_0_choice(2 * i + 1, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(2 * i +
        1) + slice1cost_column_0_choice(2 * i + 1, 1)) mod 4096);
    end loop;
    slice1cost_column_0_choice(16, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words_8);
    slice1cost_column_0_choice(16, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(16) +
      slice1cost_column_0_choice(16, 1)) mod 4096);
    for i in 0 to 16 loop
      slice1cost_pixels_first(0, i) <= slice1shift_search(0, i) - slice1shift_reference(0);
    end loop;
    for i in 0 to 16 loop
      slice1cost_pixels_first(1, i) <= slice1shift_search(1, i) - slice1shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 16 loop
        slice1cost_pixels_cost(i, j) <= (folded(slice1cost_pixels_first(i, j)) + as_number((slice1cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice1cost_read_column <= slice0cost_read_column;
    slice1cost_change_column <= slice1cost_read_column;
    for i in 0 to 16 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 7 loop slice1cost_ready_words(i) <= to_integer(slice1cost_read_words(i)); end loop;
    slice1cost_ready_words_8 <= to_integer(slice1cost_read_words_8);
    for i in 0 to 16 loop slice1cost_column_0(i) <= slice1cost_column_0_choice(i, 2); end loop;
    if slice0cost_ready_tag.valid then slice1cost_ready_column <= slice1cost_change_column; end if;
    if slice0cost_tag.valid then
      slice1cost_write_column <= slice0cost_write_column;
      for i in 0 to 7 loop
        slice1cost_write_words(i) <= (slice1cost_column_0_choice(2 * i + 1, 2) * 4096) + slice1cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice1cost_write_words(8) <= slice1cost_column_0_choice(16, 2);
    end if;
    -- slice1window
    if slice0window_entering_tag.valid then
      slice1window_ring_write_address <= slice1window_ring_read_address;
      slice1window_ring_read_address <= choice(slice1window_ring_read_address = 9, 0, (slice1window_ring_read_address +
        1) mod 16);
    end if;
    for i in 0 to 7 loop
      slice1window_change_0_choice(2 * i) := choice(slice0window_change_tag.leaves_window,
        to_integer(slice1window_leaving(i)(11 downto 0)), 0);
      slice1window_change_0_choice(2 * i + 1) := choice(slice0window_change_tag.leaves_window,
        to_integer(slice1window_leaving(i)(23 downto 12)), 0);
    end loop;
    slice1window_change_0_choice(16) := choice(slice0window_change_tag.leaves_window,
      to_integer(slice1window_leaving_8), 0);
    slice1window_entering_0 <= slice1cost_column_0;
    for i in 0 to 16 loop
      slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
    end loop;
    for i in 0 to 16 loop
      slice1window_sum_0_choice(i) := choice(slice0window_centre_first_column_0, 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag.valid then
      for i in 0 to 16 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 32768;
      end loop;
      slice1window_centre_output_column(0) <= slice0window_centre_output_column_0;
      slice1window_centre_output_column(1 to 2) <= slice1window_centre_output_column(0 to 1);
      slice1window_centre_start_of_frame(1) <= slice0window_centre_start_of_frame(1);
      slice1window_centre_start_of_frame(2) <= slice1window_centre_start_of_frame(1);
      slice1window_centre_end_of_line(0) <= slice0window_centre_end_of_line_0;
      slice1window_centre_end_of_line(1 to 2) <= slice1window_centre_end_of_line(0 to 1);
    end if;
    -- slice1winner1
    for i in 0 to 7 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
    end loop;
    slice1winner1_best_cost_0(8) <= slice1window_sum_0(16);
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1window_sum_0(1),
      slice1window_sum_0(0));
    for i in 1 to 7 loop
      slice1winner1_best_cost_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1window_sum_0(2 * i + 1),
        slice1window_sum_0(2 * i));
      slice1winner1_best_index_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice1winner2
    for i in 0 to 3 loop
      slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner2_best_cost_0(4) <= slice1winner1_best_cost_0(8);
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
    slice1winner3_best_cost_0(2) <= slice1winner2_best_cost_0(4);
    for i in 0 to 1 loop
      slice1winner3_best_cost_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_cost_0(2 * i +
        1), slice1winner2_best_cost_0(2 * i));
      slice1winner3_best_index_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_index_0(2 * i +
        1), slice1winner2_best_index_0(2 * i));
    end loop;
    -- slice1winner4
    slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
    slice1winner4_best_cost_0(1) <= slice1winner3_best_cost_0(2);
    slice1winner4_best_cost_0(0) <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_cost_0(1),
      slice1winner3_best_cost_0(0));
    slice1winner4_best_index_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_index_0(1),
      slice1winner3_best_index_0(0));
    -- slice1winner5
    slice1winner5_best_cost_0_0_is_less := (slice1winner4_best_cost_0(1) - slice1winner4_best_cost_0(0)) < 0;
    slice1winner5_best_cost_0_0 <= choice(slice1winner5_best_cost_0_0_is_less, slice1winner4_best_cost_0(1),
      slice1winner4_best_cost_0(0));
    slice1winner5_best_index_0_0 <= choice(slice1winner5_best_cost_0_0_is_less, slice0winner4_best_index_0(1),
      slice1winner4_best_index_0_0);
    -- slice1
    slice1_best_tag <= slice0_best_tag;
    slice1_best_index_0_0 <= choice((slice0_best_cost_0_0 - slice1winner5_best_cost_0_0) < 0, slice0_best_index_0_0,
      slice1winner5_best_index_0_0);
    if reset = '1' then
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 274; delay_ring_read_address <= 1;
      delay_ring_write_address <= 0; delay_column <= 0; delay_tag.valid <= false; delay_tag.row_start <= false;
      delay_tag.output_column <= false; delay_tag.start_of_frame <= false; delay_tag.end_of_line <= false;
      rows_read_column <= 0; rows_read_tag.valid <= false; rows_read_tag.row_start <= false;
      rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false;
      rows_ready_column <= 0; rows_ready_tag.valid <= false; rows_ready_tag.row_start <= false;
      rows_ready_tag.output_column <= false; rows_ready_tag.start_of_frame <= false;
      rows_ready_tag.end_of_line <= false; rows_write_column <= 0; rows_tag.valid <= false; rows_tag.row_start <= false;
      rows_tag.output_column <= false; rows_tag.start_of_frame <= false; rows_tag.end_of_line <= false;
      slice0shift_tag.valid <= false; slice0shift_tag.row_start <= false; slice0shift_tag.output_column <= false;
      slice0shift_tag.start_of_frame <= false; slice0shift_tag.end_of_line <= false;
      slice0cost_pixels_first_tag.valid <= false; slice0cost_pixels_first_tag.row_start <= false;
      slice0cost_pixels_first_tag.output_column <= false; slice0cost_pixels_first_tag.start_of_frame <= false;
      slice0cost_pixels_first_tag.end_of_line <= false; slice0cost_pixels_tag.valid <= false;
      slice0cost_pixels_tag.output_column <= false; slice0cost_pixels_tag.start_of_frame <= false;
      slice0cost_pixels_tag.end_of_line <= false; slice0cost_read_column <= 0; slice0cost_change_column <= 0;
      slice0cost_ready_column <= 0; slice0cost_ready_tag.valid <= false; slice0cost_ready_tag.output_column <= false;
      slice0cost_ready_tag.start_of_frame <= false; slice0cost_ready_tag.end_of_line <= false;
      slice0cost_write_column <= 0; slice0cost_tag.valid <= false; slice0cost_tag.output_column <= false;
      slice0cost_tag.start_of_frame <= false; slice0cost_tag.end_of_line <= false; slice0window_ring_read_address <= 1;
      slice0window_ring_write_address <= 0; slice0window_entering_tag.valid <= false;
      slice0window_entering_tag.output_column <= false; slice0window_entering_tag.start_of_frame <= false;
      slice0window_entering_tag.end_of_line <= false; slice0window_change_tag.valid <= false;
      slice0window_change_tag.output_column <= false; slice0window_change_tag.start_of_frame <= false;
      slice0window_change_tag.end_of_line <= false; slice0window_centre_output_column_0 <= false;
      slice0window_centre_start_of_frame <= (others => false); slice0window_centre_end_of_line_0 <= false;
      slice0window_tag <= (others => false); slice0winner1_tag <= (others => false);
      slice0winner2_tag <= (others => false); slice0winner3_tag <= (others => false);
      slice0winner4_tag <= (others => false); slice0winner5_tag <= (others => false);
      slice0_best_tag <= (others => false); slice1cost_read_column <= 0; slice1cost_change_column <= 0;
      slice1cost_ready_column <= 0; slice1cost_write_column <= 0; slice1window_ring_read_address <= 1;
      slice1window_ring_write_address <= 0; slice1window_centre_output_column <= (others => false);
      slice1window_centre_start_of_frame <= (others => false); slice1window_centre_end_of_line <= (others => false);
      slice1_best_tag <= (others => false);
    end if;
  end process;
end architecture;
