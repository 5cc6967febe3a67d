-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration ambrosch2007: 320x240, 100 disparities, window 3x3, 1 pixel pair a clock.
-- Options: disparities 100, sign_memory true.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config ambrosch2007
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_ambrosch2007 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 240;
    disparities : positive := 100;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 220;
    latency_clocks : positive := 19;
    flush_groups : positive := 320;
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
  assert width_px = 320 report "stereo_core_ambrosch2007: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 240 report "stereo_core_ambrosch2007: height_px is " & integer'image(height_px) & " but this core has 240" severity failure;
  assert disparities = 100 report "stereo_core_ambrosch2007: disparities is " & integer'image(disparities) & " but this core has 100" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_ambrosch2007: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_ambrosch2007: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 220 report "stereo_core_ambrosch2007: output_width_px is " & integer'image(output_width_px) & " but this core has 220" severity failure;
  assert latency_clocks = 19 report "stereo_core_ambrosch2007: latency_clocks is " & integer'image(latency_clocks) & " but this core has 19" severity failure;
  assert flush_groups = 320 report "stereo_core_ambrosch2007: flush_groups is " & integer'image(flush_groups) & " but this core has 320" severity failure;
  assert gap_groups = 0 report "stereo_core_ambrosch2007: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_ambrosch2007 is
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
  type boolean_2d is array (natural range <>, natural range <>) of boolean;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type natural_1532_1d is array (natural range <>) of natural range 0 to 1532;
  type natural_2298_1d is array (natural range <>) of natural range 0 to 2298;
  type natural_23_1d is array (natural range <>) of natural range 0 to 23;
  type natural_24_1d is array (natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_255_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 255;
  type natural_33554431_1d is array (natural range <>) of natural range 0 to 33554431;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_766_1d is array (natural range <>) of natural range 0 to 766;
  type unsigned_25_1d is array (natural range <>) of unsigned(24 downto 0);
  type tag_5 is record
    valid, border_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_6 is record
    valid, newest_inside, border_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_start_of_frame, in_valid : boolean;
  signal in_left_pixel, in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0, raster_place_group : natural range 0 to 255;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 511;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 127;
  signal delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag : tag_5;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(15 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_search, rows_reference : natural_255_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : natural range 0 to 65535;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag : tag_5;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag : tag_5;
  signal rows_inside_2 : boolean;
  signal rows_tag : tag_5;
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 2, 0 to 24);
  signal slice0shift_reference, slice0shift_search_out : natural_255_1d(0 to 2);
  signal slice0shift_tag : tag_6;
  -- slice0cost
  signal slice0cost_signs_column, slice0cost_signs_next_column, slice0cost_signs_difference_column,
    slice0cost_signs_write_column : natural range 0 to 511;
  signal slice0cost_pair_0 : natural_511_1d(0 to 24);
  signal slice0cost_signs_read_words : unsigned_25_1d(0 to 1);
  signal slice0cost_signs_ready_words : natural_33554431_1d(0 to 1);
  signal slice0cost_signs_known_words_1 : natural range 0 to 33554431;
  signal slice0cost_signs_write_words : natural_33554431_1d(0 to 1);
  signal slice0cost_difference : natural_255_2d(0 to 1, 0 to 24);
  signal slice0cost_single_0 : natural_255_1d(0 to 24);
  signal slice0cost_difference_2 : integer_minus_255_to_255_1d(0 to 24);
  signal slice0cost_newest_negative_0 : boolean_1d(0 to 24);
  signal slice0cost_difference_tag, slice0cost_pair_tag, slice0cost_tag : tag_6;
  signal slice0cost_column_0 : natural_766_1d(0 to 24);
  -- slice0window
  signal slice0window_partial_0_0 : natural_766_1d(0 to 24);
  signal slice0window_partial_0_1 : natural_1532_1d(0 to 24);
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0,
    slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_4;
  signal slice0window_sum_0 : natural_2298_1d(0 to 24);
  -- slice0winner1
  signal slice0winner1_best_cost_0 : natural_2298_1d(0 to 12);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_tag : tag_4;
  signal slice0winner1_best_index_0 : natural_24_1d(1 to 12);  -- _# up to 3, 5 .. 23, 24
  -- slice0winner2
  signal slice0winner2_best_cost_0 : natural_2298_1d(0 to 6);
  signal slice0winner2_best_index_0 : natural_24_1d(0 to 6);  -- _# up to 3, 7 .. 23, 24
  signal slice0winner2_tag : tag_4;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_2298_1d(0 to 3);
  signal slice0winner3_best_index_0 : natural_24_1d(0 to 3);  -- _# up to 7, 15, 23, 24
  signal slice0winner3_tag : tag_4;
  -- slice0winner4
  signal slice0winner4_best_cost_0 : natural_2298_1d(0 to 1);
  signal slice0winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  signal slice0winner4_tag : tag_4;
  -- slice0winner5
  signal slice0winner5_best_cost_0_0 : natural range 0 to 2298;
  signal slice0winner5_best_index_0_0 : natural range 0 to 24;
  signal slice0winner5_tag : tag_4;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 2298;
  signal slice0_best_index_0_0 : natural range 0 to 99;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_255_2d(0 to 2, 0 to 24);
  signal slice1shift_reference, slice1shift_search_out : natural_255_1d(0 to 2);
  -- slice1cost
  signal slice1cost_signs_difference_column, slice1cost_signs_write_column : natural range 0 to 511;
  signal slice1cost_pair_0 : natural_511_1d(0 to 24);
  signal slice1cost_signs_read_words : unsigned_25_1d(0 to 1);
  signal slice1cost_signs_ready_words : natural_33554431_1d(0 to 1);
  signal slice1cost_signs_known_words_1 : natural range 0 to 33554431;
  signal slice1cost_signs_write_words : natural_33554431_1d(0 to 1);
  signal slice1cost_difference : natural_255_2d(0 to 1, 0 to 24);
  signal slice1cost_single_0 : natural_255_1d(0 to 24);
  signal slice1cost_difference_2 : integer_minus_255_to_255_1d(0 to 24);
  signal slice1cost_newest_negative_0 : boolean_1d(0 to 24);
  signal slice1cost_tag_border_column : boolean;
  signal slice1cost_column_0 : natural_766_1d(0 to 24);
  -- slice1window
  signal slice1window_partial_0_0 : natural_766_1d(0 to 24);
  signal slice1window_partial_0_1 : natural_1532_1d(0 to 24);
  signal slice1window_sum_0 : natural_2298_1d(0 to 24);
  -- slice1winner1
  signal slice1winner1_best_cost_0 : natural_2298_1d(0 to 12);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_2298_1d(0 to 6);
  signal slice1winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_2298_1d(0 to 3);
  signal slice1winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice1winner4
  signal slice1winner4_best_cost_0 : natural_2298_1d(0 to 1);
  signal slice1winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice1winner5
  signal slice1winner5_best_cost_0_0 : natural range 0 to 2298;
  signal slice1winner5_best_index_0_0 : natural range 0 to 24;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 2298;
  signal slice1_best_index_0_0 : natural range 0 to 99;
  signal slice1_best_tag : tag_4;
  -- slice2shift
  signal slice2shift_search : natural_255_2d(0 to 2, 0 to 24);
  signal slice2shift_reference, slice2shift_search_out : natural_255_1d(0 to 2);
  -- slice2cost
  signal slice2cost_signs_difference_column, slice2cost_signs_write_column : natural range 0 to 511;
  signal slice2cost_pair_0 : natural_511_1d(0 to 24);
  signal slice2cost_signs_read_words : unsigned_25_1d(0 to 1);
  signal slice2cost_signs_ready_words : natural_33554431_1d(0 to 1);
  signal slice2cost_signs_known_words_1 : natural range 0 to 33554431;
  signal slice2cost_signs_write_words : natural_33554431_1d(0 to 1);
  signal slice2cost_difference : natural_255_2d(0 to 1, 0 to 24);
  signal slice2cost_single_0 : natural_255_1d(0 to 24);
  signal slice2cost_difference_2 : integer_minus_255_to_255_1d(0 to 24);
  signal slice2cost_newest_negative_0 : boolean_1d(0 to 24);
  signal slice2cost_tag_border_column : boolean;
  signal slice2cost_column_0 : natural_766_1d(0 to 24);
  -- slice2window
  signal slice2window_partial_0_0 : natural_766_1d(0 to 24);
  signal slice2window_partial_0_1 : natural_1532_1d(0 to 24);
  signal slice2window_sum_0 : natural_2298_1d(0 to 24);
  -- slice2winner1
  signal slice2winner1_best_cost_0 : natural_2298_1d(0 to 12);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice2winner2
  signal slice2winner2_best_cost_0 : natural_2298_1d(0 to 6);
  signal slice2winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice2winner3
  signal slice2winner3_best_cost_0 : natural_2298_1d(0 to 3);
  signal slice2winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice2winner4
  signal slice2winner4_best_cost_0 : natural_2298_1d(0 to 1);
  signal slice2winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice2winner5
  signal slice2winner5_best_cost_0_0 : natural range 0 to 2298;
  signal slice2winner5_best_index_0_0 : natural range 0 to 24;
  -- slice2
  signal slice2_best_cost_0_0 : natural range 0 to 2298;
  signal slice2_best_index_0_0 : natural range 0 to 99;
  signal slice2_best_tag : tag_4;
  -- slice3shift
  signal slice3shift_search : natural_255_2d(0 to 2, 0 to 24);
  signal slice3shift_reference : natural_255_1d(0 to 2);
  -- slice3cost
  signal slice3cost_signs_difference_column, slice3cost_signs_write_column : natural range 0 to 511;
  signal slice3cost_pair_0 : natural_511_1d(0 to 24);
  signal slice3cost_signs_read_words : unsigned_25_1d(0 to 1);
  signal slice3cost_signs_ready_words : natural_33554431_1d(0 to 1);
  signal slice3cost_signs_known_words_1 : natural range 0 to 33554431;
  signal slice3cost_signs_write_words : natural_33554431_1d(0 to 1);
  signal slice3cost_difference : natural_255_2d(0 to 1, 0 to 24);
  signal slice3cost_single_0 : natural_255_1d(0 to 24);
  signal slice3cost_difference_2 : integer_minus_255_to_255_1d(0 to 24);
  signal slice3cost_newest_negative_0 : boolean_1d(0 to 24);
  signal slice3cost_column_0 : natural_766_1d(0 to 24);
  -- slice3window
  signal slice3window_partial_0_0 : natural_766_1d(0 to 24);
  signal slice3window_partial_0_1 : natural_1532_1d(0 to 24);
  signal slice3window_sum_0 : natural_2298_1d(0 to 24);
  -- slice3winner1
  signal slice3winner1_best_cost_0 : natural_2298_1d(0 to 12);
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice3winner2
  signal slice3winner2_best_cost_0 : natural_2298_1d(0 to 6);
  signal slice3winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice3winner3
  signal slice3winner3_best_cost_0 : natural_2298_1d(0 to 3);
  signal slice3winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice3winner4
  signal slice3winner4_best_cost_0 : natural_2298_1d(0 to 1);
  signal slice3winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice3winner5
  signal slice3winner5_best_cost_0_0 : natural range 0 to 2298;
  signal slice3winner5_best_index_0_0 : natural range 0 to 24;
  -- slice3
  signal slice3_best_index_0_0 : natural range 0 to 99;
  signal slice3_best_tag : tag_4;

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice3_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice3_best_tag.valid and slice3_best_tag.output_column);
  disparity_start_of_frame <= as_bit(slice3_best_tag.start_of_frame and slice3_best_tag.valid and slice3_best_tag.output_column);
  disparity_end_of_line <= as_bit(slice3_best_tag.end_of_line and slice3_best_tag.valid and slice3_best_tag.output_column);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  slice3cost_signs_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(24 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_signs_difference_column, 9);
    write_address <= to_unsigned(slice3cost_signs_write_column, 9);
    write_data <= to_unsigned(slice3cost_signs_write_words(i), 25);
    cell : entity work.line_memory generic map (320, 25, 9)
      port map (clock, true, read_address, slice3cost_signs_read_words(i), write_address, write_data);
  end generate;

  slice2cost_signs_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(24 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_signs_next_column, 9);
    write_address <= to_unsigned(slice3cost_signs_difference_column, 9);
    write_data <= to_unsigned(slice2cost_signs_write_words(i), 25);
    cell : entity work.line_memory generic map (320, 25, 9)
      port map (clock, true, read_address, slice2cost_signs_read_words(i), write_address, write_data);
  end generate;

  slice1cost_signs_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(24 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_signs_column, 9);
    write_address <= to_unsigned(slice2cost_signs_difference_column, 9);
    write_data <= to_unsigned(slice1cost_signs_write_words(i), 25);
    cell : entity work.line_memory generic map (320, 25, 9)
      port map (clock, true, read_address, slice1cost_signs_read_words(i), write_address, write_data);
  end generate;

  slice0cost_signs_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(24 downto 0);
  begin
    read_address <= to_unsigned(rows_ready_column, 9);
    write_address <= to_unsigned(slice0cost_signs_write_column, 9);
    write_data <= to_unsigned(slice0cost_signs_write_words(i), 25);
    cell : entity work.line_memory generic map (320, 25, 9)
      port map (clock, true, read_address, slice0cost_signs_read_words(i), write_address, write_data);
  end generate;

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

  delay_delayed_0_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 7);
    write_address <= to_unsigned(delay_ring_write_address, 7);
    write_data <= to_unsigned(raster_features_reference_0, 8);
    cell : entity work.line_memory generic map (100, 8, 7)
      port map (clock, true, read_address, delay_delayed_0, write_address, write_data);
  end block;

  process
    variable raster_place_group_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable raster_place_group_all, raster_place_group_choice_2, raster_place_next_frame_choice,
      delay_row_inside_1_is_not_less, delay_row_inside_1_is_less, slice0winner5_best_cost_0_0_is_less,
      slice1winner5_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less, slice2winner5_best_cost_0_0_is_less,
      slice2_best_cost_0_0_is_less, slice3winner5_best_cost_0_0_is_less : boolean;
    variable raster_place_group_choice : natural range 0 to 15;
    variable raster_place_group_choices : natural_255_1d(3 to 4);  -- _choice_#
    variable slice0cost_difference_choice, slice1cost_difference_choice, slice2cost_difference_choice,
      slice3cost_difference_choice : natural_255_3d(0 to 1, 0 to 24, 1 to 2);  -- _#_#_choice_#
    variable slice0cost_difference_value, slice1cost_difference_value, slice2cost_difference_value,
      slice3cost_difference_value : boolean_2d(0 to 1, 1 to 23);  -- _#_#_value
    variable slice0cost_difference_2_difference, slice1cost_difference_2_difference,
      slice2cost_difference_2_difference, slice3cost_difference_2_difference : integer_minus_255_to_255_1d(0 to 24);  -- _#_difference
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less, slice2winner1_best_cost_0_is_less,
      slice3winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less, slice1winner2_best_cost_0_is_less, slice2winner2_best_cost_0_is_less,
      slice3winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- _#_is_less
    variable slice0winner3_best_cost_0_is_less, slice1winner3_best_cost_0_is_less, slice2winner3_best_cost_0_is_less,
      slice3winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable slice0winner4_best_cost_0_is_less, slice1winner4_best_cost_0_is_less, slice2winner4_best_cost_0_is_less,
      slice3winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
  begin
    wait until rising_edge(clock);
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
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 99, 0, (delay_ring_read_address + 1) mod 128);
    end if;
    delay_row_inside_1_is_not_less := raster_place_group >= 1;
    delay_row_inside_1_is_less := raster_place_group < 241;
    delay_ahead_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 240;
    delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
    delay_row_inside(2) <= (not is_set(raster_place_group, 7)) or (not is_set(raster_place_group, 6)) or (not
      is_set(raster_place_group, 5)) or (not is_set(raster_place_group, 4));
    delay_tag.valid <= raster_features_valid;
    delay_tag.border_column <= raster_place_column < 99;
    delay_tag.output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and (raster_place_column
      >= 99) and (raster_place_column < 319);
    delay_tag.start_of_frame <= (raster_place_column = 99) and (raster_place_group = 1);
    delay_tag.end_of_line <= raster_place_column = 318;
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
    rows_search(2) <= rows_search_rows_ready_newest_0;
    rows_reference(2) <= rows_reference_rows_ready_newest_0;
    rows_inside_2 <= rows_ready_inside(2);
    rows_tag <= rows_ready_tag;
    rows_search(0) <= choice(rows_ready_inside(0), rows_search_rows_ready_words_0 mod 256, 0);
    rows_reference(0) <= choice(rows_ready_inside(0), rows_reference_rows_ready_words_0 mod 256, 0);
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_words_0 / 256, 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_words_0 / 256, 0);
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
        for j in 0 to 23 loop slice0shift_search(i, j) <= slice0shift_search(i, j + 1); end loop;
        slice0shift_search(i, 24) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 0);
    slice0shift_search_out(1) <= slice0shift_search(1, 0);
    slice0shift_search_out(2) <= slice0shift_search(2, 0);
    slice0shift_tag.valid <= rows_tag.valid;
    slice0shift_tag.newest_inside <= rows_inside_2;
    slice0shift_tag.border_column <= rows_tag.border_column;
    slice0shift_tag.output_column <= rows_tag.output_column;
    slice0shift_tag.start_of_frame <= rows_tag.start_of_frame;
    slice0shift_tag.end_of_line <= rows_tag.end_of_line;
    -- slice0cost
    for i in 0 to 1 loop
      slice0cost_difference_choice(i, 0, 1) := choice(is_set(slice0cost_signs_ready_words(i), 0),
        slice0shift_reference(i), slice0shift_search(i, 0));
      slice0cost_difference_choice(i, 0, 2) := choice(is_set(slice0cost_signs_ready_words(i), 0), slice0shift_search(i,
        0), slice0shift_reference(i));
      for j in 1 to 23 loop
        slice0cost_difference_value(i, j) := is_set(slice0cost_signs_ready_words(i), j);
        slice0cost_difference_choice(i, j, 1) := choice(slice0cost_difference_value(i, j), slice0shift_reference(i),
          slice0shift_search(i, j));
        slice0cost_difference_choice(i, j, 2) := choice(slice0cost_difference_value(i, j), slice0shift_search(i, j),
          slice0shift_reference(i));
      end loop;
      slice0cost_difference_choice(i, 24, 1) := choice(is_set(slice0cost_signs_ready_words(i), 24),
        slice0shift_reference(i), slice0shift_search(i, 24));
      slice0cost_difference_choice(i, 24, 2) := choice(is_set(slice0cost_signs_ready_words(i), 24),
        slice0shift_search(i, 24), slice0shift_reference(i));
    end loop;
    for i in 0 to 24 loop
      slice0cost_difference_2_difference(i) := slice0shift_search(2, i) - slice0shift_reference(2);
    end loop;
    slice0cost_signs_column <= rows_ready_column;
    slice0cost_signs_next_column <= slice0cost_signs_column;
    slice0cost_signs_difference_column <= slice0cost_signs_next_column;
    slice0cost_signs_ready_words(0) <= to_integer(slice0cost_signs_read_words(0));
    slice0cost_signs_ready_words(1) <= to_integer(slice0cost_signs_read_words(1));
    slice0cost_signs_known_words_1 <= slice0cost_signs_ready_words(1);
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice0cost_difference(i, j) <= (slice0cost_difference_choice(i, j, 1) - slice0cost_difference_choice(i, j, 2))
          mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop slice0cost_newest_negative_0(i) <= slice0cost_difference_2_difference(i) < 0; end loop;
    slice0cost_difference_tag <= slice0shift_tag;
    for i in 0 to 24 loop
      slice0cost_pair_0(i) <= as_number((slice0cost_difference_2(i) < 0)) + slice0cost_difference(1, i) +
        folded(slice0cost_difference_2(i));
    end loop;
    for i in 0 to 24 loop slice0cost_single_0(i) <= slice0cost_difference(0, i); end loop;
    slice0cost_pair_tag <= slice0cost_difference_tag;
    slice0cost_tag <= slice0cost_pair_tag;
    for i in 0 to 24 loop
      slice0cost_difference_2(i) <= choice(slice0shift_tag.newest_inside, slice0cost_difference_2_difference(i), 0);
    end loop;
    for i in 0 to 24 loop
      slice0cost_column_0(i) <= choice(slice0cost_pair_tag.border_column, 0, slice0cost_pair_0(i) +
        slice0cost_single_0(i));
    end loop;
    if slice0cost_difference_tag.valid then
      slice0cost_signs_write_column <= slice0cost_signs_difference_column;
      slice0cost_signs_write_words(0) <= slice0cost_signs_known_words_1;
      slice0cost_signs_write_words(1) <= (as_number(slice0cost_newest_negative_0(23)) * 8388608) +
        (as_number(slice0cost_newest_negative_0(24)) * 16777216) + (as_number(slice0cost_newest_negative_0(22)) *
        4194304) + (as_number(slice0cost_newest_negative_0(21)) * 2097152) +
        (as_number(slice0cost_newest_negative_0(20)) * 1048576) + (as_number(slice0cost_newest_negative_0(19)) *
        524288) + (as_number(slice0cost_newest_negative_0(18)) * 262144) + (as_number(slice0cost_newest_negative_0(17))
        * 131072) + (as_number(slice0cost_newest_negative_0(16)) * 65536) +
        (as_number(slice0cost_newest_negative_0(15)) * 32768) + (as_number(slice0cost_newest_negative_0(14)) * 16384) +
        (as_number(slice0cost_newest_negative_0(13)) * 8192) + (as_number(slice0cost_newest_negative_0(12)) * 4096) +
        (as_number(slice0cost_newest_negative_0(11)) * 2048) + (as_number(slice0cost_newest_negative_0(10)) * 1024) +
        (as_number(slice0cost_newest_negative_0(9)) * 512) + (as_number(slice0cost_newest_negative_0(8)) * 256) +
        (as_number(slice0cost_newest_negative_0(6)) * 64) + (as_number(slice0cost_newest_negative_0(7)) * 128) +
        (as_number(slice0cost_newest_negative_0(5)) * 32) + (as_number(slice0cost_newest_negative_0(4)) * 16) +
        (as_number(slice0cost_newest_negative_0(3)) * 8) + (as_number(slice0cost_newest_negative_0(2)) * 4) +
        as_number(slice0cost_newest_negative_0(0)) + (as_number(slice0cost_newest_negative_0(1)) * 2);
    end if;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_partial_0_0 <= slice0cost_column_0;
      for i in 0 to 24 loop
        slice0window_partial_0_1(i) <= slice0cost_column_0(i) + slice0window_partial_0_0(i);
      end loop;
    end if;
    slice0window_centre_output_column_0 <= slice0cost_tag.output_column;
    slice0window_centre_start_of_frame_0 <= slice0cost_tag.start_of_frame;
    slice0window_centre_end_of_line_0 <= slice0cost_tag.end_of_line;
    for i in 0 to 24 loop slice0window_sum_0(i) <= slice0cost_column_0(i) + slice0window_partial_0_1(i); end loop;
    slice0window_tag.valid <= slice0cost_tag.valid;
    slice0window_tag.output_column <= slice0window_centre_output_column_0;
    slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame_0;
    slice0window_tag.end_of_line <= slice0window_centre_end_of_line_0;
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
    slice0winner2_tag.valid <= slice0winner1_tag.valid;
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
    if slice0winner2_tag.valid then
      slice0winner2_tag.output_column <= slice0winner1_tag.output_column;
      slice0winner2_tag.start_of_frame <= slice0winner1_tag.start_of_frame;
      slice0winner2_tag.end_of_line <= slice0winner1_tag.end_of_line;
    end if;
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
    slice0_best_index_0_0 <= slice0winner5_best_index_0_0 + 75;
    slice0_best_tag <= slice0winner5_tag;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 2 loop
        for j in 0 to 23 loop slice1shift_search(i, j) <= slice1shift_search(i, j + 1); end loop;
        slice1shift_search(i, 24) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    slice1shift_search_out(0) <= slice1shift_search(0, 0);
    slice1shift_search_out(1) <= slice1shift_search(1, 0);
    slice1shift_search_out(2) <= slice1shift_search(2, 0);
    -- slice1cost
    for i in 0 to 1 loop
      slice1cost_difference_choice(i, 0, 1) := choice(is_set(slice1cost_signs_ready_words(i), 0),
        slice1shift_reference(i), slice1shift_search(i, 0));
      slice1cost_difference_choice(i, 0, 2) := choice(is_set(slice1cost_signs_ready_words(i), 0), slice1shift_search(i,
        0), slice1shift_reference(i));
      for j in 1 to 23 loop
        slice1cost_difference_value(i, j) := is_set(slice1cost_signs_ready_words(i), j);
        slice1cost_difference_choice(i, j, 1) := choice(slice1cost_difference_value(i, j), slice1shift_reference(i),
          slice1shift_search(i, j));
        slice1cost_difference_choice(i, j, 2) := choice(slice1cost_difference_value(i, j), slice1shift_search(i, j),
          slice1shift_reference(i));
      end loop;
      slice1cost_difference_choice(i, 24, 1) := choice(is_set(slice1cost_signs_ready_words(i), 24),
        slice1shift_reference(i), slice1shift_search(i, 24));
      slice1cost_difference_choice(i, 24, 2) := choice(is_set(slice1cost_signs_ready_words(i), 24),
        slice1shift_search(i, 24), slice1shift_reference(i));
    end loop;
    for i in 0 to 24 loop
      slice1cost_difference_2_difference(i) := slice1shift_search(2, i) - slice1shift_reference(2);
    end loop;
    slice1cost_signs_difference_column <= slice0cost_signs_difference_column;
    slice1cost_signs_ready_words(0) <= to_integer(slice1cost_signs_read_words(0));
    slice1cost_signs_ready_words(1) <= to_integer(slice1cost_signs_read_words(1));
    slice1cost_signs_known_words_1 <= slice1cost_signs_ready_words(1);
    slice1cost_signs_write_column <= slice1cost_signs_difference_column;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice1cost_difference(i, j) <= (slice1cost_difference_choice(i, j, 1) - slice1cost_difference_choice(i, j, 2))
          mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop slice1cost_newest_negative_0(i) <= slice1cost_difference_2_difference(i) < 0; end loop;
    for i in 0 to 24 loop
      slice1cost_pair_0(i) <= as_number((slice1cost_difference_2(i) < 0)) + slice1cost_difference(1, i) +
        folded(slice1cost_difference_2(i));
    end loop;
    for i in 0 to 24 loop slice1cost_single_0(i) <= slice1cost_difference(0, i); end loop;
    slice1cost_tag_border_column <= slice0cost_tag.border_column;
    for i in 0 to 24 loop
      slice1cost_difference_2(i) <= choice(slice0cost_difference_tag.newest_inside,
        slice1cost_difference_2_difference(i), 0);
    end loop;
    for i in 0 to 24 loop
      slice1cost_column_0(i) <= choice(slice0cost_tag.border_column, 0, slice1cost_pair_0(i) + slice1cost_single_0(i));
    end loop;
    if slice0cost_pair_tag.valid then
      slice1cost_signs_write_words(0) <= slice1cost_signs_known_words_1;
      slice1cost_signs_write_words(1) <= (as_number(slice1cost_newest_negative_0(23)) * 8388608) +
        (as_number(slice1cost_newest_negative_0(24)) * 16777216) + (as_number(slice1cost_newest_negative_0(22)) *
        4194304) + (as_number(slice1cost_newest_negative_0(21)) * 2097152) +
        (as_number(slice1cost_newest_negative_0(20)) * 1048576) + (as_number(slice1cost_newest_negative_0(19)) *
        524288) + (as_number(slice1cost_newest_negative_0(18)) * 262144) + (as_number(slice1cost_newest_negative_0(17))
        * 131072) + (as_number(slice1cost_newest_negative_0(16)) * 65536) +
        (as_number(slice1cost_newest_negative_0(15)) * 32768) + (as_number(slice1cost_newest_negative_0(14)) * 16384) +
        (as_number(slice1cost_newest_negative_0(13)) * 8192) + (as_number(slice1cost_newest_negative_0(12)) * 4096) +
        (as_number(slice1cost_newest_negative_0(11)) * 2048) + (as_number(slice1cost_newest_negative_0(10)) * 1024) +
        (as_number(slice1cost_newest_negative_0(9)) * 512) + (as_number(slice1cost_newest_negative_0(8)) * 256) +
        (as_number(slice1cost_newest_negative_0(6)) * 64) + (as_number(slice1cost_newest_negative_0(7)) * 128) +
        (as_number(slice1cost_newest_negative_0(5)) * 32) + (as_number(slice1cost_newest_negative_0(4)) * 16) +
        (as_number(slice1cost_newest_negative_0(3)) * 8) + (as_number(slice1cost_newest_negative_0(2)) * 4) +
        as_number(slice1cost_newest_negative_0(0)) + (as_number(slice1cost_newest_negative_0(1)) * 2);
    end if;
    -- slice1window
    if slice0window_tag.valid then
      slice1window_partial_0_0 <= slice1cost_column_0;
      for i in 0 to 24 loop
        slice1window_partial_0_1(i) <= slice1cost_column_0(i) + slice1window_partial_0_0(i);
      end loop;
    end if;
    for i in 0 to 24 loop slice1window_sum_0(i) <= slice1cost_column_0(i) + slice1window_partial_0_1(i); end loop;
    -- slice1winner1
    for i in 0 to 11 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
    end loop;
    slice1winner1_best_cost_0(12) <= slice1window_sum_0(24);
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1window_sum_0(1),
      slice1window_sum_0(0));
    for i in 1 to 11 loop
      slice1winner1_best_cost_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1window_sum_0(2 * i + 1),
        slice1window_sum_0(2 * i));
      slice1winner1_best_index_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice1winner2
    for i in 0 to 5 loop
      slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner2_best_cost_0(6) <= slice1winner1_best_cost_0(12);
    slice1winner2_best_cost_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_cost_0(1),
      slice1winner1_best_cost_0(0));
    slice1winner2_best_index_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_index_0(1),
      as_number(slice1winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice1winner2_best_cost_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_cost_0(2 * i +
        1), slice1winner1_best_cost_0(2 * i));
      slice1winner2_best_index_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_index_0(2 * i +
        1), slice1winner1_best_index_0(2 * i));
    end loop;
    -- slice1winner3
    for i in 0 to 2 loop
      slice1winner3_best_cost_0_is_less(i) := (slice1winner2_best_cost_0(2 * i + 1) - slice1winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner3_best_cost_0(3) <= slice1winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice1winner3_best_cost_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_cost_0(2 * i +
        1), slice1winner2_best_cost_0(2 * i));
      slice1winner3_best_index_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_index_0(2 * i +
        1), slice1winner2_best_index_0(2 * i));
    end loop;
    -- slice1winner4
    slice1winner4_best_cost_0_is_less(0) := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
    slice1winner4_best_cost_0_is_less(1) := (slice1winner3_best_cost_0(3) - slice1winner3_best_cost_0(2)) < 0;
    slice1winner4_best_cost_0(0) <= choice(slice1winner4_best_cost_0_is_less(0), slice1winner3_best_cost_0(1),
      slice1winner3_best_cost_0(0));
    slice1winner4_best_index_0(0) <= choice(slice1winner4_best_cost_0_is_less(0), slice1winner3_best_index_0(1),
      slice1winner3_best_index_0(0));
    slice1winner4_best_cost_0(1) <= choice(slice1winner4_best_cost_0_is_less(1), slice1winner3_best_cost_0(3),
      slice1winner3_best_cost_0(2));
    slice1winner4_best_index_0(1) <= choice(slice1winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice1winner3_best_index_0(2));
    -- slice1winner5
    slice1winner5_best_cost_0_0_is_less := (slice1winner4_best_cost_0(1) - slice1winner4_best_cost_0(0)) < 0;
    slice1winner5_best_cost_0_0 <= choice(slice1winner5_best_cost_0_0_is_less, slice1winner4_best_cost_0(1),
      slice1winner4_best_cost_0(0));
    slice1winner5_best_index_0_0 <= choice(slice1winner5_best_cost_0_0_is_less, slice1winner4_best_index_0(1),
      slice1winner4_best_index_0(0));
    -- slice1
    slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner5_best_cost_0_0) < 0;
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_cost_0_0, slice1winner5_best_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_index_0_0,
      (((slice1winner5_best_index_0_0 / 2) + 25) * 2) + (slice1winner5_best_index_0_0 mod 2));
    -- slice2shift
    if slice0cost_difference_tag.valid then
      for i in 0 to 2 loop
        for j in 0 to 23 loop slice2shift_search(i, j) <= slice2shift_search(i, j + 1); end loop;
        slice2shift_search(i, 24) <= slice1shift_search_out(i);
      end loop;
    end if;
    slice2shift_reference <= slice1shift_reference;
    slice2shift_search_out(0) <= slice2shift_search(0, 0);
    slice2shift_search_out(1) <= slice2shift_search(1, 0);
    slice2shift_search_out(2) <= slice2shift_search(2, 0);
    -- slice2cost
    if slice0cost_pair_tag.valid then slice2cost_signs_difference_column <= slice1cost_signs_difference_column; end if;
    for i in 0 to 1 loop
      slice2cost_difference_choice(i, 0, 1) := choice(is_set(slice2cost_signs_ready_words(i), 0),
        slice2shift_reference(i), slice2shift_search(i, 0));
      slice2cost_difference_choice(i, 0, 2) := choice(is_set(slice2cost_signs_ready_words(i), 0), slice2shift_search(i,
        0), slice2shift_reference(i));
      for j in 1 to 23 loop
        slice2cost_difference_value(i, j) := is_set(slice2cost_signs_ready_words(i), j);
        slice2cost_difference_choice(i, j, 1) := choice(slice2cost_difference_value(i, j), slice2shift_reference(i),
          slice2shift_search(i, j));
        slice2cost_difference_choice(i, j, 2) := choice(slice2cost_difference_value(i, j), slice2shift_search(i, j),
          slice2shift_reference(i));
      end loop;
      slice2cost_difference_choice(i, 24, 1) := choice(is_set(slice2cost_signs_ready_words(i), 24),
        slice2shift_reference(i), slice2shift_search(i, 24));
      slice2cost_difference_choice(i, 24, 2) := choice(is_set(slice2cost_signs_ready_words(i), 24),
        slice2shift_search(i, 24), slice2shift_reference(i));
    end loop;
    for i in 0 to 24 loop
      slice2cost_difference_2_difference(i) := slice2shift_search(2, i) - slice2shift_reference(2);
    end loop;
    slice2cost_signs_ready_words(0) <= to_integer(slice2cost_signs_read_words(0));
    slice2cost_signs_ready_words(1) <= to_integer(slice2cost_signs_read_words(1));
    slice2cost_signs_known_words_1 <= slice2cost_signs_ready_words(1);
    slice2cost_signs_write_column <= slice1cost_signs_write_column;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice2cost_difference(i, j) <= (slice2cost_difference_choice(i, j, 1) - slice2cost_difference_choice(i, j, 2))
          mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop slice2cost_newest_negative_0(i) <= slice2cost_difference_2_difference(i) < 0; end loop;
    for i in 0 to 24 loop
      slice2cost_pair_0(i) <= as_number((slice2cost_difference_2(i) < 0)) + slice2cost_difference(1, i) +
        folded(slice2cost_difference_2(i));
    end loop;
    for i in 0 to 24 loop slice2cost_single_0(i) <= slice2cost_difference(0, i); end loop;
    slice2cost_tag_border_column <= slice1cost_tag_border_column;
    for i in 0 to 24 loop
      slice2cost_difference_2(i) <= choice(slice0cost_pair_tag.newest_inside, slice2cost_difference_2_difference(i), 0);
    end loop;
    for i in 0 to 24 loop
      slice2cost_column_0(i) <= choice(slice1cost_tag_border_column, 0, slice2cost_pair_0(i) + slice2cost_single_0(i));
    end loop;
    if slice0cost_tag.valid then
      slice2cost_signs_write_words(0) <= slice2cost_signs_known_words_1;
      slice2cost_signs_write_words(1) <= (as_number(slice2cost_newest_negative_0(23)) * 8388608) +
        (as_number(slice2cost_newest_negative_0(24)) * 16777216) + (as_number(slice2cost_newest_negative_0(22)) *
        4194304) + (as_number(slice2cost_newest_negative_0(21)) * 2097152) +
        (as_number(slice2cost_newest_negative_0(20)) * 1048576) + (as_number(slice2cost_newest_negative_0(19)) *
        524288) + (as_number(slice2cost_newest_negative_0(18)) * 262144) + (as_number(slice2cost_newest_negative_0(17))
        * 131072) + (as_number(slice2cost_newest_negative_0(16)) * 65536) +
        (as_number(slice2cost_newest_negative_0(15)) * 32768) + (as_number(slice2cost_newest_negative_0(14)) * 16384) +
        (as_number(slice2cost_newest_negative_0(13)) * 8192) + (as_number(slice2cost_newest_negative_0(12)) * 4096) +
        (as_number(slice2cost_newest_negative_0(11)) * 2048) + (as_number(slice2cost_newest_negative_0(10)) * 1024) +
        (as_number(slice2cost_newest_negative_0(9)) * 512) + (as_number(slice2cost_newest_negative_0(8)) * 256) +
        (as_number(slice2cost_newest_negative_0(6)) * 64) + (as_number(slice2cost_newest_negative_0(7)) * 128) +
        (as_number(slice2cost_newest_negative_0(5)) * 32) + (as_number(slice2cost_newest_negative_0(4)) * 16) +
        (as_number(slice2cost_newest_negative_0(3)) * 8) + (as_number(slice2cost_newest_negative_0(2)) * 4) +
        as_number(slice2cost_newest_negative_0(0)) + (as_number(slice2cost_newest_negative_0(1)) * 2);
    end if;
    -- slice2window
    if slice0winner1_tag.valid then
      slice2window_partial_0_0 <= slice2cost_column_0;
      for i in 0 to 24 loop
        slice2window_partial_0_1(i) <= slice2cost_column_0(i) + slice2window_partial_0_0(i);
      end loop;
    end if;
    for i in 0 to 24 loop slice2window_sum_0(i) <= slice2cost_column_0(i) + slice2window_partial_0_1(i); end loop;
    -- slice2winner1
    for i in 0 to 11 loop
      slice2winner1_best_cost_0_is_less(i) := (slice2window_sum_0(2 * i + 1) - slice2window_sum_0(2 * i)) < 0;
    end loop;
    slice2winner1_best_cost_0(12) <= slice2window_sum_0(24);
    slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
    slice2winner1_best_cost_0(0) <= choice(slice2winner1_best_cost_0_is_less(0), slice2window_sum_0(1),
      slice2window_sum_0(0));
    for i in 1 to 11 loop
      slice2winner1_best_cost_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), slice2window_sum_0(2 * i + 1),
        slice2window_sum_0(2 * i));
      slice2winner1_best_index_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice2winner2
    for i in 0 to 5 loop
      slice2winner2_best_cost_0_is_less(i) := (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice2winner2_best_cost_0(6) <= slice2winner1_best_cost_0(12);
    slice2winner2_best_cost_0(0) <= choice(slice2winner2_best_cost_0_is_less(0), slice2winner1_best_cost_0(1),
      slice2winner1_best_cost_0(0));
    slice2winner2_best_index_0(0) <= choice(slice2winner2_best_cost_0_is_less(0), slice2winner1_best_index_0(1),
      as_number(slice2winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice2winner2_best_cost_0(i) <= choice(slice2winner2_best_cost_0_is_less(i), slice2winner1_best_cost_0(2 * i +
        1), slice2winner1_best_cost_0(2 * i));
      slice2winner2_best_index_0(i) <= choice(slice2winner2_best_cost_0_is_less(i), slice2winner1_best_index_0(2 * i +
        1), slice2winner1_best_index_0(2 * i));
    end loop;
    -- slice2winner3
    for i in 0 to 2 loop
      slice2winner3_best_cost_0_is_less(i) := (slice2winner2_best_cost_0(2 * i + 1) - slice2winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice2winner3_best_cost_0(3) <= slice2winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice2winner3_best_cost_0(i) <= choice(slice2winner3_best_cost_0_is_less(i), slice2winner2_best_cost_0(2 * i +
        1), slice2winner2_best_cost_0(2 * i));
      slice2winner3_best_index_0(i) <= choice(slice2winner3_best_cost_0_is_less(i), slice2winner2_best_index_0(2 * i +
        1), slice2winner2_best_index_0(2 * i));
    end loop;
    -- slice2winner4
    slice2winner4_best_cost_0_is_less(0) := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
    slice2winner4_best_cost_0_is_less(1) := (slice2winner3_best_cost_0(3) - slice2winner3_best_cost_0(2)) < 0;
    slice2winner4_best_cost_0(0) <= choice(slice2winner4_best_cost_0_is_less(0), slice2winner3_best_cost_0(1),
      slice2winner3_best_cost_0(0));
    slice2winner4_best_index_0(0) <= choice(slice2winner4_best_cost_0_is_less(0), slice2winner3_best_index_0(1),
      slice2winner3_best_index_0(0));
    slice2winner4_best_cost_0(1) <= choice(slice2winner4_best_cost_0_is_less(1), slice2winner3_best_cost_0(3),
      slice2winner3_best_cost_0(2));
    slice2winner4_best_index_0(1) <= choice(slice2winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice2winner3_best_index_0(2));
    -- slice2winner5
    slice2winner5_best_cost_0_0_is_less := (slice2winner4_best_cost_0(1) - slice2winner4_best_cost_0(0)) < 0;
    slice2winner5_best_cost_0_0 <= choice(slice2winner5_best_cost_0_0_is_less, slice2winner4_best_cost_0(1),
      slice2winner4_best_cost_0(0));
    slice2winner5_best_index_0_0 <= choice(slice2winner5_best_cost_0_0_is_less, slice2winner4_best_index_0(1),
      slice2winner4_best_index_0(0));
    -- slice2
    slice2_best_cost_0_0_is_less := (slice1_best_cost_0_0 - slice2winner5_best_cost_0_0) < 0;
    slice2_best_tag <= slice1_best_tag;
    slice2_best_cost_0_0 <= choice(slice2_best_cost_0_0_is_less, slice1_best_cost_0_0, slice2winner5_best_cost_0_0);
    slice2_best_index_0_0 <= choice(slice2_best_cost_0_0_is_less, slice1_best_index_0_0, slice2winner5_best_index_0_0 +
      25);
    -- slice3shift
    if slice0cost_pair_tag.valid then
      for i in 0 to 2 loop
        for j in 0 to 23 loop slice3shift_search(i, j) <= slice3shift_search(i, j + 1); end loop;
        slice3shift_search(i, 24) <= slice2shift_search_out(i);
      end loop;
    end if;
    slice3shift_reference <= slice2shift_reference;
    -- slice3cost
    if slice0cost_tag.valid then slice3cost_signs_difference_column <= slice1cost_signs_write_column; end if;
    for i in 0 to 1 loop
      slice3cost_difference_choice(i, 0, 1) := choice(is_set(slice3cost_signs_ready_words(i), 0),
        slice3shift_reference(i), slice3shift_search(i, 0));
      slice3cost_difference_choice(i, 0, 2) := choice(is_set(slice3cost_signs_ready_words(i), 0), slice3shift_search(i,
        0), slice3shift_reference(i));
      for j in 1 to 23 loop
        slice3cost_difference_value(i, j) := is_set(slice3cost_signs_ready_words(i), j);
        slice3cost_difference_choice(i, j, 1) := choice(slice3cost_difference_value(i, j), slice3shift_reference(i),
          slice3shift_search(i, j));
        slice3cost_difference_choice(i, j, 2) := choice(slice3cost_difference_value(i, j), slice3shift_search(i, j),
          slice3shift_reference(i));
      end loop;
      slice3cost_difference_choice(i, 24, 1) := choice(is_set(slice3cost_signs_ready_words(i), 24),
        slice3shift_reference(i), slice3shift_search(i, 24));
      slice3cost_difference_choice(i, 24, 2) := choice(is_set(slice3cost_signs_ready_words(i), 24),
        slice3shift_search(i, 24), slice3shift_reference(i));
    end loop;
    for i in 0 to 24 loop
      slice3cost_difference_2_difference(i) := slice3shift_search(2, i) - slice3shift_reference(2);
    end loop;
    slice3cost_signs_ready_words(0) <= to_integer(slice3cost_signs_read_words(0));
    slice3cost_signs_ready_words(1) <= to_integer(slice3cost_signs_read_words(1));
    slice3cost_signs_known_words_1 <= slice3cost_signs_ready_words(1);
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice3cost_difference(i, j) <= (slice3cost_difference_choice(i, j, 1) - slice3cost_difference_choice(i, j, 2))
          mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop slice3cost_newest_negative_0(i) <= slice3cost_difference_2_difference(i) < 0; end loop;
    for i in 0 to 24 loop
      slice3cost_pair_0(i) <= as_number((slice3cost_difference_2(i) < 0)) + slice3cost_difference(1, i) +
        folded(slice3cost_difference_2(i));
    end loop;
    for i in 0 to 24 loop slice3cost_single_0(i) <= slice3cost_difference(0, i); end loop;
    for i in 0 to 24 loop
      slice3cost_difference_2(i) <= choice(slice0cost_tag.newest_inside, slice3cost_difference_2_difference(i), 0);
    end loop;
    for i in 0 to 24 loop
      slice3cost_column_0(i) <= choice(slice2cost_tag_border_column, 0, slice3cost_pair_0(i) + slice3cost_single_0(i));
    end loop;
    if slice0window_tag.valid then
      slice3cost_signs_write_column <= slice2cost_signs_write_column;
      slice3cost_signs_write_words(0) <= slice3cost_signs_known_words_1;
      slice3cost_signs_write_words(1) <= (as_number(slice3cost_newest_negative_0(23)) * 8388608) +
        (as_number(slice3cost_newest_negative_0(24)) * 16777216) + (as_number(slice3cost_newest_negative_0(22)) *
        4194304) + (as_number(slice3cost_newest_negative_0(21)) * 2097152) +
        (as_number(slice3cost_newest_negative_0(20)) * 1048576) + (as_number(slice3cost_newest_negative_0(19)) *
        524288) + (as_number(slice3cost_newest_negative_0(18)) * 262144) + (as_number(slice3cost_newest_negative_0(17))
        * 131072) + (as_number(slice3cost_newest_negative_0(16)) * 65536) +
        (as_number(slice3cost_newest_negative_0(15)) * 32768) + (as_number(slice3cost_newest_negative_0(14)) * 16384) +
        (as_number(slice3cost_newest_negative_0(13)) * 8192) + (as_number(slice3cost_newest_negative_0(12)) * 4096) +
        (as_number(slice3cost_newest_negative_0(11)) * 2048) + (as_number(slice3cost_newest_negative_0(10)) * 1024) +
        (as_number(slice3cost_newest_negative_0(9)) * 512) + (as_number(slice3cost_newest_negative_0(8)) * 256) +
        (as_number(slice3cost_newest_negative_0(6)) * 64) + (as_number(slice3cost_newest_negative_0(7)) * 128) +
        (as_number(slice3cost_newest_negative_0(5)) * 32) + (as_number(slice3cost_newest_negative_0(4)) * 16) +
        (as_number(slice3cost_newest_negative_0(3)) * 8) + (as_number(slice3cost_newest_negative_0(2)) * 4) +
        as_number(slice3cost_newest_negative_0(0)) + (as_number(slice3cost_newest_negative_0(1)) * 2);
    end if;
    -- slice3window
    if slice0winner2_tag.valid then
      slice3window_partial_0_0 <= slice3cost_column_0;
      for i in 0 to 24 loop
        slice3window_partial_0_1(i) <= slice3cost_column_0(i) + slice3window_partial_0_0(i);
      end loop;
    end if;
    for i in 0 to 24 loop slice3window_sum_0(i) <= slice3cost_column_0(i) + slice3window_partial_0_1(i); end loop;
    -- slice3winner1
    for i in 0 to 11 loop
      slice3winner1_best_cost_0_is_less(i) := (slice3window_sum_0(2 * i + 1) - slice3window_sum_0(2 * i)) < 0;
    end loop;
    slice3winner1_best_cost_0(12) <= slice3window_sum_0(24);
    slice3winner1_best_index_0_0 <= slice3winner1_best_cost_0_is_less(0);
    slice3winner1_best_cost_0(0) <= choice(slice3winner1_best_cost_0_is_less(0), slice3window_sum_0(1),
      slice3window_sum_0(0));
    for i in 1 to 11 loop
      slice3winner1_best_cost_0(i) <= choice(slice3winner1_best_cost_0_is_less(i), slice3window_sum_0(2 * i + 1),
        slice3window_sum_0(2 * i));
      slice3winner1_best_index_0(i) <= choice(slice3winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice3winner2
    for i in 0 to 5 loop
      slice3winner2_best_cost_0_is_less(i) := (slice3winner1_best_cost_0(2 * i + 1) - slice3winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice3winner2_best_cost_0(6) <= slice3winner1_best_cost_0(12);
    slice3winner2_best_cost_0(0) <= choice(slice3winner2_best_cost_0_is_less(0), slice3winner1_best_cost_0(1),
      slice3winner1_best_cost_0(0));
    slice3winner2_best_index_0(0) <= choice(slice3winner2_best_cost_0_is_less(0), slice3winner1_best_index_0(1),
      as_number(slice3winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice3winner2_best_cost_0(i) <= choice(slice3winner2_best_cost_0_is_less(i), slice3winner1_best_cost_0(2 * i +
        1), slice3winner1_best_cost_0(2 * i));
      slice3winner2_best_index_0(i) <= choice(slice3winner2_best_cost_0_is_less(i), slice3winner1_best_index_0(2 * i +
        1), slice3winner1_best_index_0(2 * i));
    end loop;
    -- slice3winner3
    for i in 0 to 2 loop
      slice3winner3_best_cost_0_is_less(i) := (slice3winner2_best_cost_0(2 * i + 1) - slice3winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice3winner3_best_cost_0(3) <= slice3winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice3winner3_best_cost_0(i) <= choice(slice3winner3_best_cost_0_is_less(i), slice3winner2_best_cost_0(2 * i +
        1), slice3winner2_best_cost_0(2 * i));
      slice3winner3_best_index_0(i) <= choice(slice3winner3_best_cost_0_is_less(i), slice3winner2_best_index_0(2 * i +
        1), slice3winner2_best_index_0(2 * i));
    end loop;
    -- slice3winner4
    slice3winner4_best_cost_0_is_less(0) := (slice3winner3_best_cost_0(1) - slice3winner3_best_cost_0(0)) < 0;
    slice3winner4_best_cost_0_is_less(1) := (slice3winner3_best_cost_0(3) - slice3winner3_best_cost_0(2)) < 0;
    slice3winner4_best_cost_0(0) <= choice(slice3winner4_best_cost_0_is_less(0), slice3winner3_best_cost_0(1),
      slice3winner3_best_cost_0(0));
    slice3winner4_best_index_0(0) <= choice(slice3winner4_best_cost_0_is_less(0), slice3winner3_best_index_0(1),
      slice3winner3_best_index_0(0));
    slice3winner4_best_cost_0(1) <= choice(slice3winner4_best_cost_0_is_less(1), slice3winner3_best_cost_0(3),
      slice3winner3_best_cost_0(2));
    slice3winner4_best_index_0(1) <= choice(slice3winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice3winner3_best_index_0(2));
    -- slice3winner5
    slice3winner5_best_cost_0_0_is_less := (slice3winner4_best_cost_0(1) - slice3winner4_best_cost_0(0)) < 0;
    slice3winner5_best_cost_0_0 <= choice(slice3winner5_best_cost_0_0_is_less, slice3winner4_best_cost_0(1),
      slice3winner4_best_cost_0(0));
    slice3winner5_best_index_0_0 <= choice(slice3winner5_best_cost_0_0_is_less, slice3winner4_best_index_0(1),
      slice3winner4_best_index_0(0));
    -- slice3
    slice3_best_tag <= slice2_best_tag;
    slice3_best_index_0_0 <= choice((slice2_best_cost_0_0 - slice3winner5_best_cost_0_0) < 0, slice2_best_index_0_0,
      slice3winner5_best_index_0_0);
    if reset = '1' then
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 241;
      raster_place_next_frame <= false; delay_ring_read_address <= 1; delay_ring_write_address <= 0; delay_column <= 0;
      delay_tag.valid <= false; delay_tag.output_column <= false; delay_tag.start_of_frame <= false;
      delay_tag.end_of_line <= false; rows_read_column <= 0; rows_read_tag.valid <= false;
      rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false;
      rows_ready_column <= 0; rows_ready_tag.valid <= false; rows_ready_tag.output_column <= false;
      rows_ready_tag.start_of_frame <= false; rows_ready_tag.end_of_line <= false; rows_write_column <= 0;
      rows_tag.valid <= false; rows_tag.output_column <= false; rows_tag.start_of_frame <= false;
      rows_tag.end_of_line <= false; slice0shift_tag.valid <= false; slice0shift_tag.output_column <= false;
      slice0shift_tag.start_of_frame <= false; slice0shift_tag.end_of_line <= false; slice0cost_signs_column <= 0;
      slice0cost_signs_next_column <= 0; slice0cost_signs_difference_column <= 0; slice0cost_signs_write_column <= 0;
      slice0cost_difference_tag.valid <= false; slice0cost_difference_tag.output_column <= false;
      slice0cost_difference_tag.start_of_frame <= false; slice0cost_difference_tag.end_of_line <= false;
      slice0cost_pair_tag.valid <= false; slice0cost_pair_tag.output_column <= false;
      slice0cost_pair_tag.start_of_frame <= false; slice0cost_pair_tag.end_of_line <= false;
      slice0cost_tag.valid <= false; slice0cost_tag.output_column <= false; slice0cost_tag.start_of_frame <= false;
      slice0cost_tag.end_of_line <= false; slice0window_centre_output_column_0 <= false;
      slice0window_centre_start_of_frame_0 <= false; slice0window_centre_end_of_line_0 <= false;
      slice0window_tag <= (others => false); slice0winner1_tag <= (others => false);
      slice0winner2_tag <= (others => false); slice0winner3_tag <= (others => false);
      slice0winner4_tag <= (others => false); slice0winner5_tag <= (others => false);
      slice0_best_tag <= (others => false); slice1cost_signs_difference_column <= 0; slice1cost_signs_write_column <= 0;
      slice1_best_tag <= (others => false); slice2cost_signs_difference_column <= 0; slice2cost_signs_write_column <= 0;
      slice2_best_tag <= (others => false); slice3cost_signs_difference_column <= 0; slice3cost_signs_write_column <= 0;
      slice3_best_tag <= (others => false);
    end if;
  end process;
end architecture;
