-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, phase correlation, configuration parts_320: 320x240, 24 disparities, window 9x9, phase of 2 scales, 1 pixel pair a clock.
-- Options: disparities 24, subpixel true, aggregation recursive, slice_disparities 12.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config parts_320
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_parts_320 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 240;
    disparities : positive := 24;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 296;
    latency_clocks : positive := 44;
    flush_groups : positive := 2567;
    gap_groups : positive := 1280
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
  assert width_px = 320 report "stereo_core_parts_320: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 240 report "stereo_core_parts_320: height_px is " & integer'image(height_px) & " but this core has 240" severity failure;
  assert disparities = 24 report "stereo_core_parts_320: disparities is " & integer'image(disparities) & " but this core has 24" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_parts_320: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_parts_320: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 296 report "stereo_core_parts_320: output_width_px is " & integer'image(output_width_px) & " but this core has 296" severity failure;
  assert latency_clocks = 44 report "stereo_core_parts_320: latency_clocks is " & integer'image(latency_clocks) & " but this core has 44" severity failure;
  assert flush_groups = 2567 report "stereo_core_parts_320: flush_groups is " & integer'image(flush_groups) & " but this core has 2567" severity failure;
  assert gap_groups = 1280 report "stereo_core_parts_320: gap_groups is " & integer'image(gap_groups) & " but this core has 1280" severity failure;
end entity;

