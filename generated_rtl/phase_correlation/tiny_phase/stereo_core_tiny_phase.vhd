-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, phase correlation, configuration tiny_phase: 40x18, 12 disparities, window 5x5, phase of 2 scales, 1 pixel pair a clock.
-- Options: disparities 12, window_px 5, subpixel true, slice_disparities 6.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_phase
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_phase is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 18;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 28;
    latency_clocks : positive := 41;
    flush_groups : positive := 245;
    gap_groups : natural := 0
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
  assert width_px = 40 report "stereo_core_tiny_phase: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 18 report "stereo_core_tiny_phase: height_px is " & integer'image(height_px) & " but this core has 18" severity failure;
  assert disparities = 12 report "stereo_core_tiny_phase: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_phase: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_tiny_phase: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 28 report "stereo_core_tiny_phase: output_width_px is " & integer'image(output_width_px) & " but this core has 28" severity failure;
  assert latency_clocks = 41 report "stereo_core_tiny_phase: latency_clocks is " & integer'image(latency_clocks) & " but this core has 41" severity failure;
  assert flush_groups = 245 report "stereo_core_tiny_phase: flush_groups is " & integer'image(flush_groups) & " but this core has 245" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_phase: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_phase is
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
  type natural_1021_1d is array (natural range <>) of natural range 0 to 1021;
  type natural_1021_2d is array (natural range <>, natural range <>) of natural range 0 to 1021;
  type natural_11_1d is array (natural range <>) of natural range 0 to 11;
  type natural_12247_1d is array (natural range <>) of natural range 0 to 12247;
  type natural_1530_1d is array (natural range <>) of natural range 0 to 1530;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_190_1d is array (natural range <>) of natural range 0 to 190;
  type natural_19_1d is array (natural range <>) of natural range 0 to 19;
  type natural_19_2d is array (natural range <>, natural range <>) of natural range 0 to 19;
  type natural_2041_1d is array (natural range <>) of natural range 0 to 2041;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_257_1d is array (natural range <>) of natural range 0 to 257;
  type natural_285_1d is array (natural range <>) of natural range 0 to 285;
  type natural_3063_1d is array (natural range <>) of natural range 0 to 3063;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_380_1d is array (natural range <>) of natural range 0 to 380;
  type natural_38_2d is array (natural range <>, natural range <>) of natural range 0 to 38;
  type natural_4082_1d is array (natural range <>) of natural range 0 to 4082;
  type natural_4082_2d is array (natural range <>, natural range <>) of natural range 0 to 4082;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_4095_2d is array (natural range <>, natural range <>) of natural range 0 to 4095;
  type natural_475_1d is array (natural range <>) of natural range 0 to 475;
  type natural_510_1d is array (natural range <>) of natural range 0 to 510;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_513_to_2046_1d is array (natural range <>) of natural range 513 to 2046;
  type natural_5_1d is array (natural range <>) of natural range 0 to 5;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_8164_1d is array (natural range <>) of natural range 0 to 8164;
  type natural_8192_1d is array (natural range <>) of natural range 0 to 8192;
  type natural_95_1d is array (natural range <>) of natural range 0 to 95;
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type tag_5 is record
    valid, border_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_start_of_frame, in_valid : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
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
    transform_centre_column, transform_left_code_row_signs : natural range 0 to 63;
  signal transform_left_code_earlier : natural_63_1d(0 to 1);
  signal transform_left_code_bits, transform_left_code_next_row_signs, transform_left_code_next_bits,
    transform_right_code_row_signs : natural range 0 to 63;
  signal transform_right_code_earlier : natural_63_1d(0 to 1);
  signal transform_right_code_bits, transform_right_code_next_row_signs,
    transform_right_code_next_bits : natural range 0 to 63;
  signal transform_counter_group : natural range 0 to 31;
  signal transform_left_rows_read_words, transform_left_rows_ready_words, transform_left_rows_write_words,
    transform_right_rows_read_words, transform_right_rows_ready_words,
    transform_right_rows_write_words : unsigned_32_1d(0 to 1);
  signal transform_left_rows_read_words_2, transform_right_rows_read_words_2 : unsigned(7 downto 0);
  signal transform_centre_group : natural range 0 to 32;
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
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 31;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 4095;
  signal delay_delayed_0 : unsigned(11 downto 0);
  signal delay_column : natural range 0 to 63;
  signal delay_row_inside : boolean_1d(0 to 4);
  signal delay_tag : tag_5;
  -- rows
  signal rows_search_rows_read_words, rows_reference_rows_read_words : unsigned_24_1d(0 to 1);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 4095;
  signal rows_search, rows_reference : natural_4095_1d(0 to 4);
  signal rows_search_rows_ready_words, rows_search_rows_write_words, rows_reference_rows_ready_words,
    rows_reference_rows_write_words : natural_16777215_1d(0 to 1);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 63;
  signal rows_read_inside : boolean_1d(0 to 4);
  signal rows_read_tag : tag_5;
  signal rows_ready_inside : boolean_1d(0 to 4);
  signal rows_ready_tag, rows_tag : tag_5;
  -- slice0shift
  signal slice0shift_search : natural_4095_2d(0 to 4, 0 to 5);
  signal slice0shift_reference, slice0shift_search_out : natural_4095_1d(0 to 4);
  signal slice0shift_tag : tag_5;
  -- slice0cost
  signal slice0cost_pixels_first : natural_255_2d(0 to 4, 0 to 5);
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_pair_tag, slice0cost_tag : tag_5;
  signal slice0cost_pixels_cost : natural_19_2d(0 to 4, 0 to 5);
  signal slice0cost_single_0 : natural_19_1d(0 to 5);
  signal slice0cost_pair : natural_38_2d(0 to 1, 0 to 5);
  signal slice0cost_column_0 : natural_95_1d(0 to 5);
  -- slice0window
  signal slice0window_partial_0_0 : natural_95_1d(0 to 5);
  signal slice0window_partial_0_1 : natural_190_1d(0 to 5);
  signal slice0window_partial_0_2 : natural_285_1d(0 to 5);
  signal slice0window_partial_0_3 : natural_380_1d(0 to 5);
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0,
    slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_4;
  signal slice0window_sum_0 : natural_475_1d(0 to 5);
  -- slice0winner1
  signal slice0winner1_best_cost_0, slice0winner1_best_below_0, slice0winner1_best_above_0,
    slice0winner1_best_first_0 : natural_475_1d(0 to 2);
  signal slice0winner1_best_last_0 : natural_475_1d(0 to 1);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_tag : tag_4;
  signal slice0winner1_best_index_0 : natural_5_1d(1 to 2);  -- _# up to 3, 5
  -- slice0winner2
  signal slice0winner2_best_cost_0, slice0winner2_best_below_0, slice0winner2_best_above_0,
    slice0winner2_best_first_0 : natural_475_1d(0 to 1);
  signal slice0winner2_best_last_0_0 : natural range 0 to 475;
  signal slice0winner2_best_index_0 : natural_5_1d(0 to 1);  -- _# up to 3, 5
  signal slice0winner2_tag : tag_4;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_below_0_0, slice0winner3_best_above_0_0,
    slice0winner3_best_first_0_0 : natural range 0 to 475;
  signal slice0winner3_best_index_0_0 : natural range 0 to 5;
  signal slice0winner3_tag : tag_4;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_below_0_0, slice0_best_above_0_0,
    slice0_best_first_0_0 : natural range 0 to 475;
  signal slice0_best_index_0_0 : natural range 0 to 11;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_4095_2d(0 to 4, 0 to 5);
  signal slice1shift_reference : natural_4095_1d(0 to 4);
  -- slice1cost
  signal slice1cost_pixels_first : natural_255_2d(0 to 4, 0 to 5);
  signal slice1cost_pixels_cost : natural_19_2d(0 to 4, 0 to 5);
  signal slice1cost_single_0 : natural_19_1d(0 to 5);
  signal slice1cost_pair : natural_38_2d(0 to 1, 0 to 5);
  signal slice1cost_column_0 : natural_95_1d(0 to 5);
  -- slice1window
  signal slice1window_partial_0_0 : natural_95_1d(0 to 5);
  signal slice1window_partial_0_1 : natural_190_1d(0 to 5);
  signal slice1window_partial_0_2 : natural_285_1d(0 to 5);
  signal slice1window_partial_0_3 : natural_380_1d(0 to 5);
  signal slice1window_centre_output_column_0, slice1window_centre_start_of_frame_0,
    slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0 : natural_475_1d(0 to 5);
  -- slice1winner1
  signal slice1winner1_best_cost_0, slice1winner1_best_below_0, slice1winner1_best_above_0 : natural_475_1d(0 to 2);
  signal slice1winner1_best_first_0 : natural_475_1d(1 to 2);
  signal slice1winner1_best_last_0 : natural_475_1d(0 to 2);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_5_1d(1 to 2);  -- _# up to 3, 5
  -- slice1winner2
  signal slice1winner2_best_cost_0, slice1winner2_best_below_0, slice1winner2_best_above_0 : natural_475_1d(0 to 1);
  signal slice1winner2_best_first_0_1 : natural range 0 to 475;
  signal slice1winner2_best_last_0 : natural_475_1d(0 to 1);
  signal slice1winner2_best_index_0 : natural_5_1d(0 to 1);  -- _# up to 3, 5
  -- slice1winner3
  signal slice1winner3_best_cost_0_0, slice1winner3_best_below_0_0, slice1winner3_best_above_0_0,
    slice1winner3_best_last_0_0 : natural range 0 to 475;
  signal slice1winner3_best_index_0_0 : natural range 0 to 5;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 475;
  signal slice1_best_index_0_0 : natural range 0 to 11;
  signal slice1_best_tag : tag_4;
  -- refinement
  signal refinement_disparity_0 : natural_11_1d(0 to 11);  -- _#_0
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- _#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- _#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- _#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- _#_end_of_line
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_cost_0, refinement_below_0, refinement_above_0 : natural range 0 to 475;
  signal refinement_remainder_0 : natural_511_1d(0 to 7);  -- _#_0 up to 475, 511 x 7
  signal refinement_u_0, refinement_v_0 : natural range 0 to 511;
  signal refinement_divisor_0 : natural_511_1d(0 to 7);  -- _#_0
  signal refinement_difference_0 : integer range -475 to 475;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_out_disparity_0 : natural range 0 to 65535;
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  -- other
  signal other_0 : natural range 0 to 254;
  signal other_1 : natural range 0 to 252;
  signal other_2 : natural range 0 to 248;
  signal other_3 : natural range 0 to 240;
  signal other_4 : natural range 0 to 224;
  signal other_5 : natural range 0 to 192;
  signal other_6 : natural range 0 to 128;
  signal other_7, other_11 : natural range 0 to 65534;
  signal other : natural_8192_1d(8 to 9);
  signal others_from_12 : natural_8192_1d(12 to 13);  -- other_#
  signal other_10, other_14 : natural range 0 to 2042;
  signal others_from_15 : natural_257_1d(15 to 16);  -- other_#

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

  delay_delayed_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 4);
    write_address <= to_unsigned(delay_ring_write_address, 4);
    write_data <= to_unsigned(raster_features_reference_0, 12);
    cell : entity work.line_memory generic map (12, 12, 4)
      port map (clock, true, read_address, delay_delayed_0, write_address, write_data);
  end block;

  transform_left_rows_read_words_2_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 6);
    write_address <= to_unsigned(transform_write_column, 6);
    write_data <= to_unsigned(transform_left_rows_write_words_2, 8);
    cell : entity work.line_memory generic map (40, 8, 6)
      port map (clock, true, read_address, transform_left_rows_read_words_2, write_address, write_data);
  end block;

  transform_left_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 6);
    write_address <= to_unsigned(transform_write_column, 6);
    cell : entity work.line_memory generic map (40, 32, 6)
      port map (clock, true, read_address, transform_left_rows_read_words(i), write_address,
        transform_left_rows_write_words(i));
  end generate;

  transform_right_rows_read_words_2_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 6);
    write_address <= to_unsigned(transform_write_column, 6);
    write_data <= to_unsigned(transform_right_rows_write_words_2, 8);
    cell : entity work.line_memory generic map (40, 8, 6)
      port map (clock, true, read_address, transform_right_rows_read_words_2, write_address, write_data);
  end block;

  transform_right_rows_read_words_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 6);
    write_address <= to_unsigned(transform_write_column, 6);
    cell : entity work.line_memory generic map (40, 32, 6)
      port map (clock, true, read_address, transform_right_rows_read_words(i), write_address,
        transform_right_rows_write_words(i));
  end generate;

  process
    variable transform_counter_group_is_equals, raster_place_group_is_equals : boolean_1d(1 to 3);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_choice_2, transform_centre_column_any,
      transform_up_to_last_0_is_equal, transform_counter_next_frame_choice, raster_place_group_all,
      delay_row_inside_2_is_less, slice0winner2_best_cost_0_0_is_less, slice0winner3_best_cost_0_0_is_less,
      slice1winner2_best_cost_0_0_is_less, slice1winner3_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less,
      refinement_divisor_0_0_is_less : boolean;
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 9;
    variable transform_counter_group_choices : natural_31_1d(3 to 4);  -- _choice_#
    variable transform_centre_column_choice : natural range 9 to 15;
    variable transform_from_first_is_equal : boolean_1d(0 to 1);  -- _#_is_equal
    variable transform_from_first_value : boolean_1d(0 to 1);  -- _#_value
    variable transform_from_first_1_choices, transform_up_to_last_0_choices : boolean_1d(1 to 2);  -- _choice_#
    variable raster_place_group_choices : natural_31_1d(2 to 3);  -- _choice_#
    variable raster_place_next_frame_choices : boolean_1d(1 to 3);  -- _choice_#
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable slice0winner2_best_below_0_0_choice, slice0winner2_best_above_0_0_choice,
      slice0winner3_best_below_0_0_choice, slice0winner3_best_above_0_0_choice, slice1winner2_best_below_0_0_choice,
      slice1winner2_best_above_0_0_choice, slice1winner3_best_below_0_0_choice, slice1winner3_best_above_0_0_choice,
      slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 475;
    variable refinement_remainder_1_0_difference : natural range 513 to 1499;
    variable refinement_remainder_0_difference : natural_513_to_2046_1d(2 to 7);  -- _#_0_difference
    variable refinement_divisor_0_0_choice : natural range 0 to 511;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
  begin
    wait until rising_edge(clock);
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_column = 39;
    transform_counter_group_is_equals(2) := transform_counter_group = 17;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 9, 0);
    transform_counter_group_choice_2 := choice((transform_counter_group / 2) = 11, transform_counter_group_is_equals(1)
      and in_valid and is_set(transform_counter_group, 0), transform_counter_group_is_equals(1) and in_valid);
    transform_counter_group_is_equals(3) := transform_counter_group = 21;
    transform_counter_group_choices(3) := choice(transform_counter_next_frame and transform_counter_group_is_equals(3),
      4, (transform_counter_group + 1) mod 32);
    transform_counter_group_choices(4) := choice(transform_counter_group_choice_2, transform_counter_group_choices(3),
      transform_counter_group);
    transform_centre_column_any := is_set(transform_counter_column, 5) or is_set(transform_counter_column, 4) or
      is_set(transform_counter_column, 3) or is_set(transform_counter_column, 2);
    transform_centre_column_choice := choice(transform_centre_column_any, 15, 9);
    transform_from_first_is_equal(0) := ((transform_centre_column / 4) mod 8) = 0;
    transform_from_first_value(0) := is_set(transform_centre_column, 1);
    transform_from_first_is_equal(1) := ((transform_centre_column / 4) mod 4) = 0;
    transform_from_first_value(1) := is_set(transform_centre_column, 3);
    transform_from_first_1_choices(1) := choice(transform_from_first_value(0), transform_from_first_is_equal(1), not
      transform_from_first_value(1));
    transform_from_first_1_choices(2) := choice(is_set(transform_centre_column, 0), transform_from_first_is_equal(1),
      transform_from_first_1_choices(1));
    transform_up_to_last_0_choices(1) := choice(transform_from_first_value(0), transform_from_first_is_equal(0),
      ((transform_centre_column / 8) mod 4) = 0);
    transform_up_to_last_0_is_equal := (transform_centre_group / 16) = 0;
    transform_up_to_last_0_choices(2) := choice((not is_set(transform_centre_group, 3)) and ((not
      is_set(transform_centre_group, 2)) or ((transform_centre_group mod 4) = 0)), not is_set(transform_centre_group,
      5), transform_up_to_last_0_is_equal);
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
    transform_centre_column <= (((transform_centre_column_choice + (transform_counter_column / 4)) mod 16) * 4) +
      (transform_counter_column mod 4);
    transform_centre_group <= transform_counter_group + as_number(transform_centre_column_any);
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
    transform_columns_start_of_frame <= is_set(others_from_15(15), 0);
    transform_columns_valid <= is_set(others_from_15(15), 8);
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
    transform_left_code_row_signs <= ((others_from_12(12) / 8192) * 2) + (others_from_12(13) / 8192) +
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
    transform_left_code_next_row_signs <= (other_11 / 32768) + ((transform_left_code_next_row_odd(0) / 32768) * 2) +
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
    transform_right_code_row_signs <= ((other(8) / 8192) * 2) + (other(9) / 8192) +
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
    transform_right_code_next_row_signs <= (other_7 / 32768) + ((transform_right_code_next_row_odd(0) / 32768) * 2) +
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
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice * 2,
      transform_counter_group_choices(4));
    transform_from_first(0) <= choice(transform_from_first_is_equal(0), (not (((not is_set(transform_centre_group, 2))
      or (not is_set(transform_centre_group, 1)) or (not is_set(transform_centre_group, 0))) and
      ((transform_centre_group / 8) = 0))) and (is_set(transform_centre_column, 5) or transform_from_first_value(0)),
      not (((not is_set(transform_centre_group, 2)) or (not is_set(transform_centre_group, 1)) or (not
      is_set(transform_centre_group, 0))) and ((transform_centre_group / 8) = 0)));
    transform_from_first(1) <= choice((not is_set(transform_centre_group, 4)) and ((not is_set(transform_centre_group,
      3)) or (((transform_centre_group / 2) mod 4) = 0)), (not (transform_from_first_1_choices(2) and
      ((transform_centre_column / 16) = 0))) and is_set(transform_centre_group, 5), not
      (transform_from_first_1_choices(2) and ((transform_centre_column / 16) = 0)));
    transform_up_to_last(0) <= choice(transform_up_to_last_0_choices(1), transform_up_to_last_0_choices(2),
      transform_up_to_last_0_choices(2) and (not is_set(transform_centre_column, 5)));
    transform_up_to_last(1) <= choice(((not is_set(transform_centre_group, 1)) or (not is_set(transform_centre_group,
      0))) and (((transform_centre_group / 4) mod 4) = 0), (not (is_set(transform_centre_column, 5) and
      (is_set(transform_centre_column, 4) or transform_from_first_value(1) or is_set(transform_centre_column, 2)))) and
      (not is_set(transform_centre_group, 5)), (not (is_set(transform_centre_column, 5) and
      (is_set(transform_centre_column, 4) or transform_from_first_value(1) or is_set(transform_centre_column, 2)))) and
      transform_up_to_last_0_is_equal);
    transform_left_code_bits <= choice(transform_filtering_inside(6, 0), transform_left_code_earlier(1), 0);
    transform_right_code_bits <= choice(transform_filtering_inside(6, 0), transform_right_code_earlier(1), 0);
    transform_left_code_next_bits <= choice(transform_filtering_inside(6, 1), transform_left_code_next_row_signs, 0);
    transform_right_code_next_bits <= choice(transform_filtering_inside(6, 1), transform_right_code_next_row_signs, 0);
    transform_counter_next_frame_choice := choice(in_start_of_frame, transform_counter_group_all,
      transform_counter_next_frame);
    if in_valid then
      transform_counter_column <= choice(transform_counter_group_is_equals(1) or in_start_of_frame, 0,
        (transform_counter_column + 1) mod 64);
      transform_counter_next_frame <= choice(transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(3), transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2) and in_start_of_frame, transform_counter_next_frame_choice);
    end if;
    if is_set(others_from_15(15), 8) then
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
    raster_place_group_is_equals(1) := raster_place_column = 39;
    raster_place_group_is_equals(2) := raster_place_group = 17;
    raster_place_group_all := raster_place_group_is_equals(1) and raster_place_group_is_equals(2);
    raster_place_group_choice := choice(raster_place_group_all, 9, 0);
    raster_place_group_is_equals(3) := raster_place_group = 19;
    raster_place_group_choices(2) := choice(raster_place_next_frame and raster_place_group_is_equals(3), 2,
      (raster_place_group + 1) mod 32);
    raster_place_group_choices(3) := choice((raster_place_group /= 20) and raster_place_group_is_equals(1) and
      transform_filtering_valid(7), raster_place_group_choices(2), raster_place_group);
    raster_place_next_frame_choices(1) := choice(raster_place_group_is_equals(3), (raster_place_column /= 39) and
      raster_place_next_frame, raster_place_next_frame);
    raster_place_next_frame_choices(2) := choice(raster_place_group_all, transform_filtering_valid(7),
      transform_filtering_valid(7) and (not transform_filtering_start_of_frame(7)));
    raster_place_next_frame_choices(3) := choice(raster_place_next_frame_choices(1),
      raster_place_next_frame_choices(2), raster_place_group_is_equals(1) and raster_place_group_is_equals(2) and
      transform_filtering_valid(7) and transform_filtering_start_of_frame(7));
    raster_features_search_0 <= (transform_left_code_next_bits * 64) + transform_left_code_bits;
    raster_features_reference_0 <= (transform_right_code_next_bits * 64) + transform_right_code_bits;
    raster_features_valid <= transform_filtering_valid(7);
    raster_place_next_frame <= raster_place_next_frame_choices(3) or ((not transform_filtering_valid(7)) and
      raster_place_next_frame);
    raster_place_group <= choice(transform_filtering_valid(7) and transform_filtering_start_of_frame(7),
      raster_place_group_choice * 2, raster_place_group_choices(3));
    if transform_filtering_valid(7) then
      raster_place_column <= choice(raster_place_group_is_equals(1) or transform_filtering_start_of_frame(7), 0,
        (raster_place_column + 1) mod 64);
    end if;
    -- delay
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 11, 0, (delay_ring_read_address + 1) mod 16);
    end if;
    delay_row_inside_2_is_less := (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) <
      18;
    delay_ahead_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) < 18;
    delay_row_inside(1) <= (raster_place_group >= 3) and (raster_place_group < 21);
    delay_row_inside(2) <= delay_row_inside_2_is_less;
    delay_row_inside(3) <= (raster_place_group >= 1) and (raster_place_group < 19);
    delay_row_inside(4) <= (not is_set(raster_place_group, 4)) or (((raster_place_group / 2) mod 8) = 0);
    delay_tag.valid <= raster_features_valid;
    delay_tag.border_column <= (not (is_set(raster_place_column, 3) and (is_set(raster_place_column, 2) or
      ((raster_place_column mod 4) = 3)))) and ((raster_place_column / 16) = 0);
    delay_tag.output_column <= delay_row_inside_2_is_less and (raster_place_column >= 11) and (raster_place_column <
      39);
    delay_tag.start_of_frame <= (raster_place_column = 11) and (raster_place_group = 2);
    delay_tag.end_of_line <= raster_place_column = 38;
    -- rows
    rows_search_rows_read_newest_0 <= delay_ahead_0;
    rows_search_rows_ready_words(0) <= to_integer(rows_search_rows_read_words(0));
    rows_search_rows_ready_words(1) <= to_integer(rows_search_rows_read_words(1));
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
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
    for i in 0 to 1 loop
      rows_search(2 * i) <= choice(rows_ready_inside(2 * i), rows_search_rows_ready_words(i) mod 4096, 0);
      rows_reference(2 * i) <= choice(rows_ready_inside(2 * i), rows_reference_rows_ready_words(i) mod 4096, 0);
      rows_search(2 * i + 1) <= choice(rows_ready_inside(2 * i + 1), rows_search_rows_ready_words(i) / 4096, 0);
      rows_reference(2 * i + 1) <= choice(rows_ready_inside(2 * i + 1), rows_reference_rows_ready_words(i) / 4096, 0);
    end loop;
    rows_search(4) <= choice(rows_ready_inside(4), rows_search_rows_ready_newest_0, 0);
    rows_reference(4) <= choice(rows_ready_inside(4), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words(0) <= (rows_search_rows_ready_words(0) / 4096) + ((rows_search_rows_ready_words(1)
        mod 4096) * 4096);
      rows_search_rows_write_words(1) <= (rows_search_rows_ready_words(1) / 4096) + (rows_search_rows_ready_newest_0 *
        4096);
      rows_reference_rows_write_words(0) <= (rows_reference_rows_ready_words(0) / 4096) +
        ((rows_reference_rows_ready_words(1) mod 4096) * 4096);
      rows_reference_rows_write_words(1) <= (rows_reference_rows_ready_words(1) / 4096) +
        (rows_reference_rows_ready_newest_0 * 4096);
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 4 loop
        for j in 0 to 4 loop slice0shift_search(i, j) <= slice0shift_search(i, j + 1); end loop;
        slice0shift_search(i, 5) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    for i in 0 to 4 loop slice0shift_search_out(i) <= slice0shift_search(i, 0); end loop;
    slice0shift_tag <= rows_tag;
    -- slice0cost
    for i in 0 to 4 loop
      slice0cost_pixels_first(i, 0) <= ((differing(slice0shift_reference(i), slice0shift_search(i, 0), 3, 5, 4)) * 4) +
        differing(slice0shift_reference(i), slice0shift_search(i, 0), 0) + differing(slice0shift_reference(i),
        slice0shift_search(i, 0), 2) + differing(slice0shift_reference(i), slice0shift_search(i, 0), 1) +
        ((differing(slice0shift_reference(i), slice0shift_search(i, 0), 6, 8, 7)) * 16) +
        ((differing(slice0shift_reference(i), slice0shift_search(i, 0), 9, 11, 10)) * 64);
      for j in 1 to 5 loop
        slice0cost_pixels_first(i, j) <= ((differing(slice0shift_search(i, j), slice0shift_reference(i), 3, 5, 4)) * 4)
          + differing(slice0shift_search(i, j), slice0shift_reference(i), 0) + differing(slice0shift_search(i, j),
          slice0shift_reference(i), 2) + differing(slice0shift_search(i, j), slice0shift_reference(i), 1) +
          ((differing(slice0shift_search(i, j), slice0shift_reference(i), 6, 8, 7)) * 16) +
          ((differing(slice0shift_search(i, j), slice0shift_reference(i), 9, 11, 10)) * 64);
      end loop;
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 4 loop
      for j in 0 to 5 loop
        slice0cost_pixels_cost(i, j) <= (((slice0cost_pixels_first(i, j) mod 4) + (((slice0cost_pixels_first(i, j) / 2)
          mod 8) / 2) + ((((slice0cost_pixels_first(i, j) / 16) mod 4) + (slice0cost_pixels_first(i, j) / 64)) / 2)) *
          2) + (((slice0cost_pixels_first(i, j) / 16) + (slice0cost_pixels_first(i, j) / 64)) mod 2);
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    for i in 0 to 5 loop slice0cost_pair(0, i) <= slice0cost_pixels_cost(1, i) + slice0cost_pixels_cost(2, i); end loop;
    for i in 0 to 5 loop slice0cost_pair(1, i) <= slice0cost_pixels_cost(3, i) + slice0cost_pixels_cost(4, i); end loop;
    for i in 0 to 5 loop slice0cost_single_0(i) <= slice0cost_pixels_cost(0, i); end loop;
    slice0cost_pair_tag <= slice0cost_pixels_tag;
    slice0cost_tag <= slice0cost_pair_tag;
    for i in 0 to 5 loop
      slice0cost_column_0(i) <= choice(slice0cost_pair_tag.border_column, 0, slice0cost_single_0(i) +
        slice0cost_pair(0, i) + slice0cost_pair(1, i));
    end loop;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_partial_0_0 <= slice0cost_column_0;
      for i in 0 to 5 loop
        slice0window_partial_0_1(i) <= slice0window_partial_0_0(i) + slice0cost_column_0(i);
      end loop;
      for i in 0 to 5 loop
        slice0window_partial_0_2(i) <= slice0window_partial_0_1(i) + slice0cost_column_0(i);
      end loop;
      for i in 0 to 5 loop
        slice0window_partial_0_3(i) <= slice0window_partial_0_2(i) + slice0cost_column_0(i);
      end loop;
    end if;
    slice0window_centre_output_column_0 <= slice0cost_tag.output_column;
    slice0window_centre_start_of_frame_0 <= slice0cost_tag.start_of_frame;
    slice0window_centre_end_of_line_0 <= slice0cost_tag.end_of_line;
    for i in 0 to 5 loop slice0window_sum_0(i) <= slice0window_partial_0_3(i) + slice0cost_column_0(i); end loop;
    slice0window_tag.valid <= slice0cost_tag.valid;
    if slice0window_tag.valid then
      slice0window_tag.output_column <= slice1window_centre_output_column_0;
      slice0window_tag.start_of_frame <= slice1window_centre_start_of_frame_0;
      slice0window_tag.end_of_line <= slice1window_centre_end_of_line_0;
    end if;
    -- slice0winner1
    slice0winner1_best_cost_0_is_less(0) := (slice0window_sum_0(1) - slice0window_sum_0(0)) < 0;
    slice0winner1_best_cost_0_is_less(1) := (slice0window_sum_0(3) - slice0window_sum_0(2)) < 0;
    slice0winner1_best_cost_0_is_less(2) := (slice0window_sum_0(5) - slice0window_sum_0(4)) < 0;
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    slice0winner1_best_first_0(0) <= slice0window_sum_0(0);
    slice0winner1_best_first_0(1) <= slice0window_sum_0(2);
    slice0winner1_best_first_0(2) <= slice0window_sum_0(4);
    slice0winner1_best_last_0(0) <= slice0window_sum_0(1);
    slice0winner1_best_last_0(1) <= slice0window_sum_0(3);
    slice0winner1_tag <= slice0window_tag;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0window_sum_0(1),
      slice0window_sum_0(0));
    for i in 0 to 1 loop
      slice0winner1_best_below_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0window_sum_0(2 * i), 0);
      slice0winner1_best_above_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 0, slice0window_sum_0(2 * i + 1));
      slice0winner1_best_cost_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), slice0window_sum_0(2 * i +
        3), slice0window_sum_0(2 * i + 2));
      slice0winner1_best_index_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice0winner1_best_below_0(2) <= choice(slice0winner1_best_cost_0_is_less(2), slice0window_sum_0(4), 0);
    slice0winner1_best_above_0(2) <= choice(slice0winner1_best_cost_0_is_less(2), 0, slice0window_sum_0(5));
    -- slice0winner2
    slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0(1) - slice0winner1_best_cost_0(0)) < 0;
    slice0winner2_best_below_0_0_choice := choice(slice0winner1_best_index_0(1) = 2, slice0winner1_best_last_0(0),
      slice0winner1_best_below_0(1));
    slice0winner2_best_above_0_0_choice := choice(slice0winner1_best_index_0_0, slice0winner1_best_first_0(1),
      slice0winner1_best_above_0(0));
    slice0winner2_best_cost_0(1) <= slice0winner1_best_cost_0(2);
    slice0winner2_best_index_0(1) <= slice0winner1_best_index_0(2);
    slice0winner2_best_below_0(1) <= slice0winner1_best_below_0(2);
    slice0winner2_best_above_0(1) <= slice0winner1_best_above_0(2);
    slice0winner2_best_first_0(0) <= slice0winner1_best_first_0(0);
    slice0winner2_best_first_0(1) <= slice0winner1_best_first_0(2);
    slice0winner2_best_last_0_0 <= slice0winner1_best_last_0(1);
    slice0winner2_tag <= slice0winner1_tag;
    slice0winner2_best_cost_0(0) <= choice(slice0winner2_best_cost_0_0_is_less, slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_0_0_is_less, slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    slice0winner2_best_below_0(0) <= choice(slice0winner2_best_cost_0_0_is_less, slice0winner2_best_below_0_0_choice,
      slice0winner1_best_below_0(0));
    slice0winner2_best_above_0(0) <= choice(slice0winner2_best_cost_0_0_is_less, slice0winner1_best_above_0(1),
      slice0winner2_best_above_0_0_choice);
    -- slice0winner3
    slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
    slice0winner3_best_below_0_0_choice := choice(is_set(slice0winner2_best_index_0(1), 2) and (not
      is_set(slice0winner2_best_index_0(1), 0)), slice0winner2_best_last_0_0, slice0winner2_best_below_0(1));
    slice0winner3_best_above_0_0_choice := choice(slice0winner2_best_index_0(0) = 3, slice0winner2_best_first_0(1),
      slice0winner2_best_above_0(0));
    slice0winner3_best_first_0_0 <= slice0winner2_best_first_0(0);
    slice0winner3_tag <= slice0winner2_tag;
    slice0winner3_best_cost_0_0 <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_cost_0(1),
      slice0winner2_best_cost_0(0));
    slice0winner3_best_index_0_0 <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_index_0(1),
      slice0winner2_best_index_0(0));
    slice0winner3_best_below_0_0 <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner3_best_below_0_0_choice,
      slice0winner2_best_below_0(0));
    slice0winner3_best_above_0_0 <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_above_0(1),
      slice0winner3_best_above_0_0_choice);
    -- slice0
    slice0_best_cost_0_0 <= slice0winner3_best_cost_0_0;
    slice0_best_index_0_0 <= (((slice0winner3_best_index_0_0 / 2) + 3) * 2) + (slice0winner3_best_index_0_0 mod 2);
    slice0_best_below_0_0 <= slice0winner3_best_below_0_0;
    slice0_best_above_0_0 <= slice0winner3_best_above_0_0;
    slice0_best_first_0_0 <= slice0winner3_best_first_0_0;
    slice0_best_tag <= slice0winner3_tag;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 4 loop
        for j in 0 to 4 loop slice1shift_search(i, j) <= slice1shift_search(i, j + 1); end loop;
        slice1shift_search(i, 5) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    -- slice1cost
    for i in 0 to 4 loop
      slice1cost_pixels_first(i, 0) <= ((differing(slice1shift_reference(i), slice1shift_search(i, 0), 3, 5, 4)) * 4) +
        differing(slice1shift_reference(i), slice1shift_search(i, 0), 0) + differing(slice1shift_reference(i),
        slice1shift_search(i, 0), 2) + differing(slice1shift_reference(i), slice1shift_search(i, 0), 1) +
        ((differing(slice1shift_reference(i), slice1shift_search(i, 0), 6, 8, 7)) * 16) +
        ((differing(slice1shift_reference(i), slice1shift_search(i, 0), 9, 11, 10)) * 64);
      for j in 1 to 5 loop
        slice1cost_pixels_first(i, j) <= ((differing(slice1shift_search(i, j), slice1shift_reference(i), 3, 5, 4)) * 4)
          + differing(slice1shift_search(i, j), slice1shift_reference(i), 0) + differing(slice1shift_search(i, j),
          slice1shift_reference(i), 2) + differing(slice1shift_search(i, j), slice1shift_reference(i), 1) +
          ((differing(slice1shift_search(i, j), slice1shift_reference(i), 6, 8, 7)) * 16) +
          ((differing(slice1shift_search(i, j), slice1shift_reference(i), 9, 11, 10)) * 64);
      end loop;
    end loop;
    for i in 0 to 4 loop
      for j in 0 to 5 loop
        slice1cost_pixels_cost(i, j) <= (((slice1cost_pixels_first(i, j) mod 4) + (((slice1cost_pixels_first(i, j) / 2)
          mod 8) / 2) + ((((slice1cost_pixels_first(i, j) / 16) mod 4) + (slice1cost_pixels_first(i, j) / 64)) / 2)) *
          2) + (((slice1cost_pixels_first(i, j) / 16) + (slice1cost_pixels_first(i, j) / 64)) mod 2);
      end loop;
    end loop;
    for i in 0 to 5 loop slice1cost_pair(0, i) <= slice1cost_pixels_cost(1, i) + slice1cost_pixels_cost(2, i); end loop;
    for i in 0 to 5 loop slice1cost_pair(1, i) <= slice1cost_pixels_cost(3, i) + slice1cost_pixels_cost(4, i); end loop;
    for i in 0 to 5 loop slice1cost_single_0(i) <= slice1cost_pixels_cost(0, i); end loop;
    for i in 0 to 5 loop
      slice1cost_column_0(i) <= choice(slice0cost_tag.border_column, 0, slice1cost_single_0(i) + slice1cost_pair(0, i)
        + slice1cost_pair(1, i));
    end loop;
    -- slice1window
    if slice0window_tag.valid then
      slice1window_partial_0_0 <= slice1cost_column_0;
      for i in 0 to 5 loop
        slice1window_partial_0_1(i) <= slice1window_partial_0_0(i) + slice1cost_column_0(i);
      end loop;
      for i in 0 to 5 loop
        slice1window_partial_0_2(i) <= slice1window_partial_0_1(i) + slice1cost_column_0(i);
      end loop;
      for i in 0 to 5 loop
        slice1window_partial_0_3(i) <= slice1window_partial_0_2(i) + slice1cost_column_0(i);
      end loop;
      slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
      slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
      slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
    end if;
    for i in 0 to 5 loop slice1window_sum_0(i) <= slice1window_partial_0_3(i) + slice1cost_column_0(i); end loop;
    -- slice1winner1
    slice1winner1_best_cost_0_is_less(0) := (slice1window_sum_0(1) - slice1window_sum_0(0)) < 0;
    slice1winner1_best_cost_0_is_less(1) := (slice1window_sum_0(3) - slice1window_sum_0(2)) < 0;
    slice1winner1_best_cost_0_is_less(2) := (slice1window_sum_0(5) - slice1window_sum_0(4)) < 0;
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    slice1winner1_best_first_0(1) <= slice1window_sum_0(2);
    slice1winner1_best_first_0(2) <= slice1window_sum_0(4);
    slice1winner1_best_last_0(0) <= slice1window_sum_0(1);
    slice1winner1_best_last_0(1) <= slice1window_sum_0(3);
    slice1winner1_best_last_0(2) <= slice1window_sum_0(5);
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1window_sum_0(1),
      slice1window_sum_0(0));
    for i in 0 to 1 loop
      slice1winner1_best_below_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1window_sum_0(2 * i), 0);
      slice1winner1_best_above_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 0, slice1window_sum_0(2 * i + 1));
      slice1winner1_best_cost_0(i + 1) <= choice(slice1winner1_best_cost_0_is_less(i + 1), slice1window_sum_0(2 * i +
        3), slice1window_sum_0(2 * i + 2));
      slice1winner1_best_index_0(i + 1) <= choice(slice1winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice1winner1_best_below_0(2) <= choice(slice1winner1_best_cost_0_is_less(2), slice1window_sum_0(4), 0);
    slice1winner1_best_above_0(2) <= choice(slice1winner1_best_cost_0_is_less(2), 0, slice1window_sum_0(5));
    -- slice1winner2
    slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0(1) - slice1winner1_best_cost_0(0)) < 0;
    slice1winner2_best_below_0_0_choice := choice(slice1winner1_best_index_0(1) = 2, slice1winner1_best_last_0(0),
      slice1winner1_best_below_0(1));
    slice1winner2_best_above_0_0_choice := choice(slice1winner1_best_index_0_0, slice1winner1_best_first_0(1),
      slice1winner1_best_above_0(0));
    slice1winner2_best_cost_0(1) <= slice1winner1_best_cost_0(2);
    slice1winner2_best_index_0(1) <= slice1winner1_best_index_0(2);
    slice1winner2_best_below_0(1) <= slice1winner1_best_below_0(2);
    slice1winner2_best_above_0(1) <= slice1winner1_best_above_0(2);
    slice1winner2_best_first_0_1 <= slice1winner1_best_first_0(2);
    slice1winner2_best_last_0 <= slice1winner1_best_last_0(1 to 2);
    slice1winner2_best_cost_0(0) <= choice(slice1winner2_best_cost_0_0_is_less, slice1winner1_best_cost_0(1),
      slice1winner1_best_cost_0(0));
    slice1winner2_best_index_0(0) <= choice(slice1winner2_best_cost_0_0_is_less, slice1winner1_best_index_0(1),
      as_number(slice1winner1_best_index_0_0));
    slice1winner2_best_below_0(0) <= choice(slice1winner2_best_cost_0_0_is_less, slice1winner2_best_below_0_0_choice,
      slice1winner1_best_below_0(0));
    slice1winner2_best_above_0(0) <= choice(slice1winner2_best_cost_0_0_is_less, slice1winner1_best_above_0(1),
      slice1winner2_best_above_0_0_choice);
    -- slice1winner3
    slice1winner3_best_cost_0_0_is_less := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
    slice1winner3_best_below_0_0_choice := choice(is_set(slice1winner2_best_index_0(1), 2) and (not
      is_set(slice1winner2_best_index_0(1), 0)), slice1winner2_best_last_0(0), slice1winner2_best_below_0(1));
    slice1winner3_best_above_0_0_choice := choice(slice1winner2_best_index_0(0) = 3, slice1winner2_best_first_0_1,
      slice1winner2_best_above_0(0));
    slice1winner3_best_last_0_0 <= slice1winner2_best_last_0(1);
    slice1winner3_best_cost_0_0 <= choice(slice1winner3_best_cost_0_0_is_less, slice1winner2_best_cost_0(1),
      slice1winner2_best_cost_0(0));
    slice1winner3_best_index_0_0 <= choice(slice1winner3_best_cost_0_0_is_less, slice1winner2_best_index_0(1),
      slice1winner2_best_index_0(0));
    slice1winner3_best_below_0_0 <= choice(slice1winner3_best_cost_0_0_is_less, slice1winner3_best_below_0_0_choice,
      slice1winner2_best_below_0(0));
    slice1winner3_best_above_0_0 <= choice(slice1winner3_best_cost_0_0_is_less, slice1winner2_best_above_0(1),
      slice1winner3_best_above_0_0_choice);
    -- slice1
    slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner3_best_cost_0_0) < 0;
    slice1_best_below_0_0_choice := choice(slice0_best_index_0_0 = 6, slice1winner3_best_last_0_0,
      slice0_best_below_0_0);
    slice1_best_above_0_0_choice := choice(slice1winner3_best_index_0_0 = 5, slice0_best_first_0_0,
      slice1winner3_best_above_0_0);
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_cost_0_0, slice1winner3_best_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_index_0_0, slice1winner3_best_index_0_0);
    slice1_best_below_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1_best_below_0_0_choice,
      slice1winner3_best_below_0_0);
    slice1_best_above_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_above_0_0, slice1_best_above_0_0_choice);
    -- refinement
    refinement_remainder_1_0_difference := (refinement_remainder_0(0) + 1024) - refinement_divisor_0(0);
    for i in 2 to 7 loop
      refinement_remainder_0_difference(i) := ((refinement_remainder_0(i - 1) * 2) + 1024) - refinement_divisor_0(i -
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
    refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 512;
    refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 512;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 9)) or
      (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 9))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((1024 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 512) + ((other_0
      / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
    refinement_below_0 <= choice(slice1_best_index_0_0 = 0, slice1_best_above_0_0, slice1_best_below_0_0);
    refinement_above_0 <= choice(slice1_best_index_0_0 = 11, slice1_best_below_0_0, slice1_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 10),
      refinement_remainder_1_0_difference mod 512, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 10),
        refinement_remainder_0_difference(i) mod 512, (refinement_remainder_0(i - 1) mod 256) * 2);
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
    other_0 <= ((refinement_remainder_0_difference(7) / 1024) * 2) + ((other_1 / 4) * 4);
    other_1 <= ((refinement_remainder_0_difference(6) / 1024) * 4) + ((other_2 / 8) * 8);
    other_2 <= ((refinement_remainder_0_difference(5) / 1024) * 8) + ((other_3 / 16) * 16);
    other_3 <= ((refinement_remainder_0_difference(4) / 1024) * 16) + ((other_4 / 32) * 32);
    other_4 <= ((refinement_remainder_0_difference(3) / 1024) * 32) + ((other_5 / 64) * 64);
    other_5 <= ((refinement_remainder_0_difference(2) / 1024) * 64) + ((other_6 / 128) * 128);
    other_6 <= (refinement_remainder_1_0_difference / 1024) * 128;
    other_7 <= (((transform_right_code_next_row_outer(0) / 2) - transform_right_code_next_row_centre(0)) mod 32768) * 2;
    other(8) <= as_number(((transform_right_code_row_before(0) - transform_right_code_row_after(0)) < 0)) * 8192;
    other(9) <= as_number((((other_10 / 2) - transform_right_code_row_centre(0)) < 0)) * 8192;
    other_10 <= ((transform_right_code_row_box_0(0) + transform_right_code_row_column(0, 3)) / 2) * 2;
    other_11 <= (((transform_left_code_next_row_outer(0) / 2) - transform_left_code_next_row_centre(0)) mod 32768) * 2;
    others_from_12(12) <= as_number(((transform_left_code_row_before(0) - transform_left_code_row_after(0)) < 0)) *
      8192;
    others_from_12(13) <= as_number((((other_14 / 2) - transform_left_code_row_centre(0)) < 0)) * 8192;
    other_14 <= ((transform_left_code_row_box_0(0) + transform_left_code_row_column(0, 3)) / 2) * 2;
    others_from_15(15) <= others_from_15(16);
    others_from_15(16) <= (as_number(transform_valid) * 256) + as_number(((transform_counter_column = 4) and
      (transform_counter_group = 4)));
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 22;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_ready_column <= 0;
      transform_write_column <= 0; transform_columns_start_of_frame <= false; transform_columns_valid <= false;
      for i in 0 to 7 loop
        transform_filtering_start_of_frame(i) <= false; transform_filtering_valid(i) <= false;
      end loop;
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 20;
      raster_place_next_frame <= false; delay_ring_read_address <= 1; delay_ring_write_address <= 0; delay_column <= 0;
      delay_tag.valid <= false; delay_tag.output_column <= false; delay_tag.start_of_frame <= false;
      delay_tag.end_of_line <= false; rows_read_column <= 0; rows_read_tag.valid <= false;
      rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false;
      rows_ready_column <= 0; rows_ready_tag.valid <= false; rows_ready_tag.output_column <= false;
      rows_ready_tag.start_of_frame <= false; rows_ready_tag.end_of_line <= false; rows_write_column <= 0;
      rows_tag.valid <= false; rows_tag.output_column <= false; rows_tag.start_of_frame <= false;
      rows_tag.end_of_line <= false; slice0shift_tag.valid <= false; slice0shift_tag.output_column <= false;
      slice0shift_tag.start_of_frame <= false; slice0shift_tag.end_of_line <= false;
      slice0cost_pixels_first_tag.valid <= false; slice0cost_pixels_first_tag.output_column <= false;
      slice0cost_pixels_first_tag.start_of_frame <= false; slice0cost_pixels_first_tag.end_of_line <= false;
      slice0cost_pixels_tag.valid <= false; slice0cost_pixels_tag.output_column <= false;
      slice0cost_pixels_tag.start_of_frame <= false; slice0cost_pixels_tag.end_of_line <= false;
      slice0cost_pair_tag.valid <= false; slice0cost_pair_tag.output_column <= false;
      slice0cost_pair_tag.start_of_frame <= false; slice0cost_pair_tag.end_of_line <= false;
      slice0cost_tag.valid <= false; slice0cost_tag.output_column <= false; slice0cost_tag.start_of_frame <= false;
      slice0cost_tag.end_of_line <= false; slice0window_centre_output_column_0 <= false;
      slice0window_centre_start_of_frame_0 <= false; slice0window_centre_end_of_line_0 <= false;
      slice0window_tag <= (others => false); slice0winner1_tag <= (others => false);
      slice0winner2_tag <= (others => false); slice0winner3_tag <= (others => false);
      slice0_best_tag <= (others => false); slice1window_centre_output_column_0 <= false;
      slice1window_centre_start_of_frame_0 <= false; slice1window_centre_end_of_line_0 <= false;
      slice1_best_tag <= (others => false);
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_output_column(i) <= false;
        refinement_tag_start_of_frame(i) <= false; refinement_tag_end_of_line(i) <= false;
      end loop;
      map_out_valid <= false; map_out_start_of_frame <= false; map_out_end_of_line <= false;
      others_from_15 <= (others => 0);
    end if;
  end process;
end architecture;
