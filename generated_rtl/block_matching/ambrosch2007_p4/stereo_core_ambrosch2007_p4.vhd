-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration ambrosch2007_p4: 320x240, 100 disparities, window 3x3, 4 pixel pairs a clock.
-- Options: disparities 100, sign_memory true.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config ambrosch2007_p4
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_ambrosch2007_p4 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 240;
    disparities : positive := 100;
    pixels_per_clock : positive := 4;
    disparity_bits : positive := 8;
    output_width_px : positive := 220;
    latency_clocks : positive := 19;
    flush_groups : positive := 320;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(31 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(31 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(31 downto 0);
    pixel_valid : out std_logic_vector(3 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 320 report "stereo_core_ambrosch2007_p4: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 240 report "stereo_core_ambrosch2007_p4: height_px is " & integer'image(height_px) & " but this core has 240" severity failure;
  assert disparities = 100 report "stereo_core_ambrosch2007_p4: disparities is " & integer'image(disparities) & " but this core has 100" severity failure;
  assert pixels_per_clock = 4 report "stereo_core_ambrosch2007_p4: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 4" severity failure;
  assert disparity_bits = 8 report "stereo_core_ambrosch2007_p4: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 220 report "stereo_core_ambrosch2007_p4: output_width_px is " & integer'image(output_width_px) & " but this core has 220" severity failure;
  assert latency_clocks = 19 report "stereo_core_ambrosch2007_p4: latency_clocks is " & integer'image(latency_clocks) & " but this core has 19" severity failure;
  assert flush_groups = 320 report "stereo_core_ambrosch2007_p4: flush_groups is " & integer'image(flush_groups) & " but this core has 320" severity failure;
  assert gap_groups = 0 report "stereo_core_ambrosch2007_p4: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_ambrosch2007_p4 is
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
  type integer_minus_255_to_255_2d is array (natural range <>, natural range <>) of integer range -255 to 255;
  type natural_11_1d is array (natural range <>) of natural range 0 to 11;
  type natural_13_1d is array (natural range <>) of natural range 0 to 13;
  type natural_1532_1d is array (natural range <>) of natural range 0 to 1532;
  type natural_1534_2d is array (natural range <>, natural range <>) of natural range 0 to 1534;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_17_1d is array (natural range <>) of natural range 0 to 17;
  type natural_19_1d is array (natural range <>) of natural range 0 to 19;
  type natural_21_1d is array (natural range <>) of natural range 0 to 21;
  type natural_2301_1d is array (natural range <>) of natural range 0 to 2301;
  type natural_2301_2d is array (natural range <>, natural range <>) of natural range 0 to 2301;
  type natural_23_1d is array (natural range <>) of natural range 0 to 23;
  type natural_23_2d is array (natural range <>, natural range <>) of natural range 0 to 23;
  type natural_24_1d is array (natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_255_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 255;
  type natural_33554431_1d is array (natural range <>) of natural range 0 to 33554431;
  type natural_3_1d is array (natural range <>) of natural range 0 to 3;
  type natural_511_2d is array (natural range <>, natural range <>) of natural range 0 to 511;
  type natural_5_1d is array (natural range <>) of natural range 0 to 5;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_766_1d is array (natural range <>) of natural range 0 to 766;
  type natural_767_2d is array (natural range <>, natural range <>) of natural range 0 to 767;
  type natural_7_1d is array (natural range <>) of natural range 0 to 7;
  type natural_99_1d is array (natural range <>) of natural range 0 to 99;
  type natural_9_1d is array (natural range <>) of natural range 0 to 9;
  type unsigned_25_1d is array (natural range <>) of unsigned(24 downto 0);
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_valid, in_start_of_frame : boolean;
  signal in_left_pixel, in_right_pixel : unsigned(31 downto 0);
  -- raster
  signal raster_features_search : natural_255_1d(0 to 3);
  signal raster_features_reference : unsigned(31 downto 0);
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 511;
  signal raster_place_group : natural range 0 to 63;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 127;
  signal delay_ahead : natural_255_1d(0 to 3);
  signal delay_delayed_0 : unsigned(31 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag_valid, delay_tag_border_column, delay_tag_output_column, delay_tag_start_of_frame,
    delay_tag_end_of_line : boolean;
  signal delay_tag_newest_inside : natural range 0 to 15;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_ready_words_0, rows_search_rows_write_words_0,
    rows_reference_rows_read_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_read_words_1, rows_reference_rows_read_words_1 : unsigned(7 downto 0);
  signal rows_search_rows_read_newest : natural_255_1d(0 to 3);
  signal rows_search_rows_ready_words_1 : natural range 0 to 255;
  signal rows_search_rows_ready_newest : natural_255_1d(0 to 3);
  signal rows_search_rows_write_words_1 : natural range 0 to 255;
  signal rows_reference_rows_read_newest : natural_255_1d(0 to 3);
  signal rows_reference_rows_ready_words_1 : natural range 0 to 255;
  signal rows_reference_rows_ready_newest : natural_255_1d(0 to 3);
  signal rows_reference_rows_write_words_1 : natural range 0 to 255;
  signal rows_search, rows_reference : natural_255_1d(0 to 5);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag_valid, rows_read_tag_border_column, rows_read_tag_output_column, rows_read_tag_start_of_frame,
    rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_output_column,
    rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column,
    rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  signal rows_read_tag_newest_inside, rows_ready_tag_newest_inside, rows_tag_newest_inside : natural range 0 to 15;
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 5, 0 to 24);
  signal slice0shift_reference, slice0shift_search_out : natural_255_1d(0 to 5);
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_output_column,
    slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  signal slice0shift_tag_newest_inside : natural range 0 to 15;
  -- slice0cost
  signal slice0cost_signs_column, slice0cost_signs_next_column, slice0cost_signs_difference_column,
    slice0cost_signs_write_column : natural range 0 to 511;
  signal slice0cost_pair : natural_511_2d(0 to 1, 0 to 24);
  signal slice0cost_signs_read_words : unsigned_25_1d(0 to 1);
  signal slice0cost_signs_ready_words, slice0cost_signs_write_words : natural_33554431_1d(0 to 1);
  signal slice0cost_difference : natural_255_2d(0 to 1, 0 to 24);
  signal slice0cost_single_0 : natural_255_1d(0 to 24);
  signal slice0cost_single : natural_255_2d(2 to 3, 0 to 24);
  signal slice0cost_single_5 : natural_255_1d(0 to 24);
  signal slice0cost_differences : integer_minus_255_to_255_2d(2 to 5, 0 to 24);  -- _difference_#_#
  signal slice0cost_newest_negative : boolean_2d(2 to 3, 0 to 24);
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column,
    slice0cost_difference_tag_output_column, slice0cost_difference_tag_start_of_frame,
    slice0cost_difference_tag_end_of_line : boolean;
  signal slice0cost_negative_1, slice0cost_single_negative_3 : boolean_1d(0 to 24);
  signal slice0cost_pair_tag_valid, slice0cost_pair_tag_border_column, slice0cost_pair_tag_output_column,
    slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid,
    slice0cost_tag_border_column, slice0cost_tag_output_column, slice0cost_tag_start_of_frame,
    slice0cost_tag_end_of_line : boolean;
  signal slice0cost_difference_tag_newest_inside, slice0cost_pair_tag_newest_inside,
    slice0cost_tag_newest_inside : natural range 0 to 15;
  signal slice0cost_column : natural_767_2d(0 to 3, 0 to 24);  -- _#_# up to 766 x 25, 767 x 75
  -- slice0window
  signal slice0window_partial_0_0 : natural_766_1d(0 to 24);
  signal slice0window_partial_0_1 : natural_1532_1d(0 to 24);
  signal slice0window_partial_0 : natural_767_2d(1 to 3, 0 to 24);  -- _#_0_#
  signal slice0window_partial_1 : natural_1534_2d(1 to 3, 0 to 24);  -- _#_1_#
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0,
    slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_4;
  signal slice0window_sum : natural_2301_2d(0 to 3, 0 to 24);  -- _#_# up to 2298 x 25, 2301 x 75
  -- slice0winner1
  signal slice0winner1_best_cost : natural_2301_2d(0 to 3, 0 to 12);  -- _#_# up to 2298 x 13, 2301 x 39
  signal slice0winner1_best_index_0 : boolean_1d(0 to 3);  -- _#_0
  signal slice0winner1_tag : tag_4;
  signal slice0winner1_best_index : natural_23_2d(0 to 3, 1 to 11);  -- _#_# up to 3, 5 .. 23, 3, 5 .. 23, 3, 5 .. 23, 3, 5 .. 23
  signal slice0winner1_best_index_0_12 : natural range 0 to 24;
  -- slice0winner2
  signal slice0winner2_best_cost : natural_2301_2d(0 to 3, 0 to 6);  -- _#_# up to 2298 x 7, 2301 x 21
  signal slice0winner2_best_index_0 : natural_24_1d(0 to 6);  -- _# up to 3, 7 .. 23, 24
  signal slice0winner2_best_index : natural_23_2d(1 to 3, 0 to 5);  -- _#_# up to 3, 7 .. 23, 3, 7 .. 23, 3, 7 .. 23
  signal slice0winner2_tag : tag_4;
  -- slice0winner3
  signal slice0winner3_best_cost : natural_2301_2d(0 to 3, 0 to 3);  -- _#_# up to 2298 x 4, 2301 x 12
  signal slice0winner3_best_index_0 : natural_24_1d(0 to 3);  -- _# up to 7, 15, 23, 24
  signal slice0winner3_best_index : natural_23_2d(1 to 3, 0 to 2);  -- _#_# up to 7, 15, 23, 7, 15, 23, 7, 15, 23
  signal slice0winner3_tag : tag_4;
  -- slice0winner4
  signal slice0winner4_best_cost : natural_2301_2d(0 to 3, 0 to 1);  -- _#_# up to 2298, 2298, 2301 x 6
  signal slice0winner4_best_index_0 : natural_15_1d(0 to 3);  -- _#_0
  signal slice0winner4_best_index_1 : natural_24_1d(0 to 3);  -- _#_1
  signal slice0winner4_tag : tag_4;
  -- slice0winner5
  signal slice0winner5_best_cost_0 : natural_2301_1d(0 to 3);  -- _#_0 up to 2298, 2301, 2301, 2301
  signal slice0winner5_best_index_0 : natural_24_1d(0 to 3);  -- _#_0
  signal slice0winner5_tag : tag_4;
  -- slice0
  signal slice0_best_cost_0 : natural_2301_1d(0 to 3);  -- _#_0 up to 2298, 2301, 2301, 2301
  signal slice0_best_index_0 : natural_99_1d(0 to 3);  -- _#_0
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_255_2d(0 to 5, 0 to 24);
  signal slice1shift_reference, slice1shift_search_out : natural_255_1d(0 to 5);
  -- slice1cost
  signal slice1cost_signs_difference_column, slice1cost_signs_write_column : natural range 0 to 511;
  signal slice1cost_pair : natural_511_2d(0 to 1, 0 to 24);
  signal slice1cost_signs_read_words : unsigned_25_1d(0 to 1);
  signal slice1cost_signs_ready_words, slice1cost_signs_write_words : natural_33554431_1d(0 to 1);
  signal slice1cost_difference : natural_255_2d(0 to 1, 0 to 24);
  signal slice1cost_single_0 : natural_255_1d(0 to 24);
  signal slice1cost_single : natural_255_2d(2 to 3, 0 to 24);
  signal slice1cost_single_5 : natural_255_1d(0 to 24);
  signal slice1cost_differences : integer_minus_255_to_255_2d(2 to 5, 0 to 24);  -- _difference_#_#
  signal slice1cost_newest_negative : boolean_2d(2 to 3, 0 to 24);
  signal slice1cost_negative_1, slice1cost_single_negative_3 : boolean_1d(0 to 24);
  signal slice1cost_tag_border_column : boolean;
  signal slice1cost_column : natural_767_2d(0 to 3, 0 to 24);  -- _#_# up to 766 x 25, 767 x 75
  -- slice1window
  signal slice1window_partial_0_0 : natural_766_1d(0 to 24);
  signal slice1window_partial_0_1 : natural_1532_1d(0 to 24);
  signal slice1window_partial_0 : natural_767_2d(1 to 3, 0 to 24);  -- _#_0_#
  signal slice1window_partial_1 : natural_1534_2d(1 to 3, 0 to 24);  -- _#_1_#
  signal slice1window_sum : natural_2301_2d(0 to 3, 0 to 24);  -- _#_# up to 2298 x 25, 2301 x 75
  -- slice1winner1
  signal slice1winner1_best_cost : natural_2301_2d(0 to 3, 0 to 12);  -- _#_# up to 2298 x 13, 2301 x 39
  signal slice1winner1_best_index_0 : boolean_1d(0 to 3);  -- _#_0
  signal slice1winner1_best_index_1 : natural_3_1d(0 to 3);  -- _#_1
  signal slice1winner1_best_index_2 : natural_5_1d(0 to 3);  -- _#_2
  signal slice1winner1_best_index_3 : natural_7_1d(0 to 3);  -- _#_3
  signal slice1winner1_best_index_4 : natural_9_1d(0 to 3);  -- _#_4
  signal slice1winner1_best_index_5 : natural_11_1d(0 to 3);  -- _#_5
  signal slice1winner1_best_index_6 : natural_13_1d(0 to 3);  -- _#_6
  signal slice1winner1_best_index_7 : natural_15_1d(0 to 3);  -- _#_7
  signal slice1winner1_best_index_8 : natural_17_1d(0 to 3);  -- _#_8
  signal slice1winner1_best_index_9 : natural_19_1d(0 to 3);  -- _#_9
  signal slice1winner1_best_index_10 : natural_21_1d(0 to 3);  -- _#_10
  signal slice1winner1_best_index_11 : natural_23_1d(0 to 3);  -- _#_11
  -- slice1winner2
  signal slice1winner2_best_cost : natural_2301_2d(0 to 3, 0 to 6);  -- _#_# up to 2298 x 7, 2301 x 21
  signal slice1winner2_best_index_0 : natural_3_1d(0 to 3);  -- _#_0
  signal slice1winner2_best_index_1 : natural_7_1d(0 to 3);  -- _#_1
  signal slice1winner2_best_index_2 : natural_11_1d(0 to 3);  -- _#_2
  signal slice1winner2_best_index_3 : natural_15_1d(0 to 3);  -- _#_3
  signal slice1winner2_best_index_4 : natural_19_1d(0 to 3);  -- _#_4
  signal slice1winner2_best_index_5 : natural_23_1d(0 to 3);  -- _#_5
  -- slice1winner3
  signal slice1winner3_best_cost : natural_2301_2d(0 to 3, 0 to 3);  -- _#_# up to 2298 x 4, 2301 x 12
  signal slice1winner3_best_index_0 : natural_7_1d(0 to 3);  -- _#_0
  signal slice1winner3_best_index_1 : natural_15_1d(0 to 3);  -- _#_1
  signal slice1winner3_best_index_2 : natural_23_1d(0 to 3);  -- _#_2
  -- slice1winner4
  signal slice1winner4_best_cost : natural_2301_2d(0 to 3, 0 to 1);  -- _#_# up to 2298, 2298, 2301 x 6
  signal slice1winner4_best_index_0 : natural_15_1d(0 to 3);  -- _#_0
  signal slice1winner4_best_index_1 : natural_24_1d(0 to 3);  -- _#_1
  -- slice1winner5
  signal slice1winner5_best_cost_0 : natural_2301_1d(0 to 3);  -- _#_0 up to 2298, 2301, 2301, 2301
  signal slice1winner5_best_index_0 : natural_24_1d(0 to 3);  -- _#_0
  -- slice1
  signal slice1_best_cost_0 : natural_2301_1d(0 to 3);  -- _#_0 up to 2298, 2301, 2301, 2301
  signal slice1_best_index_0 : natural_99_1d(0 to 3);  -- _#_0
  signal slice1_best_tag : tag_4;
  -- slice2shift
  signal slice2shift_search : natural_255_2d(0 to 5, 0 to 24);
  signal slice2shift_reference, slice2shift_search_out : natural_255_1d(0 to 5);
  -- slice2cost
  signal slice2cost_signs_difference_column, slice2cost_signs_write_column : natural range 0 to 511;
  signal slice2cost_pair : natural_511_2d(0 to 1, 0 to 24);
  signal slice2cost_signs_read_words : unsigned_25_1d(0 to 1);
  signal slice2cost_signs_ready_words, slice2cost_signs_write_words : natural_33554431_1d(0 to 1);
  signal slice2cost_difference : natural_255_2d(0 to 1, 0 to 24);
  signal slice2cost_single_0 : natural_255_1d(0 to 24);
  signal slice2cost_single : natural_255_2d(2 to 3, 0 to 24);
  signal slice2cost_single_5 : natural_255_1d(0 to 24);
  signal slice2cost_differences : integer_minus_255_to_255_2d(2 to 5, 0 to 24);  -- _difference_#_#
  signal slice2cost_newest_negative : boolean_2d(2 to 3, 0 to 24);
  signal slice2cost_negative_1, slice2cost_single_negative_3 : boolean_1d(0 to 24);
  signal slice2cost_tag_border_column : boolean;
  signal slice2cost_column : natural_767_2d(0 to 3, 0 to 24);  -- _#_# up to 766 x 25, 767 x 75
  -- slice2window
  signal slice2window_partial_0_0 : natural_766_1d(0 to 24);
  signal slice2window_partial_0_1 : natural_1532_1d(0 to 24);
  signal slice2window_partial_0 : natural_767_2d(1 to 3, 0 to 24);  -- _#_0_#
  signal slice2window_partial_1 : natural_1534_2d(1 to 3, 0 to 24);  -- _#_1_#
  signal slice2window_sum : natural_2301_2d(0 to 3, 0 to 24);  -- _#_# up to 2298 x 25, 2301 x 75
  -- slice2winner1
  signal slice2winner1_best_cost : natural_2301_2d(0 to 3, 0 to 12);  -- _#_# up to 2298 x 13, 2301 x 39
  signal slice2winner1_best_index_0 : boolean_1d(0 to 3);  -- _#_0
  signal slice2winner1_best_index_1 : natural_3_1d(0 to 3);  -- _#_1
  signal slice2winner1_best_index_2 : natural_5_1d(0 to 3);  -- _#_2
  signal slice2winner1_best_index_3 : natural_7_1d(0 to 3);  -- _#_3
  signal slice2winner1_best_index_4 : natural_9_1d(0 to 3);  -- _#_4
  signal slice2winner1_best_index_5 : natural_11_1d(0 to 3);  -- _#_5
  signal slice2winner1_best_index_6 : natural_13_1d(0 to 3);  -- _#_6
  signal slice2winner1_best_index_7 : natural_15_1d(0 to 3);  -- _#_7
  signal slice2winner1_best_index_8 : natural_17_1d(0 to 3);  -- _#_8
  signal slice2winner1_best_index_9 : natural_19_1d(0 to 3);  -- _#_9
  signal slice2winner1_best_index_10 : natural_21_1d(0 to 3);  -- _#_10
  signal slice2winner1_best_index_11 : natural_23_1d(0 to 3);  -- _#_11
  -- slice2winner2
  signal slice2winner2_best_cost : natural_2301_2d(0 to 3, 0 to 6);  -- _#_# up to 2298 x 7, 2301 x 21
  signal slice2winner2_best_index_0 : natural_3_1d(0 to 3);  -- _#_0
  signal slice2winner2_best_index_1 : natural_7_1d(0 to 3);  -- _#_1
  signal slice2winner2_best_index_2 : natural_11_1d(0 to 3);  -- _#_2
  signal slice2winner2_best_index_3 : natural_15_1d(0 to 3);  -- _#_3
  signal slice2winner2_best_index_4 : natural_19_1d(0 to 3);  -- _#_4
  signal slice2winner2_best_index_5 : natural_23_1d(0 to 3);  -- _#_5
  -- slice2winner3
  signal slice2winner3_best_cost : natural_2301_2d(0 to 3, 0 to 3);  -- _#_# up to 2298 x 4, 2301 x 12
  signal slice2winner3_best_index_0 : natural_7_1d(0 to 3);  -- _#_0
  signal slice2winner3_best_index_1 : natural_15_1d(0 to 3);  -- _#_1
  signal slice2winner3_best_index_2 : natural_23_1d(0 to 3);  -- _#_2
  -- slice2winner4
  signal slice2winner4_best_cost : natural_2301_2d(0 to 3, 0 to 1);  -- _#_# up to 2298, 2298, 2301 x 6
  signal slice2winner4_best_index_0 : natural_15_1d(0 to 3);  -- _#_0
  signal slice2winner4_best_index_1 : natural_24_1d(0 to 3);  -- _#_1
  -- slice2winner5
  signal slice2winner5_best_cost_0 : natural_2301_1d(0 to 3);  -- _#_0 up to 2298, 2301, 2301, 2301
  signal slice2winner5_best_index_0 : natural_24_1d(0 to 3);  -- _#_0
  -- slice2
  signal slice2_best_cost_0 : natural_2301_1d(0 to 3);  -- _#_0 up to 2298, 2301, 2301, 2301
  signal slice2_best_index_0 : natural_99_1d(0 to 3);  -- _#_0
  signal slice2_best_tag : tag_4;
  -- slice3shift
  signal slice3shift_search : natural_255_2d(0 to 5, 0 to 24);
  signal slice3shift_reference : natural_255_1d(0 to 5);
  -- slice3cost
  signal slice3cost_signs_difference_column, slice3cost_signs_write_column : natural range 0 to 511;
  signal slice3cost_pair : natural_511_2d(0 to 1, 0 to 24);
  signal slice3cost_signs_read_words : unsigned_25_1d(0 to 1);
  signal slice3cost_signs_ready_words, slice3cost_signs_write_words : natural_33554431_1d(0 to 1);
  signal slice3cost_difference : natural_255_2d(0 to 1, 0 to 24);
  signal slice3cost_single_0 : natural_255_1d(0 to 24);
  signal slice3cost_single : natural_255_2d(2 to 3, 0 to 24);
  signal slice3cost_single_5 : natural_255_1d(0 to 24);
  signal slice3cost_differences : integer_minus_255_to_255_2d(2 to 5, 0 to 24);  -- _difference_#_#
  signal slice3cost_newest_negative : boolean_2d(2 to 3, 0 to 24);
  signal slice3cost_negative_1, slice3cost_single_negative_3 : boolean_1d(0 to 24);
  signal slice3cost_column : natural_767_2d(0 to 3, 0 to 24);  -- _#_# up to 766 x 25, 767 x 75
  -- slice3window
  signal slice3window_partial_0_0 : natural_766_1d(0 to 24);
  signal slice3window_partial_0_1 : natural_1532_1d(0 to 24);
  signal slice3window_partial_0 : natural_767_2d(1 to 3, 0 to 24);  -- _#_0_#
  signal slice3window_partial_1 : natural_1534_2d(1 to 3, 0 to 24);  -- _#_1_#
  signal slice3window_sum : natural_2301_2d(0 to 3, 0 to 24);  -- _#_# up to 2298 x 25, 2301 x 75
  -- slice3winner1
  signal slice3winner1_best_cost : natural_2301_2d(0 to 3, 0 to 12);  -- _#_# up to 2298 x 13, 2301 x 39
  signal slice3winner1_best_index_0 : boolean_1d(0 to 3);  -- _#_0
  signal slice3winner1_best_index_1 : natural_3_1d(0 to 3);  -- _#_1
  signal slice3winner1_best_index_2 : natural_5_1d(0 to 3);  -- _#_2
  signal slice3winner1_best_index_3 : natural_7_1d(0 to 3);  -- _#_3
  signal slice3winner1_best_index_4 : natural_9_1d(0 to 3);  -- _#_4
  signal slice3winner1_best_index_5 : natural_11_1d(0 to 3);  -- _#_5
  signal slice3winner1_best_index_6 : natural_13_1d(0 to 3);  -- _#_6
  signal slice3winner1_best_index_7 : natural_15_1d(0 to 3);  -- _#_7
  signal slice3winner1_best_index_8 : natural_17_1d(0 to 3);  -- _#_8
  signal slice3winner1_best_index_9 : natural_19_1d(0 to 3);  -- _#_9
  signal slice3winner1_best_index_10 : natural_21_1d(0 to 3);  -- _#_10
  signal slice3winner1_best_index_11 : natural_23_1d(0 to 3);  -- _#_11
  -- slice3winner2
  signal slice3winner2_best_cost : natural_2301_2d(0 to 3, 0 to 6);  -- _#_# up to 2298 x 7, 2301 x 21
  signal slice3winner2_best_index_0 : natural_3_1d(0 to 3);  -- _#_0
  signal slice3winner2_best_index_1 : natural_7_1d(0 to 3);  -- _#_1
  signal slice3winner2_best_index_2 : natural_11_1d(0 to 3);  -- _#_2
  signal slice3winner2_best_index_3 : natural_15_1d(0 to 3);  -- _#_3
  signal slice3winner2_best_index_4 : natural_19_1d(0 to 3);  -- _#_4
  signal slice3winner2_best_index_5 : natural_23_1d(0 to 3);  -- _#_5
  -- slice3winner3
  signal slice3winner3_best_cost : natural_2301_2d(0 to 3, 0 to 3);  -- _#_# up to 2298 x 4, 2301 x 12
  signal slice3winner3_best_index_0 : natural_7_1d(0 to 3);  -- _#_0
  signal slice3winner3_best_index_1 : natural_15_1d(0 to 3);  -- _#_1
  signal slice3winner3_best_index_2 : natural_23_1d(0 to 3);  -- _#_2
  -- slice3winner4
  signal slice3winner4_best_cost : natural_2301_2d(0 to 3, 0 to 1);  -- _#_# up to 2298, 2298, 2301 x 6
  signal slice3winner4_best_index_0 : natural_15_1d(0 to 3);  -- _#_0
  signal slice3winner4_best_index_1 : natural_24_1d(0 to 3);  -- _#_1
  -- slice3winner5
  signal slice3winner5_best_cost_0 : natural_2301_1d(0 to 3);  -- _#_0 up to 2298, 2301, 2301, 2301
  signal slice3winner5_best_index_0 : natural_24_1d(0 to 3);  -- _#_0
  -- slice3
  signal slice3_best_index_0 : natural_99_1d(0 to 3);  -- _#_0
  signal slice3_best_tag : tag_4;

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_left_pixel <= unsigned(left_pixel);
  in_right_pixel <= unsigned(right_pixel);
  disparity <= std_logic_vector(unsigned'(to_unsigned(slice3_best_index_0(3), 8) & to_unsigned(slice3_best_index_0(2), 8) & to_unsigned(slice3_best_index_0(1), 8) & to_unsigned(slice3_best_index_0(0), 8)));
  pixel_valid <= std_logic_vector(to_unsigned(15, 4));
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
    read_address <= to_unsigned(rows_write_column, 9);
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
    write_address <= to_unsigned(slice1cost_signs_difference_column, 9);
    write_data <= to_unsigned(slice0cost_signs_write_words(i), 25);
    cell : entity work.line_memory generic map (320, 25, 9)
      port map (clock, true, read_address, slice0cost_signs_read_words(i), write_address, write_data);
  end generate;

  rows_search_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(slice0cost_signs_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words_1, 8);
    cell : entity work.line_memory generic map (320, 8, 9)
      port map (clock, true, read_address, rows_search_rows_read_words_1, write_address, write_data);
  end block;

  rows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(slice0cost_signs_column, 9);
    cell : entity work.line_memory generic map (320, 32, 9)
      port map (clock, true, read_address, rows_search_rows_read_words_0, write_address,
        rows_search_rows_write_words_0);
  end block;

  rows_reference_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(slice0cost_signs_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words_1, 8);
    cell : entity work.line_memory generic map (320, 8, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words_1, write_address, write_data);
  end block;

  rows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(slice0cost_signs_column, 9);
    cell : entity work.line_memory generic map (320, 32, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words_0, write_address,
        rows_reference_rows_write_words_0);
  end block;

  delay_delayed_0_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 7);
    write_address <= to_unsigned(delay_ring_write_address, 7);
    cell : entity work.line_memory generic map (100, 32, 7)
      port map (clock, true, read_address, delay_delayed_0, write_address, raster_features_reference);
  end block;

  process
    variable raster_place_group_is_equals, delay_row_inside_1_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable raster_place_group_alls : boolean_1d(1 to 2);  -- _all_#
    variable raster_place_group_choice : natural range 0 to 15;
    variable raster_place_group_choice_2, raster_place_next_frame_choice, delay_row_inside_0_differs,
      delay_row_inside_1_choice, delay_tag_newest_inside_is_equal, delay_tag_output_column_is_not_less,
      delay_tag_output_column_is_less : boolean;
    variable raster_place_group_choices : natural_63_1d(3 to 4);  -- _choice_#
    variable delay_tag_newest_inside_anys : boolean_1d(1 to 2);  -- _any_#
    variable delay_tag_newest_inside_choices : natural_7_1d(1 to 4);  -- _choice_#
    variable delay_tag_newest_inside_choice_2 : natural range 0 to 3;
    variable delay_tag_newest_inside_sum : natural range 0 to 7;
    variable slice0cost_difference_choice, slice1cost_difference_choice, slice2cost_difference_choice,
      slice3cost_difference_choice : natural_255_3d(0 to 1, 0 to 24, 1 to 2);  -- _#_#_choice_#
    variable slice0cost_difference_value, slice1cost_difference_value, slice2cost_difference_value,
      slice3cost_difference_value : boolean_2d(0 to 4, 0 to 23);  -- _#_#_value
    variable slice0cost_difference_difference, slice1cost_difference_difference, slice2cost_difference_difference,
      slice3cost_difference_difference : integer_minus_255_to_255_2d(4 to 5, 0 to 24);  -- _#_#_difference
    variable slice0cost_pair_is_less, slice1cost_pair_is_less, slice2cost_pair_is_less,
      slice3cost_pair_is_less : boolean_2d(0 to 1, 0 to 24);  -- _#_#_is_less
    variable slice0cost_pair_folded_value, slice1cost_pair_folded_value, slice2cost_pair_folded_value,
      slice3cost_pair_folded_value : natural_255_2d(0 to 1, 0 to 24);  -- _#_#_folded_value
    variable slice0winner1_best_cost_is_less, slice1winner1_best_cost_is_less, slice2winner1_best_cost_is_less,
      slice3winner1_best_cost_is_less : boolean_2d(0 to 3, 0 to 11);  -- _#_#_is_less
    variable slice0winner2_best_cost_is_less, slice1winner2_best_cost_is_less, slice2winner2_best_cost_is_less,
      slice3winner2_best_cost_is_less : boolean_2d(0 to 3, 0 to 5);  -- _#_#_is_less
    variable slice0winner3_best_cost_is_less, slice1winner3_best_cost_is_less, slice2winner3_best_cost_is_less,
      slice3winner3_best_cost_is_less : boolean_2d(0 to 3, 0 to 2);  -- _#_#_is_less
    variable slice0winner4_best_cost_is_less, slice1winner4_best_cost_is_less, slice2winner4_best_cost_is_less,
      slice3winner4_best_cost_is_less : boolean_2d(0 to 3, 0 to 1);  -- _#_#_is_less
    variable slice0winner5_best_cost_0_is_less, slice1winner5_best_cost_0_is_less, slice1_best_cost_0_is_less,
      slice2winner5_best_cost_0_is_less, slice2_best_cost_0_is_less,
      slice3winner5_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_0_is_less
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    delay_tag_newest_inside_choices := (others => 0); slice0cost_difference_value := (others => (others => false));
    slice1cost_difference_value := (others => (others => false));
    slice2cost_difference_value := (others => (others => false));
    slice3cost_difference_value := (others => (others => false));
    -- raster
    raster_place_group_is_equals(1) := raster_place_column = 319;
    raster_place_group_is_equals(2) := raster_place_group = 59;
    raster_place_group_alls(1) := raster_place_group_is_equals(1) and raster_place_group_is_equals(2);
    raster_place_group_choice := choice(raster_place_group_alls(1), 15, 0);
    raster_place_group_choice_2 := choice((raster_place_group / 2) = 30, raster_place_group_is_equals(1) and in_valid
      and (not is_set(raster_place_group, 0)), raster_place_group_is_equals(1) and in_valid);
    raster_place_group_alls(2) := raster_place_next_frame and (raster_place_group = 60);
    raster_place_group_choices(3) := choice(raster_place_group_alls(2), 1, (raster_place_group + 1) mod 64);
    raster_place_group_choices(4) := choice(raster_place_group_choice_2, raster_place_group_choices(3),
      raster_place_group);
    raster_features_search(0) <= to_integer(in_left_pixel(7 downto 0));
    raster_features_search(1) <= to_integer(in_left_pixel(15 downto 8));
    raster_features_search(2) <= to_integer(in_left_pixel(23 downto 16));
    raster_features_search(3) <= to_integer(in_left_pixel(31 downto 24));
    raster_features_reference <= in_right_pixel;
    raster_features_valid <= in_valid;
    raster_place_group <= choice(in_start_of_frame and in_valid, raster_place_group_choice * 4,
      raster_place_group_choices(4));
    raster_place_next_frame_choice := choice(raster_place_group_alls(2), raster_place_next_frame and
      (raster_place_column /= 319), raster_place_next_frame);
    if in_valid then
      raster_place_column <= choice(raster_place_group_is_equals(1) or in_start_of_frame, 0, (raster_place_column + 1)
        mod 512);
      raster_place_next_frame <= choice(raster_place_next_frame_choice, raster_place_group_alls(1) or (not
        in_start_of_frame), raster_place_group_is_equals(1) and raster_place_group_is_equals(2) and in_start_of_frame);
    end if;
    -- delay
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 99, 0, (delay_ring_read_address + 1) mod 128);
    end if;
    delay_row_inside_0_differs := (raster_place_group / 2) /= 0;
    delay_row_inside_1_is_equals(1) := (raster_place_group / 2) = 0;
    delay_row_inside_1_choice := choice(is_set(raster_place_group, 0), ((raster_place_group / 4) mod 4) = 3,
      ((raster_place_group / 2) mod 8) = 7);
    delay_row_inside_1_is_equals(2) := (raster_place_group / 16) = 3;
    delay_tag_newest_inside_anys(1) := ((raster_place_group / 4) /= 15) or delay_row_inside_1_is_equals(1);
    delay_tag_newest_inside_is_equal := raster_place_group = 0;
    delay_tag_newest_inside_choices(1) := choice(delay_tag_newest_inside_is_equal, 0, 7);
    delay_tag_newest_inside_anys(2) := (not delay_row_inside_1_choice) or (not is_set(raster_place_group, 5)) or (not
      is_set(raster_place_group, 4));
    delay_tag_newest_inside_choice_2 := choice(delay_tag_newest_inside_anys(2), 3, 0);
    delay_tag_newest_inside_sum := (delay_tag_newest_inside_choice_2 * 2) + as_number(delay_tag_newest_inside_anys(2));
    delay_tag_newest_inside_choices(3) := choice(delay_row_inside_1_is_equals(1), delay_tag_newest_inside_choices(1),
      delay_tag_newest_inside_sum);
    delay_tag_newest_inside_choices(4) := choice(delay_tag_newest_inside_anys(1), delay_tag_newest_inside_choices(3),
      delay_tag_newest_inside_sum);
    delay_tag_output_column_is_not_less := raster_place_column >= 99;
    delay_tag_output_column_is_less := raster_place_column < 319;
    delay_ahead <= raster_features_search;
    delay_column <= raster_place_column;
    delay_tag_valid <= raster_features_valid;
    delay_tag_newest_inside <= delay_tag_newest_inside_choices(4) + (as_number(delay_tag_newest_inside_anys(1)) * 8);
    delay_tag_border_column <= raster_place_column < 99;
    delay_tag_start_of_frame <= (raster_place_column = 99) and (raster_place_group = 1);
    delay_tag_end_of_line <= raster_place_column = 318;
    delay_row_inside(0) <= choice(((raster_place_group / 2) mod 16) = 15, delay_row_inside_0_differs and (not
      is_set(raster_place_group, 5)), delay_row_inside_0_differs);
    delay_row_inside(1) <= choice(delay_row_inside_1_is_equals(1), raster_place_group /= 0, not
      (delay_row_inside_1_choice and delay_row_inside_1_is_equals(2)));
    delay_tag_output_column <= choice(delay_tag_newest_inside_is_equal and delay_row_inside_1_is_equals(1),
      delay_row_inside_1_choice and delay_row_inside_1_is_equals(2) and delay_tag_output_column_is_not_less and
      delay_tag_output_column_is_less, (not (delay_row_inside_1_choice and delay_row_inside_1_is_equals(2))) and
      delay_tag_output_column_is_not_less and delay_tag_output_column_is_less);
    -- rows
    rows_search_rows_read_newest <= delay_ahead;
    rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
    rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
    rows_search_rows_ready_newest <= rows_search_rows_read_newest;
    rows_reference_rows_read_newest(0) <= to_integer(delay_delayed_0(7 downto 0));
    rows_reference_rows_read_newest(1) <= to_integer(delay_delayed_0(15 downto 8));
    rows_reference_rows_read_newest(2) <= to_integer(delay_delayed_0(23 downto 16));
    rows_reference_rows_read_newest(3) <= to_integer(delay_delayed_0(31 downto 24));
    rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
    rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
    rows_reference_rows_ready_newest <= rows_reference_rows_read_newest;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag_valid <= delay_tag_valid;
    rows_read_tag_newest_inside <= delay_tag_newest_inside;
    rows_read_tag_border_column <= delay_tag_border_column;
    rows_read_tag_output_column <= delay_tag_output_column;
    rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
    rows_read_tag_end_of_line <= delay_tag_end_of_line;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag_valid <= rows_read_tag_valid;
    rows_ready_tag_newest_inside <= rows_read_tag_newest_inside;
    rows_ready_tag_border_column <= rows_read_tag_border_column;
    rows_ready_tag_output_column <= rows_read_tag_output_column;
    rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
    rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
    rows_write_column <= rows_ready_column;
    rows_search(2) <= to_integer(rows_search_rows_ready_words_0(23 downto 16));
    rows_search(3) <= to_integer(rows_search_rows_ready_words_0(31 downto 24));
    rows_search(4) <= rows_search_rows_ready_words_1;
    rows_search(5) <= rows_search_rows_ready_newest(0);
    rows_reference(2) <= to_integer(rows_reference_rows_ready_words_0(23 downto 16));
    rows_reference(3) <= to_integer(rows_reference_rows_ready_words_0(31 downto 24));
    rows_reference(4) <= rows_reference_rows_ready_words_1;
    rows_reference(5) <= rows_reference_rows_ready_newest(0);
    rows_tag_valid <= rows_ready_tag_valid;
    rows_tag_newest_inside <= rows_ready_tag_newest_inside;
    rows_tag_border_column <= rows_ready_tag_border_column;
    rows_tag_output_column <= rows_ready_tag_output_column;
    rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
    rows_tag_end_of_line <= rows_ready_tag_end_of_line;
    for i in 0 to 1 loop
      rows_search(i) <= choice(rows_ready_inside(i), to_integer(rows_search_rows_ready_words_0(8 * i + 7 downto 8 *
        i)), 0);
      rows_reference(i) <= choice(rows_ready_inside(i), to_integer(rows_reference_rows_ready_words_0(8 * i + 7 downto 8
        * i)), 0);
    end loop;
    if rows_ready_tag_valid then
      rows_search_rows_write_words_0 <= to_unsigned(rows_search_rows_ready_newest(2), 8) &
        to_unsigned(rows_search_rows_ready_newest(1), 8) & to_unsigned(rows_search_rows_ready_newest(0), 8) &
        to_unsigned(rows_search_rows_ready_words_1, 8);
      rows_search_rows_write_words_1 <= rows_search_rows_ready_newest(3);
      rows_reference_rows_write_words_0 <= to_unsigned(rows_reference_rows_ready_newest(2), 8) &
        to_unsigned(rows_reference_rows_ready_newest(1), 8) & to_unsigned(rows_reference_rows_ready_newest(0), 8) &
        to_unsigned(rows_reference_rows_ready_words_1, 8);
      rows_reference_rows_write_words_1 <= rows_reference_rows_ready_newest(3);
    end if;
    -- slice0shift
    if rows_tag_valid then
      for i in 0 to 5 loop
        for j in 0 to 23 loop slice0shift_search(i, j) <= slice0shift_search(i, j + 1); end loop;
        slice0shift_search(i, 24) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    for i in 0 to 5 loop slice0shift_search_out(i) <= slice0shift_search(i, 0); end loop;
    slice0shift_tag_valid <= rows_tag_valid;
    slice0shift_tag_newest_inside <= rows_tag_newest_inside;
    slice0shift_tag_border_column <= rows_tag_border_column;
    slice0shift_tag_output_column <= rows_tag_output_column;
    slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
    slice0shift_tag_end_of_line <= rows_tag_end_of_line;
    -- slice0cost
    if rows_ready_tag_valid then slice0cost_signs_column <= rows_ready_column; end if;
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
    slice0cost_difference_value(3, 0) := is_set(slice0shift_tag_newest_inside, 1);
    slice0cost_difference_value(4, 0) := is_set(slice0shift_tag_newest_inside, 2);
    for i in 0 to 24 loop
      slice0cost_difference_difference(4, i) := slice0shift_search(4, i) - slice0shift_reference(4);
    end loop;
    for i in 0 to 24 loop
      slice0cost_difference_difference(5, i) := slice0shift_search(5, i) - slice0shift_reference(5);
    end loop;
    for i in 0 to 24 loop
      slice0cost_pair_is_less(0, i) := slice0cost_differences(2, i) < 0;
      slice0cost_pair_folded_value(0, i) := folded(slice0cost_differences(2, i));
    end loop;
    for i in 0 to 24 loop
      slice0cost_pair_folded_value(1, i) := folded(slice0cost_differences(3, i));
      slice0cost_pair_is_less(1, i) := slice0cost_differences(3, i) < 0;
    end loop;
    slice0cost_signs_next_column <= rows_write_column;
    slice0cost_signs_difference_column <= slice0cost_signs_next_column;
    slice0cost_signs_ready_words(0) <= to_integer(slice0cost_signs_read_words(0));
    slice0cost_signs_ready_words(1) <= to_integer(slice0cost_signs_read_words(1));
    slice0cost_signs_write_column <= slice0cost_signs_difference_column;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice0cost_difference(i, j) <= (slice0cost_difference_choice(i, j, 1) - slice0cost_difference_choice(i, j, 2))
          mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop slice0cost_newest_negative(2, i) <= slice0cost_difference_difference(4, i) < 0; end loop;
    for i in 0 to 24 loop slice0cost_newest_negative(3, i) <= slice0cost_difference_difference(5, i) < 0; end loop;
    slice0cost_difference_tag_valid <= slice0shift_tag_valid;
    slice0cost_difference_tag_newest_inside <= slice0shift_tag_newest_inside;
    slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
    slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
    slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
    slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
    for i in 0 to 24 loop
      slice0cost_pair(0, i) <= as_number(slice0cost_pair_is_less(0, i)) + slice0cost_difference(1, i) +
        slice0cost_pair_folded_value(0, i);
    end loop;
    for i in 0 to 24 loop
      slice0cost_pair(1, i) <= folded(slice0cost_differences(4, i)) + slice0cost_pair_folded_value(1, i) +
        as_number(slice0cost_pair_is_less(1, i));
    end loop;
    for i in 0 to 24 loop slice0cost_negative_1(i) <= slice0cost_differences(4, i) < 0; end loop;
    for i in 0 to 24 loop slice0cost_single_0(i) <= slice0cost_difference(0, i); end loop;
    for i in 0 to 24 loop
      slice0cost_single(2, i) <= (slice0cost_pair_folded_value(0, i) + as_number(slice0cost_pair_is_less(0, i))) mod
        256;
    end loop;
    for i in 0 to 24 loop slice0cost_single(3, i) <= slice0cost_pair_folded_value(1, i); end loop;
    for i in 0 to 24 loop
      slice0cost_single_5(i) <= (folded(slice0cost_differences(5, i)) + as_number((slice0cost_differences(5, i) < 0)))
        mod 256;
    end loop;
    for i in 0 to 24 loop slice0cost_single_negative_3(i) <= slice0cost_pair_is_less(1, i); end loop;
    slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
    slice0cost_pair_tag_newest_inside <= slice0cost_difference_tag_newest_inside;
    slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
    slice0cost_pair_tag_output_column <= slice0cost_difference_tag_output_column;
    slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
    slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
    slice0cost_tag_valid <= slice0cost_pair_tag_valid;
    slice0cost_tag_newest_inside <= slice0cost_pair_tag_newest_inside;
    slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
    slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
    slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
    slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
    for i in 0 to 24 loop
      slice0cost_differences(2, i) <= choice(is_set(slice0shift_tag_newest_inside, 0), slice0shift_search(2, i) -
        slice0shift_reference(2), 0);
    end loop;
    for i in 0 to 24 loop
      slice0cost_differences(3, i) <= choice(slice0cost_difference_value(3, 0), slice0shift_search(3, i) -
        slice0shift_reference(3), 0);
    end loop;
    for i in 0 to 24 loop
      slice0cost_differences(4, i) <= choice(slice0cost_difference_value(4, 0), slice0cost_difference_difference(4, i),
        0);
    end loop;
    for i in 0 to 24 loop
      slice0cost_differences(5, i) <= choice(is_set(slice0shift_tag_newest_inside, 3),
        slice0cost_difference_difference(5, i), 0);
    end loop;
    for i in 0 to 24 loop
      slice0cost_column(0, i) <= choice(slice0cost_pair_tag_border_column, 0, slice0cost_pair(0, i) +
        slice0cost_single_0(i));
    end loop;
    for i in 0 to 24 loop
      slice0cost_column(1, i) <= choice(slice0cost_pair_tag_border_column, 0,
        as_number(slice0cost_single_negative_3(i)) + slice0cost_pair(0, i) + slice0cost_single(3, i));
    end loop;
    for i in 0 to 24 loop
      slice0cost_column(2, i) <= choice(slice0cost_pair_tag_border_column, 0, slice0cost_pair(1, i) +
        as_number(slice0cost_negative_1(i)) + slice0cost_single(2, i));
    end loop;
    for i in 0 to 24 loop
      slice0cost_column(3, i) <= choice(slice0cost_pair_tag_border_column, 0, slice0cost_pair(1, i) +
        as_number(slice0cost_negative_1(i)) + slice0cost_single_5(i));
    end loop;
    if slice0cost_difference_tag_valid then
      for i in 0 to 1 loop
        slice0cost_signs_write_words(i) <= (as_number(slice0cost_newest_negative(i + 2, 23)) * 8388608) +
          (as_number(slice0cost_newest_negative(i + 2, 24)) * 16777216) + (as_number(slice0cost_newest_negative(i + 2,
          22)) * 4194304) + (as_number(slice0cost_newest_negative(i + 2, 21)) * 2097152) +
          (as_number(slice0cost_newest_negative(i + 2, 20)) * 1048576) + (as_number(slice0cost_newest_negative(i + 2,
          19)) * 524288) + (as_number(slice0cost_newest_negative(i + 2, 18)) * 262144) +
          (as_number(slice0cost_newest_negative(i + 2, 17)) * 131072) + (as_number(slice0cost_newest_negative(i + 2,
          16)) * 65536) + (as_number(slice0cost_newest_negative(i + 2, 15)) * 32768) +
          (as_number(slice0cost_newest_negative(i + 2, 14)) * 16384) + (as_number(slice0cost_newest_negative(i + 2,
          13)) * 8192) + (as_number(slice0cost_newest_negative(i + 2, 12)) * 4096) +
          (as_number(slice0cost_newest_negative(i + 2, 11)) * 2048) + (as_number(slice0cost_newest_negative(i + 2, 10))
          * 1024) + (as_number(slice0cost_newest_negative(i + 2, 9)) * 512) + (as_number(slice0cost_newest_negative(i +
          2, 8)) * 256) + (as_number(slice0cost_newest_negative(i + 2, 6)) * 64) +
          (as_number(slice0cost_newest_negative(i + 2, 7)) * 128) + (as_number(slice0cost_newest_negative(i + 2, 5)) *
          32) + (as_number(slice0cost_newest_negative(i + 2, 4)) * 16) + (as_number(slice0cost_newest_negative(i + 2,
          3)) * 8) + (as_number(slice0cost_newest_negative(i + 2, 2)) * 4) + as_number(slice0cost_newest_negative(i +
          2, 0)) + (as_number(slice0cost_newest_negative(i + 2, 1)) * 2);
      end loop;
    end if;
    -- slice0window
    if slice0cost_tag_valid then
      for i in 0 to 24 loop slice0window_partial_0_0(i) <= slice0cost_column(0, i); end loop;
      for i in 0 to 24 loop
        slice0window_partial_0_1(i) <= slice0cost_column(0, i) + slice0window_partial_0_0(i);
      end loop;
      for i in 1 to 3 loop
        for j in 0 to 24 loop slice0window_partial_0(i, j) <= slice0cost_column(i, j); end loop;
        for j in 0 to 24 loop
          slice0window_partial_1(i, j) <= slice0cost_column(i, j) + slice0window_partial_0(i, j);
        end loop;
      end loop;
    end if;
    slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
    slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
    slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
    for i in 0 to 24 loop slice0window_sum(0, i) <= slice0cost_column(0, i) + slice0window_partial_0_1(i); end loop;
    for i in 1 to 3 loop
      for j in 0 to 24 loop slice0window_sum(i, j) <= slice0cost_column(i, j) + slice0window_partial_1(i, j); end loop;
    end loop;
    slice0window_tag.valid <= slice0cost_tag_valid;
    slice0window_tag.output_column <= slice0window_centre_output_column_0;
    slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame_0;
    slice0window_tag.end_of_line <= slice0window_centre_end_of_line_0;
    -- slice0winner1
    for i in 0 to 3 loop
      for j in 0 to 11 loop
        slice0winner1_best_cost_is_less(i, j) := (slice0window_sum(i, 2 * j + 1) - slice0window_sum(i, 2 * j)) < 0;
      end loop;
    end loop;
    slice0winner1_best_cost(0, 12) <= slice0window_sum(0, 24);
    slice0winner1_best_cost(1, 12) <= slice0window_sum(1, 24);
    slice0winner1_best_cost(2, 12) <= slice0window_sum(2, 24);
    slice0winner1_best_cost(3, 12) <= slice0window_sum(3, 24);
    slice0winner1_best_index_0(0) <= slice0winner1_best_cost_is_less(0, 0);
    slice0winner1_best_index_0_12 <= 24;
    slice0winner1_best_index_0(1) <= slice0winner1_best_cost_is_less(1, 0);
    slice0winner1_best_index_0(2) <= slice0winner1_best_cost_is_less(2, 0);
    slice0winner1_best_index_0(3) <= slice0winner1_best_cost_is_less(3, 0);
    slice0winner1_tag <= slice0window_tag;
    for i in 0 to 3 loop
      slice0winner1_best_cost(i, 0) <= choice(slice0winner1_best_cost_is_less(i, 0), slice0window_sum(i, 1),
        slice0window_sum(i, 0));
      for j in 1 to 11 loop
        slice0winner1_best_cost(i, j) <= choice(slice0winner1_best_cost_is_less(i, j), slice0window_sum(i, 2 * j + 1),
          slice0window_sum(i, 2 * j));
        slice0winner1_best_index(i, j) <= choice(slice0winner1_best_cost_is_less(i, j), 2 * j + 1, 2 * j);
      end loop;
    end loop;
    -- slice0winner2
    for i in 0 to 3 loop
      for j in 0 to 5 loop
        slice0winner2_best_cost_is_less(i, j) := (slice0winner1_best_cost(i, 2 * j + 1) - slice0winner1_best_cost(i, 2
          * j)) < 0;
      end loop;
    end loop;
    slice0winner2_best_cost(0, 6) <= slice0winner1_best_cost(0, 12);
    slice0winner2_best_cost(1, 6) <= slice0winner1_best_cost(1, 12);
    slice0winner2_best_cost(2, 6) <= slice0winner1_best_cost(2, 12);
    slice0winner2_best_cost(3, 6) <= slice0winner1_best_cost(3, 12);
    slice0winner2_best_index_0(6) <= slice0winner1_best_index_0_12;
    slice0winner2_tag.valid <= slice0winner1_tag.valid;
    slice0winner2_best_cost(0, 0) <= choice(slice0winner2_best_cost_is_less(0, 0), slice0winner1_best_cost(0, 1),
      slice0winner1_best_cost(0, 0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_is_less(0, 0), slice0winner1_best_index(0, 1),
      as_number(slice0winner1_best_index_0(0)));
    for i in 1 to 5 loop
      slice0winner2_best_cost(0, i) <= choice(slice0winner2_best_cost_is_less(0, i), slice0winner1_best_cost(0, 2 * i +
        1), slice0winner1_best_cost(0, 2 * i));
      slice0winner2_best_index_0(i) <= choice(slice0winner2_best_cost_is_less(0, i), slice0winner1_best_index(0, 2 * i
        + 1), slice0winner1_best_index(0, 2 * i));
    end loop;
    for i in 1 to 3 loop
      slice0winner2_best_cost(i, 0) <= choice(slice0winner2_best_cost_is_less(i, 0), slice0winner1_best_cost(i, 1),
        slice0winner1_best_cost(i, 0));
      slice0winner2_best_index(i, 0) <= choice(slice0winner2_best_cost_is_less(i, 0), slice0winner1_best_index(i, 1),
        as_number(slice0winner1_best_index_0(i)));
      for j in 1 to 5 loop
        slice0winner2_best_cost(i, j) <= choice(slice0winner2_best_cost_is_less(i, j), slice0winner1_best_cost(i, 2 * j
          + 1), slice0winner1_best_cost(i, 2 * j));
        slice0winner2_best_index(i, j) <= choice(slice0winner2_best_cost_is_less(i, j), slice0winner1_best_index(i, 2 *
          j + 1), slice0winner1_best_index(i, 2 * j));
      end loop;
    end loop;
    if slice0winner2_tag.valid then
      slice0winner2_tag.output_column <= slice0winner1_tag.output_column;
      slice0winner2_tag.start_of_frame <= slice0winner1_tag.start_of_frame;
      slice0winner2_tag.end_of_line <= slice0winner1_tag.end_of_line;
    end if;
    -- slice0winner3
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        slice0winner3_best_cost_is_less(i, j) := (slice0winner2_best_cost(i, 2 * j + 1) - slice0winner2_best_cost(i, 2
          * j)) < 0;
      end loop;
    end loop;
    slice0winner3_best_cost(0, 3) <= slice0winner2_best_cost(0, 6);
    slice0winner3_best_cost(1, 3) <= slice0winner2_best_cost(1, 6);
    slice0winner3_best_cost(2, 3) <= slice0winner2_best_cost(2, 6);
    slice0winner3_best_cost(3, 3) <= slice0winner2_best_cost(3, 6);
    slice0winner3_best_index_0(3) <= slice0winner2_best_index_0(6);
    slice0winner3_tag <= slice0winner2_tag;
    for i in 0 to 2 loop
      slice0winner3_best_cost(0, i) <= choice(slice0winner3_best_cost_is_less(0, i), slice0winner2_best_cost(0, 2 * i +
        1), slice0winner2_best_cost(0, 2 * i));
      slice0winner3_best_index_0(i) <= choice(slice0winner3_best_cost_is_less(0, i), slice0winner2_best_index_0(2 * i +
        1), slice0winner2_best_index_0(2 * i));
    end loop;
    for i in 1 to 3 loop
      for j in 0 to 2 loop
        slice0winner3_best_cost(i, j) <= choice(slice0winner3_best_cost_is_less(i, j), slice0winner2_best_cost(i, 2 * j
          + 1), slice0winner2_best_cost(i, 2 * j));
        slice0winner3_best_index(i, j) <= choice(slice0winner3_best_cost_is_less(i, j), slice0winner2_best_index(i, 2 *
          j + 1), slice0winner2_best_index(i, 2 * j));
      end loop;
    end loop;
    -- slice0winner4
    for i in 0 to 3 loop
      slice0winner4_best_cost_is_less(i, 0) := (slice0winner3_best_cost(i, 1) - slice0winner3_best_cost(i, 0)) < 0;
      slice0winner4_best_cost_is_less(i, 1) := (slice0winner3_best_cost(i, 3) - slice0winner3_best_cost(i, 2)) < 0;
    end loop;
    slice0winner4_tag <= slice0winner3_tag;
    slice0winner4_best_cost(0, 0) <= choice(slice0winner4_best_cost_is_less(0, 0), slice0winner3_best_cost(0, 1),
      slice0winner3_best_cost(0, 0));
    slice0winner4_best_index_0(0) <= choice(slice0winner4_best_cost_is_less(0, 0), slice0winner3_best_index_0(1),
      slice0winner3_best_index_0(0));
    slice0winner4_best_cost(0, 1) <= choice(slice0winner4_best_cost_is_less(0, 1), slice0winner3_best_cost(0, 3),
      slice0winner3_best_cost(0, 2));
    slice0winner4_best_index_1(0) <= choice(slice0winner4_best_cost_is_less(0, 1), slice0winner3_best_index_0(3),
      slice0winner3_best_index_0(2));
    for i in 1 to 3 loop
      slice0winner4_best_cost(i, 0) <= choice(slice0winner4_best_cost_is_less(i, 0), slice0winner3_best_cost(i, 1),
        slice0winner3_best_cost(i, 0));
      slice0winner4_best_index_0(i) <= choice(slice0winner4_best_cost_is_less(i, 0), slice0winner3_best_index(i, 1),
        slice0winner3_best_index(i, 0));
      slice0winner4_best_cost(i, 1) <= choice(slice0winner4_best_cost_is_less(i, 1), slice0winner3_best_cost(i, 3),
        slice0winner3_best_cost(i, 2));
      slice0winner4_best_index_1(i) <= choice(slice0winner4_best_cost_is_less(i, 1), slice0winner3_best_index_0(3),
        slice0winner3_best_index(i, 2));
    end loop;
    -- slice0winner5
    for i in 0 to 3 loop
      slice0winner5_best_cost_0_is_less(i) := (slice0winner4_best_cost(i, 1) - slice0winner4_best_cost(i, 0)) < 0;
    end loop;
    slice0winner5_tag <= slice0winner4_tag;
    for i in 0 to 3 loop
      slice0winner5_best_cost_0(i) <= choice(slice0winner5_best_cost_0_is_less(i), slice0winner4_best_cost(i, 1),
        slice0winner4_best_cost(i, 0));
      slice0winner5_best_index_0(i) <= choice(slice0winner5_best_cost_0_is_less(i), slice0winner4_best_index_1(i),
        slice0winner4_best_index_0(i));
    end loop;
    -- slice0
    slice0_best_cost_0 <= slice0winner5_best_cost_0;
    slice0_best_index_0(0) <= slice0winner5_best_index_0(0) + 75;
    slice0_best_index_0(1) <= slice0winner5_best_index_0(1) + 75;
    slice0_best_index_0(2) <= slice0winner5_best_index_0(2) + 75;
    slice0_best_index_0(3) <= slice0winner5_best_index_0(3) + 75;
    slice0_best_tag <= slice0winner5_tag;
    -- slice1shift
    if slice0shift_tag_valid then
      for i in 0 to 5 loop
        for j in 0 to 23 loop slice1shift_search(i, j) <= slice1shift_search(i, j + 1); end loop;
        slice1shift_search(i, 24) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    for i in 0 to 5 loop slice1shift_search_out(i) <= slice1shift_search(i, 0); end loop;
    -- slice1cost
    if slice0cost_difference_tag_valid then
      slice1cost_signs_difference_column <= slice0cost_signs_difference_column;
    end if;
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
    slice1cost_difference_value(3, 0) := is_set(slice0cost_difference_tag_newest_inside, 1);
    slice1cost_difference_value(4, 0) := is_set(slice0cost_difference_tag_newest_inside, 2);
    for i in 0 to 24 loop
      slice1cost_difference_difference(4, i) := slice1shift_search(4, i) - slice1shift_reference(4);
    end loop;
    for i in 0 to 24 loop
      slice1cost_difference_difference(5, i) := slice1shift_search(5, i) - slice1shift_reference(5);
    end loop;
    for i in 0 to 24 loop
      slice1cost_pair_is_less(0, i) := slice1cost_differences(2, i) < 0;
      slice1cost_pair_folded_value(0, i) := folded(slice1cost_differences(2, i));
    end loop;
    for i in 0 to 24 loop
      slice1cost_pair_folded_value(1, i) := folded(slice1cost_differences(3, i));
      slice1cost_pair_is_less(1, i) := slice1cost_differences(3, i) < 0;
    end loop;
    slice1cost_signs_ready_words(0) <= to_integer(slice1cost_signs_read_words(0));
    slice1cost_signs_ready_words(1) <= to_integer(slice1cost_signs_read_words(1));
    slice1cost_signs_write_column <= slice0cost_signs_write_column;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice1cost_difference(i, j) <= (slice1cost_difference_choice(i, j, 1) - slice1cost_difference_choice(i, j, 2))
          mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop slice1cost_newest_negative(2, i) <= slice1cost_difference_difference(4, i) < 0; end loop;
    for i in 0 to 24 loop slice1cost_newest_negative(3, i) <= slice1cost_difference_difference(5, i) < 0; end loop;
    for i in 0 to 24 loop
      slice1cost_pair(0, i) <= as_number(slice1cost_pair_is_less(0, i)) + slice1cost_difference(1, i) +
        slice1cost_pair_folded_value(0, i);
    end loop;
    for i in 0 to 24 loop
      slice1cost_pair(1, i) <= folded(slice1cost_differences(4, i)) + slice1cost_pair_folded_value(1, i) +
        as_number(slice1cost_pair_is_less(1, i));
    end loop;
    for i in 0 to 24 loop slice1cost_negative_1(i) <= slice1cost_differences(4, i) < 0; end loop;
    for i in 0 to 24 loop slice1cost_single_0(i) <= slice1cost_difference(0, i); end loop;
    for i in 0 to 24 loop
      slice1cost_single(2, i) <= (slice1cost_pair_folded_value(0, i) + as_number(slice1cost_pair_is_less(0, i))) mod
        256;
    end loop;
    for i in 0 to 24 loop slice1cost_single(3, i) <= slice1cost_pair_folded_value(1, i); end loop;
    for i in 0 to 24 loop
      slice1cost_single_5(i) <= (folded(slice1cost_differences(5, i)) + as_number((slice1cost_differences(5, i) < 0)))
        mod 256;
    end loop;
    for i in 0 to 24 loop slice1cost_single_negative_3(i) <= slice1cost_pair_is_less(1, i); end loop;
    slice1cost_tag_border_column <= slice0cost_tag_border_column;
    for i in 0 to 24 loop
      slice1cost_differences(2, i) <= choice(is_set(slice0cost_difference_tag_newest_inside, 0), slice1shift_search(2,
        i) - slice1shift_reference(2), 0);
    end loop;
    for i in 0 to 24 loop
      slice1cost_differences(3, i) <= choice(slice1cost_difference_value(3, 0), slice1shift_search(3, i) -
        slice1shift_reference(3), 0);
    end loop;
    for i in 0 to 24 loop
      slice1cost_differences(4, i) <= choice(slice1cost_difference_value(4, 0), slice1cost_difference_difference(4, i),
        0);
    end loop;
    for i in 0 to 24 loop
      slice1cost_differences(5, i) <= choice(is_set(slice0cost_difference_tag_newest_inside, 3),
        slice1cost_difference_difference(5, i), 0);
    end loop;
    for i in 0 to 24 loop
      slice1cost_column(0, i) <= choice(slice0cost_tag_border_column, 0, slice1cost_pair(0, i) +
        slice1cost_single_0(i));
    end loop;
    for i in 0 to 24 loop
      slice1cost_column(1, i) <= choice(slice0cost_tag_border_column, 0, as_number(slice1cost_single_negative_3(i)) +
        slice1cost_pair(0, i) + slice1cost_single(3, i));
    end loop;
    for i in 0 to 24 loop
      slice1cost_column(2, i) <= choice(slice0cost_tag_border_column, 0, slice1cost_pair(1, i) +
        as_number(slice1cost_negative_1(i)) + slice1cost_single(2, i));
    end loop;
    for i in 0 to 24 loop
      slice1cost_column(3, i) <= choice(slice0cost_tag_border_column, 0, slice1cost_pair(1, i) +
        as_number(slice1cost_negative_1(i)) + slice1cost_single_5(i));
    end loop;
    if slice0cost_pair_tag_valid then
      for i in 0 to 1 loop
        slice1cost_signs_write_words(i) <= (as_number(slice1cost_newest_negative(i + 2, 23)) * 8388608) +
          (as_number(slice1cost_newest_negative(i + 2, 24)) * 16777216) + (as_number(slice1cost_newest_negative(i + 2,
          22)) * 4194304) + (as_number(slice1cost_newest_negative(i + 2, 21)) * 2097152) +
          (as_number(slice1cost_newest_negative(i + 2, 20)) * 1048576) + (as_number(slice1cost_newest_negative(i + 2,
          19)) * 524288) + (as_number(slice1cost_newest_negative(i + 2, 18)) * 262144) +
          (as_number(slice1cost_newest_negative(i + 2, 17)) * 131072) + (as_number(slice1cost_newest_negative(i + 2,
          16)) * 65536) + (as_number(slice1cost_newest_negative(i + 2, 15)) * 32768) +
          (as_number(slice1cost_newest_negative(i + 2, 14)) * 16384) + (as_number(slice1cost_newest_negative(i + 2,
          13)) * 8192) + (as_number(slice1cost_newest_negative(i + 2, 12)) * 4096) +
          (as_number(slice1cost_newest_negative(i + 2, 11)) * 2048) + (as_number(slice1cost_newest_negative(i + 2, 10))
          * 1024) + (as_number(slice1cost_newest_negative(i + 2, 9)) * 512) + (as_number(slice1cost_newest_negative(i +
          2, 8)) * 256) + (as_number(slice1cost_newest_negative(i + 2, 6)) * 64) +
          (as_number(slice1cost_newest_negative(i + 2, 7)) * 128) + (as_number(slice1cost_newest_negative(i + 2, 5)) *
          32) + (as_number(slice1cost_newest_negative(i + 2, 4)) * 16) + (as_number(slice1cost_newest_negative(i + 2,
          3)) * 8) + (as_number(slice1cost_newest_negative(i + 2, 2)) * 4) + as_number(slice1cost_newest_negative(i +
          2, 0)) + (as_number(slice1cost_newest_negative(i + 2, 1)) * 2);
      end loop;
    end if;
    -- slice1window
    if slice0window_tag.valid then
      for i in 0 to 24 loop slice1window_partial_0_0(i) <= slice1cost_column(0, i); end loop;
      for i in 0 to 24 loop
        slice1window_partial_0_1(i) <= slice1cost_column(0, i) + slice1window_partial_0_0(i);
      end loop;
      for i in 1 to 3 loop
        for j in 0 to 24 loop slice1window_partial_0(i, j) <= slice1cost_column(i, j); end loop;
        for j in 0 to 24 loop
          slice1window_partial_1(i, j) <= slice1cost_column(i, j) + slice1window_partial_0(i, j);
        end loop;
      end loop;
    end if;
    for i in 0 to 24 loop slice1window_sum(0, i) <= slice1cost_column(0, i) + slice1window_partial_0_1(i); end loop;
    for i in 1 to 3 loop
      for j in 0 to 24 loop slice1window_sum(i, j) <= slice1cost_column(i, j) + slice1window_partial_1(i, j); end loop;
    end loop;
    -- slice1winner1
    for i in 0 to 3 loop
      for j in 0 to 11 loop
        slice1winner1_best_cost_is_less(i, j) := (slice1window_sum(i, 2 * j + 1) - slice1window_sum(i, 2 * j)) < 0;
      end loop;
    end loop;
    slice1winner1_best_cost(0, 12) <= slice1window_sum(0, 24);
    slice1winner1_best_cost(1, 12) <= slice1window_sum(1, 24);
    slice1winner1_best_cost(2, 12) <= slice1window_sum(2, 24);
    slice1winner1_best_cost(3, 12) <= slice1window_sum(3, 24);
    slice1winner1_best_index_0(0) <= slice1winner1_best_cost_is_less(0, 0);
    slice1winner1_best_index_0(1) <= slice1winner1_best_cost_is_less(1, 0);
    slice1winner1_best_index_0(2) <= slice1winner1_best_cost_is_less(2, 0);
    slice1winner1_best_index_0(3) <= slice1winner1_best_cost_is_less(3, 0);
    for i in 0 to 3 loop
      slice1winner1_best_cost(i, 0) <= choice(slice1winner1_best_cost_is_less(i, 0), slice1window_sum(i, 1),
        slice1window_sum(i, 0));
      slice1winner1_best_cost(i, 1) <= choice(slice1winner1_best_cost_is_less(i, 1), slice1window_sum(i, 3),
        slice1window_sum(i, 2));
      slice1winner1_best_index_1(i) <= choice(slice1winner1_best_cost_is_less(i, 1), 3, 2);
      slice1winner1_best_cost(i, 2) <= choice(slice1winner1_best_cost_is_less(i, 2), slice1window_sum(i, 5),
        slice1window_sum(i, 4));
      slice1winner1_best_index_2(i) <= choice(slice1winner1_best_cost_is_less(i, 2), 5, 4);
      slice1winner1_best_cost(i, 3) <= choice(slice1winner1_best_cost_is_less(i, 3), slice1window_sum(i, 7),
        slice1window_sum(i, 6));
      slice1winner1_best_index_3(i) <= choice(slice1winner1_best_cost_is_less(i, 3), 7, 6);
      slice1winner1_best_cost(i, 4) <= choice(slice1winner1_best_cost_is_less(i, 4), slice1window_sum(i, 9),
        slice1window_sum(i, 8));
      slice1winner1_best_index_4(i) <= choice(slice1winner1_best_cost_is_less(i, 4), 9, 8);
      slice1winner1_best_cost(i, 5) <= choice(slice1winner1_best_cost_is_less(i, 5), slice1window_sum(i, 11),
        slice1window_sum(i, 10));
      slice1winner1_best_index_5(i) <= choice(slice1winner1_best_cost_is_less(i, 5), 11, 10);
      slice1winner1_best_cost(i, 6) <= choice(slice1winner1_best_cost_is_less(i, 6), slice1window_sum(i, 13),
        slice1window_sum(i, 12));
      slice1winner1_best_index_6(i) <= choice(slice1winner1_best_cost_is_less(i, 6), 13, 12);
      slice1winner1_best_cost(i, 7) <= choice(slice1winner1_best_cost_is_less(i, 7), slice1window_sum(i, 15),
        slice1window_sum(i, 14));
      slice1winner1_best_index_7(i) <= choice(slice1winner1_best_cost_is_less(i, 7), 15, 14);
      slice1winner1_best_cost(i, 8) <= choice(slice1winner1_best_cost_is_less(i, 8), slice1window_sum(i, 17),
        slice1window_sum(i, 16));
      slice1winner1_best_index_8(i) <= choice(slice1winner1_best_cost_is_less(i, 8), 17, 16);
      slice1winner1_best_cost(i, 9) <= choice(slice1winner1_best_cost_is_less(i, 9), slice1window_sum(i, 19),
        slice1window_sum(i, 18));
      slice1winner1_best_index_9(i) <= choice(slice1winner1_best_cost_is_less(i, 9), 19, 18);
      slice1winner1_best_cost(i, 10) <= choice(slice1winner1_best_cost_is_less(i, 10), slice1window_sum(i, 21),
        slice1window_sum(i, 20));
      slice1winner1_best_index_10(i) <= choice(slice1winner1_best_cost_is_less(i, 10), 21, 20);
      slice1winner1_best_cost(i, 11) <= choice(slice1winner1_best_cost_is_less(i, 11), slice1window_sum(i, 23),
        slice1window_sum(i, 22));
      slice1winner1_best_index_11(i) <= choice(slice1winner1_best_cost_is_less(i, 11), 23, 22);
    end loop;
    -- slice1winner2
    for i in 0 to 3 loop
      for j in 0 to 5 loop
        slice1winner2_best_cost_is_less(i, j) := (slice1winner1_best_cost(i, 2 * j + 1) - slice1winner1_best_cost(i, 2
          * j)) < 0;
      end loop;
    end loop;
    slice1winner2_best_cost(0, 6) <= slice1winner1_best_cost(0, 12);
    slice1winner2_best_cost(1, 6) <= slice1winner1_best_cost(1, 12);
    slice1winner2_best_cost(2, 6) <= slice1winner1_best_cost(2, 12);
    slice1winner2_best_cost(3, 6) <= slice1winner1_best_cost(3, 12);
    for i in 0 to 3 loop
      slice1winner2_best_cost(i, 0) <= choice(slice1winner2_best_cost_is_less(i, 0), slice1winner1_best_cost(i, 1),
        slice1winner1_best_cost(i, 0));
      slice1winner2_best_index_0(i) <= choice(slice1winner2_best_cost_is_less(i, 0), slice1winner1_best_index_1(i),
        as_number(slice1winner1_best_index_0(i)));
      slice1winner2_best_cost(i, 1) <= choice(slice1winner2_best_cost_is_less(i, 1), slice1winner1_best_cost(i, 3),
        slice1winner1_best_cost(i, 2));
      slice1winner2_best_index_1(i) <= choice(slice1winner2_best_cost_is_less(i, 1), slice1winner1_best_index_3(i),
        slice1winner1_best_index_2(i));
      slice1winner2_best_cost(i, 2) <= choice(slice1winner2_best_cost_is_less(i, 2), slice1winner1_best_cost(i, 5),
        slice1winner1_best_cost(i, 4));
      slice1winner2_best_index_2(i) <= choice(slice1winner2_best_cost_is_less(i, 2), slice1winner1_best_index_5(i),
        slice1winner1_best_index_4(i));
      slice1winner2_best_cost(i, 3) <= choice(slice1winner2_best_cost_is_less(i, 3), slice1winner1_best_cost(i, 7),
        slice1winner1_best_cost(i, 6));
      slice1winner2_best_index_3(i) <= choice(slice1winner2_best_cost_is_less(i, 3), slice1winner1_best_index_7(i),
        slice1winner1_best_index_6(i));
      slice1winner2_best_cost(i, 4) <= choice(slice1winner2_best_cost_is_less(i, 4), slice1winner1_best_cost(i, 9),
        slice1winner1_best_cost(i, 8));
      slice1winner2_best_index_4(i) <= choice(slice1winner2_best_cost_is_less(i, 4), slice1winner1_best_index_9(i),
        slice1winner1_best_index_8(i));
      slice1winner2_best_cost(i, 5) <= choice(slice1winner2_best_cost_is_less(i, 5), slice1winner1_best_cost(i, 11),
        slice1winner1_best_cost(i, 10));
      slice1winner2_best_index_5(i) <= choice(slice1winner2_best_cost_is_less(i, 5), slice1winner1_best_index_11(i),
        slice1winner1_best_index_10(i));
    end loop;
    -- slice1winner3
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        slice1winner3_best_cost_is_less(i, j) := (slice1winner2_best_cost(i, 2 * j + 1) - slice1winner2_best_cost(i, 2
          * j)) < 0;
      end loop;
    end loop;
    slice1winner3_best_cost(0, 3) <= slice1winner2_best_cost(0, 6);
    slice1winner3_best_cost(1, 3) <= slice1winner2_best_cost(1, 6);
    slice1winner3_best_cost(2, 3) <= slice1winner2_best_cost(2, 6);
    slice1winner3_best_cost(3, 3) <= slice1winner2_best_cost(3, 6);
    for i in 0 to 3 loop
      slice1winner3_best_cost(i, 0) <= choice(slice1winner3_best_cost_is_less(i, 0), slice1winner2_best_cost(i, 1),
        slice1winner2_best_cost(i, 0));
      slice1winner3_best_index_0(i) <= choice(slice1winner3_best_cost_is_less(i, 0), slice1winner2_best_index_1(i),
        slice1winner2_best_index_0(i));
      slice1winner3_best_cost(i, 1) <= choice(slice1winner3_best_cost_is_less(i, 1), slice1winner2_best_cost(i, 3),
        slice1winner2_best_cost(i, 2));
      slice1winner3_best_index_1(i) <= choice(slice1winner3_best_cost_is_less(i, 1), slice1winner2_best_index_3(i),
        slice1winner2_best_index_2(i));
      slice1winner3_best_cost(i, 2) <= choice(slice1winner3_best_cost_is_less(i, 2), slice1winner2_best_cost(i, 5),
        slice1winner2_best_cost(i, 4));
      slice1winner3_best_index_2(i) <= choice(slice1winner3_best_cost_is_less(i, 2), slice1winner2_best_index_5(i),
        slice1winner2_best_index_4(i));
    end loop;
    -- slice1winner4
    for i in 0 to 3 loop
      slice1winner4_best_cost_is_less(i, 0) := (slice1winner3_best_cost(i, 1) - slice1winner3_best_cost(i, 0)) < 0;
      slice1winner4_best_cost_is_less(i, 1) := (slice1winner3_best_cost(i, 3) - slice1winner3_best_cost(i, 2)) < 0;
    end loop;
    for i in 0 to 3 loop
      slice1winner4_best_cost(i, 0) <= choice(slice1winner4_best_cost_is_less(i, 0), slice1winner3_best_cost(i, 1),
        slice1winner3_best_cost(i, 0));
      slice1winner4_best_index_0(i) <= choice(slice1winner4_best_cost_is_less(i, 0), slice1winner3_best_index_1(i),
        slice1winner3_best_index_0(i));
      slice1winner4_best_cost(i, 1) <= choice(slice1winner4_best_cost_is_less(i, 1), slice1winner3_best_cost(i, 3),
        slice1winner3_best_cost(i, 2));
      slice1winner4_best_index_1(i) <= choice(slice1winner4_best_cost_is_less(i, 1), slice0winner3_best_index_0(3),
        slice1winner3_best_index_2(i));
    end loop;
    -- slice1winner5
    for i in 0 to 3 loop
      slice1winner5_best_cost_0_is_less(i) := (slice1winner4_best_cost(i, 1) - slice1winner4_best_cost(i, 0)) < 0;
    end loop;
    for i in 0 to 3 loop
      slice1winner5_best_cost_0(i) <= choice(slice1winner5_best_cost_0_is_less(i), slice1winner4_best_cost(i, 1),
        slice1winner4_best_cost(i, 0));
      slice1winner5_best_index_0(i) <= choice(slice1winner5_best_cost_0_is_less(i), slice1winner4_best_index_1(i),
        slice1winner4_best_index_0(i));
    end loop;
    -- slice1
    slice1_best_cost_0_is_less(0) := (slice0_best_cost_0(0) - slice1winner5_best_cost_0(0)) < 0;
    slice1_best_cost_0_is_less(1) := (slice0_best_cost_0(1) - slice1winner5_best_cost_0(1)) < 0;
    slice1_best_cost_0_is_less(2) := (slice0_best_cost_0(2) - slice1winner5_best_cost_0(2)) < 0;
    slice1_best_cost_0_is_less(3) := (slice0_best_cost_0(3) - slice1winner5_best_cost_0(3)) < 0;
    slice1_best_tag <= slice0_best_tag;
    for i in 0 to 3 loop
      slice1_best_cost_0(i) <= choice(slice1_best_cost_0_is_less(i), slice0_best_cost_0(i),
        slice1winner5_best_cost_0(i));
      slice1_best_index_0(i) <= choice(slice1_best_cost_0_is_less(i), slice0_best_index_0(i),
        (((slice1winner5_best_index_0(i) / 2) + 25) * 2) + (slice1winner5_best_index_0(i) mod 2));
    end loop;
    -- slice2shift
    if slice0cost_difference_tag_valid then
      for i in 0 to 5 loop
        for j in 0 to 23 loop slice2shift_search(i, j) <= slice2shift_search(i, j + 1); end loop;
        slice2shift_search(i, 24) <= slice1shift_search_out(i);
      end loop;
    end if;
    slice2shift_reference <= slice1shift_reference;
    for i in 0 to 5 loop slice2shift_search_out(i) <= slice2shift_search(i, 0); end loop;
    -- slice2cost
    if slice0cost_pair_tag_valid then slice2cost_signs_difference_column <= slice0cost_signs_write_column; end if;
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
    slice2cost_difference_value(3, 0) := is_set(slice0cost_pair_tag_newest_inside, 1);
    slice2cost_difference_value(4, 0) := is_set(slice0cost_pair_tag_newest_inside, 2);
    for i in 0 to 24 loop
      slice2cost_difference_difference(4, i) := slice2shift_search(4, i) - slice2shift_reference(4);
    end loop;
    for i in 0 to 24 loop
      slice2cost_difference_difference(5, i) := slice2shift_search(5, i) - slice2shift_reference(5);
    end loop;
    for i in 0 to 24 loop
      slice2cost_pair_is_less(0, i) := slice2cost_differences(2, i) < 0;
      slice2cost_pair_folded_value(0, i) := folded(slice2cost_differences(2, i));
    end loop;
    for i in 0 to 24 loop
      slice2cost_pair_folded_value(1, i) := folded(slice2cost_differences(3, i));
      slice2cost_pair_is_less(1, i) := slice2cost_differences(3, i) < 0;
    end loop;
    slice2cost_signs_ready_words(0) <= to_integer(slice2cost_signs_read_words(0));
    slice2cost_signs_ready_words(1) <= to_integer(slice2cost_signs_read_words(1));
    slice2cost_signs_write_column <= slice1cost_signs_write_column;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice2cost_difference(i, j) <= (slice2cost_difference_choice(i, j, 1) - slice2cost_difference_choice(i, j, 2))
          mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop slice2cost_newest_negative(2, i) <= slice2cost_difference_difference(4, i) < 0; end loop;
    for i in 0 to 24 loop slice2cost_newest_negative(3, i) <= slice2cost_difference_difference(5, i) < 0; end loop;
    for i in 0 to 24 loop
      slice2cost_pair(0, i) <= as_number(slice2cost_pair_is_less(0, i)) + slice2cost_difference(1, i) +
        slice2cost_pair_folded_value(0, i);
    end loop;
    for i in 0 to 24 loop
      slice2cost_pair(1, i) <= folded(slice2cost_differences(4, i)) + slice2cost_pair_folded_value(1, i) +
        as_number(slice2cost_pair_is_less(1, i));
    end loop;
    for i in 0 to 24 loop slice2cost_negative_1(i) <= slice2cost_differences(4, i) < 0; end loop;
    for i in 0 to 24 loop slice2cost_single_0(i) <= slice2cost_difference(0, i); end loop;
    for i in 0 to 24 loop
      slice2cost_single(2, i) <= (slice2cost_pair_folded_value(0, i) + as_number(slice2cost_pair_is_less(0, i))) mod
        256;
    end loop;
    for i in 0 to 24 loop slice2cost_single(3, i) <= slice2cost_pair_folded_value(1, i); end loop;
    for i in 0 to 24 loop
      slice2cost_single_5(i) <= (folded(slice2cost_differences(5, i)) + as_number((slice2cost_differences(5, i) < 0)))
        mod 256;
    end loop;
    for i in 0 to 24 loop slice2cost_single_negative_3(i) <= slice2cost_pair_is_less(1, i); end loop;
    slice2cost_tag_border_column <= slice1cost_tag_border_column;
    for i in 0 to 24 loop
      slice2cost_differences(2, i) <= choice(is_set(slice0cost_pair_tag_newest_inside, 0), slice2shift_search(2, i) -
        slice2shift_reference(2), 0);
    end loop;
    for i in 0 to 24 loop
      slice2cost_differences(3, i) <= choice(slice2cost_difference_value(3, 0), slice2shift_search(3, i) -
        slice2shift_reference(3), 0);
    end loop;
    for i in 0 to 24 loop
      slice2cost_differences(4, i) <= choice(slice2cost_difference_value(4, 0), slice2cost_difference_difference(4, i),
        0);
    end loop;
    for i in 0 to 24 loop
      slice2cost_differences(5, i) <= choice(is_set(slice0cost_pair_tag_newest_inside, 3),
        slice2cost_difference_difference(5, i), 0);
    end loop;
    for i in 0 to 24 loop
      slice2cost_column(0, i) <= choice(slice1cost_tag_border_column, 0, slice2cost_pair(0, i) +
        slice2cost_single_0(i));
    end loop;
    for i in 0 to 24 loop
      slice2cost_column(1, i) <= choice(slice1cost_tag_border_column, 0, as_number(slice2cost_single_negative_3(i)) +
        slice2cost_pair(0, i) + slice2cost_single(3, i));
    end loop;
    for i in 0 to 24 loop
      slice2cost_column(2, i) <= choice(slice1cost_tag_border_column, 0, slice2cost_pair(1, i) +
        as_number(slice2cost_negative_1(i)) + slice2cost_single(2, i));
    end loop;
    for i in 0 to 24 loop
      slice2cost_column(3, i) <= choice(slice1cost_tag_border_column, 0, slice2cost_pair(1, i) +
        as_number(slice2cost_negative_1(i)) + slice2cost_single_5(i));
    end loop;
    if slice0cost_tag_valid then
      for i in 0 to 1 loop
        slice2cost_signs_write_words(i) <= (as_number(slice2cost_newest_negative(i + 2, 23)) * 8388608) +
          (as_number(slice2cost_newest_negative(i + 2, 24)) * 16777216) + (as_number(slice2cost_newest_negative(i + 2,
          22)) * 4194304) + (as_number(slice2cost_newest_negative(i + 2, 21)) * 2097152) +
          (as_number(slice2cost_newest_negative(i + 2, 20)) * 1048576) + (as_number(slice2cost_newest_negative(i + 2,
          19)) * 524288) + (as_number(slice2cost_newest_negative(i + 2, 18)) * 262144) +
          (as_number(slice2cost_newest_negative(i + 2, 17)) * 131072) + (as_number(slice2cost_newest_negative(i + 2,
          16)) * 65536) + (as_number(slice2cost_newest_negative(i + 2, 15)) * 32768) +
          (as_number(slice2cost_newest_negative(i + 2, 14)) * 16384) + (as_number(slice2cost_newest_negative(i + 2,
          13)) * 8192) + (as_number(slice2cost_newest_negative(i + 2, 12)) * 4096) +
          (as_number(slice2cost_newest_negative(i + 2, 11)) * 2048) + (as_number(slice2cost_newest_negative(i + 2, 10))
          * 1024) + (as_number(slice2cost_newest_negative(i + 2, 9)) * 512) + (as_number(slice2cost_newest_negative(i +
          2, 8)) * 256) + (as_number(slice2cost_newest_negative(i + 2, 6)) * 64) +
          (as_number(slice2cost_newest_negative(i + 2, 7)) * 128) + (as_number(slice2cost_newest_negative(i + 2, 5)) *
          32) + (as_number(slice2cost_newest_negative(i + 2, 4)) * 16) + (as_number(slice2cost_newest_negative(i + 2,
          3)) * 8) + (as_number(slice2cost_newest_negative(i + 2, 2)) * 4) + as_number(slice2cost_newest_negative(i +
          2, 0)) + (as_number(slice2cost_newest_negative(i + 2, 1)) * 2);
      end loop;
    end if;
    -- slice2window
    if slice0winner1_tag.valid then
      for i in 0 to 24 loop slice2window_partial_0_0(i) <= slice2cost_column(0, i); end loop;
      for i in 0 to 24 loop
        slice2window_partial_0_1(i) <= slice2cost_column(0, i) + slice2window_partial_0_0(i);
      end loop;
      for i in 1 to 3 loop
        for j in 0 to 24 loop slice2window_partial_0(i, j) <= slice2cost_column(i, j); end loop;
        for j in 0 to 24 loop
          slice2window_partial_1(i, j) <= slice2cost_column(i, j) + slice2window_partial_0(i, j);
        end loop;
      end loop;
    end if;
    for i in 0 to 24 loop slice2window_sum(0, i) <= slice2cost_column(0, i) + slice2window_partial_0_1(i); end loop;
    for i in 1 to 3 loop
      for j in 0 to 24 loop slice2window_sum(i, j) <= slice2cost_column(i, j) + slice2window_partial_1(i, j); end loop;
    end loop;
    -- slice2winner1
    for i in 0 to 3 loop
      for j in 0 to 11 loop
        slice2winner1_best_cost_is_less(i, j) := (slice2window_sum(i, 2 * j + 1) - slice2window_sum(i, 2 * j)) < 0;
      end loop;
    end loop;
    slice2winner1_best_cost(0, 12) <= slice2window_sum(0, 24);
    slice2winner1_best_cost(1, 12) <= slice2window_sum(1, 24);
    slice2winner1_best_cost(2, 12) <= slice2window_sum(2, 24);
    slice2winner1_best_cost(3, 12) <= slice2window_sum(3, 24);
    slice2winner1_best_index_0(0) <= slice2winner1_best_cost_is_less(0, 0);
    slice2winner1_best_index_0(1) <= slice2winner1_best_cost_is_less(1, 0);
    slice2winner1_best_index_0(2) <= slice2winner1_best_cost_is_less(2, 0);
    slice2winner1_best_index_0(3) <= slice2winner1_best_cost_is_less(3, 0);
    for i in 0 to 3 loop
      slice2winner1_best_cost(i, 0) <= choice(slice2winner1_best_cost_is_less(i, 0), slice2window_sum(i, 1),
        slice2window_sum(i, 0));
      slice2winner1_best_cost(i, 1) <= choice(slice2winner1_best_cost_is_less(i, 1), slice2window_sum(i, 3),
        slice2window_sum(i, 2));
      slice2winner1_best_index_1(i) <= choice(slice2winner1_best_cost_is_less(i, 1), 3, 2);
      slice2winner1_best_cost(i, 2) <= choice(slice2winner1_best_cost_is_less(i, 2), slice2window_sum(i, 5),
        slice2window_sum(i, 4));
      slice2winner1_best_index_2(i) <= choice(slice2winner1_best_cost_is_less(i, 2), 5, 4);
      slice2winner1_best_cost(i, 3) <= choice(slice2winner1_best_cost_is_less(i, 3), slice2window_sum(i, 7),
        slice2window_sum(i, 6));
      slice2winner1_best_index_3(i) <= choice(slice2winner1_best_cost_is_less(i, 3), 7, 6);
      slice2winner1_best_cost(i, 4) <= choice(slice2winner1_best_cost_is_less(i, 4), slice2window_sum(i, 9),
        slice2window_sum(i, 8));
      slice2winner1_best_index_4(i) <= choice(slice2winner1_best_cost_is_less(i, 4), 9, 8);
      slice2winner1_best_cost(i, 5) <= choice(slice2winner1_best_cost_is_less(i, 5), slice2window_sum(i, 11),
        slice2window_sum(i, 10));
      slice2winner1_best_index_5(i) <= choice(slice2winner1_best_cost_is_less(i, 5), 11, 10);
      slice2winner1_best_cost(i, 6) <= choice(slice2winner1_best_cost_is_less(i, 6), slice2window_sum(i, 13),
        slice2window_sum(i, 12));
      slice2winner1_best_index_6(i) <= choice(slice2winner1_best_cost_is_less(i, 6), 13, 12);
      slice2winner1_best_cost(i, 7) <= choice(slice2winner1_best_cost_is_less(i, 7), slice2window_sum(i, 15),
        slice2window_sum(i, 14));
      slice2winner1_best_index_7(i) <= choice(slice2winner1_best_cost_is_less(i, 7), 15, 14);
      slice2winner1_best_cost(i, 8) <= choice(slice2winner1_best_cost_is_less(i, 8), slice2window_sum(i, 17),
        slice2window_sum(i, 16));
      slice2winner1_best_index_8(i) <= choice(slice2winner1_best_cost_is_less(i, 8), 17, 16);
      slice2winner1_best_cost(i, 9) <= choice(slice2winner1_best_cost_is_less(i, 9), slice2window_sum(i, 19),
        slice2window_sum(i, 18));
      slice2winner1_best_index_9(i) <= choice(slice2winner1_best_cost_is_less(i, 9), 19, 18);
      slice2winner1_best_cost(i, 10) <= choice(slice2winner1_best_cost_is_less(i, 10), slice2window_sum(i, 21),
        slice2window_sum(i, 20));
      slice2winner1_best_index_10(i) <= choice(slice2winner1_best_cost_is_less(i, 10), 21, 20);
      slice2winner1_best_cost(i, 11) <= choice(slice2winner1_best_cost_is_less(i, 11), slice2window_sum(i, 23),
        slice2window_sum(i, 22));
      slice2winner1_best_index_11(i) <= choice(slice2winner1_best_cost_is_less(i, 11), 23, 22);
    end loop;
    -- slice2winner2
    for i in 0 to 3 loop
      for j in 0 to 5 loop
        slice2winner2_best_cost_is_less(i, j) := (slice2winner1_best_cost(i, 2 * j + 1) - slice2winner1_best_cost(i, 2
          * j)) < 0;
      end loop;
    end loop;
    slice2winner2_best_cost(0, 6) <= slice2winner1_best_cost(0, 12);
    slice2winner2_best_cost(1, 6) <= slice2winner1_best_cost(1, 12);
    slice2winner2_best_cost(2, 6) <= slice2winner1_best_cost(2, 12);
    slice2winner2_best_cost(3, 6) <= slice2winner1_best_cost(3, 12);
    for i in 0 to 3 loop
      slice2winner2_best_cost(i, 0) <= choice(slice2winner2_best_cost_is_less(i, 0), slice2winner1_best_cost(i, 1),
        slice2winner1_best_cost(i, 0));
      slice2winner2_best_index_0(i) <= choice(slice2winner2_best_cost_is_less(i, 0), slice2winner1_best_index_1(i),
        as_number(slice2winner1_best_index_0(i)));
      slice2winner2_best_cost(i, 1) <= choice(slice2winner2_best_cost_is_less(i, 1), slice2winner1_best_cost(i, 3),
        slice2winner1_best_cost(i, 2));
      slice2winner2_best_index_1(i) <= choice(slice2winner2_best_cost_is_less(i, 1), slice2winner1_best_index_3(i),
        slice2winner1_best_index_2(i));
      slice2winner2_best_cost(i, 2) <= choice(slice2winner2_best_cost_is_less(i, 2), slice2winner1_best_cost(i, 5),
        slice2winner1_best_cost(i, 4));
      slice2winner2_best_index_2(i) <= choice(slice2winner2_best_cost_is_less(i, 2), slice2winner1_best_index_5(i),
        slice2winner1_best_index_4(i));
      slice2winner2_best_cost(i, 3) <= choice(slice2winner2_best_cost_is_less(i, 3), slice2winner1_best_cost(i, 7),
        slice2winner1_best_cost(i, 6));
      slice2winner2_best_index_3(i) <= choice(slice2winner2_best_cost_is_less(i, 3), slice2winner1_best_index_7(i),
        slice2winner1_best_index_6(i));
      slice2winner2_best_cost(i, 4) <= choice(slice2winner2_best_cost_is_less(i, 4), slice2winner1_best_cost(i, 9),
        slice2winner1_best_cost(i, 8));
      slice2winner2_best_index_4(i) <= choice(slice2winner2_best_cost_is_less(i, 4), slice2winner1_best_index_9(i),
        slice2winner1_best_index_8(i));
      slice2winner2_best_cost(i, 5) <= choice(slice2winner2_best_cost_is_less(i, 5), slice2winner1_best_cost(i, 11),
        slice2winner1_best_cost(i, 10));
      slice2winner2_best_index_5(i) <= choice(slice2winner2_best_cost_is_less(i, 5), slice2winner1_best_index_11(i),
        slice2winner1_best_index_10(i));
    end loop;
    -- slice2winner3
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        slice2winner3_best_cost_is_less(i, j) := (slice2winner2_best_cost(i, 2 * j + 1) - slice2winner2_best_cost(i, 2
          * j)) < 0;
      end loop;
    end loop;
    slice2winner3_best_cost(0, 3) <= slice2winner2_best_cost(0, 6);
    slice2winner3_best_cost(1, 3) <= slice2winner2_best_cost(1, 6);
    slice2winner3_best_cost(2, 3) <= slice2winner2_best_cost(2, 6);
    slice2winner3_best_cost(3, 3) <= slice2winner2_best_cost(3, 6);
    for i in 0 to 3 loop
      slice2winner3_best_cost(i, 0) <= choice(slice2winner3_best_cost_is_less(i, 0), slice2winner2_best_cost(i, 1),
        slice2winner2_best_cost(i, 0));
      slice2winner3_best_index_0(i) <= choice(slice2winner3_best_cost_is_less(i, 0), slice2winner2_best_index_1(i),
        slice2winner2_best_index_0(i));
      slice2winner3_best_cost(i, 1) <= choice(slice2winner3_best_cost_is_less(i, 1), slice2winner2_best_cost(i, 3),
        slice2winner2_best_cost(i, 2));
      slice2winner3_best_index_1(i) <= choice(slice2winner3_best_cost_is_less(i, 1), slice2winner2_best_index_3(i),
        slice2winner2_best_index_2(i));
      slice2winner3_best_cost(i, 2) <= choice(slice2winner3_best_cost_is_less(i, 2), slice2winner2_best_cost(i, 5),
        slice2winner2_best_cost(i, 4));
      slice2winner3_best_index_2(i) <= choice(slice2winner3_best_cost_is_less(i, 2), slice2winner2_best_index_5(i),
        slice2winner2_best_index_4(i));
    end loop;
    -- slice2winner4
    for i in 0 to 3 loop
      slice2winner4_best_cost_is_less(i, 0) := (slice2winner3_best_cost(i, 1) - slice2winner3_best_cost(i, 0)) < 0;
      slice2winner4_best_cost_is_less(i, 1) := (slice2winner3_best_cost(i, 3) - slice2winner3_best_cost(i, 2)) < 0;
    end loop;
    for i in 0 to 3 loop
      slice2winner4_best_cost(i, 0) <= choice(slice2winner4_best_cost_is_less(i, 0), slice2winner3_best_cost(i, 1),
        slice2winner3_best_cost(i, 0));
      slice2winner4_best_index_0(i) <= choice(slice2winner4_best_cost_is_less(i, 0), slice2winner3_best_index_1(i),
        slice2winner3_best_index_0(i));
      slice2winner4_best_cost(i, 1) <= choice(slice2winner4_best_cost_is_less(i, 1), slice2winner3_best_cost(i, 3),
        slice2winner3_best_cost(i, 2));
      slice2winner4_best_index_1(i) <= choice(slice2winner4_best_cost_is_less(i, 1), slice0winner3_best_index_0(3),
        slice2winner3_best_index_2(i));
    end loop;
    -- slice2winner5
    for i in 0 to 3 loop
      slice2winner5_best_cost_0_is_less(i) := (slice2winner4_best_cost(i, 1) - slice2winner4_best_cost(i, 0)) < 0;
    end loop;
    for i in 0 to 3 loop
      slice2winner5_best_cost_0(i) <= choice(slice2winner5_best_cost_0_is_less(i), slice2winner4_best_cost(i, 1),
        slice2winner4_best_cost(i, 0));
      slice2winner5_best_index_0(i) <= choice(slice2winner5_best_cost_0_is_less(i), slice2winner4_best_index_1(i),
        slice2winner4_best_index_0(i));
    end loop;
    -- slice2
    slice2_best_cost_0_is_less(0) := (slice1_best_cost_0(0) - slice2winner5_best_cost_0(0)) < 0;
    slice2_best_cost_0_is_less(1) := (slice1_best_cost_0(1) - slice2winner5_best_cost_0(1)) < 0;
    slice2_best_cost_0_is_less(2) := (slice1_best_cost_0(2) - slice2winner5_best_cost_0(2)) < 0;
    slice2_best_cost_0_is_less(3) := (slice1_best_cost_0(3) - slice2winner5_best_cost_0(3)) < 0;
    slice2_best_tag <= slice1_best_tag;
    for i in 0 to 3 loop
      slice2_best_cost_0(i) <= choice(slice2_best_cost_0_is_less(i), slice1_best_cost_0(i),
        slice2winner5_best_cost_0(i));
      slice2_best_index_0(i) <= choice(slice2_best_cost_0_is_less(i), slice1_best_index_0(i),
        slice2winner5_best_index_0(i) + 25);
    end loop;
    -- slice3shift
    if slice0cost_pair_tag_valid then
      for i in 0 to 5 loop
        for j in 0 to 23 loop slice3shift_search(i, j) <= slice3shift_search(i, j + 1); end loop;
        slice3shift_search(i, 24) <= slice2shift_search_out(i);
      end loop;
    end if;
    slice3shift_reference <= slice2shift_reference;
    -- slice3cost
    if slice0cost_tag_valid then slice3cost_signs_difference_column <= slice1cost_signs_write_column; end if;
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
    slice3cost_difference_value(3, 0) := is_set(slice0cost_tag_newest_inside, 1);
    slice3cost_difference_value(4, 0) := is_set(slice0cost_tag_newest_inside, 2);
    for i in 0 to 24 loop
      slice3cost_difference_difference(4, i) := slice3shift_search(4, i) - slice3shift_reference(4);
    end loop;
    for i in 0 to 24 loop
      slice3cost_difference_difference(5, i) := slice3shift_search(5, i) - slice3shift_reference(5);
    end loop;
    for i in 0 to 24 loop
      slice3cost_pair_is_less(0, i) := slice3cost_differences(2, i) < 0;
      slice3cost_pair_folded_value(0, i) := folded(slice3cost_differences(2, i));
    end loop;
    for i in 0 to 24 loop
      slice3cost_pair_folded_value(1, i) := folded(slice3cost_differences(3, i));
      slice3cost_pair_is_less(1, i) := slice3cost_differences(3, i) < 0;
    end loop;
    slice3cost_signs_ready_words(0) <= to_integer(slice3cost_signs_read_words(0));
    slice3cost_signs_ready_words(1) <= to_integer(slice3cost_signs_read_words(1));
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice3cost_difference(i, j) <= (slice3cost_difference_choice(i, j, 1) - slice3cost_difference_choice(i, j, 2))
          mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop slice3cost_newest_negative(2, i) <= slice3cost_difference_difference(4, i) < 0; end loop;
    for i in 0 to 24 loop slice3cost_newest_negative(3, i) <= slice3cost_difference_difference(5, i) < 0; end loop;
    for i in 0 to 24 loop
      slice3cost_pair(0, i) <= as_number(slice3cost_pair_is_less(0, i)) + slice3cost_difference(1, i) +
        slice3cost_pair_folded_value(0, i);
    end loop;
    for i in 0 to 24 loop
      slice3cost_pair(1, i) <= folded(slice3cost_differences(4, i)) + slice3cost_pair_folded_value(1, i) +
        as_number(slice3cost_pair_is_less(1, i));
    end loop;
    for i in 0 to 24 loop slice3cost_negative_1(i) <= slice3cost_differences(4, i) < 0; end loop;
    for i in 0 to 24 loop slice3cost_single_0(i) <= slice3cost_difference(0, i); end loop;
    for i in 0 to 24 loop
      slice3cost_single(2, i) <= (slice3cost_pair_folded_value(0, i) + as_number(slice3cost_pair_is_less(0, i))) mod
        256;
    end loop;
    for i in 0 to 24 loop slice3cost_single(3, i) <= slice3cost_pair_folded_value(1, i); end loop;
    for i in 0 to 24 loop
      slice3cost_single_5(i) <= (folded(slice3cost_differences(5, i)) + as_number((slice3cost_differences(5, i) < 0)))
        mod 256;
    end loop;
    for i in 0 to 24 loop slice3cost_single_negative_3(i) <= slice3cost_pair_is_less(1, i); end loop;
    for i in 0 to 24 loop
      slice3cost_differences(2, i) <= choice(is_set(slice0cost_tag_newest_inside, 0), slice3shift_search(2, i) -
        slice3shift_reference(2), 0);
    end loop;
    for i in 0 to 24 loop
      slice3cost_differences(3, i) <= choice(slice3cost_difference_value(3, 0), slice3shift_search(3, i) -
        slice3shift_reference(3), 0);
    end loop;
    for i in 0 to 24 loop
      slice3cost_differences(4, i) <= choice(slice3cost_difference_value(4, 0), slice3cost_difference_difference(4, i),
        0);
    end loop;
    for i in 0 to 24 loop
      slice3cost_differences(5, i) <= choice(is_set(slice0cost_tag_newest_inside, 3),
        slice3cost_difference_difference(5, i), 0);
    end loop;
    for i in 0 to 24 loop
      slice3cost_column(0, i) <= choice(slice2cost_tag_border_column, 0, slice3cost_pair(0, i) +
        slice3cost_single_0(i));
    end loop;
    for i in 0 to 24 loop
      slice3cost_column(1, i) <= choice(slice2cost_tag_border_column, 0, as_number(slice3cost_single_negative_3(i)) +
        slice3cost_pair(0, i) + slice3cost_single(3, i));
    end loop;
    for i in 0 to 24 loop
      slice3cost_column(2, i) <= choice(slice2cost_tag_border_column, 0, slice3cost_pair(1, i) +
        as_number(slice3cost_negative_1(i)) + slice3cost_single(2, i));
    end loop;
    for i in 0 to 24 loop
      slice3cost_column(3, i) <= choice(slice2cost_tag_border_column, 0, slice3cost_pair(1, i) +
        as_number(slice3cost_negative_1(i)) + slice3cost_single_5(i));
    end loop;
    if slice0window_tag.valid then
      slice3cost_signs_write_column <= slice2cost_signs_write_column;
      for i in 0 to 1 loop
        slice3cost_signs_write_words(i) <= (as_number(slice3cost_newest_negative(i + 2, 23)) * 8388608) +
          (as_number(slice3cost_newest_negative(i + 2, 24)) * 16777216) + (as_number(slice3cost_newest_negative(i + 2,
          22)) * 4194304) + (as_number(slice3cost_newest_negative(i + 2, 21)) * 2097152) +
          (as_number(slice3cost_newest_negative(i + 2, 20)) * 1048576) + (as_number(slice3cost_newest_negative(i + 2,
          19)) * 524288) + (as_number(slice3cost_newest_negative(i + 2, 18)) * 262144) +
          (as_number(slice3cost_newest_negative(i + 2, 17)) * 131072) + (as_number(slice3cost_newest_negative(i + 2,
          16)) * 65536) + (as_number(slice3cost_newest_negative(i + 2, 15)) * 32768) +
          (as_number(slice3cost_newest_negative(i + 2, 14)) * 16384) + (as_number(slice3cost_newest_negative(i + 2,
          13)) * 8192) + (as_number(slice3cost_newest_negative(i + 2, 12)) * 4096) +
          (as_number(slice3cost_newest_negative(i + 2, 11)) * 2048) + (as_number(slice3cost_newest_negative(i + 2, 10))
          * 1024) + (as_number(slice3cost_newest_negative(i + 2, 9)) * 512) + (as_number(slice3cost_newest_negative(i +
          2, 8)) * 256) + (as_number(slice3cost_newest_negative(i + 2, 6)) * 64) +
          (as_number(slice3cost_newest_negative(i + 2, 7)) * 128) + (as_number(slice3cost_newest_negative(i + 2, 5)) *
          32) + (as_number(slice3cost_newest_negative(i + 2, 4)) * 16) + (as_number(slice3cost_newest_negative(i + 2,
          3)) * 8) + (as_number(slice3cost_newest_negative(i + 2, 2)) * 4) + as_number(slice3cost_newest_negative(i +
          2, 0)) + (as_number(slice3cost_newest_negative(i + 2, 1)) * 2);
      end loop;
    end if;
    -- slice3window
    if slice0winner2_tag.valid then
      for i in 0 to 24 loop slice3window_partial_0_0(i) <= slice3cost_column(0, i); end loop;
      for i in 0 to 6 loop
        slice3window_partial_0_1(i) <= slice3cost_column(0, i) + slice3window_partial_0_0(i);
      end loop;
      for i in 7 to 24 loop
        slice3window_partial_0_1(i) <= slice3window_partial_0_0(i) + slice3cost_column(0, i);
      end loop;
      for i in 1 to 3 loop
        for j in 0 to 24 loop slice3window_partial_0(i, j) <= slice3cost_column(i, j); end loop;
        for j in 0 to 24 loop
          slice3window_partial_1(i, j) <= slice3window_partial_0(i, j) + slice3cost_column(i, j);
        end loop;
      end loop;
    end if;
    for i in 0 to 24 loop slice3window_sum(0, i) <= slice3window_partial_0_1(i) + slice3cost_column(0, i); end loop;
    for i in 1 to 3 loop
      for j in 0 to 24 loop slice3window_sum(i, j) <= slice3window_partial_1(i, j) + slice3cost_column(i, j); end loop;
    end loop;
    -- slice3winner1
    for i in 0 to 3 loop
      for j in 0 to 11 loop
        slice3winner1_best_cost_is_less(i, j) := (slice3window_sum(i, 2 * j + 1) - slice3window_sum(i, 2 * j)) < 0;
      end loop;
    end loop;
    slice3winner1_best_cost(0, 12) <= slice3window_sum(0, 24);
    slice3winner1_best_cost(1, 12) <= slice3window_sum(1, 24);
    slice3winner1_best_cost(2, 12) <= slice3window_sum(2, 24);
    slice3winner1_best_cost(3, 12) <= slice3window_sum(3, 24);
    slice3winner1_best_index_0(0) <= slice3winner1_best_cost_is_less(0, 0);
    slice3winner1_best_index_0(1) <= slice3winner1_best_cost_is_less(1, 0);
    slice3winner1_best_index_0(2) <= slice3winner1_best_cost_is_less(2, 0);
    slice3winner1_best_index_0(3) <= slice3winner1_best_cost_is_less(3, 0);
    for i in 0 to 3 loop
      slice3winner1_best_cost(i, 0) <= choice(slice3winner1_best_cost_is_less(i, 0), slice3window_sum(i, 1),
        slice3window_sum(i, 0));
      slice3winner1_best_cost(i, 1) <= choice(slice3winner1_best_cost_is_less(i, 1), slice3window_sum(i, 3),
        slice3window_sum(i, 2));
      slice3winner1_best_index_1(i) <= choice(slice3winner1_best_cost_is_less(i, 1), 3, 2);
      slice3winner1_best_cost(i, 2) <= choice(slice3winner1_best_cost_is_less(i, 2), slice3window_sum(i, 5),
        slice3window_sum(i, 4));
      slice3winner1_best_index_2(i) <= choice(slice3winner1_best_cost_is_less(i, 2), 5, 4);
      slice3winner1_best_cost(i, 3) <= choice(slice3winner1_best_cost_is_less(i, 3), slice3window_sum(i, 7),
        slice3window_sum(i, 6));
      slice3winner1_best_index_3(i) <= choice(slice3winner1_best_cost_is_less(i, 3), 7, 6);
      slice3winner1_best_cost(i, 4) <= choice(slice3winner1_best_cost_is_less(i, 4), slice3window_sum(i, 9),
        slice3window_sum(i, 8));
      slice3winner1_best_index_4(i) <= choice(slice3winner1_best_cost_is_less(i, 4), 9, 8);
      slice3winner1_best_cost(i, 5) <= choice(slice3winner1_best_cost_is_less(i, 5), slice3window_sum(i, 11),
        slice3window_sum(i, 10));
      slice3winner1_best_index_5(i) <= choice(slice3winner1_best_cost_is_less(i, 5), 11, 10);
      slice3winner1_best_cost(i, 6) <= choice(slice3winner1_best_cost_is_less(i, 6), slice3window_sum(i, 13),
        slice3window_sum(i, 12));
      slice3winner1_best_index_6(i) <= choice(slice3winner1_best_cost_is_less(i, 6), 13, 12);
      slice3winner1_best_cost(i, 7) <= choice(slice3winner1_best_cost_is_less(i, 7), slice3window_sum(i, 15),
        slice3window_sum(i, 14));
      slice3winner1_best_index_7(i) <= choice(slice3winner1_best_cost_is_less(i, 7), 15, 14);
      slice3winner1_best_cost(i, 8) <= choice(slice3winner1_best_cost_is_less(i, 8), slice3window_sum(i, 17),
        slice3window_sum(i, 16));
      slice3winner1_best_index_8(i) <= choice(slice3winner1_best_cost_is_less(i, 8), 17, 16);
      slice3winner1_best_cost(i, 9) <= choice(slice3winner1_best_cost_is_less(i, 9), slice3window_sum(i, 19),
        slice3window_sum(i, 18));
      slice3winner1_best_index_9(i) <= choice(slice3winner1_best_cost_is_less(i, 9), 19, 18);
      slice3winner1_best_cost(i, 10) <= choice(slice3winner1_best_cost_is_less(i, 10), slice3window_sum(i, 21),
        slice3window_sum(i, 20));
      slice3winner1_best_index_10(i) <= choice(slice3winner1_best_cost_is_less(i, 10), 21, 20);
      slice3winner1_best_cost(i, 11) <= choice(slice3winner1_best_cost_is_less(i, 11), slice3window_sum(i, 23),
        slice3window_sum(i, 22));
      slice3winner1_best_index_11(i) <= choice(slice3winner1_best_cost_is_less(i, 11), 23, 22);
    end loop;
    -- slice3winner2
    for i in 0 to 3 loop
      for j in 0 to 5 loop
        slice3winner2_best_cost_is_less(i, j) := (slice3winner1_best_cost(i, 2 * j + 1) - slice3winner1_best_cost(i, 2
          * j)) < 0;
      end loop;
    end loop;
    slice3winner2_best_cost(0, 6) <= slice3winner1_best_cost(0, 12);
    slice3winner2_best_cost(1, 6) <= slice3winner1_best_cost(1, 12);
    slice3winner2_best_cost(2, 6) <= slice3winner1_best_cost(2, 12);
    slice3winner2_best_cost(3, 6) <= slice3winner1_best_cost(3, 12);
    for i in 0 to 3 loop
      slice3winner2_best_cost(i, 0) <= choice(slice3winner2_best_cost_is_less(i, 0), slice3winner1_best_cost(i, 1),
        slice3winner1_best_cost(i, 0));
      slice3winner2_best_index_0(i) <= choice(slice3winner2_best_cost_is_less(i, 0), slice3winner1_best_index_1(i),
        as_number(slice3winner1_best_index_0(i)));
      slice3winner2_best_cost(i, 1) <= choice(slice3winner2_best_cost_is_less(i, 1), slice3winner1_best_cost(i, 3),
        slice3winner1_best_cost(i, 2));
      slice3winner2_best_index_1(i) <= choice(slice3winner2_best_cost_is_less(i, 1), slice3winner1_best_index_3(i),
        slice3winner1_best_index_2(i));
      slice3winner2_best_cost(i, 2) <= choice(slice3winner2_best_cost_is_less(i, 2), slice3winner1_best_cost(i, 5),
        slice3winner1_best_cost(i, 4));
      slice3winner2_best_index_2(i) <= choice(slice3winner2_best_cost_is_less(i, 2), slice3winner1_best_index_5(i),
        slice3winner1_best_index_4(i));
      slice3winner2_best_cost(i, 3) <= choice(slice3winner2_best_cost_is_less(i, 3), slice3winner1_best_cost(i, 7),
        slice3winner1_best_cost(i, 6));
      slice3winner2_best_index_3(i) <= choice(slice3winner2_best_cost_is_less(i, 3), slice3winner1_best_index_7(i),
        slice3winner1_best_index_6(i));
      slice3winner2_best_cost(i, 4) <= choice(slice3winner2_best_cost_is_less(i, 4), slice3winner1_best_cost(i, 9),
        slice3winner1_best_cost(i, 8));
      slice3winner2_best_index_4(i) <= choice(slice3winner2_best_cost_is_less(i, 4), slice3winner1_best_index_9(i),
        slice3winner1_best_index_8(i));
      slice3winner2_best_cost(i, 5) <= choice(slice3winner2_best_cost_is_less(i, 5), slice3winner1_best_cost(i, 11),
        slice3winner1_best_cost(i, 10));
      slice3winner2_best_index_5(i) <= choice(slice3winner2_best_cost_is_less(i, 5), slice3winner1_best_index_11(i),
        slice3winner1_best_index_10(i));
    end loop;
    -- slice3winner3
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        slice3winner3_best_cost_is_less(i, j) := (slice3winner2_best_cost(i, 2 * j + 1) - slice3winner2_best_cost(i, 2
          * j)) < 0;
      end loop;
    end loop;
    slice3winner3_best_cost(0, 3) <= slice3winner2_best_cost(0, 6);
    slice3winner3_best_cost(1, 3) <= slice3winner2_best_cost(1, 6);
    slice3winner3_best_cost(2, 3) <= slice3winner2_best_cost(2, 6);
    slice3winner3_best_cost(3, 3) <= slice3winner2_best_cost(3, 6);
    for i in 0 to 3 loop
      slice3winner3_best_cost(i, 0) <= choice(slice3winner3_best_cost_is_less(i, 0), slice3winner2_best_cost(i, 1),
        slice3winner2_best_cost(i, 0));
      slice3winner3_best_index_0(i) <= choice(slice3winner3_best_cost_is_less(i, 0), slice3winner2_best_index_1(i),
        slice3winner2_best_index_0(i));
      slice3winner3_best_cost(i, 1) <= choice(slice3winner3_best_cost_is_less(i, 1), slice3winner2_best_cost(i, 3),
        slice3winner2_best_cost(i, 2));
      slice3winner3_best_index_1(i) <= choice(slice3winner3_best_cost_is_less(i, 1), slice3winner2_best_index_3(i),
        slice3winner2_best_index_2(i));
      slice3winner3_best_cost(i, 2) <= choice(slice3winner3_best_cost_is_less(i, 2), slice3winner2_best_cost(i, 5),
        slice3winner2_best_cost(i, 4));
      slice3winner3_best_index_2(i) <= choice(slice3winner3_best_cost_is_less(i, 2), slice3winner2_best_index_5(i),
        slice3winner2_best_index_4(i));
    end loop;
    -- slice3winner4
    for i in 0 to 3 loop
      slice3winner4_best_cost_is_less(i, 0) := (slice3winner3_best_cost(i, 1) - slice3winner3_best_cost(i, 0)) < 0;
      slice3winner4_best_cost_is_less(i, 1) := (slice3winner3_best_cost(i, 3) - slice3winner3_best_cost(i, 2)) < 0;
    end loop;
    for i in 0 to 3 loop
      slice3winner4_best_cost(i, 0) <= choice(slice3winner4_best_cost_is_less(i, 0), slice3winner3_best_cost(i, 1),
        slice3winner3_best_cost(i, 0));
      slice3winner4_best_index_0(i) <= choice(slice3winner4_best_cost_is_less(i, 0), slice3winner3_best_index_1(i),
        slice3winner3_best_index_0(i));
      slice3winner4_best_cost(i, 1) <= choice(slice3winner4_best_cost_is_less(i, 1), slice3winner3_best_cost(i, 3),
        slice3winner3_best_cost(i, 2));
      slice3winner4_best_index_1(i) <= choice(slice3winner4_best_cost_is_less(i, 1), slice0winner3_best_index_0(3),
        slice3winner3_best_index_2(i));
    end loop;
    -- slice3winner5
    for i in 0 to 3 loop
      slice3winner5_best_cost_0_is_less(i) := (slice3winner4_best_cost(i, 1) - slice3winner4_best_cost(i, 0)) < 0;
    end loop;
    for i in 0 to 3 loop
      slice3winner5_best_cost_0(i) <= choice(slice3winner5_best_cost_0_is_less(i), slice3winner4_best_cost(i, 1),
        slice3winner4_best_cost(i, 0));
      slice3winner5_best_index_0(i) <= choice(slice3winner5_best_cost_0_is_less(i), slice3winner4_best_index_1(i),
        slice3winner4_best_index_0(i));
    end loop;
    -- slice3
    slice3_best_tag <= slice2_best_tag;
    for i in 0 to 3 loop
      slice3_best_index_0(i) <= choice((slice2_best_cost_0(i) - slice3winner5_best_cost_0(i)) < 0,
        slice2_best_index_0(i), slice3winner5_best_index_0(i));
    end loop;
    if reset = '1' then
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 61;
      raster_place_next_frame <= false; delay_ring_read_address <= 1; delay_ring_write_address <= 0; delay_column <= 0;
      delay_tag_valid <= false; delay_tag_output_column <= false; delay_tag_start_of_frame <= false;
      delay_tag_end_of_line <= false; rows_read_column <= 0; rows_read_tag_valid <= false;
      rows_read_tag_output_column <= false; rows_read_tag_start_of_frame <= false; rows_read_tag_end_of_line <= false;
      rows_ready_column <= 0; rows_ready_tag_valid <= false; rows_ready_tag_output_column <= false;
      rows_ready_tag_start_of_frame <= false; rows_ready_tag_end_of_line <= false; rows_write_column <= 0;
      rows_tag_valid <= false; rows_tag_output_column <= false; rows_tag_start_of_frame <= false;
      rows_tag_end_of_line <= false; slice0shift_tag_valid <= false; slice0shift_tag_output_column <= false;
      slice0shift_tag_start_of_frame <= false; slice0shift_tag_end_of_line <= false; slice0cost_signs_column <= 0;
      slice0cost_signs_next_column <= 0; slice0cost_signs_difference_column <= 0; slice0cost_signs_write_column <= 0;
      slice0cost_difference_tag_valid <= false; slice0cost_difference_tag_output_column <= false;
      slice0cost_difference_tag_start_of_frame <= false; slice0cost_difference_tag_end_of_line <= false;
      slice0cost_pair_tag_valid <= false; slice0cost_pair_tag_output_column <= false;
      slice0cost_pair_tag_start_of_frame <= false; slice0cost_pair_tag_end_of_line <= false;
      slice0cost_tag_valid <= false; slice0cost_tag_output_column <= false; slice0cost_tag_start_of_frame <= false;
      slice0cost_tag_end_of_line <= false; slice0window_centre_output_column_0 <= false;
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