architecture rtl of stereo_core_parts_320 is
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
  type integer_minus_19_to_19_1d is array (natural range <>) of integer range -19 to 19;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type natural_1021_1d is array (natural range <>) of natural range 0 to 1021;
  type natural_1021_2d is array (natural range <>, natural range <>) of natural range 0 to 1021;
  type natural_11_1d is array (natural range <>) of natural range 0 to 11;
  type natural_12247_1d is array (natural range <>) of natural range 0 to 12247;
  type natural_1530_1d is array (natural range <>) of natural range 0 to 1530;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_19_2d is array (natural range <>, natural range <>) of natural range 0 to 19;
  type natural_2041_1d is array (natural range <>) of natural range 0 to 2041;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2049_to_8190_1d is array (natural range <>) of natural range 2049 to 8190;
  type natural_23_1d is array (natural range <>) of natural range 0 to 23;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_257_1d is array (natural range <>) of natural range 0 to 257;
  type natural_3063_1d is array (natural range <>) of natural range 0 to 3063;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_4082_1d is array (natural range <>) of natural range 0 to 4082;
  type natural_4082_2d is array (natural range <>, natural range <>) of natural range 0 to 4082;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_4095_2d is array (natural range <>, natural range <>) of natural range 0 to 4095;
  type natural_510_1d is array (natural range <>) of natural range 0 to 510;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_8164_1d is array (natural range <>) of natural range 0 to 8164;
  type natural_8192_1d is array (natural range <>) of natural range 0 to 8192;
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
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_counter_group, transform_left_rows_read_newest_0,
    transform_left_rows_ready_words_2, transform_left_rows_ready_newest_0, transform_left_rows_write_words_2,
    transform_right_rows_read_newest_0, transform_right_rows_ready_words_2, transform_right_rows_ready_newest_0,
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
    transform_centre_column : natural range 0 to 511;
  signal transform_left_rows_read_words, transform_left_rows_ready_words, transform_left_rows_write_words,
    transform_right_rows_read_words, transform_right_rows_ready_words,
    transform_right_rows_write_words : unsigned_32_1d(0 to 1);
  signal transform_left_rows_read_words_2, transform_right_rows_read_words_2 : unsigned(7 downto 0);
  signal transform_centre_group : natural range 0 to 256;
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
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 4095;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 511;
  signal raster_place_group : natural range 0 to 255;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 31;
  signal delay_ahead_0 : natural range 0 to 4095;
  signal delay_delayed_0 : unsigned(11 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag : tag_9;
  -- rows
  signal rows_search_rows_read_words, rows_reference_rows_read_words : unsigned_24_1d(0 to 3);
  signal rows_search_rows_read_words_4, rows_reference_rows_read_words_4 : unsigned(11 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_words_4,
    rows_search_rows_ready_newest_0 : natural range 0 to 4095;
  signal rows_search_rows_write_words : natural_16777215_1d(0 to 4);  -- _# up to 16777215 x 4, 4095
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_words_4,
    rows_reference_rows_ready_newest_0 : natural range 0 to 4095;
  signal rows_reference_rows_write_words : natural_16777215_1d(0 to 4);  -- _# up to 16777215 x 4, 4095
  signal rows_search, rows_reference : natural_4095_1d(0 to 1);
  signal rows_search_rows_ready_words, rows_reference_rows_ready_words : natural_16777215_1d(0 to 3);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag : tag_9;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag, rows_tag : tag_9;
  -- slice0shift
  signal slice0shift_search : natural_4095_2d(0 to 1, 0 to 11);
  signal slice0shift_reference, slice0shift_search_out : natural_4095_1d(0 to 1);
  signal slice0shift_tag : tag_9;
  -- slice0cost
  signal slice0cost_pixels_first : natural_255_2d(0 to 1, 0 to 11);
  signal slice0cost_column_0 : natural_255_1d(0 to 11);
  signal slice0cost_pixels_first_tag : tag_9;
  signal slice0cost_pixels_tag, slice0cost_ready_tag, slice0cost_tag : tag_8;
  signal slice0cost_pixels_cost : natural_19_2d(0 to 1, 0 to 11);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column,
    slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words, slice0cost_ready_words, slice0cost_write_words : unsigned_32_1d(0 to 2);
  signal slice0cost_change_0 : integer_minus_19_to_19_1d(0 to 11);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving : unsigned_32_1d(0 to 2);
  signal slice0window_entering_0 : natural_255_1d(0 to 11);
  signal slice0window_entering_tag, slice0window_change_tag : tag_6;
  signal slice0window_centre_output_column_0, slice0window_centre_first_column_0, slice0window_centre_start_of_frame_0,
    slice0window_centre_start_of_frame_3, slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_4;
  signal slice0window_change_0 : integer_minus_255_to_255_1d(0 to 11);
  signal slice0window_sum_0 : natural_2047_1d(0 to 11);
  -- slice0winner1
  signal slice0winner1_best_cost_0, slice0winner1_best_below_0, slice0winner1_best_above_0,
    slice0winner1_best_first_0 : natural_2047_1d(0 to 5);
  signal slice0winner1_best_last_0 : natural_2047_1d(0 to 4);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_tag : tag_4;
  signal slice0winner1_best_index_0 : natural_11_1d(1 to 5);  -- _# up to 3, 5 .. 11
  -- slice0winner2
  signal slice0winner2_best_cost_0, slice0winner2_best_below_0, slice0winner2_best_above_0,
    slice0winner2_best_first_0 : natural_2047_1d(0 to 2);
  signal slice0winner2_best_last_0 : natural_2047_1d(0 to 1);
  signal slice0winner2_best_index_0 : natural_11_1d(0 to 2);  -- _# up to 3, 7, 11
  signal slice0winner2_tag : tag_4;
  -- slice0winner3
  signal slice0winner3_best_cost_0, slice0winner3_best_below_0, slice0winner3_best_above_0,
    slice0winner3_best_first_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner3_best_index_0 : natural_11_1d(0 to 1);  -- _# up to 7, 11
  signal slice0winner3_tag : tag_4;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0, slice0winner4_best_above_0_0,
    slice0winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_index_0_0 : natural range 0 to 11;
  signal slice0winner4_tag : tag_4;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_below_0_0, slice0_best_above_0_0,
    slice0_best_first_0_0 : natural range 0 to 2047;
  signal slice0_best_index_0_0 : natural range 0 to 23;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_4095_2d(0 to 1, 0 to 11);
  signal slice1shift_reference : natural_4095_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first : natural_255_2d(0 to 1, 0 to 11);
  signal slice1cost_column_0 : natural_255_1d(0 to 11);
  signal slice1cost_pixels_cost : natural_19_2d(0 to 1, 0 to 11);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column,
    slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words, slice1cost_ready_words, slice1cost_write_words : unsigned_32_1d(0 to 2);
  signal slice1cost_change_0 : integer_minus_19_to_19_1d(0 to 11);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving : unsigned_32_1d(0 to 2);
  signal slice1window_entering_0 : natural_255_1d(0 to 11);
  signal slice1window_change_0 : integer_minus_255_to_255_1d(0 to 11);
  signal slice1window_sum_0 : natural_2047_1d(0 to 11);
  signal slice1window_centre_output_column : boolean_1d(0 to 2);
  signal slice1window_centre_start_of_frame : boolean_1d(0 to 1);
  signal slice1window_centre_end_of_line : boolean_1d(0 to 2);
  -- slice1winner1
  signal slice1winner1_best_cost_0, slice1winner1_best_below_0, slice1winner1_best_above_0 : natural_2047_1d(0 to 5);
  signal slice1winner1_best_first_0 : natural_2047_1d(1 to 5);
  signal slice1winner1_best_last_0 : natural_2047_1d(0 to 5);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_11_1d(1 to 5);  -- _# up to 3, 5 .. 11
  -- slice1winner2
  signal slice1winner2_best_cost_0, slice1winner2_best_below_0, slice1winner2_best_above_0 : natural_2047_1d(0 to 2);
  signal slice1winner2_best_first_0 : natural_2047_1d(1 to 2);
  signal slice1winner2_best_last_0 : natural_2047_1d(0 to 2);
  signal slice1winner2_best_index_0 : natural_11_1d(0 to 2);  -- _# up to 3, 7, 11
  -- slice1winner3
  signal slice1winner3_best_cost_0, slice1winner3_best_below_0, slice1winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_first_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_last_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_index_0 : natural_11_1d(0 to 1);  -- _# up to 7, 11
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0, slice1winner4_best_above_0_0,
    slice1winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_index_0_0 : natural range 0 to 11;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 2047;
  signal slice1_best_index_0_0 : natural range 0 to 23;
  signal slice1_best_tag : tag_4;
  -- refinement
  signal refinement_disparity_0 : natural_23_1d(0 to 11);  -- _#_0
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- _#_0
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
  -- map
  signal map_out_disparity_0 : natural range 0 to 65535;
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  -- other
  signal other_0, other_3 : boolean;
  signal others_from_11 : boolean_1d(11 to 12);  -- other_#
  signal other : natural_257_1d(1 to 2);
  signal other_4 : natural range 0 to 254;
  signal other_5 : natural range 0 to 252;
  signal other_6 : natural range 0 to 248;
  signal other_7 : natural range 0 to 240;
  signal other_8 : natural range 0 to 224;
  signal other_9 : natural range 0 to 192;
  signal other_10 : natural range 0 to 128;
  signal other_13, other_17 : natural range 0 to 65534;
  signal others_from_14 : natural_8192_1d(14 to 15);  -- other_#
  signal others_from_18 : natural_8192_1d(18 to 19);  -- other_#
  signal other_16, other_20 : natural range 0 to 2042;

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  slice1window_leaving_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 4);
    write_address <= to_unsigned(slice1window_ring_write_address, 4);
    write_data <= to_unsigned(slice1cost_column_0(4 * i + 3), 8) & to_unsigned(slice1cost_column_0(4 * i + 2), 8) &
      to_unsigned(slice1cost_column_0(4 * i + 1), 8) & to_unsigned(slice1cost_column_0(4 * i), 8);
    cell : entity work.line_memory generic map (10, 32, 4)
      port map (clock, true, read_address, slice1window_leaving(i), write_address, write_data);
  end generate;

  slice1cost_read_words_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 9);
    write_address <= to_unsigned(slice1cost_write_column, 9);
    cell : entity work.line_memory generic map (320, 32, 9)
      port map (clock, true, read_address, slice1cost_read_words(i), write_address, slice1cost_write_words(i));
  end generate;

  slice0window_leaving_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 4);
    write_address <= to_unsigned(slice0window_ring_write_address, 4);
    write_data <= to_unsigned(slice0cost_column_0(4 * i + 3), 8) & to_unsigned(slice0cost_column_0(4 * i + 2), 8) &
      to_unsigned(slice0cost_column_0(4 * i + 1), 8) & to_unsigned(slice0cost_column_0(4 * i), 8);
    cell : entity work.line_memory generic map (10, 32, 4)
      port map (clock, true, read_address, slice0window_leaving(i), write_address, write_data);
  end generate;

  slice0cost_read_words_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    cell : entity work.line_memory generic map (320, 32, 9)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, slice0cost_write_words(i));
  end generate;

  rows_search_rows_read_words_4_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words(4), 12);
    cell : entity work.line_memory generic map (320, 12, 9)
      port map (clock, true, read_address, rows_search_rows_read_words_4, write_address, write_data);
  end block;

  rows_search_rows_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (320, 24, 9)
      port map (clock, true, read_address, rows_search_rows_read_words(i), write_address, write_data);
  end generate;

  rows_reference_rows_read_words_4_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words(4), 12);
    cell : entity work.line_memory generic map (320, 12, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words_4, write_address, write_data);
  end block;

  rows_reference_rows_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (320, 24, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words(i), write_address, write_data);
  end generate;

  delay_delayed_0_memory : block
    signal read_address, write_address : unsigned(4 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 5);
    write_address <= to_unsigned(delay_ring_write_address, 5);
    write_data <= to_unsigned(raster_features_reference_0, 12);
    cell : entity work.line_memory generic map (24, 12, 5)
      port map (clock, true, read_address, delay_delayed_0, write_address, write_data);
  end block;

  transform_left_rows_read_words_2_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    write_data <= to_unsigned(transform_left_rows_write_words_2, 8);
    cell : entity work.line_memory generic map (320, 8, 9)
      port map (clock, true, read_address, transform_left_rows_read_words_2, write_address, write_data);
  end block;

  transform_left_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (320, 32, 9)
      port map (clock, true, read_address, transform_left_rows_read_words(i), write_address,
        transform_left_rows_write_words(i));
  end generate;

  transform_right_rows_read_words_2_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    write_data <= to_unsigned(transform_right_rows_write_words_2, 8);
    cell : entity work.line_memory generic map (320, 8, 9)
      port map (clock, true, read_address, transform_right_rows_read_words_2, write_address, write_data);
  end block;

  transform_right_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (320, 32, 9)
      port map (clock, true, read_address, transform_right_rows_read_words(i), write_address,
        transform_right_rows_write_words(i));
  end generate;

  process
    variable transform_counter_group_is_equals : boolean_1d(1 to 4);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_counter_group_choice_2,
      transform_centre_column_is_less, raster_place_group_is_equal, raster_place_group_choice,
      delay_tag_first_cost_is_equal, slice0winner3_best_cost_0_0_is_less, slice0winner4_best_cost_0_0_is_less,
      slice1winner3_best_cost_0_0_is_less, slice1winner4_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less,
      refinement_divisor_0_0_is_less : boolean;
    variable transform_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choices : natural_255_1d(3 to 4);  -- _choice_#
    variable transform_centre_column_choice : natural range 79 to 127;
    variable transform_counter_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
    variable slice0cost_column_0_choice, slice1cost_column_0_choice : natural_255_2d(0 to 11, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice, slice1window_change_0_choice : natural_255_1d(0 to 11);  -- _#_choice
    variable slice0window_sum_0_choice, slice1window_sum_0_choice : natural_2047_1d(0 to 11);  -- _#_choice
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less : boolean_1d(0 to 5);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less, slice1winner2_best_cost_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable slice0winner2_best_below_0_choice, slice0winner2_best_above_0_choice, slice1winner2_best_below_0_choice,
      slice1winner2_best_above_0_choice : natural_2047_1d(0 to 2);  -- _#_choice
    variable slice0winner3_best_below_0_0_choice, slice0winner3_best_above_0_0_choice,
      slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice, slice1winner3_best_below_0_0_choice,
      slice1winner3_best_above_0_0_choice, slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice,
      slice1_best_below_0_0_choice, slice1_best_above_0_0_choice,
      refinement_divisor_0_0_choice : natural range 0 to 2047;
    variable refinement_remainder_1_0_difference : natural range 2049 to 6143;
    variable refinement_remainder_0_difference : natural_2049_to_8190_1d(2 to 7);  -- _#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
  begin
    wait until rising_edge(clock);
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_column = 319;
    transform_counter_group_is_equals(2) := transform_counter_group = 239;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 15, 0);
    transform_counter_group_is_equals(3) := (transform_counter_group / 16) = 15;
    transform_counter_group_differs := (transform_counter_group mod 16) /= 4;
    transform_counter_group_choice_2 := choice(transform_counter_group_is_equals(3), transform_counter_group_differs
      and in_valid and transform_counter_group_is_equals(1), in_valid and transform_counter_group_is_equals(1));
    transform_counter_group_is_equals(4) := transform_counter_group = 243;
    transform_counter_group_choices(3) := choice(transform_counter_group_is_equals(4) and transform_counter_next_frame,
      4, (transform_counter_group + 1) mod 256);
    transform_counter_group_choices(4) := choice(transform_counter_group_choice_2, transform_counter_group_choices(3),
      transform_counter_group);
    transform_centre_column_is_less := 3 < transform_counter_column;
    transform_centre_column_choice := choice(transform_centre_column_is_less, 127, 79);
    transform_left_0 <= in_left_pixel;
    transform_right_0 <= in_right_pixel;
    transform_valid <= in_valid;
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
    transform_centre_column <= (((transform_centre_column_choice + (transform_counter_column / 4)) mod 128) * 4) +
      (transform_counter_column mod 4);
    transform_centre_group <= transform_counter_group + as_number(transform_centre_column_is_less);
    transform_from_first(0) <= (1 < transform_centre_column) and (6 < transform_centre_group);
    transform_from_first(1) <= (4 < transform_centre_column) and (9 < transform_centre_group);
    transform_up_to_last(0) <= (transform_centre_column < 318) and (transform_centre_group < 243);
    transform_up_to_last(1) <= (transform_centre_column < 316) and (transform_centre_group < 241);
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
    transform_columns_start_of_frame <= is_set(other(1), 0);
    transform_columns_valid <= is_set(other(1), 8);
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
    transform_left_code_row_signs <= ((others_from_18(18) / 8192) * 2) + (others_from_18(19) / 8192) +
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
    transform_left_code_next_row_signs <= (other_17 / 32768) + ((transform_left_code_next_row_odd(0) / 32768) * 2) +
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
    transform_right_code_row_signs <= ((others_from_14(14) / 8192) * 2) + (others_from_14(15) / 8192) +
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
    transform_right_code_next_row_signs <= (other_13 / 32768) + ((transform_right_code_next_row_odd(0) / 32768) * 2) +
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
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice * 16,
      transform_counter_group_choices(4));
    transform_left_code_bits <= choice(transform_filtering_inside(6, 0), transform_left_code_earlier(1), 0);
    transform_right_code_bits <= choice(transform_filtering_inside(6, 0), transform_right_code_earlier(1), 0);
    transform_left_code_next_bits <= choice(transform_filtering_inside(6, 1), transform_left_code_next_row_signs, 0);
    transform_right_code_next_bits <= choice(transform_filtering_inside(6, 1), transform_right_code_next_row_signs, 0);
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(3),
      transform_counter_group_differs and transform_counter_group_is_equals(1), transform_counter_group_is_equals(1));
    transform_counter_next_frame_choices(2) := choice(in_start_of_frame, transform_counter_group_all,
      transform_counter_next_frame);
    if in_valid then
      transform_counter_column <= choice(in_start_of_frame or transform_counter_group_is_equals(1), 0,
        (transform_counter_column + 1) mod 512);
      transform_counter_next_frame <= choice(transform_counter_group_is_equals(4) and
        transform_counter_next_frame_choices(1), transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2) and in_start_of_frame, transform_counter_next_frame_choices(2));
    end if;
    if is_set(other(1), 8) then
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
    -- raster
    raster_place_group_is_equal := raster_place_column = 319;
    raster_place_group_choice := choice(((raster_place_group mod 16) = 4) and is_set(raster_place_group, 7) and
      (((raster_place_group / 16) mod 4) = 3), transform_filtering_valid(7) and raster_place_group_is_equal and (not
      is_set(raster_place_group, 6)), transform_filtering_valid(7) and raster_place_group_is_equal);
    raster_features_search_0 <= (transform_left_code_next_bits * 64) + transform_left_code_bits;
    raster_features_reference_0 <= (transform_right_code_next_bits * 64) + transform_right_code_bits;
    raster_features_valid <= transform_filtering_valid(7);
    raster_place_group <= choice(transform_filtering_valid(7) and transform_filtering_start_of_frame(7), 0,
      (raster_place_group + as_number(raster_place_group_choice)) mod 256);
    if transform_filtering_valid(7) then
      raster_place_column <= choice(raster_place_group_is_equal or transform_filtering_start_of_frame(7), 0,
        (raster_place_column + 1) mod 512);
    end if;
    -- delay
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 23, 0, (delay_ring_read_address + 1) mod 32);
    end if;
    delay_tag_first_cost_is_equal := raster_place_column = 23;
    delay_ahead_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 249);
    delay_row_inside(1) <= (not is_set(raster_place_group, 7)) or (not is_set(raster_place_group, 6)) or (not
      is_set(raster_place_group, 5)) or (not is_set(raster_place_group, 4));
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= raster_place_column = 0;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.border_column <= raster_place_column < 23;
    delay_tag.first_cost <= delay_tag_first_cost_is_equal;
    delay_tag.leaves_window <= (((((raster_place_column / 32) + 2047) mod 2048) * 32) + (raster_place_column mod 32)) <
      65508;
    delay_tag.output_column <= ((((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) <
      240) and (raster_place_column >= 23) and (raster_place_column < 319);
    delay_tag.start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 4);
    delay_tag.end_of_line <= raster_place_column = 318;
    -- rows
    rows_search_rows_read_newest_0 <= delay_ahead_0;
    rows_search_rows_ready_words(0) <= to_integer(rows_search_rows_read_words(0));
    rows_search_rows_ready_words(1) <= to_integer(rows_search_rows_read_words(1));
    rows_search_rows_ready_words(2) <= to_integer(rows_search_rows_read_words(2));
    rows_search_rows_ready_words(3) <= to_integer(rows_search_rows_read_words(3));
    rows_search_rows_ready_words_4 <= to_integer(rows_search_rows_read_words_4);
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
    rows_reference_rows_ready_words(0) <= to_integer(rows_reference_rows_read_words(0));
    rows_reference_rows_ready_words(1) <= to_integer(rows_reference_rows_read_words(1));
    rows_reference_rows_ready_words(2) <= to_integer(rows_reference_rows_read_words(2));
    rows_reference_rows_ready_words(3) <= to_integer(rows_reference_rows_read_words(3));
    rows_reference_rows_ready_words_4 <= to_integer(rows_reference_rows_read_words_4);
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_tag <= rows_ready_tag;
    rows_search(0) <= choice(rows_ready_inside(0), rows_search_rows_ready_words(0) mod 4096, 0);
    rows_reference(0) <= choice(rows_ready_inside(0), rows_reference_rows_ready_words(0) mod 4096, 0);
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_newest_0, 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      for i in 0 to 2 loop
        rows_search_rows_write_words(i) <= (rows_search_rows_ready_words(i) / 4096) + ((rows_search_rows_ready_words(i
          + 1) mod 4096) * 4096);
      end loop;
      rows_search_rows_write_words(3) <= (rows_search_rows_ready_words(3) / 4096) + (rows_search_rows_ready_words_4 *
        4096);
      rows_search_rows_write_words(4) <= rows_search_rows_ready_newest_0;
      for i in 0 to 2 loop
        rows_reference_rows_write_words(i) <= (rows_reference_rows_ready_words(i) / 4096) +
          ((rows_reference_rows_ready_words(i + 1) mod 4096) * 4096);
      end loop;
      rows_reference_rows_write_words(3) <= (rows_reference_rows_ready_words(3) / 4096) +
        (rows_reference_rows_ready_words_4 * 4096);
      rows_reference_rows_write_words(4) <= rows_reference_rows_ready_newest_0;
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 10 loop slice0shift_search(i, j) <= slice0shift_search(i, j + 1); end loop;
        slice0shift_search(i, 11) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 0);
    slice0shift_search_out(1) <= slice0shift_search(1, 0);
    slice0shift_tag <= rows_tag;
    -- slice0cost
    for i in 0 to 1 loop
      for j in 0 to 3 loop
        slice0cost_column_0_choice(4 * i + j, 1) := choice(slice0cost_ready_tag.first_group, 0,
          to_integer(slice0cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice0cost_column_0_choice(4 * i + j, 2) := choice(slice0cost_ready_tag.border_column, 0,
          (slice0cost_change_0(4 * i + j) + slice0cost_column_0_choice(4 * i + j, 1)) mod 256);
      end loop;
    end loop;
    for i in 8 to 10 loop
      slice0cost_column_0_choice(i, 1) := choice(slice0cost_ready_tag.first_group, 0,
        to_integer(slice0cost_ready_words(2)(8 * i - 57 downto 8 * i - 64)));
      slice0cost_column_0_choice(i, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(i) +
        slice0cost_column_0_choice(i, 1)) mod 256);
    end loop;
    slice0cost_column_0_choice(11, 1) := choice(slice0cost_ready_tag.first_group, 0,
      to_integer(slice0cost_ready_words(2)(31 downto 24)));
    slice0cost_column_0_choice(11, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_column_0_choice(11,
      1) + slice0cost_change_0(11)) mod 256);
    for i in 0 to 1 loop
      slice0cost_pixels_first(i, 0) <= ((differing(slice0shift_reference(i), slice0shift_search(i, 0), 3, 5, 4)) * 4) +
        differing(slice0shift_reference(i), slice0shift_search(i, 0), 0) + differing(slice0shift_reference(i),
        slice0shift_search(i, 0), 2) + differing(slice0shift_reference(i), slice0shift_search(i, 0), 1) +
        ((differing(slice0shift_reference(i), slice0shift_search(i, 0), 6, 8, 7)) * 16) +
        ((differing(slice0shift_reference(i), slice0shift_search(i, 0), 9, 11, 10)) * 64);
      for j in 1 to 11 loop
        slice0cost_pixels_first(i, j) <= ((differing(slice0shift_search(i, j), slice0shift_reference(i), 3, 5, 4)) * 4)
          + differing(slice0shift_search(i, j), slice0shift_reference(i), 0) + differing(slice0shift_search(i, j),
          slice0shift_reference(i), 2) + differing(slice0shift_search(i, j), slice0shift_reference(i), 1) +
          ((differing(slice0shift_search(i, j), slice0shift_reference(i), 6, 8, 7)) * 16) +
          ((differing(slice0shift_search(i, j), slice0shift_reference(i), 9, 11, 10)) * 64);
      end loop;
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 1 loop
      for j in 0 to 11 loop
        slice0cost_pixels_cost(i, j) <= (((slice0cost_pixels_first(i, j) mod 4) + (((slice0cost_pixels_first(i, j) / 2)
          mod 8) / 2) + ((((slice0cost_pixels_first(i, j) / 16) mod 4) + (slice0cost_pixels_first(i, j) / 64)) / 2)) *
          2) + (((slice0cost_pixels_first(i, j) / 16) + (slice0cost_pixels_first(i, j) / 64)) mod 2);
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
    for i in 0 to 11 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    slice0cost_ready_words <= slice0cost_read_words;
    slice0cost_ready_column <= slice0cost_change_column;
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    for i in 0 to 11 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
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
      for i in 0 to 2 loop
        slice0cost_write_words(i) <= to_unsigned(slice0cost_column_0_choice(4 * i + 3, 2), 8) &
          to_unsigned(slice0cost_column_0_choice(4 * i + 2, 2), 8) & to_unsigned(slice0cost_column_0_choice(4 * i + 1,
          2), 8) & to_unsigned(slice0cost_column_0_choice(4 * i, 2), 8);
      end loop;
    end if;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_ring_write_address <= slice0window_ring_read_address;
      slice0window_ring_read_address <= choice(slice0window_ring_read_address = 9, 0, (slice0window_ring_read_address +
        1) mod 16);
    end if;
    for i in 0 to 2 loop
      for j in 0 to 3 loop
        slice0window_change_0_choice(4 * i + j) := choice(slice0window_entering_tag.leaves_window,
          to_integer(slice0window_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    slice0window_entering_0 <= slice0cost_column_0;
    slice0window_entering_tag.valid <= slice0cost_tag.valid;
    slice0window_entering_tag.first_cost <= slice0cost_tag.first_cost;
    slice0window_entering_tag.leaves_window <= slice0cost_tag.leaves_window;
    slice0window_entering_tag.output_column <= slice0cost_tag.output_column;
    slice0window_entering_tag.start_of_frame <= slice0cost_tag.start_of_frame;
    slice0window_entering_tag.end_of_line <= slice0cost_tag.end_of_line;
    for i in 0 to 11 loop
      slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
    end loop;
    slice0window_change_tag <= slice0window_entering_tag;
    slice0window_centre_output_column_0 <= slice0window_change_tag.output_column;
    slice0window_centre_first_column_0 <= slice0window_change_tag.first_cost;
    slice0window_centre_start_of_frame_0 <= slice0window_change_tag.start_of_frame;
    slice0window_centre_end_of_line_0 <= slice0window_change_tag.end_of_line;
    slice0window_tag.valid <= slice0window_change_tag.valid;
    for i in 0 to 11 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 11 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 2048;
      end loop;
    end if;
    if slice0window_tag.valid then
      slice0window_centre_start_of_frame_3 <= slice1window_centre_start_of_frame(1);
      slice0window_tag.output_column <= slice1window_centre_output_column(2);
      slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame_3;
      slice0window_tag.end_of_line <= slice1window_centre_end_of_line(2);
    end if;
    -- slice0winner1
    for i in 0 to 5 loop
      slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
    end loop;
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    for i in 0 to 5 loop slice0winner1_best_first_0(i) <= slice0window_sum_0(2 * i); end loop;
    for i in 0 to 4 loop slice0winner1_best_last_0(i) <= slice0window_sum_0(2 * i + 1); end loop;
    slice0winner1_tag <= slice0window_tag;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0window_sum_0(1),
      slice0window_sum_0(0));
    for i in 0 to 4 loop
      slice0winner1_best_below_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0window_sum_0(2 * i), 0);
      slice0winner1_best_above_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 0, slice0window_sum_0(2 * i + 1));
      slice0winner1_best_cost_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), slice0window_sum_0(2 * i +
        3), slice0window_sum_0(2 * i + 2));
      slice0winner1_best_index_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice0winner1_best_below_0(5) <= choice(slice0winner1_best_cost_0_is_less(5), slice0window_sum_0(10), 0);
    slice0winner1_best_above_0(5) <= choice(slice0winner1_best_cost_0_is_less(5), 0, slice0window_sum_0(11));
    -- slice0winner2
    for i in 0 to 2 loop
      slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner2_best_below_0_choice(0) := choice(slice0winner1_best_index_0(1) = 2, slice0winner1_best_last_0(0),
      slice0winner1_best_below_0(1));
    slice0winner2_best_below_0_choice(1) := choice(slice0winner1_best_index_0(3) = 6, slice0winner1_best_last_0(2),
      slice0winner1_best_below_0(3));
    slice0winner2_best_below_0_choice(2) := choice(is_set(slice0winner1_best_index_0(5), 3) and
      ((slice0winner1_best_index_0(5) mod 4) = 2), slice0winner1_best_last_0(4), slice0winner1_best_below_0(5));
    slice0winner2_best_above_0_choice(0) := choice(slice0winner1_best_index_0_0, slice0winner1_best_first_0(1),
      slice0winner1_best_above_0(0));
    slice0winner2_best_above_0_choice(1) := choice(other_0, slice0winner1_best_first_0(3),
      slice0winner1_best_above_0(2));
    slice0winner2_best_above_0_choice(2) := choice(other_3, slice0winner1_best_first_0(5),
      slice0winner1_best_above_0(4));
    slice0winner2_best_first_0(0) <= slice0winner1_best_first_0(0);
    slice0winner2_best_first_0(1) <= slice0winner1_best_first_0(2);
    slice0winner2_best_first_0(2) <= slice0winner1_best_first_0(4);
    slice0winner2_best_last_0(0) <= slice0winner1_best_last_0(1);
    slice0winner2_best_last_0(1) <= slice0winner1_best_last_0(3);
    slice0winner2_tag <= slice0winner1_tag;
    slice0winner2_best_cost_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    for i in 0 to 1 loop
      slice0winner2_best_below_0(i) <= choice(slice0winner2_best_cost_0_is_less(i),
        slice0winner2_best_below_0_choice(i), slice0winner1_best_below_0(2 * i));
      slice0winner2_best_above_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_above_0(2 * i +
        1), slice0winner2_best_above_0_choice(i));
      slice0winner2_best_cost_0(i + 1) <= choice(slice0winner2_best_cost_0_is_less(i + 1), slice0winner1_best_cost_0(2
        * i + 3), slice0winner1_best_cost_0(2 * i + 2));
      slice0winner2_best_index_0(i + 1) <= choice(slice0winner2_best_cost_0_is_less(i + 1),
        slice0winner1_best_index_0(2 * i + 3), slice0winner1_best_index_0(2 * i + 2));
    end loop;
    slice0winner2_best_below_0(2) <= choice(slice0winner2_best_cost_0_is_less(2), slice0winner2_best_below_0_choice(2),
      slice0winner1_best_below_0(4));
    slice0winner2_best_above_0(2) <= choice(slice0winner2_best_cost_0_is_less(2), slice0winner1_best_above_0(5),
      slice0winner2_best_above_0_choice(2));
    -- slice0winner3
    slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
    slice0winner3_best_below_0_0_choice := choice(slice0winner2_best_index_0(1) = 4, slice0winner2_best_last_0(0),
      slice0winner2_best_below_0(1));
    slice0winner3_best_above_0_0_choice := choice(slice0winner2_best_index_0(0) = 3, slice0winner2_best_first_0(1),
      slice0winner2_best_above_0(0));
    slice0winner3_best_cost_0(1) <= slice0winner2_best_cost_0(2);
    slice0winner3_best_index_0(1) <= slice0winner2_best_index_0(2);
    slice0winner3_best_below_0(1) <= slice0winner2_best_below_0(2);
    slice0winner3_best_above_0(1) <= slice0winner2_best_above_0(2);
    slice0winner3_best_first_0(0) <= slice0winner2_best_first_0(0);
    slice0winner3_best_first_0(1) <= slice0winner2_best_first_0(2);
    slice0winner3_best_last_0_0 <= slice0winner2_best_last_0(1);
    slice0winner3_tag <= slice0winner2_tag;
    slice0winner3_best_cost_0(0) <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_cost_0(1),
      slice0winner2_best_cost_0(0));
    slice0winner3_best_index_0(0) <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_index_0(1),
      slice0winner2_best_index_0(0));
    slice0winner3_best_below_0(0) <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner3_best_below_0_0_choice,
      slice0winner2_best_below_0(0));
    slice0winner3_best_above_0(0) <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_above_0(1),
      slice0winner3_best_above_0_0_choice);
    -- slice0winner4
    slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
    slice0winner4_best_below_0_0_choice := choice(is_set(slice0winner3_best_index_0(1), 3) and
      ((slice0winner3_best_index_0(1) mod 4) = 0), slice0winner3_best_last_0_0, slice0winner3_best_below_0(1));
    slice0winner4_best_above_0_0_choice := choice(slice0winner3_best_index_0(0) = 7, slice0winner3_best_first_0(1),
      slice0winner3_best_above_0(0));
    slice0winner4_best_first_0_0 <= slice0winner3_best_first_0(0);
    slice0winner4_tag <= slice0winner3_tag;
    slice0winner4_best_cost_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_cost_0(1),
      slice0winner3_best_cost_0(0));
    slice0winner4_best_index_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_index_0(1),
      slice0winner3_best_index_0(0));
    slice0winner4_best_below_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner4_best_below_0_0_choice,
      slice0winner3_best_below_0(0));
    slice0winner4_best_above_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_above_0(1),
      slice0winner4_best_above_0_0_choice);
    -- slice0
    slice0_best_cost_0_0 <= slice0winner4_best_cost_0_0;
    slice0_best_index_0_0 <= (((slice0winner4_best_index_0_0 / 4) + 3) * 4) + (slice0winner4_best_index_0_0 mod 4);
    slice0_best_below_0_0 <= slice0winner4_best_below_0_0;
    slice0_best_above_0_0 <= slice0winner4_best_above_0_0;
    slice0_best_first_0_0 <= slice0winner4_best_first_0_0;
    slice0_best_tag <= slice0winner4_tag;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 10 loop slice1shift_search(i, j) <= slice1shift_search(i, j + 1); end loop;
        slice1shift_search(i, 11) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    -- slice1cost
    for i in 0 to 1 loop
      for j in 0 to 3 loop
        slice1cost_column_0_choice(4 * i + j, 1) := choice(slice0cost_tag.first_group, 0,
          to_integer(slice1cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice1cost_column_0_choice(4 * i + j, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(4 * i
          + j) + slice1cost_column_0_choice(4 * i + j, 1)) mod 256);
      end loop;
    end loop;
    for i in 8 to 10 loop
      slice1cost_column_0_choice(i, 1) := choice(slice0cost_tag.first_group, 0, to_integer(slice1cost_ready_words(2)(8
        * i - 57 downto 8 * i - 64)));
      slice1cost_column_0_choice(i, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(i) +
        slice1cost_column_0_choice(i, 1)) mod 256);
    end loop;
    slice1cost_column_0_choice(11, 1) := choice(slice0cost_tag.first_group, 0, to_integer(slice1cost_ready_words(2)(31
      downto 24)));
    slice1cost_column_0_choice(11, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_column_0_choice(11, 1) +
      slice1cost_change_0(11)) mod 256);
    for i in 0 to 1 loop
      slice1cost_pixels_first(i, 0) <= ((differing(slice1shift_reference(i), slice1shift_search(i, 0), 3, 5, 4)) * 4) +
        differing(slice1shift_reference(i), slice1shift_search(i, 0), 0) + differing(slice1shift_reference(i),
        slice1shift_search(i, 0), 2) + differing(slice1shift_reference(i), slice1shift_search(i, 0), 1) +
        ((differing(slice1shift_reference(i), slice1shift_search(i, 0), 6, 8, 7)) * 16) +
        ((differing(slice1shift_reference(i), slice1shift_search(i, 0), 9, 11, 10)) * 64);
      for j in 1 to 11 loop
        slice1cost_pixels_first(i, j) <= ((differing(slice1shift_search(i, j), slice1shift_reference(i), 3, 5, 4)) * 4)
          + differing(slice1shift_search(i, j), slice1shift_reference(i), 0) + differing(slice1shift_search(i, j),
          slice1shift_reference(i), 2) + differing(slice1shift_search(i, j), slice1shift_reference(i), 1) +
          ((differing(slice1shift_search(i, j), slice1shift_reference(i), 6, 8, 7)) * 16) +
          ((differing(slice1shift_search(i, j), slice1shift_reference(i), 9, 11, 10)) * 64);
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 11 loop
        slice1cost_pixels_cost(i, j) <= (((slice1cost_pixels_first(i, j) mod 4) + (((slice1cost_pixels_first(i, j) / 2)
          mod 8) / 2) + ((((slice1cost_pixels_first(i, j) / 16) mod 4) + (slice1cost_pixels_first(i, j) / 64)) / 2)) *
          2) + (((slice1cost_pixels_first(i, j) / 16) + (slice1cost_pixels_first(i, j) / 64)) mod 2);
      end loop;
    end loop;
    slice1cost_read_column <= slice0cost_read_column;
    slice1cost_change_column <= slice1cost_read_column;
    for i in 0 to 11 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    slice1cost_ready_words <= slice1cost_read_words;
    for i in 0 to 11 loop slice1cost_column_0(i) <= slice1cost_column_0_choice(i, 2); end loop;
    if slice0cost_ready_tag.valid then slice1cost_ready_column <= slice1cost_change_column; end if;
    if slice0cost_tag.valid then
      slice1cost_write_column <= slice0cost_write_column;
      for i in 0 to 2 loop
        slice1cost_write_words(i) <= to_unsigned(slice1cost_column_0_choice(4 * i + 3, 2), 8) &
          to_unsigned(slice1cost_column_0_choice(4 * i + 2, 2), 8) & to_unsigned(slice1cost_column_0_choice(4 * i + 1,
          2), 8) & to_unsigned(slice1cost_column_0_choice(4 * i, 2), 8);
      end loop;
    end if;
    -- slice1window
    if slice0window_entering_tag.valid then
      slice1window_ring_write_address <= slice1window_ring_read_address;
      slice1window_ring_read_address <= choice(slice1window_ring_read_address = 9, 0, (slice1window_ring_read_address +
        1) mod 16);
    end if;
    for i in 0 to 2 loop
      for j in 0 to 3 loop
        slice1window_change_0_choice(4 * i + j) := choice(slice0window_change_tag.leaves_window,
          to_integer(slice1window_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    slice1window_entering_0 <= slice1cost_column_0;
    for i in 0 to 11 loop
      slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
    end loop;
    for i in 0 to 11 loop
      slice1window_sum_0_choice(i) := choice(slice0window_centre_first_column_0, 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag.valid then
      for i in 0 to 11 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 2048;
      end loop;
      slice1window_centre_output_column(0) <= slice0window_centre_output_column_0;
      slice1window_centre_output_column(1 to 2) <= slice1window_centre_output_column(0 to 1);
      slice1window_centre_start_of_frame(0) <= slice0window_centre_start_of_frame_0;
      slice1window_centre_start_of_frame(1) <= slice1window_centre_start_of_frame(0);
      slice1window_centre_end_of_line(0) <= slice0window_centre_end_of_line_0;
      slice1window_centre_end_of_line(1 to 2) <= slice1window_centre_end_of_line(0 to 1);
    end if;
    -- slice1winner1
    for i in 0 to 5 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
    end loop;
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    for i in 1 to 5 loop slice1winner1_best_first_0(i) <= slice1window_sum_0(2 * i); end loop;
    for i in 0 to 5 loop slice1winner1_best_last_0(i) <= slice1window_sum_0(2 * i + 1); end loop;
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1window_sum_0(1),
      slice1window_sum_0(0));
    for i in 0 to 4 loop
      slice1winner1_best_below_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1window_sum_0(2 * i), 0);
      slice1winner1_best_above_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 0, slice1window_sum_0(2 * i + 1));
      slice1winner1_best_cost_0(i + 1) <= choice(slice1winner1_best_cost_0_is_less(i + 1), slice1window_sum_0(2 * i +
        3), slice1window_sum_0(2 * i + 2));
      slice1winner1_best_index_0(i + 1) <= choice(slice1winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice1winner1_best_below_0(5) <= choice(slice1winner1_best_cost_0_is_less(5), slice1window_sum_0(10), 0);
    slice1winner1_best_above_0(5) <= choice(slice1winner1_best_cost_0_is_less(5), 0, slice1window_sum_0(11));
    -- slice1winner2
    for i in 0 to 2 loop
      slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner2_best_below_0_choice(0) := choice(slice1winner1_best_index_0(1) = 2, slice1winner1_best_last_0(0),
      slice1winner1_best_below_0(1));
    slice1winner2_best_below_0_choice(1) := choice(slice1winner1_best_index_0(3) = 6, slice1winner1_best_last_0(2),
      slice1winner1_best_below_0(3));
    slice1winner2_best_below_0_choice(2) := choice(is_set(slice1winner1_best_index_0(5), 3) and
      ((slice1winner1_best_index_0(5) mod 4) = 2), slice1winner1_best_last_0(4), slice1winner1_best_below_0(5));
    slice1winner2_best_above_0_choice(0) := choice(slice1winner1_best_index_0_0, slice1winner1_best_first_0(1),
      slice1winner1_best_above_0(0));
    slice1winner2_best_above_0_choice(1) := choice(others_from_11(11), slice1winner1_best_first_0(3),
      slice1winner1_best_above_0(2));
    slice1winner2_best_above_0_choice(2) := choice(others_from_11(12), slice1winner1_best_first_0(5),
      slice1winner1_best_above_0(4));
    slice1winner2_best_first_0(1) <= slice1winner1_best_first_0(2);
    slice1winner2_best_first_0(2) <= slice1winner1_best_first_0(4);
    slice1winner2_best_last_0(0) <= slice1winner1_best_last_0(1);
    slice1winner2_best_last_0(1) <= slice1winner1_best_last_0(3);
    slice1winner2_best_last_0(2) <= slice1winner1_best_last_0(5);
    slice1winner2_best_cost_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_cost_0(1),
      slice1winner1_best_cost_0(0));
    slice1winner2_best_index_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_index_0(1),
      as_number(slice1winner1_best_index_0_0));
    for i in 0 to 1 loop
      slice1winner2_best_below_0(i) <= choice(slice1winner2_best_cost_0_is_less(i),
        slice1winner2_best_below_0_choice(i), slice1winner1_best_below_0(2 * i));
      slice1winner2_best_above_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_above_0(2 * i +
        1), slice1winner2_best_above_0_choice(i));
      slice1winner2_best_cost_0(i + 1) <= choice(slice1winner2_best_cost_0_is_less(i + 1), slice1winner1_best_cost_0(2
        * i + 3), slice1winner1_best_cost_0(2 * i + 2));
      slice1winner2_best_index_0(i + 1) <= choice(slice1winner2_best_cost_0_is_less(i + 1),
        slice1winner1_best_index_0(2 * i + 3), slice1winner1_best_index_0(2 * i + 2));
    end loop;
    slice1winner2_best_below_0(2) <= choice(slice1winner2_best_cost_0_is_less(2), slice1winner2_best_below_0_choice(2),
      slice1winner1_best_below_0(4));
    slice1winner2_best_above_0(2) <= choice(slice1winner2_best_cost_0_is_less(2), slice1winner1_best_above_0(5),
      slice1winner2_best_above_0_choice(2));
    -- slice1winner3
    slice1winner3_best_cost_0_0_is_less := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
    slice1winner3_best_below_0_0_choice := choice(slice1winner2_best_index_0(1) = 4, slice1winner2_best_last_0(0),
      slice1winner2_best_below_0(1));
    slice1winner3_best_above_0_0_choice := choice(slice1winner2_best_index_0(0) = 3, slice1winner2_best_first_0(1),
      slice1winner2_best_above_0(0));
    slice1winner3_best_cost_0(1) <= slice1winner2_best_cost_0(2);
    slice1winner3_best_index_0(1) <= slice1winner2_best_index_0(2);
    slice1winner3_best_below_0(1) <= slice1winner2_best_below_0(2);
    slice1winner3_best_above_0(1) <= slice1winner2_best_above_0(2);
    slice1winner3_best_first_0_1 <= slice1winner2_best_first_0(2);
    slice1winner3_best_last_0 <= slice1winner2_best_last_0(1 to 2);
    slice1winner3_best_cost_0(0) <= choice(slice1winner3_best_cost_0_0_is_less, slice1winner2_best_cost_0(1),
      slice1winner2_best_cost_0(0));
    slice1winner3_best_index_0(0) <= choice(slice1winner3_best_cost_0_0_is_less, slice1winner2_best_index_0(1),
      slice1winner2_best_index_0(0));
    slice1winner3_best_below_0(0) <= choice(slice1winner3_best_cost_0_0_is_less, slice1winner3_best_below_0_0_choice,
      slice1winner2_best_below_0(0));
    slice1winner3_best_above_0(0) <= choice(slice1winner3_best_cost_0_0_is_less, slice1winner2_best_above_0(1),
      slice1winner3_best_above_0_0_choice);
    -- slice1winner4
    slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
    slice1winner4_best_below_0_0_choice := choice(is_set(slice1winner3_best_index_0(1), 3) and
      ((slice1winner3_best_index_0(1) mod 4) = 0), slice1winner3_best_last_0(0), slice1winner3_best_below_0(1));
    slice1winner4_best_above_0_0_choice := choice(slice1winner3_best_index_0(0) = 7, slice1winner3_best_first_0_1,
      slice1winner3_best_above_0(0));
    slice1winner4_best_last_0_0 <= slice1winner3_best_last_0(1);
    slice1winner4_best_cost_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_cost_0(1),
      slice1winner3_best_cost_0(0));
    slice1winner4_best_index_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_index_0(1),
      slice1winner3_best_index_0(0));
    slice1winner4_best_below_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner4_best_below_0_0_choice,
      slice1winner3_best_below_0(0));
    slice1winner4_best_above_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_above_0(1),
      slice1winner4_best_above_0_0_choice);
    -- slice1
    slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner4_best_cost_0_0) < 0;
    slice1_best_below_0_0_choice := choice(slice0_best_index_0_0 = 12, slice1winner4_best_last_0_0,
      slice0_best_below_0_0);
    slice1_best_above_0_0_choice := choice(slice1winner4_best_index_0_0 = 11, slice0_best_first_0_0,
      slice1winner4_best_above_0_0);
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_cost_0_0, slice1winner4_best_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_index_0_0, slice1winner4_best_index_0_0);
    slice1_best_below_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1_best_below_0_0_choice,
      slice1winner4_best_below_0_0);
    slice1_best_above_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_above_0_0, slice1_best_above_0_0_choice);
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
    refinement_disparity_0(0) <= slice1_best_index_0_0;
    refinement_disparity_0(1 to 11) <= refinement_disparity_0(0 to 10);
    refinement_passed_0(0) <= true;
    refinement_passed_0(1 to 11) <= refinement_passed_0(0 to 10);
    refinement_tag_valid(0) <= slice1_best_tag.valid;
    refinement_tag_output_column(0) <= slice1_best_tag.output_column;
    refinement_tag_start_of_frame(0) <= slice1_best_tag.start_of_frame;
    refinement_tag_end_of_line(0) <= slice1_best_tag.end_of_line;
    for i in 1 to 11 loop
      refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
      refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
      refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
      refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
    end loop;
    refinement_cost_0 <= slice1_best_cost_0_0;
    refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 2048;
    refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 2048;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 11)) or
      (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 11))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((4096 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 2048) +
      ((other_4 / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
    refinement_below_0 <= choice(slice1_best_index_0_0 = 0, slice1_best_above_0_0, slice1_best_below_0_0);
    refinement_above_0 <= choice(slice1_best_index_0_0 = 23, slice1_best_below_0_0, slice1_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 12),
      refinement_remainder_1_0_difference mod 2048, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 12),
        refinement_remainder_0_difference(i) mod 2048, (refinement_remainder_0(i - 1) mod 1024) * 2);
    end loop;
    -- map
    map_out_disparity_0 <= (((((refinement_disparity_0(11) + (refinement_fraction_0 / 16)) * 2) +
      ((refinement_fraction_0 mod 16) / 8) + 8191) mod 8192) * 8) + (refinement_fraction_0 mod 8);
    map_out_passed_0 <= refinement_passed_0(11);
    map_out_valid <= refinement_tag_valid(11) and refinement_tag_output_column(11);
    map_out_start_of_frame <= refinement_tag_start_of_frame(11) and refinement_tag_valid(11) and
      refinement_tag_output_column(11);
    map_out_end_of_line <= refinement_tag_end_of_line(11) and refinement_tag_valid(11) and
      refinement_tag_output_column(11);
    -- other
    other_0 <= slice0winner1_best_cost_0_is_less(2);
    other(1) <= other(2);
    other(2) <= (as_number(transform_valid) * 256) + as_number(((transform_counter_column = 4) and
      (transform_counter_group = 4)));
    other_3 <= slice0winner1_best_cost_0_is_less(4);
    other_4 <= ((refinement_remainder_0_difference(7) / 4096) * 2) + ((other_5 / 4) * 4);
    other_5 <= ((refinement_remainder_0_difference(6) / 4096) * 4) + ((other_6 / 8) * 8);
    other_6 <= ((refinement_remainder_0_difference(5) / 4096) * 8) + ((other_7 / 16) * 16);
    other_7 <= ((refinement_remainder_0_difference(4) / 4096) * 16) + ((other_8 / 32) * 32);
    other_8 <= ((refinement_remainder_0_difference(3) / 4096) * 32) + ((other_9 / 64) * 64);
    other_9 <= ((refinement_remainder_0_difference(2) / 4096) * 64) + ((other_10 / 128) * 128);
    other_10 <= (refinement_remainder_1_0_difference / 4096) * 128;
    others_from_11(11) <= slice1winner1_best_cost_0_is_less(2);
    others_from_11(12) <= slice1winner1_best_cost_0_is_less(4);
    other_13 <= (((transform_right_code_next_row_outer(0) / 2) - transform_right_code_next_row_centre(0)) mod 32768) *
      2;
    others_from_14(14) <= as_number(((transform_right_code_row_before(0) - transform_right_code_row_after(0)) < 0)) *
      8192;
    others_from_14(15) <= as_number((((other_16 / 2) - transform_right_code_row_centre(0)) < 0)) * 8192;
    other_16 <= ((transform_right_code_row_box_0(0) + transform_right_code_row_column(0, 3)) / 2) * 2;
    other_17 <= (((transform_left_code_next_row_outer(0) / 2) - transform_left_code_next_row_centre(0)) mod 32768) * 2;
    others_from_18(18) <= as_number(((transform_left_code_row_before(0) - transform_left_code_row_after(0)) < 0)) *
      8192;
    others_from_18(19) <= as_number((((other_20 / 2) - transform_left_code_row_centre(0)) < 0)) * 8192;
    other_20 <= ((transform_left_code_row_box_0(0) + transform_left_code_row_column(0, 3)) / 2) * 2;
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 244;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_ready_column <= 0;
      transform_write_column <= 0; transform_columns_start_of_frame <= false; transform_columns_valid <= false;
      for i in 0 to 7 loop
        transform_filtering_start_of_frame(i) <= false; transform_filtering_valid(i) <= false;
      end loop;
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 244; delay_ring_read_address <= 1;
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
      slice0window_centre_start_of_frame_0 <= false; slice0window_centre_start_of_frame_3 <= false;
      slice0window_centre_end_of_line_0 <= false; slice0window_tag <= (others => false);
      slice0winner1_tag <= (others => false); slice0winner2_tag <= (others => false);
      slice0winner3_tag <= (others => false); slice0winner4_tag <= (others => false);
      slice0_best_tag <= (others => false); slice1cost_read_column <= 0; slice1cost_change_column <= 0;
      slice1cost_ready_column <= 0; slice1cost_write_column <= 0; slice1window_ring_read_address <= 1;
      slice1window_ring_write_address <= 0; slice1window_centre_output_column <= (others => false);
      slice1window_centre_start_of_frame <= (others => false); slice1window_centre_end_of_line <= (others => false);
      slice1_best_tag <= (others => false);
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_output_column(i) <= false;
        refinement_tag_start_of_frame(i) <= false; refinement_tag_end_of_line(i) <= false;
      end loop;
      map_out_valid <= false; map_out_start_of_frame <= false; map_out_end_of_line <= false; other <= (others => 0);
    end if;
  end process;
end architecture;
