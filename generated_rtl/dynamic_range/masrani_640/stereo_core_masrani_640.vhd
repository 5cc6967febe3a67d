-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, dynamic range, configuration masrani_640: 640x480, 128 disparities by two windows of 16, window 9x9, phase of 2 scales, 1 pixel pair a clock.
-- Options: subpixel true.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config masrani_640
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_masrani_640 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 128;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 624;
    latency_clocks : positive := 59;
    flush_groups : positive := 30612;
    gap_groups : positive := 15360
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 640 report "stereo_core_masrani_640: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_masrani_640: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 128 report "stereo_core_masrani_640: disparities is " & integer'image(disparities) & " but this core has 128" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_masrani_640: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_masrani_640: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 624 report "stereo_core_masrani_640: output_width_px is " & integer'image(output_width_px) & " but this core has 624" severity failure;
  assert latency_clocks = 59 report "stereo_core_masrani_640: latency_clocks is " & integer'image(latency_clocks) & " but this core has 59" severity failure;
  assert flush_groups = 30612 report "stereo_core_masrani_640: flush_groups is " & integer'image(flush_groups) & " but this core has 30612" severity failure;
  assert gap_groups = 15360 report "stereo_core_masrani_640: gap_groups is " & integer'image(gap_groups) & " but this core has 15360" severity failure;
end entity;

architecture rtl of stereo_core_masrani_640 is
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
  type boolean_2d is array (natural range <>, natural range <>) of boolean;
  type boolean_3d is array (natural range <>, natural range <>, natural range <>) of boolean;
  type integer_minus_19_to_19_1d is array (natural range <>) of integer range -19 to 19;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type integer_minus_30_to_32_1d is array (natural range <>) of integer range -30 to 32;
  type natural_1021_1d is array (natural range <>) of natural range 0 to 1021;
  type natural_1021_2d is array (natural range <>, natural range <>) of natural range 0 to 1021;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_1073741823_1d is array (natural range <>) of natural range 0 to 1073741823;
  type natural_12247_1d is array (natural range <>) of natural range 0 to 12247;
  type natural_124_1d is array (natural range <>) of natural range 0 to 124;
  type natural_126_1d is array (natural range <>) of natural range 0 to 126;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_12_2d is array (natural range <>, natural range <>) of natural range 0 to 12;
  type natural_1530_1d is array (natural range <>) of natural range 0 to 1530;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_15_2d is array (natural range <>, natural range <>) of natural range 0 to 15;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_168_1d is array (natural range <>) of natural range 0 to 168;
  type natural_19_2d is array (natural range <>, natural range <>) of natural range 0 to 19;
  type natural_2016_1d is array (natural range <>) of natural range 0 to 2016;
  type natural_2041_1d is array (natural range <>) of natural range 0 to 2041;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2049_to_8190_1d is array (natural range <>) of natural range 2049 to 8190;
  type natural_210_1d is array (natural range <>) of natural range 0 to 210;
  type natural_24_1d is array (natural range <>) of natural range 0 to 24;
  type natural_252_1d is array (natural range <>) of natural range 0 to 252;
  type natural_254_1d is array (natural range <>) of natural range 0 to 254;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_257_1d is array (natural range <>) of natural range 0 to 257;
  type natural_294_1d is array (natural range <>) of natural range 0 to 294;
  type natural_3063_1d is array (natural range <>) of natural range 0 to 3063;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_3_1d is array (natural range <>) of natural range 0 to 3;
  type natural_3_2d is array (natural range <>, natural range <>) of natural range 0 to 3;
  type natural_3_to_65538_1d is array (natural range <>) of natural range 3 to 65538;
  type natural_3_to_65538_2d is array (natural range <>, natural range <>) of natural range 3 to 65538;
  type natural_4082_1d is array (natural range <>) of natural range 0 to 4082;
  type natural_4082_2d is array (natural range <>, natural range <>) of natural range 0 to 4082;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_4095_2d is array (natural range <>, natural range <>) of natural range 0 to 4095;
  type natural_4095_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 4095;
  type natural_4095_4d is array (natural range <>, natural range <>, natural range <>, natural range <>) of natural range 0 to 4095;
  type natural_4194303_1d is array (natural range <>) of natural range 0 to 4194303;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_510_1d is array (natural range <>) of natural range 0 to 510;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_2d is array (natural range <>, natural range <>) of natural range 0 to 63;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_65535_2d is array (natural range <>, natural range <>) of natural range 0 to 65535;
  type natural_65535_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 65535;
  type natural_6_1d is array (natural range <>) of natural range 0 to 6;
  type natural_6_2d is array (natural range <>, natural range <>) of natural range 0 to 6;
  type natural_8164_1d is array (natural range <>) of natural range 0 to 8164;
  type natural_8191_2d is array (natural range <>, natural range <>) of natural range 0 to 8191;
  type natural_8192_1d is array (natural range <>) of natural range 0 to 8192;
  type natural_84_1d is array (natural range <>) of natural range 0 to 84;
  type natural_9214_2d is array (natural range <>, natural range <>) of natural range 0 to 9214;
  type unsigned_12_1d is array (natural range <>) of unsigned(11 downto 0);
  type unsigned_16_1d is array (natural range <>) of unsigned(15 downto 0);
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type tag_7 is record
    valid, border_column, first_cost, map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_6 is record
    valid, map_column, output_column, first_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_5 is record
    valid, map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_2 is record
    first_cost, output_column : boolean;
  end record;
  type tag_3 is record
    valid, output_column, start_of_frame : boolean;
  end record;
  type tag_8 is record
    row_start, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame : boolean;
    end_of_line : boolean;
  end record;
  type tag_8_b is record
    valid, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_6_b is record
    valid, first_cost, leaves_window, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_5_b is record
    valid, first_cost, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- coarse
  signal coarse_pixels_left, coarse_pixels_right, coarse_pixels_column, coarse_pixels_part, coarse_pixels_sum_column,
    coarse_pixels_read_column, coarse_pixels_total_column, coarse_pixels_out_left,
    coarse_pixels_out_right : natural range 0 to 255;
  signal coarse_pixels_valid, coarse_pixels_first_row, coarse_pixels_sum_ends, coarse_pixels_sum_is_first,
    coarse_pixels_sum_is_last, coarse_pixels_sum_starts, coarse_pixels_read_ends, coarse_pixels_read_is_first,
    coarse_pixels_read_is_last, coarse_pixels_read_starts, coarse_pixels_total_ends, coarse_pixels_total_is_last,
    coarse_pixels_total_starts, coarse_pixels_out_start, coarse_pixels_out_valid : boolean;
  signal coarse_pixels_row : natural range 0 to 3;
  signal coarse_pixels_left_sum, coarse_pixels_right_sum, coarse_pixels_left_read,
    coarse_pixels_repetition : natural range 0 to 65535;
  signal coarse_pixels_read_word_0 : unsigned(23 downto 0);
  signal coarse_pixels_right_read : natural range 0 to 4095;
  signal coarse_pixels_total : natural range 0 to 16777215;
  -- coarsetransform
  signal coarsetransform_left_0, coarsetransform_right_0, coarsetransform_counter_column,
    coarsetransform_left_rows_read_newest_0, coarsetransform_left_rows_ready_newest_0,
    coarsetransform_right_rows_read_newest_0, coarsetransform_right_rows_ready_newest_0, coarsetransform_read_column,
    coarsetransform_ready_column, coarsetransform_write_column : natural range 0 to 255;
  signal coarsetransform_left_column, coarsetransform_right_column : natural_255_1d(0 to 4);
  signal coarsetransform_left_code_column_centre, coarsetransform_right_code_column_centre : natural range 0 to 255;
  signal coarsetransform_valid, coarsetransform_counter_next_frame, coarsetransform_from_first_0,
    coarsetransform_up_to_last_0, coarsetransform_columns_inside_0, coarsetransform_columns_start_of_frame,
    coarsetransform_columns_valid : boolean;
  signal coarsetransform_filtering_inside_0 : boolean_1d(0 to 4);  -- _#_inside_0
  signal coarsetransform_filtering_start_of_frame : boolean_1d(0 to 5);  -- _#_start_of_frame
  signal coarsetransform_filtering_valid : boolean_1d(0 to 5);  -- _#_valid
  signal coarsetransform_counter_group : natural range 0 to 127;
  signal coarsetransform_left_rows_read_words_0, coarsetransform_left_rows_ready_words_0,
    coarsetransform_left_rows_write_words_0, coarsetransform_right_rows_read_words_0,
    coarsetransform_right_rows_ready_words_0, coarsetransform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal coarsetransform_centre_group : natural range 0 to 128;
  signal coarsetransform_left_code_column_near, coarsetransform_left_code_column_outer,
    coarsetransform_right_code_column_near, coarsetransform_right_code_column_outer : natural range 0 to 510;
  signal coarsetransform_left_code_column_upper, coarsetransform_left_code_column_lower,
    coarsetransform_right_code_column_upper, coarsetransform_right_code_column_lower : natural range 0 to 765;
  signal coarsetransform_left_code_column_response : natural_1021_1d(0 to 1);
  signal coarsetransform_left_code_row_column : natural_1021_2d(0 to 1, 0 to 3);
  signal coarsetransform_left_code_row_centre : natural_1530_1d(0 to 2);  -- _# up to 1021, 1021, 1530
  signal coarsetransform_right_code_column_response : natural_1021_1d(0 to 1);
  signal coarsetransform_right_code_row_column : natural_1021_2d(0 to 1, 0 to 3);
  signal coarsetransform_right_code_row_centre : natural_1530_1d(0 to 2);  -- _# up to 1021, 1021, 1530
  signal coarsetransform_left_code_column_response_2 : natural range 0 to 1530;
  signal coarsetransform_left_code_row_column_2 : natural_1530_1d(0 to 3);
  signal coarsetransform_right_code_column_response_2 : natural range 0 to 1530;
  signal coarsetransform_right_code_row_column_2 : natural_1530_1d(0 to 3);
  signal coarsetransform_left_code_row_outer_1, coarsetransform_right_code_row_outer_1 : natural range 0 to 2042;
  signal coarsetransform_left_code_row_outer_2, coarsetransform_right_code_row_outer_2 : natural range 0 to 3060;
  signal coarsetransform_left_code_row_before, coarsetransform_left_code_row_after,
    coarsetransform_right_code_row_before, coarsetransform_right_code_row_after : natural_3063_1d(0 to 1);
  signal coarsetransform_left_code_row_before_2, coarsetransform_left_code_row_after_2,
    coarsetransform_right_code_row_before_2, coarsetransform_right_code_row_after_2 : natural range 0 to 4591;
  signal coarsetransform_left_code_row_even, coarsetransform_left_code_row_odd, coarsetransform_right_code_row_even,
    coarsetransform_right_code_row_odd : natural_16383_1d(1 to 2);
  signal coarsetransform_left_code_row_signs, coarsetransform_left_code_bits, coarsetransform_right_code_row_signs,
    coarsetransform_right_code_bits : natural range 0 to 63;
  -- coarseraster
  signal coarseraster_features_search_0, coarseraster_features_reference_0 : natural range 0 to 63;
  signal coarseraster_features_valid, coarseraster_place_next_frame : boolean;
  signal coarseraster_place_column : natural range 0 to 255;
  signal coarseraster_place_group : natural range 0 to 127;
  -- coarsedelay
  signal coarsedelay_ring_read_address, coarsedelay_ring_write_address : natural range 0 to 31;
  signal coarsedelay_ahead_0 : natural range 0 to 63;
  signal coarsedelay_delayed_0 : unsigned(5 downto 0);
  signal coarsedelay_column : natural range 0 to 255;
  signal coarsedelay_row_inside : boolean_1d(0 to 6);
  signal coarsedelay_tag : tag_7;
  -- coarserows
  signal coarserows_search_rows_read_words_0, coarserows_reference_rows_read_words_0 : unsigned(29 downto 0);
  signal coarserows_search_rows_read_words_1, coarserows_reference_rows_read_words_1 : unsigned(5 downto 0);
  signal coarserows_search_rows_read_newest_0, coarserows_search_rows_ready_words_1,
    coarserows_search_rows_ready_newest_0 : natural range 0 to 63;
  signal coarserows_search_rows_write_words : natural_1073741823_1d(0 to 1);  -- _# up to 1073741823, 63
  signal coarserows_reference_rows_read_newest_0, coarserows_reference_rows_ready_words_1,
    coarserows_reference_rows_ready_newest_0 : natural range 0 to 63;
  signal coarserows_reference_rows_write_words : natural_1073741823_1d(0 to 1);  -- _# up to 1073741823, 63
  signal coarserows_search, coarserows_reference : natural_63_1d(0 to 6);
  signal coarserows_search_rows_ready_words_0, coarserows_reference_rows_ready_words_0 : natural range 0 to 1073741823;
  signal coarserows_read_column, coarserows_ready_column, coarserows_write_column : natural range 0 to 255;
  signal coarserows_read_inside : boolean_1d(0 to 6);
  signal coarserows_read_tag : tag_7;
  signal coarserows_ready_inside : boolean_1d(0 to 6);
  signal coarserows_ready_tag, coarserows_tag : tag_7;
  -- coarseslice0shift
  signal coarseslice0shift_search : natural_63_2d(0 to 6, 0 to 24);
  signal coarseslice0shift_reference, coarseslice0shift_search_out : natural_63_1d(0 to 6);
  signal coarseslice0shift_tag : tag_7;
  -- coarseslice0cost
  signal coarseslice0cost_pixels_first : natural_15_2d(0 to 6, 0 to 24);
  signal coarseslice0cost_pixels_first_tag, coarseslice0cost_pixels_tag, coarseslice0cost_pair_tag,
    coarseslice0cost_tag : tag_7;
  signal coarseslice0cost_pixels_cost : natural_6_2d(0 to 6, 0 to 24);
  signal coarseslice0cost_single_0 : natural_6_1d(0 to 24);
  signal coarseslice0cost_pair : natural_12_2d(0 to 2, 0 to 24);
  signal coarseslice0cost_column_0 : natural_42_1d(0 to 24);
  -- coarseslice0window
  signal coarseslice0window_partial_0_0 : natural_42_1d(0 to 24);
  signal coarseslice0window_partial_0_1 : natural_84_1d(0 to 24);
  signal coarseslice0window_partial_0_2 : natural_126_1d(0 to 24);
  signal coarseslice0window_partial_0_3 : natural_168_1d(0 to 24);
  signal coarseslice0window_partial_0_4 : natural_210_1d(0 to 24);
  signal coarseslice0window_partial_0_5 : natural_252_1d(0 to 24);
  signal coarseslice0window_centre_map_column_0 : boolean;
  signal coarseslice0window_centre_output_column, coarseslice0window_centre_first_column : boolean_1d(0 to 2);
  signal coarseslice0window_centre_start_of_frame_0, coarseslice0window_centre_end_of_line_0 : boolean;
  signal coarseslice0window_tag : tag_6;
  signal coarseslice0window_sum_0 : natural_294_1d(0 to 24);
  -- coarseslice0other
  signal coarseslice0other_cost_0 : natural_294_1d(0 to 24);
  signal coarseslice0other_cost_out_0 : natural range 0 to 294;
  signal coarseslice0other_winner_0 : natural_31_1d(0 to 24);
  signal coarseslice0other_winner_out_0 : natural range 0 to 31;
  -- coarseslice0winner1
  signal coarseslice0winner1_best_cost_0 : natural_294_1d(0 to 12);
  signal coarseslice0winner1_best_index_0_0 : boolean;
  signal coarseslice0winner1_tag : tag_6;
  signal coarseslice0winner1_best_index_0 : natural_24_1d(1 to 12);  -- _# up to 3, 5 .. 23, 24
  -- coarseslice0winner2
  signal coarseslice0winner2_best_cost_0 : natural_294_1d(0 to 6);
  signal coarseslice0winner2_best_index_0 : natural_24_1d(0 to 6);  -- _# up to 3, 7 .. 23, 24
  signal coarseslice0winner2_tag : tag_5;
  -- coarseslice0winner3
  signal coarseslice0winner3_best_cost_0 : natural_294_1d(0 to 3);
  signal coarseslice0winner3_best_index_0 : natural_24_1d(0 to 3);  -- _# up to 7, 15, 23, 24
  signal coarseslice0winner3_tag : tag_5;
  -- coarseslice0winner4
  signal coarseslice0winner4_best_cost_0 : natural_294_1d(0 to 1);
  signal coarseslice0winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  signal coarseslice0winner4_tag : tag_5;
  -- coarseslice0winner5
  signal coarseslice0winner5_best_cost_0_0 : natural range 0 to 294;
  signal coarseslice0winner5_best_index_0_0 : natural range 0 to 24;
  signal coarseslice0winner5_tag : tag_5;
  -- coarseslice0
  signal coarseslice0_best_cost_0_0 : natural range 0 to 294;
  signal coarseslice0_best_index_0_0 : natural range 0 to 31;
  signal coarseslice0_best_tag : tag_5;
  -- coarseslice1shift
  signal coarseslice1shift_search : natural_63_2d(0 to 6, 0 to 6);
  signal coarseslice1shift_reference : natural_63_1d(0 to 6);
  -- coarseslice1cost
  signal coarseslice1cost_pixels_first : natural_15_2d(0 to 6, 0 to 6);
  signal coarseslice1cost_pixels_cost : natural_6_2d(0 to 6, 0 to 6);
  signal coarseslice1cost_single_0 : natural_6_1d(0 to 6);
  signal coarseslice1cost_pair : natural_12_2d(0 to 2, 0 to 6);
  signal coarseslice1cost_column_0 : natural_42_1d(0 to 6);
  signal coarseslice1cost_tag : tag_2;
  -- coarseslice1window
  signal coarseslice1window_partial_0_0 : natural_42_1d(0 to 6);
  signal coarseslice1window_partial_0_1 : natural_84_1d(0 to 6);
  signal coarseslice1window_partial_0_2 : natural_126_1d(0 to 6);
  signal coarseslice1window_partial_0_3 : natural_168_1d(0 to 6);
  signal coarseslice1window_partial_0_4 : natural_210_1d(0 to 6);
  signal coarseslice1window_partial_0_5 : natural_252_1d(0 to 6);
  signal coarseslice1window_centre_map_column : boolean_1d(0 to 1);
  signal coarseslice1window_centre_output_column, coarseslice1window_centre_first_column : boolean_1d(0 to 2);
  signal coarseslice1window_centre_start_of_frame, coarseslice1window_centre_end_of_line : boolean_1d(0 to 1);
  signal coarseslice1window_sum_0 : natural_294_1d(0 to 6);
  -- coarseslice1other
  signal coarseslice1other_cost_0 : natural_294_1d(1 to 6);
  signal coarseslice1other_winner_0 : natural_31_1d(0 to 6);
  signal coarseslice1other_winner_out_0 : natural range 0 to 31;
  -- coarseslice1winner1
  signal coarseslice1winner1_best_cost_0 : natural_294_1d(0 to 3);
  signal coarseslice1winner1_best_index_0_0 : boolean;
  signal coarseslice1winner1_best_index_0 : natural_6_1d(1 to 3);  -- _# up to 3, 5, 6
  -- coarseslice1winner2
  signal coarseslice1winner2_best_cost_0 : natural_294_1d(0 to 1);
  signal coarseslice1winner2_best_index_0 : natural_6_1d(0 to 1);  -- _# up to 3, 6
  -- coarseslice1winner3
  signal coarseslice1winner3_best_cost_0_0 : natural range 0 to 294;
  signal coarseslice1winner3_best_index_0_0 : natural range 0 to 6;
  -- coarseslice1winner4
  signal coarseslice1winner4_best_cost_0_0 : natural range 0 to 294;
  signal coarseslice1winner4_best_index_0_0 : natural range 0 to 6;
  -- coarseslice1winner5
  signal coarseslice1winner5_best_cost_0_0 : natural range 0 to 294;
  signal coarseslice1winner5_best_index_0_0 : natural range 0 to 6;
  -- coarseslice1
  signal coarseslice1_best_index_0_0 : natural range 0 to 31;
  signal coarseslice1_best_tag : tag_5;
  -- coarseleftright
  signal coarseleftright_other_0 : natural_31_1d(1 to 4);  -- _#_0
  signal coarseleftright_ring_read_address, coarseleftright_ring_write_address,
    coarseleftright_checked_disparity_0 : natural range 0 to 31;
  signal coarseleftright_holds_winners, coarseleftright_held_valid, coarseleftright_asking_passed_0 : boolean;
  signal coarseleftright_asking_tag : tag_3;
  signal coarseleftright_answered_passed_0 : boolean;
  signal coarseleftright_answered_tag : tag_3;
  signal coarseleftright_checked_passed_0 : boolean;
  signal coarseleftright_checked_tag : tag_3;
  signal coarseleftright_position, coarseleftright_held_position, coarseleftright_address_0,
    coarseleftright_asking_disparity_0, coarseleftright_answered_disparity_0 : natural range 0 to 63;
  signal coarseleftright_held_0 : unsigned(12 downto 0);
  signal coarseleftright_found_0 : unsigned(4 downto 0);
  -- ranges
  signal ranges_column, ranges_in_column, ranges_read_column, ranges_ready_column, ranges_pixels_written,
    ranges_centre_column, ranges_counted_column : natural range 0 to 255;
  signal ranges_row, ranges_in_row, ranges_read_row, ranges_ready_row, ranges_paired_column, ranges_pair_read_column,
    ranges_pair_ready_column, ranges_pairs_written : natural range 0 to 127;
  signal ranges_pixel_0, ranges_pixels_read_newest_0, ranges_pixels_ready_newest_0, ranges_left, ranges_above,
    ranges_middle, ranges_below, ranges_next_above, ranges_right, ranges_next_below : natural range 0 to 63;
  signal ranges_in_valid, ranges_read_valid, ranges_ready_valid, ranges_centre_valid, ranges_counts,
    ranges_counted_valid, ranges_paired_valid, ranges_pair_read_valid, ranges_pair_ready_valid, ranges_valid : boolean;
  signal ranges_pixels_read_words_0 : unsigned(11 downto 0);
  signal ranges_pixels_ready_words_0, ranges_pixels_write_words_0 : natural range 0 to 4095;
  signal ranges_centre_row, ranges_counted_row, ranges_paired_row, ranges_pair_read_row, ranges_pair_ready_row,
    ranges_block_column : natural range 0 to 65535;
  signal ranges_disparity : natural range 0 to 31;
  signal ranges_first_of_pair, ranges_pair_0, ranges_pairs_read_newest_0, ranges_pairs_ready_words_0,
    ranges_pairs_ready_newest_0, ranges_pairs_write_words_0, ranges_range : natural range 0 to 2047;
  signal ranges_pairs_read_words_0 : unsigned(10 downto 0);
  signal ranges_block_row : natural range 0 to 32767;
  -- targets
  signal targets_newest_0, targets_rows_read_newest_0, targets_rows_ready_words_1,
    targets_rows_ready_newest_0 : natural range 0 to 2047;
  signal targets_rows_write_words : natural_4194303_1d(0 to 1);  -- _# up to 4194303, 2047
  signal targets_column_range, targets_behind, targets_here, targets_around : natural range 0 to 2047;
  signal targets_read_column, targets_walk_place, targets_read_place, targets_ready_place,
    targets_write_column : natural range 0 to 127;
  signal targets_comes, targets_last_row, targets_again, targets_walk_has_above, targets_walk_has_below,
    targets_walk_valid, targets_read_comes, targets_ready_comes, targets_read_walk_has_above,
    targets_read_walk_has_below, targets_read_walk_valid, targets_ready_walk_has_above, targets_ready_walk_has_below,
    targets_ready_walk_valid, targets_column_walk_has_below, targets_column_walk_valid, targets_around_walk_has_below,
    targets_around_walk_valid, targets_known, targets_wish_walk_has_below, targets_wish_walk_valid : boolean;
  signal targets_pause, targets_walked, targets_next_band, targets_walk_column, targets_read_walk_column,
    targets_ready_walk_column, targets_column_walk_column, targets_around_walk_column, targets_wish_walk_column,
    targets_low : natural range 0 to 65535;
  signal targets_walk_band, targets_read_walk_band, targets_ready_walk_band, targets_column_walk_band,
    targets_around_walk_band, targets_wish_walk_band : natural range 0 to 7;
  signal targets_rows_read_words_0 : unsigned(21 downto 0);
  signal targets_rows_read_words_1 : unsigned(10 downto 0);
  signal targets_rows_ready_words_0 : natural range 0 to 4194303;
  signal targets_low_wish, targets_high_wish : natural range 0 to 126;
  signal targets_high : natural range 0 to 65534;
  signal targets_place : natural range 0 to 1023;
  -- hold
  signal hold_back_ring_read_address, hold_back_ring_write_address, hold_back_next_ring_read_address,
    hold_back_next_ring_write_address, hold_back_next_next_ring_read_address, hold_back_next_next_ring_write_address,
    hold_back_next_next_next_ring_read_address, hold_back_next_next_next_ring_write_address,
    hold_back_next_next_next_next_ring_read_address, hold_back_next_next_next_next_ring_write_address,
    hold_back_next_next_next_next_next_ring_read_address, hold_back_next_next_next_next_next_ring_write_address,
    hold_back_next_next_next_next_next_next_ring_read_address,
    hold_back_next_next_next_next_next_next_ring_write_address,
    hold_back_next_next_next_next_next_next_next_ring_read_address,
    hold_back_next_next_next_next_next_next_next_ring_write_address,
    hold_back_next_next_next_next_next_next_next_next_ring_read_address,
    hold_back_next_next_next_next_next_next_next_next_ring_write_address : natural range 0 to 4095;
  signal hold_back_holds_groups, hold_back_held_is_new, hold_back_next_holds_groups, hold_back_next_held_is_new,
    hold_back_next_held_valid, hold_back_next_next_holds_groups, hold_back_next_next_held_is_new,
    hold_back_next_next_held_valid, hold_back_next_next_next_holds_groups, hold_back_next_next_next_held_is_new,
    hold_back_next_next_next_held_valid, hold_back_next_next_next_next_holds_groups,
    hold_back_next_next_next_next_held_is_new, hold_back_next_next_next_next_held_valid,
    hold_back_next_next_next_next_next_holds_groups, hold_back_next_next_next_next_next_held_is_new,
    hold_back_next_next_next_next_next_held_valid, hold_back_next_next_next_next_next_next_holds_groups,
    hold_back_next_next_next_next_next_next_held_is_new, hold_back_next_next_next_next_next_next_held_valid,
    hold_back_next_next_next_next_next_next_next_holds_groups,
    hold_back_next_next_next_next_next_next_next_held_is_new, hold_back_next_next_next_next_next_next_next_held_valid,
    hold_back_next_next_next_next_next_next_next_next_holds_groups,
    hold_back_next_next_next_next_next_next_next_next_held_is_new,
    hold_back_next_next_next_next_next_next_next_next_held_valid : boolean;
  signal hold_back_held_0, hold_back_next_held_0, hold_back_next_next_held_0, hold_back_next_next_next_held_0,
    hold_back_next_next_next_next_held_0, hold_back_next_next_next_next_next_held_0,
    hold_back_next_next_next_next_next_next_held_0, hold_back_next_next_next_next_next_next_next_held_0,
    hold_back_next_next_next_next_next_next_next_next_held_0 : unsigned(16 downto 0);
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0, transform_left_rows_ready_words_2,
    transform_left_rows_ready_newest_0, transform_left_rows_write_words_2, transform_right_rows_read_newest_0,
    transform_right_rows_ready_words_2, transform_right_rows_ready_newest_0,
    transform_right_rows_write_words_2 : natural range 0 to 255;
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 9);
  signal transform_left_code_column_box_0_0 : natural_255_1d(0 to 4);  -- _#_0
  signal transform_left_code_column_centre : natural range 0 to 255;
  signal transform_right_code_column_box_0_0 : natural_255_1d(0 to 4);  -- _#_0
  signal transform_right_code_column_centre : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_from_first, transform_up_to_last, transform_columns_inside : boolean_1d(0 to 1);
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_inside : boolean_2d(0 to 6, 0 to 1);  -- _#_inside_#
  signal transform_filtering_start_of_frame : boolean_1d(0 to 7);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 7);  -- _#_valid
  signal transform_counter_column, transform_read_column, transform_ready_column, transform_write_column,
    transform_centre_column : natural range 0 to 1023;
  signal transform_counter_group : natural range 0 to 511;
  signal transform_left_rows_read_words, transform_left_rows_ready_words, transform_left_rows_write_words,
    transform_right_rows_read_words, transform_right_rows_ready_words,
    transform_right_rows_write_words : unsigned_32_1d(0 to 1);
  signal transform_left_rows_read_words_2, transform_right_rows_read_words_2 : unsigned(7 downto 0);
  signal transform_centre_group : natural range 0 to 512;
  signal transform_left_code_column_near, transform_left_code_column_outer : natural range 0 to 510;
  signal transform_left_code_next_column_box_0_0 : natural_510_1d(0 to 4);  -- _#_0
  signal transform_left_code_next_column_centre, transform_right_code_column_near,
    transform_right_code_column_outer : natural range 0 to 510;
  signal transform_right_code_next_column_box_0_0 : natural_510_1d(0 to 4);  -- _#_0
  signal transform_right_code_next_column_centre : natural range 0 to 510;
  signal transform_left_code_column_upper, transform_left_code_column_lower, transform_right_code_column_upper,
    transform_right_code_column_lower : natural range 0 to 765;
  signal transform_left_code_column_response : natural_1021_1d(0 to 1);
  signal transform_left_code_row_box_0 : natural_1530_1d(0 to 2);  -- _# up to 1021, 1021, 1530
  signal transform_left_code_row_column : natural_1021_2d(0 to 1, 0 to 3);
  signal transform_left_code_row_centre : natural_1530_1d(0 to 2);  -- _# up to 1021, 1021, 1530
  signal transform_right_code_column_response : natural_1021_1d(0 to 1);
  signal transform_right_code_row_box_0 : natural_1530_1d(0 to 2);  -- _# up to 1021, 1021, 1530
  signal transform_right_code_row_column : natural_1021_2d(0 to 1, 0 to 3);
  signal transform_right_code_row_centre : natural_1530_1d(0 to 2);  -- _# up to 1021, 1021, 1530
  signal transform_left_code_column_response_2 : natural range 0 to 1530;
  signal transform_left_code_row_column_2 : natural_1530_1d(0 to 3);
  signal transform_right_code_column_response_2 : natural range 0 to 1530;
  signal transform_right_code_row_column_2 : natural_1530_1d(0 to 3);
  signal transform_left_code_row_outer_1, transform_right_code_row_outer_1 : natural range 0 to 2042;
  signal transform_left_code_row_outer_2, transform_right_code_row_outer_2 : natural range 0 to 3060;
  signal transform_left_code_row_before, transform_left_code_row_after, transform_right_code_row_before,
    transform_right_code_row_after : natural_3063_1d(0 to 1);
  signal transform_left_code_row_before_2, transform_left_code_row_after_2, transform_right_code_row_before_2,
    transform_right_code_row_after_2 : natural range 0 to 4591;
  signal transform_left_code_row_even, transform_left_code_row_odd, transform_right_code_row_even,
    transform_right_code_row_odd : natural_16383_1d(1 to 2);
  signal transform_left_code_row_signs : natural range 0 to 63;
  signal transform_left_code_earlier : natural_63_1d(0 to 1);
  signal transform_left_code_bits, transform_left_code_next_row_signs, transform_left_code_next_bits,
    transform_right_code_row_signs : natural range 0 to 63;
  signal transform_right_code_earlier : natural_63_1d(0 to 1);
  signal transform_right_code_bits, transform_right_code_next_row_signs,
    transform_right_code_next_bits : natural range 0 to 63;
  signal transform_left_code_next_column_near, transform_left_code_next_column_outer,
    transform_right_code_next_column_near, transform_right_code_next_column_outer : natural range 0 to 1020;
  signal transform_left_code_next_column_upper, transform_left_code_next_column_response_2 : natural range 0 to 65535;
  signal transform_left_code_next_row_earlier_0_0 : natural_65535_1d(0 to 2);  -- _#_0 up to 2041, 2041, 65535
  signal transform_left_code_next_row_box_0_2 : natural range 0 to 65535;
  signal transform_left_code_next_row_column_2 : natural_65535_1d(0 to 7);
  signal transform_left_code_next_row_outer_2, transform_left_code_next_row_before_2,
    transform_left_code_next_row_after_2 : natural range 0 to 65535;
  signal transform_left_code_next_row_even : natural_65535_1d(1 to 2);
  signal transform_left_code_next_row_odd : natural_65535_1d(0 to 2);
  signal transform_right_code_next_column_upper, transform_right_code_next_column_response_2 : natural range 0 to 65535;
  signal transform_right_code_next_row_earlier_0_0 : natural_65535_1d(0 to 2);  -- _#_0 up to 2041, 2041, 65535
  signal transform_right_code_next_row_box_0_2 : natural range 0 to 65535;
  signal transform_right_code_next_row_column_2 : natural_65535_1d(0 to 7);
  signal transform_right_code_next_row_outer_2, transform_right_code_next_row_before_2,
    transform_right_code_next_row_after_2 : natural range 0 to 65535;
  signal transform_right_code_next_row_even : natural_65535_1d(1 to 2);
  signal transform_right_code_next_row_odd : natural_65535_1d(0 to 2);
  signal transform_left_code_next_column_lower, transform_right_code_next_column_lower : natural range 0 to 1531;
  signal transform_left_code_next_column_response, transform_right_code_next_column_response : natural_2041_1d(0 to 1);
  signal transform_left_code_next_row_box_0 : natural_4082_1d(0 to 1);
  signal transform_left_code_next_row_column : natural_4082_2d(0 to 1, 0 to 7);
  signal transform_left_code_next_row_centre : natural_32767_1d(0 to 2);  -- _# up to 4082, 4082, 32767
  signal transform_right_code_next_row_box_0 : natural_4082_1d(0 to 1);
  signal transform_right_code_next_row_column : natural_4082_2d(0 to 1, 0 to 7);
  signal transform_right_code_next_row_centre : natural_32767_1d(0 to 2);  -- _# up to 4082, 4082, 32767
  signal transform_left_code_next_row_outer, transform_right_code_next_row_outer : natural_8164_1d(0 to 1);
  signal transform_left_code_next_row_before, transform_left_code_next_row_after, transform_right_code_next_row_before,
    transform_right_code_next_row_after : natural_12247_1d(0 to 1);
  -- ahead
  signal ahead_ring_read_address, ahead_ring_write_address : natural range 0 to 127;
  signal ahead_holds_groups, ahead_held_is_new, ahead_held_valid : boolean;
  signal ahead_held_0 : unsigned(12 downto 0);
  -- raster
  signal raster_features_reference_0 : natural range 0 to 4095;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- bases
  signal bases_address : natural_1023_1d(0 to 2);
  signal bases_asked_column, bases_read_column, bases_ready_column, bases_wanted_column,
    bases_stands_column : natural range 0 to 1023;
  signal bases_asked_limit, bases_read_limit : natural range 0 to 65535;
  signal bases_ready_targets : natural_65535_1d(0 to 2);
  signal bases_ready_limit : natural range 0 to 65535;
  signal bases_base : natural_65535_2d(0 to 1, 0 to 2);
  signal bases_from_0_2 : natural range 0 to 65535;
  signal bases_asked_head, bases_asked_frame_starts, bases_asked_valid, bases_read_head, bases_read_frame_starts,
    bases_read_valid, bases_ready_head, bases_ready_frame_starts, bases_ready_valid, bases_wanted_head,
    bases_wanted_frame_starts, bases_wanted_valid : boolean;
  signal bases_rises, bases_falls : boolean_2d(0 to 1, 0 to 1);
  signal bases_stands_frame_starts, bases_stands_valid : boolean;
  signal bases_read_targets : unsigned_16_1d(0 to 2);
  signal bases_goal : natural_255_2d(0 to 1, 0 to 2);
  signal bases_from : natural_8191_2d(0 to 1, 0 to 1);
  -- rows
  signal rows_last : natural_4095_1d(1 to 3);
  signal rows_write_codes : natural_4095_1d(0 to 3);
  signal rows_ready_codes : natural_4095_1d(0 to 15);
  signal rows_codes : natural_4095_3d(0 to 1, 0 to 1, 0 to 3);
  signal rows_newest_column, rows_newest_row, rows_enter_row, rows_leave_row : natural range 0 to 65535;
  signal rows_write_word : natural range 0 to 2047;
  signal rows_address : natural_2047_1d(0 to 15);
  signal rows_position : natural_8191_2d(0 to 1, 0 to 1);
  signal rows_wanted_first_bank, rows_asked_first_bank, rows_read_first_bank,
    rows_ready_first_bank : natural_3_2d(0 to 1, 0 to 1);
  signal rows_wanted_one, rows_wanted_four, rows_asked_one, rows_asked_four, rows_read_one, rows_read_four,
    rows_ready_one, rows_ready_four, rows_step_one, rows_step_four : boolean_2d(0 to 1, 0 to 1);
  signal rows_read_codes : unsigned_12_1d(0 to 15);
  -- pairs
  signal pairs_ring_read_address, pairs_ring_write_address : natural range 0 to 15;
  signal pairs_delayed_0 : unsigned(11 downto 0);
  signal pairs_row_inside : boolean_1d(0 to 1);
  signal pairs_tag : tag_8;
  -- compared
  signal compared_rows_read_words : unsigned_24_1d(0 to 3);
  signal compared_rows_read_words_4 : unsigned(11 downto 0);
  signal compared_rows_read_newest_0, compared_rows_ready_words_4,
    compared_rows_ready_newest_0 : natural range 0 to 4095;
  signal compared_rows_write_words : natural_16777215_1d(0 to 4);  -- _# up to 16777215 x 4, 4095
  signal compared_held_reference : natural_4095_2d(0 to 7, 0 to 1);  -- _#_reference_#
  signal compared_rows_ready_words : natural_16777215_1d(0 to 3);
  signal compared_read_inside : boolean_1d(0 to 1);
  signal compared_read_tag : tag_8;
  signal compared_ready_inside : boolean_1d(0 to 1);
  signal compared_ready_tag : tag_8;
  signal compared_held_inside : boolean_2d(0 to 7, 0 to 1);  -- _#_inside_#
  signal compared_tags_row_start : boolean_1d(0 to 7);  -- _#_row_start
  signal compared_tags_first_group : boolean_1d(0 to 7);  -- _#_first_group
  signal compared_tags_border_column : boolean_1d(0 to 7);  -- _#_border_column
  signal compared_tags_first_cost : boolean_1d(0 to 7);  -- _#_first_cost
  signal compared_tags_leaves_window : boolean_1d(0 to 7);  -- _#_leaves_window
  signal compared_tags_output_column : boolean_1d(0 to 7);  -- _#_output_column
  signal compared_tags_start_of_frame : boolean_1d(0 to 7);  -- _#_start_of_frame
  signal compared_tags_end_of_line : boolean_1d(0 to 7);  -- _#_end_of_line
  signal compared_tags_valid : boolean_1d(2 to 7);  -- _#_valid
  signal compared_write_column : natural range 0 to 1023;
  -- lowchain
  signal lowchain_lane : natural_4095_2d(0 to 1, 0 to 15);
  -- lowcost
  signal lowcost_pixels_first : natural_255_2d(0 to 1, 0 to 15);
  signal lowcost_column_0 : natural_255_1d(0 to 15);
  signal lowcost_pixels_first_tag, lowcost_pixels_tag, lowcost_ready_tag : tag_8_b;
  signal lowcost_tag : tag_6_b;
  signal lowcost_pixels_cost : natural_19_2d(0 to 1, 0 to 15);
  signal lowcost_read_column, lowcost_change_column, lowcost_ready_column,
    lowcost_write_column : natural range 0 to 1023;
  signal lowcost_read_words, lowcost_ready_words, lowcost_write_words : unsigned_32_1d(0 to 3);
  signal lowcost_change_0 : integer_minus_19_to_19_1d(0 to 15);
  -- lowwindow
  signal lowwindow_ring_read_address, lowwindow_ring_write_address : natural range 0 to 15;
  signal lowwindow_leaving : unsigned_32_1d(0 to 3);
  signal lowwindow_entering_0 : natural_255_1d(0 to 15);
  signal lowwindow_entering_tag : tag_6_b;
  signal lowwindow_change_tag : tag_5_b;
  signal lowwindow_centre_output_column, lowwindow_centre_start_of_frame,
    lowwindow_centre_end_of_line : boolean_1d(0 to 3);
  signal lowwindow_tag : tag_4;
  signal lowwindow_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal lowwindow_sum_0 : natural_2047_1d(0 to 15);
  -- lowwinner1
  signal lowwinner1_best_cost_0, lowwinner1_best_below_0, lowwinner1_best_above_0 : natural_2047_1d(0 to 7);
  signal lowwinner1_best_first_0 : natural_2047_1d(1 to 7);
  signal lowwinner1_best_last_0 : natural_2047_1d(0 to 6);
  signal lowwinner1_best_index_0_0 : boolean;
  signal lowwinner1_tag : tag_4;
  signal lowwinner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- lowwinner2
  signal lowwinner2_best_cost_0, lowwinner2_best_below_0, lowwinner2_best_above_0 : natural_2047_1d(0 to 3);
  signal lowwinner2_best_first_0 : natural_2047_1d(1 to 3);
  signal lowwinner2_best_last_0 : natural_2047_1d(0 to 2);
  signal lowwinner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal lowwinner2_tag : tag_4;
  -- lowwinner3
  signal lowwinner3_best_cost_0, lowwinner3_best_below_0, lowwinner3_best_above_0 : natural_2047_1d(0 to 1);
  signal lowwinner3_best_first_0_1, lowwinner3_best_last_0_0 : natural range 0 to 2047;
  signal lowwinner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal lowwinner3_tag : tag_4;
  -- lowwinner4
  signal lowwinner4_best_cost_0_0, lowwinner4_best_below_0_0, lowwinner4_best_above_0_0 : natural range 0 to 2047;
  signal lowwinner4_best_index_0_0 : natural range 0 to 15;
  signal lowwinner4_tag : tag_4;
  -- highchain
  signal highchain_lane : natural_4095_2d(0 to 1, 0 to 15);
  -- highcost
  signal highcost_pixels_first : natural_255_2d(0 to 1, 0 to 15);
  signal highcost_column_0 : natural_255_1d(0 to 15);
  signal highcost_pixels_cost : natural_19_2d(0 to 1, 0 to 15);
  signal highcost_read_words, highcost_ready_words, highcost_write_words : unsigned_32_1d(0 to 3);
  signal highcost_change_0 : integer_minus_19_to_19_1d(0 to 15);
  -- highwindow
  signal highwindow_leaving : unsigned_32_1d(0 to 3);
  signal highwindow_entering_0 : natural_255_1d(0 to 15);
  signal highwindow_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal highwindow_sum_0 : natural_2047_1d(0 to 15);
  -- highwinner1
  signal highwinner1_best_cost_0, highwinner1_best_below_0, highwinner1_best_above_0 : natural_2047_1d(0 to 7);
  signal highwinner1_best_first_0 : natural_2047_1d(1 to 7);
  signal highwinner1_best_last_0 : natural_2047_1d(0 to 6);
  signal highwinner1_best_index_0_0 : boolean;
  signal highwinner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- highwinner2
  signal highwinner2_best_cost_0, highwinner2_best_below_0, highwinner2_best_above_0 : natural_2047_1d(0 to 3);
  signal highwinner2_best_first_0 : natural_2047_1d(1 to 3);
  signal highwinner2_best_last_0 : natural_2047_1d(0 to 2);
  signal highwinner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  -- highwinner3
  signal highwinner3_best_cost_0, highwinner3_best_below_0, highwinner3_best_above_0 : natural_2047_1d(0 to 1);
  signal highwinner3_best_first_0_1, highwinner3_best_last_0_0 : natural range 0 to 2047;
  signal highwinner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  -- highwinner4
  signal highwinner4_best_cost_0_0, highwinner4_best_below_0_0, highwinner4_best_above_0_0 : natural range 0 to 2047;
  signal highwinner4_best_index_0_0 : natural range 0 to 15;
  -- centre
  signal centre_held_0 : natural_65535_1d(1 to 3);
  signal centre_held_1 : natural_65535_1d(0 to 3);
  signal centre_line : natural_4095_2d(0 to 1, 0 to 16);
  -- choice
  signal choice_best_cost_0_0, choice_best_below_0_0, choice_best_above_0_0 : natural range 0 to 2047;
  signal choice_best_index_0_0 : natural range 0 to 15;
  signal choice_best_tag : tag_4;
  signal choice_base : natural range 0 to 4095;
  -- refinement
  signal refinement_disparity_0 : natural_15_1d(0 to 11);  -- _#_0
  signal refinement_passed_0 : boolean_1d(0 to 2);  -- _#_0
  signal refinement_passed_0s : boolean_1d(6 to 11);  -- _#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- _#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- _#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- _#_end_of_line
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_cost_0, refinement_below_0, refinement_above_0, refinement_u_0,
    refinement_v_0 : natural range 0 to 2047;
  signal refinement_remainder_0, refinement_divisor_0 : natural_2047_1d(0 to 7);  -- _#_0
  signal refinement_difference_0 : integer range -2047 to 2047;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- base
  signal base : natural_4095_1d(1 to 12);
  -- map
  signal map_disparity_0 : natural range 0 to 65535;
  signal map_passed_0, map_valid, map_start_of_frame, map_end_of_line : boolean;
  -- other
  signal other_0, other_4 : natural range 0 to 65534;
  signal other : natural_8192_1d(1 to 2);
  signal others_from_5 : natural_8192_1d(5 to 6);  -- other_#
  signal others_from_23 : natural_8192_1d(23 to 24);  -- other_#
  signal others_from_26 : natural_8192_1d(26 to 27);  -- other_#
  signal other_3, other_7, other_25, other_28 : natural range 0 to 2042;
  signal others_from_8 : natural_257_1d(8 to 9);  -- other_#
  signal others_from_30 : natural_257_1d(30 to 31);  -- other_#
  signal others_from_10 : boolean_1d(10 to 12);  -- other_#
  signal other_18 : boolean;
  signal others_from_21 : boolean_1d(21 to 22);  -- other_#
  signal other_13, other_29 : natural range 0 to 254;
  signal other_14 : natural range 0 to 252;
  signal other_15 : natural range 0 to 248;
  signal other_16 : natural range 0 to 240;
  signal other_17 : natural range 0 to 224;
  signal other_19 : natural range 0 to 192;
  signal other_20 : natural range 0 to 128;

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_passed_0), 1));
  disparity_valid <= as_bit(map_valid);
  disparity_start_of_frame <= as_bit(map_start_of_frame);
  disparity_end_of_line <= as_bit(map_end_of_line);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  lowwindow_leaving_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(lowwindow_ring_read_address, 4);
    write_address <= to_unsigned(lowwindow_ring_write_address, 4);
    write_data <= to_unsigned(lowcost_column_0(4 * i + 3), 8) & to_unsigned(lowcost_column_0(4 * i + 2), 8) &
      to_unsigned(lowcost_column_0(4 * i + 1), 8) & to_unsigned(lowcost_column_0(4 * i), 8);
    cell : entity work.line_memory generic map (10, 32, 4)
      port map (clock, true, read_address, lowwindow_leaving(i), write_address, write_data);
  end generate;

  lowcost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(lowcost_read_column, 10);
    write_address <= to_unsigned(lowcost_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, lowcost_read_words(i), write_address, lowcost_write_words(i));
  end generate;

  highwindow_leaving_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(lowwindow_ring_read_address, 4);
    write_address <= to_unsigned(lowwindow_ring_write_address, 4);
    write_data <= to_unsigned(highcost_column_0(4 * i + 3), 8) & to_unsigned(highcost_column_0(4 * i + 2), 8) &
      to_unsigned(highcost_column_0(4 * i + 1), 8) & to_unsigned(highcost_column_0(4 * i), 8);
    cell : entity work.line_memory generic map (10, 32, 4)
      port map (clock, true, read_address, highwindow_leaving(i), write_address, write_data);
  end generate;

  highcost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(lowcost_read_column, 10);
    write_address <= to_unsigned(lowcost_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, highcost_read_words(i), write_address, highcost_write_words(i));
  end generate;

  compared_rows_read_words_4_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(bases_asked_column, 10);
    write_address <= to_unsigned(compared_write_column, 10);
    write_data <= to_unsigned(compared_rows_write_words(4), 12);
    cell : entity work.line_memory generic map (640, 12, 10)
      port map (clock, true, read_address, compared_rows_read_words_4, write_address, write_data);
  end block;

  compared_rows_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(bases_asked_column, 10);
    write_address <= to_unsigned(compared_write_column, 10);
    write_data <= to_unsigned(compared_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (640, 24, 10)
      port map (clock, true, read_address, compared_rows_read_words(i), write_address, write_data);
  end generate;

  pairs_delayed_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(pairs_ring_read_address, 4);
    write_address <= to_unsigned(pairs_ring_write_address, 4);
    write_data <= to_unsigned(raster_features_reference_0, 12);
    cell : entity work.line_memory generic map (16, 12, 4)
      port map (clock, true, read_address, pairs_delayed_0, write_address, write_data);
  end block;

  rows_read_codes_memory : for i in 15 downto 12 generate
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(rows_address(i), 11);
    write_address <= to_unsigned(rows_write_word, 11);
    write_data <= to_unsigned(rows_write_codes(i - 12), 12);
    cell : entity work.line_memory generic map (1761, 12, 11)
      port map (clock, true, read_address, rows_read_codes(i), write_address, write_data);
  end generate;

  rows_read_codes_11_memory : for i in 11 downto 8 generate
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(rows_address(i), 11);
    write_address <= to_unsigned(rows_write_word, 11);
    write_data <= to_unsigned(rows_write_codes(i - 8), 12);
    cell : entity work.line_memory generic map (1761, 12, 11)
      port map (clock, true, read_address, rows_read_codes(i), write_address, write_data);
  end generate;

  rows_read_codes_7_memory : for i in 7 downto 4 generate
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(rows_address(i), 11);
    write_address <= to_unsigned(rows_write_word, 11);
    write_data <= to_unsigned(rows_write_codes(i - 4), 12);
    cell : entity work.line_memory generic map (1761, 12, 11)
      port map (clock, true, read_address, rows_read_codes(i), write_address, write_data);
  end generate;

  rows_read_codes_3_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(rows_address(i), 11);
    write_address <= to_unsigned(rows_write_word, 11);
    write_data <= to_unsigned(rows_write_codes(i), 12);
    cell : entity work.line_memory generic map (1761, 12, 11)
      port map (clock, true, read_address, rows_read_codes(i), write_address, write_data);
  end generate;

  bases_read_targets_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(bases_address(i), 10);
    write_address <= to_unsigned(targets_place, 10);
    write_data <= ((to_unsigned((targets_high mod 256), 8) & to_unsigned(0, 8)) or (to_unsigned(targets_low, 16)));
    cell : entity work.line_memory generic map (1024, 16, 10)
      port map (clock, true, read_address, bases_read_targets(i), write_address, write_data);
  end generate;

  ahead_held_0_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
    signal write_data : unsigned(12 downto 0);
  begin
    read_address <= to_unsigned(ahead_ring_read_address, 7);
    write_address <= to_unsigned(ahead_ring_write_address, 7);
    write_data <= to_unsigned(transform_right_code_next_bits, 6) & to_unsigned(transform_right_code_bits, 6) &
      to_unsigned(as_number(transform_filtering_start_of_frame(7)), 1);
    cell : entity work.line_memory generic map (117, 13, 7)
      port map (clock, true, read_address, ahead_held_0, write_address, write_data);
  end block;

  transform_left_rows_read_words_2_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 10);
    write_address <= to_unsigned(transform_write_column, 10);
    write_data <= to_unsigned(transform_left_rows_write_words_2, 8);
    cell : entity work.line_memory generic map (640, 8, 10)
      port map (clock, true, read_address, transform_left_rows_read_words_2, write_address, write_data);
  end block;

  transform_left_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 10);
    write_address <= to_unsigned(transform_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, transform_left_rows_read_words(i), write_address,
        transform_left_rows_write_words(i));
  end generate;

  transform_right_rows_read_words_2_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 10);
    write_address <= to_unsigned(transform_write_column, 10);
    write_data <= to_unsigned(transform_right_rows_write_words_2, 8);
    cell : entity work.line_memory generic map (640, 8, 10)
      port map (clock, true, read_address, transform_right_rows_read_words_2, write_address, write_data);
  end block;

  transform_right_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 10);
    write_address <= to_unsigned(transform_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, transform_right_rows_read_words(i), write_address,
        transform_right_rows_write_words(i));
  end generate;

  hold_back_next_next_next_next_next_next_next_next_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_next_next_next_next_next_next_next_next_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_next_next_next_next_next_next_next_next_ring_write_address, 12);
    write_data <= ((to_unsigned(65535, 16) &
      to_unsigned(as_number(hold_back_next_next_next_next_next_next_holds_groups), 1)) and
      (hold_back_next_next_next_next_next_next_next_held_0));
    cell : entity work.line_memory generic map (2819, 17, 12)
      port map (clock, true, read_address, hold_back_next_next_next_next_next_next_next_next_held_0, write_address,
        write_data);
  end block;

  hold_back_next_next_next_next_next_next_next_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_next_next_next_next_next_next_next_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_next_next_next_next_next_next_next_ring_write_address, 12);
    write_data <= ((to_unsigned(65535, 16) &
      to_unsigned(as_number(hold_back_next_next_next_next_next_next_next_holds_groups), 1)) and
      (hold_back_next_next_next_next_next_next_held_0));
    cell : entity work.line_memory generic map (2819, 17, 12)
      port map (clock, true, read_address, hold_back_next_next_next_next_next_next_next_held_0, write_address,
        write_data);
  end block;

  hold_back_next_next_next_next_next_next_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_next_next_next_next_next_next_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_next_next_next_next_next_next_ring_write_address, 12);
    write_data <= ((to_unsigned(65535, 16) & to_unsigned(as_number(hold_back_next_next_next_next_next_holds_groups),
      1)) and (hold_back_next_next_next_next_next_held_0));
    cell : entity work.line_memory generic map (2820, 17, 12)
      port map (clock, true, read_address, hold_back_next_next_next_next_next_next_held_0, write_address, write_data);
  end block;

  hold_back_next_next_next_next_next_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_next_next_next_next_next_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_next_next_next_next_next_ring_write_address, 12);
    write_data <= ((to_unsigned(65535, 16) & to_unsigned(as_number(hold_back_next_next_next_next_holds_groups), 1)) and
      (hold_back_next_next_next_next_held_0));
    cell : entity work.line_memory generic map (2820, 17, 12)
      port map (clock, true, read_address, hold_back_next_next_next_next_next_held_0, write_address, write_data);
  end block;

  hold_back_next_next_next_next_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_next_next_next_next_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_next_next_next_next_ring_write_address, 12);
    write_data <= ((to_unsigned(65535, 16) & to_unsigned(as_number(hold_back_next_next_next_holds_groups), 1)) and
      (hold_back_next_next_next_held_0));
    cell : entity work.line_memory generic map (2820, 17, 12)
      port map (clock, true, read_address, hold_back_next_next_next_next_held_0, write_address, write_data);
  end block;

  hold_back_next_next_next_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_next_next_next_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_next_next_next_ring_write_address, 12);
    write_data <= ((to_unsigned(65535, 16) & to_unsigned(as_number(hold_back_next_next_holds_groups), 1)) and
      (hold_back_next_next_held_0));
    cell : entity work.line_memory generic map (2820, 17, 12)
      port map (clock, true, read_address, hold_back_next_next_next_held_0, write_address, write_data);
  end block;

  hold_back_next_next_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_next_next_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_next_next_ring_write_address, 12);
    write_data <= ((to_unsigned(65535, 16) & to_unsigned(as_number(hold_back_next_holds_groups), 1)) and
      (hold_back_next_held_0));
    cell : entity work.line_memory generic map (2820, 17, 12)
      port map (clock, true, read_address, hold_back_next_next_held_0, write_address, write_data);
  end block;

  hold_back_next_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_next_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_next_ring_write_address, 12);
    write_data <= ((to_unsigned(65535, 16) & to_unsigned(as_number(hold_back_holds_groups), 1)) and (hold_back_held_0));
    cell : entity work.line_memory generic map (2820, 17, 12)
      port map (clock, true, read_address, hold_back_next_held_0, write_address, write_data);
  end block;

  hold_back_held_0_memory : block
    signal read_address, write_address : unsigned(11 downto 0);
    signal write_data : unsigned(16 downto 0);
  begin
    read_address <= to_unsigned(hold_back_ring_read_address, 12);
    write_address <= to_unsigned(hold_back_ring_write_address, 12);
    write_data <= to_unsigned(in_right_pixel, 8) & to_unsigned(in_left_pixel, 8) &
      to_unsigned(as_number(in_start_of_frame), 1);
    cell : entity work.line_memory generic map (2820, 17, 12)
      port map (clock, true, read_address, hold_back_held_0, write_address, write_data);
  end block;

  targets_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(targets_read_column, 7);
    write_address <= to_unsigned(targets_write_column, 7);
    write_data <= to_unsigned(targets_rows_write_words(1), 11);
    cell : entity work.line_memory generic map (80, 11, 7)
      port map (clock, true, read_address, targets_rows_read_words_1, write_address, write_data);
  end block;

  targets_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(targets_read_column, 7);
    write_address <= to_unsigned(targets_write_column, 7);
    write_data <= to_unsigned(targets_rows_write_words(0), 22);
    cell : entity work.line_memory generic map (80, 22, 7)
      port map (clock, true, read_address, targets_rows_read_words_0, write_address, write_data);
  end block;

  ranges_pairs_read_words_0_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(ranges_paired_column, 7);
    write_address <= to_unsigned(ranges_pairs_written, 7);
    write_data <= to_unsigned(ranges_pairs_write_words_0, 11);
    cell : entity work.line_memory generic map (81, 11, 7)
      port map (clock, true, read_address, ranges_pairs_read_words_0, write_address, write_data);
  end block;

  ranges_pixels_read_words_0_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(ranges_in_column, 8);
    write_address <= to_unsigned(ranges_pixels_written, 8);
    write_data <= to_unsigned(ranges_pixels_write_words_0, 12);
    cell : entity work.line_memory generic map (161, 12, 8)
      port map (clock, true, read_address, ranges_pixels_read_words_0, write_address, write_data);
  end block;

  coarseleftright_found_0_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(4 downto 0);
  begin
    read_address <= to_unsigned(coarseleftright_address_0, 6);
    write_address <= to_unsigned(coarseleftright_position, 6);
    write_data <= to_unsigned(coarseleftright_other_0(4), 5);
    cell : entity work.line_memory generic map (64, 5, 6)
      port map (clock, true, read_address, coarseleftright_found_0, write_address, write_data);
  end block;

  coarseleftright_held_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(12 downto 0);
  begin
    read_address <= to_unsigned(coarseleftright_ring_read_address, 5);
    write_address <= to_unsigned(coarseleftright_ring_write_address, 5);
    write_data <= to_unsigned(1, 1) & to_unsigned(coarseslice1_best_index_0_0, 8) &
      to_unsigned(as_number(coarseslice1_best_tag.end_of_line), 1) &
      to_unsigned(as_number(coarseslice1_best_tag.start_of_frame), 1) &
      to_unsigned(as_number(coarseslice1_best_tag.output_column), 1) &
      to_unsigned(as_number(coarseslice1_best_tag.map_column), 1);
    cell : entity work.line_memory generic map (32, 13, 5)
      port map (clock, true, read_address, coarseleftright_held_0, write_address, write_data);
  end block;

  coarserows_search_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(coarsedelay_column, 8);
    write_address <= to_unsigned(coarserows_write_column, 8);
    write_data <= to_unsigned(coarserows_search_rows_write_words(1), 6);
    cell : entity work.line_memory generic map (192, 6, 8)
      port map (clock, true, read_address, coarserows_search_rows_read_words_1, write_address, write_data);
  end block;

  coarserows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(coarsedelay_column, 8);
    write_address <= to_unsigned(coarserows_write_column, 8);
    write_data <= to_unsigned(coarserows_search_rows_write_words(0), 30);
    cell : entity work.line_memory generic map (192, 30, 8)
      port map (clock, true, read_address, coarserows_search_rows_read_words_0, write_address, write_data);
  end block;

  coarserows_reference_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(coarsedelay_column, 8);
    write_address <= to_unsigned(coarserows_write_column, 8);
    write_data <= to_unsigned(coarserows_reference_rows_write_words(1), 6);
    cell : entity work.line_memory generic map (192, 6, 8)
      port map (clock, true, read_address, coarserows_reference_rows_read_words_1, write_address, write_data);
  end block;

  coarserows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(coarsedelay_column, 8);
    write_address <= to_unsigned(coarserows_write_column, 8);
    write_data <= to_unsigned(coarserows_reference_rows_write_words(0), 30);
    cell : entity work.line_memory generic map (192, 30, 8)
      port map (clock, true, read_address, coarserows_reference_rows_read_words_0, write_address, write_data);
  end block;

  coarsedelay_delayed_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(coarsedelay_ring_read_address, 5);
    write_address <= to_unsigned(coarsedelay_ring_write_address, 5);
    write_data <= to_unsigned(coarseraster_features_reference_0, 6);
    cell : entity work.line_memory generic map (32, 6, 5)
      port map (clock, true, read_address, coarsedelay_delayed_0, write_address, write_data);
  end block;

  coarsetransform_left_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(coarsetransform_counter_column, 8);
    write_address <= to_unsigned(coarsetransform_write_column, 8);
    cell : entity work.line_memory generic map (192, 32, 8)
      port map (clock, true, read_address, coarsetransform_left_rows_read_words_0, write_address,
        coarsetransform_left_rows_write_words_0);
  end block;

  coarsetransform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(coarsetransform_counter_column, 8);
    write_address <= to_unsigned(coarsetransform_write_column, 8);
    cell : entity work.line_memory generic map (192, 32, 8)
      port map (clock, true, read_address, coarsetransform_right_rows_read_words_0, write_address,
        coarsetransform_right_rows_write_words_0);
  end block;

  coarse_pixels_read_word_0_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(coarse_pixels_sum_column, 8);
    write_address <= to_unsigned(coarse_pixels_total_column, 8);
    write_data <= to_unsigned(coarse_pixels_total, 24);
    cell : entity work.line_memory generic map (160, 24, 8)
      port map (clock, true, read_address, coarse_pixels_read_word_0, write_address, write_data);
  end block;

  process
    variable coarse_pixels_column_any, coarse_pixels_column_all, coarse_pixels_first_row_is_equal,
      coarse_pixels_first_row_choice, coarse_pixels_repetition_differs, coarse_pixels_out_valid_all,
      coarse_pixels_left_sum_is_equal, coarsetransform_counter_group_all, coarsetransform_counter_group_choice_2,
      coarsetransform_centre_group_any, coarsetransform_from_first_0_value, coarsetransform_from_first_0_differs,
      coarsetransform_up_to_last_0_choice, coarseraster_place_group_all, coarseraster_place_group_choice_2,
      coarsedelay_row_inside_3_is_not_less, coarsedelay_row_inside_3_is_less, coarsedelay_tag_border_column_choice,
      coarsedelay_tag_first_cost_is_equal, coarsedelay_tag_map_column_is_not_less, coarsedelay_tag_map_column_is_less,
      coarseslice0winner5_best_cost_0_0_is_less, coarseslice1other_cost_0_1_any,
      coarseslice1winner3_best_cost_0_0_is_less, coarseleftright_holds_winners_choice, ranges_column_differs,
      ranges_column_is_equal, ranges_row_choice_2, ranges_pixel_0_choice, ranges_centre_valid_differs,
      targets_pause_all, targets_pause_is_equal, targets_walked_is_equal, targets_walked_any, targets_column_range_any,
      targets_around_is_equal, targets_around_differs, targets_low_all, targets_low_differs,
      hold_back_holds_groups_is_equal, hold_back_next_holds_groups_any, hold_back_next_next_holds_groups_is_equal,
      hold_back_next_next_next_holds_groups_any, hold_back_next_next_next_next_holds_groups_is_equal,
      hold_back_next_next_next_next_next_holds_groups_any, hold_back_next_next_next_next_next_next_holds_groups_any,
      hold_back_next_next_next_next_next_next_next_holds_groups_is_equal,
      hold_back_next_next_next_next_next_next_next_next_holds_groups_any, transform_counter_group_all,
      transform_counter_group_differs, transform_centre_column_is_less, transform_counter_column_choice,
      ahead_holds_groups_is_equal, raster_place_group_is_equal, bases_address_0_is_less, rows_newest_column_any,
      rows_newest_column_is_equal, rows_newest_row_is_equal, rows_enter_row_all, rows_write_codes_0_all,
      pairs_tag_first_cost_is_equal, lowchain_lane_0_0_all, lowchain_lane_1_0_choice, lowwinner4_best_cost_0_0_is_less,
      highwinner4_best_cost_0_0_is_less, choice_best_cost_0_0_is_less, refinement_divisor_0_0_is_less : boolean;
    variable coarse_pixels_column_is_equals, coarsetransform_counter_group_is_equals,
      transform_counter_group_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable coarse_pixels_column_choices, coarse_pixels_part_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable coarse_pixels_row_choices : natural_3_1d(1 to 2);  -- _choice_#
    variable coarse_pixels_repetition_choice, coarse_pixels_left_sum_choice, coarse_pixels_right_sum_choice,
      targets_pause_choice : natural range 0 to 65535;
    variable coarse_pixels_total_choice : natural range 0 to 16777215;
    variable coarsetransform_counter_group_choice, coarseraster_place_group_choice,
      transform_counter_group_choice : natural range 0 to 15;
    variable coarsetransform_counter_group_choices, coarseraster_place_group_choices : natural_127_1d(3 to 4);  -- _choice_#
    variable coarsetransform_counter_next_frame_choices, ranges_column_choices : boolean_1d(1 to 3);  -- _choice_#
    variable coarseraster_place_group_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable coarseraster_place_next_frame_choices : boolean_1d(1 to 4);  -- _choice_#
    variable coarseslice0other_cost_0_all : boolean_1d(0 to 1);  -- _#_all
    variable coarseslice0other_cost_0_choice : boolean_1d(1 to 23);  -- _#_choice
    variable coarseslice0winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- _#_is_less
    variable coarseslice0winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- _#_is_less
    variable coarseslice0winner3_best_cost_0_is_less, coarseslice1winner1_best_cost_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable coarseslice0winner4_best_cost_0_is_less, coarseslice1winner2_best_cost_0_is_less,
      lowwinner3_best_cost_0_is_less, highwinner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
    variable coarseslice1other_cost_0_choice : boolean_1d(1 to 6);  -- _#_choice
    variable coarseleftright_checked_passed_0_difference : integer range -30 to 64;
    variable ranges_column_anys : boolean_1d(1 to 3);  -- _any_#
    variable ranges_column_alls : boolean_1d(1 to 2);  -- _all_#
    variable ranges_column_choices_from_4 : natural_255_1d(4 to 5);  -- _choice_#
    variable ranges_row_choice, bases_address_0_choice_2 : natural range 0 to 127;
    variable ranges_counts_sum : natural range 1 to 32;
    variable ranges_counts_differences : integer_minus_30_to_32_1d(1 to 4);  -- _difference_#
    variable ranges_counts_sum_2 : natural range 0 to 4;
    variable ranges_pair_0_values : boolean_1d(1 to 4);  -- _value_#
    variable ranges_pair_0_choices : boolean_1d(1 to 15);  -- _choice_#
    variable ranges_pair_0_choice_6, targets_column_range_choice_79, lowwinner4_best_below_0_0_choice,
      lowwinner4_best_above_0_0_choice, highwinner4_best_below_0_0_choice, highwinner4_best_above_0_0_choice,
      refinement_divisor_0_0_choice : natural range 0 to 2047;
    variable ranges_pair_0_choices_from_7 : natural_31_1d(7 to 17);  -- _choice_#
    variable ranges_pair_0_choice_16 : natural range 0 to 63;
    variable ranges_range_values : boolean_1d(1 to 8);  -- _value_#
    variable ranges_range_choices : boolean_1d(1 to 13);  -- _choice_#
    variable ranges_range_choices_from_7 : natural_31_1d(7 to 14);  -- _choice_#
    variable targets_walked_alls : boolean_1d(1 to 3);  -- _all_#
    variable targets_walk_place_choices : natural_127_1d(1 to 2);  -- _choice_#
    variable targets_last_row_choices, transform_counter_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
    variable targets_column_range_values : boolean_1d(1 to 20);  -- _value_#
    variable targets_column_range_alls : boolean_1d(1 to 5);  -- _all_#
    variable targets_column_range_choices : boolean_1d(1 to 75);  -- _choice_#
    variable targets_column_range_value_10, targets_around_choice_32, bases_address_0_value,
      bases_address_0_choice : natural range 0 to 1023;
    variable targets_column_range_choices_from_35 : natural_1023_1d(35 to 64);  -- _choice_#
    variable targets_column_range_choices_from_38 : natural_31_1d(38 to 78);  -- _choice_#
    variable targets_column_range_values_from_21 : natural_31_1d(21 to 22);  -- _value_#
    variable targets_around_choices : boolean_1d(1 to 47);  -- _choice_#
    variable targets_around_values : boolean_1d(1 to 25);  -- _value_#
    variable targets_around_alls : boolean_1d(1 to 4);  -- _all_#
    variable targets_around_choices_from_21 : natural_2047_1d(21 to 22);  -- _choice_#
    variable targets_around_choices_from_23 : natural_31_1d(23 to 49);  -- _choice_#
    variable targets_around_choices_from_29 : natural_63_1d(29 to 30);  -- _choice_#
    variable targets_low_wish_value, targets_high_wish_value : natural range 0 to 124;
    variable targets_low_wish_choices, targets_high_wish_choices : natural_124_1d(1 to 2);  -- _choice_#
    variable targets_low_choices, targets_high_choices : natural_32767_1d(1 to 5);  -- _choice_#
    variable targets_low_choice_2, targets_high_choice_2 : natural range 0 to 3;
    variable targets_low_sum : natural range 0 to 32767;
    variable transform_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_centre_column_choice : natural range 159 to 255;
    variable bases_address_0_value_2 : natural range 0 to 1008;
    variable bases_goal_0_value : natural_254_1d(0 to 2);  -- _#_value
    variable bases_rises_sum : natural_3_to_65538_2d(0 to 1, 0 to 1);  -- _#_#_sum
    variable bases_rises_all, bases_falls_all : boolean_2d(0 to 1, 0 to 1);  -- _#_#_all
    variable bases_base_choice : natural_65535_3d(0 to 1, 0 to 2, 1 to 2);  -- _#_#_choice_#
    variable bases_base_2_sum : natural_3_to_65538_1d(0 to 1);  -- _#_2_sum
    variable rows_last_3_sum : natural range 0 to 4095;
    variable rows_newest_column_sum : natural range 1 to 65536;
    variable rows_newest_column_choices : natural_65535_1d(1 to 2);  -- _choice_#
    variable rows_newest_row_sum : natural range 5 to 2052;
    variable rows_newest_row_choices : natural_2047_1d(1 to 4);  -- _choice_#
    variable rows_enter_row_choices, rows_leave_row_choices : natural_2047_1d(1 to 3);  -- _choice_#
    variable rows_position_sum : natural_9214_2d(0 to 1, 0 to 1);  -- _#_#_sum
    variable rows_address_value : natural_2016_1d(0 to 3);  -- _4#_value
    variable rows_address_value_2 : natural_31_1d(0 to 3);  -- _4#_value_2
    variable rows_codes_choice : natural_4095_4d(0 to 1, 0 to 1, 0 to 2, 1 to 2);  -- _#_#_#_choice_#
    variable rows_write_word_choices : natural_63_1d(1 to 3);  -- _choice_#
    variable lowcost_pixels_first_0_value : boolean_2d(0 to 1, 1 to 20);  -- _#_0_value_#
    variable lowcost_pixels_first_choice, highcost_pixels_first_choice : boolean_3d(0 to 1, 0 to 15, 1 to 12);  -- _#_#_choice_#
    variable lowcost_pixels_first_1_differs : boolean_2d(0 to 1, 1 to 12);  -- _#_1_differs_#
    variable lowcost_column_0_choice, highcost_column_0_choice : natural_255_2d(0 to 15, 1 to 2);  -- _#_choice_#
    variable lowwindow_change_0_choice, highwindow_change_0_choice : natural_255_1d(0 to 15);  -- _#_choice
    variable lowwindow_sum_0_choice, highwindow_sum_0_choice : natural_2047_1d(0 to 15);  -- _#_choice
    variable lowwinner1_best_cost_0_is_less, highwinner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- _#_is_less
    variable lowwinner2_best_cost_0_is_less, highwinner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable lowwinner2_best_below_0_choice, lowwinner2_best_above_0_choice, highwinner2_best_below_0_choice,
      highwinner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- _#_choice
    variable lowwinner3_best_below_0_choice, lowwinner3_best_above_0_choice, highwinner3_best_below_0_choice,
      highwinner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- _#_choice
    variable highchain_lane_0_choice : boolean_1d(0 to 1);  -- _#_0_choice
    variable refinement_remainder_1_0_difference : natural range 2049 to 6143;
    variable refinement_remainder_0_difference : natural_2049_to_8190_1d(2 to 7);  -- _#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable other_29_choice : natural range 95 to 127;
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    ranges_pair_0_choices := (others => false); ranges_pair_0_choices_from_7 := (others => 0);
    ranges_range_choices := (others => false); ranges_range_choices_from_7 := (others => 0);
    rows_codes_choice := (others => (others => (others => (others => 0)))); targets_around_choices := (others => false);
    targets_around_choices_from_23 := (others => 0); targets_column_range_choices := (others => false);
    targets_column_range_choices_from_35 := (others => 0); targets_column_range_choices_from_38 := (others => 0);
    targets_column_range_values := (others => false); targets_high_choices := (others => 0);
    targets_low_choices := (others => 0);
    -- coarse
    coarse_pixels_column_any := (not in_start_of_frame) or (not in_valid);
    coarse_pixels_column_is_equals(1) := coarse_pixels_part = 3;
    coarse_pixels_column_is_equals(2) := coarse_pixels_column = 159;
    coarse_pixels_column_all := coarse_pixels_column_is_equals(1) and coarse_pixels_column_is_equals(2);
    coarse_pixels_column_choices(1) := choice(coarse_pixels_column_all, 0, (coarse_pixels_column +
      as_number(coarse_pixels_column_is_equals(1))) mod 256);
    coarse_pixels_column_choices(2) := choice(in_valid, coarse_pixels_column_choices(1), coarse_pixels_column);
    coarse_pixels_part_choices(1) := choice(coarse_pixels_column_is_equals(1), 0, (coarse_pixels_part + 1) mod 256);
    coarse_pixels_part_choices(2) := choice(in_valid, coarse_pixels_part_choices(1), coarse_pixels_part);
    coarse_pixels_row_choices(1) := choice(coarse_pixels_column_all, (coarse_pixels_row + 1) mod 4, coarse_pixels_row);
    coarse_pixels_row_choices(2) := choice(in_valid, coarse_pixels_row_choices(1), coarse_pixels_row);
    coarse_pixels_first_row_is_equal := coarse_pixels_row = 3;
    coarse_pixels_first_row_choice := choice(in_valid, in_start_of_frame, coarse_pixels_first_row);
    coarse_pixels_repetition_differs := coarse_pixels_repetition /= 32;
    coarse_pixels_repetition_choice := choice(coarse_pixels_repetition_differs, (coarse_pixels_repetition + 1) mod
      65536, 32);
    coarse_pixels_out_valid_all := coarse_pixels_total_is_last and coarse_pixels_total_ends;
    coarse_pixels_left <= in_left_pixel;
    coarse_pixels_right <= in_right_pixel;
    coarse_pixels_valid <= in_valid;
    coarse_pixels_sum_ends <= coarse_pixels_column_is_equals(1) and coarse_pixels_valid;
    coarse_pixels_sum_is_first <= coarse_pixels_row = 0;
    coarse_pixels_sum_is_last <= coarse_pixels_first_row_is_equal;
    coarse_pixels_sum_starts <= coarse_pixels_first_row;
    coarse_pixels_sum_column <= coarse_pixels_column;
    coarse_pixels_left_read <= coarse_pixels_left_sum;
    coarse_pixels_right_read <= coarse_pixels_right_sum mod 4096;
    coarse_pixels_read_column <= coarse_pixels_sum_column;
    coarse_pixels_read_ends <= coarse_pixels_sum_ends;
    coarse_pixels_read_is_first <= coarse_pixels_sum_is_first;
    coarse_pixels_read_is_last <= coarse_pixels_sum_is_last;
    coarse_pixels_read_starts <= coarse_pixels_sum_starts;
    coarse_pixels_total_ends <= coarse_pixels_read_ends;
    coarse_pixels_total_is_last <= coarse_pixels_read_is_last;
    coarse_pixels_total_starts <= coarse_pixels_read_starts;
    coarse_pixels_out_start <= coarse_pixels_total_starts and coarse_pixels_total_is_last and
      (coarse_pixels_total_column = 0) and coarse_pixels_total_ends;
    coarse_pixels_out_valid <= coarse_pixels_repetition_differs or coarse_pixels_out_valid_all;
    coarse_pixels_column <= choice(coarse_pixels_column_any, coarse_pixels_column_choices(2), 0);
    coarse_pixels_part <= choice(coarse_pixels_column_any, coarse_pixels_part_choices(2), 0);
    coarse_pixels_row <= choice(coarse_pixels_column_any, coarse_pixels_row_choices(2), 0);
    coarse_pixels_first_row <= choice(coarse_pixels_column_is_equals(1) and coarse_pixels_column_is_equals(2) and
      coarse_pixels_first_row and coarse_pixels_first_row_is_equal, coarse_pixels_first_row_choice,
      coarse_pixels_first_row or (in_start_of_frame and in_valid));
    coarse_pixels_repetition <= choice(coarse_pixels_total_is_last and coarse_pixels_total_ends and
      (coarse_pixels_total_column = 159), 0, coarse_pixels_repetition_choice);
    coarse_pixels_left_sum_is_equal := coarse_pixels_part = 0;
    coarse_pixels_left_sum_choice := choice(coarse_pixels_left_sum_is_equal, 0, coarse_pixels_left_sum);
    coarse_pixels_right_sum_choice := choice(coarse_pixels_left_sum_is_equal, 0, coarse_pixels_right_sum);
    if coarse_pixels_valid then
      coarse_pixels_left_sum <= (coarse_pixels_left_sum_choice + coarse_pixels_left) mod 65536;
      coarse_pixels_right_sum <= (coarse_pixels_right_sum_choice + coarse_pixels_right) mod 65536;
    end if;
    coarse_pixels_total_choice := choice(coarse_pixels_read_is_first, 0, to_integer(coarse_pixels_read_word_0));
    if coarse_pixels_read_ends then
      coarse_pixels_total <= (to_integer(((to_unsigned(coarse_pixels_right_read, 12) & to_unsigned(0, 12)) or
        (to_unsigned(coarse_pixels_left_read, 24)))) + coarse_pixels_total_choice) mod 16777216;
      coarse_pixels_total_column <= coarse_pixels_read_column;
    end if;
    if coarse_pixels_out_valid_all then
      coarse_pixels_out_left <= ((((coarse_pixels_total / 8) + 1) mod 512) * 8) / 16;
      coarse_pixels_out_right <= ((((coarse_pixels_total / 32768) + 1) mod 512) * 8) / 16;
    end if;
    -- coarsetransform
    coarsetransform_counter_group_is_equals(1) := coarsetransform_counter_column = 191;
    coarsetransform_counter_group_is_equals(2) := coarsetransform_counter_group = 119;
    coarsetransform_counter_group_all := coarsetransform_counter_group_is_equals(1) and
      coarsetransform_counter_group_is_equals(2);
    coarsetransform_counter_group_choice := choice(coarsetransform_counter_group_all, 15, 0);
    coarsetransform_counter_group_choice_2 := choice((coarsetransform_counter_group / 2) = 61,
      coarsetransform_counter_group_is_equals(1) and coarse_pixels_out_valid and is_set(coarsetransform_counter_group,
      0), coarsetransform_counter_group_is_equals(1) and coarse_pixels_out_valid);
    coarsetransform_counter_group_choices(3) := choice(coarsetransform_counter_next_frame and
      (coarsetransform_counter_group = 121), 2, (coarsetransform_counter_group + 1) mod 128);
    coarsetransform_counter_group_choices(4) := choice(coarsetransform_counter_group_choice_2,
      coarsetransform_counter_group_choices(3), coarsetransform_counter_group);
    coarsetransform_counter_next_frame_choices(1) := choice(coarsetransform_counter_group_is_equals(1) and
      ((coarsetransform_counter_group / 4) = 30), coarsetransform_counter_next_frame and
      (is_set(coarsetransform_counter_group, 1) or (not is_set(coarsetransform_counter_group, 0))),
      coarsetransform_counter_next_frame);
    coarsetransform_counter_next_frame_choices(2) := choice(coarsetransform_counter_group_all, coarse_pixels_out_valid,
      coarse_pixels_out_valid and (not coarse_pixels_out_start));
    coarsetransform_counter_next_frame_choices(3) := choice(coarsetransform_counter_next_frame_choices(1),
      coarsetransform_counter_next_frame_choices(2), coarsetransform_counter_group_is_equals(1) and
      coarsetransform_counter_group_is_equals(2) and coarse_pixels_out_valid and coarse_pixels_out_start);
    coarsetransform_centre_group_any := (((coarsetransform_counter_column / 2) mod 16) /= 0) or
      is_set(coarsetransform_counter_column, 7) or is_set(coarsetransform_counter_column, 6) or
      is_set(coarsetransform_counter_column, 5);
    coarsetransform_from_first_0_value := is_set(coarsetransform_centre_group, 2);
    coarsetransform_from_first_0_differs := (other_29 / 2) /= 0;
    coarsetransform_up_to_last_0_choice := choice(((other_29 / 2) mod 16) = 15, is_set(other_29, 7) and
      (is_set(other_29, 6) or is_set(other_29, 5)), (other_29 / 64) = 3);
    coarsetransform_left_0 <= coarse_pixels_out_left;
    coarsetransform_right_0 <= coarse_pixels_out_right;
    coarsetransform_valid <= coarse_pixels_out_valid;
    coarsetransform_counter_next_frame <= coarsetransform_counter_next_frame_choices(3) or ((not
      coarse_pixels_out_valid) and coarsetransform_counter_next_frame);
    coarsetransform_left_rows_read_newest_0 <= coarsetransform_left_0;
    coarsetransform_left_rows_ready_words_0 <= coarsetransform_left_rows_read_words_0;
    coarsetransform_left_rows_ready_newest_0 <= coarsetransform_left_rows_read_newest_0;
    coarsetransform_right_rows_read_newest_0 <= coarsetransform_right_0;
    coarsetransform_right_rows_ready_words_0 <= coarsetransform_right_rows_read_words_0;
    coarsetransform_right_rows_ready_newest_0 <= coarsetransform_right_rows_read_newest_0;
    coarsetransform_read_column <= coarsetransform_counter_column;
    coarsetransform_ready_column <= coarsetransform_read_column;
    coarsetransform_centre_group <= coarsetransform_counter_group + as_number(coarsetransform_centre_group_any);
    coarsetransform_up_to_last_0 <= (not coarsetransform_up_to_last_0_choice) and (not
      ((coarsetransform_from_first_0_value or is_set(coarsetransform_centre_group, 1) or
      is_set(coarsetransform_centre_group, 0)) and (((coarsetransform_centre_group / 8) mod 16) = 15))) and (not
      is_set(coarsetransform_centre_group, 7));
    for i in 0 to 3 loop
      coarsetransform_left_column(i) <= to_integer(coarsetransform_left_rows_ready_words_0(8 * i + 7 downto 8 * i));
    end loop;
    coarsetransform_left_column(4) <= coarsetransform_left_rows_ready_newest_0;
    for i in 0 to 3 loop
      coarsetransform_right_column(i) <= to_integer(coarsetransform_right_rows_ready_words_0(8 * i + 7 downto 8 * i));
    end loop;
    coarsetransform_right_column(4) <= coarsetransform_right_rows_ready_newest_0;
    coarsetransform_columns_inside_0 <= coarsetransform_up_to_last_0 and coarsetransform_from_first_0;
    coarsetransform_columns_start_of_frame <= is_set(others_from_30(30), 0);
    coarsetransform_columns_valid <= is_set(others_from_30(30), 8);
    coarsetransform_left_code_column_centre <= coarsetransform_left_column(2);
    coarsetransform_left_code_column_near <= coarsetransform_left_column(1) + coarsetransform_left_column(3);
    coarsetransform_left_code_column_outer <= (510 - coarsetransform_left_column(0)) - coarsetransform_left_column(4);
    coarsetransform_left_code_column_upper <= 765 - ((((coarsetransform_left_column(0) / 2) +
      coarsetransform_left_column(1)) * 2) + (coarsetransform_left_column(0) mod 2));
    coarsetransform_left_code_column_lower <= ((coarsetransform_left_column(3) + (coarsetransform_left_column(4) / 2))
      * 2) + (coarsetransform_left_column(4) mod 2);
    coarsetransform_left_code_column_response(0) <= ((coarsetransform_left_code_column_centre +
      (coarsetransform_left_code_column_near / 2)) * 2) + (coarsetransform_left_code_column_near mod 2);
    coarsetransform_left_code_column_response(1) <= ((coarsetransform_left_code_column_centre +
      (coarsetransform_left_code_column_outer / 2)) * 2) + (coarsetransform_left_code_column_outer mod 2);
    coarsetransform_left_code_column_response_2 <= coarsetransform_left_code_column_upper +
      coarsetransform_left_code_column_lower;
    coarsetransform_left_code_row_centre(0) <= coarsetransform_left_code_row_column(0, 1);
    coarsetransform_left_code_row_centre(1) <= coarsetransform_left_code_row_column(1, 1);
    coarsetransform_left_code_row_centre(2) <= coarsetransform_left_code_row_column_2(1);
    coarsetransform_left_code_row_outer_1 <= coarsetransform_left_code_column_response(1) +
      coarsetransform_left_code_row_column(1, 3);
    coarsetransform_left_code_row_outer_2 <= coarsetransform_left_code_column_response_2 +
      coarsetransform_left_code_row_column_2(3);
    coarsetransform_left_code_row_before(0) <= ((coarsetransform_left_code_row_column(0, 2) +
      (coarsetransform_left_code_row_column(0, 3) / 2)) * 2) + (coarsetransform_left_code_row_column(0, 3) mod 2);
    coarsetransform_left_code_row_before(1) <= ((coarsetransform_left_code_row_column(1, 2) +
      (coarsetransform_left_code_row_column(1, 3) / 2)) * 2) + (coarsetransform_left_code_row_column(1, 3) mod 2);
    coarsetransform_left_code_row_before_2 <= ((coarsetransform_left_code_row_column_2(2) +
      (coarsetransform_left_code_row_column_2(3) / 2)) * 2) + (coarsetransform_left_code_row_column_2(3) mod 2);
    coarsetransform_left_code_row_after(0) <= (((coarsetransform_left_code_column_response(0) / 2) +
      coarsetransform_left_code_row_column(0, 0)) * 2) + (coarsetransform_left_code_column_response(0) mod 2);
    coarsetransform_left_code_row_after(1) <= (((coarsetransform_left_code_column_response(1) / 2) +
      coarsetransform_left_code_row_column(1, 0)) * 2) + (coarsetransform_left_code_column_response(1) mod 2);
    coarsetransform_left_code_row_after_2 <= (((coarsetransform_left_code_column_response_2 / 2) +
      coarsetransform_left_code_row_column_2(0)) * 2) + (coarsetransform_left_code_column_response_2 mod 2);
    coarsetransform_left_code_row_even(1) <= ((((coarsetransform_left_code_row_outer_1 / 2) -
      coarsetransform_left_code_row_centre(1)) mod 8192) * 2) + (coarsetransform_left_code_row_outer_1 mod 2);
    coarsetransform_left_code_row_even(2) <= ((((coarsetransform_left_code_row_outer_2 / 2) -
      coarsetransform_left_code_row_centre(2)) mod 8192) * 2) + (coarsetransform_left_code_row_outer_2 mod 2);
    coarsetransform_left_code_row_odd(1) <= (coarsetransform_left_code_row_before(1) -
      coarsetransform_left_code_row_after(1)) mod 16384;
    coarsetransform_left_code_row_odd(2) <= (coarsetransform_left_code_row_before_2 -
      coarsetransform_left_code_row_after_2) mod 16384;
    coarsetransform_left_code_row_signs <= ((others_from_26(26) / 8192) * 2) + (others_from_26(27) / 8192) +
      ((((coarsetransform_left_code_row_even(2) + coarsetransform_left_code_row_odd(1)) mod 16384) / 8192) * 8) +
      ((((coarsetransform_left_code_row_odd(1) - coarsetransform_left_code_row_even(2)) mod 16384) / 8192) * 32) +
      ((((coarsetransform_left_code_row_even(1) - coarsetransform_left_code_row_odd(2)) mod 16384) / 8192) * 4) +
      ((((coarsetransform_left_code_row_even(1) + coarsetransform_left_code_row_odd(2)) mod 16384) / 8192) * 16);
    coarsetransform_right_code_column_centre <= coarsetransform_right_column(2);
    coarsetransform_right_code_column_near <= coarsetransform_right_column(1) + coarsetransform_right_column(3);
    coarsetransform_right_code_column_outer <= (510 - coarsetransform_right_column(0)) -
      coarsetransform_right_column(4);
    coarsetransform_right_code_column_upper <= 765 - ((((coarsetransform_right_column(0) / 2) +
      coarsetransform_right_column(1)) * 2) + (coarsetransform_right_column(0) mod 2));
    coarsetransform_right_code_column_lower <= ((coarsetransform_right_column(3) + (coarsetransform_right_column(4) /
      2)) * 2) + (coarsetransform_right_column(4) mod 2);
    coarsetransform_right_code_column_response(0) <= ((coarsetransform_right_code_column_centre +
      (coarsetransform_right_code_column_near / 2)) * 2) + (coarsetransform_right_code_column_near mod 2);
    coarsetransform_right_code_column_response(1) <= ((coarsetransform_right_code_column_centre +
      (coarsetransform_right_code_column_outer / 2)) * 2) + (coarsetransform_right_code_column_outer mod 2);
    coarsetransform_right_code_column_response_2 <= coarsetransform_right_code_column_upper +
      coarsetransform_right_code_column_lower;
    coarsetransform_right_code_row_centre(0) <= coarsetransform_right_code_row_column(0, 1);
    coarsetransform_right_code_row_centre(1) <= coarsetransform_right_code_row_column(1, 1);
    coarsetransform_right_code_row_centre(2) <= coarsetransform_right_code_row_column_2(1);
    coarsetransform_right_code_row_outer_1 <= coarsetransform_right_code_column_response(1) +
      coarsetransform_right_code_row_column(1, 3);
    coarsetransform_right_code_row_outer_2 <= coarsetransform_right_code_column_response_2 +
      coarsetransform_right_code_row_column_2(3);
    coarsetransform_right_code_row_before(0) <= ((coarsetransform_right_code_row_column(0, 2) +
      (coarsetransform_right_code_row_column(0, 3) / 2)) * 2) + (coarsetransform_right_code_row_column(0, 3) mod 2);
    coarsetransform_right_code_row_before(1) <= ((coarsetransform_right_code_row_column(1, 2) +
      (coarsetransform_right_code_row_column(1, 3) / 2)) * 2) + (coarsetransform_right_code_row_column(1, 3) mod 2);
    coarsetransform_right_code_row_before_2 <= ((coarsetransform_right_code_row_column_2(2) +
      (coarsetransform_right_code_row_column_2(3) / 2)) * 2) + (coarsetransform_right_code_row_column_2(3) mod 2);
    coarsetransform_right_code_row_after(0) <= (((coarsetransform_right_code_column_response(0) / 2) +
      coarsetransform_right_code_row_column(0, 0)) * 2) + (coarsetransform_right_code_column_response(0) mod 2);
    coarsetransform_right_code_row_after(1) <= (((coarsetransform_right_code_column_response(1) / 2) +
      coarsetransform_right_code_row_column(1, 0)) * 2) + (coarsetransform_right_code_column_response(1) mod 2);
    coarsetransform_right_code_row_after_2 <= (((coarsetransform_right_code_column_response_2 / 2) +
      coarsetransform_right_code_row_column_2(0)) * 2) + (coarsetransform_right_code_column_response_2 mod 2);
    coarsetransform_right_code_row_even(1) <= ((((coarsetransform_right_code_row_outer_1 / 2) -
      coarsetransform_right_code_row_centre(1)) mod 8192) * 2) + (coarsetransform_right_code_row_outer_1 mod 2);
    coarsetransform_right_code_row_even(2) <= ((((coarsetransform_right_code_row_outer_2 / 2) -
      coarsetransform_right_code_row_centre(2)) mod 8192) * 2) + (coarsetransform_right_code_row_outer_2 mod 2);
    coarsetransform_right_code_row_odd(1) <= (coarsetransform_right_code_row_before(1) -
      coarsetransform_right_code_row_after(1)) mod 16384;
    coarsetransform_right_code_row_odd(2) <= (coarsetransform_right_code_row_before_2 -
      coarsetransform_right_code_row_after_2) mod 16384;
    coarsetransform_right_code_row_signs <= ((others_from_23(23) / 8192) * 2) + (others_from_23(24) / 8192) +
      ((((coarsetransform_right_code_row_even(2) + coarsetransform_right_code_row_odd(1)) mod 16384) / 8192) * 8) +
      ((((coarsetransform_right_code_row_odd(1) - coarsetransform_right_code_row_even(2)) mod 16384) / 8192) * 32) +
      ((((coarsetransform_right_code_row_even(1) - coarsetransform_right_code_row_odd(2)) mod 16384) / 8192) * 4) +
      ((((coarsetransform_right_code_row_even(1) + coarsetransform_right_code_row_odd(2)) mod 16384) / 8192) * 16);
    coarsetransform_filtering_inside_0(0) <= coarsetransform_columns_inside_0;
    coarsetransform_filtering_start_of_frame(0) <= coarsetransform_columns_start_of_frame;
    coarsetransform_filtering_valid(0) <= coarsetransform_columns_valid;
    for i in 1 to 4 loop
      coarsetransform_filtering_inside_0(i) <= coarsetransform_filtering_inside_0(i - 1);
      coarsetransform_filtering_start_of_frame(i) <= coarsetransform_filtering_start_of_frame(i - 1);
      coarsetransform_filtering_valid(i) <= coarsetransform_filtering_valid(i - 1);
    end loop;
    coarsetransform_filtering_start_of_frame(5) <= coarsetransform_filtering_start_of_frame(4);
    coarsetransform_filtering_valid(5) <= coarsetransform_filtering_valid(4);
    coarsetransform_counter_group <= choice(coarse_pixels_out_valid and coarse_pixels_out_start,
      coarsetransform_counter_group_choice * 8, coarsetransform_counter_group_choices(4));
    coarsetransform_from_first_0 <= choice((not is_set(coarsetransform_centre_group, 4)) and ((not
      coarsetransform_from_first_0_value) or ((coarsetransform_centre_group mod 4) = 0)) and (not
      is_set(coarsetransform_centre_group, 7)) and (not is_set(coarsetransform_centre_group, 6)) and (not
      is_set(coarsetransform_centre_group, 3)), coarsetransform_from_first_0_differs and
      is_set(coarsetransform_centre_group, 5), coarsetransform_from_first_0_differs);
    coarsetransform_left_code_bits <= choice(coarsetransform_filtering_inside_0(4),
      coarsetransform_left_code_row_signs, 0);
    coarsetransform_right_code_bits <= choice(coarsetransform_filtering_inside_0(4),
      coarsetransform_right_code_row_signs, 0);
    if coarse_pixels_out_valid then
      coarsetransform_counter_column <= choice(coarsetransform_counter_group_is_equals(1) or coarse_pixels_out_start,
        0, (coarsetransform_counter_column + 1) mod 256);
    end if;
    if is_set(others_from_30(30), 8) then
      coarsetransform_left_rows_write_words_0 <= to_unsigned(coarsetransform_left_rows_ready_newest_0, 8) &
        coarsetransform_left_rows_ready_words_0(31 downto 8);
      coarsetransform_right_rows_write_words_0 <= to_unsigned(coarsetransform_right_rows_ready_newest_0, 8) &
        coarsetransform_right_rows_ready_words_0(31 downto 8);
      coarsetransform_write_column <= coarsetransform_ready_column;
    end if;
    if coarsetransform_filtering_valid(1) then
      for i in 0 to 1 loop
        coarsetransform_left_code_row_column(i, 0) <= coarsetransform_left_code_column_response(i);
        coarsetransform_left_code_row_column(i, 1) <= coarsetransform_left_code_row_column(i, 0);
        coarsetransform_left_code_row_column(i, 2) <= coarsetransform_left_code_row_column(i, 1);
        coarsetransform_left_code_row_column(i, 3) <= coarsetransform_left_code_row_column(i, 2);
      end loop;
      coarsetransform_left_code_row_column_2(0) <= coarsetransform_left_code_column_response_2;
      coarsetransform_left_code_row_column_2(1 to 3) <= coarsetransform_left_code_row_column_2(0 to 2);
      for i in 0 to 1 loop
        coarsetransform_right_code_row_column(i, 0) <= coarsetransform_right_code_column_response(i);
        coarsetransform_right_code_row_column(i, 1) <= coarsetransform_right_code_row_column(i, 0);
        coarsetransform_right_code_row_column(i, 2) <= coarsetransform_right_code_row_column(i, 1);
        coarsetransform_right_code_row_column(i, 3) <= coarsetransform_right_code_row_column(i, 2);
      end loop;
      coarsetransform_right_code_row_column_2(0) <= coarsetransform_right_code_column_response_2;
      coarsetransform_right_code_row_column_2(1 to 3) <= coarsetransform_right_code_row_column_2(0 to 2);
    end if;
    -- coarseraster
    coarseraster_place_group_is_equals(1) := coarseraster_place_column = 191;
    coarseraster_place_group_is_equals(2) := coarseraster_place_group = 119;
    coarseraster_place_group_all := coarseraster_place_group_is_equals(1) and coarseraster_place_group_is_equals(2);
    coarseraster_place_group_choice := choice(coarseraster_place_group_all, 15, 0);
    coarseraster_place_group_is_equals(3) := (coarseraster_place_group / 2) = 61;
    coarseraster_place_group_choice_2 := choice(coarseraster_place_group_is_equals(3),
      coarsetransform_filtering_valid(5) and (not is_set(coarseraster_place_group, 0)),
      coarsetransform_filtering_valid(5));
    coarseraster_place_group_choices(3) := choice(coarseraster_place_next_frame and (coarseraster_place_group = 122),
      3, (coarseraster_place_group + 1) mod 128);
    coarseraster_place_group_choices(4) := choice(coarseraster_place_group_is_equals(1) and
      coarseraster_place_group_choice_2, coarseraster_place_group_choices(3), coarseraster_place_group);
    coarseraster_place_next_frame_choices(1) := choice(coarseraster_place_group_is_equals(3),
      coarseraster_place_next_frame and is_set(coarseraster_place_group, 0), coarseraster_place_next_frame);
    coarseraster_place_next_frame_choices(2) := choice(coarseraster_place_group_is_equals(1),
      coarseraster_place_next_frame_choices(1), coarseraster_place_next_frame);
    coarseraster_place_next_frame_choices(3) := choice(coarseraster_place_group_all,
      coarsetransform_filtering_valid(5), coarsetransform_filtering_valid(5) and (not
      coarsetransform_filtering_start_of_frame(5)));
    coarseraster_place_next_frame_choices(4) := choice(coarseraster_place_next_frame_choices(2),
      coarseraster_place_next_frame_choices(3), coarseraster_place_group_is_equals(1) and
      coarseraster_place_group_is_equals(2) and coarsetransform_filtering_valid(5) and
      coarsetransform_filtering_start_of_frame(5));
    coarseraster_features_search_0 <= coarsetransform_left_code_bits;
    coarseraster_features_reference_0 <= coarsetransform_right_code_bits;
    coarseraster_features_valid <= coarsetransform_filtering_valid(5);
    coarseraster_place_next_frame <= coarseraster_place_next_frame_choices(4) or ((not
      coarsetransform_filtering_valid(5)) and coarseraster_place_next_frame);
    coarseraster_place_group <= choice(coarsetransform_filtering_valid(5) and
      coarsetransform_filtering_start_of_frame(5), coarseraster_place_group_choice * 8,
      coarseraster_place_group_choices(4));
    if coarsetransform_filtering_valid(5) then
      coarseraster_place_column <= choice(coarseraster_place_group_is_equals(1) or
        coarsetransform_filtering_start_of_frame(5), 0, (coarseraster_place_column + 1) mod 256);
    end if;
    -- coarsedelay
    if coarseraster_features_valid then
      coarsedelay_ring_write_address <= coarsedelay_ring_read_address;
      coarsedelay_ring_read_address <= choice(coarsedelay_ring_read_address = 31, 0, (coarsedelay_ring_read_address +
        1) mod 32);
    end if;
    coarsedelay_row_inside_3_is_not_less := coarseraster_place_group >= 3;
    coarsedelay_row_inside_3_is_less := coarseraster_place_group < 123;
    coarsedelay_tag_border_column_choice := choice(is_set(coarseraster_place_column, 4) and
      is_set(coarseraster_place_column, 3) and ((coarseraster_place_column mod 4) = 3), (not
      is_set(coarseraster_place_column, 7)) and (not is_set(coarseraster_place_column, 6)) and (not
      is_set(coarseraster_place_column, 2)), (coarseraster_place_column / 64) = 0);
    coarsedelay_tag_first_cost_is_equal := coarseraster_place_column = 31;
    coarsedelay_tag_map_column_is_not_less := coarseraster_place_column >= 31;
    coarsedelay_tag_map_column_is_less := coarseraster_place_column < 191;
    coarsedelay_ahead_0 <= coarseraster_features_search_0;
    coarsedelay_column <= coarseraster_place_column;
    coarsedelay_row_inside(0) <= (((((coarseraster_place_group / 2) + 32765) mod 32768) * 2) +
      (coarseraster_place_group mod 2)) < 120;
    coarsedelay_row_inside(1) <= (coarseraster_place_group >= 5) and (coarseraster_place_group < 125);
    coarsedelay_row_inside(2) <= (((((coarseraster_place_group / 4) + 16383) mod 16384) * 4) +
      (coarseraster_place_group mod 4)) < 120;
    coarsedelay_row_inside(3) <= coarsedelay_row_inside_3_is_not_less and coarsedelay_row_inside_3_is_less;
    coarsedelay_row_inside(4) <= (((((coarseraster_place_group / 2) + 32767) mod 32768) * 2) +
      (coarseraster_place_group mod 2)) < 120;
    coarsedelay_row_inside(5) <= (coarseraster_place_group >= 1) and (coarseraster_place_group < 121);
    coarsedelay_row_inside(6) <= (not is_set(coarseraster_place_group, 6)) or (not is_set(coarseraster_place_group, 5))
      or (not is_set(coarseraster_place_group, 4)) or (not is_set(coarseraster_place_group, 3));
    coarsedelay_tag.valid <= coarseraster_features_valid;
    coarsedelay_tag.border_column <= coarsedelay_tag_border_column_choice and (not is_set(coarseraster_place_column,
      5));
    coarsedelay_tag.first_cost <= coarsedelay_tag_first_cost_is_equal;
    coarsedelay_tag.map_column <= coarsedelay_tag_map_column_is_not_less and coarsedelay_tag_map_column_is_less;
    coarsedelay_tag.output_column <= coarsedelay_row_inside_3_is_not_less and coarsedelay_row_inside_3_is_less and
      coarsedelay_tag_map_column_is_not_less and coarsedelay_tag_map_column_is_less;
    coarsedelay_tag.start_of_frame <= (coarseraster_place_group = 3) and coarsedelay_tag_first_cost_is_equal;
    coarsedelay_tag.end_of_line <= coarseraster_place_column = 190;
    -- coarserows
    coarserows_search_rows_read_newest_0 <= coarsedelay_ahead_0;
    coarserows_search_rows_ready_words_0 <= to_integer(coarserows_search_rows_read_words_0);
    coarserows_search_rows_ready_words_1 <= to_integer(coarserows_search_rows_read_words_1);
    coarserows_search_rows_ready_newest_0 <= coarserows_search_rows_read_newest_0;
    coarserows_reference_rows_read_newest_0 <= to_integer(coarsedelay_delayed_0);
    coarserows_reference_rows_ready_words_0 <= to_integer(coarserows_reference_rows_read_words_0);
    coarserows_reference_rows_ready_words_1 <= to_integer(coarserows_reference_rows_read_words_1);
    coarserows_reference_rows_ready_newest_0 <= coarserows_reference_rows_read_newest_0;
    coarserows_read_column <= coarsedelay_column;
    coarserows_read_inside <= coarsedelay_row_inside;
    coarserows_read_tag <= coarsedelay_tag;
    coarserows_ready_column <= coarserows_read_column;
    coarserows_ready_inside <= coarserows_read_inside;
    coarserows_ready_tag <= coarserows_read_tag;
    coarserows_tag <= coarserows_ready_tag;
    coarserows_search(0) <= choice(coarserows_ready_inside(0), coarserows_search_rows_ready_words_0 mod 64, 0);
    coarserows_reference(0) <= choice(coarserows_ready_inside(0), coarserows_reference_rows_ready_words_0 mod 64, 0);
    coarserows_search(1) <= choice(coarserows_ready_inside(1), (coarserows_search_rows_ready_words_0 / 64) mod 64, 0);
    coarserows_reference(1) <= choice(coarserows_ready_inside(1), (coarserows_reference_rows_ready_words_0 / 64) mod
      64, 0);
    coarserows_search(2) <= choice(coarserows_ready_inside(2), (coarserows_search_rows_ready_words_0 / 4096) mod 64, 0);
    coarserows_reference(2) <= choice(coarserows_ready_inside(2), (coarserows_reference_rows_ready_words_0 / 4096) mod
      64, 0);
    coarserows_search(3) <= choice(coarserows_ready_inside(3), (coarserows_search_rows_ready_words_0 / 262144) mod 64,
      0);
    coarserows_reference(3) <= choice(coarserows_ready_inside(3), (coarserows_reference_rows_ready_words_0 / 262144)
      mod 64, 0);
    coarserows_search(4) <= choice(coarserows_ready_inside(4), coarserows_search_rows_ready_words_0 / 16777216, 0);
    coarserows_reference(4) <= choice(coarserows_ready_inside(4), coarserows_reference_rows_ready_words_0 / 16777216,
      0);
    coarserows_search(5) <= choice(coarserows_ready_inside(5), coarserows_search_rows_ready_words_1, 0);
    coarserows_reference(5) <= choice(coarserows_ready_inside(5), coarserows_reference_rows_ready_words_1, 0);
    coarserows_search(6) <= choice(coarserows_ready_inside(6), coarserows_search_rows_ready_newest_0, 0);
    coarserows_reference(6) <= choice(coarserows_ready_inside(6), coarserows_reference_rows_ready_newest_0, 0);
    if coarserows_ready_tag.valid then
      coarserows_search_rows_write_words(0) <= (coarserows_search_rows_ready_words_0 / 64) +
        (coarserows_search_rows_ready_words_1 * 16777216);
      coarserows_search_rows_write_words(1) <= coarserows_search_rows_ready_newest_0;
      coarserows_reference_rows_write_words(0) <= (coarserows_reference_rows_ready_words_0 / 64) +
        (coarserows_reference_rows_ready_words_1 * 16777216);
      coarserows_reference_rows_write_words(1) <= coarserows_reference_rows_ready_newest_0;
      coarserows_write_column <= coarserows_ready_column;
    end if;
    -- coarseslice0shift
    if coarserows_tag.valid then
      for i in 0 to 6 loop
        for j in 0 to 23 loop coarseslice0shift_search(i, j) <= coarseslice0shift_search(i, j + 1); end loop;
        coarseslice0shift_search(i, 24) <= coarserows_search(i);
      end loop;
    end if;
    coarseslice0shift_reference <= coarserows_reference;
    for i in 0 to 6 loop coarseslice0shift_search_out(i) <= coarseslice0shift_search(i, 0); end loop;
    coarseslice0shift_tag <= coarserows_tag;
    -- coarseslice0cost
    for i in 0 to 6 loop
      coarseslice0cost_pixels_first(i, 0) <= ((differing(coarseslice0shift_reference(i), coarseslice0shift_search(i,
        0), 3, 5, 4)) * 4) + differing(coarseslice0shift_reference(i), coarseslice0shift_search(i, 0), 0) +
        differing(coarseslice0shift_reference(i), coarseslice0shift_search(i, 0), 2) +
        differing(coarseslice0shift_reference(i), coarseslice0shift_search(i, 0), 1);
      for j in 1 to 24 loop
        coarseslice0cost_pixels_first(i, j) <= ((differing(coarseslice0shift_search(i, j),
          coarseslice0shift_reference(i), 3, 5, 4)) * 4) + differing(coarseslice0shift_search(i, j),
          coarseslice0shift_reference(i), 0) + differing(coarseslice0shift_search(i, j),
          coarseslice0shift_reference(i), 2) + differing(coarseslice0shift_search(i, j),
          coarseslice0shift_reference(i), 1);
      end loop;
    end loop;
    coarseslice0cost_pixels_first_tag <= coarseslice0shift_tag;
    for i in 0 to 2 loop
      for j in 0 to 24 loop
        coarseslice0cost_pixels_cost(2 * i, j) <= (coarseslice0cost_pixels_first(2 * i, j) / 4) +
          (coarseslice0cost_pixels_first(2 * i, j) mod 4);
      end loop;
      for j in 0 to 24 loop
        coarseslice0cost_pixels_cost(2 * i + 1, j) <= (coarseslice0cost_pixels_first(2 * i + 1, j) / 4) +
          (coarseslice0cost_pixels_first(2 * i + 1, j) mod 4);
      end loop;
    end loop;
    for i in 0 to 24 loop
      coarseslice0cost_pixels_cost(6, i) <= (coarseslice0cost_pixels_first(6, i) / 4) +
        (coarseslice0cost_pixels_first(6, i) mod 4);
    end loop;
    coarseslice0cost_pixels_tag <= coarseslice0cost_pixels_first_tag;
    for i in 0 to 2 loop
      for j in 0 to 24 loop
        coarseslice0cost_pair(i, j) <= coarseslice0cost_pixels_cost(2 * i + 1, j) + coarseslice0cost_pixels_cost(2 * i
          + 2, j);
      end loop;
    end loop;
    for i in 0 to 24 loop coarseslice0cost_single_0(i) <= coarseslice0cost_pixels_cost(0, i); end loop;
    coarseslice0cost_pair_tag <= coarseslice0cost_pixels_tag;
    coarseslice0cost_tag <= coarseslice0cost_pair_tag;
    for i in 0 to 24 loop
      coarseslice0cost_column_0(i) <= choice(coarseslice0cost_pair_tag.border_column, 0, coarseslice0cost_pair(1, i) +
        coarseslice0cost_pair(2, i) + coarseslice0cost_pair(0, i) + coarseslice0cost_single_0(i));
    end loop;
    -- coarseslice0window
    if coarseslice0cost_tag.valid then
      coarseslice0window_partial_0_0 <= coarseslice0cost_column_0;
      for i in 0 to 24 loop
        coarseslice0window_partial_0_1(i) <= coarseslice0window_partial_0_0(i) + coarseslice0cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        coarseslice0window_partial_0_2(i) <= coarseslice0window_partial_0_1(i) + coarseslice0cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        coarseslice0window_partial_0_3(i) <= coarseslice0window_partial_0_2(i) + coarseslice0cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        coarseslice0window_partial_0_4(i) <= coarseslice0window_partial_0_3(i) + coarseslice0cost_column_0(i);
      end loop;
      for i in 0 to 24 loop
        coarseslice0window_partial_0_5(i) <= coarseslice0window_partial_0_4(i) + coarseslice0cost_column_0(i);
      end loop;
      coarseslice0window_centre_output_column(1) <= coarseslice1cost_tag.output_column;
      coarseslice0window_centre_output_column(2) <= coarseslice0window_centre_output_column(1);
      coarseslice0window_centre_first_column(1) <= coarseslice1cost_tag.first_cost;
      coarseslice0window_centre_first_column(2) <= coarseslice0window_centre_first_column(1);
    end if;
    coarseslice0window_centre_map_column_0 <= coarseslice0cost_tag.map_column;
    coarseslice0window_centre_output_column(0) <= coarseslice0cost_tag.output_column;
    coarseslice0window_centre_first_column(0) <= coarseslice0cost_tag.first_cost;
    coarseslice0window_centre_start_of_frame_0 <= coarseslice0cost_tag.start_of_frame;
    coarseslice0window_centre_end_of_line_0 <= coarseslice0cost_tag.end_of_line;
    for i in 0 to 24 loop
      coarseslice0window_sum_0(i) <= coarseslice0window_partial_0_5(i) + coarseslice0cost_column_0(i);
    end loop;
    coarseslice0window_tag.valid <= coarseslice0cost_tag.valid;
    if coarseslice0window_tag.valid then
      coarseslice0window_tag.map_column <= coarseslice1window_centre_map_column(1);
      coarseslice0window_tag.output_column <= coarseslice1window_centre_output_column(1);
      coarseslice0window_tag.first_column <= coarseslice1window_centre_first_column(1);
      coarseslice0window_tag.start_of_frame <= coarseslice1window_centre_start_of_frame(1);
      coarseslice0window_tag.end_of_line <= coarseslice1window_centre_end_of_line(1);
    end if;
    -- coarseslice0other
    coarseslice0other_cost_0_all(0) := coarseslice1window_centre_output_column(2) and
      (coarseslice1window_centre_first_column(2) or ((coarseslice0other_cost_0(1) - coarseslice0window_sum_0(0)) >= 0));
    coarseslice0other_cost_0_all(1) := coarseslice1window_centre_output_column(2) and
      coarseslice1window_centre_first_column(2);
    for i in 1 to 23 loop
      coarseslice0other_cost_0_choice(i) := choice((coarseslice0other_cost_0(i + 1) - coarseslice0window_sum_0(i)) >=
        0, coarseslice1window_centre_output_column(2), coarseslice0other_cost_0_all(1));
    end loop;
    if coarseslice0window_tag.valid then
      coarseslice0other_cost_0(0) <= choice(coarseslice0other_cost_0_all(0), coarseslice0window_sum_0(0),
        coarseslice0other_cost_0(1));
      coarseslice0other_winner_0(0) <= choice(coarseslice0other_cost_0_all(0), 7, coarseslice0other_winner_0(1));
      for i in 1 to 23 loop
        coarseslice0other_cost_0(i) <= choice(coarseslice0other_cost_0_choice(i), coarseslice0window_sum_0(i),
          coarseslice0other_cost_0(i + 1));
        coarseslice0other_winner_0(i) <= choice(coarseslice0other_cost_0_choice(i), i + 7, coarseslice0other_winner_0(i
          + 1));
      end loop;
      coarseslice0other_cost_0(24) <= choice(coarseslice1window_centre_output_column(2), coarseslice0window_sum_0(24),
        0);
      coarseslice0other_winner_0(24) <= choice(coarseslice1window_centre_output_column(2), 31, 0);
    end if;
    coarseslice0other_cost_out_0 <= coarseslice0other_cost_0(0);
    coarseslice0other_winner_out_0 <= coarseslice0other_winner_0(0);
    -- coarseslice0winner1
    for i in 0 to 11 loop
      coarseslice0winner1_best_cost_0_is_less(i) := (coarseslice0window_sum_0(2 * i + 1) - coarseslice0window_sum_0(2 *
        i)) < 0;
    end loop;
    coarseslice0winner1_best_cost_0(12) <= coarseslice0window_sum_0(24);
    coarseslice0winner1_best_index_0_0 <= coarseslice0winner1_best_cost_0_is_less(0);
    coarseslice0winner1_best_index_0(12) <= 24;
    coarseslice0winner1_tag <= coarseslice0window_tag;
    coarseslice0winner1_best_cost_0(0) <= choice(coarseslice0winner1_best_cost_0_is_less(0),
      coarseslice0window_sum_0(1), coarseslice0window_sum_0(0));
    for i in 1 to 11 loop
      coarseslice0winner1_best_cost_0(i) <= choice(coarseslice0winner1_best_cost_0_is_less(i),
        coarseslice0window_sum_0(2 * i + 1), coarseslice0window_sum_0(2 * i));
      coarseslice0winner1_best_index_0(i) <= choice(coarseslice0winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- coarseslice0winner2
    for i in 0 to 5 loop
      coarseslice0winner2_best_cost_0_is_less(i) := (coarseslice0winner1_best_cost_0(2 * i + 1) -
        coarseslice0winner1_best_cost_0(2 * i)) < 0;
    end loop;
    coarseslice0winner2_best_cost_0(6) <= coarseslice0winner1_best_cost_0(12);
    coarseslice0winner2_best_index_0(6) <= coarseslice0winner1_best_index_0(12);
    coarseslice0winner2_tag.valid <= coarseslice0winner1_tag.valid;
    coarseslice0winner2_tag.map_column <= coarseslice0winner1_tag.map_column;
    coarseslice0winner2_tag.output_column <= coarseslice0winner1_tag.output_column;
    coarseslice0winner2_tag.start_of_frame <= coarseslice0winner1_tag.start_of_frame;
    coarseslice0winner2_tag.end_of_line <= coarseslice0winner1_tag.end_of_line;
    coarseslice0winner2_best_cost_0(0) <= choice(coarseslice0winner2_best_cost_0_is_less(0),
      coarseslice0winner1_best_cost_0(1), coarseslice0winner1_best_cost_0(0));
    coarseslice0winner2_best_index_0(0) <= choice(coarseslice0winner2_best_cost_0_is_less(0),
      coarseslice0winner1_best_index_0(1), as_number(coarseslice0winner1_best_index_0_0));
    for i in 1 to 5 loop
      coarseslice0winner2_best_cost_0(i) <= choice(coarseslice0winner2_best_cost_0_is_less(i),
        coarseslice0winner1_best_cost_0(2 * i + 1), coarseslice0winner1_best_cost_0(2 * i));
      coarseslice0winner2_best_index_0(i) <= choice(coarseslice0winner2_best_cost_0_is_less(i),
        coarseslice0winner1_best_index_0(2 * i + 1), coarseslice0winner1_best_index_0(2 * i));
    end loop;
    -- coarseslice0winner3
    for i in 0 to 2 loop
      coarseslice0winner3_best_cost_0_is_less(i) := (coarseslice0winner2_best_cost_0(2 * i + 1) -
        coarseslice0winner2_best_cost_0(2 * i)) < 0;
    end loop;
    coarseslice0winner3_best_cost_0(3) <= coarseslice0winner2_best_cost_0(6);
    coarseslice0winner3_best_index_0(3) <= coarseslice0winner2_best_index_0(6);
    coarseslice0winner3_tag <= coarseslice0winner2_tag;
    for i in 0 to 2 loop
      coarseslice0winner3_best_cost_0(i) <= choice(coarseslice0winner3_best_cost_0_is_less(i),
        coarseslice0winner2_best_cost_0(2 * i + 1), coarseslice0winner2_best_cost_0(2 * i));
      coarseslice0winner3_best_index_0(i) <= choice(coarseslice0winner3_best_cost_0_is_less(i),
        coarseslice0winner2_best_index_0(2 * i + 1), coarseslice0winner2_best_index_0(2 * i));
    end loop;
    -- coarseslice0winner4
    coarseslice0winner4_best_cost_0_is_less(0) := (coarseslice0winner3_best_cost_0(1) -
      coarseslice0winner3_best_cost_0(0)) < 0;
    coarseslice0winner4_best_cost_0_is_less(1) := (coarseslice0winner3_best_cost_0(3) -
      coarseslice0winner3_best_cost_0(2)) < 0;
    coarseslice0winner4_tag <= coarseslice0winner3_tag;
    for i in 0 to 1 loop
      coarseslice0winner4_best_cost_0(i) <= choice(coarseslice0winner4_best_cost_0_is_less(i),
        coarseslice0winner3_best_cost_0(2 * i + 1), coarseslice0winner3_best_cost_0(2 * i));
      coarseslice0winner4_best_index_0(i) <= choice(coarseslice0winner4_best_cost_0_is_less(i),
        coarseslice0winner3_best_index_0(2 * i + 1), coarseslice0winner3_best_index_0(2 * i));
    end loop;
    -- coarseslice0winner5
    coarseslice0winner5_best_cost_0_0_is_less := (coarseslice0winner4_best_cost_0(1) -
      coarseslice0winner4_best_cost_0(0)) < 0;
    coarseslice0winner5_tag <= coarseslice0winner4_tag;
    coarseslice0winner5_best_cost_0_0 <= choice(coarseslice0winner5_best_cost_0_0_is_less,
      coarseslice0winner4_best_cost_0(1), coarseslice0winner4_best_cost_0(0));
    coarseslice0winner5_best_index_0_0 <= choice(coarseslice0winner5_best_cost_0_0_is_less,
      coarseslice0winner4_best_index_0(1), coarseslice0winner4_best_index_0(0));
    -- coarseslice0
    coarseslice0_best_cost_0_0 <= coarseslice0winner5_best_cost_0_0;
    coarseslice0_best_index_0_0 <= coarseslice0winner5_best_index_0_0 + 7;
    coarseslice0_best_tag <= coarseslice0winner5_tag;
    -- coarseslice1shift
    if coarseslice0shift_tag.valid then
      for i in 0 to 6 loop
        for j in 0 to 5 loop coarseslice1shift_search(i, j) <= coarseslice1shift_search(i, j + 1); end loop;
        coarseslice1shift_search(i, 6) <= coarseslice0shift_search_out(i);
      end loop;
    end if;
    coarseslice1shift_reference <= coarseslice0shift_reference;
    -- coarseslice1cost
    for i in 0 to 6 loop
      coarseslice1cost_pixels_first(i, 0) <= ((differing(coarseslice1shift_reference(i), coarseslice1shift_search(i,
        0), 3, 5, 4)) * 4) + differing(coarseslice1shift_reference(i), coarseslice1shift_search(i, 0), 0) +
        differing(coarseslice1shift_reference(i), coarseslice1shift_search(i, 0), 2) +
        differing(coarseslice1shift_reference(i), coarseslice1shift_search(i, 0), 1);
      for j in 1 to 6 loop
        coarseslice1cost_pixels_first(i, j) <= ((differing(coarseslice1shift_search(i, j),
          coarseslice1shift_reference(i), 3, 5, 4)) * 4) + differing(coarseslice1shift_search(i, j),
          coarseslice1shift_reference(i), 0) + differing(coarseslice1shift_search(i, j),
          coarseslice1shift_reference(i), 2) + differing(coarseslice1shift_search(i, j),
          coarseslice1shift_reference(i), 1);
      end loop;
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 6 loop
        coarseslice1cost_pixels_cost(2 * i, j) <= (coarseslice1cost_pixels_first(2 * i, j) / 4) +
          (coarseslice1cost_pixels_first(2 * i, j) mod 4);
      end loop;
      for j in 0 to 6 loop
        coarseslice1cost_pixels_cost(2 * i + 1, j) <= (coarseslice1cost_pixels_first(2 * i + 1, j) / 4) +
          (coarseslice1cost_pixels_first(2 * i + 1, j) mod 4);
      end loop;
    end loop;
    for i in 0 to 6 loop
      coarseslice1cost_pixels_cost(6, i) <= (coarseslice1cost_pixels_first(6, i) / 4) +
        (coarseslice1cost_pixels_first(6, i) mod 4);
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 6 loop
        coarseslice1cost_pair(i, j) <= coarseslice1cost_pixels_cost(2 * i + 1, j) + coarseslice1cost_pixels_cost(2 * i
          + 2, j);
      end loop;
    end loop;
    for i in 0 to 6 loop coarseslice1cost_single_0(i) <= coarseslice1cost_pixels_cost(0, i); end loop;
    for i in 0 to 6 loop
      coarseslice1cost_column_0(i) <= choice(coarseslice0cost_tag.border_column, 0, coarseslice1cost_pair(1, i) +
        coarseslice1cost_pair(2, i) + coarseslice1cost_pair(0, i) + coarseslice1cost_single_0(i));
    end loop;
    if coarseslice0cost_tag.valid then
      coarseslice1cost_tag.first_cost <= coarseslice0cost_tag.first_cost;
      coarseslice1cost_tag.output_column <= coarseslice0cost_tag.output_column;
    end if;
    -- coarseslice1window
    if coarseslice0window_tag.valid then
      coarseslice1window_partial_0_0 <= coarseslice1cost_column_0;
      for i in 0 to 6 loop
        coarseslice1window_partial_0_1(i) <= coarseslice1window_partial_0_0(i) + coarseslice1cost_column_0(i);
      end loop;
      for i in 0 to 6 loop
        coarseslice1window_partial_0_2(i) <= coarseslice1window_partial_0_1(i) + coarseslice1cost_column_0(i);
      end loop;
      for i in 0 to 6 loop
        coarseslice1window_partial_0_3(i) <= coarseslice1window_partial_0_2(i) + coarseslice1cost_column_0(i);
      end loop;
      for i in 0 to 6 loop
        coarseslice1window_partial_0_4(i) <= coarseslice1window_partial_0_3(i) + coarseslice1cost_column_0(i);
      end loop;
      for i in 0 to 6 loop
        coarseslice1window_partial_0_5(i) <= coarseslice1window_partial_0_4(i) + coarseslice1cost_column_0(i);
      end loop;
      coarseslice1window_centre_map_column(0) <= coarseslice0window_centre_map_column_0;
      coarseslice1window_centre_map_column(1) <= coarseslice1window_centre_map_column(0);
      coarseslice1window_centre_output_column(0) <= coarseslice0window_centre_output_column(0);
      coarseslice1window_centre_output_column(1) <= coarseslice1window_centre_output_column(0);
      coarseslice1window_centre_first_column(0) <= coarseslice0window_centre_first_column(0);
      coarseslice1window_centre_first_column(1) <= coarseslice1window_centre_first_column(0);
      coarseslice1window_centre_start_of_frame(0) <= coarseslice0window_centre_start_of_frame_0;
      coarseslice1window_centre_start_of_frame(1) <= coarseslice1window_centre_start_of_frame(0);
      coarseslice1window_centre_end_of_line(0) <= coarseslice0window_centre_end_of_line_0;
      coarseslice1window_centre_end_of_line(1) <= coarseslice1window_centre_end_of_line(0);
    end if;
    coarseslice1window_centre_output_column(2) <= coarseslice0window_centre_output_column(2);
    coarseslice1window_centre_first_column(2) <= coarseslice0window_centre_first_column(2);
    for i in 0 to 6 loop
      coarseslice1window_sum_0(i) <= coarseslice1window_partial_0_5(i) + coarseslice1cost_column_0(i);
    end loop;
    -- coarseslice1other
    coarseslice1other_cost_0_1_any := (not coarseslice0winner1_tag.output_column) or (not
      coarseslice0winner1_tag.first_column);
    for i in 1 to 5 loop
      coarseslice1other_cost_0_choice(i) := choice((coarseslice1other_cost_0(i + 1) - coarseslice1window_sum_0(i)) >=
        0, not coarseslice0winner1_tag.output_column, coarseslice1other_cost_0_1_any);
    end loop;
    coarseslice1other_cost_0_choice(6) := choice((coarseslice0other_cost_out_0 - coarseslice1window_sum_0(6)) >= 0, not
      coarseslice0winner1_tag.output_column, coarseslice1other_cost_0_1_any);
    if coarseslice0winner1_tag.valid then
      for i in 1 to 5 loop
        coarseslice1other_cost_0(i) <= choice(coarseslice1other_cost_0_choice(i), coarseslice1other_cost_0(i + 1),
          coarseslice1window_sum_0(i));
        coarseslice1other_winner_0(i) <= choice(coarseslice1other_cost_0_choice(i), coarseslice1other_winner_0(i + 1),
          i);
      end loop;
      coarseslice1other_cost_0(6) <= choice(coarseslice1other_cost_0_choice(6), coarseslice0other_cost_out_0,
        coarseslice1window_sum_0(6));
      coarseslice1other_winner_0(6) <= choice(coarseslice1other_cost_0_choice(6), coarseslice0other_winner_out_0, 6);
      coarseslice1other_winner_0(0) <= choice((not coarseslice0winner1_tag.output_column) or ((not
        coarseslice0winner1_tag.first_column) and ((coarseslice1other_cost_0(1) - coarseslice1window_sum_0(0)) < 0)),
        coarseslice1other_winner_0(1), 0);
    end if;
    coarseslice1other_winner_out_0 <= coarseslice1other_winner_0(0);
    -- coarseslice1winner1
    for i in 0 to 2 loop
      coarseslice1winner1_best_cost_0_is_less(i) := (coarseslice1window_sum_0(2 * i + 1) - coarseslice1window_sum_0(2 *
        i)) < 0;
    end loop;
    coarseslice1winner1_best_cost_0(3) <= coarseslice1window_sum_0(6);
    coarseslice1winner1_best_index_0_0 <= coarseslice1winner1_best_cost_0_is_less(0);
    coarseslice1winner1_best_index_0(3) <= 6;
    coarseslice1winner1_best_cost_0(0) <= choice(coarseslice1winner1_best_cost_0_is_less(0),
      coarseslice1window_sum_0(1), coarseslice1window_sum_0(0));
    for i in 1 to 2 loop
      coarseslice1winner1_best_cost_0(i) <= choice(coarseslice1winner1_best_cost_0_is_less(i),
        coarseslice1window_sum_0(2 * i + 1), coarseslice1window_sum_0(2 * i));
      coarseslice1winner1_best_index_0(i) <= choice(coarseslice1winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- coarseslice1winner2
    coarseslice1winner2_best_cost_0_is_less(0) := (coarseslice1winner1_best_cost_0(1) -
      coarseslice1winner1_best_cost_0(0)) < 0;
    coarseslice1winner2_best_cost_0_is_less(1) := (coarseslice1winner1_best_cost_0(3) -
      coarseslice1winner1_best_cost_0(2)) < 0;
    coarseslice1winner2_best_cost_0(0) <= choice(coarseslice1winner2_best_cost_0_is_less(0),
      coarseslice1winner1_best_cost_0(1), coarseslice1winner1_best_cost_0(0));
    coarseslice1winner2_best_index_0(0) <= choice(coarseslice1winner2_best_cost_0_is_less(0),
      coarseslice1winner1_best_index_0(1), as_number(coarseslice1winner1_best_index_0_0));
    coarseslice1winner2_best_cost_0(1) <= choice(coarseslice1winner2_best_cost_0_is_less(1),
      coarseslice1winner1_best_cost_0(3), coarseslice1winner1_best_cost_0(2));
    coarseslice1winner2_best_index_0(1) <= choice(coarseslice1winner2_best_cost_0_is_less(1),
      coarseslice1winner1_best_index_0(3), coarseslice1winner1_best_index_0(2));
    -- coarseslice1winner3
    coarseslice1winner3_best_cost_0_0_is_less := (coarseslice1winner2_best_cost_0(1) -
      coarseslice1winner2_best_cost_0(0)) < 0;
    coarseslice1winner3_best_cost_0_0 <= choice(coarseslice1winner3_best_cost_0_0_is_less,
      coarseslice1winner2_best_cost_0(1), coarseslice1winner2_best_cost_0(0));
    coarseslice1winner3_best_index_0_0 <= choice(coarseslice1winner3_best_cost_0_0_is_less,
      coarseslice1winner2_best_index_0(1), coarseslice1winner2_best_index_0(0));
    -- coarseslice1winner4
    coarseslice1winner4_best_cost_0_0 <= coarseslice1winner3_best_cost_0_0;
    coarseslice1winner4_best_index_0_0 <= coarseslice1winner3_best_index_0_0;
    -- coarseslice1winner5
    coarseslice1winner5_best_cost_0_0 <= coarseslice1winner4_best_cost_0_0;
    coarseslice1winner5_best_index_0_0 <= coarseslice1winner4_best_index_0_0;
    -- coarseslice1
    coarseslice1_best_tag <= coarseslice0_best_tag;
    coarseslice1_best_index_0_0 <= choice((coarseslice0_best_cost_0_0 - coarseslice1winner5_best_cost_0_0) < 0,
      coarseslice0_best_index_0_0, coarseslice1winner5_best_index_0_0);
    -- coarseleftright
    coarseleftright_holds_winners_choice := choice((coarseleftright_ring_read_address / 2) = 0, (not
      coarseleftright_holds_winners) and is_set(coarseleftright_ring_read_address, 0), not
      coarseleftright_holds_winners);
    coarseleftright_checked_passed_0_difference := (coarseleftright_answered_disparity_0 + 1) -
      to_integer(coarseleftright_found_0);
    coarseleftright_other_0(1) <= coarseslice1other_winner_out_0;
    coarseleftright_other_0(2 to 4) <= coarseleftright_other_0(1 to 3);
    coarseleftright_position <= (coarseleftright_position + as_number(coarseslice1_best_tag.valid)) mod 64;
    coarseleftright_held_position <= coarseleftright_position;
    coarseleftright_held_valid <= (not coarseleftright_holds_winners_choice) and coarseslice1_best_tag.valid;
    coarseleftright_address_0 <= (to_integer(coarseleftright_held_0(12 downto 4)) + coarseleftright_held_position + 33)
      mod 64;
    coarseleftright_asking_disparity_0 <= to_integer(coarseleftright_held_0(9 downto 4));
    coarseleftright_asking_passed_0 <= coarseleftright_held_0(12) = '1';
    coarseleftright_asking_tag.valid <= coarseleftright_held_valid;
    coarseleftright_asking_tag.output_column <= coarseleftright_held_0(1) = '1';
    coarseleftright_asking_tag.start_of_frame <= coarseleftright_held_0(2) = '1';
    coarseleftright_answered_disparity_0 <= coarseleftright_asking_disparity_0;
    coarseleftright_answered_passed_0 <= coarseleftright_asking_passed_0;
    coarseleftright_answered_tag <= coarseleftright_asking_tag;
    coarseleftright_checked_disparity_0 <= coarseleftright_answered_disparity_0 mod 32;
    coarseleftright_checked_passed_0 <= coarseleftright_answered_passed_0 and
      (coarseleftright_checked_passed_0_difference >= 0) and (coarseleftright_checked_passed_0_difference < 3);
    coarseleftright_checked_tag <= coarseleftright_answered_tag;
    coarseleftright_holds_winners <= choice(coarseleftright_holds_winners_choice, (not coarseslice1_best_tag.valid) and
      coarseleftright_holds_winners, coarseslice1_best_tag.valid or coarseleftright_holds_winners);
    if coarseslice1_best_tag.valid then
      coarseleftright_ring_write_address <= coarseleftright_ring_read_address;
      coarseleftright_ring_read_address <= choice(coarseleftright_ring_read_address = 31, 0,
        (coarseleftright_ring_read_address + 1) mod 32);
    end if;
    -- ranges
    ranges_column_differs := (ranges_row / 2) /= 60;
    ranges_column_anys(1) := ranges_column_differs or is_set(ranges_row, 0);
    ranges_column_choices(1) := choice((ranges_column / 16) = 10, ((ranges_column mod 16) /= 0) and
      ranges_column_anys(1), ranges_column_anys(1));
    ranges_column_alls(1) := ranges_column_choices(1) and ((not coarseleftright_checked_tag.valid) or (not
      coarseleftright_checked_tag.output_column));
    ranges_column_alls(2) := coarseleftright_checked_tag.start_of_frame and coarseleftright_checked_tag.valid and
      coarseleftright_checked_tag.output_column;
    ranges_column_choices(2) := choice(ranges_column_alls(1), ranges_column_alls(2), ranges_column_differs or
      ranges_column_alls(2) or (not is_set(ranges_row, 0)));
    ranges_column_is_equal := (ranges_column / 32) = 5;
    ranges_column_choices(3) := choice(((ranges_column / 2) mod 8) = 0, ranges_column_alls(2) or (not
      is_set(ranges_column, 0)), ranges_column_alls(2));
    ranges_column_anys(2) := ranges_column_alls(2) or (not is_set(ranges_column, 4));
    ranges_column_anys(3) := (not coarseleftright_checked_tag.start_of_frame) or (not
      coarseleftright_checked_tag.valid) or (not coarseleftright_checked_tag.output_column);
    ranges_column_choices_from_4(4) := choice(ranges_column_anys(3), ranges_column, 0);
    ranges_column_choices_from_4(5) := choice((not ranges_column_alls(2)) and ranges_column_is_equal and
      ranges_column_choices(3) and ranges_column_anys(2), 0, (ranges_column_choices_from_4(4) + 1) mod 256);
    ranges_row_choice := choice(ranges_column_anys(3), ranges_row, 0);
    ranges_row_choice_2 := choice(ranges_column_alls(1), not ranges_column_alls(2), (not ranges_column_alls(2)) and
      (ranges_row = 121));
    ranges_pixel_0_choice := choice(ranges_column_choices(1), coarseleftright_checked_passed_0,
      coarseleftright_checked_tag.start_of_frame and coarseleftright_checked_tag.valid and
      coarseleftright_checked_tag.output_column and coarseleftright_checked_passed_0);
    ranges_centre_valid_differs := ranges_ready_row /= 0;
    ranges_counts_sum := (ranges_middle mod 32) + 1;
    ranges_counts_differences(1) := ranges_counts_sum - (ranges_above mod 32);
    ranges_counts_differences(2) := ranges_counts_sum - (ranges_right mod 32);
    ranges_counts_differences(3) := ranges_counts_sum - (ranges_below mod 32);
    ranges_counts_differences(4) := ranges_counts_sum - (ranges_left mod 32);
    ranges_counts_sum_2 := as_number(((ranges_counts_differences(1) >= 0) and (ranges_counts_differences(1) < 3) and
      is_set(ranges_above, 5))) + as_number(((ranges_counts_differences(2) >= 0) and (ranges_counts_differences(2) < 3)
      and is_set(ranges_right, 5))) + as_number(((ranges_counts_differences(3) >= 0) and (ranges_counts_differences(3)
      < 3) and is_set(ranges_below, 5))) + as_number(((ranges_counts_differences(4) >= 0) and
      (ranges_counts_differences(4) < 3) and is_set(ranges_left, 5)));
    ranges_pair_0_values(1) := is_set(ranges_disparity, 1);
    ranges_pair_0_choices(1) := choice(is_set(ranges_first_of_pair, 6) and ((not is_set(ranges_disparity, 0)) or (not
      ranges_counts)), (not is_set(ranges_first_of_pair, 7)) and ranges_pair_0_values(1) and ranges_counts, (not
      is_set(ranges_first_of_pair, 7)) or (ranges_pair_0_values(1) and ranges_counts));
    for i in 2 to 3 loop
      ranges_pair_0_values(i) := is_set(ranges_disparity, i);
      ranges_pair_0_choices(i) := choice(ranges_pair_0_choices(i - 1), (not is_set(ranges_first_of_pair, i + 6)) or
        (ranges_pair_0_values(i) and ranges_counts), (not is_set(ranges_first_of_pair, i + 6)) and
        ranges_pair_0_values(i) and ranges_counts);
    end loop;
    ranges_pair_0_choices(4) := choice(is_set(ranges_first_of_pair, 10), is_set(ranges_disparity, 4) and ranges_counts,
      ranges_counts);
    ranges_pair_0_choices(5) := choice(ranges_pair_0_choices(3), ranges_pair_0_choices(4), (not
      is_set(ranges_first_of_pair, 10)) and is_set(ranges_disparity, 4) and ranges_counts);
    ranges_pair_0_choice_6 := choice(ranges_counts, (((ranges_disparity * 32) + ranges_disparity) * 2) + 1, 0);
    ranges_pair_0_choices_from_7(7) := choice((not ranges_pair_0_choices(5)) and is_set(ranges_first_of_pair, 0),
      ranges_first_of_pair / 64, ranges_pair_0_choice_6 / 64);
    ranges_pair_0_choices(8) := choice(ranges_pair_0_values(1), (not is_set(ranges_first_of_pair, 2)) or ranges_counts,
      not is_set(ranges_first_of_pair, 2));
    ranges_pair_0_choices(9) := choice(is_set(ranges_disparity, 0) and (not is_set(ranges_first_of_pair, 1)) and
      ranges_counts, ranges_pair_0_choices(8), ranges_pair_0_values(1) and (not is_set(ranges_first_of_pair, 2)) and
      ranges_counts);
    for i in 2 to 3 loop
      ranges_pair_0_choices(2 * i + 6) := choice(ranges_pair_0_values(i), (not is_set(ranges_first_of_pair, i + 1)) or
        ranges_counts, not is_set(ranges_first_of_pair, i + 1));
      ranges_pair_0_choices(2 * i + 7) := choice(ranges_pair_0_choices(2 * i + 5), ranges_pair_0_choices(2 * i + 6),
        ranges_pair_0_values(i) and (not is_set(ranges_first_of_pair, i + 1)) and ranges_counts);
    end loop;
    ranges_pair_0_values(4) := is_set(ranges_first_of_pair, 5);
    ranges_pair_0_choices(14) := choice(is_set(ranges_disparity, 4), ranges_pair_0_values(4) and ranges_counts,
      ranges_counts);
    ranges_pair_0_choices(15) := choice(ranges_pair_0_choices(13), (not is_set(ranges_disparity, 4)) and
      ranges_pair_0_values(4) and ranges_counts, ranges_pair_0_choices(14));
    ranges_pair_0_choice_16 := choice(ranges_counts, (ranges_disparity * 2) + 1, 0);
    ranges_pair_0_choices_from_7(17) := choice((not ranges_pair_0_choices(15)) and is_set(ranges_first_of_pair, 0),
      (ranges_first_of_pair mod 64) / 2, ranges_pair_0_choice_16 / 2);
    ranges_range_values(1) := is_set(ranges_pairs_ready_newest_0, 6);
    ranges_range_choices(1) := choice(ranges_range_values(1), not is_set(ranges_pairs_ready_words_0, 7),
      ((ranges_pairs_ready_words_0 / 64) mod 4) = 0);
    ranges_range_choices(2) := choice(is_set(ranges_pairs_ready_newest_0, 7), ranges_range_values(1) or (not
      is_set(ranges_pairs_ready_words_0, 7)) or (not is_set(ranges_pairs_ready_words_0, 6)), ranges_range_choices(1));
    ranges_range_values(2) := is_set(ranges_pairs_ready_words_0, 8);
    ranges_range_values(3) := is_set(ranges_pairs_ready_words_0, 9);
    ranges_range_choices(4) := not is_larger(ranges_pairs_ready_newest_0, ranges_pairs_ready_words_0, 8, 9,
      ranges_range_choices(2));
    ranges_range_choices(5) := choice(is_set(ranges_pairs_ready_newest_0, 10), is_set(ranges_pairs_ready_newest_0, 0),
      (not is_set(ranges_pairs_ready_words_0, 10)) and is_set(ranges_pairs_ready_newest_0, 0));
    ranges_range_choices(6) := choice(ranges_range_choices(4), is_set(ranges_pairs_ready_newest_0, 10) and (not
      is_set(ranges_pairs_ready_words_0, 10)) and is_set(ranges_pairs_ready_newest_0, 0), ranges_range_choices(5));
    ranges_range_choices_from_7(7) := choice((not ranges_range_choices(6)) and is_set(ranges_pairs_ready_words_0, 0),
      ranges_pairs_ready_words_0 / 64, ranges_pairs_ready_newest_0 / 64);
    ranges_range_values(4) := is_set(ranges_pairs_ready_newest_0, 1);
    ranges_range_choices(8) := choice(ranges_range_values(4), (not is_set(ranges_pairs_ready_words_0, 2)) or (not
      is_set(ranges_pairs_ready_words_0, 1)), not is_set(ranges_pairs_ready_words_0, 2));
    ranges_range_choices(9) := choice(is_set(ranges_pairs_ready_newest_0, 2), ranges_range_choices(8),
      ranges_range_values(4) and (((ranges_pairs_ready_words_0 / 2) mod 4) = 0));
    ranges_range_values(5) := is_set(ranges_pairs_ready_words_0, 3);
    ranges_range_values(6) := is_set(ranges_pairs_ready_words_0, 4);
    ranges_range_choices(11) := not is_larger(ranges_pairs_ready_newest_0, ranges_pairs_ready_words_0, 3, 4,
      ranges_range_choices(9));
    ranges_range_values(7) := is_set(ranges_pairs_ready_newest_0, 5);
    ranges_range_values(8) := is_set(ranges_pairs_ready_words_0, 5);
    ranges_range_choices(12) := choice(ranges_range_values(7), ranges_range_values(8) and
      is_set(ranges_pairs_ready_newest_0, 0), is_set(ranges_pairs_ready_newest_0, 0));
    ranges_range_choices(13) := choice(ranges_range_choices(11), ranges_range_choices(12), (not ranges_range_values(7))
      and ranges_range_values(8) and is_set(ranges_pairs_ready_newest_0, 0));
    ranges_range_choices_from_7(14) := choice((not ranges_range_choices(13)) and is_set(ranges_pairs_ready_words_0, 0),
      (ranges_pairs_ready_words_0 mod 64) / 2, (ranges_pairs_ready_newest_0 mod 64) / 2);
    ranges_row <= (ranges_row_choice + as_number(((not ranges_row_choice_2) and (not ranges_column_alls(2)) and
      ranges_column_is_equal and ranges_column_choices(3) and ranges_column_anys(2)))) mod 128;
    ranges_pixel_0 <= (as_number((coarseleftright_checked_tag.valid and coarseleftright_checked_tag.output_column and
      ranges_pixel_0_choice)) * 32) + coarseleftright_checked_disparity_0;
    ranges_in_column <= ranges_column_choices_from_4(4);
    ranges_in_row <= ranges_row_choice;
    ranges_in_valid <= ranges_column_choices(2);
    ranges_pixels_read_newest_0 <= ranges_pixel_0;
    ranges_pixels_ready_words_0 <= to_integer(ranges_pixels_read_words_0);
    ranges_pixels_ready_newest_0 <= ranges_pixels_read_newest_0;
    ranges_read_column <= ranges_in_column;
    ranges_read_row <= ranges_in_row;
    ranges_read_valid <= ranges_in_valid;
    ranges_ready_column <= ranges_read_column;
    ranges_ready_row <= ranges_read_row;
    ranges_ready_valid <= ranges_read_valid;
    ranges_centre_column <= ranges_ready_column;
    ranges_centre_row <= (ranges_ready_row + 65535) mod 65536;
    ranges_disparity <= ranges_middle mod 32;
    ranges_counted_column <= ranges_centre_column;
    ranges_counted_row <= ranges_centre_row;
    ranges_counted_valid <= ranges_centre_valid;
    ranges_paired_column <= ranges_counted_column / 2;
    ranges_paired_row <= ranges_counted_row;
    ranges_paired_valid <= ranges_counted_valid and (not is_set(ranges_counted_column, 0));
    ranges_pairs_read_newest_0 <= ranges_pair_0;
    ranges_pairs_ready_words_0 <= to_integer(ranges_pairs_read_words_0);
    ranges_pairs_ready_newest_0 <= ranges_pairs_read_newest_0;
    ranges_pair_read_column <= ranges_paired_column;
    ranges_pair_read_row <= ranges_paired_row;
    ranges_pair_read_valid <= ranges_paired_valid;
    ranges_pair_ready_column <= ranges_pair_read_column;
    ranges_pair_ready_row <= ranges_pair_read_row;
    ranges_pair_ready_valid <= ranges_pair_read_valid;
    ranges_block_column <= (ranges_pair_ready_column + 65535) mod 65536;
    ranges_block_row <= ranges_pair_ready_row / 2;
    ranges_valid <= ranges_pair_ready_valid and is_set(ranges_pair_ready_row, 0);
    ranges_column <= choice(ranges_column_choices(2), ranges_column_choices_from_4(5), ranges_column_choices_from_4(4));
    ranges_centre_valid <= choice((ranges_ready_column / 16) = 0, ((ranges_ready_column mod 16) /= 0) and
      ranges_centre_valid_differs and ranges_ready_valid, ranges_centre_valid_differs and ranges_ready_valid);
    ranges_counts <= choice(is_set(ranges_counts_sum_2, 2), is_set(ranges_middle, 5), is_set(ranges_counts_sum_2, 1)
      and is_set(ranges_middle, 5));
    ranges_pair_0 <= choice((not is_set(ranges_first_of_pair, 0)) and (not ranges_counts), 0,
      (ranges_pair_0_choices_from_7(7) * 64) + (ranges_pair_0_choices_from_7(17) * 2) + 1);
    ranges_range <= choice((not is_set(ranges_pairs_ready_words_0, 0)) and (not is_set(ranges_pairs_ready_newest_0,
      0)), 0, (ranges_range_choices_from_7(7) * 64) + (ranges_range_choices_from_7(14) * 2) + 1);
    if ranges_ready_valid then
      ranges_pixels_write_words_0 <= (ranges_pixels_ready_words_0 / 64) + (ranges_pixels_ready_newest_0 * 64);
      ranges_pixels_written <= ranges_ready_column;
      ranges_left <= ranges_middle;
      ranges_above <= ranges_next_above;
      ranges_middle <= ranges_right;
      ranges_below <= ranges_next_below;
      ranges_next_below <= ranges_pixels_ready_newest_0;
      ranges_next_above <= choice((((ranges_ready_row / 2) mod 16) /= 0) or is_set(ranges_ready_row, 6) or
        is_set(ranges_ready_row, 5), ranges_pixels_ready_words_0 mod 64, 0);
      ranges_right <= choice(((ranges_ready_row / 8) /= 0) or is_set(ranges_ready_row, 0) or is_set(ranges_ready_row,
        2) or is_set(ranges_ready_row, 1), ranges_pixels_ready_words_0 / 64, 0);
    end if;
    if ranges_counted_valid then ranges_first_of_pair <= ranges_pair_0_choice_6; end if;
    if ranges_pair_ready_valid then
      ranges_pairs_write_words_0 <= ranges_pairs_ready_newest_0;
      ranges_pairs_written <= ranges_pair_ready_column;
    end if;
    -- targets
    targets_pause_all := ranges_valid and (ranges_block_column = 79) and (ranges_block_row /= 0);
    targets_pause_is_equal := targets_pause = 6;
    targets_pause_choice := choice(targets_pause_is_equal, 6, (targets_pause + 1) mod 65536);
    targets_walked_is_equal := targets_walked = 80;
    targets_walked_alls(1) := targets_again and targets_walked_is_equal and (not targets_last_row) and
      targets_pause_is_equal;
    targets_walked_any := (not ranges_valid) or (ranges_block_column /= 79) or (ranges_block_row = 0);
    targets_walked_alls(2) := (not targets_walked_alls(1)) and targets_walked_any;
    targets_walked_alls(3) := targets_pause_is_equal and (targets_walked /= 81);
    targets_walk_place_choices(1) := choice(targets_walk_place = 0, 79, (targets_walk_place + 127) mod 128);
    targets_walk_place_choices(2) := choice(targets_walked_alls(3), targets_walk_place_choices(1), targets_walk_place);
    targets_last_row_choices(1) := choice(targets_walked_is_equal, (not targets_last_row) and (targets_pause /= 6), not
      targets_last_row);
    targets_last_row_choices(2) := choice(targets_again, targets_last_row_choices(1), not targets_last_row);
    targets_column_range_values(1) := is_set(targets_rows_ready_words_0, 11);
    targets_column_range_alls(1) := targets_ready_walk_has_above and targets_ready_walk_has_below;
    targets_column_range_choices(1) := choice(targets_column_range_values(1), targets_ready_walk_has_above,
      targets_column_range_alls(1));
    targets_column_range_choices(2) := choice(is_set(targets_rows_ready_words_0, 0), targets_column_range_choices(1),
      targets_column_range_values(1) and targets_ready_walk_has_above and (not targets_ready_walk_has_below));
    targets_column_range_choices(3) := choice(is_set(targets_rows_ready_words_1, 0), (not
      targets_column_range_values(1)) and targets_ready_walk_has_below, (not targets_column_range_values(1)) or (not
      targets_ready_walk_has_below));
    targets_column_range_any := (not is_set(targets_rows_ready_words_1, 0)) or (not targets_ready_walk_has_below);
    targets_column_range_alls(2) := (not targets_column_range_choices(2)) and targets_column_range_choices(3);
    for i in 0 to 1 loop
      targets_column_range_values(2 * i + 2) := is_set(targets_rows_ready_words_0, 18 - i);
      targets_column_range_values(2 * i + 3) := is_set(targets_rows_ready_words_1, 7 - i);
      targets_column_range_choices(3 * i + 4) := choice(targets_ready_walk_has_below, targets_column_range_values(2 * i
        + 2), targets_column_range_values(2 * i + 3));
      targets_column_range_choices(3 * i + 5) := choice(targets_column_range_values(2 * i + 2),
        targets_ready_walk_has_above, targets_column_range_alls(1));
      targets_column_range_choices(3 * i + 6) := choice(is_set(targets_rows_ready_words_0, 7 - i),
        targets_column_range_choices(3 * i + 5), targets_column_range_values(2 * i + 2) and
        targets_ready_walk_has_above and (not targets_ready_walk_has_below));
    end loop;
    targets_column_range_choices(10) := choice(targets_column_range_choices(4), (not targets_column_range_choices(6))
      or targets_column_range_choices(7) or (not targets_column_range_choices(9)), (not
      targets_column_range_choices(6)) and (targets_column_range_choices(7) or (not targets_column_range_choices(9))));
    targets_column_range_values(6) := is_set(targets_rows_ready_words_0, 19);
    targets_column_range_values(7) := is_set(targets_rows_ready_words_1, 8);
    targets_column_range_choices(11) := choice(targets_ready_walk_has_below, targets_column_range_values(6),
      targets_column_range_values(7));
    targets_column_range_choices(12) := choice(targets_column_range_values(6), targets_ready_walk_has_above,
      targets_column_range_alls(1));
    targets_column_range_choices(13) := choice(is_set(targets_rows_ready_words_0, 8), targets_column_range_choices(12),
      targets_column_range_values(6) and targets_ready_walk_has_above and (not targets_ready_walk_has_below));
    targets_column_range_choices(14) := inverted_carry(targets_column_range_choices(10), not
      targets_column_range_choices(11), targets_column_range_choices(13));
    targets_column_range_values(8) := is_set(targets_rows_ready_words_0, 20);
    targets_column_range_values(9) := is_set(targets_rows_ready_words_1, 9);
    targets_column_range_choices(15) := choice(targets_ready_walk_has_below, targets_column_range_values(8),
      targets_column_range_values(9));
    targets_column_range_choices(16) := choice(targets_column_range_values(8), targets_ready_walk_has_above,
      targets_column_range_alls(1));
    targets_column_range_choices(17) := choice(is_set(targets_rows_ready_words_0, 9), targets_column_range_choices(16),
      targets_column_range_values(8) and targets_ready_walk_has_above and (not targets_ready_walk_has_below));
    targets_column_range_choices(18) := carry(targets_column_range_choices(14), not targets_column_range_choices(15),
      targets_column_range_choices(17));
    targets_column_range_choices(19) := choice(targets_ready_walk_has_below, is_set(targets_rows_ready_words_0, 21),
      is_set(targets_rows_ready_words_1, 10));
    targets_column_range_choices(20) := choice(is_set(targets_rows_ready_words_0, 21), targets_ready_walk_has_above,
      targets_column_range_alls(1));
    targets_column_range_choices(21) := choice(is_set(targets_rows_ready_words_0, 10),
      targets_column_range_choices(20), is_set(targets_rows_ready_words_0, 21) and targets_ready_walk_has_above and
      (not targets_ready_walk_has_below));
    targets_column_range_choices(22) := choice(targets_ready_walk_has_below, targets_column_range_values(1),
      is_set(targets_rows_ready_words_1, 0));
    targets_column_range_choices(23) := choice(targets_column_range_choices(19), targets_column_range_choices(22), (not
      targets_column_range_choices(21)) and targets_column_range_choices(22));
    targets_column_range_choices(24) := choice(targets_column_range_choices(18), targets_column_range_choices(19) and
      (not targets_column_range_choices(21)) and targets_column_range_choices(22), targets_column_range_choices(23));
    targets_column_range_alls(3) := (not targets_column_range_choices(24)) and targets_column_range_choices(2);
    targets_column_range_choices(25) := choice(targets_column_range_alls(3), targets_column_range_choices(6),
      targets_column_range_choices(4));
    targets_column_range_choices(26) := choice(targets_column_range_alls(3), targets_column_range_choices(9),
      targets_column_range_choices(7));
    targets_column_range_choices(27) := choice((not targets_column_range_alls(2)) and targets_column_range_choices(25),
      (not ((not targets_column_range_alls(2)) and targets_column_range_choices(26) and ((not
      targets_column_range_values(5)) or (not targets_ready_walk_has_below)))) and targets_column_range_values(3) and
      targets_ready_walk_has_below, (not ((not targets_column_range_alls(2)) and targets_column_range_choices(26) and
      ((not targets_column_range_values(5)) or (not targets_ready_walk_has_below)))) or (targets_column_range_values(3)
      and targets_ready_walk_has_below));
    for i in 0 to 1 loop
      targets_column_range_choices(2 * i + 28) := choice(targets_column_range_alls(3), targets_column_range_choices(4 *
        i + 13), targets_column_range_choices(4 * i + 11));
      targets_column_range_choices(2 * i + 29) := choice(targets_column_range_choices(2 * i + 27), (not ((not
        targets_column_range_alls(2)) and targets_column_range_choices(2 * i + 28))) or (targets_column_range_values(2
        * i + 7) and targets_ready_walk_has_below), (not ((not targets_column_range_alls(2)) and
        targets_column_range_choices(2 * i + 28))) and targets_column_range_values(2 * i + 7) and
        targets_ready_walk_has_below);
    end loop;
    targets_column_range_choices(32) := choice(targets_column_range_alls(3), targets_column_range_choices(21),
      targets_column_range_choices(19));
    targets_column_range_choices(33) := choice(targets_column_range_choices(31), (not ((not
      targets_column_range_alls(2)) and targets_column_range_choices(32))) or (is_set(targets_rows_ready_words_1, 10)
      and targets_ready_walk_has_below), (not ((not targets_column_range_alls(2)) and
      targets_column_range_choices(32))) and is_set(targets_rows_ready_words_1, 10) and targets_ready_walk_has_below);
    targets_column_range_alls(4) := (not targets_column_range_alls(2)) and targets_column_range_any;
    targets_column_range_choices(34) := choice(targets_column_range_choices(33), targets_column_range_alls(4), not
      targets_column_range_alls(2));
    targets_column_range_value_10 := (targets_rows_ready_words_0 mod 2048) / 2;
    targets_column_range_choices_from_35(35) := choice(targets_ready_walk_has_below, targets_column_range_value_10,
      targets_rows_ready_words_0 / 4096);
    targets_column_range_choices_from_35(36) := choice(targets_ready_walk_has_above,
      targets_column_range_choices_from_35(35), 0);
    targets_column_range_choices_from_35(37) := choice(targets_ready_walk_has_below, targets_rows_ready_words_0 / 4096,
      targets_rows_ready_words_1 / 2);
    targets_column_range_choices_from_38(38) := choice(targets_column_range_alls(3),
      (targets_column_range_choices_from_35(36) * 2) / 64, (targets_column_range_choices_from_35(37) * 2) / 64);
    for i in 0 to 1 loop
      targets_column_range_values(2 * i + 11) := is_set(targets_rows_ready_words_0, 13 - i);
      targets_column_range_values(2 * i + 12) := is_set(targets_rows_ready_words_1, 2 - i);
      targets_column_range_choices(3 * i + 39) := choice(targets_ready_walk_has_below, targets_column_range_values(2 *
        i + 11), targets_column_range_values(2 * i + 12));
      targets_column_range_choices(3 * i + 40) := choice(targets_column_range_values(2 * i + 11),
        targets_ready_walk_has_above, targets_column_range_alls(1));
      targets_column_range_choices(3 * i + 41) := choice(is_set(targets_rows_ready_words_0, 2 - i),
        targets_column_range_choices(3 * i + 40), targets_column_range_values(2 * i + 11) and
        targets_ready_walk_has_above and (not targets_ready_walk_has_below));
    end loop;
    targets_column_range_choices(45) := choice(targets_column_range_choices(39), (not targets_column_range_choices(41))
      or (targets_column_range_choices(42) and (not targets_column_range_choices(44))), (not
      targets_column_range_choices(41)) and targets_column_range_choices(42) and (not
      targets_column_range_choices(44)));
    targets_column_range_values(15) := is_set(targets_rows_ready_words_0, 14);
    targets_column_range_values(16) := is_set(targets_rows_ready_words_1, 3);
    targets_column_range_choices(46) := choice(targets_ready_walk_has_below, targets_column_range_values(15),
      targets_column_range_values(16));
    targets_column_range_choices(47) := choice(targets_column_range_values(15), targets_ready_walk_has_above,
      targets_column_range_alls(1));
    targets_column_range_choices(48) := choice(is_set(targets_rows_ready_words_0, 3), targets_column_range_choices(47),
      targets_column_range_values(15) and targets_ready_walk_has_above and (not targets_ready_walk_has_below));
    targets_column_range_choices(49) := inverted_carry(targets_column_range_choices(45), not
      targets_column_range_choices(46), targets_column_range_choices(48));
    targets_column_range_values(17) := is_set(targets_rows_ready_words_0, 15);
    targets_column_range_values(18) := is_set(targets_rows_ready_words_1, 4);
    targets_column_range_choices(50) := choice(targets_ready_walk_has_below, targets_column_range_values(17),
      targets_column_range_values(18));
    targets_column_range_choices(51) := choice(targets_column_range_values(17), targets_ready_walk_has_above,
      targets_column_range_alls(1));
    targets_column_range_choices(52) := choice(is_set(targets_rows_ready_words_0, 4), targets_column_range_choices(51),
      targets_column_range_values(17) and targets_ready_walk_has_above and (not targets_ready_walk_has_below));
    targets_column_range_choices(53) := carry(targets_column_range_choices(49), not targets_column_range_choices(50),
      targets_column_range_choices(52));
    targets_column_range_values(19) := is_set(targets_rows_ready_words_0, 16);
    targets_column_range_values(20) := is_set(targets_rows_ready_words_1, 5);
    targets_column_range_choices(54) := choice(targets_ready_walk_has_below, targets_column_range_values(19),
      targets_column_range_values(20));
    targets_column_range_choices(55) := choice(targets_column_range_values(19), targets_ready_walk_has_above,
      targets_column_range_alls(1));
    targets_column_range_choices(56) := choice(is_set(targets_rows_ready_words_0, 5), targets_column_range_choices(55),
      targets_column_range_values(19) and targets_ready_walk_has_above and (not targets_ready_walk_has_below));
    targets_column_range_choices(57) := choice(targets_column_range_choices(54), targets_column_range_choices(56) and
      targets_column_range_choices(22), targets_column_range_choices(22));
    targets_column_range_choices(58) := choice(targets_column_range_choices(53), targets_column_range_choices(57), (not
      targets_column_range_choices(54)) and targets_column_range_choices(56) and targets_column_range_choices(22));
    targets_column_range_alls(5) := (not targets_column_range_choices(58)) and targets_column_range_choices(2);
    targets_column_range_values_from_21(21) := (targets_rows_ready_words_0 / 4096) mod 32;
    targets_column_range_choices_from_38(59) := choice(targets_ready_walk_has_below, targets_column_range_value_10 mod
      32, targets_column_range_values_from_21(21));
    targets_column_range_choices_from_38(60) := choice(targets_ready_walk_has_above,
      targets_column_range_choices_from_38(59), 0);
    targets_column_range_values_from_21(22) := (targets_rows_ready_words_1 / 2) mod 32;
    targets_column_range_choices_from_38(61) := choice(targets_ready_walk_has_below,
      targets_column_range_values_from_21(21), targets_column_range_values_from_21(22));
    targets_column_range_choices_from_38(62) := choice(targets_column_range_alls(5),
      targets_column_range_choices_from_38(60), targets_column_range_choices_from_38(61));
    targets_column_range_choices_from_35(63) := choice(targets_column_range_alls(2), 0,
      (targets_column_range_choices_from_38(38) * 32) + targets_column_range_choices_from_38(62));
    targets_column_range_choices_from_35(64) := choice(targets_ready_walk_has_below, targets_rows_ready_words_1 / 2, 0);
    targets_column_range_choices_from_38(65) := choice(targets_column_range_choices(34),
      (targets_column_range_choices_from_35(63) * 2) / 64, (targets_column_range_choices_from_35(64) * 2) / 64);
    targets_column_range_choices(66) := choice(targets_column_range_alls(5), targets_column_range_choices(41),
      targets_column_range_choices(39));
    targets_column_range_choices(67) := choice(targets_column_range_alls(5), targets_column_range_choices(44),
      targets_column_range_choices(42));
    targets_column_range_choices(68) := choice((not targets_column_range_alls(2)) and targets_column_range_choices(66),
      (not ((not targets_column_range_alls(2)) and targets_column_range_choices(67))) and targets_ready_walk_has_below
      and (((targets_rows_ready_words_1 / 2) mod 4) = 3), ((not ((not targets_column_range_alls(2)) and
      targets_column_range_choices(67))) and targets_column_range_values(14) and targets_ready_walk_has_below) or
      (targets_column_range_values(12) and targets_ready_walk_has_below));
    for i in 0 to 2 loop
      targets_column_range_choices(2 * i + 69) := choice(targets_column_range_alls(5), targets_column_range_choices(4 *
        i + 48), targets_column_range_choices(4 * i + 46));
      targets_column_range_choices(2 * i + 70) := choice(targets_column_range_choices(2 * i + 68), (not ((not
        targets_column_range_alls(2)) and targets_column_range_choices(2 * i + 69))) or (targets_column_range_values(2
        * i + 16) and targets_ready_walk_has_below), (not ((not targets_column_range_alls(2)) and
        targets_column_range_choices(2 * i + 69))) and targets_column_range_values(2 * i + 16) and
        targets_ready_walk_has_below);
    end loop;
    targets_column_range_choices(75) := choice(targets_column_range_choices(74), not targets_column_range_alls(2),
      targets_column_range_alls(4));
    targets_column_range_choices_from_38(76) := choice(targets_column_range_alls(2), 0,
      targets_column_range_choices_from_38(62));
    targets_column_range_choices_from_38(77) := choice(targets_ready_walk_has_below,
      targets_column_range_values_from_21(22), 0);
    targets_column_range_choices_from_38(78) := choice(targets_column_range_choices(75),
      targets_column_range_choices_from_38(76), targets_column_range_choices_from_38(77));
    targets_column_range_choice_79 := choice((not targets_column_range_choices(2)) and targets_column_range_choices(3)
      and targets_column_range_any, 0, (targets_column_range_choices_from_38(65) * 64) +
      (targets_column_range_choices_from_38(78) * 2) + 1);
    targets_around_is_equal := targets_column_walk_column = 79;
    targets_around_choices(1) := choice(is_set(targets_here, 0), targets_around_is_equal, (not is_set(targets_behind,
      0)) or targets_around_is_equal);
    targets_around_values(1) := is_set(targets_here, 6);
    targets_around_values(2) := is_set(targets_behind, 6);
    targets_around_differs := targets_column_walk_column /= 79;
    targets_around_values(3) := is_set(targets_here, 7);
    targets_around_values(4) := is_set(targets_behind, 7);
    targets_around_choices(2) := choice((not targets_around_values(1)) and targets_around_values(2) and
      targets_around_differs, targets_around_values(3) and (not targets_around_values(4)) and targets_around_differs,
      targets_around_values(3) or (not targets_around_values(4)) or targets_around_is_equal);
    for i in 8 to 9 loop
      targets_around_values(2 * i - 11) := is_set(targets_here, i);
      targets_around_values(2 * i - 10) := is_set(targets_behind, i);
      targets_around_choices(i - 5) := choice(targets_around_choices(i - 6), targets_around_values(2 * i - 11) or (not
        targets_around_values(2 * i - 10)) or targets_around_is_equal, targets_around_values(2 * i - 11) and (not
        targets_around_values(2 * i - 10)) and targets_around_differs);
    end loop;
    targets_around_choices(5) := choice(targets_around_choices(4), is_set(targets_here, 10) or (not
      is_set(targets_behind, 10)) or targets_around_is_equal, is_set(targets_here, 10) and (not is_set(targets_behind,
      10)) and targets_around_differs);
    targets_around_alls(1) := (not is_set(targets_here, 0)) and is_set(targets_behind, 0) and targets_around_differs;
    targets_around_alls(2) := is_set(targets_behind, 0) and targets_around_differs;
    targets_around_choices(6) := choice(targets_around_choices(5), targets_around_alls(1), targets_around_alls(2));
    targets_around_choices(7) := choice(targets_around_choices(6), targets_around_values(4) and targets_around_differs,
      targets_around_values(3) and targets_around_differs);
    targets_around_choices(8) := choice(targets_around_choices(6), targets_around_values(2) and targets_around_differs,
      targets_around_values(1) and targets_around_differs);
    targets_around_choices(9) := choice(is_set(targets_here, 0), targets_around_differs, targets_around_alls(2));
    targets_around_alls(3) := targets_around_choices(8) and targets_around_choices(9) and (not
      is_set(targets_column_range, 6));
    targets_around_values(9) := is_set(targets_column_range, 7);
    targets_around_choices(10) := inverted_carry(targets_around_alls(3), not targets_around_choices(9),
      targets_around_values(9));
    targets_around_choices(11) := choice(targets_around_choices(7), targets_around_choices(10), (not
      targets_around_alls(3)) or targets_around_values(9));
    for i in 10 to 11 loop
      targets_around_choices(3 * i - 18) := choice(targets_around_choices(6), targets_around_values(2 * i - 14) and
        targets_around_differs, targets_around_values(2 * i - 15) and targets_around_differs);
      targets_around_values(i) := is_set(targets_column_range, i - 2);
      targets_around_choices(3 * i - 17) := choice(targets_around_choices(3 * i - 18), (not targets_around_choices(9))
        and targets_around_values(i), targets_around_values(i));
      targets_around_choices(3 * i - 16) := choice(targets_around_choices(3 * i - 19), (not targets_around_choices(3 *
        i - 18)) or (not targets_around_choices(9)) or targets_around_values(i), targets_around_choices(3 * i - 17));
    end loop;
    targets_around_choices(18) := choice(targets_around_choices(6), is_set(targets_behind, 10), is_set(targets_here,
      10));
    targets_around_alls(4) := targets_around_choices(18) and targets_around_choices(9);
    targets_around_choices(19) := choice(targets_around_alls(4), is_set(targets_column_range, 10) and
      is_set(targets_column_range, 0), is_set(targets_column_range, 0));
    targets_around_choices(20) := choice(targets_around_choices(17), targets_around_choices(19), (not
      targets_around_alls(4)) and is_set(targets_column_range, 10) and is_set(targets_column_range, 0));
    targets_around_choices_from_21(21) := choice(targets_around_is_equal, 0, targets_behind);
    targets_around_choices_from_21(22) := choice(targets_around_is_equal, 0, targets_here);
    targets_around_choices_from_23(23) := choice(targets_around_choices(6), targets_around_choices_from_21(21) / 64,
      targets_around_choices_from_21(22) / 64);
    targets_around_values(12) := is_set(targets_here, 1);
    targets_around_values(13) := is_set(targets_behind, 1);
    targets_around_values(14) := is_set(targets_here, 2);
    targets_around_values(15) := is_set(targets_behind, 2);
    targets_around_choices(24) := choice(targets_around_values(12) and (not targets_around_values(13)) and
      targets_around_differs, targets_around_values(14) or (not targets_around_values(15)) or targets_around_is_equal,
      targets_around_values(14) and (not targets_around_values(15)) and targets_around_differs);
    for i in 3 to 5 loop
      targets_around_values(2 * i + 10) := is_set(targets_here, i);
      targets_around_values(2 * i + 11) := is_set(targets_behind, i);
      targets_around_choices(i + 22) := choice(targets_around_choices(i + 21), targets_around_values(2 * i + 10) or
        (not targets_around_values(2 * i + 11)) or targets_around_is_equal, targets_around_values(2 * i + 10) and (not
        targets_around_values(2 * i + 11)) and targets_around_differs);
    end loop;
    targets_around_choices(28) := choice(targets_around_choices(27), targets_around_alls(2), targets_around_alls(1));
    targets_around_choices_from_29(29) := choice(targets_around_is_equal, 0, targets_behind mod 64);
    targets_around_choices_from_29(30) := choice(targets_around_is_equal, 0, targets_here mod 64);
    targets_around_choices_from_23(31) := choice(targets_around_choices(28), targets_around_choices_from_29(29) / 2,
      targets_around_choices_from_29(30) / 2);
    targets_around_choice_32 := choice(targets_around_choices(1), 0, (targets_around_choices_from_23(23) * 32) +
      targets_around_choices_from_23(31));
    targets_around_choices_from_23(33) := choice((not targets_around_choices(20)) and targets_around_choices(9),
      (targets_around_choice_32 * 2) / 64, targets_column_range / 64);
    targets_around_choices(34) := choice(targets_around_choices(28), targets_around_values(13) and
      targets_around_differs, targets_around_values(12) and targets_around_differs);
    targets_around_values(22) := is_set(targets_column_range, 1);
    targets_around_choices(35) := choice(targets_around_choices(34), (not targets_around_choices(9)) and
      targets_around_values(22), targets_around_values(22));
    for i in 23 to 25 loop
      targets_around_choices(3 * i - 33) := choice(targets_around_choices(28), targets_around_values(2 * i - 31) and
        targets_around_differs, targets_around_values(2 * i - 32) and targets_around_differs);
      targets_around_values(i) := is_set(targets_column_range, i - 21);
      targets_around_choices(3 * i - 32) := choice(targets_around_choices(3 * i - 33), (not targets_around_choices(9))
        and targets_around_values(i), targets_around_values(i));
      targets_around_choices(3 * i - 31) := choice(targets_around_choices(3 * i - 34), (not targets_around_choices(3 *
        i - 33)) or (not targets_around_choices(9)) or targets_around_values(i), targets_around_choices(3 * i - 32));
    end loop;
    targets_around_choices(45) := choice(targets_around_choices(28), targets_around_values(21),
      targets_around_values(20));
    targets_around_choices(46) := choice(targets_around_choices(45) and targets_around_choices(9),
      is_set(targets_column_range, 0), (not is_set(targets_column_range, 5)) and is_set(targets_column_range, 0));
    targets_around_choices(47) := choice(targets_around_choices(44), targets_around_choices(45) and
      targets_around_choices(9) and (not is_set(targets_column_range, 5)) and is_set(targets_column_range, 0),
      targets_around_choices(46));
    targets_around_choices_from_23(48) := choice(targets_around_choices(1), 0, targets_around_choices_from_23(31));
    targets_around_choices_from_23(49) := choice((not targets_around_choices(47)) and targets_around_choices(9),
      targets_around_choices_from_23(48), (targets_column_range mod 64) / 2);
    targets_low_wish_value := (((targets_around mod 64) * 2) / 4) * 4;
    targets_low_wish_choices(1) := choice(targets_low_wish_value < 118, targets_low_wish_value, 118);
    targets_low_wish_choices(2) := choice(targets_low_wish_choices(1) < 6, 6, targets_low_wish_choices(1));
    targets_high_wish_value := (targets_around / 64) * 4;
    targets_high_wish_choices(1) := choice(targets_high_wish_value < 118, targets_high_wish_value, 118);
    targets_high_wish_choices(2) := choice(targets_high_wish_choices(1) < 6, 6, targets_high_wish_choices(1));
    targets_low_all := targets_wish_walk_valid and (targets_wish_walk_column /= 79);
    targets_low_differs := targets_wish_walk_column /= 78;
    targets_low_choices(1) := choice(targets_low_differs, targets_low / 2, 0);
    targets_low_choice_2 := choice(targets_low_differs, (targets_low / 2) mod 4, 0);
    targets_low_sum := (((((targets_low_choices(1) * 2) / 8) + 1) mod 8192) * 4) + targets_low_choice_2;
    targets_low_choices(3) := choice(((targets_low_sum - (targets_low_wish / 2)) < 0) and targets_low_differs,
      targets_low_sum, targets_low_wish / 2);
    targets_low_choices(4) := choice(targets_known, targets_low_choices(3), targets_low_choices(1));
    targets_low_choices(5) := choice(targets_low_all, targets_low_choices(4), targets_low / 2);
    targets_high_choices(1) := choice(targets_low_differs, targets_high / 2, 8);
    targets_high_choice_2 := choice(targets_low_differs, (targets_high / 2) mod 4, 0);
    targets_high_choices(3) := choice(((((((targets_high_wish / 8) + 3) * 4) + ((targets_high_wish / 2) mod 4)) -
      targets_high_choices(1)) < 0) and targets_low_differs, (((((targets_high_choices(1) * 2) / 8) + 8189) mod 8192) *
      4) + targets_high_choice_2, targets_high_wish / 2);
    targets_high_choices(4) := choice(targets_known, targets_high_choices(3), targets_high_choices(1));
    targets_high_choices(5) := choice(targets_low_all, targets_high_choices(4), targets_high / 2);
    targets_newest_0 <= ranges_range;
    targets_comes <= ranges_valid;
    targets_last_row <= (not targets_last_row_choices(2)) and targets_walked_any;
    targets_walk_column <= (79 - targets_walked) mod 65536;
    targets_walk_band <= targets_next_band mod 8;
    targets_walk_has_above <= targets_next_band /= 0;
    targets_walk_has_below <= not targets_last_row;
    targets_walk_valid <= targets_walked_alls(3);
    targets_rows_read_newest_0 <= targets_newest_0;
    targets_rows_ready_words_0 <= to_integer(targets_rows_read_words_0);
    targets_rows_ready_words_1 <= to_integer(targets_rows_read_words_1);
    targets_rows_ready_newest_0 <= targets_rows_read_newest_0;
    targets_read_comes <= targets_comes;
    targets_ready_comes <= targets_read_comes;
    targets_read_place <= targets_read_column;
    targets_ready_place <= targets_read_place;
    targets_read_walk_column <= targets_walk_column;
    targets_read_walk_band <= targets_walk_band;
    targets_read_walk_has_above <= targets_walk_has_above;
    targets_read_walk_has_below <= targets_walk_has_below;
    targets_read_walk_valid <= targets_walk_valid;
    targets_ready_walk_column <= targets_read_walk_column;
    targets_ready_walk_band <= targets_read_walk_band;
    targets_ready_walk_has_above <= targets_read_walk_has_above;
    targets_ready_walk_has_below <= targets_read_walk_has_below;
    targets_ready_walk_valid <= targets_read_walk_valid;
    targets_column_walk_column <= targets_ready_walk_column;
    targets_column_walk_band <= targets_ready_walk_band;
    targets_column_walk_has_below <= refinement_passed_0(2);
    targets_column_walk_valid <= targets_ready_walk_valid;
    targets_around_walk_column <= targets_column_walk_column;
    targets_around_walk_band <= targets_column_walk_band;
    targets_around_walk_has_below <= targets_column_walk_has_below;
    targets_around_walk_valid <= targets_column_walk_valid;
    targets_low_wish <= (((targets_low_wish_choices(2) / 2) + 32765) mod 64) * 2;
    targets_high_wish <= (((targets_high_wish_choices(2) / 2) + 32765) mod 64) * 2;
    targets_known <= is_set(targets_around, 0);
    targets_wish_walk_column <= targets_around_walk_column;
    targets_wish_walk_band <= targets_around_walk_band;
    targets_wish_walk_has_below <= targets_around_walk_has_below;
    targets_wish_walk_valid <= targets_around_walk_valid;
    targets_low <= targets_low_choices(5) * 2;
    targets_high <= targets_high_choices(5) * 2;
    targets_read_column <= choice(ranges_valid, ranges_block_column mod 128, targets_walk_place);
    targets_pause <= choice(targets_pause_all, 0, targets_pause_choice);
    targets_next_band <= choice(targets_pause_all, (ranges_block_row + 65535) mod 65536, (targets_next_band +
      as_number(targets_walked_alls(1))) mod 65536);
    targets_walked <= choice(targets_walked_alls(2), (targets_walked + as_number(targets_walked_alls(3))) mod 65536, 0);
    targets_walk_place <= choice(targets_walked_alls(2), targets_walk_place_choices(2), 79);
    targets_column_range <= choice(targets_ready_walk_column < 80, targets_column_range_choice_79, 0);
    targets_around <= choice((not is_set(targets_column_range, 0)) and targets_around_choices(1), 0,
      (targets_around_choices_from_23(33) * 64) + (targets_around_choices_from_23(49) * 2) + 1);
    if targets_pause_all then targets_again <= ranges_block_row = 59; end if;
    if targets_ready_comes then
      targets_rows_write_words(0) <= (targets_rows_ready_words_0 / 2048) + (targets_rows_ready_words_1 * 2048);
      targets_rows_write_words(1) <= targets_rows_ready_newest_0;
      targets_write_column <= targets_ready_place;
    end if;
    if targets_column_walk_valid then
      targets_behind <= targets_around_choices_from_21(22);
      targets_here <= targets_column_range;
    end if;
    if targets_low_all then
      targets_place <= to_integer(((to_unsigned(targets_wish_walk_band, 3) & to_unsigned(0, 7)) or
        (to_unsigned(((targets_wish_walk_column + 1) mod 1024), 10))));
    end if;
    -- hold
    if in_valid then
      hold_back_ring_write_address <= hold_back_ring_read_address;
      hold_back_ring_read_address <= choice(hold_back_ring_read_address = 2819, 0, (hold_back_ring_read_address + 1)
        mod 4096);
    end if;
    hold_back_holds_groups_is_equal := hold_back_ring_read_address = 0;
    hold_back_next_holds_groups_any := hold_back_next_held_is_new or (hold_back_next_ring_read_address = 0);
    hold_back_next_next_holds_groups_is_equal := hold_back_next_next_ring_read_address = 0;
    hold_back_next_next_next_holds_groups_any := hold_back_next_next_next_held_is_new or
      (hold_back_next_next_next_ring_read_address = 0);
    hold_back_next_next_next_next_holds_groups_is_equal := hold_back_next_next_next_next_ring_read_address = 0;
    hold_back_next_next_next_next_next_holds_groups_any := hold_back_next_next_next_next_next_held_is_new or
      (hold_back_next_next_next_next_next_ring_read_address = 0);
    hold_back_next_next_next_next_next_next_holds_groups_any := hold_back_next_next_next_next_next_next_held_is_new or
      (hold_back_next_next_next_next_next_next_next_ring_read_address = 0);
    hold_back_next_next_next_next_next_next_next_holds_groups_is_equal :=
      hold_back_next_next_next_next_next_next_ring_read_address = 0;
    hold_back_next_next_next_next_next_next_next_next_holds_groups_any :=
      hold_back_next_next_next_next_next_next_next_next_held_is_new or
      (hold_back_next_next_next_next_next_next_next_next_ring_read_address = 0);
    hold_back_holds_groups <= hold_back_held_is_new or hold_back_holds_groups_is_equal;
    hold_back_held_is_new <= hold_back_held_is_new or (hold_back_holds_groups_is_equal and in_valid);
    hold_back_next_holds_groups <= hold_back_next_holds_groups_any;
    hold_back_next_held_valid <= coarse_pixels_valid;
    hold_back_next_next_holds_groups <= hold_back_next_next_held_is_new or hold_back_next_next_holds_groups_is_equal;
    hold_back_next_next_held_is_new <= hold_back_next_next_held_is_new or (hold_back_next_next_holds_groups_is_equal
      and hold_back_next_held_valid);
    hold_back_next_next_held_valid <= hold_back_next_held_valid;
    hold_back_next_next_next_holds_groups <= hold_back_next_next_next_holds_groups_any;
    hold_back_next_next_next_held_valid <= hold_back_next_next_held_valid;
    hold_back_next_next_next_next_holds_groups <= hold_back_next_next_next_next_held_is_new or
      hold_back_next_next_next_next_holds_groups_is_equal;
    hold_back_next_next_next_next_held_is_new <= hold_back_next_next_next_next_held_is_new or
      (hold_back_next_next_next_next_holds_groups_is_equal and hold_back_next_next_next_held_valid);
    hold_back_next_next_next_next_held_valid <= hold_back_next_next_next_held_valid;
    hold_back_next_next_next_next_next_holds_groups <= hold_back_next_next_next_next_next_holds_groups_any;
    hold_back_next_next_next_next_next_held_valid <= hold_back_next_next_next_next_held_valid;
    hold_back_next_next_next_next_next_next_holds_groups <= hold_back_next_next_next_next_next_next_holds_groups_any;
    hold_back_next_next_next_next_next_next_held_valid <= hold_back_next_next_next_next_next_held_valid;
    hold_back_next_next_next_next_next_next_next_holds_groups <=
      hold_back_next_next_next_next_next_next_next_held_is_new or
      hold_back_next_next_next_next_next_next_next_holds_groups_is_equal;
    hold_back_next_next_next_next_next_next_next_held_is_new <=
      hold_back_next_next_next_next_next_next_next_held_is_new or
      (hold_back_next_next_next_next_next_next_next_holds_groups_is_equal and
      hold_back_next_next_next_next_next_held_valid);
    hold_back_next_next_next_next_next_next_next_held_valid <= hold_back_next_next_next_next_next_next_held_valid;
    hold_back_next_next_next_next_next_next_next_next_holds_groups <=
      hold_back_next_next_next_next_next_next_next_next_holds_groups_any;
    hold_back_next_next_next_next_next_next_next_next_held_valid <=
      hold_back_next_next_next_next_next_next_next_held_valid;
    if coarse_pixels_valid then
      hold_back_next_ring_write_address <= hold_back_next_ring_read_address;
      hold_back_next_held_is_new <= hold_back_next_holds_groups_any;
      hold_back_next_ring_read_address <= choice(hold_back_next_ring_read_address = 2819, 0,
        (hold_back_next_ring_read_address + 1) mod 4096);
    end if;
    if hold_back_next_held_valid then
      hold_back_next_next_ring_write_address <= hold_back_next_next_ring_read_address;
      hold_back_next_next_ring_read_address <= choice(hold_back_next_next_ring_read_address = 2819, 0,
        (hold_back_next_next_ring_read_address + 1) mod 4096);
    end if;
    if hold_back_next_next_held_valid then
      hold_back_next_next_next_ring_write_address <= hold_back_next_next_next_ring_read_address;
      hold_back_next_next_next_held_is_new <= hold_back_next_next_next_holds_groups_any;
      hold_back_next_next_next_ring_read_address <= choice(hold_back_next_next_next_ring_read_address = 2819, 0,
        (hold_back_next_next_next_ring_read_address + 1) mod 4096);
    end if;
    if hold_back_next_next_next_held_valid then
      hold_back_next_next_next_next_ring_write_address <= hold_back_next_next_next_next_ring_read_address;
      hold_back_next_next_next_next_ring_read_address <= choice(hold_back_next_next_next_next_ring_read_address = 2819,
        0, (hold_back_next_next_next_next_ring_read_address + 1) mod 4096);
    end if;
    if hold_back_next_next_next_next_held_valid then
      hold_back_next_next_next_next_next_ring_write_address <= hold_back_next_next_next_next_next_ring_read_address;
      hold_back_next_next_next_next_next_held_is_new <= hold_back_next_next_next_next_next_holds_groups_any;
      hold_back_next_next_next_next_next_ring_read_address <=
        choice(hold_back_next_next_next_next_next_ring_read_address = 2819, 0,
        (hold_back_next_next_next_next_next_ring_read_address + 1) mod 4096);
    end if;
    if hold_back_next_next_next_next_next_held_valid then
      hold_back_next_next_next_next_next_next_ring_write_address <=
        hold_back_next_next_next_next_next_next_ring_read_address;
      hold_back_next_next_next_next_next_next_ring_read_address <=
        choice(hold_back_next_next_next_next_next_next_ring_read_address = 2819, 0,
        (hold_back_next_next_next_next_next_next_ring_read_address + 1) mod 4096);
    end if;
    if hold_back_next_next_next_next_next_next_held_valid then
      hold_back_next_next_next_next_next_next_held_is_new <= hold_back_next_next_next_next_next_next_holds_groups_any;
      hold_back_next_next_next_next_next_next_next_ring_write_address <=
        hold_back_next_next_next_next_next_next_next_ring_read_address;
      hold_back_next_next_next_next_next_next_next_ring_read_address <=
        choice(hold_back_next_next_next_next_next_next_next_ring_read_address = 2818, 0,
        (hold_back_next_next_next_next_next_next_next_ring_read_address + 1) mod 4096);
    end if;
    if hold_back_next_next_next_next_next_next_next_held_valid then
      hold_back_next_next_next_next_next_next_next_next_ring_write_address <=
        hold_back_next_next_next_next_next_next_next_next_ring_read_address;
      hold_back_next_next_next_next_next_next_next_next_held_is_new <=
        hold_back_next_next_next_next_next_next_next_next_holds_groups_any;
      hold_back_next_next_next_next_next_next_next_next_ring_read_address <=
        choice(hold_back_next_next_next_next_next_next_next_next_ring_read_address = 2818, 0,
        (hold_back_next_next_next_next_next_next_next_next_ring_read_address + 1) mod 4096);
    end if;
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_group = 479;
    transform_counter_group_is_equals(2) := transform_counter_column = 639;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 15, 0);
    transform_counter_group_differs := transform_counter_group /= 484;
    transform_counter_group_choices(2) := choice((transform_counter_group = 483) and transform_counter_next_frame, 4,
      (transform_counter_group + 1) mod 512);
    transform_counter_group_choices(3) := choice(transform_counter_group_differs and
      hold_back_next_next_next_next_next_next_next_next_held_valid and transform_counter_group_is_equals(2),
      transform_counter_group_choices(2), transform_counter_group);
    transform_centre_column_is_less := 3 < transform_counter_column;
    transform_centre_column_choice := choice(transform_centre_column_is_less, 255, 159);
    transform_left_0 <= to_integer(hold_back_next_next_next_next_next_next_next_next_held_0(8 downto 1));
    transform_right_0 <= to_integer(hold_back_next_next_next_next_next_next_next_next_held_0(16 downto 9));
    transform_valid <= hold_back_next_next_next_next_next_next_next_next_held_valid;
    transform_left_rows_read_newest_0 <= transform_left_0;
    transform_left_rows_ready_words <= transform_left_rows_read_words;
    transform_left_rows_ready_words_2 <= to_integer(transform_left_rows_read_words_2);
    transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
    transform_right_rows_read_newest_0 <= transform_right_0;
    transform_right_rows_ready_words <= transform_right_rows_read_words;
    transform_right_rows_ready_words_2 <= to_integer(transform_right_rows_read_words_2);
    transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
    transform_read_column <= transform_counter_column;
    transform_ready_column <= transform_read_column;
    transform_centre_column <= (((transform_centre_column_choice + (transform_counter_column / 4)) mod 256) * 4) +
      (transform_counter_column mod 4);
    transform_centre_group <= transform_counter_group + as_number(transform_centre_column_is_less);
    transform_from_first(0) <= (1 < transform_centre_column) and (6 < transform_centre_group);
    transform_from_first(1) <= (4 < transform_centre_column) and (9 < transform_centre_group);
    transform_up_to_last(0) <= (transform_centre_column < 638) and (transform_centre_group < 483);
    transform_up_to_last(1) <= (transform_centre_column < 636) and (transform_centre_group < 481);
    for i in 0 to 1 loop
      transform_left_column(4 * i) <= to_integer(transform_left_rows_ready_words(i)(7 downto 0));
      transform_left_column(4 * i + 1) <= to_integer(transform_left_rows_ready_words(i)(15 downto 8));
      transform_left_column(4 * i + 2) <= to_integer(transform_left_rows_ready_words(i)(23 downto 16));
      transform_left_column(4 * i + 3) <= to_integer(transform_left_rows_ready_words(i)(31 downto 24));
    end loop;
    transform_left_column(8) <= transform_left_rows_ready_words_2;
    transform_left_column(9) <= transform_left_rows_ready_newest_0;
    for i in 0 to 1 loop
      transform_right_column(4 * i) <= to_integer(transform_right_rows_ready_words(i)(7 downto 0));
      transform_right_column(4 * i + 1) <= to_integer(transform_right_rows_ready_words(i)(15 downto 8));
      transform_right_column(4 * i + 2) <= to_integer(transform_right_rows_ready_words(i)(23 downto 16));
      transform_right_column(4 * i + 3) <= to_integer(transform_right_rows_ready_words(i)(31 downto 24));
    end loop;
    transform_right_column(8) <= transform_right_rows_ready_words_2;
    transform_right_column(9) <= transform_right_rows_ready_newest_0;
    transform_columns_inside(0) <= transform_up_to_last(0) and transform_from_first(0);
    transform_columns_inside(1) <= transform_up_to_last(1) and transform_from_first(1);
    transform_columns_start_of_frame <= is_set(others_from_8(8), 0);
    transform_columns_valid <= is_set(others_from_8(8), 8);
    transform_left_code_column_box_0_0 <= transform_left_column(3 to 7);
    transform_left_code_column_centre <= transform_left_code_column_box_0_0(2);
    transform_left_code_column_near <= transform_left_code_column_box_0_0(1) + transform_left_code_column_box_0_0(3);
    transform_left_code_column_outer <= (510 - transform_left_code_column_box_0_0(4)) -
      transform_left_code_column_box_0_0(0);
    transform_left_code_column_upper <= 765 - (((transform_left_code_column_box_0_0(1) +
      (transform_left_code_column_box_0_0(0) / 2)) * 2) + (transform_left_code_column_box_0_0(0) mod 2));
    transform_left_code_column_lower <= ((transform_left_code_column_box_0_0(3) +
      (transform_left_code_column_box_0_0(4) / 2)) * 2) + (transform_left_code_column_box_0_0(4) mod 2);
    transform_left_code_column_response(0) <= ((transform_left_code_column_centre + (transform_left_code_column_near /
      2)) * 2) + (transform_left_code_column_near mod 2);
    transform_left_code_column_response(1) <= ((transform_left_code_column_centre + (transform_left_code_column_outer /
      2)) * 2) + (transform_left_code_column_outer mod 2);
    transform_left_code_column_response_2 <= transform_left_code_column_upper + transform_left_code_column_lower;
    transform_left_code_row_box_0(0) <= transform_left_code_column_response(0);
    transform_left_code_row_box_0(1) <= transform_left_code_column_response(1);
    transform_left_code_row_box_0(2) <= transform_left_code_column_response_2;
    transform_left_code_row_centre(0) <= transform_left_code_row_column(0, 1);
    transform_left_code_row_centre(1) <= transform_left_code_row_column(1, 1);
    transform_left_code_row_centre(2) <= transform_left_code_row_column_2(1);
    transform_left_code_row_outer_1 <= transform_left_code_row_box_0(1) + transform_left_code_row_column(1, 3);
    transform_left_code_row_outer_2 <= transform_left_code_row_box_0(2) + transform_left_code_row_column_2(3);
    transform_left_code_row_before(0) <= ((transform_left_code_row_column(0, 2) + (transform_left_code_row_column(0, 3)
      / 2)) * 2) + (transform_left_code_row_column(0, 3) mod 2);
    transform_left_code_row_before(1) <= ((transform_left_code_row_column(1, 2) + (transform_left_code_row_column(1, 3)
      / 2)) * 2) + (transform_left_code_row_column(1, 3) mod 2);
    transform_left_code_row_before_2 <= ((transform_left_code_row_column_2(2) + (transform_left_code_row_column_2(3) /
      2)) * 2) + (transform_left_code_row_column_2(3) mod 2);
    transform_left_code_row_after(0) <= (((transform_left_code_row_box_0(0) / 2) + transform_left_code_row_column(0,
      0)) * 2) + (transform_left_code_row_box_0(0) mod 2);
    transform_left_code_row_after(1) <= (((transform_left_code_row_box_0(1) / 2) + transform_left_code_row_column(1,
      0)) * 2) + (transform_left_code_row_box_0(1) mod 2);
    transform_left_code_row_after_2 <= (((transform_left_code_row_box_0(2) / 2) + transform_left_code_row_column_2(0))
      * 2) + (transform_left_code_row_box_0(2) mod 2);
    transform_left_code_row_even(1) <= ((((transform_left_code_row_outer_1 / 2) - transform_left_code_row_centre(1))
      mod 8192) * 2) + (transform_left_code_row_outer_1 mod 2);
    transform_left_code_row_even(2) <= ((((transform_left_code_row_outer_2 / 2) - transform_left_code_row_centre(2))
      mod 8192) * 2) + (transform_left_code_row_outer_2 mod 2);
    transform_left_code_row_odd(1) <= (transform_left_code_row_before(1) - transform_left_code_row_after(1)) mod 16384;
    transform_left_code_row_odd(2) <= (transform_left_code_row_before_2 - transform_left_code_row_after_2) mod 16384;
    transform_left_code_row_signs <= ((others_from_5(5) / 8192) * 2) + (others_from_5(6) / 8192) +
      ((((transform_left_code_row_even(2) + transform_left_code_row_odd(1)) mod 16384) / 8192) * 8) +
      ((((transform_left_code_row_odd(1) - transform_left_code_row_even(2)) mod 16384) / 8192) * 32) +
      ((((transform_left_code_row_even(1) - transform_left_code_row_odd(2)) mod 16384) / 8192) * 4) +
      ((((transform_left_code_row_even(1) + transform_left_code_row_odd(2)) mod 16384) / 8192) * 16);
    for i in 0 to 4 loop
      transform_left_code_next_column_box_0_0(i) <= transform_left_column(2 * i) + transform_left_column(2 * i + 1);
    end loop;
    transform_left_code_next_column_centre <= transform_left_code_next_column_box_0_0(2);
    transform_left_code_next_column_near <= transform_left_code_next_column_box_0_0(1) +
      transform_left_code_next_column_box_0_0(3);
    transform_left_code_next_column_outer <= (1020 - transform_left_code_next_column_box_0_0(4)) -
      transform_left_code_next_column_box_0_0(0);
    transform_left_code_next_column_upper <= (1530 - (((transform_left_code_next_column_box_0_0(1) +
      (transform_left_code_next_column_box_0_0(0) / 2)) * 2) + (transform_left_code_next_column_box_0_0(0) mod 2))) mod
      65536;
    transform_left_code_next_column_lower <= ((transform_left_code_next_column_box_0_0(3) +
      (transform_left_code_next_column_box_0_0(4) / 2)) * 2) + (transform_left_code_next_column_box_0_0(4) mod 2);
    transform_left_code_next_column_response(0) <= ((transform_left_code_next_column_centre +
      (transform_left_code_next_column_near / 2)) * 2) + (transform_left_code_next_column_near mod 2);
    transform_left_code_next_column_response(1) <= ((transform_left_code_next_column_centre +
      (transform_left_code_next_column_outer / 2)) * 2) + (transform_left_code_next_column_outer mod 2);
    transform_left_code_next_column_response_2 <= (transform_left_code_next_column_upper +
      transform_left_code_next_column_lower) mod 65536;
    transform_left_code_next_row_box_0(0) <= transform_left_code_next_column_response(0) +
      transform_left_code_next_row_earlier_0_0(0);
    transform_left_code_next_row_box_0(1) <= transform_left_code_next_column_response(1) +
      transform_left_code_next_row_earlier_0_0(1);
    transform_left_code_next_row_box_0_2 <= (transform_left_code_next_column_response_2 +
      transform_left_code_next_row_earlier_0_0(2)) mod 65536;
    transform_left_code_next_row_centre(0) <= transform_left_code_next_row_column(0, 3);
    transform_left_code_next_row_centre(1) <= transform_left_code_next_row_column(1, 3);
    transform_left_code_next_row_centre(2) <= transform_left_code_next_row_column_2(3) mod 32768;
    transform_left_code_next_row_outer(0) <= transform_left_code_next_row_box_0(0) +
      transform_left_code_next_row_column(0, 7);
    transform_left_code_next_row_outer(1) <= transform_left_code_next_row_box_0(1) +
      transform_left_code_next_row_column(1, 7);
    transform_left_code_next_row_outer_2 <= (transform_left_code_next_row_box_0_2 +
      transform_left_code_next_row_column_2(7)) mod 65536;
    transform_left_code_next_row_before(0) <= ((transform_left_code_next_row_column(0, 5) +
      (transform_left_code_next_row_column(0, 7) / 2)) * 2) + (transform_left_code_next_row_column(0, 7) mod 2);
    transform_left_code_next_row_before(1) <= ((transform_left_code_next_row_column(1, 5) +
      (transform_left_code_next_row_column(1, 7) / 2)) * 2) + (transform_left_code_next_row_column(1, 7) mod 2);
    transform_left_code_next_row_before_2 <= (((transform_left_code_next_row_column_2(5) +
      (transform_left_code_next_row_column_2(7) / 2)) mod 32768) * 2) + (transform_left_code_next_row_column_2(7) mod
      2);
    transform_left_code_next_row_after(0) <= (((transform_left_code_next_row_box_0(0) / 2) +
      transform_left_code_next_row_column(0, 1)) * 2) + (transform_left_code_next_row_box_0(0) mod 2);
    transform_left_code_next_row_after(1) <= (((transform_left_code_next_row_box_0(1) / 2) +
      transform_left_code_next_row_column(1, 1)) * 2) + (transform_left_code_next_row_box_0(1) mod 2);
    transform_left_code_next_row_after_2 <= ((((transform_left_code_next_row_box_0_2 / 2) +
      transform_left_code_next_row_column_2(1)) mod 32768) * 2) + (transform_left_code_next_row_box_0_2 mod 2);
    transform_left_code_next_row_even(1) <= ((((transform_left_code_next_row_outer(1) / 2) -
      transform_left_code_next_row_centre(1)) mod 32768) * 2) + (transform_left_code_next_row_outer(1) mod 2);
    transform_left_code_next_row_even(2) <= ((((transform_left_code_next_row_outer_2 / 2) -
      transform_left_code_next_row_centre(2)) mod 32768) * 2) + (transform_left_code_next_row_outer_2 mod 2);
    transform_left_code_next_row_odd(0) <= (transform_left_code_next_row_before(0) -
      transform_left_code_next_row_after(0)) mod 65536;
    transform_left_code_next_row_odd(1) <= (transform_left_code_next_row_before(1) -
      transform_left_code_next_row_after(1)) mod 65536;
    transform_left_code_next_row_odd(2) <= (transform_left_code_next_row_before_2 -
      transform_left_code_next_row_after_2) mod 65536;
    transform_left_code_next_row_signs <= (other_4 / 32768) + ((transform_left_code_next_row_odd(0) / 32768) * 2) +
      ((((transform_left_code_next_row_even(2) + transform_left_code_next_row_odd(1)) mod 65536) / 32768) * 8) +
      ((((transform_left_code_next_row_odd(1) - transform_left_code_next_row_even(2)) mod 65536) / 32768) * 32) +
      ((((transform_left_code_next_row_even(1) - transform_left_code_next_row_odd(2)) mod 65536) / 32768) * 4) +
      ((((transform_left_code_next_row_even(1) + transform_left_code_next_row_odd(2)) mod 65536) / 32768) * 16);
    transform_right_code_column_box_0_0 <= transform_right_column(3 to 7);
    transform_right_code_column_centre <= transform_right_code_column_box_0_0(2);
    transform_right_code_column_near <= transform_right_code_column_box_0_0(1) + transform_right_code_column_box_0_0(3);
    transform_right_code_column_outer <= (510 - transform_right_code_column_box_0_0(4)) -
      transform_right_code_column_box_0_0(0);
    transform_right_code_column_upper <= 765 - (((transform_right_code_column_box_0_0(1) +
      (transform_right_code_column_box_0_0(0) / 2)) * 2) + (transform_right_code_column_box_0_0(0) mod 2));
    transform_right_code_column_lower <= ((transform_right_code_column_box_0_0(3) +
      (transform_right_code_column_box_0_0(4) / 2)) * 2) + (transform_right_code_column_box_0_0(4) mod 2);
    transform_right_code_column_response(0) <= ((transform_right_code_column_centre + (transform_right_code_column_near
      / 2)) * 2) + (transform_right_code_column_near mod 2);
    transform_right_code_column_response(1) <= ((transform_right_code_column_centre +
      (transform_right_code_column_outer / 2)) * 2) + (transform_right_code_column_outer mod 2);
    transform_right_code_column_response_2 <= transform_right_code_column_upper + transform_right_code_column_lower;
    transform_right_code_row_box_0(0) <= transform_right_code_column_response(0);
    transform_right_code_row_box_0(1) <= transform_right_code_column_response(1);
    transform_right_code_row_box_0(2) <= transform_right_code_column_response_2;
    transform_right_code_row_centre(0) <= transform_right_code_row_column(0, 1);
    transform_right_code_row_centre(1) <= transform_right_code_row_column(1, 1);
    transform_right_code_row_centre(2) <= transform_right_code_row_column_2(1);
    transform_right_code_row_outer_1 <= transform_right_code_row_box_0(1) + transform_right_code_row_column(1, 3);
    transform_right_code_row_outer_2 <= transform_right_code_row_box_0(2) + transform_right_code_row_column_2(3);
    transform_right_code_row_before(0) <= ((transform_right_code_row_column(0, 2) + (transform_right_code_row_column(0,
      3) / 2)) * 2) + (transform_right_code_row_column(0, 3) mod 2);
    transform_right_code_row_before(1) <= ((transform_right_code_row_column(1, 2) + (transform_right_code_row_column(1,
      3) / 2)) * 2) + (transform_right_code_row_column(1, 3) mod 2);
    transform_right_code_row_before_2 <= ((transform_right_code_row_column_2(2) + (transform_right_code_row_column_2(3)
      / 2)) * 2) + (transform_right_code_row_column_2(3) mod 2);
    transform_right_code_row_after(0) <= (((transform_right_code_row_box_0(0) / 2) + transform_right_code_row_column(0,
      0)) * 2) + (transform_right_code_row_box_0(0) mod 2);
    transform_right_code_row_after(1) <= (((transform_right_code_row_box_0(1) / 2) + transform_right_code_row_column(1,
      0)) * 2) + (transform_right_code_row_box_0(1) mod 2);
    transform_right_code_row_after_2 <= (((transform_right_code_row_box_0(2) / 2) +
      transform_right_code_row_column_2(0)) * 2) + (transform_right_code_row_box_0(2) mod 2);
    transform_right_code_row_even(1) <= ((((transform_right_code_row_outer_1 / 2) - transform_right_code_row_centre(1))
      mod 8192) * 2) + (transform_right_code_row_outer_1 mod 2);
    transform_right_code_row_even(2) <= ((((transform_right_code_row_outer_2 / 2) - transform_right_code_row_centre(2))
      mod 8192) * 2) + (transform_right_code_row_outer_2 mod 2);
    transform_right_code_row_odd(1) <= (transform_right_code_row_before(1) - transform_right_code_row_after(1)) mod
      16384;
    transform_right_code_row_odd(2) <= (transform_right_code_row_before_2 - transform_right_code_row_after_2) mod 16384;
    transform_right_code_row_signs <= ((other(1) / 8192) * 2) + (other(2) / 8192) +
      ((((transform_right_code_row_even(2) + transform_right_code_row_odd(1)) mod 16384) / 8192) * 8) +
      ((((transform_right_code_row_odd(1) - transform_right_code_row_even(2)) mod 16384) / 8192) * 32) +
      ((((transform_right_code_row_even(1) - transform_right_code_row_odd(2)) mod 16384) / 8192) * 4) +
      ((((transform_right_code_row_even(1) + transform_right_code_row_odd(2)) mod 16384) / 8192) * 16);
    for i in 0 to 4 loop
      transform_right_code_next_column_box_0_0(i) <= transform_right_column(2 * i) + transform_right_column(2 * i + 1);
    end loop;
    transform_right_code_next_column_centre <= transform_right_code_next_column_box_0_0(2);
    transform_right_code_next_column_near <= transform_right_code_next_column_box_0_0(1) +
      transform_right_code_next_column_box_0_0(3);
    transform_right_code_next_column_outer <= (1020 - transform_right_code_next_column_box_0_0(4)) -
      transform_right_code_next_column_box_0_0(0);
    transform_right_code_next_column_upper <= (1530 - (((transform_right_code_next_column_box_0_0(1) +
      (transform_right_code_next_column_box_0_0(0) / 2)) * 2) + (transform_right_code_next_column_box_0_0(0) mod 2)))
      mod 65536;
    transform_right_code_next_column_lower <= ((transform_right_code_next_column_box_0_0(3) +
      (transform_right_code_next_column_box_0_0(4) / 2)) * 2) + (transform_right_code_next_column_box_0_0(4) mod 2);
    transform_right_code_next_column_response(0) <= ((transform_right_code_next_column_centre +
      (transform_right_code_next_column_near / 2)) * 2) + (transform_right_code_next_column_near mod 2);
    transform_right_code_next_column_response(1) <= ((transform_right_code_next_column_centre +
      (transform_right_code_next_column_outer / 2)) * 2) + (transform_right_code_next_column_outer mod 2);
    transform_right_code_next_column_response_2 <= (transform_right_code_next_column_upper +
      transform_right_code_next_column_lower) mod 65536;
    transform_right_code_next_row_box_0(0) <= transform_right_code_next_column_response(0) +
      transform_right_code_next_row_earlier_0_0(0);
    transform_right_code_next_row_box_0(1) <= transform_right_code_next_column_response(1) +
      transform_right_code_next_row_earlier_0_0(1);
    transform_right_code_next_row_box_0_2 <= (transform_right_code_next_column_response_2 +
      transform_right_code_next_row_earlier_0_0(2)) mod 65536;
    transform_right_code_next_row_centre(0) <= transform_right_code_next_row_column(0, 3);
    transform_right_code_next_row_centre(1) <= transform_right_code_next_row_column(1, 3);
    transform_right_code_next_row_centre(2) <= transform_right_code_next_row_column_2(3) mod 32768;
    transform_right_code_next_row_outer(0) <= transform_right_code_next_row_box_0(0) +
      transform_right_code_next_row_column(0, 7);
    transform_right_code_next_row_outer(1) <= transform_right_code_next_row_box_0(1) +
      transform_right_code_next_row_column(1, 7);
    transform_right_code_next_row_outer_2 <= (transform_right_code_next_row_box_0_2 +
      transform_right_code_next_row_column_2(7)) mod 65536;
    transform_right_code_next_row_before(0) <= ((transform_right_code_next_row_column(0, 5) +
      (transform_right_code_next_row_column(0, 7) / 2)) * 2) + (transform_right_code_next_row_column(0, 7) mod 2);
    transform_right_code_next_row_before(1) <= ((transform_right_code_next_row_column(1, 5) +
      (transform_right_code_next_row_column(1, 7) / 2)) * 2) + (transform_right_code_next_row_column(1, 7) mod 2);
    transform_right_code_next_row_before_2 <= (((transform_right_code_next_row_column_2(5) +
      (transform_right_code_next_row_column_2(7) / 2)) mod 32768) * 2) + (transform_right_code_next_row_column_2(7) mod
      2);
    transform_right_code_next_row_after(0) <= (((transform_right_code_next_row_box_0(0) / 2) +
      transform_right_code_next_row_column(0, 1)) * 2) + (transform_right_code_next_row_box_0(0) mod 2);
    transform_right_code_next_row_after(1) <= (((transform_right_code_next_row_box_0(1) / 2) +
      transform_right_code_next_row_column(1, 1)) * 2) + (transform_right_code_next_row_box_0(1) mod 2);
    transform_right_code_next_row_after_2 <= ((((transform_right_code_next_row_box_0_2 / 2) +
      transform_right_code_next_row_column_2(1)) mod 32768) * 2) + (transform_right_code_next_row_box_0_2 mod 2);
    transform_right_code_next_row_even(1) <= ((((transform_right_code_next_row_outer(1) / 2) -
      transform_right_code_next_row_centre(1)) mod 32768) * 2) + (transform_right_code_next_row_outer(1) mod 2);
    transform_right_code_next_row_even(2) <= ((((transform_right_code_next_row_outer_2 / 2) -
      transform_right_code_next_row_centre(2)) mod 32768) * 2) + (transform_right_code_next_row_outer_2 mod 2);
    transform_right_code_next_row_odd(0) <= (transform_right_code_next_row_before(0) -
      transform_right_code_next_row_after(0)) mod 65536;
    transform_right_code_next_row_odd(1) <= (transform_right_code_next_row_before(1) -
      transform_right_code_next_row_after(1)) mod 65536;
    transform_right_code_next_row_odd(2) <= (transform_right_code_next_row_before_2 -
      transform_right_code_next_row_after_2) mod 65536;
    transform_right_code_next_row_signs <= (other_0 / 32768) + ((transform_right_code_next_row_odd(0) / 32768) * 2) +
      ((((transform_right_code_next_row_even(2) + transform_right_code_next_row_odd(1)) mod 65536) / 32768) * 8) +
      ((((transform_right_code_next_row_odd(1) - transform_right_code_next_row_even(2)) mod 65536) / 32768) * 32) +
      ((((transform_right_code_next_row_even(1) - transform_right_code_next_row_odd(2)) mod 65536) / 32768) * 4) +
      ((((transform_right_code_next_row_even(1) + transform_right_code_next_row_odd(2)) mod 65536) / 32768) * 16);
    transform_filtering_inside(0, 0) <= transform_columns_inside(0);
    transform_filtering_inside(0, 1) <= transform_columns_inside(1);
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
    for i in 1 to 6 loop
      transform_filtering_inside(i, 0) <= transform_filtering_inside(i - 1, 0);
      transform_filtering_inside(i, 1) <= transform_filtering_inside(i - 1, 1);
      transform_filtering_start_of_frame(i) <= transform_filtering_start_of_frame(i - 1);
      transform_filtering_valid(i) <= transform_filtering_valid(i - 1);
    end loop;
    transform_filtering_start_of_frame(7) <= transform_filtering_start_of_frame(6);
    transform_filtering_valid(7) <= transform_filtering_valid(6);
    transform_counter_group <= choice(hold_back_next_next_next_next_next_next_next_next_held_valid and
      hold_back_next_next_next_next_next_next_next_next_holds_groups and
      (hold_back_next_next_next_next_next_next_next_next_held_0(0) = '1'), transform_counter_group_choice * 32,
      transform_counter_group_choices(3));
    transform_left_code_bits <= choice(transform_filtering_inside(6, 0), transform_left_code_earlier(1), 0);
    transform_right_code_bits <= choice(transform_filtering_inside(6, 0), transform_right_code_earlier(1), 0);
    transform_left_code_next_bits <= choice(transform_filtering_inside(6, 1), transform_left_code_next_row_signs, 0);
    transform_right_code_next_bits <= choice(transform_filtering_inside(6, 1), transform_right_code_next_row_signs, 0);
    transform_counter_column_choice := choice(hold_back_next_next_next_next_next_next_next_next_holds_groups,
      (hold_back_next_next_next_next_next_next_next_next_held_0(0) = '1') or transform_counter_group_is_equals(2),
      transform_counter_group_is_equals(2));
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(2), (transform_counter_group /=
      483) and transform_counter_next_frame, transform_counter_next_frame);
    transform_counter_next_frame_choices(2) := choice(transform_counter_group_differs,
      transform_counter_next_frame_choices(1), transform_counter_next_frame);
    if hold_back_next_next_next_next_next_next_next_next_held_valid then
      transform_counter_column <= choice(transform_counter_column_choice, 0, (transform_counter_column + 1) mod 1024);
      transform_counter_next_frame <= choice(transform_counter_next_frame_choices(2), transform_counter_group_all or
        (not hold_back_next_next_next_next_next_next_next_next_holds_groups) or (not
        (hold_back_next_next_next_next_next_next_next_next_held_0(0) = '1')), transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2) and hold_back_next_next_next_next_next_next_next_next_holds_groups and
        (hold_back_next_next_next_next_next_next_next_next_held_0(0) = '1'));
    end if;
    if is_set(others_from_8(8), 8) then
      transform_left_rows_write_words(0) <= transform_left_rows_ready_words(1)(7 downto 0) &
        transform_left_rows_ready_words(0)(31 downto 8);
      transform_left_rows_write_words(1) <= to_unsigned(transform_left_rows_ready_words_2, 8) &
        transform_left_rows_ready_words(1)(31 downto 8);
      transform_left_rows_write_words_2 <= transform_left_rows_ready_newest_0;
      transform_right_rows_write_words(0) <= transform_right_rows_ready_words(1)(7 downto 0) &
        transform_right_rows_ready_words(0)(31 downto 8);
      transform_right_rows_write_words(1) <= to_unsigned(transform_right_rows_ready_words_2, 8) &
        transform_right_rows_ready_words(1)(31 downto 8);
      transform_right_rows_write_words_2 <= transform_right_rows_ready_newest_0;
      transform_write_column <= transform_ready_column;
    end if;
    if transform_filtering_valid(3) then
      for i in 0 to 1 loop
        transform_left_code_row_column(i, 0) <= transform_left_code_row_box_0(i);
        transform_left_code_row_column(i, 1) <= transform_left_code_row_column(i, 0);
        transform_left_code_row_column(i, 2) <= transform_left_code_row_column(i, 1);
        transform_left_code_row_column(i, 3) <= transform_left_code_row_column(i, 2);
      end loop;
      transform_left_code_row_column_2(0) <= transform_left_code_row_box_0(2);
      transform_left_code_row_column_2(1 to 3) <= transform_left_code_row_column_2(0 to 2);
      for i in 0 to 1 loop
        transform_left_code_next_row_column(i, 0) <= transform_left_code_next_row_box_0(i);
        for j in 1 to 7 loop
          transform_left_code_next_row_column(i, j) <= transform_left_code_next_row_column(i, j - 1);
        end loop;
      end loop;
      transform_left_code_next_row_column_2(0) <= transform_left_code_next_row_box_0_2;
      transform_left_code_next_row_column_2(1 to 7) <= transform_left_code_next_row_column_2(0 to 6);
      for i in 0 to 1 loop
        transform_right_code_row_column(i, 0) <= transform_right_code_row_box_0(i);
        transform_right_code_row_column(i, 1) <= transform_right_code_row_column(i, 0);
        transform_right_code_row_column(i, 2) <= transform_right_code_row_column(i, 1);
        transform_right_code_row_column(i, 3) <= transform_right_code_row_column(i, 2);
      end loop;
      transform_right_code_row_column_2(0) <= transform_right_code_row_box_0(2);
      transform_right_code_row_column_2(1 to 3) <= transform_right_code_row_column_2(0 to 2);
      for i in 0 to 1 loop
        transform_right_code_next_row_column(i, 0) <= transform_right_code_next_row_box_0(i);
        for j in 1 to 7 loop
          transform_right_code_next_row_column(i, j) <= transform_right_code_next_row_column(i, j - 1);
        end loop;
      end loop;
      transform_right_code_next_row_column_2(0) <= transform_right_code_next_row_box_0_2;
      transform_right_code_next_row_column_2(1 to 7) <= transform_right_code_next_row_column_2(0 to 6);
    end if;
    if transform_filtering_valid(6) then
      transform_left_code_earlier(0) <= transform_left_code_row_signs;
      transform_left_code_earlier(1) <= transform_left_code_earlier(0);
      transform_right_code_earlier(0) <= transform_right_code_row_signs;
      transform_right_code_earlier(1) <= transform_right_code_earlier(0);
    end if;
    if transform_filtering_valid(2) then
      transform_left_code_next_row_earlier_0_0(0) <= transform_left_code_next_column_response(0);
      transform_left_code_next_row_earlier_0_0(1) <= transform_left_code_next_column_response(1);
      transform_left_code_next_row_earlier_0_0(2) <= transform_left_code_next_column_response_2;
      transform_right_code_next_row_earlier_0_0(0) <= transform_right_code_next_column_response(0);
      transform_right_code_next_row_earlier_0_0(1) <= transform_right_code_next_column_response(1);
      transform_right_code_next_row_earlier_0_0(2) <= transform_right_code_next_column_response_2;
    end if;
    -- ahead
    if transform_filtering_valid(7) then
      ahead_ring_write_address <= ahead_ring_read_address;
      ahead_ring_read_address <= choice(ahead_ring_read_address = 116, 0, (ahead_ring_read_address + 1) mod 128);
    end if;
    ahead_holds_groups_is_equal := ahead_ring_read_address = 0;
    if ahead_holds_groups_is_equal then
      ahead_holds_groups <= ahead_holds_groups or transform_filtering_valid(7);
    end if;
    ahead_held_is_new <= ahead_holds_groups_is_equal or ahead_holds_groups;
    ahead_held_valid <= transform_filtering_valid(7);
    -- raster
    raster_place_group_is_equal := raster_place_column = 639;
    raster_features_reference_0 <= to_integer(ahead_held_0(12 downto 1));
    raster_features_valid <= ahead_held_valid;
    raster_place_group <= choice(ahead_held_valid and ahead_held_is_new and (ahead_held_0(0) = '1'), 0,
      (raster_place_group + as_number(((raster_place_group /= 484) and ahead_held_valid and
      raster_place_group_is_equal))) mod 512);
    if ahead_held_valid then
      raster_place_column <= choice(raster_place_group_is_equal or (ahead_held_is_new and (ahead_held_0(0) = '1')), 0,
        (raster_place_column + 1) mod 1024);
    end if;
    -- bases
    bases_address_0_is_less := raster_place_column < 16;
    bases_address_0_value := ((raster_place_column + 8177) mod 8192) / 8;
    bases_address_0_choice := choice(bases_address_0_is_less, 0, bases_address_0_value);
    bases_address_0_value_2 := (raster_place_group mod 64) * 16;
    bases_address_0_choice_2 := choice(bases_address_0_is_less, 0, bases_address_0_value mod 128);
    bases_goal_0_value(0) := ((bases_ready_targets(0) / 2) mod 128) * 2;
    bases_goal_0_value(1) := ((bases_ready_targets(1) / 2) mod 128) * 2;
    bases_goal_0_value(2) := ((bases_ready_targets(2) / 2) mod 128) * 2;
    for i in 0 to 1 loop
      bases_rises_sum(i, 0) := bases_base(i, 0) + 3;
      bases_rises_all(i, 0) := ((bases_goal(i, 0) - bases_rises_sum(i, 0)) >= 0) and (not bases_wanted_head);
      bases_rises_sum(i, 1) := bases_base(i, 1) + 3;
      bases_rises_all(i, 1) := ((bases_goal(i, 1) - bases_rises_sum(i, 1)) >= 0) and (not bases_wanted_head);
    end loop;
    bases_falls_all(0, 0) := ((bases_goal(0, 0) - bases_base(0, 0)) < 0) and (not bases_wanted_head);
    bases_falls_all(0, 1) := ((bases_goal(0, 1) - bases_base(0, 1)) < 0) and (not bases_wanted_head);
    bases_falls_all(1, 0) := ((bases_goal(1, 0) - bases_base(1, 0)) < 0) and (not bases_wanted_head);
    bases_falls_all(1, 1) := ((bases_goal(1, 1) - bases_base(1, 1)) < 0) and (not bases_wanted_head);
    bases_address(0) <= ((((bases_address_0_choice / 128) + (bases_address_0_value_2 / 128)) mod 8) * 128) +
      bases_address_0_choice_2;
    bases_address(1) <= ((((bases_address_0_choice / 128) + ((((raster_place_group + 55) mod 64) * 16) / 128)) mod 8) *
      128) + bases_address_0_choice_2;
    bases_address(2) <= ((((bases_address_0_choice / 128) + (((((bases_address_0_value_2 / 64) + 15) mod 16) * 64) /
      128)) mod 8) * 128) + bases_address_0_choice_2;
    bases_asked_column <= raster_place_column;
    bases_asked_head <= bases_address_0_is_less;
    bases_asked_frame_starts <= to_integer(((to_unsigned(raster_place_column, 10)) or (to_unsigned(raster_place_group,
      10)))) = 0;
    bases_asked_valid <= raster_features_valid;
    bases_read_column <= bases_asked_column;
    bases_read_limit <= bases_asked_limit;
    bases_read_head <= bases_asked_head;
    bases_read_frame_starts <= bases_asked_frame_starts;
    bases_read_valid <= bases_asked_valid;
    bases_ready_targets(0) <= to_integer(bases_read_targets(0));
    bases_ready_targets(1) <= to_integer(bases_read_targets(1));
    bases_ready_targets(2) <= to_integer(bases_read_targets(2));
    bases_ready_column <= bases_read_column;
    bases_ready_limit <= bases_read_limit;
    bases_ready_head <= bases_read_head;
    bases_ready_frame_starts <= bases_read_frame_starts;
    bases_ready_valid <= bases_read_valid;
    bases_wanted_column <= bases_ready_column;
    bases_wanted_head <= bases_ready_head;
    bases_wanted_frame_starts <= bases_ready_frame_starts;
    bases_wanted_valid <= bases_ready_valid;
    bases_rises <= bases_rises_all;
    bases_falls <= bases_falls_all;
    bases_stands_column <= bases_wanted_column;
    bases_stands_frame_starts <= bases_wanted_frame_starts;
    bases_stands_valid <= bases_wanted_valid;
    bases_asked_limit <= choice(bases_address_0_is_less, 624, (639 - raster_place_column) mod 65536);
    for i in 0 to 2 loop
      bases_goal(0, i) <= choice((bases_goal_0_value(i) - bases_ready_limit) < 0, bases_goal_0_value(i),
        bases_ready_limit mod 256);
    end loop;
    for i in 0 to 2 loop
      bases_goal(1, i) <= choice(((bases_ready_targets(i) / 256) - bases_ready_limit) < 0, bases_ready_targets(i) /
        256, bases_ready_limit mod 256);
    end loop;
    bases_from(0, 0) <= choice(bases_wanted_head, bases_goal(0, 0), bases_base(0, 0) mod 8192);
    bases_from(0, 1) <= choice(bases_wanted_head, bases_goal(0, 1), bases_base(0, 1) mod 8192);
    bases_from(1, 0) <= choice(bases_wanted_head, bases_goal(1, 0), bases_base(1, 0) mod 8192);
    bases_from(1, 1) <= choice(bases_wanted_head, bases_goal(1, 1), bases_base(1, 1) mod 8192);
    for i in 0 to 1 loop
      bases_base_choice(i, 0, 1) := choice(((((as_number(bases_falls_all(i, 0)) * 32768) + 32768) mod 65536) - 32768) <
        0, 65535, 0);
      bases_base_choice(i, 0, 2) := choice(bases_rises_all(i, 0), bases_rises_sum(i, 0) mod 65536, (bases_base(i, 0) +
        bases_base_choice(i, 0, 1)) mod 65536);
      bases_base_choice(i, 1, 1) := choice(((((as_number(bases_falls_all(i, 1)) * 32768) + 32768) mod 65536) - 32768) <
        0, 65535, 0);
      bases_base_choice(i, 1, 2) := choice(bases_rises_all(i, 1), bases_rises_sum(i, 1) mod 65536, (bases_base(i, 1) +
        bases_base_choice(i, 1, 1)) mod 65536);
      bases_base_2_sum(i) := bases_base(i, 2) + 3;
      bases_base_choice(i, 2, 1) := choice(((((as_number((((bases_goal(i, 2) - bases_base(i, 2)) < 0) and (not
        bases_wanted_head))) * 32768) + 32768) mod 65536) - 32768) < 0, 65535, 0);
      bases_base_choice(i, 2, 2) := choice(((bases_goal(i, 2) - bases_base_2_sum(i)) >= 0) and (not bases_wanted_head),
        bases_base_2_sum(i) mod 65536, (bases_base(i, 2) + bases_base_choice(i, 2, 1)) mod 65536);
    end loop;
    if bases_wanted_valid then
      bases_base(0, 0) <= choice(bases_wanted_head, bases_goal(0, 0), bases_base_choice(0, 0, 2));
      bases_base(0, 1) <= choice(bases_wanted_head, bases_goal(0, 1), bases_base_choice(0, 1, 2));
      bases_base(0, 2) <= choice(bases_wanted_head, bases_goal(0, 2), bases_base_choice(0, 2, 2));
      bases_base(1, 0) <= choice(bases_wanted_head, bases_goal(1, 0), bases_base_choice(1, 0, 2));
      bases_base(1, 1) <= choice(bases_wanted_head, bases_goal(1, 1), bases_base_choice(1, 1, 2));
      bases_base(1, 2) <= choice(bases_wanted_head, bases_goal(1, 2), bases_base_choice(1, 2, 2));
    end if;
    if bases_stands_valid then bases_from_0_2 <= bases_base(0, 2); end if;
    -- rows
    rows_last_3_sum := (transform_left_code_next_bits * 64) + transform_left_code_bits;
    rows_newest_column_any := (not transform_filtering_valid(7)) or (not transform_filtering_start_of_frame(7));
    rows_newest_column_is_equal := rows_newest_column = 639;
    rows_newest_column_sum := rows_newest_column + 1;
    rows_newest_column_choices(1) := choice(rows_newest_column_is_equal, 0, rows_newest_column_sum mod 65536);
    rows_newest_column_choices(2) := choice(rows_newest_column_any, rows_newest_column_choices(1), 0);
    if transform_filtering_valid(7) then
      rows_last(1 to 2) <= rows_last(2 to 3);
      rows_last(3) <= rows_last_3_sum;
      rows_newest_column <= rows_newest_column_choices(2);
    end if;
    rows_newest_row_is_equal := (rows_newest_row / 32) = 50;
    rows_newest_row_sum := (rows_newest_row / 32) + 5;
    rows_newest_row_choices(1) := choice(rows_newest_row_is_equal, 0, rows_newest_row_sum mod 2048);
    rows_newest_row_choices(2) := choice(rows_newest_column_is_equal, rows_newest_row_choices(1), rows_newest_row / 32);
    rows_newest_row_choices(3) := choice(rows_newest_column_any, rows_newest_row_choices(2), 0);
    rows_newest_row_choices(4) := choice(transform_filtering_valid(7), rows_newest_row_choices(3), rows_newest_row /
      32);
    rows_enter_row_all := (bases_stands_column = 0) and bases_stands_valid;
    rows_enter_row_choices(1) := choice((rows_enter_row / 32) = 50, 0, ((rows_enter_row / 32) + 5) mod 2048);
    rows_enter_row_choices(2) := choice(bases_stands_frame_starts, 0, rows_enter_row_choices(1));
    rows_enter_row_choices(3) := choice(rows_enter_row_all, rows_enter_row_choices(2), rows_enter_row / 32);
    rows_leave_row_choices(1) := choice((rows_leave_row / 32) = 50, 0, ((rows_leave_row / 32) + 5) mod 2048);
    rows_leave_row_choices(2) := choice(bases_stands_frame_starts, 10, rows_leave_row_choices(1));
    rows_leave_row_choices(3) := choice(rows_enter_row_all, rows_leave_row_choices(2), rows_leave_row / 32);
    rows_position_sum(0, 0) := bases_from(0, 0) + bases_stands_column;
    rows_position_sum(0, 1) := bases_from(0, 1) + bases_stands_column;
    rows_position_sum(1, 0) := bases_from(1, 0) + bases_stands_column;
    rows_position_sum(1, 1) := bases_from(1, 1) + bases_stands_column;
    for i in 0 to 1 loop
      rows_address_value(2 * i) := (((rows_enter_row / 32) + (rows_position(i, 0) / 128)) mod 64) * 32;
      rows_address_value_2(2 * i) := (rows_position(i, 0) / 4) mod 32;
      rows_address_value(2 * i + 1) := (((rows_leave_row / 32) + (rows_position(i, 1) / 128)) mod 64) * 32;
      rows_address_value_2(2 * i + 1) := (rows_position(i, 1) / 4) mod 32;
    end loop;
    for i in 0 to 1 loop
      rows_codes_choice(i, 0, 0, 1) := choice(is_set(rows_ready_first_bank(i, 0), 1), rows_ready_codes(8 * i + 3),
        rows_ready_codes(8 * i + 1));
      rows_codes_choice(i, 0, 0, 2) := choice(is_set(rows_ready_first_bank(i, 0), 1), rows_ready_codes(8 * i + 2),
        rows_ready_codes(8 * i));
      rows_codes_choice(i, 0, 1, 1) := choice(is_set(rows_ready_first_bank(i, 0), 1), rows_ready_codes(8 * i),
        rows_ready_codes(8 * i + 2));
      rows_codes_choice(i, 0, 2, 1) := choice(is_set(rows_ready_first_bank(i, 0), 1), rows_ready_codes(8 * i + 1),
        rows_ready_codes(8 * i + 3));
      rows_codes_choice(i, 1, 0, 1) := choice(is_set(rows_ready_first_bank(i, 1), 1), rows_ready_codes(8 * i + 7),
        rows_ready_codes(8 * i + 5));
      rows_codes_choice(i, 1, 0, 2) := choice(is_set(rows_ready_first_bank(i, 1), 1), rows_ready_codes(8 * i + 6),
        rows_ready_codes(8 * i + 4));
      rows_codes_choice(i, 1, 1, 1) := choice(is_set(rows_ready_first_bank(i, 1), 1), rows_ready_codes(8 * i + 4),
        rows_ready_codes(8 * i + 6));
      rows_codes_choice(i, 1, 2, 1) := choice(is_set(rows_ready_first_bank(i, 1), 1), rows_ready_codes(8 * i + 5),
        rows_ready_codes(8 * i + 7));
    end loop;
    rows_newest_row <= rows_newest_row_choices(4) * 32;
    rows_enter_row <= rows_enter_row_choices(3) * 32;
    rows_leave_row <= rows_leave_row_choices(3) * 32;
    rows_position(0, 0) <= rows_position_sum(0, 0) mod 8192;
    rows_position(0, 1) <= rows_position_sum(0, 1) mod 8192;
    rows_position(1, 0) <= rows_position_sum(1, 0) mod 8192;
    rows_position(1, 1) <= rows_position_sum(1, 1) mod 8192;
    rows_wanted_first_bank(0, 0) <= rows_position_sum(0, 0) mod 4;
    rows_wanted_first_bank(0, 1) <= rows_position_sum(0, 1) mod 4;
    rows_wanted_first_bank(1, 0) <= rows_position_sum(1, 0) mod 4;
    rows_wanted_first_bank(1, 1) <= rows_position_sum(1, 1) mod 4;
    rows_wanted_one(0, 0) <= (not bases_falls(0, 0)) and (not bases_rises(0, 0));
    rows_wanted_one(0, 1) <= (not bases_falls(0, 1)) and (not bases_rises(0, 1));
    rows_wanted_one(1, 0) <= (not bases_falls(1, 0)) and (not bases_rises(1, 0));
    rows_wanted_one(1, 1) <= (not bases_falls(1, 1)) and (not bases_rises(1, 1));
    rows_wanted_four <= bases_rises;
    for i in 0 to 1 loop
      rows_address(8 * i) <= (rows_address_value(2 * i) + rows_address_value_2(2 * i) +
        as_number((is_set(rows_wanted_first_bank(i, 0), 1) or is_set(rows_wanted_first_bank(i, 0), 0)))) mod 2048;
      rows_address(8 * i + 1) <= (rows_address_value(2 * i) + rows_address_value_2(2 * i) + (rows_wanted_first_bank(i,
        0) / 2)) mod 2048;
      rows_address(8 * i + 2) <= (rows_address_value(2 * i) + rows_address_value_2(2 * i) +
        as_number((rows_wanted_first_bank(i, 0) = 3))) mod 2048;
      rows_address(8 * i + 3) <= rows_address_value(2 * i) + rows_address_value_2(2 * i);
      rows_address(8 * i + 4) <= (rows_address_value(2 * i + 1) + rows_address_value_2(2 * i + 1) +
        as_number((is_set(rows_wanted_first_bank(i, 1), 1) or is_set(rows_wanted_first_bank(i, 1), 0)))) mod 2048;
      rows_address(8 * i + 5) <= (rows_address_value(2 * i + 1) + rows_address_value_2(2 * i + 1) +
        (rows_wanted_first_bank(i, 1) / 2)) mod 2048;
      rows_address(8 * i + 6) <= (rows_address_value(2 * i + 1) + rows_address_value_2(2 * i + 1) +
        as_number((rows_wanted_first_bank(i, 1) = 3))) mod 2048;
      rows_address(8 * i + 7) <= rows_address_value(2 * i + 1) + rows_address_value_2(2 * i + 1);
    end loop;
    rows_asked_first_bank <= rows_wanted_first_bank;
    rows_asked_one <= rows_wanted_one;
    rows_asked_four <= rows_wanted_four;
    rows_read_first_bank <= rows_asked_first_bank;
    rows_read_one <= rows_asked_one;
    rows_read_four <= rows_asked_four;
    for i in 0 to 15 loop rows_ready_codes(i) <= to_integer(rows_read_codes(i)); end loop;
    rows_ready_first_bank <= rows_read_first_bank;
    rows_ready_one <= rows_read_one;
    rows_ready_four <= rows_read_four;
    rows_step_one <= rows_ready_one;
    rows_step_four <= rows_ready_four;
    for i in 0 to 1 loop
      rows_codes(i, 0, 0) <= choice(is_set(rows_ready_first_bank(i, 0), 0), rows_codes_choice(i, 0, 0, 1),
        rows_codes_choice(i, 0, 0, 2));
      rows_codes(i, 0, 1) <= choice(is_set(rows_ready_first_bank(i, 0), 0), rows_codes_choice(i, 0, 1, 1),
        rows_codes_choice(i, 0, 0, 1));
      rows_codes(i, 0, 2) <= choice(is_set(rows_ready_first_bank(i, 0), 0), rows_codes_choice(i, 0, 2, 1),
        rows_codes_choice(i, 0, 1, 1));
      rows_codes(i, 0, 3) <= choice(is_set(rows_ready_first_bank(i, 0), 0), rows_codes_choice(i, 0, 0, 2),
        rows_codes_choice(i, 0, 2, 1));
      rows_codes(i, 1, 0) <= choice(is_set(rows_ready_first_bank(i, 1), 0), rows_codes_choice(i, 1, 0, 1),
        rows_codes_choice(i, 1, 0, 2));
      rows_codes(i, 1, 1) <= choice(is_set(rows_ready_first_bank(i, 1), 0), rows_codes_choice(i, 1, 1, 1),
        rows_codes_choice(i, 1, 0, 1));
      rows_codes(i, 1, 2) <= choice(is_set(rows_ready_first_bank(i, 1), 0), rows_codes_choice(i, 1, 2, 1),
        rows_codes_choice(i, 1, 1, 1));
      rows_codes(i, 1, 3) <= choice(is_set(rows_ready_first_bank(i, 1), 0), rows_codes_choice(i, 1, 0, 2),
        rows_codes_choice(i, 1, 2, 1));
    end loop;
    rows_write_word_choices(1) := choice(rows_newest_row_is_equal, 0, rows_newest_row_sum mod 64);
    rows_write_word_choices(2) := choice(rows_newest_column_is_equal, rows_write_word_choices(1), (rows_newest_row /
      32) mod 64);
    rows_write_word_choices(3) := choice(rows_newest_column_any, rows_write_word_choices(2), 0);
    rows_write_codes_0_all := ((((rows_newest_column_sum mod 65536) / 2) mod 2) = 1) and is_set(rows_newest_column_sum,
      0) and rows_newest_column_any and (rows_newest_column /= 639) and transform_filtering_valid(7);
    if rows_write_codes_0_all then
      rows_write_codes(0) <= rows_last(1);
      rows_write_codes(1 to 2) <= rows_last(2 to 3);
      rows_write_codes(3) <= rows_last_3_sum;
      rows_write_word <= ((((((rows_newest_column_choices(2) / 4) mod 2048) / 32) + rows_write_word_choices(3)) mod 64)
        * 32) + ((rows_newest_column_choices(2) / 4) mod 32);
    end if;
    -- pairs
    if raster_features_valid then
      pairs_ring_write_address <= pairs_ring_read_address;
      pairs_ring_read_address <= choice(pairs_ring_read_address = 15, 0, (pairs_ring_read_address + 1) mod 16);
    end if;
    pairs_tag_first_cost_is_equal := raster_place_column = 15;
    pairs_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 489);
    pairs_row_inside(1) <= raster_place_group < 480;
    pairs_tag.row_start <= raster_place_column = 0;
    pairs_tag.first_group <= raster_place_group = 0;
    pairs_tag.border_column <= raster_place_column < 15;
    pairs_tag.first_cost <= pairs_tag_first_cost_is_equal;
    pairs_tag.leaves_window <= (((((raster_place_column / 8) + 8189) mod 8192) * 8) + (raster_place_column mod 8)) <
      65516;
    pairs_tag.output_column <= ((((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) <
      480) and (raster_place_column >= 15) and (raster_place_column < 639);
    pairs_tag.start_of_frame <= (raster_place_group = 4) and pairs_tag_first_cost_is_equal;
    pairs_tag.end_of_line <= raster_place_column = 638;
    -- compared
    compared_rows_read_newest_0 <= to_integer(pairs_delayed_0);
    compared_rows_ready_words(0) <= to_integer(compared_rows_read_words(0));
    compared_rows_ready_words(1) <= to_integer(compared_rows_read_words(1));
    compared_rows_ready_words(2) <= to_integer(compared_rows_read_words(2));
    compared_rows_ready_words(3) <= to_integer(compared_rows_read_words(3));
    compared_rows_ready_words_4 <= to_integer(compared_rows_read_words_4);
    compared_rows_ready_newest_0 <= compared_rows_read_newest_0;
    compared_read_inside <= pairs_row_inside;
    compared_read_tag <= pairs_tag;
    compared_ready_inside <= compared_read_inside;
    compared_ready_tag <= compared_read_tag;
    compared_held_inside(0, 0) <= compared_ready_inside(0);
    compared_held_inside(0, 1) <= compared_ready_inside(1);
    for i in 1 to 7 loop
      compared_held_reference(i, 0) <= compared_held_reference(i - 1, 0);
      compared_held_reference(i, 1) <= compared_held_reference(i - 1, 1);
      compared_held_inside(i, 0) <= compared_held_inside(i - 1, 0);
      compared_held_inside(i, 1) <= compared_held_inside(i - 1, 1);
    end loop;
    compared_tags_row_start(0) <= compared_ready_tag.row_start;
    compared_tags_first_group(0) <= compared_ready_tag.first_group;
    compared_tags_border_column(0) <= compared_ready_tag.border_column;
    compared_tags_first_cost(0) <= compared_ready_tag.first_cost;
    compared_tags_leaves_window(0) <= compared_ready_tag.leaves_window;
    compared_tags_output_column(0) <= compared_ready_tag.output_column;
    compared_tags_start_of_frame(0) <= compared_ready_tag.start_of_frame;
    compared_tags_end_of_line(0) <= compared_ready_tag.end_of_line;
    compared_tags_row_start(1) <= compared_tags_row_start(0);
    compared_tags_first_group(1) <= compared_tags_first_group(0);
    compared_tags_border_column(1) <= compared_tags_border_column(0);
    compared_tags_first_cost(1) <= compared_tags_first_cost(0);
    compared_tags_leaves_window(1) <= compared_tags_leaves_window(0);
    compared_tags_output_column(1) <= compared_tags_output_column(0);
    compared_tags_start_of_frame(1) <= compared_tags_start_of_frame(0);
    compared_tags_end_of_line(1) <= compared_tags_end_of_line(0);
    compared_tags_valid(2) <= bases_stands_valid;
    for i in 2 to 6 loop
      compared_tags_row_start(i) <= compared_tags_row_start(i - 1);
      compared_tags_first_group(i) <= compared_tags_first_group(i - 1);
      compared_tags_border_column(i) <= compared_tags_border_column(i - 1);
      compared_tags_first_cost(i) <= compared_tags_first_cost(i - 1);
      compared_tags_leaves_window(i) <= compared_tags_leaves_window(i - 1);
      compared_tags_output_column(i) <= compared_tags_output_column(i - 1);
      compared_tags_start_of_frame(i) <= compared_tags_start_of_frame(i - 1);
      compared_tags_end_of_line(i) <= compared_tags_end_of_line(i - 1);
      compared_tags_valid(i + 1) <= compared_tags_valid(i);
    end loop;
    compared_tags_row_start(7) <= compared_tags_row_start(6);
    compared_tags_first_group(7) <= compared_tags_first_group(6);
    compared_tags_border_column(7) <= compared_tags_border_column(6);
    compared_tags_first_cost(7) <= compared_tags_first_cost(6);
    compared_tags_leaves_window(7) <= compared_tags_leaves_window(6);
    compared_tags_output_column(7) <= compared_tags_output_column(6);
    compared_tags_start_of_frame(7) <= compared_tags_start_of_frame(6);
    compared_tags_end_of_line(7) <= compared_tags_end_of_line(6);
    compared_held_reference(0, 0) <= choice(compared_ready_inside(0), compared_rows_ready_words(0) mod 4096, 0);
    compared_held_reference(0, 1) <= choice(compared_ready_inside(1), compared_rows_ready_newest_0, 0);
    if bases_ready_valid then
      for i in 0 to 2 loop
        compared_rows_write_words(i) <= (compared_rows_ready_words(i) / 4096) + ((compared_rows_ready_words(i + 1) mod
          4096) * 4096);
      end loop;
      compared_rows_write_words(3) <= (compared_rows_ready_words(3) / 4096) + (compared_rows_ready_words_4 * 4096);
      compared_rows_write_words(4) <= compared_rows_ready_newest_0;
      compared_write_column <= bases_ready_column;
    end if;
    -- lowchain
    lowchain_lane_0_0_all := compared_tags_valid(6) and (rows_step_one(0, 0) or rows_step_four(0, 0));
    if lowchain_lane_0_0_all then
      for i in 0 to 11 loop
        lowchain_lane(0, i) <= choice(rows_step_four(0, 0), lowchain_lane(0, i + 4), lowchain_lane(0, i + 1));
      end loop;
      lowchain_lane(0, 12) <= choice(rows_step_four(0, 0), rows_codes(0, 0, 0), lowchain_lane(0, 13));
      lowchain_lane(0, 13) <= choice(rows_step_four(0, 0), rows_codes(0, 0, 1), lowchain_lane(0, 14));
      lowchain_lane(0, 14) <= choice(rows_step_four(0, 0), rows_codes(0, 0, 2), lowchain_lane(0, 15));
      lowchain_lane(0, 15) <= choice(rows_step_four(0, 0), rows_codes(0, 0, 3), rows_codes(0, 0, 0));
    end if;
    lowchain_lane_1_0_choice := choice(rows_step_one(0, 1), compared_tags_valid(6), rows_step_four(0, 1) and
      compared_tags_valid(6));
    if lowchain_lane_1_0_choice then
      for i in 0 to 11 loop
        lowchain_lane(1, i) <= choice(rows_step_four(0, 1), lowchain_lane(1, i + 4), lowchain_lane(1, i + 1));
      end loop;
      lowchain_lane(1, 12) <= choice(rows_step_four(0, 1), rows_codes(0, 1, 0), lowchain_lane(1, 13));
      lowchain_lane(1, 13) <= choice(rows_step_four(0, 1), rows_codes(0, 1, 1), lowchain_lane(1, 14));
      lowchain_lane(1, 14) <= choice(rows_step_four(0, 1), rows_codes(0, 1, 2), lowchain_lane(1, 15));
      lowchain_lane(1, 15) <= choice(rows_step_four(0, 1), rows_codes(0, 1, 3), rows_codes(0, 1, 0));
    end if;
    -- lowcost
    for i in 0 to 1 loop
      lowcost_pixels_first_0_value(i, 1) := is_set(compared_held_reference(7, i), 3);
      lowcost_pixels_first_0_value(i, 2) := is_set(lowchain_lane(1 - i, 0), 3);
      lowcost_pixels_first_choice(i, 0, 1) := choice(lowcost_pixels_first_0_value(i, 1), (not
        lowcost_pixels_first_0_value(i, 2)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 2) and
        compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 3) := is_set(compared_held_reference(7, i), 5);
      lowcost_pixels_first_0_value(i, 4) := is_set(lowchain_lane(1 - i, 0), 5);
      lowcost_pixels_first_choice(i, 0, 2) := choice(lowcost_pixels_first_0_value(i, 3), (not
        lowcost_pixels_first_0_value(i, 4)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 4) and
        compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 5) := is_set(compared_held_reference(7, i), 4);
      lowcost_pixels_first_0_value(i, 6) := is_set(lowchain_lane(1 - i, 0), 4);
      lowcost_pixels_first_choice(i, 0, 3) := choice(lowcost_pixels_first_0_value(i, 5), (not
        lowcost_pixels_first_0_value(i, 6)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 6) and
        compared_held_inside(7, i));
      lowcost_pixels_first_choice(i, 0, 4) := choice(is_set(compared_held_reference(7, i), 0), (not
        is_set(lowchain_lane(1 - i, 0), 0)) or (not compared_held_inside(7, i)), is_set(lowchain_lane(1 - i, 0), 0) and
        compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 7) := is_set(compared_held_reference(7, i), 2);
      lowcost_pixels_first_0_value(i, 8) := is_set(lowchain_lane(1 - i, 0), 2);
      lowcost_pixels_first_choice(i, 0, 5) := choice(lowcost_pixels_first_0_value(i, 7), (not
        lowcost_pixels_first_0_value(i, 8)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 8) and
        compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 9) := is_set(compared_held_reference(7, i), 1);
      lowcost_pixels_first_0_value(i, 10) := is_set(lowchain_lane(1 - i, 0), 1);
      lowcost_pixels_first_choice(i, 0, 6) := choice(lowcost_pixels_first_0_value(i, 9), (not
        lowcost_pixels_first_0_value(i, 10)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 10)
        and compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 11) := is_set(compared_held_reference(7, i), 6);
      lowcost_pixels_first_0_value(i, 12) := is_set(lowchain_lane(1 - i, 0), 6);
      lowcost_pixels_first_choice(i, 0, 7) := choice(lowcost_pixels_first_0_value(i, 11), (not
        lowcost_pixels_first_0_value(i, 12)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 12)
        and compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 13) := is_set(compared_held_reference(7, i), 8);
      lowcost_pixels_first_0_value(i, 14) := is_set(lowchain_lane(1 - i, 0), 8);
      lowcost_pixels_first_choice(i, 0, 8) := choice(lowcost_pixels_first_0_value(i, 13), (not
        lowcost_pixels_first_0_value(i, 14)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 14)
        and compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 15) := is_set(compared_held_reference(7, i), 7);
      lowcost_pixels_first_0_value(i, 16) := is_set(lowchain_lane(1 - i, 0), 7);
      lowcost_pixels_first_choice(i, 0, 9) := choice(lowcost_pixels_first_0_value(i, 15), (not
        lowcost_pixels_first_0_value(i, 16)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 16)
        and compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 17) := is_set(compared_held_reference(7, i), 9);
      lowcost_pixels_first_0_value(i, 18) := is_set(lowchain_lane(1 - i, 0), 9);
      lowcost_pixels_first_choice(i, 0, 10) := choice(lowcost_pixels_first_0_value(i, 17), (not
        lowcost_pixels_first_0_value(i, 18)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 18)
        and compared_held_inside(7, i));
      lowcost_pixels_first_choice(i, 0, 11) := choice(is_set(compared_held_reference(7, i), 11), (not
        is_set(lowchain_lane(1 - i, 0), 11)) or (not compared_held_inside(7, i)), is_set(lowchain_lane(1 - i, 0), 11)
        and compared_held_inside(7, i));
      lowcost_pixels_first_0_value(i, 19) := is_set(compared_held_reference(7, i), 10);
      lowcost_pixels_first_0_value(i, 20) := is_set(lowchain_lane(1 - i, 0), 10);
      lowcost_pixels_first_choice(i, 0, 12) := choice(lowcost_pixels_first_0_value(i, 19), (not
        lowcost_pixels_first_0_value(i, 20)) or (not compared_held_inside(7, i)), lowcost_pixels_first_0_value(i, 20)
        and compared_held_inside(7, i));
      lowcost_pixels_first_1_differs(i, 1) := lowcost_pixels_first_0_value(i, 1) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 1) := choice(is_set(lowchain_lane(1 - i, 1), 3),
        lowcost_pixels_first_1_differs(i, 1), lowcost_pixels_first_0_value(i, 1));
      lowcost_pixels_first_1_differs(i, 2) := lowcost_pixels_first_0_value(i, 3) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 2) := choice(is_set(lowchain_lane(1 - i, 1), 5),
        lowcost_pixels_first_1_differs(i, 2), lowcost_pixels_first_0_value(i, 3));
      lowcost_pixels_first_1_differs(i, 3) := lowcost_pixels_first_0_value(i, 5) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 3) := choice(is_set(lowchain_lane(1 - i, 1), 4),
        lowcost_pixels_first_1_differs(i, 3), lowcost_pixels_first_0_value(i, 5));
      lowcost_pixels_first_1_differs(i, 4) := is_set(compared_held_reference(7, i), 0) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 4) := choice(is_set(lowchain_lane(1 - i, 1), 0),
        lowcost_pixels_first_1_differs(i, 4), is_set(compared_held_reference(7, i), 0));
      lowcost_pixels_first_1_differs(i, 5) := lowcost_pixels_first_0_value(i, 7) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 5) := choice(is_set(lowchain_lane(1 - i, 1), 2),
        lowcost_pixels_first_1_differs(i, 5), lowcost_pixels_first_0_value(i, 7));
      lowcost_pixels_first_1_differs(i, 6) := lowcost_pixels_first_0_value(i, 9) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 6) := choice(is_set(lowchain_lane(1 - i, 1), 1),
        lowcost_pixels_first_1_differs(i, 6), lowcost_pixels_first_0_value(i, 9));
      lowcost_pixels_first_1_differs(i, 7) := lowcost_pixels_first_0_value(i, 11) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 7) := choice(is_set(lowchain_lane(1 - i, 1), 6),
        lowcost_pixels_first_1_differs(i, 7), lowcost_pixels_first_0_value(i, 11));
      lowcost_pixels_first_1_differs(i, 8) := lowcost_pixels_first_0_value(i, 13) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 8) := choice(is_set(lowchain_lane(1 - i, 1), 8),
        lowcost_pixels_first_1_differs(i, 8), lowcost_pixels_first_0_value(i, 13));
      lowcost_pixels_first_1_differs(i, 9) := lowcost_pixels_first_0_value(i, 15) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 9) := choice(is_set(lowchain_lane(1 - i, 1), 7),
        lowcost_pixels_first_1_differs(i, 9), lowcost_pixels_first_0_value(i, 15));
      lowcost_pixels_first_1_differs(i, 10) := lowcost_pixels_first_0_value(i, 17) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 10) := choice(is_set(lowchain_lane(1 - i, 1), 9),
        lowcost_pixels_first_1_differs(i, 10), lowcost_pixels_first_0_value(i, 17));
      lowcost_pixels_first_1_differs(i, 11) := is_set(compared_held_reference(7, i), 11) /= compared_held_inside(7, i);
      lowcost_pixels_first_choice(i, 1, 11) := choice(is_set(lowchain_lane(1 - i, 1), 11),
        lowcost_pixels_first_1_differs(i, 11), is_set(compared_held_reference(7, i), 11));
      lowcost_pixels_first_1_differs(i, 12) := lowcost_pixels_first_0_value(i, 19) /= compared_held_inside(7, i);
      for j in 1 to 14 loop
        lowcost_pixels_first_choice(i, j, 12) := choice(is_set(lowchain_lane(1 - i, j), 10),
          lowcost_pixels_first_1_differs(i, 12), lowcost_pixels_first_0_value(i, 19));
        lowcost_pixels_first_choice(i, j + 1, 1) := choice(is_set(lowchain_lane(1 - i, j + 1), 3),
          lowcost_pixels_first_1_differs(i, 1), lowcost_pixels_first_0_value(i, 1));
        lowcost_pixels_first_choice(i, j + 1, 2) := choice(is_set(lowchain_lane(1 - i, j + 1), 5),
          lowcost_pixels_first_1_differs(i, 2), lowcost_pixels_first_0_value(i, 3));
        lowcost_pixels_first_choice(i, j + 1, 3) := choice(is_set(lowchain_lane(1 - i, j + 1), 4),
          lowcost_pixels_first_1_differs(i, 3), lowcost_pixels_first_0_value(i, 5));
        lowcost_pixels_first_choice(i, j + 1, 4) := choice(is_set(lowchain_lane(1 - i, j + 1), 0),
          lowcost_pixels_first_1_differs(i, 4), is_set(compared_held_reference(7, i), 0));
        lowcost_pixels_first_choice(i, j + 1, 5) := choice(is_set(lowchain_lane(1 - i, j + 1), 2),
          lowcost_pixels_first_1_differs(i, 5), lowcost_pixels_first_0_value(i, 7));
        lowcost_pixels_first_choice(i, j + 1, 6) := choice(is_set(lowchain_lane(1 - i, j + 1), 1),
          lowcost_pixels_first_1_differs(i, 6), lowcost_pixels_first_0_value(i, 9));
        lowcost_pixels_first_choice(i, j + 1, 7) := choice(is_set(lowchain_lane(1 - i, j + 1), 6),
          lowcost_pixels_first_1_differs(i, 7), lowcost_pixels_first_0_value(i, 11));
        lowcost_pixels_first_choice(i, j + 1, 8) := choice(is_set(lowchain_lane(1 - i, j + 1), 8),
          lowcost_pixels_first_1_differs(i, 8), lowcost_pixels_first_0_value(i, 13));
        lowcost_pixels_first_choice(i, j + 1, 9) := choice(is_set(lowchain_lane(1 - i, j + 1), 7),
          lowcost_pixels_first_1_differs(i, 9), lowcost_pixels_first_0_value(i, 15));
        lowcost_pixels_first_choice(i, j + 1, 10) := choice(is_set(lowchain_lane(1 - i, j + 1), 9),
          lowcost_pixels_first_1_differs(i, 10), lowcost_pixels_first_0_value(i, 17));
        lowcost_pixels_first_choice(i, j + 1, 11) := choice(is_set(lowchain_lane(1 - i, j + 1), 11),
          lowcost_pixels_first_1_differs(i, 11), is_set(compared_held_reference(7, i), 11));
      end loop;
      lowcost_pixels_first_choice(i, 15, 12) := choice(is_set(lowchain_lane(1 - i, 15), 10),
        lowcost_pixels_first_1_differs(i, 12), lowcost_pixels_first_0_value(i, 19));
    end loop;
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        lowcost_column_0_choice(4 * i + j, 1) := choice(lowcost_ready_tag.first_group, 0,
          to_integer(lowcost_ready_words(i)(8 * j + 7 downto 8 * j)));
        lowcost_column_0_choice(4 * i + j, 2) := choice(lowcost_ready_tag.border_column, 0, (lowcost_change_0(4 * i +
          j) + lowcost_column_0_choice(4 * i + j, 1)) mod 256);
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        lowcost_pixels_first(i, j) <= ((as_number(lowcost_pixels_first_choice(i, j, 1)) +
          as_number(lowcost_pixels_first_choice(i, j, 2)) + as_number(lowcost_pixels_first_choice(i, j, 3))) * 4) +
          as_number(lowcost_pixels_first_choice(i, j, 4)) + as_number(lowcost_pixels_first_choice(i, j, 5)) +
          as_number(lowcost_pixels_first_choice(i, j, 6)) + ((as_number(lowcost_pixels_first_choice(i, j, 7)) +
          as_number(lowcost_pixels_first_choice(i, j, 8)) + as_number(lowcost_pixels_first_choice(i, j, 9))) * 16) +
          ((as_number(lowcost_pixels_first_choice(i, j, 10)) + as_number(lowcost_pixels_first_choice(i, j, 11)) +
          as_number(lowcost_pixels_first_choice(i, j, 12))) * 64);
      end loop;
    end loop;
    lowcost_pixels_first_tag.valid <= compared_tags_valid(7);
    lowcost_pixels_first_tag.first_group <= compared_tags_first_group(7);
    lowcost_pixels_first_tag.border_column <= compared_tags_border_column(7);
    lowcost_pixels_first_tag.first_cost <= compared_tags_first_cost(7);
    lowcost_pixels_first_tag.leaves_window <= compared_tags_leaves_window(7);
    lowcost_pixels_first_tag.output_column <= compared_tags_output_column(7);
    lowcost_pixels_first_tag.start_of_frame <= compared_tags_start_of_frame(7);
    lowcost_pixels_first_tag.end_of_line <= compared_tags_end_of_line(7);
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        lowcost_pixels_cost(i, j) <= (((lowcost_pixels_first(i, j) mod 4) + (((lowcost_pixels_first(i, j) / 2) mod 8) /
          2) + ((((lowcost_pixels_first(i, j) / 16) mod 4) + (lowcost_pixels_first(i, j) / 64)) / 2)) * 2) +
          (((lowcost_pixels_first(i, j) / 16) + (lowcost_pixels_first(i, j) / 64)) mod 2);
      end loop;
    end loop;
    lowcost_pixels_tag <= lowcost_pixels_first_tag;
    lowcost_change_column <= lowcost_read_column;
    for i in 0 to 15 loop lowcost_change_0(i) <= lowcost_pixels_cost(1, i) - lowcost_pixels_cost(0, i); end loop;
    lowcost_ready_words <= lowcost_read_words;
    lowcost_ready_column <= lowcost_change_column;
    lowcost_ready_tag <= lowcost_pixels_tag;
    for i in 0 to 15 loop lowcost_column_0(i) <= lowcost_column_0_choice(i, 2); end loop;
    lowcost_tag.valid <= lowcost_ready_tag.valid;
    lowcost_tag.first_cost <= lowcost_ready_tag.first_cost;
    lowcost_tag.leaves_window <= lowcost_ready_tag.leaves_window;
    lowcost_tag.output_column <= lowcost_ready_tag.output_column;
    lowcost_tag.start_of_frame <= lowcost_ready_tag.start_of_frame;
    lowcost_tag.end_of_line <= lowcost_ready_tag.end_of_line;
    if compared_tags_valid(7) then
      lowcost_read_column <= choice(compared_tags_row_start(7), 0, (lowcost_read_column + 1) mod 1024);
    end if;
    if lowcost_ready_tag.valid then
      lowcost_write_column <= lowcost_ready_column;
      for i in 0 to 3 loop
        lowcost_write_words(i) <= to_unsigned(lowcost_column_0_choice(4 * i + 3, 2), 8) &
          to_unsigned(lowcost_column_0_choice(4 * i + 2, 2), 8) & to_unsigned(lowcost_column_0_choice(4 * i + 1, 2), 8)
          & to_unsigned(lowcost_column_0_choice(4 * i, 2), 8);
      end loop;
    end if;
    -- lowwindow
    if lowcost_tag.valid then
      lowwindow_ring_write_address <= lowwindow_ring_read_address;
      lowwindow_ring_read_address <= choice(lowwindow_ring_read_address = 9, 0, (lowwindow_ring_read_address + 1) mod
        16);
    end if;
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        lowwindow_change_0_choice(4 * i + j) := choice(lowwindow_entering_tag.leaves_window,
          to_integer(lowwindow_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    lowwindow_entering_0 <= lowcost_column_0;
    lowwindow_entering_tag <= lowcost_tag;
    for i in 0 to 15 loop lowwindow_change_0(i) <= lowwindow_entering_0(i) - lowwindow_change_0_choice(i); end loop;
    lowwindow_change_tag.valid <= lowwindow_entering_tag.valid;
    lowwindow_change_tag.first_cost <= lowwindow_entering_tag.first_cost;
    lowwindow_change_tag.output_column <= lowwindow_entering_tag.output_column;
    lowwindow_change_tag.start_of_frame <= lowwindow_entering_tag.start_of_frame;
    lowwindow_change_tag.end_of_line <= lowwindow_entering_tag.end_of_line;
    lowwindow_tag.valid <= lowwindow_change_tag.valid;
    lowwindow_tag.output_column <= lowwindow_centre_output_column(3);
    lowwindow_tag.start_of_frame <= lowwindow_centre_start_of_frame(3);
    lowwindow_tag.end_of_line <= lowwindow_centre_end_of_line(3);
    for i in 0 to 15 loop
      lowwindow_sum_0_choice(i) := choice(lowwindow_change_tag.first_cost, 0, lowwindow_sum_0(i));
    end loop;
    if lowwindow_change_tag.valid then
      for i in 0 to 15 loop
        lowwindow_sum_0(i) <= (lowwindow_sum_0_choice(i) + lowwindow_change_0(i)) mod 2048;
      end loop;
      lowwindow_centre_output_column(0) <= lowwindow_change_tag.output_column;
      lowwindow_centre_output_column(1 to 3) <= lowwindow_centre_output_column(0 to 2);
      lowwindow_centre_start_of_frame(0) <= lowwindow_change_tag.start_of_frame;
      lowwindow_centre_start_of_frame(1 to 3) <= lowwindow_centre_start_of_frame(0 to 2);
      lowwindow_centre_end_of_line(0) <= lowwindow_change_tag.end_of_line;
      lowwindow_centre_end_of_line(1 to 3) <= lowwindow_centre_end_of_line(0 to 2);
    end if;
    -- lowwinner1
    for i in 0 to 7 loop
      lowwinner1_best_cost_0_is_less(i) := (lowwindow_sum_0(2 * i + 1) - lowwindow_sum_0(2 * i)) < 0;
    end loop;
    lowwinner1_best_index_0_0 <= lowwinner1_best_cost_0_is_less(0);
    for i in 1 to 7 loop lowwinner1_best_first_0(i) <= lowwindow_sum_0(2 * i); end loop;
    for i in 0 to 6 loop lowwinner1_best_last_0(i) <= lowwindow_sum_0(2 * i + 1); end loop;
    lowwinner1_tag <= lowwindow_tag;
    lowwinner1_best_cost_0(0) <= choice(lowwinner1_best_cost_0_is_less(0), lowwindow_sum_0(1), lowwindow_sum_0(0));
    for i in 0 to 6 loop
      lowwinner1_best_below_0(i) <= choice(lowwinner1_best_cost_0_is_less(i), lowwindow_sum_0(2 * i), 0);
      lowwinner1_best_above_0(i) <= choice(lowwinner1_best_cost_0_is_less(i), 0, lowwindow_sum_0(2 * i + 1));
      lowwinner1_best_cost_0(i + 1) <= choice(lowwinner1_best_cost_0_is_less(i + 1), lowwindow_sum_0(2 * i + 3),
        lowwindow_sum_0(2 * i + 2));
      lowwinner1_best_index_0(i + 1) <= choice(lowwinner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    lowwinner1_best_below_0(7) <= choice(lowwinner1_best_cost_0_is_less(7), lowwindow_sum_0(14), 0);
    lowwinner1_best_above_0(7) <= choice(lowwinner1_best_cost_0_is_less(7), 0, lowwindow_sum_0(15));
    -- lowwinner2
    for i in 0 to 3 loop
      lowwinner2_best_cost_0_is_less(i) := (lowwinner1_best_cost_0(2 * i + 1) - lowwinner1_best_cost_0(2 * i)) < 0;
    end loop;
    lowwinner2_best_below_0_choice(0) := choice(lowwinner1_best_index_0(1) = 2, lowwinner1_best_last_0(0),
      lowwinner1_best_below_0(1));
    lowwinner2_best_below_0_choice(1) := choice(lowwinner1_best_index_0(3) = 6, lowwinner1_best_last_0(2),
      lowwinner1_best_below_0(3));
    lowwinner2_best_below_0_choice(2) := choice(is_set(lowwinner1_best_index_0(5), 3) and ((lowwinner1_best_index_0(5)
      mod 4) = 2), lowwinner1_best_last_0(4), lowwinner1_best_below_0(5));
    lowwinner2_best_below_0_choice(3) := choice(lowwinner1_best_index_0(7) = 14, lowwinner1_best_last_0(6),
      lowwinner1_best_below_0(7));
    lowwinner2_best_above_0_choice(0) := choice(lowwinner1_best_index_0_0, lowwinner1_best_first_0(1),
      lowwinner1_best_above_0(0));
    for i in 1 to 3 loop
      lowwinner2_best_above_0_choice(i) := choice(others_from_10(i + 9), lowwinner1_best_first_0(2 * i + 1),
        lowwinner1_best_above_0(2 * i));
    end loop;
    lowwinner2_best_first_0(1) <= lowwinner1_best_first_0(2);
    lowwinner2_best_first_0(2) <= lowwinner1_best_first_0(4);
    lowwinner2_best_first_0(3) <= lowwinner1_best_first_0(6);
    lowwinner2_best_last_0(0) <= lowwinner1_best_last_0(1);
    lowwinner2_best_last_0(1) <= lowwinner1_best_last_0(3);
    lowwinner2_best_last_0(2) <= lowwinner1_best_last_0(5);
    lowwinner2_tag <= lowwinner1_tag;
    lowwinner2_best_cost_0(0) <= choice(lowwinner2_best_cost_0_is_less(0), lowwinner1_best_cost_0(1),
      lowwinner1_best_cost_0(0));
    lowwinner2_best_index_0(0) <= choice(lowwinner2_best_cost_0_is_less(0), lowwinner1_best_index_0(1),
      as_number(lowwinner1_best_index_0_0));
    for i in 0 to 2 loop
      lowwinner2_best_below_0(i) <= choice(lowwinner2_best_cost_0_is_less(i), lowwinner2_best_below_0_choice(i),
        lowwinner1_best_below_0(2 * i));
      lowwinner2_best_above_0(i) <= choice(lowwinner2_best_cost_0_is_less(i), lowwinner1_best_above_0(2 * i + 1),
        lowwinner2_best_above_0_choice(i));
      lowwinner2_best_cost_0(i + 1) <= choice(lowwinner2_best_cost_0_is_less(i + 1), lowwinner1_best_cost_0(2 * i + 3),
        lowwinner1_best_cost_0(2 * i + 2));
      lowwinner2_best_index_0(i + 1) <= choice(lowwinner2_best_cost_0_is_less(i + 1), lowwinner1_best_index_0(2 * i +
        3), lowwinner1_best_index_0(2 * i + 2));
    end loop;
    lowwinner2_best_below_0(3) <= choice(lowwinner2_best_cost_0_is_less(3), lowwinner2_best_below_0_choice(3),
      lowwinner1_best_below_0(6));
    lowwinner2_best_above_0(3) <= choice(lowwinner2_best_cost_0_is_less(3), lowwinner1_best_above_0(7),
      lowwinner2_best_above_0_choice(3));
    -- lowwinner3
    lowwinner3_best_cost_0_is_less(0) := (lowwinner2_best_cost_0(1) - lowwinner2_best_cost_0(0)) < 0;
    lowwinner3_best_cost_0_is_less(1) := (lowwinner2_best_cost_0(3) - lowwinner2_best_cost_0(2)) < 0;
    lowwinner3_best_below_0_choice(0) := choice(lowwinner2_best_index_0(1) = 4, lowwinner2_best_last_0(0),
      lowwinner2_best_below_0(1));
    lowwinner3_best_below_0_choice(1) := choice(lowwinner2_best_index_0(3) = 12, lowwinner2_best_last_0(2),
      lowwinner2_best_below_0(3));
    lowwinner3_best_above_0_choice(0) := choice(lowwinner2_best_index_0(0) = 3, lowwinner2_best_first_0(1),
      lowwinner2_best_above_0(0));
    lowwinner3_best_above_0_choice(1) := choice(is_set(lowwinner2_best_index_0(2), 3) and ((lowwinner2_best_index_0(2)
      mod 4) = 3), lowwinner2_best_first_0(3), lowwinner2_best_above_0(2));
    lowwinner3_best_first_0_1 <= lowwinner2_best_first_0(2);
    lowwinner3_best_last_0_0 <= lowwinner2_best_last_0(1);
    lowwinner3_tag <= lowwinner2_tag;
    for i in 0 to 1 loop
      lowwinner3_best_cost_0(i) <= choice(lowwinner3_best_cost_0_is_less(i), lowwinner2_best_cost_0(2 * i + 1),
        lowwinner2_best_cost_0(2 * i));
      lowwinner3_best_index_0(i) <= choice(lowwinner3_best_cost_0_is_less(i), lowwinner2_best_index_0(2 * i + 1),
        lowwinner2_best_index_0(2 * i));
      lowwinner3_best_below_0(i) <= choice(lowwinner3_best_cost_0_is_less(i), lowwinner3_best_below_0_choice(i),
        lowwinner2_best_below_0(2 * i));
      lowwinner3_best_above_0(i) <= choice(lowwinner3_best_cost_0_is_less(i), lowwinner2_best_above_0(2 * i + 1),
        lowwinner3_best_above_0_choice(i));
    end loop;
    -- lowwinner4
    lowwinner4_best_cost_0_0_is_less := (lowwinner3_best_cost_0(1) - lowwinner3_best_cost_0(0)) < 0;
    lowwinner4_best_below_0_0_choice := choice(lowwinner3_best_index_0(1) = 8, lowwinner3_best_last_0_0,
      lowwinner3_best_below_0(1));
    lowwinner4_best_above_0_0_choice := choice(lowwinner3_best_index_0(0) = 7, lowwinner3_best_first_0_1,
      lowwinner3_best_above_0(0));
    lowwinner4_tag <= lowwinner3_tag;
    lowwinner4_best_cost_0_0 <= choice(lowwinner4_best_cost_0_0_is_less, lowwinner3_best_cost_0(1),
      lowwinner3_best_cost_0(0));
    lowwinner4_best_index_0_0 <= choice(lowwinner4_best_cost_0_0_is_less, lowwinner3_best_index_0(1),
      lowwinner3_best_index_0(0));
    lowwinner4_best_below_0_0 <= choice(lowwinner4_best_cost_0_0_is_less, lowwinner4_best_below_0_0_choice,
      lowwinner3_best_below_0(0));
    lowwinner4_best_above_0_0 <= choice(lowwinner4_best_cost_0_0_is_less, lowwinner3_best_above_0(1),
      lowwinner4_best_above_0_0_choice);
    -- highchain
    for i in 0 to 1 loop
      highchain_lane_0_choice(i) := choice(rows_step_one(1, i), compared_tags_valid(6), rows_step_four(1, i) and
        compared_tags_valid(6));
      if highchain_lane_0_choice(i) then
        for j in 0 to 11 loop
          highchain_lane(i, j) <= choice(rows_step_four(1, i), highchain_lane(i, j + 4), highchain_lane(i, j + 1));
        end loop;
        highchain_lane(i, 12) <= choice(rows_step_four(1, i), rows_codes(1, i, 0), highchain_lane(i, 13));
        highchain_lane(i, 13) <= choice(rows_step_four(1, i), rows_codes(1, i, 1), highchain_lane(i, 14));
        highchain_lane(i, 14) <= choice(rows_step_four(1, i), rows_codes(1, i, 2), highchain_lane(i, 15));
        highchain_lane(i, 15) <= choice(rows_step_four(1, i), rows_codes(1, i, 3), rows_codes(1, i, 0));
      end if;
    end loop;
    -- highcost
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        highcost_pixels_first_choice(i, j, 1) := choice(is_set(highchain_lane(1 - i, j), 3),
          lowcost_pixels_first_1_differs(i, 1), lowcost_pixels_first_0_value(i, 1));
        highcost_pixels_first_choice(i, j, 2) := choice(is_set(highchain_lane(1 - i, j), 5),
          lowcost_pixels_first_1_differs(i, 2), lowcost_pixels_first_0_value(i, 3));
        highcost_pixels_first_choice(i, j, 3) := choice(is_set(highchain_lane(1 - i, j), 4),
          lowcost_pixels_first_1_differs(i, 3), lowcost_pixels_first_0_value(i, 5));
        highcost_pixels_first_choice(i, j, 4) := choice(is_set(highchain_lane(1 - i, j), 0),
          lowcost_pixels_first_1_differs(i, 4), is_set(compared_held_reference(7, i), 0));
        highcost_pixels_first_choice(i, j, 5) := choice(is_set(highchain_lane(1 - i, j), 2),
          lowcost_pixels_first_1_differs(i, 5), lowcost_pixels_first_0_value(i, 7));
        highcost_pixels_first_choice(i, j, 6) := choice(is_set(highchain_lane(1 - i, j), 1),
          lowcost_pixels_first_1_differs(i, 6), lowcost_pixels_first_0_value(i, 9));
        highcost_pixels_first_choice(i, j, 7) := choice(is_set(highchain_lane(1 - i, j), 6),
          lowcost_pixels_first_1_differs(i, 7), lowcost_pixels_first_0_value(i, 11));
        highcost_pixels_first_choice(i, j, 8) := choice(is_set(highchain_lane(1 - i, j), 8),
          lowcost_pixels_first_1_differs(i, 8), lowcost_pixels_first_0_value(i, 13));
        highcost_pixels_first_choice(i, j, 9) := choice(is_set(highchain_lane(1 - i, j), 7),
          lowcost_pixels_first_1_differs(i, 9), lowcost_pixels_first_0_value(i, 15));
        highcost_pixels_first_choice(i, j, 10) := choice(is_set(highchain_lane(1 - i, j), 9),
          lowcost_pixels_first_1_differs(i, 10), lowcost_pixels_first_0_value(i, 17));
        highcost_pixels_first_choice(i, j, 11) := choice(is_set(highchain_lane(1 - i, j), 11),
          lowcost_pixels_first_1_differs(i, 11), is_set(compared_held_reference(7, i), 11));
        highcost_pixels_first_choice(i, j, 12) := choice(is_set(highchain_lane(1 - i, j), 10),
          lowcost_pixels_first_1_differs(i, 12), lowcost_pixels_first_0_value(i, 19));
      end loop;
    end loop;
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        highcost_column_0_choice(4 * i + j, 1) := choice(lowcost_ready_tag.first_group, 0,
          to_integer(highcost_ready_words(i)(8 * j + 7 downto 8 * j)));
        highcost_column_0_choice(4 * i + j, 2) := choice(lowcost_ready_tag.border_column, 0, (highcost_change_0(4 * i +
          j) + highcost_column_0_choice(4 * i + j, 1)) mod 256);
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        highcost_pixels_first(i, j) <= ((as_number(highcost_pixels_first_choice(i, j, 1)) +
          as_number(highcost_pixels_first_choice(i, j, 2)) + as_number(highcost_pixels_first_choice(i, j, 3))) * 4) +
          as_number(highcost_pixels_first_choice(i, j, 4)) + as_number(highcost_pixels_first_choice(i, j, 5)) +
          as_number(highcost_pixels_first_choice(i, j, 6)) + ((as_number(highcost_pixels_first_choice(i, j, 7)) +
          as_number(highcost_pixels_first_choice(i, j, 8)) + as_number(highcost_pixels_first_choice(i, j, 9))) * 16) +
          ((as_number(highcost_pixels_first_choice(i, j, 10)) + as_number(highcost_pixels_first_choice(i, j, 11)) +
          as_number(highcost_pixels_first_choice(i, j, 12))) * 64);
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        highcost_pixels_cost(i, j) <= (((highcost_pixels_first(i, j) mod 4) + (((highcost_pixels_first(i, j) / 2) mod
          8) / 2) + ((((highcost_pixels_first(i, j) / 16) mod 4) + (highcost_pixels_first(i, j) / 64)) / 2)) * 2) +
          (((highcost_pixels_first(i, j) / 16) + (highcost_pixels_first(i, j) / 64)) mod 2);
      end loop;
    end loop;
    for i in 0 to 15 loop highcost_change_0(i) <= highcost_pixels_cost(1, i) - highcost_pixels_cost(0, i); end loop;
    highcost_ready_words <= highcost_read_words;
    for i in 0 to 15 loop highcost_column_0(i) <= highcost_column_0_choice(i, 2); end loop;
    if lowcost_ready_tag.valid then
      for i in 0 to 3 loop
        highcost_write_words(i) <= to_unsigned(highcost_column_0_choice(4 * i + 3, 2), 8) &
          to_unsigned(highcost_column_0_choice(4 * i + 2, 2), 8) & to_unsigned(highcost_column_0_choice(4 * i + 1, 2),
          8) & to_unsigned(highcost_column_0_choice(4 * i, 2), 8);
      end loop;
    end if;
    -- highwindow
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        highwindow_change_0_choice(4 * i + j) := choice(lowwindow_entering_tag.leaves_window,
          to_integer(highwindow_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    highwindow_entering_0 <= highcost_column_0;
    for i in 0 to 15 loop highwindow_change_0(i) <= highwindow_entering_0(i) - highwindow_change_0_choice(i); end loop;
    for i in 0 to 15 loop
      highwindow_sum_0_choice(i) := choice(lowwindow_change_tag.first_cost, 0, highwindow_sum_0(i));
    end loop;
    if lowwindow_change_tag.valid then
      for i in 0 to 15 loop
        highwindow_sum_0(i) <= (highwindow_sum_0_choice(i) + highwindow_change_0(i)) mod 2048;
      end loop;
    end if;
    -- highwinner1
    for i in 0 to 7 loop
      highwinner1_best_cost_0_is_less(i) := (highwindow_sum_0(2 * i + 1) - highwindow_sum_0(2 * i)) < 0;
    end loop;
    highwinner1_best_index_0_0 <= highwinner1_best_cost_0_is_less(0);
    for i in 1 to 7 loop highwinner1_best_first_0(i) <= highwindow_sum_0(2 * i); end loop;
    for i in 0 to 6 loop highwinner1_best_last_0(i) <= highwindow_sum_0(2 * i + 1); end loop;
    highwinner1_best_cost_0(0) <= choice(highwinner1_best_cost_0_is_less(0), highwindow_sum_0(1), highwindow_sum_0(0));
    for i in 0 to 6 loop
      highwinner1_best_below_0(i) <= choice(highwinner1_best_cost_0_is_less(i), highwindow_sum_0(2 * i), 0);
      highwinner1_best_above_0(i) <= choice(highwinner1_best_cost_0_is_less(i), 0, highwindow_sum_0(2 * i + 1));
      highwinner1_best_cost_0(i + 1) <= choice(highwinner1_best_cost_0_is_less(i + 1), highwindow_sum_0(2 * i + 3),
        highwindow_sum_0(2 * i + 2));
      highwinner1_best_index_0(i + 1) <= choice(highwinner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    highwinner1_best_below_0(7) <= choice(highwinner1_best_cost_0_is_less(7), highwindow_sum_0(14), 0);
    highwinner1_best_above_0(7) <= choice(highwinner1_best_cost_0_is_less(7), 0, highwindow_sum_0(15));
    -- highwinner2
    for i in 0 to 3 loop
      highwinner2_best_cost_0_is_less(i) := (highwinner1_best_cost_0(2 * i + 1) - highwinner1_best_cost_0(2 * i)) < 0;
    end loop;
    highwinner2_best_below_0_choice(0) := choice(highwinner1_best_index_0(1) = 2, highwinner1_best_last_0(0),
      highwinner1_best_below_0(1));
    highwinner2_best_below_0_choice(1) := choice(highwinner1_best_index_0(3) = 6, highwinner1_best_last_0(2),
      highwinner1_best_below_0(3));
    highwinner2_best_below_0_choice(2) := choice(is_set(highwinner1_best_index_0(5), 3) and
      ((highwinner1_best_index_0(5) mod 4) = 2), highwinner1_best_last_0(4), highwinner1_best_below_0(5));
    highwinner2_best_below_0_choice(3) := choice(highwinner1_best_index_0(7) = 14, highwinner1_best_last_0(6),
      highwinner1_best_below_0(7));
    highwinner2_best_above_0_choice(0) := choice(highwinner1_best_index_0_0, highwinner1_best_first_0(1),
      highwinner1_best_above_0(0));
    highwinner2_best_above_0_choice(1) := choice(other_18, highwinner1_best_first_0(3), highwinner1_best_above_0(2));
    highwinner2_best_above_0_choice(2) := choice(others_from_21(21), highwinner1_best_first_0(5),
      highwinner1_best_above_0(4));
    highwinner2_best_above_0_choice(3) := choice(others_from_21(22), highwinner1_best_first_0(7),
      highwinner1_best_above_0(6));
    highwinner2_best_first_0(1) <= highwinner1_best_first_0(2);
    highwinner2_best_first_0(2) <= highwinner1_best_first_0(4);
    highwinner2_best_first_0(3) <= highwinner1_best_first_0(6);
    highwinner2_best_last_0(0) <= highwinner1_best_last_0(1);
    highwinner2_best_last_0(1) <= highwinner1_best_last_0(3);
    highwinner2_best_last_0(2) <= highwinner1_best_last_0(5);
    highwinner2_best_cost_0(0) <= choice(highwinner2_best_cost_0_is_less(0), highwinner1_best_cost_0(1),
      highwinner1_best_cost_0(0));
    highwinner2_best_index_0(0) <= choice(highwinner2_best_cost_0_is_less(0), highwinner1_best_index_0(1),
      as_number(highwinner1_best_index_0_0));
    for i in 0 to 2 loop
      highwinner2_best_below_0(i) <= choice(highwinner2_best_cost_0_is_less(i), highwinner2_best_below_0_choice(i),
        highwinner1_best_below_0(2 * i));
      highwinner2_best_above_0(i) <= choice(highwinner2_best_cost_0_is_less(i), highwinner1_best_above_0(2 * i + 1),
        highwinner2_best_above_0_choice(i));
      highwinner2_best_cost_0(i + 1) <= choice(highwinner2_best_cost_0_is_less(i + 1), highwinner1_best_cost_0(2 * i +
        3), highwinner1_best_cost_0(2 * i + 2));
      highwinner2_best_index_0(i + 1) <= choice(highwinner2_best_cost_0_is_less(i + 1), highwinner1_best_index_0(2 * i
        + 3), highwinner1_best_index_0(2 * i + 2));
    end loop;
    highwinner2_best_below_0(3) <= choice(highwinner2_best_cost_0_is_less(3), highwinner2_best_below_0_choice(3),
      highwinner1_best_below_0(6));
    highwinner2_best_above_0(3) <= choice(highwinner2_best_cost_0_is_less(3), highwinner1_best_above_0(7),
      highwinner2_best_above_0_choice(3));
    -- highwinner3
    highwinner3_best_cost_0_is_less(0) := (highwinner2_best_cost_0(1) - highwinner2_best_cost_0(0)) < 0;
    highwinner3_best_cost_0_is_less(1) := (highwinner2_best_cost_0(3) - highwinner2_best_cost_0(2)) < 0;
    highwinner3_best_below_0_choice(0) := choice(highwinner2_best_index_0(1) = 4, highwinner2_best_last_0(0),
      highwinner2_best_below_0(1));
    highwinner3_best_below_0_choice(1) := choice(highwinner2_best_index_0(3) = 12, highwinner2_best_last_0(2),
      highwinner2_best_below_0(3));
    highwinner3_best_above_0_choice(0) := choice(highwinner2_best_index_0(0) = 3, highwinner2_best_first_0(1),
      highwinner2_best_above_0(0));
    highwinner3_best_above_0_choice(1) := choice(is_set(highwinner2_best_index_0(2), 3) and
      ((highwinner2_best_index_0(2) mod 4) = 3), highwinner2_best_first_0(3), highwinner2_best_above_0(2));
    highwinner3_best_first_0_1 <= highwinner2_best_first_0(2);
    highwinner3_best_last_0_0 <= highwinner2_best_last_0(1);
    for i in 0 to 1 loop
      highwinner3_best_cost_0(i) <= choice(highwinner3_best_cost_0_is_less(i), highwinner2_best_cost_0(2 * i + 1),
        highwinner2_best_cost_0(2 * i));
      highwinner3_best_index_0(i) <= choice(highwinner3_best_cost_0_is_less(i), highwinner2_best_index_0(2 * i + 1),
        highwinner2_best_index_0(2 * i));
      highwinner3_best_below_0(i) <= choice(highwinner3_best_cost_0_is_less(i), highwinner3_best_below_0_choice(i),
        highwinner2_best_below_0(2 * i));
      highwinner3_best_above_0(i) <= choice(highwinner3_best_cost_0_is_less(i), highwinner2_best_above_0(2 * i + 1),
        highwinner3_best_above_0_choice(i));
    end loop;
    -- highwinner4
    highwinner4_best_cost_0_0_is_less := (highwinner3_best_cost_0(1) - highwinner3_best_cost_0(0)) < 0;
    highwinner4_best_below_0_0_choice := choice(highwinner3_best_index_0(1) = 8, highwinner3_best_last_0_0,
      highwinner3_best_below_0(1));
    highwinner4_best_above_0_0_choice := choice(highwinner3_best_index_0(0) = 7, highwinner3_best_first_0_1,
      highwinner3_best_above_0(0));
    highwinner4_best_cost_0_0 <= choice(highwinner4_best_cost_0_0_is_less, highwinner3_best_cost_0(1),
      highwinner3_best_cost_0(0));
    highwinner4_best_index_0_0 <= choice(highwinner4_best_cost_0_0_is_less, highwinner3_best_index_0(1),
      highwinner3_best_index_0(0));
    highwinner4_best_below_0_0 <= choice(highwinner4_best_cost_0_0_is_less, highwinner4_best_below_0_0_choice,
      highwinner3_best_below_0(0));
    highwinner4_best_above_0_0 <= choice(highwinner4_best_cost_0_0_is_less, highwinner3_best_above_0(1),
      highwinner4_best_above_0_0_choice);
    -- centre
    if bases_stands_valid then
      centre_held_0(1) <= bases_from_0_2;
      centre_held_0(2 to 3) <= centre_held_0(1 to 2);
      centre_held_1(0) <= bases_base(1, 2);
      centre_held_1(1 to 3) <= centre_held_1(0 to 2);
    end if;
    centre_line(0, 0) <= centre_held_0(3) mod 4096;
    for i in 1 to 16 loop centre_line(0, i) <= centre_line(0, i - 1); end loop;
    centre_line(1, 0) <= centre_held_1(3) mod 4096;
    for i in 1 to 16 loop centre_line(1, i) <= centre_line(1, i - 1); end loop;
    -- choice
    choice_best_cost_0_0_is_less := (highwinner4_best_cost_0_0 - lowwinner4_best_cost_0_0) < 0;
    choice_best_tag <= lowwinner4_tag;
    choice_best_cost_0_0 <= choice(choice_best_cost_0_0_is_less, highwinner4_best_cost_0_0, lowwinner4_best_cost_0_0);
    choice_best_index_0_0 <= choice(choice_best_cost_0_0_is_less, highwinner4_best_index_0_0,
      lowwinner4_best_index_0_0);
    choice_best_below_0_0 <= choice(choice_best_cost_0_0_is_less, highwinner4_best_below_0_0,
      lowwinner4_best_below_0_0);
    choice_best_above_0_0 <= choice(choice_best_cost_0_0_is_less, highwinner4_best_above_0_0,
      lowwinner4_best_above_0_0);
    choice_base <= choice(choice_best_cost_0_0_is_less, centre_line(1, 16), centre_line(0, 16));
    -- refinement
    refinement_remainder_1_0_difference := (refinement_remainder_0(0) + 4096) - refinement_divisor_0(0);
    for i in 2 to 7 loop
      refinement_remainder_0_difference(i) := ((refinement_remainder_0(i - 1) * 2) + 4096) - refinement_divisor_0(i -
        1);
    end loop;
    refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
    refinement_divisor_0_0_choice := choice(refinement_divisor_0_0_is_less, refinement_v_0, refinement_u_0);
    refinement_fraction_0_difference := 0 - (refinement_quotient_8_0 / 16);
    refinement_fraction_0_value := (refinement_quotient_8_0 + 15) / 16;
    refinement_fraction_0_choice := choice(refinement_negative_0(8), refinement_fraction_0_difference mod 256,
      refinement_fraction_0_value);
    refinement_fraction_0_choice_2 := choice(refinement_negative_0(8), refinement_fraction_0_difference mod 8,
      refinement_fraction_0_value mod 8);
    refinement_disparity_0(0) <= choice_best_index_0_0;
    refinement_disparity_0(1 to 11) <= refinement_disparity_0(0 to 10);
    refinement_passed_0(0) <= true;
    refinement_passed_0(1 to 2) <= refinement_passed_0(0 to 1);
    refinement_passed_0s(6) <= targets_wish_walk_has_below;
    refinement_passed_0s(7 to 11) <= refinement_passed_0s(6 to 10);
    refinement_tag_valid(0) <= choice_best_tag.valid;
    refinement_tag_output_column(0) <= choice_best_tag.output_column;
    refinement_tag_start_of_frame(0) <= choice_best_tag.start_of_frame;
    refinement_tag_end_of_line(0) <= choice_best_tag.end_of_line;
    for i in 1 to 11 loop
      refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
      refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
      refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
      refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
    end loop;
    refinement_cost_0 <= choice_best_cost_0_0;
    refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 2048;
    refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 2048;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 11)) or
      (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 11))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((4096 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 2048) +
      ((other_13 / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
    refinement_below_0 <= choice(choice_best_index_0_0 = 0, choice_best_above_0_0, choice_best_below_0_0);
    refinement_above_0 <= choice(choice_best_index_0_0 = 15, choice_best_below_0_0, choice_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 12),
      refinement_remainder_1_0_difference mod 2048, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 12),
        refinement_remainder_0_difference(i) mod 2048, (refinement_remainder_0(i - 1) mod 1024) * 2);
    end loop;
    -- base
    base(1) <= choice_base;
    base(2 to 12) <= base(1 to 11);
    -- map
    map_disparity_0 <= ((((((base(12) + refinement_disparity_0(11) + (refinement_fraction_0 / 16)) mod 4096) * 2) +
      ((refinement_fraction_0 mod 16) / 8) + 8191) mod 8192) * 8) + (refinement_fraction_0 mod 8);
    map_passed_0 <= refinement_passed_0s(11);
    map_valid <= refinement_tag_valid(11) and refinement_tag_output_column(11);
    map_start_of_frame <= refinement_tag_start_of_frame(11) and refinement_tag_valid(11) and
      refinement_tag_output_column(11);
    map_end_of_line <= refinement_tag_end_of_line(11) and refinement_tag_valid(11) and refinement_tag_output_column(11);
    -- other
    other_29_choice := choice(coarsetransform_centre_group_any, 127, 95);
    other_0 <= (((transform_right_code_next_row_outer(0) / 2) - transform_right_code_next_row_centre(0)) mod 32768) * 2;
    other(1) <= as_number(((transform_right_code_row_before(0) - transform_right_code_row_after(0)) < 0)) * 8192;
    other(2) <= as_number((((other_3 / 2) - transform_right_code_row_centre(0)) < 0)) * 8192;
    other_3 <= ((transform_right_code_row_box_0(0) + transform_right_code_row_column(0, 3)) / 2) * 2;
    other_4 <= (((transform_left_code_next_row_outer(0) / 2) - transform_left_code_next_row_centre(0)) mod 32768) * 2;
    others_from_5(5) <= as_number(((transform_left_code_row_before(0) - transform_left_code_row_after(0)) < 0)) * 8192;
    others_from_5(6) <= as_number((((other_7 / 2) - transform_left_code_row_centre(0)) < 0)) * 8192;
    other_7 <= ((transform_left_code_row_box_0(0) + transform_left_code_row_column(0, 3)) / 2) * 2;
    others_from_8(8) <= others_from_8(9);
    others_from_8(9) <= (as_number(transform_valid) * 256) + as_number(((transform_counter_column = 4) and
      (transform_counter_group = 4)));
    others_from_10(10) <= lowwinner1_best_cost_0_is_less(2);
    others_from_10(11) <= lowwinner1_best_cost_0_is_less(4);
    others_from_10(12) <= lowwinner1_best_cost_0_is_less(6);
    other_13 <= ((refinement_remainder_0_difference(7) / 4096) * 2) + ((other_14 / 4) * 4);
    other_14 <= ((refinement_remainder_0_difference(6) / 4096) * 4) + ((other_15 / 8) * 8);
    other_15 <= ((refinement_remainder_0_difference(5) / 4096) * 8) + ((other_16 / 16) * 16);
    other_16 <= ((refinement_remainder_0_difference(4) / 4096) * 16) + ((other_17 / 32) * 32);
    other_17 <= ((refinement_remainder_0_difference(3) / 4096) * 32) + ((other_19 / 64) * 64);
    other_18 <= highwinner1_best_cost_0_is_less(2);
    other_19 <= ((refinement_remainder_0_difference(2) / 4096) * 64) + ((other_20 / 128) * 128);
    other_20 <= (refinement_remainder_1_0_difference / 4096) * 128;
    others_from_21(21) <= highwinner1_best_cost_0_is_less(4);
    others_from_21(22) <= highwinner1_best_cost_0_is_less(6);
    others_from_23(23) <= as_number(((coarsetransform_right_code_row_before(0) -
      coarsetransform_right_code_row_after(0)) < 0)) * 8192;
    others_from_23(24) <= as_number((((other_25 / 2) - coarsetransform_right_code_row_centre(0)) < 0)) * 8192;
    other_25 <= ((coarsetransform_right_code_column_response(0) + coarsetransform_right_code_row_column(0, 3)) / 2) * 2;
    others_from_26(26) <= as_number(((coarsetransform_left_code_row_before(0) - coarsetransform_left_code_row_after(0))
      < 0)) * 8192;
    others_from_26(27) <= as_number((((other_28 / 2) - coarsetransform_left_code_row_centre(0)) < 0)) * 8192;
    other_28 <= ((coarsetransform_left_code_column_response(0) + coarsetransform_left_code_row_column(0, 3)) / 2) * 2;
    other_29 <= ((other_29_choice + (coarsetransform_counter_column / 2)) mod 128) * 2;
    others_from_30(30) <= others_from_30(31);
    others_from_30(31) <= (as_number(coarsetransform_valid) * 256) + as_number(((coarsetransform_counter_group = 2) and
      (coarsetransform_counter_column = 2)));
    if reset = '1' then
      coarse_pixels_left <= 0; coarse_pixels_right <= 0; coarse_pixels_valid <= false; coarse_pixels_column <= 0;
      coarse_pixels_part <= 0; coarse_pixels_row <= 0; coarse_pixels_first_row <= false; coarse_pixels_left_sum <= 0;
      coarse_pixels_right_sum <= 0; coarse_pixels_sum_ends <= false; coarse_pixels_sum_is_first <= false;
      coarse_pixels_sum_is_last <= false; coarse_pixels_sum_starts <= false; coarse_pixels_sum_column <= 0;
      coarse_pixels_left_read <= 0; coarse_pixels_right_read <= 0; coarse_pixels_read_column <= 0;
      coarse_pixels_read_ends <= false; coarse_pixels_read_is_first <= false; coarse_pixels_read_is_last <= false;
      coarse_pixels_read_starts <= false; coarse_pixels_total <= 0; coarse_pixels_total_ends <= false;
      coarse_pixels_total_is_last <= false; coarse_pixels_total_starts <= false; coarse_pixels_total_column <= 0;
      coarse_pixels_repetition <= 32; coarse_pixels_out_left <= 0; coarse_pixels_out_right <= 0;
      coarse_pixels_out_start <= false; coarse_pixels_out_valid <= false; coarsetransform_left_0 <= 0;
      coarsetransform_right_0 <= 0; coarsetransform_valid <= false; coarsetransform_counter_column <= 0;
      coarsetransform_counter_group <= 122; coarsetransform_counter_next_frame <= false;
      coarsetransform_left_rows_read_newest_0 <= 0; coarsetransform_left_rows_ready_words_0 <= to_unsigned(0, 32);
      coarsetransform_left_rows_ready_newest_0 <= 0; coarsetransform_left_rows_write_words_0 <= to_unsigned(0, 32);
      coarsetransform_right_rows_read_newest_0 <= 0; coarsetransform_right_rows_ready_words_0 <= to_unsigned(0, 32);
      coarsetransform_right_rows_ready_newest_0 <= 0; coarsetransform_right_rows_write_words_0 <= to_unsigned(0, 32);
      coarsetransform_read_column <= 0; coarsetransform_ready_column <= 0; coarsetransform_write_column <= 0;
      coarsetransform_centre_group <= 0; coarsetransform_from_first_0 <= false; coarsetransform_up_to_last_0 <= false;
      coarsetransform_left_column <= (others => 0); coarsetransform_right_column <= (others => 0);
      coarsetransform_columns_inside_0 <= false; coarsetransform_columns_start_of_frame <= false;
      coarsetransform_columns_valid <= false; coarsetransform_left_code_column_centre <= 0;
      coarsetransform_left_code_column_near <= 0; coarsetransform_left_code_column_outer <= 0;
      coarsetransform_left_code_column_upper <= 0; coarsetransform_left_code_column_lower <= 0;
      coarsetransform_left_code_column_response <= (others => 0); coarsetransform_left_code_column_response_2 <= 0;
      coarsetransform_left_code_row_column <= (others => (others => 0));
      coarsetransform_left_code_row_column_2 <= (others => 0); coarsetransform_left_code_row_centre <= (others => 0);
      coarsetransform_left_code_row_outer_1 <= 0; coarsetransform_left_code_row_outer_2 <= 0;
      coarsetransform_left_code_row_before <= (others => 0); coarsetransform_left_code_row_before_2 <= 0;
      coarsetransform_left_code_row_after <= (others => 0); coarsetransform_left_code_row_after_2 <= 0;
      coarsetransform_left_code_row_even <= (others => 0); coarsetransform_left_code_row_odd <= (others => 0);
      coarsetransform_left_code_row_signs <= 0; coarsetransform_left_code_bits <= 0;
      coarsetransform_right_code_column_centre <= 0; coarsetransform_right_code_column_near <= 0;
      coarsetransform_right_code_column_outer <= 0; coarsetransform_right_code_column_upper <= 0;
      coarsetransform_right_code_column_lower <= 0; coarsetransform_right_code_column_response <= (others => 0);
      coarsetransform_right_code_column_response_2 <= 0;
      coarsetransform_right_code_row_column <= (others => (others => 0));
      coarsetransform_right_code_row_column_2 <= (others => 0); coarsetransform_right_code_row_centre <= (others => 0);
      coarsetransform_right_code_row_outer_1 <= 0; coarsetransform_right_code_row_outer_2 <= 0;
      coarsetransform_right_code_row_before <= (others => 0); coarsetransform_right_code_row_before_2 <= 0;
      coarsetransform_right_code_row_after <= (others => 0); coarsetransform_right_code_row_after_2 <= 0;
      coarsetransform_right_code_row_even <= (others => 0); coarsetransform_right_code_row_odd <= (others => 0);
      coarsetransform_right_code_row_signs <= 0; coarsetransform_right_code_bits <= 0;
      for i in 0 to 4 loop
        coarsetransform_filtering_inside_0(i) <= false; coarsetransform_filtering_start_of_frame(i) <= false;
        coarsetransform_filtering_valid(i) <= false;
      end loop;
      coarsetransform_filtering_start_of_frame(5) <= false; coarsetransform_filtering_valid(5) <= false;
      coarseraster_features_search_0 <= 0; coarseraster_features_reference_0 <= 0; coarseraster_features_valid <= false;
      coarseraster_place_column <= 0; coarseraster_place_group <= 123; coarseraster_place_next_frame <= false;
      coarsedelay_ring_read_address <= 1; coarsedelay_ring_write_address <= 0; coarsedelay_ahead_0 <= 0;
      coarsedelay_column <= 0; coarsedelay_row_inside <= (others => false); coarsedelay_tag.valid <= false;
      coarsedelay_tag.border_column <= false; coarsedelay_tag.first_cost <= false;
      coarsedelay_tag.output_column <= false; coarsedelay_tag.start_of_frame <= false;
      coarserows_search_rows_read_newest_0 <= 0; coarserows_search_rows_ready_words_0 <= 0;
      coarserows_search_rows_ready_words_1 <= 0; coarserows_search_rows_ready_newest_0 <= 0;
      coarserows_search_rows_write_words <= (others => 0); coarserows_reference_rows_read_newest_0 <= 0;
      coarserows_reference_rows_ready_words_0 <= 0; coarserows_reference_rows_ready_words_1 <= 0;
      coarserows_reference_rows_ready_newest_0 <= 0; coarserows_reference_rows_write_words <= (others => 0);
      coarserows_read_column <= 0; coarserows_read_inside <= (others => false); coarserows_read_tag.valid <= false;
      coarserows_read_tag.border_column <= false; coarserows_read_tag.first_cost <= false;
      coarserows_read_tag.output_column <= false; coarserows_read_tag.start_of_frame <= false;
      coarserows_ready_column <= 0; coarserows_ready_inside <= (others => false); coarserows_ready_tag.valid <= false;
      coarserows_ready_tag.border_column <= false; coarserows_ready_tag.first_cost <= false;
      coarserows_ready_tag.output_column <= false; coarserows_ready_tag.start_of_frame <= false;
      coarserows_write_column <= 0; coarserows_search <= (others => 0); coarserows_reference <= (others => 0);
      coarserows_tag.valid <= false; coarserows_tag.border_column <= false; coarserows_tag.first_cost <= false;
      coarserows_tag.output_column <= false; coarserows_tag.start_of_frame <= false;
      coarseslice0shift_search <= (others => (others => 0)); coarseslice0shift_reference <= (others => 0);
      coarseslice0shift_search_out <= (others => 0); coarseslice0shift_tag.valid <= false;
      coarseslice0shift_tag.border_column <= false; coarseslice0shift_tag.first_cost <= false;
      coarseslice0shift_tag.output_column <= false; coarseslice0shift_tag.start_of_frame <= false;
      coarseslice0cost_pixels_first <= (others => (others => 0)); coarseslice0cost_pixels_first_tag.valid <= false;
      coarseslice0cost_pixels_first_tag.border_column <= false; coarseslice0cost_pixels_first_tag.first_cost <= false;
      coarseslice0cost_pixels_first_tag.output_column <= false;
      coarseslice0cost_pixels_first_tag.start_of_frame <= false;
      coarseslice0cost_pixels_cost <= (others => (others => 0)); coarseslice0cost_pixels_tag.valid <= false;
      coarseslice0cost_pixels_tag.border_column <= false; coarseslice0cost_pixels_tag.first_cost <= false;
      coarseslice0cost_pixels_tag.output_column <= false; coarseslice0cost_pixels_tag.start_of_frame <= false;
      coarseslice0cost_pair <= (others => (others => 0)); coarseslice0cost_single_0 <= (others => 0);
      coarseslice0cost_pair_tag.valid <= false; coarseslice0cost_pair_tag.border_column <= false;
      coarseslice0cost_pair_tag.first_cost <= false; coarseslice0cost_pair_tag.output_column <= false;
      coarseslice0cost_pair_tag.start_of_frame <= false; coarseslice0cost_column_0 <= (others => 0);
      coarseslice0cost_tag.valid <= false; coarseslice0cost_tag.border_column <= false;
      coarseslice0cost_tag.first_cost <= false; coarseslice0cost_tag.output_column <= false;
      coarseslice0cost_tag.start_of_frame <= false; coarseslice0window_partial_0_0 <= (others => 0);
      coarseslice0window_partial_0_1 <= (others => 0); coarseslice0window_partial_0_2 <= (others => 0);
      coarseslice0window_partial_0_3 <= (others => 0); coarseslice0window_partial_0_4 <= (others => 0);
      coarseslice0window_partial_0_5 <= (others => 0); coarseslice0window_centre_output_column <= (others => false);
      coarseslice0window_centre_first_column <= (others => false); coarseslice0window_centre_start_of_frame_0 <= false;
      coarseslice0window_sum_0 <= (others => 0); coarseslice0window_tag.valid <= false;
      coarseslice0window_tag.output_column <= false; coarseslice0window_tag.first_column <= false;
      coarseslice0window_tag.start_of_frame <= false; coarseslice0other_cost_0 <= (others => 0);
      coarseslice0other_winner_0 <= (others => 0); coarseslice0other_cost_out_0 <= 0;
      coarseslice0other_winner_out_0 <= 0; coarseslice0winner1_best_cost_0 <= (others => 0);
      coarseslice0winner1_best_index_0_0 <= false; coarseslice0winner1_best_index_0 <= (others => 0);
      coarseslice0winner1_tag.valid <= false; coarseslice0winner1_tag.output_column <= false;
      coarseslice0winner1_tag.first_column <= false; coarseslice0winner1_tag.start_of_frame <= false;
      coarseslice0winner2_best_cost_0 <= (others => 0); coarseslice0winner2_best_index_0 <= (others => 0);
      coarseslice0winner2_tag.valid <= false; coarseslice0winner2_tag.output_column <= false;
      coarseslice0winner2_tag.start_of_frame <= false; coarseslice0winner3_best_cost_0 <= (others => 0);
      coarseslice0winner3_best_index_0 <= (others => 0); coarseslice0winner3_tag.valid <= false;
      coarseslice0winner3_tag.output_column <= false; coarseslice0winner3_tag.start_of_frame <= false;
      coarseslice0winner4_best_cost_0 <= (others => 0); coarseslice0winner4_best_index_0 <= (others => 0);
      coarseslice0winner4_tag.valid <= false; coarseslice0winner4_tag.output_column <= false;
      coarseslice0winner4_tag.start_of_frame <= false; coarseslice0winner5_best_cost_0_0 <= 0;
      coarseslice0winner5_best_index_0_0 <= 0; coarseslice0winner5_tag.valid <= false;
      coarseslice0winner5_tag.output_column <= false; coarseslice0winner5_tag.start_of_frame <= false;
      coarseslice0_best_cost_0_0 <= 0; coarseslice0_best_index_0_0 <= 0; coarseslice0_best_tag.valid <= false;
      coarseslice0_best_tag.output_column <= false; coarseslice0_best_tag.start_of_frame <= false;
      coarseslice1shift_search <= (others => (others => 0)); coarseslice1shift_reference <= (others => 0);
      coarseslice1cost_pixels_first <= (others => (others => 0));
      coarseslice1cost_pixels_cost <= (others => (others => 0)); coarseslice1cost_pair <= (others => (others => 0));
      coarseslice1cost_single_0 <= (others => 0); coarseslice1cost_column_0 <= (others => 0);
      coarseslice1cost_tag <= (others => false); coarseslice1window_partial_0_0 <= (others => 0);
      coarseslice1window_partial_0_1 <= (others => 0); coarseslice1window_partial_0_2 <= (others => 0);
      coarseslice1window_partial_0_3 <= (others => 0); coarseslice1window_partial_0_4 <= (others => 0);
      coarseslice1window_partial_0_5 <= (others => 0); coarseslice1window_centre_output_column <= (others => false);
      coarseslice1window_centre_first_column <= (others => false);
      coarseslice1window_centre_start_of_frame <= (others => false); coarseslice1window_sum_0 <= (others => 0);
      coarseslice1other_cost_0 <= (others => 0); coarseslice1other_winner_0 <= (others => 0);
      coarseslice1other_winner_out_0 <= 0; coarseslice1winner1_best_cost_0 <= (others => 0);
      coarseslice1winner1_best_index_0_0 <= false; coarseslice1winner1_best_index_0 <= (others => 0);
      coarseslice1winner2_best_cost_0 <= (others => 0); coarseslice1winner2_best_index_0 <= (others => 0);
      coarseslice1winner3_best_cost_0_0 <= 0; coarseslice1winner3_best_index_0_0 <= 0;
      coarseslice1winner4_best_cost_0_0 <= 0; coarseslice1winner4_best_index_0_0 <= 0;
      coarseslice1winner5_best_cost_0_0 <= 0; coarseslice1winner5_best_index_0_0 <= 0; coarseslice1_best_index_0_0 <= 0;
      coarseslice1_best_tag.valid <= false; coarseslice1_best_tag.output_column <= false;
      coarseslice1_best_tag.start_of_frame <= false; coarseleftright_other_0 <= (others => 0);
      coarseleftright_ring_read_address <= 1; coarseleftright_ring_write_address <= 0;
      coarseleftright_holds_winners <= false; coarseleftright_position <= 0; coarseleftright_held_position <= 0;
      coarseleftright_held_valid <= false; coarseleftright_address_0 <= 0; coarseleftright_asking_disparity_0 <= 0;
      coarseleftright_asking_passed_0 <= true; coarseleftright_asking_tag <= (others => false);
      coarseleftright_answered_disparity_0 <= 0; coarseleftright_answered_passed_0 <= true;
      coarseleftright_answered_tag <= (others => false); coarseleftright_checked_disparity_0 <= 0;
      coarseleftright_checked_passed_0 <= true; coarseleftright_checked_tag <= (others => false); ranges_column <= 0;
      ranges_row <= 121; ranges_pixel_0 <= 0; ranges_in_column <= 0; ranges_in_row <= 0; ranges_in_valid <= false;
      ranges_pixels_read_newest_0 <= 0; ranges_pixels_ready_words_0 <= 0; ranges_pixels_ready_newest_0 <= 0;
      ranges_pixels_write_words_0 <= 0; ranges_read_column <= 0; ranges_read_row <= 0; ranges_read_valid <= false;
      ranges_ready_column <= 0; ranges_ready_row <= 0; ranges_ready_valid <= false; ranges_pixels_written <= 0;
      ranges_left <= 0; ranges_above <= 0; ranges_middle <= 0; ranges_below <= 0; ranges_next_above <= 0;
      ranges_right <= 0; ranges_next_below <= 0; ranges_centre_column <= 0; ranges_centre_row <= 0;
      ranges_centre_valid <= false; ranges_counts <= false; ranges_disparity <= 0; ranges_counted_column <= 0;
      ranges_counted_row <= 0; ranges_counted_valid <= false; ranges_first_of_pair <= 0; ranges_pair_0 <= 0;
      ranges_paired_column <= 0; ranges_paired_row <= 0; ranges_paired_valid <= false; ranges_pairs_read_newest_0 <= 0;
      ranges_pairs_ready_words_0 <= 0; ranges_pairs_ready_newest_0 <= 0; ranges_pairs_write_words_0 <= 0;
      ranges_pair_read_column <= 0; ranges_pair_read_row <= 0; ranges_pair_read_valid <= false;
      ranges_pair_ready_column <= 0; ranges_pair_ready_row <= 0; ranges_pair_ready_valid <= false;
      ranges_pairs_written <= 0; ranges_range <= 0; ranges_block_column <= 0; ranges_block_row <= 0;
      ranges_valid <= false; targets_newest_0 <= 0; targets_read_column <= 0; targets_comes <= false;
      targets_pause <= 6; targets_walked <= 81; targets_walk_place <= 0; targets_next_band <= 0;
      targets_last_row <= false; targets_again <= false; targets_walk_column <= 0; targets_walk_band <= 0;
      targets_walk_has_above <= false; targets_walk_has_below <= false; targets_walk_valid <= false;
      targets_rows_read_newest_0 <= 0; targets_rows_ready_words_0 <= 0; targets_rows_ready_words_1 <= 0;
      targets_rows_ready_newest_0 <= 0; targets_rows_write_words <= (others => 0); targets_read_comes <= false;
      targets_ready_comes <= false; targets_read_place <= 0; targets_ready_place <= 0; targets_write_column <= 0;
      targets_read_walk_column <= 0; targets_read_walk_band <= 0; targets_read_walk_has_above <= false;
      targets_read_walk_has_below <= false; targets_read_walk_valid <= false; targets_ready_walk_column <= 0;
      targets_ready_walk_band <= 0; targets_ready_walk_has_above <= false; targets_ready_walk_has_below <= false;
      targets_ready_walk_valid <= false; targets_column_range <= 0; targets_column_walk_column <= 0;
      targets_column_walk_band <= 0; targets_column_walk_valid <= false; targets_behind <= 0; targets_here <= 0;
      targets_around <= 0; targets_around_walk_column <= 0; targets_around_walk_band <= 0;
      targets_around_walk_valid <= false; targets_low_wish <= 0; targets_high_wish <= 0; targets_known <= false;
      targets_wish_walk_column <= 0; targets_wish_walk_band <= 0; targets_wish_walk_valid <= false; targets_low <= 0;
      targets_high <= 0; targets_place <= 0; hold_back_ring_read_address <= 1; hold_back_ring_write_address <= 0;
      hold_back_holds_groups <= false; hold_back_held_is_new <= false; hold_back_next_ring_read_address <= 1;
      hold_back_next_ring_write_address <= 0; hold_back_next_holds_groups <= false; hold_back_next_held_is_new <= false;
      hold_back_next_held_valid <= false; hold_back_next_next_ring_read_address <= 1;
      hold_back_next_next_ring_write_address <= 0; hold_back_next_next_holds_groups <= false;
      hold_back_next_next_held_is_new <= false; hold_back_next_next_held_valid <= false;
      hold_back_next_next_next_ring_read_address <= 1; hold_back_next_next_next_ring_write_address <= 0;
      hold_back_next_next_next_holds_groups <= false; hold_back_next_next_next_held_is_new <= false;
      hold_back_next_next_next_held_valid <= false; hold_back_next_next_next_next_ring_read_address <= 1;
      hold_back_next_next_next_next_ring_write_address <= 0; hold_back_next_next_next_next_holds_groups <= false;
      hold_back_next_next_next_next_held_is_new <= false; hold_back_next_next_next_next_held_valid <= false;
      hold_back_next_next_next_next_next_ring_read_address <= 1;
      hold_back_next_next_next_next_next_ring_write_address <= 0;
      hold_back_next_next_next_next_next_holds_groups <= false; hold_back_next_next_next_next_next_held_is_new <= false;
      hold_back_next_next_next_next_next_held_valid <= false;
      hold_back_next_next_next_next_next_next_ring_read_address <= 1;
      hold_back_next_next_next_next_next_next_ring_write_address <= 0;
      hold_back_next_next_next_next_next_next_holds_groups <= false;
      hold_back_next_next_next_next_next_next_held_is_new <= false;
      hold_back_next_next_next_next_next_next_held_valid <= false;
      hold_back_next_next_next_next_next_next_next_ring_read_address <= 1;
      hold_back_next_next_next_next_next_next_next_ring_write_address <= 0;
      hold_back_next_next_next_next_next_next_next_holds_groups <= false;
      hold_back_next_next_next_next_next_next_next_held_is_new <= false;
      hold_back_next_next_next_next_next_next_next_held_valid <= false;
      hold_back_next_next_next_next_next_next_next_next_ring_read_address <= 1;
      hold_back_next_next_next_next_next_next_next_next_ring_write_address <= 0;
      hold_back_next_next_next_next_next_next_next_next_holds_groups <= false;
      hold_back_next_next_next_next_next_next_next_next_held_is_new <= false;
      hold_back_next_next_next_next_next_next_next_next_held_valid <= false; transform_valid <= false;
      transform_counter_column <= 0; transform_counter_group <= 484; transform_counter_next_frame <= false;
      transform_columns_start_of_frame <= false; transform_columns_valid <= false;
      for i in 0 to 7 loop
        transform_filtering_start_of_frame(i) <= false; transform_filtering_valid(i) <= false;
      end loop;
      ahead_ring_read_address <= 1; ahead_ring_write_address <= 0; ahead_holds_groups <= false;
      ahead_held_is_new <= false; ahead_held_valid <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 484; bases_address(0 to 1) <= (others => 0); bases_asked_limit <= 0;
      bases_asked_head <= false; bases_asked_valid <= false; bases_read_limit <= 0; bases_read_head <= false;
      bases_read_valid <= false; bases_ready_targets(0 to 1) <= (others => 0); bases_ready_limit <= 0;
      bases_ready_head <= false; bases_ready_valid <= false; bases_goal(0, 0) <= 0; bases_goal(0, 1) <= 0;
      bases_goal(1, 0) <= 0; bases_goal(1, 1) <= 0; bases_wanted_head <= false; bases_wanted_valid <= false;
      bases_base(0, 0) <= 0; bases_base(0, 1) <= 0; bases_base(1, 0) <= 0; bases_base(1, 1) <= 0;
      bases_rises <= (others => (others => false)); bases_falls <= (others => (others => false));
      bases_stands_valid <= false; rows_newest_column <= 0; rows_wanted_one <= (others => (others => false));
      rows_wanted_four <= (others => (others => false)); rows_asked_one <= (others => (others => false));
      rows_asked_four <= (others => (others => false)); rows_read_one <= (others => (others => false));
      rows_read_four <= (others => (others => false)); rows_ready_one <= (others => (others => false));
      rows_ready_four <= (others => (others => false)); rows_step_one <= (others => (others => false));
      rows_step_four <= (others => (others => false)); pairs_tag.output_column <= false;
      pairs_tag.start_of_frame <= false; pairs_tag.end_of_line <= false; compared_read_tag.output_column <= false;
      compared_read_tag.start_of_frame <= false; compared_read_tag.end_of_line <= false;
      compared_ready_tag.output_column <= false; compared_ready_tag.start_of_frame <= false;
      compared_ready_tag.end_of_line <= false; compared_tags_output_column(0) <= false;
      compared_tags_start_of_frame(0) <= false; compared_tags_end_of_line(0) <= false;
      for i in 1 to 6 loop
        compared_tags_output_column(i) <= false; compared_tags_start_of_frame(i) <= false;
        compared_tags_end_of_line(i) <= false; compared_tags_valid(i + 1) <= false;
      end loop;
      compared_tags_output_column(7) <= false; compared_tags_start_of_frame(7) <= false;
      compared_tags_end_of_line(7) <= false; lowcost_pixels_first_tag.valid <= false;
      lowcost_pixels_first_tag.output_column <= false; lowcost_pixels_first_tag.start_of_frame <= false;
      lowcost_pixels_first_tag.end_of_line <= false; lowcost_pixels_tag.valid <= false;
      lowcost_pixels_tag.output_column <= false; lowcost_pixels_tag.start_of_frame <= false;
      lowcost_pixels_tag.end_of_line <= false; lowcost_ready_tag.valid <= false;
      lowcost_ready_tag.output_column <= false; lowcost_ready_tag.start_of_frame <= false;
      lowcost_ready_tag.end_of_line <= false; lowcost_tag.valid <= false; lowcost_tag.output_column <= false;
      lowcost_tag.start_of_frame <= false; lowcost_tag.end_of_line <= false; lowwindow_entering_tag.valid <= false;
      lowwindow_entering_tag.output_column <= false; lowwindow_entering_tag.start_of_frame <= false;
      lowwindow_entering_tag.end_of_line <= false; lowwindow_change_tag.valid <= false;
      lowwindow_change_tag.output_column <= false; lowwindow_change_tag.start_of_frame <= false;
      lowwindow_change_tag.end_of_line <= false; lowwindow_centre_output_column <= (others => false);
      lowwindow_centre_start_of_frame <= (others => false); lowwindow_centre_end_of_line <= (others => false);
      lowwindow_tag <= (others => false); lowwinner1_tag <= (others => false); lowwinner2_tag <= (others => false);
      lowwinner3_tag <= (others => false); lowwinner4_tag <= (others => false); choice_best_tag <= (others => false);
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_output_column(i) <= false;
        refinement_tag_start_of_frame(i) <= false; refinement_tag_end_of_line(i) <= false;
      end loop;
      map_valid <= false; map_start_of_frame <= false; map_end_of_line <= false; others_from_8 <= (others => 0);
      others_from_23 <= (others => 0); other_25 <= 0; others_from_26 <= (others => 0); other_28 <= 0; other_29 <= 0;
      others_from_30 <= (others => 0);
    end if;
  end process;
end architecture;
